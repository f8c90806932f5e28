#pragma once
/// Time as a compensated sum of steps (Kahan 1965, "Further remarks on reducing truncation errors"):
/// after a million steps it is still within one rounding of the true sum.

namespace flipside {

/// s: what is due so little before or after a moment is due at it.
constexpr double same_moment = 1e-9;

struct Clock {
    double time = 0;       ///< s
    double remainder = 0;  ///< accumulated rounding of `time`

    /// The remainder is the rounding of the last sum, which is exact (Knuth's TwoSum): at most half an ulp
    /// of `time`. So `time` never falls, and steps below its ulp add up in the remainder until they show.
    void advance(double dt) {
        const double y = dt + remainder;
        const double t = time + y;
        const double added = t - time;
        remainder = (time - (t - added)) + (y - added);
        time = t;
    }
    /// s from here to there; below 0 if that is past.
    [[nodiscard]] double until(const Clock& there) const {
        return (there.time - time) + (there.remainder - remainder);
    }
    friend bool operator==(const Clock&, const Clock&) = default;
};

}  // namespace flipside
