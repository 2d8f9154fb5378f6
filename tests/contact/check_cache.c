// check_cache.c - are the contacts that are kept those that would be found?
// Book: chapter 18.

#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cache.h"
#include "forget.h"
#include "convex.h"
#include "expect.h"
#include "random.h"
#include "scarce.h"
#include "suite.h"

// A few products of numbers near 1.
#define ROUNDING 1e-13

static const vec3 UP = { 0, 1, 0 };

// --- bodies ------------------------------------------------------------------

enum { KINDS = 4, BOX = 0, SLAB, BALL, DRUM, BODIES = 24 };

static shape kind[KINDS];
static rigid4 rigid[KINDS];

static int bodies, pairs, planes;
static struct body of[BODIES];
static solver_body now[BODIES];
static rigid_frame middle[BODIES];
static prediction ahead[BODIES];
static char moves[BODIES];
static int number[BODIES];
static int pair[BODIES * (BODIES + 6)][2];
static pair_list list;
static plane wall[6];
static cache_frame frame;
static contact_cache cache;

static void set_up(void)
{
    ck_assert(shape_box(&kind[BOX], vec3_make(1, 1, 1), 1).ok);
    ck_assert(shape_box(&kind[SLAB], vec3_make(4, 0.5, 4), 8).ok);
    ck_assert(shape_icosahedron(&kind[BALL], 0.5, 2).ok);
    // A drum of twelve sides, 1 m high.
    enum { RIM = 12 };
    vec3 at[2 * RIM];
    int face[4 * RIM - 4][3], n = 0;
    for (int k = 0; k < RIM; k++) {
        real a = 2 * acos(-1.0) * k / RIM;
        at[k] = vec3_make(cos(a) / 2, -0.5, -sin(a) / 2);
        at[RIM + k] = vec3_make(cos(a) / 2, 0.5, -sin(a) / 2);
        int m = (k + 1) % RIM;
        const int side[2][3] = { { k, m, RIM + m },
                                 { k, RIM + m, RIM + k } };
        memcpy(face[n], side, sizeof side);
        n += 2;
    }
    for (int k = 1; k + 1 < RIM; k++) {
        const int lid[2][3] = { { 0, k + 1, k },
                                { RIM, RIM + k, RIM + k + 1 } };
        memcpy(face[n], lid, sizeof lid);
        n += 2;
    }
    ck_assert(shape_convex(&kind[DRUM], 2 * RIM, at, n,
                           (const int (*)[3])face, 3).ok);
    for (int k = 0; k < KINDS; k++) ck_assert(rigid4_build(&rigid[k],
                                                           &kind[k]).ok);
    bodies = pairs = 0;
    frame = (cache_frame){ .body = of, .now = now, .asked = middle,
        .ahead = ahead, .moves = moves, .awake = number, .list = &list,
        .plane = wall, .stay = 0.03 };
}

static void tear_down(void)
{
    cache_free(&cache);
    for (int k = 0; k < KINDS; k++) {
        rigid4_free(&rigid[k]);
        shape_free(&kind[k]);
    }
}

// Body b stands at `at`, as at rest.
static void stand(int b, vec3 at)
{
    const rigid4 *r = of[b].rigid;
    particle p[FOUR];
    for (int k = 0; k < FOUR; k++) p[k].position = vec3_add(at, r->at[k]);
    now[b].frame = rigid4_frame(p);
}

// A body that gets no further than `reach` (m).
static int add(int k, vec3 at, real reach)
{
    int b = bodies++;
    ck_assert_int_lt(b, BODIES);
    of[b] = (struct body){ .shape = &kind[k], .rigid = &rigid[k],
                            .inner = shape_inner(&kind[k]) };
    now[b] = (solver_body){ .radius = rigid[k].reach };
    stand(b, at);
    ahead[b] = (prediction){ .turn = reach, .reach = reach };
    moves[b] = 1;
    number[b] = b;
    return b;
}

static void list_pair(int a, int b)
{
    pair[pairs][0] = a;
    pair[pairs++][1] = b;
    list = (pair_list){ .pair = pair, .count = pairs, .capacity = pairs };
    frame.is_new_list = true;
}

static void list_all(void)
{
    pairs = 0;
    for (int a = 0; a < bodies; a++)
        for (int b = a + 1; b < bodies; b++)
            if (moves[a] || moves[b]) list_pair(a, b);
}

static void add_floor(void)
{
    wall[planes++] = (plane){ UP, 0 };
}

// Every body and every plane.
static void list_plane_pairs(void)
{
    list.pair = pair;
    list.walls = 0;
    for (int b = 0; b < bodies; b++)
        for (int k = 0; k < planes; k++) {
            int *wall_pair = pair[list.count + list.walls++];
            wall_pair[0] = b;
            wall_pair[1] = contact_with_plane(k);
        }
}

// For bodies as given (their shapes).  False, leaving *c empty, without memory.
static bool fill(contact_cache *c)
{
    *c = (contact_cache){ .free_entry = -1 };
    bool done = true;
    for (int b = 0; b < bodies && done; b++)
        done = cache_add(c, b, of[b].rigid ? of[b].shape->particles : 0);
    if (!done) cache_free(c);
    return done;
}

static void begin(void)
{
    cache_free(&cache);
    frame.awakes = bodies;
    ck_assert(fill(&cache));
}

static void turn_none(void)
{
    for (int b = 0; b < bodies; b++) middle[b] = now[b].frame;
    list_plane_pairs();
}

// Of bodies that do not turn.
static void update(void)
{
    turn_none();
    cache_update(&cache, &frame);
    frame.is_new_list = false;
}

// The active contact of a and b (or of a plane); one without points if there is
// none.
static contact *contact_of(int a, int b)
{
    static contact none;
    for (int k = 0; k < cache.actives; k++) {
        contact *c = cache.active[k];
        if (c->a == a && c->b == b) return c;
    }
    none = (contact){ .count = 0 };
    return &none;
}

static bool is_active(int a, int b)
{
    return contact_of(a, b)->count > 0;
}

static real least_gap(const contact *c)
{
    real gap[CONTACT_POINTS], least = HUGE_VAL;
    contact_gaps(c, &now[c->a].frame, c->b < 0 ? NULL : &now[c->b].frame,
                 c->b < 0 ? wall[-1 - c->b].offset : 0, gap);
    for (int k = 0; k < c->count; k++) least = fmin(least, gap[k]);
    return least;
}

// Turns body b by a small rotation w about its centre, and moves it.  Returns
// how far a vertex goes at most.
static real nudge(int b, vec3 way, vec3 w)
{
    rigid_frame *f = &now[b].frame;
    real size[FOUR_AXES];
    for (int i = 0; i < FOUR_AXES; i++) {
        size[i] = vec3_length(f->axis[i]);
        f->axis[i] = vec3_add(f->axis[i], vec3_cross(w, f->axis[i]));
    }
    f->axis[1] = vec3_add_scaled(f->axis[1], -vec3_dot(f->axis[0], f->axis[1])
        / vec3_length_squared(f->axis[0]), f->axis[0]);
    for (int i = 0; i < 2; i++)
        f->axis[i] = vec3_scale(size[i] / vec3_length(f->axis[i]), f->axis[i]);
    vec3 z = vec3_cross(f->axis[0], f->axis[1]);
    real sign = vec3_dot(z, f->axis[2]) < 0 ? -1 : 1;
    f->axis[2] = vec3_scale(sign * size[2] / vec3_length(z), z);
    f->center = vec3_add(f->center, way);
    return vec3_length(way) + now[b].radius * vec3_length(w);
}

// --- what is found -----------------------------------------------------------

// Rejects: a normal from A to B; points that do not ride on their bodies; a gap
// that is not that of the surfaces.
START_TEST(box_on_a_slab_touches_with_its_four_corners)
{
    for (int order = 0; order < 2; order++) {
        bodies = pairs = 0;
        int s = -1, b = -1;
        if (order == 0) s = add(SLAB, vec3_make(0, 0, 0), 0);
        b = add(BOX, vec3_make(0.2, 0.76, 0.1), 0.02);
        if (order == 1) s = add(SLAB, vec3_make(0, 0, 0), 0);
        moves[s] = 0;
        list_pair(0, 1);
        begin();
        update();
        ck_assert_int_eq(cache.actives, 1);
        const contact *c = cache.active[0];
        ck_assert_int_eq(c->count, 4);
        near_vec3(c->normal, vec3_make(0, order == 0 ? -1 : 1, 0), ROUNDING);
        real gap[CONTACT_POINTS];
        contact_gaps(c, &now[0].frame, &now[1].frame, 0, gap);
        for (int k = 0; k < 4; k++) {
            const contact_point *p = &c->point[k];
            vec3 local = order == 0 ? p->local_b : p->local_a;
            vec3 at = frame_point(&now[b].frame, local);
            ck_assert(fabs(gap[k] - 0.01) <= ROUNDING);
            ck_assert(fabs(fabs(at.x - 0.2) - 0.5) <= ROUNDING
                      && fabs(fabs(at.z - 0.1) - 0.5) <= ROUNDING);
            // Both impulses act at one point.
            contact_arms arm = contact_arms_of(c, k, &now[0].frame,
                                               &now[1].frame);
            near_vec3(vec3_add(now[0].frame.center, arm.a),
                      vec3_add(now[1].frame.center, arm.b), ROUNDING);
        }
    }
}
END_TEST

// A box comes nearer to another by 5 cm a frame, and may go 11: so of ten frames
// only the first asks, and those in which the gap of half a metre may close.
// Rejects: asking in every frame; a gap that is kept when it may have closed.
START_TEST(pair_is_not_asked_again_before_it_can_close)
{
    int a = add(BOX, vec3_make(0, 0, 0), 0.11);
    int b = add(BOX, vec3_make(1.5, 0, 0), 0);
    moves[b] = 0;
    list_pair(a, b);
    begin();
    long asked = 0;
    for (int k = 0; k < 10; k++) {
        stand(a, vec3_make(0.05 * k, 0, 0));
        if (k > 0) cache_moved(&cache, a, 0.05);
        update();
        asked += cache.queries;
        ck_assert_int_eq(is_active(a, b), k >= 8);
    }
    ck_assert(fabs(least_gap(contact_of(a, b)) - 0.05) <= ROUNDING);
    ck_assert_int_le(asked, 4);
}
END_TEST

// 0.2 m over the floor: they touch in this frame if they may go as far.
// Rejects: vertices that cannot come down in this frame, kept; those that can,
// left out; a plane's offset that is not looked at.
START_TEST(corners_that_may_reach_a_plane_are_contacts)
{
    int near = add(BOX, vec3_make(0, 0.7, 0), 0.21);
    int far = add(BOX, vec3_make(5, 0.7, 0), 0.19);
    int under = add(BOX, vec3_make(9, -4, 0), 0);
    add_floor();
    wall[planes++] = (plane){ { 0, -1, 0 }, -1.3 };
    frame.stay = 0;
    begin();
    update();
    const contact *c = contact_of(near, contact_with_plane(0));
    ck_assert_int_eq(c->count, 4);
    near_vec3(c->normal, UP, 0);
    ck_assert(fabs(least_gap(c) - 0.2) <= ROUNDING);
    // It is 0.1 m from the ceiling, which it may reach as well.
    ck_assert(fabs(least_gap(contact_of(near, contact_with_plane(1))) - 0.1)
              <= ROUNDING);
    ck_assert(!is_active(far, contact_with_plane(0)));
    ck_assert(is_active(far, contact_with_plane(1)));
    ck_assert(fabs(least_gap(contact_of(under, contact_with_plane(0))) + 4.5)
              <= ROUNDING);
}
END_TEST

// Rejects: the first four vertices of a rim, which lie side by side: a drum
// would fall over them.
START_TEST(drum_stands_on_points_all_around_its_rim)
{
    int b = add(DRUM, vec3_make(0, 0.5, 0), 0.01);
    add_floor();
    begin();
    update();
    const contact *c = contact_of(b, contact_with_plane(0));
    ck_assert_int_eq(c->count, 4);
    for (int k = 0; k < 12; k++) {
        real a = 2 * acos(-1.0) * k / 12, most = -1;
        vec3 out = { cos(a), 0, sin(a) };
        for (int i = 0; i < 4; i++)
            most = fmax(most, vec3_dot(out, frame_point(&now[b].frame,
                                                        c->point[i].local_a)));
        ck_assert_msg(most > 0.3, "%g m that way, of 0.5", most);
    }
}
END_TEST

// A bullet of 300 m/s, 5 m a frame, from 2 m above a slab: it has one contact
// there where it will touch, and its middle keeps in front of the slab as well.
// Rejects: a way of one body instead of the difference.
START_TEST(bullet_touches_as_it_will_first)
{
    for (int at_small = 0; at_small < 2; at_small++) {
        bodies = pairs = 0;
        int small = add(BALL, vec3_make(0.2, 2, 0.1), 0);
        int slab = add(SLAB, vec3_make(0, 0, 0), 0);
        moves[at_small ? small : slab] = 0;
        int fast = at_small ? slab : small;
        ahead[fast].delta = vec3_make(0, at_small ? 5 : -5, 0);
        ahead[fast].turn = 0.01;
        ahead[fast].reach = 5.01;
        list_pair(small, slab);
        begin();
        update();
        const contact *c = contact_of(small, slab);
        // An icosahedron's edge lies along the slab: two touches.
        ck_assert_int_eq(c->count, 2);
        near_vec3(c->normal, UP, 1e-9);
        real gap[CONTACT_POINTS];
        contact_gaps(c, &now[small].frame, &now[slab].frame, 0, gap);
        // An icosahedron stands on an edge.
        ck_assert(gap[0] > 1.75 - 0.5 && gap[0] < 1.75 - 0.4);
        ck_assert(c->round_a == 0 && c->round_b == 0);
    }
}
END_TEST

// Rejects: a bullet that is stopped by what it passes; contacts of a pass that
// are kept for the next frame; a pair that cannot be asked again, if it is struck.
START_TEST(bullet_that_passes_by_touches_nothing)
{
    int b = add(BALL, vec3_make(2.6, 2, 0), 0);
    int slab = add(SLAB, vec3_make(0, 0, 0), 0);
    moves[slab] = 0;
    ahead[b] = (prediction){ .delta = { 0, -5, 0 }, .turn = 0.01, .reach = 5.01 };
    list_pair(b, slab);
    begin();
    for (int f = 0; f < 2; f++) {
        update();
        ck_assert_int_eq(cache.queries, 1);
        ck_assert_int_eq(cache.actives, 1);
        ck_assert(cache.of[0]->passes && cache.active[0]->count == 0);
        ck_assert_int_eq(cache.fast, 0);
    }
}
END_TEST

// A bullet that is through between two substeps is asked again from the far side:
// its contact stays as it was, and only for this frame.
// Rejects: a contact that lets go of what is through, or that pushes it out on
// the far side; one that outlives its frame.
START_TEST(bullet_that_is_through_comes_back_within_its_frame)
{
    int ball = add(BALL, vec3_make(0.2, 2, 0.1), 0);
    int slab = add(SLAB, vec3_make(0, 0, 0), 0);
    moves[slab] = 0;
    ahead[ball] = (prediction){ .delta = { 0, -5, 0 }, .turn = 0.01,
                                .reach = 5.01 };
    list_pair(ball, slab);
    begin();
    update();
    const contact was = *contact_of(ball, slab);
    ck_assert(was.is_ahead && was.count > 0);
    // Inside of it, nearer to the far side, and past it.
    const real height[2] = { -0.4, -3 };
    ahead[ball] = (prediction){ .turn = 0.01, .reach = 0.01 };
    for (int k = 0; k < 2; k++) {
        stand(ball, vec3_make(0.2, height[k], 0.1));
        turn_none();
        cache_again(&cache, &frame, 0);
        const contact *c = contact_of(ball, slab);
        ck_assert_int_eq(c->count, was.count);
        ck_assert(vec3_dot(c->normal, was.normal) > 0);
    }
    update();
    ck_assert_int_eq(cache.actives, 0);
}
END_TEST

// --- what is kept ------------------------------------------------------------

// A box and a slab of radius R and S stay where they are while none goes
// further than 0.03 of its radius.
// Rejects: a query in every frame; one that is never asked again; a measure
// that is another body's, or that is not of the radius.
START_TEST(bodies_that_stay_are_not_asked_again)
{
    int slab = add(SLAB, vec3_make(0, 0, 0), 0.01);
    int box = add(BOX, vec3_make(0, 0.76, 0), 0.01);
    moves[slab] = 0;
    add_floor();
    wall[0].offset = -0.25;
    list_pair(slab, box);
    begin();
    update();
    // The slab does not move, and a plane asks about no such body.
    ck_assert_int_eq(cache.queries, 1);
    real room = 0.03 * now[box].radius;
    real both = room + 0.03 * now[slab].radius;
    stand(box, vec3_make(0.99 * room, 0.76, 0));
    update();
    ck_assert_int_eq(cache.queries, 0);
    ck_assert_int_eq(cache.actives, 1);
    stand(box, vec3_make(1.01 * room, 0.76, 0));
    update();
    ck_assert_int_eq(cache.queries, 1);
    update();
    ck_assert_int_eq(cache.queries, 0);
    nudge(box, vec3_make(0, 0, 0), vec3_make(0, 0.1, 0));
    update();
    ck_assert_int_eq(cache.queries, 1);
    // It may go as far in this frame as it was asked for, and then further.
    ahead[box].turn = ahead[box].reach = 0.01 + 0.99 * both;
    update();
    ck_assert_int_eq(cache.queries, 0);
    ahead[box].turn = ahead[box].reach = 0.01 + 1.01 * both;
    update();
    ck_assert_int_eq(cache.queries, 1);
    update();
    ck_assert_int_eq(cache.queries, 0);
    // Nothing is kept of what is forgotten.
    cache_clear(&cache);
    update();
    ck_assert_int_eq(cache.queries, 1);
    frame.stay = 0;
    stand(box, vec3_make(1.01 * room, 0.76 + 1e-9, 0));
    update();
    ck_assert_int_eq(cache.queries, 1);
}
END_TEST

// The corners of an icosahedron are carried by a fifth of what it may move.  If
// three of them carry it, another may be deeper by then; if nothing does, there
// is none to come deeper; and a box lies on four.
// Rejects: a measure of all that a body does that does not ask what it lies on.
START_TEST(body_that_turns_on_few_corners_is_asked_again)
{
    const int kinds[] = { BALL, BOX };
    for (int k = 0; k < 2; k++)
        for (int is_pressed = 0; is_pressed < 2; is_pressed++) {
            bodies = planes = 0;
            add_floor();
            real low = 0;
            for (int i = 0; i < kind[kinds[k]].particles; i++)
                low = fmin(low, kind[kinds[k]].at[i].y);
            int b = add(kinds[k], vec3_make(0, -low, 0), 0.01);
            begin();
            frame.is_new_list = true;
            update();
            contact_of(b, contact_with_plane(0))->impulse[0] = is_pressed;
            update();
            ck_assert_int_eq(cache.queries, 0);
            int few = contact_of(b, contact_with_plane(0))->count < 4;
            ck_assert_int_eq(few, kinds[k] == BALL);
            nudge(b, vec3_make(0, 0, 0), vec3_make(0, 0.001, 0));
            update();
            ck_assert_int_eq(cache.queries, 0);
            nudge(b, vec3_make(0, 0, 0), vec3_make(0, 0.006, 0));
            update();
            ck_assert_int_eq(cache.queries, few && is_pressed);
        }
}
END_TEST

// Rejects: a place in the table of contacts for each pair that was ever asked; places
// that go to another pair while their contact has points.
START_TEST(pair_without_points_keeps_no_entry)
{
    int slab = add(SLAB, vec3_make(0, 0, 0), 0);
    int on = add(BOX, vec3_make(-1, 0.75, 0), 0.01);
    moves[slab] = 0;
    list_pair(slab, on);
    for (int k = 1; k < 4; k++)
        list_pair(slab, add(BOX, vec3_make(k, 1.2, 0), 0.01));
    begin();
    for (int f = 0; f < 3; f++) {
        update();
        ck_assert_int_eq(cache.actives, 1);
        ck_assert_int_eq(contact_of(slab, on)->count, 4);
        for (int k = 0, kept = 0; k < cache.pairs.count; k++) {
            kept += cache.pairs.pair[k].entry >= 0;
            ck_assert_int_le(kept, 1);
        }
    }
}
END_TEST

// Rejects: an entry that is lost with its pair, so that the table grows for
// ever; impulses that a new pair takes over from an old one.
START_TEST(pair_that_is_listed_no_more_gives_its_entry_back)
{
    int slab = add(SLAB, vec3_make(0, 0, 0), 0);
    int a = add(BOX, vec3_make(-1, 0.75, 0), 0.01);
    int b = add(BOX, vec3_make(1, 0.75, 0), 0.01);
    moves[slab] = 0;
    list_pair(slab, a);
    begin();
    for (int f = 0; f < 20; f++) {
        pairs = 0;
        list_pair(slab, f % 2 ? b : a);
        update();
        ck_assert_int_eq(cache.actives, 1);
        contact *c = contact_of(slab, f % 2 ? b : a);
        ck_assert(contact_load(c) == 0);
        c->impulse[0] = 1;
    }
    ck_assert_int_eq(cache.entries, 1);
    // While it is listed, a pair keeps its own.
    list_pair(slab, b);
    pair[0][1] = a;
    update();
    ck_assert_int_eq(cache.entries, 2);
    contact_of(slab, a)->impulse[0] = 2;
    frame.is_new_list = true;
    update();
    ck_assert(contact_load(contact_of(slab, a)) == 2);
}
END_TEST

// A box of which one side is lifted off keeps two points of four.
// Rejects: impulses that are lost with their points, or taken twice.
START_TEST(load_is_handed_over_when_a_pair_is_asked_again)
{
    int box = add(BOX, vec3_make(0.1, 0.755, 0.2), 0.02);
    int slab = add(SLAB, vec3_make(0, 0, 0), 0);
    moves[slab] = 0;
    frame.stay = 0;
    add_floor();
    wall[0].offset = 0.25;
    list_pair(box, slab);
    begin();
    update();
    for (int f = 1; f < 4; f++) {
        for (int k = 0; k < cache.actives; k++)
            for (int i = 0; i < cache.active[k]->count; i++)
                cache.active[k]->impulse[i] = i + 1;
        real had = contact_load(cache.active[0]);
        nudge(box, vec3_make(0, 0.03, 0), vec3_make(0, 0, 0.1));
        update();
        ck_assert_int_eq(cache.queries, 2);
        ck_assert_int_eq(cache.actives, 2);
        for (int k = 0; k < 2; k++) {
            ck_assert_int_eq(cache.active[k]->count, 2);
            ck_assert(fabs(contact_load(cache.active[k]) - had)
                      <= 10 * ROUNDING);
        }
    }
}
END_TEST

// A box 30 mm over the floor, 1 cm of which it may go in a frame, comes down by
// 4 mm a frame: in the fifth frame it may touch.
// Rejects: a contact that is left out for ever, for nobody says how far its
// body has gone; one that is kept although it cannot close.
START_TEST(contact_is_left_out_until_its_gap_may_close)
{
    int box = add(BOX, vec3_make(0, 0.53, 0), 0.01);
    add_floor();
    begin();
    for (int f = 0; f <= 6; f++) {
        update();
        ck_assert_int_eq(cache.queries, f == 0);
        // When it has just been asked, it is not known how near it is.
        ck_assert_int_eq(cache.actives, f == 0 || f >= 5);
        if (cache.actives > 0) {
            real gap = least_gap(cache.active[0]);
            ck_assert(fabs(gap - (0.03 - 0.004 * f)) <= ROUNDING);
            cache.of[0]->near += gap;
        }
        cache_moved(&cache, box, nudge(box, vec3_make(0, -0.004, 0),
                                       vec3_make(0, 0, 0)));
    }
}
END_TEST

// Where body b would stand, turned by w (rad) about its centre.
static rigid_frame turned(int b, const rigid_frame *from, vec3 w)
{
    motion m = { { 0, 0, 0, w.x, w.y, w.z } };
    motion_basis *basis = &now[b].basis;
    for (int i = 0; i < TURNS; i++)
        basis->turn[i] = vec3_make(i == 0, i == 1, i == 2);
    return motion_frame(from, basis, &m);
}

// A drum of twelve sides rolls on the floor by half a radian: corners that
// stood a tenth of a radian from the lowest point go up, and the lowest are in
// the end those that were .62 rad from it, further than two other pairs.
// Rejects: corners that are near when the frame begins.
START_TEST(body_that_turns_is_asked_as_it_stands_in_the_middle)
{
    const real right = acos(-1.0) / 2, side = right / 3;
    vec3 start = vec3_make(0, 0, -0.1), turn = vec3_make(0, 0, 0.5);
    add_floor();
    int drum = add(DRUM, vec3_make(0, 0.5, 0), 0.3);
    rigid_frame *f = &now[drum].frame, end;
    ahead[drum].angle = 0.5;
    *f = turned(drum, f, vec3_make(right, 0, 0));
    *f = turned(drum, f, start);
    middle[drum] = turned(drum, f, vec3_scale(0.5, turn));
    end = turned(drum, f, turn);
    begin();
    list_plane_pairs();
    cache_update(&cache, &frame);
    const contact *c = contact_of(drum, contact_with_plane(0));
    real gap[CONTACT_POINTS], least = HUGE_VAL;
    contact_gaps(c, &end, NULL, 0, gap);
    for (int k = 0; k < c->count; k++) least = fmin(least, gap[k]);
    // (motion_frame turns to a^5 / 240.)
    real lowest = 0.5 - 0.5 * cos(start.z + turn.z - side);
    ck_assert(fabs(least - lowest) <= 1e-4);
}
END_TEST

// --- the oracle: nothing is kept ---------------------------------------------

static unsigned long long seed;

// A heap: shapes by turns, on a grid of 1 m.
static void add_heap(void)
{
    for (int k = 0; k < 18; k++) {
        const int by_turns[3] = { BOX, BALL, DRUM };
        add(by_turns[k % 3], vec3_make(k % 3, 0.505 + k / 9, k / 3 % 3), 0.02);
        ahead[k].angle = 0.005;
    }
    add_floor();
    list_all();
}

// A frame in which every body goes at most as far as its reach.
static void shake(real size)
{
    for (int b = 0; b < bodies; b++) {
        vec3 way = random_vec3(&seed, size / 4);
        vec3 w = random_vec3(&seed, size / 4);
        cache_moved(&cache, b, nudge(b, way, w));
    }
}

// m, an eighth of what a body may have gone since it was asked: so much can the
// gap between two points that were nearest be wider than that of two others.
static const real KEPT = 3e-3;
// m, what two bodies may have gone since they were asked: two edges that pass
// each other were kept apart along an axis that parts them no more.
static const real GHOST = 2 * 0.03 * 0.88;

// Contacts kept from frame to frame against those of an empty cache.
// Rejects: contacts that are kept too long; those that are left out of a frame
// in which they may close; points whose bodies have gone on without them.
START_TEST(kept_contacts_are_those_that_would_be_found)
{
    enum { FRAMES = 150 };
    static contact_cache fresh;
    long asked = 0, all = 0;
    int met = 0, missing = 0, overlaps = 0;
    real worst = 0, ghost = 0;
    seed = 3;
    add_heap();
    begin();
    ck_assert(fill(&fresh));
    for (int f = 0; f < FRAMES; f++) {
        turn_none();
        cache_update(&cache, &frame);
        cache_frame plain = frame;
        plain.is_new_list = f == 0;
        cache_clear(&fresh);
        cache_update(&fresh, &plain);
        frame.is_new_list = false;
        asked += cache.queries;
        all += fresh.queries;
        for (int k = 0; k < fresh.actives; k++) {
            const contact *c = fresh.active[k], *kept;
            real gap = least_gap(c);
            if (gap > fresh.reach[k]) continue;
            met++;
            kept = contact_of(c->a, c->b);
            missing += kept->count == 0;
            if (kept->count == 0) continue;
            overlaps += gap < 0;
            real more = least_gap(kept) - gap;
            worst = fmax(worst, more);
            if (gap > 0) ghost = fmax(ghost, -least_gap(kept));
        }
        for (int k = 0; k < cache.actives; k++)
            cache.of[k]->near += least_gap(cache.active[k]);
        shake(0.004);
    }
    cache_free(&fresh);
    ck_assert_int_gt(met, 20 * FRAMES);
    ck_assert_msg(missing == 0, "%d of %d are missing", missing, met);
    ck_assert_int_gt(overlaps, FRAMES);
    ck_assert_msg(worst <= KEPT, "a gap is %g m too wide", worst);
    ck_assert_msg(ghost <= GHOST, "bodies that are apart overlap by %g m",
                  ghost);
    ck_assert_msg(asked < all / 3, "%ld queries, %ld without", asked, all);
}
END_TEST

// --- tasks, lost numbers, memory ---------------------------------------------

static void backwards(void *context, void (*work)(void *, int), void *data,
                      int items)
{
    int *count = context;
    *count += items;
    for (int k = items - 1; k >= 0; k--) work(data, k);
}

// Rejects: an item that reads what another one writes.
START_TEST(any_order_of_the_work_gives_the_same_bits)
{
    static contact first[BODIES * BODIES];
    int n = 0, items = 0;
    for (int run = 0; run < 2; run++) {
        seed = 5;
        bodies = pairs = planes = 0;
        if (run) frame.run = (tasks){ backwards, &items };
        add_heap();
        begin();
        for (int f = 0; f < 10; f++) {
            update();
            shake(0.01);
        }
        if (run == 0) n = cache.actives;
        ck_assert_int_eq(cache.actives, n);
        for (int k = 0; k < n; k++) {
            if (run == 0) first[k] = *cache.active[k];
            else ck_assert_mem_eq(&first[k], cache.active[k], sizeof *first);
        }
    }
    ck_assert_int_gt(n, 20);
    ck_assert_int_gt(items, 20);
}
END_TEST

// Rejects: comparisons that a NaN passes.
START_TEST(lost_body_touches_nothing)
{
    const real bad[] = { (real)NAN, HUGE_VAL };
    for (int k = 0; k < 6; k++) {
        bodies = pairs = planes = 0;
        seed = 5;
        add_heap();
        begin();
        update();
        int all = cache.actives, lost = 9, others = 0;
        for (int i = 0; i < all; i++)
            others += cache.active[i]->a != lost && cache.active[i]->b != lost;
        ck_assert_int_lt(others, all);
        real x = bad[k % 2];
        if (k / 2 == 0) now[lost].frame.center.y = x;
        if (k / 2 == 1) now[lost].frame.axis[1].z = x;
        if (k / 2 == 2) ahead[lost].reach = ahead[lost].turn = (real)NAN;
        update();
        int left = 0;
        for (int i = 0; i < cache.actives; i++) {
            const contact *c = cache.active[i];
            if (c->a != lost && c->b != lost) left++;
            else ck_assert(k / 2 == 1 || !(least_gap(c) < HUGE_VAL));
        }
        ck_assert_int_eq(left, others);
    }
}
END_TEST

// Rejects: contacts that are lost without a word, or for good; a crash.
START_TEST(contacts_without_memory_are_counted_until_there_is_some)
{
    bool enough = false;
    int n = 0, all = 0;
    for (; !enough; n++) {
        bodies = pairs = planes = 0;
        add_heap();
        begin();
        mallocs_left = n;
        update();
        enough = mallocs_left > 0;
        mallocs_left = INT_MAX;
        int active = cache.actives, lost = cache.lost;
        update();
        if (all == 0) all = cache.actives;
        ck_assert_int_eq(cache.actives, all);
        ck_assert_int_eq(cache.lost, 0);
        ck_assert_msg((active == all) == (lost == 0), "%d of %d contacts, and "
                      "%d are said to be lost", active, all, lost);
    }
    ck_assert_int_gt(all, 20);
    ck_assert_int_gt(n, 5);
}
END_TEST

// Rejects: an answer that is not looked at; a half-made cache.
START_TEST(refused_memory_leaves_nothing)
{
    bool ok = false;
    int n = 0;
    add_heap();
    for (; !ok; n++) {
        long before = blocks_held;
        mallocs_left = n;
        ok = fill(&cache);
        mallocs_left = INT_MAX;
        long held = blocks_held;
        if (!ok) ck_assert_int_eq(held, before);
    }
    ck_assert_int_gt(n, 2);
    cache_free(&cache);
    cache_free(&cache);
    bodies = pairs = planes = 0;
    list = (pair_list){ .pair = pair };
    begin();
    update();
    ck_assert_int_eq(cache.actives, 0);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        box_on_a_slab_touches_with_its_four_corners,
        pair_is_not_asked_again_before_it_can_close,
        corners_that_may_reach_a_plane_are_contacts,
        drum_stands_on_points_all_around_its_rim,
        bullet_touches_as_it_will_first,
        bullet_that_passes_by_touches_nothing,
        bullet_that_is_through_comes_back_within_its_frame,
        bodies_that_stay_are_not_asked_again,
        body_that_turns_on_few_corners_is_asked_again,
        pair_without_points_keeps_no_entry,
        pair_that_is_listed_no_more_gives_its_entry_back,
        load_is_handed_over_when_a_pair_is_asked_again,
        contact_is_left_out_until_its_gap_may_close,
        body_that_turns_is_asked_as_it_stands_in_the_middle,
        kept_contacts_are_those_that_would_be_found,
        any_order_of_the_work_gives_the_same_bits,
        lost_body_touches_nothing,
        contacts_without_memory_are_counted_until_there_is_some,
        refused_memory_leaves_nothing,
        NULL
    };
    return suite_run((suite){
        .name = "cache", .tests = tests, .set_up = set_up,
        .tear_down = tear_down
    });
}
