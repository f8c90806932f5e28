#include "app/window/table_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/window/claim.hpp"
#include "app/window/contender_colour.hpp"
#include "app/window/draw_shapes.hpp"

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
        return {with_alpha(colour::part, 0.35), with_alpha(colour::solid, 0.3), thin};
    if (scene.materials[part.material].kick > 0)
        return {blend(colour::kicker, colour::lit, light), blend(colour::solid, colour::kicker, 0.25 + light),
                thick, light};
    const sf::Color line = blend(colour::part, colour::lit, light);
    if (part.target) return {line, blend(colour::part, colour::lit, 0.3), thin};
    if (std::holds_alternative<shape::Gate>(part.shape.is))
        return {session.world().parts()[index].open ? with_alpha(colour::part, 0.45) : line, {}, thick};
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

void draw_parts(Canvas& canvas, const Camera& camera, const Run& run, const Look& look) {
    const lab::Session& session = run.session();
    const Scene& scene = session.scene();
    for (PartIndex i = 0; i < scene.parts.size(); ++i) {
        const Pose pose = pose_of(scene.parts[i], session.world().parts()[i]);
        ShapeStyle style = style_of(canvas, run, i, look);
        if (look.picked == Other::part(i)) {
            style.line = colour::lit;
            style.width = canvas.scaled(3);
        }
        draw_shape(canvas, camera, scene.parts[i].shape, pose, style);
    }
    if (!scene.rules) return;
    for (const Rules::Spinner& spinner : scene.rules->spinners)
        draw_spinner(canvas, camera, scene.parts[spinner.part].shape, session.game().spinning(spinner.part));
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
    const double reach = std::max(canvas.scaled(70), 8 * radius);
    if (look.charge > 0) {
        const Vec2 foot = at + (radius + canvas.scaled(5)) * perp(way);
        canvas.line(foot, foot + reach * way, canvas.scaled(6), colour::rule);
        canvas.line(foot, foot + look.charge * reach * way, canvas.scaled(6),
                    blend(colour_of(run), colour::lit, look.charge));
    }
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

bool out_of_sight(const Camera& camera, Vec2 at, double radius) {
    return at.x < -radius || at.y < -radius || at.x > camera.size.x + radius || at.y > camera.size.y + radius;
}

}  // namespace

void draw_table(Canvas& canvas, const Camera& camera, const Run& run, const Look& look) {
    const Box& bounds = run.session().scene().bounds;
    const Vec2 a = camera.to_pixels(bounds.min), b = camera.to_pixels(bounds.max);
    canvas.rectangle({a.x, b.y}, {b.x, a.y}, colour::table);
    draw_parts(canvas, camera, run, look);
    draw_launcher(canvas, camera, run, look);
}

void draw_balls(Canvas& canvas, const Camera& camera, const Run& run, std::span<const Ball> balls,
                const Look& look) {
    const sf::Color rim = colour_of(run);
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
        // Where friction makes a ball spin, a spot shows it.
        if (std::abs(ball.angle) > 1e-3 && radius > 5)
            canvas.disc(camera.to_pixels(ball.position + 0.6 * ball.radius * from_angle(ball.angle)),
                        0.13 * radius, with_alpha(colour::around, alpha));
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
    const auto others = b.session().world().balls();
    for (const Ball& ball : a.session().world().balls()) {
        const auto other = std::ranges::lower_bound(others, ball.number, {}, &Ball::number);
        if (other != others.end() && other->number == ball.number)
            canvas.line(camera.to_pixels(ball.position), camera.to_pixels(other->position),
                        canvas.scaled(1.5), with_alpha(color, 0.6));
    }
}

}  // namespace flipside::app
