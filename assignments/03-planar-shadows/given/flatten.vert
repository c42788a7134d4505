// Casters, flattened onto the receiver's plane along the rays of the light.
#include "camera.glsl"
#include "light.glsl"
#include "planar.glsl"
#include "clip_caster.glsl"
#include "ray_form.glsl"

layout(location = 0) in vec3 position;
layout(location = 2) in vec2 uv;
out vec2 surfaceUv;
out float gl_ClipDistance[2];

void main() {
    surfaceUv = uv;
    vec4 flattened = planar.rayForm != 0 ? flattenAlongRay(planar.plane, light.position, position)
                                         : planar.shadowMatrix * vec4(position, 1.0);
    if (planar.divide != 0) flattened /= flattened.w;
    // All zeros (a stub) and what is no number: outside every view.
    float size = dot(flattened, flattened);
    gl_Position = size > 0.0 && size < 1e38 ? camera.clipFromWorld * flattened : vec4(0.0, 0.0, -2.0, 1.0);

    vec2 distances = planar.clip != 0 ? clipDistances(planar.plane, light.position, position) : vec2(1.0);
    gl_ClipDistance[0] = distances.x;
    gl_ClipDistance[1] = distances.y;
}
