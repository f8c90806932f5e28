/// Replays as JSON.

#include <algorithm>
#include <charconv>

#include "lab/contenders/engines.hpp"
#include "lab/files/plain_name.hpp"
#include "lab/replay/replay.hpp"
#include "world/ball_json.hpp"
#include "world/control_json.hpp"
#include "world/input_error.hpp"
#include "world/scene_file.hpp"
#include "world/schema.hpp"
#include "world/script_file.hpp"

namespace flipside::lab {

namespace {

constexpr const char* replay_format = "flipside-replay/1";

Json replay_vector(Vec2 v) {
    return {v.x, v.y};
}

std::string hexadecimal(std::uint64_t number) {
    constexpr std::size_t digits = 16;
    char text[digits];
    char* const end = std::to_chars(text, text + digits, number, 16).ptr;
    const std::string shown(text, end);
    return std::string(digits - shown.size(), '0') + shown;
}

Json settings_json(const Settings& settings) {
    Json json = Json::object();
    const Settings defaults(settings.specs());
    for (const SettingSpec& spec : settings.specs())
        if (settings.text(spec.name) != defaults.text(spec.name))
            json[std::string(spec.name)] = settings.text(spec.name);
    return json;
}

struct WriteEdit {
    const Scene& scene;
    Json operator()(const edit::Throw& thrown) const {
        return {{"move", "throw"}, {"ball", thrown.ball}, {"velocity", replay_vector(thrown.velocity)}};
    }
    Json operator()(const edit::Add& add) const {
        return {{"move", "add"}, {"ball", flipside::to_json(add.ball, scene)}};
    }
    Json operator()(const edit::Remove& removed) const {
        return {{"move", "remove"}, {"ball", removed.ball}};
    }
};

struct WriteMove {
    const Scene& scene;
    Json operator()(const move::Press& press) const {
        return flipside::to_json(press.control, scene, "move");
    }
    Json operator()(const move::Edit& edit) const { return std::visit(WriteEdit{scene}, edit.edit); }
    Json operator()(const move::Clear& /*unused*/) const { return {{"move", "clear"}}; }
    Json operator()(const move::Change& change) const {
        return {{"move", "change"},
                {"engine", change.engine->name},
                {"settings", settings_json(change.settings)},
                {"gravity", replay_vector(change.gravity)}};
    }
    Json operator()(const move::StepLength& length) const { return {{"move", "dt"}, {"dt", length.dt}}; }
    Json operator()(const move::Resume& /*unused*/) const { return {{"move", "resume"}}; }
    Json operator()(const move::Refused& /*unused*/) const { return {{"move", "refused"}}; }
    // These two are not among the moves of a replay.
    Json operator()(const move::Scripted& /*unused*/) const { return {}; }
    Json operator()(const move::Check& /*unused*/) const { return {}; }
};

Json run_json(const ReplayRun& run, const Scene& scene) {
    Json json{
        {"name", run.name},
        {"engine", run.start.engine->name},
        {"settings", settings_json(run.start.settings)},
        {"gravity", replay_vector(run.start.gravity)},
        {"dt", run.dt},
        {"steps", run.steps},
        {"moves", Json::array()},
        {"checks", Json::array()},
        {"end",
         {{"time", run.end.time}, {"score", run.end.score}, {"checksum", hexadecimal(run.end.checksum)}}}};
    if (!run.script.empty()) json["script"] = script_document(run.script, scene);
    for (const Recording::Entry& entry : run.moves) {
        Json one = std::visit(WriteMove{scene}, entry.move);
        one["step"] = entry.step;
        json["moves"].push_back(std::move(one));
    }
    for (const std::uint64_t check : run.checks) json["checks"].push_back(hexadecimal(check));
    return json;
}

std::uint64_t read_checksum(const Node& node) {
    const auto& text = node.json().get_ref<const std::string&>();
    std::uint64_t sum = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), sum, 16);
    if (error != std::errc{} || end != text.data() + text.size())
        node.fail("is " + in_quotes(text) + "; allowed: 16 hexadecimal digits");
    return sum;
}

/// Never the path of a library.
const Engine& read_engine(const Node& node) {
    const std::string name = node.text("engine");
    std::string known;
    for (const Engine* engine : engines()) {
        if (!engine->file.empty()) continue;
        if (engine->name == name) return *engine;
        known += (known.empty() ? "" : ", ") + std::string(engine->name);
    }
    node.fail("engine", "is " + in_quotes(name) + ", which is not built in; allowed: " + known);
}

move::Change read_change(const Node& node) {
    const Engine& engine = read_engine(node);
    Settings settings(engine.settings);
    const Node given = node.at("settings");
    for (const auto& entry : given.json().items()) {
        try {
            settings.set(entry.key(), entry.value().get_ref<const std::string&>());
        } catch (const InputError& error) {
            given.at(entry.key()).fail(error.what());
        }
    }
    return {&engine, std::move(settings), node.vector("gravity")};
}

Move read_move(const Node& node, const SceneNames& names) {
    const std::string kind = node.text("move");
    const auto ball = [&] { return static_cast<BallNumber>(node.integer("ball")); };
    if (kind == "throw") return move::Edit{edit::Throw{ball(), node.vector("velocity")}};
    if (kind == "add") return move::Edit{edit::Add{read_ball(node.at("ball"), names)}};
    if (kind == "remove") return move::Edit{edit::Remove{ball()}};
    if (kind == "clear") return move::Clear{};
    if (kind == "change") return read_change(node);
    if (kind == "dt") return move::StepLength{node.real("dt")};
    if (kind == "resume") return move::Resume{};
    if (kind == "refused") return move::Refused{};
    return move::Press{0, read_control(node, names, "move")};
}

ReplayRun read_run(const Node& node, const SceneNames& names) {
    ReplayRun run{node.text("name"), read_change(node), node.real("dt"), 0, {}, {}, {}, {}};
    if (!is_plain_name(run.name))
        node.fail("name", "is no name of a run; allowed are " + std::string(plain_name_rule));
    run.steps = static_cast<std::uint64_t>(node.integer("steps"));
    if (node.has("script")) run.script = parse_script(node.at("script"), names.scene());
    for (const Node& one : node.each("moves")) {
        const auto step = static_cast<std::uint64_t>(one.integer("step"));
        if (step > run.steps || (!run.moves.empty() && step < run.moves.back().step))
            one.fail("step", "is " + std::to_string(step) + "; allowed: in order, up to the " +
                                 std::to_string(run.steps) + " steps of the run");
        run.moves.push_back({step, read_move(one, names)});
    }
    for (const Node& check : node.each("checks")) run.checks.push_back(read_checksum(check));
    if (run.checks.size() != run.steps / steps_between_checks)
        node.fail("checks", "are " + std::to_string(run.checks.size()) + "; allowed: one after every " +
                                std::to_string(steps_between_checks) + " steps, here " +
                                std::to_string(run.steps / steps_between_checks));
    const Node end = node.at("end");
    run.end = {end.real("time"), static_cast<long>(end.integer("score")), read_checksum(end.at("checksum"))};
    return run;
}

}  // namespace

std::string to_json(const Replay& replay) {
    Json json{{"format", replay_format},
              {"program", replay.program},
              {"scene", Json::parse(*replay.scene->document)},
              {"runs", Json::array()}};
    for (const ReplayRun& run : replay.runs) json["runs"].push_back(run_json(run, *replay.scene));
    return json_text(json) + "\n";
}

Replay parse_replay(std::string_view text, const std::string& file) {
    const Json document = parse_json(text, file);
    check_form(document, replay_schema, file);
    const Node root(document, file);
    Replay replay{root.text("program"), std::make_shared<const Scene>(parse_scene(root.at("scene"))), {}};
    const SceneNames names(*replay.scene);
    for (const Node& node : root.each("runs")) {
        ReplayRun run = read_run(node, names);
        if (std::ranges::find(replay.runs, run.name, &ReplayRun::name) != replay.runs.end())
            node.fail("name", in_quotes(run.name) + " is there twice; each run needs a name of its own");
        replay.runs.push_back(std::move(run));
    }
    return replay;
}

Replay load_replay(const std::filesystem::path& file) {
    return parse_replay(read_file(file), file.string());
}

}  // namespace flipside::lab
