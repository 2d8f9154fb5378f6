//> weight-copy
//>   A shape is shared by its bodies, so one with another weight is another shape.
#include "weight.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

// NULL, and *done fails, if memory is refused.
static void *copy_of(const void *from, int count, size_t size, status *done)
{
    void *to = calloc((size_t)count + 1, size);
    if (!to) *done = status_out_of_memory();
    else if (count > 0) memcpy(to, from, (size_t)count * size);
    return to;
}
#define COPY(s, of, member, count) ((s)->member = \
    copy_of((of)->member, count, sizeof *(of)->member, &done))

status weight_copy(shape *s, const shape *of)
{
    status done = status_ok();
    const mesh *m = &of->mesh;
    *s = *of;
    COPY(s, of, at, of->particles);
    COPY(s, of, mass, of->particles);
    COPY(s, of, stick, of->sticks);
    COPY(s, of, angle, of->angles);
    COPY(s, of, face, 3 * m->faces);
    COPY(s, of, mesh.half, 2 * m->edges);
    COPY(s, of, mesh.vertex_half, m->vertices);
    COPY(s, of, mesh.face_half, m->faces);
    COPY(s, of, skin.at, of->skin.points);
    COPY(s, of, skin.face, 3 * of->skin.faces);
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
// Inside a hull, or within the radius of a core along y.
static bool is_inside(const shape *s, vec3 x)
{
    if (s->round > 0) {
        real half = s->at[s->particles - 1].y;
        x.y -= real_max(-half, real_min(half, x.y));
        return vec3_length(x) < s->round;
    }
    for (int f = 0; f < s->mesh.faces; f++) {
        const int *v = &s->face[3 * f];
        vec3 out = vec3_cross(vec3_sub(s->at[v[1]], s->at[v[0]]),
                              vec3_sub(s->at[v[2]], s->at[v[0]]));
        if (!(vec3_dot(out, vec3_sub(x, s->at[v[0]])) < 0)) return false;
    }
    return true;
}

status weight_give(shape *s, const shape *of, real mass, vec3 center,
                   const real inertia[6])
{
    assert(s && of && inertia);
    *s = (shape){ .kind = of->kind };
    struct weight own = { .mass = mass, .center = center };
    if (of->kind != SHAPE_RIGID)
        return status_fail("only a rigid shape has a weight of its own");
    if (!(mass >= 1e-30 && mass <= 1e30))
        return status_fail("the mass is %g kg: it must be a number from 1e-30 "
                           "to 1e+30", mass);
    if (!is_inside(of, center))
        return status_fail("the centre of mass (%g, %g, %g) is not inside the "
                           "shape", center.x, center.y, center.z);
    status done = check_moments(inertia, mass, own.spread);
    if (done.ok) done = weight_copy(s, of);
    if (!done.ok) return done;
    s->own = own;
    for (int i = 0; i < s->particles; i++) s->mass[i] = mass / s->particles;
    return done;
}
//<
