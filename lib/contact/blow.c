//> blow-rows
//>   A blow has the rows of all points that it goes through ([`impact`
//>   ](lib-impact.md)).
#include "blow.h"

typedef struct {
    contact_solver *s;
    motion *velocity;
    real per_h, slowest;        // 1/s, m/s
    impact_set set;
    struct {
        block *of;
        int lane, point;
    } at[IMPACT_ROWS];          // whose row it is
} blow;

static impact_row point_row(const block *k, int lane, int j)
{
    const block_point *p = &k->point[j];
    impact_row r = { .body = { k->a[lane], k->two ? k->b[lane] : -1 } };
    r.along = vec3_make(real4_get(&k->normal[0], lane),
                        real4_get(&k->normal[1], lane),
                        real4_get(&k->normal[2], lane));
    r.inverse[A] = real4_get(&k->inverse_a, lane);
    r.inverse[B] = k->is_driven ? 0 : real4_get(&k->inverse_b, lane);
    for (int t = 0; t < TURNS; t++) {
        r.turn[A][t] = real4_get(&p->turn_a[t], lane);
        r.turn[B][t] = k->two ? real4_get(&p->turn_b[t], lane) : 0;
    }
    return r;
}

// Beyond its gap.
static real parts(const blow *w, const block *k, int lane, int j,
                  const impact_row *r)
{
    real gap = real_max(real4_get(&k->point[j].now, lane), 0);
    return impact_parting(r, w->velocity) + w->per_h * gap;
}
//<

//> blow-spread
//>   A blow begins with one contact. What it makes close takes part as well.
static bool has_point(const block *k, int lane, int j)
{
    return real4_get(&k->place[j].has, lane) > 0;
}

static bool closes(const blow *w, block *k, int lane)
{
    bool some = false;
    if (real4_get(&k->strikes, lane) > 1) return false;     // it will bounce
    for (int j = 0; j < k->points && !some && !k->is_stale; j++) {
        impact_row r = point_row(k, lane, j);
        some = has_point(k, lane, j)
            && parts(w, k, lane, j, &r) < -w->slowest;
    }
    return some;
}

static void add_lane(blow *w, block *k, int lane)
{
    if (w->set.rows + k->points > IMPACT_ROWS) return;
    k->in_blow |= 1 << lane;
    for (int j = 0; j < k->points; j++) {
        if (!has_point(k, lane, j)) continue;
        int i = w->set.rows;
        impact_row r = point_row(k, lane, j);
        w->at[i].of = k;
        w->at[i].lane = lane;
        w->at[i].point = j;
        impact_add(&w->set, &r, parts(w, k, lane, j, &r));
    }
}

// The body on one side of a contact, if a blow goes on through it; else -1.
static int struck_body(const block *k, int lane, int side)
{
    if (k->contact[lane] < 0) return -1;
    if (side == A) return k->a[lane];
    return k->two && !k->is_driven ? k->b[lane] : -1;
}

// Threads the contacts of each body on a list.  A side is the number of a block,
// of a lane, and A or B.
static void list_sides(contact_solver *s)
{
    enum { A_BLOCK = BODIES * REAL4 };
    for (int x = 0; x < A_BLOCK * s->blocks; x++) {
        int b = struck_body(&s->block[x / A_BLOCK], x / BODIES % REAL4, x % BODIES);
        if (b >= 0) s->first_of[b] = -1;
    }
    for (int x = A_BLOCK * s->blocks - 1; x >= 0; x--) {
        int b = struck_body(&s->block[x / A_BLOCK], x / BODIES % REAL4, x % BODIES);
        if (b < 0) continue;
        s->next_of[x] = s->first_of[b];
        s->first_of[b] = x;
    }
}

static void spread_from(blow *w, int body)
{
    const contact_solver *s = w->s;
    for (int x = s->first_of[body]; x >= 0; x = s->next_of[x]) {
        block *k = &s->block[x / (BODIES * REAL4)];
        int lane = x / BODIES % REAL4;
        if (!(k->in_blow >> lane & 1) && closes(w, k, lane))
            add_lane(w, k, lane);
    }
}

static bool spread(blow *w)
{
    int before = w->set.rows;
    for (int i = 0; i < before; i++) {
        const impact_row *r = &w->set.row[i];
        if (w->at[i].point > 0) continue;
        spread_from(w, r->body[A]);
        if (r->inverse[B] > 0) spread_from(w, r->body[B]);
    }
    return w->set.rows > before;
}
//<

//> blow
//>   While the substep lasts, the blow is part of the impulses: friction, and
//>   what hears contacts, ask for all of it.
static void keep_blow(const blow *w)
{
    for (int i = 0; i < w->set.rows; i++) {
        block *k = w->at[i].of;
        int lane = w->at[i].lane, j = w->at[i].point;
        real4 *sum = &k->point[j].impulse, *blows = &k->place[j].blow;
        real4_set(sum, lane, real4_get(sum, lane) + w->set.impulse[i]);
        real4_set(blows, lane, real4_get(blows, lane) + w->set.impulse[i]);
        k->has_blow = k->rubs = true;
        k->in_blow = 0;
    }
}

void blow_stop(contact_solver *s, const solver_frame *f, motion *velocity)
{
    blow w;
    solver_find_strikes(s, f, velocity);
    w.s = s;
    w.velocity = velocity;
    w.per_h = 1 / f->h;
    w.slowest = material_slowest(vec3_length(f->gravity), f->h);
    bool is_listed = false;
    for (int n = 0; n < s->blocks; n++) {
        block *k = &s->block[n];
        for (int l = 0; l < REAL4; l++) {
            if (!(real4_get(&k->closing, l) < 0)) continue;
            if (!is_listed) list_sides(s);
            is_listed = true;
            if (!closes(&w, k, l)) continue;
            impact_begin(&w.set);
            add_lane(&w, k, l);
            do {
                impact_stop(&w.set);
                impact_apply(&w.set, velocity);
            } while (spread(&w));
            keep_blow(&w);
        }
    }
}

void blow_forget(contact_solver *s)
{
    const real4 zero = real4_all(0);
    for (int n = 0; n < s->blocks; n++) {
        block *k = &s->block[n];
        if (!k->has_blow && !real4_any(k->struck)) continue;
        k->has_blow = false;
        real4 all = zero, left = zero;
        for (int j = 0; j < k->points; j++) {
            real4 *sum = &k->point[j].impulse;
            all = real4_add(all, *sum);
            *sum = real4_max(real4_sub(*sum, k->place[j].blow), zero);
            left = real4_add(left, *sum);
            k->place[j].blow = zero;
        }
        // Friction under the blow goes with the blow, and all friction where a
        // point struck: it has stopped the slip.  If friction were given again
        // while nothing presses, it would turn the body into the ground, and the
        // ground would push back: boxes that tumble would gain energy.
        real4 fraction = real4_if_positive(all, real4_div(left, all), zero);
        fraction = real4_if_positive(k->struck, zero, fraction);
        for (int i = 0; i < RUBS; i++)
            k->rub[i] = real4_mul(fraction, k->rub[i]);
    }
}
//<
