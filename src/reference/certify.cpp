// Writes the certificate of the exact engine (certificate.hpp).

#include <algorithm>

#include "reference/simulation.hpp"

namespace flipside::reference {

namespace {

/// Half the width of the narrowest interval about `time` over which `gap` falls from above `margin` to below
/// −margin, tried in doublings from `half` on; infinite where it does not change its sign: a graze, or a
/// touch that lasts.
template <class R>
R isolate(const R& time, R half, const R& margin, auto&& gap) {
    constexpr int most_doublings = 48;
    for (int k = 0; k < most_doublings; ++k, half *= 2)
        if (gap(R(time - half)) > margin && gap(R(time + half)) < -margin) return half;
    return infinity<R>();
}

}  // namespace

/// Half the width of an interval around now that isolates the impact of a ball.
/// `digit` is what times are rounded to, relative, and `margin` what counts as no gap, m.
template <class R>
R Simulation<R>::isolated_within(const Particle& particle, const R& digit, const R& margin) const {
    const R half = digit * std::max(R(1), magnitude(now_));
    if (particle.next == Next::feature) {
        const View<R> seen{particle.path, turning(features_[particle.next_index].part)};
        return isolate(now_, half, margin, [&](const R& t) {
            return closest_point(shape(particle.next_index), seen.at(t).position, particle.radius).gap;
        });
    }
    if (particle.next != Next::ball) return infinity<R>();
    const Particle& other = particles_[particle.next_index];
    return isolate(now_, half, margin, [&](const R& t) {
        return length(particle.path.at(t).position - other.path.at(t).position) - particle.radius -
               other.radius;
    });
}

/// Notes an impact before the ball is moved there.
template <class R>
void Simulation<R>::note_impact(BallIndex i) {
    constexpr double longest = 1e-6;  // s; over a longer time the ball may have reversed
    // Wide enough for numbers rounded to double.
    const R size = length(particles_[i].path.at(now_).position) + particles_[i].radius;
    const R half = isolated_within(particles_[i], R(0x1p-48), R(0x1p-48 * size));
    const auto note = [&](Particle& particle, Beginning::Why why, std::uint32_t index, std::size_t other_leg,
                          const V<R>& normal) {
        Beginning& begins = particle.begins;
        begins = {why,
                  index,
                  other_leg,
                  {},
                  narrow(particle.path.at(now_).velocity),
                  static_cast<double>(particle.path.spinning_at(now_).spin),
                  narrow(normal)};
        if (half < longest) begins.within = static_cast<double>(half);
    };
    Particle& particle = particles_[i];
    const V<R> position = particle.path.at(now_).position;
    if (particle.next == Next::feature)
        return note(particle, Beginning::Why::hits_part, particle.next_index, 0,
                    closest(particle.next_index, position, particle.radius).normal);
    Particle& other = particles_[particle.next_index];
    const V<R> normal = unit(V<R>(position - other.path.at(now_).position));
    const auto next_leg = [&](const Particle& one) {
        return certificate_->balls[one.ball.number].legs.size();
    };
    note(particle, Beginning::Why::hits_ball, other.ball.number, next_leg(other), normal);
    note(other, Beginning::Why::hits_ball, particle.ball.number, next_leg(particle), -normal);
}

template <class R>
void Simulation<R>::note_leg(Particle& particle, bool given) {
    const Path<R>& path = particle.path;
    CertifiedBall& certified = certificate_->balls[particle.ball.number];
    if (certified.legs.empty()) certified.ball = particle.ball;
    Leg& leg = certified.legs.emplace_back();
    leg.begins = particle.begins;
    particle.begins = {};
    if (given) leg.begins.why = Beginning::Why::given;
    leg.start = static_cast<double>(since_certificate_ + path.start);
    leg.position = narrow(path.position);
    leg.velocity = narrow(path.velocity);
    leg.spin = static_cast<double>(path.spin);
    note_pair_of_parts(particle, leg.start);
    if (path.is_series) {
        leg.held = particle.support[0];
        for (std::size_t k = 1; k <= taylor_order<R>; ++k) {
            if (k > 1) leg.displacements.push_back(narrow(path.displacements[k]));
            leg.spins.push_back(static_cast<double>(path.spins[k]));
        }
        return;
    }
    if (path.spin_rate != 0) leg.spins.push_back(static_cast<double>(path.spin_rate));
    if (path.rests) return;
    if (particle.support[0] != nothing) leg.held = particle.support[0];
    leg.acceleration = narrow(path.acceleration);
    leg.drag = static_cast<double>(path.drag);
    leg.roll = narrow(path.roll);
}

template <class R>
void Simulation<R>::note_motion(PartIndex part) {
    const Turning<R>& turning = parts_[part].turning;
    certificate_->motions[part].push_back({static_cast<double>(since_certificate_ + turning.since),
                                           static_cast<double>(turning.angle),
                                           static_cast<double>(turning.rate)});
}

template <class R>
void Simulation<R>::note_target(PartIndex part) {
    certificate_->targets.push_back(
        {part, static_cast<double>(since_certificate_ + now_), parts_[part].down});
}

template <class R>
void Simulation<R>::note_input(std::optional<BallNumber> ball, Vec2 velocity) {
    certificate_->inputs.push_back({static_cast<double>(since_certificate_ + now_), ball, velocity});
}

/// Notes that a ball begins anew where a raised target has moved it, with the velocity that it has.
template <class R>
void Simulation<R>::note_moved(Particle& particle) {
    note_input(particle.ball.number, narrow(particle.body.velocity));
    particle.begins = {};
    particle.begins.why = Beginning::Why::given;
}

template <class R>
void Simulation<R>::note_passage(const Particle& particle, PartIndex gate, bool begins) {
    const auto time = static_cast<double>(since_certificate_ + now_);
    auto& passages = certificate_->passages;
    if (begins) return passages.push_back({particle.ball.number, gate, time, {}});
    for (Passage& passage : passages)
        if (passage.ball == particle.ball.number && passage.gate == gate && !passage.until)
            passage.until = time;
}

/// Notes a ball that begins or ends to rest on two parts.
template <class R>
void Simulation<R>::note_pair_of_parts(Particle& particle, double start) {
    if (particle.noted_rest) certificate_->rests[*particle.noted_rest].until = start;
    particle.noted_rest.reset();
    if (particle.support[1] == nothing) return;
    particle.noted_rest = certificate_->rests.size();
    Rest& rest = certificate_->rests.emplace_back();
    rest.from = start;
    for (int k = 0; k < 2; ++k)
        rest.forces.push_back({particle.ball.number,
                               {},
                               particle.support[k],
                               static_cast<double>(particle.support_force[k]),
                               static_cast<double>(particle.support_friction[k])});
}

template <class R>
void Simulation<R>::note_rest(Heap& heap) {
    heap.noted = certificate_->rests.size();
    Rest& rest = certificate_->rests.emplace_back();
    rest.from = static_cast<double>(since_certificate_ + now_);
    const auto number = [&](std::uint32_t k) { return particles_[heap.balls[k]].ball.number; };
    for (std::size_t k = 0; k < heap.supports.size(); ++k) {
        const Support& support = heap.supports[k];
        RestingForce& force = rest.forces.emplace_back();
        force.ball = number(support.disc);
        if (support.other != Support::fixed) force.other = number(support.other);
        if (heap.features[k] != nothing) force.feature = heap.features[k];
        force.normal = support.normal_force;
        force.friction = support.friction_force;
    }
}

template <class R>
void Simulation<R>::note_rest_ends(const Heap& heap) {
    certificate_->rests[heap.noted].until = static_cast<double>(since_certificate_ + now_);
}

template <class R>
void Simulation<R>::certify(Certificate* certificate) {
    certificate_ = certificate;
    if (certificate_ == nullptr) return;
    since_certificate_ = -now_;
    for (PartIndex part = 0; part < parts_.size(); ++part) {
        if (parts_[part].moves) note_motion(part);
        if (parts_[part].down) certificate_->targets.push_back({part, 0, true});
    }
    for (Particle& particle : particles_) {
        particle.noted_rest.reset();
        if (particle.gone) continue;
        note_leg(particle, true);
        for (const PartIndex part : particle.inside)
            if (!scene_->parts[part].sensor) note_passage(particle, part, true);
    }
    for (auto& [id, heap] : heaps_) note_rest(heap);
}

#define FLIPSIDE_CERTIFY(R)                                                               \
    template R Simulation<R>::isolated_within(const Particle&, const R&, const R&) const; \
    template void Simulation<R>::note_impact(BallIndex);                                  \
    template void Simulation<R>::note_leg(Particle&, bool);                               \
    template void Simulation<R>::note_input(std::optional<BallNumber>, Vec2);             \
    template void Simulation<R>::note_target(PartIndex);                                  \
    template void Simulation<R>::note_moved(Particle&);                                   \
    template void Simulation<R>::note_motion(PartIndex);                                  \
    template void Simulation<R>::note_passage(const Particle&, PartIndex, bool);          \
    template void Simulation<R>::note_rest(Heap&);                                        \
    template void Simulation<R>::note_rest_ends(const Heap&);                             \
    template void Simulation<R>::certify(Certificate*);
FLIPSIDE_CERTIFY(double)
FLIPSIDE_CERTIFY(Real113)
FLIPSIDE_CERTIFY(Real226)
#undef FLIPSIDE_CERTIFY

}  // namespace flipside::reference
