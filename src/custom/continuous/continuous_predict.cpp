#include <algorithm>
#include <functional>

#include "custom/continuous/continuous_solver.hpp"
#include "custom/continuous/first_exit.hpp"
#include "custom/engine.hpp"
#include "world/gate.hpp"
#include "world/limits.hpp"
#include "world/refusal.hpp"

namespace flipside::custom {

namespace {

/// How far a ball must be out of a sensor or gate to have left it, in radii.
constexpr double sense_gap = gate_clearance;
/// The least way between two looks for a sensor's border, in radii.
constexpr double sense_step = 1e-2;

/// Where f, above 0 at a and not at b, goes through 0, to within `error` behind it: by chords, and where the
/// same end is kept twice its value counts half (the Illinois algorithm; Dowell and Jarratt 1971, "A modified
/// regula falsi method for computing the root of an equation").
/// After `most_chords`, which about ten do without, by halves: at most 1,100 more.
double first_zero(auto&& f, double a, double f_a, double b, double f_b, double error) {
    constexpr int most_chords = 100;
    int kept = 0;  // how often in a row: b above 0, a below
    for (int step = 0; b - a > error; ++step) {
        if (a + (b - a) / 2 <= a || a + (b - a) / 2 >= b) break;
        const double chord = a + (b - a) * (step < most_chords ? f_a / (f_a - f_b) : 0.5);
        const double middle = std::max(a + error / 2, std::min(chord, b - error / 2));
        const double value = f(middle);
        if (value <= 0) {
            b = middle, f_b = value;
            kept = std::min(kept, 0) - 1;
            if (kept < -1) f_a /= 2;
        } else {
            a = middle, f_a = value;
            kept = std::max(kept, 0) + 1;
            if (kept > 1) f_b /= 2;
        }
    }
    return b;
}

}  // namespace

/// Whether the feature lets the ball through now.
bool ContinuousSolver::ignores(const Feature& feature, const Ball& ball) const {
    return feature.sensor || table_->parts()[feature.part].down || !layers_meet(ball, feature) ||
           (feature.gate && inside(ball.number, feature.part));
}

/// A ball is listed in the cell in which it is now, and meets whoever is near there.
void ContinuousSolver::enter_cell(BallIndex i) {
    const double time = movers_[i].horizon;
    const Cells::Cell before = cells_[i];
    cells_.put(i, movers_[i].way.path.position(time));
    cover_way(i, time);
    if (movers_[i].horizon <= time) movers_[i].horizon = never_touch;
    predict_loss(i, time);
    predict_features(i, time);
    cells_.each_newly_near(i, before, [&](BallIndex j) { predict_ball(i, j, time); });
    schedule(i);
}

void ContinuousSolver::offer(BallIndex i, double time, Next next, std::uint32_t met,
                             std::uint32_t met_changes) {
    Mover& mover = movers_[i];
    if (!(time <= mover.next_time)) return;
    if (time == mover.next_time && order_of(i, next, met) >= order_of(i, mover.next, mover.met)) return;
    mover.next_time = time;
    mover.next = next;
    mover.met = met;
    mover.met_changes = met_changes;
}

std::uint64_t ContinuousSolver::order_of(BallIndex i, Next next, std::uint32_t met) {
    constexpr std::uint64_t meets_ball = std::uint64_t{1} << 63;
    if (next == Next::nothing) return ~std::uint64_t{0};
    if (next != Next::ball) return std::uint64_t{i} << 32;
    return meets_ball | std::uint64_t{std::min(i, met)} << 32 | std::max(i, met);
}

/// Finds the next event of a ball on its path and notes it.
void ContinuousSolver::predict(BallIndex i, double time) {
    flying_[i].near_ball = false;
    predict_with(i, time, [&] { cells_.each_near(i, [&](BallIndex j) { predict_ball(i, j, time); }); });
}

/// The same for balls that all set out now. Of two of them only the first looks for the other.
void ContinuousSolver::predict_together(std::span<const BallIndex> balls, double time) {
    ++batch_;
    for (const BallIndex i : balls) flying_[i].near_ball = false;
    for (const BallIndex i : balls)
        predict_with(i, time, [&] {
            flying_[i].batch = batch_;
            cells_.each_near(i, [&](BallIndex j) {
                if (flying_[j].batch != batch_) predict_ball(i, j, time);
            });
        });
}

void ContinuousSolver::predict_with(BallIndex i, double time, auto&& each_other) {
    Mover& mover = movers_[i];
    mover.next = Next::nothing;
    mover.next_time = after_end_;
    if (!flying_[i].meets || bodies_[i].asleep || mover.waits) return next_events_.set(i, INFINITY, 0);
    if (!mover.hops) offer(i, mover.way.until, Next::look_again);
    predict_loss(i, time);
    predict_features(i, time);
    each_other();
    schedule(i);
}

void ContinuousSolver::schedule(BallIndex i) {
    const Mover& mover = movers_[i];
    if (mover.horizon <= mover.next_time) return next_events_.set(i, mover.horizon, std::uint64_t{i} << 32);
    if (mover.next == Next::nothing) return next_events_.set(i, INFINITY, 0);
    next_events_.set(i, mover.next_time, order_of(i, mover.next, mover.met));
}

/// Whether the ball comes to this feature only by sliding to the end of what holds it. That is no touch, but
/// rounding would make one of it, at an angle of its square root.
bool ContinuousSolver::slides_to(const Mover& mover, const Ball& ball, const Feature& feature) const {
    if (mover.resting_on == nullptr) return false;
    const auto is_posed = [&](PartIndex part) {
        return !turnings_[part].still() || turnings_[part].begin.angle != 0;
    };
    const PartIndex own = mover.resting_on->part;
    if (feature.part != own && (is_posed(feature.part) || is_posed(own))) return false;
    const Pose pose = turnings_[own].pose(mover.way.path.start);
    const Vec2 normal = closest_point(*mover.resting_on, pose.undo(ball.position), ball.radius).normal;
    return ends_in(*mover.resting_on, normal, feature);
}

/// Whether the ball flies along a face below which this still feature lies.
bool ContinuousSolver::glides_over(const Mover& mover, const Feature& feature, const Pose& pose) {
    if (!mover.glides.any()) return false;
    return mover.glides.above(pose.angle == 0 ? feature : posed(feature, pose));
}

void ContinuousSolver::predict_features(BallIndex i, double time) {
    Mover& mover = movers_[i];
    mover.near_part = mover.resting_on != nullptr;
    if (mover.near.list().empty() && inside_.empty() && table_->blocked().empty()) return;
    const Ball& ball = bodies_[i];
    const Path& path = mover.way.path;
    for (auto in = std::ranges::lower_bound(inside_, ball.number, {}, &Sensed::ball);
         in != inside_.end() && in->ball == ball.number; ++in)
        offer(i, sense_time(in->sensor, ball, path, time, true), Next::sense, in->sensor);
    for (const Blocked& blocked : table_->blocked())
        if (blocked.ball == ball.number)
            offer(i, sense_time(blocked.gate, ball, path, time, true), Next::sense, blocked.gate);
    PartIndex sensed = ~0U;
    // How far from the chord of its path the ball can get, with a margin over what counts as touch.
    const double end = std::min({dt_, mover.way.until, mover.horizon}), flies = end - time;
    const Vec2 from = time == path.start ? path.flight.position : path.position(time);
    const Vec2 to = path.position(end);
    const double sag = path.max_acceleration(end) * flies * flies / 8 + clearance_margin(ball);
    for (const FeatureIndex f : mover.near.list()) {
        if (!overlap(mover.bounds, ranges_[f])) continue;
        const Feature& feature = features_[f];
        if (feature.sensor && inside(ball.number, feature.part)) continue;
        if (feature.sensor) {
            if (feature.part == sensed || !layers_meet(ball, feature)) continue;
            sensed = feature.part;
            offer(i, sense_time(sensed, ball, path, time, false), Next::sense, sensed);
            continue;
        }
        if (&feature == mover.resting_on || ignores(feature, ball)) continue;
        const Turning& turning = turnings_[feature.part];
        if (turning.still() && !ball.asleep && turning.begin.angle == 0 &&
            clear_of(feature, from, to, ball.radius, sag))
            continue;
        mover.near_part = true;
        if (slides_to(mover, ball, feature)) continue;
        if (flying_[i].pressed && rests_on(i, feature, turning.pose(time), time)) continue;
        if (turning.still() && glides_over(mover, feature, turning.begin)) continue;
        ++record_->statistics.narrow_tests;
        const double last = std::min({mover.next_time, dt_, mover.hops ? mover.way.until : dt_});
        offer(i, time_of_impact(feature, turning, path, ball.radius, time, last, &search_steps_),
              Next::feature, f);
    }
}

/// Offers when two balls meet: the same from either side, whenever it is asked, so that it does not matter
/// who asks.
void ContinuousSolver::predict_ball(BallIndex i, BallIndex j, double time) {
    const Flying &a = flying_[i], &b = flying_[j];
    ++record_->statistics.pair_tests;
    if (!b.meets) return;
    if (a.freely && b.freely) return predict_flying(i, j, time);
    if (!layers_meet(bodies_[i], bodies_[j])) return;
    flying_[i].near_ball = flying_[j].near_ball = true;
    if (a.creeps && (b.creeps || bodies_[j].asleep)) return;
    if (a.pressed && (b.pressed || bodies_[j].asleep) && in_slow_touch(i, j, time)) return;
    const Mover &mover = movers_[i], &other = movers_[j];
    const double from = std::max(a.start, b.start);
    const double until = std::min({dt_, mover.way.until, other.way.until});
    if (until < from) return;
    ++record_->statistics.narrow_tests;
    const double met =
        time_of_impact(mover.way.path, other.way.path, a.radius + b.radius, from, until, &search_steps_);
    offer(i, std::max(met, time), Next::ball, j, b.changes);
}

/// Two that fly under one gravity and one drag: seen from one another they move straight.
void ContinuousSolver::predict_flying(BallIndex i, BallIndex j, double time) {
    const Flying &a = flying_[i], &b = flying_[j];
    const double from = std::max(a.start, b.start);
    const auto at = [&](const Flying& flying) {
        const double t = from - flying.start;
        if (t == 0) return Path::Motion{flying.position, flying.velocity};
        const TimeInterval interval(drive_.drag, t);
        const Flight flight{flying.position, flying.velocity, drive_.gravity, drive_.drag};
        return Path::Motion{flight.position + flight.displacement(interval), flight.velocity_after(interval)};
    };
    const auto [p, v] = at(a);
    const auto [q, u] = at(b);
    const Vec2 between = p - q, relative = v - u;
    const double approach = -dot(between, relative);
    // Most pairs are told apart without a root: they part or pass each other by, and do not even come near.
    constexpr double near = 1e-3;  // of the sum of radii: well over what counts as touch
    constexpr double sure = 1e-9;  // well over what rounding adds up to
    const double reach = a.radius + b.radius, wide = (1 + near) * reach;
    const double apart = length_squared(between) - wide * wide;
    if (apart > 0 && !(approach > 0)) return;
    if (apart > 0 && approach * approach * (1 + sure) < length_squared(relative) * apart) return;
    flying_[i].near_ball = flying_[j].near_ball = true;
    if (!(approach > 0)) return;
    if (apart > 0 && from + (1 - sure) * apart / (2 * approach) > movers_[i].next_time) return;
    if (a.pressed && b.pressed && approach <= slow_ * length(between)) return;
    if (!layers_meet(bodies_[i], bodies_[j])) return;
    ++record_->statistics.narrow_tests;
    const double e = straight_touch(between, relative, reach, gap_rounding(p, q, reach));
    const double met = from + drag_time(drive_.drag, e);
    if (met <= std::min(movers_[i].way.until, movers_[j].way.until))
        offer(i, std::max(met, time), Next::ball, j, b.changes);
}

/// When the centre leaves the bounds.
void ContinuousSolver::predict_loss(BallIndex i, double time) {
    const Ball& ball = bodies_[i];
    Mover& mover = movers_[i];
    const Box& bounds = scene_.bounds;
    if (bounds.contains(mover.bounds.min) && bounds.contains(mover.bounds.max)) return;
    const auto& reported = table_->reported_lost();
    if (std::ranges::find(reported, ball.number) != reported.end()) return;
    const double last = std::min({dt_, mover.way.until, mover.next_time, mover.horizon});
    offer(i, first_exit(mover.way.path, bounds, time, last), Next::leave_bounds);
}

/// When a ball enters a sensor, or leaves it (or a gate): by steps that no speed can outrun, but not less
/// than a small part of a radius each, and then by chords. A brush shallower than that may pass unnoticed.
double ContinuousSolver::sense_time(PartIndex part, const Ball& ball, const Path& path, double time,
                                    bool inside) const {
    const Turning& turning = turnings_[part];
    const double own = path.max_speed(dt_), w = std::abs(turning.rate);
    const double out = std::max(sense_gap * ball.radius, 4 * gap_rounding(ball.position, ball.radius));
    const auto left_at = [&](double t) {
        const double distance = distance_to(part, path.position(t), ball.radius, turning.pose(t));
        return inside ? out - distance : distance;
    };
    const double far = w == 0 ? 0 : length(path.position(time) - turning.begin.pivot) + own * (dt_ - time);
    const double speed = own + w * far;
    const double error = std::max(gap_rounding(ball.position, ball.radius) / speed, 4 * 0x1p-53 * dt_);
    double before = time, left_before = 0;
    constexpr int most_steps = 100'000;  // some hundred where a ball rolls along a border
    double t = time;
    for (int step = 0; step < most_steps; ++step) {
        const double left = left_at(t);
        if (left <= 0) return first_zero(left_at, before, left_before, t, left, error);
        before = t;
        left_before = left;
        if (t >= dt_) return never_touch;
        t = std::min(dt_, t + std::max(left, sense_step * ball.radius) / speed);
    }
    refuse_search(engine_name, ball.number, Other::part(part), start_ + time, scene_);
}

}  // namespace flipside::custom
