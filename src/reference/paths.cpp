#include <algorithm>
#include <utility>

#include "reference/simulation.hpp"
#include "world/refusal.hpp"

namespace flipside::reference {

namespace {

/// Radii: gaps below this are contact for a ball that does not move along the normal.
template <class R>
R contact_gap() {
    using std::sqrt;
    return sqrt(epsilon<R>()) / 16;
}
/// Factor from the rounding u of the ends of a straight face to the error of its direction.
template <class R>
R direction_scale(const Feature<R>& feature) {
    const auto* line = std::get_if<Line<R>>(&feature.is);
    return line == nullptr ? R(1) : R(1 + length(line->start) / line->length);
}
/// Speed of bounces that never end, in units of √(2·force·rounding): an impact found late by a gap of the
/// rounding gains in it the speed that the bounce loses. At least 1.
template <class R>
R unending(double restitution) {
    using std::sqrt;
    const R e(restitution), lost = 1 - e * e;
    return e < 1 && e * e > lost ? R(e / sqrt(lost)) : R(1);
}
/// Relative size of an acceleration that is rounding.
template <class R>
R no_force() {
    return 16384 * epsilon<R>();
}

}  // namespace

template <class R>
Closest<R> Simulation<R>::closest(FeatureIndex f, const V<R>& position, const R& radius) const {
    const Turning<R>* turns = turning(features_[f].part);
    if (turns == nullptr) return closest_point(posed_[f], position, radius);
    const V<R> turn = from_angle(turns->angle_at(now_));
    Closest<R> seen =
        closest_point(features_[f], turns->pivot + unrotated(position - turns->pivot, turn), radius);
    seen.normal = rotated(seen.normal, turn);
    return seen;
}

/// Whether a centre is inside a polygon or taper; outlines alone do not tell.
template <class R>
void Simulation<R>::refuse_inside(const Particle& particle) const {
    for (const Primitive& primitive : primitives_) {
        const bool solid = std::holds_alternative<primitive::Polygon>(primitive.is) ||
                           std::holds_alternative<primitive::Taper>(primitive.is);
        if (!solid || scene_->parts[primitive.part].sensor || ignores(primitive.part, particle)) continue;
        const auto regions = regions_of<R>({primitive}, primitive.part);
        if (!inside(regions, view(particle, primitive.part), R(particle.radius * epsilon<R>()), now_))
            continue;
        throw Refusal("reference: ball " + std::to_string(particle.ball.number) + " begins inside " +
                      scene_->parts[primitive.part].name + at_time(now_));
    }
}

/// Moves a ball out of the parts that it overlaps where it begins: in a state, by a launch, or where a target
/// is raised. Returns whether it was moved.
template <class R>
bool Simulation<R>::move_out_of_parts(BallIndex i) {
    refuse_inside(particles_[i]);
    if (!correct_overlap(i)) return false;
    refuse_inside(particles_[i]);  // moved out of one part, it may be inside another
    return true;
}

/// Moves a ball that starts inside a part, or across a line, out of it; corrects the deepest overlap first.
/// Returns whether it was moved. Throws Refusal where parts that face each other leave no room for it.
template <class R>
bool Simulation<R>::correct_overlap(BallIndex i) {
    Particle& particle = particles_[i];
    // Radii; smaller overlaps remain.
    const double deep = rests_on_ball(i) ? heap_overlap : 1e-3;
    constexpr int most_rounds = 1000;  // what meets at 6 degrees needs as many
    for (int round = 0; round < most_rounds; ++round) {
        Closest<R> deepest;
        deepest.gap = -deep * particle.radius;
        bool found = false;
        for (const FeatureIndex f : cells_.features(particle.cell)) {
            const PartIndex part = features_[f].part;
            if (ignores(part, particle) ||
                (gate_of(scene_->parts[part]) != nullptr && passes(part, particle)))
                continue;
            const Closest<R> seen = closest(f, particle.body.position, particle.radius);
            if (!seen.facing || !(seen.gap < deepest.gap)) continue;
            deepest = seen;
            found = true;
        }
        if (!found) return round > 0;
        particle.body.position -= deepest.gap * deepest.normal;
        particle.path.position = particle.body.position;
        enter_cell(i, cells_.at(narrow(particle.body.position)));
    }
    throw Refusal("reference: ball " + std::to_string(particle.ball.number) +
                  " begins where parts leave no room for it" + at_time(now_));
}

/// Finds the features that the ball touches without an approach speed.
template <class R>
void Simulation<R>::find_touching(Particle& particle) {
    using std::sqrt;
    touching_.clear();
    // In a wider type, what touches to the rounding of what was given still touches.
    const R given = particle.given && !std::is_same_v<R, double> ? R(64 * 0x1p-53) : R(0);
    const R snap =
        contact_gap<R>() * particle.radius + given * (length(particle.body.position) + particle.radius);
    for (const FeatureIndex f : cells_.features(particle.cell)) {
        const PartIndex part = features_[f].part;
        if (f == particle.left || ignores(part, particle)) continue;
        const Closest<R> seen = closest(f, particle.body.position, particle.radius);
        if (!seen.facing || seen.gap > snap) continue;
        const bool is_gate = gate_of(scene_->parts[part]) != nullptr;
        if (is_gate && passes(part, particle)) continue;
        const Mixed& material = mixed(particle.ball.material, scene_->parts[part].material);
        const R friction(material.friction);
        const RestingContact<R> contact =
            resting_contact_at(shape(f), turning(part), particle.body, now_, friction, external_, snap);
        // Impacts with parts that may move, and all impacts with drag, are searched for.
        const bool is_searched = parts_[part].moves || external_.drag > 0;
        const R rounding = is_searched ? gap_rounding(particle.body.position, particle.body.radius)
                                       : rounding_of(particle.body);
        const R lowest_bounce =
            unending<R>(material.restitution) * sqrt(2 * rounding * std::max(R(0), contact.force));
        const R speed = length(particle.body.velocity) + magnitude(contact.tangential_speed);
        const R turned = (16 * epsilon<R>() + given) * direction_scale(shape(f));
        if (magnitude(contact.separating_speed) > (4096 * epsilon<R>() + turned) * speed + lowest_bounce)
            continue;
        if (is_gate && std::ranges::find(particle.blocked, part) == particle.blocked.end())
            particle.blocked.push_back(part);
        touching_.push_back({f, contact, friction});
    }
}

/// Notes the straight static faces that the ball touches without a contact force.
template <class R>
void Simulation<R>::note_tangent_faces(Particle& particle) {
    for (const auto& [face, contact, friction] : touching_)
        if (contact.straight && contact.turning == nullptr &&
            particle.tangent_count < particle.tangent_faces.size())
            particle.tangent_faces[particle.tangent_count++] = {contact.pivot, contact.normal};
}

/// Chooses the path along one of the touching surfaces, if that surface keeps the ball off all others.
template <class R>
bool Simulation<R>::rest_on_one(Particle& particle) {
    for (const Touching& one : touching_) {
        const RestingContact<R>& contact = one.contact;
        const R scale = length(external_.gravity) + magnitude(contact.force) + magnitude(contact.tangential);
        const R none = no_force<R>() * scale;
        if (!(contact.force > none)) continue;
        const ContactFriction<R> rub = friction_of(contact, particle.body);
        const V<R> added = contact.force * contact.normal + rub.force * contact.tangent;
        const R slow = rounding_speed(length(particle.body.velocity));
        const bool keeps_off = std::ranges::all_of(touching_, [&](const Touching& other) {
            if (&other == &one) return true;
            const R cosine = dot(contact.normal, other.contact.normal);
            return dot(added, other.contact.normal) - other.contact.force >= -none &&
                   other.contact.separating_speed - contact.separating_speed * cosine >= -slow;
        });
        if (!keeps_off) continue;
        ConstrainedPath<R> found;
        try {
            found = constrain(contact, rub, particle.body, now_, R(now_ + 1), external_);
        } catch (const EndlessSearch&) {
            refuse_search("reference", particle.ball.number, Other::part(features_[one.feature].part),
                          clock(now_), *scene_);
        }
        particle.path = found.path;
        particle.until = found.until;
        particle.separates = found.separates;
        particle.support[0] = one.feature;
        particle.support_normal = contact.normal;
        if (contact.turning != nullptr)
            particle.support_normal = unrotated(contact.normal, from_angle(contact.turning->angle_at(now_)));
        return true;
    }
    return false;
}

/// Holds a ball still between two static surfaces. If it spins, the friction of both slows it, and normal
/// forces and friction together balance its weight. Each normal force is at least `least`, per mass.
template <class R>
bool Simulation<R>::rest_on_two(Particle& particle, const R& least) {
    const R scale = length(external_.gravity), none = no_force<R>() * scale;
    for (const Touching& a : touching_)
        for (const Touching& b : touching_) {
            if (&a == &b || a.contact.turning != nullptr || b.contact.turning != nullptr) continue;
            if (!(a.contact.force > none)) continue;
            const R& spin = particle.body.spin;
            const auto push = [&](const Touching& one) {
                const R sign(spin > 0 ? 1 : spin < 0 ? -1 : 0);
                return one.contact.normal + sign * one.friction * perp(one.contact.normal);
            };
            const V<R> u = push(a), v = push(b), weight = external_.gravity;
            const R across = cross(u, v);
            if (magnitude(across) < no_force<R>()) continue;
            const R first = -cross(weight, v) / across, second = -cross(u, weight) / across;
            if (first < least || second < least) continue;
            particle.path = {};
            particle.path.rests = true;
            particle.path.start = now_;
            particle.path.position = particle.body.position;
            particle.path.angle = particle.body.angle;
            particle.path.spin = spin;
            particle.support[0] = a.feature;
            particle.support[1] = b.feature;
            particle.support_force[0] = particle.mass * std::max(R(0), first);
            particle.support_force[1] = particle.mass * std::max(R(0), second);
            const R sense(spin > 0 ? 1 : spin < 0 ? -1 : 0);
            particle.support_friction[0] = sense * a.friction * particle.support_force[0];
            particle.support_friction[1] = sense * b.friction * particle.support_force[1];
            const R rubbed = 2 * (a.friction * first + b.friction * second) / particle.radius;
            if (spin != 0 && rubbed > 0) {
                particle.path.spin_rate = spin > 0 ? R(-rubbed) : rubbed;
                particle.until = now_ + magnitude(spin) / rubbed;
            }
            return true;
        }
    return false;
}

/// Finds the path of a ball from its position: in free flight, or along a surface.
template <class R>
void Simulation<R>::find_path(Particle& particle) {
    ++particle.changes;
    particle.support[0] = particle.support[1] = nothing;
    particle.tangent_count = 0;
    particle.until = infinity<R>();
    particle.separates = false;
    Path<R>& path = particle.path;
    path.start = now_;
    path.position = particle.body.position;
    path.velocity = particle.body.velocity;
    path.acceleration = external_.gravity;
    path.drag = external_.drag;
    path.angle = particle.body.angle;
    path.spin = particle.body.spin;
    path.spin_rate = R(0);
    path.roll = {};
    path.is_series = path.rests = false;
    find_touching(particle);
    particle.left = nothing;
    particle.given = false;
    const R scale = length(external_.gravity);
    const auto is_pressed = [&] {
        return std::ranges::any_of(touching_, [&](const Touching& one) {
            const RestingContact<R>& contact = one.contact;
            return contact.force >
                   no_force<R>() * (scale + magnitude(contact.force) + magnitude(contact.tangential));
        });
    };
    if (!is_pressed()) return note_tangent_faces(particle);
    using std::sqrt;
    const R speed = length(particle.body.velocity);
    // Between two surfaces, bounces lower than the rounding of its position (see find_touching) are rest.
    const R lowest_bounce = 4 * sqrt(2 * rounding_of(particle.body) * scale), none = no_force<R>() * scale;
    // If both press it, so is spin, before friction against it lifts the ball off one, again without end.
    if (speed <= lowest_bounce && particle.radius * magnitude(particle.body.spin) <= lowest_bounce) {
        const R spin = std::exchange(particle.body.spin, R(0));
        if (rest_on_two(particle, none)) return;
        particle.body.spin = spin;
    }
    if (rest_on_one(particle)) return;
    if (speed <= lowest_bounce && rest_on_two(particle, R(-none))) return;
    // A surface from which the ball separates does not support it.
    const auto recedes = [&](const Touching& one) {
        return one.contact.separating_speed > rounding_speed(speed);
    };
    if (std::erase_if(touching_, recedes) > 0) {
        if (!is_pressed()) return note_tangent_faces(particle);
        if (rest_on_one(particle)) return;
    }
    const R slow = 65536 * sqrt(epsilon<R>() * particle.radius * scale);
    if (speed <= slow && rest_on_two(particle, R(-none))) return;
    std::string names;
    for (const Touching& one : touching_)
        names += (names.empty() ? "" : " and ") + scene_->parts[features_[one.feature].part].name;
    throw Refusal("reference: ball " + std::to_string(particle.ball.number) + " is held between " + names +
                  at_time(now_) + ", and not at rest: no closed motion for that");
}

/// Starts a path from the present position, or puts the ball to rest in a heap.
template <class R>
void Simulation<R>::start_path(BallIndex i) {
    if (particles_[i].heap != 0 || find_heap(i)) return;
    const bool given = particles_[i].given;
    find_path(particles_[i]);
    if (certificate_) note_leg(particles_[i], given);
}

#define FLIPSIDE_PATHS(R)                                      \
    template void Simulation<R>::start_path(BallIndex);        \
    template bool Simulation<R>::move_out_of_parts(BallIndex); \
    template Closest<R> Simulation<R>::closest(FeatureIndex, const V<R>&, const R&) const;
FLIPSIDE_PATHS(double)
FLIPSIDE_PATHS(Real113)
FLIPSIDE_PATHS(Real226)
#undef FLIPSIDE_PATHS

}  // namespace flipside::reference
