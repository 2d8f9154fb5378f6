// hard_bodies.c - cases 13 to 20: rigid bodies that strike, slide and stand.

#include "hard.h"
#include "hard_set.h"
#include "measure.h"
#include "random.h"
#include "step.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const real PI = 3.14159265358979323846;
static const real G = 9.81;                     // m/s^2

// ---- 13: two bodies collide ------------------------------------------------

// Two boxes of masses 1 and `ratio`, turned anyhow and turning, fly at each
// other at `speed` each, up to 0.3 m off the middle.
static void build_collision(setting *s, world_options o, real ratio, real speed,
                            unsigned long long *seed)
{
    setting_start(s, weightless(o));
    const shape *light = add_box(s, vec3_make(1, 0.8, 0.6), 1);
    const shape *heavy = add_box(s, vec3_make(1, 0.8, 0.6), ratio);
    vec3 off = vec3_scale(0.3, random_direction(seed));
    placement a = turned_anyhow(vec3_make(-0.75, 0, 0), seed);
    placement b = turned_anyhow(vec3_make(0.75, off.y, off.z), seed);
    a.velocity = vec3_make(speed, 0, 0);
    b.velocity = vec3_make(-speed, 0, 0);
    a.spin = vec3_scale(2, random_direction(seed));
    b.spin = vec3_scale(2, random_direction(seed));
    add_body(s, light, a);
    add_body(s, heavy, b);
}

// What a blow, or several, did at worst.
typedef struct {
    real momentum;      // change / sum of m |v| before
    real share;         // |share of the light body - m_B / (m_A + m_B)|
    real angular;       // change / sum of m |v| 1 m
    int  met;           // how many pairs did meet
} blow;

static void strike_once(hard_report *r, setting *s, real ratio, real speed,
                        blow *worst)
{
    if (!hard_ok(r, setting_begin(s))) return;
    measures before = world_measure(&s->w);
    vec3 a = velocity(&s->w, 0), b = velocity(&s->w, 1);
    real size = (1 + ratio) * speed;
    run_for(s, 1 / speed);
    measures after = world_measure(&s->w);
    real change_a = vec3_distance(velocity(&s->w, 0), a);
    real change_b = vec3_distance(velocity(&s->w, 1), b);
    if (!(change_a > 1e-3 * speed)) return;
    real share = change_a / (change_a + change_b);
    worst->met++;
    worst->share = fmax(worst->share, fabs(share - ratio / (1 + ratio)));
    worst->momentum = fmax(worst->momentum,
        vec3_distance(after.momentum, before.momentum) / size);
    worst->angular = fmax(worst->angular,
        vec3_distance(after.angular, before.angular) / size);
}

static void two_bodies(hard_report *r, int fast)
{
    unsigned long long seed = 13;
    real angular = 0;
    for (real ratio = 1; ratio <= 10000; ratio *= 10) {
        blow worst = { 0, 0, 0, 0 };
        for (int n = 0; n < (fast ? 10 : 100); n++) {
            world_options o = best(8);
            real speed = 2 + 4 * random_fraction(&seed);
            o.restitution = n % 3 / 2.0;
            setting s;
            build_collision(&s, o, ratio, speed, &seed);
            strike_once(r, &s, ratio, speed, &worst);
            setting_free(&s);
        }
        hard_add(r, worst.momentum, 1e-12, "", "momentum; 1:%g", ratio);
        hard_add(r, worst.met > 0 ? worst.share : HUGE_VAL, 1e-12, "",
                 "share of the push; 1:%g", ratio);
        angular = fmax(angular, worst.angular);
    }
    hard_note(r, "angular momentum changes by up to %.1e of m v times 1 m",
              angular);
}

// ---- 14: Newton's cradle ---------------------------------------------------

// As many fly off at the far end as came in, with their speed; the others stay.
static void cradle_errors(hard_report *r, setting *s, int flying, int side,
                          real *speed, real *energy)
{
    if (!hard_ok(r, setting_begin(s))) return;
    run_for(s, 1);
    for (int i = 0; i < CRADLE; i++) {
        int flies = side > 0 ? i < flying : i >= CRADLE - flying;
        vec3 want = { flies ? -side * CRADLE_SPEED : 0, 0, 0 };
        real off = vec3_distance(velocity(&s->w, i), want) / CRADLE_SPEED;
        *speed = fmax(*speed, off);
    }
    real whole = flying * CRADLE_SPEED * CRADLE_SPEED / 2;
    real kinetic = world_measure(&s->w).kinetic;
    *energy = fmax(*energy, fabs(kinetic / whole - 1));
}

static void newtons_cradle(hard_report *r, int fast)
{
    const real gap[] = { 0, 1e-9, 1e-3, 0.01 };
    (void)fast;
    for (int k = 0; k < 4; k++) {
        real speed = 0, energy = 0;
        for (int n = 0; n < 12; n++) {
            int flying = 1 + n % 3, side = n / 3 % 2 ? 1 : -1;
            world_options o = best(8);
            o.dt = n < 6 ? 1.0 / 60 : 1.0 / 73;
            setting s;
            build_cradle(&s, o, gap[k], flying, side);
            cradle_errors(r, &s, flying, side, &speed, &energy);
            setting_free(&s);
        }
        hard_add(r, speed, 0.02, "", "end speeds; gaps of %g mm", 1e3 * gap[k]);
        hard_add(r, energy, 0.02, "", "energy; gaps of %g mm", 1e3 * gap[k]);
    }
    hard_note(r, "1, 2 and 3 cubes come in, from the left and from the right, "
              "60 and 73 frames a second");
}

// ---- 15: a bounce ----------------------------------------------------------

// m, how high the cube gets between its first and its second touch: the top of
// the parabola through the two last frames, or the highest frame if it touches.
static real height_after(setting *s)
{
    const world *w = &s->w;
    real dt = w->options.dt, floor = s->start[0].y - 1, last = 1, top = 0;
    int touched = 0;
    for (int f = 0; f < 1.2 / dt; f++) {
        world_step(&s->w);
        real now = middle(w, 0).y - floor, speed = (now - last) / dt;
        real mean = (now + last) / 2 + G * dt * dt / 8;
        if (touched && speed > 0.2 && now > 0.02 && last > 0.01)
            return mean + speed * speed / (2 * G);
        touched |= now > last || now < 1e-3;
        if (touched) top = fmax(top, now);
        last = now;
    }
    return top;
}

static void bounces(hard_report *r, int fast)
{
    const int rate[] = { 20, 30, 60, 73, 120, 240 };
    (void)fast;
    for (int e = 0; e <= 2; e++)
        for (int k = 0; k < 6; k++) {
            world_options o = best(8);
            real want = e * e / 4.0;
            o.dt = 1.0 / rate[k];
            o.restitution = e / 2.0;
            setting s;
            build_bounce(&s, o);
            if (!hard_ok(r, setting_begin(&s))) return;
            hard_add(r, fabs(height_after(&s) - want), 0.01, "m",
                     "height, restitution %g; dt = 1/%d s", e / 2.0, rate[k]);
            setting_free(&s);
        }
}

// ---- 16: a slope -----------------------------------------------------------

// m, how far the block is down the slope after so many seconds more.
static real slid_after(setting *s, real seconds, real tilt)
{
    run_for(s, seconds);
    vec3 way = vec3_sub(middle(&s->w, 0), s->start[0]);
    return vec3_dot(way, vec3_make(cos(tilt), -sin(tilt), 0));
}

// mu one degree below or above the slope: after 10 s it must have slid as far
// as the formula says, or not have left its place.
static void rest_on_slope(hard_report *r, int degrees, int over, int awake)
{
    real tilt = degrees * PI / 180, mu = tan((degrees + over) * PI / 180);
    world_options o = best(8);
    o = kept_awake(o, awake);
    setting s;
    build_slope(&s, o, tilt, mu, 0);
    if (!hard_ok(r, setting_begin(&s))) return;
    real want = over > 0 ? 0 : G * (sin(tilt) - mu * cos(tilt)) * 50;
    real slid = slid_after(&s, 10, tilt);
    if (over > 0)
        hard_add(r, fabs(slid), 0.001, "m", "sticks%s; %d degrees, mu 1 over",
                 awake ? " awake" : "", degrees);
    else
        hard_add(r, fabs(slid / want - 1), 0.01, "",
                 "slides %.2f m; %d degrees, mu 1 under", want, degrees);
    setting_free(&s);
}

// Thrown along the slope with v, it comes to rest after v^2 / (2 a), or, thrown
// up a slope that is too steep, slides back.
static void slide_on_slope(hard_report *r, int degrees, real mu, real v)
{
    real tilt = degrees * PI / 180, up = v < 0 ? -1 : 1;
    real brake = G * (mu * cos(tilt) - up * sin(tilt));
    real stop = fabs(v) / brake, want = up * v * v / (2 * brake);
    real back = G * (sin(tilt) - mu * cos(tilt)), t = 3 - stop;
    if (back > 0) want += back * t * t / 2;
    setting s;
    build_slope(&s, best(8), tilt, mu, v);
    if (!hard_ok(r, setting_begin(&s))) return;
    hard_add(r, fabs(slid_after(&s, 3, tilt) / want - 1), 0.01, "",
             "%g m/s at %d degrees, mu %g: %.3f m in 3 s", v, degrees, mu,
             want);
    setting_free(&s);
}

static void slopes(hard_report *r, int fast)
{
    (void)fast;
    for (int degrees = 5; degrees <= 45; degrees += 10) {
        rest_on_slope(r, degrees, -1, 0);
        rest_on_slope(r, degrees, 1, 0);
        rest_on_slope(r, degrees, 1, 1);
    }
    slide_on_slope(r, 0, 0.5, 5);
    slide_on_slope(r, 20, 0.8, 2);
    slide_on_slope(r, 30, 0.3, -3);
}

// ---- 17 to 19: what stands -------------------------------------------------

// What became of a pile.
typedef struct {
    real drift;         // m, the largest way of a body from where it began
    real drift_each;    // m, the same, over the number of bodies up to it
    real penetration;   // m
    real asleep;        // s, when all slept; HUGE_VAL: never
} fate;

static void look_at_pile(setting *s, fate *f, int measure)
{
    world *w = &s->w;
    for (int b = 0; b < w->bodies; b++) {
        real way = vec3_distance(middle(w, b), s->start[b]);
        if (!(way <= f->drift)) f->drift = way;
        if (!(way <= f->drift_each * (b + 1))) f->drift_each = way / (b + 1);
    }
    if (measure)
        f->penetration = fmax(f->penetration, world_measure(w).penetration);
    if (w->report.asleep == w->bodies) f->asleep = fmin(f->asleep, w->time);
}

static fate pile_fate(hard_report *r, setting *s, real seconds)
{
    fate f = { 0, 0, 0, HUGE_VAL };
    if (!hard_ok(r, setting_begin(s))) return f;
    int frames = (int)(seconds / s->w.options.dt + 0.5);
    for (int n = 0; n < frames; n++) {
        world_step(&s->w);
        look_at_pile(s, &f, n < 60 || n % 10 == 9);
    }
    return f;
}

// ---- 17: stacks ------------------------------------------------------------

static void a_stack(hard_report *r, int cubes, int substeps, bool awake,
                    real t)
{
    const char *how = awake ? " awake" : "";
    world_options o = kept_awake(best(substeps), awake);
    setting s;
    build_stack(&s, o, cubes, 1);
    fate f = pile_fate(r, &s, t);
    setting_free(&s);
    hard_add(r, 1e3 * f.drift_each, 1, "mm", "drift a cube; %d%s", cubes, how);
    hard_add(r, f.penetration, 0.005, "m", "penetration; %d%s", cubes, how);
    if (!awake) hard_add(r, f.asleep, 3, "s", "asleep; %d", cubes);
}

// Asleep, a pile stands by decree: so each also has to stand without sleep.
static void stacks(hard_report *r, int fast)
{
    const int cubes[] = { 10, 20, 50 }, substeps[] = { 12, 16, 32 };
    for (int k = 0; k < 3; k++)
        for (int awake = 0; awake < 2; awake++)
            a_stack(r, cubes[k], substeps[k], awake, fast ? 2 : 30);
    hard_note(r, "12, 16 and 32 substeps; a drift is the way of a cube over the "
              "number of cubes up to it");
}

// ---- 18: heavy on light ----------------------------------------------------

static void heavy_on_light(hard_report *r, int fast)
{
    const int ratio[] = { 100, 300, 1000 };
    for (int k = 0; k < 3; k++)
        for (int awake = 0; awake < 2; awake++) {
            const char *how = awake ? " awake" : "";
            world_options o = kept_awake(best(8), awake);
            setting s;
            build_stack(&s, o, 2, ratio[k]);
            fate f = pile_fate(r, &s, fast ? 3 : 30);
            setting_free(&s);
            hard_add(r, f.penetration, 0.01, "m", "penetration; %d to 1%s",
                     ratio[k], how);
            hard_add(r, f.drift, 0.01, "m", "moved; %d to 1%s", ratio[k], how);
        }
}

// ---- 19: a card house, an arch ---------------------------------------------

static void report_pile(hard_report *r, setting *s, const char *what,
                        real size, real seconds)
{
    fate f = pile_fate(r, s, seconds);
    setting_free(s);
    hard_add(r, f.drift / size, 0.01, "", "displacement / size; %s", what);
    if (f.asleep < HUGE_VAL)
        hard_note(r, "%s: asleep after %.2f s", what, f.asleep);
}

// What ought to fall must fall: an arch a little too thin, and cards that find
// too little friction (the feet of one that carries much want tan of its lean).
static void must_fall(hard_report *r)
{
    setting s;
    build_card_house(&s, standing(12, 0.25, 0), 5, 20 * PI / 180);
    hard_add(r, !(pile_fate(r, &s, 3).drift > 0.3), 0, "",
             "stands, but should fall: cards, mu 0.25");
    setting_free(&s);
    build_arch(&s, standing(12, 0.7, 0), 11, outer_radius(0.103));
    hard_add(r, !(pile_fate(r, &s, 4).drift > 0.3), 0, "",
             "stands, but should fall: thin arch");
    setting_free(&s);
}

static void card_house(hard_report *r, int fast)
{
    static const char *const house[2] = { "cards", "cards, awake" };
    static const char *const arch[2] = { "arch", "arch, awake" };
    real t = fast ? 2 : 30;
    setting s;
    for (int awake = 0; awake < 2; awake++) {
        build_card_house(&s, standing(12, 0.7, awake), 5, 20 * PI / 180);
        report_pile(r, &s, house[awake], 1, t);
        build_arch(&s, standing(12, 0.7, awake), 11, 1.3);
        report_pile(r, &s, arch[awake], 1.3, t);
    }
    for (int lean = 15; lean <= 25 && !fast; lean += 10) {
        char what[40];
        snprintf(what, sizeof what, "cards at %d degrees", lean);
        build_card_house(&s, standing(12, 0.6, 1), 5, lean * PI / 180);
        report_pile(r, &s, what, 1, t);
    }
    build_arch(&s, standing(12, 0.7, 1), 11, outer_radius(0.112));
    report_pile(r, &s, "thinnest arch", 1.1, t);
    must_fall(r);
    hard_note(r, "12 substeps; 40 cards of 1 x 0.02 x 0.7 m at 20 degrees, "
              "mu 0.7 (at 15 and 25: 0.6, awake); 11 stones, 1 to 1.3 m");
    hard_note(r, "the thinnest arch, 0.112 of its mean radius, stands awake; "
              "0.103 falls; Milankovitch: 0.1075");
}

// ---- 20: half inside each other --------------------------------------------

// m/s, the largest speed at which the two middles part, by their places from
// one frame to the next, within 2 s; left: m, how deep they still overlap.
static real parting_speed(setting *s, real *left)
{
    world *w = &s->w;
    real most = 0, dt = w->options.dt;
    for (int f = 0; f < 2 / dt; f++) {
        vec3 a = middle(w, 0), b = middle(w, 1);
        world_step(w);
        vec3 moved = vec3_sub(vec3_sub(middle(w, 1), b),
                              vec3_sub(middle(w, 0), a));
        most = fmax(most, vec3_length(moved) / dt);
    }
    *left = world_measure(w).penetration;
    return most;
}

static void overlapping_cubes(hard_report *r, int fast)
{
    const vec3 offset[] = {
        { 0.5, 0, 0 }, { 0.5, 0.1, 0.05 }, { 0.5, 0.5, 0.5 }, { 0.1, 0, 0 },
        { 0, 0, 0 }
    };
    (void)fast;
    for (int k = 0; k < 5; k++) {
        real left = HUGE_VAL;
        setting s;
        build_overlap(&s, best(8), offset[k]);
        if (!hard_ok(r, setting_begin(&s))) return;
        real speed = parting_speed(&s, &left);
        hard_add(r, speed, 3, "m/s", "leaving, offset %g %g %g m",
                 offset[k].x, offset[k].y, offset[k].z);
        hard_add(r, left, 0.001, "m", "still inside after 2 s");
        setting_free(&s);
    }
}

const hard_case hard_bodies[] = {
    { 13, "two bodies collide", 1, two_bodies },
    { 14, "Newton's cradle of five", 1, newtons_cradle },
    { 15, "bounce from 1 m", 1, bounces },
    { 16, "block on a slope", 1, slopes },
    { 17, "stacks of 10, 20, 50 cubes", 1, stacks },
    { 18, "heavy cube on a light one", 1, heavy_on_light },
    { 19, "card house, arch", 1, card_house },
    { 20, "cubes half inside each other", 1, overlapping_cubes },
    { 0, NULL, 0, NULL }
};
