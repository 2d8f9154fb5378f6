// solution.c - rings that spread from many stones at once.

#include "blows.h"

// One ring further: every stick without a distance that touches ring k - 1 has
// distance k, and so has what it reaches.  Returns how many those are.
static int ring_reach(const stick *s, int sticks, int k, int *away,
                      int *distance)
{
    int found = 0;
    for (int j = 0; j < sticks; j++) {
        int *a = &away[s[j].a], *b = &away[s[j].b];
        if (distance[j] > 0 || (*a != k - 1 && *b != k - 1)) continue;
        distance[j] = k;
        found++;
        if (*a < 0) *a = k;
        if (*b < 0) *b = k;
    }
    return found;
}

int blows_order(const stick *s, int sticks, int particles, const int *struck,
                int m, int *order, int *away, int *distance)
{
    for (int i = 0; i < particles; i++) away[i] = -1;
    for (int i = 0; i < m; i++) away[struck[i]] = 0;
    for (int j = 0; j < sticks; j++) distance[j] = 0;
    int largest = 0;
    while (ring_reach(s, sticks, largest + 1, away, distance) > 0) largest++;

    // By distance; those without one behind the last.
    int written = 0;
    for (int k = 1; k <= largest + 1; k++)
        for (int j = 0; j < sticks; j++)
            if (distance[j] == (k <= largest ? k : 0)) order[written++] = j;
    return largest;
}
