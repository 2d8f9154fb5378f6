// check_cloth.c - what cloth and rope do among other bodies, over whole frames.
// Book: chapter 16.

#include <check.h>
#include <stdlib.h>

#include "capsule.h"
#include "expect.h"
#include "handle.h"
#include "join.h"
#include "ledger.h"
#include "measure.h"
#include "soft_step.h"
#include "stage.h"
#include "step.h"
#include "suite.h"

static shape box, crate, ball, cloth, sheet, rope;

static void set_up(void)
{
    ck_assert(shape_box(&box, vec3_make(1, 1, 1), 8).ok);
    ck_assert(shape_box(&crate, vec3_make(0.4, 0.4, 0.4), 1).ok);
    ck_assert(shape_icosahedron(&ball, 0.25, 1).ok);
    ck_assert(shape_cloth(&cloth, 10, 10, 1, 1, 1, 0.2).ok);
    ck_assert(shape_cloth(&sheet, 21, 21, 2, 2, 1, 0.2).ok);
    ck_assert(shape_rope(&rope, 12, 1.2, 0.3).ok);
    begin(world_options_default());
}

static void tear_down(void)
{
    world_free(&w);
    shape_free(&box);
    shape_free(&crate);
    shape_free(&ball);
    shape_free(&cloth);
    shape_free(&sheet);
    shape_free(&rope);
}

static void frames(int n)
{
    for (int f = 0; f < n; f++) world_step(&w);
}

static vec3 middle(int b)
{
    vec3 sum = ZERO;
    int n = body_particles(&w.body[b]);
    for (int i = 0; i < n; i++)
        sum = vec3_add_scaled(sum, 1.0 / n, particle_of(b, i)->position);
    return sum;
}

static real lowest(int b)
{
    real y = HUGE_VAL;
    for (int i = 0; i < w.body[b].shape->particles; i++)
        y = fmin(y, particle_of(b, i)->position.y);
    return y;
}

static bool sleeps(int b, int most)
{
    for (int f = 0; f < most && !probe_sleeps(&w, b); f++) world_step(&w);
    return probe_sleeps(&w, b);
}

typedef enum { BY_NAILS, IN_THE_AIR, ON_A_BODY, HOLDS } holding;

static void hold_corners(int b, holding how)
{
    int n = w.body[b].shape->columns, on = -1;
    const int at[] = { 0, n - 1, n * (n - 1), n * n - 1 };
    if (how == ON_A_BODY) on = add_nailed(&crate, 0, -9, 0);
    for (int k = 0; k < 4; k++) {
        if (how == BY_NAILS) {
            world_pin(&w, b, at[k]);
            continue;
        }
        joint_plan j = { .kind = JOINT_PIN, .a = b, .b = on };
        j.particle = at[k];
        ck_assert(world_join(&w, j, NULL).ok);
    }
}

static void pin_corners(int b)
{
    hold_corners(b, BY_NAILS);
}

// --- pins --------------------------------------------------------------------

static real fastest(int b, const vec3 *was)
{
    real most = 0;
    for (int i = 0; i < body_particles(&w.body[b]); i++)
        most = fmax(most, vec3_distance(particle_of(b, i)->position, was[i]));
    return most / w.options.dt;
}

// What holds it four corners a side apart holds it straight: nails, or pins to
// the world, or to a body.  A share exp(-5/2 t) of what swings is left after t
// seconds.
// Threads without shear that give by 4e-6 under the sheet's weight settle, for
// themselves, where a corner bears 29.5 times that weight.
// Rejects: threads that give by nothing, of which each pulls as hard as the others
// make it (64,000 N), and that shake by a metre a second; and those that give
// only where a nail is.
START_TEST(sheet_that_is_held_taut_comes_to_rest)
{
    enum { FRAMES = 600, SIDE = 10 };
    for (holding how = BY_NAILS; how < HOLDS; how++) {
        begin(world_options_default());
        int c = add_at(&cloth, 0, 2, 0);
        vec3 was[SIDE * SIDE];
        hold_corners(c, how);
        w.body[c].damping = 5;
        frames(FRAMES - 1);
        for (int i = 0; i < SIDE * SIDE; i++)
            was[i] = particle_of(c, i)->position;
        frames(1);
        real speed = fastest(c, was);
        real pull = 0;
        for (int k = 0; k < probe_joints(&w); k++)
            pull = fmax(pull, probe_joint(&w, k)->force);
        printf("a taut sheet moves by %g m/s, pulls by %g N\n", speed, pull);
        ck_assert_double_lt(speed, 0.01);
        if (how != BY_NAILS)
            ck_assert_double_eq_tol(pull / (29.5 * 9.81), 1, 0.2);
        ck_assert_int_eq(w.report.unconverged, 0);
    }
}
END_TEST

// --- what has been parted ----------------------------------------------------

// Sheets of a few cells, two to five times as long as wide, fall from their plane
// and swing at a corner for six seconds.  Their balls leave wide gaps between them,
// and layers are kept apart by the proof alone.
// Rejects: threads that stay as the proof has left them, off by up to a fifth; and
// drawn again as if that took a substep: sheets gain as much as all their weight
// falls.
START_TEST(sheets_with_oblong_cells_keep_their_threads)
{
    const struct { int columns, rows; real width, depth; int corner; } sheets[] = {
        { 3, 3, 1.81, 0.447, 0 }, { 9, 10, 0.667, 0.2, 3 },
        { 4, 4, 16, 8.37, 2 }, { 7, 7, 0.906, 0.347, 0 },
        { 3, 6, 0.942, 11.6, 3 }, { 5, 5, 0.868, 3.19, 1 },
    };
    for (size_t k = 0; k < sizeof sheets / sizeof *sheets; k++) {
        int c = sheets[k].columns, r = sheets[k].rows;
        const int at[] = { 0, c - 1, c * (r - 1), c * r - 1 };
        shape small;
        ck_assert(shape_cloth(&small, c, r, sheets[k].width, sheets[k].depth,
                              0.1, 0.2).ok);
        begin(world_options_default());
        world_pin(&w, add_at(&small, 0, 0, 0), at[sheets[k].corner]);
        real worst = 0, gained = 0;
        real large = 0.1 * 9.81 * fmax(sheets[k].width, sheets[k].depth);
        for (int f = 0; f < 360; f++) {
            frames(1);
            measures m = world_measure(&w);
            worst = fmax(worst, m.strain);
            gained = fmax(gained, (m.kinetic + m.potential) / large);
        }
        printf("%d x %d: strain %.3g, gained %.2g\n", c, r, worst, gained);
        ck_assert(worst < 0.01 && gained < 0.01);
        world_free(&w);
        shape_free(&small);
    }
}
END_TEST

// --- planes ------------------------------------------------------------------

// A cloth that falls flat from 0.3 m, 2.4 m/s.
// Rejects: a landing that throws it up again, or tears at it.
START_TEST(cloth_that_lands_flat_stays_down)
{
    int c = add_at(&cloth, 0, 0.3, 0);
    add_floor();
    bool landed = false;
    for (int f = 0; f < 120; f++) {
        frames(1);
        real y = middle(c).y, thick = w.body[c].thickness;
        landed |= y < 1.001 * thick;
        ck_assert_msg(y > 0.999 * thick, "sunk to %g", y);
        if (landed) ck_assert_msg(y < 1.01 * thick, "up again at %g", y);
        ck_assert(world_measure(&w).strain < 1e-3);
    }
    ck_assert(landed);
}
END_TEST

// A cloth of 1 m on the floor, and one stood on its edge; a rope.
// Rejects: planes that cloth and rope do not meet, or without their thickness.
START_TEST(cloth_and_rope_stay_above_a_plane)
{
    add_floor();
    const shape *s[] = { &cloth, &rope };
    for (int b = 0; b < 2; b++) {
        placement p = placement_at(vec3_make(4 * b, 2, 0));
        p.x = vec3_make(0.6, 0.8, 0);
        p.y = vec3_make(-0.8, 0.6, 0);
        add(s[b], p);
    }
    for (int f = 0; f < 180; f++) {
        frames(1);
        for (int b = 0; b < 2; b++) ck_assert(lowest(b) > 0);
    }
    for (int b = 0; b < 2; b++) {
        ck_assert(middle(b).y < 0.4);
        ck_assert(lowest(b) > 0.95 * w.body[b].thickness);
    }
}
END_TEST

// Rows that have slid past each other by a tenth, in a free sheet.
// Rejects: diagonals that do nothing in a step.
START_TEST(sheared_sheet_straightens)
{
    world_options o = world_options_default();
    o.gravity = ZERO;
    begin(o);
    add_at(&sheet, 0, 0, 0);
    for (int i = 0; i < sheet.particles; i++) {
        particle *p = particle_of(0, i);
        p->position.x += 0.1 * p->position.z;
        p->previous = p->position;
    }
    real first = world_measure(&w).shear, least = first;
    ck_assert(first > 0.04);
    // Nothing damps them: they swing.
    for (int f = 0; f < 120; f++) {
        frames(1);
        least = fmin(least, world_measure(&w).shear);
    }
    ck_assert_msg(least < 0.02, "sheared by %g, then %g", first, least);
}
END_TEST

// A rope that bears ten thousand times the mass of a link, plucked in its middle.
// Rejects: substeps in which its links swing ever wider, and tear it.
START_TEST(loaded_rope_that_is_plucked_holds_its_length)
{
    shape loaded;
    ck_assert(shape_rope(&loaded, 20, 1, 0.21).ok);
    loaded.mass[20] = 100;
    placement p = placement_at(ZERO);
    p.x = vec3_make(0, -1, 0);
    p.y = vec3_make(1, 0, 0);
    int b = add(&loaded, p);
    world_pin(&w, b, 0);
    particle_of(b, 10)->position.z += 0.005;
    for (int f = 0; f < 120; f++) {
        frames(1);
        real strain = world_measure(&w).strain;
        ck_assert_msg(strain < 1e-3, "frame %d: strained by %g", f, strain);
    }
    world_free(&w);
    shape_free(&loaded);
}
END_TEST

// --- bodies that move --------------------------------------------------------

// A ball as heavy as the sheet that it falls into, hung up by its corners.  It
// swings, and rolls: from starts a billionth of a metre apart up to heights from
// 0.20 to 0.35 m.
// Rejects: a sheet through which it falls, or one that throws it out; a ball
// that sinks between light particles.
START_TEST(sheet_carries_a_ball)
{
    int c = add_at(&sheet, 0, 0, 0), b = add_at(&ball, 0.05, 1, 0.02);
    pin_corners(c);
    for (int f = 0; f < 600; f++) {
        frames(1);
        real y = middle(b).y;
        ck_assert_msg(y > -0.3 && y <= 1, "frame %d: at %g", f, y);
        if (f > 150) ck_assert_msg(y < 0.5, "frame %d: up at %g", f, y);
        ck_assert(world_measure(&w).penetration == 0);
    }
}
END_TEST

// The same mass at the same speed, once at rest: without gravity, a ball that
// flies into a free sheet takes it along.
// Rejects: an impulse that one of the two does not feel; a ball that is through
// the sheet before it has felt its weight.
START_TEST(ball_takes_a_free_sheet_along)
{
    const real speed[] = { 2, 10, 50 };
    for (int k = 0; k < 3; k++) {
        world_options o = world_options_default();
        o.gravity = ZERO;
        begin(o);
        int c = add_at(&sheet, 0, 0, 0);
        int b = add_thrown(&ball, vec3_make(0.03, 0.5, 0.02),
                           vec3_make(0, -speed[k], 0), vec3_make(2, 1, 3));
        vec3 from = middle(c);
        int n = (int)(60 * 4 / speed[k]);
        frames(n);
        vec3 went = vec3_sub(middle(c), from);
        real taken = -went.y * 60 / n / speed[k];
        ck_assert_msg(taken > 0.2 && taken < 0.7, "%g m/s: %g of it", speed[k],
                      taken);
        ck_assert(middle(b).y > lowest(c));
        measures m = world_measure(&w);
        near_vec3(m.momentum, vec3_make(0, -speed[k], 0), 1e-9 * speed[k]);
    }
}
END_TEST

// A cube of 30 cm and 1 kg flies at 2 m/s, a corner ahead, at a sheet of 20 g
// whose rim is pinned: between its particles.
// Rejects: edges and corners that sticks have the last word about: the sheet
// lets the corner through, or throws it back at twice its speed.
START_TEST(corner_that_flies_into_a_held_sheet_is_stopped)
{
    for (int k = 0; k < 4; k++) {
        world_options o = world_options_default();
        o.gravity = ZERO;
        begin(o);
        shape held, cube;
        ck_assert(shape_cloth(&held, 6, 6, 0.5, 0.5, 0.02, 0.2).ok);
        ck_assert(shape_box(&cube, vec3_make(0.3, 0.3, 0.3), 1).ok);
        int s = add_at(&held, 0, 0, 0);
        real up = sqrt(1.0 / 3), out = sqrt(2.0 / 3), half = out / 2;
        real side = out * sqrt(0.75);
        placement p = placement_at(vec3_make(0.02 * random_real(&seed), 0.35,
                                             0.02 * random_real(&seed)));
        p.x = vec3_make(out, up, 0);
        p.y = vec3_make(-half, up, -side);
        p.z = vec3_make(-half, up, side);
        p.velocity = vec3_make(0, -2, 0);
        int b = add(&cube, p);
        for (int i = 0; i < 36; i++)
            if (i < 6 || i >= 30 || i % 6 == 0 || i % 6 == 5)
                world_pin(&w, s, i);
        for (int f = 0; f < 60; f++) {
            frames(1);
            real low = HUGE_VAL;
            for (int i = 0; i < 8; i++) low = fmin(low, vertex_of(b, i).y);
            ck_assert_msg(low > -0.02, "frame %d: the corner is at %g", f, low);
        }
        // It came with 2 J.
        real left = world_measure(&w).kinetic;
        ck_assert_msg(left < 1, "%g J are left", left);
        world_free(&w);
        shape_free(&held);
        shape_free(&cube);
    }
}
END_TEST

// Rejects: a box that turns through a cloth because its planes stand as they
// did when the frame began.
START_TEST(spinning_box_stays_on_its_side_of_a_cloth)
{
    for (int k = 0; k < 3; k++) {
        begin(world_options_default());
        int c = add_at(&sheet, 0, 0, 0);
        const vec3 spin[] = { { 0, 0, 9 }, { 7, 0, 7 }, { 20, 5, 0 } };
        int b = add_thrown(&ball, vec3_make(0, 0.6, 0), ZERO, spin[k]);
        pin_corners(c);
        for (int f = 0; f < 240; f++) {
            frames(1);
            // Or it has rolled off.
            vec3 x = middle(b);
            if (fabs(x.x) > 0.8 || fabs(x.z) > 0.8) break;
            ck_assert_msg(x.y > -0.9, "frame %d: at %g", f, x.y);
        }
    }
}
END_TEST

// --- sleep -------------------------------------------------------------------

// Puts body b there, with this velocity.
static void bring(int b, vec3 to, vec3 velocity)
{
    vec3 way = vec3_sub(to, middle(b));
    for (int i = 0; i < body_particles(&w.body[b]); i++) {
        particle *p = particle_of(b, i);
        p->position = vec3_add(p->position, way);
        p->previous = vec3_add_scaled(p->position, -w.age, velocity);
        p->inverse_mass = w.inverse_mass[w.body[b].first + i];
    }
    probe_forget_sleep(&w, b);
}

// Rejects: a deformable body that nothing wakes: a rope at rest would catch a
// cloth like a rod.
START_TEST(rope_that_sleeps_wakes_under_a_cloth)
{
    int r = add_at(&rope, 0, 0.1, 0), c = add_at(&cloth, 0, 9000, 0);
    add_nailed(&box, -0.6, -0.5, 0);
    add_nailed(&box, 0.6, -0.5, 0);
    // It lies on two boxes, and creeps into the gap between them for a while.
    ck_assert(sleeps(r, 2400));
    bring(c, vec3_make(0, 0.5, 0), vec3_make(0, -16, 0));
    bool woke = false;
    for (int f = 0; f < 30; f++) {
        frames(1);
        woke |= !probe_sleeps(&w, r);
    }
    ck_assert(woke);
    ck_assert(middle(c).y < 0.4);
}
END_TEST

// A rope of 1.2 m lies on a box, and 0.3 m of it hang down beside it: a third of
// the other part's weight, and friction is 0.5.
// Rejects: friction that lets a particle that sticks move with what pulls it, by
// a little in each substep: 11 mm in these ten seconds.
START_TEST(rope_that_friction_holds_does_not_creep)
{
    enum { CORNER = 9 };
    int r = add_at(&rope, 0, 2, 0);
    add_nailed(&box, 0, 0, 0);
    w.options.sleep_speed = 0;
    real off = 1.001 * w.body[r].thickness, link = rope.spacing;
    for (int i = 0; i < rope.particles; i++) {
        real x = fmin(i - CORNER, 0), y = fmin(CORNER - i, 0);
        particle *p = particle_of(r, i);
        p->position = vec3_make(0.5 + off + x * link, 0.5 + off + y * link, 0);
        p->previous = p->position;
    }
    frames(120);
    vec3 was = particle_of(r, 0)->position;
    frames(600);
    near_vec3(particle_of(r, 0)->position, was, 1e-5);
}
END_TEST

// A rope of 3 m hangs over a drum, as far down on one side as the rope equation
// with friction bears,
//     dT/dp = mu (T + R g sin p) + R g cos p      (T in m of rope times g),
// so b = a e^(mu pi) + 2 mu R (1 + e^(mu pi)) / (1 + mu^2).  (A particle at an end
// weighs as much as a link.)  With a twentieth more friction it stays for two
// seconds, and with a twentieth less it has gone.
// Rejects: a load that counts what the strands have drawn into the drum twice, as
// their pull and as an overlap, and holds 1.3 times as much; friction that lets a
// rope creep.
static real hangs_over_drum(real mu, real more, bool is_rope)
{
    const real pi = 3.14159265358979323846, e = exp(mu * pi);
    world_options o = world_options_default();
    o.friction = more * mu;
    o.sleep_speed = 0;
    begin(o);
    shape drum, plan;
    ck_assert(is_rope ? shape_rope(&drum, 20, 1, 1).ok
                      : shape_capsule(&drum, 1, 0.2, 1).ok);
    ck_assert(shape_rope(&plan, 60, 3, 1).ok);
    placement where = placement_at(ZERO);
    where.y = vec3_make(0, 0, 1);
    where.z = vec3_make(0, -1, 0);
    if (is_rope) {
        where.x = vec3_make(0, 0, 1);
        where.y = vec3_make(0, 1, 0);
        where.z = vec3_make(-1, 0, 0);
    }
    where.is_static = !is_rope;
    int d = add(&drum, where), r = add_at(&plan, 0, 2, 0);
    for (int i = 0; is_rope && i <= 20; i++) world_pin(&w, d, i);
    real link = plan.spacing;
    real big = is_rope ? 2.002 * w.body[r].thickness
                       : 0.2 + 1.001 * soft_gap(&w.body[r], &w.body[d]);
    real both = 61 * link - pi * big;
    real a = (both - 2 * mu * big * (1 + e) / (1 + mu * mu)) / (1 + e) - link / 2;
    for (int i = 0; i < 61; i++) {
        real s = i * link - a, p = fmin(fmax(s / big, 0), pi);
        real down = fmax(fmax(-s, s - pi * big), 0);
        particle *x = particle_of(r, i);
        x->position = vec3_make(-big * cos(p), big * sin(p) - down, 0);
        x->previous = x->position;
    }
    real was = particle_of(r, 60)->position.y;
    frames(120);
    real went = was - particle_of(r, 60)->position.y;
    world_free(&w);
    shape_free(&drum);
    shape_free(&plan);
    return went;
}

START_TEST(rope_over_a_drum_holds_what_friction_holds_and_no_more)
{
    static const real friction[] = { 0.1, 0.3, 0.5 };
    for (int k = 0; k < 3; k++) {
        real stays = hangs_over_drum(friction[k], 1.05, false);
        real goes = hangs_over_drum(friction[k], 0.95, false);
        printf("rope on a drum, friction %g: stays within %.2g m, goes %.2g m\n",
               friction[k], stays, goes);
        ck_assert(fabs(stays) < 0.005);
        ck_assert(goes > 0.1);
    }
    begin(world_options_default());
}
END_TEST

// The other rope is nailed all along: its links are as fixed as a drum.  Rejects:
// pairs of particles that friction holds by their overlap alone.
START_TEST(rope_over_a_nailed_rope_holds_what_friction_holds_and_no_more)
{
    static const real friction[] = { 0.1, 0.3, 0.5 };
    for (int k = 0; k < 3; k++) {
        real stays = hangs_over_drum(friction[k], 1.25, true);
        real goes = hangs_over_drum(friction[k], 0.8, true);
        ck_assert_msg(fabs(stays) < 0.02, "%g: goes %g m", friction[k], stays);
        ck_assert_msg(goes > 0.1, "%g: goes %g m", friction[k], goes);
    }
}
END_TEST

// A strip of cloth, as long as `size` (m), lies over a rope that hangs by its ends,
// or over a rod that is static, or one that a program could move.  It reaches as far
// down on one side as the rope equation of the drum bears at a friction of 0.5, or
// has equal halves.  Friction is `more` times as much.  Returns how far it goes in a
// second and a half, as a share of its length.
typedef enum { ON_ROD, ON_MOVED_ROD, ON_ROPE } strip_on;
static real strip_goes(strip_on on, bool is_even, real more, real size, real dt)
{
    const real pi = 3.14159265358979323846, mu = 0.5, e = exp(mu * pi);
    bool is_rope = on == ON_ROPE;
    enum { LONG = 30, WIDE = 8, ROPE = 20 };
    world_options o = world_options_default();
    o.friction = more * mu;
    o.dt = dt;
    o.sleep_speed = 0;
    begin(o);
    shape drum, plan;
    real link = size / (LONG - 1), wide = (WIDE - 1) * link;
    ck_assert(is_rope
              ? shape_rope(&drum, ROPE, 2 * wide, 0.06 * size * size).ok
              : shape_capsule(&drum, 3 * wide, 0.04 * size, 1).ok);
    ck_assert(shape_cloth(&plan, LONG, WIDE, size, wide, 0.3 * size * size,
                          0.1).ok);
    placement where = placement_at(ZERO);
    where.x = vec3_make(0, is_rope ? 0 : 1, is_rope ? 1 : 0);
    where.y = vec3_make(0, is_rope ? 1 : 0, is_rope ? 0 : 1);
    where.z = vec3_make(is_rope ? -1 : 1, 0, 0);
    where.is_static = on == ON_ROD;
    int d = add(&drum, where), c = add_at(&plan, 0, 2 * size, 0);
    if (on == ON_MOVED_ROD) world_set_kind(&w, d, BODY_KINEMATIC);
    if (is_rope) world_pin(&w, d, 0);
    if (is_rope) world_pin(&w, d, ROPE);
    real big = is_rope
             ? 1.001 * (w.body[c].thickness + w.body[d].thickness)
             : 0.04 * size + 1.001 * soft_gap(&w.body[c], &w.body[d]);
    real both = size - pi * big, arc = 2 * mu * big * (1 + e) / (1 + mu * mu);
    real shorter = is_even ? both / 2 : (both - arc) / (1 + e);
    for (int i = 0; i < LONG * WIDE; i++) {
        real s = i % LONG * link - shorter, z = i / LONG * link - wide / 2;
        real p = fmin(fmax(s / big, 0), pi);
        real down = fmax(fmax(-s, s - pi * big), 0);
        particle *x = particle_of(c, i);
        x->position = vec3_make(-big * cos(p), big * sin(p) - down, z);
        x->previous = x->position;
    }
    real was = particle_of(c, 0)->position.y;
    frames((int)(1.5 / dt));
    real went = particle_of(c, 0)->position.y - was;
    world_free(&w);
    shape_free(&drum);
    shape_free(&plan);
    return fabs(went) / size;
}

// Rejects: friction of two that move which knows nothing of what their strands will
// draw, or takes the push of one pair for the sliding of the next: a strip with
// equal halves leaves the rope within two seconds.  And one with a third of it on
// one side leaves the rod that a program moves.  The rope's balls give a
// strip a rougher and smaller arc than a rod does.
START_TEST(strip_over_a_rod_or_a_hanging_rope_obeys_the_capstan)
{
    static const real size[] = { 0.1, 1, 5 }, step[] = { 60, 30, 240 };
    static const real more[] = { 1.1, 1.25, 1.5 }, less[] = { 0.8, 0.8, 0.7 };
    for (int k = 0; k < 3; k++)
        for (strip_on on = ON_ROD; on <= ON_ROPE; on++) {
            real dt = 1 / step[k];
            real even = strip_goes(on, true, 1, size[k], dt);
            real stays = strip_goes(on, false, more[on], size[k], dt);
            real goes = strip_goes(on, false, less[on], size[k], dt);
            ck_assert_msg(even < 0.02, "%g m: %g", size[k], even);
            ck_assert_msg(stays < 0.03, "%g m: %g", size[k], stays);
            ck_assert_msg(goes > 0.1, "%g m: %g", size[k], goes);
        }
    begin(world_options_default());
}
END_TEST

// A sheet of 1 m slides over tiles of five sizes, flush: it stops after
// v^2 / (2 mu g).
// Rejects: two contacts of one normal that hold a particle to all sides, and
// edges at seams that do: it stops after .55 to .8 of that way.
START_TEST(sheet_slides_over_tiles_as_over_one_floor)
{
    const real side[] = { 0.3, 0.4, 0.5, 1, 2 }, speed = 1.5;
    for (int k = 0; k < 5; k++) {
        world_options o = world_options_default();
        o.friction = 0.2;
        begin(o);
        shape tile;
        ck_assert(shape_box(&tile, vec3_make(side[k], 0.5, 3), 1).ok);
        for (int i = 0; i < 3 / side[k]; i++)
            add_nailed(&tile, (i + 0.5) * side[k] - 1, -0.25, 0);
        int c = add_thrown(&cloth, vec3_make(0, 0.0834, 0),
                           vec3_make(speed, 0, 0), ZERO);
        real from = middle(c).x, way = speed * speed / (2 * 0.2 * 9.81);
        frames(90);
        real went = middle(c).x - from;
        ck_assert_msg(fabs(went / way - 1) < 0.03, "tiles of %g m: %g of %g m",
                      side[k], went, way);
        world_free(&w);
        shape_free(&tile);
    }
    begin(world_options_default());
}
END_TEST

// A box on a cloth on the floor, friction 0.5.
// Rejects: a cloth that never sleeps, or not together with what lies on it; a
// box that creeps over particles which push it one after the other.
START_TEST(box_on_a_cloth_lies_still_and_falls_asleep)
{
    int c = add_at(&cloth, 0, 0.2, 0), b = add_at(&crate, 0.01, 0.7, 0.02);
    add_floor();
    frames(90);
    vec3 was = middle(b);
    ck_assert(sleeps(b, 120));
    ck_assert(probe_sleeps(&w, c));
    ck_assert_int_eq(w.report.asleep, 2);
    near_vec3(middle(b), was, 1e-3);
    // Its lower side is a thickness over the cloth, which is one over the
    // floor.
    near(middle(b).y, 0.2 + 2 * w.body[c].thickness, 1e-3);
}
END_TEST

// A cloth on the floor whose first particle is pinned.  The box falls next to
// it, so that the world as a whole is awake.
// Rejects: a sleeper that is known by its first particle: a pinned one looks
// asleep all along, and the others are never laid to rest.
START_TEST(pinned_cloth_that_sleeps_is_pinned_as_a_whole)
{
    int c = add_at(&cloth, 0, 0, 0);
    add_at(&box, 5, 9000, 0);
    add_floor();
    real up = w.body[c].thickness;
    for (int i = 0; i < cloth.particles; i++) {
        particle_of(c, i)->position.y += up;
        particle_of(c, i)->previous.y += up;
    }
    world_pin(&w, c, 0);
    ck_assert(sleeps(c, 600));
    ck_assert_int_eq(w.report.asleep, 1);
    for (int i = 0; i < cloth.particles; i++) {
        const particle *p = particle_of(c, i);
        ck_assert(p->inverse_mass == 0);
        ck_assert(vec3_distance(p->position, p->previous) == 0);
    }
}
END_TEST

// --- numbers -----------------------------------------------------------------

// Rejects: NaN of one body that spreads to another that it never touched; a
// loop without an end.
START_TEST(lost_number_stays_in_its_body)
{
    add_at(&sheet, -4, 1, 0);
    int safe = add_at(&cloth, 4, 1, 0), lost = add_at(&ball, -4, 1.2, 0);
    add_floor();
    frames(2);
    particle_of(lost, 2)->position.x = (real)NAN;
    frames(60);
    for (int i = 0; i < cloth.particles; i++)
        ck_assert(vec3_is_finite(particle_of(safe, i)->position));
    for (int i = 0; i < sheet.particles; i++)
        ck_assert(vec3_is_finite(particle_of(0, i)->position));
    particle_of(safe, 3)->position.y = (real)NAN;
    frames(20);
    for (int i = 0; i < sheet.particles; i++)
        ck_assert(vec3_is_finite(particle_of(0, i)->position));
}
END_TEST

// Contacts have torn a cloth: every particle is up to 1.7 m from where it was.
// Rejects: diagonals that, drawn along what they were, end further apart than
// they are; particles were thrown off at 30 km/s.
START_TEST(torn_cloth_is_not_thrown_by_its_diagonals)
{
    int any = 7, b = add_at(&cloth, 0, 0, 0);
    for (int i = 0; i < cloth.particles; i++) {
        real x[3];
        for (int k = 0; k < 3; k++)
            any = any * 137 % 10007, x[k] = any / 5000.0 - 1;
        particle *p = particle_of(b, i);
        p->position = vec3_add(p->position, vec3_make(x[0], x[1], x[2]));
    }
    soft_frame f = soft_frame_of(&w, w.age);
    probe_draw(&w, &f);
    for (int i = 0; i < cloth.particles; i++) {
        real far = vec3_length(particle_of(b, i)->position);
        ck_assert_msg(far <= 3, "particle %d: %g m", i, far);
    }
}
END_TEST

// Rejects: restitution that a cloth does not know; one that makes energy, or
// is shared out by its strands.
START_TEST(cloth_bounces_particle_by_particle)
{
    const real shares[] = { 0, 0.5, 1 };
    for (int k = 0; k < 3; k++) {
        world_options o = world_options_default();
        o.gravity = ZERO;
        o.friction = 0;
        o.restitution = shares[k];
        o.sleep_speed = 0;
        begin(o);
        placement p = placement_at(vec3_make(0, 0.4, 0));
        p.velocity = vec3_make(0, -2, 0);
        int b = add(&cloth, p);
        add_floor();
        real before = world_measure(&w).kinetic;
        for (int f = 0; f < 60; f++) {
            world_step(&w);
            ck_assert(world_measure(&w).kinetic <= before * (1 + 1e-12));
        }
        // It lies still, or goes up again at a share of its speed.
        real h = w.age;
        for (int i = 0; i < cloth.particles; i++) {
            particle *x = particle_of(b, i);
            real up = (x->position.y - x->previous.y) / h;
            ck_assert_msg(fabs(up - 2 * shares[k]) <= 1e-9, "up at %g", up);
        }
    }
}
END_TEST

// Pinned at its first particle, straight down from there.
static int hang_at(const shape *rope_plan)
{
    int b;
    placement p = placement_at(vec3_make(0, rope_plan->at[0].x, 0));
    p.x = vec3_make(0, -1, 0);
    p.y = vec3_make(1, 0, 0);
    ck_assert(world_add(&w, rope_plan, p, &b).ok);
    world_pin(&w, b, 0);
    return b;
}

// A strip of card, held level at one end, sags under its own weight by
// q L^4 / (8 E I), of Euler and Bernoulli; the clamp holds the middle of a link.
// Rejects: a stiffness that the world forgets, or hands on in another unit; one
// that changes with substeps or iterations.
START_TEST(card_sags_by_its_stiffness)
{
    const struct { int substeps, iterations; } how[] = { { 4, 3 }, { 20, 8 } };
    for (int k = 0; k < 2; k++) {
        world_options o = world_options_default();
        o.substeps = how[k].substeps;
        o.iterations = how[k].iterations;
        o.sleep_speed = 0;
        begin(o);
        shape strip;
        // 10 mm a link, 0.3 kg/m^2.
        ck_assert(shape_cloth(&strip, 12, 3, 0.11, 0.02, 0.3 * 0.11 * 0.02,
                              0.2).ok);
        int b = add_at(&strip, 0, 0, 0);
        for (int i = 0; i < strip.particles; i++)
            if (i % 12 < 2) world_pin(&w, b, i);
        ck_assert(world_bend(&w, b, 0.016).ok);
        for (int f = 0; f < 300; f++) world_step(&w);
        // The mass of 12 particles is on 11 links, and half too much at the
        // end: the sum of check_bend.c.
        real weight = 9.81 * strip.mass[0], l = strip.spacing, wanted = 0;
        real stiff = 0.016 * (0.02 * 2 / 3 / 2) * 1.0 / (l * l * l);
        for (int i = 1; i < 11; i++) {
            real after = 11 - i;
            wanted += weight / stiff * after * (after + 1) / 2 * after;
        }
        for (int row = 0; row < 3; row++) {
            real got = -particle_of(b, 12 * row + 11)->position.y;
            ck_assert_msg(fabs(got / wanted - 1) < 0.01, "row %d sags by %g m,"
                          " wanted %g", row, got, wanted);
        }
        world_free(&w);
        shape_free(&strip);
    }
}
END_TEST

// A rope of 50 links with a load bears F_k at link k: the load and the rope
// below.  It gets longer by the sum of its compliance times F_k, whatever the
// substeps; and stores half of F_k times that.  It is let go unstretched, bounces
// and comes to rest.
// Rejects: a compliance that goes by substeps or iterations; one of a link that
// is taken for that of the rope; books that forget what is stored.
START_TEST(hanging_rope_is_stretched_by_its_load)
{
    const struct { int substeps, iterations, gradient; } how[] = {
        { 4, 1, GRADIENT_NEW }, { 8, 8, GRADIENT_OLD }, { 20, 3, GRADIENT_NEW }
    };
    for (int k = 0; k < 3; k++) {
        world_options o = world_options_default();
        o.substeps = how[k].substeps;
        o.iterations = how[k].iterations;
        o.relax.gradient = (gradient_kind)how[k].gradient;
        o.sleep_speed = 0;
        begin(o);
        shape line;
        const real each = 0.001, load = 1, compliance = 1e-4;
        ck_assert(shape_rope(&line, 50, 1, 51 * each).ok);
        line.mass[50] = load;
        int b = hang_at(&line);
        ck_assert(world_stretch(&w, b, compliance).ok);
        frames(240);
        real longer = 0, stored = 0;
        for (int i = 0; i < 50; i++) {
            real force = 9.81 * (load + (49 - i) * each);
            real d = compliance / 50 * force;
            longer += d;
            stored += force * d / 2;
        }
        real got = -particle_of(b, 50)->position.y - 1;
        ck_assert_msg(fabs(got / longer - 1) < 1e-6, "%d substeps: longer by "
                      "%.9g m, wanted %.9g", o.substeps, got, longer);
        real has = soft_energy(&w.body[b], w.pool.at);
        ck_assert_msg(fabs(has / stored - 1) < 1e-5, "%.9g J, wanted %.9g",
                      has, stored);
        world_free(&w);
        shape_free(&line);
    }
}
END_TEST

// A stretched rope that is let go shrinks, and swings: it has no more energy
// than it was given, and momentum stays.
// Rejects: an explicit spring; a pull without its counterpart.
START_TEST(what_links_have_stored_is_in_the_books)
{
    for (int k = -6; k <= 0; k++) {
        world_options o = world_options_default();
        o.gravity = ZERO;
        o.sleep_speed = 0;
        begin(o);
        real compliance = pow(10, k);
        int b = add_at(&rope, 0, 0, 0);
        ck_assert(world_stretch(&w, b, compliance).ok);
        for (int i = 0; i < 13; i++) {
            particle *p = particle_of(b, i);
            p->position.x *= 1.1;
            p->previous = p->position;
        }
        real first = ledger_total(&w).energy, before = first;
        ck_assert(fabs(first / (0.12 * 0.12 / (2 * 1.2 * compliance)) - 1)
                  < 1e-12);
        for (int f = 0; f < 60; f++) {
            world_step(&w);
            ledger_entry now = ledger_total(&w);
            ck_assert(now.energy <= before + 1e-9 * first);
            ck_assert(vec3_length(now.momentum) <= 1e-12 * sqrt(first));
            before = now.energy;
        }
        ck_assert(before < first);
        world_free(&w);
    }
}
END_TEST

// Rejects: a stiffness that is no number, or would push.
START_TEST(stiffness_is_a_finite_number)
{
    int b = add_at(&cloth, 0, 0, 0);
    const real bad[] = { -1, (real)NAN, HUGE_VAL };
    ck_assert(world_bend(&w, b, 2).ok && world_stretch(&w, b, 3).ok);
    for (int k = 0; k < 3; k++) {
        ck_assert(!world_bend(&w, b, bad[k]).ok);
        ck_assert(!world_stretch(&w, b, bad[k]).ok);
    }
    ck_assert(w.body[b].bending == 2 && w.body[b].compliance == 3);
}
END_TEST

// A bent rope that lets go swings, and loses its bends to the air as motion.
// Rejects: books in which what bends store comes from nowhere.
START_TEST(bends_are_in_the_books)
{
    world_options o = world_options_default();
    o.gravity = ZERO;
    o.sleep_speed = 0;
    o.ledger = true;
    begin(o);
    shape rod;
    ck_assert(shape_rope(&rod, 10, 1, 1).ok);
    int b = add_at(&rod, 0, 0, 0);
    ck_assert(world_bend(&w, b, 0.5).ok);
    for (int i = 0; i < rod.particles; i++) {
        real a = 0.15 * (i - 5);
        particle *p = particle_of(b, i);
        p->position = vec3_make(sin(a) / 1.5, cos(a) / 1.5, 0);
        p->previous = p->position;
    }
    real stored = bend_energy(&rod, 0.5, w.pool.at);
    ledger_entry at_first = ledger_total(&w);
    ck_assert(fabs(at_first.energy - stored) <= 1e-12 * stored);
    for (int f = 0; f < 60; f++) {
        real before = ledger_total(&w).energy;
        world_step(&w);
        ck_assert(ledger_total(&w).energy <= before + 1e-9 * stored);
    }
    ledger_entry now = ledger_total(&w);
    ck_assert(now.energy < stored && vec3_length(now.momentum) <= 1e-12);
    world_free(&w);
    shape_free(&rod);
}
END_TEST

// Rejects: links that pull along what they are now, which takes a spinning sheet 9 %
// of its angular momentum in a second; friction of particles that takes what they do
// not spin with.
START_TEST(what_spins_in_the_air_keeps_its_angular_momentum)
{
    const real steps[] = { 1.0 / 30, 1.0 / 60, 1.0 / 200 };
    for (int k = 0; k < 12; k++) {
        world_options o = world_options_default();
        world_free(&w);
        o.gravity = ZERO;
        o.dt = steps[k % 3];
        begin(o);
        vec3 spin = k % 2 ? vec3_make(0, 5, 0) : vec3_make(3, 4, 1);
        int b = add_thrown(k / 3 % 2 ? &rope : &cloth, ZERO, vec3_make(1, 2, 3),
                           spin);
        if (k >= 6) ck_assert(world_bend(&w, b, 1e-3).ok);
        // Half of it is caught in the other half.
        for (int i = 0; i < 4; i++) {
            particle *p = particle_of(b, i);
            p->previous = vec3_add(p->previous, vec3_make(0, 0, 0.002 * (4 - i)));
        }
        world_step(&w);
        measures before = world_measure(&w);
        frames((int)(2 / o.dt));
        measures now = world_measure(&w);
        real all = vec3_length(before.angular);
        near(vec3_distance(now.angular, before.angular) / all, 0, 1e-9,
             "angular momentum, of itself");
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        sheet_that_is_held_taut_comes_to_rest,
        sheets_with_oblong_cells_keep_their_threads,
        cloth_that_lands_flat_stays_down,
        cloth_and_rope_stay_above_a_plane,
        sheared_sheet_straightens,
        loaded_rope_that_is_plucked_holds_its_length,
        sheet_carries_a_ball,
        ball_takes_a_free_sheet_along,
        corner_that_flies_into_a_held_sheet_is_stopped,
        spinning_box_stays_on_its_side_of_a_cloth,
        rope_that_sleeps_wakes_under_a_cloth,
        rope_that_friction_holds_does_not_creep,
        rope_over_a_drum_holds_what_friction_holds_and_no_more,
        strip_over_a_rod_or_a_hanging_rope_obeys_the_capstan,
        rope_over_a_nailed_rope_holds_what_friction_holds_and_no_more,
        sheet_slides_over_tiles_as_over_one_floor,
        box_on_a_cloth_lies_still_and_falls_asleep,
        pinned_cloth_that_sleeps_is_pinned_as_a_whole,
        torn_cloth_is_not_thrown_by_its_diagonals,
        lost_number_stays_in_its_body,
        cloth_bounces_particle_by_particle,
        card_sags_by_its_stiffness,
        hanging_rope_is_stretched_by_its_load,
        what_links_have_stored_is_in_the_books,
        stiffness_is_a_finite_number,
        bends_are_in_the_books,
        what_spins_in_the_air_keeps_its_angular_momentum,
        NULL
    };
    return suite_run((suite){
        .name = "cloth", .tests = tests, .set_up = set_up,
        .tear_down = tear_down, .seconds = 30
    });
}
