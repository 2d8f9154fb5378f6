// 13-blocks.c - contacts one by one and four side by side: ns a contact, for
// the two passes of a substep, by how many points a contact has.
//
// 0      points, ns by the plain solver, by blocks, to make the blocks
// 1      how full the lanes are, by contacts

#include "clock.h"
#include "plain_solver.h"
#include "random.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { BODIES = 1000, CONTACTS = 3000, PLAIN = 0, BLOCKS, MAKE, WAYS };

static unsigned long long seed = 3;

static solver_body body[BODIES];
static contact table[CONTACTS], *list[CONTACTS];
static bool is_first[CONTACTS], strikes[CONTACTS];
static real reach[CONTACTS], gap[CONTACTS][CONTACT_POINTS];
static motion velocity[BODIES + 1], moved[BODIES + 1];
static plane ground = { { 0, 1, 0 }, 0 };
static solver_frame frame = { .body = body, .bodies = BODIES, .plane = &ground,
    .h = 1.0 / 480, .warm = 1, .friction = 0.5, .hertz = 60, .damping = 10,
    .max_rate = 3 };
static contact_solver solver;
static plain_solver plain = { .frame = &frame, .contact = list, .gap = gap,
                              .velocity = velocity, .moved = moved,
                              .body = body, .is_first = is_first,
                              .strikes = strikes };

// Icosahedra of 1 kg, with a radius of half a metre.
static void make_bodies(void)
{
    for (int b = 0; b < BODIES; b++) {
        const vec3 axis[3] = { { 0.2, 0, 0 }, { 0, 0.2, 0 }, { 0, 0, 0.2 } };
        body[b] = (solver_body){ .radius = 0.5, .basis.inverse_mass = 1 };
        for (int t = 0; t < TURNS; t++) {
            body[b].frame.axis[t] = axis[t];
            body[b].basis.turn[t] = vec3_scale(5 / sqrt(0.08), axis[t]);
        }
    }
}

// Each body lies on the one before, beside a few others, and one in five on the
// ground: three contacts a body, as in a heap that has been for a while.
static void make_contacts(int n, int points)
{
    for (int k = 0; k < n; k++) {
        int a = k % BODIES, b = (a + 1 + k / BODIES * 37) % BODIES;
        contact *c = &table[k];
        if (k % 15 == 0) b = contact_with_plane(0);
        *c = (contact){ .a = a, .b = b, .count = points,
                        .normal = vec3_unit(random_vec3(&seed, 1)) };
        for (int j = 0; j < points; j++) {
            c->point[j].local_a = random_vec3(&seed, 0.5);
            c->point[j].local_b = random_vec3(&seed, 0.5);
            c->impulse[j] = 1e-3;
        }
        list[k] = c;
        reach[k] = HUGE_VAL;
    }
    plain.contacts = n;
}

// Contacts found anew: blocks of the frame before are not kept.
static void prepare(void)
{
    static long found;
    for (int k = 0; k < plain.contacts; k++) table[k].found = ++found;
    const contact *const *of = (const contact *const *)list;
    if (!solver_activate(&solver, &frame, of, reach, plain.contacts)
        || !solver_prepare(&solver, &frame, of)) exit(1);
}

static void work(int way, void *with)
{
    (void)with;
    if (way == MAKE) {
        prepare();
    } else if (way == PLAIN) {
        plain_push(&plain);
        plain_relax(&plain);
    } else {
        solver_push(&solver, &frame, velocity, moved);
        solver_relax(&solver, &frame, velocity, moved);
    }
}

static void times(void)
{
    printf("\n\n# points, ns: plain, blocks, making the blocks\n"
           "#ns| points of a contact,\"one by one (ns a contact, two passes)\","
           "four side by side,to make a block (ns a contact)\n");
    for (int points = 1; points <= CONTACT_POINTS; points++) {
        lap taken[WAYS];
        real ns[WAYS];
        make_contacts(CONTACTS, points);
        plain_begin(&plain);
        prepare();
        clock_race((race){ WAYS, 15, 0.01, work, NULL }, taken);
        for (int k = 0; k < WAYS; k++)
            ns[k] = 1e9 * taken[k].seconds / CONTACTS;
        printf("%d %.1f %.1f %.1f\n#ns| %d,%.0f,%.0f,%.0f\n", points, ns[PLAIN],
               ns[BLOCKS], ns[MAKE], points, ns[PLAIN], ns[BLOCKS], ns[MAKE]);
        if (points == CONTACT_POINTS)
            clock_print_row("solver", "contacts of four points",
                            "the same impulses", "four side by side",
                            "one by one",
                            taken[PLAIN].ratio / taken[BLOCKS].ratio);
    }
}

static void fill(void)
{
    printf("\n\n# contacts, %% of the lanes that are in use\n");
    for (int n = 10; n <= CONTACTS; n *= 3) {
        make_contacts(n, 4);
        prepare();
        printf("%d %.1f\n", n, 100.0 * n / (REAL4 * solver.blocks));
    }
}

int main(void)
{
    clock_print_head("13-blocks: contacts one by one, and four side by side",
                     FLAGS);
    make_bodies();
    if (!solver_grow(&solver, BODIES)) return 1;
    times();
    fill();
    solver_free(&solver);
    return 0;
}
