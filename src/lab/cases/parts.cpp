// A ball against parts that move, and through sensors.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lab/cases/families.hpp"
#include "lab/cases/text.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {

namespace {

using std::numbers::pi;
constexpr shape::Flipper flipper_shape{{0, 0}, 1, 0.15, 0.1, 0};

/// A flipper on its way between two angles from rest, dead still once it is there.
struct Swing {
    double from, to;  ///< rad
    double rate;      ///< rad/s, ≥ 0

    [[nodiscard]] double turning() const { return to > from ? rate : -rate; }
    [[nodiscard]] double until() const { return from == to ? 0 : std::abs(to - from) / rate; }
    [[nodiscard]] double angle(double t) const { return t < until() ? from + turning() * t : to; }
    [[nodiscard]] double rate_at(double t) const { return t < until() ? turning() : 0; }
};

struct Hit {
    std::string_view name;
    Swing swing;
    Vec2 position, velocity;  ///< of the ball at time 0
};

/// The flipper's outline seen from p: distance and outward normal. The hull of two circles about (0, 0) and
/// (length, 0); on its sides the distance is that of a cone along the axis (I. Quilez, "2D distance
/// functions", uneven capsule).
struct Nearest {
    double distance = 0;
    Vec2 normal;
};
Nearest nearest(Vec2 p) {
    const double reach = flipper_shape.length, base = flipper_shape.base_radius;
    const double tip = flipper_shape.tip_radius;
    const double slope = (base - tip) / reach, rise = std::sqrt(1 - slope * slope);
    const double side = p.y < 0 ? -1 : 1;
    const Vec2 q{p.x, side * p.y};
    const double along = rise * q.x - slope * q.y;  // in the side's own frame, from the base's tangent point
    if (along < 0) return {length(p) - base, unit(p)};
    if (along > rise * reach) return {length(p - Vec2{reach, 0}) - tip, unit(p - Vec2{reach, 0})};
    return {slope * q.x + rise * q.y - base, {slope, side * rise}};
}

struct Exact {
    double time = 0;
    Vec2 velocity;  ///< of the ball after the hit
};
/// Scans for the first touch in steps of 10 µs, then bisects: independent of every engine.
Exact exact_hit(const Hit& hit, double e) {
    const auto at = [&](double t) {
        return nearest(rotated(hit.position + t * hit.velocity, -hit.swing.angle(t)));
    };
    double low = 0, high = 0;
    while (at(high).distance > radius) {
        low = high;
        high += 1e-5;
    }
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (at(middle).distance > radius ? low : high) = middle;
    }
    const Vec2 center = hit.position + high * hit.velocity;
    const Vec2 normal = rotated(at(high).normal, hit.swing.angle(high));
    const double surface = dot(cross(hit.swing.rate_at(high), center - radius * normal), normal);
    const double approach = dot(hit.velocity, normal);
    return {high, hit.velocity + ((1 + e) * (surface - approach)) * normal};
}

void flipper_hit(Experiment& experiment, const Hit& hit, double e) {
    const Swing& swing = hit.swing;
    Scene scene = empty_scene();
    scene.rest_speed = 0;
    Part& part = add_part(scene, {flipper_shape}, {"", e, 0, 0});
    const double raised = std::max({swing.from, swing.to, 0.1});
    part.motion = motion::Flip{Side::left, raised, std::max(swing.rate, 1.0), std::max(swing.rate, 1.0)};
    add_ball(scene, hit.position, hit.velocity, radius);

    State state = Trial(experiment, scene).world().save();
    state.parts[0].angle = swing.from;
    state.raised[static_cast<int>(Side::left)] = swing.to > swing.from;
    Trial trial(experiment, scene, state);
    const auto impact = trial.first_impact(1);
    const Exact exact = exact_hit(hit, e);
    const std::string of = ", " + std::string(hit.name) + ", e = " + text_of(e);
    experiment.exact("time" + of, "s", exact.time, impact ? impact->time : no_number, 1e-12);
    experiment.exact("velocity after, error" + of, "m/s", 0,
                     impact ? length(trial.ball(0).velocity - exact.velocity) : no_number, 1e-9);
}

void sensors_at(Experiment& experiment, double speed) {
    Scene scene = empty_scene();
    scene.bounds = {{-1e6, -1e6}, {1e6, 1e6}};
    add_part(scene, segment({0, -1}, {0, 1})).sensor = true;
    add_part(scene, {shape::Circle{{2, 0}, 0.3}}).sensor = true;
    add_ball(scene, {-1, 0}, {speed, 0}, radius);
    Trial trial(experiment, scene);
    std::vector<Event> begins, ends;
    trial.run_to(5 / speed + 0.1, [&] {
        for (const Event& event : trial.events()) {
            if (event.kind == EventKind::sensor_begin) begins.push_back(event);
            if (event.kind == EventKind::sensor_end) ends.push_back(event);
        }
    });
    const std::string of = ", " + text_of(speed / radius) + " r/s";
    experiment.exact("begins at two sensors" + of, "", 2, static_cast<double>(begins.size()), 0);
    experiment.exact("ends at two sensors" + of, "", 2, static_cast<double>(ends.size()), 0);
    if (begins.size() != 2 || ends.size() != 2) return;
    constexpr double enters[] = {0.9, 2.6}, leaves[] = {1.1, 3.4};  // m from the start
    double worst = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        worst = std::max(worst, std::abs(begins[i].time * speed - enters[i]));
        worst = std::max(worst, std::abs(ends[i].time * speed - leaves[i]));
    }
    experiment.exact("worst place of begin or end, error" + of, "m", 0, worst, 1e-9);
}

constexpr double ceiling = 0.45;   // m above the pivot of the flipper that crushes
constexpr double crush_rate = 20;  // rad/s

/// The most that a ball which the flipper squeezes along the ceiling can move, m/s. Its centre stays h =
/// ceiling minus radius above the pivot, and at least d = tip radius plus radius from the flipper's axis, so
/// its place along the ceiling is x = (h cos θ − d)/sin θ and |dx/dθ| = (h − d cos θ)/sin² θ, which is
/// largest where the axis ends.
double squeezed_speed() {
    const double h = ceiling - radius, d = flipper_shape.tip_radius + radius;
    const double x = flipper_shape.length + d;
    const double angle = std::acos(d / std::hypot(h, x)) - math::atan2(x, h);
    return crush_rate * (h - d * math::cos(angle)) / (math::sin(angle) * math::sin(angle));
}

void crush_with(Experiment& experiment, double e) {
    Scene scene = empty_scene({0, -g});
    add_part(scene, {shape::Polyline{{{-1, -1}, {2, -1}, {2, ceiling}, {-1, ceiling}}, true}}, {"", e, 0, 0});
    Part& flipper = add_part(scene, {flipper_shape}, {"", e, 0, 0});
    flipper.motion = motion::Flip{Side::left, pi / 3, crush_rate, crush_rate};
    add_ball(scene, {0.6, 0.3}, {}, radius);
    const Box inside{{-1.05, -1.05}, {2.05, 0.5}};
    Trial trial(experiment, scene);
    bool escaped = false;
    double fastest = 0, flipper_hits = 0;
    const auto look = [&] {
        const Ball ball = trial.ball(0);
        for (const Event& impact : trial.impacts()) flipper_hits += impact.other.index == 1 ? 1 : 0;
        escaped = escaped || !inside.contains(ball.position);
        fastest = std::max(fastest, length(ball.velocity));
    };
    for (int second = 0; second < 10; ++second) {
        trial.run_to(second + 1.0 / 6, look);
        trial.world().apply(control::Flip{Side::left, true});
        trial.run_to(second + 2.0 / 3, look);
        trial.world().apply(control::Flip{Side::left, false});
    }
    const std::string of = ", e = " + text_of(e);
    experiment.always("escaped" + of, "", 0, escaped ? 1 : 0);
    // No hit adds more than (1 + e) times the speed of the surface, and nothing falls farther than the box.
    const double surface = crush_rate * (flipper_shape.length + flipper_shape.tip_radius);
    const double most =
        (1 + e) * (squeezed_speed() + surface * flipper_hits) + std::sqrt(2 * g * (ceiling + 1));
    experiment.always("fastest" + of, "m/s", 0, fastest, most);
}

}  // namespace

void flipper(Experiment& experiment) {
    const Vec2 raised = from_angle(pi / 3);
    const Swing still{0, 0, 0}, rising{0, pi / 3, 8}, stopping{0, pi / 2, 100}, falling{pi / 3, 0, 3};
    const Hit hits[] = {{"still, base", still, {0, 0.5}, {0, -20}},
                        {"still, tip", still, {1.02, 0.5}, {0, -20}},
                        {"rising, base", rising, {0, 0.5}, {0, -20}},
                        {"rising, middle", rising, {0.5, 0.5}, {0, -20}},
                        {"rising, tip", rising, {1.02, 0.5}, {0, -20}},
                        {"receding", falling, 0.6 * raised + 0.4 * perp(raised), -12 * perp(raised)},
                        {"stopped", stopping, {-0.4, 0.7}, {10, 0}}};
    for (const Hit& hit : hits)
        for (const double e : {1.0, 0.6})
            experiment.attempt(std::string(hit.name), [&] { flipper_hit(experiment, hit, e); });
}

void sensor(Experiment& experiment) {
    for (const double speed : {1.0, 50.0, 1e4})
        experiment.attempt("sensors at " + text_of(speed / radius) + " r/s",
                           [&] { sensors_at(experiment, speed); });
}

void crushed_ball(Experiment& experiment) {
    for (const double e : {1.0, 0.5, 0.0})
        experiment.attempt("crushing, e = " + text_of(e), [&] { crush_with(experiment, e); });
}

}  // namespace flipside::lab
