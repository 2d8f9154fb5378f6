// soak.c - the room for a million steps: does anything creep, heat, or leak?
//
//   soak STEPS
//
// The first half of the steps leaves a pile alone, that may not sleep: what
// moves, moves by itself.  In the second half it is stirred, every so many
// steps: gravity turns to another wall, or a body is thrown.
// Ends with 0 if all is well, 1 if not, 2 if it was not understood.

#include "ledger.h"
#include "random.h"
#include "world_scene.h"
#include "step.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    BODIES = 50,
    CORNERS = 12,       // of an icosahedron
    STIR = 10000,       // steps from one stir to the next
    SETTLE = 3000       // steps after which a pile lies
};

// What is promised.  Bodies have a radius of 0.5 m and 1 kg: the pile that they
// make has a few hundred joules.
static const real CREEP = 0.005;    // m, an hour: a hundredth of the radius
static const real HEAT = 1e-6;      // J, of a pile that lies
static const real LEAK = 1e-11;     // of all energy that went through the books
static const real DEEP = 0.05;      // of the radius

typedef struct {
    world_scene s;
    long step;
    int  failed;
    unsigned long long seed;
    vec3 lay[BODIES];   // m, where the bodies lay when they had settled
    long settled;       // when that was
    real energy;        // J, in the beginning
    real given;         // J, by what stirred it
    real moved;         // J, that all accounts took or gave
    real hottest, deepest, farthest;    // since the last line was printed
} soak;

// ---- Measuring -------------------------------------------------------------

static void fail(soak *k, const char *what, double got, double target)
{
    printf("step %ld: %s: %g, not %g\n", k->step, what, got, target);
    k->failed++;
}

static vec3 middle(const world *w, int b)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < FOUR; i++)
        sum = vec3_add_scaled(sum, 0.25,
                              w->pool.at[w->body[b].first + i].position);
    return sum;
}

static void keep_places(soak *k)
{
    for (int b = 0; b < BODIES; b++) k->lay[b] = middle(&k->s.world, b);
    k->settled = k->step;
}

// m, the farthest that a body has gone since it lay.
static real crept(const soak *k)
{
    real most = 0;
    for (int b = 0; b < BODIES; b++)
        most = fmax(most, vec3_distance(middle(&k->s.world, b), k->lay[b]));
    return most;
}

static real kinetic(const world *w)
{
    real sum = 0;
    for (int i = 0; i < w->pool.count; i++) {
        const particle *p = &w->pool.at[i];
        real h = body_age(w, w->owner[i]);
        vec3 v = vec3_scale(1 / h, vec3_sub(p->position, p->previous));
        sum += vec3_length_squared(v) / (2 * p->inverse_mass);
    }
    return sum;
}

// What is there, less what was, and was given, and what the books say: of what
// went through them.
static real leak(const soak *k)
{
    real sum = k->energy + k->given;
    for (int who = 0; who < LEDGERS; who++)
        sum += k->s.world.ledger[who].energy;
    return fabs(ledger_total(&k->s.world).energy - sum)
         / (k->moved + fabs(k->energy));
}

// ---- What must hold at every step ------------------------------------------

static void check_body(soak *k, int b)
{
    const world *w = &k->s.world;
    vec3 at[CORNERS];
    world_vertices(w, &w->body[b], at);
    for (int i = 0; i < CORNERS; i++) {
        if (!vec3_is_finite(at[i])) fail(k, "a place that is no number", b, 0);
        for (int p = 0; p < w->planes; p++) {
            real up = vec3_dot(at[i], w->plane[p].normal) - w->plane[p].offset;
            if (up < -k->s.body_radius) fail(k, "outside", up, 0);
        }
    }
    if (rigid4_is_mirrored(w->body[b].rigid, w->pool.at + w->body[b].first))
        fail(k, "mirrored", b, 0);
}

static void check_step(soak *k)
{
    if (k->s.world.report.dropped > 0)
        fail(k, "contacts found no room", k->s.world.report.dropped, 0);
    for (int b = 0; b < BODIES && !k->failed; b++) check_body(k, b);
}

// A pile that lies.
static void check_rest(soak *k)
{
    real hours = (real)(k->step - k->settled) / (60 * 3600), far = crept(k);
    real heat = kinetic(&k->s.world);
    k->farthest = fmax(k->farthest, far);
    k->hottest = fmax(k->hottest, heat);
    if (!(heat <= HEAT)) fail(k, "J in a pile that lies", heat, HEAT);
    if (!(far <= CREEP * fmax(hours, 1)))
        fail(k, "m that a body has crept", far, CREEP * fmax(hours, 1));
}

static void check_seldom(soak *k)
{
    measures m = world_measure(&k->s.world);
    k->deepest = fmax(k->deepest, m.penetration / k->s.body_radius);
    if (!(m.penetration <= DEEP * k->s.body_radius))
        fail(k, "m of penetration", m.penetration, DEEP * k->s.body_radius);
    if (!(m.strain <= 1e-3)) fail(k, "strain", m.strain, 1e-3);
    if (!(leak(k) <= LEAK)) fail(k, "of the energy leaked", leak(k), LEAK);
}

// ---- Stirring --------------------------------------------------------------

// Gravity points to wall n.
static void turn_gravity(world *w, int n)
{
    w->options.gravity = vec3_scale(-9.81, w->plane[n].normal);
}

// Whoever was there a substep ago flies at 10 m/s.
static void throw_one(soak *k)
{
    world *w = &k->s.world;
    const body *b = &w->body[(int)(random_fraction(&k->seed) * BODIES)];
    vec3 way = { random_fraction(&k->seed) - 0.5,
                 random_fraction(&k->seed) - 0.5,
                 random_fraction(&k->seed) - 0.5 };
    way = vec3_scale(10 * body_age(w, (int)(b - w->body)), vec3_unit(way));
    for (int i = b->first; i < b->first + FOUR; i++)
        w->pool.at[i].previous = vec3_sub(w->pool.at[i].previous, way);
}

static void stir(soak *k)
{
    real before = ledger_total(&k->s.world).energy;
    if (random_fraction(&k->seed) < 0.5) throw_one(k);
    else turn_gravity(&k->s.world, (int)(random_fraction(&k->seed) * 6));
    real gave = ledger_total(&k->s.world).energy - before;
    k->given += gave;
    k->moved += fabs(gave);
}

// ---- The run ---------------------------------------------------------------

static void print_line(soak *k)
{
    ledger_entry now = ledger_total(&k->s.world);
    printf("%9ld  %9.3f h  %12.6f J  kinetic %7.1e J  crept %7.1e m  "
           "penetration %7.1e  leak %7.1e\n", k->step,
           (double)k->step / (60 * 3600), now.energy, k->hottest, k->farthest,
           k->deepest, leak(k));
    fflush(stdout);
    k->hottest = k->deepest = k->farthest = 0;
}

static void one_step(soak *k, long steps)
{
    long after = k->step - steps / 2, since;
    if (after >= 0 && after % STIR == 0) stir(k);
    real was[LEDGERS];
    for (int who = 0; who < LEDGERS; who++)
        was[who] = k->s.world.ledger[who].energy;
    world_step(&k->s.world);
    k->step++;
    for (int who = 0; who < LEDGERS; who++)
        k->moved += fabs(k->s.world.ledger[who].energy - was[who]);
    check_step(k);
    since = after < 0 ? k->step : (after + 1) % STIR;
    if (since == SETTLE) keep_places(k);
    if (since > SETTLE) check_rest(k);
    if (k->step % 100 == 0) check_seldom(k);
}

static int start(soak *k)
{
    world_options how = world_scene_options(SCENE_ROOM, 0);
    scene_options what = scene_options_default();
    *k = (soak){ .seed = 1 };
    what.bodies = BODIES;
    how.sleep_speed = 0;
    how.ledger = true;
    status built = world_scene_build(&k->s, SCENE_ROOM, what, how);
    if (!built.ok) fprintf(stderr, "soak: %s\n", built.why);
    else           k->energy = ledger_total(&k->s.world).energy;
    return built.ok;
}

int main(int count, char **word)
{
    static soak k;
    char *end = NULL;
    long steps = count == 2 ? strtol(word[1], &end, 10) : 0;
    if (steps < 1 || *end != '\0') {
        fprintf(stderr, "usage: soak STEPS\n");
        return 2;
    }
    if (!start(&k)) return 2;
    while (k.step < steps && k.failed == 0) {
        one_step(&k, steps);
        if (k.step % 100000 == 0 || k.step == steps) print_line(&k);
    }
    world_scene_free(&k.s);
    printf("soak: %ld steps, %s\n", k.step, k.failed ? "FAILED" : "all well");
    return k.failed > 0;
}
