// Task 5 · one point flattened along its ray, without a matrix.                          README §5
//   plane    (n, d), n unit, the light on the side that n points to
//   light    (l, 1), or (direction to the light, 0)
//   caster   a point of a caster                                                         [world]
// Returns (p w, w), undivided: p is where the ray from the light through the caster meets the plane, and
// w = n·(l - l_w caster), computed from the difference of the two points. w is 0 at the light's own height, where p
// is a direction, and negative above.
vec4 flattenAlongRay(vec4 plane, vec4 light, vec3 caster) {
    return vec4(0.0);  // yours; zeros draw nothing
}
