#include "app/window/editor/editor_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/window/draw_shapes.hpp"
#include "app/window/editor/editor_marks.hpp"
#include "app/window/pane_view.hpp"
#include "app/window/words.hpp"
#include "world/printable.hpp"

namespace flipside::app {

namespace {

using Kind = lab::Item::Kind;

/// Lines a pitch apart as long as they can be told apart, every tenth one brighter.
void draw_grid(Canvas& canvas, const Camera& camera, const Box& bounds, double pitch) {
    constexpr double least = 4;  // px between two lines
    while (camera.scale * pitch < canvas.scaled(least)) pitch *= 10;
    const auto lines = [&](double from, double to, const auto& line) {
        const auto first = static_cast<long>(std::ceil(from / pitch)),
                   last = static_cast<long>(std::floor(to / pitch));
        for (long i = first; i <= last && i - first < 2000; ++i)
            line(static_cast<double>(i) * pitch, with_alpha(colour::rule, i % 10 == 0 ? 1 : 0.45));
    };
    lines(bounds.min.x, bounds.max.x, [&](double x, sf::Color color) {
        canvas.line(camera.to_pixels({x, bounds.min.y}), camera.to_pixels({x, bounds.max.y}), 1, color);
    });
    lines(bounds.min.y, bounds.max.y, [&](double y, sf::Color color) {
        canvas.line(camera.to_pixels({bounds.min.x, y}), camera.to_pixels({bounds.max.x, y}), 1, color);
    });
}

ShapeStyle plain_style(const Canvas& canvas, const Scene& scene, const Part& part) {
    const double thick = canvas.scaled(2.5), thin = canvas.scaled(1.2);
    if (part.sensor) return {colour::sensor, with_alpha(colour::sensor, 0.15), thin};
    if (scene.materials[part.material].kick > 0)
        return {colour::kicker, blend(colour::solid, colour::kicker, 0.25), thick};
    if (part.target) return {colour::part, blend(colour::part, colour::lit, 0.3), thin};
    if (Table::moves(part))
        return {blend(colour::part, sf::Color::White, 0.35), blend(colour::solid, colour::part, 0.4), thick};
    return {colour::part, colour::solid, thick};
}

/// Where a flipper goes, and about what a part turns.
void draw_motion(Canvas& canvas, const Camera& camera, const Part& part) {
    const auto* flipper = std::get_if<shape::Flipper>(&part.shape.is);
    if (const auto* flip = std::get_if<motion::Flip>(&part.motion); flip != nullptr && flipper != nullptr)
        draw_shape(canvas, camera, part.shape, {flipper->pivot, flip->raised - flipper->rest},
                   {with_alpha(colour::lit, 0.5), with_alpha(colour::solid, 0.3), canvas.scaled(1)});
    if (const auto* turn = std::get_if<motion::Turn>(&part.motion)) {
        const Vec2 at = camera.to_pixels(turn->pivot);
        const double radius = canvas.scaled(16);
        const double from = 0.3, to = 4.6;
        canvas.arc(at, radius, from, to, canvas.scaled(1.5), colour::lit);
        const double end = turn->rate >= 0 ? to : from;
        const Vec2 tip = at + radius * Vec2{std::cos(end), -std::sin(end)};
        const Vec2 way = (turn->rate >= 0 ? 1.0 : -1.0) * Vec2{-std::sin(end), -std::cos(end)};
        canvas.arrow(tip, tip + canvas.scaled(7) * way, canvas.scaled(1.5), colour::lit);
    }
}

void draw_drawn_launcher(Canvas& canvas, const Camera& camera, const Launcher& launcher, bool picked) {
    const Vec2 at = camera.to_pixels(launcher.position);
    const double radius = std::max(camera.scale * launcher.ball.radius, canvas.scaled(4));
    const sf::Color color = picked ? colour::lit : colour::quiet;
    canvas.disc(at, radius, colour::raised);
    canvas.ring(at, radius, canvas.scaled(1.5), color);
    const Vec2 way{launcher.direction.x, -launcher.direction.y};
    canvas.arrow(at + radius * way, at + 4 * radius * way, canvas.scaled(1.5), color);
}

void draw_things(Canvas& canvas, const Camera& camera, const Editor& editor) {
    const Scene& scene = editor.draft().sketch();
    const Scene& good = *editor.draft().scene();
    // What the file generates comes after what it lists.
    if (!editor.draft().problem())
        for (std::size_t i = scene.parts.size(); i < good.parts.size(); ++i)
            draw_shape(canvas, camera, good.parts[i].shape, {},
                       {with_alpha(colour::part, 0.5), with_alpha(colour::solid, 0.5), canvas.scaled(1.5)});
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        ShapeStyle style = plain_style(canvas, scene, scene.parts[i]);
        const bool picked = editor.is_selected({Kind::part, i});
        if (picked) {
            draw_motion(canvas, camera, scene.parts[i]);
            style.line = colour::lit;
        }
        const auto& problem = editor.draft().problem();
        if (problem && problem->item == lab::Item{Kind::part, i}) style.line = colour::warning;
        draw_shape(canvas, camera, scene.parts[i].shape, {}, style);
    }
    if (scene.launcher)
        draw_drawn_launcher(canvas, camera, *scene.launcher, editor.is_selected({Kind::launcher, 0}));
    if (!editor.draft().problem())
        for (std::size_t i = scene.balls.size(); i < good.balls.size(); ++i)
            canvas.disc(camera.to_pixels(good.balls[i].position), camera.scale * good.balls[i].radius,
                        with_alpha(colour::quiet, 0.5));
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        const Ball& ball = scene.balls[i];
        const Vec2 at = camera.to_pixels(ball.position);
        const double radius = camera.scale * ball.radius;
        canvas.steel(at, radius, sf::Color::Transparent);
        if (editor.is_selected({Kind::ball, i}))
            canvas.ring(at, radius + canvas.scaled(3), canvas.scaled(1.5), colour::lit);
        else if (!(ball.velocity == Vec2{}))
            canvas.arrow(at, camera.to_pixels(ball.position + lab::velocity_seconds * ball.velocity),
                         canvas.scaled(1.2), colour::quiet);
    }
}

std::string millimetres(double metres) {
    return with_unit(1000 * metres, 1, "mm");
}

void draw_edit_header(Canvas& canvas, const Editor& editor, const Rect& place) {
    canvas.rectangle({place.x, place.y}, {place.x + place.width, place.y + place.height}, colour::raised);
    const double pad = canvas.scaled(10);
    const Lettering& letters = canvas.lettering();
    std::string where;
    if (editor.mouse_in_pane())
        where = "x " + millimetres(editor.target().at.x) + "   y " + millimetres(editor.target().at.y);
    const double right = letters.width(where, Type::small);
    const double y = place.y + 0.5 * (place.height - letters.line_height(Type::small));
    canvas.text({place.x + place.width - pad, y}, where, Type::small, colour::quiet, Align::right);
    const std::string name =
        printable(editor.draft().sketch().name) + (editor.unsaved() ? "  ·  not saved" : "");
    const double room = place.width - right - 4 * pad;
    const double title_y = place.y + 0.5 * (place.height - letters.line_height(Type::large));
    const std::string whole = "Drawing " + name;
    const bool fits = letters.width(whole, Type::large) <= room;
    canvas.text({place.x + pad, title_y}, letters.cut(fits ? whole : name, Type::large, room), Type::large,
                colour::text);
}

/// What to do next, below the table.
void draw_edit_advice(Canvas& canvas, const Editor& editor, const Rect& place) {
    const double pad = canvas.scaled(10);
    const Lettering& letters = canvas.lettering();
    const auto& problem = editor.draft().problem();
    const std::string words =
        problem ? "Cannot be played yet: " + problem->words : std::string(editor.tool().hint);
    const double line = letters.line_height(Type::small), room = place.width - 2 * pad;
    const auto most = static_cast<std::size_t>(std::max(1.0, place.height / line));
    const std::vector<std::string> lines = letters.lines(words, Type::small, room, most);
    double y = place.y + 0.5 * (place.height - line * static_cast<double>(lines.size()));
    for (const std::string& text : lines) {
        canvas.text({place.x + pad, y}, text, Type::small, problem ? colour::warning : colour::quiet);
        y += line;
    }
}

}  // namespace

Layout edit_layout(double width, double height, double scale, bool panel_open) {
    constexpr double column = 332, folded = 30, header = 40, advice = 28, gap = 6;
    constexpr double narrow = 560, advice_in_lines = 48;
    Layout layout;
    const double panel = std::min(width, std::round(scale * (panel_open ? column : folded)));
    const double space = std::round(scale * gap);
    const double room = std::max(1.0, width - panel - space), head = std::round(scale * header),
                 foot = std::round(scale * (room < scale * narrow ? advice_in_lines : advice));
    layout.panel = {width - panel, 0, panel, height};
    layout.headers = {{0, 0, room, head}};
    layout.panes = {{0, head, room, std::max(1.0, height - head - foot)}};
    layout.strip = {0, height - foot, room, foot};
    return layout;
}

Box view_bounds(const Editor& editor) {
    const Scene& scene = *editor.draft().scene();
    return scene.camera ? *scene.camera : scene.bounds;
}

void draw_editor(sf::RenderTarget& target, Canvas& canvas, const Editor& editor, const Layout& layout,
                 const Camera& camera) {
    target.clear(colour::around);
    const Rect& pane = layout.panes.front();
    target.setView(view_of_pane(target, pane));
    // What the document does not list is generated.
    const bool listed = editor.draft().find({Kind::bounds, 0}) != nullptr;
    const Box bounds = listed ? editor.draft().sketch().bounds : editor.draft().scene()->bounds;
    const Vec2 low = camera.to_pixels(bounds.min), high = camera.to_pixels(bounds.max);
    canvas.rectangle({low.x, high.y}, {high.x, low.y}, colour::table);
    draw_grid(canvas, camera, bounds, editor.pitch);
    const Vec2 corners[] = {{low.x, high.y}, {high.x, high.y}, {high.x, low.y}, {low.x, low.y}};
    canvas.stroke(corners, true, canvas.scaled(1), colour::sensor);
    draw_things(canvas, camera, editor);
    draw_marks(canvas, editor, camera);
    canvas.flush(target);

    const sf::Vector2f all(target.getSize());
    target.setView(sf::View({0, 0, all.x, all.y}));
    draw_edit_header(canvas, editor, layout.headers.front());
    draw_edit_advice(canvas, editor, layout.strip);
    canvas.flush(target);
}

}  // namespace flipside::app
