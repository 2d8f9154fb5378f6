// 21-body.c - what a body is made of: a particle at every vertex, held by edges
// and diagonals or by the edges of a tetrahedralisation, or four particles that
// the vertices ride on.  A vertex is struck: how fast does it go, beside a
// solid body's answer, and what does it cost to find out?
//
// index 0: body, model, particles, sticks, error of the largest moment of
//          inertia; then for each body and model: sweeps (or steps of Newton),
//          ns, median error of the answer.

#include "ball.h"
#include "clock.h"
#include "convex.h"
#include "random.h"
#include "rigid4.h"
#include "shake.h"
#include "interleave.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

typedef enum { DIAGONALS, TETRAHEDRA, FOURS, MODELS } model;
static const char *const NAME[MODELS] = {
    "edges and diagonals", "tetrahedralised", "four particles"
};
enum { BODIES = 2, SIZES = 9, BLOWS = 42, ROUNDS = 9, MOST = 42,
       DIAGONALS_MOST = 256 };
static const char *const BODY[BODIES] = { "brick", "ball of 42" };

// A symmetric matrix of the second moments of mass, kg m^2.
typedef struct { real m[3][3]; } moments;

static void add_outer(moments *q, real s, vec3 a, vec3 b)
{
    const real u[3] = { a.x, a.y, a.z }, v[3] = { b.x, b.y, b.z };
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) q->m[i][j] += s * u[i] * v[j];
}

// Of the solid with the mass of s, about the plan's origin, which is its centre
// for both bodies.  A tetrahedron (0, a, b, c) of volume V has the moments
// V / 20 ((a + b + c)(a + b + c)' + a a' + b b' + c c').
static moments solid_moments(const shape *s, real mass)
{
    moments q = { { { 0 } } };
    real volume = mesh_volume(&s->mesh, s->at);
    for (int f = 0; f < s->mesh.faces; f++) {
        const int *v = &s->face[3 * f];
        vec3 a = s->at[v[0]], b = s->at[v[1]], c = s->at[v[2]];
        vec3 sum = vec3_add(vec3_add(a, b), c);
        real part = vec3_dot(a, vec3_cross(b, c)) / 6 / volume * mass / 20;
        add_outer(&q, part, sum, sum);
        add_outer(&q, part, a, a);
        add_outer(&q, part, b, b);
        add_outer(&q, part, c, c);
    }
    return q;
}

static moments particle_moments(const vec3 *at, int n, real each)
{
    moments q = { { { 0 } } };
    for (int i = 0; i < n; i++) add_outer(&q, each, at[i], at[i]);
    return q;
}

// Both bodies lie along the axes: their tensors of inertia are diagonal.
static vec3 inertia(moments q)
{
    real x = q.m[0][0], y = q.m[1][1], z = q.m[2][2];
    return vec3_make(y + z, z + x, x + y);
}

// ---- the models ------------------------------------------------------------

typedef struct {
    shape plan;
    rigid4 four;
    stick across[DIAGONALS_MOST];
    int acrosses;
    vec3 inertia;               // kg m^2, of the solid
    vec3 push[BLOWS];           // unit
    int  struck[BLOWS];         // vertex
    real mass;
    int  blow;                  // what the race repeats
    particle p[MOST];
} body_of;

static unsigned long long seed = 1;

// The edges of the mesh, and a stick between any two opposite corners.
static void add_diagonals(body_of *b)
{
    const shape *s = &b->plan;
    for (int i = 0; i < s->particles; i++)
        for (int j = i + 1; j < s->particles; j++) {
            vec3 sum = vec3_add(s->at[i], s->at[j]);
            int joined = vec3_length(sum) < 1e-6 * s->radius;
            for (int h = 0; h < 2 * s->mesh.edges; h++)
                joined |= s->mesh.half[h].origin == i
                       && mesh_target(&s->mesh, h) == j;
            if (!joined) continue;
            real rest = vec3_distance(s->at[i], s->at[j]);
            b->across[b->acrosses++] = (stick){ i, j, rest, 1, STICK_EXACT };
        }
}

static int brick_shape(shape *s)
{
    shape box;
    int triangle[12][3];
    if (!shape_box(&box, vec3_make(1, 0.6, 0.3), 1).ok) return 0;
    for (int f = 0; f < 12; f++) mesh_face(&box.mesh, f, triangle[f]);
    int ok = shape_convex(s, 8, box.at, 12, (const int (*)[3])triangle, 1).ok;
    shape_free(&box);
    return ok;
}

static int body_make(body_of *b, int which)
{
    *b = (body_of){ .mass = 1 };
    int ok = which == 0 ? brick_shape(&b->plan)
                        : ball_shape(&b->plan, 1, 0.5, 1).ok;
    if (!ok || !rigid4_build(&b->four, &b->plan).ok) return 0;
    add_diagonals(b);
    if (!interleave(b->across, b->acrosses, b->plan.particles))
        return 0;
    b->inertia = inertia(solid_moments(&b->plan, b->mass));
    for (int k = 0; k < BLOWS; k++) {
        real x = random_real(&seed), y = random_real(&seed);
        b->push[k] = vec3_unit(vec3_make(x, y, random_real(&seed)));
        b->struck[k] = k % b->plan.particles;
    }
    return 1;
}

// ---- a blow ----------------------------------------------------------------

static int size_of(int way)
{
    return 1 << way % SIZES;
}

// kg m: so small that what is not linear does not count.
static const real BLOW = 1e-9;

static void strike_vertices(body_of *b, const stick *s, int sticks, int sweeps,
                            relax_options o)
{
    real w = b->plan.particles / b->mass;
    for (int i = 0; i < b->plan.particles; i++)
        b->p[i] = (particle){ b->plan.at[i], b->plan.at[i], w };
    vec3 *x = &b->p[b->struck[b->blow]].position;
    *x = vec3_add_scaled(*x, w * BLOW, b->push[b->blow]);
    for (int k = 0; k < sweeps; k++)
        sticks_iterate(s, sticks, b->p, o);
}

// The share of particle k in what vertex v of a body of four does.
static real share_of(const rigid4 *four, int v, int k)
{
    const real *t = FOUR_SIGN[k];
    vec3 at = four->local[v];
    return (1 + t[0] * at.x + t[1] * at.y + t[2] * at.z) / FOUR;
}

static void strike_four(body_of *b, int steps, relax_options o)
{
    real w = FOUR / b->mass;
    int v = b->struck[b->blow];
    for (int i = 0; i < FOUR; i++) {
        vec3 x = b->four.at[i];
        b->p[i] = (particle){ x, x, w };
        b->p[i].position = vec3_add_scaled(x, w * share_of(&b->four, v, i)
                                              * BLOW, b->push[b->blow]);
    }
    shake(&b->four, b->p, steps, o);
}

static void work(int way, void *with)
{
    body_of *b = with;
    relax_options o = relax_options_default();
    o.tolerance = 0;
    model m = (model)(way / SIZES);
    if (m == FOURS) strike_four(b, size_of(way), o);
    else if (m == DIAGONALS)
        strike_vertices(b, b->across, b->acrosses, size_of(way), o);
    else
        strike_vertices(b, b->plan.stick, b->plan.sticks, size_of(way), o);
    b->blow = (b->blow + 1) % BLOWS;
}

// How far the struck vertex has gone along the push.
static real went(const body_of *b, int blow, model m)
{
    int v = b->struck[blow];
    vec3 way = { 0, 0, 0 };
    if (m != FOURS) way = vec3_sub(b->p[v].position, b->p[v].previous);
    for (int i = 0; i < FOUR && m == FOURS; i++)
        way = vec3_add_scaled(way, share_of(&b->four, v, i),
                              vec3_sub(b->p[i].position, b->p[i].previous));
    return vec3_dot(way, b->push[blow]);
}

// A solid answers 1/M + (r x d) . I^-1 (r x d).
static real truth(const body_of *b, int blow)
{
    vec3 t = vec3_cross(b->plan.at[b->struck[blow]], b->push[blow]);
    vec3 I = b->inertia;
    return BLOW * (1 / b->mass + t.x * t.x / I.x + t.y * t.y / I.y
                   + t.z * t.z / I.z);
}

static real error_of(body_of *b, int way)
{
    real error[BLOWS];
    b->blow = 0;
    for (int k = 0; k < BLOWS; k++) {
        work(way, b);
        real right = truth(b, k);
        error[k] = fabs(went(b, k, (model)(way / SIZES)) - right) / right;
    }
    return clock_median(error, BLOWS);
}

// ---- telling ---------------------------------------------------------------

static real inertia_error(const body_of *b, model m)
{
    int n = m == FOURS ? FOUR : b->plan.particles;
    vec3 I = inertia(particle_moments(m == FOURS ? b->four.at : b->plan.at, n,
                                      b->mass / n));
    real x = I.x / b->inertia.x, y = I.y / b->inertia.y, z = I.z / b->inertia.z;
    return fmax(fabs(x - 1), fmax(fabs(y - 1), fabs(z - 1)));
}

static void print_model(const body_of *b, const char *name, model m)
{
    const int sticks[MODELS] = { b->acrosses, b->plan.sticks, FOUR_STICKS };
    printf("\"%s\" \"%s\" %d %d %.3g\n", name, NAME[m],
           m == FOURS ? FOUR : b->plan.particles, sticks[m],
           inertia_error(b, m));
}

static void print_curves(body_of *b, const char *name)
{
    lap l[MODELS * SIZES];
    real error[MODELS * SIZES], seconds[MODELS * SIZES];
    for (int way = 0; way < MODELS * SIZES; way++)
        error[way] = error_of(b, way);
    clock_race((race){ MODELS * SIZES, ROUNDS, 1e-3, work, b }, l);
    for (int way = 0; way < MODELS * SIZES; way++) {
        if (way % SIZES == 0)
            printf("\n\n# %s, %s\n# n ns error\n", name, NAME[way / SIZES]);
        seconds[way] = l[way].seconds;
        printf("%d %.4g %.3g\n", size_of(way), 1e9 * l[way].seconds,
               error[way]);
    }
    for (int m = DIAGONALS; m < FOURS; m++) {
        real most = error[m * SIZES + SIZES - 1];
        char at[32];
        snprintf(at, sizeof at, "%.0f %% of the impact", 100 * most);
        real slow = clock_at_error(&seconds[m * SIZES], &error[m * SIZES],
                                   SIZES, 1.01 * most);
        clock_print_row("body", name, at, NAME[FOURS], NAME[m],
                        slow / seconds[FOURS * SIZES]);
    }
}

int main(void)
{
    static body_of b[BODIES];
    clock_print_head("21-body: time and error of a blow's answer", FLAGS);
    for (int k = 0; k < BODIES; k++)
        if (!body_make(&b[k], k)) return 1;
    printf("# body model particles sticks inertia_error\n");
    for (int k = 0; k < BODIES; k++)
        for (model m = DIAGONALS; m < MODELS; m++)
            print_model(&b[k], BODY[k], m);
    for (int k = 0; k < BODIES; k++) {
        print_curves(&b[k], BODY[k]);
        rigid4_free(&b[k].four);
        shape_free(&b[k].plan);
    }
    return 0;
}
