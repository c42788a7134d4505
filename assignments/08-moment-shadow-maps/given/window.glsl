// Boxes in the map, and the mean moments in them.
#include "moment_shadow.glsl"

// The box (low, high) that the receiver's part of the light covers, seen through depth blockerDepth. At least a texel
// wide: a smaller one would only show the texel.
vec4 windowUv(Receiver receiver, float blockerDepth) {
    vec2 width = map.widthScaleUv * max(receiver.uvDepth.z - blockerDepth, 0.0);
    vec2 center = receiver.uvDepth.xy + 0.5 * (receiver.light.xy + receiver.light.zw) * width;
    vec2 halfSize = 0.5 * max((receiver.light.zw - receiver.light.xy) * width, map.texelSizeUv);
    return vec4(center - halfSize, center + halfSize);
}

// Mean moments over a box (low, high). Beyond the map nothing is drawn: depth 1, all moments 1.
vec4 meanMoments(vec4 box) {
    vec2 low = clamp(box.xy, 0.0, 1.0), high = clamp(box.zw, 0.0, 1.0);
    float inside = (high.x - low.x) * (high.y - low.y) / ((box.z - box.x) * (box.w - box.y));
    return inside > 0.0 ? mix(vec4(1.0), momentsFromStored(meanStored(low, high)), inside) : vec4(1.0);
}

// The same over whole texels: those that the box touches. Cheaper, for a search.
vec4 meanMomentsAround(vec4 box) {
    vec2 low = clamp(box.xy, 0.0, 1.0), high = clamp(box.zw, 0.0, 1.0);
    float inside = (high.x - low.x) * (high.y - low.y) / ((box.z - box.x) * (box.w - box.y));
    return inside > 0.0 ? mix(vec4(1.0), momentsFromStored(meanStoredAround(low, high)), inside) : vec4(1.0);
}
