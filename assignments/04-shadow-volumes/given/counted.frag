// Leaves the pixels whose float count is not zero; their stencil becomes 1.
uniform sampler2D counts;

void main() {
    if (texelFetch(counts, ivec2(gl_FragCoord.xy), 0).r == 0.0) discard;
}
