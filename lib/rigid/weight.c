//> weight-copy
//>   A shape is shared by its bodies, so one with another weight is another shape.
#include "weight.h"

#include "gjk.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

// NULL if there is nothing; or, and *done fails, if memory is refused.
static void *copy_of(const void *from, int count, size_t size, status *done)
{
    if (count == 0) return NULL;
    void *to = malloc((size_t)count * size);
    if (to) memcpy(to, from, (size_t)count * size);
    else    *done = status_out_of_memory();
    return to;
}

status weight_copy(shape *s, const shape *of)
{
    status done = status_ok();
    *s = *of;
#define COPY(table, count) \
    s->table = copy_of(of->table, count, sizeof *of->table, &done);
    SHAPE_TABLES(COPY, of)
#undef COPY
    if (!done.ok) shape_free(s);
    return done;
}
//<

//> weight-check
//>   Not every tensor is that of a solid: about no axis may its moment be as large
//>   as about two others together.
// Of I, and of (trace of I) / 2 - I, which is the sum of m x x^T.
static void find_spread(const real i[6], real mass, real spread[3][3])
{
    real half = (i[0] + i[1] + i[2]) / 2;
    const int of[3][3] = { { 0, 3, 4 }, { 3, 1, 5 }, { 4, 5, 2 } };
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            spread[a][b] = ((a == b ? half : 0) - i[of[a][b]]) / mass;
}

// By the pivots of an elimination.  Less than rounding's share of the largest is
// not above 0.
static bool is_positive(real m[3][3])
{
    real a = m[0][0], most = fmax(a, fmax(m[1][1], m[2][2]));
    real least = 1e-13 * most, b, c, across;
    if (!(a > least)) return false;
    b = m[1][1] - m[1][0] * m[1][0] / a;
    if (!(b > least)) return false;
    across = m[2][1] - m[2][0] * m[1][0] / a;
    c = m[2][2] - m[2][0] * m[2][0] / a - across * across / b;
    return c > least;
}

static status check_moments(const real i[6], real mass, real spread[3][3])
{
    real tensor[3][3] = { { i[0], i[3], i[4] }, { i[3], i[1], i[5] },
                          { i[4], i[5], i[2] } };
    for (int k = 0; k < 6; k++)
        if (!(fabs(i[k]) <= 1e60))
            return status_fail("moment of inertia %d is %g kg m^2: it must be a "
                               "number up to 1e+60", k, i[k]);
    if (!is_positive(tensor))
        return status_fail("the moments of inertia %g, %g, %g, %g, %g, %g are "
                           "not positive about every axis", i[0], i[1], i[2],
                           i[3], i[4], i[5]);
    find_spread(i, mass, spread);
    if (!is_positive(spread))
        return status_fail("the moments of inertia %g, %g, %g, %g, %g, %g are "
                           "those of no solid: about each principal axis it "
                           "must be less than about the two others together",
                           i[0], i[1], i[2], i[3], i[4], i[5]);
    return status_ok();
}
//<

//> weight-give
// Inside a hull, or within the radius of a core.
static bool is_inside(const shape *s, vec3 x)
{
    const hull point = { &x, 1 }, core = { s->at, s->particles };
    if (s->round > 0)
        return gjk_distance(point, core, HUGE_VAL, NULL).distance < s->round;
    for (int f = 0; f < s->mesh.faces; f++) {
        const int *v = &s->face[3 * f];
        vec3 out = vec3_cross(vec3_sub(s->at[v[1]], s->at[v[0]]),
                              vec3_sub(s->at[v[2]], s->at[v[0]]));
        if (!(vec3_dot(out, vec3_sub(x, s->at[v[0]])) < 0)) return false;
    }
    return true;
}

status weight_set(shape *s, const shape *of, real mass, vec3 center,
                  const real inertia[6])
{
    assert(s && of && inertia);
    *s = (shape){ .kind = of->kind };
    struct weight own = { .mass = mass, .center = center };
    if (of->kind != SHAPE_RIGID)
        return status_fail("only a rigid shape has a weight of its own");
    status done = size_check("mass", mass, "kg");
    if (!done.ok) return done;
    if (!is_inside(of, center))
        return status_fail("the centre of mass (%g, %g, %g) is not inside the "
                           "shape", center.x, center.y, center.z);
    done = check_moments(inertia, mass, own.spread);
    if (done.ok) done = weight_copy(s, of);
    if (!done.ok) return done;
    s->own = own;
    for (int i = 0; i < s->particles; i++) s->mass[i] = mass / s->particles;
    return done;
}
//<

//> weight-pieces
//>   Several pieces that are one body have one weight: the sum of their masses,
//>   the mean of their centres, and their spreads about it (the parallel axes of
//>   Huygens and Steiner).
static real axis_part(vec3 v, int i)
{
    return i == 0 ? v.x : i == 1 ? v.y : v.z;
}

// sum_pq spread_pq x_p x_q^T, of the axes x of the placement.
static void add_turned(real to[3][3], real mass, real spread[3][3],
                       const placement *at)
{
    const vec3 axis[3] = { at->x, at->y, at->z };
    for (int p = 0; p < 3; p++)
        for (int q = 0; q < 3; q++)
            for (int i = 0; i < 3; i++)
                for (int j = 0; j < 3; j++)
                    to[i][j] += mass * spread[p][q] * axis_part(axis[p], i)
                              * axis_part(axis[q], j);
}

// About the origin of the body, as yet.
void weight_add(struct weight *sum, const shape *piece, const placement *at)
{
    rigid_solid q = rigid4_solid(piece);
    real mass = rigid4_mass(piece);
    vec3 c = vec3_add(at->position, placement_vector(at, q.center));
    sum->mass += mass;
    sum->center = vec3_add_scaled(sum->center, mass, c);
    add_turned(sum->spread, mass, q.spread, at);
    rigid4_add_outer(sum->spread, mass, c);
}

void weight_mean(struct weight *sum)
{
    sum->center = vec3_scale(1 / sum->mass, sum->center);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) sum->spread[i][j] /= sum->mass;
    rigid4_add_outer(sum->spread, -1, sum->center);
}

void weight_reach(struct weight *whole, const shape *piece, const placement *at)
{
    for (int v = 0; v < piece->particles; v++) {
        vec3 x = vec3_add(at->position, placement_vector(at, piece->at[v]));
        real far = vec3_distance(x, whole->center) + piece->round;
        whole->reach = real_max(whole->reach, far);
    }
}

status weight_piece(shape *s, const shape *piece, const placement *at,
                    const struct weight *whole)
{
    status done = weight_copy(s, piece);
    if (!done.ok) return done;
    s->own = *whole;
    s->middle = vec3_add(at->position, placement_vector(at, piece->middle));
    for (int v = 0; v < s->particles; v++) {
        s->at[v] = vec3_add(at->position, placement_vector(at, piece->at[v]));
        s->mass[v] = whole->mass / s->particles;
    }
    for (int k = 0; k < s->skin.points; k++)
        s->skin.at[k] = vec3_add(at->position,
                                 placement_vector(at, piece->skin.at[k]));
    return done;
}
//<
