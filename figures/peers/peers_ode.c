// peers_ode.c - the room in ODE: quickstep with 20 iterations, convex against
// convex, sorted pairs, nothing sleeps.
//
// Convex bodies rather than triangle meshes: these take several times as long,
// and overlap as deep.  Everything that is not set is ODE's default.

#include "peers.h"
#include "peers_others.h"

#include <ode/ode.h>

#include <stdlib.h>

enum { FACES = 20, CONTACTS = 8, ITERATIONS = 20 };

static struct {
    dWorldID world;
    dSpaceID space;
    dJointGroupID contacts;
    int bodies;
    dBodyID *body;
    const shape *plan;
    dReal plane[FACES][4], point[CORNERS][3];
    unsigned polygon[FACES][4];     // 3, and the corners
} ode;

const char *ode_name(void) { return "ODE " dODE_VERSION; }

static void copy_plan(const shape *s)
{
    ode.plan = s;
    for (int i = 0; i < CORNERS; i++) {
        ode.point[i][0] = s->at[i].x;
        ode.point[i][1] = s->at[i].y;
        ode.point[i][2] = s->at[i].z;
    }
    for (int f = 0; f < FACES; f++) {
        const int *v = &s->face[3 * f];
        vec3 a = s->at[v[0]];
        vec3 n = vec3_unit(vec3_cross(vec3_sub(s->at[v[1]], a),
                                      vec3_sub(s->at[v[2]], a)));
        ode.plane[f][0] = n.x;
        ode.plane[f][1] = n.y;
        ode.plane[f][2] = n.z;
        ode.plane[f][3] = vec3_dot(n, a);
        ode.polygon[f][0] = 3;
        for (int k = 0; k < 3; k++) ode.polygon[f][1 + k] = (unsigned)v[k];
    }
}

static void add_walls(real side)
{
    dCreatePlane(ode.space, 0, 1, 0, 0);
    dCreatePlane(ode.space, 0, -1, 0, -side);
    dCreatePlane(ode.space, 1, 0, 0, -side / 2);
    dCreatePlane(ode.space, -1, 0, 0, -side / 2);
    dCreatePlane(ode.space, 0, 0, 1, -side / 2);
    dCreatePlane(ode.space, 0, 0, -1, -side / 2);
}

static dBodyID add_body(const placement *p, real inertia)
{
    dBodyID b = dBodyCreate(ode.world);
    dMatrix3 turn = { p->x.x, p->y.x, p->z.x, 0, p->x.y, p->y.y, p->z.y, 0,
                      p->x.z, p->y.z, p->z.z, 0 };
    dMass m;
    dMassSetParameters(&m, 1, 0, 0, 0, inertia, inertia, inertia, 0, 0, 0);
    dBodySetMass(b, &m);
    dBodySetPosition(b, p->position.x, p->position.y, p->position.z);
    dBodySetRotation(b, turn);
    dBodySetLinearVel(b, p->velocity.x, p->velocity.y, p->velocity.z);
    dBodySetAngularVel(b, p->spin.x, p->spin.y, p->spin.z);
    dGeomSetBody(dCreateConvex(ode.space, ode.plane[0], FACES, ode.point[0],
                               CORNERS, ode.polygon[0]), b);
    return b;
}

void ode_begin(const room *r)
{
    if (!dInitODE2(0)) give_up("ODE does not start");
    dRandSetSeed(1);
    ode.world = dWorldCreate();
    ode.space = dSweepAndPruneSpaceCreate(NULL, dSAP_AXES_XZY);
    ode.contacts = dJointGroupCreate(0);
    dWorldSetGravity(ode.world, 0, -9.81, 0);
    dWorldSetQuickStepNumIterations(ode.world, ITERATIONS);
    dWorldSetAutoDisableFlag(ode.world, 0);
    copy_plan(r->plan);
    add_walls(r->side);
    ode.bodies = r->bodies;
    ode.body = malloc((size_t)r->bodies * sizeof *ode.body);
    if (!ode.body) give_up("there is no memory for ODE's bodies");
    for (int k = 0; k < r->bodies; k++)
        ode.body[k] = add_body(&r->start[k], r->inertia);
}

static void touch(void *none, dGeomID a, dGeomID b)
{
    dContact c[CONTACTS];
    int found = dCollide(a, b, CONTACTS, &c[0].geom, (int)sizeof *c);
    (void)none;
    for (int k = 0; k < found; k++) {
        c[k].surface.mode = dContactApprox1;    // Coulomb's friction
        c[k].surface.mu = 0.5;
        dJointAttach(dJointCreateContact(ode.world, ode.contacts, &c[k]),
                     dGeomGetBody(a), dGeomGetBody(b));
    }
}

void ode_step(real dt)
{
    dSpaceCollide(ode.space, NULL, touch);
    if (!dWorldQuickStep(ode.world, dt)) give_up("ODE's step failed");
    dJointGroupEmpty(ode.contacts);
}

void ode_vertices(int k, vec3 *at)
{
    const dReal *p = dBodyGetPosition(ode.body[k]);
    const dReal *r = dBodyGetRotation(ode.body[k]);
    for (int i = 0; i < CORNERS; i++) {
        vec3 v = ode.plan->at[i];
        at[i] = vec3_make(p[0] + r[0] * v.x + r[1] * v.y + r[2] * v.z,
                          p[1] + r[4] * v.x + r[5] * v.y + r[6] * v.z,
                          p[2] + r[8] * v.x + r[9] * v.y + r[10] * v.z);
    }
}

void ode_end(void)
{
    free(ode.body);
    dJointGroupDestroy(ode.contacts);
    dSpaceDestroy(ode.space);
    dWorldDestroy(ode.world);
    dCloseODE();
}
