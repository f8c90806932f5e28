#include "lab/cases/stability_map.hpp"

#include <algorithm>
#include <ostream>

#include "lab/files/csv.hpp"
#include "lab/session/run.hpp"
#include "world/refusal.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {

namespace {

constexpr Box walls{{-1, 0}, {1, 3}};
constexpr double ball_radius = 0.1;  // m
constexpr double seconds = 2;
constexpr double most_energy_gain = 0.01, most_overlap = 0.1;

Scene thrown_at(double mass_ratio, double speed) {
    Scene scene = empty_scene({0, -9.81});
    scene.rest_speed = 0;
    scene.bounds = {{-1e6, -1e6}, {1e6, 1e6}};
    // e = √½ of each of two surfaces.
    const double e = std::sqrt(0.5);
    scene.materials[0].restitution = e;
    add_part(scene,
             {shape::Polyline{{walls.min, {walls.max.x, 0}, walls.max, {walls.min.x, walls.max.y}}, true}},
             {"", e, 0, 0});
    add_ball(scene, {0, ball_radius}, {}, ball_radius, 1);
    add_ball(scene, {0.01, 1.5}, {0, -speed * ball_radius}, ball_radius, mass_ratio);
    return scene;
}

/// Fills in what happened; the failure is the first one.
void run_point(const Contender& contender, StabilityPoint& point) {
    Session session(std::make_shared<const Scene>(thrown_at(point.mass_ratio, point.speed)),
                    *contender.engine, contender.settings);
    const double first = energy(session.world(), session.scene());
    const Timeline timeline(0, seconds, point.dt);
    for (std::uint64_t k = 0; k < timeline.steps(); ++k) {
        session.step(timeline.length(k));
        check_finite(session, session.world().time());
        const auto balls = session.world().balls();
        const bool inside = balls.size() == 2 && std::ranges::all_of(balls, [](const Ball& ball) {
                                return walls.contains(ball.position);
                            });
        if (!inside) {
            point.failure = "escape";
            return;
        }
        point.energy_gain = std::max(point.energy_gain, energy(session.world(), session.scene()) / first - 1);
    }
    for (const Contact& contact : session.world().contacts())
        point.overlap = std::max(point.overlap, -contact.separation / ball_radius);
    if (point.energy_gain > most_energy_gain)
        point.failure = "energy";
    else if (point.overlap > most_overlap)
        point.failure = "overlap";
}

}  // namespace

std::vector<StabilityPoint> stability_map(const Contender& contender, std::span<const double> steps,
                                          const std::function<void(double)>& watch) {
    std::vector<StabilityPoint> points;
    for (const double mass_ratio : map_mass_ratios)
        for (const double speed : map_speeds)
            for (const double dt : steps) points.push_back({mass_ratio, speed, dt, "", -1, 0});
    for (std::size_t i = 0; i < points.size(); ++i) {
        try {
            run_point(contender, points[i]);
        } catch (const NotANumber&) {
            points[i].failure = "not a number";
        } catch (const Refusal&) {
            points[i].failure = "refused";
        }
        if (watch) watch(static_cast<double>(i + 1) / static_cast<double>(points.size()));
    }
    return points;
}

void write_stability(std::ostream& out, const Contender& contender, std::span<const StabilityPoint> points) {
    out << stability_header;
    for (const StabilityPoint& point : points)
        CsvRow()
            .add(contender.engine->name)
            .add(point.mass_ratio)
            .add(point.speed)
            .add(point.dt)
            .add(point.failure.empty() ? 1.0 : 0.0)
            .add(point.failure)
            .add(point.energy_gain)
            .add(point.overlap)
            .write(out);
}

}  // namespace flipside::lab
