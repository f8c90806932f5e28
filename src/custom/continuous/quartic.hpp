#pragma once
/// Time of impact of two discs with different constant accelerations: the square of their distance is a
/// polynomial of degree four in time.

#include <array>

#include "world/vec2.hpp"

namespace flipside::custom {

/// c[0] + c[1]·t + … + c[4]·t⁴.
using Quartic = std::array<double, 5>;

/// |p + v·t + ½a·t²|² − reach², in m².
[[nodiscard]] Quartic squared_gap(Vec2 p, Vec2 v, Vec2 a, double reach);

/// First t in [0, until] at which the polynomial is ≤ 0 and decreasing, or infinity. A negative value at 0
/// does not count until the polynomial has begun to decrease again. The polynomial is monotone between the
/// roots of its derivative, which the roots of the second derivative bracket; so no root is missed. Cost: up
/// to four Newton searches of about six steps.
[[nodiscard]] double first_crossing(const Quartic& c, double until);

}  // namespace flipside::custom
