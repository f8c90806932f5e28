// Who takes part in which flights of a step. A ball flies free, which is exact in one go, until the flight in
// which it may first touch something, or in which it may be met by one that did; from there on it is
// engaged. Most never are. All of this follows from where everything is and how fast it moves, not from how
// it was searched.

#include <algorithm>

#include "custom/broad_phase/pair_order.hpp"
#include "custom/discrete/discrete_solver.hpp"
#include "custom/sift.hpp"

namespace flipside::custom {

void DiscreteSolver::find_turns() {
    const NearList::Check checked = place_all();
    const PieceIndex first = moving_pieces();
    const auto roomy = [&](std::uint32_t i) -> SingleBox {
        if (i < first || !moving_[i].active) return moving_[i].box;
        // With room for rounding: what flies straight would else be at the very edge in the end.
        const Ball& ball = (*balls_)[i - first];
        return grown(reach_of(ball, settings_.search_steps * dt_), berth * ball.radius);
    };
    near_.search_as_needed(checked, moving_, *broad_, roomy);
    part_pairs_.clear();
    ball_pairs_.clear();
    turns_.clear();
    near_.each_sifted_apart(moving_, first_ball(),
                            [&](std::span<const Pair> with_parts, std::span<const Pair> of_balls) {
                                part_pairs_.insert(part_pairs_.end(), with_parts.begin(), with_parts.end());
                                ball_pairs_.insert(ball_pairs_.end(), of_balls.begin(), of_balls.end());
                                link(of_balls);
                                take_turns(with_parts, of_balls);
                            });
    if (!any_asleep_) return;
    for (const Pair pair : ball_pairs_) {
        let_doze(place_of(pair.a));
        let_doze(place_of(pair.b));
    }
}

/// Boxes that hold to the end of the step.
NearList::Check DiscreteSolver::place_all() {
    const std::vector<Ball>& balls = *balls_;
    const PieceIndex first = moving_pieces();
    moving_.resize(first + balls.size());
    role_.resize(balls.size());
    so_far_.resize(balls.size());
    rounds_.resize(balls.size());
    first_link_.assign(balls.size(), no_link);
    links_.clear();
    engaged_.clear();
    all_engaged_.start(balls.size());
    strays_.clear();
    dozing_.clear();
    NearList::Check check = near_.begin(moving_.size());
    for (PieceIndex i = 0; i < first; ++i) {
        const PieceIndex piece = layout_.size() - first + i;
        moving_[i] = layout_.proxy(*table_, piece, 0, dt_);
        for (std::size_t k = 1; k < marks_.size(); ++k) {
            const Proxy flight = layout_.proxy(*table_, piece, marks_[k - 1].time, marks_[k].time);
            moving_[i].box = united(moving_[i].box, flight.box);
        }
        check(moving_[i]);
    }
    all_woken_ = any_asleep_ = false;
    for (std::uint32_t i = 0; i < balls.size(); ++i) {
        const Ball& ball = balls[i];
        any_asleep_ |= ball.asleep;
        role_[i] = ball.asleep ? Role::asleep : Role::free;
        moving_[first + i] = {ball.asleep ? bounds_of(ball.position, ball.radius) : reach_of(ball, dt_),
                              ball.layer, ball.collides_with, true, !ball.asleep};
        check(moving_[first + i]);
    }
    return check;
}

/// Notes for all who may touch something in which flight that can be first.
void DiscreteSolver::take_turns(std::span<const Pair> with_parts, std::span<const Pair> of_balls) {
    const std::vector<Ball>& balls = *balls_;
    for (const Pair pair : with_parts) {
        fetch(layout_.capsule(pair.a));
        fetch_motion(balls[place_of(pair.b)]);
    }
    for (const Pair pair : of_balls) {
        fetch_motion(balls[place_of(pair.a)]);
        fetch_motion(balls[place_of(pair.b)]);
    }
    const auto take = [&](std::size_t flight, std::uint32_t place) {
        if (flight < flights()) turns_.push_back({flight, place});
    };
    const auto near_on_the_way = [&](Pair pair) {
        const Ball& ball = balls[place_of(pair.b)];
        const Vec2 middle = 0.5 * (ball.position + end_of_flight(ball, scene_.gravity, marks_.back()));
        return layout_.may_touch(pair.a, middle, (1 + berth) * ball.radius + 0.5 * way(ball, dt_));
    };
    for (const auto [piece, handle] : sift(with_parts, room_, near_on_the_way)) {
        const std::uint32_t place = place_of(handle);
        // A part in motion may strike sleepers too.
        take(layout_.moves(piece) ? 0 : first_flight_to(piece, balls[place]), place);
    }
    const auto with_sleeper = [&](BallPair pair) { return balls[pair.a].asleep || balls[pair.b].asleep; };
    const auto touching = [&](Pair pair) {
        const BallPair both = places_of(pair);
        return with_sleeper(both) || approach_of(balls[both.a], balls[both.b]).touches();
    };
    for (const Pair pair : sift(of_balls, room_, touching)) {
        const auto [a, b] = places_of(pair);
        const std::size_t flight = with_sleeper({a, b}) ? 0 : flight_of(approach_of(balls[a], balls[b]));
        for (const std::uint32_t place : {a, b})
            if (!balls[place].asleep) take(flight, place);
    }
}

/// The flight in which a ball that flies freely may first touch a still piece; past the last if none. A way
/// of length l lies within l/2 of the middle between its ends.
std::size_t DiscreteSolver::first_flight_to(PieceIndex piece, const Ball& ball) const {
    const double room = (1 + berth) * ball.radius, half = 0.5 * way(ball, dt_);
    Vec2 from = ball.position;
    const double half_flight = half * (flight_.time / dt_);
    for (std::size_t k = 0; k < flights(); ++k) {
        const Vec2 to = end_of_flight(ball, scene_.gravity, marks_[k + 1]);
        if (layout_.may_touch(piece, 0.5 * (from + to), room + half_flight)) return k;
        from = to;
    }
    return flights();
}

DiscreteSolver::Approach DiscreteSolver::approach_of(const Ball& a, const Ball& b) const {
    const Vec2 before = a.position - b.position, by = marks_.back().shrunk * (a.velocity - b.velocity);
    const double reach = (1 + berth) * (a.radius + b.radius);
    return {length_squared(before) - reach * reach, -dot(before, by), length_squared(by)};
}

/// In which two balls first touch that do. Equal parts of their way take the longer the later, if any drag
/// slows it.
std::size_t DiscreteSolver::flight_of(const Approach& approach) const {
    const double way = approach.part() * marks_.back().shrunk;
    std::size_t k = 0;
    while (k < flights() && marks_[k + 1].shrunk < way) ++k;
    return k;
}

/// Where a ball is on its free way. It strays from the straight one by at most k·t²/8 (k: acceleration).
Box DiscreteSolver::free_way_of(const Ball& ball) const {
    const Vec2 here = ball.position, there = end_of_flight(ball, scene_.gravity, marks_.back());
    const double slowed = scene_.damping > 0 ? scene_.damping * way(ball, dt_) / dt_ : 0;
    const double sag = (pull_ + slowed) * dt_ * dt_ / 8;
    const double room = (1 + berth) * ball.radius + sag;
    return united(bounds_of(here, room), bounds_of(there, room));
}

/// Of one that may be met.
void DiscreteSolver::let_doze(std::uint32_t place) {
    if (role_[place] != Role::asleep) return;
    role_[place] = Role::dozing;
    lie_still(place);
    dozing_.push_back(place);
}

/// It is where it slept when the step began.
void DiscreteSolver::lie_still(std::uint32_t place) {
    so_far_[place].box = proxy_of_ball(place).box;
    so_far_[place].is_known = false;
}

/// From now on. A ball that flew free did what follows from where it was when the step began.
void DiscreteSolver::engage(std::uint32_t place) {
    Ball& ball = (*balls_)[place];
    if (role_[place] == Role::free) {
        fly_freely(ball, scene_.gravity, Stretch(scene_.damping, span_.begin));
        so_far_[place].is_known = true;
    } else {
        lie_still(place);
    }
    role_[place] = Role::engaged;
    so_far_[place].reach = reach_of(ball, dt_ - span_.begin);
    engaged_.push_back(place);
    all_engaged_.add(place);
}

/// Those whose turn it is, and sleepers that were woken in the flight before.
void DiscreteSolver::engage_due(std::size_t flight) {
    const auto due = [&](const Turn& turn) { return turn.flight == flight; };
    each_sifted(turns_, turn_room_, due, [&](std::span<const Turn> these) {
        for (const Turn& turn : these) prepare(turn.place);
        for (const Turn& turn : these)
            if (role_[turn.place] != Role::engaged) engage(turn.place);
    });
    if (all_woken_)
        for (std::uint32_t i = 0; i < role_.size(); ++i) let_doze(i);
    all_woken_ = false;
    if (dozing_.empty()) return;
    for (const std::uint32_t place : dozing_) {
        start_over(place);
        if (!(*balls_)[place].asleep) engage(place);
    }
    std::erase_if(dozing_, [&](std::uint32_t place) { return role_[place] == Role::engaged; });
}

/// Whoever flies free where an engaged ball may be in this flight is engaged too. First all ask, then those
/// who came by that.
void DiscreteSolver::engage_met() {
    std::size_t asked = engaged_.size();
    if (!seeking_.empty()) seek_company();
    const auto one_flies_free = [&](Pair pair) { return roles_of(pair) == (Role::free | Role::engaged); };
    each_sifted(ball_pairs_, room_, one_flies_free, [&](std::span<const Pair> these) {
        for (const Pair pair : these) prepare(places_of(pair));
        for (const Pair pair : these) {
            const auto [a, b] = places_of(pair);
            role_[a] == Role::free ? meet(a, b) : meet(b, a);
        }
    });
    while (asked < engaged_.size()) {
        const std::size_t known = engaged_.size();
        if (!seeking_.empty()) seek_company();
        meetings_.clear();
        for (; asked < known; ++asked) {
            const std::uint32_t by = engaged_[asked];
            for (std::uint32_t i = first_link_[by]; i != no_link; i = links_[i].next)
                if (role_[links_[i].other] == Role::free) meetings_.push_back({links_[i].other, by});
        }
        each_prepared(
            meetings_, [&](BallPair soon) { prepare(soon.a); }, [&](BallPair pair) { meet(pair.a, pair.b); });
    }
}

/// Engages a ball that flies free if it may meet this engaged one.
void DiscreteSolver::meet(std::uint32_t met, std::uint32_t by) {
    ++record_->statistics.pair_tests;
    if (role_[met] != Role::free || !overlap(SingleBox(free_way_of((*balls_)[met])), so_far_[by].box)) return;
    engage(met);
    start_flight(met);
}

/// Only those listed when the step begins: who joins late was not kicked yet.
void DiscreteSolver::link(std::span<const Pair> of_balls) {
    const auto put = [&](std::uint32_t place, std::uint32_t other) {
        links_.push_back({other, first_link_[place]});
        first_link_[place] = static_cast<std::uint32_t>(links_.size() - 1);
    };
    for (const Pair pair : of_balls) {
        const auto [a, b] = places_of(pair);
        put(a, b);
        put(b, a);
    }
}

/// An engaged ball will be outside of what it was thought to reach.
void DiscreteSolver::widen(std::uint32_t place, const Box& flight) {
    const Box reach = united(flight, reach_of((*balls_)[place], dt_ - span_.begin));
    so_far_[place].reach = reach;
    so_far_[place].is_known = true;
    strays_.add(place, reach);
    seeking_.push_back(place);
}

void DiscreteSolver::seek_company() {
    fresh_part_pairs_.clear();
    fresh_ball_pairs_.clear();
    each_prepared(
        seeking_, [&](std::uint32_t soon) { broad_->prepare(so_far_[soon].reach); },
        [&](std::uint32_t place) { seek_company_of(place); });
    seeking_.clear();
    add_pairs(fresh_part_pairs_, part_pairs_, pair_places_);
    add_pairs(fresh_ball_pairs_, ball_pairs_, pair_places_);
}

/// Lists all pairs of an engaged ball.
void DiscreteSolver::seek_company_of(std::uint32_t place) {
    const Handle first = first_ball(), own = first + place;
    const std::vector<Proxy>& still = layout_.still_proxies();
    Proxy self = proxy_of_ball(place);
    self.box = so_far_[place].reach;
    self.active = true;
    found_.clear();
    near_.find_around(self.box, *broad_, found_);
    record_->statistics.pair_tests +=
        strays_.each_overlapping(self.box, [&](std::uint32_t stray) { found_.push_back(first + stray); });
    for (auto i = static_cast<Handle>(still.size()); i < first; ++i) found_.push_back(i);
    for (const Handle other : found_) {
        if (other == own) continue;
        Proxy proxy = other < first ? proxy_of(other) : proxy_of_ball(other - first);
        if (other >= first && (role_[other - first] & Role::engaged))
            proxy.box = so_far_[other - first].reach;
        // Of a moving part only the box of this flight is at hand.
        const bool anywhere = other < first && layout_.moves(other);
        if (!may_meet(self, proxy) || !(anywhere || overlap(self.box, proxy.box))) continue;
        (other < first ? fresh_part_pairs_ : fresh_ball_pairs_)
            .push_back({std::min(own, other), std::max(own, other)});
        if (other < first || role_[other - first] != Role::asleep) continue;
        start_over(other - first);
        let_doze(other - first);
    }
}

/// Those that the last flight woke find their company too, so that all pairs are known.
void DiscreteSolver::finish_step() {
    span_ = {dt_, dt_};
    flight_ = Stretch(scene_.damping, 0);
    if (any_asleep_) {
        engage_due(flights());
        for (const std::uint32_t place : engaged_)
            if (!so_far_[place].is_known) start_flight(place);
        if (!seeking_.empty()) seek_company();
    }
    const auto is_engaged = [&](Pair pair) { return (role_[place_of(pair.b)] & Role::engaged) != 0; };
    part_pairs_.resize(sift(part_pairs_, part_pairs_, is_engaged).size());
    const auto any_engaged = [&](Pair pair) { return (roles_of(pair) & Role::engaged) != 0; };
    ball_pairs_.resize(sift(ball_pairs_, ball_pairs_, any_engaged).size());
}

}  // namespace flipside::custom
