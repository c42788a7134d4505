// lightHeight holds all that has to be known of the receiver's plane: the light's point (s, t), with s and t in
// [-1/2, 1/2] along the light's edges, stands h + k.x s + k.y t over it, where h = lightHeight.x, k = lightHeight.yz.
// Negative heights are below. Only ratios count, no unit.

// Task 2a · the receiver's plane in the map's own coordinates.                             README §2
//   widthScaleUv   S of Task 1                                                             [uv]
// Returns p such that the point that lies `offset` away from the receiver in (u, v, depth) is over the receiver's plane
// exactly where dot(p, offset) > 0; scaled so that p.z = -h. No division by h: it may be 0, or negative.
vec3 receiverPlane(vec3 lightHeight, vec2 widthScaleUv) {
    return vec3(0.0);  // yours
}

// Task 2b · does a texel block?                                                            README §2
//   plane    what 2a returns
//   offset   from the receiver to the texel's centre and its stored depth                  [u, v, depth]
//   bias     constant bias, at least 0                                                     [depth]
// Returns true where the stored surface is nearer to the light than the receiver by more than bias, *and* over the
// receiver's plane by more than bias * |h|.
bool isBlocker(vec3 plane, vec3 offset, float bias) {
    return false;  // yours
}

// Task 2c · does the receiver's own plane hide this point of the light?                    README §2
//   lightPoint   (s, t)
// Returns true where the point is over the plane.
bool isAboveHorizon(vec3 lightHeight, vec2 lightPoint) {
    return true;  // yours
}
