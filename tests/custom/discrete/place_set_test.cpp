#include "custom/discrete/place_set.hpp"

#include <set>

#include <gtest/gtest.h>

#include "rapidcheck/gtest.h"

namespace flipside::custom::test {
namespace {

RC_GTEST_PROP(PlaceSet, ListsWhatCameOnceAndInOrder, ()) {
    const auto places = *rc::gen::inRange<std::uint32_t>(1, 300);
    PlaceSet set;
    std::vector<std::uint32_t> listed{7};
    for (int time = 0; time < 2; ++time) {  // nothing of the first stays
        const auto added = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange(0U, places));
        set.start(places);
        for (const std::uint32_t place : added) set.add(place);
        set.list(listed);
        const std::set<std::uint32_t> expected(added.begin(), added.end());
        RC_ASSERT(std::ranges::equal(listed, expected));
    }
}

}  // namespace
}  // namespace flipside::custom::test
