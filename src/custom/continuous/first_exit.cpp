#include "custom/continuous/first_exit.hpp"

#include <span>

#include "custom/continuous/time_of_impact.hpp"

namespace flipside::custom {

namespace {

/// Instants after the start of a path, s. A polynomial of degree n has at most n − 1 extrema.
struct Instants {
    std::array<double, std::size_t{2} * taylor_order> at{};
    std::size_t count = 0;

    void add(double t) { at[count++] = t; }
    [[nodiscard]] std::span<double> all() { return {at.data(), count}; }
};

/// Bisection to neighbouring numbers: `is_before` is true at a and false at b, and the result is the first
/// number at which it is found false. At most 1,100 passes, since each halves the count of numbers between a
/// and b once their exponents are equal.
double turning_point(auto&& is_before, double a, double b) {
    for (;;) {
        const double middle = a + (b - a) / 2;
        if (middle <= a || middle >= b) return b;
        (is_before(middle) ? a : b) = middle;
    }
}

using Coefficients = std::array<double, taylor_order + 1>;

/// Coefficients of the m-th derivative of Σ c[k]·t^k.
Coefficients derivative(const Coefficients& c, int m) {
    Coefficients result{};
    for (int k = m; k <= taylor_order; ++k) {
        double factor = 1;
        for (int i = 0; i < m; ++i) factor *= k - i;
        result[static_cast<std::size_t>(k - m)] = factor * c[static_cast<std::size_t>(k)];
    }
    return result;
}

/// Adds the zeros in (0, h) of the slope of Σ c[k]·t^k. The zeros of each derivative lie between those of the
/// next higher one.
void add_turns(const Coefficients& c, double h, Instants& turns) {
    std::array<double, taylor_order + 1> zeros{}, next{};
    std::size_t count = 0;
    for (int m = taylor_order; m >= 1; --m) {
        const Coefficients slope = derivative(c, m);
        const auto is_below = [&](double t) {
            double sum = 0;
            for (std::size_t k = slope.size(); k-- > 0;) sum = sum * t + slope[k];
            return sum < 0;
        };
        std::size_t found = 0;
        double a = 0;
        for (std::size_t i = 0; i <= count; ++i) {
            const double b = i < count ? zeros[i] : h;
            const bool below = is_below(a);
            if (below != is_below(b))
                next[found++] = turning_point([&](double t) { return is_below(t) == below; }, a, b);
            a = b;
        }
        zeros = next, count = found;
    }
    for (std::size_t i = 0; i < count; ++i) turns.add(zeros[i]);
}

/// Adds the extremum of one coordinate of a flight, v(t) = v₀·e^(−ct) + a·E(t) = 0. There is at most one.
void add_turn(double velocity, double acceleration, double drag, double h, Instants& turns) {
    if (velocity * acceleration >= 0) return;
    const double t = drag_turn(velocity, acceleration, drag);
    if (t > 0 && t < h) turns.add(t);
}

}  // namespace

double first_exit(const Path& path, const Box& box, double t0, double t1) {
    const auto is_inside = [&](double t) { return box.contains(path.position(t)); };
    if (!is_inside(t0)) return t0;
    Instants turns;
    const double h = t1 - path.start;
    if (path.is_taylor()) {
        for (double Vec2::*axis : {&Vec2::x, &Vec2::y}) {
            Coefficients series{};
            for (std::size_t k = 1; k < series.size(); ++k) series[k] = path.taylor[0].displacement[k].*axis;
            add_turns(series, h, turns);
        }
    } else {
        const Flight& flight = path.flight;
        add_turn(flight.velocity.x, flight.acceleration.x, flight.drag, h, turns);
        add_turn(flight.velocity.y, flight.acceleration.y, flight.drag, h, turns);
    }
    std::ranges::sort(turns.all());
    double inside = t0;
    for (const double turn : turns.all()) {
        const double t = path.start + turn;
        if (t <= inside || t >= t1) continue;
        if (!is_inside(t)) return turning_point(is_inside, inside, t);
        inside = t;
    }
    return t1 > inside && !is_inside(t1) ? turning_point(is_inside, inside, t1) : never_touch;
}

}  // namespace flipside::custom
