#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "custom/between.hpp"
#include "custom/scenes.hpp"
#include "custom/tolerances.hpp"
#include "rapidcheck/gtest.h"

namespace flipside::custom::test {
namespace {

/// Balls in a clump, each some touch distances away from one before it, that fly apart, past each other and
/// against a wall.
Scene clump() {
    Scene scene = empty_scene({0, *rc::gen::element(0.0, -9.81)});
    scene.damping = *rc::gen::element(0.0, 0.3, 40.0);
    add_part(scene, segment({-9, 0}, {9, 0}));
    const auto wanted = *rc::gen::inRange(2, 9);
    for (int i = 0; i < wanted; ++i) {
        Ball ball;
        ball.radius = between(0.02, 0.1);
        ball.mass = 1;
        ball.number = static_cast<BallNumber>(scene.balls.size());
        ball.velocity = between(0, 0.5) * from_angle(between(0, 2 * std::numbers::pi));
        const double gap = between(0.1, 8) * touch_distance * ball.radius;
        ball.position = {0, ball.radius + gap};
        if (!scene.balls.empty()) {
            const Ball& beside = *rc::gen::elementOf(scene.balls);
            ball.position = beside.position + (beside.radius + ball.radius + gap) *
                                                  from_angle(between(0, 2 * std::numbers::pi));
        }
        const auto overlaps = [&](const Ball& other) {
            return length(other.position - ball.position) < other.radius + ball.radius;
        };
        if (ball.position.y > ball.radius && std::ranges::none_of(scene.balls, overlaps))
            scene.balls.push_back(ball);
    }
    return scene;
}

bool same(const Contact& a, const Contact& b) {
    return a.ball == b.ball && a.other == b.other && a.separation == b.separation;
}

/// Two balls that sleep on a floor, and a small one that falls on the right one.
Scene hit_pair() {
    Scene scene = empty_scene({0, -9.81});
    scene.rest_speed = 0.01;
    scene.materials.front().restitution = 0.9;
    add_part(scene, segment({-20, 0}, {20, 0}));
    add_ball(scene, {0, 0.1}, {}, 0.1);
    add_ball(scene, {0.2, 0.1}, {}, 0.1);
    add_ball(scene, {0.15, 2.29}, {}, 0.03);
    return scene;
}

// The left ball wakes at the end of a window, beside the one that was hit in it.
TEST(Contacts, OfABallThatWakesAreKept) {
    const auto world = make_world(hit_pair());
    bool slept = false, woke = false;
    for (int step = 0; step < 60; ++step) {
        world->step(1.0 / 60);
        const bool asleep = world->balls()[0].asleep;
        woke = woke || (slept && !asleep);
        slept = asleep;
        for (const Event& event : world->events())
            if (step > 0 && event.ball == 0 && !event.other.is_ball)
                ADD_FAILURE() << "event " << static_cast<int>(event.kind) << " at " << event.time;
        EXPECT_TRUE(std::ranges::any_of(world->contacts(), [](const Contact& contact) {
            return contact.ball == 0 && !contact.other.is_ball;
        })) << step;
    }
    EXPECT_TRUE(woke);
}

// The normal of an event points to its ball, also where that one sleeps on as the other bounces off it.
TEST(Contacts, NormalsPointToTheBallThatSleepsToo) {
    Scene scene = empty_scene({0, -9.81});
    scene.rest_speed = 0.01;
    add_part(scene, segment({-20, 0}, {20, 0}), {"", 0, 0, 0});
    add_ball(scene, {0, 0.1}, {}, 0.1);
    add_ball(scene, {0.21, 0.1}, {-0.1, 0}, 0.1);
    scene.balls[0].asleep = true;
    const auto world = make_world(scene, {{"sleep_speed", "0.2"}});
    int impacts = 0;
    for (int step = 0; step < 90 && impacts == 0; ++step) {
        world->step(1.0 / 60);
        for (const Event& event : world->events())
            if (event.other.is_ball && event.kind == EventKind::impact) {
                ++impacts;
                EXPECT_EQ(event.ball, 0U);
                EXPECT_NEAR(event.normal.x, -1, 1e-12);
                EXPECT_NEAR(event.point.x, 0.1, 1e-9);
            }
    }
    EXPECT_EQ(impacts, 1);
}

// The solver looks for contacts only at balls whose paths come near others then.
RC_GTEST_PROP(Contacts, AreThoseOfASearchOfAllBalls, ()) {
    Scene scene = clump();
    const auto world = make_world(scene);
    for (int i = 0; i < 40; ++i) {
        world->step(between(1e-6, 4e-5));
        scene.balls.assign(world->balls().begin(), world->balls().end());
        const auto fresh = make_world(scene, {{"broad_phase", "brute"}});
        RC_ASSERT(std::ranges::equal(world->contacts(), fresh->contacts(), same));
    }
}

// Its impacts on both walls have no end, so it is frozen from tick to tick, and nothing is predicted of it.
TEST(Contacts, OfABallThatIsJammedInAWedgeAreFound) {
    Scene scene = empty_scene();
    scene.rest_speed = 0;
    const Material dead{"", 0, 0.6, 0};
    add_part(scene, segment({0, 0}, {1, 0.2}), dead);
    add_part(scene, segment({0, 0}, {1, -0.3}), dead);
    add_ball(scene, {0.5, 0}, {-1, 0.5}, 0.05);
    const auto world = make_world(scene, {{"sleep", "off"}});
    for (int step = 0; step < 30; ++step) world->step(1.0 / 60);  // it has come to rest
    for (int step = 0; step < 30; ++step) {
        world->step(1.0 / 60);
        EXPECT_EQ(world->contacts().size(), 2U) << step;
    }
}

}  // namespace
}  // namespace flipside::custom::test
