#include "custom/continuous/windows.hpp"

#include <cmath>

#include "custom/engine.hpp"
#include "world/refusal.hpp"

namespace flipside::custom {

namespace {

constexpr double window_length = 1.0 / 4;  // s; a multiple of 1/60 s
constexpr double rest_length = 1.0 / 60;   // s: how long a ball must be at rest to fall asleep

std::shared_ptr<const State> without_gone(const State& start) {
    auto origin = std::make_shared<State>(start);
    Table::forget_gone(*origin);
    return origin;
}

}  // namespace

Windows::Windows(Table& table, const Layout& layout, BroadPhase& broad, const SolverSettings& settings)
    : table_(table),
      layout_(layout),
      broad_(broad),
      settings_(settings),
      solver_(table, layout, settings),
      sleep_(settings.sleep_speed, table.scene().gravity) {}

void Windows::reserve(std::size_t balls) {
    solver_.reserve(balls);
    sleep_.reserve(balls);
    contacts_.reserve(layout_.size(), balls);
}

void Windows::step(double dt, std::vector<Ball>& balls, StepRecord& record) {
    fell_asleep_ = false;
    if (quiet_) return table_.advance(dt);
    Clock now = table_.clock();
    now.advance(dt);
    advance_to(now, balls, record);
}

/// Advances to `now`, with stops at the ends of windows and at the instants at which sleep_ watches the
/// balls.
void Windows::advance_to(const Clock& now, std::vector<Ball>& balls, StepRecord& record) {
    for (;;) {
        if (!in_window_) begin(balls, record);
        if (quiet_) return table_.set_to(now, solver_.start().parts, now.time - solver_.start().clock.time);
        const double stop = watched_ ? end_at_ : watch_at_;
        const Clock here = stop < now.time ? Clock{stop, 0} : now;
        const double ahead = here.time - solver_.start().clock.time;
        solver_.run(ahead, record);
        table_.set_to(here, solver_.start().parts, ahead);
        table_.memory().engine = engine_name;
        table_.memory().time = here.time;
        if (here.time < stop) return solver_.read(ahead, now.time, balls);
        if (watched_) {
            solver_.end(now.time, balls);
            end_window(balls);
        } else {
            solver_.read(ahead, now.time, balls);
            sleep_.watch(balls, end_at_ - watch_at_);
            watched_ = true;
        }
        if (stop >= now.time) return;
    }
}

void Windows::begin(std::vector<Ball>& balls, StepRecord& record) {
    if (!balls_known_) solver_.reset(table_, balls);
    balls_known_ = true;
    if (!contacts_known_) contacts_.search(layout_, table_, balls, broad_);
    contacts_known_ = true;
    const double time = table_.time();
    double next = std::floor(time / window_length) + 1;
    while (next * window_length <= time) ++next;
    end_at_ = next * window_length;
    watch_at_ = end_at_ - rest_length;
    watched_ = !settings_.sleep || watch_at_ <= time;
    sleep_.watch({}, rest_length);
    EngineMemory& memory = table_.memory();
    if (memory.engine != engine_name || memory.time != time) memory.forces.clear();
    solver_.begin(table_, balls, end_at_ - time, record);
    quiet_ = solver_.quiet();
    in_window_ = !quiet_;
}

/// Updates contacts and sleep at the end of a window.
void Windows::end_window(std::vector<Ball>& balls) {
    in_window_ = false;
    contacts_.refresh(layout_, table_, balls, solver_.find_pairs(balls));
    contacts_.wake_unsupported(balls, table_.scene().gravity);
    if (settings_.sleep) fell_asleep_ |= sleep_.update(balls, contacts_.contacts());
}

std::shared_ptr<const State> Windows::origin() const {
    return in_window_ ? without_gone(solver_.start()) : nullptr;
}

void Windows::keep() {
    solver_.keep_start();
    kept_in_window_ = in_window_;
}

std::shared_ptr<const State> Windows::kept_origin() const {
    return kept_in_window_ ? without_gone(solver_.kept_start()) : nullptr;
}

bool Windows::resume(const State& state, std::vector<Ball>& balls, StepRecord& record) {
    begin(balls, record);
    if (!(state.clock.time >= table_.time() && state.clock.time < end_at_)) return false;
    try {
        advance_to(state.clock, balls, record);
    } catch (const Refusal&) {
        return false;
    }
    return true;
}

}  // namespace flipside::custom
