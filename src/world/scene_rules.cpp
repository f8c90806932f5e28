#include "world/scene_reader.hpp"

// The launcher, and the rules of the game.

namespace flipside {

namespace {

int points(const Node& node, const char* key) {
    return static_cast<int>(node.integer(key));
}

using PartFlag = bool Part::*;

/// Groups of parts of which each has `property`.
std::vector<Rules::Group> read_groups(const Node& rules, const char* key, const SceneReader& reader,
                                      PartFlag property, const char* what) {
    std::vector<Rules::Group> groups;
    for (const Node& node : rules.each(key)) {
        Rules::Group group{{}, points(node, "bonus")};
        for (const Node& name : node.each("parts")) {
            group.parts.push_back(reader.part(name, name.json().get<std::string>()));
            if (!(reader.scene().parts[group.parts.back()].*property))
                name.fail("this part is no " + std::string(what) + "; allowed are parts with \"" + what +
                          "\": true");
        }
        groups.push_back(std::move(group));
    }
    return groups;
}

}  // namespace

Launcher read_launcher(const Node& node, SceneReader& reader) {
    Launcher launcher;
    launcher.position = node.vector("position");
    launcher.direction = from_angle(node.radians("direction_deg"));
    const Vec2 speed = node.vector("speed");
    launcher.slowest = speed.x;
    launcher.fastest = speed.y;
    launcher.plunger = node.toggle("plunger");
    launcher.ball = reader.ball_kind(node.at("ball"));
    if (launcher.slowest > launcher.fastest)
        node.fail("speed", "the slowest is above the fastest; allowed: [slowest, fastest]");
    if (!reader.scene().bounds.contains(launcher.position))
        node.fail("position", "lies outside the bounds; allowed are places inside");
    return launcher;
}

Rules read_rules(const Node& node, const SceneReader& reader) {
    Rules rules;
    rules.balls = static_cast<int>(node.integer("balls", rules.balls));
    rules.ball_save = node.real("ball_save", rules.ball_save);
    if (node.has("tilt")) {
        rules.tilt_nudges = static_cast<int>(node.at("tilt").integer("nudges"));
        rules.tilt_seconds = node.at("tilt").real("seconds");
    }
    if (node.has("score"))
        for (const auto& entry : node.at("score").json().items()) {
            const Node score = node.at("score").at(entry.key());
            rules.scores.push_back(
                {reader.part(score, entry.key()), static_cast<int>(score.json().get<double>())});
        }
    rules.targets = read_groups(node, "targets", reader, &Part::target, "target");
    rules.lanes = read_groups(node, "lanes", reader, &Part::sensor, "sensor");
    for (const Node& spinner : node.each("spinners")) {
        const PartIndex part = reader.part(spinner.at("part"), spinner.text("part"));
        if (!reader.scene().parts[part].sensor)
            spinner.fail("part", "this part is no sensor; allowed are parts with \"sensor\": true");
        rules.spinners.push_back({part, points(spinner, "points"), spinner.real("turns_per_speed")});
    }
    return rules;
}

}  // namespace flipside
