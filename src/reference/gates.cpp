#include <algorithm>

#include "reference/simulation.hpp"
#include "world/gate.hpp"

namespace flipside::reference {

namespace {

bool contains(const std::vector<PartIndex>& list, PartIndex part) {
    return std::ranges::find(list, part) != list.end();
}

/// Returns whether the list changed.
bool set(std::vector<PartIndex>& list, PartIndex part, bool is_in) {
    const bool was_in = contains(list, part);
    if (is_in && !was_in) list.push_back(part);
    if (!is_in && was_in) std::erase(list, part);
    return is_in != was_in;
}

}  // namespace

/// A ball whose centre is farther than this from a gate has left it, m.
template <class R>
R Simulation<R>::gate_reach(const Mover& mover) const {
    return mover.radius * (1 + R(gate_clearance));
}

/// Whether the gate lets a ball through that is within a radius of it.
template <class R>
bool Simulation<R>::passes(PartIndex part, const Mover& mover) const {
    if (parts_[part].open || contains(mover.inside, part)) return true;
    if (contains(mover.blocked, part)) return false;
    const Motion<R> now = view(mover, part).at(now_);
    return lets_through(*gate_of(scene_->parts[part]), narrow(now.position), narrow(now.velocity),
                        mover.ball.radius);
}

/// Decides for each ball at a gate that had no impact event with it: one that was there at the start, or was
/// added. Returns whether anything changed.
template <class R>
bool Simulation<R>::settle_gates() {
    bool changed = false;
    for (PartIndex part = 0; part < parts_.size(); ++part) {
        if (gate_of(scene_->parts[part]) == nullptr) continue;
        const auto is_near = [&](const Mover& mover) {
            return !mover.gone && layers_meet(mover.ball, scene_->parts[part]) &&
                   inside(parts_[part].regions, view(mover, part), gate_reach(mover), now_);
        };
        const auto is_deep = [&](const Mover& mover) {
            return !contains(mover.blocked, part) &&
                   inside(parts_[part].regions, view(mover, part), R(deep_in_gate * mover.radius), now_);
        };
        parts_[part].open = std::ranges::any_of(movers_, [&](const Mover& mover) {
            return is_near(mover) && (is_deep(mover) || passes(part, mover));
        });
        for (Mover& mover : movers_) {
            const bool near = is_near(mover), open = parts_[part].open;
            if (set(mover.inside, part, near && open)) {
                changed = true;
                if (certificate_) note_passage(mover, part, near && open);
            }
            changed |= set(mover.blocked, part, near && !open);
        }
    }
    return changed;
}

/// Handles a ball that reaches a gate. Returns whether the gate lets it through; it is then open for all
/// balls.
template <class R>
bool Simulation<R>::reach_gate(BallIndex i, PartIndex part) {
    Mover& mover = movers_[i];
    if (!passes(part, mover)) {
        set(mover.blocked, part, true);
        return false;
    }
    set(mover.inside, part, true);
    mover.begins = {};
    if (certificate_) note_passage(mover, part, true);
    parts_[part].open = true;
    start_path(i);
    predict(i);
    // Balls that rested on it start new paths.
    for (BallIndex j = 0; j < movers_.size(); ++j) {
        Mover& other = movers_[j];
        if (other.gone || !set(other.blocked, part, false)) continue;
        set(other.inside, part, true);
        if (certificate_) note_passage(other, part, true);
        refresh(j);
        predict(j);
    }
    return true;
}

/// Handles a ball that has left a gate, whether the gate let it through or not.
template <class R>
void Simulation<R>::leave_gate(Mover& mover, PartIndex part) {
    set(mover.blocked, part, false);
    if (!set(mover.inside, part, false)) return;
    if (certificate_) note_passage(mover, part, false);
    parts_[part].open = std::ranges::any_of(
        movers_, [&](const Mover& other) { return !other.gone && contains(other.inside, part); });
}

template <class R>
void Simulation<R>::blocked(std::vector<Blocked>& blocked) const {
    blocked.clear();
    for (const Mover& mover : movers_) {
        if (mover.gone) continue;
        for (const PartIndex gate : mover.blocked) blocked.push_back({gate, mover.ball.number});
    }
    std::ranges::sort(blocked);
}

#define FLIPSIDE_GATES(R)                                               \
    template bool Simulation<R>::passes(PartIndex, const Mover&) const; \
    template bool Simulation<R>::settle_gates();                        \
    template bool Simulation<R>::reach_gate(BallIndex, PartIndex);      \
    template void Simulation<R>::leave_gate(Mover&, PartIndex);         \
    template R Simulation<R>::gate_reach(const Mover&) const;           \
    template void Simulation<R>::blocked(std::vector<Blocked>&) const;
FLIPSIDE_GATES(double)
FLIPSIDE_GATES(Real113)
FLIPSIDE_GATES(Real226)
#undef FLIPSIDE_GATES

}  // namespace flipside::reference
