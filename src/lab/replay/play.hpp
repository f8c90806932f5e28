#pragma once
/// Plays a replay again.

#include <optional>
#include <string>

#include "lab/replay/replay.hpp"

namespace flipside::lab {

/// Gives `target` the moves that come before step number `step`, from `next` on, which is moved on. True
/// where the engine refused that step: then the moves after it are still to come. A target has apply, edit,
/// clear, change, resume and set_step_length.
template <class Target>
bool play_moves(const ReplayRun& run, std::uint64_t step, std::size_t& next, Target& target) {
    for (; next < run.moves.size() && run.moves[next].step <= step; ++next) {
        const Move& now = run.moves[next].move;
        if (const auto* press = std::get_if<move::Press>(&now)) target.apply(press->control);
        if (const auto* edit = std::get_if<move::Edit>(&now)) target.edit(edit->edit);
        if (const auto* change = std::get_if<move::Change>(&now)) target.change(*change);
        if (const auto* length = std::get_if<move::StepLength>(&now)) target.set_step_length(length->dt);
        if (std::holds_alternative<move::Clear>(now)) target.clear();
        if (std::holds_alternative<move::Resume>(now)) target.resume();
        if (std::holds_alternative<move::Refused>(now)) {
            ++next;
            return true;
        }
    }
    return false;
}

/// Where a replay went another way than the game: between these times, s.
struct ReplayParting {
    double after = 0, before = 0;
};

/// What a replay does to a session, step by step.
class ReplaySteps {
  public:
    /// As it was. The replay must outlive this.
    ReplaySteps(const Replay& replay, std::size_t run);
    /// On another engine, as the scene recommends it: the same hands on it, as far as the rules let them.
    /// What was done to engines and settings is left out.
    ReplaySteps(const Replay& replay, std::size_t run, const Engine& other);

    /// The session in which it begins. Throws InputError where another engine cannot run the scene.
    [[nodiscard]] Session begin() const;
    /// The next step with what was done before it; false, and only that, after the last one. Throws Refusal
    /// where the engine refuses a step that it did not refuse in the game. The session is that of begin(),
    /// and nothing else changes it.
    bool step(Session& session);
    /// The length of the steps at present, s.
    [[nodiscard]] double dt() const { return dt_; }
    /// Why the engine refused the step after the last one, as it did in the game.
    [[nodiscard]] const std::optional<std::string>& refusal() const { return refusal_; }
    /// Whether the end was reached by another way. Says nothing of another engine.
    [[nodiscard]] const std::optional<ReplayParting>& parting() const { return parting_; }

  private:
    struct Hands;

    void compare(const Session& session, std::uint64_t checksum);
    void compare_end(const Session& session);

    const Replay* replay_;
    const ReplayRun* run_;
    const Engine* other_ = nullptr;
    double dt_;
    std::size_t next_move_ = 0, next_control_ = 0;
    bool ended_ = false;
    double agreed_ = 0;  ///< the last time at which a checksum was the same, s
    std::optional<std::string> refusal_;
    std::optional<ReplayParting> parting_;
};

/// Both together.
class ReplayPlayer {
  public:
    /// As ReplaySteps has it.
    ReplayPlayer(const Replay& replay, std::size_t run) : steps_(replay, run), session_(steps_.begin()) {}
    ReplayPlayer(const Replay& replay, std::size_t run, const Engine& other)
        : steps_(replay, run, other), session_(steps_.begin()) {}

    bool step() { return steps_.step(session_); }
    [[nodiscard]] const Session& session() const { return session_; }
    [[nodiscard]] const std::optional<ReplayParting>& parting() const { return steps_.parting(); }

  private:
    ReplaySteps steps_;
    Session session_;
};

/// How long a run lasts in the replay, s: its steps, each of the length that was set then.
[[nodiscard]] double duration_of(const ReplayRun& run);

}  // namespace flipside::lab
