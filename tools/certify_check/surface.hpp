#pragma once
/// How balls move, the lines, arcs and rounds that a primitive consists of, and the gap of a ball to them.

#include <numbers>

#include "jet.hpp"
#include "run.hpp"

namespace certificate {

/// Of a ball's centre, and its spin.
struct Motion {
    V place;
    Jet spin;
};

inline V vec(const Vec& v) {
    return {Jet(v[0]), Jet(v[1])};
}

inline Motion motion_of(const Leg& leg, const Jet& time) {
    const Jet t = time - leg.start;
    Jet e = t, f = 0.5 * t * t, spin = 0.0;
    if (leg.drag > 0) {
        e = (1.0 - exp(-leg.drag * t)) / leg.drag;
        f = (t - e) / leg.drag;
    }
    V more = vec({});
    for (std::size_t k = leg.displacements.size(); k-- > 0;) more = t * more + vec(leg.displacements[k]);
    for (std::size_t k = leg.spins.size(); k-- > 0;) spin = t * spin + leg.spins[k];
    const V place = vec(leg.position) + e * vec(leg.velocity) + f * vec(leg.acceleration) + t * t * more;
    return {place, leg.roll == Vec{} ? leg.spin + t * spin : dot(vec(leg.roll), derivative(place))};
}

/// A line, or a circle or a part of it.
struct Feature {
    enum class Kind {
        line,
        arc,
        round
    } kind = Kind::round;             ///< arcs have two sides, rounds only their outside
    bool full = true, wide = false;   ///< an arc without ends, or of more than half a turn
    V at;                             ///< where the line starts; the centre
    V first, last;                    ///< unit vectors: along the line; to both ends of an arc
    Jet length, radius;               ///< of a line; of a circle
    bool joined[2] = {false, false};  ///< it goes on smoothly past that end: no point is there to be hit
};

/// Ends nearer than this are one joint, m, and tangents that differ by less are smooth there, rad: the
/// scenes' rules. A face may reach so far past such an end.
constexpr double joint_distance = 1e-6, joint_angle = 1e-3;

inline Feature round(const V& center, const Jet& radius) {
    return {Feature::Kind::round, true, false, center, {}, {}, 0.0, radius};
}
inline Feature line(const V& a, const V& b, bool joined_a = false, bool joined_b = false) {
    const Jet far = length(b - a);
    return {Feature::Kind::line, false, false, a, {(b - a).x / far, (b - a).y / far}, {}, far, 0.0,
            {joined_a, joined_b}};
}

inline std::vector<Feature> features_of(const Primitive& primitive, const Run& run) {
    const auto& p = primitive.points;
    const auto at = [&](std::size_t i) { return vec(p.at(i % p.size())); };
    const auto radius = [&](std::size_t i) { return Jet(primitive.radii.at(i)); };
    const auto joined = [&](const V& end) {
        return std::ranges::none_of(run.primitives, [&](const Primitive& other) {
            return other.type == "point" && low(length(vec(other.points.at(0)) - end)[0]) <= joint_distance;
        });
    };
    if (primitive.type == "point") return {round(at(0), 0.0)};
    if (primitive.type == "circle") return {round(at(0), radius(0))};
    if (primitive.type == "arc") {
        const double from = primitive.angles.at(0), to = primitive.angles.at(1);
        const V first = from_angle(from), last = from_angle(to);
        const double turn = to - from, pi = std::numbers::pi;
        return {{Feature::Kind::arc,
                 turn >= 2 * pi,
                 turn > pi,
                 at(0),
                 first,
                 last,
                 0.0,
                 radius(0),
                 {joined(at(0) + radius(0) * first), joined(at(0) + radius(0) * last)}}};
    }
    if (primitive.type == "segment") {
        const bool gate = run.parts.at(primitive.part).gate != Vec{};
        return {line(at(0), at(1), !gate && joined(at(0)), !gate && joined(at(1)))};
    }
    std::vector<Feature> features;
    if (primitive.type == "polygon") {
        for (std::size_t i = 0; i < p.size(); ++i) {
            features.push_back(line(at(i), at(i + 1)));
            features.push_back(round(at(i), 0.0));
        }
        return features;
    }
    if (primitive.type != "taper") throw std::runtime_error("a primitive of type '" + primitive.type + "'");
    // The hull of two circles: their outer tangents touch them where n·(b − a) = r_a − r_b.
    const V way = at(1) - at(0);
    const Jet c = radius(0) - radius(1), squared = dot(way, way);
    for (const double side : {1.0, -1.0}) {
        const V n = (1.0 / squared) * (c * way + side * sqrt(squared - c * c) * perp(way));
        features.push_back(line(at(0) + radius(0) * n, at(1) + radius(1) * n, true, true));
    }
    features.push_back(round(at(0), radius(0)));
    features.push_back(round(at(1), radius(1)));
    return features;
}

/// How a ball lies to a feature.
struct Lie {
    Jet gap;
    V normal;             ///< unit, to the ball
    V velocity;           ///< of the surface where they touch
    bool apart = false;   ///< certainly not within the ends of the feature
    bool facing = false;  ///< certainly within them, joints allowed for
};

inline Lie lie_of(const Feature& f, const Part& part, const Span& span, const V& place, double r,
                  const Jet& t) {
    const V pivot = vec(part.pivot);
    const V turn = from_angle(span.rate == 0 ? Jet(span.angle) : span.angle + span.rate * (t - span.since));
    const V off = place - pivot;
    const V q = V{dot(turn, off), cross(turn, off)} + pivot - f.at;
    Lie lie;
    V normal = perp(f.first);
    I before = 1, beyond = 1;  // how far it is within the ends
    if (f.kind == Feature::Kind::line) {
        const I along = dot(f.first, q)[0];
        before = along, beyond = f.length[0] - along;
        if (const I side = cross(f.first, q)[0]; low(side) + high(side) < 0) normal = -1.0 * normal;
        lie.gap = dot(normal, q) - r;
    } else {
        const bool is_arc = f.kind == Feature::Kind::arc;
        const Jet far = length(q),
                  side = is_arc && low(far[0]) + high(far[0]) < 2 * low(f.radius[0]) ? -1.0 : 1.0;
        normal = {side * (q.x / far), side * (q.y / far)};
        lie.gap = side * (far - f.radius) - r;
        if (!f.full) before = cross(f.first, q)[0], beyond = cross(q, f.last)[0];
        // An arc that is too narrow for the ball is met at its ends alone.
        lie.apart = is_arc && high(far[0]) < low(f.radius[0]) && high(f.radius[0]) <= r;
    }
    const auto slack = [&](int end) { return f.joined[end] ? joint_distance + joint_angle * r : 1e-9 * r; };
    const bool off_first = high(before) < 0, off_last = high(beyond) < 0;
    const bool in_first = low(before) >= -slack(0), in_last = low(beyond) >= -slack(1);
    lie.apart = lie.apart || (f.wide ? off_first && off_last : off_first || off_last);
    lie.facing = f.wide ? in_first || in_last : in_first && in_last;
    lie.normal = {dot(V{turn.x, 0.0 - turn.y}, normal), cross(V{turn.x, 0.0 - turn.y}, normal)};
    lie.velocity = span.rate * perp(place - r * lie.normal - pivot);
    return lie;
}

}  // namespace certificate
