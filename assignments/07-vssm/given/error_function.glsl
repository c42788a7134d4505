// erf(x) = 2/sqrt(pi) times the integral of exp(-s²) from 0 to x, which GLSL lacks; wrong by less than 2e-6 in floats.
// [Abramowitz 1964, 7.1.26]
float errorFunction(float x) {
    float t = 1.0 / (1.0 + 0.3275911 * abs(x));
    float series = t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
    return sign(x) * (1.0 - series * exp(-x * x));
}
