#include <gtest/gtest.h>

#include "custom/continuous/neighbours.hpp"
#include "rapidcheck/gtest.h"

namespace flipside::custom {
namespace {

double number() {
    return *rc::gen::inRange(-60, 61) * 0.125;
}

Box any_box() {
    const Vec2 corner{number(), number()};
    return {corner, corner + Vec2{*rc::gen::inRange(0, 30) * 0.125, *rc::gen::inRange(0, 30) * 0.125}};
}

/// The boxes that overlap `box`, of those that the index lists near it, in that order.
std::vector<std::uint32_t> found_by(const BoxIndex& index, const Box& box) {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t i : index.near(box))
        if (overlap(box, index[i])) found.push_back(i);
    return found;
}

std::vector<std::uint32_t> found_one_by_one(const BoxIndex& index, const Box& box) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < index.size(); ++i)
        if (overlap(box, index[i])) found.push_back(i);
    return found;
}

// Includes boxes outside the range, at its border and over all of it; cells narrower and wider than the
// boxes, and boxes on the borders of cells.
RC_GTEST_PROP(BoxIndex, AgreesWithBruteForceInRisingOrder, ()) {
    std::vector<Box> boxes(*rc::gen::inRange<std::size_t>(1, 150));
    for (Box& box : boxes) box = any_box();
    const double width = 0.03125 * *rc::gen::inRange(1, 300);
    const BoxIndex index({{-4, -3}, {5, 4}}, width, boxes);
    for (int round = 0; round < 8; ++round) {
        const Box box = any_box();
        RC_ASSERT(found_by(index, box) == found_one_by_one(index, box));
    }
}

// Some thousand boxes in cells so narrow that the first levels are left out, at places of any digits.
RC_GTEST_PROP(BoxIndex, AgreesWhereNarrowLevelsAreLeftOut, ()) {
    const int seed = *rc::gen::inRange(0, 1000);
    const auto at = [&](int k) { return 3 * std::sin(1.0 + seed + 7.3 * k); };
    std::vector<Box> boxes;
    for (int k = 0; k < 2000; ++k) {
        const Vec2 corner{at(k), at(3 * k + 1)};
        boxes.push_back({corner, corner + Vec2{std::abs(at(k + 2)), std::abs(at(k + 5))}});
    }
    const BoxIndex index({{-3, -3}, {3, 3}}, 0.001, boxes);
    for (int k = 0; k < 20; ++k) {
        const Vec2 corner{at(11 * k), at(5 * k)};
        const Box box{corner, corner + 0.02 * Vec2{std::abs(at(k)), std::abs(at(k + 1))}};
        RC_ASSERT(found_by(index, box) == found_one_by_one(index, box));
    }
}

TEST(BoxIndex, AnEmptyIndexFindsNothing) {
    EXPECT_TRUE(found_by(BoxIndex({{0, 0}, {1, 1}}, 0.1, {}), {{0, 0}, {1, 1}}).empty());
}

TEST(BoxIndex, HandlesAnEmptyRangeAndAnInfiniteBox) {
    const Box everywhere{{-INFINITY, -INFINITY}, {INFINITY, INFINITY}};
    const BoxIndex index({{1, 1}, {1, 1}}, 0.1, {everywhere, {{1, 1}, {2, 2}}});
    EXPECT_EQ(found_by(index, {{1.5, 1.5}, {1.6, 1.6}}), (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(found_by(index, {{5, 5}, {6, 6}}), std::vector<std::uint32_t>{0});
    EXPECT_EQ(found_by(index, everywhere), (std::vector<std::uint32_t>{0, 1}));
}

// A hundred times as many boxes in a hundred times the area: a query reads as many, in the mean over places.
TEST(BoxIndex, TheCostOfAQueryDoesNotDependOnDistantBoxes) {
    const auto read_among = [](int in_a_row) {
        std::vector<Box> boxes;
        for (int i = 0; i < in_a_row * in_a_row; ++i) {
            const Vec2 corner{static_cast<double>(i % in_a_row), static_cast<double>(i / in_a_row)};
            boxes.push_back({corner, corner + Vec2{0.5, 0.5}});
        }
        const auto side = static_cast<double>(in_a_row);
        boxes.push_back({{0, 0}, {side, 0.1}});
        const BoxIndex index({{0, 0}, {side, side}}, 0.6, boxes);
        constexpr int places = 10;
        std::size_t read = 0;
        for (int i = 0; i < places * places; ++i) {
            const Vec2 corner{2 + 0.3 * (i % places), 2 + 0.25 * (i / places)};
            read += index.near({corner, corner + Vec2{1, 1}}).size();
        }
        return static_cast<double>(read) / (places * places);
    };
    EXPECT_LE(read_among(300), read_among(30));
    EXPECT_LE(read_among(300), 16);
}

}  // namespace
}  // namespace flipside::custom
