//> join
//>   Whatever changes about a joint wakes its bodies and asks again which pairs
//>   may meet; everything else is passed on.
#include "join.h"

#include <assert.h>

static rigid_frame frame_now(const world *w, int b)
{
    if (b < 0 || body_is_soft(&w->body[b])) return JOINT_WORLD;
    return rigid4_frame(w->pool.at + w->body[b].first);
}

static vec3 pinned_at(const world *w, const joint_plan *p)
{
    const body *soft = &w->body[p->a];
    assert(p->particle >= 0 && p->particle < body_particles(soft));
    return w->pool.at[soft->first + p->particle].position;
}

static bool can_move(const world *w, int b)
{
    return b >= 0 && !body_is_static(&w->body[b]);
}

static bool is_dynamic(const world *w, int b)
{
    return b >= 0 && body_is_dynamic(&w->body[b]);
}

static void wake(world *w, int b)
{
    if (!can_move(w, b)) return;
    world_wake(w, b);
    pair_list_renew(&w->rigid.pairs, b);
}

// And whether they may meet is asked again.
static void wake_both(world *w, const joint *j)
{
    wake(w, j->a);
    wake(w, j->b);
    w->is_still = false;
    w->soft.near.is_stale = true;
}

status world_join(world *w, joint_plan plan, int *number)
{
    assert(plan.a >= -1 && plan.a < w->bodies && plan.a != plan.b);
    assert(plan.b >= -1 && plan.b < w->bodies);
    bool is_pin = plan.kind == JOINT_PIN;
    assert(plan.a < 0 || body_is_soft(&w->body[plan.a]) == is_pin);
    assert(plan.b < 0 || !body_is_soft(&w->body[plan.b]));
    if (is_pin) plan.point = pinned_at(w, &plan);
    status done = joint_check(&plan);
    if (done.ok && !can_move(w, plan.a) && !can_move(w, plan.b))
        done = status_fail("neither of the two bodies of a joint can move");
    if (!done.ok) return done;
    rigid_frame a = frame_now(w, plan.a), b = frame_now(w, plan.b);
    joint j = joint_make(&plan, &a, &b);
    done = linkage_add(&w->joints, &j, number);
    if (!done.ok) return done;
    wake_both(w, &j);
    return done;
}

static joint *joint_at(const world *w, int number)
{
    assert(number >= 0 && number < w->joints.count);
    assert(w->joints.joint[number].kind != JOINT_NONE);
    return &w->joints.joint[number];
}

void world_unjoin(world *w, int number)
{
    wake_both(w, joint_at(w, number));
    linkage_remove(&w->joints, number);
}

void world_touch_joint(world *w, int number, bool may_touch)
{
    joint *j = joint_at(w, number);
    j->may_touch = may_touch;
    wake_both(w, j);
}

status world_limit_joint(world *w, int number, real least, real most)
{
    const real turn = JOINT_HALF_TURN;
    joint *j = joint_at(w, number);
    bool is_hinge = j->kind == JOINT_HINGE, is_slider = j->kind == JOINT_SLIDER;
    assert(is_hinge || is_slider || j->kind == JOINT_DISTANCE);
    real highest = is_hinge ? turn : 1e300;
    real lowest = is_hinge || is_slider ? -highest : 0;
    if (!(least <= most && least <= highest && most >= lowest))
        return status_fail("%g to %g are no limits of a joint", least, most);
    bool has_limits = is_hinge || is_slider ? least > lowest || most < highest
                                            : least < most;
    actuator_set_limits(j, real_max(least, lowest), real_min(most, highest),
                        has_limits);
    wake_both(w, j);
    return status_ok();
}

status world_cone_joint(world *w, int number, vec3 axis, real swing, real least,
                        real most)
{
    const real turn = JOINT_HALF_TURN;
    joint *j = joint_at(w, number);
    real length = vec3_length(axis);
    assert(j->kind == JOINT_BALL);
    if (!(length > 0 && length < HUGE_VAL))
        return status_fail("the axis of a cone has no direction");
    if (!(swing >= 0 && least <= most && least <= turn && most >= -turn))
        return status_fail("a swing of %g and a twist of %g to %g rad are no cone",
                           swing, least, most);
    rigid_frame a = frame_now(w, j->a), b = frame_now(w, j->b);
    joint_set_cone(j, &a, &b, axis);
    j->cone = real_min(swing, 2 * turn);
    j->least = real_max(least, -2 * turn);
    j->most = real_min(most, 2 * turn);
    j->is_coned = swing < turn || least > -turn || most < turn;
    j->extra = joint_ball_rows(j);
    j->cone_holds[0] = j->cone_holds[1] = false;
    for (int k = 3; k < JOINT_ROWS; k++) j->impulse[k] = 0;
    wake_both(w, j);
    return status_ok();
}

real world_joint_swing(const world *w, int number)
{
    const joint *j = joint_at(w, number);
    rigid_frame a = frame_now(w, j->a), b = frame_now(w, j->b);
    return j->is_coned ? joint_swing(j, &a, &b) : 0;
}

real world_joint_twist(const world *w, int number)
{
    const joint *j = joint_at(w, number);
    rigid_frame a = frame_now(w, j->a), b = frame_now(w, j->b);
    return j->is_coned ? joint_twist(j, &a, &b) : 0;
}

real world_joint_inertia(const world *w, int number)
{
    joint j = *joint_at(w, number);
    joint_rows r = { .count = 0 };
    if (!joint_is_free(&j)) return 0;
    motion_basis basis[2] = { { .inverse_mass = 0 }, { .inverse_mass = 0 } };
    joint_side side[2];
    const int of[2] = { j.a, j.b };
    for (int k = 0; k < 2; k++) {
        int b = of[k];
        side[k] = (joint_side){ &basis[k], frame_now(w, b) };
        if (is_dynamic(w, b))
            basis[k] = basis_find(w->body[b].rigid, &side[k].frame);
    }
    j.is_driven = true;
    joint_find_rows(&r, &j, &side[0], &side[1]);
    real inverse = actuator_inverse(&r, basis[0].inverse_mass,
                                    basis[1].inverse_mass);
    return inverse > 0 ? 1 / inverse : 0;
}

static void begin_drive(world *w, int number)
{
    joint *j = joint_at(w, number);
    real inertia = world_joint_inertia(w, number);
    j->drive.inverse = inertia > 0 ? 1 / inertia : 0;
    wake_both(w, j);
}

status world_set_motor(world *w, int number, real speed, real force)
{
    joint *j = joint_at(w, number);
    status done = actuator_set_motor(j, speed, force);
    if (done.ok) begin_drive(w, number);
    return done;
}

status world_set_friction(world *w, int number, real torque)
{
    joint *j = joint_at(w, number);
    status done = actuator_set_friction(j, torque);
    if (done.ok) wake_both(w, j);
    return done;
}

status world_set_spring(world *w, int number, real rest, real stiffness,
                        real damping, real bound)
{
    joint *j = joint_at(w, number);
    status done = actuator_set_spring(j, rest, stiffness, damping, bound);
    if (done.ok) begin_drive(w, number);
    return done;
}

real world_joint_gap(const world *w, int number)
{
    const joint *j = joint_at(w, number);
    rigid_frame a = frame_now(w, j->a), b = frame_now(w, j->b);
    vec3 on_a, on_b;
    joint_points(j, &a, &b, &on_a, &on_b);
    if (j->kind == JOINT_PIN)
        on_a = w->pool.at[w->body[j->a].first + j->particle].position;
    if (j->kind == JOINT_SLIDER)
        on_a = vec3_add_scaled(on_a, joint_where(j, &a, &b),
                               joint_direction(j, &a, &b));
    return vec3_distance(on_a, on_b);
}

// The velocity of a point of body b, and its spin.
static vec3 velocity_at(const world *w, int b, vec3 at, vec3 *spin)
{
    *spin = (vec3){ 0, 0, 0 };
    if (!can_move(w, b)) return *spin;
    rigid_frame now = frame_now(w, b);
    motion_basis basis = basis_find(w->body[b].rigid, &now);
    motion u = motion_of(w->pool.at + w->body[b].first, &now, &basis,
                         body_age(w, b));
    *spin = motion_rotation(&basis, &u);
    return motion_at(&basis, &u, vec3_sub(at, now.center));
}

// A body that is driven from outside goes as it is told.
real world_joint_speed(const world *w, int number)
{
    const joint *j = joint_at(w, number);
    if (!joint_is_free(j)) return 0;
    rigid_frame a = frame_now(w, j->a), b = frame_now(w, j->b);
    vec3 on_a, on_b, spin_a, spin_b, delta = joint_direction(j, &a, &b);
    joint_points(j, &a, &b, &on_a, &on_b);
    if (j->kind == JOINT_SLIDER) on_a = on_b;
    vec3 u = velocity_at(w, j->a, on_a, &spin_a);
    vec3 v = velocity_at(w, j->b, on_b, &spin_b);
    if (j->kind == JOINT_HINGE) return vec3_dot(delta, vec3_sub(spin_b, spin_a));
    return vec3_dot(delta, vec3_sub(v, u));
}

real world_joint_drive(const world *w, int number)
{
    return joint_at(w, number)->given;
}

// The last rows are turns about directions that are perpendicular: of a slider the
// three before its way, of others those behind the three of the point.
real world_joint_torque(const world *w, int number)
{
    const joint *j = joint_at(w, number);
    bool has_turns = j->kind != JOINT_DISTANCE && j->kind != JOINT_PIN;
    int yields = is_dynamic(w, j->b) ? j->b : j->a;
    int first = j->kind == JOINT_SLIDER ? 2 : 3;
    vec3 p = { j->impulse[first], j->impulse[first + 1], j->impulse[first + 2] };
    if (!has_turns || !is_dynamic(w, yields)) return 0;
    real seconds = body_age(w, yields);
    if (j->is_coned) {
        rigid_frame a = frame_now(w, j->a), b = frame_now(w, j->b);
        p.y *= joint_twist_length(j, &a, &b);
    }
    // A drive's force acts for another time than the substep's.
    if (j->kind == JOINT_HINGE && j->is_driven) p.z = j->given * seconds;
    return vec3_length(p) / seconds;
}

real world_joint_place(const world *w, int number)
{
    const joint *j = joint_at(w, number);
    if (j->kind == JOINT_PIN) return 0;
    rigid_frame a = frame_now(w, j->a), b = frame_now(w, j->b);
    return joint_where(j, &a, &b);
}

//<

//> join-inside
//>   In the step, joined bodies are taken from the pairs, and they sleep and
//>   wake as one island.
linkage_pass join_pass(world *w, const solver_frame *f)
{
    rigid_tables *t = &w->rigid;
    return (linkage_pass){ f, t->velocity, t->moved, t->rung, t->on_rung };
}

void join_begin(world *w, const solver_frame *f)
{
    linkage_pass q = join_pass(w, f);
    linkage_prepare(&w->joints, &q);
}

void join_unite(world *w)
{
    solver_frame f = { .body = w->rigid.now };
    linkage_pass q = join_pass(w, &f);
    linkage_unite(&w->joints, &q);
}

// What hangs on something that moves wakes as what lies on it does.
void join_wake(world *w)
{
    for (int k = 0; k < w->joints.count && w->sleep.sleepers > 0; k++) {
        const joint *j = &w->joints.joint[k];
        if (joint_holds(j) && j->a >= 0 && j->b >= 0)
            world_wake_near(w, j->a, j->b);
    }
}

// What a joint has let go may meet again.
static void renew_pairs(world *w, const joint *j)
{
    if (j->a >= 0) pair_list_renew(&w->rigid.pairs, j->a);
    if (j->b >= 0) pair_list_renew(&w->rigid.pairs, j->b);
}

// What is slower than a fall from rest is in a substep, its joints hold.
static void hold_slow(world *w, int b)
{
    if (b < 0 || !w->rigid.moves[b]) return;
    real fall = w->rigid.age[b] * vec3_length(body_gravity(w, b));
    vec3 v = motion_straight(&w->rigid.velocity[b]);
    w->rigid.held[b] |= vec3_length_squared(v) < fall * fall;
}

// A motor that turns as it should is at work, however slow it is.
static bool is_running(const joint *j)
{
    const joint_drive *d = &j->drive;
    return j->is_driven && d->force > 0 && d->speed != 0 && d->motor == 0
        && d->limit == 0;
}

static void keep_awake(world *w, const joint *j)
{
    if (is_dynamic(w, j->a)) sleep_forget(&w->sleep, j->a);
    if (is_dynamic(w, j->b)) sleep_forget(&w->sleep, j->b);
}

// What is joined sleeps and wakes together.
void join_islands_of_joints(world *w)
{
    linkage *l = &w->joints;
    w->report.broken = l->broken;
    for (int k = 0; k < l->count; k++) {
        const joint *j = &l->joint[k];
        if (j->is_broken && l->broken > 0) renew_pairs(w, j);
        if (!joint_holds(j)) continue;
        hold_slow(w, j->a);
        hold_slow(w, j->b);
        if (is_dynamic(w, j->a) && is_dynamic(w, j->b))
            sleep_touch(&w->sleep, j->a, j->b);
        if (is_running(j)) keep_awake(w, j);
    }
    if (l->broken > 0) {
        linkage_count_pins(l);
        w->soft.near.is_stale = true;
    }
    l->broken = 0;
}
//<
