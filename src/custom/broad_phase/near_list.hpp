#pragma once
/// Pairs that can meet soon, sought with room to spare so that one search of the broad phase serves many
/// flights (Verlet 1967, "Computer experiments on classical fluids"). What leaves its room is sought for
/// alone. What it answers is what the broad phase itself would: the room changes the cost, never the
/// outcome.

#include <cstdint>

#include "custom/broad_phase/box_row.hpp"
#include "custom/broad_phase/broad_phase.hpp"
#include "custom/broad_phase/room.hpp"
#include "custom/sift.hpp"

namespace flipside::custom {

class NearList {
  public:
    /// Keeps a reference to the still proxies.
    explicit NearList(const std::vector<Proxy>& still) : still_(still) {}

    /// Every pair whose boxes overlap now and that may meet, those that BroadPhase::find_pairs() finds and in
    /// its order; good until the next search. A proxy i that has left the room that it had, or is
    /// active and was not then, gets the room `roomy(i)`, which must hold its box of now, and its partners
    /// are sought; where many did, all are.
    /// Cost: one box test per listed pair, and the searches.
    std::span<const Pair> find_pairs(std::span<const Proxy> moving, BroadPhase& broad, auto&& roomy) {
        Check check = begin(moving.size());
        for (const Proxy& proxy : moving) check(proxy);
        search_as_needed(check, moving, broad, roomy);
        return sift(moving);
    }

    /// Notes who has left its room: called for every moving proxy in turn.
    class Check {
      public:
        void operator()(const Proxy& now) {
            const Proxy& room = *next_++;
            const bool same = (room.ball == now.ball) & (room.layer == now.layer) &
                              (room.collides_with == now.collides_with);
            all_same_ &= same;
            leavers_[left_] = looked_at_++;
            left_ +=
                static_cast<std::size_t>(!(same & holds(room.box, now.box) & (room.active >= now.active)));
        }

      private:
        friend NearList;
        Check(const Proxy* rooms, std::uint32_t* leavers) : next_(rooms), leavers_(leavers) {}
        const Proxy* next_;
        std::uint32_t* leavers_;
        std::size_t left_ = 0;
        std::uint32_t looked_at_ = 0;
        bool all_same_ = true;
    };

    /// The same in parts, for those who have each proxy at hand anyway: begin, check every moving proxy,
    /// search, sift.
    [[nodiscard]] Check begin(std::size_t moving);
    void search_as_needed(const Check& checked, std::span<const Proxy> moving, BroadPhase& broad,
                          auto&& roomy) {
        const std::span<const std::uint32_t> leavers(leavers_.data(), checked.left_);
        can_mend_ &= checked.all_same_;
        const bool anew = !can_mend_ || strays_.size() + leavers.size() > most_strays(moving.size());
        if (&broad != searched_ || (!leavers.empty() && anew)) {
            for (std::uint32_t i = 0; i < moving.size(); ++i) give_room(i, moving[i], roomy(i));
            search(broad);
        } else if (!leavers.empty()) {
            for (const std::uint32_t i : leavers) give_room(i, moving[i], roomy(i));
            mend(leavers, broad);
        }
    }
    [[nodiscard]] std::span<const Pair> sift(std::span<const Proxy> moving) {
        Sieve sieve(still_, moving);
        const auto hits = custom::sift(
            listed_, hits_, [&](Pair pair) { return sieve.passes(pair); },
            [&](Pair pair) { sieve.fetch(pair); });
        tests_ += sieve.tests;
        return hits;
    }
    /// The same, a block at a time: visits those with handles below `first_ball`, and those between balls.
    void each_sifted_apart(std::span<const Proxy> moving, Handle first_ball, auto&& visit) {
        Sieve sieve(still_, moving);
        for (std::size_t first = 0; first < listed_.size(); first += sift_block) {
            const auto [with_parts, of_balls] = sift_apart(
                listed_, first, std::min(first + sift_block, listed_.size()), hits_, ball_hits_,
                [&](Pair pair) { return sieve.passes(pair); }, [&](Pair pair) { return pair.a < first_ball; },
                [&](Pair pair) { sieve.fetch(pair); });
            visit(with_parts, of_balls);
        }
        tests_ += sieve.tests;
    }

    /// Adds to `found` every proxy whose room overlaps the box, and maybe others; some may come twice. Only
    /// while any proxy that find_pairs() was last given is active.
    void find_around(const SingleBox& box, BroadPhase& broad, std::vector<Handle>& found);

    /// Makes room for so many moving proxies, of which so many are balls.
    void reserve(std::size_t moving, std::size_t balls);

    /// Box tests by sifting and mending since the start.
    [[nodiscard]] std::uint64_t tests() const { return tests_; }

  private:
    /// Past these a search costs less than to seek for each alone.
    [[nodiscard]] static std::size_t most_strays(std::size_t moving) { return moving / 8; }
    void give_room(std::size_t i, const Proxy& now, const SingleBox& room) {
        rooms_[i] = now;
        rooms_[i].box = room;
    }
    void search(BroadPhase& broad);
    void mend(std::span<const std::uint32_t> leavers, BroadPhase& broad);

    /// Which of the pairs listed overlap.
    struct Sieve {
        const Proxy* kinds[2];
        Handle begins[2];
        std::uint64_t tests = 0;

        Sieve(const std::vector<Proxy>& still, std::span<const Proxy> moving)
            : kinds{still.data(), moving.data()}, begins{0, static_cast<Handle>(still.size())} {}
        [[nodiscard]] const Proxy& first_of(Pair pair) const {
            const auto kind = static_cast<std::size_t>(pair.a >= begins[1]);
            return kinds[kind][pair.a - begins[kind]];
        }
        void fetch(Pair pair) const { custom::fetch(first_of(pair)); }
        [[nodiscard]] bool passes(Pair pair) {
            const Proxy &a = first_of(pair), &b = kinds[1][pair.b - begins[1]];
            const bool may = a.active | b.active;
            tests += static_cast<std::uint64_t>(may);
            return may & overlap(a.box, b.box);
        }
    };

    const std::vector<Proxy>& still_;
    std::vector<Proxy> rooms_;              ///< what the broad phase was last given, except for the strays
    std::vector<Pair> listed_;              ///< in order
    std::vector<std::uint32_t> leavers_;    ///< room for as many as move
    BoxRow strays_;                         ///< the rooms of all that left since the search
    std::vector<Handle> around_;            ///< scratch
    std::vector<Pair> found_;               ///< scratch
    std::vector<std::size_t> places_;       ///< scratch
    std::vector<Pair> hits_, ball_hits_;    ///< scratch
    const BroadPhase* searched_ = nullptr;  ///< which one knows the rooms
    bool can_mend_ = false;                 ///< the last search was for these proxies, and one was active
    std::uint64_t tests_ = 0;
};

}  // namespace flipside::custom
