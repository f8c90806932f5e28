#pragma once
/// What the rule of gates (world/gate.hpp) means for an engine that orders events by time, in scenes that are
/// not among the hard cases: turned, shifted, of other sizes, at several steps, saved and restored.

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "world/scene_builder.hpp"
#include "world/state_file.hpp"
#include "world/world.hpp"

namespace flipside::test {

using MakeWorld = std::function<std::unique_ptr<World>(const Scene&)>;
inline constexpr double steps[] = {1.0 / 30, 1.0 / 60, 1.0 / 97, 1.0 / 240, 1.0 / 1000};

inline void run_to(World& world, double end, double dt) {
    while (world.time() < end - 1e-12) world.step(std::min(dt, end - world.time()));
}

/// A ball near either end of a gate, in any direction, of any size, anywhere: until the first meeting it
/// flies as if the gate were a segment; then the rule says whether it goes on as if the gate were a segment,
/// or as if there were none.
inline void expect_the_rule(const MakeWorld& make) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit_range(-1, 1);
    const auto draw = [&](double size) { return size * unit_range(random); };
    int passed = 0, blocked = 0;
    for (int k = 0; k < 200; ++k) {
        const double r = std::pow(10, draw(2) - 1), angle = draw(std::numbers::pi),
                     speed = std::pow(10, draw(1));
        const Vec2 origin{draw(10 * r), draw(10 * r)};
        const auto at = [&](Vec2 p) { return origin + r * rotated(p, angle); };
        const double length_of_gate = 3 + draw(2), side = draw(1);
        const Vec2 normal = rotated({0, side > 0 ? 1.0 : -1.0}, angle);
        const Vec2 aim{k % 2 == 0 ? draw(1) : length_of_gate + draw(1), draw(1)};
        const Vec2 away = 5.0 * from_angle(draw(std::numbers::pi));
        Scene scene = empty_scene();
        scene.bounds = {{-1e4, -1e4}, {1e4, 1e4}};
        scene.rest_speed = 0;
        add_ball(scene, at(aim + away), -speed * r * rotated(unit(away), angle), r);
        const double seconds = 20 / speed;
        Scene solid = scene, gate = scene;
        add_part(solid, segment(at({}), at({length_of_gate, 0})));
        add_part(gate, {shape::Gate{at({}), at({length_of_gate, 0}), normal}});

        const auto as_solid = make(solid), as_free = make(scene);
        as_solid->step(seconds);
        as_free->step(seconds);
        const bool begins_there =
            length(aim + away - Vec2{std::clamp((aim + away).x, 0.0, length_of_gate), 0}) < 1.1;
        if (begins_there || as_solid->statistics().impacts == 0) continue;
        const Event& hit = as_solid->events().front();
        const Vec2 center = hit.point + r * hit.normal;
        const bool passes = dot(center - at({}), normal) < 0;
        (passes ? passed : blocked) += 1;
        const Vec2 expected = (passes ? as_free : as_solid)->balls()[0].position;
        for (const double step : steps) {
            const auto world = make(gate);
            run_to(*world, seconds, 60 * step * seconds / 40);
            EXPECT_LE(length(world->balls()[0].position - expected), 1e-9 * r)
                << "scene " << k << ", " << step;
            EXPECT_FALSE(world->parts()[0].open) << "scene " << k;
        }
    }
    EXPECT_GT(passed, 50);
    EXPECT_GT(blocked, 50);
}

/// A ball lies against the end of a gate, before its line, and slides round the end: pressed against it until
/// its centre is 20 degrees behind the line. It has never been let through.
inline Scene sliding_round(double angle, Vec2 origin, double r, bool gate) {
    const auto at = [&](Vec2 p) { return origin + r * rotated(p, angle); };
    const double tilt = std::numbers::pi / 3, from = 75 * std::numbers::pi / 180;
    Scene scene = empty_scene(98.1 * r * rotated({std::sin(tilt), -std::cos(tilt)}, angle));
    add_ball(scene, at({-std::sin(from), std::cos(from)}), {}, r);
    const Vec2 end = at({8, 0});
    add_part(scene, gate ? Shape{shape::Gate{origin, end, rotated({0, 1}, angle)}} : segment(origin, end),
             {"", 0, 0, 0});
    return scene;
}

inline void expect_to_slide_round_the_end(const MakeWorld& make) {
    constexpr double seconds = 0.4;
    for (const double r : {0.1, 0.0135})
        for (int k = 0; k < 30; ++k) {
            const double angle = 2 * std::numbers::pi * k / 30 + 0.05;
            const Vec2 origin{k % 7 * r, -(k % 5) * r};
            const auto as_solid = make(sliding_round(angle, origin, r, false));
            run_to(*as_solid, seconds, 1.0 / 60);
            const Vec2 expected = as_solid->balls()[0].position;
            ASSERT_LT(dot(expected - origin, rotated({0, 1}, angle)), -0.5 * r);
            for (const double step : steps) {
                const auto world = make(sliding_round(angle, origin, r, true));
                run_to(*world, seconds, step);
                EXPECT_LE(length(world->balls()[0].position - expected), 1e-9 * r)
                    << "angle " << angle << ", step " << step;
            }
        }
}

/// The same, written to a file and read back at every step.
inline void expect_the_decision_to_be_saved(const MakeWorld& make) {
    const Scene scene = sliding_round(0.3, {}, 0.1, true);
    const auto through = make(scene);
    int saved_behind = 0;
    std::string file = to_json(through->save(), scene);
    for (int i = 0; i < 80; ++i) {
        through->step(1.0 / 200);
        const auto again = make(scene);
        again->restore(parse_state(file, "saved", scene));
        again->step(1.0 / 200);
        file = to_json(again->save(), scene);
        EXPECT_LE(length(again->balls()[0].position - through->balls()[0].position), 1e-10) << "step " << i;
        EXPECT_FALSE(again->parts()[0].open) << "step " << i;
        saved_behind +=
            !again->save().blocked.empty() && dot(again->balls()[0].position, rotated({0, 1}, 0.3)) < 0;
    }
    EXPECT_GT(saved_behind, 0);
}

/// One gate, two balls. What arrives at the front bounces off, unless another is in the gate meanwhile.
inline void expect_an_open_gate_to_pass_all(const MakeWorld& make) {
    for (const double dt : steps) {
        Scene scene = empty_scene();
        scene.rest_speed = 0;
        add_part(scene, {shape::Gate{{-1, 0}, {1, 0}, {0, 1}}});
        add_ball(scene, {-0.5, -0.3}, {0, 1});  // in the gate from 0.2 s to 0.4 s
        add_ball(scene, {0.5, 0.2}, {0, -1});   // meets the front at 0.1 s
        add_ball(scene, {0, 0.35}, {0, -1});    // at 0.25 s
        add_ball(scene, {0.95, 0.7}, {0, -1});  // at 0.6 s, when the third is through
        const auto world = make(scene);
        run_to(*world, 1, dt);
        const auto height = [&](std::size_t i) { return world->balls()[i].position.y; };
        EXPECT_NEAR(height(0), 0.7, 1e-12);
        EXPECT_NEAR(height(1), 0.1 + 0.9, 1e-12);
        EXPECT_NEAR(height(2), -0.65, 1e-12);
        EXPECT_NEAR(height(3), 0.1 + 0.4, 1e-12);
        EXPECT_FALSE(world->parts()[0].open);
    }
}

/// What lies on a gate falls through it when another ball opens it.
inline void expect_an_opened_gate_to_let_go(const MakeWorld& make) {
    for (const double dt : steps) {
        Scene scene = empty_scene({0, -1});
        add_part(scene, {shape::Gate{{-1, 0}, {1, 0}, {0, 1}}}, {"", 0, 0, 0});
        add_ball(scene, {0.5, 0.1});
        add_ball(scene, {-0.5, -0.3}, {0, 1.5});
        const auto world = make(scene);
        run_to(*world, 0.1, dt);
        EXPECT_EQ(world->save().blocked.size(), 1U);
        EXPECT_NEAR(world->balls()[0].position.y, 0.1, 1e-12);
        run_to(*world, 0.5, dt);
        // The second is a radius away when 1.5·t − t²/2 = 0.2.
        const double fallen = 0.5 - (1.5 - std::sqrt(2.25 - 0.4));
        EXPECT_NEAR(world->balls()[0].position.y, 0.1 - fallen * fallen / 2, 1e-9);
    }
}

/// A ball that is lost in a gate has left it, also where it was the last one.
inline void expect_a_lost_ball_to_leave(const MakeWorld& make) {
    for (const double dt : steps) {
        Scene scene = empty_scene();
        scene.bounds = {{-2, -2}, {2, 0.05}};
        add_part(scene, {shape::Gate{{-1, 0}, {1, 0}, {0, 1}}});
        add_ball(scene, {0, -0.3}, {0, 1});  // at the gate from 0.2 s to 0.4 s, out of bounds at 0.35 s
        const auto world = make(scene);
        run_to(*world, 0.3, dt);
        EXPECT_TRUE(world->parts()[0].open);
        run_to(*world, 0.36, dt);
        EXPECT_TRUE(world->balls().empty());
        EXPECT_FALSE(world->parts()[0].open);
    }
}

/// Balls that begin within a radius meet the gate there and then.
inline void expect_a_start_in_a_gate_to_be_decided(const MakeWorld& make) {
    struct Start {
        Vec2 position, velocity;
        bool passes;
    };
    const Start starts[] = {{{0, -0.07}, {0, 1}, true},     {{0, -0.07}, {1, 0}, true},
                            {{0, 0.07}, {0, -1}, false},    {{0, 0}, {0, 1}, true},
                            {{0, 0}, {0, -1}, true},        {{0, 0}, {1, 0}, true},
                            {{-1.07, -0.02}, {1, 0}, true}, {{-1.07, 0.02}, {1, 0}, false},
                            {{-1.07, 0}, {1, 0}, false},    {{-1.07, 0}, {1, 0.5}, true}};
    for (const Start& start : starts)
        for (int k = 0; k < 60; ++k) {
            const double angle = 2 * std::numbers::pi * k / 60;
            const auto at = [&](Vec2 p) { return rotated(p, angle) + Vec2{0.3, 0.1}; };
            Scene scene = empty_scene();
            scene.rest_speed = 0;
            add_part(scene, {shape::Gate{at({-1, 0}), at({1, 0}), rotated({0, 1}, angle)}});
            add_ball(scene, at(start.position), rotated(start.velocity, angle));
            const auto world = make(scene);
            world->step(1e-3);
            EXPECT_EQ(world->parts()[0].open, start.passes)
                << start.position.x << ", " << start.position.y << " angle " << angle;
        }
}

}  // namespace flipside::test
