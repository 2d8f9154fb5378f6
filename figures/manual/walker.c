//> walker
// walker.c - a character climbs a stair, goes along a wall, and pushes a crate.
#include "example.h"

#include <math.h>

enum { STEPS = 10, LEVEL = 1, WALKER = 2, CRATE = 4 };      // groups
static const double SPEED = 2, DT = 1.0 / 60, RISE = 0.2, TOP = 2;
static const double FALL = 9.81 / 60 / 60;      // m, in the first step of a fall
static tumble_walker how;
static tumble_walk at;
static tumble_body walker, crate;

static void place(tumble_world *w, double x, double y, tumble_vec3 sides)
{
    tumble_body_options o = tumble_body_at(x, y, 0);
    o.kind = TUMBLE_STATIC;
    tumble_body_add(w, tumble_shape_box(w, sides, 1), o);
}

static void build(tumble_world *w)
{
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    for (int k = 0; k < STEPS; k++)
        place(w, 3 + 0.3 * k, RISE * (k + 0.5), tumble_v(0.3, RISE, 3));
    place(w, 9, TOP / 2, tumble_v(6, TOP, 12));
    place(w, 11.5, TOP / 2 + 2, tumble_v(1, TOP + 4, 12));
    how = tumble_walker_capsule(1.2, 0.3);
    how.step = RISE;
    how.mask = LEVEL;
    tumble_body_options o = tumble_body_at(0, 0.9, 0);
    at = (tumble_walk){ .position = o.pose.position };
    o.kind = TUMBLE_KINEMATIC;
    o.group = WALKER;
    tumble_shape capsule = tumble_shape_capsule(w, how.length, how.radius, 70);
    walker = tumble_body_add(w, capsule, o);
    o = tumble_body_at(10.7, TOP + 0.25, 2);
    o.group = CRATE;
    crate = tumble_body_add(w, tumble_shape_box(w, tumble_v(0.5, 0.5, 0.5), 20),
                            o);
}

// The character goes where it can, and the body that stands for it gets the velocity
// that takes it there, and pushes the crate on its way.
static void act(tumble_world *w)
{
    double turn = tumble_world_time(w) > 4.99 ? acos(-1) / 4 : 0;
    tumble_vec3 way = { SPEED * DT * cos(turn), -FALL, SPEED * DT * sin(turn) };
    tumble_vec3 from = tumble_body_position(w, walker), none = { 0, 0, 0 };
    tumble_world_walk(w, how, at, way, &at);
    tumble_vec3 to = at.position;
    tumble_vec3 speed = { (to.x - from.x) / DT, (to.y - from.y) / DT,
                          (to.z - from.z) / DT };
    tumble_body_set_velocity(w, walker, speed, none);
}

static int laws(tumble_world *w, example_law *is)
{
    tumble_vec3 now = tumble_body_position(w, walker);
    is[0] = example_is("climbed (m)", TOP, now.y - 0.9);
    is[1] = example_is("along the wall, v t cos 45 (m)",
                       SPEED * (tumble_world_time(w) - 5) * sqrt(0.5), now.z);
    is[2] = example_is("the crate is before it (yes: 1)", 1,
                       tumble_body_position(w, crate).z > now.z + 0.3);
    return 3;
}

const example walker_scene = {
    .name = "walker", .about = "climbs, slides and pushes", .seconds = 7,
    .has_floor = true, .eye = { -0.7, 7.2, 12.2 }, .target = { 7.8, 1.8, 1 },
    .build = build, .act = act,
    .claim = "it climbs, and slides along a wall as a projection says",
    .laws = laws, .most = 1e-5 };
//<
