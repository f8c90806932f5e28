// Where things come to rest, and which contacts persist there, on every engine. A ball dropped into a wedge
// must lie where its two faces bear it, in touch with both in every step; one that lies on a floor must stay
// in touch; a heap in a box must lie low and still, without anything being pressed into anything. Each engine
// has its bound, in radii.

#include <array>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "in_small.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/engines/every_solver.hpp"
#include "lab/engines/touching.hpp"
#include "world/refusal.hpp"
#include "world/scene_builder.hpp"

namespace flipside {
namespace {

constexpr double frame = 1.0 / 60, gravity = 9.81;

struct RestBound {
    double place;    ///< from where the ball must lie, radii
    double overlap;  ///< at rest, radii
    int breaks;      ///< steps of sixty in which a contact may be missing
};

RestBound rest_bound(const Engine& engine, const Settings& settings) {
    // Box2D keeps up to three slops of skin about its polygons and lets surfaces sink in by one.
    if (engine.name == "box2d") return {0.07, 0.04, 0};
    // A loop without memory stops a ball that is slow: it may stay up to 2e-4 radii away from one of the
    // faces.
    if (engine.name == "custom" && settings.text("solver") == "simple") return {1e-3, 1e-5, 60};
    return {1e-6, 1e-9, 0};
}

struct HeapBound {
    double overlap;  ///< at any time, radii of the smaller balls
    double speed;    ///< m/s, after ten seconds
};

HeapBound heap_bound(const Engine& engine, const Settings& settings) {
    if (engine.name == "box2d") return {0.6, 0.01};
    if (engine.name == "custom" && settings.text("solver") == "simple") return {0.2, 0.4};
    return {0.03, 0};
}

double in_range(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Steps among the next sixty in which the contacts are not these.
int steps_without(World& world, const Pairs& expected) {
    int without = 0;
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        without += touching(world) == expected ? 0 : 1;
    }
    return without;
}

class ComingToRest : public testing::TestWithParam<std::pair<const Engine*, Settings>> {
  protected:
    const Engine& engine() const { return *GetParam().first; }
    const Settings& settings() const { return GetParam().second; }
    RestBound bound() const { return rest_bound(engine(), settings()); }
};

TEST_P(ComingToRest, InAWedgeABallLiesOnBothFaces) {
    std::mt19937_64 random(11);
    for (int i = 0; i < (test::in_small ? 4 : 20); ++i) {
        // Faces through the origin, rising to both sides by these angles.
        const double left = in_range(random, 0.4, 1.2), right = in_range(random, 0.4, 1.2);
        const double radius = in_range(random, 0.05, 0.2);
        Scene scene = empty_scene({0, -gravity});
        scene.rest_speed = 0.2;
        const Material dull{"", 0.4, 0.2, 0};
        add_part(scene, segment({}, {-3 * std::cos(left), 3 * std::sin(left)}), dull);
        add_part(scene, segment({}, {3 * std::cos(right), 3 * std::sin(right)}), dull);
        // The centre is a radius from both: on the line that halves the wedge.
        const Vec2 inwards_left{std::sin(left), std::cos(left)},
            inwards_right{-std::sin(right), std::cos(right)};
        const Vec2 middle = inwards_left + inwards_right;
        const Vec2 place = radius / dot(middle, inwards_left) * middle;
        add_ball(scene, place + Vec2{in_range(random, -0.3, 0.3), 1}, {}, radius);
        const auto world = engine().make(std::make_shared<const Scene>(scene), settings());
        for (int step = 0; step < 60 * 12; ++step) world->step(frame);
        ASSERT_EQ(world->balls().size(), 1U);
        EXPECT_LE(length(world->balls()[0].position - place), bound().place * radius)
            << engine().name << " wedge " << i << " of " << left << " and " << right;
        EXPECT_LE(deepest_overlap(world->contacts()), bound().overlap * radius) << engine().name << ' ' << i;
        EXPECT_LE(steps_without(*world, {{0, Other::part(0)}, {0, Other::part(1)}}), bound().breaks)
            << engine().name << ' ' << i;
    }
}

/// Of a ball on average, over the floor, m.
double mean_height(std::span<const Ball> balls) {
    double sum = 0;
    for (const Ball& ball : balls) sum += ball.position.y;
    return sum / static_cast<double>(balls.size());
}

// Balls of two sizes fall into a box, one after another. Which lies where is chaos; how high the heap is, is
// not.
TEST_P(ComingToRest, AHeapLiesLowAndStill) {
    Scene scene = empty_scene({0, -gravity});
    scene.rest_speed = 0.1;
    scene.materials[0] = {"", 0.5, 0.3, 0};
    const Material dull{"", 0.5, 0.3, 0};
    add_part(scene, {shape::Polyline{{{-0.5, 6}, {-0.5, 0}, {0.5, 0}, {0.5, 6}}, false}}, dull);
    double area = 0;
    for (int i = 0; i < 48; ++i) {
        const double radius = i % 3 == 0 ? 0.08 : 0.06;
        add_ball(scene, {-0.3 + 0.2 * (i % 4), 0.2 + 0.2 * (i / 4)}, {0.02 * (i % 5), 0}, radius);
        area += 3.14159265358979323846 * radius * radius;
    }
    const auto world = engine().make(std::make_shared<const Scene>(scene), settings());
    if (engine().name == "reference") {
        // It knows no exact outcome of moving balls in resting contact, and says so.
        EXPECT_THROW(std::ranges::for_each(std::array<int, 600>{}, [&](int) { world->step(frame); }),
                     Refusal);
        return;
    }
    double deepest = 0;
    for (int step = 0; step < 60 * 10; ++step) {
        world->step(frame);
        deepest = std::max(deepest, deepest_overlap(world->contacts()));
    }
    ASSERT_EQ(world->balls().size(), 48U);
    double fastest = 0;
    for (const Ball& ball : world->balls()) fastest = std::max(fastest, length(ball.velocity));
    const HeapBound limit = heap_bound(engine(), settings());
    // Discs of two sizes in a heap take up between 0.78 of the plane (loose) and 0.91 (the densest there is).
    EXPECT_GE(2 * mean_height(world->balls()), area / 0.91);
    EXPECT_LE(2 * mean_height(world->balls()), area / 0.70);
    EXPECT_LE(deepest, limit.overlap * 0.06);
    EXPECT_LE(fastest, limit.speed);
}

std::string name_of_solver(const testing::TestParamInfo<std::pair<const Engine*, Settings>>& test) {
    const auto& [engine, settings] = test.param;
    const auto solver = std::ranges::find(engine->settings, "solver", &SettingSpec::name);
    return std::string(engine->name) +
           (solver == engine->settings.end() ? "" : "_" + settings.text("solver"));
}

INSTANTIATE_TEST_SUITE_P(Engines, ComingToRest, testing::ValuesIn(lab::every_solver()), name_of_solver);

}  // namespace
}  // namespace flipside
