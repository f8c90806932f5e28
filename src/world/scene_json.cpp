#include "world/scene_json.hpp"

#include <numbers>

#include "world/json_file.hpp"

namespace flipside {

namespace {

double degrees(double radians) {
    return radians * (180 / std::numbers::pi);
}

Json scene_vector(Vec2 v) {
    return {v.x, v.y};
}

Json scene_points(const std::vector<Vec2>& points) {
    Json json = Json::array();
    for (const Vec2 point : points) json.push_back(scene_vector(point));
    return json;
}

Json scene_box(const Box& box) {
    return {{"min", scene_vector(box.min)}, {"max", scene_vector(box.max)}};
}

struct ShapeJson {
    Json operator()(const shape::Point& s) const { return {{"type", "point"}, {"at", scene_vector(s.at)}}; }
    Json operator()(const shape::Segment& s) const {
        return {{"type", "segment"}, {"a", scene_vector(s.a)}, {"b", scene_vector(s.b)}};
    }
    Json operator()(const shape::Arc& s) const {
        return {{"type", "arc"},
                {"center", scene_vector(s.center)},
                {"radius", s.radius},
                {"from_deg", degrees(s.from)},
                {"to_deg", degrees(s.to)}};
    }
    Json operator()(const shape::Circle& s) const {
        return {{"type", "circle"}, {"center", scene_vector(s.center)}, {"radius", s.radius}};
    }
    Json operator()(const shape::Polygon& s) const {
        return {{"type", "polygon"}, {"points", scene_points(s.points)}};
    }
    Json operator()(const shape::Capsule& s) const {
        return {
            {"type", "capsule"}, {"a", scene_vector(s.a)}, {"b", scene_vector(s.b)}, {"radius", s.radius}};
    }
    Json operator()(const shape::Flipper& s) const {
        return {{"type", "flipper"},          {"pivot", scene_vector(s.pivot)},
                {"length", s.length},         {"base_radius", s.base_radius},
                {"tip_radius", s.tip_radius}, {"rest_deg", degrees(s.rest)}};
    }
    Json operator()(const shape::Polyline& s) const {
        return {{"type", "polyline"}, {"points", scene_points(s.points)}, {"closed", s.closed}};
    }
    Json operator()(const shape::Gate& s) const {
        return {{"type", "gate"},
                {"a", scene_vector(s.a)},
                {"b", scene_vector(s.b)},
                {"normal", scene_vector(s.normal)}};
    }
    Json operator()(const shape::Compound& s) const {
        Json of = Json::array();
        for (const Shape& member : s.of) of.push_back(std::visit(*this, member.is));
        return {{"type", "compound"}, {"of", of}};
    }
};

class SceneWriter {
  public:
    explicit SceneWriter(const Scene& scene) : scene_(scene) {}

    [[nodiscard]] Json document() const {
        Json json{{"format", "flipside-scene/1"},
                  {"about", scene_.about},
                  {"bounds", scene_box(scene_.bounds)},
                  {"lost", scene_.keep_lost ? "keep" : "remove"},
                  {"gravity", scene_vector(scene_.gravity)},
                  {"damping", scene_.damping},
                  {"rest_speed", scene_.rest_speed},
                  {"balls", Json::array()},
                  {"parts", parts()}};
        if (!scene_.name.empty()) json["name"] = scene_.name;
        for (std::size_t i = 1; i < scene_.materials.size(); ++i) {
            const Material& material = scene_.materials[i];
            json["materials"][material.name] = {{"restitution", material.restitution},
                                                {"friction", material.friction},
                                                {"kick", material.kick}};
        }
        for (const Ball& ball : scene_.balls) {
            Json one = kind(ball);
            one["position"] = scene_vector(ball.position);
            one["velocity"] = scene_vector(ball.velocity);
            one["spin"] = ball.spin;
            json["balls"].push_back(std::move(one));
        }
        if (scene_.launcher) json["launcher"] = launcher(*scene_.launcher);
        if (scene_.rules) json["rules"] = rules(*scene_.rules);
        if (scene_.camera) json["camera"] = scene_box(*scene_.camera);
        for (const auto& [engine, settings] : scene_.recommend)
            for (const auto& [name, value] : settings)
                json["recommend"][engine][name] = recommended(engine, value);
        return json;
    }
    [[nodiscard]] Json table() const {
        return {{"bounds", scene_box(scene_.bounds)},
                {"lost", scene_.keep_lost},
                {"layers", scene_.layers},
                {"parts", parts()}};
    }

  private:
    /// The step is a number there.
    static Json recommended(const std::string& engine, const std::string& value) {
        return engine == "run" ? Json::parse(value) : Json(value);
    }
    template <class Thing>
    void add_common(Json& json, const Thing& thing) const {
        if (thing.material != 0) json["material"] = scene_.materials[thing.material].name;
        Json meets = Json::array();
        for (std::size_t i = 0; i < scene_.layers.size(); ++i) {
            const std::uint32_t bit = 1U << i;
            if (thing.layer == bit) json["layer"] = scene_.layers[i];
            if ((thing.collides_with & bit) != 0) meets.push_back(scene_.layers[i]);
        }
        if (thing.collides_with != ~0U) json["collides_with"] = std::move(meets);
    }
    [[nodiscard]] Json kind(const Ball& ball) const {
        Json json{{"radius", ball.radius}, {"mass", ball.mass}};
        add_common(json, ball);
        return json;
    }
    [[nodiscard]] Json parts() const {
        Json all = Json::array();
        for (const Part& part : scene_.parts) all.push_back(part_json(part));
        return all;
    }
    [[nodiscard]] Json part_json(const Part& part) const {
        Json json{{"name", part.name}, {"shape", std::visit(ShapeJson{}, part.shape.is)}};
        add_common(json, part);
        if (part.sensor) json["sensor"] = true;
        if (part.target) json["target"] = true;
        if (const auto* turn = std::get_if<motion::Turn>(&part.motion))
            json["motion"] = {{"type", "turn"},
                              {"pivot", scene_vector(turn->pivot)},
                              {"rate", turn->rate},
                              {"always", turn->always}};
        if (const auto* flip = std::get_if<motion::Flip>(&part.motion))
            json["motion"] = {{"type", "flip"},
                              {"side", flip->side == Side::left ? "left" : "right"},
                              {"raised_deg", degrees(flip->raised)},
                              {"up_rate", flip->up_rate},
                              {"down_rate", flip->down_rate}};
        return json;
    }
    [[nodiscard]] Json launcher(const Launcher& launcher) const {
        const double direction = degrees(math::atan2(launcher.direction.y, launcher.direction.x));
        return {{"position", scene_vector(launcher.position)},
                {"direction_deg", direction},
                {"speed", {launcher.slowest, launcher.fastest}},
                {"plunger", launcher.plunger},
                {"ball", kind(launcher.ball)}};
    }
    [[nodiscard]] Json part_names(const std::vector<PartIndex>& parts) const {
        Json names = Json::array();
        for (const PartIndex part : parts) names.push_back(scene_.parts[part].name);
        return names;
    }
    [[nodiscard]] Json groups(const std::vector<Rules::Group>& all) const {
        Json json = Json::array();
        for (const Rules::Group& group : all) {
            json.push_back({{"parts", part_names(group.parts)}, {"bonus", group.bonus}});
            if (group.shift) json.back()["shift"] = true;
        }
        return json;
    }
    [[nodiscard]] Json scores(const std::vector<Rules::Score>& all) const {
        Json json = Json::object();
        for (const Rules::Score& score : all) json[scene_.parts[score.part].name] = score.points;
        return json;
    }
    [[nodiscard]] Json rules(const Rules& rules) const {
        Json json{{"balls", rules.balls},
                  {"ball_save", rules.ball_save},
                  {"ball_search", rules.ball_search},
                  {"tilt", {{"nudges", rules.tilt_nudges}, {"seconds", rules.tilt_seconds}}},
                  {"score", scores(rules.scores)},
                  {"targets", groups(rules.targets)},
                  {"lanes", groups(rules.lanes)},
                  {"spinners", Json::array()}};
        for (const Rules::Spinner& spinner : rules.spinners)
            json["spinners"].push_back({{"part", scene_.parts[spinner.part].name},
                                        {"points", spinner.points},
                                        {"turns_per_speed", spinner.turns_per_speed}});
        if (const auto& shot = rules.skill_shot)
            json["skill_shot"] = {{"parts", part_names(shot->parts)}, {"bonus", shot->bonus}};
        if (const auto& multi = rules.multiball)
            json["multiball"] = {
                {"balls", multi->balls}, {"strength", multi->strength}, {"jackpot", multi->jackpot}};
        if (const auto& bonus = rules.end_bonus)
            json["end_bonus"] = {{"points", scores(bonus->scores)}, {"most_times", bonus->most_times}};
        return json;
    }

    const Scene& scene_;
};

}  // namespace

std::string to_json(const Scene& scene) {
    return json_text(SceneWriter(scene).document());
}

std::string table_text(const Scene& scene) {
    return json_text(SceneWriter(scene).table());
}

}  // namespace flipside
