#include "custom/geometry/capsule.hpp"

#include <algorithm>

#include "custom/geometry/enclosing.hpp"

namespace flipside::custom {

namespace {

Capsule around(Vec2 from, Vec2 to, double radius) {
    const Vec2 along = to - from;
    const double square = length_squared(along);
    constexpr double rounding = 1e-12;
    const double size = length(from) + length(to) + radius;
    return {from, along, square > 0 ? 1 / square : 0, radius + rounding * size};
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
