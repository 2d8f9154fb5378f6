// battery_rigid.c - scenes of the ledger: bodies that fall, stand and hit.

#include "battery.h"

#include <math.h>

enum { MOST = 512 };

static void floor_of(tumble_world *w)
{
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
}

static void walls_of(tumble_world *w, double half)
{
    floor_of(w);
    for (int k = -1; k < 2; k += 2) {
        tumble_plane_add(w, tumble_v(k, 0, 0), -half, -1);
        tumble_plane_add(w, tumble_v(0, 0, k), -half, -1);
    }
}

// Steps, and asks four times a second how deep bodies are in each other, in
// parts of a size.
static void see_overlap(battery_run *r, double seconds, double size)
{
    for (double t = 0; t < seconds - 0.125; t += 0.25) {
        battery_step(r, 0.25);
        battery_see(r, tumble_world_measure(r->w).penetration / size);
    }
}

// How far from where they stood, in parts of a size.
static void see_moved(battery_run *r, double seconds, double size)
{
    tumble_body b[MOST];
    tumble_vec3 was[MOST];
    int n = tumble_world_bodies(r->w, b, MOST);
    for (int k = 0; k < n; k++) was[k] = tumble_body_position(r->w, b[k]);
    battery_step(r, seconds);
    for (int k = 0; k < n; k++) {
        tumble_vec3 x = tumble_body_position(r->w, b[k]);
        battery_see(r, sqrt((x.x - was[k].x) * (x.x - was[k].x)
                          + (x.y - was[k].y) * (x.y - was[k].y)
                          + (x.z - was[k].z) * (x.z - was[k].z)) / size);
    }
}

static void room(battery_run *r)
{
    tumble_world *w = r->w;
    walls_of(w, 1);
    const tumble_shape shape[] = {
        tumble_shape_box(w, tumble_v(0.4, 0.3, 0.2), 20),
        tumble_shape_icosahedron(w, 0.2, 15), tumble_shape_sphere(w, 0.15, 10),
        tumble_shape_capsule(w, 0.3, 0.1, 10),
        tumble_shape_box(w, tumble_v(0.6, 0.04, 0.3), 7) };
    for (int k = 0; k < 60; k++) {
        tumble_body_options o =
            tumble_body_at(0.5 * (k % 3 - 1) + 0.01 * (k % 7),
                           0.4 + 0.3 * (k / 9),
                           0.5 * (k / 3 % 3 - 1));
        o.velocity = tumble_v(k % 5 - 2, -4, k % 7 - 3);
        o.spin = tumble_v(k % 3, k % 11 - 5, k % 4);
        tumble_body_add(w, shape[k % 5], o);
    }
    see_overlap(r, 1.25, 0.2);
}

static void tower(battery_run *r)
{
    floor_of(r->w);
    tumble_shape s = tumble_shape_box(r->w, tumble_v(0.4, 0.4, 0.4), 60);
    for (int k = 0; k < 20; k++)
        tumble_body_add(r->w, s,
                        tumble_body_at(0.02 * (k % 2), 0.2 + 0.4 * k, 0));
    see_moved(r, 5, 0.4);
}

static void wall(battery_run *r)
{
    floor_of(r->w);
    tumble_shape s = tumble_shape_box(r->w, tumble_v(0.4, 0.4, 0.4), 60);
    for (int row = 0; row < 10; row++)
        for (int k = 0; k < 10 - row; k++)
            tumble_body_add(r->w, s, tumble_body_at(0.42 * (k + 0.5 * row),
                                                    0.2 + 0.4 * row, 0));
    see_moved(r, 3, 0.4);
}

// Each of three weighs ten times what it lies on.
static void heavy(battery_run *r)
{
    floor_of(r->w);
    for (int k = 0; k < 4; k++)
        tumble_body_add(r->w, tumble_shape_box(r->w, tumble_v(0.4, 0.4, 0.4),
                                               pow(10, k)),
                        tumble_body_at(0, 0.2 + 0.4 * k, 0));
    see_overlap(r, 3, 0.4);
}

// From sliding to rolling, with 5/7 of the speed; a slower one comes to rest.
static void roll(battery_run *r)
{
    floor_of(r->w);
    tumble_shape s = tumble_shape_sphere(r->w, 0.2, 10);
    tumble_body_options o = tumble_body_at(0, 0.2, 0);
    o.velocity = tumble_v(2, 0, 0);
    tumble_body fast = tumble_body_add(r->w, s, o);
    o = tumble_body_at(0, 0.2, 1);
    o.velocity = tumble_v(0.2, 0, 0);
    tumble_body_add(r->w, s, o);
    battery_step(r, 1);
    battery_see(r, fabs(tumble_body_velocity(r->w, fast).x / 2 * 7 / 5 - 1));
    battery_step(r, 4);
}

// Balls and rods at a wall of a centimetre, and at a box that is free.
static void bullet(battery_run *r)
{
    tumble_world *w = r->w;
    tumble_body_options o = tumble_body_at(0, 1, 0);
    tumble_body shot[4];
    tumble_shape s = tumble_shape_sphere(w, 0.02, 0.1);
    tumble_shape rod = tumble_shape_box(w, tumble_v(0.04, 0.02, 0.2), 0.1);
    floor_of(w);
    o.kind = TUMBLE_STATIC;
    tumble_body_add(w, tumble_shape_box(w, tumble_v(0.01, 2, 2), 1), o);
    tumble_body_add(w, tumble_shape_box(w, tumble_v(0.3, 0.3, 0.3), 5),
                    tumble_body_at(-0.5, 0.15, 0));
    for (int k = 0; k < 4; k++) {
        o = tumble_body_at(-5, 0.15 + 0.3 * k, 0.01 * k);
        o.velocity = tumble_v(40 + 60 * k, 1, 0);
        o.spin = tumble_v(0, 0, 100 * k);
        shot[k] = tumble_body_add(w, k % 2 ? rod : s, o);
    }
    for (int k = 0; k < 10; k++) {
        battery_step(r, 0.1);
        for (int i = 0; i < 4; i++)
            battery_see(r, fmax(tumble_body_position(w, shot[i]).x, 0));
    }
}

// Coins and plates that turn fast, onto the floor and each other.
static void coins(battery_run *r)
{
    tumble_vec3 rim[32];
    floor_of(r->w);
    for (int k = 0; k < 32; k++)
        rim[k] = tumble_v(0.1 * cos(k / 2 * 0.39269908169872414),
                          k % 2 ? 0.005 : -0.005,
                          0.1 * sin(k / 2 * 0.39269908169872414));
    tumble_shape s = tumble_shape_hull(r->w, rim, 32, 0.5);
    for (int k = 0; k < 12; k++) {
        tumble_body_options o = tumble_body_at(0.15 * (k % 4), 0.3 + 0.15 * k,
                                               0);
        o.pose.rotation = tumble_quat_turn(tumble_v(1, 0, k % 3), 0.5 * k);
        o.spin = tumble_v(5 * (k % 5), 30, 4 * (k % 3));
        tumble_body_add(r->w, s, o);
    }
    see_overlap(r, 3, 0.1);
}

// Stacks of three: how long until all sleep, from half a second?
static void sleepers(battery_run *r)
{
    floor_of(r->w);
    tumble_shape box = tumble_shape_box(r->w, tumble_v(0.4, 0.4, 0.4), 60);
    tumble_shape ball = tumble_shape_icosahedron(r->w, 0.2, 30);
    for (int k = 0; k < 27; k++)
        tumble_body_add(r->w, k % 9 == 8 ? ball : box,
                        tumble_body_at(0.6 * (k / 3), 0.21 + 0.41 * (k % 3),
                                       0.01 * k));
    double wait = 0;
    for (int k = 0; k < 60; k++) {
        battery_step(r, 0.1);
        if (tumble_world_last_step(r->w).asleep < 27)
            wait = tumble_world_time(r->w);
    }
    battery_see(r, fmax(wait - 0.5, 0));
}

// A box slides over tiles, and stops where friction alone stops it.
static void seams(battery_run *r)
{
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.kind = TUMBLE_STATIC;
    tumble_shape tile = tumble_shape_box(r->w, tumble_v(0.5, 0.5, 0.5), 1);
    for (int k = 0; k < 60; k++) {
        o.pose.position = tumble_v(0.5 * (k / 3), -0.25, 0.5 * (k % 3 - 1));
        tumble_body_add(r->w, tile, o);
    }
    o = tumble_body_at(0, 0.1, 0.1);
    o.velocity = tumble_v(6, 0, 0);
    o.pose.rotation = tumble_quat_turn(tumble_v(0, 1, 0), 0.3);
    tumble_shape box = tumble_shape_box(r->w, tumble_v(0.3, 0.2, 0.3), 10);
    tumble_body b = tumble_body_add(r->w, box, o);
    o = tumble_body_at(0, 0.2, -0.5);
    o.velocity = tumble_v(3, 0, 0);
    tumble_body_add(r->w, tumble_shape_sphere(r->w, 0.2, 10), o);
    battery_step(r, 2);
    battery_see(r, fabs(tumble_body_position(r->w, b).x * 9.81 / 36 - 1));
}

static void hills(battery_run *r)
{
    double high[24 * 24];
    tumble_world *w = r->w;
    for (int k = 0; k < 24 * 24; k++)
        high[k] = 0.2 * sin(0.9 * (k % 24)) * cos(0.7 * (k / 24));
    tumble_body_add_heights(w, high, 24, 24, 8, 8, 0, tumble_body_at(0, 0, 0));
    const tumble_shape shape[] = {
        tumble_shape_box(w, tumble_v(0.4, 0.3, 0.2), 20),
        tumble_shape_sphere(w, 0.2, 30),
        tumble_shape_capsule(w, 0.4, 0.1, 10),
        tumble_shape_box(w, tumble_v(0.5, 0.05, 0.5), 10) };
    for (int k = 0; k < 36; k++) {
        tumble_body_options o = tumble_body_at(0.7 * (k % 6 - 2.5),
                                               0.8 + 0.02 * k,
                                               0.7 * (k / 6 - 2.5));
        o.velocity = tumble_v(2, -5, k % 3 - 1);
        tumble_body_add(w, shape[k % 4], o);
    }
    see_overlap(r, 0.75, 0.2);
}

// So many that the broad phase lays out lanes.
static void crowd(battery_run *r)
{
    walls_of(r->w, 2);
    tumble_shape s = tumble_shape_sphere(r->w, 0.1, 4);
    tumble_shape box = tumble_shape_box(r->w, tumble_v(0.2, 0.2, 0.2), 8);
    for (int k = 0; k < 500; k++)
        tumble_body_add(r->w, k % 4 ? s : box,
                        tumble_body_at(0.37 * (k % 10 - 4.5),
                                       0.2 + 0.25 * (k / 100), 0.37
                                       * (k / 10 % 10 - 4.5) + 0.01 * (k % 7)));
    see_overlap(r, 0.5, 0.1);
}

const battery_scene battery_rigid[] = {
    { "room", "60 bodies thrown: deepest overlap / radius", "1", 0.01, room },
    { "tower", "20 cubes: moved / side", "1", 0.01, tower },
    { "pyramid", "55 cubes: moved / side", "1", 0.01, wall },
    { "heavy", "1, 10, 100, 1000 kg: deepest overlap / side",
      "1", 0.01, heavy },
    { "roll", "from sliding to rolling: speed, from 5/7", "1", 0.001, roll },
    { "bullet", "40 to 220 m/s at 1 cm: past the wall", "m", 0.01, bullet },
    { "coins", "12 thin and turning: deepest overlap / radius",
      "1", 0.01, coins },
    { "sleepers", "stacks of three: until all sleep", "s", 0.5, sleepers },
    { "seams", "a box over tiles: way, from v^2 / (2 mu g)", "1", 0.01, seams },
    { "terrain", "36 on hills: deepest overlap / radius", "1", 0.01, hills },
    { "crowd", "500: deepest overlap / radius", "1", 0.01, crowd },
    { 0 } };
