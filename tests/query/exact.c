// exact.c - pairs of bodies in sixteen families, and how often the queries are
// wrong about them: `make queries-exact`.
//
// build/queries-exact [seed [pairs of each family [family]]]

#include "exact_judge.h"

#include <stdio.h>
#include <stdlib.h>

typedef struct {
    int  bad, sign, witness, normal;
    real error, points, along;
} tally;

static void add(tally *t, const verdict *v)
{
    t->bad += v->bad, t->sign += v->sign;
    t->witness += v->witness, t->normal += v->normal;
    t->error = real_max(t->error, v->error);
    t->points = real_max(t->points, v->points);
    t->along = real_max(t->along, v->along);
}

static void show(const char *name, int n, const tally *t, int wide, int open)
{
    printf("%-20s %8d", name, n);
    for (int k = 0; k < ASKS; k++)
        printf(" | %d %d %d %d", t[k].bad, t[k].sign, t[k].witness,
               t[k].normal);
    real error = 0, points = 0, along = 0;
    for (int k = 0; k < ASKS; k++) {
        error = real_max(error, t[k].error);
        points = real_max(points, t[k].points);
        along = real_max(along, t[k].along);
    }
    printf(" | %.1e %.1e %.1e | %d %d\n", error, points, along, wide, open);
    fflush(stdout);
}

static int judge(int family, unsigned long long seed, int n, int verbose)
{
    tally t[ASKS] = { { 0 } };
    int wide = 0, open = 0, wrong = 0;
    static made a, b;
    for (int i = 0; i < n; i++) {
        unsigned long long s = seed * 1000003 + (unsigned)family * 7919
                             + (unsigned long long)i * 104729;
        for (int k = 0; k < 4; k++)
            s = s * 6364136223846793005ULL + 1442695040888963407ULL;
        made_pair(&a, &b, family, &s);
        truth is = truth_find((hull){ a.at, a.count }, (hull){ b.at, b.count });
        wide += is.wider;
        int unproven = !(is.doubt <= 4e-15L * is.size + 1e-7L * fabsl(is.value));
        open += unproven;
        for (int k = 0; k < ASKS; k++) {
            verdict v = exact_judge(&a, &b, &is, k, s);
            int any = v.bad || v.sign || v.witness || v.normal;
            wrong += any;
            add(&t[k], &v);
            if (any && verbose)
                printf("# %s: pair %d, %s: %s%s%s%s %.17g for %.17Lg (open %.1Le"
                       "), size %.3Lg; of the size %.1e, points %.1e, along "
                       "%.1e\n", MADE_NAME[family], i, ASK_NAME[k],
                       v.bad ? "value " : "", v.sign ? "sign " : "",
                       v.witness ? "points " : "", v.normal ? "normal " : "",
                       v.value, is.value, is.doubt, is.size, v.error, v.points,
                       v.along);
        }
    }
    show(MADE_NAME[family], n, t, wide, open);
    return wrong + open;
}

int main(int argc, char **argv)
{
    unsigned long long seed = argc > 1 ? strtoull(argv[1], NULL, 10) : 2718;
    int n = argc > 2 ? atoi(argv[2]) : 1000, wrong = 0;
    int only = argc > 3 ? atoi(argv[3]) : -1;
    printf("# seed %llu; of each way to ask (", seed);
    for (int k = 0; k < ASKS; k++) printf("%s%s", k ? "; " : "", ASK_NAME[k]);
    printf("): bad values, signs, points, normals; the worst of these errors, of "
           "the size; truths that took 113 bits, and truths not proven\n");
    for (int f = 0; f < MADE_FAMILIES; f++)
        if (only < 0 || f == only) wrong += judge(f, seed, n, argc > 2);
    printf("# %s\n", wrong ? "WRONG" : "all right");
    return wrong != 0;
}
