// solution.c - what is perpendicular to all that is forbidden.

#include "flex.h"

#include <stdlib.h>

// Of what a row was, this fraction is rounding.
static const real NOTHING = 1e-9;

// Rows of length 1, each perpendicular to the others.  The row behind the last
// is the one in hand.
typedef struct {
    real *at;
    int kept, size;     // rows; numbers in each
} rows;

static real *row_in_hand(const rows *r)
{
    return r->at + (size_t)r->kept * (size_t)r->size;
}

static real dot(const real *a, const real *b, int n)
{
    real sum = 0;
    for (int i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}

// Takes from the row in hand its parts along all others, twice, because the
// first time leaves rounding of the size of the row.  Returns what is left.
static real strip(const rows *r)
{
    real *v = row_in_hand(r);
    for (int pass = 0; pass < 2; pass++)
        for (int k = 0; k < r->kept; k++) {
            const real *u = r->at + (size_t)k * (size_t)r->size;
            real part = dot(u, v, r->size);
            for (int i = 0; i < r->size; i++) v[i] -= part * u[i];
        }
    return sqrt(dot(v, v, r->size));
}

// The row in hand is kept, if it says anything new.
static void keep(rows *r)
{
    real *v = row_in_hand(r);
    real before = sqrt(dot(v, v, r->size)), left = strip(r);
    if (!(left > NOTHING * before)) return;
    for (int i = 0; i < r->size; i++) v[i] /= left;
    r->kept++;
}

static void clear(const rows *r)
{
    real *v = row_in_hand(r);
    for (int i = 0; i < r->size; i++) v[i] = 0;
}

// v for particle i.
static void put(const rows *r, int i, vec3 v)
{
    real *at = row_in_hand(r) + 3 * i;
    at[0] = v.x;
    at[1] = v.y;
    at[2] = v.z;
}

// Three shifts and, about particle 0, three turns.  (A turn about any other
// place is one of these and a shift.)
static void keep_rigid(rows *r, const vec3 *at, int n)
{
    for (int k = 0; k < 6; k++) {
        vec3 axis = { k % 3 == 0, k % 3 == 1, k % 3 == 2 };
        for (int i = 0; i < n; i++)
            put(r, i, k < 3 ? axis
                            : vec3_cross(axis, vec3_sub(at[i], at[0])));
        keep(r);
    }
}

// The rows of the rigidity matrix.
static void keep_sticks(rows *r, const vec3 *at, const stick *s, int sticks)
{
    for (int k = 0; k < sticks; k++) {
        vec3 u = vec3_unit(vec3_sub(at[s[k].b], at[s[k].a]));
        clear(r);
        put(r, s[k].a, vec3_scale(-1, u));
        put(r, s[k].b, u);
        keep(r);
    }
}

// Of the vectors with a single 1, the one that has most left is a flex.
static void write_flex(const rows *r, int n, vec3 *flex)
{
    real most = 0;
    for (int i = 0; i < n; i++) flex[i] = (vec3){ 0, 0, 0 };
    if (r->kept == r->size) return;
    for (int j = 0; j < r->size; j++) {
        const real *v = row_in_hand(r);
        clear(r);
        row_in_hand(r)[j] = 1;
        real left = strip(r);
        if (!(left > most)) continue;
        most = left;
        for (int i = 0; i < n; i++)
            flex[i] = vec3_scale(1 / left, (vec3){ v[3 * i], v[3 * i + 1],
                                                   v[3 * i + 2] });
    }
}

int flex_find(const vec3 *at, int n, const stick *s, int sticks, vec3 *flex)
{
    size_t size = 3 * (size_t)n;
    rows r = { .at = calloc((size + 1) * size + 1, sizeof(real)),
               .size = 3 * n };
    if (!r.at) return -1;
    keep_rigid(&r, at, n);
    keep_sticks(&r, at, s, sticks);
    write_flex(&r, n, flex);
    free(r.at);
    return r.size - r.kept;
}
