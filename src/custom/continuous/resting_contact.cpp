#include "custom/continuous/resting_contact.hpp"

#include <algorithm>

namespace flipside::custom {

namespace {

constexpr int order = taylor_order;
template <class T>
using Series = std::array<T, order + 1>;

/// Index without the sign that the compiler minds.
constexpr std::size_t at(int k) {
    return static_cast<std::size_t>(k);
}

/// Term k of the product of two series.
template <class A, class B>
auto product(const Series<A>& a, const Series<B>& b, int k) {
    auto sum = a[0] * b[at(k)];
    for (int j = 1; j <= k; ++j) sum += a[at(j)] * b[at(k - j)];
    return sum;
}
double dot_product(const Series<Vec2>& a, const Series<Vec2>& b, int k) {
    double sum = 0;
    for (int j = 0; j <= k; ++j) sum += dot(a[at(j)], b[at(k - j)]);
    return sum;
}

/// A vector that turns at `rate`.
Series<Vec2> turning_vector(Vec2 v, double rate) {
    Series<Vec2> series;
    series[0] = v;
    for (int k = 0; k < order; ++k) series[at(k + 1)] = rate / (k + 1) * perp(series[at(k)]);
    return series;
}

/// Where a ball's centre is in terms of the held feature: on a line `offset` from it, or on a circle.
struct Guide {
    bool straight;
    Vec2 pivot;
    double rate;
    // Straight: the centre is at pivot + s·tangent + offset·normal.
    double s, offset;
    // Curved: at pivot + arm + radius·out.
    Vec2 arm, out;
    double radius;
};

Guide guide_of(const RestingContact& contact, const Ball& ball, double time) {
    const Pose pose = contact.turning->pose(time);
    Guide guide{};
    guide.rate = contact.turning->rate_at(time);
    guide.straight = std::holds_alternative<Line>(contact.feature->is);
    if (const auto* line = std::get_if<Line>(&contact.feature->is)) {
        // Without turning the pivot is free: the start of the line keeps digits far from the origin.
        const Vec2 start = pose.apply(line->start);
        guide.pivot = guide.rate == 0 ? start : pose.pivot;
        guide.s = dot(ball.position - guide.pivot, -perp(contact.normal));
        guide.offset = dot(start - guide.pivot, contact.normal) + ball.radius;
        return guide;
    }
    Vec2 center;
    if (const auto* arc = std::get_if<Arc>(&contact.feature->is)) {
        center = pose.apply(arc->center);
        guide.out = unit(ball.position - center);
        guide.radius = arc->radius + (dot(guide.out, contact.normal) > 0 ? ball.radius : -ball.radius);
    } else {
        const auto& circle = std::get<Circle>(contact.feature->is);
        center = pose.apply(circle.center);
        guide.out = unit(ball.position - center);
        guide.radius = circle.radius + ball.radius;
    }
    guide.pivot = guide.rate == 0 ? center : pose.pivot;
    guide.arm = center - guide.pivot;
    return guide;
}

/// How friction acts while a ball is held.
struct Rub {
    double slide = 0;  ///< µ with the sign of the slip; 0 when the ball rolls or there is no friction
    bool rolls = false;

    /// What is left of a tangential acceleration.
    [[nodiscard]] double share() const { return rolls ? 2.0 / 3 : 1; }
};

/// What acts in a swing, as series in time.
struct Loads {
    Series<double> force{};  ///< per mass, along the normal
    Series<double> push{};   ///< change of the speed along perp(normal), relative to the surface
};

Loads swing_straight(const Guide& guide, Vec2 normal, Vec2 velocity, const Drive& drive, const Rub& rub,
                     Series<Vec2>& displacement) {
    const double w = guide.rate, d = guide.offset, c = drive.drag;
    const Series<Vec2> t = turning_vector(-perp(normal), w), n = turning_vector(normal, w);
    Series<double> s{};
    Loads loads;
    s[0] = guide.s;
    s[1] = dot(velocity, t[0]) + d * w;
    for (int k = 0; k + 2 <= order; ++k) {
        const double speed = (k + 1) * s[at(k + 1)] - (k == 0 ? d * w : 0);
        const double force = 2 * w * (k + 1) * s[at(k + 1)] - (k == 0 ? d * w * w : 0) -
                             dot(n[at(k)], drive.gravity) + c * w * s[at(k)];
        const double driven = w * w * s[at(k)] + dot(t[at(k)], drive.gravity) - c * speed;
        const double bend = rub.share() * driven + rub.slide * force;
        s[at(k + 2)] = bend / ((k + 1) * (k + 2));
        loads.force[at(k)] = force;
        loads.push[at(k)] = -bend;
    }
    for (int k = 0; k <= order; ++k) displacement[at(k)] = product(s, t, k) + d * n[at(k)];
    return loads;
}

Loads swing_curved(const Guide& guide, Vec2 normal, Vec2 velocity, const Drive& drive, const Rub& rub,
                   Series<Vec2>& displacement) {
    const double c = drive.drag, radius = guide.radius, side = dot(guide.out, normal) > 0 ? 1 : -1;
    const Series<Vec2> center = turning_vector(guide.arm, guide.rate);
    Series<Vec2> driving{};  // gravity as felt by one who moves with the centre
    for (int k = 0; k + 2 <= order; ++k)
        driving[at(k)] = (k == 0 ? drive.gravity : Vec2{}) - (k + 1) * (k + 2) * center[at(k + 2)] -
                         c * (k + 1) * center[at(k + 1)];
    Series<Vec2> out{}, tangent{};  // out' = turn·tangent, tangent' = −turn·out
    Series<double> turn{};
    Loads loads;
    out[0] = guide.out;
    tangent[0] = perp(guide.out);
    turn[0] = dot(velocity - cross(guide.rate, guide.arm), tangent[0]) / radius;
    for (int k = 0; k < order; ++k) {
        const double force = -side * (dot_product(out, driving, k) + radius * product(turn, turn, k));
        const double driven = dot_product(tangent, driving, k) - c * radius * turn[at(k)];
        const double bend = rub.share() * driven - side * rub.slide * force;
        turn[at(k + 1)] = bend / (radius * (k + 1));
        const Vec2 turned = product(turn, tangent, k) / (k + 1);
        out[at(k + 1)] = turned;
        tangent[at(k + 1)] = perp(turned);
        loads.force[at(k)] = force;
        loads.push[at(k)] = side * bend;
    }
    for (int k = 0; k <= order; ++k) displacement[at(k)] = center[at(k)] + radius * out[at(k)];
    return loads;
}

/// How long the polynomial is good: its last terms stay below `error`.
double good_for(const Series<Vec2>& series, double error) {
    double h = never_touch;
    for (const int k : {order, order - 1, order - 2}) {
        const double term = length(series[at(k)]);
        if (term > 0) h = std::min(h, math::root(error / term, k));
    }
    return h;
}

/// Counts the steps of the searches for the end of a contact, which take about ten each.
class Patience {
  public:
    /// False when it is at its end.
    bool lasts() { return ++steps_ <= most_steps; }
    [[nodiscard]] bool lasted() const { return steps_ <= most_steps; }

  private:
    static constexpr int most_steps = 4000;
    int steps_ = 0;
};

/// First time in [0, h] at which the series falls below zero.
double first_below_zero(const Series<double>& f, double h, Patience& patience) {
    double k2 = 0, power = 1;
    for (int k = 2; k <= order; ++k, power *= h) k2 += k * (k - 1) * std::abs(f[at(k)]) * power;
    const double tolerance = 1e-15 * (std::abs(f[0]) + k2 * h * h + std::abs(f[1]) * h);
    for (double t = 0; t < h && patience.lasts();) {
        double value = 0, slope = 0;
        for (int k = order; k >= 0; --k) {
            slope = slope * t + value;
            value = value * t + f[at(k)];
        }
        if (value <= tolerance && slope < 0) return t;
        const double step = surely_free(std::max(value, tolerance), slope, k2);
        if (t + step <= t) return t;
        t += step;
    }
    return never_touch;
}

/// When the point of touch runs off the end of the feature: the search of time_of_impact for the ends. One
/// nearer than rounding that it runs towards is reached.
double end_of_face(const Feature& feature, const Turning& turning, const Path& path, double radius, double t0,
                   double t1, Patience& patience) {
    const double rate = turning.rate_at(t0);
    const double v = path.max_speed(t1), a = path.max_acceleration(t1), w = std::abs(rate);
    for (double t = t0; t <= t1 && patience.lasts();) {
        const Vec2 p = path.position(t);
        const Pose pose = turning.pose(t);
        const Vec2 arm = p - pose.pivot, q = pose.undo(p);
        const Vec2 u = rotated(path.velocity(t) - cross(rate, arm), -pose.angle);
        const double far = w == 0 ? 0 : length(arm) + v * (t1 - t);
        const double k = a + 2 * w * (v + w * far) + w * w * far;
        const double rounding = 4 * 0x1p-53 * (std::abs(q.x) + std::abs(q.y) + radius);
        const auto free = [&](double inside, double slope) {
            if (inside < 0 || (inside <= rounding && slope < 0)) return 0.0;
            return surely_free(std::max(inside, rounding), slope, k);
        };
        double h = never_touch;
        if (const auto* line = std::get_if<Line>(&feature.is)) {
            const double s = dot(q - line->start, line->along), along = dot(u, line->along);
            h = std::min(free(s + line->before.holds(radius), along),
                         free(line->length + line->past.holds(radius) - s, -along));
        } else if (const auto* arc = std::get_if<Arc>(&feature.is); arc && !arc->full) {
            const Vec2 out = q - arc->center;
            const double from = free(cross(arc->from, out) + arc->before.holds(radius), cross(arc->from, u));
            const double to = free(cross(out, arc->to) + arc->past.holds(radius), cross(u, arc->to));
            h = arc->wide ? std::max(from, to) : std::min(from, to);
        }
        if (h <= 0) return t;
        t += h;
    }
    return never_touch;
}

}  // namespace

RestingContact resting_contact_at(const Feature& feature, const Turning& turning, const Ball& ball,
                                  Vec2 normal, double time, const Drive& drive) {
    RestingContact contact{&feature, &turning, normal, {}, 0, 0, 0};
    const Guide guide = guide_of(contact, ball, time);
    const Vec2 point = ball.position - ball.radius * normal;
    contact.surface_velocity = cross(guide.rate, point - turning.begin.pivot);
    const Vec2 driving = drive.gravity - drive.drag * ball.velocity;
    const double driven = dot(driving, normal);
    contact.driven = dot(driving, perp(normal));
    if (guide.straight) {
        const double slide = dot(ball.velocity, -perp(normal)) + guide.offset * guide.rate;
        contact.force = 2 * slide * guide.rate - guide.offset * guide.rate * guide.rate - driven;
        contact.driven -= guide.rate * guide.rate * guide.s;
    } else {
        const double side = dot(guide.out, normal) > 0 ? 1 : -1;
        const double turn = dot(ball.velocity - cross(guide.rate, guide.arm), perp(guide.out)) / guide.radius;
        contact.force =
            -driven - side * guide.radius * turn * turn - guide.rate * guide.rate * dot(guide.arm, normal);
        contact.driven += guide.rate * guide.rate * dot(guide.arm, perp(normal));
    }
    return contact;
}

void ConstrainedPath::fly(const Flight& flight, double time) {
    path.start = time;
    path.flight = flight;
    path.swing.clear();
    until = never_touch;
    spin_rate = 0;
    roll = {};
    separates = false;
}

double ConstrainedPath::spin_at(double spin, double time) const {
    const double t = time - path.start;
    if (roll != Vec2{}) return dot(roll, path.velocity(time));
    return spin + (path.swings() ? path.swing[0].spin_change(t) : spin_rate * t);
}

namespace {

/// Whether a ball rolls or slides. `driven` is what acts along perp(normal) without friction.
Rub rub_of(const RestingContact& contact, const Ball& ball, double along, double driven) {
    if (contact.friction <= 0) return {};
    const double slip = along - ball.radius * ball.spin, support = contact.friction * contact.force;
    const double none = 1e-9 * (std::abs(along) + ball.radius * std::abs(ball.spin)) +
                        1e-12 * std::sqrt(ball.radius * std::max(0.0, contact.force));
    if (std::abs(slip) > none) return {slip > 0 ? contact.friction : -contact.friction, false};
    if (std::abs(driven) / 3 < support * (1 - 1e-12)) return {0, true};
    return {driven > 0 ? contact.friction : -contact.friction, false};
}

/// The path on a still line; what ends it is the end of the slip.
void slide(const RestingContact& contact, const Ball& ball, const Rub& rub, double along, const Drive& drive,
           ConstrainedPath& held, Patience& patience) {
    Flight& flight = held.path.flight;
    const Vec2 tangent = perp(contact.normal);
    const double gravity = dot(drive.gravity, tangent), rubbed = rub.slide * contact.force;
    flight.acceleration = (rub.share() * gravity - rubbed) * tangent;
    flight.drag = rub.share() * drive.drag;
    if (rub.rolls) held.roll = tangent / ball.radius;
    if (rub.slide == 0) return;
    held.spin_rate = 2 * rubbed / ball.radius;
    // The slip shrinks along a trajectory of its own.
    const double sign = rub.slide > 0 ? 1 : -1, slip = sign * (along - ball.radius * ball.spin);
    if (!(slip > 0)) return;
    const double k = drive.drag * flight.max_acceleration(0);
    for (double t = 0; t < 1e6 && patience.lasts();) {
        const double now =
            sign * (dot(flight.velocity_at(t), tangent) - ball.radius * ball.spin) - 2 * std::abs(rubbed) * t;
        const Vec2 driving = flight.acceleration - flight.drag * flight.velocity_at(t);
        const double step =
            surely_free(std::max(0.0, now), sign * dot(driving, tangent) - 2 * std::abs(rubbed), k);
        if (t + step <= t || now <= 0) {
            held.until = held.path.start + t;
            return;
        }
        t += step;
    }
}

/// The path on anything that bends or turns.
void swing(const RestingContact& contact, const Ball& ball, const Guide& guide, const Rub& rub, double along,
           double t1, const Drive& drive, ConstrainedPath& held, Patience& patience) {
    Path& path = held.path;
    const double time = path.start;
    const Vec2 velocity = path.flight.velocity;
    Swing& swing = path.swing.emplace_back();
    const Loads loads = guide.straight
                            ? swing_straight(guide, contact.normal, velocity, drive, rub, swing.displacement)
                            : swing_curved(guide, contact.normal, velocity, drive, rub, swing.displacement);
    path.flight = {guide.pivot + swing.displacement[0], velocity, {}, 0};
    const double stop = contact.turning->rate_at(time) != 0 ? contact.turning->stop : never_touch;
    const double good = time + good_for(swing.displacement, 1e-17 * ball.radius);
    const double h = std::min({good, stop, t1}) - time;
    double power = 1;
    for (int k = 1; k <= order; ++k, power *= h) {
        swing.top_speed += k * length(swing.displacement[at(k)]) * power;
        if (k < order) swing.top_acceleration += (k + 1) * k * length(swing.displacement[at(k + 1)]) * power;
    }
    const double falls = time + first_below_zero(loads.force, h, patience);
    held.until = std::min({good, stop, falls});
    held.separates = held.until == falls;
    if (contact.friction <= 0) return;

    Series<double> more{}, less{};  // support to spare in both directions; or, sliding, the slip that is left
    const double sign = rub.slide > 0 ? 1 : -1;
    more[0] = sign * (along - ball.radius * ball.spin);
    for (int k = 0; k + 1 < order; ++k) {
        const double rubbed = rub.slide * loads.force[at(k)];
        swing.spin[at(k + 1)] = (rub.rolls ? loads.push[at(k)] : 2 * rubbed) / (ball.radius * (k + 1));
        if (!rub.rolls) {
            more[at(k + 1)] = sign * (loads.push[at(k)] - 2 * rubbed) / (k + 1);
            continue;
        }
        more[at(k)] = contact.friction * loads.force[at(k)] + loads.push[at(k)] / 2;
        less[at(k)] = contact.friction * loads.force[at(k)] - loads.push[at(k)] / 2;
    }
    double switches = never_touch;
    if (rub.rolls)
        switches = std::min(first_below_zero(more, h, patience), first_below_zero(less, h, patience));
    if (!rub.rolls && more[0] > 0) switches = first_below_zero(more, h, patience);
    if (time + switches < held.until) {
        held.until = time + switches;
        held.separates = false;
    }
}

}  // namespace

double friction_of(const RestingContact& contact, const Ball& ball) {
    const double along = dot(ball.velocity - contact.surface_velocity, perp(contact.normal));
    const Rub rub = rub_of(contact, ball, along, contact.driven);
    return rub.rolls ? -contact.driven / 3 : -rub.slide * contact.force;
}

bool constrain(const RestingContact& contact, const Ball& ball, double time, double t1, const Drive& drive,
               ConstrainedPath& held) {
    const Vec2 n = contact.normal, tangent = perp(n);
    const Guide guide = guide_of(contact, ball, time);
    const double along = dot(ball.velocity - contact.surface_velocity, tangent);
    held.fly({{}, along * tangent + contact.surface_velocity, {}, drive.drag}, time);
    Path& path = held.path;
    const Rub rub = rub_of(contact, ball, along, contact.driven);
    Patience patience;
    if (!guide.straight || guide.rate != 0) {
        swing(contact, ball, guide, rub, along, t1, drive, held, patience);
    } else {
        path.flight.position = guide.pivot + (guide.offset * n - guide.s * tangent);
        slide(contact, ball, rub, along, drive, held, patience);
    }
    const double last = std::min(held.until, t1);
    const double end =
        end_of_face(*contact.feature, *contact.turning, path, ball.radius, time, last, patience);
    if (end <= last) {
        held.until = end;
        held.separates = true;
    }
    if (held.until > t1) held.until = never_touch;
    return patience.lasted();
}

}  // namespace flipside::custom
