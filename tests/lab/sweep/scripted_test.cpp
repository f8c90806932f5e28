// Whole scripted runs, up to the horizon of double precision (windows.hpp): the custom engine's continuous
// solver follows the exact engine to 1e-9 radii at any step size, and the exact engine in double precision
// stays within what it claims, checked at 113 bits, which 226 bits check in turn.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include <gtest/gtest.h>

#include "lab/files/assets.hpp"
#include "lab/session/session.hpp"
#include "lab/sweep/contenders.hpp"
#include "lab/sweep/windows.hpp"
#include "world/refusal.hpp"
#include "world/scene_file.hpp"
#include "world/script_file.hpp"

namespace flipside::lab::sweep {
namespace {

/// A session on a scene with its own script.
struct ScriptedRun {
    ScriptedRun(const std::string& name, const std::string& engine, const std::string& settings)
        : scene(std::make_shared<const Scene>(load_scene(scene_file(name)))),
          session(scene, engine_named(engine),
                  settings_of({"", engine, settings, coarsest_steps, finest_steps, ""}, *scene)) {
        if (const auto file = script_beside(scene_file(name)))
            for (const TimedControl& timed : load_script(*file, *scene)) add(timed);
        std::ranges::stable_sort(script, {}, &TimedControl::time);
    }
    /// Balls that wait for a free place are launched at the begin of a step: here each has its own time.
    void add(TimedControl timed) {
        constexpr double apart = 0.1;  // s
        auto* launch = std::get_if<control::Launch>(&timed.control);
        for (int left = launch == nullptr ? 1 : std::exchange(launch->count, 1); left > 0; --left) {
            script.push_back(timed);
            timed.time += apart;
        }
    }
    /// On to a time, in steps of dt at most.
    void go_to(double time, double dt) {
        while (time - session.world().time() > 1e-9 * dt)
            session.step(std::min(dt, time - session.world().time()), script, next);
    }
    [[nodiscard]] const World& world() const { return session.world(); }

    std::shared_ptr<const Scene> scene;
    Session session;
    Script script;
    std::size_t next = 0;
};

class ScriptedRuns : public testing::TestWithParam<std::string> {};

TEST_P(ScriptedRuns, AreTheSameWhateverTheStepUpToTheHorizon) {
    constexpr double look = 0.1, longest = 3;  // s
    // Of a run whose thousand steps a second round more often than a window's.
    constexpr double horizon_here = horizon_radii / 10;
    ScriptedRun exact(GetParam(), "reference", "precision=113 twin=on");
    ScriptedRun rounded(GetParam(), "reference", "precision=53 twin=on");
    std::vector<ScriptedRun> ours;
    const double steps[] = {1.0 / 30, 1.0 / 60, 1.0 / 1000};
    for (std::size_t i = 0; i < std::size(steps); ++i)
        ours.emplace_back(GetParam(), "custom", "solver=continuous");
    std::size_t known = 0, claimed = 0;
    double horizon = 0, worst[std::size(steps)] = {};
    for (int n = 1; n * look <= longest; ++n) {
        const double time = (n - 0.3) * look;  // when nothing is in the scripts
        try {
            exact.go_to(time, look);
            rounded.go_to(time, look);
        } catch (const Refusal&) {
            break;
        }
        for (std::size_t i = 0; i < ours.size(); ++i) ours[i].go_to(time, steps[i]);
        const auto truth = exact.world().balls(), in_double = rounded.world().balls();
        if (in_double.size() != truth.size()) break;
        bool all = true;
        for (std::size_t k = 0; k < truth.size(); ++k) {
            const double r = truth[k].radius, certain = exact.world().uncertainty()[k];
            const double error = length(in_double[k].position - truth[k].position);
            EXPECT_LE(error, rounded.world().uncertainty()[k] + certain) << "ball " << k << " at " << time;
            claimed += std::isfinite(rounded.world().uncertainty()[k]) ? 1U : 0U;
            if (certain > claim_radii * r || error > horizon_here * r) all = false;
        }
        // What one ball does not know its neighbours will not know either.
        if (!all) break;
        horizon = time;
        for (std::size_t k = 0; k < truth.size(); ++k)
            for (std::size_t i = 0; i < ours.size(); ++i) {
                ASSERT_EQ(ours[i].world().balls().size(), truth.size());
                const Vec2 position = ours[i].world().balls()[k].position;
                const double error = length(position - truth[k].position) / truth[k].radius;
                EXPECT_LE(error, exact_radii) << "ball " << k << " at " << time;
                worst[i] = std::max(worst[i], error);
                ++known;
            }
    }
    std::printf("%s: known for %.2f s; worst error in radii at 1/30 %.1e, 1/60 %.1e, 1/1000 %.1e\n",
                GetParam().c_str(), horizon, worst[0], worst[1], worst[2]);
    EXPECT_GT(known, 0U);
    EXPECT_GT(claimed, 0U);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ScriptedRuns,
                         testing::Values("pinball", "toy", "drop", "box", "bowl", "cradle"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace flipside::lab::sweep
