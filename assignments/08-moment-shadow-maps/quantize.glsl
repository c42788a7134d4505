// Task 2a · four moments as four numbers in [0,1], to be kept in 16 bits each.              README §2, [Peters and Klein 2015]
//   b   moments (E[z], E[z²], E[z³], E[z⁴]) of any depths z in [-1,1]
// Returns, in this order,
//   3/2 b1 - 2 b3 + 1/2,   4 b2 - 4 b4,   √3/2 b1 - 2√3/9 b3 + 1/2,   b2/2 + b4/2
vec4 quantizedMoments(vec4 b) {
    return 0.5 * b + 0.5;  // yours; this is storage=raw16
}

// Task 2b · back again.                                                                    README §2
//   q   what 2a returned, or a mean of such
// Returns the moments b.
vec4 dequantizedMoments(vec4 q) {
    return 2.0 * q - 1.0;  // yours
}

// Task 2c · moments that are moments of something for certain.                             README §2, [Peters and Klein 2015]
//   b       moments, with errors of rounding
//   alpha   the moment bias, in [0,1]
// Returns the moments of a mixture: a share of 1 - alpha has b, a share of alpha has depths -1, 0, 1, of which 3/10 lie
// at -1, 4/10 at 0 and 3/10 at 1.
vec4 biasedMoments(vec4 b, float alpha) {
    return b;  // yours
}
