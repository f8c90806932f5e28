#pragma once
/// Intervals, rounded outwards by MPFI, and Taylor expansions in time with intervals as coefficients (Moore
/// 1966, "Interval Analysis"): of a quantity at a time, or everywhere in an interval of it.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include <boost/multiprecision/mpfi.hpp>

namespace certificate {

using I = boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<36>,
                                        boost::multiprecision::et_off>;

constexpr auto low = [](const I& x) { return mpfr_get_d(&x.backend().data()->left, MPFR_RNDD); };
constexpr auto high = [](const I& x) { return mpfr_get_d(&x.backend().data()->right, MPFR_RNDU); };
/// The greatest distance from 0; infinite for what is no number.
constexpr auto size_of = [](const I& x) {
    const double most = std::max(-low(x), high(x));
    return most >= 0 ? most : HUGE_VAL;
};

/// Derivatives over their factorials, as many as are known; of a constant all are, and 0.
struct Jet {
    using In = const Jet&;
    std::vector<I> c;
    std::size_t known = SIZE_MAX;

    Jet(const I& constant = 0) : c{constant} {}
    Jet(double constant) : c{I(constant)} {}
    Jet(const I& time, std::size_t terms) : c{time, I(1)}, known(terms) {}
    /// Each coefficient from those before.
    Jet(In a, In b, const auto& term) : known(std::min(a.known, b.known)) {
        for (std::size_t k = 0; k < (known == SIZE_MAX ? 1 : known); ++k) c.push_back(I(term(*this, k)));
    }
    const I& operator[](std::size_t k) const {
        static const I zero(0), anything(-HUGE_VAL, HUGE_VAL);
        return k >= known ? anything : k < c.size() ? c[k] : zero;
    }
    /// Σ a[j]·b[k − j], for j from `first` up to `last`.
    static I sum(In a, In b, std::size_t k, std::size_t first, std::size_t last) {
        I sum = 0;
        for (std::size_t j = first; j <= last && j < a.c.size(); ++j)
            if (k - j < b.c.size()) sum += a.c[j] * b.c[k - j];
        return sum;
    }
    /// The k-th coefficient of what has the derivative u·a', k > 0.
    static I chained(In a, In u, std::size_t k) {
        I sum = 0;
        for (std::size_t j = 1; j <= k; ++j) sum += j * a[j] * u[k - j];
        return sum / k;
    }
    friend Jet operator+(In a, In b) {
        return {a, b, [&](In, auto k) { return a[k] + b[k]; }};
    }
    friend Jet operator-(In a, In b) {
        return {a, b, [&](In, auto k) { return a[k] - b[k]; }};
    }
    friend Jet operator*(In a, In b) {
        return {a, b, [&](In, auto k) { return sum(a, b, k, 0, k); }};
    }
    friend Jet operator/(In a, In b) {
        return {a, b, [&](In q, auto k) { return (k == 0 ? a[0] : a[k] - sum(q, b, k, 0, k - 1)) / b[0]; }};
    }
    friend Jet sqrt(In a) {
        return {a, a, [&](In r, auto k) {
                    return k == 0 ? I(sqrt(a[0])) : (a[k] - sum(r, r, k, 1, k - 1)) / (2 * r[0]);
                }};
    }
    friend Jet exp(In a) {
        return {a, a, [&](In e, auto k) { return k == 0 ? I(exp(a[0])) : chained(a, e, k); }};
    }
    friend Jet derivative(In a) {
        Jet d(a, a, [&](In, auto k) { return (k + 1) * a[k + 1]; });
        if (d.known != SIZE_MAX) d.c.resize(--d.known);
        return d;
    }
};

/// A place, velocity or direction.
struct V {
    using In = const V&;
    Jet x = 0.0, y = 0.0;
    friend V operator+(In a, In b) { return {a.x + b.x, a.y + b.y}; }
    friend V operator-(In a, In b) { return {a.x - b.x, a.y - b.y}; }
    friend V operator*(const Jet& s, In a) { return {s * a.x, s * a.y}; }
    friend V operator/(In a, const Jet& s) { return {a.x / s, a.y / s}; }
    friend Jet dot(In a, In b) { return a.x * b.x + a.y * b.y; }
    friend Jet cross(In a, In b) { return a.x * b.y - a.y * b.x; }
    friend V perp(In a) { return {0.0 - a.y, a.x}; }
    friend V derivative(In a) { return {derivative(a.x), derivative(a.y)}; }
    friend double size(In a) { return std::max(size_of(a.x[0]), size_of(a.y[0])); }
    friend Jet length(In a) {
        Jet squared = dot(a, a);
        const I across = abs(a.x[0]), up = abs(a.y[0]);
        squared.c[0] = across * across + up * up;  // for certain not below 0
        return sqrt(squared);
    }
    static V from_angle(const Jet& a) {
        V turn{Jet(I(cos(a[0]))), Jet(I(sin(a[0])))};
        turn.x.known = turn.y.known = a.known;
        for (std::size_t k = 1; a.known != SIZE_MAX && k < a.known; ++k) {
            const I next = -Jet::chained(a, turn.y, k);
            turn.y.c.push_back(Jet::chained(a, turn.x, k)), turn.x.c.push_back(next);
        }
        return turn;
    }
};

/// All values from a to b of what f(time) expands: Taylor's theorem about the middle.
I range(const auto& f, double a, double b, std::size_t terms) {
    const Jet thin = f(Jet(I(std::midpoint(a, b)), terms)), wide = f(Jet(I(a, b), terms));
    const I t = I(a, b) - std::midpoint(a, b);
    std::size_t k = wide.c.size() - 1;
    I sum = wide[k];
    while (k-- > 0) sum = sum * t + thin[k];
    return sum;
}

}  // namespace certificate
