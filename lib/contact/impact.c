//> impact-rows
//>   Contacts that bounce and blows have the same rows.
#include "impact.h"

#include <assert.h>

real impact_parting(const impact_row *r, const motion *velocity)
{
    real sum = 0;
    for (int side = A; side <= B && r->body[side] >= 0; side++) {
        const real *u = velocity[r->body[side]].of;
        real x = vec3_dot(r->along, vec3_make(u[0], u[1], u[2]));
        real turn = 0;
        for (int t = 0; t < TURNS; t++)
            turn += r->turn[side][t] * u[MOTION_TURN + t];
        sum += side == A ? x + turn : -x - turn;
    }
    return sum;
}

real impact_product(const impact_row *r, const impact_row *s)
{
    real sum = 0;
    for (int i = A; i <= B; i++)
        for (int j = A; j <= B; j++) {
            if (!(r->inverse[i] > 0) || r->body[i] != s->body[j]) continue;
            real x = r->inverse[i] * vec3_dot(r->along, s->along);
            for (int t = 0; t < TURNS; t++)
                x += r->turn[i][t] * s->turn[j][t];
            sum += i == j ? x : -x;
        }
    return sum;
}

void impact_push(const impact_row *r, real impulse, motion *velocity)
{
    for (int side = A; side <= B; side++) {
        if (!(r->inverse[side] > 0)) continue;
        real j = side == A ? impulse : -impulse;
        motion *u = &velocity[r->body[side]];
        motion_add_straight(u, j * r->inverse[side], r->along);
        for (int t = 0; t < TURNS; t++)
            u->of[MOTION_TURN + t] += j * r->turn[side][t];
    }
}

void impact_add(impact_set *w, const impact_row *r, real parting)
{
    assert(w->rows < IMPACT_ROWS);
    int i = w->rows++;
    w->row[i] = *r;
    w->impulse[i] = w->given[i] = 0;
    w->part[i] = parting;
    for (int n = 0; n <= i; n++) {
        w->k[i][n] = w->k[n][i] = impact_product(r, &w->row[n]);
        w->part[i] -= w->k[i][n] * w->given[n];
    }
}
//<

//> impact-stop
//>   They are stopped directly, by the active set of Lawson and Hanson: the row
//>   that closes fastest joins it, until none does. A row that joins adds a line
//>   to the factors K = L D L^T. The energy falls, so no set comes twice.
// K stop = -part for the rows of the set.  False if the last of them can do
// nothing that the others cannot, to rounding.
static bool factor_set(impact_set *w)
{
    for (int i = w->good; i < w->count; i++) {
        const real *row = w->k[w->set[i]];
        w->d[i] = row[w->set[i]];
        w->y[i] = -w->part[w->set[i]];
        for (int j = 0; j < i; j++) {
            real sum = row[w->set[j]];
            for (int k = 0; k < j; k++)
                sum -= w->l[i][k] * w->l[j][k] * w->d[k];
            w->l[i][j] = sum / w->d[j];
            w->d[i] -= w->l[i][j] * sum;
            w->y[i] -= w->l[i][j] * w->y[j];
        }
        if (!(w->d[i] > 1e-12 * row[w->set[i]])) return false;
        w->good = i + 1;
    }
    for (int i = w->count - 1; i >= 0; i--) {
        w->stop[i] = w->y[i] / w->d[i];
        for (int j = i + 1; j < w->count; j++)
            w->stop[i] -= w->l[j][i] * w->stop[j];
    }
    return true;
}

// Goes from the impulses that there are towards those of the set, as far as
// none of them pulls; one that would is dropped.  True if that was all the way.
static bool step_to_set(impact_set *w)
{
    real fraction = 1;
    int least = -1, kept = 0;
    for (int i = 0; i < w->count; i++) {
        real now = w->impulse[w->set[i]];
        if (w->stop[i] > 0 || !(now < fraction * (now - w->stop[i]))) continue;
        fraction = now / (now - w->stop[i]);
        least = i;
    }
    for (int i = 0; i < w->count; i++) {
        real *now = &w->impulse[w->set[i]];
        *now = i == least ? 0 : *now + fraction * (w->stop[i] - *now);
        if (i != least) w->set[kept++] = w->set[i];
    }
    w->count = kept;
    if (least >= 0) w->good = int_min(w->good, least);
    return least < 0;
}

// The row that closes fastest, beyond rounding, of those that do not push.
static int find_closing(const impact_set *w)
{
    real most = 0, fastest = 0;
    int found = -1;
    for (int i = 0; i < w->rows; i++) {
        real closing = -w->part[i];
        fastest = real_max(closing, fastest);
        for (int j = 0; j < w->rows; j++)
            closing -= w->k[i][j] * w->impulse[j];
        if (w->impulse[i] > 0 || !(closing > most)) continue;
        most = closing;
        found = i;
    }
    return most > 1e-12 * fastest ? found : -1;
}

// Row `good` can do nothing that those before it cannot, and yet it closes, as their
// gaps are others.  It takes over from each its share, until one has nothing left
// and is dropped: no velocity changes.  False if none has a share beyond rounding.
static bool take_over(impact_set *w)
{
    int least = -1, last = w->set[w->good];
    real most = HUGE_VAL, *fraction = w->stop;
    for (int i = w->good - 1; i >= 0; i--) {
        int row = w->set[i];
        fraction[i] = w->l[w->good][i];
        for (int j = i + 1; j < w->good; j++) fraction[i] -= w->l[j][i] * fraction[j];
        real gives = fraction[i] * fabs(fraction[i]) * w->k[row][row];
        if (!(gives > 1e-12 * w->k[last][last])
            || !(w->impulse[row] < most * fraction[i])) continue;
        most = w->impulse[row] / fraction[i];
        least = i;
    }
    if (least < 0) return false;
    for (int i = 0; i < w->good; i++) {
        real *now = &w->impulse[w->set[i]];
        *now = real_max(*now - most * fraction[i], 0);
    }
    w->impulse[last] += most;
    w->impulse[w->set[least]] = 0;
    for (int i = least + 1; i < w->count; i++) w->set[i - 1] = w->set[i];
    w->count--;
    w->good = least;
    return true;
}

void impact_stop(impact_set *w)
{
    bool stops = true;
    for (int n = 0; n < 4 * IMPACT_ROWS && stops; n++) {
        int next = find_closing(w);
        if (next < 0 || w->count == IMPACT_ROWS) return;
        w->set[w->count++] = next;
        for (bool ends = false; stops && !ends; )
            if (factor_set(w)) ends = step_to_set(w);
            else stops = take_over(w);
        if (!stops) w->count = w->good;
    }
}

void impact_apply(impact_set *w, motion *velocity)
{
    for (int i = 0; i < w->rows; i++) {
        impact_push(&w->row[i], w->impulse[i] - w->given[i], velocity);
        w->given[i] = w->impulse[i];
    }
}
//<
