#include "custom/sleep.hpp"

#include <algorithm>

namespace flipside::custom {

namespace {

/// Balls that overlap anything by more than this, in radii, are on their way out of it.
constexpr double most_overlap = 0.005;
/// In an island of several balls: speeds and gains of speed that are rest, in units of what gravity gives
/// in a step.
constexpr double island_speed = 0.05;
constexpr double island_gain = 0.02;
/// A ball that gains more than this part of what gravity gives in a step is not held.
constexpr double falling = 0.5;

std::size_t place_of(std::span<const Ball> balls, BallNumber number) {
    return static_cast<std::size_t>(std::ranges::lower_bound(balls, number, {}, &Ball::number) -
                                    balls.begin());
}

}  // namespace

void Sleep::reserve(std::size_t balls) {
    make_room(before_, balls);
    make_room(members_, balls);
    make_room(slow_, balls, 1);
}

void Sleep::watch(std::span<const Ball> balls, double dt) {
    fast_ = fast_squared(dt);
    if (known_for_ != fast_) {
        begin_look(balls.size());
        for (std::size_t i = 0; i < balls.size(); ++i) look(i, balls[i]);
    }
    before_.clear();
    for (const std::uint32_t i : slow())
        before_.push_back({balls[i].number, balls[i].position, balls[i].velocity});
}

bool Sleep::may_settle(std::span<const Ball> balls) const {
    return !before_.empty() && std::ranges::any_of(slow(), [&](std::uint32_t i) { return !balls[i].asleep; });
}

bool Sleep::settle(std::span<Ball> balls, std::span<const Contact> contacts, double dt) {
    known_for_ = fast_;
    if (!may_settle(balls)) return false;
    find_islands(balls, contacts);
    for (const std::uint32_t i : slow()) {
        if (balls[i].asleep) continue;
        const auto before = std::ranges::lower_bound(before_, balls[i].number, {}, &Before::number);
        const bool was_fast = before == before_.end() || before->number != balls[i].number;
        if (was_fast || moved(*before, balls[i], members_[i].in_company, dt))
            members_[island_of(i)].moves = true;
    }
    bool any = false;
    for (const std::uint32_t i : slow()) {
        if (balls[i].asleep || members_[island_of(i)].moves) continue;
        balls[i].asleep = any = true;
        balls[i].velocity = {};
        balls[i].spin = 0;
    }
    return any;
}

void Sleep::find_islands(std::span<const Ball> balls, std::span<const Contact> contacts) {
    if (members_.size() < balls.size()) members_.resize(balls.size());
    const auto alone = [&](std::size_t i) {
        const Ball& ball = balls[i];
        members_[i] = {i, !ball.asleep && length_squared(ball.velocity) > fast_};
    };
    for (const std::uint32_t i : slow()) alone(i);
    for (const Contact& contact : contacts) {
        alone(place_of(balls, contact.ball));
        if (contact.other.is_ball) alone(place_of(balls, contact.other.index));
    }
    for (const Contact& contact : contacts) join(balls, contact);
}

/// The ball that stands for an island, by place: sets joined under the lower place, paths halved on the way
/// (Tarjan 1975, "Efficiency of a good but not linear set union algorithm").
std::size_t Sleep::island_of(std::size_t i) {
    while (members_[i].island != i) i = members_[i].island = members_[members_[i].island].island;
    return i;
}

/// Awake balls in touch belong to one island.
void Sleep::join(std::span<const Ball> balls, const Contact& contact) {
    // A sleeper's own motion is none of its neighbours' business.
    const auto squeeze = [&](std::size_t i) {
        if (-contact.separation > most_overlap * balls[i].radius && !balls[i].asleep)
            members_[island_of(i)].moves = true;
    };
    const std::size_t a = place_of(balls, contact.ball);
    squeeze(a);
    if (!contact.other.is_ball) return;
    const std::size_t b = place_of(balls, contact.other.index);
    squeeze(b);
    members_[a].in_company = members_[b].in_company = true;
    if (balls[a].asleep || balls[b].asleep) return;
    const std::size_t first = std::min(island_of(a), island_of(b)),
                      second = std::max(island_of(a), island_of(b));
    members_[second].island = first;
    members_[first].moves |= members_[second].moves;
}

/// Below this a ball may be at rest, m/s.
double Sleep::slow(bool in_company, double dt) const {
    return in_company ? std::max(speed_, island_speed * gravity_ * dt) : speed_;
}

/// Who is faster before or after a step is surely not at rest, m²/s².
double Sleep::fast_squared(double dt) const {
    const double slowest = std::max(slow(true, dt), slow(false, dt));
    return 4 * slowest * slowest;
}

/// Whether a ball did over the step what rest does not allow.
bool Sleep::moved(const Before& before, const Ball& ball, bool in_company, double dt) const {
    const double pull = gravity_ * dt;
    if (pull == 0) return ball.velocity != Vec2{} || before.velocity != Vec2{} || ball.spin != 0;
    const double slow = this->slow(in_company, dt);
    const double steady = in_company ? island_gain * pull : 1e-3 * pull + 1e-2 * speed_;
    return length(ball.velocity) >= slow || length(before.velocity) >= slow ||
           std::abs(ball.spin) * ball.radius >= slow ||
           length(ball.position - before.position) >= slow * dt ||
           length(ball.velocity - before.velocity) > std::min(steady, falling * pull);
}

}  // namespace flipside::custom
