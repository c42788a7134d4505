// Task 4 · which part of a caster can cast a shadow on the plane.                        README §4
//   plane    (n, d), the light on the side that n points to
//   light    (l, 1), or (direction to the light, 0)
//   caster   a point of a caster                                                         [world]
// Returns two distances, of any scale, that are linear in `caster` (the rasteriser interpolates them over triangles
// and cuts off what is negative):
//   x   >= 0 on the light's side of the plane and in it, < 0 behind it
//   y   >= 0 where the caster is not farther from the plane than the light, < 0 beyond; nothing is beyond a
//       directional light
vec2 clipDistances(vec4 plane, vec4 light, vec3 caster) {
    return vec2(1.0);  // yours; cuts nothing off
}
