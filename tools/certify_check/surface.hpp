#pragma once
/// How balls move, and how they lie to what they may touch.

#include <set>

#include "certificate.hpp"
#include "jet.hpp"

namespace certificate {

constexpr auto vec = [](const Vec& v) { return V{v[0], v[1]}; };

struct Motion {
    V place, velocity;  // of a ball's centre
    Jet spin;

    Motion(const Leg& leg, const Jet& time) {
        const Jet t = time - leg.start;
        const Jet e = leg.drag > 0 ? (1.0 - exp(-leg.drag * t)) / leg.drag : t;
        const Jet f = leg.drag > 0 ? (t - e) / leg.drag : 0.5 * t * t;
        V more;
        for (std::size_t k = leg.displacements.size(); k-- > 0;) more = t * more + vec(leg.displacements[k]);
        for (std::size_t k = leg.spins.size(); k-- > 0;) spin = t * spin + leg.spins[k];
        place = vec(leg.position) + e * vec(leg.velocity) + f * vec(leg.acceleration) + t * t * more;
        velocity = derivative(place);
        spin = leg.roll == Vec{} ? leg.spin + t * spin : dot(vec(leg.roll), velocity);
    }
};

/// What a ball may touch, as long as nothing changes about it: a feature of a part, or a ball on a segment.
struct Other {
    double from, until;
    const Part* part = nullptr;
    const Feature* feature = nullptr;
    Span turn{};
    const Ball* ball = nullptr;
    const Leg* leg = nullptr;
};

/// What touches a ball, with the force that the certificate states, if it does, and how exactly it touches.
struct Contact {
    const Other& on;
    const Force* force;
    double gap, overlap;  // radii
};

/// All that may be touched, in time intervals over which it does not change.
inline std::vector<Other> others_of(const Run& run) {
    std::vector<Other> others;
    for (const Feature& feature : run.features) {
        const Part& part = run.parts.at(feature.part);
        std::set<double> times{0, run.seconds};
        for (const Span& span : part.turns) times.insert(std::clamp(span.since, 0.0, run.seconds));
        for (const Absence& one : run.absences)
            if (one.part == feature.part) times.insert({one.from, one.until});
        for (auto from = times.begin(), until = std::next(from); until != times.end(); ++from, ++until) {
            Span turn = part.turns.empty() ? Span{} : part.turns[0];
            for (const Span& span : part.turns)
                if (span.since <= *from) turn = span;
            others.push_back({*from, *until, &part, &feature, turn, nullptr, nullptr});
        }
    }
    for (const Ball& ball : run.balls)
        for (const Leg& leg : ball.legs)
            others.push_back({leg.start, leg.end, nullptr, nullptr, {}, &ball, &leg});
    return others;
}
inline bool can_touch(const Ball& ball, const Other& other) {
    const auto meets = [&](const auto& one) {
        return (ball.layer & one.collides_with) != 0 && (one.layer & ball.collides_with) != 0;
    };
    return other.ball != nullptr ? meets(*other.ball) : meets(*other.part);
}

/// Past an end where it is joined smoothly to what follows a face may reach so far, m and rad: the scenes'
/// rules.
constexpr double joint_distance = 1e-6, joint_angle = 1e-3;

struct Lie {
    Jet gap;
    V normal, velocity;                 // normal: unit, to the ball; velocity: of the other, where they touch
    Jet rim = 0.0;                      // what the spin of another ball adds to that
    bool apart = false, facing = true;  // certainly not within the ends of the feature; certainly within

    Lie(const Other& other, const V& place, double r, const Jet& t) {
        if (other.ball != nullptr) {
            const Motion theirs(*other.leg, t);
            to_circle(place - theirs.place, other.ball->radius, r, 1);
            velocity = theirs.velocity, rim = other.ball->radius * theirs.spin;
            return;
        }
        const Span& span = other.turn;
        const V pivot = vec(other.part->pivot), off = place - pivot;
        const V turn =
            V::from_angle(span.rate == 0 ? Jet(span.angle) : span.angle + span.rate * (t - span.since));
        to_feature(*other.feature, V{dot(turn, off), cross(turn, off)} + pivot, r);
        normal = normal.x * turn + normal.y * perp(turn);
        velocity = span.rate * perp(place - r * normal - pivot);
    }

  private:
    /// From inside it, if side is -1.
    void to_circle(const V& from_center, double radius, double r, double side) {
        const Jet far = length(from_center);
        gap = side * (far - radius) - r, normal = side * (from_center / far);
    }
    void to_feature(const Feature& f, const V& place, double r) {
        const V at = place - vec(f.points.at(0));
        I past[2];  // how far the place is from both ends, above 0 where it is within
        if (f.type == "line") {
            const V way = vec(f.points.at(1)) - vec(f.points[0]), along = way / length(way);
            const Jet side = cross(along, at);
            const double sign = low(side[0]) + high(side[0]) < 0 ? -1 : 1;
            gap = sign * side - r, normal = sign * perp(along);
            past[0] = dot(along, at)[0], past[1] = length(way)[0] - past[0];
        } else {
            const I far = length(at)[0];
            to_circle(at, f.radius, r, f.type == "arc" && low(far) + high(far) < 2 * f.radius ? -1 : 1);
            // An arc that is too narrow for the ball is met at its ends alone.
            apart = f.type == "arc" && high(far) < f.radius && f.radius <= r;
            if (f.points.size() < 3) return;
            past[0] = cross(vec(f.points[1]) - vec(f.points[0]), at)[0] / f.radius;
            past[1] = cross(at, vec(f.points[2]) - vec(f.points[0]))[0] / f.radius;
        }
        const auto reaches = [&](std::size_t end) {
            return low(past[end]) >= -(f.joined[end] ? joint_distance + joint_angle * r : 1e-9 * r);
        };
        const bool off[] = {high(past[0]) < 0, high(past[1]) < 0};
        facing = f.wide ? reaches(0) || reaches(1) : reaches(0) && reaches(1);
        apart |= f.wide ? off[0] && off[1] : off[0] || off[1];
    }
};

/// Whether this is the line of a gate, and a ball's centre is on the side from which its normal points away.
inline bool is_behind(const Other& gate, const V& place, const Jet& t) {
    return gate.feature->type == "line" &&
           low(dot(Lie(gate, place, 0, t).normal, vec(gate.part->gate))[0]) < 0;
}

/// Whether a target is raised, as `leg` starts, that the ball overlapped and now touches.
inline bool is_moved_by_target(const Run& run, const std::vector<Other>& others, const Ball& ball,
                               const Leg& before, const Leg& leg, double bound) {
    const auto gap_on = [&](const Leg& one, const Other& target) {
        const Lie at(target, Motion(one, {I(leg.start), 1}).place, ball.radius, {I(leg.start), 1});
        return at.facing ? at.gap[0] : I(HUGE_VAL);
    };
    return std::ranges::any_of(others, [&](const Other& one) {
        return one.part != nullptr && one.from == leg.start && can_touch(ball, one) &&
               std::ranges::any_of(run.absences,
                                   [&](const Absence& down) {
                                       return down.ball < 0 && down.until == leg.start &&
                                              one.part == &run.parts.at(down.part);
                                   }) &&
               high(gap_on(before, one)) < 0 && size_of(gap_on(leg, one)) <= bound * ball.radius;
    });
}

}  // namespace certificate
