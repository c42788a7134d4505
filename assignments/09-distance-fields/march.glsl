#include "march_limits.glsl"

float sceneDistance(vec3 p);                                     // given: to the nearest blocker, negative inside
vec2 approachSince(float before, float here, float stepTaken);   // given: see march()

// Task 2a · where a shadow ray starts.                                                     README §2
//   normal   unit, on the side that the eye sees
//   offset   >= 0                                                                          [world]
// Returns the point so far over the surface.
vec3 rayStart(vec3 position, vec3 normal, float offset) {
    return position;  // yours
}

// Task 2b · how far a step may go.                                                         README §2, [Hart 1996]
//   distance   of what is nearest to the ray's point at t; negative inside                 [world]
//   t          > 0, from the ray's start                                                   [world]
//   ratio      the smallest distance / t so far: > -1, and not above this one
//   stepCap, smallestStep   see Limits
// Returns the longest step that cannot pass a place where distance / t is smaller than `ratio`, since distance changes by
// at most 1 for each unit of t. But never less than stepCap * |distance|, nor less than smallestStep        [world]
float stepLength(float distance, float t, float ratio, float stepCap, float smallestStep) {
    return smallestStep;  // yours
}

// Task 2c · the march.                                                                     README §2, [Hart 1996]
//   direction   unit
//   first       t of the first look-up, > 0                                                [world]
//   reach       t of the light: look-ups are before it                                     [world]
// Returns the smallest ratio distance / t on the ray and where it was. It starts as limits.highest at `reach`. Each
// look-up gives `here`, the scene's distance at t, and vec2 since = approachSince(before, here, stepTaken): since.x
// before t, the distance was since.y. (before: the last look-up's distance; stepTaken: from there to here; both 0 at
// the first.) The march ends at `reach`, after limits.maxSteps look-ups, or where the ratio is not above limits.lowest.
Approach march(vec3 origin, vec3 direction, float first, float reach, Limits limits) {
    return Approach(limits.highest, reach, 0.0);  // yours
}
