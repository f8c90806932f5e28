// The continuous solver works in windows of its own; steps only decide when it is read.

#include <cmath>

#include <gtest/gtest.h>

#include "custom/scenes.hpp"
#include "rapidcheck/gtest.h"
#include "world/state_file.hpp"

namespace flipside::custom::test {
namespace {

/// Balls that bounce, roll, fall asleep and are lost among parts of every kind, without islands.
Scene table_of(int balls, double turn) {
    Scene scene = empty_scene({0, -9.81});
    scene.bounds = {{-2, -2}, {2, 2}};
    scene.damping = 0.05;
    for (int i = 0; i < balls; ++i)
        add_ball(scene, {-1.5 + 0.35 * i, 0.9 + 0.02 * i}, from_angle(turn + i), 0.05, 1 + i % 3);
    add_part(scene, {shape::Polyline{{{-1.8, 1.8}, {-1.8, -0.8}, {-0.4, -1.5}}}}, {"", 0.8, 0.3, 0});
    add_part(scene, {shape::Polyline{{{0.4, -1.5}, {1.8, -0.9}, {1.8, 1.8}}}}, {"", 0.7, 0, 0});
    add_part(scene, {shape::Circle{{0, -0.5}, 0.2}}, {"", 0.9, 0, 2});
    add_part(scene, {shape::Arc{{1, 0.2}, 0.4, 3.5, 5.5}}, {"", 0.6, 0.1, 0});
    add_part(scene, {shape::Gate{{-1.8, 0.4}, {-1, 0.4}, {0, -1}}});
    add_part(scene, segment({0.5, -0.9}, {1.5, -0.8})).sensor = true;
    add_part(scene, segment({-1, -0.9}, {-0.5, -0.9})).target = true;
    add_part(scene, segment({0.2, 0}, {0.8, 0})).motion = motion::Turn{{0.5, 0}, 3, true};
    add_part(scene, {shape::Flipper{{-0.4, -1.6}, 0.3, 0.06, 0.04, -0.4}}).motion =
        motion::Flip{Side::left, 0.5, 20, 10};
    return scene;
}

std::unique_ptr<World> windows_of(const Scene& scene) {
    return make_world(scene, {{"solver", "continuous"}});
}

/// Result of a run to `end`: the states at whole tenths of a second, and all impacts.
struct Course {
    std::vector<std::vector<Ball>> balls;
    std::vector<Event> impacts;
};

/// Runs with steps of next_step(), cut at tenths of a second, when controls are applied.
Course course_of(const Scene& scene, double end, auto&& next_step) {
    const auto world = windows_of(scene);
    Course course;
    for (int tenth = 1; tenth <= std::lround(10 * end); ++tenth) {
        if (tenth % 7 == 3) world->apply(control::Flip{Side::left, tenth % 2 == 1});
        while (world->time() < tenth / 10.0) {
            const Clock clock = world->save().clock;
            const double left = tenth / 10.0 - clock.time - clock.remainder, step = next_step();
            world->step(step < left ? step : left);
            for (const Event& event : world->events())
                if (event.kind == EventKind::impact) course.impacts.push_back(event);
        }
        EXPECT_EQ(world->time(), tenth / 10.0);
        course.balls.emplace_back(world->balls().begin(), world->balls().end());
    }
    return course;
}

void expect_same(const Course& course, const Course& expected) {
    EXPECT_EQ(course.balls, expected.balls);
    ASSERT_EQ(course.impacts.size(), expected.impacts.size());
    for (std::size_t i = 0; i < course.impacts.size(); ++i) {
        EXPECT_EQ(course.impacts[i].time, expected.impacts[i].time) << i;
        EXPECT_EQ(course.impacts[i].ball, expected.impacts[i].ball) << i;
        EXPECT_EQ(course.impacts[i].impulse, expected.impacts[i].impulse) << i;
    }
}

TEST(Windows, TheStepChangesNoBit) {
    for (int scenes = 0; scenes < 12; ++scenes) {
        const Scene scene = table_of(1 + scenes % 4, 0.7 * scenes);
        const Course expected = course_of(scene, 3, [] { return 1.0 / 60; });
        EXPECT_GT(expected.impacts.size(), 5U);
        for (const double step : {1.0 / 30, 1.0 / 97, 1.0 / 240, 1.0 / 1000, 0.1})
            expect_same(course_of(scene, 3, [&] { return step; }), expected);
        double irregular = 0.001;
        const auto next = [&] { return irregular = 0.001 + std::fmod(irregular * 17.3, 0.05); };
        expect_same(course_of(scene, 3, next), expected);
    }
}

TEST(Windows, AStateSavedAnywhereContinuesWithTheSameBits) {
    const Scene scene = table_of(4, 0.3);
    const auto through = windows_of(scene);
    for (int step = 0; step < 400; ++step) {
        if (step % 50 == 20) through->apply(control::Flip{Side::left, step % 100 == 20});
        const State saved = through->save();
        const auto restored = windows_of(scene);
        restored->restore(parse_state(to_json(saved, scene), "state.json", scene));
        EXPECT_EQ(to_json(restored->save(), scene), to_json(saved, scene)) << step;
        const double dt = 0.003 + 0.001 * (step % 9);
        through->step(dt);
        restored->step(dt);
        ASSERT_EQ(to_json(restored->save(), scene), to_json(through->save(), scene)) << step;
        ASSERT_EQ(restored->events().size(), through->events().size()) << step;
    }
}

/// A state in the middle of a window.
State in_a_window(const Scene& scene) {
    const auto world = windows_of(scene);
    world->step(0.26);
    world->step(0.011);
    return world->save();
}

TEST(Windows, AnOriginThatDoesNotLeadToTheStateIsIgnored) {
    const Scene scene = table_of(3, 1.1);
    State state = in_a_window(scene);
    ASSERT_TRUE(state.origin);
    const auto goes_on_from = [&](const State& changed) {
        const auto world = windows_of(scene);
        world->restore(changed);
        EXPECT_TRUE(std::ranges::equal(world->balls(), changed.balls));
        EXPECT_EQ(world->save().origin, nullptr);
    };
    State moved = state;
    moved.balls[0].position.x += 0.01;
    goes_on_from(moved);

    State other_origin = state;
    State origin = *state.origin;
    origin.balls[0].velocity.x += 1e-9;
    other_origin.origin = std::make_shared<const State>(origin);
    goes_on_from(other_origin);

    State long_ago = state;
    origin = *state.origin;
    origin.clock = {};
    long_ago.origin = std::make_shared<const State>(origin);
    goes_on_from(long_ago);

    State with_less = state;
    origin = *state.origin;
    origin.balls.pop_back();
    with_less.origin = std::make_shared<const State>(origin);
    goes_on_from(with_less);
}

TEST(Windows, EnginesWithoutThemSaveNoOrigin) {
    const Scene scene = table_of(3, 1.1);
    const auto world = make_world(scene, {{"solver", "simple"}});
    world->restore(in_a_window(scene));
    EXPECT_EQ(world->save().origin, nullptr);
    world->step(0.01);
    EXPECT_EQ(world->save().origin, nullptr);
}

}  // namespace
}  // namespace flipside::custom::test
