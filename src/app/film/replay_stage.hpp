#pragma once
/// A stage on which a replay is played again.

#include "app/window/stage.hpp"
#include "lab/replay/play.hpp"

namespace flipside::app::film {

class ReplayStage {
  public:
    /// All of its runs, or in the single view the first; where `other` is an engine, that one in place of the
    /// first alone. The replay must outlive this. Throws InputError where the other engine cannot run it.
    ReplayStage(const lab::Replay& replay, View view, const Engine* other);

    /// All runs go on by the longest of their steps; false where none can.
    bool step();
    [[nodiscard]] const Stage& stage() const { return stage_; }
    [[nodiscard]] double time() const { return time_; }  ///< s
    [[nodiscard]] double end() const { return end_; }    ///< when the longest run ends, s
    /// The name of a run that went another way than the game, or null.
    [[nodiscard]] const std::string* parted() const;

  private:
    std::vector<lab::ReplaySteps> replays_;  ///< one for each run on show
    Stage stage_;
    double time_ = 0, end_ = 0;
};

}  // namespace flipside::app::film
