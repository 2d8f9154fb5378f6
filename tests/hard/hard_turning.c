// hard_turning.c - cases 11 and 12: bodies that turn in space, free.

#include "body.h"
#include "hard.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#ifndef SPINNING_BOX
#define SPINNING_BOX "tests/data/spinning_box.txt"
#endif

static const real PI = 3.14159265358979323846;
static const vec3 ORIGIN = { 0, 0, 0 };

// A box of eight equal masses of 1 kg on its sticks, turning about its middle.
typedef struct {
    shape plan;
    particle p[8];
    vec3 inertia;       // kg m^2, about its axes
    vec3 momentum;      // kg m^2/s, angular
    real dt;
    int  failed;
} top;

static vec3 times(vec3 a, vec3 b)
{
    return vec3_make(a.x * b.x, a.y * b.y, a.z * b.z);
}

// The first acceleration of each particle is w' x r + w x (w x r), with Euler's
// I w' = (I w) x w.
static status top_start(top *t, vec3 sides, vec3 w, real dt)
{
    *t = (top){ .dt = dt };
    status made = shape_box(&t->plan, sides, 8);
    if (!made.ok) return made;
    vec3 s = times(sides, sides);
    t->inertia = vec3_make(2 * (s.y + s.z), 2 * (s.z + s.x), 2 * (s.x + s.y));
    t->momentum = times(t->inertia, w);
    vec3 turn = vec3_cross(t->momentum, w);
    turn.x /= t->inertia.x;
    turn.y /= t->inertia.y;
    turn.z /= t->inertia.z;
    for (int i = 0; i < 8; i++) {
        vec3 r = t->plan.at[i], v = vec3_cross(w, r);
        vec3 a = vec3_add(vec3_cross(turn, r), vec3_cross(w, v));
        t->p[i] = particle_start(r, v, a, 1, dt);
    }
    return made;
}

// The sticks are relaxed until what is left is little beside the error of dt.
static void top_step(top *t)
{
    relax_options o = relax_options_default();
    o.tolerance = 1e-10;
    verlet_step(t->p, 8, ORIGIN, NULL, t->dt);
    relax_result r = sticks_relax(t->plan.stick, t->plan.sticks, t->p, 100, o);
    t->failed += !(r.worst <= 1e-3);
}

// The body's axis now, a unit vector: bit 1, 2 or 4 of a particle's number says
// on which side of it the particle stands.
static vec3 top_axis(const top *t, int bit)
{
    vec3 sum = ORIGIN;
    for (int i = 0; i < 8; i++)
        sum = vec3_add_scaled(sum, i & bit ? 1 : -1, t->p[i].position);
    return vec3_unit(sum);
}

// ---- 11: the middle axis ---------------------------------------------------

// A flip: the part of the angular speed along the middle axis changes sign.
enum { FLIPS = 16 };
typedef struct { int count; real at[FLIPS]; } flips;

static void flip_add(flips *f, real at)
{
    if (f->count < FLIPS) f->at[f->count] = at;
    f->count++;
}

// Where the cubic with values a, b and slopes p, q at t = 0 and h passes zero.
static real cubic_zero(real a, real b, real p, real q, real h)
{
    real low = 0, high = 1;
    for (int k = 0; k < 60; k++) {
        real s = (low + high) / 2, u = 1 - s;
        real y = u * u * (1 + 2 * s) * a + s * s * (1 + 2 * u) * b
               + h * s * u * (u * p - s * q);
        if ((y > 0) == (a > 0)) low = s;
        else                    high = s;
    }
    return h * low;
}

// From the stored angular speeds; their slope is (Iz - Ix) wz wx / Iy.
static flips flips_known(void)
{
    flips f = { 0, { 0 } };
    FILE *file = fopen(SPINNING_BOX, "r");
    char line[200];
    real t, x, y, z, t0 = 0, y0 = 0, slope0 = 0;
    while (file && fgets(line, sizeof line, file)) {
        if (sscanf(line, "%lf %lf %lf %lf", &t, &x, &y, &z) != 4) continue;
        real slope = (10.0 - 26) / 20 * z * x;
        if (y * y0 < 0)
            flip_add(&f, t0 + cubic_zero(y0, y, slope0, slope, t - t0));
        t0 = t;
        y0 = y;
        slope0 = slope;
    }
    if (file) fclose(file);
    return f;
}

// Of the box of 1 x 2 x 3 m within 20 s.  Seen from the body, the angular
// momentum's part along the middle axis is Iy wy: it passes zero with wy.
static flips flips_of_box(int substeps, int *failed)
{
    flips f = { 0, { 0 } };
    top t;
    if (!top_start(&t, vec3_make(1, 2, 3), vec3_make(0.01, 5, 0.01),
                   1.0 / 60 / substeps).ok)
        return f;
    real before = vec3_dot(t.momentum, top_axis(&t, 2));
    for (int n = 1; n <= 1200 * substeps; n++) {
        top_step(&t);
        real now = vec3_dot(t.momentum, top_axis(&t, 2));
        if (now * before < 0)
            flip_add(&f, (n - now / (now - before)) * t.dt);
        before = now;
    }
    *failed = t.failed;
    shape_free(&t.plan);
    return f;
}

// s, the flip that is furthest off in time; infinite if one is missing.
static real flips_apart(const flips *a, const flips *b)
{
    real worst = a->count > 0 && a->count == b->count ? 0 : HUGE_VAL;
    for (int k = 0; k < a->count && k < b->count && k < FLIPS; k++)
        worst = hard_worse(worst, fabs(a->at[k] - b->at[k]));
    return worst;
}

static void middle_axis(hard_report *r, int fast)
{
    int failed = 0, substeps = 8;
    flips known = flips_known(), found = flips_of_box(substeps, &failed);
    hard_add(r, abs(known.count - found.count), 0, "", "flips too many or few");
    for (int k = 0; k < known.count && k < found.count; k++)
        hard_add(r, 1e3 * fabs(found.at[k] - known.at[k]), 5, "ms",
                 "flip %d at %.3f s; %d substeps", k + 1, known.at[k],
                 substeps);
    hard_add(r, failed, 0, "", "times that the old gradient failed");
    for (int n = 1; n <= 32 && !fast; n *= 2) {
        found = flips_of_box(n, &failed);
        hard_note(r, "%2d substeps: %d of %d flips, off by %.2f ms", n,
                  found.count, known.count, 1e3 * flips_apart(&found, &known));
    }
}

// ---- 12: a symmetric top ---------------------------------------------------

// A box of 1 x 1 x 2 m that spins about its long axis and across it: the axis
// goes round the angular momentum L with |L| / I, I across.  Returns the
// relative error of that rate over 10 s.
static real precession_error(int substeps, real *nutation)
{
    top t;
    int steps = 600 * substeps;
    if (!top_start(&t, vec3_make(1, 1, 2), vec3_make(3, 0, 5),
                   1.0 / 60 / substeps).ok)
        return HUGE_VAL;
    vec3 up = vec3_unit(t.momentum), axis = top_axis(&t, 4);
    vec3 east = vec3_unit(vec3_add_scaled(axis, -vec3_dot(axis, up), up));
    vec3 north = vec3_cross(up, east);
    real tilt = vec3_dot(axis, up), total = 0, last = 0;
    *nutation = 0;
    for (int n = 0; n < steps; n++) {
        top_step(&t);
        axis = top_axis(&t, 4);
        real now = atan2(vec3_dot(axis, north), vec3_dot(axis, east));
        real turn = now - last;
        total += turn < -PI ? turn + 2 * PI : turn;
        last = now;
        real nod = acos(vec3_dot(axis, up)) - acos(tilt);
        *nutation = hard_worse(*nutation, fabs(nod));
    }
    shape_free(&t.plan);
    real rate = vec3_length(t.momentum) / t.inertia.x;
    return fabs(total / (steps * t.dt * rate) - 1);
}

static void symmetric_top(hard_report *r, int fast)
{
    enum { RUNGS = 4 };
    real dt[RUNGS], error[RUNGS], nutation[RUNGS];
    (void)fast;
    for (int k = 0; k < RUNGS; k++) {
        int substeps = 4 << k;
        dt[k] = 1.0 / 60 / substeps;
        error[k] = precession_error(substeps, &nutation[k]);
    }
    hard_add(r, error[1], 1e-3, "", "precession rate; 8 substeps");
    hard_add(r, fabs(hard_order(dt, error, RUNGS) - 2), 0.1, "",
             "order %.3f from 2; 4 to 32 substeps",
             hard_order(dt, error, RUNGS));
    hard_note(r, "4 substeps: %.1e, 32: %.1e; nutation, none in truth: %.1e "
              "and %.1e rad", error[0], error[RUNGS - 1], nutation[0],
              nutation[RUNGS - 1]);
}

const hard_case hard_turning[] = {
    { 11, "box about its middle axis, 20 s", 1, middle_axis },
    { 12, "symmetric top, 10 s", 1, symmetric_top },
    { 0, NULL, 0, NULL }
};
