#include "custom/continuous/continuous_solver.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <numeric>

#include "custom/broad_phase/capacity.hpp"

namespace flipside::custom {

namespace {

Box touching_box(const Ball& ball) {
    return bounds_of(ball.position, ball.radius * (1 + touch_distance));
}

std::vector<Box> ranges_of(std::span<const Feature> features, const Layout& layout, const Table& table) {
    std::vector<Box> ranges;
    for (const Feature& feature : features)
        ranges.push_back(range_of(feature, layout.primitive(feature.primitive), table));
    return ranges;
}

}  // namespace

ContinuousSolver::ContinuousSolver(const Table& table, const Layout& layout, const SolverSettings& settings)
    : scene_(table.scene()),
      layout_(layout),
      settings_(settings),
      external_{scene_.gravity, scene_.damping},
      slow_(2 * (scene_.rest_speed + length(scene_.gravity) * tick_length)),
      features_(features_of(layout.primitives(), scene_)),
      ranges_(scene_.bounds, ranges_of(features_, layout, table)),
      primitives_(scene_.parts.size()),
      turnings_(scene_.parts.size()) {
    for (PrimitiveIndex i = 0; i < layout.size(); ++i) {
        const Part& part = scene_.parts[layout.primitive(i).part];
        if (part.sensor || gate_of(part) != nullptr) primitives_[layout.primitive(i).part].push_back(i);
    }
    for (State& start : starts_) table.copy(start);
}

void ContinuousSolver::reset(const Table& table, std::span<const Ball> balls) {
    inside_.clear();
    for (Mover& mover : pool_) mover.candidates.forget();
    for (PartIndex part = 0; part < primitives_.size(); ++part) {
        if (!scene_.parts[part].sensor) continue;
        for (const Ball& ball : balls) {
            if (!layers_meet(ball, scene_.parts[part])) continue;
            for (const PrimitiveIndex primitive : primitives_[part]) {
                const Touch found =
                    touch(ball.position, ball.radius, layout_.primitive(primitive), table.pose(part));
                if (found.separation <= 0) set_inside(ball.number, part, true);
            }
        }
    }
}

void ContinuousSolver::reserve(std::size_t balls) {
    // Launched balls must not allocate.
    const std::size_t most = std::bit_ceil(balls + (scene_.launcher ? spare : 0));
    constexpr std::size_t most_near = 512;
    if (pool_.size() < most) {
        const std::size_t movers = movers_.size();
        pool_.resize(most);
        movers_ = std::span(pool_).first(movers);
        for (Mover& mover : pool_) {
            mover.candidates.reserve(std::min(features_.size(), most_near));
            mover.motion.path.taylor.reserve(1);
        }
    }
    custom::reserve_for(bodies_, most);
    custom::reserve_for(inside_, most, touches_per_ball);
    for (State& start : starts_) {
        custom::reserve_for(start.balls, most);
        custom::reserve_for(start.memory.forces, most, contacts_per_ball);
        start.blocked.reserve(std::min(most, layout_.gates().empty() ? 0 : most_near));
    }
    part_forces_.reserve(most * contacts_per_ball);
    ball_forces_.reserve(most * contacts_per_ball);
    contact_solver_.reserve(most);
    custom::reserve_for(members_, most);
    custom::reserve_for(creeping_, most);
    custom::reserve_for(pending_, most, events_per_ball);
    custom::reserve_for(woken_, most);
    custom::reserve_for(overlapped_, most, contacts_per_ball);
    if (hot_.size() < most) hot_.resize(most), rank_.resize(most);
    next_events_.reserve(most);
    cells_.reserve(most);
    custom::reserve_for(pairs_, most, pairs_per_ball);
    supports_.reserve(std::min(features_.size(), most_near));
}

/// Moves a ball that deeply overlaps a part at the start of the window out of it, by position only. Gates are
/// ignored: such a ball passes through them. Each round corrects the deepest overlap; what four rounds leave
/// remains for later windows.
void ContinuousSolver::push_out_of_parts(BallIndex i) {
    Ball& ball = bodies_[i];
    for (int round = 0; round < 4; ++round) {
        const Box here = bounds_of(ball.position, ball.radius);
        record_->statistics.pair_tests += movers_[i].candidates.cover(here, ranges_);
        Touch deepest;
        deepest.separation = -deep_overlap * ball.radius;
        bool found = false;
        PrimitiveIndex seen = layout_.size();
        for (const FeatureIndex f : movers_[i].candidates.list()) {
            if (!overlap(here, ranges_[f]) || features_[f].gate || ignores(features_[f], ball)) continue;
            if (features_[f].primitive == seen) continue;
            const Primitive& primitive = layout_.primitive(features_[f].primitive);
            const Pose pose = table_->pose(primitive.part);
            if (std::holds_alternative<Arc>(features_[f].is) &&
                closest_point(features_[f], pose.undo(ball.position), ball.radius).distance > ball.radius)
                continue;
            seen = features_[f].primitive;
            if (!should_collide(*table_, primitive, pose, ball)) continue;
            const Touch touch_now = touch(ball.position, ball.radius, primitive, pose);
            if (touch_now.past_end || touch_now.separation >= deepest.separation) continue;
            deepest = touch_now;
            found = true;
        }
        if (!found) return;
        push_out(ball, deepest);
    }
}

/// Finds the members of islands at the start of the window: balls with a contact force at the end of the
/// previous window, balls in resting contact, and their neighbours in slow contact. Balls that deeply overlap
/// each other are members too: in free flight they would never separate.
void ContinuousSolver::find_islands() {
    members_.clear();
    const auto join_once = [&](BallIndex i) {
        if (bodies_[i].asleep || hot_[i].in_island) return;
        join_island(i, 0);
        members_.push_back(i);
    };
    for (const ContactForce& force : table_->memory().forces) {
        const auto a = std::ranges::lower_bound(bodies_, force.a, {}, &Ball::number);
        const auto b = std::ranges::lower_bound(bodies_, force.b, {}, &Ball::number);
        if (a == bodies_.end() || a->number != force.a || b == bodies_.end() || b->number != force.b)
            continue;
        const auto i = static_cast<BallIndex>(a - bodies_.begin()),
                   j = static_cast<BallIndex>(b - bodies_.begin());
        ball_forces_.add({i, j, force.normal, force.tangent});
        join_once(i), join_once(j);
    }
    ball_forces_.merge();
    for (BallIndex i = 0; i < movers_.size(); ++i) {
        if (bodies_[i].asleep) continue;
        cells_.query_neighbours(i, [&](BallIndex j) {
            ++record_->statistics.pair_tests;
            if ((j > i || bodies_[j].asleep) && in_resting_contact(i, j, false)) join_once(i), join_once(j);
        });
    }
    for (std::size_t seen = 0; seen < members_.size();) {
        const BallIndex i = members_[seen++];
        cells_.query_neighbours(i, [&](BallIndex j) {
            if (!hot_[j].in_island && in_resting_contact(i, j, true)) join_once(j);
        });
    }
}

/// Whether two balls are in resting contact, or overlap deeply. `beside_island`: one of them is in an island.
bool ContinuousSolver::in_resting_contact(BallIndex i, BallIndex j, bool beside_island) const {
    const Ball &a = bodies_[i], &b = bodies_[j];
    const Vec2 between = a.position - b.position;
    const double gap = touch_distance * std::min(a.radius, b.radius);
    const double reach = a.radius + b.radius + gap;
    if (length_squared(between) > reach * reach || !layers_meet(a, b)) return false;
    const double out = a.radius + b.radius - deep_overlap * std::min(a.radius, b.radius);
    if (length_squared(between) < out * out) return true;
    const double apart = dot(a.velocity - b.velocity, unit(between));
    if (beside_island) return std::abs(apart) <= scene_.rest_speed;
    const double closing = closing_acceleration(i, j, 0);
    if (closing <= 1e-9 * length(scene_.gravity) || apart < -scene_.rest_speed) return false;
    return apart <= 0 || apart * apart <= 2 * closing * gap;
}

/// Acceleration with which two touching balls would approach each other without a contact force, m/s².
double ContinuousSolver::closing_acceleration(BallIndex i, BallIndex j, double time) const {
    const Path &a = movers_[i].motion.path, &b = movers_[j].motion.path;
    const Vec2 between = a.position(time) - b.position(time), n = unit(between);
    const double across = cross(n, a.velocity(time) - b.velocity(time));
    return -dot(a.acceleration(time) - b.acceleration(time), n) - across * across / length(between);
}

std::span<const Pair> ContinuousSolver::find_pairs(std::span<const Ball> balls) {
    pairs_.clear();
    if (!paths_started_) return pairs_;
    for (BallIndex i = 0; i < movers_.size(); ++i) {
        if (hot_[i].lost || bodies_[i].asleep) continue;
        if (movers_[i].has_near_part) pair_with_parts(balls, i);
        if (hot_[i].has_near_ball) pair_with_balls(balls, i);
    }
    return pairs_;
}

void ContinuousSolver::pair_with_parts(std::span<const Ball> balls, BallIndex i) {
    const Ball& ball = balls[rank_[i]];
    const Handle handle = layout_.size() + rank_[i];
    const Box box = touching_box(ball);
    const std::size_t first = pairs_.size();
    record_->statistics.pair_tests += movers_[i].candidates.cover(box, ranges_);
    for (const FeatureIndex f : movers_[i].candidates.list()) {
        if (!overlap(box, ranges_[f]) || !layers_meet(ball, features_[f])) continue;
        // The box of an arc is mostly empty.
        if (std::holds_alternative<Arc>(features_[f].is) &&
            closest_point(features_[f], turnings_[features_[f].part].pose(read_at_).undo(ball.position),
                          ball.radius)
                    .distance > ball.radius * (1 + touch_distance))
            continue;
        const Pair pair{features_[f].primitive, handle};
        if (pairs_.size() == first || pairs_.back() != pair) pairs_.push_back(pair);
    }
}

/// Adds the pairs of a ball with sleeping balls and with awake balls of a lower index.
void ContinuousSolver::pair_with_balls(std::span<const Ball> balls, BallIndex i) {
    const Ball& ball = balls[rank_[i]];
    const Box box = touching_box(ball);
    cells_.query_neighbours(i, [&](BallIndex j) {
        if ((j > i && !bodies_[j].asleep) || hot_[j].lost) return;
        ++record_->statistics.pair_tests;
        const Ball& other = balls[rank_[j]];
        if (!overlap(box, touching_box(other)) || !layers_meet(ball, other)) return;
        const Handle a = layout_.size() + rank_[i], b = layout_.size() + rank_[j];
        pairs_.push_back({std::min(a, b), std::max(a, b)});
    });
}

}  // namespace flipside::custom
