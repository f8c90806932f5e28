// Balls get new paths when the parts that they may touch have changed.

#include <algorithm>

#include "reference/simulation.hpp"

namespace flipside::reference {

template <class R>
void Simulation<R>::begin_anew(Place i) {
    if (movers_[i].heap != 0) return;
    advance(movers_[i]);
    start_path(i);
}

/// Handles a change of the parts that a ball may touch.
template <class R>
void Simulation<R>::refresh(Place i) {
    movers_[i].heap != 0 ? look_at_heap_again(movers_[i].heap) : begin_anew(i);
}

template <class R>
void Simulation<R>::refresh_all() {
    while (!heaps_.empty()) end_heap(heaps_.begin()->first);
    for (Place i = 0; i < movers_.size(); ++i)
        if (!movers_[i].gone) begin_anew(i);
    for (Place i = 0; i < movers_.size(); ++i)
        if (!movers_[i].gone) predict(i);
}

/// Handles a change of the motion of a part: predicts the balls near it again.
template <class R>
void Simulation<R>::refresh_beside(PartIndex part) {
    const auto near = [&](const Mover& mover) {
        const auto& features = cells_.features(mover.cell);
        const auto& sensors = cells_.sensors(mover.cell);
        return std::ranges::any_of(features, [&](FeatureIndex f) { return features_[f].part == part; }) ||
               std::ranges::find(sensors, part) != sensors.end();
    };
    look_again_on(part);
    for (Place i = 0; i < movers_.size(); ++i)
        if (!movers_[i].gone && near(movers_[i])) {
            begin_anew(i);
            predict(i);
        }
}

/// Handles a change of the supports of a heap: tests its equilibrium again.
template <class R>
void Simulation<R>::look_at_heap_again(std::uint32_t id) {
    const std::vector<Place> balls = end_heap(id);
    for (const Place j : balls) begin_anew(j);
    for (const Place j : balls) predict(j);
}

template <class R>
void Simulation<R>::look_again_on(PartIndex part) {
    std::vector<std::uint32_t> ids;
    for (const auto& [id, heap] : heaps_)
        if (std::ranges::any_of(heap.features,
                                [&](FeatureIndex f) { return f != nothing && features_[f].part == part; }))
            ids.push_back(id);
    for (const std::uint32_t id : ids)
        if (heaps_.contains(id)) look_at_heap_again(id);
}

/// Starts new paths for the balls that rest on a part which no longer collides.
template <class R>
void Simulation<R>::release(PartIndex part) {
    look_again_on(part);
    const auto on_it = [&](FeatureIndex f) { return f != nothing && features_[f].part == part; };
    for (Place j = 0; j < movers_.size(); ++j) {
        Mover& other = movers_[j];
        if (other.gone || !(on_it(other.held[0]) || on_it(other.held[1]))) continue;
        refresh(j);
        predict(j);
    }
}

#define FLIPSIDE_REFRESH(R)                                         \
    template void Simulation<R>::begin_anew(Place);                 \
    template void Simulation<R>::refresh(Place);                    \
    template void Simulation<R>::refresh_all();                     \
    template void Simulation<R>::refresh_beside(PartIndex);         \
    template void Simulation<R>::look_at_heap_again(std::uint32_t); \
    template void Simulation<R>::look_again_on(PartIndex);          \
    template void Simulation<R>::release(PartIndex);
FLIPSIDE_REFRESH(double)
FLIPSIDE_REFRESH(Real113)
FLIPSIDE_REFRESH(Real226)
#undef FLIPSIDE_REFRESH

}  // namespace flipside::reference
