#include "app/window/playfield/kickers.hpp"

#include <numbers>

#include "app/window/theme.hpp"

namespace flipside::app {

namespace {

constexpr int rays = 12;

/// Wedges from the rim of the cap inwards, every second one bright.
void draw_rays(Canvas& canvas, Vec2 at, double inner, double outer, sf::Color color) {
    for (int i = 0; i < rays; ++i) {
        const double from = 2 * std::numbers::pi * i / rays, to = from + std::numbers::pi / rays;
        const Vec2 corners[] = {at + inner * from_angle(from), at + outer * from_angle(from),
                                at + outer * from_angle(to), at + inner * from_angle(to)};
        canvas.fill(corners, color);
    }
}

}  // namespace

void draw_bumper(Canvas& canvas, const Camera& camera, const shape::Circle& bumper, double light,
                 const std::string& points) {
    const Vec2 at = camera.to_pixels(bumper.center);
    const double radius = camera.scale * bumper.radius, thin = canvas.scaled(1.5);
    const sf::Color rim = blend(colour::kicker, colour::lit, light);
    if (light > 0) canvas.disc(at, (1.2 + 0.3 * light) * radius, with_alpha(colour::lit, 0.22 * light));
    canvas.disc(at, radius, blend(colour::solid, colour::kicker, 0.15));
    canvas.ring(at, radius - 0.5 * thin, thin, rim);
    const double cap = 0.8 * radius;
    canvas.disc(at, cap, blend(colour::solid, colour::kicker, 0.35 + 0.4 * light));
    draw_rays(canvas, at, 0.52 * radius, cap, blend(colour::kicker, colour::lit, 0.35 + 0.65 * light));
    canvas.disc(at, 0.5 * radius, light > 0.5 ? colour::lit : blend(colour::around, colour::solid, 0.6));
    canvas.ring(at, 0.5 * radius, thin, rim);
    const double room = 0.9 * radius;
    const Lettering& lettering = canvas.lettering();
    if (!points.empty() && lettering.width(points, Type::small) < room &&
        lettering.line_height(Type::small) < room)
        canvas.text(at - Vec2{0, 0.5 * lettering.line_height(Type::small)}, points, Type::small,
                    light > 0.5 ? colour::around : colour::lit, Align::center);
}

void draw_band(Canvas& canvas, const Camera& camera, const shape::Segment& band, double light) {
    const Vec2 a = camera.to_pixels(band.a), b = camera.to_pixels(band.b);
    if (light > 0) canvas.line(a, b, canvas.scaled(14), with_alpha(colour::lit, 0.25 * light));
    canvas.line(a, b, canvas.scaled(4), blend(colour::kicker, colour::lit, light));
    for (const Vec2 post : {a, b}) {
        canvas.disc(post, canvas.scaled(4), colour::solid);
        canvas.ring(post, canvas.scaled(4), canvas.scaled(1.5), colour::kicker);
    }
}

}  // namespace flipside::app
