#include "lab/replay/play.hpp"

#include "lab/session/ball_edit.hpp"
#include "lab/session/checksum.hpp"
#include "lab/session/run_settings.hpp"
#include "world/refusal.hpp"

namespace flipside::lab {

/// What the moves do to a session.
struct ReplaySteps::Hands {
    ReplaySteps& steps;
    Session& session;

    void apply(const Control& control) const {
        if (steps.other_ != nullptr)
            static_cast<void>(session.press(control));
        else
            session.apply(control);
    }
    void edit(const BallEdit& edit) const {
        const auto state = edited(session.scene(), session.world().save(), edit);
        if (state) session.edit(edit, *state);
    }
    void clear() const { session.clear(); }
    void change(const move::Change& change) const {
        const auto scene = with_gravity(steps.replay_->scene, change.gravity);
        if (steps.other_ == nullptr)
            session.change(scene, *change.engine, change.settings);
        else if (scene->gravity != session.scene().gravity)
            session.change(scene, session.engine(), session.settings());
    }
    void resume() const {
        if (steps.other_ == nullptr) session.resume();
    }
    void set_step_length(double dt) const { steps.dt_ = dt; }
};

ReplaySteps::ReplaySteps(const Replay& replay, std::size_t run)
    : replay_(&replay), run_(&replay.runs[run]), dt_(run_->dt) {}

ReplaySteps::ReplaySteps(const Replay& replay, std::size_t run, const Engine& other)
    : replay_(&replay), run_(&replay.runs[run]), other_(&other), dt_(run_->dt) {}

Session ReplaySteps::begin() const {
    const auto scene = with_gravity(replay_->scene, run_->start.gravity);
    if (other_ != nullptr) return {scene, *other_, settings_for(*other_, *replay_->scene)};
    return {scene, *run_->start.engine, run_->start.settings, WithoutWorld::refuse_steps};
}

bool ReplaySteps::step(Session& session) {
    const std::uint64_t made = session.recording().steps();
    Hands hands{*this, session};
    while (play_moves(*run_, made, next_move_, hands)) {
        if (other_ != nullptr) continue;
        try {
            session.step(dt_, run_->script, next_control_);
            parting_ = ReplayParting{agreed_, session.world().time()};
            return true;
        } catch (const Refusal& as_in_the_game) {
            refusal_ = as_in_the_game.what();
        }
    }
    if (made >= run_->steps) {
        if (!std::exchange(ended_, true)) compare_end(session);
        return false;
    }
    session.step(dt_, run_->script, next_control_);
    refusal_.reset();
    if (const std::uint64_t now = made + 1; now % steps_between_checks == 0)
        compare(session, run_->checks[now / steps_between_checks - 1]);
    return true;
}

void ReplaySteps::compare(const Session& session, std::uint64_t checksum) {
    if (other_ != nullptr || parting_) return;
    const double time = session.world().time();
    if (checksum_of(session.world(), session.game()) == checksum)
        agreed_ = time;
    else
        parting_ = ReplayParting{agreed_, time};
}

/// The file says time and score at the end once more, for people.
void ReplaySteps::compare_end(const Session& session) {
    compare(session, run_->end.checksum);
    const double time = session.world().time();
    const bool as_told = time == run_->end.time && session.game().score() == run_->end.score;
    if (other_ == nullptr && !parting_ && !as_told) parting_ = ReplayParting{agreed_, time};
}

double duration_of(const ReplayRun& run) {
    double seconds = 0, dt = run.dt;
    std::uint64_t since = 0;
    for (const Recording::Entry& entry : run.moves) {
        const auto* length = std::get_if<move::StepLength>(&entry.move);
        if (length == nullptr) continue;
        seconds += static_cast<double>(entry.step - since) * dt;
        since = entry.step;
        dt = length->dt;
    }
    return seconds + static_cast<double>(run.steps - since) * dt;
}

}  // namespace flipside::lab
