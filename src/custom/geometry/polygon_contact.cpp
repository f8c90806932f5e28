#include "custom/geometry/polygon_contact.hpp"

#include <limits>

namespace flipside::custom {

namespace {

using Corners = std::span<const Vec2>;

Vec2 next_corner(Corners polygon, std::size_t i) {
    return polygon[i + 1 < polygon.size() ? i + 1 : 0];
}
Vec2 edge_normal(Corners polygon, std::size_t i) {
    return unit(-perp(next_corner(polygon, i) - polygon[i]));
}

struct Axis {
    std::size_t edge = 0;
    double separation = -std::numeric_limits<double>::infinity();
};

/// The edge of `a` from which `b` keeps the greatest signed distance.
Axis best_axis(Corners a, Corners b) {
    Axis best;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Vec2 normal = edge_normal(a, i);
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec2 corner : b) nearest = std::min(nearest, dot(corner - a[i], normal));
        if (nearest > best.separation) best = {i, nearest};
    }
    return best;
}

/// The edge of `polygon` that faces most against `normal`.
std::size_t incident_edge(Corners polygon, Vec2 normal) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const double facing = dot(edge_normal(polygon, i), normal);
        if (facing < least) least = facing, best = i;
    }
    return best;
}

/// Cuts the segment (p, q) to where along·x ≥ limit; false when nothing is left.
bool clip(Vec2& p, Vec2& q, Vec2 along, double limit) {
    const double p_inside = dot(along, p) - limit, q_inside = dot(along, q) - limit;
    if (p_inside < 0 && q_inside < 0) return false;
    if (p_inside < 0) p = p + p_inside / (p_inside - q_inside) * (q - p);
    if (q_inside < 0) q = q + q_inside / (q_inside - p_inside) * (p - q);
    return true;
}

}  // namespace

PolygonContact polygon_contact(std::span<const Vec2> a, std::span<const Vec2> b) {
    const Axis of_a = best_axis(a, b), of_b = best_axis(b, a);
    const bool reference_is_b = of_b.separation > of_a.separation;
    const Corners reference = reference_is_b ? b : a, incident = reference_is_b ? a : b;
    const Axis axis = reference_is_b ? of_b : of_a;
    const Vec2 outward = edge_normal(reference, axis.edge);

    PolygonContact contact;
    contact.normal = reference_is_b ? -outward : outward;
    contact.separation = axis.separation;
    if (axis.separation > 0) return contact;

    const Vec2 first = reference[axis.edge], last = next_corner(reference, axis.edge);
    const Vec2 along = unit(last - first);
    const std::size_t edge = incident_edge(incident, outward);
    Vec2 p = incident[edge], q = next_corner(incident, edge);
    if (!clip(p, q, along, dot(along, first)) || !clip(p, q, -along, -dot(along, last))) return contact;
    for (const Vec2 corner : {p, q}) {
        const double height = dot(corner - first, outward);
        if (height > 0) continue;
        contact.points[contact.count] = corner;
        contact.separations[contact.count++] = height;
    }
    return contact;
}

}  // namespace flipside::custom
