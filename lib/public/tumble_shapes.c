//> face-shapes
//>   Each shape is a shape of chapter 03, made, kept and counted. It cannot be
//>   dropped while a body is made of it.
#include "capsule.h"
#include "cylinder.h"
#include "hull.h"
#include "inside.h"
#include "obj.h"
#include "rounding.h"
#include "weight.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

tumble_shape inside_keep(tumble_world *w, shape *made, status done)
{
    const tumble_shape none = { 0, 0 };
    if (!inside_is_ok(w, done)) return none;
    if (!inside_is_world(w)) {
        shape_free(made);
        return none;
    }
    shape *s = malloc(sizeof *s);
    bool is_room = s && inside_reserve(w, made->particles)
                && inside_reserve(w, made->skin.points);
    int k = is_room ? slots_take(&w->shapes) : -1;
    if (k < 0) {
        free(s);
        shape_free(made);
        inside_is_ok(w, status_out_of_memory());
        return none;
    }
    *s = *made;
    *(shape_place *)slots_at(&w->shapes, k) = (shape_place){ .shape = s };
    return (tumble_shape){ (unsigned)k, slots_generation(&w->shapes, k) };
}

tumble_shape tumble_shape_box(tumble_world *w, tumble_vec3 sides, double mass)
{
    shape s;
    return inside_keep(w, &s, shape_box(&s, from_user(sides), mass));
}

tumble_shape tumble_shape_icosahedron(tumble_world *w, double radius,
                                      double mass)
{
    shape s;
    return inside_keep(w, &s, shape_icosahedron(&s, radius, mass));
}

tumble_shape tumble_shape_sphere(tumble_world *w, double radius, double mass)
{
    shape s;
    return inside_keep(w, &s, shape_sphere(&s, radius, mass));
}

tumble_shape tumble_shape_capsule(tumble_world *w, double length, double radius,
                                  double mass)
{
    shape s;
    return inside_keep(w, &s, shape_capsule(&s, length, radius, mass));
}

tumble_shape tumble_shape_cylinder(tumble_world *w, double length,
                                   double radius, double mass)
{
    shape s;
    return inside_keep(w, &s, shape_cylinder(&s, length, radius, mass));
}

tumble_shape tumble_shape_hull(tumble_world *w, const tumble_vec3 *point, int n,
                               double mass)
{
    shape s;
    if (!inside_is_list(w, point, n, "points")) return (tumble_shape){ 0, 0 };
    vec3 *at = calloc(n > 0 ? (size_t)n : 1, sizeof *at);
    for (int k = 0; at && k < n; k++) at[k] = from_user(point[k]);
    status done = at ? shape_hull(&s, at, n, mass) : status_out_of_memory();
    free(at);
    return inside_keep(w, &s, done);
}

// A hull with a round cone's weight.  The centre of mass of both is a quarter of
// the height above the base.
enum { CONE_SIDES = 32 };

static status make_cone(shape *made, real height, real radius, real mass)
{
    const tumble_vec3 y = { 0, 1, 0 }, out = { radius, -height / 4, 0 };
    vec3 at[CONE_SIDES + 1], none = { 0, 0, 0 };
    shape pyramid;
    if (!(height > 0 && radius > 0 && height < HUGE_VAL && radius < HUGE_VAL))
        return status_fail("a cone of height %g and radius %g is none: both "
                           "must be above 0", height, radius);
    for (int k = 0; k < CONE_SIDES; k++) {
        tumble_quat turn = tumble_quat_turn(y, 2 * JOINT_HALF_TURN * k / CONE_SIDES);
        at[k] = from_user(tumble_quat_rotate(turn, out));
    }
    at[CONE_SIDES] = (vec3){ 0, 0.75 * height, 0 };
    status done = shape_hull(&pyramid, at, CONE_SIDES + 1, mass);
    if (!done.ok) return done;
    real square = radius * radius, along = 0.3 * mass * square;
    real across = 0.15 * mass * (square + height * height / 4);
    const real inertia[6] = { across, along, across, 0, 0, 0 };
    done = weight_set(made, &pyramid, mass, none, inertia);
    shape_free(&pyramid);
    return done;
}

tumble_shape tumble_shape_cone(tumble_world *w, double height, double radius,
                               double mass)
{
    shape s;
    return inside_keep(w, &s, make_cone(&s, height, radius, mass));
}

tumble_shape tumble_shape_obj(tumble_world *w, const char *path, double radius,
                              double mass)
{
    shape s;
    status done = path ? obj_read(path, radius, mass, &s)
                       : status_fail("a mesh without the name of a file");
    return inside_keep(w, &s, done);
}

tumble_shape tumble_shape_rope(tumble_world *w, int n, double length,
                               double mass)
{
    shape s;
    return inside_keep(w, &s, shape_rope(&s, n, length, mass));
}

// A cloth's diagonals are so much softer than its threads.
static const real DIAGONAL = 0.2;           // tuned, 1

tumble_shape tumble_shape_cloth(tumble_world *w, int columns, int rows,
                                double width, double depth, double mass)
{
    shape s;
    return inside_keep(w, &s, shape_cloth(&s, columns, rows, width, depth, mass,
                                          DIAGONAL));
}

tumble_shape tumble_shape_weighed(tumble_world *w, tumble_shape s, double mass,
                                  tumble_vec3 center, const double inertia[6])
{
    const shape_place *of = inside_shape(w, s);
    shape made;
    if (!of) return (tumble_shape){ 0, 0 };
    status done = inertia
                ? weight_set(&made, of->shape, mass, from_user(center), inertia)
                : status_fail("a weight without moments of inertia");
    return inside_keep(w, &made, done);
}

tumble_shape tumble_shape_rounded(tumble_world *w, tumble_shape s,
                                  double radius)
{
    const shape_place *of = inside_shape(w, s);
    shape made;
    if (!of) return (tumble_shape){ 0, 0 };
    return inside_keep(w, &made, shape_round(&made, of->shape, radius));
}

bool tumble_shape_remove(tumble_world *w, tumble_shape s)
{
    shape_place *gone = inside_shape(w, s);
    if (!gone) return false;
    if (gone->bodies > 0)
        return inside_fail(w, "shape %u cannot be dropped: %d bodies are made of "
                           "it", s.place, gone->bodies);
    inside_drop(w, (int)s.place);
    return true;
}
//<
