// 21-sphere_tree.c - what the leaves of a cloth should hold, and which tree a
// body should have.
//
// A cloth of 40 x 40 particles lies askew in three layers, a fifth of a mesh
// width h apart.  Which of its triangles are nearer than 0.3 h, but were far
// from each other at rest?  Leaves are particles as balls, or triangles.
// index 0, 1: radius or thickness (h), us of refit and traversal, share of
//             those pairs that is missed, share of what is listed that is none
//
// Two balls of 1,280 triangles are pressed into each other, and their corners
// shaken until the worst edge is strained.  Which triangles cross?
// index 2, 3: strain, us of a refresh and a traversal, crossing pairs missed

#include "ball.h"
#include "clock.h"
#include "gjk.h"
#include "random.h"
#include "sphere_tree.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { SIDE = 40, PARTICLES = SIDE * SIDE, FACES = 2 * (SIDE - 1) * (SIDE - 1),
       ROOM = 1 << 20, ROUNDS = 9, RADII = 8, STRAINS = 7 };
static leaf_pair found[ROOM];
static char near[FACES][FACES];         // 1: near, 2: and listed

static void must(int good)
{
    if (good) return;
    fprintf(stderr, "21-sphere_tree: no memory, or no room\n");
    exit(1);
}

static unsigned long long seed = 1;

static real faces_apart(const int *f, const vec3 *at_f, const int *g,
                        const vec3 *at_g)
{
    vec3 x[3], y[3];
    for (int i = 0; i < 3; i++) {
        x[i] = at_f[f[i]];
        y[i] = at_g[g[i]];
    }
    hull a = { x, 3 }, b = { y, 3 };
    return gjk_distance(a, b, HUGE_VAL, NULL).distance;
}

static void face_leaves(const shape *s, leaf_feature *leaf)
{
    for (int f = 0; f < s->mesh.faces; f++) {
        const int *v = &s->face[3 * f];
        leaf[f] = (leaf_feature){ 3, { v[0], v[1], v[2] } };
    }
}

// ---- a folded cloth --------------------------------------------------------

static const real THICKNESS[2][RADII] = {
    { 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.85, 1 },          // balls
    { 0, 0.02, 0.04, 0.06, 0.08, 0.1, 0.125, 0.15 }     // around triangles
};
static const real NEAR = 0.3;

typedef struct {
    shape plan;
    vec3 at[PARTICLES];
    real h;
    sphere_tree tree[2 * RADII];
    tree_result result;
} cloth;

// Turned by 20 degrees, so that no particle lies above another, and folded in
// three, gap (m) apart.
static vec3 folded(real x, real z, real gap)
{
    real r = gap / 2, arc = acos(-1.0) * r, flat = (2 - 2 * arc) / 3;
    real s = 0.94 * x - 0.34 * z + 1, across = 0.34 * x + 0.94 * z;
    if (s < flat) return vec3_make(s, 0, across);
    if ((s -= flat) < arc)
        return vec3_make(flat + r * sin(s / r), r - r * cos(s / r), across);
    if ((s -= arc) < flat) return vec3_make(flat - s, gap, across);
    if ((s -= flat) < arc)
        return vec3_make(-r * sin(s / r), gap + r - r * cos(s / r), across);
    return vec3_make(s - arc, 2 * gap, across);
}

// Neighbours at rest are left out up to 1.54 h, as in chapter 9.
static real apart_of(int way)
{
    real r = THICKNESS[way / RADII][way % RADII];
    return way / RADII ? 1 + 1e-9 : fmax(1 + 1e-9, 0.77 / r);
}

static void cloth_make(cloth *c)
{
    static leaf_feature leaf[FACES];
    must(shape_cloth(&c->plan, SIDE, SIDE, 2, 2, 1, 1).ok);
    c->h = 2.0 / (SIDE - 1);
    for (int way = 0; way < 2 * RADII; way++) {
        int triangles = way / RADII;
        if (triangles) face_leaves(&c->plan, leaf);
        for (int i = 0; i < PARTICLES && !triangles; i++)
            leaf[i] = (leaf_feature){ 1, { i, 0, 0 } };
        must(sphere_tree_build(&c->tree[way], TREE_LAYERED, c->plan.at, leaf,
                               triangles ? FACES : PARTICLES,
                               THICKNESS[triangles][way % RADII] * c->h,
                               0).ok);
    }
    for (int i = 0; i < PARTICLES; i++)
        c->at[i] = folded(c->plan.at[i].x, c->plan.at[i].z, 0.2 * c->h);
}

static int share_a_vertex(const int *f, const int *g)
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            if (f[i] == g[j]) return 1;
    return 0;
}

// Pairs of triangles that are near now and were not at rest, all tried.
static long find_near(const cloth *c)
{
    long count = 0;
    memset(near, 0, sizeof near);
    for (int f = 0; f < FACES; f++)
        for (int g = f + 1; g < FACES; g++) {
            const int *u = &c->plan.face[3 * f], *v = &c->plan.face[3 * g];
            real at_most = NEAR * c->h + 3 * c->h;
            if (vec3_distance(c->at[u[0]], c->at[v[0]]) > at_most) continue;
            if (share_a_vertex(u, v)) continue;
            if (faces_apart(u, c->plan.at, v, c->plan.at) < 1.54 * c->h
                || faces_apart(u, c->at, v, c->at) >= NEAR * c->h) continue;
            near[f][g] = near[g][f] = 1;
            count++;
        }
    return count;
}

static void work_cloth(int way, void *with)
{
    cloth *c = with;
    sphere_tree_refresh(&c->tree[way], c->at);
    c->result = sphere_tree_self(&c->tree[way], c->at, 0, apart_of(way), found,
                                 ROOM);
}

static int mark(int f, int g)
{
    if (!near[f][g]) return 0;
    near[f][g] = near[g][f] = 2;
    return 1;
}

// A pair of particles stands for the triangles around them.
static int mark_around(const cloth *c, int u, int v)
{
    const mesh *m = &c->plan.mesh;
    int good = 0, h = m->vertex_half[u];
    do {
        int k = m->vertex_half[v];
        do {
            if (m->half[h].face >= 0 && m->half[k].face >= 0)
                good |= mark(m->half[h].face, m->half[k].face);
            k = mesh_around(m, k);
        } while (k != m->vertex_half[v]);
        h = mesh_around(m, h);
    } while (h != m->vertex_half[u]);
    return good;
}

static void judge(cloth *c, int way, long all, real *missed, real *none)
{
    long useless = 0, listed = 0;
    work_cloth(way, c);
    must(c->result.pairs <= ROOM);
    for (int i = 0; i < c->result.pairs; i++)
        useless += way / RADII ? !mark(found[i].a, found[i].b)
                               : !mark_around(c, found[i].a, found[i].b);
    for (int f = 0; f < FACES; f++)
        for (int g = f + 1; g < FACES; g++) {
            listed += near[f][g] == 2;
            if (near[f][g]) near[f][g] = near[g][f] = 1;
        }
    *missed = 1 - (real)listed / (real)all;
    *none = (real)useless / fmax(1, c->result.pairs);
}

static void print_leaves(cloth *c)
{
    lap l[2 * RADII];
    real seconds[2 * RADII], missed[2 * RADII], none[2 * RADII];
    long all = find_near(c);
    clock_race((race){ 2 * RADII, ROUNDS, 2e-3, work_cloth, c }, l);
    for (int way = 0; way < 2 * RADII; way++) {
        judge(c, way, all, &missed[way], &none[way]);
        seconds[way] = l[way].seconds;
    }
    printf("# %ld pairs of triangles are near\n", all);
    for (int way = 0; way < 2 * RADII; way++) {
        if (way % RADII == 0)
            printf("%s# leaves: %s\n# size us missed none\n",
                   way ? "\n\n" : "", way ? "triangles" : "particles");
        printf("%g %.2f %.4f %.4f\n", THICKNESS[way / RADII][way % RADII],
               1e6 * seconds[way], missed[way], none[way]);
    }
    clock_print_row("sphere_tree", "leaves of a cloth", "1 % missed",
                    "particles", "triangles",
                    clock_at_error(seconds + RADII, missed + RADII, RADII, 0.01)
                    / clock_at_error(seconds, missed, RADII, 0.01));
}

// ---- two strained balls ----------------------------------------------------

static const real STRAIN[STRAINS] = { 0, 1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3 };

typedef struct {
    shape plan;
    vec3 at[STRAINS][2][BALL_CORNERS];
    sphere_tree tree[2 * STRAINS][2];
    long crossing[STRAINS], missed[2 * STRAINS];
} balls;

// Moves every corner at random until the worst edge is strained so much.
static void shake(const shape *s, real strain, vec3 *at)
{
    vec3 move[BALL_CORNERS];
    real size = 0.01 * strain;
    for (int i = 0; i < s->particles; i++) {
        real x = random_real(&seed), y = random_real(&seed);
        move[i] = vec3_make(x, y, random_real(&seed));
    }
    for (int k = 0; k < 8; k++) {
        real worst = 0;
        for (int i = 0; i < s->particles; i++)
            at[i] = vec3_add_scaled(s->at[i], size, move[i]);
        for (int e = 0; e < s->mesh.edges; e++) {
            int a = s->mesh.half[2 * e].origin;
            int b = s->mesh.half[2 * e + 1].origin;
            real rest = vec3_distance(s->at[a], s->at[b]);
            worst = fmax(worst, fabs(vec3_distance(at[a], at[b]) / rest - 1));
        }
        if (worst > 0) size *= strain / worst;
    }
}

// Wrapped trees get twice the strain as slack (chapter 6); layered ones none.
static void balls_make(balls *b)
{
    static leaf_feature leaf[2 * BALL_CORNERS];
    must(ball_shape(&b->plan, BALL_LEVELS - 1, 0.5, 1).ok);
    face_leaves(&b->plan, leaf);
    for (int k = 0; k < STRAINS; k++)
        for (int side = 0; side < 2; side++) {
            vec3 *at = b->at[k][side];
            for (int kind = 0; kind < 2; kind++)
                must(sphere_tree_build(&b->tree[2 * k + kind][side],
                                       kind ? TREE_LAYERED : TREE_WRAPPED,
                                       b->plan.at, leaf, b->plan.mesh.faces, 0,
                                       kind ? 0 : 2 * STRAIN[k]).ok);
            shake(&b->plan, STRAIN[k], at);
            for (int i = 0; i < b->plan.particles && side; i++)
                at[i] = vec3_add(at[i], vec3_make(0.55, 0.62, 0.35));
        }
}

// Even ways are wrapped, odd ones layered.
static tree_result ask(balls *b, int way)
{
    for (int side = 0; side < 2; side++)
        sphere_tree_refresh(&b->tree[way][side], b->at[way / 2][side]);
    return sphere_tree_pairs(&b->tree[way][0], b->at[way / 2][0],
                             &b->tree[way][1], b->at[way / 2][1], 0, found,
                             ROOM);
}

static void work_balls(int way, void *with)
{
    ask(with, way);
}

// Triangles of the two that cross: all tried, and those of a list.
static long count_crossing(const balls *b, int k, int pairs)
{
    const int *face = b->plan.face;
    long n = 0;
    int faces = b->plan.mesh.faces, all = pairs < 0;
    for (int i = 0; i < (all ? faces * faces : pairs); i++) {
        int f = all ? i / faces : found[i].a, g = all ? i % faces : found[i].b;
        const vec3 *x = b->at[k][0], *y = b->at[k][1];
        // Half a radius: more than any triangle's reach.
        if (vec3_distance(x[face[3 * f]], y[face[3 * g]]) > 0.25) continue;
        n += !(faces_apart(&face[3 * f], x, &face[3 * g], y) > 0);
    }
    return n;
}

static void print_trees(balls *b)
{
    lap l[2 * STRAINS];
    clock_race((race){ 2 * STRAINS, ROUNDS, 2e-3, work_balls, b }, l);
    for (int k = 0; k < STRAINS; k++) {
        b->crossing[k] = count_crossing(b, k, -1);
        for (int way = 2 * k; way < 2 * k + 2; way++)
            b->missed[way] = b->crossing[k]
                           - count_crossing(b, k, ask(b, way).pairs);
    }
    for (int kind = 0; kind < 2; kind++) {
        printf("\n\n# %s\n# strain us missed of\n",
               kind ? "layered" : "wrapped, slack of twice the strain");
        for (int k = 0; k < STRAINS; k++)
            printf("%g %.3f %ld %ld\n", STRAIN[k],
                   1e6 * l[2 * k + kind].seconds, b->missed[2 * k + kind],
                   b->crossing[k]);
    }
    clock_print_row("sphere_tree", "balls of 1280 triangles", "strain 0.1 %",
                    "wrapped", "layered", l[3].seconds / l[2].seconds);
    clock_print_row("sphere_tree", "balls of 1280 triangles", "strain 30 %",
                    "wrapped", "layered", l[2 * STRAINS - 1].seconds
                                        / l[2 * STRAINS - 2].seconds);
}

int main(void)
{
    static cloth c;
    static balls b;
    clock_print_head("21-sphere_tree: time, what is missed, what is listed in "
                     "vain", FLAGS);
    cloth_make(&c);
    print_leaves(&c);
    balls_make(&b);
    print_trees(&b);
    for (int way = 0; way < 2 * RADII; way++) sphere_tree_free(&c.tree[way]);
    for (int way = 0; way < 2 * STRAINS; way++)
        for (int side = 0; side < 2; side++)
            sphere_tree_free(&b.tree[way][side]);
    shape_free(&c.plan);
    shape_free(&b.plan);
    return 0;
}
