// A ball dropped from 1 m on a floor with e = 0.8: apexes 0.64, 0.4096, 0.262144 m, rest after 4.0637 s.

#include <gtest/gtest.h>

#include "custom/scenes.hpp"

namespace flipside::custom::test {
namespace {

Scene drop(double restitution, double radius) {
    Scene scene = empty_scene({0, -9.81});
    add_ball(scene, {0, 1 + radius}, {}, radius);
    add_part(scene, segment({-1, 0}, {1, 0}), {"", restitution, 0, 0});
    return scene;
}

/// Heights of the apexes, each from the energy of the ball between two impacts.
std::vector<double> apexes(World& world, double radius, double seconds) {
    std::vector<double> heights;
    bool flying = false;
    for (double t = 0; t < seconds; t += 1.0 / 60) {
        const double before = world.balls()[0].velocity.y;
        world.step(1.0 / 60);
        const Ball& ball = world.balls()[0];
        if (before > 0) flying = true;
        if (flying && before > 0 && ball.velocity.y <= 0)
            heights.push_back(ball.position.y - radius + ball.velocity.y * ball.velocity.y / (2 * 9.81));
    }
    return heights;
}

TEST(Drop, FirstThreeApexesAreExact) {
    for (const double radius : {0.0135, 0.1}) {
        const auto world = make_world(drop(0.8, radius));
        const std::vector<double> heights = apexes(*world, radius, 3.0);
        ASSERT_GE(heights.size(), 3U);
        for (std::size_t i = 0; i < 3; ++i) {
            const double exact = std::pow(0.64, static_cast<double>(i + 1));
            std::printf("radius %g apex %zu: %.9f m, error %.2e m\n", radius, i + 1, heights[i],
                        heights[i] - exact);
            EXPECT_NEAR(heights[i], exact, 1e-13);
        }
    }
}

TEST(Drop, ComesToRestAndSleeps) {
    const auto world = make_world(drop(0.8, 0.0135));
    run(*world, 4.5);
    EXPECT_NEAR(world->balls()[0].position.y, 0.0135, 1e-9);
    EXPECT_EQ(world->balls()[0].velocity, Vec2{});
    EXPECT_TRUE(world->balls()[0].asleep);
    EXPECT_EQ(world->contacts().size(), 1U);
    world->step(1.0 / 60);
    EXPECT_EQ(world->statistics().pair_tests, 0U);
}

}  // namespace
}  // namespace flipside::custom::test
