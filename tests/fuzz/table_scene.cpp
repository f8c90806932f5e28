#include "fuzz/table_scene.hpp"

#include "world/scene_file.hpp"

namespace flipside::fuzz {

namespace {

constexpr const char* text = R"({
  "format": "flipside-scene/1", "name": "table", "gravity": [0, -2], "damping": 0.05,
  "bounds": {"min": [-1, -1], "max": [1, 1]},
  "materials": {"rubber": {"restitution": 0.8, "friction": 0.3}, "kicker": {"kick": 2}},
  "balls": [{"position": [-0.3, 0.5], "radius": 0.05, "mass": 0.1, "material": "rubber"},
            {"position": [0.1, 0.5], "velocity": [-1, 1], "radius": 0.05, "mass": 0.2, "layer": "upper"}],
  "launcher": {"position": [0.8, -0.7], "direction_deg": 95, "speed": [1, 4], "plunger": true,
               "ball": {"radius": 0.05, "mass": 0.1, "material": "rubber"}},
  "rules": {"balls": 2, "ball_save": 1, "tilt": {"nudges": 2, "seconds": 1}, "score": {"bumper": 10},
            "targets": [{"parts": ["drop-1", "drop-2"], "bonus": 50}], "lanes": [{"parts": ["lane"], "bonus": 5, "shift": true}],
            "ball_search": 0.5, "skill_shot": {"parts": ["lane"], "bonus": 7},
            "multiball": {"balls": 3, "strength": 1, "jackpot": 30},
            "end_bonus": {"points": {"bumper": 2, "drop-1": 3}, "most_times": 4},
            "spinners": [{"part": "lane", "points": 1, "turns_per_speed": 3}]},
  "parts": [
    {"name": "wall", "material": "rubber", "shape": {"type": "polyline", "points": [[-0.9, -0.9], [-0.9, 0.9], [0.9, 0.9], [0.9, -0.9]]}},
    {"name": "left", "shape": {"type": "flipper", "pivot": [-0.5, -0.5], "length": 0.35, "base_radius": 0.05, "tip_radius": 0.03, "rest_deg": -30},
     "motion": {"type": "flip", "side": "left", "raised_deg": 30, "up_rate": 20, "down_rate": 10}},
    {"name": "right", "shape": {"type": "flipper", "pivot": [0.5, -0.5], "length": 0.35, "base_radius": 0.05, "tip_radius": 0.03, "rest_deg": 210},
     "motion": {"type": "flip", "side": "right", "raised_deg": 150, "up_rate": 20, "down_rate": 10}},
    {"name": "vane", "shape": {"type": "segment", "a": [-0.1, 0], "b": [0.1, 0]}, "motion": {"type": "turn", "pivot": [0, 0], "rate": 4}},
    {"name": "bumper", "material": "kicker", "shape": {"type": "circle", "center": [-0.5, 0.2], "radius": 0.1}},
    {"name": "gate", "shape": {"type": "gate", "a": [0.6, 0.5], "b": [0.9, 0.5], "normal": [0, 1]}},
    {"name": "drop-1", "target": true, "shape": {"type": "segment", "a": [0.3, 0.2], "b": [0.4, 0.2]}},
    {"name": "drop-2", "target": true, "shape": {"type": "capsule", "a": [0.45, 0.2], "b": [0.55, 0.2], "radius": 0.02}},
    {"name": "lane", "sensor": true, "shape": {"type": "segment", "a": [-0.4, 0.4], "b": [0.2, 0.4]}},
    {"name": "shelf", "collides_with": ["upper"], "shape": {"type": "arc", "center": [0, 0.6], "radius": 0.3, "from_deg": 200, "to_deg": 340}}
  ]})";

}  // namespace

const std::shared_ptr<const Scene>& table_scene() {
    static const auto scene = std::make_shared<const Scene>(parse_scene(text, "table"));
    return scene;
}

}  // namespace flipside::fuzz
