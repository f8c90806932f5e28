#pragma once
/// What the tests of files share.

#include <string>

#include <gtest/gtest.h>

#include "world/input_error.hpp"
#include "world/scene_file.hpp"

namespace flipside {

/// The message of the InputError that `run` throws.
inline std::string error_of(auto&& run) {
    try {
        run();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

inline void expect_error(const std::string& error, const std::string& start, const std::string& says) {
    EXPECT_TRUE(error.starts_with(start)) << error << "\n  should start with\n" << start;
    EXPECT_NE(error.find(says), std::string::npos) << error << "\n  should say\n" << says;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
}

/// A scene with one of everything that a state or script can speak of.
inline Scene scene_with_everything() {
    return parse_scene(R"({
        "format": "flipside-scene/1", "name": "everything",
        "bounds": {"min": [-1, -1], "max": [1, 1]},
        "materials": {"steel": {"restitution": 0.9, "friction": 0.1}, "rubber": {"restitution": 0.5}},
        "balls": [{"position": [0, 0], "radius": 0.01, "mass": 0.08, "material": "steel"}],
        "parts": [
            {"name": "wall", "shape": {"type": "segment", "a": [-1, -1], "b": [1, -1]}},
            {"name": "bat", "shape": {"type": "flipper", "pivot": [0.5, 0], "length": 0.1,
             "base_radius": 0.02, "tip_radius": 0.01, "rest_deg": -30},
             "motion": {"type": "flip", "side": "left", "raised_deg": 30, "up_rate": 20, "down_rate": 10}},
            {"name": "fan", "shape": {"type": "segment", "a": [0, 0.4], "b": [0, 0.6]},
             "motion": {"type": "turn", "pivot": [0, 0.5], "rate": 3}},
            {"name": "gate", "shape": {"type": "gate", "a": [-0.5, 0], "b": [-0.4, 0], "normal": [0, 1]}},
            {"name": "drop 1", "target": true, "shape": {"type": "circle", "center": [-0.2, 0], "radius": 0.01}},
            {"name": "drop 2", "target": true, "shape": {"type": "circle", "center": [-0.3, 0], "radius": 0.01}}],
        "launcher": {"position": [0.9, -0.9], "direction_deg": 90, "speed": [1, 3],
                     "ball": {"radius": 0.01, "mass": 0.08, "material": "rubber"}}})",
                       "everything.json");
}

}  // namespace flipside
