#include "app/film/replay_stage.hpp"

#include <algorithm>

namespace flipside::app::film {

namespace {

std::vector<lab::Contender> contenders_of(const lab::Replay& replay, const Engine* other) {
    std::vector<lab::Contender> contenders;
    for (const lab::ReplayRun& run : replay.runs) {
        contenders.push_back({run.start.engine, run.start.settings, run.name, run.dt});
        if (other == nullptr) continue;
        contenders.back().engine = other;
        contenders.back().settings = lab::settings_for(*other, *replay.scene);
        contenders.back().name = other->name;
        break;
    }
    return contenders;
}

}  // namespace

ReplayStage::ReplayStage(const lab::Replay& replay, View view, const Engine* other)
    : stage_(replay.scene, contenders_of(replay, other), view) {
    for (Run& run : stage_.runs()) {
        const auto at = std::ranges::find(replay.runs, run.name(), &lab::ReplayRun::name);
        const std::size_t number = other ? 0 : static_cast<std::size_t>(at - replay.runs.begin());
        replays_.push_back(other ? lab::ReplaySteps(replay, 0, *other) : lab::ReplaySteps(replay, number));
        // With the gravity with which it began.
        const lab::Contender& contender =
            *std::ranges::find(stage_.contenders(), run.name(), &lab::Contender::name);
        const int twin = run.twin();
        run = Run(contender, replays_.back().begin(), {});
        run.set_twin(twin);
        end_ = std::max(end_, lab::duration_of(replay.runs[number]));
    }
}

bool ReplayStage::step() {
    double span = 0;
    for (const Run& run : stage_.runs()) span = std::max(span, run.dt());
    const double next = time_ + span;
    bool any = false;
    double latest = 0;
    for (std::size_t i = 0; i < replays_.size(); ++i) {
        any |= stage_.runs()[i].follow(replays_[i], next);
        latest = std::max(latest, stage_.runs()[i].session().world().time());
    }
    time_ = any ? latest : next;
    stage_.compare_runs();
    return any;
}

const std::string* ReplayStage::parted() const {
    for (std::size_t i = 0; i < replays_.size(); ++i)
        if (replays_[i].parting()) return &stage_.runs()[i].name();
    return nullptr;
}

}  // namespace flipside::app::film
