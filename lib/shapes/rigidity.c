//> rigidity-row
#include "rigidity.h"

#include <limits.h>
#include <stdint.h>
#include <stdlib.h>

// The row of a stick from a to b along the unit vector u: velocities v keep its
// length if u . v_b - u . v_a = 0, so it holds u at b, -u at a, and zeros.
static void write_row(real *row, const shape *s, stick t)
{
    vec3 u = vec3_unit(vec3_sub(s->at[t.b], s->at[t.a]));
    for (int i = 0; i < 3 * s->particles; i++) row[i] = 0;
    row[3 * t.a] = -u.x; row[3 * t.a + 1] = -u.y; row[3 * t.a + 2] = -u.z;
    row[3 * t.b] =  u.x; row[3 * t.b + 1] =  u.y; row[3 * t.b + 2] =  u.z;
}

static real row_dot(const real *a, const real *b, int n)
{
    real sum = 0;
    for (int i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}
//<

//> rigidity-reduce
// Takes from a row what the `kept` rows, of length 1 and perpendicular to each
// other, have in common with it (Gram and Schmidt).
static void reduce(real *row, const real *rows, int kept, int n)
{
    for (int k = 0; k < kept; k++) {
        const real *other = rows + (size_t)k * (size_t)n;
        real common = row_dot(row, other, n);
        for (int i = 0; i < n; i++) row[i] -= common * other[i];
    }
}
//<

//> rigidity-rank
// What is left of a row that depends on others is rounding, some 1e-16 of its
// length, which is sqrt(2).
static const real DEPENDENT = 1e-9;

// At most 3 n - 6 rows are kept, so there is room for the one in hand.
int shape_rank(const shape *s)
{
    if (s->sticks == 0) return 0;
    if (s->particles > INT_MAX / 3) return -1;
    int n = 3 * s->particles, most = int_min(s->sticks, n), rank = 0;
    if ((size_t)n > SIZE_MAX / sizeof(real) / (size_t)most) return -1;
    real *rows = calloc((size_t)most * (size_t)n, sizeof *rows);
    if (!rows) return -1;
    for (int k = 0; k < s->sticks; k++) {
        real *row = rows + (size_t)rank * (size_t)n;
        write_row(row, s, s->stick[k]);
        reduce(row, rows, rank, n);
        real left = sqrt(row_dot(row, row, n));
        if (!(left > DEPENDENT)) continue;
        for (int i = 0; i < n; i++) row[i] /= left;
        rank++;
    }
    free(rows);
    return rank;
}
//<
