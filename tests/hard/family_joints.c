// family_joints.c - rows 159 to 169: joints.
//
// Gaps are taken from poses: where does each of two bodies hold the point at
// which they were joined?  Energies are made of poses, velocities and spins,
// with each body's own inertia: tumble_world_measure's are a part of a substep
// behind where joints pull, which row 164 measures.

#include "family.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>

static const double STEPS[] = { 1.0 / 60, 1.0 / 240, 1.0 / 30 };
static const tumble_vec3 UP = { 0, 1, 0 };

// ---- Points that bodies hold -----------------------------------------------

// A point of a body, or of the world where the body is the ground.
typedef struct {
    tumble_body body;
    tumble_vec3 local;
} held;

static tumble_vec3 turn_back(tumble_quat q, tumble_vec3 a)
{
    return v_turn((tumble_quat){ -q.x, -q.y, -q.z, q.w }, a);
}

static held hold(const tumble_world *w, tumble_body b, tumble_vec3 at)
{
    held h = { b, at };
    tumble_pose p = tumble_body_pose(w, b);
    if (tumble_body_exists(w, b))
        h.local = turn_back(p.rotation, v_sub(at, p.position));
    return h;
}

static tumble_vec3 where_held(const tumble_world *w, held h)
{
    if (!tumble_body_exists(w, h.body)) return h.local;
    tumble_pose p = tumble_body_pose(w, h.body);
    return v_add(p.position, v_turn(p.rotation, h.local));
}

// Joints, and for each the two points that are one.
// The bodies, and of each the inertia about the axes of its shape (kg m^2).
enum { MOST_JOINTS = 96 };
typedef struct {
    int  count, bodies;
    held a[MOST_JOINTS], b[MOST_JOINTS];
    tumble_joint joint[MOST_JOINTS];
    tumble_body body[MOST_JOINTS];
    tumble_vec3 inertia[MOST_JOINTS];
} linkage;

static tumble_body weigh(linkage *l, tumble_body b, tumble_vec3 inertia)
{
    l->body[l->bodies] = b;
    l->inertia[l->bodies++] = inertia;
    return b;
}

static tumble_vec3 box_inertia(tumble_vec3 s, double mass)
{
    return v_scale(mass / 12, tumble_v(s.y * s.y + s.z * s.z,
                                       s.z * s.z + s.x * s.x,
                                       s.x * s.x + s.y * s.y));
}

static tumble_vec3 prism_inertia(int corners, double radius, double height,
                                 double mass)
{
    double along = mass * radius * radius / 6
                 * (2 + cos(2 * FAMILY_PI / corners));
    double across = along / 2 + mass * height * height / 12;
    return tumble_v(across, along, across);
}

static double kinetic(const tumble_world *w, const linkage *l)
{
    double sum = 0;
    for (int k = 0; k < l->bodies; k++) {
        tumble_vec3 v = tumble_body_velocity(w, l->body[k]), i = l->inertia[k];
        tumble_quat q = tumble_body_pose(w, l->body[k]).rotation;
        tumble_vec3 spin = turn_back(q, tumble_body_spin(w, l->body[k]));
        sum += tumble_body_mass(w, l->body[k]) * v_dot(v, v) / 2
             + (i.x * spin.x * spin.x + i.y * spin.y * spin.y
                + i.z * spin.z * spin.z) / 2;
    }
    return sum;
}

static double potential(const tumble_world *w, const linkage *l)
{
    double sum = 0;
    for (int k = 0; k < l->bodies; k++)
        sum += tumble_body_mass(w, l->body[k]) * FAMILY_G
             * tumble_body_position(w, l->body[k]).y;
    return sum;
}

static void keep_joint(tumble_world *w, linkage *l, tumble_joint j,
                       tumble_body a, tumble_body b, tumble_vec3 at)
{
    if (l->count == MOST_JOINTS) return;
    l->joint[l->count] = j;
    l->a[l->count] = hold(w, a, at);
    l->b[l->count++] = hold(w, b, at);
}

static void join(tumble_world *w, linkage *l, tumble_body a, tumble_body b,
                 tumble_vec3 at)
{
    keep_joint(w, l, tumble_joint_ball(w, a, b, at), a, b, at);
}

static void hinge(tumble_world *w, linkage *l, tumble_body a, tumble_body b,
                  tumble_vec3 at, tumble_vec3 axis)
{
    keep_joint(w, l, tumble_joint_hinge(w, a, b, at, axis), a, b, at);
}

// m, the widest of all joints.
static double widest(const tumble_world *w, const linkage *l)
{
    double gap = 0;
    for (int k = 0; k < l->count; k++)
        gap = hard_worse(gap, v_distance(where_held(w, l->a[k]),
                                         where_held(w, l->b[k])));
    return gap;
}

// What a run of so many seconds shows, at the end of every step.
typedef struct {
    double gap;         // m
    double off;         // J, the largest |energy - what it was|
    double gain;        // J, the largest rise above an earlier energy
    double belied;      // J, the largest |energy of tumble_world_measure - true|
} course;

// What is off by its whole energy (J) is lost, and is not followed further:
// such a step may take minutes.
static course follow(tumble_world *w, const linkage *l, double dt,
                     double seconds, double whole)
{
    course c = { 0, 0, 0, 0 };
    // In a world without gravity it measures no potential energy.
    int falls = fabs(tumble_world_measure(w).potential) > 0;
    double start = kinetic(w, l) + falls * potential(w, l), least = start;
    for (int n = (int)(seconds / dt + 0.5); n > 0; n--) {
        tumble_world_step(w);
        double now = kinetic(w, l) + falls * potential(w, l);
        c.belied = hard_worse(c.belied, fabs(now - family_energy(w)));
        c.gap = hard_worse(c.gap, widest(w, l));
        c.off = hard_worse(c.off, fabs(now - start));
        c.gain = hard_worse(c.gain, now - least);
        if (now < least) least = now;
        if (!(c.off <= whole)) break;
    }
    return c;
}

static tumble_world *begin(double dt)
{
    tumble_options o = family_options(dt, 0.5);
    return tumble_world_make(&o);
}

// ---- 160, 161: tops --------------------------------------------------------

typedef enum { DISK, PLATE, ROD, BRICK, TOPS } top_kind;
static const char *const TOP_NAME[] = { "disk", "plate", "rod", "brick" };

// A body of 1 kg that spins about its y.
static tumble_shape top_shape(tumble_world *w, top_kind kind, double size,
                              tumble_vec3 *inertia)
{
    double r = size, h = 0.2 * r;
    if (kind == DISK) {
        *inertia = prism_inertia(24, r, h, 1);
        return family_prism(w, 24, r, h, 1);
    }
    tumble_vec3 s = kind == PLATE ? tumble_v(1.6 * r, h, 1.6 * r)
                  : kind == ROD ? tumble_v(0.4 * r, 2 * r, 0.4 * r)
                  : tumble_v(1.8 * r, 0.3 * r, r);
    *inertia = box_inertia(s, 1);
    return tumble_shape_box(w, s, 1);
}

typedef struct {
    tumble_world *w;
    tumble_body body;
    linkage joints;
    tumble_vec3 pivot;
    double arm;         // m, from the pivot to the centre of mass
} top;

// Its axis leans by `lean` from the vertical, towards x; it turns with `spin`
// about its axis and goes round the vertical with `round`.
static top top_begin(tumble_world *w, tumble_shape shape, tumble_vec3 inertia,
                     double size, double lean, double spin, double round)
{
    top t = { .w = w, .pivot = tumble_v(0, 0, 0), .arm = size };
    tumble_vec3 axis = tumble_v(sin(lean), cos(lean), 0);
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.pose.position = v_scale(t.arm, axis);
    o.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1), -lean);
    tumble_vec3 across = v_sub(UP, v_scale(cos(lean), axis));
    o.spin = v_add(v_scale(spin, axis), v_scale(round, across));
    o.velocity = v_cross(o.spin, o.pose.position);
    t.body = weigh(&t.joints, tumble_body_add(w, shape, o), inertia);
    join(w, &t.joints, tumble_body_ground(), t.body, t.pivot);
    return t;
}

static double spin_along(const top *t)
{
    tumble_quat q = tumble_body_pose(t->w, t->body).rotation;
    return v_dot(tumble_body_spin(t->w, t->body), v_turn(q, UP));
}

static const double SPINS[] = { 1, 3, 10, 30, 100, 300, 500 };
static const double TOP_SIZES[] = { 0.2, 0.03, 1 };

// A top keeps its energy, and, where it is symmetric, its spin about its axis:
// nothing turns it about that.
static void tops(hard_report *r, int fast)
{
    family_worst energy = { .target = 1e-3 }, gap = { .target = 1e-4 },
                 spin = { .target = 1e-3 };
    for (int k = 0; k < (fast ? 7 : 7 * 3 * TOPS); k++) {
        double w3 = SPINS[k % 7], dt = STEPS[k / 7 % 3];
        top_kind kind = (top_kind)(k / 21);
        double size = TOP_SIZES[(k + k / 7 + k / 21) % 3];
        tumble_world *w = begin(dt);
        tumble_vec3 inertia;
        tumble_shape s = top_shape(w, kind, size, &inertia);
        top t = top_begin(w, s, inertia, size, FAMILY_PI / 3, w3, 0);
        if (family_ok(r, w)) {
            double whole = kinetic(w, &t.joints) + FAMILY_G * t.arm;
            course c = follow(w, &t.joints, dt, fast ? 2 : 10, whole);
            char at[80];
            snprintf(at, sizeof at, "%s of %g m, %g rad/s, dt 1/%.0f",
                     TOP_NAME[kind], size, w3, 1 / dt);
            family_trial(&energy, c.off / whole, "%s", at);
            family_trial(&gap, c.gap / size, "%s", at);
            if (kind != BRICK)
                family_trial(&spin, fabs(spin_along(&t) - w3)
                             / (w3 + sqrt(FAMILY_G / size)), "%s", at);
        }
        tumble_world_free(w);
    }
    family_add(r, &energy, "", "energy of a top that is let go, of its own");
    family_add(r, &gap, "", "gap at its point, of its size");
    family_add(r, &spin, "", "spin about its axis, of all that turns");
}

// How far has it gone round after so many seconds, and by how much did it lean
// otherwise than at first?
static double go_round(const top *t, double dt, double seconds, double lean,
                       double *nod)
{
    double way = 0, last = 0;
    *nod = 0;
    for (int n = (int)(seconds / dt + 0.5); n > 0; n--) {
        tumble_world_step(t->w);
        tumble_vec3 x = tumble_body_position(t->w, t->body);
        double now = atan2(-x.z, x.x);
        way += remainder(now - last, 2 * FAMILY_PI);
        last = now;
        double tilt = atan2(sqrt(x.x * x.x + x.z * x.z), x.y);
        *nod = hard_worse(*nod, fabs(tilt - lean));
    }
    return way;
}

// With the inertia I3 about its axis and I1 across it at its point, a top that
// leans by a and turns with w about its axis goes round steadily with W where
//     I1 cos(a) W^2 - I3 w W + m g l = 0.
static void precession(hard_report *r, int fast)
{
    static const double leans[] = { 60, 20, 85 }, times[] = { 1.5, 4, 12 };
    family_worst rate = { .target = 1e-3 }, nods = { .target = 1e-3 };
    for (int k = 0; k < (fast ? 3 : 81); k++) {
        double dt = STEPS[k / 3 % 3], lean = leans[k / 9 % 3] * FAMILY_PI / 180;
        double size = TOP_SIZES[k % 3], nod;
        top_kind kind = (top_kind)(k / 27);
        tumble_world *w = begin(dt);
        tumble_vec3 inertia;
        tumble_shape s = top_shape(w, kind, size, &inertia);
        double along = inertia.y;
        double a = (inertia.x + size * size) * cos(lean), c = FAMILY_G * size;
        double spin = times[(k + k / 9) % 3] * 2 * sqrt(a * c) / along;
        // Beyond what is asked of tops.
        if (spin > 500) spin = 500;
        double b = along * spin, root = b * b - 4 * a * c;
        double round = root > 0 ? (b - sqrt(root)) / (2 * a) : 0;
        top t = top_begin(w, s, inertia, size, lean, spin, round);
        if (round > 0 && family_ok(r, w)) {
            double seconds = fast ? 2 : 10;
            double way = go_round(&t, dt, seconds, lean, &nod);
            char at[80];
            snprintf(at, sizeof at, "%s of %g m, %.3g rad/s, lean %.0f deg, dt "
                     "1/%.0f", TOP_NAME[kind], size, spin,
                     lean * 180 / FAMILY_PI, 1 / dt);
            family_trial(&rate, fabs(way / (round * seconds) - 1), "%s", at);
            family_trial(&nods, nod, "%s", at);
        }
        tumble_world_free(w);
    }
    family_add(r, &rate, "", "rate of a steady precession, of itself");
    family_add(r, &nods, "rad", "lean in it");
}

// ---- 162: flywheels --------------------------------------------------------

typedef enum { ALONG, ACROSS, IN_PLANE, NAILED, WHEELS } wheel_kind;
static const char *const WHEEL_NAME[] = {
    "along its arm", "across its arm", "in its arm's plane", "on the ground"
};

// A wheel on a hinge at the end of an arm of twice its radius, which hangs on a
// ball, or on a hinge in its plane; or a wheel on the ground.
static tumble_body wheel_begin(tumble_world *w, wheel_kind kind, double size,
                               double spin, linkage *l)
{
    tumble_vec3 axis = kind == ALONG ? tumble_v(1, 0, 0) : tumble_v(0, 0, 1);
    tumble_vec3 across = kind == ALONG ? tumble_v(0, 0, -1) : tumble_v(1, 0, 0);
    tumble_body_options o = tumble_body_at(2 * size, 0, 0);
    o.pose.rotation = tumble_quat_turn(across, FAMILY_PI / 2);
    o.spin = v_scale(spin, axis);
    tumble_shape disk = family_prism(w, 16, size, size / 4, 1);
    tumble_body wheel = tumble_body_add(w, disk, o);
    weigh(l, wheel, prism_inertia(16, size, size / 4, 1));
    tumble_vec3 middle = tumble_v(2 * size, 0, 0);
    tumble_body arm = tumble_body_ground();
    if (kind != NAILED) {
        tumble_vec3 sides = tumble_v(2 * size, 0.2 * size, 0.2 * size);
        arm = tumble_body_add(w, tumble_shape_box(w, sides, 0.5),
                              tumble_body_at(size, 0, 0));
        weigh(l, arm, box_inertia(sides, 0.5));
        tumble_vec3 pivot = tumble_v(0, 0, 0);
        if (kind == IN_PLANE)
            hinge(w, l, tumble_body_ground(), arm, pivot, axis);
        else join(w, l, tumble_body_ground(), arm, pivot);
    }
    hinge(w, l, arm, wheel, middle, axis);
    return wheel;
}

static void flywheels(hard_report *r, int fast)
{
    family_worst energy = { .target = 1e-3 }, gap = { .target = 1e-4 };
    for (int k = 0; k < (fast ? 4 : 7 * 3 * WHEELS); k++) {
        wheel_kind kind = (wheel_kind)(k % WHEELS);
        double spin = SPINS[fast ? 1 : k / WHEELS % 7];
        double dt = STEPS[k / WHEELS / 7];
        double size = TOP_SIZES[(k + k / 7) % 3];
        tumble_world *w = begin(dt);
        linkage l = { 0 };
        wheel_begin(w, kind, size, spin, &l);
        if (family_ok(r, w)) {
            double whole = kinetic(w, &l) + 2 * FAMILY_G * size;
            course c = follow(w, &l, dt, fast ? 2 : 10, whole);
            char at[80];
            snprintf(at, sizeof at, "%s, %g m, %g rad/s, dt 1/%.0f",
                     WHEEL_NAME[kind], size, spin, 1 / dt);
            family_trial(&energy, c.off / whole, "%s", at);
            family_trial(&gap, c.gap / size, "%s", at);
        }
        tumble_world_free(w);
    }
    family_add(r, &energy, "", "energy of a flywheel and its arm, of its own");
    family_add(r, &gap, "", "gap of its joints, of its size");
}

// ---- 163: pendulums --------------------------------------------------------

// The mean of Gauss: of two numbers take both means, again and again.
static double mean_of_gauss(double a, double b)
{
    for (int k = 0; k < 60; k++) {
        double mean = (a + b) / 2;
        b = sqrt(a * b);
        a = mean;
    }
    return a;
}

// s, from the first time that it passes the lowest point to the last of
// `swings` whole ones later; NaN if that takes more than `most`.
static double time_swings(tumble_world *w, tumble_body b, double dt, int swings,
                          double most)
{
    double first = 0, last = 0;
    int passed = -1;
    for (double t = dt; t < most; t += dt) {
        tumble_world_step(w);
        tumble_vec3 x = tumble_body_position(w, b);
        double now = atan2(x.x, -x.y);
        if ((last < 0) != (now < 0) && fabs(now - last) < FAMILY_PI) {
            double at = t - dt * now / (now - last);
            if (++passed == 0) first = at;
            if (passed == 2 * swings) return at - first;
        }
        last = now;
    }
    return NAN;
}

// A thin rod that is let go at an angle A swings with the period
//     2 pi sqrt(I / (m g l)) / M(1, cos(A / 2)),    M: the mean of Gauss.
static void swing(hard_report *r, family_worst *period, double length,
                  double degrees, double dt, int is_hinge, int swings)
{
    double angle = degrees * FAMILY_PI / 180, thick = length / 20;
    tumble_world *w = begin(dt);
    linkage l = { 0 };
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.pose.position = v_scale(length / 2, tumble_v(sin(angle), -cos(angle), 0));
    o.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1), angle);
    tumble_shape thin = tumble_shape_box(w, tumble_v(thick, length, thick), 1);
    tumble_body rod = tumble_body_add(w, thin, o);
    tumble_vec3 pivot = { 0, 0, 0 };
    if (is_hinge)
        hinge(w, &l, tumble_body_ground(), rod, pivot, tumble_v(0, 0, 1));
    else join(w, &l, tumble_body_ground(), rod, pivot);
    double inertia = length * length / 3 + thick * thick / 12;
    double truth = 2 * FAMILY_PI * sqrt(inertia / (FAMILY_G * length / 2))
                 / mean_of_gauss(1, cos(angle / 2));
    if (family_ok(r, w)) {
        double took = time_swings(w, rod, dt, swings, (swings + 2) * 2 * truth);
        family_trial(period, fabs(took / (swings * truth) - 1),
                     "%s, %g m, %g deg, dt 1/%.0f", is_hinge ? "hinge" : "ball",
                     length, degrees, 1 / dt);
    }
    tumble_world_free(w);
}

// A ball at a distance L from a point goes round under it, at an angle A from
// the vertical, with sqrt(g / (L cos A)).
static void cone(hard_report *r, family_worst *rate, double length,
                 double degrees, double dt, double rounds)
{
    double angle = degrees * FAMILY_PI / 180;
    double truth = sqrt(FAMILY_G / (length * cos(angle))), way = 0, last = 0;
    tumble_world *w = begin(dt);
    tumble_body_options o = tumble_body_at(length * sin(angle),
                                           -length * cos(angle), 0);
    o.velocity = v_cross(v_scale(truth, UP), o.pose.position);
    tumble_body b = tumble_body_add(w, tumble_shape_sphere(w, length / 20, 1),
                                    o);
    tumble_joint_distance(w, tumble_body_ground(), tumble_v(0, 0, 0), b,
                          o.pose.position, length, length);
    int steps = (int)(rounds * 2 * FAMILY_PI / truth / dt + 0.5);
    for (int n = 0; n < steps; n++) {
        tumble_world_step(w);
        tumble_vec3 x = tumble_body_position(w, b);
        double now = atan2(-x.z, x.x);
        way += remainder(now - last, 2 * FAMILY_PI);
        last = now;
    }
    if (family_ok(r, w))
        family_trial(rate, fabs(way / (truth * steps * dt) - 1),
                     "%g m, %g deg, dt 1/%.0f", length, degrees, 1 / dt);
    tumble_world_free(w);
}

static void pendulums(hard_report *r, int fast)
{
    static const double lengths[] = { 0.02, 0.1, 1, 10 },
                        angles[] = { 170, 5, 45, 90, 150 },
                        leans[] = { 80, 5, 45 };
    family_worst period = { .target = 1e-3 }, rate = { .target = 1e-3 };
    for (int k = 0; k < (fast ? 2 : 40); k++)
        for (int i = 0; i < (fast ? 1 : 3); i++)
            swing(r, &period, lengths[k / 2 % 4], angles[k / 8], STEPS[i],
                  k % 2, fast ? 2 : 8);
    for (int k = 0; k < (fast ? 1 : 12); k++)
        for (int i = 0; i < (fast ? 1 : 3); i++)
            cone(r, &rate, lengths[k % 4], leans[k / 4], STEPS[i],
                 fast ? 2 : 10);
    family_add(r, &period, "", "period of a pendulum, of itself");
    family_add(r, &rate, "", "rate of a conical pendulum, of itself");
}

// ---- 164: double pendulums -------------------------------------------------

// Angles from straight down (rad), and their rates.
typedef struct {
    double a, b, da, db;
} two_rods;

// Lagrange's equations of two rods of length L and 1 kg, with an inertia I
// about their middles.
static two_rods two_rods_rate(two_rods s, double length, double inertia)
{
    double half = length / 2, c = cos(s.a - s.b), sn = sin(s.a - s.b);
    double m11 = inertia + half * half + length * length;
    double m12 = length * half * c, m22 = inertia + half * half;
    double f1 = -length * half * sn * s.db * s.db
              - (half + length) * FAMILY_G * sin(s.a);
    double f2 = length * half * sn * s.da * s.da
              - half * FAMILY_G * sin(s.b);
    double det = m11 * m22 - m12 * m12;
    return (two_rods){ s.da, s.db, (f1 * m22 - f2 * m12) / det,
                       (f2 * m11 - f1 * m12) / det };
}

static two_rods two_rods_add(two_rods s, double h, two_rods d)
{
    return (two_rods){ s.a + h * d.a, s.b + h * d.b, s.da + h * d.da,
                       s.db + h * d.db };
}

// Runge and Kutta's fourth order, in so many steps.
static two_rods two_rods_truth(two_rods s, double length, double inertia,
                               double seconds, int steps)
{
    double h = seconds / steps;
    for (int n = 0; n < steps; n++) {
        two_rods k1 = two_rods_rate(s, length, inertia), k2, k3, k4;
        k2 = two_rods_rate(two_rods_add(s, h / 2, k1), length, inertia);
        k3 = two_rods_rate(two_rods_add(s, h / 2, k2), length, inertia);
        k4 = two_rods_rate(two_rods_add(s, h, k3), length, inertia);
        s = two_rods_add(s, h / 6, k1);
        s = two_rods_add(s, h / 3, k2);
        s = two_rods_add(s, h / 3, k3);
        s = two_rods_add(s, h / 6, k4);
    }
    return s;
}

static tumble_vec3 along_rod(double angle, double length)
{
    return tumble_v(length * sin(angle), -length * cos(angle), 0);
}

static tumble_body add_rod(tumble_world *w, linkage *l, double length,
                           tumble_vec3 from, double angle)
{
    tumble_body_options o = tumble_body_at(0, 0, 0);
    tumble_vec3 sides = { length / 20, length, length / 20 };
    o.pose.position = v_add(from, along_rod(angle, length / 2));
    o.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1), angle);
    return weigh(l, tumble_body_add(w, tumble_shape_box(w, sides, 1), o),
                 box_inertia(sides, 1));
}

// Its end is compared after the time in which such a rod falls some five
// lengths, before chaos has its way; its energy is followed on.
static void swing_double(hard_report *r, family_worst *place,
                         family_worst *energy, family_worst *said,
                         double length, double a, double b, double dt,
                         double seconds)
{
    const tumble_vec3 across = { 0, 0, 1 }, pivot = { 0, 0, 0 };
    tumble_world *w = begin(dt);
    linkage l = { 0 };
    tumble_vec3 knee = along_rod(a, length);
    tumble_body first = add_rod(w, &l, length, pivot, a);
    tumble_body second = add_rod(w, &l, length, knee, b);
    hinge(w, &l, tumble_body_ground(), first, pivot, across);
    hinge(w, &l, first, second, knee, across);
    held end = hold(w, second, v_add(knee, along_rod(b, length)));
    int steps = (int)(sqrt(length) / dt + 0.5);
    double inertia = length * length * (1 + 1.0 / 400) / 12;
    two_rods t = two_rods_truth((two_rods){ a, b, 0, 0 }, length, inertia,
                                steps * dt, 20000);
    tumble_vec3 truth = v_add(along_rod(t.a, length), along_rod(t.b, length));
    for (int n = 0; n < steps; n++) tumble_world_step(w);
    if (family_ok(r, w)) {
        char at[80];
        snprintf(at, sizeof at, "%g m, from %.0f and %.0f deg, dt 1/%.0f",
                 length, a * 180 / FAMILY_PI, b * 180 / FAMILY_PI, 1 / dt);
        family_trial(place, v_distance(where_held(w, end), truth) / length,
                     "%s", at);
        double whole = 2 * FAMILY_G * length;
        course c = follow(w, &l, dt, seconds, whole);
        family_trial(energy, c.off / whole, "%s", at);
        family_trial(said, c.belied / whole, "%s", at);
    }
    tumble_world_free(w);
}

static void double_pendulums(hard_report *r, int fast)
{
    static const double lengths[] = { 1, 0.1, 10 };
    static const double starts[][2] = {
        { 90, 90 }, { 120, -30 }, { 170, 175 }
    };
    family_worst place = { .target = 1e-2 }, energy = { .target = 1e-3 },
                 said = { .target = 1e-3 };
    for (int k = 0; k < (fast ? 1 : 27); k++) {
        double degree = FAMILY_PI / 180;
        swing_double(r, &place, &energy, &said, lengths[k % 3],
                     starts[k / 3 % 3][0] * degree,
                     starts[k / 3 % 3][1] * degree, STEPS[k / 9],
                     fast ? 2 : 10);
    }
    family_add(r, &place, "", "end of a double pendulum, of its length");
    family_add(r, &energy, "", "energy of a double pendulum, of its scale");
    family_add(r, &said, "",
               "what tumble_world_measure says of it, of its scale");
}

// ---- 165: limits of hinges -------------------------------------------------

// A rod that turns about an upright hinge, or falls on a level one, to a limit
// of half a radian.  How far past it does the rod come, and what does it gain?
static void meet_limit(hard_report *r, family_worst *past, family_worst *gain,
                       int is_level, double size, double spin, double dt,
                       double seconds)
{
    tumble_vec3 axis = is_level ? tumble_v(0, 0, 1) : UP;
    tumble_world *w = begin(dt);
    linkage l = { 0 };
    tumble_body_options o = tumble_body_at(size / 2, 0, 0);
    o.spin = v_scale(is_level ? -spin : spin, axis);
    o.velocity = v_cross(o.spin, o.pose.position);
    tumble_vec3 sides = { size, size / 10, size / 10 };
    tumble_body rod =
        weigh(&l, tumble_body_add(w, tumble_shape_box(w, sides, 1), o),
              box_inertia(sides, 1));
    hinge(w, &l, tumble_body_ground(), rod, tumble_v(0, 0, 0), axis);
    tumble_joint_set_limits(w, l.joint[0], -0.5, 0.5);
    double least = kinetic(w, &l) + potential(w, &l), beyond = 0, most = 0;
    double whole = kinetic(w, &l) + FAMILY_G * size;
    for (int n = (int)(seconds / dt + 0.5); n > 0; n--) {
        tumble_world_step(w);
        tumble_vec3 x = tumble_body_position(w, rod);
        double now = kinetic(w, &l) + potential(w, &l);
        double turned = is_level ? atan2(x.y, x.x) : atan2(-x.z, x.x);
        beyond = hard_worse(beyond, fabs(turned) - 0.5);
        most = hard_worse(most, now - least);
        if (now < least) least = now;
    }
    if (family_ok(r, w)) {
        char at[80];
        snprintf(at, sizeof at, "%s, %g m, %g rad/s, dt 1/%.0f",
                 is_level ? "falls" : "turns", size, spin, 1 / dt);
        family_trial(past, beyond, "%s", at);
        family_trial(gain, most / whole, "%s", at);
    }
    tumble_world_free(w);
}

static void limits(hard_report *r, int fast)
{
    family_worst past = { .target = 1e-3 }, gain = { .target = 1e-3 };
    for (int k = 0; k < (fast ? 7 : 7 * 3 * 3 * 2); k++)
        meet_limit(r, &past, &gain, k / 63, TOP_SIZES[k / 21 % 3], SPINS[k % 7],
                   STEPS[k / 7 % 3], 2);
    family_add(r, &past, "rad", "way past a limit");
    family_add(r, &gain, "", "energy gained at a limit, of its own");
}

// ---- 166, 167: chains ------------------------------------------------------

static const double LINK = 0.2;         // m, of a link
static const tumble_vec3 LINK_SIDES = { 0.2, 0.04, 0.08 };

// A link of a chain from one point to another, which is joined to the body
// before it.
static tumble_body add_link(tumble_world *w, linkage *l, tumble_shape s,
                            tumble_body before, tumble_vec3 from,
                            tumble_vec3 way)
{
    double length = v_length(way);
    tumble_vec3 middle = v_add(from, v_scale(0.5, way));
    tumble_body_options o = tumble_body_at(middle.x, middle.y, middle.z);
    tumble_vec3 axis = v_cross(tumble_v(1, 0, 0), way);
    if (v_length(axis) > 1e-9 * length)
        o.pose.rotation = tumble_quat_turn(axis, acos(way.x / length));
    else if (way.x < 0) o.pose.rotation = tumble_quat_turn(UP, FAMILY_PI);
    // All links have 1 kg.
    tumble_body b = weigh(l, tumble_body_add(w, s, o),
                          box_inertia(LINK_SIDES, 1));
    join(w, l, before, b, from);
    return b;
}


// n links of 1 kg from a point of the world, all in one direction.
static tumble_body add_chain(tumble_world *w, linkage *l, int n,
                             tumble_vec3 from, tumble_vec3 direction)
{
    tumble_shape s = tumble_shape_box(w, LINK_SIDES, 1);
    tumble_body last = tumble_body_ground();
    tumble_vec3 way = v_scale(LINK, direction);
    for (int i = 0; i < n; i++, from = v_add(from, way))
        last = add_link(w, l, s, last, from, way);
    return last;
}

static tumble_body add_ball(tumble_world *w, linkage *l, double radius,
                            double mass, tumble_vec3 at, tumble_vec3 velocity)
{
    double inertia = 0.4 * mass * radius * radius;
    tumble_body_options o = tumble_body_at(at.x, at.y, at.z);
    o.velocity = velocity;
    return weigh(l, tumble_body_add(w, tumble_shape_sphere(w, radius, mass), o),
                 tumble_v(inertia, inertia, inertia));
}

typedef enum { DROPPED, SLACK, CAUGHT, LOADS } load_kind;
static const char *const LOAD_NAME[] = {
    "dropped on a bridge", "falls on a slack chain", "hung on while it moves"
};

// A bridge of ten links that hangs between two points, and a weight that falls
// on it; a chain that goes down and up again, and a weight at its other end,
// beside its point; a chain that hangs, and a weight that comes by when it is
// joined to it.
static void load_begin(tumble_world *w, linkage *l, load_kind kind, double mass,
                       double height)
{
    tumble_vec3 down = tumble_v(0, -1, 0), o = { 0, 0, 0 };
    if (kind == DROPPED) {
        tumble_vec3 way = tumble_v(0.8 * LINK, -0.6 * LINK, 0), at = o;
        tumble_body last = tumble_body_ground();
        tumble_shape s = tumble_shape_box(w, LINK_SIDES, 1);
        for (int i = 0; i < 10; i++) {
            if (i == 5) way.y = -way.y;
            last = add_link(w, l, s, last, at, way);
            at = v_add(at, way);
        }
        join(w, l, last, tumble_body_ground(), at);
        at = tumble_v(4 * LINK, height - 2.3 * LINK, 0);
        add_ball(w, l, 0.1, mass, at, o);
    } else if (kind == SLACK) {
        tumble_body last = add_chain(w, l, 5, o, down);
        tumble_vec3 at = v_scale(5 * LINK, down);
        tumble_shape s = tumble_shape_box(w, LINK_SIDES, 1);
        last = add_link(w, l, s, last, at, tumble_v(LINK, 0, 0));
        at.x = LINK;
        for (int i = 0; i < 5; i++, at.y += LINK)
            last = add_link(w, l, s, last, at, tumble_v(0, LINK, 0));
        tumble_body ball = add_ball(w, l, 0.08, mass, tumble_v(LINK, 0.1, 0),
                                    tumble_v(0, -sqrt(2 * FAMILY_G * height),
                                             0));
        join(w, l, last, ball, at);
    } else {
        tumble_body last = add_chain(w, l, 5, o, down);
        for (int n = 0; n < 10; n++) tumble_world_step(w);
        tumble_vec3 at = v_scale(5 * LINK, down);
        tumble_body ball = add_ball(w, l, 0.1, mass, tumble_v(0, at.y - 0.1, 0),
                                    tumble_v(0, 0, sqrt(2 * FAMILY_G
                                                        * height)));
        join(w, l, last, ball, at);
    }
}

// Impacts without restitution take energy, and never give any.
static void sudden_loads(hard_report *r, int fast)
{
    static const double ratios[] = { 1, 10, 100, 1000 },
                        heights[] = { 1, 0.1, 10 };
    family_worst gap = { .target = 1e-3 }, gain = { .target = 1e-3 };
    for (int k = 0; k < (fast ? LOADS : LOADS * 4 * 3 * 2); k++) {
        load_kind kind = (load_kind)(k % LOADS);
        double mass = ratios[fast ? 1 : k / LOADS % 4];
        double height = heights[k / LOADS / 4 % 3];
        double dt = STEPS[k / LOADS / 12];
        tumble_world *w = begin(dt);
        linkage l = { 0 };
        load_begin(w, &l, kind, mass, height);
        double whole = (mass + 10) * FAMILY_G * (height + 1);
        course c = follow(w, &l, dt, fast ? 1 : 3, 10 * whole);
        if (family_ok(r, w)) {
            char at[80];
            snprintf(at, sizeof at, "%g times a link, from %g m, %s, dt 1/%.0f",
                     mass, height, LOAD_NAME[kind], 1 / dt);
            family_trial(&gap, c.gap / LINK, "%s", at);
            family_trial(&gain, c.gain / whole, "%s", at);
        }
        tumble_world_free(w);
    }
    family_add(r, &gap, "", "gap under a sudden load, of a link");
    family_add(r, &gain, "", "energy gained from it, of what fell");
}

// Hung straight, its first joint bears the weight of all.  Let go level, it
// swings and whips.
static void heavy_chain(hard_report *r, family_worst *gap, family_worst *force,
                        int n, double mass, int swings, double seconds)
{
    double dt = STEPS[0];
    tumble_world *w = begin(dt);
    linkage l = { 0 };
    tumble_vec3 way = swings ? tumble_v(1, 0, 0) : tumble_v(0, -1, 0);
    tumble_body last = add_chain(w, &l, n, tumble_v(0, 0, 0), way);
    tumble_vec3 end = v_scale(n * LINK, way);
    tumble_body ball = add_ball(w, &l, LINK, mass,
                                v_add(end, v_scale(LINK, way)),
                                tumble_v(0, 0, 0));
    join(w, &l, last, ball, end);
    course c = follow(w, &l, dt, seconds, HUGE_VAL);
    if (family_ok(r, w)) {
        double weight = (n + mass) * FAMILY_G;
        double bore = tumble_joint_force(w, l.joint[0]);
        family_trial(gap, c.gap / LINK, "%d links, %g times a link, %s", n,
                     mass, swings ? "swings" : "hangs");
        if (!swings)
            family_trial(force, fabs(bore / weight - 1),
                         "%d links, %g times a link", n, mass);
    }
    tumble_world_free(w);
}

static void heavy_chains(hard_report *r, int fast)
{
    static const int links[] = { 5, 2, 10, 20, 50 };
    static const double ratios[] = { 100, 1, 10, 1000, 10000 };
    family_worst gap = { .target = 1e-4 }, force = { .target = 1e-3 };
    for (int k = 0; k < (fast ? 2 : 50); k++)
        heavy_chain(r, &gap, &force, links[k / 10], ratios[k / 2 % 5], k % 2,
                    fast ? 1 : 3);
    family_add(r, &gap, "", "gap of a chain under a weight, of a link");
    family_add(r, &force, "", "force in its first joint, of all weight");
}

// ---- 159: rings ------------------------------------------------------------

// A closed chain of n links of this length that hangs from one of its joints.
static void hang_ring(tumble_world *w, linkage *l, int n, double length)
{
    tumble_vec3 sides = tumble_v(0.9 * length, 0.2 * length, 0.2 * length);
    tumble_shape s = tumble_shape_box(w, sides, 1);
    double out = n * length / (2 * FAMILY_PI);
    for (int k = 0; k < n; k++) {
        double turn = 2 * FAMILY_PI * k / n;
        tumble_body_options o = tumble_body_at(out * sin(turn), out * cos(turn), 0);
        o.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1), -turn);
        tumble_body b = weigh(l, tumble_body_add(w, s, o), box_inertia(sides, 1));
        turn -= FAMILY_PI / n;
        tumble_vec3 at = tumble_v(out * sin(turn), out * cos(turn), 0);
        if (k > 0) join(w, l, l->body[k - 1], b, at);
    }
    tumble_vec3 hook = tumble_v(-out * sin(FAMILY_PI / n),
                                out * cos(FAMILY_PI / n), 0);
    join(w, l, l->body[n - 1], l->body[0], hook);
    join(w, l, l->body[0], tumble_body_ground(), hook);
}

// n planks of this length, each joined to the next at both rails, hang in a V.
static void hang_bridge(tumble_world *w, linkage *l, int n, double length)
{
    const double up = 0.6, along = 0.8;
    tumble_vec3 sides = tumble_v(0.9 * length, 0.1 * length, 2 * length);
    tumble_shape s = tumble_shape_box(w, sides, 1);
    tumble_body ground = tumble_body_ground();
    for (int k = 0; k < n; k++) {
        double side = k < n / 2 ? -1 : 1, deep = side < 0 ? k + 0.5 : n - k - 0.5;
        tumble_body_options o = tumble_body_at(along * length * (k + 0.5),
                                               -up * length * deep, 0);
        o.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1), side * asin(up));
        weigh(l, tumble_body_add(w, s, o), box_inertia(sides, 1));
    }
    for (int k = 0; k <= n; k++)
        for (int rail = -1; rail < 2; rail += 2)
            join(w, l, k > 0 ? l->body[k - 1] : ground, k < n ? l->body[k] : ground,
                 tumble_v(along * length * k, -up * length * (k < n - k ? k : n - k),
                          0.9 * length * rail));
}

// They hold as chains do, and falling gains nothing.
static void rings(hard_report *r, int fast)
{
    static const double lengths[] = { 0.2, 0.02, 5 };
    static const int links[] = { 10, 40 };
    family_worst gap = { .target = 1e-3 }, gain = { .target = 1e-3 };
    for (int k = 0; k < (fast ? 2 : 36); k++) {
        double dt = STEPS[k / 12], length = lengths[k / 4 % 3];
        int n = links[k / 2 % 2];
        tumble_world *w = begin(dt);
        linkage l = { 0 };
        if (k % 2) hang_bridge(w, &l, n, length);
        else       hang_ring(w, &l, n, length);
        course c = follow(w, &l, dt, fast ? 0.5 : 2, HUGE_VAL);
        if (family_ok(r, w)) {
            char at[80];
            snprintf(at, sizeof at, "%s of %d, %g m, dt 1/%.0f",
                     k % 2 ? "a bridge on two rails" : "a ring", n, length, 1 / dt);
            family_trial(&gap, c.gap / length, "%s", at);
            family_trial(&gain, c.gain / (n * FAMILY_G * n * length / 2), "%s", at);
        }
        tumble_world_free(w);
    }
    family_add(r, &gap, "", "gap in a ring of links, of a link");
    family_add(r, &gain, "", "energy gained, of a fall by its length");
}

// ---- 168: nothing stops in silence -----------------------------------------

// Is it at rest in the air: awake, under gravity, with no speed at all?
static int is_frozen(const tumble_world *w, const linkage *l)
{
    for (int k = 0; k < l->count; k++) {
        tumble_body b = l->b[k].body;
        if (!tumble_body_is_awake(w, b)
            || v_length(tumble_body_velocity(w, b)) > 0)
            return 0;
    }
    return 1;
}

// A program may take few substeps.  Then a chain may come apart, and where it
// does by more than a hundredth of a link, or stops, the report or the failure
// is to say so.
static void few_substeps(hard_report *r, int fast)
{
    static const int links[] = { 10, 50 }, few[] = { 4, 1, 2, 8 };
    family_worst frozen = { .target = 0 }, apart = { .target = 0 };
    for (int k = 0; k < (fast ? 1 : 16); k++) {
        double dt = STEPS[k / 8], mass = 100;
        int n = links[k % 2], substeps = few[k / 2 % 4], still = 0, wide = 0;
        tumble_options o = family_options(dt, 0.5);
        o.substeps = o.most_substeps = substeps;
        tumble_world *w = tumble_world_make(&o);
        linkage l = { 0 };
        tumble_body last = add_chain(w, &l, n, tumble_v(0, 0, 0),
                                     tumble_v(1, 0, 0));
        tumble_body ball = add_ball(w, &l, LINK, mass,
                                    tumble_v((n + 1) * LINK, 0, 0),
                                    tumble_v(0, 0, 0));
        join(w, &l, last, ball, tumble_v(n * LINK, 0, 0));
        int steps = (int)((fast ? 1 : 3) / dt);
        // Eight say it as well as all of them, and they are slow.
        for (int i = 0; i < steps && still + wide < 8; i++) {
            tumble_world_step(w);
            if (tumble_world_failure(w)
                || tumble_world_last_step(w).unconverged) continue;
            still += is_frozen(w, &l);
            wide += !(widest(w, &l) <= 0.01 * LINK);
        }
        family_trial(&frozen, still, "%d links, %d substeps, dt 1/%.0f", n,
                     substeps, 1 / dt);
        family_trial(&apart, wide, "%d links, %d substeps, dt 1/%.0f", n,
                     substeps, 1 / dt);
        tumble_world_free(w);
    }
    family_add(r, &frozen, "", "steps in which a chain stopped in silence");
    family_add(r, &apart, "", "steps in which it was apart in silence");
}

// ---- 169: symmetries -------------------------------------------------------

// A tree of boxes in space without gravity, that spins and bends: each is
// joined to one before it, at a corner of both, by a ball or a hinge.
static void add_tree(tumble_world *w, linkage *l, int n, double fast,
                     family_seed seed)
{
    tumble_body all[MOST_JOINTS];
    tumble_vec3 at[MOST_JOINTS], corner = { 0.1, 0.05, 0.05 };
    for (int i = 0; i < n; i++) {
        int to = i ? (int)(family_random(&seed) * i) : 0;
        at[i] = i ? v_add(at[to], tumble_v(0.2, 0.1 * (i % 2 ? 1 : -1), 0.1))
                  : tumble_v(0, 0, 0);
        tumble_body_options o = tumble_body_at(at[i].x, at[i].y, at[i].z);
        o.velocity = v_scale(0.2 * fast, family_direction(&seed));
        o.spin = v_scale(fast, family_direction(&seed));
        o.mask = 0;
        double mass = family_log_between(&seed, 0.1, 10);
        tumble_vec3 sides = v_scale(2, corner);
        all[i] = weigh(l,
                       tumble_body_add(w, tumble_shape_box(w, sides, mass), o),
                       box_inertia(sides, mass));
        tumble_vec3 point = v_scale(0.5, v_add(at[to], at[i]));
        if (i && i % 3) join(w, l, all[to], all[i], point);
        else if (i)
            hinge(w, l, all[to], all[i], point, family_direction(&seed));
    }
}

// The sums of m v and of x times m v, and, once its joints have taken up what
// the throw had against them, the energy.
static void throw_tree(hard_report *r, family_worst *sums, family_worst *energy,
                       int n, double fast, double dt, family_seed seed)
{
    tumble_options o = family_options(dt, 0.5);
    o.gravity = tumble_v(0, 0, 0);
    tumble_world *w = tumble_world_make(&o);
    linkage l = { 0 };
    add_tree(w, &l, n, fast, seed);
    tumble_measures a = tumble_world_measure(w);
    tumble_world_step(w);
    double mass = 0;
    for (int i = 0; i < n; i++) mass += tumble_body_mass(w, l.body[i]);
    double whole = kinetic(w, &l), scale = sqrt(2 * mass * whole);
    course c = follow(w, &l, dt, 5, whole);
    tumble_measures b = tumble_world_measure(w);
    if (family_ok(r, w)) {
        // kg m/s, beside a root mean square; the tree is about a metre wide.
        double off = (v_distance(a.momentum, b.momentum)
                      + v_distance(a.angular, b.angular)) / scale;
        family_trial(sums, off, "%d boxes, %g rad/s, dt 1/%.0f", n, fast,
                     1 / dt);
        family_trial(energy, c.off / whole, "%d boxes, %g rad/s, dt 1/%.0f", n,
                     fast, 1 / dt);
    }
    tumble_world_free(w);
}

// A chain of five under a moving point, as seen from it, against the same under
// one at rest: m, how far are their ends apart?
static double ride(double speed, double dt)
{
    tumble_world *w[2] = { begin(dt), begin(dt) };
    tumble_body end[2], base[2];
    for (int k = 0; k < 2; k++) {
        tumble_vec3 v = tumble_v(k * speed, 0, 0), way = { 0, 0, LINK };
        linkage l = { 0 };
        tumble_shape s = tumble_shape_box(w[k], LINK_SIDES, 1);
        tumble_body_options o = tumble_body_at(0, 0, 0);
        o.kind = TUMBLE_KINEMATIC;
        o.velocity = v;
        end[k] = base[k] = tumble_body_add(w[k], s, o);
        for (int i = 0; i < 5; i++) {
            end[k] = add_link(w[k], &l, s, end[k], v_scale(i, way), way);
            tumble_body_set_velocity(w[k], end[k], v, tumble_v(0, 0, 0));
        }
        for (int n = (int)(1 / dt + 0.5); n > 0; n--) tumble_world_step(w[k]);
    }
    double off = v_distance(v_sub(tumble_body_position(w[0], end[0]),
                                  tumble_body_position(w[0], base[0])),
                            v_sub(tumble_body_position(w[1], end[1]),
                                  tumble_body_position(w[1], base[1])));
    for (int k = 0; k < 2; k++) tumble_world_free(w[k]);
    return off;
}

// A chain of n, whose bodies and joints are made in order, or by chance: where
// is its end after a second?
static tumble_vec3 swing_shuffled(int n, family_seed seed)
{
    tumble_world *w = begin(STEPS[0]);
    tumble_shape s = tumble_shape_box(w, LINK_SIDES, 1);
    tumble_body link[MOST_JOINTS];
    int order[MOST_JOINTS];
    for (int i = 0; i < n; i++) order[i] = i;
    for (int i = n - 1; seed && i > 0; i--) {
        int k = (int)(family_random(&seed) * (i + 1)), was = order[i];
        order[i] = order[k];
        order[k] = was;
    }
    for (int i = 0; i < n; i++)
        link[order[i]] =
            tumble_body_add(w, s, tumble_body_at((order[i] + 0.5) * LINK, 0,
                                                 0));
    for (int i = 0; i < n; i++) {
        int k = order[i];
        tumble_joint_ball(w, k ? link[k - 1] : tumble_body_ground(), link[k],
                          tumble_v(k * LINK, 0, 0));
    }
    for (int i = 0; i < 60; i++) tumble_world_step(w);
    tumble_vec3 end = tumble_body_position(w, link[n - 1]);
    tumble_world_free(w);
    return end;
}

static void symmetries(hard_report *r, int fast)
{
    static const double quick[] = { 3, 30, 100 }, speeds[] = { 1, 30, 1000 };
    family_worst sums = { .target = 1e-9 }, energy = { .target = 1e-3 },
                 rides = { .target = 1e-6 }, orders = { .target = 1e-6 };
    for (int k = 0; k < (fast ? 1 : 27); k++)
        throw_tree(r, &sums, &energy, k / 9 ? 12 : 2, quick[k % 3],
                   STEPS[k / 3 % 3], 40 + (family_seed)k);
    for (int k = 0; k < (fast ? 1 : 9); k++)
        family_trial(&rides, ride(speeds[k % 3], STEPS[k / 3]) / LINK,
                     "%g m/s, dt 1/%.0f", speeds[k % 3], 1 / STEPS[k / 3]);
    for (int n = 5; n <= (fast ? 5 : 20); n *= 2) {
        tumble_vec3 truth = swing_shuffled(n, 0);
        for (family_seed seed = 1; seed < 6; seed++)
            family_trial(&orders, v_distance(truth, swing_shuffled(n, seed))
                         / LINK, "%d links, shuffle %d", n, (int)seed);
    }
    family_add(r, &sums, "", "momentum, angular momentum of thrown linkages");
    family_add(r, &energy, "", "energy of thrown linkages, of itself");
    family_add(r, &rides, "", "a swinging chain seen from a train, of a link");
    family_add(r, &orders, "", "the same, made in another order, of a link");
}

const hard_case family_joints[] = {
    { 159, "rings of links", 1, rings },
    { 160, "tops on a ball joint", 1, tops },
    { 161, "steady precession", 1, precession },
    { 162, "flywheels on hinges", 1, flywheels },
    { 163, "pendulums", 1, pendulums },
    { 164, "double pendulums", 1, double_pendulums },
    { 165, "limits of hinges", 1, limits },
    { 166, "sudden loads on joints", 1, sudden_loads },
    { 167, "chains under heavy weights", 1, heavy_chains },
    { 168, "few substeps, never in silence", 1, few_substeps },
    { 169, "linkages and their symmetries", 1, symmetries },
    { 0, NULL, 0, NULL }
};
