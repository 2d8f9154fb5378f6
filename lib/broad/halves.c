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
        sphere ball = w->pairs.ball[b];
        real x = along(ball.center, axis);
        if (!w->flags.moves[b] || ball.radius < 0 || !(x - x == 0)) continue;
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
            below += w->flags.moves[b] && w->pairs.ball[b].radius >= 0
                     && along(w->pairs.ball[b].center, axis) < middle;
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
    world_cut *t = &w->cut;
    t->lefts = 0;
    for (int b = 0; b < w->bodies; b++) {
        t->side[b] = along(w->pairs.ball[b].center, axis) >= cut;
        if (t->side[b]) t->sided[w->bodies - ++rights] = b;
        else            t->sided[t->lefts++] = b;
    }
}

const int *halves_bodies(const world *w, int side, int *n)
{
    *n = side ? w->bodies - w->cut.lefts : w->cut.lefts;
    return side ? w->cut.sided + w->cut.lefts : w->cut.sided;
}
//<

//> halves-sort
// Whoever does not move is on neither side, and is written by nobody.
int halves_part(const world *w, int a, int b)
{
    const char *moves = w->flags.moves, *side = w->cut.side;
    if (b >= w->bodies || !moves[b]) return side[a];
    if (!moves[a] || side[a] == side[b]) return side[b];
    return PILE_ACROSS;
}

void halves_sort(world *w)
{
    push_tables *t = &w->pushes;
    int at[PILE_PARTS] = { 0 };
    for (int k = 0; k < t->count; k++)
        at[halves_part(w, t->between[k][0], t->between[k][1])]++;
    for (int part = 0, sum = 0; part < PILE_PARTS; part++) {
        int n = at[part];
        at[part] = sum;
        t->end[part] = sum += n;
    }
    for (int k = 0; k < t->count; k++) {
        int part = halves_part(w, t->between[k][0], t->between[k][1]);
        t->in_parts[at[part]++] = k;
    }
}
//<
