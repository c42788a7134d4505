// The line that the nearest blocker's edge draws across the light, seen from four rays.
#include "receiver.glsl"
#include "edge.glsl"
#include "horizon.glsl"

const float kCorner = 1.4142136;

Approach approachOf(Receiver receiver) {
    return marchToLight(receiver, kCorner * receiver.edgeRatio, -kCorner * receiver.edgeRatio);
}

// Heights (see horizon.glsl) of the light's points over the plane of the edge nearest to the ray to `at`.
// Blocked ray: (0, 0, 0, 0), w 1 where it is known.
vec4 edgeSeenAlong(Receiver receiver, vec2 at) {
    vec3 toLight = light.center + light.width * (at.x * light.right + at.y * light.up) - receiver.origin;
    float distance = length(toLight);
    vec3 direction = toLight / distance;
    float highest = 2.2 * receiver.edgeRatio;
    Approach nearest = march(receiver.origin, direction, field.smallestStep, distance,
                             Limits(highest, 0.0, field.stepCap, field.smallestStep, field.maxSteps));
    if (nearest.ratio <= 0.0) return vec4(0.0);
    if (nearest.ratio >= highest) return vec4(1.0, 0.0, 0.0, 1.0);
    vec3 normal = edgePlane(safeTangent(nearest.ratio), direction,
                            gradient(receiver.origin + nearest.t * direction, 0.5 * field.cell));
    vec3 toCenter = light.center - receiver.origin;
    return vec4(dot(normal, toCenter), light.width * dot(normal, light.right), light.width * dot(normal, light.up), 1.0);
}

// of the quarter of the light around `at`
float quarterShare(vec4 edge, vec2 at) {
    return edge.w * shareAboveHorizon(vec3(edge.x + dot(edge.yz, at), 0.5 * edge.yz));
}

float softVisibility(Receiver receiver) {
    Approach nearest = approachOf(receiver);
    if (nearest.ratio >= kCorner * receiver.edgeRatio) return 1.0;
    if (nearest.ratio <= -kCorner * receiver.edgeRatio) return 0.0;
    vec2 a = vec2(-0.25, -0.25), b = vec2(0.25, -0.25), c = vec2(0.25, 0.25), d = vec2(-0.25, 0.25);
    vec4 A = edgeSeenAlong(receiver, a), B = edgeSeenAlong(receiver, b), C = edgeSeenAlong(receiver, c),
         D = edgeSeenAlong(receiver, d);
    float sum = 0.0;
    sum += A.w > 0.0 ? quarterShare(A, a) : max(quarterShare(B, a), max(quarterShare(D, a), quarterShare(C, a)));
    sum += B.w > 0.0 ? quarterShare(B, b) : max(quarterShare(A, b), max(quarterShare(C, b), quarterShare(D, b)));
    sum += C.w > 0.0 ? quarterShare(C, c) : max(quarterShare(B, c), max(quarterShare(D, c), quarterShare(A, c)));
    sum += D.w > 0.0 ? quarterShare(D, d) : max(quarterShare(A, d), max(quarterShare(C, d), quarterShare(B, d)));
    return 0.25 * sum;
}
