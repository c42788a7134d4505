// Task 1a · distance to a sphere.                                                          README §1
// Returns the signed distance from p to the sphere's surface: negative inside              [world]
float sphereDistance(vec3 p, vec3 center, float radius) {
    return 1e3;  // yours
}

// Task 1b · distance to a box along the axes.                                              README §1
//   halfSize   half its edges, each > 0
// Returns the signed distance from p to the box's surface, exact everywhere: before a face, an edge, a corner, and
// negative inside                                                                          [world]
float boxDistance(vec3 p, vec3 center, vec3 halfSize) {
    return 1e3;  // yours
}

// Task 1c · where to look up the volume.                                                   README §1
//   p              in the grid's box                                                       [world]
//   lower, upper   corners of that box: the outer corners of its outermost voxels, not their centres
// Returns the texture coordinate of p, in [0,1]³.
vec3 fieldCoordinate(vec3 p, vec3 lower, vec3 upper) {
    return vec3(0.0);  // yours
}

// Task 1d · beyond the grid.                                                               README §1
//   p               anywhere                                                               [world]
//   onBox           the point of the grid's box that is nearest to p; p itself where p is inside
//   distanceThere   the field's value at onBox. > 0 on the box's border: all blockers lie in the box
// Returns the largest distance that is safe: no blocker is nearer to p. Inside the box, distanceThere as it is.
float distanceBeyond(vec3 p, vec3 onBox, float distanceThere) {
    return 1e3;  // yours; nothing is near
}
