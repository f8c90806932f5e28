#pragma once
/// How balls move, the lines, arcs and rounds that a primitive consists of, and how a ball lies to them.

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

/// Ends nearer than this are one joint, m, and tangents that differ by less are smooth there, rad: the
/// scenes' rules. A face may reach so far past such an end.
constexpr double joint_distance = 1e-6, joint_angle = 1e-3;

/// A line, an arc of at most half a turn, which has two sides, or the outside of a circle, which is round.
struct Feature {
    bool is_line = false, is_round = true;
    V at;                             ///< where the line starts; the centre
    V first = vec({}), last{};        ///< unit vectors: along the line; to both ends of an arc
    Jet length, radius;               ///< of a line; of a circle
    bool joined[2] = {false, false};  ///< it goes on smoothly past that end: no point is there to be hit
};
inline Feature round(const V& center, const Jet& radius) {
    return {false, true, center, vec({}), {}, 0.0, radius};
}
inline Feature line(const V& a, const V& b, bool joined_a = false, bool joined_b = false) {
    const Jet far = length(b - a);
    return {true, false, a, (b - a) / far, {}, far, 0.0, {joined_a, joined_b}};
}

inline std::vector<Feature> features_of(const Primitive& primitive, const Run& run) {
    const auto& p = primitive.points;
    const auto at = [&](std::size_t i) { return vec(p.at(i)); };
    const auto radius = [&](std::size_t i) { return Jet(primitive.radii.at(i)); };
    const auto joined = [&](const V& end) {
        return std::ranges::none_of(run.primitives, [&](const Primitive& other) {
            return other.type == "point" && low(length(vec(other.points.at(0)) - end)[0]) <= joint_distance;
        });
    };
    std::vector<Feature> features;
    if (primitive.type == "point") {
        features.push_back(round(at(0), 0.0));
    } else if (primitive.type == "circle") {
        features.push_back(round(at(0), radius(0)));
    } else if (primitive.type == "arc") {
        constexpr int pieces = 3;
        const I from = primitive.angles.at(0), step = (primitive.angles.at(1) - from) / pieces;
        for (int i = 0; i < pieces; ++i) {
            const V a = from_angle(from + i * step), b = from_angle(from + (i + 1) * step);
            features.push_back({false,
                                false,
                                at(0),
                                a,
                                b,
                                0.0,
                                radius(0),
                                {joined(at(0) + radius(0) * a), joined(at(0) + radius(0) * b)}});
        }
    } else if (primitive.type == "segment") {
        const bool gate = run.parts.at(primitive.part).gate != Vec{};
        features.push_back(line(at(0), at(1), !gate && joined(at(0)), !gate && joined(at(1))));
    } else if (primitive.type == "polygon") {
        for (std::size_t i = 0; i < p.size(); ++i) {
            features.push_back(line(at(i), at((i + 1) % p.size())));
            features.push_back(round(at(i), 0.0));
        }
    } else if (primitive.type == "taper") {
        // The hull of two circles: their outer tangents touch them where n·(b − a) = r_a − r_b.
        const V way = at(1) - at(0);
        const Jet c = radius(0) - radius(1), squared = dot(way, way);
        for (const double side : {1.0, -1.0}) {
            const V n = (c * way + side * sqrt(squared - c * c) * perp(way)) / squared;
            features.push_back(line(at(0) + radius(0) * n, at(1) + radius(1) * n, true, true));
        }
        for (const std::size_t i : {0U, 1U}) features.push_back(round(at(i), radius(i)));
    }
    if (features.empty()) throw std::runtime_error("a primitive of type '" + primitive.type + "'");
    return features;
}

/// How a ball lies to what it may touch.
struct Lie {
    Jet gap;
    V normal, velocity;  ///< normal: unit, to the ball; velocity: of the other, where they touch
    Jet rim = 0.0;       ///< what the spin of a ball adds to that
    bool apart = false, facing = true;  ///< certainly not within the ends of the feature; within, or joined
};

inline Lie lie_of(const Feature& f, const Vec& pivot_at, const Span& span, const V& place, double r,
                  const Jet& t) {
    const V pivot = vec(pivot_at), off = place - pivot;
    const V turn = from_angle(span.rate == 0 ? Jet(span.angle) : span.angle + span.rate * (t - span.since));
    const V back{turn.x, 0.0 - turn.y}, q = V{dot(turn, off), cross(turn, off)} + pivot - f.at;
    Lie lie;
    V normal = perp(f.first);
    const auto reaches = [&](const I& within, bool joined) {
        lie.apart |= high(within) < 0;
        lie.facing &= low(within) >= -(joined ? joint_distance + joint_angle * r : 1e-9 * r);
    };
    if (f.is_line) {
        const I along = dot(f.first, q)[0], side = cross(f.first, q)[0];
        if (low(side) + high(side) < 0) normal = -1.0 * normal;
        lie.gap = dot(normal, q) - r;
        reaches(along, f.joined[0]);
        reaches(f.length[0] - along, f.joined[1]);
    } else {
        const Jet far = length(q);
        const double side = !f.is_round && low(far[0]) + high(far[0]) < 2 * low(f.radius[0]) ? -1 : 1;
        normal = side * (q / far);
        lie.gap = side * (far - f.radius) - r;
        if (!f.is_round) {
            reaches(cross(f.first, q)[0], f.joined[0]);
            reaches(cross(q, f.last)[0], f.joined[1]);
            // An arc that is too narrow for the ball is met at its ends alone.
            lie.apart |= high(far[0]) < low(f.radius[0]) && high(f.radius[0]) <= r;
        }
    }
    lie.normal = {dot(back, normal), cross(back, normal)};
    lie.velocity = span.rate * perp(place - r * lie.normal - pivot);
    return lie;
}

}  // namespace certificate
