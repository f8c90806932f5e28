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

void ContinuousSolver::begin(Table& table, std::span<const Ball> balls, double length, StepRecord& record) {
    table_ = &table, record_ = &record, dt_ = length, start_ = table.time();
    bodies_.assign(balls.begin(), balls.end());
    pending_.clear();
    part_forces_.clear(), ball_forces_.clear();
    creeping_.clear();
    events_ = search_steps_ = 0;
    paths_started_ = false;
    after_end_ = std::nextafter(dt_, INFINITY);
    any_in_island_ = false;
    for (const PartIndex i : table.moving_parts()) {
        const auto [pose, rate, stop] = table.turning(i, 0);
        const double end = std::isfinite(stop) ? table.pose(i, stop).angle : pose.angle;
        turnings_[i] = {pose, rate, stop, end};
    }
    assign_movers();
    settle_gates();
    current_ = 1 - kept_;
    table.copy(starts_[current_]);
    starts_[current_].balls = bodies_;
    any_awake_ = !std::ranges::all_of(bodies_, &Ball::asleep) ||
                 !std::ranges::all_of(turnings_, [](const Turning& turning) { return turning.still(); });
}

/// Assigns a mover to each ball, and clears what it holds of the ball that had it before.
void ContinuousSolver::assign_movers() {
    drop_lost();
    if (pool_.size() < bodies_.size()) reserve(bodies_.size());
    movers_ = std::span(pool_).first(bodies_.size());
    for (BallIndex i = 0; i < bodies_.size(); ++i) {
        Mover& mover = movers_[i];
        if (mover.number != bodies_[i].number) mover.candidates.forget();
        mover.number = bodies_[i].number;
        mover.jammed = mover.frozen = mover.on_tick_path = false;
        mover.resting_on = mover.separated_from = nullptr;
        mover.last_event = -1;
        mover.last_slow = mover.last_hit = -INFINITY;
        mover.simultaneous_events = mover.idle_events = mover.hits = 0;
        hot_[i] = {};
        hot_[i].radius = bodies_[i].radius;
    }
}

void ContinuousSolver::run(double until, StepRecord& record) {
    record_ = &record;
    if (!any_awake_) return;
    const bool starts = !paths_started_;
    if (starts) start_all_paths();
    if (record_->trace && (starts || record_->trace->stages.empty())) trace_paths(starts);
    handle_until(until);
}

void ContinuousSolver::start_all_paths() {
    paths_started_ = true;
    next_events_.reset(bodies_.size());
    cells_.reset(bodies_);
    for (BallIndex i = 0; i < bodies_.size(); ++i) {
        if (!bodies_[i].asleep) push_out_of_parts(i);
        start_path(i, 0);
    }
    find_islands();
    tick(0);
    members_.clear();
    for (BallIndex i = 0; i < bodies_.size(); ++i)
        if (!bodies_[i].asleep) members_.push_back(i);
    predict_together(members_, 0);
}

void ContinuousSolver::handle_until(double time) {
    for (;;) {
        const double event = next_events_.time();
        if (any_in_island_ && next_tick_ <= std::min(event, time) && next_tick_ < dt_) {
            tick(next_tick_);
            continue;
        }
        if (event > time || event > dt_) return;
        record_->trace ? trace_event(next_events_.first()) : handle(next_events_.first());
    }
}

/// The ball `time` seconds after the start of the window.
Ball ContinuousSolver::ball_at(BallIndex i, double time) const {
    const Mover& mover = movers_[i];
    Ball ball = bodies_[i];
    if (ball.asleep) return ball;
    if (hot_[i].in_island)
        advance_member(ball, mover, time);
    else
        advance(ball, mover.motion, time);
    return ball;
}

void ContinuousSolver::report_until(double time, double now) {
    auto kept = pending_.begin();
    for (Event& event : pending_) {
        if (event.time - start_ > time) {
            *kept++ = event;
            continue;
        }
        event.time = std::min(event.time, now);
        record_->events.push_back(event);
    }
    pending_.erase(kept, pending_.end());
}

void ContinuousSolver::read(double time, double now, std::vector<Ball>& balls) {
    balls.clear();
    read_at_ = time;
    for (BallIndex i = 0; i < movers_.size(); ++i) {
        rank_[i] = static_cast<BallIndex>(balls.size());
        if (!hot_[i].lost) balls.push_back(ball_at(i, time));
    }
    report_until(time, now);
}

void ContinuousSolver::end(double now, std::vector<Ball>& balls) {
    read(dt_, now, balls);
    report_until(INFINITY, now);
}

/// Moves the movers of lost balls to the end of the pool, where their lists keep their capacity.
void ContinuousSolver::drop_lost() {
    BallIndex kept = 0;
    for (BallIndex i = 0; i < movers_.size(); ++i) {
        if (hot_[i].lost) continue;
        if (kept != i) std::swap(movers_[kept], movers_[i]);
        ++kept;
    }
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
