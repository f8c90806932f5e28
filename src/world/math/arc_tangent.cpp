// Arc tangent of a quotient: t = a/b in [0, 1], then
//     atan(a/b) = atan(c) + atan((a − c·b)/(b + c·a)),    c = i/16 nearest to t,
// of which the first is in a table and the second, of an argument up to 1/32, is a short series.

#include <algorithm>
#include <cstddef>
#include <limits>

#include "world/math.hpp"
#include "world/math/double_double.hpp"

namespace flipside::math {

namespace {

/// atan(i/16): the nearest double and the rest.
constexpr DoubleDouble arc_tangents[] = {
    {0, 0},
    {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.0657e94db30d0p-1, -0x1.d5b495f6349e6p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
};
constexpr DoubleDouble half_turn{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

/// a + b, where a is the larger or 0.
DoubleDouble sum(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble high = two_sum(a.high, b.high);
    return {high.high, high.low + (a.low + b.low)};
}

/// atan(a/b) for 0 ≤ a ≤ b, b > 0.
DoubleDouble of_quotient(double a, double b) {
    // Dekker's products need room at both ends. What scaling rounds away is below any double of the quotient.
    if (b > 0x1p900) a *= 0x1p-100, b *= 0x1p-100;
    if (b < 0x1p-700) a *= 0x1p200, b *= 0x1p200;
    const double t = a / b;
    if (t < 0x1p-27) return {t, 0};
    const auto i = static_cast<std::size_t>(nearest_integer(16 * t));
    const double c = static_cast<double>(i) / 16;
    // With c of 5 bits these products are exact, and so is the first difference.
    const DoubleDouble part = split(b), numerator = two_sum(a - c * part.high, -(c * part.low));
    const double bend = c * a, denominator = b + bend, rounded = (b - denominator) + bend;
    const double q = numerator.high / denominator;
    const DoubleDouble product = two_product(q, denominator);
    const double remainder = ((numerator.high - product.high) - product.low) + (numerator.low - q * rounded);
    constexpr double series[] = {-1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11};
    const double z = q * q;
    return sum(arc_tangents[i], {q, remainder / denominator + q * z * polynomial(series, z)});
}

}  // namespace

double atan2(double y, double x) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
    double across = std::abs(x), up = std::abs(y);
    if (across == infinity || up == infinity) {
        across = across == infinity ? 1 : 0;
        up = up == infinity ? 1 : 0;
    }
    const bool steep = up > across, back = std::signbit(x);
    DoubleDouble angle;
    if (up > 0 || across > 0) angle = of_quotient(std::min(up, across), std::max(up, across));
    if (steep) angle = sum({half_turn.high / 2, half_turn.low / 2}, {-angle.high, -angle.low});
    if (back) angle = sum(half_turn, {-angle.high, -angle.low});
    return std::copysign(angle.high + angle.low, y);
}

}  // namespace flipside::math
