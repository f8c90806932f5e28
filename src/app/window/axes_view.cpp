// Separating axes: each is drawn beside the two shapes, on the left of its direction, as a line with the
// shadow of the part and, next to it, that of the ball. The picked one is bold and has words; of the others
// only the shadows are seen, faintly: which axis decides is for the reader to find.

#include <algorithm>

#include "app/window/constructions.hpp"

namespace flipside::app {

namespace {

/// The polygon and the ball, as the item that concludes the test has them.
struct TestedPair {
    std::vector<Vec2> outline;
    Vec2 center;
    double radius = 0;

    /// How far they reach in a direction, m from the world's origin.
    [[nodiscard]] double reach(Vec2 direction) const {
        double most = dot(center, direction) + radius;
        for (const Vec2 corner : outline) most = std::max(most, dot(corner, direction));
        return most;
    }
};

TestedPair pair_of(const TraceStage& stage, std::int64_t turn) {
    TestedPair pair;
    for (const TraceItem& item : stage.items) {
        if (item.kind != "closest" || item.get<std::int64_t>("turn") != turn) continue;
        const auto& flat = item.get<std::vector<double>>("outline");
        for (std::size_t i = 0; i + 1 < flat.size(); i += 2) pair.outline.push_back({flat[i], flat[i + 1]});
        pair.center = item.get<Vec2>("center");
        pair.radius = item.get<double>("radius");
    }
    return pair;
}

void draw_axis(const Construction& drawn, const TraceItem& axis, const TestedPair& pair, bool picked) {
    const Vec2 along = axis.get<Vec2>("axis"), across = perp(along);
    const auto &part = axis.get<std::vector<double>>("shadow_of_part"),
               &ball = axis.get<std::vector<double>>("shadow_of_ball");
    const double depth = axis.get<double>("depth");
    const bool decides = axis.get<bool>("decides"), gap = depth < 0;
    const double base = pair.reach(across) + drawn.metres(22), next = drawn.metres(8);
    const auto place = [&](double s, double height) { return s * along + (base + height) * across; };
    const double weight = picked ? 1 : 0.25;
    drawn.line(place(std::min(part[0], ball[0]) - drawn.metres(14), 0),
               place(std::max(part[1], ball[1]) + drawn.metres(14), 0), 1,
               with_alpha(colour::quiet, 0.5 * weight));
    drawn.line(place(part[0], 0), place(part[1], 0), picked ? 6 : 2, with_alpha(colour::part, weight));
    drawn.line(place(ball[0], next), place(ball[1], next), picked ? 6 : 2, with_alpha(drawn.color, weight));
    if (!picked) return;
    const sf::Color verdict = gap ? colour::warning : colour::lit;
    drawn.line(place(ball[0], 2 * next), place(part[1], 2 * next), 4, verdict);
    for (const double s : {ball[0], part[1]})
        drawn.line(place(s, 0), s * along - pair.reach(-across) * across, 1, with_alpha(verdict, 0.5));
    const std::string words = axis.get<std::string>("of") + (gap ? ": gap " : ": overlap ") +
                              short_length(std::abs(depth)) +
                              (decides ? gap ? ", they are apart" : ", the smallest" : "");
    drawn.word(place(0.5 * (ball[0] + part[1]), 2 * next), across, 6, words, verdict, Type::large);
}

}  // namespace

void draw_axes(const Construction& drawn) {
    const auto turn = drawn.item.get<std::int64_t>("turn");
    const TestedPair pair = pair_of(drawn.stage, turn);
    // The picked one last, above the others.
    for (const bool picked : {false, true})
        for (const TraceItem& item : drawn.stage.items)
            if (item.kind == "axis" && item.get<std::int64_t>("turn") == turn &&
                (&item == &drawn.item) == picked)
                draw_axis(drawn, item, pair, picked);
}

}  // namespace flipside::app
