// The line that the nearest blocker's edge draws across the light.
#include "receiver.glsl"
#include "edge.glsl"
#include "horizon.glsl"

Approach approachOf(Receiver receiver) { return marchToLight(receiver, 1.5 * receiver.edgeRatio, -1.5 * receiver.edgeRatio); }

float softVisibility(Receiver receiver) {
    Approach nearest = approachOf(receiver);
    if (nearest.ratio >= 1.5 * receiver.edgeRatio) return 1.0;
    if (nearest.ratio <= -1.5 * receiver.edgeRatio) return 0.0;
    vec3 normal = edgePlane(safeTangent(nearest.ratio), receiver.direction,
                            gradient(receiver.origin + nearest.t * receiver.direction, 0.5 * field.cell));
    return shareAboveHorizon(vec3(dot(normal, receiver.direction) * receiver.distance,
                                  light.width * dot(normal, light.right), light.width * dot(normal, light.up)));
}
