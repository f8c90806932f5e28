#pragma once
/// When two discs under different constant accelerations meet: the square of their distance is a polynomial
/// of degree four in time.

#include <array>

#include "world/vec2.hpp"

namespace flipside::custom {

/// c[0] + c[1]·t + … + c[4]·t⁴.
using Quartic = std::array<double, 5>;

/// |p + v·t + ½a·t²|² − reach², in m².
[[nodiscard]] Quartic squared_gap(Vec2 p, Vec2 v, Vec2 a, double reach);

/// First t in [0, until] at which it is ≤ 0 and falling, or infinity. What begins below 0 counts as above
/// until it turns. Between the roots of the derivative, which are bracketed by those of the second
/// derivative, it only falls or only rises; so no root is missed. Cost: up to four searches by Newton's
/// method of about six steps.
[[nodiscard]] double first_fall(const Quartic& c, double until);

}  // namespace flipside::custom
