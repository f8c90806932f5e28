#pragma once
/// A contender: an engine with its settings and its step. The same engine may
/// take part more than once.

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lab/session/run_settings.hpp"

namespace flipside::lab {

struct Contender {
    const Engine* engine = nullptr;
    Settings settings;
    std::string name = {};     ///< told apart from the others by it; the engine's where nothing else is said
    double dt = default_step;  ///< s
};

/// A contender before the scene is known.
struct ContenderRequest {
    std::string name;
    const Engine* engine = nullptr;
    std::optional<double> dt;  ///< s; nothing: the step of the run
    std::vector<std::pair<std::string, std::string>> set;
};

/// An engine as itself.
[[nodiscard]] ContenderRequest plain_contender(const Engine& engine);
/// "NAME=ENGINE[,dt=1/240][,K=V]...", one each; a NAME is a plain name (plain_name.hpp). Throws InputError
/// for a text of another form, an unknown engine, a setting that it does not have or a value that is not
/// allowed, and for a name that is there twice.
[[nodiscard]] std::vector<ContenderRequest> parse_contenders(std::span<const std::string> texts);
/// With the engine's defaults, what the scene recommends, then `changes` of this engine, then its own
/// settings.
[[nodiscard]] Contender contender_for(const ContenderRequest& request, const Scene& scene, double dt,
                                      std::span<const SettingChange> changes = {});
/// A text from which parse_contenders and contender_for make it again on a scene.
[[nodiscard]] std::string text_of(const Contender& contender, const Scene& scene);
/// `name`, or the first of "name-2", "name-3", ... that none of them has.
[[nodiscard]] std::string free_name(const std::string& name, std::span<const ContenderRequest> taken);

/// All of them meet at the end of every step of the longest; so the others' must divide it, to 1e-9 of it.
/// Throws InputError that names the one whose step does not. Needs at least one.
[[nodiscard]] double common_step(std::span<const Contender> contenders);

}  // namespace flipside::lab
