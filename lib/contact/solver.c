//> solver-active
//>   Which contacts take part, and in which order.
#include "solver.h"
#include "table.h"

#include <stdlib.h>
#include <string.h>

static bool is_side_driven(const solver_frame *f, int body)
{
    return body >= 0 && f->body[body].is_driven;
}

// Does a push move it?
static bool side_yields(const solver_frame *f, int body)
{
    return body >= 0 && f->body[body].basis.inverse_mass > 0
        && !f->body[body].is_driven;
}

// N: the weight of the body that lies on the other.  Notes which that is, and how
// much of the load bears it.
static real find_above(active_contact *x, const contact *c,
                       const solver_frame *f)
{
    real up = vec3_dot(c->normal, f->gravity);      // > 0: B lies on A
    int above = up > 0 ? c->b : c->a;
    if (x->count == 0 || !side_yields(f, above)) return 0;
    x->above = above;
    x->lift = x->load * fabs(up);
    return fabs(up) / f->body[above].basis.inverse_mass;
}

static void find_loads(active_contact *x, const contact *c,
                       const solver_frame *f)
{
    real inverse = f->body[x->a].basis.inverse_mass;
    if (x->sides == TWO_SIDED) inverse += f->body[x->b].basis.inverse_mass;
    x->weight = find_above(x, c, f) * inverse;
    x->borne = x->load * inverse / active_age(x, f);
}

// Contact c, and which of its points come within reach.
static void activate(active_contact *x, const contact *c, const solver_frame *f,
                     real reach)
{
    real gap[CONTACT_POINTS];
    const rigid_frame *b = c->b < 0 ? NULL : &f->body[c->b].frame;
    real height = c->b < 0 ? f->plane[-1 - c->b].offset : 0;
    bool yields_a = side_yields(f, c->a), yields_b = side_yields(f, c->b);
    x->found = c->found;
    x->a = yields_a ? c->a : c->b;
    x->b = yields_a ? c->b : c->a;
    x->is_swapped = !yields_a;
    x->sides = yields_a && yields_b ? TWO_SIDED
             : is_side_driven(f, x->b)   ? DRIVEN_SIDED : ONE_SIDED;
    x->load = contact_load(c);
    x->least = HUGE_VAL;
    x->count = 0;
    x->weight = x->borne = x->lift = 0;
    x->above = -1;
    x->is_deep = x->carries = false;
    if (!yields_a && !yields_b) return;
    contact_gaps(c, &f->body[c->a].frame, b, height, gap);
    for (int k = 0; k < c->count; k++) {
        x->least = real_min(gap[k], x->least);
        if (!(gap[k] < reach)) continue;
        x->point[x->count++] = (signed char)k;
        x->carries |= c->impulse[k] > 0;
    }
    find_loads(x, c, f);
    x->is_deep = x->count > 0
              && x->least < -CONTACT_DEEP * active_radius(x, f);
}

// Is x the contact y of the frame before, with the same points, in a block of the
// same kind?
static bool is_same(const active_contact *x, const active_contact *y)
{
    if (x->found != y->found || x->count != y->count || x->a != y->a
        || x->b != y->b || x->sides != y->sides
        || x->carries != y->carries) return false;
    for (int j = 0; j < x->count; j++)
        if (x->point[j] != y->point[j]) return false;
    return true;
}
//<

//> solver-color
//>   The 64 colours of a body are 64 bits. Contacts that find none free, on a
//>   table with a hundred cups, stand one in a block.
static void clear_colors(contact_solver *s, const active_contact *x)
{
    if (x->count == 0) return;
    for (int side = 0; side < SIDES; side++) {
        s->taken[x->a][side] = 0;
        if (x->sides == TWO_SIDED) s->taken[x->b][side] = 0;
    }
}

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

// Those of a colour stand together; of these, in blocks of their own, those that
// carry something, and of these those with as many points: a block takes as long as
// the contact in it that has most.
enum { KINDS = 2 * CONTACT_POINTS, BINS = SIDES * COLORS * KINDS };
typedef int color_counts[SIDES * COLORS][2];        // carrying nothing; something

static int bin_of(const active_contact *x)
{
    int fewer = CONTACT_POINTS - x->count;
    return x->color * KINDS + (x->carries ? fewer : KINDS - 1 - fewer);
}

// Counting sort.  Of most colours there is none, so of[color] counts them.
static void sort_contacts(contact_solver *s, color_counts of)
{
    int at[BINS] = { 0 }, sum = 0;
    for (int k = s->first; k < s->end; k++) {
        const active_contact *x = &s->active[k];
        if (x->count == 0) continue;
        of[x->color][x->carries]++;
        at[bin_of(x)]++;
    }
    for (int c = 0; c < SIDES * COLORS; c++) {
        int n = of[c][0] + of[c][1];
        for (int bin = c * KINDS; n > 0 && bin < (c + 1) * KINDS; bin++) {
            sum += at[bin];
            at[bin] = sum - at[bin];
        }
    }
    for (int k = s->first; k < s->end; k++)
        if (s->active[k].count > 0) s->order[at[bin_of(&s->active[k])]++] = k;
}

static void list_color(contact_solver *s, int color, bool carries, int first, int n)
{
    bool is_crowded = color % COLORS == COLORS - 1;
    int blocks = is_crowded ? n : (n + REAL4 - 1) / REAL4;
    if (n == 0) return;
    s->color[s->colors++] = (block_color){ s->blocks, blocks, first, n,
                                           color / COLORS, is_crowded, carries };
    s->blocks += blocks;
}

static void list_colors(contact_solver *s, color_counts of)
{
    int first = 0;
    s->colors = s->blocks = 0;
    for (int c = 0; c < SIDES * COLORS; c++) {
        list_color(s, c, true, first, of[c][1]);
        list_color(s, c, false, first + of[c][1], of[c][0]);
        first += of[c][0] + of[c][1];
    }
}
//<

//> solver-prepare
// Asked of memory two blocks before it is needed.
enum { BLOCKS_AHEAD = 2, CONTACTS_AHEAD = BLOCKS_AHEAD * REAL4 };

static void activate_chunk(void *data, int item)
{
    const preparation *p = data;
    int end = task_end(item, p->s->contacts);
    for (int k = item * TASK_CHUNK; k < end; k++) {
        active_contact *x = &p->s->active[k], was = *x;
        contact_expect(p->table[int_min(k + CONTACTS_AHEAD, end - 1)]);
        activate(x, p->table[k], p->f, p->reach[k]);
        x->is_new = k >= p->s->known || !is_same(x, &was);
    }
}

// Are the blocks those of the frame before?  Then one whose contacts are the same,
// with the same points, is good still: only its rows are made again.
static bool has_blocks(const contact_solver *s, const solver_frame *f)
{
    return s->end - s->first == s->contacts && f->h == s->h && f->warm == 1;
}

static bool may_keep_all(const contact_solver *s, const solver_frame *f)
{
    if (s->known != s->contacts || !has_blocks(s, f)) return false;
    for (int k = 0; k < s->contacts; k++)
        if (!solver_is_kept(&s->active[k], f)) return false;
    return true;
}

static bool make_solver_room(contact_solver *s, int n)
{
    int capacity = s->capacity;
    if (n > s->capacity) s->contacts = 0;
    return TABLE_RENEW(s->active, capacity, n)
        && TABLE_RENEW(s->order, s->capacity, n);
}

static void forget_blocks(contact_solver *s)
{
    s->contacts = s->blocks = s->colors = 0;
    s->first = s->end = 0;
}

// A block has as many points as the contact in it that has most.
static void count_points(contact_solver *s)
{
    int sum = 0;
    for (int n = 0; n < s->blocks; n++) {
        int most = 0, first, lanes = solver_lanes(s, n, &first);
        for (int k = first; k < first + lanes; k++)
            most = int_max(most, s->active[s->order[k]].count);
        s->start[n] = sum;
        sum += most;
    }
    s->start[s->blocks] = sum;
}

// Room for the blocks, and for their points.
static bool make_block_room(contact_solver *s)
{
    if (!TABLE_RENEW(s->block, s->block_capacity, s->blocks)
        || !TABLE_RENEW(s->start, s->start_capacity, s->blocks + 1)
        || !TABLE_RENEW(s->next_of, s->side_capacity, 2 * REAL4 * s->blocks))
        return false;
    count_points(s);
    return TABLE_RENEW(s->point, s->point_capacity, s->start[s->blocks])
        && TABLE_RENEW(s->place, s->place_capacity, s->start[s->blocks]);
}

static bool make_blocks(contact_solver *s, preparation *p)
{
    color_counts of = { { 0 } };
    for (int k = s->first; k < s->end; k++) clear_colors(s, &s->active[k]);
    for (int k = s->first; k < s->end; k++)
        if (s->active[k].count > 0) choose_color(s, &s->active[k]);
    sort_contacts(s, of);
    list_colors(s, of);
    const block *were = s->block;
    if (!make_block_room(s)) return false;
    if (s->block != were || !has_blocks(s, p->f)) p->known = 0;
    // Blocks of some of the contacts are not those of the next frame.
    s->h = s->end - s->first < s->contacts ? 0 : p->f->h;
    return true;
}

bool solver_activate(contact_solver *s, const solver_frame *f,
                     const contact *const *table, const real *reach, int n)
{
    preparation p = { .s = s, .f = f, .table = table, .reach = reach };
    if (!make_solver_room(s, n)) {
        forget_blocks(s);
        return false;
    }
    s->known = s->contacts;
    s->contacts = n;
    tasks_run(f->run, activate_chunk, &p, task_chunks(n));
    solver_take(s, 0, n);
    return true;
}

void solver_take(contact_solver *s, int first, int end)
{
    s->first = first;
    s->end = end;
}

bool solver_prepare(contact_solver *s, const solver_frame *f,
                    const contact *const *table)
{
    s->strikes = false;
    for (int k = s->first; k < s->end && !s->strikes; k++)
        s->strikes = s->active[k].count > 0 && solver_strikes(f, table[k]);
    preparation p = { .s = s, .f = f, .table = table, .known = s->blocks };
    p.is_same = may_keep_all(s, f);
    if (!p.is_same && !make_blocks(s, &p)) {
        forget_blocks(s);
        return false;
    }
    tasks_run(f->run, passes_best()->fill, &p,
              task_items(s->blocks, FEW_BLOCKS));
    return true;
}
//<

//> solver-pass
// Springs of a contact as Catto has them: a1, a2, a3 of an implicit step of h.
// Against what does not yield they are twice as stiff and half as damped.  None turns
// by more than this in a substep.
static const real EIGHTH = 0.125;           // tuned, turns

static softness softness_of(const solver_frame *f, int sides)
{
    const real two_pi = 6.283185307179586;
    real per_side = sides == TWO_SIDED ? 1 : 2;
    real omega = two_pi * per_side * real_min(f->hertz, EIGHTH / f->h);
    real zeta = f->damping / per_side;
    real a1 = 2 * zeta + f->h * omega, a2 = f->h * omega * a1;
    real a3 = 1 / (1 + a2);
    return (softness){ omega / a1, a2 * a3, a3 };
}

static void run_pass(contact_solver *s, const solver_frame *f,
                     motion *velocity, const motion *moved,
                     solver_work *work)
{
    solver_pass q = { .s = s, .f = f, .velocity = velocity, .moved = moved,
               .per_h = 1 / f->h, .max_rate = f->max_rate,
               .slowest = material_slowest(vec3_length(f->gravity), f->h) };
    for (int i = 0; i < SIDES; i++) q.soft[i] = softness_of(f, i);
    for (int c = 0; c < s->colors; c++) {
        q.first = s->color[c].first;
        q.count = s->color[c].count;
        q.sides = s->color[c].sides;
        q.carries = s->color[c].carries;
        tasks none = { 0 };
        tasks_run(s->color[c].is_crowded ? none : f->run, work, &q,
                  task_items(q.count, FEW_BLOCKS));
    }
}

void solver_renew(contact_solver *s, const solver_frame *f)
{
    preparation p = { .s = s, .f = f };
    tasks_run(f->run, passes_best()->renew, &p,
              task_items(s->blocks, FEW_BLOCKS));
}

void solver_update_gaps(contact_solver *s, const solver_frame *f,
                        const motion *moved)
{
    run_pass(s, f, NULL, moved, passes_best()->see);
}

void solver_push(contact_solver *s, const solver_frame *f, motion *velocity,
                 const motion *moved)
{
    run_pass(s, f, velocity, moved,
             passes_best()->push[s->strikes]);
}

void solver_find_strikes(contact_solver *s, const solver_frame *f,
                         motion *velocity)
{
    run_pass(s, f, velocity, NULL, passes_best()->strike);
}

void solver_relax(contact_solver *s, const solver_frame *f, motion *velocity,
                  const motion *moved)
{
    run_pass(s, f, velocity, moved,
             passes_best()->relax[s->strikes]);
}
//<

//> solver-begin
//>   Every contact starts a substep with the impulses of the last.
// Friction on what a driven body carries turns with that body, as the tangent of half
// the angle says.
static void turn_friction(block *k, int lane, const solver_frame *f,
                          const motion *velocity)
{
    int b = k->b[lane];
    if (k->contact[lane] < 0) return;
    vec3 normal = vec3_make(real4_get(&k->normal[0], lane),
                            real4_get(&k->normal[1], lane),
                            real4_get(&k->normal[2], lane));
    vec3 spin = motion_rotation(&f->body[b].basis, &velocity[b]);
    real half = f->h / 2 * vec3_dot(spin, normal);
    real scale = 1 / (1 + half * half), cosine = (1 - half * half) * scale;
    real sine = 2 * half * scale;
    real x = real4_get(&k->rub[0], lane), y = real4_get(&k->rub[1], lane);
    real4_set(&k->rub[0], lane, cosine * x - sine * y);
    real4_set(&k->rub[1], lane, sine * x + cosine * y);
}

void solver_warm(contact_solver *s, const solver_frame *f, motion *velocity)
{
    for (int n = 0; n < s->blocks; n++) {
        block *k = &s->block[n];
        for (int l = 0; l < REAL4 && k->is_driven && k->rubs; l++)
            turn_friction(k, l, f, velocity);
    }
    run_pass(s, f, velocity, NULL, passes_best()->warm);
}

void solver_mark(contact_solver *s)
{
    for (int n = 0; n < s->blocks; n++) {
        block *k = &s->block[n];
        for (int j = 0; j < k->points; j++)
            k->place[j].began = k->point[j].impulse;
        for (int i = 0; i < RUBS; i++) k->began[i] = k->rub[i];
    }
}

void solver_rewind(contact_solver *s)
{
    for (int n = 0; n < s->blocks; n++) {
        block *k = &s->block[n];
        for (int j = 0; j < k->points; j++)
            k->point[j].impulse = k->place[j].began;
        for (int i = 0; i < RUBS; i++) k->rub[i] = k->began[i];
        k->rubs = true;
    }
}

void solver_scale(contact_solver *s, real times)
{
    const real4 by = real4_all(times);
    for (int n = 0; n < s->blocks; n++) {
        block *k = &s->block[n];
        for (int j = 0; j < k->points; j++)
            k->point[j].impulse = real4_mul(by, k->point[j].impulse);
        for (int i = 0; i < RUBS; i++) k->rub[i] = real4_mul(by, k->rub[i]);
    }
}
//<

//> solver-store
//>   The impulses go back to the contacts that they came from.
static void store_lane(const block *k, int l, active_contact *x, contact *c)
{
    real sign = x->is_swapped ? -1 : 1, load = 0;
    contact_clear(c);
    for (int j = 0; j < x->count; j++) {
        c->impulse[x->point[j]] = real4_get(&k->point[j].impulse, l);
        load += c->impulse[x->point[j]];
    }
    for (int i = 0; i < 2; i++) {
        vec3 t = { real4_get(&k->across[i][0], l),
                   real4_get(&k->across[i][1], l),
                   real4_get(&k->across[i][2], l) };
        real impulse = sign * real4_get(&k->rub[i], l);
        c->friction = vec3_add_scaled(c->friction, impulse, t);
    }
    c->twist = real4_get(&k->rub[TWIST], l);
    x->load = load;
}

typedef struct {
    contact_solver *s;
    contact *const *table;
} storing;

static void write_block(contact_solver *s, const block *x, contact *const *table)
{
    for (int l = 0; l < REAL4; l++) {
        int k = x->contact[l];
        if (k >= 0) store_lane(x, l, &s->active[k], table[k]);
    }
}

static void clear_chunk(void *data, int item)
{
    const storing *q = data;
    int end = q->s->first + task_end(item, q->s->end - q->s->first);
    for (int k = q->s->first + task_first(item); k < end; k++) {
        if (q->s->active[k].count > 0) continue;
        contact_clear(q->table[k]);
        q->s->active[k].load = 0;
    }
}

// No contact is in two blocks.
static void store_chunk(void *data, int item)
{
    const storing *q = data;
    int end = task_end(item, q->s->blocks);
    for (int n = item * TASK_CHUNK; n < end; n++) {
        const block *next = &q->s->block[int_min(n + BLOCKS_AHEAD, end - 1)];
        for (int l = 0; l < REAL4; l++)
            if (next->contact[l] >= 0) contact_expect(q->table[next->contact[l]]);
        write_block(q->s, &q->s->block[n], q->table);
    }
}

void solver_store(contact_solver *s, tasks run, contact *const *table)
{
    storing q = { s, table };
    tasks_run(run, clear_chunk, &q, task_chunks(s->end - s->first));
    tasks_run(run, store_chunk, &q, task_chunks(s->blocks));
}

// Blocks are not good for the next frame, either.
void solver_forget(contact_solver *s, contact *const *table, int k)
{
    contact_clear(table[k]);
    s->active[k].load = 0;
    s->h = 0;
}
//<

//> solver-new
//>   Within a frame some contacts are found again. Only their blocks are filled
//>   again.
static bool has_new(const contact_solver *s, const block *k)
{
    bool some = false;
    for (int l = 0; l < REAL4; l++)
        some |= k->contact[l] >= 0 && s->active[k->contact[l]].is_new;
    return some;
}

static void write_blocks(contact_solver *s, contact *const *table, bool are_new)
{
    for (int n = 0; n < s->blocks; n++) {
        const block *x = &s->block[n];
        if (has_new(s, x) == are_new) write_block(s, x, table);
    }
}

void solver_store_new(contact_solver *s, contact *const *table)
{
    write_blocks(s, table, true);
}

// Has each of its contacts points enough in it?
static bool has_room(const contact_solver *s, const block *k)
{
    bool has = true;
    for (int l = 0; l < REAL4; l++)
        has &= k->contact[l] < 0
            || s->active[k->contact[l]].count <= k->points;
    return has;
}

// What they gave back are impulses of this substep, whatever they began it with.
bool solver_take_new(contact_solver *s, const solver_frame *f,
                     contact *const *table, const real *reach)
{
    solver_frame here = *f;
    here.age = NULL;
    preparation p = { .s = s, .f = &here,
                      .table = (const contact *const *)table };
    bool fits = true;
    for (int k = s->first; k < s->end; k++) {
        if (!s->active[k].is_new) continue;
        bool has_block = s->active[k].count > 0;
        activate(&s->active[k], table[k], &here, reach[k]);
        fits &= has_block || s->active[k].count == 0;
        s->strikes |= solver_strikes(f, table[k]);
    }
    for (int n = 0; n < s->blocks; n++) fits &= has_room(s, &s->block[n]);
    if (!fits) {
        write_blocks(s, table, false);
        return solver_prepare(s, &here, p.table);
    }
    for (int n = 0; n < s->blocks; n++)
        if (has_new(s, &s->block[n])) passes_best()->refill(&p, n);
    return true;
}
//<

//> solver-init
//>   Memory: made once, grown between frames, given back.
// Blocks may be kept for the next frame: their spare is another then.
static void move_spare(contact_solver *s, int spare)
{
    for (int k = 0; k < s->blocks; k++)
        for (int l = 0; l < REAL4; l++) {
            block *x = &s->block[k];
            if (x->a[l] == s->room) x->a[l] = spare;
            if (x->b[l] == s->room) x->b[l] = spare;
        }
    s->room = spare;
}

bool solver_grow(contact_solver *s, int bodies)
{
    int room = table_room(bodies, s->room);
    bool ok = true;
    if (s->taken && bodies <= s->room) return true;
    TABLE_GROW(ok, s->taken, 0, room);
    TABLE_GROW(ok, s->first_of, 0, room);
    if (ok) move_spare(s, room);
    return ok;
}

void solver_free(contact_solver *s)
{
    free(s->active);
    free(s->order);
    free(s->block);
    free(s->point);
    free(s->place);
    free(s->start);
    free(s->taken);
    free(s->first_of);
    free(s->next_of);
    *s = (contact_solver){ .contacts = 0 };
}
//<
