// check_soft_world.c - what do cloth and rope touch, and is any of it missed?
// Book: chapter 18.

#include <check.h>
#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "crossings.h"
#include "expect.h"
#include "handle.h"
#include "measure.h"
#include "soft_step.h"
#include "step.h"
#include "stage.h"
#include "suite.h"

// Two particles that are parted stand where a square root and a division put
// them.
#define ROUNDING 1e-14
// A pair so near the edge of what is listed that rounding decides.
#define EDGE 1e-9

// s, the substep that these tests speak of.
#define H (1 / 480.0)

enum { SIDE = 10, MOST = 700 };

static shape cloth, rope, link_, box;

static void set_up(void)
{
    ck_assert(shape_cloth(&cloth, SIDE, SIDE, 1, 1, 1, 0.2).ok);
    ck_assert(shape_rope(&rope, 12, 1.2, 0.3).ok);
    ck_assert(shape_rope(&link_, 1, 1, 2).ok);
    ck_assert(shape_box(&box, vec3_make(0.5, 0.5, 0.5), 8).ok);
    begin(world_options_default());
}

static void tear_down(void)
{
    world_free(&w);
    shape_free(&cloth);
    shape_free(&rope);
    shape_free(&link_);
    shape_free(&box);
}

static void put(particle *p, vec3 x)
{
    p->position = p->previous = x;
}

// What the world's step does of a substep, one by one.
static void renew(real h)
{
    soft_frame f = soft_frame_of(&w, h);
    f.age = h;
    probe_refresh(&w, &f);
}

// As if a frame began with it, in which nothing is fast.
static void refresh(real h)
{
    soft_frame f = soft_frame_of(&w, h);
    int made = probe_lists(&w)->made;
    probe_begin_lists(&w, &f);
    probe_lists(&w)->made = made;
    renew(h);
}

static void separate(real h)
{
    soft_frame f = soft_frame_of(&w, h);
    f.age = h;
    probe_separate(&w, &f);
}

static void hold(real h)
{
    soft_frame f = soft_frame_of(&w, h);
    probe_hold(&w, &f);
}

static int stretched(void)
{
    soft_frame f = soft_frame_of(&w, w.age);
    return probe_unconverged(&w, &f);
}

// --- the slow oracle ---------------------------------------------------------

static char listed[MOST][MOST];     // pair of particles, either order
static char pointed[MOST][MOST];    // particle and rigid body

static void read_lists(void)
{
    ck_assert_int_le(w.pool.count, MOST);
    for (int i = 0; i < w.pool.count; i++)
        for (int j = 0; j < w.pool.count; j++) listed[i][j] = pointed[i][j] = 0;
    for (int k = 0; k < probe_lists(&w)->pairs; k++) {
        particle_contact c = probe_lists(&w)->pair[k];
        ck_assert_msg(!listed[c.a][c.b], "pair (%d, %d) is listed twice",
                      c.a, c.b);
        listed[c.a][c.b] = listed[c.b][c.a] = 1;
    }
    for (int k = 0; k < probe_lists(&w)->points; k++) {
        point_pair p = probe_lists(&w)->point[k];
        ck_assert_msg(!pointed[p.particle][p.rigid],
                      "particle %d is listed twice", p.particle);
        pointed[p.particle][p.rigid] = 1;
    }
}

// Particles of one sheet that stood this near each other when it was flat are
// held apart by a stick, or as the ends of a cell's diagonal.
static int are_neighbours(int a, int b, int i, int j)
{
    const shape *s = w.body[a].shape;
    return a == b && vec3_distance(s->at[i], s->at[j])
                     < 1.5 * 2 * w.body[a].thickness;
}

// Is every pair nearer than `margin` beyond touching listed, and, when `exact`,
// no other?  Returns how many are.
static int pairs_are_listed(real margin, int exact)
{
    int found = 0;
    for (int a = 0; a < w.bodies; a++)
        for (int b = a; b < w.bodies; b++) {
            const body *x = &w.body[a], *y = &w.body[b];
            if (!body_is_soft(x) || !body_is_soft(y)) continue;
            real reach = x->thickness + y->thickness + margin;
            for (int i = 0; i < x->shape->particles; i++)
                for (int j = a == b ? i + 1 : 0; j < y->shape->particles; j++) {
                    int p = x->first + i, q = y->first + j;
                    real far = vec3_distance(w.pool.at[p].position,
                                             w.pool.at[q].position);
                    if (are_neighbours(a, b, i, j)) {
                        ck_assert(!listed[p][q]);
                        continue;
                    }
                    if (fabs(far - reach) < EDGE) continue;
                    found += far < reach;
                    if (far < reach)
                        ck_assert_msg(listed[p][q], "(%d, %d), %g m apart, is "
                                      "not listed", p, q, far);
                    else if (exact)
                        ck_assert_msg(!listed[p][q], "(%d, %d), %g m apart, is "
                                      "listed", p, q, far);
                }
        }
    return found;
}

// The same for particles and rigid bodies: what is within margin must be there.
static int points_are_listed(real margin)
{
    int found = 0;
    plane wall[12];
    for (int b = 0; b < w.bodies; b++) {
        const body *rigid = &w.body[b];
        if (body_is_soft(rigid)) continue;
        vec3 at[8];
        rigid_frame frame = probe_frame(&w, b);
        rigid4_ride(rigid->rigid, &frame, at, 8);
        obstacle hit = { { at, 8 }, wall, hull_planes(rigid->shape, at, wall),
                         rigid->shape->radius, 0 };
        for (int i = 0; i < w.pool.count; i++) {
            int a = w.bodies - 1;
            while (w.body[a].first > i) a--;
            if (!body_is_soft(&w.body[a])) continue;
            surface_point p;
            if (!obstacle_nearest(&hit, w.pool.at[i].position, hit.planes,
                                  soft_gap(&w.body[a], rigid) + margin - EDGE,
                                  &p)) continue;
            found++;
            ck_assert_msg(pointed[i][b], "particle %d at body %d is not listed",
                          i, b);
        }
    }
    return found;
}

// A box of half a metre stands over a facet's particles with room enough around
// them: all three in front of the same face.
static bool is_over_face(const rigid_frame *r, const vec3 end[FACET], real room)
{
    bool over[6] = { true, true, true, true, true, true };
    for (int k = 0; k < FACET; k++) {
        vec3 x = vec3_sub(end[k], r->center);
        real at[3];
        for (int i = 0; i < 3; i++)
            at[i] = vec3_dot(x, vec3_unit(r->axis[i]));
        for (int i = 0; i < 6; i++) {
            real up = i < 3 ? at[i] : -at[i - 3];
            over[i] &= up > 0.25 && fabs(at[(i + 1) % 3]) < 0.25 - room
                    && fabs(at[(i + 2) % 3]) < 0.25 - room;
        }
    }
    return over[0] || over[1] || over[2] || over[3] || over[4] || over[5];
}

static bool is_listed(int soft, int rigid, int number)
{
    const facet_list *l = &probe_lists(&w)->facet;
    for (int k = 0; k < l->count; k++)
        if (l->at[k].soft == soft && l->at[k].rigid == rigid
            && l->at[k].number == number) return true;
    return false;
}

// And for the triangles or links of body a at the rigid body b, against the query
// of two bodies.
static int facets_of_are_listed(int a, int b, real margin)
{
    const body *soft = &w.body[a], *rigid = &w.body[b];
    const shape *s = soft->shape;
    real reach = facet_gap(soft, rigid) + margin - EDGE;
    int facets = s->mesh.faces > 0 ? s->mesh.faces : s->sticks, found = 0;
    vec3 at[8], end[FACET];
    rigid_frame frame = probe_frame(&w, b);
    rigid4_ride(rigid->rigid, &frame, at, 8);
    for (int k = 0; k < facets; k++) {
        int corners[FACET];
        facet_corners(soft, k, corners);
        for (int i = 0; i < FACET; i++)
            end[i] = w.pool.at[corners[i]].position;
        gjk_result g = gjk_distance((hull){ end, FACET }, (hull){ at, 8 },
                                    reach, NULL);
        if (g.status == GJK_BEYOND || g.distance > reach) continue;
        if (is_over_face(&frame, end, reach / 2)) continue;
        found++;
        ck_assert_msg(is_listed(a, b, k), "facet %d of %d at %d, %g m from it, "
                      "is not listed", k, a, b, g.distance);
    }
    return found;
}

static int facets_are_listed(real margin)
{
    int found = 0;
    for (int a = 0; a < w.bodies; a++)
        for (int b = 0; b < w.bodies; b++)
            if (body_is_soft(&w.body[a]) && !body_is_soft(&w.body[b]))
                found += facets_of_are_listed(a, b, margin);
    return found;
}

// --- at rest -----------------------------------------------------------------

static int same_places(const vec3 *was)
{
    for (int i = 0; i < w.pool.count; i++)
        if (vec3_distance(w.pool.at[i].position, was[i]) != 0) return 0;
    return 1;
}

// Rejects: neighbours of neighbours that count as touching: a flat cloth would
// swell and never lie still.
START_TEST(flat_cloth_at_rest_touches_nothing)
{
    const struct { int columns, rows; } size[] = {
        { 2, 2 }, { 12, 12 }, { 20, 20 }, { 24, 3 },
    };
    for (int k = 0; k < 4; k++) {
        shape flat;
        int columns = size[k].columns, rows = size[k].rows;
        ck_assert(shape_cloth(&flat, columns, rows, 0.1 * (columns - 1),
                              0.1 * (rows - 1), 1, 1).ok);
        // Turned, so that its distances are rounded.
        placement p = placement_at(vec3_make(1, 2, 3));
        p.x = vec3_make(0.6, 0, 0.8);
        p.y = vec3_make(-0.48, 0.8, 0.36);
        p.z = vec3_make(-0.64, -0.6, 0.48);
        int sheet = add(&flat, p);
        vec3 was[SIDE * SIDE * 4];
        ck_assert_int_le(flat.particles, SIDE * SIDE * 4);
        for (int i = 0; i < flat.particles; i++)
            was[i] = particle_of(sheet, i)->position;
        refresh(H);
        separate(H);
        ck_assert_int_eq(probe_lists(&w)->pairs + probe_lists(&w)->points, 0);
        ck_assert_int_eq(probe_touching(&w), 0);
        ck_assert_int_eq(probe_lists(&w)->dropped, 0);
        ck_assert(same_places(was));
        begin(world_options_default());
        shape_free(&flat);
    }
}
END_TEST

// The right half of the cloth laid over the left one, `gap` above it.
static void fold(int b, real gap)
{
    for (int i = 0; i < cloth.particles; i++) {
        vec3 x = particle_of(b, i)->position;
        if (x.x > 0) put(particle_of(b, i), vec3_make(-x.x, x.y + gap, x.z));
    }
}

// Rejects: self-collision that leaves a whole sheet out.
START_TEST(folded_cloth_touches_itself)
{
    int b = add_at(&cloth, 0, 1, 0);
    fold(b, cloth.spacing / 2);
    refresh(H);
    read_lists();
    ck_assert_int_gt(pairs_are_listed(0, 0), 2 * SIDE);
    separate(H);
    ck_assert_int_gt(probe_touching(&w), 2 * SIDE);
    // The upper layer has gone up, the lower one down.
    real up = 0, down = 0;
    for (int i = 0; i < cloth.particles; i++) {
        real dy = particle_of(b, i)->position.y - particle_of(b, i)->previous.y;
        if (particle_of(b, i)->previous.y > 1) up += dy;
        else down += dy;
    }
    ck_assert_msg(up > 0 && down < 0, "up %g, down %g", up, down);
    ck_assert_int_eq(probe_lists(&w)->dropped, 0);
}
END_TEST

// Rejects: layers that are pushed by the sticks' business: neighbours left in
// the list, or pairs two apart left out.
START_TEST(fold_that_is_wide_enough_touches_nothing)
{
    int b = add_at(&cloth, 0, 1, 0);
    fold(b, 1.11 * cloth.spacing);
    // Only the two middle columns are one spacing apart, and they are joined.
    refresh(H);
    ck_assert_int_gt(probe_lists(&w)->pairs, 0);
    separate(H);
    ck_assert_int_eq(probe_touching(&w), 0);
}
END_TEST

// --- the lists ---------------------------------------------------------------

// A heap: two cloths and a rope crumpled around two boxes.
static void make_heap(real size)
{
    add_at(&cloth, 0, 0, 0);
    add_at(&rope, 0, 0, 0);
    placement nailed = placement_at(vec3_make(0.3, 0.1, 0.2));
    nailed.is_static = 1;
    add(&box, nailed);
    add_at(&cloth, 0, 0.1, 0);
    add_at(&box, -0.4, 0, -0.3);
    for (int b = 0; b < w.bodies; b++) {
        if (!body_is_soft(&w.body[b])) continue;
        for (int i = 0; i < w.body[b].shape->particles; i++) {
            real x = random_real(&seed), y = random_real(&seed);
            put(particle_of(b, i),
                vec3_scale(size, vec3_make(x, y, random_real(&seed))));
        }
    }
}

// Rejects: a margin that one of the traversals forgets; a body's first particle
// forgotten in a pair; a pair or a point twice; a mark that is not wiped.
START_TEST(lists_hold_what_all_pairs_within_the_margin_hold)
{
    const real size[] = { 0.6, 0.8, 1.2, 2 };
    for (int k = 0; k < 12; k++) {
        begin(world_options_default());
        make_heap(size[k % 4]);
        refresh(H);
        ck_assert_int_eq(probe_lists(&w)->dropped, 0);
        read_lists();
        int pairs = pairs_are_listed(probe_lists(&w)->margin, 1);
        int points = points_are_listed(probe_lists(&w)->margin);
        ck_assert_int_eq(pairs, probe_lists(&w)->pairs);
        ck_assert_int_gt(pairs, 0);
        ck_assert_int_ge(probe_lists(&w)->points, points);
        if (size[k % 4] < 1) ck_assert_int_gt(points, 10);
        for (int i = 0; i < probe_lists(&w)->pairs; i++) {
            const particle_contact *c = &probe_lists(&w)->pair[i];
            real thick[2];
            const int end[2] = { c->a, c->b };
            for (int s = 0; s < 2; s++) {
                int b = w.bodies - 1;
                while (w.body[b].first > end[s]) b--;
                thick[s] = w.body[b].thickness;
            }
            ck_assert(c->distance == thick[0] + thick[1]);
        }
    }
}
END_TEST

// A sheet whose particles 33 and 44 go by these shares of the margin: how often
// are the lists made?
static int lists_after(vec3 one, vec3 other)
{
    world_free(&w);
    begin(world_options_default());
    int b = add_at(&cloth, 0, 0, 0);
    refresh(H);
    particle *p = particle_of(b, 33), *q = particle_of(b, 44);
    put(p, vec3_add_scaled(p->position, probe_lists(&w)->margin, one));
    put(q, vec3_add_scaled(q->position, probe_lists(&w)->margin, other));
    refresh(H);
    return probe_lists(&w)->made;
}

// Rejects: lists made in every substep, which would cost all that they spare;
// lists that are never made again; two that go the same way taken for two that
// go against each other, or the other way round; what stands still forgotten.
START_TEST(lists_are_made_again_when_two_have_come_nearer_by_the_margin)
{
    const vec3 none = { 0, 0, 0 };
    const vec3 under = { 0, 0.99, 0 }, over = { 0, 1.01, 0 };
    const vec3 up = { 0, 0.51, 0 }, down = { 0, -0.51, 0 };
    const vec3 less = { 0, -0.47, 0 };
    ck_assert_int_eq(lists_after(under, none), 1);
    ck_assert_int_eq(lists_after(over, none), 2);
    ck_assert_int_eq(lists_after(under, under), 1);
    ck_assert_int_eq(lists_after(over, over), 2);
    ck_assert_int_eq(lists_after(up, less), 1);
    ck_assert_int_eq(lists_after(up, down), 2);
    // None has gone half of the margin: their box does not matter.
    ck_assert_int_eq(lists_after(vec3_make(0.28, 0.28, 0.28),
                                 vec3_make(-0.28, -0.28, -0.28)), 1);
    ck_assert_int_eq(lists_after(vec3_make(0.3, 0.3, 0.3),
                                 vec3_make(-0.3, -0.3, -0.3)), 2);
}
END_TEST

// A box whose particles go by half the margin: its vertices may go twice as
// far.
// Rejects: a rigid body whose moves count for nothing, or as those of its particles.
START_TEST(lists_are_made_again_when_a_rigid_body_has_come_near)
{
    for (int k = 0; k < 2; k++) {
        begin(world_options_default());
        add_at(&cloth, 0, 0, 0);
        int b = add_at(&box, 0, 0.3, 0);
        probe_look(&w);
        refresh(H);
        probe_move(&w, b)->of[0] = (k ? 0.51 : 0.49) * probe_lists(&w)->margin;
        refresh(H);
        ck_assert_int_eq(probe_lists(&w)->made, 1 + k);
    }
}
END_TEST

// Beside a cloth a box comes near, and others fall far away.
// Rejects: lists that are made, or looked at, for what no cloth can meet; a body
// that comes and is not asked about, or only a frame later.
START_TEST(lists_ask_only_about_what_may_come_near)
{
    add_at(&cloth, 0, 0, 0);
    for (int k = 0; k < 8; k++) add_at(&box, 20 + 2 * k, 0, 0);
    int b = add_at(&box, 2, 0, 0);
    probe_look(&w);
    *probe_reach(&w, b) = 0.2;
    refresh(H);
    ck_assert_int_eq(probe_lists(&w)->candidates, 1);
    *probe_reach(&w, b) = 0.22;
    refresh(H);
    ck_assert_int_eq(probe_lists(&w)->candidates, 2);
    ck_assert_int_eq(probe_lists(&w)->candidate[1], b);
    ck_assert_int_eq(probe_lists(&w)->made, 2);
    // What has been asked about is known until another comes.
    *probe_reach(&w, b) = 0;
    refresh(H);
    ck_assert_int_eq(probe_lists(&w)->made, 2);
    // Lost numbers may be anywhere.
    probe_ball(&w, 1)->center.x = (real)NAN;
    refresh(H);
    ck_assert_int_eq(probe_lists(&w)->candidate[1], 1);
}
END_TEST

// Rejects: NaN that keeps the lists of yesterday for good, or a crash.
START_TEST(lists_survive_what_is_not_finite)
{
    int b = add_at(&cloth, 0, 0, 0);
    add_at(&box, 0, 0.3, 0);
    refresh(H);
    particle_of(b, 44)->position.x = (real)NAN;
    probe_lists(&w)->made = 0;
    for (int k = 0; k < 3; k++) {
        refresh(H);
        separate(H);
    }
    ck_assert_int_gt(probe_lists(&w)->made, 0);
    // A speed that is no number, of a particle that is in its place.
    particle_of(b, 44)->position = cloth.at[44];
    refresh(H);
    particle_of(b, 33)->previous.x = (real)NAN;
    for (int k = 0; k < 3; k++) refresh(H);
}
END_TEST

// Rejects: a write past the lists' end; pairs that are lost without a word.
START_TEST(what_finds_no_room_is_counted)
{
    add_at(&cloth, 0, 0, 0);
    add_at(&cloth, 0, 0, 0);
    add_at(&box, 0, 0, 0);
    for (int i = 0; i < 2 * cloth.particles; i++)
        put(&w.pool.at[i], vec3_make(1e-4 * i, 0, 0));
    refresh(H);
    ck_assert_int_gt(probe_lists(&w)->dropped, 0);
    ck_assert_int_le(probe_lists(&w)->pairs, probe_lists(&w)->pair_capacity);
    ck_assert_int_le(probe_lists(&w)->points, probe_lists(&w)->point_capacity);
}
END_TEST

// --- nothing is missed -------------------------------------------------------

// A rigid body goes as it went, under gravity.
static void go_on(int b, real h)
{
    real *u = probe_velocity(&w, b)->of, *d = probe_move(&w, b)->of;
    if (body_is_soft(&w.body[b]) || body_is_static(&w.body[b])) return;
    u[1] += h * w.options.gravity.y;
    for (int i = 0; i < MOTIONS; i++) d[i] += h * u[i];
}

static int facets_met;

static void substep(real h)
{
    for (int b = 0; b < w.bodies; b++) {
        go_on(b, h);
        if (body_is_soft(&w.body[b]))
            verlet_step(particle_of(b, 0), body_particles(&w.body[b]),
                        w.options.gravity, NULL, h);
    }
    renew(h);
    read_lists();
    pairs_are_listed(0, 0);
    points_are_listed(0);
    bool is_new = probe_lists(&w)->substeps == 0;
    facets_met += facets_are_listed(is_new ? probe_lists(&w)->margin : 0);
    separate(h);
    for (int b = 0; b < w.bodies; b++)
        if (body_is_soft(&w.body[b]))
            sticks_relax(w.body[b].shape->stick, w.body[b].shape->sticks,
                         particle_of(b, 0), 2, w.options.relax);
}

// At the end of a frame the particles of rigid bodies follow.
static void follow(void)
{
    for (int b = 0; b < w.bodies; b++) {
        const body *x = &w.body[b];
        const solver_body *now = probe_start(&w, b);
        if (body_is_soft(x) || body_is_static(x)) continue;
        rigid_frame frame = now->frame;
        motion_basis basis = now->basis;
        motion u = *probe_velocity(&w, b);
        motion_displace(&frame, &basis, &u, probe_move(&w, b));
        motion_write(particle_of(b, 0), &frame, &basis, &u, w.age);
    }
}

// A frame begins: how far may rigid bodies get, as fast as they are?
static void foresee(int substeps)
{
    w.frame = substeps * w.age;
    for (int b = 0; b < w.bodies; b++) {
        const real *u = probe_velocity(&w, b)->of;
        real speed = vec3_length((vec3){ u[0], u[1], u[2] });
        speed += vec3_length(w.options.gravity) * w.frame;
        *probe_reach(&w, b) = body_is_static(&w.body[b]) ? 0
                               : w.frame * speed;
    }
    soft_frame f = soft_frame_of(&w, w.age);
    probe_begin_soft(&w, &f);
}

// A cloth that falls over a nailed box and a rope, and is hit from below by a
// quick box when it has nearly come to rest: in every substep each pair that
// touches must be in the lists.
// Rejects: lists that are made again too late, by a wrong margin, a wrong place
// of reference, a body left out, or too much trust in slow bodies.
START_TEST(nothing_is_missed_while_a_cloth_falls)
{
    world_options o = world_options_default();
    o.substeps = 20;
    begin(o);
    placement nailed = placement_at(vec3_make(0, 0, 0));
    nailed.is_static = 1;
    add(&box, nailed);
    int sheet = add_at(&cloth, 0.1, 0.4, 0.05);
    int string = add_at(&rope, 0, 0.6, 0.3);
    placement shot = placement_at(vec3_make(0.6, -2.5, 0.2));
    shot.velocity = vec3_make(0, 9, 0);
    shot.spin = vec3_make(3, 5, 7);
    add(&box, shot);
    world_pin(&w, string, 0);
    int pairs = 0, points = 0, most = 0, made = 0;
    const int substeps = 900;
    for (int k = 0; k < substeps; k++) {
        if (k % w.options.substeps == 0) {
            made += probe_lists(&w)->made;
            probe_look(&w);
            foresee(w.options.substeps);
        }
        substep(w.age);
        if ((k + 1) % w.options.substeps == 0) follow();
        pairs += probe_lists(&w)->pairs;
        points += probe_lists(&w)->points;
        if (probe_touching(&w) > most) most = probe_touching(&w);
    }
    ck_assert_int_eq(probe_lists(&w)->dropped, 0);
    ck_assert_int_gt(pairs, 10 * substeps);
    ck_assert_int_gt(points, 10 * substeps);
    ck_assert_int_gt(most, 30);
    ck_assert_int_gt(facets_met, 100);
    ck_assert_msg(made < substeps / 2, "rebuilt %d times", made);
    for (int i = 0; i < cloth.particles; i++)
        ck_assert(vec3_is_finite(particle_of(sheet, i)->position));
}
END_TEST

// --- the pushes --------------------------------------------------------------

// Two links of 1 kg a particle, crossed in one pair of ends, `gap` apart.
static void cross_links(real gap)
{
    int a = add_at(&link_, 0, 0, 0), b = add_at(&link_, 0, 0, 0);
    put(particle_of(a, 0), vec3_make(-9, 0, 0));
    put(particle_of(a, 1), vec3_make(0, 0, 0));
    put(particle_of(b, 0), vec3_make(0, gap, 0));
    put(particle_of(b, 1), vec3_make(0, 9, 0));
}

// Rejects: a push of one side alone; radii instead of their sum.
START_TEST(particles_part_to_the_sum_of_their_radii)
{
    cross_links(0.2);
    refresh(H);
    ck_assert_int_eq(probe_lists(&w)->pairs, 1);
    probe_lists(&w)->gap[0] = probe_lists(&w)->gap[1] = 1;
    separate(H);
    ck_assert_int_eq(probe_lists(&w)->pairs + probe_lists(&w)->points, 1);
    ck_assert_int_eq(probe_touching(&w), 1);
    real half = w.body[0].thickness;
    ck_assert(fabs(particle_of(0, 1)->position.y - (0.1 - half)) <= ROUNDING);
    ck_assert(fabs(particle_of(1, 0)->position.y - (0.1 + half)) <= ROUNDING);
    ck_assert(particle_of(0, 0)->position.y == 0);
    ck_assert(particle_of(1, 1)->position.y == 9);
    separate(H);
    ck_assert_int_le(probe_touching(&w), 1);
    ck_assert(fabs(particle_of(1, 0)->position.y - (0.1 + half)) <= ROUNDING);
}
END_TEST

// Rejects: a push that undoes at once how they were put; none at all.
START_TEST(what_begins_too_near_parts_in_a_second)
{
    cross_links(0.2);
    refresh(H);
    real most = 2 * w.body[0].thickness, near = 0.2;
    for (int k = 0; k < 1 / H; k++) {
        separate(H);
        real apart = particle_of(1, 0)->position.y
                   - particle_of(0, 1)->position.y;
        ck_assert(apart >= near && apart <= near + most * H + ROUNDING);
        near = apart;
    }
    ck_assert(fabs(near - most) <= ROUNDING);
}
END_TEST

// m/s, the fastest particle of body b.
static real fastest_of(int b)
{
    real most = 0;
    for (int i = 0; i < w.body[b].shape->particles; i++)
        most = real_max(most, vec3_length(world_particle_velocity(&w, b, i)));
    return most;
}

// Without gravity: a sheet through a box that does not move, through one that does,
// and half below a plane.  It comes out, the step says that it was in, and nothing
// has thrown it.
// Rejects: a way out that counts as speed, which is up to 100 m/s here; a report
// that says nothing.
START_TEST(what_begins_in_something_is_put_out_without_speed)
{
    for (int kind = 0; kind < 3; kind++) {
        world_options o = world_options_default();
        o.gravity = ZERO;
        begin(o);
        placement p = placement_at(vec3_make(0.03, 0.1, 0.02));
        p.y = vec3_make(0, 0, -1);
        p.z = vec3_make(0, 1, 0);
        int c = add(&cloth, p);
        if (kind == 0) add_nailed(&box, 0, 0, 0);
        if (kind == 1) add_at(&box, 0, 0, 0);
        if (kind == 2) add_floor();
        int unconverged = 0;
        for (int f = 0; f < 60; f++) {
            world_step(&w);
            unconverged += w.report.unconverged;
            ck_assert_msg(fastest_of(c) < 2, "kind %d, frame %d: %g m/s", kind, f,
                          fastest_of(c));
        }
        ck_assert_int_gt(unconverged, 0);
        ck_assert_int_eq(w.report.unconverged, 0);
        measures m = world_measure(&w);
        ck_assert_msg(m.penetration < 1e-3, "%g m", m.penetration);
        ck_assert_msg(m.kinetic < 0.3, "%g J", m.kinetic);
    }
}
END_TEST

// Rejects: a particle that a box lets in up to its centre; a push of an
// immovable box; the last place of the particle instead of this one.
START_TEST(particle_leaves_a_static_box_by_its_thickness_and_a_third)
{
    const real thick = 1.35 * 0.55 * rope.spacing;
    const struct { vec3 at, to; } move[] = {
        // Just inside, just outside, over an edge.
        { { 0.1, 0.2, 0 }, { 0.1, 0.25 + thick, 0 } },
        { { 0.1, -0.25 - thick / 2, 0.1 }, { 0.1, -0.25 - thick, 0.1 } },
        { { 0.25 + 0.3 * thick, 0, 0.25 + 0.4 * thick },
          { 0.25 + 0.6 * thick, 0, 0.25 + 0.8 * thick } },
    };
    for (int k = 0; k < 3; k++) {
        begin(world_options_default());
        placement nailed = placement_at(vec3_make(0, 0, 0));
        nailed.is_static = 1;
        int b = add(&box, nailed), r = add_at(&rope, 0, 3, 0);
        ck_assert(fabs(soft_gap(&w.body[r], &w.body[b]) - thick)
                  <= ROUNDING);
        put(particle_of(r, 5), move[k].at);
        refresh(H);
        // Its links may go through the box.
        probe_lists(&w)->facet.count = 0;
        separate(H);
        vec3 x = particle_of(r, 5)->position;
        ck_assert_msg(vec3_distance(x, move[k].to) <= 1e-12,
                      "case %d: (%g, %g, %g)", k, x.x, x.y, x.z);
        ck_assert_int_eq(probe_touching(&w), 1);
        for (int i = 0; i < 8; i++)
            ck_assert(vec3_distance(vertex_of(b, i), box.at[i]) <= ROUNDING);
    }
}
END_TEST

static vec3 momentum_of(real h)
{
    vec3 sum = ZERO;
    for (int b = 0; b < w.bodies; b++) {
        const real *u = probe_velocity(&w, b)->of;
        if (!body_is_soft(&w.body[b])) {
            sum = vec3_add_scaled(sum, w.body[b].mass,
                                  vec3_make(u[0], u[1], u[2]));
            continue;
        }
        for (int i = 0; i < body_particles(&w.body[b]); i++) {
            const particle *p = particle_of(b, i);
            vec3 way = vec3_sub(p->position, p->previous);
            sum = vec3_add_scaled(sum, 1 / (h * p->inverse_mass), way);
        }
    }
    return sum;
}

// A cloth that lies on a box, and goes through it: neither has been there
// before, so that all of the overlap is of this substep.
// Rejects: a movable box that is taken for a static one; an impulse of another
// size.
START_TEST(pushes_between_cloth_and_movable_box_keep_momentum)
{
    for (int k = 0; k < 50; k++) {
        world_options o = world_options_default();
        o.friction = k % 3 * 0.4;
        begin(o);
        int b = add_at(&box, 0, 0, 0);
        int s = add_at(&cloth, 0.3 * random_real(&seed), 0.25,
                       0.3 * random_real(&seed));
        probe_look(&w);
        for (int i = 0; i < cloth.particles; i++) {
            particle *p = particle_of(s, i);
            p->position.y += 0.05 * random_real(&seed);
            vec3 way = { random_real(&seed), -10 - random_real(&seed),
                         random_real(&seed) };
            p->previous = vec3_add_scaled(p->position, -0.02, way);
        }
        vec3 before = momentum_of(H);
        refresh(H);
        separate(H);
        ck_assert_int_gt(probe_touching(&w), 5);
        real size = vec3_length(before);
        near_vec3(momentum_of(H), before, 1e-13 * size);
        real down = -8 * probe_velocity(&w, b)->of[1];
        ck_assert_msg(down > size / 50, "the box got %g of %g", down, size);
    }
}
END_TEST

// Rejects: the planes of a movable box as they stood when the frame began, or
// in an earlier substep.
START_TEST(particle_meets_a_movable_box_where_it_is_now)
{
    begin(world_options_default());
    int b = add_at(&box, 0, 0, 0), r = add_at(&rope, 0, 3, 0);
    probe_look(&w);
    real thick = w.body[r].thickness;
    put(particle_of(r, 5), vec3_make(0, 0.25 + 1.1 * thick, 0));
    refresh(H);
    ck_assert_int_eq(probe_lists(&w)->points, 1);
    separate(H);
    ck_assert_int_eq(probe_touching(&w), 0);
    probe_move(&w, b)->of[1] = 0.2 * thick;
    separate(H);
    ck_assert_int_eq(probe_touching(&w), 1);
    // Turned by 45 degrees, its edge is up: 0.35 over its middle.
    put(particle_of(r, 5), vec3_make(0.1, 0.25 + 0.9 * thick, 0));
    real quarter = acos(-1) / 4;
    motion turned = { { 0 } };
    const motion_basis *basis = &probe_start(&w, b)->basis;
    for (int t = 0; t < TURNS; t++)
        turned.of[MOTION_TURN + t] = quarter * basis->turn[t].z
                                   / vec3_length_squared(basis->turn[t]);
    *probe_move(&w, b) = turned;
    separate(H);
    ck_assert_int_eq(probe_touching(&w), 1);
    vec3 x = particle_of(r, 5)->position, edge = { 0, 0.25 * sqrt(2), 0 };
    ck_assert_msg(vec3_dot(vec3_sub(x, edge), vec3_make(1, 1, 0))
                  >= 0.9 * sqrt(2) * thick, "stands at (%g, %g)", x.x, x.y);
}
END_TEST

// Particles under one box in one place push it but once.
// Rejects: each pushed by the overlap that there was before the others came:
// the box would go n times as far.
START_TEST(particles_share_the_push_of_a_box)
{
    world_options o = world_options_default();
    o.gravity = ZERO;
    o.friction = 0;
    begin(o);
    shape light;
    ck_assert(shape_box(&light, vec3_make(0.5, 0.5, 0.5), 1e-9).ok);
    int b = add_at(&light, 0, 0, 0), r = add_at(&rope, 0, -3, 0);
    probe_look(&w);
    real thick = w.body[r].thickness;
    for (int i = 0; i < 6; i++) {
        put(particle_of(r, i), vec3_make(0, -0.25 - 0.5 * thick, 0));
        particle_of(r, i)->previous.y -= thick;
    }
    refresh(H);
    probe_lists(&w)->pairs = 0;
    separate(H);
    ck_assert_int_eq(probe_lists(&w)->points, 6);
    near(probe_move(&w, b)->of[1], 0.5 * thick, 1e-6 * thick);
    shape_free(&light);
}
END_TEST

// A rope's particle under a box, aside of its middle, half a thickness deep.
// Rejects: a speed out of an overlap that was there before; an answer of the
// particle's mass alone, or of the box's without its turning.
START_TEST(box_gives_way_as_a_solid)
{
    for (int k = 0; k < 100; k++) {
        world_options o = world_options_default();
        o.gravity = ZERO;
        o.friction = 0;
        begin(o);
        int b = add_at(&box, 0, 0, 0), r = add_at(&rope, 0, -3, 0);
        probe_look(&w);
        real thick = w.body[r].thickness;
        particle *p = particle_of(r, 5);
        put(p,
            vec3_make(0.2 * random_real(&seed), -0.25 - 0.5 * thick,
                      0.2 * random_real(&seed)));
        // Even ones came in this substep; the others lay there before.
        bool is_new = k % 2 == 0;
        if (is_new) p->previous.y -= thick;
        vec3 was = p->position, back = p->previous;
        real lever2 = was.x * was.x + was.z * was.z, side2 = 0.5 * 0.5;
        // The box has 8 kg: 1/M + r^2 / I, I = M 2 s^2 / 12.
        real box_gives = 1 / 8.0 + lever2 / (8 * side2 / 6);
        real give = box_gives + p->inverse_mass, push = 0.5 * thick / give;
        refresh(H);
        separate(H);
        ck_assert_int_eq(probe_touching(&w), 1);
        near(was.y - p->position.y, push * p->inverse_mass, 1e-12);
        near(back.y - p->previous.y,
                  is_new ? 0 : push * p->inverse_mass, 1e-12);
        near(8 * probe_move(&w, b)->of[1], push, 1e-12);
        near(8 * probe_velocity(&w, b)->of[1], is_new ? push / H : 0,
                  1e-12 / H);
        vec3 turn = motion_rotation(&probe_start(&w, b)->basis,
                                    probe_move(&w, b));
        vec3 moment = vec3_cross(was, vec3_make(0, push, 0));
        near_vec3(turn, vec3_scale(6 / (8 * side2), moment), 1e-12);
    }
}
END_TEST

// A particle slides over a box in one substep: the box takes its speed along,
// but no more than friction times the push.
// Rejects: friction without the cone; one that turns the sliding round; sliding
// that is measured against the world instead of the box.
START_TEST(friction_stays_in_the_cone)
{
    const real slide[] = { 0.001, 0.02, 0.2 };
    for (int k = 0; k < 6; k++) {
        world_options o = world_options_default();
        o.gravity = ZERO;
        o.friction = 0.3;
        begin(o);
        int b = add_at(&box, 0, 0, 0), r = add_at(&rope, 0, 3, 0);
        probe_look(&w);
        real thick = w.body[r].thickness, depth = 0.5 * thick;
        // The box itself may go along.
        real along = k < 3 ? 0 : 0.05 / H;
        probe_velocity(&w, b)->of[0] = along;
        particle *p = particle_of(r, 5);
        put(p, vec3_make(0, 0.25 + 0.5 * thick, 0));
        p->previous.x -= slide[k % 3] + H * along;
        p->previous.y += thick;
        refresh(H);
        separate(H);
        const real *u = probe_velocity(&w, b)->of;
        real push = -8 * H * u[1], got = 8 * H * (u[0] - along);
        real give = 1 / 8.0 + p->inverse_mass;
        near(push, depth / give, 1e-12);
        // At the top of the box a push across turns it, too: I = M s^2 / 6.
        real across = give + 0.25 * 0.25 / (8 * 0.25 / 6);
        real whole = slide[k % 3] / across, most = 0.3 * push;
        near(got, whole < most ? whole : most, 1e-12);
        ck_assert(k % 3 != 0 || whole < most);
        ck_assert(k % 3 != 2 || whole > most);
    }
}
END_TEST

// A triangle lies over the corner of a box, by the weights of its plan, so far
// in front of it; all else of the sheet is far away.
static void lay_over_corner(int s, real gap)
{
    const real at[FACET][2] = { { 0.2, 0.1 }, { -0.3, 0.2 }, { -0.05, -0.55 } };
    vec3 n = vec3_unit(vec3_make(1, 1, 1)), x = vec3_unit(vec3_make(1, -1, 0));
    vec3 y = vec3_cross(n, x), here = vec3_make(0.25, 0.25, 0.25);
    here = vec3_add_scaled(here, gap, n);
    int end[FACET];
    facet_corners(&w.body[s], 80, end);
    for (int i = 0; i < cloth.particles; i++)
        put(particle_of(s, i), vec3_make(9 + i, 9, 9));
    for (int k = 0; k < FACET; k++)
        put(&w.pool.at[end[k]],
            vec3_add_scaled(vec3_add_scaled(here, at[k][0] / 2, x),
                            at[k][1] / 2, y));
}

// A triangle meets the corner of a box, or comes near it, and its sticks pull it
// over that.  A particle may weigh a hundred sheets, and all go as one: nothing has
// come nearer, so the overlap is parted without a speed.
// Rejects: tips and edges that are asked before the sticks alone, or after them
// only by what met them before: they come through; three light particles that
// answer for their sheet; the sum over all that hangs there, over the mass of the
// sheet alone, by which a heavy sheet seems to come at 100 m/s.
START_TEST(triangle_that_sticks_pull_back_is_held_by_all_of_its_sheet)
{
    for (int k = 0; k < 5; k++) {
        bool pinned = k & 1, meets = k & 2, heavy = k == 4;
        world_options o = world_options_default();
        o.gravity = ZERO;
        o.friction = 0;
        begin(o);
        int b = add_at(&box, 0, 0, 0), s = add_at(&cloth, 0, 0, 0);
        if (pinned) world_pin(&w, s, 0);
        if (heavy) particle_of(s, 1)->inverse_mass /= 1e4;
        probe_look(&w);
        vec3 n = vec3_unit(vec3_make(1, 1, 1));
        real gap = facet_gap(&w.body[s], &w.body[b]);
        lay_over_corner(s, meets ? 0.9 * gap : 1.5 * gap);
        int end[FACET];
        facet_corners(&w.body[s], 80, end);
        for (int i = 0; i < FACET; i++) {
            particle *p = &w.pool.at[end[i]];
            p->previous = vec3_add_scaled(p->previous, 0.1 * gap, n);
        }
        refresh(H);
        separate(H);
        ck_assert_int_eq(probe_touching(&w), meets);
        // Nothing has gone to where it lies now: the overlap is an old one.
        *probe_velocity(&w, b) = *probe_move(&w, b) = (motion){ { 0 } };
        lay_over_corner(s, 0.3 * gap);
        for (int i = 0; i < cloth.particles && heavy; i++)
            particle_of(s, i)->previous =
                vec3_add_scaled(particle_of(s, i)->position, H, n);
        if (heavy) *probe_velocity(&w, b) = (motion){ { -n.x, -n.y, -n.z } };
        vec3 was = particle_of(s, 0)->position;
        hold(H);
        real sheet = heavy ? 1 / 100.99 : 1;
        real push = 0.7 * gap / (1 / 8.0 + (pinned ? 0 : sheet));
        const real *d = probe_move(&w, b)->of, *u = probe_velocity(&w, b)->of;
        near_vec3(vec3_make(d[0], d[1], d[2]), vec3_scale(-push / 8, n), 1e-12);
        near_vec3(vec3_make(u[0], u[1], u[2]), vec3_scale(heavy ? -1 : 0, n),
                  1e-12 / H);
        near_vec3(vec3_sub(particle_of(s, 0)->position, was),
                  vec3_scale(pinned ? 0 : sheet * push, n), 1e-12);
    }
}
END_TEST

// How many edges of the box pass through a triangle of the sheet?
static int edges_through(int b, int sheet)
{
    static solid hard;
    vec3 at[SIDE * SIDE];
    int count = 0;
    world_vertices(&w, &w.body[b], at);
    solid_make(&hard, at, box.particles, box.face, box.mesh.faces);
    world_vertices(&w, &w.body[sheet], at);
    for (int k = 0; k < cloth.mesh.faces; k++) {
        patch p = patch_make(at, &cloth.face[FACET * k], 0);
        count += solid_edges_through(&hard, &p);
    }
    return count;
}

// A box of 8 kg is driven into a sheet of 1 kg, a corner ahead or flat; it hangs free,
// or a corner of it weighs a hundred sheets, or its corners are pinned.
// Rejects: a box that drives light particles before it, which their sticks pull back
// and through it; a push that one of the two does not feel.
START_TEST(sheet_stops_what_is_driven_into_it)
{
    const real speed[] = { 2, 10, 40 };
    for (int k = 0; k < 18; k++) {
        world_options o = world_options_default();
        o.gravity = ZERO;
        begin(o);
        int s = add_at(&cloth, 0, 0, 0), hangs = k / 3 % 3;
        real up = sqrt(1.0 / 3), out = sqrt(2.0 / 3), side = out * sqrt(0.75);
        placement p = placement_at(vec3_make(0.03, k < 9 ? 0.6 : 0.4, 0.02));
        if (k < 9) {
            p.x = vec3_make(out, up, 0);
            p.y = vec3_make(-out / 2, up, -side);
            p.z = vec3_make(-out / 2, up, side);
        }
        p.velocity = vec3_make(0, -speed[k % 3], 0);
        int b = add(&box, p);
        for (int i = 0; i < 4 && hangs == 2; i++)
            world_pin(&w, s, (i / 2 * SIDE + i % 2) * (SIDE - 1));
        if (hangs == 1) particle_of(s, 0)->inverse_mass /= 1e4;
        for (int f = 0; f < 30; f++) {
            world_step(&w);
            int edges = edges_through(b, s);
            ck_assert_msg(edges == 0, "%d, frame %d: %d edges", k, f, edges);
        }
        // The measure does not know of the weight.
        const particle *p0 = particle_of(s, 0);
        vec3 way = vec3_sub(p0->position, p0->previous);
        vec3 momentum = world_measure(&w).momentum;
        if (hangs == 1) momentum = vec3_add_scaled(momentum, 99.99 / w.age, way);
        if (hangs < 2)
            near_vec3(momentum, vec3_make(0, -8 * speed[k % 3], 0), 1e-9);
    }
}
END_TEST

// Rejects: sleepers that are listed, and cost, while nothing near them moves.
START_TEST(lists_leave_out_what_sleeps_or_is_static)
{
    for (int sleepers = 0; sleepers < 3; sleepers++) {
        int a = add_at(&cloth, 0, 0, 0), b = add_at(&cloth, 0, 0.05, 0);
        placement nailed = placement_at(vec3_make(0, -0.25, 0));
        nailed.is_static = 1;
        add(&box, nailed);
        if (sleepers > 0) probe_lay(&w, a);
        if (sleepers > 1) probe_lay(&w, b);
        refresh(H);
        if (sleepers == 2) {
            ck_assert_int_eq(probe_lists(&w)->pairs, 0);
            ck_assert_int_eq(probe_lists(&w)->points, 0);
        } else {
            ck_assert_int_gt(probe_lists(&w)->pairs, SIDE * SIDE / 2);
            ck_assert_int_gt(probe_lists(&w)->points, 10);
        }
        world_free(&w);
        begin(world_options_default());
    }
}
END_TEST

// --- a frame begins ----------------------------------------------------------

static void lay_to_sleep(int b)
{
    probe_lay(&w, b);
    
    for (int i = 0; i < body_particles(&w.body[b]); i++) {
        particle_of(b, i)->inverse_mass = 0;
        particle_of(b, i)->previous = particle_of(b, i)->position;
    }
}

// Rejects: a sleeper that is passed through; one that wakes for what is far
// away; a cloth that is no part of the island of what it lies on.
START_TEST(sleepers_near_a_cloth_wake_and_rest_with_it)
{
    for (int k = 0; k < 4; k++) {
        bool is_near = k & 1, is_soft = k & 2;
        begin(world_options_default());
        int c = add_at(&cloth, 0, is_near ? 0.4 : 9, 0);
        int b = add_at(is_soft ? &rope : &box, 0, 0, 0);
        int fixed = add_nailed(&box, 0, 0.8, 0);
        lay_to_sleep(b);
        for (int i = 0; i < cloth.particles; i++)
            particle_of(c, i)->previous.y += 0.01;
        probe_stir(&w, c);
        probe_begin_sleep(&w);
        ck_assert(soft_wake(&w) == is_near);
        ck_assert(probe_sleeps(&w, b) == !is_near);
        ck_assert((particle_of(b, 0)->inverse_mass > 0) == is_near);
        ck_assert((probe_joined(&w, b) == probe_joined(&w, c)) == is_near);
        ck_assert_int_ne(probe_joined(&w, fixed), probe_joined(&w, c));
    }
}
END_TEST

// Rejects: a ball that goes further in a substep than its radius; one
// that passes far away and costs substeps; a number without an upper bound, or
// of a body that is lost; what the cloth does itself left out; fewer than usual
// for a cloth that moves.
START_TEST(substeps_are_as_many_as_what_comes_near_needs)
{
    world_options o = world_options_default();
    o.gravity = ZERO;
    o.most_substeps = 1000;
    const struct { real away, way; int wanted; bool meets; } ball[] = {
        { 0.6, 1, 4, 1 }, { 0.6, 3, 12, 1 }, { 9, 1, 0, 0 },
        { 9, 10, 40, 1 }, { 0.6, 1e9, 1000, 1 }, { 0.6, (real)NAN, 0, 0 },
        { 0.6, HUGE_VAL, 0, 1 },
    };
    for (int k = 0; k < 7; k++) {
        begin(o);
        int c = add_at(&cloth, 0, 0, 0), b = add_at(&box, 0, ball[k].away, 0);
        // The inner radius of the box is 0.25 m.
        *probe_reach(&w, b) = ball[k].way;
        w.frame = o.dt;
        probe_begin_sleep(&w);
        soft_wake(&w);
        int own = soft_need(&w), wanted = int_max(ball[k].wanted,
                                               ball[k].meets ? 8 : 4);
        ck_assert_msg(own == wanted, "case %d: %d", k, own);
        // It goes half a spacing in each of 40, if there is something to meet: its
        // parts go alike.
        real far = 40 * cloth.spacing / 2 * w.age / o.dt;
        for (int i = 0; i < cloth.particles; i++)
            particle_of(c, i)->previous.y -= far;
        soft_wake(&w);
        own = soft_need(&w);
        wanted = int_max(ball[k].wanted, ball[k].meets ? 41 : 4);
        ck_assert_msg(own == wanted, "case %d: %d with the cloth's", k, own);
        *probe_reach(&w, b) = 0;
        soft_wake(&w);
        ck_assert_int_eq(soft_need(&w), ball[k].away < 1 ? 41 : 4);
        // One of its particles alone does, if nothing else: past the others.
        for (int i = 1; i < cloth.particles; i++)
            particle_of(c, i)->previous.y += far;
        soft_wake(&w);
        ck_assert_int_ge(soft_need(&w), 40);
    }
}
END_TEST

// Rejects: a cell of which only the diagonal with the stick is looked after;
// ends that are pulled together where the cell is only bent a little; a pinned
// particle that moves.
START_TEST(ends_of_diagonals_are_kept_apart)
{
    shape cell;
    ck_assert(shape_cloth(&cell, 2, 2, 1, 1, 1, 0.001).ok);
    for (int k = 0; k < 2; k++) {
        world_options o = world_options_default();
        o.substeps = 8;
        begin(o);
        int c = add_at(&cell, 0, 0, 0), a = k, b = 3 - k;
        real least = 2 * w.body[c].thickness;
        soft_frame f = soft_frame_of(&w, H);
        // 1.2 of the least, then 0.8 of it.
        vec3 way = vec3_sub(particle_of(c, b)->position,
                            particle_of(c, a)->position);
        way = vec3_scale(least / vec3_length(way), way);
        put(particle_of(c, b),
            vec3_add_scaled(particle_of(c, a)->position, 1.2, way));
        probe_draw(&w, &f);
        real far = vec3_distance(particle_of(c, a)->position,
                                 particle_of(c, b)->position);
        ck_assert(fabs(far / least - 1.2) < 0.01);
        particle_of(c, a)->inverse_mass = 0;
        vec3 was = particle_of(c, a)->position;
        put(particle_of(c, b), vec3_add_scaled(was, 0.8, way));
        probe_draw(&w, &f);
        ck_assert(vec3_distance(particle_of(c, a)->position, was) == 0);
        far = vec3_distance(was, particle_of(c, b)->position);
        ck_assert_msg(fabs(far - least) < EDGE, "%d: %g of %g", k, far,
                      least);
    }
    shape_free(&cell);
}
END_TEST

// Which share of what is wrong with the diagonal of a cell is gone after soft_draw
// in a substep of h?
static real share_drawn(const shape *cell, real h)
{
    const stick *diagonal = &cell->stick[shape_links(cell)];
    real off = 1e-5 * diagonal->rest_length;
    int c = add_at(cell, 0, 0, 0);
    particle *a = particle_of(c, diagonal->a), *b = particle_of(c, diagonal->b);
    soft_frame f = soft_frame_of(&w, h);
    vec3 out = vec3_unit(vec3_sub(b->position, a->position));
    put(b, vec3_add_scaled(b->position, off, out));
    probe_draw(&w, &f);
    return 1 - (vec3_distance(a->position, b->position)
                - diagonal->rest_length) / off;
}

// A spring's share is k in a substep of h, and 1 / (1 + (1 / k - 1) 4) in half of
// that.  Rejects: diagonals that correct as much in every substep, so that a
// sheet is four times as stiff in half of one; softer ones in long substeps.
START_TEST(diagonals_are_no_stiffer_in_short_substeps)
{
    shape cell;
    world_options o = world_options_default();
    const struct { real substeps, wanted; } is[] = {
        { 1, 0.2 }, { 8, 0.2 }, { 13, 0.2 }, { 26, 1.0 / 17 },
        { 130, 1.0 / 401 },
    };
    ck_assert(shape_cloth(&cell, 2, 2, 1, 1, 1, 0.2).ok);
    for (int k = 0; k < 10; k++) {
        o.relax.gradient = k < 5 ? GRADIENT_OLD : GRADIENT_NEW;
        begin(o);
        near(share_drawn(&cell, o.dt / is[k % 5].substeps), is[k % 5].wanted,
             1e-4);
    }
    shape_free(&cell);
}
END_TEST

// A frame of 11 substeps in four parts is one of 12.  Rejects: a part that takes
// as many as all of the frame.
START_TEST(parts_of_a_frame_share_its_substeps)
{
    world_options o = world_options_default();
    o.gravity = ZERO;
    o.substeps = 2;
    begin(o);
    int c = add_at(&cloth, 0, 0, 0);
    world_pin(&w, c, 0);
    for (int parts = 1; parts <= 4; parts += 3) {
        w.frame = o.dt / parts;
        probe_press(&w, HUGE_VAL);
        soft_wake(&w);
        ck_assert_int_eq(soft_need(&w), parts == 1 ? 11 : 3);
    }
}
END_TEST

// Nine more than the world's four.  Rejects: nine more than what is usual beside
// what moves, which is eight.
START_TEST(a_pinned_cloth_takes_thirteen_substeps)
{
    world_options o = world_options_default();
    o.gravity = ZERO;
    begin(o);
    world_pin(&w, add_at(&cloth, 0, 0, 0), 0);
    w.frame = o.dt;
    probe_press(&w, HUGE_VAL);
    soft_wake(&w);
    ck_assert_int_eq(soft_need(&w), 13);
}
END_TEST

// Rejects: a rule for weight that forgets the spacing, or a load; layers that ask for no
// substeps, or without bound; a number that falls at once, or never.
START_TEST(weight_and_layers_take_more_substeps)
{
    world_options o = world_options_default();
    real times = 20.5 / o.dt;
    o.gravity = vec3_make(0, -0.02 * cloth.spacing * times * times, 0);
    begin(o);
    add_at(&cloth, 0, 0, 0);
    w.frame = o.dt;
    soft_wake(&w);
    ck_assert_int_eq(soft_need(&w), 20);

    // A quarter of a link's length, for all that hangs on it.
    shape loaded;
    ck_assert(shape_rope(&loaded, 12, 1.2, 0.13).ok);
    loaded.mass[12] = 10;
    o.gravity = vec3_make(0, -0.25 * 0.01 / 10.12 * 0.1 * times * times, 0);
    begin(o);
    add_at(&loaded, 0, 0, 0);
    w.frame = o.dt;
    soft_wake(&w);
    ck_assert_int_eq(soft_need(&w), 20);
    shape_free(&loaded);

    o.gravity = ZERO;
    begin(o);
    add_at(&cloth, 0, 0, 0);
    w.frame = o.dt;
    const struct { real asked; int wanted; } layers[] = {
        { 3.5, 4 }, { 11.5, 11 }, { 1e9, 13 },
    };
    for (int k = 0; k < 3; k++) {
        probe_press(&w, layers[k].asked / o.dt);
        soft_wake(&w);
        ck_assert_int_eq(soft_need(&w), layers[k].wanted);
    }
    for (int f = 1; f <= 3; f++) soft_wake(&w);
    ck_assert_int_eq(soft_need(&w), 13);
    soft_wake(&w);
    ck_assert_int_eq(soft_need(&w), 4);
}
END_TEST

// Rejects: a square of the new substep alone, a last move that is carried on
// whole; a sleeper that falls.
START_TEST(parabola_is_exact_when_the_substep_changes)
{
    int b = add_thrown(&link_, ZERO, vec3_make(3, 4, 0), ZERO);
    int still = add_at(&link_, 99, 0, 0);
    lay_to_sleep(still);
    vec3 at = particle_of(b, 0)->position;
    real t = 0;
    for (int k = 0; k < 200; k++) {
        real h = 0.01 + 0.006 * random_real(&seed);
        soft_step(&w, h);
        ck_assert(w.age == h);
        t += h;
        vec3 wanted = vec3_add(at, vec3_make(3 * t, 4 * t - 9.81 * t * t / 2,
                                             0));
        near_vec3(particle_of(b, 0)->position, wanted, 1e-11);
        ck_assert(particle_of(still, 0)->position.y == 0);
    }
}
END_TEST

// Rejects: the mean strain; diagonals, which are soft, counted as strands; NaN
// taken for a small strain; a body that nothing moves.
START_TEST(what_is_stretched_by_a_hundredth_is_counted)
{
    const struct { real by; int wanted; } stretch[] = {
        { 0, 0 }, { 0.009, 0 }, { 0.011, 1 }, { -0.011, 1 },
        { (real)NAN, 1 },
    };
    for (int k = 0; k < 5; k++) {
        begin(world_options_default());
        int a = add_at(&rope, 0, 0, 0), still = add_at(&rope, 0, 1, 0);
        add_at(&box, 0, 9, 0);
        int c = add_at(&cloth, 0, 5, 0);
        lay_to_sleep(still);
        particle_of(a, 12)->position.x += stretch[k].by * rope.spacing;
        particle_of(still, 12)->position.x += 1;
        for (int i = 0; i < cloth.particles; i++) {
            vec3 *x = &particle_of(c, i)->position;
            x->x += 0.1 * x->z;
            x->z *= sqrt(1 - 0.1 * 0.1);
        }
        ck_assert_int_eq(stretched(), stretch[k].wanted);
    }
}
END_TEST

// --- edges and corners -------------------------------------------------------

// A box of 4 cm, small enough for a cell of the cloth, on its corner, which is
// `deep` above y = 0, under a triangle of the cell in the middle and no nearer
// than the gap to another, if it is nearly as much below.
static int add_tip(const shape *small, real deep, bool is_static)
{
    real half = 0.02 * sqrt(3), a = sqrt(0.5), b = sqrt(1.0 / 6);
    real c = sqrt(1.0 / 3);
    placement p = placement_at(vec3_make(0.03, deep - half, 0));
    p.x = vec3_make(-a, c, b);
    p.y = vec3_make(a, c, b);
    p.z = vec3_make(0, c, -2 * b);
    p.is_static = is_static;
    return add(small, p);
}

static void shape_tip(shape *s)
{
    ck_assert(shape_box(s, vec3_make(0.04, 0.04, 0.04), 0.3).ok);
}

static int lifted(int b)
{
    int n = 0;
    for (int i = 0; i < cloth.particles; i++)
        n += particle_of(b, i)->position.y != 0;
    return n;
}

// A corner under a triangle, and how far its particles are lifted: as their
// weights say, y_i = lambda c_i w, where sum c_i y_i is the depth.
// Rejects: particles that share alike; a lift by the depth itself; a corner that
// no list knows.
START_TEST(corner_lifts_a_triangle_by_its_weights)
{
    shape small;
    shape_tip(&small);
    for (int k = 0; k < 3; k++) {
        begin(world_options_default());
        real gap = 0.7 * 0.55 * cloth.spacing, deep = -(0.9 + 0.04 * k) * gap;
        int s = add_at(&cloth, 0, 0, 0);
        add_tip(&small, deep, true);
        refresh(H);
        // What they hold apart themselves is not the matter here.
        probe_lists(&w)->points = probe_lists(&w)->pairs = 0;
        separate(H);
        ck_assert_int_eq(probe_touching(&w), 1);
        real sum = 0, at_x = 0, at_z = 0, square = 0;
        ck_assert_int_eq(lifted(s), 3);
        for (int i = 0; i < cloth.particles; i++) {
            vec3 x = particle_of(s, i)->position;
            sum += x.y;
            at_x += x.x * x.y;
            at_z += x.z * x.y;
            square += x.y * x.y;
        }
        // c_i = y_i / sum, and so the corner's place is their mean.
        near(at_x / sum, 0.03, 1e-9);
        near(at_z / sum, 0, 1e-9);
        near(square / sum, gap + deep, 1e-9);
    }
    shape_free(&small);
}
END_TEST

// A movable one, that comes up from below.
// Rejects: a box that answers with its mass alone, or not at all; weights that
// are not those of the point.
START_TEST(corner_that_comes_up_keeps_momentum)
{
    shape small;
    shape_tip(&small);
    for (int k = 0; k < 50; k++) {
        world_options o = world_options_default();
        o.friction = k % 3 * 0.4;
        begin(o);
        int s = add_at(&cloth, 0, 0, 0), b = add_tip(&small, 0, false);
        probe_look(&w);
        motion *u = probe_velocity(&w, b);
        *u = (motion){ { random_real(&seed), 3, random_real(&seed),
                         random_real(&seed), random_real(&seed),
                         random_real(&seed) } };
        for (int i = 0; i < MOTIONS; i++)
            probe_move(&w, b)->of[i] = H * u->of[i];
        vec3 before = momentum_of(H);
        refresh(H);
        probe_lists(&w)->points = probe_lists(&w)->pairs = 0;
        separate(H);
        ck_assert_int_ge(probe_touching(&w), 1);
        ck_assert_int_ge(lifted(s), 3);
        near_vec3(momentum_of(H), before, 1e-13 * vec3_length(before));
        ck_assert(u->of[1] < 3);
    }
    shape_free(&small);
}
END_TEST

// Boxes smaller than a cell, anywhere about a cloth of long cells that lies flat.
// Rejects: a facet that is forgotten because its corners are far.
START_TEST(facets_at_a_small_box_are_listed)
{
    shape small, cells;
    int found = 0;
    shape_tip(&small);
    ck_assert(shape_cloth(&cells, 4, 10, 1, 1, 1, 0.2).ok);
    for (int k = 0; k < 200; k++) {
        begin(world_options_default());
        int s = add_at(&cells, 0, 0, 0);
        placement p = anywhere(0.5, 0, 0);
        p.position.y *= 0.25;
        p.is_static = k % 2;
        int b = add(&small, p);
        probe_look(&w);
        refresh(H);
        found += facets_of_are_listed(s, b, probe_lists(&w)->margin);
    }
    ck_assert_int_gt(found, 200);
    shape_free(&small);
    shape_free(&cells);
}
END_TEST

// The corner is above the cloth after one substep, and new lists are made.
// Rejects: a side that is forgotten with the lists.
START_TEST(cloth_is_put_back_on_the_side_that_it_came_from)
{
    shape small;
    shape_tip(&small);
    int s = add_at(&cloth, 0, 0, 0);
    add_tip(&small, 0, true);
    refresh(H);
    separate(H);
    ck_assert_int_ge(probe_touching(&w), 1);
    const facet_list *facets = &probe_lists(&w)->facet;
    facet_pair met = { .number = -1 };
    for (int k = 0; k < facets->count && met.number < 0; k++)
        if (facets->at[k].between.normal.x != 0) met = facets->at[k];
    ck_assert_int_ge(met.number, 0);
    real deep = 0.02;
    for (int i = 0; i < cloth.particles; i++)
        put(particle_of(s, i), vec3_sub(particle_of(s, i)->position,
                                        vec3_make(0, deep, 0)));
    vec3 was[SIDE * SIDE];
    for (int i = 0; i < cloth.particles; i++)
        was[i] = particle_of(s, i)->position;
    probe_lists(&w)->is_stale = true;
    refresh(H);
    ck_assert_int_eq(probe_lists(&w)->substeps, 0);
    for (int k = 0; k < probe_lists(&w)->facet.count; k++) {
        facet_pair pair = probe_lists(&w)->facet.at[k];
        if (pair.number != met.number) continue;
        near_vec3(pair.between.normal, met.between.normal, 0);
        near(pair.between.offset, met.between.offset, 0);
    }
    probe_lists(&w)->points = probe_lists(&w)->pairs = 0;
    separate(H);
    int up = 0;
    for (int i = 0; i < cloth.particles; i++) {
        real rise = particle_of(s, i)->position.y - was[i].y;
        up += rise > deep / 2;
        ck_assert_msg(rise >= 0, "particle %d is pushed down: %g", i, rise);
    }
    ck_assert_int_ge(up, 1);
    shape_free(&small);
}
END_TEST

// m, how high the cloth is over (x, z): the least, of all its triangles there.
static real least_over(int b, real x, real z)
{
    real least = HUGE_VAL;
    for (int k = 0; k < cloth.mesh.faces; k++) {
        vec3 e[FACET];
        for (int i = 0; i < FACET; i++)
            e[i] = particle_of(b, cloth.face[FACET * k + i])->position;
        vec3 n = triangle_normal(e[0], e[1], e[2]);
        real c[FACET];
        bool is_in = true;
        for (int i = 0; i < FACET; i++) {
            vec3 p = e[(i + 1) % 3], q = e[(i + 2) % 3];
            c[i] = ((p.z - z) * (q.x - x) - (p.x - x) * (q.z - z)) / n.y;
            is_in &= c[i] >= 0;
        }
        if (!is_in) continue;
        real y = c[0] * e[0].y + c[1] * e[1].y + c[2] * e[2].y;
        least = real_min(least, y);
    }
    return least;
}

// A cloth falls on a needle of 1 cm that stands under the middle of a cell, and
// hangs on it.  (Without facets it has fallen through in the second frame.)
// Rejects: what only particles hold; a strain of more than a twentieth.
START_TEST(needle_does_not_pierce_a_cloth)
{
    shape thin;
    ck_assert(shape_box(&thin, vec3_make(0.01, 2, 0.01), 1).ok);
    world_options o = world_options_default();
    o.sleep_speed = 0;
    begin(o);
    placement p = placement_at(vec3_make(0.01, -1, 0.005));
    p.is_static = true;
    add(&thin, p);
    int s = add_at(&cloth, 0, 0.1, 0);
    for (int k = 0; k < 120; k++) {
        world_step(&w);
        real high = least_over(s, 0.01, 0.005);
        ck_assert_msg(high > 0, "pierced in frame %d: %g", k, high);
        real strain = world_measure(&w).strain;
        ck_assert_msg(strain <= 0.05, "strain %g in frame %d", strain, k);
    }
    shape_free(&thin);
}
END_TEST

// A link of a rope over the needle's top, between its particles.
// Rejects: a rope that has no facets.
START_TEST(link_lies_on_an_edge)
{
    shape thin;
    ck_assert(shape_box(&thin, vec3_make(0.01, 2, 1), 1).ok);
    begin(world_options_default());
    placement p = placement_at(vec3_make(0.02, -1, 0));
    p.is_static = true;
    add(&thin, p);
    int r = add_at(&rope, 0, 0.001, 0);
    refresh(H);
    probe_lists(&w)->points = probe_lists(&w)->pairs = 0;
    separate(H);
    real gap = facet_gap(&w.body[r], &w.body[0]);
    int up = 0;
    for (int i = 0; i < rope.particles; i++)
        up += particle_of(r, i)->position.y > 0.001;
    ck_assert_int_eq(probe_touching(&w), 1);
    ck_assert_int_eq(up, 2);
    ck_assert(gap > 0.001);
    shape_free(&thin);
}
END_TEST

// --- planes ------------------------------------------------------------------

// Rejects: planes that the thickness is left out of; a pinned particle, or a
// sleeper, that is pushed; a plane that is forgotten.
START_TEST(particles_are_kept_off_planes)
{
    int b = add_at(&cloth, 0, 0, 0), still = add_at(&rope, 0, 3, 0);
    world_pin(&w, b, 0);
    ck_assert(world_add_plane(&w, UP, 0).ok);
    ck_assert(world_add_plane(&w, vec3_make(-1, 0, 0), -9).ok);
    real thick = w.body[b].thickness;
    probe_lay(&w, still);
    put(particle_of(still, 2), vec3_make(0, -1, 0));
    put(particle_of(b, 5), vec3_make(10, 4, 0));
    refresh(H);
    separate(H);
    ck_assert_int_ge(probe_touching(&w), cloth.particles);
    for (int i = 0; i < cloth.particles; i++) {
        vec3 x = particle_of(b, i)->position;
        if (i == 0) ck_assert(x.y == 0);
        else if (i == 5) near_vec3(x, vec3_make(9 - thick, 4, 0), ROUNDING);
        else ck_assert(fabs(x.y - thick) <= ROUNDING);
    }
    ck_assert(particle_of(still, 2)->position.y == -1);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        flat_cloth_at_rest_touches_nothing,
        folded_cloth_touches_itself,
        fold_that_is_wide_enough_touches_nothing,
        lists_are_made_again_when_two_have_come_nearer_by_the_margin,
        lists_are_made_again_when_a_rigid_body_has_come_near,
        lists_ask_only_about_what_may_come_near,
        lists_survive_what_is_not_finite,
        what_finds_no_room_is_counted,
        particles_part_to_the_sum_of_their_radii,
        what_begins_too_near_parts_in_a_second,
        what_begins_in_something_is_put_out_without_speed,
        box_gives_way_as_a_solid,
        particles_share_the_push_of_a_box,
        friction_stays_in_the_cone,
        triangle_that_sticks_pull_back_is_held_by_all_of_its_sheet,
        sheet_stops_what_is_driven_into_it,
        lists_leave_out_what_sleeps_or_is_static,
        particles_are_kept_off_planes,
        sleepers_near_a_cloth_wake_and_rest_with_it,
        ends_of_diagonals_are_kept_apart,
        weight_and_layers_take_more_substeps,
        diagonals_are_no_stiffer_in_short_substeps,
        parts_of_a_frame_share_its_substeps,
        a_pinned_cloth_takes_thirteen_substeps,
        substeps_are_as_many_as_what_comes_near_needs,
        parabola_is_exact_when_the_substep_changes,
        what_is_stretched_by_a_hundredth_is_counted,
        lists_hold_what_all_pairs_within_the_margin_hold,
        nothing_is_missed_while_a_cloth_falls,
        particle_leaves_a_static_box_by_its_thickness_and_a_third,
        pushes_between_cloth_and_movable_box_keep_momentum,
        particle_meets_a_movable_box_where_it_is_now,
        corner_lifts_a_triangle_by_its_weights,
        corner_that_comes_up_keeps_momentum,
        facets_at_a_small_box_are_listed,
        cloth_is_put_back_on_the_side_that_it_came_from,
        needle_does_not_pierce_a_cloth,
        link_lies_on_an_edge,
        NULL
    };
    return suite_run((suite){
        .name = "soft", .tests = tests, .set_up = set_up,
        .tear_down = tear_down, .seconds = 20
    });
}
