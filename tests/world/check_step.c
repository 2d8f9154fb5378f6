// check_step.c - does a frame do what it should, and nothing else?
// Book: chapter 18.

#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "guard.h"
#include "handle.h"
#include "ledger.h"
#include "scarce.h"
#include "stage.h"
#include "step.h"
#include "suite.h"

// A second is 480 sums of positions near 10; each one's rounding goes on as a
// velocity, so that errors grow as 480^2 / 2 * 1e-15.
#define FALL_ROUNDING 1e-9
// Momentum: every impulse is a pair of products that cancel but for rounding.
#define MOMENTUM 1e-12

// --- a world -----------------------------------------------------------------

static shape box, low, ball, cloth, rope, brick;

static void set_up(void)
{
    ck_assert(shape_box(&box, vec3_make(1, 1, 1), 1).ok);
    ck_assert(shape_box(&low, vec3_make(2, 0.5, 2), 4).ok);
    ck_assert(shape_icosahedron(&ball, 0.5, 1).ok);
    ck_assert(shape_cloth(&cloth, 10, 10, 1, 1, 1, 0.2).ok);
    ck_assert(shape_rope(&rope, 12, 1.2, 0.3).ok);
    ck_assert(shape_box(&brick, vec3_make(0.4, 0.2, 0.1), 2).ok);
    begin(world_options_default());
}

static void tear_down(void)
{
    world_free(&w);
    shape_free(&box);
    shape_free(&low);
    shape_free(&ball);
    shape_free(&cloth);
    shape_free(&rope);
    shape_free(&brick);
}

// The centre of mass: the particles of a body are equally heavy.
static vec3 middle(int b)
{
    int n = body_particles(&w.body[b]);
    vec3 sum = ZERO;
    for (int i = 0; i < n; i++)
        sum = vec3_add(sum, particle_of(b, i)->position);
    return vec3_scale(1.0 / n, sum);
}

// n frames; nothing may be dropped.
static void frames(int n)
{
    for (int k = 0; k < n; k++) {
        world_step(&w);
        ck_assert_int_eq(w.report.dropped, 0);
    }
}

static world_options without_gravity(void)
{
    world_options o = world_options_default();
    o.gravity = ZERO;
    return o;
}

static world_options without_sleep(void)
{
    world_options o = world_options_default();
    o.sleep_speed = 0;
    return o;
}

// The measures come after the step in the book: here are its own.
static vec3 momentum(void)
{
    vec3 sum = ZERO;
    for (int i = 0; i < w.pool.count; i++) {
        const particle *p = &w.pool.at[i];
        if (p->inverse_mass == 0) continue;
        sum = vec3_add_scaled(sum, 1 / (body_age(&w, w.owner[i]) * p->inverse_mass),
                              vec3_sub(p->position, p->previous));
    }
    return sum;
}

static real kinetic(void)
{
    real sum = 0;
    for (int i = 0; i < w.pool.count; i++) {
        const particle *p = &w.pool.at[i];
        if (p->inverse_mass == 0) continue;
        real h = body_age(&w, w.owner[i]);
        vec3 v = vec3_scale(1 / h, vec3_sub(p->position, p->previous));
        sum += vec3_length_squared(v) / (2 * p->inverse_mass);
    }
    return sum;
}

static vec3 angular_momentum(void)
{
    vec3 sum = ZERO;
    for (int i = 0; i < w.pool.count; i++) {
        const particle *p = &w.pool.at[i];
        vec3 way = vec3_sub(p->position, p->previous);
        sum = vec3_add_scaled(sum, 1 / (body_age(&w, w.owner[i]) * p->inverse_mass),
                              vec3_cross(p->position, way));
    }
    return sum;
}

// m, of the two rigid bodies that overlap most.
static real penetration(void)
{
    real deepest = 0;
    for (int a = 0; a < w.bodies; a++)
        for (int b = a + 1; b < w.bodies; b++) {
            vec3 at[2][12];
            const body *x[2] = { &w.body[a], &w.body[b] };
            hull q[2];
            for (int k = 0; k < 2; k++) {
                world_vertices(&w, x[k], at[k]);
                q[k] = (hull){ at[k], x[k]->shape->particles };
            }
            gjk_result g = gjk_distance(q[0], q[1], 0, NULL);
            if (g.status == GJK_OVERLAP)
                deepest = fmax(deepest,
                               hit_face_find(q[0], q[1], &g.last).depth);
        }
    return deepest;
}

enum { MOST = 1000 };

// Copies the bits of all particles.
static void copy_particles(particle *to)
{
    ck_assert_int_le(w.pool.count, MOST);
    memcpy(to, w.pool.at, (size_t)w.pool.count * sizeof *to);
}

static bool same_particles(const particle *was)
{
    return memcmp(was, w.pool.at, (size_t)w.pool.count * sizeof *was) == 0;
}

// Of the angular momentum of what turns freely: what the sticks' tolerance,
// 1e-9, leaves in each of 600 frames.
#define SPIN 6e-7
// Of its energy: a body that turns about no axis of its own trades some between
// frames, as a chord is shorter than its arc.
#define SPIN_ENERGY 0.02
// Of the energy of what bounces.
#define GAIN 1e-9
// m: what stands in touch rises by, and sinks and shifts by.
#define LIFT 1e-6
#define SAG 0.01

// --- flight ------------------------------------------------------------------

// Rejects: a start or a substep of the wrong order; gravity twice, or once a
// frame; sticks that act on what they need not.
START_TEST(free_fall_is_a_parabola)
{
    const vec3 v = { 1, 4, -2 };
    for (int k = 1; k < 10; k *= 3) {
        world_options o = world_options_default();
        o.substeps = k;
        o.most_substeps = k;
        begin(o);
        const shape *s[] = { &box, &ball, &cloth, &rope };
        vec3 from[4];
        for (int b = 0; b < 4; b++) {
            from[b] = vec3_make(5 * b, 3, 0);
            add_thrown(s[b], from[b], v, ZERO);
        }
        for (int f = 1; f <= 60; f++) {
            frames(1);
            real t = f / 60.0;
            ck_assert(fabs(w.time - t) <= FALL_ROUNDING);
            vec3 went = vec3_add_scaled(vec3_scale(t, v), t * t / 2,
                                        w.options.gravity);
            for (int b = 0; b < 4; b++)
                for (int i = 0; i < s[b]->particles; i++) {
                    vec3 x = vec3_add(vec3_add(from[b], s[b]->at[i]), went);
                    vec3 now = vertex_of(b, i);
                    ck_assert_msg(vec3_distance(now, x) <= FALL_ROUNDING,
                                  "body %d is off by %g m in frame %d", b,
                                  vec3_distance(now, x), f);
                }
        }
        ck_assert_int_eq(w.report.contacts, 0);
        ck_assert_int_eq(w.report.asleep, 0);
    }
}
END_TEST

// Rejects: a body that is stepped although it is static, in any way at all.
START_TEST(static_bodies_keep_every_bit)
{
    begin(world_options_default());
    int b = add_nailed(&low, 1, 2, 3);
    add_at(&ball, 1, 3, 3);
    add_at(&cloth, 1, 4, 3);
    particle was[8];
    int n = body_particles(&w.body[b]);
    memcpy(was, particle_of(b, 0), (size_t)n * sizeof *was);
    frames(60);
    ck_assert(memcmp(was, particle_of(b, 0), (size_t)n * sizeof *was) == 0);
    for (int i = 0; i < 8; i++)
        ck_assert(vec3_distance(vertex_of(b, i), vec3_add(vec3_make(1, 2, 3),
                                                          low.at[i])) < 1e-14);
}
END_TEST

// A brick that turns about any axis: 600 frames.
// Rejects: a frame that brakes what turns fast, or speeds up what turns slowly;
// moves that leave the body bent.
START_TEST(free_spin_keeps_angular_momentum_and_energy)
{
    for (real spin = 0.1; spin < 2000; spin *= 10) {
        begin(without_gravity());
        int b = add_thrown(&brick, ZERO, ZERO,
                           vec3_scale(spin, vec3_make(0.36, 0.48, 0.8)));
        vec3 had = angular_momentum();
        real energy = kinetic();
        frames(600);
        real lost = vec3_distance(angular_momentum(), had) / vec3_length(had);
        real more = kinetic() / energy - 1;
        ck_assert_msg(lost <= SPIN, "%g rad/s: off by %g", spin, lost);
        ck_assert_msg(more <= SPIN_ENERGY && more >= -0.05,
                      "%g rad/s: %g of the energy more", spin, more);
        for (int i = 0; i < FOUR_STICKS; i++)
            ck_assert(stick_strain(w.body[b].rigid->stick[i], particle_of(b, 0))
                      <= 1e-5);
    }
}
END_TEST

// --- impacts -----------------------------------------------------------------

// Two bodies without gravity, the second thrown at the first: their momentum.
static void keeps_momentum(const shape *a, const shape *b, world_options o)
{
    begin(o);
    add_at(a, 0, 0, 0);
    add_thrown(b, vec3_make(0.2, 2.1, 0.1), vec3_make(0.3, -6, -0.4),
               vec3_make(1, -2, 3));
    vec3 before = momentum();
    frames(60);
    vec3 after = momentum();
    ck_assert_msg(vec3_distance(before, after)
                  <= MOMENTUM * 480 * vec3_length(before),
                  "momentum changed by %g", vec3_distance(before, after));
    // They have met: what rested now moves down.
    ck_assert_msg(middle(0).y < -0.05, "no impact: %g", middle(0).y);
}

// Rejects: an impulse, friction, a bounce, a stick or a fallen-back solve that
// acts on one side alone.
START_TEST(colliding_bodies_keep_their_momentum)
{
    world_options o = without_gravity();
    keeps_momentum(&box, &ball, o);
    keeps_momentum(&ball, &low, o);
    keeps_momentum(&box, &cloth, o);
    keeps_momentum(&cloth, &low, o);
    o.restitution = 0.7;
    keeps_momentum(&box, &ball, o);
    keeps_momentum(&box, &low, o);
    o.relax.gradient = GRADIENT_NEW;
    keeps_momentum(&box, &low, o);
}
END_TEST

// A row of boxes, 5 cm apart, and a fast one: each passes the impact on in the
// middle of a frame, and crosses the gap before its end. Contacts are found for
// the speeds with which the frame begins: one that is hit may come as deep into
// its neighbour as half that speed takes it in a frame, beyond the 5 cm, and no
// box into the next but one.
// Rejects: contacts only of those that move when the frame begins.
START_TEST(impact_goes_through_a_row)
{
    const real speeds[] = { 2, 10, 20 };
    for (int k = 0; k < 3; k++) {
        begin(without_gravity());
        for (int b = 0; b < 4; b++)
            add_at(&box, 1.05 * b, 0.01 * b, 0.02 * b);
        add_thrown(&box, vec3_make(-1.05 - speeds[k] / 90, 0, 0),
                   vec3_make(speeds[k], 0, 0), ZERO);
        real deepest = 0;
        for (int f = 0; f < 40; f++) {
            frames(1);
            deepest = fmax(deepest, penetration());
        }
        real most = fmax(0.05 * box.radius, speeds[k] / 2 / 60 - 0.05);
        ck_assert_msg(deepest <= most, "%g m deep at %g m/s", deepest,
                      speeds[k]);
        ck_assert(middle(3).x > 3.15 + 0.01);
        for (int b = 0; b < 3; b++)
            ck_assert(middle(b).x < middle(b + 1).x);
    }
}
END_TEST

// How high the middle of a box rises after it fell flat from 1 m.
static real bounce_of(real restitution)
{
    world_options o = world_options_default();
    o.restitution = restitution;
    begin(o);
    add_at(&box, 0, 1.5, 0);
    add_floor();
    real y = 1.5, top = 0;
    int was_down = 0;
    for (int f = 0; f < 100; f++) {
        real before = y;
        frames(1);
        y = middle(0).y;
        if (y >= before) was_down = 1;
        if (was_down) top = fmax(top, y);
    }
    return top;
}

// From 1.5 m down to 0.5 m and up again: e^2 of that metre comes back.  The
// speed is that of the last substep before the floor, which may be 1 % of it
// away.
static const real BOUNCE = 0.05;

// Rejects: an option that is not read; a bounce that adds energy; a bounce of
// the corners alone, which the sticks take back; the speed that a push gives.
START_TEST(box_that_falls_flat_bounces_to_the_square_of_its_restitution)
{
    const real e[] = { 0, 0.5, 0.75, 1 };
    for (int k = 0; k < 4; k++) {
        real rise = bounce_of(e[k]) - 0.5;
        ck_assert_msg(fabs(rise - e[k] * e[k]) < BOUNCE,
                      "restitution %g: %g m", e[k], rise);
    }
}
END_TEST

// J and m, of 9.81 J and 1 m: what the impact knows of the moment of touching.
#define EXACT 1e-7

// A frame of any substeps: what falls is a parabola, and so is what rises.
// Rejects: gravity left out of the impact; the speed of the substep before it.
START_TEST(bounce_is_exact_in_any_substeps)
{
    for (int k = 0; k < 10; k++) {
        world_options o = world_options_default();
        o.substeps = 1 << k / 2;
        o.restitution = k % 2 ? 1 : 0.5;
        begin(o);
        add_at(&box, 0, 1.5, 0);
        add_floor();
        real floor = 0.5, e = o.restitution;
        frames(40);
        ck_assert(middle(0).y > floor);
        real top = ledger_total(&w).energy / 9.81;
        ck_assert_msg(fabs(top - floor - e * e * (1.5 - floor)) < EXACT,
                      "%d substeps, restitution %g: off by %g m", o.substeps, e,
                      top - floor - e * e * (1.5 - floor));
    }
}
END_TEST

// The speed at which two boxes part that met head on at 5 m/s.
static real parting_speed(real restitution)
{
    world_options o = without_gravity();
    o.restitution = restitution;
    begin(o);
    add_thrown(&box, vec3_make(-1, 0, 0), vec3_make(2.5, 0, 0), ZERO);
    add_thrown(&box, vec3_make(1, 0, 0), vec3_make(-2.5, 0, 0), ZERO);
    frames(60);
    real a = middle(0).x, b = middle(1).x;
    frames(6);
    ck_assert_msg(vec3_length(momentum()) < 1e-12, "momentum of %g",
                  vec3_length(momentum()));
    return (middle(1).x - b - middle(0).x + a) / (6 * o.dt);
}

// m/s, of 5: an impact is exact; without one, the springs of the contacts give
// a little of what pushed them in back.
static const real PARTING = 1e-5, SOFT_PARTING = 0.2;

// Rejects: a bounce that is not shared by mass, so that momentum is lost.
START_TEST(boxes_that_meet_head_on_part_at_restitution_times_their_speed)
{
    for (int k = 0; k <= 2; k++) {
        real e = k / 2.0, parting = parting_speed(e);
        ck_assert_msg(fabs(parting - 5 * e)
                      < (e > 0 ? PARTING : SOFT_PARTING),
                      "restitution %g: %g m/s", e, parting);
    }
}
END_TEST

// m/s, a hundredth of the impact.
#define CRADLE 0.05

// A row of boxes, hit from the left (side -1) or from the right at 5 m/s.
static void cradle(int row, int side)
{
    world_options o = without_gravity();
    o.restitution = 1;
    begin(o);
    real apart = 1.001;
    for (int b = 0; b < row; b++)
        add_at(&box, (b - (row - 1) / 2.0) * apart, 0, 0);
    add_thrown(&box, vec3_make(side * (row + 3) / 2.0 * apart, 0, 0),
               vec3_make(-side * 5, 0, 0), ZERO);
    vec3 was[MOST];
    for (int f = 0; f < 60; f++) {
        for (int b = 0; b <= row; b++) was[b] = middle(b);
        frames(1);
        ck_assert(penetration() == 0);
    }
    for (int b = 0; b <= row; b++) {
        vec3 v = vec3_scale(60, vec3_sub(middle(b), was[b]));
        int last = b == (side < 0 ? row - 1 : 0);
        ck_assert_msg(fabs(v.x + side * last * 5) < CRADLE
                      && fabs(v.y) < CRADLE, "body %d of %d goes at (%g, %g)",
                      b, row, v.x, v.y);
        if (last) ck_assert(fabs(middle(b).x) > row / 2.0 * apart + 1);
    }
}

// Newton's cradle, hit from the left, and from the right: against the order of
// its pairs.
// Rejects: an impact that is passed on once a substep, so that each pushes into
// the next; one that is shared by the whole row; one that needs a round for
// each of them where it runs against their order.
START_TEST(impact_goes_through_a_cradle_from_either_end)
{
    for (int side = -1; side < 2; side += 2) {
        cradle(5, side);
        cradle(12, side);
    }
}
END_TEST

// Twenty balls dropped on a floor, and twenty-seven in a closed room without
// gravity, with friction.
// Rejects: impacts that give energy to each other; friction that does; contacts
// that push out what an impact has left behind.
START_TEST(full_restitution_never_gives_energy)
{
    for (int k = 0; k < 2; k++) {
        world_options o = k ? without_gravity() : world_options_default();
        const real cell = 1.4;
        o.restitution = 1;
        begin(o);
        for (int b = 0; b < 20 + 7 * k; b++)
            add_thrown(&ball, vec3_make(cell * (b % 3 + 0.5),
                                        cell * (b / 9 + 0.5),
                                        cell * (b / 3 % 3 + 0.5)),
                       random_vec3(&seed, k ? 5 : 1), random_vec3(&seed, 1));
        const vec3 wall[3] = { { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 } };
        for (int i = 0; i < 3; i++) {
            ck_assert(world_add_plane(&w, wall[i], 0).ok);
            if (i == 0 && k == 0) continue;
            ck_assert(world_add_plane(&w, vec3_scale(-1, wall[i]),
                                      -3 * cell).ok);
        }
        real had = ledger_total(&w).energy;
        for (int f = 0; f < 300; f++) {
            frames(1);
            real more = ledger_total(&w).energy / had - 1;
            ck_assert_msg(more <= GAIN, "frame %d: %g more", f, more);
        }
        ck_assert(penetration() < 0.1 * ball.radius);
    }
}
END_TEST

// Boxes that spin, in a closed room without gravity and friction.  A corner that was
// put back behind a wall, to where it would have begun, turns while it goes on.
// Rejects: a push at what is overlapped only there; it took a per cent and more.
START_TEST(boxes_that_bounce_off_all_sides_keep_their_energy)
{
    const real cell = 2.5 * box.radius, KEPT = 1e-3;
    world_options o = without_gravity();
    o.restitution = 1;
    o.friction = 0;
    begin(o);
    for (int b = 0; b < 9; b++)
        add_thrown(&box, vec3_make(cell * (b % 3 + 0.5), cell * 1.5,
                                   cell * (b / 3 + 0.5)),
                   random_vec3(&seed, 15), random_vec3(&seed, 30));
    const vec3 wall[3] = { { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 } };
    for (int i = 0; i < 3; i++) {
        ck_assert(world_add_plane(&w, wall[i], 0).ok);
        ck_assert(world_add_plane(&w, vec3_scale(-1, wall[i]), -3 * cell).ok);
    }
    real had = ledger_total(&w).energy;
    frames(1200);
    real left = ledger_total(&w).energy / had;
    ck_assert_msg(fabs(left - 1) < KEPT, "%g is left", left);
}
END_TEST

// Rejects: an impact of what only stands, which hops by what gravity brings in
// a substep, and forgets its impulses.
START_TEST(bouncing_box_may_stand)
{
    world_options o = world_options_default();
    o.restitution = 1;
    o.sleep_speed = 0;
    begin(o);
    add_at(&box, 0, 0.5, 0);
    add_floor();
    real was = middle(0).y;
    for (int f = 0; f < 120; f++) {
        frames(1);
        ck_assert_msg(fabs(middle(0).y - was) < 1e-3, "it hops by %g m",
                      middle(0).y - was);
        ck_assert_int_eq(w.report.pushing, 1);
    }
}
END_TEST

// m, of a slab of 2 m: contacts without bounce are solved one point after the
// other, and lose half a percent of its width; impacts nothing.
#define FLAT 0.01

// Rejects: a landing that tilts what falls flat, at some moment of a substep.
START_TEST(box_that_falls_flat_stays_flat)
{
    for (int k = 0; k < 8; k++) {
        world_options o = world_options_default();
        o.restitution = k % 2;
        begin(o);
        add_at(&low, 0, 1 + 0.013 * k, 0);
        add_floor();
        for (int f = 0; f < 60; f++) {
            frames(1);
            real least = HUGE_VAL, most = -HUGE_VAL;
            for (int i = 0; i < 8; i++) {
                real y = vertex_of(0, i).y;
                if (box.at[i].y > 0) continue;
                least = fmin(least, y);
                most = fmax(most, y);
            }
            ck_assert_msg(most - least <= (k % 2 ? 1e-12 : FLAT),
                          "frame %d: tilted by %g m", f, most - least);
        }
    }
}
END_TEST

// --- standing ----------------------------------------------------------------

// Rejects: a static body that stands elsewhere, so that nothing meets it;
// a margin that ends before the body arrives.
START_TEST(body_lands_on_a_static_one_wherever_it_stands)
{
    const vec3 at[] = { { 0, 0, 0 }, { 10, 3, -7 }, { -300, 40, 500 } };
    const real from[] = { 0.8, 3, 12 };
    for (int k = 0; k < 9; k++) {
        vec3 x = at[k % 3];
        real height = from[k / 3];
        begin(world_options_default());
        add_nailed(&low, x.x, x.y, x.z);
        add_at(&box, x.x, x.y + 0.25 + 0.5 + height, x.z);
        frames(150);
        vec3 now = middle(1);
        ck_assert_msg(fabs(now.y - x.y - 0.75) < 0.1
                      && fabs(now.x - x.x) < 0.5 && fabs(now.z - x.z) < 0.5,
                      "dropped from %g m it is at (%g, %g, %g) from the slab",
                      height, now.x - x.x, now.y - x.y, now.z - x.z);
    }
}
END_TEST

// A pyramid of so many rows, its boxes exactly in touch.
static int add_pyramid(int rows)
{
    int n = 0;
    for (int r = 0; r < rows; r++)
        for (int k = 0; k < rows - r; k++, n++)
            add_at(&box, 1.05 * (k + r / 2.0), 0.5 + r, 0);
    add_floor();
    return n;
}

// How far any body has gone from where it was, and how far up at most.
typedef struct {
    real way, up, down;         // m
} travel;

static vec3 home[MOST];

static void remember_places(void)
{
    for (int b = 0; b < w.bodies; b++) home[b] = middle(b);
}

static travel travelled(void)
{
    travel t = { 0, 0, 0 };
    for (int b = 0; b < w.bodies; b++) {
        vec3 d = vec3_sub(middle(b), home[b]);
        t.way = fmax(t.way, vec3_length(d));
        t.up = fmax(t.up, d.y);
        t.down = fmax(t.down, -d.y);
    }
    return t;
}

// Rejects: a margin that pushes apart what was placed in touch; springs that
// throw.
START_TEST(boxes_in_touch_are_not_pushed_apart)
{
    begin(without_sleep());
    add_pyramid(10);
    remember_places();
    for (int f = 0; f < 120; f++) {
        frames(1);
        travel t = travelled();
        ck_assert_msg(t.up <= LIFT && t.way <= SAG, "frame %d: up by %g m, "
                      "away by %g m", f, t.up, t.way);
    }
}
END_TEST

// Twenty seconds with the default options.
static void stands(int bodies, real way)
{
    remember_places();
    for (int f = 0; f < 1200 && w.report.asleep < bodies; f++) frames(1);
    travel t = travelled();
    ck_assert_msg(t.way <= way, "%d bodies: one went by %g m", bodies, t.way);
}

// Under a little more and a little less gravity, so that none stands by luck.
// Rejects: loads that are not carried from frame to frame, in all of a tower;
// substeps that change while it settles.
START_TEST(towers_stand)
{
    const int high[] = { 20, 30, 60 };
    for (int k = -3; k <= 3; k++) {
        world_options o = world_options_default();
        o.gravity.y *= 1 + 2e-4 * k;
        begin(o);
        for (int b = 0; b < high[_i]; b++) add_at(&box, 0, 0.5 + b, 0);
        add_floor();
        stands(high[_i], 0.01 * high[_i]);
        vec3 top = middle(high[_i] - 1);
        ck_assert_msg(hypot(top.x, top.z) < 0.03, "it leans by %g m",
                      hypot(top.x, top.z));
    }
}
END_TEST

// Forty cubes, awake: what lies has its rows where its contacts were found.  Rows
// that lean with the tower would let it buckle: its springs are too soft for that.
// Rejects: rows that are made where everything is, for what lies, too.
START_TEST(tower_that_is_awake_stands_with_eight_substeps)
{
    enum { CUBES = 40, SECONDS = 20 };
    world_options o = without_sleep();
    o.substeps = o.most_substeps = 8;
    begin(o);
    for (int b = 0; b < CUBES; b++) add_at(&box, 0, 0.5 + b, 0);
    add_floor();
    frames(60 * SECONDS);
    for (int b = 0; b < CUBES; b++) {
        vec3 at = middle(b);
        ck_assert_msg(fabs(at.y - 0.5 - b) < 0.3 && hypot(at.x, at.z) < 0.03,
                      "cube %d at %g, %g, %g", b, at.x, at.y, at.z);
    }
}
END_TEST

// Rejects: a length, a speed or a tolerance that is meant for metres; substeps
// that come when a tower has begun to lean.
START_TEST(cubes_of_a_centimetre_stand)
{
    for (int n = 5; n <= 20; n += 5) {
        shape cube;
        ck_assert(shape_box(&cube, vec3_make(0.01, 0.01, 0.01), 1e-3).ok);
        begin(world_options_default());
        for (int k = 0; k < n; k++) add_at(&cube, 0, 0.01 * (k + 0.5), 0);
        add_floor();
        stands(n, 0.002);
        world_free(&w);
        shape_free(&cube);
    }
}
END_TEST

// Rejects: substeps that do not know what carries what.
START_TEST(heavy_stands_on_light)
{
    const real ratio[] = { 300, 1000 }, most[] = { 0.005, 0.006 };
    for (int k = 0; k < 2; k++) {
        shape heavy;
        ck_assert(shape_box(&heavy, vec3_make(1, 1, 1), ratio[k]).ok);
        begin(world_options_default());
        add_at(&box, 0, 0.5, 0);
        add_at(&heavy, 0, 1.5, 0);
        add_floor();
        stands(2, most[k]);
        world_free(&w);
        shape_free(&heavy);
    }
}
END_TEST

// Rejects: impulses that are found anew in every frame, or overlaps that are
// pushed out to the last, so that boxes hop.  (16 mJ, and rising.)
START_TEST(stack_that_is_awake_lies_still)
{
    enum { BOXES = 10 };
    begin(without_sleep());
    for (int k = 0; k < BOXES; k++) add_at(&box, 0, 0.5 + k, 0);
    add_floor();
    remember_places();
    frames(600);
    ck_assert_msg(kinetic() < 1e-6, "%g J", kinetic());
    ck_assert_msg(travelled().way < 0.05, "%g m", travelled().way);
}
END_TEST

// A slab that is found 0.1 m deep in the floor.
// Rejects: an overlap that throws; one that stays; one that goes at once.
START_TEST(old_overlap_is_pushed_out_and_not_thrown)
{
    begin(world_options_default());
    add_at(&low, 0, 0.15, 0);
    add_floor();
    real deep = 0.1;
    for (int f = 0; f < 60; f++) {
        frames(1);
        real now = 0.25 - middle(0).y;
        // At most 0.055 radii a frame: 3 m/s for a cube of 1 m.
        if (deep > 0)
            ck_assert(now <= deep + 1e-3 && now >= deep - 3.0 / 60 - 1e-9);
        // Its corners come up one after the other, so that it rocks.
        ck_assert_msg(now > -0.02, "it flies %g m high", -now);
        deep = now;
    }
    ck_assert_msg(deep < 0.005, "%g m deep", deep);
}
END_TEST

// --- options -----------------------------------------------------------------

// Rejects: an option that is not read; impulses that are lost from frame to
// frame: then a stack sinks until the springs of a single frame carry it.
START_TEST(warm_start_carries_a_stack)
{
    real sunk[2];
    for (int warm = 0; warm < 2; warm++) {
        world_options o = without_sleep();
        o.warm_start = warm;
        o.substeps = o.most_substeps = 8;
        begin(o);
        for (int k = 0; k < 8; k++) add_at(&box, 0, 0.5 + k, 0);
        add_floor();
        frames(120);
        sunk[warm] = 7.5 - middle(7).y;
    }
    ck_assert_msg(sunk[1] < 0.02 && sunk[0] > 2 * sunk[1],
                  "sunk by %g m, %g without", sunk[1], sunk[0]);
}
END_TEST

// How deep ten boxes sink into each other.
static real sag(world_options o)
{
    o.sleep_speed = 0;
    begin(o);
    for (int k = 0; k < 10; k++) add_at(&box, 0, 0.5 + k, 0);
    add_floor();
    frames(120);
    return 9.5 - middle(9).y;
}

// A contact's spring gives way by load / mass (2 pi hertz)^2, but is no stiffer
// than a substep can follow.
// Rejects: options that are not read, or are read the other way round.
START_TEST(hertz_and_substeps_make_contacts_stiffer)
{
    world_options o = world_options_default();
    real usual = sag(o);
    o.hertz = 30;
    real softer = sag(o);
    o = world_options_default();
    o.substeps = 16;
    o.hertz = 120;
    real finer = sag(o);
    ck_assert_msg(softer > 1.5 * usual && finer < 0.7 * usual && finer > 0,
                  "%g m, softer %g m, in finer substeps %g m", usual, softer,
                  finer);
}
END_TEST

// At 100 rad/s a body turns by 95 degrees in a frame.  It is turned as a whole.
// Rejects: sticks that lag behind; a frame that rounding bends, frame by frame.
START_TEST(what_turns_violently_keeps_its_shape)
{
    real strain = 0;
    begin(without_gravity());
    add_thrown(&low, ZERO, ZERO, vec3_make(20, 30, 90));
    for (int f = 0; f < 3600; f++) {
        frames(1);
        for (int i = 0; i < FOUR_STICKS; i++)
            strain = fmax(strain, stick_strain(w.body[0].rigid->stick[i],
                                               particle_of(0, 0)));
    }
    ck_assert_msg(strain <= 1e-14, "strain %g", strain);
}
END_TEST

// Two boxes meet in space, spinning, with friction and without; some bounce.
// Rejects: impulses with the arms of the frame's start; a spin that is kept while
// the body turns; a touch elsewhere than where they are.
START_TEST(boxes_that_collide_in_space_keep_their_angular_momentum)
{
    int hits = 0;
    for (int n = 0; n < 60; n++) {
        world_options o = without_gravity();
        o.friction = n % 3 * 0.5;
        o.restitution = n % 2 * 0.6;
        begin(o);
        placement a = anywhere(0.1, 0, 9), b = anywhere(0.1, 0, 9);
        a.position.x -= 1.5;
        b.position.x += 1.5;
        a.velocity = vec3_make(4, 0.2, 0);
        b.velocity = vec3_make(-2, 0, 0.3);
        add(&low, a);
        add(&brick, b);
        vec3 was = angular_momentum(), sum = momentum();
        vec3 flew = world_where(&w, 1).velocity;
        frames(90);
        real size = 4 * 2 * 4 * 1.5;        // kg m^2/s, of the heavier one
        hits += vec3_distance(world_where(&w, 1).velocity, flew) > 0.1;
        ck_assert_msg(vec3_distance(angular_momentum(), was) <= 1e-9 * size,
                      "%d: off by %g", n,
                      vec3_distance(angular_momentum(), was) / size);
        ck_assert(vec3_distance(momentum(), sum) <= 1e-9 * 16);
    }
    ck_assert_int_ge(hits, 40);
}
END_TEST

// Rejects: an option that another one needs.
START_TEST(every_option_carries_a_box)
{
    for (int k = 0; k < 16; k++) {
        world_options o = world_options_default();
        o.warm_start = k & 1;
        if (k & 2) o.sleep_speed = 0;
        if (k & 4) o.relax.gradient = GRADIENT_NEW;
        if (k & 8) o.stay = 0;
        begin(o);
        add_nailed(&low, 0, -0.25, 0);
        add_at(&box, 0, 0.7, 0);
        frames(120);
        ck_assert_msg(fabs(middle(1).y - 0.5) < 0.01, "options %d: at %g", k,
                      middle(1).y);
    }
}
END_TEST

// --- the oracle: nothing is kept between frames ------------------------------

// Twelve boxes dropped on each other, or twelve balls in a pit: where they are
// after four seconds, and how deep they ever were in each other.
enum { DROPPED = 12 };

typedef struct {
    real deepest;       // m, in any frame
    real kinetic;       // J, in the end
    vec3 at[DROPPED];   // m, in the end
} outcome;

static outcome drop(const shape *s, bool keeps)
{
    world_options o = without_sleep();
    o.warm_start = keeps;
    begin(o);
    for (int k = 0; k < DROPPED; k++)
        add_at(s, 1.1 * (k % 2) + 0.01 * k, 0.6 + 1.1 * (k / 4),
               1.1 * (k / 2 % 2));
    add_floor();
    for (int k = -1; k <= 1; k += 2) {
        ck_assert(world_add_plane(&w, vec3_make(k, 0, 0), k < 0 ? -2 : -1).ok);
        ck_assert(world_add_plane(&w, vec3_make(0, 0, k), k < 0 ? -2 : -1).ok);
    }
    outcome r = { .deepest = 0 };
    for (int f = 0; f < 240; f++) {
        if (!keeps) probe_forget_contacts(&w);
        frames(1);
        r.deepest = fmax(r.deepest, penetration());
    }
    r.kinetic = kinetic();
    for (int b = 0; b < DROPPED; b++) r.at[b] = middle(b);
    return r;
}

// A box of friction 0.5 that slides at 3 m/s comes to rest after v^2 / 2 mu g.
static real slide(bool keeps)
{
    world_options o = world_options_default();
    o.warm_start = keeps;
    begin(o);
    add_thrown(&low, vec3_make(0, 0.25, 0), vec3_make(3, 0, 0), ZERO);
    add_floor();
    for (int f = 0; f < 90; f++) {
        if (!keeps) probe_forget_contacts(&w);
        frames(1);
    }
    return middle(0).x;
}

// Rejects: a contact that is kept where it has changed, so that bodies sink, or
// stand where they should have slid off.
START_TEST(world_that_keeps_nothing_behaves_alike)
{
    const shape *what[] = { &box, &ball };
    for (int k = 0; k < 2; k++) {
        outcome kept = drop(what[k], true), fresh = drop(what[k], false);
        ck_assert_msg(kept.deepest < 0.03 && fresh.deepest < 0.03,
                      "%g m deep, %g m if nothing is kept", kept.deepest,
                      fresh.deepest);
        // Balls roll where chance takes them, and as long.
        if (k > 0) continue;
        ck_assert_msg(kept.kinetic < 1e-3 && fresh.kinetic < 0.1,
                      "%g J, %g J if nothing is kept", kept.kinetic,
                      fresh.kinetic);
        for (int b = 0; b < DROPPED; b++)
            ck_assert_msg(vec3_distance(kept.at[b], fresh.at[b]) < 0.05,
                          "box %d is %g m away", b,
                          vec3_distance(kept.at[b], fresh.at[b]));
    }
    const real way = 9 / 9.81;
    ck_assert_msg(fabs(slide(true) - way) < 0.01 * way
                  && fabs(slide(false) - way) < 0.01 * way,
                  "slid by %g m, %g m, not %g m", slide(true), slide(false),
                  way);
}
END_TEST

// --- tasks -------------------------------------------------------------------

// So many tasks take the items in turns; the last one goes first, backwards.
static void take_turns(void *context, void (*work)(void *, int), void *data,
                       int items)
{
    int count = *(int *)context;
    for (int t = count - 1; t >= 0; t--)
        for (int k = items - 1; k >= 0; k--)
            if (k % count == t) work(data, k);
}

// Rejects: an item that reads what another one writes; a sum in the order of
// the work.
START_TEST(any_number_of_tasks_gives_the_same_bits)
{
    static particle first[MOST];
    int count[] = { 0, 1, 2, 4 };
    for (int run = 0; run < 4; run++) {
        world_options o = world_options_default();
        if (run) o.host.run = (tasks){ take_turns, &count[run] };
        begin(o);
        for (int k = 0; k < 140; k++)
            add_thrown(k % 3 ? &box : &ball,
                       vec3_make(1.2 * (k % 7), 0.6 + 1.1 * (k / 49),
                                 1.2 * (k / 7 % 7)),
                       vec3_make(1 - k % 3, 0, k % 2), vec3_make(k % 5, 1, 0));
        add_at(&cloth, 3, 4.5, 3);
        add_floor();
        frames(60);
        ck_assert_int_gt(w.report.contacts, 100);
        if (run == 0) copy_particles(first);
        else ck_assert_msg(same_particles(first), "%d tasks", count[run]);
    }
}
END_TEST

// --- the frame ---------------------------------------------------------------

// Balls shot through a closed room at 1000 m/s, four times its width in a
// frame: each is near all six planes with all of its vertices.
// Rejects: lists with room for the contacts of three planes, where every third
// body is lost; planes that are passed in a frame.
START_TEST(nothing_leaves_a_closed_room_however_fast)
{
    const int many[] = { 24, 27, 60 };
    const int bodies = many[_i], side = bodies > 27 ? 4 : 3;
    const real cell = 1.6, room = side * cell;
    begin(world_options_default());
    for (int b = 0; b < bodies; b++)
        add_thrown(&ball, vec3_make(cell * (b % side + 0.5),
                                    cell * (b / side % side + 0.5),
                                    cell * (b / side / side + 0.5)),
                   vec3_scale(1000, random_direction(&seed)), ZERO);
    const vec3 wall[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    for (int k = 0; k < 3; k++) {
        ck_assert(world_add_plane(&w, wall[k], 0).ok);
        ck_assert(world_add_plane(&w, vec3_scale(-1, wall[k]), -room).ok);
    }
    for (int f = 0; f < 60; f++) {
        frames(1);
        for (int b = 0; b < bodies; b++) {
            vec3 x = middle(b);
            bool is_in = x.x > 0 && x.y > 0 && x.z > 0 && x.x < room
                      && x.y < room && x.z < room;
            if (!is_in) ck_abort_msg("frame %d: body %d of %d is at (%g, %g, "
                                     "%g) of %g", f, b, bodies, x.x, x.y, x.z,
                                     room);
        }
    }
}
END_TEST

// (The contacts of that frame start cold, which lets them sag once.)
// Rejects: a lost number that spreads to bodies which never met it, or changes
// what they do; an endless loop over it; a body without numbers that sleeps.
START_TEST(lost_number_stays_in_its_body)
{
    // First it is static, and never lost.
    const real lost[] = { 0, (real)NAN, HUGE_VAL, 1e200 };
    static particle first[MOST];
    for (int k = 0; k < 4; k++) {
        world_options o = world_options_default();
        o.substeps = o.most_substeps = 8;
        begin(o);
        placement p = placement_at(vec3_make(0, 900, 0));
        p.is_static = k == 0;
        int bad = add(&ball, p);
        add_at(&ball, 3, 0.6, 0);
        add_at(&box, 3.1, 1.7, 0);
        add_floor();
        frames(3);
        if (k > 0) particle_of(bad, 3)->position.x = lost[k];
        for (int f = 0; f < 60; f++) world_step(&w);
        for (int i = 0; i < FOUR; i++)
            *particle_of(bad, i) = (particle){ ZERO, ZERO, 1 };
        if (k == 0) copy_particles(first);
        for (int i = 0; i < w.pool.count; i++)
            ck_assert_msg(vec3_distance(w.pool.at[i].position,
                                        first[i].position) < 2e-3,
                          "%g spreads: %g m", lost[k], vec3_distance(w.pool.at[i].position, first[i].position));
        ck_assert(!probe_sleeps(&w, bad));
    }
}
END_TEST

// Rejects: a world that is lost without a word: bodies far under the floor, and
// a report that says nothing.
START_TEST(frame_of_a_second_says_what_it_could_not_do)
{
    world_options o = world_options_default();
    o.dt = 1;
    begin(o);
    for (int k = 0; k < 9; k++)
        add_at(k % 2 ? &ball : &box, 1.1 * (k % 3), 0.6 + 1.1 * (k / 3), 0);
    add_floor();
    int told = 0, deep = 0;
    for (int f = 0; f < 30; f++) {
        world_step(&w);
        told += w.report.unconverged > 0 || w.report.dropped > 0;
        for (int b = 0; b < w.bodies; b++) {
            vec3 x = middle(b);
            ck_assert(vec3_is_finite(x));
            ck_assert_msg(x.y > -0.5, "frame %d: body %d is at %g", f, b, x.y);
            deep += x.y < 0.3;
        }
    }
    ck_assert_msg(deep == 0 || told > 0, "%d were deep in the floor, and "
                  "nothing is said of it", deep);
}
END_TEST

// Falls that end in a heap.
static void add_heap(void)
{
    add_nailed(&low, 0, 0.25, 0);
    for (int k = 0; k < 12; k++)
        add_at(k % 2 ? &box : &ball, 0.3 * (k % 3), 1.2 + 1.1 * (k / 2), 0);
    add_at(&cloth, 0, 9, 0);
    add_at(&rope, 0, 9.5, 0);
    add_floor();
}

// Rejects: memory that is taken in every frame.
START_TEST(step_allocates_only_to_grow)
{
    begin(world_options_default());
    add_heap();
    frames(1200);                       // tables have grown until then
    long before = mallocs_made;
    for (int f = 0; f < 90; f++) world_step(&w);
    long after = mallocs_made;
    ck_assert_int_eq(after - before, 0);
    ck_assert_int_gt(before, 20);       // the building was counted
}
END_TEST

// Memory that runs out at any moment of forty frames, and is there again later.
// Rejects: a crash; contacts that are lost without a word, or for good.
START_TEST(frame_without_memory_says_so_and_goes_on)
{
    enum { ENOUGH = 64 };   // allocations: how many there are, the heap decides
    int least = INT_MAX;
    for (int n = 0; n < ENOUGH; n++) {
        begin(world_options_default());
        add_heap();
        int dropped = 0;
        long before = mallocs_made;
        mallocs_left = n;
        for (int f = 0; f < 40; f++) {
            world_step(&w);
            dropped += w.report.dropped;
        }
        bool is_refused = mallocs_made - before > n;
        mallocs_left = INT_MAX;
        ck_assert_msg(!is_refused || dropped > 0, "%d allocations: nothing is "
                      "said of it", n);
        frames(1);
        if (!is_refused && least > n) least = n;
        for (int b = 0; b < w.bodies; b++)
            ck_assert(vec3_is_finite(middle(b)));
        if (!is_refused) break;
    }
    ck_assert_int_gt(least, 3);
    ck_assert_int_lt(least, ENOUGH);
}
END_TEST

static real ticks;

static real tick(void)
{
    return ticks++;
}

// Rejects: a phase whose time is booked twice, or not at all; a clock that is
// asked although there is none.
START_TEST(phases_add_up_to_the_frame)
{
    world_options o = world_options_default();
    o.host.clock = tick;
    begin(o);
    add_at(&box, 0, 0.6, 0);
    add_at(&cloth, 0, 1.2, 0);
    add_floor();
    for (int f = 0; f < 10; f++) {
        ticks = 100;
        frames(1);
        real sum = 0;
        for (int k = 0; k < PHASES; k++) {
            ck_assert(w.report.time[k] > 0);
            sum += w.report.time[k];
        }
        // The first look at the clock starts it.
        ck_assert(sum == ticks - 100 - 1);
    }
    begin(world_options_default());
    add_at(&box, 0, 0.6, 0);
    frames(1);
    for (int k = 0; k < PHASES; k++) ck_assert(w.report.time[k] == 0);
}
END_TEST

// Rejects: anything that remembers more than the world does: an address, a
// static, memory that was never written.
START_TEST(same_world_takes_the_same_steps)
{
    static particle first[MOST];
    for (int run = 0; run < 2; run++) {
        begin(world_options_default());
        void *litter = malloc(1000 + 5000 * (size_t)run);
        add_nailed(&low, 0, 0.25, 0);
        add_at(&box, 0.1, 1.2, 0);
        add_at(&ball, 0.3, 2.4, 0.1);
        add_at(&cloth, 0, 3.2, 0);
        add_at(&rope, 0, 3.5, 0);
        add_floor();
        free(litter);
        for (int f = 0; f < 60; f++) world_step(&w);
        if (run == 0) copy_particles(first);
    }
    ck_assert(same_particles(first));
}
END_TEST

// Rejects: sizes of nothing that are divided by.
START_TEST(empty_world_steps)
{
    frames(3);
    ck_assert(fabs(w.time - 0.05) <= FALL_ROUNDING);
}
END_TEST

// --- extremes ----------------------------------------------------------------

// A cube of half side `room` (m) around the origin, closed by six planes.
static void add_walls(real room)
{
    for (int k = 0; k < 6; k++) {
        vec3 n = { k / 2 == 0, k / 2 == 1, k / 2 == 2 };
        ck_assert(world_add_plane(&w, vec3_scale(k % 2 ? -1 : 1, n), -room).ok);
    }
}

// A thin plate under thirteen times gravity in frames of a tenth of a second,
// and a brick ever faster, in frames of a second.
// Rejects: walls of which a frame knows only the corners that were lowest.
START_TEST(no_centre_leaves_a_closed_room)
{
    shape plate;
    ck_assert(shape_box(&plate, vec3_make(0.03, 4e-4, 0.03), 5).ok);
    for (int k = 0; k < 6; k++) {
        world_options o = without_sleep();
        o.dt = k == 0 ? 0.1 : 1;
        o.friction = 1000;
        if (k == 0) o.gravity = vec3_make(0, -126, 0);
        begin(o);
        vec3 v = { 1, -2, 3 }, spin = { 3, 5, 4 };
        for (int i = 0; i < k; i++) v = vec3_scale(10, v);
        add_thrown(k == 0 ? &plate : &brick, ZERO, v, vec3_scale(k, spin));
        add_walls(0.3);
        for (int f = 0; f < 200; f++) {
            frames(1);
            vec3 c = middle(0);
            real far = fmax(fabs(c.x), fmax(fabs(c.y), fabs(c.z)));
            ck_assert_msg(far <= 0.3 + 1e-9, "%d, frame %d: at %g m", k, f,
                          far);
        }
    }
    shape_free(&plate);
}
END_TEST

// A pebble in a cloth that wraps it, pinned at its corners, thrown ever faster.
// Rejects: a body that turns by 1e19 rad within a frame, is slow at its end,
// and has lost its place to rounding.
START_TEST(no_body_goes_further_than_its_energy_takes_it)
{
    for (int k = 0; k < 4; k++) {
        begin(without_gravity());
        int sheet = add_at(&cloth, 0, 0, 0), last = cloth.particles - 1;
        world_pin(&w, sheet, 0);
        world_pin(&w, sheet, last);
        real speed = 3 * pow(10, k);
        int b = add_thrown(&ball, vec3_make(0, 0.8, 0),
                           vec3_make(0, -speed, 0), vec3_make(0, 0, speed));
        for (int f = 0; f < 60; f++) {
            vec3 was = middle(b);
            real most = sqrt(2 * kinetic() / w.body[b].mass) * w.options.dt;
            frames(1);
            real way = vec3_distance(middle(b), was);
            ck_assert_msg(way <= 1.01 * most + 1e-3, "%g m/s, frame %d: %g of "
                          "%g m", speed, f, way, most);
        }
    }
}
END_TEST

// Needles of a hundredth of a millimetre under a hundred times gravity, thrown
// about in a box of their own size, with a friction of 1000.  Beside gravity
// only what pushes overlaps out, by 0.055 radii a frame in each of its four parts,
// adds to their motion.
// Rejects: impulses along rows of the frame's start that give energy; numbers
// that grow until they are none.
START_TEST(contacts_create_no_motion)
{
    shape needle;
    world_options o = without_sleep();
    ck_assert(shape_box(&needle, vec3_make(1e-5, 2e-5, 8e-3), 1).ok);
    o.friction = 1000;
    o.gravity = vec3_make(0, -1000, 0);
    o.dt = 0.2;
    begin(o);
    for (int b = 0; b < 24; b++)
        add_thrown(&needle, random_vec3(&seed, 0.006), random_vec3(&seed, 1),
                   ZERO);
    add_walls(0.012);
    for (int f = 0; f < 200; f++) {
        real most = sqrt(kinetic()) + sqrt(24 / 2.0) * (1000 * o.dt + 12);
        frames(1);
        real now = sqrt(kinetic());
        ck_assert_msg(now <= 1.001 * most, "frame %d: %g of %g", f, now, most);
    }
    shape_free(&needle);
}
END_TEST

// Two boxes that push each other in mid-air drift at `drift`, and come apart by
// `apart` on either side of that, with more energy than the guard allows them.
// Returns what of `apart` it leaves the first, and how the two drift then.
static real slowed(real drift, real apart, real *then)
{
    begin(without_gravity());
    add_at(&box, 0, 0, 0);
    add_at(&box, 0.995, 0, 0);
    frames(1);
    motion *u = probe_velocity(&w, 0);
    for (int b = 0; b < 2; b++)
        u[b] = (motion){ { b ? drift + apart : drift - apart } };
    island *both = probe_budget(&w, 0);
    both->most = drift * drift + apart * apart / 4;
    guard_brake(&w, 0);
    *then = (u[0].of[0] + u[1].of[0]) / 2;
    return (u[1].of[0] - u[0].of[0]) / (2 * apart);
}

// Each box weighs 1 kg: drift^2 + apart^2 joules, of which a quarter of the second
// may stay, so half of the speed.  Rejects: a share of all that the world sees,
// which brakes the passengers of a train.
START_TEST(island_with_too_much_energy_keeps_its_momentum)
{
    for (real drift = 0; drift <= 16; drift = 4 * drift + 1) {
        real then, left = slowed(drift, 0.25, &then);
        ck_assert_double_eq_tol(left, 0.5, 1e-12);
        ck_assert_double_eq_tol(then, drift, 1e-12 * (1 + drift));
    }
}
END_TEST

// A ball that turns by 1,667 rad in a frame, ten metres from another.
// Rejects: a body that may get as far as its turn is long.
START_TEST(turning_body_reaches_no_further_than_across)
{
    begin(without_gravity());
    add_thrown(&ball, ZERO, ZERO, vec3_make(0, 1e5, 0));
    add_at(&ball, 10, 0, 0);
    frames(3);
    ck_assert_int_eq(w.report.pairs, 0);
    ck_assert_int_eq(w.report.contacts, 0);
}
END_TEST

// A cloth that a ball flies through at 3 km/s, beside another that flies as
// fast towards a third: a frame in four parts.
// Rejects: most_substeps in each of the parts.
START_TEST(divided_frame_takes_no_more_substeps_than_it_may)
{
    world_options o = without_gravity();
    o.most_substeps = 100;
    begin(o);
    add_at(&cloth, 0, 0, 0);
    add_thrown(&ball, vec3_make(0, 3, 0), vec3_make(0, -3e3, 0), ZERO);
    add_thrown(&ball, vec3_make(9, 3, 0), vec3_make(0, -3e3, 0), ZERO);
    add_at(&ball, 9, 1.5, 0);
    int most = 0;
    for (int f = 0; f < 4; f++) {
        frames(1);
        most = w.report.substeps > most ? w.report.substeps : most;
    }
    ck_assert_int_eq(most, 100);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        free_fall_is_a_parabola,
        static_bodies_keep_every_bit,
        free_spin_keeps_angular_momentum_and_energy,
        colliding_bodies_keep_their_momentum,
        impact_goes_through_a_row,
        box_that_falls_flat_bounces_to_the_square_of_its_restitution,
        bounce_is_exact_in_any_substeps,
        boxes_that_meet_head_on_part_at_restitution_times_their_speed,
        impact_goes_through_a_cradle_from_either_end,
        full_restitution_never_gives_energy,
        boxes_that_bounce_off_all_sides_keep_their_energy,
        bouncing_box_may_stand,
        box_that_falls_flat_stays_flat,
        body_lands_on_a_static_one_wherever_it_stands,
        boxes_in_touch_are_not_pushed_apart,
        cubes_of_a_centimetre_stand,
        heavy_stands_on_light,
        stack_that_is_awake_lies_still,
        old_overlap_is_pushed_out_and_not_thrown,
        warm_start_carries_a_stack,
        hertz_and_substeps_make_contacts_stiffer,
        what_turns_violently_keeps_its_shape,
        boxes_that_collide_in_space_keep_their_angular_momentum,
        tower_that_is_awake_stands_with_eight_substeps,
        every_option_carries_a_box,
        world_that_keeps_nothing_behaves_alike,
        any_number_of_tasks_gives_the_same_bits,
        lost_number_stays_in_its_body,
        frame_of_a_second_says_what_it_could_not_do,
        step_allocates_only_to_grow,
        frame_without_memory_says_so_and_goes_on,
        phases_add_up_to_the_frame,
        same_world_takes_the_same_steps,
        empty_world_steps,
        no_centre_leaves_a_closed_room,
        contacts_create_no_motion,
        no_body_goes_further_than_its_energy_takes_it,
        island_with_too_much_energy_keeps_its_momentum,
        turning_body_reaches_no_further_than_across,
        divided_frame_takes_no_more_substeps_than_it_may,
        NULL
    };
    return suite_run((suite){
        .name = "step", .tests = tests, .set_up = set_up,
        .tear_down = tear_down, .seconds = 20,
        .repeated = { { towers_stand, 0, 3 },
                      { nothing_leaves_a_closed_room_however_fast, 0, 3 } }
    });
}
