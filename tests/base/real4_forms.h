// real4_forms.h - every operation of real4.h, one number in, one out, so that
// its forms can be compared.
//
// Included by real4_plain.c and real4_wide.c, which ask for a form first, and by
// check_real4.c: NAME is what the function is called there.

#include "real4.h"
#include "real4_run.h"

static void store(real4 a, real out[REAL4])
{
    for (int l = 0; l < REAL4; l++) out[l] = real4_get(&a, l);
}

static real4 load(const real in[REAL4])
{
    real4 a = real4_all(0);
    for (int l = 0; l < REAL4; l++) real4_set(&a, l, in[l]);
    return a;
}

// Rows a, b and c of six numbers are four bodies' for what gathers.
static void gather_and_scatter(const real_lanes *in, real out[2 * REAL4])
{
    _Alignas(16) real row[REAL4][6] = { { 0 } };
    const real *from[REAL4];
    real *to[REAL4];
    real4 even, odd;
    for (int l = 0; l < REAL4; l++) {
        row[l][2] = in->a[l];
        row[l][3] = in->b[l];
        from[l] = to[l] = row[l];
    }
    real4_gather2(from, 1, &even, &odd);
    real4_scatter2(to, 2, real4_add(even, odd), odd);
    for (int l = 0; l < REAL4; l++) {
        out[l] = row[l][4];
        out[REAL4 + l] = row[l][5];
    }
}

static real4 dot_and_sums(real4 a, real4 b, real4 c)
{
    const real4 x[3] = { a, b, c }, y[3] = { b, c, a };
    real4 to[3] = { c, a, b };
    real4_add3(to, x, b);
    real4_sub3(to, y, a);
    return real4_dot(to, x);
}

static real4 cross_product(real4 a, real4 b, real4 c, int i)
{
    const real4 x[3] = { a, b, c }, y[3] = { b, c, a };
    real4 to[3];
    real4_cross(x, y, to);
    return to[i];
}

// In each lane: is any number of a vector that has only this lane's not zero?
static real4 any_alone(const real_lanes *in)
{
    real4 r = real4_all(0);
    for (int l = 0; l < REAL4; l++) {
        real4 x = real4_all(0);
        real4_set(&x, l, in->a[l]);
        real4_set(&r, l, real4_any(x) ? 1 : 0);
    }
    return r;
}

void NAME(int operation, const real_lanes *in, real out[2 * REAL4])
{
    real4 a = load(in->a), b = load(in->b), c = load(in->c), r = a;
    for (int l = 0; l < 2 * REAL4; l++) out[l] = 0;
    switch (operation) {
    case ADD:      r = real4_add(a, b); break;
    case SUB:      r = real4_sub(a, b); break;
    case MUL:      r = real4_mul(a, b); break;
    case DIV:      r = real4_div(a, b); break;
    case MAX:      r = real4_max(a, b); break;
    case MIN:      r = real4_min(a, b); break;
    case CHOOSE:   r = real4_if_positive(c, a, b); break;
    case SQRT:     r = real4_sqrt(a); break;
    case MAD:      r = real4_mad(a, b, c); break;
    case SUMS:     r = dot_and_sums(a, b, c); break;
    case CROSS_X:  r = cross_product(a, b, c, 0); break;
    case CROSS_Y:  r = cross_product(a, b, c, 1); break;
    case CROSS_Z:  r = cross_product(a, b, c, 2); break;
    case MAKE:     r = real4_make(in->a[3], in->b[2], in->c[1], in->a[0]);
                   break;
    case ALL:      r = real4_all(in->a[1]); break;
    case ANY:      r = any_alone(in); break;
    case GATHER:   gather_and_scatter(in, out); return;
    default:       break;
    }
    store(r, out);
}
