#include "shading.glsl"

// The block `light` (light.glsl) is the light of the pass. What a surface gives is in shading.glsl:
// ambientAndEmissive(), directLight(), and shade(), the sum of both with a visibility.
//   baseColor       linear                        p        the receiver                  [world]
//   vertexNormal    for shading                   facet    unit, of the triangle's plane, on the eye's side

// Task 7b · drawn once, for all lights together.                                         README §7
// Returns what is seen without any light: no shadow touches it.
vec3 firstPass(vec3 baseColor, vec3 p, vec3 vertexNormal, vec3 facet) {
    return shade(baseColor, p, vertexNormal, facet, 1.0);  // yours
}

// Task 7c · what needs no volume to be dark.                                             README §7
// Returns 0.0 where the light cannot reach p whatever stands between: it lies on or below the plane of the
// receiver's facet, or p lies at or beyond the light's range, or on or behind the light's plane (it shines along
// light.forward; a directional light has no plane). Else 1.0.
float reachesReceiver(vec3 p, vec3 facet) {
    return 1.0;  // yours
}

// Task 7d · drawn once for each light, where the count is 0.                             README §7
// Returns that light's own share.
vec3 lightPass(vec3 baseColor, vec3 p, vec3 vertexNormal, vec3 facet) {
    return vec3(0.0);  // yours
}
