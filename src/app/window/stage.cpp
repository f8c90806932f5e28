#include "app/window/stage.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/assets.hpp"
#include "world/scene_file.hpp"
#include "world/script_file.hpp"

namespace flipside::app {

namespace {

constexpr std::string_view reference_name = "reference";

}  // namespace

bool is_reference(const Engine& engine) {
    return engine.name == reference_name;
}

Stage::Stage(const std::string& scene, const std::string& engine, View view,
             const std::vector<std::string>& settings, const std::optional<std::filesystem::path>& script)
    : engine_(&lab::engine_named(engine)), view_(view), reference_(engine == reference_name) {
    // The reference is to say how far it may be trusted, unless the user will not pay for that.
    std::vector<std::string> all{"reference.twin=on"};
    all.insert(all.end(), settings.begin(), settings.end());
    asked_ = changes_ = lab::parse_changes(all, lab::engines());
    load(scene);
    if (script) script_ = load_script(*script, *scene_);
    start();
}

void Stage::load(const std::string& scene) {
    original_ = std::make_shared<const Scene>(load_scene(lab::scene_file(scene)));
    scene_ = original_;
    name_ = scene;
    gravity_ = true;
    dt_ = lab::step_for(*scene_);
    settings_.clear();
}

void Stage::open(const std::string& scene) {
    load(scene);
    changes_ = asked_;
    script_.clear();
    start();
}

void Stage::open(const lab::Lesson& lesson) {
    original_ = scene_ = lesson.scene;
    name_ = "lesson " + lesson.name;
    gravity_ = true;
    dt_ = lab::step_for(*scene_);
    settings_.clear();
    changes_ = asked_;
    for (const lab::LessonEngine& on : lesson.engines)
        for (const auto& [name, value] : on.set) changes_.push_back({on.engine, name, value});
    engine_ = lesson.engines.front().engine;
    view_ = lesson.split ? View::split : View::single;
    reference_ = std::ranges::any_of(lesson.engines,
                                     [](const lab::LessonEngine& on) { return is_reference(*on.engine); });
    script_.clear();
    start();
}

void Stage::restart() {
    start();
}

void Stage::start() {
    runs_.clear();
    for (const Engine* engine : line_up(*engine_)) {
        runs_.emplace_back(lab::Session(scene_, *engine, settings_of(*engine)), script_);
        if (view_ == View::single) break;
    }
    divergences_.clear();
    pressed_.clear();
    pair_up();
}

std::vector<const Engine*> Stage::line_up(const Engine& first) const {
    std::vector<const Engine*> engines;
    std::ranges::copy_if(lab::engines(), std::back_inserter(engines),
                         [this](const Engine* engine) { return reference_ || !is_reference(*engine); });
    std::rotate(engines.begin(), std::ranges::find(engines, &first), engines.end());
    return engines;
}

const Settings& Stage::settings_of(const Engine& engine) {
    for (const auto& [owner, settings] : settings_)
        if (owner == &engine) return settings;
    return settings_.emplace_back(&engine, lab::settings_for(engine, *original_, changes_)).second;
}

void Stage::set_view(View view) {
    view_ = view;
    arrange();
}

void Stage::arrange() {
    std::vector<const Engine*> engines = line_up(*engine_);
    if (view_ == View::single) engines.resize(1);
    for (const Engine* engine : engines)
        if (!run_on(*engine)) runs_.push_back(taken_up(lead(), *engine, settings_of(*engine)));
    const auto place = [&](const Run& run) { return std::ranges::find(engines, &run.engine()); };
    std::erase_if(runs_, [&](const Run& run) { return place(run) == engines.end(); });
    std::ranges::sort(runs_, {}, place);
    pair_up();
}

Run* Stage::run_on(const Engine& engine) {
    const auto at = std::ranges::find_if(runs_, [&](const Run& run) { return &run.engine() == &engine; });
    return at == runs_.end() ? nullptr : &*at;
}

const Run& Stage::lead() const {
    const auto at = std::ranges::find_if(runs_, [](const Run& run) { return !run.halt(); });
    return at == runs_.end() ? runs_.front() : *at;
}

Run Stage::taken_up(const Run& from, const Engine& engine, const Settings& settings) const {
    lab::Session fork = from.session().fork();
    fork.change(scene_, engine, settings);
    return {std::move(fork), script_};
}

void Stage::change(Run& run, const Engine& engine, const Settings& settings) {
    if (run.halt() && !lead().halt()) {
        run = taken_up(lead(), engine, settings);
        compare_anew(engine);
    } else {
        run.change(scene_, engine, settings);
    }
}

void Stage::switch_engine() {
    for (Run& run : runs_) {
        const std::vector<const Engine*> engines = line_up(run.engine());
        const Engine& next = *engines[1 % engines.size()];
        change(run, next, settings_of(next));
    }
    engine_ = &runs_.front().engine();
    divergences_.clear();
    pair_up();
}

void Stage::show_reference(bool on) {
    if (on == reference_) return;
    const Engine& exact = lab::engine_named(reference_name);
    if (!on && engine_ == &exact) engine_ = line_up(exact).at(1);
    reference_ = on;
    if (view_ == View::single) {
        if (on) engine_ = &exact;
        change(runs_.front(), *engine_, settings_of(*engine_));
    }
    arrange();
}

const Run* Stage::guide() const {
    const auto at = std::ranges::find_if(
        runs_, [](const Run& run) { return !run.halt() && !is_reference(run.engine()); });
    return at == runs_.end() ? nullptr : &*at;
}

void Stage::take_up() {
    const Run* from = guide();
    for (Run& run : runs_) {
        if (!from || !(run.halt() || is_reference(run.engine()))) continue;
        const Engine& engine = run.engine();
        run = taken_up(*from, engine, settings_of(engine));
        compare_anew(engine);
    }
}

void Stage::compare_anew(const Engine& engine) {
    std::erase_if(divergences_, [&](const Divergence& divergence) {
        return &divergence.first() == &engine || &divergence.second() == &engine;
    });
    pair_up();
}

void Stage::pair_up() {
    std::erase_if(divergences_, [this](const Divergence& divergence) {
        return !run_on(divergence.first()) || !run_on(divergence.second());
    });
    for (std::size_t i = 0; i < runs_.size(); ++i)
        for (std::size_t j = i + 1; j < runs_.size(); ++j) {
            const Engine &a = runs_[i].engine(), &b = runs_[j].engine();
            const bool there = std::ranges::any_of(divergences_, [&](const Divergence& divergence) {
                return (&divergence.first() == &a && &divergence.second() == &b) ||
                       (&divergence.first() == &b && &divergence.second() == &a);
            });
            if (!there) divergences_.emplace_back(a, b);
        }
}

void Stage::run_until(double end, double dt) {
    // Not by adding up dt: the number of whole steps must not depend on rounding.
    const auto whole = static_cast<std::uint64_t>(std::floor(end / dt + 1e-9));
    constexpr double for_ever = std::numeric_limits<double>::infinity();
    for (std::uint64_t i = 0; i < whole; ++i) static_cast<void>(step_within(dt, for_ever));
    const double rest = end - static_cast<double>(whole) * dt;
    if (rest > 1e-9 * dt) static_cast<void>(step_within(rest, for_ever));
}

bool Stage::step_within(double dt, double seconds) {
    // The exact engine may need long for a step. It goes first, and the others wait for it: so all that is on
    // show is at one time.
    for (Run& run : runs_)
        if (is_reference(run.engine()) && !run.step_within(dt, script_, seconds)) return false;
    for (Run& run : runs_)
        if (!is_reference(run.engine())) static_cast<void>(run.step_within(dt, script_, seconds));
    for (Divergence& divergence : divergences_)
        divergence.observe(*run_on(divergence.first()), *run_on(divergence.second()), dt);
    for (const Control& control : std::exchange(pressed_, {})) press(control);
    return true;
}

bool Stage::under_way() const {
    return std::ranges::any_of(runs_, &Run::under_way);
}

void Stage::press(const Control& control) {
    if (under_way())
        pressed_.push_back(control);
    else
        for (Run& run : runs_) run.press(control);
}

void Stage::clear() {
    const bool all_halted = lead().halt().has_value();
    for (Run& run : runs_)
        if (!run.halt() || all_halted) run.clear();
    for (Run& run : runs_)
        if (run.halt()) change(run, run.engine(), run.session().settings());
    divergences_.clear();
    pair_up();
}

void Stage::set_gravity(bool on) {
    if (on == gravity_) return;
    gravity_ = on;
    Scene changed = *original_;
    if (!on) changed.gravity = {};
    scene_ = std::make_shared<const Scene>(std::move(changed));
    for (Run& run : runs_) change(run, run.engine(), run.session().settings());
}

void Stage::change_setting(std::size_t run, std::string_view name, double value) {
    const Engine& engine = runs_[run].engine();
    for (auto& [owner, settings] : settings_)
        if (owner == &engine) {
            Settings changed = settings;
            changed.set(name, value);
            change(runs_[run], engine, changed);
            settings = std::move(changed);
        }
}

}  // namespace flipside::app
