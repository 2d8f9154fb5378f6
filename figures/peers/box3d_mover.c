// box3d_mover.c - the scenes in Box3D, which counts in float: one thread, and all
// as it comes but what the scene says.

#include "race.h"

#include <box3d/box3d.h>
#include <box3d/collision.h>

#include <stdlib.h>

enum { SUBSTEPS = 4 };      // what its samples and its manual take

// m: a wall is a box so thick, from its middle; what sticks out of the scene.
static const real THICK = 5, BEYOND = 20;

typedef struct {
    b3WorldId world;
    b3BodyId *body, ground;     // [bodies]
    int  bodies, fixed, substeps;
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

static b3Quat turn_of(const pose *p)
{
    b3Matrix3 turn = { vector_of(p->x), vector_of(p->y), vector_of(p->z) };
    return b3MakeQuatFromMatrix(&turn);
}

// How far walls have to reach along each axis.
static real extent(const scene *s)
{
    real far = 0;
    for (int k = 0; k < s->bodies; k++) {
        vec3 m = s->body[k].at.middle;
        far = fmax(far, fmax(fabs(m.x), fmax(fabs(m.y), fabs(m.z))));
    }
    return far + BEYOND;
}

static void add_wall(const room *r, const b3ShapeDef *surface, vec3 normal,
                     real offset, real far)
{
    b3BodyDef what = b3DefaultBodyDef();
    what.position = place_of(vec3_scale(offset - THICK, normal));
    b3BoxHull box = b3MakeBoxHull((float)(fabs(normal.x) > 0.5 ? THICK : far),
                                  (float)(fabs(normal.y) > 0.5 ? THICK : far),
                                  (float)(fabs(normal.z) > 0.5 ? THICK : far));
    b3CreateHullShape(b3CreateBody(r->world, &what), surface, &box.base);
}

static void add_icosahedron(b3BodyId body, const b3ShapeDef *surface,
                            const body_form *f)
{
    b3Vec3 corner[FORM_CORNERS];
    for (int k = 0; k < f->corners; k++) {
        corner[2 * k] = vector_of(f->corner[k]);
        corner[2 * k + 1] = vector_of(vec3_scale(-1, f->corner[k]));
    }
    b3HullData *hull = b3CreateHull(corner, FORM_CORNERS, FORM_CORNERS);
    if (!hull) give_up("Box3D makes no hull");
    b3CreateHullShape(body, surface, hull);
    b3DestroyHull(hull);
}

// m^3; an icosahedron of radius 1 has 2.53615 of them.
static real volume(const body_form *f)
{
    real r = f->radius;
    if (f->kind == FORM_BOX) return 8 * f->half.x * f->half.y * f->half.z;
    return (f->kind == FORM_BALL ? 4.18879 : 2.536150) * r * r * r;
}

static void add_form(b3BodyId body, b3ShapeDef surface, const body_form *f)
{
    surface.density = (float)(f->mass / volume(f));
    if (f->kind == FORM_BALL) {
        b3Sphere ball = { { 0, 0, 0 }, (float)f->radius };
        b3CreateSphereShape(body, &surface, &ball);
    } else if (f->kind == FORM_BOX) {
        b3BoxHull box = b3MakeBoxHull((float)f->half.x, (float)f->half.y,
                                      (float)f->half.z);
        b3CreateHullShape(body, &surface, &box.base);
    } else add_icosahedron(body, &surface, f);
}

static b3BodyId add_body(const room *r, const body_start *s, bool is_fixed,
                         bool may_sleep)
{
    b3BodyDef what = b3DefaultBodyDef();
    if (!is_fixed) what.type = b3_dynamicBody;
    what.position = place_of(s->at.middle);
    what.rotation = turn_of(&s->at);
    what.linearVelocity = vector_of(s->velocity);
    what.angularVelocity = vector_of(s->spin);
    what.enableSleep = may_sleep;
    return b3CreateBody(r->world, &what);
}

static void add_joint(const room *r, const scene *s, const ball_joint *j)
{
    b3SphericalJointDef what = b3DefaultSphericalJointDef();
    what.base.bodyIdA = j->b < 0 ? r->ground : r->body[j->b];
    what.base.bodyIdB = r->body[j->a];
    const pose zero = { .x = { 1, 0, 0 }, .y = { 0, 1, 0 }, .z = { 0, 0, 1 } };
    const pose *side[2] = { j->b < 0 ? &zero : &s->body[j->b].at, &s->body[j->a].at };
    b3Transform *frame[2] = { &what.base.localFrameA, &what.base.localFrameB };
    for (int k = 0; k < 2; k++) {
        vec3 arm = vec3_sub(j->at, side[k]->middle);
        frame[k]->p = vector_of(vec3_make(vec3_dot(arm, side[k]->x),
                                          vec3_dot(arm, side[k]->y),
                                          vec3_dot(arm, side[k]->z)));
        b3Quat q = turn_of(side[k]);
        frame[k]->q = (b3Quat){ { -q.v.x, -q.v.y, -q.v.z }, q.s };
    }
    b3CreateSphericalJoint(r->world, &what);
}

static b3WorldId make_world(bool may_sleep)
{
    b3WorldDef how = b3DefaultWorldDef();
    how.gravity = (b3Vec3){ 0, -9.81f, 0 };
    how.enableSleep = may_sleep;
    how.workerCount = 1;
    return b3CreateWorld(&how);
}

static void *begin(const scene *s, int setting, bool may_sleep)
{
    room *r = calloc(1, sizeof *r);
    if (r) r->body = malloc((size_t)(s->bodies + 1) * sizeof *r->body);
    if (!r || !r->body) give_up("there is no memory for Box3D's bodies");
    if (s->sheet.side) give_up("Box3D has no cloth");
    b3ShapeDef surface = b3DefaultShapeDef();
    surface.baseMaterial.friction = (float)s->friction;
    surface.baseMaterial.restitution = 0;
    r->world = make_world(may_sleep);
    r->bodies = s->bodies;
    r->fixed = s->fixed;
    r->substeps = setting ? setting : SUBSTEPS;
    r->dt = s->dt;
    b3BodyDef ground = b3DefaultBodyDef();
    r->ground = b3CreateBody(r->world, &ground);
    for (int k = 0; k < s->walls; k++)
        add_wall(r, &surface, s->normal[k], s->offset[k], extent(s));
    for (int k = 0; k < s->bodies; k++) {
        r->body[k] = add_body(r, &s->body[k], k < s->fixed, may_sleep);
        add_form(r->body[k], surface, &s->form[s->body[k].form]);
    }
    for (int k = 0; k < s->joints; k++) add_joint(r, s, &s->joint[k]);
    return r;
}

static void step(void *self)
{
    const room *r = self;
    b3World_Step(r->world, (float)r->dt, r->substeps);
}

static vec3 axis_of(b3Quat q, float x, float y, float z)
{
    b3Vec3 v = b3RotateVector(q, (b3Vec3){ x, y, z });
    return vec3_unit(vec3_make(v.x, v.y, v.z));
}

static pose look(const void *self, int k)
{
    const room *r = self;
    b3Pos at = b3Body_GetPosition(r->body[k]);
    b3Quat q = b3Body_GetRotation(r->body[k]);
    return (pose){ vec3_make(at.x, at.y, at.z), axis_of(q, 1, 0, 0),
                   axis_of(q, 0, 1, 0), axis_of(q, 0, 0, 1) };
}

static void vertices(const void *self, vec3 *at)
{
    (void)self, (void)at;
    give_up("Box3D has no cloth");
}

static int asleep(const void *self)
{
    const room *r = self;
    return r->bodies - r->fixed - b3World_GetAwakeBodyCount(r->world);
}

static void end(void *self)
{
    room *r = self;
    b3DestroyWorld(r->world);
    free(r->body);
    free(r);
}

const mover box3d_mover = { begin, step, look, vertices, asleep, end };
