//> sleep-init
//>   Memory for islands and windows.
#include "sleep.h"
#include "table.h"

#include <assert.h>
#include <stdlib.h>

static bool make_sleep_room(sleep_state *s, int room, int particles)
{
    bool ok = true;
    if (room > s->room || !s->parent) {
#define GROW(table) TABLE_GROW(ok, s->table, s->room, room);
        SLEEP_TABLES(GROW, GROW)
#undef GROW
        for (int b = s->room; b < room && ok; b++) s->parent[b] = s->next[b] = b;
        if (ok) s->room = room;
    }
    if (particles > s->particle_room || !s->start[0]) {
        for (int k = 0; k < WINDOWS; k++)
            TABLE_GROW(ok, s->start[k], s->particle_room, particles);
        if (ok) s->particle_room = particles;
    }
    return ok;
}

bool sleep_grow(sleep_state *s, int bodies, int particles)
{
    assert(bodies >= 0 && particles >= 0);
    if (!make_sleep_room(s, table_room(bodies, s->room),
                         table_room(particles, s->particle_room))) return false;
    s->bodies = int_max(s->bodies, bodies);
    s->particles = int_max(s->particles, particles);
    return true;
}

void sleep_free(sleep_state *s)
{
#define FREE(table) free(s->table);
    SLEEP_TABLES(FREE, FREE)
#undef FREE
    for (int k = 0; k < WINDOWS; k++) free(s->start[k]);
    *s = (sleep_state){ .bodies = 0 };
}
//<

//> sleep-touch
//>   Islands are joined by union-find, with path halving.
// The body that stands for b's island.  Every step shortens the way for the
// next one (path halving).  Only such a body is ever given a parent, and one of
// another island: no way leads back, so it ends.
static int island_of(sleep_state *s, int b)
{
    while (s->parent[b] != b) {
        s->parent[b] = s->parent[s->parent[b]];
        b = s->parent[b];
    }
    return b;
}

// Body b takes part in this frame; for a sleeper, the one that stands for all
// that it fell asleep with: contacts between them are not looked for.
static int take_part(sleep_state *s, int b)
{
    if (s->asleep[b]) b = s->island[b];
    if (!s->takes_part[b]) s->member[s->members++] = b;
    s->takes_part[b] = true;
    return b;
}

void sleep_touch(sleep_state *s, int a, int b)
{
    assert(a >= 0 && a < s->bodies && b >= 0 && b < s->bodies);
    int i = island_of(s, take_part(s, a)), j = island_of(s, take_part(s, b));
    s->parent[j] = i;
}

void sleep_begin(sleep_state *s)
{
    for (int k = 0; k < s->members; k++) {
        int b = s->member[k];
        s->takes_part[b] = false;
        s->parent[b] = b;
    }
    s->members = 0;
}
//<

//> sleep-limits
// What is still, for one body.
typedef struct {
    real delta;     // m, in a window
    real speed;     // m/s, now
    real noise;     // m, by which a window may be longer than the one before
    int  frames;    // half a window
} sleep_limits;

static const real EARTH = 9.81, USUAL = 0.5;    // m/s^2, m: see sleep_rule
// Without gravity no speed is slow, and what moves only by rounding still sleeps.
static const real MOTIONLESS = 1e-6;        // tuned, radii: in a window
// By so much more than in the window before may it move, which is no growth: with
// a millionth what_trembles_a_little_sleeps not, with 2.5 times as much what slides
// from rest sleeps.
static const real NOISE = 2e-4;             // tuned, radii
// A mean speed is low while a body rings: at no moment may it be so much higher, nor
// in a window of what stands.
static const real JITTER = 5;               // tuned, times the speed
// So long is it still before it sleeps: for two windows, since one is compared with
// the one before, and each has two halves.
enum { HALVES_TO_SLEEP = 4 };
enum { MOST_FRAMES = 1000000 };

// Froude's scaling: lengths go as R, times as sqrt(R / g), speeds as
// sqrt(g R), and accelerations as g.
real sleep_scaled(real speed, real gravity, real radius)
{
    return speed * sqrt(gravity * radius / (EARTH * USUAL));
}

static sleep_limits limits_of(const sleep_rule *rule, real radius)
{
    real g = rule->gravity, half = rule->time / HALVES_TO_SLEEP;
    real speed = sleep_scaled(rule->speed, g, radius);
    if (g > 0) half *= real_max(1, sqrt(radius * EARTH / (USUAL * g)));
    real frames = real_min(half / rule->dt + 0.5, MOST_FRAMES);
    sleep_limits l = { .frames = int_max((int)frames, 1) };
    real window = 2 * l.frames * rule->dt;
    if (rule->lasts > window) speed *= window / rule->lasts;
    l.delta = real_max(speed * window, MOTIONLESS * radius);
    l.speed = JITTER * l.delta / window;
    l.noise = NOISE * radius;
    return l;
}
//<

//> sleep-observe
//>   Each frame adds what the body has done to its windows.
// The largest distance (m) of n particles from where they were.
static real furthest_moved(const particle *p, const vec3 *from, int n)
{
    real most = 0;
    for (int i = 0; i < n; i++) {
        vec3 d = vec3_sub(p[i].position, from[i]);
        most = real_max(vec3_length_squared(d), most);
    }
    return sqrt(most);
}

// True if none goes further than `far` (m) in a substep, and all are finite.
static bool are_slow(const particle *p, int n, real far)
{
    for (int i = 0; i < n; i++) {
        vec3 d = vec3_sub(p[i].position, p[i].previous);
        if (!(vec3_length_squared(d) <= far * far)) return false;
    }
    return true;
}

// In the window that ends now it stood, or went no further than in the one before;
// or the body is not still.  The first such window counts for two halves, each one
// after that for another half.
static void judge_watch(sleep_watch *watch, int k, const sleep_limits *l)
{
    const sleep_window *w = &watch->window[k];
    bool is_still = watch->stood[k] || w->delta <= w->before + l->noise;
    if (!is_still)              watch->still = 0;
    else if (watch->still == 0) watch->still = 2;
    else                        watch->still++;
}

// A half is over: the older window ends, and begins again.
static void next_half(sleep_state *s, int b, const particle *pool, int first,
                      int n, const sleep_limits *l)
{
    sleep_watch *watch = &s->watch[b];
    int k = watch->halves % WINDOWS;
    sleep_window *w = &watch->window[k];
    if (watch->halves >= WINDOWS) judge_watch(watch, k, l);
    w->before = watch->halves >= WINDOWS ? w->delta : -HUGE_VAL;
    w->delta = 0;
    watch->stood[k] = true;
    for (int i = first; i < first + n; i++) s->start[k][i] = pool[i].position;
    watch->halves++;
    if (watch->halves == 2 * WINDOWS) watch->halves = WINDOWS;
    watch->frames = 0;
}

// Notes how far each window has seen it go.  A window in which it has gone too
// far already needs no more looks.  What stands may go as far as jitter takes it:
// it sways, and comes back.
static void update_windows_of(sleep_state *s, int b, const particle *pool,
                              int first, int n,
                              const sleep_limits *l)
{
    sleep_watch *watch = &s->watch[b];
    for (int k = 0; k < int_min(watch->halves, WINDOWS); k++) {
        sleep_window *w = &watch->window[k];
        watch->stood[k] &= watch->stands;
        real most = watch->stood[k] ? JITTER * l->delta : l->delta;
        if (w->delta <= most)
            w->delta = real_max(furthest_moved(pool + first, s->start[k] + first, n),
                                w->delta);
        if (w->delta > most) watch->is_moving = true;
    }
}

void sleep_observe(sleep_state *s, int b, const particle *pool, int first,
                   int n, real radius, const sleep_rule *rule)
{
    assert(b >= 0 && b < s->bodies && !s->asleep[b]);
    assert(first >= 0 && n >= 0 && n <= s->particles - first);
    sleep_watch *watch = &s->watch[b];
    sleep_limits l = limits_of(rule, radius);
    take_part(s, b);
    if (!(rule->speed > 0)) {
        sleep_forget(s, b);
        return;
    }
    watch->is_moving = !are_slow(pool + first, n, l.speed * rule->h);
    update_windows_of(s, b, pool, first, n, &l);
    if (watch->halves == 0 || ++watch->frames >= l.frames)
        next_half(s, b, pool, first, n, &l);
    if (watch->is_moving) watch->still = 0;
    watch->stands = false;
}

void sleep_stand(sleep_state *s, int b)
{
    assert(b >= 0 && b < s->bodies);
    s->watch[b].stands = true;
}

bool sleep_is_moving(const sleep_state *s, int b)
{
    return s->watch[b].is_moving || s->watch[b].halves == 0;
}
//<

//> sleep-end
//>   An island in which any body is not still stays awake as a whole. What
//>   sleeps together is a ring, and two rings are one when two of their `next`
//>   change places.
// Body b falls asleep with `root`; if it sleeps, with all of its ring.
static void join_ring(sleep_state *s, int b, int root)
{
    int k = b, next = s->next[root];
    do {
        s->island[k] = root;
        k = s->next[k];
    } while (k != b);
    s->next[root] = s->next[b];
    s->next[b] = next;
}

int sleep_end(sleep_state *s)
{
    int fallen = 0;
    for (int k = 0; k < s->members; k++) s->is_restless[s->member[k]] = false;
    for (int k = 0; k < s->members; k++)
        if (s->watch[s->member[k]].still < HALVES_TO_SLEEP)
            s->is_restless[island_of(s, s->member[k])] = true;
    for (int k = 0; k < s->members; k++) {
        int b = s->member[k], root = island_of(s, b);
        if (s->is_restless[root] || (b == root && s->asleep[b])) continue;
        fallen += !s->asleep[b];
        s->asleep[b] = true;
        join_ring(s, b, root);
    }
    s->sleepers += fallen;
    return fallen;
}

void sleep_forget(sleep_state *s, int b)
{
    assert(b >= 0 && b < s->bodies);
    s->watch[b] = (sleep_watch){ .halves = 0 };
}

void sleep_put(sleep_state *s, int b)
{
    assert(b >= 0 && b < s->bodies && !s->asleep[b]);
    s->asleep[b] = true;
    s->sleepers++;
    s->island[b] = b;
    s->watch[b].still = HALVES_TO_SLEEP;
}

void sleep_wake(sleep_state *s, int b)
{
    assert(b >= 0 && b < s->bodies);
    while (s->asleep[b]) {
        int next = s->next[b];
        s->asleep[b] = false;
        s->next[b] = b;
        s->sleepers--;
        sleep_forget(s, b);
        b = next;
    }
}
//<
