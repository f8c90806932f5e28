#include "lab/session/run.hpp"

#include <algorithm>
#include <string>

namespace flipside::lab {

namespace {

bool is_finite(const Ball& ball) {
    return flipside::is_finite(ball.position) && flipside::is_finite(ball.velocity) &&
           std::isfinite(ball.angle) && std::isfinite(ball.spin);
}

}  // namespace

void check_finite(const Session& session, double time) {
    const auto balls = session.world().balls();
    const auto bad = std::ranges::find_if_not(balls, is_finite);
    if (bad == balls.end()) return;
    throw NotANumber("ball " + std::to_string(bad->number) + " is not a number any more at " +
                     std::to_string(time) + " s (engine " + std::string(session.engine().name) + ")");
}

void run(std::span<Session> sessions, const Timeline& timeline, const Script& script, const Watcher& after) {
    std::vector<std::size_t> next(sessions.size(), next_control(script, timeline.start()));
    for (std::uint64_t k = 0; k < timeline.steps(); ++k) {
        for (std::size_t i = 0; i < sessions.size(); ++i) {
            Session& session = sessions[i];
            session.step(timeline.length(k), script, next[i]);
            const double time = k + 1 == timeline.steps() ? timeline.end() : session.world().time();
            check_finite(session, time);
            after(session, k, time);
        }
    }
}

void run_on(Session& session, const Timeline& steps, const Script& script, std::size_t& next,
            const Watcher& after) {
    for (std::uint64_t k = 0; k < steps.steps(); ++k) {
        session.step(steps.length(k), script, next);
        const double time = session.world().time();
        check_finite(session, time);
        after(session, k, time);
    }
}

std::uint64_t overlaps(std::span<const Ball> balls) {
    constexpr double same_place = 1e-6;
    std::vector<const Ball*> by_x;
    double reach = 0;
    for (const Ball& ball : balls) {
        by_x.push_back(&ball);
        reach = std::max(reach, same_place * ball.radius);
    }
    std::ranges::sort(by_x, {}, [](const Ball* ball) { return ball->position.x; });
    std::vector<bool> overlapped(by_x.size());
    for (std::size_t i = 0; i < by_x.size(); ++i) {
        for (std::size_t j = i + 1; j < by_x.size(); ++j) {
            const Vec2 apart = by_x[j]->position - by_x[i]->position;
            if (apart.x > reach) break;
            if (length(apart) < same_place * std::min(by_x[i]->radius, by_x[j]->radius))
                overlapped[i] = overlapped[j] = true;
        }
    }
    return static_cast<std::uint64_t>(std::ranges::count(overlapped, true));
}

}  // namespace flipside::lab
