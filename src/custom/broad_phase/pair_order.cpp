#include "custom/broad_phase/pair_order.hpp"

#include <algorithm>
#include <numeric>

#include "custom/broad_phase/room.hpp"
#include "custom/sift.hpp"

namespace flipside::custom {

void PairOrder::start(Handle first, std::size_t moving) {
    first_ = first;
    count_ = 0;
    make_room(found_, moving, pairs_per_ball);
    found_.resize(found_.capacity());
    make_room(by_lower_, found_.capacity());
    make_room(end_of_lower_, first + moving);
    make_room(end_, moving);
    end_of_lower_.assign(first + moving, 0);
    end_.assign(moving, 0);
}

void PairOrder::finish(std::vector<Pair>& pairs) {
    const std::span<const Pair> found(found_.data(), count_);
    for (const Pair& pair : found) {
        ++end_of_lower_[pair.a];
        ++end_[pair.b - first_];
    }
    // Where each one's pairs begin; filling them in moves that to where they end.
    std::exclusive_scan(end_of_lower_.begin(), end_of_lower_.end(), end_of_lower_.begin(), 0U);
    std::exclusive_scan(end_.begin(), end_.end(), end_.begin(), 0U);
    by_lower_.resize(count_);
    for (const Pair& pair : found) by_lower_[end_of_lower_[pair.a]++] = pair;
    make_room(pairs, found_.capacity());
    pairs.resize(count_);
    for (const Pair& pair : by_lower_) pairs[end_[pair.b - first_]++] = pair;
}

namespace {

/// The first of pairs in order that is not before this one.
const Pair* find_place(std::span<const Pair> pairs, Pair pair) {
    const auto key = [](Pair p) { return std::uint64_t{p.b} << 32 | p.a; };
    return pairs.data() + count_before(pairs, [&](Pair p) { return key(p) < key(pair); });
}

}  // namespace

void add_pairs(std::vector<Pair>& fresh, std::vector<Pair>& listed) {
    std::ranges::sort(fresh);
    fresh.erase(std::unique(fresh.begin(), fresh.end()), fresh.end());
    std::erase_if(fresh, [&](Pair pair) {
        const Pair* const place = find_place(listed, pair);
        return place != listed.data() + listed.size() && *place == pair;
    });
    // Merged from the end, in place.
    std::size_t from = listed.size();
    listed.resize(from + fresh.size());
    Pair *const pairs = listed.data(), *to = pairs + listed.size();
    while (!fresh.empty()) {
        const auto place = static_cast<std::size_t>(find_place({pairs, from}, fresh.back()) - pairs);
        to = std::move_backward(pairs + place, pairs + from, to);
        *--to = fresh.back();
        fresh.pop_back();
        from = place;
    }
}

}  // namespace flipside::custom
