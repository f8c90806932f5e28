#pragma once
/// The contenders of a sweep: engines and solvers, at their defaults and tuned, libraries, and contenders
/// that a user defines. The list of those built in is data; a name stays with its meaning for ever, for it is
/// what files of different sweeps are merged by.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lab/contenders/contender.hpp"
#include "lab/contenders/engines.hpp"

namespace flipside::lab::sweep {

struct Contender {
    std::string_view name;
    std::string_view engine;
    std::string_view settings;  ///< what differs from the engine's defaults: "a=1 b=2", see settings_of
    int coarsest, finest;       ///< steps per second; every doubling from one to the other is swept
    std::string_view about;     ///< one line
};
inline constexpr int coarsest_steps = 30, finest_steps = 7680;  ///< per second

/// Those that are built in.
[[nodiscard]] std::span<const Contender> contenders();
/// And after them the libraries that were loaded, each by its name.
[[nodiscard]] std::vector<const Contender*> all_contenders();
/// Adds one that a user defines, swept at its own step if it names one, and else at all. It stays known by
/// its name. Throws InputError for a name that another contender has, and for a step that is not 1/n s, where
/// n is a multiple of 30 up to 7,680.
const Contender& add_contender(const ContenderRequest& request);
/// The same as a plan describes it. Throws InputError for an engine that is not known yet, settings that it
/// does not have, and steps that make no whole number in 1/30 s.
const Contender& add_contender(const std::string& name, const std::string& engine,
                               const std::string& settings, int coarsest, int finest,
                               const std::string& about);
/// Null for an unknown name.
[[nodiscard]] const Contender* find_contender(std::string_view name);
/// By its name, or by the path of a library, which is loaded. Throws InputError for an unknown one.
[[nodiscard]] const Contender& contender_named(std::string_view name);
/// The engine's defaults, what the scene recommends, and the contender's own settings.
[[nodiscard]] Settings settings_of(const Contender& contender, const Scene& scene);

}  // namespace flipside::lab::sweep
