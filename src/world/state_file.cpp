#include "world/state_file.hpp"

#include <algorithm>

#include "world/ball_json.hpp"
#include "world/fnv1a.hpp"
#include "world/number_text.hpp"
#include "world/scene_json.hpp"
#include "world/schema.hpp"
#include "world/surface.hpp"
#include "world/table.hpp"

namespace flipside {

namespace {

constexpr const char* state_format = "flipside-state/1";
constexpr const char* side_names[] = {"left", "right"};

Clock read_clock(const Node& root) {
    const Clock clock{root.real("time"), root.real("time_remainder", 0)};
    const double ulp = std::nextafter(clock.time, INFINITY) - clock.time;
    if (std::abs(clock.remainder) > ulp)
        root.fail("time_remainder", "is more than the rounding of the time; allowed: from -" +
                                        Json(ulp).dump() + " to " + Json(ulp).dump());
    return clock;
}

std::vector<Ball> read_balls(const Node& root, const SceneNames& names) {
    std::vector<Ball> balls;
    for (const Node& node : root.each("balls")) {
        balls.push_back(read_ball(node, names));
        const BallNumber number = balls.back().number;
        if (balls.size() > 1 && number <= balls[balls.size() - 2].number)
            node.fail("number", "is not above that of the ball before it; allowed are rising numbers");
        if (number >= static_cast<BallNumber>(root.integer("next_number")))
            node.fail("number", "is not below next_number, which no ball has yet");
    }
    return balls;
}

BallNumber number_of_ball(const Node& node, const char* key, const std::vector<Ball>& balls) {
    const auto number = static_cast<BallNumber>(node.integer(key));
    if (!std::ranges::binary_search(balls, number, {}, &Ball::number))
        node.fail(key, "no ball has this number; allowed are balls of this state");
    return number;
}

PartState read_part(const Node& node, const Part& part) {
    const PartState state{node.real("angle", 0), node.toggle("open"), node.toggle("down")};
    if (state.angle != 0 && !Table::moves(part)) node.fail("angle", "this part does not move; allowed: 0");
    if (state.open && gate_of(part) == nullptr) node.fail("open", "this part is no gate; allowed: false");
    if (state.down && !part.target) node.fail("down", "this part is no drop target; allowed: false");
    if (const auto* flip = std::get_if<motion::Flip>(&part.motion)) {
        const double full = flip->raised - std::get<shape::Flipper>(part.shape.is).rest;
        constexpr double rounding = 1e-9;
        if (state.angle < std::min(full, 0.0) - rounding || state.angle > std::max(full, 0.0) + rounding)
            node.fail("angle", "is beyond the flipper's stops; allowed: between 0 and " + Json(full).dump());
    }
    return state;
}

std::vector<PartState> read_parts(const Node& root, const SceneNames& names) {
    const auto& known = names.scene().parts;
    std::vector<PartState> states(known.size());
    if (!root.has("parts")) return states;
    const Node parts = root.at("parts");
    for (const auto& entry : parts.json().items()) {
        const Node node = parts.at(entry.key());
        const auto found = names.part(entry.key());
        if (!found)
            node.fail("this scene has no such part; allowed: " +
                      names_of(known, [](const Part& part) { return part.name; }));
        states[*found] = read_part(node, known[*found]);
    }
    return states;
}

constexpr std::string_view hex_digits = "0123456789abcdef";

std::string hex(std::string_view bytes) {
    std::string digits;
    for (const char byte : bytes) {
        digits += hex_digits[static_cast<unsigned char>(byte) >> 4U];
        digits += hex_digits[static_cast<unsigned char>(byte) & 15U];
    }
    return digits;
}

/// Of an even number of digits, as the schema has them.
std::string bytes_of(std::string_view digits) {
    std::string bytes;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
        bytes += static_cast<char>(hex_digits.find(digits[i]) << 4U | hex_digits.find(digits[i + 1]));
    return bytes;
}

/// Tells a table from another one of the same name.
std::string fingerprint(const Scene& scene) {
    const std::uint64_t hash = fnv1a(table_text(scene));
    std::string bytes;
    for (int shift = 56; shift >= 0; shift -= 8) bytes += static_cast<char>(hash >> shift);
    return hex(bytes);
}

bool is_gate(const Part& part) {
    return gate_of(part) != nullptr;
}
bool is_entered(const Part& part) {
    return part.sensor || is_gate(part);
}

/// The names of those parts of a scene.
std::string names_of_those(const Scene& scene, bool (*which)(const Part&)) {
    std::vector<Part> those;
    std::ranges::copy_if(scene.parts, std::back_inserter(those), which);
    return names_of(those, [](const Part& part) { return part.name; });
}

std::vector<Sensed> read_inside(const Node& memory, const std::vector<Ball>& balls, const SceneNames& names) {
    std::vector<Sensed> all;
    for (const Node& node : memory.each("inside")) {
        const std::string name = node.text("part");
        const auto part = names.part(name);
        if (!part || !is_entered(names.scene().parts[*part]))
            node.fail("part", in_quotes(name) + " is no sensor or gate of this scene; allowed: " +
                                  names_of_those(names.scene(), is_entered));
        const Sensed sensed{number_of_ball(node, "ball", balls), *part};
        if (!all.empty() && sensed <= all.back())
            node.fail("is not above the pair before it; allowed are pairs by ball, then part");
        all.push_back(sensed);
    }
    return all;
}

EngineMemory read_memory(const Node& root, const std::vector<Ball>& balls, const SceneNames& names) {
    if (!root.has("memory")) return {};
    const Node memory = root.at("memory");
    EngineMemory read{memory.text("engine"),
                      memory.real("time"),
                      {},
                      read_inside(memory, balls, names),
                      bytes_of(memory.text("bytes"))};
    for (const Node& node : memory.each("forces")) {
        const ContactForce force{number_of_ball(node, "a", balls), number_of_ball(node, "b", balls),
                                 node.real("normal"), node.real("tangent", 0)};
        const auto rank = [](const ContactForce& f) { return std::pair(f.b, f.a); };
        if (force.a >= force.b) node.fail("b", "is not above a; allowed are rising numbers");
        if (!read.forces.empty() && rank(force) <= rank(read.forces.back()))
            node.fail("is not above the pair before it; allowed are pairs by rising b, then a");
        read.forces.push_back(force);
    }
    return read;
}

std::vector<Blocked> read_blocked(const Node& root, const State& state, const SceneNames& names) {
    std::vector<Blocked> all;
    for (const Node& node : root.each("blocked")) {
        const std::string name = node.text("gate");
        const auto part = names.part(name);
        if (!part || !is_gate(names.scene().parts[*part]))
            node.fail("gate", in_quotes(name) + " is no gate of this scene; allowed: " +
                                  names_of_those(names.scene(), is_gate));
        if (state.parts[*part].open) node.fail("gate", "is open; allowed are closed gates");
        const Blocked blocked{*part, number_of_ball(node, "ball", state.balls)};
        if (!all.empty() && blocked <= all.back())
            node.fail("is not above the pair before it; allowed are pairs by gate, then ball");
        all.push_back(blocked);
    }
    return all;
}

Json document_of(const State& state, const Scene& scene) {
    Json json = {{"format", state_format},
                 {"scene", scene.name},
                 {"time", state.clock.time},
                 {"time_remainder", state.clock.remainder},
                 {"next_number", state.next_number},
                 {"balls", Json::array()},
                 {"parts", Json::object()},
                 {"raised", Json::array()},
                 {"rotating", state.rotating},
                 {"launches", Json::array()},
                 {"reported_lost", state.reported_lost}};
    for (const Ball& ball : state.balls) json["balls"].push_back(to_json(ball, scene));
    for (PartIndex i = 0; i < state.parts.size(); ++i)
        if (const PartState& part = state.parts[i]; part != PartState{})
            json["parts"][scene.parts[i].name] = {
                {"angle", part.angle}, {"open", part.open}, {"down", part.down}};
    for (const Side side : {Side::left, Side::right})
        if (const auto i = static_cast<int>(side); state.raised[i]) json["raised"].push_back(side_names[i]);
    for (const control::Launch& launch : state.launches)
        json["launches"].push_back(
            {{"strength", launch.strength}, {"count", launch.count}, {"size", launch.size}});
    if (!state.launches.empty()) json["next_look"] = state.next_look;
    if (const EngineMemory& memory = state.memory; !memory.engine.empty()) {
        json["memory"] = {{"engine", memory.engine}, {"time", memory.time}, {"forces", Json::array()}};
        if (!memory.bytes.empty()) json["memory"]["bytes"] = hex(memory.bytes);
        for (const ContactForce& f : memory.forces)
            json["memory"]["forces"].push_back(
                {{"a", f.a}, {"b", f.b}, {"normal", f.normal}, {"tangent", f.tangent}});
        for (const Sensed& s : memory.inside)
            json["memory"]["inside"].push_back({{"ball", s.ball}, {"part", scene.parts[s.part].name}});
    }
    for (const Blocked& b : state.blocked)
        json["blocked"].push_back({{"gate", scene.parts[b.gate].name}, {"ball", b.ball}});
    if (state.origin) json["origin"] = document_of(*state.origin, scene);
    return json;
}

/// A state of another table would lose its balls, or have them in walls.
void require_table(const Node& root, const Scene& scene) {
    if (root.text("scene") != scene.name)
        root.fail("scene", "is a state of " + in_quotes(root.text("scene")) + "; allowed is one of " +
                               in_quotes(scene.name));
    if (root.has("table") && root.text("table") != fingerprint(scene))
        root.fail("table", "is a state of another " + in_quotes(scene.name) +
                               ", with other bounds, layers or parts; allowed is one of the same table, made "
                               "with the same --balls");
}

/// All that can be said of files from before there were fingerprints.
void require_within_bounds(const Node& root, const State& state, const Scene& scene) {
    std::vector<BallNumber> lost = state.reported_lost;
    std::ranges::sort(lost);
    const auto [min, max] = scene.bounds;
    for (std::size_t i = 0; i < state.balls.size(); ++i) {
        const Ball& ball = state.balls[i];
        if (scene.bounds.contains(ball.position) || std::ranges::binary_search(lost, ball.number)) continue;
        root.at("balls").at(i).fail(
            "position",
            "is outside the bounds of this scene: a state of another table of its name? allowed: "
            "x from " +
                number_text(min.x) + " to " + number_text(max.x) + ", y from " + number_text(min.y) + " to " +
                number_text(max.y));
    }
}

State read_state(const Node& root, const SceneNames& names) {
    const Scene& scene = names.scene();
    require_table(root, scene);
    State state;
    state.clock = read_clock(root);
    state.next_number = static_cast<BallNumber>(root.integer("next_number"));
    state.balls = read_balls(root, names);
    state.memory = read_memory(root, state.balls, names);
    state.parts = read_parts(root, names);
    state.blocked = read_blocked(root, state, names);
    for (const Node& side : root.each("raised")) {
        bool& raised = state.raised[side.json() == side_names[0] ? 0 : 1];
        if (raised) side.fail("is here twice; allowed is once");
        raised = true;
    }
    state.rotating = root.toggle("rotating");
    for (const Node& launch : root.each("launches")) {
        if (!scene.launcher) launch.fail("this scene has no launcher; allowed are no launches");
        state.launches.push_back(
            {launch.real("strength"), static_cast<int>(launch.integer("count")), launch.real("size")});
    }
    if (!state.launches.empty()) {
        const double latest = next_look(state.clock.time);
        state.next_look = root.real("next_look", state.clock.time);
        if (state.next_look > latest)
            root.fail("next_look", "is too late; allowed: up to " + Json(latest).dump());
    }
    for (const Node& lost : root.each("reported_lost")) {
        const auto number = static_cast<BallNumber>(lost.json().get<double>());
        if (!std::ranges::binary_search(state.balls, number, {}, &Ball::number))
            lost.fail("no ball has this number; allowed are balls of this state");
        state.reported_lost.push_back(number);
    }
    std::vector<BallNumber> sorted = state.reported_lost;
    std::ranges::sort(sorted);
    if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
        root.fail("reported_lost", "has ball " + std::to_string(*twice) + " more than once; allowed is once");
    if (!root.has("origin")) return state;
    const Node origin = root.at("origin");
    if (origin.has("origin")) origin.fail("origin", "is that of an origin; allowed is one origin of a state");
    state.origin = std::make_shared<const State>(read_state(origin, names));
    if (state.origin->clock.time > state.clock.time)
        origin.fail("time", "is after that of the state; allowed: up to " + Json(state.clock.time).dump());
    return state;
}

}  // namespace

std::string to_json(const State& state, const Scene& scene) {
    Json json = document_of(state, scene);
    json["table"] = fingerprint(scene);
    return json_text(json) + "\n";
}

State parse_state(std::string_view text, const std::string& file, const Scene& scene) {
    const Json document = parse_json(text, file);
    check_form(document, state_schema, file);
    const Node root(document, file);
    State state = read_state(root, SceneNames(scene));
    if (!root.has("table")) require_within_bounds(root, state, scene);
    return state;
}

State load_state(const std::filesystem::path& file, const Scene& scene) {
    // What may be saved may be read: a million balls take 300 MB, and the forces of their heap as much.
    constexpr std::uintmax_t largest = std::uintmax_t{2} << 30U;
    return parse_state(read_file(file, largest), file.string(), scene);
}

}  // namespace flipside
