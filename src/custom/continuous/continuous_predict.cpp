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

/// A gap up to this, in radii, is contact for a ball that does not move along the normal.
constexpr double grip_gap = 1e-9;
/// Hops shorter than this, in units of √(r/a), do not happen: the contact holds.
constexpr double grip_hop = 1e-9;
/// Faces meet smoothly whose normals have at least this cosine (1.4e-3 rad; see joint_angle).
constexpr double smooth_joint = 1 - 1e-6;
/// How far a ball must be out of a sensor or gate to have left it, in radii.
constexpr double sense_gap = gate_clearance;
/// The least way between two looks for a sensor's border, in radii.
constexpr double sense_step = 1e-2;

/// A touch of a bend is found by steps and late by up to `rounding` of the gap. A hop that gains as much
/// speed by it as its bounce loses comes back for ever: the speed below which that happens, m/s.
double unending_hop(const Feature& feature, double force, double rounding, double restitution) {
    if (std::holds_alternative<Line>(feature.is) || restitution >= 1) return 0;
    return restitution * std::sqrt(2 * force * rounding / (1 - restitution * restitution));
}

/// How far rounding of its ends may turn a straight face, rad.
double direction_rounding(const Feature& feature) {
    const auto* line = std::get_if<Line>(&feature.is);
    if (line == nullptr) return 0;
    return 16 * 0x1p-53 * (std::abs(line->start.x) + std::abs(line->start.y)) / line->length;
}

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

/// Finds the path of a ball from where it is: along what it rests on, or free.
void ContinuousSolver::set_out(Place i, double time) {
    Ball& ball = bodies_[i];
    Mover& mover = movers_[i];
    mover.hops = mover.waits = false;
    if (ball.asleep && beside_moving_part(i)) ball.asleep = false;
    mover.held = nullptr;
    mover.glides.clear();
    mover.way.until = never_touch;
    mover.way.spin_rate = 0;
    mover.way.roll = {};
    Path& path = mover.way.path;
    path.start = time;
    path.swings = false;
    path.flight = {ball.position, ball.velocity, ball.asleep ? Vec2{} : drive_.gravity,
                   ball.asleep ? 0 : drive_.drag};
    Flying& flying = flying_[i];
    ++flying.changes;
    flying.position = ball.position;
    flying.velocity = ball.velocity;
    flying.start = time;
    flying.freely = !ball.asleep;
    list_in_cell(i, time);
    if (ball.asleep) return;
    find_grips(i, time);
    if (grips_.empty()) return;
    take_hold(i, time);
    flying.freely = mover.held == nullptr;
    if (flying.freely) return note_glides(mover);
    list_in_cell(i, time);
}

/// Lists a ball that sets out in the cell where it is: a wide one if it is fast, so that it does not leave
/// one more often than a thousand times a second.
void ContinuousSolver::list_in_cell(Place i, double time) {
    const Ball& ball = bodies_[i];
    constexpr double soon = 1e-3;  // s
    cells_.choose_level(i,
                        std::max(Cells::width_for(ball.radius), movers_[i].way.path.max_speed(dt_) * soon));
    cells_.put(i, ball.position);
    cover_way(i, time);
}

/// Finds how long the ball stays listed in its cell, and what it can meet until then.
void ContinuousSolver::cover_way(Place i, double time) {
    Mover& mover = movers_[i];
    const Path& path = mover.way.path;
    Vec2 at = path.flight.position;
    if (bodies_[i].asleep) {
        mover.horizon = never_touch;
        mover.bounds = bounds_of(at, bodies_[i].radius);
        return;
    }
    const auto [here, velocity] = path.at(time);
    const double left = dt_ - time;
    Vec2 top{std::abs(path.flight.acceleration.x), std::abs(path.flight.acceleration.y)};
    if (path.swings || path.flight.drag > 0) {
        const double most = path.max_acceleration(dt_);
        top = {most, most};
    }
    const double stays = std::min(cells_.stays(i, here, velocity, top), left);
    mover.horizon = stays < left ? time + stays : never_touch;
    const Vec2 far = Vec2{std::abs(velocity.x), std::abs(velocity.y)} * stays + 0.5 * stays * stays * top;
    mover.bounds = {here - Vec2{velocity.x > 0 ? 0.5 * stays * stays * top.x : far.x,
                                velocity.y > 0 ? 0.5 * stays * stays * top.y : far.y},
                    here + Vec2{velocity.x > 0 ? far.x : 0.5 * stays * stays * top.x,
                                velocity.y > 0 ? far.y : 0.5 * stays * stays * top.y}};
    mover.bounds = grown(mover.bounds, bodies_[i].radius);
    record_->statistics.pair_tests += mover.near.cover(mover.bounds, ranges_);
}

/// A ball is listed in the cell in which it is now, and meets whoever is near there.
void ContinuousSolver::enter_cell(Place i) {
    const double time = movers_[i].horizon;
    const Cells::Cell before = cells_[i];
    cells_.put(i, movers_[i].way.path.position(time));
    cover_way(i, time);
    if (movers_[i].horizon <= time) movers_[i].horizon = never_touch;
    predict_loss(i, time);
    predict_features(i, time);
    cells_.each_newly_near(i, before, [&](Place j) { predict_ball(i, j, time); });
    schedule(i);
}

bool ContinuousSolver::beside_moving_part(Place i) {
    const Ball& ball = bodies_[i];
    const Box here = bounds_of(ball.position, ball.radius * (1 + touch_distance));
    record_->statistics.pair_tests += movers_[i].near.cover(here, ranges_);
    return std::ranges::any_of(movers_[i].near.list(), [&](FeatureIndex f) {
        return !turnings_[features_[f].part].still() && overlap(here, ranges_[f]);
    });
}

/// What the ball touches without moving along the normal.
void ContinuousSolver::find_grips(Place i, double time) {
    grips_.clear();
    const Ball& ball = bodies_[i];
    const Mover& mover = movers_[i];
    const Box here = bounds_of(ball.position, ball.radius * (1 + 1e-6));
    for (const FeatureIndex f : mover.near.list()) {
        if (!overlap(here, ranges_[f])) continue;
        const Feature& feature = features_[f];
        if (&feature == mover.left || ignores(feature, ball)) continue;
        const Turning& turning = turnings_[feature.part];
        const Pose pose = turning.pose(time);
        ++record_->statistics.narrow_tests;
        const Sight sight = look(feature, pose.undo(ball.position), ball.radius);
        const double gap = sight.distance - ball.radius;
        if (!sight.facing || gap > grip_gap * ball.radius + gap_rounding(ball.position, ball.radius))
            continue;
        const Vec2 normal = pose.angle == 0 ? sight.normal : rotated(sight.normal, pose.angle);
        if (feature.gate && lets_through(feature.part, ball, time)) continue;
        Hold hold = hold_at(feature, turning, ball, normal, time, drive_);
        const Mixed mixed = layout_.mixed(ball.material, scene_.parts[feature.part].material);
        hold.friction = mixed.friction;
        const Vec2 relative = ball.velocity - hold.surface_velocity;
        const double force = std::max(0.0, hold.force);
        const double still =
            (1e-12 + direction_rounding(feature)) * length(relative) +
            grip_hop * std::sqrt(ball.radius * force) +
            unending_hop(feature, force, gap_rounding(ball.position, ball.radius), mixed.restitution);
        if (std::abs(dot(relative, normal)) > still) continue;
        if (feature.gate) table_->set_blocked(feature.part, ball.number, true);
        const double scale = length(drive_.gravity) + length_squared(relative) / ball.radius;
        grips_.push_back({hold, hold.force > 1e-12 * scale});
    }
}

/// The faces among the grips of a ball that none of them holds.
void ContinuousSolver::note_glides(Mover& mover) const {
    for (const auto& [hold, pressed, way, ahead] : grips_) {
        const auto* line = std::get_if<Line>(&hold.feature->is);
        if (line == nullptr || pressed || !hold.turning->still()) continue;
        mover.glides.add(hold.turning->begin.apply(line->start), hold.normal);
    }
}

/// Which way each grip leads the ball: on in its motion, or where it is driven if it does not move.
void ContinuousSolver::find_ways(const Ball& ball, double time) {
    for (Grip& grip : grips_) {
        const Hold& hold = grip.hold;
        const Vec2 tangent = perp(hold.normal);
        const double along = dot(ball.velocity - hold.surface_velocity, tangent);
        grip.way = (along != 0 ? along : hold.driven) > 0 ? tangent : -tangent;
        const Pose pose = hold.turning->pose(time);
        grip.ahead =
            ahead(*hold.feature, pose.undo(ball.position), rotated(grip.way, -pose.angle), ball.radius);
    }
}

/// Of two faces that meet smoothly, whether this one holds. Forces cannot tell, for curves need more: it is
/// the one that does not lead into the other; or where both or none do, the one that goes on for longer.
bool ContinuousSolver::goes_before(const Grip& grip, const Grip& other) {
    const bool clear = dot(grip.way, other.hold.normal) >= -speed_rounding / 2;
    const bool other_clear = dot(other.way, grip.hold.normal) >= -speed_rounding / 2;
    if (clear != other_clear) return clear;
    return grip.ahead > other.ahead || (grip.ahead == other.ahead && &grip < &other);
}

/// Chooses what the ball rests on among its grips: the one whose force keeps it off all others, or all
/// together where no single one does.
void ContinuousSolver::take_hold(Place i, double time) {
    Ball& ball = bodies_[i];
    Mover& mover = movers_[i];
    int pressed = 0;
    bool moving = false;
    if (grips_.size() > 1) find_ways(ball, time);
    for (const Grip& grip : grips_) {
        pressed += grip.pressed;
        moving = moving || grip.hold.turning->rate_at(time) != 0;
        if (!grip.pressed) continue;
        const bool enough = std::ranges::all_of(grips_, [&](const Grip& other) {
            if (&other == &grip) return true;
            const double cosine = dot(other.hold.normal, grip.hold.normal);
            return cosine < smooth_joint
                       ? other.hold.force - grip.hold.force * cosine <= 1e-9 * grip.hold.force
                       : goes_before(grip, other);
        });
        if (!enough) continue;
        mover.held = grip.hold.feature;
        if (!hold(grip.hold, ball, time, dt_, drive_, mover.way)) join(i, time);
        return;
    }
    const double slow = 1e-6 * std::sqrt(ball.radius * length(drive_.gravity));
    if (pressed < 2 || moving || length(ball.velocity) > slow) return;
    // Rubbed from two sides, a spinning ball is taken to stop at once.
    if (std::ranges::any_of(grips_, [](const Grip& grip) { return grip.hold.friction > 0; })) ball.spin = 0;
    mover.held = grips_.front().hold.feature;
    mover.way.path.flight = {ball.position, {}, {}, 0};
}

void ContinuousSolver::offer(Place i, double time, Next next, std::uint32_t met, std::uint32_t met_changes) {
    Mover& mover = movers_[i];
    if (!(time <= mover.next_time)) return;
    if (time == mover.next_time && order_of(i, next, met) >= order_of(i, mover.next, mover.met)) return;
    mover.next_time = time;
    mover.next = next;
    mover.met = met;
    mover.met_changes = met_changes;
}

std::uint64_t ContinuousSolver::order_of(Place i, Next next, std::uint32_t met) {
    constexpr std::uint64_t meets_ball = std::uint64_t{1} << 63;
    if (next == Next::nothing) return ~std::uint64_t{0};
    if (next != Next::ball) return std::uint64_t{i} << 32;
    return meets_ball | std::uint64_t{std::min(i, met)} << 32 | std::max(i, met);
}

/// Finds the next event of a ball on its path and notes it.
void ContinuousSolver::predict(Place i, double time) {
    flying_[i].near_ball = false;
    predict_with(i, time, [&] { cells_.each_near(i, [&](Place j) { predict_ball(i, j, time); }); });
}

/// The same for balls that all set out now. Of two of them only the first looks for the other.
void ContinuousSolver::predict_together(std::span<const Place> balls, double time) {
    ++batch_;
    for (const Place i : balls) flying_[i].near_ball = false;
    for (const Place i : balls)
        predict_with(i, time, [&] {
            flying_[i].batch = batch_;
            cells_.each_near(i, [&](Place j) {
                if (flying_[j].batch != batch_) predict_ball(i, j, time);
            });
        });
}

void ContinuousSolver::predict_with(Place i, double time, auto&& each_other) {
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

void ContinuousSolver::schedule(Place i) {
    const Mover& mover = movers_[i];
    if (mover.horizon <= mover.next_time) return next_events_.set(i, mover.horizon, std::uint64_t{i} << 32);
    if (mover.next == Next::nothing) return next_events_.set(i, INFINITY, 0);
    next_events_.set(i, mover.next_time, order_of(i, mover.next, mover.met));
}

/// Whether the ball comes to this feature only by sliding to the end of what holds it. That is no touch, but
/// rounding would make one of it, at an angle of its square root.
bool ContinuousSolver::slides_to(const Mover& mover, const Ball& ball, const Feature& feature) const {
    if (mover.held == nullptr) return false;
    const auto is_posed = [&](PartIndex part) {
        return !turnings_[part].still() || turnings_[part].begin.angle != 0;
    };
    const PartIndex own = mover.held->part;
    if (feature.part != own && (is_posed(feature.part) || is_posed(own))) return false;
    const Pose pose = turnings_[own].pose(mover.way.path.start);
    const Vec2 normal = look(*mover.held, pose.undo(ball.position), ball.radius).normal;
    return ends_in(*mover.held, normal, feature);
}

/// Whether the ball flies along a face below which this still feature lies.
bool ContinuousSolver::glides_over(const Mover& mover, const Feature& feature, const Pose& pose) {
    if (!mover.glides.any()) return false;
    return mover.glides.above(pose.angle == 0 ? feature : posed(feature, pose));
}

void ContinuousSolver::predict_features(Place i, double time) {
    Mover& mover = movers_[i];
    mover.near_part = mover.held != nullptr;
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
        if (&feature == mover.held || ignores(feature, ball)) continue;
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
void ContinuousSolver::predict_ball(Place i, Place j, double time) {
    const Flying &a = flying_[i], &b = flying_[j];
    ++record_->statistics.pair_tests;
    if (!b.meets) return;
    if (a.freely && b.freely) return predict_flying(i, j, time);
    if (!layers_meet(bodies_[i], bodies_[j])) return;
    flying_[i].near_ball = flying_[j].near_ball = true;
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
void ContinuousSolver::predict_flying(Place i, Place j, double time) {
    const Flying &a = flying_[i], &b = flying_[j];
    const double from = std::max(a.start, b.start);
    const auto at = [&](const Flying& flying) {
        const double t = from - flying.start;
        if (t == 0) return Path::Motion{flying.position, flying.velocity};
        const Stretch stretch(drive_.drag, t);
        const Flight flight{flying.position, flying.velocity, drive_.gravity, drive_.drag};
        return Path::Motion{flight.position + flight.displacement(stretch), flight.velocity_after(stretch)};
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
    const double met = from + drag_stretch(drive_.drag, e);
    if (met <= std::min(movers_[i].way.until, movers_[j].way.until))
        offer(i, std::max(met, time), Next::ball, j, b.changes);
}

/// When the centre leaves the bounds.
void ContinuousSolver::predict_loss(Place i, double time) {
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
