//> solver-active
#include "solver.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

static bool moves(const solver_frame *f, int body)
{
    return body >= 0 && f->body[body].basis.inverse_mass > 0;
}

// Contact c, and which of its points come within reach.
static active_contact activate(const contact *c, const solver_frame *f,
                               real reach)
{
    real gap[CONTACT_POINTS];
    active_contact x = { .a = c->a, .b = c->b, .color = -1,
                         .least = HUGE_VAL };
    const rigid_frame *b = c->b < 0 ? NULL : &f->body[c->b].frame;
    real height = c->b < 0 ? f->plane[-1 - c->b].offset : 0;
    if (!moves(f, c->a) && !moves(f, c->b)) return x;
    contact_gaps(c, &f->body[c->a].frame, b, height, gap);
    for (int k = 0; k < c->count; k++) {
        x.least = real_min(gap[k], x.least);
        if (!(gap[k] < reach)) continue;
        x.point[x.count] = (signed char)k;
        x.gap[x.count++] = gap[k];
    }
    x.is_swapped = !moves(f, c->a);
    x.sides = moves(f, c->a) && moves(f, c->b) ? TWO_SIDED : ONE_SIDED;
    if (x.is_swapped) x.a = c->b;
    if (x.sides == ONE_SIDED) x.b = f->bodies;
    return x;
}
//<

//> solver-color
// The lowest colour that neither body has yet; the last is for all that find
// none.
static void choose_color(contact_solver *s, active_contact *x)
{
    unsigned long long *a = &s->taken[x->a][x->sides], none = 0;
    unsigned long long *b = x->sides == TWO_SIDED ? &s->taken[x->b][x->sides]
                                                  : &none;
    unsigned long long used = *a | *b;
    int color = 0;
    while (color < COLORS - 1 && used >> color & 1) color++;
    x->color = x->sides * COLORS + color;
    *a |= 1ULL << color;
    *b |= 1ULL << color;
}

// Those of a colour stand together, and of these those with as many points: a
// block takes as long as the contact in it that has most.
enum { BINS = SIDES * COLORS * CONTACT_POINTS };

static int bin_of(const active_contact *x)
{
    return x->color * CONTACT_POINTS + (CONTACT_POINTS - x->count);
}

// Counting sort; end[bin] is where each bin ends in s->order.
static void sort_contacts(contact_solver *s, int end[BINS])
{
    int at[BINS] = { 0 }, sum = 0;
    for (int k = 0; k < s->contacts; k++)
        if (s->active[k].count > 0) at[bin_of(&s->active[k])]++;
    for (int bin = 0; bin < BINS; bin++) {
        sum += at[bin];
        at[bin] = sum - at[bin];
    }
    for (int k = 0; k < s->contacts; k++)
        if (s->active[k].count > 0) s->order[at[bin_of(&s->active[k])]++] = k;
    for (int bin = 0; bin < BINS; bin++) end[bin] = at[bin];
    s->touching = sum;
}

static void list_colors(contact_solver *s, const int end[BINS])
{
    int first = 0;
    s->colors = s->blocks = 0;
    for (int c = 0; c < SIDES * COLORS; c++) {
        int n = end[(c + 1) * CONTACT_POINTS - 1] - first;
        bool is_crowded = c % COLORS == COLORS - 1;
        int blocks = is_crowded ? n : (n + REAL4 - 1) / REAL4;
        first += n;
        if (n == 0) continue;
        s->color[s->colors++] = (block_color){ s->blocks, blocks, n, c / COLORS,
                                               is_crowded };
        s->blocks += blocks;
    }
}
//<

//> solver-lane
// The turns that a unit impulse with this moment (m) gives a body.
static void set_row(real4 row[TURNS], int l, const motion_basis *basis,
                    vec3 moment)
{
    for (int t = 0; t < TURNS; t++)
        real4_set(&row[t], l, vec3_dot(basis->turn[t], moment));
}

static real row_square(const real4 row[TURNS], int l)
{
    real sum = 0;
    for (int t = 0; t < TURNS; t++)
        sum += real4_get(&row[t], l) * real4_get(&row[t], l);
    return sum;
}

// One contact on its way into a lane.
typedef struct {
    const contact *c;
    const active_contact *x;
    const motion_basis *a, *b;
    vec3 normal, across[2];
    vec3 center_a, center_b;    // m, arms of where friction acts
    real sign;                  // -1: it is solved the other way round
    real warm;                  // see solver_frame
    real near;                  // m, a gap that counts as touching for that
} lane_source;

static vec3 arm(const lane_source *q, int k, bool of_b)
{
    const contact_point *p = &q->c->point[q->x->point[k]];
    return of_b != q->x->is_swapped ? p->arm_b : p->arm_a;
}

// Friction acts where the points are that touch; one that is wide open counts
// for a hundredth.
static void find_center(lane_source *q)
{
    real sum = 0;
    for (int k = 0; k < q->x->count; k++) {
        real share = real_min(1, real_max(0.01, 2 - q->x->gap[k] / q->near));
        sum += share;
        q->center_a = vec3_add_scaled(q->center_a, share, arm(q, k, false));
        q->center_b = vec3_add_scaled(q->center_b, share, arm(q, k, true));
    }
    q->center_a = vec3_scale(1 / sum, q->center_a);
    q->center_b = vec3_scale(1 / sum, q->center_b);
}

static void find_across(vec3 n, vec3 across[2])
{
    real x = fabs(n.x), y = fabs(n.y), z = fabs(n.z);
    vec3 least = { x <= y && x <= z, y < x && y <= z, z < x && z < y };
    across[0] = vec3_unit(vec3_cross(n, least));
    across[1] = vec3_cross(n, across[0]);
}
//<

//> solver-fill
static void fill_point(block *k, int l, int j, const lane_source *q)
{
    block_point *p = &k->point[j];
    vec3 a = arm(q, j, false), b = arm(q, j, true);
    set_row(p->turn_a, l, q->a, vec3_cross(a, q->normal));
    set_row(p->turn_b, l, q->b, vec3_cross(b, q->normal));
    real inverse = q->a->inverse_mass + q->b->inverse_mass
                 + row_square(p->turn_a, l) + row_square(p->turn_b, l);
    real4_set(&p->gap, l, q->x->gap[j]);
    real4_set(&p->mass, l, 1 / inverse);
    real4_set(&p->impulse, l,
              q->warm * q->c->point[q->x->point[j]].impulse);
    real4_set(&p->lever, l, vec3_distance(a, q->center_a));
}

// Both directions are solved at once, with the inverse of
//     | K00 K01 |        K_ij = how far a unit impulse along j moves the points
//     | K01 K11 |        along i.
static void fill_friction(block *k, int l, const lane_source *q)
{
    real inverse = q->a->inverse_mass + q->b->inverse_mass, cross = 0;
    real own[2], twist;
    for (int i = 0; i < 2; i++) {
        vec3 t = q->across[i];
        set_row(k->across_a[i], l, q->a, vec3_cross(q->center_a, t));
        set_row(k->across_b[i], l, q->b, vec3_cross(q->center_b, t));
        own[i] = inverse + row_square(k->across_a[i], l)
               + row_square(k->across_b[i], l);
        real4_set3(k->across[i], l, t);
        real4_set(&k->across_impulse[i], l,
                  q->warm * q->sign * vec3_dot(q->c->friction, t));
    }
    for (int t = 0; t < TURNS; t++)
        cross += real4_get(&k->across_a[0][t], l)
               * real4_get(&k->across_a[1][t], l)
               + real4_get(&k->across_b[0][t], l)
               * real4_get(&k->across_b[1][t], l);
    real volume = own[0] * own[1] - cross * cross;
    real4_set(&k->across_mass[0], l, own[1] / volume);
    real4_set(&k->across_mass[1], l, -cross / volume);
    real4_set(&k->across_mass[2], l, own[0] / volume);
    set_row(k->twist_a, l, q->a, q->normal);
    set_row(k->twist_b, l, q->b, q->normal);
    twist = row_square(k->twist_a, l) + row_square(k->twist_b, l);
    real4_set(&k->twist_mass, l, twist > 0 ? 1 / twist : 0);
    real4_set(&k->twist_impulse, l, q->warm * q->c->twist);
}
//<

//> solver-swap
// A contact whose A does not move is solved the other way round: its normal,
// and what acts along it, change sign; a twist does not, for both the axis and
// the bodies change places.
static lane_source source_of(const contact *c, const active_contact *x,
                             const solver_frame *f)
{
    static const motion_basis immovable = { .inverse_mass = 0 };
    real radius = f->body[x->a].radius;
    lane_source q = { .c = c, .x = x, .a = &f->body[x->a].basis,
                      .b = &immovable, .warm = f->warm,
                      .sign = x->is_swapped ? -1 : 1 };
    q.normal = vec3_scale(q.sign, c->normal);
    if (x->sides == TWO_SIDED) {
        q.b = &f->body[x->b].basis;
        radius = real_min(radius, f->body[x->b].radius);
    }
    q.near = radius / 25;
    find_center(&q);
    find_across(q.normal, q.across);
    return q;
}

static void fill_lane(block *k, int l, int number, const contact *c,
                      const active_contact *x, const solver_frame *f)
{
    lane_source q = source_of(c, x, f);
    k->contact[l] = number;
    k->a[l] = x->a;
    k->b[l] = x->b;
    real4_set3(k->normal, l, q.normal);
    real4_set(&k->inverse_a, l, q.a->inverse_mass);
    real4_set(&k->inverse_b, l, q.b->inverse_mass);
    for (int j = 0; j < x->count; j++) fill_point(k, l, j, &q);
    fill_friction(k, l, &q);
}
//<

//> solver-blocks
typedef struct {
    contact_solver *s;
    const solver_frame *f;
    const contact *const *table;
    const real *reach;
} preparation;

enum { CHUNK = 32 };        // contacts, or blocks, in an item of work

static int chunks(int n)
{
    return (n + CHUNK - 1) / CHUNK;
}

static void activate_chunk(void *data, int item)
{
    const preparation *p = data;
    int end = int_min((item + 1) * CHUNK, p->s->contacts);
    for (int k = item * CHUNK; k < end; k++)
        p->s->active[k] = activate(p->table[k], p->f, p->reach[k]);
}

// The first contact in s->order of block `number`, and how many it has.
static int lanes_of(const contact_solver *s, int number, int *first)
{
    int color = 0, before = 0;
    while (number >= s->color[color].first + s->color[color].count) color++;
    for (int c = 0; c < color; c++) before += s->color[c].contacts;
    int in = number - s->color[color].first;
    int each = s->color[color].is_crowded ? 1 : REAL4;
    *first = before + each * in;
    return int_min(each, s->color[color].contacts - each * in);
}

// Lanes, and points, that are left over stay zero: they push nothing.
static void fill_block(const preparation *p, int number)
{
    contact_solver *s = p->s;
    block *k = &s->block[number];
    int first, lanes = lanes_of(s, number, &first);
    const int *list = s->order + first;
    int most = s->active[list[0]].count;
    if (lanes < REAL4 || s->active[list[lanes - 1]].count < most)
        memset(k, 0, sizeof *k);
    k->points = most;
    for (int l = lanes; l < REAL4; l++) {
        k->contact[l] = -1;
        k->a[l] = k->b[l] = s->bodies;
    }
    for (int l = 0; l < lanes; l++)
        fill_lane(k, l, list[l], p->table[list[l]], &s->active[list[l]], p->f);
}

static void fill_chunk(void *data, int item)
{
    const preparation *p = data;
    int end = int_min((item + 1) * CHUNK, p->s->blocks);
    for (int k = item * CHUNK; k < end; k++) fill_block(p, k);
}
//<

//> solver-prepare
// Grows an array without keeping what is in it.
static bool grow(void **array, int *capacity, int need, size_t size)
{
    if (need <= *capacity) return true;
    void *more = malloc((size_t)need * 3 / 2 * size);
    if (!more) return false;
    free(*array);
    *array = more;
    *capacity = need * 3 / 2;
    return true;
}

static bool make_room(contact_solver *s, int n)
{
    int capacity = s->capacity;
    return grow((void **)&s->active, &capacity, n, sizeof *s->active)
        && grow((void **)&s->order, &s->capacity, n, sizeof *s->order);
}

bool solver_prepare(contact_solver *s, const solver_frame *f,
                    const contact *const *table, const real *reach, int n)
{
    int end[BINS];
    preparation p = { s, f, table, reach };
    s->contacts = s->blocks = s->colors = s->touching = 0;
    if (!make_room(s, n)) return false;
    s->contacts = n;
    memset(s->taken, 0, (size_t)s->bodies * sizeof *s->taken);
    tasks_run(f->run, activate_chunk, &p, chunks(n));
    for (int k = 0; k < n; k++)
        if (s->active[k].count > 0) choose_color(s, &s->active[k]);
    sort_contacts(s, end);
    list_colors(s, end);
    if (!grow((void **)&s->block, &s->block_capacity, s->blocks,
              sizeof *s->block)) {
        s->contacts = s->blocks = s->colors = s->touching = 0;
        return false;
    }
    tasks_run(f->run, fill_chunk, &p, chunks(s->blocks));
    return true;
}
//<

//> solver-sides
// Six numbers of four bodies: three of the centre, three turns.
static inline void gather(const motion *m, const int body[REAL4],
                          real4 to[MOTIONS])
{
    const real *const from[REAL4] = { m[body[0]].of, m[body[1]].of,
                                      m[body[2]].of, m[body[3]].of };
    for (int k = 0; k < MOTIONS / 2; k++)
        real4_gather2(from, k, &to[2 * k], &to[2 * k + 1]);
}

static inline void scatter(motion *m, const int body[REAL4],
                           const real4 from[MOTIONS])
{
    real *const to[REAL4] = { m[body[0]].of, m[body[1]].of, m[body[2]].of,
                              m[body[3]].of };
    for (int k = 0; k < MOTIONS / 2; k++)
        real4_scatter2(to, k, from[2 * k], from[2 * k + 1]);
}

// How A and B move: a body that does not move takes no part.
typedef struct {
    real4 a[MOTIONS], b[MOTIONS];
} sides4;

static inline sides4 take_sides(const block *k, const motion *m, bool two)
{
    sides4 s;
    gather(m, k->a, s.a);
    if (two) gather(m, k->b, s.b);
    return s;
}

static inline void give_sides(const block *k, motion *m, const sides4 *s,
                              bool two)
{
    scatter(m, k->a, s->a);
    if (two) scatter(m, k->b, s->b);
}

// How fast, or how far, the centres part along a direction.
static inline real4 part_centers(const real4 along[3], const sides4 *s,
                                 bool two)
{
    real4 d[3];
    if (!two) return real4_dot(along, s->a);
    for (int i = 0; i < 3; i++) d[i] = real4_sub(s->a[i], s->b[i]);
    return real4_dot(along, d);
}

// And what turning adds to that.
static inline real4 part_turns(const real4 row_a[TURNS],
                               const real4 row_b[TURNS], const sides4 *s,
                               bool two)
{
    real4 a = real4_dot(row_a, s->a + MOTION_TURN);
    return two ? real4_sub(a, real4_dot(row_b, s->b + MOTION_TURN)) : a;
}

static inline void push_turns(const real4 row_a[TURNS],
                              const real4 row_b[TURNS], real4 impulse,
                              sides4 *s, bool two)
{
    real4_add3(s->a + MOTION_TURN, row_a, impulse);
    if (two) real4_sub3(s->b + MOTION_TURN, row_b, impulse);
}

static inline void push_centers(const block *k, const real4 along[3],
                                real4 impulse, sides4 *s, bool two)
{
    real4_add3(s->a, along, real4_mul(k->inverse_a, impulse));
    if (two) real4_sub3(s->b, along, real4_mul(k->inverse_b, impulse));
}
//<

//> solver-normal
// One point takes its part of the impulse: at least so much that its points do
// not pull.  The centres' speed of parting is one number for all points of a
// contact; it is kept up to date here, and the centres are pushed at the end.
static inline void push_point(block_point *p, real4 impulse, real4 inverse,
                              real4 *parting, real4 *sum, sides4 *s, bool two)
{
    impulse = real4_max(impulse, real4_all(0));
    real4 change = real4_sub(impulse, p->impulse);
    p->impulse = impulse;
    *sum = real4_add(*sum, change);
    *parting = real4_mad(inverse, change, *parting);
    push_turns(p->turn_a, p->turn_b, change, s, two);
}

static inline real4 inverse_mass(const block *k, bool two)
{
    return two ? real4_add(k->inverse_a, k->inverse_b) : k->inverse_a;
}

// What a pass over the blocks is given.
typedef struct {
    contact_solver *s;
    motion *velocity;
    const motion *moved;
    real per_h;             // 1/s
    real friction, max_speed;
    softness soft[SIDES];
    int first, count, sides;    // the blocks of a colour
} pass;

// An open gap may close, but no further; an overlap is pushed out as a spring
// and a damper would.
static inline void push_block(block *k, const pass *q, bool two)
{
    const softness *soft = &q->soft[two ? TWO_SIDED : ONE_SIDED];
    const real4 one = real4_all(1), zero = real4_all(0);
    const real4 per_h = real4_all(q->per_h), most = real4_all(-q->max_speed);
    const real4 rate = real4_all(soft->rate * soft->mass);
    const real4 soft_mass = real4_all(soft->mass);
    const real4 soft_impulse = real4_all(soft->impulse);
    sides4 u = take_sides(k, q->velocity, two);
    sides4 d = take_sides(k, q->moved, two);
    real4 parting = part_centers(k->normal, &u, two), sum = zero;
    real4 parted = part_centers(k->normal, &d, two);
    real4 inverse = inverse_mass(k, two);
    for (int j = 0; j < k->points; j++) {
        block_point *p = &k->point[j];
        real4 turned = part_turns(p->turn_a, p->turn_b, &d, two);
        real4 gap = real4_add(real4_add(parted, p->gap), turned);
        real4 speed = real4_add(parting,
                                part_turns(p->turn_a, p->turn_b, &u, two));
        real4 bias = real4_if_positive(gap, real4_mul(gap, per_h),
                                       real4_max(real4_mul(rate, gap), most));
        real4 mass = real4_if_positive(gap, one, soft_mass);
        real4 leak = real4_if_positive(gap, zero, soft_impulse);
        real4 step = real4_mad(p->mass, real4_mad(mass, speed, bias),
                               real4_mul(leak, p->impulse));
        push_point(p, real4_sub(p->impulse, step), inverse, &parting, &sum, &u,
                   two);
    }
    push_centers(k, k->normal, sum, &u, two);
    give_sides(k, q->velocity, &u, two);
}
//<

//> solver-friction
// Coulomb: what acts across is at most friction times what acts along, and the
// twist at most that with the lever of each point.
static inline void twist_block(block *k, real4 most, sides4 *u, bool two)
{
    real4 speed = part_turns(k->twist_a, k->twist_b, u, two);
    real4 twist = real4_sub(k->twist_impulse,
                            real4_mul(k->twist_mass, speed));
    twist = real4_max(real4_min(twist, most),
                      real4_sub(real4_all(0), most));
    real4 change = real4_sub(twist, k->twist_impulse);
    k->twist_impulse = twist;
    push_turns(k->twist_a, k->twist_b, change, u, two);
}

static inline real4 slide(const block *k, int i, const sides4 *u, bool two)
{
    return real4_add(part_centers(k->across[i], u, two),
                     part_turns(k->across_a[i], k->across_b[i], u, two));
}

static inline void brake_block(block *k, real4 most, sides4 *u, bool two)
{
    const real4 *mass = k->across_mass, one = real4_all(1);
    const real4 least = real4_all(1e-300);      // no length is 0 below
    real4 x = slide(k, 0, u, two), y = slide(k, 1, u, two), impulse[2];
    impulse[0] = real4_sub(k->across_impulse[0],
                           real4_mad(mass[0], x, real4_mul(mass[1], y)));
    impulse[1] = real4_sub(k->across_impulse[1],
                           real4_mad(mass[1], x, real4_mul(mass[2], y)));
    real4 length = real4_sqrt(real4_mad(impulse[0], impulse[0],
                                        real4_mul(impulse[1], impulse[1])));
    real4 share = real4_min(real4_div(most, real4_max(length, least)), one);
    for (int i = 0; i < 2; i++) {
        impulse[i] = real4_mul(share, impulse[i]);
        real4 change = real4_sub(impulse[i], k->across_impulse[i]);
        k->across_impulse[i] = impulse[i];
        push_centers(k, k->across[i], change, u, two);
        push_turns(k->across_a[i], k->across_b[i], change, u, two);
    }
}
//<

//> solver-relax
static inline void relax_block(block *k, const pass *q, bool two)
{
    const real4 zero = real4_all(0), per_h = real4_all(q->per_h);
    const real4 friction = real4_all(q->friction);
    sides4 u = take_sides(k, q->velocity, two);
    sides4 d = take_sides(k, q->moved, two);
    real4 parting = part_centers(k->normal, &u, two), sum = zero;
    real4 parted = part_centers(k->normal, &d, two);
    real4 inverse = inverse_mass(k, two), along = zero, moment = zero;
    for (int j = 0; j < k->points; j++) {
        block_point *p = &k->point[j];
        real4 turned = part_turns(p->turn_a, p->turn_b, &d, two);
        real4 gap = real4_add(real4_add(parted, p->gap), turned);
        real4 speed = real4_add(parting,
                                part_turns(p->turn_a, p->turn_b, &u, two));
        speed = real4_mad(real4_max(gap, zero), per_h, speed);
        push_point(p, real4_sub(p->impulse, real4_mul(p->mass, speed)),
                   inverse, &parting, &sum, &u, two);
        along = real4_add(along, p->impulse);
        moment = real4_mad(p->lever, p->impulse, moment);
    }
    push_centers(k, k->normal, sum, &u, two);
    twist_block(k, real4_mul(friction, moment), &u, two);
    brake_block(k, real4_mul(friction, along), &u, two);
    give_sides(k, q->velocity, &u, two);
}
//<

//> solver-warm
static inline void warm_block(block *k, const pass *q, bool two)
{
    sides4 u = take_sides(k, q->velocity, two);
    real4 sum = real4_all(0);
    for (int j = 0; j < k->points; j++) {
        const block_point *p = &k->point[j];
        sum = real4_add(sum, p->impulse);
        push_turns(p->turn_a, p->turn_b, p->impulse, &u, two);
    }
    push_centers(k, k->normal, sum, &u, two);
    for (int i = 0; i < 2; i++) {
        push_centers(k, k->across[i], k->across_impulse[i], &u, two);
        push_turns(k->across_a[i], k->across_b[i], k->across_impulse[i], &u,
                   two);
    }
    push_turns(k->twist_a, k->twist_b, k->twist_impulse, &u, two);
    give_sides(k, q->velocity, &u, two);
}
//<

//> solver-pass
// A loop for each kind of pass and of side, so that none asks inside.
#define PASS(name, solve)                                               \
    static void name(void *data, int item)                              \
    {                                                                   \
        const pass *q = data;                                           \
        block *k = q->s->block + q->first;                              \
        int end = int_min((item + 1) * CHUNK, q->count);                \
        if (q->sides == TWO_SIDED)                                      \
            for (int i = item * CHUNK; i < end; i++) solve(&k[i], q, true); \
        else                                                            \
            for (int i = item * CHUNK; i < end; i++) solve(&k[i], q, false);\
    }

PASS(warm_chunk, warm_block)
PASS(push_chunk, push_block)
PASS(relax_chunk, relax_block)

// Springs of a contact as Catto has them: a1, a2, a3 of an implicit step of h.
// Against what does not move they are twice as stiff and half as damped.
static softness softness_of(const solver_frame *f, int sides)
{
    const real two_pi = 6.283185307179586;
    real per_side = sides == ONE_SIDED ? 2 : 1;
    real omega = two_pi * per_side * real_min(f->hertz, 0.125 / f->h);
    real zeta = f->damping / per_side;
    real a1 = 2 * zeta + f->h * omega, a2 = f->h * omega * a1;
    real a3 = 1 / (1 + a2);
    return (softness){ omega / a1, a2 * a3, a3 };
}

static void run_pass(contact_solver *s, const solver_frame *f,
                     motion *velocity, const motion *moved,
                     void (*work)(void *data, int item))
{
    pass q = { .s = s, .velocity = velocity, .moved = moved, .per_h = 1 / f->h,
               .friction = f->friction, .max_speed = f->max_speed };
    for (int i = 0; i < SIDES; i++) q.soft[i] = softness_of(f, i);
    for (int c = 0; c < s->colors; c++) {
        q.first = s->color[c].first;
        q.count = s->color[c].count;
        q.sides = s->color[c].sides;
        tasks none = { 0 };
        tasks_run(s->color[c].is_crowded ? none : f->run, work, &q,
                  chunks(q.count));
    }
}

void solver_push(contact_solver *s, const solver_frame *f, motion *velocity,
                 const motion *moved)
{
    run_pass(s, f, velocity, moved, push_chunk);
}

void solver_relax(contact_solver *s, const solver_frame *f, motion *velocity,
                  const motion *moved)
{
    run_pass(s, f, velocity, moved, relax_chunk);
}
//<

//> solver-begin
// In the first substep the contacts push one by one; in the others each body
// gets at once what its contacts did to it in the last: s->before.
void solver_begin(contact_solver *s, const solver_frame *f, motion *velocity,
                  bool is_first)
{
    for (int b = 0; b < s->bodies; b++) {
        for (int i = 0; i < MOTIONS; i++) {
            real did = is_first ? 0 : s->before[b].of[i];
            s->before[b].of[i] = velocity[b].of[i];
            velocity[b].of[i] += did;
        }
    }
    if (is_first) run_pass(s, f, velocity, NULL, warm_chunk);
}

void solver_end(contact_solver *s, const motion *velocity)
{
    for (int b = 0; b < s->bodies; b++)
        for (int i = 0; i < MOTIONS; i++)
            s->before[b].of[i] = velocity[b].of[i] - s->before[b].of[i];
}
//<

//> solver-store
static void store_lane(const contact_solver *s, const block *k, int l,
                       contact *c)
{
    const active_contact *x = &s->active[k->contact[l]];
    real sign = x->is_swapped ? -1 : 1;
    for (int j = 0; j < x->count; j++)
        c->point[x->point[j]].impulse = real4_get(&k->point[j].impulse, l);
    for (int i = 0; i < 2; i++) {
        vec3 t = { real4_get(&k->across[i][0], l),
                   real4_get(&k->across[i][1], l),
                   real4_get(&k->across[i][2], l) };
        real impulse = sign * real4_get(&k->across_impulse[i], l);
        c->friction = vec3_add_scaled(c->friction, impulse, t);
    }
    c->twist = real4_get(&k->twist_impulse, l);
}

void solver_store(const contact_solver *s, contact *const *table)
{
    for (int k = 0; k < s->contacts; k++) {
        contact *c = table[k];
        for (int j = 0; j < c->count; j++) c->point[j].impulse = 0;
        c->friction = (vec3){ 0, 0, 0 };
        c->twist = 0;
    }
    for (int n = 0; n < s->blocks; n++)
        for (int l = 0; l < REAL4; l++) {
            int k = s->block[n].contact[l];
            if (k >= 0) store_lane(s, &s->block[n], l, table[k]);
        }
}
//<

//> solver-init
status solver_init(contact_solver *s, int bodies)
{
    size_t n = (size_t)bodies;
    *s = (contact_solver){ .bodies = bodies };
    s->taken = calloc(n + 1, sizeof *s->taken);
    s->before = aligned_alloc(64, (n + 1) * sizeof *s->before);
    if (!s->taken || !s->before) {
        solver_free(s);
        return status_out_of_memory();
    }
    memset(s->before, 0, (n + 1) * sizeof *s->before);
    return status_ok();
}

void solver_free(contact_solver *s)
{
    free(s->active);
    free(s->order);
    free(s->block);
    free(s->taken);
    free(s->before);
    *s = (contact_solver){ .bodies = 0 };
}
//<
