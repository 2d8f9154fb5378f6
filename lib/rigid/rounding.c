//> rounding-moments
//>   Steiner cut such a body into the core, a slab over each face, a part of a
//>   cylinder along each edge, and a part of a ball at each corner.
#include "rounding.h"
#include "arctan.h"
#include "capsule.h"

#include "gjk.h"
#include "hull.h"

#include <assert.h>
#include <stdlib.h>

// The integrals of 1, x and x x^T.
typedef struct {
    real whole;
    vec3 first;
    real second[3][3];
} rounding_moments;

// a b^T + b a^T
static void add_product(real m[3][3], real s, vec3 a, vec3 b)
{
    const real x[3] = { a.x, a.y, a.z }, y[3] = { b.x, b.y, b.z };
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            m[i][j] += s * (x[i] * y[j] + y[i] * x[j]);
}

static void add_moments(rounding_moments *sum, real s, const rounding_moments *m)
{
    sum->whole += s * m->whole;
    sum->first = vec3_add_scaled(sum->first, s, m->first);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) sum->second[i][j] += s * m->second[i][j];
}

static void add_point(rounding_moments *sum, real s, vec3 x)
{
    sum->whole += s;
    sum->first = vec3_add_scaled(sum->first, s, x);
    add_product(sum->second, s / 2, x, x);
}

// Adds all x = p + t u, 0 < t < r: p on a part of the core, u on a part of the
// unit sphere, of k - 1 dimensions.  The volume there is t^(k - 1) dt dp du.
static void add_parts(rounding_moments *sum, const rounding_moments *p,
                      const rounding_moments *u, int k,
                      real r)
{
    real power = 1;
    for (int i = 0; i < k; i++) power *= r;
    real t0 = power / k, t1 = power * r / (k + 1);
    real t2 = power * r * r / (k + 2);
    rounding_moments m = { .whole = p->whole * u->whole * t0 };
    m.first = vec3_add_scaled(vec3_scale(u->whole * t0, p->first),
                              p->whole * t1, u->first);
    add_product(m.second, t1, p->first, u->first);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            m.second[i][j] += u->whole * t0 * p->second[i][j]
                            + p->whole * t2 * u->second[i][j];
    add_moments(sum, 1, &m);
}
//<

//> rounding-parts
// From a plane's normal to that of the next plane, by a turn about an axis.
typedef struct {
    real angle;         // rad
    vec3 axis, from, to, chord;     // unit; the integral of u along it
} arc;

static vec3 outward_of(const shape *s, int face)
{
    const int *v = &s->face[3 * face];
    return vec3_unit(triangle_normal(s->at[v[0]], s->at[v[1]], s->at[v[2]]));
}

// Over half-edge h, from the face on its right to the one on its left.
static arc arc_over(const shape *s, int h)
{
    arc a = { .from = outward_of(s, s->mesh.half[mesh_twin(h)].face),
              .to = outward_of(s, s->mesh.half[h].face) };
    vec3 across = vec3_cross(a.from, a.to);
    a.angle = real_angle(vec3_dot(a.from, a.to), vec3_length(across));
    a.axis = vec3_unit(across);
    a.chord = vec3_cross(a.axis, vec3_sub(a.from, a.to));
    return a;
}

// With t = axis x u, (u t^T + t u^T)' = 2 t t^T - 2 u u^T, and u u^T + t t^T
// is the same all along.
static rounding_moments moments_of_arc(const arc *a)
{
    rounding_moments m = { .whole = a->angle, .first = a->chord };
    vec3 t = vec3_cross(a->axis, a->from), end = vec3_cross(a->axis, a->to);
    add_product(m.second, a->angle / 4, a->from, a->from);
    add_product(m.second, a->angle / 4, t, t);
    add_product(m.second, 0.25, a->from, t);
    add_product(m.second, -0.25, a->to, end);
    return m;
}

// A part of the unit sphere, between the arcs over the edges of vertex v: its
// area is 2 pi less the angles of the faces there (Gauss and Bonnet), and the
// integral of u a sum over its rim (Stokes).  Of u u^T the sum over all corners
// is that of the sphere, and so each may be given its share of that.
static rounding_moments moments_of_corner(const shape *s, int v)
{
    const mesh *m = &s->mesh;
    rounding_moments u = { .whole = 6.283185307179586 };
    int start = m->vertex_half[v], h = start;
    do {
        arc a = arc_over(s, h);
        vec3 e = vec3_sub(s->at[mesh_target(m, h)], s->at[v]);
        h = mesh_around(m, h);
        vec3 f = vec3_sub(s->at[mesh_target(m, h)], s->at[v]);
        u.whole -= real_angle(vec3_dot(e, f), vec3_length(vec3_cross(e, f)));
        u.first = vec3_add_scaled(u.first, a.angle / 2, a.axis);
    } while (h != start);
    for (int i = 0; i < 3; i++) u.second[i][i] += u.whole / 3;
    return u;
}
//<

//> rounding-weight
// With points of a segment and of a triangle that have its moments.
static void add_slab(rounding_moments *sum, const shape *s, int face, real r)
{
    const int *v = &s->face[3 * face];
    vec3 n = triangle_normal(s->at[v[0]], s->at[v[1]], s->at[v[2]]);
    rounding_moments p = { .whole = 0 }, u = { .whole = 0 };
    for (int k = 0; k < 3; k++)
        add_point(&p, vec3_length(n) / 6, vec3_scale(0.5,
                  vec3_add(s->at[v[k]], s->at[v[(k + 1) % 3]])));
    add_point(&u, 1, vec3_unit(n));
    add_parts(sum, &p, &u, 1, r);
}

static void add_rod(rounding_moments *sum, const shape *s, int h, real r)
{
    vec3 a = s->at[s->mesh.half[h].origin], b = s->at[mesh_target(&s->mesh, h)];
    real length = vec3_distance(a, b);
    arc over = arc_over(s, h);
    rounding_moments p = { .whole = 0 }, u = moments_of_arc(&over);
    add_point(&p, length / 6, a);
    add_point(&p, length / 6, b);
    add_point(&p, 4 * length / 6, vec3_scale(0.5, vec3_add(a, b)));
    add_parts(sum, &p, &u, 2, r);
}

static rounding_moments moments_around(const shape *s, real r)
{
    rigid_solid core = rigid4_solid(s);
    rounding_moments sum = { .whole = 0 };
    add_point(&sum, core.volume, core.center);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            sum.second[i][j] += core.volume * core.spread[i][j];
    for (int f = 0; f < s->mesh.faces; f++) add_slab(&sum, s, f, r);
    for (int e = 0; e < s->mesh.edges; e++) add_rod(&sum, s, 2 * e, r);
    for (int v = 0; v < s->particles; v++) {
        rounding_moments p = { .whole = 0 }, u = moments_of_corner(s, v);
        add_point(&p, 1, s->at[v]);
        add_parts(&sum, &p, &u, 3, r);
    }
    return sum;
}
//<

//> rounding-skin
//>   For the eye there is the hull of points of the surface.
enum { ARCS = 5 };      // a quarter of a circle is drawn with so many

static int steps_of(const arc *a)
{
    const real quarter = 1.5707963267948966;
    return 1 + (int)(a->angle * ARCS / quarter * (1 - 1e-9));
}

// Points along the arc over each half-edge, at the vertex that it leaves, and
// between the arc and the middle of the vertex's part of the sphere.  Returns
// how many; at: NULL, or room for them.
static int skin_points(const shape *s, real r, vec3 *at)
{
    int n = 0;
    for (int h = 0; h < 2 * s->mesh.edges; h++) {
        arc a = arc_over(s, h);
        vec3 v = s->at[s->mesh.half[h].origin];
        vec3 top = moments_of_corner(s, s->mesh.half[h].origin).first;
        int parts = steps_of(&a), rings = parts > 1 ? 3 : 1;
        for (int k = 0; k < parts; k++)
            for (int ring = 0; ring < rings; ring++, n++) {
                if (!at) continue;
                real t = (k + 1.0) / parts;
                vec3 u = vec3_add(vec3_scale(1 - t, a.from),
                                  vec3_scale(t, a.to));
                u = vec3_add(vec3_scale(1 - ring / 3.0, vec3_unit(u)),
                             vec3_scale(ring / 3.0, vec3_unit(top)));
                at[n] = vec3_add_scaled(v, r, vec3_unit(u));
            }
    }
    return n;
}

static vec3 least_of(const vec3 *at, int n)
{
    vec3 least = at[0];
    for (int i = 1; i < n; i++)
        least = vec3_make(real_min(least.x, at[i].x),
                          real_min(least.y, at[i].y),
                          real_min(least.z, at[i].z));
    return least;
}

static status span_round(shape *s, real r)
{
    shape drawn;
    int n = skin_points(s, r, NULL);
    vec3 *at = malloc((size_t)n * sizeof *at);
    if (!at) return status_out_of_memory();
    skin_points(s, r, at);
    status done = shape_hull(&drawn, at, n, 1);
    if (done.ok) {
        vec3 moved = vec3_sub(least_of(at, n),
                              least_of(drawn.at, drawn.particles));
        for (int i = 0; i < drawn.particles; i++)
            drawn.at[i] = vec3_add(drawn.at[i], moved);
        free(s->skin.at);
        free(s->skin.face);
        s->skin = (struct skin){ drawn.particles, drawn.mesh.faces, drawn.at,
                                 drawn.face };
        drawn.at = NULL, drawn.face = NULL;
        shape_free(&drawn);
    }
    free(at);
    return done;
}
//<

//> rounding-make
// Moves it, and everything that is told of it, to its centre of mass.
static void take_weight(shape *s, const rounding_moments *m, real mass)
{
    vec3 center = vec3_scale(1 / m->whole, m->first);
    for (int v = 0; v < s->particles; v++)
        s->at[v] = vec3_sub(s->at[v], center);
    for (int i = 0; i < s->skin.points; i++)
        s->skin.at[i] = vec3_sub(s->skin.at[i], center);
    s->own = (struct weight){ .mass = mass };
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            s->own.spread[i][j] = m->second[i][j] / m->whole;
    add_product(s->own.spread, -0.5, center, center);
}

status shape_round(shape *s, const shape *of, real radius)
{
    assert(s && of);
    *s = (shape){ .kind = of->kind };
    if (of->kind != SHAPE_RIGID || of->mesh.faces == 0)
        return status_fail("only a rigid shape with faces can be rounded");
    status done = size_check("radius", radius, "m");
    if (done.ok) done = weight_copy(s, of);
    if (!done.ok) return done;
    real mass = rigid4_mass(of), round = of->round + radius;
    s->own.mass = s->round = s->rim = 0;
    rounding_moments m = moments_around(s, round);
    done = span_round(s, round);
    take_weight(s, &m, mass);
    s->round = round;
    return shape_finish(s, done);
}
//<
