//> line-rows
// line.c - ropes, and the columns and rows of a cloth, solved at one stroke.
//
// Paper: section 3.2.  Book: chapter 11.

#include "line.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

// So many lines are solved side by side.  Their numbers lie next to each other,
// so that one instruction works on two, four or eight of them.  A rope, which
// is alone, takes one lane.
enum { LANES = 8 };

// A row holds particle k of every lane, and the link from it to particle k + 1.
// A vector takes three fields.
enum {
    PLACE  = 0,         // m
    PUSH   = 3,         // m, the line along which the link pushes its ends
    WEIGHT = 6,         // 1/kg, inverse mass
    SOLVED = 7,         // kg, g of the elimination; then the multiplier
    SHARE  = 8,         // 1 / pivot; then h of the elimination
    FIELDS = 9
};

// Row 0 holds no particle and no link: who asks for the link before the first
// finds zeros.  Particle k is in row k + 1.
struct line_scratch {
    int  particles;     // of the longest line that fits
    real row[];
};
//<

//> line-scratch
line_scratch *line_scratch_new(const shape *s)
{
    size_t longest = 0, most = 0;
    for (int d = 0; d < s->directions; d++) {
        size_t lanes = s->strand[d].lines == 1 ? 1 : LANES;
        size_t rows = (size_t)s->strand[d].particles + 1;
        if (rows > longest) longest = rows;
        if (rows * lanes > most) most = rows * lanes;
    }
    line_scratch *scratch = malloc(sizeof *scratch
                                   + most * FIELDS * sizeof(real));
    if (scratch) scratch->particles = longest > 0 ? (int)longest - 1 : 0;
    return scratch;
}

void line_scratch_free(line_scratch *scratch)
{
    free(scratch);
}
//<

//> line-lane
// A vector in lane l of a row.
static inline vec3 lane_get(const real *row, int field, int lanes, int l)
{
    const real *at = row + field * lanes + l;
    return (vec3){ at[0], at[lanes], at[2 * lanes] };
}

static inline void lane_set(real *row, int field, int lanes, int l, vec3 v)
{
    real *at = row + field * lanes + l;
    at[0] = v.x;
    at[lanes] = v.y;
    at[2 * lanes] = v.z;
}

// The link from the particle of one row to that of the next.
static inline vec3 lane_link(const real *here, const real *after, int lanes,
                             int l)
{
    return vec3_sub(lane_get(after, PLACE, lanes, l),
                    lane_get(here, PLACE, lanes, l));
}
//<

//> line-tally
// What the lanes of a block report.
typedef struct {
    real worst[LANES];  // m^2, the largest |now - rest^2| / 2 before the step
    real sum[LANES];    // m^2, the sum of them
    real far[LANES];    // m^2, the square of the largest move asked for
    real lost[LANES];   // 0; NaN once a place is no number
} tally;

static inline void count_wrong(tally *t, int l, real wrong)
{
    real size = fabs(wrong);
    t->worst[l] = t->worst[l] > size ? t->worst[l] : size;
    t->sum[l] += size;
}

static inline void measure(const real *here, const real *after, int lanes,
                           real rest, tally *t)
{
    for (int l = 0; l < lanes; l++) {
        vec3 link = lane_link(here, after, lanes, l);
        count_wrong(t, l, (vec3_length_squared(link) - rest * rest) / 2);
    }
}
//<

//> line-eliminate
// A pivot below this share of its diagonal is what rounding left of nothing.
static const real NOTHING = 1e-9;

// Row k of the system, and Thomas's step with it (h and g as in the chapter):
//     h_(k-1) = upper_(k-1) / pivot_(k-1)
//     pivot_k = diagonal_k - lower_k h_(k-1)
//     g_k     = (wrong_k - lower_k g_(k-1)) / pivot_k.
// A link without length, between two nails, or that the ones before it leave
// no freedom has no pivot: its multiplier is 0.  A link shorter than
// L / sqrt(3) asks for no more than twice its length.
static inline void eliminate(real *restrict before, real *restrict here,
                             const real *restrict after, int lanes, int old,
                             real rest, tally *restrict t)
{
    for (int l = 0; l < lanes; l++) {
        vec3 link = lane_link(here, after, lanes, l);
        if (!old) lane_set(here, PUSH, lanes, l, link);
        vec3 push = old ? lane_get(here, PUSH, lanes, l) : link;
        real weight = here[WEIGHT * lanes + l];
        real both = weight + after[WEIGHT * lanes + l];
        real now = vec3_length_squared(link);

        real lower = -weight * vec3_dot(link, lane_get(before, PUSH, lanes, l));
        real upper = old ? -weight * vec3_dot(lane_link(before, here, lanes, l),
                                              push)
                         : lower;
        real h = upper * before[SHARE * lanes + l];
        before[SHARE * lanes + l] = h;
        real pivot = both * (old ? vec3_dot(link, push) : now) - lower * h;
        real least = NOTHING * both * now;
        real inverse = pivot > least ? 1 / (pivot > least ? pivot : 1) : 0;
        here[SHARE * lanes + l] = inverse;

        real wrong = (now - rest * rest) / 2;
        count_wrong(t, l, wrong);
        real asked = wrong > -now ? wrong : -now;
        here[SOLVED * lanes + l] =
            (asked - lower * before[SOLVED * lanes + l]) * inverse;
    }
}
//<

//> line-substitute
// What link k + 1, `after`, and link k, `here`, ask of the particle between
// them: w (multiplier_(k+1) push_(k+1) - multiplier_k push_k).
static inline vec3 lane_move(const real *here, const real *after, int lanes,
                             int l)
{
    real weight = after[WEIGHT * lanes + l];
    vec3 d = vec3_scale(weight * after[SOLVED * lanes + l],
                        lane_get(after, PUSH, lanes, l));
    return vec3_add_scaled(d, -weight * here[SOLVED * lanes + l],
                           lane_get(here, PUSH, lanes, l));
}

// Moves it by that share of what they ask.
static inline void move(const real *restrict here, real *restrict after,
                        int lanes, const real *restrict share)
{
    for (int l = 0; l < lanes; l++)
        lane_set(after, PLACE, lanes, l,
                 vec3_add_scaled(lane_get(after, PLACE, lanes, l), share[l],
                                 lane_move(here, after, lanes, l)));
}

// Upwards: the multiplier of link k is g_k - h_k times that of link k + 1; then
// the particle between them knows where to go.
static inline void substitute(real *restrict here, real *restrict after,
                              int lanes, tally *restrict t)
{
    for (int l = 0; l < lanes; l++) {
        here[SOLVED * lanes + l] -= here[SHARE * lanes + l]
                                  * after[SOLVED * lanes + l];
        vec3 d = lane_move(here, after, lanes, l);
        real far = vec3_length_squared(d);
        t->far[l] = t->far[l] > far ? t->far[l] : far;
        vec3 x = vec3_add(lane_get(after, PLACE, lanes, l), d);
        lane_set(after, PLACE, lanes, l, x);
        t->lost[l] += 0 * (x.x + x.y + x.z);
    }
}
//<

//> line-block
// Up to LANES neighbouring lines of a body, on their way through the solver.
typedef struct {
    strands s;
    int  lanes, used;           // 1 or LANES; of them, how many hold a line
    particle *line[LANES];      // where the line of each lane begins
    int  open[LANES];           // 1: not solved yet
    real *row;
    tally t;
    real first[LANES];          // m^2, t.worst before the first step
} block;

static inline real *row_at(const block *b, int lanes, int k)
{
    return b->row + (size_t)(k + 1) * FIELDS * (size_t)lanes;
}

// The lines from number first on.  Lanes beyond the last line hold it again:
// what comes out there is not looked at.
static void block_begin(block *b, particle *p, int first)
{
    int left = b->s.lines - first;
    b->used = left < b->lanes ? left : b->lanes;
    for (int l = 0; l < b->lanes; l++) {
        int line = first + (l < b->used ? l : b->used - 1);
        b->line[l] = p + (size_t)line * (size_t)b->s.across;
        b->open[l] = 1;
    }
}
//<

//> line-load
static inline void load(block *b, int lanes, int old)
{
    int last = b->s.particles - 1;
    size_t along = (size_t)b->s.along;
    for (int f = 0; f < FIELDS * lanes; f++) b->row[f] = 0;
    for (int k = 0; k <= last; k++) {
        real *row = row_at(b, lanes, k);
        for (int l = 0; l < lanes; l++) {
            const particle *p = b->line[l] + (size_t)k * along;
            lane_set(row, PLACE, lanes, l, p->position);
            row[WEIGHT * lanes + l] = p->inverse_mass;
            if (old && k < last)
                lane_set(row, PUSH, lanes, l,
                         vec3_sub(p[along].previous, p->previous));
        }
    }
    // No link leaves the last particle.
    real *end = row_at(b, lanes, last);
    for (int l = 0; l < lanes; l++) {
        b->t.lost[l] = 0;
        lane_set(end, PUSH, lanes, l, (vec3){ 0, 0, 0 });
        end[SOLVED * lanes + l] = 0;
    }
}

static void block_store(const block *b, const int *solved)
{
    size_t along = (size_t)b->s.along;
    for (int k = 0; k < b->s.particles; k++) {
        const real *row = row_at(b, b->lanes, k);
        for (int l = 0; l < b->used; l++)
            if (solved[l])
                b->line[l][(size_t)k * along].position =
                    lane_get(row, PLACE, b->lanes, l);
    }
}
//<

//> line-sweeps
// One loop for each number of lanes and each gradient, so that no loop chooses
// and the compiler knows how many numbers lie side by side.
static void block_eliminate(block *b, int old)
{
    real *row = b->row, rest = b->s.rest_length;
    enum { ONE = FIELDS, ALL = FIELDS * LANES };
    for (int k = 1; k < b->s.particles; k++) {
        if (b->lanes == 1 && old)
            eliminate(row, row + ONE, row + 2 * ONE, 1, 1, rest, &b->t);
        else if (b->lanes == 1)
            eliminate(row, row + ONE, row + 2 * ONE, 1, 0, rest, &b->t);
        else if (old)
            eliminate(row, row + ALL, row + 2 * ALL, LANES, 1, rest, &b->t);
        else
            eliminate(row, row + ALL, row + 2 * ALL, LANES, 0, rest, &b->t);
        row += FIELDS * b->lanes;
    }
}

// The last pair has no link above it: it moves particle 0.
static void block_substitute(block *b)
{
    for (int k = b->s.particles - 2; k >= -1; k--)
        if (b->lanes == 1)
            substitute(row_at(b, 1, k), row_at(b, 1, k + 1), 1, &b->t);
        else
            substitute(row_at(b, LANES, k), row_at(b, LANES, k + 1), LANES,
                       &b->t);
}

static void block_move(block *b, const real *share)
{
    for (int k = b->s.particles - 2; k >= -1; k--)
        if (b->lanes == 1)
            move(row_at(b, 1, k), row_at(b, 1, k + 1), 1, share);
        else
            move(row_at(b, LANES, k), row_at(b, LANES, k + 1), LANES, share);
}
//<

//> line-newton
static void clear(tally *t, int lanes)
{
    for (int l = 0; l < lanes; l++) t->worst[l] = t->sum[l] = t->far[l] = 0;
}

// A line that is nearly straight between two nails hardly answers to its
// multipliers, and they grow without bounds.  To mend all its errors one after
// the other nobody need move farther than their sum; if somebody moved farther
// than that and half a link, the whole line goes back, to the share of the way
// that this allows: so every pull keeps its counterpart.
static void block_step(block *b, int old)
{
    real back[LANES], rest = b->s.rest_length;
    int any = 0;
    clear(&b->t, b->lanes);
    block_eliminate(b, old);
    block_substitute(b);
    for (int l = 0; l < b->lanes; l++) {
        real most = rest / 2 + b->t.sum[l] / rest;
        int is_far = b->t.far[l] > most * most;
        back[l] = is_far ? most / sqrt(b->t.far[l]) - 1 : 0;
        any |= is_far;
    }
    if (any) block_move(b, back);
}

// Newton steps for all lanes, from where the particles are.  Returns how many.
static int block_newton(block *b, int old, int most, real tolerance)
{
    real enough = tolerance * b->s.rest_length * b->s.rest_length;
    if (b->lanes == 1) load(b, 1, old);
    else               load(b, LANES, old);
    for (int done = 1; ; done++) {
        block_step(b, old);
        real worst = 0;
        for (int l = 0; l < b->lanes; l++) {
            if (done == 1) b->first[l] = b->t.worst[l];
            worst = b->t.worst[l] > worst ? b->t.worst[l] : worst;
        }
        if (done == most || worst <= enough) return done;
    }
}
//<

//> line-settle
// Newton's step squares a small error.  One that leaves more than an eighth of
// it did not work, unless what it leaves is rounding: in strain,
static const real ROUNDING = 1e-9;

static void block_measure(block *b)
{
    clear(&b->t, b->lanes);
    for (int k = 0; k + 1 < b->s.particles; k++)
        if (b->lanes == 1)
            measure(row_at(b, 1, k), row_at(b, 1, k + 1), 1,
                    b->s.rest_length, &b->t);
        else
            measure(row_at(b, LANES, k), row_at(b, LANES, k + 1), LANES,
                    b->s.rest_length, &b->t);
}

static void block_judge(const block *b, real tolerance, int *solved)
{
    real enough = fmax(tolerance, ROUNDING) * b->s.rest_length
                                            * b->s.rest_length;
    for (int l = 0; l < b->used; l++)
        solved[l] = b->t.lost[l] == 0
                 && b->t.worst[l] <= fmax(enough, b->first[l] / 8);
}

// Closes the lanes that are solved, and stores them.  Returns how many are
// open still.
static int block_close(block *b, const int *solved, const real *worst,
                       line_result *r)
{
    real rest = b->s.rest_length;
    int open = 0;
    for (int l = 0; l < b->used; l++) {
        if (solved[l]) {
            b->open[l] = 0;
            r->worst = fmax(r->worst, worst[l] / (rest * rest));
        }
        open += b->open[l];
    }
    block_store(b, solved);
    return open;
}
//<

//> line-solve
// Along the old links.  Returns how many lanes are open still.
static int block_solve_old(block *b, int steps, real tolerance, line_result *r)
{
    int solved[LANES];
    real worst[LANES];
    int done = block_newton(b, 1, steps, tolerance);
    for (int l = 0; l < b->used; l++) worst[l] = b->t.worst[l];
    block_measure(b);
    block_judge(b, tolerance, solved);
    if (done > r->steps) r->steps = done;
    return block_close(b, solved, worst, r);
}

// The open lanes along the new ones.  A line whose numbers are lost, or get
// lost, stays as it is.
static void block_solve_new(block *b, int steps, real tolerance, line_result *r)
{
    int solved[LANES];
    int done = block_newton(b, 0, steps, tolerance);
    for (int l = 0; l < b->used; l++)
        solved[l] = b->open[l] && b->t.lost[l] == 0;
    if (done > r->steps) r->steps = done;
    if (block_close(b, solved, b->t.worst, r) > 0) r->worst = HUGE_VAL;
}

line_result line_solve(const strands *s, particle *p, int steps,
                       relax_options options, line_scratch *scratch)
{
    assert(steps >= 1 && options.tolerance >= 0);
    assert(s->particles <= scratch->particles);
    line_result r = { .worst = 0 };
    block b = { .s = *s, .lanes = s->lines == 1 ? 1 : LANES,
                .row = scratch->row };
    for (int first = 0; first < s->lines; first += b.lanes) {
        block_begin(&b, p, first);
        if (options.gradient == GRADIENT_OLD) {
            if (block_solve_old(&b, steps, options.tolerance, &r) == 0)
                continue;
            r.fell_back = 1;
        }
        block_solve_new(&b, steps, options.tolerance, &r);
    }
    return r;
}
//<
