// 20-margins.c - the whole table at one glance: every number of every hard
// case, as a part of its target.  Reads what `make hard` has written; a row for
// each number: its case's place from below, error / target, 1 if it is the
// case's worst; the names of the cases come first.

#include <math.h>
#include <stdio.h>
#include <string.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif
#ifndef TABLE
#define TABLE "figures/tables/hard.csv"
#endif

enum { CASES = 40, PARTS = 1200, LINE = 400 };

typedef struct {
    int    row;
    double ratio;
} part;

typedef struct {
    int  cases, number[CASES], parts;
    char name[CASES][80];
    part part[PARTS];
} table;

// number,"case",...: a line of the table.
static int read_case(table *t, const char *line)
{
    int number;
    char name[80];
    if (t->cases == CASES) return 0;
    if (sscanf(line, "%d,\"%79[^\"]\"", &number, name) != 2) return 0;
    t->number[t->cases] = number;
    snprintf(t->name[t->cases++], sizeof name, "%s", name);
    return 1;
}

// # number: what: error unit, target number, verdict: below the line of its
// case.
static void read_part(table *t, char *line)
{
    char *target = strstr(line, ", target "), *error = NULL;
    double is, most;
    if (!target || t->cases == 0 || t->parts == PARTS) return;
    *target = '\0';
    for (char *c = strstr(line, ": "); c; c = strstr(c + 2, ": ")) error = c;
    if (!error || sscanf(error + 2, "%lf", &is) != 1) return;
    if (sscanf(target + 9, "%lf", &most) != 1) return;
    double ratio = is == 0 ? 0 : most > 0 ? is / most : HUGE_VAL;
    t->part[t->parts++] = (part){ t->cases - 1, ratio };
}

// Zero and what is less than the least lies on the left edge, what is more than
// the most (or lost) on the right one.
static double shown(double ratio)
{
    const double least = 1e-9, most = 1e3;
    if (!(ratio <= most)) return most;
    return ratio < least ? least : ratio;
}

static void print_table(const table *t)
{
    printf("# number row name\n");
    for (int k = 0; k < t->cases; k++)
        printf("%d %d \"%s\"\n", t->number[k], t->cases - k, t->name[k]);
    printf("\n\n# every number: row error/target\n");
    for (int i = 0; i < t->parts; i++)
        printf("%d %.3g\n", t->cases - t->part[i].row,
               shown(t->part[i].ratio));
    printf("\n\n# the worst of each case: row error/target\n");
    for (int k = 0; k < t->cases; k++) {
        double worst = 0;
        for (int i = 0; i < t->parts; i++)
            if (t->part[i].row == k && !(t->part[i].ratio <= worst))
                worst = t->part[i].ratio;
        printf("%d %.3g\n", t->cases - k, shown(worst));
    }
}

int main(void)
{
    static table t;
    char line[LINE];
    FILE *file = fopen(TABLE, "r");
    while (file && fgets(line, sizeof line, file))
        if (!read_case(&t, line) && line[0] == '#') read_part(&t, line);
    if (file) fclose(file);
    if (t.parts == 0) {
        fprintf(stderr, "20-margins: no numbers in %s: make hard first\n",
                TABLE);
        return 1;
    }
    printf("# Hard cases: every number as a part of its target, from %s\n"
           "# %s, %s\n", TABLE, __VERSION__, FLAGS);
    print_table(&t);
    return 0;
}
