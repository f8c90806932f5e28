#include "surface.hpp"

#include <cmath>
#include <numbers>

namespace certificate {

namespace {

/// Ends nearer than this are one joint, m, and tangents that differ by less are smooth there, rad: what the
/// scenes' rules say. A face may reach so far past such an end.
constexpr double joint_distance = 1e-6, joint_angle = 1e-3;

/// `terms` terms of a polynomial in time, about a time t after its start.
template <class Term>
Jet polynomial(std::size_t terms, const I& t, int order, Term term) {
    Jet sum(I(0), order);
    for (std::size_t k = terms; k-- > 0;) {
        for (std::size_t j = sum.c.size() - 1; j > 0; --j) sum.c[j] = sum.c[j] * t + sum.c[j - 1];
        sum.c[0] = sum.c[0] * t + I(term(k));
    }
    return sum;
}

/// One coordinate of x'' = a − c·x'.
Jet damped(double x, double v, double a, double c, const I& t, int order) {
    const I decay = exp(I(-c * t)), e = (1 - decay) / c;
    Jet path(x + v * e + a * (t - e) / c, order);
    I last = v * decay + a * e;
    for (std::size_t k = 1; k < path.c.size(); ++k) {
        path.c[k] = last;
        last = ((k == 1 ? I(a) : I(0)) - c * last) / (k + 1);
    }
    return path;
}

Feature round(Vec center, double radius) {
    Feature f;
    f.x = center[0], f.y = center[1], f.radius = radius;
    return f;
}

Feature line(const I& ax, const I& ay, const I& bx, const I& by) {
    Feature f;
    f.kind = Feature::Kind::line;
    const I x = bx - ax, y = by - ay;
    f.length = sqrt(I(square(x) + square(y)));
    f.x = ax, f.y = ay, f.along_x = x / f.length, f.along_y = y / f.length;
    return f;
}

/// No point of the surface lies at this end of a primitive.
bool is_smooth(const Run& run, const I& x, const I& y) {
    for (const Primitive& primitive : run.primitives) {
        if (primitive.type != "point") continue;
        const Vec at = primitive.points[0];
        if (low(I(square(x - at[0]) + square(y - at[1]))) <= joint_distance * joint_distance) return false;
    }
    return true;
}

/// x·cos − y·sin and so on, for an angle that grows with time.
JetVec turned(const JetVec& v, const Jet& cosine, const Jet& sine) {
    return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y};
}

void see_ends(Lie& lie, const Feature& f, const I& first, const I& last, double radius) {
    const double joint = joint_distance + joint_angle * radius;
    const double before = f.goes_on_first ? -joint : -1e-9 * radius,
                 past = f.goes_on_last ? -joint : -1e-9 * radius;
    const bool in_first = low(first) >= before, in_last = low(last) >= past;
    const bool off_first = high(first) < 0, off_last = high(last) < 0;
    lie.facing = f.wide ? in_first || in_last : in_first && in_last;
    lie.apart = f.wide ? off_first && off_last : off_first || off_last;
}

}  // namespace

Motion motion_of(const Leg& leg, const I& time, int order) {
    const I t = time - leg.start;
    const auto steady = [&](double x, double v, double a) {
        return polynomial(3, t, order, [&](std::size_t k) { return k == 0 ? x : k == 1 ? v : a / 2; });
    };
    if (leg.form == "rest")
        return {{Jet(I(leg.position[0]), order), Jet(I(leg.position[1]), order)},
                steady(leg.spin, leg.spin_rate, 0)};
    if (leg.form == "series") {
        const auto series = [&](double first, const auto& others) {
            return polynomial(leg.spins.size() + 1, t, order,
                              [&](std::size_t k) { return k == 0 ? first : others(k - 1); });
        };
        return {{series(leg.position[0], [&](std::size_t k) { return leg.displacements[k][0]; }),
                 series(leg.position[1], [&](std::size_t k) { return leg.displacements[k][1]; })},
                series(leg.spin, [&](std::size_t k) { return leg.spins[k]; })};
    }
    const auto coordinate = [&](std::size_t i) {
        const double x = leg.position[i], v = leg.velocity[i], a = leg.acceleration[i];
        return leg.drag > 0 ? damped(x, v, a, leg.drag, t, order) : steady(x, v, a);
    };
    Motion motion{{coordinate(0), coordinate(1)}, steady(leg.spin, leg.spin_rate, 0)};
    if (leg.roll != Vec{})
        motion.spin =
            I(leg.roll[0]) * motion.place.x.derivative() + I(leg.roll[1]) * motion.place.y.derivative();
    return motion;
}

std::vector<Feature> features_of(const Primitive& primitive, const Run& run) {
    const auto& p = primitive.points;
    if (primitive.type == "point") return {round(p[0], 0)};
    if (primitive.type == "circle") return {round(p[0], primitive.radii[0])};
    if (primitive.type == "arc") {
        Feature f = round(p[0], primitive.radii[0]);
        f.kind = Feature::Kind::arc;
        f.full = primitive.angles[1] - primitive.angles[0] >= 2 * std::numbers::pi;
        f.wide = primitive.angles[1] - primitive.angles[0] > std::numbers::pi;
        f.from_x = cos(I(primitive.angles[0])), f.from_y = sin(I(primitive.angles[0]));
        f.to_x = cos(I(primitive.angles[1])), f.to_y = sin(I(primitive.angles[1]));
        f.goes_on_first = is_smooth(run, f.x + f.radius * f.from_x, f.y + f.radius * f.from_y);
        f.goes_on_last = is_smooth(run, f.x + f.radius * f.to_x, f.y + f.radius * f.to_y);
        return {f};
    }
    std::vector<Feature> features;
    const auto side = [](Vec a, Vec b) { return line(I(a[0]), I(a[1]), I(b[0]), I(b[1])); };
    if (primitive.type == "segment") {
        features.push_back(side(p[0], p[1]));
        if (run.parts[primitive.part].gate == Vec{}) {
            features[0].goes_on_first = is_smooth(run, I(p[0][0]), I(p[0][1]));
            features[0].goes_on_last = is_smooth(run, I(p[1][0]), I(p[1][1]));
        }
    } else if (primitive.type == "polygon") {
        for (std::size_t i = 0; i < p.size(); ++i) {
            features.push_back(side(p[i], p[(i + 1) % p.size()]));
            features.push_back(round(p[i], 0));
        }
    } else {
        // The hull of two circles: their outer tangents touch them where n·(b − a) = r_a − r_b.
        features = {round(p[0], primitive.radii[0]), round(p[1], primitive.radii[1])};
        const I x = I(p[1][0]) - p[0][0], y = I(p[1][1]) - p[0][1], squared = square(x) + square(y);
        const I c = I(primitive.radii[0]) - primitive.radii[1], s = sqrt(I(squared - square(c)));
        for (const int sign : {1, -1}) {
            const I nx = (c * x - sign * s * y) / squared, ny = (c * y + sign * s * x) / squared;
            Feature f = line(p[0][0] + primitive.radii[0] * nx, p[0][1] + primitive.radii[0] * ny,
                             p[1][0] + primitive.radii[1] * nx, p[1][1] + primitive.radii[1] * ny);
            f.goes_on_first = f.goes_on_last = true;
            features.push_back(f);
        }
    }
    return features;
}

Lie lie_of(const Feature& f, const Part& part, const Span* span, const JetVec& place, double radius,
           const I& time) {
    Lie lie;
    JetVec p = place;
    const int order = place.x.order();
    Jet cosine(I(1), order), sine(I(0), order);
    if (span != nullptr) {
        const I angle = span->angle + span->rate * (time - span->since);
        cosine.c[0] = cos(angle), sine.c[0] = sin(angle);
        for (std::size_t k = 0; k + 1 < cosine.c.size(); ++k) {
            cosine.c[k + 1] = -span->rate * sine.c[k] / (k + 1);
            sine.c[k + 1] = span->rate * cosine.c[k] / (k + 1);
        }
        const I px(part.pivot[0]), py(part.pivot[1]);
        p = turned({place.x - px, place.y - py}, cosine, I(-1) * sine);
        p = {p.x - I(-px), p.y - I(-py)};
    }
    const JetVec q{p.x - f.x, p.y - f.y};
    if (f.kind == Feature::Kind::line) {
        const Jet off = f.along_x * q.y - f.along_y * q.x;
        const I along = f.along_x * q.x.c[0] + f.along_y * q.y.c[0];
        see_ends(lie, f, along, f.length - along, radius);
        const I sign(low(off.c[0]) > 0 || (high(off.c[0]) >= 0 && low(off.c[0]) + high(off.c[0]) >= 0) ? 1
                                                                                                       : -1);
        lie.gap = sign * off - I(radius);
        lie.normal = {Jet(-sign * f.along_y, order), Jet(sign * f.along_x, order)};
    } else {
        const Jet far = length(q.x, q.y);
        const double middle = low(far.c[0]) / 2 + high(far.c[0]) / 2;
        const bool inside = f.kind == Feature::Kind::arc && middle < low(f.radius);
        const I sign(inside ? -1 : 1);
        lie.gap = sign * (far - f.radius) - I(radius);
        lie.normal = {sign * (q.x / far), sign * (q.y / far)};
        lie.facing = true;
        if (f.kind == Feature::Kind::arc && !f.full)
            see_ends(lie, f, f.from_x * q.y.c[0] - f.from_y * q.x.c[0], f.to_y * q.x.c[0] - f.to_x * q.y.c[0],
                     radius);
        if (high(far.c[0]) < low(f.radius) && high(f.radius) <= radius)
            lie.apart = true;  // too large for it: it meets the ends alone
    }
    lie.velocity = {Jet(I(0), order), Jet(I(0), order)};
    if (span == nullptr) return lie;
    lie.normal = turned(lie.normal, cosine, sine);
    const I rate(span->rate);
    const Jet x = place.x - I(radius) * lie.normal.x - I(part.pivot[0]);
    const Jet y = place.y - I(radius) * lie.normal.y - I(part.pivot[1]);
    lie.velocity = {-rate * y, rate * x};
    return lie;
}

}  // namespace certificate
