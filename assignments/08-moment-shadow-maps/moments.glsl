// Task 1 · four moments of one depth.                                                      README §1, [Peters and Klein 2015]
//   depth   of the map; may lie outside [0,1] by rounding, and is then moved to the nearer end
// Returns (z, z², z³, z⁴) for z = 2 depth - 1, which runs from -1 to 1.
vec4 depthMoments(float depth) {
    return vec4(1.0);  // yours; as if everything were at depth 1
}
