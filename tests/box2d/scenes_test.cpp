#include <algorithm>

#include <gtest/gtest.h>

#include "box2d/table_top.hpp"
#include "places.hpp"
#include "world/scene_file.hpp"
#include "world/script_file.hpp"

namespace flipside::box2d::test {
namespace {

std::string asset(const std::string& name) {
    return flipside::test::source("assets/scenes/") + name;
}

/// Plays a scene with its script for `seconds`, one step after another.
void play(World& world, const Script& script, double seconds, auto&& see) {
    std::size_t next = 0;
    run(world, seconds, [&] {
        see();
        for (; next < script.size() && script[next].time <= world.time(); ++next)
            world.apply(script[next].control);
    });
}

TEST(Scenes, pinballLosesBallsOnlyThroughTheDrain) {
    const auto scene = std::make_shared<Scene>(load_scene(asset("pinball.json")));
    const Script script = load_script(asset("pinball.script.json"), *scene);
    const auto world = engine().make(scene, Settings(engine().settings));
    int impacts = 0;
    play(*world, script, 60, [&] {
        for (const Event& event : world->events()) {
            if (event.kind != EventKind::lost) continue;
            // Below the table and between its side walls; a NaN is neither.
            EXPECT_LT(event.point.y, 0);
            EXPECT_TRUE(event.point.x > 0.1 && event.point.x < 0.42) << event.point.x;
        }
        for (const Ball& ball : world->balls())
            EXPECT_TRUE(is_finite(ball.position) && is_finite(ball.velocity));
        impacts += count(world->events(), EventKind::impact);
    });
    EXPECT_GT(impacts, 100);
}

TEST(Scenes, aThousandBallsOnTheToyStayInPlay) {
    const auto scene = std::make_shared<Scene>(load_scene(asset("toy.json")));
    const auto world = engine().make(scene, Settings(engine().settings));
    world->apply(control::Rotate{true});
    world->apply(control::Launch{1, 1000, 1});
    int lost = 0;
    run(*world, 20, [&] { lost += count(world->events(), EventKind::lost); });
    EXPECT_EQ(lost, 0);
    EXPECT_GT(world->balls().size(), 200U);
    for (const Ball& ball : world->balls()) EXPECT_TRUE(scene->bounds.contains(ball.position));
}

}  // namespace
}  // namespace flipside::box2d::test
