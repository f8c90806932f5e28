#pragma once
/// Sums and products of doubles with their rounding errors (Dekker 1971, "A floating-point technique for
/// extending the available precision"). Without std::fma, which is slow on processors that have no such
/// instruction.

#include <cfloat>
#include <cmath>
#include <limits>

namespace flipside::math {

static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0,
              "every operation rounds to double");

/// The unevaluated sum high + low.
struct DoubleDouble {
    double high = 0, low = 0;
};

/// a + b exactly.
inline DoubleDouble two_sum(double a, double b) {
    const double sum = a + b, of_b = sum - a;
    return {sum, (a - (sum - of_b)) + (b - of_b)};
}
/// The upper 26 bits of a and the rest, for |a| < 2^996.
inline DoubleDouble split(double a) {
    const double big = 0x1.0000002p27 * a, high = big - (big - a);
    return {high, a - high};
}
/// a·b exactly, for factors below 2^996 and a product in [2^−968, 2^1021].
inline DoubleDouble two_product(double a, double b) {
    const double product = a * b;
    const DoubleDouble u = split(a), v = split(b);
    const double error = ((u.high * v.high - product) + u.high * v.low + u.low * v.high) + u.low * v.low;
    return {product, error};
}
/// The nearest integer, for |x| < 2^51: doubles there have no room for a fraction.
inline double nearest_integer(double x) {
    constexpr double no_fraction = 0x1.8p52;
    return (x + no_fraction) - no_fraction;
}
/// coefficients[0] + x·(coefficients[1] + x·(…)).
template <std::size_t n>
double polynomial(const double (&coefficients)[n], double x) {
    double sum = coefficients[n - 1];
    for (std::size_t k = n - 1; k-- > 0;) sum = coefficients[k] + x * sum;
    return sum;
}

}  // namespace flipside::math
