#pragma once
/// Interval arithmetic, rounded outwards by MPFI, and Taylor expansions in time with intervals as
/// coefficients.

#include <algorithm>
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
/// The greatest distance from 0.
inline double size(const I& x) {
    return std::max(-low(x), high(x));
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

/// Derivatives of a quantity over their factorials, at a time or anywhere in an interval of it, up to an
/// order.
struct Jet {
    static constexpr int most = 10;
    std::vector<I> c;

    Jet() = default;
    explicit Jet(const I& constant, int order) : c(static_cast<std::size_t>(order + 1)) {
        if (order >= 0) c[0] = constant;
    }

    [[nodiscard]] int order() const { return static_cast<int>(c.size()) - 1; }
    [[nodiscard]] Jet derivative() const {
        Jet d(I(0), order() - 1);
        for (std::size_t k = 0; k < d.c.size(); ++k) d.c[k] = (k + 1) * c[k + 1];
        return d;
    }
    friend Jet operator+(Jet a, const Jet& b) {
        a.c.resize(std::min(a.c.size(), b.c.size()));
        for (std::size_t k = 0; k < a.c.size(); ++k) a.c[k] += b.c[k];
        return a;
    }
    friend Jet operator-(Jet a, const Jet& b) {
        a.c.resize(std::min(a.c.size(), b.c.size()));
        for (std::size_t k = 0; k < a.c.size(); ++k) a.c[k] -= b.c[k];
        return a;
    }
    friend Jet operator-(Jet a, const I& constant) {
        a.c[0] -= constant;
        return a;
    }
    friend Jet operator*(const I& s, Jet a) {
        for (I& one : a.c) one *= s;
        return a;
    }
    friend Jet operator*(const Jet& a, const Jet& b) {
        Jet p(I(0), std::min(a.order(), b.order()));
        for (std::size_t k = 0; k < p.c.size(); ++k)
            for (std::size_t j = 0; j <= k; ++j) p.c[k] += a.c[j] * b.c[k - j];
        return p;
    }
    friend Jet operator/(const Jet& a, const Jet& b) {
        Jet q(I(0), std::min(a.order(), b.order()));
        for (std::size_t k = 0; k < q.c.size(); ++k) {
            I rest = a.c[k];
            for (std::size_t j = 0; j < k; ++j) rest -= q.c[j] * b.c[k - j];
            q.c[k] = rest / b.c[0];
        }
        return q;
    }
};

/// √(x² + y²).
inline Jet length(const Jet& x, const Jet& y) {
    const Jet a = x * x + y * y;
    Jet r(sqrt(I(square(x.c[0]) + square(y.c[0]))), a.order());
    for (std::size_t k = 1; k < r.c.size(); ++k) {
        I rest = a.c[k];
        for (std::size_t j = 1; j < k; ++j) rest -= r.c[j] * r.c[k - j];
        r.c[k] = rest / (2 * r.c[0]);
    }
    return r;
}

/// All values from a to b of what f(time) expands: Taylor's theorem about the middle.
template <class F>
I range(const F& f, double a, double b) {
    const double middle = a + (b - a) / 2;
    const Jet thin = f(I(middle)), wide = f(between(a, b));
    const I t = between(a, b) - middle;
    I sum = wide.c.back();
    for (std::size_t k = wide.c.size() - 1; k-- > 0;) sum = sum * t + thin.c[k];
    return sum;
}

}  // namespace certificate
