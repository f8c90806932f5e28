#pragma once
/// When two moving shapes first touch.

#include <limits>

namespace flipside::custom {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// First time in [0, duration] at which `separation(time)` ≤ tolerance, or never. The separation must not
/// shrink faster than `speed`; then it cannot close within separation/speed, so stepping by that passes no
/// touch: conservative advancement, Mirtich 1996, "Impulse-based dynamic simulation of rigid body systems".
/// A path that grazes closer than the steps can tell apart counts as a touch where the search stopped.
template <class Separation>
[[nodiscard]] double first_touch(Separation&& separation, double speed, double duration, double tolerance) {
    constexpr int most_steps = 64;
    double time = 0;
    for (int i = 0; i < most_steps; ++i) {
        const double gap = separation(time);
        if (gap <= tolerance) return time;
        time += gap / speed;
        if (!(time <= duration)) return never;
    }
    return time;
}

}  // namespace flipside::custom
