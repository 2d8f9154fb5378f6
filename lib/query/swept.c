//> swept-sweep
//>   The differences are small and mostly exact, and all points of A are moved
//>   by the same vector.
#include "swept.h"

#include <assert.h>
#include <float.h>

// Everything is seen from B's first point b0: near B all numbers are small
// there, however far from the world's origin both are.  A's point i stands at
//   (a_i - a_0) + ((a_0 - b_0) + time delta).
typedef struct {
    hull given;        // A as it was given
    vec3 start, delta;      // m, a_0 - b_0; what A goes
    vec3 *a_at, *b_at;      // the scratch: A at some time, B
    hull a, b;         // the same, for gjk
    real near, aim;         // m: to come nearer than near is to touch; we aim
                            // at a little less
    hull other;             // B as it was given, and how both go, if they turn:
    const swept_motion *of_a, *of_b;    // then all is seen from the world
} sweep;

// Copies p as seen from its first point.  Returns its largest coordinate; not
// finite if one of them is not.
static real copy_about_first(hull p, vec3 *out)
{
    real extent = 0, poison = 0;
    for (int i = 0; i < p.count; i++) {
        vec3 r = vec3_sub(p.at[i], p.at[0]);
        real x = fabs(r.x), y = fabs(r.y), z = fabs(r.z);
        extent = x > extent ? x : extent;
        extent = y > extent ? y : extent;
        extent = z > extent ? z : extent;
        poison += (x - x) + (y - y) + (z - z);
        out[i] = r;
    }
    return extent + poison;
}
//<

//> swept-begin
//>   The copying also finds the size, and any number that is not finite. The
//>   size gives the tolerance its floor.
static real coordinates(vec3 v)
{
    return fabs(v.x) + fabs(v.y) + fabs(v.z);
}

// A's place is rounded by up to two units in the last place of its way.  Were
// we to aim at touch itself, we might land behind a thin plate; so we aim at
// half the tolerance, and that half is worth four such units.  0 if a number is
// not finite.
static int sweep_begin(sweep *s, hull a, vec3 delta, hull b,
                       real apart, real tolerance, vec3 *scratch)
{
    *s = (sweep){ .given = a, .a = a, .b = b };
    s->a.at = s->a_at = scratch;
    s->b.at = s->b_at = scratch + a.count;
    s->start = vec3_sub(a.at[0], b.at[0]);
    s->delta = delta;
    real size = copy_about_first(a, s->a_at) + copy_about_first(b, s->b_at);
    real reach = coordinates(s->start) + coordinates(delta) + size + apart;
    real least = 8 * DBL_EPSILON * reach;
    if (!(tolerance >= least)) tolerance = least;
    s->near = apart + tolerance;
    s->aim = apart + tolerance / 2;
    return reach < HUGE_VAL;
}

static void sweep_place(sweep *s, real time)
{
    if (s->of_a) {
        swept_place(s->given, s->of_a, time, s->a_at);
        swept_place(s->other, s->of_b, time, s->b_at);
        return;
    }
    vec3 a0 = s->given.at[0];
    vec3 at = vec3_add_scaled(s->start, time, s->delta);
    for (int i = 0; i < s->given.count; i++)
        s->a_at[i] = vec3_add(vec3_sub(s->given.at[i], a0), at);
}
//<

//> swept-direction
// The unit vector along a, which may be so short that its square is 0.
static vec3 direction(vec3 a)
{
    real x = fabs(a.x), y = fabs(a.y), z = fabs(a.z);
    real most = x > y ? x : y;
    most = z > most ? z : most;
    if (!(most > 0)) return a;
    return vec3_unit((vec3){ a.x / most, a.y / most, a.z / most });
}
//<

//> swept-closing
//>   The plane between them says how far they are to go along one direction,
//>   $`n`$. No point of a body is faster along $`n`$ than its centre by more than
//>   $`n \cdot (\varphi \times r) = r \cdot (n \times \varphi) \le |r|\,|n \times
//>   \varphi|`$ in a frame.
// m in a frame, at most, at which the hulls come nearer along n, from B to A.
static real sweep_closing(const sweep *s, vec3 n)
{
    const swept_motion *a = s->of_a, *b = s->of_b;
    if (!a) return -vec3_dot(s->delta, n);
    return vec3_dot(vec3_sub(b->delta, a->delta), n)
         + a->out * vec3_length(vec3_cross(n, a->turn))
         + b->out * vec3_length(vec3_cross(n, b->turn));
}
//<

//> swept-step
// Asks for the distance at r->time, and goes on to a later time up to which
// they surely do not touch.  1: ask again; 0: r->status is the answer.  In
// either case it is set: where no further question is allowed, to
// SWEPT_CAPPED.
//
// All of A is beyond the plane at distance d from B along n:
//   (x - y) . n >= d  for all x of A, y of B.
// After a further fraction t of the displacement, x has become x + t delta:
//   (x + t delta - y) . n >= d + t delta . n,
// which is more than aim as long as t < (d - aim) / -(delta . n); and for ever if
// delta . n >= 0.  What turns comes nearer by no more than sweep_closing says.
static int sweep_step(sweep *s, swept_result *r)
{
    sweep_place(s, r->time);
    gjk_result g = gjk_distance(s->a, s->b, HUGE_VAL, &r->last);
    int first = r->iterations++ == 0;
    r->supports += g.iterations;
    r->on_a = g.on_a;
    r->on_b = g.on_b;
    r->status = SWEPT_NOT_FINITE;
    if (g.status == GJK_NOT_FINITE) return 0;
    r->status = SWEPT_CAPPED;
    if (g.status == GJK_CAPPED) return 0;

    // Overlap, after they were apart, is rounding's: the last axis stands.
    if (g.status != GJK_OVERLAP) r->normal = direction(g.axis);
    r->status = first ? SWEPT_OVERLAP : SWEPT_TOUCHES;
    if (!(g.distance > s->near)) return 0;

    // Along n they part, or come nearer too slowly to meet on this way.
    real closing = sweep_closing(s, r->normal);
    real next = r->time + (g.distance - s->aim) / closing;
    r->status = SWEPT_PASSES;
    if (!(closing > 0 && next <= 1)) return 0;
    r->time = next;
    r->status = SWEPT_CAPPED;
    return 1;
}
//<

//> swept-first-touch
swept_result swept_first_touch(hull a, vec3 delta, hull b, real apart,
                               real tolerance, vec3 *scratch)
{
    assert(a.count >= 1 && b.count >= 1 && apart >= 0 && tolerance > 0);
    sweep s;
    swept_result r = { .status = SWEPT_NOT_FINITE };
    if (!sweep_begin(&s, a, delta, b, apart, tolerance, scratch)) return r;
    while (r.iterations < SWEPT_CAP && sweep_step(&s, &r)) continue;
    if (r.status == SWEPT_PASSES) r.time = 1;
    r.on_a = vec3_add(r.on_a, b.at[0]);
    r.on_b = vec3_add(r.on_b, b.at[0]);
    return r;
}
//<

//> swept-place
//>   A body that turns by $`\varphi`$ turns a vector $`r`$ to $`r + s\,(\varphi
//>   \times r) + c\,(\varphi \times (\varphi \times r))`$ (Rodrigues), with $`s =
//>   \sin|\varphi| / |\varphi|`$ and $`c = (1 - \cos|\varphi|) / |\varphi|^2`$. Both
//>   are series in the square of the angle, without a sine; a large angle is halved
//>   until it is small, and doubled again.
void swept_place(hull h, const swept_motion *m, real t, vec3 *out)
{
    enum { TERMS = 10 };        // good to 1e-9 at 3 rad
    vec3 turn = vec3_scale(t, m->turn);
    vec3 center = vec3_add_scaled(m->center, t, m->delta);
    real square = vec3_length_squared(turn), s = 1, c = 1;
    int halved = 0;
    for (; square > 9 && halved < 64; halved++) square /= 4;
    for (int k = 2 * TERMS; k > 0; k -= 2) {
        s = 1 - square / (k * (k + 1)) * s;
        c = 1 - square / ((k + 1) * (k + 2)) * c;
    }
    for (; halved > 0; halved--, square *= 4) {
        real cosine = 1 - square * c / 2;
        c = s * s;
        s *= cosine;
    }
    for (int i = 0; i < h.count; i++) {
        vec3 r = vec3_sub(h.at[i], m->center), once = vec3_cross(turn, r);
        r = vec3_add_scaled(r, s, once);
        r = vec3_add_scaled(r, c / 2, vec3_cross(turn, once));
        out[i] = vec3_add(center, r);
    }
}
//<

//> swept-turning
//>   The same steps, with both hulls placed by `swept_place`.
swept_result swept_turning(hull a, const swept_motion *of_a, hull b,
                           const swept_motion *of_b, real apart, real tolerance,
                           vec3 *scratch)
{
    vec3 *b_at = scratch + a.count;
    sweep s = { .given = a, .other = b, .of_a = of_a, .of_b = of_b,
                .a_at = scratch, .b_at = b_at,
                .a = { scratch, a.count }, .b = { b_at, b.count },
                .near = apart + tolerance, .aim = apart + tolerance / 2 };
    swept_result r = { .status = SWEPT_CAPPED };
    while (r.iterations < TURNING_CAP && sweep_step(&s, &r)) continue;
    return r;
}
//<

//> swept-inner
//>   How far may a body go before it can be lost behind another one? The
//>   largest ball inside it gives a bound. As long as two such balls cannot
//>   have passed each other, neither have the bodies.
// The origin lies behind every face, and so far behind the nearest; on the core
// of a body that is round.
real shape_inner(const shape *s)
{
    if (s->kind != SHAPE_RIGID) return 0;
    real inner = s->mesh.faces > 0 ? s->radius : 0;
    for (int f = 0; f < s->mesh.faces; f++) {
        const int *v = &s->face[3 * f];
        vec3 m = vec3_unit(triangle_normal(s->at[v[0]], s->at[v[1]],
                                           s->at[v[2]]));
        vec3 at = vec3_sub(s->at[v[0]], s->middle);
        inner = real_max(real_min(inner, vec3_dot(m, at)), 0);
    }
    return inner + s->round;
}
//<
