// Every broad phase finds the pairs that brute force finds.

#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "custom/broad_phase.hpp"
#include "rapidcheck/gtest.h"

namespace flipside::custom {
namespace {

const Box world{{0, 0}, {16, 8}};

Proxy ball_at(Vec2 center, double radius, bool active = true) {
    return {bounds_of(center, radius), 1, ~0U, true, active};
}

/// The pairs of a search, after checking them against brute force at every number of levels.
std::vector<Pair> pairs_of(const std::vector<Proxy>& still, const std::vector<Proxy>& moving) {
    std::vector<Pair> expected, found;
    make_brute_force(still)->find_pairs(moving, expected);
    for (int levels = 1; levels <= 8; ++levels) {
        const auto tree = make_quadtree(still, world, levels);
        for (int search = 0; search < 2; ++search) {  // nothing may be left over from the first
            tree->find_pairs(moving, found);
            EXPECT_EQ(found, expected) << levels << " levels, search " << search;
        }
    }
    return expected;
}

double coordinate(int beyond) {
    // Halves fall on borders of cells.
    return *rc::gen::inRange(-beyond, 32 + beyond) * 0.5;
}
Proxy any_proxy(bool ball, int beyond) {
    const double x = coordinate(beyond), y = coordinate(beyond);
    const double w = *rc::gen::inRange(0, 6) * 0.5, h = *rc::gen::inRange(0, 6) * 0.5;
    Proxy proxy{{{x, y}, {x + w, y + h}}, 1, ~0U, ball, *rc::gen::inRange(0, 3) > 0};
    proxy.layer = 1U << *rc::gen::inRange(0, 3);
    proxy.collides_with = *rc::gen::inRange(0U, 8U);
    return proxy;
}

RC_GTEST_PROP(BroadPhase, QuadtreeFindsWhatBruteForceFinds, ()) {
    const int beyond = *rc::gen::element(0, 20);
    std::vector<Proxy> still, moving;
    const int parts = *rc::gen::inRange(0, 20), balls = *rc::gen::inRange(0, 30);
    for (int i = 0; i < parts; ++i) {
        still.push_back(any_proxy(false, beyond));
        still.back().active = false;
    }
    for (int i = 0; i < parts / 4; ++i) moving.push_back(any_proxy(false, beyond));
    for (int i = 0; i < balls; ++i) moving.push_back(any_proxy(true, beyond));
    std::vector<Pair> expected, found;
    make_brute_force(still)->find_pairs(moving, expected);
    RC_ASSERT(std::ranges::is_sorted(expected));
    const auto tree = make_quadtree(still, world, *rc::gen::inRange(1, 6));
    tree->find_pairs(moving, found);
    RC_ASSERT(found == expected);
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
    const std::vector<Proxy> still{{{{0, 4}, {16, 4}}, 1, ~0U, false, false},
                                   {{{3, 4}, {3, 4}}, 1, ~0U, false, false}};
    const std::vector<Proxy> moving{ball_at({3, 4}, 0), ball_at({3, 4}, 0), ball_at({5, 5}, 1)};
    EXPECT_EQ(pairs_of(still, moving), (std::vector<Pair>{{0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}, {0, 4}}));
}

TEST(BroadPhase, StillPairsSleepersAndForeignLayersAreNotTested) {
    const Proxy still{{{0, 0}, {16, 8}}, 1, ~0U, false, false};
    Proxy other_layer = ball_at({3, 3}, 1);
    other_layer.collides_with = 2;
    for (const auto& make :
         {std::function([](std::vector<Proxy> s) { return make_brute_force(std::move(s)); }),
          std::function([](std::vector<Proxy> s) { return make_quadtree(std::move(s), world, 3); })}) {
        std::vector<Pair> pairs;
        const auto asleep = make({still, still});
        asleep->find_pairs(std::vector<Proxy>(100, ball_at({3, 3}, 1, false)), pairs);
        EXPECT_EQ(asleep->tests(), 0U);
        EXPECT_TRUE(pairs.empty());
        const auto layers = make({still});
        layers->find_pairs(std::vector<Proxy>{other_layer}, pairs);
        EXPECT_TRUE(pairs.empty());
        EXPECT_LE(layers->tests(), 1U);  // at most the place of the ball in the tree
    }
}

TEST(BroadPhase, BruteForceTestsEveryPair) {
    std::vector<Pair> pairs;
    const auto brute = make_brute_force({});
    std::vector<Proxy> moving;
    for (int i = 0; i < 32; ++i) moving.push_back(ball_at({0.5 * i, 1}, 0.1));
    brute->find_pairs(moving, pairs);
    EXPECT_EQ(brute->tests(), 496U);
}

TEST(BroadPhase, QuadtreeStatesItsShape) {
    const BroadPhaseFacts facts = make_quadtree({}, world, 4)->facts();
    EXPECT_EQ(facts.nodes, 341);
    EXPECT_EQ(facts.leaves, 256);
    EXPECT_EQ(facts.leaf_width, 1);
    EXPECT_EQ(facts.leaf_height, 0.5);
}

}  // namespace
}  // namespace flipside::custom
