// hard_thin.c - case 21: bullets against a plate of 1 cm and a cloth.

#include "hard.h"
#include "hard_set.h"
#include "random.h"
#include "step.h"

#include <math.h>
#include <stddef.h>

enum { PLATE_STATIC, PLATE_FREE, CLOTH, TARGETS };
static const char *const target_name[TARGETS] = {
    "static plate", "free plate", "cloth"
};
static const real SPEED[] = { 10, 32, 100, 316, 1000 };         // m/s
enum { SPEEDS = sizeof SPEED / sizeof *SPEED };

// The target is 1 m wide and deep, about the origin, and looks along y; bullets
// are icosahedra of 5 cm, and fly down.  The heaviest weighs 25 times what the
// cloth does.  (At the free plate, of 1 kg, only the lightest is shot: a heavy
// one takes the plate along.)
static const real BULLET = 0.05;                        // m
static const real MASS[] = { 0.05, 0.5, 5 };            // kg
enum { MASSES = sizeof MASS / sizeof *MASS };

// One shot: where the bullet begins, and how it flies.
typedef struct {
    vec3 from, way;         // m, m/s
    placement turned;
    vec3 spin;              // rad/s
} shot;

// A way up to 60 degrees off the straight one, that reaches y = 0 at `to`,
// after `before` s.
static shot any_shot(vec3 to, real speed, real before, unsigned long long *seed)
{
    shot s = { .turned = turned_anyhow(to, seed) };
    vec3 d;
    do d = random_direction(seed); while (d.y > -0.5);
    s.way = vec3_scale(speed, d);
    s.from = vec3_add_scaled(to, -before, s.way);
    s.spin = vec3_scale(50 * random_fraction(seed), random_direction(seed));
    return s;
}

static void add_bullet(setting *s, shot x, real mass)
{
    shape *plan = &s->plan[s->plans++];
    if (s->ok.ok) s->ok = shape_icosahedron(plan, BULLET, mass);
    placement p = x.turned;
    p.position = x.from;
    p.velocity = x.way;
    p.spin = x.spin;
    add_body(s, plan, p);
}

// Pins the rim of a cloth of n x n particles, or its corners only.
static void pin_cloth(world *w, int n, int corners)
{
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            int ends = (i == 0 || i == n - 1) + (j == 0 || j == n - 1);
            if (ends > corners) world_pin(w, 0, n * i + j);
        }
}

static void build_target(setting *s, int target, int corners)
{
    enum { CELLS = 20 };
    world_options o = weightless(best(8));
    o.most_substeps = 1000;
    setting_start(s, o);
    placement p = placement_at(vec3_make(0, 0, 0));
    if (target == CLOTH) {
        shape *cloth = &s->plan[s->plans++];
        if (s->ok.ok)
            s->ok = shape_cloth(cloth, CELLS + 1, CELLS + 1, 1, 1, 0.2, 0.2);
        add_body(s, cloth, p);
        if (s->ok.ok) pin_cloth(&s->w, CELLS + 1, corners);
        return;
    }
    p.is_static = target == PLATE_STATIC;
    add_body(s, add_box(s, vec3_make(1, 0.01, 1), 1), p);
}

// m, how high the bullet is over the target, as it lies; HUGE_VAL beyond its
// rim.  (A box has its corners 1, 2 and 4 along x, y and z from corner 0.)
static real height_over(const setting *s, int target)
{
    vec3 x = middle(&s->w, 1), up = { 0, 1, 0 }, along[2] = { { 1, 0, 0 },
                                                             { 0, 0, 1 } };
    if (target != CLOTH) {
        vec3 at[8];
        world_vertices(&s->w, &s->w.body[0], at);
        x = vec3_sub(x, vec3_scale(0.5, vec3_add(at[0], at[7])));
        along[0] = vec3_sub(at[1], at[0]);
        along[1] = vec3_sub(at[4], at[0]);
        up = vec3_scale(100, vec3_sub(at[2], at[0]));
    }
    int beyond = fabs(vec3_dot(x, along[0])) > 0.5
              || fabs(vec3_dot(x, along[1])) > 0.5;
    return beyond ? HUGE_VAL : vec3_dot(x, up);
}

// A cloth gives way, but not by 30 cm: that would be a strain of 17 %.  A free
// plate that was struck turns, and may turn its back to a bullet that has long
// left it: a bullet is through that is just behind the plate, or flies on with
// half of its speed.
static int went_through(const setting *s, int target, vec3 way)
{
    real height = height_over(s, target);
    if (target == CLOTH)        return !(height > -0.3);
    if (target == PLATE_STATIC) return !(height > 0);
    return !(height > 0 || height < -0.1)
        || (velocity(&s->w, 1).y < way.y / 2 && middle(&s->w, 1).y < -0.1);
}

// For a second, or until the bullet is well away, or beyond the rim.
static int passes_through(hard_report *r, setting *s, int target, vec3 way,
                          real before)
{
    if (!hard_ok(r, setting_begin(s))) return 1;
    int passed = 0, was_over = 0, is_away = 0;
    for (int f = 0; f < 60 && !passed && !is_away; f++) {
        world_step(&s->w);
        passed = went_through(s, target, way);
        real height = height_over(s, target);
        is_away = was_over && height > 0.3 && s->w.time > before;
        was_over |= height < 0.3;
    }
    return passed;
}

static int count_through(hard_report *r, int target, real speed, int shots)
{
    unsigned long long seed = 21;
    int through = 0;
    for (int n = 0; n < shots; n++) {
        setting s;
        vec3 to = { 0.6 * random_fraction(&seed) - 0.3, 0,
                    0.6 * random_fraction(&seed) - 0.3 };
        real before = 0.2 / speed + random_fraction(&seed) / 30;
        build_target(&s, target, n % 2);
        shot x = any_shot(to, speed, before, &seed);
        add_bullet(&s, x, MASS[target == PLATE_FREE ? 0 : n % MASSES]);
        through += passes_through(r, &s, target, x.way, before);
        setting_free(&s);
    }
    return through;
}

// Shots that pass beside the plate, 1 to 30 cm from its rim, without turning:
// nothing may push them.
static int count_ghosts(hard_report *r, real speed, int shots)
{
    unsigned long long seed = 22;
    int ghosts = 0;
    for (int n = 0; n < shots; n++) {
        setting s;
        vec3 to = { 0.5 + BULLET + 0.01 + 0.29 * random_fraction(&seed), 0, 0 };
        shot x = any_shot(to, speed, 0.2 / speed + random_fraction(&seed) / 30,
                          &seed);
        x.way = vec3_make(0, -speed, 0);
        x.from = vec3_make(to.x, fabs(x.from.y), to.z);
        x.spin = vec3_make(0, 0, 0);
        build_target(&s, PLATE_STATIC, 0);
        add_bullet(&s, x, MASS[0]);
        if (!hard_ok(r, setting_begin(&s))) return shots;
        run_for(&s, 0.1);
        vec3 v = velocity(&s.w, 1);
        ghosts += !(vec3_distance(v, x.way) < 1e-9 * speed);
        setting_free(&s);
    }
    return ghosts;
}

static void bullets(hard_report *r, int fast)
{
    for (int target = 0; target < TARGETS; target++)
        for (int k = 0; k < SPEEDS; k++) {
            int shots = target == CLOTH ? 60 : 300;
            if (fast && target == CLOTH && SPEED[k] > 100) continue;
            if (fast && target != PLATE_STATIC) shots = 4;
            hard_add(r, count_through(r, target, SPEED[k], shots), 0, "",
                     "through, %s, %g m/s, %d shots", target_name[target],
                     SPEED[k], shots);
        }
    for (int k = 0; k < SPEEDS; k++)
        hard_add(r, count_ghosts(r, SPEED[k], fast ? 4 : 40), 0, "",
                 "pushed, but beside the plate, %g m/s", SPEED[k]);
}

const hard_case hard_thin[] = {
    { 21, "bullets at a plate, a cloth", 1, bullets },
    { 0, NULL, 0, NULL }
};
