#include "lab/sweep/measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

#include "lab/process/cpu_clock.hpp"

namespace flipside::lab::sweep {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

auto by_pair(const Event& event) {
    return std::tuple(event.ball, event.other);
}

/// The impacts by ball and other, then time.
std::vector<Event> sorted(std::span<const Event> events) {
    std::vector<Event> impacts;
    for (const Event& event : events)
        if (event.kind == EventKind::impact) impacts.push_back(event);
    std::ranges::stable_sort(impacts, [](const Event& a, const Event& b) {
        return std::tuple(by_pair(a), a.time) < std::tuple(by_pair(b), b.time);
    });
    return impacts;
}

std::uint64_t steps_in(const Window& window, double dt) {
    return static_cast<std::uint64_t>(std::llround(window.seconds / dt));
}

/// Both errors, or the failure.
void compare_ends(std::span<const Ball> balls, const Window& window, Outcome& outcome) {
    std::vector<double> of_hit;
    for (const Window::End& end : window.ends) {
        const auto ball = std::ranges::lower_bound(balls, end.ball, {}, &Ball::number);
        if (ball == balls.end() || ball->number != end.ball) {
            outcome.failure = "lost ball";
            return;
        }
        const double error = length(ball->position - end.position) / end.radius;
        if (!std::isfinite(error)) {
            outcome.failure = "not a number";
            return;
        }
        outcome.error = std::max(outcome.error, error);
        if (end.hit) of_hit.push_back(error);
    }
    const auto middle = of_hit.begin() + static_cast<std::ptrdiff_t>((of_hit.size() - 1) / 2);
    std::ranges::nth_element(of_hit, middle);
    outcome.typical = *middle;
}

/// The impacts of an outcome, and the errors of one that failed.
void count_impacts(std::span<const Event> impacts, const Window& window, double dt, Outcome& outcome) {
    if (!outcome.failure.empty()) outcome.error = outcome.typical = infinite;
    const double end = window.start.clock.time + window.seconds;
    const Unmatched unmatched = count_unmatched(window.impacts, impacts, match_tolerance(dt), end);
    outcome.impacts = window.impacts.size();
    outcome.missed = unmatched.first;
    outcome.spurious = unmatched.second;
}

}  // namespace

Unmatched count_unmatched(std::span<const Event> first, std::span<const Event> second, double tolerance,
                          double end) {
    const std::vector<Event> a = sorted(first), b = sorted(second);
    Unmatched unmatched;
    const auto counts = [&](const Event& event) { return event.time < end - tolerance ? 1U : 0U; };
    std::size_t i = 0, j = 0;
    while (i < a.size() || j < b.size()) {
        const bool same = i < a.size() && j < b.size() && by_pair(a[i]) == by_pair(b[j]);
        if (same && std::abs(a[i].time - b[j].time) <= tolerance) {
            ++i, ++j;
            continue;
        }
        const auto key = [](const Event& event) { return std::tuple(by_pair(event), event.time); };
        if (j == b.size() || (i < a.size() && key(a[i]) < key(b[j])))
            unmatched.first += counts(a[i++]);
        else
            unmatched.second += counts(b[j++]);
    }
    return unmatched;
}

Outcome run_window(World& world, const Window& window, double dt, History& history, double most_seconds) {
    Outcome outcome;
    const double began = cpu_seconds();
    history.dt = dt;
    history.end = window.start.clock.time + window.seconds;
    std::vector<Event> impacts;
    try {
        world.restore(window.start);
        history.begin(world);
        for (std::uint64_t step = steps_in(window, dt); step > 0; --step) {
            world.step(dt);
            history.add(world, world.events());
            for (const Event& event : world.events())
                if (event.kind == EventKind::impact) impacts.push_back(event);
            if (std::isfinite(most_seconds) && cpu_seconds() - began > most_seconds)
                throw std::runtime_error("it takes too long");
        }
        compare_ends(world.balls(), window, outcome);
    } catch (const std::runtime_error& error) {
        outcome.failure = "refused";
        outcome.why = error.what();
    }
    count_impacts(impacts, window, dt, outcome);
    return outcome;
}

Outcome refused_window(const Window& window, double dt, const std::string& why) {
    Outcome outcome;
    outcome.failure = "refused";
    outcome.why = why;
    count_impacts({}, window, dt, outcome);
    return outcome;
}

bool diverged(const Outcome& outcome) {
    return outcome.error > exact_radii;
}

Blame blame_of(const Outcome& outcome, const Window& window, const History& history, const Scene& scene,
               World* own, World& exact) {
    std::vector<KnownEnd> ends;
    for (const Window::End& end : window.ends) ends.push_back({end.ball, end.position, end.radius});
    return find_blame({scene, history, ends, outcome.error, own}, exact);
}

double time_window(World& world, const Window& window, double dt) {
    try {
        const std::uint64_t steps = steps_in(window, dt), warm_up = 8;
        world.restore(window.start);
        for (std::uint64_t step = 0; step < std::min(steps, warm_up); ++step) world.step(dt);
        world.restore(window.start);
        const double began = cpu_seconds();
        double elsewhere = 0;
        for (std::uint64_t step = 0; step < steps; ++step) {
            world.step(dt);
            elsewhere += world.statistics().cpu_seconds.value_or(0);
        }
        return world.statistics().cpu_seconds ? elsewhere : cpu_seconds() - began;
    } catch (const std::runtime_error&) {
        return std::nan("");
    }
}

}  // namespace flipside::lab::sweep
