#include "lecture.glsl"

// Task 5 · half of the light is visible where the ray just grazes.                         README §5
//   ratio       smallest distance / t on the ray, negative where it goes through a blocker
//   edgeRatio   > 0
// Returns [0,1]: the share of the light beyond a straight edge that is seen under the safe angle from the light's centre.
float signedVisibility(float ratio, float edgeRatio) {
    return 1.0;  // yours
}
