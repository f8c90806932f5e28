// The hierarchical grid finds the boxes that a test of every box finds.

#include "custom/broad_phase/hierarchical_grid.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "rapidcheck/gtest.h"

namespace flipside::custom {
namespace {

using Index = HierarchicalGrid::Index;

/// A box with its corners on a grid of numbers that are exact, some of them far out: many share borders.
Box any_placed_box() {
    const double unit = std::ldexp(1, *rc::gen::inRange(-12, 6));
    const double far = *rc::gen::element(0.0, 0.0, 0.0, 4096.0, -1048576.0);
    const auto number = [&](int from, int to) { return unit * *rc::gen::inRange(from, to); };
    const Vec2 low{far + number(-20, 20), number(-20, 20)};
    return {low, low + Vec2{number(0, 9), number(0, 9)}};
}

std::vector<Index> found_by_testing_all(const std::vector<Box>& boxes, const Box& box) {
    std::vector<Index> found;
    for (Index i = 0; i < boxes.size(); ++i)
        if (overlap(box, boxes[i])) found.push_back(i);
    return found;
}

RC_GTEST_PROP(HierarchicalGrid, FindsWhatOverlaps, ()) {
    std::vector<Box> boxes(*rc::gen::element(3U, 17U, 100U));
    HierarchicalGrid grid;
    grid.reset(boxes.size());
    for (Index i = 0; i < boxes.size(); ++i) grid.place(i, boxes[i] = any_placed_box());
    std::vector<Index> found;
    for (int move = 0; move < 50; ++move) {
        const auto i = static_cast<Index>(*rc::gen::inRange<std::size_t>(0, boxes.size()));
        grid.place(i, boxes[i] = any_placed_box());
        const Box box = *rc::gen::arbitrary<bool>() ? any_placed_box() : boxes[i];
        const std::vector<Index> expected = found_by_testing_all(boxes, box);
        RC_ASSERT(grid.find(box, found) <= boxes.size());
        RC_ASSERT(found == expected);
        const bool others = std::ranges::any_of(expected, [&](Index j) { return j != i; });
        RC_ASSERT(grid.any(box, i) == others);
    }
    boxes.resize(boxes.size() / 2);
    grid.shrink(boxes.size());
    RC_ASSERT(grid.size() == boxes.size());
    const Box box = any_placed_box();
    static_cast<void>(grid.find(box, found));
    RC_ASSERT(found == found_by_testing_all(boxes, box));
}

TEST(HierarchicalGrid, ABoxThatIsNotPlacedOverlapsNothing) {
    for (const std::size_t count : {5U, 50U}) {
        HierarchicalGrid grid;
        grid.reset(count);
        grid.place(2, {{0, 0}, {1, 1}});
        EXPECT_FALSE(grid.any({{-1e9, -1e9}, {1e9, 1e9}}, 2));
        EXPECT_TRUE(grid.any({{1, 1}, {2, 2}}, 0));
    }
}

TEST(HierarchicalGrid, TestsAreAsManyAsNeighboursWhateverTheNumberOfBoxes) {
    // Discs a tenth apart fill a square: of the same size, and every hundredth of them a hundred times
    // larger.
    for (const double larger : {1.0, 100.0})
        for (const int side : {30, 100}) {
            HierarchicalGrid grid;
            grid.reset(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
            for (int i = 0; i < side * side; ++i)
                grid.place(static_cast<Index>(i),
                           bounds_of({1.1 * (i % side), 1.1 * static_cast<int>(i / side)},
                                     i % 100 == 7 ? 0.5 * larger : 0.5));
            std::vector<Index> found;
            const std::uint64_t tests = grid.find(bounds_of({5, 5}, 0.5), found);
            // Nine cells of up to twice the size of a box, and all that are a hundred times larger.
            const unsigned near = 36, large = larger == 1 ? 0 : static_cast<unsigned>(side * side / 100);
            EXPECT_LE(tests, near + large) << side;
        }
}

}  // namespace
}  // namespace flipside::custom
