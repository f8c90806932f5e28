// A step: windows on the grid of the world's time, the events of each in order of time, and the balls at its
// end.

#include "custom/continuous/continuous_solver.hpp"

#include <algorithm>
#include <bit>

#include "custom/broad_phase/capacity.hpp"
#include "custom/engine.hpp"
#include "custom/trace/continuous_trace.hpp"
#include "world/refusal.hpp"

namespace flipside::custom {

namespace {

constexpr double window_length = 1.0 / 4;  // s; a multiple of 1/60 s
constexpr double rest_length = 1.0 / 20;   // s: how long a ball must be at rest to fall asleep

Box near_box(const Ball& ball) {
    return bounds_of(ball.position, ball.radius * (1 + sleep_distance));
}

/// Asks the processor to load an object into its cache while it works on others. It changes no result, and
/// pays where so many balls are simulated that their data does not fit there. Inlined always, since GCC
/// removes calls of functions that do nothing but this.
template <class T>
[[gnu::always_inline]] inline void prefetch(const T& object) {
    constexpr std::size_t cache_line = 64;  // bytes
    const auto* bytes = static_cast<const char*>(static_cast<const void*>(&object));
    for (std::size_t at = 0; at < sizeof(T); at += cache_line) __builtin_prefetch(bytes + at);
}

std::shared_ptr<const State> without_gone(const State& start) {
    auto origin = std::make_shared<State>(start);
    Table::forget_gone(*origin);
    return origin;
}

}  // namespace

ContinuousSolver::ContinuousSolver(Table& table, const Layout& layout, BroadPhase& broad,
                                   const SolverSettings& settings)
    : sim_(table, layout, settings),
      gates_(sim_),
      paths_(sim_, gates_),
      predictions_(sim_, gates_, paths_),
      islands_(sim_, gates_, paths_, predictions_),
      events_(sim_, gates_, paths_, predictions_, islands_),
      sleep_(settings.sleep_speed, sim_.external),
      contacts_(layout, table, broad, sleep_distance) {
    for (State& start : starts_) table.copy(start);
}

void ContinuousSolver::reserve(std::size_t balls) {
    // Launched balls must not allocate.
    const std::size_t most = std::bit_ceil(balls + (sim_.scene.launcher ? spare : 0));
    sim_.reserve(most);
    predictions_.reserve(most);
    islands_.reserve(most);
    events_.reserve(most);
    for (State& start : starts_) {
        custom::reserve_for(start.balls, most);
        custom::reserve_for(start.memory.forces, most, contacts_per_ball);
        custom::reserve_for(start.memory.inside, most, touches_per_ball);
        start.blocked.reserve(std::min(most, sim_.layout.gates().empty() ? 0 : most_near));
    }
    custom::reserve_for(awake_, most);
    custom::reserve_for(pairs_, most, pairs_per_ball);
    if (rank_.size() < most) rank_.resize(most);
    sleep_.reserve(balls);
    contacts_.reserve(balls);
}

void ContinuousSolver::step(double dt, std::vector<Ball>& balls, StepRecord& record) {
    sim_.record = &record;
    sleep_changed_ = false;
    record.statistics.handed_over = in_window_ ? sim_.members : 0;
    Clock now = sim_.table.clock();
    now.advance(dt);
    advance_to(now, balls);
    if (quiet_ && record.trace)
        record.trace->stage("asleep", "src/custom/continuous/continuous_solver.cpp: ContinuousSolver::step")
            .says = "No ball is awake and no part moves: nothing is done.";
}

/// Advances to `now`, with stops at the ends of windows and at the instants at which sleep_ watches the
/// balls.
void ContinuousSolver::advance_to(const Clock& now, std::vector<Ball>& balls) {
    sim_.now = now.time;
    for (;;) {
        if (!in_window_ && !quiet_) begin(balls);
        if (quiet_) return sim_.table.set_to(now, sim_.table.parts(), 0);
        const double stop = std::min(watch_at_, end_on_clock_);
        const Clock here = stop < now.time ? Clock{stop, 0} : now;
        const double ahead = here.time - sim_.start;
        if (sim_.record->trace && sim_.record->trace->stages.empty()) trace_paths(sim_, false);
        handle_until(ahead);
        sim_.table.set_to(here, starts_[current_].parts, ahead);
        if (here.time < stop) return read(ahead, balls);
        if (stop == end_on_clock_) {
            end(balls);
        } else {
            read(ahead, balls);
            sleep_.watch(balls, end_on_clock_ - watch_at_);
            watch_at_ = INFINITY;
        }
        if (stop >= now.time) return;
    }
}

void ContinuousSolver::load(std::span<const Ball> balls) {
    EngineMemory& memory = sim_.table.memory();
    if (memory.engine == engine_name && memory.time == sim_.table.time()) return;
    memory = {std::string(engine_name), sim_.table.time(), {}};
    gates_.find_sensed(balls);
}

/// Begins a window at the table's time.
void ContinuousSolver::begin(const std::vector<Ball>& balls) {
    if (!contacts_known_) contacts_.search(balls);
    contacts_known_ = true;
    choose_end();
    events_.clear();
    sim_.search_steps = 0;
    sim_.any_in_island = false;
    for (const PartIndex i : sim_.table.moving_parts()) {
        const auto [pose, rate, stop] = sim_.table.turning(i, 0);
        const double last = std::isfinite(stop) ? sim_.table.pose(i, stop).angle : pose.angle;
        sim_.turnings[i] = {pose, rate, stop, last};
    }
    if (rank_.size() < balls.size()) reserve(balls.size());
    sim_.start_with(balls);
    gates_.settle();
    current_ = 1 - kept_;
    sim_.table.copy(starts_[current_]);
    starts_[current_].balls = sim_.balls;
    quiet_ = std::ranges::all_of(sim_.balls, &Ball::asleep) &&
             std::ranges::all_of(sim_.turnings, [](const Turning& turning) { return turning.still(); });
    in_window_ = !quiet_;
    if (quiet_) return sim_.table.memory().forces.clear();
    start_all_paths();
    if (sim_.record->trace) trace_paths(sim_, true);
}

/// Ends the window at the next point of the grid, and chooses when to watch which balls are at rest.
void ContinuousSolver::choose_end() {
    sim_.start = sim_.table.time();
    double next = std::floor(sim_.start / window_length) + 1;
    while (next * window_length <= sim_.start) ++next;
    end_on_clock_ = next * window_length;
    sim_.end = end_on_clock_ - sim_.start;
    sim_.after_end = std::nextafter(sim_.end, INFINITY);
    watch_at_ = end_on_clock_ - rest_length;
    if (!sim_.settings.sleep || watch_at_ <= sim_.start) watch_at_ = INFINITY;
    sleep_.watch({}, rest_length);
}

/// Starts and predicts the paths of all balls at the start of the window.
void ContinuousSolver::start_all_paths() {
    predictions_.clear();
    sim_.cells.reset(sim_.balls);
    for (BallIndex i = 0; i < sim_.balls.size(); ++i) {
        if (!sim_.balls[i].asleep) paths_.push_out_of_parts(i);
        paths_.start_path(i, 0);
    }
    islands_.start_window();
    awake_.clear();
    for (BallIndex i = 0; i < sim_.balls.size(); ++i)
        if (!sim_.balls[i].asleep) awake_.push_back(i);
    predictions_.predict(awake_, 0);
}

/// Handles events and ticks in order of time; a tick comes before an event at the same time.
void ContinuousSolver::handle_until(double time) {
    const EventQueue& queue = predictions_.queue();
    for (;;) {
        const double event = queue.time();
        if (sim_.any_in_island && sim_.tick_at <= std::min(event, time) && sim_.tick_at < sim_.end) {
            islands_.tick(sim_.tick_at);
            continue;
        }
        if (event > time) return;
        const BallIndex first = queue.first();
        if (sim_.record->trace)
            trace_event(sim_, first, [&] { events_.handle(first); });
        else
            events_.handle(first);
        // What its event will read: with 100,000 balls an event takes a fifth less time.
        const BallIndex soon = queue.soon();
        prefetch(sim_.particles[soon]), prefetch(sim_.balls[soon]), prefetch(sim_.hot[soon]);
        prefetch(sim_.near[soon]), prefetch(sim_.cells[soon]), prefetch(sim_.cells.link(soon));
    }
}

/// Replaces `balls`, those of the window, by their state at `time`, without lost balls.
void ContinuousSolver::read(double time, std::vector<Ball>& balls) {
    BallIndex count = 0;
    for (BallIndex i = 0; i < sim_.particles.size(); ++i) {
        rank_[i] = count;
        if (!sim_.hot[i].lost) sim_.read(i, time, balls[count++]);
    }
    balls.resize(count);
}

/// Reads the balls at the end of the window, and updates contacts and sleep.
void ContinuousSolver::end(std::vector<Ball>& balls) {
    read(sim_.end, balls);
    in_window_ = false;
    contacts_.refresh(balls, find_pairs(balls));
    sleep_changed_ |= contacts_.wake_unsupported(balls);
    if (sim_.settings.sleep) sleep_changed_ |= sleep_.update(balls, contacts_.contacts());
}

std::shared_ptr<const State> ContinuousSolver::origin() const {
    return in_window_ ? without_gone(starts_[current_]) : nullptr;
}

void ContinuousSolver::keep() {
    kept_ = current_;
    kept_in_window_ = in_window_;
}

std::shared_ptr<const State> ContinuousSolver::kept_origin() const {
    return kept_in_window_ ? without_gone(starts_[kept_]) : nullptr;
}

bool ContinuousSolver::resume(const Clock& to, std::vector<Ball>& balls, StepRecord& record) {
    sim_.record = &record;
    begin(balls);
    if (!(to.time >= sim_.table.time() && to.time < end_on_clock_)) return false;
    try {
        advance_to(to, balls);
    } catch (const Refusal&) {
        return false;
    }
    return true;
}

std::span<const Pair> ContinuousSolver::find_pairs(std::span<const Ball> balls) {
    pairs_.clear();
    if (quiet_) return pairs_;
    const double time = sim_.table.time() - sim_.start;
    for (BallIndex i = 0; i < sim_.particles.size(); ++i) {
        const bool near_ball = sim_.near[i].ball_at(time);
        if (!(near_ball || sim_.near[i].part) || sim_.hot[i].lost || sim_.balls[i].asleep) continue;
        if (sim_.near[i].part) pair_with_parts(balls, i, time);
        if (near_ball) pair_with_balls(balls, i);
    }
    return pairs_;
}

void ContinuousSolver::pair_with_parts(std::span<const Ball> balls, BallIndex i, double time) {
    const Ball& ball = balls[rank_[i]];
    const Handle handle = sim_.layout.size() + rank_[i];
    const Box box = near_box(ball);
    const std::size_t first = pairs_.size();
    for (const FeatureIndex f : sim_.features_near(box)) {
        const Feature& feature = sim_.features[f];
        if (!layers_meet(ball, feature)) continue;
        // The box of an arc is mostly empty.
        const Pose pose = sim_.turnings[feature.part].pose(time);
        if (std::holds_alternative<Arc>(feature.is) &&
            closest_point(feature, ball.position, ball.radius, pose).distance >
                ball.radius * (1 + sleep_distance))
            continue;
        const Pair pair{feature.primitive, handle};
        if (pairs_.size() == first || pairs_.back() != pair) pairs_.push_back(pair);
    }
}

/// Adds the pairs of a ball with sleeping balls and with awake balls of a lower index.
void ContinuousSolver::pair_with_balls(std::span<const Ball> balls, BallIndex i) {
    const Ball& ball = balls[rank_[i]];
    const Box box = near_box(ball);
    sim_.cells.query_neighbours(i, [&](BallIndex j) {
        if (j > i && !sim_.balls[j].asleep) return;
        ++sim_.record->statistics.pair_tests;
        const Ball& other = balls[rank_[j]];
        if (!overlap(box, near_box(other)) || !layers_meet(ball, other)) return;
        const Handle a = sim_.layout.size() + rank_[i], b = sim_.layout.size() + rank_[j];
        pairs_.push_back({std::min(a, b), std::max(a, b)});
    });
}

}  // namespace flipside::custom
