#pragma once
/// What an SVG file of the report shows, read back: its points, and where gnuplot put the labels of the axes.

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace flipside::lab::report {

struct DrawnPoint {
    std::string words;
    double x, y;  ///< px
};

inline std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

inline std::vector<DrawnPoint> points_of(const std::string& svg) {
    static const std::regex point(
        "<g class=\"point\"><title>([^<]*)</title>\\s*"
        "<use [^>]*translate\\(([-0-9.]+),([-0-9.]+)\\)");
    std::vector<DrawnPoint> points;
    for (std::sregex_iterator at(svg.begin(), svg.end(), point), end; at != end; ++at)
        points.push_back({(*at)[1], std::stod((*at)[2]), std::stod((*at)[3])});
    return points;
}

/// Places of the texts that are `words`.
inline std::vector<DrawnPoint> texts_of(const std::string& svg, const std::string& words) {
    const std::regex text("translate\\(([-0-9.]+),([-0-9.]+)\\)[^>]*>\\s*<text>(?:<tspan[^>]*>)?" + words +
                          "(?:</tspan>)?</text>");
    std::vector<DrawnPoint> found;
    for (std::sregex_iterator at(svg.begin(), svg.end(), text), end; at != end; ++at)
        found.push_back({words, std::stod((*at)[1]), std::stod((*at)[2])});
    return found;
}

}  // namespace flipside::lab::report
