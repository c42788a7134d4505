// A ray to each quarter of the light, where one ray to its centre cannot tell.
#include "edge_line.glsl"

Approach approachOf(Receiver receiver) { return marchToLight(receiver, surelyLit(receiver), -surelyLit(receiver)); }

// In order around the light, so that i + 1 and i + 3 are the neighbours of i.
vec2 quarterCenter(int i) { return vec2(i == 1 || i == 2 ? 0.25 : -0.25, i < 2 ? -0.25 : 0.25); }

EdgeLine lineSeenTowards(Receiver receiver, vec2 at) {
    vec3 toLight = light.center + light.width * (at.x * light.right + at.y * light.up) - receiver.origin;
    float distance = length(toLight);
    vec3 direction = toLight / distance;
    // A little beyond the neighbouring quarters' centres, which lie one edgeRatio away.
    float highest = 1.2 * receiver.edgeRatio, lowest = -receiver.edgeRatio;
    Approach nearest = march(receiver.origin, direction, field.smallestStep, distance,
                             Limits(highest, lowest, field.stepCap, field.smallestStep, field.maxSteps));
    return edgeLine(receiver, direction, nearest, highest, lowest);
}

float quarterShare(EdgeLine line, vec2 at) {
    return shareAboveHorizon(vec3(line.height.x + dot(line.height.yz, at), 0.5 * line.height.yz));
}

// A ray that went through something thin does not know how far the edge is; its neighbours may.
float quarterVisibility(EdgeLine own, EdgeLine left, EdgeLine right, vec2 at) {
    if (own.trusted) return quarterShare(own, at);
    vec2 weight = vec2(left.near && left.trusted, right.near && right.trusted);
    return dot(weight, vec2(quarterShare(left, at), quarterShare(right, at))) / max(weight.x + weight.y, 1.0);
}

float softVisibility(Receiver receiver) {
    float most = surelyLit(receiver);
    EdgeLine center = edgeLine(receiver, receiver.direction, approachOf(receiver), most, -most), lines[4];
    for (int i = 0; i < 4; ++i) {
        if (center.trusted) break;   // in a loop, which a rasteriser that runs pixels in groups can leave early
        lines[i] = lineSeenTowards(receiver, quarterCenter(i));
    }
    float sum = 0.0;
    for (int i = 0; i < 4; ++i)
        sum += quarterVisibility(lines[i], lines[(i + 1) & 3], lines[(i + 3) & 3], quarterCenter(i));
    return center.trusted ? shareAboveHorizon(center.height) : 0.25 * sum;
}
