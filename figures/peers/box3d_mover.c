// box3d_mover.c - rooms and piles in Box3D, which counts in float: so many
// substeps, one thread; all else is Box3D's default.

#include "piles.h"

#include <box3d/box3d.h>
#include <box3d/collision.h>

#include <stdlib.h>

// m: a wall is a box so thick, from its middle; what sticks out of the scene.
static const real THICK = 5, BEYOND = 10;

typedef struct {
    b3WorldId world;
    b3BodyId *body;         // [bodies]
    b3HullData *hull;       // of icosahedra
    b3BoxHull cube;
    int  bodies, substeps;
    real dt;
} room;

static b3Vec3 vector_of(vec3 v)
{
    return (b3Vec3){ (float)v.x, (float)v.y, (float)v.z };
}

static b3Pos place_of(vec3 v)
{
    return (b3Pos){ (float)v.x, (float)v.y, (float)v.z };
}

// How far walls have to reach along each axis.
static real extent(const pile *p)
{
    real far = 0;
    for (int k = 0; k < p->boxes; k++) {
        vec3 m = p->box[k].at.middle;
        far = fmax(far, fmax(fabs(m.x), fmax(fabs(m.y), fabs(m.z))));
    }
    return far + BEYOND;
}

static void add_wall(const room *r, const b3ShapeDef *surface, vec3 normal, real offset, real far)
{
    b3BodyDef what = b3DefaultBodyDef();
    what.position = place_of(vec3_scale(offset - THICK, normal));
    b3BoxHull box = b3MakeBoxHull((float)(fabs(normal.x) > 0.5 ? THICK : far),
                                  (float)(fabs(normal.y) > 0.5 ? THICK : far),
                                  (float)(fabs(normal.z) > 0.5 ? THICK : far));
    b3CreateHullShape(b3CreateBody(r->world, &what), surface, &box.base);
}

static void make_hull(room *r, const pile *p)
{
    b3Vec3 corner[PILE_CORNERS];
    float half = (float)p->half;
    if (half > 0) {
        r->cube = b3MakeBoxHull(half, half, half);
        return;
    }
    for (int k = 0; k < PILE_CORNERS / 2; k++) {
        corner[2 * k] = vector_of(p->body.corner[k]);
        corner[2 * k + 1] = vector_of(vec3_scale(-1, p->body.corner[k]));
    }
    r->hull = b3CreateHull(corner, PILE_CORNERS, PILE_CORNERS);
    if (!r->hull) give_up("Box3D makes no hull");
}

static b3BodyId add_body(const room *r, const b3ShapeDef *surface, const start *s, bool may_sleep)
{
    b3BodyDef what = b3DefaultBodyDef();
    b3Matrix3 turn = { vector_of(s->at.x), vector_of(s->at.y), vector_of(s->at.z) };
    what.type = b3_dynamicBody;
    what.position = place_of(s->at.middle);
    what.rotation = b3MakeQuatFromMatrix(&turn);
    what.linearVelocity = vector_of(s->velocity);
    what.angularVelocity = vector_of(s->spin);
    what.enableSleep = may_sleep;
    b3BodyId body = b3CreateBody(r->world, &what);
    b3CreateHullShape(body, surface, r->hull ? r->hull : &r->cube.base);
    return body;
}

// m^3; an icosahedron of radius 1 has 2.53615 of them.
static real volume(const pile *p)
{
    real cube = 2 * p->half, r = p->radius;
    return p->half > 0 ? cube * cube * cube : 2.536150 * r * r * r;
}

static void *begin(const pile *p, int substeps, bool may_sleep)
{
    room *r = calloc(1, sizeof *r);
    if (r) r->body = malloc((size_t)p->boxes * sizeof *r->body);
    if (!r || !r->body) give_up("there is no memory for Box3D's bodies");
    b3WorldDef how = b3DefaultWorldDef();
    b3ShapeDef surface = b3DefaultShapeDef();
    how.gravity = (b3Vec3){ 0, -9.81f, 0 };
    how.enableSleep = may_sleep;
    how.workerCount = 1;
    surface.baseMaterial.friction = (float)p->friction;
    surface.baseMaterial.restitution = 0;
    r->world = b3CreateWorld(&how);
    r->bodies = p->boxes;
    r->substeps = substeps;
    r->dt = p->dt;
    make_hull(r, p);
    for (int k = 0; k < p->walls; k++)
        add_wall(r, &surface, p->normal[k], p->offset[k], extent(p));
    surface.density = (float)(1 / volume(p));
    for (int k = 0; k < p->boxes; k++)
        r->body[k] = add_body(r, &surface, &p->box[k], may_sleep);
    return r;
}

static void step(void *self)
{
    const room *r = self;
    b3World_Step(r->world, (float)r->dt, r->substeps);
}

static vec3 vec3_of(b3Vec3 v)
{
    return vec3_make(v.x, v.y, v.z);
}

static pose look(const void *self, int k)
{
    const room *r = self;
    b3Pos at = b3Body_GetPosition(r->body[k]);
    b3Quat q = b3Body_GetRotation(r->body[k]);
    return (pose){ vec3_make(at.x, at.y, at.z),
                   vec3_unit(vec3_of(b3RotateVector(q, (b3Vec3){ 1, 0, 0 }))),
                   vec3_unit(vec3_of(b3RotateVector(q, (b3Vec3){ 0, 1, 0 }))),
                   vec3_unit(vec3_of(b3RotateVector(q, (b3Vec3){ 0, 0, 1 }))) };
}

static int asleep(const void *self)
{
    const room *r = self;
    return r->bodies - b3World_GetAwakeBodyCount(r->world);
}

static void end(void *self)
{
    room *r = self;
    b3DestroyWorld(r->world);
    if (r->hull) b3DestroyHull(r->hull);
    free(r->body);
    free(r);
}

const mover mover_box3d = { "Box3D", begin, step, look, asleep, end };
