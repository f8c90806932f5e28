// Contact forces of heaps whose forces are known on paper, and heaps that have none.

#include "reference/equilibrium.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace flipside::reference {
namespace {

constexpr double weight = 9.81;

Support on_floor(std::uint32_t disc, double friction = 0) {
    return {disc, Support::fixed, {0, 1}, friction};
}
/// `disc` lies on `other`, to its right by this angle from above.
Support leans_on(std::uint32_t disc, std::uint32_t other, double angle, double friction) {
    return {disc, other, {std::sin(angle), std::cos(angle)}, friction};
}

TEST(Equilibrium, AColumnCarriesWhatLiesAboveEach) {
    std::vector<Vec2> weights;
    std::vector<Support> supports{on_floor(0)};
    for (std::uint32_t i = 0; i < 10; ++i) {
        weights.push_back({0, -weight * (i % 2 == 0 ? 1 : 1000)});  // heavy on light
        if (i > 0) supports.push_back(leans_on(i, i - 1, 0, 0));
    }
    EXPECT_LE(find_equilibrium(weights, supports).share, balance_tolerance);
    for (std::uint32_t i = 0; i < 10; ++i) {
        double above = 0;
        for (std::uint32_t k = i; k < 10; ++k) above -= weights[k].y;
        EXPECT_NEAR(supports[i].normal_force, above, 1e-12 * above);
        EXPECT_EQ(supports[i].friction_force, 0);
    }
}

/// Two discs on a floor and a third on both, each line of centres this far from the vertical.
std::vector<Support> pyramid(double angle, double friction) {
    return {on_floor(0, friction), on_floor(1, friction), leans_on(2, 0, angle, friction),
            leans_on(2, 1, -angle, friction)};
}

TEST(Equilibrium, APyramidStandsFromFrictionOfHalfTheAngleOn) {
    // The lower disc turns about where it touches the floor, so the force of the upper one goes through that
    // point: half the angle of the line of centres from it.
    const std::vector<Vec2> weights(3, {0, -weight});
    for (const double angle : {0.3, std::numbers::pi / 6, 0.8}) {
        const double least = std::tan(angle / 2);
        auto enough = pyramid(angle, least * (1 + 1e-9));
        EXPECT_LE(find_equilibrium(weights, enough).share, balance_tolerance);
        EXPECT_NEAR(enough[0].normal_force, 1.5 * weight, 1e-9);
        EXPECT_NEAR(enough[2].friction_force, least * enough[2].normal_force, 1e-7);
        auto less = pyramid(angle, least * (1 - 1e-3));
        EXPECT_GT(find_equilibrium(weights, less).share, 1e-5);
    }
}

TEST(Equilibrium, SaysWhichDiscHasNoSupport) {
    const std::vector<Vec2> weights(3, {0, -weight});
    std::vector<Support> supports{on_floor(0), on_floor(1)};
    const Imbalance left = find_equilibrium(weights, supports);
    EXPECT_EQ(left.disc, 2U);
    EXPECT_EQ(left.share, 1);
}

TEST(Equilibrium, OfAnIndeterminateHeapAnyForcesDo) {
    // A disc in a slot between walls, with friction: walls may press as hard as they like.
    const std::vector<Vec2> weights(2, {0, -weight});
    std::vector<Support> supports{on_floor(0, 1), leans_on(1, 0, 0, 1)};
    for (std::uint32_t i = 0; i < 2; ++i)
        for (const double side : {1.0, -1.0}) supports.push_back({i, Support::fixed, {side, 0}, 1});
    EXPECT_LE(find_equilibrium(weights, supports).share, balance_tolerance);
}

/// What is left of the weights, recomputed from the forces.
double left_over(const std::vector<Vec2>& weights, const std::vector<Support>& supports) {
    std::vector<Vec2> force = weights;
    std::vector<double> torque(weights.size());
    for (const Support& one : supports) {
        const Vec2 push = one.normal_force * one.normal + one.friction_force * perp(one.normal);
        force[one.disc] += push;
        torque[one.disc] += one.friction_force;
        if (one.other == Support::fixed) continue;
        force[one.other] -= push;
        torque[one.other] += one.friction_force;
    }
    double worst = 0;
    for (std::size_t i = 0; i < weights.size(); ++i)
        worst = std::max(
            {worst, length(force[i]) / length(weights[i]), std::abs(torque[i]) / length(weights[i])});
    return worst;
}

struct Heap {
    std::vector<Vec2> weights;
    std::vector<Support> supports;
};

/// A heap that has an equilibrium, since its weights are made from forces. draw(a, b) is from a to b - 1.
Heap heap_in_equilibrium(const std::function<int(int, int)>& draw) {
    const int count = draw(2, 25);
    Heap heap{std::vector<Vec2>(static_cast<std::size_t>(count)), {}};
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 3; ++k) {
            const double angle = draw(0, 6283) / 1e3;
            const double friction = draw(0, 3) / 2.0;
            const auto disc = static_cast<std::uint32_t>(i),
                       other = static_cast<std::uint32_t>(draw(0, i + 1));
            const Vec2 push = draw(1, 4) * from_angle(angle);
            heap.supports.push_back(
                {disc, other == disc ? Support::fixed : other, from_angle(angle), friction});
            heap.weights[disc] -= push;
            if (other != disc) heap.weights[other] += push;
        }
    return heap;
}

/// The forces of the heap are found again, or others that do as well; else says what is wrong with them.
std::string fault_of_forces(Heap heap) {
    const Imbalance left = find_equilibrium(heap.weights, heap.supports);
    if (!(left.share <= balance_tolerance)) return "lacks " + std::to_string(left.share) + " of a weight";
    if (!(left_over(heap.weights, heap.supports) <= 2 * balance_tolerance))
        return "claims more than it holds";
    for (const Support& one : heap.supports) {
        if (!(one.normal_force >= 0)) return "pulls";
        if (!(std::abs(one.friction_force) <= one.friction * one.normal_force * (1 + 1e-15)))
            return "rubs too much";
    }
    return "";
}

RC_GTEST_PROP(Equilibrium, IsFoundWhereThereIsOne, ()) {
    const Heap heap = heap_in_equilibrium([](int from, int to) { return *rc::gen::inRange(from, to); });
    for (const Vec2& one : heap.weights) RC_PRE(length(one) > 1e-3);
    RC_ASSERT(fault_of_forces(heap) == "");
}

// In these a force became so small that it was rounded to none, and then all forces to no number.
TEST(Equilibrium, IsFoundWhereAForceIsAllButZero) {
    for (const unsigned seed : {3592U, 5710U, 43483U}) {
        std::mt19937_64 random(seed);
        const auto draw = [&](int from, int to) {
            return from + static_cast<int>(random() % static_cast<unsigned>(to - from));
        };
        EXPECT_EQ(fault_of_forces(heap_in_equilibrium(draw)), "");
    }
}

}  // namespace
}  // namespace flipside::reference
