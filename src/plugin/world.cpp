#include "plugin/world.hpp"

#include <algorithm>
#include <tuple>

#include "plugin/engine.hpp"
#include "plugin/handover.hpp"
#include "plugin/needs.hpp"
#include "world/fnv1a.hpp"
#include "world/input_error.hpp"
#include "world/printable.hpp"
#include "world/refusal.hpp"
#include "world/scene_json.hpp"

namespace flipside::plugin {

namespace {

/// The engine itself says that it cannot.
struct Declined : Refusal {
    using Refusal::Refusal;
};

std::vector<double> numbers_of(const Settings& settings) {
    std::vector<double> numbers;
    for (const SettingSpec& spec : settings.specs()) numbers.push_back(settings.real(spec.name));
    return numbers;
}

/// FNV-1a of the balls: what an engine saved is of these and no others.
std::string fingerprint(std::span<const Ball> balls) {
    std::uint64_t hash = fnv1a({});
    for (const Ball& ball : balls) {
        const flipside_ball bytes = as_c(ball);
        hash = fnv1a({reinterpret_cast<const char*>(&bytes), sizeof bytes}, hash);
    }
    return {reinterpret_cast<const char*>(&hash), sizeof hash};
}

}  // namespace

PluginWorld::PluginWorld(std::shared_ptr<const Scene> scene, const Plugin& plugin, const Settings& settings)
    : plugin_(plugin),
      settings_(numbers_of(settings)),
      table_(std::move(scene)),
      primitives_(surface_of(table_.scene())),
      balls_(table_.scene().balls),
      guard_(plugin.name) {
    const std::string missing = missing_features(table_.scene(), primitives_, plugin.description.features);
    if (!missing.empty())
        throw InputError(plugin.name + ": cannot run scene '" + table_.scene().name +
                         "', which needs what this engine does not support: " + missing);
    try {
        make();
    } catch (const Declined& declined) {
        throw InputError(declined.what());
    }
}

void PluginWorld::refuse(const std::string& why) const {
    throw Refusal(plugin_.name + ": " + why);
}

/// Asks the engine's process. What it refuses, and its end, end the run.
Answer PluginWorld::ask(Ask kind) const {
    const auto when = [&] {
        return (kind == Ask::step   ? "the step from "
                : kind == Ask::make ? "make at "
                                    : "save at ") +
               brief(table_.time()) + " s";
    };
    if (plugin_.silences >= most_silences)
        refuse("has not answered in time " + std::to_string(most_silences) +
               " times, and is not asked any more");
    try {
        const Answer answer = process_->ask(kind, question_, answer_);
        Reader in(answer_);
        if (answer == Answer::refused)
            throw Declined(plugin_.name + ": refuses " + when() + ": " + printable(in.text()));
        if (answer == Answer::broken) refuse("in " + when() + " it " + printable(in.text()));
        return answer;
    } catch (const Silent& silent) {
        ++plugin_.silences;
        process_.reset();
        refuse("in " + when() + " its process " + silent.what());
    } catch (const Ended& ended) {
        process_.reset();
        refuse("in " + when() + " its process " + ended.what());
    } catch (const Malformed& problem) {
        process_.reset();
        refuse("in " + when() + " its process answers nonsense (" + problem.what() + ")");
    }
}

/// A world of the engine's for the scene as it is now.
void PluginWorld::make(std::string_view saved) {
    if (!process_) {
        knows_json_ = false;
        process_ = std::make_unique<Process>(plugin_.file);
        try {
            if (process_->receive(answer_) != Answer::done) throw Malformed("it is no engine any more");
            Reader in(answer_);
            if (Description::read(in) != plugin_.description)
                throw Malformed("the file is not the one that it was");
        } catch (const Ended& ended) {
            process_.reset();
            refuse(std::string("its process ") + ended.what() + " while it was loaded");
        } catch (const Malformed& problem) {
            process_.reset();
            refuse(printable(plugin_.file) + ": " + problem.what());
        }
    }
    Writer out(question_);
    out.text(knows_json_ ? std::string() : to_json(table_.scene()));
    Handover(table_, primitives_, balls_).write(out);
    out.array(std::span(std::as_const(settings_)));
    out.text(saved);
    static_cast<void>(ask(Ask::make));
    knows_json_ = true;
    Reader in(answer_);
    in.array(foreign_contacts_);
    take_contacts(foreign_contacts_);
    changes_.clear();
    stale_ = false;
}

void PluginWorld::step(double dt) {
    guard_.run(
        table_, balls_, [&] { make_step(dt); }, [&](const State& before) { set_state(before); });
}

void PluginWorld::apply(const Control& control) {
    table_.apply(control);
    if (const auto* nudge = std::get_if<control::Nudge>(&control)) {
        for (Ball& ball : balls_) {
            ball.velocity += nudge->velocity;
            ball.asleep = false;
        }
        flipside_control told{};
        told.kind = FLIPSIDE_NUDGE;
        told.velocity = as_c(nudge->velocity);
        change(told);
    }
    if (!std::holds_alternative<control::RaiseTargets>(control)) return;
    for (PartIndex i = 0; i < table_.parts().size(); ++i)
        if (table_.scene().parts[i].target && !table_.parts()[i].down) show(i, true);
}

BallNumber PluginWorld::add(const Ball& ball) {
    balls_.push_back(table_.numbered(ball));
    change(FLIPSIDE_ADD_BALL, balls_.back());
    return balls_.back().number;
}

bool PluginWorld::remove(BallNumber number) {
    const auto at = find(number);
    if (at == balls_.end()) return false;
    change(FLIPSIDE_REMOVE_BALL, *at);
    balls_.erase(at);
    return true;
}

void PluginWorld::change(flipside_control_kind kind, const Ball& ball) {
    flipside_control told{};
    told.kind = kind;
    told.ball = as_c(ball);
    change(told);
}

/// The engine hears of it before its next step; one that follows no controls gets a new world then.
void PluginWorld::change(const flipside_control& control) {
    stale_ |= !plugin_.description.offers.control;
    if (!stale_) changes_.push_back(control);
}

void PluginWorld::show(PartIndex target, bool there) {
    flipside_control told{};
    told.kind = FLIPSIDE_PRESENCE;
    told.part = target;
    told.on = there ? 1 : 0;
    change(told);
}

State PluginWorld::save() const {
    State state = table_.save(balls_);
    if (!plugin_.description.offers.save) return state;
    try {
        std::string bytes = engine_bytes();
        if (!bytes.empty())
            state.memory = {plugin_.name, time(), {}, {}, fingerprint(state.balls) + std::move(bytes)};
    } catch (const Refusal&) {
        // The next step says so; until then the balls are what there is.
    }
    return state;
}

/// What the engine saves of the world as it is now; nothing where it has none.
std::string PluginWorld::engine_bytes() const {
    if (stale_) return "";
    Writer(question_).array(std::span(std::as_const(changes_)));
    changes_.clear();
    const Answer answer = ask(Ask::save);
    stale_ = answer == Answer::not_followed;
    return stale_ ? "" : Reader(answer_).text();
}

void PluginWorld::set_state(const State& state) {
    table_.restore(state);
    balls_ = state.balls;
    events_.clear();
    contacts_.clear();
    changes_.clear();
    stale_ = true;
}

void PluginWorld::restore(const State& state) {
    guard_.forget();
    set_state(state);
    const EngineMemory& memory = state.memory;
    const std::string expected = fingerprint(state.balls);
    const bool fits = plugin_.description.offers.save && memory.engine == plugin_.name &&
                      memory.time == time() && memory.bytes.starts_with(expected);
    try {
        make(fits ? std::string_view(memory.bytes).substr(expected.size()) : "");
    } catch (const Refusal&) {
        // The next step tries once more, and says so.
        stale_ = true;
    }
}

std::vector<Ball>::iterator PluginWorld::find(BallNumber number) {
    const auto at = std::ranges::lower_bound(balls_, number, {}, &Ball::number);
    return at != balls_.end() && at->number == number ? at : balls_.end();
}

bool PluginWorld::is_there(BallNumber number) const {
    return std::ranges::binary_search(balls_, number, {}, &Ball::number);
}

void PluginWorld::inspect(Inspector& inspector) const {
    if (inspector.wants(Topic::contacts))
        for (const Contact& contact : contacts_) inspector.contact(contact);
    if (inspector.wants(Topic::sleep))
        for (const Ball& ball : balls_)
            if (ball.asleep) inspector.circle(Topic::sleep, ball.position, ball.radius);
}

}  // namespace flipside::plugin
