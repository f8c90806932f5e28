// Members of contact islands: which balls are, and the paths that they follow between ticks.

#include <algorithm>
#include <cmath>

#include "custom/islands/islands.hpp"

namespace flipside::custom {

namespace {

/// Contacts with balls in a row, each within a tick of the one before, that show an inelastic collapse.
constexpr int most_hits = 20;

/// A ball at 7 m/s is frozen for at most 1/7,680 s, in which it would move 0.9 mm.
constexpr int most_freeze_halvings = 5;

/// Ticks without a load after which a ball leaves its island.
constexpr double longest_unloaded = 2.5;

}  // namespace

/// Finds the members of islands at the start of the window: balls with a contact force at the end of the
/// previous window, balls in resting contact, and their neighbours in slow contact. Balls that deeply overlap
/// each other are members too: in free flight they would never separate.
void Islands::find_members() {
    members_.clear();
    const auto join_once = [&](BallIndex i) {
        if (sim_.balls[i].asleep || sim_.hot[i].in_island) return;
        sim_.join_island(i, 0);
        members_.push_back(i);
    };
    for (const ContactForce& force : sim_.table.memory().forces) {
        const Ball *a = find_ball(sim_.balls, force.a), *b = find_ball(sim_.balls, force.b);
        if (a == nullptr || b == nullptr) continue;
        const auto i = static_cast<BallIndex>(a - sim_.balls.data()),
                   j = static_cast<BallIndex>(b - sim_.balls.data());
        ball_forces_.add({i, j, force.normal, force.tangent});
        join_once(i), join_once(j);
    }
    ball_forces_.merge();
    for (BallIndex i = 0; i < sim_.particles.size(); ++i) {
        if (sim_.balls[i].asleep) continue;
        sim_.cells.query_neighbours(i, [&](BallIndex j) {
            ++sim_.record->statistics.pair_tests;
            if ((j > i || sim_.balls[j].asleep) && in_resting_contact(i, j, false))
                join_once(i), join_once(j);
        });
    }
    sim_.cells.flood_fill(members_, [&](BallIndex i, BallIndex j) {
        if (!sim_.hot[j].in_island && in_resting_contact(i, j, true)) join_once(j);
    });
}

/// Whether two balls are in resting contact, or overlap deeply. `beside_island`: one of them is in an island.
bool Islands::in_resting_contact(BallIndex i, BallIndex j, bool beside_island) const {
    const Ball &a = sim_.balls[i], &b = sim_.balls[j];
    const Vec2 between = a.position - b.position;
    const double gap = touch_distance * std::min(a.radius, b.radius);
    const double reach = a.radius + b.radius + gap;
    if (length_squared(between) > reach * reach || !layers_meet(a, b)) return false;
    const double out = a.radius + b.radius - deep_overlap * std::min(a.radius, b.radius);
    if (length_squared(between) < out * out) return true;
    const double apart = dot(a.velocity - b.velocity, unit(between));
    if (beside_island) return std::abs(apart) <= sim_.scene.rest_speed;
    const double closing = closing_acceleration(i, j, 0);
    if (closing <= 1e-9 * length(sim_.scene.gravity) || apart < -sim_.scene.rest_speed) return false;
    return apart <= 0 || apart * apart <= 2 * closing * gap;
}

double Islands::closing_acceleration(BallIndex i, BallIndex j, double time) const {
    const Path &a = sim_.particles[i].motion.path, &b = sim_.particles[j].motion.path;
    const Vec2 between = a.position(time) - b.position(time), n = unit(between);
    const double across = cross(n, a.velocity(time) - b.velocity(time));
    return -dot(a.acceleration(time) - b.acceleration(time), n) - across * across / length(between);
}

void Islands::solve_jammed(BallIndex first, double time) {
    members_.clear();
    const auto mark_jammed = [&](BallIndex i) {
        if (sim_.balls[i].asleep || sim_.hot[i].lost || sim_.particles[i].jammed) return;
        sim_.join_island(i, time);
        sim_.particles[i].jammed = true;
        members_.push_back(i);
    };
    mark_jammed(first);
    const auto place = [&](BallIndex i) { return sim_.particles[i].motion.path.position(time); };
    sim_.cells.flood_fill(members_, [&](BallIndex i, BallIndex j) {
        const Ball &ball = sim_.balls[i], &other = sim_.balls[j];
        const double reach = (1 + resting_distance) * (ball.radius + other.radius);
        if (length(place(j) - place(i)) <= reach && layers_meet(ball, other)) mark_jammed(j);
    });
    tick(time);
}

double Islands::longest_freeze(BallIndex i, double time) const {
    const Ball ball = sim_.ball_at(i, time);
    double longest = sim_.tick_length;
    for (int halvings = 0; halvings < most_freeze_halvings; ++halvings) {
        if (longest * length(ball.velocity) <= farthest_approach * ball.radius) break;
        longest /= 2;
    }
    return longest;
}

void Islands::freeze(BallIndex i, double time, double longest) {
    sim_.advance_to(i, time);
    sim_.join_island(i, time);
    sim_.hot[i].creeps = false;
    sim_.tick_at = std::min(sim_.tick_at, sim_.next_on_grid(time, longest));
    stay_frozen(i, sim_.balls[i].velocity, time);
    predictions_.predict(i, time);
    // It predicts no events of its own, so its neighbours must predict theirs with it.
    sim_.cells.query_neighbours(i, [&](BallIndex j) {
        if (!sim_.particles[j].frozen) predictions_.predict(j, time);
    });
}

void Islands::stay_frozen(BallIndex i, Vec2 velocity, double time) {
    Particle& particle = sim_.particles[i];
    particle.frozen = true;
    particle.velocity_begin = particle.velocity_end = velocity;
    start_member_path(i, {sim_.balls[i].position, {}, {}, 0}, time, sim_.tick_at);
}

/// Starts the path of a member until its next tick.
void Islands::start_member_path(BallIndex i, const Flight& flight, double time, double until) {
    Particle& particle = sim_.particles[i];
    sim_.any_in_island = particle.on_tick_path = true;
    particle.separated_from = nullptr;
    paths_.start_flight(i, flight, time);
    particle.motion.until = until;
}

/// Starts the path of a member over a tick: the parabola under gravity and drag that ends at the solved
/// position. Since all balls then have the same acceleration, the relative motion of any two is straight. A
/// member without a load flies freely, and leaves the island after some ticks.
void Islands::start_tick_path(BallIndex i, double time, const ContactSolver::Body& body) {
    Particle& particle = sim_.particles[i];
    const Ball& ball = sim_.balls[i];
    if (time - particle.last_loaded > longest_unloaded * sim_.tick_length) {
        sim_.leave_island(i);
        sim_.balls[i].position = body.position;
        return paths_.start_path(i, time);
    }
    const double duration = sim_.tick_at - time;
    // A velocity change greater than that of gravity applies at once, so that an impact within the tick does
    // not see the old velocity.
    const bool stopped =
        length(body.velocity - ball.velocity) > 2 * length(sim_.scene.gravity) * sim_.tick_length;
    particle.velocity_begin = stopped ? body.velocity : ball.velocity;
    particle.velocity_end = body.velocity;
    const TimeInterval interval(sim_.external.drag, duration);
    const Vec2 thrown =
        particle.loads == 0
            ? ball.velocity
            : (duration * body.velocity - interval.fallen * sim_.external.gravity) / interval.shrunk;
    start_member_path(i, {body.position, thrown, sim_.external.gravity, sim_.external.drag}, time,
                      sim_.tick_at);
    particle.motion.spin_rate = (body.rim_speed / ball.radius - ball.spin) / duration;
}

/// Starts the path of a creeping member: uniform motion over a long tick. At its first instant the ball still
/// has its old velocity, so that Sleep sees the change.
void Islands::start_creep_path(BallIndex i, double time, double until, const ContactSolver::Body& body) {
    Particle& particle = sim_.particles[i];
    particle.velocity_begin = sim_.balls[i].velocity;
    particle.velocity_end = body.velocity;
    start_member_path(i, {body.position, body.velocity, {}, 0}, time, until);
    particle.motion.spin_rate = (body.rim_speed / body.radius - sim_.balls[i].spin) / (until - time);
    sim_.hot[i].creeps = true;
}

bool Islands::note_hit(BallIndex i, BallIndex j, double approach, double time) const {
    for (Particle* particle : {&sim_.particles[i], &sim_.particles[j]}) {
        particle->hits = time - particle->last_hit < sim_.tick_length ? particle->hits + 1 : 0;
        particle->last_hit = time;
    }
    return approach <= sim_.slow && std::min(sim_.particles[i].hits, sim_.particles[j].hits) >= most_hits;
}

}  // namespace flipside::custom
