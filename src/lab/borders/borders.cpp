#include "lab/borders/borders.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lab/hunt/hard.hpp"
#include "lab/session/run.hpp"
#include "world/input_error.hpp"
#include "world/refusal.hpp"
#include "world/scene_builder.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab {

namespace {

constexpr double r = 0.1, g = 9.81;  // m, m/s²
constexpr double most_overlap = 0.1, most_gain = 0.01, most_change = 0.1;

/// A closed box from the origin, with this restitution between all things.
BorderRun box(double width, double height, double restitution, double gravity) {
    BorderRun run;
    run.scene = empty_scene({0, -gravity});
    run.scene.rest_speed = gravity > 0 ? 0.1 : 0;
    run.scene.bounds = {{-1e6, -1e6}, {1e6, 1e6}};
    run.scene.materials[0].restitution = std::sqrt(restitution);
    run.walls = {{0, 0}, {width, height}};
    add_part(run.scene, {shape::Polyline{{{0, 0}, {width, 0}, {width, height}, {0, height}}, true}},
             {"", std::sqrt(restitution), 0, 0});
    run.is_elastic = restitution == 1 && gravity == 0;
    return run;
}

BorderRun heavy_on_light(double ratio) {
    BorderRun run = box(10 * r, 10 * r, 0.5, g);
    add_ball(run.scene, {5 * r, r}, {}, r, 1);
    add_ball(run.scene, {5 * r, 3 * r}, {}, r, ratio);
    return run;
}

/// The heavy one comes down a little off the middle at 100 radii/s.
BorderRun heavy_thrown_at_light(double ratio) {
    BorderRun run = box(20 * r, 30 * r, 0.5, g);
    add_ball(run.scene, {10 * r, r}, {}, r, 1);
    add_ball(run.scene, {10.1 * r, 15 * r}, {0, -100 * r}, r, ratio);
    return run;
}

/// Both come along the corner's diagonal at 20 radii/s, and nothing bounces; the second is thrice as heavy.
BorderRun light_in_corner(double ratio) {
    BorderRun run = box(20 * r, 20 * r, 0, g);
    const Vec2 diagonal{std::sqrt(0.5), std::sqrt(0.5)}, corner{r, r};
    add_ball(run.scene, corner, {}, r, 1);
    add_ball(run.scene, corner + 3 * r * diagonal, -20 * r * diagonal, r, ratio);
    add_ball(run.scene, corner + 5.5 * r * diagonal, -20 * r * diagonal, r, 3 * ratio);
    return run;
}

/// The light one is smaller by half, and both come down at it from either side at 50 radii/s.
BorderRun light_pinched(double ratio) {
    BorderRun run = box(20 * r, 20 * r, 0, g);
    const Vec2 floor{10 * r, 0.5 * r};
    add_ball(run.scene, floor, {}, 0.5 * r, 1);
    add_ball(run.scene, floor + Vec2{-3 * r, 3 * r}, {35 * r, -35 * r}, r, ratio);
    add_ball(run.scene, floor + Vec2{3.5 * r, 3 * r}, {-35 * r, -35 * r}, r, ratio / 3);
    return run;
}

/// The worst that a hunt found for the bespoke engine (lab/hunt), where the ratio is 1,000: here with any.
BorderRun hunted(double ratio) {
    constexpr double lightest = 0.03, heavy = 30;  // kg, in the file
    BorderRun run;
    run.scene = load_scene(hunt::hard_folder() / "custom-overlap.json");
    run.walls = run.scene.bounds;
    run.seconds = 1;
    for (Ball& ball : run.scene.balls)
        if (ball.mass == heavy) ball.mass = ratio * lightest;
    return run;
}

/// From side to side of a channel that is a fifth of a radius wider than a ball.
BorderRun stack(double balls) {
    constexpr double play = 0.2 * r;
    const double rise = std::sqrt(4 * r * r - play * play);
    BorderRun run = box(2 * r + play, (balls + 2) * 2 * r, 0.5, g);
    for (int i = 0; i < static_cast<int>(balls); ++i)
        add_ball(run.scene, {r + (i % 2 == 0 ? 0 : play), r + i * rise}, {}, r, 1);
    return run;
}

/// Thirty steps, in a box that is forty radii wide.
BorderRun ball_at_walls(double radii_per_step) {
    BorderRun run = box(40 * r, 40 * r, 1, 0);
    run.seconds = 30 * run.dt;
    const double speed = radii_per_step * r / run.dt;
    add_ball(run.scene, {20 * r, 20 * r}, {0.8 * speed, 0.6 * speed}, r, 1);
    return run;
}

/// The same of two balls in a lane, each with half the speed.
BorderRun ball_at_ball(double radii_per_step) {
    BorderRun run = box(40 * r, 2.2 * r, 1, 0);
    run.seconds = 30 * run.dt;
    run.is_lane = true;
    const double speed = 0.5 * radii_per_step * r / run.dt;
    add_ball(run.scene, {10.3 * r, 1.1 * r}, {speed, 0}, r, 1);
    add_ball(run.scene, {29.1 * r, 1.1 * r}, {-speed, 0}, r, 1);
    return run;
}

/// Twenty balls fall into a box.
BorderRun step_of(double milliseconds) {
    BorderRun run = box(12 * r, 40 * r, 0.5, g);
    run.dt = milliseconds / 1000;
    for (int i = 0; i < 20; ++i) {
        const int row = i / 4;
        add_ball(run.scene, {(2 + 2.2 * (i % 4) + 0.3 * (row % 2)) * r, (12 + 2.5 * row) * r}, {}, r, 1);
    }
    return run;
}

std::string text_of(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

/// The deepest, in radii of the smaller ball of the two.
double overlap(std::span<const Ball> balls, const Box& walls) {
    double deepest = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const Vec2 p = balls[i].position;
        const double radius = balls[i].radius;
        for (const double gap : {p.x - walls.min.x, p.y - walls.min.y, walls.max.x - p.x, walls.max.y - p.y})
            deepest = std::max(deepest, 1 - gap / radius);
        for (std::size_t k = 0; k < i; ++k)
            deepest = std::max(deepest, (radius + balls[k].radius - length(p - balls[k].position)) /
                                            std::min(radius, balls[k].radius));
    }
    return deepest;
}

/// J; the potential is 0 in the lowest corner of the box, so that it is never below, and a gain is a share of
/// all.
double energy_in(const Session& session, const Box& walls) {
    const Vec2 gravity = session.scene().gravity;
    const Vec2 lowest{gravity.x > 0 ? walls.max.x : walls.min.x, gravity.y > 0 ? walls.max.y : walls.min.y};
    double mass = 0;
    for (const Ball& ball : session.world().balls()) mass += ball.mass;
    return energy(session.world(), session.scene()) + mass * dot(gravity, lowest);
}

/// "" or what is wrong with the world after a step.
std::string fault_of(const Session& session, const BorderRun& run, double first_energy) {
    const auto balls = session.world().balls();
    check_finite(session, session.world().time());
    const auto inside = [&](const Ball& ball) { return run.walls.contains(ball.position); };
    if (balls.size() != run.scene.balls.size() || !std::ranges::all_of(balls, inside))
        return "a ball gets out";
    if (run.is_lane && !std::ranges::is_sorted(balls, {}, [](const Ball& ball) { return ball.position.x; }))
        return "balls pass through each other";
    const double deepest = overlap(balls, run.walls);
    if (deepest > most_overlap) return "overlap of " + text_of("%.2g", deepest) + " radii";
    const double gain = energy_in(session, run.walls) / first_energy - 1;
    if (gain > most_gain) return "gains " + text_of("%.2g", 100 * gain) + " % of energy";
    if (run.is_elastic && gain < -most_change)
        return "loses " + text_of("%.2g", -100 * gain) + " % of energy";
    return "";
}

std::string run_at(const Contender& contender, const BorderRun& run) {
    try {
        Session session(std::make_shared<const Scene>(run.scene), *contender.engine, contender.settings);
        const double first = energy_in(session, run.walls);
        const Timeline timeline(0, run.seconds, run.dt);
        for (std::uint64_t k = 0; k < timeline.steps(); ++k) {
            session.step(timeline.length(k));
            if (std::string fault = fault_of(session, run, first); !fault.empty()) return fault;
        }
    } catch (const NotANumber&) {
        return "not a number";
    } catch (const Refusal&) {
        return "refused";
    } catch (const InputError&) {
        return "refused";
    }
    return "";
}

const std::vector<double> ratios{1, 2, 5, 10, 30, 100, 300, 1e3, 3e3, 1e4, 3e4, 1e5, 3e5, 1e6};
const std::vector<double> speeds{1, 3, 10, 30, 100, 300, 1e3, 3e3, 1e4, 3e4, 1e5};

}  // namespace

std::span<const Border> borders() {
    static const Border all[] = {
        {"heavy-on-light", "mass ratio, lying", "A heavy ball lies on a light one.", ratios, heavy_on_light},
        {"heavy-thrown", "mass ratio, thrown", "A heavy ball is thrown down at a light one on the floor.",
         ratios, heavy_thrown_at_light},
        {"heavy-corner", "mass ratio, in a corner", "Two heavy balls press a light one into a corner.",
         ratios, light_in_corner},
        {"heavy-pinch", "mass ratio, from two sides", "Two heavy balls hit a small light one on the floor.",
         ratios, light_pinched},
        {"hunted", "mass ratio, hunted",
         "A scene that was searched for the deepest overlap of the bespoke engine.", ratios, hunted},
        {"stack",
         "stack, balls",
         "A stack that leans from side to side of a channel.",
         {2, 3, 4, 6, 8, 10, 14, 20, 28, 40, 56, 80, 110, 160, 220},
         stack},
        {"wall-speed", "at a wall, radii a step", "A fast ball between walls.", speeds, ball_at_walls},
        {"ball-speed", "at a ball, radii a step", "Two fast balls meet.", speeds, ball_at_ball},
        {"step",
         "step, ms",
         "Twenty balls fall into a box, in steps of this length.",
         {1, 2, 4, 8, 16, 33, 66, 100, 200, 400},
         step_of}};
    return all;
}

std::vector<BorderPoint> find_borders(const Contender& contender, std::size_t most,
                                      const std::function<void(double)>& watch) {
    std::vector<BorderPoint> points;
    const auto all = borders();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::span<const double> ladder = all[i].ladder;
        for (const double value : ladder.first(std::min(most, ladder.size()))) {
            points.push_back({all[i].name, value, run_at(contender, all[i].make(value))});
            watch((static_cast<double>(i) + 0.5) / static_cast<double>(all.size()));
            if (!points.back().failure.empty()) break;
        }
    }
    return points;
}

}  // namespace flipside::lab
