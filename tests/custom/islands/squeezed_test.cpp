// Balls that an impact drives between others and walls: many impacts at one instant, or without end.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "custom/scenes.hpp"
#include "in_small.hpp"
#include "world/scene_file.hpp"

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

/// Six balls that fall into a narrow pit, heavier and heavier: the last has up to `most_ratio` times the mass
/// of the first.
Scene pit(std::mt19937& random, double most_ratio) {
    Scene scene = empty_scene({0, -9.81});
    scene.rest_speed = 0.1;
    const double width = between(random, 0.2, 0.5), slope = between(random, -0.1, 0.1);
    const Material walls{"", between(random, 0, 1), 0, 0};
    add_part(scene, {shape::Polyline{{{0, 9}, {0, slope}, {width, -slope}, {width, 9}}, false}}, walls);
    double above = 0.2;
    for (int i = 0; i < 6; ++i) {
        const double r = between(random, 0.02, 0.09);
        const double mass = std::exp((i + between(random, 0, 1)) / 6 * std::log(most_ratio));
        const Vec2 velocity{between(random, -2, 2), between(random, -5, 0)};
        add_ball(scene, {between(random, r, width - r), above + r}, velocity, r, mass);
        above += 2 * r + 0.01;
    }
    return scene;
}

/// Twelve balls of all sizes that fall into a pit, with masses up to `most_ratio` times the least, in any
/// order.
Scene filled_pit(std::mt19937& random, double most_ratio) {
    Scene scene = empty_scene({0, -9.81});
    scene.rest_speed = 0.1;
    scene.materials[0] = {"ball", between(random, 0, 0.9), 0, 0};
    const double width = between(random, 0.3, 1);
    add_part(scene, {shape::Polyline{{{0, 6}, {0, 0}, {width, 0}, {width, 6}}, false}},
             {"", between(random, 0, 0.9), 0, 0});
    double above = 0.1;
    for (int i = 0; i < 12; ++i) {
        const double r = std::min(between(random, 0.03, 0.12), 0.4 * width);
        const double mass = std::exp(between(random, 0, std::log(most_ratio)));
        const Vec2 velocity{between(random, -1, 1), between(random, -6, 0)};
        add_ball(scene, {between(random, r, width - r), above + r}, velocity, r, mass);
        above += 2 * r + 0.005;
    }
    return scene;
}

/// Depth of an overlap in radii of the smaller ball; below 0 for a gap.
double depth(const Scene& scene, const Contact& contact) {
    double r = scene.balls[contact.ball].radius;
    if (contact.other.is_ball) r = std::min(r, scene.balls[contact.other.index].radius);
    return -contact.separation / r;
}

/// The deepest overlap of a ball with anything in so many steps of 1/240 s, radii.
double deepest_in(const Scene& scene, int steps) {
    const auto world = make_world(scene);
    double deepest = 0;
    for (int step = 0; step < steps; ++step) {
        world->step(1.0 / 240);
        for (const Contact& contact : world->contacts()) deepest = std::max(deepest, depth(scene, contact));
    }
    return deepest;
}

/// The deepest in so many of these scenes, radii.
double deepest(Scene (*make)(std::mt19937&, double), double most_ratio, unsigned seed, int scenes = 3000) {
    std::mt19937 random(seed);
    double deepest = 0;
    for (int i = 0; i < (flipside::test::in_small ? 100 : scenes); ++i)
        deepest = std::max(deepest, deepest_in(make(random, most_ratio), 120));
    return deepest;
}

TEST(Squeezed, AnImpactOnABallInAWedgeCausesNoDeepOverlap) {
    EXPECT_LT(deepest(wedge, 2, 1), 0.01);
    EXPECT_LT(deepest(wedge, 100, 2), 0.015);
}

// Between two ticks such a ball would cross the arc on a chord, up to 1.6 radii deep. What is left is between
// the balls, of which one is turned by the arc within a tick.
TEST(Squeezed, ABallThatIsSqueezedOutAlongAnArcDoesNotEnterIt) {
    EXPECT_LT(deepest(bowl, 300, 3), 0.015);
}

// Positions must be corrected until the heavy balls have moved, and no farther than needed: else the light
// ones slide out into their neighbours.
TEST(Squeezed, LightBallsUnderHeavyOnesOverlapLittle) {
    EXPECT_LT(deepest(pit, 100, 4, 1000), 0.025);
    EXPECT_LT(deepest(pit, 1000, 5, 1000), 0.025);
}

// The position correction pushes a light ball out from under a heavy one, into others that may still fly.
TEST(Squeezed, ABallIsNotPushedOutOfOneIntoAnotherThatFlies) {
    EXPECT_LT(deepest(filled_pit, 10, 6, 1000), 0.02);
}

// Both creep to the wall, the lower one pushed by the one on the slope. What creeps has no impacts with
// walls.
TEST(Squeezed, BallsThatSlideIntoACornerDoNotEnterTheWall) {
    for (const double wall : {2.0, 2.05, 2.1, 2.15, 2.2}) {
        Scene scene = empty_scene({0, -9.81});
        scene.rest_speed = 0.1;
        scene.materials[0] = {"ball", 0, 0, 0};
        add_part(scene, {shape::Polyline{{{-8, 1.4}, {0, 0}, {wall, 0}, {wall, 9}}, false}}, {"", 0, 0, 0});
        add_ball(scene, {-1.38, 1.1}, {}, 1);
        add_ball(scene, {0.6, 1}, {}, 1);
        EXPECT_LT(deepest_in(scene, 480), 0.005) << wall;
    }
}

// It falls at 0.6 to 1.1 m/s. The impulse that stops it acts at one instant: as a force over a whole tick it
// threw the ball up again at several times that speed.
TEST(Squeezed, AHeavyBallThatFallsOnALightOneDoesNotRise) {
    for (const double ratio : {1e3, 1e4, 1e5})
        for (int i = 0; i < 40; ++i) {
            Scene scene = empty_scene({0, -9.81});
            scene.materials[0] = {"ball", 0, 0, 0};
            add_part(scene, segment({-1, 0}, {1, 0}), {"", 0, 0, 0});
            add_ball(scene, {0, 0.1}, {}, 0.1, 1 / ratio);
            const double height = 0.02 + 0.001 * i;
            add_ball(scene, {0, 0.3 + height}, {}, 0.1, 1);
            const auto world = make_world(scene);
            for (int step = 0; step < 120; ++step) {
                world->step(1.0 / 240);
                ASSERT_LT(world->balls()[1].velocity.y, 0.2) << ratio << ", from " << height << " m";
            }
        }
}

// Its arms press the ball between them, and its impacts on them have no end. Relative to them it hardly
// moves, though it moves fast, so it is a member of an island from tick to tick, and not frozen while they
// pass.
TEST(Squeezed, ABallThatATurningWedgeCarriesIsNotFrozen) {
    for (const double gravity : {0.0, 1.0, 9.81})
        for (const double rest_speed : {0.0, 0.01}) {
            Scene scene = empty_scene({0, -gravity});
            scene.rest_speed = rest_speed;
            const shape::Polyline wedge{{{-0.65, 0.35}, {-0.89, 0.19}, {-0.745, 0.063}}, false};
            add_part(scene, {wedge}, {"", 0, 0, 0}).motion = motion::Turn{{-0.42, 0.19}, -3.5, true};
            add_ball(scene, {-0.83, 0.19}, {-1, 0.75}, 0.02);
            EXPECT_LT(deepest_in(scene, 150), 0.002) << gravity << " m/s², " << rest_speed << " m/s";
        }
}

// Ball 4, which lies in an arc, is jammed at 0.75 s, the first instant of a window. Once that took all events
// from ball 3, far away: ball 1 flew into it at 4 m/s. `flipside hunt` found it, and it cannot be shrunk
// much.
TEST(Squeezed, ABallThatIsJammedAtTheStartOfAWindowTakesNoEventsFromOthers) {
    const Scene scene = parse_scene(R"({
        "format": "flipside-scene/1", "name": "jam", "about": "Five balls.", "rest_speed": 0.01, "gravity": [-0.06, -9.78052],
        "bounds": {"min": [-1, -1], "max": [1, 1]},
        "materials": {"soft": {"restitution": 0}, "hard": {"restitution": 0.9}},
        "balls": [
            {"mass": 1, "position": [0.8, -0.02], "radius": 0.0338, "velocity": [2, 0.86]},
            {"mass": 1, "position": [0.4, -0.374], "radius": 0.0755, "velocity": [-0.724, 3.4]},
            {"mass": 30, "position": [0.1974, -0.3], "radius": 0.067, "velocity": [0.93, 2.4]},
            {"mass": 1, "position": [-0.08, 0.5], "radius": 0.04, "velocity": [3.4, -2]},
            {"mass": 0.06, "position": [-0.07938, 0.74], "radius": 0.06, "velocity": [-2, 0.3], "spin": -5}
        ],
        "parts": [
            {"name": "walls", "material": "soft",
             "shape": {"type": "polyline", "closed": true, "points": [[-1, -1], [1, -1], [1, 1], [-1, 1]]}},
            {"name": "bowl", "material": "hard",
             "shape": {"type": "arc", "center": [-0.542, -0.4277], "radius": 0.3477, "from_deg": -90, "to_deg": 200}}
        ]})",
                                    "jam");
    EXPECT_LT(deepest_in(scene, 240), 0.02);
}

}  // namespace
}  // namespace flipside::custom::test
