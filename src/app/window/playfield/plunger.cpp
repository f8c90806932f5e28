#include "app/window/playfield/plunger.hpp"

#include <vector>

#include "app/window/theme.hpp"

namespace flipside::app {

void draw_plunger(Canvas& canvas, const Camera& camera, const Launcher& launcher, double charge) {
    const double radius = camera.scale * launcher.ball.radius;
    const Vec2 at = camera.to_pixels(launcher.position);
    const Vec2 way{launcher.direction.x, -launcher.direction.y}, aside = perp(way);
    // In radii behind the middle of the ball: the head, and the collar that the spring is pressed against.
    const double head = 1 + 1.6 * charge, collar = 4;
    const auto behind = [&](double radii, double across) {
        return at - radius * radii * way + radius * across * aside;
    };
    canvas.line(behind(head, 0), behind(collar + 0.6 + 1.6 * charge, 0), canvas.scaled(2.5), colour::part);
    constexpr int turns = 6;
    std::vector<Vec2> spring;
    for (int i = 0; i <= 2 * turns; ++i) {
        const double along = static_cast<double>(i) / (2 * turns);
        spring.push_back(behind(head + 0.25 + along * (collar - head - 0.25), i % 2 == 0 ? -0.42 : 0.42));
    }
    canvas.stroke(spring, false, canvas.scaled(1.2), blend(colour::part, colour::solid, 0.3));
    canvas.line(behind(head, -0.62), behind(head, 0.62), canvas.scaled(4),
                blend(colour::kicker, colour::lit, charge));
    canvas.line(behind(collar, -0.75), behind(collar, 0.75), canvas.scaled(3), colour::solid);
}

}  // namespace flipside::app
