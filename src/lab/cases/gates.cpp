// A ball that comes to the free end of a gate.

#include <array>
#include <cmath>
#include <numbers>

#include "lab/cases/families.hpp"
#include "lab/session/timeline.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {

namespace {

/// Before it is turned: the gate ends in the origin, lies along −x, and passes what moves up. Lengths in
/// radii, times in s.
struct Picture {
    std::string_view name;
    Vec2 start, velocity;  ///< r, r/s
    double gravity = 0;    ///< downwards, r/s²
    bool passes = false;   ///< by the rule (world/gate.hpp)
};
constexpr double time = 0.5;
constexpr Picture pictures[] = {
    {"along the line, before it", {4, 0.5}, {-16, 0}, 0, false},
    {"along the line, behind it", {4, -0.5}, {-16, 0}, 0, true},
    {"on the line", {4, 0}, {-16, 0}, 0, false},
    {"to the line from behind", {4, -1.5}, {-16, 8}, 0, true},
    {"to the line from before", {4, 1.5}, {-16, -8}, 0, false},
    {"down past the end", {0.5, 4}, {0, -16}, 0, false},
    {"up past the end", {0.5, -4}, {0, 16}, 0, true},
    {"round the end, on to the face", {4, -4}, {-20, 48}, 160, false},
};

/// Where a point without weight is that is reflected by the end of the gate, if the gate does not let it
/// through: at the first time at which |start + velocity·t| is 1.
Vec2 straight_end(const Picture& p) {
    if (p.passes) return p.start + time * p.velocity;
    const double a = length_squared(p.velocity), b = dot(p.start, p.velocity);
    const double hit = (-b - std::sqrt(b * b - a * (length_squared(p.start) - 1))) / a;
    const Vec2 normal = p.start + hit * p.velocity;
    return normal + (time - hit) * (p.velocity - 2 * dot(p.velocity, normal) * normal);
}
/// Where a falling one is that is reflected by the face, one radius above the line.
Vec2 falling_end(const Picture& p) {
    const double g = p.gravity, v = p.velocity.y;
    const double hit = (v + std::sqrt(v * v + 2 * g * (p.start.y - 1))) / g;
    const double up = g * hit - v, after = time - hit;
    return {p.start.x + time * p.velocity.x, 1 + up * after - g * after * after / 2};
}

/// Steps of 1, 0.7, 0.4, 0.15 and 0.05 of the case's own, in each orientation.
void meet_gate(Experiment& experiment, const Picture& picture, int orientations) {
    constexpr std::array steps{1.0, 0.7, 0.4, 0.15, 0.05};
    const Vec2 expected = picture.gravity == 0 ? straight_end(picture) : falling_end(picture);
    double worst = 0;
    int ended_there = 0, faster = 0;
    for (int k = 0; k < orientations; ++k)
        for (const double step : steps) {
            const double angle = 2 * std::numbers::pi * (k + 0.25) / orientations;
            const auto turned = [&](Vec2 v) { return radius * rotated(v, angle); };
            Scene scene = empty_scene(turned({0, -picture.gravity}));
            scene.rest_speed = 0;
            add_part(scene, {shape::Gate{turned({-10, 0}), {}, turned({0, 1})}});
            add_ball(scene, turned(picture.start), turned(picture.velocity), radius);
            Trial trial(experiment, scene);
            const Timeline timeline(0, time, step * experiment.dt());
            for (std::uint64_t i = 0; i < timeline.steps(); ++i) trial.step(timeline.length(i));
            const Ball ball = trial.ball(0);
            const double error = length(ball.position - turned(expected)) / radius;
            if (!(error <= worst)) worst = error;  // that of a lost ball is no number
            ended_there += error < 0.1 ? 1 : 0;
            const double fallen = dot(scene.gravity, ball.position - scene.balls[0].position);
            const double energy = length_squared(ball.velocity) / 2 - fallen;
            faster += energy > 1.1 * length_squared(scene.balls[0].velocity) / 2 ? 1 : 0;
        }
    const int runs = orientations * static_cast<int>(steps.size());
    const std::string of = ", " + std::string(picture.name) + ", " + std::to_string(runs) + " runs";
    experiment.exact("ends where the rule says" + of, "", runs, ended_there, 0);
    experiment.exact("farthest from there" + of, "r", 0, worst, 1e-9);
    experiment.always("balls that gained energy" + of, "", 0, faster);
}

}  // namespace

void gate_end(Experiment& experiment) {
    const int orientations = experiment.size(60, 12);
    for (const Picture& picture : pictures)
        experiment.attempt(std::string(picture.name), [&] { meet_gate(experiment, picture, orientations); });
}

}  // namespace flipside::lab
