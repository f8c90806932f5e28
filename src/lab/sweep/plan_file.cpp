#include <algorithm>

#include <nlohmann/json.hpp>

#include "lab/files/assets.hpp"
#include "lab/files/data_file.hpp"
#include "lab/files/plain_name.hpp"
#include "lab/process/build_commit.hpp"
#include "lab/sweep/plan.hpp"
#include "world/input_error.hpp"
#include "world/printable.hpp"
#include "world/schema.hpp"

namespace flipside::lab::sweep {

namespace fs = std::filesystem;

namespace {

const fs::path file_name = "plan.json";
constexpr const char *plan_format = "flipside-sweep/5", *plan_origin = "plan";

/// Numbers stay so small that nothing that is reckoned from them overflows.
constexpr std::string_view plan_schema = R"({
  "type": "object",
  "additionalProperties": false,
  "required": ["format", "commit", "seed", "blocks", "windows_per_block", "timed_per_block", "repetitions",
               "finest_steps_per_second", "most_work", "variants", "contenders"],
  "properties": {
    "format": {"const": "flipside-sweep/5"},
    "commit": {"type": "string"},
    "seed": {"type": "integer", "minimum": 0, "maximum": 9007199254740991},
    "blocks": {"type": "integer", "minimum": 1, "maximum": 10000},
    "windows_per_block": {"type": "integer", "minimum": 1, "maximum": 100000},
    "timed_per_block": {"type": "integer", "minimum": 0, "maximum": 100000},
    "repetitions": {"type": "integer", "minimum": 0, "maximum": 100000},
    "finest_steps_per_second": {"type": "integer", "minimum": 30, "maximum": 7680},
    "most_work": {"type": "number", "minimum": 1, "maximum": 1e12},
    "variants": {"type": "array", "minItems": 1, "maxItems": 100, "items": {
      "type": "object",
      "additionalProperties": false,
      "required": ["name", "scene", "scene_xxh3", "balls", "from", "until", "shortest", "longest"],
      "properties": {
        "name": {"type": "string", "minLength": 1, "maxLength": 255},
        "scene": {"type": "string"},
        "scene_xxh3": {"type": "string"},
        "balls": {"type": "integer", "minimum": 0, "maximum": 1000000},
        "from": {"type": "number", "minimum": 0, "maximum": 1000000},
        "until": {"type": "number", "minimum": 0, "maximum": 1000000},
        "shortest": {"type": "integer", "minimum": 1, "maximum": 1000},
        "longest": {"type": "integer", "minimum": 1, "maximum": 1000}
      }}},
    "contenders": {"type": "array", "minItems": 1, "maxItems": 100, "items": {
      "type": "object",
      "additionalProperties": false,
      "required": ["name", "engine", "settings", "coarsest_steps_per_second", "finest_steps_per_second",
                   "about"],
      "properties": {
        "name": {"type": "string", "minLength": 1, "maxLength": 255},
        "engine": {"type": "string", "maxLength": 255},
        "settings": {"type": "string", "maxLength": 2000},
        "coarsest_steps_per_second": {"type": "integer", "minimum": 30, "maximum": 7680},
        "finest_steps_per_second": {"type": "integer", "minimum": 30, "maximum": 7680},
        "about": {"type": "string", "maxLength": 5000},
        "file_xxh3": {"type": "string"}
      }}}
  }
})";

/// Of the scene's file and of the script that belongs to it.
std::string scene_checksum(const Variant& variant) {
    const fs::path scene = scene_file(variant.scene);
    const auto script = script_beside(scene);
    return checksum(checksum(read_file(scene)) + (script ? checksum(read_file(*script)) : ""));
}

/// A name that is part of a file's.
void require_plain_name(const Node& node) {
    const std::string name = node.text("name");
    if (!is_plain_name(name))
        node.fail("name", "is " + in_quotes(name) + "; allowed are " + std::string(plain_name_rule));
}

Variant parse_variant(const Node& node) {
    require_plain_name(node);
    return {.name = node.text("name"),
            .scene = node.text("scene"),
            .balls = static_cast<int>(node.integer("balls")),
            .from = node.real("from"),
            .until = node.real("until"),
            .shortest = static_cast<int>(node.integer("shortest")),
            .longest = static_cast<int>(node.integer("longest"))};
}

/// Of the library that a contender was loaded from; "" where it is built in.
std::string file_checksum(const Contender& contender) {
    const std::string_view file = engine_named(contender.engine).file;
    return file.empty() ? "" : checksum(read_file(file));
}

const Contender* parse_contender(const Node& node) {
    // A name and not a path: reading a plan loads nothing.
    require_plain_name(node);
    const int coarsest = static_cast<int>(node.integer("coarsest_steps_per_second"));
    const int finest = static_cast<int>(node.integer("finest_steps_per_second"));
    const Contender* contender = find_contender(node.text("name"));
    try {
        if (contender == nullptr)
            contender = &add_contender(node.text("name"), node.text("engine"), node.text("settings"),
                                       coarsest, finest, printable(node.text("about")));
    } catch (const InputError& error) {
        node.fail(error.what());
    }
    if (node.text("engine") != contender->engine || node.text("settings") != contender->settings ||
        coarsest != contender->coarsest || finest != contender->finest ||
        node.text("file_xxh3") != file_checksum(*contender))
        node.fail("is another contender than " + std::string(contender->name) +
                  " of this version; allowed is the same one");
    return contender;
}

void require_different_names(const Node& root, const Plan& plan) {
    std::vector<std::string_view> names;
    for (const Variant& variant : plan.variants) names.push_back(variant.name);
    for (const Contender* contender : plan.contenders) names.push_back(contender->name);
    const auto middle = names.begin() + static_cast<std::ptrdiff_t>(plan.variants.size());
    std::sort(names.begin(), middle);
    std::sort(middle, names.end());
    if (std::adjacent_find(names.begin(), middle) != middle) root.fail("variants", "are there twice");
    if (std::adjacent_find(middle, names.end()) != names.end()) root.fail("contenders", "are there twice");
}

}  // namespace

std::string to_json(const Plan& plan) {
    nlohmann::ordered_json variants, all;
    for (const Variant& variant : plan.variants)
        variants.push_back({{"name", variant.name},
                            {"scene", printable(variant.scene)},
                            {"scene_xxh3", scene_checksum(variant)},
                            {"balls", variant.balls},
                            {"from", variant.from},
                            {"until", variant.until},
                            {"shortest", variant.shortest},
                            {"longest", variant.longest}});
    for (const Contender* contender : plan.contenders) {
        all.push_back({{"name", contender->name},
                       {"engine", contender->engine},
                       {"settings", contender->settings},
                       {"coarsest_steps_per_second", contender->coarsest},
                       {"finest_steps_per_second", contender->finest},
                       {"about", contender->about}});
        if (const std::string sum = file_checksum(*contender); !sum.empty()) all.back()["file_xxh3"] = sum;
    }
    const nlohmann::ordered_json json{{"format", plan_format},
                                      {"commit", build_commit()},
                                      {"seed", plan.seed},
                                      {"blocks", plan.blocks},
                                      {"windows_per_block", plan.block_size},
                                      {"timed_per_block", plan.timed},
                                      {"repetitions", plan.repetitions},
                                      {"finest_steps_per_second", plan.finest},
                                      {"most_work", plan.most_work},
                                      {"variants", variants},
                                      {"contenders", all}};
    return json_text(json, 2) + '\n';
}

Plan parse_plan(std::string_view json, const std::string& file) {
    const Json document = parse_json(json, file);
    check_form(document, plan_schema, file);
    const Node root(document, file);
    Plan plan;
    plan.seed = static_cast<std::uint64_t>(root.integer("seed"));
    plan.blocks = static_cast<std::uint32_t>(root.integer("blocks"));
    plan.block_size = static_cast<std::size_t>(root.integer("windows_per_block"));
    plan.timed = static_cast<std::size_t>(root.integer("timed_per_block"));
    plan.repetitions = static_cast<std::size_t>(root.integer("repetitions"));
    plan.finest = static_cast<int>(root.integer("finest_steps_per_second"));
    plan.most_work = root.real("most_work");
    for (const Node& node : root.each("variants")) plan.variants.push_back(parse_variant(node));
    plan.contenders.clear();
    for (const Node& node : root.each("contenders")) plan.contenders.push_back(parse_contender(node));
    require_different_names(root, plan);
    return plan;
}

void write_plan(const fs::path& folder, const std::string& json) {
    write_data_file(folder / file_name, plan_origin, json);
}

std::string read_plan(const fs::path& folder) {
    return read_data_file(folder / file_name, plan_origin);
}

}  // namespace flipside::lab::sweep
