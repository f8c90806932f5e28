// Predicts the next event of a ball on its path, and puts it into the queue.

#include <algorithm>
#include <functional>

#include "custom/continuous/continuous_solver.hpp"
#include "custom/engine.hpp"
#include "world/gate.hpp"
#include "world/limits.hpp"
#include "world/refusal.hpp"

namespace flipside::custom {

namespace {

/// Radii: a ball has left a sensor or gate when it is this far outside.
constexpr double sense_gap = gate_clearance;
/// Radii: least distance that a ball moves between two evaluations of its distance from a sensor.
constexpr double sense_step = 1e-2;

}  // namespace

/// Whether the feature does not collide with the ball now.
bool ContinuousSolver::ignores(const Feature& feature, const Ball& ball) const {
    return feature.sensor || table_.parts()[feature.part].down || !layers_meet(ball, feature) ||
           (feature.gate && inside(ball.number, feature.part));
}

/// Lists a ball in the cell in which it is now, and predicts its events with the neighbours there.
void ContinuousSolver::enter_cell(BallIndex i) {
    const double time = movers_[i].cell_exit;
    const Cells::Cell before = cells_[i];
    cells_.insert(i, movers_[i].motion.path.position(time));
    update_swept_bounds(i, time);
    if (movers_[i].cell_exit <= time) movers_[i].cell_exit = never_touch;
    predict_loss(i, time);
    predict_features(i, time);
    cells_.query_new_neighbours(i, before, [&](BallIndex j) { predict_ball(i, j, time); });
    schedule(i);
}

void ContinuousSolver::offer(BallIndex i, double time, EventType next, std::uint32_t partner,
                             std::uint32_t partner_version) {
    Mover& mover = movers_[i];
    if (!(time <= mover.next_time)) return;
    if (time == mover.next_time && order_of(i, next, partner) >= order_of(i, mover.next, mover.partner))
        return;
    mover.next_time = time;
    mover.next = next;
    mover.partner = partner;
    mover.partner_version = partner_version;
}

std::uint64_t ContinuousSolver::order_of(BallIndex i, EventType next, std::uint32_t partner) {
    constexpr std::uint64_t meets_ball = std::uint64_t{1} << 63;
    if (next == EventType::none) return ~std::uint64_t{0};
    if (next != EventType::ball) return std::uint64_t{i} << 32;
    return meets_ball | std::uint64_t{std::min(i, partner)} << 32 | std::max(i, partner);
}

/// Predicts the next event of a ball on its path.
void ContinuousSolver::predict(BallIndex i, double time) {
    near_[i] = {};
    predict_with(i, time,
                 [&] { cells_.query_neighbours(i, [&](BallIndex j) { predict_ball(i, j, time); }); });
}

/// The same for several balls whose paths all start now. Each pair of them is predicted once.
void ContinuousSolver::predict_together(std::span<const BallIndex> balls, double time) {
    ++batch_;
    for (const BallIndex i : balls) near_[i] = {};
    for (const BallIndex i : balls)
        predict_with(i, time, [&] {
            hot_[i].batch = batch_;
            cells_.query_neighbours(i, [&](BallIndex j) {
                if (hot_[j].batch != batch_) predict_ball(i, j, time);
            });
        });
}

void ContinuousSolver::predict_with(BallIndex i, double time, auto&& each_other) {
    Mover& mover = movers_[i];
    mover.next = EventType::none;
    mover.next_time = after_end_;
    if (hot_[i].lost || bodies_[i].asleep || mover.frozen) return next_events_.set(i, INFINITY, 0);
    if (!mover.on_tick_path) offer(i, mover.motion.until, EventType::path_end);
    predict_loss(i, time);
    predict_features(i, time);
    each_other();
    schedule(i);
}

void ContinuousSolver::schedule(BallIndex i) {
    const Mover& mover = movers_[i];
    if (mover.cell_exit <= mover.next_time)
        return next_events_.set(i, mover.cell_exit, std::uint64_t{i} << 32);
    if (mover.next == EventType::none) return next_events_.set(i, INFINITY, 0);
    next_events_.set(i, mover.next_time, order_of(i, mover.next, mover.partner));
}

/// Whether the ball reaches this feature only by sliding to the end of the face on which it rests. That is no
/// impact, but an overlap of one rounding u would look like one, at an angle of √u.
bool ContinuousSolver::slides_to(const Mover& mover, const Ball& ball, const Feature& feature) const {
    if (mover.resting_on == nullptr) return false;
    const auto is_posed = [&](PartIndex part) {
        return !turnings_[part].still() || turnings_[part].begin.angle != 0;
    };
    const PartIndex own = mover.resting_on->part;
    if (feature.part != own && (is_posed(feature.part) || is_posed(own))) return false;
    const Pose pose = turnings_[own].pose(mover.motion.path.start);
    const Vec2 normal = closest_point(*mover.resting_on, pose.undo(ball.position), ball.radius).normal;
    return continues_in(*mover.resting_on, normal, feature);
}

/// Whether the ball flies along a face and this static feature lies below that face.
bool ContinuousSolver::above_tangent_face(const Mover& mover, const Feature& feature, const Pose& pose) {
    if (!mover.tangent_faces.any()) return false;
    return mover.tangent_faces.above(pose.angle == 0 ? feature : posed(feature, pose));
}

void ContinuousSolver::predict_features(BallIndex i, double time) {
    Mover& mover = movers_[i];
    near_[i].part = mover.resting_on != nullptr;
    const std::span<const FeatureIndex> near = features_near(i, mover.bounds);
    if (near.empty() && inside_.empty() && table_.blocked().empty()) return;
    const Ball& ball = bodies_[i];
    const Path& path = mover.motion.path;
    bool any_sensor = false;
    // Bound on the distance of the path from its chord, with a margin greater than touch_distance.
    const double end = std::min({end_, mover.motion.until, mover.cell_exit}), duration = end - time;
    const Vec2 from = time == path.start ? path.flight.position : path.position(time);
    const Vec2 to = path.position(end);
    const double sag = path.max_acceleration(end) * duration * duration / 8 + clearance_margin(ball);
    for (const FeatureIndex f : near) {
        if (!overlap(mover.bounds, ranges_[f])) continue;
        const Feature& feature = features_[f];
        any_sensor = any_sensor || feature.sensor;
        if (&feature == mover.resting_on || ignores(feature, ball)) continue;
        const Turning& turning = turnings_[feature.part];
        if (turning.still() && !ball.asleep && turning.begin.angle == 0 &&
            clear_of(feature, from, to, ball.radius, sag))
            continue;
        near_[i].part = true;
        if (slides_to(mover, ball, feature)) continue;
        if (hot_[i].in_island && rests_on(i, feature, turning.pose(time), time)) continue;
        if (turning.still() && above_tangent_face(mover, feature, turning.begin)) continue;
        ++record_->statistics.narrow_tests;
        const double last = std::min({mover.next_time, end_, mover.on_tick_path ? mover.motion.until : end_});
        offer(i, time_of_impact(feature, turning, path, ball.radius, time, last, &search_steps_),
              EventType::feature, f);
    }
    if (any_sensor || !inside_.empty() || !table_.blocked().empty()) predict_sensors(i, time, near);
}

/// Predicts when a ball enters or leaves a sensor, or leaves a gate, if that is before all else that is
/// predicted so far: a search for more would be repeated after that event.
void ContinuousSolver::predict_sensors(BallIndex i, double time, std::span<const FeatureIndex> near) {
    const Ball& ball = bodies_[i];
    const Mover& mover = movers_[i];
    const auto predict_sensor = [&](PartIndex part, bool inside) {
        const double last = std::min({end_, mover.motion.until, mover.cell_exit, mover.next_time});
        offer(i, sense_time(part, ball, mover.motion.path, time, last, inside), EventType::sensor, part);
    };
    for (auto in = std::ranges::lower_bound(inside_, ball.number, {}, &Sensed::ball);
         in != inside_.end() && in->ball == ball.number; ++in)
        predict_sensor(in->sensor, true);
    for (const Blocked& blocked : table_.blocked())
        if (blocked.ball == ball.number) predict_sensor(blocked.gate, true);
    PartIndex sensed = ~0U;
    for (const FeatureIndex f : near) {
        const Feature& feature = features_[f];
        if (!feature.sensor || feature.part == sensed || !overlap(mover.bounds, ranges_[f]) ||
            !layers_meet(ball, feature) || inside(ball.number, feature.part))
            continue;
        sensed = feature.part;
        predict_sensor(sensed, false);
    }
}

/// Predicts the impact of two balls. The result does not depend on which of them is predicted, nor when.
void ContinuousSolver::predict_ball(BallIndex i, BallIndex j, double time) {
    const HotState &a = hot_[i], &b = hot_[j];
    ++record_->statistics.pair_tests;
    if (b.lost) return;
    if (a.ballistic && b.ballistic) return predict_flying(i, j, time);
    if (!layers_meet(bodies_[i], bodies_[j])) return;
    note_near(i, j, -INFINITY, -INFINITY);  // at any time
    if (a.creeps && (b.creeps || bodies_[j].asleep)) return;
    if (a.in_island && (b.in_island || bodies_[j].asleep) && in_slow_contact(i, j, time)) return;
    const Mover &mover = movers_[i], &other = movers_[j];
    const double from = std::max(a.start, b.start);
    const double until = std::min({end_, mover.motion.until, other.motion.until});
    if (until < from) return;
    ++record_->statistics.narrow_tests;
    const double met = time_of_impact(mover.motion.path, other.motion.path, a.radius + b.radius, from, until,
                                      &search_steps_);
    offer(i, std::max(met, time), EventType::ball, j, b.version);
}

/// The same for two balls in ballistic flight. Their relative motion is straight.
void ContinuousSolver::predict_flying(BallIndex i, BallIndex j, double time) {
    const HotState &a = hot_[i], &b = hot_[j];
    const double from = std::max(a.start, b.start);
    const auto at = [&](const HotState& hot) {
        const double t = from - hot.start;
        if (t == 0) return Path::Motion{hot.position, hot.velocity};
        const TimeInterval interval(external_.drag, t);
        const Flight flight{hot.position, hot.velocity, external_.gravity, external_.drag};
        return Path::Motion{flight.position + flight.displacement(interval), flight.velocity_after(interval)};
    };
    const auto [p, v] = at(a);
    const auto [q, u] = at(b);
    const Vec2 between = p - q, relative = v - u;
    const double approach = -dot(between, relative);
    // Most pairs separate, or pass each other at a distance: they are rejected without a square root.
    constexpr double margin = 1e-3;  // of the sum of radii; greater than touch_distance
    constexpr double sure = 1e-9;    // greater than all rounding here
    const double reach = a.radius + b.radius, wide = (1 + margin) * reach;
    const double apart = length_squared(between) - wide * wide;
    if (apart > 0 && !(approach > 0)) return;
    if (apart > 0 && approach * approach * (1 + sure) < length_squared(relative) * apart) return;
    if (!(approach > 0)) {
        const double left = approach < 0 ? (1 + sure) * apart / (2 * approach) : INFINITY;
        return note_near(i, j, from + drag_time(external_.drag, left), INFINITY);
    }
    const double soonest = from + (1 - sure) * std::max(apart, 0.0) / (2 * approach);
    note_near(i, j, -INFINITY, soonest);
    if (soonest > movers_[i].next_time) return;
    if (a.in_island && b.in_island && approach <= slow_ * length(between)) return;
    if (!layers_meet(bodies_[i], bodies_[j])) return;
    ++record_->statistics.narrow_tests;
    const double e = straight_touch(between, relative, reach, gap_rounding(p, q, reach));
    const double met = from + drag_time(external_.drag, e);
    if (met <= std::min(movers_[i].motion.until, movers_[j].motion.until))
        offer(i, std::max(met, time), EventType::ball, j, b.version);
}

/// Notes that two balls may be within touch_distance of each other until one time, and from another on.
void ContinuousSolver::note_near(BallIndex i, BallIndex j, double until, double from) {
    for (NearTimes* near : {&near_[i], &near_[j]}) {
        near->until = std::max(near->until, until);
        near->from = std::min(near->from, from);
    }
}

/// Predicts when the centre of the ball leaves the bounds of the scene.
void ContinuousSolver::predict_loss(BallIndex i, double time) {
    const Ball& ball = bodies_[i];
    Mover& mover = movers_[i];
    const Box& bounds = scene_.bounds;
    if (bounds.contains(mover.bounds.min) && bounds.contains(mover.bounds.max)) return;
    const auto& reported = table_.reported_lost();
    if (std::ranges::find(reported, ball.number) != reported.end()) return;
    const double last = std::min({end_, mover.motion.until, mover.next_time, mover.cell_exit});
    offer(i, first_exit(mover.motion.path, bounds, time, last), EventType::leave_bounds);
}

/// Time at which a ball enters a sensor, or leaves a sensor or gate; never_touch if not before `last`, which
/// the search passes by one step at most. Conservative advancement with a bound on
/// the speed, in steps of at least sense_step, and then first_zero(). A contact shallower than sense_step may
/// be missed.
double ContinuousSolver::sense_time(PartIndex part, const Ball& ball, const Path& path, double time,
                                    double last, bool inside) const {
    const Turning& turning = turnings_[part];
    const double own = path.max_speed(end_), w = std::abs(turning.rate);
    const double out = std::max(sense_gap * ball.radius, 4 * gap_rounding(ball.position, ball.radius));
    const auto left_at = [&](double t) {
        const double distance = distance_to(part, path.position(t), ball.radius, turning.pose(t));
        return inside ? out - distance : distance;
    };
    const double far = w == 0 ? 0 : length(path.position(time) - turning.begin.pivot) + own * (end_ - time);
    const double speed = own + w * far;
    const double error = std::max(gap_rounding(ball.position, ball.radius) / speed, 4 * 0x1p-53 * end_);
    double before = time, left_before = 0;
    constexpr int most_steps = 100'000;  // some hundred for a ball that rolls along the border of a sensor
    double t = time;
    for (int step = 0; step < most_steps; ++step) {
        const double left = left_at(t);
        if (left <= 0) return first_zero(left_at, before, left_before, t, left, error);
        before = t;
        left_before = left;
        if (t >= last) return never_touch;
        t = std::min(end_, t + std::max(left, sense_step * ball.radius) / speed);
    }
    refuse_search(engine_name, ball.number, Other::part(part), start_ + time, scene_);
}

}  // namespace flipside::custom
