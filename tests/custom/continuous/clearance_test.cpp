#include "custom/continuous/clearance.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "custom/between.hpp"
#include "world/scene_builder.hpp"
#include "world/scene_file.hpp"

namespace flipside::custom::test {
namespace {

/// The clearance of a whole table: all kinds of pieces, arcs from both sides.
struct OnPinball {
    std::shared_ptr<const Scene> scene =
        std::make_shared<const Scene>(load_scene(FLIPSIDE_SOURCE_DIR "/assets/scenes/pinball.json"));
    Table table{scene};
    Layout layout{*scene};
    Clearance clearance{*scene, layout, table};

    [[nodiscard]] double free_for(const Ball& ball, const Flight& flight, double longest, double finest) {
        std::uint64_t boxes = 0, shapes = 0;
        return clearance.free_for(ball, flight, longest, finest, boxes, shapes);
    }
    /// How far the ball is from all pieces, and its centre from the bounds.
    [[nodiscard]] double room(const Ball& ball, Vec2 at) const {
        const Box& bounds = scene->bounds;
        double least =
            std::min({at.x - bounds.min.x, bounds.max.x - at.x, at.y - bounds.min.y, bounds.max.y - at.y});
        for (const Piece& piece : layout.pieces())
            least = std::min(least, touch(at, ball.radius, piece, table.pose(piece.part)).separation);
        return least;
    }
};

Flight any_flight(const Scene& scene) {
    return {{between(0.01, 0.51), between(0.01, 1.06)},
            between(0, 4) * from_angle(between(0, 7)),
            scene.gravity,
            scene.damping};
}

RC_GTEST_PROP(Clearance, WhatIsToldToBeFreeTouchesNothing, ()) {
    static OnPinball on;
    const Ball ball = on.scene->launcher->ball;
    const Flight flight = any_flight(*on.scene);
    const double free = on.free_for(ball, flight, between(0.02, 1), 1.0 / 120);
    for (double t = 0; t < free; t += 1.0 / 480)
        RC_ASSERT(on.room(ball, flight.position + flight.displacement(t)) > 0);
}

// Against the time of impact. The surface of all these is about 2 m to the right.
TEST(Clearance, FlightsAreFollowedToWhatTheyMeet) {
    const Shape shapes[] = {segment({2, -3}, {2, 1}),
                            {shape::Point{{2, 0}}},
                            {shape::Circle{{3, 0}, 1}},
                            {shape::Capsule{{2.5, -1}, {3, 4}, 0.5}},
                            {shape::Polygon{{{2, 0}, {3, -1}, {4, 2}}}},
                            {shape::Arc{{-1, 0}, 3, -1, 1}},
                            {shape::Arc{{5, 0}, 3, 2, 4}}};
    for (const Shape& shape : shapes) {
        Scene scene = empty_scene({0, -1});
        add_part(scene, shape);
        add_part(scene, segment({-2, -3}, {9, -3}));
        const Table table(std::make_shared<const Scene>(scene));
        const Layout layout(scene);
        Clearance clearance(scene, layout, table);
        const Ball ball = add_ball(scene, {}, {4, 0.2}, 0.1);
        std::uint64_t tests = 0;
        const Flight flight{ball.position, ball.velocity, scene.gravity, 0.05};
        double met = never_touch;
        Path path;
        path.flight = flight;
        for (const Feature& feature : features_of(layout.pieces(), scene))
            met = std::min(met, time_of_impact(feature, {}, path, ball.radius, 0, 1));
        ASSERT_LT(met, 1);
        const double free = clearance.free_for(ball, flight, 1, 1e-4, tests, tests);
        EXPECT_LT(free, met);
        EXPECT_GT(free, met - 1e-3) << shape.is.index();
    }
}

}  // namespace
}  // namespace flipside::custom::test
