#include "custom/continuous/time_of_impact.hpp"

#include <span>

namespace flipside::custom {

namespace {

/// Motion of a point relative to a feature or disc, with bounds.
struct RelativeMotion {
    Vec2 at, velocity;
    double top_speed, top_acceleration;  ///< over the rest of the search
    Vec2 acceleration{};                 ///< used only if top_jerk is finite
    double top_jerk = INFINITY;          ///< m/s³, over the rest of the search
};

/// The gap at one instant, with bounds for the next step of the search.
struct Gap {
    double value = 0, slope = 0;
    double k = 0;               ///< bound on −f''
    double trusted = INFINITY;  ///< s, for which k holds
    double outside = 0;         ///< s, for which the point stays past the ends of the feature
    double separating = 0;      ///< s, for which f stays above its value now
};

/// Time for which the distance d from a centre at −out keeps growing (`side` 1) or shrinking (−1): 3·d″/J,
/// where J bounds d‴ while d is above `nearest`. A ball that separates from an arc leaves it as t³, and a
/// bound on d″ alone would allow only tiny steps.
double separating_time(const RelativeMotion& q, Vec2 out, double d, double side, double nearest) {
    const double across = cross(out, q.velocity) / d;
    const double bend = side * (dot(out, q.acceleration) + across * across) / d;
    if (bend <= 0) return 0;
    const double soon = nearest / q.top_speed;
    const double speed = std::min(q.top_speed, length(q.velocity) + q.top_acceleration * soon);
    const double whirl = speed / nearest;
    return std::min(soon,
                    3 * bend / (q.top_jerk + 3 * whirl * q.top_acceleration + 2 * whirl * whirl * speed));
}

Gap gap_to_disc(const RelativeMotion& q, Vec2 center, double reach) {
    const Vec2 out = q.at - center;
    const double d = length(out), slope = d > 0 ? dot(out, q.velocity) / d : 0;
    Gap gap{d - reach, slope, q.top_acceleration + q.top_speed * q.top_speed / reach};
    if (slope > 0) gap.separating = separating_time(q, out, d, 1, d);
    return gap;
}

struct GapTo {
    RelativeMotion q;
    double radius = 0;

    Gap operator()(const Line& line) const {
        const Vec2 from_start = q.at - line.start;
        const double d = cross(line.along, from_start), side = d >= 0 ? 1 : -1;
        const double s = dot(line.along, from_start), along = dot(line.along, q.velocity);
        const double before = -line.before.length(radius) - s;
        const double past = s - line.length - line.past.length(radius);
        return {side * d - radius, side * cross(line.along, q.velocity), q.top_acceleration, INFINITY,
                std::max(until_inside(before, -along), until_inside(past, along))};
    }
    Gap operator()(const Arc& arc) const {
        const Vec2 out = q.at - arc.center;
        const double d = length(out), off = d - arc.radius, side = off >= 0 ? 1 : -1;
        const double slope = d > 0 ? side * dot(out, q.velocity) / d : -q.top_speed;
        // Inside the arc the distance from the centre can shrink; half of it bounds the curvature for a
        // while.
        const double nearest = side > 0 ? arc.radius : 0.5 * std::max(d, 1e-300);
        Gap gap{side * off - radius, slope, q.top_acceleration + q.top_speed * q.top_speed / nearest,
                side > 0 ? INFINITY : nearest / q.top_speed, arc.full ? 0 : until_facing(arc, out)};
        if (slope > 0) gap.separating = separating_time(q, out, d, side, nearest);
        return gap;
    }
    Gap operator()(const Circle& circle) const {
        return gap_to_disc(q, circle.center, radius + circle.radius);
    }

  private:
    /// `out`: distance past an end, m.
    [[nodiscard]] double until_inside(double out, double slope) const {
        return out > 0 ? safe_time(out, slope, q.top_acceleration) : 0;
    }
    [[nodiscard]] double until_facing(const Arc& arc, Vec2 out) const {
        const double before = -cross(arc.from, out) - arc.before.length(radius);
        const double past = -cross(out, arc.to) - arc.past.length(radius);
        const double a = until_inside(before, -cross(arc.from, q.velocity));
        const double b = until_inside(past, -cross(q.velocity, arc.to));
        return arc.wide ? std::min(a, b) : std::max(a, b);
    }
};

/// Conservative advancement. `moving(t)` gives the relative motion, `gap_of` its gap; a gap at t0 of at most
/// `rounding` means contact.
///
/// A gap that stays just above rounding allows only tiny steps. After `sure_steps` of them a minimum length
/// of the step makes the search end. It can then miss an overlap that lasts less than one step; its depth is
/// less than K·((t1 − t0)/5000)²/8.
double search(auto&& moving, auto&& gap_of, double radius, double rounding, double t0, double t1,
              std::uint64_t& steps) {
    constexpr int sure_steps = 5000, all_steps = 2 * sure_steps;  // grazes take about 50
    double t = t0, zero = 0, slide_step = 0, open = never_touch;
    for (int step = 0; step <= all_steps; ++step) {
        ++steps;
        const RelativeMotion q = moving(t);
        Gap gap = gap_of(q);
        if (step == 0 && std::abs(gap.value) <= rounding) zero = gap.value;
        gap.value -= zero;
        const double still = speed_rounding * q.top_speed;
        const double tolerance = 4 * 0x1p-53 * (radius + q.top_speed * (t1 - t0));
        double h = gap.outside;
        if (gap.value > tolerance) {
            open = t;
            const double by_curve = std::min(gap.trusted, safe_time(gap.value, gap.slope, gap.k));
            h = std::max({h, gap.value / q.top_speed, by_curve, gap.separating});
        } else if (gap.slope < -still) {
            if (h <= 0) {
                if (step <= sure_steps || open >= t) return t;
                const auto is_open = [&](double at) {
                    const Gap middle = gap_of(moving(at));
                    return !(middle.value - zero <= tolerance && middle.slope < -still);
                };
                constexpr int most_halvings = 64;  // reach neighbouring numbers, except next to 0
                return turning_point(is_open, open, t, most_halvings);
            }
        } else if (gap.slope > still) {
            const double turn = gap.slope / gap.k;
            h = std::max(
                {h, std::min(gap.trusted, gap.value < -tolerance ? turn : 2 * turn), gap.separating});
        } else {
            // The disc slides along: the gap is constant to first order.
            const double pace = q.top_speed + std::sqrt(q.top_acceleration * radius);
            slide_step = slide_step > 0 ? 2 * slide_step : 1e-7 * radius / pace;
            h = std::max(h, slide_step);
        }
        if (step >= sure_steps) h = std::max(h, (t1 - t) / (all_steps - step));
        double next = t + h;
        if (next <= t) {
            if (gap.outside <= 0) return gap.slope < 0 ? t : never_touch;
            next = std::nextafter(t, INFINITY);  // it is not between the ends of the curve yet
        }
        if (!(next <= t1)) return never_touch;
        t = next;
    }
    return never_touch;  // the whole interval has been searched
}

/// Motion of a ball relative to a part until t1, as a function of time, in the pose of the scene file. The
/// part turns at the rate that it has at t0.
auto motion_relative_to(const Turning& turning, const Path& path, double t0, double t1) {
    const double rate = turning.rate_at(t0), w = std::abs(rate), drag = path.flight.drag;
    const double v = path.max_speed(t1), a = path.max_acceleration(t1);
    const double jerk = path.is_taylor() ? INFINITY : drag * a;
    Pose pose = turning.pose(t0);
    return [=, &turning, &path](double t) mutable {
        const auto [p, u] = path.at(t);
        if (w == 0) {
            const Vec2 driving = path.flight.acceleration - drag * u;
            if (pose.angle == 0) return RelativeMotion{p, u, v, a, driving, jerk};
            return RelativeMotion{pose.undo(p), rotated(u, -pose.angle), v, a, rotated(driving, -pose.angle),
                                  jerk};
        }
        pose.angle = turning.begin.angle + rate * t;
        const Vec2 arm = p - pose.pivot;
        const double far = length(arm) + v * (t1 - t), top = v + w * far;
        return RelativeMotion{pose.undo(p), rotated(u - cross(rate, arm), -pose.angle), top,
                              a + 2 * w * top + w * w * far};
    };
}

/// The feature in the given pose.
Feature posed(Feature feature, const Pose& pose) {
    if (auto* line = std::get_if<Line>(&feature.is)) {
        line->start = pose.apply(line->start);
        line->along = rotated(line->along, pose.angle);
    } else if (auto* arc = std::get_if<Arc>(&feature.is)) {
        arc->center = pose.apply(arc->center);
        for (Vec2* direction : {&arc->from, &arc->to, &arc->middle})
            *direction = rotated(*direction, pose.angle);
    } else if (auto* circle = std::get_if<Circle>(&feature.is)) {
        circle->center = pose.apply(circle->center);
    }
    return feature;
}

/// Whether gap + rate·E(t) + bend·F(t), negative at 0, rises above 0 and decreases again.
bool rises_above_zero(double gap, double rate, double bend, double drag) {
    if (rate <= 0 || bend >= 0 || rate * rate - 2 * gap * bend <= 0) return false;
    if (drag <= 0) return true;
    const TimeInterval top(drag, drag_turn(rate, bend, drag));
    return gap + top.shrunk * rate + top.fallen * bend > 0;
}

/// Impact of a flight with a static line. The gap on each side closes at most once.
double touch_line(const Line& line, const Path& path, double radius, double t0, double t1) {
    const auto [p, v] = path.at(t0);
    const Vec2 a = path.flight.acceleration;
    const double drag = path.flight.drag;
    const auto zero = [](double x, double scale) { return std::abs(x) <= speed_rounding * scale ? 0 : x; };
    const double d = cross(line.along, p - line.start);
    const double slope = zero(cross(line.along, v), length(v)), bend = zero(cross(line.along, a), length(a));
    double first = never_touch;
    for (const double side : {1.0, -1.0}) {
        double gap = side * d - radius;
        if (std::abs(gap) <= gap_rounding(p, radius)) gap = 0;
        // A ball on the other side must first come to this one.
        if (side * d < 0 && !rises_above_zero(gap, side * slope, side * bend, drag)) continue;
        if (gap == 0 && slope == 0) continue;  // slides along, or rests
        const double t = first_crossing(gap, side * slope, side * bend, drag);
        if (t <= t1 - t0 && t < first && closest_point({line, 0, 0}, path.position(t0 + t), radius).facing)
            first = t;
    }
    return t0 + first;
}

/// Instants after the start of a path, s. A polynomial of degree n has at most n − 1 extrema.
struct Instants {
    std::array<double, std::size_t{2} * taylor_order> at{};
    std::size_t count = 0;

    void add(double t) { at[count++] = t; }
    [[nodiscard]] std::span<double> all() { return {at.data(), count}; }
};

/// Coefficients of the m-th derivative.
Series<double> derivative(const Series<double>& c, int m) {
    Series<double> result;
    for (int k = m; k <= taylor_order; ++k) {
        double factor = 1;
        for (int i = 0; i < m; ++i) factor *= k - i;
        result[k - m] = factor * c[k];
    }
    return result;
}

/// Adds the zeros in (0, h) of the slope of Σ c[k]·t^k. The zeros of each derivative lie between those of the
/// next higher one.
void add_turns(const Series<double>& c, double h, Instants& turns) {
    Instants zeros;
    for (int m = taylor_order; m >= 1; --m) {
        const Series<double> slope = derivative(c, m);
        const auto is_below = [&](double t) { return slope[0] + slope.change(t) < 0; };
        Instants bounds = std::exchange(zeros, {});
        bounds.add(h);
        double a = 0;
        for (const double b : bounds.all()) {
            const bool below = is_below(a);
            if (below != is_below(b))
                zeros.add(turning_point([&](double t) { return is_below(t) == below; }, a, b));
            a = b;
        }
    }
    for (const double t : zeros.all()) turns.add(t);
}

}  // namespace

// The miss distance is a cross product, so that grazing contacts keep their digits.
double straight_touch(Vec2 d, Vec2 v, double reach, double rounding) {
    const double speed = length(v), distance = length(d);
    if (speed == 0 || dot(d, v) >= 0) return never_touch;
    const double approach = -dot(d, v) / speed, miss = std::abs(cross(d, v)) / speed;
    const double gap = distance - reach;
    if (gap <= rounding) return approach > speed_rounding * distance ? 0 : never_touch;
    if (miss >= reach) return never_touch;
    const double half = std::sqrt((reach - miss) * (reach + miss));
    return gap * (distance + reach) / (speed * (approach + half));
}

double search_impact(const Feature& feature, const Turning& turning, const Path& path, double radius,
                     double t0, double t1, std::uint64_t& steps) {
    const double stop = turning.rate_at(t0) == 0 ? t1 : std::min(t1, turning.stop);
    const auto gap = [&](const RelativeMotion& q) { return std::visit(GapTo{q, radius}, feature.is); };
    const double t = search(motion_relative_to(turning, path, t0, stop), gap, radius,
                            gap_rounding(path.position(t0), radius), t0, stop, steps);
    if (t < never_touch || stop >= t1) return t;
    return search_impact(feature, turning, path, radius, stop, t1, steps);
}

double search_impact(const Path& a, const Path& b, double radii, double t0, double t1, std::uint64_t& steps) {
    const double top_speed = a.max_speed(t1) + b.max_speed(t1);
    const double top_acceleration = a.max_acceleration(t1) + b.max_acceleration(t1);
    const auto moving = [&](double t) {
        const auto [p, u] = a.at(t);
        const auto [q, v] = b.at(t);
        return RelativeMotion{p - q, u - v, top_speed, top_acceleration};
    };
    const auto gap = [&](const RelativeMotion& q) { return gap_to_disc(q, {}, radii); };
    return search(moving, gap, radii, gap_rounding(a.position(t0), b.position(t0), radii), t0, t1, steps);
}

double end_of_face(const Feature& feature, const Turning& turning, const Path& path, double radius, double t0,
                   double t1, int& steps_left) {
    auto motion = motion_relative_to(turning, path, t0, t1);
    const auto free_time = [&](double t) {
        const RelativeMotion q = motion(t);
        const double rounding = 4 * 0x1p-53 * (std::abs(q.at.x) + std::abs(q.at.y) + radius);
        const auto free = [&](double inside, double slope) {
            if (inside < 0 || (inside <= rounding && slope < 0)) return 0.0;
            return safe_time(std::max(inside, rounding), slope, q.top_acceleration);
        };
        if (const auto* line = std::get_if<Line>(&feature.is)) {
            const double s = dot(q.at - line->start, line->along), along = dot(q.velocity, line->along);
            return std::min(free(s + line->before.resting_length(radius), along),
                            free(line->length + line->past.resting_length(radius) - s, -along));
        }
        const auto* arc = std::get_if<Arc>(&feature.is);
        if (arc == nullptr || arc->full) return never_touch;
        const Vec2 out = q.at - arc->center;
        const double from =
            free(cross(arc->from, out) + arc->before.resting_length(radius), cross(arc->from, q.velocity));
        const double to =
            free(cross(out, arc->to) + arc->past.resting_length(radius), cross(q.velocity, arc->to));
        return arc->wide ? std::max(from, to) : std::min(from, to);
    };
    return conservative_advancement(free_time, t0, t1, steps_left);
}

double time_of_impact(const Feature& feature, const Turning& turning, const Path& path, double radius,
                      double t0, double t1, std::uint64_t& steps) {
    if (turning.rate_at(t0) == 0 && !turning.unmoved())
        return time_of_impact(posed(feature, turning.pose(t0)), {}, path, radius, t0, t1, steps);
    if (turning.unmoved() && !path.is_taylor()) {
        if (const auto* line = std::get_if<Line>(&feature.is)) return touch_line(*line, path, radius, t0, t1);
        const Flight& flight = path.flight;
        const auto* circle = std::get_if<Circle>(&feature.is);
        if (circle != nullptr && flight.acceleration == Vec2{} && flight.drag <= 0) {
            const Vec2 p = path.position(t0);
            const double t = t0 + straight_touch(p - circle->center, flight.velocity, radius + circle->radius,
                                                 gap_rounding(p, radius));
            return t <= t1 ? t : never_touch;
        }
    }
    return search_impact(feature, turning, path, radius, t0, t1, steps);
}

double time_of_impact(const Path& a, const Path& b, double radii, double t0, double t1,
                      std::uint64_t& steps) {
    const Flight &f = a.flight, &g = b.flight;
    const bool alike = f.acceleration == g.acceleration && f.drag == g.drag;
    if (a.is_taylor() || b.is_taylor() || (!alike && (f.drag > 0 || g.drag > 0)))
        return search_impact(a, b, radii, t0, t1, steps);
    const auto [p, u] = a.at(t0);
    const auto [q, v] = b.at(t0);
    const Vec2 between = p - q, relative = u - v;
    const double rounding = gap_rounding(p, q, radii);
    double after = 0;
    if (alike) {
        // Equal accelerations cancel, and drag slows both equally: the relative path is straight.
        after = drag_time(f.drag, straight_touch(between, relative, radii, rounding));
    } else {
        Quartic gap = squared_gap(between, relative, f.acceleration - g.acceleration, radii);
        // As in straight_touch, what touches and approaches by rounding alone has no impact yet: the
        // accelerations decide.
        if (std::abs(length(between) - radii) <= rounding &&
            std::abs(gap[1]) <= 2 * speed_rounding * length(between) * length(relative))
            gap[0] = gap[1] = 0;
        after = first_crossing(gap, t1 - t0);
    }
    return t0 + after <= t1 ? t0 + after : never_touch;
}

double first_exit(const Path& path, const Box& box, double t0, double t1) {
    const auto is_inside = [&](double t) { return box.contains(path.position(t)); };
    if (!is_inside(t0)) return t0;
    Instants turns;
    for (double Vec2::*axis : {&Vec2::x, &Vec2::y}) {
        if (path.is_taylor()) {
            Series<double> series;
            for (int k = 1; k <= taylor_order; ++k) series[k] = path.taylor[0].displacement[k].*axis;
            add_turns(series, t1 - path.start, turns);
            continue;
        }
        // Where v(t) = v₀·e^(−ct) + a·E(t) = 0, at most once.
        const double velocity = path.flight.velocity.*axis, acceleration = path.flight.acceleration.*axis;
        if (velocity * acceleration < 0) turns.add(drag_turn(velocity, acceleration, path.flight.drag));
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
