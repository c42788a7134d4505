// Task 2a · a point as the light's projection sees it.                                   README §2
//   world           any point                                                            [world]
//   clipFromWorld   light clip space from world
// Returns homogeneous clip coordinates; w is the distance along the light's axis, <= 0 behind the light.
vec4 lightClipPosition(vec3 world, mat4 clipFromWorld) {
    return vec4(0.0, 0.0, -2.0, 1.0);  // yours; this is outside every view, so nothing is drawn
}

// Task 2b · where to look in the map, and what to compare.                               README §2
//   lightClip   with w > 0
// Returns (u, v, depth): [0,1]³ inside the light's view; depth 0 is the near plane, 1 the far plane.
vec3 shadowMapUvDepth(vec4 lightClip) {
    return vec3(0.5, 0.5, 0.0);  // yours
}
