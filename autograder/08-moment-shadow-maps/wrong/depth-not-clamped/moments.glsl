// Fails: Task1Moments.DepthsOutsideCountAsTheNearestInside · depths outside [0,1] are not clamped
vec4 depthMoments(float depth) {
    float z = 2.0 * depth - 1.0;
    return vec4(z, z * z, z * z * z, z * z * z * z);
}
