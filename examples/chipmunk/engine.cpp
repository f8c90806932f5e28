/// Chipmunk 7 behind flipside/engine.h.
///
/// What it supports: everything that a scene may need. Arcs are chords (setting chord_error); there is no
/// continuous collision, so fast balls need sub-steps; it saves nothing beside the balls.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iterator>
#include <string>

#include "space.hpp"

using flipside_chipmunk::Options;
using flipside_chipmunk::Space;

struct flipside_world {
    Space space;
};

namespace {

flipside_world* make(const flipside_scene* scene, const double* settings, char* why) {
    try {
        const Options options{static_cast<int>(settings[0]), static_cast<int>(settings[1]), settings[2],
                              settings[3], settings[4]};
        return new flipside_world{{*scene, options}};
    } catch (const std::exception& problem) {
        std::snprintf(why, FLIPSIDE_WHY, "%s", problem.what());
        return nullptr;
    }
}

void destroy(flipside_world* world) {
    delete world;
}

int step(flipside_world* world, const flipside_step* step, char* why) {
    try {
        world->space.step(*step);
        return 0;
    } catch (const std::exception& problem) {
        std::snprintf(why, FLIPSIDE_WHY, "%s", problem.what());
        return 1;
    }
}

uint32_t balls(flipside_world* world, flipside_ball_state* out, uint32_t capacity) {
    uint32_t count = 0;
    for (const auto& [number, ball] : world->space.balls()) {
        if (count < capacity) {
            const cpVect position = cpBodyGetPosition(ball.body), velocity = cpBodyGetVelocity(ball.body);
            out[count] = {number,
                          0,
                          flipside_chipmunk::vec(position),
                          flipside_chipmunk::vec(velocity),
                          cpBodyGetAngle(ball.body),
                          cpBodyGetAngularVelocity(ball.body)};
        }
        ++count;
    }
    return count;
}

template <class T>
uint32_t copy(const std::vector<T>& list, T* out, uint32_t capacity) {
    if (list.size() <= capacity) std::copy(list.begin(), list.end(), out);
    return static_cast<uint32_t>(list.size());
}

uint32_t events(flipside_world* world, flipside_event* out, uint32_t capacity) {
    return copy(world->space.events(), out, capacity);
}

uint32_t contacts(flipside_world* world, flipside_contact* out, uint32_t capacity) {
    return copy(world->space.contacts(), out, capacity);
}

int control(flipside_world* world, const flipside_control* control) {
    try {
        return world->space.control(*control) ? 0 : 1;
    } catch (const std::exception&) {
        return 1;
    }
}

constexpr flipside_setting integer(const char* name, const char* about, double initial) {
    return {name, "", about, FLIPSIDE_INTEGER, 0, nullptr, initial, 1, 1000};
}
constexpr flipside_setting real(const char* name, const char* unit, const char* about, double initial,
                                double min, double max) {
    return {name, unit, about, FLIPSIDE_REAL, 0, nullptr, initial, min, max};
}

const flipside_setting settings[] = {
    integer("iterations", "passes of the solver per sub-step; too few leave heaps soft", 10),
    integer("substeps",
            "equal parts each step is cut into; there is no continuous collision, so fast balls need them",
            4),
    real("slop", "radii", "overlap that is left alone, of the smallest ball; too small makes heaps tremble",
         0.01, 0, 1),
    real("bias", "", "share of an overlap that is left after a second; too small throws balls apart", 0.0018,
         0, 1),
    real("chord_error", "m", "how far the chords that stand for an arc may stray from it", 2e-5, 1e-8, 1),
};

}  // namespace

const flipside_engine* flipside_engine_entry(void) {
    static const std::string library = std::string("Chipmunk ") + cpVersionString;
    static const flipside_engine engine = {
        .size = sizeof(flipside_engine),
        .version = FLIPSIDE_ENGINE_VERSION,
        .name = "chipmunk",
        .about = "double precision, time stepping with an iterative solver, no continuous collision",
        .library = library.c_str(),
        .features = FLIPSIDE_POINTS | FLIPSIDE_SEGMENTS | FLIPSIDE_ARCS | FLIPSIDE_CIRCLES |
                    FLIPSIDE_POLYGONS | FLIPSIDE_TAPERS | FLIPSIDE_BALL_PAIRS | FLIPSIDE_FRICTION |
                    FLIPSIDE_KICKS | FLIPSIDE_DAMPING | FLIPSIDE_MOVING | FLIPSIDE_SENSORS | FLIPSIDE_LAYERS |
                    FLIPSIDE_GATES,
        .settings = settings,
        .setting_count = std::size(settings),
        .reserved = 0,
        .make = make,
        .step = step,
        .balls = balls,
        .destroy = destroy,
        .events = events,
        .contacts = contacts,
        .control = control,
        .save = nullptr,
        .restore = nullptr,
    };
    return &engine;
}
