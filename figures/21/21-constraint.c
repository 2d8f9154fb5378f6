// 21-constraint.c - what a percent of strain costs: sweeps or small steps, with
// each of the three relaxations, or a direct solve.  A rope of 50 links swings
// from 30 degrees; a free brick, thrown, tumbles.
//
// Columns: n, ns a frame, strain (the largest after the first quarter second,
// median of the frames), energy lost (rope) or angular momentum lost (body), as
// a share.  What exploded is nan.

#include "clock.h"
#include "rigid4.h"
#include "shake.h"
#include "line.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { LINKS = 50, MOST = 64, FRAMES = 120, FIRST = 15, ROUNDS = 9,
       WAYS = 7, SIZES = 7 };
static const char *const NAME[WAYS] = {
    "sweeps exact root", "sweeps approximate root", "sweeps old gradient",
    "substeps exact root", "substeps approximate root", "substeps old gradient",
    "direct"
};
static const vec3 FALL = { 0, -9.81, 0 };

// One of the two, and how it begins.
typedef struct {
    shape plan;
    rigid4 four;
    int is_rope, particles;
    line_scratch *scratch;
    particle p[MOST], start[WAYS * SIZES][MOST];
    real strain[WAYS * SIZES], lost[WAYS * SIZES];
} thing;

static int size_of(int way)         // sweeps or substeps
{
    return 1 << way % SIZES;
}

static int kind_of(int way)
{
    return way / SIZES;
}

static int is_direct(int way)
{
    return kind_of(way) == 6;
}

// Sweeps keep one step a frame, the others take many.
static int substeps_of(int way)
{
    return kind_of(way) < 3 ? 1 : size_of(way);
}

static relax_options options_of(int way)
{
    relax_options o = relax_options_pbd();
    int root = kind_of(way) % 3;
    o.tolerance = 0;
    if (root == 1) o.root = ROOT_APPROXIMATE;
    if (root == 2 || is_direct(way)) o.gradient = GRADIENT_OLD;
    return o;
}

static void hold(thing *t, int way, relax_options o)
{
    int sweeps = kind_of(way) < 3 ? size_of(way) : 1;
    if (!is_direct(way)) {
        for (int k = 0; k < sweeps; k++)
            sticks_iterate(t->plan.stick, t->plan.sticks, t->p, o);
    } else if (t->is_rope) {
        line_solve(shape_strands(&t->plan, 0), t->p, 1, o, t->scratch);
    } else {
        shake(&t->four, t->p, 1, o);
    }
}

static void frame(int way, void *with)
{
    thing *t = with;
    int substeps = substeps_of(way), n = t->particles;
    if (is_direct(way) && !t->is_rope) n = FOUR;
    real h = 1.0 / 60 / substeps;
    relax_options o = options_of(way);
    for (int k = 0; k < substeps; k++) {
        verlet_step(t->p, n, t->is_rope ? FALL : (vec3){ 0, 0, 0 }, NULL, h);
        hold(t, way, o);
    }
}

// What the race repeats: the frame after the first half second.
static void work(int way, void *with)
{
    thing *t = with;
    for (int i = 0; i < t->particles; i++) t->p[i] = t->start[way][i];
    frame(way, with);
}

// ---- the two things --------------------------------------------------------

// Let go at 30 degrees, 1 kg a particle, 1 m long.
static void begin_rope(thing *t, real h)
{
    for (int i = 0; i <= LINKS; i++) {
        real down = (real)i / LINKS;
        vec3 x = { down / 2, -sqrt(0.75) * down, 0 }, rest = { 0, 0, 0 };
        t->p[i] = particle_start(x, rest, FALL, i > 0, h);
    }
}

// With 8 rad/s about a skew axis; a frame turns it by 8 degrees.  The circle's
// own acceleration makes the start one of order 2.
static void begin_body(thing *t, const vec3 *at, real each, real h)
{
    const vec3 spin = { 4, 4 * sqrt(2), 4 };
    for (int i = 0; i < t->particles; i++) {
        vec3 v = vec3_cross(spin, at[i]);
        t->p[i] = particle_start(at[i], v, vec3_cross(spin, v), 1 / each, h);
    }
}

static void begin(thing *t, int way)
{
    real h = 1.0 / 60 / substeps_of(way);
    if (t->is_rope) {
        begin_rope(t, h);
    } else if (is_direct(way)) {
        t->particles = FOUR;
        begin_body(t, t->four.at, t->four.mass, h);
    } else {
        t->particles = t->plan.particles;
        begin_body(t, t->plan.at, t->plan.mass[0], h);
    }
}

static real strain(const thing *t, int way)
{
    int fours = is_direct(way) && !t->is_rope;
    const stick *s = fours ? t->four.stick : t->plan.stick;
    int n = fours ? FOUR_STICKS : t->plan.sticks;
    real most = 0;
    for (int k = 0; k < n; k++) {
        real e = stick_strain(s[k], t->p);
        if (!(e <= most)) most = e;
    }
    return most;
}

// The rope's energy (J) half a step ago; the body's angular momentum, in units
// of the step.
static real kept(const thing *t, real h)
{
    real energy = 0;
    vec3 turning = { 0, 0, 0 };
    for (int i = 0; i < t->particles; i++) {
        const particle *p = &t->p[i];
        if (!(p->inverse_mass > 0)) continue;
        vec3 v = vec3_scale(1 / h, vec3_sub(p->position, p->previous));
        real m = 1 / p->inverse_mass;
        energy += m * (vec3_dot(v, v) / 2
                       + 9.81 * (p->position.y + p->previous.y) / 2);
        turning = vec3_add_scaled(turning, m, vec3_cross(p->position, v));
    }
    return t->is_rope ? energy : vec3_length(turning);
}

// The error of one way, and where its timed frame begins.
static void measure(thing *t, int way)
{
    real e[FRAMES], h = 1.0 / 60 / substeps_of(way);
    // What a rope has to lose: from 30 degrees to hanging still.
    real all = 9.81 * (LINKS + 1) / 2 * (1 - sqrt(0.75));
    begin(t, way);
    real before = t->is_rope ? -sqrt(0.75) * 9.81 * (LINKS + 1) / 2
                             : kept(t, h);
    for (int k = 0; k < FRAMES; k++) {
        if (k == FRAMES / 4)
            for (int i = 0; i < t->particles; i++) t->start[way][i] = t->p[i];
        frame(way, t);
        e[k] = strain(t, way);
    }
    real after = kept(t, h);
    t->strain[way] = clock_median(e + FIRST, FRAMES - FIRST);
    t->lost[way] = (before - after) / (t->is_rope ? all : before);
    if (!(t->strain[way] < 10) || !(fabs(t->lost[way]) < 10))
        t->strain[way] = t->lost[way] = (real)NAN;
}

// ---- the race --------------------------------------------------------------

// The best of some kinds at this strain; its name in *name.
static real best_of(const thing *t, const lap *l, int from, int to, real wanted,
                    const char **name)
{
    real best = HUGE_VAL, seconds[SIZES];
    for (int kind = from; kind < to; kind++) {
        for (int k = 0; k < SIZES; k++)
            seconds[k] = l[kind * SIZES + k].seconds;
        real s = clock_at_error(seconds, &t->strain[kind * SIZES], SIZES,
                                wanted);
        if (s < best) *name = NAME[kind];
        best = fmin(best, s);
    }
    return best;
}

static void print_row(const thing *t, const lap *l, real wanted)
{
    const char *sweeps = NAME[0], *substeps = NAME[3], *direct = NAME[6];
    const char *what = t->is_rope ? "rope" : "free body";
    char error[32];
    real a = best_of(t, l, 0, 3, wanted, &sweeps);
    real b = best_of(t, l, 3, 6, wanted, &substeps);
    real c = best_of(t, l, 6, 7, wanted, &direct);
    snprintf(error, sizeof error, "strain %g", wanted);
    clock_print_row("constraint", what, error, direct, substeps, b / c);
    clock_print_row("constraint", what, error, direct, sweeps, a / c);
}

static void print_thing(thing *t, const char *what)
{
    lap l[WAYS * SIZES];
    for (int way = 0; way < WAYS * SIZES; way++) measure(t, way);
    t->particles = t->plan.particles;
    clock_race((race){ WAYS * SIZES, ROUNDS, 2e-3, work, t }, l);
    for (int way = 0; way < WAYS * SIZES; way++) {
        if (way % SIZES == 0)
            printf("\n\n# %s, %s\n# n ns strain lost\n", what,
                   NAME[kind_of(way)]);
        printf("%d %.4g %.3g %.3g\n", size_of(way), 1e9 * l[way].seconds,
               t->strain[way], t->lost[way]);
    }
    print_row(t, l, 1e-2);
    print_row(t, l, 1e-4);
}

int main(void)
{
    static thing rope = { .is_rope = 1 }, body;
    if (!shape_rope(&rope.plan, LINKS, 1, 1).ok
        || !shape_box(&body.plan, vec3_make(1, 0.7, 0.4), 1).ok
        || !rigid4_build(&body.four, &body.plan).ok) return 1;
    rope.scratch = line_scratch_new(&rope.plan);
    if (!rope.scratch) return 1;
    rope.particles = rope.plan.particles;
    clock_print_head("21-constraint: time and strain of a frame", FLAGS);
    print_thing(&rope, "rope");
    print_thing(&body, "free body");
    line_scratch_free(rope.scratch);
    shape_free(&rope.plan);
    rigid4_free(&body.four);
    shape_free(&body.plan);
    return 0;
}
