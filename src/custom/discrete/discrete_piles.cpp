// Which balls make up piles, and what they touch. The rest is the pile's own business (pile.hpp).

#include <algorithm>
#include <tuple>

#include "custom/discrete/discrete_solver.hpp"
#include "custom/sift.hpp"

namespace flipside::custom {

namespace {

/// Surfaces nearer than this, in radii, can press on each other.
constexpr double leaning = 1e-3;
/// Where the pressings of two balls stand in their list.
auto rank(BallNumber a, BallNumber b) {
    return std::pair(b, a);
}

}  // namespace

/// Whether two balls are in touch and come together no faster than at rest. What comes faster is an impact:
/// not before it overlaps, and then of the rounds. Those `left_over` by them press too.
bool DiscreteSolver::press(BallPair pair, bool left_over) const {
    const Ball &a = (*balls_)[pair.a], &b = (*balls_)[pair.b];
    const Vec2 between = a.position - b.position;
    const double reach = a.radius + b.radius, near = reach + leaning * std::min(a.radius, b.radius);
    const double square = length_squared(between);
    if (square >= near * near || (a.asleep && b.asleep)) return false;
    if (left_over && square < (1 - overlap_slop) * reach * reach) return true;
    const Vec2 normal = unit(between);
    return -dot(a.velocity - b.velocity, normal) <= rest_approach(normal);
}

/// Marks the balls that press on each other after the flight.
void DiscreteSolver::find_piles() {
    any_pile_ = false;
    each_prepared(
        near_balls_,
        [&](BallPair soon) {
            fetch_motion((*balls_)[soon.a]);
            fetch_motion((*balls_)[soon.b]);
        },
        [&](BallPair pair) {
            if (press(pair, false)) put_in_pile(pair);
        });
}

void DiscreteSolver::put_in_pile(BallPair pair) {
    rounds_[pair.a].in_pile = rounds_[pair.b].in_pile = true;
    any_pile_ = true;
}

/// After the rounds: finds who presses now, and solves the piles.
void DiscreteSolver::solve_piles() {
    pressing_.clear();
    pressed_.clear();
    for (const BallPair pair : near_balls_) {
        const bool seen = rounds_[pair.a].in_pile || rounds_[pair.b].in_pile || rounds_[pair.a].changed_in ||
                          rounds_[pair.b].changed_in;
        if (!seen || !press(pair, true)) continue;
        put_in_pile(pair);
        pressing_.push_back(pair);
    }
    if (any_pile_) {
        pile_.start(*balls_, scene_.gravity, span_.duration());
        places_.clear();
        for (const auto* places : {&engaged_, &dozing_})
            std::ranges::copy_if(*places, std::back_inserter(places_),
                                 [&](std::uint32_t place) { return rounds_[place].in_pile; });
        std::ranges::sort(places_);
        for (const std::uint32_t place : places_) {
            pile_.join(place);
            rounds_[place].pushed = true;
        }
        pile_balls_on_balls();
        pile_balls_on_parts();
        pile_.solve();
    }
    keep_pressings();
}

void DiscreteSolver::pile_balls_on_balls() {
    const std::vector<Pressing>& known = table_->pressings();
    auto next = known.begin();
    for (const BallPair pair : pressing_) {
        ++record_->statistics.narrow_tests;
        ++record_->statistics.contacts;
        const Ball &a = (*balls_)[pair.a], &b = (*balls_)[pair.b];
        const auto here = rank(a.number, b.number);
        while (next != known.end() && rank(next->a, next->b) < here) ++next;
        Pressing pressing{a.number, b.number, 0, 0};
        if (next != known.end() && rank(next->a, next->b) == here) pressing = *next;
        pressed_.push_back(pressing);
        pile_.add(pair.a, pair.b, layout_.mixed(a.material, b.material).friction,
                  {pressing.normal * span_.duration(), pressing.tangent * span_.duration()});
    }
}

void DiscreteSolver::pile_balls_on_parts() {
    for (auto first = candidates_.begin(); first != candidates_.end();) {
        const std::uint32_t place = first->ball;
        const auto last =
            std::find_if(first, candidates_.end(), [&](const Candidate& c) { return c.ball != place; });
        if (rounds_[place].in_pile && !(*balls_)[place].asleep) pile_on_parts(place, {first, last});
        first = last;
    }
}

/// The deepest touch first; what then only touches a corner is clear of it.
void DiscreteSolver::pile_on_parts(std::uint32_t place, std::span<const Candidate> near) {
    const Vec2 here = (*balls_)[place].position;
    Ball ball = (*balls_)[place];
    deep_.clear();
    for (const Candidate& candidate : near) {
        const double separation = touch_at_end(ball, candidate.piece).separation;
        if (separation <= leaning * ball.radius) deep_.push_back({separation, candidate.piece});
    }
    std::ranges::sort(deep_);
    for (const Deep& deep : deep_) {
        const bool corner = std::holds_alternative<piece::Point>(layout_.piece(deep.piece).is);
        Touch found = touch_at_end(ball, deep.piece);
        if (found.separation > (corner ? 0 : leaning * ball.radius)) continue;
        if (found.separation > -overlap_slop * ball.radius && strikes(ball, deep.piece, found)) continue;
        ++record_->statistics.contacts;
        const Vec2 pushed = ball.position - here;
        push_out(ball, found);
        found.separation -= dot(pushed, found.normal);
        pile_.add(place, found, surface_velocity(deep.piece, span_.end, found.point),
                  layout_.mixed(ball, deep.piece).friction);
    }
}

/// Notes the forces between balls for the next flight. Sleepers keep theirs until they wake.
void DiscreteSolver::keep_pressings() {
    std::vector<Pressing>& pressings = table_->pressings();
    if (pressings.empty() && pressed_.empty()) return;
    const auto before = [](const Pressing& x, const Pressing& y) { return rank(x.a, x.b) < rank(y.a, y.b); };
    for (std::size_t i = 0; i < pressed_.size(); ++i) {
        pressed_[i].normal = pile_.impulses()[i].normal / span_.duration();
        pressed_[i].tangent = pile_.impulses()[i].tangent / span_.duration();
    }
    std::erase_if(pressed_, [](const Pressing& pressing) { return pressing.normal <= 0; });
    const auto sleeps = [&](BallNumber number) {
        const auto ball = std::ranges::lower_bound(*balls_, number, {}, &Ball::number);
        return ball != balls_->end() && ball->number == number && ball->asleep;
    };
    if (any_asleep_)
        std::erase_if(pressings, [&](const Pressing& p) { return !sleeps(p.a) || !sleeps(p.b); });
    else
        pressings.clear();
    const auto kept = static_cast<std::ptrdiff_t>(pressings.size());
    pressings.insert(pressings.end(), pressed_.begin(), pressed_.end());
    if (kept > 0) std::sort(pressings.begin(), pressings.end(), before);
}

}  // namespace flipside::custom
