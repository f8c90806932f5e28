/// How balls move: alone, against a floor, against each other.

#include <algorithm>
#include <cmath>

#include "flipside/engine.h"
#include "lab/conformance/check.hpp"
#include "world/trace.hpp"

namespace flipside::lab {

namespace {

constexpr double fine = 1.0 / 240;  ///< s

Finding steps_of_any_length(const Subject& subject) {
    const auto world =
        subject.world(R"("balls": [{"position": [0, 0], "velocity": [1, 2], "radius": 0.1, "mass": 1}])");
    double time = 0;
    for (const double dt : {1.0 / 60, 1e-3, 0.25, 1e-6}) {
        world->step(dt);
        time += dt;
    }
    const Ball& ball = world->balls().front();
    const double error = length(ball.position - time * Vec2{1, 2});
    return graded(error, 1e-9, 1e-6,
                  "Without gravity, after steps of 1/60, 1/1000, 1/4 and 1e-6 s, a ball is " + brief(error) +
                      " m from its straight line.");
}

Finding free_fall(const Subject& subject) {
    const auto world = subject.world(
        R"("gravity": [0, -9.81], "balls": [{"position": [0, 5], "velocity": [1, 0], "radius": 0.1, "mass": 1}])");
    double worst = 0;
    run_for(*world, 1, fine, [&] {
        const double t = world->time();
        const Vec2 exact{t, 5 - 9.81 * t * t / 2};
        worst = std::max(worst, length(world->balls().front().position - exact));
    });
    // What Euler's methods are off by, and a little.
    const double bound = 1.01 * 9.81 * 1 * fine / 2;
    return graded(worst, 1e-9, bound,
                  "In a second of free fall in steps of 1/240 s it is at most " + brief(worst) +
                      " m from the parabola; the bound is " + brief(bound) +
                      " m, full marks are for 1e-9 m.");
}

/// The greatest height after the first bounce from 1 m above the floor, m.
double height_after_bounce(const Subject& subject, double restitution) {
    const auto world = subject.world(
        R"("gravity": [0, -9.81], "materials": {"m": {"restitution": )" + std::to_string(restitution) +
        R"(}}, "balls": [{"position": [0, 1.1], "radius": 0.1, "mass": 1}], "parts": [)" +
        subject.floor(R"("material": "m", )") + "]");
    const double fall = std::sqrt(2 / 9.81);
    double highest = 0;
    run_for(*world, fall * (1 + restitution) + 0.01, fine, [&] {
        if (world->time() > fall + 0.02 && !world->balls().empty())
            highest = std::max(highest, world->balls().front().position.y - 0.1);
    });
    return highest;
}

Finding bounces(const Subject& subject) {
    if (subject.floor().empty()) return fails("It declares no surface that a ball could fall on.");
    double worst = 0;
    std::string heights;
    for (const double restitution : {0.5, 0.8, 1.0}) {
        const double height = height_after_bounce(subject, restitution), exact = restitution * restitution;
        worst = std::max(worst, std::abs(height - exact));
        heights += (heights.empty() ? "" : ", ") + brief(height) + " m for " + brief(exact) + " m";
    }
    return graded(worst, 0.005, 0.1,
                  "Fallen from 1 m with restitutions of 0.5, 0.8 and 1 a ball comes back to " + heights +
                      "; the bound is 0.1 m, full marks are for 5 mm.");
}

Finding momentum(const Subject& subject) {
    const auto world = subject.world(R"("balls": [
        {"position": [-1, 0], "velocity": [2, 0], "radius": 0.1, "mass": 1},
        {"position": [0, 0.05], "velocity": [-1, 0], "radius": 0.1, "mass": 3}])");
    run_for(*world, 1, fine, [] {});
    Vec2 sum;
    for (const Ball& ball : world->balls()) sum += ball.mass * ball.velocity;
    const double error = length(sum - Vec2{2 - 3, 0});
    const bool met = world->balls()[0].velocity.x < 1.9;
    return met ? graded(error, 1e-12, 1e-3,
                        "When two balls meet off centre, their momentum changes by " + brief(error) + " N s.")
               : fails("Two balls that fly at each other pass through each other.");
}

std::string box_of_balls(const std::string& walls) {
    std::string balls;
    for (int i = 0; i < 9; ++i)
        balls += std::string(i == 0 ? "" : ", ") + R"({"position": [)" + std::to_string(i % 3 - 1) + ", " +
                 std::to_string(i / 3 - 1) + R"(], "velocity": [)" + std::to_string((i * 7) % 5 - 2) + ", " +
                 std::to_string((i * 3) % 7 - 3) + R"(], "radius": 0.25, "mass": 1})";
    return R"("parts": [)" + walls + R"(], "balls": [)" + balls + "]";
}

constexpr const char* box_walls =
    R"({"name": "box", "shape": {"type": "polyline", "points": [[-2, -2], [2, -2], [2, 2], [-2, 2]], "closed": true}})";

Finding energy_in_a_box(const Subject& subject) {
    const auto world = subject.world(box_of_balls(box_walls));
    const auto energy = [&] {
        double sum = 0;
        for (const Ball& ball : world->balls()) sum += 0.5 * ball.mass * length_squared(ball.velocity);
        return sum;
    };
    const double first = energy();
    double worst = 0;
    run_for(*world, 5, fine, [&] { worst = std::max(worst, std::abs(energy() - first) / first); });
    if (world->balls().size() != 9) return fails("Balls have left a closed box.");
    return graded(worst, 1e-9, 0.1,
                  "Nine elastic balls in a box, without gravity: their energy is off by at most " +
                      brief(100 * worst) + " % in 5 s; the bound is 10 %.");
}

Finding same_bits_twice(const Subject& subject) {
    const auto run = [&] {
        const std::string balls =
            subject.declares(FLIPSIDE_BALL_PAIRS)
                ? R"({"position": [0.03, 1], "radius": 0.1, "mass": 1}, {"position": [0, 2], "radius": 0.1, "mass": 2})"
                : R"({"position": [0.03, 1], "radius": 0.1, "mass": 1})";
        const auto world = subject.world(R"("gravity": [0, -9.81], "balls": [)" + balls + R"(], "parts": [)" +
                                         subject.floor() + "]");
        run_for(*world, 2, fine, [] {});
        return std::vector<Ball>(world->balls().begin(), world->balls().end());
    };
    return run() == run() ? passes("Two runs of 2 s in two processes end with the same bits.")
                          : fails("Two runs of the same scene do not end with the same bits.");
}

constexpr ContractItem motion[] = {
    {"steps", "It advances by exactly dt, whatever its length.", 4, 0, true, steps_of_any_length},
    {"free fall", "A ball in the air flies the parabola.", 10, 0, true, free_fall},
    {"bounce", "A ball comes back to the square of the restitution of its height.", 12, 0, true, bounces},
    {"determinism", "The same scene gives the same bits.", 8, 0, true, same_bits_twice},
    {"momentum", "Balls that meet keep their momentum.", 5, FLIPSIDE_BALL_PAIRS, false, momentum},
    {"energy", "Elastic balls keep their energy.", 5,
     FLIPSIDE_BALL_PAIRS | FLIPSIDE_SEGMENTS | FLIPSIDE_POINTS, false, energy_in_a_box},
};

}  // namespace

std::span<const ContractItem> motion_items() {
    return motion;
}

}  // namespace flipside::lab
