#include "reference/polynomial.hpp"

#include <boost/math/tools/toms748_solve.hpp>

namespace flipside::reference {

namespace {

template <class R>
int degree(const Polynomial<R>& f) {
    int n = 4;
    while (n > 0 && f.c[static_cast<std::size_t>(n)] == 0) --n;
    return n;
}

/// The root between two values of different sign; the end of the bracket on the side of b.
template <class R>
R bracketed(const Polynomial<R>& f, const R& a, const R& b, const R& fa, const R& fb) {
    if (fb == 0) return b;
    if (fa == 0) return a;
    std::uintmax_t most = 400;
    const auto tight = [](const R& low, const R& high) {
        return high - low <= 2 * epsilon<R>() * std::max(magnitude(low), magnitude(high));
    };
    return boost::math::tools::toms748_solve([&](const R& t) { return f.at(t); }, a, b, fa, fb, tight, most)
        .second;
}

}  // namespace

template <class R>
R Polynomial<R>::rounding(const R& t) const {
    R sum = magnitude(c[4]);
    for (const std::size_t k : {3U, 2U, 1U, 0U}) sum = sum * t + magnitude(c[k]);
    return 8 * epsilon<R>() * sum;
}

template <class R>
Roots<R> roots(const Polynomial<R>& f, const R& from, const R& until) {
    Roots<R> found;
    const int n = degree(f);
    if (n == 0) return found;
    if (n == 1) {
        const R t = -f.c[0] / f.c[1];
        if (t > from && t < until) found.at[static_cast<std::size_t>(found.count++)] = t;
        return found;
    }
    const Roots<R> turns = roots(f.derivative(), from, until);
    R a = from, fa = f.at(a);
    for (int i = 0; i <= turns.count; ++i) {
        const R b = i < turns.count ? turns.at[static_cast<std::size_t>(i)] : until;
        const R fb = f.at(b);
        if ((fa < 0 && fb >= 0) || (fa > 0 && fb <= 0)) {
            const R t = bracketed(f, a, b, fa, fb);
            if (t > from && t < until && found.count < n)
                found.at[static_cast<std::size_t>(found.count++)] = t;
        }
        a = b, fa = fb;
    }
    return found;
}

namespace {

/// First time in [a, b] at which f' < −slope; b if none.
template <class R>
R turns_down(const Polynomial<R>& derivative, const R& a, const R& b, const R& slope) {
    if (derivative.at(a) < -slope) return a;
    Polynomial<R> steeper = derivative;
    steeper.c[0] += slope;
    const Roots<R> found = roots(steeper, a, b);
    return found.count > 0 ? found.at[0] : b;
}

}  // namespace

template <class R>
FallingRoots<R> falling_roots(const Polynomial<R>& f, const R& until, const R& slope) {
    FallingRoots<R> found;
    const Polynomial<R> derivative = f.derivative();
    const Roots<R> turns = roots(derivative, R(0), until);
    const auto add = [&](const R& t) { found.at[static_cast<std::size_t>(found.count++)] = t; };
    R a(0), fa = f.c[0];
    for (int i = 0; i <= turns.count; ++i) {
        const R b = i < turns.count ? turns.at[static_cast<std::size_t>(i)] : until;
        const R fb = f.at(b);
        if (i < turns.count && fb <= fa && magnitude(fb) <= f.rounding(b)) found.grazes = true;
        if (fb < fa) {
            if (fa <= 0) {
                const R t = turns_down(derivative, a, b, slope);
                if (t < b) add(t);
            } else if (fb <= 0) {
                add(bracketed(f, a, b, fa, fb));
            }
        }
        a = b, fa = fb;
    }
    return found;
}

#define FLIPSIDE_POLYNOMIALS(R)                                        \
    template struct Polynomial<R>;                                     \
    template Roots<R> roots(const Polynomial<R>&, const R&, const R&); \
    template FallingRoots<R> falling_roots(const Polynomial<R>&, const R&, const R&);
FLIPSIDE_POLYNOMIALS(double)
FLIPSIDE_POLYNOMIALS(Real113)
FLIPSIDE_POLYNOMIALS(Real226)
#undef FLIPSIDE_POLYNOMIALS

}  // namespace flipside::reference
