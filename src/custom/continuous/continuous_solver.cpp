// A step: windows on the grid of the world's time, the events of each in order of time, and the balls at its
// end.

#include "custom/continuous/continuous_solver.hpp"

#include <algorithm>
#include <bit>

#include "custom/broad_phase/capacity.hpp"
#include "custom/engine.hpp"
#include "custom/prefetch.hpp"
#include "world/refusal.hpp"

namespace flipside::custom {

namespace {

constexpr double window_length = 1.0 / 4;  // s; a multiple of 1/60 s
constexpr double rest_length = 1.0 / 60;   // s: how long a ball must be at rest to fall asleep

Box touching_box(const Ball& ball) {
    return bounds_of(ball.position, ball.radius * (1 + touch_distance));
}

std::shared_ptr<const State> without_gone(const State& start) {
    auto origin = std::make_shared<State>(start);
    Table::forget_gone(*origin);
    return origin;
}

}  // namespace

ContinuousSolver::ContinuousSolver(Table& table, const Layout& layout, BroadPhase& broad,
                                   const SolverSettings& settings)
    : table_(table),
      scene_(table.scene()),
      layout_(layout),
      broad_(broad),
      settings_(settings),
      external_{scene_.gravity, scene_.damping},
      slow_(2 * (scene_.rest_speed + length(scene_.gravity) * tick_length)),
      features_(features_of(layout.primitives(), scene_)),
      ranges_(scene_.bounds, ranges_of(features_, layout.primitives(), table)),
      primitives_(scene_.parts.size()),
      sleep_(settings.sleep_speed, scene_.gravity),
      turnings_(scene_.parts.size()) {
    for (PrimitiveIndex i = 0; i < layout.size(); ++i) {
        const Part& part = scene_.parts[layout.primitive(i).part];
        if (part.sensor || gate_of(part) != nullptr) primitives_[layout.primitive(i).part].push_back(i);
    }
    for (State& start : starts_) table.copy(start);
}

/// Finds again which balls are inside sensors, from the positions of the balls.
void ContinuousSolver::find_sensed(std::span<const Ball> balls) {
    inside_.clear();
    for (Candidates& candidates : candidates_) candidates.forget();
    for (PartIndex part = 0; part < primitives_.size(); ++part) {
        if (!scene_.parts[part].sensor) continue;
        for (const Ball& ball : balls) {
            if (!layers_meet(ball, scene_.parts[part])) continue;
            for (const PrimitiveIndex primitive : primitives_[part]) {
                const Touch found =
                    touch(ball.position, ball.radius, layout_.primitive(primitive), table_.pose(part));
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
        for (Mover& mover : pool_) mover.motion.path.taylor.reserve(1);
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
    if (hot_.size() < most) {
        hot_.resize(most), near_.resize(most), candidates_.resize(most), rank_.resize(most);
        for (Candidates& candidates : candidates_) candidates.reserve(std::min(features_.size(), most_near));
    }
    next_events_.reserve(most);
    cells_.reserve(most);
    custom::reserve_for(pairs_, most, pairs_per_ball);
    found_features_.reserve(features_.size());
    crossed_features_.reserve(features_.size());
    supports_.reserve(std::min(features_.size(), most_near));
    sleep_.reserve(balls);
    contacts_.reserve(layout_.size(), balls);
}

void ContinuousSolver::step(double dt, std::vector<Ball>& balls, StepRecord& record) {
    record_ = &record;
    fell_asleep_ = false;
    if (quiet_) return table_.advance(dt);
    Clock now = table_.clock();
    now.advance(dt);
    advance_to(now, balls);
}

/// Advances to `now`, with stops at the ends of windows and at the instants at which sleep_ watches the
/// balls.
void ContinuousSolver::advance_to(const Clock& now, std::vector<Ball>& balls) {
    for (;;) {
        if (!in_window_) begin(balls);
        if (quiet_) return table_.set_to(now, start().parts, now.time - start_);
        const double stop = watched_ ? end_on_clock_ : watch_at_;
        const Clock here = stop < now.time ? Clock{stop, 0} : now;
        const double ahead = here.time - start_;
        run(ahead);
        table_.set_to(here, start().parts, ahead);
        table_.memory().engine = engine_name;
        table_.memory().time = here.time;
        if (here.time < stop) return read(ahead, now.time, balls);
        if (watched_) {
            end(now.time, balls);
        } else {
            read(ahead, now.time, balls);
            sleep_.watch(balls, end_on_clock_ - watch_at_);
            watched_ = true;
        }
        if (stop >= now.time) return;
    }
}

/// Begins a window at the table's time.
void ContinuousSolver::begin(const std::vector<Ball>& balls) {
    if (!balls_known_) find_sensed(balls);
    balls_known_ = true;
    if (!contacts_known_) contacts_.search(layout_, table_, balls, broad_);
    contacts_known_ = true;
    choose_end();
    EngineMemory& memory = table_.memory();
    if (memory.engine != engine_name || memory.time != start_) memory.forces.clear();
    bodies_ = balls;
    pending_.clear();
    part_forces_.clear(), ball_forces_.clear();
    creeping_.clear();
    events_ = search_steps_ = 0;
    paths_started_ = any_in_island_ = false;
    for (const PartIndex i : table_.moving_parts()) {
        const auto [pose, rate, stop] = table_.turning(i, 0);
        const double last = std::isfinite(stop) ? table_.pose(i, stop).angle : pose.angle;
        turnings_[i] = {pose, rate, stop, last};
    }
    assign_movers();
    settle_gates();
    current_ = 1 - kept_;
    table_.copy(starts_[current_]);
    starts_[current_].balls = bodies_;
    quiet_ = std::ranges::all_of(bodies_, &Ball::asleep) &&
             std::ranges::all_of(turnings_, [](const Turning& turning) { return turning.still(); });
    in_window_ = !quiet_;
}

/// Ends the window at the next point of the grid, and chooses when to watch which balls are at rest.
void ContinuousSolver::choose_end() {
    start_ = table_.time();
    double next = std::floor(start_ / window_length) + 1;
    while (next * window_length <= start_) ++next;
    end_on_clock_ = next * window_length;
    end_ = end_on_clock_ - start_;
    after_end_ = std::nextafter(end_, INFINITY);
    watch_at_ = end_on_clock_ - rest_length;
    watched_ = !settings_.sleep || watch_at_ <= start_;
    sleep_.watch({}, rest_length);
}

/// Assigns a mover to each ball, and clears what it holds of the ball that had it before.
void ContinuousSolver::assign_movers() {
    if (pool_.size() < bodies_.size()) reserve(bodies_.size());
    movers_ = std::span(pool_).first(bodies_.size());
    for (BallIndex i = 0; i < bodies_.size(); ++i) {
        Mover& mover = movers_[i];
        if (mover.number != bodies_[i].number) candidates_[i].forget();
        mover.number = bodies_[i].number;
        mover.jammed = mover.frozen = mover.on_tick_path = false;
        mover.resting_on = mover.separated_from = nullptr;
        mover.last_event = -1;
        mover.last_slow = mover.last_hit = -INFINITY;
        mover.simultaneous_events = mover.idle_events = mover.hits = 0;
        mover.events_until = 0;
        hot_[i] = {};
        near_[i] = {};
        hot_[i].radius = bodies_[i].radius;
    }
}

/// Handles all events up to `until`.
void ContinuousSolver::run(double until) {
    const bool starts = !paths_started_;
    if (starts) start_all_paths();
    if (record_->trace && (starts || record_->trace->stages.empty())) trace_paths(starts);
    handle_until(until);
}

/// Starts and predicts the paths of all balls at the start of the window.
void ContinuousSolver::start_all_paths() {
    paths_started_ = true;
    next_events_.reset(bodies_.size());
    cells_.reset(bodies_);
    for (BallIndex i = 0; i < bodies_.size(); ++i) {
        if (!bodies_[i].asleep) push_out_of_parts(i);
        start_path(i, 0);
    }
    find_islands();
    solve_islands(0);
    members_.clear();
    for (BallIndex i = 0; i < bodies_.size(); ++i)
        if (!bodies_[i].asleep) members_.push_back(i);
    predict_together(members_, 0);
}

/// Handles events and ticks in order of time; a tick comes before an event at the same time.
void ContinuousSolver::handle_until(double time) {
    for (;;) {
        const double event = next_events_.time();
        if (any_in_island_ && next_tick_ <= std::min(event, time) && next_tick_ < end_) {
            tick(next_tick_);
            continue;
        }
        if (event > time || event > end_) return;
        record_->trace ? trace_event(next_events_.first()) : handle(next_events_.first());
        // What its event will read: with 100,000 balls an event takes a sixth less time.
        const BallIndex soon = next_events_.soon();
        prefetch(movers_[soon]), prefetch(bodies_[soon]), prefetch(hot_[soon]), prefetch(candidates_[soon]);
    }
}

/// The ball `time` seconds after the start of the window.
Ball ContinuousSolver::ball_at(BallIndex i, double time) const {
    Ball ball = bodies_[i];
    if (ball.asleep) return ball;
    advance(ball, movers_[i].motion, time);
    if (movers_[i].on_tick_path) ball.velocity = true_velocity(i, time);
    return ball;
}

/// Records the events up to `time` that are not recorded yet; their times are clamped to `now`.
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

/// Replaces `balls` by their state at `time`, without lost balls.
void ContinuousSolver::read(double time, double now, std::vector<Ball>& balls) {
    balls.clear();
    read_at_ = time;
    constexpr BallIndex ahead = 6;  // balls; loading one takes about as long as reading these
    for (BallIndex i = 0; i < movers_.size(); ++i) {
        if (i + ahead < movers_.size()) prefetch(movers_[i + ahead].motion);
        rank_[i] = static_cast<BallIndex>(balls.size());
        if (!hot_[i].lost) balls.push_back(ball_at(i, time));
    }
    report_until(time, now);
}

/// Reads the balls at the end of the window, and updates contacts and sleep.
void ContinuousSolver::end(double now, std::vector<Ball>& balls) {
    read(end_, now, balls);
    report_until(INFINITY, now);
    in_window_ = false;
    contacts_.refresh(layout_, table_, balls, find_pairs(balls));
    contacts_.wake_unsupported(balls, scene_.gravity);
    if (settings_.sleep) fell_asleep_ |= sleep_.update(balls, contacts_.contacts());
}

std::shared_ptr<const State> ContinuousSolver::origin() const {
    return in_window_ ? without_gone(start()) : nullptr;
}

void ContinuousSolver::keep() {
    kept_ = current_;
    kept_in_window_ = in_window_;
}

std::shared_ptr<const State> ContinuousSolver::kept_origin() const {
    return kept_in_window_ ? without_gone(starts_[kept_]) : nullptr;
}

bool ContinuousSolver::resume(const State& state, std::vector<Ball>& balls, StepRecord& record) {
    record_ = &record;
    begin(balls);
    if (!(state.clock.time >= table_.time() && state.clock.time < end_on_clock_)) return false;
    try {
        advance_to(state.clock, balls);
    } catch (const Refusal&) {
        return false;
    }
    return true;
}

std::span<const Pair> ContinuousSolver::find_pairs(std::span<const Ball> balls) {
    pairs_.clear();
    if (!paths_started_) return pairs_;
    for (BallIndex i = 0; i < movers_.size(); ++i) {
        const bool near_ball = near_[i].ball_at(read_at_);
        if (!(near_ball || near_[i].part) || hot_[i].lost || bodies_[i].asleep) continue;
        if (near_[i].part) pair_with_parts(balls, i);
        if (near_ball) pair_with_balls(balls, i);
    }
    return pairs_;
}

void ContinuousSolver::pair_with_parts(std::span<const Ball> balls, BallIndex i) {
    const Ball& ball = balls[rank_[i]];
    const Handle handle = layout_.size() + rank_[i];
    const Box box = touching_box(ball);
    const std::size_t first = pairs_.size();
    for (const FeatureIndex f : features_near(i, box)) {
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
