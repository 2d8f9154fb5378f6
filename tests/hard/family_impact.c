// family_impact.c - rows 125 to 134, and 189: restitution, impacts with a
// formula, blades that turn, thin plates, and bodies at one place.

#include "family.h"

#include <math.h>
#include <stddef.h>

static const double dt[] = { 1 / 60.0, 1 / 240.0, 1 / 120.0 };

// A world of zero gravity.
static tumble_world *weightless(double step, double friction, double e)
{
    tumble_options o = family_options(step, friction);
    o.gravity = tumble_v(0, 0, 0);
    o.restitution = e;
    return tumble_world_make(&o);
}

// ---- 125 and 126: restitution 1 --------------------------------------------

static void add_walls(tumble_world *w, double half, int lid)
{
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_plane_add(w, tumble_v(1, 0, 0), -half, -1);
    tumble_plane_add(w, tumble_v(-1, 0, 0), -half, -1);
    tumble_plane_add(w, tumble_v(0, 0, 1), -half, -1);
    tumble_plane_add(w, tumble_v(0, 0, -1), -half, -1);
    if (lid) tumble_plane_add(w, tumble_v(0, -1, 0), -2 * half, -1);
}

// n bodies of this size in layers of 3 x 3, a size and a half apart, thrown in
// all directions; under gravity the first of them is dropped.
static void fill(tumble_world *w, int n, int cubes, double size, int dropped,
                 family_seed *s)
{
    double mass = 1000 * size * size * size, speed = 2 * sqrt(size * FAMILY_G);
    tumble_shape shape =
        cubes ? tumble_shape_box(w, tumble_v(size, size, size), mass)
              : tumble_shape_sphere(w, size / 2, mass);
    for (int i = 0; i < n; i++) {
        double x = i % 3 - 1, z = i / 3 % 3 - 1, y = 1 + i / 9;
        tumble_body_options o = tumble_body_at(1.9 * size * x, 1.9 * size * y,
                                               1.9 * size * z);
        if (cubes) o.pose.rotation = family_rotation(s);
        if (i > 0 || !dropped) o.velocity = v_scale(speed, family_direction(s));
        tumble_body_add(w, shape, o);
    }
}

static void bounce(hard_report *r, family_worst *energy, int n, int cubes,
                   double size, double gravity, double step, family_seed *s)
{
    tumble_options o = family_options(step, 0);
    o.gravity = tumble_v(0, -gravity, 0);
    o.restitution = 1;
    o.sleep_speed = 0;
    tumble_world *w = tumble_world_make(&o);
    add_walls(w, 3.5 * size, gravity == 0);
    fill(w, n, cubes, size, gravity > 0, s);
    double before = family_energy(w), worst = 0;
    for (int second = 0; second < 20; second++) {
        family_run(w, 1);
        double change = fabs(family_energy(w) / before - 1);
        worst = hard_worse(worst, change);
    }
    family_trial(energy, worst, "%d %s of %g m, dt 1/%.0f", n,
                 cubes ? "cubes" : "balls", size, 1 / step);
    family_ok(r, w);
    tumble_world_free(w);
}

static void elastic(hard_report *r, double gravity, int fast)
{
    static const int many[] = { 1, 2, 9, 18 };
    static const double size[] = { 1, 0.1, 10 };
    family_seed seed = 125;
    for (int cubes = 0; cubes < 2; cubes++) {
        family_worst energy = { .target = 0.01 };
        for (int n = 0; n < (fast ? 2 : 4); n++)
            for (int k = 0; k < (fast ? 1 : 3); k++)
                bounce(r, &energy, many[n], cubes, size[k], gravity,
                       dt[(n + k) % 3], &seed);
        family_add(r, &energy, "", cubes ? "energy of cubes in any second"
                                         : "energy of balls in any second");
    }
}

static void elastic_fall(hard_report *r, int fast)
{
    elastic(r, FAMILY_G, fast);
}

static void elastic_gas(hard_report *r, int fast)
{
    elastic(r, 0, fast);
}

// ---- 127: two balls, obliquely ---------------------------------------------

// Smooth balls exchange what they have along the line of their centres at the
// moment of touch: v' = v - (1 + e) m* / m (u . n) n, with the reduced mass m*.
static void meet(hard_report *r, family_worst *off, double step, family_seed *s)
{
    double e = family_random(s), size = family_log_between(s, 0.1, 10);
    double speed = size * family_log_between(s, 0.5, 60);
    double a = size * family_between(s, 0.2, 1);
    double b = size * family_between(s, 0.2, 1);
    double ma = family_log_between(s, 0.1, 10);
    double mb = family_log_between(s, 0.1, 10);
    tumble_world *w = weightless(step, 0, e);
    tumble_quat q = family_rotation(s);
    // b comes along x, and passes a's centre by a share of a + b.
    double past = family_between(s, 0, 0.9) * (a + b);
    double start = a + b + speed * step * family_between(s, 1, 4);
    tumble_vec3 x = v_turn(q, tumble_v(-start, past, 0));
    tumble_body_options o = tumble_body_at(0, 0, 0),
                        p = tumble_body_at(x.x, x.y, x.z);
    p.velocity = v_turn(q, tumble_v(speed, 0, 0));
    tumble_body first = tumble_body_add(w, tumble_shape_sphere(w, a, ma), o);
    tumble_body second = tumble_body_add(w, tumble_shape_sphere(w, b, mb), p);
    family_run(w, 2 * start / speed + 2 * step);
    double sine = past / (a + b), cosine = sqrt(1 - sine * sine);
    tumble_vec3 n = v_turn(q, tumble_v(cosine, -sine, 0));
    tumble_vec3 given = v_scale((1 + e) * mb / (ma + mb) * speed * cosine, n);
    tumble_vec3 taken = v_scale(-ma / mb, given);
    double error = v_distance(tumble_body_velocity(w, first), given)
                 + v_distance(tumble_body_velocity(w, second),
                              v_add(p.velocity, taken));
    family_trial(off, error / speed, "e %.2f, past by %.2f of a + b, %.2g "
                 "sizes a step, dt 1/%.0f", e, sine, speed * step / size,
                 1 / step);
    family_ok(r, w);
    tumble_world_free(w);
}

static void two_balls(hard_report *r, int fast)
{
    family_worst off = { .target = 1e-6 };
    family_seed seed = 127;
    for (int n = 0; n < (fast ? 20 : 2000); n++)
        meet(r, &off, dt[n % 3], &seed);
    family_add(r, &off, "", "velocities after, from the formula");
}

// ---- 128: a ball strikes the ground with spin ------------------------------

// Coulomb's impulse is at most mu times the normal one, m (1 + e) v: it slides
// with that, or it takes the whole slip u, of which a ball's effective mass
// 2/7 m needs 2/7 m u.
static void strike(hard_report *r, family_worst *off, double step,
                   family_seed *s)
{
    double e = family_random(s), mu = family_log_between(s, 0.02, 2);
    double a = family_log_between(s, 0.01, 1), down = family_between(s, 1, 10);
    double along = family_between(s, -10, 10);
    double spin = family_between(s, -10, 10) / a;
    tumble_world *w = weightless(step, mu, e);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    double high = a + down * step * family_between(s, 1, 3);
    tumble_body_options o = tumble_body_at(0, high, 0);
    o.velocity = tumble_v(along, -down, 0);
    o.spin = tumble_v(0, 0, spin);
    tumble_body b = tumble_body_add(w, tumble_shape_sphere(w, a, 1), o);
    family_run(w, high / down + step);
    double slip = along + spin * a;
    double push = fmin(mu * (1 + e) * down, 2 / 7.0 * fabs(slip));
    push *= slip > 0 ? -1 : 1;
    tumble_vec3 v = { along + push, e * down, 0 };
    double turns = spin + push / (0.4 * a);
    double error = v_distance(tumble_body_velocity(w, b), v)
                 + a * fabs(tumble_body_spin(w, b).z - turns);
    double speed = fabs(along) + down + fabs(spin * a);
    family_trial(off, error / speed, "e %.2f, mu %.2f, radius %.3f m, "
                 "down %.1f, along %.1f m/s, dt 1/%.0f", e, mu, a, down, along,
                 1 / step);
    family_ok(r, w);
    tumble_world_free(w);
}

static void spin_and_strike(hard_report *r, int fast)
{
    family_worst off = { .target = 1e-3 };
    family_seed seed = 128;
    for (int n = 0; n < (fast ? 20 : 2000); n++)
        strike(r, &off, dt[n % 3], &seed);
    family_add(r, &off, "", "velocity and spin after / speeds before");
}

// ---- 129 and 130: blades that turn -----------------------------------------

// A ball at rest within the circle of a blade's tip is hit in its first turn.
// It begins a quarter of a right angle away from the blade, and apart from it.
static void sweep(hard_report *r, family_worst *missed, int free_blade,
                  double step, family_seed *s)
{
    double thick = family_log_between(s, 0.005, 0.1);
    double spin = family_log_between(s, 5, 1000);
    if (family_random(s) < 0.5) spin = -spin;
    double a = family_log_between(s, 0.02, 0.1);
    double away = family_between(s, 0.4, 0.95);
    double angle = family_between(s, 0.15 * FAMILY_PI, 0.85 * FAMILY_PI);
    tumble_world *w = weightless(step, 0.3, 0);
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.kind = free_blade ? TUMBLE_DYNAMIC : TUMBLE_KINEMATIC;
    o.spin = tumble_v(0, spin, 0);
    tumble_shape blade = tumble_shape_box(w, tumble_v(2, 0.2, thick), 1000);
    if (family_random(s) < 0.25) {      // a round bar
        blade = tumble_shape_capsule(w, 2, thick, 1000);
        o.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1), FAMILY_PI / 2);
    }
    tumble_body_add(w, blade, o);
    tumble_body_options p = tumble_body_at(away * cos(angle), 0,
                                           away * sin(angle));
    tumble_body ball = tumble_body_add(w, tumble_shape_sphere(w, a, 0.01), p);
    // Half a turn brings one of its two ends there.
    family_run(w, FAMILY_PI / fabs(spin) + step);
    int hit = v_length(tumble_body_velocity(w, ball)) > 0;
    family_trial(missed, !hit, "%.0f rad/s, %.3f m thick, ball of %.3f m at "
                 "%.2f m, dt 1/%.0f", fabs(spin), thick, a, away, 1 / step);
    family_ok(r, w);
    tumble_world_free(w);
}

static void sweeps(hard_report *r, int free_blade, int fast)
{
    family_worst missed = { .target = 0 };
    family_seed seed = 129;
    for (int n = 0; n < (fast ? 40 : 4000); n++)
        sweep(r, &missed, free_blade, dt[n % 3], &seed);
    hard_add(r, (double)missed.beyond, 0, "", "balls that are missed, of %d",
             missed.trials);
    hard_note(r, "the first: %s", missed.where);
}

static void driven_blades(hard_report *r, int fast)
{
    sweeps(r, 0, fast);
}

static void free_blades(hard_report *r, int fast)
{
    sweeps(r, 1, fast);
}

// ---- 131: thin plates -------------------------------------------------------

// A ball that is shot at a plate, 20 kg and free or static, stays on its side.
static void shoot(hard_report *r, family_worst *through, double step,
                  family_seed *s)
{
    double thick = family_log_between(s, 1e-4, 5e-2);
    double speed = family_log_between(s, 5, 5000);
    double a = family_log_between(s, 0.01, 0.1);
    double slant = family_between(s, -1.2, 1.2);
    int is_free = family_random(s) < 0.75;
    tumble_world *w = weightless(step, 0.3, family_random(s) < 0.5 ? 0 : 0.5);
    tumble_body_options o = tumble_body_at(0, 0, 0),
                        p = tumble_body_at(0, 0, 0);
    o.kind = is_free ? TUMBLE_DYNAMIC : TUMBLE_STATIC;
    tumble_shape sheet = tumble_shape_box(w, tumble_v(3, thick, 3), 20);
    tumble_body plate = tumble_body_add(w, sheet, o);
    p.velocity = tumble_v(speed * sin(slant), -speed * cos(slant), 0);
    tumble_vec3 aim = { family_between(s, -0.5, 0.5), thick / 2 + a,
                        family_between(s, -0.5, 0.5) };
    p.pose.position = v_add(aim, v_scale(-1.7 * step, p.velocity));
    tumble_body ball = tumble_body_add(w, tumble_shape_sphere(w, a, 0.05), p);
    int lost = 0;
    // It may leave over the rim, and is then no longer judged.
    for (int n = 0; n < 60 && !lost; n++) {
        tumble_world_step(w);
        tumble_pose q = tumble_body_pose(w, plate);
        tumble_quat back = { -q.rotation.x, -q.rotation.y, -q.rotation.z,
                             q.rotation.w };
        tumble_vec3 x = tumble_body_position(w, ball);
        x = v_turn(back, v_sub(x, q.position));
        if (fabs(x.x) > 1.5 || fabs(x.z) > 1.5) { if (n > 3) break; }
        else lost = x.y < 0;
    }
    family_trial(through, lost, "%s plate of %.2g mm, %.0f m/s, ball of "
                 "%.3f m, dt 1/%.0f", is_free ? "free" : "static", 1e3 * thick,
                 speed, a, 1 / step);
    family_ok(r, w);
    tumble_world_free(w);
}

static void thin_plates(hard_report *r, int fast)
{
    family_worst through = { .target = 0 };
    family_seed seed = 131;
    for (int n = 0; n < (fast ? 40 : 10000); n++)
        shoot(r, &through, dt[n % 3], &seed);
    hard_add(r, (double)through.beyond, 0, "", "balls that are through, of %d",
             through.trials);
    hard_note(r, "the first: %s", through.where);
}

// ---- 189: coincident bodies part -------------------------------------------

// Overlaps are pushed out by 0.055 radii a frame.  A body that overlaps many is pushed
// out at that speed in all, whoever the others are: so n bodies that begin at one
// place have no more energy, once they are apart, than if each went so fast.
static void part_from(hard_report *r, family_worst *f, family_seed *seed, int n,
                      double jitter, int round, double step)
{
    double out = 0.055 * 1.02 * (round ? 0.5 : sqrt(0.75)) / step;      // m/s
    tumble_world *w = weightless(step, 0.5, 0);
    tumble_shape s = round ? tumble_shape_sphere(w, 0.5, 1)
                           : tumble_shape_box(w, tumble_v(1, 1, 1), 1);
    for (int i = 0; i < n; i++) {
        tumble_vec3 at = v_scale(jitter, family_direction(seed));
        tumble_body_add(w, s, tumble_body_at(at.x, at.y, at.z));
    }
    double speed = 0;
    for (double time = 0; time < 5; time += step) {
        tumble_world_step(w);
        double energy = tumble_world_measure(w).kinetic;
        speed = hard_worse(speed, sqrt(2 * energy / n));
    }
    family_trial(f, speed / out, "%d %s, %g m apart, dt 1/%.0f", n,
                 round ? "balls" : "cubes", jitter, 1 / step);
    family_ok(r, w);
    tumble_world_free(w);
}

static void coincident(hard_report *r, int fast)
{
    static const int many[] = { 2, 5, 15, 50 };
    static const double jitter[] = { 0, 0.01, 0.3 };
    family_worst speed = { .target = 1 };
    family_seed seed = 189;
    for (int k = 0; k < (fast ? 2 : 4); k++)
        for (int i = 0; i < 3; i++)
            for (int n = 0; n < (fast ? 1 : 4); n++)
                part_from(r, &speed, &seed, many[k], jitter[i], n % 2,
                          dt[n / 2]);
    family_add(r, &speed, "", "speed / that of pushing out");
}

const hard_case family_impact[] = {
    { 125, "restitution 1 under gravity", 1, elastic_fall },
    { 126, "restitution 1 without gravity", 1, elastic_gas },
    { 127, "two smooth balls, obliquely", 1, two_balls },
    { 128, "a ball strikes with spin", 1, spin_and_strike },
    { 129, "driven blades miss nothing", 1, driven_blades },
    { 130, "free blades miss nothing", 1, free_blades },
    { 131, "thin plates let nothing through", 1, thin_plates },
    { 189, "bodies at one place part", 0, coincident },
    { 0, NULL, 0, NULL }
};
