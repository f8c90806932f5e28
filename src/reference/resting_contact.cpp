#include "reference/resting_contact.hpp"

namespace flipside::reference {

template <class R>
RestingContact<R> resting_contact_at(const Feature<R>& feature, const Turning<R>* turning,
                                     const Body<R>& ball, const R& time, const R& friction,
                                     const Drive<R>& drive, const R& snap) {
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
    const auto place = [&](const V<R>& p) {
        return turning != nullptr ? contact.pivot + rotated(p - contact.pivot, turn) : p;
    };
    const R& w = contact.rate;
    if (const auto* line = std::get_if<Line<R>>(&feature.is)) {
        const V<R> start = place(line->start);
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
        const V<R> center = place(curve.center);
        if (turning == nullptr) contact.pivot = center;
        contact.arm = center - contact.pivot;
        const V<R> q = ball.position - center;
        const R far = reference::length(q);
        contact.out = unit(q);
        contact.side = R(curve.round || far >= curve.radius ? 1 : -1);
        contact.normal = contact.side * contact.out;
        contact.tangent = perp(contact.out);
        const R exact = curve.radius + contact.side * ball.radius;
        contact.length = magnitude(far - exact) > snap ? far : exact;
    }
    const V<R> point = ball.position - ball.radius * contact.normal;
    const V<R> relative = ball.velocity - cross(w, point - contact.pivot);
    contact.parting = dot(relative, contact.normal);
    contact.slip = dot(relative, contact.tangent) - contact.side * ball.radius * ball.spin;
    const V<R> driving = drive.gravity - drive.drag * ball.velocity;
    contact.driven = dot(driving, contact.tangent);
    if (contact.straight) {
        contact.passing = dot(ball.velocity, contact.tangent) + w * contact.offset;
        contact.driven += w * w * contact.along;
        contact.force = w * (2 * contact.passing - w * contact.offset) - dot(driving, contact.normal);
    } else {
        contact.passing = dot(ball.velocity - cross(w, contact.arm), contact.tangent);
        contact.driven += w * w * dot(contact.arm, contact.tangent);
        const R held = dot(driving, contact.out) + w * w * dot(contact.arm, contact.out);
        contact.force = -contact.side * (held + contact.passing * contact.passing / contact.length);
    }
    return contact;
}

template <class R>
Rubbing<R> rubbing_of(const RestingContact<R>& contact, const Body<R>& ball) {
    using std::sqrt;
    if (!(contact.friction > 0)) return {};
    const R most = contact.friction * (contact.force > 0 ? contact.force : R(0));
    const R scale = magnitude(contact.passing) + ball.radius * magnitude(ball.spin) + magnitude(contact.slip);
    const R none = 4096 * epsilon<R>() * (scale + sqrt(ball.radius * (most + magnitude(contact.driven))));
    const auto sliding = [&](int sign) { return Rubbing<R>{Rub::slides, R(-sign * most), R(sign)}; };
    if (contact.slip > none) return sliding(1);
    if (contact.slip < -none) return sliding(-1);
    if (magnitude(contact.driven) < 3 * most * (1 - 1024 * epsilon<R>()) || contact.driven == 0)
        return {Rub::rolls, R(-contact.driven / 3), R(0)};
    return sliding(contact.driven > 0 ? 1 : -1);
}

namespace {

template <class R>
Smallest<R> smallest_speed(const R& speed, const Body<R>& ball) {
    using std::sqrt;
    return {rounding_speed(speed), 64 * epsilon<R>() * (speed + sqrt(ball.radius))};
}

template <class R>
Ride<R> begin_ride(const Body<R>& ball, const R& time) {
    Ride<R> ride;
    ride.path.start = time;
    ride.path.angle = ball.angle;
    ride.path.spin = ball.spin;
    return ride;
}

/// The path on a static line: a closed form.
template <class R>
Ride<R> slide(const RestingContact<R>& contact, const Rubbing<R>& rubbing, const Body<R>& ball, const R& time,
              const R& last, const Drive<R>& drive) {
    Ride<R> ride = begin_ride(ball, time);
    Path<R>& path = ride.path;
    const V<R>& tangent = contact.tangent;
    const R driving = dot(drive.gravity, tangent);
    path.position = contact.pivot + (contact.along * tangent + contact.offset * contact.normal);
    path.velocity = contact.passing * tangent;
    path.drag = drive.drag;
    path.acceleration = driving * tangent;
    const R share = R(2) / 3;
    if (rubbing.how == Rub::rolls) {
        path.acceleration = share * path.acceleration;
        path.drag = share * drive.drag;
        path.roll = R(-1 / ball.radius) * tangent;
        path.spin = -contact.passing / ball.radius;
        if (!(drive.drag > 0)) return ride;
        // It rolls while the tangential force is below three times the limit of friction.
        for (const int sign : {1, -1}) {
            const auto spare = [&](const R& t) {
                const Motion<R> m = path.at(t);
                const R driven = driving - drive.drag * dot(m.velocity, tangent);
                const R change = -drive.drag * share * driven;
                return Value<R>{3 * contact.friction * contact.force - sign * driven, -sign * change};
            };
            const R bend = share * share * drive.drag * drive.drag * magnitude(contact.driven);
            ride.until = std::min(ride.until, first_fall(spare, time, last, bend,
                                                         smallest_speed(magnitude(contact.force), ball)));
        }
        return ride;
    }
    path.acceleration += rubbing.force * tangent;
    path.spin_rate = -2 * contact.side * rubbing.force / ball.radius;
    if (rubbing.how == Rub::none || !(rubbing.sign * contact.slip > 0)) return ride;
    const auto slip = [&](const R& t) {
        const Motion<R> m = path.at(t);
        const R spin = path.spin + (t - time) * path.spin_rate;
        const R faster = dot(path.acceleration - path.drag * m.velocity, tangent);
        return Value<R>{rubbing.sign * (dot(m.velocity, tangent) - contact.side * ball.radius * spin),
                        rubbing.sign * (faster + 2 * rubbing.force)};
    };
    const R bend =
        path.drag * (magnitude(dot(path.acceleration, tangent)) + path.drag * magnitude(contact.passing));
    ride.until = first_fall(slip, time, last, bend, smallest_speed(magnitude(contact.slip), ball));
    return ride;
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
    Series<R, R> force{};   ///< N
    Series<R, R> driven{};  ///< along the tangent, but for friction
    Series<R, R> speed{};   ///< s' or Lφ'
};

/// The tangential acceleration with friction.
template <class R>
R rubbed(const Rubbing<R>& rubbing, const RestingContact<R>& contact, const R& driven, const R& force) {
    if (rubbing.how == Rub::rolls) return driven * 2 / 3;
    return driven - rubbing.sign * contact.friction * force;
}

template <class R>
Expansion<R> expand_straight(const RestingContact<R>& contact, const Rubbing<R>& rubbing,
                             const Drive<R>& drive, Series<V<R>, R>& place) {
    constexpr std::size_t order = taylor_order<R>;
    const R &w = contact.rate, &d = contact.offset, &c = drive.drag;
    const auto t = turning(contact.tangent, w), n = turning(contact.normal, w);
    Series<R, R> s{};
    Expansion<R> e;
    s[0] = contact.along;
    e.speed[0] = contact.passing;
    for (std::size_t k = 0; k < order; ++k) {
        const auto next = static_cast<int>(k) + 1;
        s[k + 1] = e.speed[k] / next;
        e.force[k] = 2 * w * e.speed[k] - dot(n[k], drive.gravity) + c * w * s[k];
        e.driven[k] = w * w * s[k] + dot(t[k], drive.gravity) - c * e.speed[k];
        if (k == 0) {
            e.force[k] -= w * w * d;
            e.driven[k] += c * w * d;
        }
        e.speed[k + 1] = rubbed(rubbing, contact, e.driven[k], e.force[k]) / next;
    }
    for (std::size_t k = 0; k <= order; ++k) place[k] = product(s, t, k) + d * n[k];
    return e;
}

template <class R>
Expansion<R> expand_curved(const RestingContact<R>& contact, const Rubbing<R>& rubbing, const Drive<R>& drive,
                           Series<V<R>, R>& place) {
    constexpr std::size_t order = taylor_order<R>;
    const R &w = contact.rate, &l = contact.length, &c = drive.drag;
    const auto center = turning(contact.arm, w);
    Series<V<R>, R> driving, out, tangent;
    Series<R, R> turn{};  // φ'
    for (std::size_t k = 0; k <= order; ++k) {
        driving[k] = w * w * center[k] - c * cross(w, center[k]);
        if (k == 0) driving[k] += drive.gravity;
    }
    Expansion<R> e;
    out[0] = contact.out;
    tangent[0] = contact.tangent;
    turn[0] = contact.passing / l;
    e.speed[0] = contact.passing;
    for (std::size_t k = 0; k < order; ++k) {
        const auto next = static_cast<int>(k) + 1;
        e.force[k] = -contact.side * (product(out, driving, k) + l * product(turn, turn, k));
        e.driven[k] = product(tangent, driving, k) - c * e.speed[k];
        e.speed[k + 1] = rubbed(rubbing, contact, e.driven[k], e.force[k]) / next;
        turn[k + 1] = e.speed[k + 1] / l;
        out[k + 1] = product(turn, tangent, k) / R(next);
        tangent[k + 1] = -(product(turn, out, k) / R(next));
    }
    for (std::size_t k = 0; k <= order; ++k) place[k] = center[k] + l * out[k];
    return e;
}

/// Time for which the last terms of the series stay below a small part of the rounding of the radius.
template <class R>
R good_for(const Series<V<R>, R>& series, const R& radius) {
    R h = infinity<R>();
    for (const std::size_t k : {taylor_order<R>, taylor_order<R> - 1, taylor_order<R> - 2}) {
        const R term = length(series[k]);
        if (term > 0) h = std::min(h, root(R(epsilon<R>() * radius / (64 * term)), static_cast<int>(k)));
    }
    return h;
}

/// First time after `time` at which a positive series becomes negative.
template <class R>
R falls_after(const Series<R, R>& f, const R& time, const R& h) {
    R bend{}, power(1), scale = magnitude(f[0]), slopes{};
    for (std::size_t k = 1; k < f.size() - 1; ++k) {
        const auto n = static_cast<int>(k);
        slopes += n * magnitude(f[k]) * power;
        if (k >= 2) bend += n * (n - 1) * magnitude(f[k]) * power / h;
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
    return first_fall(value, time, R(time + h), bend,
                      Smallest<R>{rounding_speed(slopes), 64 * epsilon<R>() * scale});
}

template <class R>
void bound_ride(Path<R>& path, const R& h) {
    path.ride_bounds = {};
    R power(1);
    for (std::size_t k = 1; k <= taylor_order<R>; ++k) {
        const auto n = static_cast<int>(k);
        path.ride_bounds.speed += n * length(path.displacements[k]) * power;
        if (k >= 2)
            path.ride_bounds.acceleration += n * (n - 1) * length(path.displacements[k]) * (power / h);
        power *= h;
    }
}

/// When the ball begins or ceases to roll.
template <class R>
R switches(const RestingContact<R>& contact, const Rubbing<R>& rubbing, const Expansion<R>& e, const R& time,
           const R& h) {
    if (rubbing.how == Rub::none) return infinity<R>();
    Series<R, R> more{}, less{};
    if (rubbing.how == Rub::rolls) {
        for (std::size_t k = 0; k < more.size(); ++k) {
            more[k] = 3 * contact.friction * e.force[k] + e.driven[k];
            less[k] = 3 * contact.friction * e.force[k] - e.driven[k];
        }
        return std::min(falls_after(more, time, h), falls_after(less, time, h));
    }
    if (!(rubbing.sign * contact.slip > 0)) return infinity<R>();
    more[0] = rubbing.sign * contact.slip;
    for (std::size_t k = 0; k + 1 < more.size(); ++k)
        more[k + 1] =
            (rubbing.sign * e.driven[k] - 3 * contact.friction * e.force[k]) / (static_cast<int>(k) + 1);
    return falls_after(more, time, h);
}

/// The path on a curved or turning surface: a Taylor polynomial.
template <class R>
Ride<R> swing(const RestingContact<R>& contact, const Rubbing<R>& rubbing, const Body<R>& ball, const R& time,
              const R& last, const Drive<R>& drive) {
    Ride<R> ride = begin_ride(ball, time);
    Path<R>& path = ride.path;
    path.rides = true;
    const Expansion<R> e = contact.straight ? expand_straight(contact, rubbing, drive, path.displacements)
                                            : expand_curved(contact, rubbing, drive, path.displacements);
    path.position = contact.pivot + path.displacements[0];
    path.velocity = path.displacements[1];
    if (rubbing.how != Rub::none) {
        for (std::size_t k = 0; k < taylor_order<R>; ++k) {
            const R push = rubbing.how == Rub::rolls ? R(-e.driven[k] / 3)
                                                     : R(-rubbing.sign * contact.friction * e.force[k]);
            path.spins[k + 1] = -2 * contact.side * push / (ball.radius * (static_cast<int>(k) + 1));
        }
    }
    if (rubbing.how == Rub::rolls) path.spin += contact.slip / (contact.side * ball.radius);
    const R good = good_for(path.displacements, ball.radius);
    ride.until = std::min(last, R(time + good));
    if (contact.turning != nullptr) ride.until = std::min(ride.until, contact.turning->stop);
    const R h = ride.until - time;
    if (!(h > 0)) return ride;
    bound_ride(path, h);
    const R falls = falls_after(e.force, time, h);
    const R other = switches(contact, rubbing, e, time, h);
    ride.separates = falls <= ride.until && falls <= other;
    ride.until = std::min({ride.until, falls, other});
    return ride;
}

}  // namespace

template <class R>
Ride<R> ride(const RestingContact<R>& contact, const Rubbing<R>& rubbing, const Body<R>& ball, const R& time,
             const R& last, const Drive<R>& drive) {
    const bool closed = contact.straight && contact.rate == 0;
    Ride<R> found = closed ? slide(contact, rubbing, ball, time, last, drive)
                           : swing(contact, rubbing, ball, time, last, drive);
    const View<R> view{found.path, contact.turning};
    const R end = leaves_face(*contact.feature, view, ball.radius, time, std::min(found.until, last));
    if (end <= found.until && end <= last) {
        found.until = end;
        found.separates = true;
    }
    if (found.until > last) found.until = last;
    return found;
}

#define FLIPSIDE_GRIPS(R)                                                                                  \
    template RestingContact<R> resting_contact_at(const Feature<R>&, const Turning<R>*, const Body<R>&,    \
                                                  const R&, const R&, const Drive<R>&, const R&);          \
    template Rubbing<R> rubbing_of(const RestingContact<R>&, const Body<R>&);                              \
    template Ride<R> ride(const RestingContact<R>&, const Rubbing<R>&, const Body<R>&, const R&, const R&, \
                          const Drive<R>&);
FLIPSIDE_GRIPS(double)
FLIPSIDE_GRIPS(Real113)
FLIPSIDE_GRIPS(Real226)
#undef FLIPSIDE_GRIPS

}  // namespace flipside::reference
