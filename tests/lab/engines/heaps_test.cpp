// Heaps that the bespoke engine has brought to rest: the exact engine takes them up and looks for forces that
// balance all weights.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <regex>

#include <gtest/gtest.h>

#include "in_small.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "lab/scenes/dice.hpp"
#include "lab/session/run_settings.hpp"
#include "world/refusal.hpp"
#include "world/scene_builder.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab {
namespace {

Scene heap_scene(double friction) {
    Scene scene = empty_scene({0, -9.81});
    scene.materials[0].restitution = 0.5;
    scene.materials[0].friction = friction;
    return scene;
}
Scene falling_column(double gap, double heavy) {
    Scene scene = heap_scene(0);
    add_part(scene, segment({-1, 0}, {1, 0}), {"", 0.5, 0, 0});
    for (int i = 0; i < 10; ++i) add_ball(scene, {0, 0.1 + (0.2 + gap) * i}, {}, 0.1, i % 2 == 0 ? 1 : heavy);
    return scene;
}
/// Fifty balls that rain into a V.
Scene rain_in_a_groove(double friction) {
    Scene scene = heap_scene(friction);
    add_part(scene, {shape::Polyline{{{-4, 4}, {0, 0}, {4, 4}}, false}}, {"", 0.5, friction, 0});
    for (int i = 0; i < 50; ++i) {
        const int row = i / 9;
        add_ball(scene, {-0.9 + 0.21 * (i % 9) + 0.003 * row, 1.2 + 0.25 * row});
    }
    return scene;
}

std::unique_ptr<World> world_of(const char* name, const Scene& scene) {
    const Engine& engine = engine_named(name);
    const auto shared = std::make_shared<const Scene>(scene);
    return engine.make(shared, settings_for(engine, *shared, {}));
}

std::unique_ptr<World> at_rest(const Scene& scene) {
    auto world = world_of("custom", scene);
    while (world->time() < 20 && world->statistics().asleep < scene.balls.size()) world->step(1.0 / 60);
    EXPECT_EQ(world->statistics().asleep, scene.balls.size());
    return world;
}

TEST(RestedHeaps, WithoutFrictionAreInEquilibriumOnTheReference) {
    for (const Scene& scene : {falling_column(0.01, 1), falling_column(0, 1000), rain_in_a_groove(0)}) {
        const auto bespoke = at_rest(scene), exact = world_of("reference", scene);
        exact->restore(bespoke->save());
        for (int i = 0; i < 60; ++i) ASSERT_NO_THROW(exact->step(1.0 / 60));
        EXPECT_EQ(exact->statistics().asleep, scene.balls.size());
        EXPECT_EQ(exact->statistics().impacts, 0U);
        for (std::size_t i = 0; i < scene.balls.size(); ++i)
            EXPECT_EQ(exact->balls()[i].position, bespoke->balls()[i].position);
    }
}

/// The largest part of a ball's weight that no contact forces hold up; 0 in equilibrium.
double missing_support(const World& bespoke, const Scene& scene) {
    const auto exact = world_of("reference", scene);
    exact->restore(bespoke.save());
    try {
        exact->step(1.0 / 60);
    } catch (const Refusal& refusal) {
        const std::string why = refusal.what();
        std::smatch found;
        if (std::regex_search(why, found, std::regex("begins to move: ([0-9.e-]+) of its weight")))
            return std::stod(found[1]);
        return 1;  // a ball already moves
    }
    return 0;
}

// With friction it falls asleep while its last contacts still settle.
TEST(RestedHeaps, WithFrictionLacksLittleOfAWeight) {
    const Scene scene = rain_in_a_groove(0.5);
    EXPECT_LT(missing_support(*at_rest(scene), scene), 0.02);
}

/// Balls of `rain` that fall with other speeds for each seed.
Scene rain_of(int balls, std::uint64_t seed) {
    Scene scene = load_scene(scene_file("rain"), balls);
    Dice dice(seed);
    for (Ball& ball : scene.balls) ball.velocity.x += dice.between(-1, 1);
    return scene;
}

// Balls that sleep too early, or carry balls that came to rest on them later, lack some of it.
// FLIPSIDE_HEAPS=N takes N heaps of each size.
TEST(RestedHeaps, OfRainSeldomLackMuchOfAWeight) {
    const char* const wish = std::getenv("FLIPSIDE_HEAPS");
    const int of_each = wish != nullptr ? std::atoi(wish) : test::in_small ? 3 : 8;
    int heaps = 0, awake = 0, lack_a_hundredth = 0, lack_a_twentieth = 0;
    double most = 0;
    for (int n = 0; n < of_each; ++n)
        for (const int balls : {40, 90, 150}) {
            const Scene scene = rain_of(balls, static_cast<std::uint64_t>(n) + 6);
            const auto world = world_of("custom", scene);
            while (world->time() < 30) world->step(1.0 / 60);
            const double missing = missing_support(*world, scene);
            ++heaps;
            awake += world->statistics().asleep < scene.balls.size();
            lack_a_hundredth += missing > 0.01;
            lack_a_twentieth += missing > 0.05;
            most = std::max(most, missing);
        }
    std::printf(
        "%d heaps, %d with awake balls; in %d a ball lacks 0.01 of its weight, in %d 0.05, %.2f at most\n",
        heaps, awake, lack_a_hundredth, lack_a_twentieth, most);
    ASSERT_GT(heaps, 0);
    EXPECT_LE(awake, heaps / 8);
    EXPECT_LE(lack_a_twentieth, heaps / 4);
}

/// A world with the same balls, of which each reaches by half of that farther than it does, in radii.
std::unique_ptr<World> reaching(const World& world, Scene scene, double gap) {
    scene.balls.assign(world.balls().begin(), world.balls().end());
    for (Ball& ball : scene.balls) ball.radius *= 1 + gap / 2;
    return world_of("custom", scene);
}

// Rest is judged by speeds, and such a ball is about to move. A second support may be three thousandths of a
// radius away: so far may one that is hit move, and fall asleep again, without waking what lies on it.
TEST(RestedHeaps, HaveNoBallThatLiesOnTheSlopeOfAnotherAlone) {
    constexpr double sleep_distance = 3e-3;
    for (std::uint64_t seed = 1; seed <= (test::in_small ? 30 : 150); ++seed) {
        const Scene scene = rain_of(40, seed);
        const auto world = world_of("custom", scene);
        while (world->time() < 15) world->step(1.0 / 60);
        const auto near = reaching(*world, scene, sleep_distance);
        for (const Ball& ball : world->balls()) {
            if (!ball.asleep) continue;
            int contacts = 0;
            double lean = 0;
            for (const Contact& contact : near->contacts())
                if (contact.ball == ball.number || contact.other == Other::ball(ball.number))
                    ++contacts, lean = std::abs(contact.normal.x);
            if (contacts == 1) {
                EXPECT_LT(lean, 0.1) << "seed " << seed << ", ball " << ball.number;
            }
        }
    }
}

}  // namespace
}  // namespace flipside::lab
