#include "custom/geometry/capsule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "custom/geometry/enclosing.hpp"

namespace flipside::custom {

namespace {

/// Not smaller than it.
float rounded_up(double positive) {
    constexpr float most = std::numeric_limits<float>::max();
    if (positive > most) return std::numeric_limits<float>::infinity();
    return std::nextafter(static_cast<float>(positive), std::numeric_limits<float>::infinity());
}

Capsule around(Vec2 from, Vec2 to, double radius) {
    const double size = length(from) + length(to) + radius, core = length(to - from);
    const double room = radius + 1e-12 * size + 1e-6 * core;
    // A core that single precision can't hold is left to the radius.
    const bool holds = core > 1e-15 && core < 1e15;
    if (!holds) return {from, 0, 0, 0, rounded_up(room + core)};
    const Vec2 along = to - from;
    return {from, static_cast<float>(along.x), static_cast<float>(along.y),
            static_cast<float>(1 / (core * core)), rounded_up(room)};
}

Capsule around(const Piece& piece) {
    std::vector<Vec2> outline;
    append_outline(piece, {}, outline);
    const Disc disc = enclosing_disc(outline);
    return around(disc.center, disc.center, disc.radius);
}

}  // namespace

Capsule capsule_around(const Piece& piece) {
    if (const auto* point = std::get_if<piece::Point>(&piece.is)) return around(point->at, point->at, 0);
    if (const auto* segment = std::get_if<piece::Segment>(&piece.is))
        return around(segment->a, segment->b, 0);
    if (const auto* circle = std::get_if<piece::Circle>(&piece.is))
        return around(circle->center, circle->center, circle->radius);
    if (const auto* taper = std::get_if<piece::Taper>(&piece.is))
        return around(taper->a, taper->b, std::max(taper->radius_a, taper->radius_b));
    return around(piece);
}

}  // namespace flipside::custom
