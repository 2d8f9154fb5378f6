//> face-where
//>   To ask a body where it is, its position and rotation are taken out of its
//>   four particles (chapter 18, *From outside*).
#include "handle.h"
#include "inside.h"

#include <stddef.h>

// Where a body is; zeros if there is none.
static placement where_is(const tumble_world *w, tumble_body b)
{
    const body_place *x = inside_body_of(w, b);
    placement p = { .is_static = true };
    if (x && x->mesh) inside_place(&p, x->mesh->pose);
    else if (x)       p = world_where(&w->world, x->piece[0].number);
    return p;
}

tumble_pose tumble_body_pose(const tumble_world *w, tumble_body b)
{
    placement p = where_is(w, b);
    if (!inside_body_of(w, b)) return (tumble_pose){ { 0, 0, 0 }, { 0, 0, 0, 0 } };
    return (tumble_pose){ to_user(p.position), inside_quat(p.x, p.y, p.z) };
}

tumble_vec3 tumble_body_position(const tumble_world *w, tumble_body b)
{
    return to_user(where_is(w, b).position);
}

tumble_vec3 tumble_body_velocity(const tumble_world *w, tumble_body b)
{
    return to_user(where_is(w, b).velocity);
}

tumble_vec3 tumble_body_spin(const tumble_world *w, tumble_body b)
{
    return to_user(where_is(w, b).spin);
}

double tumble_body_mass(const tumble_world *w, tumble_body b)
{
    const body_place *x = inside_body_of(w, b);
    if (!x || x->kind != TUMBLE_DYNAMIC) return 0;
    return w->world.body[x->piece[0].number].mass;
}

void *tumble_body_user(const tumble_world *w, tumble_body b)
{
    const body_place *x = inside_body_of(w, b);
    return x ? x->user : NULL;
}

bool tumble_body_set_user(tumble_world *w, tumble_body b, void *user)
{
    body_place *x = inside_body(w, b);
    if (x) x->user = user;
    return x != NULL;
}
//<

//> face-options
//>   What was set can be asked for: the options with which another such body would
//>   be added.
tumble_body_options tumble_body_get_options(const tumble_world *w,
                                            tumble_body b)
{
    const body_place *x = inside_body_of(w, b);
    if (!x) return (tumble_body_options){ .group = 0 };
    int number = x->piece[0].number;
    const body *all = &w->world.body[number];
    material m = w->world.rigid.material[number];
    placement p = where_is(w, b);
    return (tumble_body_options){
        .kind = x->kind, .pose = tumble_body_pose(w, b),
        .velocity = to_user(p.velocity), .spin = to_user(p.spin),
        .friction = m.friction, .restitution = m.restitution,
        .damping = all->damping, .spin_damping = all->spin_damping,
        .group = x->is_sensor ? x->group : all->group,
        .mask = x->is_sensor ? x->mask : all->mask, .user = x->user };
}

tumble_shape tumble_body_shape(const tumble_world *w, tumble_body b)
{
    const body_place *x = inside_body_of(w, b);
    if (!x || x->mesh) return (tumble_shape){ 0, 0 };
    int k = x->piece[0].shape;
    return (tumble_shape){ (unsigned)k, slots_generation(&w->shapes, k) };
}
//<

//> face-bulk
//>   A game draws all of them in every frame, so it may ask for all at once, or
//>   only for those that moved. The engine has a list of those that are awake.
void tumble_body_poses(const tumble_world *w, const tumble_body *b, int n,
                       tumble_pose *out)
{
    for (int k = 0; k < n && b && out; k++) out[k] = tumble_body_pose(w, b[k]);
}

void tumble_body_velocities(const tumble_world *w, const tumble_body *b, int n,
                            tumble_vec3 *velocity, tumble_vec3 *spin)
{
    for (int k = 0; k < n && b; k++) {
        placement p = where_is(w, b[k]);
        if (velocity) velocity[k] = to_user(p.velocity);
        if (spin)     spin[k] = to_user(p.spin);
    }
}

// Is body b of the engine there, and the first piece of its own?
static bool is_first(const tumble_world *w, int b)
{
    if (body_is_gone(&w->world.body[b]) || inside_mesh(w, b)) return false;
    const body_place *x = slots_at(&w->bodies, w->owner[b]);
    return x->piece[0].number == b;
}

int tumble_world_moved(const tumble_world *w, tumble_body *out, int most)
{
    int n = 0;
    if (!w || w->world.report.substeps == 0) return 0;
    const rigid_tables *t = &w->world.rigid;
    for (int k = 0; k < t->awakes; k++) {
        if (!is_first(w, t->awake[k])) continue;
        if (out && n < most) out[n] = inside_owner(w, t->awake[k]);
        n++;
    }
    return n;
}
//<

//> face-touch
//>   Pushing looks at its numbers first. An impulse that would give a body a
//>   speed beyond counting is refused, because one such body can spoil a world.
int inside_rigid(tumble_world *w, tumble_body b, tumble_vec3 p, tumble_vec3 q)
{
    const body_place *x = inside_body(w, b);
    if (!x) return -1;
    int number = x->piece[0].number;
    if (body_is_soft(&w->world.body[number]))
        inside_fail(w, "body %u is a rope or a cloth, and is moved by its "
                    "vertices", b.place);
    else if (x->mesh)
        inside_fail(w, "body %u is a surface, and stays where it is", b.place);
    else if (x->pieces > 1 && !x->is_whole)
        inside_fail(w, "body %u has %d pieces, and stays where it is", b.place,
                    x->pieces);
    else if (!vec3_is_finite(from_user(p)) || !vec3_is_finite(from_user(q)))
        inside_fail(w, "body %u is given numbers that are not finite", b.place);
    else
        return number;
    return -1;
}

// The same for one that yields.
static int find_dynamic(tumble_world *w, tumble_body b, tumble_vec3 p,
                        tumble_vec3 q)
{
    int number = inside_rigid(w, b, p, q);
    if (number < 0) return -1;
    const body_place *x = inside_body(w, b);
    if (x->kind == TUMBLE_DYNAMIC) return number;
    inside_fail(w, "body %u is %s: it does not yield", b.place,
                x->kind == TUMBLE_STATIC ? "static" : "kinematic");
    return -1;
}

bool tumble_body_set_pose(tumble_world *w, tumble_body b, tumble_pose pose)
{
    int number = inside_rigid(w, b, pose.position, pose.position);
    if (number < 0) return false;
    placement p = world_where(&w->world, number);
    inside_place(&p, pose);
    if (!inside_is_ok(w, world_put(&w->world, number, p))) return false;
    body_place *x = inside_body(w, b);
    return x->lock == 0 || inside_lock(w, x, inside_locked(w, x));
}

bool tumble_body_set_velocity(tumble_world *w, tumble_body b,
                              tumble_vec3 velocity, tumble_vec3 spin)
{
    int number = inside_rigid(w, b, velocity, spin);
    if (number < 0 || !inside_is_speed(w, velocity)
        || !inside_is_speed(w, spin)) return false;
    if (body_is_static(&w->world.body[number]))
        return inside_fail(w, "body %u is static: it has no velocity", b.place);
    world_set_velocity(&w->world, number, from_user(velocity), from_user(spin));
    return true;
}

// Is what an impulse, or a force in a second, gives body `number` a velocity?
static bool is_bearable(tumble_world *w, int number, tumble_vec3 impulse)
{
    vec3 v = vec3_scale(1 / w->world.body[number].mass, from_user(impulse));
    return inside_is_speed(w, to_user(v));
}

bool tumble_body_push(tumble_world *w, tumble_body b, tumble_vec3 impulse,
                      tumble_vec3 at)
{
    int number = find_dynamic(w, b, impulse, at);
    if (number < 0 || !is_bearable(w, number, impulse)) return false;
    world_push(&w->world, number, from_user(impulse), from_user(at));
    return true;
}

bool tumble_body_force(tumble_world *w, tumble_body b, tumble_vec3 force,
                       tumble_vec3 torque)
{
    int number = find_dynamic(w, b, force, torque);
    if (number < 0 || !is_bearable(w, number, force)) return false;
    world_force(&w->world, number, from_user(force), from_user(torque));
    return true;
}
//<

//> face-force-at
//>   A force at a point is that force at the centre, and a torque.
bool tumble_body_force_at(tumble_world *w, tumble_body b, tumble_vec3 force,
                          tumble_vec3 at)
{
    int number = find_dynamic(w, b, force, at);
    if (number < 0 || !is_bearable(w, number, force)) return false;
    vec3 f = from_user(force);
    vec3 arm = vec3_sub(from_user(at), inside_frame(w, number).center);
    world_force(&w->world, number, f, vec3_cross(arm, f));
    return true;
}
//<

//> face-sleep
//>   A program may wake a body, or send it to sleep.
bool tumble_body_wake(tumble_world *w, tumble_body b)
{
    const body_place *x = inside_body(w, b);
    if (x) world_wake(&w->world, x->piece[0].number);
    return x != NULL;
}

bool tumble_body_sleep(tumble_world *w, tumble_body b)
{
    const body_place *x = inside_body(w, b);
    if (x) world_sleep(&w->world, x->piece[0].number);
    return x != NULL;
}

bool tumble_body_is_awake(const tumble_world *w, tumble_body b)
{
    const body_place *x = inside_body_of(w, b);
    return x && x->kind != TUMBLE_STATIC
        && !w->world.sleep.asleep[x->piece[0].number];
}
//<

//> face-soft
//>   The particles of ropes and cloth are named by their number in the shape.
int inside_vertex(tumble_world *w, tumble_body b, int i)
{
    const body_place *x = inside_body(w, b);
    if (!x) return -1;
    int number = x->piece[0].number;
    const body *all = &w->world.body[number];
    if (!body_is_soft(all))
        inside_fail(w, "body %u is rigid: its vertices cannot be moved", b.place);
    else if (i < 0 || i >= all->shape->particles)
        inside_fail(w, "body %u has no vertex %d", b.place, i);
    else
        return number;
    return -1;
}

bool tumble_body_pin(tumble_world *w, tumble_body b, int i)
{
    int number = inside_vertex(w, b, i);
    if (number >= 0) world_pin(&w->world, number, i);
    return number >= 0;
}

bool tumble_body_unpin(tumble_world *w, tumble_body b, int i)
{
    int number = inside_vertex(w, b, i);
    if (number >= 0) world_unpin(&w->world, number, i);
    return number >= 0;
}

bool tumble_body_push_vertex(tumble_world *w, tumble_body b, int i,
                             tumble_vec3 impulse)
{
    int number = inside_vertex(w, b, i);
    if (number < 0) return false;
    const body *all = &w->world.body[number];
    if (body_is_static(all))
        return inside_fail(w, "body %u is static: it does not yield", b.place);
    real mass = all->shape->mass[i];
    if (!inside_is_speed(w, to_user(vec3_scale(1 / mass, from_user(impulse)))))
        return false;
    world_push_particle(&w->world, number, i, from_user(impulse));
    return true;
}

tumble_vec3 tumble_body_vertex_velocity(const tumble_world *w, tumble_body b,
                                        int i)
{
    const body_place *x = inside_body_of(w, b);
    const tumble_vec3 none = { 0, 0, 0 };
    if (!x || x->mesh || i < 0) return none;
    int number = x->piece[0].number;
    const body *all = &w->world.body[number];
    if (!body_is_soft(all) || i >= all->shape->particles) return none;
    return to_user(world_particle_velocity(&w->world, number, i));
}

bool tumble_body_set_vertex_velocity(tumble_world *w, tumble_body b, int i,
                                     tumble_vec3 velocity)
{
    int number = inside_vertex(w, b, i);
    if (number < 0 || !inside_is_speed(w, velocity)) return false;
    return world_set_particle_velocity(&w->world, number, i, from_user(velocity))
        || inside_fail(w, "vertex %d of body %u is pinned, or the body static: "
                       "it stays where it is", i, b.place);
}

bool tumble_body_set_bending(tumble_world *w, tumble_body b, double stiffness)
{
    int number = inside_vertex(w, b, 0);
    return number >= 0
        && inside_is_ok(w, world_bend(&w->world, number, stiffness));
}

bool tumble_body_set_stretch(tumble_world *w, tumble_body b, double compliance)
{
    int number = inside_vertex(w, b, 0);
    return number >= 0
        && inside_is_ok(w, world_stretch(&w->world, number, compliance));
}

tumble_vec3 tumble_body_vertex(const tumble_world *w, tumble_body b, int i)
{
    const body_place *x = inside_body_of(w, b);
    const tumble_vec3 none = { 0, 0, 0 };
    if (!x || i < 0) return none;
    if (x->mesh)
        return i < x->mesh->surface.points ? to_user(x->mesh->surface.point[i])
                                           : none;
    const body *all = &w->world.body[x->piece[0].number];
    if (i >= all->shape->particles) return none;
    world_vertices(&w->world, all, w->scratch);
    return to_user(w->scratch[i]);
}
//<

//> face-material
//>   Material, damping and filter are set body by body, and asked for again in
//>   the next step.
bool tumble_body_set_material(tumble_world *w, tumble_body b, double friction,
                              double restitution)
{
    const body_place *x = inside_body(w, b);
    material m = { friction, restitution };
    for (int k = 0; x && k < x->pieces; k++)
        if (!inside_is_ok(w, world_set_material(&w->world, x->piece[k].number,
                                                m))) return false;
    return x != NULL;
}

bool tumble_body_set_damping(tumble_world *w, tumble_body b, double damping,
                             double spin_damping)
{
    const body_place *x = inside_body(w, b);
    return x && inside_is_ok(w, world_set_damping(&w->world, x->piece[0].number,
                                                  damping, spin_damping));
}

bool tumble_body_set_filter(tumble_world *w, tumble_body b, unsigned group,
                            unsigned mask)
{
    body_place *x = inside_body(w, b);
    if (x && !inside_is_group(w, group)) return false;
    if (x && x->is_sensor) {
        x->group = group;
        x->mask = mask;
        return true;
    }
    for (int k = 0; x && k < x->pieces; k++)
        world_set_filter(&w->world, x->piece[k].number, group, mask);
    return x != NULL;
}
//<
