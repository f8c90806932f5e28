/* An engine that keeps the contract until a step that begins at 0.1 s or later, and then does on purpose what
 * its setting `does` says. Its ball falls as it should until then. */

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "flipside/engine.h"

enum {
    NOTHING,
    CRASH,
    HANG,
    SLEEP,
    WRITE_BEYOND,
    NOT_A_NUMBER,
    TOO_MANY_BALLS,
    TOO_FEW_BALLS,
    TOO_MANY_EVENTS,
    WRONG_NUMBER,
    PRINT,
    EXIT,
    FORK,
    LEAVE_A_CHILD,
    WRITE_TO_SOCKET,
    CLOSE_SOCKET,
    FILL_MEMORY,
    SAY_NO,
    ABORT,
    FAR_AWAY,
    EVENT_OF_NOBODY,
    EVENTS_IN_DISORDER,
    CRASH_IN_MAKE,
    REFUSE_MAKE,
    SHOUT
};

struct flipside_world {
    flipside_ball_state balls[16];
    uint32_t count;
    flipside_vec gravity;
    double time;
    int does, active;
};

static flipside_world* make(const flipside_scene* scene, const double* settings, char* why) {
    if ((int)settings[0] == CRASH_IN_MAKE) raise(SIGSEGV);
    if ((int)settings[0] == REFUSE_MAKE) {
        strcpy(why, "no such luck\033[31m");
        return NULL;
    }
    if (scene->ball_count > 16) return NULL;
    flipside_world* world = calloc(1, sizeof *world);
    for (uint32_t i = 0; i < scene->ball_count; ++i) world->balls[i] = scene->balls[i].state;
    world->count = scene->ball_count;
    world->gravity = scene->gravity;
    world->does = (int)settings[0];
    world->time = scene->time;
    return world;
}

static int step(flipside_world* world, const flipside_step* step, char* why) {
    for (uint32_t i = 0; i < world->count; ++i) {
        flipside_ball_state* ball = &world->balls[i];
        ball->position.x += step->dt * ball->velocity.x + step->dt * step->dt / 2 * world->gravity.x;
        ball->position.y += step->dt * ball->velocity.y + step->dt * step->dt / 2 * world->gravity.y;
        ball->velocity.x += step->dt * world->gravity.x;
        ball->velocity.y += step->dt * world->gravity.y;
    }
    world->time = step->time + step->dt;
    world->active = step->time >= 0.1;
    if (!world->active) return 0;
    static const char nonsense[100] = "nonsense";
    switch (world->does) {
        case CRASH:
            raise(SIGSEGV);
            break;
        case ABORT:
            fprintf(stderr, "assertion failed: \033]0;owned\a the ball is round\n");
            abort();
        case HANG:
            for (volatile int forever = 1; forever;) {
            }
            break;
        case SLEEP:
            sleep(1000);
            break;
        case NOT_A_NUMBER:
            world->balls[0].position.y = NAN;
            break;
        case FAR_AWAY:
            world->balls[0].position.x = 1e300;
            break;
        case WRONG_NUMBER:
            world->balls[0].number = 77;
            break;
        case PRINT:
            printf("hello from the engine\n");
            break;
        case SHOUT:
            for (int i = 0; i < 100000; ++i) printf("a line of words that nobody reads, number %d\n", i);
            fflush(stdout);
            break;
        case EXIT:
            exit(0);
        case FORK:
            (void)!fork();
            break;
        case LEAVE_A_CHILD:
            if (fork() == 0) sleep(1000);
            raise(SIGKILL);
            break;
        case WRITE_TO_SOCKET:
            (void)!write(3, nonsense, sizeof nonsense);
            break;
        case CLOSE_SOCKET:
            close(3);
            sleep(1000);
            break;
        case FILL_MEMORY:
            for (size_t size = 0;; size += 1 << 26)
                if (!malloc(1 << 26)) abort();
        case SAY_NO:
            strcpy(why, "it is too late");
            return 1;
        default:
            break;
    }
    return 0;
}

static uint32_t balls(flipside_world* world, flipside_ball_state* out, uint32_t capacity) {
    if (world->active && world->does == WRITE_BEYOND) memset(out, 1, (capacity + 1) * sizeof *out);
    memcpy(out, world->balls, world->count * sizeof *out);
    if (world->active && world->does == TOO_MANY_BALLS) return 4000000000u;
    if (world->active && world->does == TOO_FEW_BALLS) return 0;
    return world->count;
}

static uint32_t events(flipside_world* world, flipside_event* out, uint32_t capacity) {
    if (!world->active) return 0;
    if (world->does == TOO_MANY_EVENTS) return 4000000000u;
    if (world->does != EVENT_OF_NOBODY && world->does != EVENTS_IN_DISORDER) return 0;
    if (capacity < 2) return 2;
    memset(out, 0, 2 * sizeof *out);
    out[0].time = world->time;
    out[1].time = world->does == EVENTS_IN_DISORDER ? world->time - 0.001 : world->time;
    out[1].other = world->does == EVENT_OF_NOBODY ? 1000 : 0;
    return 2;
}

static const char* const names[] = {"nothing",
                                    "crash",
                                    "hang",
                                    "sleep",
                                    "write-beyond",
                                    "not-a-number",
                                    "too-many-balls",
                                    "too-few-balls",
                                    "too-many-events",
                                    "wrong-number",
                                    "print",
                                    "exit",
                                    "fork",
                                    "leave-a-child",
                                    "write-to-socket",
                                    "close-socket",
                                    "fill-memory",
                                    "say-no",
                                    "abort",
                                    "far-away",
                                    "event-of-nobody",
                                    "events-in-disorder",
                                    "crash-in-make",
                                    "refuse-make",
                                    "shout"};

const flipside_engine* flipside_engine_entry(void) {
    static const flipside_setting does = {
        .name = "does",
        .unit = "",
        .about = "what it does",
        .kind = FLIPSIDE_CHOICE,
        .choice_count = sizeof names / sizeof *names,
        .choices = names,
    };
    static const flipside_engine engine = {
        .size = sizeof engine,
        .version = FLIPSIDE_ENGINE_VERSION,
        .name = "custom",
        .about = "does on purpose what an engine must not",
        .features = ~UINT64_C(0),
        .settings = &does,
        .setting_count = 1,
        .make = make,
        .step = step,
        .balls = balls,
        .events = events,
    };
    return &engine;
}
