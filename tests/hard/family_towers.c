// family_towers.c - rows 135 to 139: towers of all sizes, a paddle in a bin.

#include "family.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>

// ---- 135: towers -----------------------------------------------------------

// Builds n cubes, one on the other, waits for ten seconds, and says how far the
// upper one has come down and aside, in heights of the tower and in sides.
static void stand(hard_report *r, int n, double side, tumble_options o,
                  double *sag, double *aside)
{
    tumble_world *w = tumble_world_make(&o);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_shape cube = tumble_shape_box(w, tumble_v(side, side, side),
                                         1000 * side * side * side);
    tumble_body top = tumble_body_ground();
    for (int i = 0; i < n; i++)
        top = tumble_body_add(w, cube, tumble_body_at(0, (i + 0.5) * side, 0));
    family_run(w, 10);
    tumble_vec3 x = tumble_body_position(w, top);
    *sag = fabs((n - 0.5) * side - x.y) / (n * side);
    *aside = hypot(x.x, x.z) / side;
    family_ok(r, w);
    tumble_world_free(w);
}

// What carries k cubes is pressed into the one below it, as a soft contact is:
// by c h^2 k g, where h is the substep.  So a tower of n sags by
// c h^2 g n^2 / 2 in all, and by c h^2 g n / (2 side) of its height: as the
// square of the substep, as n, and as 1 / side.
static void towers(hard_report *r, int fast)
{
    static const int n[] = { 5, 10, 20, 40, 60 };
    static const double side[] = { 1, 0.1, 0.01, 0.001, 10 };
    family_worst sag = { .target = 0.01 }, off = { .target = 0.5 };
    for (int i = 0; i < (fast ? 2 : 5); i++)
        for (int k = 0; k < (fast ? 1 : 5); k++) {
            double down, aside;
            stand(r, n[i], side[k], tumble_options_default(), &down, &aside);
            // Fallen is what stands aside by half a side.
            int fallen = !(aside < 0.5 && down < 0.5);
            family_trial(&off, aside, "%d cubes of %g m", n[i], side[k]);
            family_trial(&sag, fallen ? HUGE_VAL : down, "%d cubes of %g m%s",
                         n[i], side[k], fallen ? ", which fell" : "");
        }
    hard_add(r, (double)off.beyond, 0, "", "towers that fell, of %d",
             off.trials);
    hard_note(r, "the one that went furthest: %s", off.where);
    family_add(r, &sag, "", "sag / height");
}

// Does the sag follow its law?  The slope against the substep is 2, against the
// number of cubes 1, against their side -1.
static void sag_law(hard_report *r, int fast)
{
    static const int substeps[] = { 8, 16, 32 }, n[] = { 5, 10, 20 };
    static const double side[] = { 1, 2, 4 };
    double step[3], at[3], aside;
    int most = fast ? 5 : 10;
    for (int i = 0; i < 3; i++) {
        tumble_options o = tumble_options_default();
        o.substeps = o.most_substeps = substeps[i];
        o.sleep_speed = 0;
        step[i] = o.dt / o.substeps;
        stand(r, most, 1, o, &at[i], &aside);
    }
    hard_add(r, fabs(hard_order(step, at, 3) - 2), 0.2, "",
             "slope against the substep, from 2");
    double many[3], wide[3];
    for (int i = 0; i < 3; i++) {
        tumble_options o = tumble_options_default();
        o.sleep_speed = 0;
        many[i] = n[i];
        stand(r, n[i], 1, o, &at[i], &aside);
        hard_note(r, "%d cubes of 1 m at the defaults: sag / height %.4f", n[i],
                  at[i]);
        o.substeps = o.most_substeps = substeps[0];
        stand(r, n[i], 1, o, &at[i], &aside);
    }
    double c = 2 * at[1] / (step[0] * step[0] * FAMILY_G * n[1]);
    hard_note(r, "sag / height = c h^2 g n / (2 side) with c = %.2f", c);
    hard_add(r, fabs(hard_order(many, at, 3) - 1), 0.2, "",
             "slope against the number, from 1");
    for (int i = 0; i < 3; i++) {
        tumble_options o = tumble_options_default();
        o.sleep_speed = 0;
        o.substeps = o.most_substeps = substeps[0];
        wide[i] = side[i];
        stand(r, most, side[i], o, &at[i], &aside);
    }
    hard_add(r, fabs(hard_order(wide, at, 3) + 1), 0.2, "",
             "slope against the side, from -1");
}

// ---- 137: a paddle in a bin ------------------------------------------------

static void add_bin(tumble_world *w, double half)
{
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_plane_add(w, tumble_v(1, 0, 0), -half, -1);
    tumble_plane_add(w, tumble_v(-1, 0, 0), -half, -1);
    tumble_plane_add(w, tumble_v(0, 0, 1), -half, -1);
    tumble_plane_add(w, tumble_v(0, 0, -1), -half, -1);
}

// 60 cubes and balls in a bin of 14 x 14 sizes, of which a paddle stirs the
// middle.  No body can be faster than the tip and a fall through the bin.
static void stir(hard_report *r, family_worst *deep, family_worst *fast_one,
                 double size, double tips, double step)
{
    enum { BODIES = 60 };
    tumble_options o = family_options(step, 0.5);
    tumble_world *w = tumble_world_make(&o);
    double half = 7 * size, mass = 1000 * size * size * size;
    add_bin(w, half);
    tumble_body_options p = tumble_body_at(0, 1.5 * size, 0);
    p.kind = TUMBLE_KINEMATIC;
    p.spin = tumble_v(0, tips / (3 * size), 0);
    tumble_vec3 sides = { 6 * size, 2 * size, 0.5 * size };
    tumble_body_add(w, tumble_shape_box(w, sides, 1), p);
    tumble_shape cube = tumble_shape_box(w, tumble_v(size, size, size), mass);
    tumble_shape ball = tumble_shape_sphere(w, size / 2, mass);
    tumble_body body[BODIES];
    for (int i = 0; i < BODIES; i++) {
        double x = i % 6 - 2.5, z = i / 6 % 6 - 2.5, y = 3.5 + i / 36 * 1.5;
        body[i] = tumble_body_add(w, i % 2 ? cube : ball,
                                  tumble_body_at(1.4 * size * x, size * y,
                                                 1.4 * size * z));
    }
    // A body may be thrown up at the tip's speed, and falls from there.
    double allowed = tips + sqrt(2 * FAMILY_G * 6 * size);
    double deepest = 0, fastest = 0;
    for (double time = 0; time < 10; time += step) {
        tumble_world_step(w);
        deepest = hard_worse(deepest, tumble_world_measure(w).penetration);
        for (int i = 0; i < BODIES; i++) {
            double speed = v_length(tumble_body_velocity(w, body[i]));
            fastest = hard_worse(fastest, speed);
        }
    }
#define HERE "bodies of %g m, tips at %.3g m/s, dt 1/%.0f", size, tips, 1 / step
    family_trial(deep, deepest / size, HERE);
    family_trial(fast_one, fastest / allowed, HERE);
#undef HERE
    family_ok(r, w);
    tumble_world_free(w);
}

static void paddle(hard_report *r, int fast)
{
    static const double size[] = { 0.4, 0.1 }, turns[] = { 0.5, 2, 8 };
    static const double dt[] = { 1 / 60.0, 1 / 240.0 };
    family_worst deep = { .target = 0.05 }, fast_one = { .target = 1.1 };
    for (int k = 0; k < (fast ? 1 : 2); k++)
        for (int i = 0; i < (fast ? 1 : 3); i++)
            for (int n = 0; n < (fast ? 1 : 2); n++)
                stir(r, &deep, &fast_one, size[k],
                     turns[i] * sqrt(FAMILY_G * size[k]), dt[n]);
    family_add(r, &deep, "", "deepest overlap / size");
    family_add(r, &fast_one, "", "speed / (tip and fall)");
}

const hard_case family_towers[] = {
    { 135, "towers of 5 to 60, 1 mm to 10 m", 1, towers },
    { 136, "sag follows its law", 1, sag_law },
    { 137, "a paddle in a bin", 0, paddle },
    { 0, NULL, 0, NULL }
};
