#include <algorithm>

#include "reference/simulation.hpp"

namespace flipside::reference {

template <class R>
void Simulation<R>::offer(Mover& mover, const R& time, Next next, std::uint32_t index,
                          std::uint32_t changes) {
    if (!(time < mover.next_time)) return;
    mover.next_time = time;
    mover.next = next;
    mover.next_index = index;
    mover.other_version = changes;
}

/// Predicts the next event of a ball on its path, up to the border of its cell and for at most a second, for
/// which the bounds on speeds hold.
template <class R>
void Simulation<R>::predict(BallIndex i) {
    Mover& mover = movers_[i];
    ++mover.predictions;
    mover.next = Next::nothing;
    mover.next_time = infinity<R>();
    offer(mover, R(now_ + 1), Next::predict_again, 1);
    offer(mover, mover.until, Next::predict_again, 0);
    int side = 0;
    const R crosses = leaves(mover.path, cells_.box(mover.cell), now_, mover.next_time, side);
    offer(mover, crosses, Next::cell, static_cast<std::uint32_t>(side));
    if (!mover.reported_lost) {
        if (!scene_->bounds.contains(narrow(mover.body.position)) && mover.path.start == now_)
            offer(mover, now_, Next::lost, outside_already);
        const R goes = leaves(mover.path, scene_->bounds, now_, mover.next_time, side);
        offer(mover, goes, Next::lost, static_cast<std::uint32_t>(side));
    }
    predict_features(mover);
    predict_sensors(mover);
    predict_balls(i);
    queue_.push_back({mover.next_time, i, mover.predictions});
    std::push_heap(queue_.begin(), queue_.end());
}

/// Whether the ball reaches this feature only by sliding to the end of its supporting face, or has just slid
/// off it. That is no impact, but rounding could make it look like one.
template <class R>
bool Simulation<R>::slides_to(const Mover& mover, FeatureIndex f) const {
    const FeatureIndex on = mover.support[0];
    if (on == nothing || mover.support[1] != nothing) return false;
    const PartIndex part = features_[f].part, own = features_[on].part;
    if (part != own && (turning(part) != nullptr || turning(own) != nullptr)) return false;
    if (turning(part) == nullptr && turning(own) == nullptr &&
        comes_off(shape(f), mover.path.at(now_), mover.radius))
        return true;
    return ends_in(shape(on), shape(f), mover.support_normal, mover.radius);
}

/// Whether the ball flies along a face and this static feature lies below that face.
template <class R>
bool Simulation<R>::is_below_tangent_face(const Mover& mover, FeatureIndex f) const {
    if (mover.tangent_count == 0 || turning(features_[f].part) != nullptr) return false;
    const auto tangent_faces = std::span(mover.tangent_faces).first(mover.tangent_count);
    return std::ranges::any_of(tangent_faces, [&](const TangentFace& glide) {
        return lies_below(shape(f), glide.at, glide.normal);
    });
}

template <class R>
void Simulation<R>::predict_features(Mover& mover) {
    for (const FeatureIndex f : cells_.features(mover.cell)) {
        ++counts_.pair_tests;
        const PartIndex part = features_[f].part;
        if (f == mover.support[0] || f == mover.support[1] || ignores(part, mover)) continue;
        if (mover.heap != 0 && turning(part) == nullptr) continue;  // neither moves
        if (slides_to(mover, f) || is_below_tangent_face(mover, f)) continue;
        ++counts_.narrow_tests;
        const R last = std::min(mover.next_time, parts_[part].turning.stop);
        const View<R> seen{mover.path, turning(part)};
        const R time = search(mover, Other::part(part), [&] {
            return time_of_impact(shape(f), seen, mover.radius, now_, last, counts_.grazing);
        });
        offer(mover, time, Next::feature, f);
    }
}

template <class R>
void Simulation<R>::predict_sensors(Mover& mover) {
    const auto is_inside = [&](PartIndex part) {
        return std::ranges::find(mover.inside, part) != mover.inside.end();
    };
    const auto offer_exit = [&](PartIndex part) {
        ++counts_.narrow_tests;
        const R last = std::min(mover.next_time, parts_[part].turning.stop);
        const R reach = scene_->parts[part].sensor ? mover.radius : gate_reach(mover);
        const R time = search(mover, Other::part(part), [&] {
            return leaves(parts_[part].regions, view(mover, part), reach, now_, last);
        });
        offer(mover, time, Next::sensor, part);
    };
    for (const PartIndex part : mover.inside) offer_exit(part);
    for (const PartIndex part : mover.blocked) offer_exit(part);
    PartIndex done = ~0U;
    for (const PartIndex part : cells_.sensors(mover.cell)) {
        ++counts_.pair_tests;
        if (part == done || !scene_->parts[part].sensor || is_inside(part) ||
            !layers_meet(mover.ball, scene_->parts[part]))
            continue;
        done = part;
        ++counts_.narrow_tests;
        const R last = std::min(mover.next_time, parts_[part].turning.stop);
        const R time = search(mover, Other::part(part), [&] {
            return enters(parts_[part].regions, view(mover, part), mover.radius, now_, last);
        });
        offer(mover, time, Next::sensor, part);
    }
}

template <class R>
void Simulation<R>::predict_balls(BallIndex i) {
    Mover& mover = movers_[i];
    cells_.each_near(mover.cell, [&](BallIndex j) {
        const Mover& other = movers_[j];
        if (j == i) return;
        ++counts_.pair_tests;
        if (!layers_meet(mover.ball, other.ball) || (mover.heap != 0 && mover.heap == other.heap)) return;
        ++counts_.narrow_tests;
        const R last = std::min(mover.next_time, other.until);
        const R time = search(mover, Other::ball(other.ball.number), [&] {
            return time_of_impact(mover.path, other.path, R(mover.radius + other.radius), now_, last,
                                  counts_.grazing);
        });
        offer(mover, time, Next::ball, j, other.changes);
    });
}

#define FLIPSIDE_PREDICT(R)                                                                   \
    template void Simulation<R>::offer(Mover&, const R&, Next, std::uint32_t, std::uint32_t); \
    template void Simulation<R>::predict(BallIndex);
FLIPSIDE_PREDICT(double)
FLIPSIDE_PREDICT(Real113)
FLIPSIDE_PREDICT(Real226)
#undef FLIPSIDE_PREDICT

}  // namespace flipside::reference
