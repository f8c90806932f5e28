#include "world/bounds.hpp"

#include <numbers>

namespace flipside {

namespace {

struct BoundsOf {
    const Pose& pose;

    [[nodiscard]] Box around(Vec2 p, double radius = 0) const { return bounds_of(pose.apply(p), radius); }

    Box operator()(const primitive::Point& p) const { return around(p.at); }
    Box operator()(const primitive::Segment& p) const { return united(around(p.a), around(p.b)); }
    Box operator()(const primitive::Circle& p) const { return around(p.center, p.radius); }
    Box operator()(const primitive::Taper& p) const {
        return united(around(p.a, p.radius_a), around(p.b, p.radius_b));
    }
    Box operator()(const primitive::Polygon& p) const {
        Box box = around(p.points.front());
        for (const Vec2 point : p.points) box = united(box, around(point));
        return box;
    }
    /// Contains the ends, and those of the four extreme points of the circle that lie on the arc.
    Box operator()(const primitive::Arc& p) const {
        constexpr double quarter = std::numbers::pi / 2;
        constexpr Vec2 outermost[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
        const Vec2 center = pose.apply(p.center);
        const double from = p.from + pose.angle, to = p.to + pose.angle;
        const auto at = [&](Vec2 direction) { return bounds_of(center + p.radius * direction, 0); };
        Box box = united(at(from_angle(from)), at(from_angle(to)));
        const double first = std::ceil(from / quarter);
        for (int i = 0; i < 4 && (first + i) * quarter <= to; ++i) {
            const double turn = std::fmod(first + i, 4.0);
            box = united(box, at(outermost[static_cast<int>(turn < 0 ? turn + 4 : turn)]));
        }
        return box;
    }
};

}  // namespace

Box bounds_of(const Primitive& primitive, const Pose& pose) {
    return std::visit(BoundsOf{pose}, primitive.is);
}

}  // namespace flipside
