#include "app/window/playfield/inserts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "app/window/theme.hpp"

namespace flipside::app {

namespace {

struct Extent {
    Vec2 middle;   ///< the average of its ends or corners
    Vec2 longest;  ///< its longest side
};

Extent extent_of(const Shape& shape) {
    if (const auto* segment = std::get_if<shape::Segment>(&shape.is))
        return {0.5 * (segment->a + segment->b), segment->b - segment->a};
    const auto* polygon = std::get_if<shape::Polygon>(&shape.is);
    if (polygon == nullptr) return {};
    Extent extent;
    const auto count = static_cast<double>(polygon->points.size());
    for (std::size_t i = 0; i < polygon->points.size(); ++i) {
        const Vec2 a = polygon->points[i], b = polygon->points[(i + 1) % polygon->points.size()];
        extent.middle = extent.middle + a / count;
        if (length(b - a) > length(extent.longest)) extent.longest = b - a;
    }
    return extent;
}

void add_rollover(std::vector<Insert>& inserts, const Scene& scene, PartIndex part) {
    const Extent extent = extent_of(scene.parts[part].shape);
    if (extent.longest == Vec2{}) return;
    inserts.push_back({Insert::Kind::rollover, part, extent.middle, {}, 0.32 * length(extent.longest)});
}

void add_target(std::vector<Insert>& inserts, const Scene& scene, const Chart& chart, PartIndex part) {
    const Extent extent = extent_of(scene.parts[part].shape);
    if (extent.longest == Vec2{}) return;
    const double size = 0.5 * length(extent.longest), apart = 1.9 * size;
    const Vec2 across = unit(perp(extent.longest));
    const Vec2 one = extent.middle + apart * across, other = extent.middle - apart * across;
    if (chart.near(one) >= chart.near(other))
        inserts.push_back({Insert::Kind::target, part, one, -across, size});
    else
        inserts.push_back({Insert::Kind::target, part, other, across, size});
}

/// In the middle before the lamps of its targets, which are the last `count`.
void add_bank(std::vector<Insert>& inserts, std::size_t bank, std::size_t count) {
    if (count == 0) return;
    Insert lamp{Insert::Kind::bank, bank, {}, {}, 0};
    for (const Insert& target : std::span(inserts).last(count)) {
        lamp.at = lamp.at + target.at / double(count);
        lamp.way = lamp.way + target.way;
        lamp.radius = std::max(lamp.radius, 0.9 * target.radius);
    }
    lamp.way = unit(lamp.way, {0, 0});
    lamp.at = lamp.at - 3.2 * lamp.radius * lamp.way;
    inserts.push_back(lamp);
}

/// Between the pivots of the lowest left and right flipper, and how long these are.
struct BetweenFlippers {
    Vec2 at;
    double length = 0;
};
std::optional<BetweenFlippers> between_flippers(const Scene& scene) {
    const shape::Flipper* lowest[2] = {nullptr, nullptr};
    for (const Part& part : scene.parts) {
        const auto* flip = std::get_if<motion::Flip>(&part.motion);
        if (flip == nullptr) continue;
        const auto& flipper = std::get<shape::Flipper>(part.shape.is);
        const shape::Flipper*& low = lowest[static_cast<int>(flip->side)];
        if (low == nullptr || flipper.pivot.y < low->pivot.y) low = &flipper;
    }
    if (lowest[0] == nullptr || lowest[1] == nullptr) return std::nullopt;
    return BetweenFlippers{0.5 * (lowest[0]->pivot + lowest[1]->pivot), lowest[0]->length};
}

/// Where there is room for them.
void add_about_flippers(std::vector<Insert>& inserts, const Scene& scene, const Chart& chart) {
    const auto middle = between_flippers(scene);
    if (!middle || !scene.launcher) return;
    const double radius = 1.15 * scene.launcher->ball.radius;
    const auto add = [&](Insert::Kind kind, int of, Vec2 at) {
        if (chart.near(at) > radius) inserts.push_back({kind, static_cast<std::size_t>(of), at, {}, radius});
    };
    constexpr int most = 6;
    const int times = scene.rules->end_bonus ? std::min(scene.rules->end_bonus->most_times, most) : 1;
    for (int i = 2; i <= times; ++i) {
        const double aside = 2.9 * radius * (i - 0.5 * (times + 2)), along = aside / middle->length;
        const Vec2 up{0, (1.75 - 0.12 * along * along) * middle->length};
        add(Insert::Kind::times, i, middle->at + Vec2{aside, 0} + up);
    }
    if (scene.rules->ball_save > 0) add(Insert::Kind::save, 0, middle->at - Vec2{0, 1.2 * middle->length});
}

const sf::Color glass = blend(colour::around, colour::lit, 0.3);  ///< of a lamp that is off
const sf::Color hot(0xff, 0xf6, 0xdc);                            ///< the middle of one that is on

/// A lens in a dark bezel, with light that spills over it.
void draw_round(Canvas& canvas, Vec2 at, double radius, bool lit) {
    if (lit) canvas.disc(at, 1.7 * radius, with_alpha(colour::lit, 0.12));
    canvas.disc(at, radius, colour::around);
    const double lens = radius - canvas.scaled(1.5);
    if (lens < 1) return;
    canvas.disc(at, lens, lit ? colour::lit : glass);
    canvas.disc(at, 0.55 * lens, lit ? hot : blend(colour::around, glass, 0.7));
}

/// The lamp of the skill shot comes and goes, and a ring runs out from it: here the ball shall pass.
void draw_called(Canvas& canvas, Vec2 at, double radius, double time) {
    constexpr double period = 0.8;  // s
    const double phase = time / period - std::floor(time / period);
    draw_round(canvas, at, radius, phase < 0.5);
    canvas.ring(at, radius * (1 + 0.9 * phase), canvas.scaled(1.5),
                with_alpha(colour::lit, 0.7 * (1 - phase)));
}

void draw_arrow(Canvas& canvas, Vec2 at, Vec2 way, double radius, bool lit) {
    const Vec2 aside = perp(way);
    const auto triangle = [&](double size, sf::Color color) {
        const Vec2 corners[] = {at + size * way, at - 0.7 * size * way + 0.8 * size * aside,
                                at - 0.7 * size * way - 0.8 * size * aside};
        canvas.fill(corners, color);
    };
    if (lit) triangle(1.6 * radius, with_alpha(colour::lit, 0.12));
    triangle(radius, colour::around);
    triangle(0.72 * radius, lit ? colour::lit : glass);
}

/// With a number, where that fits.
void draw_number(Canvas& canvas, Vec2 at, double radius, bool lit, std::size_t number) {
    draw_round(canvas, at, radius, lit);
    const Lettering& lettering = canvas.lettering();
    const std::string words = std::to_string(number);
    const double height = lettering.line_height(Type::small);
    if (height > 2.2 * radius) return;
    canvas.text(at - Vec2{0, 0.5 * height}, words, Type::small, lit ? colour::around : colour::quiet,
                Align::center);
}

/// An arrow that turns back.
void draw_again(Canvas& canvas, Vec2 at, double radius, bool lit) {
    constexpr double from = -0.6, to = 4.2;  // rad
    if (lit) canvas.disc(at, 1.7 * radius, with_alpha(colour::lit, 0.14));
    canvas.disc(at, radius, colour::around);
    const sf::Color color = lit ? colour::lit : glass;
    canvas.arc(at, 0.6 * radius, from, to, 0.2 * radius, color);
    const Vec2 out = from_angle(from), end = at + 0.6 * radius * Vec2{out.x, -out.y};
    const Vec2 way{out.y, out.x};  // clockwise, as seen
    const Vec2 head[] = {end + 0.45 * radius * way, end + 0.4 * radius * perp(way),
                         end - 0.4 * radius * perp(way)};
    canvas.fill(head, color);
}

/// A star of four points.
void draw_star(Canvas& canvas, Vec2 at, double radius, bool lit) {
    if (lit) canvas.disc(at, 1.8 * radius, with_alpha(colour::lit, 0.14));
    canvas.disc(at, radius, colour::around);
    canvas.ring(at, radius - canvas.scaled(0.75), canvas.scaled(1.5), lit ? colour::lit : glass);
    for (const Vec2 way : {Vec2{1, 0}, Vec2{0, 1}}) {
        const Vec2 aside = 0.24 * radius * perp(way), tip = 0.74 * radius * way;
        const Vec2 points[] = {at + tip, at + aside, at - tip, at - aside};
        canvas.fill(points, lit ? hot : glass);
    }
}

}  // namespace

std::vector<Insert> inserts_of(const Scene& scene, const Chart& chart) {
    std::vector<Insert> inserts;
    if (!scene.rules) return inserts;
    for (const Rules::Group& group : scene.rules->lanes)
        for (const PartIndex part : group.parts) add_rollover(inserts, scene, part);
    for (std::size_t bank = 0; bank < scene.rules->targets.size(); ++bank) {
        const std::size_t before = inserts.size();
        for (const PartIndex part : scene.rules->targets[bank].parts) add_target(inserts, scene, chart, part);
        if (scene.rules->multiball) add_bank(inserts, bank, inserts.size() - before);
    }
    add_about_flippers(inserts, scene, chart);
    return inserts;
}

void draw_inserts(Canvas& canvas, const Camera& camera, std::span<const Insert> inserts, const Run& run) {
    const lab::Game& game = run.session().game();
    const double time = run.session().world().time();
    for (const Insert& insert : inserts) {
        const Vec2 at = camera.to_pixels(insert.at);
        const double radius = camera.scale * insert.radius;
        const auto part = static_cast<PartIndex>(insert.of);
        switch (insert.kind) {
            case Insert::Kind::bank:
                draw_star(canvas, at, radius, game.bank_done(insert.of) || game.turns().multiball());
                break;
            case Insert::Kind::times:
                draw_number(canvas, at, radius, game.times() >= static_cast<int>(insert.of), insert.of);
                break;
            case Insert::Kind::save:
                draw_again(canvas, at, radius, game.turns().saves(time));
                break;
            case Insert::Kind::target:
                draw_arrow(canvas, at, {insert.way.x, -insert.way.y}, radius, game.lit(part));
                break;
            case Insert::Kind::rollover:
                if (game.skill_shot() == part && !game.lit(part))
                    draw_called(canvas, at, radius, time);
                else
                    draw_round(canvas, at, radius, game.lit(part));
        }
    }
}

}  // namespace flipside::app
