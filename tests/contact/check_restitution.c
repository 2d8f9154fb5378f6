// check_restitution.c - do bodies part as fast as they should, and no faster?
// Book: chapter 15.

#include <check.h>
#include <string.h>

#include "restitution.h"
#include "expect.h"
#include "plain_impact.h"
#include "random.h"
#include "suite.h"

// A few roundings of sums of numbers near the largest.
#define ROUNDING 1e-13

enum { MOST = 32 };

// --- chance ------------------------------------------------------------------

static unsigned long long seed;

// Between 10^-n and 10^n, all powers alike.
static real any_size(real n)
{
    return exp(n * random_real(&seed) * log(10));
}

// --- a world of a few bodies -------------------------------------------------

static solver_body body[MOST];
static rigid4 plan[MOST];
static vec3 origin[MOST];       // where they began
static plane wall[6];
static contact made[4 * MOST];
static const contact *table[4 * MOST];
static motion velocity[MOST + 1], moved[MOST + 1];
static int bodies, contacts;
static solver_frame frame;
static vec3 gravity;

static void begin(real h)
{
    bodies = contacts = 0;
    memset(velocity, 0, sizeof velocity);
    memset(moved, 0, sizeof moved);
    gravity = vec3_make(0, 0, 0);
    frame = (solver_frame){ .body = body, .plane = wall, .h = h };
}

static void set_up(void)
{
    begin(0.01);
}

// A body with these moments of inertia about x, y and z; mass HUGE_VAL: it does
// not move.
static int add(vec3 at, real mass, vec3 inertia, real radius)
{
    solver_body *b = &body[bodies];
    rigid4 *f = &plan[bodies];
    const real moment[TURNS] = { inertia.x, inertia.y, inertia.z };
    *b = (solver_body){ .radius = radius, .frame = { .center = at,
        .axis = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } } };
    *f = (rigid4){ .mass = mass / FOUR };
    for (int t = 0; t < TURNS; t++) {
        f->per_length[t] = 1;
        f->root[t] = sqrt(moment[t]);
        f->inverse[t] = 1 / moment[t];
        f->turn[t] = 1 / f->root[t];
    }
    for (int t = 0, next = 1; t < TURNS; t++, next = (next + 1) % TURNS) {
        int best = (f->alike + 1) % TURNS;
        if (fabs(f->inverse[t] - f->inverse[next])
            < fabs(f->inverse[f->alike] - f->inverse[best])) f->alike = t;
    }
    if (mass < HUGE_VAL) b->basis = basis_find(f, &b->frame);
    origin[bodies] = at;
    frame.bodies = ++bodies;
    return bodies - 1;
}

// A ball of radius r, filled evenly.
static int add_ball(vec3 at, real mass, real r)
{
    real i = 0.4 * mass * r * r;
    return add(at, mass, vec3_make(i, i, i), r);
}

static void set_velocity(int b, vec3 v)
{
    velocity[b].of[0] = v.x;
    velocity[b].of[1] = v.y;
    velocity[b].of[2] = v.z;
}

static vec3 velocity_of(int b)
{
    const real *u = velocity[b].of;
    return vec3_make(u[0], u[1], u[2]);
}

static vec3 moved_of(int b)
{
    const real *d = moved[b].of;
    vec3 way = vec3_sub(body[b].frame.center, origin[b]);
    return vec3_add(way, vec3_make(d[0], d[1], d[2]));
}

static vec3 spin_of(int b)
{
    return motion_rotation(&body[b].basis, &velocity[b]);
}

static contact *add_contact(int a, int b, vec3 normal)
{
    contact *c = &made[contacts];
    *c = (contact){ .a = a, .b = b, .normal = normal };
    table[contacts++] = c;
    return c;
}

// Points given from the centres.
static void add_point(contact *c, vec3 arm_a, vec3 arm_b)
{
    c->point[c->count++] = (contact_point){ .local_a = arm_a, .local_b = arm_b,
                                            .own = 1 };
}

// Their cores are their centres: they touch wherever they meet.
static void join_balls(int a, int b)
{
    const vec3 core = { 0, 0, 0 };
    vec3 n = vec3_unit(vec3_sub(body[a].frame.center, body[b].frame.center));
    contact *c = add_contact(a, b, n);
    add_point(c, core, core);
    c->round_a = body[a].radius;
    c->round_b = body[b].radius;
}

static void put_on_floor(int b)
{
    const vec3 up = { 0, 1, 0 }, core = { 0, 0, 0 };
    contact *c = add_contact(b, contact_with_plane(0), up);
    wall[0] = (plane){ .normal = up, .offset = 0 };
    add_point(c, core, core);
    c->round_a = body[b].radius;
}

static int solve(real restitution)
{
    frame.restitution = restitution;
    frame.gravity = gravity;
    return restitution_solve(table, contacts, &frame, body, velocity, moved);
}

static void fall(void)
{
    for (int b = 0; b < bodies; b++)
        if (body[b].basis.inverse_mass > 0)
            set_velocity(b, vec3_add_scaled(velocity_of(b), frame.h, gravity));
}

static void advance(void)
{
    for (int b = 0; b < bodies; b++)
        for (int k = 0; k < MOTIONS; k++)
            moved[b].of[k] += frame.h * velocity[b].of[k];
}

// A substep with the solver in it: n says which.
static contact_solver solver;

static int substep_with_solver(int n, real restitution)
{
    int impacts = solve(restitution);
    if (n == 0) {
        real far[4 * MOST];
        for (int k = 0; k < contacts; k++) far[k] = 100;
        ck_assert(solver_activate(&solver, &frame, table, far, contacts));
        ck_assert(solver_prepare(&solver, &frame, table));
    }
    if (impacts > 0) solver_renew(&solver, &frame);
    if (impacts > 0) solver_update_gaps(&solver, &frame, moved);
    solver_warm(&solver, &frame, velocity);
    solver_push(&solver, &frame, velocity, moved);
    advance();
    solver_relax(&solver, &frame, velocity, moved);
    return impacts;
}

static void expect_vec3(vec3 got, vec3 wanted, real tolerance)
{
    ck_assert_msg(vec3_distance(got, wanted) <= tolerance,
                  "got %g %g %g, wanted %g %g %g", got.x, got.y, got.z,
                  wanted.x, wanted.y, wanted.z);
}

// --- head on -----------------------------------------------------------------

// Momentum is kept, and u_a' - u_b' = -e (u_a - u_b): two equations for the two
// velocities.  Rejects: a mass for an inverse mass; e + 1 for e.
START_TEST(balls_that_meet_head_on_part_at_restitution_times_their_speed)
{
    const real e[] = { 0.01, 0.3, 0.5, 1 };
    for (int k = 0; k < 4; k++)
        for (real ratio = 1e-6; ratio < 2e6; ratio *= 10) {
            begin(0.01);
            add_ball(vec3_make(0, 0, 0), 1, 0.5);
            add_ball(vec3_make(1.01, 0, 0), ratio, 0.5);
            set_velocity(0, vec3_make(3, 0, 0));
            set_velocity(1, vec3_make(-1, 0, 0));
            join_balls(0, 1);
            ck_assert_int_eq(solve(e[k]), 1);
            real middle = (3 - ratio) / (1 + ratio);
            real apart = 4 * e[k] / (1 + ratio);
            expect_vec3(velocity_of(0), vec3_make(middle - ratio * apart, 0, 0),
                        20 * ROUNDING);
            expect_vec3(velocity_of(1), vec3_make(middle + apart, 0, 0),
                        20 * ROUNDING);
            expect_vec3(spin_of(0), vec3_make(0, 0, 0), 0);
        }
}
END_TEST

// A ball comes by, and its neighbour is at (far, 0, 0): when do two of radius 1/2
// meet, and along which normal then?  |far - v t| = 1.
static real meeting(vec3 v, real far, vec3 *normal)
{
    real vv = vec3_length_squared(v), b = far * v.x;
    real t = (b - sqrt(b * b - vv * (far * far - 1))) / vv;
    *normal = vec3_sub(vec3_scale(t, v), vec3_make(far, 0, 0));
    return t;
}

// They meet after a quarter of the substep, and have parted for three quarters
// when it ends; where they are then says along which normal.  Rejects: a touch
// at the start, or at the end, of a substep; the normal of its start.
START_TEST(bodies_go_on_from_where_they_meet)
{
    const vec3 v = { 4, 2, 0 };
    vec3 n;
    real t = meeting(v, 1.01, &n), j = 1.5 * -vec3_dot(v, n) / (1 + 1.0 / 3);
    vec3 v_a = vec3_add_scaled(v, j, n), v_b = vec3_scale(-j / 3, n);
    add_ball(vec3_make(0, 0, 0), 1, 0.5);
    add_ball(vec3_make(1.01, 0, 0), 3, 0.5);
    set_velocity(0, vec3_make(4, 2, 0));
    join_balls(0, 1);
    ck_assert_int_eq(solve(0.5), 1);
    advance();
    vec3 way = vec3_add_scaled(vec3_scale(t, v), 0.01 - t, v_a);
    expect_vec3(velocity_of(0), v_a, 10 * ROUNDING);
    expect_vec3(velocity_of(1), v_b, 10 * ROUNDING);
    expect_vec3(moved_of(0), way, ROUNDING);
    expect_vec3(moved_of(1), vec3_scale(0.01 - t, v_b), ROUNDING);
}
END_TEST

// What overlaps already touches when the substep begins, and parts all through
// it.  Rejects: a touch before that.
START_TEST(bodies_that_overlap_strike_at_once)
{
    add_ball(vec3_make(0, 0, 0), 1, 0.5);
    add_ball(vec3_make(0.99, 0, 0), 3, 0.5);
    set_velocity(0, vec3_make(4, 0, 0));
    join_balls(0, 1);
    ck_assert_int_eq(solve(0.5), 1);
    expect_vec3(moved_of(0), vec3_make(0, 0, 0), 0);
    expect_vec3(moved_of(1), vec3_make(0, 0, 0), 0);
    expect_vec3(velocity_of(1), vec3_make(1.5, 0, 0), ROUNDING);
}
END_TEST

// What is already moved in this frame counts.  Rejects: a gap that is always
// that of the frame's start.
START_TEST(gap_is_that_of_now)
{
    add_ball(vec3_make(0, 0, 0), 1, 0.5);
    add_ball(vec3_make(1.5, 0, 0), 1, 0.5);
    set_velocity(0, vec3_make(4, 0, 0));
    join_balls(0, 1);
    ck_assert_int_eq(solve(1), 0);
    moved[0].of[0] = 0.49;
    ck_assert_int_eq(solve(1), 1);
    expect_vec3(velocity_of(0), vec3_make(0, 0, 0), ROUNDING);
    expect_vec3(velocity_of(1), vec3_make(4, 0, 0), ROUNDING);
}
END_TEST

// Rejects: bodies that strike from afar, or as they part; in a substep that
// would not bring them together.
START_TEST(bodies_that_do_not_touch_in_this_substep_do_not_strike)
{
    add_ball(vec3_make(0, 0, 0), 1, 0.5);
    add_ball(vec3_make(1.05, 0, 0), 1, 0.5);
    join_balls(0, 1);
    const real speed[] = { -5, -1e-3, 0, 1, 4.9 };
    for (int k = 0; k < 5; k++) {
        set_velocity(0, vec3_make(speed[k], 0, 0));
        ck_assert_int_eq(solve(1), 0);
        ck_assert(velocity[0].of[0] == speed[k] && moved[0].of[0] == 0);
    }
    set_velocity(0, vec3_make(5.1, 0, 0));
    ck_assert_int_eq(solve(1), 1);
}
END_TEST

// Rejects: bodies at rest that gravity lets bounce on for ever.
START_TEST(slow_bodies_do_not_bounce)
{
    real slowest = material_slowest(9.81, 0.001);
    near(slowest, 2 * 9.81 * 0.001, ROUNDING);
    ck_assert(material_slowest(0, 0.1) == 0);
    for (int k = 0; k < 2; k++) {
        begin(0.001);
        gravity = vec3_make(0, -9.81, 0);
        add_ball(vec3_make(0, 0.5, 0), 1, 0.5);
        put_on_floor(0);
        // It touches at once, half a substep before its velocity.
        real half = 9.81 * 0.0005, speed = slowest + (k ? half : 0.9 * half);
        set_velocity(0, vec3_make(0, -speed * (1 + ROUNDING), 0));
        ck_assert_int_eq(solve(1), k);
    }
}
END_TEST

// Rejects: a normal of before, along which what parts would be held; one that a
// capsule, which has a core, gets as well.
START_TEST(only_balls_face_each_other_where_they_come)
{
    for (int is_ball = 0; is_ball < 2; is_ball++) {
        begin(0.01);
        add_ball(vec3_make(0, 0, 0), 1, 0.5);
        add_ball(vec3_make(1.01, 0, 0), 1, 0.5);
        set_velocity(0, vec3_make(2, -3, 0));
        set_velocity(1, vec3_make(0, 4, 1));
        moved[1].of[1] = 0.25;
        join_balls(0, 1);
        contact *c = &made[0];
        vec3 was = c->normal, way = { 0.02 - 1.01, -0.03 - 0.25 - 0.04, -0.01 };
        if (!is_ball) c->point[0].local_a.x = 0.1;
        ck_assert(restitution_face(c, &frame, velocity, moved) == is_ball);
        expect_vec3(c->normal, is_ball ? vec3_unit(way) : was, ROUNDING);
    }
}
END_TEST

// Two balls that slide past each other, and do not strike: the second goes across by
// .03 or .2 m, where their centres are 1.01 m apart.  Rejects: one impact for which all
// balls are faced; an old normal that is kept however far they come around each other.
START_TEST(balls_that_do_not_strike_are_faced_when_they_have_come_around)
{
    for (int is_far = 0; is_far < 2; is_far++) {
        begin(0.01);
        add_ball(vec3_make(0, 0, 0), 1, 0.5);
        add_ball(vec3_make(1.01, 0, 0), 1, 0.5);
        set_velocity(1, vec3_make(0, is_far ? 20 : 3, 0));
        join_balls(0, 1);
        frame.restitution = 0;
        ck_assert(restitution_face(&made[0], &frame, velocity, moved) == is_far);
    }
}
END_TEST

// Rejects: a large body that loses what it would bounce with.
START_TEST(size_does_not_say_what_is_slow)
{
    for (real radius = 0.005; radius < 100; radius *= 10) {
        begin(0.001);
        gravity = vec3_make(0, -9.81, 0);
        add_ball(vec3_make(0, radius, 0), 1, radius);
        put_on_floor(0);
        set_velocity(0, vec3_make(0, -0.03, 0));
        ck_assert_int_eq(solve(1), 1);
    }
}
END_TEST

// Rejects: a contact that strikes only if its first body moves.
START_TEST(what_does_not_move_may_be_either_body)
{
    for (int k = 0; k < 2; k++) {
        begin(0.01);
        add_ball(vec3_make(0, 0, 0), k ? HUGE_VAL : 1, 0.5);
        add_ball(vec3_make(1.01, 0, 0), k ? 1 : HUGE_VAL, 0.5);
        set_velocity(k, vec3_make(k ? -4 : 4, 1, 0));
        join_balls(0, 1);
        ck_assert_int_eq(solve(0.5), 1);
        vec3 v = { 4, 1, 0 }, n;
        meeting(v, 1.01, &n);
        v = vec3_add_scaled(v, -1.5 * vec3_dot(v, n), n);
        if (k) v.x = -v.x;
        expect_vec3(velocity_of(k), v, 10 * ROUNDING);
        expect_vec3(velocity_of(1 - k), vec3_make(0, 0, 0), 0);
        expect_vec3(moved_of(1 - k), vec3_make(0, 0, 0), 0);
    }
}
END_TEST

// --- in gravity --------------------------------------------------------------

// J per kg, and m^2/s^2: of a fall whose velocity is that of the middle of a
// substep h.
static real energy_of_fall(int b)
{
    vec3 v = velocity_of(b);
    real middle = body[b].frame.center.y + moved[b].of[1] - v.y * frame.h / 2;
    return vec3_length_squared(v) / 2 - gravity.y * middle;
}

// Lets a ball go from 1 m above the floor, and follows it for n impacts: the
// energy after each is e^2 times that before, measured from the floor.
// The floor is a plane, or body A of the contact.
static void expect_bounces(real h, real e, int n, bool on_plane, real tolerance)
{
    begin(h);
    gravity = vec3_make(0, -9.81, 0);
    add_ball(vec3_make(0, 1.5, 0), 2, 0.5);
    if (on_plane) {
        put_on_floor(0);
    } else {
        add_ball(vec3_make(0, -1, 0), HUGE_VAL, 1);
        join_balls(1, 0);
    }
    real wanted = 9.81 - 9.81 * 9.81 * h * h / 8, floor = 9.81 * 0.5;
    real beside = 9.81 * 9.81 * h * h / 8;
    set_velocity(0, vec3_make(0, 9.81 * h / 2, 0));
    solver = (contact_solver){ .contacts = 0 };
    ck_assert(solver_grow(&solver, bodies));
    for (int k = 0, steps = 0; k < n; steps++) {
        ck_assert_int_lt(steps, 1000000);
        fall();
        int hit = substep_with_solver(steps, e);
        ck_assert_int_le(hit, 1);
        if (!hit) continue;
        k++;
        wanted = (wanted + beside) * e * e - beside;
        near(energy_of_fall(0) - floor, wanted, tolerance);
    }
    solver_free(&solver);
}

// Rejects: a fall that is taken to be straight within the substep; a rebound
// that begins at the wrong height; a solver that brakes what will bounce.
START_TEST(ball_comes_back_to_the_square_of_its_restitution)
{
    const real h[] = { 1.0 / 60, 1.0 / 240, 1.0 / 487, 1e-4 };
    for (int k = 0; k < 4; k++) {
        expect_bounces(h[k], 1, k < 3 ? 100 : 10, true, 1e-10);
        expect_bounces(h[k], 0.9, 8, true, 1e-10);
        expect_bounces(h[k], 0.9, 8, false, 1e-10);
        expect_bounces(h[k], 0.5, 1, true, 1e-10);
    }
}
END_TEST

// Both fall alike, so nothing is added to the speed at which they meet.
// Rejects: gravity that is counted for one of two.
START_TEST(what_falls_together_meets_at_the_speed_that_it_has)
{
    gravity = vec3_make(0, -9.81, 0);
    add_ball(vec3_make(0, 1.01, 0), 1, 0.5);
    add_ball(vec3_make(0, 0, 0), 1, 0.5);
    set_velocity(0, vec3_make(0, -8, 0));
    set_velocity(1, vec3_make(0, -3, 0));
    join_balls(0, 1);
    ck_assert_int_eq(solve(1), 1);
    expect_vec3(velocity_of(0), vec3_make(0, -3, 0), ROUNDING);
    expect_vec3(velocity_of(1), vec3_make(0, -8, 0), 2 * ROUNDING);
}
END_TEST

// --- Newton's cradle ---------------------------------------------------------

// Contacts in any order.  Rejects: an impact that is passed on in the next
// substep only, or not at all.
START_TEST(cradle_passes_on_as_many_balls_as_come)
{
    enum { BALLS = 5 };
    for (int come = 1; come < BALLS; come++)
        for (int order = 0; order < 2 * BALLS; order++) {
            begin(0.01);
            for (int b = 0; b < BALLS; b++) {
                bool moves = b < come;
                add_ball(vec3_make(moves ? b - 0.015 : b, 0, 0), 1, 0.5);
                set_velocity(b, vec3_make(moves ? 2 : 0, 0, 0));
            }
            for (int k = 0; k < BALLS - 1; k++) {
                int b = (k + order) % (BALLS - 1);
                if (order >= BALLS) b = BALLS - 2 - b;
                join_balls(b, b + 1);
            }
            solve(1);
            advance();
            for (int b = 0; b < BALLS; b++) {
                bool goes = b >= BALLS - come;
                expect_vec3(velocity_of(b), vec3_make(goes ? 2 : 0, 0, 0),
                            10 * ROUNDING);
                real way = goes ? 2 * 0.0025 : 0;
                if (b < come) way += 0.015;
                expect_vec3(moved_of(b), vec3_make(way, 0, 0), 10 * ROUNDING);
            }
        }
}
END_TEST

static real energy_of_all(void)
{
    real sum = 0;
    for (int b = 0; b < bodies; b++)
        sum += motion_energy(&body[b].basis, &velocity[b]);
    return sum;
}

// A row of balls of many masses between two walls, for 20 s: each is
// hit from both sides, often in one substep.  Rejects: a solver that takes part
// of an impact, or goes by the gaps of before.
START_TEST(row_between_walls_keeps_its_energy)
{
    enum { BALLS = 6 };
    int hits = 0;
    seed = 9;
    frame.h = 0.001;
    frame.hertz = 60;
    frame.damping = 10;
    frame.max_rate = 3;
    for (int b = 0; b < BALLS + 2; b++) {
        bool is_wall = b == 0 || b == BALLS + 1;
        add_ball(vec3_make(1.1 * b, 0, 0), is_wall ? HUGE_VAL : any_size(0.5),
                 0.5);
        if (!is_wall) set_velocity(b, vec3_make(3 * random_real(&seed), 0, 0));
        if (b > 0) join_balls(b - 1, b);
    }
    real before = energy_of_all();
    solver = (contact_solver){ .contacts = 0 };
    ck_assert(solver_grow(&solver, bodies));
    for (int n = 0; n < 20000; n++) hits += substep_with_solver(n, 1);
    solver_free(&solver);
    ck_assert_int_ge(hits, 1000);
    near(energy_of_all(), before, 1e-9 * before);
    for (int b = 0; b <= BALLS; b++)
        ck_assert(moved_of(b + 1).x - moved_of(b).x >= -0.1 - 1e-6);
}
END_TEST

// Rejects: rounds without end.
START_TEST(rounds_are_bounded)
{
    // A ball between two walls that are nearer than it is wide.
    add_ball(vec3_make(0, 0, 0), 1, 0.5);
    add_ball(vec3_make(-0.9, 0, 0), HUGE_VAL, 0.5);
    add_ball(vec3_make(0.9, 0, 0), HUGE_VAL, 0.5);
    set_velocity(0, vec3_make(1, 0, 0));
    join_balls(0, 1);
    join_balls(0, 2);
    ck_assert_int_eq(solve(1), CONTACT_ROUNDS);
    near(fabs(velocity[0].of[0]), 1, ROUNDING);
}
END_TEST

// Speeds of 1, 0.2 and 0.04 m/s: the third is not worth a round.  Rejects: bodies
// that are wedged, and cost all rounds of every substep.
START_TEST(what_is_passed_on_ends_with_a_tenth_of_the_blow)
{
    add_ball(vec3_make(0, 0, 0), 1, 0.5);
    add_ball(vec3_make(-0.9, 0, 0), HUGE_VAL, 0.5);
    add_ball(vec3_make(0.9, 0, 0), HUGE_VAL, 0.5);
    set_velocity(0, vec3_make(1, 0, 0));
    join_balls(0, 1);
    join_balls(0, 2);
    ck_assert_int_eq(solve(0.2), 2);
    near(velocity[0].of[0], 0.04, ROUNDING);
}
END_TEST

// --- friction ----------------------------------------------------------------

// A ball comes down at 4 m/s and goes along at v: the normal impulse is
// N = (1 + e) 4 m.  If mu N is too little to stop the sliding of the point that
// touches, it is what friction gives: v' = v - mu N / m, and the spin
// 5/2 mu N / (m r).  Else the point stops: v' = 5/7 v, and the ball rolls.
// Rejects: friction of the normal impulse without restitution; with the mass of
// the ball for that of its point; a spin of the other sign.
START_TEST(ball_with_friction_leaves_as_the_closed_form_says)
{
    const real mu[] = { 0, 0.1, 0.25, 1 }, e = 0.6, m = 3, r = 0.5;
    for (int k = 0; k < 4; k++)
        for (real v = 0.5; v < 20; v *= 2) {
            begin(0.01);
            frame.friction = mu[k];
            add_ball(vec3_make(0, r + 0.02, 0), m, r);
            put_on_floor(0);
            set_velocity(0, vec3_make(0.6 * v, -4, 0.8 * v));
            ck_assert_int_eq(solve(e), 1);
            real slower = real_min(mu[k] * (1 + e) * 4, 2.0 / 7 * v);
            real left = v - slower, spin = 2.5 * slower / r;
            expect_vec3(velocity_of(0),
                        vec3_make(0.6 * left, 4 * e, 0.8 * left), 1e-12);
            expect_vec3(spin_of(0), vec3_make(0.8 * spin, 0, -0.6 * spin),
                        1e-12);
        }
}
END_TEST

// A face on a face: four points, loaded alike, with the lever l from their
// middle.  Twisting ends, or is braked by mu N l.  Rejects: an impact that lets
// a spinning top land as if it were of ice.
START_TEST(face_that_spins_is_braked)
{
    const real spin = 6, lever = sqrt(0.5), m = 3, i = 0.5;
    for (real mu = 0; mu < 0.2; mu += 0.05) {
        begin(0.01);
        frame.friction = mu;
        add(vec3_make(0, 0.5, 0), m, vec3_make(i, i, i), 1);
        contact *c = add_contact(0, contact_with_plane(0), vec3_make(0, 1, 0));
        for (int k = 0; k < 4; k++)
            add_point(c, vec3_make(k % 2 - 0.5, -0.5, k / 2 - 0.5),
                      vec3_make(0, 0, 0));
        wall[0] = (plane){ .normal = { 0, 1, 0 }, .offset = 0 };
        set_velocity(0, vec3_make(0, -2, 0));
        velocity[0].of[MOTION_TURN + 1] = spin * sqrt(i);
        ck_assert_int_eq(solve(0.5), 1);
        real brake = mu * 3 * m * lever / i;
        expect_vec3(velocity_of(0), vec3_make(0, 1, 0), ROUNDING);
        expect_vec3(spin_of(0), vec3_make(0, real_max(spin - brake, 0), 0),
                    ROUNDING);
    }
}
END_TEST

// --- several points ----------------------------------------------------------

static void add_flat_box(real gap, vec3 turn)
{
    add(vec3_make(0, 0.5 + gap, 0), 1, vec3_make(1.0 / 6, 1.0 / 6, 1.0 / 6), 0.87);
    contact *c = add_contact(0, contact_with_plane(0), vec3_make(0, 1, 0));
    for (int k = 0; k < 4; k++)
        add_point(c, vec3_make(k % 2 - 0.5, -0.5, k / 2 - 0.5),
                  vec3_make(0, 0, 0));
    wall[0] = (plane){ .normal = { 0, 1, 0 }, .offset = 0 };
    real root = sqrt(6);
    velocity[0] = (motion){ { 0, -4, 0, turn.x / root, turn.y / root,
                              turn.z / root } };
}

// Rejects: corners that strike one after the other, and leave the box turning.
START_TEST(box_that_lands_flat_leaves_flat)
{
    add_flat_box(0.01, vec3_make(0, 0, 0));
    ck_assert_int_eq(solve(0.5), 1);
    expect_vec3(velocity_of(0), vec3_make(0, 2, 0), ROUNDING);
    expect_vec3(spin_of(0), vec3_make(0, 0, 0), ROUNDING);
}
END_TEST

// Where all four touch, each corner parts at e times its own speed: then the box
// leaves turning the other way, e times as fast.  Rejects: one speed for all corners.
START_TEST(each_corner_parts_at_its_own_speed)
{
    add_flat_box(0, vec3_make(0.3, 0.7, -0.2));
    ck_assert_int_eq(solve(0.5), 1);
    expect_vec3(velocity_of(0), vec3_make(0, 2, 0), ROUNDING);
    expect_vec3(spin_of(0), vec3_make(-0.15, 0.7, 0.1), ROUNDING);
}
END_TEST

// A corner that strikes away from the centre: the impulse is
// (1 + e) c / (1/m + l^2 / i).  Rejects: the mass of the whole body.
START_TEST(eccentric_impact_turns_the_body)
{
    const real m = 2, i = 0.3, l = 0.4, e = 0.25;
    add(vec3_make(0, 0.51, 0), m, vec3_make(1, 1, i), 1);
    contact *c = add_contact(0, contact_with_plane(0), vec3_make(0, 1, 0));
    add_point(c, vec3_make(l, -0.5, 0), vec3_make(0, 0, 0));
    wall[0] = (plane){ .normal = { 0, 1, 0 }, .offset = 0 };
    set_velocity(0, vec3_make(0, -5, 0));
    ck_assert_int_eq(solve(e), 1);
    real j = (1 + e) * 5 / (1 / m + l * l / i);
    expect_vec3(velocity_of(0), vec3_make(0, j / m - 5, 0), 1e-12);
    expect_vec3(spin_of(0), vec3_make(0, 0, l * j / i), 1e-12);
    begin(0.01);
    add(vec3_make(0, 0.5, 0), m, vec3_make(1, 1, i), 1);
    c = add_contact(0, contact_with_plane(0), vec3_make(0, 1, 0));
    add_point(c, vec3_make(l, -0.5, 0), vec3_make(0, 0, 0));
    // The centre does not move: the corner alone comes down, at 5 m/s, and
    // touches where it is.
    velocity[0].of[MOTION_TURN + 2] = -5 / l * sqrt(i);
    ck_assert_int_eq(solve(e), 1);
    expect_vec3(velocity_of(0), vec3_make(0, j / m, 0), 1e-12);
    expect_vec3(spin_of(0), vec3_make(0, 0, l * j / i - 5 / l), 1e-12);
}
END_TEST

// --- whatever strikes whatever -----------------------------------------------

// Two bodies of any mass and inertia, points in one plane across the normal.
static vec3 any_inertia(real mass, real r)
{
    real x = any_size(0.5), y = any_size(0.5), z = any_size(0.5);
    return vec3_scale(mass * r * r, vec3_make(x, y, z));
}

static void any_pair(void)
{
    begin(0.01 * any_size(1));
    int points = 1 + (int)(2 + 2 * random_real(&seed));
    frame.friction = random_real(&seed) > 0 ? any_size(1) : 0;
    if (random_real(&seed) > 0)
        gravity = vec3_scale(10, random_direction(&seed));
    vec3 n = random_direction(&seed), middle = random_vec3(&seed, 1);
    vec3 across = vec3_unit(vec3_cross(n, random_direction(&seed)));
    vec3 aside = vec3_cross(n, across);
    for (int b = 0; b < 2; b++) {
        real mass = any_size(3), r = any_size(0.5);
        bool moves = b == 1 || random_real(&seed) < 0.7;
        vec3 inertia = any_inertia(mass, r);
        add(vec3_add_scaled(middle, r, random_direction(&seed)),
            moves ? mass : HUGE_VAL,
            inertia, r);
        for (int k = 0; k < MOTIONS && moves; k++)
            velocity[b].of[k] = 20 * random_real(&seed)
                * (k < 3 ? 1 : sqrt(mass) * r);
    }
    contact *c = add_contact(0, 1, n);
    for (int k = 0; k < points; k++) {
        vec3 at = vec3_add_scaled(middle, random_real(&seed), across);
        at = vec3_add_scaled(at, random_real(&seed), aside);
        add_point(c, vec3_sub(at, body[0].frame.center),
                  vec3_sub(at, body[1].frame.center));
    }
}

// Of the pair in the fall: constant but for the impact.
static real energy_of_pair(void)
{
    real sum = 0;
    for (int b = 0; b < 2; b++) {
        if (!(body[b].basis.inverse_mass > 0)) continue;
        vec3 middle = vec3_add_scaled(moved_of(b), frame.h / 2, velocity_of(b));
        sum += motion_energy(&body[b].basis, &velocity[b])
             - vec3_dot(gravity, middle) / body[b].basis.inverse_mass;
    }
    return sum;
}

static vec3 momentum_of_pair(void)
{
    vec3 sum = { 0, 0, 0 };
    for (int b = 0; b < 2; b++)
        sum = vec3_add_scaled(sum, 1 / body[b].basis.inverse_mass,
                              velocity_of(b));
    return sum;
}

// About the origin.
static vec3 angular_momentum_of_pair(void)
{
    vec3 sum = { 0, 0, 0 };
    for (int b = 0; b < 2; b++) {
        const motion_basis *x = &body[b].basis;
        sum = vec3_add_scaled(sum, 1 / x->inverse_mass,
                              vec3_cross(body[b].frame.center, velocity_of(b)));
        for (int t = 0; t < TURNS; t++)
            sum = vec3_add_scaled(sum, velocity[b].of[MOTION_TURN + t]
                / vec3_length_squared(x->turn[t]), x->turn[t]);
    }
    return sum;
}

static real scale_of_momentum(void)
{
    real sum = 0;
    for (int b = 0; b < 2; b++)
        sum += (vec3_length(velocity_of(b)) + vec3_length(spin_of(b)) * 100)
             / body[b].basis.inverse_mass * 10;
    return sum;
}

// Rejects: friction, or several points, that give energy (Kane's paradox);
// restitution 1 that takes some.
START_TEST(no_impact_gives_energy)
{
    int hits = 0, kept = 0;
    seed = 11;
    for (int round = 0; round < 20000; round++) {
        any_pair();
        real e = round % 3 == 0 ? 1 : random_fraction(&seed);
        real before = energy_of_pair(), size = fabs(before);
        for (int b = 0; b < 2; b++)
            size += motion_energy(&body[b].basis, &velocity[b]);
        int hit = solve(e);
        if (!hit) continue;
        hits++;
        real after = energy_of_pair();
        ck_assert_msg(after <= before + ROUNDING * size,
                      "round %d: %.17g, before %.17g", round, after, before);
        if (e < 1 || frame.friction > 0) continue;
        near(after, before, hit * ROUNDING * size);
        kept++;
    }
    ck_assert_int_ge(hits, 5000);
    ck_assert_int_ge(kept, 500);
}
END_TEST

// A body of three moments strikes a wall in the middle of a substep, and ends it as
// one does that flew freely to the wall, was struck there, and flew on.  Rejects: a
// body that is put back with its angular momentum, but not by its own flight: its
// energy would change with how it is turned.
START_TEST(struck_body_flies_freely_before_and_after)
{
    int hits = 0;
    seed = 15;
    for (int round = 0; round < 2000; round++) {
        begin(0.01);
        add(vec3_make(0, 0.03, 0), 1, vec3_make(0.1, 0.4, 0.45), 0.5);
        contact *c = add_contact(0, contact_with_plane(0), vec3_make(0, 1, 0));
        wall[0] = (plane){ .normal = { 0, 1, 0 }, .offset = 0 };
        add_point(c, random_vec3(&seed, 0.02), vec3_make(0, 0, 0));
        set_velocity(0, vec3_make(0, -5, 0));
        for (int t = MOTION_TURN; t < MOTIONS; t++)
            velocity[0].of[t] = 3 * random_real(&seed);
        real before = motion_energy(&body[0].basis, &velocity[0]);
        if (solve(1) != 1) continue;
        hits++;
        for (int n = 0; n < 2; n++) {
            real after = motion_energy(&body[0].basis, &velocity[0]);
            near(after, before, 1e-4 * before);
            motion_advance(&body[0].frame, &body[0].basis, &velocity[0], 0.01);
        }
        ck_assert(body[0].is_struck && !motion_is_some(&moved[0]));
    }
    ck_assert_int_ge(hits, 1000);
}
END_TEST

// Rejects: an impulse on one of the two only, or at different places.
START_TEST(impact_keeps_momentum_and_angular_momentum)
{
    int hits = 0;
    seed = 12;
    for (int round = 0; round < 20000; round++) {
        any_pair();
        if (!(body[0].basis.inverse_mass > 0)) continue;
        vec3 p = momentum_of_pair(), l = angular_momentum_of_pair();
        real size = scale_of_momentum();
        if (!solve(random_fraction(&seed))) continue;
        hits++;
        expect_vec3(momentum_of_pair(), p, ROUNDING * size);
        expect_vec3(angular_momentum_of_pair(), l, ROUNDING * size);
    }
    ck_assert_int_ge(hits, 5000);
}
END_TEST

static real apart(int k)
{
    const contact_point *p = &made[0].point[k];
    vec3 v = vec3_sub(motion_at(&body[0].basis, &velocity[0], p->local_a),
                      motion_at(&body[1].basis, &velocity[1], p->local_b));
    return vec3_dot(made[0].normal, v);
}

// The points of the pair get gaps, some of which close in the substep.
static void open_gaps(void)
{
    contact *c = &made[0];
    for (int k = 0; k < c->count; k++) {
        real gap = 10 * frame.h * real_max(random_real(&seed), 0);
        vec3 *arm = &c->point[k].local_b;
        *arm = vec3_add_scaled(*arm, -gap, c->normal);
    }
}

// How far point k is open where the bodies stand at a time t (s), as they went.
static real gap_at(int k, const solver_body was[2], const motion went[2], real t)
{
    real gap[CONTACT_POINTS];
    rigid_frame at[2];
    for (int b = 0; b < 2; b++) {
        solver_body x = was[b];
        motion u = went[b];
        if (x.basis.inverse_mass > 0)
            motion_advance(&x.frame, &x.basis, &u, t);
        at[b] = x.frame;
    }
    contact_gaps(&made[0], &at[0], &at[1], 0, gap);
    return gap[k];
}

// s after the substep began: what B has been moved is what it did not go before.
static real time_of_impact(const motion went[2])
{
    vec3 was = vec3_make(went[1].of[0], went[1].of[1], went[1].of[2]);
    vec3 change = vec3_sub(was, velocity_of(1));
    return vec3_dot(moved_of(1), change) / vec3_length_squared(change);
}

// They strike when the first of them touches, as the bodies stand and have turned
// by then.  Rejects: a later one, for which the first would have gone through; a
// touch where the substep's start would have it.
START_TEST(no_point_goes_through)
{
    const real TURN = 0.1;      // rad, in the substep, at most
    int hits = 0, off = 0;
    seed = 14;
    for (int round = 0; round < 20000; round++) {
        any_pair();
        open_gaps();
        frame.friction = 0;
        gravity = vec3_make(0, 0, 0);
        for (int b = 0; b < 2; b++) {
            real turn = vec3_length(spin_of(b)) * frame.h;
            for (int t = MOTION_TURN; t < MOTIONS && turn > TURN; t++)
                velocity[b].of[t] *= TURN / turn;
        }
        const motion went[2] = { velocity[0], velocity[1] };
        const solver_body was[2] = { body[0], body[1] };
        if (solve(random_fraction(&seed)) != 1) continue;
        real t = time_of_impact(went), least = HUGE_VAL;
        // What touched as it began is as deep as it was; what touches just
        // after its end strikes at its end.
        if (!(t > 1e-6 * frame.h && t < 0.999 * frame.h)) continue;
        hits++;
        for (int k = 0; k < made[0].count; k++)
            least = real_min(least, gap_at(k, was, went, t));
        // Of the way of a substep, at 20 m/s.  (Moments that no body has make
        // some of these turn so unevenly that Newton's steps end before.)
        real way = 20 * frame.h;
        off += !(fabs(least) <= 1e-9 * way);
        ck_assert_msg(fabs(least) <= 1e-4 * way,
                      "%d: open by %g at %g of %g", round, least, t, frame.h);
    }
    ck_assert_int_le(off, hits / 100);
    ck_assert_int_ge(hits, 2000);
}
END_TEST

// Rejects: friction that stops one of two directions, and lets the other slide.
START_TEST(enough_friction_stops_the_point)
{
    int hits = 0;
    seed = 15;
    for (int round = 0; round < 20000; round++) {
        any_pair();
        made[0].count = 1;
        frame.friction = 1e6;
        gravity = vec3_make(0, 0, 0);
        const contact_point *p = &made[0].point[0];
        real closing = -apart(0);
        if (solve(0.5) != 1) continue;
        hits++;
        vec3 v = vec3_sub(motion_at(&body[0].basis, &velocity[0], p->local_a),
                          motion_at(&body[1].basis, &velocity[1], p->local_b));
        vec3 n = made[0].normal;
        v = vec3_add_scaled(v, -vec3_dot(v, n), n);
        ck_assert(closing > 0 && vec3_length(v) <= 1e-7 * (closing + 20));
    }
    ck_assert_int_ge(hits, 3000);
}
END_TEST

// Rejects: points that still close, or part too slowly, after an impact; too
// fast, if one alone has touched.
START_TEST(every_point_parts_at_restitution_times_its_speed)
{
    int hits = 0;
    seed = 13;
    for (int round = 0; round < 20000; round++) {
        any_pair();
        frame.friction = 0;
        gravity = vec3_make(0, 0, 0);
        real closed[CONTACT_POINTS], e = random_fraction(&seed),
             fastest = 0;
        for (int k = 0; k < made[0].count; k++) {
            closed[k] = -apart(k);
            fastest = real_max(closed[k], fastest);
        }
        if (solve(e) != 1) continue;
        hits++;
        for (int k = 0; k < made[0].count; k++) {
            ck_assert(!(closed[k] > 0)
                      || apart(k) >= e * closed[k] - 1e-9 * (fastest + 20));
            if (made[0].count == 1)
                near(apart(k), e * closed[k], 1e-11 * (fastest + 20));
        }
    }
    ck_assert_int_ge(hits, 5000);
}
END_TEST

// Rejects: a NaN that spreads to what it touches.
START_TEST(numbers_that_are_not_finite_strike_nothing)
{
    const real bad[] = { (real)NAN, HUGE_VAL, -HUGE_VAL };
    for (int k = 0; k < 3; k++)
        for (int number = 0; number < MOTIONS; number++) {
            begin(0.01);
            add_ball(vec3_make(0, 0, 0), 1, 0.5);
            add_ball(vec3_make(1, 0, 0), 1, 0.5);
            join_balls(0, 1);
            set_velocity(1, vec3_make(-3, 0, 0));
            velocity[0].of[number] = bad[k];
            motion before = velocity[1];
            solve(1);
            for (int i = 0; i < MOTIONS; i++) {
                ck_assert(velocity[1].of[i] == before.of[i]);
                ck_assert(moved[1].of[i] == 0);
            }
        }
}
END_TEST

// --- the plain form ----------------------------------------------------------

// A box of any sides about the middle: one that turns by `turn` (rad) at most.
static void any_box(vec3 at, bool moves, real turn)
{
    real x = random_between(&seed, 0.3, 1), y = random_between(&seed, 0.3, 1),
         z = random_between(&seed, 0.3, 1), mass = any_size(1);
    vec3 i = vec3_make(y * y + z * z, x * x + z * z, x * x + y * y);
    int b = add(at, moves ? mass : HUGE_VAL, vec3_scale(mass / 12, i), 1);
    if (!moves) return;
    velocity[b] = motion_make(&body[b].basis, random_vec3(&seed, 5),
                              vec3_scale(turn / frame.h, random_vec3(&seed, 0.5)));
}

// Two boxes, and up to four points that are open by up to twice the way of a
// substep; of every other pair all touch.
static plain_impact any_two_boxes(real turn, bool touch)
{
    vec3 n = random_direction(&seed), across = vec3_unit(vec3_cross(n, random_direction(&seed)));
    vec3 aside = vec3_cross(n, across);
    begin(0.01);
    any_box(vec3_scale(0.5, n), true, turn);
    any_box(vec3_scale(-0.5, n), random_below(&seed, 3) > 0, turn);
    contact *c = add_contact(0, 1, n);
    for (int k = 1 + random_below(&seed, 4); k > 0; k--) {
        vec3 at = vec3_add_scaled(vec3_scale(random_real(&seed) / 2, across),
                                  random_real(&seed) / 2, aside);
        real gap = touch ? -1e-12 : random_between(&seed, 0, 0.1);
        add_point(c, vec3_sub(at, body[0].frame.center),
                  vec3_sub(vec3_add_scaled(at, -gap, n), body[1].frame.center));
    }
    plain_impact x = { .normal = n, .points = c->count,
                       .restitution = random_fraction(&seed) };
    for (int side = 0; side < 2; side++) {
        x.body[side] = (plain_body){ body[side].frame, body[side].basis,
                                     velocity[side] };
        for (int k = 0; k < c->count; k++)
            x.at[side][k] = side ? c->point[k].local_b : c->point[k].local_a;
    }
    return x;
}

// m/s: by how much the ends differ in velocity, and in place over the substep.  How
// they have turned may differ by two steps of a midpoint rule, each phi^3 / 24, if
// they turn by phi: engine bodies fly back from an impact, and on again.
static real difference_of_ends(const plain_impact *x, const motion began[2])
{
    real most = 0;
    for (int b = 0; b < 2; b++) {
        motion *u = &velocity[b];
        const plain_body *p = &x->body[b];
        if (!(body[b].basis.inverse_mass > 0)) continue;
        real before = vec3_length(motion_rotation(&body[b].basis, &began[b]));
        real after = vec3_length(motion_rotation(&p->basis, &p->velocity));
        real phi = frame.h * real_max(before, after);
        motion_advance(&body[b].frame, &body[b].basis, u, frame.h);
        for (int i = 0; i < FOUR_AXES; i++)
            ck_assert(vec3_distance(body[b].frame.axis[i], p->frame.axis[i])
                      <= phi * phi * phi / 12 + 1e-12);
        real way = vec3_distance(body[b].frame.center, p->frame.center);
        vec3 fast = vec3_sub(motion_straight(u), motion_straight(&p->velocity));
        most = real_max(most, real_max(way / frame.h, vec3_length(fast)));
    }
    return most;
}

// Two boxes of which several points strike, one after the other or together, turned
// as they are at that moment.  Rejects, in either form: an impact where the substep
// began; one that stops the points and then goes on without e; points that push
// though they part; one body that gets no impulse; a body that has flown on with its
// new velocity for the whole substep.
START_TEST(impact_ends_as_the_plain_form_does)
{
    int hits = 0, unlike = 0;
    seed = 31;
    for (int round = 0; round < 4000; round++) {
        bool touch = round % 2;
        plain_impact x = any_two_boxes(_i ? 0.1 : 0, touch);
        const motion began[2] = { velocity[0], velocity[1] };
        int hit = solve(x.restitution);
        real t = plain_impact_step(&x, frame.h);
        unlike += !touch && (hit > 0) != (t < frame.h);
        if (hit != 1) continue;
        hits++;
        // Boxes of 10 kg at 5 m/s; point after point is stopped until 1e-13 m/s
        // are left of each.
        ck_assert(difference_of_ends(&x, began) <= 1e-11);
    }
    ck_assert_int_ge(hits, 1000);
    ck_assert_int_eq(unlike, 0);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        balls_that_meet_head_on_part_at_restitution_times_their_speed,
        bodies_go_on_from_where_they_meet,
        bodies_that_overlap_strike_at_once,
        gap_is_that_of_now,
        bodies_that_do_not_touch_in_this_substep_do_not_strike,
        slow_bodies_do_not_bounce, size_does_not_say_what_is_slow,
        only_balls_face_each_other_where_they_come,
        balls_that_do_not_strike_are_faced_when_they_have_come_around,
        what_does_not_move_may_be_either_body,
        ball_comes_back_to_the_square_of_its_restitution,
        what_falls_together_meets_at_the_speed_that_it_has,
        cradle_passes_on_as_many_balls_as_come,
        row_between_walls_keeps_its_energy,
        rounds_are_bounded,
        what_is_passed_on_ends_with_a_tenth_of_the_blow,
        ball_with_friction_leaves_as_the_closed_form_says,
        face_that_spins_is_braked,
        box_that_lands_flat_leaves_flat,
        each_corner_parts_at_its_own_speed,
        eccentric_impact_turns_the_body,
        no_impact_gives_energy,
        struck_body_flies_freely_before_and_after,
        impact_keeps_momentum_and_angular_momentum,
        every_point_parts_at_restitution_times_its_speed,
        no_point_goes_through,
        enough_friction_stops_the_point,
        numbers_that_are_not_finite_strike_nothing,
        NULL
    };
    return suite_run((suite){
        .name = "restitution", .tests = tests, .set_up = set_up,
        .repeated = { { impact_ends_as_the_plain_form_does, 0, 2 } }
    });
}
