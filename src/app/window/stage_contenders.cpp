/// How the contenders of a stage are changed while they run.

#include <algorithm>
#include <utility>

#include "app/window/stage.hpp"
#include "world/input_error.hpp"

namespace flipside::app {

void Stage::replace(std::size_t place, const lab::Contender& contender) {
    std::vector<lab::Contender> all = contenders_;
    all[place] = contender;
    const double dt = lab::common_step(all);
    go_on_from_here();
    if (Run* run = find_run(contenders_[place].name)) change(*run, contender);
    contenders_ = std::move(all);
    set_step(dt);
    pair_up();
}

void Stage::set_step(double dt) {
    if (dt == dt_) return;
    dt_ = dt;
    for (Run& run : runs_)
        if (run.under_way()) run.change(scene_, contenders_[place_of(run)]);
}

void Stage::change_setting(std::size_t run, std::string_view name, double value) {
    const std::size_t place = place_of(runs_[run]);
    lab::Contender changed = contenders_[place];
    changed.settings.set(name, value);
    replace(place, changed);
}

void Stage::change_step(std::size_t run, double dt) {
    const std::size_t place = place_of(runs_[run]);
    lab::Contender changed = contenders_[place];
    changed.dt = dt;
    replace(place, changed);
    line_up_[place].dt = dt;
}

void Stage::change_engine(std::size_t run, const Engine& engine) {
    const std::size_t place = place_of(runs_[run]);
    if (contenders_[place].engine == &engine) return;
    std::vector<lab::ContenderRequest> others = line_up_;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(place));
    lab::ContenderRequest request = lab::plain_contender(engine);
    request.name = lab::free_name(request.name, others);
    request.dt = line_up_[place].dt;
    replace(place, lab::contender_for(request, *original_, contenders_[place].dt, changes_));
    line_up_[place] = std::move(request);
    compare_anew(contenders_[place].name);
}

void Stage::add_contender() {
    if (contenders_.size() == most_contenders)
        throw InputError("there is room for " + std::to_string(most_contenders) + " contenders");
    go_on_from_here();
    lab::ContenderRequest request = line_up_.back();
    lab::Contender contender = contenders_.back();
    request.name = contender.name = lab::free_name(std::string(contender.engine->name), line_up_);
    line_up_.push_back(std::move(request));
    contenders_.push_back(std::move(contender));
    arrange();
}

void Stage::remove_contender(std::size_t run) {
    if (contenders_.size() == 1) throw InputError("the last contender stays");
    go_on_from_here();
    const auto place = static_cast<std::ptrdiff_t>(place_of(runs_[run]));
    line_up_.erase(line_up_.begin() + place);
    contenders_.erase(contenders_.begin() + place);
    arrange();
    set_step(lab::common_step(contenders_));
}

bool Stage::steps_differ() const {
    return std::ranges::any_of(runs_, [&](const Run& run) { return run.dt() != runs_.front().dt(); });
}

std::size_t Stage::slowest() const {
    const auto waited_for = std::ranges::find_if(runs_, &Run::under_way);
    const auto at =
        waited_for != runs_.end() ? waited_for : std::ranges::max_element(runs_, {}, &Run::cost_per_second);
    return static_cast<std::size_t>(at - runs_.begin());
}

}  // namespace flipside::app
