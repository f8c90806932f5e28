#include "custom/continuous/next_events.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace flipside::custom::test {
namespace {

RC_GTEST_PROP(EventQueue, TheFirstIsTheEarliestAfterAnyChanges, ()) {
    const auto balls = *rc::gen::inRange<std::size_t>(1, 40);
    EventQueue events;
    events.reset(balls);
    std::vector<std::pair<double, std::uint64_t>> known(balls, {INFINITY, 0});
    for (int change = 0; change < 200; ++change) {
        const auto i = *rc::gen::inRange<std::size_t>(0, balls);
        // Few different times, so that many are equal; no two events have the same order.
        const double time = *rc::gen::element(0.0, 1.0, 2.0, static_cast<double>(INFINITY));
        const auto order = std::uint64_t{i} + 100 * *rc::gen::inRange<std::uint64_t>(0, 3);
        events.set(static_cast<BallIndex>(i), time, order);
        known[i] = {time, order};
        const auto least = std::ranges::min_element(known);
        RC_ASSERT(events.time() == least->first);
        if (least->first < INFINITY) RC_ASSERT(known[events.first()] == *least);
    }
}

RC_GTEST_PROP(EventQueue, WhoeverComesFirstWasSaidToComeSoon, ()) {
    const auto balls = *rc::gen::inRange<BallIndex>(17, 200);
    EventQueue events;
    events.reset(balls);
    std::set<BallIndex> said;
    for (BallIndex change = 0; change < 400; ++change) {
        const auto i = change < balls ? change : events.first();
        events.set(i, change * 1e-3 + *rc::gen::inRange(1, 100), i);
        said.insert(events.soon());
        RC_ASSERT(said.contains(events.first()));
        if (change >= balls) said.erase(i);
        said.insert(events.soon());
    }
}

TEST(EventQueue, AreEmptyAtFirst) {
    EventQueue events;
    for (const std::size_t balls : {0U, 1U, 2U, 3U, 64U}) {
        events.reset(balls);
        EXPECT_EQ(events.time(), INFINITY);
    }
}

}  // namespace
}  // namespace flipside::custom::test
