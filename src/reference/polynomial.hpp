#pragma once
/// Real roots of polynomials up to the fourth degree, and when one falls through zero. No formula is used:
/// the roots of f' cut f into monotone pieces, and each piece with a change of sign is bracketed (TOMS 748,
/// Alefeld, Potra and Shi 1995). Degrees are true ones: leading zeros are dropped first, as a solver that
/// takes c₄ = 0 for a quartic invents roots. No root is lost and none invented, but pairs nearer than
/// rounding can tell; those are reported as grazing.

#include <array>

#include "reference/real.hpp"

namespace flipside::reference {

template <class R>
struct Polynomial {
    std::array<R, 5> c{};  ///< f = Σ c[k]·t^k

    [[nodiscard]] R at(const R& t) const { return (((c[4] * t + c[3]) * t + c[2]) * t + c[1]) * t + c[0]; }
    [[nodiscard]] Polynomial derivative() const { return {{c[1], 2 * c[2], 3 * c[3], 4 * c[4], R(0)}}; }
    /// Bound on the rounding error of at(t), t ≥ 0.
    [[nodiscard]] R rounding(const R& t) const;
};

template <class R>
struct Roots {
    std::array<R, 4> at{};
    int count = 0;
};

/// Where the sign changes in (from, until), in order.
template <class R>
[[nodiscard]] Roots<R> roots(const Polynomial<R>& f, const R& from, const R& until);

template <class R>
struct FallingRoots {
    std::array<R, 6> at{};
    int count = 0;
    bool grazes = false;  ///< a least value was within rounding of zero
};

/// Every time in [0, until] at which f falls through zero or, being below it, begins to fall faster than
/// `slope` > 0; in order.
template <class R>
[[nodiscard]] FallingRoots<R> falling_roots(const Polynomial<R>& f, const R& until, const R& slope);

}  // namespace flipside::reference
