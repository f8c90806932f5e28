#include "custom/geometry/explain.hpp"

#include <algorithm>

namespace flipside::custom {

namespace {

constexpr const char* to_a_point = "separation = |c - p| - r";
constexpr const char* to_a_circle = "separation = |c - m| - R - r";
constexpr const char* to_a_face = "separation = (c - p) . n - r";

/// "a = b - c" with numbers for distance, core and radius.
std::string filled(double distance, double core, double radius) {
    const double separation = distance - core - radius;
    return brief(separation) + " = " + brief(distance) + (core > 0 ? " - " + brief(core) : "") + " - " +
           brief(radius);
}

void add(TraceItem& item, const char* shape, std::string_view feature, const char* formula,
         const std::string& numbers) {
    item.with("shape", shape)
        .with("feature", feature)
        .with("formula", formula)
        .with("filled", std::string_view(numbers));
}

/// A disc in the frame of the shape's pose.
struct Explainer {
    TraceItem& item;
    Vec2 center;
    double radius = 0;
    Touch found;

    /// Of the centre from the closest point, m; below 0 inside a solid.
    [[nodiscard]] double height() const { return found.separation + radius; }

    void operator()(const piece::Point&) const {
        add(item, "point", "the point", to_a_point, filled(height(), 0, radius));
    }
    void operator()(const piece::Circle& circle) const {
        add(item, "circle", "the rim", to_a_circle,
            filled(length(center - circle.center), circle.radius, radius));
    }
    void operator()(const piece::Segment& segment) const {
        const Vec2 along = segment.b - segment.a;
        const double at = dot(center - segment.a, along) / length_squared(along);
        item.with("along", at);
        const char* feature = at < 0 ? "past the end a" : at > 1 ? "past the end b" : "the face";
        add(item, "segment", feature, found.past_end ? to_a_point : to_a_face, filled(height(), 0, radius));
    }
    void operator()(const piece::Arc& arc) const {
        const char* feature = found.past_end                             ? "past an end"
                              : length(center - arc.center) < arc.radius ? "the hollow side"
                                                                         : "the outer side";
        add(item, "arc", feature, found.past_end ? to_a_point : "separation = ||c - m| - R| - r",
            filled(height(), 0, radius));
    }
    void operator()(const piece::Polygon& polygon) const {
        const auto& points = polygon.points;
        std::vector<double> heights;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec2 next = points[(i + 1) % points.size()];
            heights.push_back(dot(center - points[i], unit(-perp(next - points[i]))));
        }
        const auto edge = std::ranges::max_element(heights) - heights.begin();
        const bool corner = found.separation + radius > heights[static_cast<std::size_t>(edge)] * (1 + 1e-12);
        item.with("heights", TraceValue(std::move(heights)));
        add(item, "polygon", (corner ? "a corner of edge " : "edge ") + std::to_string(edge),
            corner ? to_a_point : to_a_face, filled(height(), 0, radius));
    }
    void operator()(const piece::Taper& taper) const {
        const Vec2 forward = unit(taper.b - taper.a);
        const double slant = (taper.radius_a - taper.radius_b) / length(taper.b - taper.a);
        const bool round = std::abs(dot(found.normal, forward) - slant) > 1e-9;
        const bool at_a = length_squared(center - taper.a) < length_squared(center - taper.b);
        add(item, taper.radius_a == taper.radius_b ? "capsule" : "flipper",
            !round ? "a straight side"
            : at_a ? "the round end a"
                   : "the round end b",
            round ? to_a_circle : to_a_face,
            round ? filled(length(center - (at_a ? taper.a : taper.b)),
                           at_a ? taper.radius_a : taper.radius_b, radius)
                  : filled(height(), 0, radius));
    }
};

}  // namespace

void explain_touch(TraceItem& item, Vec2 center, double radius, const Piece& piece, const Pose& pose) {
    const Vec2 local = pose.undo(center);
    std::visit(Explainer{item, local, radius, touch(local, radius, Piece{piece.is, piece.part}, Pose{})},
               piece.is);
}

void explain_touch(TraceItem& item, Vec2 center_a, double radius_a, Vec2 center_b, double radius_b) {
    add(item, "ball", "the rim", to_a_circle, filled(length(center_a - center_b), radius_b, radius_a));
}

}  // namespace flipside::custom
