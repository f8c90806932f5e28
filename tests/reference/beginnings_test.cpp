// Where a ball begins: what the exact engine does with one that overlaps a part at the start, after a launch,
// when it is added, and when a target is raised round it.

#include <numbers>

#include <gtest/gtest.h>

#include "reference/support.hpp"
#include "world/refusal.hpp"

namespace flipside::reference::test {
namespace {

/// Why it refuses what `act` does; empty where it does not.
std::string why_refused(auto&& act) {
    try {
        act();
    } catch (const Refusal& refusal) {
        return refusal.what();
    }
    return {};
}

/// A drop target whose top is the x axis, which the second ball hits at once. The first then sinks into it at
/// a speed of 1.
Scene target_scene() {
    Scene scene = empty_scene();
    add_part(scene, {shape::Polygon{{{-1, 0}, {-1, -1}, {1, -1}, {1, 0}}}}).target = true;
    add_ball(scene, {0.5, 0.2}, {0, -1});
    add_ball(scene, {-0.5, 0.1}, {0, -1});
    return scene;
}

std::unique_ptr<World> raised_after(double seconds) {
    auto world = make_world(target_scene());
    world->step(seconds);
    EXPECT_TRUE(world->parts()[0].down);
    world->apply(control::RaiseTargets{});
    return world;
}

TEST(ReferenceBeginnings, ABallIsMovedOutOfATargetThatIsRaised) {
    const auto world = raised_after(0.15);  // its centre is above the top
    world->step(0.1);
    EXPECT_NEAR(world->balls()[0].position.y, 0.1 + 0.1, 1e-12);
}

TEST(ReferenceBeginnings, ATargetThatIsRaisedRoundABallIsRefused) {
    for (const double seconds : {0.22, 0.25, 0.7}) {
        const auto world = raised_after(seconds);
        EXPECT_EQ(why_refused([&] { world->step(0.1); }),
                  "reference: ball 0 begins inside part 0 at " + std::to_string(seconds) + " s");
    }
}

/// A ball of this radius that begins 0.03 above a floor, and falls at a speed of 1.
Ball overlapping(double radius) {
    Scene scene = empty_scene();
    return add_ball(scene, {0, 0.03}, {0, -1}, radius);
}
Scene floor_scene() {
    Scene scene = empty_scene({0, -1});
    add_part(scene, segment({-1, 0}, {1, 0}));
    return scene;
}

TEST(ReferenceBeginnings, ABallIsMovedOutOfAPartAlsoWhenItIsAddedOrLaunched) {
    for (const double radius : {0.05, 0.1}) {  // the cells are for balls of the launcher, or larger
        const auto height = [&](const Scene& scene, auto&& begin) {
            const auto world = make_world(scene);
            world->step(0.25);
            begin(*world);
            world->step(0.5);
            EXPECT_EQ(world->statistics().impacts, 1U);
            return world->balls()[0].position.y;
        };
        const double expected = radius + 1 * 0.5 - 0.5 * 0.5 / 2;
        EXPECT_NEAR(height(floor_scene(), [&](World& world) { world.add(overlapping(radius)); }), expected,
                    1e-12);
        Scene scene = floor_scene();
        scene.launcher = {{0, 0.03}, {0, -1}, 1, 1, false, overlapping(radius)};
        EXPECT_NEAR(height(scene, [](World& world) { world.apply(control::Launch{}); }), expected, 1e-12);
    }
}

TEST(ReferenceBeginnings, ALaunchIntoAPartIsRefusedAtItsTime) {
    Scene scene = empty_scene();
    add_part(scene, {shape::Polygon{{{-1, 0}, {-1, -1}, {1, -1}, {1, 0}}}});
    scene.launcher = {{0, -0.03}, {0, -1}, 1, 1, false, overlapping(0.1)};
    const auto world = make_world(scene);
    world->step(0.25);
    world->step(1);  // the origin of times is reset
    world->apply(control::Launch{});
    EXPECT_EQ(why_refused([&] { world->step(0.5); }), "reference: ball 0 begins inside part 0 at 1.250000 s");
}

/// A ball of radius 0.1 between two lines through points 0.08 left and right of it.
Scene slot_scene(double degrees_from_upright) {
    const double lean = degrees_from_upright * std::numbers::pi / 180;
    Scene scene = empty_scene();
    for (const double side : {-1.0, 1.0}) {
        const Vec2 at{side * 0.08, 0}, along{side * std::sin(lean), std::cos(lean)};
        add_part(scene, segment(at - 0.2 * along, at + 2 * along));
    }
    add_ball(scene, {0, 0}, {}, 0.1);
    return scene;
}

TEST(ReferenceBeginnings, ABallIsMovedOutOfANarrowWedge) {
    const double lean = 10;
    const auto world = make_world(slot_scene(lean));
    world->step(0.1);
    const Vec2 at = world->balls()[0].position;
    const double cosine = std::cos(lean * std::numbers::pi / 180);
    for (const double side : {-1.0, 1.0}) {
        const double from_line = (0.08 - side * at.x) * cosine + at.y * std::sqrt(1 - cosine * cosine);
        EXPECT_GE(from_line, 0.1 * (1 - 1e-3)) << side;
        EXPECT_LE(from_line, 0.1 * (1 + 1e-2)) << side;
    }
}

TEST(ReferenceBeginnings, ABallForWhichPartsLeaveNoRoomIsRefused) {
    EXPECT_EQ(why_refused([] { make_world(slot_scene(0))->step(0.1); }),
              "reference: ball 0 begins where parts leave no room for it at 0.000000 s");
}

/// A closed gate along the x axis that lets through what comes from below.
Scene gate_scene(double speed) {
    Scene scene = empty_scene({0, -1});
    add_part(scene, {shape::Gate{{-1, 0}, {1, 0}, {0, 1}}}, {"", 0.5, 0, 0});
    add_ball(scene, {0, 0.06}, {0, speed});
    return scene;
}

TEST(ReferenceBeginnings, ABallIsMovedOutOfAGateThatBlocksIt) {
    const double t = 0.25, fallen = t * t / 2;
    for (const auto& [speed, after] : {std::pair{-1.0, 0.5}, {1.0, 1.0}, {0.0, 0.0}}) {
        Scene scene = gate_scene(speed);
        const double expected = 0.1 + (speed == 0 ? 0 : after * t - fallen);
        const auto world = make_world(scene);
        world->step(t);
        EXPECT_NEAR(world->balls()[0].position.y, expected, 1e-12) << "speed " << speed;
        scene.balls.clear();
        const auto later = make_world(scene);
        later->step(0.5);
        later->add(gate_scene(speed).balls[0]);
        later->step(t);
        EXPECT_NEAR(later->balls()[0].position.y, expected, 1e-12) << "speed " << speed;
    }
}

/// It begins inside a disc, and out of that it is before the gate, or behind.
TEST(ReferenceBeginnings, ABallThatIsMovedToAGateMeetsItThere) {
    for (const int side : {1, -1}) {
        Scene scene = gate_scene(0);
        add_part(scene, {shape::Circle{{0.1, side * 0.25}, 0.1}});
        scene.balls[0].position = {0.02, side * 0.13};  // apart from the gate; the way out leads to it
        scene.balls[0].velocity = {-1, 0};
        scene.gravity = {};
        const auto world = make_world(scene);
        world->step(0.01);
        EXPECT_EQ(world->parts()[0].open, side < 0);
    }
}

}  // namespace
}  // namespace flipside::reference::test
