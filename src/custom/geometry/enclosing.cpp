// The circle by Welzl 1991, "Smallest enclosing disks (balls and ellipsoids)", in the incremental form of
// de Berg et al. 2008, "Computational Geometry", 4.7. The hull by Andrew 1979, "Another efficient
// algorithm for convex hulls in two dimensions". The rectangle has a side on a side of the hull (Freeman,
// Shapira 1975); rotating calipers find the farthest point from each side (Toussaint 1983).

#include "custom/geometry/enclosing.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <random>

namespace flipside::custom {

namespace {

bool holds(const Disc& disc, Vec2 p) {
    constexpr double rounding = 1 + 1e-12;
    return length(p - disc.center) <= disc.radius * rounding;
}

Disc disc_on(Vec2 a, Vec2 b) {
    return {0.5 * (a + b), 0.5 * length(b - a)};
}

/// Circle through three points; for points on a line, the circle of the two farthest apart.
Disc disc_on(Vec2 a, Vec2 b, Vec2 c) {
    const Vec2 ab = b - a, ac = c - a;
    const double twice_area = cross(ab, ac);
    if (std::abs(twice_area) <= 1e-14 * length(ab) * length(ac))
        return std::max({disc_on(a, b), disc_on(b, c), disc_on(a, c)},
                        [](const Disc& x, const Disc& y) { return x.radius < y.radius; });
    const Vec2 to_center =
        (-perp(ab) * length_squared(ac) + perp(ac) * length_squared(ab)) / (-2 * twice_area);
    return {a + to_center, length(to_center)};
}

/// Smallest disc around `points` with the given points on its border.
Disc disc_around(std::span<const Vec2> points, Vec2 a, Vec2 b) {
    Disc disc = disc_on(a, b);
    for (const Vec2 p : points)
        if (!holds(disc, p)) disc = disc_on(a, b, p);
    return disc;
}
Disc disc_around(std::span<const Vec2> points, Vec2 a) {
    Disc disc{a, 0};
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!holds(disc, points[i])) disc = disc_around(points.first(i), a, points[i]);
    return disc;
}

/// Number of points whose hull encloses a full circle.
constexpr int sides = 64;

void append_arc(Vec2 center, double radius, double from, double to, std::vector<Vec2>& points) {
    const int steps = std::max(1, static_cast<int>(std::ceil((to - from) / (2 * std::numbers::pi) * sides)));
    const double step = (to - from) / steps;
    for (int i = 0; i < steps; ++i)
        points.push_back(center + radius / math::cos(0.5 * step) * from_angle(from + (i + 0.5) * step));
}

struct AppendOutline {
    const Pose& pose;
    std::vector<Vec2>& points;

    void add(Vec2 p) const { points.push_back(pose.apply(p)); }
    void add_circle(Vec2 center, double radius) const {
        append_arc(pose.apply(center), radius, 0, 2 * std::numbers::pi, points);
    }
    void operator()(const primitive::Point& p) const { add(p.at); }
    void operator()(const primitive::Segment& p) const { add(p.a), add(p.b); }
    void operator()(const primitive::Circle& p) const { add_circle(p.center, p.radius); }
    void operator()(const primitive::Taper& p) const {
        add_circle(p.a, p.radius_a);
        add_circle(p.b, p.radius_b);
    }
    void operator()(const primitive::Polygon& p) const {
        for (const Vec2 point : p.points) add(point);
    }
    void operator()(const primitive::Arc& p) const {
        add(p.center + p.radius * from_angle(p.from));
        add(p.center + p.radius * from_angle(p.to));
        append_arc(pose.apply(p.center), p.radius, p.from + pose.angle, p.to + pose.angle, points);
    }
};

}  // namespace

std::array<Vec2, 4> Rectangle::corners() const {
    const Vec2 x = half.x * along, y = half.y * perp(along);
    return {center - x - y, center + x - y, center + x + y, center - x + y};
}

Disc enclosing_disc(std::span<const Vec2> points) {
    // A random order makes it linear. std::shuffle gives another one with another library.
    std::vector<Vec2> order(points.begin(), points.end());
    std::mt19937 random;
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    Disc disc{order.front(), 0};
    for (std::size_t i = 1; i < order.size(); ++i)
        if (!holds(disc, order[i])) disc = disc_around(std::span<const Vec2>(order).first(i), order[i]);
    return disc;
}

std::vector<Vec2> convex_hull(std::span<const Vec2> points) {
    std::vector<Vec2> sorted(points.begin(), points.end()), hull;
    std::ranges::sort(sorted, [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (sorted.size() < 3) return sorted;
    const auto turn = [&](auto from, auto to) {
        const std::size_t base = hull.size();
        for (; from != to; ++from) {
            while (hull.size() >= base + 2 &&
                   cross(hull.back() - *(hull.end() - 2), *from - hull.back()) <= 0)
                hull.pop_back();
            hull.push_back(*from);
        }
        hull.pop_back();  // the first point of the other half
    };
    turn(sorted.begin(), sorted.end());
    turn(sorted.rbegin(), sorted.rend());
    return hull;
}

Rectangle enclosing_rectangle(std::span<const Vec2> points) {
    const std::vector<Vec2> hull = convex_hull(points);
    if (hull.size() == 1) return {hull.front(), {1, 0}, {}};
    const auto at = [&](std::size_t i) { return hull[i % hull.size()]; };
    Rectangle best;
    double least = std::numeric_limits<double>::infinity();
    std::size_t front = 1, top = 1, back = 1;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2 along = unit(at(i + 1) - at(i)), up = perp(along);
        const auto climb = [&](std::size_t& index, Vec2 direction) {
            // At most once around: for almost equal points, rounding may put each above the one before.
            for (std::size_t left = hull.size(); left > 0; --left, ++index)
                if (!(dot(at(index + 1) - at(index), direction) > 0)) break;
        };
        climb(front, along);
        top = std::max(top, front), climb(top, up);
        back = std::max(back, top), climb(back, -along);
        const double low = dot(at(back), along), high = dot(at(front), along);
        const double bottom = dot(at(i), up), height = dot(at(top), up) - bottom;
        if ((high - low) * height >= least) continue;
        least = (high - low) * height;
        best = {0.5 * (low + high) * along + (bottom + 0.5 * height) * up,
                along,
                {0.5 * (high - low), 0.5 * height}};
    }
    return best;
}

void append_outline(const Primitive& primitive, const Pose& pose, std::vector<Vec2>& points) {
    std::visit(AppendOutline{pose, points}, primitive.is);
}

}  // namespace flipside::custom
