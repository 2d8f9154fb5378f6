// battery_held.c - scenes of the ledger: what turns, and what joints hold.

#include "battery.h"

#include <math.h>

static double energy_of(const tumble_world *w)
{
    tumble_measures m = tumble_world_measure(w);
    return m.kinetic + m.potential;
}

// A wheel on its tip, and a free brick that turns about its middle axis.
static void top(battery_run *r)
{
    tumble_world *w = r->w;
    tumble_body_options o = tumble_body_at(0, 0.2, 0);
    o.spin = tumble_v(0, 40, 0);
    tumble_body b =
        tumble_body_add(w, tumble_shape_box(w, tumble_v(0.4, 0.1, 0.3), 5), o);
    tumble_joint_ball(w, b, tumble_body_ground(), tumble_v(0.05, 0, 0));
    o = tumble_body_at(2, 0, 0);
    o.spin = tumble_v(0.01, 0.02, 12);
    tumble_body_add(w, tumble_shape_box(w, tumble_v(0.5, 0.1, 0.3), 5), o);
    battery_step(r, 0.1);
    double first = energy_of(w), scale = fabs(first);
    for (int k = 0; k < 12; k++) {
        battery_step(r, 0.25);
        battery_see(r, fabs(energy_of(w) - first) / scale);
    }
}

// Hinged planks, let go level: their energy, beside what all of them fall.
static void chain(battery_run *r)
{
    tumble_world *w = r->w;
    tumble_shape s = tumble_shape_box(w, tumble_v(0.18, 0.04, 0.1), 1);
    tumble_body before = tumble_body_ground();
    for (int k = 0; k < 12; k++) {
        tumble_body b = tumble_body_add(w, s,
                                        tumble_body_at(0.1 + 0.2 * k, 0, 0));
        tumble_joint_hinge(w, before, b, tumble_v(0.2 * k, 0, 0),
                           tumble_v(0, 0, 1));
        before = b;
    }
    battery_step(r, 0.1);
    double first = energy_of(w);
    for (int k = 0; k < 8; k++) {
        battery_step(r, 0.25);
        battery_see(r, fabs(energy_of(w) - first) / (12 * 9.81 * 1.2));
    }
}

// A bridge of hinged planks between walls, with a load: gaps of its joints.
static void planks(battery_run *r)
{
    tumble_world *w = r->w;
    tumble_shape s = tumble_shape_box(w, tumble_v(0.38, 0.05, 0.8), 10);
    tumble_joint j[11];
    tumble_body before = tumble_body_ground();
    for (int k = 0; k < 10; k++) {
        tumble_body b = tumble_body_add(w, s,
                                        tumble_body_at(0.2 + 0.4 * k, 1, 0));
        j[k] = tumble_joint_hinge(w, before, b, tumble_v(0.4 * k, 1, 0),
                                  tumble_v(0, 0, 1));
        before = b;
    }
    j[10] = tumble_joint_hinge(w, before, tumble_body_ground(),
                               tumble_v(4, 1, 0), tumble_v(0, 0, 1));
    tumble_body_add(w, tumble_shape_box(w, tumble_v(0.4, 0.4, 0.4), 100),
                    tumble_body_at(2, 1.25, 0));
    for (int k = 0; k < 24; k++) {
        battery_step(r, 1.0 / 60);
        for (int i = 0; i < 11; i++)
            battery_see(r, tumble_joint_gap(w, j[i]));
    }
}

// A scene of chapter 19, as it is there, for so long.
static void run_example(battery_run *r, const example *e, double seconds)
{
    e->build(r->w);
    for (int k = 0; k < 60 * seconds; k++) {
        if (e->act) e->act(r->w);
        battery_step(r, 1.0 / 60);
    }
    battery_see(r, example_error(e, r->w));
}

static void doll(battery_run *r)
{
    run_example(r, &ragdoll, 2);
}

static void balls(battery_run *r)
{
    tumble_options o = cradle.options ? cradle.options()
                                      : tumble_options_default();
    tumble_world_free(r->w);
    r->w = tumble_world_make(&o);
    run_example(r, &cradle, cradle.seconds);
}

static void wreck(battery_run *r)
{
    tumble_body b[64];
    wrecker.build(r->w);
    int n = tumble_world_bodies(r->w, b, 64);
    for (int k = 0; k < 8; k++) {
        battery_step(r, 0.25);
        battery_see(r, tumble_world_measure(r->w).penetration / 0.2);
    }
    battery_see(r, n > 0 ? 0 : HUGE_VAL);
}

const battery_scene battery_held[] = {
    { "top", "a wheel on its tip, a free brick: energy", "1", 0.001, top },
    { "chain", "12 hinged planks, let go level: energy / fall",
      "1", 0.01, chain },
    { "bridge", "10 planks and 100 kg: gap", "m", 0.0001, planks },
    { "doll", "a ragdoll on a stair: gap", "m", 0.0001, doll },
    { "cradle", "five balls: speed, from the first", "1", 0.01, balls },
    { "wrecker", "a ball on a chain: deepest overlap / 0.2 m",
      "1", 0.01, wreck },
    { 0 } };
