// The field anywhere: the volume's value at the nearest point of its box, and from there your bound. Outside the blockers'
// own box their distance is also at least the box's.
#include "field.glsl"
#include "distance.glsl"

float sceneDistance(vec3 p) {
    vec3 onBox = clamp(p, field.lower, field.upper);
    float there = textureLod(distanceField, fieldCoordinate(onBox, field.lower, field.upper), 0.0).r;
    float toBlockers = length(p - clamp(p, field.blockersLower, field.blockersUpper));
    float beyond = distanceBeyond(p, onBox, there);
    return p == onBox ? beyond : max(beyond, toBlockers);
}
