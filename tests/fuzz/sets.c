// sets.c - see sets.h.

#include "sets.h"

// A few points; of each: new, an earlier one again, or between two earlier.
static void take_points(body *b, bytes *in)
{
    b->count = take_count(in, 1, 12);
    for (int i = 0; i < b->count; i++) {
        int how = take_byte(in) % 6;
        vec3 p = b->at[i > 0 ? take_byte(in) % i : 0];
        vec3 q = b->at[i > 0 ? take_byte(in) % i : 0];
        if (i == 0 || how < 4) b->at[i] = take_vec3(in);
        else if (how == 4) b->at[i] = p;
        else b->at[i] = vec3_add(vec3_scale(0.5, p), vec3_scale(0.5, q));
    }
}

// The balls are made once: that takes longer than any query.
static const body *ball(int level)
{
    static body made[3];
    if (made[level].count == 0) body_icosphere(&made[level], level, 1);
    return &made[level];
}

static void take_body(body *b, bytes *in)
{
    unsigned long long seed = (unsigned long long)take_byte(in);
    int kind = take_byte(in) % 12;
    switch (kind) {
    case 0: *b = body_cube(0, 0, 0); break;
    case 1: body_icosahedron(b, 1); break;
    case 2: body_square(b); break;
    case 3: body_any(b, (int)(seed % 5), &seed); break;
    case 4: *b = *ball(1); break;
    case 5: *b = *ball(2); break;
    default: take_points(b, in); return;
    }
    if (take_byte(in) & 1) body_turn(b, &seed);
    vec3 scale = take_vec3(in), by = take_vec3(in);
    for (int i = 0; i < b->count; i++) {
        vec3 p = b->at[i];
        b->at[i] = (vec3){ scale.x * p.x + by.x, scale.y * p.y + by.y,
                           scale.z * p.z + by.z };
    }
}

int is_number(real x) { return x - x == 0; }

// The smallest and the largest coordinate that is not 0.
static void range_of(const body *b, real *least, real *most, int *finite)
{
    for (int i = 0; i < b->count; i++) {
        real x[3] = { b->at[i].x, b->at[i].y, b->at[i].z };
        for (int k = 0; k < 3; k++) {
            real size = fabs(x[k]);
            if (!is_number(size)) *finite = 0;
            if (size > 0 && size < *least) *least = size;
            if (size > *most) *most = size;
        }
    }
}

static void box_of(const body *b, vec3 *low, vec3 *high)
{
    *low = *high = b->at[0];
    for (int i = 1; i < b->count; i++) {
        vec3 p = b->at[i];
        *low = (vec3){ fmin(low->x, p.x), fmin(low->y, p.y),
                       fmin(low->z, p.z) };
        *high = (vec3){ fmax(high->x, p.x), fmax(high->y, p.y),
                        fmax(high->z, p.z) };
    }
}

// The largest of b's coordinates less the least of a's.
static long double over(vec3 low, vec3 high)
{
    long double x = (long double)high.x - (long double)low.x;
    long double y = (long double)high.y - (long double)low.y;
    long double z = (long double)high.z - (long double)low.z;
    return fmaxl(x, fmaxl(y, z));
}

void sets_measure(sets *s)
{
    vec3 low_a, high_a, low_b, high_b;
    real least = HUGE_VAL, most = 0;
    s->finite = 1;
    range_of(&s->a, &least, &most, &s->finite);
    range_of(&s->b, &least, &most, &s->finite);
    s->fair = s->finite && most <= 1e57
           && (most == 0 || (least >= 1e-40 && least >= 1e-9 * most));
    box_of(&s->a, &low_a, &high_a);
    box_of(&s->b, &low_b, &high_b);
    s->reach = fmaxl(over(low_a, high_b), over(low_b, high_a));
    s->place = 2 * (long double)most;
    if (s->reach > 0 && s->reach < 1e-40L) s->fair = 0;
}

void sets_take(sets *s, bytes *in)
{
    take_body(&s->a, in);
    if (take_byte(in) % 8 == 0) s->b = s->a;
    else take_body(&s->b, in);
    // Far from the origin: both, by the same.
    if (take_byte(in) % 8 == 0) {
        vec3 by = take_vec3(in);
        body_move(&s->a, by);
        body_move(&s->b, by);
    }
    sets_measure(s);
}

static int is_between(real x, real low, real high, long double rounding)
{
    return (long double)x >= (long double)low - rounding
        && (long double)x <= (long double)high + rounding;
}

int set_may_hold(const body *b, vec3 x, long double rounding)
{
    vec3 low, high;
    box_of(b, &low, &high);
    return is_between(x.x, low.x, high.x, rounding)
        && is_between(x.y, low.y, high.y, rounding)
        && is_between(x.z, low.z, high.z, rounding);
}
