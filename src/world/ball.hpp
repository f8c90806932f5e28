#pragma once
/// A ball: the only dynamic body. A disc with moment of inertia ½·m·r².

#include <algorithm>
#include <cstdint>
#include <span>

#include "world/vec2.hpp"

namespace flipside {

/// Names a ball for the whole life of a world; never used again after the ball is gone. The balls of a
/// scene are numbered from 0 in the order of the file, later ones follow.
using BallNumber = std::uint32_t;

/// Position and motion come first, so that loops over them read less memory.
struct Ball {
    Vec2 position;      ///< m
    Vec2 velocity;      ///< m/s
    double radius = 0;  ///< m, > 0
    BallNumber number = 0;
    bool asleep = false;
    double angle = 0;                   ///< rad
    double spin = 0;                    ///< rad/s, anticlockwise
    double mass = 0;                    ///< kg, > 0
    std::uint32_t material = 0;         ///< index into Scene::materials
    std::uint32_t layer = 1;            ///< one bit
    std::uint32_t collides_with = ~0U;  ///< mask of layers

    friend bool operator==(const Ball&, const Ball&) = default;
};

/// Of that number, in a list by rising number; null where there is none. It stands at the place of its number
/// as long as no ball before it is gone.
[[nodiscard]] inline const Ball* find_ball(std::span<const Ball> balls, BallNumber number) {
    if (number < balls.size() && balls[number].number == number) return &balls[number];
    const auto at = std::ranges::lower_bound(balls, number, {}, &Ball::number);
    return at != balls.end() && at->number == number ? &*at : nullptr;
}

/// The place in that list of a ball that is there.
[[nodiscard]] inline std::size_t index_of(std::span<const Ball> balls, BallNumber number) {
    return static_cast<std::size_t>(find_ball(balls, number) - balls.data());
}

inline double inertia(const Ball& ball) {
    return 0.5 * ball.mass * ball.radius * ball.radius;
}

}  // namespace flipside
