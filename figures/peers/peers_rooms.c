// peers_rooms.c - icosahedra thrown into a cubic room: by us and by ODE, from
// the same places; with 10,000 of them beside 1,000; asleep beside awake.
//
// Depth, strain and energy are measured by one and the same function for both
// sides, from the vertices alone.

#include "peers_others.h"
#include "hard_set.h"
#include "hit_face.h"
#include "oracle.h"
#include "random.h"
#include "step.h"
#include "peers.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { FRAMES = 600, PIECE = 10, PIECES = FRAMES / PIECE, MOST = 1000 };
static const real DT = 1.0 / 60, RADIUS = 0.5;

static shape icosahedron;

// ---- The scene -------------------------------------------------------------

static int grid_cells(int bodies)
{
    int cells = 1;
    while (cells * cells * cells < bodies) cells++;
    return cells;
}

static vec3 throw_of(real most, unsigned long long *seed)
{
    real x = 2 * random_fraction(seed) - 1, y = 2 * random_fraction(seed) - 1;
    real z = 2 * random_fraction(seed) - 1;
    return vec3_make(most * x, most * y, most * z);
}

// Body k in its cell of a cubic grid, anywhere in it, turned anyhow.
static placement start_of(int k, int cells, real side, unsigned long long *seed)
{
    real cell = side / cells, loose = fmax(0, cell / 2 - RADIUS);
    vec3 place = vec3_make(k % cells, k / (cells * cells), k / cells % cells);
    vec3 at = vec3_scale(cell, vec3_add(place, vec3_make(0.5, 0.5, 0.5)));
    at = vec3_sub(at, vec3_make(side / 2, 0, side / 2));
    placement p = turned_anyhow(vec3_add(at, throw_of(loose, seed)), seed);
    p.velocity = throw_of(5, seed);
    p.spin = throw_of(5, seed);
    return p;
}

// Any icosahedron has (golden edge)^2 / 10 of its mass as inertia.
static room room_of(int bodies, unsigned long long seed)
{
    const real golden = (1 + sqrt(5.0)) / 2;
    int cells = grid_cells(bodies);
    real reach = golden * icosahedron.spacing;
    room r = { .bodies = bodies, .side = cbrt(0.317 * bodies / 0.15),
               .inertia = reach * reach / 10, .plan = &icosahedron };
    r.side = fmax(r.side, 2 * RADIUS * cells);
    r.start = malloc((size_t)bodies * sizeof *r.start);
    if (!r.start) give_up("there is no memory for a room");
    for (int k = 0; k < bodies; k++)
        r.start[k] = start_of(k, cells, r.side, &seed);
    return r;
}

static status add_walls(world *w, real side)
{
    status done = world_add_plane(w, vec3_make(0, 1, 0), 0);
    if (done.ok) done = world_add_plane(w, vec3_make(0, -1, 0), -side);
    for (int k = -1; k <= 1 && done.ok; k += 2) {
        done = world_add_plane(w, vec3_make(k, 0, 0), -side / 2);
        if (done.ok) done = world_add_plane(w, vec3_make(0, 0, k), -side / 2);
    }
    return done;
}

enum { STEPS = 8 };             // substeps, twice the default
static int substeps;            // a frame of ours

static void our_begin(world *w, const room *r, bool may_sleep)
{
    world_options o = world_options_default();
    if (!may_sleep) o.sleep_speed = 0;
    o.substeps = o.most_substeps = substeps;
    status done = world_init(w, o);
    if (done.ok) done = add_walls(w, r->side);
    for (int k = 0; k < r->bodies && done.ok; k++)
        done = world_add(w, r->plan, r->start[k], NULL);
    if (!done.ok) give_up(done.why);
}

// ---- The same measure for both ---------------------------------------------

typedef vec3 corners[CORNERS];

// Over all frames, but for the energy, which is that of the last one.
typedef struct {
    real depth;         // m, deepest in another body, or behind a wall
    real strain;        // of the edges
    real joules;        // of motion
    corners a, b;       // the two that were deepest
    real pair_depth;    // m, of them
} outcome;

static corners now_at[MOST], then_at[MOST];
static vec3 middle_of[MOST];

static void look_at_edges(const corners at, outcome *o)
{
    for (int k = 0; k < icosahedron.sticks; k++) {
        stick s = icosahedron.stick[k];
        real l = vec3_distance(at[s.a], at[s.b]);
        o->strain = fmax(o->strain, fabs(l / s.rest_length - 1));
    }
}

static void look_at_walls(const corners at, real side, outcome *o)
{
    for (int i = 0; i < CORNERS; i++) {
        vec3 p = at[i];
        if (!vec3_is_finite(p)) o->depth = HUGE_VAL;
        real out = fmax(fabs(p.x), fabs(p.z)) - side / 2;
        o->depth = fmax(o->depth, fmax(out, fmax(-p.y, p.y - side)));
    }
}

static void copy_corners(corners to, const corners from)
{
    for (int i = 0; i < CORNERS; i++) to[i] = from[i];
}

// The engine asks the same functions.  So the slow oracle has a word: on the
// deepest pair of all (check), and on one in so many.
enum { DOUBTED = 5000 };
static long looked;

static void look_at_pair(const corners a, const corners b, outcome *o)
{
    hull p = { a, CORNERS }, q = { b, CORNERS };
    gjk_result r = gjk_distance(p, q, 0, NULL);
    real depth = r.status == GJK_OVERLAP ? hit_face_find(p, q, &r.last).depth
                                         : 0;
    if (++looked % DOUBTED == 0
        && !(fabs(depth - fmax(0, (real)oracle_depth(p, q))) <= 1e-12))
        give_up("the oracle does not agree about a pair");
    o->depth = fmax(o->depth, depth);
    if (depth <= o->pair_depth) return;
    o->pair_depth = depth;
    copy_corners(o->a, a);
    copy_corners(o->b, b);
}

// The energy of motion between two frames: the corners stand around the middle
// with sum r x (d x r) = 8 R^2 d for a small turn d.
static real joules_of(const corners then, const corners now, real inertia)
{
    vec3 go = { 0, 0, 0 }, turn = { 0, 0, 0 }, middle = { 0, 0, 0 };
    for (int i = 0; i < CORNERS; i++) {
        middle = vec3_add_scaled(middle, 1.0 / CORNERS, now[i]);
        go = vec3_add_scaled(go, 1.0 / CORNERS, vec3_sub(now[i], then[i]));
    }
    for (int i = 0; i < CORNERS; i++)
        turn = vec3_add(turn, vec3_cross(vec3_sub(now[i], middle),
                                         vec3_sub(now[i], then[i])));
    turn = vec3_scale(1 / (8 * RADIUS * RADIUS), turn);
    return (vec3_length_squared(go) + inertia * vec3_length_squared(turn))
         / (2 * DT * DT);
}

static void look(const room *r, void (*vertices)(int, vec3 *), outcome *o)
{
    o->joules = 0;
    for (int k = 0; k < r->bodies; k++) {
        copy_corners(then_at[k], now_at[k]);
        vertices(k, now_at[k]);
        o->joules += joules_of(then_at[k], now_at[k], r->inertia);
        look_at_edges(now_at[k], o);
        look_at_walls(now_at[k], r->side, o);
        middle_of[k] = vec3_scale(0.5, vec3_add(now_at[k][0], now_at[k][3]));
    }
    for (int a = 0; a < r->bodies; a++)
        for (int b = a + 1; b < r->bodies; b++)
            if (vec3_distance(middle_of[a], middle_of[b]) < 2.01 * RADIUS)
                look_at_pair(now_at[a], now_at[b], o);
}

// The deepest pair again, by the slow oracle: the quick one has to agree.
static void check(const outcome *o)
{
    if (!(o->pair_depth > 0)) return;
    real truth = (real)oracle_depth((hull){ o->a, CORNERS },
                                    (hull){ o->b, CORNERS });
    if (!(fabs(o->pair_depth - truth) <= 1e-12))
        give_up("the oracle does not agree about the deepest pair");
}

// ---- Ours and ODE's --------------------------------------------------------

static room hall;
static world ours;

static void our_vertices(int k, vec3 *at)
{
    world_vertices(&ours, &ours.body[k], at);
}

static void our_start(int piece)
{
    if (piece > 0) return;
    world_free(&ours);
    our_begin(&ours, &hall, false);
}

static void our_frames(int piece)
{
    (void)piece;
    for (int f = 0; f < PIECE; f++) world_step(&ours);
}

static void ode_start(int piece)
{
    if (piece > 0) return;
    ode_end();
    ode_begin(&hall);
}

static void ode_frames(int piece)
{
    (void)piece;
    for (int f = 0; f < PIECE; f++) ode_step(DT);
}

static void measure(outcome *us, outcome *them)
{
    our_start(0);
    for (int f = 0; f < FRAMES; f++) {
        world_step(&ours);
        look(&hall, our_vertices, us);
    }
    ode_begin(&hall);
    for (int f = 0; f < FRAMES; f++) {
        ode_step(DT);
        look(&hall, ode_vertices, them);
    }
    check(us);
    check(them);
}

static void write_outcome(char *to, const outcome *o)
{
    snprintf(to, TEXT, "%.1f mm deep; strain %.0e; %.2g J left",
             1e3 * o->depth, o->strain, o->joules);
}

// What the paper needs for its 50 bodies, on a processor of its time.
static void add_paper(real ms)
{
    row r = { .what = "room of 50, a step", .against = "the paper, in 2005",
              .unit = "ms", .ours = ms, .theirs = 50, .most = 0.075,
              .is_quoted = 1 };
    snprintf(r.their_error, TEXT, "not told");
    table_add(r);
}

static void against_ode(int bodies, int rounds, int steps, const char *what)
{
    const way ways[2] = { { our_start, our_frames },
                          { ode_start, ode_frames } };
    outcome us = { .depth = 0 }, them = { .depth = 0 };
    hall = room_of(bodies, 1);
    substeps = steps;
    measure(&us, &them);
    real *time = time_in_turn(ways, 2, PIECES, rounds);
    row r = { .what = what, .against = "ODE, quickstep, 20 iterations",
              .unit = "ms", .ratio = 0.38,
              .ours = 1e3 / FRAMES * time_sum(time, PIECES, 0),
              .theirs = 1e3 / FRAMES * time_sum(time, PIECES, 1) };
    r.is_wrong = !(us.depth <= them.depth / 2);
    write_outcome(r.our_error, &us);
    write_outcome(r.their_error, &them);
    table_add(r);
    if (bodies == 50 && steps == STEPS) add_paper(r.ours);
    free(time);
    free(hall.start);
    ode_end();
    world_free(&ours);
}

// ---- Ten times as many -----------------------------------------------------

// The fall, which takes most of that time, and the pile.
enum { MANY = 10000, FEW = 1000, LONG = 150, STRIDE = 5,
       STRIDES = LONG / STRIDE };

static room large;
static world many;

static void many_start(int piece)
{
    if (piece > 0) return;
    world_free(&many);
    our_begin(&many, &large, false);
}

// A frame: what there was to ask, and to push.  Ten times the bodies fall
// further, and faster, and lie deeper.
typedef struct {
    real pairs, contacts;
} sums;

static sums in_many, in_few;

static void step_in(world *w, sums *sum)
{
    for (int f = 0; f < STRIDE; f++) {
        world_step(w);
        sum->pairs += w->report.pairs;
        sum->contacts += w->report.contacts;
    }
}

static void many_frames(int piece)
{
    (void)piece;
    step_in(&many, &in_many);
}

static void few_frames(int piece)
{
    (void)piece;
    step_in(&ours, &in_few);
}

static void write_crowd(char *to, const world *w, sums sum)
{
    real each = (real)LONG * w->bodies;
    snprintf(to, TEXT, "%.1f pairs and %.1f contacts a body; %d found no room",
             sum.pairs / each, sum.contacts / each, w->report.dropped);
}

static void against_fewer(void)
{
    const way ways[2] = { { many_start, many_frames },
                          { our_start, few_frames } };
    large = room_of(MANY, 1);
    hall = room_of(FEW, 1);
    real *time = time_in_turn(ways, 2, STRIDES, 1);
    row r = { .what = "room of 10,000, a step of the first 2.5 s",
              .against = "ours of 1,000", .unit = "ms", .ratio = 12,
              .ours = 1e3 / LONG * time_sum(time, STRIDES, 0),
              .theirs = 1e3 / LONG * time_sum(time, STRIDES, 1) };
    write_crowd(r.our_error, &many, in_many);
    write_crowd(r.their_error, &ours, in_few);
    r.is_wrong = many.report.dropped > 0;
    table_add(r);
    free(time);
    free(hall.start);
    free(large.start);
    world_free(&many);
    world_free(&ours);
}

// ---- Asleep ----------------------------------------------------------------

// Some throws lie still after some seconds, some rock for a minute: the first of
// THROWS that is asleep after SETTLE frames; the same kept awake, for LIE; and
// the pieces of PIECE frames that are watched then.
enum { THROWS = 4, SETTLE = 900, LIE = 600, WATCH = 10 };

static void asleep_frames(int piece)
{
    (void)piece;
    for (int f = 0; f < PIECE; f++) world_step(&many);
}

// Returns when it fell asleep, in frames.
static int settle(unsigned long long seed)
{
    int frames = 0;
    free(hall.start);
    world_free(&many);
    hall = room_of(FEW, seed);
    our_begin(&many, &hall, true);
    for (; frames < SETTLE && many.report.asleep < FEW; frames++)
        world_step(&many);
    return frames;
}

static void against_awake(void)
{
    const way ways[2] = { { NULL, asleep_frames }, { NULL, our_frames } };
    int throws = 0, frames = SETTLE;
    hall.start = NULL;
    while (throws < THROWS && frames == SETTLE)
        frames = settle((unsigned long long)++throws);
    our_begin(&ours, &hall, false);
    for (int f = 0; f < LIE; f++) world_step(&ours);
    real *time = time_in_turn(ways, 2, WATCH, 3);
    row r = { .what = "settled room of 1,000, asleep, a step",
              .against = "itself awake", .unit = "ms", .ratio = 0.02,
              .ours = 1e3 / PIECE / WATCH * time_sum(time, WATCH, 0),
              .theirs = 1e3 / PIECE / WATCH * time_sum(time, WATCH, 1) };
    r.is_wrong = many.report.asleep < FEW;
    snprintf(r.our_error, TEXT, "%d of %d asleep (throw %d, after %.1f s)",
             many.report.asleep, (int)FEW, throws, frames * DT);
    table_add(r);
    free(time);
    free(hall.start);
    world_free(&many);
    world_free(&ours);
}

void peers_rooms(void)
{
    if (!shape_icosahedron(&icosahedron, RADIUS, 1).ok)
        give_up("there is no memory for the room");
    against_ode(50, 5, STEPS, "room of 50, a step");
    against_ode(200, 3, STEPS, "room of 200, a step");
    against_ode(1000, 1, STEPS, "room of 1,000, a step");
    against_ode(50, 5, STEPS / 2, "room of 50, half as many substeps");
    against_ode(200, 3, STEPS / 2, "room of 200, the same");
    against_ode(1000, 1, STEPS / 2, "room of 1,000, the same");
    substeps = STEPS;
    against_fewer();
    against_awake();
    shape_free(&icosahedron);
}
