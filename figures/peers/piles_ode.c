// piles_ode.c - the piles in ODE: quickstep with so many iterations, or the
// direct dWorldStep.  Boxes, sorted pairs; all else is ODE's default.

#include "piles.h"

#include <ode/ode.h>

#include <stdarg.h>
#include <stdlib.h>

enum { CONTACTS = 8 };

typedef struct {
    dWorldID world;
    dSpaceID space;
    dJointGroupID contacts;
    real friction, dt;
    int  boxes, iterations;
    dBodyID *box;
} room;

static dBodyID add_box(const room *r, const start *s, real half)
{
    const pose *p = &s->at;
    dMatrix3 turn = { p->x.x, p->y.x, p->z.x, 0, p->x.y, p->y.y, p->z.y, 0,
                      p->x.z, p->y.z, p->z.z, 0 };
    dBodyID b = dBodyCreate(r->world);
    dMass m;
    dMassSetBoxTotal(&m, 1, 2 * half, 2 * half, 2 * half);
    dBodySetMass(b, &m);
    dBodySetPosition(b, p->middle.x, p->middle.y, p->middle.z);
    dBodySetRotation(b, turn);
    dBodySetLinearVel(b, s->velocity.x, s->velocity.y, s->velocity.z);
    dBodySetAngularVel(b, s->spin.x, s->spin.y, s->spin.z);
    dGeomSetBody(dCreateBox(r->space, 2 * half, 2 * half, 2 * half), b);
    return b;
}

// Its direct solver complains of what it cannot solve, and goes on.
static void keep_quiet(int number, const char *text, va_list rest)
{
    (void)number;
    (void)text;
    (void)rest;
}

static void *begin(const pile *p, int iterations, bool may_sleep)
{
    static bool has_begun;
    room *r = calloc(1, sizeof *r);
    if (!has_begun && !dInitODE2(0)) give_up("ODE does not start");
    has_begun = true;
    dSetMessageHandler(keep_quiet);
    if (r) r->box = malloc((size_t)p->boxes * sizeof *r->box);
    if (!r || !r->box) give_up("there is no memory for ODE's boxes");
    dRandSetSeed(1);
    r->world = dWorldCreate();
    r->space = dSweepAndPruneSpaceCreate(NULL, dSAP_AXES_XZY);
    r->contacts = dJointGroupCreate(0);
    r->friction = p->friction;
    r->dt = p->dt;
    r->boxes = p->boxes;
    r->iterations = iterations;
    dWorldSetGravity(r->world, 0, -9.81, 0);
    if (iterations > 0) dWorldSetQuickStepNumIterations(r->world, iterations);
    dWorldSetAutoDisableFlag(r->world, may_sleep);
    for (int k = 0; k < p->walls; k++)
        dCreatePlane(r->space, p->normal[k].x, p->normal[k].y, p->normal[k].z,
                     p->offset[k]);
    for (int k = 0; k < p->boxes; k++)
        r->box[k] = add_box(r, &p->box[k], p->half);
    return r;
}

static bool is_awake(dBodyID b)
{
    return b && dBodyIsEnabled(b);
}

static void touch(void *self, dGeomID a, dGeomID b)
{
    const room *r = self;
    dBodyID x = dGeomGetBody(a), y = dGeomGetBody(b);
    dContact c[CONTACTS];
    if (!is_awake(x) && !is_awake(y)) return;
    int found = dCollide(a, b, CONTACTS, &c[0].geom, (int)sizeof *c);
    for (int k = 0; k < found; k++) {
        c[k].surface.mode = dContactApprox1;    // Coulomb's friction
        c[k].surface.mu = r->friction;
        dJointAttach(dJointCreateContact(r->world, r->contacts, &c[k]), x, y);
    }
}

static void step(void *self)
{
    room *r = self;
    dSpaceCollide(r->space, r, touch);
    if (!(r->iterations > 0 ? dWorldQuickStep(r->world, r->dt)
                            : dWorldStep(r->world, r->dt)))
        give_up("ODE's step failed");
    dJointGroupEmpty(r->contacts);
}

static pose look(const void *self, int box)
{
    dBodyID b = ((const room *)self)->box[box];
    const dReal *p = dBodyGetPosition(b), *r = dBodyGetRotation(b);
    return (pose){ { p[0], p[1], p[2] }, { r[0], r[4], r[8] },
                   { r[1], r[5], r[9] }, { r[2], r[6], r[10] } };
}

static int asleep(const void *self)
{
    const room *r = self;
    int count = 0;
    for (int k = 0; k < r->boxes; k++) count += !dBodyIsEnabled(r->box[k]);
    return count;
}

static void end(void *self)
{
    room *r = self;
    dJointGroupDestroy(r->contacts);
    dSpaceDestroy(r->space);
    dWorldDestroy(r->world);
    free(r->box);
    free(r);
}

const mover mover_ode = { "ODE " dODE_VERSION, begin, step, look, asleep, end };
