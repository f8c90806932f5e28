#pragma once
/// The contenders in the report's own measurements: engines and solvers, each with its look in every figure.

#include <span>
#include <string>
#include <vector>

#include "lab/contenders/engines.hpp"
#include "lab/report/figure.hpp"

namespace flipside::lab::report {

struct Contender {
    std::string name;  ///< as the key shows it, and files are called
    std::string engine;
    std::string setting;  ///< what differs from the engine's defaults: "NAME=VALUE", or ""
    std::string colour;
    int dash, marker;
};

/// Those whose engine there is; engines of which no solver is listed take part as they come.
[[nodiscard]] std::vector<Contender> contenders();
/// Of an engine's lines; grey for one that is not here.
[[nodiscard]] std::string colour_of(std::string_view engine);
/// The settings that the scene recommends for it, and its own.
[[nodiscard]] Settings settings_of(const Contender& contender, const Scene& scene);
/// A series that looks like this contender, without points.
[[nodiscard]] Series series_of(const Contender& contender);

}  // namespace flipside::lab::report
