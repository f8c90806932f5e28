// What is picked without a branch is what the standard algorithms pick with one.

#include "custom/sift.hpp"

#include <iterator>

#include <gtest/gtest.h>

#include "rapidcheck/gtest.h"

namespace flipside::custom::test {
namespace {

bool is_even(int i) {
    return i % 2 == 0;
}
bool is_low(int i) {
    return i < 10;
}
std::vector<int> any_numbers() {
    return *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 20));
}
std::vector<int> list_of(std::span<const int> items) {
    return {items.begin(), items.end()};
}

RC_GTEST_PROP(Sift, KeepsWhatPassesInOrder, ()) {
    const std::vector<int> items = any_numbers();
    std::vector<int> room = any_numbers(), expected, negated;
    std::ranges::copy_if(items, std::back_inserter(expected), is_even);
    RC_ASSERT(list_of(sift(items, room, is_even)) == expected);
    std::ranges::transform(expected, std::back_inserter(negated), std::negate{});
    RC_ASSERT(list_of(sift(items, room, is_even, Nothing{}, std::negate{})) == negated);
}

RC_GTEST_PROP(Sift, MaySiftAListIntoItself, ()) {
    std::vector<int> items = any_numbers(), expected;
    std::ranges::copy_if(items, std::back_inserter(expected), is_even);
    RC_ASSERT(list_of(sift(items, items, is_even)) == expected);
}

RC_GTEST_PROP(Sift, TellsApartWhatPassesOfAPart, ()) {
    const std::vector<int> items = any_numbers();
    const std::size_t last = *rc::gen::inRange<std::size_t>(0, items.size() + 1),
                      first = *rc::gen::inRange<std::size_t>(0, last + 1);
    std::vector<int> room = any_numbers(), other, low, high, passed, prepared;
    const std::span<const int> part = std::span(items).subspan(first, last - first);
    std::ranges::copy_if(part, std::back_inserter(passed), is_even);
    std::ranges::partition_copy(passed, std::back_inserter(low), std::back_inserter(high), is_low);
    const auto told_apart = sift_apart(items, first, last, room, other, is_even, is_low,
                                       [&](int item) { prepared.push_back(item); });
    RC_ASSERT(list_of(told_apart.first) == low);
    RC_ASSERT(list_of(told_apart.second) == high);
    RC_ASSERT(prepared.size() == part.size());
}

// More than one block of them.
RC_GTEST_PROP(Sift, VisitsAllThatPassInOrder, ()) {
    std::vector<int> items;
    for (int i = *rc::gen::inRange(0, 40); i > 0; --i)
        for (const int item : any_numbers()) items.push_back(item);
    std::vector<int> room, expected, visited;
    std::ranges::copy_if(items, std::back_inserter(expected), is_even);
    each_sifted(items, room, is_even, [&](std::span<const int> these) {
        visited.insert(visited.end(), these.begin(), these.end());
    });
    RC_ASSERT(visited == expected);
    std::vector<int> prepared;
    visited.clear();
    each_prepared(
        items, [&](int item) { prepared.push_back(item); },
        [&](int item) {
            RC_ASSERT(visited.size() < prepared.size());
            visited.push_back(item);
        });
    RC_ASSERT(visited == items);
    RC_ASSERT(prepared == items);
}

RC_GTEST_PROP(Sift, CountsThoseBefore, ()) {
    std::vector<int> items = any_numbers();
    std::ranges::sort(items);
    const int at = *rc::gen::inRange(-1, 21);
    const auto expected = std::ranges::lower_bound(items, at) - items.begin();
    RC_ASSERT(count_before(items, [&](int i) { return i < at; }) == static_cast<std::size_t>(expected));
}

}  // namespace
}  // namespace flipside::custom::test
