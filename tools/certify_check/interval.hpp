#pragma once
/// Interval arithmetic, rounded outwards by MPFI, and Taylor expansions in time with intervals as
/// coefficients.

#include <array>

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

/// Derivatives of a quantity over their factorials, at a time or anywhere in an interval of it; the first
/// `order` + 1 are known.
struct Jet {
    static constexpr int most = 6;
    std::array<I, most + 1> c;
    int order = most;

    Jet() = default;
    Jet(const I& constant) { c[0] = constant; }  // NOLINT(google-explicit-constructor)

    [[nodiscard]] Jet derivative() const {
        Jet d;
        d.order = order - 1;
        for (int k = 0; k <= d.order; ++k) d.c[k] = (k + 1) * c[k + 1];
        return d;
    }
    friend Jet operator+(Jet a, const Jet& b) {
        a.order = std::min(a.order, b.order);
        for (int k = 0; k <= a.order; ++k) a.c[k] += b.c[k];
        return a;
    }
    friend Jet operator-(Jet a, const Jet& b) {
        a.order = std::min(a.order, b.order);
        for (int k = 0; k <= a.order; ++k) a.c[k] -= b.c[k];
        return a;
    }
    friend Jet operator*(const I& s, Jet a) {
        for (int k = 0; k <= a.order; ++k) a.c[k] *= s;
        return a;
    }
    friend Jet operator*(const Jet& a, const Jet& b) {
        Jet p;
        p.order = std::min(a.order, b.order);
        for (int k = 0; k <= p.order; ++k)
            for (int j = 0; j <= k; ++j) p.c[k] += a.c[j] * b.c[k - j];
        return p;
    }
    friend Jet operator/(const Jet& a, const Jet& b) {
        Jet q;
        q.order = std::min(a.order, b.order);
        for (int k = 0; k <= q.order; ++k) {
            I rest = a.c[k];
            for (int j = 0; j < k; ++j) rest -= q.c[j] * b.c[k - j];
            q.c[k] = rest / b.c[0];
        }
        return q;
    }
};

/// √(x² + y²).
inline Jet length(const Jet& x, const Jet& y) {
    const Jet a = x * x + y * y;
    Jet r;
    r.order = a.order;
    r.c[0] = sqrt(I(square(x.c[0]) + square(y.c[0])));
    for (int k = 1; k <= r.order; ++k) {
        I rest = a.c[k];
        for (int j = 1; j < k; ++j) rest -= r.c[j] * r.c[k - j];
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
    I sum = wide.c[wide.order];
    for (int k = wide.order - 1; k >= 0; --k) sum = sum * t + thin.c[k];
    return sum;
}

}  // namespace certificate
