//> motion-basis
//>   Six coordinates of a motion: three along the axes, three about them.
#include "motion.h"

#include <assert.h>

motion_basis basis_find(const rigid4 *f, const rigid_frame *frame)
{
    motion_basis b = { .inverse_mass = 1 / (FOUR * f->mass) };
    for (int t = 0; t < TURNS; t++)
        b.turn[t] = vec3_scale(f->turn[t], frame->axis[t]);
    return b;
}
//<

//> motion-of
//>   The motion of four particles is the one with their momentum and angular
//>   momentum.
// With v = w x r, w = sum_t u_t turn_t, the angular momentum L of a body is
// that for which turn_t . L = u_t: the turns are perpendicular in energy.
motion motion_of(const particle *p, const rigid_frame *frame,
                 const motion_basis *basis, real h)
{
    vec3 sum = { 0, 0, 0 }, spin = { 0, 0, 0 };
    real mass = basis->inverse_mass > 0 ? 1 / (FOUR * basis->inverse_mass) : 0;
    for (int k = 0; k < FOUR; k++) {
        vec3 way = vec3_sub(p[k].position, p[k].previous);
        sum = vec3_add(sum, way);
        spin = vec3_add(spin, vec3_cross(frame_arm(frame, k), way));
    }
    motion m = { { sum.x / (FOUR * h), sum.y / (FOUR * h),
                   sum.z / (FOUR * h) } };
    for (int t = 0; t < TURNS; t++)
        m.of[MOTION_TURN + t] = mass / h * vec3_dot(basis->turn[t], spin);
    return m;
}
//<

//> motion-make
// The turns are about axes that are perpendicular.
motion motion_make(const motion_basis *basis, vec3 velocity, vec3 spin)
{
    motion m = { { velocity.x, velocity.y, velocity.z } };
    for (int t = 0; t < TURNS; t++) {
        real square = vec3_length_squared(basis->turn[t]);
        if (square > 0)
            m.of[MOTION_TURN + t] = vec3_dot(basis->turn[t], spin) / square;
    }
    return m;
}
//<

//> motion-push
//>   An impulse at a point changes all six.
void motion_push(motion *m, const motion_basis *basis, vec3 arm, vec3 impulse)
{
    vec3 moment = vec3_cross(arm, impulse);
    m->of[0] += basis->inverse_mass * impulse.x;
    m->of[1] += basis->inverse_mass * impulse.y;
    m->of[2] += basis->inverse_mass * impulse.z;
    for (int t = 0; t < TURNS; t++)
        m->of[MOTION_TURN + t] += vec3_dot(basis->turn[t], moment);
}

real motion_energy(const motion_basis *basis, const motion *m)
{
    const real *v = m->of, *w = m->of + MOTION_TURN;
    if (!(basis->inverse_mass > 0)) return 0;
    return ((v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / basis->inverse_mass
            + (w[0] * w[0] + w[1] * w[1] + w[2] * w[2])) / 2;
}

// The vector L with turn_t . L = u_t for all three t (Cramer's rule).
vec3 motion_angular(const motion_basis *basis, const motion *m)
{
    const vec3 *t = basis->turn;
    const real *u = m->of + MOTION_TURN;
    vec3 across = vec3_cross(t[1], t[2]);
    vec3 sum = vec3_scale(u[0], across);
    sum = vec3_add_scaled(sum, u[1], vec3_cross(t[2], t[0]));
    sum = vec3_add_scaled(sum, u[2], vec3_cross(t[0], t[1]));
    real volume = vec3_dot(t[0], across);   // 0: immovable
    return vec3_scale(volume != 0 ? 1 / volume : 0, sum);
}
//<

//> motion-moves
//>   A body moves on, in parts of a frame if it turns far.
static const real FURTHEST = 1.0 / 3;       // rad, in one move

int motion_moves(const motion_basis *basis, const motion *d)
{
    real moves = vec3_length(motion_rotation(basis, d)) / FURTHEST;
    if (moves < TURN_MOVES - 1) return 1 + (int)moves;
    return moves - moves == 0 ? TURN_MOVES : 1;     // one for NaN and infinity
}

// sin(a) / a by its series, for a of no more than FURTHEST: to 1e-16.
static real chord(real a)
{
    real x = a * a;
    return 1 - x * (1.0 / 6) * (1 - x * (1.0 / 20) * (1 - x * (1.0 / 42)
           * (1 - x * (1.0 / 72) * (1 - x * (1.0 / 110)))));
}

// A particle on a circle that goes straight along its tangent by r sin(a), and
// is then drawn back to the circle along its old radius, has turned by a.
void motion_begin(particle *p, const rigid_frame *frame,
                  const motion_basis *basis, const motion *d, int moves)
{
    real share = 1.0 / moves;
    vec3 straight = { share * d->of[0], share * d->of[1], share * d->of[2] };
    vec3 turn = vec3_scale(share, motion_rotation(basis, d));
    turn = vec3_scale(chord(real_min(vec3_length(turn), 1)), turn);
    for (int k = 0; k < FOUR; k++) {
        vec3 way = vec3_add(straight, vec3_cross(turn, frame_arm(frame, k)));
        p[k].previous = p[k].position;
        p[k].position = vec3_add(p[k].position, way);
    }
}

void motion_go_on(particle *p)
{
    for (int k = 0; k < FOUR; k++) {
        vec3 here = p[k].position;
        p[k].position = vec3_add(here, vec3_sub(here, p[k].previous));
        p[k].previous = here;
    }
}
//<

//> motion-frame
//>   Cloth asks where a body is within a frame, before its particles have
//>   moved. A frame is turned without a sine.
// x, turned by the angle 2 arctan |t| about t (Cayley).
static vec3 turned(vec3 t, vec3 x)
{
    vec3 once = vec3_cross(t, x);
    return vec3_add_scaled(x, 2 / (1 + vec3_length_squared(t)),
                           vec3_add(once, vec3_cross(t, once)));
}

// The same so many times, from powers of two: the cosine and the sine of the
// whole angle.
static vec3 turned_often(vec3 t, int times, vec3 x)
{
    real square = vec3_length_squared(t), tangent = sqrt(square);
    real c = (1 - square) / (1 + square), s = 2 * tangent / (1 + square);
    real cosine = 1, sine = 0;
    vec3 axis = vec3_scale(1 / tangent, t), once = vec3_cross(axis, x);
    for (; times > 0; times /= 2) {
        real c2 = c * c - s * s, s2 = 2 * c * s, last = cosine;
        if (times % 2 == 1) {
            cosine = last * c - sine * s;
            sine = last * s + sine * c;
        }
        c = c2;
        s = s2;
    }
    x = vec3_add_scaled(x, sine, once);
    return vec3_add_scaled(x, 1 - cosine, vec3_cross(axis, once));
}

// In as many moves as motion_begin, each by so small an angle a that
// tan(a / 2) is a / 2 (1 + a^2 / 12) to a^5 / 240.
rigid_frame motion_frame(const rigid_frame *frame, const motion_basis *basis,
                         const motion *d)
{
    enum { A_FEW = 8 };     // are quicker one by one
    vec3 straight = { d->of[0], d->of[1], d->of[2] };
    int moves = motion_moves(basis, d);
    vec3 turn = vec3_scale(1.0 / moves, motion_rotation(basis, d));
    real a2 = vec3_length_squared(turn);
    vec3 half = vec3_scale((1 + a2 / 12) / 2, turn);
    rigid_frame now = *frame;
    now.center = vec3_add(frame->center, straight);
    for (int i = 0; i < FOUR_AXES; i++) {
        if (moves > A_FEW)
            now.axis[i] = turned_often(half, moves, now.axis[i]);
        for (int k = 0; k < moves && moves <= A_FEW; k++)
            now.axis[i] = turned(half, now.axis[i]);
    }
    return now;
}
//<

//> motion-frame-free
// A body that turns by t, a small part of a turn, does so about an axis that
// goes on moving.  Euler's equations change the angular velocity by
// I^-1 (I t x t) in that time, so the turn by half of it.  And I^-1 y is the sum
// of tau (tau . y).
static vec3 precessed(const vec3 tau[TURNS], vec3 angular, vec3 t)
{
    vec3 moment = vec3_cross(angular, t), sum = t;
    for (int i = 0; i < TURNS; i++)
        sum = vec3_add_scaled(sum, vec3_dot(tau[i], moment) / 2, tau[i]);
    return sum;
}

rigid_frame motion_frame_free(const rigid_frame *frame,
                              const motion_basis *basis, const motion *d)
{
    vec3 straight = { d->of[0], d->of[1], d->of[2] }, tau[TURNS];
    int moves = motion_moves(basis, d);
    if (moves > FREE_MOVES) return motion_frame(frame, basis, d);
    vec3 angular = vec3_scale(1.0 / moves, motion_angular(basis, d));
    rigid_frame now = *frame;
    now.center = vec3_add(frame->center, straight);
    for (int i = 0; i < TURNS; i++) tau[i] = basis->turn[i];
    for (int k = 0; k < moves; k++) {
        vec3 turn = { 0, 0, 0 };
        for (int i = 0; i < TURNS; i++)
            turn = vec3_add_scaled(turn, vec3_dot(tau[i], angular), tau[i]);
        turn = precessed(tau, angular, turn);
        vec3 half = vec3_scale((1 + vec3_length_squared(turn) / 12) / 2, turn);
        for (int i = 0; i < FOUR_AXES; i++) {
            now.axis[i] = turned(half, now.axis[i]);
            tau[i] = turned(half, tau[i]);
        }
    }
    return now;
}

void motion_put(particle *p, const rigid_frame *frame)
{
    for (int k = 0; k < FOUR; k++) {
        p[k].previous = p[k].position;
        p[k].position = vec3_add(frame->center, frame_arm(frame, k));
    }
}
//<

//> motion-change
// |turn|^2 is one over a moment of inertia.
real motion_change(const motion_basis *basis, const motion *m)
{
    real sum = 0, inverse[TURNS];
    for (int t = 0; t < TURNS; t++)
        inverse[t] = vec3_length_squared(basis->turn[t]);
    for (int t = 0; t < TURNS; t++) {
        real a = inverse[(t + 1) % TURNS], b = inverse[(t + 2) % TURNS];
        real unlike = real_max(a, b) > 0 ? (a - b) / real_max(a, b) : 0;
        real spin = m->of[MOTION_TURN + t] * sqrt(inverse[t]);
        sum += unlike * spin * (unlike * spin);
    }
    return sqrt(sum);
}
//<

//> motion-end
// The rotation of the motion in a basis with an angular momentum L.
static vec3 rotation_with(const motion_basis *basis, vec3 angular)
{
    motion m = { { 0 } };
    for (int t = 0; t < TURNS; t++)
        m.of[MOTION_TURN + t] = vec3_dot(basis->turn[t], angular);
    return motion_rotation(basis, &m);
}

// The angular momentum of four particles of this mass that turn: 4 m times the
// sum of y_i x (w x y_i) over the axes.
static vec3 carried(const rigid_frame *frame, real mass, vec3 turn)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < FOUR_AXES; i++)
        sum = vec3_add(sum, vec3_cross(frame->axis[i],
                                       vec3_cross(turn, frame->axis[i])));
    return vec3_scale(FOUR * mass, sum);
}

// A body that turns freely keeps its energy.  One that was hit on the way has
// an angular momentum that does not fit how it lies now: a needle that is to
// turn about its length would have a thousand times the energy.  It is braked.
static vec3 braked(const rigid_frame *now, real mass, const motion *u,
                   vec3 turn, real most)
{
    const real *w = u->of + MOTION_TURN;
    real before = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
    real after = vec3_dot(turn, carried(now, mass, turn));
    return after > most * before ? vec3_scale(sqrt(before / after), turn)
                                 : turn;
}

// The sticks hold to a tolerance only, and so do the turns of a basis.  What
// the particles lack of the angular momentum is given to them once more:
// without it a spin would drift by the tolerance in every frame.
void motion_end_within(const rigid4 *f, particle *p, const rigid_frame *frame,
                       const motion *u, real h, real most)
{
    vec3 straight = { u->of[0], u->of[1], u->of[2] };
    motion_basis basis = basis_find(f, frame);
    vec3 angular = motion_angular(&basis, u);
    rigid_frame now = rigid4_frame(p);
    motion_basis new_basis = basis_find(f, &now);
    vec3 turn = rotation_with(&new_basis, angular);
    vec3 lacking = vec3_sub(angular, carried(&now, f->mass, turn));
    turn = vec3_add(turn, rotation_with(&new_basis, lacking));
    turn = braked(&now, f->mass, u, turn, most);
    for (int k = 0; k < FOUR; k++) {
        vec3 way = vec3_add(straight, vec3_cross(turn, frame_arm(&now, k)));
        p[k].previous = vec3_add_scaled(p[k].position, -h, way);
    }
}

void motion_end(const rigid4 *f, particle *p, const rigid_frame *frame,
                const motion *u, real h)
{
    motion_end_within(f, p, frame, u, h, 1.001);
}
//<
