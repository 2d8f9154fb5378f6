// 13-passes.c - how passes over the contacts of a stack end, and what it takes
// that they may begin with what they remember.  Nothing but rigid4.h and push.h:
// cubes of 1 m, one on the other, each on four corners, looked at anew in every
// fourth substep.

#include "push.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

// How the passes of a substep go.
typedef enum { FORWARD, BOTH, MOMENTUM, HOWS } way;
static const char *const NAME[HOWS] = {
    "forward only", "forward and backward", "with momentum"
};

enum { CUBES = 20, CORNERS = 4, CONTACTS = CORNERS * CUBES, COLD = 200 };
static const real H = 1.0 / 240, G = 9.81;

typedef struct {
    int cubes, pushes;
    particle p[CUBES * FOUR];
    rigid4_ways ways[CUBES];
    push push[CONTACTS];
    push_drift drift[CUBES + PILE_PARTS];
    int order[CONTACTS];
    push_near near[CONTACTS];
    push_pile pile;
    push_options how;
} stack;

static shape cube;
static rigid4 plan;

static push_side side_of(const stack *s, int b, int v)
{
    push_side x = { .ways = &s->ways[b], .first = FOUR * b, .count = FOUR,
                    .body = b };
    for (int k = 0; k < FOUR; k++) x.share[k] = plan.weight[v][k];
    return x;
}

static real skin(void)
{
    return 0.005 * cube.radius;
}

// The contacts of a new frame, which take over what the old ones remember.
static void find(stack *s)
{
    static const int low[CORNERS] = { 0, 1, 4, 5 };
    static const int high[CORNERS] = { 2, 3, 6, 7 };
    int known = s->pushes > 0, i = 0;
    for (int b = 0; b < s->cubes; b++) {
        const particle *p = s->p + FOUR * b;
        vec3 at[FOUR];
        for (int k = 0; k < FOUR; k++) at[k] = p[k].position;
        rigid4_find_ways(at, p->inverse_mass, &s->ways[b]);
    }
    for (int b = 0; b < s->cubes; b++)
        for (int k = 0; k < CORNERS; k++, i++) {
            push_memory old = push_remember(&s->push[i], H);
            push x = { .thickness = b > 0 ? 2 * skin() : skin(),
                       .near = HUGE_VAL };
            x.a = side_of(s, b, low[k]);
            if (b > 0) x.b = side_of(s, b - 1, high[k]);
            x.fixed = vec3_make(cube.at[low[k]].x, 0, cube.at[low[k]].z);
            push_directions(&x, vec3_make(0, 1, 0));
            if (known) push_recall(&x, &old, H);
            s->push[i] = x;
        }
    s->pushes = i;
}

static vec3 middle_at_start(int b)
{
    return vec3_make(0, 0.5 + b + skin() * (1 + 2 * b), 0);
}

static void build(stack *s, int cubes, real slop)
{
    *s = (stack){ .cubes = cubes,
        .how = { .friction = 0.5, .mend = 0.2, .mend_speed = 3,
                 .slop = slop } };
    for (int b = 0; b < cubes; b++)
        for (int k = 0; k < FOUR; k++) {
            vec3 at = vec3_add(middle_at_start(b), plan.at[k]);
            s->p[FOUR * b + k] = (particle){ at, at, 1 / plan.mass };
        }
    find(s);
}

static void fall(stack *s)
{
    verlet_step(s->p, FOUR * s->cubes, vec3_make(0, -G, 0), NULL, H);
}

// --- passes ------------------------------------------------------------------

// What is pushed once more, and mended.
static void begin(stack *s)
{
    int n = s->pushes;
    for (int k = 0; k < n; k++) s->order[k] = k;
    for (int b = 0; b < s->cubes; b++)
        s->drift[b] = (push_drift){ .stirred = 0 };
    s->pile = (push_pile){ s->push, s->order, { n, n, n }, s->drift, s->cubes,
                           s->near, { 0 } };
    if (!pile_begin(&s->pile, PILE_LEFT, s->p, s->how, H)) return;
    if (pile_mend(&s->pile, PILE_LEFT, s->how))
        pile_settle(&s->pile, PILE_LEFT);
}

static void end(stack *s)
{
    for (int b = 0; b < s->cubes; b++)
        drift_apply(&s->drift[b], &s->ways[b], s->p + FOUR * b);
}

static real lean(stack *s, real pace)
{
    if (pile_leads_on(&s->pile, PILE_LEFT) < 0) pace = 1;
    real next = (1 + sqrt(1 + 4 * pace * pace)) / 2;
    pile_lean(&s->pile, PILE_LEFT, (pace - 1) / next, s->how);
    return next;
}

// The largest change of a gap (m) that is still wanted, from when the substep
// began.
static real wanted(const stack *now)
{
    static stack copy;
    stack *s = &copy;
    real most = 0;
    *s = *now;
    end(s);
    for (int i = 0; i < s->pushes; i++) {
        const push *c = &s->push[i];
        real gap = 0;
        for (int k = 0; k < FOUR; k++) {
            const particle *a = &s->p[c->a.first + k];
            const particle *b = &s->p[c->b.first + k];
            gap += c->a.share[k] * (a->position.y - a->previous.y);
            if (c->b.count > 0)
                gap -= c->b.share[k] * (b->position.y - b->previous.y);
        }
        most = fmax(most, fabs(gap));
    }
    return most;
}

// left: NULL, or where to write what is wanted after each pass.
static void passes(stack *s, way how, int count, real *left)
{
    real pace = 1;
    for (int n = 0; n < count; n++) {
        int back = n % 2 == 1 && how != FORWARD;
        if (how == MOMENTUM && n % 2 == 0 && n > 0) pace = lean(s, pace);
        pile_pass(&s->pile, PILE_LEFT, back ? -1 : 1, 0, s->how);
        if (left) left[n] = wanted(s);
    }
}

// --- one substep that remembers nothing --------------------------------------

static void cold(stack *s)
{
    static real left[HOWS][COLD];
    for (way w = 0; w < HOWS; w++) {
        build(s, CUBES, 0.05);
        fall(s);
        begin(s);
        passes(s, w, COLD, left[w]);
    }
    printf("\n\n# %d cubes, one substep, cold: passes, what is left of "
           "gravity's move, forward only, and back, with momentum\n", CUBES);
    // Even numbers: a pair of passes is whole.
    for (int n = 1; n < COLD; n += 2)
        printf("%d %.4g %.4g %.4g\n", n + 1, left[FORWARD][n] / (G * H * H),
               left[BOTH][n] / (G * H * H), left[MOMENTUM][n] / (G * H * H));
}

// --- ten seconds -------------------------------------------------------------

static void substep(stack *s, way how, int count)
{
    const relax_options relax = { ROOT_EXACT, GRADIENT_OLD, 1e-9, 0 };
    fall(s);
    begin(s);
    passes(s, how, count, NULL);
    end(s);
    for (int b = 0; b < s->cubes; b++)
        rigid4_relax(&plan, s->p + FOUR * b, 6, relax);
}

// mm, the furthest way of a cube in ten seconds, over the number of cubes up to
// it.
static real drift(stack *s, int cubes, way how, int count, real slop)
{
    real most = 0;
    build(s, cubes, slop);
    for (int n = 0; n < 2400; n++) {
        if (n % 4 == 0) find(s);
        substep(s, how, count);
        for (int b = 0; b < cubes; b++) {
            vec3 mean = { 0, 0, 0 };
            for (int k = 0; k < FOUR; k++)
                mean = vec3_add_scaled(mean, 0.25,
                                       s->p[FOUR * b + k].position);
            most = fmax(most, vec3_distance(mean, middle_at_start(b))
                              / (b + 1));
        }
    }
    return 1e3 * most;
}

int main(void)
{
    static stack s;
    if (!shape_box(&cube, vec3_make(1, 1, 1), 1).ok
        || !rigid4_build(&plan, &cube).ok) return 1;
    printf("# stacks of cubes of 1 m, substeps of 1/240 s\n"
           "# compiler: %s\n# flags: %s\n", __VERSION__, FLAGS);
    cold(&s);
    for (way w = 0; w < HOWS; w++) {
        printf("\n\n# %d cubes, 10 s, with memory, %s: passes, drift in mm a "
               "cube\n", CUBES, NAME[w]);
        for (int n = w == FORWARD ? 1 : 2; n <= 32; n *= 2)
            printf("%d %.4g\n", n, drift(&s, CUBES, w, n, 0.05));
    }
    printf("\n\n# 10 cubes, 10 s, passes, drift in mm a cube with a slop of "
           "0.05 and of 0\n");
    for (int n = 2; n <= 32; n *= 2)
        printf("%d %.4g %.4g\n", n, drift(&s, 10, MOMENTUM, n, 0.05),
               drift(&s, 10, MOMENTUM, n, 0));
    rigid4_free(&plan);
    shape_free(&cube);
    return 0;
}
