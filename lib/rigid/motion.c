//> motion-basis
//>   Six coordinates of a motion: three along the axes, three about them.
#include "motion.h"

#include <math.h>
#include <string.h>

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
    m->of[0] += basis->inverse_mass * impulse.x;
    m->of[1] += basis->inverse_mass * impulse.y;
    m->of[2] += basis->inverse_mass * impulse.z;
    motion_twist(m, basis, vec3_cross(arm, impulse));
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
//>   One that turns far goes in several moves.
static const real FURTHEST = 1.0 / 3;       // tuned, rad: in one move

enum { TURN_MOVES = 1000 };                  // at most

// So many equal moves are a turn by d.
static int moves_of(const motion_basis *basis, const motion *d)
{
    real square = vec3_length_squared(motion_rotation(basis, d));
    if (square < FURTHEST * FURTHEST) return 1;     // mostly
    real moves = sqrt(square) / FURTHEST;
    if (moves < TURN_MOVES - 1) return 1 + (int)moves;
    return moves - moves == 0 ? TURN_MOVES : 1;     // one for NaN and infinity
}
//<

//> motion-frame
//>   Cloth, impacts and joints ask where a body would be. A frame is turned
//>   without a sine: the tangent of half an angle is a short series.
// t, a rotation by a small part of a turn, as Cayley's map takes it: as long as
// tan(|t| / 2), by its series.  At FURTHEST it is good to 5e-9.
static vec3 half_tangent(vec3 t)
{
    real a = vec3_length_squared(t);
    return vec3_scale((1 + a * (1.0 / 12 + a * (1.0 / 120 + a * (17.0 / 20160))))
                      / 2, t);
}

// All axes but one (-1: all) are turned by the angle 2 arctan |t| about t (Cayley).
static void turn_axes(rigid_frame *f, vec3 t, int but)
{
    real twice = 2 / (1 + vec3_length_squared(t));
    for (int i = 0; i < FOUR_AXES; i++) {
        vec3 once = vec3_cross(t, f->axis[i]);
        if (i == but) continue;
        f->axis[i] = vec3_add_scaled(f->axis[i], twice,
                                     vec3_add(once, vec3_cross(t, once)));
    }
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

rigid_frame motion_frame(const rigid_frame *frame, const motion_basis *basis,
                         const motion *d)
{
    vec3 straight = { d->of[0], d->of[1], d->of[2] };
    int moves = moves_of(basis, d);
    vec3 turn = vec3_scale(1.0 / moves, motion_rotation(basis, d));
    vec3 half = half_tangent(turn);
    rigid_frame now = *frame;
    now.center = vec3_add(frame->center, straight);
    if (moves == 1) turn_axes(&now, half, -1);
    for (int i = 0; i < FOUR_AXES && moves > 1; i++)
        now.axis[i] = turned_often(half, moves, now.axis[i]);
    return now;
}
//<

//> motion-turning
// A body that turns freely: its axes, how fast each turns it for a unit of
// angular momentum, and that angular momentum.
typedef struct {
    rigid_frame frame;
    real scale[TURNS];      // motion_basis.turn beside frame.axis
    real inverse[TURNS];    // 1/(kg m^2), one over each moment of inertia
    vec3 angular;           // kg m^2/s
} turning;

// It turns by t, a small part of a turn: all its axes but one, about which it
// turns; -1: all.
static void turn_by(turning *x, vec3 t, int but)
{
    turn_axes(&x->frame, half_tangent(t), but);
}

static const real ALIKE = 1e-12;        // moments, to rounding

// About its own axis k, as if the moment there were one over `inverse`.
static void turn_about(turning *x, int k, real inverse, real h)
{
    vec3 axis = x->frame.axis[k];
    real share = vec3_dot(axis, x->angular) / vec3_length_squared(axis);
    if (fabs(inverse) > ALIKE * x->inverse[k])
        turn_by(x, vec3_scale(h * inverse * share, axis), k);
}
//<

//> motion-moments
//>   Which two moments are nearest to each other?
// Of the three moments two are nearest to each other, `ball` and `like`.
typedef struct {
    int ball, like, odd;
} moments;

static moments compare_moments(const turning *x)
{
    moments best = { 0, 1, 2 };
    real least = HUGE_VAL;
    for (int k = 0; k < TURNS; k++) {
        int i = (k + 1) % TURNS, j = (k + 2) % TURNS;
        real apart = fabs(x->inverse[i] - x->inverse[j]);
        if (!(apart < least)) continue;
        least = apart;
        best = (moments){ i, j, k };
    }
    return best;
}
//<

//> motion-freely
// The energy is that of a ball with the first moment, and what the other two
// axes have more or less.  A ball turns steadily about its angular momentum, and
// a turn about an own axis is exact, whatever the other moments are.  The first
// changes nothing for the others, so only these two are split, symmetrically in
// time.  A top, a wheel or a needle, with two moments alike, turns exactly.
static void turn_freely(turning *x, real h)
{
    moments m = compare_moments(x);
    real ball = x->inverse[m.ball];
    turn_by(x, vec3_scale(h * ball, x->angular), -1);
    turn_about(x, m.like, x->inverse[m.like] - ball, h / 2);
    turn_about(x, m.odd, x->inverse[m.odd] - ball, h);
    turn_about(x, m.like, x->inverse[m.like] - ball, h / 2);
}
//<

//> motion-advance
//>   Every substep a body flies straight on, and turns. Its velocity follows from
//>   the angular momentum.
// The basis and the velocity of a body that stands so.
static void turn_basis(const turning *x, motion_basis *basis, motion *u)
{
    for (int t = 0; t < TURNS; t++) {
        basis->turn[t] = vec3_scale(x->scale[t], x->frame.axis[t]);
        u->of[MOTION_TURN + t] = vec3_dot(basis->turn[t], x->angular);
    }
}

static turning turning_of(const rigid_frame *frame, const motion_basis *basis,
                          const motion *u)
{
    turning x = { .frame = *frame, .angular = motion_angular(basis, u) };
    for (int t = 0; t < TURNS; t++) {
        x.scale[t] = vec3_dot(basis->turn[t], frame->axis[t])
                   / vec3_length_squared(frame->axis[t]);
        x.inverse[t] = vec3_length_squared(basis->turn[t]);
    }
    return x;
}

void motion_advance(rigid_frame *frame, motion_basis *basis, motion *u, real h)
{
    vec3 straight = { u->of[0], u->of[1], u->of[2] };
    real turn = h * vec3_length(motion_rotation(basis, u));
    real parts = turn / FURTHEST;
    int n = parts < FREE_MOVES ? 1 + (int)parts : FREE_MOVES;
    turning x = turning_of(frame, basis, u);
    x.frame.center = vec3_add_scaled(x.frame.center, h, straight);
    for (int k = 0; k < n; k++) turn_freely(&x, h / n);
    turn_basis(&x, basis, u);
    *frame = x.frame;
}
//<

//> motion-displace
//>   What is put elsewhere keeps its angular momentum, too.
void motion_displace(rigid_frame *frame, motion_basis *basis, motion *u,
                     const motion *d)
{
    turning x = turning_of(frame, basis, u);
    x.frame = motion_frame(frame, basis, d);
    turn_basis(&x, basis, u);
    *frame = x.frame;
}
//<

//> motion-put
//>   At the end of a frame the axes are made straight again, and the particles
//>   follow.
// With unit vectors e, Newton's step towards right angles and unit lengths is
// e_i - sum_j (e_i . e_j - delta_ij) e_j / 2.
void motion_straighten(const rigid4 *f, rigid_frame *frame)
{
    vec3 was[FOUR_AXES];
    memcpy(was, frame->axis, sizeof was);
    for (int i = 0; i < FOUR_AXES; i++)
        for (int j = 0; j < FOUR_AXES; j++) {
            real off = vec3_dot(was[i], was[j]) - (i == j) * f->square[i];
            frame->axis[i] = vec3_add_scaled(frame->axis[i],
                                             -off / (2 * f->square[j]), was[j]);
        }
}

void motion_put(particle *p, const rigid_frame *frame,
                const motion_basis *basis, const motion *u, real h)
{
    vec3 straight = { u->of[0], u->of[1], u->of[2] };
    vec3 turn = motion_rotation(basis, u);
    for (int k = 0; k < FOUR; k++) {
        vec3 arm = frame_arm(frame, k);
        vec3 way = vec3_add(straight, vec3_cross(turn, arm));
        p[k].position = vec3_add(frame->center, arm);
        p[k].previous = vec3_add_scaled(p[k].position, -h, way);
    }
}
//<
