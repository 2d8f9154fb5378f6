// hard_trees.c - case 23: do sphere trees hold bodies that have moved and are
// strained, and is T = Nv Cv + Np Cp + Nu Cu what the clock shows?

#define _POSIX_C_SOURCE 200809L

#include "bodies.h"
#include "convex.h"
#include "hard.h"
#include "body.h"
#include "random.h"
#include "sphere_tree.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef unsigned long long dice;

// ---- forms -----------------------------------------------------------------

// Points at rest and where they are now, the leaves over them, and the sticks
// or edges whose strain counts.
typedef struct {
    const char *name;
    int  points, leaves, edges, soft;
    vec3 *rest, *at;
    leaf_feature *leaf;
    int  (*edge)[2];
} form;

static void form_free(form *f)
{
    free(f->rest);
    free(f->at);
    free(f->leaf);
    free(f->edge);
}

static int form_room(form *f, const char *name, int points, int leaves,
                     int edges)
{
    *f = (form){ .name = name, .points = points, .leaves = leaves,
                 .edges = edges };
    f->rest = calloc((size_t)points, sizeof *f->rest);
    f->at   = calloc((size_t)points, sizeof *f->at);
    f->leaf = calloc((size_t)leaves, sizeof *f->leaf);
    f->edge = calloc((size_t)edges, sizeof *f->edge);
    if (f->rest && f->at && f->leaf && f->edge) return 1;
    form_free(f);
    return 0;
}

// The triangles of a shape, or the links of a rope, are the leaves.
static int form_of_shape(form *f, const char *name, status made, shape *s)
{
    int rope = s->kind == SHAPE_ROPE;
    if (!made.ok) return 0;
    int good = form_room(f, name, s->particles,
                         rope ? s->sticks : s->mesh.faces, s->sticks);
    for (int i = 0; good && i < s->particles; i++) f->rest[i] = s->at[i];
    for (int i = 0; good && i < s->sticks; i++) {
        f->edge[i][0] = s->stick[i].a;
        f->edge[i][1] = s->stick[i].b;
    }
    for (int i = 0; good && i < f->leaves; i++) {
        const int *v = rope ? f->edge[i] : &s->face[3 * i];
        f->leaf[i] = rope ? (leaf_feature){ 2, { v[0], v[1], 0 } }
                          : (leaf_feature){ 3, { v[0], v[1], v[2] } };
    }
    if (good) f->soft = s->kind != SHAPE_RIGID;
    shape_free(s);
    return good;
}

// The number of the middle of a and b on the unit ball, new or not.
static int middle(vec3 *at, int *count, int a, int b)
{
    vec3 m = vec3_unit(vec3_add(at[a], at[b]));
    for (int i = 0; i < *count; i++)
        if (vec3_distance(at[i], m) < 1e-6) return i;
    at[*count] = m;
    return (*count)++;
}

enum { BALL_FACES = 1280 };

// Each triangle of an icosahedron in four, three times over: 642 points.
static int ball_faces(const shape *round, vec3 *at, int (*face)[3])
{
    static int coarse[BALL_FACES][3];
    int points = round->particles, faces = round->mesh.faces;
    for (int i = 0; i < points; i++) at[i] = vec3_unit(round->at[i]);
    for (int i = 0; i < 3 * faces; i++) face[i / 3][i % 3] = round->face[i];
    for (int level = 0; level < 3; level++) {
        memcpy(coarse, face, sizeof coarse);
        for (int i = faces - 1; i >= 0; i--) {
            const int *v = coarse[i];
            int m[3];
            for (int k = 0; k < 3; k++)
                m[k] = middle(at, &points, v[k], v[(k + 1) % 3]);
            for (int k = 0; k < 3; k++) {
                int *part = face[4 * i + k];
                part[0] = v[k];
                part[1] = m[k];
                part[2] = m[(k + 2) % 3];
            }
            memcpy(face[4 * i + 3], m, sizeof m);
        }
        faces *= 4;
    }
    return points;
}

static int form_ball(form *f)
{
    static vec3 at[642];
    static int face[BALL_FACES][3];
    shape round, s;
    if (!shape_icosahedron(&round, 1, 12).ok) return 0;
    int points = ball_faces(&round, at, face);
    shape_free(&round);
    status made = shape_convex(&s, points, at, BALL_FACES,
                               (const int (*)[3])face, 1);
    return form_of_shape(f, "ball of 642", made, &s);
}

enum { FORMS = 5 };

static int form_make(form *f, int kind)
{
    shape s;
    status made;
    switch (kind) {
    case 0:
        made = shape_box(&s, vec3_make(1, 2, 3), 1);
        return form_of_shape(f, "box", made, &s);
    case 1:
        made = shape_icosahedron(&s, 1, 1);
        return form_of_shape(f, "icosahedron", made, &s);
    case 2: return form_ball(f);
    case 3:
        made = shape_cloth(&s, 20, 20, 2, 2, 1, 0.1);
        return form_of_shape(f, "cloth", made, &s);
    default:
        made = shape_rope(&s, 50, 2, 1);
        return form_of_shape(f, "rope", made, &s);
    }
}

// ---- motion and strain -----------------------------------------------------

// Stretches by up to 1 % along three directions, each the other way or not,
// turns, and moves away by up to a kilometre.
static void stretch_and_move(form *f, dice *d)
{
    vec3 u = random_direction(d), v = random_direction(d);
    v = vec3_unit(vec3_cross(u, v));
    vec3 w = vec3_cross(u, v), away = random_vector(d, 0, 1000);
    vec3 x = random_direction(d), y = random_direction(d);
    y = vec3_unit(vec3_cross(x, y));
    vec3 z = vec3_cross(x, y);
    real by[3];
    for (int k = 0; k < 3; k++) by[k] = 1 + 0.01 * (2 * random_fraction(d) - 1);
    by[(int)(3 * random_fraction(d))] = random_fraction(d) < 0.5 ? 1.01 : 0.99;
    for (int i = 0; i < f->points; i++) {
        vec3 p = f->rest[i], q = away;
        q = vec3_add_scaled(q, by[0] * vec3_dot(u, p), x);
        q = vec3_add_scaled(q, by[1] * vec3_dot(v, p), y);
        f->at[i] = vec3_add_scaled(q, by[2] * vec3_dot(w, p), z);
    }
}

static real worst_strain(const form *f, const vec3 *at)
{
    real worst = 0;
    for (int i = 0; i < f->edges; i++) {
        int a = f->edge[i][0], b = f->edge[i][1];
        real rest = vec3_distance(f->rest[a], f->rest[b]);
        worst = hard_worse(worst, fabs(vec3_distance(at[a], at[b]) / rest - 1));
    }
    return worst;
}

// Moves every particle along its way, as far as strains the worst stick by 1 %.
static void strain_along(form *f, const vec3 *way)
{
    real size = 1e-4;
    for (int k = 0; k < 6; k++) {       // the strain is nearly linear in size
        for (int i = 0; i < f->points; i++)
            f->at[i] = vec3_add_scaled(f->rest[i], size, way[i]);
        if (k < 5) size *= 0.01 / worst_strain(f, f->at);
    }
}

static void jolt(form *f, dice *d)
{
    vec3 way[642];
    for (int i = 0; i < f->points; i++) way[i] = random_vector(d, 0, 1);
    strain_along(f, way);
}

// A cloth or a rope that is crumpled, as no stretch is.
static void crumple(form *f, dice *d)
{
    for (int i = 0; i < f->points; i++) {
        vec3 p = f->rest[i];
        vec3 wave = { sin(3 * p.x), sin(5 * p.x + 4 * p.z), cos(4 * p.z) };
        f->at[i] = vec3_add(vec3_add_scaled(p, 0.3, wave),
                            random_vector(d, 0, 0.02));
    }
}

// ---- what stands outside ---------------------------------------------------

// Visits, and so brings up to date, every node: a ball as large as the world
// meets them all.
static int visit_all(sphere_tree *t, const vec3 *at)
{
    const vec3 zero = { 0, 0, 0 };
    const leaf_feature one = { 1, { 0, 0, 0 } };
    sphere_tree world;
    if (!sphere_tree_build(&world, TREE_LAYERED, &zero, &one, 1, 1e9, 0).ok)
        return 0;
    int met = sphere_tree_pairs(t, at, &world, &zero, 0, NULL, 0).pairs;
    sphere_tree_free(&world);
    return met == t->leaves;
}

// What stands outside the balls above it, but for rounding: of places a
// kilometre away, and of the radius.
typedef struct {
    long vertices;      // -1: not every node was visited
    real furthest;      // in radii of the ball; < 0 where all are inside
} escape;

static void escape_add(escape *e, vec3 p, sphere b)
{
    real grain = 1e-12 * b.radius + 1e-15 * vec3_length(p);
    real from = vec3_distance(p, b.center);
    e->vertices += !(from <= b.radius + grain);
    e->furthest = hard_worse(e->furthest, from / b.radius - 1);
}

static escape escape_of(sphere_tree *t, const form *f)
{
    escape e = { -1, -1 };
    int *parent = malloc((size_t)t->nodes * sizeof *parent);
    sphere_tree_refresh(t, f->at);
    if (!parent || !visit_all(t, f->at)) {
        free(parent);
        return e;
    }
    e.vertices = 0;
    parent[t->nodes - 1] = -1;
    for (int k = t->leaves; k < t->nodes; k++)
        for (int c = 0; c < 2; c++) parent[t->node[k].child[c]] = k;
    for (int i = 0; i < t->leaves; i++)
        for (int j = 0; j < t->leaf[i].count; j++)
            for (int k = i; k >= 0; k = parent[k])
                escape_add(&e, f->at[t->leaf[i].vertex[j]], t->node[k].ball);
    free(parent);
    return e;
}

// The same, but out for it: a particle at a time takes another way, kept if a
// vertex then stands further out.
static void jolt_outwards(form *f, sphere_tree *t, dice *d)
{
    vec3 way[12], best[12];
    real furthest = -1, size = 0.5;
    for (int i = 0; i < f->points; i++) best[i] = random_vector(d, 0, 1);
    for (int tries = 0; tries < 2000; tries++, size *= 0.998) {
        memcpy(way, best, sizeof way);
        int i = (int)(f->points * random_fraction(d));
        way[i] = vec3_add(way[i], random_vector(d, 0, size));
        strain_along(f, way);
        real out = escape_of(t, f).furthest;
        if (out <= furthest) continue;
        furthest = out;
        memcpy(best, way, sizeof way);
    }
    strain_along(f, best);
}

enum { STRETCHED, JOLTED, OUTWARDS, CRUMPLED };

// Of many poses together.
static escape escape_in_poses(form *f, tree_kind kind, int how, real slack,
                              int poses)
{
    dice d = 23;
    sphere_tree t;
    escape all = { -1, -1 };
    if (!sphere_tree_build(&t, kind, f->rest, f->leaf, f->leaves, 0, slack).ok)
        return all;
    all.vertices = 0;
    for (int n = 0; n < poses && all.vertices >= 0; n++) {
        if (how == STRETCHED)     stretch_and_move(f, &d);
        else if (how == JOLTED)   jolt(f, &d);
        else if (how == OUTWARDS) jolt_outwards(f, &t, &d);
        else                      crumple(f, &d);
        escape e = escape_of(&t, f);
        all.furthest = hard_worse(all.furthest, e.furthest);
        all.vertices = e.vertices < 0 ? -1 : all.vertices + e.vertices;
    }
    sphere_tree_free(&t);
    return all;
}

static void add_escape(hard_report *r, form *f, tree_kind kind, int how,
                       real slack, int poses)
{
    static const char *const way[4] = { "1 % stretched", "1 % in a stick",
                                        "1 % outwards", "crumpled" };
    escape e = escape_in_poses(f, kind, how, slack, poses);
    hard_add(r, e.vertices < 0 ? HUGE_VAL : (double)e.vertices, 0, "",
             "outside; %s; %s; %s", f->name,
             kind == TREE_WRAPPED ? "wrapped" : "layered", way[how]);
}

// Wrapped balls of 1 % slack hold what is stretched by 1 % in any direction.  A
// body whose sticks give 1 % may give 4.7 % elsewhere, and so 5 % holds it.
static const real SLACK = 0.05;

static void strain_notes(hard_report *r, form *f, int poses)
{
    escape any = escape_in_poses(f, TREE_WRAPPED, JOLTED, 0.02, poses * 20);
    escape out = escape_in_poses(f, TREE_WRAPPED, OUTWARDS, 0, poses);
    hard_note(r, "%s: sticks off by 1 %% let a vertex out by up to %.1f %% of "
              "a radius; slack 2 %%: %ld out in %d random poses", f->name,
              100 * out.furthest, any.vertices, poses * 20);
}

// Wrapped trees are for rigid bodies: cloth and rope are only stretched.
static void hold_all(hard_report *r, int fast)
{
    for (int kind = 0; kind < FORMS; kind++) {
        form f;
        if (!form_make(&f, kind)) {
            hard_add(r, HUGE_VAL, 0, "", "no memory");
            continue;
        }
        int poses = (fast ? 20000 : 400000) / (f.points + 100);
        int other = f.soft ? CRUMPLED : JOLTED, small = f.points <= 12;
        add_escape(r, &f, TREE_WRAPPED, STRETCHED, 0.01, poses);
        add_escape(r, &f, TREE_LAYERED, STRETCHED, 0, poses);
        add_escape(r, &f, TREE_LAYERED, other, 0, poses);
        if (!f.soft) add_escape(r, &f, TREE_WRAPPED, other, SLACK, poses);
        if (small)
            add_escape(r, &f, TREE_WRAPPED, OUTWARDS, SLACK, fast ? 2 : 40);
        if (small && !fast) strain_notes(r, &f, 40);
        form_free(&f);
    }
}

// ---- the cost model --------------------------------------------------------

enum { RUNS = 32, ROUNDS = 151, ROOM = 1 << 17 };

// One query, asked again and again.
typedef struct {
    vec3 move;                  // m, of the second body
    real margin;                // m
    int  fresh;                 // 1: the trees must follow each time
    double terms[3];            // Nv, Np, Nu
    double seconds[ROUNDS];     // of one query
} run;

// Two bodies with their trees.
typedef struct {
    const char *name;
    form f[2];
    sphere_tree t[2];
} couple;

static leaf_pair found[ROOM];

static double now(void)         // s of processor time
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// Asks for some 20 us, and returns the time of one query.  Not for longer: a
// processor learns the branches of what is asked again and again.  For the same
// reason the trees that are to stand are brought up to date by the mirrored
// query, which takes other branches.
static double time_run(couple *c, run *q, int first)
{
    const vec3 *a = c->f[0].rest, *b = c->f[1].at;
    int times = first ? 1 : (int)fmin(4000, 1 + 2e-5 / q->seconds[0]);
    for (int i = 0; i < c->f[1].points; i++)
        c->f[1].at[i] = vec3_add(c->f[1].rest[i], q->move);
    for (int k = 0; k < 2; k++) sphere_tree_refresh(&c->t[k], k ? b : a);
    if (!q->fresh)
        sphere_tree_pairs(&c->t[1], b, &c->t[0], a, q->margin, found, ROOM);
    double start = now();
    for (int k = 0; k < times; k++) {
        for (int i = 0; i < 2 && q->fresh; i++)
            sphere_tree_refresh(&c->t[i], i ? b : a);
        tree_result r = sphere_tree_pairs(&c->t[0], a, &c->t[1], b, q->margin,
                                          found, ROOM);
        q->terms[0] = r.visited;
        q->terms[1] = r.pairs;
        q->terms[2] = r.updated;
    }
    return (now() - start) / times;
}

static int by_size(const void *x, const void *y)
{
    double a = *(const double *)x, b = *(const double *)y;
    return (a > b) - (a < b);
}

static double median(double *x, int n)
{
    qsort(x, (size_t)n, sizeof *x, by_size);
    return x[n / 2];
}

static int fitted(int n) { return n / 2 % 2 == 0; }

// The three costs: least squares of the relative errors of half of the runs.
static void fit(const run *q, const double *seconds, double cost[3])
{
    double m[3][4] = { { 0 } };
    for (int n = 0; n < RUNS; n++)
        for (int i = 0; i < 3 && fitted(n); i++) {
            double x = q[n].terms[i] / seconds[n];
            for (int j = 0; j < 3; j++)
                m[i][j] += x * q[n].terms[j] / seconds[n];
            m[i][3] += x;
        }
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++) {
            double f = m[i][k] / m[k][k];
            for (int j = 0; i != k && j < 4; j++) m[i][j] -= f * m[k][j];
        }
    for (int k = 0; k < 3; k++) cost[k] = m[k][3] / m[k][k];
}

static double off_model(const run *q, const double cost[3], double seconds)
{
    double model = 0;
    for (int i = 0; i < 3; i++) model += cost[i] * q->terms[i];
    return fabs(model / seconds - 1);
}

// The runs take turns, round after round, no pose after itself, so that whatever
// else the machine does disturbs all alike; the median of each counts.  Fitted to
// one half of the poses, checked on the other.
static void check_model(hard_report *r, couple *c, run *q)
{
    double seconds[RUNS], cost[3], worst = 0, mean = 0;
    for (int round = 0; round < ROUNDS; round++)
        for (int k = 0; k < RUNS; k++) {
            int n = 17 * k % RUNS;
            q[n].seconds[round] = time_run(c, &q[n], round == 0);
        }
    for (int n = 0; n < RUNS; n++) seconds[n] = median(q[n].seconds, ROUNDS);
    fit(q, seconds, cost);
    for (int n = 0; n < RUNS; n++) {
        if (fitted(n)) continue;
        double off = off_model(&q[n], cost, seconds[n]);
        worst = hard_worse(worst, off);
        mean += off / (RUNS / 2);
    }
    hard_add(r, worst, 0.1, "", "cost model against the clock; %s", c->name);
    hard_note(r, "%s: Cv %.1f ns, Cp %.1f ns, Cu %.1f ns from 16 runs; 16 "
              "others: off by %.1f %% in the mean", c->name, 1e9 * cost[0],
              1e9 * cost[1], 1e9 * cost[2], 100 * mean);
}

// Two balls of 1280 triangles, or two cloths of 722, one of them standing.
static int couple_make(couple *c, int cloth)
{
    *c = (couple){ .name = cloth ? "two cloths" : "two balls" };
    for (int k = 0; k < 2; k++) {
        form *f = &c->f[k];
        if (!form_make(f, cloth ? 3 : 2)) return 0;
        for (int i = 0; cloth && k && i < f->points; i++) {
            vec3 p = f->rest[i];
            f->rest[i] = vec3_make(0.8 * p.x - 0.6 * p.z,
                                   0.6 * p.x + 0.8 * p.z, p.y);
        }
        if (!sphere_tree_build(&c->t[k], TREE_WRAPPED, f->rest, f->leaf,
                               f->leaves, 0, 0.02).ok)
            return 0;
    }
    return 1;
}

// From just apart to deep in each other, with margins of 0 to 0.1 m; each pose
// with trees that must follow, and with trees that stand.
static void cost_model(hard_report *r)
{
    for (int cloth = 0; cloth < 2; cloth++) {
        static run q[RUNS];
        couple c;
        if (!couple_make(&c, cloth)) {
            hard_add(r, HUGE_VAL, 0.1, "", "no memory");
            return;
        }
        for (int n = 0; n < RUNS; n++) {
            int pose = n / 2;
            vec3 way = cloth ? vec3_make(0.3, -1 + 0.07 * pose, 0)
                             : vec3_make(1.98 - 0.1 * pose, 0.1, 0.05);
            q[n] = (run){ .move = way, .margin = 0.02 * (pose % 6),
                          .fresh = n % 2 };
        }
        check_model(r, &c, q);
        for (int k = 0; k < 2; k++) {
            form_free(&c.f[k]);
            sphere_tree_free(&c.t[k]);
        }
    }
}

// The clock is not asked in make test, which is to hold on any machine.
static void sphere_trees(hard_report *r, int fast)
{
    hold_all(r, fast);
    if (!fast) cost_model(r);
}

const hard_case hard_trees[] = {
    { 23, "sphere trees", 1, sphere_trees },
    { 0, NULL, 0, NULL }
};
