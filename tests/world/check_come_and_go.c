// check_come_and_go.c - may bodies come and go while a world runs?
// Book: chapter 18.

#include <check.h>
#include <string.h>

#include "expect.h"
#include "handle.h"
#include "measure.h"
#include "scarce.h"
#include "stage.h"
#include "step.h"
#include "suite.h"

static shape box, slab, ball, cloth, rope, small_cloth;

static void set_up(void)
{
    ck_assert(shape_box(&box, vec3_make(1, 1, 1), 1).ok);
    ck_assert(shape_box(&slab, vec3_make(3, 0.5, 3), 5).ok);
    ck_assert(shape_icosahedron(&ball, 0.5, 1).ok);
    ck_assert(shape_cloth(&cloth, 10, 10, 1, 1, 1, 0.2).ok);
    ck_assert(shape_cloth(&small_cloth, 5, 7, 0.4, 0.6, 0.3, 0.2).ok);
    ck_assert(shape_rope(&rope, 12, 1.2, 0.3).ok);
    begin(world_options_default());
}

static void tear_down(void)
{
    world_free(&w);
    shape_free(&box);
    shape_free(&slab);
    shape_free(&ball);
    shape_free(&cloth);
    shape_free(&small_cloth);
    shape_free(&rope);
}

static real height(int b)
{
    return rigid4_frame(particle_of(b, 0)).center.y;
}

static void steps(int n)
{
    for (int k = 0; k < n; k++) {
        world_step(&w);
        ck_assert_int_eq(w.report.dropped, 0);
    }
}

// Until all sleep.
static void steps_to_sleep(void)
{
    int k = 0;
    while (!w.is_still && k++ < 2000) world_step(&w);
    ck_assert(w.is_still);
}

// --- memory ------------------------------------------------------------------

// A column of a hundred bodies: in every frame the oldest goes, and one comes.
// (Check itself must not be called where memory is counted.)
static int fountain(int *next, int n)
{
    int faults = 0;
    for (int k = 0; k < n; k++, ++*next) {
        int b = *next % 100, now = -1;
        world_remove(&w, b);
        placement p = placement_at(vec3_make(2 * random_real(&seed),
                                             6 + random_real(&seed),
                                             2 * random_real(&seed)));
        p.velocity = random_vec3(&seed, 3);
        faults += !world_add(&w, *next % 3 ? &box : &ball, p, &now).ok;
        faults += now != b;
        world_step(&w);
        faults += w.report.dropped;
    }
    return faults;
}

// Rejects: memory that grows with every body that comes; a place that is not
// used again; a table that is made anew each time.
START_TEST(bodies_come_and_go_on_the_same_memory)
{
    int next = 0;
    add_floor();
    for (int k = 0; k < 100; k++)
        add_at(&ball, 3 * random_real(&seed), 2 + 0.1 * k,
               3 * random_real(&seed));
    ck_assert_int_eq(fountain(&next, 1000), 0);
    ck_assert_int_eq(w.bodies, 100);
    ck_assert_int_eq(w.pool.count, 100 * FOUR);
    long blocks = blocks_held, made = mallocs_made;
    int entries = probe_contact_room(&w);
    int faults = fountain(&next, 1000);
    long held = blocks_held, more = mallocs_made - made;
    ck_assert_int_eq(faults, 0);
    ck_assert_int_eq(held, blocks);
    ck_assert_int_le(more, 12);
    ck_assert_int_le(probe_contact_room(&w), entries + entries / 4);
    ck_assert_int_eq(probe_vertices(&w), 100 * ball.particles);
    ck_assert_int_eq(w.pool.count, 100 * FOUR);
}
END_TEST

// Rejects: a shape that is kept when its last body has gone; one that goes
// while another body has it; a cloth in the place of a box.
START_TEST(places_and_shapes_are_used_again)
{
    const shape *all[] = { &box, &ball, &cloth, &rope, &small_cloth };
    int at[5];
    for (int k = 0; k < 5; k++) at[k] = add_at(all[k], 4 * k, 5, 0);
    add_at(&box, 0, 9, 0);
    long blocks = blocks_held;
    int particles = w.pool.count;
    for (int round = 0; round < 8; round++) {
        steps(2);
        for (int k = 0; k < 5; k++) world_remove(&w, at[k]);
        ck_assert_int_eq(w.softs, 0);
        ck_assert_int_eq(w.gone, 5);
        steps(2);
        for (int k = 4; k >= 0; k--) {
            int number = add_at(all[k], 4 * k, 5, 0);
            ck_assert_int_eq(number < 5, 1);
            ck_assert(w.body[number].room >= body_particles(&w.body[number]));
            at[k] = number;
        }
        ck_assert_int_eq(w.bodies, 6);
        ck_assert_int_eq(w.shapes, 5);
        ck_assert_int_eq(probe_lists(&w)->softs, 3);
        ck_assert_int_eq(w.pool.count, particles);
    }
    long held = blocks_held;
    ck_assert_int_le(held, blocks + 20);
}
END_TEST

// Rejects: a half-added body; a world that does not go on.
START_TEST(body_without_memory_is_refused_and_nothing_has_changed)
{
    const shape *all[] = { &box, &rope, &small_cloth, &slab };
    add_floor();
    add_at(&ball, 0, 1, 0);
    add_at(&cloth, 0, 2, 0);
    for (int k = 0; k < 4; k++) {
        bool ok = false;
        for (int n = 0; !ok; n++) {
            int bodies = w.bodies, softs = w.softs, number = -7;
            int particles = w.pool.count, dynamic = w.dynamic_bodies;
            mallocs_left = n;
            ok = world_add(&w, all[k], placement_at(vec3_make(0, 3 + k, 0)),
                           &number).ok;
            mallocs_left = INT_MAX;
            steps(1);
            if (ok) break;
            ck_assert_int_eq(number, -7);
            ck_assert_int_eq(w.bodies, bodies);
            ck_assert_int_eq(w.softs, softs);
            ck_assert_int_eq(probe_lists(&w)->softs, softs);
            ck_assert_int_eq(w.pool.count, particles);
            ck_assert_int_eq(w.dynamic_bodies, dynamic);
        }
    }
    ck_assert_int_eq(w.bodies, 6);
    steps(100);
}
END_TEST

// --- the others --------------------------------------------------------------

// Twelve bodies fall in a heap, and one flies by for ever, so that every frame
// has as many substeps.  Others come and go, far away.
static void play(bool guests, unsigned long long hash[150])
{
    int fixed = -1, flying = -1;
    begin(world_options_default());
    for (int k = 0; k < 12; k++)
        add_at(k % 2 ? &box : &ball, 0.3 * (k % 3), 1.2 + 1.1 * (k / 2), 0);
    add_thrown(&box, vec3_make(0, 50, 500), vec3_make(0, 300, 0), ZERO);
    add_floor();
    for (int f = 0; f < 150; f++) {
        placement far = placement_at(vec3_make(700 + f, 30, 0));
        if (guests && f % 20 == 5) flying = add(&slab, far);
        far.is_static = true;
        if (guests && f % 50 == 11) fixed = add(&ball, far);
        if (guests && f % 20 == 14) world_remove(&w, flying);
        if (guests && f % 50 == 41) world_remove(&w, fixed);
        steps(1);
        hash[f] = 0;
        for (int i = 0; i < 13 * FOUR; i++) {
            unsigned long long bits[3];
            memcpy(bits, &w.pool.at[i].position, sizeof bits);
            for (int k = 0; k < 3; k++) hash[f] = 31 * hash[f] + bits[k];
        }
    }
}

// Rejects: contacts that are found again because another body has come; a spare
// motion in the place of a body.
START_TEST(others_keep_their_bits_when_a_far_body_comes_and_goes)
{
    static unsigned long long alone[150], with[150];
    play(false, alone);
    play(true, with);
    for (int f = 0; f < 150; f++)
        ck_assert_msg(alone[f] == with[f], "from frame %d on", f);
}
END_TEST

// Rejects: a contact with a body that has gone; with the one that has its
// number now; impulses that it left behind.
START_TEST(what_a_body_touched_is_forgotten_with_it)
{
    for (int again = 0; again < 3; again++) {
        begin(world_options_default());
        int lower = again == 1 ? add_at(&slab, 0, 0.25, 0)
                               : add_at(&box, 0, 0.5, 0);
        int upper = add_at(&box, 0, again == 1 ? 1 : 1.5, 0);
        add_floor();
        steps(20);
        world_remove(&w, lower);
        if (again == 2) ck_assert_int_eq(add_at(&ball, 50, 9, 0), lower);
        if (again == 1) ck_assert_int_eq(add_at(&box, 0, 9, 0), lower);
        ck_assert_int_eq(probe_points(&w, lower), 0);
        real start = height(upper), dt = w.options.dt;
        steps(6);
        near(start - height(upper), 9.81 * 36 * dt * dt / 2, 0.004);
        if (again == 0) continue;
        near(9 - height(lower), 9.81 * 36 * dt * dt / 2, 1e-9);
    }
}
END_TEST

// Rejects: contacts of the old body with the neighbours of the new one.
START_TEST(body_in_the_place_of_another_has_contacts_of_its_own)
{
    shape low;
    ck_assert(shape_box(&low, vec3_make(1, 0.6, 1), 1).ok);
    int lower = add_nailed(&box, 0, 0.5, 0), upper = add_at(&box, 0, 1.5, 0);
    add_floor();
    steps(20);
    world_remove(&w, lower);
    ck_assert_int_eq(add_nailed(&low, 0, 0.3, 0), lower);
    steps(60);
    near(height(upper), 1.1, 0.005);
    // One that stands as the old one did bears it at once.
    world_remove(&w, lower);
    ck_assert_int_eq(add_nailed(&low, 0, 0.3, 0), lower);
    for (int f = 0; f < 10; f++) {
        steps(1);
        near(height(upper), 1.1, 0.001);
    }
    world_free(&w);
    shape_free(&low);
}
END_TEST

// Blocks that are kept name a spare motion, which is another now.
START_TEST(no_block_names_a_body_that_came_later)
{
    add_floor();
    for (int k = 0; k < 5; k++) add_at(&box, 3 * k, 0.5, 0);
    steps(40);
    ck_assert(probe_solver_names(&w, 5));
    for (int k = 0; k < 12; k++) add_at(&box, 3 * k, 50, 0);
    ck_assert(probe_solver_names(&w, 5));
}
END_TEST

// --- sleep -------------------------------------------------------------------

// Rejects: a body that sleeps on in the air.
START_TEST(what_lies_on_a_body_that_goes_wakes_and_falls)
{
    for (int fixed = 0; fixed < 2; fixed++) {
        begin(world_options_default());
        int lower = fixed ? add_nailed(&slab, 0, 0.25, 0)
                          : add_at(&slab, 0, 0.25, 0);
        int upper = add_at(&box, 0, 1, 0), other = add_at(&box, 20, 0.5, 0);
        add_floor();
        steps_to_sleep();
        world_remove(&w, lower);
        ck_assert(!probe_sleeps(&w, upper) && probe_sleeps(&w, other));
        steps(100);
        near(height(upper), 0.5, 0.005);
        steps_to_sleep();
        world_remove(&w, other);
        ck_assert(probe_sleeps(&w, upper));
    }
}
END_TEST

// Rejects: the same of a cloth; a list of particles near what has gone.
START_TEST(cloth_on_a_body_that_goes_wakes_and_falls)
{
    int lower = add_nailed(&slab, 0, 1, 0), sheet = add_at(&cloth, 0, 1.3, 0);
    add_floor();
    steps_to_sleep();
    ck_assert(particle_of(sheet, 55)->position.y > 1.2);
    world_remove(&w, lower);
    steps(200);
    ck_assert(particle_of(sheet, 55)->position.y < 0.2);
    // What comes in its place is met.
    steps_to_sleep();
    ck_assert_int_eq(add_nailed(&slab, 0, 3, 0), lower);
    for (int i = 0; i < cloth.particles; i++) {
        particle *p = particle_of(sheet, i);
        p->position.y += 4;
        p->previous = p->position;
    }
    world_wake(&w, sheet);
    steps(200);
    ck_assert(particle_of(sheet, 55)->position.y > 3.2);
}
END_TEST

// Rejects: a plane that nothing meets, since the list of pairs is older.
START_TEST(plane_may_come_at_any_time)
{
    int b = add_at(&box, 0, 5, 0);
    steps(10);
    add_floor();
    steps_to_sleep();
    near(height(b), 0.5, 0.005);
    ck_assert(world_add_plane(&w, vec3_unit(vec3_make(1, 1, 0)), 0.9).ok);
    ck_assert(!probe_sleeps(&w, b));
    steps(60);
    ck_assert(height(b) > 0.51 || rigid4_frame(particle_of(b, 0)).center.x > 1);
}
END_TEST

// Rejects: a particle that stays pinned, or asleep.
START_TEST(particle_may_be_pinned_and_let_go)
{
    int b = add_at(&rope, 0, 3, 0);
    world_pin(&w, b, 0);
    steps(30);
    vec3 was = particle_of(b, 0)->position;
    ck_assert(particle_of(b, 12)->position.y < 2.8);
    near_vec3(was, vec3_make(-0.6, 3, 0), 1e-12);
    world_unpin(&w, b, 0);
    steps(30);
    ck_assert(particle_of(b, 0)->position.y < 2.5);
}
END_TEST

// --- anything ----------------------------------------------------------------

// Bodies of all kinds come and go at random, and nothing is lost.  They appear within
// each other, and cloth is stretched while they part.  That is reported, and is over
// a second later.
START_TEST(anything_may_come_and_go)
{
    const shape *all[] = { &box, &ball, &cloth, &rope, &slab, &small_cloth };
    for (int start = 0; start < 6; start++) {
        begin(world_options_default());
        add_floor();
        for (int f = 0; f < 150; f++) {
            int kind = (int)(3 + 3 * random_real(&seed)),
                b = (int)(8 + 8 * random_real(&seed));
            placement p = anywhere(2, 2, 3);
            p.position.y += 4;
            p.is_static = kind == 4;
            if (random_real(&seed) > 0.5) add(all[kind], p);
            if (random_real(&seed) > 0.5 && b < w.bodies
                && !body_is_gone(&w.body[b]))
                world_remove(&w, b);
            steps(1);
        }
        for (int b = 0; b < w.bodies; b++)
            for (int i = 0; i < body_particles(&w.body[b]); i++)
                ck_assert(vec3_is_finite(particle_of(b, i)->position));
        ck_assert(!(world_measure(&w).strain > 0.02) || w.report.unconverged > 0);
        steps(60);
        measures m = world_measure(&w);
        ck_assert_msg(m.strain < 0.05, "strain %g", m.strain);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        bodies_come_and_go_on_the_same_memory,
        places_and_shapes_are_used_again,
        body_without_memory_is_refused_and_nothing_has_changed,
        others_keep_their_bits_when_a_far_body_comes_and_goes,
        what_a_body_touched_is_forgotten_with_it,
        body_in_the_place_of_another_has_contacts_of_its_own,
        no_block_names_a_body_that_came_later,
        what_lies_on_a_body_that_goes_wakes_and_falls,
        cloth_on_a_body_that_goes_wakes_and_falls,
        plane_may_come_at_any_time,
        particle_may_be_pinned_and_let_go,
        anything_may_come_and_go,
        NULL
    };
    return suite_run((suite){
        .name = "come and go", .tests = tests, .set_up = set_up,
        .tear_down = tear_down, .seconds = 120
    });
}
