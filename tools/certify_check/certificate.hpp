#pragma once
/// A certificate as its file states it; assets/certificate.schema.json says what each name means. SI units.

#include <array>
#include <istream>
#include <stdexcept>
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
struct Part {
    std::string name;
    unsigned material, layer, collides_with;
    Vec gate, pivot;
    std::vector<Span> turns;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Part, name, material, layer, collides_with, gate, pivot, turns)
};
struct Feature {
    unsigned part;
    std::string type;
    std::vector<Vec> points;
    double radius;
    bool wide;
    std::array<bool, 2> joined;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Feature, part, type, points, radius, wide, joined)
};
struct Leg {
    std::string why;
    unsigned met, met_leg;
    int held;
    double within, start, spin_before, drag, spin, end = 0;  // end: the start of the next
    Vec velocity_before, normal, position, velocity, acceleration, roll;
    std::vector<Vec> displacements;
    std::vector<double> spins;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Leg, why, met, met_leg, held, within, start, spin_before, drag, spin,
                                   velocity_before, normal, position, velocity, acceleration, roll,
                                   displacements, spins)
};
struct Ball {
    int number;
    unsigned material, layer, collides_with;
    double radius, mass;
    std::vector<Leg> legs;
    std::vector<double> gone;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Ball, number, material, layer, collides_with, radius, mass, legs, gone)
};
struct Input {
    double time;
    int ball;
    Vec velocity;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Input, time, ball, velocity)
};
struct Absence {
    unsigned part;
    int ball;
    double from, until;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Absence, part, ball, from, until)
};
struct Force {
    int ball, other;
    unsigned feature;
    double normal, friction;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Force, ball, other, feature, normal, friction)
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
    std::vector<Feature> features;
    std::vector<Input> inputs;
    std::vector<Absence> absences;
    std::vector<Rest> rests;
    std::vector<Ball> balls;
    NLOHMANN_DEFINE_TYPE_INTRUSIVE(Run, format, ends, seconds, damping, rest_speed, gravity, least, most,
                                   materials, parts, features, inputs, absences, rests, balls)
};

inline Run read(std::istream& file) {
    Run run = nlohmann::json::parse(file).get<Run>();
    if (run.format != "flipside-certificate/3") throw std::runtime_error("it is no flipside-certificate/3");
    for (const Feature& feature : run.features)
        if (feature.type != "line" && feature.type != "arc" && feature.type != "round")
            throw std::runtime_error("a feature is a " + feature.type);
    for (Ball& ball : run.balls) {
        if (!(ball.radius > 0 && ball.mass > 0 && !ball.legs.empty()))
            throw std::runtime_error("a ball has no size, mass or segment");
        for (std::size_t i = 0; i < ball.legs.size(); ++i) {
            Leg& leg = ball.legs[i];
            const double last = ball.gone.empty() ? run.seconds : ball.gone[0];
            leg.end = i + 1 < ball.legs.size() ? ball.legs[i + 1].start : last;
            if (!(leg.start <= leg.end)) throw std::runtime_error("a segment ends before it starts");
        }
    }
    return run;
}

/// The first condition that does not hold.
struct Rejected : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What is counted. `touches` are without approach and change nothing; not isolated are grazes.
struct Verdict {
    std::size_t legs, held, resting, impacts, touches, not_isolated, given, enclosures;
    double loosest;  // radii; the largest gap or overlap of what rests
};

}  // namespace certificate
