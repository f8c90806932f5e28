// Exponential and logarithm by way of powers of 2: x = k·ln 2 + r with |r| ≤ ½ ln 2, and x = 2^k·m with m
// between √½ and √2.

#include <bit>
#include <cstdint>
#include <limits>

#include "world/math.hpp"
#include "world/math/double_double.hpp"

namespace flipside::math {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// ln 2: 32 bits, so that multiples up to 2^20 are exact, and the rest.
constexpr DoubleDouble ln_2{0x1.62e42feep-1, 0x1.a39ef35793c76p-33};

/// e^x = 2^k·(1 + r + rest).
struct Exponential {
    int k = 0;
    double r = 0, rest = 0;
};

/// For |x| < 800.
Exponential exponential(DoubleDouble x) {
    // 1/3!, 1/4!, …: what is left out is below 2^−59 of e^r − 1.
    constexpr double series[] = {
        1.0 / 6,          1.0 / 24,          1.0 / 120,          1.0 / 720,      1.0 / 5040,
        1.0 / 40320,      1.0 / 362880,      1.0 / 3628800,      1.0 / 39916800, 1.0 / 479001600,
        1.0 / 6227020800, 1.0 / 87178291200, 1.0 / 1307674368000};
    constexpr double one_over_ln_2 = 0x1.71547652b82fep+0;
    // Up to ½ it is as it is: e^r − 1 would lose digits where it is less than 2^k − 1.
    const double k = std::abs(x.high) <= 0.5 ? 0 : nearest_integer(x.high * one_over_ln_2);
    const DoubleDouble r = two_sum(x.high - k * ln_2.high, x.low - k * ln_2.low);
    const double square = r.high * r.high;
    const double rest = square * (0.5 + r.high * polynomial(series, r.high)) + (r.low + r.low * r.high);
    return {static_cast<int>(k), r.high, rest};
}

/// 2^k, −1022 ≤ k ≤ 1023.
double power_of_two(int k) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52);
}

/// 2^k·(1 + f + low), with 1 + f between √½ and √2.
struct Scaled {
    int k = 0;
    double f = 0, low = 0;
};

/// A normal u.high > 0 and |u.low| ≤ ulp(u.high).
Scaled scaled(DoubleDouble u) {
    constexpr auto root_half = std::bit_cast<std::uint64_t>(0x1.6a09e667f3bcdp-1);
    const auto bits = std::bit_cast<std::uint64_t>(u.high);
    const auto k = static_cast<int>(static_cast<std::int64_t>(bits - root_half) >> 52);
    const double m = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(k) << 52));
    return {k, m - 1, u.low == 0 ? 0 : u.low * power_of_two(-k)};
}

/// Natural, by ln(1 + f) = 2·artanh(s), s = f/(2 + f).
DoubleDouble logarithm(const Scaled& x) {
    const double denominator = 2 + x.f, rounded = x.f - (denominator - 2);
    const double s = x.f / denominator;
    const DoubleDouble product = two_product(s, denominator);
    const double remainder = ((x.f - product.high) - product.low) + (x.low * (1 - s) - s * rounded);
    // What is left out is below 2^−60 of it.
    constexpr double series[] = {2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11,
                                 2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21};
    const double z = s * s, rest = 2 * remainder / denominator + s * z * polynomial(series, z);
    const DoubleDouble high = two_sum(x.k * ln_2.high, 2 * s);
    return {high.high, high.low + (rest + x.k * ln_2.low)};
}

}  // namespace

double expm1(double x) {
    if (std::abs(x) < 0x1p-54 || std::isnan(x)) return x;
    if (x > 710) return infinity;
    if (x < -40) return -1;
    const Exponential e = exponential({x, 0});
    if (e.k > 60) {  // the 1 is below rounding; 2^1024 is not a double, but twice 2^1023 times less than 1 is
        const DoubleDouble one = two_sum(1, e.r);
        return (one.high + (one.low + e.rest)) * power_of_two(e.k - 1) * 2;
    }
    const double scale = power_of_two(e.k);
    const DoubleDouble less = two_sum(scale, -1), all = two_sum(less.high, scale * e.r);
    return all.high + (all.low + (less.low + scale * e.rest));
}

double log1p(double x) {
    if (std::abs(x) < 0x1p-54 || std::isnan(x) || x == infinity) return x;
    if (x <= -1) return x == -1 ? -infinity : not_a_number;
    Scaled u{0, x, 0};
    if (x < -0.25 || x > 0.375) {
        const DoubleDouble sum = two_sum(1, x);
        u = scaled({sum.high, sum.high < 0x1p60 ? sum.low : 0});
    }
    const DoubleDouble log = logarithm(u);
    return log.high + log.low;
}

double root(double x, int n) {
    if (!(x > 0) || x == infinity || n == 1) return x < 0 ? not_a_number : x;
    const bool subnormal = x < std::numeric_limits<double>::min();
    Scaled u = scaled({subnormal ? x * 0x1p54 : x, 0});
    if (subnormal) u.k -= 54;
    const DoubleDouble log = logarithm(u);
    const double quotient = log.high / n;
    const DoubleDouble product = two_product(quotient, n);
    const double rest = ((log.high - product.high) - product.low + log.low) / n;
    const Exponential e = exponential({quotient, rest});
    const DoubleDouble one = two_sum(1, e.r);
    return (one.high + (one.low + e.rest)) * power_of_two(e.k);
}

}  // namespace flipside::math
