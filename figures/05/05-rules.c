// 05-rules.c - hit_face as it stands, and without one of its rules at a time:
// how many answers are wrong?
//
// build/figures/05-rules [pairs.txt]
//
// The changed modules are made of lib/paper/hit_face.c and 05-rules.edits when
// this program is built.  Asked are all stored pairs that touch or overlap (or
// those of another file of the same form), and pairs made for the purpose; the
// slow oracle knows their depth.  Columns: what is changed; of the stored
// pairs, depths wrong by more than a millionth (and by more than 1e-14 of the
// size), and those of them that are called touching; the same of the made
// pairs; and right depths whose normal or points are off by more than 1e-9 of
// the size.

#include "bodies.h"
#include "hit_face.h"
#include "oracle.h"
#include "random.h"

#include <stdio.h>

enum { VARIANTS = 10, MADE = 9600 };

typedef hit_result find(hull a, hull b, const simplex *start);

find hit_face_find_1, hit_face_find_2, hit_face_find_3, hit_face_find_4,
     hit_face_find_5, hit_face_find_6, hit_face_find_7, hit_face_find_8,
     hit_face_find_9;

static const struct {
    const char *name;
    find *ask;
} variant[VARIANTS] = {
    { "nothing", hit_face_find },
    { "stop within 1e-6 m", hit_face_find_1 },
    { "stop within 1e-6 of the size", hit_face_find_2 },
    { "height of the plane at a corner", hit_face_find_3 },
    { "height of the plane at v", hit_face_find_4 },
    { "faces may turn inside out", hit_face_find_5 },
    { "inside out and seen by rounding", hit_face_find_6 },
    { "any of the faces equally close", hit_face_find_7 },
    { "normals by the cross product alone", hit_face_find_8 },
    { "weights as they come", hit_face_find_9 }
};

typedef struct {
    int pairs, wrong, touching, off;
} tally;

static tally stored[VARIANTS], made[VARIANTS];

// Is the move along the normal long enough, and from point to point?
static int is_off(const body *a, const body *b, hit_result r, real size)
{
    vec3 gap = vec3_sub(r.on_b, r.on_a);
    vec3 out = vec3_scale(-1, r.normal);
    real far = 1e-15 * vec3_length(a->at[0]);
    real width = (real)oracle_width(body_hull(a), body_hull(b), out);
    return !(fabs(width - r.depth) <= 1e-9 * size + far
             && vec3_distance(gap, vec3_scale(r.depth, r.normal))
                <= 1e-9 * size + far);
}

static void ask_all(const body *a, const body *b, real truth, tally *t)
{
    gjk_result g = gjk_distance(body_hull(a), body_hull(b), HUGE_VAL, NULL);
    if (g.status != GJK_OVERLAP) return;
    real size = pair_size(a, b);
    for (int k = 0; k < VARIANTS; k++, t++) {
        hit_result r = variant[k].ask(body_hull(a), body_hull(b), &g.last);
        real error = fabs(r.depth - truth);
        int wrong = !(error <= 1e-6 * truth || error <= 1e-14 * size);
        t->pairs++;
        t->wrong += wrong;
        t->touching += wrong && !(r.depth > 1e-12 * size);
        if (!wrong && r.status == HIT_FOUND) t->off += is_off(a, b, r, size);
    }
}

static void ask_stored(const char *path)
{
    static pair_known p;
    FILE *file = fopen(path, "r");
    while (file && pair_read(file, &p) == 1)
        if (p.kind != 'S') ask_all(&p.a, &p.b, p.value, stored);
    if (file) fclose(file);
}

static real halved(real x, int times)
{
    for (int k = 0; k < times; k++) x /= 2;
    return x;
}

// A turn of b about its middle by a small angle (rad).
static void tilt(body *b, real angle, unsigned long long *seed)
{
    vec3 axis = random_direction(seed);
    for (int i = 0; i < b->count; i++)
        b->at[i] = vec3_add_scaled(b->at[i], angle, vec3_cross(axis, b->at[i]));
}

static int below(int most, unsigned long long *seed)
{
    return (int)(most * random_fraction(seed));
}

// A box whose corners are whole numbers.
static void make_box(body *b, unsigned long long *seed)
{
    vec3 low, size;
    low.x = below(5, seed), size.x = 1 + below(3, seed);
    low.y = below(5, seed), size.y = 1 + below(3, seed);
    low.z = below(5, seed), size.z = 1 + below(3, seed);
    body_box(b, low, vec3_add(low, size));
}

// Two square prisms, an edge of the one over an edge of the other at a small
// angle (rad), and deep in it (m); all of it turned.
static void make_roofs(body *a, body *b, real angle, real deep,
                       unsigned long long *seed)
{
    body_box(a, (vec3){ -0.5, -0.5, -0.5 }, (vec3){ 0.5, 0.5, 0.5 });
    *b = *a;
    for (int i = 0; i < 8; i++) {
        vec3 p = b->at[i];
        real x = 2 * p.y, y = (p.x - p.z) / 2, z = (p.x + p.z) / 2;
        a->at[i] = (vec3){ x - angle * y, y + angle * x, z + 1 - deep };
        b->at[i] = (vec3){ x, y, z };
    }
    body_move(b, (vec3){ random_fraction(seed) - 0.5, 0, 0 });
    unsigned long long same = *seed;
    body_turn(a, &same);
    body_turn(b, seed);
}

// Six kinds of pairs: 0 a body and its copy, turned and moved by anything from
// a little to nearly nothing; 1 the same in one place; 2 needles and plates; 3
// bodies pushed in by a hair from where they touch; 4 boxes of whole numbers; 5
// edges that are nearly parallel.
static void make_pair(int n, body *a, body *b, unsigned long long *seed)
{
    int kind = n % 6;
    int i = below(50, seed), j = below(50, seed);
    body_any(a, n / 6 % 3, seed);
    body_any(b, n / 18 % 3, seed);
    if (kind < 2) *b = *a;
    if (kind == 0) tilt(b, halved(1, i), seed);
    if (kind == 0) body_move(b, random_vector(seed, 0, halved(0.5, j)));
    for (int k = 0; kind == 2 && k < a->count; k++) {
        a->at[k].x = halved(a->at[k].x, i / 2);
        a->at[k].y = halved(a->at[k].y, j / 2);
    }
    if (kind == 2) body_move(b, random_vector(seed, 0, 0.5));
    if (kind == 3) {
        body_move(b, (vec3){ 2, 0.1, 0.2 });
        gjk_result g = gjk_distance(body_hull(a), body_hull(b), HUGE_VAL, NULL);
        body_move(b, vec3_scale(1 + halved(1, i), g.axis));
    }
    if (kind == 4) make_box(a, seed), make_box(b, seed);
    if (kind == 5) make_roofs(a, b, halved(0.1, i), halved(0.1, j), seed);
}

static void ask_made(void)
{
    static body a, b;
    unsigned long long seed = 5;
    for (int n = 0; n < MADE; n++) {
        make_pair(n, &a, &b, &seed);
        if (a.count * b.count > 100) continue;      // the oracle is slow
        real truth = (real)oracle_depth(body_hull(&a), body_hull(&b));
        if (truth >= 0) ask_all(&a, &b, truth, made);
    }
}

int main(int count, char **argument)
{
    ask_stored(count > 1 ? argument[1] : "tests/data/pairs-all.txt");
    ask_made();
    printf("without the rule,wrong of %d stored pairs,called touching,"
           "wrong of %d made pairs,called touching,normal or points off\n",
           stored[0].pairs, made[0].pairs);
    for (int k = 0; k < VARIANTS; k++)
        printf("%s,%d,%d,%d,%d,%d\n", variant[k].name, stored[k].wrong,
               stored[k].touching, made[k].wrong, made[k].touching,
               stored[k].off + made[k].off);
    return 0;
}
