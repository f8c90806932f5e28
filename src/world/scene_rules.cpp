#include "world/scene_reader.hpp"

// The launcher, and the rules of the game.

namespace flipside {

namespace {

int points(const Node& node, const char* key) {
    return static_cast<int>(node.integer(key));
}

using PartFlag = bool Part::*;

/// The parts of a group, of which each has `property`.
std::vector<PartIndex> read_parts(const Node& group, const SceneReader& reader, PartFlag property,
                                  const char* what) {
    std::vector<PartIndex> parts;
    for (const Node& name : group.each("parts")) {
        parts.push_back(reader.part(name, name.json().get<std::string>()));
        if (!(reader.scene().parts[parts.back()].*property))
            name.fail("this part is no " + std::string(what) + "; allowed are parts with \"" + what +
                      "\": true");
    }
    return parts;
}

std::vector<Rules::Group> read_groups(const Node& rules, const char* key, const SceneReader& reader,
                                      PartFlag property, const char* what) {
    std::vector<Rules::Group> groups;
    for (const Node& node : rules.each(key))
        groups.push_back(
            {read_parts(node, reader, property, what), points(node, "bonus"), node.toggle("shift")});
    return groups;
}

/// Points by the names of parts.
std::vector<Rules::Score> read_scores(const Node& scores, const SceneReader& reader) {
    std::vector<Rules::Score> all;
    for (const auto& entry : scores.json().items()) {
        const Node score = scores.at(entry.key());
        all.push_back({reader.part(score, entry.key()), static_cast<int>(score.json().get<double>())});
    }
    return all;
}

std::vector<Rules::Spinner> read_spinners(const Node& rules, const SceneReader& reader) {
    std::vector<Rules::Spinner> spinners;
    for (const Node& spinner : rules.each("spinners")) {
        const PartIndex part = reader.part(spinner.at("part"), spinner.text("part"));
        if (!reader.scene().parts[part].sensor)
            spinner.fail("part", "this part is no sensor; allowed are parts with \"sensor\": true");
        spinners.push_back({part, points(spinner, "points"), spinner.real("turns_per_speed")});
    }
    return spinners;
}

Rules::Multiball read_multiball(const Node& node, const Node& rules, const SceneReader& reader) {
    if (!reader.scene().launcher)
        node.fail("takes a launcher, from which the balls come; the scene has no \"launcher\"");
    if (!rules.has("targets") || rules.at("targets").size() == 0)
        node.fail("takes groups of targets, which start it; the rules have no \"targets\"");
    return {static_cast<int>(node.integer("balls")), node.real("strength"), points(node, "jackpot")};
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
    rules.ball_search = node.real("ball_search", rules.ball_search);
    if (node.has("score")) rules.scores = read_scores(node.at("score"), reader);
    rules.targets = read_groups(node, "targets", reader, &Part::target, "target");
    rules.lanes = read_groups(node, "lanes", reader, &Part::sensor, "sensor");
    rules.spinners = read_spinners(node, reader);
    if (node.has("skill_shot")) {
        const Node shot = node.at("skill_shot");
        rules.skill_shot = {read_parts(shot, reader, &Part::sensor, "sensor"), points(shot, "bonus")};
    }
    if (node.has("multiball")) rules.multiball = read_multiball(node.at("multiball"), node, reader);
    if (node.has("end_bonus")) {
        const Node bonus = node.at("end_bonus");
        rules.end_bonus = {read_scores(bonus.at("points"), reader),
                           static_cast<int>(bonus.integer("most_times"))};
    }
    return rules;
}

}  // namespace flipside
