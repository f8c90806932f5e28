#include <algorithm>

#include <nlohmann/json.hpp>

#include "lab/sweep/windows.hpp"
#include "world/input_error.hpp"
#include "world/schema.hpp"
#include "world/state_file.hpp"

namespace flipside::lab::sweep {

namespace {

constexpr const char* windows_format = "flipside-windows/2";

constexpr std::string_view windows_schema = R"({
  "type": "object",
  "additionalProperties": false,
  "required": ["format", "scene", "trajectories", "skipped", "windows"],
  "properties": {
    "format": {"const": "flipside-windows/2"},
    "scene": {"type": "string"},
    "trajectories": {"type": "integer", "minimum": 0, "maximum": 1000000},
    "skipped": {"type": "object",
                "additionalProperties": {"type": "integer", "minimum": 0, "maximum": 1000000000}},
    "windows": {"type": "array", "maxItems": 100000, "items": {
      "type": "object",
      "additionalProperties": false,
      "required": ["start", "seconds", "ends", "impacts"],
      "properties": {
        "start": {"type": "object"},
        "seconds": {"type": "number"},
        "ends": {"type": "array", "maxItems": 1000000, "items": {
          "type": "object",
          "additionalProperties": false,
          "required": ["ball", "position", "radius", "uncertainty", "hit"],
          "properties": {
            "ball": {"type": "integer", "minimum": 0, "maximum": 4294967295},
            "position": {"type": "array", "minItems": 2, "maxItems": 2, "items": {"type": "number"}},
            "radius": {"type": "number"},
            "uncertainty": {"type": "number", "minimum": 0},
            "hit": {"type": "boolean"}
          }}},
        "impacts": {"type": "array", "minItems": 1, "maxItems": 10000000, "items": {
          "type": "object",
          "additionalProperties": false,
          "required": ["time", "ball", "speed"],
          "properties": {
            "time": {"type": "number"},
            "ball": {"type": "integer", "minimum": 0, "maximum": 4294967295},
            "part": {"type": "integer", "minimum": 0, "maximum": 4294967295},
            "other_ball": {"type": "integer", "minimum": 0, "maximum": 4294967295},
            "speed": {"type": "number", "minimum": 0}
          }}}
      }}}
  }
})";

Json json_of(const Window& window, const Scene& scene) {
    Json ends = Json::array(), impacts = Json::array();
    for (const Window::End& end : window.ends)
        ends.push_back({{"ball", end.ball},
                        {"position", {end.position.x, end.position.y}},
                        {"radius", end.radius},
                        {"uncertainty", end.uncertainty},
                        {"hit", end.hit}});
    for (const Event& impact : window.impacts)
        impacts.push_back({{"time", impact.time},
                           {"ball", impact.ball},
                           {impact.other.is_ball ? "other_ball" : "part", impact.other.index},
                           {"speed", impact.speed}});
    return {{"start", Json::parse(to_json(window.start, scene))},
            {"seconds", window.seconds},
            {"ends", ends},
            {"impacts", impacts}};
}

/// Reads the windows of one file, whose form has been checked.
class Reader {
  public:
    Reader(const std::string& file, const BlockPlan& plan, const Scene& scene)
        : file_(file), plan_(plan), scene_(scene) {}

    [[nodiscard]] Window window(const Node& node) const {
        Window window;
        window.start = start(node);
        window.seconds = seconds(node);
        for (const Node& one : node.each("ends")) window.ends.push_back(end(one, window));
        if (std::ranges::none_of(window.ends, &Window::End::hit))
            node.fail("ends", "hold no ball that was hit; allowed is at least one");
        for (const Node& one : node.each("impacts")) window.impacts.push_back(impact(one, window));
        return window;
    }

  private:
    [[nodiscard]] State start(const Node& node) const {
        const Node json = node.at("start");
        State state = parse_state(json.json().dump(), file_ + ": " + json.pointer(), scene_);
        const double latest = plan_.variant.until + 1;  // a trajectory goes on to its moment in whole steps
        if (state.clock.time > latest)
            json.fail("time", "is " + json.at("time").json().dump() +
                                  "; windows of this variant start before " + Json(latest).dump() + " s");
        const auto wanted = static_cast<std::size_t>(plan_.variant.balls);
        if (state.balls.empty() || (wanted > 0 && state.balls.size() != wanted))
            json.fail("balls", "are " + std::to_string(state.balls.size()) +
                                   "; allowed is the number of balls of this variant");
        return state;
    }
    [[nodiscard]] double seconds(const Node& node) const {
        const double value = node.real("seconds");
        for (int units = plan_.variant.shortest; units <= plan_.variant.longest; ++units)
            if (value == window_unit * units) return value;
        node.fail("seconds", "is " + node.at("seconds").json().dump() + "; allowed are " +
                                 std::to_string(plan_.variant.shortest) + " to " +
                                 std::to_string(plan_.variant.longest) + " thirtieths");
    }
    static BallNumber ball(const Node& node, const char* key, const Window& window) {
        const auto number = static_cast<BallNumber>(node.integer(key));
        if (!std::ranges::binary_search(window.start.balls, number, {}, &Ball::number))
            node.fail(key, "no ball of the start has this number");
        return number;
    }
    [[nodiscard]] static Window::End end(const Node& node, const Window& window) {
        Window::End end{ball(node, "ball", window), node.vector("position"), node.real("radius"),
                        node.real("uncertainty"), node.toggle("hit")};
        if (!window.ends.empty() && end.ball <= window.ends.back().ball)
            node.fail("ball", "is not above that of the one before; allowed are rising numbers");
        if (end.radius != std::ranges::lower_bound(window.start.balls, end.ball, {}, &Ball::number)->radius)
            node.fail("radius", "is not that of the ball at the start");
        if (end.uncertainty > claim_radii * end.radius)
            node.fail("uncertainty", "is above " + Json(claim_radii).dump() + " radii");
        return end;
    }
    [[nodiscard]] Event impact(const Node& node, const Window& window) const {
        Event event;
        event.time = node.real("time");
        const double from = window.impacts.empty() ? window.start.clock.time : window.impacts.back().time;
        const double until = window.start.clock.time + window.seconds;
        constexpr double rounding = 1e-9;  // s
        if (event.time < from || event.time > until + rounding)
            node.fail("time", "is not in the window, or before the impact before it");
        event.ball = ball(node, "ball", window);
        if (node.has("part") == node.has("other_ball")) node.fail("takes either part or other_ball");
        if (node.has("part")) {
            event.other = Other::part(static_cast<PartIndex>(node.integer("part")));
            if (event.other.index >= scene_.parts.size()) node.fail("part", "the scene has no such part");
        } else {
            event.other = Other::ball(ball(node, "other_ball", window));
        }
        event.speed = node.real("speed");
        return event;
    }

    const std::string& file_;
    const BlockPlan& plan_;
    const Scene& scene_;
};

}  // namespace

std::string to_json(const Block& block, const Scene& scene) {
    Json windows = Json::array();
    for (const Window& window : block.windows) windows.push_back(json_of(window, scene));
    const Json json{{"format", windows_format},
                    {"scene", scene.name},
                    {"trajectories", block.trajectories},
                    {"skipped", block.skipped},
                    {"windows", windows}};
    return json_text(json) + "\n";
}

Block parse_block(std::string_view json, const std::string& file, const BlockPlan& plan, const Scene& scene) {
    const Json document = parse_json(json, file);
    check_form(document, windows_schema, file);
    const Node root(document, file);
    if (root.text("scene") != scene.name)
        root.fail("scene", "is " + in_quotes(root.text("scene")) + "; allowed is " + in_quotes(scene.name));
    Block block;
    block.trajectories = static_cast<std::size_t>(root.integer("trajectories"));
    block.skipped = document.at("skipped").get<std::map<std::string, std::size_t>>();
    const Reader reader(file, plan, scene);
    for (const Node& node : root.each("windows")) block.windows.push_back(reader.window(node));
    if (block.windows.size() > plan.size)
        root.fail("windows", "are more than the " + std::to_string(plan.size) + " of a block");
    return block;
}

}  // namespace flipside::lab::sweep
