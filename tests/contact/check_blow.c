// check_blow.c - does a blow stop all that it goes through, and nothing else?
// Book: chapter 15.

#include <check.h>
#include <string.h>

#include "blow.h"
#include "plain_blow.h"
#include "pile.h"
#include "suite.h"

static pile heap;
static contact_solver solver;
static plain_touch touch[PILE_CONTACTS];
static motion plain_velocity[PILE_BODIES];
static motion_basis basis[PILE_BODIES];
static real before[PILE_CONTACTS][CONTACT_POINTS];

static void begin_test(void)
{
    seed = 51;
    solver = (contact_solver){ .contacts = 0 };
    ck_assert(solver_grow(&solver, PILE_BODIES));
    pile_clear(&heap);
    heap.frame.gravity = GRAVITY;
}

static void end_test(void)
{
    solver_free(&solver);
}

// --- the engine's form -------------------------------------------------------

static void prepare(void)
{
    const contact *table[PILE_CONTACTS];
    for (int k = 0; k < heap.contacts; k++) table[k] = &heap.contact[k];
    pile_find(&heap);
    ck_assert(solver_activate(&solver, &heap.frame, table, heap.reach,
                              heap.contacts));
    ck_assert(solver_prepare(&solver, &heap.frame, table));
    solver_update_gaps(&solver, &heap.frame, heap.moved);
}

// N s: the impulse of point j of lane l.
static real impulse_of(int n, int l, int j)
{
    return real4_get(&solver.block[n].point[j].impulse, l);
}

// N s: how much of all impulses came now.
static real sum_of_blows(void)
{
    real sum = 0;
    for (int n = 0; n < solver.blocks; n++)
        for (int l = 0; l < REAL4; l++)
            for (int j = 0; j < solver.block[n].points; j++)
                sum += impulse_of(n, l, j);
    return sum;
}

// --- the plain form ----------------------------------------------------------

static plain_touch touch_of(const contact *c)
{
    const solver_body *a = &heap.body[c->a], *b = &heap.body[c->b < 0 ? 0 : c->b];
    plain_touch t = { .body = { c->a, c->b }, .normal = c->normal,
                      .points = c->count };
    t.bounces = solver_material(&heap.frame, c->a, c->b).restitution > 0;
    const rigid_frame *frame_b = c->b < 0 ? NULL : &b->frame;
    real height = c->b < 0 ? heap.plane[-1 - c->b].offset : 0;
    contact_gaps(c, &a->frame, frame_b, height, t.gap);
    for (int k = 0; k < c->count; k++) {
        contact_arms at = contact_arms_of(c, k, &a->frame, frame_b);
        t.arm[0][k] = at.a;
        t.arm[1][k] = at.b;
    }
    return t;
}

// The contacts in the order of the engine's blocks.
static plain_blow plain_of(void)
{
    plain_blow x = { .touch = touch, .basis = basis, .velocity = plain_velocity,
                     .h = heap.frame.h };
    x.slowest = 2 * vec3_length(heap.frame.gravity) * x.h;
    for (int b = 0; b < heap.frame.bodies; b++) {
        basis[b] = heap.body[b].basis;
        plain_velocity[b] = heap.velocity[b];
    }
    for (int n = 0; n < solver.blocks; n++)
        for (int l = 0; l < REAL4; l++)
            if (solver.block[n].contact[l] >= 0)
                touch[x.touches++] =
                    touch_of(&heap.contact[solver.block[n].contact[l]]);
    return x;
}

static real sum_of_plain(const plain_blow *x)
{
    real sum = 0;
    for (int i = 0; i < x->touches; i++)
        for (int k = 0; k < x->touch[i].points; k++)
            sum += x->touch[i].impulse[k];
    return sum;
}

// J: the energy of the difference of both ends.
static real difference(void)
{
    real sum = 0;
    for (int b = 0; b < heap.frame.bodies; b++) {
        if (!(basis[b].inverse_mass > 0)) continue;
        motion u = heap.velocity[b];
        for (int i = 0; i < MOTIONS; i++) u.of[i] -= plain_velocity[b].of[i];
        sum += motion_energy(&basis[b], &u);
    }
    return sum;
}

// --- by hand -----------------------------------------------------------------

// m/s: what a load makes close.
static real speed_of_load(real ratio)
{
    return 2 * vec3_length(heap.frame.gravity) * heap.frame.h * sqrt(ratio);
}

// Box i on box i - 1, or on the floor, each 1 m wide and high; all but the last lie.
static void stack(int boxes, real mass, real ratio, bool on_floor, real speed)
{
    const vec3 sides = { 1, 1, 1 };
    for (int i = 0; i < boxes; i++)
        pile_box(&heap, vec3_make(0, i + 0.5, 0), sides,
                 i == boxes - 1 ? ratio * mass : mass);
    heap.velocity[boxes - 1].of[1] = -speed;
    for (int i = on_floor ? 0 : 1; i < boxes; i++) {
        contact *c = pile_contact(&heap, i, i > 0 ? i - 1 : contact_with_plane(0),
                                  vec3_make(0, 1, 0));
        for (int k = 0; k < 4; k++) {
            vec3 low = { k & 1 ? 0.5 : -0.5, -0.5, k & 2 ? 0.5 : -0.5 };
            vec3 high = { low.x, 0.5, low.z };
            pile_point(&heap, c, low, high, 0);
        }
    }
}

static void run_engine(void)
{
    prepare();
    blow_stop(&solver, &heap.frame, heap.velocity);
}

// A floor takes it all, through any number of boxes: nothing moves, and each contact
// has the momentum of what struck, M v.  Its rounding moves a light body, m, by 1e-16
// of M v / m, at each of some points, in each of some steps.  Rejects: a blow that
// ends at the first body, or at the second; a push that goes to one side only.
START_TEST(blow_goes_through_a_stack_to_the_floor)
{
    for (int boxes = 2; boxes <= 8; boxes++)
        for (real ratio = 2; ratio < 2e6; ratio *= 10) {
            end_test();
            begin_test();
            real speed = 20 * speed_of_load(ratio);
            stack(boxes, 0.5, ratio, true, speed);
            run_engine();
            real momentum = 0.5 * ratio * speed;
            for (int b = 0; b < boxes; b++)
                ck_assert(motion_fastest(&heap.body[b].basis, &heap.velocity[b], 1)
                          <= 1e-14 * ratio * speed);
            ck_assert(fabs(sum_of_blows() - boxes * momentum)
                      <= 1e-9 * boxes * momentum);
        }
}
END_TEST

// In the air all go on together, with the momentum that there was: M v of M + n m.
// Rejects, in either form: a body without its share; speed that is stopped, not
// shared.
START_TEST(blow_in_the_air_shares_its_momentum)
{
    for (int boxes = 2; boxes <= 8; boxes++)
        for (real ratio = 2; ratio < 5e3; ratio *= 10) {
            end_test();
            begin_test();
            real speed = 20 * speed_of_load(ratio);
            stack(boxes, 0.5, ratio, false, speed);
            prepare();
            plain_blow x = plain_of();
            ck_assert_int_eq(plain_blow_stop(&x), 1);
            run_engine();
            real all = -speed * ratio / (ratio + boxes - 1);
            for (int b = 0; b < boxes; b++) {
                ck_assert(fabs(heap.velocity[b].of[1] - all) <= 1e-9 * speed);
                ck_assert(fabs(plain_velocity[b].of[1] - all) <= 1e-9 * speed);
            }
        }
}
END_TEST

// What a load makes close is no blow: twice what gravity gives in a substep, times
// the root of the ratio.  Rejects: a threshold without the root, or without the two.
START_TEST(a_load_is_no_blow)
{
    for (real ratio = 4; ratio < 5e4; ratio *= 4)
        for (int k = 0; k < 2; k++) {
            end_test();
            begin_test();
            real speed = speed_of_load(ratio) * (k ? 1 + 1e-9 : 1 - 1e-9);
            stack(2, 0.5, ratio, true, speed);
            run_engine();
            real left = -heap.velocity[1].of[1];
            ck_assert(k ? left <= 1e-9 : left == speed);
            ck_assert(k ? sum_of_blows() > 0 : sum_of_blows() == 0);
        }
}
END_TEST

// --- by chance ---------------------------------------------------------------

static void any_heap(int n)
{
    end_test();
    solver = (contact_solver){ .contacts = 0 };
    ck_assert(solver_grow(&solver, PILE_BODIES));
    int bodies = 2 + n % 6;
    pile_clear(&heap);
    heap.frame.gravity = GRAVITY;
    for (int b = 0; b < bodies; b++) pile_any_body(&heap, 1 + n % 2);
    for (int k = 0; k < 10; k++) {
        int a = any_below(bodies), b = any_below(bodies);
        if (a == b) b = contact_with_plane(any_below(2));
        pile_any_contact(&heap, a, b, true);
        contact *c = &heap.contact[heap.contacts - 1];
        for (int j = 0; j < c->count; j++) c->impulse[j] = 0;
    }
}

// m/s: by how much the plain form leaves a point closing; or parting, though it pushes.
static real left_by_plain(const plain_blow *x)
{
    real most = 0;
    for (int i = 0; i < x->touches; i++)
        for (int k = 0; k < touch[i].points && touch[i].wave > 0; k++) {
            real parts = plain_blow_parting(x, &touch[i], k);
            most = fmax(most, touch[i].impulse[k] > 0 ? fabs(parts) : -parts);
        }
    return most;
}

// The engine's velocities are the right ones, u.  If the impulses of another form leave
// no point closing, nor one that pushes parting, by more than e, then the energy of the
// difference is e / 2 times the sum of the impulses of both, at most.  (Half the sum of
// (impulse - impulse of u) (parting - parting of u): no mixed term is below 0.)  The
// plain form measures its own e: few of these end before 1e-13 m/s change.  Rejects, in
// either form: a contact left out, or one that joins though it bounces, or parts; a wave
// too few; a row of another body; a gap that is left out.
START_TEST(blow_ends_as_the_plain_form_does)
{
    int compared = 0, joined = 0;
    for (int n = 0; n < 2000; n++) {
        any_heap(n);
        if (n % 5 == 0) heap.frame.restitution = 0.5 * (n % 10 > 0);
        prepare();
        plain_blow x = plain_of();
        int hits = plain_blow_stop(&x);
        blow_stop(&solver, &heap.frame, heap.velocity);
        if (hits > 1) continue;         // a list has the last blow's alone
        compared += hits;
        for (int i = 0; i < x.touches; i++) joined += x.touch[i].wave > 1;
        // Rounding of what meets at up to 5 m/s.
        real e = left_by_plain(&x) + 1e-11;
        real off = difference(), impulses = sum_of_blows() + sum_of_plain(&x);
        ck_assert_msg(off <= e / 2 * impulses, "%d: %g J off", n, off);
        ck_assert_msg(e < 1e-3, "%d: %g m/s are left", n, e);
    }
    ck_assert_int_ge(compared, 1000);
    ck_assert_int_ge(joined, 3000);
}
END_TEST

// Rejects: a blow that acts again in the next substep; one that takes the impulse
// of a load with it.
START_TEST(blow_is_forgotten_when_its_substep_ends)
{
    for (int n = 0; n < 300; n++) {
        any_heap(n);
        for (int k = 0; k < heap.contacts; k++)
            for (int j = 0; j < heap.contact[k].count; j++)
                heap.contact[k].impulse[j] = random_fraction(&seed);
        prepare();
        for (int i = 0; i < solver.blocks * REAL4; i++)
            for (int j = 0; j < solver.block[i / REAL4].points; j++)
                before[i][j] = impulse_of(i / REAL4, i % REAL4, j);
        blow_stop(&solver, &heap.frame, heap.velocity);
        blow_forget(&solver);
        for (int i = 0; i < solver.blocks * REAL4; i++)
            for (int j = 0; j < solver.block[i / REAL4].points; j++) {
                real now = impulse_of(i / REAL4, i % REAL4, j);
                ck_assert(fabs(now - before[i][j]) <= ROUNDING);
            }
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        blow_goes_through_a_stack_to_the_floor,
        blow_in_the_air_shares_its_momentum,
        a_load_is_no_blow,
        blow_ends_as_the_plain_form_does,
        blow_is_forgotten_when_its_substep_ends, NULL
    };
    return suite_run((suite){ .name = "blow", .tests = tests,
                              .set_up = begin_test, .tear_down = end_test });
}
