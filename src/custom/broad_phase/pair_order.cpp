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

std::uint64_t key(Pair pair) {
    return std::uint64_t{pair.b} << 32 | pair.a;
}

/// How many of `pairs`, in order, come before this one, which is not before the first `known` of them and
/// likely soon after: sought in strides that double (Bentley, Yao 1976, "An almost optimal algorithm for
/// unbounded searching"), then by halves.
std::size_t place_after(std::size_t known, std::span<const Pair> pairs, Pair pair) {
    const auto is_before = [&](Pair p) { return key(p) < key(pair); };
    std::size_t stride = 8;
    while (known + stride < pairs.size() && is_before(pairs[known + stride])) {
        known += stride;
        stride *= 2;
    }
    return known + count_before(pairs.subspan(known, std::min(stride, pairs.size() - known)), is_before);
}

}  // namespace

void add_pairs(std::vector<Pair>& fresh, std::vector<Pair>& listed, std::vector<std::size_t>& places) {
    std::ranges::sort(fresh);
    fresh.erase(std::unique(fresh.begin(), fresh.end()), fresh.end());
    std::size_t place = 0;
    places.clear();
    std::erase_if(fresh, [&](Pair pair) {
        place = place_after(place, listed, pair);
        const bool known = place < listed.size() && listed[place] == pair;
        if (!known) places.push_back(place);
        return known;
    });
    // Merged from the end, in place.
    std::size_t from = listed.size();
    listed.resize(from + fresh.size());
    Pair *const pairs = listed.data(), *to = pairs + listed.size();
    for (std::size_t i = fresh.size(); i-- > 0; from = places[i]) {
        to = std::move_backward(pairs + places[i], pairs + from, to);
        *--to = fresh[i];
    }
}

}  // namespace flipside::custom
