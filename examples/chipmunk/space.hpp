#pragma once
/// A Flipside scene in a Chipmunk space. Metres are Chipmunk's units; everything else of the library is as it
/// comes, but for what a setting says.

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <chipmunk/chipmunk.h>

#include "flipside/engine.h"

namespace flipside_chipmunk {

struct Options {
    int iterations, substeps;
    double slop;         ///< overlap that is left alone, radii of the smallest ball
    double bias;         ///< share of an overlap that is left after a second
    double chord_error;  ///< m
};

/// What a shape belongs to.
struct Tag {
    bool is_ball = false;
    std::uint32_t index = 0;  ///< number of a ball or index of a part
};

struct Part {
    flipside_part is;
    cpBody* body = nullptr;
    std::vector<cpShape*> shapes;
    bool open = false;  ///< of a gate
};

struct Body {
    flipside_ball is;
    cpBody* body = nullptr;
    cpShape* shape = nullptr;
};

/// A ball and what it meets: two balls (the lower number first), or a ball and a part.
struct Pair {
    std::uint32_t ball = 0;
    bool with_ball = false;
    std::uint32_t other = 0;

    friend auto operator<=>(const Pair&, const Pair&) = default;
};

struct FreeSpace {
    void operator()(cpSpace* space) const { cpSpaceFree(space); }
};

class Space {
  public:
    Space(const flipside_scene& scene, const Options& options);
    Space(const Space&) = delete;
    Space& operator=(const Space&) = delete;
    ~Space();

    void step(const flipside_step& step);
    /// False where the space must be made anew.
    bool control(const flipside_control& control);

    [[nodiscard]] const std::map<std::uint32_t, Body>& balls() const { return balls_; }
    [[nodiscard]] const std::vector<flipside_event>& events() const { return events_; }
    [[nodiscard]] const std::vector<flipside_contact>& contacts() const { return contacts_; }

  private:
    // shapes.cpp
    void add_primitive(const flipside_primitive& primitive, const flipside_scene& scene);
    void add_arc(const flipside_primitive& primitive);
    void add_taper(const flipside_primitive& primitive);
    void add_segment(const flipside_primitive& primitive, cpVect before, cpVect a, cpVect b, cpVect after);
    void add_shape(std::uint32_t part, cpShape* shape);
    void add_ball(const flipside_ball& ball);
    void remove_ball(std::uint32_t number);
    [[nodiscard]] cpVect local(std::uint32_t part, flipside_vec p) const;

    // rules.cpp
    void listen();
    [[nodiscard]] bool begin(cpArbiter* arbiter);
    [[nodiscard]] bool before_solve(cpArbiter* arbiter);
    void after_solve(cpArbiter* arbiter);
    void separate(cpArbiter* arbiter);
    void meet_gate(const Pair& pair);
    void leave_gate(const Pair& pair);
    void look_for_contacts();
    void report_touches();
    void report(flipside_event_kind kind, const Pair& pair, cpVect point = cpvzero, cpVect normal = cpvzero,
                double speed = 0, double impulse = 0);

    Options options_;
    double rest_speed_;
    std::unique_ptr<cpSpace, FreeSpace> space_;
    std::vector<flipside_material> materials_;
    std::vector<Part> parts_;
    std::map<std::uint32_t, Body> balls_;
    std::deque<Tag> tags_;  ///< of shapes; Chipmunk points at them

    double now_ = 0;                       ///< s, of what is reported
    std::map<Pair, int> touching_;         ///< of sensors and gates: how many shapes of the part
    std::map<Pair, bool> blocked_;         ///< of gates: whether the ball is not let through
    std::map<Pair, flipside_event> hits_;  ///< of the sub-step
    std::vector<Pair> held_;               ///< touches that were reported as begun
    std::vector<flipside_event> events_, between_steps_;
    bool in_step_ = false;
    std::vector<flipside_contact> contacts_;
};

[[nodiscard]] inline cpVect vec(flipside_vec v) {
    return cpv(v.x, v.y);
}
[[nodiscard]] inline flipside_vec vec(cpVect v) {
    return {v.x, v.y};
}

}  // namespace flipside_chipmunk
