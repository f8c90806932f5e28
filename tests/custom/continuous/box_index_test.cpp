#include "custom/continuous/box_index.hpp"

#include <gtest/gtest.h>

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

// Whatever lies outside the range, touches a border, is moved or taken away.
RC_GTEST_PROP(BoxIndex, FindsWhatTestingEachFinds, ()) {
    const auto count = *rc::gen::inRange<std::size_t>(1, 150);
    BoxIndex index({{-4, -3}, {5, 4}}, count);
    for (std::size_t i = 0; i < count; ++i) index.set(i, any_box());
    for (int round = 0; round < 8; ++round) {
        const auto moved = *rc::gen::inRange<std::size_t>(0, count);
        index.set(moved, *rc::gen::inRange(0, 3) == 0 ? BoxIndex::nowhere : any_box());
        const Box box = any_box();
        RC_ASSERT(found_by(index, box) == found_one_by_one(index, box));
    }
}

TEST(BoxIndex, OfNothingFindsNothing) {
    EXPECT_TRUE(found_by(BoxIndex({{0, 0}, {1, 1}}, 0), {{0, 0}, {1, 1}}).empty());
}

TEST(BoxIndex, ARangeWithoutSizeAndABoxWithoutEndAreNoMatter) {
    BoxIndex index({{1, 1}, {1, 1}}, 3);
    const Box everywhere{{-INFINITY, -INFINITY}, {INFINITY, INFINITY}};
    index.set(0, everywhere);
    index.set(2, {{1, 1}, {2, 2}});
    EXPECT_EQ(found_by(index, {{1.5, 1.5}, {1.6, 1.6}}), (std::vector<std::uint32_t>{0, 2}));
    EXPECT_EQ(found_by(index, {{5, 5}, {6, 6}}), std::vector<std::uint32_t>{0});
    EXPECT_EQ(found_by(index, everywhere), (std::vector<std::uint32_t>{0, 2}));
}

}  // namespace
}  // namespace flipside::custom
