// 13-tower.h - cubes of 1 m, one on the other, moved by the plain solver of
// chapter 13 and by nothing else: their contacts are their corners.

#ifndef TUMBLE_13_TOWER_H
#define TUMBLE_13_TOWER_H

#include "plain_solver.h"

#include <stdlib.h>

enum { TOWER = 32, CORNERS = 4 };

typedef struct {
    int cubes;
    rigid4 rigid[TOWER];
    particle p[TOWER][FOUR];
    solver_body body[TOWER];
    contact contact[TOWER], *list[TOWER];
    real gap[TOWER][CONTACT_POINTS];
    bool is_first[TOWER], strikes[TOWER];
    motion velocity[TOWER + 1], moved[TOWER + 1];
    plane ground;
    solver_frame frame;
    int substeps, iterations;       // a frame; a substep
    bool warm;                      // do contacts remember?
} tower;

static void tower_add(tower *t, real mass)
{
    int b = t->cubes++;
    shape cube;
    contact *c = &t->contact[b];
    if (!shape_box(&cube, vec3_make(1, 1, 1), mass).ok
        || !rigid4_build(&t->rigid[b], &cube).ok) exit(1);
    *c = (contact){ .a = b, .b = b - 1, .count = CORNERS,
                    .normal = { 0, 1, 0 } };
    t->list[b] = c;
    for (int k = 0; k < CORNERS; k++) {
        // Bit 1 of a corner's number says that it is an upper one.
        int low = (k & 1) | (k & 2) << 1, high = low | 2;
        c->point[k].local_a = t->rigid[b].local[low];
        c->point[k].own = 1;
        if (b > 0) c->point[k].local_b = t->rigid[b - 1].local[high];
    }
    for (int k = 0; k < FOUR; k++) {
        vec3 at = vec3_add(t->rigid[b].at[k], vec3_make(0, b + 0.5, 0));
        t->p[b][k] = (particle){ at, at, 1 / t->rigid[b].mass };
    }
    t->body[b].radius = sqrt(0.75);
    shape_free(&cube);
}

// Substeps of a sixtieth of a second, `iterations` passes each; the springs as
// stiff as a substep bears.
static void tower_begin(tower *t, int substeps, int iterations)
{
    *t = (tower){ .substeps = substeps, .iterations = iterations, .warm = true,
                  .ground = { { 0, 1, 0 }, 0 } };
    t->frame = (solver_frame){ .h = 1.0 / 60 / substeps, .warm = 1,
        .friction = 0.5, .hertz = 1e6, .damping = 10, .max_rate = 3 };
}

static void tower_free(tower *t)
{
    for (int b = 0; b < t->cubes; b++) rigid4_free(&t->rigid[b]);
}

static void tower_find(tower *t)
{
    t->frame.body = t->body;
    t->frame.plane = &t->ground;
    t->frame.bodies = t->cubes;
    for (int b = 0; b < t->cubes; b++) {
        solver_body *x = &t->body[b];
        x->frame = rigid4_frame(t->p[b]);
        x->basis = basis_find(&t->rigid[b], &x->frame);
        t->velocity[b] = motion_of(t->p[b], &x->frame, &x->basis, t->frame.h);
        t->moved[b] = (motion){ { 0 } };
    }
}

static void tower_forget(tower *t)
{
    for (int b = 0; b < t->cubes; b++) {
        contact *c = &t->contact[b];
        for (int k = 0; k < CORNERS; k++) c->impulse[k] = 0;
        c->friction = vec3_make(0, 0, 0);
        c->twist = 0;
    }
}

static void tower_put(tower *t)
{
    for (int b = 0; b < t->cubes; b++) {
        solver_body *x = &t->body[b];
        motion_straighten(&t->rigid[b], &x->frame);
        motion_write(t->p[b], &x->frame, &x->basis, &t->velocity[b], t->frame.h);
    }
}

static void tower_frame(tower *t)
{
    tower_find(t);
    plain_solver s = { &t->frame, t->list, t->cubes, t->gap, t->velocity,
                       t->moved, t->body, t->is_first, t->strikes };
    plain_begin(&s);
    for (int n = 0; n < t->substeps; n++) {
        for (int b = 0; b < t->cubes; b++)
            t->velocity[b].of[1] -= 9.81 * t->frame.h;
        if (!t->warm) tower_forget(t);
        plain_warm_start(&s);
        for (int k = 0; k < t->iterations; k++) plain_push(&s);
        plain_move(&s);
        plain_relax(&s);
    }
    tower_put(t);
}

// m, by how much the highest cube lies lower than it should.
static real tower_sag(const tower *t)
{
    return t->cubes - 0.5 - rigid4_frame(t->p[t->cubes - 1]).center.y;
}

#endif
