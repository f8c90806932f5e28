/// What a scene is made of, in Chipmunk's shapes.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "space.hpp"

namespace flipside_chipmunk {

namespace {

/// Chords over an angle of `sweep` so that none strays further than `error` from the arc: the sagitta of a
/// chord over d is R (1 - cos d/2).
int chord_count(double radius, double sweep, double error) {
    const double half = std::acos(1 - std::min(error, radius) / radius);
    return std::clamp(static_cast<int>(std::ceil(sweep / (2 * half))), 2, 4096);
}

cpVect on_circle(cpVect center, double radius, double angle) {
    return cpvadd(center, cpvmult(cpvforangle(angle), radius));
}

/// Gravity and drag by Chipmunk's own formula; the drag is of the way alone, not of the spin.
void update_velocity(cpBody* body, cpVect gravity, cpFloat damping, cpFloat dt) {
    const double spin = cpBodyGetAngularVelocity(body);
    cpBodyUpdateVelocity(body, gravity, damping, dt);
    cpBodySetAngularVelocity(body, spin);
}

}  // namespace

Space::Space(const flipside_scene& scene, const Options& options)
    : options_(options),
      rest_speed_(scene.rest_speed),
      space_(cpSpaceNew()),
      materials_(scene.materials, scene.materials + scene.material_count),
      now_(scene.time) {
    cpSpace* const space = space_.get();
    cpSpaceSetIterations(space, options.iterations);
    cpSpaceSetCollisionBias(space, options.bias);
    cpSpaceSetGravity(space, vec(scene.gravity));
    cpSpaceSetDamping(space, std::exp(-scene.damping));
    for (std::uint32_t i = 0; i < scene.part_count; ++i) {
        Part part{scene.parts[i], cpSpaceGetStaticBody(space), {}, false};
        part.open = (part.is.flags & FLIPSIDE_PART_OPEN) != 0;
        if ((part.is.flags & FLIPSIDE_PART_MOVES) != 0) {
            part.body = cpSpaceAddBody(space, cpBodyNewKinematic());
            cpBodySetPosition(part.body, vec(part.is.pivot));
            cpBodySetAngle(part.body, part.is.angle);
        }
        parts_.push_back(std::move(part));
    }
    for (std::uint32_t i = 0; i < scene.primitive_count; ++i) add_primitive(scene.primitives[i], scene);
    for (std::uint32_t i = 0; i < scene.ball_count; ++i) add_ball(scene.balls[i]);
    for (std::uint32_t i = 0; i < scene.blocked_count; ++i)
        blocked_[{scene.blocked[i].ball, false, scene.blocked[i].part}] = true;
    listen();
}

Space::~Space() {
    // Whoever is told of a separation now would look at what is half gone.
    cpCollisionHandler* const handler = cpSpaceAddDefaultCollisionHandler(space_.get());
    handler->separateFunc = [](cpArbiter*, cpSpace*, cpDataPointer) {};
    while (!balls_.empty()) remove_ball(balls_.begin()->first);
    for (Part& part : parts_) {
        for (cpShape* shape : part.shapes) {
            cpSpaceRemoveShape(space_.get(), shape);
            cpShapeFree(shape);
        }
        if (part.body == cpSpaceGetStaticBody(space_.get())) continue;
        cpSpaceRemoveBody(space_.get(), part.body);
        cpBodyFree(part.body);
    }
}

/// In the frame of the part's body.
cpVect Space::local(std::uint32_t part, flipside_vec p) const {
    const flipside_part& is = parts_[part].is;
    return (is.flags & FLIPSIDE_PART_MOVES) != 0 ? cpvsub(vec(p), vec(is.pivot)) : vec(p);
}

void Space::add_shape(std::uint32_t part, cpShape* shape) {
    Part& of = parts_[part];
    cpShapeSetUserData(shape, &tags_.emplace_back(Tag{false, part}));
    cpShapeSetFilter(shape, {0, of.is.layer, of.is.collides_with});
    cpShapeSetElasticity(shape, materials_[of.is.material].restitution);
    // Chipmunk multiplies; the root of each makes that the root of the product.
    cpShapeSetFriction(shape, std::sqrt(materials_[of.is.material].friction));
    cpShapeSetSensor(shape, (of.is.flags & FLIPSIDE_PART_SENSOR) != 0);
    of.shapes.push_back(cpSpaceAddShape(space_.get(), shape));
}

/// Between neighbours that come from `before` and go on to `after`: its ends meet nothing that these would.
void Space::add_segment(const flipside_primitive& primitive, cpVect before, cpVect a, cpVect b,
                        cpVect after) {
    cpShape* const shape = cpSegmentShapeNew(parts_[primitive.part].body, a, b, 0);
    cpSegmentShapeSetNeighbors(shape, before, after);
    add_shape(primitive.part, shape);
}

void Space::add_primitive(const flipside_primitive& primitive, const flipside_scene& scene) {
    cpBody* const body = parts_[primitive.part].body;
    const cpVect a = local(primitive.part, primitive.a), b = local(primitive.part, primitive.b);
    switch (primitive.kind) {
        case FLIPSIDE_POINT:
            return add_shape(primitive.part, cpCircleShapeNew(body, 0, a));
        case FLIPSIDE_CIRCLE:
            return add_shape(primitive.part, cpCircleShapeNew(body, primitive.radius_a, a));
        case FLIPSIDE_SEGMENT:
            return add_segment(primitive, cpvsub(a, cpvsub(b, a)), a, b, cpvadd(b, cpvsub(b, a)));
        case FLIPSIDE_ARC:
            return add_arc(primitive);
        case FLIPSIDE_TAPER:
            return add_taper(primitive);
        case FLIPSIDE_POLYGON: {
            std::vector<cpVect> corners;
            for (std::uint32_t i = 0; i < primitive.point_count; ++i)
                corners.push_back(local(primitive.part, scene.points[primitive.first_point + i]));
            return add_shape(primitive.part,
                             cpPolyShapeNewRaw(body, static_cast<int>(corners.size()), corners.data(), 0));
        }
        default:
            return;
    }
}

void Space::add_arc(const flipside_primitive& primitive) {
    const double sweep = primitive.to - primitive.from;
    const int count = chord_count(primitive.radius_a, sweep, options_.chord_error);
    const cpVect center = local(primitive.part, primitive.a);
    const auto corner = [&](int i) {
        return on_circle(center, primitive.radius_a, primitive.from + sweep * i / count);
    };
    // Beyond its ends an open arc goes on along its tangent, a full circle along its next chord.
    const bool closed = sweep >= 2 * std::numbers::pi;
    const double length = primitive.radius_a * sweep / count;
    const cpVect along_first = cpvmult(cpvperp(cpvforangle(primitive.from)), length);
    const cpVect along_last = cpvmult(cpvperp(cpvforangle(primitive.to)), length);
    const cpVect before = closed ? corner(-1) : cpvsub(corner(0), along_first);
    const cpVect after = closed ? corner(1) : cpvadd(corner(count), along_last);
    for (int i = 0; i < count; ++i)
        add_segment(primitive, i == 0 ? before : corner(i - 1), corner(i), corner(i + 1),
                    i + 1 == count ? after : corner(i + 2));
}

/// A capsule is a fat segment; where the ends differ, two discs and the four corners of their tangents.
void Space::add_taper(const flipside_primitive& primitive) {
    cpBody* const body = parts_[primitive.part].body;
    const cpVect a = local(primitive.part, primitive.a), b = local(primitive.part, primitive.b);
    if (primitive.radius_a == primitive.radius_b)
        return add_shape(primitive.part, cpSegmentShapeNew(body, a, b, primitive.radius_a));
    add_shape(primitive.part, cpCircleShapeNew(body, primitive.radius_a, a));
    add_shape(primitive.part, cpCircleShapeNew(body, primitive.radius_b, b));
    // The outward normal n of a tangent has n (b - a) = ra - rb.
    const cpVect axis = cpvnormalize(cpvsub(b, a));
    const double sine = (primitive.radius_a - primitive.radius_b) / cpvdist(a, b);
    const cpVect aside = cpvmult(cpvperp(axis), std::sqrt(1 - sine * sine));
    const cpVect left = cpvadd(cpvmult(axis, sine), aside), right = cpvsub(cpvmult(axis, sine), aside);
    const cpVect corners[] = {
        cpvadd(a, cpvmult(right, primitive.radius_a)), cpvadd(b, cpvmult(right, primitive.radius_b)),
        cpvadd(b, cpvmult(left, primitive.radius_b)), cpvadd(a, cpvmult(left, primitive.radius_a))};
    add_shape(primitive.part, cpPolyShapeNewRaw(body, 4, corners, 0));
}

void Space::add_ball(const flipside_ball& ball) {
    Body& added = balls_[ball.state.number];
    added.is = ball;
    added.body = cpSpaceAddBody(space_.get(),
                                cpBodyNew(ball.mass, cpMomentForCircle(ball.mass, 0, ball.radius, cpvzero)));
    added.shape = cpSpaceAddShape(space_.get(), cpCircleShapeNew(added.body, ball.radius, cpvzero));
    cpBodySetPosition(added.body, vec(ball.state.position));
    cpBodySetVelocity(added.body, vec(ball.state.velocity));
    cpBodySetAngle(added.body, ball.state.angle);
    cpBodySetAngularVelocity(added.body, ball.state.spin);
    cpBodySetVelocityUpdateFunc(added.body, update_velocity);
    cpShapeSetUserData(added.shape, &tags_.emplace_back(Tag{true, ball.state.number}));
    cpShapeSetFilter(added.shape, {0, ball.layer, ball.collides_with});
    cpShapeSetElasticity(added.shape, materials_[ball.material].restitution);
    cpShapeSetFriction(added.shape, std::sqrt(materials_[ball.material].friction));
    double smallest = ball.radius;
    for (const auto& [number, one] : balls_) smallest = std::min(smallest, one.is.radius);
    cpSpaceSetCollisionSlop(space_.get(), options_.slop * smallest);
}

void Space::remove_ball(std::uint32_t number) {
    const auto at = balls_.find(number);
    if (at == balls_.end()) return;
    cpSpaceRemoveShape(space_.get(), at->second.shape);
    cpSpaceRemoveBody(space_.get(), at->second.body);
    cpShapeFree(at->second.shape);
    cpBodyFree(at->second.body);
    balls_.erase(at);
    const auto is_its = [&](const Pair& pair) {
        return pair.ball == number || (pair.with_ball && pair.other == number);
    };
    std::erase_if(held_, is_its);
    std::erase_if(blocked_, [&](const auto& one) { return is_its(one.first); });
}

}  // namespace flipside_chipmunk
