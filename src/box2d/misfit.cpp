#include "box2d/misfit.hpp"

#include <cmath>

#include "world/number_text.hpp"

namespace flipside::box2d {

std::optional<Misfit> misfit(const Ball& ball, const Units& units) {
    constexpr double most = 1e15;
    const auto found = [](const char* key, double value, const char* unit, const std::string& allowed) {
        return Misfit{key, "is " + number_text(value) + unit +
                               "; box2d computes in single precision, where allowed is " + allowed + unit};
    };
    const double longest = most / units.scale;  // m, or m/s
    const std::string short_of = "less than " + number_text(longest);
    if (!(ball.mass > 1 / most && ball.mass < most))
        return found("mass", ball.mass, " kg", "from " + number_text(1 / most) + " to " + number_text(most));
    if (!(units.distance(ball.radius) > 0))
        return found("radius", ball.radius, " m", "more than " + number_text(1e-45 / units.scale));
    if (!(ball.radius < longest)) return found("radius", ball.radius, " m", short_of);
    if (const double away = length(ball.position - units.origin); !(away < longest))
        return found("position", away, " m from the middle of the bounds", short_of);
    if (const double speed = length(ball.velocity); !(speed < longest))
        return found("velocity", speed, " m/s", short_of);
    if (!(std::abs(ball.angle) < most))
        return found("angle", ball.angle, " rad", "less than " + number_text(most));
    if (!(std::abs(ball.spin) < most))
        return found("spin", ball.spin, " rad/s", "less than " + number_text(most));
    return std::nullopt;
}

}  // namespace flipside::box2d
