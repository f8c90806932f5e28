// Balls get new paths when the parts that they may touch have changed.

#include <algorithm>

#include "reference/simulation.hpp"

namespace flipside::reference {

template <class R>
void Simulation<R>::restart_path(BallIndex i) {
    if (particles_[i].heap != 0) return;
    advance(particles_[i]);
    start_path(i);
}

/// Handles a change of the parts that a ball may touch.
template <class R>
void Simulation<R>::refresh(BallIndex i) {
    particles_[i].heap != 0 ? test_heap_again(particles_[i].heap) : restart_path(i);
}

template <class R>
void Simulation<R>::refresh_all() {
    while (!heaps_.empty()) end_heap(heaps_.begin()->first);
    for (BallIndex i = 0; i < particles_.size(); ++i)
        if (!particles_[i].gone) restart_path(i);
    for (BallIndex i = 0; i < particles_.size(); ++i)
        if (!particles_[i].gone) predict(i);
}

/// Handles a change of the motion of a part: predicts the balls near it again.
template <class R>
void Simulation<R>::refresh_beside(PartIndex part) {
    const auto near = [&](const Particle& particle) {
        const auto& features = cells_.features(particle.cell);
        const auto& sensors = cells_.sensors(particle.cell);
        return std::ranges::any_of(features, [&](FeatureIndex f) { return features_[f].part == part; }) ||
               std::ranges::find(sensors, part) != sensors.end();
    };
    test_heaps_on(part);
    for (BallIndex i = 0; i < particles_.size(); ++i)
        if (!particles_[i].gone && near(particles_[i])) {
            restart_path(i);
            predict(i);
        }
}

/// Handles a change of the supports of a heap: tests its equilibrium again.
template <class R>
void Simulation<R>::test_heap_again(std::uint32_t id) {
    const std::vector<BallIndex> balls = end_heap(id);
    for (const BallIndex j : balls) restart_path(j);
    for (const BallIndex j : balls) predict(j);
}

template <class R>
void Simulation<R>::test_heaps_on(PartIndex part) {
    std::vector<std::uint32_t> ids;
    for (const auto& [id, heap] : heaps_)
        if (std::ranges::any_of(heap.features,
                                [&](FeatureIndex f) { return f != nothing && features_[f].part == part; }))
            ids.push_back(id);
    for (const std::uint32_t id : ids)
        if (heaps_.contains(id)) test_heap_again(id);
}

/// Starts new paths for the balls that rest on a part which no longer collides.
template <class R>
void Simulation<R>::release(PartIndex part) {
    test_heaps_on(part);
    const auto on_it = [&](FeatureIndex f) { return f != nothing && features_[f].part == part; };
    for (BallIndex j = 0; j < particles_.size(); ++j) {
        Particle& other = particles_[j];
        if (other.gone || !(on_it(other.support[0]) || on_it(other.support[1]))) continue;
        refresh(j);
        predict(j);
    }
}

#define FLIPSIDE_REFRESH(R)                                      \
    template void Simulation<R>::restart_path(BallIndex);        \
    template void Simulation<R>::refresh(BallIndex);             \
    template void Simulation<R>::refresh_all();                  \
    template void Simulation<R>::refresh_beside(PartIndex);      \
    template void Simulation<R>::test_heap_again(std::uint32_t); \
    template void Simulation<R>::test_heaps_on(PartIndex);       \
    template void Simulation<R>::release(PartIndex);
FLIPSIDE_REFRESH(double)
FLIPSIDE_REFRESH(Real113)
FLIPSIDE_REFRESH(Real226)
#undef FLIPSIDE_REFRESH

}  // namespace flipside::reference
