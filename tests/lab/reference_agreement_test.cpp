// The exact engine against the bespoke one's continuous solver: from states along the exact trajectory both
// run for a short while, and each ball ends at the same place. Two programs that share no solver code.

#include <algorithm>
#include <cstdio>

#include <gtest/gtest.h>

#include "lab/assets.hpp"
#include "lab/engines.hpp"
#include "lab/session.hpp"
#include "world/scene_file.hpp"
#include "world/script_file.hpp"

namespace flipside {
namespace {

struct Windows {
    std::string scene;
    int launched;    ///< balls, at the start
    double every;    ///< s, between windows
    double seconds;  ///< of a window
    int count;
};

std::unique_ptr<World> world_of(const std::shared_ptr<const Scene>& scene, const std::string& name) {
    const Engine& engine = lab::engine_named(name);
    Settings settings = lab::settings_for(engine, *scene);
    if (name == "custom") settings.set("solver", "continuous");
    return engine.make(scene, settings);
}

void run(World& world, double seconds) {
    const auto steps = static_cast<int>(std::lround(seconds * 60));
    for (int i = 0; i < steps; ++i) world.step(1.0 / 60);
}

/// Largest distance of a ball from its twin, in radii, per window.
std::vector<double> differences(const Windows& windows) {
    const auto scene = std::make_shared<const Scene>(load_scene(lab::scene_file(windows.scene)));
    const auto truth = world_of(scene, "reference");
    const auto exact = world_of(scene, "reference"), custom = world_of(scene, "custom");
    if (windows.launched > 0) truth->apply(control::Launch{0.8, windows.launched, 1});
    truth->apply(control::Rotate{true});
    std::vector<double> found;
    for (int i = 0; i < windows.count; ++i) {
        run(*truth, windows.every);
        if (scene->rules) {
            truth->apply(control::Flip{Side::left, i % 3 == 0});
            truth->apply(control::Flip{Side::right, i % 4 == 0});
        }
        const State state = truth->save();
        for (World* world : {exact.get(), custom.get()}) {
            world->restore(state);
            run(*world, windows.seconds);
        }
        double worst = exact->balls().size() == custom->balls().size() ? 0 : INFINITY;
        for (std::size_t k = 0; k < exact->balls().size() && std::isfinite(worst); ++k) {
            const Ball &a = exact->balls()[k], &b = custom->balls()[k];
            worst = std::max(worst, length(a.position - b.position) / a.radius);
        }
        found.push_back(worst);
    }
    return found;
}

class Agreement : public testing::TestWithParam<Windows> {};

TEST_P(Agreement, OfTheExactAndTheContinuousSolver) {
    std::vector<double> found = differences(GetParam());
    std::ranges::sort(found);
    const auto same = std::ranges::count_if(found, [](double d) { return d <= 1e-9; });
    std::printf("%s: %zu windows, median %.2g radii, largest %.2g, %td within 1e-9\n",
                GetParam().scene.c_str(), found.size(), found[found.size() / 2], found.back(), same);
    EXPECT_LE(found[found.size() / 2], 1e-11);
    // Where a ball comes to a joint, or a hit is a graze, the two may take a different side of rounding.
    EXPECT_GE(static_cast<double>(same), 0.9 * static_cast<double>(found.size()));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Agreement,
                         testing::Values(Windows{"pinball", 3, 0.1, 0.2, 100},
                                         Windows{"toy", 12, 0.1, 0.2, 100},
                                         Windows{"rain", 0, 0.05, 0.1, 20}),
                         [](const auto& test) { return test.param.scene; });

}  // namespace
}  // namespace flipside
