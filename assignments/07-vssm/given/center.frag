// Mean depth of the map, from at most 64 x 64 texels spread over it: one pixel.
uniform sampler2D shadowMap;
layout(location = 0) out float mean;

void main() {
    ivec2 size = textureSize(shadowMap, 0), count = min(size, ivec2(64)), step = size / count;
    float sum = 0.0;
    for (int j = 0; j < count.y; ++j)
        for (int i = 0; i < count.x; ++i) sum += texelFetch(shadowMap, ivec2(i, j) * step + step / 2, 0).r;
    mean = sum / float(count.x * count.y);
}
