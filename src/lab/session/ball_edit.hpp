#pragma once
/// What a hand does to the balls of a table between steps. Neither the rules nor a script know of it.

#include <optional>
#include <variant>

#include "world/state.hpp"

namespace flipside::lab {

namespace edit {

/// Gives a ball that lies there or moves another velocity, m/s.
struct Throw {
    BallNumber ball = 0;
    Vec2 velocity;
};
/// Adds a ball. It gets its own number, or the world's next one if that is higher.
struct Add {
    Ball ball;
};
struct Remove {
    BallNumber ball = 0;
};

}  // namespace edit

using BallEdit = std::variant<edit::Throw, edit::Add, edit::Remove>;

/// The state after it, all balls awake; nothing where there is no such ball, no free place (pick.hpp) for a
/// new one, or more of it than there may be: balls (most_things) or speed (top_speed).
[[nodiscard]] std::optional<State> edited(const Scene& scene, State state, const BallEdit& edit);

}  // namespace flipside::lab
