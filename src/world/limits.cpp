#include "world/limits.hpp"

#include <algorithm>
#include <cstdio>

#include "world/refusal.hpp"

namespace flipside {

namespace {

std::string shown(const char* format, double value) {
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string name_of(Other met, const Scene& scene) {
    return met.is_ball ? "ball " + std::to_string(met.index) : scene.parts[met.index].name;
}

[[noreturn]] void refuse(std::string_view engine, const Ball& ball, const std::string& where, double time) {
    const double speed = std::max(length(ball.velocity), std::abs(ball.spin) * ball.radius);
    throw Refusal(std::string(engine) + ": ball " + std::to_string(ball.number) + " has reached " +
                  shown("%.3g", speed) + " m/s" + where + " at " + shown("%.9g", time) +
                  " s; the top speed, of its centre and of its rim, is " + shown("%.0e", top_speed) + " m/s");
}

}  // namespace

void refuse_speed(std::string_view engine, const Ball& ball, Other met, double time, const Scene& scene) {
    refuse(engine, ball, " by an impact on " + name_of(met, scene), time);
}

void refuse_search(std::string_view engine, BallNumber ball, Other met, double time, const Scene& scene) {
    refuse_search(engine, ball, name_of(met, scene), time);
}

void refuse_search(std::string_view engine, BallNumber ball, const std::string& met, double time) {
    throw Refusal(std::string(engine) + ": ball " + std::to_string(ball) + " and " + met + ", from " +
                  shown("%.9g", time) +
                  " s on: the search for their next touch has passed its bound of steps");
}

void require_finite(std::string_view engine, const Event& event, const Scene& scene) {
    for (const double number :
         {event.point.x, event.point.y, event.normal.x, event.normal.y, event.speed, event.impulse})
        if (!std::isfinite(number))
            throw Refusal(std::string(engine) + ": ball " + std::to_string(event.ball) + " and " +
                          (event.kind == EventKind::lost ? "the bounds" : name_of(event.other, scene)) +
                          " at " + shown("%.9g", event.time) +
                          " s: what they do to each other is beyond the numbers of this engine");
}

void require_limits(std::string_view engine, std::span<const Ball> balls, double time) {
    for (const Ball& ball : balls) {
        if (!within_top_speed(ball)) refuse(engine, ball, "", time);
        if (!within_reach(ball))
            throw Refusal(std::string(engine) + ": ball " + std::to_string(ball.number) + " is " +
                          shown("%.3g", length(ball.position)) + " m away at " + shown("%.9g", time) +
                          " s; the farthest coordinate of a world is " + shown("%.0e", farthest) + " m");
    }
    if (!(time <= last_time))
        throw Refusal(std::string(engine) + ": the time has reached " + shown("%.9g", time) +
                      " s; the last time of a world is " + shown("%.0e", last_time) + " s");
}

}  // namespace flipside
