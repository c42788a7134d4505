// Every bias is asked for in texels, so that a slider means the same in every scene: texelSize is the width of
// one texel at the receiver [world], cosTheta the cosine between facet normal and direction to the light, in (0, 1].
// At default settings only 4d is called with an effect: 4a to 4c are multiplied by sliders that stand at 0, and
// 4e is for filter=hardware.

// Task 4a · constant depth bias.                                                         README §4
// Returns the distance [world] by which the receiver moves towards the light.
float constantBias(float texels, float texelSize) {
    return 0.0;  // yours
}

// Task 4b · slope bias: the depth of a tilted plane across `texels` texels.              README §4
// Returns the distance [world] by which the receiver moves towards the light: grows with tan(theta); the
// tangent is capped at 200 (89.7 degrees), so that the result stays finite.
float slopeBias(float texels, float texelSize, float cosTheta) {
    return 0.0;  // yours
}

// Task 4c · normal offset: the receiver leaves its surface.                              README §4, [Holbert 2011]
//   facet   unit normal on the eye's side
// Returns a vector [world] along the facet normal, `texels` texels long at grazing light and 0 at normal
// incidence: times sin(theta).
vec3 normalOffset(vec3 facet, float cosTheta, float texels, float texelSize) {
    return vec3(0.0);  // yours
}

// Task 4d · how fast the receiver's own plane changes depth across the map.              README §4, [Isidoro 2006]
//   dx, dy   change of the receiver's (u, v, depth) from this pixel to the next one right, and the next one up:
//            two directions within its plane
// Returns (d depth / d u, d depth / d v): a plane in the world stays a plane in (u, v, depth). (0, 0) where the
// light sees the plane edge-on (dx and dy are parallel in u, v), because there is no gradient. Ask for a
// determinant of exactly 0: on steep planes that do have a gradient it falls below 1e-6.
vec2 receiverPlaneGradient(vec3 dx, vec3 dy) {
    return vec2(0.0);  // yours
}

// Task 4e · the bias that a plane needs when all texels of a kernel share one reference.  README §4
//   gradient       as returned above
//   texelSizeUv    1 / map size
//   radiusTexels   how far the kernel's sampling positions reach from the receiver       [texels]
// Returns [depth] >= 0, to be subtracted from the receiver's depth by given code: the largest depth that the plane
// can lose between the receiver and the farthest texel centre read, half a texel beyond the radius along u and
// along v.
float receiverPlaneBias(vec2 gradient, vec2 texelSizeUv, float radiusTexels) {
    return 0.0;  // yours
}
