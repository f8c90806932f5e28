// Writes the trace of the continuous solver. Its stages are the paths and predictions at the start of the
// step, then the events in order of time, interrupted by the island solves at the ticks.

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
    if (mover.cell_exit <= mover.next_time && mover.cell_exit < never_touch) return "leaves its cell";
    switch (mover.next) {
        case EventType::feature:
            return "meets a part";
        case EventType::ball:
            return "meets a ball";
        case EventType::path_end:
            return "its path ends";
        case EventType::sensor:
            return "enters or leaves a sensor or gate";
        case EventType::leave_bounds:
            return "leaves the bounds";
        case EventType::none:
            break;
    }
    return "nothing in this window";
}

/// Adds the kind and time of a ball's next event.
void ContinuousSolver::trace_next(TraceItem& item, BallIndex i) const {
    const Mover& mover = movers_[i];
    const std::string_view name = name_of_next(i);
    const double time = std::min(mover.cell_exit, mover.next_time);
    item.with("next", name);
    if (time <= end_) item.with("next_time", start_ + time);
    if (name == "meets a part") item.with("next_part", scene_.parts[features_[mover.partner].part].name);
    if (name == "meets a ball") item.with("next_ball", bodies_[mover.partner].number);
}

/// Writes the path of every ball and its next event.
void ContinuousSolver::trace_paths(bool all_start) {
    TraceStage& stage =
        record_->trace->stage(all_start ? "start of the window" : "paths and predictions so far",
                              all_start ? "src/custom/continuous/continuous_solver.cpp: start_all_paths"
                                        : "src/custom/continuous/next_events.cpp: predict");
    std::size_t meets = 0, rest = 0, asleep = 0, islands = 0;
    for (BallIndex i = 0; i < movers_.size(); ++i) {
        const Mover& mover = movers_[i];
        if (hot_[i].lost) continue;
        const Ball& ball = bodies_[i];
        TraceItem& item = stage.add("path").with("ball", ball.number);
        item.with("way", ball.asleep         ? "asleep"
                         : hot_[i].creeps    ? "uniform through a long tick of an island"
                         : hot_[i].in_island ? "a parabola of an island, to its next tick"
                         : mover.resting_on  ? mover.motion.path.is_taylor()
                                                   ? "in resting contact, curved or turning"
                                                   : "in resting contact"
                                             : "free flight");
        if (mover.resting_on != nullptr) item.with("part", scene_.parts[mover.resting_on->part].name);
        const Flight& flight = mover.motion.path.flight;
        item.with("since", start_ + mover.motion.path.start)
            .with("position", flight.position)
            .with("velocity", flight.velocity)
            .with("acceleration", flight.acceleration)
            .with("drag", flight.drag)
            .with("spin", ball.spin);
        asleep += ball.asleep;
        if (ball.asleep) continue;
        islands += hot_[i].in_island;
        rest += mover.resting_on != nullptr;
        meets +=
            mover.next_time <= end_ && (mover.next == EventType::feature || mover.next == EventType::ball);
        trace_next(item, i);
        const double now = std::max(0.0, mover.motion.path.start);
        const double end = std::min({mover.cell_exit, mover.next_time, end_});
        if (end > now) item.with("swept", swept(now, end, [&](double t) { return ball_at(i, t).position; }));
    }
    stage.says = (all_start ? "A window of " + milliseconds(end_) + " begins and all balls start a new path: "
                            : "The window since " + brief(start_) + " s goes on: ") +
                 std::to_string(meets) + " of " + counted(stage.items.size(), "ball") +
                 " will have an impact in it, " + std::to_string(rest) + " rest on a part, " +
                 std::to_string(islands) + " are in islands, " + std::to_string(asleep) + " sleep.";
}

/// Handles an event, and writes it with its result.
void ContinuousSolver::trace_event(BallIndex i) {
    Trace& trace = *record_->trace;
    const Mover& mover = movers_[i];
    const std::string_view name = name_of_next(i);
    const double time = std::min(mover.cell_exit, mover.next_time);
    const bool meets_ball = name == "meets a ball";
    const BallIndex other = meets_ball ? mover.partner : i;
    if (trace.stages.empty() || trace.stages.back().name != events_stage)
        trace.stage(events_stage, "src/custom/continuous/events.cpp: handle");
    const std::size_t stage = trace.stages.size() - 1, at = trace.stages[stage].items.size();
    trace.stages[stage]
        .add("event")
        .with("time", start_ + time)
        .with("ball", mover.number)
        .with("event", name);
    const auto velocity = [&](BallIndex k) { return ball_at(k, time).velocity; };
    const Vec2 before = velocity(i), other_before = velocity(other);
    std::vector<double> way =
        swept(mover.motion.path.start, time, [&](double t) { return ball_at(i, t).position; });
    std::vector<double> other_way =
        swept(movers_[other].motion.path.start, time, [&](double t) { return ball_at(other, t).position; });
    const bool stale = meets_ball && hot_[other].version != mover.partner_version;
    const PartIndex part = name == "meets a part" ? features_[mover.partner].part : 0;
    const bool meets_part = name == "meets a part";
    const std::size_t reported = pending_.size();
    handle(i);
    TraceItem& item = trace.stages[stage].items[at];
    if (meets_ball) item.with("other_ball", bodies_[other].number);
    if (meets_part) item.with("part", scene_.parts[part].name);
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
                            : hot_[i].in_island   ? "joins an island"
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

/// Writes the contacts, sweeps and members of the last island solve.
void ContinuousSolver::trace_tick(double time, double duration) {
    TraceStage& stage =
        record_->trace->stage("island solve", "src/custom/islands/contact_solver.cpp: ContactSolver::solve");
    for (const ContactSolver::Contact& contact : contact_solver_.contacts()) {
        const bool balls = contact.with == ContactSolver::With::ball;
        TraceItem& item = stage.add("contact").with("ball", bodies_[balls ? contact.a : contact.b].number);
        if (balls)
            item.with("other_ball", bodies_[contact.b].number);
        else
            item.with("part", scene_.parts[layout_.primitive(contact.a).part].name);
        const ContactSolver::Body& upper = contact_solver_.bodies()[contact.upper];
        item.with("point", upper.position - upper.radius * contact.normal)
            .with("normal", contact.normal)
            .with("gap", contact.detected_gap)
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
