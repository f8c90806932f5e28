#include "custom/continuous/resting_contact.hpp"

#include <algorithm>
#include <functional>

namespace flipside::custom {

namespace {

constexpr int order = taylor_order;

/// Term k of the product of two series.
template <class Times = std::multiplies<>>
auto product(const auto& a, const auto& b, int k, Times times = {}) {
    auto sum = times(a[0], b[k]);
    for (int j = 1; j <= k; ++j) sum += times(a[j], b[k - j]);
    return sum;
}

/// A vector that turns at `rate`.
Series<Vec2> turning_vector(Vec2 v, double rate) {
    Series<Vec2> series;
    series[0] = v;
    for (int k = 0; k < order; ++k) series[k + 1] = rate / (k + 1) * perp(series[k]);
    return series;
}

/// The curve on which the centre of a resting ball moves: a line parallel to the face, or a circle.
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
        // On a part that does not turn, any pivot will do; the start of the line keeps digits far from the
        // origin.
        const Vec2 start = pose.apply(line->start);
        guide.pivot = guide.rate == 0 ? start : pose.pivot;
        guide.s = dot(ball.position - guide.pivot, -perp(contact.normal));
        guide.offset = dot(start - guide.pivot, contact.normal) + ball.radius;
        return guide;
    }
    const Circle circle = circle_of(*contact.feature);
    const Vec2 center = pose.apply(circle.center);
    guide.out = unit(ball.position - center);
    guide.radius = circle.radius + (dot(guide.out, contact.normal) > 0 ? ball.radius : -ball.radius);
    guide.pivot = guide.rate == 0 ? center : pose.pivot;
    guide.arm = center - guide.pivot;
    return guide;
}

/// How friction acts in a resting contact.
struct Friction {
    double slide = 0;  ///< µ with the sign of the slip; 0 when the ball rolls or there is no friction
    bool rolls = false;
    bool begins = false;  ///< to slide: there is no slip yet

    /// Part of a tangential force that accelerates the centre; the rest accelerates the spin of a rolling
    /// ball.
    [[nodiscard]] double share() const { return rolls ? 2.0 / 3 : 1; }
};

/// Forces in a resting contact, as series in time.
struct Loads {
    Series<double> force{};  ///< per mass, along the normal
    Series<double> slide{};  ///< acceleration along perp(normal) relative to the surface, m/s²
};

/// Time for which the last terms of the series stay below `error`, s.
double valid_time(const Series<Vec2>& series, double error) {
    double h = never_touch;
    for (const int k : {order, order - 1, order - 2}) {
        const double term = length(series[k]);
        if (term > 0) h = std::min(h, math::root(error / term, k));
    }
    return h;
}

/// Speed of a ball along perp(normal) relative to the surface, m/s.
double speed_along(const RestingContact& contact, const Ball& ball) {
    return dot(ball.velocity - contact.surface_velocity, perp(contact.normal));
}

/// Whether a ball rolls or slides.
Friction friction_state(const RestingContact& contact, const Ball& ball) {
    if (contact.friction <= 0) return {};
    const double along = speed_along(contact, ball);
    const double slip = along - ball.radius * ball.spin, support = contact.friction * contact.force;
    const double none = 1e-12 * (std::abs(along) + ball.radius * std::abs(ball.spin)) +
                        1e-12 * std::sqrt(ball.radius * std::max(0.0, contact.force));
    if (std::abs(slip) > none) return {slip > 0 ? contact.friction : -contact.friction, false};
    if (std::abs(contact.tangential) / 3 < support * (1 - 1e-12)) return {0, true};
    return {contact.tangential > 0 ? contact.friction : -contact.friction, false, true};
}

/// Finds the path of a resting ball; see constrain().
struct PathOnSurface {
    const RestingContact& contact;
    const Ball& ball;
    const ExternalForces& external;
    double time = 0;  ///< s, at its start
    ConstrainedPath& motion;
    Guide guide = guide_of(contact, ball, time);
    Friction friction = friction_state(contact, ball);
    double along = speed_along(contact, ball);
    int steps_left = 4000;  ///< of the searches for its end, which take about ten each

    /// The path on a static line. It ends when the slip falls to 0.
    void slide() {
        Flight& flight = motion.path.flight;
        const Vec2 tangent = perp(contact.normal);
        const double gravity = dot(external.gravity, tangent);
        const double sliding_force = friction.slide * contact.force;
        flight.acceleration = (friction.share() * gravity - sliding_force) * tangent;
        flight.drag = friction.share() * external.drag;
        if (friction.rolls) motion.roll = tangent / ball.radius;
        if (friction.slide == 0) return;
        motion.spin_rate = 2 * sliding_force / ball.radius;
        const double sign = friction.slide > 0 ? 1 : -1;
        const double slip = sign * (along - ball.radius * ball.spin);
        const double k = external.drag * flight.max_acceleration(0);
        const auto growth = [&](double t) {
            const Vec2 driving = flight.acceleration - flight.drag * flight.velocity_at(t);
            return sign * dot(driving, tangent) - 2 * std::abs(sliding_force);
        };
        // A ball that begins to slip does so faster and faster, until drag has slowed that.
        const double rounding = 1e-15 * (std::abs(along) + ball.radius * std::abs(ball.spin));
        const double first = friction.begins ? safe_time(rounding, std::max(0.0, growth(0)), k) : 0;
        const auto free_time = [&](double t) {
            const double now = sign * (dot(flight.velocity_at(t), tangent) - ball.radius * ball.spin) -
                               2 * std::abs(sliding_force) * t - (friction.begins ? slip : 0);
            return now > 0 ? safe_time(now, growth(t), k) : 0;
        };
        constexpr double longest = 1e6;  // s
        motion.until = time + conservative_advancement(free_time, first, longest, steps_left);
    }

    /// The path on a curved or turning surface.
    void move_on_curve(double t1) {
        Path& path = motion.path;
        const Vec2 velocity = path.flight.velocity;
        TaylorPath& taylor = path.taylor.emplace_back();
        const Loads loads = guide.straight ? expand_on_line(velocity, taylor.displacement)
                                           : expand_on_circle(velocity, taylor.displacement);
        path.flight = {guide.pivot + taylor.displacement[0], velocity, {}, 0};
        const double stop = contact.turning->rate_at(time) != 0 ? contact.turning->stop : never_touch;
        const double valid = time + valid_time(taylor.displacement, 1e-17 * ball.radius);
        const double h = std::min({valid, stop, t1}) - time;
        double power = 1;
        for (int k = 1; k <= order; ++k, power *= h) {
            taylor.top_speed += k * length(taylor.displacement[k]) * power;
            if (k < order)
                taylor.top_acceleration += (k + 1) * k * length(taylor.displacement[k + 1]) * power;
        }
        const double separates = time + first_below_zero(loads.force, h);
        motion.until = std::min({valid, stop, separates});
        motion.separates = motion.until == separates;
        if (contact.friction <= 0) return;

        Series<double> more{}, less{};  // friction to spare in both directions; or, sliding, the slip
        const double sign = friction.slide > 0 ? 1 : -1;
        more[0] = sign * (along - ball.radius * ball.spin);
        for (int k = 0; k + 1 < order; ++k) {
            const double sliding_force = friction.slide * loads.force[k];
            taylor.spin[k + 1] =
                (friction.rolls ? loads.slide[k] : 2 * sliding_force) / (ball.radius * (k + 1));
            if (!friction.rolls) {
                more[k + 1] = sign * (loads.slide[k] - 2 * sliding_force) / (k + 1);
                continue;
            }
            more[k] = contact.friction * loads.force[k] + loads.slide[k] / 2;
            less[k] = contact.friction * loads.force[k] - loads.slide[k] / 2;
        }
        // A ball that begins to slip does so faster at first.
        if (friction.begins) more[0] = 0, more[1] = std::max(0.0, more[1]);
        double switches = first_below_zero(more, h);
        if (friction.rolls) switches = std::min(switches, first_below_zero(less, h));
        if (time + switches < motion.until) {
            motion.until = time + switches;
            motion.separates = false;
        }
    }

    Loads expand_on_line(Vec2 velocity, Series<Vec2>& displacement) const {
        const double w = guide.rate, d = guide.offset, c = external.drag;
        const Series<Vec2> t = turning_vector(-perp(contact.normal), w),
                           n = turning_vector(contact.normal, w);
        Series<double> s{};
        Loads loads;
        s[0] = guide.s;
        s[1] = dot(velocity, t[0]) + d * w;
        for (int k = 0; k + 2 <= order; ++k) {
            const double speed = (k + 1) * s[k + 1] - (k == 0 ? d * w : 0);
            const double force = 2 * w * (k + 1) * s[k + 1] - (k == 0 ? d * w * w : 0) -
                                 dot(n[k], external.gravity) + c * w * s[k];
            const double tangential = w * w * s[k] + dot(t[k], external.gravity) - c * speed;
            const double bend = friction.share() * tangential + friction.slide * force;
            s[k + 2] = bend / ((k + 1) * (k + 2));
            loads.force[k] = force;
            loads.slide[k] = -bend;
        }
        for (int k = 0; k <= order; ++k) displacement[k] = product(s, t, k) + d * n[k];
        return loads;
    }

    Loads expand_on_circle(Vec2 velocity, Series<Vec2>& displacement) const {
        const double c = external.drag, radius = guide.radius,
                     side = dot(guide.out, contact.normal) > 0 ? 1 : -1;
        const Series<Vec2> center = turning_vector(guide.arm, guide.rate);
        Series<Vec2> felt{};  // gravity and inertial forces in the frame of the moving centre
        for (int k = 0; k + 2 <= order; ++k)
            felt[k] = (k == 0 ? external.gravity : Vec2{}) - (k + 1) * (k + 2) * center[k + 2] -
                      c * (k + 1) * center[k + 1];
        Series<Vec2> out{}, tangent{};  // out' = turn·tangent, tangent' = −turn·out
        Series<double> turn{};
        Loads loads;
        out[0] = guide.out;
        tangent[0] = perp(guide.out);
        turn[0] = dot(velocity - cross(guide.rate, guide.arm), tangent[0]) / radius;
        for (int k = 0; k < order; ++k) {
            const double force = -side * (product(out, felt, k, dot) + radius * product(turn, turn, k));
            const double tangential = product(tangent, felt, k, dot) - c * radius * turn[k];
            const double bend = friction.share() * tangential - side * friction.slide * force;
            turn[k + 1] = bend / (radius * (k + 1));
            const Vec2 turned = product(turn, tangent, k) / (k + 1);
            out[k + 1] = turned;
            tangent[k + 1] = perp(turned);
            loads.force[k] = force;
            loads.slide[k] = side * bend;
        }
        for (int k = 0; k <= order; ++k) displacement[k] = center[k] + radius * out[k];
        return loads;
    }

    /// First time in [0, h] at which the series falls below zero.
    double first_below_zero(const Series<double>& f, double h) {
        double k2 = 0, power = 1;
        for (int k = 2; k <= order; ++k, power *= h) k2 += k * (k - 1) * std::abs(f[k]) * power;
        const double tolerance = 1e-15 * (std::abs(f[0]) + k2 * h * h + std::abs(f[1]) * h);
        const auto free_time = [&](double t) {
            double value = 0, slope = 0;
            for (int k = order; k >= 0; --k) {
                slope = slope * t + value;
                value = value * t + f[k];
            }
            if (value <= tolerance && slope < 0) return 0.0;
            return safe_time(std::max(value, tolerance), slope, k2);
        };
        return conservative_advancement(free_time, 0, h, steps_left);
    }
};

}  // namespace

RestingContact resting_contact_at(const Feature& feature, const Turning& turning, const Ball& ball,
                                  Vec2 normal, double time, const ExternalForces& external) {
    RestingContact contact{&feature, &turning, normal, {}};
    const Guide guide = guide_of(contact, ball, time);
    contact.surface_velocity = turning.velocity_at(ball.position - ball.radius * normal, time);
    const Vec2 driving = external.gravity - external.drag * ball.velocity;
    const double normal_part = dot(driving, normal);
    contact.tangential = dot(driving, perp(normal));
    if (guide.straight) {
        const double slide = dot(ball.velocity, -perp(normal)) + guide.offset * guide.rate;
        contact.force = 2 * slide * guide.rate - guide.offset * guide.rate * guide.rate - normal_part;
        contact.tangential -= guide.rate * guide.rate * guide.s;
    } else {
        const double side = dot(guide.out, normal) > 0 ? 1 : -1;
        const double turn = dot(ball.velocity - cross(guide.rate, guide.arm), perp(guide.out)) / guide.radius;
        contact.force = -normal_part - side * guide.radius * turn * turn -
                        guide.rate * guide.rate * dot(guide.arm, normal);
        contact.tangential += guide.rate * guide.rate * dot(guide.arm, perp(normal));
    }
    return contact;
}

void ConstrainedPath::fly(const Flight& flight, double time) {
    path.start = time;
    path.flight = flight;
    path.taylor.clear();
    until = never_touch;
    spin_rate = 0;
    roll = {};
    separates = false;
}

double friction_of(const RestingContact& contact, const Ball& ball) {
    const Friction friction = friction_state(contact, ball);
    return friction.rolls ? -contact.tangential / 3 : -friction.slide * contact.force;
}

bool constrain(const RestingContact& contact, const Ball& ball, double time, double t1,
               const ExternalForces& external, ConstrainedPath& motion) {
    const Vec2 n = contact.normal, tangent = perp(n);
    PathOnSurface path{contact, ball, external, time, motion};
    motion.fly({{}, path.along * tangent + contact.surface_velocity, {}, external.drag}, time);
    if (const Guide& guide = path.guide; !guide.straight || guide.rate != 0) {
        path.move_on_curve(t1);
    } else {
        motion.path.flight.position = guide.pivot + (guide.offset * n - guide.s * tangent);
        path.slide();
    }
    const double last = std::min(motion.until, t1);
    const double end = end_of_face(*contact.feature, *contact.turning, motion.path, ball.radius, time, last,
                                   path.steps_left);
    if (end <= last) {
        motion.until = end;
        motion.separates = true;
    }
    if (motion.until > t1) motion.until = never_touch;
    return path.steps_left >= 0;
}

}  // namespace flipside::custom
