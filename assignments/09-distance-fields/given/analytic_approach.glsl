// Tasks 2 and 4: the same past a rounded box, with the closest approach between look-ups.
#include "approach_circles.glsl"
#include "rounded_box.glsl"
#include "march.glsl"

Approach marchRoundedBox(vec3 center, vec3 halfSize, float radius, vec3 origin, vec3 direction, float first, float reach,
                         Limits limits) {
    shapeCenter = center, shapeHalfSize = halfSize, shapeRadius = radius;
    return march(origin, direction, first, reach, limits);
}
