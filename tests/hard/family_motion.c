// family_motion.c - rows 150 to 159: motions with a formula.

#include "family.h"

#include <math.h>
#include <stddef.h>

static const double dt[] = { 1 / 60.0, 1 / 240.0, 1 / 30.0 };

// ---- 150: free fall --------------------------------------------------------

// x + v t + g t^2 / 2, at any speed and any step.
static void parabola(hard_report *r, family_worst *off, double step,
                     family_seed *s)
{
    tumble_options o = family_options(step, 0.5);
    double g = family_log_between(s, 0.1, 100);
    double speed = family_log_between(s, 0.1, 300);
    tumble_vec3 down = v_scale(g, family_direction(s));
    o.gravity = down;
    tumble_world *w = tumble_world_make(&o);
    tumble_body_options b = tumble_body_at(0, 0, 0);
    b.velocity = v_scale(speed, family_direction(s));
    b.spin = v_scale(family_log_between(s, 0.1, 50), family_direction(s));
    tumble_shape box = tumble_shape_box(w, tumble_v(1, 0.6, 0.3), 2);
    tumble_body body = tumble_body_add(w, box, b);
    family_run(w, 2);
    double t = tumble_world_time(w);
    tumble_vec3 x = v_add(v_scale(t, b.velocity), v_scale(t * t / 2, down));
    double way = speed * t + g * t * t / 2;
    family_trial(off, v_distance(tumble_body_position(w, body), x) / way,
                 "g %.3g m/s^2, %.3g m/s, dt 1/%.0f", g, speed, 1 / step);
    family_ok(r, w);
    tumble_world_free(w);
}

static void free_fall(hard_report *r, int fast)
{
    family_worst off = { .target = 1e-10 };
    family_seed seed = 150;
    for (int n = 0; n < (fast ? 20 : 1000); n++)
        parabola(r, &off, dt[n % 3], &seed);
    family_add(r, &off, "", "distance from the parabola / way");
}

// ---- 151: rolling down -----------------------------------------------------

// What rolls without slip is as heavy again by I / a^2: a ball goes down with
// 5/7 g sin, if friction holds: tan <= 7/2 mu.  It begins at rest, or rolls
// with a speed of sqrt(g a) / 5 already.  The engine brakes what rolls slowly,
// so that balls come to rest (chapter 18), and this makes the difference.
static void roll(hard_report *r, family_worst off[2], double slope, double a,
                 double step, int rolls)
{
    tumble_options o = family_options(step, 1);
    o.gravity = v_scale(FAMILY_G, tumble_v(sin(slope), -cos(slope), 0));
    tumble_world *w = tumble_world_make(&o);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_body_options p = tumble_body_at(0, a, 0);
    double speed = rolls ? sqrt(FAMILY_G * a) / 5 : 0;
    p.velocity = tumble_v(speed, 0, 0);
    p.spin = tumble_v(0, 0, -speed / a);
    tumble_body b = tumble_body_add(w, tumble_shape_sphere(w, a, 1), p);
    family_run(w, 3);
    double t = tumble_world_time(w);
    double ideal = speed * t + 5 / 14.0 * FAMILY_G * sin(slope) * t * t;
    double slip =
        fabs(tumble_body_velocity(w, b).x + a * tumble_body_spin(w, b).z);
#define HERE "slope of %.0f degrees, radius %g m, dt 1/%.0f", \
    slope * 180 / FAMILY_PI, a, 1 / step
    family_trial(&off[0], fabs(tumble_body_position(w, b).x / ideal - 1), HERE);
    family_trial(&off[1], slip / (ideal / t), HERE);
#undef HERE
    family_ok(r, w);
    tumble_world_free(w);
}

static void rolling(hard_report *r, int fast)
{
    static const double slope[] = { 2, 10, 30, 60 };
    static const double radius[] = { 0.1, 0.01, 1, 10 };
    for (int rolls = 1; rolls >= 0; rolls--) {
        family_worst off[2] = { { .target = 1e-3 }, { .target = 1e-3 } };
        for (int i = 0; i < 4; i++)
            for (int k = 0; k < 4; k++)
                for (int n = 0; n < (fast ? 1 : 3); n++)
                    roll(r, off, slope[i] * FAMILY_PI / 180, radius[k], dt[n],
                         rolls);
        family_add(r, &off[0], "", rolls
                   ? "way of one that rolls, from its own"
                   : "way from rest, from 5/14 g sin t^2");
        family_add(r, &off[1], "", rolls ? "slip of one that rolls / speed"
                                         : "slip from rest / speed");
    }
}

// ---- 152: from sliding to rolling ------------------------------------------

// A ball that is set down with v and no spin slides for 2 v / (7 mu g), and
// then rolls with 5/7 v: its way until T is 5/7 v T + 2 v^2 / (49 mu g).
static void begin_to_roll(hard_report *r, family_worst *off, double speed,
                          double mu, double a, double step)
{
    tumble_options o = family_options(step, mu);
    tumble_world *w = tumble_world_make(&o);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_body_options b = tumble_body_at(0, a, 0);
    b.velocity = tumble_v(speed, 0, 0);
    tumble_body ball = tumble_body_add(w, tumble_shape_sphere(w, a, 1), b);
    double slides = 2 * speed / (7 * mu * FAMILY_G);
    family_run(w, 2 * slides + 10 * step);
    double ideal = 5 / 7.0 * speed * tumble_world_time(w)
                 + 2 * speed * speed / (49 * mu * FAMILY_G);
#define HERE "%g m/s, mu %g, radius %g m, dt 1/%.0f", speed, mu, a, 1 / step
    family_trial(&off[0],
                 fabs(tumble_body_velocity(w, ball).x / speed * 7 / 5 - 1),
                 HERE);
    family_trial(&off[1], fabs(tumble_body_position(w, ball).x / ideal - 1),
                 HERE);
#undef HERE
    family_ok(r, w);
    tumble_world_free(w);
}

static void sliding_to_rolling(hard_report *r, int fast)
{
    static const double speed[] = { 0.5, 3, 20 }, mu[] = { 0.05, 0.3, 1 };
    static const double radius[] = { 0.1, 0.01, 1 };
    family_worst off[2] = { { .target = 1e-3 }, { .target = 1e-2 } };
    for (int i = 0; i < 3; i++)
        for (int m = 0; m < 3; m++)
            for (int k = 0; k < 3; k++)
                for (int n = 0; n < (fast ? 1 : 3); n++)
                    begin_to_roll(r, off, speed[i], mu[m], radius[k], dt[n]);
    family_add(r, &off[0], "", "speed, from 5/7 v");
    family_add(r, &off[1], "", "way, from its formula");
}

// ---- 153: a free body that turns -------------------------------------------

// Euler's equations in the body's axes, and its rotation, by the rule of Runge
// and Kutta: y = spin (3), quaternion (4).
static void euler(const double inertia[3], const double y[7], double out[7])
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = (inertia[j] - inertia[k]) / inertia[i] * y[j] * y[k];
    }
    tumble_quat q = { y[3], y[4], y[5], y[6] };
    tumble_quat half = { y[0] / 2, y[1] / 2, y[2] / 2, 0 };
    tumble_quat rate = q_times(q, half);
    out[3] = rate.x;
    out[4] = rate.y;
    out[5] = rate.z;
    out[6] = rate.w;
}

static void runge_kutta(const double inertia[3], double y[7], double h)
{
    static const double share[4] = { 0, 0.5, 0.5, 1 };
    static const double weight[4] = { 1, 2, 2, 1 };
    double sum[7] = { 0 }, k[7] = { 0 };
    for (int stage = 0; stage < 4; stage++) {
        double at[7];
        for (int i = 0; i < 7; i++) at[i] = y[i] + share[stage] * h * k[i];
        euler(inertia, at, k);
        for (int i = 0; i < 7; i++) sum[i] += weight[stage] * k[i];
    }
    for (int i = 0; i < 7; i++) y[i] += h / 6 * sum[i];
}

static tumble_quat true_rotation(tumble_vec3 sides, tumble_vec3 spin, double t)
{
    double x = sides.x * sides.x, y = sides.y * sides.y, z = sides.z * sides.z;
    double inertia[3] = { y + z, x + z, x + y };
    double state[7] = { spin.x, spin.y, spin.z, 0, 0, 0, 1 };
    int steps = 20000;
    for (int n = 0; n < steps; n++) runge_kutta(inertia, state, t / steps);
    tumble_quat q = { state[3], state[4], state[5], state[6] };
    return q;
}

// How far the tips of the body's axes are from where they should be, in parts
// of its length.
static double turned_wrong(tumble_quat a, tumble_quat b)
{
    double worst = 0;
    for (int i = 0; i < 3; i++) {
        tumble_vec3 e = { i == 0, i == 1, i == 2 };
        worst = hard_worse(worst, v_distance(v_turn(a, e), v_turn(b, e)));
    }
    return worst;
}

static tumble_world *spin_freely(double step, tumble_vec3 sides,
                                 tumble_vec3 spin, tumble_body *body)
{
    tumble_options o = family_options(step, 0.5);
    o.gravity = tumble_v(0, 0, 0);
    tumble_world *w = tumble_world_make(&o);
    tumble_body_options b = tumble_body_at(0, 0, 0);
    b.spin = spin;
    *body = tumble_body_add(w, tumble_shape_box(w, sides, 2), b);
    return w;
}

// A second order in dt, for spins about every axis and between them; and L and
// the energy of what turns never change.
static void spin_once(hard_report *r, family_worst of[4], tumble_vec3 sides,
                      tumble_vec3 spin)
{
    enum { LEVELS = 4 };
    double step[LEVELS], error[LEVELS];
    tumble_quat truth = true_rotation(sides, spin, 2);
#define HERE "box %g x %g x %g m, spin %.3g, %.3g, %.3g", sides.x, sides.y, \
    sides.z, spin.x, spin.y, spin.z
    for (int k = 0; k < LEVELS; k++) {
        tumble_body b;
        step[k] = ldexp(1 / 60.0, -k);
        tumble_world *w = spin_freely(step[k], sides, spin, &b);
        tumble_measures before = tumble_world_measure(w);
        family_run(w, 2);
        tumble_measures after = tumble_world_measure(w);
        error[k] = turned_wrong(tumble_body_pose(w, b).rotation, truth);
        family_trial(&of[2], v_distance(after.angular, before.angular)
                             / v_length(before.angular), HERE);
        family_trial(&of[3], fabs(after.kinetic / before.kinetic - 1), HERE);
        family_ok(r, w);
        tumble_world_free(w);
    }
    // A symmetric step is off by a twelfth of its angle squared, every radian.
    double angle = v_length(spin) * step[0], radians = 2 * v_length(spin);
    family_trial(&of[0], error[0] / (radians * angle * angle / 12), HERE);
    // Where rounding is all that is left there is no order to be seen.
    if (error[LEVELS - 1] > 1e-9)
        family_trial(&of[1], fmax(2 - hard_order(step, error, LEVELS), 0),
                     HERE);
#undef HERE
}

static void free_spin(hard_report *r, int fast)
{
    static const tumble_vec3 sides[] = { { 1, 0.6, 0.3 }, { 1, 0.1, 0.1 },
                                         { 1, 1, 0.1 }, { 0.02, 0.015, 0.01 } };
    family_worst of[4] = { { .target = 1 }, { .target = 0.1 },
                           { .target = 1e-10 }, { .target = 1e-3 } };
    family_seed seed = 153;
    for (int k = 0; k < (fast ? 1 : 4); k++)
        for (int n = 0; n < (fast ? 2 : 8); n++) {
            double speed = family_log_between(&seed, 0.5, 12);
            tumble_vec3 spin = v_scale(speed, family_direction(&seed));
            spin_once(r, of, sides[k], spin);
        }
    // About the middle axis, with a little of the others: Dzhanibekov's flips.
    spin_once(r, of, sides[0], tumble_v(0.05, 5, 0.05));
    family_add(r, &of[0], "", "axes off after 2 s / angle (spin dt)^2 / 12");
    family_add(r, &of[1], "", "order in dt, below 2 by");
    family_add(r, &of[2], "", "angular momentum");
    family_add(r, &of[3], "", "energy");
}

// ---- 154: slide or topple --------------------------------------------------

// A block on a slope topples if tan > width / height, and stays below, as long
// as friction holds it.
static int topples(hard_report *r, double side, double shape, double part,
                   double step)
{
    tumble_options o = family_options(step, 3);
    double slope = atan(part * shape);
    o.gravity = v_scale(FAMILY_G, tumble_v(sin(slope), -cos(slope), 0));
    tumble_world *w = tumble_world_make(&o);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_vec3 sides = { shape * side, side, shape * side };
    tumble_shape block = tumble_shape_box(w, sides, 1000 * side * side * side);
    tumble_body b = tumble_body_add(w, block, tumble_body_at(0, side / 2, 0));
    int fell = 0;
    for (int n = 0; n < 40; n++) {
        family_run(w, 0.25);
        tumble_quat q = tumble_body_pose(w, b).rotation;
        fell |= !(v_turn(q, tumble_v(0, 1, 0)).y > 0.9);
    }
    family_ok(r, w);
    tumble_world_free(w);
    return fell;
}

static void toppling(hard_report *r, int fast)
{
    static const double side[] = { 1, 0.1, 0.01, 10 };
    static const double shape[] = { 0.2, 0.5, 1 };
    family_worst early = { .target = 0 }, late = { .target = 0 };
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++)
            for (int n = 0; n < (fast ? 1 : 3); n++) {
#define HERE "%g m high, %g of that wide, dt 1/%.0f", side[k], shape[i], \
    1 / dt[n]
                family_trial(&early, topples(r, side[k], shape[i], 0.97, dt[n]),
                             HERE);
                family_trial(&late, !topples(r, side[k], shape[i], 1.03, dt[n]),
                             HERE);
#undef HERE
            }
    family_add(r, &early, "", "topples at .97 of the slope");
    family_add(r, &late, "", "stands at 1.03 of the slope");
}

// ---- 155: a ball that bounces out ------------------------------------------

// Dropped from h with restitution e, a ball bounces at times that are a
// geometric series: so at any time its height has a formula.
static void bounces(hard_report *r, family_worst *off, double e, double a,
                    double height, double step)
{
    tumble_options o = family_options(step, 0.5);
    o.restitution = e;
    tumble_world *w = tumble_world_make(&o);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_body b = tumble_body_add(w, tumble_shape_sphere(w, a, 1),
                                    tumble_body_at(0, a + height, 0));
    double fall = sqrt(2 * height / FAMILY_G), worst = 0;
    // Three bounces: later ones may be too slow to bounce.
    double end = fall * (1 + 2 * e + 2 * e * e + e * e * e);
    int steps = (int)(end / step);
    for (int n = 0; n < steps; n++) {
        tumble_world_step(w);
        double t = tumble_world_time(w) + fall, flight = 2 * fall;
        double up = FAMILY_G * fall;
        while (t > flight) { t -= flight; flight *= e; up *= e; }
        double high = up * t - FAMILY_G * t * t / 2;
        worst = hard_worse(worst,
                           fabs(tumble_body_position(w, b).y - a - high));
    }
    family_trial(off, worst / height, "e %g, radius %g m, from %g m, dt 1/%.0f",
                 e, a, height, 1 / step);
    family_ok(r, w);
    tumble_world_free(w);
}

static void bouncing(hard_report *r, int fast)
{
    static const double e[] = { 0.6, 0.8, 1 }, radius[] = { 0.1, 0.01, 1 };
    static const double height[] = { 5, 20, 100 };
    family_worst off = { .target = 1e-6 };
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            for (int h = 0; h < 3; h++)
                for (int n = 0; n < (fast ? 1 : 3); n++)
                    bounces(r, &off, e[i], radius[k], height[h] * radius[k],
                            dt[n]);
    family_add(r, &off, "", "height in any frame / height at first");
}

const hard_case family_motion[] = {
    { 150, "free fall", 1, free_fall },
    { 151, "rolling down a slope", 1, rolling },
    { 152, "from sliding to rolling", 1, sliding_to_rolling },
    { 153, "a free body that turns", 1, free_spin },
    { 154, "toppling on a slope", 1, toppling },
    { 155, "three bounces", 1, bouncing },
    { 0, NULL, 0, NULL }
};
