/// How a stage goes back in time, and on from there.

#include <algorithm>

#include "app/window/stage.hpp"

namespace flipside::app {

namespace {

double begin_of(const Run& run) {
    return run.recorder().time(0);
}

double end_of(const Run& run) {
    return run.recorder().time(run.recorder().size() - 1);
}

/// The one that came furthest: others may have halted.
const Run& furthest(const std::vector<Run>& runs) {
    return *std::ranges::max_element(runs, {}, &end_of);
}

}  // namespace

double Stage::record_begin() const {
    const double begin = begin_of(*std::ranges::max_element(runs_, {}, &begin_of));
    return std::min(begin, record_end());
}

double Stage::record_end() const {
    return end_of(furthest(runs_));
}

void Stage::go_to(double time) {
    if (under_way()) return;
    const double there = std::clamp(time, record_begin(), record_end());
    for (Run& run : runs_) run.go_to(there, script_);
    in_past_ = there < record_end();
    // Settings and gravity are those of then.
    for (Run& run : runs_) contenders_[place_of(run)].settings = run.session().settings();
    scene_ = runs_.front().session().shared_scene();
    gravity_ = scene_ == original_ || !has_gravity();
}

bool Stage::step_back() {
    const lab::Recorder& recorder = furthest(runs_).recorder();
    const std::size_t now = recorder.at(furthest(runs_).session().world().time());
    if (under_way() || now == 0 || recorder.time(now - 1) < record_begin()) return false;
    go_to(recorder.time(now - 1));
    return true;
}

bool Stage::step_forward() {
    const lab::Recorder& recorder = furthest(runs_).recorder();
    const std::size_t now = recorder.at(furthest(runs_).session().world().time());
    if (under_way() || now + 1 >= recorder.size()) return false;
    go_to(recorder.time(now + 1));
    return true;
}

void Stage::go_on_from_here() {
    if (!in_past_) return;
    in_past_ = false;
    for (Run& run : runs_) run.go_on_from_here();
    for (Divergence& divergence : divergences_) divergence.forget_after(time());
}

}  // namespace flipside::app
