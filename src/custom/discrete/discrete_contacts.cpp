// The rounds of response after a flight, and what keeps heaps up.

#include <algorithm>
#include <tuple>

#include "custom/discrete/discrete_solver.hpp"
#include "custom/geometry/sweep.hpp"

namespace flipside::custom {

namespace {

/// Overlaps up to this, in radii, are rounding and left alone.
constexpr double slop = 1e-9;
/// Balls nearer than this, in radii, lean on each other.
constexpr double leaning = 1e-3;
/// Passes over the supports of one ball.
constexpr int support_passes = 8;
/// In a heap, slip slower than this times what gravity gives in one flight is rest.
constexpr double stick = 1.5;
/// The same for what is rounding.
constexpr double rest_noise = 1e-9;

}  // namespace

void DiscreteSolver::report(const Ball& ball, Other other, const Impact& hit, Vec2 point, double time) {
    ++record_->statistics.impacts;
    record_->events.push_back({table_->time() + time - hit.ago, EventKind::impact, ball.number, other, point,
                               hit.normal, hit.speed, hit.impulse});
}

/// Answers a touch of a ball with a piece `at` seconds into this motion iteration.
void DiscreteSolver::respond_to(Ball& ball, PieceIndex index, const Touch& touch, double at, double& flown) {
    const PartIndex part = layout_.piece(index).part;
    const double now = span_.begin + at;
    const Pose pose = layout_.pose(*table_, index, now);
    const Vec2 surface = cross(layout_.rate(*table_, index, now), touch.point - pose.pivot);
    const Impact hit =
        respond(ball, touch, surface, layout_.mixed(ball.material, scene_.parts[part].material),
                {scene_.gravity, scene_.rest_speed, flown, span_.duration()});
    flown = hit.ago;
    if (!hit.happened) return push_out(ball, touch);
    report(ball, Other::part(part), hit, touch.point, now);
    if (scene_.parts[part].target) {
        table_->set_down(part, true);
        for (Ball& other : *balls_) other.asleep = false;
    }
}

/// Round by round, until nothing overlaps. A ball is looked at again only when the round before or this
/// one has moved it. Where the rounds do not suffice, in heaps, support comes from below.
void DiscreteSolver::collide() {
    changed_in_.assign(balls_->size(), 0);
    for (round_ = 1; round_ <= settings_.collision_iterations; ++round_) {
        const bool parts = collide_parts();
        const bool between_balls = collide_balls();
        if (!parts && !between_balls) return;
    }
    if (scene_.gravity != Vec2{}) support_from_below();
}

bool DiscreteSolver::changed(std::uint32_t place) const {
    return changed_in_[place] + 1 >= round_;
}

bool DiscreteSolver::collide_parts() {
    bool any = false;
    for (auto first = candidates_.begin(); first != candidates_.end();) {
        const std::uint32_t place = first->ball;
        const auto last =
            std::find_if(first, candidates_.end(), [&](const Candidate& c) { return c.ball != place; });
        if (!(*balls_)[place].asleep && changed(place) && collide_ball_with_parts(place, {first, last})) {
            changed_in_[place] = round_;
            any = true;
        }
        first = last;
    }
    return any;
}

/// The deepest touch first: a ball that lies on a face is then clear of the face's ends.
bool DiscreteSolver::collide_ball_with_parts(std::uint32_t place, std::span<const Candidate> near) {
    Ball& ball = (*balls_)[place];
    const auto touch_now = [&](PieceIndex index) {
        const Piece& piece = layout_.piece(index);
        const Pose pose = layout_.pose(*table_, index, span_.end);
        Touch found;
        found.separation = never;
        if (!layout_.stops(*table_, index, pose, ball)) return found;
        ++record_->statistics.narrow_tests;
        if (!layout_.moves(index) && misses(ball.position, ball.radius, piece)) return found;
        found = touch(ball.position, ball.radius, piece, pose);
        if (found.past_end) found.separation = never;
        return found;
    };
    deep_.clear();
    for (const Candidate& candidate : near) {
        const double separation = touch_now(candidate.piece).separation;
        if (separation < -slop * ball.radius) deep_.push_back({separation, candidate.piece});
    }
    std::ranges::sort(deep_);
    for (const Deep& deep : deep_) {
        const Touch found = touch_now(deep.piece);
        if (found.separation >= 0) continue;
        ++record_->statistics.contacts;
        respond_to(ball, deep.piece, found, span_.duration(), flown_[place]);
    }
    return !deep_.empty();
}

bool DiscreteSolver::collide_balls() {
    bool any = false;
    for (const BallPair pair : ball_pairs_) {
        if (!changed(pair.a) && !changed(pair.b)) continue;
        Ball &a = (*balls_)[pair.a], &b = (*balls_)[pair.b];
        if (a.asleep && b.asleep) continue;
        ++record_->statistics.narrow_tests;
        if (round_ == 1 && !a.asleep && !b.asleep && turn_back(pair)) {
            any = true;
            continue;
        }
        const Vec2 between = a.position - b.position;
        const double reach = a.radius + b.radius;
        if (length_squared(between) >= (1 - slop) * reach * reach) continue;
        ++record_->statistics.contacts;
        any = true;
        changed_in_[pair.a] = changed_in_[pair.b] = round_;
        collide(pair, unit(between));
    }
    return any;
}

/// Answers the touch of two balls that passed through each other in this flight.
bool DiscreteSolver::turn_back(BallPair pair) {
    Ball &a = (*balls_)[pair.a], &b = (*balls_)[pair.b];
    const double ago = passed_through(a, b, std::min(flown_[pair.a], flown_[pair.b]));
    if (ago == never) return false;
    a.position -= ago * a.velocity;
    b.position -= ago * b.velocity;
    Impact hit = respond(a, b, false, layout_.mixed(a.material, b.material),
                         {scene_.gravity, scene_.rest_speed, 0, 0});
    hit.ago = ago;
    if (hit.happened) report(a, Other::ball(b.number), hit, b.position + b.radius * hit.normal, span_.end);
    a.position += ago * a.velocity;
    b.position += ago * b.velocity;
    flown_[pair.a] = flown_[pair.b] = ago;
    changed_in_[pair.a] = changed_in_[pair.b] = round_;
    ++record_->statistics.contacts;
    return true;
}

void DiscreteSolver::collide(BallPair pair, Vec2 normal) {
    Ball &a = (*balls_)[pair.a], &b = (*balls_)[pair.b];
    // A sleeper holds against what merely rests on it, and wakes when hit.
    const double approach = -dot(a.velocity - b.velocity, normal);
    const double weight = std::abs(dot(scene_.gravity, normal)) * span_.duration();
    if (approach > settings_.sleep_speed + weight) a.asleep = b.asleep = false;
    const bool held_a = a.asleep;
    Ball &free = held_a ? b : a, &other = held_a ? a : b;
    const double flown = std::min(flown_[pair.a], flown_[pair.b]);
    Impact hit = respond(free, other, other.asleep, layout_.mixed(a.material, b.material),
                         {scene_.gravity, scene_.rest_speed, flown, span_.duration()});
    flown_[pair.a] = flown_[pair.b] = hit.ago;
    if (hit.happened) {
        if (held_a) hit.normal = -hit.normal;
        report(a, Other::ball(b.number), hit, b.position + b.radius * hit.normal, span_.end);
    }
    push_out(free, other, other.asleep);
}

/// Lists what each awake ball of a heap can lean on: lower balls that it touches, and parts. By the height
/// of the upper ball.
void DiscreteSolver::find_supports() {
    supports_.clear();
    const auto height = [&](const Ball& ball) { return -dot(ball.position, scene_.gravity); };
    in_heap_.assign(stirred_.begin(), stirred_.end());
    for (const BallPair pair : ball_pairs_) {
        const Ball &a = (*balls_)[pair.a], &b = (*balls_)[pair.b];
        const double reach = a.radius + b.radius + leaning * std::min(a.radius, b.radius);
        if (length_squared(a.position - b.position) >= reach * reach) continue;
        in_heap_[pair.a] = in_heap_[pair.b] = true;
        const bool a_above = std::tuple(height(a), pair.a) > std::tuple(height(b), pair.b);
        const auto [upper, lower] = a_above ? std::pair(pair.a, pair.b) : std::pair(pair.b, pair.a);
        const Ball& leans = (*balls_)[upper];
        if (!leans.asleep) supports_.push_back({height(leans), upper, true, lower});
    }
    for (const Candidate& candidate : candidates_) {
        const Ball& ball = (*balls_)[candidate.ball];
        if (in_heap_[candidate.ball] && !ball.asleep)
            supports_.push_back({height(ball), candidate.ball, false, candidate.piece});
    }
    std::ranges::sort(supports_);
}

/// Rounds carry a push one ball further each, so they cannot bear a heap. Where they are used up, every
/// ball, from the lowest to the highest, is put on those below that are themselves borne by the table,
/// which hold as if they had infinite mass (shock propagation: Guendelman, Bridson, Fedkiw 2003, "Nonconvex
/// rigid bodies with stacking"). Only balls that the last round moved are touched, and those upon them.
void DiscreteSolver::support_from_below() {
    stirred_.resize(balls_->size());
    std::ranges::transform(changed_in_, stirred_.begin(),
                           [&](int round) { return round >= settings_.collision_iterations; });
    find_supports();
    borne_.assign(balls_->size(), false);
    for (auto first = supports_.begin(); first != supports_.end();) {
        const std::uint32_t place = first->ball;
        const auto last =
            std::find_if(first, supports_.end(), [&](const Support& s) { return s.ball != place; });
        const std::span<const Support> below(first, last);
        if (std::ranges::any_of(below, [&](const Support& s) { return s.is_ball && stirred_[s.on]; }))
            stirred_[place] = true;
        for (int pass = 0; pass < support_passes; ++pass) {
            bool moved = false;
            for (const Support& support : below) {
                Vec2 surface;
                const Touch on = touch_of(place, support, surface);
                if (on.separation > leaning * (*balls_)[place].radius) continue;
                borne_[place] = true;
                if (stirred_[place] && lean((*balls_)[place], on, surface)) moved = true;
            }
            if (!moved) break;
        }
        first = last;
    }
}

/// How a ball lies to a support, and how fast that moves there. Far away if it does not bear.
Touch DiscreteSolver::touch_of(std::uint32_t place, const Support& support, Vec2& surface) {
    const Ball& ball = (*balls_)[place];
    Touch far;
    far.separation = never;
    if (support.is_ball) {
        const Ball& lower = (*balls_)[support.on];
        if (!borne_[support.on] && !lower.asleep) return far;
        ++record_->statistics.narrow_tests;
        surface = lower.velocity;
        return touch(ball.position, ball.radius, lower.position, lower.radius);
    }
    const Piece& piece = layout_.piece(support.on);
    const Pose pose = layout_.pose(*table_, support.on, span_.end);
    if (!layout_.stops(*table_, support.on, pose, ball)) return far;
    ++record_->statistics.narrow_tests;
    const Touch on = touch(ball.position, ball.radius, piece, pose);
    surface = cross(layout_.rate(*table_, support.on, span_.end), on.point - pose.pivot);
    return on.past_end ? far : on;
}

/// Puts a ball on a support without a bounce: the rounds had those. A hop off it that gravity takes back
/// during the next flight is none, and slip that is about as slow is taken for rest: the rounds
/// leave that much behind where the true forces of a heap balance. False when nothing changed.
bool DiscreteSolver::lean(Ball& ball, const Touch& on, Vec2 surface) {
    const double gain = pull_ * span_.duration();
    const double pressing = -dot(scene_.gravity, on.normal) * span_.duration();
    const Vec2 relative = ball.velocity - surface;
    const double closing = -dot(relative, on.normal);
    const bool closes = closing > rest_noise * gain || (closing < -rest_noise * gain && closing > -pressing);
    const Vec2 slip = relative + closing * on.normal;
    const bool sticks = pressing > 0 && length(slip) < stick * gain;
    const bool overlaps = on.separation < -slop * ball.radius;
    if (!closes && !overlaps && !(sticks && length(slip) > rest_noise * gain)) return false;
    ++record_->statistics.contacts;
    if (closes) ball.velocity += closing * on.normal;
    if (sticks) ball.velocity -= slip, ball.spin = 0;
    push_out(ball, on);
    return true;
}

}  // namespace flipside::custom
