// Without an alpha test a rasteriser may reject depth early.
bool isMissing(vec2 uv) { return false; }
