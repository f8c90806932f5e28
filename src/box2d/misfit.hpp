#pragma once
/// Balls that Box2D cannot hold: it squares lengths and speeds in float, and stops the program at what is not
/// finite then.

#include <optional>
#include <string>

#include "box2d/units.hpp"
#include "world/ball.hpp"

namespace flipside::box2d {

struct Misfit {
    const char* key;      ///< what of the ball: "mass"
    std::string problem;  ///< "is 1e+29 kg; ..."
};

/// Nothing where the ball can be held.
[[nodiscard]] std::optional<Misfit> misfit(const Ball& ball, const Units& units);

}  // namespace flipside::box2d
