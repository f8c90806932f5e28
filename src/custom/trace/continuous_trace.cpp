#include "custom/trace/continuous_trace.hpp"

#include <algorithm>
#include <optional>

#include "custom/geometry/narrow_phase.hpp"

namespace flipside::custom {

namespace {

/// Of each EventType.
constexpr std::string_view event_names[] = {"nothing in this window",
                                            "meets a part",
                                            "meets a ball",
                                            "its path ends",
                                            "enters or leaves a sensor or gate",
                                            "leaves the bounds"};

struct NextEvent {
    std::string_view name;
    double time = 0;           ///< s, in the window
    std::optional<Other> met;  ///< part or ball
};

NextEvent next_of(const Simulation& sim, BallIndex i) {
    const Particle& particle = sim.particles[i];
    if (particle.cell_exit <= particle.next_time && particle.cell_exit < never_touch)
        return {"leaves its cell", particle.cell_exit, {}};
    NextEvent next{event_names[static_cast<std::size_t>(particle.next)], particle.next_time, {}};
    if (particle.next == EventType::feature) next.met = Other::part(sim.features[particle.partner].part);
    if (particle.next == EventType::ball) next.met = Other::ball(sim.balls[particle.partner].number);
    return next;
}

/// Adds the kind and time of a ball's next event.
void trace_next(const Simulation& sim, TraceItem& item, BallIndex i) {
    const NextEvent next = next_of(sim, i);
    item.with("next", next.name);
    if (next.time <= sim.end) item.with("next_time", sim.start + next.time);
    if (!next.met) return;
    if (next.met->is_ball)
        item.with("next_ball", next.met->index);
    else
        item.with("next_part", sim.scene.parts[next.met->index].name);
}

/// Adds the gap between a ball and what it will meet, now, with the line that measures it. A part is posed
/// relative to the table's clock.
void trace_gap(const Simulation& sim, TraceItem& item, BallIndex i) {
    const Particle& particle = sim.particles[i];
    const NextEvent next = next_of(sim, i);
    const double now = std::max(sim.table.time() - sim.start, particle.motion.path.start);
    if (!next.met || next.time > sim.end || next.time < now) return;
    const Ball ball = sim.ball_at(i, now);
    Touch found;
    if (next.met->is_ball) {
        const Ball other = sim.ball_at(particle.partner, now);
        found = touch(ball.position, ball.radius, other.position, other.radius);
    } else {
        const Primitive& primitive = sim.layout.primitive(sim.features[particle.partner].primitive);
        const Pose pose = sim.table.pose(primitive.part, now + sim.start - sim.table.time());
        found = touch(ball.position, ball.radius, primitive, pose);
    }
    const Vec2 rim = found.point + found.separation * found.normal;
    item.with("gap", found.separation)
        .with("gap_line", std::vector<double>{rim.x, rim.y, found.point.x, found.point.y});
}

}  // namespace

void trace_paths(const Simulation& sim, bool all_start) {
    TraceStage& stage =
        sim.record->trace->stage(all_start ? "start of the window" : "paths and predictions so far",
                                 all_start ? "src/custom/continuous/continuous_solver.cpp: start_all_paths"
                                           : "src/custom/continuous/next_events.cpp: predict");
    std::size_t meets = 0, rest = 0, asleep = 0, islands = 0;
    for (BallIndex i = 0; i < sim.particles.size(); ++i) {
        const Particle& particle = sim.particles[i];
        const Path& path = particle.motion.path;
        if (sim.hot[i].lost) continue;
        const Ball& ball = sim.balls[i];
        TraceItem& item = stage.add("path").with("ball", ball.number);
        item.with("way", ball.asleep            ? "asleep"
                         : sim.hot[i].creeps    ? "uniform through a long tick of an island"
                         : sim.hot[i].in_island ? "a parabola of an island, to its next tick"
                         : path.is_taylor()     ? "in resting contact, curved or turning"
                         : particle.resting_on  ? "in resting contact"
                                                : "free flight");
        if (particle.resting_on != nullptr)
            item.with("part", sim.scene.parts[particle.resting_on->part].name);
        item.with("since", sim.start + path.start)
            .with("position", path.flight.position)
            .with("velocity", path.flight.velocity)
            .with("acceleration", path.flight.acceleration)
            .with("drag", path.flight.drag)
            .with("spin", ball.spin);
        asleep += ball.asleep;
        if (ball.asleep) continue;
        islands += sim.hot[i].in_island;
        rest += particle.resting_on != nullptr;
        meets += particle.next_time <= sim.end &&
                 (particle.next == EventType::feature || particle.next == EventType::ball);
        trace_next(sim, item, i);
        trace_gap(sim, item, i);
        const double now = std::max(0.0, path.start);
        const double end = std::min(next_of(sim, i).time, sim.end);
        if (end > now)
            item.with("swept", swept(now, end, [&](double t) { return sim.ball_at(i, t).position; }));
    }
    stage.says =
        (all_start ? "A window of " + milliseconds(sim.end) + " begins and all balls start a new path: "
                   : "The window since " + brief(sim.start) + " s goes on: ") +
        std::to_string(meets) + " of " + counted(stage.items.size(), "ball") +
        " will have an impact in it, " + std::to_string(rest) + " rest on a part, " +
        std::to_string(islands) + " are in islands, " + std::to_string(asleep) + " sleep.";
}

void trace_event(const Simulation& sim, BallIndex i, const std::function<void()>& handle) {
    const NextEvent event = next_of(sim, i);
    const bool meets_ball = event.met && event.met->is_ball;
    const BallIndex other = meets_ball ? sim.particles[i].partner : i;
    const auto velocity = [&](BallIndex k) { return sim.ball_at(k, event.time).velocity; };
    const auto way_here = [&](BallIndex k) {
        return swept(sim.particles[k].motion.path.start, event.time,
                     [&](double t) { return sim.ball_at(k, t).position; });
    };
    TraceItem item{"event", {}};
    item.with("time", sim.start + event.time).with("ball", sim.balls[i].number).with("event", event.name);
    if (event.met) item.with_other(*event.met, sim.scene);
    item.with("velocity_before", velocity(i)).with("swept", way_here(i));
    if (meets_ball) item.with("other_velocity_before", velocity(other)).with("other_swept", way_here(other));
    const bool stale = meets_ball && sim.hot[other].version != sim.particles[i].partner_version;
    const std::vector<Event>& recorded = sim.record->events;
    const std::size_t before_it = recorded.size();
    handle();
    item.with("position", sim.ball_at(i, event.time).position).with("velocity", velocity(i));
    if (meets_ball) item.with("other_velocity", velocity(other));
    if (stale) item.with("answer", "the other has changed its path meanwhile: predicted again");
    if (recorded.size() > before_it && recorded[before_it].kind == EventKind::impact) {
        const Mixed& material = meets_ball
                                    ? sim.layout.mixed(sim.balls[i], sim.balls[other])
                                    : sim.layout.mixed(sim.balls[i], sim.scene.parts[event.met->index]);
        item.with("answer", "impact")
            .with_impact(recorded[before_it])
            .with("restitution", material.restitution);
    } else if (!stale && event.met) {
        const bool passes = !meets_ball && sim.table.parts()[event.met->index].open;
        item.with("answer", passes                        ? "the gate lets it through"
                            : sim.particles[i].resting_on ? "comes to rest on it"
                            : sim.hot[i].in_island        ? "joins an island"
                                                          : "slow touch");
    }
    trace_next(sim, item, i);
    TraceStage& stage = sim.record->trace->same_stage("events", "src/custom/continuous/events.cpp: handle");
    stage.items.push_back(std::move(item));
    const auto impacts = std::ranges::count_if(
        stage.items, [](const TraceItem& one) { return one.find("impulse") != nullptr; });
    stage.says = counted(stage.items.size(), "event") + " in order of time, " +
                 counted(static_cast<std::uint64_t>(impacts), "impact") +
                 " among them; only the balls involved are predicted again.";
}

void trace_tick(const Simulation& sim, const ContactSolver& solver, std::span<const BallIndex> members,
                double time, double duration) {
    TraceStage& stage = sim.record->trace->stage(
        "island solve", "src/custom/islands/contact_solver.cpp: ContactSolver::solve");
    for (const ContactSolver::Contact& contact : solver.contacts()) {
        const bool balls = contact.with == ContactSolver::With::ball;
        const Other other = balls ? Other::ball(sim.balls[contact.b].number)
                                  : Other::part(sim.layout.primitive(contact.a).part);
        const ContactSolver::Body& upper = solver.bodies()[contact.upper];
        stage.add("contact")
            .with("ball", sim.balls[balls ? contact.a : contact.b].number)
            .with_other(other, sim.scene)
            .with("point", upper.position - upper.radius * contact.normal)
            .with("normal", contact.normal)
            .with("gap", contact.detected_gap)
            .with("friction", contact.friction)
            .with("impulse", contact.impulse.normal)
            .with("tangential_impulse", contact.impulse.tangent);
    }
    const std::span<const double> residuals = solver.residuals();
    for (std::size_t k = 0; k < residuals.size(); ++k)
        stage.add("sweep").with("sweep", k + 1).with("residual", residuals[k]);
    for (BallIndex k = 0; k < members.size(); ++k) {
        const ContactSolver::Body& body = solver.bodies()[k];
        stage.add("member")
            .with("ball", sim.balls[members[k]].number)
            .with("position", body.position)
            .with("velocity", body.velocity)
            .with("spin", body.rim_speed / body.radius);
    }
    stage.says = "Tick at " + brief(sim.start + time) + " s: " + counted(members.size(), "ball") + " and " +
                 counted(solver.contacts().size(), "contact") + " are solved together for " +
                 milliseconds(duration) + "; after " + counted(residuals.size(), "sweep") +
                 " the last changed no velocity by more than " +
                 brief(1e3 * (residuals.empty() ? 0 : residuals.back())) + " mm/s.";
}

}  // namespace flipside::custom
