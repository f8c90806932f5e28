#include "app/window/microscope.hpp"

#include <algorithm>

namespace flipside::app {

namespace {

/// Kinds of items that say where a ball has come to. (Others tell of places that it had or will have.)
constexpr std::string_view moves[] = {"move", "response", "position", "event", "member", "ball"};

Ball* find(std::vector<Ball>& balls, const TraceItem& item, std::string_view name) {
    const TraceValue* number = item.find(name);
    if (number == nullptr) return nullptr;
    const auto at =
        std::ranges::find(balls, static_cast<BallNumber>(std::get<std::int64_t>(*number)), &Ball::number);
    return at == balls.end() ? nullptr : &*at;
}

void take_over(const TraceItem& item, std::string_view position, std::string_view velocity, Ball* ball) {
    if (ball == nullptr) return;
    if (const TraceValue* value = item.find(position)) ball->position = std::get<Vec2>(*value);
    if (const TraceValue* value = item.find(velocity)) ball->velocity = std::get<Vec2>(*value);
}

}  // namespace

void Microscope::take_step(Stage& stage) {
    const std::size_t looked_at = run_;
    traces_.assign(stage.runs().size(), {});
    for (std::size_t i = 0; i < traces_.size(); ++i) {
        Run& run = stage.runs()[i];
        const auto balls = run.session().world().balls();
        traces_[i].before.assign(balls.begin(), balls.end());
        run.trace(&traces_[i].trace);
    }
    stage.step();
    for (std::size_t i = 0; i < traces_.size(); ++i) {
        Run& run = stage.runs()[i];
        run.trace(nullptr);
        traces_[i].name = run.name();
        traces_[i].steps = run.session().totals().steps;
        const auto balls = run.session().world().balls();
        traces_[i].after.assign(balls.begin(), balls.end());
        if (run.halt()) {
            traces_[i].trace.stages.clear();
            TraceStage& stopped = traces_[i].trace.stage("stopped", "src/world/refusal.hpp: Refusal");
            stopped.says = run.halt()->reason + ".";
        }
    }
    look_at(std::min(looked_at, traces_.size() - 1));
}

bool Microscope::shows(const Stage& stage) const {
    if (traces_.empty() || traces_.size() != stage.runs().size()) return false;
    for (std::size_t i = 0; i < traces_.size(); ++i) {
        const Run& run = stage.runs()[i];
        const Traced& traced = traces_[i];
        if (run.name() != traced.name || run.session().totals().steps != traced.steps) return false;
        if (!std::ranges::equal(run.session().world().balls(), traced.after)) return false;
    }
    return !stage.under_way();
}

void Microscope::look_at(std::size_t run) {
    run_ = run;
    to_stage(0);
}

bool Microscope::next() {
    if (at_ + 1 >= stages().size()) return false;
    to_stage(at_ + 1);
    return true;
}

bool Microscope::back() {
    if (at_ == 0) return false;
    to_stage(at_ - 1);
    return true;
}

void Microscope::to_stage(std::size_t stage) {
    at_ = stage;
    pick_by_key(0);
    show_balls();
}

void Microscope::show_balls() {
    const bool over = at_ + 1 == stages().size();
    for (Traced& traced : traces_) traced.now = over ? traced.after : traced.before;
    if (over) return;
    std::vector<Ball>& balls = traces_[run_].now;
    for (std::size_t k = 0; k <= at_; ++k)
        for (const TraceItem& item : stages()[k].items) {
            if (std::ranges::find(moves, item.kind) == std::end(moves)) continue;
            take_over(item, "position", "velocity", find(balls, item, "ball"));
            take_over(item, "other_position", "other_velocity", find(balls, item, "other_ball"));
        }
}

}  // namespace flipside::app
