// check_rooms.c - what is thrown in closed rooms, through tumble.h: however often it
// would cross the room in a step, it stays inside.  Book: chapters 15, 18.

#include "tumble.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <math.h>
#include <stdbool.h>

enum { COLUMNS = 9, THROWN = 8, STEPS = 8 };

typedef enum { BOXES, PIECES, TERRAIN, ROOMS } room_kind;

// Six boxes, or the ground and five boxes.
static void build(tumble_world *w, room_kind kind, double half, double thick)
{
    static const double ground[COLUMNS * COLUMNS];
    tumble_shape wall[6];
    tumble_pose at[6];
    double width = 2 * (half + thick);
    for (int k = 0; k < 6; k++) {
        double side[3] = { width, width, width }, center[3] = { 0, 0, 0 };
        side[k / 2] = thick;
        center[k / 2] = (k % 2 ? -1 : 1) * (half + thick / 2);
        tumble_body_options o = tumble_body_at(center[0], center[1], center[2]);
        o.kind = TUMBLE_STATIC;
        at[k] = o.pose;
        wall[k] = tumble_shape_box(w, tumble_v(side[0], side[1], side[2]), 1);
        if (kind == BOXES || (kind == TERRAIN && k != 3))
            tumble_body_add(w, wall[k], o);
    }
    if (kind == PIECES)
        tumble_body_add_pieces(w, wall, at, 6, tumble_body_at(0, 0, 0));
    if (kind == TERRAIN)
        tumble_body_add_heights(w, ground, COLUMNS, COLUMNS, width, width, thick,
                                tumble_body_at(0, -half, 0));
}

static tumble_shape thing(tumble_world *w, int kind, double size)
{
    if (kind == 0) return tumble_shape_sphere(w, size, 1);
    if (kind == 1) return tumble_shape_capsule(w, size, size / 2, 1);
    return tumble_shape_box(w, tumble_v(1.2 * size, size, 0.8 * size), 1);
}

static tumble_vec3 any_way(unsigned long long *r, double speed)
{
    vec3 v = random_vec3(r, speed);
    return tumble_v(v.x, v.y, v.z);
}

typedef struct {
    double size, speed, dt, restitution, thick;     // m, m/s, s, 1, m
    room_kind room;
    int kind, thrown;
} throwing;

// In a room of ten sizes each way, or twenty.
static int count_lost(throwing t, unsigned long long seed)
{
    tumble_options options = tumble_options_default();
    tumble_body b[THROWN];
    double half = t.thrown > 1 ? 10 * t.size : 5 * t.size;
    int lost = 0;
    options.dt = t.dt;
    options.restitution = t.restitution;
    tumble_world *w = tumble_world_make(&options);
    build(w, t.room, half, t.thick);
    tumble_shape s = thing(w, t.kind, t.size);
    for (int k = 0; k < t.thrown; k++) {
        double far = t.thrown > 1 ? half / 2 : 0;
        tumble_body_options o = tumble_body_at(
            k & 1 ? far : -far, k & 2 ? far : -far, k & 4 ? far : -far);
        o.velocity = any_way(&seed, t.speed);
        o.spin = any_way(&seed, 0.1 * t.speed / t.size);
        b[k] = tumble_body_add(w, s, o);
    }
    for (int n = 0; n < STEPS; n++) tumble_world_step(w);
    for (int k = 0; k < t.thrown; k++) {
        tumble_vec3 x = tumble_body_position(w, b[k]);
        double far = fmax(fabs(x.x), fmax(fabs(x.y), fabs(x.z)));
        lost += !(far <= half);
    }
    ck_assert_ptr_null(tumble_world_failure(w));
    tumble_world_free(w);
    return lost;
}

// Rejects: contacts of where bodies would have gone, had nothing been in their way;
// a last look that sees only what these contacts are of, or each wall once.
START_TEST(closed_room_keeps_what_is_thrown_in_it)
{
    static const double size[] = { 0.01, 0.1, 1 }, speed[] = { 30, 300, 1000 },
                        step[] = { 1.0 / 30, 1.0 / 60, 1.0 / 240 },
                        thick[] = { 0.03, 0.1, 1 };
    for (int k = 0; k < 9 * ROOMS; k++) {
        throwing t = { size[k % 3], speed[k / 3 % 3], step[(k + k / 3) % 3],
                       k % 4 / 2.0, thick[k % 7 % 3], k / 9, k % 5 % 3,
                       k % 2 ? THROWN : 1 };
        if (t.restitution > 1) t.restitution = 1;
        for (int n = 0; n < 3; n++) {
            int lost = count_lost(t, (unsigned long long)(3 * k + n));
            ck_assert_msg(lost == 0, "room %d, thing %d of %g m, %g m/s, %g s: "
                          "%d of %d are out", t.room, t.kind, t.size, t.speed,
                          t.dt, lost, t.thrown);
        }
    }
}
END_TEST

// Rejects: a wall that is found only when the ball is through, which stops it.
START_TEST(ball_that_crosses_a_room_in_each_part_of_a_step_bounces_on)
{
    tumble_options options = tumble_options_default();
    options.restitution = 1;
    options.friction = 0;
    for (unsigned long long seed = 1; seed <= 10; seed++) {
        unsigned long long state = seed;
        tumble_world *w = tumble_world_make(&options);
        build(w, seed % 2 ? BOXES : PIECES, 0.5, 0.03);
        tumble_shape s = tumble_shape_sphere(w, 0.1, 1);
        tumble_body_options o = tumble_body_at(0, 0, 0);
        o.velocity = any_way(&state, 150);
        tumble_body_add(w, s, o);
        double before = tumble_world_measure(w).kinetic;
        for (int n = 0; n < STEPS; n++) tumble_world_step(w);
        double after = tumble_world_measure(w).kinetic;
        ck_assert_msg(fabs(after / before - 1) < 0.01, "%g of %g J", after, before);
        tumble_world_free(w);
    }
}
END_TEST

static bool never(void *context, const tumble_contact *c)
{
    (void)c;
    ++*(int *)context;
    return false;
}

// Rejects: a wall that a program does not want, found again after an impact with the
// ground.
START_TEST(program_that_wants_no_wall_lets_all_of_them_pass)
{
    tumble_world *w = tumble_world_make(NULL);
    unsigned long long seed = 1;
    int asked = 0;
    build(w, BOXES, 0.5, 0.03);
    tumble_world_choose_contacts(w, never, &asked);
    tumble_shape s = tumble_shape_sphere(w, 0.1, 1);
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.velocity = any_way(&seed, 300);
    tumble_body b = tumble_body_add(w, s, o);
    for (int n = 0; n < STEPS; n++) tumble_world_step(w);
    tumble_vec3 v = tumble_body_velocity(w, b);
    ck_assert_int_gt(asked, 0);
    ck_assert_double_eq_tol(v.x, o.velocity.x, 1e-9);
    ck_assert_double_eq_tol(v.z, o.velocity.z, 1e-9);
    tumble_world_free(w);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        closed_room_keeps_what_is_thrown_in_it,
        ball_that_crosses_a_room_in_each_part_of_a_step_bounces_on,
        program_that_wants_no_wall_lets_all_of_them_pass,
        NULL
    };
    return suite_run((suite){ .name = "rooms", .tests = tests, .seconds = 60 });
}
