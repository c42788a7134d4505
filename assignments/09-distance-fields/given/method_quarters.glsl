// A ray to each quarter of the light, where one ray to its centre cannot tell.
#include "edge_line.glsl"

Approach approachOf(Receiver receiver) { return marchToLight(receiver, surelyLit(receiver), -surelyLit(receiver)); }

// `at`: (s, t) of the quarter's centre.
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
    float center = approachOf(receiver).ratio;
    if (abs(center) >= surelyLit(receiver)) return center > 0.0 ? 1.0 : 0.0;
    vec2 a = vec2(-0.25, -0.25), b = vec2(0.25, -0.25), c = vec2(0.25, 0.25), d = vec2(-0.25, 0.25);
    EdgeLine lineA = lineSeenTowards(receiver, a), lineB = lineSeenTowards(receiver, b),
             lineC = lineSeenTowards(receiver, c), lineD = lineSeenTowards(receiver, d);
    return 0.25 * (quarterVisibility(lineA, lineB, lineD, a) + quarterVisibility(lineB, lineA, lineC, b) +
                   quarterVisibility(lineC, lineB, lineD, c) + quarterVisibility(lineD, lineA, lineC, d));
}
