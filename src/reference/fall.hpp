#pragma once
/// The search that everything without a closed form comes down to: when does a function that is positive
/// first fall to zero? It steps by what a bound on the second derivative certifies to be free, so it skips
/// no root, and converges quadratically to a simple one, from before.
///
/// What is found at or below zero follows the rules of Bannerman, Strobl, Formella and Pöschel 2014 ("Stable
/// algorithm for event detection in event-driven particle dynamics"): falling, the event is now; rising,
/// there is none until it turns.

#include <algorithm>

#include "reference/real.hpp"
#include "world/refusal.hpp"

namespace flipside::reference {

template <class R>
struct Value {
    R value{}, slope{};
};

/// Longest s with f + f'·s − ½k·s² ≥ 0, for f ≥ 0.
template <class R>
R free_step(const R& f, const R& slope, const R& k) {
    using std::sqrt;
    if (!(k > 0)) return slope < 0 ? R(-f / slope) : infinity<R>();
    const R root = sqrt(slope * slope + 2 * k * f);
    return slope < 0 ? R(2 * f / (root - slope)) : R((slope + root) / k);
}

/// Value, slope and second derivative.
template <class R>
struct Bent {
    R value{}, slope{}, bend{};
};

/// What counts as rounding.
template <class R>
struct Smallest {
    R slope{};  ///< a fall slower than this is none
    R value{};  ///< > 0; a least value below this is a graze
};

/// First time in [from, until] at which `f(t)` (a Value) is ≤ 0 and falls faster than `smallest`, where
/// `meets(t)` agrees; never otherwise. f'' ≥ −bound between. `again(t)`, for a time that `meets` refuses,
/// gives a later time up to which it is sure to refuse. Sets `grazes` where the least value is within
/// rounding of zero. Where value and slope are both rounding it steps so far that the value cannot change
/// by more than that either: such a fall is found late by no more.
template <class R, class F, class Meets, class Again>
R first_fall(const F& f, R from, const R& until, const R& bound, const Smallest<R>& smallest,
             const Meets& meets, const Again& again, bool& grazes) {
    using std::sqrt;
    const R least = bound > 0 ? R(sqrt(2 * smallest.value / bound)) : infinity<R>();
    constexpr int most_steps = 100'000;  // a few, in practice
    int steps = 0;
    R t = from;
    while (t <= until) {
        if (++steps > most_steps) throw EndlessSearch();
        const Value<R> now = f(t);
        if (now.value <= 0) {
            R later = t;
            if (!meets(t))
                later = again(t);
            else if (now.slope < -smallest.slope)
                return t;
            if (now.slope >= -smallest.slope) {
                if (!(bound > 0)) return infinity<R>();
                const R turn = (now.slope + smallest.slope) / bound;  // it does not fall faster before
                later = std::max(later, R(t + (turn > least ? turn : least)));
            }
            t = later;
            continue;
        }
        const R step = free_step(now.value, now.slope, bound);
        const bool flat = magnitude(now.slope) <= smallest.slope;
        if (flat && now.value <= smallest.value) grazes = true;
        if (flat && step < least) {
            t += least;
        } else if (t + step <= t) {
            if (meets(t)) return t;
            t = again(t);
        } else {
            t += step;
        }
    }
    return infinity<R>();
}

/// The same for what always meets.
template <class R, class F>
R first_fall(const F& f, const R& from, const R& until, const R& bound, const Smallest<R>& smallest) {
    bool grazes = false;
    return first_fall(
        f, from, until, bound, smallest, [](const R&) { return true; }, [](const R& t) { return t; }, grazes);
}

/// Where a contact has just let go, a function begins at zero with slope and second derivative zero. There
/// a bound on the second derivative certifies steps of its rounding only, 1/√ε of them. With a bound on the
/// third, `jerk`, steps grow in proportion to the time since: f(t + h) ≥ f + f'h + f''h²/2 − jerk·h³/6.
/// Gives a time up to which `f(t)` (a Bent) that begins so surely stays above −smallest.value; `from` for one
/// that begins otherwise.
template <class R, class F>
R clear_of_start(const F& f, const R& from, const R& until, const R& jerk, const Smallest<R>& smallest) {
    using std::sqrt;
    const R least = root(R(3 * smallest.value / jerk), 3);
    const R flat = smallest.value / (least * least);
    constexpr int most_steps = 1000;
    R t = from;
    for (int step = 0; step < most_steps && t < until; ++step) {
        const Bent<R> now = f(t);
        const bool begins = magnitude(now.value) <= smallest.value &&
                            magnitude(now.slope) <= smallest.slope && magnitude(now.bend) <= flat;
        if (step == 0 ? !begins : now.slope < -smallest.slope || now.bend < -flat) return t;
        // The longer of the steps that slope and bend each certify by themselves.
        const R by_slope = sqrt(std::max(R(0), R(6 * now.slope / jerk)));
        const R by_bend = std::max(R(0), R(3 * now.bend / jerk));
        t += std::max(least, std::max(by_slope, by_bend));
    }
    return t;
}

}  // namespace flipside::reference
