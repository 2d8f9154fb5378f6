//> cylinder-rim
//>   The corners of a rim lie on a circle.
#include "cylinder.h"

#include <assert.h>
#include <string.h>

enum { QUARTER_SIDES = CYLINDER_SIDES / 4,
       CYLINDER_POINTS = 2 + 2 * CYLINDER_SIDES,
       CYLINDER_FACES = 4 * CYLINDER_SIDES };

// Corner k of a circle of radius 1, without a function that rounds in its own way:
// within a quarter each is turned on by 11.25 degrees, and the quarters are alike.
static vec3 rim_corner(int k)
{
    const real half = sqrt(2 + sqrt(2.0));          // 2 cos(22.5 degrees)
    const real cosine = sqrt(2 + half) / 2, sine = sqrt(2 - half) / 2;
    real x = 1, z = 0;
    for (int i = k % QUARTER_SIDES; i > 0; i--) {
        real turned = x * cosine - z * sine;
        z = x * sine + z * cosine;
        x = turned;
    }
    for (int i = k / QUARTER_SIDES; i > 0; i--) {
        real turned = -z;
        z = x;
        x = turned;
    }
    return vec3_make(x, 0, z);
}

// The two middles, the lower rim, and the upper one.
static void place_rims(vec3 *at, real half, real radius)
{
    at[0] = vec3_make(0, -half, 0);
    at[1] = vec3_make(0, half, 0);
    for (int k = 0; k < CYLINDER_SIDES; k++) {
        vec3 out = vec3_scale(radius, rim_corner(k));
        at[2 + k] = vec3_add(at[0], out);
        at[2 + CYLINDER_SIDES + k] = vec3_add(at[1], out);
    }
}
//<

//> cylinder-make
//>   The prism is a convex body as any other; the shape is told that it is round.
static void span_prism(int face[CYLINDER_FACES][3])
{
    for (int k = 0; k < CYLINDER_SIDES; k++) {
        int next = (k + 1) % CYLINDER_SIDES;
        int low = 2 + k, low_next = 2 + next;
        int high = low + CYLINDER_SIDES, high_next = low_next + CYLINDER_SIDES;
        const int side[4][3] = {
            { 0, low, low_next }, { 1, high_next, high },
            { low, high, high_next }, { low, high_next, low_next } };
        memcpy(face[4 * k], side, sizeof side);
    }
}

static status check_cylinder(real length, real radius)
{
    status r = size_check("length", length, "m");
    if (r.ok) r = size_check("radius", radius, "m");
    if (!r.ok) return r;
    if (radius >= 1e-4 * length && radius <= 1e4 * length) return status_ok();
    return status_fail("the radius is %g of the length: it must be from 0.0001 "
                       "to 10000", radius / length);
}

status shape_cylinder(shape *s, real length, real radius, real mass)
{
    assert(s);
    vec3 at[CYLINDER_POINTS];
    int face[CYLINDER_FACES][3];
    *s = (shape){ .kind = SHAPE_RIGID };
    status r = check_cylinder(length, radius);
    if (!r.ok) return r;
    place_rims(at, length / 2, radius);
    span_prism(face);
    r = shape_convex(s, CYLINDER_POINTS, at, CYLINDER_FACES,
                     (const int (*)[3])face, mass);
    if (!r.ok) return r;
    // (Their mean is the origin but for rounding.)
    for (int i = 0; i < CYLINDER_POINTS; i++) s->at[i] = at[i];
    s->rim = radius;
    return r;
}
//<
