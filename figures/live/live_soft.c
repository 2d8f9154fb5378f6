// live_soft.c - what is drawn with more than its faces: cloth with a weave and a hem,
// rope of two strands, ground with tiles.

#include "live_page.h"

#include <math.h>
#include <stdlib.h>

enum { SQUARES = 12, SIDES = 12, MOST_CUTS = 8 };   // of a cloth; of a rope's ring
static const real HEM = 1.0 / 350;              // of a cloth's width: half as thick
static const real LAY = 5;                      // radii, in which strands change places
static const real PI = 3.14159265358979;

// --- Cloth ------------------------------------------------------------------------
// How many there are in a row: the first two faces are a square of the first two rows.
static int columns_of(const int *face)
{
    int most = 0;
    for (int k = 0; k < 6; k++) most = int_max(most, face[k]);
    return most - 1;
}

static real length_of(const vec3 *at, int n)
{
    real sum = 0;
    for (int i = 1; i < n; i++) sum += vec3_distance(at[i - 1], at[i]);
    return sum;
}

// One side of it, this far off its middle; returns its first vertex.
static int add_side(live_colour c, const vec3 *at, const vec3 *normal, int n,
                    int columns, real off)
{
    real square = (real)SQUARES / (int_max(columns, n / columns) - 1);
    int first = 0;
    for (int i = 0; i < n; i++) {
        vec3 weave = { square * (i % columns), square * (i / columns), LIVE_WOVEN };
        int k = live_vertex(vec3_add_scaled(at[i], off, normal[i]),
                            off > 0 ? normal[i] : vec3_scale(-1, normal[i]), c, 1, weave);
        if (i == 0) first = k;
    }
    return first;
}

// The particle that comes k-th around the rim.
static int on_rim(int k, int columns, int rows)
{
    int across = columns - 1, along = rows - 1;
    k %= 2 * (across + along);
    if (k < across) return k;
    if (k < across + along) return (k - across) * columns + across;
    if (k < 2 * across + along) return along * columns + 2 * across + along - k;
    return (2 * (across + along) - k) * columns;
}

void live_cloth(int number, live_colour c, const vec3 *at, int n, const int *face, int faces)
{
    int columns = columns_of(face), rows = n / columns;
    vec3 *normal = live_normals(at, n, face, faces);
    real half = HEM * length_of(at, columns);
    int a = add_side(c, at, normal, n, columns, half);
    int b = add_side(c, at, normal, n, columns, -half);
    for (const int *f = face; f < face + 3 * faces; f += 3) {
        live_triangle(number, a + f[0], a + f[1], a + f[2]);
        live_triangle(number, b + f[0], b + f[2], b + f[1]);
    }
    for (int k = 0; k < 2 * (columns + rows - 2); k++) {
        int i = on_rim(k, columns, rows), j = on_rim(k + 1, columns, rows);
        live_triangle(number, a + i, b + i, b + j);
        live_triangle(number, a + i, b + j, a + j);
    }
    free(normal);
}

// --- Rope -------------------------------------------------------------------------
// Between at[k] and at[k + 1], as smooth as a spline of Catmull and Rom.
static vec3 rope_point(const vec3 *at, int n, int k, real t)
{
    vec3 a = at[k], b = at[k + 1];
    vec3 da = vec3_scale(0.5, vec3_sub(b, at[int_max(k - 1, 0)]));
    vec3 db = vec3_scale(0.5, vec3_sub(at[int_min(k + 2, n - 1)], a));
    real t2 = t * t, t3 = t2 * t;
    vec3 p = vec3_scale(2 * t3 - 3 * t2 + 1, a);
    p = vec3_add_scaled(p, t3 - 2 * t2 + t, da);
    p = vec3_add_scaled(p, 3 * t2 - 2 * t3, b);
    return vec3_add_scaled(p, t3 - t2, db);
}

// A ring about that place: thick and light where a strand is, dark between them.
static int add_ring(live_colour c, vec3 here, vec3 along, vec3 *side, real radius, real turned)
{
    int first = 0;
    *side = vec3_add_scaled(*side, -vec3_dot(*side, along), along);
    if (vec3_length_squared(*side) < 1e-6) *side = vec3_cross(along, vec3_make(along.y, along.z, along.x));
    *side = vec3_unit(*side);
    vec3 other = vec3_cross(along, *side);
    for (int i = 0; i < SIDES; i++) {
        real angle = 2 * PI * i / SIDES, strand = fabs(cos(angle - turned));
        vec3 out = vec3_add_scaled(vec3_scale(cos(angle), *side), sin(angle), other);
        int k = live_vertex(vec3_add_scaled(here, radius * (0.75 + 0.3 * strand), out), out, c,
                            0.45 + 0.65 * strand, vec3_make(0, 0, LIVE_PLAIN));
        if (i == 0) first = k;
    }
    return first;
}

static void join_rings(int number, int a, int b)
{
    for (int i = 0; i < SIDES; i++) {
        int next = (i + 1) % SIDES;
        live_triangle(number, a + i, a + next, b + next);
        live_triangle(number, a + i, b + next, b + i);
    }
}

void live_rope(int number, live_colour c, const vec3 *at, int n, real radius)
{
    vec3 side = { 0.36, 0.48, 0.8 }, here = at[0];
    real turned = 0;
    int before = -1;
    for (int k = 0; k + 1 < n; k++) {
        int cuts = (int)real_min(MOST_CUTS, 1 + vec3_distance(at[k], at[k + 1]) / radius);
        for (int i = k > 0; i <= cuts; i++) {
            real t = (real)i / cuts, near = i < cuts ? t + 0.25 / cuts : t - 0.25 / cuts;
            vec3 p = rope_point(at, n, k, t), q = rope_point(at, n, k, near);
            turned += PI * vec3_distance(here, p) / (LAY * radius);
            here = p;
            vec3 along = vec3_unit(i < cuts ? vec3_sub(q, p) : vec3_sub(p, q));
            int ring = add_ring(c, p, along, &side, radius, turned);
            if (before >= 0) join_rings(number, before, ring);
            before = ring;
        }
    }
}

// --- Ground -----------------------------------------------------------------------
void live_ground(live_colour c, const vec3 *at, const int *face, int faces, real side)
{
    for (const int *f = face; f < face + 3 * faces; f += 3) {
        vec3 n = vec3_unit(vec3_cross(vec3_sub(at[f[1]], at[f[0]]), vec3_sub(at[f[2]], at[f[0]])));
        int k[3];
        for (int i = 0; i < 3; i++) {
            vec3 p = at[f[i]];
            k[i] = live_vertex(p, n, c, 1, vec3_make(p.x / side, p.z / side, n.y > 0.5 ? LIVE_TILED : LIVE_PLAIN));
        }
        live_triangle(-1, k[0], k[1], k[2]);
    }
}
