// 04-rules.c - GJK as it stands, and without one of its rules at a time: how many
// answers are wrong?
//
// build/figures/04-rules [pairs.txt]
//
// The changed modules are made of lib/paper/gjk.c and 04-rules.edits when this
// program is built.  Asked are the stored pairs with exact answers (or those of
// another file of the same form), and pairs made for the purpose, whose answers
// are known because of how they are made, or by the slow oracle.  Columns: what is changed; of the
// stored pairs, answers that are wrong (a distance by more than a millionth and
// by more than 1e-14 of the size, or apart for overlap, or the reverse), and
// those of them whose status is wrong; the same of the made pairs.

#include "bodies.h"
#include "gjk.h"
#include "oracle.h"
#include "random.h"

#include <stdio.h>

enum { VARIANTS = 13, MADE = 20000 };

typedef gjk_result find(hull a, hull b, real margin, simplex *carried);

find gjk_distance_1, gjk_distance_2, gjk_distance_3, gjk_distance_4,
     gjk_distance_5, gjk_distance_6, gjk_distance_7, gjk_distance_8,
     gjk_distance_9, gjk_distance_10,
     gjk_distance_11, gjk_distance_12;

static const struct {
    const char *name;
    find *ask;
} variant[VARIANTS] = {
    { "nothing", gjk_distance },
    { "the proof at the end", gjk_distance_12 },
    { "touching: below 1e-6 m", gjk_distance_1 },
    { "touching: below 1e-10 of the size", gjk_distance_2 },
    { "heights from the world's origin", gjk_distance_3 },
    { "v as the weights give it", gjk_distance_4 },
    { "v perpendicular to triangles only", gjk_distance_5 },
    { "normals by the cross product alone", gjk_distance_6 },
    { "done when v shrinks no more", gjk_distance_10 },
    { "then apart in any case", gjk_distance_7 },
    { "then apart beyond 2e-12 of the size", gjk_distance_8 },
    { "a corner may be taken twice", gjk_distance_11 },
    { "done when the bounds agree to 1e-6", gjk_distance_9 }
};

typedef struct {
    int pairs, wrong, status;
} tally;

static tally stored[VARIANTS], made[VARIANTS];

// truth: m, > 0 apart; < 0 minus the depth; 0 touching, where either is right.
static void ask_all(const body *a, const body *b, real truth, tally *t)
{
    real size = pair_size(a, b);
    for (int k = 0; k < VARIANTS; k++, t++) {
        gjk_result r = variant[k].ask(body_hull(a), body_hull(b), HUGE_VAL,
                                      NULL);
        real wanted = real_max(truth, 0), error = fabs(r.distance - wanted);
        int apart = r.status == GJK_APART;
        int is_false = fabs(truth) > 1e-12 * size && apart != (truth > 0);
        t->pairs++;
        t->status += is_false;
        t->wrong += is_false || !(error <= 1e-6 * wanted || error <= 1e-14 * size);
    }
}

static void ask_stored(const char *path)
{
    static pair_known p;
    FILE *file = fopen(path, "r");
    while (file && pair_read(file, &p) == 1)
        ask_all(&p.a, &p.b, p.kind == 'S' ? p.value : -p.value, stored);
    if (file) fclose(file);
}

static real power(real base, real exponent)
{
    real x = 1;
    for (; exponent >= 1; exponent -= 1) x *= base;
    return x;
}

// Two edges that cross at this angle (rad), the gap above each other (m).
static void make_edges(body *a, body *b, real angle, real gap,
                       unsigned long long *seed)
{
    real end = random_fraction(seed);
    a->count = b->count = 2;
    a->at[0] = (vec3){ -1, 0, 0 }, a->at[1] = (vec3){ 1, 0, 0 };
    b->at[0] = (vec3){ end - 1, -angle, gap };
    b->at[1] = (vec3){ end + 1, angle, gap };
    unsigned long long same = *seed;
    body_turn(a, &same);
    body_turn(b, seed);
}

// A small plate over a large one, nearly parallel to it, both askew and this far
// (m) from the world's origin, where coordinates are rounded.  Returns what the
// slow oracle says of them as they are then.
static real make_plates(body *a, body *b, real gap, real far,
                        unsigned long long *seed)
{
    real tilt = power(0.1, 1 + 12 * random_fraction(seed));
    a->count = b->count = 4;
    for (int i = 0; i < 4; i++) {
        real x = i % 2 ? 1 : -1, y = i / 2 ? 1 : -1;
        a->at[i] = (vec3){ x, y, 0 };
        b->at[i] = (vec3){ x / 2, y / 4, gap * (1 + tilt * (1 + x)) };
    }
    unsigned long long same = *seed;
    body_turn(a, &same);
    body_turn(b, seed);
    vec3 by = vec3_scale(far, random_direction(seed));
    body_move(a, by);
    body_move(b, by);
    return (real)oracle_distance(body_hull(a), body_hull(b));
}

// A box over a plate, the gap above it (m), both scaled.
static real make_boxes(body *a, body *b, real gap, real scale,
                       unsigned long long *seed)
{
    real x = random_fraction(seed) - 0.5, y = random_fraction(seed) - 0.5;
    body_box(a, (vec3){ -1, -1, -1 }, (vec3){ 1, 1, 0 });
    body_box(b, (vec3){ x, y, gap }, (vec3){ x + 0.3, y + 0.2, gap + 0.5 });
    body_scale(a, scale);
    body_scale(b, scale);
    return gap * scale;
}

static real make_pair(int n, body *a, body *b, unsigned long long *seed)
{
    real u = random_fraction(seed), v = random_fraction(seed);
    real gap = power(0.1, 1 + 9 * u);
    if (n % 4 == 0) make_edges(a, b, power(0.1, 3 + 9 * v) * u, gap, seed);
    if (n % 4 == 1)
        gap = make_plates(a, b, power(0.1, 1 + 5 * u), power(10, 8 * v), seed);
    if (n % 4 == 2) gap = make_boxes(a, b, gap, power(0.1, 8 * v), seed);
    if (n % 4 == 3) {
        body_random(a, 4 + n / 4 % 3, seed);
        *b = *a;
        body_move(b, random_vector(seed, 0, 1e-14));
        gap = -0.01;
    }
    return gap;
}

static void ask_made(void)
{
    static body a, b;
    unsigned long long seed = 4;
    for (int n = 0; n < MADE; n++) {
        real truth = make_pair(n, &a, &b, &seed);
        ask_all(&a, &b, truth, made);
    }
}

int main(int count, char **argument)
{
    ask_stored(count > 1 ? argument[1] : "tests/data/pairs-all.txt");
    ask_made();
    printf("without the rule,wrong of %d stored pairs,wrong status,"
           "wrong of %d made pairs,wrong status\n", stored[0].pairs,
           made[0].pairs);
    for (int k = 0; k < VARIANTS; k++)
        printf("%s,%d,%d,%d,%d\n", variant[k].name, stored[k].wrong,
               stored[k].status, made[k].wrong, made[k].status);
    return 0;
}
