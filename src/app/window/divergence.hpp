#pragma once
/// How two runs that began in one state come apart, at the same simulated times.

#include <optional>

#include "app/window/history.hpp"
#include "app/window/run.hpp"
#include "lab/live_match.hpp"

namespace flipside::app {

class Divergence {
  public:
    /// Of the runs on these engines.
    Divergence(const Engine& first, const Engine& second) : first_(&first), second_(&second) {}

    /// After each step of `dt` s. Runs of which one has halted are not compared.
    void observe(const Run& first, const Run& second, double dt);

    [[nodiscard]] const Engine& first() const { return *first_; }
    [[nodiscard]] const Engine& second() const { return *second_; }
    /// Greatest distance between the same ball of both, in its radii; nothing while they share none.
    [[nodiscard]] const std::deque<Sample>& history() const { return history_; }
    /// The first impact that is not the same in both, as `flipside compare` has it.
    [[nodiscard]] const std::optional<lab::Parting>& parting() const { return match_.parting(); }

    /// What the ball hit then; "" before that.
    [[nodiscard]] std::string parted_on(const Scene& scene) const;

  private:
    const Engine *first_, *second_;
    lab::LiveMatch match_;
    std::deque<Sample> history_;
};

}  // namespace flipside::app
