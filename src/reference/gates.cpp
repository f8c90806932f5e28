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
R Simulation<R>::gate_reach(const Particle& particle) const {
    return particle.radius * (1 + R(gate_clearance));
}

/// Whether the gate lets a ball through that is within a radius of it.
template <class R>
bool Simulation<R>::passes(PartIndex part, const Particle& particle) const {
    if (parts_[part].open || contains(particle.inside, part)) return true;
    if (contains(particle.blocked, part)) return false;
    const Motion<R> now = view(particle, part).at(now_);
    return lets_through(*gate_of(scene_->parts[part]), narrow(now.position), narrow(now.velocity),
                        particle.ball.radius);
}

/// Decides for each ball at a gate that had no impact event with it: one that was there at the start, or was
/// added. Returns whether anything changed.
template <class R>
bool Simulation<R>::settle_gates() {
    bool changed = false;
    for (PartIndex part = 0; part < parts_.size(); ++part) {
        if (gate_of(scene_->parts[part]) == nullptr) continue;
        const auto is_near = [&](const Particle& particle) {
            return !particle.gone && layers_meet(particle.ball, scene_->parts[part]) &&
                   inside(parts_[part].regions, view(particle, part), gate_reach(particle), now_);
        };
        const auto is_deep = [&](const Particle& particle) {
            return !contains(particle.blocked, part) && inside(parts_[part].regions, view(particle, part),
                                                               R(deep_in_gate * particle.radius), now_);
        };
        parts_[part].open = std::ranges::any_of(particles_, [&](const Particle& particle) {
            return is_near(particle) && (is_deep(particle) || passes(part, particle));
        });
        for (Particle& particle : particles_) {
            const bool near = is_near(particle), open = parts_[part].open;
            if (set(particle.inside, part, near && open)) {
                changed = true;
                if (certificate_) note_passage(particle, part, near && open);
            }
            changed |= set(particle.blocked, part, near && !open);
        }
    }
    return changed;
}

/// Handles a ball that reaches a gate. Returns whether the gate lets it through; it is then open for all
/// balls.
template <class R>
bool Simulation<R>::reach_gate(BallIndex i, PartIndex part) {
    Particle& particle = particles_[i];
    if (!passes(part, particle)) {
        set(particle.blocked, part, true);
        return false;
    }
    set(particle.inside, part, true);
    particle.begins = {};
    if (certificate_) note_passage(particle, part, true);
    parts_[part].open = true;
    start_path(i);
    predict(i);
    // Balls that rested on it start new paths.
    for (BallIndex j = 0; j < particles_.size(); ++j) {
        Particle& other = particles_[j];
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
void Simulation<R>::leave_gate(Particle& particle, PartIndex part) {
    set(particle.blocked, part, false);
    if (!set(particle.inside, part, false)) return;
    if (certificate_) note_passage(particle, part, false);
    parts_[part].open = std::ranges::any_of(
        particles_, [&](const Particle& other) { return !other.gone && contains(other.inside, part); });
}

template <class R>
void Simulation<R>::blocked(std::vector<Blocked>& blocked) const {
    blocked.clear();
    for (const Particle& particle : particles_) {
        if (particle.gone) continue;
        for (const PartIndex gate : particle.blocked) blocked.push_back({gate, particle.ball.number});
    }
    std::ranges::sort(blocked);
}

#define FLIPSIDE_GATES(R)                                                  \
    template bool Simulation<R>::passes(PartIndex, const Particle&) const; \
    template bool Simulation<R>::settle_gates();                           \
    template bool Simulation<R>::reach_gate(BallIndex, PartIndex);         \
    template void Simulation<R>::leave_gate(Particle&, PartIndex);         \
    template R Simulation<R>::gate_reach(const Particle&) const;           \
    template void Simulation<R>::blocked(std::vector<Blocked>&) const;
FLIPSIDE_GATES(double)
FLIPSIDE_GATES(Real113)
FLIPSIDE_GATES(Real226)
#undef FLIPSIDE_GATES

}  // namespace flipside::reference
