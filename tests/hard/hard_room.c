// hard_room.c - case 26: the room, from 50 to 1000 bodies, and thrown fast.

#include "hard.h"
#include "random.h"
#include "shake.h"
#include "world_scene.h"
#include "step.h"

#include <math.h>
#include <stdio.h>

// ---- What is watched -------------------------------------------------------

// The largest of each since the watch began; bodies are counted at the worst
// moment.
typedef struct {
    double penetration; // of the radius
    double settled;     // the same, over the last two seconds
    double strain;
    int escaped;        // a vertex is behind a wall by more than a radius
    int mirrored;
    int lost;           // a place is no number
    int dropped;        // contacts that found no room, in all
    int asleep;         // in the end
    double kinetic;     // J, in the end
} watched;

// How often penetration is measured: at each step while bodies fly and fall, to
// which it takes a third of the time, then more seldom.
enum { RATE = 120, FALLING = 10 * RATE, SELDOM = 10 };
static const real SETTLED = 10;                 // s, by then they lie

static int is_outside(const world *w, const vec3 *at, int n, real far)
{
    for (int p = 0; p < w->planes; p++)
        for (int i = 0; i < n; i++)
            if (vec3_dot(at[i], w->plane[p].normal) < w->plane[p].offset - far)
                return 1;
    return 0;
}

static int is_lost(const vec3 *at, int n)
{
    for (int i = 0; i < n; i++)
        if (!vec3_is_finite(at[i])) return 1;
    return 0;
}

static void count_bodies(const world_scene *s, watched *o)
{
    enum { CORNERS = 12 };
    vec3 at[CORNERS];
    int escaped = 0, mirrored = 0, lost = 0;
    const world *w = &s->world;
    for (int k = 0; k < w->bodies; k++) {
        const body *b = &w->body[k];
        world_vertices(w, b, at);
        lost += is_lost(at, CORNERS);
        escaped += is_outside(w, at, CORNERS, s->body_radius);
        mirrored += is_mirrored(b->rigid, w->pool.at + b->first);
    }
    if (escaped > o->escaped)   o->escaped = escaped;
    if (mirrored > o->mirrored) o->mirrored = mirrored;
    if (lost > o->lost)         o->lost = lost;
}

static void watch(world_scene *s, int frame, int frames, watched *o)
{
    int is_end = frame >= frames - 2 * RATE;
    o->dropped += s->world.report.dropped;
    o->asleep = s->world.report.asleep;
    count_bodies(s, o);
    if (frame >= FALLING && frame % SELDOM != 0) return;
    measures m = world_measure(&s->world);
    double depth = m.penetration / s->body_radius;
    o->penetration = hard_worse(o->penetration, depth);
    o->strain = hard_worse(o->strain, m.strain);
    if (is_end) o->settled = hard_worse(o->settled, depth);
    o->kinetic = m.kinetic;
}

// ---- The room --------------------------------------------------------------

typedef struct {
    int  bodies, resting;
    real seconds;
    real speed;         // m/s, of each in a direction of its own, beside the
                        // throw of the scene; 0: as the scene is
    int  seed;
} room;

// Whoever was so far back a substep ago flies at that speed.
static void throw_all(world *w, real speed, unsigned long long seed)
{
    real way = speed * w->options.dt / w->options.substeps;
    for (int k = 0; k < w->bodies && speed > 0; k++) {
        const body *b = &w->body[k];
        vec3 d = random_direction(&seed);
        for (int i = b->first; i < b->first + body_particles(b); i++) {
            particle *p = &w->pool.at[i];
            p->previous = vec3_add_scaled(p->previous, -way, d);
        }
    }
}

static void run_room(hard_report *r, room what, watched *o)
{
    world_options how = world_scene_options(SCENE_ROOM, 0);
    how.dt = 1.0 / RATE;
    scene_options of = scene_options_default();
    world_scene s;
    if (!what.resting) how.sleep_speed = 0;
    of.bodies = what.bodies;
    of.seed = (unsigned long long)what.seed;
    if (!hard_ok(r, world_scene_build(&s, SCENE_ROOM, of, how))) return;
    throw_all(&s.world, what.speed, of.seed);
    int frames = (int)(what.seconds * RATE + 0.5);
    for (int f = 0; f < frames; f++) {
        world_step(&s.world);
        watch(&s, f, frames, o);
    }
    world_scene_free(&s);
}

// ---- 26 --------------------------------------------------------------------

static void add_counts(hard_report *r, const watched *o, const char *which)
{
    hard_add(r, o->escaped, 0, "", "escaped; %s", which);
    hard_add(r, o->mirrored, 0, "", "mirrored; %s", which);
    hard_add(r, o->lost, 0, "", "NaN; %s", which);
}

// One seed for the whole time, others for as long as bodies fall.
static void pour(hard_report *r, room what, int seeds)
{
    char which[40];
    watched o = { 0 };
    snprintf(which, sizeof which, "%d bodies%s", what.bodies,
             what.resting ? "" : " kept awake");
    run_room(r, what, &o);
    int asleep = o.asleep;
    double settled = o.settled, kinetic = o.kinetic;
    for (int k = 1; k < seeds; k++) {
        room next = what;
        next.seed = what.seed + k;
        next.seconds = fmin(what.seconds, (real)FALLING / RATE);
        run_room(r, next, &o);
    }
    hard_add(r, o.penetration, 0.05, "radii", "penetration; %s", which);
    if (what.seconds >= SETTLED)
        hard_add(r, settled, 0.005, "radii", "the same, settled; %s", which);
    hard_add(r, o.strain, 0.001, "", "strain; %s", which);
    add_counts(r, &o, which);
    hard_note(r, "%s: %d seeds; after %g s %d asleep, %.1e J; %d contacts "
              "found no room", which, seeds, what.seconds, asleep, kinetic,
              o.dropped);
}

static void fling(hard_report *r, const int *bodies, int rooms, real speed,
                  real seconds)
{
    char which[40];
    watched o = { 0 };
    snprintf(which, sizeof which, "thrown at %g m/s", speed);
    for (int k = 0; k < rooms; k++)
        run_room(r, (room){ bodies[k], 1, seconds, speed, 1 }, &o);
    add_counts(r, &o, which);
    hard_note(r, "%s: penetration %.3f of the radius, strain %.1e", which,
              o.penetration, o.strain);
}

enum { SIZES = 4, SPEEDS = 3 };
static const int many[SIZES] = { 50, 200, 500, 1000 };
static const real fast_as[SPEEDS] = { 20, 50, 100 };

static void some_rooms(hard_report *r)
{
    pour(r, (room){ 50, 1, 10, 0, 1 }, 1);
    pour(r, (room){ 500, 1, 2, 0, 1 }, 1);
    for (int k = 0; k < SPEEDS; k++) fling(r, many, 1, fast_as[k], 2);
}

static void full_room(hard_report *r, int fast)
{
    static const int seeds[SIZES] = { 6, 4, 2, 3 };
    if (fast) {
        some_rooms(r);
        return;
    }
    for (int k = 0; k < SIZES; k++)
        pour(r, (room){ many[k], 1, 60, 0, 1 }, seeds[k]);
    pour(r, (room){ 200, 0, 60, 0, 1 }, 1);
    for (int k = 0; k < SPEEDS; k++) fling(r, many, SIZES, fast_as[k], 10);
}

const hard_case hard_room[] = {
    { 26, "a room full of icosahedra", 1, full_room },
    { 0, NULL, 0, NULL }
};
