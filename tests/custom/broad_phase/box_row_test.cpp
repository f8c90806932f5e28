// A row of boxes finds what brute force finds, sorted or not.

#include "custom/broad_phase/box_row.hpp"

#include <gtest/gtest.h>

#include "rapidcheck/gtest.h"

namespace flipside::custom::test {
namespace {

Box any_box() {
    const double x = *rc::gen::inRange(0, 40) * 0.25, y = *rc::gen::inRange(0, 8) * 0.25;
    return bounds_of({x, y}, *rc::gen::inRange(1, 8) * 0.125);
}

RC_GTEST_PROP(BoxRow, FindsWhatOverlaps, ()) {
    BoxRow row;
    std::vector<Box> boxes;
    const int count = *rc::gen::inRange(0, 120);  // sorted from 33 on
    for (int i = 0; i < count; ++i) {
        boxes.push_back(any_box());
        row.add(static_cast<std::uint32_t>(i), boxes.back());
        if (i % 10 != 0) continue;
        const Box asked = any_box();
        std::vector<std::uint32_t> found, expected;
        const std::uint64_t tests = row.each_overlapping(asked, [&](auto name) { found.push_back(name); });
        for (std::uint32_t k = 0; k < boxes.size(); ++k)
            if (overlap(asked, boxes[k])) expected.push_back(k);
        std::ranges::sort(found);
        RC_ASSERT(found == expected);
        RC_ASSERT(found.size() <= tests && tests <= boxes.size());
    }
    row.clear();
    RC_ASSERT(row.each_overlapping(any_box(), [](auto) { RC_FAIL("found in an empty row"); }) == 0);
}

}  // namespace
}  // namespace flipside::custom::test
