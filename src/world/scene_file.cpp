#include "world/scene_file.hpp"

#include <algorithm>

#include "world/crowding.hpp"
#include "world/scene_reader.hpp"
#include "world/schema.hpp"

namespace flipside {

namespace {

bool is_field(const Json& generator) {
    return generator["type"] == "field";
}

/// Given, or made by a generated field.
Box read_bounds(const Node& root) {
    std::vector<Node> fields = root.each("generate");
    std::erase_if(fields, [](const Node& node) { return !is_field(node.json()); });
    if (fields.size() > 1) fields[1].fail("a second field; allowed is one");
    if (fields.empty() && !root.has("bounds"))
        root.fail("the key \"bounds\" is missing; only a scene with a generated field may leave it out");
    if (fields.empty()) return read_box(root.at("bounds"));
    if (root.has("bounds"))
        root.fail("bounds", "a generated field sets the bounds; allowed is to leave this out");
    return field_bounds(fields[0]);
}

void read_balls(const Node& root, SceneReader& reader) {
    for (const Node& node : root.each("balls")) {
        Ball ball = reader.ball_kind(node);
        ball.position = node.vector("position");
        ball.velocity = node.vector("velocity");
        ball.spin = node.real("spin", 0);
        reader.add_ball(node, ball);
    }
}

void read_parts(const Node& root, SceneReader& reader) {
    for (const Node& node : root.each("parts")) {
        Part part;
        part.name = node.text("name");
        part.material = reader.material(node);
        part.shape = read_shape(node.at("shape"));
        part.motion = read_motion(node, part.shape);
        part.sensor = node.toggle("sensor");
        part.target = node.toggle("target");
        reader.read_layers(node, part);
        if (part.sensor && part.target)
            node.fail("target", "a sensor is never hit, so it cannot be a target; allowed is one of both");
        const bool gate = std::holds_alternative<shape::Gate>(part.shape.is);
        if (gate && (part.sensor || part.target || node.has("motion")))
            node.fail("a gate cannot be a sensor or a target, nor move; allowed is a gate alone");
        reader.add_part(node, std::move(part));
    }
}

/// Refuses a scene whose step would take too much time and memory: 3,000 balls at one position have
/// 4.5 million overlapping pairs. Heaps have three for each ball, and thousands of balls on a table of
/// sensors, arcs and long lines some ten.
void refuse_crowds(const Node& root, const Scene& scene) {
    constexpr std::uint64_t always = 250'000, for_each = 64;
    std::vector<Boxed> things;
    for (const Ball& ball : scene.balls) {
        const Vec2 reach{ball.radius, ball.radius};
        things.push_back(
            {{ball.position - reach, ball.position + reach}, true, ball.layer, ball.collides_with});
    }
    std::vector<PartIndex> part_of;
    std::vector<Box> boxes;
    for (PartIndex i = 0; i < scene.parts.size(); ++i) {
        const Part& part = scene.parts[i];
        boxes.clear();
        append_boxes(part.shape, boxes);
        for (const Box& box : boxes) things.push_back({box, false, part.layer, part.collides_with});
        part_of.insert(part_of.end(), boxes.size(), i);
    }
    const std::uint64_t most = always + for_each * things.size();
    const auto at = crowded_at(things, most);
    if (!at) return;
    const std::size_t balls = scene.balls.size();
    root.fail("too much lies over one another, as where " +
              (*at < balls ? "ball " + std::to_string(*at)
                           : "part " + in_quotes(scene.parts[part_of[*at - balls]].name)) +
              " is; allowed are " + std::to_string(most) +
              " overlapping pairs of boxes, of balls and of the lines, arcs and solids of parts");
}

/// A setting's value as on the command line.
std::string setting_text(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
    return value.dump();
}

Scene read_scene(const Node& root) {
    check_form(root, scene_schema);
    Scene scene;
    scene.document = std::make_shared<const std::string>(json_text(root.json()));
    scene.place = root.file() + ": " + root.pointer();
    SceneReader reader(scene);
    scene.name = root.text("name");
    scene.about = root.text("about");
    scene.bounds = read_bounds(root);
    scene.keep_lost = root.text("lost", "remove") == "keep";
    scene.gravity = root.vector("gravity");
    scene.damping = root.real("damping", 0);
    scene.rest_speed = root.real("rest_speed", scene.rest_speed);
    if (root.has("materials"))
        for (const auto& entry : root.at("materials").json().items())
            reader.add_material(entry.key(), root.at("materials").at(entry.key()));
    read_balls(root, reader);
    read_parts(root, reader);
    for (const Node& generator : root.each("generate")) generate(generator, reader);
    refuse_crowds(root, scene);
    if (root.has("launcher")) scene.launcher = read_launcher(root.at("launcher"), reader);
    if (root.has("rules")) scene.rules = read_rules(root.at("rules"), reader);
    if (root.has("camera")) scene.camera = read_box(root.at("camera"));
    if (root.has("recommend")) {
        const Node recommend = root.at("recommend");
        for (const auto& engine : recommend.json().items())
            for (const auto& setting : engine.value().items())
                scene.recommend[engine.key()][setting.key()] = setting_text(setting.value());
    }
    return scene;
}

}  // namespace

Box read_box(const Node& node) {
    const Box box{node.vector("min"), node.vector("max")};
    if (!(box.min.x < box.max.x && box.min.y < box.max.y))
        node.fail("min is not below max; allowed: min less than max in x and in y");
    return box;
}

InputError ball_error(const Scene& scene, BallNumber ball, const std::string& key,
                      const std::string& problem) {
    const std::string number = std::to_string(ball);
    const Json document = scene.document ? Json::parse(*scene.document) : Json::object();
    if (ball < document.value("balls", Json::array()).size())
        return InputError(scene.place + "/balls/" + number + '/' + key + ": " + problem);
    const std::string generated = scene.document ? scene.place + "/generate: " : "";
    return InputError(generated + "the " + key + " of ball " + number + ' ' + problem);
}

Scene parse_scene(std::string_view text, const std::string& file) {
    const Json document = parse_json(text, file);
    return read_scene(Node(document, file));
}

Scene parse_scene(const Node& node) {
    return read_scene(node);
}

Scene load_scene(const std::filesystem::path& file) {
    return parse_scene(read_file(file), file.string());
}

Scene load_scene(const std::filesystem::path& file, int count) {
    const std::string name = file.string();
    Json document = parse_json(read_file(file), name);
    check_form(document, scene_schema, name);
    Json generators = document.value("generate", Json::array());
    const auto field = std::ranges::find_if(generators, is_field);
    if (field == generators.end())
        throw InputError(name, "/generate", "no field is generated here whose balls could be counted anew");
    (*field)["balls"] = count;
    document["generate"] = generators;
    return read_scene(Node(document, name));
}

}  // namespace flipside
