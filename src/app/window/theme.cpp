#include "app/window/theme.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace flipside::app {

sf::Color engine_colour(std::string_view engine) {
    if (engine == "custom") return {0x56, 0xb4, 0xe9};
    if (engine == "box2d") return {0xe6, 0x9f, 0x00};
    if (engine == "reference") return {0x00, 0x9e, 0x73};
    return {0xcc, 0x79, 0xa7};  // from a library
}

sf::Color with_alpha(sf::Color color, double alpha) {
    color.a = static_cast<sf::Uint8>(std::lround(color.a * std::clamp(alpha, 0.0, 1.0)));
    return color;
}

sf::Color blend(sf::Color a, sf::Color b, double t) {
    const auto mix = [t](sf::Uint8 from, sf::Uint8 to) {
        return static_cast<sf::Uint8>(std::lround(from + (to - from) * std::clamp(t, 0.0, 1.0)));
    };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), mix(a.a, b.a)};
}

FontFiles find_fonts() {
    static constexpr const char* folders[] = {"/usr/share/fonts/opentype/inter",
                                              "/usr/share/fonts/truetype/inter",
                                              "/usr/share/fonts/inter",
                                              "/usr/share/fonts/truetype/dejavu",
                                              "/usr/share/fonts/TTF",
                                              "/usr/share/fonts/dejavu-sans-fonts",
                                              "/usr/local/share/fonts",
                                              "/usr/share/fonts/dejavu"};
    static constexpr const char* faces[][2] = {{"Inter-Regular.otf", "Inter-SemiBold.otf"},
                                               {"Inter-Regular.ttf", "Inter-SemiBold.ttf"},
                                               {"DejaVuSans.ttf", "DejaVuSans-Bold.ttf"}};
    for (const auto& face : faces)
        for (const std::filesystem::path folder : folders)
            if (exists(folder / face[0]) && exists(folder / face[1]))
                return {folder / face[0], folder / face[1]};
    throw std::runtime_error("no font found: install the package fonts-inter or fonts-dejavu-core");
}

}  // namespace flipside::app
