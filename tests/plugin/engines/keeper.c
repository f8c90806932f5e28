/* An engine whose balls are pushed at random, so that it has something to save: the state of its generator.
 * It follows controls, and counts its worlds in the spin of every ball: 1 in the first, 2 in the second. */

#include <stdlib.h>
#include <string.h>

#include "flipside/engine.h"

enum { ROOM = 16 };

struct flipside_world {
    flipside_ball_state balls[ROOM];
    uint32_t count;
    uint64_t random;
};

static int worlds;

static flipside_world* make(const flipside_scene* scene, const double* settings, char* why) {
    (void)settings;
    (void)why;
    flipside_world* world = calloc(1, sizeof *world);
    ++worlds;
    for (uint32_t i = 0; i < scene->ball_count && i < ROOM; ++i) {
        world->balls[i] = scene->balls[i].state;
        world->balls[i].spin = worlds;
    }
    world->count = scene->ball_count;
    world->random = 1;
    return world;
}

static int step(flipside_world* world, const flipside_step* step, char* why) {
    (void)why;
    for (uint32_t i = 0; i < world->count; ++i) {
        world->random = world->random * 6364136223846793005u + 1442695040888963407u;
        world->balls[i].velocity.x += (double)(world->random >> 40) * 1e-9;
        world->balls[i].position.x += step->dt * world->balls[i].velocity.x;
        world->balls[i].position.y += step->dt * world->balls[i].velocity.y;
    }
    return 0;
}

static uint32_t balls(flipside_world* world, flipside_ball_state* out, uint32_t capacity) {
    if (world->count <= capacity) memcpy(out, world->balls, world->count * sizeof *out);
    return world->count;
}

static int control(flipside_world* world, const flipside_control* control) {
    uint32_t at = 0;
    while (at < world->count && world->balls[at].number != control->ball.state.number) ++at;
    switch (control->kind) {
        case FLIPSIDE_ADD_BALL:
            if (world->count == ROOM) return 1;
            world->balls[world->count] = control->ball.state;
            world->balls[world->count++].spin = worlds;
            return 0;
        case FLIPSIDE_REMOVE_BALL:
            world->balls[at] = world->balls[--world->count];
            return 0;
        case FLIPSIDE_NUDGE:
            for (uint32_t i = 0; i < world->count; ++i) world->balls[i].velocity.x += control->velocity.x;
            return 0;
        default:
            return 1;
    }
}

static uint64_t save(flipside_world* world, void* out, uint64_t capacity) {
    if (capacity >= sizeof world->random) memcpy(out, &world->random, sizeof world->random);
    return sizeof world->random;
}

static int restore(flipside_world* world, const void* bytes, uint64_t size) {
    if (size != sizeof world->random) return 1;
    memcpy(&world->random, bytes, sizeof world->random);
    return 0;
}

const flipside_engine* flipside_engine_entry(void) {
    static const flipside_engine engine = {
        .size = sizeof engine,
        .version = FLIPSIDE_ENGINE_VERSION,
        .name = "keeper",
        .about = "pushes balls at random, and can go on with it",
        .features = FLIPSIDE_BALL_PAIRS | FLIPSIDE_POINTS,
        .make = make,
        .step = step,
        .balls = balls,
        .control = control,
        .save = save,
        .restore = restore,
    };
    return &engine;
}
