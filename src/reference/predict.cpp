#include <algorithm>

#include "reference/simulation.hpp"

namespace flipside::reference {

template <class R>
void Simulation<R>::offer(Particle& particle, const R& time, Next next, std::uint32_t index,
                          std::uint32_t changes) {
    const bool ball_with_lower_number =
        next == Next::ball && particle.next == Next::ball && index < particle.next_index;
    if (!(time < particle.next_time || (time == particle.next_time && ball_with_lower_number))) return;
    particle.next_time = time;
    particle.next = next;
    particle.next_index = index;
    particle.other_version = changes;
}

/// When the ball leaves the box, if before its next event so far. Throws Refusal, with the name of the
/// border, if the search does not end.
template <class R>
R Simulation<R>::search_border(const Particle& particle, const char* border, const Box& box,
                               int& side) const {
    try {
        return leaves(particle.path, box, now_, particle.next_time, side);
    } catch (const EndlessSearch&) {
        refuse_search("reference", particle.ball.number, border, clock(now_));
    }
}

/// Predicts the next event of a ball on its path, up to the border of its cell and for at most a second, for
/// which the bounds on speeds hold.
template <class R>
void Simulation<R>::predict(BallIndex i) {
    Particle& particle = particles_[i];
    ++particle.predictions;
    particle.next = Next::nothing;
    particle.next_time = infinity<R>();
    offer(particle, R(now_ + 1), Next::predict_again, 1);
    offer(particle, particle.until, Next::predict_again, 0);
    int side = 0;
    const R crosses = search_border(particle, "the border of its cell", cells_.box(particle.cell), side);
    offer(particle, crosses, Next::cell, static_cast<std::uint32_t>(side));
    if (!particle.reported_lost) {
        if (!scene_->bounds.contains(narrow(particle.body.position)) && particle.path.start == now_)
            offer(particle, now_, Next::lost, outside_already);
        const R goes = search_border(particle, "the bounds", scene_->bounds, side);
        offer(particle, goes, Next::lost, static_cast<std::uint32_t>(side));
    }
    predict_features(particle);
    predict_sensors(particle);
    predict_balls(i);
    const bool meets_ball = particle.next == Next::ball;
    const BallIndex low = meets_ball ? std::min(i, particle.next_index) : i,
                    high = meets_ball ? std::max(i, particle.next_index) : i;
    const std::uint64_t order =
        std::uint64_t{meets_ball} << 63 | std::uint64_t{low} << 32 | std::uint64_t{high};
    queue_.push_back({particle.next_time, i, particle.predictions, order});
    std::push_heap(queue_.begin(), queue_.end());
}

/// Whether the ball reaches this feature only by sliding to the end of its supporting face, or has just slid
/// off it. That is no impact, but rounding could make it look like one.
template <class R>
bool Simulation<R>::slides_to(const Particle& particle, FeatureIndex f) const {
    const FeatureIndex on = particle.support[0];
    if (on == nothing || particle.support[1] != nothing) return false;
    const PartIndex part = features_[f].part, own = features_[on].part;
    if (part != own && (turning(part) != nullptr || turning(own) != nullptr)) return false;
    if (turning(part) == nullptr && turning(own) == nullptr &&
        comes_off(shape(f), particle.path.at(now_), particle.radius))
        return true;
    return ends_in(shape(on), shape(f), particle.support_normal, particle.radius);
}

/// Whether the ball flies along a face and this static feature lies below that face.
template <class R>
bool Simulation<R>::is_below_tangent_face(const Particle& particle, FeatureIndex f) const {
    if (particle.tangent_count == 0 || turning(features_[f].part) != nullptr) return false;
    const auto tangent_faces = std::span(particle.tangent_faces).first(particle.tangent_count);
    return std::ranges::any_of(tangent_faces, [&](const TangentFace& glide) {
        return lies_below(shape(f), glide.at, glide.normal);
    });
}

template <class R>
void Simulation<R>::predict_features(Particle& particle) {
    for (const FeatureIndex f : cells_.features(particle.cell)) {
        ++counts_.pair_tests;
        const PartIndex part = features_[f].part;
        if (f == particle.support[0] || f == particle.support[1] || ignores(part, particle)) continue;
        if (particle.heap != 0 && turning(part) == nullptr) continue;  // neither moves
        if (slides_to(particle, f) || is_below_tangent_face(particle, f)) continue;
        ++counts_.narrow_tests;
        const R last = std::min(particle.next_time, parts_[part].turning.stop);
        const View<R> seen{particle.path, turning(part)};
        const R time = search(particle, Other::part(part), [&] {
            return time_of_impact(shape(f), seen, particle.radius, now_, last, counts_.grazing);
        });
        offer(particle, time, Next::feature, f);
    }
}

template <class R>
void Simulation<R>::predict_sensors(Particle& particle) {
    const auto is_inside = [&](PartIndex part) {
        return std::ranges::find(particle.inside, part) != particle.inside.end();
    };
    const auto offer_exit = [&](PartIndex part) {
        ++counts_.narrow_tests;
        const R last = std::min(particle.next_time, parts_[part].turning.stop);
        const R reach = scene_->parts[part].sensor ? particle.radius : gate_reach(particle);
        const R time = search(particle, Other::part(part), [&] {
            return leaves(parts_[part].regions, view(particle, part), reach, now_, last);
        });
        offer(particle, time, Next::sensor, part);
    };
    for (const PartIndex part : particle.inside) offer_exit(part);
    for (const PartIndex part : particle.blocked) offer_exit(part);
    PartIndex done = ~0U;
    for (const PartIndex part : cells_.sensors(particle.cell)) {
        ++counts_.pair_tests;
        if (part == done || !scene_->parts[part].sensor || is_inside(part) ||
            !layers_meet(particle.ball, scene_->parts[part]))
            continue;
        done = part;
        ++counts_.narrow_tests;
        const R last = std::min(particle.next_time, parts_[part].turning.stop);
        const R time = search(particle, Other::part(part), [&] {
            return enters(parts_[part].regions, view(particle, part), particle.radius, now_, last);
        });
        offer(particle, time, Next::sensor, part);
    }
}

template <class R>
void Simulation<R>::predict_balls(BallIndex i) {
    Particle& particle = particles_[i];
    cells_.each_near(particle.cell, [&](BallIndex j) {
        const Particle& other = particles_[j];
        if (j == i) return;
        ++counts_.pair_tests;
        if (!layers_meet(particle.ball, other.ball) || (particle.heap != 0 && particle.heap == other.heap))
            return;
        ++counts_.narrow_tests;
        const R last = std::min(particle.next_time, other.until);
        const R time = search(particle, Other::ball(other.ball.number), [&] {
            return time_of_impact(particle.path, other.path, R(particle.radius + other.radius), now_, last,
                                  counts_.grazing);
        });
        offer(particle, time, Next::ball, j, other.changes);
    });
}

#define FLIPSIDE_PREDICT(R)                                                                      \
    template void Simulation<R>::offer(Particle&, const R&, Next, std::uint32_t, std::uint32_t); \
    template void Simulation<R>::predict(BallIndex);
FLIPSIDE_PREDICT(double)
FLIPSIDE_PREDICT(Real113)
FLIPSIDE_PREDICT(Real226)
#undef FLIPSIDE_PREDICT

}  // namespace flipside::reference
