#pragma once
/// Who takes part in a sweep: engines and solvers, at their defaults and tuned. This list is data; a name
/// stays with its meaning for ever, for it is what files of different sweeps are merged by.

#include <span>
#include <string>
#include <string_view>
#include <vector>

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
/// By its name, or by the path of a library, which is loaded. Throws InputError for an unknown one.
[[nodiscard]] const Contender& contender_named(std::string_view name);
/// The engine's defaults, what the scene recommends, and the contender's own settings.
[[nodiscard]] Settings settings_of(const Contender& contender, const Scene& scene);

}  // namespace flipside::lab::sweep
