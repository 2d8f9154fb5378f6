//> rigid4-solid
//>   The solid that a mesh encloses is summed over tetrahedra.
#include "rigid4.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

// The alternate corners of a cube: sum t = 0, sum t t^T = 4 times the unit
// matrix.
enum { AXES = FOUR_AXES };
const real FOUR_SIGN[FOUR][AXES] = {
    { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 }
};

void rigid4_add_outer(real m[3][3], real s, vec3 a)
{
    const real x[3] = { a.x, a.y, a.z };
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) m[i][j] += s * x[i] * x[j];
}

// The solid is cut into tetrahedra from the origin, one under each face, with
// the sign of the side that it looks to.  Over a tetrahedron (0, a, b, c) of
// volume v the mean of x is S / 4, S = a + b + c, and the mean of x x^T is
// (S S^T + a a^T + b b^T + c c^T) / 20.
static rigid_solid solid_of(const shape *s)
{
    rigid_solid q = { .volume = 0 };
    for (int f = 0; f < s->mesh.faces; f++) {
        const int *v = &s->face[3 * f];
        vec3 a = s->at[v[0]], b = s->at[v[1]], c = s->at[v[2]];
        vec3 sum = vec3_add(a, vec3_add(b, c));
        real volume = vec3_dot(a, vec3_cross(b, c)) / 6;
        q.volume += volume;
        q.center = vec3_add_scaled(q.center, volume / 4, sum);
        rigid4_add_outer(q.spread, volume / 20, sum);
        rigid4_add_outer(q.spread, volume / 20, a);
        rigid4_add_outer(q.spread, volume / 20, b);
        rigid4_add_outer(q.spread, volume / 20, c);
    }
    q.center = vec3_scale(1 / q.volume, q.center);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) q.spread[i][j] /= q.volume;
    rigid4_add_outer(q.spread, -1, q.center);
    return q;
}
//<

//> rigid4-round
//>   For a ball or a capsule each integral is a formula.
// Of a round one, with a core along y: a cylinder of the length 2 half, and two
// half balls.  Over the cylinder the mean of y^2 is half^2 / 3, over a half ball
// half^2 + 2 half (3/8 r) + r^2 / 5.  Across it means are r^2 / 4 and r^2 / 5.
static rigid_solid solid_of_round(const shape *s)
{
    real r = s->round, half = s->at[s->particles - 1].y;
    real cylinder = 2 * half, balls = 4 * r / 3;    // volumes / (pi r^2)
    real whole = cylinder + balls;
    rigid_solid q = { .volume = whole * r * r };
    q.spread[0][0] = q.spread[2][2] = (cylinder * (r * r / 4)
                                       + balls * (r * r / 5)) / whole;
    q.spread[1][1] = (cylinder * (half * half / 3)
                      + balls * (half * half + 0.75 * half * r + r * r / 5))
                   / whole;
    return q;
}
//<

//> rigid4-cylinder
// Of a cylinder about y: the mean of y^2 is a third of half its length squared, and
// across it means are r^2 / 4.
static rigid_solid solid_of_cylinder(const shape *s)
{
    real r = s->rim, half = s->at[1].y;
    rigid_solid q = { .volume = 2 * half * r * r };
    q.spread[0][0] = q.spread[2][2] = r * r / 4;
    q.spread[1][1] = half * half / 3;
    return q;
}
//<

//> rigid4-own
//>   What has a weight of its own is taken at its word.
rigid_solid rigid4_solid(const shape *s)
{
    if (!(s->own.mass > 0))
        return s->round > 0 ? solid_of_round(s)
             : s->rim > 0 ? solid_of_cylinder(s) : solid_of(s);
    rigid_solid q = { .volume = 1, .center = s->own.center };
    memcpy(q.spread, s->own.spread, sizeof q.spread);
    return q;
}

real rigid4_mass(const shape *s)
{
    real mass = 0;
    if (s->own.mass > 0) return s->own.mass;
    for (int i = 0; i < s->particles; i++) mass += s->mass[i];
    return mass;
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
//>   The four particles stand at the corners that the columns say.
static void place_four(rigid4 *f, const shape *s, const rigid_solid *q,
                       const vec3 axis[AXES])
{
    int stick_count = 0;
    f->mass = rigid4_mass(s) / FOUR;
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
}

// 1/(kg m^2)
static real apart_from_next(const rigid4 *f, int i)
{
    return fabs(f->inverse[i] - f->inverse[(i + 1) % AXES]);
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
        f->root[i] = sqrt(inertia);
        f->inverse[i] = 1 / inertia;
        f->per_length[i] = 1 / sqrt(f->square[i]);
        f->turn[i] = f->per_length[i] / f->root[i];
    }
    for (int i = 0; i < AXES; i++)
        if (apart_from_next(f, i) < apart_from_next(f, f->alike)) f->alike = i;
}

// (What has a weight of its own may have its centre beside the axis.)
static int round_axes(const shape *s)
{
    if (s->own.mass > 0) return 0;
    if (s->rim > 0) return 1;
    return s->round > 0 && s->particles <= 2 ? 5 - 2 * s->particles : 0;
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
    rigid_solid q = rigid4_solid(s);
    real root[3][3] = { { 0 } };
    if (!(q.volume > 0) || !root_of(q.spread, root))
        return status_fail("a body of %d vertices is too thin to be solid",
                           s->particles);
    rigid_frame rest = { .center = q.center };
    find_axes(root, rest.axis);
    place_four(f, s, &q, rest.axis);
    find_turns(f);
    f->round_axes = round_axes(s);
    f->local = malloc((size_t)s->particles * sizeof *f->local);
    if (!f->local) {
        rigid4_free(f);
        return status_out_of_memory();
    }
    for (int v = 0; v < s->particles; v++) {
        vec3 r = vec3_sub(s->at[v], f->center);
        f->local[v] = frame_local(&rest, r);
        f->middle = vec3_add_scaled(f->middle, 1.0 / s->particles, f->local[v]);
        f->span = vec3_make(real_max(f->span.x, fabs(f->local[v].x)),
                            real_max(f->span.y, fabs(f->local[v].y)),
                            real_max(f->span.z, fabs(f->local[v].z)));
        f->reach = fmax(f->reach, vec3_length(r) + s->round);
    }
    f->reach = fmax(f->reach, s->own.reach);
    return status_ok();
}
//<

//> rigid4-ride
//>   What rides on a body is a weighted mean of its four particles.
void rigid4_ride(const rigid4 *f, const rigid_frame *frame, vec3 *at, int n)
{
    for (int v = 0; v < n; v++) at[v] = frame_point(frame, f->local[v]);
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

rigid_frame rigid4_rest(const rigid4 *f)
{
    particle p[FOUR];
    for (int k = 0; k < FOUR; k++) p[k] = (particle){ .position = f->at[k] };
    return rigid4_frame(p);
}
//<
