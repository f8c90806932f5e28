#pragma once
/// How two runs that began in one state come apart, at the same simulated times.

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "app/window/history.hpp"
#include "app/window/run.hpp"
#include "lab/comparison/live_match.hpp"

namespace flipside::app {

class Divergence {
  public:
    /// Of the runs with these names.
    Divergence(std::string first, std::string second)
        : first_(std::move(first)), second_(std::move(second)) {}

    /// After each span that both have run. Runs of which one has halted are not compared.
    void observe(const Run& first, const Run& second);

    /// The runs went back to `time` and go on from there.
    void forget_after(double time);

    [[nodiscard]] const std::string& first() const { return first_; }
    [[nodiscard]] const std::string& second() const { return second_; }
    [[nodiscard]] bool is_of(std::string_view name) const { return first_ == name || second_ == name; }
    /// Greatest distance between the same ball of both, in its radii; nothing while they share none.
    [[nodiscard]] const std::deque<Sample>& history() const { return history_; }
    /// The first impact that is not the same in both, as `flipside compare` has it, since both tables were
    /// last empty.
    [[nodiscard]] const std::optional<lab::Parting>& parting() const { return match_.parting(); }

    /// The first since the runs began in one state.
    [[nodiscard]] const std::optional<lab::Parting>& first_parting() const { return first_parting_; }

    /// What the ball hit then; "" before that.
    [[nodiscard]] std::string parted_on(const Scene& scene) const;

  private:
    std::string first_, second_;
    lab::LiveMatch match_;
    std::optional<lab::Parting> first_parting_;
    bool was_empty_ = false;
    std::deque<Sample> history_;
};

/// What the ball hit as two runs parted.
[[nodiscard]] std::string name_of_parting(const lab::Parting& parting, const Scene& scene);

}  // namespace flipside::app
