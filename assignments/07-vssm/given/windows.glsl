// A window of the map is cut into n x n cells. Each has a box of its own, and a part of the light.
#include "variance_shadow.glsl"
#include "box.glsl"
#include "light_share.glsl"

struct Window {
    vec2 low;           // corner [texels]
    vec2 width;         // of a cell [texels]
    float inverseArea;  // of a cell
};

Window windowAround(vec2 centerUv, vec2 widthUv, float inverse) {
    vec2 width = widthUv * inverse * shadow.mapSize;
    return Window((centerUv - 0.5 * widthUv) * shadow.mapSize, width, 1.0 / (width.x * width.y));
}

// The least window of whole texels that holds it, for whom parts of texels do not matter: a look-up then reads one texel
// and not four.
Window wholeTexelsAround(vec2 centerUv, vec2 widthUv, float inverse) {
    vec2 middle = centerUv * shadow.mapSize, reach = 0.5 * widthUv * shadow.mapSize;
    vec2 low = floor(middle - reach), width = ceil((middle + reach - low) * inverse);
    return Window(low, width, 1.0 / (width.x * width.y));
}

// Left of column i in row j.
Side sideOf(Window window, int i, int j) {
    vec2 low = window.low + vec2(i, j) * window.width, high = vec2(low.x, low.y + window.width.y);
    return sideAt(clamp(low, 0.0, shadow.mapSize), clamp(high, 0.0, shadow.mapSize));
}

// Likewise in a window of whole texels.
Side wholeSideOf(Window window, int i, int j) {
    vec2 low = window.low + vec2(i, j) * window.width, high = vec2(low.x, low.y + window.width.y);
    return wholeSideAt(clamp(low, 0.0, shadow.mapSize), clamp(high, 0.0, shadow.mapSize));
}

vec2 meanVarianceBetween(Window window, Side left, Side right) {
    vec2 inside = right.high - left.low;
    vec2 moments = withBorder(meanBetween(left, right), inside.x * inside.y * window.inverseArea, shadow.center);
    return meanVariance(moments, shadow.center, shadow.minVariance);
}

// Middle of cell (i, j) in [-1/2, 1/2]², of a window and of the light alike. inverse = 1/n.
vec2 cellMiddle(int i, int j, float inverse) { return (vec2(i, j) + 0.5) * inverse - 0.5; }

// What is nearer than this, `offsetUv` beside the receiver, blocks: it lies over the receiver's plane, and nearer to the
// light than the receiver.
float blockedBelow(Receiver receiver, vec2 offsetUv) {
    return receiver.uvDepth.z + min(dot(receiver.slope, offsetUv), 0.0) - receiver.bias;
}

// Share of a cell of the light, n x n of which make the whole, that stands over the receiver's plane.
float shareAboveHorizon(Receiver receiver, vec2 middle, float inverse) {
    float height = receiver.lightHeight.x + dot(receiver.lightHeight.yz, middle);
    return shareAboveHorizon(vec3(height, inverse * receiver.lightHeight.yz));
}
