/// The elementary functions against numbers of 113 to 1300 bits.

#include "world/math.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

namespace flipside {
namespace {

namespace mp = boost::multiprecision;
template <unsigned bits>
using Float = mp::number<mp::cpp_bin_float<bits, mp::digit_base_2>, mp::et_off>;
using Float128 = Float<128>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double least = std::numeric_limits<double>::denorm_min();
constexpr double greatest = std::numeric_limits<double>::max();

/// Units in the last place of `exact` between it and `value`.
template <class R>
double error_in_ulps(double value, const R& exact) {
    const double size = std::abs(static_cast<double>(exact));
    const double ulp = std::max(std::ldexp(1.0, std::ilogb(size) - 52), least);
    return std::abs(static_cast<double>((R(value) - exact) / R(ulp)));
}

/// Arguments of every kind; the same ones each time, with every library.
class Arguments {
  public:
    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    /// Of a size between two powers of 2, all equally likely.
    double of_size(double from, double to) {
        return std::exp2(std::floor(uniform(from, to))) * uniform(1, 2);
    }
    double sign() { return engine_() % 2 == 0 ? 1 : -1; }
    /// Steps by a few doubles.
    double beside(double x) {
        return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + engine_() % 9 - 4);
    }

  private:
    std::mt19937_64 engine_{1};
};

/// The greatest error over many arguments, with the argument.
class Worst {
  public:
    template <class R>
    void see(double value, const R& exact, double argument, double other = 0) {
        const double error = error_in_ulps(value, exact);
        if (!(error <= error_)) error_ = error, argument_ = argument, other_ = other;
    }
    void expect_below(double limit) const {
        EXPECT_LT(error_, limit) << std::hexfloat << argument_ << ' ' << other_;
    }

  private:
    double error_ = 0, argument_ = 0, other_ = 0;
};

/// A million arguments in all; a fiftieth of them where nothing is optimised, or instrumented.
#ifdef NDEBUG
constexpr int many = 85'000;
#else
constexpr int many = 1700;
#endif

template <class R>
void see_sine(double x, Worst& sine, Worst& cosine) {
    const auto [s, c] = math::sincos(x);
    sine.see(s, sin(R(x)), x);
    cosine.see(c, cos(R(x)), x);
}

TEST(Math, SineAndCosine) {
    Arguments arguments;
    Worst sine, cosine;
    for (int i = 0; i < many; ++i) {
        see_sine<Float128>(arguments.uniform(-8, 8), sine, cosine);
        see_sine<Float128>(arguments.sign() * arguments.of_size(-40, 24), sine, cosine);
    }
    sine.expect_below(0.9);
    cosine.expect_below(0.9);
}

TEST(Math, SineAndCosineNextToMultiplesOfAQuarterTurn) {
    Arguments arguments;
    Worst sine, cosine;
    for (int i = 0; i < many / 10; ++i) {
        const double turns = std::floor(arguments.of_size(0, 30));
        see_sine<Float<200>>(arguments.beside(turns * std::numbers::pi / 4), sine, cosine);
    }
    sine.expect_below(0.9);
    cosine.expect_below(0.9);
}

TEST(Math, SineAndCosineOfHugeAngles) {
    Arguments arguments;
    Worst sine, cosine;
    for (int i = 0; i < many / 100; ++i) see_sine<Float<1300>>(arguments.of_size(24, 1024), sine, cosine);
    // Kahan's: the double that is nearest to a multiple of π/2.
    see_sine<Float<1300>>(0x1.6ac5b262ca1ffp+849, sine, cosine);
    see_sine<Float<1300>>(greatest, sine, cosine);
    sine.expect_below(0.9);
    cosine.expect_below(0.9);
}

TEST(Math, ArcTangent) {
    Arguments arguments;
    Worst worst;
    const auto see = [&](double y, double x) {
        worst.see(math::atan2(y, x), Float128(atan2(Float128(y), Float128(x))), y, x);
    };
    for (int i = 0; i < many; ++i) {
        see(arguments.uniform(-1, 1), arguments.uniform(-1, 1));
        const double x = arguments.sign() * arguments.of_size(-1000, 1000);
        see(x * arguments.sign() * arguments.of_size(-20, 20), x);
    }
    worst.expect_below(0.6);
}

TEST(Math, Expm1) {
    Arguments arguments;
    Worst worst;
    const auto see = [&](double x) { worst.see(math::expm1(x), Float128(expm1(Float128(x))), x); };
    for (int i = 0; i < many; ++i) {
        see(arguments.uniform(-3, 3));
        see(arguments.sign() * arguments.of_size(-60, 5));
        see(arguments.uniform(-50, 709.78));
    }
    worst.expect_below(0.9);
}

TEST(Math, Log1p) {
    Arguments arguments;
    Worst worst;
    const auto see = [&](double x) { worst.see(math::log1p(x), Float128(log1p(Float128(x))), x); };
    for (int i = 0; i < many; ++i) {
        see(arguments.uniform(-1, 3));
        see(arguments.sign() * arguments.of_size(-60, -1));
        see(arguments.of_size(-60, 1023));
        see(arguments.of_size(-53, -1) - 1);
    }
    worst.expect_below(0.6);
}

TEST(Math, Root) {
    Arguments arguments;
    Worst worst;
    const auto see = [&](double x, int n) {
        worst.see(math::root(x, n), Float128(pow(Float128(x), Float128(1) / n)), x, n);
    };
    for (int i = 0; i < many; ++i)
        see(arguments.of_size(-1074, 1024), static_cast<int>(arguments.uniform(2, 40)));
    worst.expect_below(0.8);
}

/// Equal, with the sign of a zero; or both no number.
void expect_same(double value, double expected) {
    if (std::isnan(expected))
        EXPECT_TRUE(std::isnan(value)) << value;
    else
        EXPECT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected)) << value;
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
using std::numbers::pi;

TEST(Math, SpecialValuesOfSineAndCosine) {
    for (const double zero : {0.0, -0.0, least, -least}) {
        expect_same(math::sin(zero), zero);
        expect_same(math::cos(zero), 1);
    }
    for (const double none : {infinity, -infinity, nan}) {
        expect_same(math::sin(none), nan);
        expect_same(math::cos(none), nan);
    }
}

TEST(Math, SpecialValuesOfTheArcTangent) {
    for (const double s : {1.0, -1.0}) {  // C's Annex F.10.1.4
        expect_same(math::atan2(s * 0.0, -0.0), s * pi);
        expect_same(math::atan2(s * 0.0, 0.0), s * 0.0);
        for (const double x : {least, 1.0, greatest, infinity}) {
            expect_same(math::atan2(s * 0.0, -x), s * pi);
            expect_same(math::atan2(s * 0.0, x), s * 0.0);
            expect_same(math::atan2(s * x, 0.0), s * pi / 2);
            expect_same(math::atan2(s * x, -0.0), s * pi / 2);
            if (x == infinity) continue;
            expect_same(math::atan2(s * x, -infinity), s * pi);
            expect_same(math::atan2(s * x, infinity), s * 0.0);
            expect_same(math::atan2(s * infinity, x), s * pi / 2);
            expect_same(math::atan2(s * x, x), s * pi / 4);
            expect_same(math::atan2(s * x, -x), s * 3 * pi / 4);
        }
        expect_same(math::atan2(s * infinity, infinity), s * pi / 4);
        expect_same(math::atan2(s * infinity, -infinity), s * 3 * pi / 4);
        expect_same(math::atan2(s * least, greatest), s * 0.0);
        expect_same(math::atan2(s * least, 1), s * least);
    }
    expect_same(math::atan2(nan, 1), nan);
    expect_same(math::atan2(1, nan), nan);
}

TEST(Math, SpecialValuesOfExponentialLogarithmAndRoot) {
    for (const double same : {0.0, -0.0, least, -least, infinity, nan}) {
        expect_same(math::expm1(same), same);
        expect_same(math::log1p(same), same);
    }
    expect_same(math::expm1(-infinity), -1);
    expect_same(math::expm1(-1000), -1);
    expect_same(math::expm1(709.8), infinity);
    expect_same(math::log1p(-1), -infinity);
    expect_same(math::log1p(-1.5), nan);
    expect_same(math::log1p(-infinity), nan);
    for (const double same : {0.0, infinity, nan}) expect_same(math::root(same, 3), same);
    expect_same(math::root(-1, 3), nan);
    for (const int n : {1, 2, 3, 20, 22}) expect_same(math::root(1, n), 1);
    expect_same(math::root(greatest, 1), greatest);
    expect_same(math::root(0x1p-1074, 2), 0x1p-537);
    expect_same(math::root(0x1p1023, 33), 0x1p31);
}

}  // namespace
}  // namespace flipside
