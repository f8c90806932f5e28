#include <cstdio>

#include <gtest/gtest.h>

#include "box2d/table_top.hpp"
#include "world/input_error.hpp"

namespace flipside::box2d::test {
namespace {

TEST(Box2dWorld, dropBouncesNearlyToTheExactApexes) {
    // e = 0.8 from 1 m: apexes 0.64, 0.4096, 0.262144 m. Semi-implicit Euler falls short of the apex v²/2g
    // of each flight by v·h/2, which is g·h/v of it, and hands the loss on to the next.
    TableTop top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}, top.material(0.8));
    top.ball({0, 1 + 0.0135});
    const auto world = top.world();
    double apexes[3], low = 0, high = 0;
    int bounces = 0;
    run(*world, 3, [&] {
        if (count(world->events(), EventKind::impact) > 0) {
            if (bounces > 0 && bounces <= 3) apexes[bounces - 1] = high;
            ++bounces;
            high = 0;
        }
        high = std::max(high, world->balls()[0].position.y - 0.0135);
        low = std::min(low, world->balls()[0].position.y - 0.0135);
    });
    ASSERT_GE(bounces, 4);
    const double exact[3] = {0.64, 0.4096, 0.262144};
    double bound = 0;
    for (int i = 0; i < 3; ++i) {
        bound += 9.81 * frame / std::sqrt(2 * 9.81 * exact[i]);
        std::printf("apex %d: %.6f m, exact %.6f m, error %+.2f %%\n", i + 1, apexes[i], exact[i],
                    100 * (apexes[i] / exact[i] - 1));
        EXPECT_NEAR(apexes[i] / exact[i], 1, bound);
    }
    EXPECT_GT(low, -0.07 * 0.0135);  // at most 3 slops of 0.005 units: 6 % of the radius, and rounding
}

TEST(Box2dWorld, ballComesToRestAndSleeps) {
    TableTop top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}, top.material(0.5));
    top.ball({0, 0.1});
    const auto world = top.world();
    run(*world, 3);
    EXPECT_TRUE(world->balls()[0].asleep);
    EXPECT_EQ(world->balls()[0].velocity, Vec2{});
    EXPECT_NEAR(world->balls()[0].position.y, 0.0135, 0.021 * 0.0135);  // one slop is 2 % of the radius
    ASSERT_EQ(world->contacts().size(), 1U);
    EXPECT_NEAR(world->contacts()[0].normal.y, 1, 1e-6);
    EXPECT_EQ(world->statistics().asleep, 1U);
}

}  // namespace
}  // namespace flipside::box2d::test
