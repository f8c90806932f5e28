#include "lab/replay/play.hpp"

#include "lab/session/ball_edit.hpp"
#include "lab/session/checksum.hpp"
#include "lab/session/run_settings.hpp"
#include "world/refusal.hpp"

namespace flipside::lab {

/// What the moves do to the session of a player.
struct ReplayPlayer::Hands {
    ReplayPlayer& player;

    void apply(const Control& control) const {
        if (player.other_)
            static_cast<void>(player.session_.press(control));
        else
            player.session_.apply(control);
    }
    void edit(const BallEdit& edit) const {
        const auto state = edited(player.session_.scene(), player.session_.world().save(), edit);
        if (state) player.session_.edit(edit, *state);
    }
    void clear() const { player.session_.clear(); }
    void change(const move::Change& change) const {
        const auto scene = with_gravity(player.replay_->scene, change.gravity);
        if (!player.other_)
            player.session_.change(scene, *change.engine, change.settings);
        else if (scene->gravity != player.session_.scene().gravity)
            player.session_.change(scene, player.session_.engine(), player.session_.settings());
    }
    void resume() const {
        if (!player.other_) player.session_.resume();
    }
    void set_step_length(double dt) const { player.dt_ = dt; }
};

ReplayPlayer::ReplayPlayer(const Replay& replay, std::size_t run)
    : replay_(&replay),
      run_(&replay.runs[run]),
      other_(false),
      session_(with_gravity(replay.scene, run_->start.gravity), *run_->start.engine, run_->start.settings,
               WithoutWorld::refuse_steps),
      dt_(run_->dt) {}

ReplayPlayer::ReplayPlayer(const Replay& replay, std::size_t run, const Engine& other)
    : replay_(&replay),
      run_(&replay.runs[run]),
      other_(true),
      session_(with_gravity(replay.scene, run_->start.gravity), other, settings_for(other, *replay.scene)),
      dt_(run_->dt) {}

bool ReplayPlayer::step() {
    const std::uint64_t made = session_.recording().steps();
    Hands hands{*this};
    while (play_moves(*run_, made, next_move_, hands)) {
        if (other_) continue;
        try {
            session_.step(dt_, run_->script, next_control_);
            parting_ = ReplayParting{agreed_, session_.world().time()};
            return true;
        } catch (const Refusal&) {  // as in the game
            continue;
        }
    }
    if (made >= run_->steps) {
        if (!std::exchange(ended_, true)) compare(run_->end.checksum);
        return false;
    }
    session_.step(dt_, run_->script, next_control_);
    if (const std::uint64_t now = made + 1; now % steps_between_checks == 0)
        compare(run_->checks[now / steps_between_checks - 1]);
    return true;
}

void ReplayPlayer::compare(std::uint64_t checksum) {
    if (other_ || parting_) return;
    const double time = session_.world().time();
    if (checksum_of(session_.world(), session_.game()) == checksum)
        agreed_ = time;
    else
        parting_ = ReplayParting{agreed_, time};
}

}  // namespace flipside::lab
