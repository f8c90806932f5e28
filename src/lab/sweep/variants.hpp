#pragma once
/// What a sweep measures on: a scene with a number of balls, and how its windows are come by.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lab/scenes/dice.hpp"
#include "world/controls.hpp"

namespace flipside::lab::sweep {

/// A scene with a number of balls. Windows start between `from` and `until` of a trajectory.
struct Variant {
    std::string name;                ///< plain (plain_name.hpp) and stable, as in all files: "pinball-8"
    std::string scene;               ///< a name in assets/scenes or the path of a scene file
    int balls = 0;                   ///< fired by the launcher, or generated; 0: as scene and script say
    double from = 0, until = 10;     ///< s since the trajectory's start
    int shortest = 3, longest = 15;  ///< length of a window, in units of window_unit

    friend bool operator==(const Variant&, const Variant&) = default;
};
/// Windows last a whole number of these, s: so every step size that is swept divides them, and all engines
/// take equal steps.
inline constexpr double window_unit = 1.0 / 30;

/// pinball with 1 ball and with 8, toy, rain.
[[nodiscard]] std::vector<Variant> standard_variants();
/// The standard ones of these scenes (all where none is named), a plain one for any other scene; with
/// `balls` > 0 one for that number each. Throws InputError for unknown scenes, those that cannot have
/// another number of balls, those whose name is no plain one (plain_name.hpp) and two of the same name.
[[nodiscard]] std::vector<Variant> variants_of(const std::vector<std::string>& scenes, int balls);

/// Its balls come from the launcher: each from a launch of its own, all put on one table at once.
[[nodiscard]] bool is_fired(const Variant& variant, const Scene& scene);
/// The scene with the variant's balls, as far as they are generated.
[[nodiscard]] std::shared_ptr<const Scene> load(const Variant& variant);
/// Controls for one more trajectory of the variant, another one for each throw of the dice: the scene's own
/// script with launches of other strengths; where the variant says how many balls are fired, one launch in
/// place of the script's, and the rest of the script from another moment on. What lies on the table at the
/// start gets a nudge of up to 5 radii a second.
[[nodiscard]] Script trajectory_script(const Variant& variant, const Scene& scene, Dice& dice);

}  // namespace flipside::lab::sweep
