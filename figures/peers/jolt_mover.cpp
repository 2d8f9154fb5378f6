// jolt_mover.cpp - the scenes in Jolt, which counts in float: one thread, and all
// as it comes but what the scene says.

#include "race.h"

#include <Jolt/Jolt.h>

#include <Jolt/Core/Factory.h>
#include <Jolt/Core/JobSystemSingleThreaded.h>
#include <Jolt/Core/TempAllocator.h>
#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Body/BodyLock.h>
#include <Jolt/Physics/Body/BodyLockMulti.h>
#include <Jolt/Physics/Collision/BroadPhase/BroadPhaseLayerInterfaceTable.h>
#include <Jolt/Physics/Collision/BroadPhase/ObjectVsBroadPhaseLayerFilterTable.h>
#include <Jolt/Physics/Collision/GroupFilterTable.h>
#include <Jolt/Physics/Collision/ObjectLayerPairFilterTable.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/Collision/Shape/ConvexHullShape.h>
#include <Jolt/Physics/Collision/Shape/SphereShape.h>
#include <Jolt/Physics/Constraints/PointConstraint.h>
#include <Jolt/Physics/PhysicsSystem.h>
#include <Jolt/Physics/SoftBody/SoftBodyCreationSettings.h>
#include <Jolt/Physics/SoftBody/SoftBodyMotionProperties.h>
#include <Jolt/RegisterTypes.h>

#include <algorithm>
#include <cfloat>
#include <vector>

using namespace JPH;

namespace {

// m: a wall is a box so thick, from its middle; what sticks out of the scene.
const real THICK = 5, BEYOND = 20;
const ObjectLayer STILL = 0, MOVING = 1;

struct layers {
    BroadPhaseLayerInterfaceTable of{ 2, 2 };
    ObjectLayerPairFilterTable pairs{ 2 };
    ObjectVsBroadPhaseLayerFilterTable *wide;
    layers()
    {
        of.MapObjectToBroadPhaseLayer(STILL, BroadPhaseLayer(0));
        of.MapObjectToBroadPhaseLayer(MOVING, BroadPhaseLayer(1));
        pairs.EnableCollision(STILL, MOVING);
        pairs.EnableCollision(MOVING, MOVING);
        wide = new ObjectVsBroadPhaseLayerFilterTable(of, 2, pairs, 2);
    }
    ~layers() { delete wide; }
};

struct room {
    layers where;
    PhysicsSystem physics;
    TempAllocatorImplWithMallocFallback memory{ 64 * 1024 * 1024 };
    JobSystemSingleThreaded jobs{ cMaxPhysicsJobs };
    std::vector<BodyID> body;
    BodyID cloth;
    bool has_cloth = false;
    int fixed = 0, steps = 1, iterations = 0;
    float dt = 0;
};

Vec3 vector_of(vec3 v)
{
    return Vec3((float)v.x, (float)v.y, (float)v.z);
}

vec3 vec3_of(Vec3 v)
{
    return vec3_make(v.GetX(), v.GetY(), v.GetZ());
}

Quat turn_of(const pose &p)
{
    return Mat44(Vec4(vector_of(p.x), 0), Vec4(vector_of(p.y), 0),
                 Vec4(vector_of(p.z), 0), Vec4(0, 0, 0, 1)).GetQuaternion().Normalized();
}

real extent(const scene *s)
{
    real far = 0;
    for (int k = 0; k < s->bodies; k++) {
        vec3 m = s->body[k].at.middle;
        far = std::max({ far, fabs(m.x), fabs(m.y), fabs(m.z) });
    }
    return far + BEYOND;
}

// Its edges are rounded by 5 cm where the body is large enough.
RefConst<Shape> shape_of(const body_form &f)
{
    if (f.kind == FORM_BALL) return new SphereShape((float)f.radius);
    if (f.kind == FORM_BOX) {
        float least = (float)std::min({ f.half.x, f.half.y, f.half.z });
        return new BoxShape(vector_of(f.half), std::min(cDefaultConvexRadius, least / 2));
    }
    Array<Vec3> corner;
    for (int k = 0; k < f.corners; k++) {
        corner.push_back(vector_of(f.corner[k]));
        corner.push_back(-vector_of(f.corner[k]));
    }
    ShapeSettings::ShapeResult made = ConvexHullShapeSettings(corner).Create();
    if (made.HasError()) give_up("Jolt makes no hull");
    return made.Get();
}

void add_wall(room *r, const scene *s, int k)
{
    vec3 n = s->normal[k];
    float far = (float)extent(s), thick = (float)THICK;
    Vec3 half(fabs(n.x) > 0.5 ? thick : far, fabs(n.y) > 0.5 ? thick : far,
              fabs(n.z) > 0.5 ? thick : far);
    BodyCreationSettings what(new BoxShape(half),
                              vector_of(vec3_scale(s->offset[k] - THICK, n)),
                              Quat::sIdentity(), EMotionType::Static, STILL);
    what.mFriction = (float)s->friction;
    r->physics.GetBodyInterface().CreateAndAddBody(what, EActivation::DontActivate);
}

BodyID add_body(room *r, const scene *s, int k, const Shape *shape,
                GroupFilterTable *groups, bool may_sleep)
{
    const body_start &b = s->body[k];
    bool is_fixed = k < s->fixed;
    BodyCreationSettings what(shape, vector_of(b.at.middle), turn_of(b.at),
                              is_fixed ? EMotionType::Static : EMotionType::Dynamic,
                              is_fixed ? STILL : MOVING);
    what.mLinearVelocity = vector_of(b.velocity);
    what.mAngularVelocity = vector_of(b.spin);
    what.mFriction = (float)s->friction;
    what.mAllowSleeping = may_sleep;
    what.mOverrideMassProperties = EOverrideMassProperties::CalculateInertia;
    what.mMassPropertiesOverride.mMass = (float)s->form[b.form].mass;
    if (groups) what.mCollisionGroup = CollisionGroup(groups, 0, (unsigned)k);
    return r->physics.GetBodyInterface().CreateAndAddBody(what, EActivation::Activate);
}

void add_joint(room *r, const ball_joint &j)
{
    PointConstraintSettings what;
    what.mPoint1 = what.mPoint2 = vector_of(j.at);
    if (r->iterations)
        what.mNumVelocityStepsOverride = (unsigned)r->iterations;
    BodyID id[2] = { j.b < 0 ? BodyID() : r->body[(size_t)j.b], r->body[(size_t)j.a] };
    BodyLockMultiWrite lock(r->physics.GetBodyLockInterface(), id, 2);
    Body *b = lock.GetBody(0);
    r->physics.AddConstraint(what.Create(b ? *b : Body::sFixedToWorld, *lock.GetBody(1)));
}

// Threads along rows, columns and diagonals that give as much as those of its own
// examples.  (With none that give, and with none across, it explodes sooner.)
Ref<SoftBodySharedSettings> sheet_of(const cloth_sheet &c)
{
    Ref<SoftBodySharedSettings> to = new SoftBodySharedSettings;
    unsigned n = (unsigned)c.side;
    float wide = (float)c.width / (float)(n - 1), half = (float)c.width / 2;
    for (unsigned k = 0; k < n * n; k++) {
        Float3 at((float)(k % n) * wide - half, 0, (float)(k / n) * wide - half);
        to->mVertices.push_back(SoftBodySharedSettings::Vertex(
            at, Float3(0, 0, 0), (float)(n * n) / (float)c.mass));
    }
    for (int k = 0; k < c.pins; k++)
        to->mVertices[(size_t)sheet_corner(&c, k)].mInvMass = 0;
    for (unsigned j = 0; j + 1 < n; j++)
        for (unsigned i = 0; i + 1 < n; i++) {
            unsigned a = j * n + i;
            to->AddFace(SoftBodySharedSettings::Face(a, a + n, a + n + 1));
            to->AddFace(SoftBodySharedSettings::Face(a, a + n + 1, a + 1));
        }
    SoftBodySharedSettings::VertexAttributes give(1.0e-5f, 1.0e-5f, FLT_MAX);
    to->CreateConstraints(&give, 1, SoftBodySharedSettings::EBendType::None);
    to->Optimize();
    return to;
}

void add_sheet(room *r, const scene *s, bool may_sleep)
{
    SoftBodyCreationSettings what(sheet_of(s->sheet), vector_of(s->sheet.middle),
                                  Quat::sIdentity(), MOVING);
    what.mFriction = (float)s->friction;
    what.mAllowSleeping = may_sleep;
    if (r->iterations) what.mNumIterations = (unsigned)r->iterations;
    r->cloth = r->physics.GetBodyInterface().CreateAndAddSoftBody(what, EActivation::Activate);
    r->has_cloth = true;
}

void begin_jolt()
{
    static bool is_begun;
    if (is_begun) return;
    is_begun = true;
    RegisterDefaultAllocator();
    Factory::sInstance = new Factory();
    RegisterTypes();
}

void set_up(room *r, const scene *s, int setting)
{
    const unsigned most = 65536;
    r->fixed = s->fixed;
    r->steps = setting > 0 ? setting : 1;
    r->iterations = setting < 0 ? -setting : 0;
    r->dt = (float)s->dt;
    r->physics.Init((unsigned)s->bodies + 16, 0, most, most, r->where.of,
                    *r->where.wide, r->where.pairs);
    r->physics.SetGravity(Vec3(0, -9.81f, 0));
    PhysicsSettings how = r->physics.GetPhysicsSettings();
    if (r->iterations) how.mNumVelocitySteps = (unsigned)r->iterations;
    r->physics.SetPhysicsSettings(how);
}

void *begin(const scene *s, int setting, bool may_sleep)
{
    begin_jolt();
    room *r = new room;
    set_up(r, s, setting);
    Ref<GroupFilterTable> groups;
    if (s->joints) {
        groups = new GroupFilterTable((unsigned)s->bodies);
        for (int k = 0; k < s->joints; k++)
            if (s->joint[k].b >= 0)
                groups->DisableCollision((unsigned)s->joint[k].a, (unsigned)s->joint[k].b);
    }
    RefConst<Shape> shape[FORMS];
    for (int k = 0; k < s->forms; k++) shape[k] = shape_of(s->form[k]);
    for (int k = 0; k < s->walls; k++) add_wall(r, s, k);
    for (int k = 0; k < s->bodies; k++)
        r->body.push_back(add_body(r, s, k, shape[s->body[k].form], groups, may_sleep));
    for (int k = 0; k < s->joints; k++) add_joint(r, s->joint[k]);
    if (s->sheet.side) add_sheet(r, s, may_sleep);
    r->physics.OptimizeBroadPhase();
    return r;
}

void step(void *self)
{
    room *r = (room *)self;
    if (r->physics.Update(r->dt, r->steps, &r->memory, &r->jobs) != EPhysicsUpdateError::None)
        give_up("Jolt has no room for what touches");
}

pose look(const void *self, int k)
{
    const room *r = (const room *)self;
    const BodyInterface &bodies = r->physics.GetBodyInterfaceNoLock();
    BodyID id = r->body[(size_t)k];
    Quat q = bodies.GetRotation(id);
    pose p;
    p.middle = vec3_of(bodies.GetCenterOfMassPosition(id));
    p.x = vec3_unit(vec3_of(q * Vec3::sAxisX()));
    p.y = vec3_unit(vec3_of(q * Vec3::sAxisY()));
    p.z = vec3_unit(vec3_of(q * Vec3::sAxisZ()));
    return p;
}

void vertices(const void *self, vec3 *at)
{
    const room *r = (const room *)self;
    BodyLockRead lock(r->physics.GetBodyLockInterfaceNoLock(), r->cloth);
    const Body &body = lock.GetBody();
    const SoftBodyMotionProperties *soft =
        static_cast<const SoftBodyMotionProperties *>(body.GetMotionProperties());
    RMat44 to = body.GetCenterOfMassTransform();
    for (const SoftBodyMotionProperties::Vertex &v : soft->GetVertices())
        *at++ = vec3_of(to * v.mPosition);
}

int asleep(const void *self)
{
    const room *r = (const room *)self;
    return (int)r->body.size() - r->fixed
         - (int)r->physics.GetNumActiveBodies(EBodyType::RigidBody);
}

void end(void *self)
{
    delete (room *)self;
}

}

extern "C" const mover jolt_mover = { begin, step, look, vertices, asleep, end };
