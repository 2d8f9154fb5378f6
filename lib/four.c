//> four-solid
#include "four.h"

#include <assert.h>
#include <stdlib.h>

// The alternate corners of a cube: sum t = 0, sum t t^T = 4 times the unit
// matrix.
static const real T[FOUR][3] = {
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

//> four-root
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

// y with L y = x.
static vec3 undo_root(real root[3][3], vec3 x)
{
    vec3 y;
    y.x = x.x / root[0][0];
    y.y = (x.y - root[1][0] * y.x) / root[1][1];
    y.z = (x.z - root[2][0] * y.x - root[2][1] * y.y) / root[2][2];
    return y;
}
//<

//> four-matrix
// Entry (s, u) of J J^T: the row of stick (a, b) holds -o at a and o at b,
// o = x_b - x_a, so that two sticks meet in o . o' where they share a particle,
// with a minus sign where one begins and the other ends there.
static real row_product(const stick *s, const stick *u, const vec3 *at)
{
    vec3 o = vec3_sub(at[s->b], at[s->a]), q = vec3_sub(at[u->b], at[u->a]);
    int shared = (s->a == u->a) + (s->b == u->b)
               - (s->a == u->b) - (s->b == u->a);
    return shared * vec3_dot(o, q);
}

// Gauss and Jordan: matrix and identity side by side, the largest pivot of each
// column.  There is one: J J^T is positive definite where the four do not lie
// in a plane, and root_of has refused what rounding could take for flat.
static void invert(real m[FOUR_STICKS][2 * FOUR_STICKS])
{
    for (int c = 0; c < FOUR_STICKS; c++) {
        int best = c;
        for (int r = c + 1; r < FOUR_STICKS; r++)
            if (fabs(m[r][c]) > fabs(m[best][c])) best = r;
        for (int k = 0; k < 2 * FOUR_STICKS; k++) {
            real kept = m[c][k];
            m[c][k] = m[best][k];
            m[best][k] = kept;
        }
        real pivot = m[c][c];
        for (int k = 0; k < 2 * FOUR_STICKS; k++) m[c][k] /= pivot;
        for (int r = 0; r < FOUR_STICKS; r++) {
            real share = m[r][c];
            if (r == c || share == 0) continue;
            for (int k = 0; k < 2 * FOUR_STICKS; k++)
                m[r][k] -= share * m[c][k];
        }
    }
}

static void invert_sticks(four *f)
{
    real m[FOUR_STICKS][2 * FOUR_STICKS] = { { 0 } };
    for (int s = 0; s < FOUR_STICKS; s++) {
        for (int u = 0; u < FOUR_STICKS; u++)
            m[s][u] = row_product(&f->stick[s], &f->stick[u], f->at);
        m[s][FOUR_STICKS + s] = 1;
    }
    invert(m);
    for (int s = 0; s < FOUR_STICKS; s++)
        for (int u = 0; u < FOUR_STICKS; u++)
            f->inverse[s][u] = m[s][FOUR_STICKS + u];
}
//<

//> four-build
// Does 1, 2, 3 turn right, as seen from 0?
static int turns_right(vec3 x0, vec3 x1, vec3 x2, vec3 x3)
{
    vec3 a = vec3_sub(x1, x0), b = vec3_sub(x2, x0), c = vec3_sub(x3, x0);
    return vec3_dot(a, vec3_cross(b, c)) > 0;
}

static void place_four(four *f, const shape *s, const solid *q,
                       real root[3][3])
{
    real mass = 0;
    int stick_count = 0;
    for (int i = 0; i < s->particles; i++) mass += s->mass[i];
    f->mass = mass / FOUR;
    f->center = q->center;
    for (int k = 0; k < FOUR; k++) {
        vec3 r = { root[0][0] * T[k][0],
                   root[1][0] * T[k][0] + root[1][1] * T[k][1],
                   root[2][0] * T[k][0] + root[2][1] * T[k][1]
                   + root[2][2] * T[k][2] };
        f->at[k] = vec3_add(q->center, r);
        f->radius = fmax(f->radius, vec3_length(r));
    }
    for (int a = 0; a < FOUR; a++)
        for (int b = a + 1; b < FOUR; b++)
            f->stick[stick_count++] = (stick){ a, b,
                vec3_distance(f->at[a], f->at[b]), 1, STICK_EXACT };
    for (int k = 0; k < FOUR_STICKS; k++) {
        f->square[k] = f->stick[k].rest_length * f->stick[k].rest_length;
        f->per_square[k] = 1 / f->square[k];
    }
    f->turns_right = turns_right(f->at[0], f->at[1], f->at[2], f->at[3]);
}

// p = sum a_k x_k with sum a_k = 1: with x_k = c + L t_k and y = L^-1 (p - c),
// a_k = (1 + t_k . y) / 4, because sum a_k t_k = (sum t_k t_k^T / 4) y = y.
static void weigh(vec3 y, real weight[FOUR])
{
    for (int k = 0; k < FOUR; k++)
        weight[k] = (1 + T[k][0] * y.x + T[k][1] * y.y + T[k][2] * y.z) / FOUR;
}

void four_free(four *f)
{
    free(f->weight);
    *f = (four){ .weight = NULL };
}

status four_build(four *f, const shape *s)
{
    assert(s->kind == SHAPE_RIGID && s->particles > 0);
    *f = (four){ .weight = NULL };
    solid q = solid_of(s);
    real root[3][3] = { { 0 } };
    if (!(q.volume > 0) || !root_of(q.spread, root))
        return status_fail("a body of %d vertices is too thin to be solid",
                           s->particles);
    place_four(f, s, &q, root);
    invert_sticks(f);
    f->weight = malloc((size_t)s->particles * sizeof *f->weight);
    if (!f->weight) {
        four_free(f);
        return status_out_of_memory();
    }
    for (int v = 0; v < s->particles; v++) {
        vec3 r = vec3_sub(s->at[v], f->center);
        real *a = f->weight[v], sum = 0;
        weigh(undo_root(root, r), a);
        f->reach = fmax(f->reach, vec3_length(r));
        for (int k = 0; k < FOUR; k++) {
            f->middle[k] += a[k] / s->particles;
            sum += fabs(a[k]);
        }
        f->swing = fmax(f->swing, sum);
    }
    return status_ok();
}
//<

//> four-ride
void four_ride(const four *f, const particle *p, vec3 *at, int n)
{
    for (int v = 0; v < n; v++) {
        const real *a = f->weight[v];
        vec3 x = vec3_scale(a[0], p[0].position);
        for (int k = 1; k < FOUR; k++)
            x = vec3_add_scaled(x, a[k], p[k].position);
        at[v] = x;
    }
}

int four_is_mirrored(const four *f, const particle *p)
{
    return turns_right(p[0].position, p[1].position, p[2].position,
                       p[3].position) != f->turns_right;
}
//<

//> four-solve
// mu = (J J^T)^-1 c.
static void solve_sticks(const four *f, const real c[FOUR_STICKS],
                         real mu[FOUR_STICKS])
{
    for (int s = 0; s < FOUR_STICKS; s++) {
        real sum = 0;
        for (int u = 0; u < FOUR_STICKS; u++) sum += f->inverse[s][u] * c[u];
        mu[s] = sum;
    }
}

// The ends of each stick: every pair.
static const int END[FOUR_STICKS][2] = {
    { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 }
};

// How far each stick is off, as (d^2 - L^2) / 2; returns the worst, relative to
// its length: (d^2 - L^2) / (2 L^2).  HUGE_VAL for NaN.
static real stick_errors(const four *f, const particle *p,
                         real c[FOUR_STICKS])
{
    real worst = 0;
    for (int s = 0; s < FOUR_STICKS; s++) {
        vec3 d = vec3_sub(p[END[s][1]].position, p[END[s][0]].position);
        c[s] = (vec3_length_squared(d) - f->square[s]) / 2;
        real error = fabs(c[s]) * f->per_square[s];
        if (!(error <= worst)) worst = error >= 0 ? error : HUGE_VAL;
    }
    return worst;
}
//<

//> four-relax
// One Newton step: x_k -= sum_s J_sk mu_s, J at o.  All four have one mass, so
// it falls out.
static void newton_step(const four *f, particle *p, const vec3 o[FOUR],
                        const real c[FOUR_STICKS])
{
    real mu[FOUR_STICKS];
    solve_sticks(f, c, mu);
    for (int s = 0; s < FOUR_STICKS; s++) {
        int a = END[s][0], b = END[s][1];
        vec3 move = vec3_scale(mu[s], vec3_sub(o[b], o[a]));
        p[a].position = vec3_add(p[a].position, move);
        p[b].position = vec3_sub(p[b].position, move);
    }
}

// Sticks off by more, relative to their lengths, make a body bent: Newton may
// lose its way, or find the mirror image.
static const real BENT = 0.05;

// The last resort: stick by stick along the sticks as they lie; and where that
// ends in the mirror, or nowhere, the body goes on as it lay a step ago,
// without turning.
static relax_result relax_bent(const four *f, particle *p,
                               relax_options options)
{
    enum { SWEEPS = 60 };
    vec3 mean = { 0, 0, 0 };
    for (int k = 0; k < FOUR; k++)
        mean = vec3_add_scaled(mean, 1.0 / FOUR,
                               vec3_sub(p[k].position, p[k].previous));
    options.gradient = GRADIENT_NEW;
    relax_result r = sticks_relax(f->stick, FOUR_STICKS, p, FOUR, SWEEPS,
                                  options, NULL);
    r.fell_back = 1;
    if (r.worst <= 0.01 && !four_is_mirrored(f, p)) return r;
    for (int k = 0; k < FOUR && vec3_is_finite(mean); k++)
        p[k].position = vec3_add(p[k].previous, mean);
    return r;
}

relax_result four_relax(const four *f, particle *p, int steps,
                        relax_options options)
{
    relax_result r = { .sweeps = 0 };
    real c[FOUR_STICKS], first = 0;
    vec3 o[FOUR], kept[FOUR];
    if (p[0].inverse_mass == 0) return r;
    r.worst = first = stick_errors(f, p, c);
    r.tested += FOUR_STICKS;
    for (int k = 0; k < FOUR && !(first <= options.tolerance); k++) {
        kept[k] = p[k].position;
        o[k] = options.gradient == GRADIENT_OLD ? p[k].previous : kept[k];
    }
    while (r.sweeps < steps) {
        if (r.sweeps > 0) {
            r.worst = stick_errors(f, p, c);
            r.tested += FOUR_STICKS;
        }
        if (r.worst <= options.tolerance || !(r.worst < HUGE_VAL)) break;
        newton_step(f, p, o, c);
        r.relaxed += FOUR_STICKS;
        r.sweeps++;
    }
    // A body that was hardly bent is straight now: one step squares the error.
    if (first > BENT || !(r.worst <= BENT)) r.worst = stick_errors(f, p, c);
    if (r.worst <= fmax(BENT, options.tolerance) && !four_is_mirrored(f, p))
        return r;
    for (int k = 0; k < FOUR && r.sweeps > 0; k++) p[k].position = kept[k];
    return relax_bent(f, p, options);
}
//<

//> four-batch
// Bodies of one plan side by side: numbers of one kind lie next to each other,
// one for each body, so that a processor takes two or more at a time.
enum { LANES = 4 };
typedef real lane[LANES];

// How far a body is: to be solved on, solved, or left to four_relax.
enum { GOING, DONE, LEFT };

typedef struct {
    lane at[FOUR][3], old[FOUR][3];         // m
    lane c[FOUR_STICKS];                    // m^2, see stick_errors
    lane worst;                             // of the sticks' relative errors
    lane volume;                            // m^3, sixfold; < 0: in a mirror
    int  state[LANES];
} batch;

static void batch_take(const particle *restrict p, const int *restrict first,
                       batch *restrict t)
{
    for (int l = 0; l < LANES; l++) {
        const particle *of = p + first[l];
        t->state[l] = of->inverse_mass > 0 ? GOING : LEFT;
        for (int k = 0; k < FOUR; k++) {
            t->at[k][0][l] = of[k].position.x;
            t->at[k][1][l] = of[k].position.y;
            t->at[k][2][l] = of[k].position.z;
        }
    }
}

static void batch_take_old(const particle *restrict p,
                           const int *restrict first, batch *restrict t)
{
    for (int l = 0; l < LANES; l++)
        for (int k = 0; k < FOUR; k++) {
            vec3 old = p[first[l] + k].previous;
            t->old[k][0][l] = old.x;
            t->old[k][1][l] = old.y;
            t->old[k][2][l] = old.z;
        }
}

static void batch_give(const batch *t, int l, particle *p)
{
    for (int k = 0; k < FOUR; k++)
        p[k].position = vec3_make(t->at[k][0][l], t->at[k][1][l],
                                  t->at[k][2][l]);
}
//<

//> four-batch-errors
// stick_errors of each body.  Inner loops of known length are unrolled: the
// loop over the bodies is the innermost that is left, and has no branch.  A NaN
// may slip through `worst`; but a body with a NaN has no volume.
static void batch_errors(const four *restrict f, batch *restrict t)
{
    for (int l = 0; l < LANES; l++) {
        real worst = 0;
        for (int s = 0; s < FOUR_STICKS; s++) {
            const int a = END[s][0], b = END[s][1];
            real x = t->at[b][0][l] - t->at[a][0][l];
            real y = t->at[b][1][l] - t->at[a][1][l];
            real z = t->at[b][2][l] - t->at[a][2][l];
            real c = (x * x + y * y + z * z - f->square[s]) / 2;
            real error = fabs(c) * f->per_square[s];
            t->c[s][l] = c;
            worst = error > worst ? error : worst;
        }
        t->worst[l] = worst;
    }
}

// turns_right asks for its sign, which is that of T.
static void batch_volumes(batch *t)
{
    for (int l = 0; l < LANES; l++) {
        real r[FOUR][3];
        for (int k = 1; k < FOUR; k++)
            for (int i = 0; i < 3; i++)
                r[k][i] = t->at[k][i][l] - t->at[0][i][l];
        t->volume[l] = r[1][0] * (r[2][1] * r[3][2] - r[2][2] * r[3][1])
                     + r[1][1] * (r[2][2] * r[3][0] - r[2][0] * r[3][2])
                     + r[1][2] * (r[2][0] * r[3][1] - r[2][1] * r[3][0]);
    }
}
//<

//> four-batch-step
// newton_step of each body.
static void batch_step(const four *restrict f, batch *restrict t)
{
    for (int l = 0; l < LANES; l++) {
        real mu[FOUR_STICKS];
        for (int s = 0; s < FOUR_STICKS; s++) {
            mu[s] = 0;
            for (int u = 0; u < FOUR_STICKS; u++)
                mu[s] += f->inverse[s][u] * t->c[u][l];
        }
        for (int i = 0; i < 3; i++) {
            real x[FOUR], o[FOUR];
            for (int k = 0; k < FOUR; k++) {
                x[k] = t->at[k][i][l];
                o[k] = t->old[k][i][l];
            }
            for (int s = 0; s < FOUR_STICKS; s++) {
                real move = mu[s] * (o[END[s][1]] - o[END[s][0]]);
                x[END[s][0]] += move;
                x[END[s][1]] -= move;
            }
            for (int k = 0; k < FOUR; k++) t->at[k][i][l] = x[k];
        }
    }
}
//<

//> four-batch-relax
// After k steps: gives back whoever is content, or has had all steps.  Bent or
// mirrored bodies, and what is no number, are left as they came.  Returns
// whether anybody goes on.
static int batch_sort(batch *t, particle *p, const int *first, int k,
                      int steps, real tolerance, relax_result *all)
{
    int going = 0, has_volumes = 0;
    for (int l = 0; l < LANES; l++) {
        if (t->state[l] != GOING) continue;
        if (t->worst[l] <= BENT && t->worst[l] > tolerance && k < steps) {
            going = 1;
            continue;
        }
        if (!has_volumes) batch_volumes(t);
        has_volumes = 1;
        t->state[l] = LEFT;
        if (!(t->worst[l] <= BENT) || !(t->volume[l] < 0)) continue;
        t->state[l] = DONE;
        if (k > 0) batch_give(t, l, p + first[l]);
        all->tested += FOUR_STICKS * (k < steps ? k + 1 : k);
        all->relaxed += FOUR_STICKS * k;
        all->sweeps = k > all->sweeps ? k : all->sweeps;
        all->worst = fmax(all->worst, t->worst[l]);
    }
    return going;
}

static void add_result(relax_result *all, relax_result r)
{
    all->tested += r.tested;
    all->relaxed += r.relaxed;
    all->fell_back += r.fell_back;
    all->sweeps = r.sweeps > all->sweeps ? r.sweeps : all->sweeps;
    all->worst = fmax(all->worst, r.worst);
}

static void batch_relax(const four *f, particle *p, const int *first,
                        int steps, relax_options o, relax_result *all)
{
    batch t;
    batch_take(p, first, &t);
    for (int k = 0; k <= steps; k++) {
        if (k > 0) batch_step(f, &t);
        if (k < steps) batch_errors(f, &t);
        if (!batch_sort(&t, p, first, k, steps, o.tolerance, all)) break;
        if (k == 0) batch_take_old(p, first, &t);
    }
    for (int l = 0; l < LANES; l++)
        if (t.state[l] == LEFT)
            add_result(all, four_relax(f, p + first[l], steps, o));
}

relax_result four_relax_all(const four *f, particle *p, const int *first,
                            int bodies, int steps, relax_options options)
{
    relax_result all = { .worst = 0 };
    int b = 0, is_old = options.gradient == GRADIENT_OLD;
    assert(steps > 0);
    for (; is_old && b + LANES <= bodies; b += LANES)
        batch_relax(f, p, first + b, steps, options, &all);
    for (; b < bodies; b++)
        add_result(&all, four_relax(f, p + first[b], steps, options));
    return all;
}
//<

//> four-ways
// The particles as they lie about their middle, turned about an axis: e x r.
// No stick o changes its length by that: o . (e x o) = 0.
static void turn_about(vec3 e, const vec3 r[FOUR], vec3 turn[FOUR])
{
    for (int k = 0; k < FOUR; k++) turn[k] = vec3_cross(e, r[k]);
}

static real dot_of_moves(const vec3 a[FOUR], const vec3 b[FOUR])
{
    real sum = 0;
    for (int k = 0; k < FOUR; k++) sum += vec3_dot(a[k], b[k]);
    return sum;
}

static void take_from(vec3 move[FOUR], real s, const vec3 other[FOUR])
{
    for (int k = 0; k < FOUR; k++)
        move[k] = vec3_add_scaled(move[k], -s, other[k]);
}

// Turns about x, y and z, each freed of what the ones before it have of it
// (Gram and Schmidt).  They are perpendicular to the three straight ways as
// they are, for the r add up to nothing.  With one mass 1 / w for all four, a
// way of unit length times sqrt(w) is as long as it must be.
void four_find_ways(const vec3 at[FOUR], real inverse_mass, four_ways *w)
{
    static const vec3 axis[TURNS] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    vec3 r[FOUR], middle = { 0, 0, 0 };
    real root = sqrt(inverse_mass);
    w->along = root / 2;
    for (int k = 0; k < FOUR; k++)
        middle = vec3_add_scaled(middle, 1.0 / FOUR, at[k]);
    for (int k = 0; k < FOUR; k++) r[k] = vec3_sub(at[k], middle);
    for (int t = 0; t < TURNS; t++) {
        turn_about(axis[t], r, w->turn[t]);
        for (int u = 0; u < t; u++)
            take_from(w->turn[t], dot_of_moves(w->turn[t], w->turn[u]),
                      w->turn[u]);
        real length = sqrt(dot_of_moves(w->turn[t], w->turn[t]));
        real scale = length > 0 ? 1 / length : 0;
        for (int k = 0; k < FOUR; k++)
            w->turn[t][k] = vec3_scale(scale, w->turn[t][k]);
    }
    for (int t = 0; t < TURNS; t++)
        for (int k = 0; k < FOUR; k++)
            w->turn[t][k] = vec3_scale(root, w->turn[t][k]);
}
//<

//> four-rows
void four_rows(const four_ways *w, const real share[FOUR], const vec3 d[3],
               real row[3][FOUR_WAYS])
{
    for (int i = 0; i < 3; i++) {
        row[i][0] = w->along * d[i].x;
        row[i][1] = w->along * d[i].y;
        row[i][2] = w->along * d[i].z;
    }
    for (int t = 0; t < TURNS; t++) {
        vec3 move = vec3_scale(share[0], w->turn[t][0]);
        for (int k = 1; k < FOUR; k++)
            move = vec3_add_scaled(move, share[k], w->turn[t][k]);
        for (int i = 0; i < 3; i++) row[i][3 + t] = vec3_dot(move, d[i]);
    }
}

//<

//> four-go
// Even ways and odd ones are summed side by side: a processor adds and
// multiplies two numbers at a time, if the compiler sees that they are two of a
// kind, and that no result lies where a number is still to be read (restrict).
void four_part(const real (*restrict row_a)[FOUR_WAYS],
               const real (*restrict row_b)[FOUR_WAYS],
               const real *restrict was, const real *restrict a,
               const real *restrict b, real *restrict apart)
{
    real sum[3][2];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++) {
            const real *q = row_a[i] + k, *r = row_b[i] + k;
            sum[i][k] = q[0] * a[k] + q[2] * a[k + 2] + q[4] * a[k + 4]
                     + (r[0] * b[k] + r[2] * b[k + 2] + r[4] * b[k + 4]);
        }
    for (int i = 0; i < 3; i++) apart[i] = was[i] + (sum[i][0] + sum[i][1]);
}

void four_go(const real (*restrict row)[FOUR_WAYS], const real *restrict l,
             real *restrict way)
{
    for (int k = 0; k < FOUR_WAYS; k++)
        way[k] += l[0] * row[0][k] + l[1] * row[1][k] + l[2] * row[2][k];
}
//<

//> four-move
void four_move(const four_ways *w, const real along[FOUR_WAYS], vec3 move[FOUR])
{
    vec3 all = vec3_scale(w->along,
                          vec3_make(along[0], along[1], along[2]));
    for (int k = 0; k < FOUR; k++) {
        move[k] = all;
        for (int t = 0; t < TURNS; t++)
            move[k] = vec3_add_scaled(move[k], along[3 + t], w->turn[t][k]);
    }
}
//<
