// Intermediate results as images, for you and for the grader.
#include "receiver.glsl"

layout(location = 0) out float ratio;     // smallest distance / t; the largest of interest where nothing comes near
layout(location = 1) out float approach;  // t of it; 0 where nothing comes near                     [world]
layout(location = 2) out float steps;     // look-ups, as a share of max_steps

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ratio = -1.0, approach = 0.0, steps = 0.0;
    if (texelFetch(receiverPosition, pixel, 0).w <= 0.0) return;
    Receiver receiver = receiverAt(pixel);
    Approach nearest = approachOf(receiver);
    ratio = nearest.ratio;
    approach = nearest.t < receiver.distance ? nearest.t : 0.0;
    steps = nearest.steps / float(field.maxSteps);
}
