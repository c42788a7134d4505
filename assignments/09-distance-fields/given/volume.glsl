// The field anywhere: the volume's value at the nearest point of its box, and from there your bound.
#include "field.glsl"
#include "distance.glsl"

float sceneDistance(vec3 p) {
    vec3 onBox = clamp(p, field.lower, field.upper);
    float there = textureLod(distanceField, fieldCoordinate(onBox, field.lower, field.upper), 0.0).r;
    return distanceBeyond(p, onBox, there);
}
