#pragma once
/// The numbers that the exact engine computes with: double, and binary floating point of 113 and 226 bits
/// (Boost.Multiprecision, Maddock and Kormanyos). Everything else in this folder is written once, for any of
/// them; plane vectors of them are here too.

#include <cmath>
#include <limits>
#include <type_traits>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "world/vec2.hpp"

namespace flipside::reference {

using Real113 = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<113, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;
using Real226 = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<226, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

/// A type of about twice the precision, for decisions too close to rounding; the widest is its own.
template <class R>
struct Wider {
    using type = Real226;
};
template <>
struct Wider<double> {
    using type = Real113;
};

template <class R>
R epsilon() {
    return std::numeric_limits<R>::epsilon();
}
/// Where it stands for a time: never.
template <class R>
R infinity() {
    return std::numeric_limits<R>::infinity();
}

template <class R>
struct V {
    R x{}, y{};

    V() = default;
    V(R x_, R y_) : x(std::move(x_)), y(std::move(y_)) {}
    explicit V(Vec2 v) : x(v.x), y(v.y) {}
    template <class S>
    explicit V(const V<S>& v) : x(v.x), y(v.y) {}

    friend V operator+(const V& a, const V& b) { return {a.x + b.x, a.y + b.y}; }
    friend V operator-(const V& a, const V& b) { return {a.x - b.x, a.y - b.y}; }
    friend V operator-(const V& a) { return {-a.x, -a.y}; }
    friend V operator*(const R& s, const V& a) { return {s * a.x, s * a.y}; }
    friend V operator/(const V& a, const R& s) { return {a.x / s, a.y / s}; }
    V& operator+=(const V& b) { return x += b.x, y += b.y, *this; }
    V& operator-=(const V& b) { return x -= b.x, y -= b.y, *this; }
};

template <class R>
R dot(const V<R>& a, const V<R>& b) {
    return a.x * b.x + a.y * b.y;
}
/// z of the 3D cross product.
template <class R>
R cross(const V<R>& a, const V<R>& b) {
    return a.x * b.y - a.y * b.x;
}
/// ω × r.
template <class R>
V<R> cross(const R& rate, const V<R>& r) {
    return {-rate * r.y, rate * r.x};
}
/// A quarter turn anticlockwise.
template <class R>
V<R> perp(const V<R>& a) {
    return {-a.y, a.x};
}
template <class R>
R length(const V<R>& a) {
    using std::sqrt;
    return sqrt(dot(a, a));
}
/// Unit vector; upwards where there is no direction.
template <class R>
V<R> unit(const V<R>& a) {
    const R l = length(a);
    return l > 0 ? a / l : V<R>{R(0), R(1)};
}
template <class R>
V<R> from_angle(const R& angle) {
    if constexpr (std::is_same_v<R, double>)
        return V<R>(flipside::from_angle(angle));
    else
        return {cos(angle), sin(angle)};
}
/// The n-th root of x ≥ 0.
template <class R>
R root(const R& x, int n) {
    if constexpr (std::is_same_v<R, double>)
        return math::root(x, n);
    else
        return n == 3 ? R(cbrt(x)) : R(pow(x, R(R(1) / n)));
}
/// Turned by the angle of the unit vector `turn`.
template <class R>
V<R> rotated(const V<R>& a, const V<R>& turn) {
    return {turn.x * a.x - turn.y * a.y, turn.y * a.x + turn.x * a.y};
}
/// Turned back by it.
template <class R>
V<R> unrotated(const V<R>& a, const V<R>& turn) {
    return {turn.x * a.x + turn.y * a.y, turn.x * a.y - turn.y * a.x};
}
template <class R>
Vec2 narrow(const V<R>& a) {
    return {static_cast<double>(a.x), static_cast<double>(a.y)};
}
template <class R>
R magnitude(const R& a) {
    return a < 0 ? -a : a;
}

}  // namespace flipside::reference
