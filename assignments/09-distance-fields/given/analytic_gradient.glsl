// Task 6a alone: around a rounded box whose distance is known.
#include "rounded_box.glsl"
#include "edge.glsl"

vec3 gradientRoundedBox(vec3 center, vec3 halfSize, float radius, vec3 p, float delta) {
    shapeCenter = center, shapeHalfSize = halfSize, shapeRadius = radius;
    return gradient(p, delta);
}
