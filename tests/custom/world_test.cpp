// The World interface: controls, gates, sensors, layers, targets, loss, state.

#include <algorithm>

#include <gtest/gtest.h>

#include "custom/broad_phase/registry.hpp"
#include "custom/scenes.hpp"

namespace flipside::custom::test {
namespace {

std::vector<Event> run_collecting(World& world, double seconds, double dt = 1.0 / 60) {
    std::vector<Event> events;
    const auto steps = static_cast<int>(std::lround(seconds / dt));
    for (int i = 0; i < steps; ++i) {
        world.step(dt);
        events.insert(events.end(), world.events().begin(), world.events().end());
    }
    return events;
}
auto count(const std::vector<Event>& events, EventKind kind) {
    return std::ranges::count(events, kind, &Event::kind);
}

TEST(World, AdvancesTimeByExactlyTheStep) {
    const auto world = make_world(empty_scene(), {{"motion_iterations", "3"}});
    for (int i = 0; i < 1000; ++i) world->step(0.1);
    EXPECT_NEAR(world->time(), 100, 1e-13);
}

TEST(World, FlightIsTheExactParabolaAtAnyStep) {
    for (const double dt : {1.0 / 10, 1.0 / 60, 1.0 / 1000}) {
        Scene scene = empty_scene({0.5, -9.81});
        add_ball(scene, {1, 2}, {3, 4});
        const auto world = make_world(scene);
        run(*world, 1, dt);
        EXPECT_NEAR(world->balls()[0].position.x, 1 + 3 + 0.25, 1e-12);
        EXPECT_NEAR(world->balls()[0].position.y, 2 + 4 - 4.905, 1e-12);
    }
}

TEST(World, DampingIsTheExactExponential) {
    for (const double c : {1e-6, 0.3, 20.0}) {
        Scene scene = empty_scene({0, -9.81});
        scene.damping = c;
        add_ball(scene, {0, 0}, {2, 0});
        const auto world = make_world(scene);
        run(*world, 1);
        const Ball& ball = world->balls()[0];
        EXPECT_NEAR(ball.velocity.x, 2 * std::exp(-c), 1e-13);
        EXPECT_NEAR(ball.position.x, 2 * -std::expm1(-c) / c, 1e-13);
        EXPECT_NEAR(ball.velocity.y, 9.81 * std::expm1(-c) / c, 1e-12);
    }
}

TEST(World, ImpactEventSaysWhereWhenAndHowHard) {
    Scene scene = empty_scene();
    add_ball(scene, {0, 1.12}, {1, -2}, 0.1, 3);
    add_part(scene, segment({-9, 0}, {9, 0}), {"", 0.5, 0, 0});
    const auto world = make_world(scene);
    const std::vector<Event> events = run_collecting(*world, 1);
    ASSERT_EQ(events.size(), 1U);
    const Event& hit = events[0];
    EXPECT_EQ(hit.kind, EventKind::impact);
    EXPECT_EQ(hit.ball, 0U);
    EXPECT_EQ(hit.other, Other::part(0));
    EXPECT_NEAR(hit.time, 0.51, 1e-6);
    EXPECT_NEAR(hit.point.x, 0.51, 0.02);
    EXPECT_EQ(hit.point.y, 0);
    EXPECT_EQ(hit.normal, (Vec2{0, 1}));
    EXPECT_NEAR(hit.speed, 2, 1e-15);
    EXPECT_NEAR(hit.impulse, 1.5 * 3 * 2, 1e-14);
    EXPECT_NEAR(world->balls()[0].position.y, 0.1 + 0.49, 1e-6);
}

TEST(World, GatePassesOneWayAndReflectsTheOther) {
    Scene scene = empty_scene();
    for (const double speed : {0.5, 3.0, 30.0})
        for (const double side : {-1.0, 1.0}) {
            scene.parts.clear(), scene.balls.clear();
            add_ball(scene, {0, side}, {0, -side * speed});
            add_part(scene, {shape::Gate{{-0.5, 0}, {0.5, 0}, {0, 1}}});
            const auto world = make_world(scene);
            bool opened = false;
            for (double t = 0; t < 2 / speed; t += 1e-3) {
                world->step(1e-3);
                opened = opened || world->parts()[0].open;
            }
            const Ball& ball = world->balls()[0];
            EXPECT_NEAR(ball.velocity.y, speed, 1e-12) << speed << " from " << side;
            EXPECT_NEAR(ball.position.y, side < 0 ? 1 : 1.2, 0.05) << speed;
            EXPECT_EQ(opened, side < 0);
            EXPECT_FALSE(world->parts()[0].open);
        }
}

TEST(World, GateStaysOpenWhileOccupied) {
    Scene scene = empty_scene();
    add_ball(scene, {0, 0.02}, {0, 0});  // in the gate, at rest
    add_ball(scene, {0.5, 1}, {0, -1});  // approaches it
    add_part(scene, {shape::Gate{{-1, 0}, {1, 0}, {0, 1}}});
    const auto world = make_world(scene, {{"sleep", "off"}});
    State state = world->save();
    state.parts[0].open = true;
    world->restore(state);
    run(*world, 2);
    EXPECT_TRUE(world->parts()[0].open);
    EXPECT_NEAR(world->balls()[1].position.y, -1, 1e-12);
    EXPECT_EQ(world->balls()[0].position, (Vec2{0, 0.02}));
}

TEST(World, SensorBeginsOnceAndEndsOnceAtAnySpeed) {
    for (const double speed : {0.3, 5.0, 300.0}) {
        Scene scene = empty_scene();
        add_ball(scene, {-0.97, 0}, {speed, 0});
        add_part(scene, segment({0, -1}, {0, 1})).sensor = true;
        const auto world = make_world(scene);
        const std::vector<Event> events = run_collecting(*world, std::ceil(2 / speed * 60) / 60);
        ASSERT_EQ(events.size(), 2U) << speed;
        EXPECT_EQ(events[0].kind, EventKind::sensor_begin);
        EXPECT_EQ(events[1].kind, EventKind::sensor_end);
        EXPECT_EQ(events[0].other, Other::part(0));
        EXPECT_EQ(world->balls()[0].velocity, (Vec2{speed, 0}));
        EXPECT_TRUE(world->contacts().empty());
    }
}

TEST(World, LayersThatDoNotMeetPassThroughEachOther) {
    Scene scene = empty_scene();
    add_ball(scene, {0, 1}, {0, -1}).collides_with = 1;
    Ball& other = add_ball(scene, {0.05, -1}, {0, 1});
    other.layer = other.collides_with = 2;
    Part& part = add_part(scene, segment({-1, 0}, {1, 0}));
    part.layer = 4;
    const auto world = make_world(scene);
    EXPECT_TRUE(run_collecting(*world, 2).empty());
    EXPECT_NEAR(world->balls()[0].position.y, -1, 1e-12);
    EXPECT_EQ(world->statistics().narrow_tests, 0U);
}

TEST(World, DropTargetGoesDownUntilRaised) {
    Scene scene = empty_scene();
    add_ball(scene, {0, 1}, {0, -1});
    add_part(scene, segment({-1, 0}, {1, 0})).target = true;
    add_part(scene, segment({-1, 2}, {1, 2}));
    const auto world = make_world(scene);
    run(*world, 1);
    EXPECT_TRUE(world->parts()[0].down);
    run(*world, 4);  // to the wall, and back through its first position
    EXPECT_LT(world->balls()[0].position.y, 0);
    world->apply(control::RaiseTargets{});
    EXPECT_FALSE(world->parts()[0].down);
}

// The shortest way out of the block leads through the floor.
TEST(World, ATargetThatIsRaisedPushesNoBallThroughTheFloor) {
    Scene scene = empty_scene({0, -1});
    add_ball(scene, {0, 0.1});
    add_ball(scene, {0, 2}, {0, -1});
    add_part(scene, segment({-2, 0}, {2, 0}));
    add_part(scene, {shape::Polygon{{{-0.5, 0.01}, {0.5, 0.01}, {0.5, 0.6}, {-0.5, 0.6}}}}).target = true;
    const auto world = make_world(scene);
    run(*world, 2);
    ASSERT_TRUE(world->parts()[1].down);
    for (int i = 0; i < 5; ++i) {
        world->apply(control::RaiseTargets{});
        run(*world, 0.5);
        for (const Ball& ball : world->balls()) EXPECT_GT(ball.position.y, 0) << i;
    }
}

TEST(World, LostOnceAndRemovedOrKept) {
    for (const bool keep : {false, true}) {
        Scene scene = empty_scene();
        scene.bounds = {{-1, -1}, {1, 1}};
        scene.keep_lost = keep;
        add_ball(scene, {0, 0}, {2, 0});
        add_ball(scene, {0, 0.5});
        const auto world = make_world(scene);
        const std::vector<Event> events = run_collecting(*world, 1);
        ASSERT_EQ(events.size(), 1U);
        EXPECT_EQ(events[0].kind, EventKind::lost);
        EXPECT_EQ(events[0].ball, 0U);
        EXPECT_EQ(world->balls().size(), keep ? 2U : 1U);
        EXPECT_EQ(world->save().reported_lost.size(), keep ? 1U : 0U);
    }
}

TEST(World, NumbersAreNeverUsedAgain) {
    Scene scene = empty_scene();
    add_ball(scene, {0, 0});
    const auto world = make_world(scene);
    EXPECT_EQ(world->add(scene.balls[0]), 1U);
    EXPECT_TRUE(world->remove(1));
    EXPECT_FALSE(world->remove(1));
    EXPECT_EQ(world->add(scene.balls[0]), 2U);
}

TEST(World, LaunchesWaitForTheirPlace) {
    Scene scene = empty_scene();
    scene.launcher = Launcher{{0, 0}, {1, 0}, 1, 3, false, {}};
    scene.launcher->ball.radius = 0.1;
    scene.launcher->ball.mass = 1;
    const auto world = make_world(scene);
    world->apply(control::Launch{0.5, 10, 1});
    run(*world, 10);
    ASSERT_EQ(world->balls().size(), 10U);
    for (std::size_t i = 0; i < 10; ++i) EXPECT_NEAR(world->balls()[i].velocity.x, 2, 1e-12);
    for (std::size_t i = 1; i < 10; ++i)
        EXPECT_GE(world->balls()[i - 1].position.x - world->balls()[i].position.x, 0.3 - 1e-9);
}

TEST(World, TouchesThatLastBeginAndEnd) {
    Scene scene = empty_scene({0, -9.81});
    add_ball(scene, {0, 0.3}, {0, 0});
    add_part(scene, segment({-1, 0}, {1, 0}), {"", 0, 0, 0});
    const auto world = make_world(scene);
    std::vector<Event> events = run_collecting(*world, 1);
    EXPECT_EQ(count(events, EventKind::impact), 1);
    EXPECT_EQ(count(events, EventKind::begin), 1);
    ASSERT_EQ(world->contacts().size(), 1U);
    EXPECT_NEAR(world->contacts()[0].separation, 0, 1e-10);
    world->apply(control::Nudge{{0, 2}});
    events = run_collecting(*world, 0.1);
    EXPECT_EQ(count(events, EventKind::end), 1);
    EXPECT_TRUE(world->contacts().empty());
}

/// A table with one part of each kind.
Scene rich_scene() {
    Scene scene = empty_scene({0, -2});
    scene.bounds = {{-2, -2}, {2, 2}};
    scene.damping = 0.05;
    for (int i = 0; i < 20; ++i)
        add_ball(scene, {-1.5 + 0.15 * i, 0.7 + 0.05 * (i % 3)}, {0.3 * i - 2, 0.1 * i}, 0.05, 1 + i % 3);
    add_part(scene, {shape::Polyline{{{-1.8, -1.8}, {1.8, -1.8}, {1.8, 1.8}, {-1.8, 1.8}}, true}},
             {"", 0.8, 0.3, 0});
    add_part(scene, {shape::Circle{{0, -0.5}, 0.2}}, {"", 0.9, 0, 2});
    add_part(scene, {shape::Gate{{-1.8, 0.4}, {-1, 0.4}, {0, 1}}});
    add_part(scene, segment({0.5, -1}, {1.5, -0.8})).sensor = true;
    add_part(scene, segment({-1, -1.2}, {-0.5, -1.2})).target = true;
    add_part(scene, segment({0.6, 0}, {1.2, 0})).motion = motion::Turn{{0.9, 0}, 3, true};
    add_part(scene, {shape::Flipper{{-0.9, -0.6}, 0.5, 0.08, 0.05, -0.4}}).motion =
        motion::Flip{Side::left, 0.5, 20, 10};
    return scene;
}

void expect_same(const World& a, const World& b) {
    const State x = a.save(), y = b.save();
    EXPECT_EQ(x.clock, y.clock);
    EXPECT_TRUE(x.balls == y.balls);
    EXPECT_TRUE(x.parts == y.parts);
}

TEST(World, SaveAndRestoreContinueBitForBit) {
    const auto through = make_world(rich_scene()), first = make_world(rich_scene()),
               second = make_world(rich_scene());
    const auto half = [](World& world) {
        std::vector<Event> events;
        for (int i = 0; i < 300; ++i) {
            if (i % 40 == 0) world.apply(control::Flip{Side::left, i % 80 == 0});
            if (i == 250) world.apply(control::RaiseTargets{});
            const auto step_events = run_collecting(world, 1.0 / 60);
            events.insert(events.end(), step_events.begin(), step_events.end());
        }
        return events;
    };
    half(*through);
    half(*first);
    second->restore(first->save());
    const std::vector<Event> expected = half(*through), found = half(*second);
    expect_same(*through, *second);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].time, expected[i].time);
        EXPECT_EQ(found[i].kind, expected[i].kind);
        EXPECT_EQ(found[i].other, expected[i].other);
        EXPECT_EQ(found[i].impulse, expected[i].impulse);
    }
    EXPECT_GT(count(expected, EventKind::impact), 100);
    EXPECT_GT(count(expected, EventKind::sensor_begin), 0);
}

TEST(World, BroadPhaseChangesNoBit) {
    const auto brute = make_world(rich_scene(), {{"solver", "simple"}, {"broad_phase", "brute"}});
    const auto tree = make_world(
        rich_scene(), {{"solver", "simple"}, {"broad_phase", "quadtree"}, {"quadtree_levels", "3"}});
    run(*brute, 5);
    run(*tree, 5);
    expect_same(*brute, *tree);
    EXPECT_LT(tree->statistics().pair_tests, brute->statistics().pair_tests);
    EXPECT_EQ(tree->statistics().broad_phase.leaves, 64);
    for (const BroadPhaseKind& kind : broad_phases) {
        const auto world = make_world(rich_scene(), {{"solver", "simple"}, {"broad_phase", kind.name}});
        run(*world, 5);
        expect_same(*brute, *world);
    }
}

TEST(World, ShowsItsInsides) {
    struct Counter final : Inspector {
        int boxes = 0, cells = 0, pairs = 0, contacts = 0, sleepers = 0, others = 0;
        [[nodiscard]] bool wants(Topic) const override { return true; }
        void box(Topic, const Box&) override { ++boxes; }
        void cell(const Box&, int) override { ++cells; }
        void pair(Vec2, Vec2) override { ++pairs; }
        void contact(const Contact&) override { ++contacts; }
        void segment(Topic, Vec2, Vec2) override { ++others; }
        void circle(Topic topic, Vec2, double) override { ++(topic == Topic::sleep ? sleepers : others); }
    } counter;
    Scene scene = empty_scene({0, -9.81});
    add_ball(scene, {0, 0.1});
    add_ball(scene, {5, 5});
    add_part(scene, segment({-1, 0}, {1, 0}));
    add_part(scene, segment({-9, 9}, {-8, 9})).motion = motion::Turn{{-8, 9}, 1, true};
    const auto world = make_world(scene);
    run(*world, 0.3);
    world->inspect(counter);
    EXPECT_EQ(counter.boxes, 2 * 3 + 2);  // two faces with two ends each, two balls
    EXPECT_EQ(counter.cells, 2);
    EXPECT_EQ(counter.pairs, 1);
    EXPECT_EQ(counter.contacts, 1);
    EXPECT_EQ(counter.sleepers, 1);
    EXPECT_EQ(counter.others, 0);
}

TEST(World, KnowsItsSettingsAndRefusesOthers) {
    Settings settings(engine().settings);
    EXPECT_EQ(settings.integer("motion_iterations"), 4);
    EXPECT_EQ(settings.integer("collision_iterations"), 6);
    EXPECT_EQ(settings.choice("solver"), "continuous");
    EXPECT_THROW(settings.set("broad_phase", "magic"), std::runtime_error);
    try {
        settings.set("solver", "discrete");
        FAIL() << "a solver that is no longer there was taken";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string_view(error.what()).find("take continuous"), std::string_view::npos);
    }
    EXPECT_THROW(settings.set("motion_iterations", "65"), std::runtime_error);
}

}  // namespace
}  // namespace flipside::custom::test
