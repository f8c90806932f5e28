// Every broad phase finds the pairs that brute force finds.

#include <algorithm>
#include <functional>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "custom/broad_phase/registry.hpp"
#include "custom/scenes.hpp"
#include "rapidcheck/gtest.h"

namespace flipside::custom {
namespace {

const Box world{{0, 0}, {16, 8}};

Proxy ball_at(Vec2 center, double radius) {
    return {bounds_of(center, radius), 1, ~0U, true};
}

using Make = std::function<std::unique_ptr<BroadPhase>(std::vector<Proxy>)>;

struct Kind {
    std::string name;
    Make make;
};

/// Every broad phase, at several settings each; brute force first.
std::vector<Kind> kinds() {
    std::vector<Kind> all{{"brute force", [](auto still) { return make_brute_force(std::move(still), {}); }},
                          {"sweep", [](auto still) { return make_sweep(std::move(still), {}); }}};
    for (const int levels : {1, 2, 3, 5, 8})
        all.push_back({"quadtree " + std::to_string(levels), [=](auto still) {
                           return make_quadtree(std::move(still),
                                                {.world = world, .quadtree_levels = levels});
                       }});
    for (const int capacity : {1, 4, 100})
        for (const int depth : {1, 6, 24})
            all.push_back(
                {"adaptive " + std::to_string(capacity) + ", " + std::to_string(depth), [=](auto still) {
                     return make_adaptive_quadtree(
                         std::move(still),
                         {.world = world, .adaptive_capacity = capacity, .adaptive_depth = depth});
                 }});
    for (const double cell : {0.0, 0.1, 0.5, 1.0, 3.0, 100.0})
        all.push_back({"grid " + std::to_string(cell), [=](const auto& still) {
                           return make_grid(still, {.world = world, .grid_cell = cell});
                       }});
    return all;
}

/// The pairs of a search, after checking that all broad phases agree.
std::vector<Pair> pairs_of(const std::vector<Proxy>& still, const std::vector<Proxy>& moving) {
    std::vector<Pair> expected, found;
    make_brute_force(still, {})->find_pairs(moving, expected);
    for (const Kind& kind : kinds()) {
        const auto broad = kind.make(still);
        for (int search = 0; search < 2; ++search) {  // the second must not depend on the first
            broad->find_pairs(moving, found);
            EXPECT_EQ(found, expected) << kind.name << ", search " << search;
        }
    }
    return expected;
}

double coordinate(int beyond) {
    // Multiples of a half lie on borders of cells.
    return *rc::gen::inRange(-beyond, 32 + beyond) * 0.5;
}
Proxy any_proxy(bool ball, int beyond) {
    const double x = coordinate(beyond), y = coordinate(beyond);
    const double w = *rc::gen::inRange(0, 6) * 0.5, h = *rc::gen::inRange(0, 6) * 0.5;
    Proxy proxy{{{x, y}, {x + w, y + h}}, 1, ~0U, ball};
    proxy.layer = 1U << *rc::gen::inRange(0, 3);
    proxy.collides_with = *rc::gen::inRange(0U, 8U);
    return proxy;
}

/// Moving parts and balls, up to `beyond` outside the world.
std::vector<Proxy> any_moving(int beyond) {
    std::vector<Proxy> moving;
    const int parts = *rc::gen::inRange(0, 5), balls = *rc::gen::inRange(0, 30);
    for (int i = 0; i < parts; ++i) moving.push_back(any_proxy(false, beyond));
    for (int i = 0; i < balls; ++i) moving.push_back(any_proxy(true, beyond));
    return moving;
}

// Several searches with different proxies: sizes of cells and orders change.
RC_GTEST_PROP(BroadPhase, AllFindWhatBruteForceFinds, ()) {
    const int beyond = *rc::gen::element(0, 20);
    std::vector<Proxy> still;
    const int parts = *rc::gen::inRange(0, 20);
    for (int i = 0; i < parts; ++i) still.push_back(any_proxy(false, beyond));
    std::vector<std::unique_ptr<BroadPhase>> all;
    for (const Kind& kind : kinds()) all.push_back(kind.make(still));
    for (int search = 0; search < 3; ++search) {
        const std::vector<Proxy> moving = any_moving(beyond);
        std::vector<Pair> expected, found;
        all.front()->find_pairs(moving, expected);
        RC_ASSERT(std::ranges::is_sorted(expected));
        for (const auto& broad : all) {
            broad->find_pairs(moving, found);
            RC_ASSERT(found == expected);
        }
    }
}

// Balls of similar size among a few huge boxes, and many balls at one position.
TEST(BroadPhase, ManyBallsAmongHugeBoxes) {
    std::vector<Proxy> still, moving;
    for (int i = 0; i < 8; ++i) still.push_back({{{2.0 * i, 0}, {2.0 * i, 8}}, 1, ~0U, false});
    moving.push_back({{{0, 0}, {16, 8}}, 1, ~0U, false});
    moving.push_back(ball_at({8, 4}, 5));
    std::mt19937 random(7);
    const auto number = [&](double limit) { return std::uniform_real_distribution(0.0, limit)(random); };
    for (int i = 0; i < 1000; ++i) moving.push_back(ball_at({number(16), number(8)}, 0.1));
    for (int i = 0; i < 50; ++i) moving.push_back(ball_at({3 + number(0.1), 3}, 0.1));
    EXPECT_GT(pairs_of(still, moving).size(), 2000U);
}

TEST(BroadPhase, AThousandBallsAtOnePoint) {
    const std::vector<Proxy> moving(1000, ball_at({3, 3}, 0.1));
    for (const Kind& kind : kinds()) {
        std::vector<Pair> pairs;
        kind.make({})->find_pairs(moving, pairs);
        EXPECT_EQ(pairs.size(), 499'500U) << kind.name;
        EXPECT_TRUE(std::ranges::is_sorted(pairs)) << kind.name;
    }
}

// 20,000 balls of one size, a tenth of the area covered.
TEST(BroadPhase, TestsOfManyBallsGrowWithTheirNumber) {
    const auto tests_per_ball = [](const Make& make, int side) {
        std::vector<Proxy> moving;
        std::mt19937 random(3);
        std::uniform_real_distribution<double> anywhere(0, 1);
        const double radius = std::sqrt(0.1 * 16 * 8 / (side * side * 3.14));
        for (int i = 0; i < side * side; ++i)
            moving.push_back(ball_at({16 * anywhere(random), 8 * anywhere(random)}, radius));
        std::vector<Pair> pairs;
        const auto broad = make({});
        broad->find_pairs(moving, pairs);
        return static_cast<double>(broad->tests()) / (side * side);
    };
    const Make grid = [](const auto& still) { return make_grid(still, {.world = world}); };
    const Make adaptive = [](auto still) {
        return make_adaptive_quadtree(std::move(still), {.world = world, .adaptive_depth = 12});
    };
    EXPECT_LT(tests_per_ball(grid, 141), 3);
    EXPECT_LT(tests_per_ball(grid, 141), 1.1 * tests_per_ball(grid, 30));
    EXPECT_LT(tests_per_ball(adaptive, 141), 40);
}

TEST(BroadPhase, EverythingInOneCell) {
    const std::vector<Proxy> moving(20, ball_at({0.01, 0.01}, 0.001));
    EXPECT_EQ(pairs_of({}, moving).size(), 190U);
}

TEST(BroadPhase, BallsOnBordersOfCells) {
    std::vector<Proxy> moving;
    for (int x = 0; x <= 16; ++x)
        for (int y = 0; y <= 8; ++y) moving.push_back(ball_at({double(x), double(y)}, 0.5));
    // Every ball touches its eight neighbours: 16·9 + 17·8 along the axes, 2·16·8 across.
    EXPECT_EQ(pairs_of({}, moving).size(), 16U * 9 + 17 * 8 + 2 * 16 * 8);
}

TEST(BroadPhase, OutsideTheWorldAndAtInfinity) {
    const double far = std::numeric_limits<double>::infinity();
    const std::vector<Proxy> moving{ball_at({-50, 3}, 1), ball_at({-51, 3}, 1), ball_at({1e300, -1e300}, 1),
                                    ball_at({far, 3}, 1), ball_at({-50, 99}, 1)};
    EXPECT_EQ(pairs_of({}, moving), (std::vector<Pair>{{0, 1}}));
}

TEST(BroadPhase, BoxesWithoutHeightOrSize) {
    const std::vector<Proxy> still{{{{0, 4}, {16, 4}}, 1, ~0U, false}, {{{3, 4}, {3, 4}}, 1, ~0U, false}};
    const std::vector<Proxy> moving{ball_at({3, 4}, 0), ball_at({3, 4}, 0), ball_at({5, 5}, 1)};
    EXPECT_EQ(pairs_of(still, moving), (std::vector<Pair>{{0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}, {0, 4}}));
}

TEST(BroadPhase, PairsOfPartsAndForeignLayersAreNotTested) {
    const Proxy still{{{0, 0}, {16, 8}}, 1, ~0U, false};
    Proxy other_layer = ball_at({3, 3}, 1);
    other_layer.collides_with = 2;
    for (const auto& [name, make] : kinds()) {
        std::vector<Pair> pairs;
        const auto parts = make({still, still});
        parts->find_pairs(std::vector<Proxy>(100, still), pairs);
        EXPECT_EQ(parts->tests(), 0U) << name;
        EXPECT_TRUE(pairs.empty()) << name;
        const auto layers = make({still});
        layers->find_pairs(std::vector<Proxy>{other_layer}, pairs);
        EXPECT_TRUE(pairs.empty()) << name;
        EXPECT_LE(layers->tests(), 1U) << name;  // at most the test that finds the cells of the ball
    }
}

TEST(BroadPhase, BruteForceTestsEveryPair) {
    std::vector<Pair> pairs;
    const auto brute = make_brute_force({}, {});
    std::vector<Proxy> moving;
    for (int i = 0; i < 32; ++i) moving.push_back(ball_at({0.5 * i, 1}, 0.1));
    brute->find_pairs(moving, pairs);
    EXPECT_EQ(brute->tests(), 496U);
}

TEST(BroadPhase, QuadtreeStatesItsShape) {
    const BroadPhaseFacts facts = make_quadtree({}, {.world = world})->facts();
    EXPECT_EQ(facts.nodes, 341);
    EXPECT_EQ(facts.leaves, 256);
    EXPECT_EQ(facts.leaf_width, 1);
    EXPECT_EQ(facts.leaf_height, 0.5);
}

TEST(BroadPhase, GridFitsItsCellsOrTakesThemAsSet) {
    const std::vector<Proxy> moving(1000, ball_at({3, 3}, 0.2));
    std::vector<Pair> pairs;
    const auto fitted = make_grid({}, {.world = world}),
               set = make_grid({}, {.world = world, .grid_cell = 0.5});
    fitted->find_pairs(moving, pairs);
    EXPECT_GT(fitted->facts().leaf_width, 0.4);
    EXPECT_LT(fitted->facts().leaf_width, 0.6);
    EXPECT_EQ(fitted->facts().most_in_leaf, 1000);
    EXPECT_EQ(set->facts().leaf_width, 0.5);
    EXPECT_EQ(set->facts().leaves, 32 * 16);
}

TEST(BroadPhase, AGridOfFewBallsHasFewCellsHoweverLargeTheWorld) {
    const Box large{{-1e4, -1e4}, {1e4, 1e4}};
    const std::vector<Proxy> moving{ball_at({3, 3}, 0.2), ball_at({3.1, 3}, 0.2), ball_at({-9e3, 5}, 0.2)};
    std::vector<Pair> pairs;
    const auto grid = make_grid({}, {.world = large});
    grid->find_pairs(moving, pairs);
    EXPECT_LE(grid->facts().leaves, 1 << 13);
    EXPECT_EQ(pairs, (std::vector<Pair>{{0, 1}}));
}

TEST(BroadPhase, AdaptiveQuadtreeSplitsWhereThingsCrowd) {
    std::vector<Proxy> moving;
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k) moving.push_back(ball_at({0.1 + 0.2 * i, 0.1 + 0.1 * k}, 0.04));
    const auto tree =
        make_adaptive_quadtree({}, {.world = world, .adaptive_capacity = 4, .adaptive_depth = 10});
    std::vector<Pair> pairs;
    tree->find_pairs(moving, pairs);
    // The lower left quarter is halved until 4 × 4 balls in 0.8 m × 0.4 m are separate: 8, 4, 2, 1, 0.5 m.
    EXPECT_EQ(tree->facts().levels, 5);
    EXPECT_EQ(tree->facts().nodes, 1 + 4 * 5);
    EXPECT_EQ(tree->facts().leaves, 1 + 3 * 5);
}

Scene scene_of(std::initializer_list<double> radii) {
    Scene scene = empty_scene();
    for (const double radius : radii) add_ball(scene, {}, {}, radius);
    return scene;
}

TEST(BroadPhase, RegistryNamesWhatItMakes) {
    for (const BroadPhaseKind& kind : broad_phases)
        EXPECT_EQ(kind.make({}, {.world = world})->facts().name, kind.title) << kind.name;
}

TEST(BroadPhase, AutomaticChoiceFollowsTheScene) {
    const auto chosen = [](std::initializer_list<double> radii, std::size_t still) {
        Settings settings(engine().settings);
        settings.set("broad_phase", "auto");
        return make_broad_phase(scene_of(radii), std::vector<Proxy>(still), settings)->facts().name;
    };
    EXPECT_EQ(chosen({}, 100), "brute force");
    EXPECT_EQ(chosen({1, 1}, 10), "brute force");
    EXPECT_EQ(chosen({1, 1}, 100), "grid");
    EXPECT_EQ(chosen({1, 100}, 100), "adaptive quadtree");
    const auto table = test::make_world(scene_of({1, 1}), {{"solver", "simple"}, {"broad_phase", "auto"}});
    table->step(0.01);
    EXPECT_EQ(table->statistics().broad_phase.name, "brute force");
}

}  // namespace
}  // namespace flipside::custom
