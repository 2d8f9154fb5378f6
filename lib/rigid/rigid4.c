//> rigid4-solid
//>   The solid that a mesh encloses is summed over tetrahedra.
#include "rigid4.h"

#include <assert.h>
#include <stddef.h>
#include <stdlib.h>

// The alternate corners of a cube: sum t = 0, sum t t^T = 4 times the unit
// matrix.
enum { AXES = FOUR_AXES };
const real FOUR_SIGN[FOUR][AXES] = {
    { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 }
};

// What a solid has: volume (m^3), and the means of x and of x x^T over it.
typedef struct {
    real volume;
    vec3 center;
    real spread[3][3];      // m^2, about the centre
} solid;

static void add_outer(real m[3][3], real s, vec3 a)
{
    const real x[3] = { a.x, a.y, a.z };
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) m[i][j] += s * x[i] * x[j];
}

// The solid is cut into tetrahedra from the origin, one under each face, with
// the sign of the side that it looks to.  Over a tetrahedron (0, a, b, c) of
// volume v the mean of x is S / 4, S = a + b + c, and the mean of x x^T is
// (S S^T + a a^T + b b^T + c c^T) / 20.
static solid solid_of(const shape *s)
{
    solid q = { .volume = 0 };
    for (int f = 0; f < s->mesh.faces; f++) {
        const int *v = &s->face[3 * f];
        vec3 a = s->at[v[0]], b = s->at[v[1]], c = s->at[v[2]];
        vec3 sum = vec3_add(a, vec3_add(b, c));
        real volume = vec3_dot(a, vec3_cross(b, c)) / 6;
        q.volume += volume;
        q.center = vec3_add_scaled(q.center, volume / 4, sum);
        add_outer(q.spread, volume / 20, sum);
        add_outer(q.spread, volume / 20, a);
        add_outer(q.spread, volume / 20, b);
        add_outer(q.spread, volume / 20, c);
    }
    q.center = vec3_scale(1 / q.volume, q.center);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) q.spread[i][j] /= q.volume;
    add_outer(q.spread, -1, q.center);
    return q;
}
//<

//> rigid4-round
//>   For a ball or a capsule each integral is a formula.
// Of a round one, with a core along y: a cylinder of the length 2 half, and two
// half balls.  Over the cylinder the mean of y^2 is half^2 / 3, over a half ball
// half^2 + 2 half (3/8 r) + r^2 / 5.  Across it means are r^2 / 4 and r^2 / 5.
static solid solid_of_round(const shape *s)
{
    real r = s->round, half = s->at[s->particles - 1].y;
    real cylinder = 2 * half, balls = 4 * r / 3;    // volumes / (pi r^2)
    real whole = cylinder + balls;
    solid q = { .volume = whole * r * r };
    q.spread[0][0] = q.spread[2][2] = (cylinder * (r * r / 4)
                                       + balls * (r * r / 5)) / whole;
    q.spread[1][1] = (cylinder * (half * half / 3)
                      + balls * (half * half + 0.75 * half * r + r * r / 5))
                   / whole;
    return q;
}
//<

//> rigid4-root
//>   The root is Cholesky's; then its columns are turned.
// spread = L L^T, L lower triangular (Cholesky).  0 if the solid is flat: a
// pivot below a billionth of a billionth of the largest spread is rounding's.
static int root_of(real spread[3][3], real root[3][3])
{
    real most = fmax(spread[0][0], fmax(spread[1][1], spread[2][2]));
    for (int i = 0; i < 3; i++)
        for (int j = 0; j <= i; j++) {
            real left = spread[i][j];
            for (int k = 0; k < j; k++) left -= root[i][k] * root[j][k];
            if (i != j) {
                root[i][j] = left / root[j][j];
            } else {
                if (!(left > 1e-14 * most)) return 0;
                root[i][i] = sqrt(left);
            }
        }
    return 1;
}
//<

//> rigid4-columns
// The square of a cosine that rounding makes of a right angle.
static const real UPRIGHT = 1e-30;

// Turns the columns a and b of L in their plane until they are perpendicular;
// 0 if they are.  With a' = cos a - sin b and b' = sin a + cos b,
//     a' . b' = sin cos (a . a - b . b) + (cos^2 - sin^2) a . b,
// which is 0 where the tangent t solves t^2 + 2 z t - 1 = 0, with
// z = (b . b - a . a) / (2 a . b).  The lesser root turns by at most
// 45 degrees.
static int turn_columns(vec3 *a, vec3 *b)
{
    real aa = vec3_length_squared(*a), bb = vec3_length_squared(*b);
    real ab = vec3_dot(*a, *b);
    if (ab * ab <= UPRIGHT * aa * bb) return 0;
    real z = (bb - aa) / (2 * ab);
    real t = (z < 0 ? -1 : 1) / (fabs(z) + sqrt(1 + z * z));
    real cosine = 1 / sqrt(1 + t * t);
    vec3 kept = *a;
    *a = vec3_scale(cosine, vec3_add_scaled(*a, -t, *b));
    *b = vec3_scale(cosine, vec3_add_scaled(*b, t, kept));
    return 1;
}

// A root of the spread, L Q with Q a rotation, whose columns are perpendicular
// (Jacobi's way).  A few rounds do: near the end each squares what is left.
static void find_axes(real root[3][3], vec3 axis[AXES])
{
    enum { ROUNDS = 30 };
    for (int i = 0; i < AXES; i++)
        axis[i] = vec3_make(root[0][i], root[1][i], root[2][i]);
    for (int n = 0, turned = 1; n < ROUNDS && turned; n++) {
        turned = turn_columns(&axis[0], &axis[1]);
        turned |= turn_columns(&axis[0], &axis[2]);
        turned |= turn_columns(&axis[1], &axis[2]);
    }
}
//<

//> rigid4-build
// Does 1, 2, 3 turn right, as seen from 0?
static int turns_right(vec3 x0, vec3 x1, vec3 x2, vec3 x3)
{
    vec3 a = vec3_sub(x1, x0), b = vec3_sub(x2, x0), c = vec3_sub(x3, x0);
    return vec3_dot(a, vec3_cross(b, c)) > 0;
}

// The pairs of the three axes, each with itself and with the others.
static const int PAIR[FOUR_STICKS][2] = {
    { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 0, 2 }, { 1, 2 }
};

static void place_four(rigid4 *f, const shape *s, const solid *q,
                       const vec3 axis[AXES])
{
    real mass = 0;
    int stick_count = 0;
    for (int i = 0; i < s->particles; i++) mass += s->mass[i];
    f->mass = mass / FOUR;
    f->center = q->center;
    for (int k = 0; k < FOUR; k++) {
        vec3 r = { 0, 0, 0 };
        for (int i = 0; i < AXES; i++)
            r = vec3_add_scaled(r, FOUR_SIGN[k][i], axis[i]);
        f->at[k] = vec3_add(q->center, r);
        f->radius = fmax(f->radius, vec3_length(r));
    }
    for (int a = 0; a < FOUR; a++)
        for (int b = a + 1; b < FOUR; b++)
            f->stick[stick_count++] = (stick){ a, b,
                vec3_distance(f->at[a], f->at[b]), 1, STICK_EXACT };
    for (int i = 0; i < AXES; i++)
        f->square[i] = vec3_length_squared(axis[i]);
    for (int k = 0; k < FOUR_STICKS; k++)
        f->per_sum[k] = 1 / (f->square[PAIR[k][0]] + f->square[PAIR[k][1]]);
    f->turns_right = turns_right(f->at[0], f->at[1], f->at[2], f->at[3]);
}

// The frame's axes are perpendicular, so each coordinate is found alone.
static vec3 local_of(const vec3 axis[AXES], vec3 r)
{
    return vec3_make(vec3_dot(r, axis[0]) / vec3_length_squared(axis[0]),
                     vec3_dot(r, axis[1]) / vec3_length_squared(axis[1]),
                     vec3_dot(r, axis[2]) / vec3_length_squared(axis[2]));
}

// A turn about axis i moves particles across it by what they are off it: the
// moment of inertia is 4 mass (y_j^2 + y_k^2), j and k being the other two.  A
// turn of c y_i, an angle of c |y_i|, has an energy of (c |y_i|)^2 inertia / 2;
// this is a half for c = 1 / sqrt(y_i^2 inertia).
static void find_turns(rigid4 *f)
{
    real sum = f->square[0] + f->square[1] + f->square[2];
    for (int i = 0; i < AXES; i++) {
        real inertia = FOUR * f->mass * (sum - f->square[i]);
        f->turn[i] = 1 / sqrt(f->square[i] * inertia);
    }
}

void rigid4_free(rigid4 *f)
{
    free(f->local);
    *f = (rigid4){ .local = NULL };
}

status rigid4_build(rigid4 *f, const shape *s)
{
    assert(s->kind == SHAPE_RIGID && s->particles > 0);
    *f = (rigid4){ .local = NULL };
    solid q = s->round > 0 ? solid_of_round(s) : solid_of(s);
    real root[3][3] = { { 0 } };
    if (!(q.volume > 0) || !root_of(q.spread, root))
        return status_fail("a body of %d vertices is too thin to be solid",
                           s->particles);
    vec3 axis[AXES];
    find_axes(root, axis);
    place_four(f, s, &q, axis);
    find_turns(f);
    f->local = malloc((size_t)s->particles * sizeof *f->local);
    if (!f->local) {
        rigid4_free(f);
        return status_out_of_memory();
    }
    for (int v = 0; v < s->particles; v++) {
        vec3 r = vec3_sub(s->at[v], f->center);
        f->local[v] = local_of(axis, r);
        f->middle = vec3_add_scaled(f->middle, 1.0 / s->particles, f->local[v]);
        f->reach = fmax(f->reach, vec3_length(r) + s->round);
    }
    return status_ok();
}
//<

//> rigid4-ride
//>   What rides on a body is a weighted mean of its four particles.
void rigid4_ride(const rigid4 *f, const rigid_frame *frame, vec3 *at, int n)
{
    for (int v = 0; v < n; v++) at[v] = frame_point(frame, f->local[v]);
}

// (Sums and differences of the particles at rest are four times the axes.)
vec3 rigid4_local(const rigid4 *f, vec3 at)
{
    vec3 axis[AXES] = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } };
    for (int i = 0; i < AXES; i++)
        for (int k = 0; k < FOUR; k++)
            axis[i] = vec3_add_scaled(axis[i], FOUR_SIGN[k][i] / FOUR,
                                      f->at[k]);
    return local_of(axis, vec3_sub(at, f->center));
}

int rigid4_is_mirrored(const rigid4 *f, const particle *p)
{
    return turns_right(p[0].position, p[1].position, p[2].position,
                       p[3].position) != f->turns_right;
}
//<

//> rigid4-frame
// Four particles are a middle and a frame of three vectors,
//     x_k = middle + sum_i T_ki y_i,
// and because sum_k T_ki = 0 and sum_k T_ki T_kj is 4 or 0, sums and
// differences find both: 4 middle = sum_k x_k, 4 y_i = sum_k T_ki x_k.
typedef struct {
    vec3 middle, y[AXES];   // m, four times what it is
} frame;

static inline frame frame_of(vec3 x0, vec3 x1, vec3 x2, vec3 x3)
{
    vec3 a = vec3_add(x0, x1), b = vec3_sub(x0, x1);
    vec3 c = vec3_add(x2, x3), d = vec3_sub(x2, x3);
    return (frame){ vec3_add(a, c),
                    { vec3_sub(a, c), vec3_add(b, d), vec3_sub(b, d) } };
}

rigid_frame rigid4_frame(const particle *p)
{
    frame f = frame_of(p[0].position, p[1].position, p[2].position,
                       p[3].position);
    return (rigid_frame){ vec3_scale(0.25, f.middle),
        { vec3_scale(0.25, f.y[0]), vec3_scale(0.25, f.y[1]),
          vec3_scale(0.25, f.y[2]) } };
}
//<

//> rigid4-batch
//>   The plain form of chapter 13: particles fly, and their sticks are solved.
//>   Bodies of one shape need the same arithmetic. So four of them are laid
//>   side by side, and each step is a loop over the four in which nothing
//>   depends on a choice. A compiler turns that into vector instructions. (The
//>   world of chapter 18 puts its particles, so their sticks hold already.)
// Bodies of one plan side by side: numbers of one kind lie next to each other,
// one for each body, so that a processor takes two or more at a time.  There
// are LANES bodies, or a single one: `lanes` is a constant wherever it is
// given, so that a compiler makes a version of its own for each.
enum { LANES = 4 };
typedef real lane[LANES];

typedef struct {
    lane middle[AXES];          // m
    lane now[AXES][AXES];       // m, the frame
    lane old[AXES][AXES];       // m, four times that of a substep ago
    lane at[FOUR][AXES];        // m, where the particles end
    lane bend[FOUR_STICKS];     // E, for each of PAIR
    lane worst;     // of the sticks' relative errors, as last measured
    lane most;      // the largest that was measured
    lane steps;     // done so far
    lane volume;    // m^3, of the frame; < 0: in a mirror
} batch;

static inline void put(lane to[AXES], int l, vec3 a)
{
    to[0][l] = a.x;
    to[1][l] = a.y;
    to[2][l] = a.z;
}

static inline void batch_take(const int lanes, const particle *restrict p,
                              const ptrdiff_t *restrict first,
                              batch *restrict t)
{
    for (int l = 0; l < lanes; l++) {
        const ptrdiff_t k = first[l];
        frame a = frame_of(p[k].position, p[k + 1].position,
                           p[k + 2].position, p[k + 3].position);
        put(t->middle, l, vec3_scale(1.0 / FOUR, a.middle));
        for (int i = 0; i < AXES; i++)
            put(t->now[i], l, vec3_scale(1.0 / FOUR, a.y[i]));
        t->most[l] = t->steps[l] = 0;
    }
}

static inline void batch_take_old(const int lanes, const particle *restrict p,
                                  const ptrdiff_t *restrict first,
                                  batch *restrict t)
{
    for (int l = 0; l < lanes; l++) {
        const ptrdiff_t k = first[l];
        frame a = frame_of(p[k].previous, p[k + 1].previous,
                           p[k + 2].previous, p[k + 3].previous);
        for (int i = 0; i < AXES; i++) put(t->old[i], l, a.y[i]);
    }
}

// The same, along the sticks as they lie.
static inline void batch_keep_new(const int lanes, batch *t)
{
    for (int i = 0; i < AXES; i++)
        for (int j = 0; j < AXES; j++)
            for (int l = 0; l < lanes; l++)
                t->old[i][j][l] = FOUR * t->now[i][j][l];
}
//<

//> rigid4-bend
// G = Y^T Y - S, E_ij = G_ij / (s_i + s_j), and the worst of the sticks: the
// two of the axes i and j are off by
//     (G_ii + G_jj) / (2 (s_i + s_j)) +- E_ij.
// The larger of two is so put that a NaN in all of them comes out at the end.
static inline void batch_bend(const int lanes, const rigid4 *restrict f,
                              batch *restrict t)
{
    for (int l = 0; l < lanes; l++) {
        real g[FOUR_STICKS], e[FOUR_STICKS];
        for (int s = 0; s < FOUR_STICKS; s++) {
            const int i = PAIR[s][0], j = PAIR[s][1];
            g[s] = t->now[i][0][l] * t->now[j][0][l]
                 + t->now[i][1][l] * t->now[j][1][l]
                 + t->now[i][2][l] * t->now[j][2][l];
            if (i == j) g[s] -= f->square[i];
        }
        for (int s = 0; s < FOUR_STICKS; s++) {
            real k = g[s] * f->per_sum[s];
            real both = g[PAIR[s][0]] + g[PAIR[s][1]];
            e[s] = fabs(both) * (f->per_sum[s] / 2) + fabs(k);
            t->bend[s][l] = k;
        }
        real worst = e[3] > e[4] ? e[3] : e[4], most = t->most[l];
        worst = worst > e[5] ? worst : e[5];
        t->worst[l] = worst;
        t->most[l] = most > worst ? most : worst;
    }
}
//<

//> rigid4-step
// Y -= Y0 E, of each body that has not converged.  For the others B is nothing,
// also where their old places are no numbers.
static inline void batch_step(const int lanes, batch *restrict t,
                              real tolerance)
{
    for (int l = 0; l < lanes; l++) {
        real k[FOUR_STICKS], go = t->worst[l] > tolerance ? 1.0 : 0.0;
        for (int s = 0; s < FOUR_STICKS; s++) k[s] = t->bend[s][l] / FOUR;
        t->steps[l] += go;
        for (int i = 0; i < AXES; i++) {
            real x = t->old[0][i][l], y = t->old[1][i][l];
            real z = t->old[2][i][l];
            x = go > 0 ? x : 0;
            y = go > 0 ? y : 0;
            z = go > 0 ? z : 0;
            t->now[0][i][l] -= x * k[0] + y * k[3] + z * k[4];
            t->now[1][i][l] -= x * k[3] + y * k[1] + z * k[5];
            t->now[2][i][l] -= x * k[4] + y * k[5] + z * k[2];
        }
    }
}

// The particles of the frame, and its volume.
static inline void batch_end(const int lanes, batch *restrict t)
{
    for (int l = 0; l < lanes; l++) {
        real y[AXES][AXES];
        for (int i = 0; i < AXES; i++) {
            real c = t->middle[i][l], x = t->now[0][i][l];
            real u = t->now[1][i][l], v = t->now[2][i][l];
            t->at[0][i][l] = (c + x) + (u + v);
            t->at[1][i][l] = (c + x) - (u + v);
            t->at[2][i][l] = (c - x) + (u - v);
            t->at[3][i][l] = (c - x) - (u - v);
            y[0][i] = x, y[1][i] = u, y[2][i] = v;
        }
        t->volume[l] = y[0][0] * (y[1][1] * y[2][2] - y[1][2] * y[2][1])
                     + y[0][1] * (y[1][2] * y[2][0] - y[1][0] * y[2][2])
                     + y[0][2] * (y[1][0] * y[2][1] - y[1][1] * y[2][0]);
    }
}
//<

//> rigid4-bent
// Sticks off by more, relative to their lengths, make a body bent: Newton may
// lose its way, or find the mirror image.
static const real BENT = 0.05;              // tuned, 1

// Four sticks of a needle are as long as it is, and say little of how thick it
// is in either direction.  Its axes tell.
static bool is_straight(const rigid4 *f, const vec3 y[AXES])
{
    for (int i = 0; i < AXES; i++) {
        real s = f->square[i], off = vec3_length_squared(y[i]) - s;
        if (!(fabs(off) <= 2 * BENT * s)) return false;
        for (int j = 0; j < i; j++) {
            real cross = vec3_dot(y[i], y[j]);
            if (!(cross * cross <= BENT * BENT * s * f->square[j]))
                return false;
        }
    }
    return true;
}

// A body whose sticks are all off by no more than this is straight.  They bound
// the sums of two of the axes' errors, and so each error: |G_ii| <= 2 worst
// (s_1 + s_2 + s_3), which must be within 2 BENT s_i.
static real tolerance_of(const rigid4 *f, real asked)
{
    const real *s = f->square;
    real least = real_min(s[0], real_min(s[1], s[2]));
    return real_min(asked, BENT * least / (s[0] + s[1] + s[2]));
}

// Makes three axes perpendicular, and as long as the plan has them: the longest
// keeps its direction.  False if they have none.
static bool straighten(const rigid4 *f, vec3 y[AXES])
{
    const real *s = f->square;
    int a = s[0] >= s[1] && s[0] >= s[2] ? 0 : s[1] >= s[2] ? 1 : 2;
    int b = (a + 1) % AXES, c = (a + 2) % AXES;
    vec3 along = vec3_unit(y[a]);
    vec3 side = vec3_unit(vec3_add_scaled(y[b], -vec3_dot(y[b], along), along));
    vec3 across = vec3_cross(along, side);
    if (!(fabs(vec3_length_squared(across) - 1) < BENT)) return false;
    y[a] = vec3_scale(sqrt(s[a]), along);
    y[b] = vec3_scale(sqrt(s[b]), side);
    y[c] = vec3_scale(sqrt(s[c]), across);
    return true;
}

// The last resort: the body goes on as it lay a step ago, without turning.
static rigid4_result put_back(const rigid4 *f, particle *p)
{
    rigid4_result lost = { .worst = HUGE_VAL, .fell_back = 1 };
    rigid_frame now = rigid4_frame(p);
    frame old = frame_of(p[0].previous, p[1].previous, p[2].previous,
                         p[3].previous);
    if (!vec3_is_finite(now.center) || !straighten(f, old.y)) return lost;
    for (int i = 0; i < AXES; i++) now.axis[i] = old.y[i];
    for (int k = 0; k < FOUR; k++)
        p[k].position = vec3_add(now.center, frame_arm(&now, k));
    return (rigid4_result){ .worst = 0, .fell_back = 1 };
}
//<

//> rigid4-solve
// NaN does not count: bodies without one go on.
static inline real largest(const int lanes, const lane a)
{
    real most = 0;
    for (int l = 0; l < lanes; l++) most = a[l] > most ? a[l] : most;
    return most;
}

// Up to so many steps.  After the last one no body is measured again: a step
// squares the error of a body that was hardly bent.
static inline void batch_solve(const int lanes, const rigid4 *f,
                               const particle *p, const ptrdiff_t *first,
                               int steps, relax_options o, batch *t)
{
    batch_take(lanes, p, first, t);
    for (int k = 0; k < steps; k++) {
        batch_bend(lanes, f, t);
        if (!(largest(lanes, t->worst) > o.tolerance)) break;
        if (k == 0 && o.gradient == GRADIENT_OLD)
            batch_take_old(lanes, p, first, t);
        else if (k == 0)
            batch_keep_new(lanes, t);
        batch_step(lanes, t, o.tolerance);
    }
    batch_end(lanes, t);
}
//<

//> rigid4-relax
//>   A single body takes the same way with one lane, and gets the same bits
//>   (`bodies_relaxed_together_get_the_bits_of_each_alone`).
static void add_result(rigid4_result *all, rigid4_result r)
{
    all->tested += r.tested;
    all->relaxed += r.relaxed;
    all->fell_back += r.fell_back;
    all->iterations = int_max(r.iterations, all->iterations);
    all->worst = r.worst > all->worst ? r.worst : all->worst;
}

// The worst of body l, which was bent on the way, when all steps are done.
static real measured_again(const rigid4 *f, const batch *t, int l)
{
    batch again = *t;
    batch_bend(LANES, f, &again);
    return again.worst[l];
}

static bool is_straight_lane(const rigid4 *f, const batch *t, int l)
{
    vec3 y[AXES];
    for (int i = 0; i < AXES; i++)
        y[i] = vec3_make(t->now[i][0][l], t->now[i][1][l], t->now[i][2][l]);
    return is_straight(f, y);
}

// What became of body l, whose particles begin at p.
static void batch_give(const rigid4 *f, const batch *t, int l, particle *p,
                       int steps, relax_options o, rigid4_result *all)
{
    int done = (int)t->steps[l];
    real worst = t->worst[l];
    if (p->inverse_mass == 0) return;
    if (!(t->most[l] <= BENT)) worst = measured_again(f, t, l);
    if (!(worst <= BENT) || !(t->volume[l] > 0)
        || (worst > o.tolerance && !is_straight_lane(f, t, l))) {
        add_result(all, put_back(f, p));
        return;
    }
    for (int k = 0; k < FOUR && done > 0; k++)
        p[k].position = vec3_make(t->at[k][0][l], t->at[k][1][l],
                                  t->at[k][2][l]);
    add_result(all, (rigid4_result){ .worst = worst, .iterations = done,
        .tested = FOUR_STICKS * (done + (done < steps)),
        .relaxed = FOUR_STICKS * done });
}

rigid4_result rigid4_relax_all(const rigid4 *f, particle *p, const int *first,
                            int bodies, int steps, relax_options options)
{
    rigid4_result all = { .worst = 0 };
    assert(steps > 0);
    options.tolerance = tolerance_of(f, options.tolerance);
    for (int b = 0; b < bodies; b += LANES) {
        // Lanes that are left over repeat the last body.
        int n = bodies - b < LANES ? bodies - b : LANES;
        ptrdiff_t of[LANES];
        batch t;
        for (int l = 0; l < LANES; l++)
            of[l] = first[b + (l < n ? l : n - 1)];
        if (n == 1) batch_solve(1, f, p, of, steps, options, &t);
        else batch_solve(LANES, f, p, of, steps, options, &t);
        for (int l = 0; l < n; l++)
            batch_give(f, &t, l, p + of[l], steps, options, &all);
    }
    return all;
}

rigid4_result rigid4_relax(const rigid4 *f, particle *p, int steps,
                        relax_options options)
{
    const int first = 0;
    return rigid4_relax_all(f, p, &first, 1, steps, options);
}
//<
