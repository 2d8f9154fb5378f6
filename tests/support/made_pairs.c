// made_pairs.c - see made_pairs.h.

#include "made_pairs.h"
#include "random.h"

#include <string.h>

const char *const MADE_NAME[MADE_FAMILIES] = {
    "random", "box, aspect to 1e6", "tetrahedra", "offset 1e7", "scale 1e+-30",
    "scale 1e+-55", "duplicates", "lattice", "coplanar flat", "needles",
    "sphere, capsule", "almost flat", "sliver of A - B", "sliver, 5 to 54 m",
    "resting boxes", "size ratio to 1e9"
};

// 10 to a power between these.
static real power(unsigned long long *s, real low, real high)
{
    return pow(10, random_between(s, low, high));
}

// An orthonormal frame, any.
typedef struct { vec3 x, y, z; } frame;

static frame any_frame(unsigned long long *s)
{
    vec3 x = random_direction(s), c = random_direction(s);
    vec3 y = vec3_unit(vec3_cross(x, c));
    return (frame){ x, y, vec3_cross(x, y) };
}

static vec3 in(const frame *f, vec3 p)
{
    return vec3_add(vec3_scale(p.x, f->x),
                    vec3_add(vec3_scale(p.y, f->y), vec3_scale(p.z, f->z)));
}

static void turn(made *m, const frame *f)
{
    for (int i = 0; i < m->count; i++) m->at[i] = in(f, m->at[i]);
}

static void move(made *m, vec3 by)
{
    for (int i = 0; i < m->count; i++) m->at[i] = vec3_add(m->at[i], by);
}

static void scale(made *m, real by)
{
    for (int i = 0; i < m->count; i++) m->at[i] = vec3_scale(by, m->at[i]);
    m->round *= by;
}

static void cloud(made *m, int count, unsigned long long *s)
{
    m->count = count, m->round = 0;
    for (int i = 0; i < count; i++) m->at[i] = random_vector(s, 0.3, 1);
}

static void box(made *m, vec3 half)
{
    m->count = 8, m->round = 0;
    for (int i = 0; i < 8; i++)
        m->at[i] = (vec3){ i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y,
                           i & 4 ? half.z : -half.z };
}

// How far A reaches beyond B along d.
static real reach(const made *a, const made *b, vec3 d)
{
    real most = -HUGE_VAL, least = HUGE_VAL;
    for (int i = 0; i < a->count; i++)
        most = real_max(most, vec3_dot(d, a->at[i]));
    for (int i = 0; i < b->count; i++)
        least = real_min(least, vec3_dot(d, b->at[i]));
    return most - least;
}

// Moves B along d until a gap of so much along d is left; < 0: overlap.
static void set_apart(made *a, made *b, vec3 d, real gap)
{
    move(b, vec3_scale(reach(a, b, d) + gap, d));
}

// A gap or an overlap of any order of magnitude.
static real any_gap(unsigned long long *s, real low, real high)
{
    real g = power(s, low, high);
    return random_below(s, 3) ? g : -g;
}

static void meet(made *a, made *b, unsigned long long *s)
{
    vec3 d = random_direction(s);
    if (random_below(s, 2)) set_apart(a, b, d, any_gap(s, -15, 0));
    else move(b, random_vector(s, 0, 2));
}

static void clouds(made *a, made *b, unsigned long long *s)
{
    cloud(a, 4 + random_below(s, 9), s);
    cloud(b, 4 + random_below(s, 9), s);
    meet(a, b, s);
}

static void boxes(made *a, made *b, unsigned long long *s)
{
    for (int k = 0; k < 2; k++) {
        made *m = k ? b : a;
        real x = power(s, -6, 0), y = power(s, -6, 0);
        box(m, vec3_make(x, y, power(s, -1, 0)));
        frame f = any_frame(s);
        turn(m, &f);
    }
    meet(a, b, s);
}

static void repeat(made *m, unsigned long long *s)
{
    while (m->count < MADE_POINTS) {
        m->at[m->count] = m->at[random_below(s, m->count)];
        m->count++;
    }
}

static void lattice(made *m, unsigned long long *s)
{
    m->count = 1 + random_below(s, 10), m->round = 0;
    for (int i = 0; i < m->count; i++) {
        int x = random_below(s, 4), y = random_below(s, 4);
        m->at[i] = vec3_make(x, y, random_below(s, 4));
    }
}

static void flat(made *a, made *b, unsigned long long *s)
{
    int turned = random_below(s, 3);
    for (int k = 0; k < 2; k++) {
        made *m = k ? b : a;
        m->count = 2 + random_below(s, 7), m->round = 0;
        for (int i = 0; i < m->count; i++) {
            real x = random_real(s), y = random_real(s);
            m->at[i] = vec3_make(x + 1.5 * k * (turned ? 1 : x), y, 0.25);
            if (turned == 2)            // a plane that doubles hold exactly
                m->at[i] = vec3_make(m->at[i].x, y, m->at[i].x);
        }
    }
}

static void needles(made *a, made *b, unsigned long long *s)
{
    for (int k = 0; k < 2; k++) {
        made *m = k ? b : a;
        cloud(m, 4 + random_below(s, 5), s);
        real x = power(s, -10, -2), y = power(s, -10, -2);
        for (int i = 0; i < m->count; i++)
            m->at[i] = vec3_make(x * m->at[i].x, y * m->at[i].y, m->at[i].z);
        frame f = any_frame(s);
        turn(m, &f);
    }
    if (random_below(s, 2)) meet(a, b, s);
    else move(b, random_vector(s, 0, power(s, -12, 0)));
}

static void capsules(made *a, made *b, unsigned long long *s)
{
    cloud(a, 1 + random_below(s, 2), s);
    cloud(b, 1 + random_below(s, 8), s);
    a->round = power(s, -3, 0);
    if (b->count < 3) b->round = power(s, -3, 0);
    vec3 d = random_direction(s);
    set_apart(a, b, d, a->round + b->round + any_gap(s, -12, 0));
}

static void almost_flat(made *a, made *b, unsigned long long *s)
{
    for (int k = 0; k < 2; k++) {
        made *m = k ? b : a;
        cloud(m, 4 + random_below(s, 5), s);
        real thin = power(s, -16, -6);
        for (int i = 0; i < m->count; i++) m->at[i].z *= thin;
        frame f = any_frame(s);
        turn(m, &f);
    }
    meet(a, b, s);
}

// A wedge with an edge along x at z = 0, the rest below.
static void wedge(made *m, unsigned long long *s)
{
    m->count = 4 + random_below(s, 4), m->round = 0;
    m->at[0] = vec3_make(-random_between(s, 0.2, 1), 0, 0);
    m->at[1] = vec3_make(random_between(s, 0.2, 1), 0, 0);
    for (int i = 2; i < m->count; i++) {
        real x = random_real(s), y = random_real(s);
        m->at[i] = vec3_make(x, y, -random_between(s, 0.1, 1));
    }
}

// Two edges along one line but for a turn of 1e-16 to 1e-8, and what is between
// them as little.
static void sliver(made *a, made *b, real size, unsigned long long *s)
{
    wedge(a, s);
    wedge(b, s);
    real y = power(s, -16, -8), z = power(s, -16, -8);
    real slide = random_real(s);
    for (int i = 0; i < b->count; i++) {
        vec3 p = b->at[i];
        b->at[i] = vec3_make(p.x + slide, p.y + y * p.x, z * p.x - p.z);
    }
    move(b, vec3_make(0, random_real(s) * power(s, -16, -8),
                      any_gap(s, -16, -8)));
    frame f = any_frame(s);
    turn(a, &f), turn(b, &f);
    vec3 place = random_below(s, 2) ? random_vec3(s, 1) : vec3_make(0, 0, 0);
    move(a, place), move(b, place);
    scale(a, size), scale(b, size);
}

static void resting(made *a, made *b, unsigned long long *s)
{
    vec3 h[2];
    for (int k = 0; k < 2; k++) {
        real x = random_between(s, 0.2, 1), y = random_between(s, 0.2, 1);
        h[k] = vec3_make(x, y, random_between(s, 0.1, 1));
        box(k ? b : a, h[k]);
    }
    real x = power(s, -16, -3) * random_real(s), y = power(s, -16, -3);
    frame tilt = { vec3_unit(vec3_make(1, 0, x)), { 0, 0, 0 }, { 0, 0, 0 } };
    tilt.z = vec3_unit(vec3_cross(tilt.x, vec3_make(0, 1, y)));
    tilt.y = vec3_cross(tilt.z, tilt.x);
    real c = random_below(s, 2) ? random_real(s) : 1, d = sqrt(1 - c * c);
    frame spin = { { c, d, 0 }, { -d, c, 0 }, { 0, 0, 1 } };
    turn(b, &spin), turn(b, &tilt);
    set_apart(a, b, vec3_make(0, 0, 1), any_gap(s, -16, -3));
    if (random_below(s, 2))
        move(b, vec3_make(random_real(s) * 0.6, random_real(s) * 0.6, 0));
    frame f = any_frame(s);
    if (random_below(s, 2)) turn(a, &f), turn(b, &f);
}

static void ratio(made *a, made *b, unsigned long long *s)
{
    real r = power(s, -9, -2);
    for (int k = 0; k < 2; k++) {
        made *m = k ? b : a;
        if (random_below(s, 2)) cloud(m, 4 + random_below(s, 9), s);
        else {
            box(m, vec3_make(0.5, 0.5, 0.5));
            frame f = any_frame(s);
            turn(m, &f);
        }
    }
    scale(b, r);
    // On the surface of A: a point of a face, an edge, or a corner.
    real u = random_fraction(s), v = random_fraction(s) * (1 - u);
    if (random_below(s, 2)) v = 0;
    int i = random_below(s, a->count), j = random_below(s, a->count);
    int k = random_below(s, a->count);
    vec3 at = vec3_add(vec3_scale(1 - u - v, a->at[i]),
                       vec3_add(vec3_scale(u, a->at[j]),
                                vec3_scale(v, a->at[k])));
    move(b, vec3_add(at, random_vector(s, 0, 2 * r)));
    if (random_below(s, 2)) { made t = *a; *a = *b; *b = t; }
}

static void scaled(made *a, made *b, int most, unsigned long long *s)
{
    clouds(a, b, s);
    real by = power(s, most - 1, most);
    if (random_below(s, 2)) by = 1 / by;
    scale(a, by), scale(b, by);
}

static void offset(made *a, made *b, unsigned long long *s)
{
    clouds(a, b, s);
    vec3 far = random_vector(s, 1e6, 1e7);
    move(a, far), move(b, far);
}

void made_pair(made *a, made *b, int family, unsigned long long *s)
{
    memset(a, 0, sizeof *a), memset(b, 0, sizeof *b);
    switch (family) {
    case 0: clouds(a, b, s); break;
    case 1: boxes(a, b, s); break;
    case 2: cloud(a, 4, s), cloud(b, 4, s), meet(a, b, s); break;
    case 3: offset(a, b, s); break;
    case 4: scaled(a, b, 30, s); break;
    case 5: scaled(a, b, 55, s); break;
    case 6: clouds(a, b, s), repeat(a, s), repeat(b, s); break;
    case 7: lattice(a, s), lattice(b, s), move(b, random_below(s, 2)
                ? vec3_make(3, 1, 0) : vec3_make(0, 0, 0)); break;
    case 8: flat(a, b, s); break;
    case 9: needles(a, b, s); break;
    case 10: capsules(a, b, s); break;
    case 11: almost_flat(a, b, s); break;
    case 12: sliver(a, b, 1, s); break;
    case 13: sliver(a, b, random_between(s, 5, 54), s); break;
    case 14: resting(a, b, s); break;
    default: ratio(a, b, s); break;
    }
}

void made_before(made *m, const made *now, unsigned long long *s)
{
    real size = 0;
    for (int i = 1; i < now->count; i++)
        size = real_max(size, vec3_distance(now->at[i], now->at[0]));
    vec3 by = random_vec3(s, 0.01 * size), lean = random_vec3(s, 0.01);
    *m = *now;
    for (int i = 0; i < m->count; i++) {
        vec3 p = vec3_sub(now->at[i], now->at[0]);
        m->at[i] = vec3_add(now->at[i], vec3_add(by, vec3_cross(lean, p)));
    }
}
