// The continuous solver against the reference on random scenes: all shapes, motions and materials, one to six
// balls, at three steps each. Nothing may be further off than 1e-9 radii that is not explained: the reference
// claims no more there, a shift of the start by 1e-13 m leads as far apart, or balls are in resting contact,
// so that they were in an island, which is inexact by design. The explained are counted and printed.

#include <cstdio>

#include <gtest/gtest.h>

#include "in_small.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/hunt/random_scene.hpp"
#include "lab/scenes/clear_starts.hpp"
#include "world/refusal.hpp"

namespace flipside {
namespace {

constexpr double exact = 1e-9;    // radii
constexpr double shift = 1e-13;   // m
constexpr double duration = 0.6;  // s

std::unique_ptr<World> world_of(const Scene& scene, const char* engine,
                                std::initializer_list<std::pair<const char*, const char*>> changes) {
    const Engine& used = lab::engine_named(engine);
    Settings settings(used.settings);
    for (const auto& [name, value] : changes) settings.set(name, value);
    return used.make(std::make_shared<const Scene>(scene), settings);
}

/// Of the worst ball, radii; infinite where the worlds have other balls.
double distance(const World& a, const World& b) {
    if (a.balls().size() != b.balls().size()) return INFINITY;
    double worst = 0;
    for (std::size_t i = 0; i < a.balls().size(); ++i)
        worst = std::max(worst, length(a.balls()[i].position - b.balls()[i].position) / a.balls()[i].radius);
    return worst;
}

enum class Outcome { exact, refused, unknown, chaotic, island, wrong };

/// Up to the end, or to where the first of them differ by more than is exact.
Outcome compare(const Scene& scene, double dt, double& error) {
    Scene shifted = scene;
    for (Ball& ball : shifted.balls) {
        ball.position += {shift, -0.5 * shift};
        ball.velocity += {-shift, shift};  // in a second
        ball.spin += shift / ball.radius;
    }
    const auto ours = world_of(scene, "custom", {{"sleep", "off"}}),
               near = world_of(shifted, "custom", {{"sleep", "off"}}),
               truth = world_of(scene, "reference", {{"twin", "on"}});
    bool pressed = false;
    for (int step = 0; step < duration / dt; ++step) {
        if (step == static_cast<int>(0.2 / dt))
            for (World* world : {&*ours, &*near, &*truth}) world->apply(control::Flip{Side::left, true});
        try {
            truth->step(dt);
        } catch (const Refusal&) {
            return Outcome::refused;
        }
        ours->step(dt);
        near->step(dt);
        pressed = pressed || ours->statistics().handed_over > 0;
        error = distance(*ours, *truth);
        if (error <= exact) continue;
        if (pressed) return Outcome::island;
        for (std::size_t i = 0; i < truth->balls().size(); ++i)
            if (truth->uncertainty()[i] > 0.1 * exact * truth->balls()[i].radius) return Outcome::unknown;
        return distance(*ours, *near) > 0.1 * error ? Outcome::chaotic : Outcome::wrong;
    }
    return Outcome::exact;
}

/// Beyond the first thousand, these once differed: a wide turning arc was passed through on the reference, a
/// ball was left without its support in a wedge, a ball that had begun to slip never rolled again (57490,
/// 66029), a flipper at its stop had a bump where its tip begins (59254, 63954), and the slowest impacts of a
/// ball in a closing wedge were left out (61979, 63497).
constexpr unsigned once_wrong[] = {1558, 1913, 2326, 57490, 59254, 61979, 63497, 63954, 66029};

TEST(RandomScenes, AreAsTheReferenceHasThem) {
    constexpr unsigned scenes = test::in_small ? 30 : 1000;
    std::vector<unsigned> seeds(std::begin(once_wrong), std::end(once_wrong));
    for (unsigned seed = 0; seed < scenes; ++seed) seeds.push_back(seed);
    int counts[6] = {};
    for (const unsigned seed : seeds) {
        Scene scene = lab::RandomScene(seed).make();
        lab::clear_starts(scene);
        for (const double dt : {1.0 / 37, 1.0 / 60, 1.0 / 240}) {
            double error = 0;
            const Outcome outcome = compare(scene, dt, error);
            ++counts[static_cast<int>(outcome)];
            EXPECT_NE(outcome, Outcome::wrong) << "scene " << seed << " at " << dt << " s: " << error << " r";
        }
    }
    std::printf(
        "%zu scenes, three steps each: %d exact, %d until the reference refuses, %d where it claims no "
        "more, %d chaotic, %d with balls in islands, %d wrong\n",
        seeds.size(), counts[0], counts[1], counts[2], counts[3], counts[4], counts[5]);
    EXPECT_GT(counts[0], static_cast<int>(seeds.size()));
}

}  // namespace
}  // namespace flipside
