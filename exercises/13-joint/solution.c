// solution.c - a push in three directions at once, that may pull as well.

#include "shared.h"

// The axes are perpendicular, so each coordinate is found alone.
vec3 joint_local(const rigid_frame *frame, vec3 point)
{
    const vec3 *axis = frame->axis;
    vec3 r = vec3_sub(point, frame->center);
    return vec3_make(vec3_dot(r, axis[0]) / vec3_length_squared(axis[0]),
                     vec3_dot(r, axis[1]) / vec3_length_squared(axis[1]),
                     vec3_dot(r, axis[2]) / vec3_length_squared(axis[2]));
}

// One body of a joint, as it stood a step ago.
typedef struct {
    particle *p;
    rigid_frame frame;
    motion_basis basis;     // zero: it does not move
    vec3 arm;
} side;

// Adds to the columns of K what a push of 1 along x, y and z does to the point.
static side side_of(const rigid4 *f, particle *p, vec3 local, vec3 column[3])
{
    static const vec3 axis[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    particle before[FOUR];
    side s = { .p = p };
    for (int k = 0; k < FOUR; k++)
        before[k].position = p[k].previous;
    s.frame = rigid4_frame(before);
    s.arm = vec3_sub(frame_point(&s.frame, local), s.frame.center);
    if (p->inverse_mass > 0) s.basis = basis_find(f, &s.frame);
    for (int i = 0; i < 3; i++) {
        motion m = { { 0 } };
        motion_push(&m, &s.basis, s.arm, axis[i]);
        column[i] = vec3_add(column[i], motion_at(&s.basis, &m, s.arm));
    }
    return s;
}

static void push_by(const side *s, vec3 push)
{
    motion d = { { 0 } };
    motion_push(&d, &s->basis, s->arm, push);
    for (int k = 0; k < FOUR; k++)
        s->p[k].position = vec3_add(s->p[k].position,
            motion_at(&s->basis, &d, frame_arm(&s->frame, k)));
}

// The push l on A, and -l on B, changes the gap by (K_A + K_B) l, which is to
// be -gap: Cramer's rule.
real joint_close(const joint *j, const rigid4 *f, particle *p)
{
    vec3 column[3] = { { 0, 0, 0 } }, on_b = j->fixed;
    side a = side_of(f, p + j->a, j->local_a, column), b = { .p = p };
    rigid_frame now = rigid4_frame(p + j->a);
    vec3 on_a = frame_point(&now, j->local_a);
    if (j->b >= 0) {
        b = side_of(f, p + j->b, j->local_b, column);
        now = rigid4_frame(p + j->b);
        on_b = frame_point(&now, j->local_b);
    }
    vec3 gap = vec3_sub(on_b, on_a), yz = vec3_cross(column[1], column[2]);
    real volume = vec3_dot(column[0], yz);
    if (!(volume > 0)) return vec3_length(gap);
    vec3 push = { vec3_dot(gap, yz) / volume,
                  vec3_dot(gap, vec3_cross(column[2], column[0])) / volume,
                  vec3_dot(gap, vec3_cross(column[0], column[1])) / volume };
    push_by(&a, push);
    if (j->b >= 0) push_by(&b, vec3_scale(-1, push));
    return vec3_length(gap);
}
