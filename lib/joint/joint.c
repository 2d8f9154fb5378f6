//> joint-check
//>   A plan is checked before anything is changed, and a refusal is a sentence
//>   that names the number.
#include "joint.h"
#include "arctan.h"
#include "inline.h"

#include <stddef.h>
#include <string.h>

static status check_distance(const joint_plan *p)
{
    if (p->least >= 0 && p->most >= p->least && p->most > 0
        && p->most < HUGE_VAL) return status_ok();
    return status_fail("a distance of %g to %g m is none: it must have "
                       "0 <= least <= most, and most > 0", p->least, p->most);
}

status joint_check(const joint_plan *p)
{
    if (p->kind <= JOINT_NONE || p->kind >= JOINT_KINDS)
        return status_fail("a joint has no kind %d", (int)p->kind);
    if (!vec3_is_finite(p->point) || !vec3_is_finite(p->point_b))
        return status_fail("the point of a joint is not finite");
    if (!(p->strength >= 0))
        return status_fail("the strength of a joint is %g; it must be 0 or "
                           "more", p->strength);
    real axis = vec3_length(p->axis);
    bool has_lock = p->a < 0 && p->locked > 0 && p->locked < 1u << JOINT_ROWS;
    if (p->kind == JOINT_LOCK && !has_lock)
        return status_fail("axes 0x%x are none that can be locked", p->locked);
    bool has_axis = p->kind == JOINT_HINGE || p->kind == JOINT_SLIDER;
    if (has_axis && !(axis > 0 && axis < HUGE_VAL))
        return status_fail("the axis of a %s has no direction",
                           p->kind == JOINT_HINGE ? "hinge" : "slider");
    return p->kind == JOINT_DISTANCE ? check_distance(p) : status_ok();
}
//<

//> joint-make
//>   To make the joint, points and axes are put into the coordinates of both
//>   bodies. As it is made, no joint has an error.
const rigid_frame JOINT_WORLD = {
    { 0, 0, 0 }, { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }
};

static vec3 in_world(const rigid_frame *f, vec3 local)
{
    return vec3_sub(frame_point(f, local), f->center);
}

// Two unit vectors across n, fixed by n alone.
static void choose_across(vec3 n, vec3 *x, vec3 *y)
{
    real a = fabs(n.x), b = fabs(n.y), c = fabs(n.z);
    vec3 least = { a <= b && a <= c, b < a && b <= c, c < a && c < b };
    *x = vec3_unit(vec3_cross(n, least));
    *y = vec3_cross(n, *x);
}

static void set_axes(joint *j, const rigid_frame *a, const rigid_frame *b,
                     const vec3 axis[JOINT_AXES])
{
    for (int i = 0; i < JOINT_AXES; i++) {
        j->axis_a[i] = frame_local(a, axis[i]);
        j->axis_b[i] = frame_local(b, axis[i]);
    }
}

void joint_set_cone(joint *j, const rigid_frame *a, const rigid_frame *b,
                    vec3 along)
{
    vec3 axis[JOINT_AXES] = { vec3_unit(along) };
    choose_across(axis[0], &axis[1], &axis[2]);
    set_axes(j, a, b, axis);
}

joint joint_make(const joint_plan *p, const rigid_frame *a,
                 const rigid_frame *b)
{
    vec3 axis[JOINT_AXES] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    bool has_two = p->kind == JOINT_DISTANCE;
    joint j = { .kind = p->kind, .a = p->a, .b = p->b, .least = p->least,
                .most = p->most, .particle = p->particle,
                .locked = p->locked, .may_touch = p->may_touch };
    j.strength = p->strength > 0 ? p->strength : HUGE_VAL;
    j.has_limits = j.is_limited = has_two && p->least < p->most;
    j.drive.bound = HUGE_VAL;
    if (p->kind == JOINT_HINGE || p->kind == JOINT_SLIDER) {
        axis[0] = vec3_unit(p->axis);
        choose_across(axis[0], &axis[1], &axis[2]);
    }
    j.local_a = frame_local(a, vec3_sub(p->point, a->center));
    j.local_b = frame_local(b, vec3_sub(has_two ? p->point_b : p->point,
                                        b->center));
    set_axes(&j, a, b, axis);
    return j;
}
//<

//> joint-angle
//>   A hinge with a limit needs to know its angle.
real joint_angle(const joint *j, const rigid_frame *a, const rigid_frame *b)
{
    vec3 arrow = in_world(b, j->axis_b[1]);
    return real_angle(vec3_dot(arrow, in_world(a, j->axis_a[1])),
                      vec3_dot(arrow, in_world(a, j->axis_a[2])));
}
//<

//> joint-cone
//>   A ball joint is free to lean and to turn. *Swing* is the angle between an
//>   axis of A and the same axis of B. *Twist* is what B has turned about it, when
//>   the swing is taken back by the shortest way.
real joint_swing(const joint *j, const rigid_frame *a, const rigid_frame *b)
{
    vec3 x = in_world(a, j->axis_a[0]), y = in_world(b, j->axis_b[0]);
    return real_angle(vec3_dot(x, y), vec3_length(vec3_cross(x, y)));
}

real joint_twist(const joint *j, const rigid_frame *a, const rigid_frame *b)
{
    vec3 x = in_world(a, j->axis_a[0]), y = in_world(b, j->axis_b[0]);
    vec3 arrow = in_world(b, j->axis_b[1]), turn = vec3_cross(y, x);
    real more = 1 + vec3_dot(x, y);
    vec3 once = vec3_cross(turn, arrow), twice = vec3_cross(turn, once);
    arrow = vec3_add(arrow, once);
    if (more > 0) arrow = vec3_add_scaled(arrow, 1 / more, twice);
    return real_angle(vec3_dot(arrow, in_world(a, j->axis_a[1])),
                      vec3_dot(arrow, in_world(a, j->axis_a[2])));
}

real joint_twist_length(const joint *j, const rigid_frame *a,
                        const rigid_frame *b)
{
    vec3 x = in_world(a, j->axis_a[0]), y = in_world(b, j->axis_b[0]);
    real more = 1 + vec3_dot(x, y);
    return more > 0 ? sqrt(2 / more) : 0;
}

// What is left until the limits of swing and twist.
static void cone_errors(const joint *j, const joint_rows *r, const rigid_frame *a,
                        const rigid_frame *b, real e[JOINT_ROWS])
{
    real twist = joint_twist(j, a, b);
    e[3] = j->cone - joint_swing(j, a, b);
    e[4] = r->is_upper ? j->most - twist : twist - j->least;
}
//<

//> joint-errors
//>   Here are the errors, in a few lines each. They are the formulas of the
//>   idea, for bodies that stand anywhere.
void joint_points(const joint *j, const rigid_frame *a, const rigid_frame *b,
                  vec3 *on_a, vec3 *on_b)
{
    *on_a = frame_point(a, j->local_a);
    *on_b = frame_point(b, j->local_b);
}

real joint_where(const joint *j, const rigid_frame *a, const rigid_frame *b)
{
    vec3 on_a, on_b;
    if (j->kind == JOINT_HINGE) return joint_angle(j, a, b);
    joint_points(j, a, b, &on_a, &on_b);
    if (j->kind == JOINT_DISTANCE) return vec3_distance(on_a, on_b);
    if (j->kind != JOINT_SLIDER) return 0;
    return vec3_dot(vec3_sub(on_b, on_a), in_world(a, j->axis_a[0]));
}

vec3 joint_direction(const joint *j, const rigid_frame *a, const rigid_frame *b)
{
    vec3 on_a, on_b;
    if (j->kind != JOINT_DISTANCE) return in_world(a, j->axis_a[0]);
    joint_points(j, a, b, &on_a, &on_b);
    return vec3_unit(vec3_sub(on_b, on_a));
}

// By which small rotation A is ahead of B.  An axis x that has turned by d has
// gone to x + d x x, and x x (d x x), summed over three perpendicular axes, is
// 2 d.
static vec3 twist_between(const joint *j, const rigid_frame *a,
                          const rigid_frame *b)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < JOINT_AXES; i++)
        sum = vec3_add(sum, vec3_cross(in_world(b, j->axis_b[i]),
                                       in_world(a, j->axis_a[i])));
    return vec3_scale(0.5, sum);
}

static bool is_locked(const joint *j, int k)
{
    return j->locked >> k & 1;
}

// With all three turns locked a body keeps its axes; with two, the third; with one
// it may come to stand anywhere, and has no error, if it does not turn about that.
static vec3 locked_tilt(const joint *j, const rigid_frame *a,
                        const rigid_frame *b)
{
    int turns = 0, free = 0;
    vec3 none = { 0, 0, 0 };
    for (int k = 0; k < TURNS; k++) {
        turns += is_locked(j, 3 + k);
        if (!is_locked(j, 3 + k)) free = k;
    }
    if (turns == TURNS) return twist_between(j, a, b);
    if (turns < 2) return none;
    return vec3_cross(in_world(b, j->axis_b[free]),
                      in_world(a, j->axis_a[free]));
}

static void lock_errors(const joint *j, const rigid_frame *a,
                        const rigid_frame *b, vec3 gap, real e[JOINT_ROWS])
{
    vec3 tilt = locked_tilt(j, a, b);
    const real all[JOINT_ROWS] = { gap.x, gap.y, gap.z,
                                   tilt.x, tilt.y, tilt.z };
    int n = 0;
    for (int k = 0; k < JOINT_ROWS; k++)
        if (is_locked(j, k)) e[n++] = all[k];
    if (n == 3) e[n] = 0;
}

static void write_vec3(real e[3], vec3 v)
{
    e[0] = v.x, e[1] = v.y, e[2] = v.z;
}

// What is left until the limit, of an angle or a length; of a drive its place.
static real room(const joint *j, const joint_rows *r, real value)
{
    if (j->is_driven) return value;
    return r->is_upper ? j->most - value : value - j->least;
}

// A slider is long, so its directions are those of A as A stands.
static void slider_errors(const joint *j, const joint_rows *r,
                          const rigid_frame *a, const rigid_frame *b, vec3 gap,
                          real e[JOINT_ROWS])
{
    e[0] = vec3_dot(gap, in_world(a, j->axis_a[1]));
    e[1] = vec3_dot(gap, in_world(a, j->axis_a[2]));
    write_vec3(e + 2, twist_between(j, a, b));
    e[5] = room(j, r, -vec3_dot(gap, in_world(a, j->axis_a[0])));
}

static void hinge_errors(const joint *j, const joint_rows *r,
                         const rigid_frame *a, const rigid_frame *b,
                         real e[JOINT_ROWS])
{
    vec3 tilt = vec3_cross(in_world(b, j->axis_b[0]),
                           in_world(a, j->axis_a[0]));
    for (int k = 0; k < 2; k++) e[3 + k] = vec3_dot(tilt, r->across[k]);
    if (j->is_limited || j->is_driven)
        e[5] = room(j, r, joint_angle(j, a, b));
}

static real distance_error(const joint *j, const joint_rows *r, real length)
{
    bool is_held = !j->is_limited && !j->is_driven;
    return is_held ? length - j->most : room(j, r, length);
}

static void errors(const joint *j, const joint_rows *r, const rigid_frame *a,
                   const rigid_frame *b, vec3 gap, real e[JOINT_ROWS])
{
    write_vec3(e, gap);
    if (j->is_coned)                cone_errors(j, r, a, b, e);
    if (j->kind == JOINT_DISTANCE)  e[0] = distance_error(j, r, vec3_length(gap));
    if (j->kind == JOINT_SLIDER)    slider_errors(j, r, a, b, gap, e);
    if (j->kind == JOINT_LOCK)      lock_errors(j, a, b, gap, e);
    if (j->kind == JOINT_HINGE)     hinge_errors(j, r, a, b, e);
    if (j->kind == JOINT_FIXED)     write_vec3(e + 3, twist_between(j, a, b));
}

void joint_errors(const joint *j, const joint_rows *r, const rigid_frame *a,
                  const rigid_frame *b, real e[JOINT_ROWS])
{
    vec3 on_a, on_b;
    joint_points(j, a, b, &on_a, &on_b);
    errors(j, r, a, b, vec3_sub(on_a, on_b), e);
}
//<

//> joint-rows
static const vec3 AXIS[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };

// How fast a point at `arm` goes along d; how fast a body turns about d.
static void fill_row_along(real row[MOTIONS], const joint_side *s, vec3 arm, vec3 d,
                           real sign)
{
    vec3 moment = vec3_cross(arm, d);
    row[0] = sign * d.x;
    row[1] = sign * d.y;
    row[2] = sign * d.z;
    for (int t = 0; t < TURNS; t++)
        row[MOTION_TURN + t] = sign * vec3_dot(s->basis->turn[t], moment);
}

static void fill_row_about(real row[MOTIONS], const joint_side *s, vec3 d,
                           real sign)
{
    row[0] = row[1] = row[2] = 0;
    for (int t = 0; t < TURNS; t++)
        row[MOTION_TURN + t] = sign * vec3_dot(s->basis->turn[t], d);
}

ALWAYS_INLINE void relative_turn_row(joint_rows *r, int k, const joint_side *a,
                                     const joint_side *b, vec3 d)
{
    fill_row_about(r->a[k], a, d, 1);
    fill_row_about(r->b[k], b, d, -1);
}

// The row of a limit leads away from it, that of a drive along its way; returns
// which way that is.
static real choose_limit(joint_rows *r, const joint *j, real place)
{
    r->is_upper = j->is_limited && j->most - place < place - j->least;
    return r->is_upper ? -1 : 1;
}

// Both impulses act at one point: what one body gains of angular momentum the
// other loses.
static void relative_row(joint_rows *r, int k, const joint_side *a,
                         const joint_side *b, vec3 at, vec3 d)
{
    fill_row_along(r->a[k], a, vec3_sub(at, a->frame.center), d, 1);
    fill_row_along(r->b[k], b, vec3_sub(at, b->frame.center), d, -1);
}

// The point of a body goes along x, y and z.
static void point_rows(real (*row)[MOTIONS], const joint_side *s, vec3 at,
                       real sign)
{
    vec3 arm = vec3_scale(sign, vec3_sub(at, s->frame.center));
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++) row[k][i] = k == i ? sign : 0;
    for (int t = 0; t < TURNS; t++) {
        vec3 delta = vec3_cross(s->basis->turn[t], arm);
        row[0][MOTION_TURN + t] = delta.x;
        row[1][MOTION_TURN + t] = delta.y;
        row[2][MOTION_TURN + t] = delta.z;
    }
}

// Both impulses act at the middle between the two points.
static void find_point_rows(joint_rows *r, const joint_side *a,
                            const joint_side *b, vec3 on_a, vec3 on_b)
{
    vec3 middle = vec3_scale(0.5, vec3_add(on_a, on_b));
    point_rows(r->a, a, middle, 1);
    point_rows(r->b, b, middle, -1);
    r->held = 3;
}

static void find_hinge_rows(joint_rows *r, const joint *j, const joint_side *a,
                            const joint_side *b)
{
    for (int k = 0; k < 2; k++) {
        r->across[k] = in_world(&a->frame, j->axis_a[1 + k]);
        relative_turn_row(r, 3 + k, a, b, r->across[k]);
    }
    r->held = 5;
    if (!j->is_limited && !j->is_driven) return;
    choose_limit(r, j, joint_angle(j, &a->frame, &b->frame));
    vec3 axis = in_world(&a->frame, j->axis_a[0]);
    relative_turn_row(r, 5, a, b, vec3_scale(r->is_upper ? 1 : -1, axis));
}
//<

//> joint-rows-others
//>   The rows of a cone, of friction, of a slider, a lock and a distance.
// A turn d changes the swing by d along the axis of both, y x x, and the twist by d
// along (x + y) / (1 + x y).
static void find_cone_rows(joint_rows *r, const joint *j, const joint_side *a,
                           const joint_side *b)
{
    const rigid_frame *f = &a->frame, *g = &b->frame;
    vec3 x = in_world(f, j->axis_a[0]), y = in_world(g, j->axis_b[0]);
    vec3 lean = vec3_cross(y, x), sum = vec3_add(x, y);
    real length = vec3_length(lean), twist = joint_twist(j, f, g);
    real more = 1 + vec3_dot(x, y);
    r->is_upper = j->most - twist < twist - j->least;
    real sign = r->is_upper ? 1 : -1;
    relative_turn_row(r, 3, a, b, vec3_scale(length > 0 ? -1 / length : 0, lean));
    relative_turn_row(r, 4, a, b, vec3_scale(more > 0 ? sign / more : 0, sum));
}

// Friction acts about all axes: with a cone about those of its swing and twist, and
// a third one.  Where nothing leans, any lean will do.
static void find_friction_rows(joint_rows *r, const joint *j,
                               const joint_side *a, const joint_side *b)
{
    vec3 x = in_world(&a->frame, j->axis_a[0]);
    vec3 y = in_world(&b->frame, j->axis_b[0]);
    vec3 lean = vec3_cross(y, x), third = vec3_cross(lean, vec3_add(x, y));
    real length = vec3_length(third);
    r->twist_size = 1;
    for (int k = 0; k < 3 && !j->is_coned; k++)
        relative_turn_row(r, 3 + k, a, b, AXIS[k]);
    if (!j->is_coned) return;
    r->twist_size = joint_twist_length(j, &a->frame, &b->frame);
    if (length > 0) {
        relative_turn_row(r, 5, a, b, vec3_scale(1 / length, third));
        return;
    }
    choose_across(x, &lean, &third);
    relative_turn_row(r, 3, a, b, lean);
    relative_turn_row(r, 5, a, b, third);
}

static void find_slider_rows(joint_rows *r, const joint *j, const joint_side *a,
                             const joint_side *b, vec3 on_b)
{
    for (int k = 0; k < 2; k++)
        relative_row(r, k, a, b, on_b, in_world(&a->frame, j->axis_a[1 + k]));
    for (int k = 0; k < 3; k++) relative_turn_row(r, 2 + k, a, b, AXIS[k]);
    r->held = 5;
    r->lengths = 2;
    if (!j->is_limited && !j->is_driven) return;
    real sign = choose_limit(r, j, joint_where(j, &a->frame, &b->frame));
    vec3 axis = in_world(&a->frame, j->axis_a[0]);
    relative_row(r, 5, a, b, on_b, vec3_scale(-sign, axis));
}

// It pulls at the centre of mass, so ways and turns have nothing to do with each
// other.
static void find_lock_rows(joint_rows *r, const joint *j, const joint_side *a,
                           const joint_side *b)
{
    r->held = r->lengths = 0;
    for (int k = 0; k < 3; k++)
        if (is_locked(j, k))
            relative_row(r, r->held++, a, b, b->frame.center, AXIS[k]);
    r->lengths = r->held;
    for (int k = 0; k < 3; k++)
        if (is_locked(j, 3 + k)) relative_turn_row(r, r->held++, a, b, AXIS[k]);
    if (r->held != 3) return;
    // Three rows are taken for those of a ball joint (linkage.c).
    relative_turn_row(r, r->held++, a, b, vec3_make(0, 0, 0));
}

// A length that must not change is one row; a least and a most are a limit, the
// nearer of the two.
static void find_distance_row(joint_rows *r, const joint *j,
                              const joint_side *a, const joint_side *b,
                              vec3 on_a, vec3 on_b)
{
    vec3 gap = vec3_sub(on_a, on_b);
    real length = vec3_length(gap);
    vec3 along = length > 0 ? vec3_scale(1 / length, gap) : AXIS[1];
    r->held = !j->is_limited && !j->is_driven;
    r->lengths = 1;
    real sign = choose_limit(r, j, length);
    fill_row_along(r->a[0], a, vec3_sub(on_a, a->frame.center), along, sign);
    fill_row_along(r->b[0], b, vec3_sub(on_b, b->frame.center), along, -sign);
}
//<

//> joint-rows-all
void joint_find_rows(joint_rows *r, const joint *j, const joint_side *a,
                     const joint_side *b)
{
    vec3 on_a, on_b;
    joint_points(j, &a->frame, &b->frame, &on_a, &on_b);
    r->is_upper = false;
    r->lengths = 3;
    if (j->kind == JOINT_DISTANCE) {
        find_distance_row(r, j, a, b, on_a, on_b);
    } else if (j->kind == JOINT_SLIDER) {
        find_slider_rows(r, j, a, b, on_b);
    } else if (j->kind == JOINT_LOCK) {
        find_lock_rows(r, j, a, b);
    } else {
        find_point_rows(r, a, b, on_a, on_b);
        if (j->kind == JOINT_HINGE) find_hinge_rows(r, j, a, b);
        if (j->is_coned)            find_cone_rows(r, j, a, b);
        if (j->friction > 0)        find_friction_rows(r, j, a, b);
        for (int k = 0; k < 3 && j->kind == JOINT_FIXED; k++)
            relative_turn_row(r, r->held++, a, b, AXIS[k]);
    }
    errors(j, r, &a->frame, &b->frame, vec3_sub(on_a, on_b), r->error);
}
//<

//> joint-small
//>   Gauss and Jordan: one unknown after the other trades places with its
//>   equation. It takes one division a row. If no body can move along a row,
//>   its division would be by zero, and the row is left out. Most matrices have
//>   three rows or six, and a loop whose length is known is quicker.
ALWAYS_INLINE void invert(int n, real m[JOINT_ROWS][JOINT_ROWS])
{
    for (int k = 0; k < n; k++) {
        real row[JOINT_ROWS], one = m[k][k] > 0 ? 1 / m[k][k] : 0;
        for (int l = 0; l < n; l++) row[l] = one * m[k][l];
        row[k] = one;
        for (int i = 0; i < n; i++) {
            real times = m[i][k];
            m[i][k] = 0;
            for (int l = 0; l < n; l++) m[i][l] -= times * row[l];
        }
        for (int l = 0; l < n; l++) m[k][l] = row[l];
    }
}

void small_invert(int n, real m[JOINT_ROWS][JOINT_ROWS])
{
    if (n == 3)         invert(3, m);
    else if (n == 6)    invert(6, m);
    else                invert(n, m);
}
//<
