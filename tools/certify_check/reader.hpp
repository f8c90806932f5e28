#pragma once
/// A certificate as its file states it: the names are the file's (assets/certificate.schema.json says what
/// they mean). SI units; seconds since it began.

#include <array>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace certificate {

using Vec = std::array<double, 2>;

struct Material {
    double restitution, friction, kick;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Material, restitution, friction, kick)

struct Span {
    double since, angle, rate;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Span, since, angle, rate)

struct Change {
    double time;
    bool down;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Change, time, down)

struct Part {
    std::string name;
    std::size_t material;
    unsigned layer, collides_with;
    bool sensor;
    Vec gate;  ///< its normal; 0 where it is none
    Vec pivot;
    std::vector<Span> turns;  ///< none: stands still
    std::vector<Change> target;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Part, name, material, layer, collides_with, sensor, gate, pivot, turns,
                                   target)

struct Primitive {
    std::size_t part;
    std::string type;
    std::vector<Vec> points;
    std::vector<double> radii, angles;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Primitive, part, type, points, radii, angles)

struct Leg {
    std::string why, form;
    std::size_t met;
    double within, start, end = 0, spin_before, drag, spin, spin_rate;
    Vec velocity_before, normal, position, velocity, acceleration, roll;
    std::vector<Vec> displacements;
    std::vector<double> spins;
    std::vector<std::size_t> held;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Leg, why, form, met, within, start, spin_before, drag, spin, spin_rate,
                                   velocity_before, normal, position, velocity, acceleration, roll,
                                   displacements, spins, held)

struct Ball {
    std::size_t number, material;
    double radius, mass;
    unsigned layer, collides_with;
    std::vector<Leg> legs;
    std::vector<double> gone;  ///< when it left, if it did
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Ball, number, material, radius, mass, layer, collides_with, legs, gone)

struct Input {
    double time;
    std::int64_t ball;  ///< −1: all of them are nudged by the velocity
    Vec velocity;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Input, time, ball, velocity)

struct Passage {
    std::size_t ball, gate;
    double from, until;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Passage, ball, gate, from, until)

struct Run {
    std::string format, scene, ends;
    double seconds, damping, rest_speed;
    Vec gravity, least, most;  ///< least, most: the bounds
    std::vector<Material> materials;
    std::vector<Part> parts;
    std::vector<Primitive> primitives;
    std::vector<Input> inputs;
    std::vector<Passage> passages;
    std::vector<Ball> balls;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Run, format, scene, ends, seconds, damping, rest_speed, gravity, least,
                                   most, materials, parts, primitives, inputs, passages, balls)

/// Throws std::exception that says what is wrong.
[[nodiscard]] Run read(const std::string& file);

}  // namespace certificate
