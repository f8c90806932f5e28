#include <cstdio>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "box2d/table_top.hpp"

namespace flipside::box2d::test {
namespace {

using std::numbers::pi;

/// The contact of a ball at `at` with the one part of the scene, by Box2D's narrow phase, at time 0.
std::optional<Contact> contact_at(TableTop& top, Vec2 at) {
    top.scene.balls.clear();
    top.ball(at);
    const auto world = top.world();
    if (world->contacts().empty()) return std::nullopt;
    return world->contacts()[0];
}

/// Distance of p from the segment ab, and the nearest point.
std::pair<double, Vec2> to_segment(Vec2 p, Vec2 a, Vec2 b) {
    const double t = std::clamp(dot(p - a, b - a) / length_squared(b - a), 0.0, 1.0);
    const Vec2 nearest = a + t * (b - a);
    return {length(p - nearest), nearest};
}

/// Places balls in touch with a part at random places about the origin and compares with `exact`, which
/// gives the distance from the centre to the surface and the nearest point of it.
void expect_exact(TableTop& top, double reach, auto&& exact, double tolerance,
                  double point_tolerance = 1e-6) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> at(-reach, reach);
    int touching = 0;
    double worst = 0, worst_angle = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec2 p{at(random), at(random)};
        const auto [distance, nearest] = exact(p);
        const double separation = distance - radius;
        if (std::abs(separation) < tolerance || distance < 0.3 * radius) continue;
        const auto contact = contact_at(top, p);
        ASSERT_EQ(contact.has_value(), separation < 0)
            << "at " << p.x << ", " << p.y << " separation " << separation;
        if (!contact) continue;
        ++touching;
        worst = std::max(worst, std::abs(contact->separation - separation));
        worst_angle = std::max(worst_angle, length(contact->normal - (p - nearest) / distance));
        EXPECT_NEAR(contact->separation, separation, tolerance) << p.x << ", " << p.y;
        EXPECT_NEAR(length(contact->point - nearest), 0, point_tolerance);
    }
    EXPECT_GT(touching, 100);
    std::printf("%d contacts: separation off by up to %.1e m, normal by %.1e rad\n", touching, worst,
                worst_angle);
}

TEST(Shapes, segmentWithItsEndsIsExact) {
    TableTop top;
    const Vec2 a{-0.03, -0.01}, b{0.04, 0.02};
    top.part(shape::Segment{a, b});
    const auto distance = [&](Vec2 p) { return to_segment(p, a, b); };
    expect_exact(top, 0.06, distance, 1e-4 * radius);
}

TEST(Shapes, circleAndPointAreExact) {
    for (const double size : {0.0, 0.02}) {
        TableTop top;
        if (size > 0)
            top.part(shape::Circle{{0.005, 0}, size});
        else
            top.part(shape::Point{{0.005, 0}});
        expect_exact(
            top, 0.04,
            [&](Vec2 p) {
                const Vec2 from = p - Vec2{0.005, 0};
                return std::pair(length(from) - size, Vec2{0.005, 0} + size * unit(from));
            },
            1e-4 * radius);
    }
}

TEST(Shapes, capsuleIsExact) {
    TableTop top;
    const Vec2 a{-0.03, -0.01}, b{0.03, 0.02};
    top.part(shape::Capsule{a, b, 0.01});
    expect_exact(
        top, 0.07,
        [&](Vec2 p) {
            const auto [distance, nearest] = to_segment(p, a, b);
            return std::pair(distance - 0.01, nearest + 0.01 * unit(p - nearest));
        },
        1e-4 * radius);
}

TEST(Shapes, polygonsOfFewAndOfManyCornersAreExact) {
    for (const int corners : {3, 8, 9, 24}) {
        TableTop top;
        shape::Polygon polygon;
        for (int i = 0; i < corners; ++i)
            polygon.points.push_back(0.03 * from_angle(0.2 + 2 * pi * i / corners));
        top.part(polygon);
        expect_exact(
            top, 0.06,
            [&](Vec2 p) {
                std::pair<double, Vec2> best{1e9, {}};
                bool inside = true;
                for (std::size_t i = 0; i < polygon.points.size(); ++i) {
                    const Vec2 a = polygon.points[i], b = polygon.points[(i + 1) % polygon.points.size()];
                    best = std::min(best, to_segment(p, a, b),
                                    [](const auto& x, const auto& y) { return x.first < y.first; });
                    inside = inside && cross(b - a, p - a) > 0;
                }
                if (inside) best.first = 0;  // left out of the comparison
                return best;
            },
            1e-4 * radius);
    }
}

TEST(Shapes, arcStraysByItsChordErrorAtMost) {
    for (const double sweep : {1.0, 4.0, 2 * pi}) {
        TableTop top;
        const shape::Arc arc{{0.01, 0}, 0.05, 0.5, 0.5 + sweep};
        top.part(arc);
        const auto exact = [&](Vec2 p) {
            const Vec2 from = p - arc.center;
            double angle = angle_of(from);
            while (angle < arc.from) angle += 2 * pi;
            const Vec2 ends[] = {arc.center + arc.radius * from_angle(arc.from),
                                 arc.center + arc.radius * from_angle(arc.to)};
            Vec2 nearest = arc.center + arc.radius * unit(from);
            if (angle > arc.to) nearest = length(p - ends[0]) < length(p - ends[1]) ? ends[0] : ends[1];
            return std::pair(length(p - nearest), nearest);
        };
        expect_exact(top, 0.08, exact, 2e-5 + 1e-4 * radius, radius * std::sqrt(2 * 2e-5 / arc.radius));
    }
}

TEST(Shapes, chordErrorIsASetting) {
    TableTop top;
    top.part(shape::Arc{{0, 0}, 0.5, 0, pi});
    Settings settings(engine().settings);
    const auto edges = [&](double error) {
        settings.set("chord_error", error);
        const auto world = top.world(settings);
        world->step(frame);
        return world->statistics().broad_phase.leaves - 2;  // the rest are the arc's ends
    };
    // Chords over δ with R(1 − cos δ/2) = error: π/δ of them.
    EXPECT_EQ(edges(1e-4), std::ceil(pi / (2 * std::acos(1 - 1e-4 / 0.5))));
    EXPECT_EQ(edges(1e-2), std::ceil(pi / (2 * std::acos(1 - 1e-2 / 0.5))));
}

/// Rolls a ball at 1 m/s along parts whose top is y = 0 and expects that nothing disturbs it.
void expect_no_bump(TableTop& top, double seconds) {
    for (const double speed : {1.0, -1.0}) {
        top.scene.balls.clear();
        top.ball({speed > 0 ? -0.9 : 0.9, radius - 0.004 / 18.5}, {speed, 0});
        const auto world = top.world();
        run(*world, seconds,
            [&] { EXPECT_EQ(count(world->events(), EventKind::impact), 0) << world->balls()[0].position.x; });
        EXPECT_NEAR(world->balls()[0].velocity.x, speed, 1e-6);
        EXPECT_NEAR(world->balls()[0].velocity.y, 0, 1e-6);
        EXPECT_NEAR(world->balls()[0].position.x, (speed > 0 ? -0.9 : 0.9) + speed * seconds, 1e-4);
    }
}

TEST(Shapes, hundredCollinearSegmentsGiveNoBump) {
    TableTop top;
    const std::uint32_t material = top.material(0.8);
    for (int i = 0; i < 100; ++i)
        top.part(shape::Segment{{-1 + 0.02 * i, 0}, {-1 + 0.02 * (i + 1), 0}}, material);
    expect_no_bump(top, 1.8);
}

TEST(Shapes, capsuleHasNoBumpWhereItsSidesMeetItsEnds) {
    TableTop top;
    const std::uint32_t material = top.material(0.8);
    // The capsule's flat top ends at x = ±0.3; floors before and after join it there at its height.
    top.part(shape::Capsule{{-0.3, -0.05}, {0.3, -0.05}, 0.05}, material);
    top.part(shape::Segment{{-1, 0}, {1, 0}}, material);
    expect_no_bump(top, 1.8);
}

TEST(Shapes, aCornerIsHit) {
    TableTop top;
    top.scene.gravity = {};
    top.part(shape::Polyline{{{-0.1, 0}, {0, 0}, {0, -0.1}}, false}, top.material(1));
    // Straight at the corner along its bisector: comes straight back.
    const Vec2 diagonal = from_angle(pi / 4);
    top.ball(0.05 * diagonal, -1 * diagonal);
    const auto world = top.world();
    run(*world, 0.1);
    EXPECT_NEAR(world->balls()[0].velocity.x, diagonal.x, 1e-4);
    EXPECT_NEAR(world->balls()[0].velocity.y, diagonal.y, 1e-4);
}

}  // namespace
}  // namespace flipside::box2d::test
