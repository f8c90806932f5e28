#include "lab/session/traced_step.hpp"

#include <nlohmann/json.hpp>

#include "lab/files/text_stream.hpp"
#include "world/json_file.hpp"
#include "world/printable.hpp"
#include "world/trace_units.hpp"

namespace flipside::lab {

namespace {

using OrderedJson = nlohmann::ordered_json;

struct AsJson {
    template <class T>
    OrderedJson operator()(const T& value) const {
        return value;
    }
    OrderedJson operator()(Vec2 value) const { return OrderedJson::array({value.x, value.y}); }
    OrderedJson operator()(const Box& value) const {
        return {{"min", (*this)(value.min)}, {"max", (*this)(value.max)}};
    }
};

bool is_about(const TraceItem& item, BallNumber ball) {
    bool about_another = false;
    for (const auto& [name, value] : item.fields) {
        if (name != "ball" && name != "other_ball") continue;
        if (std::get<std::int64_t>(value) == std::int64_t{ball}) return true;
        about_another = true;
    }
    return !about_another;
}

}  // namespace

TracedStep trace_step(Session& session, double dt, const Script& script, std::size_t& next) {
    TracedStep step{session.scene().name, std::string(session.engine().name), session.world().time(), dt, {}};
    session.world().trace(&step.trace);
    try {
        session.step(dt, script, next);
    } catch (...) {
        session.world().trace(nullptr);
        throw;
    }
    session.world().trace(nullptr);
    return step;
}

void keep_ball(Trace& trace, BallNumber ball) {
    for (TraceStage& stage : trace.stages)
        std::erase_if(stage.items, [&](const TraceItem& item) { return !is_about(item, ball); });
}

std::string to_text(const TracedStep& step) {
    TextStream text;
    text << printable(step.scene) << " on " << step.engine << ": the step from " << brief(step.time)
         << " s to " << brief(step.time + step.dt) << " s\n";
    int number = 0;
    for (const TraceStage& stage : step.trace.stages) {
        text << '\n'
             << ++number << ". " << stage.name << "  [" << stage.where << "]\n   " << printable(stage.says)
             << '\n';
        for (const TraceItem& item : stage.items) {
            text << "     " << item.kind << ':';
            for (const auto& [name, value] : item.fields)
                text << "  " << name << ' ' << with_its_unit(name, value);
            text << '\n';
        }
    }
    return text.str();
}

/// A line for each item: a trace of many balls is long.
std::string to_json(const TracedStep& step) {
    const auto text_of = [](const auto& value) { return json_text(OrderedJson(value)); };
    std::string text = "{\"scene\": " + text_of(step.scene) + ", \"engine\": " + text_of(step.engine) +
                       ", \"time\": " + text_of(step.time) + ", \"dt\": " + text_of(step.dt) +
                       ", \"stages\": [";
    std::string_view next_stage = "\n";
    for (const TraceStage& stage : step.trace.stages) {
        text += next_stage;
        text += "{\"name\": " + text_of(stage.name) + ", \"where\": " + text_of(stage.where) +
                ", \"says\": " + text_of(stage.says) + ", \"items\": [";
        next_stage = ",\n";
        std::string_view next_item = "\n ";
        for (const TraceItem& item : stage.items) {
            OrderedJson json{{"kind", item.kind}};
            for (const auto& [name, value] : item.fields) json[name] = std::visit(AsJson{}, value);
            text += next_item;
            text += json_text(json);
            next_item = ",\n ";
        }
        text += "]}";
    }
    return text + "]}\n";
}

}  // namespace flipside::lab
