#include "app/window/stage.hpp"

#include <algorithm>
#include <cmath>

#include "lab/assets.hpp"
#include "world/scene_file.hpp"
#include "world/script_file.hpp"

namespace flipside::app {

Stage::Stage(const std::string& scene, const std::string& engine, View view,
             const std::vector<std::string>& settings, const std::optional<std::filesystem::path>& script)
    : engine_(&lab::engine_named(engine)), view_(view) {
    changes_ = lab::parse_changes(settings, lab::engines());
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
    script_.clear();
    start();
}

void Stage::restart() {
    start();
}

void Stage::start() {
    runs_.clear();
    runs_.emplace_back(lab::Session(scene_, *engine_, settings_of(*engine_)), script_);
    if (view_ != View::single) {
        const Engine& partner = partner_of(*engine_);
        runs_.emplace_back(lab::Session(scene_, partner, settings_of(partner)), script_);
    }
    distance_.clear();
    parting_.reset();
}

const Engine& Stage::partner_of(const Engine& engine) {
    const auto engines = lab::engines();
    const auto at = std::ranges::find(engines, &engine);
    return at + 1 == engines.end() ? *engines.front() : **(at + 1);
}

const Settings& Stage::settings_of(const Engine& engine) {
    for (const auto& [owner, settings] : settings_)
        if (owner == &engine) return settings;
    return settings_.emplace_back(&engine, lab::settings_for(engine, *original_, changes_)).second;
}

void Stage::set_view(View view) {
    if (view == view_) return;
    view_ = view;
    if (view == View::single) {
        runs_.pop_back();
    } else if (runs_.size() == 1) {
        // The newcomer takes over what is on the table, score and all.
        const Engine& partner = partner_of(*engine_);
        lab::Session fork = runs_.front().session().fork();
        fork.change(scene_, partner, settings_of(partner));
        runs_.emplace_back(std::move(fork), script_);
    }
    distance_.clear();
    parting_.reset();
}

void Stage::switch_engine() {
    for (Run& run : runs_) {
        const Engine& next = partner_of(run.session().engine());
        run.change(scene_, next, settings_of(next));
    }
    engine_ = &runs_.front().session().engine();
}

void Stage::run_until(double end, double dt) {
    // Not by adding up dt: the number of whole steps must not depend on rounding.
    const auto whole = static_cast<std::uint64_t>(std::floor(end / dt + 1e-9));
    for (std::uint64_t i = 0; i < whole; ++i) step(dt);
    const double rest = end - static_cast<double>(whole) * dt;
    if (rest > 1e-9 * dt) step(rest);
}

void Stage::step(double dt) {
    for (Run& run : runs_) run.step(dt, script_);
    if (runs_.size() == 2) compare();
}

void Stage::compare() {
    const World& a = runs_[0].session().world();
    const World& b = runs_[1].session().world();
    double most = -1;
    for (const Ball& ball : a.balls()) {
        const auto other = std::ranges::lower_bound(b.balls(), ball.number, {}, &Ball::number);
        if (other == b.balls().end() || other->number != ball.number) continue;
        const double distance = length(other->position - ball.position);
        most = std::max(most, distance);
        if (parting_ || distance <= ball.radius) continue;
        const Other* hit = runs_[0].traces().last_hit(ball.number);
        std::string on;
        if (hit) on = hit->is_ball ? "ball " + std::to_string(hit->index) : scene_->parts[hit->index].name;
        parting_ = Parting{a.time(), ball.number, on};
    }
    if (most >= 0) remember(distance_, {a.time(), most}, Run::history_seconds);
}

bool Stage::press(const Control& control) {
    bool any = false;
    for (Run& run : runs_) any |= run.session().press(control);
    return any;
}

void Stage::clear() {
    for (Run& run : runs_) run.clear();
    parting_.reset();
}

void Stage::set_gravity(bool on) {
    if (on == gravity_) return;
    gravity_ = on;
    Scene changed = *original_;
    if (!on) changed.gravity = {};
    scene_ = std::make_shared<const Scene>(std::move(changed));
    for (Run& run : runs_) run.change(scene_, run.session().engine(), run.session().settings());
}

void Stage::change_setting(std::size_t run, std::string_view name, double value) {
    const Engine& engine = runs_[run].session().engine();
    for (auto& [owner, settings] : settings_)
        if (owner == &engine) {
            Settings changed = settings;
            changed.set(name, value);
            runs_[run].change(scene_, engine, changed);
            settings = std::move(changed);
        }
}

}  // namespace flipside::app
