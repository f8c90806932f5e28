#pragma once
/// How far an engine holds: in each of these experiments one number grows until the engine breaks. Balls have
/// a radius of 0.1 m and lie in a closed box, so that everything can be judged by where they are, whatever
/// the engine says of its contacts.
///
/// A run holds when every ball stays inside the box and a number, no ball overlaps a wall or another ball by
/// more than a tenth of a radius at the end of any step, balls that cannot pass each other do not, and the
/// energy does not rise by more than 1 % (without losses it must not change by more than a tenth, so
/// that balls are not slowed down).

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lab/contenders/contender.hpp"

namespace flipside::lab {

/// One experiment at one value.
struct BorderRun {
    Scene scene;
    Box walls;  ///< the box
    double dt = default_step, seconds = 2;
    bool is_lane = false;     ///< balls cannot pass each other: by their numbers from left to right
    bool is_elastic = false;  ///< nothing takes energy
};
struct Border {
    std::string_view name;   ///< as files have it
    std::string_view title;  ///< what grows, with its unit, in few words
    std::string_view about;  ///< what happens, in a sentence
    std::vector<double> ladder;
    BorderRun (*make)(double value);
};
[[nodiscard]] std::span<const Border> borders();

/// What became of one value.
struct BorderPoint {
    std::string_view border;
    double value = 0;
    std::string failure;  ///< "" where it holds
};
/// As `most` of find_borders(): no limit.
inline constexpr std::size_t whole_ladders = ~std::size_t{0};
/// Border by border, value by value until the first at which the contender does not hold, `most` of them at
/// most. Steps are those of the experiments. `watch` is called after each with the part done, 0 … 1.
[[nodiscard]] std::vector<BorderPoint> find_borders(const Contender& contender, std::size_t most,
                                                    const std::function<void(double)>& watch);

}  // namespace flipside::lab
