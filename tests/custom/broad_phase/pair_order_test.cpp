// Pairs come out in order, each once, however they came in.

#include "custom/broad_phase/pair_order.hpp"

#include <gtest/gtest.h>

#include "rapidcheck/gtest.h"

namespace flipside::custom::test {
namespace {

std::vector<Pair> any_pairs(int most, Handle most_handle) {
    std::vector<Pair> pairs;
    for (int i = *rc::gen::inRange(0, most); i > 0; --i) {
        const Handle b = *rc::gen::inRange<Handle>(1, most_handle);
        pairs.push_back({*rc::gen::inRange<Handle>(0, b), b});
    }
    return pairs;
}

RC_GTEST_PROP(PairOrder, AddsToThoseListed, ()) {
    // Few handles: many pairs come twice. Many: those to be added lie far apart.
    const auto handles = *rc::gen::element<Handle>(12, 100);
    std::vector<Pair> listed = any_pairs(300, handles), fresh = any_pairs(20, handles), expected = listed;
    std::ranges::sort(listed);
    listed.erase(std::unique(listed.begin(), listed.end()), listed.end());
    expected.insert(expected.end(), fresh.begin(), fresh.end());
    std::ranges::sort(expected);
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    std::vector<std::size_t> scratch;
    add_pairs(fresh, listed, scratch);
    RC_ASSERT(listed == expected);
}

}  // namespace
}  // namespace flipside::custom::test
