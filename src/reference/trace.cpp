// Writes the trace of the exact engine: the paths at the start of the step, and the events in order of time,
// each with an interval that isolates it.

#include <algorithm>

#include "reference/simulation.hpp"

namespace flipside::reference {

namespace {

/// For a picture.
template <class R>
std::vector<double> way_of(const Path<R>& path, const R& from, const R& to) {
    return swept(0, 1, [&](double share) { return narrow(path.at(from + R(share) * (to - from)).position); });
}

}  // namespace

template <class R>
std::string_view Simulation<R>::name_of_next(const Particle& particle) {
    switch (particle.next) {
        case Next::feature:
            return "hits a part";
        case Next::ball:
            return "hits a ball";
        case Next::cell:
            return "leaves its cell";
        case Next::predict_again:
            return particle.next_index != 0 ? "reaches the horizon of its prediction" : "its path ends";
        case Next::sensor:
            return "enters or leaves a sensor or gate";
        case Next::lost:
            return "leaves the bounds";
        case Next::nothing:
            break;
    }
    return "nothing";
}

template <class R>
void Simulation<R>::trace_next(TraceItem& item, const Particle& particle) const {
    item.with("next", name_of_next(particle));
    if (particle.next_time < infinity<R>()) item.with("next_time", clock(particle.next_time));
    if (particle.next == Next::feature)
        item.with("next_part", scene_->parts[features_[particle.next_index].part].name);
    if (particle.next == Next::ball) item.with("next_ball", particles_[particle.next_index].ball.number);
}

/// Writes the path of every ball at the start of the step.
template <class R>
void Simulation<R>::trace_paths() {
    TraceStage& stage = trace_->stage("paths and predictions", "src/reference/predict.cpp: predict");
    std::size_t held = 0;
    for (const Particle& particle : particles_) {
        if (particle.gone) continue;
        const Path<R>& path = particle.path;
        TraceItem& item = stage.add("path").with("ball", particle.ball.number);
        item.with("way", path.rests                       ? "at rest"
                         : path.is_series                 ? "along a part that turns or is curved"
                         : particle.support[0] != nothing ? "along a part"
                                                          : "free flight");
        if (particle.support[0] != nothing)
            item.with("part", scene_->parts[features_[particle.support[0]].part].name);
        item.with("since", clock(path.start))
            .with("position", narrow(path.position))
            .with("velocity", narrow(path.velocity))
            .with("acceleration", narrow(path.acceleration))
            .with("drag", static_cast<double>(path.drag));
        trace_next(item, particle);
        const R end = std::min(particle.next_time, run_end_);
        if (end > now_) item.with("swept", way_of(path, now_, end));
        held += particle.support[0] != nothing;
    }
    stage.says = counted(stage.items.size(), "ball") + ", " + std::to_string(held) +
                 " in resting contact with a part; each has a path and one next event.";
}

/// Handles an event, and writes it with its result.
template <class R>
void Simulation<R>::trace_event(BallIndex i) {
    TraceStage& stage = trace_->same_stage("events", "src/reference/events.cpp: handle");
    const Particle particle = particles_[i];
    const bool hits_part = particle.next == Next::feature, hits_ball = particle.next == Next::ball;
    TraceItem& item = stage.add("event").with("time", clock(now_)).with("ball", particle.ball.number);
    item.with("event", name_of_next(particle));
    const R half = isolated_within(particle, epsilon<R>(), R(0));
    if (hits_part) {
        const PartIndex part = features_[particle.next_index].part;
        item.with("part", scene_->parts[part].name);
    }
    if (hits_ball) {
        const Particle other = particles_[particle.next_index];
        item.with("other_ball", other.ball.number);
        if (other.gone || other.changes != particle.other_version)
            item.with("answer", "the other has changed its path meanwhile: predicted again");
    }
    if (half < infinity<R>()) item.with("isolated_within", static_cast<double>(half));
    item.with("position", narrow(particle.path.at(now_).position))
        .with("velocity_before", narrow(particle.path.at(now_).velocity));
    const auto way_here = [&](const Path<R>& path) {
        return way_of(path, std::max(path.start, run_start_), now_);
    };
    item.with("swept", way_here(particle.path));
    if (hits_ball) item.with("other_swept", way_here(particles_[particle.next_index].path));
    const std::size_t reported = events_.size();
    handle(i);
    item.with("velocity", narrow(particles_[i].path.at(now_).velocity));
    for (std::size_t k = reported; k < events_.size(); ++k)
        if (events_[k].kind == EventKind::impact) item.with("answer", "impact").with_impact(events_[k]);
    trace_next(item, particles_[i]);
    stage.says = counted(stage.items.size(), "event") +
                 " in order of time; a root is isolated within the "
                 "interval given, in which the gap changes its sign.";
}

#define FLIPSIDE_TRACE(R)                       \
    template void Simulation<R>::trace_paths(); \
    template void Simulation<R>::trace_event(BallIndex);
FLIPSIDE_TRACE(double)
FLIPSIDE_TRACE(Real113)
FLIPSIDE_TRACE(Real226)
#undef FLIPSIDE_TRACE

}  // namespace flipside::reference
