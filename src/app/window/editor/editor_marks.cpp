#include "app/window/editor/editor_marks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/window/draw_shapes.hpp"
#include "app/window/labels.hpp"
#include "app/window/words.hpp"

namespace flipside::app {

namespace {

void draw_square(Canvas& canvas, Vec2 at, double half, sf::Color color, bool filled) {
    if (filled) return canvas.rectangle(at - Vec2{half, half}, at + Vec2{half, half}, color);
    canvas.rectangle(at - Vec2{half, half}, at + Vec2{half, half}, colour::table);
    const Vec2 corners[] = {at + Vec2{-half, -half}, at + Vec2{half, -half}, at + Vec2{half, half},
                            at + Vec2{-half, half}};
    canvas.stroke(corners, true, canvas.scaled(1.5), color);
}

/// Ends and corners are squares, what else is pulled a disc, and where a corner may come a small disc.
void draw_handles(Canvas& canvas, const Editor& editor, const Camera& camera) {
    const double size = canvas.scaled(4);
    if (const auto turn = editor.turn_handle(camera, canvas.scaled(1))) {
        canvas.line(turn->about, turn->at, canvas.scaled(1), with_alpha(colour::lit, 0.5));
        canvas.disc(turn->at, canvas.scaled(7), colour::table);
        canvas.arc(turn->at, canvas.scaled(5), 0.4, 5.2, canvas.scaled(1.5), colour::lit);
    }
    for (const lab::Handle& handle : editor.handles(camera, canvas.scaled(1))) {
        const Vec2 at = camera.to_pixels(handle.at);
        switch (handle.role) {
            case lab::Role::corner:
            case lab::Role::arc_end:
                draw_square(canvas, at, size, colour::lit, true);
                break;
            case lab::Role::between:
                canvas.disc(at, 0.6 * size, with_alpha(colour::lit, 0.6));
                break;
            case lab::Role::centre:
                canvas.line(at - Vec2{size, 0}, at + Vec2{size, 0}, canvas.scaled(1.5), colour::lit);
                canvas.line(at - Vec2{0, size}, at + Vec2{0, size}, canvas.scaled(1.5), colour::lit);
                break;
            case lab::Role::velocity:
                canvas.arrow(camera.to_pixels(handle.anchor.value_or(handle.at)), at, canvas.scaled(1.5),
                             colour::lit);
                canvas.disc(at, 0.7 * size, colour::lit);
                break;
            case lab::Role::pivot:
                draw_square(canvas, at, size, colour::lit, false);
                break;
            default:
                canvas.disc(at, size, colour::lit);
                canvas.disc(at, size - canvas.scaled(1.5), colour::table);
        }
    }
}

/// Length and direction from one point to the other.
std::string way_in_words(Vec2 way) {
    const double degrees = angle_of(way) * 180 / std::numbers::pi;
    std::string angle = with_unit(degrees, 1, "°");
    angle.erase(angle.rfind(' '), 1);  // unlike other units
    return with_unit(1000 * length(way), 1, "mm") + "   " + angle;
}

/// A ring where it joins, a cross on the grid.
void draw_target(Canvas& canvas, const Camera& camera, const lab::Snapped& target) {
    const Vec2 at = camera.to_pixels(target.at);
    const double size = canvas.scaled(5);
    if (target.to == lab::SnappedTo::end) {
        canvas.ring(at, canvas.scaled(8), canvas.scaled(2), colour::lit);
        return;
    }
    canvas.line(at - Vec2{size, 0}, at + Vec2{size, 0}, canvas.scaled(1.2), colour::text);
    canvas.line(at - Vec2{0, size}, at + Vec2{0, size}, canvas.scaled(1.2), colour::text);
}

/// The points so far and the one that would be next, as the part that they would make.
void draw_pen(Canvas& canvas, const Editor& editor, const Camera& camera) {
    if (!editor.draws() || !editor.mouse_in_pane()) return;
    const double radius = editor.draft().ball_radius();
    std::vector<Vec2> points = editor.pen();
    if (points.empty() || !(points.back() == editor.target().at)) points.push_back(editor.target().at);
    const lab::Tool& tool = editor.tool();
    const bool complete =
        tool.points == 0 ? points.size() > 1 : static_cast<int>(points.size()) >= tool.points;
    const ShapeStyle style{with_alpha(colour::lit, 0.9), with_alpha(colour::solid, 0.5), canvas.scaled(2)};
    if (complete && lab::place_of(tool) == "parts") {
        const lab::OrderedJson part = lab::made(tool, points, "new", radius);
        // Two corners of a polygon are a line yet.
        if (tool.name == "Polygon" && points.size() < 3)
            canvas.line(camera.to_pixels(points[0]), camera.to_pixels(points[1]), style.width, style.line);
        else
            draw_shape(canvas, camera, lab::sketch_of_shape(part.at("shape")), {}, style);
    } else if (complete) {
        canvas.ring(camera.to_pixels(points.back()), camera.scale * radius, style.width, style.line);
    }
    draw_target(canvas, camera, editor.target());
    if (!editor.pen().empty())
        Labels(canvas, camera.size, 0)
            .put_beside(camera.to_pixels(editor.target().at), {1, 1}, 14,
                        way_in_words(editor.target().at - editor.pen().back()), colour::lit);
}

/// Where on the table a thing is, px: for words beside it.
Vec2 place_on_screen(const Editor& editor, const Camera& camera, const lab::Item& item) {
    const lab::OrderedJson* thing = editor.draft().find(item);
    if (thing == nullptr) return 0.5 * camera.size;
    const Vec2 at = camera.to_pixels(item.kind == lab::Item::Kind::bounds ? lab::vector_of(thing->at("min"))
                                                                          : lab::middle_of(*thing));
    return {std::clamp(at.x, 0.0, camera.size.x), std::clamp(at.y, 0.0, camera.size.y)};
}

/// In lines, on a patch with an edge in the colour of warnings.
void draw_problem(Canvas& canvas, const Editor& editor, const Camera& camera) {
    const auto& problem = editor.draft().problem();
    if (!problem || !problem->item) return;
    const Lettering& letters = canvas.lettering();
    const double pad = canvas.scaled(8), line = letters.line_height(Type::small);
    const double room = std::min(canvas.scaled(280), camera.size.x - 4 * pad);
    const std::vector<std::string> lines = letters.lines(sentence(problem->words), Type::small, room);
    double width = 0;
    for (const std::string& words : lines) width = std::max(width, letters.width(words, Type::small));
    const double height = line * static_cast<double>(lines.size()) + pad;
    const Vec2 at = place_on_screen(editor, camera, *problem->item);
    Vec2 corner = at + Vec2{2.5 * pad, 2.5 * pad};
    if (corner.y + height > camera.size.y) corner.y = at.y - 2.5 * pad - height;
    corner.x = std::clamp(corner.x, 0.0, std::max(0.0, camera.size.x - width - 2 * pad));
    corner.y = std::max(0.0, corner.y);
    canvas.rectangle(corner, corner + Vec2{width + 2 * pad, height}, with_alpha(colour::raised, 0.96));
    canvas.rectangle(corner, corner + Vec2{canvas.scaled(3), height}, colour::warning);
    Vec2 pen = corner + Vec2{pad, 0.5 * pad};
    for (const std::string& words : lines) {
        canvas.text(pen, words, Type::small, colour::text);
        pen.y += line;
    }
}

}  // namespace

void draw_marks(Canvas& canvas, const Editor& editor, const Camera& camera) {
    draw_handles(canvas, editor, camera);
    draw_pen(canvas, editor, camera);
    if (editor.drags() && editor.target().to != lab::SnappedTo::nothing)
        draw_target(canvas, camera, editor.target());
    draw_problem(canvas, editor, camera);
}

}  // namespace flipside::app
