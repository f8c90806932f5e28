#include "lab/blame/wrong_step.hpp"

#include <algorithm>
#include <cmath>

#include "lab/blame/approach.hpp"
#include "lab/blame/continuation.hpp"
#include "lab/blame/met_kind.hpp"
#include "lab/blame/missed_contact.hpp"
#include "lab/blame/wrong_impact.hpp"
#include "world/refusal.hpp"

namespace flipside::lab {

namespace {

bool same_pair(const Event& a, const Event& b) {
    return a.ball == b.ball && a.other == b.other;
}

bool is_of(BallNumber ball, const auto& pair) {
    return pair.ball == ball || pair.other == Other::ball(ball);
}

const Event* find_pair(std::span<const Event> events, const Event& like) {
    const auto at = std::ranges::find_if(events, [&](const Event& event) { return same_pair(event, like); });
    return at == events.end() ? nullptr : &*at;
}

}  // namespace

WrongStep::WrongStep(const Divergence& divergence, std::size_t step, double tolerance, World& exact)
    : in_(divergence),
      history_(divergence.history),
      step_(step),
      tolerance_(tolerance),
      match_(match_tolerance(divergence.history.dt)),
      exact_(exact),
      before_(history_.states[step - 1]),
      after_(history_.states[step]) {
    exact_.restore(before_);
    contacts_before_.assign(exact_.contacts().begin(), exact_.contacts().end());
    events_ = go_on(exact_, before_, after_.clock.time, history_);
    contacts_after_.assign(exact_.contacts().begin(), exact_.contacts().end());
    exact_after_ = exact_.save();
    exact_after_.origin.reset();
}

Blame WrongStep::blame() {
    if (const auto motion = mistimed()) return *motion;
    culprit_ = culprit();
    const Ball* const ball = find_ball(after_.balls, culprit_);
    if (ball != nullptr && !is_number(*ball)) {
        Blame stopped;
        stopped.fault = Fault::stopped;
        stopped.ball = culprit_;
        stopped.time = after_.clock.time;
        return stopped;
    }
    const Impacts exact = impacts_of_culprit(events_), own = impacts_of_culprit(history_.events[step_ - 1]);
    for (const Event& impact : exact)
        if (find_pair(own, impact) == nullptr) return lacking(impact);
    for (const Event& impact : own)
        if (find_pair(exact, impact) == nullptr) return surplus(impact);
    if (exact.empty()) return without_impact();
    return differing(*find_pair(own, exact.front()), exact.front());
}

/// The ball that ends worst, if it would although all others made this step exactly. Otherwise one that it
/// meets later on: the one that this step put furthest off.
BallNumber WrongStep::culprit() {
    const Worst loser = worst_if_exact_from(after_, history_, in_.ends, exact_);
    if (before_.balls.size() < 2) return loser.ball;
    State alone = exact_after_;
    std::erase_if(alone.balls, [&](const Ball& ball) { return ball.number == loser.ball; });
    if (const Ball* ball = find_ball(after_.balls, loser.ball))
        alone.balls.insert(std::ranges::lower_bound(alone.balls, loser.ball, {}, &Ball::number), *ball);
    if (worst_if_exact_from(alone, history_, in_.ends, exact_).radii > tolerance_) return loser.ball;
    Worst other{-1, loser.ball};
    const double left = history_.end - after_.clock.time;
    for (const Ball& ball : exact_after_.balls) {
        const Ball* own = find_ball(after_.balls, ball.number);
        const double off =
            own == nullptr
                ? INFINITY
                : (length(own->position - ball.position) + left * length(own->velocity - ball.velocity)) /
                      ball.radius;
        if (ball.number != loser.ball && off > other.radii) other = {off, ball.number};
    }
    return other.ball;
}

WrongStep::Impacts WrongStep::impacts_of_culprit(std::span<const Event> events) const {
    Impacts impacts;
    for (const Event& event : events)
        if (event.kind == EventKind::impact && is_of(culprit_, event)) impacts.push_back(event);
    return impacts;
}

/// The exact engine has an impact in this step, the contender has not.
Blame WrongStep::lacking(const Event& exact_impact) {
    const Event due = exact_before(exact_impact).value_or(exact_impact);
    if (const auto later = own_after(exact_impact)) return make(Fault::late, due, later->time - due.time);
    if (touches(history_.contacts[step_ - 1], due) && touches(history_.contacts[step_], due))
        return make(Fault::resting, due, off_the_path());
    if (own_before(exact_impact)) return make(Fault::impulse, exact_impact, exact_impact.speed);
    if (due.time > history_.end - match_ && comes_after_the_end(due))
        return make(Fault::late, due, history_.end - due.time);
    const std::size_t step = step_around(due.time);
    return make(why_missed({in_.scene, due, history_.states[step - 1], history_.states[step]}, in_.own), due,
                due.speed);
}

/// The step, up to this one, in which a time lies.
std::size_t WrongStep::step_around(double time) const {
    std::size_t step = step_;
    while (step > 1 && history_.states[step - 1].clock.time > time) --step;
    return step;
}

/// The contender has an impact in this step, the exact engine has not.
Blame WrongStep::surplus(const Event& impact) {
    if (touches(contacts_before_, impact) || touches(contacts_after_, impact))
        return make(Fault::resting, impact, off_the_path());
    const auto ahead = go_on(exact_, before_, after_.clock.time + match_, history_);
    if (const Event* later = find_pair(impacts_of_culprit(ahead), impact))
        return make(Fault::early, *later, std::abs(later->time - impact.time));
    if (!own_before(impact))
        if (const auto due = exact_before(impact)) return make(Fault::late, *due, impact.time - due->time);
    return make(Fault::invented, impact, impact.speed);
}

/// Both have it.
Blame WrongStep::differing(const Event& impact, const Event& exact_impact) const {
    const Ball* const own = find_ball(after_.balls, culprit_);
    const Ball* const exact = find_ball(exact_after_.balls, culprit_);
    if (own == nullptr || exact == nullptr) return make(Fault::unknown, exact_impact, 0);
    const WrongImpact wrong = compare_impacts(
        {impact, exact_impact, *own, *exact, approach_velocity(exact_impact, culprit_, before_, in_.scene),
         rubs(exact_impact, before_, in_.scene), misread_normal(impact, after_, in_.scene), after_.clock.time,
         history_.end});
    return make(wrong.fault, exact_impact, wrong.amount);
}

/// Neither has an impact: the ball flies, or is held by what it touched before.
Blame WrongStep::without_impact() {
    const Ball* const ball = find_ball(before_.balls, culprit_);
    const double slow = in_.scene.rest_speed + 2 * length(in_.scene.gravity) * history_.dt;
    const auto holds = [&](const Contact& contact) {
        if (!is_of(culprit_, contact) || ball == nullptr) return false;
        if (contact.other.is_ball) return true;
        const bool still = std::holds_alternative<motion::Still>(in_.scene.parts[contact.other.index].motion);
        return !still || dot(ball->velocity, contact.normal) <= slow;
    };
    for (const std::vector<Contact>& contacts : {contacts_before_, history_.contacts[step_ - 1]})
        for (const Contact& contact : contacts) {
            if (!holds(contact)) continue;
            Event at;
            at.time = after_.clock.time;
            at.ball = contact.ball;
            at.other = contact.other;
            at.point = contact.point;
            return make(Fault::resting, at, off_the_path());
        }
    Blame drift;
    drift.fault = Fault::drift;
    drift.ball = culprit_;
    drift.time = after_.clock.time;
    drift.amount = off_the_path();
    return drift;
}

Blame WrongStep::make(Fault fault, const Event& at, double amount) const {
    Blame blame;
    blame.fault = fault;
    blame.ball = culprit_;
    blame.other = at.ball == culprit_ ? at.other : Other::ball(at.ball);
    blame.time = at.time;
    blame.amount = std::abs(amount);
    const std::uint32_t part = at.other.index;
    const PartState state = at.other.is_ball ? PartState{} : exact_after_.parts[part];
    blame.kind = met_kind(in_.scene, at.other, state, at.point);
    return blame;
}

std::optional<Event> WrongStep::own_before(const Event& like) const {
    for (std::size_t k = step_ - 1; k-- > 0;)
        for (const Event& event : history_.events[k]) {
            if (history_.states[k + 1].clock.time < like.time - match_) return std::nullopt;
            if (event.kind == EventKind::impact && same_pair(event, like)) return event;
        }
    return std::nullopt;
}

std::optional<Event> WrongStep::own_after(const Event& like) const {
    for (std::size_t k = step_; k < history_.steps(); ++k)
        for (const Event& event : history_.events[k]) {
            if (event.time > like.time + match_) return std::nullopt;
            if (event.kind == EventKind::impact && same_pair(event, like)) return event;
        }
    return std::nullopt;
}

/// Whether an impact that the contender did not make until the end of the run may still be ahead of it.
bool WrongStep::comes_after_the_end(const Event& due) {
    try {
        const auto ahead = go_on(exact_, history_.states.back(), due.time + match_, history_);
        return find_pair(ahead, due) != nullptr;
    } catch (const Refusal&) {
        return false;
    }
}

std::optional<Event> WrongStep::exact_before(const Event& like) {
    const double earliest = after_.clock.time - match_ - history_.dt;
    const auto from = std::ranges::find_if(history_.states,
                                           [&](const State& state) { return state.clock.time >= earliest; });
    std::optional<Event> last;
    try {
        for (const Event& event : go_on(exact_, *from, after_.clock.time, history_))
            if (event.kind == EventKind::impact && same_pair(event, like)) last = event;
    } catch (const Refusal&) {
        return std::nullopt;
    }
    return last;
}

/// The parts that move would be enough to end the run outside of the tolerance, though every ball made this
/// step exactly. The one that is turned furthest from where it should be.
std::optional<Blame> WrongStep::mistimed() {
    constexpr double rounding = 1e-9;  // rad
    State alone = exact_after_;
    double most = rounding;
    Event at;
    at.time = after_.clock.time;
    for (PartIndex part = 0; part < alone.parts.size(); ++part) {
        const double turned = std::abs(after_.parts[part].angle - alone.parts[part].angle);
        alone.parts[part].angle = after_.parts[part].angle;
        if (turned > most) most = turned, at.other = Other::part(part);
    }
    if (most <= rounding) return std::nullopt;
    const Worst loser = worst_if_exact_from(alone, history_, in_.ends, exact_);
    if (loser.radii <= tolerance_) return std::nullopt;
    culprit_ = at.ball = loser.ball;
    if (const Ball* ball = find_ball(alone.balls, culprit_)) at.point = ball->position;
    return make(Fault::motion, at, most);
}

bool WrongStep::touches(std::span<const Contact> contacts, const Event& pair) const {
    return std::ranges::any_of(contacts, [&](const Contact& contact) {
        return contact.ball == pair.ball && contact.other == pair.other;
    });
}

/// How far the culprit is from the exact path at the end of this step, m.
double WrongStep::off_the_path() {
    const Ball* const own = find_ball(after_.balls, culprit_);
    go_on(exact_, history_.states.front(), after_.clock.time, history_);
    const Ball* const exact = find_ball(exact_.balls(), culprit_);
    return own != nullptr && exact != nullptr ? length(own->position - exact->position) : 0;
}

}  // namespace flipside::lab
