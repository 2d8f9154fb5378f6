// battery_soft.c - scenes of the ledger: rope and cloth.

#include "battery.h"

#include <math.h>

// Steps, and asks four times a second how far sticks are from their lengths.
static void see_strain(battery_run *r, double seconds)
{
    for (double t = 0; t < seconds - 0.125; t += 0.25) {
        battery_step(r, 0.25);
        battery_see(r, tumble_world_measure(r->w).strain);
    }
}

static tumble_body add_static(tumble_world *w, tumble_shape s, double height)
{
    tumble_body_options o = tumble_body_at(0, height, 0);
    o.kind = TUMBLE_STATIC;
    return tumble_body_add(w, s, o);
}

// A rope is let go level, with a hundred times its weight at its end; another
// hangs over a beam.
static void load(battery_run *r)
{
    tumble_world *w = r->w;
    tumble_shape s = tumble_shape_rope(w, 20, 2, 0.2);
    tumble_body rope = tumble_body_add(w, s, tumble_body_at(0, 3, 0));
    tumble_body box =
        tumble_body_add(w, tumble_shape_box(w, tumble_v(0.3, 0.3, 0.3), 20),
                        tumble_body_at(1.15, 3, 0));
    tumble_body_pin(w, rope, 0);
    tumble_joint_hang(w, rope, 20, box);
    add_static(w, tumble_shape_box(w, tumble_v(0.2, 0.2, 1), 1), 1);
    tumble_body_add(w, s, tumble_body_at(0.3, 1.3, 0.1));
    see_strain(r, 1.5);
}

// A cloth's particles keep half of a spacing and some more from a cube.
static void drape(battery_run *r)
{
    enum { MOST = 21 * 21 };
    const double half = 0.3, spacing = 0.075;
    tumble_world *w = r->w;
    tumble_vec3 at[MOST];
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    add_static(w, tumble_shape_box(w, tumble_v(0.6, 0.6, 0.6), 1), 0.4);
    tumble_body c =
        tumble_body_add(w, tumble_shape_cloth(w, 21, 21, 1.5, 1.5, 0.5),
                        tumble_body_at(0, 0.8, 0));
    for (int k = 0; k < 11; k++) {
        battery_step(r, 0.1);
        int n = tumble_body_vertices(w, c, at, MOST);
        for (int i = 0; i < n; i++) {
            double out = fmax(fmax(fabs(at[i].x), fabs(at[i].z)),
                              fabs(at[i].y - 0.4)) - half;
            battery_see(r, fmax(0.5 - out / spacing, 0));
        }
    }
}

// Hung by two corners, and a ball is thrown at it.
static void curtain_of(battery_run *r)
{
    tumble_world *w = r->w;
    tumble_body c =
        tumble_body_add(w, tumble_shape_cloth(w, 21, 21, 1.5, 1.5, 0.5),
                        tumble_body_at(0, 1, 0));
    tumble_body_pin(w, c, 0);
    tumble_body_pin(w, c, 20);
    tumble_body_options o = tumble_body_at(0, 0.2, 1);
    o.velocity = tumble_v(0, 2, -5);
    tumble_body_add(w, tumble_shape_sphere(w, 0.15, 2), o);
    see_strain(r, 0.75);
}

// Pinned at four corners, with boxes on it.
static void laden(battery_run *r)
{
    tumble_world *w = r->w;
    tumble_body c = tumble_body_add(w,
                                    tumble_shape_cloth(w, 17, 17, 1.6, 1.6, 1),
                                    tumble_body_at(0, 1, 0));
    for (int k = 0; k < 4; k++)
        tumble_body_pin(w, c, k / 2 * 16 * 17 + k % 2 * 16);
    tumble_shape s = tumble_shape_box(w, tumble_v(0.3, 0.2, 0.25), 2);
    for (int k = 0; k < 4; k++)
        tumble_body_add(w, s, tumble_body_at(0.2 * (k % 2), 1.3 + 0.25 * k,
                                             0.1 * k - 0.15));
    see_strain(r, 0.75);
}

// Two sheets that fall on a ball and on each other, and a bullet through them.
static void layers(battery_run *r)
{
    tumble_world *w = r->w;
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_shape s = tumble_shape_cloth(w, 15, 15, 1, 1, 0.3);
    add_static(w, tumble_shape_sphere(w, 0.25, 1), 0.25);
    tumble_body_add(w, s, tumble_body_at(0, 0.6, 0));
    tumble_body_options o = tumble_body_at(0.1, 0.8, 0.05);
    o.pose.rotation = tumble_quat_turn(tumble_v(0, 1, 0), 0.4);
    tumble_body_add(w, s, o);
    o = tumble_body_at(0.3, 3, 0.2);
    o.velocity = tumble_v(0, -20, 0);
    tumble_body_add(w, tumble_shape_box(w, tumble_v(0.08, 0.3, 0.08), 1), o);
    see_strain(r, 1);
}

const battery_scene battery_soft[] = {
    { "load", "ropes, one with 100 times its weight: strain",
      "1", 0.001, load },
    { "drape", "a cloth on a cube: too near / spacing", "1", 0.05, drape },
    { "curtain", "hung by two corners, a ball: strain",
      "1", 0.001, curtain_of },
    { "laden", "a sheet with four boxes: strain", "1", 0.001, laden },
    { "layers", "two sheets and a peg: strain", "1", 0.001, layers },
    { 0 } };
