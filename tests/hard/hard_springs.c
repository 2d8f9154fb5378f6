// hard_springs.c - see hard_springs.h.

#include "hard_springs.h"
#include "line.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

enum { DICE = 8, STEPS = 20000 };       // cubes, at most; steps a second

typedef struct {
    vec3 at, speed, spin;   // m, m/s, rad/s
    vec3 axis[3];           // unit
    real half, mass;        // m, of its side; kg
    vec3 force, moment;     // N, N m
} die;

typedef struct {
    vec3 at, speed, force;
    real mass;              // kg; 0: pinned
} bead;

typedef struct {
    const shape *plan;
    bead *bead;
    real link, shear;       // N/m
    real gap;               // m, from a bead to a die
    real friction;
    vec3 gravity;
    die  die[DICE];
    int  dice;
    real strain;            // of the longest or shortest link
} springs;

// Where two touch: a spring (N/m), and a brake (N s/m) that takes what swings.
typedef struct {
    real stiffness, brake;
} buffer;
static const buffer SOFT = { 2000, 0.3 }, HARD = { 5000, 3 };

// ---- forces ----------------------------------------------------------------

// What a buffer that is pressed in by `deep` (m) pushes along the normal (unit),
// with friction, while its ends pass each other with `rel` (m/s).
static vec3 pushed(buffer b, real deep, vec3 normal, vec3 rel, real friction)
{
    real up = vec3_dot(rel, normal);
    real load = real_max(b.stiffness * deep - b.brake * up, 0);
    vec3 slide = vec3_add_scaled(rel, -up, normal);
    real speed = vec3_length(slide);
    vec3 force = vec3_scale(load, normal);
    if (!(speed > 0)) return force;
    return vec3_add_scaled(force, -real_min(friction * load / speed, b.brake),
                           slide);
}

static vec3 die_speed(const die *d, vec3 arm)
{
    return vec3_add(d->speed, vec3_cross(d->spin, arm));
}

static void die_push(die *d, vec3 arm, vec3 force)
{
    d->force = vec3_add(d->force, force);
    d->moment = vec3_add(d->moment, vec3_cross(arm, force));
}

// m, how far x is off the die, less than 0 inside; and the way out, unit.
static real die_off(const die *d, vec3 x, vec3 *out)
{
    vec3 from = vec3_sub(x, d->at), beside = { 0, 0, 0 };
    int face = 0;
    real most = 0;
    for (int k = 0; k < 3; k++) {
        real far = vec3_dot(from, d->axis[k]);
        real over = far - real_max(real_min(far, d->half), -d->half);
        beside = vec3_add_scaled(beside, over, d->axis[k]);
        if (fabs(far) > fabs(most)) {
            most = far;
            face = k;
        }
    }
    real off = vec3_length(beside);
    if (off > 0) *out = vec3_scale(1 / off, beside);
    else *out = vec3_scale(most < 0 ? -1 : 1, d->axis[face]);
    return off > 0 ? off : fabs(most) - d->half;
}

static void pull(springs *s, int k, real stiffness)
{
    const stick *t = &s->plan->stick[k];
    bead *a = &s->bead[t->a], *b = &s->bead[t->b];
    vec3 across = vec3_sub(b->at, a->at);
    real length = vec3_length(across), longer = length - t->rest_length;
    vec3 force = vec3_scale(stiffness * longer / length, across);
    a->force = vec3_add(a->force, force);
    b->force = vec3_sub(b->force, force);
    if (k < shape_links(s->plan))
        s->strain = real_max(s->strain, fabs(longer / t->rest_length));
}

static void meet_bead(springs *s, die *d, bead *b)
{
    vec3 from = vec3_sub(b->at, d->at), out;
    real far = 2 * d->half + s->gap;
    if (vec3_length_squared(from) > far * far) return;
    real off = die_off(d, b->at, &out);
    if (off >= s->gap) return;
    vec3 arm = vec3_add_scaled(from, -off, out);
    vec3 rel = vec3_sub(b->speed, die_speed(d, arm));
    vec3 force = pushed(SOFT, s->gap - off, out, rel, s->friction);
    b->force = vec3_add(b->force, force);
    die_push(d, arm, vec3_scale(-1, force));
}

// A point of die a, at this arm.
static void meet_point(const springs *s, die *a, vec3 arm, die *b)
{
    vec3 x = vec3_add(a->at, arm), other = vec3_sub(x, b->at), out;
    real off = die_off(b, x, &out);
    if (off >= 0) return;
    vec3 rel = vec3_sub(die_speed(a, arm), die_speed(b, other));
    vec3 force = pushed(HARD, -off, out, rel, s->friction);
    die_push(a, arm, force);
    die_push(b, other, vec3_scale(-1, force));
}

// Nine points of each edge of a.
static void meet_die(const springs *s, die *a, die *b)
{
    real far = 2 * sqrt(3) * real_max(a->half, b->half);
    if (vec3_distance(a->at, b->at) > far) return;
    for (int edge = 0; edge < 12; edge++) {
        int along = edge % 3, up = edge / 3 % 2, left = edge / 6;
        vec3 middle = vec3_add(
            vec3_scale(up ? a->half : -a->half, a->axis[(along + 1) % 3]),
            vec3_scale(left ? a->half : -a->half, a->axis[(along + 2) % 3]));
        for (int k = -4; k <= 4; k++)
            meet_point(s, a, vec3_add_scaled(middle, a->half * k / 4,
                                             a->axis[along]), b);
    }
}

static void add_forces(springs *s)
{
    int links = shape_links(s->plan);
    s->strain = 0;
    for (int i = 0; i < s->plan->particles; i++)
        s->bead[i].force = vec3_scale(s->bead[i].mass, s->gravity);
    for (int k = 0; k < s->plan->sticks; k++)
        pull(s, k, k < links ? s->link : s->shear);
    for (int d = 0; d < s->dice; d++) {
        s->die[d].force = vec3_scale(s->die[d].mass, s->gravity);
        s->die[d].moment = vec3_make(0, 0, 0);
    }
    for (int d = 0; d < s->dice; d++) {
        for (int i = 0; i < s->plan->particles; i++)
            meet_bead(s, &s->die[d], &s->bead[i]);
        for (int k = 0; k < s->dice; k++)
            if (k != d) meet_die(s, &s->die[d], &s->die[k]);
    }
}

// ---- motion ----------------------------------------------------------------

// The axes follow the spin, and are made perpendicular again.
static void die_turn(die *d, real h)
{
    vec3 *a = d->axis;
    for (int k = 0; k < 2; k++)
        a[k] = vec3_add_scaled(a[k], h, vec3_cross(d->spin, a[k]));
    a[0] = vec3_unit(a[0]);
    a[2] = vec3_unit(vec3_cross(a[0], a[1]));
    a[1] = vec3_cross(a[2], a[0]);
}

// A cube turns about each axis alike: m (2 half)^2 / 6.
static void die_move(die *d, real h)
{
    real inertia = d->mass * d->half * d->half * 2 / 3;
    d->speed = vec3_add_scaled(d->speed, h / d->mass, d->force);
    d->spin = vec3_add_scaled(d->spin, h / inertia, d->moment);
    d->at = vec3_add_scaled(d->at, h, d->speed);
    die_turn(d, h);
}

static void step(springs *s, real h)
{
    add_forces(s);
    for (int i = 0; i < s->plan->particles; i++) {
        bead *b = &s->bead[i];
        if (!(b->mass > 0)) continue;
        b->speed = vec3_add_scaled(b->speed, h / b->mass, b->force);
        b->at = vec3_add_scaled(b->at, h, b->speed);
    }
    for (int d = 0; d < s->dice; d++) die_move(&s->die[d], h);
}

// ---- from a world ----------------------------------------------------------

// Three edges meet in its first corner.
static die die_of(const world *w, const body *b)
{
    enum { CORNERS = 8 };
    vec3 at[CORNERS];
    die d = { .mass = b->mass };
    real side = HUGE_VAL;
    int found = 0;
    assert(b->shape->particles == CORNERS);
    world_vertices(w, b, at);
    for (int i = 0; i < CORNERS; i++) {
        d.at = vec3_add_scaled(d.at, 1.0 / CORNERS, at[i]);
        if (i > 0) side = real_min(side, vec3_distance(at[0], at[i]));
    }
    for (int i = 1; i < CORNERS && found < 3; i++)
        if (vec3_distance(at[0], at[i]) < 1.1 * side)
            d.axis[found++] = vec3_unit(vec3_sub(at[i], at[0]));
    d.axis[2] = vec3_cross(d.axis[0], d.axis[1]);
    d.half = side / 2;
    return d;
}

static bool springs_begin(springs *s, const world *w, real shear)
{
    const body *b = &w->body[0];
    const strands along = shape_strands(b->shape, 0);
    assert(b->compliance > 0 && w->bodies <= 1 + DICE);
    *s = (springs){ .plan = b->shape, .shear = shear, .gap = b->thickness,
                    .friction = w->options.friction,
                    .gravity = w->options.gravity, .dice = w->bodies - 1 };
    s->link = shape_width(b->shape, 0) / (b->compliance * along.rest_length);
    s->bead = calloc((size_t)b->shape->particles, sizeof *s->bead);
    if (!s->bead) return false;
    for (int i = 0; i < b->shape->particles; i++) {
        const particle *p = &w->pool.at[b->first + i];
        s->bead[i].at = p->position;
        s->bead[i].mass = p->inverse_mass > 0 ? 1 / p->inverse_mass : 0;
    }
    for (int d = 0; d < s->dice; d++) s->die[d] = die_of(w, &w->body[1 + d]);
    return true;
}

real springs_strain(const world *w, real shear, real seconds)
{
    springs s;
    real most = 0;
    long steps = (long)(STEPS * seconds);
    long frame = (long)(STEPS * w->options.dt);
    if (!springs_begin(&s, w, shear)) return HUGE_VAL;
    for (long k = 1; k <= steps; k++) {
        step(&s, 1.0 / STEPS);
        if (k % frame == 0) most = real_max(most, s.strain);
    }
    free(s.bead);
    return most;
}
