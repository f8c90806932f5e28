/* An engine that declares sensors and cannot tell of what is in them. */

#include <stddef.h>

#include "flipside/engine.h"

static flipside_world* make(const flipside_scene* scene, const double* settings, char* why) {
    (void)scene, (void)settings, (void)why;
    return NULL;
}

static int step(flipside_world* world, const flipside_step* step, char* why) {
    (void)world, (void)step, (void)why;
    return 0;
}

static uint32_t balls(flipside_world* world, flipside_ball_state* out, uint32_t capacity) {
    (void)world, (void)out, (void)capacity;
    return 0;
}

const flipside_engine* flipside_engine_entry(void) {
    static const flipside_engine engine = {.size = sizeof engine,
                                           .version = FLIPSIDE_ENGINE_VERSION,
                                           .name = "mute",
                                           .features = FLIPSIDE_SEGMENTS | FLIPSIDE_SENSORS,
                                           .make = make,
                                           .step = step,
                                           .balls = balls};
    return &engine;
}
