#include "box2d/world.hpp"

#include <box2d/b2_circle_shape.h>

#include "box2d/misfit.hpp"
#include "box2d/shapes.hpp"
#include "world/scene_file.hpp"
#include "world/surface.hpp"

namespace flipside::box2d {

namespace {

/// Restored balls have their pointers in the state's file, without its name.
void require_all_fit(const std::vector<Ball>& balls, const Units& units) {
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (const auto found = misfit(balls[i], units))
            throw InputError("/balls/" + std::to_string(i) + '/' + found->key + ": " + found->problem);
}

Vec2 center(const Box& box) {
    return 0.5 * (box.min + box.max);
}

}  // namespace

Box2dWorld::Box2dWorld(std::shared_ptr<const Scene> scene, const Options& options)
    : options_(options),
      units_{center(scene->bounds), options.length_scale},
      table_(std::move(scene)),
      balls_(table_.scene().balls),
      rules_(table_, balls_, units_) {
    for (const Ball& ball : balls_)
        if (const auto found = misfit(ball, units_))
            throw ball_error(table_.scene(), ball.number, found->key, found->problem);
    for (PartIndex i = 0; i < table_.scene().parts.size(); ++i) {
        const Part& part = table_.scene().parts[i];
        if (Table::moves(part)) moving_.push_back(i);
        if (gate_of(part)) gates_.push_back(i);
    }
    build();
}

void Box2dWorld::build() {
    world_ = std::make_unique<b2World>(b2Vec2_zero);
    world_->SetContactListener(&rules_);
    world_->SetContactFilter(&rules_);
    world_->SetContinuousPhysics(options_.continuous);
    world_->SetWarmStarting(options_.warm_starting);
    world_->SetAllowSleeping(options_.sleep);
    parts_.clear();
    bodies_.clear();
    for (PartIndex i = 0; i < table_.scene().parts.size(); ++i) add_part(i);
    for (const Primitive& primitive : surface_of(table_.scene())) {
        const Part& part = table_.scene().parts[primitive.part];
        const Units frame{Table::moves(part) ? table_.pose(primitive.part).pivot : units_.origin,
                          units_.scale};
        add_primitive(*parts_[primitive.part], primitive, part.sensor, frame, options_.chord_error);
    }
    for (const Ball& ball : balls_) add_body(ball);
    find_pairs();
    // What touches already does not begin to do so in the next step.
    look();
    on_sensors_ = touching_.sensors;
    held_ = touching_.contacts;
    std::erase_if(held_, [&](const Contact& contact) { return comes_or_goes(contact); });
}

void Box2dWorld::add_part(PartIndex part) {
    b2BodyDef body;
    if (Table::moves(table_.scene().parts[part])) {
        body.type = b2_kinematicBody;
        body.position = units_.point(table_.pose(part).pivot);
        body.angle = static_cast<float>(table_.pose(part).angle);
    }
    body.enabled = !table_.parts()[part].down;
    parts_.push_back(world_->CreateBody(&body));
}

void Box2dWorld::add_body(const Ball& ball) {
    b2BodyDef body;
    body.type = b2_dynamicBody;
    body.position = units_.point(ball.position);
    body.angle = static_cast<float>(ball.angle);
    body.linearVelocity = units_.vector(ball.velocity);
    body.angularVelocity = static_cast<float>(ball.spin);
    body.bullet = options_.bullets;
    body.awake = !(ball.asleep && options_.sleep);
    body.userData.pointer = bodies_.size();
    bodies_.push_back(world_->CreateBody(&body));

    b2CircleShape circle;
    circle.m_radius = units_.distance(ball.radius);
    b2FixtureDef fixture;
    fixture.shape = &circle;
    fixture.userData.pointer = Tag{Other::ball(ball.number)}.packed();
    bodies_.back()->CreateFixture(&fixture);

    b2MassData mass;
    mass.mass = static_cast<float>(ball.mass);
    mass.center.SetZero();
    mass.I = static_cast<float>(inertia(ball) * units_.scale * units_.scale);
    bodies_.back()->SetMassData(&mass);

    for (const PartIndex gate : gates_)
        if (begins_in_gate(gate, ball)) rules_.open_gate(gate, *parts_[gate]);
}

/// Whether the ball, which joins, is on its way through the gate.
bool Box2dWorld::begins_in_gate(PartIndex gate, const Ball& ball) const {
    return layers_meet(ball, table_.scene().parts[gate]) && table_.is_deep_in(gate, table_.pose(gate), ball);
}

void Box2dWorld::find_pairs() {
    // Box2D does this at the start of its next step. Doing it here makes contacts() right until then,
    // and its outcome the same whether or not anybody asks for contacts().
    const_cast<b2ContactManager&>(world_->GetContactManager()).FindNewContacts();
    looked_ = false;
}

void Box2dWorld::look() const {
    if (!looked_) touching_.look(*world_, table_, balls_, units_, {});
    looked_ = true;
}

std::span<const Contact> Box2dWorld::contacts() const {
    look();
    return touching_.contacts;
}

std::size_t Box2dWorld::place_of(BallNumber number) const {
    const Ball* ball = find_ball(balls_, number);
    return ball == nullptr ? balls_.size() : static_cast<std::size_t>(ball - balls_.data());
}

BallNumber Box2dWorld::add(const Ball& ball) {
    if (const auto found = misfit(ball, units_))
        throw InputError("the " + std::string(found->key) + " of the new ball " + found->problem);
    balls_.push_back(table_.numbered(ball));
    add_body(balls_.back());
    find_pairs();
    return balls_.back().number;
}

bool Box2dWorld::remove(BallNumber number) {
    const std::size_t place = place_of(number);
    if (place == balls_.size()) return false;
    remove_at(place);
    find_pairs();
    return true;
}

void Box2dWorld::remove_at(std::size_t place) {
    world_->DestroyBody(bodies_[place]);
    balls_.erase(balls_.begin() + static_cast<std::ptrdiff_t>(place));
    bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(place));
    for (std::size_t i = place; i < bodies_.size(); ++i) bodies_[i]->GetUserData().pointer = i;
}

void Box2dWorld::apply(const Control& control) {
    table_.apply(control);
    if (const auto* nudge = std::get_if<control::Nudge>(&control))
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            balls_[i].velocity += nudge->velocity;
            balls_[i].asleep = false;
            bodies_[i]->SetAwake(true);
            bodies_[i]->SetLinearVelocity(units_.vector(balls_[i].velocity));
        }
    if (std::holds_alternative<control::RaiseTargets>(control))
        for (PartIndex i = 0; i < parts_.size(); ++i)
            if (table_.scene().parts[i].target) parts_[i]->SetEnabled(!table_.parts()[i].down);
    find_pairs();
}

void Box2dWorld::restore(const State& state) {
    require_all_fit(state.balls, units_);
    guard_.forget();
    table_.restore(state);
    balls_ = state.balls;
    events_.clear();
    build();
}

}  // namespace flipside::box2d
