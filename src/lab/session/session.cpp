#include "lab/session/session.hpp"

#include <algorithm>
#include <limits>

#include "lab/process/allocations.hpp"
#include "lab/process/cpu_clock.hpp"
#include "lab/session/checksum.hpp"
#include "lab/session/refusing_world.hpp"
#include "world/refusal.hpp"
#include "world/table.hpp"

namespace flipside::lab {

Session::Session(std::shared_ptr<const Scene> scene, const Engine& engine, Settings settings,
                 WithoutWorld otherwise)
    : scene_(std::move(scene)),
      engine_(&engine),
      settings_(std::move(settings)),
      otherwise_(otherwise),
      world_(make(scene_, engine, settings_)),
      game_(scene_),
      recording_(engine, settings_, scene_->gravity) {}

std::unique_ptr<World> Session::make(const std::shared_ptr<const Scene>& scene, const Engine& engine,
                                     const Settings& settings) const {
    return otherwise_ == WithoutWorld::fail ? engine.make(scene, settings)
                                            : world_or_refusal(engine, scene, settings);
}

void Session::apply(const Control& control) {
    recording_.add(move::Press{world_->time(), control});
    hand_over(control);
}

bool Session::press(const Control& control) {
    if (!game_.permits(control, world_->balls())) return false;
    apply(control);
    return true;
}

void Session::hand_over(const Control& control) {
    world_->apply(control);
    game_.applied(control, world_->time());
}

void Session::edit(const BallEdit& edit, const State& edited) {
    go_on_from(edited);
    recording_.add(move::Edit{edit});
}

void Session::clear() {
    State state = world_->save();
    state.balls.clear();
    state.launches.clear();
    go_on_from(state);
    recording_.add(move::Clear{});
}

void Session::resume() {
    abandon_step();
    world_->restore(world_->save());
    recording_.add(move::Resume{});
}

void Session::abandon_step() {
    if (under_way_ && under_way_->begun)
        recording_.spoil("something was changed in the middle of a step of " + std::string(engine_->name));
    under_way_.reset();
}

void Session::step(double dt) {
    const Script nothing;
    std::size_t next = 0;
    step(dt, nothing, next);
}

void Session::step(double dt, const Script& script, std::size_t& next) {
    static_cast<void>(step_within(dt, script, next, std::numeric_limits<double>::infinity()));
}

bool Session::step_within(double dt, const Script& script, std::size_t& next, double seconds) {
    if (!under_way_) {
        events_.clear();
        under_way_ = Progress{world_->clock(), dt};
        under_way_->end.advance(dt);
        recording_.begin_step(dt);
    }
    auto& [end, left, portion, begun] = *under_way_;
    while (left > 0) {
        if (portion == 0) portion = until_stop(script, next);
        if (!advance(portion, seconds)) return false;
        left = portion < left ? world_->clock().until(end) : 0;
        portion = 0;
        begun = true;
    }
    ++totals_.steps;
    under_way_.reset();
    recording_.end_step();
    if (recording_.steps() % steps_between_checks == 0)
        recording_.add(move::Check{checksum_of(*world_, game_)});
    return true;
}

double Session::until_stop(const Script& script, std::size_t& next) {
    const double left = under_way_->left;
    const auto until = [&](double time) { return world_->clock().until({time, 0}); };
    for (; next < script.size(); ++next) {
        const double ahead = until(script[next].time);
        if (ahead >= left - same_moment) break;
        if (ahead > same_moment) return until_look(ahead);
        // The time that was asked for, not the world's: so a replay splits its steps at the very same times.
        recording_.add(move::Scripted{script[next]});
        hand_over(script[next].control);
    }
    return until_look(left);
}

double Session::until_look(double stop) const {
    if (!world_->launch_waiting()) return stop;
    const Clock now = world_->clock();
    const double ahead = now.until({next_look(now.time), 0});
    return ahead < stop - same_moment ? ahead : stop;
}

bool Session::advance(double dt, double seconds) {
    const std::uint64_t allocated = allocations();
    const CpuStopwatch watch;
    bool done = false;
    try {
        done = world_->step_within(dt, seconds);
        // An engine may find these only when asked: they are part of what a step costs.
        if (done) static_cast<void>(world_->events()), static_cast<void>(world_->contacts());
    } catch (const Refusal&) {
        under_way_.reset();
        recording_.add(move::Refused{});
        throw;
    }
    const std::optional<double> elsewhere = world_->statistics().cpu_seconds;
    totals_.step_seconds += elsewhere ? (done ? *elsewhere : 0) : watch.seconds();
    if (totals_.steps >= warm_up_steps) totals_.allocations += allocations() - allocated;
    if (!done) return false;

    const Statistics& statistics = world_->statistics();
    totals_.pair_tests += statistics.pair_tests;
    totals_.narrow_tests += statistics.narrow_tests;
    totals_.contacts += statistics.contacts;
    totals_.handed_over += statistics.handed_over;
    totals_.max_penetration = std::max(totals_.max_penetration, deepest_overlap(world_->contacts()));
    for (const Event& event : world_->events()) count(event);
    events_.insert(events_.end(), world_->events().begin(), world_->events().end());

    const long launched = game_.launched();
    const auto answer = game_.observe(world_->events(), world_->time(), world_->balls());
    totals_.launched += static_cast<std::uint64_t>(game_.launched() - launched);
    for (const Control& control : answer) world_->apply(control);
    return true;
}

void Session::count(const Event& event) {
    if (event.kind == EventKind::impact) ++totals_.impacts;
    if (event.kind != EventKind::lost) return;
    ++totals_.lost;
    const Box& bounds = scene_->bounds;
    const bool drained = scene_->rules && event.point.y < bounds.min.y && event.point.x >= bounds.min.x &&
                         event.point.x <= bounds.max.x;
    if (!drained) ++totals_.strays;
}

void Session::change(std::shared_ptr<const Scene> scene, const Engine& engine, Settings settings) {
    State state = world_->save();
    // What lay at rest under one gravity need not under another.
    if (scene->gravity != scene_->gravity)
        for (Ball& ball : state.balls) ball.asleep = false;
    std::unique_ptr<World> next = make(scene, engine, settings);
    next->restore(state);
    world_ = std::move(next);
    abandon_step();
    scene_ = std::move(scene);
    engine_ = &engine;
    settings_ = std::move(settings);
    recording_.add(move::Change{engine_, settings_, scene_->gravity});
}

void Session::restore(const State& state) {
    go_on_from(state);
    recording_.spoil("it goes on from a state that does not come from the scene");
}

void Session::go_on_from(const State& state) {
    world_->restore(state);
    abandon_step();
    game_.resume(state);
}

void Session::restore(const Snapshot& snapshot) {
    if (snapshot.scene != scene_ || snapshot.engine != engine_ || !(snapshot.settings == settings_)) {
        world_ = snapshot.engine->make(snapshot.scene, snapshot.settings);
        scene_ = snapshot.scene;
        engine_ = snapshot.engine;
        settings_ = snapshot.settings;
    }
    world_->restore(snapshot.state);
    under_way_.reset();
    game_ = snapshot.game;
    recording_ = snapshot.recording;
    if (!engine_->restores_exactly) recording_.add(move::Resume{});
    totals_ = snapshot.totals;
    events_ = snapshot.events;
}

std::size_t next_control(const Script& script, double time) {
    const auto at = std::ranges::find_if(
        script, [&](const TimedControl& control) { return control.time >= time - same_moment; });
    return static_cast<std::size_t>(at - script.begin());
}

double energy(const World& world, const Scene& scene) {
    double sum = 0;
    for (const Ball& ball : world.balls()) {
        sum += 0.5 * ball.mass * length_squared(ball.velocity);
        sum += 0.5 * inertia(ball) * ball.spin * ball.spin;
        sum -= ball.mass * dot(scene.gravity, ball.position);
    }
    return sum;
}

}  // namespace flipside::lab
