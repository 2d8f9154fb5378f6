// solids.h - solids whose inertia is known, and chance, for the tests of
// chapter 13.
//
// Needs check.h before it.

#ifndef TUMBLE_SOLIDS_H
#define TUMBLE_SOLIDS_H

#include "convex.h"
#include "expect.h"
#include "random.h"
#include "rigid4.h"

// A few roundings of the largest term: sums of up to a hundred.
#define ROUNDING 1e-13
// The same for bodies up to ten times as long as wide, whose sticks' matrix has
// a condition of up to 10^4.
#define LONG_BODY 1e-12

// --- chance ------------------------------------------------------------------

static unsigned long long seed;

// Columns: where x, y and z go.
typedef struct {
    vec3 x, y, z;
} matrix;

static inline vec3 times(const matrix *m, vec3 a)
{
    return vec3_add(vec3_scale(a.x, m->x),
           vec3_add(vec3_scale(a.y, m->y), vec3_scale(a.z, m->z)));
}

static inline matrix any_rotation(void)
{
    matrix m = { .x = random_direction(&seed) };
    m.y = vec3_unit(vec3_cross(m.x, random_direction(&seed)));
    m.z = vec3_cross(m.x, m.y);
    return m;
}

// Any turning, stretching and shearing that neither flattens nor mirrors.
static inline matrix any_affine(void)
{
    matrix m = { random_vec3(&seed, 1), random_vec3(&seed, 1),
                 random_vec3(&seed, 1) };
    real volume = vec3_dot(m.x, vec3_cross(m.y, m.z));
    return volume > 0.1 ? m : any_affine();
}

// --- solids that are known ---------------------------------------------------

// Their centre, measured from the mean of the vertices, and the mean of x x^T
// about it.
typedef struct {
    shape plan;
    vec3  center;
    real  spread[3];    // m^2, of x x, y y, z z: the others are 0
} known;

enum { BOX, BALL, WEDGE, HOUSE, SOLIDS };

static known solid[SOLIDS];
static rigid4 f;

// Any tetrahedron is an affine image of this one, whose spread is that of its
// corners divided by 5: each corner's square is 1, and sum x x^T / 20 = 1 / 5.
static inline void make_wedge(known *k)
{
    const vec3 at[4] = { { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 },
                         { -1, -1, 1 } };
    const int face[4][3] = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 },
                             { 1, 3, 2 } };
    expect_ok(shape_convex(&k->plan, 4, at, 4, face, 3));
    for (int i = 0; i < 3; i++) k->spread[i] = 1.0 / 5;
}

// A box of sides 2, 1, 2 under a roof with four sides, 3 high: lopsided.  The
// roof's volume is 4, its centre 3/4 above its base, its spread 3 * 3^2 / 80 in
// height, 2^2 / 20 across.
static inline void make_house(known *k)
{
    const vec3 at[9] = { { -1, 0, -1 }, { 1, 0, -1 }, { 1, 0, 1 }, { -1, 0, 1 },
                         { -1, 1, -1 }, { 1, 1, -1 }, { 1, 1, 1 }, { -1, 1, 1 },
                         { 0, 4, 0 } };
    const int face[14][3] = {
        { 0, 1, 2 }, { 0, 2, 3 }, { 0, 4, 5 }, { 0, 5, 1 }, { 1, 5, 6 },
        { 1, 6, 2 }, { 2, 6, 7 }, { 2, 7, 3 }, { 3, 7, 4 }, { 3, 4, 0 },
        { 4, 8, 5 }, { 5, 8, 6 }, { 6, 8, 7 }, { 7, 8, 4 },
    };
    const real box = 4, roof = 4, all = box + roof;
    const real low = 0.5, high = 1.75, mean = (4 * 0 + 4 * 1 + 4) / 9.0;
    real center = (box * low + roof * high) / all;
    expect_ok(shape_convex(&k->plan, 9, at, 14, face, 5));
    k->center = vec3_make(0, center - mean, 0);
    k->spread[0] = k->spread[2] = (box * 4 / 12 + roof * 4 / 20) / all;
    k->spread[1] = (box * (1.0 / 12 + (low - center) * (low - center))
                    + roof * (27.0 / 80 + (high - center) * (high - center)))
                 / all;
}

static inline void set_up(void)
{
    seed = 12;
    expect_ok(shape_box(&solid[BOX].plan, vec3_make(1, 2, 3), 7));
    for (int i = 0; i < 3; i++)
        solid[BOX].spread[i] = (i + 1) * (i + 1) / 12.0;
    // An icosahedron of edge a: a^2 phi^2 / 20 along every axis, and the square
    // of its radius is a^2 (phi^2 + 1) / 4.
    expect_ok(shape_icosahedron(&solid[BALL].plan, 0.5, 2));
    real phi2 = (3 + sqrt(5.0)) / 2, edge2 = 0.25 * 4 / (phi2 + 1);
    for (int i = 0; i < 3; i++) solid[BALL].spread[i] = edge2 * phi2 / 20;
    make_wedge(&solid[WEDGE]);
    make_house(&solid[HOUSE]);
}

static inline void tear_down(void)
{
    for (int i = 0; i < SOLIDS; i++) shape_free(&solid[i].plan);
    rigid4_free(&f);
}

// The image of a solid: all its corners moved.
static inline void make_image(shape *s, const shape *of, const matrix *m)
{
    vec3 at[12];
    for (int i = 0; i < of->particles; i++) at[i] = times(m, of->at[i]);
    expect_ok(shape_convex(s, of->particles, at, of->mesh.faces,
                           (const int (*)[3])of->face, 3));
}

// The body f, turned and moved, at rest.
static inline matrix stand(particle *p)
{
    matrix turn = any_rotation();
    vec3 away = random_vec3(&seed, 1);
    for (int k = 0; k < FOUR; k++) {
        vec3 x = vec3_add(away, times(&turn, f.at[k]));
        p[k] = (particle){ x, x, 1 / f.mass };
    }
    return turn;
}

// --- six sticks at once ------------------------------------------------------

// Oracle: J J^T of the six sticks at rest, and its inverse.  The row of stick
// (a, b) holds -o at a and o at b, o = x_b - x_a, so that two sticks meet in
// o . o' where they share a particle, with a minus sign where one begins and
// the other ends there.
static inline real row_product(const stick *s, const stick *u, const vec3 *at)
{
    vec3 o = vec3_sub(at[s->b], at[s->a]), q = vec3_sub(at[u->b], at[u->a]);
    int shared = (s->a == u->a) + (s->b == u->b)
               - (s->a == u->b) - (s->b == u->a);
    return shared * vec3_dot(o, q);
}

// Gauss and Jordan: matrix and identity side by side, the largest pivot of each
// column.
static inline void invert(real m[FOUR_STICKS][2 * FOUR_STICKS])
{
    for (int c = 0; c < FOUR_STICKS; c++) {
        int best = c;
        for (int r = c + 1; r < FOUR_STICKS; r++)
            if (fabs(m[r][c]) > fabs(m[best][c])) best = r;
        for (int k = 0; k < 2 * FOUR_STICKS; k++) {
            real kept = m[c][k];
            m[c][k] = m[best][k];
            m[best][k] = kept;
        }
        real pivot = m[c][c];
        for (int k = 0; k < 2 * FOUR_STICKS; k++) m[c][k] /= pivot;
        for (int r = 0; r < FOUR_STICKS; r++) {
            real share = m[r][c];
            if (r == c || share == 0) continue;
            for (int k = 0; k < 2 * FOUR_STICKS; k++)
                m[r][k] -= share * m[c][k];
        }
    }
}

typedef struct {
    real at[FOUR_STICKS][FOUR_STICKS];  // 1/m^4
} inverse;

static inline inverse inverse_of(const rigid4 *of)
{
    real m[FOUR_STICKS][2 * FOUR_STICKS] = { { 0 } };
    inverse r;
    for (int s = 0; s < FOUR_STICKS; s++) {
        for (int u = 0; u < FOUR_STICKS; u++)
            m[s][u] = row_product(&of->stick[s], &of->stick[u], of->at);
        m[s][FOUR_STICKS + s] = 1;
    }
    invert(m);
    for (int s = 0; s < FOUR_STICKS; s++)
        for (int u = 0; u < FOUR_STICKS; u++)
            r.at[s][u] = m[s][FOUR_STICKS + u];
    return r;
}

#endif
