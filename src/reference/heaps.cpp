// Static heaps: balls at rest in contact with each other.
//
// If contact forces among such balls and from static parts balance their weights (equilibrium.hpp), they are
// a heap and stay at rest. An impact on one of them is refused. If their supports change, equilibrium is
// tested again. Balls that rest on parts alone are no heap.

#include <algorithm>
#include <utility>

#include "reference/simulation.hpp"
#include "world/refusal.hpp"

namespace flipside::reference {

/// Position and velocity of a ball now, without advancing it.
template <class R>
Body<R> Simulation<R>::body_now(const Particle& particle) const {
    if (particle.path.start == now_) return particle.body;
    const Motion<R> now = particle.path.at(now_);
    const Spinning<R> spinning = particle.path.spinning_at(now_);
    return {now.position, now.velocity, spinning.angle, spinning.spin, particle.radius};
}

/// Whether a ball is at rest: its bounces are lower than the rounding of its position.
template <class R>
bool Simulation<R>::is_at_rest(const Particle& particle) const {
    using std::sqrt;
    const Body<R> body = body_now(particle);
    const R lowest_bounce = sqrt(2 * rounding_of(body) * length(external_.gravity));
    return length(body.velocity) <= lowest_bounce && magnitude(body.spin) * particle.radius <= lowest_bounce;
}

/// The balls at rest that touch this one, which is at rest itself.
template <class R>
auto Simulation<R>::touched_at_rest(BallIndex i) const -> std::vector<BallIndex> {
    const Particle& particle = particles_[i];
    std::vector<BallIndex> found;
    cells_.each_near(particle.cell, [&](BallIndex j) {
        const Particle& other = particles_[j];
        if (j == i || !layers_meet(particle.ball, other.ball)) return;
        const R gap =
            length(body_now(particle).position - body_now(other).position) - particle.radius - other.radius;
        if (in_touch(gap, std::min(particle.radius, other.radius)) && is_at_rest(other)) found.push_back(j);
    });
    std::ranges::sort(found);
    return found;
}

/// Whether a ball at rest touches another that its weight can load.
template <class R>
bool Simulation<R>::rests_on_ball(BallIndex i) const {
    return length(external_.gravity) > 0 && is_at_rest(particles_[i]) && !touched_at_rest(i).empty();
}

/// All balls at rest in contact with this one, directly or through others, with their supports.
template <class R>
auto Simulation<R>::connected_balls_at_rest(BallIndex i) const -> Heap {
    Heap heap;
    heap.balls = {i};
    std::vector<char> seen(particles_.size());
    seen[i] = 1;
    for (std::size_t k = 0; k < heap.balls.size(); ++k)
        for (const BallIndex j : touched_at_rest(heap.balls[k]))
            if (std::exchange(seen[j], 1) == 0) heap.balls.push_back(j);
    std::ranges::sort(heap.balls);
    for (std::uint32_t k = 0; k < heap.balls.size(); ++k) {
        part_supports(heap, k);
        for (const BallIndex j : touched_at_rest(heap.balls[k])) {
            if (j > heap.balls[k]) continue;
            const Particle &particle = particles_[heap.balls[k]], &other = particles_[j];
            const auto at = std::ranges::lower_bound(heap.balls, j) - heap.balls.begin();
            const Vec2 normal = narrow(unit(V<R>(body_now(particle).position - body_now(other).position)));
            heap.supports.push_back({k, static_cast<std::uint32_t>(at), normal,
                                     mixed(particle.ball.material, other.ball.material).friction});
            heap.features.push_back(nothing);
        }
    }
    return heap;
}

/// Adds the contacts of the k-th ball of a heap with static parts.
template <class R>
void Simulation<R>::part_supports(Heap& heap, std::uint32_t k) const {
    const Particle& particle = particles_[heap.balls[k]];
    for (const FeatureIndex f : cells_.features(particle.cell)) {
        const PartIndex part = features_[f].part;
        if (ignores(part, particle) || turning(part) != nullptr) continue;
        const Closest<R> seen = closest(f, body_now(particle).position, particle.radius);
        if (!seen.facing || !in_touch(seen.gap, particle.radius)) continue;
        if (gate_of(scene_->parts[part]) != nullptr && passes(part, particle)) continue;
        heap.supports.push_back({k, Support::fixed, narrow(seen.normal),
                                 mixed(particle.ball.material, scene_->parts[part].material).friction});
        heap.features.push_back(f);
    }
}

/// Finds the heap of a ball that rests on others, and puts its balls to rest if they can be in equilibrium.
template <class R>
bool Simulation<R>::find_heap(BallIndex i) {
    constexpr std::size_t most = 400;  // balls; so many take seconds
    if (particles_[i].heap_searched_at == now_ || !rests_on_ball(i)) return false;
    Heap heap = connected_balls_at_rest(i);
    std::vector<Vec2> weights;
    for (const BallIndex j : heap.balls) weights.push_back(particles_[j].ball.mass * scene_->gravity);
    std::vector<Support> parts_alone = heap.supports;
    std::erase_if(parts_alone, [](const Support& one) { return one.other != Support::fixed; });
    const bool too_many = heap.balls.size() > most;
    const bool stand = !too_many && find_equilibrium(weights, parts_alone).share <= balance_tolerance;
    const Imbalance left = stand || too_many ? Imbalance{} : find_equilibrium(weights, heap.supports);
    if (!stand && !too_many && left.share <= balance_tolerance) {
        settle(std::move(heap));
        return true;
    }
    std::string why;
    if (too_many) why = ", and is too large to look for equilibrium in it";
    if (left.share > 0)
        why = ", and in this one ball " + std::to_string(particles_[heap.balls[left.disc]].ball.number) +
              " begins to move: " + std::to_string(left.share) + " of its weight is not held";
    for (const BallIndex j : heap.balls) {
        particles_[j].heap_searched_at = now_;
        if (stand) continue;
        particles_[j].no_equilibrium_since = now_;
        particles_[j].no_equilibrium = why;
    }
    return false;
}

template <class R>
void Simulation<R>::settle(Heap heap) {
    const std::uint32_t id = ++last_heap_;
    for (const BallIndex j : heap.balls) {
        Particle& particle = particles_[j];
        if (particle.heap != 0) end_heap(particle.heap);
        const Body<R> body = body_now(particle);
        particle.body = {body.position, {}, body.angle, R(0), particle.radius};
        ++particle.changes;
        particle.heap = id;
        particle.support[0] = particle.support[1] = particle.left = nothing;
        particle.tangent_count = 0;
        particle.until = infinity<R>();
        particle.separates = false;
        particle.path = {};
        particle.path.rests = true;
        particle.path.start = now_;
        particle.path.position = body.position;
        particle.path.angle = body.angle;
        const bool given = std::exchange(particle.given, false);
        if (certificate_) note_leg(particle, given);
    }
    if (certificate_) note_rest(heap);
    heaps_.emplace(id, std::move(heap));
}

/// Dissolves a heap; its balls are still at rest.
template <class R>
auto Simulation<R>::end_heap(std::uint32_t id) -> std::vector<BallIndex> {
    const auto at = heaps_.find(id);
    std::vector<BallIndex> balls = std::move(at->second.balls);
    if (certificate_) note_rest_ends(at->second);
    heaps_.erase(at);
    std::erase_if(balls, [&](BallIndex j) { return particles_[j].gone; });
    for (const BallIndex j : balls) particles_[j].heap = 0;
    return balls;
}

/// Refuses an impact on a ball of a heap.
template <class R>
void Simulation<R>::refuse_impact_on_heap(const Particle& hit, const std::string& by) const {
    throw Refusal("reference: " + by + " hits ball " + std::to_string(hit.ball.number) + " in a heap of " +
                  std::to_string(heaps_.at(hit.heap).balls.size()) + " balls in resting contact" +
                  at_time(now_) + ": resting contact between balls has no order of impacts");
}

#define FLIPSIDE_HEAPS(R)                                                         \
    template bool Simulation<R>::rests_on_ball(BallIndex) const;                  \
    template bool Simulation<R>::find_heap(BallIndex);                            \
    template auto Simulation<R>::end_heap(std::uint32_t)->std::vector<BallIndex>; \
    template void Simulation<R>::refuse_impact_on_heap(const Particle&, const std::string&) const;
FLIPSIDE_HEAPS(double)
FLIPSIDE_HEAPS(Real113)
FLIPSIDE_HEAPS(Real226)
#undef FLIPSIDE_HEAPS

}  // namespace flipside::reference
