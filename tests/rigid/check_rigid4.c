// check_rigid4.c - do four particles move as the solid would?  Book: chapter
// 13.

#include <check.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

#include "scarce.h"
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

// --- relaxing ----------------------------------------------------------------

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
        rigid4_result r = rigid4_relax(&f, p, 1, n % 2 ? OLD : NEW);
        real worst = step_of_sticks(q, o), size = fmax(f.radius, 1);
        ck_assert_int_eq(r.fell_back, 0);
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
        rigid4_result r = rigid4_relax(&f, p, 1, *o);
        real after = worst_strain(p);
        ck_assert(r.iterations == 1 && r.fell_back == 0);
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
        rigid4_result r = rigid4_relax(&f, p, 20, OLD);
        ck_assert_msg(vec3_distance(momentum(p), linear) <= ROUNDING * size,
                      "momentum changed by %g",
                      vec3_distance(momentum(p), linear));
        if (!r.fell_back)
            ck_assert_msg(vec3_distance(turning(p), angular)
                          <= 1e-12 * size * fmax(f.radius, 1),
                          "angular momentum changed by %g",
                          vec3_distance(turning(p), angular));
        ck_assert(r.fell_back == 0 && r.worst <= OLD.tolerance);
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
            rigid4_result r = rigid4_relax(&f, p, 6, OLD);
            ck_assert_int_eq(r.fell_back, 0);
            worst = fmax(worst, worst_strain(p));
        }
        real turned = vec3_distance(turning(p), angular)
                    / vec3_length(angular);
        real drift = vec3_distance(momentum(p), linear) / vec3_length(linear);
        ck_assert_msg(turned <= SPINNING && drift <= SPINNING,
                      "angular momentum is off by %g, momentum by %g", turned,
                      drift);
        ck_assert_msg(worst <= OLD.tolerance, "strain %g", worst);
        ck_assert(!rigid4_is_mirrored(&f, p));
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

// Rejects: a body that is moved in spite of its pins.
START_TEST(pinned_body_is_not_relaxed)
{
    expect_ok(rigid4_build(&f, &solid[WEDGE].plan));
    particle p[FOUR], was[FOUR];
    stand(p);
    for (int k = 0; k < FOUR; k++) {
        p[k].position = vec3_add(p[k].position, random_vec3(&seed, 1));
        p[k].inverse_mass = 0;
    }
    memcpy(was, p, sizeof p);
    rigid4_result r = rigid4_relax(&f, p, 6, OLD);
    ck_assert(memcmp(was, p, sizeof p) == 0);
    ck_assert(r.iterations == 0 && r.relaxed == 0 && r.fell_back == 0);
}
END_TEST

// Rejects: a step for a body that needs none, which would never come to rest.
START_TEST(body_within_tolerance_keeps_every_bit)
{
    expect_ok(rigid4_build(&f, &solid[BOX].plan));
    for (int n = 0; n < 100; n++) {
        particle p[FOUR], was[FOUR];
        stand(p);
        memcpy(was, p, sizeof p);
        rigid4_result r = rigid4_relax(&f, p, 6, n % 2 ? OLD : NEW);
        ck_assert(memcmp(was, p, sizeof p) == 0);
        ck_assert(r.iterations == 0 && r.relaxed == 0);
        ck_assert_int_eq(r.tested, FOUR_STICKS);
    }
}
END_TEST

// Rejects: one step more or less than was asked for; a count of sticks that is
// not that of the steps.
START_TEST(steps_are_counted_and_capped)
{
    const relax_options never = { ROOT_EXACT, GRADIENT_OLD, 0, 0 };
    expect_ok(rigid4_build(&f, &solid[HOUSE].plan));
    for (int steps = 1; steps < 6; steps++) {
        particle p[FOUR];
        stand(p);
        p[1].position =
            vec3_add_scaled(p[1].position, 0.02, random_direction(&seed));
        rigid4_result r = rigid4_relax(&f, p, steps, never);
        ck_assert_int_le(r.iterations, steps);
        if (steps < 3) ck_assert_int_eq(r.iterations, steps);
        ck_assert_int_eq(r.relaxed, FOUR_STICKS * r.iterations);
        ck_assert_int_ge(r.tested, r.relaxed);
    }
}
END_TEST

// Swollen by 6 %, more than counts as bent: (s^2 - 1) / 2 is 0.0618.  A step
// leaves s - (s^2 - 1) / 2 = 0.9982, the next one 1 - 1.6e-6.
// Rejects: a body judged by how it came, or by its last step alone; one that
// may stay bent, because a wide tolerance is taken as it is.
START_TEST(bent_body_is_judged_when_its_steps_are_done)
{
    const relax_options wide = { ROOT_EXACT, GRADIENT_OLD, 0.1, 0 };
    const real left[3] = { 1.8e-3, 1.8e-3, 1.6e-6 };
    expect_ok(rigid4_build(&f, &solid[HOUSE].plan));
    for (int steps = 0; steps < 3; steps++) {
        particle p[FOUR];
        stand(p);
        vec3 middle = { 0, 0, 0 };
        for (int k = 0; k < FOUR; k++)
            middle = vec3_add_scaled(middle, 1.0 / FOUR, p[k].position);
        for (int k = 0; k < FOUR; k++)
            p[k].position = vec3_add_scaled(p[k].position, 0.06,
                vec3_sub(p[k].position, middle));
        rigid4_result r = steps == 0 ? rigid4_relax(&f, p, 1, wide)
                                    : rigid4_relax(&f, p, steps, OLD);
        ck_assert_int_eq(r.fell_back, 0);
        ck_assert_int_eq(r.iterations, steps > 0 ? steps : 1);
        ck_assert_msg(fabs(r.worst - left[steps]) <= 0.02 * left[steps],
                      "%d steps leave %g", steps, r.worst);
    }
}
END_TEST

// --- violence ----------------------------------------------------------------

enum { SCATTERED, CRUSHED, PRESSED, MIRRORED, PIERCED, FLUNG, TINY, WRECKS };

// m, nearly the largest double.
#define LIMIT 1.7e308

// What may become of the particles in a step; they stood well before it.
static void wreck(particle *p, int kind)
{
    vec3 mean = { 0, 0, 0 }, n = random_direction(&seed);
    for (int k = 0; k < FOUR; k++)
        mean = vec3_add_scaled(mean, 1.0 / FOUR, p[k].position);
    for (int k = 0; k < FOUR; k++) {
        vec3 *x = &p[k].position, d = vec3_sub(*x, mean);
        real up = vec3_dot(d, n);
        switch (kind) {
        case SCATTERED: *x = random_vec3(&seed, 5 * f.radius); break;
        case CRUSHED:   *x = mean; break;
        case PRESSED:   *x = vec3_add_scaled(*x, -up, n); break;
        case MIRRORED:  *x = vec3_add_scaled(*x, -2 * up, n); break;
        case PIERCED:   if (k == 0) *x = vec3_add_scaled(mean, -2, d); break;
        case FLUNG:     *x = random_vec3(&seed, LIMIT); break;
        default:        *x = vec3_add_scaled(mean, 1e-200, d); break;
        }
    }
}

// A body that was straight a step ago is never left bent or mirrored.
// (So far away that a body has no size it need only be somewhere.)
static void is_sound(const particle *p, const char *what)
{
    real far = 0;
    for (int k = 0; k < FOUR; k++) {
        ck_assert_msg(vec3_is_finite(p[k].position), "%s: lost", what);
        far = fmax(far, fabs(p[k].position.x));
    }
    if (far > 1e12) return;
    ck_assert_msg(!rigid4_is_mirrored(&f, p), "%s: mirrored", what);
    ck_assert_msg(worst_strain(p) <= 0.01, "%s: strain %g", what,
                  worst_strain(p));
}

static void try_wreck(int i)
{
    static const char *const name[WRECKS] = { "scattered", "crushed",
        "pressed flat", "mirrored", "pierced", "flung away", "tiny" };
    for (int n = 0; n < 300 * SOLIDS; n++) {
        expect_ok(rigid4_build(&f, &solid[n % SOLIDS].plan));
        particle p[FOUR];
        stand(p);
        wreck(p, i);
        rigid4_relax(&f, p, 6, n % 8 < 4 ? OLD : NEW);
        is_sound(p, name[i]);
        rigid4_free(&f);
    }
}

// Rejects: Newton's iteration trusted where it finds the mirror image, or
// nothing at all; a mirror that has no strain taken for a body at rest.
START_TEST(whatever_happens_to_a_body_it_is_never_mirrored_nor_lost)
{
    for (int i = 0; i < WRECKS; i++) try_wreck(i);
}
END_TEST

static void try_plate(int i)
{
    shape plate;
    // A tenth to an eightieth as thick as wide.
    expect_ok(shape_box(&plate, vec3_make(1, 1.0 / (10 << i), 1), 1));
    expect_ok(rigid4_build(&f, &plate));
    shape_free(&plate);
    for (int n = 0; n < 400; n++) {
        particle p[FOUR];
        matrix turn = stand(p);
        real share = n % 4 == 0 ? 2 : 1.5 + random_real(&seed) / 2;
        for (int k = 0; k < FOUR; k++) {
            real up = vec3_dot(vec3_sub(p[k].position, p[0].position), turn.y);
            p[k].position = vec3_add_scaled(p[k].position, -share * up, turn.y);
        }
        rigid4_relax(&f, p, 6, n % 2 ? OLD : NEW);
        is_sound(p, "plate");
    }
    rigid4_free(&f);
}

// In a plate a particle that goes through the plane of the others changes no
// stick by much: (2 t / L)^2 / 2.
// Rejects: a small strain taken for a small error.
START_TEST(thin_plate_is_never_mirrored)
{
    for (int i = 0; i < 4; i++) try_plate(i);
}
END_TEST

// Rejects: an endless loop over NaN, or a crash; a fall back that is not told.
START_TEST(lost_numbers_are_told_and_do_no_harm)
{
    const real bad[] = { (real)NAN, HUGE_VAL, -HUGE_VAL };
    expect_ok(rigid4_build(&f, &solid[BALL].plan));
    for (int k = 0; k < 3 * FOUR; k++) {
        particle p[FOUR];
        vec3 at[12];
        stand(p);
        p[k % FOUR].position.y = bad[k / FOUR];
        rigid4_result r = rigid4_relax(&f, p, 6, OLD);
        ck_assert_int_eq(r.fell_back, 1);
        rigid_frame frame = rigid4_frame(p);
        rigid4_ride(&f, &frame, at, 12);
    }
}
END_TEST

// --- many at once ------------------------------------------------------------

// Rejects: a body that goes on after it is content, or stops with its
// neighbour; one that is pinned, bent, mirrored or lost and treated as others;
// one that lies still, whose old places are no numbers, moved by them;
// the last few of a list left out; counts of one body for those of all.
START_TEST(bodies_relaxed_together_get_the_bits_of_each_alone)
{
    enum { MOST = 11 };
    const real bad[] = { (real)NAN, HUGE_VAL };
    particle one[MOST * FOUR], all[MOST * FOUR];
    for (int n = 0; n < 2000; n++) {
        int bodies = 1 + n % MOST, steps = 1 + n % 6;
        const relax_options *o = n % 5 ? &OLD : &NEW;
        rigid4_result sum = { .worst = 0 };
        int first[MOST];
        expect_ok(rigid4_build(&f, &solid[n % SOLIDS].plan));
        for (int b = 0; b < bodies; b++) {
            particle *p = one + b * FOUR;
            first[(b + n) % bodies] = b * FOUR;
            int kind = (int)(12 * (random_real(&seed) + 1));
            stand(p);
            for (int k = 0; k < FOUR && kind > 2 && kind != 5; k++)
                p[k].position = vec3_add_scaled(p[k].position, 0.05 * f.radius
                                                * (random_real(&seed) + 1),
                                                random_vec3(&seed, 1));
            for (int k = 0; k < FOUR && kind == 1; k++) p[k].inverse_mass = 0;
            if (kind == 2) wreck(p, n % WRECKS);
            if (kind == 3) p[n % FOUR].position.z = bad[n % 2];
            if (kind == 4 || kind == 5) p[n % FOUR].previous.x = bad[n % 2];
        }
        memcpy(all, one, sizeof one);
        for (int b = 0; b < bodies; b++) {
            rigid4_result r = rigid4_relax(&f, one + b * FOUR, steps, *o);
            sum.tested += r.tested;
            sum.relaxed += r.relaxed;
            sum.fell_back += r.fell_back;
            if (r.iterations > sum.iterations) sum.iterations = r.iterations;
            sum.worst = fmax(sum.worst, r.worst);
        }
        rigid4_result r = rigid4_relax_all(&f, all, first, bodies, steps, *o);
        ck_assert(memcmp(one, all, (size_t)bodies * FOUR * sizeof *one) == 0);
        ck_assert(r.tested == sum.tested && r.relaxed == sum.relaxed);
        ck_assert(r.iterations == sum.iterations);
        ck_assert(r.fell_back == sum.fell_back);
        ck_assert(r.worst == sum.worst);
        rigid4_free(&f);
    }
}
END_TEST

// A needle a thousand times as long as thick, as it was and as it is now.
typedef struct {
    shape plan;
    rigid_frame was, bad;
} bent_needle;

// One thickness is wrong, and the other as well, so that the two short sticks
// have their lengths: the long ones hardly tell.
static void bend_needle(bent_needle *x, int thin, particle *p)
{
    real side[3] = { 1, 1, 1 };
    side[thin] = 2e-3;
    side[(thin + 1) % 3] = 1e-3;
    expect_ok(shape_box(&x->plan, vec3_make(side[0], side[1], side[2]), 1));
    expect_ok(rigid4_build(&f, &x->plan));
    stand(p);
    x->was = x->bad = rigid4_frame(p);
    for (int i = 0; i < FOUR_AXES; i++)
        if (f.square[i] < 1e-6)
            x->bad.axis[i] = vec3_scale(f.square[i] < 1.5e-7 ? 1.8 : sqrt(0.44),
                                        x->was.axis[i]);
    x->bad.center = vec3_add(x->was.center, random_vec3(&seed, 1));
    for (int k = 0; k < FOUR; k++)
        p[k].position = vec3_add(x->bad.center, frame_arm(&x->bad, k));
    ck_assert(worst_strain(p) <= 1e-5);
}

static void expect_axes(const bent_needle *x, const particle *p, real most)
{
    rigid_frame now = rigid4_frame(p);
    for (int i = 0; i < FOUR_AXES; i++) {
        real off = vec3_distance(now.axis[i], x->was.axis[i])
                 / vec3_length(x->was.axis[i]);
        ck_assert_msg(off <= most, "axis %d is off by %g", i, off);
    }
    ck_assert(vec3_distance(now.center, x->bad.center) <= ROUNDING);
}

// One step does not mend it: it is put back.  Six do.
// Rejects: a body judged by its sticks alone; one that is put back bent.
START_TEST(needle_is_judged_by_its_axes)
{
    const relax_options exact = { ROOT_EXACT, GRADIENT_OLD, 1e-12, 0 };
    for (int n = 0; n < 100; n++) {
        bent_needle x;
        particle p[FOUR];
        int steps = n % 2 ? 1 : 6;
        bend_needle(&x, n % 3, p);
        rigid4_result r = rigid4_relax(&f, p, steps, exact);
        ck_assert_int_eq(r.fell_back, steps == 1);
        expect_axes(&x, p, 1e-4);
        rigid4_free(&f);
        shape_free(&x.plan);
    }
}
END_TEST

// Rejects: sticks within their tolerance that leave a body as thick as it
// likes: what its moment of inertia is said to be, and is not, made it turn
// faster and faster.
START_TEST(needle_is_straight_whatever_the_tolerance)
{
    for (int n = 0; n < 12; n++) {
        const real tolerance[] = { 1, 0.05, 1e-3, 1e-5 };
        relax_options rough = { ROOT_EXACT, GRADIENT_OLD, tolerance[n / 3], 0 };
        bent_needle x;
        particle p[FOUR];
        bend_needle(&x, n % 3, p);
        rigid4_result r = rigid4_relax(&f, p, 6, rough);
        ck_assert(r.worst <= 5e-8 && r.fell_back == 0);
        expect_axes(&x, p, 0.1);
        rigid4_free(&f);
        shape_free(&x.plan);
    }
}
END_TEST

// Bent a step ago as now: nothing to go back to but its directions.
// Rejects: a body that is put back bent, and stays so for ever.
START_TEST(body_that_was_bent_is_put_back_straight)
{
    for (int n = 0; n < 200; n++) {
        expect_ok(rigid4_build(&f, &solid[n % SOLIDS].plan));
        particle p[FOUR];
        stand(p);
        for (int k = 0; k < FOUR; k++) {
            p[k].previous = vec3_add_scaled(p[k].previous, 0.2 * f.radius,
                                            random_vec3(&seed, 1));
            p[k].position = random_vec3(&seed, 5 * f.radius);
        }
        rigid4_result r = rigid4_relax(&f, p, 1, OLD);
        if (r.fell_back) ck_assert(worst_strain(p) <= ROUNDING && r.worst == 0);
        ck_assert(!rigid4_is_mirrored(&f, p));
        rigid4_free(&f);
    }
}
END_TEST

// Rejects: a mirror that is seen by volume in one place only, or in none.
START_TEST(mirror_image_is_known)
{
    for (int n = 0; n < 100; n++) {
        expect_ok(rigid4_build(&f, &solid[n % SOLIDS].plan));
        particle p[FOUR];
        stand(p);
        ck_assert(!rigid4_is_mirrored(&f, p));
        wreck(p, MIRRORED);
        ck_assert(rigid4_is_mirrored(&f, p));
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
        body_without_volume_is_refused_with_a_sentence,
        small_and_large_bodies_are_built_alike,
        refused_memory_is_told_and_leaves_nothing,
        step_of_the_frame_is_newtons_step_of_the_six_sticks,
        one_step_squares_the_error,
        relaxing_keeps_momentum_and_angular_momentum,
        pinned_body_is_not_relaxed,
        body_within_tolerance_keeps_every_bit,
        steps_are_counted_and_capped,
        bent_body_is_judged_when_its_steps_are_done,
        lost_numbers_are_told_and_do_no_harm,
        bodies_relaxed_together_get_the_bits_of_each_alone,
        needle_is_judged_by_its_axes,
        needle_is_straight_whatever_the_tolerance,
        body_that_was_bent_is_put_back_straight,
        mirror_image_is_known,
        whatever_happens_to_a_body_it_is_never_mirrored_nor_lost,
        thin_plate_is_never_mirrored,
        NULL
    };
    return suite_run((suite){
        .name = "rigid4", .tests = tests, .set_up = set_up,
        .tear_down = tear_down
    });
}
