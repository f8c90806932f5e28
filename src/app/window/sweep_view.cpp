// Swept paths: the band that a ball covers on its way, and where and when that ends.

#include "app/window/constructions.hpp"

namespace flipside::app {

namespace {

constexpr std::pair<const char*, const char*> end_times[] = {
    {"time_of_impact", " after the start of the step"}, {"time", ""}, {"next_time", ""}};

/// When, and what happens then.
std::string end_of_sweep(const Construction& drawn) {
    std::string words;
    for (const char* name : {"event", "next"})
        if (const auto* what = drawn.value<std::string>(name); what != nullptr && words.empty())
            words = *what + " ";
    for (const auto& [name, of_what] : end_times)
        if (const auto* time = drawn.value<double>(name)) {
            const bool late = of_what[0] != 0;
            return words + (late ? "time of impact " : "at ") +
                   (late ? brief(1e3 * *time) + " ms" : brief(*time) + " s") + of_what;
        }
    return words.empty() ? "" : words.substr(0, words.size() - 1);
}

void draw_band(const Construction& drawn, const std::vector<double>& flat, double radius, sf::Color color) {
    std::vector<Vec2> left, right, middle;
    for (std::size_t i = 0; i + 1 < flat.size(); i += 2) middle.push_back({flat[i], flat[i + 1]});
    if (middle.size() < 2 || middle.front() == middle.back()) return;
    for (std::size_t i = 0; i < middle.size(); ++i) {
        const Vec2 along = middle[std::min(i + 1, middle.size() - 1)] - middle[i > 0 ? i - 1 : 0];
        const Vec2 across = length_squared(along) > 0 ? radius * unit(perp(along)) : Vec2{};
        left.push_back(drawn.at(middle[i] + across));
        right.push_back(drawn.at(middle[i] - across));
    }
    for (std::size_t i = 1; i < left.size(); ++i) {
        const Vec2 patch[] = {left[i - 1], left[i], right[i], right[i - 1]};
        drawn.canvas.fill(patch, with_alpha(color, 0.18));
    }
    for (Vec2& point : middle) point = drawn.at(point);
    drawn.canvas.stroke(left, false, drawn.canvas.scaled(1), with_alpha(color, 0.6));
    drawn.canvas.stroke(right, false, drawn.canvas.scaled(1), with_alpha(color, 0.6));
    drawn.canvas.stroke(middle, false, drawn.canvas.scaled(1.5), color);
    drawn.canvas.ring(middle.front(), drawn.camera.scale * radius, drawn.canvas.scaled(1),
                      with_alpha(colour::quiet, 0.8));
    drawn.canvas.ring(middle.back(), drawn.camera.scale * radius, drawn.canvas.scaled(2), color);
}

/// The gap to what will be met, as a line across it.
void draw_gap(const Construction& drawn) {
    const auto* gap = drawn.value<double>("gap");
    const auto* flat = drawn.value<std::vector<double>>("gap_line");
    if (gap == nullptr || flat == nullptr || flat->size() < 4) return;
    const Vec2 rim{(*flat)[0], (*flat)[1]}, met{(*flat)[2], (*flat)[3]};
    drawn.line(rim, met, 3, colour::warning);
    drawn.canvas.disc(drawn.at(met), drawn.canvas.scaled(3), colour::warning);
    const Vec2 away = rim == met ? Vec2{0, 1} : unit(met - rim);
    drawn.word(met, away, 8, "gap " + short_length(*gap), colour::warning, Type::large);
}

}  // namespace

void draw_sweep(const Construction& drawn, double radius, double other_radius) {
    const auto* path = drawn.value<std::vector<double>>("swept");
    if (path == nullptr || path->size() < 4) return;
    draw_band(drawn, *path, radius, drawn.color);
    draw_gap(drawn);
    if (const auto* other = drawn.value<std::vector<double>>("other_swept"))
        draw_band(drawn, *other, other_radius, colour::quiet);
    const Vec2 end{(*path)[path->size() - 2], path->back()};
    // On the side from which it came, where it meets nothing.
    const double from = (*path)[1] > end.y ? 1 : -1;
    drawn.word(end + Vec2{0, from * radius}, {0, from}, 6, end_of_sweep(drawn), colour::lit);
}

}  // namespace flipside::app
