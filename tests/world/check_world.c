// check_world.c - does a world start as it was told to?  Book: chapter 9.

#include <check.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "convex.h"
#include "scarce.h"
#include "stage.h"
#include "suite.h"
#include "world.h"

// A position is a sum of four products, its previous one of two more.
#define ROUNDING 1e-14

// --- a world and its shapes --------------------------------------------------

static shape box, ball, cloth, rope;

static void set_up(void)
{
    ck_assert(shape_box(&box, vec3_make(1, 2, 3), 6).ok);
    ck_assert(shape_icosahedron(&ball, 0.5, 2).ok);
    ck_assert(shape_cloth(&cloth, 5, 4, 2, 1.5, 1, 0.2).ok);
    ck_assert(shape_rope(&rope, 7, 3.5, 0.4).ok);
    ck_assert(world_init(&w, world_options_default()).ok);
}

static void tear_down(void)
{
    world_free(&w);
    shape_free(&box);
    shape_free(&ball);
    shape_free(&cloth);
    shape_free(&rope);
}

// A third of a turn about (1, 1, 1), then some: no axis is its own.
static placement slanted(void)
{
    placement p = placement_at(vec3_make(3, -2, 5));
    p.x = vec3_make(0.6, 0, 0.8);
    p.y = vec3_make(-0.48, 0.8, 0.36);
    p.z = vec3_make(-0.64, -0.6, 0.48);
    return p;
}

// --- options -----------------------------------------------------------------

// One option, made bad or extreme.
typedef struct {
    const char *name;
    real least, most;
} range;

// The whole numbers first, then the choices by name, then the rest.
static const range RANGE[] = {
    { "substeps", 0, 10000 }, { "most_substeps", 1, 10000 },
    { "iterations", 1, 10000 },
    { "root", 0, ROOT_APPROXIMATE }, { "gradient", 0, GRADIENT_OLD },
    { "dt", 1e-9, 1 }, { "tolerance", 0, 1 }, { "friction", 0, 1000 },
    { "restitution", 0, 1 }, { "hertz", 1e-3, 1e6 }, { "stay", 0, 0.1 },
    { "sleep_speed", 0, 1e9 }, { "time_to_sleep", 0, 1e9 },
};
enum { RANGES = sizeof RANGE / sizeof *RANGE, WHOLE = 3, CHOICES = 2,
       INTEGERS = WHOLE + CHOICES };

static bool is_integer(int k)
{
    return k < INTEGERS;
}

static void set_choice(world_options *o, int k, int value)
{
    switch (k) {
    case 0: o->relax.root = (root_kind)value; break;
    case 1: o->relax.gradient = (gradient_kind)value; break;
    default: ck_abort();
    }
}

static void set_option(world_options *o, int k, real value)
{
    int *const whole[] = { &o->substeps, &o->most_substeps, &o->iterations };
    real *const number[] = { &o->dt, &o->relax.tolerance, &o->friction,
        &o->restitution, &o->hertz, &o->stay, &o->sleep_speed,
        &o->time_to_sleep };
    if (k < WHOLE)           *whole[k] = (int)value;
    else if (is_integer(k))  set_choice(o, k - WHOLE, (int)value);
    else                     *number[k - INTEGERS] = value;
}

static void refused(world_options o, const char *name)
{
    world bad;
    status done = world_init(&bad, o);
    ck_assert_msg(!done.ok, "%s was not refused", name);
    size_t n = strlen(name);
    ck_assert_msg(strncmp(done.why, name, n) == 0
                  && strncmp(done.why + n, " is ", 4) == 0,
                  "%s: the sentence is: %s", name, done.why);
    world_free(&bad);
}

// Rejects: a range that is open at one end; NaN, which is neither below the
// least nor above the most; a choice that no enum has, taken for another one; a
// sentence that names another option.
START_TEST(options_out_of_range_are_refused_by_name)
{
    for (int k = 0; k < RANGES; k++) {
        real step = is_integer(k) ? 1 : 1e-6 * RANGE[k].most;
        real least = RANGE[k].least;
        real low = is_integer(k) || !(least > 0) ? least - step : 0.9 * least;
        const real bad[] = { low, -HUGE_VAL, RANGE[k].most + step, HUGE_VAL,
                             (real)NAN };
        for (int i = 0; i < 5; i++) {
            world_options o = world_options_default();
            if (is_integer(k) && !(bad[i] - bad[i] == 0)) continue;
            set_option(&o, k, bad[i]);
            refused(o, RANGE[k].name);
        }
    }
    const real bad[] = { HUGE_VAL, -HUGE_VAL, (real)NAN };
    for (int i = 0; i < 3; i++) {
        world_options o = world_options_default();
        o.gravity.z = bad[i];
        refused(o, "gravity");
    }
}
END_TEST

// Rejects: a limit that is itself refused.
START_TEST(limits_of_the_options_are_allowed)
{
    for (int k = 0; k < RANGES; k++)
        for (int side = 0; side < 2; side++) {
            world_options o = world_options_default();
            set_option(&o, k, side ? RANGE[k].most : RANGE[k].least);
            world fine;
            status done = world_init(&fine, o);
            ck_assert_msg(done.ok, "%s", done.why);
            world_free(&fine);
        }
}
END_TEST

// Rejects: a default that is not what its comment says.
START_TEST(defaults_are_as_documented)
{
    world_options o = world_options_default();
    ck_assert(o.dt == 1.0 / 60 && o.substeps == 0);
    near_vec3(o.gravity, vec3_make(0, -9.81, 0), 0);
    ck_assert(o.friction == 0.5 && o.restitution == 0);
    ck_assert_int_gt(o.most_substeps, o.substeps);
    ck_assert(o.warm_start && o.sleep_speed > 0 && o.time_to_sleep == 0.5);
    ck_assert(!o.host.clock && !o.host.run.run && !o.ledger);
}
END_TEST

// --- bodies ------------------------------------------------------------------

// Rejects: axes taken as rows; a shape that is not turned about its middle;
// vertices that do not ride with the four particles.
START_TEST(vertices_stand_where_the_axes_say)
{
    placement p = slanted();
    begin(world_options_default());
    add(&ball, placement_at(vec3_make(0, 0, 0)));
    add(&box, p);
    const body *b = &w.body[1];
    ck_assert_int_eq(b->first, FOUR);
    ck_assert_int_eq(body_particles(b), FOUR);
    for (int i = 0; i < box.particles; i++) {
        vec3 r = box.at[i], d = vec3_sub(vertex_of(1, i), p.position);
        ck_assert(fabs(vec3_dot(d, p.x) - r.x) <= ROUNDING * 10);
        ck_assert(fabs(vec3_dot(d, p.y) - r.y) <= ROUNDING * 10);
        ck_assert(fabs(vec3_dot(d, p.z) - r.z) <= ROUNDING * 10);
    }
}
END_TEST

// Rejects: the velocity over a frame instead of a substep; a spin of the wrong
// sense; a start that forgets half a step of gravity.
START_TEST(particles_start_with_velocity_and_spin)
{
    placement p = slanted();
    p.velocity = vec3_make(1, 2, 3);
    p.spin = vec3_make(0, 0, 4);
    begin(world_options_default());
    add(&box, p);
    real h = w.options.dt / w.options.substeps;
    for (int i = 0; i < body_particles(&w.body[0]); i++) {
        const particle *x = &w.pool.at[i];
        vec3 r = vec3_sub(x->position, p.position);
        vec3 v = vec3_make(1 - 4 * r.y, 2 + 4 * r.x, 3);
        vec3 was = vec3_add_scaled(x->position, -h, v);
        was = vec3_add_scaled(was, h * h / 2, w.options.gravity);
        near_vec3(x->previous, was, ROUNDING);
    }
}
END_TEST

// A pyramid 4 m high: the mean of its corners is 0.8 m above its base, the
// centre of its solid 1 m.  Thrown with a spin, its momentum is that of this
// centre, its angular momentum that of the solid about it.
// Rejects: a spin about the corners' mean, which would throw the solid aside; a
// spin of the corners' inertia.
START_TEST(lopsided_body_spins_about_the_centre_of_its_solid)
{
    const vec3 at[5] = { { -1, 0, -1 }, { 1, 0, -1 }, { 1, 0, 1 }, { -1, 0, 1 },
                         { 0, 4, 0 } };
    const int face[6][3] = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 4, 1 }, { 1, 4, 2 },
                             { 2, 4, 3 }, { 3, 4, 0 } };
    shape pyramid;
    ck_assert(shape_convex(&pyramid, 5, at, 6, face, 12).ok);
    placement p = slanted();
    p.velocity = vec3_make(1, 2, 3);
    p.spin = vec3_add(vec3_scale(2, p.x), vec3_add(vec3_scale(-3, p.y),
                                                   vec3_scale(4, p.z)));
    world_options o = world_options_default();
    o.gravity = vec3_make(0, 0, 0);
    begin(o);
    add(&pyramid, p);
    real h = w.options.dt / w.options.substeps;
    vec3 sum = { 0, 0, 0 }, center = { 0, 0, 0 }, turning = { 0, 0, 0 };
    for (int k = 0; k < FOUR; k++) {
        const particle *x = &w.pool.at[k];
        ck_assert(fabs(1 / x->inverse_mass - 3) <= 3 * ROUNDING);
        center = vec3_add_scaled(center, 0.25, x->position);
        sum = vec3_add_scaled(sum, 3 / h, vec3_sub(x->position, x->previous));
    }
    for (int k = 0; k < FOUR; k++) {
        const particle *x = &w.pool.at[k];
        vec3 r = vec3_sub(x->position, center);
        vec3 v = vec3_scale(1 / h, vec3_sub(x->position, x->previous));
        turning = vec3_add_scaled(turning, 3, vec3_cross(r, v));
    }
    near_vec3(sum, vec3_scale(12, p.velocity), 1e-10);
    near_vec3(center, vec3_add_scaled(p.position, 0.2, p.y), 10 * ROUNDING);
    // The mean of x^2 and z^2 is 2^2 / 20, that of y^2 3 * 4^2 / 80.
    const real across = 0.2, up = 0.6;
    vec3 l = { 12 * (up + across) * 2, 12 * (across + across) * -3,
               12 * (across + up) * 4 };
    vec3 wanted = vec3_add(vec3_scale(l.x, p.x), vec3_add(
        vec3_scale(l.y, p.y), vec3_scale(l.z, p.z)));
    near_vec3(turning, wanted, 1e-10);
    world_free(&w);
    shape_free(&pyramid);
}
END_TEST

// Rejects: a total mass on every particle; inverse masses not inverted.
START_TEST(masses_are_those_of_the_shape)
{
    begin(world_options_default());
    add(&box, placement_at(vec3_make(0, 0, 0)));
    add(&cloth, placement_at(vec3_make(0, 5, 0)));
    ck_assert(fabs(w.body[0].mass - 6) <= ROUNDING * 6);
    ck_assert(fabs(w.body[1].mass - 1) <= ROUNDING);
    int n = body_particles(&w.body[0]);
    for (int i = 0; i < n; i++)
        ck_assert(w.pool.at[i].inverse_mass == 4 / 6.0);
    for (int i = 0; i < cloth.particles; i++)
        ck_assert(w.pool.at[n + i].inverse_mass == 1 / cloth.mass[i]);
    ck_assert_int_eq(w.softs, 1);
    ck_assert(!body_is_soft(&w.body[0]) && body_is_soft(&w.body[1]));
    ck_assert(w.body[1].rigid == NULL && w.body[0].rigid != NULL);
}
END_TEST

// Rejects: a static body that drifts because it was given a velocity; one with
// a finite mass, which an impulse would be shared with.
START_TEST(static_body_is_immovable_and_at_rest)
{
    placement p = slanted();
    p.velocity = vec3_make(9, 9, 9);
    p.spin = vec3_make(9, 9, 9);
    p.is_static = 1;
    begin(world_options_default());
    add(&box, p);
    ck_assert(w.body[0].mass == HUGE_VAL && body_is_static(&w.body[0]));
    for (int i = 0; i < body_particles(&w.body[0]); i++) {
        ck_assert(w.pool.at[i].inverse_mass == 0);
        near_vec3(w.pool.at[i].previous, w.pool.at[i].position, 0);
    }
}
END_TEST

// Rejects: a pin in the pool's particle of that number instead of the body's;
// one that keeps the particle's velocity.
START_TEST(pin_holds_one_particle_of_its_body)
{
    placement p = placement_at(vec3_make(0, 1, 0));
    p.velocity = vec3_make(0, 0, 1);
    begin(world_options_default());
    add(&ball, p);
    add(&rope, p);
    world_pin(&w, 1, 2);
    int first = w.body[1].first;
    for (int i = 0; i < w.pool.count; i++) {
        const particle *x = &w.pool.at[i];
        bool pinned = i == first + 2;
        ck_assert_int_eq(x->inverse_mass == 0, pinned);
        ck_assert_int_eq(vec3_distance(x->position, x->previous) == 0, pinned);
    }
    ck_assert(!body_is_static(&w.body[1]));
    ck_assert(w.inverse_mass[first + 2] == 0);
    ck_assert(w.inverse_mass[first + 1] > 0);
}
END_TEST

// Rejects: a body of no volume that gets four particles all the same; a shape
// that is entered although it was refused.
START_TEST(body_too_thin_for_four_particles_is_refused)
{
    shape sheet;
    ck_assert(shape_box(&sheet, vec3_make(1, 1, 1), 1).ok);
    for (int i = 0; i < sheet.particles; i++) sheet.at[i].y = 0;
    add(&ball, placement_at(vec3_make(0, 0, 0)));
    int number = -7;
    status done = world_add(&w, &sheet, placement_at(vec3_make(0, 5, 0)),
                            &number);
    ck_assert(!done.ok && strstr(done.why, "too thin"));
    ck_assert(w.bodies == 1 && w.shapes == 1 && number == -7);
    ck_assert_int_eq(w.pool.count, FOUR);
    world_free(&w);
    shape_free(&sheet);
}
END_TEST

static void misplaced(placement p, const char *what)
{
    int bodies = w.bodies, count = w.pool.count, number = -7;
    status done = world_add(&w, &box, p, &number);
    ck_assert_msg(!done.ok, "%s was accepted", what);
    ck_assert(strstr(done.why, "body 1") && strstr(done.why, "perpendicular"));
    ck_assert(w.bodies == bodies && w.pool.count == count && number == -7);
}

// Rejects: axes of which one is never measured; a left-handed body, which is
// its mirror image; NaN, which no comparison finds.
START_TEST(placement_must_be_finite_and_orthonormal)
{
    add(&ball, placement_at(vec3_make(0, 0, 0)));
    const real bad[] = { (real)NAN, HUGE_VAL, -HUGE_VAL };
    for (int k = 0; k < 18; k++)
        for (int i = 0; i < 3; i++) {
            placement p = placement_at(vec3_make(0, 0, 0));
            vec3 *v[6] = { &p.position, &p.x, &p.y, &p.z, &p.velocity,
                           &p.spin };
            real *at[3] = { &v[k / 3]->x, &v[k / 3]->y, &v[k / 3]->z };
            *at[k % 3] = bad[i];
            misplaced(p, "a number that is not finite");
        }
    for (int k = 1; k < 8; k++)
        for (int i = 0; i < 2; i++) {
            real s = i ? 2 : 0.999;
            placement p = slanted();
            if (k & 1) p.x = vec3_scale(s, p.x);
            if (k & 2) p.y = vec3_scale(s, p.y);
            if (k & 4) p.z = vec3_scale(s, p.z);
            misplaced(p, "an axis that is no unit");
        }
    placement p = slanted();
    p.z = vec3_scale(-1, p.z);
    misplaced(p, "a left-handed frame");
    p = slanted();
    p.y = vec3_unit(vec3_add_scaled(p.y, 0.01, p.x));
    misplaced(p, "an oblique frame");
    p.z = vec3_cross(p.x, p.y);
    misplaced(p, "an oblique frame whose z is across");
    p = (placement){ .position = { 0, 0, 0 } };
    misplaced(p, "no frame");
    add(&box, slanted());
}
END_TEST

// Rejects: an array that forgets its bodies when it grows; a shape counted
// once for every body.
START_TEST(many_bodies_share_their_shapes)
{
    enum { MANY = 100 };
    begin(world_options_default());
    for (int k = 0; k < MANY; k++) {
        int number = -1;
        const shape *s = k % 3 ? &ball : &box;
        ck_assert(world_add(&w, s, placement_at(vec3_make(k, 0, 0)),
                            &number).ok);
        ck_assert_int_eq(number, k);
    }
    ck_assert_int_eq(w.bodies, MANY);
    ck_assert_int_eq(w.shapes, 2);
    int first = 0;
    for (int k = 0; k < MANY; k++) {
        const body *b = &w.body[k];
        ck_assert_ptr_eq(b->shape, k % 3 ? &ball : &box);
        ck_assert_int_eq(b->first, first);
        ck_assert_ptr_eq(b->rigid, w.body[k % 3 ? 1 : 0].rigid);
        near_vec3(vertex_of(k, 0),
                  vec3_add(b->shape->at[0], vec3_make(k, 0, 0)),
                  ROUNDING * (k + 10));
        first += body_particles(b);
    }
    ck_assert_int_eq(w.pool.count, first);
}
END_TEST

// --- planes ------------------------------------------------------------------

// Rejects: a normal that is left as long as it was given, or an offset that is
// not shortened with it.
START_TEST(planes_are_kept_with_unit_normals)
{
    ck_assert(world_add_plane(&w, vec3_make(0, 5, 0), 10).ok);
    ck_assert(world_add_plane(&w, vec3_make(3, 0, -4), -5).ok);
    ck_assert_int_eq(w.planes, 2);
    near_vec3(w.plane[0].normal, vec3_make(0, 1, 0), ROUNDING);
    ck_assert(fabs(w.plane[0].offset - 2) <= ROUNDING);
    near_vec3(w.plane[1].normal, vec3_make(0.6, 0, -0.8), ROUNDING);
    ck_assert(fabs(w.plane[1].offset + 1) <= ROUNDING);
}
END_TEST

// Rejects: a seventh plane that is written over what follows.
START_TEST(world_has_as_many_planes_as_one_likes)
{
    for (int k = 0; k < 100; k++)
        ck_assert(world_add_plane(&w, vec3_make(0, 1, 0), -k).ok);
    ck_assert_int_eq(w.planes, 100);
    for (int k = 0; k < 100; k++) ck_assert(w.plane[k].offset == -k);
}
END_TEST

// Rejects: a normal without direction; one so long that its length overflows
// and leaves none; an offset that is not finite, or so large that the cloth which
// it pushes is lost (NaN).
START_TEST(plane_without_a_finite_normal_and_offset_is_refused)
{
    const struct { vec3 normal; real offset; } bad[] = {
        { { 0, 0, 0 }, 0 }, { { (real)NAN, 1, 0 }, 0 },
        { { 0, HUGE_VAL, 0 }, 0 }, { { 0, 1, 0 }, (real)NAN },
        { { 0, 1, 0 }, HUGE_VAL }, { { 0, 1, 0 }, -HUGE_VAL },
        { { 0, 1e200, 0 }, 1 }, { { 0, 1e-10, 0 }, 1e300 },
        { { 0.5, 4, 1.5 }, 1e300 }, { { 0, 1, 0 }, -1e61 },
    };
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        status done = world_add_plane(&w, bad[k].normal, bad[k].offset);
        ck_assert_msg(!done.ok, "plane %d was accepted", (int)k);
        ck_assert(done.why[0] != 0);
        ck_assert_int_eq(w.planes, 0);
    }
}
END_TEST

// --- begin, look, free -------------------------------------------------------

// Rejects: tables in the wrong order; a body that stands where its shape does,
// at the origin: a static one is never looked at again, so that everything
// would fall through it; a deformable body among the rigid ones.
START_TEST(world_has_everything_in_its_place)
{
    placement still = slanted();
    still.is_static = true;
    begin(world_options_default());
    add(&box, still);
    add(&ball, placement_at(vec3_make(0, 9, 0)));
    add(&cloth, placement_at(vec3_make(8, 9, 0)));
    for (int i = 0; i < w.pool.count; i++)
        ck_assert(w.inverse_mass[i] == w.pool.at[i].inverse_mass);
    for (int b = 0; b < 2; b++) {
        const sphere *around = probe_ball(&w, b);
        ck_assert_int_eq(probe_is_dynamic(&w, b), b == 1);
        near_vec3(probe_start(&w, b)->frame.center,
                  b ? vec3_make(0, 9, 0) : still.position, 10 * ROUNDING);
        for (int i = 0; i < w.body[b].shape->particles; i++)
            ck_assert(vec3_distance(around->center, vertex_of(b, i))
                      <= around->radius);
        ck_assert(around->radius <= 1.1 * w.body[b].shape->radius);
    }
    ck_assert(probe_ball(&w, 2)->radius < 0);
    ck_assert(!probe_is_dynamic(&w, 2) && !probe_is_rigid(&w, 2));
}
END_TEST

// Rejects: leaves of a tree that are not a deformable body's particles; a tree
// for a rigid body, which needs none.
START_TEST(thickness_is_the_radius_of_the_particles)
{
    begin(world_options_default());
    add(&box, placement_at(vec3_make(0, 0, 0)));
    add(&cloth, placement_at(vec3_make(0, 3, 0)));
    add(&rope, placement_at(vec3_make(0, 6, 0)));
    ck_assert(w.body[0].thickness == 0);
    // Two sheets of spacing s must keep more than s apart.
    ck_assert(w.body[1].thickness > cloth.spacing / 2);
    ck_assert(w.body[2].thickness > rope.spacing / 2);
    ck_assert_int_eq(probe_lists(&w)->tree[0].leaves, 0);
    ck_assert_int_eq(probe_lists(&w)->tree[1].leaves, cloth.particles);
    ck_assert_int_eq(probe_lists(&w)->tree[2].leaves, rope.particles);
}
END_TEST

// Rejects: vertices of the shape instead of those that the particles carry; a
// range of another body.
START_TEST(vertices_ride_on_the_particles)
{
    begin(world_options_default());
    add(&ball, placement_at(vec3_make(0, 0, 0)));
    add(&box, placement_at(vec3_make(0, 5, 0)));
    add(&rope, placement_at(vec3_make(0, 9, 0)));
    // A quarter of a turn about y, and away: from (x, y, z) to (z, y, -x).
    for (int i = 0; i < w.pool.count; i++) {
        vec3 x = w.pool.at[i].position;
        w.pool.at[i].position = vec3_make(x.z + 7, x.y, -x.x);
    }
    for (int b = 0; b < 3; b++)
        for (int i = 0; i < w.body[b].shape->particles; i++) {
            vec3 x = w.body[b].shape->at[i];
            real up = b == 0 ? 0 : b == 1 ? 5 : 9;
            near_vec3(vertex_of(b, i), vec3_make(x.z + 7, x.y + up, -x.x),
                      ROUNDING * 10);
        }
}
END_TEST

// Rejects: a free of what was never there, or twice.
START_TEST(world_may_be_freed_at_any_time)
{
    world_free(&w);
    world_free(&w);
    ck_assert(world_init(&w, world_options_default()).ok);
    add(&box, placement_at(vec3_make(0, 0, 0)));
    world_free(&w);
    ck_assert_int_eq(w.bodies, 0);
    ck_assert_int_eq(w.pool.count, 0);
    ck_assert(world_init(&w, world_options_default()).ok);
    add(&cloth, placement_at(vec3_make(0, 0, 0)));
    world_free(&w);
}
END_TEST

// A world of every part there is.
static status build(const world_options *o)
{
    status done = world_init(&w, *o);
    const shape *s[] = { &box, &ball, &cloth, &rope, &box };
    for (int k = 0; k < 5 && done.ok; k++)
        done = world_add(&w, s[k], placement_at(vec3_make(0, 4 * k, 0)), NULL);
    if (done.ok) done = world_add_plane(&w, vec3_make(0, 1, 0), -9);
    return done;
}

// Rejects: a malloc whose answer nobody looks at; a half-built world of which
// something is lost.
START_TEST(every_refusal_of_memory_is_told_and_leaves_nothing)
{
    const world_options o = world_options_default();
    int n = 0, ok = 0;
    world_free(&w);
    for (; n < 1000 && !ok; n++) {
        long before = blocks_held;
        mallocs_left = n;
        status done = build(&o);
        mallocs_left = INT_MAX;
        ok = done.ok;
        world_free(&w);
        long after = blocks_held;
        if (!ok) ck_assert_str_eq(done.why, "out of memory");
        ck_assert_int_eq(after, before);
    }
    ck_assert(ok);
    ck_assert_int_gt(n, 30);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        options_out_of_range_are_refused_by_name,
        limits_of_the_options_are_allowed,
        defaults_are_as_documented,
        lopsided_body_spins_about_the_centre_of_its_solid,
        body_too_thin_for_four_particles_is_refused,
        placement_must_be_finite_and_orthonormal,
        planes_are_kept_with_unit_normals,
        world_has_as_many_planes_as_one_likes,
        plane_without_a_finite_normal_and_offset_is_refused,
        thickness_is_the_radius_of_the_particles,
        world_may_be_freed_at_any_time,
        every_refusal_of_memory_is_told_and_leaves_nothing,
        vertices_stand_where_the_axes_say,
        particles_start_with_velocity_and_spin,
        masses_are_those_of_the_shape,
        static_body_is_immovable_and_at_rest,
        pin_holds_one_particle_of_its_body,
        many_bodies_share_their_shapes,
        world_has_everything_in_its_place,
        vertices_ride_on_the_particles,
        NULL
    };
    return suite_run((suite){
        .name = "world", .tests = tests, .set_up = set_up,
        .tear_down = tear_down
    });
}
