#include <algorithm>

#include "reference/simulation.hpp"

namespace flipside::reference {

namespace {

/// Radii: surfaces closer than this count as touching.
constexpr double touch_distance = 1e-4;

}  // namespace

template <class R>
void Simulation<R>::read(std::vector<Ball>& balls) const {
    balls.clear();
    for (const Particle& particle : particles_) {
        if (particle.gone) continue;
        Ball& ball = balls.emplace_back(particle.ball);
        const Motion<R> now = particle.path.at(now_);
        const Spinning<R> spinning = particle.path.spinning_at(now_);
        ball.position = narrow(now.position);
        ball.velocity = narrow(now.velocity);
        ball.angle = static_cast<double>(spinning.angle);
        ball.spin = static_cast<double>(spinning.spin);
        ball.asleep = particle.heap != 0;
    }
}

template <class R>
double Simulation<R>::distance(BallNumber number, Vec2 position) const {
    const auto i = find(number);
    return i ? static_cast<double>(length(particles_[*i].path.at(now_).position - V<R>(position)))
             : std::numeric_limits<double>::infinity();
}

template <class R>
void Simulation<R>::forecast(std::vector<Forecast>& forecasts) const {
    forecasts.clear();
    for (const Particle& particle : particles_) {
        if (particle.gone || particle.next == Next::nothing) continue;
        Forecast& forecast = forecasts.emplace_back();
        forecast.radius = particle.ball.radius;
        forecast.touches = particle.next == Next::feature || particle.next == Next::ball;
        const auto last = static_cast<int>(forecast.way.size()) - 1;
        for (int k = 0; k <= last; ++k)
            forecast.way[static_cast<std::size_t>(k)] =
                narrow(particle.path.at(now_ + k * (particle.next_time - now_) / last).position);
    }
}

template <class R>
void Simulation<R>::occupied(std::vector<std::pair<Box, int>>& cells) const {
    cells.clear();
    for (Cells::Index i = 0; i < cells_.count(); ++i) {
        const int balls = cells_.balls(i);
        if (balls == 0) continue;
        Box box = cells_.box(i);
        box.min = {std::max(box.min.x, scene_->bounds.min.x), std::max(box.min.y, scene_->bounds.min.y)};
        box.max = {std::min(box.max.x, scene_->bounds.max.x), std::min(box.max.y, scene_->bounds.max.y)};
        cells.emplace_back(box, balls);
    }
}

template <class R>
void Simulation<R>::part_contacts(const Particle& particle, std::vector<Contact>& contacts) const {
    const V<R> position = particle.path.at(now_).position;
    for (const FeatureIndex f : cells_.features(particle.cell)) {
        const PartIndex part = features_[f].part;
        if (ignores(part, particle)) continue;
        const Closest<R> seen = closest(f, position, particle.radius);
        if (!seen.facing || seen.gap > touch_distance * particle.radius) continue;
        if (gate_of(scene_->parts[part]) != nullptr && passes(part, particle)) continue;
        const V<R> point = position - (seen.gap + particle.radius) * seen.normal;
        contacts.push_back({particle.ball.number, Other::part(part), narrow(point), narrow(seen.normal),
                            static_cast<double>(seen.gap)});
    }
}

template <class R>
void Simulation<R>::contacts(std::vector<Contact>& contacts) const {
    contacts.clear();
    for (BallIndex i = 0; i < particles_.size(); ++i) {
        const Particle& particle = particles_[i];
        if (particle.gone) continue;
        part_contacts(particle, contacts);
        const V<R> position = particle.path.at(now_).position;
        cells_.each_near(particle.cell, [&](BallIndex j) {
            const Particle& other = particles_[j];
            if (j <= i || !layers_meet(particle.ball, other.ball)) return;
            const V<R> between = position - other.path.at(now_).position;
            const R reach = particle.radius + other.radius;
            if (dot(between, between) > R(1.001) * reach * reach) return;
            const R gap = length(between) - reach;
            if (gap > touch_distance * std::min(particle.radius, other.radius)) return;
            const V<R> normal = unit(between), point = position - (gap + particle.radius) * normal;
            contacts.push_back({particle.ball.number, Other::ball(other.ball.number), narrow(point),
                                narrow(normal), static_cast<double>(gap)});
        });
    }
    keep_deepest(contacts);
}

#define FLIPSIDE_READ_OUT(R)                                             \
    template void Simulation<R>::read(std::vector<Ball>&) const;         \
    template double Simulation<R>::distance(BallNumber, Vec2) const;     \
    template void Simulation<R>::contacts(std::vector<Contact>&) const;  \
    template void Simulation<R>::forecast(std::vector<Forecast>&) const; \
    template void Simulation<R>::occupied(std::vector<std::pair<Box, int>>&) const;
FLIPSIDE_READ_OUT(double)
FLIPSIDE_READ_OUT(Real113)
FLIPSIDE_READ_OUT(Real226)
#undef FLIPSIDE_READ_OUT

}  // namespace flipside::reference
