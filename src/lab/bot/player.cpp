#include "lab/bot/player.hpp"

#include <algorithm>

namespace flipside::lab::bot {

namespace {

constexpr double held = 0.15;         ///< s that a flipper is raised at least
constexpr double between = 0.1;       ///< s from letting a flipper fall to raising it again, at least
constexpr double closing = 0.03;      ///< s that a flipper takes to come up to a ball
constexpr double falling = 0.4;       ///< m/s towards a flipper; a ball that rolls down one is slower
constexpr double depth = 0.03;        ///< m below a flipper's line at which a ball may be believed to be
constexpr double nudge_speed = 0.25;  ///< m/s, as the window's keys do it
/// s between nudges: a third of a tilt's usual three within three seconds is never exceeded.
constexpr double between_nudges = 2;
constexpr double nudges_in = 0.5;  ///< share of the balls on their way out that it nudges at

/// From −1 to 1, mostly near 0: the mean of three even ones.
double around_zero(Dice& dice) {
    return (dice.between(-1, 1) + dice.between(-1, 1) + dice.between(-1, 1)) / 3;
}

}  // namespace

Player::Player(std::shared_ptr<const Scene> scene, std::uint64_t seed)
    : scene_(std::move(scene)), dice_(seed) {
    for (const Part& part : scene_->parts) {
        const auto* flip = std::get_if<motion::Flip>(&part.motion);
        if (!flip) continue;
        const auto& flipper = std::get<shape::Flipper>(part.shape.is);
        const Vec2 along = from_angle(flipper.rest);
        const Vec2 up = flip->raised > flipper.rest ? perp(along) : -perp(along);
        fingers_.push_back({flipper, flip->side, along, up});
        aim(fingers_.back());
    }
}

void Player::aim(Finger& finger) {
    finger.aim = finger.flipper.length * dice_.between(0.35, 1);
    // The root of 9: three times the spread of the mean of three even ones is 1.
    finger.misjudgement = 3 * misjudged * around_zero(dice_);
}

std::vector<Control> Player::act(double time, std::span<const Ball> balls, const Game& game) {
    seen_.push_back({time, {balls.begin(), balls.end()}});
    while (seen_.size() > 1 && seen_[1].time <= time - reaction) seen_.pop_front();
    std::vector<Control> does;
    if (seen_.front().time <= time - reaction) {
        flip(time, does);
        save_by_nudge(time, does);
    }
    plunge(time, balls, game, does);
    return does;
}

Ball Player::believed(const Ball& seen, double since) const {
    Ball ball = seen;
    ball.velocity += since * scene_->gravity;
    ball.position += 0.5 * since * (seen.velocity + ball.velocity);
    return ball;
}

bool Player::in_reach(const Finger& finger, const Ball& ball) {
    const Vec2 from_pivot = ball.position - finger.flipper.pivot;
    const double along = dot(from_pivot, finger.along), height = dot(from_pivot, finger.up);
    const double nearing = std::max(0.0, -dot(ball.velocity, finger.up));
    const double surface = ball.radius + finger.flipper.base_radius;
    // The aim is for what rolls down the flipper; what falls on it is hit where it falls.
    const double from = nearing > falling ? 0.25 * finger.flipper.length : finger.aim;
    return along >= from && along <= finger.flipper.length + ball.radius && height >= -depth &&
           height <= surface + closing * nearing && dot(ball.velocity, finger.along) > -0.2;
}

void Player::flip(double time, std::vector<Control>& does) {
    const Observation& observed = seen_.front();
    for (Finger& finger : fingers_) {
        if (finger.release_at >= 0) {
            if (time < finger.release_at) continue;
            does.emplace_back(control::Flip{finger.side, false});
            finger.release_at = -1;
            finger.busy_until = time + between;
            aim(finger);
            continue;
        }
        if (time < finger.busy_until) continue;
        const double since = std::max(0.0, time - observed.time + finger.misjudgement);
        const auto comes = [&](const Ball& ball) { return in_reach(finger, believed(ball, since)); };
        if (std::ranges::none_of(observed.balls, comes)) continue;
        does.emplace_back(control::Flip{finger.side, true});
        finger.release_at = time + held + dice_.below(held);
    }
}

/// A ball that will come down out of reach of every flipper is pushed towards the nearest one.
void Player::save_by_nudge(double time, std::vector<Control>& does) {
    if (time < nudges_again_ || fingers_.empty()) return;
    const Observation& observed = seen_.front();
    for (const Ball& seen : observed.balls) {
        const Ball ball = believed(seen, time - observed.time);
        const Finger* nearest = nullptr;
        double gap = 0;
        for (const Finger& finger : fingers_) {
            const Vec2 tip = finger.flipper.pivot + finger.flipper.length * finger.along;
            const double above = ball.position.y - tip.y;
            // Out of reach is what passes beyond the tip; what is far from all flippers, or high, may wait.
            const double beyond = dot(ball.position - tip, finger.along) - ball.radius;
            if (ball.velocity.y > -0.3 || above < 0 || above > 0.12 || beyond < 0 ||
                beyond > finger.flipper.length)
                continue;
            if (!nearest || beyond < gap) nearest = &finger, gap = beyond;
        }
        const auto reached = [&](const Finger& finger) {
            return std::abs(ball.position.x - finger.flipper.pivot.x) <
                   std::abs(finger.along.x) * finger.flipper.length;
        };
        if (!nearest || std::ranges::any_of(fingers_, reached)) continue;
        nudges_again_ = time + between_nudges;
        if (dice_.below(1) >= nudges_in) return;
        const double sense = nearest->flipper.pivot.x < ball.position.x ? -1 : 1;
        does.emplace_back(control::Nudge{{sense * nudge_speed, 0}});
        return;
    }
}

void Player::plunge(double time, std::span<const Ball> balls, const Game& game, std::vector<Control>& does) {
    const bool ready =
        game.permits(control::Launch{}, balls) &&
        std::ranges::all_of(balls, [](const Ball& ball) { return length(ball.velocity) < 0.05; });
    if (!ready) {
        fires_.reset();
    } else if (!fires_) {
        fires_ = time + dice_.between(0.5, 1.5);
    } else if (time >= *fires_) {
        does.emplace_back(control::Launch{dice_.between(0.55, 1)});
        fires_.reset();
    }
}

}  // namespace flipside::lab::bot
