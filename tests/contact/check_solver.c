// check_solver.c - do four contacts side by side what each does by itself?
// Book: chapter 13.

#include <check.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

#include "pile.h"
#include "scarce.h"
#include "suite.h"

static pile one, other;
static contact_solver solver;

static void begin_test(void)
{
    seed = 13;
    solver = (contact_solver){ .contacts = 0 };
    ck_assert(solver_grow(&solver, PILE_BODIES));
}

static void end_test(void)
{
    solver_free(&solver);
}

// --- both solvers ------------------------------------------------------------

static void add_gravity(pile *p, vec3 gravity)
{
    for (int b = 0; b < p->frame.bodies; b++) {
        if (p->body[b].basis.inverse_mass == 0) continue;
        p->velocity[b].of[0] += p->frame.h * gravity.x;
        p->velocity[b].of[1] += p->frame.h * gravity.y;
        p->velocity[b].of[2] += p->frame.h * gravity.z;
    }
}

static void set_table(pile *p, contact *table[])
{
    for (int k = 0; k < p->contacts; k++) table[k] = &p->contact[k];
}

static void prepare(pile *p)
{
    contact *table[PILE_CONTACTS];
    set_table(p, table);
    p->frame.body = p->body;
    p->frame.plane = p->plane;
    const contact *const *list = (const contact *const *)table;
    ck_assert(solver_activate(&solver, &p->frame, list, p->reach, p->contacts));
    ck_assert(solver_prepare(&solver, &p->frame, list));
}

// Its lower face on plane 0, with this gap.
static contact *stand_on_plane(pile *p, int b, vec3 sides, real gap)
{
    contact *c = pile_contact(p, b, contact_with_plane(0), p->plane[0].normal);
    for (int k = 0; k < 4; k++)
        pile_point(p, c, vec3_make((k & 1 ? 0.5 : -0.5) * sides.x,
                                   -0.5 * sides.y,
                                   (k & 2 ? 0.5 : -0.5) * sides.z),
                   vec3_make(0, 0, 0), gap);
    return c;
}

// What lies is displaced, and its rows stay where they were made.
static bool lies(const pile *p, int b)
{
    return p->frame.is_elsewhere && p->frame.is_elsewhere[b];
}

static void advance(pile *p)
{
    for (int b = 0; b < p->frame.bodies; b++) {
        solver_body *x = &p->body[b];
        if (x->basis.inverse_mass == 0) continue;
        if (!lies(p, b))
            motion_advance(&x->frame, &x->basis, &p->velocity[b], p->frame.h);
        for (int k = 0; k < MOTIONS && lies(p, b); k++)
            p->moved[b].of[k] += p->frame.h * p->velocity[b].of[k];
    }
}

static void renew(pile *p)
{
    static char fresh[PILE_BODIES];
    for (int b = 0; b < p->frame.bodies; b++) fresh[b] = !lies(p, b);
    solver_frame now = p->frame;
    now.fresh = fresh;
    solver_renew(&solver, &now);
}

static void push(pile *p, vec3 gravity)
{
    add_gravity(p, gravity);
    solver_warm(&solver, &p->frame, p->velocity);
    solver_push(&solver, &p->frame, p->velocity, p->moved);
    advance(p);
}

static void relax(pile *p)
{
    renew(p);
    solver_relax(&solver, &p->frame, p->velocity, p->moved);
}

static void substep(pile *p, vec3 gravity)
{
    push(p, gravity);
    relax(p);
}

static void store(pile *p)
{
    contact *table[PILE_CONTACTS];
    set_table(p, table);
    solver_store(&solver, (tasks){ .run = NULL }, table);
}

static void run(pile *p, vec3 gravity, int substeps)
{
    pile_find(p);
    prepare(p);
    for (int k = 0; k < substeps; k++) substep(p, gravity);
    store(p);
}

static void forget(contact *c)
{
    for (int k = 0; k < c->count; k++) c->impulse[k] = 0;
    c->friction = vec3_make(0, 0, 0);
    c->twist = 0;
}

// The order in which the blocks take the contacts.  Those of two static bodies
// are in none, and forget.
static int order_of_blocks(pile *p, contact *list[])
{
    int n = 0;
    for (int k = 0; k < p->contacts; k++)
        if (solver.active[k].count == 0) forget(&p->contact[k]);
    for (int k = 0; k < solver.blocks; k++)
        for (int l = 0; l < REAL4; l++)
            if (solver.block[k].contact[l] >= 0)
                list[n++] = &p->contact[solver.block[k].contact[l]];
    return n;
}

// Moves all bodies a little.
static void jolt(pile *p)
{
    for (int b = 0; b < p->frame.bodies; b++) {
        solver_body *x = &p->body[b];
        motion d = { { 0 } };
        if (x->basis.inverse_mass == 0) continue;
        for (int k = 0; k < MOTIONS; k++) d.of[k] = 1e-4 * random_real(&seed);
        if (lies(p, b))
            motion_add(&p->moved[b], &d);
        else
            motion_displace(&x->frame, &x->basis, &p->velocity[b], &d);
    }
}

// The same substeps by blocks (p) and one by one (q).  After each push both are
// jolted: a gap that the push has just closed is 0, and rounding would choose
// between a contact that is rigid and one that is soft.
static void run_both(pile *p, pile *q, int substeps)
{
    contact *list[PILE_CONTACTS];
    static real gap[PILE_CONTACTS][CONTACT_POINTS];
    static bool is_first[PILE_CONTACTS], strikes[PILE_CONTACTS];
    p->frame.gravity = q->frame.gravity = GRAVITY;
    pile_find(p);
    prepare(p);
    q->frame.body = q->body;
    q->frame.plane = q->plane;
    plain_solver s = { &q->frame, list, order_of_blocks(q, list), gap,
                       q->velocity, q->moved, q->body, is_first, strikes };
    plain_begin(&s);
    for (int n = 0; n < substeps; n++) {
        push(p, GRAVITY);
        add_gravity(q, GRAVITY);
        plain_warm_start(&s);
        plain_push(&s);
        plain_move(&s);
        const unsigned long long alike = seed;
        jolt(p);
        seed = alike;
        jolt(q);
        plain_measure(&s);
        relax(p);
        plain_relax(&s);
    }
    store(p);
}

// --- the oracle --------------------------------------------------------------

static real off_by, largest;

static void compare(real got, real wanted)
{
    ck_assert(got - got == 0 && wanted - wanted == 0);
    off_by = fmax(off_by, fabs(got - wanted));
    largest = fmax(largest, fabs(wanted));
}

// Returns the largest difference of the impulses, and of the velocities, of two
// runs, each beside the largest, or 1.
static real difference(const pile *p, const pile *q)
{
    real worst;
    off_by = 0;
    largest = 1;
    for (int k = 0; k < p->contacts; k++) {
        const contact *c = &p->contact[k], *d = &q->contact[k];
        for (int j = 0; j < c->count; j++)
            compare(c->impulse[j], d->impulse[j]);
        compare(vec3_distance(c->friction, d->friction), 0);
        compare(c->twist, d->twist);
    }
    worst = off_by / largest;
    off_by = 0;
    largest = 1;
    for (int b = 0; b < p->frame.bodies; b++)
        for (int k = 0; k < MOTIONS; k++) {
            compare(p->velocity[b].of[k], q->velocity[b].of[k]);
            compare(p->moved[b].of[k], q->moved[b].of[k]);
        }
    return fmax(worst, off_by / largest);
}

// Eight substeps, each of two passes: roundings grow where masses differ.  Gaps
// are measured again in each, to 4e-16 m some metres from the origin, and closed
// within a substep of down to 1e-3 s: 4e-13 m/s a pass, and as much again at the end
// of an arm that is six times as long as a body is wide, for both push at one place.
#define SAME 1e-11

// Bodies stand a little off from where their contacts were found.
static void place_aside(const pile *p, rigid_frame placed[PILE_BODIES])
{
    for (int b = 0; b < p->frame.bodies; b++) {
        placed[b] = p->body[b].frame;
        placed[b].center =
            vec3_add_scaled(placed[b].center, 0.1, random_vec3(&seed, 1));
        for (int k = 0; k < FOUR_AXES; k++)
            placed[b].axis[k] = vec3_add_scaled(placed[b].axis[k], 0.1,
                                                random_vec3(&seed, 1));
    }
}

// Where the plain solver alone, from velocities a rounding or two off, ends
// elsewhere, a rounding has decided whether a contact is soft, or bounces.
static bool is_decided_by_rounding(const pile *start, const pile *end,
                                   int substeps)
{
    static pile near, far;
    near = *start;
    for (int b = 0; b < near.frame.bodies; b++)
        for (int k = 0; k < MOTIONS; k++) near.velocity[b].of[k] *= 1 + 1e-14;
    far = near;
    run_both(&near, &far, substeps);
    return difference(&far, end) > SAME;
}

// Rejects: a lane in another lane's place; a row of another body, or of where it
// stood before, or stands now though it lies; a point left out; friction about another centre; a mass without
// the turns of one side; a spring that is not that of its kind of contact.
START_TEST(blocks_find_the_impulses_of_the_plain_solver)
{
    static rigid_frame placed[PILE_BODIES];
    static char some[PILE_BODIES];
    static pile start;
    real worst = 0;
    int left_out = 0;
    for (int n = 0; n < 300; n++) {
        int bodies = 2 + n % 60;
        pile_any(&one, bodies, any_below(3 * bodies), n % 3);
        one.frame.friction = 0.2 * (n % 5);
        one.frame.h = 1.0 / (60 << n % 5);
        one.frame.restitution = n % 4 == 0;
        if (n % 8 == 0) one.frame.gravity = GRAVITY;
        place_aside(&one, placed);
        for (int b = 0; b < bodies; b++) some[b] = any_below(2) == 0;
        if (n % 2) one.frame.rows_at = placed;
        if (n % 2) one.frame.is_elsewhere = some;
        start = other = one;
        run_both(&one, &other, 1 + n % 8);
        real off = one.contacts > 0 ? difference(&one, &other) : 0;
        bool is_chance = off > SAME
                      && is_decided_by_rounding(&start, &other, 1 + n % 8);
        left_out += is_chance;
        if (!is_chance) worst = fmax(worst, off);
    }
    printf("blocks and the plain solver: off by %.2g\n", worst);
    ck_assert_msg(worst <= SAME, "off by %g", worst);
    ck_assert_int_le(left_out, 3);
}
END_TEST

// Rejects: a body that gets two pushes at once, of which one is lost.
START_TEST(a_hundred_contacts_on_one_body_share_it)
{
    pile_clear(&one);
    pile_any_body(&one, 0);
    for (int k = 0; k < 200; k++) {
        pile_any_body(&one, 0);
        pile_any_contact(&one, k % 2 ? 0 : k + 1, k % 2 ? k + 1 : 0, false);
    }
    other = one;
    run_both(&one, &other, 8);
    ck_assert_int_ge(one.contacts, 200);
    real off = difference(&one, &other);
    ck_assert_msg(off <= SAME, "off by %g", off);
}
END_TEST

static void gaps_of(const pile *p, const contact *c, real gap[CONTACT_POINTS])
{
    contact_gaps(c, &p->body[c->a].frame,
                 c->b < 0 ? NULL : &p->body[c->b].frame,
                 c->b < 0 ? p->plane[-1 - c->b].offset : 0, gap);
}

// Points beyond reach are as if they were not there, and forget their impulse.
// Rejects: a contact without a point in reach that keeps what it pushed.
START_TEST(points_out_of_reach_take_no_part)
{
    for (int n = 0; n < 100; n++) {
        pile_any(&one, 20, 40, 0);
        other = one;
        for (int k = 0; k < one.contacts; k++) {
            one.reach[k] = n % 4 ? 0.01 * random_real(&seed) : -1;
            contact *c = &other.contact[k];
            real gap[CONTACT_POINTS];
            int left = 0;
            gaps_of(&one, c, gap);
            for (int j = 0; j < c->count; j++)
                if (gap[j] < one.reach[k]) {
                    c->impulse[left] = c->impulse[j];
                    c->point[left++] = c->point[j];
                }
            c->count = left;
        }
        run_both(&one, &other, 4);
        for (int b = 0; b < one.frame.bodies; b++)
            for (int k = 0; k < MOTIONS; k++)
                ck_assert_msg(fabs(one.velocity[b].of[k]
                                   - other.velocity[b].of[k]) <= 1e-11,
                              "%d: off by %g", n, one.velocity[b].of[k]
                                                  - other.velocity[b].of[k]);
        for (int k = 0; k < one.contacts; k++)
            if (other.contact[k].count == 0) {
                ck_assert(contact_load(&one.contact[k]) == 0);
                ck_assert(vec3_length(one.contact[k].friction) == 0);
                ck_assert(one.contact[k].twist == 0);
            }
    }
}
END_TEST

// Rejects: an impulse of the last frame taken as it is where the substep is of
// another length; friction or a twist that is not.
START_TEST(old_impulses_are_taken_in_part)
{
    pile_any(&one, 20, 40, 0);
    other = one;
    one.frame.warm = 0.25;
    for (int k = 0; k < other.contacts; k++) {
        contact *c = &other.contact[k];
        for (int j = 0; j < c->count; j++) c->impulse[j] *= 0.25;
        c->friction = vec3_scale(0.25, c->friction);
        c->twist *= 0.25;
    }
    run(&one, GRAVITY, 2);
    run(&other, GRAVITY, 2);
    ck_assert(difference(&one, &other) == 0);
}
END_TEST

static void find_again(pile *p)
{
    contact *table[PILE_CONTACTS];
    set_table(p, table);
    for (int k = 0; k < p->contacts; k++) solver.active[k].is_new = k % 3 > 0;
    solver_store_new(&solver, table);
    ck_assert(solver_take_new(&solver, &p->frame, table, p->reach));
}

// Rejects: an impulse that is taken for one of the substep before whenever its
// contact is found again, and grows with every time; a load that does.
START_TEST(contacts_that_are_found_again_keep_their_impulses)
{
    static real age[PILE_BODIES];
    for (int n = 0; n < 10; n++) {
        pile_any(&one, 20, 40, 0);
        for (int b = 0; b < PILE_BODIES; b++) age[b] = one.frame.h / (1 + n);
        one.frame.age = age;
        other = one;
        pile_find(&one);
        prepare(&one);
        for (int times = 0; times < 3; times++) find_again(&one);
        substep(&one, GRAVITY);
        store(&one);
        run(&other, GRAVITY, 1);
        ck_assert(difference(&one, &other) <= SAME);
    }
}
END_TEST

// Some frames of four substeps, of contacts that stay: their gaps change, and
// in the second frame the substep is of another length, and nothing else.
static void run_frames(pile *p, bool anew)
{
    const unsigned long long start = seed;
    pile_find(p);
    for (int frame = 0; frame < 4; frame++) {
        if (anew) pile_find(p);
        p->frame.warm = frame == 1 ? 0.5 : 1;
        prepare(p);
        for (int k = 0; k < 4; k++) {
            push(p, GRAVITY);
            jolt(p);
            relax(p);
        }
        store(p);
        for (int b = 0; b < p->frame.bodies; b++) {
            solver_body *x = &p->body[b];
            if (x->basis.inverse_mass == 0) continue;
            for (int k = 0; k < MOTIONS; k++)
                p->moved[b].of[k] += 0.003 * random_real(&seed);
            motion_displace(&x->frame, &x->basis, &p->velocity[b],
                            &p->moved[b]);
            p->moved[b] = (motion){ { 0 } };
        }
    }
    seed = start;
}

// Rejects: a gap of the frame before; a block that is kept although its points
// are others, or its bodies; an impulse that is lost.
START_TEST(blocks_that_are_kept_give_the_bits_of_new_ones)
{
    static rigid_frame placed[PILE_BODIES];
    static char some[PILE_BODIES];
    for (int n = 0; n < 1000; n++) {
        pile_any(&one, 10, n % 10 ? 1 : 20, 0);
        for (int k = 0; k < one.contacts; k++)
            one.reach[k] = n % 2 ? 0.005 * random_real(&seed) : HUGE_VAL;
        place_aside(&one, placed);
        for (int b = 0; b < one.frame.bodies; b++) some[b] = (b + n) % 3 > 0;
        one.frame.rows_at = placed;
        one.frame.is_elsewhere = some;
        other = one;
        run_frames(&one, false);
        run_frames(&other, true);
        real off = difference(&one, &other);
        ck_assert_msg(off <= SAME, "%d: off by %g", n, off);
    }
}
END_TEST

// Something else has moved the bodies since the last pass: an impact.
// Rejects: gaps of before, by which a contact is rigid that should be soft.
START_TEST(gaps_are_seen_again_where_bodies_have_been_moved)
{
    contact *list[PILE_CONTACTS];
    static real gap[PILE_CONTACTS][CONTACT_POINTS];
    static rigid_frame here[PILE_BODIES];
    static char all[PILE_BODIES];
    static bool is_first[PILE_CONTACTS], strikes[PILE_CONTACTS];
    memset(all, 1, sizeof all);
    for (int n = 0; n < 50; n++) {
        pile_any(&one, 20, 40, 0);
        pile_find(&one);
        for (int b = 0; b < one.frame.bodies; b++)
            here[b] = one.body[b].frame;
        one.frame.rows_at = here;
        one.frame.is_elsewhere = all;
        other = one;
        prepare(&one);
        plain_solver s = { &other.frame, list, order_of_blocks(&other, list),
                           gap, other.velocity, other.moved, other.body, is_first,
                           strikes };
        other.frame.body = other.body;
        other.frame.plane = other.plane;
        plain_begin(&s);
        const unsigned long long alike = seed;
        jolt(&one);
        seed = alike;
        jolt(&other);
        solver_warm(&solver, &one.frame, one.velocity);
        solver_update_gaps(&solver, &one.frame, one.moved);
        solver_push(&solver, &one.frame, one.velocity, one.moved);
        store(&one);
        plain_warm_start(&s);
        plain_push(&s);
        ck_assert(difference(&one, &other) <= SAME);
    }
}
END_TEST

// A box falls towards the ground, faster than its gap allows.  Where impacts
// are to come it is not held; slowly, or where it has pushed, it is.
// Rejects: a bounce that is taken away before it can happen.
START_TEST(what_is_going_to_strike_is_left_to_the_impact)
{
    const struct { real restitution, speed, impulse; bool is_held; } rule[] = {
        { 0, 5, 0, true }, { 0.5, 5, 0, false }, { 0.5, 0.01, 0, true },
        { 0.5, 5, 1e-9, true },
    };
    const vec3 sides = { 1, 1, 1 };
    for (int k = 0; k < COUNT(rule); k++) {
        pile_clear(&one);
        pile_box(&one, vec3_make(0, 0.5, 0), sides, 1);
        contact *c = stand_on_plane(&one, 0, sides, 1e-6);
        for (int j = 0; j < 4; j++) c->impulse[j] = rule[k].impulse;
        one.frame.restitution = rule[k].restitution;
        one.frame.gravity = GRAVITY;
        one.velocity[0].of[1] = -rule[k].speed;
        pile_find(&one);
        prepare(&one);
        solver_relax(&solver, &one.frame, one.velocity, one.moved);
        real speed = -one.velocity[0].of[1];
        ck_assert_msg(rule[k].is_held ? speed < 0.5 * rule[k].speed
                                      : speed == rule[k].speed,
                      "case %d: goes on at %g", k, speed);
    }
}
END_TEST

// --- laws --------------------------------------------------------------------

// Rejects: an impulse that only one side gets; friction at two places.
START_TEST(impulses_keep_momentum_and_angular_momentum)
{
    for (int n = 0; n < 50; n++) {
        pile_clear(&one);
        for (int k = 0; k < 20; k++) {
            pile_any_body(&one, 1);
            if (one.body[k].basis.inverse_mass == 0) {
                one.frame.bodies--;
                k--;
            }
        }
        for (int k = 0; k < 60; k++) {
            int a = any_below(20), b = any_below(20);
            if (a != b) pile_any_contact(&one, a, b, true);
        }
        vec3 sum[2] = { { 0 } }, turning[2] = { { 0 } };
        for (int end = 0; end < 2; end++) {
            for (int b = 0; b < 20; b++) {
                const solver_body *x = &one.body[b];
                const real *u = one.velocity[b].of;
                vec3 p = vec3_scale(1 / x->basis.inverse_mass,
                                    vec3_make(u[0], u[1], u[2]));
                sum[end] = vec3_add(sum[end], p);
                turning[end] = vec3_add(turning[end],
                                        vec3_cross(x->frame.center, p));
                for (int t = 0; t < TURNS; t++) {
                    vec3 turn = x->basis.turn[t];
                    turning[end] = vec3_add_scaled(turning[end],
                        u[MOTION_TURN + t] / vec3_length_squared(turn), turn);
                }
            }
            if (end == 0) run(&one, vec3_make(0, 0, 0), 8);
        }
        ck_assert(vec3_distance(sum[0], sum[1]) <= 1e-11);
        ck_assert(vec3_distance(turning[0], turning[1]) <= 1e-11);
    }
}
END_TEST

static contact_arms arms_of(const pile *p, const contact *c, int k)
{
    return contact_arms_of(c, k, &p->body[c->a].frame,
                           c->b < 0 ? NULL : &p->body[c->b].frame);
}

// The speed at which point k of a contact parts.
static real speed_of(const pile *p, const contact *c, int k)
{
    contact_arms arm = arms_of(p, c, k);
    vec3 v = motion_at(&p->body[c->a].basis, &p->velocity[c->a], arm.a);
    if (c->b >= 0)
        v = vec3_sub(v, motion_at(&p->body[c->b].basis, &p->velocity[c->b],
                                  arm.b));
    return vec3_dot(c->normal, v);
}

// Without friction the passes converge: what pushes does not part, and what
// parts does not push.  Rejects: impulses that pull; a gap that may be passed;
// a pass that does not converge.
START_TEST(relaxed_contacts_either_push_or_part)
{
    for (int n = 0; n < 20; n++) {
        pile_any(&one, 12, 15, 0);
        one.frame.friction = 0;
        pile_find(&one);
        prepare(&one);
        solver_warm(&solver, &one.frame, one.velocity);
        for (int k = 0; k < 20000; k++)
            solver_relax(&solver, &one.frame, one.velocity, one.moved);
        store(&one);
        for (int k = 0; k < one.contacts; k++) {
            const contact *c = &one.contact[k];
            real gap[CONTACT_POINTS];
            if (solver.active[k].count == 0) continue;
            gaps_of(&one, c, gap);
            for (int j = 0; j < c->count; j++) {
                real part = speed_of(&one, c, j)
                          + real_max(gap[j], 0) / one.frame.h;
                ck_assert(c->impulse[j] >= 0);
                ck_assert_msg(part >= -1e-6, "closes at %g", -part);
                if (c->impulse[j] > 1e-6)
                    ck_assert_msg(part <= 1e-6, "pushes and parts at %g", part);
            }
        }
    }
}
END_TEST

// m, between points j and i, each where both push.
static real apart(const contact *c, int j, int i)
{
    const rigid_frame *at = &one.body[c->a].frame;
    const rigid_frame *to = c->b < 0 ? NULL : &one.body[c->b].frame;
    contact_arms x = contact_arms_of(c, j, at, to);
    contact_arms y = contact_arms_of(c, i, at, to);
    return fmax(vec3_distance(x.a, y.a), vec3_distance(x.b, y.b));
}

// Rejects: a limit for each point or each direction, by which a cone becomes a
// box; a twist without one.
START_TEST(friction_stays_in_the_cone)
{
    int at_the_rim = 0;
    for (int n = 0; n < 100; n++) {
        pile_any(&one, 20, 40, 0);
        run(&one, GRAVITY, 4);
        for (int k = 0; k < one.contacts; k++) {
            const contact *c = &one.contact[k];
            real most = one.frame.friction * contact_load(c), lever = 0;
            real across = vec3_length(c->friction);
            for (int j = 0; j < c->count; j++)
                for (int i = 0; i < c->count; i++)
                    lever = fmax(lever, apart(c, j, i));
            ck_assert(across <= most * (1 + 1e-12));
            ck_assert(fabs(c->twist) <= most * lever * (1 + 1e-12));
            at_the_rim += across > 0 && across >= most * (1 - 1e-12);
        }
    }
    ck_assert_int_gt(at_the_rim, 100);
}
END_TEST

// --- one box on the ground ---------------------------------------------------

// A slope of tan = s, in a frame that leans with it.
static vec3 gravity_on_slope(real s)
{
    real per = 9.81 / sqrt(1 + s * s);
    return vec3_make(s * per, -per, 0);
}

static real slid(real slope, real seconds)
{
    const vec3 sides = { 1, 0.2, 1 };
    pile_clear(&one);
    pile_box(&one, vec3_make(0, 0.1, 0), sides, 3);
    stand_on_plane(&one, 0, sides, 0);
    run(&one, gravity_on_slope(slope), (int)(seconds * 480));
    return one.body[0].frame.center.x;
}

// From rest a box on a slope beyond the cone goes g (sin - mu cos) t^2 / 2, and
// one within it stays.  Rejects: friction from the impulses of before; a cone
// that is a hundredth too wide; a box that creeps.
START_TEST(box_slides_if_the_slope_is_beyond_the_cone)
{
    const real mu = 0.5, slope[] = { 0, 0.3, 0.499, 0.501, 0.6, 1 };
    for (int k = 0; k < COUNT(slope); k++) {
        real s = slope[k], way = slid(s, 2);
        real wanted = s > mu ? 9.81 * (s - mu) / sqrt(1 + s * s) * 2 : 0;
        // The springs take some substeps to settle, in which the load is not
        // the weight: a start of some mm/s.
        ck_assert_msg(fabs(way - wanted) <= 0.01 + 0.01 * wanted,
                      "slope %g: slid %g, wanted %g", s, way, wanted);
    }
}
END_TEST

// A box that spins on the spot loses mu N times the mean lever (here that of
// its corners) in angular momentum a second.  Rejects: a twist about the
// world's origin; a lever that is squared, or of one point only.
START_TEST(spinning_box_is_braked_by_its_twist)
{
    const vec3 sides = { 1, 0.2, 1 };
    pile_clear(&one);
    pile_box(&one, vec3_make(5, 0.1, -3), sides, 3);
    stand_on_plane(&one, 0, sides, 0);
    real moment = 3 * 2.0 / 12, lever = sqrt(0.5), spin = 20;
    one.velocity[0].of[MOTION_TURN + 1] = spin * sqrt(moment);
    run(&one, GRAVITY, 240);
    real wanted = spin - 0.5 * 3 * 9.81 * lever / moment * 0.5;
    real got = one.velocity[0].of[MOTION_TURN + 1] / sqrt(moment);
    ck_assert_msg(fabs(got - wanted) <= 0.01 * spin, "%g, wanted %g", got,
                  wanted);
    run(&one, GRAVITY, 480);
    ck_assert(fabs(one.velocity[0].of[MOTION_TURN + 1]) <= 1e-9);
}
END_TEST

// A cube at rest sinks until its springs carry it: by g / omega^2, with omega
// that of a contact with what does not move, 2 pi times twice the hertz.
// Rejects: a spring of another stiffness; one that is measured from elsewhere.
START_TEST(cube_sags_by_what_its_springs_give)
{
    const vec3 sides = { 1, 1, 1 };
    for (int substeps = 2; substeps <= 32; substeps *= 2) {
        pile_clear(&one);
        one.frame.h = 1.0 / (60 * substeps);
        pile_box(&one, vec3_make(0, 0.5, 0), sides, 3);
        contact *c = stand_on_plane(&one, 0, sides, 0);
        run(&one, GRAVITY, 4000);
        real hertz = 2 * fmin(60, 0.125 / one.frame.h);
        real omega = 2 * acos(-1) * hertz, sag = 9.81 / (omega * omega);
        real sags = 0.5 - one.body[0].frame.center.y;
        ck_assert_msg(fabs(sags - sag) <= 1e-6 * sag,
                      "sags by %g, wanted %g", sags, sag);
        real weight = 3 * 9.81 * one.frame.h;
        ck_assert(fabs(contact_load(c) - weight) <= 1e-9 * weight);
        for (int k = 0; k < MOTIONS; k++)
            ck_assert(fabs(one.velocity[0].of[k]) <= 1e-12);
    }
}
END_TEST

// Ten cubes that lie, the highest a hundred times as heavy: every contact carries
// what stands on it.  Rejects: a warm start that is lost between frames, or given
// twice.
START_TEST(tower_carries_its_loads_from_frame_to_frame)
{
    enum { CUBES = 10 };
    static rigid_frame found[CUBES];
    static const char lying[CUBES] = { 1, 1, 1, 1, 1, 1, 1, 1, 1, 1 };
    const vec3 sides = { 1, 1, 1 }, up = { 0, 1, 0 };
    pile_clear(&one);
    for (int k = 0; k < CUBES; k++)
        pile_box(&one, vec3_make(0, k + 0.5, 0), sides,
                 k == CUBES - 1 ? 100 : 1);
    stand_on_plane(&one, 0, sides, 0);
    for (int k = 1; k < CUBES; k++) {
        contact *c = pile_contact(&one, k % 2 ? k : k - 1, k % 2 ? k - 1 : k,
                                  vec3_scale(k % 2 ? 1 : -1, up));
        for (int j = 0; j < 4; j++) {
            vec3 high = { j & 1 ? 0.5 : -0.5, 0.5, j & 2 ? 0.5 : -0.5 };
            vec3 low = { high.x, -0.5, high.z };
            pile_point(&one, c, k % 2 ? low : high, k % 2 ? high : low, 0);
        }
    }
    for (int k = 0; k < CUBES; k++) found[k] = one.body[k].frame;
    one.frame.rows_at = found;
    one.frame.is_elsewhere = lying;
    for (int frame = 0; frame < 600; frame++) {
        run(&one, GRAVITY, 8);
        for (int k = 0; k < CUBES; k++) {
            one.body[k].frame.center.y += one.moved[k].of[1];
            one.moved[k] = (motion){ { 0 } };
        }
    }
    for (int k = 0; k < CUBES; k++) {
        real weight = (CUBES - 1 - k + 100) * 9.81 * one.frame.h;
        real load = contact_load(&one.contact[k]);
        ck_assert_msg(fabs(load - weight) <= 1e-5 * weight,
                      "contact %d: %.9g of %.9g", k, load, weight);
    }
}
END_TEST

// How fast a body falls at most (m/s) that is put on a light one which lies, and
// is so many times as heavy.
static real falls_at(real ratio)
{
    const vec3 sides = { 1, 1, 1 };
    real most = 0;
    pile_clear(&one);
    pile_box(&one, vec3_make(0, 0.5, 0), sides, 1);
    pile_box(&one, vec3_make(0, 1.5, 0), sides, ratio);
    stand_on_plane(&one, 0, sides, 0);
    contact *c = pile_contact(&one, 1, 0, vec3_make(0, 1, 0));
    for (int j = 0; j < 4; j++) {
        vec3 low = { j & 1 ? 0.5 : -0.5, -0.5, j & 2 ? 0.5 : -0.5 };
        pile_point(&one, c, low, vec3_make(low.x, 0.5, low.z), 0);
    }
    pile_find(&one);
    prepare(&one);
    for (int k = 0; k < 200; k++) {
        substep(&one, GRAVITY);
        most = real_max(most, -one.velocity[1].of[1]);
    }
    return most;
}

// In each substep the mass M gets what it has been given, and some m v more, with m
// that of the light one: so M v'' = -m v / h^2, which is a quarter of a swing.  It
// ends after about 1.6 root(M/m) substeps, with root(M/m) g h.  (With two hard passes
// it is root(M/2m); soft ones bear less.)  Rejects: a warm start that is lost, for
// which M falls on and on; a blow that is told from a load by one speed.
START_TEST(mass_on_a_light_one_falls_as_the_root_of_their_ratio)
{
    for (real ratio = 1; ratio < 2000; ratio *= 10) {
        real fastest = falls_at(ratio) / (9.81 * one.frame.h), root = sqrt(ratio);
        ck_assert_msg(fastest > 0.5 * root && fastest < root,
                      "%g times: %g g h", ratio, fastest);
    }
}
END_TEST

// Rejects: a correction that throws bodies apart.
START_TEST(deep_overlap_is_pushed_out_at_most_so_fast)
{
    const vec3 sides = { 1, 1, 1 };
    pile_clear(&one);
    pile_box(&one, vec3_make(0, 0, 0), sides, 3);
    stand_on_plane(&one, 0, sides, -0.5);
    pile_find(&one);
    prepare(&one);
    for (int k = 0; k < 400; k++) {
        real was = one.body[0].frame.center.y;
        substep(&one, GRAVITY);
        ck_assert(one.body[0].frame.center.y - was <= 3.01 * one.frame.h);
        // One pass over the four corners takes most of that speed back.
        ck_assert(one.velocity[0].of[1] <= 1);
    }
    ck_assert(fabs(one.velocity[0].of[1]) <= 1e-9);
    ck_assert(fabs(one.body[0].frame.center.y - 0.5) <= 0.01);
}
END_TEST

// --- what the machine does ---------------------------------------------------

static void shuffled(void *context, void (*work)(void *data, int item),
                     void *data, int items)
{
    int start = any_below(items), stride = 1 + any_below(items);
    for (; stride > 1; stride--) {
        int a = items, b = stride;
        while (b) { int c = a % b; a = b; b = c; }
        if (a == 1) break;
    }
    for (int k = 0; k < items; k++) work(data, (start + k * stride) % items);
    ++*(int *)context;
}

// Rejects: blocks of one colour that share a body; a sum whose order depends on
// who comes first.
START_TEST(any_order_of_the_work_gives_the_same_bits)
{
    int calls = 0;
    for (int n = 0; n < 20; n++) {
        pile_any(&one, PILE_BODIES, PILE_CONTACTS, 1);
        other = one;
        run(&one, GRAVITY, 3);
        other.frame.run = (tasks){ shuffled, &calls };
        run(&other, GRAVITY, 3);
        ck_assert(memcmp(one.velocity, other.velocity, sizeof one.velocity)
                  == 0);
        for (int k = 0; k < one.contacts; k++) other.contact[k].found = 0;
        for (int k = 0; k < one.contacts; k++) one.contact[k].found = 0;
        ck_assert(memcmp(one.contact, other.contact, sizeof one.contact) == 0);
    }
    ck_assert_int_gt(calls, 100);
}
END_TEST

// Rejects: NaN that reaches the other lanes of a block.
START_TEST(lost_body_loses_no_other_that_it_does_not_touch)
{
    for (int n = 0; n < 50; n++) {
        pile_clear(&one);
        for (int k = 0; k < 40; k++) pile_any_body(&one, 0);
        for (int k = 0; k < 40; k += 2)
            pile_any_contact(&one, k, k + 1, false);
        other = one;
        one.velocity[n % 40].of[n % MOTIONS] = (real)NAN;
        run(&one, GRAVITY, 4);
        run(&other, GRAVITY, 4);
        for (int b = 0; b < 40; b++)
            if (b / 2 != n % 40 / 2)
                ck_assert(memcmp(&one.velocity[b], &other.velocity[b],
                                 sizeof one.velocity[b]) == 0);
    }
}
END_TEST

// Rejects: a malloc whose answer is not looked at; a count of contacts that
// have no blocks; memory that is lost.
START_TEST(refused_memory_leaves_no_contact)
{
    enum { ARRAYS = 7 };        // that solver_prepare allocates
    contact *table[PILE_CONTACTS];
    contact_solver s;
    for (int left = 0; left < 1; left++) {
        long before = blocks_held;
        mallocs_left = left;
        s = (contact_solver){ .contacts = 0 };
        bool done = solver_grow(&s, 10);
        mallocs_left = INT_MAX;
        long after = blocks_held;
        ck_assert(!done);
        ck_assert_int_eq(after, before);
        solver_free(&s);
    }
    pile_any(&one, 20, 40, 0);
    set_table(&one, table);
    for (int left = 0; left <= ARRAYS; left++) {
        long before = blocks_held;
        s = (contact_solver){ .contacts = 0 };
        bool begun = solver_grow(&s, 20);
        mallocs_left = left;
        const contact *const *list = (const contact *const *)table;
        bool done = solver_activate(&s, &one.frame, list, one.reach, one.contacts)
                 && solver_prepare(&s, &one.frame, list);
        mallocs_left = INT_MAX;
        bool is_empty = s.contacts == 0 && s.blocks == 0 && s.colors == 0;
        solver_free(&s);
        solver_free(&s);
        long after = blocks_held;
        ck_assert(begun);
        ck_assert(done == (left == ARRAYS) && is_empty != done);
        ck_assert_int_eq(after, before);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        blocks_find_the_impulses_of_the_plain_solver,
        a_hundred_contacts_on_one_body_share_it,
        points_out_of_reach_take_no_part,
        old_impulses_are_taken_in_part,
        contacts_that_are_found_again_keep_their_impulses,
        blocks_that_are_kept_give_the_bits_of_new_ones,
        gaps_are_seen_again_where_bodies_have_been_moved,
        what_is_going_to_strike_is_left_to_the_impact,
        impulses_keep_momentum_and_angular_momentum,
        relaxed_contacts_either_push_or_part,
        friction_stays_in_the_cone,
        box_slides_if_the_slope_is_beyond_the_cone,
        spinning_box_is_braked_by_its_twist,
        cube_sags_by_what_its_springs_give,
        mass_on_a_light_one_falls_as_the_root_of_their_ratio,
        tower_carries_its_loads_from_frame_to_frame,
        deep_overlap_is_pushed_out_at_most_so_fast,
        any_order_of_the_work_gives_the_same_bits,
        lost_body_loses_no_other_that_it_does_not_touch,
        refused_memory_leaves_no_contact,
        NULL
    };
    return suite_run((suite){
        .name = "solver", .tests = tests, .set_up = begin_test,
        .tear_down = end_test, .seconds = 30
    });
}
