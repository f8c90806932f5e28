#pragma once
/// A scene: plain data of a table, independent of engines. The scene file reader checks everything
/// (scene_file.hpp), so engines may rely on these comments.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "world/ball.hpp"
#include "world/shape.hpp"

namespace flipside {

using PartIndex = std::uint32_t;

struct Material {
    std::string name;
    double restitution = 1;  ///< e ≥ 0; may exceed 1
    double friction = 0;     ///< µ ≥ 0
    double kick = 0;         ///< k ≥ 0, m/s: least outgoing normal speed after a hit
};

/// What happens between two surfaces.
struct Mixed {
    double restitution, friction, kick;
};
inline Mixed mix(const Material& a, const Material& b) {
    return {a.restitution * b.restitution, std::sqrt(a.friction * b.friction),
            a.kick > b.kick ? a.kick : b.kick};
}

enum class Side { left, right };

namespace motion {

struct Still {};
/// Turns about `pivot` at `rate` rad/s while rotation is switched on, or from the start if `always`.
struct Turn {
    Vec2 pivot;
    double rate = 0;
    bool always = false;
};
/// A flipper between its shape's rest angle and `raised` (rad), stopping dead at both. Rates in rad/s,
/// both > 0; the sense of turning is that of raised − rest. Only on a part whose shape is a flipper.
struct Flip {
    Side side = Side::left;
    double raised = 0;
    double up_rate = 0;
    double down_rate = 0;
};

}  // namespace motion

using Motion = std::variant<motion::Still, motion::Turn, motion::Flip>;

struct Part {
    std::string name;  ///< unique
    std::uint32_t material = 0;
    Shape shape;
    Motion motion;
    std::uint32_t layer = 1;            ///< one bit
    std::uint32_t collides_with = ~0U;  ///< mask of layers
    bool sensor = false;                ///< begin and end events, no response
    bool target = false;                ///< a drop target: gone after an impact until it is raised again
};

/// Layers meet when each is in the other's mask. Works on any two of Ball and Part.
template <class A, class B>
constexpr bool layers_meet(const A& a, const B& b) {
    return (a.layer & b.collides_with) != 0 && (b.layer & a.collides_with) != 0;
}

/// Where balls enter. A launch of strength s in [0, 1] leaves at slowest + s·(fastest − slowest).
struct Launcher {
    Vec2 position;
    Vec2 direction;                   ///< unit
    double slowest = 0, fastest = 0;  ///< m/s
    bool plunger = false;             ///< a ball that lies here already is fired instead of a new one added
    Ball ball;                        ///< radius, mass, material, layers; the rest is unused
};

/// The game played on the table, see lab/game/game.hpp.
struct Rules {
    struct Score {
        PartIndex part;
        int points;  ///< per impact, or per sensor-begin where the part is a sensor
    };
    struct Group {  ///< drop targets, or rollover lanes: when every one is hit, a bonus, and all reset
        std::vector<PartIndex> parts;
        int bonus;
        bool shift = false;  ///< of lanes: a raised flipper moves the lights towards its side
    };
    struct SkillShot {                 ///< the rollover that a new ball must pass first
        std::vector<PartIndex> parts;  ///< sensors, from left to right; one of them at a time is the one
        int bonus;
    };
    struct Multiball {
        int balls;        ///< in play, once every group of targets has been down
        double strength;  ///< 0…1, of the launches that bring them
        int jackpot;      ///< for each group of targets meanwhile
    };
    struct EndBonus {
        std::vector<Score> scores;  ///< points that each hit adds
        int most_times;             ///< it is paid once, and once more for each group of lanes, up to this
    };
    struct Spinner {
        PartIndex part;  ///< a sensor; a ball that passes at v m/s spins it v·turns_per_speed half turns
        int points;      ///< per half turn
        double turns_per_speed;
    };
    int balls = 3;
    double ball_save = 0;    ///< s after a new ball's launch during which it is given back if it drains
    double ball_search = 0;  ///< s that a ball may meet nothing before the table shakes it loose; 0: for ever
    int tilt_nudges = 3;     ///< this many nudges within tilt_seconds tilt the table
    double tilt_seconds = 3;
    std::vector<Score> scores;
    std::vector<Group> targets;
    std::vector<Group> lanes;
    std::vector<Spinner> spinners;
    std::optional<SkillShot> skill_shot;
    std::optional<Multiball> multiball;
    std::optional<EndBonus> end_bonus;
};

/// The most balls, and the most parts, of a scene.
inline constexpr std::size_t most_things = 1'000'000;

struct Scene {
    std::string name;
    std::string about;
    Box bounds;                ///< a ball whose centre leaves this box is lost
    bool keep_lost = false;    ///< a lost ball stays in the world (reported once) instead of being removed
    Vec2 gravity;              ///< m/s²
    double damping = 0;        ///< c ≥ 0, 1/s: v' = g − c·v
    double rest_speed = 0.01;  ///< ≥ 0, m/s: an approach slower than this has restitution 0 and no kick
    std::vector<Material> materials;  ///< [0] is the one of things that name none: e = 1, µ = 0, k = 0
    std::vector<std::string> layers;  ///< name of each layer bit; [0] is "default"
    std::vector<Ball> balls;          ///< numbered 0, 1, … in this order
    std::vector<Part> parts;
    std::optional<Launcher> launcher;
    std::optional<Rules> rules;
    std::optional<Box> camera;  ///< view of the window; the bounds if empty
    /// Recommended settings: engine → setting → value as on the command line. "run" holds "dt".
    std::map<std::string, std::map<std::string, std::string>> recommend;
    /// Where the scene was read, for messages: "FILE: " and the pointer to it in that file.
    std::string place;
    /// The scene file that it was read from, as JSON in one line; null for a scene that was made otherwise.
    /// Whoever changes the scene does not change this.
    std::shared_ptr<const std::string> document;
};

}  // namespace flipside
