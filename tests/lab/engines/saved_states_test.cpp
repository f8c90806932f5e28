// A state that a world saves can always be read, whatever happened to the world; and what is restored from it
// saves the same again.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lab/engines/every_solver.hpp"
#include "world/refusal.hpp"
#include "world/scene_file.hpp"
#include "world/state_file.hpp"

namespace flipside {
namespace {

double between(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1'000'001) / 1e6;
}

/// A walled table with one of everything that a state speaks of. Lost balls are kept or not.
Scene table(bool keeps_lost) {
    const std::string lost = keeps_lost ? "keep" : "remove";
    return parse_scene(R"({
        "format": "flipside-scene/1", "name": "table", "bounds": {"min": [-1, -1], "max": [1, 1]},
        "gravity": [0, -9], "damping": 0.1, "lost": ")" +
                           lost + R"(",
        "materials": {"steel": {"restitution": 0.9, "friction": 0.1}, "gainful": {"restitution": 2.5}},
        "parts": [
            {"name": "floor", "material": "steel", "shape": {"type": "segment", "a": [-0.9, -0.9], "b": [0.9, -0.9]}},
            {"name": "wall", "material": "gainful", "shape": {"type": "segment", "a": [-0.9, -0.9], "b": [-0.9, 0.9]}},
            {"name": "bat", "shape": {"type": "flipper", "pivot": [0.5, 0], "length": 0.2,
             "base_radius": 0.02, "tip_radius": 0.01, "rest_deg": -30},
             "motion": {"type": "flip", "side": "left", "raised_deg": 30, "up_rate": 20, "down_rate": 10}},
            {"name": "fan", "shape": {"type": "segment", "a": [0, 0.4], "b": [0, 0.6]},
             "motion": {"type": "turn", "pivot": [0, 0.5], "rate": 3}},
            {"name": "gate", "shape": {"type": "gate", "a": [-0.5, 0], "b": [-0.3, 0], "normal": [0, 1]}},
            {"name": "lane", "sensor": true, "shape": {"type": "circle", "center": [0.3, -0.5], "radius": 0.1}},
            {"name": "drop 1", "target": true, "shape": {"type": "circle", "center": [-0.2, -0.4], "radius": 0.05}},
            {"name": "drop 2", "target": true, "shape": {"type": "circle", "center": [0.1, -0.6], "radius": 0.05}}],
        "launcher": {"position": [0.8, -0.5], "direction_deg": 100, "speed": [1, 3],
                     "ball": {"radius": 0.03, "mass": 0.08, "material": "steel"}}})",
                       "table.json");
}

Scene some_scene() {
    Scene scene = table(*rc::gen::arbitrary<bool>());
    const int balls = *rc::gen::inRange(0, 7);
    for (int i = 0; i < balls; ++i) {
        Ball ball;
        ball.number = static_cast<BallNumber>(i);
        ball.position = {between(-1, 1), between(-1, 1)};
        const double speed = *rc::gen::element(0.0, 1e-9, 3.0, 1e4, 7e8);
        ball.velocity = speed * Vec2{between(-1, 1), between(-1, 1)};
        ball.radius = *rc::gen::element(1e-6, 0.03, 0.1);
        ball.mass = *rc::gen::element(1e-9, 0.08, 1e6);
        ball.spin = *rc::gen::element(0.0, 50.0, -1e6);
        ball.material = *rc::gen::element(0U, 1U, 2U);
        scene.balls.push_back(ball);
    }
    return scene;
}

Control some_control() {
    switch (*rc::gen::inRange(0, 5)) {
        case 0:
            return control::Flip{*rc::gen::element(Side::left, Side::right), *rc::gen::arbitrary<bool>()};
        case 1:
            return control::Launch{between(0, 1), *rc::gen::inRange(1, 5), *rc::gen::element(0.5, 1.0)};
        case 2:
            return control::Nudge{{between(-1, 1) * 1e6, between(-1, 1)}};
        case 3:
            return control::Rotate{*rc::gen::arbitrary<bool>()};
        default:
            return control::RaiseTargets{};
    }
}

void expect_saved_well(World& world, const Scene& scene) {
    const std::string saved = to_json(world.save(), scene);
    world.restore(parse_state(saved, "state.json", scene));
    RC_ASSERT(to_json(world.save(), scene) == saved);
}

RC_GTEST_PROP(SavedState, CanAlwaysBeRead, ()) {
    const auto scene = std::make_shared<const Scene>(some_scene());
    const auto solvers = lab::every_solver();
    const auto& [engine, settings] = solvers[*rc::gen::inRange<std::size_t>(0, solvers.size())];
    const auto world = engine->make(scene, settings);
    State start = world->save();
    start.clock.time = *rc::gen::element(0.0, 0.1, 16'667.0, 1e12 - 0.5);
    start.next_number = *rc::gen::element(start.next_number, 4'294'967'293U);  // so few are left
    world->restore(start);
    const int steps = *rc::gen::inRange(0, 12);
    try {
        for (int step = 0; step < steps; ++step) {
            if (*rc::gen::inRange(0, 2) == 0) world->apply(some_control());
            if (*rc::gen::inRange(0, 4) == 0) expect_saved_well(*world, *scene);
            const double time = world->time();
            world->step(*rc::gen::element(1e-6, 1.0 / 60, 0.013, 0.2));
            RC_ASSERT(world->time() >= time);
        }
    } catch (const Refusal&) {  // the world is then as before that step
    }
    expect_saved_well(*world, *scene);
}

}  // namespace
}  // namespace flipside
