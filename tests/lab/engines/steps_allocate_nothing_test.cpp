// No step asks the heap for anything once a run has warmed up: every scene that comes with the program, under
// its own script, with either solver forced and with the one it would choose.

#include <gtest/gtest.h>

#include "in_small.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "lab/session/session.hpp"
#include "world/scene_file.hpp"
#include "world/script_file.hpp"

namespace flipside::lab {
namespace {

using SceneAndSolver = std::tuple<std::string, std::string>;
class Steps : public testing::TestWithParam<SceneAndSolver> {};

TEST_P(Steps, AllocateNothingAfterWarmUp) {
    const auto& [name, solver] = GetParam();
    const auto scene = std::make_shared<const Scene>(load_scene(scene_file(name)));
    const Engine& custom = engine_named("custom");
    Settings settings = settings_for(custom, *scene);
    settings.set("solver", solver);
    Session session(scene, custom, settings);
    Script script;
    if (const auto file = script_beside(scene_file(name))) script = load_script(*file, *scene);
    std::size_t next = 0;
    // Many balls event by event take a while where they lie in heaps.
    const bool crowd = scene->balls.size() > 64 && solver == "continuous";
    const int steps = crowd ? 90 : flipside::test::in_small ? 240 : 900;
    for (int i = 0; i < steps; ++i) session.step(step_for(*scene), script, next);
    EXPECT_EQ(session.totals().allocations, 0U);
}

INSTANTIATE_TEST_SUITE_P(EveryScene, Steps,
                         testing::Combine(testing::ValuesIn(scene_names()),
                                          testing::Values("simple", "continuous")),
                         [](const auto& test) {
                             return std::get<0>(test.param) + "_" + std::get<1>(test.param);
                         });

}  // namespace
}  // namespace flipside::lab
