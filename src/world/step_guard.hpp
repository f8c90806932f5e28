#pragma once
/// Keeps the promise of Refusal for an engine that changes its balls in place: a step that is refused leaves
/// the world as it was before it, and every further step is refused alike. Refuses where a step begins or
/// ends beyond the limits of limits.hpp.

#include <optional>
#include <span>
#include <string>

#include "world/limits.hpp"
#include "world/refusal.hpp"
#include "world/table.hpp"

namespace flipside {

class StepGuard {
  public:
    explicit StepGuard(std::string_view engine) : engine_(engine) {}

    /// Reserves memory for so many balls and forces between them, so that steps allocate nothing.
    void reserve(std::size_t balls, std::size_t forces) {
        before_.balls.reserve(balls);
        before_.memory.forces.reserve(forces);
        before_.memory.inside.reserve(balls);
        before_.reported_lost.reserve(balls);
        before_.blocked.reserve(balls);
    }
    /// Makes the step. If it is refused, `restore(State)` must restore the state before it.
    void run(const Table& table, const std::vector<Ball>& balls, auto&& step, auto&& restore) {
        table.copy(before_);
        before_.balls = balls;
        const auto require = [&] { require_limits(engine_, balls, table.time()); };
        attempt([&] { require(), step(), require(); }, [&] { restore(before_); });
    }
    /// The same for a step that begins within the limits and that the engine can undo without a copy of the
    /// state. `step` must refuse to end beyond the limits.
    void attempt(auto&& step, auto&& undo) {
        if (refusal_) throw Refusal(*refusal_);
        try {
            step();
        } catch (const Refusal& refusal) {
            undo();
            refusal_ = refusal.what();
            throw;
        }
    }
    /// Another state was restored: the world may step again.
    void forget() { refusal_.reset(); }

  private:
    std::string_view engine_;
    State before_;
    std::optional<std::string> refusal_;
};

}  // namespace flipside
