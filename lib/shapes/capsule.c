//> round-skin
//>   For the eye there is a skin of triangles, which nothing else looks at.
#include "capsule.h"

#include <assert.h>
#include <stdlib.h>

// Two half balls of A_QUARTER - 1 rings and a pole each, and between them the two
// ends of a cylinder, which are one ring if it has no length.
enum { A_QUARTER = 5, SLICES = 4 * A_QUARTER };

// The cosine and the sine of the k-th part of a right angle, k = 0 to A_QUARTER,
// without a function that rounds in its own way: turned on by 18 degrees each.
static void circle_point(int k, real *c, real *s)
{
    const real cosine = sqrt(10 + 2 * sqrt(5.0)) / 4;
    const real sine = (sqrt(5.0) - 1) / 4;
    *c = 1;
    *s = 0;
    for (; k > 0; k--) {
        real x = *c * cosine - *s * sine;
        *s = *c * sine + *s * cosine;
        *c = x;
    }
}

// Ring k from below, of `rings`; the lower half stands `half` (m) lower.
static void place_ring(vec3 *at, int k, int rings, real half, real radius)
{
    bool is_low = k < rings / 2 || (rings % 2 == 0 && k == rings / 2 - 1);
    int from_pole = is_low ? k + 1 : rings - k;
    real out, up, c, s;
    circle_point(A_QUARTER - from_pole, &out, &up);
    for (int i = 0; i < SLICES; i++) {
        circle_point(i, &c, &s);
        real y = half + radius * up;
        at[i] = vec3_make(radius * out * c, is_low ? -y : y, radius * out * s);
    }
}

static int *add_triangle(int *face, int a, int b, int c)
{
    face[0] = a;
    face[1] = b;
    face[2] = c;
    return face + 3;
}

// Points: the lower pole, the rings, the upper pole.
static void span_skin(int *face, int rings)
{
    int top = 1 + rings * SLICES;
    for (int i = 0; i < SLICES; i++) {
        int j = (i + 1) % SLICES, last = top - SLICES;
        face = add_triangle(face, 0, 1 + i, 1 + j);
        face = add_triangle(face, top, last + j, last + i);
        for (int a = 1; a < last; a += SLICES) {
            face = add_triangle(face, a + i, a + SLICES + i, a + j);
            face = add_triangle(face, a + j, a + SLICES + i, a + SLICES + j);
        }
    }
}

static status make_skin(struct skin *k, real half, real radius)
{
    int rings = 2 * A_QUARTER - (half > 0 ? 0 : 1);
    k->points = rings * SLICES + 2;
    k->faces = 2 * rings * SLICES;
    k->at = malloc((size_t)k->points * sizeof *k->at);
    k->face = malloc((size_t)k->faces * 3 * sizeof *k->face);
    if (!k->at || !k->face) return status_out_of_memory();
    k->at[0] = vec3_make(0, -half - radius, 0);
    k->at[k->points - 1] = vec3_make(0, half + radius, 0);
    for (int n = 0; n < rings; n++)
        place_ring(k->at + 1 + n * SLICES, n, rings, half, radius);
    span_skin(k->face, rings);
    return status_ok();
}
//<

//> round-make
//>   Mass and inertia are those of the solid, so that chapter 13 can build its
//>   four particles.
// A core of two particles is an edge with nothing on either side.
void capsule_join_core(mesh *m)
{
    m->vertices = 2;
    m->edges = 1;
    m->half[0] = (half_edge){ 0, 1, -1 };
    m->half[1] = (half_edge){ 1, 0, -1 };
    m->vertex_half[0] = 0;
    m->vertex_half[1] = 1;
}

static status make_round(shape *s, real half, real radius, real mass)
{
    int particles = half > 0 ? 2 : 1;
    status r = shape_begin(s, SHAPE_RIGID, particles, 1, mass);
    if (r.ok) r = size_check("radius", radius, "m");
    if (r.ok) r = shape_span(s, NULL, 0);
    if (r.ok) r = make_skin(&s->skin, half, radius);
    if (r.ok && particles == 2) {
        s->at[0].y = -half;
        s->at[1].y = half;
        capsule_join_core(&s->mesh);
        shape_add_edges(s);
    }
    s->round = radius;
    r = shape_finish(s, r);
    if (r.ok) s->spacing = radius;
    return r;
}

status shape_sphere(shape *s, real radius, real mass)
{
    assert(s);
    return make_round(s, 0, radius, mass);
}

status shape_capsule(shape *s, real length, real radius, real mass)
{
    assert(s);
    *s = (shape){ .kind = SHAPE_RIGID };
    status r = size_check("length", length, "m");
    return r.ok ? make_round(s, length / 2, radius, mass) : r;
}
//<
