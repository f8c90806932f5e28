// What a trace says of the continuous solver. Events of all kinds take turns in order of time, so its stages
// are: the paths and predictions with which the step begins, then events, interrupted by the solves of
// islands at their ticks.

#include <algorithm>

#include "custom/continuous/continuous_solver.hpp"

namespace flipside::custom {

namespace {

constexpr std::string_view events_stage = "events";

std::string milliseconds(double seconds) {
    return brief(1e3 * seconds) + " ms";
}

}  // namespace

std::string_view ContinuousSolver::name_of_next(BallIndex i) const {
    const Mover& mover = movers_[i];
    if (mover.horizon <= mover.next_time && mover.horizon < never_touch) return "leaves its cell";
    switch (mover.next) {
        case Next::feature:
            return "meets a part";
        case Next::ball:
            return "meets a ball";
        case Next::look_again:
            return "its path ends";
        case Next::sense:
            return "enters or leaves a sensor or gate";
        case Next::leave_bounds:
            return "leaves the bounds";
        case Next::nothing:
            break;
    }
    return "nothing in this window";
}

/// Adds what a ball's next event is, and when.
void ContinuousSolver::trace_next(TraceItem& item, BallIndex i) const {
    const Mover& mover = movers_[i];
    const std::string_view name = name_of_next(i);
    const double time = std::min(mover.horizon, mover.next_time);
    item.with("next", name);
    if (time <= dt_) item.with("next_time", start_ + time);
    if (name == "meets a part")
        item.with("next_part", std::string_view(scene_.parts[features_[mover.met].part].name));
    if (name == "meets a ball") item.with("next_ball", bodies_[mover.met].number);
}

/// The path of every ball, and what it will meet.
void ContinuousSolver::trace_paths(bool all_set_out) {
    TraceStage& stage =
        record_->trace->stage(all_set_out ? "set out" : "paths and predictions so far",
                              all_set_out ? "src/custom/continuous/continuous_window.cpp: set_out_all"
                                          : "src/custom/continuous/continuous_predict.cpp: predict");
    std::size_t meets = 0, rest = 0, asleep = 0, islands = 0;
    for (BallIndex i = 0; i < movers_.size(); ++i) {
        const Mover& mover = movers_[i];
        if (mover.lost) continue;
        const Ball& ball = bodies_[i];
        TraceItem& item = stage.add("path").with("ball", ball.number);
        item.with("way", ball.asleep          ? "asleep"
                         : flying_[i].creeps  ? "on through a long tick of an island"
                         : flying_[i].pressed ? "a hop of an island, to its next tick"
                         : mover.resting_on ? mover.way.path.swings() ? "swings along a part" : "along a part"
                                            : "free flight");
        if (mover.resting_on != nullptr)
            item.with("part", std::string_view(scene_.parts[mover.resting_on->part].name));
        const Flight& flight = mover.way.path.flight;
        item.with("since", start_ + mover.way.path.start)
            .with("position", flight.position)
            .with("velocity", flight.velocity)
            .with("acceleration", flight.acceleration)
            .with("drag", flight.drag)
            .with("spin", ball.spin);
        asleep += ball.asleep;
        if (ball.asleep) continue;
        islands += flying_[i].pressed;
        rest += mover.resting_on != nullptr;
        meets += mover.next_time <= dt_ && (mover.next == Next::feature || mover.next == Next::ball);
        trace_next(item, i);
        const double now = std::max(0.0, mover.way.path.start);
        const double end = std::min({mover.horizon, mover.next_time, dt_});
        if (end > now) item.with("swept", swept(now, end, [&](double t) { return ball_at(i, t).position; }));
    }
    stage.says = (all_set_out ? "A window of " + milliseconds(dt_) + " begins and all balls set out: "
                              : "The window since " + brief(start_) + " s goes on: ") +
                 std::to_string(meets) + " of " + counted(stage.items.size(), "ball") +
                 " will meet something in it, " + std::to_string(rest) + " rest on a part, " +
                 std::to_string(islands) + " press on each other, " + std::to_string(asleep) + " sleep.";
}

/// Handles an event, and writes what it was and what followed from it.
void ContinuousSolver::trace_event(BallIndex i) {
    Trace& trace = *record_->trace;
    const Mover& mover = movers_[i];
    const std::string_view name = name_of_next(i);
    const double time = std::min(mover.horizon, mover.next_time);
    const bool meets_ball = name == "meets a ball";
    const BallIndex other = meets_ball ? mover.met : i;
    if (trace.stages.empty() || trace.stages.back().name != events_stage)
        trace.stage(events_stage, "src/custom/continuous/continuous_events.cpp: handle");
    const std::size_t stage = trace.stages.size() - 1, at = trace.stages[stage].items.size();
    trace.stages[stage]
        .add("event")
        .with("time", start_ + time)
        .with("ball", mover.number)
        .with("event", name);
    const auto velocity = [&](BallIndex k) { return ball_at(k, time).velocity; };
    const Vec2 before = velocity(i), other_before = velocity(other);
    std::vector<double> way =
        swept(mover.way.path.start, time, [&](double t) { return ball_at(i, t).position; });
    std::vector<double> other_way =
        swept(movers_[other].way.path.start, time, [&](double t) { return ball_at(other, t).position; });
    const bool stale = meets_ball && flying_[other].changes != mover.met_changes;
    const PartIndex part = name == "meets a part" ? features_[mover.met].part : 0;
    const bool meets_part = name == "meets a part";
    const std::size_t reported = pending_.size();
    handle(i);
    TraceItem& item = trace.stages[stage].items[at];
    if (meets_ball) item.with("other_ball", bodies_[other].number);
    if (meets_part) item.with("part", std::string_view(scene_.parts[part].name));
    item.with("position", ball_at(i, time).position).with("velocity_before", before);
    item.with("velocity", velocity(i));
    if (meets_ball) item.with("other_velocity_before", other_before).with("other_velocity", velocity(other));
    const bool impact = pending_.size() > reported && pending_[reported].kind == EventKind::impact;
    item.with("swept", std::move(way));
    if (meets_ball) item.with("other_swept", std::move(other_way));
    if (stale) item.with("answer", "the other has changed its path meanwhile: predicted again");
    if (impact) {
        const Event& event = pending_[reported];
        const Mixed& material = meets_ball ? layout_.mixed(bodies_[i].material, bodies_[other].material)
                                           : layout_.mixed(bodies_[i].material, scene_.parts[part].material);
        item.with("answer", "impact")
            .with("point", event.point)
            .with("normal", event.normal)
            .with("speed", event.speed)
            .with("impulse", event.impulse)
            .with("restitution", material.restitution);
    } else if (!stale && (meets_ball || meets_part)) {
        item.with("answer", movers_[i].resting_on ? "comes to rest on it"
                            : flying_[i].pressed  ? "joins an island"
                                                  : "slow touch");
    }
    trace_next(item, i);
    TraceStage& events = trace.stages[stage];
    const auto impacts = std::ranges::count_if(events.items, [](const TraceItem& one) {
        const TraceValue* answer = one.find("answer");
        return answer != nullptr && *answer == TraceValue(std::string("impact"));
    });
    events.says = counted(events.items.size(), "event") + " in order of time, " +
                  counted(static_cast<std::uint64_t>(impacts), "impact") +
                  " among them; only the balls involved are predicted again.";
}

/// After the solve of a tick.
void ContinuousSolver::trace_tick(double time, double duration) {
    TraceStage& stage =
        record_->trace->stage("island solve", "src/custom/islands/contact_solver.cpp: ContactSolver::solve");
    for (const ContactSolver::Contact& contact : contact_solver_.contacts()) {
        const bool balls = contact.with == ContactSolver::With::ball;
        TraceItem& item = stage.add("contact").with("ball", bodies_[balls ? contact.a : contact.b].number);
        if (balls)
            item.with("other_ball", bodies_[contact.b].number);
        else
            item.with("part", std::string_view(scene_.parts[layout_.primitive(contact.a).part].name));
        const ContactSolver::Body& upper = contact_solver_.bodies()[contact.upper];
        item.with("point", upper.position - upper.radius * contact.normal)
            .with("normal", contact.normal)
            .with("gap", contact.gap_found)
            .with("friction", contact.friction)
            .with("impulse", contact.impulse.normal)
            .with("tangential_impulse", contact.impulse.tangent);
    }
    const std::span<const double> residuals = contact_solver_.residuals();
    for (std::size_t k = 0; k < residuals.size(); ++k)
        stage.add("sweep").with("sweep", k + 1).with("residual", residuals[k]);
    for (BallIndex k = 0; k < members_.size(); ++k) {
        const ContactSolver::Body& body = contact_solver_.bodies()[k];
        stage.add("member")
            .with("ball", bodies_[members_[k]].number)
            .with("position", body.position)
            .with("velocity", body.velocity)
            .with("spin", body.spin);
    }
    stage.says = "Tick at " + brief(start_ + time) + " s: " + counted(members_.size(), "ball") + " and " +
                 counted(contact_solver_.contacts().size(), "contact") + " are solved together for " +
                 milliseconds(duration) + "; after " + counted(residuals.size(), "sweep") +
                 " the last changed no velocity by more than " +
                 brief(1e3 * (residuals.empty() ? 0 : residuals.back())) + " mm/s.";
}

}  // namespace flipside::custom
