// check_step.c - does a frame do what it should, and nothing else?
// Book: chapter 9.

#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "ledger.h"
#include "scarce.h"
#include "stage.h"
#include "step.h"

// A second is 480 sums of positions near 10; each one's rounding goes on as a
// velocity, so that errors grow as 480^2 / 2 * 1e-15.
#define FALL_ROUNDING 1e-9
// Momentum: every push is a pair of products that cancel but for rounding.
#define MOMENTUM 1e-12

// Sums of a thousand bookings of what there is in all.
#define BOOKS 1e-11
// A hundredth: of its way, or of its energy.
#define SLIDING 0.01

// --- a world -----------------------------------------------------------------

static shape box, low, ball, cloth, rope;

static void set_up(void)
{
    ck_assert(shape_box(&box, vec3_make(1, 1, 1), 1).ok);
    ck_assert(shape_box(&low, vec3_make(2, 0.5, 2), 4).ok);
    ck_assert(shape_icosahedron(&ball, 0.5, 1).ok);
    ck_assert(shape_cloth(&cloth, 10, 10, 1, 1, 1, 0.2).ok);
    ck_assert(shape_rope(&rope, 12, 1.2, 0.3).ok);
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

// Takes body b there, upright, with that velocity.
static void bring(int b, vec3 at, vec3 velocity)
{
    const body *x = &w.body[b];
    for (int i = 0; i < body_particles(x); i++) {
        particle *p = particle_of(b, i);
        p->position = vec3_add(at, body_is_soft(x) ? x->plan->at[i]
                                                    : x->four->at[i]);
        p->previous = vec3_add_scaled(p->position, -w.age, velocity);
    }
}

// n frames; nothing may be dropped.
static void frames(int n)
{
    for (int k = 0; k < n; k++) {
        world_step(&w);
        ck_assert_int_eq(w.report.dropped, 0);
    }
}

// Steps until so many sleep, at most `most` frames; 1 if they do.
static int sleeps(int bodies, int most)
{
    for (int k = 0; k < most; k++) {
        frames(1);
        if (w.report.asleep == bodies) return 1;
    }
    return 0;
}

static world_options without_gravity(void)
{
    world_options o = world_options_default();
    o.gravity = ZERO;
    return o;
}

// The chapter's measures stand to the right of the step: here are their own.
static vec3 momentum(void)
{
    vec3 sum = ZERO;
    for (int i = 0; i < w.pool.count; i++) {
        const particle *p = &w.pool.at[i];
        if (p->inverse_mass == 0) continue;
        sum = vec3_add_scaled(sum, 1 / (w.age * p->inverse_mass),
                              vec3_sub(p->position, p->previous));
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
                q[k] = (hull){ at[k], x[k]->plan->particles };
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

static int same_particles(const particle *was)
{
    return memcmp(was, w.pool.at, (size_t)w.pool.count * sizeof *was) == 0;
}

// --- flight ------------------------------------------------------------------

// Rejects: a start or a substep of the wrong order; gravity twice, or once a
// frame; sticks that act on what they need not.
START_TEST(free_fall_is_a_parabola)
{
    const vec3 v = { 1, 4, -2 };
    for (int k = 1; k < 10; k *= 3) {
        world_options o = world_options_default();
        o.substeps = k;
        begin(o);
        const shape *s[] = { &box, &ball, &cloth, &rope };
        vec3 from[4];
        for (int b = 0; b < 4; b++) {
            from[b] = vec3_make(5 * b, 3, 0);
            add_thrown(s[b], from[b], v, ZERO);
        }
        ready();
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

// Rejects: a body that is stepped although it is nailed, in any way at all.
START_TEST(nailed_bodies_keep_every_bit)
{
    begin(world_options_default());
    int b = add_nailed(&low, 1, 2, 3);
    add_at(&ball, 1, 3, 3);
    add_at(&cloth, 1, 4, 3);
    ready();
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

// --- blows -------------------------------------------------------------------

// Two bodies without gravity, the second thrown at the first: their momentum.
static void keeps_momentum(const shape *a, const shape *b, world_options o)
{
    begin(o);
    add_at(a, 0, 0, 0);
    add_thrown(b, vec3_make(0.2, 2.1, 0.1), vec3_make(0.3, -6, -0.4),
               vec3_make(1, -2, 3));
    ready();
    vec3 before = momentum();
    frames(60);
    vec3 after = momentum();
    ck_assert_msg(vec3_distance(before, after)
                  <= MOMENTUM * 480 * vec3_length(before),
                  "momentum changed by %g", vec3_distance(before, after));
    // They have met: what rested now moves down.
    ck_assert_msg(middle(0).y < -0.05, "no blow: %g", middle(0).y);
}

// Rejects: a push, friction, a bounce, a stick or a fallen-back solve that acts
// on one side alone.
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

// A row of boxes, 5 cm apart, and a quick one: each passes the blow on in the
// middle of a frame, and crosses the gap before its end.
// Rejects: contacts of a frame's start alone, or only of those that move then:
// the second box would pass into the third.
START_TEST(blow_goes_through_a_row_in_one_frame)
{
    const real speeds[] = { 2, 10, 20 };
    for (int k = 0; k < 3; k++) {
        begin(without_gravity());
        for (int b = 0; b < 4; b++)
            add_at(&box, 1.05 * b, 0.01 * b, 0.02 * b);
        add_thrown(&box, vec3_make(-1.05 - speeds[k] / 90, 0, 0),
                   vec3_make(speeds[k], 0, 0), ZERO);
        ready();
        real deepest = 0;
        for (int f = 0; f < 40; f++) {
            frames(1);
            deepest = fmax(deepest, penetration());
        }
        ck_assert_msg(deepest <= 0.05 * box.radius, "%g m deep at %g m/s",
                      deepest, speeds[k]);
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
    ready();
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

// Rejects: an option that nobody reads; a bounce that adds energy; a bounce of
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

// J and m, of 9.81 J and 1 m: what the blow knows of the moment of touching.
#define EXACT 1e-7

// A frame of any substeps: what falls is a parabola, and so is what rises.
// Rejects: gravity left out of the blow; the speed of the substep before it.
START_TEST(bounce_of_four_particles_is_exact_in_any_substeps)
{
    for (int k = 0; k < 10; k++) {
        world_options o = world_options_default();
        o.substeps = 1 << k / 2;
        o.restitution = k % 2 ? 1 : 0.5;
        begin(o);
        add_at(&box, 0, 1.5, 0);
        add_floor();
        ready();
        real floor = 0.5 + w.body[0].thickness, e = o.restitution;
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
    o.passes = 20;
    begin(o);
    add_thrown(&box, vec3_make(-1, 0, 0), vec3_make(2.5, 0, 0), ZERO);
    add_thrown(&box, vec3_make(1, 0, 0), vec3_make(-2.5, 0, 0), ZERO);
    ready();
    frames(60);
    real a = middle(0).x, b = middle(1).x;
    frames(6);
    ck_assert_msg(vec3_length(momentum()) < 1e-12, "momentum of %g",
                  vec3_length(momentum()));
    return (middle(1).x - b - middle(0).x + a) / (6 * o.dt);
}

// m/s, of 5: as far as corners and sticks agree after their rounds.
static const real PARTING = 1e-5;

// Rejects: a bounce that is not shared by mass, so that momentum is lost.
START_TEST(boxes_that_meet_head_on_part_at_restitution_times_their_speed)
{
    for (int k = 0; k <= 2; k++) {
        real e = k / 2.0, parting = parting_speed(e);
        ck_assert_msg(fabs(parting - 5 * e) < PARTING,
                      "restitution %g: %g m/s", e, parting);
    }
}
END_TEST

// m/s, a hundredth of the blow.
#define CRADLE 0.05

// A row of boxes, hit from the left (side -1) or from the right at 5 m/s.
static void cradle(int row, int side)
{
    world_options o = without_gravity();
    o.restitution = 1;
    begin(o);
    real apart = 1.001 + 2 * o.skin * box.radius;
    for (int b = 0; b < row; b++)
        add_at(&box, (b - (row - 1) / 2.0) * apart, 0, 0);
    add_thrown(&box, vec3_make(side * (row + 3) / 2.0 * apart, 0, 0),
               vec3_make(-side * 5, 0, 0), ZERO);
    ready();
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
// Rejects: a blow that is passed on once a substep, so that each pushes into
// the next; one that is shared by the whole row; one that needs a round for
// each of them where it runs against their order.
START_TEST(blow_goes_through_a_cradle_from_either_end)
{
    for (int side = -1; side < 2; side += 2) {
        cradle(5, side);
        cradle(12, side);
    }
}
END_TEST

// Rejects: a blow of what only stands, which hops by what gravity brings in a
// substep, and forgets its pushes.
START_TEST(bouncing_box_may_stand)
{
    world_options o = world_options_default();
    o.restitution = 1;
    o.resting = 0;
    begin(o);
    add_at(&box, 0, 0.5 + 0.005 * box.radius, 0);
    add_floor();
    ready();
    real was = middle(0).y;
    for (int f = 0; f < 120; f++) {
        frames(1);
        ck_assert_msg(fabs(middle(0).y - was) < 1e-3, "it hops by %g m",
                      middle(0).y - was);
        ck_assert_int_eq(w.report.pushing, 4);
    }
}
END_TEST

// m, of a slab of 2 m: a thousandth.
#define FLAT 0.002

// Rejects: a landing that tilts what falls flat, at some moment of a substep.
START_TEST(box_that_falls_flat_stays_flat)
{
    for (int k = 0; k < 8; k++) {
        world_options o = world_options_default();
        o.restitution = k % 2;
        begin(o);
        add_at(&low, 0, 1 + 0.013 * k, 0);
        add_floor();
        ready();
        for (int f = 0; f < 60; f++) {
            frames(1);
            real least = HUGE_VAL, most = -HUGE_VAL;
            for (int i = 0; i < 8; i++) {
                real y = vertex_of(0, i).y;
                if (box.at[i].y > 0) continue;
                least = fmin(least, y);
                most = fmax(most, y);
            }
            ck_assert_msg(most - least <= FLAT, "frame %d: tilted by %g m", f,
                          most - least);
        }
    }
}
END_TEST

// --- standing ----------------------------------------------------------------

// Rejects: a nailed body whose tree stands elsewhere, so that nobody meets it;
// a margin that ends before the body arrives.
START_TEST(body_lands_on_a_nailed_one_wherever_it_stands)
{
    const vec3 at[] = { { 0, 0, 0 }, { 10, 3, -7 }, { -300, 40, 500 } };
    const real from[] = { 0.8, 3, 12 };
    for (int k = 0; k < 9; k++) {
        vec3 x = at[k % 3];
        real height = from[k / 3];
        begin(world_options_default());
        add_nailed(&low, x.x, x.y, x.z);
        add_at(&box, x.x, x.y + 0.25 + 0.5 + height, x.z);
        ready();
        frames(150);
        vec3 now = middle(1);
        ck_assert_msg(fabs(now.y - x.y - 0.75) < 0.1
                      && fabs(now.x - x.x) < 0.5 && fabs(now.z - x.z) < 0.5,
                      "dropped from %g m it is at (%g, %g, %g) from the slab",
                      height, now.x - x.x, now.y - x.y, now.z - x.z);
    }
}
END_TEST

// Rejects: a body that sinks, creeps or trembles for ever; a sleeper that moves
// by a bit, or costs a single look at a stick.
START_TEST(dropped_box_comes_to_rest_and_sleeps_for_nothing)
{
    begin(world_options_default());
    placement p = placement_at(vec3_make(0, 1.4, 0));
    p.x = vec3_make(0.6, 0, 0.8);
    p.y = vec3_make(-0.48, 0.8, 0.36);
    p.z = vec3_make(-0.64, -0.6, 0.48);
    int b = add(&box, p);
    add_floor();
    ready();
    frames(5);
    ck_assert_int_gt(w.report.tested, 0);
    ck_assert(sleeps(1, 600));
    vec3 at = middle(b);
    // Flat, on any side: its middle half a side above the floor, its skin and a
    // hundredth of its size besides.
    ck_assert_msg(at.y > 0.5 - 0.01 && at.y < 0.5 + w.body[b].thickness + 0.01,
                  "rests at %g", at.y);
    ck_assert(vec3_length(vec3_make(at.x, 0, at.z)) < 2);
    static particle asleep[MOST];
    copy_particles(asleep);
    frames(120);
    ck_assert_int_eq(w.report.asleep, 1);
    ck_assert_int_eq(w.report.tested, 0);
    ck_assert_int_eq(w.report.relaxed, 0);
    ck_assert(same_particles(asleep));
    for (int i = 0; i < w.pool.count; i++)
        ck_assert(vec3_distance(asleep[i].position, asleep[i].previous) == 0);
    // The others see it where it lies, to the last bit.
    for (int i = 0; i < 8; i++)
        ck_assert(vec3_distance(w.of.at[w.body[b].corner + i],
                                vertex_of(b, i)) == 0);
    const body *x = &w.body[b];
    for (int k = 0; k < FOUR_STICKS; k++)
        ck_assert(stick_strain(x->four->stick[k], particle_of(b, 0)) <= 0.01);
}
END_TEST

// Rejects: sleep although it is not asked for.
START_TEST(nobody_sleeps_where_resting_is_off)
{
    world_options o = world_options_default();
    o.resting = 0;
    begin(o);
    add_at(&box, 0, 0.5, 0);
    add_floor();
    ready();
    frames(120);
    ck_assert_int_eq(w.report.asleep, 0);
    ck_assert_int_gt(w.report.tested, 0);
}
END_TEST

// Rejects: a sleeper that is a rock for ever; one that wakes too late to take
// its part of the blow; waking that reaches a box far away.
START_TEST(second_box_thrown_at_a_sleeper_wakes_it)
{
    begin(world_options_default());
    int first = add_at(&box, 0, 0.51, 0), far = add_at(&box, 9, 0.51, 0);
    int shot = add_at(&box, 0, 500, 0);
    add_floor();
    ready();
    ck_assert(sleeps(2, 400));
    vec3 was = middle(first);
    bring(shot, vec3_make(was.x - 1.5, 0.6, was.z), vec3_make(8, 0, 0));
    int woke = 0;
    for (int f = 0; f < 60 && !woke; f++) {
        frames(1);
        woke = !w.rest.asleep[first];
        if (!woke) ck_assert(middle(first).x == was.x);
    }
    ck_assert(woke);
    frames(30);
    ck_assert_msg(middle(first).x > was.x + 0.2, "moved by %g",
                  middle(first).x - was.x);
    ck_assert_msg(penetration() < 0.05 * box.radius,
                  "%g deep", penetration());
    ck_assert(w.rest.asleep[far]);
}
END_TEST

// Rejects: waking by whatever lies near, which would keep a whole heap awake
// for its last restless body's neighbours.
START_TEST(calm_neighbour_lets_a_sleeper_sleep)
{
    begin(world_options_default());
    int first = add_at(&box, 0, 0.51, 0), other = add_at(&box, 0, 500, 0);
    add_floor();
    ready();
    ck_assert(sleeps(1, 400));
    vec3 at = vec3_add(middle(first), vec3_make(1.01, 0, 0));
    bring(other, at, ZERO);
    for (int f = 0; f < 20; f++) {
        w.rest.calm[other] = 0.1;
        frames(1);
        ck_assert(w.rest.asleep[first]);
    }
}
END_TEST

// Rejects: a skin that only planes know; a skin taken for an overlap.
START_TEST(bodies_at_rest_keep_their_skins_apart)
{
    world_options o = world_options_default();
    o.skin = 0.02;
    begin(o);
    add_nailed(&low, 0, -0.25, 0);
    add_at(&box, 0.1, 0.6, 0.05);
    ready();
    ck_assert(sleeps(1, 400));
    real apart = 0.02 * (low.radius + box.radius), gap = middle(1).y - 0.5;
    ck_assert_msg(gap > apart / 2 && gap < 1.2 * apart,
                  "the gap is %g, the skins %g", gap, apart);
    ck_assert(penetration() == 0);
}
END_TEST

// Rejects: islands that know only the contacts of the last substep: the upper
// box would go on sleeping in the air.
START_TEST(sleepers_on_a_sleeper_wake_with_it)
{
    for (int k = 0; k < 4; k++) {
        begin(world_options_default());
        int base = add_at(&low, 0, 0.26, 0);
        int upper = add_at(&box, 0.04 * k, 1.03, 0.02 * k);
        int shot = add_at(&box, 0, 500, 0);
        add_floor();
        ready();
        if (!sleeps(2, 900)) ck_abort_msg("the stack does not come to rest");
        // Whatever they do, they may not both sleep apart while one lies on
        // the other.
        int stands = middle(upper).y > 0.9;
        ck_assert_msg(stands, "the upper box fell off");
        bring(shot, vec3_make(-1.9, 0.6, 0), vec3_make(9, 0, 0));
        for (int f = 0; f < 60 && w.rest.asleep[base]; f++) frames(1);
        ck_assert(!w.rest.asleep[base]);
        ck_assert(!w.rest.asleep[upper]);
        bring(base, vec3_make(50, 0.5, 0), ZERO);
        frames(60);
        ck_assert_msg(middle(upper).y < 0.8, "it hangs in the air at %g",
                      middle(upper).y);
    }
}
END_TEST

// Rejects: a deformable body that nothing wakes: a rope at rest would catch a
// cloth like a rod; a cloth at rest would hang in the air when what it lies on
// is taken away.
START_TEST(deformable_sleepers_wake_too)
{
    begin(world_options_default());
    int r = add_at(&rope, 0, 0.1, 0), c = add_at(&cloth, 0, 9000, 0);
    add_nailed(&box, -0.6, -0.5, 0);
    add_nailed(&box, 0.6, -0.5, 0);
    ready();
    // It lies on two boxes, and creeps into the gap between them for a while.
    ck_assert(sleeps(1, 1200));
    ck_assert(w.rest.asleep[r]);
    bring(c, vec3_make(0, 0.5, 0), vec3_make(0, -16, 0));
    int woke = 0;
    for (int f = 0; f < 30; f++) {
        frames(1);
        woke |= !w.rest.asleep[r];
    }
    ck_assert(woke);
    ck_assert(middle(c).y < 0.4);
}
END_TEST

static int island_of(int b)
{
    while (w.rest.parent[b] != b) b = w.rest.parent[b];
    return b;
}

// Rejects: a cloth that falls asleep while what it lies on still moves, or that
// goes on hanging when it wakes.
START_TEST(cloth_is_of_the_island_of_what_it_lies_on)
{
    begin(world_options_default());
    int b = add_at(&box, 0, 0.52, 0), c = add_at(&cloth, 0, 1.1, 0);
    int far = add_at(&box, 9, 0.52, 0), nailed = add_nailed(&box, 0, 1.8, 0);
    add_floor();
    ready();
    frames(3);
    ck_assert_int_eq(island_of(b), island_of(c));
    ck_assert_int_ne(island_of(far), island_of(c));
    ck_assert_int_ne(island_of(nailed), island_of(c));
}
END_TEST

// A cloth that falls flat from 0.3 m, 2.4 m/s.
// Rejects: a landing that throws it up again, or tears at it; one that takes
// the sticks more than their iterations.
START_TEST(cloth_that_lands_flat_stays_down)
{
    begin(world_options_default());
    int c = add_at(&cloth, 0, 0.3, 0);
    add_floor();
    ready();
    int landed = 0;
    for (int f = 0; f < 120; f++) {
        frames(1);
        real y = middle(c).y, thick = w.body[c].thickness;
        landed |= y < 1.001 * thick;
        ck_assert_msg(y > 0.999 * thick, "sunk to %g", y);
        if (landed) ck_assert_msg(y < 1.01 * thick, "up again at %g", y);
        for (int k = 0; k < cloth.sticks; k++)
            ck_assert(stick_strain(cloth.stick[k], particle_of(c, 0)) < 1e-3);
    }
    ck_assert(landed);
}
END_TEST

// Rejects: planes that cloth and rope do not meet, or without their thickness.
START_TEST(everything_stays_above_a_plane)
{
    begin(world_options_default());
    add_floor();
    const shape *s[] = { &box, &ball, &cloth, &rope };
    for (int b = 0; b < 4; b++) {
        placement p = placement_at(vec3_make(4 * b, 2, 0));
        // Steep, so that an edge comes first.
        p.x = vec3_make(0.6, 0.8, 0);
        p.y = vec3_make(-0.8, 0.6, 0);
        add(s[b], p);
    }
    ready();
    for (int f = 0; f < 180; f++) {
        frames(1);
        for (int b = 0; b < 4; b++)
            for (int i = 0; i < s[b]->particles; i++) {
                real y = vertex_of(b, i).y;
                ck_assert_msg(y > -0.05 * s[b]->radius, "body %d is at %g", b,
                              y);
            }
    }
    for (int b = 0; b < 4; b++) {
        ck_assert(middle(b).y < 0.6);
        for (int i = 0; i < s[b]->particles; i++)
            ck_assert(vertex_of(b, i).y > 0.9 * w.body[b].thickness - 0.005);
    }
}
END_TEST

// --- mending, memory, pairs: the options of bodies of four particles ---------

// A slab that is found `deep` in the floor; returns how deep it is after n
// frames, and in *speed how fast it goes then.
static real sunken(world_options o, real deep, int n, real *speed)
{
    begin(o);
    add_at(&low, 0, 0.25 - deep, 0);
    add_floor();
    ready();
    frames(n);
    real before = middle(0).y;
    frames(1);
    *speed = (middle(0).y - before) / o.dt;
    return 0.25 - middle(0).y;
}

// Rejects: an overlap that throws; one that stays; options that nobody reads.
START_TEST(old_overlap_is_mended_at_the_pace_of_its_options)
{
    world_options o = world_options_default();
    real speed;
    o.skin = 0;
    o.mend = 0;
    o.least_substeps = o.substeps;
    real left = sunken(o, 0.1, 30, &speed);
    ck_assert_msg(fabs(left - 0.1) < 1e-3 && fabs(speed) < 0.01,
                  "without mending it is %g m deep, at %g m/s", left, speed);
    // A fifth of a corner's overlap is less of the slab's, which four corners
    // move in turn.  Three frames of four substeps.
    o.mend = 0.2;
    o.mend_speed = 1000;
    left = sunken(o, 0.1, 2, &speed);
    ck_assert_msg(left > 0.1 * pow(0.8, 12) && left < 0.1 * pow(0.9, 12),
                  "%g m deep", left);
    left = sunken(o, 0.1, 30, &speed);
    ck_assert_msg(fabs(left) < 1e-3 && fabs(speed) < 0.01, "%g m deep, %g m/s",
                  left, speed);
    // At most 0.3 m/s at a corner: 10 cm take 20 frames or more.
    o.mend_speed = 0.3;
    left = sunken(o, 0.1, 9, &speed);
    ck_assert_msg(left > 0.05 && left < 0.08 && speed < 0.3 && speed > 0.15,
                  "%g m deep, %g m/s", left, speed);
}
END_TEST

// Rejects: a memory that is lost from frame to frame, or kept in spite of the
// option: without one a stack of boxes has no time to find its pushes.  (In the
// end it leans, and falls over.)
START_TEST(memory_carries_a_stack)
{
    enum { BOXES = 8 };
    real sunk[2], lean[2], skin = 0;
    for (int memory = 0; memory < 2; memory++) {
        world_options o = world_options_default();
        o.memory = memory;
        o.resting = 0;
        begin(o);
        for (int k = 0; k < BOXES; k++) add_at(&box, 0, 0.51 + 1.01 * k, 0);
        add_floor();
        ready();
        frames(memory ? 120 : 180);
        // Every corner carries, in either case.
        ck_assert_int_eq(w.report.pushing, 4 * BOXES);
        skin = w.body[0].thickness;
        real free = BOXES - 0.5 + (2 * BOXES - 1) * skin;
        vec3 top = middle(BOXES - 1);
        sunk[memory] = free - top.y;
        lean[memory] = hypot(top.x, top.z);
    }
    ck_assert_msg(sunk[1] < skin && sunk[1] > -skin, "sunk by %g m", sunk[1]);
    ck_assert_msg(sunk[0] > 20 * skin, "%g m without", sunk[0]);
    // How far it leans hangs on the last bits: over starts that differ by 1e-7 m,
    // 0.2 to 1.6 skins, and less later; without, 12 to 33, and it falls.
    ck_assert_msg(lean[1] < 2 * skin, "it leans by %g m", lean[1]);
    ck_assert_msg(lean[0] > 8 * skin, "%g m without", lean[0]);
}
END_TEST

// Rejects: passes that are lost with the substeps that a slow frame saves.
START_TEST(frame_of_fewer_substeps_has_as_many_passes)
{
    vec3 end[3];
    for (int k = 0; k < 3; k++) {
        world_options o = world_options_default();
        o.substeps = k == 0 ? 4 : 2;
        o.least_substeps = 2;
        o.passes = k == 0 ? 6 : k == 1 ? 12 : 6;
        o.memory = 0;
        o.content = 0;
        begin(o);
        for (int b = 0; b < 5; b++) add_at(&box, 0.01 * b, 0.5 + b, 0);
        add_floor();
        ready();
        // The first substep, too, is as long as the one before.
        w.age = o.dt / 2;
        for (int i = 0; i < w.pool.count; i++)
            w.pool.at[i].previous = w.pool.at[i].position;
        frames(10);
        ck_assert_int_eq(w.report.substeps, 2);
        end[k] = middle(4);
    }
    ck_assert(memcmp(&end[0], &end[1], sizeof *end) == 0);
    ck_assert(memcmp(&end[0], &end[2], sizeof *end) != 0);
}
END_TEST

// Rejects: overlaps that are mended to the last: the next one's mending leaves
// a gap, into which each box falls within one substep.  (16 mJ, and rising.)
START_TEST(stack_that_is_awake_lies_still)
{
    enum { BOXES = 10 };
    world_options o = world_options_default();
    o.resting = 0;
    begin(o);
    real skin = o.skin * box.radius;
    for (int k = 0; k < BOXES; k++)
        add_at(&box, 0, 0.5 + skin + k * (1 + 2 * skin), 0);
    add_floor();
    ready();
    frames(600);
    real lively = 0;
    for (int i = 0; i < w.pool.count; i++) {
        const particle *p = &w.pool.at[i];
        vec3 v = vec3_scale(1 / w.age, vec3_sub(p->position, p->previous));
        lively += vec3_length_squared(v) / (2 * p->inverse_mass);
    }
    ck_assert_msg(lively < 1e-3, "%g J", lively);
    for (int k = 0; k < BOXES; k++) {
        real y = 0.5 + skin + k * (1 + 2 * skin);
        vec3 at = middle(k);
        ck_assert_msg(fabs(at.y - y) < skin
                      && hypot(at.x, at.z) < 2 * skin,
                      "box %d went by (%g, %g, %g)", k, at.x, at.y - y, at.z);
    }
}
END_TEST

// How far a box of 100 kg sinks that stands on one of 1 kg, without memory.
static real pressed(int passes, real content)
{
    shape heavy;
    ck_assert(shape_box(&heavy, vec3_make(1, 1, 1), 100).ok);
    world_options o = world_options_default();
    o.passes = passes;
    o.content = content;
    o.memory = o.resting = 0;
    begin(o);
    add_at(&box, 0, 0.51, 0);
    add_at(&heavy, 0, 1.53, 0);
    add_floor();
    ready();
    frames(60);
    real deep = 1.5 - middle(1).y;
    begin(o);
    shape_free(&heavy);
    return deep;
}

// After one pair of passes a frame it stands on the floor, and has driven the
// light one out sideways.
// Rejects: options that nobody reads; passes that go on when all are content,
// or end before.
START_TEST(passes_carry_the_heavy_on_the_light)
{
    real once = pressed(1, 0), often = pressed(60, 0);
    ck_assert_msg(once > 0.9 && fabs(often) < 0.02, "%g m after one pass, %g m "
                  "after sixty", once, often);
    ck_assert(pressed(60, 1) == pressed(1, 1));
}
END_TEST

// At 100 rad/s a body turns by 24 degrees in a substep: one step of Newton's
// leaves it bent.
// Rejects: an option that nobody reads.
START_TEST(sweeps_straighten_what_turns_violently)
{
    real strain[2] = { 0, 0 };
    for (int k = 0; k < 2; k++) {
        world_options o = without_gravity();
        o.sweeps = k ? 8 : 1;
        begin(o);
        add_thrown(&low, ZERO, ZERO, vec3_make(20, 30, 90));
        ready();
        for (int f = 0; f < 60; f++) {
            frames(1);
            for (int i = 0; i < FOUR_STICKS; i++)
                strain[k] = fmax(strain[k], stick_strain(
                    w.body[0].four->stick[i], particle_of(0, 0)));
        }
    }
    ck_assert_msg(strain[1] <= 2e-6 && strain[0] > 1e-4,
                  "strain %g with one sweep, %g with eight", strain[0],
                  strain[1]);
}
END_TEST

// Rejects: an option that another one needs.
START_TEST(every_option_carries_a_box)
{
    for (int k = 0; k < 8; k++) {
        world_options o = world_options_default();
        o.memory = k & 1;
        o.resting = k >> 1 & 1;
        o.relax.gradient = k >> 2 & 1 ? GRADIENT_NEW : GRADIENT_OLD;
        begin(o);
        add_nailed(&low, 0, -0.25, 0);
        add_at(&box, 0, 0.7, 0);
        ready();
        frames(120);
        ck_assert_msg(fabs(middle(1).y - 0.5) < 0.15, "options %d: at %g", k,
                      middle(1).y);
    }
}
END_TEST

// --- the ledger --------------------------------------------------------------

static real total_energy(void)
{
    return ledger_total(&w).energy;
}

// Do all accounts together say what has changed since `was`?
static void books_balance(ledger_entry was, real error)
{
    ledger_entry now = ledger_total(&w), sum = { 0, ZERO, ZERO };
    for (int k = 0; k < LEDGERS; k++) {
        sum.energy += w.ledger[k].energy;
        sum.momentum = vec3_add(sum.momentum, w.ledger[k].momentum);
        sum.angular = vec3_add(sum.angular, w.ledger[k].angular);
    }
    ck_assert_msg(fabs(now.energy - was.energy - sum.energy) <= error,
                  "energy changed by %.17g, the books say %.17g",
                  now.energy - was.energy, sum.energy);
    ck_assert(vec3_distance(vec3_sub(now.momentum, was.momentum), sum.momentum)
              <= error);
    ck_assert(vec3_distance(vec3_sub(now.angular, was.angular), sum.angular)
              <= error);
}

// Rejects: a stage that nobody books, or that is booked twice; a ledger that
// loses what sleeps.
START_TEST(books_balance_whatever_happens)
{
    for (int k = 0; k < 2; k++) {
        world_options o = world_options_default();
        o.ledger = 1;
        begin(o);
        if (k == 0) {
            for (int b = 0; b < 10; b++)
                add_thrown(b % 2 ? &ball : &box,
                           vec3_make(1.3 * (b % 2), 0.8 + 1.2 * (b / 4),
                                     1.3 * (b / 2 % 2)),
                           vec3_make(b % 3, 0, 1 - b % 2), vec3_make(1, b, 0));
            ck_assert(world_add_plane(&w, vec3_make(1, 0, 0), -0.8).ok);
            ck_assert(world_add_plane(&w, vec3_make(-1, 0, 0), -2.4).ok);
        } else {
            add_nailed(&box, 0, 0.5, 0);
            add_at(&cloth, 0.1, 1.2, 0.2);
            add_at(&rope, 0, 2, 0);
            add_at(&ball, 0.2, 3, 0.1);
        }
        add_floor();
        ready();
        ledger_entry was = ledger_total(&w);
        real most = 0;
        for (int f = 0; f < 180; f++) {
            world_step(&w);
            for (int who = 0; who < LEDGERS; who++)
                most = fmax(most, fabs(w.ledger[who].energy));
        }
        ck_assert(most > 1);
        books_balance(was, BOOKS * fmax(most, fabs(was.energy)));
        // Gravity keeps the energy, whatever else happens.
        ck_assert_msg(fabs(w.ledger[LEDGER_INTEGRATE].energy)
                      <= BOOKS * fmax(most, was.energy), "gravity gave %g J",
                      w.ledger[LEDGER_INTEGRATE].energy);
        ledger_clear(&w);
        for (int who = 0; who < LEDGERS; who++)
            ck_assert(w.ledger[who].energy == 0
                      && vec3_length(w.ledger[who].angular) == 0);
    }
}
END_TEST

// Rejects: a ledger that moves what it counts, or that counts unasked.
START_TEST(ledger_changes_no_bit)
{
    static particle first[MOST];
    for (int k = 0; k < 2; k++) {
        world_options o = world_options_default();
        o.ledger = k;
        begin(o);
        add_nailed(&low, 0, 0.25, 0);
        add_at(&box, 0.1, 1.2, 0);
        add_at(&ball, 0.3, 2.4, 0.1);
        add_at(&cloth, 0, 3.2, 0);
        add_floor();
        ready();
        frames(90);
        if (k == 0) copy_particles(first);
        for (int who = 0; who < LEDGERS - 1; who++)
            ck_assert_int_eq(w.ledger[who].energy != 0,
                             k == 1);
    }
    ck_assert(same_particles(first));
}
END_TEST

// A slab of 4 kg slides at 3 m/s over a floor of friction 0.5.
// Corners of the mesh are pushed by what their sticks take back: contacts and
// sticks together give nothing.
// Rejects: friction that is booked under contacts, with the wrong sign, or by
// its force alone.
START_TEST(friction_takes_what_a_sliding_block_loses)
{
    world_options o = world_options_default();
    o.ledger = 1;
    o.skin = 0;
    begin(o);
    add_thrown(&low, vec3_make(0, 0.25, 0), vec3_make(3, 0, 0), ZERO);
    add_floor();
    ready();
    real from = middle(0).x, had = total_energy();
    frames(60);
    real way = middle(0).x - from, taken = -w.ledger[LEDGER_FRICTION].energy;
    real coulomb = 0.5 * 4 * 9.81 * way;
    // v^2 / 2 mu g, and 18 J.
    ck_assert_msg(fabs(way - 9 / 9.81) < SLIDING, "it went %g m", way);
    ck_assert_msg(fabs(taken - coulomb) < SLIDING * 18,
                  "friction took %g J, over %g m it takes %g J", taken, way,
                  coulomb);
    ck_assert_msg(fabs(had - total_energy() - taken) < SLIDING * 18,
                  "others took %g J", had - total_energy() - taken);
    real pushed = w.ledger[LEDGER_CONTACTS].energy
                + w.ledger[LEDGER_STICKS].energy;
    ck_assert_msg(fabs(pushed) < SLIDING * 18, "contacts gave %g J", pushed);
}
END_TEST

// Rejects: a bounce that gains, or a ledger that finds a loss where a flat body
// rises as high as it fell.
START_TEST(elastic_bounce_costs_nothing)
{
    world_options o = world_options_default();
    o.ledger = 1;
    o.restitution = 1;
    o.friction = 0;
    begin(o);
    add_at(&box, 0, 1.5, 0);
    add_floor();
    ready();
    frames(50);
    // It has bounced, and fallen by 1 m of 1 kg before.
    ck_assert(w.ledger[LEDGER_CONTACTS].momentum.y > 5);
    real pushed = w.ledger[LEDGER_CONTACTS].energy
                + w.ledger[LEDGER_STICKS].energy;
    ck_assert_msg(fabs(pushed) < EXACT, "contacts gave %g J", pushed);
    ck_assert_msg(fabs(w.ledger[LEDGER_FRICTION].energy) <= 1e-12,
                  "friction gave %g J", w.ledger[LEDGER_FRICTION].energy);
}
END_TEST

// Rejects: rest that is booked under the sticks, or that takes more than was
// left; books that go on while everybody sleeps.
START_TEST(rest_takes_what_was_left)
{
    world_options o = world_options_default();
    o.ledger = 1;
    begin(o);
    add_at(&box, 0, 0.7, 0);
    add_floor();
    ready();
    ledger_entry was = ledger_total(&w);
    ck_assert(sleeps(1, 600));
    books_balance(was, BOOKS * fabs(was.energy) * 10);
    real taken = -w.ledger[LEDGER_REST].energy;
    ck_assert_msg(fabs(taken) < 0.01, "rest took %g J", taken);
    ledger_entry then[LEDGERS];
    memcpy(then, w.ledger, sizeof then);
    frames(30);
    ck_assert(memcmp(then, w.ledger, sizeof then) == 0);
}
END_TEST

// --- the frame ---------------------------------------------------------------

// Thirty balls fall into a pit, and one box on a slab without any plane.
// Rejects: lists that are too short for a heap, or for a single face on a face.
START_TEST(nothing_finds_no_room)
{
    begin(world_options_default());
    for (int k = 0; k < 30; k++)
        add_at(k % 2 ? &ball : &box, 1.3 * (k % 3), 1 + 1.1 * (k / 3),
               0.4 * (k % 2));
    add_floor();
    ck_assert(world_add_plane(&w, vec3_make(1, 0, 0), -0.8).ok);
    ck_assert(world_add_plane(&w, vec3_make(-1, 0, 0), -3.4).ok);
    ck_assert(world_add_plane(&w, vec3_make(0, 0, 1), -0.8).ok);
    ck_assert(world_add_plane(&w, vec3_make(0, 0, -1), -1.2).ok);
    ready();
    frames(120);
    ck_assert_int_gt(w.report.pairs, 20);

    for (int k = 0; k < 5; k++) {
        begin(world_options_default());
        add_nailed(&low, 0, -0.25, 0);
        add_at(&box, 0.03 * k, 0.52, 0.02 * k);
        ready();
        frames(10);
        ck_assert_int_ge(w.report.contacts, 4);
        frames(50);
    }
}
END_TEST

// Twenty-seven balls shot through a closed room at 1000 m/s, four times its
// width in a frame: each is near all six planes with all of its corners.
// Rejects: lists with room for the contacts of three planes, where every third
// body is lost.
START_TEST(nobody_leaves_a_closed_room_however_fast)
{
    enum { SIDE = 3, BODIES = SIDE * SIDE * SIDE };
    const real cell = 1.6, room = SIDE * cell;
    begin(world_options_default());
    for (int b = 0; b < BODIES; b++)
        add_thrown(&ball, vec3_make(cell * (b % SIDE + 0.5),
                                    cell * (b / SIDE % SIDE + 0.5),
                                    cell * (b / SIDE / SIDE + 0.5)),
                   vec3_scale(1000, any_unit()), ZERO);
    const vec3 wall[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    for (int k = 0; k < 3; k++) {
        ck_assert(world_add_plane(&w, wall[k], 0).ok);
        ck_assert(world_add_plane(&w, vec3_scale(-1, wall[k]), -room).ok);
    }
    ready();
    for (int f = 0; f < 60; f++) world_step(&w);
    for (int b = 0; b < BODIES; b++) {
        vec3 x = middle(b);
        for (int k = 0; k < 3; k++) {
            real along = vec3_dot(x, wall[k]);
            ck_assert_msg(along > 0 && along < room, "body %d is at %g of %g",
                          b, along, room);
        }
    }
}
END_TEST

// Rejects: memory taken, or given back, while the film runs.
START_TEST(step_allocates_nothing)
{
    for (int k = 0; k < 2; k++) {
        world_options o = world_options_default();
        o.ledger = k;
        begin(o);
        add_nailed(&low, 0, 0.25, 0);
        add_at(&box, 0, 1.2, 0);
        add_at(&ball, 0.3, 2.4, 0.1);
        add_at(&cloth, 0, 3, 0);
        add_at(&rope, 0, 3.3, 0);
        add_floor();
        ready();
        long before = mallocs_made;
        for (int f = 0; f < 90; f++) world_step(&w);
        ck_assert_int_eq(mallocs_made, before);
        ck_assert_int_gt(before, 20);   // the building was counted
    }
}
END_TEST

static real ticks;

static real tick(void)
{
    return ticks++;
}

// Rejects: a stage whose time is booked twice, or on nobody; a clock that is
// asked although there is none.
START_TEST(stages_add_up_to_the_frame)
{
    world_options o = world_options_default();
    o.clock = tick;
    begin(o);
    add_at(&box, 0, 0.6, 0);
    add_at(&cloth, 0, 1.2, 0);
    add_floor();
    ready();
    for (int f = 0; f < 10; f++) {
        ticks = 100;
        frames(1);
        real sum = 0;
        for (int k = 0; k < STAGES; k++) {
            ck_assert(w.report.time[k] > 0);
            sum += w.report.time[k];
        }
        // The first look at the clock starts it.
        ck_assert(sum == ticks - 100 - 1);
    }
    begin(world_options_default());
    add_at(&box, 0, 0.6, 0);
    ready();
    frames(1);
    for (int k = 0; k < STAGES; k++) ck_assert(w.report.time[k] == 0);
}
END_TEST

// Rejects: a lost number that spreads to bodies which never met it; an endless
// loop over it.
START_TEST(lost_number_stays_in_its_body)
{
    begin(world_options_default());
    int bad = add_at(&ball, 0, 5, 0), good = add_at(&ball, 3, 0.6, 0);
    int sheet = add_at(&cloth, -4, 1, 0);
    add_floor();
    ready();
    frames(3);
    particle_of(bad, 3)->position.x = (real)NAN;
    for (int f = 0; f < 60; f++) world_step(&w);
    for (int i = 0; i < ball.particles; i++)
        ck_assert(vec3_is_finite(vertex_of(good, i)));
    for (int i = 0; i < cloth.particles; i++)
        ck_assert(vec3_is_finite(vertex_of(sheet, i)));
    ck_assert(!w.rest.asleep[bad]);
}
END_TEST

// Rejects: anything that remembers more than the world does: an address, a
// static, memory that nobody has written.
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
        ready();
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
    ready();
    frames(3);
    ck_assert(fabs(w.time - 0.05) <= FALL_ROUNDING);
}
END_TEST

// Rejects: a dt^2 for the new step alone, a last move that is carried on whole.
START_TEST(parabola_is_exact_when_the_step_changes)
{
    const vec3 gravity = { 0, -9.81, 0 }, speed = { 3, 4, 0 };
    real dt = 0.01, t = 0;
    particle p[2] = { particle_start(ZERO, speed, gravity, 1, dt),
                      { { 1, 0, 0 }, { 0, 0, 0 }, 0 } };
    unsigned dice = 1;
    for (int k = 0; k < 200; k++) {
        dice = dice * 1664525u + 1013904223u;
        real next = 0.004 + 0.01 * (real)(dice >> 24) / 256;
        verlet_step_changed(p, 2, gravity, dt, next);
        dt = next;
        t += dt;
        vec3 wanted = vec3_add_scaled(vec3_scale(t, speed), t * t / 2, gravity);
        ck_assert(vec3_distance(p[0].position, wanted) <= FALL_ROUNDING);
        ck_assert(p[1].position.x == 1 && p[1].previous.x == 1);
    }
}
END_TEST

// Rejects: two formulas that differ where they meet: a change of nothing would
// change the bits.
START_TEST(unchanged_step_is_the_plain_step)
{
    const vec3 gravity = { 0, -9.81, 0 };
    particle p = particle_start(ZERO, vec3_make(1, 2, 3), gravity, 1, 0.01);
    particle q = p;
    verlet_step(&p, 1, gravity, NULL, 0.01);
    verlet_step_changed(&q, 1, gravity, 0.01, 0.01);
    ck_assert_mem_eq(&p, &q, sizeof p);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        parabola_is_exact_when_the_step_changes,
        unchanged_step_is_the_plain_step,
        free_fall_is_a_parabola,
        bounce_of_four_particles_is_exact_in_any_substeps,
        blow_goes_through_a_cradle_from_either_end,
        bouncing_box_may_stand,
        old_overlap_is_mended_at_the_pace_of_its_options,
        memory_carries_a_stack,
        frame_of_fewer_substeps_has_as_many_passes,
        stack_that_is_awake_lies_still,
        passes_carry_the_heavy_on_the_light,
        sweeps_straighten_what_turns_violently,
        every_option_carries_a_box,
        books_balance_whatever_happens,
        step_allocates_nothing,
        stages_add_up_to_the_frame,
        same_world_takes_the_same_steps,
        empty_world_steps,
        nailed_bodies_keep_every_bit,
        colliding_bodies_keep_their_momentum,
        blow_goes_through_a_row_in_one_frame,
        box_that_falls_flat_bounces_to_the_square_of_its_restitution,
        boxes_that_meet_head_on_part_at_restitution_times_their_speed,
        box_that_falls_flat_stays_flat,
        body_lands_on_a_nailed_one_wherever_it_stands,
        dropped_box_comes_to_rest_and_sleeps_for_nothing,
        nobody_sleeps_where_resting_is_off,
        second_box_thrown_at_a_sleeper_wakes_it,
        calm_neighbour_lets_a_sleeper_sleep,
        bodies_at_rest_keep_their_skins_apart,
        sleepers_on_a_sleeper_wake_with_it,
        deformable_sleepers_wake_too,
        cloth_is_of_the_island_of_what_it_lies_on,
        everything_stays_above_a_plane,
        cloth_that_lands_flat_stays_down,
        ledger_changes_no_bit,
        friction_takes_what_a_sliding_block_loses,
        elastic_bounce_costs_nothing,
        rest_takes_what_was_left,
        nothing_finds_no_room,
        nobody_leaves_a_closed_room_however_fast,
        lost_number_stays_in_its_body,
    };
    Suite *s = suite_create("step");
    TCase *t = tcase_create("step");
    tcase_add_checked_fixture(t, set_up, tear_down);
    tcase_set_timeout(t, 20);
    for (size_t i = 0; i < sizeof tests / sizeof *tests; i++)
        tcase_add_test(t, tests[i]);
    suite_add_tcase(s, t);
    SRunner *runner = srunner_create(s);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
