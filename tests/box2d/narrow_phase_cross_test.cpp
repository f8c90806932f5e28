/// The custom engine's narrow phase against Box2D's own manifold functions, at random placements.
///
/// Everything is in Box2D's units, with its usual sizes: discs of radius 0.25, parts of about 1. All numbers
/// are floats to begin with, so both see the same placement, and shapes have no skin (as in
/// box2d/shapes.hpp), so nothing needs to be left out for it. What is left out is counted and must be rare:
/// - surfaces nearer to touching than `verdict_band`: Box2D's rounding decides (10 ulp of 1 unit);
/// - a closest point nearer to the centre than 1e-3 radii: the normal is a difference of equal numbers,
///   wrong by 1e-7/2.5e-4 or more;
/// - a tie between two closest features of a solid with the centre inside it, to 1e-5.

#include <algorithm>
#include <cstdio>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include <box2d/b2_circle_shape.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_polygon_shape.h>
#include <gtest/gtest.h>

#include "custom/geometry/narrow_phase.hpp"

namespace flipside::box2d::test {
namespace {

constexpr double disc_radius = 0.25;
constexpr double verdict_band = 1e-6;
constexpr double separation_tolerance = 1e-4 * disc_radius;
constexpr double normal_tolerance = 1e-3;
using std::numbers::pi;

b2Vec2 to_b2(Vec2 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

/// Random numbers that are floats.
struct Dice {
    std::mt19937_64 engine{20240611};

    double number(double low, double high) {
        return double{static_cast<float>(std::uniform_real_distribution(low, high)(engine))};
    }
    Vec2 place(double reach) { return {number(-reach, reach), number(-reach, reach)}; }
    /// A convex polygon of 3 to 8 corners on an ellipse about `center`, no side shorter than 0.1.
    std::vector<Vec2> polygon(Vec2 center) {
        for (;;) {
            const auto corners = static_cast<std::size_t>(std::uniform_int_distribution(3, 8)(engine));
            const double a = number(0.3, 1.2), b = number(0.3, 1.2), turn = number(0, 2 * pi);
            std::vector<double> angles(corners);
            for (double& angle : angles) angle = number(0, 2 * pi);
            std::ranges::sort(angles);
            std::vector<Vec2> points;
            points.reserve(corners);
            for (const double t : angles) {
                const Vec2 p = center + rotated({a * std::cos(t), b * std::sin(t)}, turn);
                points.push_back({double{static_cast<float>(p.x)}, double{static_cast<float>(p.y)}});
            }
            if (well_formed(points)) return points;
        }
    }

  private:
    static bool well_formed(const std::vector<Vec2>& points) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec2 here = points[(i + 1) % points.size()] - points[i];
            const Vec2 next = points[(i + 2) % points.size()] - points[(i + 1) % points.size()];
            if (length(here) < 0.1 || cross(unit(here), unit(next)) < 0.01) return false;
        }
        return true;
    }
};

b2PolygonShape shape_of(const std::vector<Vec2>& points) {
    b2PolygonShape shape;
    std::vector<b2Vec2> corners;
    for (const Vec2 p : points) corners.push_back(to_b2(p));
    shape.Set(corners.data(), static_cast<int32>(corners.size()));
    shape.m_radius = 0;
    return shape;
}

b2Transform nowhere() {
    b2Transform transform;
    transform.SetIdentity();
    return transform;
}

b2CircleShape circle(Vec2 center, double r) {
    b2CircleShape shape;
    shape.m_p = to_b2(center);
    shape.m_radius = static_cast<float>(r);
    return shape;
}

struct Answer {
    Vec2 normal;
    double separation;
};

/// Box2D's answer for a shape and a disc, by a function that fills a manifold; nothing when apart.
std::optional<Answer> ask(const b2Shape& shape, auto&& collide, const b2CircleShape& disc) {
    b2Manifold manifold{};  // apart, Box2D leaves all but the count as it was
    collide(&manifold, disc);
    if (manifold.pointCount == 0) return std::nullopt;
    b2WorldManifold world;
    world.Initialize(&manifold, nowhere(), shape.m_radius, nowhere(), disc.m_radius);
    return Answer{{double{world.normal.x}, double{world.normal.y}}, double{world.separations[0]}};
}

/// Compares, and keeps count of what had to be left out.
struct Comparison {
    int placements = 0, touching = 0, on_the_verge = 0, at_the_centre = 0, ties = 0;

    void add(const custom::Touch& ours, const std::optional<Answer>& theirs, Vec2 center, double distance,
             bool tie = false) {
        ++placements;
        if (std::abs(ours.separation) < verdict_band) {
            ++on_the_verge;
            return;
        }
        ASSERT_EQ(ours.separation < 0, theirs.has_value())
            << "center " << center.x << ", " << center.y << ", our separation " << ours.separation;
        if (!theirs) return;
        ++touching;
        EXPECT_NEAR(ours.separation, theirs->separation, separation_tolerance)
            << "center " << center.x << ", " << center.y;
        if (distance < 1e-3 * disc_radius) {
            ++at_the_centre;
        } else if (tie) {
            ++ties;
        } else {
            EXPECT_LT(length(ours.normal - theirs->normal), normal_tolerance)
                << "center " << center.x << ", " << center.y << ", our normal " << ours.normal.x << ", "
                << ours.normal.y << ", Box2D's " << theirs->normal.x << ", " << theirs->normal.y;
        }
    }
    void finish(double most_ties = 0) const {
        EXPECT_GE(placements, 10000);
        EXPECT_GE(touching, placements / 20);
        EXPECT_LE(on_the_verge, placements / 1000);
        EXPECT_LE(at_the_centre, touching / 100);
        EXPECT_LE(ties, most_ties * touching);
        std::printf("%d placements, %d touching; left out: %d on the verge, %d centred, %d ties\n",
                    placements, touching, on_the_verge, at_the_centre, ties);
    }
};

TEST(NarrowPhaseCross, discAndDisc) {
    Dice dice;
    Comparison comparison;
    for (int i = 0; i < 20000; ++i) {
        const double other = dice.number(0.05, 0.5);
        const Vec2 center = dice.place(0.8), at = dice.place(0.1);
        const b2CircleShape shape = circle(at, other);
        const auto theirs = ask(
            shape,
            [&](b2Manifold* manifold, const b2CircleShape& disc) {
                b2CollideCircles(manifold, &shape, nowhere(), &disc, nowhere());
            },
            circle(center, disc_radius));
        comparison.add(custom::touch(center, disc_radius, at, other), theirs, center, length(center - at));
        comparison.add(custom::touch(center, disc_radius, Primitive{primitive::Circle{at, other}}), theirs,
                       center, length(center - at));
    }
    comparison.finish();
}

TEST(NarrowPhaseCross, discAndPoint) {
    Dice dice;
    Comparison comparison;
    for (int i = 0; i < 20000; ++i) {
        const Vec2 center = dice.place(0.5), at = dice.place(0.1);
        const b2CircleShape shape = circle(at, 0);
        const auto theirs = ask(
            shape,
            [&](b2Manifold* manifold, const b2CircleShape& disc) {
                b2CollideCircles(manifold, &shape, nowhere(), &disc, nowhere());
            },
            circle(center, disc_radius));
        comparison.add(custom::touch(center, disc_radius, Primitive{primitive::Point{at}}), theirs, center,
                       length(center - at));
    }
    comparison.finish();
}

TEST(NarrowPhaseCross, discAndSegmentWithItsEnds) {
    Dice dice;
    Comparison comparison;
    int ends = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec2 center = dice.place(1), a = dice.place(1), b = dice.place(1);
        if (length(a - b) < 0.01) continue;
        b2EdgeShape shape;
        shape.SetTwoSided(to_b2(a), to_b2(b));
        shape.m_radius = 0;
        bool at_end = false;
        const auto theirs = ask(
            shape,
            [&](b2Manifold* manifold, const b2CircleShape& disc) {
                b2CollideEdgeAndCircle(manifold, &shape, nowhere(), &disc, nowhere());
                at_end = manifold->type == b2Manifold::e_circles;
            },
            circle(center, disc_radius));
        const custom::Touch ours = custom::touch(center, disc_radius, Primitive{primitive::Segment{a, b}});
        comparison.add(ours, theirs, center, length(center - ours.point));
        if (!theirs) continue;
        // They agree on what is an end, but for centres within rounding of its normal line.
        const double beyond = std::max(dot(a - center, unit(b - a)), dot(center - b, unit(b - a)));
        if (std::abs(beyond) > 1e-5) {
            EXPECT_EQ(ours.past_end, at_end) << center.x << ", " << center.y;
        }
        ends += at_end;
    }
    EXPECT_GT(ends, 500);
    comparison.finish();
}

TEST(NarrowPhaseCross, discAndPolygon) {
    Dice dice;
    Comparison comparison;
    for (int i = 0; i < 20000; ++i) {
        const std::vector<Vec2> points = dice.polygon(dice.place(0.1));
        const Vec2 center = dice.place(1.5);
        const b2PolygonShape shape = shape_of(points);
        const auto theirs = ask(
            shape,
            [&](b2Manifold* manifold, const b2CircleShape& disc) {
                b2CollidePolygonAndCircle(manifold, &shape, nowhere(), &disc, nowhere());
            },
            circle(center, disc_radius));
        // Signed distances to the sides' lines, the nearest last.
        std::vector<double> heights;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Vec2 along = unit(points[(k + 1) % points.size()] - points[k]);
            heights.push_back(-cross(along, center - points[k]));
        }
        std::ranges::sort(heights);
        const bool inside = heights.back() < 0;
        const bool tie = inside && heights.back() - heights[heights.size() - 2] < 1e-5;
        const custom::Touch ours = custom::touch(center, disc_radius, Primitive{primitive::Polygon{points}});
        comparison.add(ours, theirs, center, length(center - ours.point), tie);
    }
    comparison.finish(1e-3);
}

/// An arc as Box2D knows it: the nearest of many chords. 4,000 of them stray by R(1 − cos π/4000), 3e-7
/// radii here, and their normals by π/4000, 8e-4 rad.
TEST(NarrowPhaseCross, discAndArc) {
    Dice dice;
    Comparison comparison;
    constexpr int chords = 4000;
    for (int i = 0; i < 12000; ++i) {
        const double from = dice.number(-pi, pi), sweep = dice.number(0.3, 2 * pi);
        const primitive::Arc arc{dice.place(0.2), dice.number(0.3, 0.8), from, from + sweep};
        const Vec2 center = dice.place(1.3);
        const auto corner = [&](int k) {
            return to_b2(arc.center + arc.radius * from_angle(arc.from + sweep * k / chords));
        };
        const auto collide = [&](int k) {
            b2EdgeShape shape;
            shape.SetTwoSided(corner(k), corner(k + 1));
            shape.m_radius = 0;
            return ask(
                shape,
                [&](b2Manifold* manifold, const b2CircleShape& disc) {
                    b2CollideEdgeAndCircle(manifold, &shape, nowhere(), &disc, nowhere());
                },
                circle(center, disc_radius));
        };
        // Only the chords about the centre's direction and the two at the ends can be the nearest.
        double angle = angle_of(center - arc.center);
        while (angle < arc.from) angle += 2 * pi;
        const int middle = static_cast<int>((angle - arc.from) / sweep * chords);
        const custom::Touch ours = custom::touch(center, disc_radius, Primitive{arc});
        // Of chords that are as near to rounding, the one that turns its face most towards our normal.
        std::optional<Answer> theirs;
        for (const int k : {0, middle - 1, middle, middle + 1, chords - 1}) {
            const auto answer = k >= 0 && k < chords ? collide(k) : std::nullopt;
            if (!answer) continue;
            const double nearer = theirs ? theirs->separation - answer->separation : 1;
            const bool better_faced =
                theirs && dot(answer->normal, ours.normal) > dot(theirs->normal, ours.normal);
            if (nearer > verdict_band || (nearer > -verdict_band && better_faced)) theirs = answer;
        }
        // At the arc's centre every point of it is as near, and opposite its gap both ends are.
        const Vec2 ends[] = {arc.center + arc.radius * from_angle(arc.from),
                             arc.center + arc.radius * from_angle(arc.to)};
        const bool tie =
            length(center - arc.center) < 1e-3 ||
            (ours.past_end && std::abs(length(center - ends[0]) - length(center - ends[1])) < 1e-5);
        comparison.add(ours, theirs, center, length(center - ours.point), tie);
    }
    comparison.finish(1e-3);
}

}  // namespace
}  // namespace flipside::box2d::test
