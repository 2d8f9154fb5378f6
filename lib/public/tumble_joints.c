//> face-join
//>   To join two bodies, both ids are looked up; the id of the ground stands
//>   for the world, which does not move. Nothing else here is more than a
//>   change of types.
#include "inside.h"
#include "join.h"

#include <stdlib.h>

// The engine's number of a rigid body, or -1 for the ground; false, with a
// failure, if it is gone, or no body that can be joined.
static bool find_side(tumble_world *w, tumble_body b, int *number)
{
    *number = -1;
    if (b.place == tumble_body_ground().place) return true;
    const body_place *x = inside_body(w, b);
    if (!x) return false;
    *number = x->piece[0].number;
    if (!body_is_soft(&w->world.body[*number])) return true;
    return inside_fail(w, "body %u is a rope or a cloth: joints hold rigid "
                       "bodies", b.place);
}

static tumble_joint joint_in(const tumble_world *w, int k)
{
    return (tumble_joint){ (unsigned)k, slots_generation(&w->joints, k) };
}

static tumble_joint enter(tumble_world *w, joint_plan plan)
{
    const tumble_joint none = { 0, 0 };
    int number;
    if (!inside_is_ok(w, world_join(&w->world, plan, &number))) return none;
    int k = slots_take(&w->joints);
    if (k < 0) {
        world_unjoin(&w->world, number);
        inside_is_ok(w, status_out_of_memory());
        return none;
    }
    *(int *)slots_at(&w->joints, k) = number;
    return joint_in(w, k);
}

static tumble_joint join_bodies(tumble_world *w, tumble_body a, tumble_body b,
                                joint_plan plan)
{
    const tumble_joint none = { 0, 0 };
    if (!find_side(w, a, &plan.a) || !find_side(w, b, &plan.b)) return none;
    if (plan.a != plan.b) return enter(w, plan);
    inside_fail(w, "a joint holds two bodies, or one and the ground");
    return none;
}

tumble_joint tumble_joint_ball(tumble_world *w, tumble_body a, tumble_body b,
                               tumble_vec3 at)
{
    return join_bodies(w, a, b, (joint_plan){ .kind = JOINT_BALL,
                                              .point = from_user(at) });
}

tumble_joint tumble_joint_hinge(tumble_world *w, tumble_body a, tumble_body b,
                                tumble_vec3 at, tumble_vec3 axis)
{
    return join_bodies(w, a, b, (joint_plan){ .kind = JOINT_HINGE,
                                              .point = from_user(at),
                                              .axis = from_user(axis) });
}

tumble_joint tumble_joint_fixed(tumble_world *w, tumble_body a, tumble_body b,
                                tumble_vec3 at)
{
    return join_bodies(w, a, b, (joint_plan){ .kind = JOINT_FIXED,
                                              .point = from_user(at) });
}

tumble_joint tumble_joint_slider(tumble_world *w, tumble_body a, tumble_body b,
                                 tumble_vec3 at, tumble_vec3 axis)
{
    return join_bodies(w, a, b, (joint_plan){ .kind = JOINT_SLIDER,
                                              .point = from_user(at),
                                              .axis = from_user(axis) });
}

tumble_joint tumble_joint_distance(tumble_world *w, tumble_body a,
                                   tumble_vec3 at_a, tumble_body b,
                                   tumble_vec3 at_b, double least, double most)
{
    return join_bodies(w, a, b, (joint_plan){ .kind = JOINT_DISTANCE,
                                              .point = from_user(at_a),
                                              .point_b = from_user(at_b),
                                              .least = least, .most = most });
}

tumble_joint tumble_joint_hang(tumble_world *w, tumble_body soft, int i,
                               tumble_body b)
{
    const tumble_joint none = { 0, 0 };
    joint_plan plan = { .kind = JOINT_PIN, .particle = i };
    plan.a = inside_vertex(w, soft, i);
    if (plan.a < 0 || !find_side(w, b, &plan.b)) return none;
    return enter(w, plan);
}
//<

//> face-joint
//>   A joint that has broken or gone is refused as a body is. When a body goes,
//>   its joints go first.
bool tumble_joint_remove(tumble_world *w, tumble_joint j)
{
    const int *x = inside_joint(w, j);
    if (!x) return false;
    world_unjoin(&w->world, *x);
    slots_give(&w->joints, (int)j.place);
    return true;
}

void inside_forget_joints(tumble_world *w)
{
    for (int k = 0; k < w->joints.count; k++) {
        const int *x = slots_at(&w->joints, k);
        if (!x) continue;
        const joint *held = &w->world.joints.joint[*x];
        if (held->is_broken) world_unjoin(&w->world, *x);
        if (held->kind == JOINT_NONE) slots_give(&w->joints, k);
    }
}

bool tumble_joint_set_limits(tumble_world *w, tumble_joint j, double least,
                             double most)
{
    const int *x = inside_joint(w, j);
    if (!x) return false;
    if (!joint_is_free(&w->world.joints.joint[*x]))
        return inside_fail(w, "joint %u is no hinge, no slider and no distance: "
                           "it has no limits", j.place);
    return inside_is_ok(w, world_limit_joint(&w->world, *x, least, most));
}

bool tumble_joint_set_cone(tumble_world *w, tumble_joint j, tumble_vec3 axis,
                           double swing, double least, double most)
{
    const int *x = inside_joint(w, j);
    if (!x) return false;
    if (w->world.joints.joint[*x].kind != JOINT_BALL)
        return inside_fail(w, "joint %u is no ball joint: it has no cone",
                           j.place);
    return inside_is_ok(w, world_cone_joint(&w->world, *x, from_user(axis),
                                            swing, least, most));
}

bool tumble_joint_set_motor(tumble_world *w, tumble_joint j, double speed,
                            double force)
{
    const int *x = inside_joint(w, j);
    return x && inside_is_ok(w, world_set_motor(&w->world, *x, speed, force));
}

bool tumble_joint_set_friction(tumble_world *w, tumble_joint j, double torque)
{
    const int *x = inside_joint(w, j);
    return x && inside_is_ok(w, world_set_friction(&w->world, *x, torque));
}

bool tumble_joint_set_spring(tumble_world *w, tumble_joint j, double rest,
                             double stiffness, double damping)
{
    const int *x = inside_joint(w, j);
    return x && inside_is_ok(w, world_set_spring(&w->world, *x, rest,
                                                 stiffness, damping, HUGE_VAL));
}

// Stiffness and damping of a spring that swings the two bodies of a joint so often
// in a second.
bool tumble_joint_set_servo(tumble_world *w, tumble_joint j, double place,
                            double hertz, double ratio, double force)
{
    const int *x = inside_joint(w, j);
    if (!x) return false;
    if (!(hertz > 0 && hertz < HUGE_VAL && ratio >= 0 && ratio < HUGE_VAL
          && force >= 0))
        return inside_fail(w, "a servo of %g Hz, ratio %g and force %g: hertz "
                           "must be above 0 and finite, the ratio 0 or more and "
                           "finite, the force 0 or more", hertz, ratio, force);
    real omega = 2 * JOINT_HALF_TURN * hertz;
    real inertia = world_joint_inertia(&w->world, *x);
    real stiffness = force > 0 ? inertia * omega * omega : 0;
    real damping = force > 0 ? 2 * ratio * inertia * omega : 0;
    return inside_is_ok(w, world_set_spring(&w->world, *x, place, stiffness,
                                            damping, force));
}

bool tumble_joint_set_touching(tumble_world *w, tumble_joint j, bool may_touch)
{
    const int *x = inside_joint(w, j);
    if (!x) return false;
    if (w->world.joints.joint[*x].kind == JOINT_PIN)
        return inside_fail(w, "joint %u hangs a rope or a cloth on a body, which "
                           "the vertices beside it would push", j.place);
    world_touch_joint(&w->world, *x, may_touch);
    return true;
}

bool tumble_joint_set_strength(tumble_world *w, tumble_joint j, double force)
{
    const int *x = inside_joint(w, j);
    if (!x) return false;
    if (!(force >= 0))
        return inside_fail(w, "a joint of strength %g N: it must be 0 or more",
                           force);
    joint *held = &w->world.joints.joint[*x];
    held->strength = force > 0 ? force : HUGE_VAL;
    if (held->a >= 0) world_wake(&w->world, held->a);
    if (held->b >= 0) world_wake(&w->world, held->b);
    return true;
}
//<

//> face-joint-look
//>   A joint can be asked for its force and its gap, and where it is along its free
//>   way, how fast, and what drives it there.
static const int *joint_entry(const tumble_world *w, tumble_joint j)
{
    return w ? slots_find(&w->joints, j.place, j.generation) : NULL;
}

bool tumble_joint_exists(const tumble_world *w, tumble_joint j)
{
    return joint_entry(w, j) != NULL;
}

int tumble_world_joints(const tumble_world *w, tumble_joint *out, int most)
{
    int n = 0;
    for (int k = 0; w && k < w->joints.count; k++) {
        if (!slots_is_taken(&w->joints, k)) continue;
        if (out && n < most) out[n] = joint_in(w, k);
        n++;
    }
    return n;
}

tumble_body tumble_joint_body(const tumble_world *w, tumble_joint j, int side)
{
    const int *x = joint_entry(w, j);
    if (!x || side < 0 || side > 1) return (tumble_body){ 0, 0 };
    const joint *held = &w->world.joints.joint[*x];
    return inside_owner(w, side == 0 ? held->a : held->b);
}

double tumble_joint_force(const tumble_world *w, tumble_joint j)
{
    const int *x = joint_entry(w, j);
    return x ? w->world.joints.joint[*x].force : 0;
}

double tumble_joint_torque(const tumble_world *w, tumble_joint j)
{
    const int *x = joint_entry(w, j);
    return x ? world_joint_torque(&w->world, *x) : 0;
}

double tumble_joint_gap(const tumble_world *w, tumble_joint j)
{
    const int *x = joint_entry(w, j);
    return x ? world_joint_gap(&w->world, *x) : 0;
}

double tumble_joint_place(const tumble_world *w, tumble_joint j)
{
    const int *x = joint_entry(w, j);
    return x ? world_joint_place(&w->world, *x) : 0;
}

double tumble_joint_speed(const tumble_world *w, tumble_joint j)
{
    const int *x = joint_entry(w, j);
    return x ? world_joint_speed(&w->world, *x) : 0;
}

double tumble_joint_swing(const tumble_world *w, tumble_joint j)
{
    const int *x = joint_entry(w, j);
    return x ? world_joint_swing(&w->world, *x) : 0;
}

double tumble_joint_twist(const tumble_world *w, tumble_joint j)
{
    const int *x = joint_entry(w, j);
    return x ? world_joint_twist(&w->world, *x) : 0;
}

double tumble_joint_drive(const tumble_world *w, tumble_joint j)
{
    const int *x = joint_entry(w, j);
    return x ? world_joint_drive(&w->world, *x) : 0;
}

bool tumble_joint_may_touch(const tumble_world *w, tumble_joint j)
{
    const int *x = joint_entry(w, j);
    return x && w->world.joints.joint[*x].may_touch;
}

double tumble_joint_angle(const tumble_world *w, tumble_joint j)
{
    return tumble_joint_place(w, j);
}
//<
