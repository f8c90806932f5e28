#include "lab/blame/missed_contact.hpp"

#include <algorithm>
#include <stdexcept>

#include "lab/blame/met_kind.hpp"
#include "world/surface.hpp"

namespace flipside::lab {

namespace {

bool holds_open(const MissedContact& contact) {
    const Other other = contact.due.other;
    if (other.is_ball || gate_of(contact.scene.parts[other.index]) == nullptr) return false;
    return contact.before.parts[other.index].open || contact.after.parts[other.index].open;
}

/// How the ball lies to what it should meet.
struct Lie {
    bool touches = false;
    bool recedes = false;  ///< the surface of a part taken as at rest
};
Lie lie(const MissedContact& contact, const State& state) {
    constexpr double touching = 1e-6;  // radii
    const Ball* const ball = find_ball(state.balls, contact.due.ball);
    const Other other = contact.due.other;
    const Ball* const met = other.is_ball ? find_ball(state.balls, other.index) : nullptr;
    if (ball == nullptr || (other.is_ball && met == nullptr)) return {};
    if (met != nullptr) {
        const Vec2 apart = ball->position - met->position;
        return {length(apart) <= (1 + touching) * (ball->radius + met->radius),
                dot(ball->velocity - met->velocity, apart) >= 0};
    }
    const PartState& part = state.parts[other.index];
    const Vec2 normal = surface_normal(contact.scene, other.index, part, ball->position, ball->radius);
    return {
        separation(contact.scene, other.index, part, ball->position, ball->radius) <= touching * ball->radius,
        dot(ball->velocity, normal) >= 0};
}

bool names(const TraceItem& item, const char* name, const TraceValue& value) {
    const TraceValue* const found = item.find(name);
    return found != nullptr && *found == value;
}

/// Whether an item of a broad phase says that it hands on the pair.
bool offers(const TraceItem& item, const MissedContact& contact) {
    if (item.kind != "pair" && !(item.kind == "test" && names(item, "overlap", true))) return false;
    const auto ball = [](std::uint32_t number) { return TraceValue(std::int64_t{number}); };
    const auto& [number, other] = std::pair(ball(contact.due.ball), contact.due.other);
    if (!other.is_ball)
        return names(item, "ball", number) && names(item, "part", contact.scene.parts[other.index].name);
    return (names(item, "ball", number) && names(item, "other_ball", ball(other.index))) ||
           (names(item, "ball", ball(other.index)) && names(item, "other_ball", number));
}

/// Whether the trace of the step lists pairs, but not this one.
bool was_overlooked(const MissedContact& contact, World& own) {
    Trace trace;
    own.trace(&trace);
    try {
        own.restore(contact.before);
        own.step(contact.after.clock.time - contact.before.clock.time);
    } catch (const std::runtime_error&) {
        trace.stages.clear();  // no evidence
    }
    own.trace(nullptr);
    bool lists = false, offered = false;
    for (const TraceStage& stage : trace.stages) {
        if (!stage.name.starts_with("broad phase")) continue;
        lists = true;
        offered |=
            std::ranges::any_of(stage.items, [&](const TraceItem& item) { return offers(item, contact); });
    }
    return lists && !offered;
}

}  // namespace

Fault why_missed(const MissedContact& contact, World* own) {
    if (holds_open(contact)) return Fault::let_through;
    const Lie after = lie(contact, contact.after);
    if (!lie(contact, contact.before).touches && (!after.touches || after.recedes)) return Fault::tunnelled;
    return own != nullptr && was_overlooked(contact, *own) ? Fault::unpaired : Fault::missed;
}

}  // namespace flipside::lab
