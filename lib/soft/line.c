//> line-rows
//>   The coordinates of many particles lie apart, each in an array of its own
//>   (*structure of arrays*).
// line.c - ropes, and the columns and rows of a cloth, solved at one stroke.
//
// Paper: section 3.2.  Book: chapter 12.

#include "line.h"
#include "inline.h"
#include "taut.h"

#include <assert.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

// So many lines are solved side by side.  Their numbers lie next to each other,
// so that one instruction works on two, four or eight of them.  A rope, which is
// alone, takes one lane.
enum { LANES = 8 };

static int lanes_for(strands s)
{
    return s.lines < LANES ? 1 : LANES;
}

// Many particles, each coordinate for itself.  The four stand in one piece of
// memory, one after the other, equally far apart.
typedef struct {
    real *x, *y, *z;    // m
    real *weight;       // 1/kg, inverse mass
} places;

// A row of links holds that from particle k of every lane to particle k + 1.
// A vector takes three fields.
enum {
    PUSH   = 0,         // m, the line along which the link pushes its ends
    SOLVED = 3,         // kg, g of the elimination; then the multiplier
    SHARE  = 4,         // 1 / pivot; then h of the elimination
    FIELDS = 5
};
//<

//> line-scratch
//>   All memory of a solve is one block a thread, asked for when the body is
//>   added.
// Row 0 of the links, and of a block's particles, are zeros, for what reads
// the one before the first: link k and particle k are in row k + 1.
struct line_scratch {
    int    particles;   // of the longest line that fits
    int    room;        // particles of the body
    real   lightest;    // 1/kg, the largest inverse mass
    places now, before; // [room] at this step, and a step ago
    places block;       // [(particles + 1) * LANES] of the lines in hand
    real  *link;        // [(particles + 1) * LANES * FIELDS]
    real  *drawn[2];    // [drawn_room] kg m, for each direction, block, link
                        // and lane: how the link has pulled so far
    real   memory[];
};

// Every array begins with a line of the cache, of LINE bytes: a vector that
// lies across two of them is fetched twice.
enum { LINE = 64, IN_LINE = LINE / sizeof(real) };

static real *line_begin(real *memory)
{
    uintptr_t over = (uintptr_t)memory % LINE;
    return over ? memory + (LINE - over) / sizeof(real) : memory;
}

static places cut(real **memory, size_t n)
{
    real *at = *memory;
    n = (n + IN_LINE - 1) / IN_LINE * IN_LINE;
    *memory += 4 * n;
    return (places){ at, at + n, at + 2 * n, at + 3 * n };
}

// The last block of a direction may have lanes that nothing needs.
static size_t drawn_room(const shape *s)
{
    int most = int_max(s->columns, s->rows);
    return (size_t)s->particles + (size_t)(LANES * most);
}

size_t line_scratch_size(const shape *s)
{
    size_t longest = (size_t)int_max(s->columns, s->rows);
    size_t room = longest > 0 ? (size_t)s->particles : 0;
    size_t rows = (longest + 1) * LANES, drawn = room ? drawn_room(s) : 0;
    return sizeof(line_scratch) + sizeof(real) * (8 * room
               + (4 + FIELDS) * rows + 2 * drawn + 13 * IN_LINE);
}

void line_scratch_init(line_scratch *scratch, const shape *s)
{
    size_t longest = (size_t)int_max(s->columns, s->rows);
    size_t room = longest > 0 ? (size_t)s->particles : 0;
    size_t rows = (longest + 1) * LANES, drawn = room ? drawn_room(s) : 0;
    real *memory = line_begin(scratch->memory);
    scratch->particles = (int)longest;
    scratch->room      = (int)room;
    scratch->now    = cut(&memory, room);
    scratch->before = cut(&memory, room);
    scratch->block  = cut(&memory, rows);
    scratch->link   = memory;
    scratch->drawn[0] = memory + FIELDS * rows;
    scratch->drawn[1] = scratch->drawn[0] + drawn;
}

line_scratch *line_scratch_new(const shape *s)
{
    line_scratch *scratch = malloc(line_scratch_size(s));
    if (scratch) line_scratch_init(scratch, s);
    return scratch;
}

void line_scratch_free(line_scratch *scratch)
{
    free(scratch);
}
//<

//> line-gather
//>   Of a particle's seven numbers the solver needs four. They are fetched once
//>   a substep, and brought back at the end.
// Returns the largest weight.
static real gather_line(places to, const particle *p, int n)
{
    real largest = 0;
    for (int i = 0; i < n; i++) {
        to.x[i] = p[i].position.x;
        to.y[i] = p[i].position.y;
        to.z[i] = p[i].position.z;
        to.weight[i] = p[i].inverse_mass;
        largest = to.weight[i] > largest ? to.weight[i] : largest;
    }
    return largest;
}

static void gather_before(places to, const particle *p, int n)
{
    for (int i = 0; i < n; i++) {
        to.x[i] = p[i].previous.x;
        to.y[i] = p[i].previous.y;
        to.z[i] = p[i].previous.z;
    }
}

static void gather_all(line_scratch *scratch, const particle *p, int n,
                       relax_options options)
{
    assert(options.tolerance >= 0 && n <= scratch->room);
    scratch->lightest = gather_line(scratch->now, p, n);
    if (options.gradient == GRADIENT_OLD) gather_before(scratch->before, p, n);
}

static void scatter_line(places from, particle *p, int n)
{
    for (int i = 0; i < n; i++)
        p[i].position = (vec3){ from.x[i], from.y[i], from.z[i] };
}

static inline vec3 place_get(places from, int i)
{
    return (vec3){ from.x[i], from.y[i], from.z[i] };
}

static inline void place_set(places to, int i, vec3 x)
{
    to.x[i] = x.x;
    to.y[i] = x.y;
    to.z[i] = x.z;
}

// The same, from place i on.
static inline places places_from(places p, int i)
{
    return (places){ p.x + i, p.y + i, p.z + i, p.weight + i };
}
//<

//> line-lane
//>   Three small functions read and write the lanes.
// A vector in lane l of a row of links.
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

// The link from particle l of `here`, a row, to the one `pitch` further on.
static inline vec3 lane_link(places here, int pitch, int l)
{
    return vec3_sub(place_get(here, l + pitch), place_get(here, l));
}
//<

//> line-tally
//>   What a block of lines reports while it is solved.
// What the lanes of a block report.
typedef struct {
    real worst[LANES];  // m^2, the largest |now - rest^2| / 2 before the step
    real sum[LANES];    // m^2, the sum of them; of the old gradient only
    real far[LANES];    // m^2, no less than the square of any move; no number
                        // once a place is none
} tally;

// Twice what is wrong, for each link: halved in the end.
static inline void count_wrong(tally *t, int l, real twice, int old)
{
    real size = fabs(twice);
    t->worst[l] = t->worst[l] > size ? t->worst[l] : size;
    if (old) t->sum[l] += size;
}
//<

//> line-eliminate
// A pivot below this share of its diagonal is what rounding left of nothing.
static const real LINE_NOTHING = 1e-9;

static inline vec3 row_link(const real *at, int apart, int pitch, int l)
{
    return vec3_sub(lane_get(at, 0, apart, l + pitch),
                    lane_get(at, 0, apart, l));
}

// What the particles around link k add to row k, and to upper_(k-1).
typedef struct {
    real lower, upper, diagonal;
} entries;

ALWAYS_INLINE entries entries_of(vec3 last, vec3 link, vec3 last_push,
                                 vec3 push, real weight, real both)
{
    return (entries){ weight * vec3_dot(link, last_push),
                      weight * vec3_dot(last, push),
                      both * vec3_dot(link, push) };
}

// m^2, what is wrong with a link that may be longer by `longer` (m), times its
// length.
static inline real wrong_length(real now, real rest, real longer)
{
    real length = sqrt(now);
    return length * (length - rest - longer);
}

// Row k of the system, and Thomas's step with it (h and g as in the chapter,
// but h and lower with the other sign, which spares turning them round):
//     h_(k-1) = upper_(k-1) / pivot_(k-1)
//     pivot_k = diagonal_k - lower_k h_(k-1)
//     g_k     = (wrong_k + lower_k g_(k-1)) / pivot_k.
// h_(k-1) waits until now: along the old links upper_(k-1) needs link k.
// A link without length, between two nails, or that the ones before it leave
// no freedom has no pivot: its multiplier is 0.  A link shorter than about
// L / sqrt(3) asks for no more than twice its length.
// at: the coordinates of a row of particles, `apart` numbers from each other.  drawn:
// how the links have pulled; a pull of 1 stretches them by give.
ALWAYS_INLINE void eliminate_rows(const real *restrict at, int apart, int pitch,
                                  real *restrict before,
                                  int lanes, int old, int gives,
                                  real rest2, real half,
                                  const real *restrict drawn, real give,
                                  tally *restrict t)
{
    real rest = sqrt(rest2);
    real *here = before + FIELDS * lanes;
    for (int l = 0; l < lanes; l++) {
        vec3 link = row_link(at, apart, pitch, l);
        if (!old) lane_set(here, PUSH, lanes, l, link);
        vec3 push = old ? lane_get(here, PUSH, lanes, l) : link;
        vec3 last_push = lane_get(before, PUSH, lanes, l);
        vec3 last = old ? row_link(at, apart, pitch, l - pitch) : last_push;
        const real *w = at + 3 * apart + l;
        real weight = w[0], both = weight + w[pitch];
        real now = vec3_length_squared(link);
        entries e = entries_of(last, link, last_push, push, weight, both);
        if (gives) e.diagonal += give * now;
        real h = (old ? e.upper : e.lower) * before[SHARE * lanes + l];
        before[SHARE * lanes + l] = h;
        real pivot = e.diagonal - e.lower * h;
        real least = LINE_NOTHING * (old ? both * now : e.diagonal);
        real inverse = pivot > least ? 1 / pivot : 0;
        here[SHARE * lanes + l] = inverse;

        real twice = now - rest2;
        if (gives) twice = 2 * wrong_length(now, rest, give * drawn[l]);
        real asked = half * twice;
        count_wrong(t, l, twice, old);
        asked = asked > -now ? asked : -now;
        asked += e.lower * before[SOLVED * lanes + l];
        real solved = asked * inverse;
        here[SOLVED * lanes + l] = solved;
        if (!old) t->far[l] += asked * solved;
    }
}

// Row k of eight, which give or do not: a loop for each, so that none chooses.
// A compiler must assume that two pointers may point to the same thing; `restrict`
// says that they do not, and is surely heard in a function of its own.
NEVER_INLINE void eliminate_eight(const real *restrict at, int apart, int pitch,
                                  real *restrict before,
                                  real rest2, real half,
                                  const real *restrict drawn, real give,
                                  tally *restrict t)
{
    if (give > 0)
        eliminate_rows(at, apart, pitch, before, LANES, 0, 1, rest2, half, drawn, give,
                       t);
    else
        eliminate_rows(at, apart, pitch, before, LANES, 0, 0, rest2, half, drawn, give,
                       t);
}
//<

//> line-substitute
//>   The walk up moves the particles.
// Upwards: the multiplier of link k, `here`, is g_k + h_k times that of link
// k + 1, `after`.  Then the particle between them knows where to go, for link
// k + 1 has left in `pull` what it asks:
//     w (multiplier_(k+1) push_(k+1) - multiplier_k push_k).
ALWAYS_INLINE void substitute(real *restrict x, real *restrict y,
                              real *restrict z, const real *restrict weight,
                              real *restrict here,
                              const real *restrict after, int lanes, int old,
                              real *restrict pull, real *restrict far)
{
    for (int l = 0; l < lanes; l++) {
        real solved = here[SOLVED * lanes + l]
                    + here[SHARE * lanes + l] * after[SOLVED * lanes + l];
        here[SOLVED * lanes + l] = solved;
        vec3 up = lane_get(pull, 0, lanes, l);
        vec3 down = vec3_scale(solved, lane_get(here, PUSH, lanes, l));
        vec3 g = vec3_sub(up, down);
        vec3 d = vec3_scale(weight[l], g);
        lane_set(pull, 0, lanes, l, down);
        if (old) far[l] += vec3_length_squared(d);
        x[l] += d.x;
        y[l] += d.y;
        z[l] += d.z;
    }
}

// As above.
NEVER_INLINE void substitute_eight(real *restrict x, real *restrict y,
                                   real *restrict z, const real *restrict weight,
                                   real *restrict here, const real *restrict after,
                                   real *restrict pull, real *restrict far)
{
    substitute(x, y, z, weight, here, after, LANES, 0, pull, far);
}
//<

//> line-block
//>   Neighbouring columns lie side by side already, and are solved where they
//>   are.
// Up to LANES neighbouring lines of a body, on their way through the solver.
typedef struct {
    strands s;
    const line_scratch *scratch;
    real more;                  // what is asked for, in what is wrong
    int  lanes;                 // 1 or LANES
    int  start;                 // where in the body the line of lane 0 begins
    int  from;                  // lanes before this one are not looked at
    int  old;                   // 1: along the old links; of one lane
    int  in_place;              // 1: solved where the body's places are
    bool may_skip;              // a block that is good
    int  direction;             // of the strands
    real give;                  // 1/kg, by how much (m) a pull of 1 kg m
                                // stretches a link
    real *drawn;                // [links][lanes] kg m, how they have pulled; or
                                // NULL: none asks
    places at;                  // particle k of lane l is number k pitch + l
    int  pitch;
    tally t;
    real first;                 // m^2, of lane 0: t.worst before the first step
} line_block;

static inline real *row_at(const line_block *b, int k)
{
    return b->scratch->link + (k + 1) * FIELDS * b->lanes;
}

// The lines from number first on.  Where fewer are left than it has lanes, it
// begins with lines of the block before: what comes out there is not looked at.
// Along the old links each line is judged for itself, so each is a block.
static void block_begin(line_block *b, int first)
{
    b->lanes = b->old ? 1 : lanes_for(b->s);
    int begin = int_min(first, b->s.lines - b->lanes);
    b->start = begin * b->s.across;
    b->from = first - begin;
    if (b->drawn)
        b->drawn = b->scratch->drawn[b->direction]
                 + first * b->s.particles;
}
//<

//> line-load
//>   Rows lie the other way. Eight of them are turned into columns on their way
//>   into a small block of memory, and back on their way out.
// Neighbouring columns lie side by side in the body, and are solved where they
// are.  Rows, and what must not be solved twice or may have to be taken back
// (the old gradient), are copied.
static int fits_in_place(const line_block *b)
{
    return !b->old && b->from == 0 && (b->lanes == 1 || b->s.across == 1);
}

// One particle of all lanes.
ALWAYS_INLINE void lanes_in(real *restrict to, const real *restrict from,
                            int across, int lanes)
{
    for (int l = 0; l < lanes; l++) to[l] = from[l * across];
}

ALWAYS_INLINE void copy_lanes(const line_block *b, int lanes, places to, places from)
{
    int across = b->s.across;
    from = places_from(from, b->start);
    for (int k = 0; k < b->s.particles; k++) {
        lanes_in(to.x, from.x, across, lanes);
        lanes_in(to.y, from.y, across, lanes);
        lanes_in(to.z, from.z, across, lanes);
        lanes_in(to.weight, from.weight, across, lanes);
        to = places_from(to, lanes);
        from = places_from(from, b->s.along);
    }
}

static void block_copy(const line_block *b, places to, places from)
{
    if (b->lanes == LANES) copy_lanes(b, LANES, to, from);
    else                   copy_lanes(b, 1, to, from);
}

static void block_fetch(line_block *b)
{
    places room = b->scratch->block;
    for (int l = 0; l < b->lanes; l++) place_set(room, l, (vec3){ 0, 0, 0 });
    b->pitch = b->lanes;
    b->at = places_from(room, b->lanes);
    block_copy(b, b->at, b->scratch->now);
}

static void block_load(line_block *b)
{
    int links = b->s.particles - 1, along = b->s.along;
    b->in_place = fits_in_place(b);
    b->pitch = along;
    b->at = places_from(b->scratch->now, b->start);
    if (!b->in_place) block_fetch(b);

    // No link comes before the first, none after the last.
    real *before = row_at(b, -1), *after = row_at(b, links);
    for (int f = 0; f < FIELDS * b->lanes; f++) before[f] = after[f] = 0;
    for (int k = 0; k < links && b->old; k++)
        lane_set(row_at(b, k), PUSH, 1, 0,
                 lane_link(b->scratch->before, along, b->start + k * along));
}

// The lanes that are solved go where they came from.
static void block_store(const line_block *b, const int *solved)
{
    if (b->in_place) return;
    for (int l = 0; l < b->lanes; l++)
        for (int k = 0; k < b->s.particles && solved[l]; k++)
            place_set(b->scratch->now, b->start + k * b->s.along + l * b->s.across,
                      place_get(b->at, k * b->lanes + l));
}
//<

//> line-sweeps
//>   The walk down, and the walk up.
static void block_eliminate(line_block *b)
{
    tally t = { .worst = { 0 } };
    const real *at = b->at.x, *drawn = b->drawn;
    int apart = (int)(b->at.y - b->at.x), pitch = b->pitch, lanes = b->lanes;
    real *row = row_at(b, -1), rest2 = b->s.rest_length * b->s.rest_length;
    real half = b->more / 2;
    for (int k = 1; k < b->s.particles; k++) {
        if (b->old)
            eliminate_rows(at, apart, pitch, row, 1, 1, 0, rest2, half, NULL, 0, &t);
        else if (lanes == 1)
            eliminate_rows(at, apart, pitch, row, 1, 0, b->give > 0, rest2, half, drawn,
                           b->give, &t);
        else
            eliminate_eight(at, apart, pitch, row, rest2, half, drawn, b->give, &t);
        row += FIELDS * lanes;
        at += pitch;
        if (drawn) drawn += lanes;
    }
    for (int l = 0; l < b->lanes; l++) {
        t.worst[l] /= 2;
        t.sum[l] /= 2;
        t.far[l] *= b->scratch->lightest;
    }
    b->t = t;
}

// The last pair has no link above it: it moves particle 0.
static void block_substitute(line_block *b)
{
    real pull[3 * LANES] = { 0 }, far[LANES] = { 0 };
    for (int k = b->s.particles - 1; k >= 0; k--) {
        places at = places_from(b->at, k * b->pitch);
        real *here = row_at(b, k - 1), *after = row_at(b, k);
        if (b->lanes == 1)
            substitute(at.x, at.y, at.z, at.weight, here, after, 1, b->old, pull, far);
        else
            substitute_eight(at.x, at.y, at.z, at.weight, here, after, pull, far);
    }
    for (int l = 0; l < b->lanes && b->old; l++) b->t.far[l] = 0;
    for (int l = 0; l < b->lanes; l++) b->t.far[l] += far[l];
}
//<

//> line-too-far
//>   The limit of Newton's step.
// A line that is nearly straight between two nails hardly answers to its
// multipliers, and they grow without bounds.  To correct all its errors one
// after the other no particle needs to move farther than their sum; if one has
// moved farther than that and half a link, the whole line goes back, to the
// share of the way that this allows: so every pull keeps its counterpart.
static vec3 move_of(const line_block *b, int k, int l)
{
    const real *here = row_at(b, k - 1), *after = row_at(b, k);
    int solved = SOLVED * b->lanes + l;
    vec3 up = vec3_scale(after[solved], lane_get(after, PUSH, b->lanes, l));
    vec3 down = vec3_scale(here[solved], lane_get(here, PUSH, b->lanes, l));
    int i = k * b->pitch + l;
    return vec3_scale(b->at.weight[i], vec3_sub(up, down));
}

// m^2, the sum of what was wrong.  Along the new links it was not counted:
// there each link has left its own in the row.
static real sum_of_wrong(const line_block *b, int l)
{
    real rest = b->s.rest_length, sum = 0;
    if (b->old) return b->t.sum[l];
    for (int k = 0; k + 1 < b->s.particles; k++) {
        vec3 link = lane_get(row_at(b, k), PUSH, b->lanes, l);
        sum += fabs(vec3_length_squared(link) - rest * rest) / 2;
    }
    return sum;
}

static void hold_back(line_block *b, int l)
{
    real rest = b->s.rest_length, far = 0;
    real most = rest / 2 + sum_of_wrong(b, l) / rest;
    for (int k = 0; k < b->s.particles; k++)
        far = fmax(far, vec3_length_squared(move_of(b, k, l)));
    if (!(far > most * most)) return;
    real back = most / sqrt(far) - 1;
    for (int k = 0; k < b->s.particles; k++) {
        int i = k * b->pitch + l;
        place_set(b->at, i, vec3_add_scaled(place_get(b->at, i), back,
                                            move_of(b, k, l)));
    }
    for (int k = 0; k + 1 < b->s.particles; k++)
        row_at(b, k)[SOLVED * b->lanes + l] *= 1 + back;
}

// What the links have pulled is remembered: it is that which stretches them, and
// makes them strings.
static void remember_pulls(const line_block *b, const int *solved)
{
    real *drawn = b->drawn;
    for (int k = 0; k + 1 < b->s.particles; k++)
        for (int l = 0; l < b->lanes; l++, drawn++) {
            const real *row = row_at(b, k);
            vec3 link = lane_get(row, PUSH, b->lanes, l);
            real pull = row[SOLVED * b->lanes + l] * vec3_length(link);
            if (solved[l]) *drawn += pull;
        }
}
//<

//> line-newton
//>   Row k of the system, times its multiplier, summed over all rows, is the sum
//>   of all squared moves, each divided by its inverse mass. Elimination has that
//>   sum at hand: what stood over each pivot, times its g. If it is small, no
//>   particle has gone too far; and a NaN never leaves a sum.
// Where all moves together are short, each is.
static void block_step(line_block *b)
{
    real half = b->s.rest_length / 2;
    block_eliminate(b);
    block_substitute(b);
    for (int l = 0; l < b->lanes; l++)
        if (b->t.far[l] > half * half) hold_back(b, l);
}

// Newton steps for all lanes, from where the particles are.
static void block_newton(line_block *b, int most, real tolerance, line_result *r)
{
    real enough = tolerance * b->s.rest_length * b->s.rest_length;
    block_load(b);
    for (int done = 1; ; done++) {
        real worst = 0;
        block_step(b);
        for (int l = 0; l < b->lanes; l++)
            worst = b->t.worst[l] > worst ? b->t.worst[l] : worst;
        if (done == 1) b->first = b->t.worst[0];
        r->steps = int_max(r->steps, done);
        if (done == most || worst <= enough) return;
    }
}

// A sum with a NaN in it, or out of all bounds.
static int is_line_lost(const line_block *b, int l)
{
    return !(b->t.far[l] < HUGE_VAL);
}
//<

//> line-settle
//>   The judge of the old gradient.
// Newton's step squares a small error.  One that leaves more than an eighth of
// it did not work, unless what it leaves is rounding: in strain,
static const real WORKED = 0.125;           // tuned, 1
static const real LINE_ROUNDING = 1e-9;

static bool has_worked(const line_block *b, real tolerance)
{
    real rest2 = b->s.rest_length * b->s.rest_length, worst = 0;
    for (int k = 0; k + 1 < b->s.particles; k++) {
        vec3 link = lane_link(b->at, b->pitch, k * b->pitch);
        real wrong = fabs(vec3_length_squared(link) - rest2) / 2;
        worst = worst > wrong ? worst : wrong;
    }
    return !is_line_lost(b, 0)
        && worst <= fmax(fmax(tolerance, LINE_ROUNDING) * rest2,
                         WORKED * b->first);
}

// Stores the lanes that are solved.
static void block_close(const line_block *b, const int *solved, line_result *r)
{
    real rest = b->s.rest_length;
    for (int l = 0; l < b->lanes; l++)
        if (solved[l]) r->worst = fmax(r->worst, b->t.worst[l] / (rest * rest));
    if (b->drawn) remember_pulls(b, solved);
    block_store(b, solved);
}
//<

//> line-look
//>   After a few iterations most blocks have converged. To find that out is
//>   cheaper than to solve them.
// Twice what is wrong with eight links whose first ends stand side by side.
static inline void measure_links(places at, int pitch, real rest2,
                                 real worst[LANES], real sum[LANES])
{
    for (int l = 0; l < LANES; l++) {
        real size = fabs(vec3_length_squared(lane_link(at, pitch, l)) - rest2);
        worst[l] = worst[l] > size ? worst[l] : size;
        sum[l] += size;
    }
}

// m^2, the largest |now - rest^2| of a block of lines; HUGE_VAL for NaN.  Columns or
// rows, one of the two lies side by side in the body.
static real block_worst(const line_block *b)
{
    strands s = b->s;
    bool is_across = s.across == 1;
    int links = s.particles - 1, side = is_across ? b->lanes : links;
    int steps = is_across ? links : b->lanes;
    real rest2 = s.rest_length * s.rest_length;
    real worst[LANES] = { 0 }, sum[LANES] = { 0 };
    if (side < LANES) return HUGE_VAL;
    for (int k = 0; k < steps; k++)
        for (int q = 0; q < side; q += LANES) {
            int i = (q < side - LANES ? q : side - LANES)
                  + k * (is_across ? s.along : s.across);
            measure_links(places_from(b->scratch->now, b->start + i), s.along,
                          rest2, worst, sum);
        }
    real most = 0;
    for (int l = 0; l < LANES; l++)
        most = real_max(most, sum[l] < HUGE_VAL ? worst[l] : HUGE_VAL);
    return most;
}

static bool is_good(const line_block *b, real tolerance, line_result *r)
{
    real rest2 = b->s.rest_length * b->s.rest_length;
    real worst = block_worst(b);
    if (!(worst <= 2 * tolerance * rest2)) return false;
    r->worst = fmax(r->worst, worst / (2 * rest2));
    return true;
}
//<

//> line-solve
//>   One direction is solved block by block.
// Along the old links.  False: that did not work, and the line is as it was.
static bool block_solve_old(line_block *b, int steps, real tolerance, line_result *r)
{
    const int solved[LANES] = { 1 };
    block_newton(b, steps, tolerance, r);
    if (!has_worked(b, tolerance)) return false;
    block_close(b, solved, r);
    return true;
}

// A line whose numbers are lost, or get lost, goes back to where it began.
static void block_restore(line_block *b, int l, const particle *p)
{
    for (int k = 0; k < b->s.particles; k++) {
        int i = b->start + l * b->s.across + k * b->s.along;
        place_set(b->scratch->now, i, p[i].position);
    }
}

// Along the new ones.
static void block_solve_new(line_block *b, int steps, real tolerance,
                            const particle *p, line_result *r)
{
    int solved[LANES];
    block_newton(b, steps, tolerance, r);
    for (int l = 0; l < b->lanes; l++) {
        bool lost = l >= b->from && is_line_lost(b, l);
        solved[l] = l >= b->from && !lost;
        if (lost) block_restore(b, l, p);
        if (lost) r->worst = HUGE_VAL;
    }
    block_close(b, solved, r);
}

// All lines of the direction b.s, from the places to the places; p is where
// they were when the places were gathered.
static void solve_lines(line_block b, const particle *p, int steps,
                        relax_options options,
                        line_result *r)
{
    assert(b.s.particles <= b.scratch->particles);
    for (int first = 0; first < b.s.lines; first += b.lanes) {
        b.old = options.gradient == GRADIENT_OLD;
        block_begin(&b, first);
        if (b.may_skip && is_good(&b, options.tolerance, r)) continue;
        if (b.old && block_solve_old(&b, steps, options.tolerance, r)) continue;
        r->fell_back |= b.old;
        b.old = 0;
        block_solve_new(&b, steps, options.tolerance, p, r);
    }
}
//<

//> line-strands
//>   From a cloth's columns and rows follow its lines.
int shape_directions(const shape *s)
{
    return (s->rows > 1) + (s->columns > 1);
}

// The links of the columns stand first in the list of sticks, then those of the
// rows; a rope is a cloth of one row.
strands shape_strands(const shape *s, int direction)
{
    int c = s->columns, r = s->rows;
    if (r > 1 && direction == 0)
        return (strands){ c, r, 1, c, s->stick[0].rest_length };
    return (strands){ r, c, c, 1, s->stick[c * (r - 1)].rest_length };
}

int shape_links(const shape *s)
{
    return s->columns * (s->rows - 1) + s->rows * (s->columns - 1);
}

real shape_width(const shape *s, int direction)
{
    if (shape_directions(s) < 2) return 1;
    strands other = shape_strands(s, 1 - direction);
    real lines = shape_strands(s, direction).lines;
    return other.rest_length * (lines - 1) / lines;
}
//<

//> line-hold
//>   What touches something is heavy before the first iteration. Afterwards the
//>   pulls are read off the moves.
static void hold_begin(const shape *s, line_scratch *scratch, const line_hold *hold)
{
    for (int i = 0; i < s->particles; i++)
        scratch->now.weight[i] *= hold_share(&hold[i]);
}

// p: as they were before.  A free particle would have been moved by the move divided by
// its share.  Of that so much is remembered that nothing overshoots: what is given in
// advance moves the strands, too.
static void hold_end(const shape *s, const line_scratch *scratch, const particle *p,
                     line_hold *hold)
{
    for (int i = 0; i < s->particles; i++) {
        line_hold *h = &hold[i];
        vec3 d = vec3_sub(place_get(scratch->now, i), p[i].position);
        real newer = real_min(hold_share(h), 0.5);
        d = vec3_scale(newer / hold_share(h), d);
        h->pull = vec3_add_scaled(d, 1 - newer, h->pull);
    }
}
//<

//> line-give
//>   How much a link gives way, if what it is made of is elastic.
real links_energy(const shape *s, real compliance, const particle *p)
{
    real sum = 0;
    for (int d = 0; d < shape_directions(s) && compliance > 0; d++) {
        strands of = shape_strands(s, d);
        real give = compliance * of.rest_length / shape_width(s, d);
        for (int line = 0; line < of.lines; line++)
            for (int k = 0; k + 1 < of.particles; k++) {
                const particle *a = p + line * of.across + k * of.along;
                real length = vec3_distance(a->position,
                                            a[of.along].position);
                real longer = length - of.rest_length;
                sum += longer * longer / (2 * give);
            }
    }
    return sum;
}

static void forget_pulls(const shape *s, line_scratch *scratch)
{
    size_t n = 2 * drawn_room(s);
    for (size_t i = 0; i < n; i++) scratch->drawn[0][i] = 0;
}
//<

//> line-taut
// How a line has pulled, link after link, each `lanes` numbers from the last.
static real *drawn_of(const line_scratch *scratch, strands x, int d, int line,
                      int *lanes)
{
    int first = x.lines < LANES ? line : line / LANES * LANES;
    *lanes = lanes_for(x);
    int begin = int_min(first, x.lines - *lanes);
    return scratch->drawn[d] + first * x.particles + line - begin;
}

// Is a link of the line so taut, if it joins the lightest particles of all?
static bool may_be_taut(strands x, int d, const line_hold *hold, real most)
{
    real hardest = 0;
    for (int k = 0; k + 1 < x.particles; k++) {
        real push = hold[k * x.along].push[d];
        hardest = push > hardest ? push : hardest;
    }
    return hardest > most * x.rest_length && hardest < HUGE_VAL;
}

// By how much each link, as it was a substep ago, is tauter than an explicit
// step bears.
static void find_stiffness(const shape *s, int d, const particle *p,
                           const line_hold *hold, real *stiffness)
{
    strands x = shape_strands(s, d);
    for (int k = 0; k + 1 < x.particles; k++) {
        const particle *a = p + k * x.along, *b = a + x.along;
        real w = real_max(a->inverse_mass, b->inverse_mass), more = 0;
        real length = vec3_distance(a->previous, b->previous);
        if (w > 0 && length > 0)
            more = hold[k * x.along].push[d] / length
                 - taut_most(w, shape_directions(s));
        stiffness[k] = real_max(more, 0);
    }
}

// What it has pulled then is known to the links, as if they had done it.
static void step_string(const shape *s, const line_scratch *scratch, int d,
                        int line, const particle *p, const line_hold *hold)
{
    strands x = shape_strands(s, d);
    int first = line * x.across, lanes;
    places at = places_from(scratch->now, first);
    real *drawn = drawn_of(scratch, x, d, line, &lanes);
    real *stiffness = scratch->link;
    find_stiffness(s, d, p + first, hold + first, stiffness);
    taut_step((taut_string){ x.particles, x.along, at.x, at.y, at.z, at.weight,
                             stiffness }, stiffness + x.particles);
    for (int k = 0; k + 1 < x.particles; k++)
        drawn[k * lanes] = stiffness[k]
                         * vec3_length(lane_link(at, x.along, k * x.along));
}

static void step_strings(const shape *s, const line_scratch *scratch,
                         const particle *p, const line_hold *hold)
{
    if (!(scratch->lightest > 0)) return;
    real most = taut_most(scratch->lightest, shape_directions(s));
    for (int d = 0; d < shape_directions(s); d++) {
        strands x = shape_strands(s, d);
        for (int line = 0; line < x.lines; line++) {
            if (!may_be_taut(x, d, hold + line * x.across, most)) continue;
            step_string(s, scratch, d, line, p, hold);
        }
    }
}

static void remember_strings(const shape *s, const line_scratch *scratch,
                             line_hold *hold)
{
    for (int d = 0; d < shape_directions(s); d++) {
        strands x = shape_strands(s, d);
        for (int line = 0; line < x.lines; line++) {
            int lanes;
            const real *drawn = drawn_of(scratch, x, d, line, &lanes);
            line_hold *first = hold + line * x.across;
            for (int k = 0; k + 1 < x.particles; k++)
                first[k * x.along].push[d] = drawn[k * lanes];
        }
    }
}
//<

//> line-relax
//>   Then the directions take turns, until nothing is off by more than the
//>   tolerance. In a cloth such a step costs what one iteration over its links
//>   costs (chapter 21), and gives the answer that thousands would not.
line_result line_solve(strands s, particle *p, int steps,
                       relax_options options, line_scratch *scratch)
{
    assert(steps >= 1);
    line_result r = { .worst = 0 };
    int last = (s.lines - 1) * s.across + (s.particles - 1) * s.along;
    gather_all(scratch, p, last + 1, options);
    solve_lines((line_block){ .s = s, .scratch = scratch, .more = 1 }, p, steps,
                options, &r);
    scatter_line(scratch->now, p, last + 1);
    return r;
}

// What one direction of a cloth does the other half undoes: sweep after sweep.
// All but the last ask for more than the error; where threads give, the first does
// not, for most lines are good after it.  (Along the old links a larger error would
// be taken for failure.)  A rope has only one
// direction, and no need; it takes more than a step only where it touches
// something.
static const real MORE = 1.2;               // tuned, 1

line_result lines_relax(const shape *s, particle *p, int fewest, int sweeps,
                        relax_options options, line_hold *hold, real give,
                        line_scratch *scratch)
{
    assert(sweeps >= 1 && give >= 0);
    line_result r = { .worst = 0 };
    int directions = shape_directions(s), done = 0;
    int most = directions > 1 || hold ? sweeps : 1;
    if (give > 0) options.gradient = GRADIENT_NEW;
    int is_new = options.gradient == GRADIENT_NEW;
    bool is_drawn = give > 0 || (hold && directions == 1), is_done;
    gather_all(scratch, p, s->particles, options);
    if (hold) hold_begin(s, scratch, hold);
    if (is_drawn) forget_pulls(s, scratch);
    if (is_drawn && hold) step_strings(s, scratch, p, hold);
    do {
        bool asks_more = directions > 1 && (done > 0 || !(give > 0));
        real more = is_new && asks_more && done + 1 < most ? MORE : 1;
        r.worst = 0;
        line_block b = { .scratch = scratch, .more = more,
                    .may_skip = directions > 1 && done > 0 };
        for (b.direction = 0; b.direction < directions; b.direction++) {
            b.s = shape_strands(s, b.direction);
            b.drawn = is_drawn ? scratch->drawn[b.direction] : NULL;
            b.give = give * b.s.rest_length / shape_width(s, b.direction);
            solve_lines(b, p, 1, options, &r);
        }
        is_done = r.worst <= options.tolerance && done + 1 >= fewest;
    } while (++done < most && !is_done);
    if (hold) hold_end(s, scratch, p, hold);
    if (is_drawn && hold) remember_strings(s, scratch, hold);
    scatter_line(scratch->now, p, s->particles);
    r.steps = done;
    return r;
}
//<
