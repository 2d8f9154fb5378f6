// family_symmetry.c - rows 140 to 149: the same scene scaled, moved, turned,
// mirrored and built in another order.
//
// Mechanics has no unit of its own, no place, no direction, no hand and no
// frame at rest.  So a scene that is built in another one, and seen from there,
// is the same scene.

#include "family.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

// How a scene is built: lengths, times and masses times so much; mirrored at
// x = 0, then turned, moved, and given a velocity; the bodies in what order.
typedef struct {
    double length, time, mass;
    int mirror, reversed;
    tumble_quat turn;
    tumble_vec3 move, drift;        // m, m/s
} view;

static view plain_view(void)
{
    view f = { .length = 1, .time = 1, .mass = 1, .turn = { 0, 0, 0, 1 } };
    return f;
}

static tumble_vec3 put_vector(const view *f, tumble_vec3 a)
{
    if (f->mirror) a.x = -a.x;
    return v_turn(f->turn, a);
}

// A turn is an axis, which mirrors the other way.
static tumble_quat put_turn(const view *f, tumble_quat q)
{
    if (f->mirror) { q.y = -q.y; q.z = -q.z; }
    return q_times(f->turn, q);
}

static tumble_vec3 put_position(const view *f, tumble_vec3 x, double time)
{
    tumble_vec3 moved = v_add(f->move, v_scale(time, f->drift));
    return v_add(v_scale(f->length, put_vector(f, x)), moved);
}

// ---- Scenes ----------------------------------------------------------------

// Calm: a tower of four, boxes that slide, balls that roll and bounce.  Pairs:
// six times a body falls on another, off its middle.  A heap: twelve bodies
// fall on each other; every impact makes small differences larger, so only equal
// bits can be asked of it.  All begin a little above the floor, since what
// touches exactly may touch or not touch in another view.
typedef enum { CALM, PAIRS, HEAP, SCENES } scene;
static const char *const scene_name[SCENES] = { "the calm scene", "the pairs",
                                                "the heap" };
static const int frames[SCENES] = { 60, 36, 60 };       // that are played
enum { BODIES = 12 };

static tumble_shape shape_of(tumble_world *w, const view *f, int i, double size)
{
    double s = size * f->length, mass = 1000 * size * size * size * f->mass;
    switch (i % 3) {
    case 0:  return tumble_shape_sphere(w, s / 2, mass);
    case 1:  return tumble_shape_capsule(w, s / 2, s / 4, mass);
    default: return tumble_shape_box(w, tumble_v(s, 0.75 * s, 0.5 * s), mass);
    }
}

// Body i of the calm scene: 0 to 3 are the tower, then boxes, then balls.
static tumble_shape calm_body(tumble_world *w, const view *f, int i,
                              tumble_body_options *o)
{
    double s = f->length, mass = 100 * f->mass;
    double slow = 1 + 0.5 * (i % 4);
    if (i < 4) {
        *o = tumble_body_at(0, 0.2505 + 0.5005 * i, 0);
        return tumble_shape_box(w, tumble_v(s / 2, s / 2, s / 2), mass);
    }
    if (i < 8) {
        *o = tumble_body_at(2, 0.1255, 2 * (i - 6));
        o->velocity = tumble_v(slow, 0, 0.5);
        o->pose.rotation = tumble_quat_turn(tumble_v(0, 1, 0), 0.2 * i);
        return tumble_shape_box(w, tumble_v(s / 2, s / 4, s / 2), mass);
    }
    *o = tumble_body_at(-2, i % 2 ? 0.2505 : 1, 2 * (i - 10));
    o->velocity = tumble_v(-slow, 0, 0.3);
    return tumble_shape_sphere(w, s / 4, mass);
}

static tumble_shape heap_body(tumble_world *w, const view *f, int i,
                              tumble_body_options *o)
{
    family_seed s = 1000u + (unsigned)i;
    *o = tumble_body_at(0.25 * (i % 3 - 1) + 0.0625, 0.6 + 0.5 * (i / 3),
                        0.25 * (i % 2) + 0.03125);
    o->pose.rotation = family_rotation(&s);
    o->spin = v_scale(2, family_direction(&s));
    return shape_of(w, f, i, 0.5);
}

// Six below, and six that fall on them.
static tumble_shape pairs_body(tumble_world *w, const view *f, int i,
                               tumble_body_options *o)
{
    int pair = i / 2, upper = i % 2;
    family_seed s = 2000u + (unsigned)i;
    *o = tumble_body_at(3 * (pair % 3 - 1) + 0.1 * upper, upper ? 1.1 : 0.3,
                        3 * (pair / 3) + 0.07 * upper);
    o->pose.rotation = family_rotation(&s);
    return shape_of(w, f, pair + upper, 0.5);
}

static tumble_body add_seen(tumble_world *w, const view *f, scene k, int i)
{
    tumble_body_options o;
    tumble_shape s = k == CALM  ? calm_body(w, f, i, &o)
                   : k == PAIRS ? pairs_body(w, f, i, &o)
                                : heap_body(w, f, i, &o);
    o.pose.position = put_position(f, o.pose.position, 0);
    o.pose.rotation = put_turn(f, o.pose.rotation);
    o.velocity = v_add(v_scale(f->length / f->time, put_vector(f, o.velocity)),
                       f->drift);
    tumble_vec3 spin = put_vector(f, o.spin);
    if (f->mirror) spin = v_scale(-1, spin);
    o.spin = v_scale(1 / f->time, spin);
    return tumble_body_add(w, s, o);
}

// A wide kinematic box, since a plane cannot move.
static void add_floor(tumble_world *w, const view *f)
{
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.kind = TUMBLE_KINEMATIC;
    o.pose.position = put_position(f, tumble_v(0, -2, 0), 0);
    o.pose.rotation = f->turn;
    o.velocity = f->drift;
    double a = f->length;
    tumble_body_add(w, tumble_shape_box(w, tumble_v(32 * a, 4 * a, 32 * a), 1),
                    o);
}

// Plays the scene, and writes where its bodies are then.  Two defaults are in seconds:
// that no substep is longer than 1/240 s, and the least time to sleep, so nothing
// sleeps in these.  sleep_speed is that of a cube of 1 m, and scales by itself.
static void play(hard_report *r, const view *f, scene k,
                 tumble_vec3 out[BODIES])
{
    tumble_options o = tumble_options_default();
    double speed = f->length / f->time;
    o.dt *= f->time;
    o.substeps = 4;
    o.time_to_sleep = 10 * f->time;
    o.friction = 0.5;
    o.restitution = 0.25;
    o.gravity = v_scale(speed / f->time, v_turn(f->turn, o.gravity));
    tumble_world *w = tumble_world_make(&o);
    tumble_body body[BODIES];
    add_floor(w, f);
    for (int n = 0; n < BODIES; n++) {
        int i = f->reversed ? BODIES - 1 - n : n;
        body[i] = add_seen(w, f, k, i);
    }
    for (int n = 0; n < frames[k]; n++) tumble_world_step(w);
    for (int i = 0; i < BODIES; i++) out[i] = tumble_body_position(w, body[i]);
    family_ok(r, w);
    tumble_world_free(w);
}

// How far apart are the two at most, in metres of the plain one?
static double apart(hard_report *r, const view *f, scene k)
{
    tumble_vec3 there[BODIES], here[BODIES];
    view plain = plain_view();
    play(r, &plain, k, here);
    play(r, f, k, there);
    double worst = 0;
    for (int i = 0; i < BODIES; i++) {
        double time = f->time * frames[k] / 60.0;
        tumble_vec3 right = put_position(f, here[i], time);
        worst = hard_worse(worst, v_distance(there[i], right) / f->length);
    }
    return worst;
}

// ---- 140: no unit of its own -----------------------------------------------

// Powers of two change the exponents of doubles and not their digits.  So the
// scaled scene has the same bits, if no length, time or mass is built in.
static void scaled(hard_report *r, int fast)
{
    family_worst froude = { .target = 0 }, slow = { .target = 0 },
                 heavy = { .target = 0 };
    for (int k = 0; k < SCENES; k++)
        for (int e = -5; e <= 5; e += fast ? 10 : 2) {
            view f = plain_view(), g = f, m = f;
            f.length = ldexp(1, 2 * e);
            f.time = g.time = ldexp(1, e);
            // The same density, and ten times this in powers of two.
            f.mass = ldexp(1, 6 * e);
            m.mass = ldexp(1, 4 * e);
            // A step is a second at most.
            family_trial(&froude, apart(r, &f, (scene)k), "%s, lengths x 2^%d",
                         scene_name[k], 2 * e);
            family_trial(&slow, apart(r, &g, (scene)k), "%s, times x 2^%d",
                         scene_name[k], e);
            family_trial(&heavy, apart(r, &m, (scene)k), "%s, masses x 2^%d",
                         scene_name[k], 4 * e);
        }
    family_add(r, &froude, "m", "lengths x 4^k, times x 2^k, same gravity");
    family_add(r, &slow, "m", "times x 2^k, gravity / 4^k");
    family_add(r, &heavy, "m", "masses x 16^k");
}

// ---- 141 to 145: no place, no direction, no hand, no frame, no first ------

static void see(hard_report *r, family_worst of[HEAP], const view *f,
                const char *what, double number)
{
    for (int k = 0; k < HEAP; k++)
        family_trial(&of[k], apart(r, f, (scene)k), "%s %g", what, number);
}

static void tell(hard_report *r, const family_worst of[HEAP])
{
    for (int k = 0; k < HEAP; k++)
        family_add(r, &of[k], "m", scene_name[k]);
}

// Rounding is 1e-16 of a metre, and an impact makes it ten times as large.
// What is more than this allows comes from a choice between equals: which
// points a manifold keeps, which contact an iteration begins with.  The bodies
// are half a metre wide.
#define WORSTS { { .target = 1e-4 }, { .target = 1e-3 } }

static void turned(hard_report *r, int fast)
{
    family_worst of[HEAP] = WORSTS;
    family_seed seed = 141;
    for (int n = 0; n < (fast ? 2 : 12); n++) {
        view f = plain_view();
        f.turn = family_rotation(&seed);
        see(r, of, &f, "rotation", n);
    }
    tell(r, of);
}

static void mirrored(hard_report *r, int fast)
{
    (void)fast;
    family_worst of[HEAP] = WORSTS;
    view f = plain_view();
    f.mirror = 1;
    see(r, of, &f, "mirror", 1);
    tell(r, of);
}

static void moved(hard_report *r, int fast)
{
    family_worst of[HEAP] = WORSTS;
    for (double far = 16; far < (fast ? 17 : 3000); far *= 4) {
        view f = plain_view();
        f.move = tumble_v(far, -far, 2 * far);
        see(r, of, &f, "metres from the origin:", far);
    }
    tell(r, of);
}

static void drifting(hard_report *r, int fast)
{
    family_worst of[HEAP] = WORSTS;
    for (double speed = 1; speed < (fast ? 2 : 200); speed *= 3) {
        view f = plain_view();
        f.drift = tumble_v(speed, speed / 2, -speed);
        see(r, of, &f, "m/s along x:", speed);
    }
    tell(r, of);
}

// Which body is solved first shows where an iteration is not finished.
static void reversed(hard_report *r, int fast)
{
    (void)fast;
    family_worst of[HEAP] = WORSTS;
    view f = plain_view();
    f.reversed = 1;
    see(r, of, &f, "the last first", 1);
    tell(r, of);
}

// ---- 146: friction has no direction ----------------------------------------

// A body that slides in any direction stops after v^2 / (2 mu g), and straight
// ahead; on a slope in any direction it stays up to mu, and slides beyond.
static void push_over(hard_report *r, family_worst *way, family_worst *aside,
                      double angle, double mu, double speed, double turn)
{
    tumble_options o = family_options(1 / 60.0, mu);
    tumble_world *w = tumble_world_make(&o);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_vec3 ahead = { cos(angle), 0, sin(angle) };
    tumble_body_options b = tumble_body_at(0, 0.1, 0);
    b.velocity = v_scale(speed, ahead);
    b.pose.rotation = tumble_quat_turn(tumble_v(0, 1, 0), turn);
    tumble_shape slider = tumble_shape_box(w, tumble_v(0.4, 0.2, 0.4), 10);
    tumble_body box = tumble_body_add(w, slider, b);
    family_run(w, 1.5 * speed / (mu * FAMILY_G));
    tumble_vec3 x = tumble_body_position(w, box);
    double ideal = speed * speed / (2 * mu * FAMILY_G), along = v_dot(x, ahead);
    x.y = 0;
#define HERE "at %.0f degrees, turned by %.1f, mu %g, %g m/s", \
    angle * 180 / FAMILY_PI, turn, mu, speed
    family_trial(way, fabs(along / ideal - 1), HERE);
    family_trial(aside, v_distance(x, v_scale(along, ahead)) / ideal, HERE);
#undef HERE
    family_ok(r, w);
    tumble_world_free(w);
}

// Does a box stay on a slope of `part` of mu, that falls in this direction?
static double slides_down(hard_report *r, double angle, double mu, double part)
{
    tumble_options o = family_options(1 / 60.0, mu);
    double slope = atan(part * mu);
    o.gravity = v_scale(FAMILY_G, tumble_v(sin(slope) * cos(angle), -cos(slope),
                                           sin(slope) * sin(angle)));
    tumble_world *w = tumble_world_make(&o);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_body b =
        tumble_body_add(w, tumble_shape_box(w, tumble_v(0.4, 0.1, 0.4), 10),
                        tumble_body_at(0, 0.05, 0));
    family_run(w, 4);
    tumble_vec3 x = tumble_body_position(w, b);
    family_ok(r, w);
    tumble_world_free(w);
    return hypot(x.x, x.z);
}

static void isotropic(hard_report *r, int fast)
{
    static const double mu[] = { 0.1, 0.5, 1 }, speed[] = { 1, 4, 16 };
    family_worst way = { .target = 0.03 }, aside = { .target = 0.01 };
    family_worst stays = { .target = 1e-3 }, goes = { .target = 0.1 };
    int directions = fast ? 4 : 16;
    for (int d = 0; d < directions; d++) {
        double angle = 2 * FAMILY_PI * (d + 0.3) / directions;
        for (int m = 0; m < 3; m++) {
            for (int v = 0; v < (fast ? 1 : 3); v++)
                push_over(r, &way, &aside, angle, mu[m], speed[v], 0.2 * d);
            family_trial(&stays, slides_down(r, angle, mu[m], 0.98),
                         "mu %g, %.0f degrees", mu[m], angle * 180 / FAMILY_PI);
            // It slides with g cos (1.02 - 1) mu for four seconds.
            double slope = atan(1.02 * mu[m]);
            double ideal = 0.02 * mu[m] * FAMILY_G * cos(slope) * 8;
            double down = slides_down(r, angle, mu[m], 1.02);
            family_trial(&goes, fabs(down / ideal - 1), "mu %g, %.0f degrees",
                         mu[m], angle * 180 / FAMILY_PI);
        }
    }
    family_add(r, &way, "", "way, from v^2 / (2 mu g)");
    family_add(r, &aside, "", "aside / way");
    family_add(r, &stays, "m", "way in 4 s on a slope of .98 mu");
    family_add(r, &goes, "", "way on a slope of 1.02 mu, from its own");
}

// ---- 147: nothing gives energy ---------------------------------------------

// Bodies that fall, slide and bounce lose energy, or keep it: whatever their
// shapes and sizes, it never becomes more than it was.
static void passive(hard_report *r, family_worst *gain, double size, double e,
                    double step, family_seed *s)
{
    tumble_options o = family_options(step, family_between(s, 0, 1));
    o.restitution = e;
    tumble_world *w = tumble_world_make(&o);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_plane_add(w, tumble_v(1, 0.3, 0), -3 * size, -1);
    tumble_plane_add(w, tumble_v(-1, 0.3, 0), -3 * size, -1);
    tumble_plane_add(w, tumble_v(0, 0.3, 1), -3 * size, -1);
    tumble_plane_add(w, tumble_v(0, 0.3, -1), -3 * size, -1);
    view f = plain_view();
    f.length = size;
    for (int i = 0; i < 24; i++) {
        tumble_body_options b = tumble_body_at(1.3 * size * (i % 3 - 1),
                                               1.2 * size * (1 + i / 9),
                                               1.3 * size * (i / 3 % 3 - 1));
        b.pose.rotation = family_rotation(s);
        b.velocity = v_scale(sqrt(size * FAMILY_G), family_direction(s));
        tumble_body_add(w, shape_of(w, &f, i, 1), b);
    }
    double before = family_energy(w), least = before, worst = 0;
    int steps = (int)(5 / step);
    for (int n = 0; n < steps; n++) {
        tumble_world_step(w);
        double now = family_energy(w);
        worst = hard_worse(worst, (now - least) / before);
        if (now < least) least = now;
    }
    family_trial(gain, worst, "24 bodies of %g m, e %g, dt 1/%.0f", size, e,
                 1 / step);
    family_ok(r, w);
    tumble_world_free(w);
}

static void no_gain(hard_report *r, int fast)
{
    static const double size[] = { 0.5, 0.02, 5 }, e[] = { 0, 0.5, 1 };
    static const double dt[] = { 1 / 60.0, 1 / 240.0 };
    family_worst gain = { .target = 1e-3 };
    family_seed seed = 147;
    for (int k = 0; k < (fast ? 1 : 3); k++)
        for (int i = 0; i < 3; i++)
            for (int n = 0; n < (fast ? 1 : 2); n++)
                passive(r, &gain, size[k], e[i], dt[n], &seed);
    family_add(r, &gain, "", "energy regained in 5 s / energy");
}

const hard_case family_symmetry[] = {
    { 140, "scaled: no unit of its own", 1, scaled },
    { 141, "turned: no direction", 1, turned },
    { 142, "moved: no place", 1, moved },
    { 143, "mirrored: no hand", 1, mirrored },
    { 144, "in a train: no frame at rest", 1, drifting },
    { 145, "the last added first: no order", 1, reversed },
    { 146, "friction in all directions", 1, isotropic },
    { 147, "nothing gains energy", 1, no_gain },
    { 0, NULL, 0, NULL }
};
