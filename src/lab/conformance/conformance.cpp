#include "lab/conformance/conformance.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <nlohmann/json.hpp>

#include "flipside/engine.h"
#include "lab/conformance/check.hpp"
#include "lab/contenders/engines.hpp"
#include "plugin/needs.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"
#include "world/printable.hpp"
#include "world/refusal.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab {

namespace {

constexpr std::string_view grade_names[] = {"pass", "part", "fail", "not offered"};
constexpr int points_for_loading = 4;

std::vector<const ContractItem*> all_items() {
    std::vector<const ContractItem*> all;
    for (const auto items : {motion_items(), surface_items(), contract_items()})
        for (const ContractItem& item : items) all.push_back(&item);
    return all;
}

std::string names_of_missing(std::uint64_t needs, std::uint64_t declared) {
    std::string names;
    for (const plugin::Feature& feature : plugin::features())
        if ((needs & feature.bit) != 0 && (declared & feature.bit) == 0)
            names += (names.empty() ? "" : ", ") + std::string(feature.name);
    return names;
}

Finding find(const ContractItem& item, const Subject& subject) {
    const std::string missing = names_of_missing(item.needs, subject.description().features);
    if (!missing.empty() && item.mandatory) return fails("Does not declare " + missing + ".");
    if (!missing.empty())
        return {Grade::not_offered,
                "Does not declare " + missing + ": scenes that need it are refused by name."};
    try {
        return item.check(subject);
    } catch (const Refusal& refusal) {
        return fails(refusal.what());
    } catch (const InputError& error) {
        return fails(error.what());
    }
}

Mark marked(const ContractItem& item, const Finding& found) {
    const double share = found.grade == Grade::pass ? 1 : found.grade == Grade::part ? found.share : 0;
    return {item.name,
            item.asks,
            item.mandatory,
            found.grade,
            static_cast<int>(std::floor(share * item.points)),
            item.points,
            printable(found.says)};
}

}  // namespace

std::string_view name_of(Grade grade) {
    return grade_names[static_cast<std::size_t>(grade)];
}

Finding passes(std::string says) {
    return {Grade::pass, std::move(says)};
}

Finding fails(std::string says) {
    return {Grade::fail, std::move(says)};
}

Finding graded(double error, double good, double bound, std::string says) {
    if (!(error <= bound)) return fails(std::move(says));
    if (error <= good) return passes(std::move(says));
    return {Grade::part, std::move(says), 0.5 + 0.5 * std::log(bound / error) / std::log(bound / good)};
}

std::shared_ptr<const Scene> Subject::scene(const std::string& rest) const {
    return std::make_shared<const Scene>(parse_scene(R"({"format": "flipside-scene/1", "name": "conformance",
                        "bounds": {"min": [-10, -10], "max": [10, 10]}, "rest_speed": 0.01, )" +
                                                         rest + "}",
                                                     "conformance"));
}

std::unique_ptr<World> Subject::world(const std::string& rest) const {
    return engine().make(scene(rest), Settings(engine().settings));
}

std::string Subject::floor(const std::string& more) const {
    struct Kind {
        std::uint64_t needs;
        const char* shape;
    };
    constexpr Kind kinds[] = {
        {FLIPSIDE_SEGMENTS | FLIPSIDE_POINTS, R"({"type": "segment", "a": [-9, 0], "b": [9, 0]})"},
        {FLIPSIDE_POLYGONS, R"({"type": "polygon", "points": [[-9, -1], [9, -1], [9, 0], [-9, 0]]})"},
        {FLIPSIDE_TAPERS, R"({"type": "capsule", "a": [-8, -1], "b": [8, -1], "radius": 1})"},
        {FLIPSIDE_CIRCLES, R"({"type": "circle", "center": [0, -1000], "radius": 1000})"}};
    for (const Kind& kind : kinds)
        if (declares(kind.needs))
            return std::string(R"({"name": "floor", )") + more + "\"shape\": " + kind.shape + "}";
    return "";
}

int Conformance::points() const {
    int sum = 0;
    for (const Mark& mark : marks) sum += mark.points;
    return sum;
}

int Conformance::of() const {
    int sum = 0;
    for (const Mark& mark : marks) sum += mark.of;
    return sum;
}

bool Conformance::passed() const {
    return std::ranges::none_of(marks, [](const Mark& mark) { return mark.grade == Grade::fail; });
}

Conformance check_conformance(const std::filesystem::path& file, const std::function<void(double)>& watch) {
    if (!std::filesystem::exists(file)) throw InputError(file.string(), "", "there is no such file");
    Conformance result{printable(file.string()), "", "", {}};
    const ContractItem loads{"loads",
                             "The library loads, is of this version of the interface, and describes itself.",
                             points_for_loading,
                             0,
                             true,
                             nullptr};
    std::unique_ptr<const plugin::Plugin> plugin;
    try {
        std::vector<std::string_view> taken;
        for (const Engine* engine : engines())
            if (engine->file.empty()) taken.push_back(engine->name);
        plugin = plugin::load(file, taken);
        result.engine = plugin->name;
        result.library = plugin->description.library;
        const std::string name = printable(plugin->description.name);
        result.marks.push_back(marked(
            loads, plugin->name == name
                       ? passes("It is \"" + name + "\": " + plugin->description.about + ".")
                       : Finding{Grade::part,
                                 "It calls itself \"" + name +
                                     "\", which is no word of its own; here it is " + plugin->name + ".",
                                 0.5}));
    } catch (const InputError& error) {
        result.marks.push_back(marked(loads, fails(error.what())));
    }
    const std::vector<const ContractItem*> items = all_items();
    for (const ContractItem* item : items) {
        const Finding found = plugin ? find(*item, Subject(*plugin)) : fails("It was not loaded.");
        result.marks.push_back(marked(*item, found));
        if (watch) watch(static_cast<double>(result.marks.size()) / static_cast<double>(items.size() + 1));
    }
    return result;
}

std::string to_json(const Conformance& conformance) {
    nlohmann::ordered_json items = nlohmann::ordered_json::array();
    for (const Mark& mark : conformance.marks)
        items.push_back({{"name", mark.name},
                         {"asks", mark.asks},
                         {"mandatory", mark.mandatory},
                         {"verdict", name_of(mark.grade)},
                         {"points", mark.points},
                         {"of", mark.of},
                         {"says", mark.says}});
    const nlohmann::ordered_json json{{"format", "flipside-conformance/1"},
                                      {"file", conformance.file},
                                      {"engine", conformance.engine},
                                      {"library", conformance.library},
                                      {"passed", conformance.passed()},
                                      {"points", conformance.points()},
                                      {"of", conformance.of()},
                                      {"items", items}};
    return json_text(json, 2) + '\n';
}

}  // namespace flipside::lab
