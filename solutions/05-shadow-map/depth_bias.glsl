float constantBias(float texels, float texelSize) { return texels * texelSize; }

float slopeBias(float texels, float texelSize, float cosTheta) {
    float sinTheta = sqrt(max(1.0 - cosTheta * cosTheta, 0.0));
    return texels * texelSize * min(sinTheta / max(cosTheta, 1e-6), 200.0);
}

vec3 normalOffset(vec3 facet, float cosTheta, float texels, float texelSize) {
    return facet * (texels * texelSize * sqrt(max(1.0 - cosTheta * cosTheta, 0.0)));
}

vec2 receiverPlaneGradient(vec4 worldPlane, mat4 clipPlaneFromWorldPlane) {
    // x X + y Y + z Z + w = 0 in normalised device coordinates; u, v and depth halve all three alike.
    vec4 plane = clipPlaneFromWorldPlane * worldPlane;
    return plane.z == 0.0 ? vec2(0.0) : -plane.xy / plane.z;
}

float receiverPlaneBias(vec2 gradient, vec2 texelSizeUv, float radiusTexels) {
    return (0.5 + radiusTexels) * dot(abs(gradient), texelSizeUv);
}
