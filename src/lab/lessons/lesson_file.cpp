#include <algorithm>

#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "lab/files/plain_name.hpp"
#include "lab/lessons/lesson.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"
#include "world/printable.hpp"
#include "world/scene_file.hpp"
#include "world/schema.hpp"

namespace flipside::lab {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t largest_file = 1U << 20U;
constexpr double most_steps = 1e6, most_ball_steps = 1e8, most_traced = 1000;  // of a run
constexpr std::size_t longest_run_name = 40;

std::shared_ptr<const Scene> scene_in(const Node& owner, const std::string& file) {
    const Node node = owner.at("scene");
    const auto balls = static_cast<int>(owner.integer("balls"));
    try {
        if (node.json().is_object())
            return std::make_shared<const Scene>(
                parse_scene(node.json().dump(), file + " at " + node.pointer()));
        const fs::path path = scene_file(node.json().get<std::string>());
        return std::make_shared<const Scene>(balls > 0 ? load_scene(path, balls) : load_scene(path));
    } catch (const InputError& error) {
        node.fail(error.what());
    }
}

const Engine& engine_in(const Node& node) {
    try {
        return engine_named(node.text("engine"));
    } catch (const InputError& error) {
        node.fail("engine", error.what());
    }
}

std::vector<std::pair<std::string, std::string>> changes_in(const Node& node) {
    std::vector<std::pair<std::string, std::string>> changes;
    if (!node.has("set")) return changes;
    for (const auto& [name, value] : node.at("set").json().items())
        changes.emplace_back(name, value.is_string() ? value.get<std::string>() : value.dump());
    return changes;
}

std::optional<double> step_in(const Node& node) {
    if (!node.has("dt")) return std::nullopt;
    try {
        return parse_step(node.text("dt"));
    } catch (const InputError& error) {
        node.fail("dt", error.what());
    }
}

/// Checked against the settings that the engine has.
ContenderRequest contender_in(const Node& node) {
    const Engine& engine = engine_in(node);
    ContenderRequest found{std::string(engine.name), &engine, step_in(node), changes_in(node)};
    Settings settings(found.engine->settings);
    for (const auto& [name, value] : found.set) {
        try {
            settings.set(name, value);
        } catch (const InputError& error) {
            node.at("set").at(name).fail(error.what());
        }
    }
    return found;
}

/// Those of the panes, each with a name of its own and a step that meets the others'.
std::vector<ContenderRequest> contenders_in(const Node& node, const Scene& scene) {
    std::vector<ContenderRequest> found;
    std::vector<Contender> contenders;
    for (const Node& one : node.each("engines")) {
        ContenderRequest request = contender_in(one);
        if (one.has("name")) request.name = one.text("name");
        if (!is_plain_name(request.name))
            one.fail("name", "is no name; allowed are " + std::string(plain_name_rule));
        if (std::ranges::find(found, request.name, &ContenderRequest::name) != found.end())
            one.fail("the name '" + request.name + "' is there twice; each needs a \"name\" of its own");
        contenders.push_back(contender_for(request, scene, step_for(scene)));
        found.push_back(std::move(request));
    }
    try {
        static_cast<void>(common_step(contenders));
    } catch (const InputError& error) {
        node.fail("engines", error.what());
    }
    return found;
}

/// A name that a formula can speak of.
bool is_run_name(std::string_view name) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    return !name.empty() && name.size() <= longest_run_name && is_letter(name[0]) &&
           std::ranges::all_of(name,
                               [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

/// Limits the length of a run, since claims are verified while the user waits.
void check_length(const Node& node, const ClaimRun& run) {
    const auto balls = static_cast<double>(run.scene->balls.size());
    const double steps = run.seconds / *run.on.dt;
    if (!(steps <= most_steps))
        node.fail("seconds",
                  "makes " + brief(steps) + " steps; at most " + brief(most_steps) + " are allowed");
    if (!(steps * balls <= most_ball_steps))
        node.fail("seconds", "makes " + brief(steps) + " steps of " + brief(balls) + " balls; at most " +
                                 brief(most_ball_steps) + " times balls are allowed");
    if (run.trace && balls > most_traced)
        node.fail("trace",
                  "is of " + brief(balls) + " balls; at most " + brief(most_traced) + " are allowed");
}

ClaimRun run_in(const Node& node, const std::string& name, const Lesson& lesson, const std::string& file) {
    ClaimRun run;
    if (!is_run_name(name))
        node.fail("is no name of a run; it takes a letter, then letters, digits and _, " +
                  std::to_string(longest_run_name) + " in all");
    run.name = name;
    run.scene = node.has("scene") ? scene_in(node, file) : lesson.scene;
    run.on = contender_in(node);
    if (!run.on.dt) run.on.dt = step_for(*run.scene);
    run.seconds = node.real("seconds");
    run.from = node.real("from", 0);
    if (run.from >= run.seconds)
        node.fail("from", "is not before the end of the run; it takes less than \"seconds\"");
    run.against_reference = node.toggle("against_reference");
    run.trace = node.toggle("trace");
    if (node.has("compare_with")) run.compare_with = node.text("compare_with");
    check_length(node, run);
    return run;
}

Claim claim_in(const Node& node, const Lesson& lesson, const std::string& file) {
    Claim claim;
    claim.says = node.text("says");
    for (const auto& [name, value] : node.at("runs").json().items())
        claim.runs.push_back(run_in(node.at("runs").at(name), name, lesson, file));
    for (const ClaimRun& run : claim.runs)
        if (!run.compare_with.empty() &&
            std::ranges::find(claim.runs, run.compare_with, &ClaimRun::name) == claim.runs.end())
            node.at("runs").at(run.name).fail(
                "compare_with", "names no run; there are " +
                                    names_of(claim.runs, [](const ClaimRun& one) { return one.name; }));
    for (const Node& statement : node.each("holds"))
        claim.holds.push_back(statement.json().get<std::string>());
    return claim;
}

Question question_in(const Node& node) {
    Question question{
        node.text("asks"), {}, static_cast<std::size_t>(node.integer("right")), node.text("because")};
    for (const Node& answer : node.each("answers"))
        question.answers.push_back(answer.json().get<std::string>());
    if (question.right >= question.answers.size())
        node.fail("right",
                  "is the place of no answer; it takes 0 to " + std::to_string(question.answers.size() - 1));
    return question;
}

LessonView view_in(const Node& node) {
    const std::string name = node.text("view", "single");
    return name == "split" ? LessonView::split : name == "overlay" ? LessonView::overlay : LessonView::single;
}

fs::path lessons_folder() {
    return assets_folder() / "lessons";
}

}  // namespace

Lesson parse_lesson(std::string_view text, const std::string& file) {
    const Json document = parse_json(text, file);
    check_form(document, lesson_schema, file);
    const Node node(document, file);
    Lesson lesson;
    lesson.title = node.text("title");
    lesson.idea = node.text("idea");
    lesson.scene = scene_in(node, file);
    lesson.engines = contenders_in(node, *lesson.scene);
    lesson.view = view_in(node);
    for (const Node& show : node.each("show")) lesson.show.push_back(show.json().get<std::string>());
    lesson.plots = node.text("plots");
    lesson.inside = node.toggle("inside");
    lesson.paused = node.toggle("paused", lesson.inside);
    lesson.speed = node.real("speed", 1);
    lesson.task = node.text("do");
    if (node.has("question")) lesson.question = question_in(node.at("question"));
    lesson.claim = claim_in(node.at("claim"), lesson, file);
    return lesson;
}

Lesson load_lesson(const fs::path& path) {
    Lesson lesson = parse_lesson(read_file(path, largest_file), path.string());
    lesson.name = path.stem().string();
    lesson.text = read_file(fs::path(path).replace_extension(".md"), largest_file);
    return lesson;
}

std::vector<fs::path> lesson_files() {
    std::vector<fs::path> files;
    std::error_code failed;
    for (const fs::directory_entry& entry : fs::directory_iterator(lessons_folder(), failed))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    if (failed)
        throw InputError(
            lessons_folder().string(), "",
            "cannot be read (" + failed.message() + "); set FLIPSIDE_ASSETS to the assets folder");
    std::ranges::sort(files);
    return files;
}

fs::path lesson_file(const std::string& name) {
    std::error_code none;
    if (fs::is_regular_file(name, none)) return name;
    const std::vector<fs::path> files = lesson_files();
    for (const fs::path& file : files) {
        const std::string stem = file.stem().string();
        const std::string number = stem.substr(0, stem.find('-')),
                          rest = stem.substr(std::min(stem.size(), stem.find('-') + 1));
        const std::string asked = name.size() == 1 ? "0" + name : name;
        if (stem == name || rest == name || number == asked) return file;
    }
    throw InputError("no lesson " + in_quotes(name) + "; give the path of a file or one of " +
                     names_of(files, [](const fs::path& file) { return file.stem().string(); }));
}

}  // namespace flipside::lab
