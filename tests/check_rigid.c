// check_rigid.c - whom do rigid bodies meet, and where?  Book: chapter 9.

#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "rigid.h"

// A few products of numbers near 1.
#define ROUNDING 1e-13

static const vec3 ZERO = { 0, 0, 0 }, UP = { 0, 1, 0 };

static world w;
static shape box, slab, ball, rope;

// The tests of what any rigid body does are run twice: with four particles a
// body, and with one at every vertex.
enum { MODELS = 2, MOST = 100 };

static world_options ours(int model)
{
    return model ? world_options_vertices() : world_options_default();
}

static void begin(world_options o)
{
    world_free(&w);
    ck_assert(world_init(&w, o).ok);
}

static unsigned long long seed;

// Numbers in [-1, 1) from a linear congruence; the same on every machine.
static real any(void)
{
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return (real)(seed >> 11) / 4503599627370496.0 - 1;
}

static vec3 any_vec3(void)
{
    real x = any(), y = any();
    return vec3_make(x, y, any());
}

static vec3 any_unit(void)
{
    vec3 d = any_vec3();
    real length = vec3_length(d);
    return length > 0.1 && length < 1 ? vec3_scale(1 / length, d) : any_unit();
}

static void set_up(void)
{
    seed = 3;
    ck_assert(shape_box(&box, vec3_make(1, 1, 1), 1).ok);
    ck_assert(shape_box(&slab, vec3_make(4, 0.5, 4), 8).ok);
    ck_assert(shape_icosahedron(&ball, 0.5, 2).ok);
    ck_assert(shape_rope(&rope, 5, 1, 1).ok);
}

static void tear_down(void)
{
    world_free(&w);
    shape_free(&box);
    shape_free(&slab);
    shape_free(&ball);
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

static int add_nailed(const shape *s, real x, real y, real z)
{
    placement p = placement_at(vec3_make(x, y, z));
    p.nailed = 1;
    return add(s, p);
}

static placement anywhere(real far, real fast, real quick)
{
    placement p = placement_at(vec3_scale(far, any_vec3()));
    p.x = any_unit();
    p.y = vec3_unit(vec3_cross(p.x, any_unit()));
    p.z = vec3_cross(p.x, p.y);
    p.velocity = vec3_scale(fast, any_vec3());
    p.spin = vec3_scale(quick, any_vec3());
    return p;
}

static void ready(void)
{
    ck_assert(world_begin(&w).ok);
}

// As the step begins a frame.
static void find(void)
{
    w.report = (step_report){ .substeps = w.options.substeps };
    rest_begin(&w.rest);
    rigid_find_pairs(&w);
    rigid_find_contacts(&w);
}

static void integrate(void)
{
    real h = w.options.dt / w.options.substeps;
    for (int b = 0; b < w.bodies; b++)
        if (body_moves(&w, b))
            verlet_step(w.pool.at + w.body[b].first,
                        body_particles(&w.body[b]), w.options.gravity, NULL, h);
}

static void relax(void)
{
    for (int b = 0; b < w.bodies; b++) {
        const body *x = &w.body[b];
        particle *p = w.pool.at + x->first;
        if (!body_moves(&w, b)) continue;
        if (x->four) four_relax(x->four, p, 6, w.options.relax);
        else sticks_relax(x->plan->stick, x->plan->sticks, p,
                          x->plan->particles, 6, w.options.relax, w.of.before);
    }
}

// A whole frame without its end.
static void frame(void)
{
    real h = w.options.dt / w.options.substeps;
    find();
    for (int k = 0; k < w.options.substeps; k++) {
        integrate();
        if (k > 0) rigid_find_again(&w, k);
        rigid_separate(&w, h);
        relax();
        rigid_bounce(&w, h);
    }
    rigid_remember(&w);
}

// Contacts of either kind.
static int contacts(void)
{
    return w.contacts + w.pushes;
}

static int is_pair(const int of[2], int a, int b)
{
    return (of[0] == a && of[1] == b) || (of[0] == b && of[1] == a);
}

// Did the two push each other in this frame?
static int pushes(int a, int b)
{
    int sum = 0;
    for (int k = 0; k < w.contacts; k++)
        sum += is_pair(w.between[k], a, b) && w.contact[k].pushed > 0;
    for (int k = 0; k < w.pushes; k++)
        sum += is_pair(w.pushed[k], a, b) && w.push[k].pushed[NORMAL] > 0;
    return sum > 0;
}

static void near_real(real got, real wanted, real error)
{
    ck_assert_msg(fabs(got - wanted) <= error, "got %.17g, wanted %.17g",
                  got, wanted);
}

static void near_vec3(vec3 got, vec3 wanted, real error)
{
    ck_assert_msg(vec3_distance(got, wanted) <= error,
                  "got (%.17g, %.17g, %.17g), wanted (%.17g, %.17g, %.17g)",
                  got.x, got.y, got.z, wanted.x, wanted.y, wanted.z);
}

// --- contacts that remember --------------------------------------------------

static vec3 point_of(const push_side *s)
{
    vec3 sum = ZERO;
    for (int k = 0; k < s->count; k++)
        sum = vec3_add_scaled(sum, s->share[k],
                              w.pool.at[s->first + k].position);
    return sum;
}

static feature_point any_feature(int count, int vertices)
{
    feature_point f = { .count = count };
    real sum = 0;
    for (int v = 0; v < count; v++) {
        f.vertex[v] = (int)((any() + 1) / 2 * (vertices / count))
                    + v * (vertices / count);
        f.weight[v] = 0.1 + (any() + 1) / 2;
        sum += f.weight[v];
    }
    for (int v = 0; v < count; v++) f.weight[v] /= sum;
    return f;
}

static vec3 feature_of(int b, const feature_point *f)
{
    vec3 at[MOST], sum = ZERO;
    world_vertices(&w, &w.body[b], at);
    for (int v = 0; v < f->count; v++)
        sum = vec3_add_scaled(sum, f->weight[v], at[f->vertex[v]]);
    return sum;
}

// Rejects: weights of one vertex where there are three; those of the other
// body; the plan's place instead of the body's.
START_TEST(push_has_the_points_of_its_contact)
{
    begin(world_options_default());
    int a = add(&ball, anywhere(3, 5, 5)), b = add(&box, anywhere(3, 5, 5));
    placement still = anywhere(3, 0, 0);
    still.nailed = 1;
    int c = add(&ball, still), r = add_at(&rope, 0, 9, 0);
    ready();
    for (int n = 0; n < 200; n++) {
        int rigid = n % 2 ? b : c;
        contact x = { .normal = any_unit(), .thickness = 0.1 + any() / 20,
                      .fixed = any_vec3() };
        x.a = any_feature(1 + n % 3, 12);
        x.b = any_feature(1 + n / 3 % 3, n % 2 ? 8 : 12);
        push p = rigid_push(&w, &x, a, rigid);
        near_vec3(point_of(&p.a), feature_of(a, &x.a), ROUNDING * 10);
        near_vec3(point_of(&p.b), feature_of(rigid, &x.b), ROUNDING * 10);
        near_vec3(p.along[NORMAL], x.normal, 0);
        ck_assert(p.thickness == x.thickness && p.a.ways == &w.ways[a]);
        for (int d = 0; d < DIRECTIONS; d++) ck_assert(p.pushed[d] == 0);
        ck_assert(!p.ready && p.worn == 0);
        // A plane is nobody: its point is fixed.
        x.b.count = 0;
        p = rigid_push(&w, &x, a, -1);
        ck_assert_int_eq(p.b.count, 0);
        near_vec3(p.fixed, x.fixed, 0);
        // A deformable body touches with one particle, numbered in the pool.
        x.a = (feature_point){ 1, { w.body[r].first + n % 6 }, { 1 } };
        p = rigid_push(&w, &x, r, a);
        ck_assert(p.a.count == 1 && p.a.ways == NULL && p.a.share[0] == 1);
        ck_assert_int_eq(p.a.first, w.body[r].first + n % 6);
    }
}
END_TEST

// Less than a twelfth of the speed of a fall through the shortest stick.
START_TEST(speed_of_rest_is_that_of_a_small_fall)
{
    begin(ours(_i));
    int a = add_at(&box, 0, 0, 0), b = add_at(&slab, 0, 9, 0);
    near_real(rigid_rest_speed(&w, &w.body[a]), sqrt(2 * 9.81) / 12, ROUNDING);
    near_real(rigid_rest_speed(&w, &w.body[b]), sqrt(9.81) / 12, ROUNDING);
    w.options.gravity = ZERO;
    ck_assert(rigid_rest_speed(&w, &w.body[a]) == 0);
}
END_TEST

// --- how far they go ---------------------------------------------------------

// Where a particle was tells its speed half a substep ago.
// Rejects: a way in metres a substep; a spin that moves the middle; gravity, or
// the hundredth of a radius, left out; a turn of the four particles instead of
// the corners'.
START_TEST(way_and_turn_are_those_of_a_frame)
{
    const vec3 spin[] = { { 0, 0, 0 }, { 0, 0, 3 } };
    for (int k = 0; k < 2; k++) {
        begin(ours(_i));
        placement p = placement_at(vec3_make(1, 2, 3));
        p.velocity = vec3_make(3, -4, 12);
        p.spin = spin[k];
        int b = add(&box, p);
        ready();
        rigid_look_ahead(&w, &w.body[b]);
        real dt = w.options.dt, h = w.age, g = 9.81;
        vec3 way = vec3_make(3 * dt, -4 * dt + g * dt * h / 2, 12 * dt);
        near_vec3(w.body[b].way, way, ROUNDING * 10);
        real least = g * dt * dt / 2 + box.radius / 100;
        real corners = 3 * sqrt(0.5) * dt * k;
        near_real(w.body[b].turn, least + corners, ROUNDING * 10);
        near_real(w.body[b].reach, vec3_length(way) + w.body[b].turn,
                  ROUNDING * 10);
    }
}
END_TEST

// Rejects: a look at where they are instead of at the way between; a way of one
// instead of the difference; a line that goes on beyond its end; what they turn
// left out.
START_TEST(who_flies_into_whom)
{
    const struct { vec3 from, v; real spin; int into; } shot[] = {
        { { -3, 0, 0 }, { 600, 0, 0 }, 0, 1 },      // 10 m a frame
        { { -3, 0, 0 }, { -600, 0, 0 }, 0, 0 },
        { { -3, 0, 1.3 }, { 600, 0, 0 }, 0, 1 },    // balls of 0.87 and 0.5
        { { -3, 0, 1.6 }, { 600, 0, 0 }, 0, 0 },
        { { -3, 0, 1.6 }, { 600, 0, 0 }, 30, 1 },   // they may turn together
        { { -3, 0, 0 }, { 60, 0, 0 }, 0, 0 },       // 1 m: not there yet
        { { -3, 0, 0 }, { 115, 0, 0 }, 0, 1 },
        { { -1.2, 0, 0 }, { 20, 0, 0 }, 0, 0 },     // too slow to be lost
        { { -3, 0, -3 }, { 600, 0, 600 }, 0, 1 },
    };
    for (size_t k = 0; k < sizeof shot / sizeof *shot; k++)
        for (int swept = 0; swept < 2; swept++) {
            world_options o = ours(_i);
            o.gravity = ZERO;
            o.swept = swept;
            begin(o);
            // Seen from each other: half of it each.
            placement p = placement_at(shot[k].from), q = placement_at(ZERO);
            p.velocity = vec3_scale(0.5, shot[k].v);
            q.velocity = vec3_scale(-0.5, shot[k].v);
            q.spin = vec3_make(0, shot[k].spin, 0);
            int a = add(&ball, p), b = add(&box, q);
            ready();
            find();
            int into = swept && shot[k].into;
            const body *x = &w.body[a], *y = &w.body[b];
            ck_assert_msg(rigid_flies_into(&w, x, y) == into, "shot %zu", k);
            ck_assert_int_eq(rigid_flies_into(&w, y, x), into);
        }
}
END_TEST

// --- who may meet whom -------------------------------------------------------

static real distance_of(int a, int b)
{
    vec3 at[2][12];
    point_set q[2];
    const int who[2] = { a, b };
    for (int k = 0; k < 2; k++) {
        const shape *s = w.body[who[k]].plan;
        world_vertices(&w, &w.body[who[k]], at[k]);
        q[k] = (point_set){ at[k], s->particles, s->ring_start, s->ring };
    }
    gjk_result g = gjk_distance(q[0], q[1], gjk_options_default(), NULL);
    return g.status == GJK_OVERLAP ? 0 : g.distance;
}

static int is_listed(int a, int b)
{
    for (int k = 0; k < w.pairs; k++)
        if (w.pair[k].a == a && w.pair[k].b == b) return 1;
    return 0;
}

// Bodies fly and turn through each other for a frame: whoever touches has been
// listed, and has contacts.
// Rejects: a reach by the centre's way alone; by the four particles' instead of
// the vertices' they carry; a spin, or gravity, left out.
START_TEST(whoever_meets_in_a_frame_was_listed_before)
{
    enum { BODIES = 10 };
    int met = 0, listed = 0;
    real further = 0;
    for (int n = 0; n < 60; n++) {
        world_options o = ours(_i);
        o.pairs = n % 2 ? PAIRS_ALL : PAIRS_SORTED;
        begin(o);
        for (int b = 0; b < BODIES; b++)
            add(b % 2 ? &ball : &box, anywhere(2.5, 20, 30));
        ready();
        find();
        ck_assert_int_eq(w.report.dropped, 0);
        ck_assert_int_eq(w.report.pairs, w.pairs);
        for (int k = 1; k < w.pairs; k++)
            ck_assert(w.pair[k - 1].a < w.pair[k].a
                      || (w.pair[k - 1].a == w.pair[k].a
                          && w.pair[k - 1].b < w.pair[k].b));
        listed += w.pairs;
        vec3 from[BODIES][12], now[12];
        for (int b = 0; b < BODIES; b++)
            world_vertices(&w, &w.body[b], from[b]);
        for (int k = 0; k < o.substeps; k++) {
            integrate();
            relax();
            for (int a = 0; a < BODIES; a++)
                for (int b = a + 1; b < BODIES; b++) {
                    real apart = w.body[a].thickness + w.body[b].thickness;
                    if (distance_of(a, b) > apart) continue;
                    met++;
                    ck_assert_msg(is_listed(a, b), "(%d, %d) meet unlisted", a,
                                  b);
                }
        }
        // Nobody went further than his reach.
        for (int b = 0; b < BODIES; b++) {
            world_vertices(&w, &w.body[b], now);
            for (int i = 0; i < w.body[b].plan->particles; i++)
                further = fmax(further, vec3_distance(now[i], from[b][i])
                                        - w.body[b].reach);
        }
    }
    ck_assert_msg(further <= 0, "%g m further than its reach", further);
    ck_assert_int_gt(met, 300);
    ck_assert_int_lt(listed, 60 * BODIES * (BODIES - 1) / 2);
}
END_TEST

// Rejects: pairs of which neither moves; deformable bodies among rigid ones.
START_TEST(only_pairs_that_can_move_are_listed)
{
    begin(ours(_i));
    int a = add_nailed(&slab, 0, 0, 0), b = add_nailed(&slab, 0, 0.4, 0);
    int c = add_at(&box, 0, 1.1, 0), d = add_at(&box, 0.5, 1.8, 0);
    add_at(&rope, 0, 1, 0);
    int far = add_at(&box, 0, 30, 0);
    ready();
    find();
    ck_assert(!is_listed(a, b) && is_listed(b, c) && is_listed(c, d));
    ck_assert(!is_listed(d, far));
    for (int k = 0; k < w.pairs; k++) ck_assert(w.pair[k].b != 4);
    w.rest.asleep[c] = w.rest.asleep[d] = 1;
    w.rest.calm[far] = 1;
    find();
    ck_assert(!is_listed(b, c) && !is_listed(c, d));
    // Each alone is seen by who moves.
    w.rest.asleep[d] = 0;
    w.rest.calm[d] = 1;
    find();
    ck_assert(is_listed(c, d) && !is_listed(b, c));
}
END_TEST

// Rejects: a blow that is passed on to one who looks only as far as he himself
// goes.
START_TEST(who_is_near_a_quick_one_looks_as_far)
{
    world_options o = ours(_i);
    o.gravity = ZERO;
    begin(o);
    placement shot = placement_at(vec3_make(-1.05, 0, 0));
    shot.velocity = vec3_make(30, 0, 0);
    add(&box, shot);
    for (int k = 0; k < 3; k++) add_at(&box, 1.2 * k, 0, 0);
    ready();
    find();
    for (int k = 0; k < 3; k++) ck_assert(is_listed(k, k + 1));
    ck_assert(w.body[1].reach >= 30.0 / 60 && w.body[2].reach >= 30.0 / 60);
}
END_TEST

// --- waking ------------------------------------------------------------------

static void nap(int b, int island)
{
    w.rest.asleep[b] = 1;
    w.rest.island[b] = island;
    for (int i = 0; i < body_particles(&w.body[b]); i++)
        w.pool.at[w.body[b].first + i].inverse_mass = 0;
}

// Rejects: a sleeper that a calm one wakes, or a nailed one; one that wakes
// alone, or stays nailed when awake.
START_TEST(sleeper_wakes_for_the_quick_with_all_of_its_island)
{
    begin(ours(_i));
    int quick = add_at(&box, 0, 0, 0), a = add_at(&box, 3, 0, 0);
    int b = add_at(&box, 6, 0, 0), other = add_at(&box, 9, 0, 0);
    int nailed = add_nailed(&box, 12, 0, 0), calm = add_at(&box, 15, 0, 0);
    ready();
    nap(a, a);
    nap(b, a);
    nap(other, other);
    w.rest.calm[calm] = 0.1;
    ck_assert_int_eq(rigid_wake(&w, calm, a), 0);
    ck_assert_int_eq(rigid_wake(&w, a, nailed), 0);
    ck_assert_int_eq(rigid_wake(&w, a, b), 0);
    ck_assert_int_eq(rigid_wake(&w, quick, calm), 0);
    // What never moves is found to lie still, too.
    w.rest.asleep[nailed] = 1;
    ck_assert_int_eq(rigid_wake(&w, quick, nailed), 0);
    ck_assert(w.rest.asleep[nailed]);
    ck_assert(w.rest.asleep[a] && w.rest.asleep[b]);
    w.trusted = 5;
    ck_assert_int_eq(rigid_wake(&w, quick, b), 1);
    ck_assert(!w.rest.asleep[a] && !w.rest.asleep[b] && w.rest.asleep[other]);
    ck_assert_int_eq(w.trusted, -1);
    for (int i = 0; i < w.pool.count; i++) {
        int k = w.bodies - 1;
        while (w.body[k].first > i) k--;
        real wanted = k == other ? 0 : w.of.inverse_mass[i];
        ck_assert(w.pool.at[i].inverse_mass == wanted);
    }
    // In the other order.
    ck_assert_int_eq(rigid_wake(&w, other, quick), 1);
}
END_TEST

// Rejects: pairs of the woken that are listed a frame too late.
START_TEST(woken_take_part_in_the_same_frame)
{
    begin(ours(_i));
    placement shot = placement_at(vec3_make(-1.2, 0, 0));
    shot.velocity = vec3_make(20, 0, 0);
    int quick = add(&box, shot), a = add_at(&box, 0, 0, 0);
    int b = add_at(&box, 1.01, 0, 0);
    ready();
    nap(a, a);
    nap(b, a);
    find();
    ck_assert(!w.rest.asleep[a] && !w.rest.asleep[b]);
    ck_assert(is_listed(quick, a) && is_listed(a, b));
}
END_TEST

// --- where they touch --------------------------------------------------------

// Rejects: an immovable body that is A; contacts that keep no skin, or one skin
// of two; a normal into the body.
START_TEST(box_on_a_slab_touches_with_its_corners)
{
    for (int order = 0; order < 2; order++) {
        begin(ours(_i));
        int s = -1;
        if (!order) s = add_nailed(&slab, 0, 0, 0);
        int b = add_at(&box, 0.2, 0.76, 0.1);
        if (order) s = add_nailed(&slab, 0, 0, 0);
        ready();
        find();
        ck_assert_int_eq(contacts(), 4);
        real skins = w.body[s].thickness + w.body[b].thickness;
        for (int k = 0; k < 4; k++) {
            if (_i) {
                ck_assert(w.between[k][0] == b && w.between[k][1] == s);
                near_vec3(w.contact[k].normal, UP, ROUNDING);
                ck_assert(w.contact[k].thickness == skins);
                near_real(contact_gap(&w.contact[k], w.pool.at), 0.01 - skins,
                          ROUNDING);
            } else {
                const push *c = &w.push[k];
                near_vec3(c->along[NORMAL], UP, ROUNDING);
                ck_assert(c->thickness == skins);
                ck_assert_int_eq(c->a.first, w.body[b].first);
                vec3 on_b = c->b.count > 0 ? point_of(&c->b) : c->fixed;
                near_vec3(vec3_sub(point_of(&c->a), on_b),
                          vec3_make(0, 0.01, 0), ROUNDING * 10);
            }
        }
    }
}
END_TEST

// Rejects: planes that are met by particles that are no vertices; a corner that
// will touch before the frame ends, left out; one far away, kept.
START_TEST(corners_near_a_plane_are_contacts)
{
    begin(ours(_i));
    placement p = placement_at(vec3_make(0, 0.75, 0));
    p.velocity = vec3_make(0, -20, 0);
    add(&box, p);
    add_at(&box, 5, 2, 0);
    ck_assert(world_add_plane(&w, UP, 0).ok);
    ready();
    find();
    // 0.25 m high, it falls by a third of a metre in a frame.
    ck_assert_int_eq(contacts(), 4);
    for (int k = 0; k < 4; k++) {
        if (_i) {
            ck_assert(w.between[k][0] == 0 && w.between[k][1] == -1);
            continue;
        }
        ck_assert(w.pushed[k][0] == 0 && w.pushed[k][1] == w.bodies);
        near_real(point_of(&w.push[k].a).y, 0.25, ROUNDING);
        ck_assert_int_eq(w.push[k].b.count, 0);
    }
}
END_TEST

// Rejects: a write past the end; contacts that are lost without a word.
START_TEST(contacts_without_room_are_counted)
{
    world_options o = ours(_i);
    o.stay = 0;
    begin(o);
    add_at(&box, 0, 0.5, 0);
    add_at(&box, 0, 1.5, 0);
    ck_assert(world_add_plane(&w, UP, 0).ok);
    ready();
    find();
    int all = contacts();
    ck_assert_int_eq(w.report.dropped, 0);
    ck_assert_int_eq(all, 8);
    for (int room = 0; room < all; room++) {
        if (_i) w.contact_capacity = room;
        else    w.push_capacity = room;
        find();
        ck_assert_int_eq(contacts(), room);
        ck_assert_int_eq(w.report.dropped, all - room);
    }
    w.pair_capacity = 0;
    find();
    ck_assert_int_eq(w.pairs, 0);
    ck_assert_int_ge(w.report.dropped, 1);
}
END_TEST

// Rejects: a body that sinks a little in every frame; a push of one corner for
// all four.
START_TEST(separated_box_stands_on_its_skin)
{
    begin(ours(_i));
    int b = add_at(&box, 0, 0.5, 0);
    ck_assert(world_add_plane(&w, UP, 0).ok);
    ready();
    for (int f = 0; f < 240; f++) frame();
    vec3 at[8];
    world_vertices(&w, &w.body[b], at);
    real least = HUGE_VAL, skin = w.body[b].thickness;
    for (int i = 0; i < 8; i++) least = fmin(least, at[i].y);
    ck_assert_msg(least > 0 && least < 1.5 * skin, "at %g, skin %g", least,
                  skin);
    ck_assert_int_gt(w.report.contacts, 3);
    ck_assert(w.collided[b]);
}
END_TEST

// The small one shot at the slab, or the slab at the small one, nailed.
static void shoot(int model, int at_small)
{
    world_options o = ours(model);
    o.gravity = ZERO;
    begin(o);
    placement small = placement_at(vec3_make(0.2, 2, 0.1));
    placement large = placement_at(ZERO);
    small.nailed = at_small;
    large.nailed = !at_small;
    if (at_small) large.velocity = vec3_make(0, 300, 0);
    else          small.velocity = vec3_make(0, -300, 0);
    add(&ball, small);
    add(&slab, large);
    ready();
    find();
}

// A bullet of 300 m/s, 5 m a frame, from 2 m above a slab: it has one contact,
// there where it will touch.  Its middle keeps in front of the slab as well.
// Rejects: a guard that stands at the slab's middle, or keeps no inner radius
// away; a guard of what is nailed.
START_TEST(bullet_has_a_touch_and_a_guard)
{
    shoot(_i, 0);
    ck_assert_int_eq(contacts(), _i ? 1 : 2);
    if (_i) {
        near_vec3(w.contact[0].normal, UP, 1e-9);
    } else {
        const push *touch = &w.push[0], *guard = &w.push[1];
        near_vec3(touch->along[NORMAL], UP, 1e-9);
        near_vec3(guard->along[NORMAL], touch->along[NORMAL], 0);
        near_vec3(guard->fixed, touch->fixed, 0);
        real skins = w.body[0].thickness + w.body[1].thickness;
        near_real(touch->thickness, skins, 0);
        near_real(guard->thickness, skins + ball.inner, ROUNDING);
        near_vec3(point_of(&guard->a), vec3_make(0.2, 2, 0.1), ROUNDING * 10);
        ck_assert(point_of(&touch->a).y < 2 - ball.inner / 2);
    }
    shoot(_i, 1);
    ck_assert_int_eq(contacts(), 1);
}
END_TEST

// --- memory ------------------------------------------------------------------

// What the contacts of all but one body have pushed.
static vec3 pushed_but_by(int b)
{
    vec3 sum = ZERO;
    for (int k = 0; k < w.pushes; k++) {
        if (w.pushed[k][0] == b || w.pushed[k][1] == b) continue;
        for (int d = 0; d < DIRECTIONS; d++)
            sum = vec3_add_scaled(sum, w.push[k].pushed[d], w.push[k].along[d]);
    }
    return sum;
}

// Rejects: a memory of another pair, or of another point of this one; one that
// is lost where pairs come and go before it in the list.
START_TEST(new_contacts_begin_with_what_the_old_ones_pushed)
{
    for (int memory = 0; memory < 2; memory++) {
        world_options o = world_options_default();
        o.memory = memory;
        begin(o);
        add_nailed(&slab, 0, -0.25, 0);
        for (int k = 0; k < 3; k++) add_at(&box, 0.02 * k, 0.51 + 1.01 * k, 0);
        int passing = add_at(&ball, 9, 0.5, 0);
        add_at(&box, -1.8, 0.51, 0);
        ck_assert(world_add_plane(&w, UP, -2).ok);
        ready();
        for (int f = 0; f < 200; f++) frame();
        ck_assert_int_eq(w.report.pushing, w.memories);
        for (int k = 1; k < w.memories; k++) {
            const push_memory *m = &w.memory[k - 1], *n = &w.memory[k];
            int plane_m = m->b >= w.bodies, plane_n = n->b >= w.bodies;
            ck_assert(plane_m >= plane_n);
            if (plane_m == plane_n)
                ck_assert(m->a < n->a || (m->a == n->a && m->b <= n->b));
        }
        vec3 was = pushed_but_by(passing);
        ck_assert(was.y > 0);
        // The ball comes by: new pairs stand between the old ones.
        for (int i = 0; i < FOUR; i++) {
            particle *x = &w.pool.at[w.body[passing].first + i];
            x->position = x->previous = vec3_add(vec3_make(1.06, 0.5, 0),
                                                 w.body[passing].four->at[i]);
        }
        find();
        ck_assert(is_listed(1, passing));
        near_vec3(pushed_but_by(passing), memory ? was : ZERO, 1e-3 * was.y);
    }
}
END_TEST

// A pile of three lies still: its contacts of the last frame are those of this
// one.  One box moves, a little or more.
// Rejects: contacts that stay when their body has gone; the ones of a neighbour
// that nobody touches thrown away with them; a push that is lost, or begins
// anew; a list of pairs that misses whoever comes near.
START_TEST(who_lies_where_he_lay_keeps_his_contacts)
{
    const struct { real by; int stays; } way[] = { { 0.0005, 1 }, { 0.01, 0 } };
    for (int k = 0; k < 2; k++) {
        begin(world_options_default());
        w.options.resting = 0;
        for (int b = 0; b < 3; b++) add_at(&box, 0, 0.505 + 1.01 * b, 0);
        int far = add_at(&box, 5, 0.505, 0);
        ck_assert(world_add_plane(&w, UP, 0).ok);
        ready();
        for (int f = 0; f < 120; f++) frame();
        find();
        int all = w.pushes;
        vec3 was = w.push[0].along[ACROSS], at = point_of(&w.push[0].a);
        real load = w.push[0].pushed[NORMAL];
        ck_assert(load > 0);
        for (int b = 0; b <= far; b++) ck_assert(!w.fresh[b]);
        for (int i = 0; i < FOUR; i++) {
            particle *x = &w.pool.at[w.body[0].first + i];
            real by = way[k].by * box.radius;
            x->position.x += by;
            x->previous.x += by;
        }
        find();
        ck_assert_int_eq(w.fresh[0], !way[k].stays);
        ck_assert(!w.fresh[1] && !w.fresh[2] && !w.fresh[far]);
        ck_assert_int_eq(w.pushes, all);
        // Found anew, nobody has needed it yet.
        for (int i = 0; i < all; i++) {
            int moved = w.pushed[i][0] == 0 && !way[k].stays;
            if (w.push[i].pushed[NORMAL] > 0)
                ck_assert_int_eq(w.push[i].ready, !moved);
        }
        near_real(w.push[0].pushed[NORMAL], load, 1e-9 * load);
        near_vec3(w.push[0].along[ACROSS], was, ROUNDING);
        near_vec3(point_of(&w.push[0].a), at, 0.011 * box.radius);
        ck_assert(is_listed(0, 1) && is_listed(1, 2) && !is_listed(0, 2));
    }
}
END_TEST

// Two boxes lie still, and one of them is moved: the contacts of the other
// would stay, but there is no room.  Rejects: a write past the end.
START_TEST(contacts_that_stay_without_room_are_counted)
{
    begin(world_options_default());
    w.options.resting = 0;
    add_at(&box, 0, 0.505, 0);
    add_at(&box, 5, 0.505, 0);
    ck_assert(world_add_plane(&w, UP, 0).ok);
    ready();
    for (int f = 0; f < 120; f++) frame();
    for (int i = 0; i < FOUR; i++)
        w.pool.at[w.body[0].first + i].position.x += 0.01;
    w.push_capacity = 6;
    find();
    ck_assert(w.fresh[0] && !w.fresh[1]);
    ck_assert_int_eq(w.pushes, 4);
    ck_assert_int_eq(w.report.dropped, 4);
}
END_TEST

// Rejects: a gap, or a push, that is that of another frame.
START_TEST(pile_stands_alike_whether_contacts_stay_or_not)
{
    vec3 top[2];
    for (int k = 0; k < 2; k++) {
        world_options o = world_options_default();
        o.stay = k ? 0.001 : 0;
        o.resting = 0;
        begin(o);
        for (int b = 0; b < 3; b++)
            add_at(&box, 0.1 * b, 0.505 + 1.01 * b, -0.05 * b);
        ck_assert(world_add_plane(&w, UP, 0).ok);
        ready();
        for (int f = 0; f < 240; f++) frame();
        top[k] = w.pool.at[w.body[2].first].position;
        real load = 0;
        for (int i = 0; i < w.pushes && w.pushed[i][1] >= w.bodies; i++)
            load += w.push[i].pushed[NORMAL];
        real weight = 3 * w.body[0].mass * 9.81 * w.age * w.age;
        near_real(load, weight, 1e-3 * weight);
    }
    near_vec3(top[0], top[1], 0.002);
}
END_TEST

// Rejects: a memory that goes to a point far from its own, or to all of them.
START_TEST(memory_goes_to_the_point_that_it_is_of)
{
    world_options o = world_options_default();
    o.stay = 0;
    begin(o);
    add_nailed(&slab, 0, -0.25, 0);
    add_at(&box, 0.1, 0.505, 0.2);
    ready();
    for (int kept = 0; kept < 4; kept++) {
        find();
        ck_assert_int_eq(w.pushes, 4);
        vec3 at = point_of(&w.push[kept].a);
        w.memory[0] = push_remember(&w.push[kept], 0, 1, w.age);
        w.memory[0].force = UP;
        w.memories = 1;
        find();
        ck_assert_int_eq(w.pushes, 4);
        for (int k = 0; k < 4; k++) {
            int same = vec3_distance(point_of(&w.push[k].a), at) < 0.1;
            near_real(w.push[k].pushed[NORMAL], same * w.age * w.age, ROUNDING);
        }
        // Another pair's, or a plane's, is nobody's here.
        w.memory[0].b = 2;
        w.memories = 1;
        find();
        for (int k = 0; k < 4; k++) ck_assert(w.push[k].pushed[NORMAL] == 0);
    }
}
END_TEST

// Four contacts leave what they pushed, as lasting ones or as those of a quick
// pair; one is found again.
// Rejects: a load that nobody bears, for its contact is gone; one that is taken
// over twice; a run of memories that nobody looks into.
START_TEST(every_memory_is_handed_over_once)
{
    world_options o = world_options_default();
    o.stay = 0;
    begin(o);
    add_nailed(&slab, 0, -0.25, 0);
    add_at(&box, 0.1, 0.505, 0.2);
    ready();
    for (int lasting = 0; lasting <= 4; lasting++) {
        w.options.manifold = 1;
        w.memories = w.lasting_memories = 0;
        find();
        ck_assert_int_eq(w.pushes, 4);
        for (int k = 0; k < 4; k++) {
            w.memory[k] = push_remember(&w.push[k], 0, 1, w.age);
            w.memory[k].force = vec3_scale(k + 1, UP);
        }
        for (int manifold = 1; manifold >= 0; manifold--) {
            w.options.manifold = manifold;
            w.memories = 4;
            w.lasting_memories = lasting;
            find();
            ck_assert_int_eq(w.pushes, manifold ? 4 : 1);
            real sum = 0;
            for (int k = 0; k < w.pushes; k++) sum += w.push[k].pushed[NORMAL];
            near_real(sum, 10 * w.age * w.age, ROUNDING);
        }
    }
}
END_TEST

// Rejects: bodies that lie on each other asleep apart; nailed ones that join
// what stands on them; neighbours that are near and do not push.
START_TEST(bodies_that_push_each_other_are_one_island)
{
    begin(ours(_i));
    int s = add_nailed(&slab, 0, -0.25, 0);
    // Not in each other's skin: of that, vertices make a leap.
    int a = add_at(&box, 0, 0.52, 0), b = add_at(&box, 0, 1.56, 0);
    int c = add_at(&box, _i ? -1.5 : -1.02, 0.52, 0);
    ready();
    // Of vertices, a stack does not stand for ever, and what lies on another
    // leaps and does not push it in every frame.
    int frames = _i ? 0 : 600, all = 0;
    for (int f = 0; f < 600 && (f < frames || !all); f++) {
        frame();
        all = pushes(a, b) && w.collided[a] && w.collided[c];
    }
    // (Every frame looks a little beyond the skins.)
    if (_i == 0) ck_assert_int_ge(contacts(), 16);
    char still[4] = { 1, 1, 1, 1 };
    rest_end(&w.rest, still, 1, 0.5);
    ck_assert(w.rest.asleep[a] && w.rest.asleep[b] && w.rest.asleep[c]);
    ck_assert_int_eq(w.rest.island[a], w.rest.island[b]);
    ck_assert_int_ne(w.rest.island[a], w.rest.island[c]);
    ck_assert(w.collided[a] && w.collided[b] && w.collided[c]);
    ck_assert(body_is_nailed(&w.body[s]));
}
END_TEST

// In the first of four substeps, in the second of eight.
// Rejects: contacts that are kept where they change, or found anew in each of
// many substeps; those of slow pairs and of planes thrown away with them.
START_TEST(quick_pairs_are_looked_at_again)
{
    begin(ours(_i));
    placement p = placement_at(vec3_make(0, 1.2, 0));
    p.velocity = vec3_make(0, -25, 0);
    p.spin = vec3_make(0, 0, 20);
    add(&box, p);
    add_nailed(&slab, 0, 0.25, 0);
    int calm = add_at(&box, 5, -1.5, 0);
    ck_assert(world_add_plane(&w, UP, -2).ok);
    ready();
    find();
    ck_assert_int_gt(contacts(), 4);
    vec3 point[MOST][2];
    for (int k = 1; k < 3; k++) {
        for (int again = 0; again < 2; again++) {
            for (int i = 0; i < contacts(); i++)
                point[i][again] = _i ? feature_now(w.contact[i].a, w.pool.at)
                                     : point_of(&w.push[i].a);
            if (again) break;
            integrate();
            relax();
            for (int i = 0; i < contacts(); i++)
                point[i][0] = _i ? feature_now(w.contact[i].a, w.pool.at)
                                 : point_of(&w.push[i].a);
            rigid_find_again(&w, k);
        }
        int calms = 0, changed = 0;
        for (int i = 0; i < contacts(); i++) {
            int who = _i ? w.between[i][0] : w.pushed[i][0];
            real moved = vec3_distance(point[i][0], point[i][1]);
            calms += who == calm;
            if (who == calm) ck_assert(moved == 0);
            else             changed |= moved > 0.01;
        }
        ck_assert_int_eq(calms, 4);
        ck_assert_int_eq(changed, k == (_i == 0 ? 1 : 2));
    }
}
END_TEST

// Rejects: NaN that meets everybody.
START_TEST(lost_body_touches_nobody)
{
    begin(ours(_i));
    int a = add_at(&ball, 0, 0.5, 0), b = add_at(&ball, 0.9, 0.5, 0);
    int c = add_at(&box, 5, 0.5, 0);
    ck_assert(world_add_plane(&w, UP, 0).ok);
    ready();
    w.pool.at[w.body[a].first + 2].position.x = (real)NAN;
    for (int f = 0; f < 10; f++) frame();
    const int fine[2] = { b, c };
    for (int k = 0; k < 2; k++) {
        const body *x = &w.body[fine[k]];
        for (int i = x->first; i < x->first + body_particles(x); i++)
            ck_assert(vec3_is_finite(w.pool.at[i].position));
    }
}
END_TEST

int main(void)
{
    const TTest *const once[] = {
        push_has_the_points_of_its_contact,
        new_contacts_begin_with_what_the_old_ones_pushed,
        who_lies_where_he_lay_keeps_his_contacts,
        contacts_that_stay_without_room_are_counted,
        pile_stands_alike_whether_contacts_stay_or_not,
        memory_goes_to_the_point_that_it_is_of,
        every_memory_is_handed_over_once,
    };
    const TTest *const both[] = {
        speed_of_rest_is_that_of_a_small_fall,
        way_and_turn_are_those_of_a_frame,
        who_flies_into_whom,
        whoever_meets_in_a_frame_was_listed_before,
        only_pairs_that_can_move_are_listed,
        who_is_near_a_quick_one_looks_as_far,
        sleeper_wakes_for_the_quick_with_all_of_its_island,
        woken_take_part_in_the_same_frame,
        box_on_a_slab_touches_with_its_corners,
        corners_near_a_plane_are_contacts,
        contacts_without_room_are_counted,
        separated_box_stands_on_its_skin,
        bullet_has_a_touch_and_a_guard,
        bodies_that_push_each_other_are_one_island,
        quick_pairs_are_looked_at_again,
        lost_body_touches_nobody,
    };
    Suite *s = suite_create("rigid");
    TCase *t = tcase_create("rigid");
    tcase_add_checked_fixture(t, set_up, tear_down);
    for (size_t i = 0; i < sizeof once / sizeof *once; i++)
        tcase_add_test(t, once[i]);
    for (size_t i = 0; i < sizeof both / sizeof *both; i++)
        tcase_add_loop_test(t, both[i], 0, MODELS);
    suite_add_tcase(s, t);
    SRunner *runner = srunner_create(s);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
