#include "lab/report/contender.hpp"

#include <algorithm>

namespace flipside::lab::report {

std::vector<Contender> contenders() {
    std::vector<Contender> all{
        {"custom-continuous", "custom", "solver=continuous", std::string(colour::custom), 1, 7},
        {"custom-simple", "custom", "solver=simple", std::string(colour::custom), 3, 9},
        {"box2d", "box2d", "", std::string(colour::box2d), 1, 5}};
    constexpr std::string_view colours[] = {colour::blue, colour::wine, colour::olive};
    constexpr std::string_view listed[] = {"custom", "box2d", "reference"};
    std::size_t others = 0;
    for (const Engine* engine : engines_beside(listed)) {
        const std::string name(engine->name);
        const std::size_t look = others++ % std::size(colours);
        all.push_back({name, name, "", std::string(colours[look]), 2, 11 + static_cast<int>(look)});
    }
    all.push_back({"reference", "reference", "", std::string(colour::reference), 4, 9});
    std::erase_if(all, [](const Contender& contender) {
        return std::ranges::find(engines(), contender.engine, &Engine::name) == engines().end();
    });
    return all;
}

std::string colour_of(std::string_view engine) {
    for (const Contender& contender : contenders())
        if (contender.engine == engine) return contender.colour;
    return std::string(colour::grey);
}

Settings settings_of(const Contender& contender, const Scene& scene) {
    const Engine& engine = engine_named(contender.engine);
    if (contender.setting.empty()) return settings_for(engine, scene);
    const Engine* const used[] = {&engine};
    return settings_for(engine, scene, parse_changes({&contender.setting, 1}, used));
}

Series series_of(const Contender& contender) {
    return {contender.name, contender.colour, contender.dash, contender.marker, 0.8, true, {}};
}

}  // namespace flipside::lab::report
