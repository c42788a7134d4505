// Mean over about a box, from mip levels. The level lies between two, and each is asked for with a level that is the
// same for all pixels: some rasterisers take one level for four pixels at once.
vec4 mipMean(sampler2D levels, vec2 low, vec2 high) {
    vec2 size = vec2(textureSize(levels, 0));
    int last = int(log2(max(size.x, size.y)));
    vec2 width = high - low;
    float level = clamp(0.5 * log2(max(width.x * width.y, 1.0)), 0.0, float(last));
    vec4 mean = vec4(0.0);
    for (int i = 0; i <= last; ++i)
        mean += max(1.0 - abs(level - float(i)), 0.0) * textureLod(levels, 0.5 * (low + high) / size, float(i));
    return mean;
}
