// One hard shadow: whether each receiver sees one point of the light. Blended, so that the points add up to visibility.
#include "light.glsl"
#include "area_shadow_map.glsl"

uniform sampler2D receiverPosition;  // world_receivers.frag
uniform sampler2D receiverNormal;
uniform float weight;                // 1 / number of points
layout(location = 0) out float visibility;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 position = texelFetch(receiverPosition, pixel, 0);
    vec3 normal = texelFetch(receiverNormal, pixel, 0).xyz;
    vec4 clip = map.clipFromWorld * vec4(position.xyz, 1.0);
    float height = dot(normal, light.center - position.xyz);
    visibility = position.w < 0.0 ? weight : 0.0;
    if (position.w <= 0.0 || height <= 0.0 || clip.w <= 0.0) return;

    // A texel blocks if it is nearer than the receiver and over the receiver's plane where it was sampled: its centre.
    vec3 receiver = 0.5 * clip.xyz / clip.w + 0.5;
    vec3 offset = vec3(texelCenter(receiver.xy), storedDepth(receiver.xy)) - receiver;
    vec3 plane = vec3(light.width * vec2(dot(normal, light.right), dot(normal, light.up)) / map.widthScaleUv, -height);
    float bias = constantBias(receiver.z);
    bool blocked = -offset.z > bias && dot(plane, offset) > bias * height;
    visibility = blocked ? 0.0 : weight;
}
