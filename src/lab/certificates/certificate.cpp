#include "lab/certificates/certificate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/world.hpp"
#include "world/json_file.hpp"
#include "world/refusal.hpp"
#include "world/surface.hpp"
#include "world/table.hpp"

namespace flipside::lab {

namespace {

using reference::Beginning;
using reference::Certificate;
using reference::CertifiedBall;
using reference::Leg;
using CertificateJson = nlohmann::ordered_json;

CertificateJson pair_of(Vec2 v) {
    return CertificateJson::array({v.x, v.y});
}
template <class Things, class Write>
CertificateJson list_of(const Things& things, Write write) {
    CertificateJson list = CertificateJson::array();
    for (const auto& thing : things) list.push_back(write(thing));
    return list;
}

CertificateJson primitive_json(const char* type, const std::vector<Vec2>& points,
                               std::vector<double> radii = {}, std::vector<double> angles = {}) {
    return {{"type", type},
            {"points", list_of(points, pair_of)},
            {"radii", std::move(radii)},
            {"angles", std::move(angles)}};
}
struct PrimitiveJson {
    CertificateJson operator()(const primitive::Point& p) const { return primitive_json("point", {p.at}); }
    CertificateJson operator()(const primitive::Segment& s) const {
        return primitive_json("segment", {s.a, s.b});
    }
    CertificateJson operator()(const primitive::Arc& a) const {
        return primitive_json("arc", {a.center}, {a.radius}, {a.from, a.to});
    }
    CertificateJson operator()(const primitive::Circle& c) const {
        return primitive_json("circle", {c.center}, {c.radius});
    }
    CertificateJson operator()(const primitive::Polygon& p) const {
        return primitive_json("polygon", p.points);
    }
    CertificateJson operator()(const primitive::Taper& t) const {
        return primitive_json("taper", {t.a, t.b}, {t.radius_a, t.radius_b});
    }
};

CertificateJson to_json(const Primitive& primitive) {
    CertificateJson json = std::visit(PrimitiveJson{}, primitive.is);
    json["part"] = primitive.part;
    return json;
}

CertificateJson to_json(const Leg& leg) {
    constexpr const char* reasons[] = {"given", "goes on", "part", "ball"};
    const Beginning& begins = leg.begins;
    return {{"start", leg.start},
            {"why", reasons[static_cast<int>(begins.why)]},
            {"met", begins.met},
            {"within", begins.within.value_or(-1)},
            {"normal", pair_of(begins.normal)},
            {"velocity_before", pair_of(begins.velocity_before)},
            {"spin_before", begins.spin_before},
            {"position", pair_of(leg.position)},
            {"velocity", pair_of(leg.velocity)},
            {"acceleration", pair_of(leg.acceleration)},
            {"drag", leg.drag},
            {"spin", leg.spin},
            {"roll", pair_of(leg.roll)},
            {"displacements", list_of(leg.displacements, pair_of)},
            {"spins", leg.spins},
            {"held", leg.held ? std::int64_t{*leg.held} : -1}};
}

CertificateJson to_json(const CertifiedBall& certified) {
    const Ball& ball = certified.ball;
    return {{"number", ball.number},
            {"radius", ball.radius},
            {"mass", ball.mass},
            {"material", ball.material},
            {"layer", ball.layer},
            {"collides_with", ball.collides_with},
            {"gone", certified.gone ? CertificateJson::array({*certified.gone}) : CertificateJson::array()},
            {"legs", list_of(certified.legs, [](const Leg& leg) { return to_json(leg); })}};
}

CertificateJson to_json(const reference::RestingForce& force) {
    return {{"ball", force.ball},
            {"other", force.other ? std::int64_t{*force.other} : -1},
            {"primitive", force.primitive},
            {"normal", force.normal},
            {"friction", force.friction}};
}

Vec2 pivot_of(const Part& part) {
    if (const auto* turn = std::get_if<motion::Turn>(&part.motion)) return turn->pivot;
    if (const auto* flipper = std::get_if<shape::Flipper>(&part.shape.is)) return flipper->pivot;
    return {};
}

CertificateJson part_json(const Scene& scene, PartIndex index, const Certificate& certificate) {
    const Part& part = scene.parts[index];
    CertificateJson turns = CertificateJson::array(), changes = CertificateJson::array();
    if (const auto motion = certificate.motions.find(index); motion != certificate.motions.end())
        for (const auto& span : motion->second)
            turns.push_back({{"since", span.since}, {"angle", span.angle}, {"rate", span.rate}});
    for (const auto& change : certificate.targets)
        if (change.part == index) changes.push_back({{"time", change.time}, {"down", change.down}});
    return {{"name", part.name},
            {"material", part.material},
            {"layer", part.layer},
            {"collides_with", part.collides_with},
            {"sensor", part.sensor},
            {"gate", pair_of(gate_of(part) != nullptr ? gate_of(part)->normal : Vec2{})},
            {"pivot", pair_of(pivot_of(part))},
            {"turns", std::move(turns)},
            {"target", std::move(changes)}};
}

/// Only what happened up to then.
void cut(Certificate& certificate, double seconds) {
    const auto later = [&](const auto& one) { return one.start > seconds; };
    for (auto& [number, certified] : certificate.balls) {
        std::erase_if(certified.legs, later);
        if (certified.gone > seconds) certified.gone.reset();
    }
    std::erase_if(certificate.balls, [](const auto& entry) { return entry.second.legs.empty(); });
    for (auto& [part, spans] : certificate.motions)
        std::erase_if(spans, [&](const auto& span) { return span.since > seconds; });
    std::erase_if(certificate.passages, [&](const auto& passage) { return passage.from > seconds; });
    for (auto& passage : certificate.passages)
        if (passage.until > seconds) passage.until.reset();
    std::erase_if(certificate.rests, [&](const auto& rest) { return rest.from > seconds; });
    for (auto& rest : certificate.rests)
        if (rest.until > seconds) rest.until.reset();
    std::erase_if(certificate.inputs, [&](const auto& input) { return input.time > seconds; });
    std::erase_if(certificate.targets, [&](const auto& change) { return change.time > seconds; });
}

CertificateJson whole(const Session& session, const Certificate& certificate, const Certified& certified,
                      double start) {
    const Scene& scene = session.scene();
    CertificateJson parts = CertificateJson::array();
    for (PartIndex i = 0; i < scene.parts.size(); ++i) parts.push_back(part_json(scene, i, certificate));
    const auto passage_json = [&](const reference::Passage& passage) {
        return CertificateJson{{"ball", passage.ball},
                               {"gate", passage.gate},
                               {"from", passage.from},
                               {"until", passage.until.value_or(certified.seconds)}};
    };
    const auto rest_json = [&](const reference::Rest& rest) {
        return CertificateJson{
            {"from", rest.from},
            {"until", rest.until.value_or(certified.seconds)},
            {"forces", list_of(rest.forces, [](const auto& force) { return to_json(force); })}};
    };
    // JSON has no infinity.
    constexpr double far = std::numeric_limits<double>::max();
    const auto finite = [&](Vec2 v) { return Vec2{std::clamp(v.x, -far, far), std::clamp(v.y, -far, far)}; };
    return {{"format", "flipside-certificate/2"},
            {"scene", scene.name},
            {"precision", std::stoi(session.settings().text("precision"))},
            {"start", start},
            {"seconds", certified.seconds},
            {"ends", certified.ends},
            {"gravity", pair_of(scene.gravity)},
            {"damping", scene.damping},
            {"rest_speed", scene.rest_speed},
            {"least", pair_of(finite(scene.bounds.min))},
            {"most", pair_of(finite(scene.bounds.max))},
            {"materials", list_of(scene.materials,
                                  [](const Material& m) {
                                      return CertificateJson{{"restitution", m.restitution},
                                                             {"friction", m.friction},
                                                             {"kick", m.kick}};
                                  })},
            {"parts", std::move(parts)},
            {"primitives",
             list_of(surface_of(scene), [](const Primitive& primitive) { return to_json(primitive); })},
            {"inputs", list_of(certificate.inputs,
                               [](const reference::Input& input) {
                                   return CertificateJson{
                                       {"time", input.time},
                                       {"ball", input.ball ? std::int64_t{*input.ball} : -1},
                                       {"velocity", pair_of(input.velocity)}};
                               })},
            {"passages", list_of(certificate.passages, passage_json)},
            {"rests", list_of(certificate.rests, rest_json)},
            {"balls", list_of(certificate.balls, [](const auto& entry) { return to_json(entry.second); })}};
}

}  // namespace

Certified certify(Session& session, const Timeline& timeline, const Script& script) {
    auto& world = dynamic_cast<reference::ReferenceWorld&>(session.world());
    Certificate certificate;
    Certified certified;
    const double start = world.time();
    world.certify(&certificate);
    std::size_t next = next_control(script, start);
    try {
        for (std::uint64_t k = 0; k < timeline.steps() && certified.ends.empty(); ++k) {
            session.step(timeline.length(k), script, next);
            const auto unclaimed = [](double uncertainty) { return std::isinf(uncertainty); };
            if (std::ranges::any_of(world.uncertainty(), unclaimed))
                certified.ends = "the horizon: the twin of more digits is a radius away";
            else
                certified.seconds = world.time() - start;
        }
    } catch (const Refusal& refusal) {
        if (certified.seconds == 0) throw;
        certified.ends = refusal.what();
    }
    world.certify(nullptr);
    cut(certificate, certified.seconds);
    certified.json = json_text(whole(session, certificate, certified, start)) + "\n";
    return certified;
}

}  // namespace flipside::lab
