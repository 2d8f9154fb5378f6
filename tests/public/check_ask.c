// check_ask.c - tests of lib/tumble.h: what is where, and who touches whom?

#include "tumble.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <math.h>
#include <string.h>

static const unsigned ALL = ~0u;
static const double fine = 1e-9;

static void near(double got, double wanted, double tolerance)
{
    ck_assert_msg(fabs(got - wanted) <= tolerance, "got %.17g, wanted %.17g",
                  got, wanted);
}

static void near_vec3(tumble_vec3 got, double x, double y, double z)
{
    near(got.x, x, fine);
    near(got.y, y, fine);
    near(got.z, z, fine);
}

static tumble_pose at(double x, double y, double z)
{
    return (tumble_pose){ { x, y, z }, { 0, 0, 0, 1 } };
}

static tumble_pose turned(double x, double y, double z, double angle)
{
    tumble_pose p = at(x, y, z);
    p.rotation = tumble_quat_turn(tumble_v(0, 0, 1), angle);
    return p;
}

static tumble_body add_static(tumble_world *w, tumble_shape s, tumble_pose p,
                              unsigned group)
{
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.kind = TUMBLE_STATIC;
    o.pose = p;
    o.group = group;
    return tumble_body_add(w, s, o);
}

static tumble_world *empty(void)
{
    tumble_world *w = tumble_world_make(NULL);
    ck_assert_ptr_nonnull(w);
    return w;
}

// --- What is where -----------------------------------------------------------

// Two boxes in a row, of groups 1 and 2: who leaves out the first meets the other.
START_TEST(a_question_asks_only_the_groups_that_it_names)
{
    tumble_world *w = empty();
    tumble_shape box = tumble_shape_box(w, tumble_v(1, 1, 1), 1);
    tumble_body first = add_static(w, box, at(0, 0, 0), 1);
    tumble_body second = add_static(w, box, at(3, 0, 0), 2);
    const tumble_body wanted[4] = { { 0, 0 }, first, second, first };
    for (unsigned mask = 0; mask < 4; mask++) {
        tumble_hit h[3] = { { .fraction = 7 } };
        tumble_body met[2] = { { 0, 0 }, { 0, 0 } };
        bool any = mask > 0;
        tumble_vec3 from = tumble_v(-2, 0, 0), to = tumble_v(8, 0, 0);
        ck_assert(tumble_world_ray(w, from, to, mask, &h[0]) == any);
        ck_assert(tumble_world_sweep(w, box, at(-2, 0, 0), to, mask, &h[1])
                  == any);
        ck_assert(tumble_world_nearest(w, from, 9, mask, &h[2]) == any);
        int n = tumble_world_overlap(w, box, at(1.5, 0, 0), mask, met, 2);
        ck_assert_int_eq(n, 0);
        tumble_shape rod = tumble_shape_box(w, tumble_v(4, 1, 1), 1);
        n = tumble_world_overlap(w, rod, at(1.5, 0, 0), mask, met, 2);
        ck_assert_int_eq(n, (int)(mask % 2 + mask / 2));
        if (!any) continue;
        for (int k = 0; k < 3; k++)
            ck_assert(tumble_body_is_same(h[k].body, wanted[mask]));
        ck_assert(tumble_body_is_same(met[0], wanted[mask]));
        near(h[0].fraction, mask == 2 ? 0.45 : 0.15, fine);
    }
    tumble_world_free(w);
}
END_TEST

// A rod of 4 m that is turned by 30 degrees has its end at 2 (cos, sin).
// Rejects: a pose that is taken without its rotation, or turned the other way.
START_TEST(a_shape_is_asked_as_it_is_turned)
{
    tumble_world *w = empty();
    const double pi = acos(-1), c = 1.8 * cos(pi / 6), s = 1.8 * sin(pi / 6);
    tumble_shape rod = tumble_shape_box(w, tumble_v(4, 0.2, 0.2), 1);
    tumble_shape ball = tumble_shape_sphere(w, 0.1, 1);
    tumble_body up = add_static(w, ball, at(c, s, 0), 1);
    tumble_body down = add_static(w, ball, at(c, -s, 0), 2);
    tumble_body met;
    tumble_hit h;
    for (int k = -1; k <= 1; k += 2) {
        tumble_pose p = turned(0, 0, 0, k * pi / 6);
        ck_assert_int_eq(tumble_world_overlap(w, rod, p, ALL, &met, 1), 1);
        ck_assert(tumble_body_is_same(met, k > 0 ? up : down));
        p.position.x = -1;
        ck_assert(tumble_world_sweep(w, rod, p, tumble_v(2, 0, 0), ALL, &h));
        ck_assert(tumble_body_is_same(h.body, k > 0 ? up : down));
    }
    // Of the body that stands there, too: its upper side is hit from above.
    tumble_body_remove(w, up);
    tumble_body_remove(w, down);
    add_static(w, rod, turned(0, 0, 0, pi / 6), 1);
    ck_assert(tumble_world_ray(w, tumble_v(1, 5, 0), tumble_v(1, -5, 0), ALL,
                               &h));
    near_vec3(h.normal, -sin(pi / 6), cos(pi / 6), 0);
    near_vec3(h.point, 1, tan(pi / 6) + 0.1 / cos(pi / 6), 0);
    tumble_world_free(w);
}
END_TEST

// Radii .5 and .3, the centres .48 off: they touch .64 before they are abreast.
START_TEST(balls_and_capsules_are_met_at_their_radius)
{
    tumble_world *w = empty();
    tumble_shape big = tumble_shape_sphere(w, 0.5, 1);
    tumble_shape small = tumble_shape_sphere(w, 0.3, 1);
    tumble_shape rod = tumble_shape_capsule(w, 2, 0.5, 1);
    tumble_body ball = add_static(w, big, at(0, 2, 0), 1);
    tumble_body capsule = add_static(w, rod, turned(0, -2, 0, acos(0)), 1);
    tumble_hit h;
    ck_assert(tumble_world_ray(w, tumble_v(-3, 2.3, 0), tumble_v(1, 2.3, 0),
                               ALL, &h));
    ck_assert(tumble_body_is_same(h.body, ball));
    near_vec3(h.point, -0.4, 2.3, 0);
    near_vec3(h.normal, -0.8, 0.6, 0);
    near(h.fraction, 0.65, fine);
    ck_assert(tumble_world_sweep(w, small, at(-2.64, 2.48, 0),
                                 tumble_v(4, 0, 0), ALL, &h));
    near(h.fraction, 0.5, fine);
    near_vec3(h.normal, -0.8, 0.6, 0);
    near_vec3(h.point, -0.4, 2.3, 0);
    ck_assert(tumble_world_nearest(w, tumble_v(3, 6, 0), 5, ALL, &h));
    near(h.fraction, 4.5, fine);
    near_vec3(h.point, 0.3, 2.4, 0);
    near_vec3(h.normal, 0.6, 0.8, 0);
    ck_assert(!tumble_world_nearest(w, tumble_v(3, 6, 0), 4.4, ALL, &h));
    // The capsule lies along x: its end is a ball about (1, -2, 0).
    ck_assert(tumble_world_ray(w, tumble_v(1.3, 0, 0), tumble_v(1.3, -4, 0),
                               ALL, &h));
    ck_assert(tumble_body_is_same(h.body, capsule));
    near_vec3(h.point, 1.3, -1.6, 0);
    for (int k = 0; k < 2; k++) {
        double away = k ? 0.801 : 0.799;
        ck_assert_int_eq(tumble_world_overlap(w, small, at(0, 2 + away, 0), ALL,
                                              NULL, 0), !k);
        ck_assert_int_eq(tumble_world_overlap(w, small, at(1 + away, -2, 0),
                                              ALL, NULL, 0), !k);
    }
    tumble_world_free(w);
}
END_TEST

START_TEST(what_begins_inside_meets_at_once)
{
    tumble_world *w = empty();
    tumble_shape box = tumble_shape_box(w, tumble_v(2, 2, 2), 1);
    tumble_body b = add_static(w, box, at(0, 0, 0), 1);
    tumble_hit h;
    ck_assert(tumble_world_ray(w, tumble_v(0.3, 0, 0), tumble_v(9, 0, 0), ALL,
                               &h));
    ck_assert(tumble_body_is_same(h.body, b) && h.fraction == 0);
    ck_assert(tumble_world_nearest(w, tumble_v(0.3, 0.2, 0), 1, ALL, &h));
    ck_assert(tumble_body_is_same(h.body, b) && h.fraction == 0);
    near_vec3(h.point, 0.3, 0.2, 0);
    ck_assert(!tumble_world_ray(w, tumble_v(3, 0, 0), tumble_v(9, 0, 0), ALL,
                                &h));
    tumble_world_free(w);
}
END_TEST

// A body of three pieces, of which each is found, and two boxes beside it.
// Rejects: a body told once for every piece; more than there is room for.
START_TEST(pieces_that_overlap_are_one_body)
{
    tumble_world *w = empty();
    tumble_shape box = tumble_shape_box(w, tumble_v(1, 1, 1), 1);
    const tumble_shape piece[3] = { box, box, box };
    const tumble_pose where[3] = { at(0, 0, 0), at(2, 0, 0), at(4, 0, 0) };
    tumble_body stage = tumble_body_add_pieces(w, piece, where, 3,
                                               tumble_body_at(0, 0, 0));
    tumble_body met[3];
    for (int k = 0; k < 3; k++) {
        tumble_pose p = at(2 * k, 0.9, 0);
        ck_assert_int_eq(tumble_world_overlap(w, box, p, ALL, met, 3), 1);
        ck_assert(tumble_body_is_same(met[0], stage));
    }
    tumble_shape rod = tumble_shape_box(w, tumble_v(9, 1, 1), 1);
    ck_assert_int_eq(tumble_world_overlap(w, rod, at(2, 0.9, 0), ALL, met, 3),
                     1);
    tumble_body_add(w, box, tumble_body_at(0, 1.5, 0));
    tumble_body_add(w, box, tumble_body_at(2, 1.5, 0));
    memset(met, 77, sizeof met);
    tumble_body untouched = met[2];
    ck_assert_int_eq(tumble_world_overlap(w, rod, at(2, 0.9, 0), ALL, met, 2),
                     3);
    ck_assert(tumble_body_is_same(met[2], untouched));
    tumble_world_free(w);
}
END_TEST

// --- Who touches whom --------------------------------------------------------

START_TEST(a_contact_is_where_the_corners_are)
{
    tumble_world *w = empty();
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_shape box = tumble_shape_box(w, tumble_v(1, 1, 1), 2);
    tumble_body low = tumble_body_add(w, box, tumble_body_at(3, 0.5, 4));
    tumble_body high = tumble_body_add(w, box, tumble_body_at(3, 1.5, 4));
    tumble_contact c[3];
    for (int k = 0; k < 60; k++) tumble_world_step(w);
    ck_assert_int_eq(tumble_world_contacts(w, c, 3), 2);
    for (int k = 0; k < 2; k++) {
        bool is_floor = tumble_body_is_same(c[k].b, tumble_body_ground());
        bool is_up = is_floor || tumble_body_is_same(c[k].a, high);
        double sum = 0, up = is_up ? 1 : -1;
        ck_assert(is_floor ? tumble_body_is_same(c[k].a, low)
                  : tumble_body_is_same(c[k].a, up > 0 ? high : low)
                    && tumble_body_is_same(c[k].b, up > 0 ? low : high));
        near(c[k].normal.y, up, 1e-6);
        ck_assert_int_eq(c[k].points, 4);
        for (int i = 0; i < 4; i++) {
            near(fabs(c[k].point[i].x - 3), 0.5, 1e-3);
            near(fabs(c[k].point[i].z - 4), 0.5, 1e-3);
            near(c[k].point[i].y, is_floor ? 0 : 1, 2e-3);
            sum += c[k].force[i];
        }
        near(sum, is_floor ? 4 * 9.81 : 2 * 9.81, 0.1);
    }
    tumble_world_free(w);
}
END_TEST

enum { MOST = 64 };
typedef struct { tumble_body a, b; } pair;
static pair touching[MOST];
static int touchings;

static int place_of(tumble_body a, tumble_body b)
{
    int k = 0;
    while (k < touchings && !(tumble_body_is_same(touching[k].a, a)
                              && tumble_body_is_same(touching[k].b, b))) k++;
    return k;
}

// What the events say begins and ends, in a list of what touches.
static void take_events(const tumble_event *e, int n)
{
    for (int i = 0; i < n; i++) {
        int k = place_of(e[i].a, e[i].b);
        ck_assert_msg((k == touchings) == e[i].begins, "%u and %u: %s twice",
                      e[i].a.place, e[i].b.place,
                      e[i].begins ? "begins" : "ends");
        ck_assert_int_lt(touchings, MOST);
        if (e[i].begins) touching[touchings++] = (pair){ e[i].a, e[i].b };
        else             touching[k] = touching[--touchings];
    }
}

// Four walls, a stage of two pieces, and twelve balls that bounce; every now and
// then one is taken away, and another comes in its place.
// Rejects: events that are lost, told twice, or of the body that was there before.
START_TEST(events_are_the_difference_of_the_contacts)
{
    tumble_options o = tumble_options_default();
    o.restitution = 0.8;
    tumble_world *w = tumble_world_make(&o);
    tumble_shape slab = tumble_shape_box(w, tumble_v(4, 1, 8), 1);
    tumble_shape ball = tumble_shape_sphere(w, 0.4, 1);
    const tumble_shape piece[2] = { slab, slab };
    const tumble_pose where[2] = { at(-2, -0.5, 0), at(2, -0.5, 0) };
    tumble_body all[12], stage;
    tumble_event e[MOST];
    tumble_contact c[MOST];
    unsigned long long seed = 5;
    int begun = 0, renewed = 0;
    for (int k = 0; k < 12; k++)
        all[k] = tumble_body_add(w, ball,
                                 tumble_body_at(0.7 * (k % 3) - 0.7, 1 + k,
                                                0.3 * (k % 2)));
    stage = tumble_body_add_pieces(w, piece, where, 2, tumble_body_at(0, 0, 0));
    for (int k = -1; k <= 1; k += 2) {
        tumble_plane_add(w, tumble_v(k, 0, 0), -1.5, -1);
        tumble_plane_add(w, tumble_v(0, 0, k), -1.5, -1);
    }
    touchings = 0;
    for (int step = 0; step < 800; step++) {
        int gone = random_below(&seed, 12);
        bool is_new = step % 10 == 5;
        if (is_new) {
            tumble_body old = all[gone];
            tumble_pose there = tumble_body_pose(w, old);
            tumble_body_remove(w, old);
            double up = step % 20 == 5 ? 3 : 0;
            all[gone] = tumble_body_add(w, ball,
                                        tumble_body_at(there.position.x,
                                                       there.position.y + up,
                                                       there.position.z));
            ck_assert_uint_eq(old.place, all[gone].place);
            for (int k = 0; k < touchings; k++)
                renewed += tumble_body_is_same(touching[k].a, old)
                        || tumble_body_is_same(touching[k].b, old);
        }
        tumble_world_step(w);
        int n = tumble_world_events(w, e, MOST);
        int all_contacts = tumble_world_contacts(w, c, MOST);
        ck_assert_int_le(n, MOST);
        for (int k = 0; k < n; k++) begun += e[k].begins;
        take_events(e, n);
        for (int k = 0; k < all_contacts; k++)
            ck_assert_int_lt(place_of(c[k].a, c[k].b), touchings);
        ck_assert_int_le(touchings, all_contacts);
        for (int k = 0; k < touchings; k++)
            ck_assert(tumble_body_exists(w, touching[k].a)
                      && (tumble_body_exists(w, touching[k].b)
                          || tumble_body_is_same(touching[k].b,
                                                 tumble_body_ground())));
    }
    ck_assert_int_gt(begun, 50);
    ck_assert_int_gt(renewed, 5);
    ck_assert(tumble_body_exists(w, stage));
    tumble_world_free(w);
}
END_TEST

// A box that stands on both pieces of a stage touches one body.
START_TEST(a_pair_begins_once_however_many_pieces_touch)
{
    // Gravity pushes the box against a floor and a wall of one body.
    tumble_options o = tumble_options_default();
    o.gravity = tumble_v(-9, -9, 0);
    tumble_world *w = tumble_world_make(&o);
    tumble_shape box = tumble_shape_box(w, tumble_v(1, 1, 1), 1);
    const tumble_shape piece[2] = { box, box };
    const tumble_pose where[2] = { at(0, 0, 0), at(-1, 1, 0) };
    tumble_body stage = tumble_body_add_pieces(w, piece, where, 2,
                                               tumble_body_at(0, 0, 0));
    tumble_body b = tumble_body_add(w, box, tumble_body_at(0, 1, 0));
    tumble_event e[4];
    for (int k = 0; k < 30; k++) tumble_world_step(w);
    ck_assert_int_eq(tumble_world_contacts(w, NULL, 0), 2);
    ck_assert_int_eq(tumble_world_events(w, e, 4), 1);
    ck_assert(e[0].begins);
    tumble_body on = tumble_body_is_same(e[0].a, b) ? e[0].b : e[0].a;
    ck_assert(tumble_body_is_same(e[0].a, b) || tumble_body_is_same(e[0].b, b));
    ck_assert(tumble_body_is_same(on, stage));
    tumble_world_free(w);
}
END_TEST

// --- Drawing -----------------------------------------------------------------

typedef struct {
    tumble_vec3 low, high;      // of all that was drawn
    int points, lines, triangles;
} picture;

static void add_point(picture *p, tumble_vec3 x)
{
    p->low = tumble_v(fmin(p->low.x, x.x), fmin(p->low.y, x.y),
                      fmin(p->low.z, x.z));
    p->high = tumble_v(fmax(p->high.x, x.x), fmax(p->high.y, x.y),
                       fmax(p->high.z, x.z));
}

static void on_triangle(void *c, tumble_body b, const tumble_vec3 x[3])
{
    (void)b;
    ((picture *)c)->triangles++;
    for (int k = 0; k < 3; k++) add_point(c, x[k]);
}

static void on_line(void *c, tumble_body b, const tumble_vec3 x[2])
{
    (void)b;
    ((picture *)c)->lines++;
    for (int k = 0; k < 2; k++) add_point(c, x[k]);
}

static void on_point(void *c, tumble_body b, tumble_vec3 x)
{
    (void)b;
    ((picture *)c)->points++;
    add_point(c, x);
}

static picture drawn(const tumble_world *w)
{
    const double far = HUGE_VAL;
    picture p = { { far, far, far }, { -far, -far, -far }, 0, 0, 0 };
    const tumble_pen pen = { on_triangle, on_line, on_point, &p };
    tumble_world_draw(w, &pen);
    return p;
}

START_TEST(bodies_pieces_and_joints_are_drawn_where_they_are)
{
    tumble_world *w = empty();
    tumble_shape box = tumble_shape_box(w, tumble_v(1, 2, 3), 1);
    const tumble_shape piece[2] = { box, box };
    const tumble_pose where[2] = { at(0, 0, 0), at(5, 0, 0) };
    tumble_body stage = tumble_body_add_pieces(w, piece, where, 2,
                                               tumble_body_at(0, 0, 0));
    tumble_vec3 corner[17] = { { 0, 0, 0 } };
    ck_assert_int_eq(tumble_body_vertices(w, stage, corner, 12), 16);
    for (int k = 0; k < 16; k++) near(corner[k].y, 0, k < 12);
    near(fabs(corner[0].x), 0.5, fine);
    near(fabs(corner[8].x - 5), 0.5, fine);
    ck_assert(corner[12].x == 0);
    picture p = drawn(w);
    ck_assert_int_eq(p.triangles, 24);
    near_vec3(p.low, -0.5, -1, -1.5);
    near_vec3(p.high, 5.5, 1, 1.5);
    tumble_body b = tumble_body_add(w, box, tumble_body_at(2, 9, 0));
    tumble_body other = tumble_body_add(w, box, tumble_body_at(4, 9, 0));
    tumble_joint j = tumble_joint_ball(w, b, tumble_body_ground(),
                                       tumble_v(2, 12, 7));
    tumble_joint_distance(w, b, tumble_v(2, 9, -8), other, tumble_v(20, 9, 0),
                          0, 99);
    p = drawn(w);
    ck_assert_int_eq(p.triangles, 48);
    ck_assert_int_eq(p.points, 1);
    ck_assert_int_eq(p.lines, 1);
    near_vec3(p.low, -0.5, -1, -8);
    near_vec3(p.high, 20, 12, 7);
    tumble_joint_remove(w, j);
    ck_assert_int_eq(drawn(w).points, 0);
    tumble_world_free(w);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        a_question_asks_only_the_groups_that_it_names,
        a_shape_is_asked_as_it_is_turned,
        balls_and_capsules_are_met_at_their_radius,
        what_begins_inside_meets_at_once,
        pieces_that_overlap_are_one_body,
        a_contact_is_where_the_corners_are,
        events_are_the_difference_of_the_contacts,
        a_pair_begins_once_however_many_pieces_touch,
        bodies_pieces_and_joints_are_drawn_where_they_are,
        NULL
    };
    return suite_run((suite){ .name = "ask", .tests = tests, .seconds = 60 });
}
