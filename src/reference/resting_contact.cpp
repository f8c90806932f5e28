#include "reference/resting_contact.hpp"

namespace flipside::reference {

template <class R>
RestingContact<R> resting_contact_at(const Feature<R>& feature, const Turning<R>* turning,
                                     const Body<R>& ball, const R& time, const R& friction,
                                     const ExternalForces<R>& external, const R& snap) {
    RestingContact<R> contact;
    contact.feature = &feature;
    contact.turning = turning;
    contact.friction = friction;
    V<R> turn{R(1), R(0)};
    if (turning != nullptr) {
        contact.rate = turning->rate;
        contact.pivot = turning->pivot;
        turn = from_angle(turning->angle_at(time));
    }
    const auto posed = [&](const V<R>& p) {
        return turning != nullptr ? contact.pivot + rotated(p - contact.pivot, turn) : p;
    };
    const R& w = contact.rate;
    if (const auto* line = std::get_if<Line<R>>(&feature.is)) {
        const V<R> start = posed(line->start);
        const V<R> left = perp(turning != nullptr ? rotated(line->along, turn) : line->along);
        contact.straight = true;
        if (turning == nullptr) contact.pivot = start;
        contact.normal = dot(ball.position - start, left) >= 0 ? left : -left;
        contact.tangent = -perp(contact.normal);
        contact.side = R(-1);
        const R gap = dot(ball.position - start, contact.normal) - ball.radius;
        contact.along = dot(ball.position - contact.pivot, contact.tangent);
        contact.offset = dot(start - contact.pivot, contact.normal) + ball.radius;
        if (magnitude(gap) > snap) contact.offset += gap;
    } else {
        const auto& curve = std::get<Curve<R>>(feature.is);
        const V<R> center = posed(curve.center);
        if (turning == nullptr) contact.pivot = center;
        contact.arm = center - contact.pivot;
        const V<R> q = ball.position - center;
        const R far = reference::length(q);
        contact.out = unit(q);
        contact.side = R(curve.is_circle || far >= curve.radius ? 1 : -1);
        contact.normal = contact.side * contact.out;
        contact.tangent = perp(contact.out);
        const R exact = curve.radius + contact.side * ball.radius;
        contact.length = magnitude(far - exact) > snap ? far : exact;
    }
    const V<R> point = ball.position - ball.radius * contact.normal;
    const V<R> relative = ball.velocity - cross(w, point - contact.pivot);
    contact.separating_speed = dot(relative, contact.normal);
    contact.slip = dot(relative, contact.tangent) - contact.side * ball.radius * ball.spin;
    const V<R> applied = external.gravity - external.drag * ball.velocity;
    contact.tangential = dot(applied, contact.tangent);
    if (contact.straight) {
        contact.tangential_speed = dot(ball.velocity, contact.tangent) + w * contact.offset;
        contact.tangential += w * w * contact.along;
        contact.force =
            w * (2 * contact.tangential_speed - w * contact.offset) - dot(applied, contact.normal);
    } else {
        contact.tangential_speed = dot(ball.velocity - cross(w, contact.arm), contact.tangent);
        contact.tangential += w * w * dot(contact.arm, contact.tangent);
        const R held = dot(applied, contact.out) + w * w * dot(contact.arm, contact.out);
        contact.force =
            -contact.side * (held + contact.tangential_speed * contact.tangential_speed / contact.length);
    }
    return contact;
}

template <class R>
ContactFriction<R> friction_of(const RestingContact<R>& contact, const Body<R>& ball) {
    using std::sqrt;
    if (!(contact.friction > 0)) return {};
    const R most = contact.friction * (contact.force > 0 ? contact.force : R(0));
    const R scale =
        magnitude(contact.tangential_speed) + ball.radius * magnitude(ball.spin) + magnitude(contact.slip);
    const R none = 4096 * epsilon<R>() * (scale + sqrt(ball.radius * (most + magnitude(contact.tangential))));
    const auto sliding = [&](int sign, bool begins = false) {
        return ContactFriction<R>{FrictionMode::slides, R(-sign * most), R(sign), begins};
    };
    if (contact.slip > none) return sliding(1);
    if (contact.slip < -none) return sliding(-1);
    if (magnitude(contact.tangential) < 3 * most * (1 - 1024 * epsilon<R>()) || contact.tangential == 0)
        return {FrictionMode::rolls, R(-contact.tangential / 3), R(0)};
    return sliding(contact.tangential > 0 ? 1 : -1, true);
}

namespace {

template <class R>
Tolerance<R> speed_tolerance(const R& speed, const Body<R>& ball) {
    using std::sqrt;
    return {rounding_speed(speed), 64 * epsilon<R>() * (speed + sqrt(ball.radius))};
}

template <class R>
ConstrainedPath<R> start_of_path(const Body<R>& ball, const R& time) {
    ConstrainedPath<R> constrained;
    constrained.path.start = time;
    constrained.path.angle = ball.angle;
    constrained.path.spin = ball.spin;
    return constrained;
}

/// The path on a static line: a closed form.
template <class R>
ConstrainedPath<R> line_path(const RestingContact<R>& contact, const ContactFriction<R>& contact_friction,
                             const Body<R>& ball, const R& time, const R& last,
                             const ExternalForces<R>& external) {
    ConstrainedPath<R> constrained = start_of_path(ball, time);
    Path<R>& path = constrained.path;
    const V<R>& tangent = contact.tangent;
    const R applied = dot(external.gravity, tangent);
    path.position = contact.pivot + (contact.along * tangent + contact.offset * contact.normal);
    path.velocity = contact.tangential_speed * tangent;
    path.drag = external.drag;
    path.acceleration = applied * tangent;
    const R share = R(2) / 3;
    if (contact_friction.mode == FrictionMode::rolls) {
        path.acceleration = share * path.acceleration;
        path.drag = share * external.drag;
        path.roll = R(-1 / ball.radius) * tangent;
        path.spin = -contact.tangential_speed / ball.radius;
        if (!(external.drag > 0)) return constrained;
        // It rolls while the tangential force is below three times the limit of friction.
        for (const int sign : {1, -1}) {
            const auto spare = [&](const R& t) {
                const Motion<R> m = path.at(t);
                const R tangential = applied - external.drag * dot(m.velocity, tangent);
                const R change = -external.drag * share * tangential;
                return Value<R>{3 * contact.friction * contact.force - sign * tangential, -sign * change};
            };
            const R curvature = share * share * external.drag * external.drag * magnitude(contact.tangential);
            constrained.until = std::min(constrained.until,
                                         first_falling_root(spare, time, last, curvature,
                                                            speed_tolerance(magnitude(contact.force), ball)));
        }
        return constrained;
    }
    path.acceleration += contact_friction.force * tangent;
    path.spin_rate = -2 * contact.side * contact_friction.force / ball.radius;
    if (contact_friction.mode == FrictionMode::frictionless) return constrained;
    const auto slip = [&](const R& t) {
        const Motion<R> m = path.at(t);
        const R spin = path.spin + (t - time) * path.spin_rate;
        const R faster = dot(path.acceleration - path.drag * m.velocity, tangent);
        return Value<R>{
            contact_friction.sign * (dot(m.velocity, tangent) - contact.side * ball.radius * spin),
            contact_friction.sign * (faster + 2 * contact_friction.force)};
    };
    const R curvature = path.drag * (magnitude(dot(path.acceleration, tangent)) +
                                     path.drag * magnitude(contact.tangential_speed));
    const Tolerance<R> tolerance = speed_tolerance(magnitude(contact.slip), ball);
    // A ball that begins to slip does so faster and faster, until drag has slowed that.
    R from = time;
    if (contact_friction.begins)
        from += free_step(tolerance.value, std::max(R(0), slip(time).slope), curvature);
    constrained.until = first_falling_root(slip, from, last, curvature, tolerance);
    return constrained;
}

template <class T, class R>
T product(const Series<R, R>& a, const Series<T, R>& b, std::size_t n) {
    T sum = a[0] * b[n];
    for (std::size_t k = 1; k <= n; ++k) sum += a[k] * b[n - k];
    return sum;
}
template <class R>
R product(const Series<V<R>, R>& a, const Series<V<R>, R>& b, std::size_t n) {
    R sum = dot(a[0], b[n]);
    for (std::size_t k = 1; k <= n; ++k) sum += dot(a[k], b[n - k]);
    return sum;
}
/// The series of a vector that turns at a rate.
template <class R>
Series<V<R>, R> turning(const V<R>& begin, const R& rate) {
    Series<V<R>, R> series;
    series[0] = begin;
    for (std::size_t k = 1; k < series.size(); ++k)
        series[k] = rate / static_cast<int>(k) * perp(series[k - 1]);
    return series;
}

/// Taylor series of a resting contact; the position is in path.displacements, with its start in [0].
template <class R>
struct Expansion {
    Series<R, R> force{};       ///< N
    Series<R, R> tangential{};  ///< along the tangent, but for friction
    Series<R, R> speed{};       ///< s' or Lφ'
};

/// The tangential acceleration with friction.
template <class R>
R rubbed(const ContactFriction<R>& contact_friction, const RestingContact<R>& contact, const R& tangential,
         const R& force) {
    if (contact_friction.mode == FrictionMode::rolls) return tangential * 2 / 3;
    return tangential - contact_friction.sign * contact.friction * force;
}

template <class R>
Expansion<R> expand_straight(const RestingContact<R>& contact, const ContactFriction<R>& contact_friction,
                             const ExternalForces<R>& external, Series<V<R>, R>& position) {
    constexpr std::size_t order = taylor_order<R>;
    const R &w = contact.rate, &d = contact.offset, &c = external.drag;
    const auto t = turning(contact.tangent, w), n = turning(contact.normal, w);
    Series<R, R> s{};
    Expansion<R> e;
    s[0] = contact.along;
    e.speed[0] = contact.tangential_speed;
    for (std::size_t k = 0; k < order; ++k) {
        const auto next = static_cast<int>(k) + 1;
        s[k + 1] = e.speed[k] / next;
        e.force[k] = 2 * w * e.speed[k] - dot(n[k], external.gravity) + c * w * s[k];
        e.tangential[k] = w * w * s[k] + dot(t[k], external.gravity) - c * e.speed[k];
        if (k == 0) {
            e.force[k] -= w * w * d;
            e.tangential[k] += c * w * d;
        }
        e.speed[k + 1] = rubbed(contact_friction, contact, e.tangential[k], e.force[k]) / next;
    }
    for (std::size_t k = 0; k <= order; ++k) position[k] = product(s, t, k) + d * n[k];
    return e;
}

template <class R>
Expansion<R> expand_curved(const RestingContact<R>& contact, const ContactFriction<R>& contact_friction,
                           const ExternalForces<R>& external, Series<V<R>, R>& position) {
    constexpr std::size_t order = taylor_order<R>;
    const R &w = contact.rate, &l = contact.length, &c = external.drag;
    const auto center = turning(contact.arm, w);
    Series<V<R>, R> applied, out, tangent;
    Series<R, R> turn{};  // φ'
    for (std::size_t k = 0; k <= order; ++k) {
        applied[k] = w * w * center[k] - c * cross(w, center[k]);
        if (k == 0) applied[k] += external.gravity;
    }
    Expansion<R> e;
    out[0] = contact.out;
    tangent[0] = contact.tangent;
    turn[0] = contact.tangential_speed / l;
    e.speed[0] = contact.tangential_speed;
    for (std::size_t k = 0; k < order; ++k) {
        const auto next = static_cast<int>(k) + 1;
        e.force[k] = -contact.side * (product(out, applied, k) + l * product(turn, turn, k));
        e.tangential[k] = product(tangent, applied, k) - c * e.speed[k];
        e.speed[k + 1] = rubbed(contact_friction, contact, e.tangential[k], e.force[k]) / next;
        turn[k + 1] = e.speed[k + 1] / l;
        out[k + 1] = product(turn, tangent, k) / R(next);
        tangent[k + 1] = -(product(turn, out, k) / R(next));
    }
    for (std::size_t k = 0; k <= order; ++k) position[k] = center[k] + l * out[k];
    return e;
}

/// Time for which the last terms of the series stay below a small part of the rounding of the radius.
template <class R>
R series_valid_for(const Series<V<R>, R>& series, const R& radius) {
    R h = infinity<R>();
    for (const std::size_t k : {taylor_order<R>, taylor_order<R> - 1, taylor_order<R> - 2}) {
        const R term = length(series[k]);
        if (term > 0) h = std::min(h, root(R(epsilon<R>() * radius / (64 * term)), static_cast<int>(k)));
    }
    return h;
}

/// First time after `time` at which a positive series becomes negative.
template <class R>
R first_falling_root_after(const Series<R, R>& f, const R& time, const R& h) {
    R curvature{}, power(1), scale = magnitude(f[0]), slopes{};
    for (std::size_t k = 1; k < f.size() - 1; ++k) {
        const auto n = static_cast<int>(k);
        slopes += n * magnitude(f[k]) * power;
        if (k >= 2) curvature += n * (n - 1) * magnitude(f[k]) * power / h;
        power *= h;
        scale += magnitude(f[k]) * power;
    }
    const auto value = [&](const R& at) {
        const R t = at - time;
        R sum{}, slope{};
        for (std::size_t k = f.size() - 1; k-- > 0;) {
            slope = slope * t + sum;
            sum = sum * t + f[k];
        }
        return Value<R>{sum, slope};
    };
    return first_falling_root(value, time, R(time + h), curvature,
                              Tolerance<R>{rounding_speed(slopes), 64 * epsilon<R>() * scale});
}

template <class R>
void bound_series(Path<R>& path, const R& h) {
    path.series_bounds = {};
    R power(1);
    for (std::size_t k = 1; k <= taylor_order<R>; ++k) {
        const auto n = static_cast<int>(k);
        path.series_bounds.speed += n * length(path.displacements[k]) * power;
        if (k >= 2)
            path.series_bounds.acceleration += n * (n - 1) * length(path.displacements[k]) * (power / h);
        power *= h;
    }
}

/// When the ball begins or ceases to roll.
template <class R>
R mode_change(const RestingContact<R>& contact, const ContactFriction<R>& contact_friction,
              const Expansion<R>& e, const R& time, const R& h) {
    if (contact_friction.mode == FrictionMode::frictionless) return infinity<R>();
    Series<R, R> more{}, less{};
    if (contact_friction.mode == FrictionMode::rolls) {
        for (std::size_t k = 0; k < more.size(); ++k) {
            more[k] = 3 * contact.friction * e.force[k] + e.tangential[k];
            less[k] = 3 * contact.friction * e.force[k] - e.tangential[k];
        }
        return std::min(first_falling_root_after(more, time, h), first_falling_root_after(less, time, h));
    }
    more[0] = contact_friction.sign * contact.slip;
    for (std::size_t k = 0; k + 1 < more.size(); ++k)
        more[k + 1] = (contact_friction.sign * e.tangential[k] - 3 * contact.friction * e.force[k]) /
                      (static_cast<int>(k) + 1);
    // A ball that begins to slip does so faster at first.
    if (contact_friction.begins) more[0] = R(0), more[1] = std::max(R(0), more[1]);
    return first_falling_root_after(more, time, h);
}

/// The path on a curved or turning surface: a Taylor polynomial.
template <class R>
ConstrainedPath<R> series_path(const RestingContact<R>& contact, const ContactFriction<R>& contact_friction,
                               const Body<R>& ball, const R& time, const R& last,
                               const ExternalForces<R>& external) {
    ConstrainedPath<R> constrained = start_of_path(ball, time);
    Path<R>& path = constrained.path;
    path.is_series = true;
    const Expansion<R> e = contact.straight
                               ? expand_straight(contact, contact_friction, external, path.displacements)
                               : expand_curved(contact, contact_friction, external, path.displacements);
    path.position = contact.pivot + path.displacements[0];
    path.velocity = path.displacements[1];
    if (contact_friction.mode != FrictionMode::frictionless) {
        for (std::size_t k = 0; k < taylor_order<R>; ++k) {
            const R push = contact_friction.mode == FrictionMode::rolls
                               ? R(-e.tangential[k] / 3)
                               : R(-contact_friction.sign * contact.friction * e.force[k]);
            path.spins[k + 1] = -2 * contact.side * push / (ball.radius * (static_cast<int>(k) + 1));
        }
    }
    if (contact_friction.mode == FrictionMode::rolls)
        path.spin += contact.slip / (contact.side * ball.radius);
    const R good = series_valid_for(path.displacements, ball.radius);
    constrained.until = std::min(last, R(time + good));
    if (contact.turning != nullptr) constrained.until = std::min(constrained.until, contact.turning->stop);
    const R h = constrained.until - time;
    if (!(h > 0)) return constrained;
    bound_series(path, h);
    const R falls = first_falling_root_after(e.force, time, h);
    const R other = mode_change(contact, contact_friction, e, time, h);
    constrained.separates = falls <= constrained.until && falls <= other;
    constrained.until = std::min({constrained.until, falls, other});
    return constrained;
}

}  // namespace

template <class R>
ConstrainedPath<R> constrain(const RestingContact<R>& contact, const ContactFriction<R>& contact_friction,
                             const Body<R>& ball, const R& time, const R& last,
                             const ExternalForces<R>& external) {
    const bool closed = contact.straight && contact.rate == 0;
    ConstrainedPath<R> found = closed ? line_path(contact, contact_friction, ball, time, last, external)
                                      : series_path(contact, contact_friction, ball, time, last, external);
    const View<R> view{found.path, contact.turning};
    const R end = leaves_face(*contact.feature, view, ball.radius, time, std::min(found.until, last));
    if (end <= found.until && end <= last) {
        found.until = end;
        found.separates = true;
    }
    if (found.until > last) found.until = last;
    return found;
}

#define FLIPSIDE_RESTING_CONTACT(R)                                                                        \
    template RestingContact<R> resting_contact_at(const Feature<R>&, const Turning<R>*, const Body<R>&,    \
                                                  const R&, const R&, const ExternalForces<R>&, const R&); \
    template ContactFriction<R> friction_of(const RestingContact<R>&, const Body<R>&);                     \
    template ConstrainedPath<R> constrain(const RestingContact<R>&, const ContactFriction<R>&,             \
                                          const Body<R>&, const R&, const R&, const ExternalForces<R>&);
FLIPSIDE_RESTING_CONTACT(double)
FLIPSIDE_RESTING_CONTACT(Real113)
FLIPSIDE_RESTING_CONTACT(Real226)
#undef FLIPSIDE_RESTING_CONTACT

}  // namespace flipside::reference
