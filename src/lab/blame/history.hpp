#pragma once
/// What a contender did, step by step: what blame is found from.

#include <vector>

#include "world/controls.hpp"
#include "world/world.hpp"

namespace flipside::lab {

struct History {
    std::vector<State> states;                   ///< before the first step, and after each
    std::vector<std::vector<Event>> events;      ///< impacts and begins of each step
    std::vector<std::vector<Contact>> contacts;  ///< as many as states
    double dt = 0;                               ///< s, the contender's step
    double end = 0;                              ///< s, when the run ends or should have ended
    Script script;                               ///< of the run; only controls before `end` count

    /// Starts at the world as it is.
    void begin(const World& world);
    /// After a step: the world as it is, and what happened in it.
    void add(const World& world, std::span<const Event> happened);

    [[nodiscard]] std::size_t steps() const { return events.size(); }
};

/// Where a ball must be at the end.
struct KnownEnd {
    BallNumber ball = 0;
    Vec2 position;      ///< m
    double radius = 0;  ///< m
};

}  // namespace flipside::lab
