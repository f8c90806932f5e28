#include "reference/simulation.hpp"

#include <algorithm>
#include <utility>

#include "world/refusal.hpp"
#include "world/table.hpp"

namespace flipside::reference {

namespace {

/// Box of a feature in every pose that its part may take.
template <class R>
Box range_of(const Feature<R>& feature, const Part& part, Vec2 pivot) {
    const Box box = bounds_of(feature);
    if (!Table::moves(part)) return box;
    const double dx = std::max(box.max.x - pivot.x, pivot.x - box.min.x);
    const double dy = std::max(box.max.y - pivot.y, pivot.y - box.min.y);
    const double far = length(Vec2{dx, dy});
    return {{pivot.x - far, pivot.y - far}, {pivot.x + far, pivot.y + far}};
}

}  // namespace

template <class R>
Simulation<R>::Simulation(std::shared_ptr<const Scene> scene)
    : scene_(std::move(scene)),
      primitives_(surface_of(*scene_)),
      external_{V<R>(scene_->gravity), R(scene_->damping)},
      features_(features_of<R>(primitives_, *scene_)),
      posed_(features_),
      parts_(scene_->parts.size()) {
    for (PartIndex i = 0; i < parts_.size(); ++i) {
        const Part& part = scene_->parts[i];
        PartNow& now = parts_[i];
        now.moves = Table::moves(part);
        if (const auto* turn = std::get_if<motion::Turn>(&part.motion)) now.turning.pivot = V<R>(turn->pivot);
        if (std::holds_alternative<motion::Flip>(part.motion))
            now.turning.pivot = V<R>(std::get<shape::Flipper>(part.shape.is).pivot);
        if (part.sensor || gate_of(part) != nullptr) now.regions = regions_of<R>(primitives_, i);
        while (now.first < features_.size() && features_[now.first].part < i) ++now.first;
        now.last = now.first;
        while (now.last < features_.size() && features_[now.last].part == i) ++now.last;
    }
    for (const Material& a : scene_->materials)
        for (const Material& b : scene_->materials) mixed_.push_back(mix(a, b));
}

template <class R>
void Simulation<R>::load(const State& state) {
    particles_.clear();
    heaps_.clear();
    queue_.clear();
    events_.clear();
    now_ = run_start_ = R(0);
    length_ = 0;
    time_ = state.clock.time;
    reported_lost_ = state.reported_lost;
    raised_[0] = state.raised[0], raised_[1] = state.raised[1];
    rotating_ = state.rotating;
    for (PartIndex i = 0; i < parts_.size(); ++i) {
        parts_[i].open = state.parts[i].open;
        parts_[i].down = state.parts[i].down;
        Turning<R>& turning = parts_[i].turning;
        turning.angle = R(state.parts[i].angle);
        turning.rate = R(0);
        turning.since = R(0);
        turning.stop = infinity<R>();
        if (parts_[i].moves) set_motion(i);
    }
    for (const Ball& ball : state.balls) join(ball);
    for (const Blocked& blocked : state.blocked)
        if (const auto i = find(blocked.ball)) particles_[*i].blocked.push_back(blocked.gate);
    rebuild_cells();
    settle_gates();  // those that block a ball are solid to it
    for (BallIndex i = 0; i < particles_.size(); ++i) {
        move_out_of_parts(i);
        begin_inside(particles_[i]);
    }
    settle_gates();
    refresh_all();
}

template <class R>
void Simulation<R>::join(const Ball& ball) {
    Particle& particle = particles_.emplace_back();
    particle.ball = ball;
    particle.radius = R(ball.radius);
    particle.mass = R(ball.mass);
    particle.reported_lost = std::ranges::find(reported_lost_, ball.number) != reported_lost_.end();
    particle.body = {V<R>(ball.position), V<R>(ball.velocity), R(ball.angle), R(ball.spin), R(ball.radius)};
    particle.path.start = now_;
    particle.path.position = particle.body.position;
    particle.path.velocity = particle.body.velocity;
    particle.path.angle = particle.body.angle;
    particle.path.spin = particle.body.spin;
    particle.inside.reserve(8);
    particle.blocked.reserve(2);
}

template <class R>
void Simulation<R>::rebuild_cells() {
    std::vector<Cells::Item> items;
    for (const Feature<R>& feature : features_)
        items.push_back(
            {range_of(feature, scene_->parts[feature.part], narrow(parts_[feature.part].turning.pivot)),
             feature.part, false});
    for (const Primitive& primitive : primitives_)
        if (!parts_[primitive.part].regions.empty()) {
            Scene plain;  // the primitive as if it could be touched
            plain.parts.resize(scene_->parts.size());
            for (const Feature<R>& feature : features_of<R>({primitive}, plain))
                items.push_back({range_of(feature, scene_->parts[primitive.part],
                                          narrow(parts_[primitive.part].turning.pivot)),
                                 primitive.part, true});
        }
    double radius = scene_->launcher ? scene_->launcher->ball.radius : 0;
    for (const Particle& particle : particles_) radius = std::max(radius, particle.ball.radius);
    cells_.build(scene_->bounds, items, particles_.size(), radius);
    for (BallIndex i = 0; i < particles_.size(); ++i) {
        Particle& particle = particles_[i];
        if (particle.gone) continue;
        particle.cell = cells_.at(narrow(particle.path.at(now_).position));
        cells_.link(i, particle.cell);
    }
}

template <class R>
void Simulation<R>::begin_inside(Particle& particle) {
    particle.inside.clear();
    for (PartIndex part = 0; part < parts_.size(); ++part) {
        if (parts_[part].regions.empty() || !layers_meet(particle.ball, scene_->parts[part])) continue;
        if (!scene_->parts[part].sensor) continue;
        if (inside(parts_[part].regions, view(particle, part), particle.radius, now_))
            particle.inside.push_back(part);
    }
}

/// Motion of a part from now on with the present controls.
template <class R>
void Simulation<R>::set_motion(PartIndex part) {
    Turning<R>& turning = parts_[part].turning;
    turning.angle = turning.angle_at(now_);
    turning.since = now_;
    turning.stop = infinity<R>();
    if (const auto* turn = std::get_if<motion::Turn>(&scene_->parts[part].motion)) {
        turning.rate = turn->always || rotating_ ? R(turn->rate) : R(0);
    } else {
        const auto& flip = std::get<motion::Flip>(scene_->parts[part].motion);
        const bool up = raised_[static_cast<int>(flip.side)];
        const auto& flipper = std::get<shape::Flipper>(scene_->parts[part].shape.is);
        turning.goal = up ? R(flip.raised - flipper.rest) : R(0);  // in double, as states have it
        const R speed(up ? flip.up_rate : flip.down_rate), way = turning.goal - turning.angle;
        turning.rate = way > 0 ? speed : way < 0 ? R(-speed) : R(0);
        if (turning.rate != 0) turning.stop = now_ + magnitude(way) / speed;
    }
    if (turning.rate == 0) {
        const V<R> turn = from_angle(turning.angle);
        for (FeatureIndex f = parts_[part].first; f < parts_[part].last; ++f)
            posed_[f] = posed(features_[f], turning.pivot, turn);
    }
    if (certificate_) note_motion(part);
}

template <class R>
void Simulation<R>::change_motions() {
    for (PartIndex part = 0; part < parts_.size(); ++part) {
        if (!parts_[part].moves) continue;
        const R rate = parts_[part].turning.rate;
        set_motion(part);
        if (parts_[part].turning.rate != rate) refresh_beside(part);
    }
}

template <class R>
R Simulation<R>::next_stop() const {
    R first = infinity<R>();
    for (const PartNow& part : parts_) first = std::min(first, part.turning.stop);
    return first;
}

/// Handles flippers that reach their stops now.
template <class R>
void Simulation<R>::handle_stops() {
    for (PartIndex part = 0; part < parts_.size(); ++part) {
        if (parts_[part].turning.stop > now_) continue;
        set_motion(part);
        refresh_beside(part);
    }
}

template <class R>
void Simulation<R>::apply(const Control& control) {
    if (const auto* flip = std::get_if<control::Flip>(&control)) {
        raised_[static_cast<int>(flip->side)] = flip->up;
        change_motions();
    } else if (const auto* rotate = std::get_if<control::Rotate>(&control)) {
        rotating_ = rotate->on;
        change_motions();
    } else if (const auto* nudge = std::get_if<control::Nudge>(&control)) {
        if (certificate_) note_input({}, nudge->velocity);
        while (!heaps_.empty()) end_heap(heaps_.begin()->first);
        for (Particle& particle : particles_) {
            if (particle.gone) continue;
            advance(particle);
            particle.body.velocity += V<R>(nudge->velocity);
            particle.given = true;
            particle.path.velocity = particle.body.velocity;
        }
        for (BallIndex i = 0; i < particles_.size(); ++i)
            if (!particles_[i].gone) start_path(i);
        for (BallIndex i = 0; i < particles_.size(); ++i)
            if (!particles_[i].gone) predict(i);
    } else if (const auto* raise = std::get_if<control::RaiseTargets>(&control)) {
        std::vector<char> is_raised(parts_.size(), raise->parts.empty() ? 1 : 0);
        for (const PartIndex part : raise->parts) is_raised[part] = 1;
        for (PartIndex part = 0; part < parts_.size(); ++part) {
            const bool was_down = is_raised[part] != 0 && std::exchange(parts_[part].down, false);
            if (certificate_ && was_down) note_target(part);
        }
        bool moved = false;
        for (BallIndex i = 0; i < particles_.size(); ++i) {
            if (particles_[i].gone) continue;
            advance(particles_[i]);
            if (!move_out_of_parts(i)) continue;
            moved = true;
            if (certificate_) note_moved(particles_[i]);
        }
        if (moved) settle_gates();
        refresh_all();
    }
}

template <class R>
void Simulation<R>::add(const Ball& ball) {
    join(ball);
    if (certificate_) note_input(ball.number, ball.velocity);
    const auto i = static_cast<BallIndex>(particles_.size() - 1);
    const bool is_largest = ball.radius > cells_.largest();
    if (is_largest) {
        rebuild_cells();
    } else {
        particles_[i].cell = cells_.at(ball.position);
        cells_.link(i, particles_[i].cell);
    }
    bool others_change = settle_gates() || is_largest;
    if (move_out_of_parts(i)) others_change |= settle_gates();
    if (others_change) return refresh_all();
    refresh(i);
    predict(i);
}

template <class R>
auto Simulation<R>::find(BallNumber number) const -> std::optional<BallIndex> {
    const auto number_of = [](const Particle& particle) { return particle.ball.number; };
    const auto at = std::ranges::lower_bound(particles_, number, {}, number_of);
    if (at == particles_.end() || at->ball.number != number || at->gone) return {};
    return static_cast<BallIndex>(at - particles_.begin());
}

template <class R>
void Simulation<R>::remove(BallNumber number) {
    const auto i = find(number);
    if (!i) return;
    Particle& particle = particles_[*i];
    cells_.unlink(*i, particle.cell);
    particle.gone = true;
    if (certificate_) certificate_->balls[number].gone = static_cast<double>(since_certificate_ + now_);
    ++particle.changes;
    ++particle.predictions;
    std::erase(reported_lost_, number);
    if (particle.heap != 0) test_heap_again(particle.heap);
    for (const PartIndex part : particle.inside)
        if (!scene_->parts[part].sensor && std::ranges::none_of(particles_, [&](const Particle& other) {
                return !other.gone && std::ranges::find(other.inside, part) != other.inside.end();
            }))
            parts_[part].open = false;
}

template <class R>
void Simulation<R>::set_velocity(BallNumber number, Vec2 velocity) {
    const auto i = find(number);
    if (!i) return;
    Particle& particle = particles_[*i];
    if (certificate_) note_input(number, velocity);
    std::vector<BallIndex> left;  // by a removed ball
    if (particle.heap != 0) left = end_heap(particle.heap);
    advance(particle);
    particle.body.velocity = V<R>(velocity);
    particle.given = true;
    start_path(*i);
    for (const BallIndex j : left)
        if (j != *i) restart_path(j);
    for (const BallIndex j : left) predict(j);
    predict(*i);
}

template <class R>
void Simulation<R>::begin(double seconds) {
    events_.clear();
    counts_ = {};
    run_start_ = now_;
    run_end_ = now_ + R(seconds);
    length_ = seconds;
    if (trace_) trace_paths();
}

template <class R>
bool Simulation<R>::run_until(std::chrono::steady_clock::time_point deadline) {
    if (length_ == 0) return true;
    for (;;) {
        while (!queue_.empty() &&
               queue_.front().prediction != particles_[queue_.front().particle].predictions) {
            std::pop_heap(queue_.begin(), queue_.end());
            queue_.pop_back();
        }
        const R event = queue_.empty() ? infinity<R>() : queue_.front().time, stop = next_stop();
        if (std::min(event, stop) > run_end_) break;
        if (stop <= event) {
            now_ = stop;
            handle_stops();
        } else {
            now_ = std::max(now_, event);
            const BallIndex particle = queue_.front().particle;
            std::pop_heap(queue_.begin(), queue_.end());
            queue_.pop_back();
            ++counts_.events;
            trace_ ? trace_event(particle) : handle(particle);
        }
        if (std::chrono::steady_clock::now() > deadline) return false;
    }
    now_ = run_end_;
    time_ += length_;
    length_ = 0;
    if (now_ >= 1) reset_time_origin();
    run_start_ = now_;  // of the next run, and of what is done before it
    return true;
}

/// Resets the origin of times once a second, so that times keep their digits.
template <class R>
void Simulation<R>::reset_time_origin() {
    for (Particle& particle : particles_) {
        particle.path.start -= now_;
        particle.until -= now_;
        particle.next_time -= now_;
        particle.series_since -= now_;
        particle.slow_contacts_since -= now_;
        particle.heap_searched_at -= now_;
        particle.no_equilibrium_since -= now_;
    }
    for (PartNow& part : parts_) {
        part.turning.since -= now_;
        part.turning.stop -= now_;
    }
    for (Entry& entry : queue_) entry.time -= now_;
    since_certificate_ += now_;
    std::make_heap(queue_.begin(), queue_.end());
    now_ = R(0);
}

template <class R>
bool Simulation<R>::ignores(PartIndex part, const Particle& particle) const {
    return parts_[part].down || !layers_meet(particle.ball, scene_->parts[part]) ||
           (!parts_[part].regions.empty() &&
            std::ranges::find(particle.inside, part) != particle.inside.end());
}

template <class R>
std::string Simulation<R>::at_time(const R& time) const {
    return " at " + std::to_string(clock(time)) + " s";
}

template class Simulation<double>;
template class Simulation<Real113>;
template class Simulation<Real226>;

std::unique_ptr<Exact> make_exact(int bits, std::shared_ptr<const Scene> scene) {
    if (bits <= 53) return std::make_unique<Simulation<double>>(std::move(scene));
    if (bits <= 113) return std::make_unique<Simulation<Real113>>(std::move(scene));
    return std::make_unique<Simulation<Real226>>(std::move(scene));
}

}  // namespace flipside::reference
