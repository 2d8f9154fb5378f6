// 11-manifold.c - a box that is set down on another: how far does it tilt if
// they touch in one point, and if they touch in up to four?  And two faces seen
// along the normal, with the corners of what they share; and what it costs to
// find them.

#include "clock.h"
#include "manifold.h"
#include "random.h"
#include "response.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { CORNERS = 8, MOST = 12, FRAMES = 180, SUBSTEPS = 8, PASSES = 2 };
static const real DT = 1.0 / 60;

static unsigned long long seed = 10;

// --- the query ---------------------------------------------------------------

static query_result query(const shape *a, const vec3 *at_a, const shape *b,
                          const vec3 *at_b, real margin)
{
    collider ca = { a, at_a, false }, cb = { b, at_b, false };
    query_cache none = { .count = 0 };
    return query_nearest(&ca, &cb, margin, &none);
}

static manifold touches(const shape *a, const vec3 *at_a, const shape *b,
                        const vec3 *at_b, const query_result *q, real margin)
{
    collider ca = { a, at_a, false }, cb = { b, at_b, false };
    return manifold_find(&ca, &cb, q, margin, 0);
}

// --- a box on a box ----------------------------------------------------------

// The box's particles, then those of the table, which are nailed.
typedef struct {
    particle p[2 * CORNERS];
    vec3     at[2 * CORNERS];
} stage;

static int find_contacts(stage *s, const shape *box, const shape *table,
                         int most, feature_contact *c)
{
    real margin = 0.02;
    for (int i = 0; i < 2 * CORNERS; i++) s->at[i] = s->p[i].position;
    query_result q = query(box, s->at, table, s->at + CORNERS, margin);
    if (!q.near) return 0;
    manifold m = { 1, q.normal, { q.at }, 0, 0 };
    if (most > 1)
        m = touches(box, s->at, table, s->at + CORNERS, &q, margin);
    for (int k = 0; k < m.count; k++) {
        vec3 on_b = feature_at(&m.point[k].b, s->at + CORNERS);
        c[k] = (feature_contact){ .a = m.point[k].a, .normal = q.normal,
                          .apart = vec3_dot(on_b, q.normal),
                          .mass_a = 1, .mass_b = HUGE_VAL };
    }
    return m.count;
}

// Degrees between the box's upright edges and the vertical.
static real tilt(const particle *p)
{
    vec3 up = { 0, 0, 0 };
    for (int k = 0; k < CORNERS; k++)
        up = vec3_add_scaled(up, k & 2 ? 1 : -1, p[k].position);
    return atan2(hypot(up.x, up.z), up.y) * 180 / acos(-1.0);
}

// m, how deep its lowest corner is in the table, whose top is y = 0.
static real depth(const particle *p)
{
    real deepest = 0;
    for (int k = 0; k < CORNERS; k++)
        deepest = fmax(deepest, -p[k].position.y);
    return deepest;
}

static void drop(int most)
{
    shape box, table;
    stage s;
    feature_contact c[MANIFOLD_POINTS];
    relax_options relax = relax_options_pbd();
    const vec3 gravity = { 0, -9.81, 0 };
    real worst_tilt = 0, worst_depth = 0;
    if (!shape_box(&box, vec3_make(1, 0.3, 1), 1).ok
        || !shape_box(&table, vec3_make(3, 1, 3), 1).ok) return;
    for (int i = 0; i < CORNERS; i++) {
        // It leans by half a degree.
        vec3 r = box.at[i], x = { 0.1, 0.17, 0.2 };
        x = vec3_add(x, vec3_make(r.x - 0.0087 * r.y, r.y + 0.0087 * r.x, r.z));
        vec3 y = vec3_add(table.at[i], vec3_make(0, -0.5, 0));
        s.p[i] = (particle){ x, x, 1 / box.mass[i] };
        s.p[CORNERS + i] = (particle){ y, y, 0 };
    }
    printf("\n\n# at most %d: s, tilt in degrees, depth in mm\n", most);
    for (int frame = 0; frame < FRAMES; frame++) {
        printf("%.4f %.6g %.6g\n", frame * DT, tilt(s.p), 1e3 * depth(s.p));
        int n = find_contacts(&s, &box, &table, most, c);
        for (int step = 0; step < SUBSTEPS; step++) {
            verlet_step(s.p, CORNERS, gravity, NULL, DT / SUBSTEPS);
            for (int pass = 0; pass < PASSES; pass++) {
                for (int k = 0; k < n; k++)
                    response_separate(&c[k], s.p, 0.5);
                sticks_iterate(box.stick, box.sticks, s.p, relax);
            }
        }
        worst_tilt = fmax(worst_tilt, tilt(s.p));
        worst_depth = fmax(worst_depth, depth(s.p));
    }
    printf("# worst tilt %.3g degrees, worst depth %.3g mm\n", worst_tilt,
           1e3 * worst_depth);
    shape_free(&box);
    shape_free(&table);
}

// --- two faces seen along the normal -----------------------------------------

static vec3 turned(vec3 p, real by)
{
    return vec3_make(cos(by) * p.x + sin(by) * p.z, p.y,
                     cos(by) * p.z - sin(by) * p.x);
}

static void outline(const vec3 *at, const int *v)
{
    for (int k = 0; k <= 4; k++) printf("%g %g\n", at[v[k % 4]].z,
                                        at[v[k % 4]].x);
}

static real across(vec3 o, vec3 p, vec3 x)
{
    return (p.z - o.z) * (x.x - o.x) - (p.x - o.x) * (x.z - o.z);
}

// The corners of what the two share: kind 0 a vertex of A, 1 of B, 2 a
// crossing.
static void corners(const vec3 *a, const int *va, const vec3 *b, const int *vb)
{
    for (int side = 0; side < 2; side++) {
        const vec3 *p = side ? b : a, *q = side ? a : b;
        const int *vp = side ? vb : va, *vq = side ? va : vb;
        for (int i = 0; i < 4; i++) {
            int in = 0;
            for (int j = 0; j < 4; j++)
                in += across(q[vq[j]], q[vq[(j + 1) % 4]], p[vp[i]]) > 0;
            if (in == 4 || in == 0) printf("%g %g %d\n", p[vp[i]].z,
                                           p[vp[i]].x, side);
        }
    }
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            vec3 a0 = a[va[i]], a1 = a[va[(i + 1) % 4]];
            vec3 b0 = b[vb[j]], b1 = b[vb[(j + 1) % 4]];
            real u = across(b0, b1, a0), u1 = across(b0, b1, a1);
            real v = across(a0, a1, b0), v1 = across(a0, a1, b1);
            if (u * u1 >= 0 || v * v1 >= 0) continue;
            printf("%g %g 2\n", a0.z + u / (u - u1) * (a1.z - a0.z),
                   a0.x + u / (u - u1) * (a1.x - a0.x));
        }
}

static void faces(void)
{
    shape s;
    vec3 a[CORNERS], b[CORNERS];
    const int low[4] = { 0, 1, 5, 4 }, high[4] = { 2, 3, 7, 6 };
    if (!shape_box(&s, vec3_make(1, 1, 1), 1).ok) return;
    for (int i = 0; i < CORNERS; i++) {
        b[i] = s.at[i];
        a[i] = vec3_add(turned(s.at[i], 0.45), vec3_make(0.22, 1.001, 0.38));
    }
    printf("\n\n# the lower face of A\n");
    outline(a, low);
    printf("\n\n# the upper face of B\n");
    outline(b, high);
    printf("\n\n# corners of what they share, and their kind\n");
    corners(a, low, b, high);
    query_result q = query(&s, a, &s, b, 0.01);
    manifold m = touches(&s, a, &s, b, &q, 0.01);
    printf("\n\n# the touches of manifold_find\n");
    for (int k = 0; k < m.count; k++) {
        vec3 x = feature_at(&m.point[k].b, b);
        printf("%g %g\n", x.z, x.x);
    }
    vec3 x = feature_at(&q.at.b, b);
    printf("\n\n# what the query found\n%g %g\n", x.z, x.x);
    shape_free(&s);
}

// --- what it costs -----------------------------------------------------------

enum { PAIRS = 5000, BLOCK = 100, AGAIN = 20 };

typedef struct {
    vec3 a[MOST], b[MOST];
    query_result q;
} pair;

// kind 0: cubes stacked exactly; 1: turned about the normal; 2: anyhow.
static pair any_pair(const shape *s, int kind)
{
    pair p;
    do {
        vec3 x = random_direction(&seed),
             y = vec3_unit(vec3_cross(x, random_direction(&seed)));
        vec3 z = vec3_cross(x, y), off = vec3_scale(1.001, z);
        real c = random_real(&seed), d = sqrt(1 - c * c);
        vec3 u = x, v = y, w = z;
        if (kind == 1) {
            u = vec3_add_scaled(vec3_scale(c, x), d, y);
            v = vec3_add_scaled(vec3_scale(c, y), -d, x);
            off = vec3_add_scaled(off, 0.4 * random_real(&seed), x);
        } else if (kind == 2) {
            u = random_direction(&seed);
            v = vec3_unit(vec3_cross(u, random_direction(&seed)));
            w = vec3_cross(u, v);
            off = vec3_scale(0.95, random_direction(&seed));
        }
        for (int i = 0; i < s->particles; i++) {
            vec3 r = s->at[i];
            p.b[i] = vec3_add_scaled(vec3_add_scaled(
                     vec3_scale(r.x, x), r.y, y), r.z, z);
            p.a[i] = vec3_add(off, vec3_add_scaled(vec3_add_scaled(
                     vec3_scale(r.x, u), r.y, v), r.z, w));
        }
        p.q = query(s, p.a, s, p.b, 0.05);
    } while (!p.q.near);
    return p;
}

// Seconds that one block takes: the manifold of each pair, or GJK without a
// start.  Counts the touches, or GJK's.
static real block_seconds(const shape *s, const pair *p, int gjk, int *count)
{
    real start = clock_seconds();
    for (int k = 0; k < BLOCK; k++) {
        hull a = { p[k].a, s->particles }, b = { p[k].b, s->particles };
        if (gjk) *count += gjk_distance(a, b, HUGE_VAL, NULL).last.count;
        else     *count += touches(s, a.at, s, b.at, &p[k].q, 0.05).count;
    }
    return clock_seconds() - start;
}

// The mean over blocks of pairs, of each the best of many rounds: the machine
// has other things to do.
static void cost(const char *what, const shape *s, int kind)
{
    static pair all[PAIRS];
    real sum[2] = { 0, 0 };
    int count[2] = { 0, 0 }, alone = 0;
    for (int k = 0; k < PAIRS; k++) all[k] = any_pair(s, kind);
    for (int first = 0; first < PAIRS; first += BLOCK)
        for (int gjk = 0; gjk < 2; gjk++) {
            real best = HUGE_VAL;
            for (int again = 0; again < AGAIN; again++)
                best = fmin(best, block_seconds(s, all + first, gjk,
                                                &count[gjk]));
            sum[gjk] += best;
        }
    for (int k = 0; k < PAIRS; k++)
        alone += touches(s, all[k].a, s, all[k].b, &all[k].q, 0.05).count == 1;
    printf("# %s: manifold_find %.0f ns, cold GJK %.0f ns, %.2f touches, "
           "%.0f %% have one\n", what, 1e9 * sum[0] / PAIRS,
           1e9 * sum[1] / PAIRS, (real)count[0] / PAIRS / AGAIN,
           100.0 * alone / PAIRS);
}

int main(void)
{
    shape cube, ball;
    if (!shape_box(&cube, vec3_make(1, 1, 1), 1).ok
        || !shape_icosahedron(&ball, 0.5, 1).ok) return 1;
    printf("# a box of 1 x 0.3 x 1 m set down on a table; %d substeps "
           "of 1/60 s, %d times contacts and sticks in each\n"
           "# %s, %s\n", SUBSTEPS, PASSES, __VERSION__, FLAGS);
    cost("equal cubes stacked", &cube, 0);
    cost("cubes stacked, turned", &cube, 1);
    cost("icosahedra anyhow", &ball, 2);
    drop(1);
    drop(MANIFOLD_POINTS);
    faces();
    shape_free(&cube);
    shape_free(&ball);
    return 0;
}
