// The rounds of response after a flight.

#include <algorithm>

#include "custom/discrete/discrete_solver.hpp"
#include "custom/engine.hpp"
#include "custom/geometry/sweep.hpp"
#include "custom/sift.hpp"
#include "world/limits.hpp"

namespace flipside::custom {

void DiscreteSolver::report(const Ball& ball, Other other, const Impact& hit, Vec2 point, double time) {
    ++record_->statistics.impacts;
    if (!within_top_speed(ball))
        refuse_speed(engine_name, ball, other, table_->time() + time - hit.ago, scene_);
    record_->events.push_back({table_->time() + time - hit.ago, EventKind::impact, ball.number, other, point,
                               hit.normal, hit.speed, hit.impulse});
}

/// Answers a touch of a ball with a piece `at` seconds into this motion iteration.
void DiscreteSolver::respond_to(Ball& ball, PieceIndex index, const Touch& touch, double at, double& flown) {
    const PartIndex part = layout_.piece(index).part;
    const double now = span_.begin + at;
    const Impact hit =
        respond(ball, touch, surface_velocity(index, now, touch.point), layout_.mixed(ball, index),
                {scene_.gravity, scene_.rest_speed, flown, span_.duration()});
    if (!hit.happened) return push_out(ball, touch);
    flown = hit.ago;
    report(ball, Other::part(part), hit, touch.point, now);
    if (!layout_.always_stops(index) && scene_.parts[part].target) {
        table_->set_down(part, true);
        for (Ball& other : *balls_) other.asleep = false;
        all_woken_ = true;
    }
}

/// Round by round, until nothing overlaps. A ball is looked at again only when the round before or this
/// one has moved it. Under gravity, balls that merely press on each other are left to their pile, which
/// comes last.
void DiscreteSolver::collide() {
    const bool piles = pull_ > 0;
    if (piles) find_piles();
    for (round_ = 1; round_ <= settings_.collision_iterations; ++round_) {
        const bool parts = collide_parts();
        const bool between_balls = collide_balls();
        if (!parts && !between_balls) break;
    }
    if (piles) solve_piles();
}

bool DiscreteSolver::changed(std::uint32_t place) const {
    return rounds_[place].changed_in + 1 >= round_;
}

bool DiscreteSolver::collide_parts() {
    bool any = false;
    std::uint64_t tests = 0;
    const std::span<const Candidate> touching = sift(
        candidates_, touching_room_,
        [&](const Candidate& c) {
            if (!changed(c.ball)) return false;
            ++tests;
            const Ball& ball = (*balls_)[c.ball];
            return static_cast<bool>(!ball.asleep & layout_.may_touch(c.piece, ball.position, ball.radius));
        },
        [&](const Candidate& c) {
            if (round_ > 1) return;  // few are looked at again
            fetch_motion((*balls_)[c.ball]);
            fetch(layout_.capsule(c.piece));
        });
    record_->statistics.narrow_tests += tests;
    for (auto first = touching.begin(); first != touching.end();) {
        const auto soon = first + std::min<std::ptrdiff_t>(4, touching.end() - first - 1);
        fetch(layout_.piece(soon->piece));
        fetch((*balls_)[soon->ball].material);
        fetch(so_far_[soon->ball]);
        const std::uint32_t place = first->ball;
        const auto last =
            std::find_if(first, touching.end(), [&](const Candidate& c) { return c.ball != place; });
        if (collide_ball_with_parts(place, {first, last})) {
            rounds_[place].changed_in = static_cast<std::uint8_t>(round_);
            any = true;
        }
        first = last;
    }
    return any;
}

/// How a ball lies to a piece at the end of the flight; far away if that lets it through.
Touch DiscreteSolver::touch_at_end(const Ball& ball, PieceIndex index) {
    const Pose pose = layout_.pose(*table_, index, span_.end);
    Touch found;
    found.separation = never;
    if (!layout_.stops(*table_, index, pose, ball)) return found;
    ++record_->statistics.narrow_tests;
    found = touch(ball.position, ball.radius, layout_.piece(index), pose);
    if (found.past_end) found.separation = never;
    return found;
}

/// The deepest touch first: a ball that lies on a face is then clear of the face's ends.
bool DiscreteSolver::collide_ball_with_parts(std::uint32_t place, std::span<const Candidate> near) {
    Ball& ball = (*balls_)[place];
    deep_.clear();
    for (const Candidate& candidate : near) {
        const double separation = touch_at_end(ball, candidate.piece).separation;
        if (separation < -overlap_slop * ball.radius) deep_.push_back({separation, candidate.piece});
    }
    std::ranges::sort(deep_);
    const Vec2 was = ball.position;
    bool any = false;
    for (const Deep& deep : deep_) {
        const Touch found = touch_at_end(ball, deep.piece);
        if (found.separation >= 0 || (rounds_[place].in_pile && !strikes(ball, deep.piece, found))) continue;
        ++record_->statistics.contacts;
        respond_to(ball, deep.piece, found, span_.duration(), so_far_[place].flown);
        any = true;
        if (deep_.size() > 1 || layout_.moves(deep.piece)) rounds_[place].pushed = true;
    }
    // Thrown back so far it may meet the next part.
    if (length_squared(ball.position - was) > 0.25 * ball.radius * ball.radius) rounds_[place].pushed = true;
    return any;
}

/// Whether the ball came faster than rest_speed, without what gravity added since the touch.
bool DiscreteSolver::strikes(const Ball& ball, PieceIndex index, const Touch& touch) const {
    const Vec2 surface = surface_velocity(index, span_.end, touch.point);
    const double closing = -dot(ball.velocity - surface, touch.normal);
    const double fallen = 2 * dot(scene_.gravity, touch.normal) * touch.separation;
    return closing > 0 && closing * closing - fallen > scene_.rest_speed * scene_.rest_speed;
}

/// Balls that come together no faster than this press on each other: gravity drives them that fast in a
/// flight.
double DiscreteSolver::rest_approach(Vec2 normal) const {
    return scene_.rest_speed + std::abs(dot(scene_.gravity, normal)) * span_.duration();
}

/// Of the surface of a piece at a point, `ahead` seconds into the step.
Vec2 DiscreteSolver::surface_velocity(PieceIndex index, double ahead, Vec2 point) const {
    return cross(layout_.rate(*table_, index, ahead), point - layout_.pose(*table_, index, ahead).pivot);
}

bool DiscreteSolver::collide_balls() {
    bool any = false;
    each_prepared(
        near_balls_, [&](BallPair soon) { prepare(soon); },
        [&](BallPair pair) {
            if (!changed(pair.a) && !changed(pair.b)) return;
            if (!collide(pair)) return;
            any = true;
            rounds_[pair.a].changed_in = rounds_[pair.b].changed_in = static_cast<std::uint8_t>(round_);
            rounds_[pair.a].pushed = rounds_[pair.b].pushed = true;
        });
    return any;
}

/// Answers two balls that touch or passed through each other in this flight; whether they did.
bool DiscreteSolver::collide(BallPair pair) {
    const Ball &a = (*balls_)[pair.a], &b = (*balls_)[pair.b];
    if (a.asleep && b.asleep) return false;
    ++record_->statistics.narrow_tests;
    if (round_ == 1 && !a.asleep && !b.asleep && turn_back(pair)) return true;
    const Vec2 between = a.position - b.position;
    const double reach = a.radius + b.radius;
    if (length_squared(between) >= (1 - overlap_slop) * reach * reach) return false;
    ++record_->statistics.contacts;
    return collide(pair, unit(between));
}

/// Answers the touch of two balls that passed through each other in this flight.
bool DiscreteSolver::turn_back(BallPair pair) {
    Ball &a = (*balls_)[pair.a], &b = (*balls_)[pair.b];
    const double ago = passed_through(a, b, std::min(so_far_[pair.a].flown, so_far_[pair.b].flown));
    if (ago == never) return false;
    a.position -= ago * a.velocity;
    b.position -= ago * b.velocity;
    Impact hit = respond(a, b, false, layout_.mixed(a.material, b.material),
                         {scene_.gravity, scene_.rest_speed, 0, 0});
    hit.ago = ago;
    if (hit.happened) {
        report(a, Other::ball(b.number), hit, b.position + b.radius * hit.normal, span_.end);
        if (!within_top_speed(b))
            refuse_speed(engine_name, b, Other::ball(a.number), table_->time() + span_.end, scene_);
    }
    a.position += ago * a.velocity;
    b.position += ago * b.velocity;
    so_far_[pair.a].flown = so_far_[pair.b].flown = ago;
    ++record_->statistics.contacts;
    return true;
}

/// Answers the touch of two balls. False when it is left to a pile.
bool DiscreteSolver::collide(BallPair pair, Vec2 normal) {
    Ball &a = (*balls_)[pair.a], &b = (*balls_)[pair.b];
    // A sleeper holds against what merely rests on it, and wakes when hit.
    const double approach = -dot(a.velocity - b.velocity, normal);
    const double rest = rest_approach(normal);
    if (approach > settings_.sleep_speed + rest - scene_.rest_speed) a.asleep = b.asleep = false;
    if (pull_ > 0 && approach <= rest) {
        put_in_pile(pair);
        return false;
    }
    const bool held_a = a.asleep;
    Ball &free = held_a ? b : a, &other = held_a ? a : b;
    const double flown = std::min(so_far_[pair.a].flown, so_far_[pair.b].flown);
    Impact hit = respond(free, other, other.asleep, layout_.mixed(a.material, b.material),
                         {scene_.gravity, scene_.rest_speed, flown, span_.duration()});
    so_far_[pair.a].flown = so_far_[pair.b].flown = hit.ago;
    if (hit.happened) {
        if (held_a) hit.normal = -hit.normal;
        report(a, Other::ball(b.number), hit, b.position + b.radius * hit.normal, span_.end);
        if (!within_top_speed(b))
            refuse_speed(engine_name, b, Other::ball(a.number), table_->time() + span_.end, scene_);
    }
    if (!rounds_[pair.a].in_pile && !rounds_[pair.b].in_pile) push_out(free, other, other.asleep);
    return true;
}

/// Balls push each other, and are thrown back, without regard for what lies behind. A ball whose centre got
/// through a still part by that is put back to where it crossed, on the side where its flight began, and
/// stops closing in.
void DiscreteSolver::keep_sides() {
    for (const auto* places : {&engaged_, &dozing_})
        for (const std::uint32_t place : *places)
            if (rounds_[place].pushed) keep_side(place);
}

void DiscreteSolver::keep_side(std::uint32_t place) {
    Ball& ball = (*balls_)[place];
    const Vec2 from = so_far_[place].start;
    const std::size_t first = count_before(candidates_, [&](const Candidate& c) { return c.ball < place; });
    std::size_t last = first;
    while (last < candidates_.size() && candidates_[last].ball == place) ++last;
    std::span<const Candidate> near = candidates_.subspan(first, last - first);
    // Candidates are all that the box of the flight overlaps.
    if (!Box(so_far_[place].box).contains(ball.position))
        near = look_around(ball, length(ball.position - from));
    constexpr int most_crossed = 4;
    for (int crossed = 0; crossed < most_crossed; ++crossed) {
        double time = never;
        const Candidate* const met = first_crossed(ball, from, near, time);
        if (met == nullptr) return;
        ball.position = from + time * (ball.position - from);
        const Touch found = touch(ball.position, ball.radius, layout_.piece(met->piece));
        push_out(ball, found);
        ball.velocity += std::max(0.0, -dot(ball.velocity, found.normal)) * found.normal;
    }
    ball.position = from;
}

/// The first still part that the centre crosses on the straight way from `from`, and when, 0 … 1; null if
/// none.
const DiscreteSolver::Candidate* DiscreteSolver::first_crossed(const Ball& ball, Vec2 from,
                                                               std::span<const Candidate> near,
                                                               double& time) const {
    const Vec2 way = ball.position - from;
    const double far = (1 + 1e-9) * length(way);
    const Candidate* met = nullptr;
    for (const Candidate& candidate : near) {
        if (!layout_.may_touch(candidate.piece, from + 0.5 * way, 0.5 * far)) continue;
        const Piece& piece = layout_.piece(candidate.piece);
        if (layout_.moves(candidate.piece) || std::holds_alternative<piece::Point>(piece.is)) continue;
        Ball at_start = ball;
        at_start.position = from;
        if (!layout_.stops(*table_, candidate.piece, {}, at_start)) continue;
        const auto distance = [&](double t) { return touch(from + t * way, 0, piece).separation; };
        const double crosses = first_touch(distance, far, 1, overlap_slop * ball.radius);
        if (crosses > 0 && crosses < time) time = crosses, met = &candidate;
    }
    return met;
}

}  // namespace flipside::custom
