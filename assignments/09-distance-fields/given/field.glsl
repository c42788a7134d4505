// The distance field, and your dials. Twin: FieldBlock in field.h.
layout(std140) uniform Field {
    vec3 lower;           // corner of the grid's box                                       [world]
    float cell;           // edge of a voxel                                                [world]
    vec3 upper;           // opposite corner
    float normalOffset;   // how far rays start from the surface                            [world]
    float k;              // sharpness of the lecture's shadow, in units of the derived one
    float stepCap;        // see march.glsl
    float smallestStep;   // [world]
    int maxSteps;
    vec3 blockersLower;   // corners of the blockers' own box: smaller than the grid's      [world]
    float sliceY;         // height of the picture `distance`                               [world]
    vec3 blockersUpper;
} field;

uniform sampler3D distanceField;   // signed distance at voxel centres, linear in between   [world]

// Chunks behind these signatures are linked in, as the settings say.
float sceneDistance(vec3 p);                                            // from p to the nearest blocker, negative inside
vec2 approachSince(float before, float here, float stepTaken);         // method: see closest_approach.glsl
