// The receiver's plane and what the settings ask for. Twin: PlanarBlock in assignment.cpp.
layout(std140) uniform Planar {
    mat4 shadowMatrix;          // yours, for the chosen form
    mat4 textureClipFromWorld;  // texture_view.h
    vec4 plane;                 // (n, d): n unit, on the light's side
    float shadowVisibility;     // of a receiver in shadow
    int rayForm;                // 1: flattenAlongRay(), 0: the matrix
    int clip;
    int divide;
} planar;
