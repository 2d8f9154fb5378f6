// check_tumble_steer.c - tests of lib/tumble.h: what a program asks of many
// bodies, and how it steers them.

#include "random.h"
#include "suite.h"
#include "tumble.h"

#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double fine = 1e-9;

static void near(double got, double wanted, double tolerance)
{
    ck_assert_msg(fabs(got - wanted) <= tolerance, "got %.17g, wanted %.17g",
                  got, wanted);
}

static void near_vec3(tumble_vec3 got, double x, double y, double z,
                      double tolerance)
{
    near(got.x, x, tolerance);
    near(got.y, y, tolerance);
    near(got.z, z, tolerance);
}

static void expect_failure(tumble_world *w, const char *part)
{
    const char *why = tumble_failure(w);
    ck_assert_ptr_nonnull(why);
    ck_assert_msg(strstr(why, part) != NULL, "said: %s\nwanted: %s", why, part);
    tumble_forget_failure(w);
}

static void expect_fine(const tumble_world *w)
{
    const char *why = tumble_failure(w);
    ck_assert_msg(why == NULL, "failed: %s", why);
}

static tumble_world *weightless(void)
{
    tumble_options o = tumble_options_default();
    o.gravity = tumble_v(0, 0, 0);
    tumble_world *w = tumble_make(&o);
    ck_assert_ptr_nonnull(w);
    return w;
}

static tumble_world *with_floor(void)
{
    tumble_world *w = tumble_make(NULL);
    ck_assert_ptr_nonnull(w);
    ck_assert(tumble_add_plane(w, tumble_v(0, 1, 0), 0, -1).generation > 0);
    return w;
}

static void run(tumble_world *w, double seconds)
{
    int steps = (int)(seconds * 60 + 0.5);
    for (int k = 0; k < steps; k++) tumble_step(w);
}

static tumble_body add_box(tumble_world *w, double x, double y, double z)
{
    return tumble_add(w, tumble_box(w, tumble_v(1, 1, 1), 2),
                      tumble_at(x, y, z));
}

static tumble_body add_kind(tumble_world *w, tumble_kind kind, double x,
                            double y, double z)
{
    tumble_body_options o = tumble_at(x, y, z);
    o.kind = kind;
    return tumble_add(w, tumble_box(w, tumble_v(1, 1, 1), 2), o);
}

static bool is_same(tumble_body a, tumble_body b)
{
    return a.place == b.place && a.generation == b.generation;
}

// A world that was saved and loaded.
static tumble_world *copied(const tumble_world *w)
{
    size_t size = tumble_save(w, NULL, 0);
    void *bytes = malloc(size);
    ck_assert_ptr_nonnull(bytes);
    ck_assert_uint_eq(tumble_save(w, bytes, size), size);
    tumble_world *copy = tumble_load(bytes, size);
    ck_assert_msg(copy != NULL, "%s", tumble_failure(NULL));
    free(bytes);
    return copy;
}

// It goes on as w does.
static void goes_on_alike(tumble_world *w, int steps)
{
    tumble_world *copy = copied(w);
    for (int k = 0; k < steps; k++) {
        tumble_step(w);
        tumble_step(copy);
        ck_assert_uint_eq(tumble_hash(w), tumble_hash(copy));
    }
    tumble_free(copy);
}

// --- Many at once ------------------------------------------------------------
START_TEST(many_poses_are_those_of_each)
{
    enum { N = 40 };
    tumble_world *w = with_floor();
    tumble_body b[N + 1];
    for (int k = 0; k < N; k++) b[k] = add_box(w, k % 3, 1 + 1.1 * k, k % 2);
    b[N] = (tumble_body){ 0, 0 };
    tumble_remove(w, b[7]);
    run(w, 0.5);
    tumble_pose pose[N + 1];
    tumble_vec3 velocity[N + 1], spin[N + 1];
    tumble_get_poses(w, b, N + 1, pose);
    tumble_get_velocities(w, b, N + 1, velocity, NULL);
    tumble_get_velocities(w, b, N + 1, NULL, spin);
    for (int k = 0; k <= N; k++) {
        tumble_pose p = tumble_get_pose(w, b[k]);
        tumble_vec3 v = tumble_velocity(w, b[k]), s = tumble_spin(w, b[k]);
        ck_assert(memcmp(&p, &pose[k], sizeof p) == 0);
        ck_assert(memcmp(&v, &velocity[k], sizeof v) == 0);
        ck_assert(memcmp(&s, &spin[k], sizeof s) == 0);
        ck_assert((pose[k].rotation.w == 0) == (k == 7 || k == N));
    }
    expect_fine(w);
    tumble_free(w);
}
END_TEST

static bool has_moved(const tumble_world *w, tumble_body b)
{
    tumble_body moved[64];
    int n = tumble_moved(w, moved, 64);
    ck_assert_int_le(n, 64);
    bool found = false;
    for (int k = 0; k < n; k++) found |= is_same(moved[k], b);
    return found;
}

// All that are not named stand where they stood, to the bit, and a pile that has
// fallen asleep is named no more.
START_TEST(what_is_not_said_to_have_moved_has_not)
{
    enum { N = 24 };
    tumble_world *w = with_floor();
    tumble_body b[N];
    int most = 0, least = N;
    for (int k = 0; k < N - 3; k++)
        b[k] = add_box(w, 3 * (k % 7), 0.5 + 1.001 * (k / 7), 0);
    b[N - 3] = add_kind(w, TUMBLE_STATIC, 0, 0, 20);
    b[N - 2] = add_kind(w, TUMBLE_KINEMATIC, 0, 0, 40);
    b[N - 1] = tumble_add(w, tumble_rope(w, 8, 2, 1), tumble_at(0, 1, 60));
    ck_assert_int_eq(tumble_moved(w, NULL, 0), 0);
    for (int step = 0; step < 600; step++) {
        tumble_vec3 was[N], is[N];
        if (step == 300)
            tumble_set_velocity(w, b[N - 2], tumble_v(0, 0, 1),
                                tumble_v(0, 0, 0));
        for (int k = 0; k < N; k++) was[k] = tumble_vertex(w, b[k], 0);
        tumble_step(w);
        int n = tumble_moved(w, NULL, 0);
        most = n > most ? n : most;
        least = n < least ? n : least;
        for (int k = 0; k < N; k++) {
            is[k] = tumble_vertex(w, b[k], 0);
            if (!has_moved(w, b[k]))
                ck_assert(memcmp(&is[k], &was[k], sizeof *is) == 0);
        }
        ck_assert(!has_moved(w, b[N - 3]));
        ck_assert_int_eq(has_moved(w, b[N - 2]), step >= 300);
    }
    ck_assert_int_eq(most, N - 2);
    ck_assert_int_eq(least, 0);
    ck_assert_int_eq(tumble_moved(w, NULL, 0), 1);
    tumble_free(w);
}
END_TEST

// --- Joined bodies that meet ---------------------------------------------------
// A door before a wall, hinged a tenth of a metre away from its own side and from
// the wall's.  When it has swung down it leans on the wall with its lower corner,
// as far behind the hinge's line as it was before it: so it has turned by a
// quarter, and twice the angle under which the hinge sees that tenth.
static double place_after(bool asked, bool given_back, tumble_world **left)
{
    tumble_world *w = tumble_make(NULL);
    tumble_body_options o = tumble_at(0, -1, 0);
    o.kind = TUMBLE_STATIC;
    tumble_body wall = tumble_add(w, tumble_box(w, tumble_v(1, 3, 1), 1), o);
    tumble_body door = add_box(w, 1.2, 1.2, 0);
    tumble_joint j = tumble_hinge(w, wall, door, tumble_v(0.6, 0.6, 0),
                                  tumble_v(0, 0, 1));
    ck_assert(!tumble_may_touch(w, j));
    if (asked) ck_assert(tumble_set_touching(w, j, true));
    ck_assert_int_eq(tumble_may_touch(w, j), asked);
    tumble_push(w, door, tumble_v(0.5, 0, 0), tumble_v(1.2, 1.7, 0));
    run(w, 1);
    if (given_back) ck_assert(tumble_set_touching(w, j, false));
    double least = 0;
    for (int k = 0; k < 240; k++) {
        tumble_step(w);
        double place = tumble_joint_place(w, j);
        least = place < least ? place : least;
    }
    expect_fine(w);
    *left = w;
    return least;
}

START_TEST(a_door_stops_at_its_wall_if_it_may_touch_it)
{
    const double tenth = asin(0.1 / sqrt(1.22)), quarter = acos(0);
    tumble_world *w;
    near(place_after(true, false, &w), -quarter - 2 * tenth, 2e-3);
    goes_on_alike(w, 30);
    tumble_free(w);
    ck_assert(place_after(false, false, &w) < -2.2);
    tumble_free(w);
    ck_assert(place_after(true, true, &w) < -2.2);
    ck_assert(!tumble_set_touching(w, (tumble_joint){ 9, 1 }, true));
    expect_failure(w, "joint 9 is gone");
    ck_assert(!tumble_may_touch(w, (tumble_joint){ 9, 1 }));
    tumble_free(w);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        many_poses_are_those_of_each,
        what_is_not_said_to_have_moved_has_not,
        a_door_stops_at_its_wall_if_it_may_touch_it,
        NULL
    };
    return suite_run((suite){ .name = "steer", .tests = tests, .seconds = 60 });
}
