#include "app/window/pick_view.hpp"

#include <algorithm>

#include "app/window/words.hpp"

namespace flipside::app {

namespace {

/// A band back to the hand, an arrow where the ball will go, and how fast.
void draw_sling(Canvas& canvas, const Camera& camera, const Ball& ball, const Sling& sling) {
    const Vec2 at = camera.to_pixels(ball.position), held = camera.to_pixels(sling.held);
    const Vec2 away = at - held;
    canvas.line(at, held, canvas.scaled(1.5), with_alpha(colour::text, 0.6));
    canvas.disc(held, canvas.scaled(3), colour::text);
    canvas.arrow(at, at + away, canvas.scaled(2.5), colour::lit);
    const std::string words = with_unit(length(sling.velocity), 2, "m/s");
    const double pad = canvas.scaled(5), line = canvas.lettering().line_height(Type::small);
    const double width = canvas.lettering().width(words, Type::small) + 2 * pad;
    // Beside the hand, and never out of the pane.
    const Vec2 corner{std::clamp(held.x + 2 * pad, 0.0, std::max(0.0, camera.size.x - width)),
                      std::clamp(held.y - line - 2 * pad, 0.0, std::max(0.0, camera.size.y - line - pad))};
    canvas.rectangle(corner, corner + Vec2{width, line + pad}, with_alpha(colour::raised, 0.9));
    canvas.text(corner + Vec2{pad, 0.5 * pad}, words, Type::small, colour::lit);
}

}  // namespace

void draw_picked(Canvas& canvas, const Camera& camera, std::span<const Ball> balls, const Look& look) {
    if (look.picked && look.picked->is_ball)
        if (const Ball* ball = find_ball(balls, look.picked->index))
            canvas.ring(camera.to_pixels(ball->position), camera.scale * ball->radius + canvas.scaled(4),
                        canvas.scaled(1.5), colour::lit);
    if (look.sling)
        if (const Ball* ball = find_ball(balls, look.sling->ball))
            draw_sling(canvas, camera, *ball, *look.sling);
}

}  // namespace flipside::app
