// hard.h - the hard cases: what each one measures, and the target beside it.
//
// A case runs an experiment or several, and reports numbers, each with the
// target that it must not exceed.  On the table a case is one line: its worst
// number, by the ratio of error and target.

#ifndef TUMBLE_HARD_H
#define TUMBLE_HARD_H

#include "status.h"

enum { HARD_PARTS = 48, HARD_NOTES = 48 };

// One number beside its target.
typedef struct {
    char   what[64];    // what is measured
    char   unit[8];     // "" where it has none
    double error;       // >= 0; NaN never holds
    double target;      // it holds if error <= target
} hard_part;

// What a case found out.
typedef struct {
    int  parts, notes;
    hard_part part[HARD_PARTS];
    char note[HARD_NOTES][192];     // what a reader of the numbers should know
} hard_report;

typedef struct {
    int number;         // of the table; 0 ends a list of cases
    const char *name;
    int fast;           // 1: it has a short form, which make test runs
    void (*run)(hard_report *r, int fast);
} hard_case;

// What a program runs: hard_list.c has the engine's cases, families.c those
// through tumble.h.
typedef struct {
    const char *program;    // its name
    const char *title;      // what its table is
    const hard_case *const *list;       // one a file; NULL ends them
} hard_catalogue;
extern const hard_catalogue hard_all;

// The case of this number, or NULL.
const hard_case *hard_find(int number);
enum { HARD_LAST = 199 };           // the largest number there may be

// Adds a number, or a note, with the sentence that printf would make.
#if defined(__GNUC__)
__attribute__((format(printf, 5, 6)))
#endif
void hard_add(hard_report *r, double error, double target, const char *unit,
              const char *format, ...);
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void hard_note(hard_report *r, const char *format, ...);

// 1 if all is well; else adds why not, as a number that does not hold.
int hard_ok(hard_report *r, status so_far);

// error / target; 0 where both are 0; infinite for NaN.
double hard_ratio(const hard_part *p);
int    hard_holds(const hard_part *p);
// The part with the largest ratio, the first of equals.  Requires: parts > 0.
const hard_part *hard_worst(const hard_report *r);

// The larger of two errors; infinite as soon as one of them is NaN, which fmax
// would let go.
double hard_worse(double so_far, double now);

// The slope of log error over log step, by least squares.
double hard_order(const double *step, const double *error, int n);

#endif
