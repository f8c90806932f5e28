#include "reference/grip.hpp"

namespace flipside::reference {

template <class R>
Grip<R> grip_at(const Feature<R>& feature, const Turning<R>* turning, const Body<R>& ball, const R& time,
                const R& friction, const Drive<R>& drive, const R& snap) {
    Grip<R> grip;
    grip.feature = &feature;
    grip.turning = turning;
    grip.friction = friction;
    V<R> turn{R(1), R(0)};
    if (turning != nullptr) {
        grip.rate = turning->rate;
        grip.pivot = turning->pivot;
        turn = from_angle(turning->angle_at(time));
    }
    const auto place = [&](const V<R>& p) {
        return turning != nullptr ? grip.pivot + rotated(p - grip.pivot, turn) : p;
    };
    const R& w = grip.rate;
    if (const auto* line = std::get_if<Line<R>>(&feature.is)) {
        const V<R> start = place(line->start);
        const V<R> left = perp(turning != nullptr ? rotated(line->along, turn) : line->along);
        grip.straight = true;
        if (turning == nullptr) grip.pivot = start;
        grip.normal = dot(ball.position - start, left) >= 0 ? left : -left;
        grip.tangent = -perp(grip.normal);
        grip.side = R(-1);
        const R gap = dot(ball.position - start, grip.normal) - ball.radius;
        grip.along = dot(ball.position - grip.pivot, grip.tangent);
        grip.offset = dot(start - grip.pivot, grip.normal) + ball.radius;
        if (magnitude(gap) > snap) grip.offset += gap;
    } else {
        const auto& curve = std::get<Curve<R>>(feature.is);
        const V<R> center = place(curve.center);
        if (turning == nullptr) grip.pivot = center;
        grip.arm = center - grip.pivot;
        const V<R> q = ball.position - center;
        const R far = reference::length(q);
        grip.out = unit(q);
        grip.side = R(curve.round || far >= curve.radius ? 1 : -1);
        grip.normal = grip.side * grip.out;
        grip.tangent = perp(grip.out);
        const R exact = curve.radius + grip.side * ball.radius;
        grip.length = magnitude(far - exact) > snap ? far : exact;
    }
    const V<R> contact = ball.position - ball.radius * grip.normal;
    const V<R> relative = ball.velocity - cross(w, contact - grip.pivot);
    grip.parting = dot(relative, grip.normal);
    grip.slip = dot(relative, grip.tangent) - grip.side * ball.radius * ball.spin;
    const V<R> pull = drive.gravity - drive.drag * ball.velocity;
    grip.driven = dot(pull, grip.tangent);
    if (grip.straight) {
        grip.passing = dot(ball.velocity, grip.tangent) + w * grip.offset;
        grip.driven += w * w * grip.along;
        grip.force = w * (2 * grip.passing - w * grip.offset) - dot(pull, grip.normal);
    } else {
        grip.passing = dot(ball.velocity - cross(w, grip.arm), grip.tangent);
        grip.driven += w * w * dot(grip.arm, grip.tangent);
        const R held = dot(pull, grip.out) + w * w * dot(grip.arm, grip.out);
        grip.force = -grip.side * (held + grip.passing * grip.passing / grip.length);
    }
    return grip;
}

template <class R>
Rubbing<R> rubbing_of(const Grip<R>& grip, const Body<R>& ball) {
    using std::sqrt;
    if (!(grip.friction > 0)) return {};
    const R most = grip.friction * (grip.force > 0 ? grip.force : R(0));
    const R scale = magnitude(grip.passing) + ball.radius * magnitude(ball.spin) + magnitude(grip.slip);
    const R none = 4096 * epsilon<R>() * (scale + sqrt(ball.radius * (most + magnitude(grip.driven))));
    const auto sliding = [&](int sign) { return Rubbing<R>{Rub::slides, R(-sign * most), R(sign)}; };
    if (grip.slip > none) return sliding(1);
    if (grip.slip < -none) return sliding(-1);
    if (magnitude(grip.driven) < 3 * most * (1 - 1024 * epsilon<R>()) || grip.driven == 0)
        return {Rub::rolls, R(-grip.driven / 3), R(0)};
    return sliding(grip.driven > 0 ? 1 : -1);
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

/// On a line that stands still: a closed form.
template <class R>
Ride<R> slide(const Grip<R>& grip, const Rubbing<R>& rubbing, const Body<R>& ball, const R& time,
              const R& last, const Drive<R>& drive) {
    Ride<R> ride = begin_ride(ball, time);
    Path<R>& path = ride.path;
    const V<R>& tangent = grip.tangent;
    const R pull = dot(drive.gravity, tangent);
    path.position = grip.pivot + (grip.along * tangent + grip.offset * grip.normal);
    path.velocity = grip.passing * tangent;
    path.drag = drive.drag;
    path.acceleration = pull * tangent;
    const R share = R(2) / 3;
    if (rubbing.how == Rub::rolls) {
        path.acceleration = share * path.acceleration;
        path.drag = share * drive.drag;
        path.roll = R(-1 / ball.radius) * tangent;
        path.spin = -grip.passing / ball.radius;
        if (!(drive.drag > 0)) return ride;
        // It rolls while what drives it stays below three times the grip.
        for (const int sign : {1, -1}) {
            const auto spare = [&](const R& t) {
                const Motion<R> m = path.at(t);
                const R driven = pull - drive.drag * dot(m.velocity, tangent);
                const R change = -drive.drag * share * driven;
                return Value<R>{3 * grip.friction * grip.force - sign * driven, -sign * change};
            };
            const R bend = share * share * drive.drag * drive.drag * magnitude(grip.driven);
            ride.until = std::min(
                ride.until, first_fall(spare, time, last, bend, smallest_speed(magnitude(grip.force), ball)));
        }
        return ride;
    }
    path.acceleration += rubbing.force * tangent;
    path.spin_rate = -2 * grip.side * rubbing.force / ball.radius;
    if (rubbing.how == Rub::none || !(rubbing.sign * grip.slip > 0)) return ride;
    const auto slip = [&](const R& t) {
        const Motion<R> m = path.at(t);
        const R spin = path.spin + (t - time) * path.spin_rate;
        const R faster = dot(path.acceleration - path.drag * m.velocity, tangent);
        return Value<R>{rubbing.sign * (dot(m.velocity, tangent) - grip.side * ball.radius * spin),
                        rubbing.sign * (faster + 2 * rubbing.force)};
    };
    const R bend =
        path.drag * (magnitude(dot(path.acceleration, tangent)) + path.drag * magnitude(grip.passing));
    ride.until = first_fall(slip, time, last, bend, smallest_speed(magnitude(grip.slip), ball));
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

/// Expansions of a ride in time; the position is in path.displacements, with its start in [0].
template <class R>
struct Expansion {
    Series<R, R> force{};   ///< N
    Series<R, R> driven{};  ///< along the tangent, but for friction
    Series<R, R> speed{};   ///< s' or Lφ'
};

/// What friction makes of the tangential acceleration.
template <class R>
R rubbed(const Rubbing<R>& rubbing, const Grip<R>& grip, const R& driven, const R& force) {
    if (rubbing.how == Rub::rolls) return driven * 2 / 3;
    return driven - rubbing.sign * grip.friction * force;
}

template <class R>
Expansion<R> expand_straight(const Grip<R>& grip, const Rubbing<R>& rubbing, const Drive<R>& drive,
                             Series<V<R>, R>& place) {
    constexpr std::size_t order = taylor_order<R>;
    const R &w = grip.rate, &d = grip.offset, &c = drive.drag;
    const auto t = turning(grip.tangent, w), n = turning(grip.normal, w);
    Series<R, R> s{};
    Expansion<R> e;
    s[0] = grip.along;
    e.speed[0] = grip.passing;
    for (std::size_t k = 0; k < order; ++k) {
        const auto next = static_cast<int>(k) + 1;
        s[k + 1] = e.speed[k] / next;
        e.force[k] = 2 * w * e.speed[k] - dot(n[k], drive.gravity) + c * w * s[k];
        e.driven[k] = w * w * s[k] + dot(t[k], drive.gravity) - c * e.speed[k];
        if (k == 0) {
            e.force[k] -= w * w * d;
            e.driven[k] += c * w * d;
        }
        e.speed[k + 1] = rubbed(rubbing, grip, e.driven[k], e.force[k]) / next;
    }
    for (std::size_t k = 0; k <= order; ++k) place[k] = product(s, t, k) + d * n[k];
    return e;
}

template <class R>
Expansion<R> expand_curved(const Grip<R>& grip, const Rubbing<R>& rubbing, const Drive<R>& drive,
                           Series<V<R>, R>& place) {
    constexpr std::size_t order = taylor_order<R>;
    const R &w = grip.rate, &l = grip.length, &c = drive.drag;
    const auto center = turning(grip.arm, w);
    Series<V<R>, R> pull, out, tangent;
    Series<R, R> turn{};  // φ'
    for (std::size_t k = 0; k <= order; ++k) {
        pull[k] = w * w * center[k] - c * cross(w, center[k]);
        if (k == 0) pull[k] += drive.gravity;
    }
    Expansion<R> e;
    out[0] = grip.out;
    tangent[0] = grip.tangent;
    turn[0] = grip.passing / l;
    e.speed[0] = grip.passing;
    for (std::size_t k = 0; k < order; ++k) {
        const auto next = static_cast<int>(k) + 1;
        e.force[k] = -grip.side * (product(out, pull, k) + l * product(turn, turn, k));
        e.driven[k] = product(tangent, pull, k) - c * e.speed[k];
        e.speed[k + 1] = rubbed(rubbing, grip, e.driven[k], e.force[k]) / next;
        turn[k + 1] = e.speed[k + 1] / l;
        out[k + 1] = product(turn, tangent, k) / R(next);
        tangent[k + 1] = -(product(turn, out, k) / R(next));
    }
    for (std::size_t k = 0; k <= order; ++k) place[k] = center[k] + l * out[k];
    return e;
}

/// How long the expansion is good: its last terms stay below a small part of the ball's rounding.
template <class R>
R good_for(const Series<V<R>, R>& series, const R& radius) {
    R h = infinity<R>();
    for (const std::size_t k : {taylor_order<R>, taylor_order<R> - 1, taylor_order<R> - 2}) {
        const R term = length(series[k]);
        if (term > 0) h = std::min(h, root(R(epsilon<R>() * radius / (64 * term)), static_cast<int>(k)));
    }
    return h;
}

/// First time after `time` at which a series that is positive falls through zero.
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

/// When friction changes: it begins to roll, or can no longer.
template <class R>
R switches(const Grip<R>& grip, const Rubbing<R>& rubbing, const Expansion<R>& e, const R& time, const R& h) {
    if (rubbing.how == Rub::none) return infinity<R>();
    Series<R, R> more{}, less{};
    if (rubbing.how == Rub::rolls) {
        for (std::size_t k = 0; k < more.size(); ++k) {
            more[k] = 3 * grip.friction * e.force[k] + e.driven[k];
            less[k] = 3 * grip.friction * e.force[k] - e.driven[k];
        }
        return std::min(falls_after(more, time, h), falls_after(less, time, h));
    }
    if (!(rubbing.sign * grip.slip > 0)) return infinity<R>();
    more[0] = rubbing.sign * grip.slip;
    for (std::size_t k = 0; k + 1 < more.size(); ++k)
        more[k + 1] =
            (rubbing.sign * e.driven[k] - 3 * grip.friction * e.force[k]) / (static_cast<int>(k) + 1);
    return falls_after(more, time, h);
}

/// On anything that bends or turns: a Taylor polynomial.
template <class R>
Ride<R> swing(const Grip<R>& grip, const Rubbing<R>& rubbing, const Body<R>& ball, const R& time,
              const R& last, const Drive<R>& drive) {
    Ride<R> ride = begin_ride(ball, time);
    Path<R>& path = ride.path;
    path.rides = true;
    const Expansion<R> e = grip.straight ? expand_straight(grip, rubbing, drive, path.displacements)
                                         : expand_curved(grip, rubbing, drive, path.displacements);
    path.position = grip.pivot + path.displacements[0];
    path.velocity = path.displacements[1];
    if (rubbing.how != Rub::none) {
        for (std::size_t k = 0; k < taylor_order<R>; ++k) {
            const R push = rubbing.how == Rub::rolls ? R(-e.driven[k] / 3)
                                                     : R(-rubbing.sign * grip.friction * e.force[k]);
            path.spins[k + 1] = -2 * grip.side * push / (ball.radius * (static_cast<int>(k) + 1));
        }
    }
    if (rubbing.how == Rub::rolls) path.spin += grip.slip / (grip.side * ball.radius);
    const R good = good_for(path.displacements, ball.radius);
    ride.until = std::min(last, R(time + good));
    if (grip.turning != nullptr) ride.until = std::min(ride.until, grip.turning->stop);
    const R h = ride.until - time;
    if (!(h > 0)) return ride;
    bound_ride(path, h);
    const R falls = falls_after(e.force, time, h);
    const R other = switches(grip, rubbing, e, time, h);
    ride.lets_go = falls <= ride.until && falls <= other;
    ride.until = std::min({ride.until, falls, other});
    return ride;
}

}  // namespace

template <class R>
Ride<R> ride(const Grip<R>& grip, const Rubbing<R>& rubbing, const Body<R>& ball, const R& time,
             const R& last, const Drive<R>& drive) {
    const bool closed = grip.straight && grip.rate == 0;
    Ride<R> found = closed ? slide(grip, rubbing, ball, time, last, drive)
                           : swing(grip, rubbing, ball, time, last, drive);
    const View<R> view{found.path, grip.turning};
    const R end = leaves_face(*grip.feature, view, ball.radius, time, std::min(found.until, last));
    if (end <= found.until && end <= last) {
        found.until = end;
        found.lets_go = true;
    }
    if (found.until > last) found.until = last;
    return found;
}

#define FLIPSIDE_GRIPS(R)                                                                              \
    template Grip<R> grip_at(const Feature<R>&, const Turning<R>*, const Body<R>&, const R&, const R&, \
                             const Drive<R>&, const R&);                                               \
    template Rubbing<R> rubbing_of(const Grip<R>&, const Body<R>&);                                    \
    template Ride<R> ride(const Grip<R>&, const Rubbing<R>&, const Body<R>&, const R&, const R&,       \
                          const Drive<R>&);
FLIPSIDE_GRIPS(double)
FLIPSIDE_GRIPS(Real113)
FLIPSIDE_GRIPS(Real226)
#undef FLIPSIDE_GRIPS

}  // namespace flipside::reference
