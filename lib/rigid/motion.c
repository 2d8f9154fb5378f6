//> motion-basis
//>   Six coordinates of a motion: three along the axes, three about them.
#include "motion.h"
#include "inline.h"

#include <math.h>
#include <string.h>

const motion_basis MOTION_IMMOVABLE = { .inverse_mass = 0 };

motion_basis basis_find(const rigid4 *f, const rigid_frame *frame)
{
    motion_basis b = { .inverse_mass = 1 / (FOUR * f->mass), .of = f };
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
        vec3 delta = vec3_sub(p[k].position, p[k].previous);
        sum = vec3_add(sum, delta);
        spin = vec3_add(spin, vec3_cross(frame_arm(frame, k), delta));
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
    motion_add_straight(m, basis->inverse_mass, impulse);
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
// So many equal moves are a turn by d.
static int moves_of(const motion_basis *basis, const motion *d)
{
    real square = vec3_length_squared(motion_rotation(basis, d));
    if (square < MOTION_FURTHEST * MOTION_FURTHEST) return 1;     // mostly
    real moves = sqrt(square) / MOTION_FURTHEST;
    if (moves < MOTION_MOVES - 1) return 1 + (int)moves;
    return moves - moves == 0 ? MOTION_MOVES : 1;     // one for NaN and infinity
}
//<

//> motion-frame
//>   Cloth, impacts and joints ask where a body would be. A frame is turned
//>   without a sine: the tangent of half an angle is a short series.
// tan(x / 2) / x, from the square of x, a small part of a turn, by its series.  At
// MOTION_FURTHEST it is good to 5e-9; of a wild turn it must stay a number.
static real half_tangent_ratio(real a)
{
    a = real_min(a, 1);
    return (1 + a * (1.0 / 12 + a * (1.0 / 120 + a * (17.0 / 20160)))) / 2;
}

static vec3 half_tangent(vec3 t)
{
    return vec3_scale(half_tangent_ratio(vec3_length_squared(t)), t);
}

// All axes are turned by the angle 2 arctan(|t| / w) about t (Cayley).
static void turn_axes(rigid_frame *f, real w, vec3 t)
{
    real twice = 2 / (w * w + vec3_length_squared(t));
    for (int i = 0; i < FOUR_AXES; i++) {
        vec3 once = vec3_cross(t, f->axis[i]);
        vec3 more = vec3_add_scaled(vec3_cross(t, once), w, once);
        f->axis[i] = vec3_add_scaled(f->axis[i], twice, more);
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
    vec3 straight = motion_straight(d);
    int moves = moves_of(basis, d);
    vec3 turn = vec3_scale(1.0 / moves, motion_rotation(basis, d));
    vec3 half = half_tangent(turn);
    rigid_frame now = *frame;
    now.center = vec3_add(frame->center, straight);
    if (moves == 1) turn_axes(&now, 1, half);
    for (int i = 0; i < FOUR_AXES && moves > 1; i++)
        now.axis[i] = turned_often(half, moves, now.axis[i]);
    return now;
}
//<

//> motion-turning
// A body that turns freely, in coordinates along its own axes: how it turned since
// it began, as a quaternion of any length, and its angular momentum.
typedef struct {
    const real *inverse;    // 1/(kg m^2), one over each moment of inertia
    real angular[TURNS];    // kg m^2/s
    real w, turned[TURNS];  // 1, the quaternion: its number and its vector
} turning;

// As a ball turns with these moments: about its angular momentum.
static void turn_ball(turning *x, real inverse, real h)
{
    const real *l = x->angular, *v = x->turned;
    vec3 t = half_tangent(vec3_scale(h * inverse, vec3_make(l[0], l[1], l[2])));
    vec3 was = { v[0], v[1], v[2] };
    vec3 now = vec3_add_scaled(vec3_add(was, vec3_cross(was, t)), x->w, t);
    x->w -= vec3_dot(was, t);
    x->turned[0] = now.x, x->turned[1] = now.y, x->turned[2] = now.z;
}

// Each move makes the quaternion longer: here it has length 1 again.
static void shorten(turning *x)
{
    real *v = x->turned;
    real one = 1 / sqrt(x->w * x->w + v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    x->w *= one;
    for (int t = 0; t < TURNS; t++) v[t] *= one;
}

static const real SAME_MOMENTS = 1e-12; // moments, to rounding

// About its own axis k, as if the moment there were one over `inverse`: its angular
// momentum stays, so its coordinates turn back.  The axes k, i, j are right-handed.
static void turn_plane(turning *x, int k, int i, int j, real inverse, real h)
{
    real *v = x->turned, *l = x->angular;
    real by = h * inverse * l[k], w = x->w, a = v[i], b = l[i];
    if (!(fabs(inverse) > SAME_MOMENTS * x->inverse[k])) return;
    real t = by * half_tangent_ratio(by * by), twice = 2 * t / (1 + t * t);
    x->w -= t * v[k];
    v[k] += t * w;
    v[i] += t * v[j];
    v[j] -= t * a;
    l[i] += twice * (l[j] - t * b);
    l[j] -= twice * (b + t * l[j]);
}
//<

//> motion-freely
// The energy is that of a ball with the first moment, and what the other two
// axes have more or less.  A ball turns steadily about its angular momentum, and
// a turn about an own axis is exact, whatever the other moments are.  The first
// changes nothing for the others, so only these two are split, symmetrically in
// time.  The ball's moment is one of the two that are nearest to each other: so a
// top, a wheel or a needle, with two moments alike, turns exactly.
static void turn_freely(turning *x, int ball, real h)
{
    int next = (ball + 1) % TURNS, odd = (ball + 2) % TURNS;
    real inverse = x->inverse[ball];
    turn_ball(x, inverse, h);
    turn_plane(x, next, odd, ball, x->inverse[next] - inverse, h / 2);
    turn_plane(x, odd, ball, next, x->inverse[odd] - inverse, h);
    turn_plane(x, next, odd, ball, x->inverse[next] - inverse, h / 2);
}
//<

//> motion-fastest
//>   In how many moves does it turn? A number that changes as the body tumbles gives
//>   energy, or takes it, with every change.
// So it is that of the fastest that the body will ever spin.  While it turns freely,
// the squares q of its angular momentum along its axes change so that their sum stays,
// and the energy.  That leaves one line, along which the square of the spin grows
// evenly, until the first q is 0.
static real fastest_spin(const turning *x)
{
    real q[TURNS], along[TURNS], square = 0, grows = 0, far = HUGE_VAL;
    for (int t = 0; t < TURNS; t++) {
        real i = x->inverse[t], s = i * i;
        q[t] = x->angular[t] * x->angular[t];
        along[t] = x->inverse[(t + 1) % TURNS] - x->inverse[(t + 2) % TURNS];
        square += s * q[t];
        grows += s * along[t];
    }
    real sign = grows < 0 ? -1 : 1;
    for (int t = 0; t < TURNS; t++)
        if (sign * along[t] < 0) far = real_min(far, -q[t] / (sign * along[t]));
    return sqrt(far < HUGE_VAL ? square + far * fabs(grows) : square);
}

// Most bodies are slow, even if all that they have were about their lightest axis.
static bool is_slow(const turning *x, real h)
{
    real light = 0, square = 0;
    for (int t = 0; t < TURNS; t++) {
        light = real_max(light, x->inverse[t]);
        square += x->angular[t] * x->angular[t];
    }
    return h * h * light * light * square < MOTION_FURTHEST * MOTION_FURTHEST;
}

static int free_moves(const turning *x, real h)
{
    if (is_slow(x, h)) return 1;
    real parts = fabs(h) * fastest_spin(x) / MOTION_FURTHEST;
    return parts < MOTION_MOVES ? 1 + (int)parts : MOTION_MOVES;
}
//<

//> motion-advance
//>   Every substep a body flies straight on, and turns. Its velocity follows from
//>   the angular momentum.
void motion_advance(rigid_frame *frame, motion_basis *basis, motion *u, real h)
{
    const rigid4 *f = basis->of;
    vec3 straight = motion_straight(u), axis = { 0, 0, 0 };
    frame->center = vec3_add_scaled(frame->center, h, straight);
    if (!f) return;
    turning x = { .w = 1, .inverse = f->inverse };
    for (int t = 0; t < TURNS; t++)
        x.angular[t] = u->of[MOTION_TURN + t] * f->root[t];
    int n = free_moves(&x, h);
    for (int k = 0; k < n; k++) {
        turn_freely(&x, f->alike, h / n);
        if (n > 1) shorten(&x);
    }
    for (int t = 0; t < TURNS; t++)
        axis = vec3_add_scaled(axis, x.turned[t] * f->per_length[t],
                               frame->axis[t]);
    turn_axes(frame, x.w, axis);
    for (int t = 0; t < TURNS; t++) {
        basis->turn[t] = vec3_scale(f->turn[t], frame->axis[t]);
        u->of[MOTION_TURN + t] = x.angular[t] / f->root[t];
    }
}
//<

//> motion-displace
//>   What is put elsewhere keeps its angular momentum, too.
void motion_displace(rigid_frame *frame, motion_basis *basis, motion *u,
                     const motion *d)
{
    vec3 angular = motion_angular(basis, u);
    *frame = motion_frame(frame, basis, d);
    for (int t = 0; t < TURNS && basis->of; t++) {
        basis->turn[t] = vec3_scale(basis->of->turn[t], frame->axis[t]);
        u->of[MOTION_TURN + t] = vec3_dot(basis->turn[t], angular);
    }
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

void motion_write(particle *p, const rigid_frame *frame,
                  const motion_basis *basis, const motion *u, real h)
{
    vec3 straight = motion_straight(u);
    vec3 turn = motion_rotation(basis, u);
    for (int k = 0; k < FOUR; k++) {
        vec3 arm = frame_arm(frame, k);
        vec3 delta = vec3_add(straight, vec3_cross(turn, arm));
        p[k].position = vec3_add(frame->center, arm);
        p[k].previous = vec3_add_scaled(p[k].position, -h, delta);
    }
}
//<
