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
        before_.reported_lost.reserve(balls);
        before_.blocked.reserve(balls);
    }
    /// Makes the step. If it is refused, `restore(State)` must restore the state before it. A step in which
    /// no ball moves needs no copy and no test of the balls.
    void run(const Table& table, const std::vector<Ball>& balls, auto&& step, auto&& restore,
             bool balls_move = true) {
        if (refusal_) throw Refusal(*refusal_);
        const auto require = [&] {
            require_limits(engine_, std::span(balls).first(balls_move ? balls.size() : 0), table.time());
        };
        table.copy(before_);
        if (balls_move) before_.balls = balls;
        try {
            require();
            step();
            require();
        } catch (const Refusal& refusal) {
            if (!balls_move) before_.balls = balls;
            restore(before_);
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
