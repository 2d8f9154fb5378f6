// curtain.c - a ball walks through a curtain that hangs from a rail.
#include "example.h"

enum { SIDE = 30 };
static tumble_body cloth, ball;

static void build(tumble_world *w)
{
    tumble_body_options at = tumble_body_at(0, 1.5, 0);
    at.pose.rotation = tumble_quat_turn(tumble_v(1, 0, 0), 1.5707963);
    cloth = tumble_body_add(w, tumble_shape_cloth(w, SIDE, SIDE, 2, 2, 0.8),
                            at);
    for (int i = 0; i < SIDE; i++) tumble_body_pin(w, cloth, i);
    tumble_body_options walker = tumble_body_at(0.1, 1, -2);
    walker.kind = TUMBLE_KINEMATIC;
    walker.velocity = tumble_v(0, 0, 1);
    ball = tumble_body_add(w, tumble_shape_sphere(w, 0.4, 1), walker);
}

// m, by which the deepest vertex of the curtain is inside the ball.
static double inside(tumble_world *w)
{
    static tumble_vec3 at[SIDE * SIDE];
    tumble_vec3 c = tumble_body_position(w, ball);
    double deepest = 0;
    int n = tumble_body_vertices(w, cloth, at, SIDE * SIDE);
    for (int k = 0; k < n; k++) {
        double x = at[k].x - c.x, y = at[k].y - c.y, z = at[k].z - c.z;
        double deep = 0.16 - (x * x + y * y + z * z);
        if (deep > deepest) deepest = deep;
    }
    bool is_through = c.z > 1.5;
    return is_through ? deepest : 1;
}

const example curtain = {
    .name = "curtain", .about = "a ball walks through it", .seconds = 4,
    .eye = { 3, 1.8, -4.6 }, .target = { 0, 1.4, 0 },
    .build = build,
    .claim = "the ball has passed, and the curtain is not in it",
    .error = inside };
