#include "app/window/table_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/window/claim.hpp"
#include "app/window/contender_colour.hpp"
#include "app/window/draw_shapes.hpp"
#include "app/window/playfield/kickers.hpp"
#include "app/window/playfield/plunger.hpp"

namespace flipside::app {

namespace {

/// Line and fill of a part, which tell its kind: sensor, active kicker, drop target, moving part or wall.
ShapeStyle style_of(const Canvas& canvas, const Run& run, PartIndex index, const Look& look) {
    const lab::Session& session = run.session();
    const Scene& scene = session.scene();
    const Part& part = scene.parts[index];
    const bool lights = has(look.shows, Show::lights);
    const double light = lights ? run.traces().light(index, session.world().time()) : 0;
    const double thick = canvas.scaled(2.5), thin = canvas.scaled(1.2);
    if (part.sensor) {
        const double glow = std::max(light, session.game().lit(index) ? 0.85 : 0.0);
        return {blend(colour::sensor, colour::lit, glow), with_alpha(colour::lit, 0.35 * glow), thin};
    }
    if (part.target && session.world().parts()[index].down)
        return {with_alpha(blend(colour::part, colour::lit, light), 0.35 + 0.65 * light),
                with_alpha(blend(colour::solid, colour::lit, light), 0.3 + 0.7 * light), thin};
    if (scene.materials[part.material].kick > 0)
        return {blend(colour::kicker, colour::lit, light), blend(colour::solid, colour::kicker, 0.25 + light),
                thick, light};
    const sf::Color line = blend(colour::part, colour::lit, light);
    if (part.target) return {line, blend(colour::part, colour::lit, 0.3), thin};
    if (std::holds_alternative<shape::Gate>(part.shape.is))
        return {session.world().parts()[index].open ? with_alpha(colour::part, 0.45) : line, {}, thick};
    if (look.artwork && std::holds_alternative<shape::Flipper>(part.shape.is))
        return {blend(colour::kicker, colour::lit, light), blend(colour::part, sf::Color::White, 0.45),
                canvas.scaled(3)};
    if (Table::moves(part))
        return {blend(line, sf::Color::White, 0.35), blend(colour::solid, colour::part, 0.4), thick};
    return {line, colour::solid, thick};
}

/// The plate of a spinner, seen from above: edge on while it hangs, broad as it comes round.
void draw_spinner(Canvas& canvas, const Camera& camera, const Shape& shape, double half_turns) {
    const auto* axle = std::get_if<shape::Segment>(&shape.is);
    if (!axle) return;
    const Vec2 a = camera.to_pixels(axle->a), b = camera.to_pixels(axle->b);
    const double breadth = 0.3 * length(b - a) * std::abs(std::sin(std::numbers::pi * half_turns));
    const Vec2 along = 0.18 * (b - a);
    const Vec2 across = std::max(canvas.scaled(1), 0.5 * breadth) * unit(perp(b - a));
    const Vec2 plate[] = {a + along + across, b - along + across, b - along - across, a + along - across};
    canvas.fill(plate, blend(colour::kicker, colour::solid, half_turns > 0 ? 0.4 : 0));
    canvas.stroke(plate, true, canvas.scaled(1), colour::kicker);
}

int points_of(const Scene& scene, PartIndex part) {
    if (!scene.rules) return 0;
    const auto entry = std::ranges::find(scene.rules->scores, part, &Rules::Score::part);
    return entry == scene.rules->scores.end() ? 0 : entry->points;
}

/// Bumpers and slingshots with their own look; false for what has none.
bool draw_kicker(Canvas& canvas, const Camera& camera, const Run& run, PartIndex index, const Look& look) {
    const Scene& scene = run.session().scene();
    const Part& part = scene.parts[index];
    if (scene.materials[part.material].kick <= 0 || part.target || Table::moves(part)) return false;
    const double light =
        has(look.shows, Show::lights) ? run.traces().light(index, run.session().world().time()) : 0;
    if (const auto* bumper = std::get_if<shape::Circle>(&part.shape.is)) {
        const int points = points_of(scene, index);
        draw_bumper(canvas, camera, *bumper, light, points > 0 ? std::to_string(points) : "");
        return true;
    }
    const auto* band = std::get_if<shape::Segment>(&part.shape.is);
    if (band != nullptr) draw_band(canvas, camera, *band, light);
    return band != nullptr;
}

/// Thin walls as rods: dark, with the light along the middle.
bool is_rod(const Part& part) {
    return !part.sensor && (std::holds_alternative<shape::Segment>(part.shape.is) ||
                            std::holds_alternative<shape::Arc>(part.shape.is) ||
                            std::holds_alternative<shape::Polyline>(part.shape.is) ||
                            std::holds_alternative<shape::Compound>(part.shape.is));
}

/// Of what moves or goes down; what always stands has its shadow on the ground.
void draw_shadow(Canvas& canvas, const Camera& camera, const Part& part, const Pose& pose) {
    Camera moved = camera;
    moved.pan(canvas.scaled(4) * Vec2{0.8, 1});
    const sf::Color black = with_alpha(sf::Color::Black, 0.35);
    draw_shape(canvas, moved, part.shape, pose, {black, black, canvas.scaled(3)});
}

void draw_parts(Canvas& canvas, const Camera& camera, const Run& run, const Look& look) {
    const lab::Session& session = run.session();
    const Scene& scene = session.scene();
    for (PartIndex i = 0; i < scene.parts.size(); ++i) {
        const Pose pose = pose_of(scene.parts[i], session.world().parts()[i]);
        ShapeStyle style = style_of(canvas, run, i, look);
        const bool down = session.world().parts()[i].down;
        if (look.artwork && !down && (Table::moves(scene.parts[i]) || scene.parts[i].target))
            draw_shadow(canvas, camera, scene.parts[i], pose);
        if (look.picked == Other::part(i)) {
            style.line = colour::lit;
            style.width = canvas.scaled(3);
        } else if (look.artwork && draw_kicker(canvas, camera, run, i, look)) {
            continue;
        } else if (look.artwork && is_rod(scene.parts[i])) {
            ShapeStyle casing = style;
            casing.width = canvas.scaled(4);
            casing.line = blend(colour::solid, style.line, 0.45);
            draw_shape(canvas, camera, scene.parts[i].shape, pose, casing);
            style.width = canvas.scaled(1.4);
            style.line = blend(style.line, sf::Color::White, 0.3);
        }
        draw_shape(canvas, camera, scene.parts[i].shape, pose, style);
    }
    if (!scene.rules) return;
    for (const Rules::Spinner& spinner : scene.rules->spinners)
        draw_spinner(canvas, camera, scene.parts[spinner.part].shape, session.game().spinning(spinner.part));
}

/// How far the launch is charged, with a mark at every fifth to aim by.
void draw_charge(Canvas& canvas, Vec2 foot, Vec2 way, double radius, double charge, sf::Color own) {
    const double reach = std::max(canvas.scaled(70), 8 * radius), width = canvas.scaled(6);
    canvas.line(foot, foot + reach * way, width, colour::rule);
    canvas.line(foot, foot + charge * reach * way, width, blend(own, colour::lit, charge));
    for (int fifth = 1; fifth < 5; ++fifth) {
        const Vec2 mark = foot + 0.2 * fifth * reach * way;
        canvas.line(mark - 0.5 * width * perp(way), mark + 0.5 * width * perp(way), canvas.scaled(1),
                    colour::table);
    }
}

void draw_launcher(Canvas& canvas, const Camera& camera, const Run& run, const Look& look) {
    const lab::Session& session = run.session();
    if (!session.scene().launcher) return;
    const Launcher& launcher = *session.scene().launcher;
    const Vec2 at = camera.to_pixels(launcher.position);
    const double radius = camera.scale * launcher.ball.radius;
    const Vec2 way{launcher.direction.x, -launcher.direction.y};

    const auto balls = session.world().balls();
    const bool occupied = std::ranges::any_of(balls, [&](const Ball& ball) {
        return length(ball.position - launcher.position) < ball.radius + launcher.ball.radius;
    });
    if (!occupied && session.game().permits(control::Launch{}, balls)) {
        canvas.disc(at, radius, colour::raised);
        canvas.ring(at, radius, canvas.scaled(1.2), colour::quiet);
    }
    if (look.artwork && launcher.plunger) draw_plunger(canvas, camera, launcher, look.charge);
    if (look.charge > 0)
        draw_charge(canvas, at + (radius + canvas.scaled(5)) * perp(way), way, radius, look.charge,
                    colour_of(run));
}

/// A hue per ball, well apart for neighbours (golden angle).
sf::Color own_colour(BallNumber number) {
    const double hue = 2.399963 * number;
    const auto channel = [hue](double shift) {
        return static_cast<sf::Uint8>(std::lround(165 + 90 * std::cos(hue + shift)));
    };
    return {channel(0), channel(2.0944), channel(4.1888), 215};
}

/// Even what is known no longer leaves a trace of where the engine has it.
double opacity(const World& world, std::span<const Ball> balls, std::size_t ball) {
    constexpr double faint = 0.15;
    if (balls.size() != world.balls().size()) return 1;  // as they were when there were others
    return faint + (1 - faint) * claim(uncertainty_in_radii(world, ball));
}

/// Where friction makes a ball spin, two engraved arcs show how far it has turned, and a spot which is which.
void draw_spin(Canvas& canvas, Vec2 at, double radius, double angle, double alpha) {
    constexpr double half = 0.65;  // rad
    const sf::Color engraved = with_alpha(colour::around, 0.75 * alpha);
    for (const double side : {0.0, std::numbers::pi})
        canvas.arc(at, 0.62 * radius, angle + side - half, angle + side + half, 0.1 * radius, engraved);
    const Vec2 way = from_angle(angle);
    canvas.disc(at + 0.62 * radius * Vec2{way.x, -way.y}, 0.13 * radius, engraved);
}

bool out_of_sight(const Camera& camera, Vec2 at, double radius) {
    return at.x < -radius || at.y < -radius || at.x > camera.size.x + radius || at.y > camera.size.y + radius;
}

/// Below the balls, the light from the upper left.
void draw_shadows(Canvas& canvas, const Camera& camera, std::span<const Ball> balls) {
    for (const Ball& ball : balls) {
        const Vec2 at = camera.to_pixels(ball.position);
        const double radius = camera.scale * ball.radius;
        if (!out_of_sight(camera, at, 2 * radius))
            canvas.disc(at + radius * Vec2{0.28, 0.36}, 1.05 * radius, with_alpha(sf::Color::Black, 0.35));
    }
}
constexpr std::size_t most_shadows = 200;  ///< more are a carpet, and cost as much as the balls

}  // namespace

bool has_overlays(const Look& look) {
    Shows others = look.shows;
    others.reset(static_cast<std::size_t>(Show::lights));
    return others.any();
}

void draw_bare_ground(Canvas& canvas, const Camera& camera, const Scene& scene) {
    const Vec2 a = camera.to_pixels(scene.bounds.min), b = camera.to_pixels(scene.bounds.max);
    canvas.rectangle({a.x, b.y}, {b.x, a.y}, colour::table);
}

void draw_table(Canvas& canvas, const Camera& camera, const Run& run, const Look& look) {
    draw_parts(canvas, camera, run, look);
    draw_launcher(canvas, camera, run, look);
}

void draw_balls(Canvas& canvas, const Camera& camera, const Run& run, std::span<const Ball> balls,
                const Look& look) {
    const sf::Color rim = colour_of(run);
    if (look.artwork && balls.size() <= most_shadows) draw_shadows(canvas, camera, balls);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const Ball& ball = balls[i];
        const Vec2 at = camera.to_pixels(ball.position);
        const double radius = camera.scale * ball.radius;
        if (out_of_sight(camera, at, radius)) continue;
        const double alpha = opacity(run.session().world(), balls, i);
        const sf::Color tint = look.random_colours ? own_colour(ball.number) : sf::Color::Transparent;
        const sf::Color sleeper =
            look.random_colours ? blend(colour::solid, tint, 0.6) : sf::Color(0x5b, 0x61, 0x69);
        if (ball.asleep)
            canvas.disc(at, radius, with_alpha(sleeper, alpha));
        else
            canvas.steel(at, radius, tint, alpha);
        const double width = std::clamp(0.16 * radius, 1.0, canvas.scaled(3));
        canvas.ring(at, std::max(0.5, radius - 0.5 * width), width, with_alpha(rim, alpha));
        if (std::abs(ball.angle) > 1e-3 && radius > 5) draw_spin(canvas, at, radius, ball.angle, alpha);
    }
}

void draw_halos(Canvas& canvas, const Camera& camera, const Run& run, std::span<const Ball> balls) {
    const sf::Color color = colour_of(run);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const Vec2 at = camera.to_pixels(balls[i].position);
        const double radius = camera.scale * balls[i].radius, width = canvas.scaled(2);
        if (!out_of_sight(camera, at, radius + 2 * width))
            canvas.ring(at, radius + 1.5 * width, width,
                        with_alpha(color, opacity(run.session().world(), balls, i)));
    }
}

void draw_links(Canvas& canvas, const Camera& camera, const Run& a, const Run& b, sf::Color color) {
    const auto balls = a.session().world().balls(), others = b.session().world().balls();
    // All lines together hide no more of the table than those of a few balls.
    constexpr double strongest = 0.6, faintest = 0.06, few = 20;
    const double alpha = std::clamp(strongest * few / std::max<double>(1, static_cast<double>(balls.size())),
                                    faintest, strongest);
    for (const Ball& ball : balls) {
        const auto other = std::ranges::lower_bound(others, ball.number, {}, &Ball::number);
        if (other != others.end() && other->number == ball.number)
            canvas.line(camera.to_pixels(ball.position), camera.to_pixels(other->position),
                        canvas.scaled(1.5), with_alpha(color, alpha));
    }
}

}  // namespace flipside::app
