// The closest point of a primitive to a disc's centre: the regions between which the construction chooses,
// the one that it chose tinted; the foot of the perpendicular and where it was clamped to.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/window/constructions.hpp"

namespace flipside::app {

namespace {

using std::numbers::pi;

struct ClosestView {
    const Construction& drawn;
    Vec2 center, point, normal;
    double radius, separation;
    Vec2 region_middle;  ///< where its name goes

    explicit ClosestView(const Construction& what)
        : drawn(what),
          center(what.item.get<Vec2>("center")),
          point(what.item.get<Vec2>("point")),
          normal(what.item.get<Vec2>("normal")),
          radius(what.item.get<double>("radius")),
          separation(what.item.get<double>("separation")),
          region_middle(center) {}

    [[nodiscard]] std::string shape() const { return drawn.item.get<std::string>("shape"); }
    [[nodiscard]] std::string feature() const { return drawn.item.get<std::string>("feature"); }
    /// How far a region is drawn, m.
    [[nodiscard]] double depth() const {
        return std::max(1.3 * length(center - point), drawn.metres(50)) + radius;
    }
    void border(Vec2 from, Vec2 to) const { drawn.line(from, to, 1, with_alpha(colour::text, 0.5)); }
    /// The primitive itself, which the veil over the table has faded.
    void outline(Vec2 from, Vec2 to) const { drawn.line(from, to, 2.5, colour::part); }
    void outline(Vec2 middle, double core, double from, double to) const {
        drawn.canvas.arc(drawn.at(middle), drawn.camera.scale * core, from, to, drawn.canvas.scaled(2.5),
                         colour::part);
    }
    void tint(std::span<const Vec2> region) const { drawn.fill(region, with_alpha(colour::lit, 0.12)); }
    void fan(Vec2 apex, double outer, double from, double to) {
        constexpr int primitives = 24;
        for (int k = 0; k < primitives; ++k) {
            const Vec2 patch[] = {apex, apex + outer * from_angle(from + k * (to - from) / primitives),
                                  apex + outer * from_angle(from + (k + 1) * (to - from) / primitives)};
            tint(patch);
            if (k == 0 || patch[1].y > region_middle.y) region_middle = patch[1];
        }
    }

    /// Regions beside a straight edge from a to b, and past its ends.
    void straight(Vec2 a, Vec2 b, bool two_sided) {
        const double d = depth(), t = drawn.item.get<double>("along");
        const Vec2 u = unit(b - a);
        const Vec2 side = dot(center - a, perp(u)) < 0 ? -perp(u) : perp(u);
        for (const Vec2 end : {a, b}) border(two_sided ? end - d * side : end, end + d * side);
        if (t >= 0 && t <= 1) {
            const Vec2 region[] = {a, b, b + d * side, a + d * side};
            tint(region);
            region_middle = 0.5 * (a + b) + d * side;
        } else {
            const Vec2 end = t < 0 ? a : b, out = t < 0 ? -u : u;
            if (two_sided) {
                const Vec2 region[] = {end - d * side, end + d * side, end + d * (side + out),
                                       end + d * (out - side)};
                tint(region);
                region_middle = end + d * (side + 0.5 * out);
            }
            const Vec2 foot = drawn.item.get<Vec2>("foot");
            drawn.line(end, foot, 1.5, with_alpha(colour::part, 0.6));
            drawn.line(center, foot, 1, with_alpha(colour::quiet, 0.7));
            drawn.canvas.ring(drawn.at(foot), drawn.canvas.scaled(4), drawn.canvas.scaled(1.5), colour::text);
        }
    }
    /// Past a corner of a polygon: between the normals of its two edges.
    void corner(const std::vector<Vec2>& corners, Vec2 at_corner) {
        const std::size_t n = corners.size();
        const auto i = static_cast<std::size_t>(std::ranges::find(corners, at_corner) - corners.begin());
        const double first = angle_of(-perp(at_corner - corners[(i + n - 1) % n]));
        const double turn = std::remainder(angle_of(-perp(corners[(i + 1) % n] - at_corner)) - first, 2 * pi);
        for (const double angle : {first, first + turn})
            border(at_corner, at_corner + depth() * from_angle(angle));
        fan(at_corner, depth(), first, first + turn);
    }
    void polygon(Vec2 a, Vec2 b, const std::vector<double>& flat) {
        std::vector<Vec2> corners;
        for (std::size_t i = 0; i + 1 < flat.size(); i += 2) corners.push_back({flat[i], flat[i + 1]});
        for (std::size_t i = 0; i < corners.size(); ++i)
            outline(corners[i], corners[(i + 1) % corners.size()]);
        straight(a, b, false);
        if (const double t = drawn.item.get<double>("along"); t < 0 || t > 1) corner(corners, t < 0 ? a : b);
    }
    void arc() {
        const Vec2 middle = drawn.item.get<Vec2>("middle");
        const double core = drawn.item.get<double>("core"), from = drawn.item.get<double>("from"),
                     to = drawn.item.get<double>("to"), t = drawn.item.get<double>("along");
        const double out = core + drawn.metres(24), half_gap = pi - (to - from) / 2;
        outline(middle, core, from, to);
        for (const double angle : {from, to}) border(middle, middle + out * from_angle(angle));
        if (t < 0)
            fan(middle, out, from - half_gap, from);
        else if (t > 1)
            fan(middle, out, to, to + half_gap);
        else
            fan(middle, out, from, to);
        border(middle, t < 0 || t > 1 ? center : point);
        drawn.canvas.disc(drawn.at(middle), drawn.canvas.scaled(3), colour::text);
        drawn.word(middle, {1, -1}, 4, "m", colour::text);
    }
    /// The borders are normals where the straight sides end.
    void taper(Vec2 a, Vec2 b) {
        const double core_a = drawn.item.get<double>("core"), core_b = drawn.item.get<double>("other_core");
        const double t = drawn.item.get<double>("along"), out = depth(), forward = angle_of(b - a);
        const double lean = std::acos(std::clamp((core_a - core_b) / length(b - a), -1.0, 1.0));
        outline(a, core_a, forward + lean, forward + 2 * pi - lean);
        outline(b, core_b, forward - lean, forward + lean);
        for (const double angle : {forward + lean, forward - lean}) {
            outline(a + core_a * from_angle(angle), b + core_b * from_angle(angle));
            border(a, a + (core_a + out) * from_angle(angle));
            border(b, b + (core_b + out) * from_angle(angle));
        }
        border(a, b);
        if (t < 0) return fan(a, core_a + out, forward + lean, forward + 2 * pi - lean);
        if (t > 1) return fan(b, core_b + out, forward - lean, forward + lean);
        const double side = forward + (dot(center - a, perp(b - a)) < 0 ? -lean : lean);
        const Vec2 region[] = {a, b, b + (core_b + out) * from_angle(side),
                               a + (core_a + out) * from_angle(side)};
        tint(region);
        region_middle = 0.5 * (region[2] + region[3]);
    }

    void words() const {
        const bool overlaps = separation < 0;
        const sf::Color verdict = overlaps ? colour::warning : colour::lit;
        drawn.line(point, center - radius * normal, 3.5, verdict);
        drawn.word(center + radius * normal, normal, 6,
                   (overlaps ? "overlap " : "separation ") + short_length(std::abs(separation)), verdict);
        drawn.word(region_middle, region_middle - point, 4, shape() + ": " + feature(), colour::lit);
        drawn.word(center, perp(normal), 2, "c", colour::text);
        const auto* t = drawn.value<double>("along");
        const auto* foot = drawn.value<Vec2>("foot");
        const bool clamped = t != nullptr && (*t < 0 || *t > 1);
        if (foot != nullptr && clamped)
            drawn.word(*foot, *foot - center, 6, "foot, t = " + brief(*t), colour::text);
        drawn.word(point, -normal, 8,
                   t == nullptr ? "p"
                   : clamped    ? "p, t = " + brief(*t) + " clamped to " + (*t < 0 ? "0" : "1")
                                : "p, t = " + brief(*t),
                   colour::text);
    }
    void ends(Vec2 a, Vec2 b) const {
        drawn.word(a, a - b, 5, "a", colour::text);
        drawn.word(b, b - a, 5, "b", colour::text);
    }
};

}  // namespace

void draw_closest(const Construction& drawn) {
    ClosestView view(drawn);
    const auto *a = drawn.value<Vec2>("a"), *b = drawn.value<Vec2>("b");
    if (drawn.value<double>("from") != nullptr)
        view.arc();
    else if (drawn.value<double>("other_core") != nullptr)
        view.taper(*a, *b);
    else if (const auto* outline = drawn.value<std::vector<double>>("outline"))
        view.polygon(*a, *b, *outline);
    else if (a != nullptr) {
        view.outline(*a, *b);
        view.straight(*a, *b, true);
    }
    view.words();
    if (a != nullptr) view.ends(*a, *b);
}

}  // namespace flipside::app
