#include "lab/sweep/variants.hpp"

#include <algorithm>

#include "lab/files/assets.hpp"
#include "lab/files/plain_name.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"
#include "world/scene_file.hpp"
#include "world/script_file.hpp"

namespace flipside::lab::sweep {

namespace {

bool has_field(const std::string& scene) {
    try {
        static_cast<void>(load_scene(scene_file(scene), 1));
        return true;
    } catch (const InputError&) {
        return false;
    }
}

}  // namespace

std::vector<Variant> standard_variants() {
    return {
        {.name = "pinball-1", .scene = "pinball", .balls = 1, .from = 1, .until = 12},
        {.name = "pinball-8", .scene = "pinball", .balls = 8, .from = 0.1, .until = 4},
        {.name = "toy", .scene = "toy", .from = 1, .until = 12},
        // A tenth of a second of 320 balls holds some two hundred hits; later on they lie in heaps.
        {.name = "rain", .scene = "rain", .balls = 320, .from = 0, .until = 1.5, .shortest = 3, .longest = 3},
    };
}

namespace {

/// How windows of a scene are come by.
Variant variant_of(const std::string& scene, const std::string& name) {
    Variant variant{.name = name, .scene = scene};
    if (name == "bowl") variant.until = 0.5;  // after its nudge it soon slides, and hits nothing
    return variant;
}

/// Their files would be the same.
void require_different(const std::vector<Variant>& variants) {
    for (std::size_t i = 0; i < variants.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (variants[i].name == variants[j].name)
                throw InputError("scenes '" + variants[j].scene + "' and '" + variants[i].scene +
                                 "' are both called '" + variants[i].name +
                                 "'; allowed are scenes of different names");
}

}  // namespace

std::vector<Variant> variants_of(const std::vector<std::string>& scenes, int balls) {
    std::vector<Variant> standard = standard_variants();
    if (scenes.empty() && balls == 0) return standard;
    std::vector<std::string> names = scenes;
    if (names.empty())
        for (const Variant& variant : standard)
            if (std::ranges::find(names, variant.scene) == names.end()) names.push_back(variant.scene);

    std::vector<Variant> variants;
    for (const std::string& name : names) {
        const std::size_t before = variants.size();
        std::ranges::copy_if(standard, std::back_inserter(variants),
                             [&](const Variant& variant) { return variant.scene == name; });
        const auto scene = load_scene(scene_file(name));
        if (!is_plain_name(scene.name))
            throw InputError(scene_file(name).string(), "/name",
                             "the scene's name is " + in_quotes(scene.name) +
                                 ", and files of a sweep are called by it; allowed are " +
                                 std::string(plain_name_rule));
        if (variants.size() == before) variants.push_back(variant_of(name, scene.name));
        if (balls == 0) continue;
        if (!scene.launcher && !has_field(name))
            throw InputError("--balls: scene '" + name + "' has neither a launcher nor a field of balls");
        variants.resize(before + 1);
        variants.back().name = scene.name + "-" + std::to_string(balls);
        variants.back().balls = balls;
    }
    require_different(variants);
    return variants;
}

std::shared_ptr<const Scene> load(const Variant& variant) {
    const auto file = scene_file(variant.scene);
    const bool field = variant.balls > 0 && has_field(variant.scene);
    return std::make_shared<const Scene>(field ? load_scene(file, variant.balls) : load_scene(file));
}

bool is_fired(const Variant& variant, const Scene& scene) {
    return variant.balls > 0 && scene.launcher && scene.balls.empty();
}

Script trajectory_script(const Variant& variant, const Scene& scene, Dice& dice) {
    const auto file = script_beside(scene_file(variant.scene));
    const Script own = file ? load_script(*file, scene) : Script{};
    const bool fired = is_fired(variant, scene);

    Script script;
    constexpr double first = 0.1,
                     weakest = 0.6;  // s; of full strength, so that the ball comes onto the table
    if (fired) script.push_back({first, control::Launch{dice.between(weakest, 1), 1, 1}});
    if (!scene.balls.empty()) {
        const double most = 5 * scene.balls.front().radius;
        script.push_back({0, control::Nudge{{dice.between(-most, most), dice.between(-most, most)}}});
    }
    const double skipped = fired && !own.empty() ? dice.below(0.5 * own.back().time) : 0;
    for (TimedControl timed : own) {
        auto* launch = std::get_if<control::Launch>(&timed.control);
        if (timed.time < skipped || (fired && launch != nullptr)) continue;
        timed.time -= skipped;
        if (launch != nullptr) launch->strength *= dice.between(0.9, 1);
        script.push_back(timed);
    }
    std::ranges::stable_sort(script, {}, &TimedControl::time);
    return script;
}

}  // namespace flipside::lab::sweep
