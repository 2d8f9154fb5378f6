//> angular-of
//>   The arms are those of a step ago.
// angular.c - the angular momentum that links and bends must not change.
//
// Paper: nothing.  Book: chapter 12.

#include "angular.h"

// By this share of itself the inertia of what lies in one line is not nothing about
// that line: rounding leaves more of it.
static const real ANGULAR_NOTHING = 1e-9;

// rad: a turn by so much changes a length by an eighth of a percent, half of what
// cloth may be off.
static const real ANGULAR_MOST = 0.05;

// Which of a particle's places.
typedef enum { BEFORE, NOW } moment;

static vec3 mass_center(const particle *p, int n, moment m)
{
    vec3 sum = { 0, 0, 0 };
    real mass = 0;
    for (int i = 0; i < n; i++) {
        real of = 1 / p[i].inverse_mass;
        sum = vec3_add_scaled(sum, of, m == NOW ? p[i].position : p[i].previous);
        mass += of;
    }
    return vec3_scale(1 / mass, sum);
}

static vec3 sum_about(vec3 middle, const particle *p, int n)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < n; i++) {
        vec3 arm = vec3_sub(p[i].previous, middle);
        vec3 delta = vec3_sub(p[i].position, p[i].previous);
        sum = vec3_add_scaled(sum, 1 / p[i].inverse_mass, vec3_cross(arm, delta));
    }
    return sum;
}

angular angular_measure(const particle *p, int n)
{
    vec3 middle = mass_center(p, n, BEFORE);
    return (angular){ middle, sum_about(middle, p, n) };
}
//<

//> angular-restore
//>   Three equations for the three components of a turn.
// A turn by the vector t takes a particle at r from the centre to r + t x r.  With
// the arm b of a step ago that gives it m b x (t x r) = m ((b . r) t - r (b . t)).
// So the rows of the matrix are the sum of m (b . r) times those of 1, less m r b^T.
typedef struct {
    vec3 row[3];        // kg m^2
} turn_matrix;

static turn_matrix matrix_of(vec3 middle, vec3 center, const particle *p, int n)
{
    turn_matrix a = { { { 0, 0, 0 } } };
    real sum = 0;
    for (int i = 0; i < n; i++) {
        vec3 b = vec3_scale(1 / p[i].inverse_mass, vec3_sub(p[i].previous, middle));
        vec3 r = vec3_sub(p[i].position, center);
        sum += vec3_dot(b, r);
        a.row[0] = vec3_add_scaled(a.row[0], -r.x, b);
        a.row[1] = vec3_add_scaled(a.row[1], -r.y, b);
        a.row[2] = vec3_add_scaled(a.row[2], -r.z, b);
    }
    // What lies in one line has no inertia about it, and is not turned about it.
    sum *= 1 + ANGULAR_NOTHING;
    a.row[0].x += sum;
    a.row[1].y += sum;
    a.row[2].z += sum;
    return a;
}

// Cramer's rule.
static vec3 turn_for(turn_matrix a, vec3 asked)
{
    vec3 x = vec3_cross(a.row[1], a.row[2]), y = vec3_cross(a.row[2], a.row[0]),
         z = vec3_cross(a.row[0], a.row[1]);
    vec3 sum = vec3_add_scaled(vec3_scale(asked.x, x), asked.y, y);
    sum = vec3_add_scaled(sum, asked.z, z);
    return vec3_scale(1 / vec3_dot(a.row[0], x), sum);
}

void angular_restore(angular was, particle *p, int n)
{
    vec3 center = mass_center(p, n, NOW);
    vec3 lost = vec3_sub(was.sum, sum_about(was.middle, p, n));
    vec3 turn = turn_for(matrix_of(was.middle, center, p, n), lost);
    if (!(vec3_length_squared(turn) < ANGULAR_MOST * ANGULAR_MOST)) return;
    for (int i = 0; i < n; i++) {
        vec3 r = vec3_sub(p[i].position, center);
        p[i].position = vec3_add(p[i].position, vec3_cross(turn, r));
    }
}
//<
