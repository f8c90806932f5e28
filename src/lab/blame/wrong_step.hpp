#pragma once
/// What is wrong in one step of a contender: held against the exact engine's step from the same state.

#include "lab/blame/find_blame.hpp"

namespace flipside::lab {

class WrongStep {
  public:
    /// The step that ends in state `step` ≥ 1 of the history. Where an exact engine goes on from the state
    /// before it, the run ends within `tolerance` radii.
    WrongStep(const Divergence& divergence, std::size_t step, double tolerance, World& exact);

    [[nodiscard]] Blame blame();

  private:
    using Impacts = std::vector<Event>;

    [[nodiscard]] std::optional<Blame> mistimed();
    [[nodiscard]] BallNumber culprit();
    /// Of the culprit, by time.
    [[nodiscard]] Impacts impacts_of_culprit(std::span<const Event> events) const;

    [[nodiscard]] Blame lacking(const Event& exact_impact);
    [[nodiscard]] Blame surplus(const Event& impact);
    [[nodiscard]] Blame differing(const Event& impact, const Event& exact_impact) const;
    [[nodiscard]] Blame without_impact();

    [[nodiscard]] Blame make(Fault fault, const Event& at, double amount) const;
    /// The contender's impact of that pair nearest to `time`, within the tolerance of matching, of steps
    /// before this one or after it.
    [[nodiscard]] std::optional<Event> own_before(const Event& like) const;
    [[nodiscard]] std::optional<Event> own_after(const Event& like) const;
    /// The last impact of that pair until the end of this step, of the exact engine that sets out as long
    /// before as impacts may differ.
    [[nodiscard]] std::optional<Event> exact_before(const Event& like);
    [[nodiscard]] bool comes_after_the_end(const Event& due);
    [[nodiscard]] std::size_t step_around(double time) const;
    [[nodiscard]] bool touches(std::span<const Contact> contacts, const Event& pair) const;
    [[nodiscard]] double off_the_path();

    const Divergence& in_;
    const History& history_;
    std::size_t step_;
    double tolerance_, match_;
    World& exact_;
    const State &before_, &after_;
    std::vector<Contact> contacts_before_, contacts_after_;  ///< of the exact engine
    std::vector<Event> events_;
    State exact_after_;
    BallNumber culprit_ = 0;
};

}  // namespace flipside::lab
