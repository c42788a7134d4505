// Task 2 alone: past a rounded box whose distance is known.
#include "approach_plain.glsl"
#include "rounded_box.glsl"
#include "march.glsl"

Approach marchRoundedBox(vec3 center, vec3 halfSize, float radius, vec3 origin, vec3 direction, float first, float reach,
                         Limits limits) {
    shapeCenter = center, shapeHalfSize = halfSize, shapeRadius = radius;
    return march(origin, direction, first, reach, limits);
}
