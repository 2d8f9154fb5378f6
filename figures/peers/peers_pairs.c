// peers_pairs.c - two icosahedra of radius 0.5 m, apart and overlapping: 20,000
// distinct pairs of each, because a loop over few teaches the processor their
// answers.  The slow oracle judges.

#include "peers_others.h"
#include "hard_set.h"
#include "hit_face.h"
#include "oracle.h"
#include "random.h"
#include "peers.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { PAIRS = 20000, BLOCK = 500, BLOCKS = PAIRS / BLOCK, ROUNDS = 15 };

// m, how far they are apart, or have been pushed into each other: even after
// they have moved all are further apart than MARGIN, or overlap.
static const real NEAREST = 0.02, WIDEST = 0.5, MARGIN = 0.005;
static const real LEAST_DEEP = 0.02, DEEPEST = 0.25;

// The sets of points stand ready, as libccd's bodies do.
typedef struct {
    solid a, b;
    hull pa, pb;
} couple;

static couple before[PAIRS], after[PAIRS];      // a slow motion's frames
static simplex found[PAIRS], parted[PAIRS];     // before, without and with a
                                                // margin
static simplex carried[BLOCK];

static hull hull_of(const solid *s)
{
    return (hull){ s->at, CORNERS };
}

// ---- The pairs -------------------------------------------------------------

static solid solid_at(const shape *plan, placement p)
{
    solid s = { .middle = p.position };
    for (int i = 0; i < CORNERS; i++) {
        vec3 v = plan->at[i], at = vec3_add_scaled(p.position, v.x, p.x);
        s.at[i] = vec3_add_scaled(vec3_add_scaled(at, v.y, p.y), v.z, p.z);
    }
    return s;
}

static void move(solid *s, vec3 by)
{
    s->middle = vec3_add(s->middle, by);
    for (int i = 0; i < CORNERS; i++) s->at[i] = vec3_add(s->at[i], by);
}

// By up to half a degree, and up to 2.5 mm: about what a frame brings in a room
// that comes to rest.
static solid moved_on(solid s, unsigned long long *seed)
{
    const real most = 0.5 * 3.14159265358979 / 180;
    real turn = most * random_fraction(seed),
         far = 0.0025 * random_fraction(seed);
    vec3 axis = random_direction(seed),
         by = vec3_scale(far, random_direction(seed));
    real c = cos(turn), k = sin(turn);
    for (int i = 0; i < CORNERS; i++) {
        vec3 r = vec3_sub(s.at[i], s.middle);
        vec3 turned = vec3_add_scaled(vec3_scale(c, r), k,
                                      vec3_cross(axis, r));
        turned = vec3_add_scaled(turned, (1 - c) * vec3_dot(axis, r), axis);
        s.at[i] = vec3_add(s.middle, turned);
    }
    move(&s, by);
    return s;
}

static void make_ready(couple *c)
{
    c->pa = hull_of(&c->a);
    c->pb = hull_of(&c->b);
}

static gjk_result distance(const couple *c, real margin, simplex *from)
{
    return gjk_distance(c->pa, c->pb, margin, from);
}

// Brings b towards a until they are `gap` apart: Newton, because the distance
// falls, convex, along the way.  A negative gap: pushed in by so much along the
// axis on which they were a micrometre apart.
static couple pair_at(const shape *plan, real gap, unsigned long long *seed)
{
    const real wanted = fmax(gap, 1e-6);
    const vec3 origin = { 0, 0, 0 };
    couple c = { .a = solid_at(plan, turned_anyhow(origin, seed)) };
    vec3 course = random_direction(seed);
    c.b = solid_at(plan, turned_anyhow(vec3_scale(2, course), seed));
    make_ready(&c);
    gjk_result r = distance(&c, HUGE_VAL, NULL);
    for (int tries = 0; tries < 60; tries++) {
        if (fabs(r.distance - wanted) < 1e-9) break;
        real slope = -vec3_dot(r.axis, course) / r.distance;
        move(&c.b, vec3_scale((wanted - r.distance) / slope, course));
        r = distance(&c, HUGE_VAL, NULL);
    }
    if (gap < 0) move(&c.b, vec3_scale(-gap / r.distance, r.axis));
    return c;
}

static void make_pairs(real least, real most)
{
    shape plan;
    unsigned long long seed = 4;
    if (!shape_icosahedron(&plan, 0.5, 1).ok) give_up("no icosahedron");
    for (int i = 0; i < PAIRS; i++) {
        real gap = least + (most - least) * (i + random_fraction(&seed))
             / PAIRS;
        before[i] = pair_at(&plan, gap, &seed);
        after[i].a = moved_on(before[i].a, &seed);
        after[i].b = moved_on(before[i].b, &seed);
        make_ready(&before[i]);
        make_ready(&after[i]);
        found[i].count = parted[i].count = 0;
        distance(&before[i], HUGE_VAL, &found[i]);
        distance(&before[i], MARGIN, &parted[i]);
    }
    shape_free(&plan);
}

// ---- Apart -----------------------------------------------------------------

enum { COLD, WARM };
static real told[2][PAIRS];     // our distances
static int overlap[2][PAIRS];   // libccd's answers, by GJK and by MPR
static gjk_status reached[PAIRS];

// In a scene the bodies have just been moved, all their points written anew.  So
// the pairs of a block are copied here before the clock starts, for us and for
// others alike; and a block is no more than a scene of a hundred bodies has.
enum { FEW = 50, FEWS = PAIRS / FEW };
static couple now[FEW];

static void put(const couple *from)
{
    for (int k = 0; k < FEW; k++) {
        now[k] = from[k];
        make_ready(&now[k]);
    }
}

static void put_before(int part)
{
    put(before + part * FEW);
}

static void put_after(int part)
{
    put(after + part * FEW);
    for (int k = 0; k < FEW; k++) carried[k] = found[part * FEW + k];
}

static void put_parted(int part)
{
    put(after + part * FEW);
    for (int k = 0; k < FEW; k++) carried[k] = parted[part * FEW + k];
}

static void distance_cold(int part)
{
    for (int k = 0, i = part * FEW; k < FEW; k++, i++)
        told[COLD][i] = distance(&now[k], HUGE_VAL, NULL).distance;
}

static void distance_carried(int part)
{
    for (int k = 0, i = part * FEW; k < FEW; k++, i++)
        told[WARM][i] = distance(&now[k], HUGE_VAL, &carried[k]).distance;
}

static void margin_carried(int part)
{
    for (int k = 0, i = part * FEW; k < FEW; k++, i++)
        reached[i] = distance(&now[k], MARGIN, &carried[k]).status;
}

static void gjk_says(int part)
{
    for (int k = 0, i = part * FEW; k < FEW; k++, i++)
        overlap[0][i] = ccd_gjk_overlap(&now[k].a, &now[k].b);
}

static void mpr_says(int part)
{
    for (int k = 0, i = part * FEW; k < FEW; k++, i++)
        overlap[1][i] = ccd_mpr_overlap(&now[k].a, &now[k].b);
}

// ---- How wrong -------------------------------------------------------------

typedef struct {
    int  asked, wrong;
    real worst;
} judged;

static void judge(judged *j, real error, real most)
{
    j->asked++;
    j->wrong += !(error <= most);
    if (!(error <= j->worst)) j->worst = error;
}

// The slow oracle takes a millisecond a pair: it is asked about every so
// many, and about all pairs where we and others do not agree.
enum { EVERY = 10 };

// Relative to the distance; beyond TIGHT it is wrong.
static const real TIGHT = 1e-13;

static judged judge_distances(const couple *pair, const real *ours)
{
    judged j = { 0 };
    for (int i = 0; i < PAIRS; i += EVERY) {
        real truth = (real)oracle_distance(hull_of(&pair[i].a),
                                           hull_of(&pair[i].b));
        judge(&j, fabs(ours[i] - truth) / truth, TIGHT);
    }
    return j;
}

static void write_judged(char *to, judged j, const char *unit)
{
    snprintf(to, TEXT, "%d of %d wrong; largest %.2g%s", j.wrong, j.asked,
             j.worst, unit);
}

// A row in ns, without their error.
static row row_of(const char *what, const char *against, real ours, real theirs,
                  real ratio, judged j, const char *unit)
{
    row r = { .what = what, .against = against, .unit = "ns", .ours = ours,
              .theirs = theirs, .ratio = ratio, .is_wrong = j.wrong > 0 };
    write_judged(r.our_error, j, unit);
    return r;
}

enum { CCD_BY_GJK, CCD_BY_MPR };

// They never overlap.
static void write_overlaps(char *to, int which, const char *beside)
{
    int sum = 0;
    for (int i = 0; i < PAIRS; i++) sum += overlap[which][i] != 0;
    snprintf(to, TEXT, "%d of %d wrong%s", sum, (int)PAIRS, beside);
}

static void add_distances(real cold, real warm, real theirs)
{
    row r = row_of("distance of two icosahedra, cold",
                   "ccdGJKIntersect: yes or no", cold, theirs, 1.2,
                   judge_distances(before, told[COLD]), "");
    write_overlaps(r.their_error, CCD_BY_GJK, "; no distance");
    table_add(r);
    table_add(row_of("the same, moved a little, simplex carried", "ours, cold",
                     warm, cold, 0.2, judge_distances(after, told[WARM]), ""));
}

static void add_margin(real ours, real theirs, int which)
{
    row r = { .what = "further apart than 5 mm? moved, axis carried",
              .against = which == CCD_BY_GJK ? "ccdGJKIntersect, cold"
                                             : "ccdMPRIntersect, cold",
              .unit = "ns", .ours = ours, .theirs = theirs,
              .ratio = which == CCD_BY_GJK ? 0.1 : 0 };
    int within = 0;
    for (int i = 0; i < PAIRS; i++) within += reached[i] != GJK_BEYOND;
    r.is_wrong = within > 0;
    snprintf(r.our_error, TEXT, "%d of %d wrong", within, (int)PAIRS);
    write_overlaps(r.their_error, which, "");
    table_add(r);
}

static void measure_apart(void)
{
    enum { DISTANCE, CARRIED, BEYOND, BY_GJK, BY_MPR, COUNT };
    const way ways[COUNT] = { { put_before, distance_cold },
        { put_after, distance_carried }, { put_parted, margin_carried },
        { put_before, gjk_says }, { put_before, mpr_says } };
    real ns[COUNT];
    make_pairs(NEAREST, WIDEST);
    real *time = time_in_turn(ways, COUNT, FEWS, ROUNDS);
    for (int w = 0; w < COUNT; w++)
        ns[w] = 1e9 / PAIRS * time_sum(time, FEWS, w);
    add_distances(ns[DISTANCE], ns[CARRIED], ns[BY_GJK]);
    add_margin(ns[BEYOND], ns[BY_GJK], CCD_BY_GJK);
    add_margin(ns[BEYOND], ns[BY_MPR], CCD_BY_MPR);
    free(time);
}

// ---- Overlapping -----------------------------------------------------------

// An answer: b moved by `depth` along `along` no longer overlaps.
typedef struct {
    real depth;
    vec3 along;
} exit_found;

enum { OURS, CCD_GJK, CCD_MPR, DEPTHS };
static exit_found out[DEPTHS][PAIRS];

// Asked like theirs: do they overlap, and how deep?
static exit_found exit_of(const couple *c)
{
    const exit_found none = { 0, { 0, 0, 0 } };
    gjk_result g = distance(c, 0, NULL);
    if (g.status != GJK_OVERLAP) return none;
    hit_result h = hit_face_find(c->pa, c->pb, &g.last);
    if (h.status != HIT_FOUND) return none;
    return (exit_found){ h.depth, vec3_scale(-1, h.normal) };
}

static void depth_cold(int part)
{
    for (int i = part * BLOCK; i < (part + 1) * BLOCK; i++)
        out[OURS][i] = exit_of(&before[i]);
}

static void depth_gjk(int part)
{
    for (int i = part * BLOCK; i < (part + 1) * BLOCK; i++) {
        exit_found *e = &out[CCD_GJK][i];
        if (!ccd_gjk_depth(&before[i].a, &before[i].b, &e->depth, &e->along))
            *e = (exit_found){ 0, { 0, 0, 0 } };
    }
}

static void depth_mpr(int part)
{
    for (int i = part * BLOCK; i < (part + 1) * BLOCK; i++) {
        exit_found *e = &out[CCD_MPR][i];
        if (!ccd_mpr_depth(&before[i].a, &before[i].b, &e->depth, &e->along))
            *e = (exit_found){ 0, { 0, 0, 0 } };
    }
}

// m, how far an answer is from the truth: in its depth, or because it is not
// the shortest way, or leaves them overlapping.  An answer that says nothing is
// wrong by all of the depth.
static real depth_error(const couple *c, exit_found e, real truth)
{
    if (!(vec3_length(e.along) > 0.5)) return truth;
    real there = (real)oracle_width(hull_of(&c->a), hull_of(&c->b), e.along);
    return fmax(fabs(e.depth - truth), fabs(there - truth));
}

// An answer is wrong if it is off by more than a thousandth of the radius, ten
// times the tolerance that libccd is given.
static const real ROUGH = 0.0005;

// What no answer contradicts is taken for true, but for the sample.
static real true_depth(int i)
{
    hull a = hull_of(&before[i].a), b = hull_of(&before[i].b);
    real ours = out[OURS][i].depth;
    int doubt = i % EVERY == 0;
    for (int k = CCD_GJK; k <= CCD_MPR; k++)
        doubt |= !(depth_error(&before[i], out[k][i], ours) <= ROUGH);
    return doubt ? (real)oracle_depth(a, b) : ours;
}

static void judge_depths(judged j[DEPTHS])
{
    for (int i = 0; i < PAIRS; i++) {
        real truth = true_depth(i);
        for (int k = OURS; k < DEPTHS; k++)
            judge(&j[k], depth_error(&before[i], out[k][i], truth), ROUGH);
    }
}

static void add_cold(const char *what, const char *against, const real *ns,
                     int which, real ratio, const judged *j)
{
    row r = row_of(what, against, ns[OURS], ns[which], ratio, j[OURS], " m");
    write_judged(r.their_error, j[which], " m");
    table_add(r);
}

static void measure_overlapping(void)
{
    const way ways[DEPTHS] = { { NULL, depth_cold }, { NULL, depth_gjk },
                               { NULL, depth_mpr } };
    judged j[DEPTHS] = { { 0 } };
    real ns[DEPTHS];
    make_pairs(-DEEPEST, -LEAST_DEEP);
    real *time = time_in_turn(ways, DEPTHS, BLOCKS, ROUNDS);
    for (int w = 0; w < DEPTHS; w++)
        ns[w] = 1e9 / PAIRS * time_sum(time, BLOCKS, w);
    judge_depths(j);
    add_cold("depth and hit face of two icosahedra, cold", "ccdGJKPenetration",
             ns, CCD_GJK, 0.3, j);
    add_cold("the same (stretch)", "ccdMPRPenetration", ns, CCD_MPR, 1, j);
    free(time);
}

void peers_pairs(void)
{
    measure_apart();
    measure_overlapping();
}
