// queries.c - the same questions about convex bodies, to this library and to
// openGJK, Jolt and Box3D, of which any may be missing.  Prints a CSV.
//
// All take turns, in rounds: the machine may be busy, and ratios hold.  A ratio
// is taken in every round; the table has their median, least and largest.

#include "ball.h"
#include "clock.h"
#include "hit_face.h"
#include "oracle.h"
#include "queries.h"
#include "random.h"
#include "search.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PAIRS = QUERY_PAIRS, CORNERS = QUERY_CORNERS, ROUNDS = 15 };

// m, for bodies of radius 0.5 m: how far they are apart, or in each other.
static const real NEAREST = 0.02, WIDEST = 0.5;

// Relative to the distance, of answers in doubles; and of a hundredth: what an
// answer in floats or an approximate one may be off.
static const real TIGHT = 1e-13, ROUGH = 1e-2;

typedef struct {
    vec3 a[CORNERS], b[CORNERS];
    vec3 from_b;        // m, from the middle of B to that of A
    simplex found;      // of the pair before it moved
    separating_axis parted; // by what, then
} couple;

static couple before[PAIRS], after[PAIRS];
static shape plan;
static real truth[2][PAIRS];    // m, of before and after: < 0: depth

static _Noreturn void give_up(const char *why)
{
    fprintf(stderr, "queries: %s\n", why);
    exit(1);
}

// ---- The pairs -------------------------------------------------------------

static hull_mesh side_of(const vec3 *at)
{
    return (hull_mesh){ { at, plan.particles }, &plan.mesh, 2 * plan.radius };
}

static gjk_result plain(const couple *c, simplex *from)
{
    return gjk_distance(side_of(c->a).hull, side_of(c->b).hull, HUGE_VAL, from);
}

// Turned in any way.
static void put_body(vec3 *at, vec3 middle, unsigned long long *seed)
{
    vec3 x = random_direction(seed);
    vec3 z = vec3_unit(vec3_cross(x, random_direction(seed)));
    vec3 y = vec3_cross(z, x);
    for (int i = 0; i < plan.particles; i++) {
        vec3 v = plan.at[i], sum = vec3_add_scaled(middle, v.x, x);
        at[i] = vec3_add_scaled(vec3_add_scaled(sum, v.y, y), v.z, z);
    }
}

static void move(couple *c, vec3 by)
{
    c->from_b = vec3_sub(c->from_b, by);
    for (int i = 0; i < plan.particles; i++) c->b[i] = vec3_add(c->b[i], by);
}

// B comes towards A until they are `gap` apart: Newton, because the distance
// falls, convex, along the way.  A negative gap: pushed in by so much.
static void make_pair(couple *c, real gap, unsigned long long *seed)
{
    const real wanted = fmax(gap, 1e-6);
    vec3 course = random_direction(seed);
    *c = (couple){ .from_b = vec3_scale(-2, course) };
    put_body(c->a, (vec3){ 0, 0, 0 }, seed);
    put_body(c->b, vec3_scale(2, course), seed);
    gjk_result r = plain(c, NULL);
    for (int k = 0; k < 60 && fabs(r.distance - wanted) > 1e-9; k++) {
        real slope = -vec3_dot(r.axis, course) / r.distance;
        move(c, vec3_scale((wanted - r.distance) / slope, course));
        r = plain(c, NULL);
    }
    if (gap < 0) move(c, vec3_scale(-gap / r.distance, r.axis));
}

// By up to half a degree, and up to 2.5 mm: about what a frame brings.
static void move_on(couple *c, unsigned long long *seed)
{
    const real most = 0.5 * 3.14159265358979 / 180;
    vec3 about = vec3_scale(most * random_fraction(seed),
                            random_direction(seed));
    vec3 middle = vec3_scale(-1, c->from_b);
    for (int i = 0; i < plan.particles; i++) {
        vec3 r = vec3_sub(c->b[i], middle), turn = vec3_cross(about, r);
        c->b[i] = vec3_add(c->b[i], turn);
    }
    move(c, vec3_scale(0.0025 * random_fraction(seed),
                       random_direction(seed)));
}

static real true_gap(const couple *c)
{
    hull a = side_of(c->a).hull, b = side_of(c->b).hull;
    gjk_result g = plain(c, NULL);
    if (plan.particles > 12)
        return g.status == GJK_OVERLAP
             ? -hit_face_find(a, b, &g.last).depth : g.distance;
    return (real)(g.status == GJK_OVERLAP ? -oracle_depth(a, b)
                                          : oracle_distance(a, b));
}

static void make_pairs(bool are_apart)
{
    unsigned long long seed = 4;
    for (int k = 0; k < PAIRS; k++) {
        real part = (k + random_fraction(&seed)) / PAIRS;
        real gap = NEAREST + (WIDEST - NEAREST) * part;
        make_pair(&before[k], are_apart ? gap : -gap / 2, &seed);
        after[k] = before[k];
        move_on(&after[k], &seed);
        before[k].parted = (separating_axis){ before[k].from_b, -1, -1 };
        hull_mesh a = side_of(before[k].a), b = side_of(before[k].b);
        search_apart(&a, &b, 0, &before[k].parted);
        plain(&before[k], &before[k].found);
        truth[0][k] = true_gap(&before[k]);
        truth[1][k] = true_gap(&after[k]);
    }
}

// ---- The questions ---------------------------------------------------------

// What stands ready when the clock starts: the corners where they are now.
// Pair after pair, each as long as it is.
static vec3 corners_now[PAIRS * 2 * CORNERS];
static struct {
    simplex found;
    separating_axis parted;
} now[PAIRS];
static real answer[PAIRS];

static hull_mesh here(int k, int side)
{
    return side_of(corners_now + (2 * k + side) * plan.particles);
}

static void put_corners(int k, const couple *c)
{
    vec3 *to = corners_now + 2 * k * plan.particles;
    for (int i = 0; i < plan.particles; i++) {
        to[i] = c->a[i];
        to[plan.particles + i] = c->b[i];
    }
}

#if defined(WITH_GJK) || defined(WITH_BOX3D) || defined(WITH_JOLT)
static query_pair theirs(const couple *c)
{
    return (query_pair){ plan.particles, &c->a[0].x, &c->b[0].x,
                         { -c->from_b.x, -c->from_b.y, -c->from_b.z } };
}
#endif

static void put_ours(int k)
{
    put_corners(k, &before[k]);
    now[k].parted = (separating_axis){ before[k].from_b, -1, -1 };
    now[k].found.count = 0;
}

static void put_ours_moved(int k)
{
    put_corners(k, &after[k]);
    now[k].parted = before[k].parted;
    now[k].found = before[k].found;
}

static real ask_plain(int k)
{
    return gjk_distance(here(k, 0).hull, here(k, 1).hull, HUGE_VAL,
                        NULL).distance;
}

static real ask_plain_carried(int k)
{
    return gjk_distance(here(k, 0).hull, here(k, 1).hull, HUGE_VAL,
                        &now[k].found).distance;
}

static real ask_distance(int k)
{
    hull_mesh a = here(k, 0), b = here(k, 1);
    return search_nearest(&a, &b, HUGE_VAL, &now[k].found).distance;
}

static real ask_apart(int k)
{
    hull_mesh a = here(k, 0), b = here(k, 1);
    return search_apart(&a, &b, 0, &now[k].parted) ? 1 : -1;
}

static real ask_depth(int k)
{
    hull_mesh a = here(k, 0), b = here(k, 1);
    simplex s = { .count = 0 };
    gjk_result g = search_nearest(&a, &b, 0, &s);
    if (g.status != GJK_OVERLAP) return 0;
    return -hit_face_climb(&a, &b, &g.last).depth;
}

static real ask_plain_depth(int k)
{
    hull a = here(k, 0).hull, b = here(k, 1).hull;
    gjk_result g = gjk_distance(a, b, 0, NULL);
    if (g.status != GJK_OVERLAP) return 0;
    return -hit_face_find(a, b, &g.last).depth;
}

#ifdef WITH_GJK
static void put_gjk(int k)
{
    query_pair p = theirs(&before[k]);
    gjk_put(k, &p);
}

static real ask_gjk(int k)
{
    return gjk_ask(k);
}
#endif

#ifdef WITH_BOX3D
static void put_box3d(int k)
{
    query_pair p = theirs(&before[k]), moved = theirs(&after[k]);
    box3d_put(k, &p);
    box3d_learn(k);
    box3d_move(k, &moved);
}

static real ask_box3d(int k)
{
    return box3d_ask(k);
}
#endif

#ifdef WITH_JOLT
static void put_jolt(int k)
{
    query_pair p = theirs(&before[k]);
    jolt_put(k, &p);
}

static void put_jolt_moved(int k)
{
    query_pair p = theirs(&before[k]), moved = theirs(&after[k]);
    jolt_put(k, &p);
    jolt_learn(k);
    jolt_move(k, &moved);
}

static real ask_jolt(int k)
{
    return jolt_overlap(k) ? -1 : 1;
}

static real ask_jolt_depth(int k)
{
    return -jolt_depth(k);
}
#endif

// ---- The ways --------------------------------------------------------------

typedef enum { DISTANCE, SIGN } kind;

typedef struct {
    const char *question, *by;
    bool are_apart, is_moved;
    kind kind;
    real target;                // of ours over theirs; 0: none
    void (*put)(int k);         // not timed
    real (*ask)(int k);
    int  most;                  // corners; 0: any
} way;

// Ours first, then those that are asked the same.
static const way ways[] = {
    { "distance, cold", "ours", 1, 0, DISTANCE, 0, put_ours, ask_distance, 0 },
    { "distance, cold", "chapter 04", 1, 0, DISTANCE, 0, put_ours, ask_plain,
      0 },
#ifdef WITH_GJK
    { "distance, cold", "openGJK", 1, 0, DISTANCE, 0.8, put_gjk, ask_gjk, 0 },
#endif
    { "distance, carried", "ours", 1, 1, DISTANCE, 0, put_ours_moved,
      ask_distance, 0 },
    { "distance, carried", "chapter 04", 1, 1, DISTANCE, 0, put_ours_moved,
      ask_plain_carried, 0 },
#ifdef WITH_BOX3D
    { "distance, carried", "Box3D", 1, 1, DISTANCE, 1, put_box3d, ask_box3d,
      32 },
#endif
    { "apart? cold", "ours", 1, 0, SIGN, 0, put_ours, ask_apart, 0 },
#ifdef WITH_JOLT
    { "apart? cold", "Jolt", 1, 0, SIGN, 2, put_jolt, ask_jolt, 0 },
#endif
    { "apart? carried", "ours", 1, 1, SIGN, 0, put_ours_moved, ask_apart, 0 },
#ifdef WITH_JOLT
    { "apart? carried", "Jolt", 1, 1, SIGN, 1.2, put_jolt_moved, ask_jolt, 0 },
#endif
    { "overlapping? cold", "ours", 0, 0, SIGN, 0, put_ours, ask_apart, 0 },
#ifdef WITH_JOLT
    { "overlapping? cold", "Jolt", 0, 0, SIGN, 2, put_jolt, ask_jolt, 0 },
#endif
    { "depth, cold", "ours", 0, 0, DISTANCE, 0, put_ours, ask_depth, 0 },
    { "depth, cold", "chapters 04 and 05", 0, 0, DISTANCE, 0, put_ours,
      ask_plain_depth, 0 },
#ifdef WITH_JOLT
    { "depth, cold", "Jolt", 0, 0, DISTANCE, 1.2, put_jolt, ask_jolt_depth, 0 },
#endif
};
enum { WAYS = sizeof ways / sizeof *ways };

typedef struct {
    real ns[ROUNDS];
    int  wrong;         // by more than TIGHT, or a wrong yes or no
    int  rough;         // by more than ROUGH
} timing;

static timing timings[WAYS];

static void time_way(const way *w, timing *l, int round)
{
    for (int k = 0; k < PAIRS; k++) w->put(k);
    real start = clock_seconds();
    for (int k = 0; k < PAIRS; k++) answer[k] = w->ask(k);
    if (round >= 0)
        l->ns[round] = 1e9 * (clock_seconds() - start) / PAIRS;
}

static void judge_way(const way *w, timing *l)
{
    l->wrong = l->rough = 0;
    for (int k = 0; k < PAIRS; k++) {
        real t = truth[w->is_moved][k], off = fabs(answer[k] - t);
        if (w->kind == SIGN) {
            l->wrong += l->rough += (answer[k] > 0) != (t > 0);
            continue;
        }
        l->wrong += !(off <= TIGHT * fmax(fabs(t), 0.5));
        l->rough += !(off <= ROUGH * fabs(t));
    }
}

// ---- The table -------------------------------------------------------------

static void print_way(const char *name, const way *w, const timing *ours,
                      const timing *l)
{
    real mine[ROUNDS], ns[ROUNDS], ratio[ROUNDS], least = HUGE_VAL, most = 0;
    for (int r = 0; r < ROUNDS; r++) {
        mine[r] = ours->ns[r];
        ns[r] = l->ns[r];
        ratio[r] = ours->ns[r] / l->ns[r];
        least = fmin(least, ratio[r]);
        most = fmax(most, ratio[r]);
    }
    printf("%s,\"%s\",%.0f,%s,%.0f,%.2f,%.2f,%.2f,", name, w->question,
           clock_median(mine, ROUNDS), w->by, clock_median(ns, ROUNDS),
           clock_median(ratio, ROUNDS), least, most);
    if (w->target > 0) printf("%.1f", w->target);
    printf(",%d,%d,%d\n", ours->wrong, l->wrong, l->rough);
    fflush(stdout);
}

static void race_pairs(const char *name, bool are_apart)
{
    for (int r = -1; r < ROUNDS; r++)
        for (int k = 0; k < WAYS; k++) {
            int w = (k + r + 1) % WAYS;
            bool is_here = ways[w].are_apart == are_apart
                && (!ways[w].most || plan.particles <= ways[w].most);
            if (!is_here) continue;
            time_way(&ways[w], &timings[w], r);
            judge_way(&ways[w], &timings[w]);
        }
    int ours = 0;
    for (int w = 0; w < WAYS; w++) {
        if (ways[w].are_apart != are_apart
            || (ways[w].most && plan.particles > ways[w].most)) continue;
        if (strcmp(ways[w].by, "ours") == 0) ours = w;
        else print_way(name, &ways[w], &timings[ours], &timings[w]);
    }
}

static void race_body(const char *only, const char *name, status made)
{
    if (only && strcmp(only, name) != 0) return;
    if (!made.ok) give_up(made.why);
    for (int are_apart = 1; are_apart >= 0; are_apart--) {
        make_pairs(are_apart);
        race_pairs(name, are_apart);
    }
    shape_free(&plan);
}

int main(int argc, char **argv)
{
    const char *only = argc > 1 ? argv[1] : NULL;
    clock_print_head("Questions about convex bodies, to us and to others",
                     FLAGS);
    printf("# a ratio is ours over theirs, round by round: median, least,"
           " largest; wrong: off by more than %g of the distance, or the wrong"
           " yes or no; rough: by more than a hundredth\n", TIGHT);
    printf("bodies,question,ns,beside,its ns,ratio,least,largest,target,wrong,"
           "its wrong,its rough\n");
    race_body(only, "cubes", shape_box(&plan, (vec3){ .577, .577, .577 }, 1));
    race_body(only, "icosahedra", shape_icosahedron(&plan, 0.5, 1));
    race_body(only, "balls of 162", ball_shape(&plan, 2, 0.5, 1));
    race_body(only, "balls of 642", ball_shape(&plan, 3, 0.5, 1));
    return 0;
}
