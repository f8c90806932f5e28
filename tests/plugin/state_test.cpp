#include "places.hpp"
#include "support.hpp"
#include "world/state_file.hpp"

namespace flipside::plugin {
namespace {

std::vector<Vec2> places(const World& world) {
    std::vector<Vec2> all;
    for (const Ball& ball : world.balls()) all.push_back(ball.position);
    return all;
}

void run(World& world, int steps) {
    for (int i = 0; i < steps; ++i) world.step(0.01);
}

TEST(PluginState, WhatAnEngineSavesGoesThroughAFileAndItGoesOnWithTheSameBits) {
    const auto scene = falling(3);
    const auto whole = world_of(test::keeper_engine, scene), half = world_of(test::keeper_engine, scene);
    run(*whole, 20);
    run(*half, 10);
    const State saved = half->save();
    EXPECT_EQ(saved.memory.engine, "keeper");
    const State read = parse_state(to_json(saved, *scene), "state", *scene);
    EXPECT_EQ(read, saved);
    const auto rest = world_of(test::keeper_engine, scene);
    rest->restore(read);
    run(*rest, 10);
    EXPECT_EQ(places(*rest), places(*whole));
    // The one that saved was not disturbed by it.
    run(*half, 10);
    EXPECT_EQ(places(*half), places(*whole));
}

TEST(PluginState, WhatWasSavedOfOtherBallsIsNotGivenBack) {
    const auto scene = falling(3);
    const auto half = world_of(test::keeper_engine, scene);
    run(*half, 10);
    State changed = half->save(), bare = changed;
    changed.balls[1].velocity.y = bare.balls[1].velocity.y = 5;
    bare.memory = {};
    const auto a = world_of(test::keeper_engine, scene), b = world_of(test::keeper_engine, scene);
    a->restore(changed);
    b->restore(bare);
    run(*a, 10);
    run(*b, 10);
    EXPECT_EQ(places(*a), places(*b));
}

TEST(PluginState, AnEngineThatFollowsControlsIsNotMadeAnew) {
    const auto world = world_of(test::keeper_engine, falling(3));
    run(*world, 1);
    const double spin = world->balls()[0].spin;
    Ball added = world->balls()[2];
    added.position = {5, 5};
    world->add(added);
    world->remove(1);
    world->apply(control::Nudge{{1, 0}});
    const double before = world->balls()[0].velocity.x;
    run(*world, 1);
    ASSERT_EQ(world->balls().size(), 3U);
    EXPECT_EQ(world->balls()[1].number, 2U);
    EXPECT_EQ(world->balls()[2].number, 3U);
    for (const Ball& ball : world->balls()) EXPECT_EQ(ball.spin, spin);
    EXPECT_NEAR(world->balls()[0].velocity.x, before, 0.05);
    // A state makes a new one.
    world->restore(world->save());
    run(*world, 1);
    EXPECT_EQ(world->balls()[0].spin, spin + 1);
}

}  // namespace
}  // namespace flipside::plugin
