//> ordering-distances
#include "ordering.h"

#include <assert.h>
#include <limits.h>
#include <stdlib.h>

// The constraint graph: particles are its corners, sticks its edges.  away[i]
// is the number of sticks on the shortest path from v to particle i, -1 while
// none is known; each round of the loop walks one stick further, and looks only
// at sticks that wait to be reached.
// A stick with an end at v has distance 1, its neighbours 2, and so on; one
// that no path reaches is put behind the last.  Returns the largest of the
// distances that are reached.
static int stick_distances(const stick *s, int sticks, int particles, int v,
                           int *away, int *waiting, int *distance)
{
    for (int i = 0; i < particles; i++) away[i] = i == v ? 0 : -1;
    for (int k = 0; k < sticks; k++) waiting[k] = k;
    int largest = 0, left = sticks, grew = 1;
    while (grew) {
        int kept = 0;
        for (int i = 0; i < left; i++) {
            int k = waiting[i], *a = &away[s[k].a], *b = &away[s[k].b];
            if (*a != largest && *b != largest) {
                waiting[kept++] = k;
                continue;
            }
            distance[k] = largest + 1;
            if (*a < 0) *a = largest + 1;
            if (*b < 0) *b = largest + 1;
        }
        grew = kept < left;
        left = kept;
        largest += grew;
    }
    for (int i = 0; i < left; i++) distance[waiting[i]] = largest + 1;
    return largest;
}
//<

//> ordering-list
// Near sticks stand in every round, the next in every second, those behind in
// every fourth: of n rounds a stick of distance k has n / 2^(k-1), cut down.
// Whoever has none by then has one turn in the last.
static int rounds_between(int k, int n)
{
    int every = 1;
    for (int i = 1; i < k && every <= n; i++) every *= 2;
    return every;
}

static int turns_of(int k, int n)
{
    int every = rounds_between(k, n);
    return every <= n ? n / every : 1;
}

// Paper: leaves open how the repeats follow each other; here: interleaved,
// because a stick that has just been relaxed has nothing left to mend.
static int has_turn(int k, int r, int n)
{
    int every = rounds_between(k, n);
    return every <= n ? r % every == 0 : r == n;
}

static long long list_length(const int *distance, int sticks, int rounds)
{
    long long length = 0;
    for (int i = 0; i < sticks; i++) length += turns_of(distance[i], rounds);
    return length;
}

// Writes one particle's list to out; n is the largest distance that is reached.
static void list_write(const int *distance, int sticks, int n, int rounds,
                       int *out)
{
    for (int r = 1; r <= rounds; r++)
        for (int k = 1; k <= n + 1; k++) {
            if (!has_turn(k, r, rounds)) continue;
            for (int i = 0; i < sticks; i++)
                if (distance[i] == k) *out++ = i;
        }
}
//<

//> stick-lists-fill
// So many numbers have bytes that can be numbered by an int.
enum { LISTS_AT_MOST = INT_MAX / (int)sizeof(int) };

static status lists_too_long(int sticks, int particles)
{
    return status_fail("%d particles with %d sticks make lists too long to "
                       "number", particles, sticks);
}

// Without repeats there is one round, and every stick in it.
static int rounds_of(int n, int repeated)
{
    return repeated && n > 1 ? n : 1;
}

// All lists one behind the other: counted first, then written.
static status lists_fill(stick_lists *l, const stick *s, int sticks,
                         int repeated, int *away, int *waiting, int *distance)
{
    long long total = 0;
    for (int v = 0; v < l->particles; v++) {
        int n = stick_distances(s, sticks, l->particles, v, away, waiting,
                                distance);
        l->start[v] = (int)total;
        total += list_length(distance, sticks, rounds_of(n, repeated));
        if (total > LISTS_AT_MOST) return lists_too_long(sticks, l->particles);
    }
    l->start[l->particles] = (int)total;
    l->stick = malloc(((size_t)total + 1) * sizeof *l->stick);
    if (!l->stick) return status_out_of_memory();
    for (int v = 0; v < l->particles; v++) {
        int n = stick_distances(s, sticks, l->particles, v, away, waiting,
                                distance);
        list_write(distance, sticks, n, rounds_of(n, repeated),
                   l->stick + l->start[v]);
    }
    return status_ok();
}
//<

//> stick-lists-build
static status check_lists(const stick *s, int sticks, int particles)
{
    // Every stick stands in every list, once at least.
    if (particles >= LISTS_AT_MOST
        || (long long)particles * sticks > LISTS_AT_MOST)
        return lists_too_long(sticks, particles);
    for (int k = 0; k < sticks; k++)
        if (s[k].a < 0 || s[k].a >= particles
            || s[k].b < 0 || s[k].b >= particles)
            return status_fail("stick %d joins particles %d and %d, of %d", k,
                               s[k].a, s[k].b, particles);
    return status_ok();
}

status stick_lists_build(stick_lists *l, const stick *s, int sticks,
                         int particles, int repeated)
{
    assert(sticks >= 0 && particles >= 0);
    *l = (stick_lists){ 0 };
    status result = check_lists(s, sticks, particles);
    if (!result.ok) return result;

    size_t points = (size_t)particles + 1, n = (size_t)sticks + 1;
    int *away = malloc(points * sizeof *away);
    int *waiting = malloc(n * sizeof *waiting);
    int *distance = malloc(n * sizeof *distance);
    l->start = malloc(points * sizeof *l->start);
    l->particles = particles;
    if (away && waiting && distance && l->start)
        result = lists_fill(l, s, sticks, repeated, away, waiting, distance);
    else
        result = status_out_of_memory();
    free(away);
    free(waiting);
    free(distance);
    if (!result.ok) stick_lists_free(l);
    return result;
}

void stick_lists_free(stick_lists *l)
{
    free(l->start);
    free(l->stick);
    *l = (stick_lists){ 0 };
}
//<

//> most-moved
int most_moved(const particle *p, const vec3 *before, int n)
{
    int most = -1;
    real furthest = 0;
    for (int i = 0; i < n; i++) {
        vec3 moved = vec3_sub(p[i].position, before[i]);
        real square = vec3_length_squared(moved);
        if (!(square > furthest)) continue;
        furthest = square;
        most = i;
    }
    return most;
}
//<

//> order-scratch
struct order_scratch {
    int   sticks;
    real *strain;       // [sticks] at the last look
    int  *looked;       // [sticks] when that was, counted in relaxations
    int  *moved;        // [2 * sticks] when each particle moved last
    int  *winner;       // [2 * leaves] see ORDER_LARGEST
    int   leaves;       // a power of two, >= sticks
};

order_scratch *order_scratch_new(int sticks)
{
    assert(sticks >= 0 && sticks <= INT_MAX / 32);
    order_scratch *o = calloc(1, sizeof *o);
    if (!o) return NULL;
    o->sticks = sticks;
    o->leaves = 1;
    while (o->leaves < sticks) o->leaves *= 2;
    size_t n = (size_t)sticks + 1;
    o->strain = malloc(n * sizeof *o->strain);
    o->looked = malloc(n * sizeof *o->looked);
    o->moved  = malloc(2 * n * sizeof *o->moved);
    o->winner = malloc(2 * (size_t)o->leaves * sizeof *o->winner);
    if (o->strain && o->looked && o->moved && o->winner) return o;
    order_scratch_free(o);
    return NULL;
}

void order_scratch_free(order_scratch *scratch)
{
    if (!scratch) return;
    free(scratch->strain);
    free(scratch->looked);
    free(scratch->moved);
    free(scratch->winner);
    free(scratch);
}
//<

//> ordering-look
// What the five orders share: the body, and the account of what was done.
typedef struct {
    const stick_lists *lists;
    const stick  *s;
    int           n;
    particle     *p;
    int           particles;
    relax_options options;
    long long     budget;   // relaxations that are still allowed
    relax_result  result;
} relaxation;

// Looks at stick k, relaxes it if the options say so, and returns the strain
// that it had (infinite if it is not a number).
static real look(relaxation *r, int k)
{
    stick_result done = stick_relax(r->s[k], r->p, r->options);
    r->result.tested++;
    r->result.relaxed += done.moved;
    r->budget -= done.moved;
    return fabs(done.error) / r->s[k].rest_length;
}

// One relaxation leaves no strain.
static int lands(const relaxation *r, int k)
{
    return r->s[k].stiffness >= 1 && r->options.root == ROOT_EXACT &&
           r->options.gradient == GRADIENT_NEW;
}
//<

//> ordering-sweeps
// The account when the budget ran out: what strain is left?
static void measure_rest(relaxation *r)
{
    real worst = 0;
    for (int k = 0; k < r->n; k++)
        worst = real_max(stick_strain(r->s[k], r->p), worst);
    r->result.tested += r->n;
    r->result.worst = worst;
}

// ORDER_LISTED, ORDER_BREADTH, ORDER_REPEATED: through the list (NULL: 0 to
// entries - 1), again and again, until a sweep finds all well or moves nothing.
static void relax_by_list(relaxation *r, const int *list, int entries)
{
    while (r->budget > 0) {
        real worst = 0;
        int before = r->result.relaxed;
        for (int i = 0; i < entries && r->budget > 0; i++)
            worst = real_max(look(r, list ? list[i] : i), worst);
        r->result.worst = worst;
        r->result.iterations++;
        if (r->budget <= 0) break;
        if (worst <= r->options.tolerance || r->result.relaxed == before)
            return;
    }
    measure_rest(r);
}
//<

//> ordering-work-list
// ORDER_WORK_LIST goes by a clock that advances with each relaxation.  Stick k
// need only be looked at if an end has moved since the last look.
static int is_stale(const relaxation *r, const order_scratch *o, int k)
{
    const stick *s = &r->s[k];
    return o->moved[s->a] > o->looked[k] || o->moved[s->b] > o->looked[k];
}

// Looks at stick k; now: the clock.  Returns the clock after.
static int look_by_clock(relaxation *r, order_scratch *o, int k, int now)
{
    int before = r->result.relaxed;
    o->strain[k] = look(r, k);
    o->looked[k] = now;
    if (r->result.relaxed == before) return now;

    // One that does not land is stale at once; one that does is well.
    now++;
    if (r->p[r->s[k].a].inverse_mass > 0) o->moved[r->s[k].a] = now;
    if (r->p[r->s[k].b].inverse_mass > 0) o->moved[r->s[k].b] = now;
    if (!lands(r, k)) return now;
    o->strain[k] = 0;
    o->looked[k] = now;
    return now;
}

static void relax_by_work(relaxation *r, const int *list, order_scratch *o)
{
    r->options.dead_band = 1;
    for (int v = 0; v < r->particles; v++) o->moved[v] = 0;
    for (int k = 0; k < r->n; k++) o->looked[k] = -1;
    int now = 0, found = 1;
    while (found && r->budget > 0) {
        found = 0;
        for (int i = 0; i < r->n && r->budget > 0; i++) {
            int k = list ? list[i] : i;
            if (!is_stale(r, o, k)) continue;
            found = 1;
            now = look_by_clock(r, o, k, now);
        }
        r->result.iterations += found;
    }
    if (r->budget <= 0) {
        measure_rest(r);
        return;
    }
    for (int k = 0; k < r->n; k++)
        r->result.worst = real_max(o->strain[k], r->result.worst);
}
//<

//> ordering-largest
// ORDER_LARGEST keeps a tournament.  The sticks are the leaves of a binary
// tree, in order; winner[node] is the stick with the largest strain below the
// node (-1: no stick), winner[1] that of all.  When a strain changes, only its
// path to the root is played again.
static int better(const order_scratch *o, int left, int right)
{
    if (left < 0 || right < 0) return left < 0 ? right : left;
    return o->strain[right] > o->strain[left] ? right : left;
}

static void play_again(order_scratch *o, int k)
{
    for (int node = (o->leaves + k) / 2; node >= 1; node /= 2)
        o->winner[node] = better(o, o->winner[2 * node],
                                 o->winner[2 * node + 1]);
}

static void play_all(order_scratch *o, int n)
{
    for (int k = 0; k < o->leaves; k++)
        o->winner[o->leaves + k] = k < n ? k : -1;
    for (int node = o->leaves - 1; node >= 1; node--)
        o->winner[node] = better(o, o->winner[2 * node],
                                 o->winner[2 * node + 1]);
}

// The sticks of particle v stand first in its list: is the i-th one of them?
static int has_stick(const relaxation *r, int v, int i)
{
    if (i >= r->lists->start[v + 1]) return 0;
    const stick *s = &r->s[r->lists->stick[i]];
    return s->a == v || s->b == v;
}

static void measure(relaxation *r, order_scratch *o, int k)
{
    o->strain[k] = stick_strain(r->s[k], r->p);
    r->result.tested++;
}

// The sticks that share a particle with k, which has just moved its ends.
static void measure_around(relaxation *r, order_scratch *o, int k)
{
    for (int end = 0; end < 2; end++) {
        int v = end ? r->s[k].b : r->s[k].a;
        for (int i = r->lists->start[v]; has_stick(r, v, i); i++) {
            int other = r->lists->stick[i];
            if (other == k) continue;
            measure(r, o, other);
            play_again(o, other);
        }
    }
}
//<

//> ordering-by-largest
// A stick that cannot move (nailed at both ends, or without direction) leaves
// the tournament until one of its neighbours moves.
static void relax_by_largest(relaxation *r, order_scratch *o)
{
    int stuck = 0;
    r->options.dead_band = 0;
    for (int k = 0; k < r->n; k++) measure(r, o, k);
    play_all(o, r->n);
    while (r->budget > 0) {
        int k = o->winner[1];
        if (!(o->strain[k] > r->options.tolerance)) break;
        int moved = stick_relax(r->s[k], r->p, r->options).moved;
        r->result.relaxed += moved;
        r->budget -= moved;

        // It is well now, or nothing helps it, or it stays in the game.
        if (!moved) stuck = 1;
        if (!moved || lands(r, k)) o->strain[k] = 0;
        else measure(r, o, k);
        play_again(o, k);
        if (moved) measure_around(r, o, k);
    }
    r->result.worst = o->strain[o->winner[1]];
    if (stuck) measure_rest(r);
}
//<

//> sticks-relax-ordered
relax_result sticks_relax_ordered(order_kind kind, const stick_lists *lists,
                                  const stick *s, int n, particle *p,
                                  int particles, int from, int max_sweeps,
                                  relax_options options,
                                  order_scratch *scratch)
{
    assert(from < particles && (kind == ORDER_LISTED || lists));
    relaxation r = { .lists = lists, .s = s, .n = n, .p = p,
                     .particles = particles, .options = options,
                     .budget = (long long)max_sweeps * n };
    if (n <= 0) return r.result;

    // Where in the lists does the list of the particle that moved most stand?
    const int *list = NULL;
    int entries = n;
    if (kind != ORDER_LISTED && from >= 0) {
        assert(particles == lists->particles);
        list = lists->stick + lists->start[from];
        entries = lists->start[from + 1] - lists->start[from];
    }
    assert(kind < ORDER_WORK_LIST || (scratch && scratch->sticks >= n &&
                                      particles <= 2 * scratch->sticks));
    if (kind == ORDER_WORK_LIST) {
        assert(entries == n);
        relax_by_work(&r, list, scratch);
    } else if (kind == ORDER_LARGEST) {
        relax_by_largest(&r, scratch);
        r.result.iterations = (r.result.relaxed + n - 1) / n;
    } else {
        relax_by_list(&r, list, entries);
    }
    return r.result;
}
//<

//> sticks-relax-from
// Relaxes stick k, and keeps the account of it.
static void relax_one(stick s, particle *p, relax_options options,
                      relax_result *r)
{
    stick_result done = stick_relax(s, p, options);
    r->worst = real_max(fabs(done.error) / s.rest_length, r->worst);
    r->tested++;
    r->relaxed += done.moved;
}

relax_result sticks_relax_from(const stick_lists *l, int from,
                               const stick *s, int n, particle *p,
                               int max_iterations, relax_options options)
{
    const int *list = from < 0 ? NULL : l->stick + l->start[from];
    int entries = from < 0 ? n : l->start[from + 1] - l->start[from];
    relax_result r = { .worst = 0 };
    while (r.iterations < max_iterations) {
        int relaxed_before = r.relaxed;
        r.worst = 0;
        for (int i = 0; i < entries; i++)
            relax_one(s[list ? list[i] : i], p, options, &r);
        r.iterations++;
        if (r.worst <= options.tolerance || r.relaxed == relaxed_before) break;
    }
    return r;
}
//<

//> sticks-relax-largest
// The stick with the largest strain, the first of equals; -1 if none has any.
static int most_strained(const stick *s, int n, const particle *p, real *worst)
{
    int most = -1;
    *worst = 0;
    for (int k = 0; k < n; k++) {
        real strain = stick_strain(s[k], p);
        if (strain > *worst) *worst = strain, most = k;
    }
    return most;
}

relax_result sticks_relax_largest(const stick *s, int n, particle *p,
                                  int max_iterations, relax_options options)
{
    relax_result r = { .worst = 0 };
    for (r.iterations = 0; r.iterations < max_iterations; r.iterations++)
        for (int i = 0; i < n; i++) {
            int k = most_strained(s, n, p, &r.worst);
            r.tested += n;
            if (!(r.worst > options.tolerance)) return r;
            if (!stick_relax(s[k], p, options).moved) return r;
            r.relaxed++;
        }
    return r;
}
//<
