#include "custom/continuous/clearance.hpp"

#include <algorithm>
#include <numbers>

namespace flipside::custom {

namespace {

constexpr Box nowhere = BoxIndex::nowhere;

Box around(Vec2 a, Vec2 b) {
    return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

/// How many points and slabs stand for a piece.
struct Size {
    std::uint32_t points, slabs;

    static Size of(const Piece& piece) {
        if (const auto* polygon = std::get_if<piece::Polygon>(&piece.is)) {
            const auto corners = static_cast<std::uint32_t>(polygon->points.size());
            return {corners, corners};
        }
        if (std::holds_alternative<piece::Arc>(piece.is)) return {1, 1};
        const bool round =
            std::holds_alternative<piece::Point>(piece.is) || std::holds_alternative<piece::Circle>(piece.is);
        return round ? Size{1, 0} : Size{2, 2};
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
        obstacle.first_slab = static_cast<std::uint32_t>(slabs_.size());
        obstacle.points = size.points;
        obstacle.slabs = size.slabs;
        points_.resize(points_.size() + size.points);
        slabs_.resize(slabs_.size() + size.slabs);
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
    in_the_way_.reserve(obstacles_.size());
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
        const double high = dot(back, *point) - arc->radius * (math::cos(half) + 1);
        slabs_[obstacle.first_slab] = {back, -INFINITY, high};
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

/// Slabs around the points of a polygon, one per edge and open to the inside; or of a stretch, across it and
/// along it.
void Clearance::enclose(const Obstacle& obstacle) {
    Slab* slab = &slabs_[obstacle.first_slab];
    const Vec2* points = &points_[obstacle.first_point];
    if (obstacle.points == 2) {
        const Vec2 along = unit(points[1] - points[0]), side = perp(along);
        slab[0] = {side, dot(side, points[0]), dot(side, points[0])};
        slab[1] = {along, dot(along, points[0]), dot(along, points[1])};
        return;
    }
    for (std::uint32_t i = 0; i < obstacle.points; ++i) {
        const Vec2 a = points[i], out = -perp(unit(points[(i + 1) % obstacle.points] - a));
        *slab++ = {out, -INFINITY, dot(out, a)};
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
        take_over(moving, turning.begin, layout_.size() + i);
    }
    return left;
}

void Clearance::take_over(const Moving& moving, const Pose& pose, std::size_t disc) {
    for (std::uint32_t piece = moving.first; piece < moving.last; ++piece) {
        boxes_.set(piece, nowhere);
        if (!moving.turns) place(piece, layout_.piece(piece), pose);
    }
    boxes_.set(disc, moving.turns ? moving.disc : nowhere);
}

bool Clearance::beside_turning(const Box& box) const {
    return std::ranges::any_of(moving_, [&](const Moving& m) { return m.turns && overlap(m.disc, box); });
}

bool Clearance::apart(const Obstacle& obstacle, const Chord& chord) const {
    const double gap = chord.reach + obstacle.radius;
    // Without a branch per slab: nothing foretells which one keeps them apart.
    double beyond = -INFINITY;
    for (std::uint32_t i = 0; i < obstacle.slabs; ++i) {
        const Slab& slab = slabs_[obstacle.first_slab + i];
        const double a = dot(slab.normal, chord.a), b = dot(slab.normal, chord.b);
        beyond = std::max({beyond, std::min(a, b) - slab.high, slab.low - std::max(a, b)});
    }
    if (beyond > gap) return true;
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

/// For how long a ball at `at` surely does not get nearer to an obstacle than reach_. It stays on its side of
/// the line across the way to the nearest point until gravity and its speed take it there.
double Clearance::surely_apart(const Obstacle& obstacle, Vec2 at, Vec2 velocity, double longest) const {
    const auto stays = [&](Vec2 normal, double gap) {
        if (gap <= 0) return 0.0;
        return surely_free(gap, dot(normal, velocity), slowed_ - dot(normal, flight_->acceleration));
    };
    const double reach = reach_ + obstacle.radius;
    const Vec2 first = points_[obstacle.first_point];
    double free = 0;
    if (obstacle.hollow) {
        const Slab& chord = slabs_[obstacle.first_slab];
        free = stays(chord.normal, dot(chord.normal, at) - chord.high - reach);
        if (length_squared(at - first) < obstacle.radius * obstacle.radius)
            return std::max(free, surely_within(at - first, velocity, obstacle.radius - reach_, longest));
    }
    const Vec2 out = at - (obstacle.points == 1 ? first : nearest_point(obstacle, at));
    const double distance = length(out);
    return distance > reach ? std::max(free, stays(out / distance, distance - reach)) : free;
}

/// Of an obstacle's core to a point outside; inside a polygon that point itself.
Vec2 Clearance::nearest_point(const Obstacle& obstacle, Vec2 at) const {
    const Vec2* points = &points_[obstacle.first_point];
    if (obstacle.points == 2) return nearest_on(at, points[0], points[1]);
    Vec2 nearest = at;
    double least = INFINITY;
    for (std::uint32_t i = 0; i < obstacle.points; ++i) {
        const Slab& slab = slabs_[obstacle.first_slab + i];
        if (dot(slab.normal, at) < slab.high) continue;
        const Vec2 on_edge = nearest_on(at, points[i], points[i + 1 < obstacle.points ? i + 1 : 0]);
        const double squared = length_squared(at - on_edge);
        if (squared >= least) continue;
        least = squared;
        nearest = on_edge;
    }
    return nearest;
}

/// For how long a point surely stays within a circle about the origin.
double Clearance::surely_within(Vec2 at, Vec2 velocity, double radius, double longest) const {
    const double room = radius - length(at);
    if (room <= 0) return 0;
    // So long the flight strays by half the room at most; the other half is left for straight motion.
    const double straight = std::min(longest, std::sqrt(room / bend_));
    const double rest = radius - room / 2;
    const double speed_squared = length_squared(velocity), along = dot(at, velocity);
    const double left = rest * rest - length_squared(at);
    if (speed_squared == 0) return straight;
    return std::min(straight, (std::sqrt(along * along + speed_squared * left) - along) / speed_squared);
}

/// Until when, up to `until`, the flight is clear of an obstacle.
double Clearance::clear_until(const Obstacle& obstacle, double until, Vec2 at_until) {
    Vec2 at = flight_->position, velocity = flight_->velocity;
    // Each advance gains more than finest_, half a step; `until` is 64 steps at most (find_free_time).
    for (double t = 0;;) {
        ++shape_tests_;
        const double left = until - t;
        if (apart(obstacle, {at, at_until, reach_ + bend_ * left * left / 8})) return until;
        const double free = surely_apart(obstacle, at, velocity, left);
        t += free;
        if (t >= until) return until;
        if (free <= finest_) return t;
        const Stretch stretch(flight_->drag, t);
        at = flight_->position + flight_->displacement(stretch);
        velocity = flight_->velocity_after(stretch);
    }
}

double Clearance::surely_inside(const Box& bounds, double longest) const {
    const Vec2 p = flight_->position, v = flight_->velocity, a = flight_->acceleration;
    if (!bounds.contains(p)) return 0;
    return std::min({longest, surely_free(p.x - bounds.min.x, v.x, slowed_ - a.x),
                     surely_free(bounds.max.x - p.x, -v.x, slowed_ + a.x),
                     surely_free(p.y - bounds.min.y, v.y, slowed_ - a.y),
                     surely_free(bounds.max.y - p.y, -v.y, slowed_ + a.y)});
}

double Clearance::free_for(const Ball& ball, const Flight& flight, double longest, double finest,
                           std::uint64_t& box_tests, std::uint64_t& shape_tests) {
    flight_ = &flight;
    finest_ = finest;
    reach_ = ball.radius + clearance_margin(ball);
    slowed_ = flight.drag * flight.max_speed(longest);
    bend_ = length(flight.acceleration) + slowed_;
    shape_tests_ = 0;
    double until = longest;
    Vec2 end = flight.position + flight.displacement(until);
    const auto way = [&] { return grown(around(flight.position, end), bend_ * until * until / 8); };
    // Not up to the border: there a rounding decides whether the ball is lost.
    const Box inside = grown(scene_.bounds, -clearance_margin(ball));
    if (!holds(inside, way())) {
        until = surely_inside(inside, longest);
        end = flight.position + flight.displacement(until);
    }
    const Box box = grown(way(), reach_);
    in_the_way_.clear();
    box_tests += boxes_.find(box, in_the_way_);
    for (const std::uint32_t i : in_the_way_) {
        if (!layers_meet(ball, obstacles_[i])) continue;
        const double clear = clear_until(obstacles_[i], until, end);
        if (clear >= until) continue;
        until = clear;
        if (until <= 0) break;
        end = flight.position + flight.displacement(until);
    }
    shape_tests += shape_tests_;
    return until;
}

}  // namespace flipside::custom
