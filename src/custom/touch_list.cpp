#include "custom/touch_list.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "custom/broad_phase/capacity.hpp"

namespace flipside::custom {

namespace {

/// A contact whose normal has a larger downward component, as a sine, presses a ball from above and does not
/// support it.
constexpr double most_from_above = 0.1;
/// A contact holds a ball up if its force can have a larger upward component, as a share of its normal force.
constexpr double least_lift = 1e-9;

auto key(const Contact& contact) {
    return std::tie(contact.ball, contact.other);
}
const Sensed& key(const Sensed& sensed) {
    return sensed;
}

bool sleeps(std::span<const Ball> balls, BallNumber number) {
    const Ball* ball = find_ball(balls, number);
    return ball != nullptr && ball->asleep;
}

/// Visits the elements of `these` that are not in `those`; both are sorted by key.
void each_missing(const auto& these, const auto& those, auto&& visit) {
    auto other = those.begin();
    for (const auto& item : these) {
        while (other != those.end() && key(*other) < key(item)) ++other;
        if (other == those.end() || key(item) < key(*other)) visit(item);
    }
}

}  // namespace

void TouchList::reserve(std::size_t balls) {
    reserve_for(moving_, layout_.size() + balls);
    for (auto* list : {&before_, &now_}) reserve_for(*list, balls, touches_per_ball);
    reserve_for(pairs_, balls, pairs_per_ball);
    reserve_for(woken_, balls);
    for (auto* list : {&sensed_before_, &sensed_}) reserve_for(*list, balls, touches_per_ball);
}

void TouchList::keep_sleeping(std::span<const Ball> balls) {
    for (const Contact& contact : before_)
        if (sleeps(balls, contact.ball) && (!contact.other.is_ball || sleeps(balls, contact.other.index)))
            now_.push_back(contact);
    for (const Sensed& s : sensed_before_)
        if (sleeps(balls, s.ball)) sensed_.push_back(s);
}

void TouchList::test(const Ball& ball, PrimitiveIndex index) {
    const Primitive& primitive = layout_.primitive(index);
    const Pose pose = table_.pose(primitive.part);
    const bool sensor = table_.scene().parts[primitive.part].sensor;
    if (!sensor && !layout_.should_collide(table_, index, pose, ball)) return;
    const Touch found = touch(ball.position, ball.radius, primitive, pose);
    if (found.past_end) return;
    if (sensor && found.separation <= 0) sensed_.push_back({ball.number, primitive.part});
    if (!sensor && found.separation <= distance_ * ball.radius)
        now_.push_back(
            {ball.number, Other::part(primitive.part), found.point, found.normal, found.separation});
}

void TouchList::test(const Ball& lower, const Ball& ball) {
    const Touch found = touch(lower.position, lower.radius, ball.position, ball.radius);
    if (found.separation <= distance_ * std::min(lower.radius, ball.radius))
        now_.push_back({lower.number, Other::ball(ball.number), found.point, found.normal, found.separation});
}

void TouchList::begin() {
    std::swap(before_, now_);
    std::swap(sensed_before_, sensed_);
    now_.clear();
    sensed_.clear();
}

void TouchList::search(std::span<const Ball> balls) {
    begin();
    layout_.fill_proxies(table_, balls, 0, distance_, moving_);
    broad_.find_pairs(moving_, pairs_);
    test_pairs(balls);
}

void TouchList::refresh(std::span<const Ball> balls, std::span<const Pair> pairs) {
    begin();
    keep_sleeping(balls);
    pairs_.assign(pairs.begin(), pairs.end());
    test_pairs(balls);
}

void TouchList::test_pairs(std::span<const Ball> balls) {
    if (pairs_.empty()) return;  // the kept contacts are sorted
    const Handle first_ball = layout_.size();
    for (const Pair pair : pairs_) {
        const Ball& ball = balls[pair.b - first_ball];
        if (pair.a < first_ball)
            test(ball, pair.a);
        else
            test(balls[pair.a - first_ball], ball);
    }
    keep_deepest(now_);
    sort_unique(sensed_);
    // The lists are swapped in the next search, so both get the same capacity now.
    before_.reserve(now_.capacity());
    sensed_before_.reserve(sensed_.capacity());
}

void TouchList::report_touches(std::vector<Event>& events) const {
    const auto report = [&](EventKind kind, const auto& these, const auto& those) {
        each_missing(these, those, [&](const Contact& c) {
            events.push_back({table_.time(), kind, c.ball, c.other, c.point, c.normal, 0, 0});
        });
    };
    report(EventKind::begin, now_, before_);
    report(EventKind::end, before_, now_);
}

void TouchList::report_sensors(std::vector<Sensed>& crossed, std::vector<Event>& events) const {
    // A sensor crossed within the step has a begin event, and an end event unless the ball is still inside.
    const auto report = [&](EventKind kind, const auto& these, const auto& those) {
        each_missing(these, those, [&](const Sensed& s) {
            events.push_back({table_.time(), kind, s.ball, Other::part(s.part), {}, {}, 0, 0});
        });
    };
    const auto add = [&](const std::vector<Sensed>& list) {
        crossed.insert(crossed.end(), list.begin(), list.end());
        sort_unique(crossed);
    };
    add(sensed_);
    report(EventKind::sensor_begin, crossed, sensed_before_);
    add(sensed_before_);
    report(EventKind::sensor_end, crossed, sensed_);
}

void TouchList::leave_sensors(BallNumber ball) {
    std::erase_if(sensed_, [&](const Sensed& sensed) { return sensed.ball == ball; });
}

bool TouchList::wake_unsupported(std::span<Ball> balls) {
    const Vec2 gravity = table_.scene().gravity;
    woken_.assign(balls.size(), 0);
    bool any = false;
    const auto wake = [&](BallNumber number) {
        if (!sleeps(balls, number)) return;
        const std::size_t i = index_of(balls, number);
        balls[i].asleep = false;
        woken_[i] = any = true;
    };
    const auto is_woken = [&](BallNumber number) { return woken_[index_of(balls, number)] != 0; };
    const double most = most_from_above * length(gravity);
    each_missing(before_, now_, [&](const Contact& ended) {
        const double along = dot(ended.normal, gravity);
        if (along < most) wake(ended.ball);
        if (-along < most && ended.other.is_ball) wake(ended.other.index);
    });
    const bool woke = any;
    while (std::exchange(any, false))
        for (const Contact& contact : now_) {
            if (!contact.other.is_ball) continue;
            if (is_woken(contact.ball)) wake(contact.other.index);
            if (is_woken(contact.other.index)) wake(contact.ball);
        }
    return woke;
}

void TouchList::wake_unheld(std::span<Ball> balls) const {
    const Vec2 gravity = table_.scene().gravity;
    std::vector<char> held(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) held[i] = !balls[i].asleep;
    const auto is_held = [&](const Ball& ball) -> char& {
        return held[static_cast<std::size_t>(&ball - balls.data())];
    };
    const double least = least_lift * length(gravity);
    char fixed = 1;  // a part holds
    for (bool any = true; std::exchange(any, false);)
        for (const Contact& contact : now_) {
            const Ball& first = *find_ball(balls, contact.ball);
            const Ball* second = contact.other.is_ball ? find_ball(balls, contact.other.index) : nullptr;
            const Mixed& mixed = second ? layout_.mixed(first, *second)
                                        : layout_.mixed(first, table_.scene().parts[contact.other.index]);
            const double up = -dot(contact.normal, gravity);
            const double by_friction = mixed.friction * std::abs(cross(contact.normal, gravity));
            char &ball = is_held(first), &other = second ? is_held(*second) : fixed;
            if (up + by_friction > least && other && !ball) ball = any = true;
            if (-up + by_friction > least && ball && !other) other = any = true;
        }
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (!held[i]) balls[i].asleep = false;
}

}  // namespace flipside::custom
