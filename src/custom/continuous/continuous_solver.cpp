#include "custom/continuous/continuous_solver.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <numeric>

#include "custom/sift.hpp"

namespace flipside::custom {

namespace {

/// Overlaps deeper than this, in radii, are no matter of rounding.
constexpr double deep = 1e-3;

Box touching_box(const Ball& ball) {
    return bounds_of(ball.position, ball.radius * (1 + touch_distance));
}

}  // namespace

ContinuousSolver::ContinuousSolver(const Table& table, const Layout& layout, const SolverSettings& settings,
                                   DiscreteSolver& discrete)
    : scene_(table.scene()),
      layout_(layout),
      settings_(settings),
      discrete_(discrete),
      drive_{scene_.gravity, scene_.damping},
      features_(features_of(layout.pieces(), scene_)),
      ranges_(scene_.bounds, features_.size()),
      pieces_(scene_.parts.size()),
      clearance_(scene_, layout, table),
      few_(make_few(layout.still_proxies(), scene_.bounds)),
      turnings_(scene_.parts.size()) {
    for (FeatureIndex i = 0; i < features_.size(); ++i)
        ranges_.set(i, range_of(features_[i], layout.piece(features_[i].piece), table));
    for (PieceIndex i = 0; i < layout.size(); ++i) {
        const Part& part = scene_.parts[layout.piece(i).part];
        if (part.sensor || gate_of(part) != nullptr) pieces_[layout.piece(i).part].push_back(i);
    }
}

void ContinuousSolver::reset(Table& table, std::vector<Ball>& balls) {
    inside_.clear();
    for (Mover& mover : pool_) {
        mover.near.forget();
        mover.lies = false;
        mover.free = 0;
    }
    for (const Ball& ball : balls)
        for (PartIndex part = 0; part < pieces_.size(); ++part)
            for (const PieceIndex piece : pieces_[part]) {
                if (!scene_.parts[part].sensor || !layers_meet(ball, scene_.parts[part]) ||
                    !layout_.may_touch(piece, ball.position, ball.radius))
                    continue;
                const Touch found = touch(ball.position, ball.radius, layout_.piece(piece), table.pose(part));
                if (found.separation <= 0) set_inside(ball.number, part, true);
            }
    settle_gates(table, balls);
}

void ContinuousSolver::reserve(std::size_t balls) {
    // Balls that are launched later must find their place made.
    const std::size_t most = std::bit_ceil(balls + (scene_.launcher ? spare : 0));
    constexpr std::size_t most_near = 512;
    if (pool_.size() < most) {
        const std::size_t movers = movers_.size();
        pool_.resize(most);
        movers_ = std::span(pool_).first(movers);
        for (Mover& mover : pool_) mover.near.reserve(std::min(features_.size(), most_near));
    }
    for (auto* list : {&bodies_, &start_state_.balls, &handed_}) custom::make_room(*list, most);
    for (auto* list : {&inside_, &inside_before_}) custom::make_room(*list, most, touches_per_ball);
    for (State* state : {&start_state_, &last_read_}) {
        custom::make_room(state->pressings, most, contacts_per_ball);
        state->blocked.reserve(std::min(most, layout_.gates().empty() ? 0 : most_near));
    }
    custom::make_room(pending_, most, events_per_ball);
    make_writable(rank_, most);
    custom::make_room(active_room_, most);
    paths_.reserve(most);
    custom::make_room(near_, most);
    custom::make_room(queue_, most, pairs_per_ball);
    custom::make_room(pairs_, most, pairs_per_ball);
    grips_.reserve(std::min(features_.size(), most_near));
}

void ContinuousSolver::prepare_movers() {
    queue_.clear();
    const std::vector<Ball>& balls = bodies_;
    for (Place i = 0; i < balls.size(); ++i) {
        Mover& mover = movers_[i];
        mover.held = mover.left = nullptr;
        mover.last_time = -1;
        mover.stalled = mover.idle = 0;
        mover.lost = false;
        ++mover.predictions;
        if (mover.handed_over) continue;
        if (!mover.active) {
            go_free(i);
            continue;
        }
        if (!balls[i].asleep && !mover.clear) come_out(i);
        set_out(i, 0);
    }
}

/// Pushes a ball that begins deep in a solid or on a curve out of it, by position only; one that begins in a
/// gate is on its way through. The deepest comes first; what then still overlaps is left for later steps.
void ContinuousSolver::come_out(Place i) {
    Ball& ball = bodies_[i];
    for (int round = 0; round < 4; ++round) {
        const Box here = bounds_of(ball.position, ball.radius);
        record_->statistics.pair_tests += movers_[i].near.cover(here, ranges_);
        Touch deepest;
        deepest.separation = -deep * ball.radius;
        bool found = false;
        PieceIndex seen = layout_.size();
        for (const FeatureIndex f : movers_[i].near.list()) {
            if (!overlap(here, ranges_[f]) || features_[f].gate || ignores(features_[f], ball)) continue;
            if (features_[f].piece == seen) continue;
            const Piece& piece = layout_.piece(features_[f].piece);
            const Pose pose = table_->pose(piece.part);
            if (std::holds_alternative<Bow>(features_[f].is) &&
                look(features_[f], pose.undo(ball.position), ball.radius).distance > ball.radius)
                continue;
            seen = features_[f].piece;
            if (!stops(*table_, piece, pose, ball)) continue;
            const Touch touch_now = touch(ball.position, ball.radius, piece, pose);
            if (touch_now.past_end || touch_now.separation >= deepest.separation) continue;
            deepest = touch_now;
            found = true;
        }
        if (!found) return;
        push_out(ball, deepest);
    }
}

/// Balls that touch, are pressed together, and neither bounce nor hop out of touch; and those that a pile
/// left deep in one another, which flying freely would never come apart.
void ContinuousSolver::find_piles() {
    list_active();
    apart_ = !any_paths_cross();
    if (apart_) return;
    for (Place i = 0; i < movers_.size(); ++i) {
        record_->statistics.pair_tests += paths_.find(touching_bounds(i), near_);
        for (const Place j : near_)
            if (j > i && piled(i, j)) hand_over(i), hand_over(j);
    }
}

bool ContinuousSolver::piled(Place i, Place j) const {
    const Mover &first = movers_[i], &second = movers_[j];
    const Ball &a = bodies_[i], &b = bodies_[j];
    if (!first.active && !second.active) return false;
    if ((first.handed_over && second.handed_over) || (a.asleep && b.asleep)) return false;
    if (!layers_meet(a, b)) return false;
    if (first.handed_over || second.handed_over) return overlap(paths_[i], paths_[j]);
    const Vec2 between = a.position - b.position;
    const double near = touch_distance * std::min(a.radius, b.radius);
    const double reach = a.radius + b.radius + near;
    if (length_squared(between) > reach * reach) return false;
    const double out = a.radius + b.radius - deep * std::min(a.radius, b.radius);
    if (length_squared(between) < out * out) return true;
    const double apart = dot(a.velocity - b.velocity, unit(between));
    const double pressed = pressing(i, j, 0);
    if (pressed <= 1e-9 * length(scene_.gravity) || apart < -scene_.rest_speed) return false;
    return apart <= 0 || apart * apart <= 2 * pressed * near;
}

void ContinuousSolver::list_active() {
    active_ = sift(Places{0, movers_.size()}, active_room_, [&](Place i) { return movers_[i].active; });
}

bool ContinuousSolver::any_paths_cross() const {
    return std::ranges::any_of(active_, [&](Place i) { return paths_.any(touching_bounds(i), i); });
}

Box ContinuousSolver::touching_bounds(Place i) const {
    return grown(paths_[i], touch_distance * bodies_[i].radius);
}

/// With what acceleration two balls that touch would come closer, were there no contact, m/s².
double ContinuousSolver::pressing(Place i, Place j, double time) const {
    const Path &a = movers_[i].way.path, &b = movers_[j].way.path;
    const Vec2 between = a.position(time) - b.position(time), n = unit(between);
    const double across = cross(n, a.velocity(time) - b.velocity(time));
    return -dot(a.acceleration(time) - b.acceleration(time), n) - across * across / length(between);
}

void ContinuousSolver::hand_over(Place i) {
    if (movers_[i].handed_over) return;
    movers_[i].handed_over = true;
    spoilt_ = true;
}

/// Moves the balls that were handed over; the others may not come near them.
void ContinuousSolver::run_discrete(BroadPhase& broad) {
    handed_.clear();
    std::vector<Ball>& balls = bodies_;
    for (Place i = 0; i < balls.size(); ++i)
        if (movers_[i].handed_over) handed_.push_back(balls[i]);
    if (handed_.empty()) return table_->pressings().clear();
    constexpr std::size_t few = 16;
    const std::uint64_t tests = few_->tests();
    const auto reported = static_cast<std::ptrdiff_t>(record_->events.size());
    discrete_.step(*table_, handed_, dt_, handed_.size() <= few ? *few_ : broad, *record_);
    discrete_.land(handed_, [](std::size_t, const Ball&) {});
    pending_.insert(pending_.end(), record_->events.begin() + reported, record_->events.end());
    record_->events.erase(record_->events.begin() + reported, record_->events.end());
    record_->crossed.clear();
    open_again();
    record_->statistics.pair_tests += few_->tests() - tests;
    auto next = handed_.begin();
    for (Place i = 0; i < balls.size(); ++i) {
        if (!movers_[i].handed_over) continue;
        paths_.place(i, united(bounds_of(balls[i].position, balls[i].radius),
                               bounds_of(next->position, next->radius)));
        balls[i] = *next++;
    }
}

std::span<const Pair> ContinuousSolver::find_pairs(std::span<const Ball> balls) {
    pairs_.clear();
    if (!any_active_ || balls.empty()) return pairs_;
    list_active();
    const bool cross = !apart_ && any_paths_cross();
    const double margin = touch_distance * std::ranges::max(balls, {}, &Ball::radius).radius;
    for (Place i = 0; i < movers_.size(); ++i) {
        if (movers_[i].lost) continue;
        if (movers_[i].active) pair_with_parts(balls, i);
        if (cross) pair_with_balls(balls, i, margin);
    }
    return pairs_;
}

void ContinuousSolver::pair_with_parts(std::span<const Ball> balls, Place i) {
    const Ball& ball = balls[rank_[i]];
    if (ball.asleep) return;
    const Handle handle = layout_.size() + rank_[i];
    const Box box = touching_box(ball);
    const std::size_t first = pairs_.size();
    record_->statistics.pair_tests += movers_[i].near.cover(box, ranges_);
    for (const FeatureIndex f : movers_[i].near.list()) {
        if (!overlap(box, ranges_[f]) || !layers_meet(ball, features_[f])) continue;
        // The box of an arc is mostly empty.
        if (std::holds_alternative<Bow>(features_[f].is) &&
            look(features_[f], turnings_[features_[f].part].pose(read_at_).undo(ball.position), ball.radius)
                    .distance > ball.radius * (1 + touch_distance))
            continue;
        const Pair pair{features_[f].piece, handle};
        if (pairs_.size() == first || pairs_.back() != pair) pairs_.push_back(pair);
    }
}

/// With those before it. No touching_box() reaches further than by `margin` out of the bounds of a path.
void ContinuousSolver::pair_with_balls(std::span<const Ball> balls, Place i, double margin) {
    const Ball& ball = balls[rank_[i]];
    const Box box = touching_box(ball);
    record_->statistics.pair_tests += paths_.find(grown(box, margin), near_);
    for (const Place j : near_) {
        if (j >= i || movers_[j].lost || !(movers_[i].active || movers_[j].active)) continue;
        const Ball& other = balls[rank_[j]];
        if (overlap(box, touching_box(other)) && !(ball.asleep && other.asleep) && layers_meet(ball, other))
            pairs_.push_back({layout_.size() + rank_[j], layout_.size() + rank_[i]});
    }
}

}  // namespace flipside::custom
