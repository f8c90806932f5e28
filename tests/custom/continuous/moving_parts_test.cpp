// Moving parts and gates in the continuous solver, in many placements. Cases with known answers are tested in
// lab/cases.

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "custom/scenes.hpp"
#include "in_small.hpp"

namespace flipside::custom::test {
namespace {

using std::numbers::pi;

std::unique_ptr<World> without_sleep(const Scene& scene) {
    return make_world(scene, {{"solver", "continuous"}, {"sleep", "off"}});
}

Part& add_flipper(Scene& scene, double e, double rate, double raised = pi / 3) {
    Part& part = add_part(scene, {shape::Flipper{{0, 0}, 1, 0.15, 0.1, 0}}, {"", e, 0, 0});
    part.motion = motion::Flip{Side::left, raised, rate, rate};
    return part;
}

TEST(MovingParts, GatePassesOneWay) {
    for (const bool along : {true, false}) {
        for (const double speed : {1.0, 500.0}) {
            Scene scene = empty_scene();
            scene.rest_speed = 0;
            add_part(scene, {shape::Gate{{0, -1}, {0, 1}, {along ? 1.0 : -1.0, 0}}});
            add_ball(scene, {-0.5, 0}, {speed, 0});
            const auto world = without_sleep(scene);
            bool was_open = false;
            while (world->time() < 1 / speed) {
                world->step(0.05 / speed);
                was_open = was_open || world->parts()[0].open;
            }
            EXPECT_EQ(was_open, along);
            EXPECT_FALSE(world->parts()[0].open);
            EXPECT_NEAR(world->balls()[0].velocity.x, along ? speed : -speed, 1e-12 * speed);
        }
    }
}

// An arm pushes a ball, which slides out along it. Its bounces get lower until they are lost in rounding;
// then it rests on the arm. They used to go on, up to a million a second.
TEST(MovingParts, BouncesOnATurningArmEnd) {
    for (const double e : {0.25, 0.7})
        for (const double friction : {0.0, 0.3}) {
            Scene scene = empty_scene();
            scene.rest_speed = 0;
            add_part(scene, segment({0, 0}, {5, 0}), {"", e, friction, 0}).motion =
                motion::Turn{{0, 0}, 3.8, true};
            scene.materials[0].friction = 1;
            add_ball(scene, {0.2, 0.031}, {0.5, 0}, 0.03);
            const auto world = without_sleep(scene);
            std::uint64_t impacts = 0;
            for (int step = 0; step < 48; ++step)
                world->step(1.0 / 60), impacts += world->statistics().impacts;
            EXPECT_LT(impacts, 100U) << e << ", " << friction;
            EXPECT_GT(length(world->balls()[0].position), 1);
        }
}

// A ball between a wall and one of 1e8 times its mass has 31,415 impacts (Galperin 2003, "Playing pool with
// π"). No limit on their pace holds where no moving part drives the ball.
TEST(MovingParts, FarAwayCutOffNoCollisions) {
    Scene scene = empty_scene();
    scene.rest_speed = 0;
    add_part(scene, segment({0, -1}, {0, 1}), {"", 1, 0, 0});
    add_part(scene, segment({4, 3}, {4, 4})).motion = motion::Turn{{4, 3}, 5, true};
    add_ball(scene, {2, 0}, {0, 0}, 0.1, 1);
    add_ball(scene, {3, 0}, {-1, 0}, 0.1, 1e8);
    const auto world = without_sleep(scene);
    std::uint64_t impacts = 0;
    for (int step = 0; step < 1800; ++step) world->step(1.0 / 60), impacts += world->statistics().impacts;
    EXPECT_EQ(impacts, 31'415U);
}

// A turning segment, 20 r long, 5…60 rad/s, against balls of 0…400 m/s: a ball never changes sides except
// around an end. Checked in short steps in the frame of the segment.
TEST(MovingParts, NothingPassesATurningSegment) {
    int hits = 0;
    for (int i = 0; i < 700; ++i) {
        const double rate = 5 + 55.0 * (i % 7) / 6, speed = 400.0 * (i % 100) / 99, around = 0.61 * i;
        Scene scene = empty_scene();
        scene.rest_speed = 0;
        add_part(scene, segment({-1, 0}, {1, 0})).motion = motion::Turn{{0, 0}, rate, true};
        const Vec2 start = 1.5 * from_angle(around), aim = 0.8 * std::sin(1.7 * i) * from_angle(2.1 * i);
        add_ball(scene, start, speed * unit(aim - start));
        const auto world = without_sleep(scene);
        double before = 0;
        const double dt = 0.2 / (60 + 40 * std::max(rate, speed / 4));
        for (int k = 0; k < 300 && !world->balls().empty(); ++k) {
            world->step(dt);
            hits += static_cast<int>(world->statistics().impacts);
            const Vec2 p = rotated(world->balls()[0].position, -rate * world->time());
            EXPECT_GE(std::abs(p.x) <= 1 ? std::abs(p.y) : 1, 0.1 - 1e-9) << "placement " << i;
            if (std::abs(p.x) < 1 && before != 0) {
                ASSERT_GT(before * p.y, 0) << "placement " << i;
            }
            before = std::abs(p.x) < 1 ? p.y : 0;
        }
    }
    std::printf("turning segment: %d hits\n", hits);
    EXPECT_GT(hits, 400);
}

// A flipper is raised at every phase of an incoming ball, with one step per frame.
TEST(MovingParts, NothingPassesARaisedFlipper) {
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        Scene scene = empty_scene({0, -9.81});
        add_flipper(scene, 0.7, 40, pi / 3);
        const double x = 0.1 + 0.35 * (i % 37) / 36, speed = 1 + 60.0 * (i % 11) / 10;
        const double height = 0.3 + speed / 60 * 4 * (i / 1000.0);
        add_ball(scene, {x, height}, {0, -speed});
        const auto world = without_sleep(scene);
        bool hit = false;
        for (int k = 0; k < 30 && !hit; ++k) {
            if (k == 1) world->apply(control::Flip{Side::left, true});
            world->step(1.0 / 60);
            hit = world->statistics().impacts > 0;
            const Ball& ball = world->balls()[0];
            const Vec2 p = rotated(ball.position, -world->parts()[0].angle);
            if (ball.position.x > 0 && p.x > 0 && p.x < 0.9) {
                ASSERT_GT(p.y, 0.19) << "placement " << i;
            }
        }
        hits += hit;
    }
    std::printf("flipper: %d of 1000 hit\n", hits);
    EXPECT_EQ(hits, 1000);
}

// Without gravity, a ball lands on a flipper that has come to its stop in the same window, and slides over
// its tip: it goes on straight.
TEST(MovingParts, AFlipperAtItsStopHasASmoothTip) {
    for (int k = 0; k < 100; ++k) {
        const double raised = 0.3 + 0.01 * k;
        Scene scene = empty_scene();
        add_flipper(scene, 0, 20, raised);
        // Unit vectors along the upper face and off it, which carries the ball from 0.1 s on.
        const double angle = raised - std::asin(0.05);
        const Vec2 along = from_angle(angle), off = perp(along);
        add_ball(scene, 0.35 * off + 0.3 * along, 3 * along - off);
        const auto world = without_sleep(scene);
        world->apply(control::Flip{Side::left, true});
        run(*world, 0.15, 0.05);
        const Ball before = world->balls()[0];
        ASSERT_NEAR(dot(before.position, off), 0.25, 1e-12) << "raised by " << raised;
        run(*world, 0.25, 0.05);
        EXPECT_LT(length(world->balls()[0].velocity - before.velocity), 1e-12) << "raised by " << raised;
    }
}

/// A closed room of 2 m, of lines or of thick walls.
void add_room(Scene& scene, bool thick) {
    if (!thick) {
        add_part(scene, {shape::Polyline{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, true}});
        return;
    }
    for (int side = 0; side < 4; ++side) {
        shape::Polygon wall{{{-1.2, -1.2}, {1.2, -1.2}, {1.2, -1}, {-1.2, -1}}};
        for (Vec2& point : wall.points)
            for (int turn = 0; turn < side; ++turn) point = perp(point);
        add_part(scene, {wall});
    }
}

// A bar that turns near a corner leaves no room for the ball, or holds it down on the floor.
TEST(MovingParts, PressABallAgainstWallsButNotThroughThem) {
    std::vector<unsigned> seeds{62, 149, 982, 1373, 1930, 2269, 2777};  // once wrong
    for (unsigned seed = 0; seed < (flipside::test::in_small ? 1 : 10); ++seed) seeds.push_back(seed);
    for (const bool thick : {false, true})
        for (const unsigned seed : seeds) {
            std::mt19937 random(seed);
            const auto real = [&](double low, double high) {
                return low + (high - low) * static_cast<double>(random() >> 8) * 0x1p-24;
            };
            Scene scene = empty_scene({0, -9.81});
            add_room(scene, thick);
            const double x = real(-0.95, -0.6), y = real(-0.95, -0.6);
            const double half = real(0.1, 0.4), bar_radius = real(0.02, 0.1);
            const Vec2 pivot{x, y}, to_end = half * from_angle(real(0, pi));
            const double rate = (real(0, 1) < 0.5 ? -1 : 1) * real(1, 30);
            const double restitution = real(0, 1), friction = real(0, 0.5);
            add_part(scene, {shape::Capsule{pivot - to_end, pivot + to_end, bar_radius}},
                     {"", restitution, friction, 0})
                .motion = motion::Turn{pivot, rate, true};
            const double radius = real(0.03, 0.1), left = real(-0.9, 0.3), low = real(-0.9, 0.3);
            const double along = real(-3, 0), down = real(-3, 0);
            add_ball(scene, {left, low}, {along, down}, radius);
            const auto world = without_sleep(scene);
            for (int k = 0; k < 240; ++k) {
                world->step(1.0 / 60);
                const Vec2 at = world->balls()[0].position;
                ASSERT_LE(std::max(std::abs(at.x), std::abs(at.y)), 1)
                    << (thick ? "thick" : "thin") << " walls, seed " << seed << ", " << world->time() << " s";
            }
        }
}

// Balls whose impacts have no end are held in place for a moment; the flipper and the others must not get
// into them meanwhile. They used to, by up to 1.9 radii.
TEST(MovingParts, AFlipperThatRisesUnderAHeapDrivesNoBallIntoAnother) {
    for (unsigned seed = 0; seed < (flipside::test::in_small ? 1 : 4); ++seed) {
        std::mt19937 random(seed);
        Scene scene = empty_scene({0, -9.81});
        scene.rest_speed = 0.05;
        scene.materials[0] = {"ball", seed % 2 == 0 ? 0.0 : 0.5, seed < 2 ? 0.0 : 0.3, 0};
        add_part(scene, {shape::Polyline{{{-0.5, 0}, {0.5, 0}, {0.5, 4}, {-0.5, 4}}, true}}, {"", 0, 0.3, 0});
        add_part(scene, {shape::Flipper{{-0.25, 0.2}, 0.35, 0.04, 0.02, -0.26}}, {"", 0, 0.3, 0}).motion =
            motion::Flip{Side::left, 0.7, 20, 10};
        for (int k = 0; k < 210; ++k) {
            const double aside = 0.6 * (static_cast<double>(random() >> 8) * 0x1p-24 - 0.5);
            add_ball(scene, {-0.46 + 0.045 * (k % 21), 0.4 + 0.045 * (k / 21)}, {aside, 0}, 0.02);
        }
        const auto world = make_world(scene);
        run(*world, 2);
        world->apply(control::Flip{Side::left, true});
        double deepest = 0;
        for (int step = 0; step < 48; ++step) {
            world->step(1.0 / 240);
            for (const Contact& contact : world->contacts())
                deepest = std::max(deepest, -contact.separation / 0.02);
        }
        EXPECT_LE(deepest, 0.05) << seed;
    }
}

}  // namespace
}  // namespace flipside::custom::test
