/// The elementary functions give the same bits in every build and on every processor.

#include <bit>
#include <cstdint>
#include <random>

#include <boost/crc.hpp>
#include <gtest/gtest.h>

#include "world/math.hpp"

namespace flipside {
namespace {

/// Of the bits of f(x) for 10^5 numbers of sizes from 2^from to 2^to, of either sign.
template <class F>
std::uint32_t checksum_of(const F& f, int from, int to) {
    std::mt19937_64 random(1);
    boost::crc_32_type crc;
    for (int i = 0; i < 100'000; ++i) {
        const std::uint64_t word = random();
        const int exponent = from + 1023 + static_cast<int>(random() % static_cast<unsigned>(to - from));
        const double x =
            std::bit_cast<double>((word & 0x800fffffffffffff) | static_cast<std::uint64_t>(exponent) << 52);
        const double value = f(x);
        if (value != value) continue;  // which no-number it is, IEEE 754 leaves open
        const auto bits = std::bit_cast<std::uint64_t>(value);
        for (int byte = 0; byte < 8; ++byte) crc.process_byte(static_cast<unsigned char>(bits >> 8 * byte));
    }
    return crc.checksum();
}

TEST(GoldenMath, SameBitsInEveryBuild) {
    EXPECT_EQ(checksum_of(math::sin, -30, 30), 0x3d51effc);
    EXPECT_EQ(checksum_of(math::cos, -30, 30), 0x82a69d1e);
    EXPECT_EQ(checksum_of(math::sin, 30, 1024), 0x6ede8211);
    EXPECT_EQ(checksum_of([](double x) { return math::atan2(x, 0.7); }, -60, 60), 0x15b27860);
    EXPECT_EQ(checksum_of([](double x) { return math::atan2(0.7, x); }, -60, 60), 0x57eb0f20);
    EXPECT_EQ(checksum_of(math::expm1, -60, 10), 0x548d11a7);
    EXPECT_EQ(checksum_of(math::log1p, -60, 1023), 0x6c3b1751);
    EXPECT_EQ(checksum_of([](double x) { return math::root(x, 3); }, -1022, 1023), 0x2967e43c);
    EXPECT_EQ(checksum_of([](double x) { return math::root(x, 22); }, -1022, 1023), 0xde3d17d3);
}

}  // namespace
}  // namespace flipside
