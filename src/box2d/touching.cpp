#include "box2d/touching.hpp"

#include <algorithm>

#include <box2d/b2_time_of_impact.h>

#include "box2d/contact_rules.hpp"
#include "box2d/meeting.hpp"

namespace flipside::box2d {

namespace {

/// Whether a ball that flew straight from `from` to where it is now crossed the sensor on its way. Box2D
/// itself looks at sensors once per step, and a fast ball is over one between two looks.
bool crossed(const Meeting& meeting, b2Vec2 from) {
    const b2Body& body = *meeting.ball.GetBody();
    const b2Vec2 to = body.GetPosition();
    const float radius = meeting.ball.GetShape()->m_radius;
    if (b2DistanceSquared(from, to) < radius * radius) return false;
    b2TOIInput input;
    input.proxyA.Set(meeting.surface.GetShape(), 0);
    input.proxyB.Set(meeting.ball.GetShape(), 0);
    const b2Body& sensor = *meeting.surface.GetBody();
    input.sweepA.localCenter.SetZero();
    input.sweepA.c0 = input.sweepA.c = sensor.GetPosition();
    input.sweepA.a0 = input.sweepA.a = sensor.GetAngle();
    input.sweepB.localCenter.SetZero();
    input.sweepB.c0 = from;
    input.sweepB.c = to;
    input.sweepB.a0 = input.sweepB.a = body.GetAngle();
    input.sweepA.alpha0 = input.sweepB.alpha0 = 0;
    input.tMax = 1;
    b2TOIOutput output{};
    b2TimeOfImpact(&output, &input);
    return output.state == b2TOIOutput::e_touching;
}

Contact contact_of(const Meeting& meeting, const Touch& touch, const Units& units) {
    const Vec2 normal = unit({touch.normal.x, touch.normal.y});
    const double separation = units.distance(touch.separation);
    return {meeting.number, meeting.other, units.point(touch.point) - separation / 2 * normal, normal,
            separation};
}

}  // namespace

void Touching::look(b2World& world, const Table& table, const std::vector<Ball>& balls, const Units& units,
                    const std::vector<b2Vec2>& before) {
    contacts.clear();
    sensors.clear();
    passed.clear();
    at_gates.clear();
    pairs = 0;
    for (b2Contact* contact = world.GetContactList(); contact; contact = contact->GetNext()) {
        ++pairs;
        const Meeting meeting = Meeting::of(*contact);
        const PartIndex part = meeting.other.index;
        const auto touch = touch_of(*contact, meeting);
        if (meeting.sensor()) {
            const std::size_t place = meeting.ball.GetBody()->GetUserData().pointer;
            if (touch)
                sensors.push_back({meeting.number, part});
            else if (!before.empty() && crossed(meeting, before[place]))
                passed.push_back({meeting.number, part});
            continue;
        }
        if (!touch) continue;
        if (!meeting.other.is_ball && gate_of(table.scene().parts[part])) {
            b2Body& body = *meeting.ball.GetBody();
            at_gates.push_back({meeting.number, part});
            if (passes_gate(table, part, balls[body.GetUserData().pointer], units.point(body.GetPosition()),
                            units.vector(body.GetLinearVelocity())))
                continue;
        }
        contacts.push_back(contact_of(meeting, *touch, units));
    }
    sort_unique(sensors);
    sort_unique(passed);
    sort_unique(at_gates);
    keep_deepest(contacts);
}

}  // namespace flipside::box2d
