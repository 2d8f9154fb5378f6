//> passes-lane
//>   First the blocks are made. A contact whose A yields to no push is turned
//>   round, so that A always yields.
#include "passes.h"

#ifndef PASSES
#define PASSES passes_narrow    // see passes_wide.c
#endif

// A contact on its way into a lane of a block, turned so that A yields.
typedef struct {
    int  a, b;
    vec3 normal, across, aside;
    real across_impulse, aside_impulse, twist;
    real radius, per_near, round_a, round_b, height;
    real has[CONTACT_POINTS], own[CONTACT_POINTS];
    real impulse[CONTACT_POINTS];
    vec3 local_a[CONTACT_POINTS], local_b[CONTACT_POINTS];
} lane_source;

// Two unit vectors across n, fixed by n alone.
static void choose_lane_across(lane_source *q, vec3 friction)
{
    vec3 n = q->normal;
    real x = fabs(n.x), y = fabs(n.y), z = fabs(n.z);
    vec3 least = { x <= y && x <= z, y < x && y <= z, z < x && z < y };
    q->across = vec3_unit(vec3_cross(n, least));
    q->aside = vec3_cross(n, q->across);
    q->across_impulse = vec3_dot(friction, q->across);
    q->aside_impulse = vec3_dot(friction, q->aside);
}

// A contact that has fewer points than its block has none there.
static void choose_points(lane_source *q, const contact *c,
                          const active_contact *x, real warm)
{
    for (int j = 0; j < x->count; j++) {
        int k = x->point[j];
        const contact_point *p = &c->point[k];
        q->local_a[j] = x->is_swapped ? p->local_b : p->local_a;
        q->local_b[j] = x->is_swapped ? p->local_a : p->local_b;
        q->own[j] = x->is_swapped ? 1 - p->own : p->own;
        q->has[j] = 1;
        q->impulse[j] = warm * c->impulse[k];
    }
}

// A contact whose A does not yield is solved the other way round: its normal,
// and what acts along it, change sign; a twist does not, for both its axis and
// the bodies change places.  A gap of one part of the radius in NEAR is near.
static const real NEAR = 25;                // tuned, 1

static void choose_lane(lane_source *q, const contact *c,
                        const active_contact *x, const solver_frame *f,
                        int spare)
{
    real sign = x->is_swapped ? -1 : 1, warm = f->warm * f->h / active_age(x, f);
    *q = (lane_source){ .a = x->a, .b = spare };
    if (x->sides != ONE_SIDED) q->b = x->b;
    q->normal = vec3_scale(sign, c->normal);
    q->radius = active_radius(x, f);
    q->per_near = NEAR / q->radius;
    q->round_a = x->is_swapped ? c->round_b : c->round_a;
    q->round_b = x->is_swapped ? c->round_a : c->round_b;
    q->height = c->b < 0 ? f->plane[-1 - c->b].offset : 0;
    q->twist = x->count > 1 ? warm * c->twist : 0;
    choose_lane_across(q, vec3_scale(sign * warm, c->friction));
    choose_points(q, c, x, warm);
}
//<

//> passes-transpose
// One number of each of four lanes, side by side.  (Not stored one by one: a
// processor waits long for what it has stored in parts and loads as a whole.)
#define LANES(q, number) \
    real4_make((q)[0] number, (q)[1] number, (q)[2] number, (q)[3] number)

#define LANES3(to, q, vector)               \
    do {                                    \
        (to)[0] = LANES(q, vector.x);       \
        (to)[1] = LANES(q, vector.y);       \
        (to)[2] = LANES(q, vector.z);       \
    } while (0)

static void transpose_place(block_place *p, const lane_source q[REAL4], int j)
{
    LANES3(p->local_a, q, .local_a[j]);
    LANES3(p->local_b, q, .local_b[j]);
    p->own = LANES(q, .own[j]);
    p->has = LANES(q, .has[j]);
    p->blow = real4_all(0);
}

static void transpose(block *k, const lane_source q[REAL4])
{
    LANES3(k->normal, q, .normal);
    LANES3(k->across[0], q, .across);
    LANES3(k->across[1], q, .aside);
    k->rub[0] = LANES(q, .across_impulse);
    k->rub[1] = LANES(q, .aside_impulse);
    k->rub[TWIST] = LANES(q, .twist);
    k->per_near = LANES(q, .per_near);
    k->radius = LANES(q, .radius);
    k->round_a = LANES(q, .round_a);
    k->round_b = LANES(q, .round_b);
    k->height = LANES(q, .height);
    k->is_round = real4_any(real4_add(k->round_a, k->round_b));
    for (int j = 0; j < k->points; j++) {
        transpose_place(&k->place[j], q, j);
        k->point[j].impulse = LANES(q, .impulse[j]);
    }
}
//<

//> passes-stand
//>   Where do the bodies of a block stand now? Arms and gaps follow from it. Of
//>   what lies, and of what touches a driven body that turns, arms are taken
//>   elsewhere (chapter 18).
// The frames and the turns of four bodies.
typedef struct {
    real4 center[3], axis[FOUR_AXES][3], turn[TURNS][3], inverse;
} bodies4;

// A lane that is left over is of a body that weighs a kilogram; a plane does
// not move, and has a height.
static const solver_body LIGHT = { .basis = { .inverse_mass = 1 } };
static const solver_body NOWHERE = { .basis = { .inverse_mass = 0 } };

static inline const solver_body *a_of(const block *k, const solver_frame *f,
                                      int lane)
{
    return k->contact[lane] < 0 ? &LIGHT : &f->body[k->a[lane]];
}

// Its B: -1 where it is a plane, or the lane is left over.
static inline int number_of_b(const contact_solver *s, const block *k, int lane)
{
    return k->contact[lane] < 0 ? -1 : s->active[k->contact[lane]].b;
}

static inline const solver_body *b_of(const contact_solver *s, const block *k,
                                      const solver_frame *f, int lane)
{
    int b = number_of_b(s, k, lane);
    return b < 0 ? &NOWHERE : &f->body[b];
}

static void take_frames(bodies4 *to, const rigid_frame *const from[REAL4])
{
    LANES3(to->center, from, ->center);
    for (int i = 0; i < FOUR_AXES; i++) LANES3(to->axis[i], from, ->axis[i]);
}

static void take_turns(bodies4 *to, const motion_basis *const from[REAL4])
{
    for (int t = 0; t < TURNS; t++) LANES3(to->turn[t], from, ->turn[t]);
    to->inverse = LANES(from, ->inverse_mass);
}

// m, from the centres.
static inline void find_arm(real4 arm[3], const bodies4 *b,
                            const real4 local[3])
{
    for (int i = 0; i < 3; i++) {
        arm[i] = real4_mul(local[0], b->axis[0][i]);
        for (int k = 1; k < FOUR_AXES; k++)
            arm[i] = real4_mad(local[k], b->axis[k][i], arm[i]);
    }
}

// What the rows of a block are made of.
typedef struct {
    bodies4 a, b;
    real4 delta[3];             // m, from B's centre to A's
    real4 arm_a[CONTACT_POINTS][3], arm_b[CONTACT_POINTS][3];   // m
} raw_block;

// As contact_arms_of has them: one place for both.
static inline void share_arms(raw_block *raw, real4 own, int j)
{
    for (int i = 0; i < 3; i++) {
        real4 seen = real4_sub(raw->arm_b[j][i], raw->delta[i]);
        real4 off = real4_sub(raw->arm_a[j][i], seen);
        raw->arm_a[j][i] = real4_mad(own, off, seen);
        raw->arm_b[j][i] = real4_add(raw->arm_a[j][i], raw->delta[i]);
    }
}

static void find_arms(const block *k, raw_block *raw)
{
    real4 minus_a = real4_sub(real4_all(0), k->round_a);
    for (int i = 0; i < 3; i++)
        raw->delta[i] = real4_sub(raw->a.center[i], raw->b.center[i]);
    for (int j = 0; j < k->points; j++) {
        find_arm(raw->arm_a[j], &raw->a, k->place[j].local_a);
        find_arm(raw->arm_b[j], &raw->b, k->place[j].local_b);
        if (k->is_round) {
            real4_add3(raw->arm_a[j], k->normal, minus_a);
            real4_add3(raw->arm_b[j], k->normal, k->round_b);
        }
    }
}

// The arms are of both sides still, each to its own surface.
static void find_gaps(block *k, const raw_block *raw)
{
    for (int j = 0; j < k->points; j++) {
        real4 d[3];
        for (int i = 0; i < 3; i++)
            d[i] = real4_add(raw->delta[i], real4_sub(raw->arm_a[j][i],
                                                      raw->arm_b[j][i]));
        k->point[j].gap = real4_sub(real4_dot(k->normal, d), k->height);
        k->point[j].now = k->point[j].gap;
    }
}

// What an impact put back stands, until the substep is over, where it has not been:
// a gap that is closed there, and was open, is as it was.
static inline void keep_open(block *k, const real4 was[CONTACT_POINTS])
{
    for (int j = 0; j < k->points; j++) {
        block_point *p = &k->point[j];
        real4 kept = real4_if_positive(was[j], was[j], p->gap);
        p->gap = p->now = real4_if_positive(p->gap, p->gap, kept);
    }
}

static inline void take_gaps(const block *k, real4 gap[CONTACT_POINTS])
{
    for (int j = 0; j < k->points; j++) gap[j] = k->point[j].gap;
}

// The arms, where the bodies stand now; or, for rows, elsewhere, if one of them
// lies or touches a driven body that turns.
static inline void take_arms(const contact_solver *s, const block *k,
                             const solver_frame *f, raw_block *raw,
                             bool is_elsewhere)
{
    const rigid_frame *a[REAL4], *b[REAL4];
    bool some = !is_elsewhere;
    for (int l = 0; l < REAL4; l++) {
        int at_a = k->contact[l] < 0 ? -1 : k->a[l], at_b = number_of_b(s, k, l);
        bool from_a = is_elsewhere && at_a >= 0 && f->is_elsewhere[at_a];
        bool from_b = is_elsewhere && at_b >= 0 && f->is_elsewhere[at_b];
        some |= from_a || from_b;
        a[l] = from_a ? &f->rows_at[at_a] : &a_of(k, f, l)->frame;
        b[l] = from_b ? &f->rows_at[at_b] : &b_of(s, k, f, l)->frame;
    }
    if (!some) return;
    take_frames(&raw->a, a);
    take_frames(&raw->b, b);
    find_arms(k, raw);
}

static void update_gaps_of(const contact_solver *s, block *k,
                           const solver_frame *f, raw_block *raw)
{
    take_arms(s, k, f, raw, false);
    find_gaps(k, raw);
}

static bool lane_rests(const solver_frame *f, const contact_solver *s,
                       const block *k, int lane, int b)
{
    return f->lying && k->contact[lane] >= 0 && b != s->room
        && f->is_elsewhere[b] == LIES;
}

// Do all bodies lie, with all gaps closed?  Then nothing that rows are made of
// changes, in this frame or the next.
static bool all_rest(const contact_solver *s, const block *k,
                     const solver_frame *f)
{
    const real4 one = real4_all(1), zero = real4_all(0);
    real4 open = zero;
    if (!f->lying) return false;
    for (int l = 0; l < REAL4; l++) {
        if (k->contact[l] < 0) continue;
        if (!lane_rests(f, s, k, l, k->a[l])) return false;
        if (k->two && !lane_rests(f, s, k, l, k->b[l])) return false;
    }
    for (int j = 0; j < k->points; j++) {
        real4 gap = real4_mul(k->point[j].gap, k->per_near);
        gap = real4_mul(k->place[j].has, real4_sub(gap, one));
        open = real4_max(open, gap);
    }
    return !real4_any(open);
}

// Is one body of a contact heavier than the other, by more than rounding?  A mass M
// that is put on m falls at up to sqrt(M / m) g h until the warm start bears it
// (chapter 15).  What closes twice as fast is a blow.  (Of like bodies a pass takes
// most of a blow.)
static void find_uneven(block *k)
{
    k->uneven = k->closing = real4_all(0);
    k->is_uneven = false;
    for (int l = 0; l < REAL4 && k->two && !k->is_driven; l++) {
        real a = real4_get(&k->inverse_a, l), b = real4_get(&k->inverse_b, l);
        real ratio = a > b ? a / b : b / a;
        if (k->contact[l] < 0 || !(ratio > 1 + 0x1p-40)) continue;
        real4_set(&k->uneven, l, sqrt(ratio));
        k->is_uneven = true;
    }
}

static void stand_block(const contact_solver *s, block *k, const solver_frame *f,
                        raw_block *raw)
{
    const motion_basis *a[REAL4], *b[REAL4];
    update_gaps_of(s, k, f, raw);
    for (int l = 0; l < REAL4; l++) {
        a[l] = &a_of(k, f, l)->basis;
        b[l] = &b_of(s, k, f, l)->basis;
        if (lane_rests(f, s, k, l, k->a[l])) a[l] = &f->lying[k->a[l]];
        if (lane_rests(f, s, k, l, k->b[l])) b[l] = &f->lying[k->b[l]];
    }
    take_turns(&raw->a, a);
    if (k->two) take_turns(&raw->b, b);
    k->inverse_a = raw->a.inverse;
    k->inverse_b = k->two ? raw->b.inverse : real4_all(0);
    if (f->is_elsewhere) take_arms(s, k, f, raw, true);
    for (int j = 0; j < k->points; j++) share_arms(raw, k->place[j].own, j);
}
//<

//> passes-rows
// Returns the square of the row, in 1/kg: what a unit impulse with this moment
// (m) does along itself by turning the body.
static inline real4 make_row(real4 row[TURNS], real4 turn[TURNS][3],
                             const real4 moment[3])
{
    for (int t = 0; t < TURNS; t++) row[t] = real4_dot(turn[t], moment);
    return real4_dot(row, row);
}

// Of a body that does not move no row is read.
ALWAYS_INLINE real4 make_rows(real4 row_a[TURNS], real4 row_b[TURNS],
                              raw_block *raw, const real4 arm_a[3],
                              const real4 arm_b[3], const real4 along[3],
                              bool two)
{
    real4 moment[3];
    real4_cross(arm_a, along, moment);
    real4 square = make_row(row_a, raw->a.turn, moment);
    if (!two) return square;
    real4_cross(arm_b, along, moment);
    return real4_add(square, make_row(row_b, raw->b.turn, moment));
}

// Friction acts where the points are that touch, of both bodies at one place; one
// that is wide open counts for little.
static const real OPEN = 0.01;              // tuned, 1

static inline void find_center(const block *k, const raw_block *raw,
                               real4 center_a[3], real4 center_b[3])
{
    const real4 zero = real4_all(0), one = real4_all(1);
    real4 sum = zero;
    for (int i = 0; i < 3; i++) center_a[i] = zero;
    for (int j = 0; j < k->points; j++) {
        real4 open = real4_mul(k->point[j].gap, k->per_near);
        real4 fraction = real4_sub(real4_all(2), open);
        fraction = real4_min(one, real4_max(fraction, real4_all(OPEN)));
        fraction = real4_mul(fraction, k->place[j].has);
        sum = real4_add(sum, fraction);
        real4_add3(center_a, raw->arm_a[j], fraction);
    }
    real4 per_sum = real4_div(one, real4_if_positive(sum, sum, one));
    for (int i = 0; i < 3; i++) {
        center_a[i] = real4_mul(center_a[i], per_sum);
        center_b[i] = real4_add(center_a[i], raw->delta[i]);
    }
}

// The effective mass is 1 / K, K = how far a unit impulse parts the points.
ALWAYS_INLINE void make_points(block *k, raw_block *raw, real4 inverse,
                               const real4 center_a[3], bool two)
{
    for (int j = 0; j < k->points; j++) {
        block_point *p = &k->point[j];
        real4 d[3], square = make_rows(p->turn_a, p->turn_b, raw,
                                       raw->arm_a[j], raw->arm_b[j],
                                       k->normal, two);
        for (int i = 0; i < 3; i++)
            d[i] = real4_sub(raw->arm_a[j][i], center_a[i]);
        p->lever = real4_sqrt(real4_dot(d, d));
        p->mass = real4_div(k->place[j].has, real4_add(inverse, square));
    }
}

// Both directions are solved at once, with the inverse of
//     | K00 K01 |        K_ij = how far a unit impulse along j moves the points
//     | K01 K11 |        along i.
ALWAYS_INLINE void make_friction(block *k, raw_block *raw, real4 inverse,
                                 const real4 center_a[3],
                                 const real4 center_b[3], bool two)
{
    real4 own[2], twist, *mass = k->across_mass;
    for (int i = 0; i < 2; i++)
        own[i] = real4_add(inverse, make_rows(k->rub_a[i], k->rub_b[i],
                                              raw, center_a, center_b,
                                              k->across[i], two));
    real4 cross = real4_dot(k->rub_a[0], k->rub_a[1]);
    if (two) cross = real4_add(cross, real4_dot(k->rub_b[0],
                                                k->rub_b[1]));
    real4 volume = real4_sub(real4_mul(own[0], own[1]),
                             real4_mul(cross, cross));
    real4 per_volume = real4_div(real4_all(1), volume);
    mass[0] = real4_mul(own[1], per_volume);
    mass[1] = real4_sub(real4_all(0), real4_mul(cross, per_volume));
    mass[2] = real4_mul(own[0], per_volume);
    if (k->points == 1) return;         // one point alone does not twist
    twist = make_row(k->rub_a[TWIST], raw->a.turn, k->normal);
    if (two) twist = real4_add(twist, make_row(k->rub_b[TWIST], raw->b.turn,
                                               k->normal));
    twist = real4_if_positive(twist, twist, real4_all(1));
    k->twist_mass = real4_div(real4_all(1), twist);
}
//<

//> passes-blocks
//>   A block is filled, and its rows are made.
static void set_material(const preparation *p, block *k)
{
    k->friction = k->strikes = real4_all(0);
    for (int l = 0; l < REAL4; l++) {
        if (k->contact[l] < 0) continue;
        const contact *c = p->table[k->contact[l]];
        material m = solver_material(p->f, c->a, c->b);
        real4_set(&k->friction, l, m.friction);
        real4_set(&k->strikes, l,
                  solver_strikes(p->f, c) + (m.restitution > 0));
    }
}

ALWAYS_INLINE void make_rows_at(block *k, raw_block *raw, bool two)
{
    real4 center_a[3], center_b[3];
    real4 inverse = real4_add(k->inverse_a, k->inverse_b);
    find_center(k, raw, center_a, center_b);
    make_points(k, raw, inverse, center_a, two);
    make_friction(k, raw, inverse, center_a, center_b, two);
}

// The rows of a block, for bodies that stand as they do now.
static void make_rows_of(const contact_solver *s, block *k,
                         const solver_frame *f)
{
    raw_block raw;
    stand_block(s, k, f, &raw);
    if (k->two) make_rows_at(k, &raw, true);
    else make_rows_at(k, &raw, false);
    k->is_stale = false;
    k->lies = all_rest(s, k, f);
}

static void fill_block(void *data, int number)
{
    const preparation *p = data;
    contact_solver *s = p->s;
    block *k = &s->block[number];
    lane_source q[REAL4];
    int first, lanes = solver_lanes(s, number, &first);
    const int *list = s->order + first;
    k->rubs = true;
    k->has_blow = false;
    k->struck = real4_all(0);
    k->in_blow = 0;
    k->two = s->active[list[0]].sides != ONE_SIDED;
    k->is_driven = s->active[list[0]].sides == DRIVEN_SIDED;
    k->points = s->start[number + 1] - s->start[number];
    k->point = s->point + s->start[number];
    k->place = s->place + s->start[number];
    for (int l = 0; l < REAL4; l++) {
        // A lane that is left over has no points: it pushes nothing.
        q[l] = (lane_source){ .a = s->room, .b = s->room };
        if (l < lanes)
            choose_lane(&q[l], p->table[list[l]], &s->active[list[l]], p->f,
                        s->room);
        k->contact[l] = l < lanes ? list[l] : -1;
        k->a[l] = q[l].a;
        k->b[l] = q[l].b;
    }
    transpose(k, q);
    set_material(p, k);
    make_rows_of(s, k, p->f);
    find_uneven(k);
}

//<

//> passes-keep
//>   Where the contacts of a block are those of the frame before, it is kept. Only
//>   its rows and gaps are made again. (A heap that lies still keeps all.)
static void keep_block(const preparation *p, int number)
{
    block *k = &p->s->block[number];
    raw_block raw;
    set_material(p, k);
    if (k->lies) {
        update_gaps_of(p->s, k, p->f, &raw);
        if (all_rest(p->s, k, p->f)) return;
    }
    make_rows_of(p->s, k, p->f);
}

static bool block_is_good(const preparation *p, int number)
{
    const contact_solver *s = p->s;
    const block *k = &s->block[number];
    int first, lanes = solver_lanes(s, number, &first), at = s->start[number];
    bool good = k->point == s->point + at && k->place == s->place + at
             && k->points == s->start[number + 1] - at;
    for (int l = 0; l < REAL4 && good; l++) {
        int n = l < lanes ? s->order[first + l] : -1;
        good = k->contact[l] == n
            && (n < 0 || solver_is_kept(&s->active[n], p->f));
    }
    return good;
}

static void fill_chunk(void *data, int item)
{
    const preparation *p = data;
    int end = task_last(item, p->s->blocks, FEW_BLOCKS);
    for (int k = item * FEW_BLOCKS; k < end; k++) {
        if (k < p->known && (p->is_same || block_is_good(p, k)))
            keep_block(p, k);
        else fill_block(data, k);
    }
}
//<

//> passes-renew
// Did it push or rub when it was last solved?  If not, only its gaps are
// measured, because most of them stay open: see solver-lazy.
static bool acts(const block *k)
{
    bool some = k->rubs;
    for (int j = 0; j < k->points && !some; j++)
        some = real4_any(k->point[j].impulse);
    return some;
}

static bool is_fresh(const block *k, const solver_frame *f, int spare)
{
    bool some = !f->fresh;
    for (int l = 0; l < REAL4 && !some; l++)
        some = (k->a[l] != spare && f->fresh[k->a[l]])
            || (k->b[l] != spare && f->fresh[k->b[l]]);
    return some;
}

static void renew_block(contact_solver *s, block *k, const solver_frame *f)
{
    raw_block raw;
    if (acts(k)) {
        make_rows_of(s, k, f);
        return;
    }
    update_gaps_of(s, k, f, &raw);
    k->is_stale = true;
    k->lies = false;
}

static void renew_chunk(void *data, int item)
{
    const preparation *p = data;
    contact_solver *s = p->s;
    int end = task_last(item, s->blocks, FEW_BLOCKS);
    for (int n = item * FEW_BLOCKS; n < end; n++) {
        block *k = &s->block[n];
        real4 was[CONTACT_POINTS];
        if (!is_fresh(k, p->f, s->room)) continue;
        take_gaps(k, was);
        renew_block(s, k, p->f);
        if (p->f->is_put_back) keep_open(k, was);
    }
}
//<

//> passes-sides
//>   Compare the passes with the plain solver, line by line.
// Six numbers of four bodies: three of the centre, three turns.
ALWAYS_INLINE void gather_sides(const motion *m, const int body[REAL4],
                                real4 to[MOTIONS])
{
    const real *const from[REAL4] = { m[body[0]].of, m[body[1]].of,
                                      m[body[2]].of, m[body[3]].of };
    for (int k = 0; k < MOTIONS / 2; k++)
        real4_gather2(from, k, &to[2 * k], &to[2 * k + 1]);
}

ALWAYS_INLINE void scatter_sides(motion *m, const int body[REAL4],
                                 const real4 from[MOTIONS])
{
    real *const to[REAL4] = { m[body[0]].of, m[body[1]].of, m[body[2]].of,
                              m[body[3]].of };
    for (int k = 0; k < MOTIONS / 2; k++)
        real4_scatter2(to, k, from[2 * k], from[2 * k + 1]);
}

// How A and B move: a body that does not move takes no part, and a driven one is
// read, but not written.
typedef struct {
    real4 a[MOTIONS], b[MOTIONS];
} sides4;

ALWAYS_INLINE sides4 take_sides(const block *k, const motion *m, bool two)
{
    sides4 s;
    gather_sides(m, k->a, s.a);
    if (two) gather_sides(m, k->b, s.b);
    return s;
}

ALWAYS_INLINE void give_sides(const block *k, motion *m, const sides4 *s,
                              bool two)
{
    scatter_sides(m, k->a, s->a);
    if (two && !k->is_driven) scatter_sides(m, k->b, s->b);
}

// How fast, or how far, the centres part along a direction.
ALWAYS_INLINE real4 part_centers(const real4 along[3], const sides4 *s,
                                 bool two)
{
    real4 d[3];
    if (!two) return real4_dot(along, s->a);
    for (int i = 0; i < 3; i++) d[i] = real4_sub(s->a[i], s->b[i]);
    return real4_dot(along, d);
}

// And what turning adds to that.
ALWAYS_INLINE real4 part_turns(const real4 row_a[TURNS],
                               const real4 row_b[TURNS], const sides4 *s,
                               bool two)
{
    real4 a = real4_dot(row_a, s->a + MOTION_TURN);
    return two ? real4_sub(a, real4_dot(row_b, s->b + MOTION_TURN)) : a;
}

ALWAYS_INLINE void push_turns(const real4 row_a[TURNS],
                              const real4 row_b[TURNS], real4 impulse,
                              sides4 *s, bool two)
{
    real4_add3(s->a + MOTION_TURN, row_a, impulse);
    if (two) real4_sub3(s->b + MOTION_TURN, row_b, impulse);
}

ALWAYS_INLINE void push_centers(const block *k, const real4 along[3],
                                real4 impulse, sides4 *s, bool two)
{
    real4_add3(s->a, along, real4_mul(k->inverse_a, impulse));
    if (two) real4_sub3(s->b, along, real4_mul(k->inverse_b, impulse));
}
//<

//> passes-normal
// One point takes its part of the impulse: at least so much that its points do
// not pull.  The centres' speed of parting is one number for all points of a
// contact; it is kept up to date here, and the centres are pushed at the end.
ALWAYS_INLINE void push_point(block_point *p, real4 impulse, real4 inverse,
                              real4 *parting, real4 *sum, sides4 *s, bool two)
{
    impulse = real4_max(impulse, real4_all(0));
    real4 change = real4_sub(impulse, p->impulse);
    p->impulse = impulse;
    *sum = real4_add(*sum, change);
    *parting = real4_mad(inverse, change, *parting);
    push_turns(p->turn_a, p->turn_b, change, s, two);
}

ALWAYS_INLINE real4 inverse_mass(const block *k, bool two)
{
    return two ? real4_add(k->inverse_a, k->inverse_b) : k->inverse_a;
}

// An open point that closes fast, and has not pushed, is left to an impact: it is
// as if its gap would just close.
static inline real4 leave_impacts(const block *k, const solver_pass *q, real4 speed,
                                  real4 impulse)
{
    const real4 zero = real4_all(0);
    real4 slow = real4_add(speed, real4_all(q->slowest));
    real4 left = real4_if_positive(impulse, speed,
                                   real4_if_positive(slow, speed, zero));
    return real4_if_positive(k->strikes, left, speed);
}
//<

//> passes-struck
//>   What closes fast strikes, as for an impact; its friction is for this substep
//>   alone ([`blow`](lib-blow.md)).
// The impulse of a point that is open and closes fast; else 0.
static inline real4 striking(const solver_pass *q, real4 gap, real4 speed,
                             real4 impulse)
{
    const real4 zero = real4_all(0);
    real4 slow = real4_add(speed, real4_all(q->slowest));
    return real4_if_positive(gap, real4_if_positive(slow, zero, impulse), zero);
}
//<

//> passes-closing
//>   Where a heavy body strikes a light one, how fast do they close when the pass
//>   is over ([`blow`](lib-blow.md))? Slower ones the
//>   warm start bears soon.
static void find_strike(block *k, const solver_pass *q, bool two)
{
    const real4 zero = real4_all(0), per_h = real4_all(q->per_h);
    real4 closing = zero;
    k->closing = zero;
    if (!k->is_uneven || k->is_stale) return;
    sides4 u = take_sides(k, q->velocity, two);
    real4 parting = part_centers(k->normal, &u, two);
    real4 slowest = real4_mul(k->uneven, real4_all(q->slowest));
    real4 bounces = real4_sub(k->strikes, real4_all(1));
    for (int j = 0; j < k->points; j++) {
        const block_point *p = &k->point[j];
        real4 turns = part_turns(p->turn_a, p->turn_b, &u, two);
        real4 then = real4_mad(real4_max(p->now, zero), per_h,
                               real4_add(parting, turns));
        then = real4_add(then, slowest);
        then = real4_if_positive(bounces, zero, then);
        closing = real4_min(closing, real4_mul(k->place[j].has, then));
    }
    k->closing = real4_if_positive(k->uneven, closing, zero);
}
//<

//> passes-see
//>   What a caller may look at.
ALWAYS_INLINE void see_block(block *k, const solver_pass *q, bool two)
{
    sides4 d = take_sides(k, q->moved, two);
    real4 parted = part_centers(k->normal, &d, two);
    for (int j = 0; j < k->points; j++) {
        block_point *p = &k->point[j];
        real4 turned = part_turns(p->turn_a, p->turn_b, &d, two);
        p->now = real4_add(real4_add(parted, p->gap), turned);
    }
}
//<

//> passes-lazy
//>   What did not push in the last substep has no rows of this one yet. Might
//>   one of its gaps close in this substep? The rows of an older one say so,
//>   if all that turning does is doubted. Only then are rows made.
ALWAYS_INLINE bool wakes(block *k, const solver_pass *q, const sides4 *u, bool two)
{
    const real4 per_h = real4_all(q->per_h), zero = real4_all(0);
    real4 parting = part_centers(k->normal, u, two), closing = zero;
    for (int j = 0; j < k->points; j++) {
        const block_point *p = &k->point[j];
        real4 turns = part_turns(p->turn_a, p->turn_b, u, two);
        real4 off = real4_max(turns, real4_sub(zero, turns));
        real4 then = real4_mad(p->now, per_h, real4_add(parting, turns));
        then = real4_mul(k->place[j].has, real4_sub(then, off));
        closing = real4_min(closing, then);
    }
    if (!real4_any(closing)) return false;
    real4 was[CONTACT_POINTS];
    take_gaps(k, was);
    make_rows_of(q->s, k, q->f);
    keep_open(k, was);
    see_block(k, q, two);
    return true;
}
//<

//> passes-push
// What pushes apart along the normal: how fast the centres part, and what it has
// given so far.
typedef struct {
    sides4 u;
    real4 parting, sum;
} pushing;

// An open gap may close, but no further; an overlap is pushed out as a spring
// and a damper would.  Only where `on` is positive.  Returns what open ones push.
// What has landed has a gap of zero, and rounding is not to decide whether that is
// open: a gap is, beyond CONTACT_TOUCHES.
ALWAYS_INLINE real4 push_points(block *k, const solver_pass *q, pushing *w,
                                real4 on, bool two, bool has_impacts)
{
    const softness *soft = &q->soft[q->sides];
    const real4 one = real4_all(1), zero = real4_all(0);
    const real4 per_h = real4_all(q->per_h);
    const real4 most = real4_mul(real4_all(-q->max_rate), k->radius);
    const real4 rate = real4_all(soft->rate * soft->mass);
    const real4 soft_mass = real4_all(soft->mass);
    const real4 soft_impulse = real4_all(soft->impulse);
    const real4 touch = real4_mul(real4_all(CONTACT_TOUCHES), k->radius);
    real4 inverse = inverse_mass(k, two), pushes = zero;
    for (int j = 0; j < k->points; j++) {
        block_point *p = &k->point[j];
        real4 gap = p->now, open = real4_sub(gap, touch);
        real4 speed = real4_add(w->parting,
                                part_turns(p->turn_a, p->turn_b, &w->u, two));
        if (has_impacts)
            speed = real4_if_positive(
                open, leave_impacts(k, q, speed, p->impulse), speed);
        real4 bias = real4_if_positive(open, real4_mul(gap, per_h),
                                       real4_max(real4_mul(rate, gap), most));
        real4 mass = real4_if_positive(open, one, soft_mass);
        real4 leak = real4_if_positive(open, zero, soft_impulse);
        real4 step = real4_mad(p->mass, real4_mad(mass, speed, bias),
                               real4_mul(leak, p->impulse));
        step = real4_if_positive(on, step, zero);
        push_point(p, real4_sub(p->impulse, step), inverse, &w->parting,
                   &w->sum, &w->u, two);
        pushes = real4_add(pushes, real4_if_positive(open, p->impulse, zero));
        k->struck = real4_mad(on, striking(q, open, speed, p->impulse), k->struck);
    }
    return pushes;
}

// The first point that strikes turns the body onto the others: what falls flat
// would land on its rim.  So several go on in turn, once for each.  (What rests
// has that time from one substep to the next.)
ALWAYS_INLINE void push_block(block *k, const solver_pass *q, bool two,
                              bool has_impacts)
{
    pushing w = { .u = take_sides(k, q->velocity, two), .sum = real4_all(0) };
    if (k->is_stale && !wakes(k, q, &w.u, two)) return;
    w.parting = part_centers(k->normal, &w.u, two);
    real4 open = push_points(k, q, &w, real4_all(1), two, has_impacts);
    if (k->points > 1 && real4_any(open)) {
        open = real4_mul(open, k->place[1].has);
        for (int i = 1; i < CONTACT_POINTS; i++)
            push_points(k, q, &w, open, two, has_impacts);
    }
    push_centers(k, k->normal, w.sum, &w.u, two);
    give_sides(k, q->velocity, &w.u, two);
}
//<

//> passes-friction
// Coulomb: what acts across is at most friction times what acts along, and the
// twist at most that with the lever of each point.
ALWAYS_INLINE void twist_block(block *k, real4 most, real4 on, sides4 *u,
                               bool two)
{
    real4 speed = part_turns(k->rub_a[TWIST], k->rub_b[TWIST], u, two);
    real4 twist = real4_sub(k->rub[TWIST],
                            real4_mul(k->twist_mass, speed));
    twist = real4_max(real4_min(twist, most),
                      real4_sub(real4_all(0), most));
    real4 change = real4_mul(on, real4_sub(twist, k->rub[TWIST]));
    k->rub[TWIST] = real4_add(k->rub[TWIST], change);
    push_turns(k->rub_a[TWIST], k->rub_b[TWIST], change, u, two);
}

ALWAYS_INLINE real4 slide_point(const block *k, int i, const sides4 *u, bool two)
{
    return real4_add(part_centers(k->across[i], u, two),
                     part_turns(k->rub_a[i], k->rub_b[i], u, two));
}

ALWAYS_INLINE void brake_block(block *k, real4 most, real4 on, sides4 *u,
                               bool two)
{
    const real4 *mass = k->across_mass, one = real4_all(1);
    const real4 least = real4_all(1e-300);      // no length is 0 below
    real4 x = slide_point(k, 0, u, two), y = slide_point(k, 1, u, two), impulse[2];
    impulse[0] = real4_sub(k->rub[0],
                           real4_mad(mass[0], x, real4_mul(mass[1], y)));
    impulse[1] = real4_sub(k->rub[1],
                           real4_mad(mass[1], x, real4_mul(mass[2], y)));
    real4 length = real4_sqrt(real4_mad(impulse[0], impulse[0],
                                        real4_mul(impulse[1], impulse[1])));
    real4 fraction = real4_min(real4_div(most, real4_max(length, least)), one);
    for (int i = 0; i < 2; i++) {
        impulse[i] = real4_mul(fraction, impulse[i]);
        real4 change = real4_mul(on, real4_sub(impulse[i], k->rub[i]));
        k->rub[i] = real4_add(k->rub[i], change);
        push_centers(k, k->across[i], change, u, two);
        push_turns(k->rub_a[i], k->rub_b[i], change, u, two);
    }
}
//<

//> passes-relax
//>   As the push does, the relax pass leaves a point alone that is open and
//>   closes fast, if it will have an impact (chapter 15).
// A round over the points, and their friction, where `on` is 1 and not 0.
ALWAYS_INLINE void relax_once(block *k, const solver_pass *q, real4 on,
                              sides4 *side, bool two, bool has_impacts)
{
    const real4 zero = real4_all(0), per_h = real4_all(q->per_h);
    const real4 friction = k->friction;
    sides4 u = *side;
    real4 parting = part_centers(k->normal, &u, two), sum = zero;
    real4 inverse = inverse_mass(k, two), along = zero, moment = zero;
    for (int j = 0; j < k->points; j++) {
        block_point *p = &k->point[j];
        real4 gap = p->now;
        real4 speed = real4_add(parting,
                                part_turns(p->turn_a, p->turn_b, &u, two));
        if (has_impacts) speed = leave_impacts(k, q, speed, p->impulse);
        real4 then = real4_mad(real4_max(gap, zero), per_h, speed);
        real4 step = real4_mul(on, real4_mul(p->mass, then));
        push_point(p, real4_sub(p->impulse, step), inverse, &parting, &sum, &u,
                   two);
        k->struck = real4_mad(on, striking(q, gap, speed, p->impulse), k->struck);
        along = real4_add(along, p->impulse);
        moment = real4_mad(p->lever, p->impulse, moment);
    }
    push_centers(k, k->normal, sum, &u, two);
    if (k->rubs || real4_any(along)) {
        if (k->points > 1) twist_block(k, real4_mul(friction, moment), on, &u, two);
        brake_block(k, real4_mul(friction, along), on, &u, two);
        k->rubs = real4_any(along);
    }
    *side = u;
}

// What strikes, and a contact that brings no impulse along, has yet to find its
// impulses, and what its points and its friction have not found together in a substep
// turns its bodies.  A block that ought to stand on a slope toppled, and a box that
// fell flat and slid was thrown up.  So these go on in turn as well, once for each
// point.
ALWAYS_INLINE void relax_block(block *k, const solver_pass *q, bool two,
                               bool has_impacts)
{
    see_block(k, q, two);
    sides4 u = take_sides(k, q->velocity, two);
    if (k->is_stale && !wakes(k, q, &u, two)) return;
    real4 all = k->place[0].has;
    relax_once(k, q, all, &u, two, has_impacts);
    real4 on = q->carries ? real4_if_positive(k->struck, all, real4_all(0)) : all;
    for (int i = 1; i < CONTACT_POINTS && real4_any(on); i++)
        relax_once(k, q, on, &u, two, has_impacts);
    give_sides(k, q->velocity, &u, two);
}
//<

//> passes-warm
//>   Warm start: the impulses of the last substep act again.
ALWAYS_INLINE void warm_block(block *k, const solver_pass *q, bool two)
{
    k->struck = real4_all(0);
    if (!acts(k)) return;
    sides4 u = take_sides(k, q->velocity, two);
    real4 sum = real4_all(0);
    for (int j = 0; j < k->points; j++) {
        const block_point *p = &k->point[j];
        sum = real4_add(sum, p->impulse);
        push_turns(p->turn_a, p->turn_b, p->impulse, &u, two);
    }
    push_centers(k, k->normal, sum, &u, two);
    for (int i = 0; i < (k->points > 1 ? RUBS : TWIST); i++) {
        if (i < TWIST) push_centers(k, k->across[i], k->rub[i], &u, two);
        push_turns(k->rub_a[i], k->rub_b[i], k->rub[i], &u, two);
    }
    give_sides(k, q->velocity, &u, two);
}
//<

//> passes-table
// A loop for each kind of pass and of side, so that none asks inside.
#define PASS(name, solve_two, solve_one)                              \
    static void name(void *data, int item)                            \
    {                                                                 \
        const solver_pass *q = data;                                  \
        block *first = q->s->block + q->first;                        \
        block *x = first + item * FEW_BLOCKS;                         \
        block *end = first + task_last(item, q->count, FEW_BLOCKS);   \
        if (q->sides != ONE_SIDED)                                    \
            for (; x < end; x++) solve_two;                           \
        else                                                          \
            for (; x < end; x++) solve_one;                           \
    }

PASS(see_chunk, see_block(x, q, true), see_block(x, q, false))
PASS(strike_chunk, find_strike(x, q, true), (void)x)
PASS(warm_chunk, warm_block(x, q, true), warm_block(x, q, false))
PASS(push_chunk, push_block(x, q, true, false), push_block(x, q, false, false))
PASS(push_to_impacts_chunk, push_block(x, q, true, true),
     push_block(x, q, false, true))
PASS(relax_chunk, relax_block(x, q, true, false), relax_block(x, q, false, false))
PASS(relax_to_impacts_chunk, relax_block(x, q, true, true),
     relax_block(x, q, false, true))

const solver_passes PASSES = {
    .fill = fill_chunk, .refill = fill_block, .renew = renew_chunk,
    .see = see_chunk, .strike = strike_chunk, .warm = warm_chunk,
    .push = { push_chunk, push_to_impacts_chunk },
    .relax = { relax_chunk, relax_to_impacts_chunk }
};
//<
