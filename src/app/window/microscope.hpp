#pragma once
/// Walks through the stages of one step: the traces of all runs in it, where the walk stands, and the balls
/// as they were there. Knows no screen.

#include <algorithm>
#include <utility>
#include <vector>

#include "app/window/stage.hpp"
#include "world/trace.hpp"

namespace flipside::app {

class Microscope {
  public:
    /// Takes the stage's next step with all that its runs write of it; stands at its first stage.
    void take_step(Stage& stage);
    /// To the next stage; false at the last one.
    bool next();
    /// To the one before; false at the first.
    bool back();
    void to_stage(std::size_t stage);
    void to_last() { to_stage(stages().size() - 1); }
    /// Which run's stages are walked; its walk begins anew.
    void look_at(std::size_t run);
    void pick(std::size_t item) { item_ = item; }
    void pick_next() { pick_by_key(item_ + 1 < stage().items.size() ? item_ + 1 : 0); }
    void pick_before() {
        pick_by_key((item_ > 0 ? item_ : std::max<std::size_t>(stage().items.size(), 1)) - 1);
    }
    void close() { traces_.clear(); }

    /// A step has been taken, and nothing has happened since.
    [[nodiscard]] bool shows(const Stage& stage) const;
    [[nodiscard]] std::size_t run() const { return run_; }
    [[nodiscard]] std::size_t at() const { return at_; }
    [[nodiscard]] std::size_t item() const { return item_; }
    /// Whether the list is to bring the item into sight: once after it was picked otherwise than in the list.
    [[nodiscard]] bool to_be_shown() { return std::exchange(to_be_shown_, false); }
    [[nodiscard]] const std::vector<TraceStage>& stages() const { return traces_[run_].trace.stages; }
    [[nodiscard]] const TraceStage& stage() const { return stages()[at_]; }
    /// Of a run, where the walk stands: the one that is walked as its stages say, others as before the step
    /// until the walk has come to its end.
    [[nodiscard]] std::span<const Ball> balls(std::size_t run) const { return traces_[run].now; }

  private:
    struct Traced {
        std::string name;         ///< of the contender
        std::uint64_t steps = 0;  ///< of the session, after the step
        Trace trace;
        std::vector<Ball> before, after, now;
    };
    void show_balls();
    void pick_by_key(std::size_t item) { item_ = item, to_be_shown_ = true; }

    std::vector<Traced> traces_;  ///< by run
    std::size_t run_ = 0, at_ = 0, item_ = 0;
    bool to_be_shown_ = false;
};

}  // namespace flipside::app
