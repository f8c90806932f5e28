#include <gtest/gtest.h>

#include "box2d/table_top.hpp"

namespace flipside::box2d::test {
namespace {

/// Counts of all events of a run.
struct Counts {
    int by_kind[6] = {};

    Counts(World& world, double seconds) {
        run(world, seconds, [&] {
            for (const Event& event : world.events()) ++by_kind[static_cast<int>(event.kind)];
        });
    }
    int operator[](EventKind kind) const { return by_kind[static_cast<int>(kind)]; }
};

TEST(Touching, sensorBeginsOnceAndEndsOnceAtAnySpeed) {
    // At 50 m/s and 1/60 s a ball moves 62 radii per step: two looks never find it on the thin sensor. (The
    // scale keeps the step below Box2D's limit of 2 units.)
    for (const double speed : {0.1, 1.0, 6.0, 50.0}) {
        TableTop top;
        top.scene.gravity = {};
        top.part(shape::Segment{{0, -0.1}, {0, 0.1}}).sensor = true;
        top.ball({-0.05, 0.03}, {speed, 0});
        Settings settings(engine().settings);
        settings.set("length_scale", 2);
        const auto world = top.world(settings);
        const Counts counts(*world, 0.1 / speed + 2 * frame);
        EXPECT_EQ(counts[EventKind::sensor_begin], 1) << speed;
        EXPECT_EQ(counts[EventKind::sensor_end], 1) << speed;
        EXPECT_EQ(counts[EventKind::impact] + counts[EventKind::begin], 0) << speed;
        EXPECT_NEAR(world->balls()[0].velocity.x, speed, 1e-5 * speed);
    }
}

TEST(Touching, sensorOfManyCornersKnowsItsInside) {
    TableTop top;
    top.scene.gravity = {};
    shape::Polygon polygon;
    for (int i = 0; i < 20; ++i) polygon.points.push_back(0.2 * from_angle(0.1 * 3.14159265358979 * i));
    top.part(polygon).sensor = true;
    top.ball({-0.5, 0.01}, {1, 0});
    const auto world = top.world();
    const Counts there(*world, 0.5);
    EXPECT_EQ(there[EventKind::sensor_begin], 1);
    EXPECT_EQ(there[EventKind::sensor_end], 0);  // now at the centre, far from every side
    const Counts gone(*world, 0.5);
    EXPECT_EQ(gone[EventKind::sensor_begin], 0);
    EXPECT_EQ(gone[EventKind::sensor_end], 1);
}

TEST(Touching, restBeginsOnceAndABounceDoesNot) {
    TableTop top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}, top.material(0.5));
    top.ball({0, 0.1});
    const auto world = top.world();
    const Counts counts(*world, 3);
    EXPECT_EQ(counts[EventKind::begin], 1);
    EXPECT_EQ(counts[EventKind::end], 0);
    EXPECT_GE(counts[EventKind::impact], 3);
}

TEST(Touching, rollingOffAnEdgeEndsTheTouch) {
    TableTop top;
    top.part(shape::Segment{{-1, 0}, {0.1, 0}}, top.material(0));
    top.ball({0, radius - 0.0001}, {0.5, 0});
    const auto world = top.world();
    const Counts counts(*world, 0.5);
    EXPECT_EQ(counts[EventKind::begin], 0) << "it touches from the start";
    EXPECT_EQ(counts[EventKind::end], 1);
}

TEST(Touching, aBallThatLeavesFromTheStartHasNoTouchThatEnds) {
    TableTop top;
    top.part(shape::Segment{{-1, 0}, {1, 0}}, top.material(0));
    top.ball({0, radius - 0.0001}, {0, 2});
    const auto world = top.world();
    const Counts counts(*world, 0.1);
    EXPECT_EQ(counts[EventKind::begin], 0);
    EXPECT_EQ(counts[EventKind::end], 0);
}

TEST(Touching, contactsAreThoseOfThisInstantByPair) {
    TableTop top;
    top.scene.gravity = {};
    top.part(shape::Segment{{0, -1}, {0, 1}});
    top.part(shape::Circle{{0.1, 0}, 0.05});
    top.ball({0.1, 0.05 + radius - 0.001});
    top.ball({0.013, 0});
    top.ball({0.013 + 2 * radius - 0.002, 0.0});
    const auto world = top.world();
    const auto contacts = world->contacts();
    ASSERT_EQ(contacts.size(), 4U);
    EXPECT_EQ(contacts[0].other, Other::part(1));
    EXPECT_NEAR(contacts[0].separation, -0.001, 1e-7);
    EXPECT_NEAR(contacts[0].point.y, 0.05, 1e-7);
    EXPECT_EQ(contacts[1].ball, 1U);
    EXPECT_EQ(contacts[1].other, Other::part(0));
    EXPECT_NEAR(contacts[1].separation, -0.0005, 1e-7);
    EXPECT_NEAR(contacts[1].normal.x, 1, 1e-6);
    EXPECT_NEAR(contacts[1].point.x, 0, 1e-7);
    EXPECT_EQ(contacts[2].other, Other::ball(2));
    EXPECT_NEAR(contacts[2].normal.x, -1, 1e-6);
    EXPECT_NEAR(contacts[2].point.x, 0.013 + radius - 0.002, 1e-7);
    EXPECT_NEAR(contacts[2].separation, -0.002, 1e-7);
    EXPECT_EQ(contacts[3].ball, 2U);
}

}  // namespace
}  // namespace flipside::box2d::test
