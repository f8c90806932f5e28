#pragma once
/// The trace of a step: its stages with their numbers. A world writes it during the step if a trace is
/// requested. It costs nothing otherwise, and never changes a bit of the result.

#include <concepts>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "world/ball.hpp"
#include "world/events.hpp"
#include "world/scene.hpp"

namespace flipside {

class World;

using TraceValue = std::variant<bool, std::int64_t, double, std::string, Vec2, Box, std::vector<double>>;

/// One entry of a stage: a pair, a contact, an impact. Fields that refer to the table have the same names
/// everywhere: `ball` and `other_ball` are numbers of balls, `part` is a part's name; `position`, `point` and
/// `normal` are in metres, in the world's frame.
struct TraceItem {
    std::string kind;
    std::vector<std::pair<std::string, TraceValue>> fields;

    /// Adds a field and returns the item.
    TraceItem& with(std::string_view name, TraceValue value);
    TraceItem& with(std::string_view name, const char* value) {
        return with(name, TraceValue(std::string(value)));
    }
    TraceItem& with(std::string_view name, std::string_view value) {
        return with(name, TraceValue(std::string(value)));
    }
    TraceItem& with(std::string_view name, std::string value) {
        return with(name, TraceValue(std::move(value)));
    }
    /// For counts and indices.
    template <std::unsigned_integral N>
    requires(!std::same_as<N, bool>) TraceItem& with(std::string_view name, N value) {
        return with(name, TraceValue(static_cast<std::int64_t>(value)));
    }
    /// Adds the other body: `other_ball`, or `part`.
    TraceItem& with_other(Other other, const Scene& scene);
    /// Adds point, normal, speed and impulse.
    TraceItem& with_impact(const Event& impact);

    /// Null where there is no such field.
    [[nodiscard]] const TraceValue* find(std::string_view name) const;
    /// The same, of a type that it must have.
    template <class T>
    [[nodiscard]] const T& get(std::string_view name) const {
        return std::get<T>(*find(name));
    }
};

struct TraceStage {
    std::string name;   ///< in the field's terms
    std::string where;  ///< "file: function" that does it
    std::string says;   ///< one sentence, with its numbers
    std::vector<TraceItem> items;

    /// Adds an item and returns it; valid until the next one is added.
    TraceItem& add(std::string_view kind) { return items.emplace_back(TraceItem{std::string(kind), {}}); }
};

/// In the order in which the stages ran.
struct Trace {
    std::vector<TraceStage> stages;

    /// Begins a stage and returns it; valid until the next one begins.
    TraceStage& stage(std::string_view name, std::string_view where) {
        return stages.emplace_back(TraceStage{std::string(name), std::string(where), {}, {}});
    }
    /// The last stage if it has this name; else begins it.
    TraceStage& same_stage(std::string_view name, std::string_view where) {
        return !stages.empty() && stages.back().name == name ? stages.back() : stage(name, where);
    }
};

/// Adds the last stage of every step: the balls and events that the world reports.
void trace_read_out(Trace& trace, std::string_view where, const World& world, const Scene& scene);

/// Points of a path: x and y of `place` at equal times from `from` to `to`.
[[nodiscard]] std::vector<double> swept(double from, double to, const std::function<Vec2(double)>& place);

/// A number for a sentence, to four digits.
[[nodiscard]] std::string brief(double number);
/// A value in a line of text, numbers to four digits; text is printable().
[[nodiscard]] std::string in_brief(const TraceValue& value);
/// "4.167 ms".
[[nodiscard]] std::string milliseconds(double seconds);
/// "1 ball", "3 balls".
[[nodiscard]] std::string counted(std::uint64_t n, std::string_view thing);

}  // namespace flipside
