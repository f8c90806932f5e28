#include "app/window/window_report.hpp"

#include <cerrno>
#include <system_error>

#include <nlohmann/json.hpp>

#include "app/window/claim.hpp"
#include "app/window/playfield/captions.hpp"
#include "app/window/step_bar.hpp"
#include "lab/files/path_error.hpp"
#include "lab/process/failure.hpp"
#include "world/json_file.hpp"

namespace flipside::app {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Rect& r) {
    return {r.x, r.y, r.width, r.height};
}

Json json_of(const std::vector<Rect>& rects) {
    Json list = Json::array();
    for (const Rect& r : rects) list.push_back(json_of(r));
    return list;
}

Json settings_of(const Settings& settings) {
    Json values = Json::object();
    for (const SettingSpec& spec : settings.specs())
        values[std::string(spec.name)] = settings.text(spec.name);
    return values;
}

/// What holds until somebody does something.
Json still(const Stage& stage, const WindowState& window, const WindowControls& controls,
           const Layout& layout, const ControlPlaces& places) {
    Json j;
    j["scene"] = stage.scene_name();
    j["view"] = view_name(stage.view());
    j["reference"] = stage.reference();
    j["paused"] = controls.paused;
    j["speed"] = controls.speed;
    j["muted"] = controls.muted;
    j["has_sound"] = controls.has_sound;
    j["gravity"] = stage.gravity();
    j["panel"] = controls.panel_open;
    j["help"] = controls.help_open;
    j["plots"] = spec_of(controls.plots).label;
    j["step_bar"] = controls.bar_open;
    j["by_keys"] = controls.by_keys;
    j["focus"] = places.focus;
    j["notice"] = controls.notice.words();
    j["letters"] = controls.scale;
    j["artwork"] = controls.look.artwork;
    j["slow"] = window.slow;
    j["edit"] = window.edit.empty() ? Json() : Json::parse(window.edit);
    j["browser"] = window.browser;
    j["last_key"] = window.last_key;
    j["last_screenshot"] = window.last_screenshot;
    j["last_export"] = window.last_export;
    j["last_game"] = window.last_game;
    for (std::size_t i = 0; i < show_count; ++i)
        j["show"][std::string(show_specs[i].name)] = bool(controls.look.shows[i]);
    j["layout"] = {{"window", {window.width, window.height}}, {"headers", json_of(layout.headers)},
                   {"panes", json_of(layout.panes)},          {"bar", json_of(layout.bar)},
                   {"scrubber", json_of(layout.scrubber)},    {"strip", json_of(layout.strip)},
                   {"panel", json_of(layout.panel)}};
    j["controls"] = Json::object();
    for (const auto& [name, place] : places) j["controls"][name] = json_of(place);
    for (const Run& run : stage.runs())
        j["engines"].push_back({{"name", run.name()},
                                {"engine", run.engine().name},
                                {"dt", run.dt()},
                                {"settings", settings_of(run.session().settings())}});
    return j;
}

Json caption_words(const lab::Session& session) {
    const auto words = caption_of(session.game(), session.world().time());
    return words ? Json{words->title, words->detail} : Json();
}

Json json_of(const Run& run, const Rect& pane, const Camera& camera) {
    const lab::Session& session = run.session();
    const Scene& scene = session.scene();
    Json balls = Json::array(), flippers = Json::array();
    for (std::size_t i = 0; i < session.world().balls().size(); ++i) {
        const Ball& ball = session.world().balls()[i];
        const Vec2 at = camera.to_pixels(ball.position);
        balls.push_back({{"number", ball.number},
                         {"position", {ball.position.x, ball.position.y}},
                         {"velocity", {ball.velocity.x, ball.velocity.y}},
                         {"uncertainty", uncertainty_in_radii(session.world(), i)},
                         {"pixel", {pane.x + at.x, pane.y + at.y}},
                         {"pixel_radius", camera.scale * ball.radius}});
    }
    for (std::size_t i = 0; i < scene.parts.size(); ++i)
        if (const auto* flip = std::get_if<motion::Flip>(&scene.parts[i].motion))
            flippers.push_back({{"name", scene.parts[i].name},
                                {"side", flip->side == Side::left ? "left" : "right"},
                                {"angle", session.world().parts()[i].angle}});
    return {
        {"name", run.name()},
        {"engine", session.engine().name},
        {"dt", run.dt()},
        {"time", session.world().time()},
        {"steps", session.totals().steps},
        {"launched", session.totals().launched},
        {"score", session.game().score()},
        {"balls_left", session.game().balls_left()},
        {"ball", session.game().turns().number()},
        {"over", session.game().over()},
        {"caption", caption_words(session)},
        {"balls", balls},
        {"flippers", flippers},
        {"horizon", run.passed_horizon() ? Json(*run.passed_horizon()) : Json()},
        {"halted", run.halt() ? Json{{"time", run.halt()->time}, {"reason", run.halt()->reason}} : Json()}};
}

Json json_of(const GameEnd& end) {
    Json j{{"scores", Json::array()}, {"parted", end.parted}, {"high", Json::array()}};
    for (const GameEnd::Score& score : end.scores)
        j["scores"].push_back(
            {{"name", score.name}, {"points", score.points}, {"best", score.best}, {"enters", score.enters}});
    for (const HighScore& high : end.high) j["high"].push_back({high.engine, high.score});
    return j;
}

/// The open lesson.
Json json_of(const Lessons& lessons) {
    Json j{{"name", lessons.lesson()->name}, {"title", lessons.lesson()->title}};
    j["answered"] = lessons.answered() ? Json(*lessons.answered()) : Json();
    if (const auto& checked = lessons.checked())
        for (const lab::Verified& one : *checked) j["holds"].push_back(one.holds);
    return j;
}

/// What is shown of a step.
Json json_of(const Microscope& microscope, const Stage& stage) {
    const TraceStage& now = microscope.stage();
    Json balls = Json::array();
    for (const Ball& ball : microscope.balls(microscope.run()))
        balls.push_back({{"number", ball.number}, {"position", {ball.position.x, ball.position.y}}});
    return {{"engine", stage.runs()[microscope.run()].name()},
            {"stage", microscope.at()},
            {"stages", microscope.stages().size()},
            {"name", now.name},
            {"says", now.says},
            {"where", now.where},
            {"items", now.items.size()},
            {"item", microscope.item()},
            {"picked", microscope.item() < now.items.size() ? in_one_line(now.items[microscope.item()]) : ""},
            {"balls", balls}};
}

Json json_of(const Card& card) {
    Json j{{"title", card.title}, {"about", card.about}, {"rows", Json::object()}};
    for (const Card::Row& row : card.rows) j["rows"][row.label] = row.cells;
    return j;
}

Json json_of(const Divergence& divergence, const Scene& scene) {
    Json j{{"first", divergence.first()}, {"second", divergence.second()}};
    j["radii"] = divergence.history().empty() ? Json() : Json(divergence.history().back().value);
    if (const auto& parting = divergence.parting())
        j["parted"] = {{"time", parting->time}, {"ball", parting->ball}, {"on", divergence.parted_on(scene)}};
    return j;
}

}  // namespace

WindowReport::WindowReport(const std::filesystem::path& file) : out_(file) {
    if (!out_)
        lab::throw_path_error(file, "cannot be written", std::error_code(errno, std::generic_category()));
}

void WindowReport::write(const Stage& stage, const Microscope& microscope, const Lessons& lessons,
                         const WindowState& window, const WindowControls& controls, const Layout& layout,
                         const Camera& camera, const ControlPlaces& places) {
    Json j = still(stage, window, controls, layout, places);
    if (lessons.lesson()) j["lesson"] = json_of(lessons);
    if (controls.bar_open && microscope.shows(stage)) j["inside"] = json_of(microscope, stage);
    j["frame"] = window.frame;
    j["time"] = stage.time();
    j["under_way"] = stage.under_way();
    j["record"] = {stage.record_begin(), stage.record_end()};
    j["in_past"] = stage.in_past();
    j["charge"] = window.charge;
    j["game_end"] = window.end ? json_of(*window.end) : Json();
    j["card"] = window.card ? json_of(*window.card) : Json();
    const std::optional<Sling>& sling = controls.look.sling;
    j["sling"] = sling ? Json{sling->velocity.x, sling->velocity.y} : Json();
    j["scale"] = camera.scale;
    j["center"] = {camera.center.x, camera.center.y};
    for (std::size_t i = 0; i < stage.runs().size(); ++i)
        j["panes"].push_back(
            json_of(stage.runs()[i], layout.panes[layout.panes.size() == 1 ? 0 : i], camera));
    for (const Divergence& divergence : stage.divergences())
        j["divergences"].push_back(json_of(divergence, stage.scene()));
    out_ << json_text(j) << std::endl;
    if (!out_) throw lab::Failure("the window's report cannot be written");
}

}  // namespace flipside::app
