// family_ground.c - rows 115 to 119: ground that turns, lifts and moves.
//
// Coulomb: what rests on ground that accelerates stays on it as long as the
// force that this needs is no more than mu times the weight.  So up to .95 of
// that, nothing creeps: a millimetre in 10 s at most.

#include "family.h"

#include <math.h>
#include <stddef.h>

static const double share[] = { 0.2, 0.5, 0.8, 0.95 };      // of mu g
static const double dt[] = { 1 / 60.0, 1 / 240.0, 1 / 30.0 };
enum { SHARES = 4, STEPS = 3 };

// A kinematic plate whose top is y = 0 where it begins.
static tumble_body add_plate(tumble_world *w, double width, tumble_quat q)
{
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.kind = TUMBLE_KINEMATIC;
    o.pose.position = v_turn(q, tumble_v(0, -width / 20, 0));
    o.pose.rotation = q;
    tumble_vec3 sides = { width, width / 10, width };
    return tumble_body_add(w, tumble_shape_box(w, sides, 1), o);
}

// A low box that stands on the plate at x, in the plate's axes.
static tumble_body add_rider(tumble_world *w, double x, double size,
                             tumble_quat q, tumble_vec3 velocity,
                             tumble_vec3 spin)
{
    tumble_shape s = tumble_shape_box(w, tumble_v(size, size / 2, size),
                                      1000 * size * size * size);
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.pose.position = v_turn(q, tumble_v(x, size / 4, 0));
    o.pose.rotation = q;
    o.velocity = velocity;
    o.spin = spin;
    return tumble_body_add(w, s, o);
}

// Where is b, in the axes of the plate?
static tumble_vec3 seen_from(const tumble_world *w, tumble_body plate,
                             tumble_body b)
{
    tumble_pose p = tumble_body_pose(w, plate);
    tumble_quat back = { -p.rotation.x, -p.rotation.y, -p.rotation.z,
                         p.rotation.w };
    return v_turn(back, v_sub(tumble_body_position(w, b), p.position));
}

static double crept(const tumble_world *w, tumble_body plate, tumble_body b,
                    tumble_vec3 at)
{
    tumble_vec3 way = v_sub(seen_from(w, plate, b), at);
    return hypot(way.x, way.z);
}

// ---- 115: a turntable ------------------------------------------------------

// omega^2 R = share mu g.
static double ride_turntable(hard_report *r, double radius, double size,
                             double mu, double part, double step)
{
    tumble_options o = family_options(step, mu);
    tumble_world *w = tumble_world_make(&o);
    double omega = sqrt(part * mu * FAMILY_G / radius);
    tumble_quat level = { 0, 0, 0, 1 };
    tumble_body plate = add_plate(w, 3 * radius + 4 * size, level);
    tumble_vec3 spin = { 0, omega, 0 };
    tumble_body_set_velocity(w, plate, tumble_v(0, 0, 0), spin);
    tumble_body b = add_rider(w, radius, size, level,
                              tumble_v(0, 0, -omega * radius), spin);
    tumble_vec3 at = seen_from(w, plate, b);
    family_run(w, 10);
    double creep = crept(w, plate, b, at);
    family_ok(r, w);
    tumble_world_free(w);
    return creep;
}

static void turntable(hard_report *r, int fast)
{
    static const double radius[] = { 2, 0.5, 8 }, size[] = { 0.2, 0.05, 1 };
    static const double mu[] = { 0.5, 0.8, 0.2 };
    family_worst creep = { .target = 1e-3 };
    for (int k = 0; k < (fast ? 1 : 3); k++)
        for (int m = 0; m < (fast ? 1 : 3); m++)
            for (int n = 0; n < (fast ? 1 : STEPS); n++)
                for (int i = 0; i < SHARES; i++) {
                    double way = ride_turntable(r, radius[k], size[k], mu[m],
                                                share[i], dt[n]);
                    family_trial(&creep, way, "%g of friction, radius %g m, "
                                 "mu %g, dt 1/%.0f", share[i], radius[k], mu[m],
                                 1 / dt[n]);
                }
    family_add(r, &creep, "m", "creep in 10 s");
}

// ---- 116: a plate on a circle ----------------------------------------------

// The plate moves on a circle and does not turn.  In step n it goes straight
// from one point of the circle to the next.
static tumble_vec3 chord(double radius, double omega, double step, int n)
{
    double from = omega * n * step, to = from + omega * step;
    tumble_vec3 way = { radius * (cos(to) - cos(from)), 0,
                        radius * (sin(from) - sin(to)) };
    return v_scale(1 / step, way);
}

// How far is x from the segment between zero and `end`, in the plane?
static double off_segment(tumble_vec3 x, tumble_vec3 end)
{
    double square = v_dot(end, end);
    double along = square > 0 ? v_dot(x, end) / square : 0;
    if (along < 0) along = 0;
    if (along > 1) along = 1;
    tumble_vec3 off = v_sub(x, v_scale(along, end));
    return hypot(off.x, off.z);
}

// So its velocity jumps by some u at every step, and by Coulomb's law what lies
// on it slips by u^2 / (2 mu g) against u until friction has stopped it.  An
// engine may take the jumps as they are, or for the smooth motion that they
// stand for, which makes nothing slip.  So what is measured is how far the
// engine is from all that lies between the sum of these slips and zero.
static double ride_circle(hard_report *r, double radius, double size,
                          double mu, double part, double step)
{
    tumble_options o = family_options(step, mu);
    tumble_world *w = tumble_world_make(&o);
    double omega = sqrt(part * mu * FAMILY_G / radius);
    tumble_quat level = { 0, 0, 0, 1 };
    tumble_vec3 still = { 0, 0, 0 }, now = chord(radius, omega, step, 0);
    tumble_body plate = add_plate(w, 20 * size, level);
    tumble_body b = add_rider(w, 0, size, level, now, still);
    tumble_vec3 at = seen_from(w, plate, b), slips = still;
    int steps = (int)(10 / step + 0.5);
    for (int n = 0; n < steps; n++) {
        tumble_vec3 next = chord(radius, omega, step, n);
        tumble_vec3 jump = v_sub(next, now);
        double slip = v_length(jump) / (2 * mu * FAMILY_G);
        slips = v_sub(slips, v_scale(slip, jump));
        tumble_body_set_velocity(w, plate, next, still);
        tumble_world_step(w);
        now = next;
    }
    tumble_vec3 crept_by = v_sub(seen_from(w, plate, b), at);
    double creep = off_segment(crept_by, slips);
    family_ok(r, w);
    tumble_world_free(w);
    return creep;
}

static void circling(hard_report *r, int fast)
{
    static const double radius[] = { 1, 0.1, 10 };
    family_worst creep = { .target = 1e-3 };
    for (int k = 0; k < (fast ? 1 : 3); k++)
        for (int n = 0; n < (fast ? 1 : STEPS); n++)
            for (int i = 0; i < SHARES; i++)
                family_trial(&creep, ride_circle(r, radius[k], 0.2, 0.5,
                                                 share[i], dt[n]),
                             "%g of friction, circle of %g m, dt 1/%.0f",
                             share[i], radius[k], 1 / dt[n]);
    family_add(r, &creep, "m", "creep in 10 s, from its law");
}

// ---- 117: a lift with an inclined floor ------------------------------------

// It goes up at a constant speed, or up and down with half of gravity at most;
// the tangent of its slope is a share of mu.
static void ride_lift(hard_report *r, family_worst *creep, family_worst *deep,
                      double speed, int swings, double part, double step)
{
    const double mu = 0.5, size = 0.2;
    tumble_options o = family_options(step, mu);
    tumble_world *w = tumble_world_make(&o);
    tumble_quat q = tumble_quat_turn(tumble_v(0, 0, 1), atan(part * mu));
    double omega = 0.5 * FAMILY_G / speed;
    tumble_body plate = add_plate(w, 10 * size, q);
    tumble_vec3 start = { 0, speed, 0 };
    tumble_body b = add_rider(w, 0, size, q, start, tumble_v(0, 0, 0));
    tumble_vec3 at = seen_from(w, plate, b);
    double deepest = 0;
    int steps = (int)(10 / step + 0.5);
    for (int n = 0; n < steps; n++) {
        double from = sin(omega * n * step), to = sin(omega * (n + 1) * step);
        double now = swings ? speed * (to - from) / (omega * step) : speed;
        tumble_body_set_velocity(w, plate, tumble_v(0, now, 0),
                                 tumble_v(0, 0, 0));
        tumble_world_step(w);
        deepest = hard_worse(deepest, tumble_world_measure(w).penetration);
    }
#define HERE "%s %g m/s, slope of %g of friction, dt 1/%.0f", \
    swings ? "swings at" : "goes up at", speed, part, 1 / step
    family_trial(creep, crept(w, plate, b, at), HERE);
    family_trial(deep, deepest / size, HERE);
#undef HERE
    family_ok(r, w);
    tumble_world_free(w);
}

static void lift(hard_report *r, int fast)
{
    static const double speed[] = { 1, 0.1, 5, 20 };
    family_worst creep = { .target = 1e-3 }, deep = { .target = 5e-3 };
    for (int k = 0; k < (fast ? 1 : 4); k++)
        for (int n = 0; n < (fast ? 1 : STEPS); n++)
            for (int i = 0; i < 2 * SHARES; i++) {
                // What swings quicker than a step can follow is left out.
                int swings = i % 2;
                if (swings && speed[k] < 1) continue;
                ride_lift(r, &creep, &deep, speed[k], swings, share[i / 2],
                          dt[n]);
            }
    family_add(r, &creep, "m", "creep in 10 s");
    family_add(r, &deep, "", "deepest overlap / size");
}

// ---- 118: onto a moving belt -----------------------------------------------

// A body that is set at rest on a belt slips v^2 / (2 mu g) behind it.
static void board(hard_report *r, family_worst *slip, double speed, double mu,
                  double step)
{
    tumble_options o = family_options(step, mu);
    tumble_world *w = tumble_world_make(&o);
    tumble_quat level = { 0, 0, 0, 1 };
    double ideal = speed * speed / (2 * mu * FAMILY_G);
    double lasts = speed / (mu * FAMILY_G);
    tumble_body plate = add_plate(w, 4 * ideal + 4, level);
    tumble_body_set_velocity(w, plate, tumble_v(speed, 0, 0),
                             tumble_v(0, 0, 0));
    tumble_body b = add_rider(w, 0, 0.2, level, tumble_v(0, 0, 0),
                              tumble_v(0, 0, 0));
    tumble_vec3 at = seen_from(w, plate, b);
    family_run(w, 1.5 * lasts);
    family_trial(slip, fabs(crept(w, plate, b, at) / ideal - 1),
                 "%g m/s, mu %g, dt 1/%.0f", speed, mu, 1 / step);
    family_ok(r, w);
    tumble_world_free(w);
}

static void boarding(hard_report *r, int fast)
{
    static const double speed[] = { 1, 2, 5, 10, 20 }, mu[] = { 0.2, 0.5, 0.9 };
    family_worst slip = { .target = 0.03 };
    for (int k = 0; k < 5; k++)
        for (int m = 0; m < 3; m++)
            for (int n = 0; n < (fast ? 1 : STEPS); n++)
                board(r, &slip, speed[k], mu[m], dt[n]);
    family_add(r, &slip, "", "slip, from v^2 / (2 mu g)");
}

// ---- 119: a ball in a lift -------------------------------------------------

// At a constant speed a lift is as good a floor as the ground: a ball that is set
// on it with v and no spin ends by rolling with 5/7 v.
static void roll_in_lift(hard_report *r, family_worst *rolls, double lifting,
                         double along, double speed, double step)
{
    const double mu = 0.5, a = 0.25;
    tumble_options o = family_options(step, mu);
    tumble_world *w = tumble_world_make(&o);
    tumble_quat level = { 0, 0, 0, 1 };
    tumble_body floor = add_plate(w, 40, level);
    tumble_vec3 moves = { along, lifting, 0 }, still = { 0, 0, 0 };
    tumble_body_set_velocity(w, floor, moves, still);
    tumble_body_options b = tumble_body_at(0, a, 0);
    b.velocity = v_add(moves, tumble_v(0, 0, speed));
    tumble_body ball = tumble_body_add(w, tumble_shape_sphere(w, a, 1), b);
    family_run(w, 4 * speed / (7 * mu * FAMILY_G) + 10 * step);
    double now = tumble_body_velocity(w, ball).z;
    family_trial(rolls, fabs(now / speed * 7 / 5 - 1), "%g m/s up, %g along, "
                 "ball at %g m/s, dt 1/%.0f", lifting, along, speed, 1 / step);
    family_ok(r, w);
    tumble_world_free(w);
}

static void ball_in_lift(hard_report *r, int fast)
{
    static const double lifting[] = { 1, 0, -1, 0.1, 10, -10, 100 };
    static const double along[] = { 0, 1, 30 }, speed[] = { 2, 8 };
    family_worst rolls = { .target = 0.01 };
    for (int k = 0; k < (fast ? 2 : 7); k++)
        for (int i = 0; i < 3; i++)
            for (int v = 0; v < 2; v++)
                for (int n = 0; n < (fast ? 1 : STEPS); n++)
                    roll_in_lift(r, &rolls, lifting[k], along[i], speed[v],
                                 dt[n]);
    family_add(r, &rolls, "", "speed of a ball that rolls, from 5/7 v");
}

const hard_case family_ground[] = {
    { 115, "creep on a turntable", 1, turntable },
    { 116, "creep on a plate on a circle", 1, circling },
    { 117, "creep in a lift with a slope", 1, lift },
    { 118, "boarding a moving belt", 1, boarding },
    { 119, "a ball in a lift", 1, ball_in_lift },
    { 0, NULL, 0, NULL }
};
