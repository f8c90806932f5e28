#include "custom/continuous/gates.hpp"

#include <algorithm>
#include <cmath>

#include "custom/broad_phase/capacity.hpp"
#include "custom/geometry/narrow_phase.hpp"
#include "world/gate.hpp"

namespace flipside::custom {

namespace {

/// Radii: a ball has entered a sensor when it is this near. Rounding lies below it, so a ball that rolls
/// along the border of a sensor is inside; and balls that enter at one instant do so.
constexpr double enter_gap = 1e-12;
/// Radii: least distance that a ball moves between two evaluations of its distance from a sensor.
constexpr double sense_step = 1e-2;
/// Limit on these evaluations. A ball that rolls along the border of a sensor needs some hundred, one beside
/// a sensor that turns fast may need more than that; then it moves further between two of them.
constexpr double most_steps = 100'000;

/// m: how near a sensor the ball has entered it.
double entered_at(Vec2 center, double radius) {
    return std::max(enter_gap * radius, gap_rounding(center, radius));
}
/// m: how far outside a sensor or gate the ball has left it.
double left_at(Vec2 center, double radius) {
    return std::max(gate_clearance * radius, 4 * gap_rounding(center, radius));
}

}  // namespace

Gates::Gates(Simulation& sim) : sim_(sim), first_(sim.scene.parts.size(), sim.layout.size()) {
    for (PrimitiveIndex i = sim.layout.size(); i-- > 0;) first_[sim.layout.primitive(i).part] = i;
    near_.reserve(sim.layout.size());
}

void Gates::find_sensed(std::span<const Ball> balls) {
    list().clear();
    for (PartIndex part = 0; part < first_.size(); ++part) {
        if (!sim_.scene.parts[part].sensor) continue;
        for (const Ball& ball : balls)
            if (layers_meet(ball, sim_.scene.parts[part]) &&
                distance_to(part, ball.position, ball.radius, sim_.table.pose(part)) <=
                    entered_at(ball.position, ball.radius))
                set_inside(ball.number, part, true);
    }
}

bool Gates::inside(BallNumber ball, PartIndex part) const {
    return std::ranges::binary_search(list(), Sensed{ball, part});
}

bool Gates::any_inside(PartIndex part) const {
    return std::ranges::any_of(list(), [&](const Sensed& sensed) { return sensed.part == part; });
}

std::span<const Sensed> Gates::around(BallNumber ball) const {
    const auto first = std::ranges::lower_bound(list(), ball, {}, &Sensed::ball);
    return {first, std::ranges::upper_bound(first, list().end(), ball, {}, &Sensed::ball)};
}

double Gates::distance_to(PartIndex part, Vec2 center, double radius, const Pose& pose) const {
    double least = INFINITY;
    for (const Primitive& primitive : sim_.layout.primitives().subspan(first_[part])) {
        if (primitive.part != part) break;
        least = std::min(least, touch(center, radius, primitive, pose).separation);
    }
    return least;
}

void Gates::settle() {
    for (const PartIndex part : sim_.layout.gates()) {
        const Pose pose = sim_.turnings[part].pose(0);
        const Box around = bounds_of(sim_.layout.primitive(first_[part]), pose);  // a gate is one segment
        const auto is_near = [&](const Ball& ball) {
            const double out = left_at(ball.position, ball.radius);
            return overlap(around, bounds_of(ball.position, ball.radius + out)) &&
                   layers_meet(ball, sim_.scene.parts[part]) &&
                   distance_to(part, ball.position, ball.radius, pose) < out;
        };
        const auto passes = [&](const Ball& ball) {
            return inside(ball.number, part) || lets_through(part, ball, 0) ||
                   sim_.table.is_deep_in(part, pose, ball);
        };
        const bool open =
            std::ranges::any_of(sim_.balls, [&](const Ball& ball) { return is_near(ball) && passes(ball); });
        sim_.table.set_open(part, open);
        for (Ball& ball : sim_.balls) {
            const bool near = is_near(ball);
            const bool was_blocked = sim_.table.is_blocked(part, ball.number);
            set_inside(ball.number, part, open && near);
            sim_.table.set_blocked(part, ball.number, !open && near);
            if (open && was_blocked) ball.asleep = false;
        }
    }
}

bool Gates::lets_through(PartIndex part, const Ball& ball, double time) const {
    const Turning& turning = sim_.turnings[part];
    return sim_.table.lets_through(part, turning.pose(time), turning.rate_at(time), ball);
}

bool Gates::ignores(const Feature& feature, const Ball& ball) const {
    return feature.sensor || sim_.table.parts()[feature.part].down || !layers_meet(ball, feature) ||
           (feature.gate && inside(ball.number, feature.part));
}

std::span<const PrimitiveIndex> Gates::primitives_near(const Box& box, const Ball& ball) {
    near_.clear();
    for (const FeatureIndex f : sim_.features_near(box)) {
        const Feature& feature = sim_.features[f];
        const bool listed = !near_.empty() && near_.back() == feature.primitive;
        if (!listed && !ignores(feature, ball)) near_.push_back(feature.primitive);
    }
    return near_;
}

double Gates::sense_time(PartIndex part, const Ball& ball, const Path& path, double time, double last,
                         bool inside) const {
    const Turning& turning = sim_.turnings[part];
    const double own = path.max_speed(sim_.end), w = std::abs(turning.rate);
    const double out = left_at(ball.position, ball.radius), near = entered_at(ball.position, ball.radius);
    const auto distance_left = [&](double t) {
        const double distance = distance_to(part, path.position(t), ball.radius, turning.pose(t));
        return inside ? out - distance : distance - near;
    };
    const double far =
        w == 0 ? 0 : length(path.position(time) - turning.begin.pivot) + own * (sim_.end - time);
    const double speed = own + w * far;
    const double error = std::max(gap_rounding(ball.position, ball.radius) / speed, 4 * 0x1p-53 * sim_.end);
    double before = time, left_before = 0;
    const double least_step = std::max({sense_step * ball.radius / speed, (last - time) / most_steps, error});
    for (double t = time;; t = std::min(sim_.end, t + std::max(left_before / speed, least_step))) {
        const double left = distance_left(t);
        if (left <= 0) return first_zero(distance_left, before, left_before, t, left, error);
        before = t;
        left_before = left;
        if (t >= last) return never_touch;
    }
}

}  // namespace flipside::custom
