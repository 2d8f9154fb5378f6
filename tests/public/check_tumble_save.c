// check_tumble_save.c - does a world that was saved and loaded go on as if it
// never had been?

#define _DEFAULT_SOURCE

#include "scarce.h"
#include "random.h"
#include "store.h"
#include "suite.h"
#include "thread.h"
#include "tumble.h"

#include <check.h>
#include <malloc.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { EACH = 20, MOST = 400, HEAD = 48 };

typedef struct {
    unsigned char *at;
    size_t size;
} bytes;

static bytes saved(const tumble_world *w)
{
    bytes b = { NULL, tumble_world_save(w, NULL, 0) };
    b.at = malloc(b.size);
    ck_assert_ptr_nonnull(b.at);
    ck_assert_uint_eq(tumble_world_save(w, b.at, b.size), b.size);
    return b;
}

static tumble_world *loaded(bytes b)
{
    tumble_world *w = tumble_world_load(b.at, b.size);
    ck_assert_msg(w != NULL, "%s", tumble_world_failure(NULL));
    ck_assert_ptr_null(tumble_world_failure(NULL));
    return w;
}

static tumble_world *copied(const tumble_world *w)
{
    bytes b = saved(w);
    tumble_world *copy = loaded(b);
    free(b.at);
    return copy;
}

// --- Worlds ------------------------------------------------------------------
static void add_walls(tumble_world *w, double far)
{
    const tumble_vec3 normal[] = { { 0, 1, 0 }, { 1, 0, 0 }, { -1, 0, 0 },
                                   { 0, 0, 1 }, { 0, 0, -1 } };
    for (int k = 0; k < 5; k++)
        tumble_plane_add(w, normal[k], k == 0 ? 0 : -far, k == 4 ? 0.2 : -1);
}

static unsigned long long seed;

static tumble_vec3 any_vec3(double most)
{
    double x = random_between(&seed, -most, most),
        y = random_between(&seed, -most, most);
    return tumble_v(x, y, random_between(&seed, -most, most));
}

static tumble_shape any_solid(tumble_world *w, int k)
{
    tumble_vec3 point[12];
    for (int i = 0; i < 12; i++) point[i] = any_vec3(0.5);
    return k % 5 == 0 ? tumble_shape_box(w, tumble_v(0.8, 0.6, 0.5), 2)
         : k % 5 == 1 ? tumble_shape_icosahedron(w, 0.5, 1)
         : k % 5 == 2 ? tumble_shape_sphere(w, 0.4, 1)
         : k % 5 == 3 ? tumble_shape_capsule(w, 0.6, 0.25, 1)
                      : tumble_shape_hull(w, point, 12, 1);
}

static void throw_all(tumble_world *w, int n, double speed)
{
    tumble_shape shape[7];
    for (int k = 0; k < 7; k++) shape[k] = any_solid(w, k);
    for (int k = 0; k < n; k++) {
        tumble_body_options o = tumble_body_at(k % 3 - 1.2, 1 + k / 9 * 1.3,
                                               k / 3 % 3 - 1.1);
        o.velocity = any_vec3(speed);
        o.spin = any_vec3(5);
        o.pose.rotation = tumble_quat_turn(any_vec3(1), 1);
        tumble_body_add(w, shape[k % 7], o);
    }
}

static void make_room(tumble_world *w)
{
    add_walls(w, 2);
    throw_all(w, 40, 5);
}

static void make_pile(tumble_world *w)
{
    add_walls(w, 20);
    tumble_shape box = tumble_shape_box(w, tumble_v(1, 1, 1), 2);
    for (int row = 0; row < 4; row++)
        for (int k = 0; k < 4 - row; k++)
            tumble_body_add(w, box, tumble_body_at(k * 1.05 + row * 0.52,
                                                   row + 0.5, 0));
}

static void make_cloth(tumble_world *w)
{
    add_walls(w, 20);
    tumble_body_options o = tumble_body_at(0, 0.5, 0);
    o.kind = TUMBLE_STATIC;
    tumble_shape box = tumble_shape_box(w, tumble_v(1, 1, 1), 2);
    tumble_shape sheet = tumble_shape_cloth(w, 14, 14, 2, 2, 1);
    tumble_body_add(w, box, o);
    tumble_body cloth = tumble_body_add(w, sheet, tumble_body_at(0, 1.3, 0.1));
    tumble_body over = tumble_body_add(w, sheet, tumble_body_at(0.1, 1.6, 0));
    tumble_body_set_stretch(w, over, 1e-4);
    tumble_body_set_bending(w, cloth, 1e-3);
    tumble_body rope = tumble_body_add(w, tumble_shape_rope(w, 20, 2, 0.3),
                                       tumble_body_at(0, 3, 0));
    tumble_body_pin(w, rope, 0);
    tumble_body_set_bending(w, rope, 1e-2);
    tumble_body load = tumble_body_add(w, box, tumble_body_at(1.2, 2.4, 0));
    tumble_joint_hang(w, rope, 20, load);
    tumble_body_add(w, any_solid(w, 2), tumble_body_at(-0.3, 2.4, 0));
}

static void make_joints(tumble_world *w)
{
    add_walls(w, 20);
    tumble_shape box = tumble_shape_box(w, tumble_v(0.8, 0.4, 0.4), 2);
    tumble_body b[8];
    for (int k = 0; k < 8; k++)
        b[k] = tumble_body_add(w, box, tumble_body_at(k, 4, 0));
    tumble_joint_ball(w, tumble_body_ground(), b[0], tumble_v(-0.5, 4, 0));
    for (int k = 0; k + 1 < 6; k++) {
        tumble_vec3 at = tumble_v(k + 0.5, 4, 0);
        if (k % 3 == 0) tumble_joint_ball(w, b[k], b[k + 1], at);
        if (k % 3 == 1) {
            tumble_joint j = tumble_joint_hinge(w, b[k], b[k + 1], at,
                                                tumble_v(0, 0.3, 1));
            tumble_joint_set_limits(w, j, -0.4, 0.5);
        }
        if (k % 3 == 2) tumble_joint_fixed(w, b[k], b[k + 1], at);
    }
    tumble_joint_distance(w, b[5], tumble_v(5, 4, 0), b[6], tumble_v(6, 4, 0),
                          0.5, 1.5);
    tumble_joint_set_strength(w,
                              tumble_joint_ball(w, tumble_body_ground(), b[7],
                                                tumble_v(7.5, 4, 0)), 35);
    tumble_joint_ball(w, b[0], b[4], tumble_v(2, 4.3, 0));  // closes a ring
}

static void hang_spinning(tumble_world *w, int boxes, double speed)
{
    tumble_shape box = tumble_shape_box(w, tumble_v(1, 0.2, 0.1), 1);
    tumble_body last = tumble_body_ground();
    for (int k = 0; k < boxes; k++) {
        tumble_body_options o = tumble_body_at(1.2 * k, 3, 0);
        o.spin = any_vec3(speed);
        tumble_body b = tumble_body_add(w, box, o);
        tumble_joint_ball(w, last, b, tumble_v(1.2 * k - 0.6, 3, 0));
        last = b;
    }
}

// Held at their centres they go on for ever.
static void make_spinning(tumble_world *w)
{
    tumble_shape box = tumble_shape_box(w, tumble_v(1, 0.2, 0.1), 1);
    for (int k = 0; k < 8; k++) {
        tumble_body_options o = tumble_body_at(2 * k, 3, 0);
        o.spin = tumble_v(100, 50, 200);
        tumble_body b = tumble_body_add(w, box, o);
        tumble_joint_ball(w, tumble_body_ground(), b, o.pose.position);
    }
}

static void make_driven(tumble_world *w)
{
    make_room(w);
    tumble_body_options o = tumble_body_at(0, 0.6, 0);
    o.kind = TUMBLE_KINEMATIC;
    o.velocity = tumble_v(0.2, 0, 0);
    o.spin = tumble_v(0, 2, 0);
    tumble_body_add(w, tumble_shape_box(w, tumble_v(2, 0.2, 0.4), 1), o);
    tumble_shape part[2] = { any_solid(w, 0), any_solid(w, 2) };
    tumble_pose at[2] = { { { 0, 3, 0 }, { 0, 0, 0, 1 } },
                          { { 0, 3.3, 0 }, { 0, 0, 0, 1 } } };
    tumble_body_add_pieces(w, part, at, 2, o);
}

// Twenty times too fast, far too heavy, and as bouncy as can be.
static void make_hard(tumble_world *w)
{
    make_pile(w);
    tumble_body_options o = tumble_body_at(-15, 1.5, 0.1);
    o.velocity = tumble_v(200, 0, 0);
    o.restitution = 1;
    tumble_body_add(w, tumble_shape_sphere(w, 0.2, 0.1), o);
    tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 1, 1), 2000),
                    tumble_body_at(1.5, 7, 0));
    o = tumble_body_at(0, 3, 5);
    o.spin = tumble_v(200, 30, 0);
    tumble_body_add(w, tumble_shape_box(w, tumble_v(2, 0.1, 0.1), 1), o);
}

// A sheet that stands on its edge, and crumples, and a rope whose box has more
// cells than its grid, so that the tree is asked.
static void make_spread(tumble_world *w)
{
    add_walls(w, 40);
    tumble_body_options o = tumble_body_at(0, 1.1, 0);
    o.pose.rotation = tumble_quat_turn(tumble_v(1, 0.1, 0), 1.5);
    tumble_body_add(w, tumble_shape_cloth(w, 14, 14, 2, 2, 1), o);
    o = tumble_body_at(0, 9, 9);
    o.pose.rotation = tumble_quat_turn(tumble_v(0, -1, 1), 0.955);
    tumble_body_add(w, tumble_shape_rope(w, 400, 20, 0.1), o);
}

// Boxes that lie on a slope: what is kept of their contacts has skew normals.
static void make_slope(tumble_world *w)
{
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.kind = TUMBLE_STATIC;
    o.pose.rotation = tumble_quat_turn(tumble_v(0.6, 0, 0.8), 0.2);
    tumble_body_add(w, tumble_shape_box(w, tumble_v(8, 1, 8), 1), o);
    o.kind = TUMBLE_DYNAMIC;
    tumble_shape box = tumble_shape_box(w, tumble_v(1, 0.6, 0.8), 1);
    for (int k = -1; k < 2; k++) {
        // A point on the axis, and from there up: turned by 0.2 rad.
        double x = 1.5 * k, up = 0.81;
        o.pose.position = tumble_v(0.6 * x - 0.8 * sin(0.2) * up, cos(0.2) * up,
                                   0.8 * x + 0.6 * sin(0.2) * up);
        tumble_body_add(w, box, o);
    }
}

// Bodies that are not evenly filled: balls, capsules and boxes that rock; and
// bodies of two and three pieces, of which one has gone.
static void make_weighed(tumble_world *w)
{
    const double inertia[6] = { 0.2, 0.3, 0.25, 0.02, -0.01, 0.03 };
    add_walls(w, 2);
    for (int k = 0; k < 12; k++) {
        tumble_shape s = tumble_shape_weighed(w, any_solid(w, k % 4), 2,
                                              tumble_v(0, -0.2, 0.1), inertia);
        if (k == 5)
            s = tumble_shape_rounded(w, tumble_shape_box(w, tumble_v(1, .6, .4),
                                                         2), .1);
        tumble_body_options o = tumble_body_at(k % 3 - 1.2, 1 + k / 9 * 1.3,
                                               k / 3 % 3 - 1.1);
        o.spin = any_vec3(5);
        tumble_body_add(w, s, o);
    }
    tumble_shape piece[3] = { any_solid(w, 0), any_solid(w, 2), any_solid(w, 3) };
    tumble_pose pose[3] = { { { 0, 0, 0 }, { 0, 0, 0, 1 } },
                            { { 0.7, 0.1, 0 }, { 0, 0, 0, 1 } },
                            { { 0, -0.2, 0.6 }, { 0.6, 0, 0, 0.8 } } };
    for (int k = 0; k < 6; k++) {
        tumble_body_options o = tumble_body_at(k % 3 - 1, 4 + k / 3 * 1.5, 0);
        o.spin = any_vec3(3);
        tumble_body b = tumble_body_add_compound(w, piece, pose, 2 + k % 2, o);
        if (k == 2) tumble_body_remove(w, b);
    }
}

// A cloth between two bars that turn until it would have to cross itself.
static void make_twisted(tumble_world *w)
{
    enum { SIDE = 8 };
    tumble_body cloth =
        tumble_body_add(w, tumble_shape_cloth(w, SIDE, SIDE, 1, 1, 0.2),
                        tumble_body_at(0, 0, 0));
    for (int side = 0; side < 2; side++) {
        tumble_body_options o = tumble_body_at(side - 0.5, 0, 0);
        o.kind = TUMBLE_KINEMATIC;
        o.spin = tumble_v(side ? 8 : -8, 0, 0);
        o.mask = 0;
        tumble_body bar =
            tumble_body_add(w, tumble_shape_box(w, tumble_v(.05, .05, 1), 1),
                            o);
        for (int i = 0; i < SIDE; i++)
            tumble_joint_hang(w, cloth, i * SIDE + side * (SIDE - 1), bar);
    }
}

typedef void making(tumble_world *w);
static making *const MAKE[] = { make_room, make_pile, make_cloth, make_joints,
                                make_driven, make_hard, make_spinning,
                                make_slope, make_weighed, make_spread,
                                make_twisted };
enum { ALL_WORLDS = sizeof MAKE / sizeof *MAKE, WORLDS = ALL_WORLDS - 2,
       TWISTED = ALL_WORLDS - 1 };

static tumble_world *world_of(int which, double restitution)
{
    tumble_options o = tumble_options_default();
    o.restitution = restitution;
    o.substeps = 8;
    o.most_substeps = 40;
    tumble_world *w = tumble_world_make(&o);
    ck_assert_ptr_nonnull(w);
    seed = 1;
    MAKE[which](w);
    ck_assert_ptr_null(tumble_world_failure(w));
    return w;
}

// --- What a program does to it -----------------------------------------------
static void touch(tumble_world *w, int k)
{
    tumble_body all[MOST];
    int n = tumble_world_bodies(w, all, MOST);
    tumble_body b = all[k * 7 % n], other = all[(k * 5 + 1) % n];
    tumble_body_options o = tumble_body_at(0, 6, 0.3);
    tumble_event e[4];
    const tumble_shape first = { 0, 1 };
    switch (k % 9) {
    case 0: tumble_body_force(w, b, tumble_v(3, 20, 1), tumble_v(0, 2, 1));
            break;
    case 1: tumble_body_remove(w, b); break;
    case 2: o.restitution = 0.7;
            o.damping = 0.2;
            tumble_body_add(w, k % 2 ? first : any_solid(w, k), o); break;
    case 3: tumble_body_set_material(w, b, 0.9, 0.4); break;
    case 4: tumble_body_set_filter(w, b, 2, ~0u - 1); break;
    case 5: tumble_body_push(w, b, tumble_v(1, 2, 0),
                             tumble_body_position(w, b)); break;
    case 6: tumble_joint_ball(w, b, other, tumble_body_position(w, b)); break;
    case 7: tumble_world_events(w, e, 4); break;
    case 8: tumble_body_set_damping(w, b, 0.5, 0.5);
            tumble_body_force(w, b, tumble_v(3, 20, 1), tumble_v(0, 2, 1));
            break;
    }
    tumble_world_forget_failure(w);
}

static void go_on(tumble_world *w, int from, int steps, bool is_touched)
{
    seed = (unsigned long long)from;
    for (int k = from; k < from + steps; k++) {
        if (is_touched && k % 10 == 0) touch(w, k / 10);
        tumble_world_step(w);
    }
}

// --- The tests ---------------------------------------------------------------
static void expect_alike(const tumble_world *a, const tumble_world *b,
                         const char *what, int number)
{
    tumble_contact x[4], y[4];
    tumble_report r = tumble_world_last_step(a), t = tumble_world_last_step(b);
    ck_assert_msg(tumble_world_hash(a) == tumble_world_hash(b),
                  "%s %d: %016llx %016llx", what, number, tumble_world_hash(a),
                  tumble_world_hash(b));
    ck_assert(tumble_world_time(a) == tumble_world_time(b));
    ck_assert_mem_eq(&r, &t, sizeof r);
    int n = tumble_world_contacts(a, x, 4);
    ck_assert_int_eq(tumble_world_contacts(b, y, 4), n);
    for (int k = 0; k < n && k < 4; k++)
        ck_assert(x[k].force[0] == y[k].force[0] && x[k].a.place == y[k].a.place
                  && x[k].points == y[k].points);
}

// Saved after so many steps, it goes on for so many more with the same bits, and
// so does what it was saved from.
static void expect_same(tumble_world *w, int which, int steps, bool is_touched)
{
    unsigned long long was = tumble_world_hash(w);
    tumble_world *copy = copied(w);
    ck_assert(tumble_world_hash(w) == was);
    expect_alike(w, copy, "world", which);
    for (int k = 0; k < steps; k += EACH) {
        go_on(w, k, EACH, is_touched);
        go_on(copy, k, EACH, is_touched);
        expect_alike(w, copy, "world", which);
    }
    tumble_world_free(w);
    tumble_world_free(copy);
}

// Rejects: any table forgotten, and any that the next frame reads taken for
// scratch (which is filled with garbage here).
START_TEST(a_loaded_world_goes_on_with_the_same_bits)
{
    const int moment[] = { 0, 1, 37, 400 };
    for (int m = 0; m < 4; m++) {
        tumble_world *w = world_of(_i, 0);
        go_on(w, 0, moment[m], false);
        expect_same(w, _i, m == 2 ? 240 : 60, false);
    }
}
END_TEST

START_TEST(also_where_all_bounces)
{
    tumble_world *w = world_of(_i, 0.8);
    go_on(w, 0, 25, false);
    expect_same(w, _i, 100, false);
}
END_TEST

// Boxes on joints that spin at 1 to 1,000 rad/s, one alone and three in a chain.
// How many parts a frame has depends on what was joined in the last one.
// Rejects: a table of joined bodies that is loaded as zeros.
START_TEST(what_spins_on_a_joint_goes_on_alike)
{
    for (int s = 0; s < 40; s++) {
        tumble_world *w = tumble_world_make(NULL);
        seed = (unsigned long long)s;
        hang_spinning(w, s % 2 ? 1 : 3, pow(10, random_between(&seed, 0, 3)));
        go_on(w, 0, s % 4 * 7, false);
        tumble_world *copy = copied(w);
        for (int k = 0; k < 10; k++) {
            tumble_world_step(w);
            tumble_world_step(copy);
            expect_alike(w, copy, "spinning world", s);
        }
        tumble_world_free(w);
        tumble_world_free(copy);
    }
}
END_TEST

// Some are pushed when they are saved.  What spins on joints that are closed to
// rings takes most of all substeps, and is saved once.
START_TEST(bodies_come_and_go_and_are_pushed_alike)
{
    int last = MAKE[_i] == make_spinning ? 15 : 155;
    for (int k = 15; k <= last; k += 70) {
        tumble_world *w = world_of(_i, 0.3);
        go_on(w, 0, k, true);
        touch(w, 8);
        expect_same(w, _i, last == 15 ? EACH : 3 * EACH, true);
    }
}
END_TEST

// Rejects: a number that is lost.  (The bytes of the second are all of the
// first's; padding, too, is copied.)
START_TEST(what_is_loaded_is_saved_as_the_same_bytes)
{
    for (int k = 0; k < WORLDS; k++) {
        tumble_world *w = world_of(k, 0);
        go_on(w, 0, 130, true);
        bytes a = saved(w);
        tumble_world_free(w);
        w = loaded(a);
        bytes b = saved(w);
        ck_assert_uint_eq(a.size, b.size);
        ck_assert(memcmp(a.at, b.at, a.size) == 0);
        tumble_world_free(w);
        free(a.at);
        free(b.at);
    }
}
END_TEST

START_TEST(one_two_and_four_threads_go_on_alike)
{
    for (int which = 0; which < 3; which++) {
        tumble_world *w = world_of(which, 0);
        for (int k = 0; k < 40; k++) tumble_world_step(w);
        bytes b = saved(w);
        for (int k = 0; k < 200; k++) tumble_world_step(w);
        for (int threads = 1; threads <= 4; threads *= 2) {
            thread_pool *pool = thread_pool_new(threads);
            tasks t = thread_pool_tasks(pool);
            tumble_world *copy = loaded(b);
            tumble_world_run_on(copy, t.run, t.context);
            for (int k = 0; k < 100; k++) tumble_world_step(copy);
            tumble_world *next = copied(copy);
            tumble_world_free(copy);
            for (int k = 0; k < 100; k++) tumble_world_step(next);
            ck_assert(tumble_world_hash(next) == tumble_world_hash(w));
            tumble_world_free(next);
            thread_pool_free(pool);
        }
        tumble_world_free(w);
        free(b.at);
    }
}
END_TEST

START_TEST(cloth_that_is_kept_from_crossing_goes_on_alike_by_any_threads)
{
    enum { TWO = 2 };
    tumble_world *w = tumble_world_make(NULL);
    make_twisted(w);
    for (int k = 0; k < 50; k++) tumble_world_step(w);
    tumble_world *copy = copied(w);
    thread_pool *pool = thread_pool_new(TWO);
    tasks t = thread_pool_tasks(pool);
    tumble_world_run_on(copy, t.run, t.context);
    int prevented = 0;
    for (int k = 0; k < 40; k++) {
        tumble_world_step(w);
        tumble_world_step(copy);
        prevented += tumble_world_last_step(w).prevented;
        expect_alike(w, copy, "twisted", k);
    }
    ck_assert_int_gt(prevented, 0);
    tumble_world_free(w);
    tumble_world_free(copy);
    thread_pool_free(pool);
}
END_TEST

// Ids, user data, a failure that was not asked for yet, and whom events know.
START_TEST(what_a_program_holds_is_good_afterwards)
{
    int mine = 7;
    tumble_world *w = tumble_world_make(NULL);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_shape box = tumble_shape_box(w, tumble_v(1, 1, 1), 2);
    tumble_body gone = tumble_body_add(w, box, tumble_body_at(5, 0.5, 0));
    tumble_body lies = tumble_body_add(w, box, tumble_body_at(0, 0.5, 0));
    tumble_body hangs = tumble_body_add(w, box, tumble_body_at(3, 3, 0));
    tumble_joint j = tumble_joint_ball(w, tumble_body_ground(), hangs,
                                       tumble_v(3, 3.5, 0));
    tumble_event e[4];
    tumble_body_set_user(w, lies, &mine);
    tumble_body_remove(w, gone);
    for (int k = 0; k < 30; k++) tumble_world_step(w);
    ck_assert_int_eq(tumble_world_events(w, e, 4), 1);
    tumble_shape_remove(w, box);
    bytes b = saved(w);
    tumble_world_free(w);

    w = loaded(b);
    free(b.at);
    ck_assert_ptr_nonnull(strstr(tumble_world_failure(w), "cannot be dropped"));
    tumble_world_forget_failure(w);
    ck_assert(tumble_body_exists(w, lies) && !tumble_body_exists(w, gone));
    ck_assert_ptr_eq(tumble_body_user(w, lies), &mine);
    ck_assert(tumble_joint_exists(w, j));
    ck_assert_int_eq(tumble_world_events(w, e, 4), 0);
    tumble_body next = tumble_body_add(w, box, tumble_body_at(5, 0.5, 0));
    ck_assert_uint_eq(next.place, gone.place);
    ck_assert(!tumble_body_exists(w, gone));
    ck_assert(tumble_body_remove(w, lies) && tumble_body_remove(w, hangs)
              && tumble_body_remove(w, next));
    ck_assert(!tumble_joint_exists(w, j));
    ck_assert(tumble_shape_remove(w, box));
    ck_assert_ptr_null(tumble_world_failure(w));
    tumble_world_free(w);
}
END_TEST

START_TEST(a_box_in_a_heap_takes_six_kilobytes)
{
    enum { BOXES = 200 };
    tumble_world *w = tumble_world_make(NULL);
    tumble_shape s = tumble_shape_box(w, tumble_v(0.5, 0.5, 0.5), 1);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    for (int k = 0; k < BOXES; k++)
        tumble_body_add(w, s,
                        tumble_body_at(0.7 * (k % 6), 0.4 + 0.7 * (k / 36),
                                       0.71 * (k / 6 % 6)));
    for (int k = 0; k < 100; k++) tumble_world_step(w);
    double each = (double)tumble_world_save(w, NULL, 0) / BOXES;
    ck_assert_msg(each > 2000 && each < 6000, "%g bytes", each);
    tumble_world_free(w);
}
END_TEST

START_TEST(an_empty_world_can_be_saved)
{
    tumble_world *w = tumble_world_make(NULL), *copy = copied(w);
    tumble_world_step(copy);
    ck_assert_uint_ne(tumble_body_add(copy, tumble_shape_sphere(copy, 1, 1),
                                      tumble_body_at(0, 0, 0)).generation, 0);
    tumble_world_step(copy);
    tumble_world_free(w);
    tumble_world_free(copy);
}
END_TEST

static void expect_refusal(const void *at, size_t size, const char *part)
{
    ck_assert_ptr_null(tumble_world_load(at, size));
    const char *why = tumble_world_failure(NULL);
    ck_assert_ptr_nonnull(why);
    ck_assert_msg(!part || strstr(why, part), "said: %s", why);
    ck_assert(strlen(why) > 20 && !strchr(why, '\n'));
}

// Every byte once, and every length up to some; in a copy of just that length,
// so that reading further is seen.
START_TEST(bytes_that_were_cut_or_altered_are_refused)
{
    tumble_world *w = world_of(1, 0);
    for (int k = 0; k < 10; k++) tumble_world_step(w);
    bytes b = saved(w);
    for (size_t i = 0; i < b.size; i += i < 4000 ? 1 : 61) {
        b.at[i] ^= (unsigned char)(1 << i % 8);
        expect_refusal(b.at, b.size, NULL);
        b.at[i] ^= (unsigned char)(1 << i % 8);
    }
    for (size_t n = 0; n < b.size; n += n < 200 ? 1 : 997) {
        unsigned char *cut = malloc(n > 0 ? n : 1);
        memcpy(cut, b.at, n);
        expect_refusal(cut, n, n < HEAD ? "no saved world" : "has");
        free(cut);
    }
    expect_refusal(NULL, 0, "0 bytes");
    b.at[8]++;
    expect_refusal(b.at, b.size, "another version");
    b.at[8]--;
    tumble_world_free(loaded(b));
    free(b.at);
    tumble_world_free(w);
}
END_TEST

START_TEST(too_little_room_is_told_and_not_overrun)
{
    tumble_world *w = world_of(3, 0);
    size_t size = tumble_world_save(w, NULL, 0);
    for (size_t room = 0; room < size; room += size / 97 + 1) {
        unsigned char *at = malloc(room + 1);
        at[room] = 77;
        ck_assert_uint_eq(tumble_world_save(w, at, room), size);
        ck_assert_uint_eq(at[room], 77);
        expect_refusal(at, room, NULL);
        free(at);
    }
    tumble_world_free(w);
}
END_TEST

START_TEST(where_memory_runs_out_nothing_is_loaded_and_nothing_lost)
{
    for (int which = 0; which < WORLDS; which++) {
        tumble_world *w = world_of(which, 0);
        for (int k = 0; k < 30; k++) tumble_world_step(w);
        bytes b = saved(w);
        tumble_world_free(w);
        for (int left = 0; ; left++) {
            long held = blocks_held;
            mallocs_left = left;
            w = tumble_world_load(b.at, b.size);
            mallocs_left = INT_MAX;
            if (w) tumble_world_free(w);
            held -= blocks_held;
            ck_assert_int_eq(held, 0);
            if (w) break;
            ck_assert_str_eq(tumble_world_failure(NULL), "out of memory");
        }
        free(b.at);
    }
}
END_TEST

// --- Put back, again and again -----------------------------------------------
// From the state, and on: the hash at the end.
static unsigned long long tried(tumble_world *w, bytes b, int *refused)
{
    *refused += !tumble_world_restore(w, b.at, b.size);
    mallocs_left = INT_MAX;
    go_on(w, 30, 20, false);
    return tumble_world_hash(w);
}

// Rejects: a table that is allocated anew; one that nothing frees.
START_TEST(a_state_that_is_put_back_again_asks_for_no_memory)
{
    for (int which = 0; which < ALL_WORLDS; which++) {
        int refused = 0, others = 0;
        tumble_world *w = world_of(which, 0);
        go_on(w, 0, 30, true);
        bytes b = saved(w);
        go_on(w, 30, 20, false);
        unsigned long long after = tumble_world_hash(w);
        others += tried(w, b, &refused) != after;
        others += tried(w, b, &refused) != after;
        long held = blocks_held;
        for (int round = 0; round < 4; round++) {
            mallocs_left = 0;
            others += tried(w, b, &refused) != after;
        }
        held -= blocks_held;
        tumble_world_free(w);
        free(b.at);
        ck_assert_msg(refused == 0, "world %d: %d refused", which, refused);
        ck_assert_int_eq(others, 0);
        ck_assert_int_eq(held, 0);
    }
}
END_TEST

START_TEST(what_was_put_back_is_saved_as_the_same_bytes)
{
    for (int which = 0; which < ALL_WORLDS; which++) {
        int refused = 0;
        tumble_world *w = world_of(which, 0);
        go_on(w, 0, 30, true);
        bytes b = saved(w);
        for (int round = 0; round < 3; round++) tried(w, b, &refused);
        ck_assert(tumble_world_restore(w, b.at, b.size));
        bytes again = saved(w);
        ck_assert_int_eq(refused, 0);
        ck_assert_uint_eq(again.size, b.size);
        ck_assert(memcmp(again.at, b.at, b.size) == 0);
        tumble_world_free(w);
        free(again.at);
        free(b.at);
    }
}
END_TEST

// Rejects: a list of tables that is lost.
START_TEST(where_memory_runs_out_a_world_stays_as_it_was)
{
    for (int which = 0; which < WORLDS; which++) {
        int others = 0, refused = 0;
        tumble_world *w = world_of(which, 0);
        go_on(w, 0, 30, true);
        bytes b = saved(w);
        go_on(w, 30, 20, false);
        unsigned long long after = tumble_world_hash(w);
        bool done = false;
        for (int left = 0; !done; left++) {
            long held = blocks_held;
            mallocs_left = left;
            done = tumble_world_restore(w, b.at, b.size);
            mallocs_left = INT_MAX;
            if (done) break;
            others += blocks_held != held || tumble_world_hash(w) != after
                   || !tumble_world_failure(w);
            tumble_world_forget_failure(w);
        }
        go_on(w, 30, 20, false);
        others += tumble_world_hash(w) != after;
        others += tried(w, b, &refused) != after;
        tumble_world_free(w);
        free(b.at);
        ck_assert_int_eq(others + refused, 0);
    }
}
END_TEST

// --- Is each table needed? ---------------------------------------------------
// A place in the code that stores a table, by the address behind its call.
enum { MOST_PLACES = 400 };
static const void *place[MOST_PLACES];
static bool is_needed[MOST_PLACES], is_used[MOST_PLACES];
static int places, spoilt = -1, garbage;

static int place_of(const void *address)
{
    int k = 0;
    while (k < places && place[k] != address) k++;
    if (k == MOST_PLACES) abort();
    if (k == places) place[places++] = address;
    return k;
}

void __real_store_table(store *s, void *array, int count, int room,
                        size_t size);
void __wrap_store_table(store *s, void *array, int count, int room,
                        size_t size);

// As store_table; but the tables of one place are read as garbage.
void __wrap_store_table(store *s, void *array, int count, int room,
                        size_t size)
{
    const void *address = __builtin_return_address(0);
    char *at;
    __real_store_table(s, array, count, room, size);
    memcpy(&at, array, sizeof at);
    if (!s->is_reading || count == 0 || !at) return;
    int k = place_of(address);
    is_used[k] = true;
    if (k == spoilt) memset(at, garbage, (size_t)count * size);
}

static void add_to(unsigned long long *sum, const void *data, size_t n)
{
    const unsigned char *at = data;
    for (size_t k = 0; k < n; k++) *sum = (*sum ^ at[k]) * 0x100000001b3U;
}

static void add_triangle(void *sum, tumble_body b, const tumble_vec3 at[3])
{
    (void)b;
    add_to(sum, at, 3 * sizeof *at);
}

// What a program may see of a world.
static void add_sight(const tumble_world *w, unsigned long long *sum)
{
    tumble_body all[MOST];
    tumble_report r = tumble_world_last_step(w);
    tumble_pen pen = { .triangle = add_triangle, .context = sum };
    int n = tumble_world_bodies(w, all, MOST);
    tumble_contact c[MOST];
    int touches = tumble_world_contacts(w, c, MOST);
    for (int k = 0; k < touches && k < MOST; k++)
        add_to(sum, c[k].force, (size_t)c[k].points * sizeof *c[k].force);
    for (int k = 0; k < n; k++) {
        tumble_vec3 v = tumble_body_velocity(w, all[k]);
        add_to(sum, &v, sizeof v);
    }
    add_to(sum, &touches, sizeof touches);
    add_to(sum, &r, sizeof r);
    tumble_world_draw(w, &pen);
}

// With ids of what was made before it was saved.
static void use_ids(tumble_world *w, unsigned long long *sum)
{
    tumble_event e[4] = { { .begins = false } };
    int events = tumble_world_events(w, e, 4);
    add_to(sum, &events, sizeof events);
    for (unsigned k = 0; k < 12; k++) {
        int done[3] = { tumble_joint_exists(w, (tumble_joint){ k, 1 }) };
        done[1] = tumble_shape_remove(w, (tumble_shape){ k, 1 });
        tumble_body_remove(w, (tumble_body){ k, 1 });
        done[2] = tumble_shape_remove(w, (tumble_shape){ k, 1 });
        add_to(sum, done, sizeof done);
        tumble_joint_remove(w, (tumble_joint){ k, 1 });
        tumble_body_unpin(w, (tumble_body){ k, 1 }, 0);
        tumble_body_add(w, (tumble_shape){ k, 1 }, tumble_body_at(3 * k, 9, 3));
    }
    for (unsigned k = 0; k < 5; k++)
        tumble_plane_remove(w, (tumble_plane){ k, 1 });
}

// What a saved world looks like on its way; a trial ends where it differs.
static unsigned long long seen[16];
static bool is_trial;

static void compare(const tumble_world *w, unsigned long long *sum, int at)
{
    add_sight(w, sum);
    if (is_trial && seen[at] != *sum) _exit(1);
    seen[at] = *sum;
}

static void follow(bytes b)
{
    unsigned long long sum = 1;
    tumble_world *w = tumble_world_load(b.at, b.size);
    if (!w) _exit(1);
    for (int k = 0; k < 12; k++) {
        compare(w, &sum, k);
        go_on(w, k, k < 4 ? 1 : 8, false);
    }
    tumble_body_wake(w, (tumble_body){ 3, 1 }); // and its island
    go_on(w, 0, 8, false);
    compare(w, &sum, 12);
    use_ids(w, &sum);
    go_on(w, 0, 20, false);
    compare(w, &sum, 13);
    tumble_world_free(w);
}

// In a process of its own, which may break, and may turn without end: it has five
// times as long as the world took whose tables are right.
static bool goes_elsewhere(bytes b, double seconds)
{
    int ended;
    pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0) {
        const struct rlimit none = { 0, 0 };
        long most = (long)(5e6 * (seconds + 0.01));
        struct itimerval timer = { .it_value = { most / 1000000,
                                                 most % 1000000 } };
        setrlimit(RLIMIT_CORE, &none);
        setitimer(ITIMER_PROF, &timer, NULL);
        fclose(stderr);
        is_trial = true;
        follow(b);
        _exit(0);
    }
    ck_assert_int_eq(waitpid(child, &ended, 0), child);
    return ended != 0;
}

// Is there a table in these bytes that no world has needed so far?
static bool has_unneeded(bytes b)
{
    bool has = false;
    memset(is_used, 0, sizeof is_used);
    tumble_world_free(loaded(b));
    for (int k = 0; k < places; k++) has = has || (is_used[k] && !is_needed[k]);
    return has;
}

static bool all_are_needed(void)
{
    bool all = true;
    for (int k = 0; k < places; k++) all = all && is_needed[k];
    return all;
}

// Garbage of three kinds: none at all, zeros, and large numbers; for each table
// that this world has.  The first is seen soonest, and the last may turn longest.
static void look_for_needed(const tumble_world *w)
{
    const int kind[] = { 0xff, 0, 0x5a };
    bytes b = saved(w);
    if (!has_unneeded(b)) {
        free(b.at);
        return;
    }
    clock_t began = clock();
    follow(b);
    double seconds = (double)(clock() - began) / CLOCKS_PER_SEC;
    for (int i = 0; i < 3 * places; i++) {
        garbage = kind[i % 3];
        spoilt = i / 3;
        if (is_used[spoilt] && !is_needed[spoilt])
            is_needed[spoilt] = goes_elsewhere(b, seconds);
    }
    spoilt = -1;
    free(b.at);
}

// Rejects: a table that is saved, and that nothing reads.
START_TEST(what_reads_garbage_for_a_table_goes_elsewhere)
{
    const int moment[] = { 37, 98, 400, 160, 220, 340, 200 };
    // A table that shows early need not be followed later: so the worlds that step
    // fast come first, and those that have most tables; so do the moments.
    const int world[ALL_WORLDS] = { 1, 7, 5, 3, 2, TWISTED, 9, 8, 0, 4,
                                      6 };
    // At the first three of these each table is there; the rest are for those that
    // nothing has needed until then.
    const int in_turn[] = { 0, 1, 4, 2, 3, 5, 6 };
    int needed = 0;
    for (int k = 0; k < 7 * ALL_WORLDS; k++) {
        if (k >= 3 * ALL_WORLDS && all_are_needed()) break;
        int when = in_turn[k / ALL_WORLDS];
        tumble_world *w = world_of(world[k % ALL_WORLDS], 0.3);
        go_on(w, 0, moment[when], when == 1);
        if (when != 1 && when < 4) touch(w, 8);
        if (when == 4) {        // one sleeps among others that lie still
            tumble_body_wake(w, (tumble_body){ 3, 1 });
            tumble_body_sleep(w, (tumble_body){ 0, 1 });
        }
        if (when == 6) {        // all sleep but one
            tumble_body all[MOST];
            int n = tumble_world_bodies(w, all, MOST);
            for (int b = 1; b < n; b++) tumble_body_sleep(w, all[b]);
            tumble_body_wake(w, all[0]);
            go_on(w, 0, 2, false);
        }
        look_for_needed(w);
        tumble_world_free(w);
    }
    for (int k = 0; k < places; k++) {
        needed += is_needed[k];
        if (!is_needed[k])
            fprintf(stderr, "not needed: tumble_world_load + %td\n",
                    (const char *)place[k]
                    - (const char *)(size_t)tumble_world_load);
    }
    ck_assert_int_eq(needed, places);
}
END_TEST

int main(void)
{
    mallopt(M_PERTURB, 0xa5);
    const TTest *const tests[] = {
        what_spins_on_a_joint_goes_on_alike,
        what_is_loaded_is_saved_as_the_same_bytes,
        one_two_and_four_threads_go_on_alike,
        cloth_that_is_kept_from_crossing_goes_on_alike_by_any_threads,
        what_a_program_holds_is_good_afterwards,
        a_box_in_a_heap_takes_six_kilobytes,
        an_empty_world_can_be_saved,
        bytes_that_were_cut_or_altered_are_refused,
        too_little_room_is_told_and_not_overrun,
        where_memory_runs_out_nothing_is_loaded_and_nothing_lost,
        a_state_that_is_put_back_again_asks_for_no_memory,
        what_was_put_back_is_saved_as_the_same_bytes,
        where_memory_runs_out_a_world_stays_as_it_was,
        what_reads_garbage_for_a_table_goes_elsewhere,
        NULL
    };
    return suite_run((suite){
        .name = "tumble_world_save", .tests = tests, .seconds = 120,
        .repeated = { { a_loaded_world_goes_on_with_the_same_bits, 0, WORLDS },
                      { also_where_all_bounces, 0, WORLDS },
                      { bodies_come_and_go_and_are_pushed_alike, 0, WORLDS } }
    });
}
