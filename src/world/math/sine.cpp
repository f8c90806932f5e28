// Sine and cosine: the angle less the nearest multiple of π/2, in two doubles, then polynomials on [−π/4,
// π/4].

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

#include "world/math.hpp"
#include "world/math/double_double.hpp"

namespace flipside::math {

namespace {

__extension__ using Unsigned128 = unsigned __int128;

/// angle = quadrant·π/2 + rest (modulo 2π); |rest| ≤ π/4 but for rounding.
struct Reduced {
    unsigned quadrant = 0;
    DoubleDouble rest;
};

constexpr DoubleDouble half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

/// The bits of 2/π behind the binary point, after a word of zeros.
constexpr std::uint64_t two_over_pi[] = {0,
                                         0xa2f9836e4e441529,
                                         0xfc2757d1f534ddc0,
                                         0xdb6295993c439041,
                                         0xfe5163abdebbc561,
                                         0xb7246e3a424dd2e0,
                                         0x06492eea09d1921c,
                                         0xfe1deb1cb129a73e,
                                         0xe88235f52ebb4484,
                                         0xe99c7026b45f7e41,
                                         0x3991d639835339f4,
                                         0x9c845f8bbdf9283b,
                                         0x1ff897ffde05980f,
                                         0xef2f118b5a0a6d1f,
                                         0x6d367ecf27cb09b7,
                                         0x4f463f669e5fea2d,
                                         0x7527bac7ebe5f17b,
                                         0x3d0739f78a5292ea,
                                         0x6bfb5fb11f8d5d08,
                                         0x56033046fc7b6bab};

/// 64 of those bits, from bit `first` on.
std::uint64_t bits_of_two_over_pi(std::size_t first) {
    const std::size_t word = first / 64, shift = first % 64;
    if (shift == 0) return two_over_pi[word];
    return two_over_pi[word] << shift | two_over_pi[word + 1] >> (64 - shift);
}

/// For any finite angle ≥ π/4 (Payne and Hanek 1983): angle·2/π modulo 4 in integers of 192 bits. Bits of 2/π
/// that make multiples of 4 are left out, those after the 192nd add less than 2^−137. No double is nearer to
/// a multiple of π/2 than about 2^−62 of it, so that 75 bits of the rest are right.
Reduced reduce_exactly(double angle) {
    const auto bits = std::bit_cast<std::uint64_t>(angle);
    const std::uint64_t mantissa = (bits & 0x000fffffffffffff) | 0x0010000000000000;
    const auto first = static_cast<std::size_t>((bits >> 52) - 1075 + 62);  // of weight 2^(1 − exponent)
    const Unsigned128 low = static_cast<Unsigned128>(mantissa) * bits_of_two_over_pi(first + 128);
    const Unsigned128 middle =
        static_cast<Unsigned128>(mantissa) * bits_of_two_over_pi(first + 64) + (low >> 64);
    std::uint64_t words[] = {mantissa * bits_of_two_over_pi(first) + static_cast<std::uint64_t>(middle >> 64),
                             static_cast<std::uint64_t>(middle), static_cast<std::uint64_t>(low)};

    auto quadrant = static_cast<unsigned>(words[0] >> 62);
    words[0] = words[0] << 2 | words[1] >> 62;
    words[1] = words[1] << 2 | words[2] >> 62;
    words[2] <<= 2;
    // What is left is a fraction. From ½ on the next multiple is nearer, and the rest is negative.
    const bool negative = words[0] >> 63 != 0;
    if (negative) {
        ++quadrant;
        words[2] = ~words[2] + 1;
        words[1] = ~words[1] + (words[2] == 0 ? 1 : 0);
        words[0] = ~words[0] + (words[1] == 0 && words[2] == 0 ? 1 : 0);
    }
    int exponent = -64;
    while (words[0] >> 63 == 0 && exponent > -256) {  // to the first bit that is set
        const int zeros = words[0] == 0 ? 63 : std::countl_zero(words[0]);
        words[0] = words[0] << zeros | words[1] >> (64 - zeros);
        words[1] = words[1] << zeros | words[2] >> (64 - zeros);
        words[2] <<= zeros;
        exponent -= zeros;
    }
    const double scale = (negative ? -1 : 1) * std::ldexp(1.0, exponent);
    const double high = static_cast<double>(words[0] & ~std::uint64_t{0x7ff}) * scale;
    const double low_part =
        (static_cast<double>(words[0] & 0x7ff) + static_cast<double>(words[1]) * 0x1p-64) * scale;
    const DoubleDouble product = two_product(high, half_pi.high);
    return {quadrant & 3, {product.high, product.low + (high * half_pi.low + low_part * half_pi.high)}};
}

/// For π/4 ≤ angle: π/2 in parts of 33, 33 and 53 bits (Cody and Waite 1980), where that is good enough.
Reduced reduce(double angle) {
    constexpr double first = 0x1.921fb544p+0, second = 0x1.0b4611a6p-34, third = 0x1.3198a2e037073p-69;
    constexpr double most = 0x1p20;  // the multiples of the first two parts are exact up to here
    if (angle > most) return reduce_exactly(angle);
    const double turns = nearest_integer(angle * (2 / std::numbers::pi));
    const DoubleDouble near = two_sum(angle - turns * first, -(turns * second));
    // The third part's rounding is below 2^−99.
    if (std::abs(near.high) < 0x1p-30) return reduce_exactly(angle);
    const double low = near.low - turns * third, high = near.high + low;
    return {static_cast<unsigned>(turns) & 3, {high, (near.high - high) + low}};
}

/// On [−π/4, π/4]. Both polynomials are Chebyshev interpolations in z = x², for z up to (π/4)²: of (sin x −
/// x)/x³ with an error of 2.1e-17, and of (cos x − 1 + z/2)/z² with one of 1.3e-18.
SineCosine on_quarter(DoubleDouble x) {
    constexpr double of_sine[] = {-0.16666666666666666,   0.008333333333330948,    -0.00019841269836756774,
                                  2.7557316101617874e-06, -2.5051131650235181e-08, 1.5918115263265974e-10};
    constexpr double of_cosine[] = {0.041666666666666664,    -0.0013888888888887398, 2.4801587298764561e-05,
                                    -2.7557317271145144e-07, 2.087614614655861e-09,  -1.1382623647474604e-11};
    const double z = x.high * x.high, half = 0.5 * z, most = 1 - half;
    const double sine = x.high + (x.high * z * polynomial(of_sine, z) + x.low * most);
    const double cosine = most + (((1 - most) - half) + (z * z * polynomial(of_cosine, z) - x.high * x.low));
    return {sine, cosine};
}

}  // namespace

SineCosine sincos(double angle) {
    const double size = std::abs(angle);
    if (size < 0x1p-27) return {angle, 1};
    if (size <= std::numbers::pi / 4) return on_quarter({angle, 0});
    if (!(size < std::numeric_limits<double>::infinity())) {
        const double none = std::numeric_limits<double>::quiet_NaN();
        return {none, none};
    }
    const Reduced reduced = reduce(size);
    const auto [s, c] = on_quarter(reduced.rest);
    const double sign = angle < 0 ? -1 : 1;
    switch (reduced.quadrant) {
        case 0:
            return {sign * s, c};
        case 1:
            return {sign * c, -s};
        case 2:
            return {-sign * s, -c};
        default:
            return {-sign * c, s};
    }
}

double sin(double angle) {
    return sincos(angle).sine;
}

double cos(double angle) {
    return sincos(angle).cosine;
}

}  // namespace flipside::math
