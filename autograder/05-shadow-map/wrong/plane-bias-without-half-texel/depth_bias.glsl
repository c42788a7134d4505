// Fails: Task4DepthBias.PlaneBiasReachesTheFarthestTexelCentre · the plane's bias forgets the half texel around each sample
float constantBias(float texels, float texelSize) { return texels * texelSize; }

float slopeBias(float texels, float texelSize, float cosTheta) {
    float sinTheta = sqrt(max(1.0 - cosTheta * cosTheta, 0.0));
    return texels * texelSize * min(sinTheta / max(cosTheta, 1e-6), 200.0);
}

vec3 normalOffset(vec3 facet, float cosTheta, float texels, float texelSize) {
    return facet * (texels * texelSize * sqrt(max(1.0 - cosTheta * cosTheta, 0.0)));
}

vec2 receiverPlaneGradient(vec3 dx, vec3 dy) {
    // Cramer's rule for gradient · dx.xy = dx.z, gradient · dy.xy = dy.z.
    float determinant = dx.x * dy.y - dx.y * dy.x;
    vec2 scaled = vec2(dx.z * dy.y - dy.z * dx.y, dy.z * dx.x - dx.z * dy.x);
    return determinant == 0.0 ? vec2(0.0) : scaled / determinant;
}

float receiverPlaneBias(vec2 gradient, vec2 texelSizeUv, float radiusTexels) {
    return radiusTexels * dot(abs(gradient), texelSizeUv);
}
