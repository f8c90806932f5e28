#include "app/window/playfield/ground.hpp"

#include <algorithm>
#include <cmath>

#include <SFML/Graphics/Sprite.hpp>

#include "app/window/draw_shapes.hpp"
#include "app/window/theme.hpp"

namespace flipside::app {

namespace {

const sf::Color shallow(0x20, 0x2a, 0x35), coast(0x82, 0x6e, 0x4e), line(0x3a, 0x46, 0x54);

sf::Vector2f vector(Vec2 p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y)};
}

/// From the tint at the coast to the table's own where it is deepest, quickly at first.
sf::Color tint(const Chart& chart, double depth) {
    const double t = std::clamp(depth / (0.7 * Chart::levels * chart.interval), 0.0, 1.0);
    return blend(shallow, colour::table, t * (2 - t));
}

sf::Image tints_of(const Chart& chart) {
    sf::Image image;
    image.create(static_cast<unsigned>(chart.columns), static_cast<unsigned>(chart.rows));
    for (int row = 0; row < chart.rows; ++row)
        for (int column = 0; column < chart.columns; ++column)
            image.setPixel(static_cast<unsigned>(column), static_cast<unsigned>(row),
                           tint(chart, chart.at(column, row)));
    return image;
}

}  // namespace

bool Ground::draw(sf::RenderTarget& target, Canvas& canvas, const std::shared_ptr<const Scene>& scene,
                  const Camera& camera, bool dimmed) {
    const sf::Vector2u size(static_cast<unsigned>(std::ceil(camera.size.x)),
                            static_cast<unsigned>(std::ceil(camera.size.y)));
    if (picture_.getSize() != size) {
        painted_for_.reset();
        if (!picture_.create(size.x, size.y)) return false;
    }
    if (scene != scene_) survey(scene);
    if (painted_for_ != camera) paint(canvas, camera);
    sf::Sprite sprite(picture_.getTexture());
    const sf::Uint8 strength = dimmed ? 90 : 255;
    sprite.setColor({255, 255, 255, strength});
    target.draw(sprite);
    return true;
}

void Ground::survey(const std::shared_ptr<const Scene>& scene) {
    scene_ = scene;
    chart_ = chart_of(*scene);
    inserts_ = inserts_of(*scene, chart_);
    tints_.loadFromImage(tints_of(chart_));
    tints_.setSmooth(true);
    painted_for_.reset();
}

void Ground::paint(Canvas& canvas, const Camera& camera) {
    painted_for_ = camera;
    picture_.clear(colour::around);
    // The middle of a pixel of the tints is where its sample lies.
    const Vec2 low = chart_.box.min - 0.5 * chart_.spacing * Vec2{1, 1};
    sf::Sprite tints(tints_);
    const auto scale = static_cast<float>(chart_.spacing * camera.scale);
    tints.setPosition(vector(camera.to_pixels(low)));
    tints.setScale(scale, -scale);
    picture_.draw(tints);
    paint_lines(canvas, camera);
    // Samples go on past the table's bounds.
    const Vec2 a = camera.to_pixels(chart_.box.min), b = camera.to_pixels(chart_.box.max);
    canvas.rectangle({0, 0}, {camera.size.x, b.y}, colour::around);
    canvas.rectangle({b.x, 0}, camera.size, colour::around);
    canvas.rectangle({0, 0}, {a.x, camera.size.y}, colour::around);
    canvas.rectangle({0, a.y}, camera.size, colour::around);
    paint_shadows(canvas, camera);
    canvas.flush(picture_);
    picture_.display();
}

void Ground::paint_lines(Canvas& canvas, const Camera& camera) const {
    for (const Chart::Stroke& stroke : chart_.strokes) {
        const Vec2 a = camera.to_pixels(stroke.a), b = camera.to_pixels(stroke.b);
        if (std::max(a.x, b.x) < 0 || std::max(a.y, b.y) < 0 || std::min(a.x, b.x) > camera.size.x ||
            std::min(a.y, b.y) > camera.size.y)
            continue;
        const double faint = 1 - 0.7 * (stroke.level - 1) / (Chart::levels - 1);
        canvas.line(a, b, canvas.scaled(1),
                    stroke.level == 1 ? with_alpha(coast, 0.55) : with_alpha(line, 0.8 * faint));
    }
}

/// Of what always stands where it is. The light comes from the upper left, as it does on the balls.
void Ground::paint_shadows(Canvas& canvas, const Camera& camera) const {
    const double height = camera.scale * 0.35 * chart_.interval;
    Camera moved = camera;
    moved.pan({0.8 * height, height});
    const ShapeStyle shadow{with_alpha(sf::Color::Black, 0.4), with_alpha(sf::Color::Black, 0.4),
                            canvas.scaled(4)};
    for (const Part& part : scene_->parts)
        if (is_coast(part)) draw_shape(canvas, moved, part.shape, {}, shadow);
}

}  // namespace flipside::app
