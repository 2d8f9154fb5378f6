// family_round.c - rows 110 to 114: hulls with round faces, coins and drums.
//
// They are dropped, flat, tilted and turned at random, and lie still after a
// while: no deeper than half a percent of their size, on a plane as on a box.

#include "family.h"

#include <math.h>
#include <stddef.h>

typedef struct {
    int corners;
    double radius, height;      // m
    int start;                  // 0: flat; 1, 2: tilted; 3: turned at random
    int on_box;
    double dt;                  // s
} trial;

typedef struct { family_worst deepest, resting, awake; } tally;

static tumble_quat first_rotation(const trial *t, family_seed *s)
{
    static const double tilt[] = { 0, 0.5, 1.2 };
    if (t->start < 3)
        return tumble_quat_turn(tumble_v(1, 0, 0.3), tilt[t->start]);
    return family_rotation(s);
}

// A table as wide as 40 radii, or a plane.
static void add_ground(tumble_world *w, const trial *t)
{
    if (!t->on_box) {
        tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
        return;
    }
    double a = t->radius;
    tumble_body_options o = tumble_body_at(0, -a, 0);
    o.kind = TUMBLE_STATIC;
    tumble_body_add(w, tumble_shape_box(w, tumble_v(40 * a, 2 * a, 40 * a), 1),
                    o);
}

// Its lowest point begins one radius above the ground.
static tumble_body drop(tumble_world *w, const trial *t, family_seed *s)
{
    double a = t->radius;
    tumble_shape shape = family_prism(w, t->corners, a, t->height,
                                      1000 * a * a * t->height);
    double reach = sqrt(a * a + t->height * t->height / 4);
    tumble_body_options o = tumble_body_at(0, a + reach, 0);
    o.pose.rotation = first_rotation(t, s);
    return tumble_body_add(w, shape, o);
}

static void let_fall(hard_report *r, tally *a, const trial *t, family_seed *s)
{
    tumble_options o = family_options(t->dt, 0.5);
    tumble_world *w = tumble_world_make(&o);
    add_ground(w, t);
    tumble_body b = drop(w, t, s);
    double deepest = 0, size = fmax(2 * t->radius, t->height);
    // Twenty seconds; those of 1 cm and of 1 m fall for .05 and .5 s of them.
    for (double time = 0; time < 20 && tumble_body_is_awake(w, b);
         time += t->dt) {
        tumble_world_step(w);
        deepest = hard_worse(deepest, tumble_world_measure(w).penetration);
    }
    static const char *const start[] = { "flat", "tilted", "steep", "turned" };
#define HERE "%d corners, radius %g m, height %g m, %s, dt 1/%.0f", \
    t->corners, t->radius, t->height, start[t->start], 1 / t->dt
    family_trial(&a->deepest, deepest / size, HERE);
    family_trial(&a->resting, tumble_world_measure(w).penetration / size, HERE);
    family_trial(&a->awake, tumble_body_is_awake(w, b), HERE);
#undef HERE
    family_ok(r, w);
    tumble_world_free(w);
}

static void all_shapes(hard_report *r, int on_box, int fast)
{
    static const int corners[] = { 6, 8, 12, 16, 24, 32, 48 };
    static const double radius[] = { 0.1, 0.01, 1 }, height[] = { 0.1, 0.5, 2 };
    tally a = { .deepest = { .target = 5e-3 }, .resting = { .target = 5e-3 },
                .awake = { .target = 0 } };
    family_seed seed = 110;
    for (int c = 0; c < 7; c++)
        for (int h = 0; h < 3; h++)
            for (int k = 0; k < (fast ? 1 : 3); k++)
                for (int i = fast ? 1 : 0; i < (fast ? 2 : 4); i++) {
                    trial t = { corners[c], radius[k], height[h] * radius[k],
                                i, on_box, (c + h) % 3 ? 1 / 60.0
                                                       : 1 / 120.0 };
                    let_fall(r, &a, &t, &seed);
                }
    family_add(r, &a.deepest, "", "deepest in any frame / size");
    family_add(r, &a.resting, "", "deepest at the end / size");
    family_add(r, &a.awake, "", "awake after 20 s");
}

static void on_a_plane(hard_report *r, int fast)
{
    all_shapes(r, 0, fast);
}

static void on_a_box(hard_report *r, int fast)
{
    all_shapes(r, 1, fast);
}

// ---- 112: rolls and piles of coins -----------------------------------------

// Ten coins, one on the other, stand, and keep their height to half a percent.
static void roll_of_coins(hard_report *r, family_worst *sunk, family_worst *off,
                          int corners, double radius, double thick)
{
    enum { COINS = 10 };
    tumble_world *w = tumble_world_make(NULL);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    double height = thick * radius;
    tumble_shape coin = family_prism(w, corners, radius, height,
                                     1000 * radius * radius * height);
    tumble_body top = tumble_body_ground();
    for (int i = 0; i < COINS; i++) {
        tumble_body_options o = tumble_body_at(0, (i + 0.5) * height, 0);
        o.pose.rotation = tumble_quat_turn(tumble_v(0, 1, 0), 0.3 * i);
        top = tumble_body_add(w, coin, o);
    }
    family_run(w, 5);
    tumble_vec3 x = tumble_body_position(w, top);
#define HERE "%d corners, radius %g m, thickness %g of it", corners, radius, \
    thick
    family_trial(sunk, fabs(x.y / ((COINS - 0.5) * height) - 1), HERE);
    family_trial(off, hypot(x.x, x.z) / radius, HERE);
#undef HERE
    family_ok(r, w);
    tumble_world_free(w);
}

static void rolls_of_coins(hard_report *r, int fast)
{
    static const int corners[] = { 6, 12, 24, 48 };
    static const double radius[] = { 0.1, 0.01, 1 }, thick[] = { 0.1, 0.4, 1 };
    family_worst sunk = { .target = 1e-2 }, off = { .target = 1e-2 };
    for (int c = 0; c < 4; c++)
        for (int k = 0; k < (fast ? 1 : 3); k++)
            for (int h = 0; h < 3; h++)
                roll_of_coins(r, &sunk, &off, corners[c], radius[k], thick[h]);
    family_add(r, &sunk, "", "height of the upper coin, from its own");
    family_add(r, &off, "", "the upper coin's way aside / radius");
}

const hard_case family_round[] = {
    { 110, "coins and drums on a plane", 1, on_a_plane },
    { 111, "coins and drums on a box", 1, on_a_box },
    { 112, "rolls of ten coins", 1, rolls_of_coins },
    { 0, NULL, 0, NULL }
};
