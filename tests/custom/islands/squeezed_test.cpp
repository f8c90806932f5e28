// Balls that an impact drives between others and walls: many impacts at one instant, or without end.

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "custom/scenes.hpp"
#include "in_small.hpp"

namespace flipside::custom::test {
namespace {

double between(std::mt19937& random, double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / static_cast<double>(std::mt19937::max()));
}

/// A ball between a floor and a wall that leans over it by up to 60°, and a ball that hits it from the open
/// side.
Scene wedge(std::mt19937& random, double most_ratio) {
    const double lean = between(random, 0.5, 1.5), r = between(random, 0.03, 0.1);
    Scene scene = empty_scene({0, -9.81});
    scene.rest_speed = 0.1;
    scene.materials[0] = {"ball", between(random, 0, 1), 0, 0};
    const Vec2 up{-std::cos(lean), std::sin(lean)}, inward{-std::sin(lean), -std::cos(lean)};
    add_part(scene, segment({-5, 0}, {5, 0}), {"", between(random, 0, 1), 0, 0});
    add_part(scene, segment({0, 0}, 5 * up), {"", between(random, 0, 1), 0, 0});
    // The ball touches both: it is one radius above the floor and one radius from the wall.
    const Vec2 lies{-r * (1 - inward.y) / -inward.x, r};
    add_ball(scene, lies, {}, r, 1);
    const double other = between(random, 0.03, 0.1);
    const double angle = std::numbers::pi - lean * between(random, 0.2, 0.8);
    double far = r + other;
    Vec2 from;
    do {
        far += 0.02;
        from = lies + far * Vec2{std::cos(angle), std::sin(angle)};
    } while (from.y < other || dot(from, inward) < other);
    add_ball(scene, from, between(random, 1, 10) * unit(lies - from), other,
             std::exp(between(random, 0, std::log(most_ratio))));
    return scene;
}

/// A light ball on the inside of an arc, and a ball up to `most_ratio` times its mass that hits it off its
/// middle, so that it is squeezed out and flies along the arc.
Scene bowl(std::mt19937& random, double most_ratio) {
    const double radius = between(random, 0.2, 0.5), r = between(random, 0.03, 0.07);
    Scene scene = empty_scene({0, -9.81});
    scene.rest_speed = 0.1;
    add_part(scene, {shape::Arc{{0, 0}, radius, -3.3, 0.2}}, {"", between(random, 0, 1), 0, 0});
    const double at = between(random, -2.2, -0.9);
    const Vec2 lies = (radius - r) * Vec2{std::cos(at), std::sin(at)};
    add_ball(scene, lies, {}, r, 1);
    const double other = between(random, 0.02, 0.05), aside = between(random, -0.9, 0.9) * (r + other);
    const Vec2 from = lies + Vec2{aside, radius + r + other};
    add_ball(scene, from, {0, -between(random, 1, 8)}, other,
             std::exp(between(random, 0, std::log(most_ratio))));
    return scene;
}

/// The deepest overlap of a ball with anything in 3,000 of these scenes, in radii of the smaller ball.
double deepest(Scene (*make)(std::mt19937&, double), double most_ratio, unsigned seed) {
    std::mt19937 random(seed);
    double deepest = 0;
    for (int i = 0; i < (flipside::test::in_small ? 100 : 3000); ++i) {
        const Scene scene = make(random, most_ratio);
        const auto world = make_world(scene);
        double here = 0;
        for (int step = 0; step < 120; ++step) {
            world->step(1.0 / 240);
            for (const Contact& contact : world->contacts())
                here = std::max(here,
                                -contact.separation / std::min(scene.balls[0].radius, scene.balls[1].radius));
        }
        deepest = std::max(deepest, here);
    }
    return deepest;
}

TEST(Squeezed, AnImpactOnABallInAWedgeCausesNoDeepOverlap) {
    EXPECT_LT(deepest(wedge, 2, 1), 0.01);
    EXPECT_LT(deepest(wedge, 100, 2), 0.02);
}

// Between two ticks such a ball would cross the arc on a chord, up to 1.6 radii deep. What is left is between
// the balls, of which one is turned by the arc within a tick.
TEST(Squeezed, ABallThatIsSqueezedOutAlongAnArcDoesNotEnterIt) {
    EXPECT_LT(deepest(bowl, 300, 3), 0.05);
}

}  // namespace
}  // namespace flipside::custom::test
