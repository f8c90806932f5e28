// What must not matter: how a scene is turned, which way time runs, and how long the steps are.

#include <algorithm>
#include <cmath>

#include "lab/cases/families.hpp"
#include "lab/cases/text.hpp"
#include "lab/scenes/dice.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {

namespace {

/// As it is, or turned by a quarter turn anticlockwise: exact in any number type.
Vec2 quarter(Vec2 v, bool turned) {
    return turned ? Vec2{-v.y, v.x} : v;
}

/// Balls that hardly touch, thrown about a box with two pins.
Scene lively_box(int balls, double restitution, Vec2 gravity, bool turned) {
    Scene scene = empty_scene(quarter(gravity, turned));
    scene.rest_speed = 0;
    scene.materials[0].restitution = std::sqrt(restitution);
    const Material wall{"", std::sqrt(restitution), 0, 0};
    const auto at = [&](double x, double y) { return quarter({x, y}, turned); };
    add_part(scene, {shape::Polyline{{at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)}, true}}, wall);
    add_part(scene, {shape::Circle{at(0.3, 0.2), 0.15}}, wall);
    add_part(scene, {shape::Point{at(-0.4, -0.3)}}, wall);
    Dice dice(1);
    for (int i = 0; i < balls; ++i) {
        const int row = i / 4;
        const double x = -0.75 + 0.5 * (i % 4), y = -0.7 + 0.45 * row;
        add_ball(scene, at(x, y), quarter(2 * dice.direction(), turned), 0.06);
    }
    return scene;
}

/// Balls in rows that are thrown about a box, or its mirror image with the balls in reverse order.
Scene rows_in_a_box(int balls, double restitution, double weight, bool mirrored) {
    const auto at = [&](Vec2 v) { return mirrored ? Vec2{-v.x, v.y} : v; };
    Scene scene = empty_scene({0, -weight});
    scene.rest_speed = 0.01;
    scene.materials[0].restitution = std::sqrt(restitution);
    const Material wall{"", std::sqrt(restitution), 0, 0};
    add_part(scene, {shape::Polyline{{at({-2, -2}), at({2, -2}), at({2, 2}), at({-2, 2})}, true}}, wall);
    add_part(scene, {shape::Circle{at({0.7, -1.2}), 0.3}}, wall);
    add_part(scene, segment(at({-1.5, -0.9}), at({-0.4, -1.4})), wall);
    Dice dice(1);
    std::vector<Ball> made;
    for (int i = 0; i < balls; ++i) {
        const int row = i / 14;
        const Vec2 place{-1.85 + 0.28 * (i % 14) + dice.below(0.05), 1.8 - 0.25 * row};
        made.push_back(add_ball(scene, at(place), at(2 * dice.direction()), 0.08));
    }
    if (!mirrored) return scene;
    std::ranges::reverse(made);
    for (BallNumber i = 0; i < made.size(); ++i) made[i].number = i;
    scene.balls = std::move(made);
    return scene;
}

/// Of the worst ball, radii.
double farthest_apart(const Trial& a, auto&& place_of) {
    double worst = 0;
    for (const Ball& ball : a.world().balls())
        worst = std::max(worst, length(ball.position - place_of(ball.number)) / ball.radius);
    return worst;
}

/// To `seconds` and back again; and how far apart a shift of the start leads.
void reverse_after(Experiment& experiment, double seconds) {
    constexpr double shift = 1e-12;  // m
    const Scene scene = lively_box(8, 1, {0, -g}, false);
    Scene shifted = scene;
    for (Ball& ball : shifted.balls) ball.position += {shift, -shift};
    Trial there(experiment, scene), beside(experiment, shifted);
    there.run_to(seconds);
    beside.run_to(seconds);
    const double amplified = farthest_apart(there, [&](BallNumber i) { return beside.ball(i).position; });
    State back = there.world().save();
    back.origin.reset();
    back.clock = {};
    for (Ball& ball : back.balls) ball.velocity = -ball.velocity, ball.spin = -ball.spin;
    Trial again(experiment, scene, back);
    again.run_to(seconds);
    const double missed = farthest_apart(again, [&](BallNumber i) { return scene.balls[i].position; });
    experiment.exact("way from the start, over that of a shift by 1e-12 m, " + text_of(seconds) + " s", "", 0,
                     missed / amplified, 1);
    experiment.note("shift by 1e-12 m becomes, " + text_of(seconds) + " s", "r", amplified);
}

/// Everything but what presses: gravity, drag, a part that turns, a kicker.
Scene busy_box() {
    Scene scene = lively_box(6, 0.9, {0, -g}, false);
    scene.rest_speed = 0.01;
    scene.damping = 0.05;
    add_part(scene, segment({-0.2, 0.6}, {0.2, 0.6}), {"", 0.8, 0.3, 0}).motion =
        motion::Turn{{0, 0.6}, 3, true};
    add_part(scene, {shape::Circle{{-0.5, 0.4}, 0.1}}, {"", 0.9, 0, 2});
    return scene;
}

}  // namespace

void mirror(Experiment& experiment) {
    constexpr double seconds = 3;
    const auto compare = [&](const std::string& name, int balls, double restitution, double weight,
                             double tolerance) {
        Trial one(experiment, rows_in_a_box(balls, restitution, weight, false)),
            other(experiment, rows_in_a_box(balls, restitution, weight, true));
        one.run_to(seconds);
        other.run_to(seconds);
        const double apart = farthest_apart(other, [&](BallNumber i) {
            const Vec2 image = one.ball(static_cast<BallNumber>(balls) - 1 - i).position;
            return Vec2{-image.x, image.y};
        });
        experiment.exact("largest difference after 3 s, " + name, "r", 0, apart, tolerance);
    };
    experiment.attempt("few", [&] { compare("8 balls, e = 1", 8, 1, g, 0); });
    experiment.attempt("many", [&] { compare("120 balls, e = 0.9, no weight", 120, 0.9, 0, 1e-9); });
}

void quarter_turn(Experiment& experiment) {
    constexpr double seconds = 3;
    Trial upright(experiment, lively_box(8, 0.9, {0, -g}, false)),
        turned(experiment, lively_box(8, 0.9, {0, -g}, true));
    upright.run_to(seconds);
    turned.run_to(seconds);
    const double apart =
        farthest_apart(turned, [&](BallNumber i) { return quarter(upright.ball(i).position, true); });
    experiment.exact("largest difference after 3 s", "r", 0, apart, 0);
    experiment.exact("impacts fewer or more", "", static_cast<double>(upright.impact_count()),
                     static_cast<double>(turned.impact_count()), 0);
}

void time_reversal(Experiment& experiment) {
    for (const double seconds : {1.0, 2.0, 3.0})
        experiment.attempt("reversal", [&] { reverse_after(experiment, seconds); });
}

void step_independence(Experiment& experiment) {
    constexpr double seconds = 3;
    const auto run = [&](auto&& step_of) {
        Trial trial(experiment, busy_box());
        for (int k = 0; trial.time() < seconds - 1e-9; ++k)
            trial.step(std::min(step_of(k), seconds - trial.time()));
        return trial;
    };
    const Trial first = run([](int) { return 1.0 / 60; });
    // The reference starts new paths at the end of each step and rounds there, so a saved state does not
    // continue to the bit.
    const double tolerance = experiment.input().contender.engine->restores_exactly ? 0 : 1e-8;
    const auto compare = [&](const std::string& name, auto&& step_of) {
        const Trial other = run(step_of);
        experiment.exact("largest difference after 3 s, " + name, "r", 0,
                         farthest_apart(other, [&](BallNumber i) { return first.ball(i).position; }),
                         tolerance);
    };
    for (const double rate : {30.0, 97.0, 240.0})
        compare("dt = 1/" + text_of(rate) + " s", [&](int) { return 1 / rate; });
    compare("irregular steps", [](int k) { return 1e-3 * (1 + k * k % 37); });
}

}  // namespace flipside::lab
