#include "lab/blame/continuation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/session/session.hpp"
#include "world/refusal.hpp"

namespace flipside::lab {

namespace {

constexpr double same_time = 1e-9;  // s
constexpr double infinite = std::numeric_limits<double>::infinity();

void step_to(World& world, double time, double longest, std::vector<Event>& events) {
    while (time - world.time() > same_time) {
        world.step(std::min(longest, time - world.time()));
        for (const Event& event : world.events())
            if (event.kind == EventKind::impact || event.kind == EventKind::begin) events.push_back(event);
    }
}

}  // namespace

bool is_number(const Ball& ball) {
    return is_finite(ball.position) && is_finite(ball.velocity) && std::isfinite(ball.spin) &&
           std::isfinite(ball.angle);
}

std::vector<Event> go_on(World& world, const State& state, double time, const History& history) {
    const Script& script = history.script;
    const bool launches = !state.launches.empty() || std::ranges::any_of(script, [](const TimedControl& one) {
        return std::holds_alternative<control::Launch>(one.control);
    });
    constexpr double long_step = 0.5;  // s
    const double longest = launches ? history.dt : long_step;
    std::vector<Event> events;
    world.restore(state);
    for (std::size_t next = next_control(script, state.clock.time);
         next < script.size() && script[next].time < time - same_time; ++next) {
        step_to(world, script[next].time, longest, events);
        world.apply(script[next].control);
    }
    step_to(world, time, longest, events);
    return events;
}

Worst worst(std::span<const Ball> balls, std::span<const KnownEnd> ends) {
    Worst found;
    for (const KnownEnd& end : ends) {
        const Ball* ball = find_ball(balls, end.ball);
        const double apart =
            ball && is_number(*ball) ? length(ball->position - end.position) / end.radius : infinite;
        if (apart > found.radii) found = {apart, end.ball};
    }
    return found;
}

Worst worst_if_exact_from(const State& state, const History& history, std::span<const KnownEnd> ends,
                          World& exact) {
    const auto bad = std::ranges::find_if_not(state.balls, is_number);
    if (bad != state.balls.end()) return {infinite, bad->number};
    try {
        go_on(exact, state, history.end, history);
    } catch (const Refusal&) {
        // The nearest to a culprit that is known is the worst ball of the state itself.
        return {infinite, worst(state.balls, ends).ball};
    }
    return worst(exact.balls(), ends);
}

}  // namespace flipside::lab
