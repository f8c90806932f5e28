#include "custom/continuous/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "custom/broad_phase/capacity.hpp"

namespace flipside::custom {

namespace {

/// Parts of farthest_approach: what counts as a slow approach also without gravity and rest_speed. Else a
/// ball that a turning part presses into a wedge would have impacts on it without end.
constexpr double least_approach = 0.1;

/// m: of all balls that the scene has or launches.
double smallest_radius(const Scene& scene) {
    double smallest = scene.launcher ? scene.launcher->ball.radius : INFINITY;
    for (const Ball& ball : scene.balls) smallest = std::min(smallest, ball.radius);
    return std::isfinite(smallest) ? smallest : 1;
}

}  // namespace

Simulation::Simulation(Table& of_table, const Layout& of_layout, const SolverSettings& with)
    : table(of_table),
      scene(of_table.scene()),
      layout(of_layout),
      settings(with),
      external{scene.gravity, scene.damping},
      features(features_of(layout.primitives(), scene)),
      ranges(scene.bounds, Cells::width_for(smallest_radius(scene)),
             ranges_of(features, layout.primitives(), table)),
      turnings(scene.parts.size()),
      near_features_(features.size()) {}

void Simulation::reserve(std::size_t most) {
    if (pool_.size() < most) {
        const std::size_t used = particles.size();
        pool_.resize(most);
        particles = std::span(pool_).first(used);
        for (Particle& particle : pool_) particle.motion.path.taylor.reserve(1);
    }
    reserve_for(balls, most);
    if (hot.size() < most) hot.resize(most), near.resize(most);
    cells.reserve(most);
}

void Simulation::start_with(std::span<const Ball> at_start) {
    members = 0;
    balls.assign(at_start.begin(), at_start.end());
    choose_tick();
    particles = std::span(pool_).first(balls.size());
    for (BallIndex i = 0; i < balls.size(); ++i) {
        particles[i] = {.motion = std::move(particles[i].motion)};
        particles[i].motion.fly({}, 0);
        hot[i] = {};
        near[i] = {};
        hot[i].radius = balls[i].radius;
    }
}

/// Chooses the length of a tick by the smallest ball: what approaches slowly must not get deep into it.
void Simulation::choose_tick() {
    double smallest = INFINITY;
    for (const Ball& ball : balls) smallest = std::min(smallest, ball.radius);
    tick_length = 2 * longest_tick;
    for (int halvings = 0; halvings <= most_halvings; ++halvings) {
        tick_length /= 2;
        const double farthest = farthest_approach * smallest;
        slow = std::max(2 * (scene.rest_speed + length(scene.gravity) * tick_length),
                        least_approach * farthest / tick_length);
        if (slow * tick_length <= farthest) break;
    }
}

void advance(Ball& ball, const ConstrainedPath& motion, double time) {
    const Path& path = motion.path;
    const double t = time - path.start;
    const auto [position, velocity] = path.at(time);
    if (motion.roll != Vec2{}) {
        ball.angle += dot(motion.roll, position - ball.position);
        ball.spin = dot(motion.roll, velocity);
    } else if (path.is_taylor()) {
        ball.angle += ball.spin * t + path.taylor[0].spin.integral(t);
        ball.spin += path.taylor[0].spin.change(t);
    } else {
        ball.angle += (ball.spin + motion.spin_rate / 2 * t) * t;
        ball.spin += motion.spin_rate * t;
    }
    ball.position = position;
    ball.velocity = velocity;
}

Vec2 Simulation::true_velocity(BallIndex i, double time) const {
    const Particle& particle = particles[i];
    if (!particle.on_tick_path) return balls[i].velocity;
    const double begin = particle.motion.path.start, duration = particle.motion.until - begin;
    if (hot[i].creeps) return time > begin ? particle.velocity_end : particle.velocity_begin;
    const double part = duration > 0 ? (time - begin) / duration : 1;  // 0 at the end of the window
    return particle.velocity_begin + part * (particle.velocity_end - particle.velocity_begin);
}

Ball Simulation::ball_at(BallIndex i, double time) const {
    Ball ball = balls[i];
    read(i, time, ball);
    return ball;
}

void Simulation::read(BallIndex i, double time, Ball& ball) const {
    const Ball& begin = balls[i];
    if (hot[i].ballistic && !hot[i].in_island && !begin.asleep && ball.number == begin.number) {
        // The same as below from fewer cache lines.
        const auto [position, velocity] = flying_at(hot[i], time);
        ball.position = position;
        ball.velocity = velocity;
        ball.angle = begin.angle + begin.spin * (time - hot[i].start);
        ball.spin = begin.spin;
        ball.asleep = false;
        return;
    }
    ball = begin;
    if (ball.asleep) return;
    advance(ball, particles[i].motion, time);
    if (particles[i].on_tick_path) ball.velocity = true_velocity(i, time);
}

std::span<const FeatureIndex> Simulation::features_near(const Box& box) {
    const std::span<const FeatureIndex> listed = ranges.near(box);
    record->statistics.pair_tests += listed.size();
    // Each is written, and stays if it overlaps: a branch would be mispredicted.
    std::size_t count = 0;
    for (const FeatureIndex f : listed) {
        near_features_[count] = f;
        count += static_cast<std::size_t>(overlap(box, ranges[f]));
    }
    return std::span(near_features_).first(count);
}

double Simulation::next_on_grid(double time, double length) const {
    double left = std::ceil((end - time) / length) - 1;
    while (left > 0 && end - left * length <= time + 1e-3 * tick_length) --left;
    return left > 0 ? end - left * length : end;
}

void Simulation::join_island(BallIndex i, double time) {
    Particle& particle = particles[i];
    if (balls[i].asleep || hot[i].lost || hot[i].in_island) return;
    if (!any_in_island) tick_at = next_tick(time);
    hot[i].in_island = any_in_island = true;
    std::uint64_t& counted = record->statistics.handed_over;
    counted = std::max(counted, ++members);
    particle.on_tick_path = false;
    particle.last_loaded = time;
}

}  // namespace flipside::custom
