// check_motion.c - do the six ways of four particles move a body as the
// textbook says, and for as long as it likes?  Book: chapter 13.

#include <stdio.h>
#include <string.h>

#include "motion.h"
#include "solids.h"
#include "suite.h"

// The image of solid i under any affine map, built as f; returns its shape.
static shape any_image(int i, matrix *m)
{
    shape s;
    *m = any_affine();
    make_image(&s, &solid[i].plan, m);
    expect_ok(rigid4_build(&f, &s));
    return s;
}

static void leave(shape *s)
{
    rigid4_free(&f);
    shape_free(s);
}

// I x for a solid of this mass with the spread of solid i seen through m, and
// then turned: the integral of mass (r^2 x - r (r . x)).
static vec3 inertia_times(int i, const matrix *m, const matrix *turn, real mass,
                          vec3 x)
{
    const vec3 column[3] = { m->x, m->y, m->z };
    vec3 sum = { 0, 0, 0 };
    for (int k = 0; k < 3; k++) {
        vec3 c = times(turn, column[k]);
        real share = mass * solid[i].spread[k];
        sum = vec3_add_scaled(sum, share * vec3_length_squared(c), x);
        sum = vec3_add_scaled(sum, -share * vec3_dot(c, x), c);
    }
    return sum;
}

static vec3 turns_of(const motion_basis *b, vec3 x)
{
    motion m = { { 0 } };
    for (int t = 0; t < TURNS; t++)
        m.of[MOTION_TURN + t] = vec3_dot(b->turn[t], x);
    return motion_rotation(b, &m);
}

// --- the basis ---------------------------------------------------------------

// The sum of turn turn^T is the inverse of the inertia, and turn_s . I turn_t
// is 1 or 0.  Rejects: axes that are not divided by the root of their moments;
// one moment of another axis; turns of the frame at rest.
static void try_basis(int i, const matrix *m)
{
    particle p[FOUR];
    matrix turn = stand(p);
    rigid_frame frame = rigid4_frame(p);
    motion_basis b = basis_find(&f, &frame);
    real mass = FOUR * f.mass;
    ck_assert(fabs(b.inverse_mass * mass - 1) <= ROUNDING);
    vec3 x = random_direction(&seed), y = turns_of(&b, x);
    vec3 back = inertia_times(i, m, &turn, mass, y);
    ck_assert_msg(vec3_distance(back, x) <= LONG_BODY, "solid %d: off by %g", i,
                  vec3_distance(back, x));
    for (int s = 0; s < TURNS; s++)
        for (int t = 0; t < TURNS; t++) {
            real e = vec3_dot(b.turn[s], inertia_times(i, m, &turn, mass,
                                                       b.turn[t]));
            ck_assert(fabs(e - (s == t)) <= LONG_BODY);
        }
}

START_TEST(basis_is_the_root_of_the_inverse_inertia)
{
    const matrix as_it_is = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    for (int i = 0; i < SOLIDS; i++) {
        expect_ok(rigid4_build(&f, &solid[i].plan));
        for (int n = 0; n < 20; n++) try_basis(i, &as_it_is);
        rigid4_free(&f);
        for (int n = 0; n < 200; n++) {
            matrix m;
            shape s = any_image(i, &m);
            try_basis(i, &m);
            leave(&s);
        }
    }
}
END_TEST

// A box of sides 1, 2 and 3 and 7 kg, and an icosahedron, in numbers that can
// be had by hand.
START_TEST(box_and_ball_have_the_moments_of_the_textbook)
{
    const vec3 axis[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    const real box[3] = { 7 * 13.0 / 12, 7 * 10.0 / 12, 7 * 5.0 / 12 };
    real phi2 = (3 + sqrt(5.0)) / 2, ball = 2 * phi2 / (10 * (phi2 + 1));
    for (int i = 0; i < 2; i++) {
        expect_ok(rigid4_build(&f, &solid[i ? BALL : BOX].plan));
        particle p[FOUR];
        for (int k = 0; k < FOUR; k++) p[k].position = f.at[k];
        rigid_frame frame = rigid4_frame(p);
        motion_basis b = basis_find(&f, &frame);
        for (int k = 0; k < 3; k++) {
            vec3 spin = turns_of(&b, axis[k]);
            real moment = i ? ball : box[k];
            ck_assert(vec3_distance(spin, vec3_scale(1 / moment, axis[k]))
                      <= ROUNDING / moment);
        }
        rigid4_free(&f);
    }
}
END_TEST

// --- velocities --------------------------------------------------------------

static vec3 linear_momentum(const particle *p, real h)
{
    vec3 sum = { 0, 0, 0 };
    for (int k = 0; k < FOUR; k++)
        sum = vec3_add_scaled(sum, f.mass / h,
                              vec3_sub(p[k].position, p[k].previous));
    return sum;
}

// About the middle of the four.
static vec3 angular_momentum(const particle *p, real h)
{
    rigid_frame frame = rigid4_frame(p);
    vec3 sum = { 0, 0, 0 };
    for (int k = 0; k < FOUR; k++) {
        vec3 v = vec3_scale(1 / h, vec3_sub(p[k].position, p[k].previous));
        vec3 r = vec3_sub(p[k].position, frame.center);
        sum = vec3_add_scaled(sum, f.mass, vec3_cross(r, v));
    }
    return sum;
}

static void set_moving(particle *p, vec3 v, vec3 spin, real h)
{
    rigid_frame frame = rigid4_frame(p);
    for (int k = 0; k < FOUR; k++) {
        vec3 r = vec3_sub(p[k].position, frame.center);
        p[k].previous = vec3_add_scaled(p[k].position, -h,
                                        vec3_add(v, vec3_cross(spin, r)));
    }
}

// Rejects: a velocity of one particle for that of all; a moment about the
// origin; a factor of h.
START_TEST(motion_has_the_momentum_of_the_particles)
{
    const real h = 1.0 / 512;
    for (int n = 0; n < 400; n++) {
        matrix m;
        shape s = any_image(n % SOLIDS, &m);
        particle p[FOUR];
        stand(p);
        // Half of them bend while they move: only what is rigid counts.
        vec3 v = random_vec3(&seed, 1), spin = random_vec3(&seed, 1);
        set_moving(p, v, spin, h);
        for (int k = 0; k < FOUR && n % 2; k++)
            p[k].previous =
                vec3_add_scaled(p[k].previous, h, random_vec3(&seed, 1));
        rigid_frame frame = rigid4_frame(p);
        motion_basis b = basis_find(&f, &frame);
        motion u = motion_of(p, &frame, &b, h);
        vec3 sum = vec3_scale(FOUR * f.mass, vec3_make(u.of[0], u.of[1],
                                                       u.of[2]));
        vec3 had = linear_momentum(p, h), turning = { 0, 0, 0 };
        for (int k = 0; k < FOUR; k++) {
            vec3 r = frame_arm(&frame, k);
            turning = vec3_add_scaled(turning, f.mass,
                vec3_cross(r, vec3_cross(motion_rotation(&b, &u), r)));
        }
        ck_assert(vec3_distance(sum, had) <= 1e-12);
        ck_assert(vec3_distance(turning, angular_momentum(p, h)) <= 1e-11);
        if (n % 2 == 0) {
            vec3 arm = random_vec3(&seed, 1);
            ck_assert(vec3_distance(motion_at(&b, &u, arm),
                                    vec3_add(v, vec3_cross(spin, arm)))
                      <= 1e-10);
        }
        leave(&s);
    }
}
END_TEST

// Rejects: an energy without the half, or of the linear part alone.
START_TEST(motion_has_the_energy_and_spin_of_the_particles)
{
    const real h = 1.0 / 512;
    for (int n = 0; n < 100; n++) {
        matrix m;
        shape s = any_image(n % SOLIDS, &m);
        particle p[FOUR];
        stand(p);
        set_moving(p, random_vec3(&seed, 1), random_vec3(&seed, 1), h);
        rigid_frame frame = rigid4_frame(p);
        motion_basis b = basis_find(&f, &frame);
        motion u = motion_of(p, &frame, &b, h);
        real energy = 0;
        for (int k = 0; k < FOUR; k++)
            energy += f.mass / 2 / (h * h) * vec3_length_squared(
                          vec3_sub(p[k].position, p[k].previous));
        ck_assert(fabs(motion_energy(&b, &u) - energy) <= 1e-11 * energy);
        ck_assert(vec3_distance(motion_angular(&b, &u),
                                angular_momentum(p, h)) <= 1e-11);
        leave(&s);
    }
}
END_TEST

// --- impulses ----------------------------------------------------------------

// v = j / M and spin = I^-1 (r x j), of a solid box in its own axes.
static vec3 textbook_spin(vec3 sides, real mass, vec3 moment)
{
    vec3 square = { sides.x * sides.x, sides.y * sides.y, sides.z * sides.z };
    return vec3_make(12 * moment.x / (mass * (square.y + square.z)),
                     12 * moment.y / (mass * (square.z + square.x)),
                     12 * moment.z / (mass * (square.x + square.y)));
}

// The largest relative error of n boxes pushed at random points, in any pose.
static real worst_answer(real aspect, int n)
{
    real worst = 0;
    for (int i = 0; i < n; i++) {
        vec3 sides =
            { 1, 1 + (aspect - 1) * random_fraction(&seed), aspect };
        real mass = 2 + random_real(&seed);
        shape s;
        particle p[FOUR];
        expect_ok(shape_box(&s, sides, mass));
        expect_ok(rigid4_build(&f, &s));
        matrix turn = stand(p);
        rigid_frame frame = rigid4_frame(p);
        motion_basis b = basis_find(&f, &frame);
        motion u = { { 0 } };
        vec3 j = random_vec3(&seed, 1), r = s.at[i % 8];
        motion_push(&u, &b, times(&turn, r), times(&turn, j));
        vec3 spin = textbook_spin(sides, mass, vec3_cross(r, j));
        vec3 v = { u.of[0], u.of[1], u.of[2] };
        vec3 got = motion_rotation(&b, &u);
        worst = fmax(worst, vec3_distance(v, vec3_scale(1 / mass,
                     times(&turn, j))) * mass / vec3_length(j));
        worst = fmax(worst, vec3_distance(got, times(&turn, spin))
                     / vec3_length(spin));
        rigid4_free(&f);
        shape_free(&s);
    }
    return worst;
}

// Rejects: a moment of the wrong sign, or about the origin; an inertia of the
// pose at rest.
START_TEST(impulse_changes_velocity_and_spin_as_the_textbook_says)
{
    const struct { real aspect, most; } rule[] = {
        { 1, ROUNDING }, { 3, ROUNDING }, { 10, LONG_BODY },
        // The place of a corner is known to 1e-16 of the body's length, and
        // the moment about the long axis is smaller by the aspect's square.
        { 100, 1e-11 }, { 1000, 1e-9 },
    };
    for (int k = 0; k < COUNT(rule); k++) {
        real error = worst_answer(rule[k].aspect, 1000);
        printf("impulses at aspect %g: off by %.2g at most\n", rule[k].aspect,
               error);
        ck_assert_msg(error <= rule[k].most, "aspect %g: off by %g",
                      rule[k].aspect, error);
    }
}
END_TEST

// Oracle: an impulse j at a point with these weights of the four gives each of
// them weight j / mass, and the six sticks take back what would change their
// lengths.
static void sticks_answer(const vec3 at[FOUR], const real weight[FOUR], vec3 j,
                          vec3 answer[FOUR])
{
    const inverse answer_of = inverse_of(&f);
    real mu[FOUR_STICKS] = { 0 }, w = 1 / f.mass;
    vec3 o[FOUR_STICKS];
    for (int s = 0; s < FOUR_STICKS; s++) {
        int a = f.stick[s].a, b = f.stick[s].b;
        o[s] = vec3_sub(at[b], at[a]);
        real c = (weight[b] - weight[a]) * vec3_dot(o[s], j);
        for (int u = 0; u < FOUR_STICKS; u++) mu[u] += answer_of.at[u][s] * c;
    }
    for (int k = 0; k < FOUR; k++) answer[k] = vec3_scale(w * weight[k], j);
    for (int s = 0; s < FOUR_STICKS; s++) {
        int a = f.stick[s].a, b = f.stick[s].b;
        answer[a] = vec3_add_scaled(answer[a], w * mu[s], o[s]);
        answer[b] = vec3_add_scaled(answer[b], -w * mu[s], o[s]);
    }
}

// Rejects: a way that bends a stick; five ways, or seven, where there are six.
START_TEST(six_ways_are_what_the_sticks_leave)
{
    for (int n = 0; n < 400; n++) {
        matrix m;
        shape s = any_image(n % SOLIDS, &m);
        particle p[FOUR];
        stand(p);
        real weight[FOUR] = { random_real(&seed), random_real(&seed),
                              random_real(&seed) };
        weight[3] = 1 - weight[0] - weight[1] - weight[2];
        rigid_frame frame = rigid4_frame(p);
        motion_basis b = basis_find(&f, &frame);
        vec3 at[FOUR], arm = { 0, 0, 0 }, j = random_direction(&seed),
             told[FOUR];
        for (int k = 0; k < FOUR; k++) {
            at[k] = p[k].position;
            arm = vec3_add_scaled(arm, weight[k], frame_arm(&frame, k));
        }
        sticks_answer(at, weight, j, told);
        motion u = { { 0 } };
        motion_push(&u, &b, arm, j);
        real most = 0, off = 0;
        for (int k = 0; k < FOUR; k++) {
            vec3 got = motion_at(&b, &u, frame_arm(&frame, k));
            most = fmax(most, vec3_length(told[k]));
            off = fmax(off, vec3_distance(told[k], got));
        }
        // The matrix of the sticks has a condition of up to 10^6 here.
        ck_assert_msg(off <= 1e-10 * most, "off by %g of %g", off, most);
        leave(&s);
    }
}
END_TEST

// --- moves -------------------------------------------------------------------

// One frame of dt without forces, in one substep.
static void free_frame(particle *p, real dt)
{
    rigid_frame frame = rigid4_frame(p);
    motion_basis b = basis_find(&f, &frame);
    motion u = motion_of(p, &frame, &b, dt);
    motion_advance(&frame, &b, &u, dt);
    motion_straighten(&f, &frame);
    motion_write(p, &frame, &b, &u, dt);
}

// rad: by so much less is a body turned that turns by `by` in parts of a third of
// a radian, at most so many.  Of tan(a / 2) = a / 2 (1 + a^2 / 12 + ... +
// 31 a^8 / 362880 + ...) the last term here, and what follows, is left out.
static real series_error(real by, int parts)
{
    real a = real_max(real_min(by, 1.0 / 3), by / parts), a4 = a * a * a * a;
    return by * a4 * a4 * 31 / 362880 * 1.1;
}

// Over 1e5 frames, each with some roundings of numbers near 1.
#define LONG_TIME 1e-10

// Rejects: a momentum that drifts by the tolerance of sticks, 1e-9 a frame;
// velocities of the old basis in the new one; a frame that rounding bends.
START_TEST(momentum_and_angular_momentum_last_for_1e5_frames)
{
    for (int i = 0; i < SOLIDS; i++) {
        const real dt = 1.0 / 64;
        expect_ok(rigid4_build(&f, &solid[i].plan));
        particle p[FOUR];
        stand(p);
        set_moving(p, vec3_make(1e-3, 0, 2e-3),
                   vec3_scale(5, random_direction(&seed)), dt);
        vec3 linear = linear_momentum(p, dt), angular = angular_momentum(p, dt);
        for (int n = 0; n < 100000; n++) free_frame(p, dt);
        real off = vec3_distance(angular_momentum(p, dt), angular)
                 / vec3_length(angular);
        printf("solid %d: angular momentum is off by %.1g\n", i, off);
        ck_assert_msg(off <= LONG_TIME, "off by %g", off);
        ck_assert(vec3_distance(linear_momentum(p, dt), linear)
                  <= 1e-8 * vec3_length(linear));
        rigid4_free(&f);
    }
}
END_TEST

// The angle, in (-pi, pi], by which frame b is turned against a about the axis.
static real angle_between(const rigid_frame *a, const rigid_frame *b, vec3 axis)
{
    real sine = 0, cosine = 0;
    for (int i = 0; i < FOUR_AXES; i++) {
        vec3 x = vec3_unit(a->axis[i]), y = vec3_unit(b->axis[i]);
        sine += vec3_dot(axis, vec3_cross(x, y)) / 2;
        cosine += (vec3_dot(x, y) - vec3_dot(x, axis) * vec3_dot(y, axis)) / 2;
    }
    return atan2(sine, cosine);
}

// About the middle axis a body turns over, sooner or later.
static bool is_middle(int i)
{
    const real *y = f.square;
    return (y[i] - y[(i + 1) % 3]) * (y[i] - y[(i + 2) % 3]) < 0;
}

// Rejects: a chord taken for its arc, which turns by too little from 10 rad/s
// on; a brake.
START_TEST(free_spin_keeps_its_speed_and_turns_by_its_angle)
{
    const real dt = 1.0 / 60, speed[] = { 0.1, 1, 10, 19, 50, 203, 1003 };
    for (int k = 0; k < COUNT(speed); k++) {
        expect_ok(rigid4_build(&f, &solid[BOX].plan));
        for (int i = 0; i < FOUR_AXES; i++) {
            particle p[FOUR];
            if (is_middle(i)) continue;
            stand(p);
            rigid_frame at = rigid4_frame(p);
            vec3 axis = vec3_unit(at.axis[i]);
            set_moving(p, vec3_make(1, 2, 3), vec3_scale(speed[k], axis), dt);
            real most = 0;
            for (int n = 0; n < 600; n++) {
                rigid_frame was = rigid4_frame(p);
                free_frame(p, dt);
                rigid_frame now = rigid4_frame(p);
                real off = angle_between(&was, &now, axis) - speed[k] * dt;
                most = fmax(most, fabs(remainder(off, 2 * acos(-1))));
            }
            at = rigid4_frame(p);
            motion_basis b = basis_find(&f, &at);
            motion u = motion_of(p, &at, &b, dt);
            vec3 spin = motion_rotation(&b, &u);
            ck_assert_msg(vec3_distance(spin, vec3_scale(speed[k], axis))
                          <= 1e-6 * speed[k], "%g rad/s: %g", speed[k],
                          vec3_dot(spin, axis));
            ck_assert_msg(most <= 1e-12 + series_error(speed[k] * dt, MOTION_MOVES),
                          "%g rad/s: a frame is off by %g", speed[k], most);
        }
        rigid4_free(&f);
    }
}
END_TEST

// x, turned about the unit axis by a (Rodrigues).
static vec3 turned_by(vec3 axis, real a, vec3 x)
{
    vec3 r = vec3_add_scaled(vec3_scale(cos(a), x), sin(a),
                             vec3_cross(axis, x));
    return vec3_add_scaled(r, vec3_dot(axis, x) * (1 - cos(a)), axis);
}

// Rejects: a turn the other way; an angle that is off by more than its series.
START_TEST(frame_inside_a_frame_is_turned_and_moved)
{
    const real angles[] = { 0, 1e-3, 0.05, 0.3, 2, 40 };
    for (int n = 0; n < 600; n++) {
        matrix m;
        shape s = any_image(n % SOLIDS, &m);
        particle p[FOUR];
        stand(p);
        rigid_frame frame = rigid4_frame(p);
        motion_basis b = basis_find(&f, &frame);
        vec3 axis = random_direction(&seed), way = random_vec3(&seed, 1);
        real by = angles[n % COUNT(angles)];
        motion d = { { way.x, way.y, way.z } };
        for (int t = 0; t < TURNS; t++)
            d.of[MOTION_TURN + t] = by * vec3_dot(axis, b.turn[t])
                                  / vec3_length_squared(b.turn[t]);
        rigid_frame now = motion_frame(&frame, &b, &d);
        real off = 1e-12 + series_error(by, 1000);
        ck_assert(vec3_distance(now.center, vec3_add(frame.center, way))
                  <= 1e-14 * 10);
        for (int i = 0; i < FOUR_AXES; i++) {
            vec3 x = turned_by(axis, by, frame.axis[i]);
            ck_assert_msg(vec3_distance(now.axis[i], x)
                          <= off * vec3_length(x), "%g rad: off by %g", by,
                          vec3_distance(now.axis[i], x));
        }
        leave(&s);
    }
}
END_TEST

// --- an asymmetric top -------------------------------------------------------

// Oracle: Euler's equations by Runge and Kutta, for the three axes of a frame.
typedef struct {
    vec3 axis[3];
} pose;

static pose pose_rate(const pose *q, const real moment[3], vec3 angular)
{
    vec3 spin = { 0, 0, 0 };
    for (int i = 0; i < 3; i++)
        spin = vec3_add_scaled(spin, vec3_dot(q->axis[i], angular) / moment[i],
                               q->axis[i]);
    pose rate;
    for (int i = 0; i < 3; i++) rate.axis[i] = vec3_cross(spin, q->axis[i]);
    return rate;
}

static pose pose_go(const pose *q, real s, const pose *rate)
{
    pose r;
    for (int i = 0; i < 3; i++)
        r.axis[i] = vec3_add_scaled(q->axis[i], s, rate->axis[i]);
    return r;
}

static pose precessed(pose q, const real moment[3], vec3 angular, real time)
{
    enum { STEPS = 20000 };
    real h = time / STEPS;
    for (int n = 0; n < STEPS; n++) {
        pose a = pose_rate(&q, moment, angular), x = pose_go(&q, h / 2, &a);
        pose b = pose_rate(&x, moment, angular);
        x = pose_go(&q, h / 2, &b);
        pose c = pose_rate(&x, moment, angular);
        x = pose_go(&q, h, &c);
        pose d = pose_rate(&x, moment, angular);
        q = pose_go(&q, h / 6, &a);
        q = pose_go(&q, h / 3, &b);
        q = pose_go(&q, h / 3, &c);
        q = pose_go(&q, h / 6, &d);
    }
    return q;
}

// How far the axes are off after a second of `frames` frames, and by how much
// the energy ever was, relative.
static real precess(int frames, real *energy_off)
{
    const real dt = 1.0 / frames;
    particle p[FOUR];
    pose q;
    real moment[3], off = 0, before = 0;
    for (int k = 0; k < FOUR; k++)
        p[k] = (particle){ f.at[k], f.at[k], 1 / f.mass };
    rigid_frame frame = rigid4_frame(p);
    for (int i = 0; i < 3; i++) {
        q.axis[i] = vec3_unit(frame.axis[i]);
        moment[i] = 1 / (f.turn[i] * f.turn[i] * f.square[i]);
    }
    set_moving(p, vec3_make(0, 0, 0), vec3_make(3, 6, 2), dt);
    vec3 angular = angular_momentum(p, dt);
    *energy_off = 0;
    for (int n = 0; n <= frames; n++) {
        frame = rigid4_frame(p);
        motion_basis b = basis_find(&f, &frame);
        motion u = motion_of(p, &frame, &b, dt);
        real energy = motion_energy(&b, &u);
        if (n == 0) before = energy;
        *energy_off = fmax(*energy_off, fabs(energy / before - 1));
        if (n < frames) free_frame(p, dt);
    }
    q = precessed(q, moment, angular, 1);
    for (int i = 0; i < 3; i++)
        off = fmax(off, vec3_distance(vec3_unit(frame.axis[i]), q.axis[i]));
    return off;
}

// Rejects: a spin that stays where it was while the body turns, which is of
// order 1 and gains energy.
START_TEST(lopsided_body_precesses_with_order_two)
{
    expect_ok(rigid4_build(&f, &solid[BOX].plan));
    real was = 0;
    for (int frames = 60; frames <= 960; frames *= 2) {
        real energy, off = precess(frames, &energy);
        printf("%4d frames: axes off by %.3g, energy by %.1g\n", frames, off,
               energy);
        if (frames > 60)
            ck_assert_msg(was / off > 3.8 && was / off < 4.2, "%g times",
                          was / off);
        // At 7 rad/s.  It does not drift: check_advance.c.
        real dt = 1.0 / frames;
        ck_assert_msg(energy <= 0.1 * (7 * dt) * (7 * dt), "energy off by %g",
                      energy);
        was = off;
    }
}
END_TEST

// Rejects: a spin that is kept, or that turns with the body; a way that is not
// gone.
START_TEST(what_is_displaced_keeps_its_angular_momentum)
{
    for (int n = 0; n < 300; n++) {
        matrix m;
        shape s = any_image(n % SOLIDS, &m);
        particle p[FOUR];
        stand(p);
        rigid_frame was = rigid4_frame(p), now = was;
        motion_basis b = basis_find(&f, &was);
        vec3 way = random_vec3(&seed, 1), turn = random_vec3(&seed, 1);
        motion u = motion_make(&b, random_vec3(&seed, 1), random_vec3(&seed, 9));
        motion d = motion_make(&b, way, turn);
        vec3 had = motion_angular(&b, &u);
        rigid_frame wanted = motion_frame(&was, &b, &d);
        motion_displace(&now, &b, &u, &d);
        ck_assert(memcmp(&now, &wanted, sizeof now) == 0);
        vec3 has = motion_angular(&b, &u);
        ck_assert(vec3_distance(had, has) <= 1e-13 * vec3_length(had));
        motion_basis found = basis_find(&f, &now);
        for (int t = 0; t < TURNS; t++)
            ck_assert(vec3_distance(found.turn[t], b.turn[t])
                      <= 1e-12 * vec3_length(b.turn[t]));
        leave(&s);
    }
}
END_TEST

// Axes that are bent and stretched by a are right to a^2 afterwards.
// Rejects: a correction that is half, or double, of what is lacking.
START_TEST(bent_frame_is_straightened)
{
    for (int n = 0; n < 100; n++) {
        const real a = 1e-5;
        matrix m;
        shape s = any_image(n % SOLIDS, &m);
        particle p[FOUR];
        stand(p);
        rigid_frame frame = rigid4_frame(p);
        for (int i = 0; i < FOUR_AXES; i++)
            frame.axis[i] = vec3_add_scaled(frame.axis[i],
                a * vec3_length(frame.axis[i]), random_vec3(&seed, 1));
        motion_straighten(&f, &frame);
        for (int i = 0; i < FOUR_AXES; i++)
            for (int j = 0; j < FOUR_AXES; j++) {
                real size = sqrt(f.square[i] * f.square[j]);
                real off = vec3_dot(frame.axis[i], frame.axis[j])
                         - (i == j) * f.square[i];
                ck_assert_msg(fabs(off) <= 30 * a * a * size,
                              "off by %g", off / size);
            }
        leave(&s);
    }
}
END_TEST

// --- what does not move, and what is lost ------------------------------------

// Rejects: a body of no inverse mass that is divided by; one that goes.
START_TEST(immovable_body_answers_nothing)
{
    const motion_basis none = { .inverse_mass = 0 };
    expect_ok(rigid4_build(&f, &solid[BALL].plan));
    particle p[FOUR], was[FOUR];
    stand(p);
    for (int k = 0; k < FOUR; k++) p[k].inverse_mass = 0;
    memcpy(was, p, sizeof p);
    rigid_frame frame = rigid4_frame(p);
    motion u = motion_of(p, &frame, &none, 1.0 / 60);
    motion_push(&u, &none, random_vec3(&seed, 1), random_vec3(&seed, 1));
    for (int k = 0; k < MOTIONS; k++) ck_assert(u.of[k] == 0);
    ck_assert(motion_energy(&none, &u) == 0);
    ck_assert(vec3_length(motion_angular(&none, &u)) == 0);
    ck_assert(vec3_length(motion_at(&none, &u, random_vec3(&seed, 1))) == 0);
    motion_basis basis = none;
    motion_advance(&frame, &basis, &u, 1.0 / 60);
    motion_displace(&frame, &basis, &u, &u);
    motion_write(p, &frame, &basis, &u, 1.0 / 60);
    for (int k = 0; k < FOUR; k++) {
        // They are put at the sum of a centre and an arm.
        ck_assert(vec3_distance(p[k].position, was[k].position) <= 1e-15);
        ck_assert(vec3_distance(p[k].previous, p[k].position) == 0);
    }
}
END_TEST

// Rejects: moves without end of a body that is lost, or spins madly; a spin that
// asks for more of them than an int can hold.
START_TEST(lost_body_and_a_mad_one_are_quickly_done)
{
    const real bad[] = { (real)NAN, HUGE_VAL, -HUGE_VAL, 1e15 };
    expect_ok(rigid4_build(&f, &solid[HOUSE].plan));
    particle p[FOUR];
    stand(p);
    const rigid_frame was = rigid4_frame(p);
    for (int n = 0; n < 5000; n++)
        for (int k = 0; k < 4; k++) {
            rigid_frame frame = was;
            motion_basis b = basis_find(&f, &frame);
            motion d = { { 0 } };
            d.of[MOTION_TURN + n % TURNS] = bad[k];
            bool some = k == 3;
            if (n % 1000 == 0) frame = motion_frame(&was, &b, &d);
            ck_assert(n % 1000 || vec3_is_finite(frame.axis[0]) == some);
            frame = was;
            motion_advance(&frame, &b, &d, 1);
            ck_assert(vec3_is_finite(frame.axis[0]) == some);
        }
}
END_TEST

// Rejects: a spin that is lost where the parts of a substep are at their most.
START_TEST(wild_spin_keeps_its_angular_momentum)
{
    expect_ok(rigid4_build(&f, &solid[HOUSE].plan));
    particle p[FOUR];
    stand(p);
    for (real turn = 1; turn < 1e9; turn *= 10) {
        rigid_frame frame = rigid4_frame(p);
        motion_basis b = basis_find(&f, &frame);
        vec3 spin = vec3_scale(turn, vec3_unit(vec3_make(1, 2, 3)));
        motion u = motion_make(&b, vec3_make(1, 0, 0), spin);
        vec3 had = motion_angular(&b, &u);
        motion_advance(&frame, &b, &u, 1);
        vec3 has = motion_angular(&b, &u);
        ck_assert_msg(vec3_distance(had, has) <= 1e-12 * vec3_length(had),
                      "%g rad/s: off by %g", turn, vec3_distance(had, has));
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        basis_is_the_root_of_the_inverse_inertia,
        wild_spin_keeps_its_angular_momentum,
        box_and_ball_have_the_moments_of_the_textbook,
        motion_has_the_momentum_of_the_particles,
        motion_has_the_energy_and_spin_of_the_particles,
        impulse_changes_velocity_and_spin_as_the_textbook_says,
        six_ways_are_what_the_sticks_leave,
        momentum_and_angular_momentum_last_for_1e5_frames,
        free_spin_keeps_its_speed_and_turns_by_its_angle,
        frame_inside_a_frame_is_turned_and_moved,
        lopsided_body_precesses_with_order_two,
        what_is_displaced_keeps_its_angular_momentum,
        bent_frame_is_straightened,
        immovable_body_answers_nothing,
        lost_body_and_a_mad_one_are_quickly_done,
        NULL
    };
    return suite_run((suite){
        .name = "motion", .tests = tests, .set_up = set_up,
        .tear_down = tear_down, .seconds = 30
    });
}
