// check_step.c - does a frame do what it should, and nothing else?
// Book: chapter 9.

#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "scarce.h"
#include "step.h"

// A second is 480 sums of positions near 10; each one's rounding goes on as a
// velocity, so that errors grow as 480^2 / 2 * 1e-15.
#define FALL_ROUNDING 1e-9
// Momentum: every push is a pair of products that cancel but for rounding.
#define MOMENTUM 1e-12

// --- a world -----------------------------------------------------------------

static const vec3 NOTHING = { 0, 0, 0 }, UP = { 0, 1, 0 };

static world w;
static shape box, low, ball, cloth, rope;

static void begin(world_options o)
{
    status done = world_init(&w, o);
    ck_assert_msg(done.ok, "%s", done.why);
}

static void again(world_options o)
{
    world_free(&w);
    begin(o);
}

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

static int add(const shape *s, placement where)
{
    int number;
    status done = world_add(&w, s, where, &number);
    ck_assert_msg(done.ok, "%s", done.why);
    return number;
}

static int add_at(const shape *s, real x, real y, real z)
{
    return add(s, placement_at(vec3_make(x, y, z)));
}

static int add_thrown(const shape *s, vec3 at, vec3 velocity, vec3 spin)
{
    placement p = placement_at(at);
    p.velocity = velocity;
    p.spin = spin;
    return add(s, p);
}

static int add_nailed(const shape *s, real x, real y, real z)
{
    placement p = placement_at(vec3_make(x, y, z));
    p.nailed = 1;
    return add(s, p);
}

static void add_floor(void)
{
    ck_assert(world_add_plane(&w, UP, 0).ok);
}

static void ready(void)
{
    ck_assert(world_begin(&w).ok);
}

static particle *particle_of(int b, int i)
{
    return &w.pool.at[w.body[b].first + i];
}

static vec3 middle(int b)
{
    const shape *s = w.body[b].plan;
    vec3 sum = NOTHING;
    for (int i = 0; i < s->particles; i++)
        sum = vec3_add(sum, particle_of(b, i)->position);
    return vec3_scale(1.0 / s->particles, sum);
}

// Takes body b there, upright, with that velocity.
static void bring(int b, vec3 at, vec3 velocity)
{
    real h = w.options.dt / w.options.substeps;
    for (int i = 0; i < w.body[b].plan->particles; i++) {
        particle *p = particle_of(b, i);
        p->position = vec3_add(at, w.body[b].plan->at[i]);
        p->previous = vec3_add_scaled(p->position, -h, velocity);
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
    o.gravity = NOTHING;
    return o;
}

// The chapter's measures stand to the right of the step: here are their own.
static vec3 momentum(void)
{
    real h = w.options.dt / w.options.substeps;
    vec3 sum = NOTHING;
    for (int i = 0; i < w.pool.count; i++) {
        const particle *p = &w.pool.at[i];
        if (p->inverse_mass == 0) continue;
        sum = vec3_add_scaled(sum, 1 / (h * p->inverse_mass),
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
            collider c[2];
            for (int k = 0; k < 2; k++) {
                for (int i = 0; i < x[k]->plan->particles; i++)
                    at[k][i] = w.pool.at[x[k]->first + i].position;
                c[k] = (collider){ x[k]->plan, x[k]->first, at[k],
                                   x[k]->mass };
            }
            contact touch[PAIR_CONTACTS];
            simplex fresh = { .count = 0 };
            if (collide_rigid(&c[0], &c[1], 0, 0, &fresh, w.hit, touch) > 0)
                deepest = fmax(deepest, -contact_gap(touch, w.pool.at));
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
    const world_options way[] = { world_options_default(),
                                  world_options_paper() };
    const vec3 v = { 1, 4, -2 };
    for (int k = 0; k < 2; k++) {
        again(way[k]);
        const shape *s[] = { &box, &ball, &cloth, &rope };
        vec3 from[4];
        for (int b = 0; b < 4; b++) {
            from[b] = vec3_make(5 * b, 3, 0);
            add_thrown(s[b], from[b], v, NOTHING);
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
                    vec3 now = particle_of(b, i)->position;
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
    add_nailed(&low, 1, 2, 3);
    add_at(&ball, 1, 3, 3);
    add_at(&cloth, 1, 4, 3);
    ready();
    frames(60);
    for (int i = 0; i < 8; i++)
        ck_assert(vec3_distance(particle_of(0, i)->position,
            vec3_add(vec3_make(1, 2, 3), low.at[i])) == 0);
}
END_TEST

// --- blows -------------------------------------------------------------------

// Two bodies without gravity, the second thrown at the first: their momentum.
static void keeps_momentum(const shape *a, const shape *b, world_options o)
{
    again(o);
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
    o.response.restitution = 0.7;
    keeps_momentum(&box, &ball, o);
    o.manifold = o.look_ahead = 0;
    keeps_momentum(&box, &low, o);
    o.order = ORDER_REPEATED;
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
        again(without_gravity());
        for (int b = 0; b < 4; b++)
            add_at(&box, 1.05 * b, 0.01 * b, 0.02 * b);
        add_thrown(&box, vec3_make(-1.05 - speeds[k] / 90, 0, 0),
                   vec3_make(speeds[k], 0, 0), NOTHING);
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
    o.response.restitution = restitution;
    again(o);
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

// From 1.5 m down to 0.5 m and up again: e^2 of that metre comes back.  The speed
// is that of the last substep before the floor, which may be 1 % of it away.
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

// The speed at which two boxes part that met head on at 5 m/s.
static real parting_speed(real restitution, int blows)
{
    world_options o = world_options_default();
    o.gravity = vec3_make(0, 0, 0);
    o.response.restitution = restitution;
    o.blows = blows;
    again(o);
    add_at(&box, -1, 0, 0);
    add_at(&box, 1, 0, 0);
    for (int i = 0; i < w.pool.count; i++)
        w.pool.at[i].previous.x += (i < box.particles ? -2.5 : 2.5)
                                 * o.dt / o.substeps;
    ready();
    frames(60);
    real a = middle(0).x, b = middle(1).x, sum = 0;
    frames(6);
    for (int i = 0; i < w.pool.count; i++)
        sum += w.pool.at[i].position.x - w.pool.at[i].previous.x;
    ck_assert_msg(fabs(sum) < 1e-12, "momentum of %g", sum);
    return (middle(1).x - b - middle(0).x + a) / (6 * o.dt);
}

// 3 % of 5 m/s: as far as corners and sticks agree after their rounds.
static const real PARTING = 0.15;

// Rejects: a bounce that is not shared by mass, so that momentum is lost.
START_TEST(boxes_that_meet_head_on_part_at_restitution_times_their_speed)
{
    for (int k = 0; k <= 2; k++) {
        real e = k / 2.0, parting = parting_speed(e, 1);
        ck_assert_msg(fabs(parting - 5 * e) < PARTING,
                      "restitution %g: %g m/s", e, parting);
    }
}
END_TEST

// Rejects: an option that nobody reads.  (The gain of 3 throws them apart.)
START_TEST(without_blows_a_push_throws_boxes_apart)
{
    real parting = parting_speed(0, 0);
    ck_assert_msg(parting > 0.8 && parting < 1.2, "%g m/s", parting);
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
        again(world_options_default());
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
    vec3 x = middle(b);
    // Flat, on any side: its middle half a side above the floor, its skin and a
    // hundredth of its size besides.
    ck_assert_msg(x.y > 0.5 - 0.01 && x.y < 0.5 + w.body[b].thickness + 0.01,
                  "rests at %g", x.y);
    ck_assert(vec3_length(vec3_make(x.x, 0, x.z)) < 2);
    static particle asleep[MOST];
    copy_particles(asleep);
    frames(120);
    ck_assert_int_eq(w.report.asleep, 1);
    ck_assert_int_eq(w.report.tested, 0);
    ck_assert_int_eq(w.report.relaxed, 0);
    ck_assert(same_particles(asleep));
    for (int i = 0; i < 8; i++)
        ck_assert(vec3_distance(asleep[i].position, asleep[i].previous) == 0);
    for (int k = 0; k < box.sticks; k++)
        ck_assert(stick_strain(box.stick[k], w.pool.at) <= 0.01);
}
END_TEST

// Rejects: sleep although it is not asked for.
START_TEST(nobody_sleeps_where_resting_is_off)
{
    world_options o = world_options_default();
    o.resting = 0;
    again(o);
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
    int first = add_at(&box, 0, 0.51, 0), other = add_at(&box, 0, 500, 0);
    add_floor();
    ready();
    ck_assert(sleeps(1, 400));
    vec3 at = vec3_add(middle(first), vec3_make(1.01, 0, 0));
    bring(other, at, NOTHING);
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
    o.response.gain = 1;
    again(o);
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
        world_options o = world_options_default();
        o.response.gain = 1 + k % 2;
        again(o);
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
        bring(base, vec3_make(50, 0.5, 0), NOTHING);
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
    int r = add_at(&rope, 0, 0.1, 0);
    int c = add_at(&cloth, 0, 14, 0);
    add_nailed(&box, -0.6, -0.5, 0);
    add_nailed(&box, 0.6, -0.5, 0);
    ready();
    int slept = 0;
    for (int f = 0; f < 200; f++) {
        frames(1);
        slept |= w.rest.asleep[r];
    }
    // It lay on two boxes, and slept; then the cloth fell on it, at 16 m/s.
    ck_assert(slept);
    ck_assert(middle(c).y < 5);
    ck_assert(!w.rest.asleep[r] || w.rest.island[r] == w.rest.island[c]);
}
END_TEST

// Rejects: planes that cloth and rope do not meet, or without their thickness.
START_TEST(everything_stays_above_a_plane)
{
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
                real y = particle_of(b, i)->position.y;
                ck_assert_msg(y > -0.05 * s[b]->radius, "body %d is at %g", b,
                              y);
            }
    }
    for (int b = 0; b < 4; b++) {
        ck_assert(middle(b).y < 0.6);
        for (int i = 0; i < s[b]->particles; i++)
            ck_assert(particle_of(b, i)->position.y
                      > 0.9 * w.body[b].thickness - 0.005);
    }
}
END_TEST

// --- the frame ---------------------------------------------------------------

// Thirty balls fall into a pit, and one box on a slab without any plane.
// Rejects: lists that are too short for a heap, or for a single face on a face.
START_TEST(nothing_finds_no_room)
{
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
        again(world_options_default());
        add_nailed(&low, 0, -0.25, 0);
        add_at(&box, 0.03 * k, 0.52, 0.02 * k);
        ready();
        frames(10);
        ck_assert_int_ge(w.report.contacts, 4);
        frames(50);
    }
}
END_TEST

// Rejects: memory taken, or given back, while the film runs.
START_TEST(step_allocates_nothing)
{
    world_options way[] = { world_options_default(), world_options_paper(),
                            world_options_default() };
    way[2].order = ORDER_WORK_LIST;
    for (int k = 0; k < 3; k++) {
        again(way[k]);
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
    again(o);
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
    again(world_options_default());
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
    int bad = add_at(&ball, 0, 5, 0), good = add_at(&ball, 3, 0.6, 0);
    int sheet = add_at(&cloth, -4, 1, 0);
    add_floor();
    ready();
    frames(3);
    particle_of(bad, 4)->position.x = (real)NAN;
    for (int f = 0; f < 60; f++) world_step(&w);
    for (int i = 0; i < ball.particles; i++)
        ck_assert(vec3_is_finite(particle_of(good, i)->position));
    for (int i = 0; i < cloth.particles; i++)
        ck_assert(vec3_is_finite(particle_of(sheet, i)->position));
    ck_assert(!w.rest.asleep[bad]);
}
END_TEST

// Rejects: anything that remembers more than the world does: an address, a
// static, memory that nobody has written.
START_TEST(same_world_takes_the_same_steps)
{
    const world_options way[] = { world_options_default(),
                                  world_options_paper() };
    for (int k = 0; k < 2; k++) {
        static particle first[MOST];
        for (int run = 0; run < 2; run++) {
            again(way[k]);
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

int main(void)
{
    const TTest *const test[] = {
        free_fall_is_a_parabola,
        nailed_bodies_keep_every_bit,
        colliding_bodies_keep_their_momentum,
        blow_goes_through_a_row_in_one_frame,
        box_that_falls_flat_bounces_to_the_square_of_its_restitution,
        boxes_that_meet_head_on_part_at_restitution_times_their_speed,
        without_blows_a_push_throws_boxes_apart,
        body_lands_on_a_nailed_one_wherever_it_stands,
        dropped_box_comes_to_rest_and_sleeps_for_nothing,
        nobody_sleeps_where_resting_is_off,
        second_box_thrown_at_a_sleeper_wakes_it,
        calm_neighbour_lets_a_sleeper_sleep,
        bodies_at_rest_keep_their_skins_apart,
        sleepers_on_a_sleeper_wake_with_it,
        deformable_sleepers_wake_too,
        everything_stays_above_a_plane,
        nothing_finds_no_room,
        step_allocates_nothing,
        stages_add_up_to_the_frame,
        lost_number_stays_in_its_body,
        same_world_takes_the_same_steps,
        empty_world_steps,
    };
    Suite *s = suite_create("step");
    TCase *t = tcase_create("step");
    tcase_add_checked_fixture(t, set_up, tear_down);
    tcase_set_timeout(t, 20);
    for (size_t i = 0; i < sizeof test / sizeof *test; i++)
        tcase_add_test(t, test[i]);
    suite_add_tcase(s, t);
    SRunner *runner = srunner_create(s);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
