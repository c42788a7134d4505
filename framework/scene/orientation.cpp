// Filter first, as in [Shewchuk 1997]: the determinant in float64 with a bound of its rounding
// error. Only where the bound does not settle the sign it is computed again without rounding.
//
// The bound. Let u = b - a, v = c - a, t = light.xyz - light.w a. Each coordinate has one rounding
// (light.w a is exact: 24 + 24 bits), a relative error of at most e = 2^-53. A term u v t of the
// determinant collects 3 of these, 2 from its products, 1 from the difference in the cross product
// and 2 from the sum: 8 factors (1 + e). So the error is at most ((1 + e)^8 - 1) times the sum of
// the terms' magnitudes, of which the computed sum is itself (1 - e)^8 or more: less than 9 e times
// the computed sum. Fused multiply-adds only take roundings away. Nothing leaves float64's range:
// coordinates of u and v are 0 or within 2^-149 … 2^129, those of t within 2^-298 … 2^257, so terms
// lie within 2^-596 … 2^517.
#include "scene/orientation.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/error.h"

namespace penumbra {

namespace {

// value = ± mantissa 2^exponent, mantissa < 2^24, exponent >= -149.
struct Parts {
    std::uint64_t mantissa;
    int exponent;
    bool negative;

    explicit Parts(float value) {
        EXPECTS(std::isfinite(value));
        const auto bits = std::bit_cast<std::uint32_t>(value);
        const int field = int((bits >> 23) & 0xffu);  // 0: denormal
        mantissa = (bits & 0x7fffffu) | (field > 0 ? 0x800000u : 0u);
        exponent = (field > 0 ? field : 1) - 150;
        negative = (bits >> 31) != 0;
    }
};

// A sum of non-negative numbers in fixed point, wide enough for any product of four floats: their
// lowest bit is at least 2^-596; 24 of them stay below 2^517. Integers do not round: that is why
// the sign is exact.
class FixedPoint {
public:
    // Adds value 2^exponent, value < 2^48.
    void add(std::uint64_t value, int exponent) {
        const unsigned position = unsigned(exponent - kLowest);
        unsigned i = position / 32;
        const unsigned shift = position % 32;  // value << shift spans three digits
        std::uint64_t carry = 0;
        const std::array<std::uint64_t, 3> digits = {(value << shift) & kMask,
                                                     ((value >> 1) >> (31 - shift)) & kMask,
                                                     ((value >> 32) >> (32 - shift)) & kMask};
        for (unsigned k = 0; k < digits.size() || carry != 0; ++k, ++i) {
            const std::uint64_t sum = digits_[i] + (k < digits.size() ? digits[k] : 0) + carry;
            digits_[i] = sum & kMask;
            carry = sum >> 32;
        }
    }

    int compare(const FixedPoint& other) const {
        for (unsigned i = kDigits; i-- > 0;)
            if (digits_[i] != other.digits_[i]) return digits_[i] > other.digits_[i] ? 1 : -1;
        return 0;
    }

private:
    static constexpr int kLowest = 4 * -149;
    static constexpr unsigned kDigits = 36;  // 1152 bits: 2^-596 … 2^555
    static constexpr std::uint64_t kMask = 0xffffffffu;
    std::array<std::uint64_t, kDigits> digits_{};
};

// Sums the positive and the negative products apart; their comparison is the sign of the whole.
class ExactSum {
public:
    void add(bool minus, float a, float b, float c, float d) {
        const Parts p(a), q(b), r(c), s(d);
        const std::uint64_t first = p.mantissa * q.mantissa, second = r.mantissa * s.mantissa;
        const int exponent = p.exponent + q.exponent + r.exponent + s.exponent;
        const bool negative = minus ^ p.negative ^ q.negative ^ r.negative ^ s.negative;
        FixedPoint& sum = negative ? negative_ : positive_;
        // 48 bits times 48 bits, in halves of 24.
        for (const int i : {0, 24})
            for (const int j : {0, 24})
                sum.add(((first >> i) & 0xffffffu) * ((second >> j) & 0xffffffu), exponent + i + j);
    }

    // scale · det(p, q, r), the product of four factors each
    void addDeterminant(bool minus, float scale, glm::vec3 p, glm::vec3 q, glm::vec3 r) {
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            add(minus, scale, p[i], q[j], r[k]);
            add(!minus, scale, p[i], q[k], r[j]);
        }
    }

    int sign() const { return positive_.compare(negative_); }

private:
    FixedPoint positive_, negative_;
};

// The determinant multiplied out: no differences, so nothing to round.
// n · (light.xyz - w a) = det(l, a, b) + det(l, b, c) + det(l, c, a) - w det(a, b, c)
int exactOrientation(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec4 light) {
    ExactSum sum;
    const glm::vec3 l(light);
    sum.addDeterminant(false, 1.0f, l, a, b);
    sum.addDeterminant(false, 1.0f, l, b, c);
    sum.addDeterminant(false, 1.0f, l, c, a);
    sum.addDeterminant(true, light.w, a, b, c);
    return sum.sign();
}

}  // namespace

int orientation(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec4 light) {
    const glm::dvec3 from(a), u = glm::dvec3(b) - from, v = glm::dvec3(c) - from;
    const glm::dvec3 t = glm::dvec3(light) - double(light.w) * from;
    double determinant = 0.0, magnitude = 0.0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double plus = u[j] * v[k], minus = u[k] * v[j];
        determinant += t[i] * (plus - minus);
        magnitude += std::abs(t[i]) * (std::abs(plus) + std::abs(minus));
    }
    constexpr double kUnitRoundoff = 0.5 * std::numeric_limits<double>::epsilon();
    const double bound = 9.0 * kUnitRoundoff * magnitude;
    if (determinant > bound) return 1;
    if (determinant < -bound) return -1;
    return exactOrientation(a, b, c,
                            light);  // for inputs that are not finite, too: they stop there
}

}  // namespace penumbra
