#include "custom/continuous/clearance.hpp"

#include <algorithm>
#include <numbers>

namespace flipside::custom {

namespace {

constexpr Box nowhere = BoxIndex::nowhere;

Box around(Vec2 a, Vec2 b) {
    return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

/// How many points and half-planes stand for a piece.
struct Size {
    std::uint32_t points, planes;

    static Size of(const Piece& piece) {
        if (const auto* polygon = std::get_if<piece::Polygon>(&piece.is)) {
            const auto corners = static_cast<std::uint32_t>(polygon->points.size());
            return {corners, corners};
        }
        if (std::holds_alternative<piece::Arc>(piece.is)) return {1, 1};
        const bool round =
            std::holds_alternative<piece::Point>(piece.is) || std::holds_alternative<piece::Circle>(piece.is);
        return round ? Size{1, 0} : Size{2, 4};
    }
};

}  // namespace

Clearance::Clearance(const Scene& scene, const Layout& layout, const Table& table)
    : scene_(scene), layout_(layout), boxes_(scene.bounds, layout.size() + table.moving_parts().size()) {
    for (PieceIndex i = 0; i < layout.size(); ++i) {
        const Piece& piece = layout.piece(i);
        const Size size = Size::of(piece);
        Obstacle obstacle;
        obstacle.layer = scene.parts[piece.part].layer;
        obstacle.collides_with = scene.parts[piece.part].collides_with;
        obstacle.first_point = static_cast<std::uint32_t>(points_.size());
        obstacle.first_plane = static_cast<std::uint32_t>(planes_.size());
        obstacle.points = size.points;
        obstacle.planes = size.planes;
        points_.resize(points_.size() + size.points);
        planes_.resize(planes_.size() + size.planes);
        obstacles_.push_back(obstacle);
        place(i, piece, table.pose(piece.part));
    }
    for (const PartIndex part : table.moving_parts()) {
        Moving moving{part, false, table.pose(part).angle, 0, 0, {}};
        double reach = 0;
        for (PieceIndex i = 0; i < layout.size(); ++i) {
            if (layout.piece(i).part != part) continue;
            if (moving.last == 0) moving.first = i;
            moving.last = i + 1;
            const Box box = bounds_of(layout.piece(i));
            const Vec2 pivot = table.pose(part).pivot;
            const double dx = std::max(box.max.x - pivot.x, pivot.x - box.min.x);
            const double dy = std::max(box.max.y - pivot.y, pivot.y - box.min.y);
            reach = std::max(reach, std::sqrt(dx * dx + dy * dy));
        }
        Obstacle disc;
        disc.layer = scene.parts[part].layer;
        disc.collides_with = scene.parts[part].collides_with;
        disc.first_point = static_cast<std::uint32_t>(points_.size());
        disc.points = 1;
        disc.radius = reach;
        points_.push_back(table.pose(part).pivot);
        moving.disc = bounds_of(points_.back(), reach);
        obstacles_.push_back(disc);
        moving_.push_back(moving);
    }
    // Each halving lists what the one before had in the way.
    in_the_way_.reserve(obstacles_.size() * 16);
}

/// Puts the obstacle of a piece where the piece is.
void Clearance::place(std::size_t index, const Piece& piece, const Pose& pose) {
    Obstacle& obstacle = obstacles_[index];
    boxes_.set(index, bounds_of(piece, pose));
    Vec2* point = &points_[obstacle.first_point];
    if (const auto* at = std::get_if<piece::Point>(&piece.is)) *point = pose.apply(at->at);
    if (const auto* circle = std::get_if<piece::Circle>(&piece.is)) {
        *point = pose.apply(circle->center);
        obstacle.radius = circle->radius;
    }
    if (const auto* arc = std::get_if<piece::Arc>(&piece.is)) {
        *point = pose.apply(arc->center);
        obstacle.radius = arc->radius;
        obstacle.hollow = true;
        // The arc lies beyond its chord.
        const double half = std::min((arc->to - arc->from) / 2, std::numbers::pi);
        const Vec2 back = -rotated(from_angle(arc->from + half), pose.angle);
        planes_[obstacle.first_plane] = {back, dot(back, *point) - arc->radius * (std::cos(half) + 1)};
        return;
    }
    if (const auto* segment = std::get_if<piece::Segment>(&piece.is)) {
        point[0] = pose.apply(segment->a);
        point[1] = pose.apply(segment->b);
    }
    if (const auto* taper = std::get_if<piece::Taper>(&piece.is)) {
        point[0] = pose.apply(taper->a);
        point[1] = pose.apply(taper->b);
        obstacle.radius = std::max(taper->radius_a, taper->radius_b);
    }
    if (const auto* polygon = std::get_if<piece::Polygon>(&piece.is))
        for (const Vec2 corner : polygon->points) *point++ = pose.apply(corner);
    if (obstacle.points > 1) enclose(obstacle);
}

/// Half-planes around the points of a polygon, or of a stretch: its two sides and its two ends.
void Clearance::enclose(const Obstacle& obstacle) {
    HalfPlane* plane = &planes_[obstacle.first_plane];
    const Vec2* points = &points_[obstacle.first_point];
    for (std::uint32_t i = 0; i < obstacle.points; ++i) {
        const Vec2 a = points[i], along = unit(points[(i + 1) % obstacle.points] - a);
        *plane++ = {-perp(along), dot(-perp(along), a)};
        if (obstacle.points == 2) *plane++ = {-along, dot(-along, a)};
    }
}

bool Clearance::follow(std::span<const Turning> turnings) {
    bool left = false;
    for (std::size_t i = 0; i < moving_.size(); ++i) {
        Moving& moving = moving_[i];
        const Turning& turning = turnings[moving.part];
        const bool turns = !turning.still();
        const double angle = turning.begin.angle;
        if (turns == moving.turns && (turns || angle == moving.angle)) continue;
        left = left || !moving.turns;
        moving.turns = turns;
        moving.angle = angle;
        for (std::uint32_t piece = moving.first; piece < moving.last; ++piece) {
            boxes_.set(piece, nowhere);
            if (!turns) place(piece, layout_.piece(piece), turning.begin);
        }
        boxes_.set(layout_.size() + i, turns ? moving.disc : nowhere);
    }
    return left;
}

bool Clearance::beside_turning(const Box& box) const {
    return std::ranges::any_of(moving_, [&](const Moving& m) { return m.turns && overlap(m.disc, box); });
}

bool Clearance::apart(const Obstacle& obstacle, const Chord& chord) const {
    const double gap = chord.reach + obstacle.radius;
    for (std::uint32_t i = 0; i < obstacle.planes; ++i) {
        const HalfPlane& plane = planes_[obstacle.first_plane + i];
        if (std::min(dot(plane.normal, chord.a), dot(plane.normal, chord.b)) - plane.offset > gap)
            return true;
    }
    const Vec2* points = &points_[obstacle.first_point];
    if (obstacle.points == 1) {
        if (distance_squared(points[0], chord.a, chord.b) > gap * gap) return true;
        if (!obstacle.hollow || obstacle.radius <= chord.reach) return false;
        const double inner = obstacle.radius - chord.reach;
        return std::max(length_squared(chord.a - points[0]), length_squared(chord.b - points[0])) <
               inner * inner;
    }
    const Vec2 across = perp(chord.b - chord.a);
    double least = INFINITY, most = -INFINITY;
    for (std::uint32_t i = 0; i < obstacle.points; ++i) {
        const double side = dot(across, points[i] - chord.a);
        least = std::min(least, side);
        most = std::max(most, side);
    }
    const double wide = gap * length(across);
    return least > wide || most < -wide;
}

double Clearance::free_for(const Ball& ball, const Flight& flight, double longest, double finest,
                           std::uint64_t& box_tests, std::uint64_t& shape_tests) {
    flight_ = &flight;
    finest_ = finest;
    reach_ = ball.radius + clearance_margin(ball);
    bend_ = flight.max_acceleration(longest);
    shape_tests_ = 0;
    const Vec2 end = flight.position + flight.displacement(longest);
    const Box box = grown(around(flight.position, end), reach_ + bend_ * longest * longest / 8);
    in_the_way_.clear();
    box_tests += boxes_.find(box, in_the_way_);
    std::erase_if(in_the_way_, [&](std::uint32_t i) { return !layers_meet(ball, obstacles_[i]); });
    const double free = follow(0, flight.position, longest, end, 0, in_the_way_.size());
    shape_tests += shape_tests_;
    return free;
}

/// Until when, from t0 to at most t1, the flight is clear of the obstacles listed from `first` to `last`.
double Clearance::follow(double t0, Vec2 at_t0, double t1, Vec2 at_t1, std::size_t first, std::size_t last) {
    const double sag = bend_ * (t1 - t0) * (t1 - t0) / 8;
    const Chord chord{at_t0, at_t1, reach_ + sag};
    const Box centre = grown(around(at_t0, at_t1), sag), box = grown(centre, reach_);
    const std::size_t kept = last;
    in_the_way_.resize(kept);
    for (std::size_t i = first; i < last; ++i) {
        const std::uint32_t obstacle = in_the_way_[i];
        ++shape_tests_;
        if (overlap(box, boxes_[obstacle]) && !apart(obstacles_[obstacle], chord))
            in_the_way_.push_back(obstacle);
    }
    const bool inside = scene_.bounds.contains(centre.min) && scene_.bounds.contains(centre.max);
    if (inside && in_the_way_.size() == kept) return t1;
    if (t1 - t0 <= finest_) return t0;
    const std::size_t end = in_the_way_.size();
    const double middle = t0 + (t1 - t0) / 2;
    const Vec2 at_middle = flight_->position + flight_->displacement(middle);
    const double free = follow(t0, at_t0, middle, at_middle, kept, end);
    return free < middle ? free : follow(middle, at_middle, t1, at_t1, kept, end);
}

}  // namespace flipside::custom
