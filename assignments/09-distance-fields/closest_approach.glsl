// Task 4 · between two look-ups.                                                           README §4, [Aaltonen 2018]
//   before, here   distances at the last look-up and at this one                           [world]
//   stepTaken      from there to here; 0: there was none before                            [world]
// Suppose both have measured the distance of the same point. Returns (how far back from here the ray came nearest to it,
// how near that was) [world]; and (0, here) where that tells nothing: at the first look-up, inside a blocker at either
// one, or where the nearest place is not between the two.
vec2 closestApproach(float before, float here, float stepTaken) {
    return vec2(0.0, here);  // yours
}
