// hard_queries.c - case 22: the stored pairs, and a million random ones.
//
// An answer is not compared with another program's, but proven, in long double:
// - apart: the witness points are points of both bodies, so the distance is no
//   more than theirs; the axis parts the bodies, so it is no less than the gap
//   along it.
// - overlapping: the simplex of gjk shows the origin in A - B; the plane of the
//   hit face supports A - B, so the depth is no more than its distance.
// That no other plane is nearer is left to the slow oracle, which is asked
// about a share of the pairs.

#include "bodies.h"
#include "hard.h"
#include "hit_face.h"
#include "oracle.h"
#include "random.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#ifndef PAIRS
#define PAIRS "tests/data/pairs.txt"
#endif

typedef unsigned long long dice;
typedef long double wide;

// ---- families of pairs -----------------------------------------------------

static real between(dice *d, real low, real high)
{
    return low + (high - low) * random_fraction(d);
}

// 10 to a power between low and high.
static real power(dice *d, real low, real high)
{
    return exp(log(10) * between(d, low, high));
}

static int pick(dice *d, int n) { return (int)(n * random_fraction(d)); }

static void stretch(body *b, real x, real y, real z)
{
    for (int i = 0; i < b->count; i++)
        b->at[i] = vec3_make(x * b->at[i].x, y * b->at[i].y, z * b->at[i].z);
}

static void copy(body *to, const body *from)
{
    to->count = from->count;
    to->has_ring = 0;
    memcpy(to->at, from->at, (size_t)from->count * sizeof *from->at);
}

static void cube(body *b)
{
    body_box(b, vec3_make(-0.5, -0.5, -0.5), vec3_make(0.5, 0.5, 0.5));
}

// A prism with 3 to 8 sides.
static void prism(body *b, dice *d)
{
    int sides = 3 + pick(d, 6);
    b->count = 2 * sides;
    b->has_ring = 0;
    for (int i = 0; i < b->count; i++) {
        real turn = 6.283185307179586 * (i / 2) / sides;
        b->at[i] = vec3_make(0.6 * cos(turn), 0.6 * sin(turn), i % 2 - 0.5);
    }
}

// Something of size 1 with a volume, turned anyhow.
static void solid(body *b, dice *d)
{
    switch (pick(d, 6)) {
    case 0: cube(b); break;
    case 1: body_icosahedron(b, 0.6); break;
    case 2: body_random(b, 4, d); break;
    case 3: body_random(b, 5 + pick(d, 8), d); break;
    case 4: prism(b, d); break;
    default: cube(b); stretch(b, between(d, 0.3, 1), 1, 1);
    }
    body_turn(b, d);
}

static void two(body *a, body *b, dice *d)
{
    solid(a, d);
    solid(b, d);
    body_move(b, random_vector(d, 0, 1.6));
}

static void cubes(body *a, body *b, dice *d)
{
    cube(a);
    cube(b);
    body_turn(a, d);
    body_turn(b, d);
    body_move(b, random_vector(d, 0, 1.8));
}

// Every other point a mean of the others: inside, or on a face or an edge.
static void interior(body *a, body *b, dice *d)
{
    two(a, b, d);
    int n = a->count;
    for (int i = 0; i < n; i++) {
        vec3 p = a->at[pick(d, n)], q = a->at[pick(d, n)];
        vec3 half = vec3_scale(0.5, vec3_add(p, q));
        a->at[a->count++] = vec3_add(half, vec3_scale(0.3, vec3_sub(
                                         a->at[pick(d, n)], half)));
    }
}

static void doubled(body *a, body *b, dice *d)
{
    two(a, b, d);
    for (int i = 0, n = a->count; i < n; i++) a->at[a->count++] = a->at[i];
    for (int i = 0; i < 3; i++) b->at[b->count++] = b->at[0];
}

static void slivers(body *a, body *b, dice *d)
{
    solid(b, d);
    body_random(a, 4, d);
    stretch(a, 1, 1, power(d, -12, -4));
    body_turn(a, d);
    if (pick(d, 2)) {
        stretch(b, 1, power(d, -12, -4), 1);
        body_turn(b, d);
    }
    body_move(b, random_vector(d, 0, 1.2));
}

static void needles(body *a, body *b, dice *d)
{
    two(a, b, d);
    cube(a);
    stretch(a, 1e-4, 1e-4, 1);
    body_turn(a, d);
    if (pick(d, 2)) {
        copy(b, a);
        body_turn(b, d);
        body_move(b, random_vector(d, 0, 3e-4));
    }
}

static void plates(body *a, body *b, dice *d)
{
    two(a, b, d);
    cube(a);
    stretch(a, 1, 1, 1e-4);
    if (pick(d, 2)) {
        copy(b, a);
        if (pick(d, 2)) body_turn(b, d);
        real side = between(d, -0.5, 0.5), up = power(d, -6, 0);
        body_move(b, vec3_make(side, 0, up));
    }
    body_turn(a, d);
}

// One of size 1e-4 at the other's side.
static void mixed(body *a, body *b, dice *d)
{
    solid(a, d);
    solid(b, d);
    body_scale(b, power(d, -4, -2));
    vec3 p = a->at[pick(d, a->count)], q = a->at[pick(d, a->count)];
    body_move(b, vec3_scale(between(d, 0.45, 0.55), vec3_add(p, q)));
}

static void points(body *a, body *b, dice *d)
{
    two(a, b, d);
    a->count = 1;
    if (pick(d, 4) == 0) b->count = 1;
}

static void segments(body *a, body *b, dice *d)
{
    two(a, b, d);
    a->count = 2;
    if (pick(d, 3) == 0) b->count = 2;
}

static void polygons(body *a, body *b, dice *d)
{
    two(a, b, d);
    a->count = 3 + pick(d, 4);
    for (int i = 0; i < a->count; i++) {
        real x = between(d, -1, 1), y = between(d, -1, 1);
        a->at[i] = vec3_make(x, y, 0);
    }
    if (pick(d, 3) == 0) {
        copy(b, a);
        if (pick(d, 2)) body_turn(b, d);
        body_move(b, vec3_make(between(d, -1, 1), 0, 0));
    } else body_turn(a, d);
}

static void far_away(body *a, body *b, dice *d)
{
    two(a, b, d);
    vec3 off = vec3_scale(power(d, 5, 7), random_direction(d));
    body_move(a, off);
    body_move(b, off);
}

static void sized(body *a, body *b, real by)
{
    body_scale(a, by);
    body_scale(b, by);
}

static void tiny(body *a, body *b, dice *d)
{
    two(a, b, d);
    sized(a, b, 1e-6);
}

static void large(body *a, body *b, dice *d)
{
    two(a, b, d);
    sized(a, b, 1e6);
}

static void vast(body *a, body *b, dice *d)
{
    two(a, b, d);
    sized(a, b, pick(d, 2) ? 1e30 : 1e-30);
}

static void coincident(body *a, body *b, dice *d)
{
    solid(a, d);
    copy(b, a);
    if (pick(d, 2)) body_move(b, random_vector(d, 0, power(d, -16, -2)));
}

static void concentric(body *a, body *b, dice *d)
{
    solid(a, d);
    copy(b, a);
    if (pick(d, 2)) solid(b, d);
    body_scale(b, power(d, -4, 0));
}

// A copy beside itself: every face meets its like.
static void parallel(body *a, body *b, dice *d)
{
    solid(a, d);
    copy(b, a);
    vec3 edge = vec3_sub(a->at[0], a->at[1 + pick(d, 3)]);
    body_move(b, vec3_scale(between(d, 0, 1.6), edge));
}

// Whole numbers below these, drawn one by one: C leaves the order within an
// expression open.
static vec3 whole(dice *d, int n)
{
    int x = pick(d, n), y = pick(d, n), z = pick(d, n);
    return vec3_make(x, y, z);
}

// Boxes with whole corners: they touch exactly, or are apart or overlap by
// whole metres.
static void lattice(body *a, body *b, dice *d)
{
    body *each[2] = { a, b };
    for (int k = 0; k < 2; k++) {
        vec3 low = whole(d, 5), side = whole(d, 3);
        side = vec3_add(side, vec3_make(1, 1, 1));
        body_box(each[k], low, vec3_add(low, side));
    }
}

// Cubes whose sides are whole along crossed directions: edges touch edges.
static void lattice_crossed(body *a, body *b, dice *d)
{
    lattice(a, b, d);
    for (int i = 0; i < 8; i++) {
        vec3 p = b->at[i];
        b->at[i] = vec3_make(p.x - p.z, 2 * p.y, p.x + p.z);
    }
    body_move(b, vec3_sub(whole(d, 5), vec3_make(2, 4, 4)));
}

// Moved until a gap, or a depth, of 1e-15 to 1e-3 is left.
static void near_touch(body *a, body *b, dice *d)
{
    two(a, b, d);
    body_move(b, vec3_scale(2.5, random_direction(d)));
    gjk_result g = gjk_distance(body_hull(a), body_hull(b), HUGE_VAL, NULL);
    if (g.status != GJK_APART) return;
    real gap = power(d, -15, -3) * (pick(d, 2) ? 1 : -1);
    body_move(b, vec3_scale(1 - gap / g.distance, g.axis));
}

static void deep(body *a, body *b, dice *d)
{
    solid(a, d);
    solid(b, d);
    body_move(b, random_vector(d, 0, 0.05));
}

// Edges that cross at 1e-9 to 1e-3 rad.
static void near_parallel(body *a, body *b, dice *d)
{
    cube(a);
    cube(b);
    stretch(b, 1, 0.7, 0.7);
    real turn = power(d, -9, -3), lean = 0.7853981633974483;
    for (int i = 0; i < 8; i++) {
        vec3 p = b->at[i];
        p = vec3_make(p.x, p.y * cos(lean) - p.z * sin(lean),
                      p.y * sin(lean) + p.z * cos(lean));
        b->at[i] = vec3_make(p.x * cos(turn) - p.y * sin(turn),
                             p.x * sin(turn) + p.y * cos(turn), p.z);
    }
    real x = between(d, -0.5, 0.5), y = between(d, 0.9, 1.1);
    body_move(b, vec3_make(x, y, between(d, 0.4, 0.6)));
}

// A box that rests on a box, tilted by 1e-9 to 1e-2 rad.
static void resting(body *a, body *b, dice *d)
{
    cube(a);
    cube(b);
    real turn = power(d, -9, -2), down = power(d, -9, -2);
    for (int i = 0; i < 8; i++) {
        vec3 p = b->at[i];
        b->at[i] = vec3_make(p.x * cos(turn) - p.y * sin(turn),
                             p.x * sin(turn) + p.y * cos(turn), p.z);
    }
    real side = between(d, -0.8, 0.8);
    body_move(b, vec3_make(side, 1 - down, between(d, -0.8, 0.8)));
}

// Balls of 42, now and then of 162 or 642 points.
static void balls(body *a, body *b, dice *d)
{
    static body made[3];
    for (int k = 0; k < 3 && made[k].count == 0; k++)
        body_icosphere(&made[k], k + 1, 0.6);
    int rare = pick(d, 32);
    *a = made[rare == 0 ? 2 : rare < 4 ? 1 : 0];
    *b = made[pick(d, 16) == 0];
    body_turn(a, d);
    body_turn(b, d);
    body_move(b, random_vector(d, 0, 1.6));
}

static const struct {
    const char *name;
    void (*make)(body *a, body *b, dice *d);
} family[] = {
    { "cubes", cubes }, { "solids", two }, { "interior vertices", interior },
    { "doubled vertices", doubled }, { "slivers", slivers },
    { "needles", needles }, { "plates", plates }, { "mixed sizes", mixed },
    { "points", points }, { "segments", segments }, { "polygons", polygons },
    { "far away", far_away }, { "size 1e-6", tiny }, { "size 1e6", large },
    { "size 1e30 and 1e-30", vast }, { "coincident", coincident },
    { "concentric", concentric }, { "parallel faces", parallel },
    { "lattice", lattice }, { "crossed lattice", lattice_crossed },
    { "near touch", near_touch }, { "deep", deep },
    { "near parallel edges", near_parallel }, { "resting", resting },
    { "balls", balls }
};
enum { FAMILIES = (int)(sizeof family / sizeof *family) };

// ---- what an answer must hold ----------------------------------------------

enum { SMALL = 24 };    // points; all families but the balls stay below

typedef struct {
    long pairs, apart, overlapping, touching;
    long bad, not_finite, capped;
    long gjk_most, hit_most;            // iterations
    long asked_distance, asked_depth;   // of the oracle
    long unproven;                      // overlaps that only the status tells
    long large, large_over, large_most; // depths of large bodies, and beyond 64
    const char *first_bad;
} tally;

typedef struct {
    const body *a, *b;
    hull pa, pb;
    real size;              // m, of the larger body's box
    gjk_result g;
    int  share;             // 1: this pair is one that the oracle is asked
} question;

static real largest_side(const body *b)
{
    real side = 0;
    for (int c = 0; c < 3; c++) {
        real low = HUGE_VAL, high = -HUGE_VAL;
        for (int i = 0; i < b->count; i++) {
            vec3 p = b->at[i];
            real x = c == 0 ? p.x : c == 1 ? p.y : p.z;
            low = fmin(low, x);
            high = fmax(high, x);
        }
        side = fmax(side, high - low);
    }
    return side;
}

// The criterion of the stored pairs: 1e-6 of the truth, or, near touch, what
// rounding alone makes: 1e-14 of the size.
static int agrees(wide error, wide truth, real size)
{
    return fabsl(error) <= 1e-6L * fabsl(truth)
        || fabsl(error) <= 1e-14L * (wide)size;
}

// sum weight (a - b), exactly where the simplex says that it is.
static wide simplex_length(const question *q)
{
    const simplex *s = &q->g.last;
    wide x = 0, y = 0, z = 0, sum = 0;
    for (int k = 0; k < s->count; k++) {
        vec3 a = q->a->at[s->of[k].a], b = q->b->at[s->of[k].b];
        wide w = (wide)s->weight[k];
        if (w < 0) return (wide)HUGE_VAL;
        x += w * ((wide)a.x - (wide)b.x);
        y += w * ((wide)a.y - (wide)b.y);
        z += w * ((wide)a.z - (wide)b.z);
        sum += w;
    }
    return sqrtl(x * x + y * y + z * z) / sum;
}

// Six times the volume of the origin and three corners of the simplex.
static wide volume(const question *q, int i, int j, int k)
{
    int three[3] = { i, j, k };
    wide m[3][3];
    for (int r = 0; r < 3; r++) {
        vec3 a = q->a->at[q->g.last.of[three[r]].a];
        vec3 b = q->b->at[q->g.last.of[three[r]].b];
        m[r][0] = (wide)a.x - (wide)b.x;
        m[r][1] = (wide)a.y - (wide)b.y;
        m[r][2] = (wide)a.z - (wide)b.z;
    }
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
         + m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2])
         + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// The origin is in A - B, or as near as rounding: in the simplex, by the signs
// of four volumes, or at the point of it that its weights name.
static int overlap_proven(const question *q)
{
    if (simplex_length(q) <= 1e-14L * (wide)q->size) return 1;
    if (q->g.last.count < 4) return 0;
    wide v[4] = { volume(q, 1, 2, 3), -volume(q, 0, 2, 3), volume(q, 0, 1, 3),
                  -volume(q, 0, 1, 2) };
    return (v[0] >= 0 && v[1] >= 0 && v[2] >= 0 && v[3] >= 0)
        || (v[0] <= 0 && v[1] <= 0 && v[2] <= 0 && v[3] <= 0);
}

static wide gap_along(const question *q, vec3 axis)
{
    return -oracle_width(q->pa, q->pb, vec3_scale(-1, axis));
}

// Proven if both bounds meet; else the oracle decides.
static int apart_holds(const question *q, tally *t)
{
    wide most = simplex_length(q), least = gap_along(q, q->g.axis);
    wide said = (wide)q->g.distance;
    t->apart++;
    int small = q->a->count * q->b->count <= 200;
    if (!agrees(most - least, most, q->size) || (q->share && small)) {
        if (!small) return 0;
        t->asked_distance++;
        most = least = oracle_distance(q->pa, q->pb);
    }
    return agrees(said - most, most, q->size)
        && agrees(said - least, most, q->size);
}

// How many directions the oracle's depth tries, times the points it reads.
static long oracle_work(const question *q)
{
    long a = q->a->count, b = q->b->count;
    long faces = a * (a - 1) * (a - 2) / 6 + b * (b - 1) * (b - 2) / 6;
    return (faces + a * (a - 1) * b * (b - 1) / 4) * (a + b);
}

// The hit face's plane supports A - B, the points lie on both bodies, and the
// oracle, where it is asked, finds no direction that is shorter.
static int depth_holds(const question *q, const hit_result *h, tally *t)
{
    vec3 out = vec3_scale(-1, h->normal);
    wide said = (wide)h->depth, plane = oracle_width(q->pa, q->pb, out);
    t->overlapping++;
    if (fabs(vec3_length(h->normal) - 1) > 1e-12) return 0;
    if (!agrees(said - plane, plane, q->size)) return 0;
    int inside = overlap_proven(q);
    long work = oracle_work(q), most = q->share ? 400000 : inside ? 0 : 20000;
    if (work > most) {
        t->unproven += !inside;
        return 1;
    }
    t->asked_depth++;
    wide least = oracle_depth(q->pa, q->pb);
    return said <= least || agrees(said - least, least, q->size);
}

// A - B lies within rounding of a plane through the origin.
static int flat_holds(const question *q, const hit_result *h, tally *t)
{
    vec3 back = vec3_scale(-1, h->normal);
    wide up = oracle_width(q->pa, q->pb, h->normal);
    wide down = oracle_width(q->pa, q->pb, back);
    t->touching++;
    return h->depth == 0 && agrees(up, 0, q->size) && agrees(down, 0, q->size);
}

static int overlap_holds(const question *q, tally *t)
{
    hit_result h = hit_face_find(q->pa, q->pb, &q->g.last);
    if (q->a->count > SMALL || q->b->count > SMALL) {
        t->large++;
        t->large_over += h.iterations > 64;
        if (h.iterations > t->large_most) t->large_most = h.iterations;
    } else if (h.iterations > t->hit_most) t->hit_most = h.iterations;
    t->not_finite += !(h.depth - h.depth == 0) || !vec3_is_finite(h.normal)
                  || !vec3_is_finite(h.on_a) || !vec3_is_finite(h.on_b);
    switch (h.status) {
    case HIT_FOUND: return depth_holds(q, &h, t);
    case HIT_FLAT:  return flat_holds(q, &h, t);
    case HIT_CAPPED: t->capped++; return 0;
    default: return 0;
    }
}

static void judge(const body *a, const body *b, int share, const char *name,
                  tally *t)
{
    question q = { a, b, body_hull(a), body_hull(b), 0,
                   { .iterations = 0 }, share };
    q.size = fmax(largest_side(a), largest_side(b));
    q.g = gjk_distance(q.pa, q.pb, HUGE_VAL, NULL);
    t->pairs++;
    if (q.g.iterations > t->gjk_most) t->gjk_most = q.g.iterations;
    t->not_finite += !(q.g.distance - q.g.distance == 0)
                  || !vec3_is_finite(q.g.axis);
    t->capped += q.g.status == GJK_CAPPED;
    int holds = q.g.status == GJK_APART ? apart_holds(&q, t)
              : q.g.status == GJK_OVERLAP ? overlap_holds(&q, t) : 0;
    if (holds) return;
    if (t->bad++ == 0) t->first_bad = name;
}

// ---- 22 --------------------------------------------------------------------

// The stored pairs: the sign, and the number, as the criterion says.
static int stored_holds(const pair_known *p)
{
    hull a = body_hull(&p->a), b = body_hull(&p->b);
    gjk_result g = gjk_distance(a, b, HUGE_VAL, NULL);
    real size = fmax(largest_side(&p->a), largest_side(&p->b));
    real truth = p->kind == 'S' ? p->value : -p->value, said = g.distance;
    if (g.status == GJK_OVERLAP)
        said = -hit_face_find(a, b, &g.last).depth;
    else if (g.status != GJK_APART) return 0;
    if (fabs(truth) > 1e-12 * size && (said > 0) != (truth > 0)) return 0;
    return agrees((wide)said - (wide)truth, (wide)truth, size);
}

static void stored_pairs(hard_report *r)
{
    static pair_known p;
    FILE *file = fopen(PAIRS, "r");
    int read = -1, pairs = 0, bad = 0;
    while (file && (read = pair_read(file, &p)) == 1) {
        pairs++;
        bad += !stored_holds(&p);
    }
    if (file) fclose(file);
    hard_add(r, read == 0 ? bad : HUGE_VAL, 0, "", "BAD of %d stored pairs",
             pairs);
}

static void random_pairs(tally *t, long pairs, int every)
{
    static body a, b;
    for (long n = 0; n < pairs; n++) {
        // Each pair has numbers of its own: any of them can be made alone.
        dice d = (dice)n * 2862933555777941757ULL + 3037000493ULL;
        int kind = (int)(n % FAMILIES);
        for (int k = 0; k < 3; k++) random_fraction(&d);
        a.has_ring = b.has_ring = 0;
        family[kind].make(&a, &b, &d);
        judge(&a, &b, n / FAMILIES % every == 0, family[kind].name, t);
    }
}

static void report_pairs(hard_report *r, const tally *t)
{
    hard_add(r, (double)t->bad, 0, "", "BAD of %ld random pairs", t->pairs);
    hard_add(r, (double)t->not_finite, 0, "", "NaN or infinite");
    hard_add(r, (double)t->capped, 0, "", "ran into a cap");
    hard_add(r, (double)t->gjk_most, 64, "", "iterations of a distance");
    hard_add(r, (double)t->hit_most, 64, "",
             "iterations of a depth; up to %d points", SMALL);
    hard_note(r, "%ld apart: proven by witness points and axis, but %ld by the "
              "slow oracle", t->apart, t->asked_distance);
    hard_note(r, "%ld overlap: the plane is proven to support A - B; that none "
              "is nearer, by the slow oracle, for %ld", t->overlapping,
              t->asked_depth);
    hard_note(r, "%ld touch within rounding; %ld overlaps rest on the status",
              t->touching, t->unproven);
    hard_note(r, "balls of 42 to 642 points take up to %ld iterations, more "
              "than 64 in %ld of %ld depths", t->large_most, t->large_over,
              t->large);
    if (t->bad) hard_note(r, "the first bad one: %s", t->first_bad);
}

static void pairs_of_bodies(hard_report *r, int fast)
{
    tally t = { .pairs = 0 };
    stored_pairs(r);
    random_pairs(&t, fast ? 20000 : 1000000, fast ? 20 : 5);
    report_pairs(r, &t);
}

const hard_case hard_queries[] = {
    { 22, "pairs of bodies", 1, pairs_of_bodies },
    { 0, NULL, 0, NULL }
};
