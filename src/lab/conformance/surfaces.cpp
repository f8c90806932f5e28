/// What balls meet: every kind of primitive, and what surfaces do.

#include <algorithm>
#include <cmath>

#include "flipside/engine.h"
#include "lab/conformance/check.hpp"
#include "world/trace.hpp"

namespace flipside::lab {

namespace {

constexpr double small_step = 1.0 / 240;  ///< s
constexpr double ball_radius = 0.1;       ///< m

/// A ball that falls on a shape whose highest point is the origin, without a bounce.
Finding carries(const Subject& subject, const std::string& shape) {
    const auto world = subject.world(
        R"("gravity": [0, -9.81], "materials": {"dead": {"restitution": 0}},
           "balls": [{"position": [0, 0.5], "radius": 0.1, "mass": 1}],
           "parts": [{"name": "shape", "material": "dead", "shape": )" +
        shape + "}]");
    double lowest = 1;
    run_for(*world, 0.8, small_step, [&] {
        lowest =
            world->balls().empty() ? -10 : std::min(lowest, world->balls().front().position.y - ball_radius);
    });
    return graded(-lowest, 0.02 * ball_radius, 0.5 * ball_radius,
                  "A ball that falls on it sinks in by " + brief(1e3 * std::max(0.0, -lowest)) +
                      " mm at most; the bound is half its radius, 50 mm.");
}

Finding carried_by_point(const Subject& subject) {
    return carries(subject, R"({"type": "point", "at": [0, 0]})");
}
Finding carried_by_segment(const Subject& subject) {
    return carries(subject, R"({"type": "segment", "a": [-3, 0], "b": [3, 0]})");
}
Finding carried_by_arc(const Subject& subject) {
    return carries(subject,
                   R"({"type": "arc", "center": [0, 5], "radius": 5, "from_deg": 200, "to_deg": 340})");
}
Finding carried_by_circle(const Subject& subject) {
    return carries(subject, R"({"type": "circle", "center": [0, -1], "radius": 1})");
}
Finding carried_by_polygon(const Subject& subject) {
    return carries(subject, R"({"type": "polygon", "points": [[-2, -1], [2, -1], [2, 0], [-2, 0]]})");
}
Finding carried_by_capsule(const Subject& subject) {
    return carries(subject, R"({"type": "capsule", "a": [-1, -0.5], "b": [1, -0.5], "radius": 0.5})");
}

Finding friction_rolls(const Subject& subject) {
    const auto world = subject.world(
        R"("gravity": [0, -9.81], "materials": {"rough": {"restitution": 0, "friction": 0.5}},
           "balls": [{"position": [-5, 0.1], "velocity": [3, 0], "radius": 0.1, "mass": 1, "material": "rough"}],
           "parts": [)" +
        subject.floor(R"("material": "rough", )") + "]");
    run_for(*world, 1, small_step, [] {});
    const Ball& ball = world->balls().front();
    const double error = std::max(std::abs(ball.velocity.x - 2), std::abs(-ball.spin * ball.radius - 2)) / 2;
    return graded(error, 0.001, 0.1,
                  "A ball that slides at 3 m/s rolls at 2 m/s in the end; here it moves at " +
                      brief(ball.velocity.x) + " m/s and its rim at " + brief(-ball.spin * ball.radius) +
                      " m/s.");
}

Finding kicks(const Subject& subject) {
    const auto world = subject.world(
        R"("materials": {"bumper": {"restitution": 0.5, "kick": 3}},
           "balls": [{"position": [0, 1], "velocity": [0, -1], "radius": 0.1, "mass": 1}], "parts": [)" +
        subject.floor(R"("material": "bumper", )") + "]");
    run_for(*world, 1.5, small_step, [] {});
    const double speed = world->balls().empty() ? 0 : world->balls().front().velocity.y;
    return graded(std::abs(speed - 3), 1e-6, 0.3,
                  "From a bumper with a kick of 3 m/s a ball comes back at " + brief(speed) + " m/s.");
}

Finding damps(const Subject& subject) {
    const auto world = subject.world(
        R"("damping": 0.5, "balls": [{"position": [0, 0], "velocity": [2, 0], "radius": 0.1, "mass": 1}])");
    run_for(*world, 1, small_step, [] {});
    const double speed = world->balls().front().velocity.x, exact = 2 * std::exp(-0.5);
    return graded(std::abs(speed - exact), 1e-6, 0.01,
                  "With a drag of 0.5 /s, 2 m/s become " + brief(speed) +
                      " m/s in a second; the exact answer is " + brief(exact) + " m/s.");
}

/// A bar that turns at 2 rad/s comes up under a ball at rest half a metre from its pivot: its surface moves
/// at 1 m/s.
Finding moves(const Subject& subject) {
    const auto world = subject.world(
        R"("balls": [{"position": [0.5, 0.3], "radius": 0.1, "mass": 1}],
           "parts": [{"name": "bar", "motion": {"type": "turn", "pivot": [0, 0], "rate": 2, "always": true}, "shape": )" +
        std::string(subject.declares(FLIPSIDE_SEGMENTS | FLIPSIDE_POINTS)
                        ? R"({"type": "segment", "a": [0, 0], "b": [1, 0]})"
                        : R"({"type": "capsule", "a": [0, 0], "b": [1, 0], "radius": 0.01})") +
        "}]");
    run_for(*world, 0.6, small_step, [] {});
    // Elastic and without friction: twice the surface's speed at the distance where they meet, along its
    // normal.
    const double speed = length(world->balls().front().velocity);
    const double exact = 2 * 2 * std::sqrt(0.5 * 0.5 + 0.3 * 0.3 - 0.1 * 0.1);
    return graded(std::abs(speed - exact) / exact, 1e-3, 0.1,
                  "Hit by a bar that turns, a ball at rest flies at " + brief(speed) +
                      " m/s; the exact answer is " + brief(exact) + " m/s.");
}

Finding senses(const Subject& subject) {
    const auto world = subject.world(
        R"("balls": [{"position": [0, 1], "velocity": [0, -1], "radius": 0.1, "mass": 1}], "parts": [)" +
        subject.floor(R"("sensor": true, )") + "]");
    std::string seen;
    run_for(*world, 2.5, small_step, [&] {
        for (const Event& event : world->events())
            seen += (seen.empty() ? "" : ", ") + std::string(name_of(event.kind));
    });
    const bool went_on = std::abs(world->balls().front().position.y + 1.5) < 1e-6;
    if (!went_on) return fails("A sensor stops a ball.");
    const bool is_line = subject.declares(FLIPSIDE_SEGMENTS | FLIPSIDE_POINTS);
    return seen == (is_line ? "sensor-begin, sensor-end" : "sensor-begin")
               ? passes("A ball that passes through a sensor is reported: " + seen + ".")
               : fails("A ball that passes through a sensor is reported as \"" + seen.substr(0, 100) + "\".");
}

Finding keeps_layers_apart(const Subject& subject) {
    const auto world = subject.world(
        R"("balls": [{"position": [0, 1], "velocity": [0, -1], "radius": 0.1, "mass": 1}], "parts": [)" +
        subject.floor(R"("layer": "upper", "collides_with": [], )") + "]");
    run_for(*world, 2, small_step, [] {});
    return std::abs(world->balls().front().position.y + 1) < 1e-6
               ? passes("A ball passes through a part of another layer.")
               : fails("A ball is stopped by a part of a layer that it does not meet.");
}

/// Where a ball is after 2 s that meets a gate at y = 0 at 1 m/s from 1 m away.
double height_after_gate(const Subject& subject, double side) {
    const std::string y = std::to_string(side), v = std::to_string(-side);
    const auto world = subject.world(R"("balls": [{"position": [0, )" + y + R"(], "velocity": [0, )" + v +
                                     R"(], "radius": 0.1, "mass": 1}],
           "parts": [{"name": "gate", "shape": {"type": "gate", "a": [-1, 0], "b": [1, 0], "normal": [0, 1]}}])");
    run_for(*world, 2, small_step, [] {});
    if (world->parts().front().open) return std::nan("");
    return world->balls().front().position.y;
}

Finding gates_work(const Subject& subject) {
    const double passed = height_after_gate(subject, -1), reflected = height_after_gate(subject, 1);
    if (!(std::abs(passed - 1) < 1e-6))
        return fails("A gate does not let a ball through that moves along its normal, or stays open.");
    return std::abs(reflected - 1.2) < 0.05
               ? passes("A gate lets one way through, and is solid the other way.")
               : fails("A gate is not solid to a ball that comes against its normal.");
}

constexpr std::uint64_t line = FLIPSIDE_SEGMENTS | FLIPSIDE_POINTS;
constexpr ContractItem surfaces[] = {
    {"points", "A ball rests on a point.", 2, FLIPSIDE_POINTS, false, carried_by_point},
    {"segments", "A ball rests on a segment.", 2, line, false, carried_by_segment},
    {"arcs", "A ball rests in an arc.", 2, FLIPSIDE_ARCS | FLIPSIDE_POINTS, false, carried_by_arc},
    {"circles", "A ball rests on a circle.", 2, FLIPSIDE_CIRCLES, false, carried_by_circle},
    {"polygons", "A ball rests on a polygon.", 2, FLIPSIDE_POLYGONS, false, carried_by_polygon},
    {"capsules", "A ball rests on a capsule.", 2, FLIPSIDE_TAPERS, false, carried_by_capsule},
    {"friction", "A ball that slides begins to roll.", 4, FLIPSIDE_FRICTION, false, friction_rolls},
    {"kicks", "A bumper kicks.", 2, FLIPSIDE_KICKS, false, kicks},
    {"damping", "A ball is slowed by the table's drag.", 2, FLIPSIDE_DAMPING, false, damps},
    {"moving parts", "A part that turns hits as fast as its surface moves.", 4, FLIPSIDE_MOVING, false,
     moves},
    {"sensors", "A sensor reports, and stops nothing.", 3, FLIPSIDE_SENSORS, false, senses},
    {"layers", "Things of layers that do not meet pass through each other.", 2, FLIPSIDE_LAYERS, false,
     keeps_layers_apart},
    {"gates", "A gate lets balls through one way.", 3, FLIPSIDE_GATES | line, false, gates_work},
};

}  // namespace

std::span<const ContractItem> surface_items() {
    return surfaces;
}

}  // namespace flipside::lab
