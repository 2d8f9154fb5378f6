//> step-time
#include "step.h"
#include "halves.h"
#include "ledger.h"
#include "narrow.h"
#include "pairs.h"
#include "soft.h"
#include "solver.h"

#include <assert.h>
#include <stddef.h>

static real clock_now(const world *w)
{
    return w->options.clock ? w->options.clock() : 0;
}

// Books the time since *since to a stage, and starts the next.
static void lap(world *w, int stage, real *since)
{
    real now = clock_now(w);
    w->report.time[stage] += now - *since;
    *since = now;
}
//<

//> step-integrate
// What both halves of a stage are told: each does the bodies of its side.
typedef struct {
    world *w;
    real h;
    rigid4_result done[2];
} stage;

// Taylor about x, forward by dt and backward by dt_before:
//     x'         = x + v dt        + a dt^2 / 2
//     x_previous = x - v dt_before + a dt_before^2 / 2
// The second gives
//     v dt = ((x - x_previous) + a dt_before^2 / 2) dt / dt_before,
// and put into the first,
//     x' = x + (x - x_previous) dt / dt_before + a dt (dt_before + dt) / 2.
void verlet_step_changed(particle *p, int n, vec3 a, real dt_before, real dt)
{
    assert(n >= 0 && dt_before > 0 && dt > 0 && vec3_is_finite(a));
    real carry = dt / dt_before, square = dt * (dt_before + dt) / 2;
    for (int i = 0; i < n; i++) {
        vec3 here = p[i].position, move = { 0, 0, 0 };
        if (p[i].inverse_mass > 0) {
            vec3 last_move = vec3_sub(here, p[i].previous);
            move = vec3_add_scaled(vec3_scale(carry, last_move), square, a);
        }
        p[i].position = vec3_add(here, move);
        p[i].previous = here;
    }
}

// The first substep of a frame may be longer or shorter than the last one.
static void integrate_side(void *data, int side)
{
    const stage *s = data;
    const world *w = s->w;
    int n;
    const int *mine = halves_bodies(w, side, &n);
    for (int i = 0; i < n; i++) {
        const body *b = &w->body[mine[i]];
        particle *p = w->pool.at + b->first;
        if (!body_moves(w, mine[i])) continue;
        if (w->age == s->h)
            verlet_step(p, body_particles(b), w->options.gravity, NULL, s->h);
        else
            verlet_step_changed(p, body_particles(b), w->options.gravity,
                                w->age, s->h);
    }
}

static void integrate(world *w, real h)
{
    stage s = { .w = w, .h = h };
    halves_do(w, integrate_side, &s);
    // The near lists counted on the pace that was.
    if (w->age != h && w->near.trusted > 0) w->near.trusted = 0;
    w->age = h;
}
//<

//> step-relax-lines
static const plan_entry *entry_of(const world *w, const shape *s)
{
    int k = 0;
    while (w->plan[k].shape != s) k++;
    return &w->plan[k];
}

// Soft diagonals first, then the lines that must hold.
static rigid4_result relax_soft(world *w, const body *b)
{
    const shape *s = b->plan;
    particle *p = w->pool.at + b->first;
    relax_options o = w->options.relax;
    int links = shape_links(s), others = s->sticks - links;
    if (others > 0) sticks_iterate(s->stick + links, others, p, o);
    line_result l = lines_relax(s, p, w->options.sweeps, o,
                                entry_of(w, s)->line);
    int tested = others + l.steps * links;
    return (rigid4_result){ .worst = l.worst, .tested = tested,
                           .relaxed = tested, .iterations = l.steps,
                           .fell_back = l.fell_back };
}
//<

//> step-relax
static void add_up(rigid4_result *sum, rigid4_result r)
{
    sum->tested += r.tested;
    sum->relaxed += r.relaxed;
    sum->fell_back += r.fell_back;
}

// Where the particles of bodies list[0], list[1] ... begin, as long as these
// are of the same four, and move; returns how many.
enum { ALIKE = 32 };

static int find_alike(const world *w, const int *list, int n, int first[ALIKE])
{
    int k = 0;
    for (; k < n && k < ALIKE; k++) {
        const body *b = &w->body[list[k]];
        if (b->four != w->body[list[0]].four || !body_moves(w, list[k])) break;
        first[k] = b->first;
    }
    return k;
}

static void relax_side(void *data, int side)
{
    stage *s = data;
    world *w = s->w;
    const world_options *o = &w->options;
    rigid4_result sum = { .tested = 0 };
    int n, first[ALIKE];
    const int *mine = halves_bodies(w, side, &n);
    for (int i = 0, k; i < n; i += k) {
        const body *b = &w->body[mine[i]];
        k = 1;
        if (body_is_soft(b) || !body_moves(w, mine[i])) continue;
        k = find_alike(w, mine + i, n - i, first);
        add_up(&sum, rigid4_relax_all(b->four, w->pool.at, first, k, o->sweeps,
                                    o->relax));
    }
    s->done[side] = sum;
}

// Lines of one shape share their scratch, so these bodies come one by one.
static void relax(world *w)
{
    stage s = { .w = w };
    halves_do(w, relax_side, &s);
    for (int b = 0; b < w->bodies; b++)
        if (body_is_soft(&w->body[b]) && body_moves(w, b))
            add_up(&s.done[0], relax_soft(w, &w->body[b]));
    add_up(&s.done[0], s.done[1]);
    w->report.tested += s.done[0].tested;
    w->report.relaxed += s.done[0].relaxed;
    w->report.fell_back += s.done[0].fell_back;
}
//<

//> step-rest
// m, whoever goes no further lies still: a hundredth of its shortest stick.
static real stillness(const body *b)
{
    return 0.01 * b->plan->spacing;
}

// Are all particles of b still where it came to lie?  If not, it has come to
// lie here.  (A speed would not do: what slides down a slope begins slowly.)
static int lies_still(world *w, const body *b)
{
    int end = b->first + body_particles(b), moved = 0;
    real far = stillness(b);
    for (int i = b->first; i < end && !moved; i++) {
        vec3 d = vec3_sub(w->pool.at[i].position, w->of.lain[i]);
        moved = !(vec3_length_squared(d) <= far * far);
    }
    for (int i = b->first; i < end && moved; i++)
        w->of.lain[i] = w->pool.at[i].position;
    return !moved;
}

// Whoever sleeps is nailed where it lies, and seen there: the other stages only
// look at what moves.
static void put_to_bed(world *w, body *b)
{
    for (int i = b->first; i < b->first + body_particles(b); i++) {
        particle *p = &w->pool.at[i];
        p->inverse_mass = 0;
        p->previous = p->position;
    }
    world_look_again(w, b);
}

// s, how long an island must lie still: half a second, but longer where gravity
// is weak or a body large.  Whoever is thrown straight up is within d of the
// top for 2 sqrt(2 d / g), and nobody is to sleep there: twice that.
static real patience(const world *w)
{
    real most = 0.5, gravity = vec3_length(w->options.gravity);
    for (int b = 0; b < w->bodies && gravity > 0; b++)
        if (body_moves(w, b))
            most = fmax(most, 4 * sqrt(2 * stillness(&w->body[b]) / gravity));
    return most;
}

// Bodies that pushed each other in this frame, and lay still for as long as
// patience asks, fall asleep together.
static void rest(world *w)
{
    char *still = w->flags.still;
    for (int b = 0; b < w->bodies; b++)
        still[b] = (char)(!body_moves(w, b) || lies_still(w, &w->body[b]));
    rest_end(&w->rest, still, w->options.dt, patience(w));
    w->report.asleep = 0;
    for (int b = 0; b < w->bodies; b++) {
        if (!w->rest.asleep[b] || body_is_nailed(&w->body[b])) continue;
        if (w->flags.moves[b]) put_to_bed(w, &w->body[b]);
        w->report.asleep++;
    }
}
//<

//> step-join
static int spheres_meet(sphere a, sphere b, real margin)
{
    real r = a.radius + b.radius + margin;
    return vec3_distance(a.center, b.center) <= r;
}

// A deformable body wakes, and rests with, whatever its sphere meets, with
// twice the margin of the near lists for what this frame will bring.
static void join_soft(world *w)
{
    for (int b = 0; b < w->bodies; b++)
        if (body_moves(w, b)) world_look_again(w, &w->body[b]);
    for (int a = 0; a < w->bodies; a++) {
        body *soft = &w->body[a];
        if (!body_is_soft(soft) || body_is_nailed(soft)) continue;
        sphere ball = sphere_tree_root(&soft->tree, w->of.at + soft->corner);
        for (int b = 0; b < w->bodies; b++) {
            body *x = &w->body[b];
            if (b == a || body_is_nailed(x)) continue;
            sphere other = sphere_tree_root(&x->tree, w->of.at + x->corner);
            if (!spheres_meet(ball, other, 2 * w->near.margin)) continue;
            pairs_wake(w, a, b);
            rest_touch(&w->rest, a, b);
        }
    }
}
//<

//> step-substeps
// In a substep nothing should go further than a share of its own radius: the
// inner one of a rigid body, half the spacing of a deformable one.
static int substeps_for(const world *w, const body *b, real share)
{
    real radius = body_is_soft(b) ? b->plan->spacing / 2 : b->inner;
    real need = (vec3_length(b->way) + b->turn) / (share * radius);
    if (!(need < w->options.most_substeps)) return w->options.most_substeps;
    return (int)need + ((int)need < need);
}

// What a deformable body may meet in this frame, itself among it.  A rigid body
// drives the light particles of a cloth before it, their sticks pull them back,
// and it must not be past them before their whole weight has stopped it: a
// quarter of its radius.
static int substeps_for_soft(world *w, body *soft)
{
    int n = 0;
    sphere ball = sphere_tree_root(&soft->tree, w->of.at + soft->corner);
    for (int k = 0; k < w->bodies; k++) {
        body *b = &w->body[k];
        sphere other = sphere_tree_root(&b->tree, w->of.at + b->corner);
        if (spheres_meet(ball, other, soft->reach + b->reach))
            n = int_max(n, substeps_for(w, b, body_is_soft(b) ? 1 : 0.25));
    }
    return n;
}

// So many substeps that no rigid body goes further than a sixth of its inner
// radius in one, within the bounds that the options set.  The lines of a
// deformable body count on all of their substeps.
static int substeps_at_this_pace(const world *w)
{
    int n = w->options.least_substeps, most = w->options.substeps;
    for (int k = 0; k < w->bodies && n < most; k++) {
        const body *b = &w->body[k];
        if (body_is_nailed(b)) continue;
        n = body_is_soft(b) ? most : int_max(n, substeps_for(w, b, 1.0 / 6));
    }
    return n < most ? n : most;
}

// Paper: section 7 asks for very small steps where things are thin; here: as
// small as it takes for what will, or may, touch something in this frame.
static int choose_substeps(world *w)
{
    int n = substeps_at_this_pace(w);
    for (int k = 0; k < w->bodies; k++)
        if (body_is_soft(&w->body[k])) pairs_look_ahead(w, &w->body[k]);
    for (int k = 0; k < w->bodies; k++)
        if (body_is_soft(&w->body[k]))
            n = int_max(n, substeps_for_soft(w, &w->body[k]));
    for (int k = 0; k < w->pairs.count; k++) {
        const body_pair *x = &w->pairs.at[k];
        const body *a = &w->body[x->a], *b = &w->body[x->b];
        if (pairs_fly_into(w, a, b))
            n = int_max(n, int_max(substeps_for(w, a, 1),
                                   substeps_for(w, b, 1)));
    }
    return n;
}
//<

//> step-substep
static void find(world *w, real *since)
{
    pairs_find(w);
    lap(w, STAGE_PAIRS, since);
    w->report.substeps = choose_substeps(w);
    narrow_find(w);
    lap(w, STAGE_QUERY, since);
}

static void substep(world *w, int k, real h, real *since)
{
    if (k > 0) narrow_find_again(w, k);
    lap(w, STAGE_QUERY, since);
    integrate(w, h);
    ledger_book(w, LEDGER_INTEGRATE);
    lap(w, STAGE_INTEGRATE, since);
    if (w->softs > 0) soft_refresh(w);
    lap(w, STAGE_PAIRS, since);
    solver_separate(w, h);
    if (w->softs > 0) soft_separate(w);
    ledger_book(w, LEDGER_CONTACTS);
    lap(w, STAGE_SEPARATE, since);
    relax(w);
    ledger_book(w, LEDGER_STICKS);
    if (w->softs > 0) soft_hold(w);
    ledger_book(w, LEDGER_CONTACTS);
    lap(w, STAGE_RELAX, since);
}
//<

//> step
void world_step(world *w)
{
    assert(w->ready);
    const world_options *o = &w->options;
    real since = clock_now(w);
    w->report = (step_report){ .substeps = o->substeps };
    ledger_open(w);
    rest_begin(&w->rest);
    if (w->softs > 0) join_soft(w);
    // Paper: bodies move, then overlaps are looked for; here: what may touch in
    // this frame is found before anything moves.
    find(w, &since);
    real h = o->dt / w->report.substeps;
    for (int k = 0; k < w->report.substeps; k++) substep(w, k, h, &since);
    solver_end(w);
    if (o->resting) rest(w);
    ledger_book(w, LEDGER_REST);
    w->time += o->dt;
    lap(w, STAGE_REST, &since);
}
//<
