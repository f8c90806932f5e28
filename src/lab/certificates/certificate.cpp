#include "lab/certificates/certificate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/feature.hpp"
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

CertificateJson to_json(const reference::Feature<reference::Real113>& feature) {
    CertificateJson json = {{"part", feature.part}, {"type", "line"}, {"points", CertificateJson::array()},
                            {"radius", 0},          {"wide", false},  {"joined", {false, false}}};
    const auto add_point = [&](const auto& at) { json["points"].push_back(pair_of(narrow(at))); };
    if (const auto* line = std::get_if<reference::Line<reference::Real113>>(&feature.is)) {
        add_point(line->start);
        add_point(line->start + line->length * line->along);
        json["joined"] = {line->before.joined, line->past.joined};
        return json;
    }
    const auto& curve = std::get<reference::Curve<reference::Real113>>(feature.is);
    json["type"] = curve.is_circle ? "round" : "arc";
    json["radius"] = static_cast<double>(curve.radius);
    add_point(curve.center);
    if (curve.full) return json;
    add_point(curve.center + curve.radius * curve.from);
    add_point(curve.center + curve.radius * curve.to);
    json["wide"] = curve.wide;
    json["joined"] = {curve.before.joined, curve.past.joined};
    return json;
}

CertificateJson to_json(const Leg& leg) {
    constexpr const char* reasons[] = {"given", "goes on", "part", "ball"};
    const Beginning& begins = leg.begins;
    return {{"start", leg.start},
            {"why", reasons[static_cast<int>(begins.why)]},
            {"met", begins.other},
            {"met_leg", begins.other_leg},
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
            {"feature", force.feature},
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
    CertificateJson turns = CertificateJson::array();
    if (const auto motion = certificate.motions.find(index); motion != certificate.motions.end())
        for (const auto& span : motion->second)
            turns.push_back({{"since", span.since}, {"angle", span.angle}, {"rate", span.rate}});
    return {{"name", part.name},
            {"material", part.material},
            {"layer", part.layer},
            {"collides_with", part.collides_with},
            {"gate", pair_of(gate_of(part) != nullptr ? gate_of(part)->normal : Vec2{})},
            {"pivot", pair_of(pivot_of(part))},
            {"turns", std::move(turns)}};
}

/// When a part is not there: for one ball while a gate lets it through, for all while a target is down.
CertificateJson absences_json(const Certificate& certificate, double seconds) {
    CertificateJson absences = CertificateJson::array();
    const auto add = [&](PartIndex part, std::int64_t ball, double from, std::optional<double> until) {
        absences.push_back(
            {{"part", part}, {"ball", ball}, {"from", from}, {"until", until.value_or(seconds)}});
    };
    for (const auto& passage : certificate.passages)
        add(passage.gate, passage.ball, passage.from, passage.until);
    for (auto down = certificate.targets.begin(); down != certificate.targets.end(); ++down) {
        if (!down->down) continue;
        const auto up = std::find_if(down, certificate.targets.end(), [&](const auto& change) {
            return change.part == down->part && !change.down;
        });
        add(down->part, -1, down->time,
            up != certificate.targets.end() ? std::optional(up->time) : std::nullopt);
    }
    return absences;
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
    const auto rest_json = [&](const reference::Rest& rest) {
        return CertificateJson{
            {"from", rest.from},
            {"until", rest.until.value_or(certified.seconds)},
            {"forces", list_of(rest.forces, [](const auto& force) { return to_json(force); })}};
    };
    // JSON has no infinity.
    constexpr double far = std::numeric_limits<double>::max();
    const auto finite = [&](Vec2 v) { return Vec2{std::clamp(v.x, -far, far), std::clamp(v.y, -far, far)}; };
    return {{"format", "flipside-certificate/3"},
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
            {"features", list_of(reference::features_of<reference::Real113>(surface_of(scene), scene),
                                 [](const auto& feature) { return to_json(feature); })},
            {"inputs", list_of(certificate.inputs,
                               [](const reference::Input& input) {
                                   return CertificateJson{
                                       {"time", input.time},
                                       {"ball", input.ball ? std::int64_t{*input.ball} : -1},
                                       {"velocity", pair_of(input.velocity)}};
                               })},
            {"absences", absences_json(certificate, certified.seconds)},
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
