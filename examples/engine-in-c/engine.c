/* A whole engine in one file of C: discs under gravity against segments, points, circles and one another.
 *
 * It is the simplest loop: move every ball, find the overlapping pairs, push them apart and
 * turn their velocities round. A course starts here. What to do next, from easy to hard:
 *   1. A fast ball jumps over a thin wall: `flipside cases thin-wall --engine ./libengine-in-c.so`.
 *   2. All pairs are tested: 1000 balls cost a million tests a step. Sort them along x first.
 *   3. Friction: the impulse along the surface, at most mu times the one across it (FLIPSIDE_FRICTION).
 *   4. Parts that move: flipside_motion says how (FLIPSIDE_MOVING).
 *   5. The time of impact instead of the overlap after it.
 *
 * `flipside conformance ./libengine-in-c.so` marks what is there. */

#include "flipside/engine.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_EVENTS = 1 << 16 };

struct flipside_world {
    flipside_scene scene; /* only its numbers: what it points at was Flipside's, and is copied below */
    flipside_material* materials;
    flipside_part* parts;
    flipside_primitive* primitives;
    flipside_ball* balls;
    uint32_t ball_count;
    int substeps;
    flipside_event* events; /* of the last step */
    uint32_t event_count;
    flipside_contact* contacts; /* at its end */
    uint32_t contact_count, contact_room;
};

static flipside_vec vec(double x, double y) {
    return (flipside_vec){x, y};
}
static flipside_vec add(flipside_vec a, double s, flipside_vec b) {
    return vec(a.x + s * b.x, a.y + s * b.y);
}
static double dot(flipside_vec a, flipside_vec b) {
    return a.x * b.x + a.y * b.y;
}

static void* copy(const void* from, size_t size) {
    void* to = malloc(size ? size : 1);
    return to && size ? memcpy(to, from, size) : to;
}

static void destroy(flipside_world* world) {
    free(world->materials);
    free(world->parts);
    free(world->primitives);
    free(world->balls);
    free(world->events);
    free(world->contacts);
    free(world);
}

static flipside_world* make(const flipside_scene* scene, const double* settings, char* why) {
    flipside_world* world = calloc(1, sizeof *world);
    if (!world) return NULL;
    world->scene = *scene;
    world->materials = copy(scene->materials, scene->material_count * sizeof *scene->materials);
    world->parts = copy(scene->parts, scene->part_count * sizeof *scene->parts);
    world->primitives = copy(scene->primitives, scene->primitive_count * sizeof *scene->primitives);
    world->balls = copy(scene->balls, scene->ball_count * sizeof *scene->balls);
    world->ball_count = scene->ball_count;
    world->substeps = (int)settings[0];
    world->events = malloc(MOST_EVENTS * sizeof *world->events);
    if (world->materials && world->parts && world->primitives && world->balls && world->events) return world;
    snprintf(why, FLIPSIDE_WHY, "there is no memory for %u balls", (unsigned)scene->ball_count);
    destroy(world);
    return NULL;
}

/* The point of a primitive that is nearest to p, and how far it is inside the primitive's surface (a circle's
 * radius). */
static flipside_vec nearest(const flipside_primitive* primitive, flipside_vec p, double* radius) {
    *radius = primitive->kind == FLIPSIDE_CIRCLE ? primitive->radius_a : 0;
    if (primitive->kind != FLIPSIDE_SEGMENT) return primitive->a;
    flipside_vec along = add(primitive->b, -1, primitive->a);
    double share = dot(add(p, -1, primitive->a), along) / dot(along, along);
    return add(primitive->a, share < 0 ? 0 : share > 1 ? 1 : share, along);
}

/* Two things that overlap by `depth`, `normal` from `other` to the ball. A wall is a thing of no inverse
 * mass. */
typedef struct meeting {
    flipside_ball *ball, *other_ball; /* other_ball is null for a part */
    uint32_t part;
    flipside_vec point, normal;
    double depth;
} meeting;

/* The response: an impulse along the normal that turns the approach round, times the restitution. */
static void bounce(flipside_world* world, const meeting* m, double time) {
    const flipside_material* a = &world->materials[m->ball->material];
    const flipside_material* b =
        &world->materials[m->other_ball ? m->other_ball->material : world->parts[m->part].material];
    double restitution = a->restitution * b->restitution, kick = fmax(a->kick, b->kick);
    double inverse = 1 / m->ball->mass, other_inverse = m->other_ball ? 1 / m->other_ball->mass : 0;
    double share = inverse / (inverse + other_inverse);

    /* Push them apart, the lighter one further. */
    m->ball->state.position = add(m->ball->state.position, share * m->depth, m->normal);
    if (m->other_ball)
        m->other_ball->state.position =
            add(m->other_ball->state.position, -(1 - share) * m->depth, m->normal);

    flipside_vec relative = m->ball->state.velocity;
    if (m->other_ball) relative = add(relative, -1, m->other_ball->state.velocity);
    double approach = -dot(relative, m->normal);
    if (approach <= 0) return; /* they part already */
    int is_impact = approach > world->scene.rest_speed;
    double leave = is_impact ? fmax(restitution * approach, kick) : 0;
    double impulse = (approach + leave) / (inverse + other_inverse);
    m->ball->state.velocity = add(m->ball->state.velocity, impulse * inverse, m->normal);
    if (m->other_ball)
        m->other_ball->state.velocity =
            add(m->other_ball->state.velocity, -impulse * other_inverse, m->normal);

    if (!is_impact || world->event_count == MOST_EVENTS) return;
    world->events[world->event_count++] = (flipside_event){
        .time = time,
        .kind = FLIPSIDE_IMPACT,
        .ball = m->ball->state.number,
        .other_is_ball = m->other_ball != NULL,
        .other = m->other_ball ? m->other_ball->state.number : m->part,
        .point = m->point,
        .normal = m->normal,
        .speed = approach,
        .impulse = impulse,
    };
}

static void note_contact(flipside_world* world, const meeting* m) {
    if (world->contact_count == world->contact_room) {
        uint32_t room = world->contact_room ? 2 * world->contact_room : 64;
        flipside_contact* more = realloc(world->contacts, room * sizeof *more);
        if (!more) return;
        world->contacts = more;
        world->contact_room = room;
    }
    world->contacts[world->contact_count++] = (flipside_contact){
        .ball = m->ball->state.number,
        .other_is_ball = m->other_ball != NULL,
        .other = m->other_ball ? m->other_ball->state.number : m->part,
        .point = m->point,
        .normal = m->normal,
        .separation = -m->depth,
    };
}

/* Whether a ball overlaps the disc of `radius` about `center`; fills in the geometry of the meeting. */
static int overlaps(meeting* m, flipside_vec center, double radius) {
    flipside_vec apart = add(m->ball->state.position, -1, center);
    double distance = sqrt(dot(apart, apart));
    m->depth = m->ball->radius + radius - distance;
    if (m->depth < 0 || distance == 0) return 0;
    m->normal = vec(apart.x / distance, apart.y / distance);
    m->point = add(center, radius, m->normal);
    return 1;
}

/* Looks at everything that may overlap and shows it to `see`. Balls come by rising number, so the ball of a
 * pair is the lower one, as events want it. */
static void find_overlaps(flipside_world* world, double time, int respond) {
    for (uint32_t i = 0; i < world->ball_count; ++i) {
        meeting m = {.ball = &world->balls[i]};
        for (uint32_t j = 0; j < world->scene.primitive_count; ++j) {
            double radius;
            flipside_vec center = nearest(&world->primitives[j], m.ball->state.position, &radius);
            m.part = world->primitives[j].part;
            if (!overlaps(&m, center, radius)) continue;
            respond ? bounce(world, &m, time) : note_contact(world, &m);
        }
        for (uint32_t j = i + 1; j < world->ball_count; ++j) {
            m.other_ball = &world->balls[j];
            if (!overlaps(&m, m.other_ball->state.position, m.other_ball->radius)) continue;
            respond ? bounce(world, &m, time) : note_contact(world, &m);
        }
    }
}

static int step(flipside_world* world, const flipside_step* step, char* why) {
    (void)why; /* nothing here can fail */
    double h = step->dt / world->substeps;
    world->event_count = world->contact_count = 0;
    for (int i = 0; i < world->substeps; ++i) {
        /* Half the gravity before the move and half after it: without hits that is the parabola itself. */
        for (uint32_t j = 0; j < world->ball_count; ++j) {
            flipside_ball_state* ball = &world->balls[j].state;
            ball->velocity = add(ball->velocity, h / 2, world->scene.gravity);
            ball->position = add(ball->position, h, ball->velocity);
            ball->velocity = add(ball->velocity, h / 2, world->scene.gravity);
        }
        find_overlaps(world, step->time + (i + 1) * h, 1);
    }
    find_overlaps(world, step->time + step->dt, 0);
    return 0;
}

static uint32_t balls(flipside_world* world, flipside_ball_state* out, uint32_t capacity) {
    for (uint32_t i = 0; i < world->ball_count && i < capacity; ++i) out[i] = world->balls[i].state;
    return world->ball_count;
}

static uint32_t events(flipside_world* world, flipside_event* out, uint32_t capacity) {
    if (world->event_count <= capacity) memcpy(out, world->events, world->event_count * sizeof *out);
    return world->event_count;
}

static uint32_t contacts(flipside_world* world, flipside_contact* out, uint32_t capacity) {
    if (world->contact_count > 0 && world->contact_count <= capacity)
        memcpy(out, world->contacts, world->contact_count * sizeof *out);
    return world->contact_count;
}

static const flipside_setting settings[] = {{
    .name = "substeps",
    .unit = "",
    .about = "equal parts each step is cut into; too few let fast balls sink into walls and jump over them",
    .kind = FLIPSIDE_INTEGER,
    .initial = 8,
    .min = 1,
    .max = 1000,
}};

const flipside_engine* flipside_engine_entry(void) {
    static const flipside_engine engine = {
        .size = sizeof engine,
        .version = FLIPSIDE_ENGINE_VERSION,
        .name = "engine-in-c",
        .about = "the smallest whole engine: move, find overlaps, push out and reflect",
        .features =
            FLIPSIDE_POINTS | FLIPSIDE_SEGMENTS | FLIPSIDE_CIRCLES | FLIPSIDE_BALL_PAIRS | FLIPSIDE_KICKS,
        .settings = settings,
        .setting_count = 1,
        .make = make,
        .step = step,
        .balls = balls,
        .destroy = destroy,
        .events = events,
        .contacts = contacts,
    };
    return &engine;
}
