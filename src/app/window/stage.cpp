#include "app/window/stage.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/files/assets.hpp"
#include "lab/session/timeline.hpp"
#include "world/input_error.hpp"
#include "world/scene_file.hpp"
#include "world/script_file.hpp"

namespace flipside::app {

namespace {

constexpr std::string_view reference_name = "reference";

std::shared_ptr<const Scene> scene_of(const std::string& name) {
    return std::make_shared<const Scene>(load_scene(lab::scene_file(name)));
}

std::string_view contender_name(const lab::Contender* contender) {
    return contender->name;
}

/// Every engine as it is but for the reference, in the order of the list, round from `first`; the reference
/// where it is the first.
std::vector<lab::ContenderRequest> everybody(const Engine& first) {
    std::vector<const Engine*> engines;
    std::ranges::copy_if(lab::engines(), std::back_inserter(engines),
                         [&](const Engine* engine) { return engine == &first || !is_reference(*engine); });
    std::rotate(engines.begin(), std::ranges::find(engines, &first), engines.end());
    std::vector<lab::ContenderRequest> requests;
    for (const Engine* engine : engines) requests.push_back(lab::plain_contender(*engine));
    return requests;
}

View view_of(lab::LessonView view) {
    return view == lab::LessonView::split     ? View::split
           : view == lab::LessonView::overlay ? View::overlay
                                              : View::single;
}

/// The guide is the first run of which this is not so.
bool goes_on_from_guide(const Run& run) {
    return run.halt() || is_reference(run.engine());
}

}  // namespace

bool is_reference(const Engine& engine) {
    return engine.name == reference_name;
}

Stage::Stage(const std::string& scene, const std::string& engine, View view,
             const std::vector<std::string>& settings, const std::optional<std::filesystem::path>& script,
             const std::vector<std::string>& contenders, std::optional<double> dt)
    : line_up_(lab::parse_contenders(contenders)), asked_dt_(dt), view_(view) {
    // A library is an engine once it is loaded, and then it may have settings.
    const Engine& first = lab::engine_named(engine);
    changes_ = lab::parse_changes(settings, lab::engines());
    // The reference is to say how far it may be trusted, unless the user will not pay for that.
    const auto is_twin = [](const lab::SettingChange& change) {
        return is_reference(*change.engine) && change.name == "twin";
    };
    if (std::ranges::none_of(changes_, is_twin))
        changes_.push_back({&lab::engine_named(reference_name), "twin", "on"});
    if (line_up_.size() > most_contenders)
        throw InputError(std::to_string(line_up_.size()) + " contenders; the window has room for " +
                         std::to_string(most_contenders));
    if (line_up_.empty()) line_up_ = everybody(first);
    show_scene(scene, scene_of(scene), line_up_);
    script_file_ = script;
    if (script) script_ = load_script(*script, *scene_);
    start();
}

void Stage::show_scene(std::string name, std::shared_ptr<const Scene> scene,
                       std::vector<lab::ContenderRequest> line_up) {
    std::vector<lab::Contender> contenders;
    for (const lab::ContenderRequest& request : line_up)
        contenders.push_back(
            lab::contender_for(request, *scene, asked_dt_.value_or(lab::step_for(*scene)), changes_));
    dt_ = lab::common_step(contenders);
    contenders_ = std::move(contenders);
    line_up_ = std::move(line_up);
    original_ = scene_ = std::move(scene);
    name_ = std::move(name);
    gravity_ = true;
    script_file_.reset();
    script_.clear();
}

void Stage::open(const std::string& scene) {
    show_scene(scene, scene_of(scene), before_lesson_ ? before_lesson_->line_up : line_up_);
    if (before_lesson_) view_ = before_lesson_->view;
    before_lesson_.reset();
    start();
}

void Stage::open(const lab::Lesson& lesson) {
    std::vector<lab::ContenderRequest> requests = lesson.engines;
    // In the single view the others wait for Tab.
    if (lesson.view == lab::LessonView::single)
        for (const lab::ContenderRequest& other : everybody(*lesson.engines.front().engine))
            if (std::ranges::find(requests, other.engine, &lab::ContenderRequest::engine) == requests.end())
                requests.push_back(other);
    for (std::size_t i = lesson.engines.size(); i < requests.size(); ++i)
        requests[i].name = lab::free_name(requests[i].name, {requests.data(), i});
    Before before = before_lesson_.value_or(Before{line_up_, view_});
    show_scene("lesson " + lesson.name, lesson.scene, std::move(requests));
    before_lesson_ = std::move(before);
    view_ = view_of(lesson.view);
    start();
}

void Stage::reload() {
    take(name_, scene_of(name_));
}

void Stage::restart() {
    start();
}

void Stage::start() {
    in_past_ = false;
    ++games_;
    runs_.clear();
    for (const lab::Contender* contender : on_show())
        runs_.emplace_back(
            *contender,
            lab::Session(scene_, *contender->engine, contender->settings, lab::WithoutWorld::refuse_steps),
            script_);
    divergences_.clear();
    pressed_.clear();
    edits_.clear();
    pair_up();
}

std::vector<const lab::Contender*> Stage::on_show() const {
    std::vector<const lab::Contender*> shown;
    for (const lab::Contender& contender : contenders_)
        if (view_ != View::single || &contender == &contenders_.front() || is_reference(*contender.engine))
            shown.push_back(&contender);
    return shown;
}

void Stage::set_view(View view) {
    go_on_from_here();
    view_ = view;
    arrange();
}

void Stage::arrange() {
    const std::vector<const lab::Contender*> shown = on_show();
    for (const lab::Contender* contender : shown)
        if (find_run(contender->name) == nullptr) runs_.push_back(taken_up(lead(), *contender));
    const auto place = [&](const Run& run) { return std::ranges::find(shown, run.name(), &contender_name); };
    std::erase_if(runs_, [&](const Run& run) { return place(run) == shown.end(); });
    std::ranges::sort(runs_, {}, place);
    pair_up();
}

Run* Stage::find_run(std::string_view name) {
    const auto at = std::ranges::find(runs_, name, &Run::name);
    return at == runs_.end() ? nullptr : &*at;
}

const Run& Stage::run_named(std::string_view name) const {
    return *std::ranges::find(runs_, name, &Run::name);
}

std::size_t Stage::place_of(const Run& run) const {
    const auto at = std::ranges::find(contenders_, run.name(), &lab::Contender::name);
    return static_cast<std::size_t>(at - contenders_.begin());
}

const Run& Stage::lead() const {
    const auto at = std::ranges::find_if(runs_, [](const Run& run) { return !run.halt(); });
    return at == runs_.end() ? runs_.front() : *at;
}

bool Stage::reference() const {
    return std::ranges::any_of(contenders_,
                               [](const lab::Contender& one) { return is_reference(*one.engine); });
}

const Run* Stage::exact() const {
    const auto at = std::ranges::find_if(runs_, [](const Run& run) { return is_reference(run.engine()); });
    return at == runs_.end() ? nullptr : &*at;
}

Run Stage::taken_up(const Run& from, const lab::Contender& contender) const {
    lab::Session fork = from.session().fork();
    fork.change(scene_, *contender.engine, contender.settings);
    return {contender, std::move(fork), script_};
}

void Stage::change(Run& run, const lab::Contender& contender) {
    if (run.halt() && !lead().halt()) {
        run = taken_up(lead(), contender);
        compare_anew(run.name());
    } else {
        run.change(scene_, contender);
    }
}

void Stage::switch_engine() {
    go_on_from_here();
    // The reference keeps its place, for it is what the others are held against; alone it gives way.
    std::vector<std::size_t> places;
    const bool reference_alone = view_ == View::single && is_reference(*contenders_.front().engine);
    for (std::size_t i = 0; i < contenders_.size(); ++i)
        if (reference_alone || !is_reference(*contenders_[i].engine)) places.push_back(i);
    for (std::size_t i = 1; i < places.size(); ++i) {
        std::swap(contenders_[places[i - 1]], contenders_[places[i]]);
        std::swap(line_up_[places[i - 1]], line_up_[places[i]]);
    }
    const std::vector<const lab::Contender*> shown = on_show();
    change(runs_.front(), *shown.front());
    runs_.erase(runs_.begin() + 1, runs_.end());
    divergences_.clear();
    arrange();
}

bool Stage::show_reference(bool on) {
    if (on == reference()) return true;
    go_on_from_here();
    const Engine& exact = lab::engine_named(reference_name);
    if (on) {
        if (contenders_.size() == most_contenders) return false;
        line_up_.push_back(lab::plain_contender(exact));
        line_up_.back().name = lab::free_name(line_up_.back().name, {line_up_.data(), line_up_.size() - 1});
        line_up_.back().dt = dt_;
        contenders_.push_back(lab::contender_for(line_up_.back(), *original_, dt_, changes_));
    } else {
        if (std::ranges::all_of(contenders_, [](const auto& one) { return is_reference(*one.engine); })) {
            line_up_.push_back(everybody(*lab::engines().front()).front());
            contenders_.push_back(lab::contender_for(line_up_.back(), *original_, dt_, changes_));
        }
        std::erase_if(line_up_, [](const auto& one) { return is_reference(*one.engine); });
        std::erase_if(contenders_, [](const auto& one) { return is_reference(*one.engine); });
    }
    arrange();
    return true;
}

const Run* Stage::guide() const {
    const auto at = std::ranges::find_if_not(runs_, goes_on_from_guide);
    return at == runs_.end() ? nullptr : &*at;
}

bool Stage::can_take_up() const {
    return guide() != nullptr && std::ranges::any_of(runs_, goes_on_from_guide);
}

void Stage::take_up() {
    go_on_from_here();
    const Run* from = guide();
    for (Run& run : runs_) {
        if (!from || !goes_on_from_guide(run)) continue;
        run = taken_up(*from, contenders_[place_of(run)]);
        compare_anew(run.name());
    }
}

void Stage::compare_anew(std::string_view name) {
    std::erase_if(divergences_, [&](const Divergence& divergence) { return divergence.is_of(name); });
    pair_up();
}

void Stage::pair_up() {
    for (auto run = runs_.begin(); run != runs_.end(); ++run)
        run->set_twin(static_cast<int>(
            std::count_if(runs_.begin(), run, [&](const Run& r) { return &r.engine() == &run->engine(); })));
    std::erase_if(divergences_, [this](const Divergence& divergence) {
        return find_run(divergence.first()) == nullptr || find_run(divergence.second()) == nullptr;
    });
    for (std::size_t i = 0; i < runs_.size(); ++i)
        for (std::size_t j = i + 1; j < runs_.size(); ++j) {
            const std::string &a = runs_[i].name(), &b = runs_[j].name();
            const bool there = std::ranges::any_of(divergences_, [&](const Divergence& divergence) {
                return divergence.is_of(a) && divergence.is_of(b);
            });
            if (!there) divergences_.emplace_back(a, b);
        }
}

void Stage::run_until(double end) {
    const lab::Timeline timeline(0, end, dt_);
    constexpr double for_ever = std::numeric_limits<double>::infinity();
    for (std::uint64_t k = 0; k < timeline.steps(); ++k)
        static_cast<void>(step_within(timeline.length(k), for_ever));
}

bool Stage::step_within(double span, double seconds) {
    go_on_from_here();
    // The exact engine may need long for a step. It goes first, and the others wait for it: so all that is on
    // show is at one time.
    for (Run& run : runs_)
        if (is_reference(run.engine()) && !run.step_within(span, script_, seconds)) return false;
    for (Run& run : runs_)
        if (!is_reference(run.engine()))
            static_cast<void>(run.step_within(span, script_, std::numeric_limits<double>::infinity()));
    compare_runs();
    for (const Control& control : std::exchange(pressed_, {})) press(control);
    for (const lab::BallEdit& edit : std::exchange(edits_, {})) this->edit(edit);
    return true;
}

bool Stage::under_way() const {
    return std::ranges::any_of(runs_, &Run::under_way);
}

void Stage::press(const Control& control) {
    go_on_from_here();
    if (under_way())
        pressed_.push_back(control);
    else
        for (Run& run : runs_) run.press(control);
}

void Stage::clear() {
    go_on_from_here();
    const bool all_halted = lead().halt().has_value();
    for (Run& run : runs_)
        if (!run.halt() || all_halted) run.clear();
    for (Run& run : runs_)
        if (run.halt()) change(run, contenders_[place_of(run)]);
    divergences_.clear();
    pair_up();
}

void Stage::set_scene() {
    Scene changed = *original_;
    if (!gravity_) changed.gravity = {};
    scene_ = std::make_shared<const Scene>(std::move(changed));
}

void Stage::set_gravity(bool on) {
    if (on == gravity_) return;
    go_on_from_here();
    gravity_ = on;
    set_scene();
    for (Run& run : runs_) change(run, contenders_[place_of(run)]);
}

}  // namespace flipside::app
