#include "app/window/run.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "app/window/claim.hpp"
#include "lab/session/timeline.hpp"
#include "world/refusal.hpp"

namespace flipside::app {

namespace {

std::size_t count_overlaps(std::span<const Ball> balls) {
    std::vector<Vec2> places;
    places.reserve(balls.size());
    for (const Ball& ball : balls) places.push_back(ball.position);
    const auto before = [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
    std::ranges::sort(places, before);
    std::size_t overlaps = 0;
    for (std::size_t i = 1; i < places.size(); ++i) overlaps += places[i] == places[i - 1];
    return overlaps;
}

}  // namespace

Run::Run(const lab::Contender& contender, lab::Session session, const Script& script)
    : name_(contender.name),
      dt_(contender.dt),
      session_(std::move(session)),
      next_control_(lab::next_control(script, session_.world().time())),
      traces_(session_.scene().parts.size()),
      counted_(session_.totals()) {
    recorder_.start(session_, next_control_);
    measure_energy(true);
}

bool Run::step_within(double span, const Script& script, double seconds) {
    if (halt_) return true;
    if (!under_way()) events_.clear();
    const lab::Timeline steps(0, span, dt_);
    const double share = seconds / static_cast<double>(std::max<std::uint64_t>(1, steps.steps()));
    try {
        for (; done_ < steps.steps(); ++done_) {
            if (!session_.step_within(steps.length(done_), script, next_control_, share)) return false;
            observe_step();
        }
        recorder_.record(session_, {span, dt_, std::exchange(pressed_, {})}, events_, next_control_);
    } catch (const Refusal& refusal) {
        halt_ = recorded_halt_ = Halt{session_.world().time(), refusal.what()};
    }
    done_ = 0;
    return true;
}

bool Run::follow(lab::ReplaySteps& replay, double time) {
    constexpr double same_time = 1e-9;  // s
    events_.clear();
    try {
        while (session_.world().time() < time - same_time && replay.step(session_)) observe_step();
        if (const auto& reason = replay.refusal())
            halt_ = Halt{session_.world().time(), *reason};
        else
            halt_.reset();
    } catch (const Refusal& refusal) {
        halt_ = Halt{session_.world().time(), refusal.what()};
    }
    dt_ = replay.dt();
    step_cost_ = 0;  // what it costs to show a game again is none of the game's
    return session_.world().time() >= time - same_time;
}

bool Run::press(const Control& control) {
    if (halt_ || !session_.press(control)) return false;
    pressed_.push_back(control);
    return true;
}

void Run::go_to(double time, const Script& script) {
    const std::size_t moment = recorder_.at(time);
    events_ = recorder_.restore(moment, session_, script);
    next_control_ = recorder_.next_control(moment);
    done_ = 0;
    pressed_.clear();
    traces_ = Traces(session_.scene().parts.size());
    halt_ = recorded_halt_ && time >= recorded_halt_->time ? recorded_halt_ : std::nullopt;
    energy_ = lab::energy(session_.world(), session_.scene());
    for (const Sample& baseline : baselines_)
        if (baseline.time <= session_.world().time()) energy_before_ = baseline.value;
    balls_ = session_.world().balls().size();
    count_from_here();
}

bool Run::played_by_hand() const {
    const auto is_a_key = [](const lab::Recording::Entry& entry) {
        if (const auto* press = std::get_if<lab::move::Press>(&entry.move)) {
            const auto* launch = std::get_if<control::Launch>(&press->control);
            return launch == nullptr || (launch->count == 1 && launch->size == 1);
        }
        return std::holds_alternative<lab::move::StepLength>(entry.move) ||
               std::holds_alternative<lab::move::Check>(entry.move);
    };
    return !went_back_ && !session_.recording().spoiled() &&
           std::ranges::all_of(session_.recording().entries(), is_a_key);
}

void Run::go_on_from_here() {
    went_back_ = true;
    const double now = session_.world().time();
    recorder_.forget_after(recorder_.at(now));
    recorded_halt_ = halt_;
    impacts_.forget_after(now);
    passed_horizon_ = passed_horizon();
    std::erase_if(baselines_, [now](const Sample& later) { return later.time > now; });
    while (!numbers_.empty() && numbers_.back().time > now) numbers_.pop_back();
    forget_after(uncertainty_, now);
}

void Run::count_from_here() {
    spent_ = session_.totals().step_seconds;
    timed_ = {};
    counted_ = session_.totals();
}

void Run::trace(Trace* trace) {
    traced_ = trace != nullptr;
    session_.world().trace(trace);
}

double Run::take_cost() {
    const double before = std::exchange(spent_, session_.totals().step_seconds);
    if (traced_) return std::numeric_limits<double>::quiet_NaN();
    const double cost = spent_ - before;
    step_cost_ = step_cost_ == 0 ? cost : step_cost_ + 0.05 * (cost - step_cost_);
    ++timed_.steps;
    timed_.seconds += cost;
    return cost;
}

void Run::observe_step() {
    events_.insert(events_.end(), session_.events().begin(), session_.events().end());
    const double cost = take_cost();
    traces_.observe(session_.events(), session_.world().balls(), session_.world().time());
    impacts_.observe(session_.events(), session_.world().balls());
    measure_energy(false);
    measure_uncertainty();
    const World& world = session_.world();
    numbers_.push_back({world.time(), energy_, cost, world.statistics(), world.balls().size(),
                        deepest_overlap(world.contacts()), dt_, session_.scene().gravity});
    while (numbers_.front().time < world.time() - lab::Recorder::longest) numbers_.pop_front();
}

void Run::measure_uncertainty() {
    const World& world = session_.world();
    if (world.uncertainty().empty()) return;
    double worst = 0;
    for (std::size_t i = 0; i < world.balls().size(); ++i)
        worst = std::max(worst, uncertainty_in_radii(world, i));
    remember(uncertainty_, {world.time(), worst});
    if (worst < horizon_radii)
        passed_horizon_.reset();
    else if (!passed_horizon_)
        passed_horizon_ = world.time();
}

std::optional<double> Run::passed_horizon() const {
    return passed_horizon_ && *passed_horizon_ <= session_.world().time() ? passed_horizon_ : std::nullopt;
}

bool Run::is_measure_at(double time) const {
    constexpr double same_time = 1e-9;  // s
    const auto after = std::ranges::upper_bound(uncertainty_, time + same_time, {}, &Sample::time);
    return after == uncertainty_.begin() || std::prev(after)->value < horizon_radii;
}

void Run::measure_energy(bool start_anew) {
    const World& world = session_.world();
    energy_ = lab::energy(world, session_.scene());
    if (start_anew || world.balls().size() != balls_) {
        energy_before_ = energy_;
        baselines_.push_back({world.time(), energy_});
        while (baselines_.size() > 1 && baselines_[1].time < world.time() - lab::Recorder::longest)
            baselines_.pop_front();
    }
    balls_ = world.balls().size();
}

void Run::change(std::shared_ptr<const Scene> scene, const lab::Contender& contender) {
    const bool another = contender.engine != &session_.engine();
    session_.change(std::move(scene), *contender.engine, contender.settings);
    name_ = contender.name;
    dt_ = contender.dt;
    done_ = 0;
    halt_.reset();
    recorded_halt_.reset();
    uncertainty_.clear();
    passed_horizon_.reset();
    step_cost_ = 0;
    spent_ = session_.totals().step_seconds;
    measure_energy(true);
    if (!another) return record_change();
    // Of another engine the past is another's.
    impacts_ = {};
    pressed_.clear();
    recorder_.start(session_, next_control_);
}

void Run::record_change() {
    // It has in it what was pressed since the last step.
    pressed_.clear();
    recorder_.changed(session_, events_);
}

void Run::clear() {
    halt_.reset();
    recorded_halt_.reset();
    session_.clear();
    measure_energy(true);
    record_change();
}

bool Run::permits(const lab::BallEdit& edit) const {
    return !halt_ && lab::edited(session_.scene(), session_.world().save(), edit);
}

void Run::edit(const lab::BallEdit& edit) {
    const auto state = halt_ ? std::nullopt : lab::edited(session_.scene(), session_.world().save(), edit);
    if (!state) return;
    session_.edit(edit, *state);
    measure_energy(true);
    record_change();
}

void Run::refresh(double running) {
    const lab::Totals& now = session_.totals();
    const auto since = [](std::uint64_t a, std::uint64_t b) { return static_cast<double>(a - b); };
    const double pair_tests = since(now.pair_tests, counted_.pair_tests);
    const double narrow_tests = since(now.narrow_tests, counted_.narrow_tests);
    const double steps = since(now.steps, counted_.steps);
    rates_.overlaps = count_overlaps(session_.world().balls());
    if (running > 0) {
        rates_.pair_tests = pair_tests / running;
        rates_.narrow_tests = narrow_tests / running;
        rates_.impacts = since(now.impacts, counted_.impacts) / running;
    }
    if (steps > 0) {
        rates_.pair_tests_per_step = pair_tests / steps;
        rates_.narrow_tests_per_step = narrow_tests / steps;
    } else if (const StepNumbers* shown = numbers_at(numbers_, session_.world().time())) {
        rates_.pair_tests_per_step = static_cast<double>(shown->statistics.pair_tests);
        rates_.narrow_tests_per_step = static_cast<double>(shown->statistics.narrow_tests);
        if (shown->timed()) rates_.step_seconds = shown->cost;
    }
    if (timed_.steps > 0) rates_.step_seconds = timed_.seconds / static_cast<double>(timed_.steps);
    timed_ = {};
    counted_ = now;
}

}  // namespace flipside::app
