// family_momentum.c - rows 120 to 124: both momenta of bodies that collide.
//
// No gravity and no ground: sum m v and sum (x x m v + I w) cannot change,
// whatever the shapes, masses, restitution and friction.

#include "family.h"

#include <math.h>
#include <stddef.h>

typedef enum { BALLS, BOXES, CAPSULES, COINS, MIXED, SHAPES } mix;
static const char *const mix_name[SHAPES] = { "balls", "boxes", "capsules",
                                              "coins", "mixed" };

static tumble_shape some_shape(tumble_world *w, mix m, double size, double mass,
                               family_seed *s)
{
    if (m == MIXED) m = (mix)(int)family_between(s, 0, MIXED);
    double a = size / 2;
    switch (m) {
    case BALLS:    return tumble_shape_sphere(w, a, mass);
    case CAPSULES: return tumble_shape_capsule(w, a, a / 2, mass);
    case COINS:    return family_prism(w, 12, a, a / 2, mass);
    default:
        return tumble_shape_box(w, tumble_v(size, 0.8 * size, 0.6 * size),
                                mass);
    }
}

// What the sums are held against: those of |m v|, and of |m v| times the size,
// which is the arm of an impact.  (The sum of |L| itself may be near zero.)
typedef struct { double linear, angular; } sums;

typedef struct {
    mix shapes;
    int bodies;
    double size, speed;         // m, m/s
    double friction, restitution, ratio;    // ratio: of the masses
    double dt;                  // s
} trial;

static void add_one(tumble_world *w, const trial *t, tumble_vec3 x,
                    tumble_vec3 v, double mass, sums *all, family_seed *s)
{
    tumble_body_options o = tumble_body_at(x.x, x.y, x.z);
    o.pose.rotation = family_rotation(s);
    o.velocity = v;
    tumble_body_add(w, some_shape(w, t->shapes, t->size, mass, s), o);
    all->linear += mass * v_length(v);
    all->angular += mass * v_length(v) * t->size;
}

// Two fly at each other, off their middles; more fly inwards from a ball.
static sums throw_together(tumble_world *w, const trial *t, family_seed *s)
{
    sums all = { 0, 0 };
    double density = 1000 * t->size * t->size * t->size;
    double away = t->size * (t->bodies > 2 ? 2 * cbrt(t->bodies) : 1.2);
    for (int i = 0; i < t->bodies; i++) {
        tumble_vec3 aim = v_scale(0.4 * t->size, family_direction(s));
        // Golden spiral: the same distance between all of them.
        double z = t->bodies > 2 ? 1 - (2 * i + 1.0) / t->bodies : 0;
        double turn = t->bodies > 2 ? 2.399963229728653 * i : FAMILY_PI * i;
        double across = sqrt(1 - z * z);
        tumble_vec3 out = { across * cos(turn), across * sin(turn), z };
        tumble_vec3 x = v_add(v_scale(away, out), aim);
        double mass = density * (i % 2 ? t->ratio : 1);
        add_one(w, t, x, v_scale(-t->speed, out), mass, &all, s);
    }
    return all;
}

static void collide(hard_report *r, family_worst *linear, family_worst *angular,
                    const trial *t, family_seed *s)
{
    tumble_options o = family_options(t->dt, t->friction);
    o.gravity = tumble_v(0, 0, 0);
    o.restitution = t->restitution;
    tumble_world *w = tumble_world_make(&o);
    sums all = throw_together(w, t, s);
    tumble_measures before = tumble_world_measure(w);
    family_run(w, 8 * t->size / t->speed * cbrt(t->bodies / 2.0));
    tumble_measures after = tumble_world_measure(w);
#define HERE "%d %s of %g m, %g m/s, e %g, 1 to %g, dt 1/%.0f", t->bodies, \
    mix_name[t->shapes], t->size, t->speed, t->restitution, t->ratio, 1 / t->dt
    family_trial(linear, v_distance(before.momentum, after.momentum)
                         / all.linear, HERE);
    family_trial(angular, v_distance(before.angular, after.angular)
                          / all.angular, HERE);
#undef HERE
    family_ok(r, w);
    tumble_world_free(w);
}

static void collisions(hard_report *r, int bodies, double friction, int times)
{
    static const double size[] = { 0.5, 0.01, 10 };
    static const double dt[] = { 1 / 60.0, 1 / 240.0 };
    static const double ratio[] = { 1, 10, 1000 };
    // A velocity is a difference of positions: it is rounded by ulp(x) / h.
    family_worst linear = { .target = 1e-11 }, angular = { .target = 1e-9 };
    family_seed seed = 120;
    for (int m = 0; m < SHAPES; m++)
        for (int n = 0; n < times; n++) {
            trial t = { .shapes = (mix)m, .bodies = bodies, .size = size[n % 3],
                        .friction = friction, .restitution = n / 2 % 3 / 2.0,
                        .ratio = ratio[n / 3 % 3], .dt = dt[n / 2 % 2] };
            t.speed = t.size * family_log_between(&seed, 2, 40);
            collide(r, &linear, &angular, &t, &seed);
        }
    family_add(r, &linear, "", "linear momentum / sum of m v");
    family_add(r, &angular, "", "angular momentum / sum of m v size");
}

static void pairs_smooth(hard_report *r, int fast)
{
    collisions(r, 2, 0, fast ? 6 : 600);
}

static void pairs_rough(hard_report *r, int fast)
{
    collisions(r, 2, 0.5, fast ? 6 : 600);
}

static void clouds_smooth(hard_report *r, int fast)
{
    collisions(r, 40, 0, fast ? 1 : 24);
}

static void clouds_rough(hard_report *r, int fast)
{
    collisions(r, 40, 0.5, fast ? 1 : 24);
}

const hard_case family_momentum[] = {
    { 120, "momenta, two bodies, mu 0", 1, pairs_smooth },
    { 121, "momenta, two bodies, mu .5", 1, pairs_rough },
    { 122, "momenta, 40 bodies, mu 0", 1, clouds_smooth },
    { 123, "momenta, 40 bodies, mu .5", 1, clouds_rough },
    { 0, NULL, 0, NULL }
};
