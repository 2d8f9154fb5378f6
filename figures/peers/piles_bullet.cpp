// piles_bullet.cpp - the piles in Bullet, which counts in float: the sequential
// impulse solver with so many iterations; all else is Bullet's default.  Bullet
// is C++, and so is this file, the only one.

#include "piles.h"

#include <btBulletDynamicsCommon.h>

#include <cstdio>
#include <memory>
#include <vector>

namespace {

struct room {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{ &configuration };
    btDbvtBroadphase broad;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{ &dispatcher, &broad, &solver,
                                   &configuration };
    std::vector<std::unique_ptr<btCollisionShape>> shape;
    std::vector<std::unique_ptr<btRigidBody>> wall, box;
    btScalar dt;

    ~room()
    {
        for (auto &b : box) world.removeRigidBody(b.get());
        for (auto &b : wall) world.removeRigidBody(b.get());
    }
};

btVector3 vector_of(vec3 v)
{
    return btVector3(btScalar(v.x), btScalar(v.y), btScalar(v.z));
}

vec3 vec3_of(const btVector3 &v)
{
    return vec3_make(v.x(), v.y(), v.z());
}

btTransform transform_of(const pose &p)
{
    btMatrix3x3 turn(btScalar(p.x.x), btScalar(p.y.x), btScalar(p.z.x),
                     btScalar(p.x.y), btScalar(p.y.y), btScalar(p.z.y),
                     btScalar(p.x.z), btScalar(p.y.z), btScalar(p.z.z));
    return btTransform(turn, vector_of(p.middle));
}

void add_wall(room *r, vec3 normal, real offset, btScalar friction)
{
    r->shape.emplace_back(new btStaticPlaneShape(vector_of(normal),
                                                 btScalar(offset)));
    r->wall.emplace_back(new btRigidBody(0, nullptr, r->shape.back().get()));
    r->wall.back()->setFriction(friction);
    r->world.addRigidBody(r->wall.back().get());
}

void add_box(room *r, btCollisionShape *cube, const start &s,
             btScalar friction, bool may_sleep)
{
    btVector3 inertia;
    cube->calculateLocalInertia(1, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(1, nullptr, cube, inertia);
    info.m_startWorldTransform = transform_of(s.at);
    r->box.emplace_back(new btRigidBody(info));
    btRigidBody *b = r->box.back().get();
    b->setLinearVelocity(vector_of(s.velocity));
    b->setAngularVelocity(vector_of(s.spin));
    b->setFriction(friction);
    if (!may_sleep) b->setActivationState(DISABLE_DEACTIVATION);
    r->world.addRigidBody(b);
}

void *begin(const pile *p, int iterations, bool may_sleep)
{
    room *r = new room;
    btScalar half = btScalar(p->half);
    // Bullet multiplies the frictions of two bodies.
    btScalar friction = btScalar(std::sqrt(p->friction));
    r->dt = btScalar(p->dt);
    r->world.setGravity(btVector3(0, btScalar(-9.81), 0));
    r->world.getSolverInfo().m_numIterations = iterations;
    for (int k = 0; k < p->walls; k++)
        add_wall(r, p->normal[k], p->offset[k], friction);
    btCollisionShape *cube = new btBoxShape(btVector3(half, half, half));
    r->shape.emplace_back(cube);
    for (int k = 0; k < p->boxes; k++)
        add_box(r, cube, p->box[k], friction, may_sleep);
    return r;
}

void step(void *self)
{
    room *r = static_cast<room *>(self);
    r->world.stepSimulation(r->dt, 0, r->dt);
}

pose look(const void *self, int box)
{
    const room *r = static_cast<const room *>(self);
    const btTransform &t = r->box[size_t(box)]->getWorldTransform();
    return pose{ vec3_of(t.getOrigin()), vec3_of(t.getBasis().getColumn(0)),
                 vec3_of(t.getBasis().getColumn(1)),
                 vec3_of(t.getBasis().getColumn(2)) };
}

int asleep(const void *self)
{
    int count = 0;
    for (auto &b : static_cast<const room *>(self)->box)
        count += !b->isActive();
    return count;
}

void end(void *self)
{
    delete static_cast<room *>(self);
}

} // namespace

extern const mover mover_bullet = { "Bullet", begin, step, look, asleep, end };
