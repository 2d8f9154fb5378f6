// exact_judge.h - are both forms of the query right about a pair?  Cold, carried
// from a moment before, and carried from their own answer.

#ifndef TUMBLE_EXACT_JUDGE_H
#define TUMBLE_EXACT_JUDGE_H

#include "made_pairs.h"
#include "truth.h"

enum { ASK_PAPER, ASK_PAPER_CARRIED, ASK_PAPER_AGAIN,
       ASK_ENGINE, ASK_ENGINE_CARRIED, ASK_ENGINE_AGAIN, ASKS };

extern const char *const ASK_NAME[ASKS];

typedef struct {
    int  bad;           // a wrong value: by more than 1e-6 of itself and 1e-14
                        // of the size; or no answer
    int  sign;          // of those, the wrong side of touching
    int  witness;       // points that the normal does not join, to 1e-9 of size
    int  normal;        // along it they are as far apart, to 1e-9 of size
    real error, points, along;      // those errors, of the size
    real value;
} verdict;

verdict exact_judge(const made *a, const made *b, const truth *t, int ask,
                    unsigned long long seed);

#endif
