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
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Material, restitution, friction, kick)
};
struct Span {
    double since, angle, rate;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Span, since, angle, rate)
};
struct Change {
    double time;
    bool down;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Change, time, down)
};
struct Part {
    std::string name;
    std::size_t material;
    unsigned layer, collides_with;
    bool sensor;
    Vec gate, pivot;
    std::vector<Span> turns;
    std::vector<Change> target;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Part, name, material, layer, collides_with, sensor, gate, pivot, turns,
                                   target)
};
struct Primitive {
    std::size_t part;
    std::string type;
    std::vector<Vec> points;
    std::vector<double> radii, angles;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Primitive, part, type, points, radii, angles)
};
struct Leg {
    std::string why;
    std::size_t met;
    std::int64_t held;
    double within, start, end = 0, spin_before, drag, spin;  ///< end: the start of the next
    Vec velocity_before, normal, position, velocity, acceleration, roll;
    std::vector<Vec> displacements;
    std::vector<double> spins;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Leg, why, met, held, within, start, spin_before, drag, spin,
                                   velocity_before, normal, position, velocity, acceleration, roll,
                                   displacements, spins)
};
struct Ball {
    std::size_t number, material;
    double radius, mass;
    unsigned layer, collides_with;
    std::vector<Leg> legs;
    std::vector<double> gone;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Ball, number, material, radius, mass, layer, collides_with, legs, gone)
};
struct Input {
    double time;
    std::int64_t ball;
    Vec velocity;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Input, time, ball, velocity)
};
struct Passage {
    std::size_t ball, gate;
    double from, until;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Passage, ball, gate, from, until)
};
struct Force {
    std::size_t ball, primitive;
    std::int64_t other;
    double normal, friction;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Force, ball, primitive, other, normal, friction)
};
struct Rest {
    double from, until;
    std::vector<Force> forces;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Rest, from, until, forces)
};
struct Run {
    std::string format, ends;
    double seconds, damping, rest_speed;
    Vec gravity, least, most;
    std::vector<Material> materials;
    std::vector<Part> parts;
    std::vector<Primitive> primitives;
    std::vector<Input> inputs;
    std::vector<Passage> passages;
    std::vector<Rest> rests;
    std::vector<Ball> balls;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Run, format, ends, seconds, damping, rest_speed, gravity, least, most,
                                   materials, parts, primitives, inputs, passages, rests, balls)
};

}  // namespace certificate
