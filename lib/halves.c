//> halves-do
#include "halves.h"

void halves_do(const world *w, void (*work)(void *data, int half), void *data)
{
    if (w->options.both) {
        w->options.both(w->options.both_context, work, data);
        return;
    }
    work(data, 0);
    work(data, 1);
}
//<

//> halves-cut
// To begin a second thread's work, and to wait for its end, takes about a
// microsecond: as long as a pass takes over the contacts of a few bodies.
enum { WORTH = 128 };

static real along(vec3 v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// The ends of what moves along an axis; returns how many move.
static int ends_of(const world *w, int axis, real end[2])
{
    int n = 0;
    end[0] = HUGE_VAL;
    end[1] = -HUGE_VAL;
    for (int b = 0; b < w->bodies; b++) {
        real x = along(w->ball[b].center, axis);
        if (!w->moves[b] || w->ball[b].radius < 0 || !(x - x == 0)) continue;
        end[0] = fmin(end[0], x);
        end[1] = fmax(end[1], x);
        n++;
    }
    return n;
}

// Where to cut, so that half lie below: halved so often that it is within a
// 4,000th of the whole.
static real median(const world *w, int axis, int n, real end[2])
{
    for (int round = 0; round < 12; round++) {
        real middle = (end[0] + end[1]) / 2;
        int below = 0;
        for (int b = 0; b < w->bodies; b++)
            below += w->moves[b] && w->ball[b].radius >= 0
                     && along(w->ball[b].center, axis) < middle;
        end[2 * below > n] = middle;
    }
    return end[0];
}

void halves_cut(world *w)
{
    real end[3][2], cut = HUGE_VAL;
    int n = 0, axis = 0, rights = 0;
    for (int k = 0; k < 3; k++) {
        n = ends_of(w, k, end[k]);
        if (end[k][1] - end[k][0] > end[axis][1] - end[axis][0]) axis = k;
    }
    if (n >= WORTH) cut = median(w, axis, n, end[axis]);
    w->lefts = 0;
    for (int b = 0; b < w->bodies; b++) {
        w->side[b] = along(w->ball[b].center, axis) >= cut;
        if (w->side[b]) w->sided[w->bodies - ++rights] = b;
        else            w->sided[w->lefts++] = b;
    }
}

const int *halves_bodies(const world *w, int side, int *n)
{
    *n = side ? w->bodies - w->lefts : w->lefts;
    return side ? w->sided + w->lefts : w->sided;
}
//<

//> halves-sort
// Whoever does not move is on neither side, and is written by nobody.
int halves_part(const world *w, int a, int b)
{
    if (b >= w->bodies || !w->moves[b]) return w->side[a];
    if (!w->moves[a] || w->side[a] == w->side[b]) return w->side[b];
    return PILE_ACROSS;
}

void halves_sort(world *w)
{
    int at[PILE_PARTS] = { 0 };
    for (int k = 0; k < w->pushes; k++)
        at[halves_part(w, w->pushed[k][0], w->pushed[k][1])]++;
    for (int part = 0, sum = 0; part < PILE_PARTS; part++) {
        int n = at[part];
        at[part] = sum;
        w->part_end[part] = sum += n;
    }
    for (int k = 0; k < w->pushes; k++) {
        int part = halves_part(w, w->pushed[k][0], w->pushed[k][1]);
        w->in_parts[at[part]++] = k;
    }
}
//<
