// The field anywhere: the volume's value at the nearest point of its box, and from there your bound. Outside the blockers'
// own box their distance is also at least the box's.
#include "field.glsl"
#include "distance.glsl"

float sceneDistance(vec3 p) {
    vec3 onBox = clamp(p, field.lower, field.upper);
    float there = textureLod(distanceField, fieldCoordinate(onBox, field.lower, field.upper), 0.0).r;
    if (p == onBox) return distanceBeyond(p, onBox, there);
    vec3 toBlockers = p - clamp(p, field.blockersLower, field.blockersUpper);
    return max(distanceBeyond(p, onBox, there), length(toBlockers));
}
