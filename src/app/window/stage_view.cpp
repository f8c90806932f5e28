#include "app/window/stage_view.hpp"

#include <algorithm>

#include "app/window/constructions.hpp"
#include "app/window/theme.hpp"

namespace flipside::app {

namespace {

/// Draws one item by the names of its fields, which mean the same in every engine's trace.
class ItemView {
  public:
    ItemView(Canvas& canvas, const Camera& camera, const TraceItem& item, std::span<const Ball> balls,
             bool picked, sf::Color color)
        : canvas_(canvas),
          camera_(camera),
          item_(item),
          balls_(balls),
          picked_(picked),
          color_(color),
          width_(canvas.scaled(picked ? 2.5 : 1)) {}

    void draw() const {
        if (const auto* box = value<Box>("box"))
            rectangle(*box, picked_ ? 1 : item_.kind == "cell" ? 0.25 : 0.4);
        if (const auto* tight = value<Box>("tight_box"); tight != nullptr && picked_) rectangle(*tight, 0.7);
        const Ball* ball = ball_of("ball");
        const Ball* other = ball_of("other_ball");
        if (ball != nullptr && picked_) ring(*ball);
        if (other != nullptr && picked_) ring(*other);
        if (item_.kind == "test" && ball != nullptr && other != nullptr)
            line(ball->position, other->position, verdict());
        way("position_before", "position");
        way("other_position_before", "other_position");
        if (const auto* point = value<Vec2>("point")) contact(*point);
        if (picked_ && ball != nullptr && item_.find("swept") == nullptr) {
            arrow(*ball, "velocity_before", colour::quiet);
            arrow(*ball, "velocity", color_);
        }
        if (picked_ && other != nullptr) {
            arrow(*other, "other_velocity_before", colour::quiet);
            arrow(*other, "other_velocity", color_);
        }
    }

  private:
    template <class T>
    [[nodiscard]] const T* value(std::string_view name) const {
        const TraceValue* found = item_.find(name);
        return found == nullptr ? nullptr : std::get_if<T>(found);
    }
    [[nodiscard]] const Ball* ball_of(std::string_view name) const {
        const auto* number = value<std::int64_t>(name);
        if (number == nullptr) return nullptr;
        const auto at = std::ranges::find(balls_, static_cast<BallNumber>(*number), &Ball::number);
        return at == balls_.end() ? nullptr : &*at;
    }
    /// Boxes that overlap stand out; those that do not are barely there.
    [[nodiscard]] sf::Color verdict() const {
        const auto* overlap = value<bool>("overlap");
        const bool yes = overlap == nullptr || *overlap;
        return with_alpha(yes ? colour::pairs : colour::quiet, picked_ ? 1 : yes ? 0.8 : 0.25);
    }
    void line(Vec2 a, Vec2 b, sf::Color color) const {
        canvas_.line(camera_.to_pixels(a), camera_.to_pixels(b), width_, color);
    }
    void rectangle(const Box& box, double alpha) const {
        const Vec2 a = camera_.to_pixels(box.min), b = camera_.to_pixels(box.max);
        const Vec2 corners[] = {a, {b.x, a.y}, b, {a.x, b.y}};
        const sf::Color own = item_.kind == "cell" ? colour::cells : colour::boxes;
        canvas_.stroke(corners, true, width_, with_alpha(own, alpha));
    }
    void ring(const Ball& ball) const {
        canvas_.ring(camera_.to_pixels(ball.position), camera_.scale * ball.radius + canvas_.scaled(3),
                     width_, colour::lit);
    }
    void way(std::string_view from, std::string_view to) const {
        const auto *a = value<Vec2>(from), *b = value<Vec2>(to);
        if (a == nullptr || b == nullptr || *a == *b) return;
        line(*a, *b, with_alpha(color_, picked_ ? 1 : 0.7));
        const Ball* ball = ball_of(from.starts_with("other") ? "other_ball" : "ball");
        if (ball != nullptr)
            canvas_.ring(camera_.to_pixels(*a), camera_.scale * ball->radius, canvas_.scaled(1),
                         with_alpha(colour::quiet, 0.7));
    }
    void contact(Vec2 point) const {
        const auto* overlap = value<bool>("overlap");
        const bool apart = overlap != nullptr && !*overlap;
        const sf::Color own = with_alpha(apart ? colour::quiet : colour::warning, picked_ ? 1 : 0.8);
        const Vec2 at = camera_.to_pixels(point);
        if (const auto* center = value<Vec2>("center")) line(*center, point, with_alpha(own, 0.6));
        canvas_.disc(at, canvas_.scaled(picked_ ? 4 : 2.5), own);
        const auto* normal = value<Vec2>("normal");
        if (normal != nullptr && !(*normal == Vec2{}))
            canvas_.arrow(at, at + canvas_.scaled(picked_ ? 26 : 14) * Vec2{normal->x, -normal->y}, width_,
                          own);
    }
    /// The way of a tenth of a second.
    void arrow(const Ball& ball, std::string_view name, sf::Color color) const {
        const auto* velocity = value<Vec2>(name);
        if (velocity == nullptr || *velocity == Vec2{}) return;
        canvas_.arrow(camera_.to_pixels(ball.position), camera_.to_pixels(ball.position + 0.1 * *velocity),
                      width_, color);
    }

    Canvas& canvas_;
    const Camera& camera_;
    const TraceItem& item_;
    std::span<const Ball> balls_;
    bool picked_;
    sf::Color color_;
    double width_;
};

/// Box2D's box with room to move, and the one without.
void draw_fat_box(const Construction& drawn) {
    const auto &fat = drawn.item.get<Box>("box"), &tight = drawn.item.get<Box>("tight_box");
    const double most = std::max(
        {fat.max.x - tight.max.x, fat.max.y - tight.max.y, tight.min.x - fat.min.x, tight.min.y - fat.min.y});
    const bool ball = drawn.item.find("ball") != nullptr;
    drawn.word(
        {0.5 * (fat.min.x + fat.max.x), fat.max.y}, {0, 1}, 3,
        "fat box: up to " + short_length(most) + (ball ? " more, for where the ball goes next" : " more"),
        colour::boxes);
    drawn.word({0.5 * (tight.min.x + tight.max.x), tight.min.y}, {0, -1}, 3,
               ball ? "what the ball swept in this step" : "its own box", colour::boxes);
}

/// What the picked item comes from, with words. Under the item itself.
void draw_construction(const Construction& drawn, std::span<const Ball> balls) {
    const std::string& kind = drawn.item.kind;
    if (kind == "closest" && drawn.item.find("shape") != nullptr) draw_closest(drawn);
    if (kind == "axis") draw_axes(drawn);
    if (kind == "cell" || kind == "test" || kind == "search") draw_cells(drawn);
    if (kind == "fat box") draw_fat_box(drawn);
    const auto radius_of = [&](const char* name) {
        const auto* number = drawn.value<std::int64_t>(name);
        if (number == nullptr) return 0.0;
        const auto at = std::ranges::find(balls, static_cast<BallNumber>(*number), &Ball::number);
        return at == balls.end() ? 0.0 : at->radius;
    };
    if (const double radius = radius_of("ball"); radius > 0)
        draw_sweep(drawn, radius, radius_of("other_ball"));
}

}  // namespace

void draw_stage_items(Canvas& canvas, const Camera& camera, const TraceStage& stage, std::size_t picked,
                      std::span<const Ball> balls, sf::Color color) {
    // A heap's trace may have more than anybody can see.
    constexpr std::size_t most = 5000;
    const std::size_t shown = std::min(stage.items.size(), most);
    for (std::size_t i = 0; i < shown; ++i)
        if (i != picked) ItemView(canvas, camera, stage.items[i], balls, false, color).draw();
    if (picked >= stage.items.size()) return;
    Labels labels(canvas, camera.size, canvas.scaled(34));
    draw_construction({canvas, camera, labels, stage, stage.items[picked], color}, balls);
    ItemView(canvas, camera, stage.items[picked], balls, true, color).draw();
}

}  // namespace flipside::app
