// solution.c - colour after colour, and four lanes after four.

#include "blocks.h"

static bool is_free(int body, const int *last, int colour)
{
    return body < 0 || last[body] < colour;
}

// Takes what it can of the `left` contacts in the list, into lanes from `used`
// on; the others move up in the list.  Returns how many were taken.
static int colour_next(const meeting *m, int *list, int left, int *last,
                       int colour, int *lane)
{
    int taken = 0;
    for (int k = 0; k < left; k++) {
        meeting now = m[list[k]];
        if (is_free(now.a, last, colour) && is_free(now.b, last, colour)) {
            if (now.a >= 0) last[now.a] = colour;
            if (now.b >= 0) last[now.b] = colour;
            lane[taken++] = list[k];
        } else list[k - taken] = list[k];
    }
    return taken;
}

int blocks_fill(const meeting *m, int count, int bodies, int *lane, int *scratch)
{
    int *last = scratch, *list = scratch + bodies, used = 0, left = count;
    for (int i = 0; i < bodies; i++) last[i] = 0;
    for (int k = 0; k < count; k++) list[k] = k;
    for (int colour = 1; left > 0; colour++) {
        int taken = colour_next(m, list, left, last, colour, lane + used);
        left -= taken;
        used += taken;
        while (used % LANES) lane[used++] = -1;
    }
    return used / LANES;
}
