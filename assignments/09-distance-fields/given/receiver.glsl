// The receiver in this pixel, and its ray to the light's centre.
#include "field.glsl"
#include "light.glsl"
#include "receivers.glsl"
#include "march.glsl"
#include "lecture.glsl"

struct Receiver {
    vec3 lightHeight;   // of the light's point (s, t) over the receiver's plane: x + s y + t z
    vec3 origin;        // where rays start: over the surface                               [world]
    vec3 direction;     // unit, to the light's centre
    float distance;     // of the light's centre                                            [world]
    float edgeRatio;    // how far the light's edge is from its centre, over that distance
};

Receiver receiverAt(ivec2 pixel) {
    vec4 position = texelFetch(receiverPosition, pixel, 0), height = texelFetch(receiverLightHeight, pixel, 0);
    vec3 normal = (light.right * height.y + light.up * height.z) / light.width + light.forward * height.w;
    Receiver receiver;
    receiver.lightHeight = height.xyz;
    receiver.origin = rayStart(position.xyz, normal, field.normalOffset);
    vec3 toLight = light.center - receiver.origin;
    receiver.distance = length(toLight);
    receiver.direction = toLight / receiver.distance;
    receiver.edgeRatio = lightEdgeRatio(light.width, receiver.distance);
    return receiver;
}

// Towards the light, as far as ratios between `lowest` and `highest` are in question.
Approach marchToLight(Receiver receiver, float highest, float lowest) {
    return march(receiver.origin, receiver.direction, field.smallestStep, receiver.distance,
                 Limits(highest, lowest, field.stepCap, field.smallestStep, field.maxSteps));
}

Approach approachOf(Receiver receiver);    // method
float softVisibility(Receiver receiver);   // method
float lightAboveHorizon(Receiver receiver); // horizon: share of the light over the receiver's plane
