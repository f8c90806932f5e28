#include "lab/game/ball_search.hpp"

#include <algorithm>

namespace flipside::lab {

namespace {

constexpr double between_moves = 0.8;  ///< s
constexpr double flip_seconds = 0.15;
constexpr double first_nudge = 0.25;  ///< m/s, as the window's keys do it
constexpr double most_nudge = 1;      ///< m/s
constexpr int moves_a_round = 4;

Vec2 direction(int move) {
    constexpr Vec2 ways[] = {{}, {-1, 0}, {1, 0}, {0, 1}};
    return ways[move];
}

bool waits_at(const std::optional<Launcher>& launcher, const Ball& ball) {
    return launcher && length(ball.position - launcher->position) < 2 * ball.radius;
}

}  // namespace

void BallSearch::follow(std::span<const Event> events, std::span<const Ball> balls, const Scene& scene,
                        double time) {
    const auto met = [&](BallNumber number) {
        const auto at = std::ranges::find(seen_, number, &Seen::ball);
        if (at != seen_.end()) at->met = time;
    };
    std::erase_if(seen_, [&](const Seen& seen) { return find_ball(balls, seen.ball) == nullptr; });
    for (const Ball& ball : balls)
        if (std::ranges::find(seen_, ball.number, &Seen::ball) == seen_.end())
            seen_.push_back({ball.number, time});
        else if (waits_at(scene.launcher, ball))
            met(ball.number);
    for (const Event& event : events) {
        if (event.kind != EventKind::impact && event.kind != EventKind::sensor_begin) continue;
        met(event.ball);
        if (event.other.is_ball) met(event.other.index);
    }
}

void BallSearch::lower_flippers(std::vector<Control>& does, const bool (&held)[2]) {
    for (const Side side : {Side::left, Side::right})
        if (!held[static_cast<int>(side)]) does.emplace_back(control::Flip{side, false});
    lower_at_ = -1;
}

void BallSearch::move(double time, std::vector<Control>& does) {
    const int kind = moves_ % moves_a_round, round = moves_ / moves_a_round;
    if (kind == 0) {
        does.emplace_back(control::Flip{Side::left, true});
        does.emplace_back(control::Flip{Side::right, true});
        lower_at_ = time + flip_seconds;
    } else {
        does.emplace_back(control::Nudge{std::min(most_nudge, (1 + round) * first_nudge) * direction(kind)});
    }
    ++moves_;
    next_move_ = time + between_moves;
}

std::vector<Control> BallSearch::look(std::span<const Event> events, std::span<const Ball> balls,
                                      const Scene& scene, const bool (&held)[2], double time) {
    std::vector<Control> does;
    follow(events, balls, scene, time);
    if (lower_at_ >= 0 && time >= lower_at_) lower_flippers(does, held);
    if (held[0] || held[1])
        for (Seen& seen : seen_) seen.met = time;
    const double patience = scene.rules->ball_search;
    const bool missing =
        std::ranges::any_of(seen_, [&](const Seen& seen) { return time - seen.met >= patience; });
    // A ball that only bounced where it lies is missing again soon: then the search goes on where it was.
    if (!missing && time >= next_move_ + 2 * patience) moves_ = 0;
    if (!missing || time < next_move_) return does;
    if (moves_ == 0) ++begun_;
    move(time, does);
    return does;
}

}  // namespace flipside::lab
