// Fails: Task1AttachedShadow.TheSideOfThePlaneDecides, Task1AttachedShadow.ALoneBoxIsDarkWhereItFacesAway · the sign of the cosine is lost
float facingVisibility(vec3 facet, vec3 toLight) { return abs(dot(facet, toLight)) > 0.0 ? 1.0 : 0.0; }
