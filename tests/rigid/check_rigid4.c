// check_rigid4.c - do four particles move as the solid would?  Book: chapter
// 13.

#include <check.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

#include "capsule.h"
#include "cylinder.h"
#include "scarce.h"
#include "shake.h"
#include "solids.h"
#include "suite.h"

// --- the plan ----------------------------------------------------------------

// Is sum m x x^T of the four that of the known solid, seen through m, and are
// they centred where it is?
static void has_inertia_of(const known *k, const matrix *m, real mass)
{
    const vec3 axis[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    const vec3 column[3] = { m->x, m->y, m->z };
    vec3 mean = { 0, 0, 0 };
    real size = 0;
    for (int i = 0; i < FOUR; i++) {
        mean = vec3_add_scaled(mean, 1.0 / FOUR, f.at[i]);
        size = fmax(size, f.radius);
    }
    ck_assert(fabs(FOUR * f.mass - mass) <= ROUNDING * mass);
    ck_assert(vec3_distance(mean, f.center) <= ROUNDING * size);
    ck_assert(vec3_distance(f.center, times(m, k->center)) <= ROUNDING * size);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            real got = 0, wanted = 0;
            for (int n = 0; n < FOUR; n++) {
                vec3 r = vec3_sub(f.at[n], f.center);
                got += f.mass * vec3_dot(axis[i], r) * vec3_dot(axis[j], r);
            }
            for (int n = 0; n < 3; n++)
                wanted += mass * k->spread[n] * vec3_dot(axis[i], column[n])
                        * vec3_dot(axis[j], column[n]);
            ck_assert_msg(fabs(got - wanted) <= ROUNDING * mass * size * size,
                          "entry (%d, %d) is %.17g, wanted %.17g", i, j, got,
                          wanted);
        }
}

static void try_inertia(int i)
{
    const matrix as_it_is = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    const known *k = &solid[i];
    real mass = k->plan.mass[0] * k->plan.particles;
    expect_ok(rigid4_build(&f, &k->plan));
    has_inertia_of(k, &as_it_is, mass);
    rigid4_free(&f);
    for (int n = 0; n < 200; n++) {
        matrix m = any_affine();
        shape s;
        make_image(&s, &k->plan, &m);
        expect_ok(rigid4_build(&f, &s));
        has_inertia_of(k, &m, 3);
        rigid4_free(&f);
        shape_free(&s);
    }
}

// Rejects: the inertia of the corners instead of the solid's (2.3 to 5 times as
// much); products of inertia left out; a centre at the mean of the corners.
START_TEST(four_particles_have_mass_center_and_inertia_of_the_solid)
{
    for (int i = 0; i < SOLIDS; i++) try_inertia(i);
}
END_TEST

static void try_ride(int i)
{
    for (int n = 0; n < 100; n++) {
        matrix m = any_affine(), turn = any_rotation();
        vec3 away = random_vec3(&seed, 10), at[12], mean = { 0, 0, 0 };
        shape s;
        make_image(&s, &solid[i].plan, &m);
        expect_ok(rigid4_build(&f, &s));
        particle p[FOUR];
        for (int k = 0; k < FOUR; k++)
            p[k].position = vec3_add(away, times(&turn, f.at[k]));
        rigid_frame frame = rigid4_frame(p);
        rigid4_ride(&f, &frame, at, s.particles);
        for (int v = 0; v < s.particles; v++) {
            vec3 x = vec3_add(away, times(&turn, s.at[v]));
            ck_assert_msg(vec3_distance(at[v], x) <= ROUNDING * 20,
                          "vertex %d is %g m off", v, vec3_distance(at[v], x));
            ck_assert(vec3_distance(frame_point(&frame, f.local[v]), x)
                      <= ROUNDING * 20);
            mean = vec3_add_scaled(mean, 1.0 / s.particles, x);
        }
        ck_assert(vec3_distance(frame_point(&frame, f.middle), mean)
                  <= ROUNDING * 20);
        for (int k = 0; k < FOUR; k++)
            ck_assert(vec3_distance(vec3_add(frame.center,
                                             frame_arm(&frame, k)),
                                    p[k].position) <= ROUNDING * 20);
        rigid4_free(&f);
        shape_free(&s);
    }
}

// Rejects: coordinates of another vertex; some that hold only while the body
// stands at the origin, or is not turned; a middle of the solid, not of its
// vertices; axes in another order than the particles' signs.
START_TEST(vertices_ride_where_the_shape_has_them)
{
    for (int i = 0; i < SOLIDS; i++) try_ride(i);
}
END_TEST

static void try_sticks(int i)
{
    const shape *s = &solid[i].plan;
    expect_ok(rigid4_build(&f, s));
    int joined[FOUR][FOUR] = { { 0 } };
    for (int k = 0; k < FOUR_STICKS; k++) {
        const stick *t = &f.stick[k];
        ck_assert(t->a != t->b && t->stiffness == 1 && t->kind == STICK_EXACT);
        ck_assert_int_eq(joined[t->a][t->b]++ + joined[t->b][t->a]++, 0);
        ck_assert(fabs(vec3_distance(f.at[t->a], f.at[t->b]) - t->rest_length)
                  <= ROUNDING);
    }
    real radius = 0, reach = 0;
    for (int k = 0; k < FOUR; k++)
        radius = fmax(radius, vec3_distance(f.at[k], f.center));
    for (int v = 0; v < s->particles; v++)
        reach = fmax(reach, vec3_distance(s->at[v], f.center));
    ck_assert(fabs(f.radius - radius) <= ROUNDING);
    ck_assert(fabs(f.reach - reach) <= ROUNDING);
    rigid4_free(&f);
}

// Rejects: a stick twice, or another length than the particles have; a radius
// of the vertices, a reach of the particles, or either from the origin.
START_TEST(sticks_and_radii_are_those_of_the_particles)
{
    for (int i = 0; i < SOLIDS; i++) try_sticks(i);
}
END_TEST

// --- what cannot be built ----------------------------------------------------

static void is_empty(void)
{
    ck_assert(f.local == NULL && f.mass == 0 && f.reach == 0);
}

static void is_refused(shape *s)
{
    long before = blocks_held;
    status done = rigid4_build(&f, s);
    long after = blocks_held;
    ck_assert_msg(!done.ok, "accepted");
    ck_assert_str_eq(done.why, "a body of 8 vertices is too thin to be solid");
    ck_assert_int_eq(after, before);
    is_empty();
}

// The part of a turn that takes it elsewhere: nothing of a ball, what is across the
// axis of what is round about y, all of a box and of what has its centre elsewhere.
// Rejects: a roller that is taken for one that tumbles, or the other way round.
START_TEST(turn_about_its_own_axis_takes_nothing_elsewhere)
{
    const vec3 turn = { 0.3, 2, -0.5 }, none = { 0, 0, 0 };
    const vec3 across = { 0.3, 0, -0.5 };
    const vec3 wanted[] = { none, across, across, turn, turn };
    for (int k = 0; k < 5; k++) {
        shape s;
        if (k == 0) expect_ok(shape_sphere(&s, 0.5, 2));
        if (k == 1) expect_ok(shape_capsule(&s, 1, 0.2, 2));
        if (k > 1 && k < 4) expect_ok(shape_cylinder(&s, 1, 0.2, 2));
        if (k == 4) expect_ok(shape_box(&s, vec3_make(1, 1, 1), 2));
        if (k == 3) s.own.mass = 2;
        if (k == 3) s.own.spread[0][0] = s.own.spread[1][1] = 0.1;
        if (k == 3) s.own.spread[2][2] = 0.1;
        expect_ok(rigid4_build(&f, &s));
        rigid_frame rest = rigid4_rest(&f);
        vec3 got = rigid4_lean(&f, &rest, turn);
        ck_assert(vec3_distance(got, wanted[k]) <= ROUNDING);
        rigid4_free(&f);
        shape_free(&s);
    }
}
END_TEST

// Rejects: a division by a volume of 0, or by a pivot that is rounding's; an
// inside-out mesh taken for a solid of negative mass; NaN that no comparison
// finds.
START_TEST(body_without_volume_is_refused_with_a_sentence)
{
    shape *s = &solid[BOX].plan, thin;
    vec3 kept[8];
    for (int i = 0; i < 8; i++) kept[i] = s->at[i];
    for (int i = 0; i < 8; i++) s->at[i].y = 0;
    is_refused(s);
    for (int i = 0; i < 8; i++) s->at[i] = vec3_make(kept[i].x, 0, 0);
    is_refused(s);
    for (int i = 0; i < 8; i++) s->at[i] = vec3_make(0, 0, 0);
    is_refused(s);
    for (int i = 0; i < 8; i++) s->at[i] = vec3_scale(-1, kept[i]);
    is_refused(s);
    for (int i = 0; i < 8; i++) s->at[i] = kept[i];
    s->at[3].z = (real)NAN;
    is_refused(s);
    // A sheet a billionth as thick as wide.
    expect_ok(shape_box(&thin, vec3_make(1, 1, 1), 1));
    for (int i = 0; i < 8; i++) thin.at[i].y *= 1e-9;
    is_refused(&thin);
    shape_free(&thin);
}
END_TEST

// Rejects: an absolute limit on what is thin, or small.
START_TEST(small_and_large_bodies_are_built_alike)
{
    const real size[] = { 1e-6, 1, 1e6 };
    for (int k = 0; k < 3; k++) {
        shape s;
        real l = size[k];
        expect_ok(shape_box(&s, vec3_make(l, 1e-4 * l, 2 * l), 1));
        expect_ok(rigid4_build(&f, &s));
        vec3 at[8];
        particle p[FOUR];
        for (int i = 0; i < FOUR; i++) p[i].position = f.at[i];
        rigid_frame frame = rigid4_frame(p);
        rigid4_ride(&f, &frame, at, 8);
        for (int v = 0; v < 8; v++)
            ck_assert(vec3_distance(at[v], s.at[v]) <= ROUNDING * l);
        shape_free(&s);
        rigid4_free(&f);
    }
}
END_TEST

// Rejects: a malloc whose answer nobody looks at; a free of what is not there.
START_TEST(refused_memory_is_told_and_leaves_nothing)
{
    long before = blocks_held;
    mallocs_left = 0;
    status done = rigid4_build(&f, &solid[HOUSE].plan);
    mallocs_left = INT_MAX;
    long after = blocks_held;
    ck_assert(!done.ok);
    ck_assert_str_eq(done.why, "out of memory");
    ck_assert_int_eq(after, before);
    is_empty();
    before = blocks_held;
    done = rigid4_build(&f, &solid[HOUSE].plan);
    long built = blocks_held;
    rigid4_free(&f);
    rigid4_free(&f);
    after = blocks_held;
    expect_ok(done);
    ck_assert(built == before + 1 && after == before);
    is_empty();
}
END_TEST

// --- the six sticks, plainly ----------------------------------------------------------------

static const relax_options OLD = { ROOT_EXACT, GRADIENT_OLD, 1e-6, 0 };
static const relax_options NEW = { ROOT_EXACT, GRADIENT_NEW, 1e-6, 0 };

static real worst_strain(const particle *p)
{
    real worst = 0;
    for (int k = 0; k < FOUR_STICKS; k++) {
        real strain = stick_strain(f.stick[k], p);
        if (!(strain <= worst)) worst = strain >= 0 ? strain : HUGE_VAL;
    }
    return worst;
}

static vec3 momentum(const particle *p)
{
    vec3 sum = { 0, 0, 0 };
    for (int k = 0; k < FOUR; k++)
        sum = vec3_add_scaled(sum, f.mass,
                              vec3_sub(p[k].position, p[k].previous));
    return sum;
}

static vec3 turning(const particle *p)
{
    vec3 sum = { 0, 0, 0 };
    for (int k = 0; k < FOUR; k++)
        sum = vec3_add_scaled(sum, f.mass,
                              vec3_cross(p[k].previous, p[k].position));
    return sum;
}

// Oracle: one Newton step of the six sticks, x -= J^T (J J^T)^-1 c, along the
// sticks as they lie at o.  Returns the worst of them, measured before.
static real step_of_sticks(particle *p, const vec3 o[FOUR])
{
    const inverse answer_of = inverse_of(&f);
    real c[FOUR_STICKS], worst = 0;
    for (int s = 0; s < FOUR_STICKS; s++) {
        const stick *t = &f.stick[s];
        vec3 d = vec3_sub(p[t->b].position, p[t->a].position);
        real square = t->rest_length * t->rest_length;
        c[s] = (vec3_length_squared(d) - square) / 2;
        worst = fmax(worst, fabs(c[s]) / square);
    }
    for (int s = 0; s < FOUR_STICKS; s++) {
        particle *a = &p[f.stick[s].a], *b = &p[f.stick[s].b];
        vec3 along = vec3_sub(o[f.stick[s].b], o[f.stick[s].a]);
        real mu = 0;
        for (int u = 0; u < FOUR_STICKS; u++) mu += answer_of.at[s][u] * c[u];
        a->position = vec3_add_scaled(a->position, mu, along);
        b->position = vec3_add_scaled(b->position, -mu, along);
    }
    return worst;
}

// Both ways round in the last places of the body; the matrix of dot products
// has a condition of up to some 10^4 among these bodies.
#define SAME_STEP 1e-12

// Rejects: a frame that is not that of the particles, axes that are not
// perpendicular, a bend with the wrong share, a worst stick that is not.
START_TEST(step_of_the_frame_is_newtons_step_of_the_six_sticks)
{
    real most = 0;
    for (int n = 0; n < 2000; n++) {
        matrix m = any_affine();
        shape s;
        make_image(&s, &solid[n % SOLIDS].plan, &m);
        expect_ok(rigid4_build(&f, &s));
        particle p[FOUR], q[FOUR];
        vec3 o[FOUR];
        stand(p);
        for (int k = 0; k < FOUR; k++)
            p[k].position = vec3_add_scaled(p[k].position, 1e-3 * f.radius,
                                            random_vec3(&seed, 1));
        memcpy(q, p, sizeof q);
        for (int k = 0; k < FOUR; k++)
            o[k] = n % 2 ? p[k].previous : p[k].position;
        shake_result r = shake(&f, p, 1, n % 2 ? OLD : NEW);
        real worst = step_of_sticks(q, o), size = fmax(f.radius, 1);
        ck_assert(fabs(r.worst - worst) <= SAME_STEP * fmax(1, worst));
        for (int k = 0; k < FOUR; k++)
            most = fmax(most, vec3_distance(p[k].position, q[k].position)
                              / size);
        rigid4_free(&f);
        shape_free(&s);
    }
    printf("frame and six sticks: one step differs by %.2g of a radius\n",
           most);
    ck_assert_msg(most <= SAME_STEP, "%g", most);
}
END_TEST

// The factor depends on the body's form; of these it is at most 14.
#define SQUARED 20

// Rejects: Newton's step with a matrix of the wrong sign, place or factor: the
// error would shrink by a part only.
START_TEST(one_step_squares_the_error)
{
    real most[2] = { 0, 0 };
    for (int n = 0; n < 2000; n++) {
        expect_ok(rigid4_build(&f, &solid[n % SOLIDS].plan));
        particle p[FOUR];
        stand(p);
        real size = f.radius * (n % 5 == 0 ? 1e-2 : n % 5 == 1 ? 1e-3 : 1e-4);
        for (int k = 0; k < FOUR; k++)
            p[k].position =
                vec3_add_scaled(p[k].position, size, random_vec3(&seed, 1));
        real before = worst_strain(p);
        const relax_options *o = n % 2 ? &OLD : &NEW;
        shake_result r = shake(&f, p, 1, *o);
        real after = worst_strain(p);
        ck_assert_int_eq(r.steps, 1);
        ck_assert(fabs(r.worst - before) <= before * before);
        most[n % 2] = fmax(most[n % 2], after / (before * before));
        rigid4_free(&f);
    }
    printf("one step: strain e becomes at most %.2g e^2 (new), %.2g e^2 "
           "(old gradients)\n", most[0], most[1]);
    ck_assert_msg(most[0] <= SQUARED && most[1] <= SQUARED, "%g, %g", most[0],
                  most[1]);
}
END_TEST

// Rejects: gradients of the new places, or a step that moves the centre.
START_TEST(relaxing_keeps_momentum_and_angular_momentum)
{
    for (int n = 0; n < 1000; n++) {
        expect_ok(rigid4_build(&f, &solid[n % SOLIDS].plan));
        particle p[FOUR];
        stand(p);
        // Up to 0.15 of its radius: some bodies need several steps.
        for (int k = 0; k < FOUR; k++)
            p[k].position = vec3_add_scaled(p[k].position, 0.1 * f.radius,
                                            random_vec3(&seed, 1));
        vec3 linear = momentum(p), angular = turning(p);
        real size = FOUR * f.mass * f.radius;
        shake_result r = shake(&f, p, 20, OLD);
        ck_assert_msg(vec3_distance(momentum(p), linear) <= ROUNDING * size,
                      "momentum changed by %g",
                      vec3_distance(momentum(p), linear));
        ck_assert_msg(vec3_distance(turning(p), angular)
                      <= 1e-12 * size * fmax(f.radius, 1),
                      "angular momentum changed by %g",
                      vec3_distance(turning(p), angular));
        ck_assert(r.worst <= OLD.tolerance);
        ck_assert(worst_strain(p) <= 2 * OLD.tolerance);
        rigid4_free(&f);
    }
}
END_TEST

// 30 rad/s in 240 substeps a second are 7 degrees each.  2400 of them add their
// roundings, in the end of places 30 m from the origin.
#define SPINNING 1e-10

static void try_spin(int i)
{
    const vec3 none = { 0, 0, 0 };
    const real h = 1.0 / 240;
    expect_ok(rigid4_build(&f, &solid[i].plan));
    for (int n = 0; n < 6; n++) {
        vec3 spin = vec3_scale(30, random_direction(&seed)),
             v = vec3_scale(3, random_direction(&seed));
        particle p[FOUR];
        for (int k = 0; k < FOUR; k++) {
            vec3 r = vec3_sub(f.at[k], f.center);
            p[k] = particle_start(f.at[k], vec3_add(v, vec3_cross(spin, r)),
                                  none, 1 / f.mass, h);
        }
        vec3 linear = momentum(p), angular = turning(p);
        real worst = 0;
        for (int step = 0; step < 2400; step++) {
            verlet_step(p, FOUR, none, NULL, h);
            shake(&f, p, 6, OLD);
            worst = fmax(worst, worst_strain(p));
        }
        real turned = vec3_distance(turning(p), angular)
                    / vec3_length(angular);
        real drift = vec3_distance(momentum(p), linear) / vec3_length(linear);
        ck_assert_msg(turned <= SPINNING && drift <= SPINNING,
                      "angular momentum is off by %g, momentum by %g", turned,
                      drift);
        ck_assert_msg(worst <= OLD.tolerance, "strain %g", worst);
        ck_assert(!is_mirrored(&f, p));
    }
    rigid4_free(&f);
}

// Rejects: the brake of gradients at the new places, which takes most of the
// spin within seconds; a drift of the centre.
START_TEST(free_spin_keeps_its_momentum_for_ten_seconds)
{
    for (int i = 0; i < SOLIDS; i++) try_spin(i);
}
END_TEST

// In a random plane through their middle.
static void mirror(particle *p)
{
    vec3 middle = rigid4_frame(p).center, n = random_direction(&seed);
    for (int k = 0; k < FOUR; k++) {
        real up = vec3_dot(vec3_sub(p[k].position, middle), n);
        p[k].position = vec3_add_scaled(p[k].position, -2 * up, n);
    }
}

// Rejects: a mirror that is seen by volume in one place only, or in none.
START_TEST(mirror_image_is_known)
{
    for (int n = 0; n < 100; n++) {
        expect_ok(rigid4_build(&f, &solid[n % SOLIDS].plan));
        particle p[FOUR];
        stand(p);
        ck_assert(!is_mirrored(&f, p));
        mirror(p);
        ck_assert(is_mirrored(&f, p));
        ck_assert(worst_strain(p) <= ROUNDING);
        rigid4_free(&f);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        four_particles_have_mass_center_and_inertia_of_the_solid,
        vertices_ride_where_the_shape_has_them,
        sticks_and_radii_are_those_of_the_particles,
        free_spin_keeps_its_momentum_for_ten_seconds,
        turn_about_its_own_axis_takes_nothing_elsewhere,
        body_without_volume_is_refused_with_a_sentence,
        small_and_large_bodies_are_built_alike,
        refused_memory_is_told_and_leaves_nothing,
        step_of_the_frame_is_newtons_step_of_the_six_sticks,
        one_step_squares_the_error,
        relaxing_keeps_momentum_and_angular_momentum,
        mirror_image_is_known,
        NULL
    };
    return suite_run((suite){
        .name = "rigid4", .tests = tests, .set_up = set_up,
        .tear_down = tear_down
    });
}
