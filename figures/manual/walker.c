//> walker
// walker.c - a character climbs a stair, goes along a wall, and pushes a crate.
#include "example.h"

#include <math.h>

enum { STEPS = 10, LEVEL = 1, WALKER = 2, CRATE = 4 };      // groups
static const double SPEED = 2, DT = 1.0 / 60, SKIN = 0.01, RISE = 0.2, TOP = 2;
static tumble_shape shape;
static tumble_body walker, crate;

static void place(tumble_world *w, double x, double y, tumble_vec3 sides)
{
    tumble_body_options at = tumble_body_at(x, y, 0);
    at.kind = TUMBLE_STATIC;
    tumble_body_add(w, tumble_shape_box(w, sides, 1), at);
}

static void build(tumble_world *w)
{
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    for (int k = 0; k < STEPS; k++)
        place(w, 3 + 0.3 * k, RISE * (k + 0.5), tumble_v(0.3, RISE, 3));
    place(w, 9, TOP / 2, tumble_v(6, TOP, 12));
    place(w, 11.5, TOP / 2 + 2, tumble_v(1, TOP + 4, 12));
    tumble_body_options at = tumble_body_at(0, 0.9 + SKIN, 0);
    at.kind = TUMBLE_KINEMATIC;
    at.group = WALKER;
    shape = tumble_shape_capsule(w, 1.2, 0.3, 70);
    walker = tumble_body_add(w, shape, at);
    at = tumble_body_at(10.7, TOP + 0.25, 2);
    at.group = CRATE;
    crate = tumble_body_add(w, tumble_shape_box(w, tumble_v(0.5, 0.5, 0.5), 20),
                            at);
}

static tumble_vec3 plus(tumble_vec3 a, double by, tumble_vec3 b)
{
    return tumble_v(a.x + by * b.x, a.y + by * b.y, a.z + by * b.z);
}

static double dot(tumble_vec3 a, tumble_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

// Goes `way`, but stops SKIN before the level.  What is left of the way, along
// the surface that it met, becomes `way`.
static tumble_vec3 go(tumble_world *w, tumble_vec3 from, tumble_vec3 *way)
{
    tumble_pose pose = { from, { 0, 0, 0, 1 } };
    tumble_hit h = { .fraction = 1 };
    if (tumble_world_sweep(w, shape, pose, *way, LEVEL, &h))
        h.fraction = fmax(0, h.fraction - SKIN / sqrt(dot(*way, *way)));
    tumble_vec3 went = *way, left = plus(went, -dot(went, h.normal), h.normal);
    *way = plus(tumble_v(0, 0, 0), 1 - h.fraction, left);
    return plus(from, h.fraction, went);
}

// Up, ahead and down again: so it climbs steps, and nothing higher.  The body
// gets the velocity that takes it there, and pushes the crate on its way.
static void act(tumble_world *w)
{
    double turn = tumble_world_time(w) > 4.99 ? acos(-1) / 4 : 0;
    tumble_vec3 up = { 0, 1.2 * RISE, 0 }, down = { 0, -2.4 * RISE, 0 };
    tumble_vec3 ahead = { SPEED * DT * cos(turn), 0, SPEED * DT * sin(turn) };
    tumble_vec3 from = tumble_body_position(w, walker), to = go(w, from, &up);
    for (int k = 0; k < 3; k++) to = go(w, to, &ahead);
    tumble_vec3 none = { 0, 0, 0 }, moves = plus(go(w, to, &down), -1, from);
    tumble_body_set_velocity(w, walker, plus(none, 1 / DT, moves), none);
}

static int laws(tumble_world *w, example_law *is)
{
    tumble_vec3 at = tumble_body_position(w, walker);
    is[0] = example_is("climbed (m)", TOP, at.y - 0.9 - SKIN);
    is[1] = example_is("along the wall, v t cos 45 (m)",
                       SPEED * (tumble_world_time(w) - 5) * sqrt(0.5), at.z);
    is[2] = example_is("the crate is before it (yes: 1)", 1,
                       tumble_body_position(w, crate).z > at.z + 0.3);
    return 3;
}

const example walker_scene = {
    .name = "walker", .about = "climbs, slides and pushes", .seconds = 7,
    .has_floor = true, .eye = { -0.7, 7.2, 12.2 }, .target = { 7.8, 1.8, 1 },
    .build = build, .act = act,
    .claim = "it climbs, and slides along a wall as a projection says",
    .laws = laws, .most = 1e-6 };
//<
