// Fails: Task0.Unknown · the second and the third moment have changed places
vec4 depthMoments(float depth) {
    float z = 2.0 * clamp(depth, 0.0, 1.0) - 1.0;
    return vec4(z, z * z * z, z * z, z * z * z * z);
}
