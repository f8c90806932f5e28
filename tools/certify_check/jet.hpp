#pragma once
/// Intervals, rounded outwards by MPFI, and Taylor expansions in time with intervals as coefficients (Moore
/// 1966, "Interval Analysis"): of a quantity at a time, or everywhere in an interval of it.

#include <algorithm>
#include <climits>
#include <cmath>
#include <vector>

#include <boost/multiprecision/mpfi.hpp>

namespace certificate {

using I = boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<36>,
                                        boost::multiprecision::et_off>;

inline double low(const I& x) {
    return mpfr_get_d(&x.backend().data()->left, MPFR_RNDD);
}
inline double high(const I& x) {
    return mpfr_get_d(&x.backend().data()->right, MPFR_RNDU);
}
/// The greatest distance from 0; infinite for what is no number.
inline double size(const I& x) {
    const double most = std::max(-low(x), high(x));
    return most >= 0 ? most : HUGE_VAL;
}
inline I between(double a, double b) {
    I x;
    mpfi_interv_d(x.backend().data(), a, b);
    return x;
}
inline I square(const I& x) {
    I y;
    mpfi_sqr(y.backend().data(), x.backend().data());
    return y;
}

/// Derivatives over their factorials; those past the last are 0, up to the order that is known.
struct Jet {
    std::vector<I> c;
    int known = INT_MAX;

    Jet(const I& constant = 0) : c{constant} {}
    Jet(double constant) : c{I(constant)} {}
    Jet(const I& time, int order) : c{time, I(1)}, known(order) {}
    /// `terms` coefficients at most, each from those before.
    template <class Term>
    Jet(std::size_t terms, int order, const Term& term) : known(order) {
        for (std::size_t k = 0; k < terms && static_cast<int>(k) <= order; ++k) c.push_back(term(*this, k));
    }
    const I& operator[](std::size_t k) const {
        static const I zero(0);
        return k < c.size() ? c[k] : zero;
    }
    /// As many terms as an expansion without end has.
    [[nodiscard]] std::size_t all() const { return c.size() == 1 ? 1 : static_cast<std::size_t>(known) + 1; }
    [[nodiscard]] Jet derivative() const {
        const auto term = [this](const Jet&, std::size_t k) { return I((k + 1) * (*this)[k + 1]); };
        return {std::max<std::size_t>(c.size(), 2) - 1, known == INT_MAX ? known : known - 1, term};
    }
    static Jet merged(const Jet& a, const Jet& b, std::size_t terms, const auto& term) {
        return {terms, std::min(a.known, b.known), term};
    }
    /// Σ a[j]·b[k − j], for j from `first` up to `last`.
    static I convolved(const Jet& a, const Jet& b, std::size_t k, std::size_t first, std::size_t last) {
        I sum = 0;
        for (std::size_t j = first; j <= last && j < a.c.size(); ++j)
            if (k - j < b.c.size()) sum += a.c[j] * b.c[k - j];
        return sum;
    }
    /// The k-th term of what has the derivative u·a', k > 0.
    static I chained(const Jet& a, const Jet& u, std::size_t k) {
        I sum = 0;
        for (std::size_t j = 1; j <= k && j < a.c.size(); ++j) sum += j * a.c[j] * u[k - j];
        return sum / k;
    }
    friend Jet operator+(const Jet& a, const Jet& b) {
        return merged(a, b, std::max(a.c.size(), b.c.size()), [&](auto&, auto k) { return I(a[k] + b[k]); });
    }
    friend Jet operator-(const Jet& a, const Jet& b) {
        return merged(a, b, std::max(a.c.size(), b.c.size()), [&](auto&, auto k) { return I(a[k] - b[k]); });
    }
    friend Jet operator*(const Jet& a, const Jet& b) {
        return merged(a, b, a.c.size() + b.c.size() - 1,
                      [&](auto&, auto k) { return convolved(a, b, k, 0, k); });
    }
    friend Jet operator/(const Jet& a, const Jet& b) {
        return merged(a, b, b.c.size() == 1 ? a.c.size() : b.all(), [&](const Jet& q, std::size_t k) {
            return k == 0 ? I(a[0] / b[0]) : I((a[k] - convolved(q, b, k, 0, k - 1)) / b[0]);
        });
    }
    friend Jet sqrt(const Jet& a) {
        return merged(a, a, a.all(), [&](const Jet& r, std::size_t k) {
            return k == 0 ? I(sqrt(a[0])) : I((a[k] - convolved(r, r, k, 1, k - 1)) / (2 * r[0]));
        });
    }
    friend Jet exp(const Jet& a) {
        return merged(a, a, a.all(),
                      [&](auto& e, auto k) { return k == 0 ? I(exp(a[0])) : chained(a, e, k); });
    }
};

/// A place, velocity or direction.
struct V {
    Jet x, y;
    friend V operator+(const V& a, const V& b) { return {a.x + b.x, a.y + b.y}; }
    friend V operator-(const V& a, const V& b) { return {a.x - b.x, a.y - b.y}; }
    friend V operator*(const Jet& s, const V& a) { return {s * a.x, s * a.y}; }
    friend V operator/(const V& a, const Jet& s) { return {a.x / s, a.y / s}; }
    friend Jet dot(const V& a, const V& b) { return a.x * b.x + a.y * b.y; }
    friend Jet cross(const V& a, const V& b) { return a.x * b.y - a.y * b.x; }
    friend V perp(const V& a) { return {0.0 - a.y, a.x}; }
    friend V derivative(const V& a) { return {a.x.derivative(), a.y.derivative()}; }
    friend double size(const V& a) { return std::max(size(a.x[0]), size(a.y[0])); }
};
inline Jet length(const V& a) {
    Jet squared = dot(a, a);
    squared.c[0] = square(a.x[0]) + square(a.y[0]);  // for certain not below 0
    return sqrt(squared);
}
/// The unit vector at an angle.
inline V from_angle(const Jet& a) {
    V turn{Jet(I(cos(a[0]))), Jet(I(sin(a[0])))};
    turn.x.known = turn.y.known = a.known;
    for (std::size_t k = 1; k < a.all(); ++k) {
        const I x = -Jet::chained(a, turn.y, k), y = Jet::chained(a, turn.x, k);
        turn.x.c.push_back(x), turn.y.c.push_back(y);
    }
    return turn;
}

/// All values from a to b of what f(time) expands: Taylor's theorem about the middle.
I range(const auto& f, double a, double b, int order) {
    const double middle = a + (b - a) / 2;
    const Jet thin = f(Jet(I(middle), order)), wide = f(Jet(between(a, b), order));
    const I t = between(a, b) - middle;
    std::size_t k = std::min(static_cast<std::size_t>(wide.known), wide.c.size());
    I sum = wide[k];
    while (k-- > 0) sum = sum * t + thin[k];
    return sum;
}

}  // namespace certificate
