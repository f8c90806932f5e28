#pragma once
/// The search for times without a closed form: when does a positive function first reach zero? It is
/// conservative advancement: a bound on the second derivative certifies each step, so no root is skipped. It
/// converges quadratically to a simple root, from before.
///
/// A function that is zero or negative at the start follows the rules of Bannerman, Strobl, Formella and
/// Pöschel 2014
/// ("Stable algorithm for event detection in event-driven particle dynamics"): if it decreases, the event
/// is now; if it increases, there is none until it decreases again.

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
struct SecondOrder {
    R value{}, slope{}, curvature{};
};

/// Sizes of rounding.
template <class R>
struct Tolerance {
    R slope{};  ///< a slower decrease does not count
    R value{};  ///< > 0; a minimum below this is a grazing contact
};

/// First time in [from, until] at which `f(t)` (a Value) is ≤ 0, decreases faster than `tolerance`, and
/// `accepts(t)` is true; else never. f'' ≥ −bound in between. If `accepts(t)` is false, `again(t)` gives a
/// later time up to which it stays false. Sets `grazes` if the minimum is zero to rounding. If value and
/// slope are both of the size of rounding, the search takes a step in which the value changes by no more than
/// that; so the result is late by no more.
template <class R, class F, class Accepts, class Again>
R first_falling_root(const F& f, R from, const R& until, const R& bound, const Tolerance<R>& tolerance,
                     const Accepts& accepts, const Again& again, bool& grazes) {
    using std::sqrt;
    const R least = bound > 0 ? R(sqrt(2 * tolerance.value / bound)) : infinity<R>();
    constexpr int most_steps = 100'000;  // a few, in practice
    int steps = 0;
    R t = from;
    while (t <= until) {
        if (++steps > most_steps) throw EndlessSearch();
        const Value<R> now = f(t);
        if (now.value <= 0) {
            R later = t;
            if (!accepts(t))
                later = again(t);
            else if (now.slope < -tolerance.slope)
                return t;
            if (now.slope >= -tolerance.slope) {
                if (!(bound > 0)) return infinity<R>();
                const R turn = (now.slope + tolerance.slope) / bound;  // it does not fall faster before
                later = std::max(later, R(t + (turn > least ? turn : least)));
            }
            t = later;
            continue;
        }
        const R step = free_step(now.value, now.slope, bound);
        const bool flat = magnitude(now.slope) <= tolerance.slope;
        if (flat && now.value <= tolerance.value) grazes = true;
        if (flat && step < least) {
            t += least;
        } else if (t + step <= t) {
            if (accepts(t)) return t;
            t = again(t);
        } else {
            t += step;
        }
    }
    return infinity<R>();
}

/// The same if `accepts` is always true.
template <class R, class F>
R first_falling_root(const F& f, const R& from, const R& until, const R& bound,
                     const Tolerance<R>& tolerance) {
    bool grazes = false;
    return first_falling_root(
        f, from, until, bound, tolerance, [](const R&) { return true; }, [](const R& t) { return t; },
        grazes);
}

/// When a contact has just separated, the gap starts at zero with zero slope and second derivative. Then a
/// bound on the second derivative certifies only steps of the size of rounding, 1/√ε of them. With a bound on
/// the third, `jerk`, the steps grow in proportion to the time: f(t + h) ≥ f + f'h + f''h²/2 − jerk·h³/6.
/// Returns a time up to which such an `f(t)` (a SecondOrder) stays above −tolerance.value; `from` for other
/// functions.
template <class R, class F>
R skip_flat_start(const F& f, const R& from, const R& until, const R& jerk, const Tolerance<R>& tolerance) {
    using std::sqrt;
    const R least = root(R(3 * tolerance.value / jerk), 3);
    const R flat = tolerance.value / (least * least);
    constexpr int most_steps = 1000;
    R t = from;
    for (int step = 0; step < most_steps && t < until; ++step) {
        const SecondOrder<R> now = f(t);
        const bool begins = magnitude(now.value) <= tolerance.value &&
                            magnitude(now.slope) <= tolerance.slope && magnitude(now.curvature) <= flat;
        if (step == 0 ? !begins : now.slope < -tolerance.slope || now.curvature < -flat) return t;
        // The longer of the two steps that the slope and the second derivative certify.
        const R by_slope = sqrt(std::max(R(0), R(6 * now.slope / jerk)));
        const R by_bend = std::max(R(0), R(3 * now.curvature / jerk));
        t += std::max(least, std::max(by_slope, by_bend));
    }
    return t;
}

}  // namespace flipside::reference
