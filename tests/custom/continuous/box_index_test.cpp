#include <gtest/gtest.h>

#include "custom/continuous/neighbours.hpp"
#include "rapidcheck/gtest.h"

namespace flipside::custom {
namespace {

constexpr Box nowhere{{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};

double number() {
    return *rc::gen::inRange(-60, 61) * 0.125;
}

Box any_box() {
    const Vec2 corner{number(), number()};
    return {corner, corner + Vec2{*rc::gen::inRange(0, 30) * 0.125, *rc::gen::inRange(0, 30) * 0.125}};
}

std::vector<std::uint32_t> found_by(const BoxIndex& index, const Box& box) {
    std::vector<std::uint32_t> found;
    EXPECT_GT(index.find(box, found), found.size());
    return found;
}

std::vector<std::uint32_t> found_one_by_one(const BoxIndex& index, const Box& box) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < index.size(); ++i)
        if (overlap(box, index[i])) found.push_back(i);
    return found;
}

// Includes boxes outside the range, at its border, over all of it, and empty ones.
RC_GTEST_PROP(BoxIndex, AgreesWithBruteForce, ()) {
    std::vector<Box> boxes(*rc::gen::inRange<std::size_t>(1, 150));
    for (Box& box : boxes) box = *rc::gen::inRange(0, 9) == 0 ? nowhere : any_box();
    const BoxIndex index({{-4, -3}, {5, 4}}, boxes);
    for (int round = 0; round < 8; ++round) {
        const Box box = any_box();
        RC_ASSERT(found_by(index, box) == found_one_by_one(index, box));
    }
}

// Up to 150 boxes near each other, so that short and long lists take turns.
RC_GTEST_PROP(Candidates, ContainAllThatABoxOverlapsInOrder, ()) {
    std::vector<Box> boxes(*rc::gen::inRange<std::size_t>(1, 150));
    for (Box& box : boxes) box = any_box();
    const BoxIndex index({{-8, -8}, {8, 8}}, boxes);
    Candidates candidates;
    std::vector<std::uint32_t> buffer;
    std::uint64_t tests = 0;
    Box box = any_box();
    for (int round = 0; round < 12; ++round) {
        // A small move mostly stays in the fat AABB.
        const Vec2 by =
            *rc::gen::inRange(0, 3) == 0 ? Vec2{number(), number()} : 0.01 * Vec2{number(), number()};
        box = {box.min + by, box.max + by};
        const Vec2 velocity{number(), number()};
        std::vector<std::uint32_t> overlapped;
        for (const std::uint32_t i : candidates.near(box, velocity, index, buffer, tests))
            if (overlap(box, index[i])) overlapped.push_back(i);
        RC_ASSERT(overlapped == found_one_by_one(index, box));
    }
}

TEST(BoxIndex, AnEmptyIndexFindsNothing) {
    EXPECT_TRUE(found_by(BoxIndex({{0, 0}, {1, 1}}, {}), {{0, 0}, {1, 1}}).empty());
}

TEST(BoxIndex, HandlesAnEmptyRangeAndAnInfiniteBox) {
    const Box everywhere{{-INFINITY, -INFINITY}, {INFINITY, INFINITY}};
    const BoxIndex index({{1, 1}, {1, 1}}, {everywhere, nowhere, {{1, 1}, {2, 2}}});
    EXPECT_EQ(found_by(index, {{1.5, 1.5}, {1.6, 1.6}}), (std::vector<std::uint32_t>{0, 2}));
    EXPECT_EQ(found_by(index, {{5, 5}, {6, 6}}), std::vector<std::uint32_t>{0});
    EXPECT_EQ(found_by(index, everywhere), (std::vector<std::uint32_t>{0, 2}));
}

// A hundred times as many boxes in a hundred times the area: the number of tests per query stays the same, in
// the mean over places, since it depends on how the cells lie between the boxes.
TEST(BoxIndex, TheCostOfAQueryDoesNotDependOnDistantBoxes) {
    const auto tests_among = [](int in_a_row) {
        std::vector<Box> boxes;
        for (int i = 0; i < in_a_row * in_a_row; ++i) {
            const Vec2 corner{static_cast<double>(i % in_a_row), static_cast<double>(i / in_a_row)};
            boxes.push_back({corner, corner + Vec2{0.5, 0.5}});
        }
        const auto side = static_cast<double>(in_a_row);
        boxes.push_back({{0, 0}, {side, 0.1}});
        const BoxIndex index({{0, 0}, {side, side}}, boxes);
        std::vector<std::uint32_t> found;
        constexpr int places = 10;
        std::uint64_t tests = 0;
        for (int i = 0; i < places * places; ++i) {
            const Vec2 corner{2 + 0.3 * (i % places), 2 + 0.25 * (i / places)};
            tests += index.find({corner, corner + Vec2{1, 1}}, found);
        }
        return static_cast<double>(tests) / (places * places);
    };
    EXPECT_LE(tests_among(300), tests_among(30) + 2);
}

}  // namespace
}  // namespace flipside::custom
