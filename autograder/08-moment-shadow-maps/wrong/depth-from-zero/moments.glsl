// Fails: Task0.Unknown · moments of a depth from 0 to 1, read as one from -1 to 1
vec4 depthMoments(float depth) {
    float z = clamp(depth, 0.0, 1.0);
    return vec4(z, z * z, z * z * z, z * z * z * z);
}
