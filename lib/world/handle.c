//> handle-where
//>   Verlet's velocity is half a substep old. Gravity has given a falling body
//>   some speed since, which is added. For a body at rest contacts have
//>   cancelled it.
#include "handle.h"

#include <assert.h>

// The vector d of the shape, in the world.
static vec3 vector_now(const rigid_frame *now, const rigid_frame *rest, vec3 d)
{
    return frame_vector(now, frame_local(rest, d));
}

// Does something hold a rope or a cloth: a nail, a pin, or what does not move?
static bool is_soft_held(const world *w, int b)
{
    const body *x = &w->body[b];
    bool is_held = false;
    for (int i = x->first; i < x->first + body_particles(x); i++)
        is_held |= !(w->pool.at[i].inverse_mass > 0)
                || w->soft.hold[i].state >= LINE_TOUCHES;
    for (int k = 0; k < w->joints.count && !is_held; k++) {
        const joint *j = &w->joints.joint[k];
        is_held = j->kind == JOINT_PIN && !j->is_broken && j->a == b;
    }
    return is_held;
}

// s, as rigid_since.
static real since_of(const world *w, int b)
{
    if (!body_is_soft(&w->body[b])) return rigid_since(w, b);
    return is_soft_held(w, b) ? 0 : w->age / 2;
}

static vec3 since_then(const world *w, int b)
{
    return vec3_scale(since_of(w, b), body_gravity(w, b));
}

static placement where_rigid(const world *w, int b)
{
    const body *x = &w->body[b];
    const particle *p = w->pool.at + x->first;
    rigid_frame now = rigid4_frame(p), rest = rigid4_rest(x->rigid);
    placement at = placement_at(now.center);
    at.x = vector_now(&now, &rest, at.x);
    at.y = vector_now(&now, &rest, at.y);
    at.z = vector_now(&now, &rest, at.z);
    vec3 out = vector_now(&now, &rest, x->rigid->center);
    at.position = vec3_sub(now.center, out);
    at.is_static = body_is_static(x);
    if (x->is_kinematic) {
        at.velocity = w->rigid.drive[b].velocity;
        at.spin = w->rigid.drive[b].spin;
    }
    if (!body_moves(w, b)) return at;
    motion_basis basis = basis_find(x->rigid, &now);
    motion u = motion_of(p, &now, &basis, body_age(w, b));
    at.velocity = vec3_add(motion_straight(&u), since_then(w, b));
    at.spin = motion_rotation(&basis, &u);
    return at;
}

placement world_where(const world *w, int b)
{
    assert(b >= 0 && b < w->bodies);
    const body *x = &w->body[b];
    if (!body_is_soft(x)) return where_rigid(w, b);
    int n = body_particles(x);
    placement at = placement_at(vec3_make(0, 0, 0));
    for (int i = x->first; i < x->first + n; i++) {
        const particle *p = &w->pool.at[i];
        vec3 delta = vec3_sub(p->position, p->previous);
        at.position = vec3_add_scaled(at.position, 1.0 / n, p->position);
        at.velocity = vec3_add_scaled(at.velocity, 1 / (n * w->age), delta);
    }
    at.is_static = body_is_static(x);
    if (body_moves(w, b)) at.velocity = vec3_add(at.velocity, since_then(w, b));
    return at;
}
//<

//> handle-put
//>   To put a body elsewhere is to remove it and to add it again.
// A body that is put elsewhere is one that is gone and has come: only its
// number, its shape and its particles stay.
status world_put(world *w, int b, placement where)
{
    assert(b >= 0 && b < w->bodies && !body_is_gone(&w->body[b]));
    const body *x = &w->body[b];
    status done = placement_check(&where, x->shape, b);
    if (!done.ok) return done;
    where.is_static = body_is_static(x);
    world_wake_around(w, b);
    cache_forget(&w->rigid.cache, &b, 1);
    soft_forget(&w->soft, b);
    world_place(w, b, &where);
    if (x->is_kinematic)
        w->rigid.drive[b] = (body_drive){ where.velocity, where.spin };
    world_wake_around(w, b);
    return done;
}
//<

//> handle-push
//>   A sleeper is pinned, so its particles get their masses back before it is
//>   pushed.
// Adds to the velocity of a rigid body: its particles were elsewhere.
static void add_velocity(world *w, int b, vec3 velocity, vec3 spin)
{
    particle *p = w->pool.at + w->body[b].first;
    rigid_frame now = rigid4_frame(p);
    for (int k = 0; k < FOUR; k++) {
        vec3 v = vec3_add(velocity, vec3_cross(spin, frame_arm(&now, k)));
        p[k].previous = vec3_add_scaled(p[k].previous, -body_age(w, b), v);
    }
}

static bool wake_rigid(world *w, int b)
{
    assert(b >= 0 && b < w->bodies && !body_is_soft(&w->body[b]));
    if (!body_is_dynamic(&w->body[b])) return false;
    world_wake(w, b);
    w->is_still = false;
    return true;
}

static void drive(world *w, int b, vec3 velocity, vec3 spin)
{
    w->rigid.drive[b] = (body_drive){ velocity, spin };
    world_notice(w, b);
    w->is_still = false;
}

void world_set_velocity(world *w, int b, vec3 velocity, vec3 spin)
{
    assert(vec3_is_finite(velocity) && vec3_is_finite(spin));
    if (w->body[b].is_kinematic) drive(w, b, velocity, spin);
    if (!wake_rigid(w, b)) return;
    particle *p = w->pool.at + w->body[b].first;
    for (int k = 0; k < FOUR; k++) p[k].previous = p[k].position;
    w->rigid.held[b] = false;
    velocity = vec3_sub(velocity, since_then(w, b));
    add_velocity(w, b, velocity, spin);
}

void world_push(world *w, int b, vec3 impulse, vec3 at)
{
    assert(vec3_is_finite(impulse) && vec3_is_finite(at));
    if (!wake_rigid(w, b)) return;
    const body *x = &w->body[b];
    rigid_frame now = rigid4_frame(w->pool.at + x->first);
    motion_basis basis = basis_find(x->rigid, &now);
    motion u = { { 0 } };
    motion_push(&u, &basis, vec3_sub(at, now.center), impulse);
    add_velocity(w, b, motion_straight(&u), motion_rotation(&basis, &u));
}

void world_push_particle(world *w, int b, int i, vec3 impulse)
{
    assert(vec3_is_finite(impulse));
    particle *p = world_particle(w, b, i);
    w->is_still = false;
    p->previous = vec3_add_scaled(p->previous, -w->age * p->inverse_mass,
                                  impulse);
}
//<

//> handle-vertex
//>   A vertex of a rope or a cloth has a velocity, too. The mean of all of them is
//>   that of the body.
vec3 world_particle_velocity(const world *w, int b, int i)
{
    assert(b >= 0 && b < w->bodies && body_is_soft(&w->body[b]));
    assert(i >= 0 && i < body_particles(&w->body[b]));
    const particle *p = &w->pool.at[w->body[b].first + i];
    vec3 v = vec3_scale(1 / w->age, vec3_sub(p->position, p->previous));
    return body_moves(w, b) ? vec3_add(v, since_then(w, b)) : v;
}

bool world_set_particle_velocity(world *w, int b, int i, vec3 velocity)
{
    assert(vec3_is_finite(velocity));
    particle *p = world_particle(w, b, i);
    w->is_still = false;
    if (!(p->inverse_mass > 0)) return false;
    vec3 v = vec3_sub(velocity, since_then(w, b));
    p->previous = vec3_add_scaled(p->position, -w->age, v);
    return true;
}
//<

//> handle-gravity
//>   The velocities that particles have are half a substep old, and go on with the
//>   gravity of the world. Where another takes its place, they go on from what they
//>   are *now*.
// Adds to the velocity of all particles of a deformable body.
static void add_soft_velocity(world *w, const body *x, vec3 velocity)
{
    for (int i = x->first; i < x->first + body_particles(x); i++) {
        particle *p = &w->pool.at[i];
        if (p->inverse_mass > 0)
            p->previous = vec3_add_scaled(p->previous, -w->age, velocity);
    }
}

void world_set_gravity(world *w, vec3 gravity)
{
    assert(vec3_is_finite(gravity));
    vec3 less = vec3_sub(w->options.gravity, gravity), none = { 0, 0, 0 };
    for (int b = 0; b < w->bodies; b++) {
        const body *x = &w->body[b];
        world_wake(w, b);
        if (!body_moves(w, b)) continue;
        vec3 change = vec3_scale(x->gravity * since_of(w, b), less);
        if (body_is_soft(x)) add_soft_velocity(w, x, change);
        else add_velocity(w, b, change, none);
    }
    w->options.gravity = gravity;
    for (int b = 0; b < w->bodies; b++)
        w->body[b].taut = world_taut(w, &w->body[b]);
}

status world_set_gravity_scale(world *w, int b, real scale)
{
    assert(b >= 0 && b < w->bodies && !body_is_soft(&w->body[b]));
    if (!(fabs(scale) <= 1000))
        return status_fail("%g times the world's gravity on a body; it must lie "
                           "between -1000 and 1000", scale);
    vec3 was = since_then(w, b), none = { 0, 0, 0 };
    world_wake_around(w, b);
    w->body[b].gravity = scale;
    w->most_gravity = real_max(fabs(scale), w->most_gravity);
    w->is_still = false;
    if (body_moves(w, b)) add_velocity(w, b, vec3_sub(was, since_then(w, b)), none);
    return status_ok();
}
//<

//> handle-force
//>   A force acts through the next frame, with an equal part in each substep
//>   (`constant_force_gives_force_times_time_by_mass`).
void world_force(world *w, int b, vec3 force, vec3 torque)
{
    assert(vec3_is_finite(force) && vec3_is_finite(torque));
    if (!wake_rigid(w, b)) return;
    body_load *load = &w->rigid.load[b];
    load->force = vec3_add(load->force, force);
    load->torque = vec3_add(load->torque, torque);
    w->rigid.is_loaded = true;
}

motion world_load(const world *w, int b, real seconds)
{
    const motion_basis *basis = &w->rigid.now[b].basis;
    const body_load *load = &w->rigid.load[body_whole(&w->body[b], b)];
    const vec3 center = { 0, 0, 0 };
    motion u = { { 0 } };
    motion_push(&u, basis, center, vec3_scale(seconds, load->force));
    motion_twist(&u, basis, vec3_scale(seconds, load->torque));
    return u;
}

void world_forget_loads(world *w)
{
    for (int k = 0; k < w->rigid.awakes && w->rigid.is_loaded; k++)
        w->rigid.load[w->rigid.awake[k]] = (body_load){ .force = { 0, 0, 0 } };
    w->rigid.is_loaded = false;
}
//<

//> handle-material
//>   Friction, restitution and damping of a body.
static status take_material(const world *w, material *own, material m)
{
    if (m.friction < 0) m.friction = w->options.friction;
    if (m.restitution < 0) m.restitution = w->options.restitution;
    if (!(m.friction <= 1000))
        return status_fail("friction is %g; it must be at most 1000",
                           m.friction);
    if (!(m.restitution <= 1))
        return status_fail("restitution is %g; it must be at most 1",
                           m.restitution);
    *own = m;
    return status_ok();
}

status world_set_material(world *w, int b, material m)
{
    assert(b >= 0 && b < w->bodies);
    world_wake_around(w, b);
    return take_material(w, &w->rigid.material[b], m);
}

status world_set_plane_material(world *w, int k, material m)
{
    assert(k >= 0 && k < w->planes);
    return take_material(w, &w->wall[k], m);
}

status world_set_damping(world *w, int b, real damping, real spin_damping)
{
    assert(b >= 0 && b < w->bodies);
    if (!(damping >= 0 && damping < HUGE_VAL
          && spin_damping >= 0 && spin_damping < HUGE_VAL))
        return status_fail("the damping of a body is %g and %g; both must be "
                           "finite, and 0 or more", damping, spin_damping);
    w->body[b].damping = damping;
    w->body[b].spin_damping = spin_damping;
    w->is_damped |= damping > 0 || spin_damping > 0;
    return status_ok();
}
//<

//> handle-kind
//>   A body becomes dynamic, static or kinematic.
static body_kind kind_of(const body *b)
{
    if (body_is_static(b)) return BODY_STATIC;
    return b->is_kinematic ? BODY_KINEMATIC : BODY_DYNAMIC;
}

// To the books only a dynamic one has a mass: what a kinematic one gives comes from
// outside.
void world_set_kind(world *w, int b, body_kind kind)
{
    assert(b >= 0 && b < w->bodies && !body_is_soft(&w->body[b]));
    body *x = &w->body[b];
    body_kind was = kind_of(x);
    real inverse = kind == BODY_STATIC ? 0 : 1 / x->rigid->mass;
    if (kind == was) return;
    placement at = world_where(w, b);
    world_wake_around(w, b);
    w->kinematic_bodies += (kind == BODY_KINEMATIC) - (was == BODY_KINEMATIC);
    w->dynamic_bodies += (kind == BODY_DYNAMIC) - (was == BODY_DYNAMIC);
    x->is_kinematic = kind == BODY_KINEMATIC;
    x->mass = kind == BODY_STATIC ? HUGE_VAL : FOUR * x->rigid->mass;
    for (int i = x->first; i < x->first + FOUR; i++) {
        particle *p = &w->pool.at[i];
        p->inverse_mass = inverse;
        p->previous = p->position;
        w->inverse_mass[i] = kind == BODY_DYNAMIC ? inverse : 0;
    }
    if (was == BODY_STATIC || kind == BODY_STATIC) w->rigid.age[b] = w->age;
    world_renew(w, b);
    w->rigid.drive[b] = (body_drive){ .velocity = { 0, 0, 0 } };
    if (kind == BODY_DYNAMIC) world_set_velocity(w, b, at.velocity, at.spin);
}

void world_set_filter(world *w, int b, unsigned group, unsigned mask)
{
    assert(b >= 0 && b < w->bodies);
    w->body[b].group = group;
    w->body[b].mask = mask;
    world_wake_around(w, b);
    world_renew(w, b);
}

void world_set_family(world *w, int b, int family)
{
    assert(b >= 0 && b < w->bodies && family >= 0);
    w->body[b].family = family;
}
//<

//> handle-sleep
//>   A body is woken, or sent to sleep.
void world_sleep(world *w, int b)
{
    assert(b >= 0 && b < w->bodies);
    if (!body_moves(w, b)) return;
    sleep_put(&w->sleep, b);
    w->rigid.load[b] = (body_load){ .force = { 0, 0, 0 } };
    world_pin_sleeper(w, b);
}
//<
