/* The interface of a foreign engine, in plain C: a shared library that implements it runs wherever Flipside
 * takes the name of an engine (--engine ./my.so). docs/plugins.md is the tour, examples/engine-in-c the
 * smallest whole engine, `flipside conformance ./my.so` says what of the contract a library meets.
 *
 * What is mandatory: make, step, balls. All else may be null.
 *
 * Division of work. Flipside keeps the clock, reads the controls, turns the flippers, launches balls, notices
 * balls that leave the bounds, drops targets, and checks every number that an engine gives. The engine moves
 * balls. What changes from outside between two steps reaches it by control(); an engine without it is made
 * anew from the balls as they are.
 *
 * Units: SI (m, kg, s, rad), double; x to the right, y up; angles anticlockwise.
 *
 * Ownership: what Flipside passes belongs to Flipside and is valid until the call returns; copy what you
 * need. What flipside_engine_entry() returns stays valid for ever. Each side frees only what it allocated
 * itself.
 *
 * Threads: a library is loaded in a process of its own, which holds one world at a time and makes all calls
 * from one thread, one after another. The engine may start threads; what they use up in a step is counted.
 *
 * Errors: make and step say in a sentence why they fail (see below). A crash, exit(), a call that takes
 * longer than 10 s, a number that is none, more than 4 GiB of memory: the run ends, by name; all else goes
 * on. Standard input is empty; of what is written to standard output and error the last line is quoted where
 * a run ends so.
 *
 * Time: counted as the engine's are the CPU seconds that its process spends in step, balls, events and
 * contacts; the way between the processes is not.
 *
 * Later versions: structs that begin with `size` (bytes) may grow at their end; read beyond what you know
 * only after a look at it. Elements of arrays stay as they are as long as FLIPSIDE_ENGINE_VERSION does. */

#ifndef FLIPSIDE_ENGINE_H
#define FLIPSIDE_ENGINE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define FLIPSIDE_ENGINE_VERSION 1u

/* What a scene may need of an engine beyond gravity and restitution. A scene that needs what an engine does
 * not declare is refused, with the name of what is missing and of a part that needs it. */
#define FLIPSIDE_POINTS (1u << 0) /* primitives by kind; points are also the corners and ends of curves */
#define FLIPSIDE_SEGMENTS (1u << 1)
#define FLIPSIDE_ARCS (1u << 2)
#define FLIPSIDE_CIRCLES (1u << 3)
#define FLIPSIDE_POLYGONS (1u << 4)
#define FLIPSIDE_TAPERS (1u << 5)     /* capsules and flippers */
#define FLIPSIDE_BALL_PAIRS (1u << 6) /* more than one ball */
#define FLIPSIDE_FRICTION (1u << 7)   /* and with it spin */
#define FLIPSIDE_KICKS (1u << 8)
#define FLIPSIDE_DAMPING (1u << 9)
#define FLIPSIDE_MOVING (1u << 10) /* turning parts, flippers: see flipside_motion */
#define FLIPSIDE_SENSORS (1u << 11)
#define FLIPSIDE_LAYERS (1u << 12) /* things that do not meet */
#define FLIPSIDE_GATES (1u << 13)  /* see flipside_part */

typedef struct flipside_vec {
    double x, y;
} flipside_vec;

/* How two surfaces meet: restitution e = e1 e2, friction mu = sqrt(mu1 mu2), kick k = the larger. The normal
 * speed v of an approach becomes e v, where v is below the scene's rest_speed 0; at least k where it is not
 * below. Both seen from the surface, which on a moving part has the velocity omega x (point - pivot). */
typedef struct flipside_material {
    double restitution; /* >= 0, may exceed 1 */
    double friction;    /* >= 0 */
    double kick;        /* m/s, >= 0 */
} flipside_material;

/* What of a ball changes. */
typedef struct flipside_ball_state {
    uint32_t number; /* names the ball for its whole life; rising with age, not always without gaps */
    uint32_t asleep; /* 0 or 1 */
    flipside_vec position, velocity; /* m, m/s */
    double angle, spin;              /* rad, rad/s; an engine without friction leaves spin and turns angle */
} flipside_ball_state;

/* A disc with the moment of inertia m r r / 2. Two things meet when the layer of each is in the other's mask.
 */
typedef struct flipside_ball {
    flipside_ball_state state;
    double radius, mass;    /* m, kg; > 0 */
    uint32_t material;      /* index into the scene's */
    uint32_t layer;         /* one bit */
    uint32_t collides_with; /* mask of layers */
    uint32_t reserved;
} flipside_ball;

enum flipside_primitive_kind {
    FLIPSIDE_POINT = 0, /* a */
    FLIPSIDE_SEGMENT =
        1,            /* from a to b, two-sided, without its ends: where they can be hit they are points */
    FLIPSIDE_ARC = 2, /* about a, radius_a, anticlockwise from `from` to `to`; two-sided, without its ends */
    FLIPSIDE_CIRCLE = 3, /* about a, radius_a; solid */
    FLIPSIDE_POLYGON =
        4, /* convex, solid, anticlockwise: point_count of the scene's points from first_point on */
    FLIPSIDE_TAPER = 5 /* solid: the convex hull of the circles a, radius_a and b, radius_b */
};

/* A primitive of a part's surface, where it is at the part's angle 0. Joints are resolved: where two curves
 * meet smoothly there is no point, and nothing may catch. */
typedef struct flipside_primitive {
    uint32_t kind;
    uint32_t part; /* index into the scene's parts */
    flipside_vec a, b;
    double radius_a, radius_b;
    double from, to; /* rad, from < to <= from + 2 pi */
    uint32_t first_point, point_count;
} flipside_primitive;

#define FLIPSIDE_PART_SENSOR (1u << 0) /* begins and ends, no response */
#define FLIPSIDE_PART_MOVES (1u << 1)
#define FLIPSIDE_PART_GATE (1u << 2)
#define FLIPSIDE_PART_OPEN (1u << 3) /* a gate that is open now */

/* A gate meets a ball when its centre first comes within a radius of the gate's segment, and decides then,
 * once: open, it lets the ball through; closed, it does where the centre is on the side from which `normal`
 * points away. A closed gate is solid to a ball that it does not let through until the ball has left. A gate
 * is open while a ball that it let through has not left. The engine reports what changes (FLIPSIDE_GATE_...
 * below). */
typedef struct flipside_part {
    const char* name;
    uint32_t flags;
    uint32_t material;
    uint32_t layer, collides_with;
    flipside_vec pivot;  /* of a part that moves */
    double angle;        /* rad, now; 0 for what does not move */
    flipside_vec normal; /* of a gate */
} flipside_part;

/* A closed gate that does not let this ball through, which is still within a radius of it. */
typedef struct flipside_blocked {
    uint32_t part, ball;
} flipside_blocked;

typedef struct flipside_scene {
    uint32_t size;
    uint32_t material_count, ball_count, part_count, primitive_count, point_count, blocked_count;
    uint32_t reserved;
    const char* name;
    const char* json; /* all of it, as a scene file (assets/scene.schema.json); the numbers below are exact */
    double time;      /* s: a world may be made in mid-run */
    flipside_vec gravity;
    double damping;    /* c in v' = g - c v, 1/s */
    double rest_speed; /* m/s */
    flipside_vec bounds_min, bounds_max;
    const flipside_material* materials;
    const flipside_ball* balls; /* by rising number */
    const flipside_part* parts;
    const flipside_primitive* primitives; /* by part; drop targets that are down have none */
    const flipside_vec* points;
    const flipside_blocked* blocked;
} flipside_scene;

/* How a part that moves does so in a step: t seconds after its start, its angle is
 * angle + rate * min(t, until_stop), about its pivot. */
typedef struct flipside_motion {
    uint32_t part;
    uint32_t reserved;
    double angle, rate; /* rad, rad/s */
    double until_stop;  /* s; infinite where nothing stops it */
} flipside_motion;

typedef struct flipside_step {
    uint32_t size;
    uint32_t motion_count; /* one per part that moves, in the order of the parts */
    const flipside_motion* motions;
    double time, dt; /* s: from time to time + dt; sub-steps are the engine's own business */
} flipside_step;

enum flipside_event_kind {
    FLIPSIDE_IMPACT = 0, /* met faster than rest_speed; one per impact, or one per pair and step */
    FLIPSIDE_BEGIN = 1,  /* a touch that lasts beyond the step began */
    FLIPSIDE_END = 2,
    FLIPSIDE_SENSOR_BEGIN = 3,
    FLIPSIDE_SENSOR_END = 4,
    FLIPSIDE_GATE_OPENED = 5, /* of the part `other`; the ball that did it */
    FLIPSIDE_GATE_CLOSED = 6,
    FLIPSIDE_GATE_BLOCKED = 7, /* it does not let the ball through; and */
    FLIPSIDE_GATE_LEFT = 8     /* a ball that was blocked has left */
};

typedef struct flipside_event {
    double time; /* s, in the step; an engine that knows only steps gives its end */
    uint32_t kind;
    uint32_t ball; /* between two balls the lower number */
    uint32_t other_is_ball;
    uint32_t other;      /* number of a ball or index of a part */
    flipside_vec point;  /* m, on the surface of `other` */
    flipside_vec normal; /* unit, from other to ball */
    double speed;        /* m/s, approach along the normal before the hit, >= 0 */
    double impulse;      /* N s along the normal, >= 0 */
} flipside_event;

/* Two surfaces that touch now. */
typedef struct flipside_contact {
    uint32_t ball;
    uint32_t other_is_ball;
    uint32_t other;
    uint32_t reserved;
    flipside_vec point, normal; /* as in an event */
    double separation;          /* m, negative where they overlap */
} flipside_contact;

enum flipside_control_kind {
    FLIPSIDE_ADD_BALL = 0,    /* ball */
    FLIPSIDE_REMOVE_BALL = 1, /* ball.state.number */
    FLIPSIDE_SET_BALL = 2,    /* ball: the one of its number is now so */
    FLIPSIDE_NUDGE = 3,       /* velocity, added to that of every ball, which wakes it */
    FLIPSIDE_PRESENCE = 4     /* part: a drop target is there (on = 1) or down (on = 0) */
};

typedef struct flipside_control {
    uint32_t size;
    uint32_t kind;
    flipside_ball ball;
    flipside_vec velocity;
    uint32_t part, on;
} flipside_control;

enum flipside_setting_kind {
    FLIPSIDE_REAL = 0,
    FLIPSIDE_INTEGER = 1,
    FLIPSIDE_TOGGLE = 2, /* 0 or 1 */
    FLIPSIDE_CHOICE = 3  /* an index into choices */
};

typedef struct flipside_setting {
    const char* name;  /* letters, digits and _ */
    const char* unit;  /* "" where it has none */
    const char* about; /* one line: what it means, and what too small or too large does */
    uint32_t kind;
    uint32_t choice_count;
    const char* const* choices;
    double initial, min, max; /* min and max of reals and integers, inclusive */
} flipside_setting;

typedef struct flipside_world flipside_world; /* the engine's own */

/* Bytes that `why` points at: a sentence for people, UTF-8, ended by 0. */
#define FLIPSIDE_WHY 256

typedef struct flipside_engine {
    uint32_t size;       /* sizeof(flipside_engine) */
    uint32_t version;    /* FLIPSIDE_ENGINE_VERSION */
    const char* name;    /* a word: what figures and settings are called by */
    const char* about;   /* one line */
    const char* library; /* name and version of a library that it wraps; null where there is none */
    uint64_t features;   /* FLIPSIDE_POINTS | ... */
    const flipside_setting* settings;
    uint32_t setting_count;
    uint32_t reserved;

    /* Makes a world; null where it cannot, and says why. `settings` are values in the order declared. */
    flipside_world* (*make)(const flipside_scene* scene, const double* settings, char* why);
    /* Advances by exactly step->dt. Returns 0; anything else ends the run, and says why. */
    int (*step)(flipside_world* world, const flipside_step* step, char* why);
    /* Writes all balls, at most `capacity`, in any order; returns how many there are. */
    uint32_t (*balls)(flipside_world* world, flipside_ball_state* out, uint32_t capacity);

    /* From here on each may be null. */

    void (*destroy)(flipside_world* world);
    /* Of the last step, in order of time. Both return how many there are; where that is more than `capacity`
     * they are called again with room enough. Touches with sensors are no contacts. */
    uint32_t (*events)(flipside_world* world, flipside_event* out, uint32_t capacity);
    uint32_t (*contacts)(flipside_world* world, flipside_contact* out, uint32_t capacity);
    /* Returns 0 where it is done. For anything else, and for kinds that you do not know, the world is made
     * anew. */
    int (*control)(flipside_world* world, const flipside_control* control);
    /* What the balls do not say and the next step depends on: impulses to start from, say. save returns how
     * many bytes there are, and is called again where they are more than `capacity`. restore gets them back,
     * in a world just made from the same scene and balls, which then goes on with the same bits; 0 where it
     * is done. */
    uint64_t (*save)(flipside_world* world, void* out, uint64_t capacity);
    int (*restore)(flipside_world* world, const void* bytes, uint64_t size);
} flipside_engine;

/* What a library exports: one function of this name and type. */
#define FLIPSIDE_ENTRY "flipside_engine_entry"
#if defined(_WIN32)
#define FLIPSIDE_EXPORT __declspec(dllexport)
#else
#define FLIPSIDE_EXPORT __attribute__((visibility("default")))
#endif
FLIPSIDE_EXPORT const flipside_engine* flipside_engine_entry(void);

#ifdef __cplusplus
}
#endif

#endif
