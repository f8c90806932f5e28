#include "lab/lessons/brute_force_gap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "world/table.hpp"

namespace flipside::lab {

namespace {

/// Of equally spaced points, counted by the length of what they are on.
class Nearest {
  public:
    Nearest(Vec2 center, int points) : center_(center), points_(points) {}

    double of(const primitive::Point& point) { return length(center_ - point.at); }
    double of(const primitive::Segment& segment) {
        line(segment.a, segment.b, 1);
        return least_;
    }
    double of(const primitive::Arc& primitive) {
        arc(primitive.center, primitive.radius, primitive.from, primitive.to, 1);
        return least_;
    }
    double of(const primitive::Circle& circle) {
        arc(circle.center, circle.radius, 0, 2 * std::numbers::pi, 1);
        return least_;
    }
    double of(const primitive::Polygon& polygon) {
        const auto& corners = polygon.points;
        double around = 0;
        const auto next = [&](std::size_t i) { return corners[(i + 1) % corners.size()]; };
        for (std::size_t i = 0; i < corners.size(); ++i) around += length(next(i) - corners[i]);
        for (std::size_t i = 0; i < corners.size(); ++i)
            line(corners[i], next(i), length(next(i) - corners[i]) / around);
        return least_;
    }
    /// Two sides, each between the places where it touches the circles, and what is left of those.
    double of(const primitive::Taper& taper) {
        const Vec2 axis = taper.b - taper.a;
        const double span = length(axis), forward = angle_of(axis);
        const double grows = taper.radius_a - taper.radius_b;
        const double lean = std::acos(grows / span), side = std::sqrt(span * span - grows * grows);
        const double round_a = 2 * (std::numbers::pi - lean) * taper.radius_a;
        const double round_b = 2 * lean * taper.radius_b;
        const double around = round_a + round_b + 2 * side;
        for (const double angle : {forward + lean, forward - lean})
            line(taper.a + taper.radius_a * from_angle(angle), taper.b + taper.radius_b * from_angle(angle),
                 side / around);
        arc(taper.a, taper.radius_a, forward + lean, forward + 2 * std::numbers::pi - lean, round_a / around);
        arc(taper.b, taper.radius_b, forward - lean, forward + lean, round_b / around);
        return least_;
    }

  private:
    void each(double share, auto&& place) {
        const double last = std::max(1.0, std::round(share * points_));
        for (double k = 0; k <= last; ++k) least_ = std::min(least_, length(center_ - place(k / last)));
    }
    void line(Vec2 a, Vec2 b, double share) {
        each(share, [&](double t) { return a + t * (b - a); });
    }
    void arc(Vec2 center, double radius, double from, double to, double share) {
        each(share, [&](double t) { return center + radius * from_angle(from + t * (to - from)); });
    }

    Vec2 center_;
    int points_;
    double least_ = INFINITY;
};

}  // namespace

double distance_by_brute_force(Vec2 center, const Primitive& primitive, int points) {
    return std::visit([&](const auto& kind) { return Nearest(center, points).of(kind); }, primitive.is);
}

double separation_off(const Trace& trace, const Scene& scene) {
    constexpr int points = 10'000, most = 1000;
    const std::vector<Primitive> primitives = surface_of(scene);
    double off = 0;
    int looked_at = 0;
    for (const TraceStage& stage : trace.stages)
        for (const TraceItem& item : stage.items) {
            if (item.kind != "closest" || item.find("primitive") == nullptr || ++looked_at > most) continue;
            const Pose pose{item.get<Vec2>("pivot"), item.get<double>("pose_angle")};
            const Primitive& primitive =
                primitives[static_cast<std::size_t>(item.get<std::int64_t>("primitive"))];
            // Of the centre, from the outline: inside a solid it is below 0.
            const double height = item.get<double>("separation") + item.get<double>("radius");
            const double found =
                distance_by_brute_force(pose.undo(item.get<Vec2>("center")), primitive, points);
            off = std::max(off, std::abs(std::abs(height) - found));
        }
    return off;
}

}  // namespace flipside::lab
