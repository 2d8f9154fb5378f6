//> blow-rows
//>   A blow has the rows of all points that it goes through, and K, whose element
//>   i, j says how fast a unit impulse along row j parts the points of row i.
#include "blow.h"

enum { A, B, BODIES };

typedef struct {
    block *of;                  // whose point it is
    int  lane, point;
    int  body[BODIES];          // B < 0: it does not move
    bool yields[BODIES];
    vec3 normal;
    real turn[BODIES][TURNS], inverse[BODIES];
    real least;                 // m/s, at which an open gap just closes
} blow_row;

typedef struct {
    contact_solver *s;
    motion *velocity;
    real per_h, slowest;        // 1/s, m/s
    int  rows, count, good;     // of the set, so many are factored
    blow_row row[BLOW_ROWS];
    real part[BLOW_ROWS];       // m/s, how it parts beyond least without a blow
    real impulse[BLOW_ROWS], given[BLOW_ROWS];      // N s
    int  set[BLOW_ROWS];        // the rows that push
    real k[BLOW_ROWS][BLOW_ROWS], l[BLOW_ROWS][BLOW_ROWS];
    real d[BLOW_ROWS], y[BLOW_ROWS], stop[BLOW_ROWS];
} blow;

static blow_row row_of(const blow *w, block *k, int lane, int j)
{
    const block_point *p = &k->point[j];
    blow_row r = { .of = k, .lane = lane, .point = j };
    r.normal = vec3_make(real4_get(&k->normal[0], lane),
                         real4_get(&k->normal[1], lane),
                         real4_get(&k->normal[2], lane));
    r.body[A] = k->a[lane];
    r.body[B] = k->two ? k->b[lane] : -1;
    r.yields[A] = true;
    r.yields[B] = k->two && !k->is_driven;
    r.inverse[A] = real4_get(&k->inverse_a, lane);
    r.inverse[B] = r.yields[B] ? real4_get(&k->inverse_b, lane) : 0;
    for (int t = 0; t < TURNS; t++) {
        r.turn[A][t] = real4_get(&p->turn_a[t], lane);
        r.turn[B][t] = k->two ? real4_get(&p->turn_b[t], lane) : 0;
    }
    r.least = -w->per_h * real_max(real4_get(&p->now, lane), 0);
    return r;
}

static real row_parts(const blow_row *r, const motion *velocity)
{
    real sum = -r->least;
    for (int side = A; side < BODIES && r->body[side] >= 0; side++) {
        const real *u = velocity[r->body[side]].of;
        real x = r->normal.x * u[0] + r->normal.y * u[1] + r->normal.z * u[2];
        for (int t = 0; t < TURNS; t++)
            x += r->turn[side][t] * u[MOTION_TURN + t];
        sum += side == A ? x : -x;
    }
    return sum;
}

static void row_push(const blow_row *r, real impulse, motion *velocity)
{
    for (int side = A; side < BODIES; side++) {
        if (!r->yields[side]) continue;
        real j = side == A ? impulse : -impulse;
        real straight = j * r->inverse[side];
        real *u = velocity[r->body[side]].of;
        u[0] += straight * r->normal.x;
        u[1] += straight * r->normal.y;
        u[2] += straight * r->normal.z;
        for (int t = 0; t < TURNS; t++)
            u[MOTION_TURN + t] += j * r->turn[side][t];
    }
}

static real row_product(const blow_row *r, const blow_row *s)
{
    real sum = 0;
    for (int i = A; i < BODIES; i++)
        for (int j = A; j < BODIES; j++) {
            if (!r->yields[i] || r->body[i] != s->body[j]) continue;
            real x = r->inverse[i] * vec3_dot(r->normal, s->normal);
            for (int t = 0; t < TURNS; t++)
                x += r->turn[i][t] * s->turn[j][t];
            sum += i == j ? x : -x;
        }
    return sum;
}
//<

//> blow-stop
//>   Its impulses are found as those of one contact are ([`restitution`
//>   ](lib-restitution.md)): by the active set of Lawson and Hanson. A row that
//>   joins the set adds a line to its factors.
// False if the last row of the set can do nothing that the others cannot.
static bool factor(blow *w)
{
    for (int i = w->good; i < w->count; i++) {
        const real *row = w->k[w->set[i]];
        w->d[i] = row[w->set[i]];
        w->y[i] = -w->part[w->set[i]];
        for (int j = 0; j < i; j++) {
            real sum = row[w->set[j]];
            for (int k = 0; k < j; k++)
                sum -= w->l[i][k] * w->l[j][k] * w->d[k];
            w->l[i][j] = sum / w->d[j];
            w->d[i] -= w->l[i][j] * sum;
            w->y[i] -= w->l[i][j] * w->y[j];
        }
        if (!(w->d[i] > 1e-12 * row[w->set[i]])) return false;
        w->good = i + 1;
    }
    for (int i = w->count - 1; i >= 0; i--) {
        w->stop[i] = w->y[i] / w->d[i];
        for (int j = i + 1; j < w->count; j++)
            w->stop[i] -= w->l[j][i] * w->stop[j];
    }
    return true;
}

// Towards the impulses of the set, until one would pull: that is dropped.
static bool go_to_set(blow *w)
{
    real share = 1;
    int least = -1, kept = 0;
    for (int i = 0; i < w->count; i++) {
        real now = w->impulse[w->set[i]];
        if (w->stop[i] > 0 || !(now < share * (now - w->stop[i]))) continue;
        share = now / (now - w->stop[i]);
        least = i;
    }
    for (int i = 0; i < w->count; i++) {
        real *now = &w->impulse[w->set[i]];
        *now = i == least ? 0 : *now + share * (w->stop[i] - *now);
        if (i != least) w->set[kept++] = w->set[i];
    }
    w->count = kept;
    if (least >= 0) w->good = int_min(w->good, least);
    return least < 0;
}

// The row that closes fastest, beyond rounding, of those that do not push.
static int find_closing(const blow *w)
{
    real most = 0, fastest = w->slowest;
    int found = -1;
    for (int i = 0; i < w->rows; i++) {
        real closing = -w->part[i];
        fastest = real_max(closing, fastest);
        for (int j = 0; j < w->rows; j++)
            closing -= w->k[i][j] * w->impulse[j];
        if (w->impulse[i] > 0 || !(closing > most)) continue;
        most = closing;
        found = i;
    }
    return most > 1e-9 * fastest ? found : -1;
}

static void stop_rows(blow *w)
{
    bool stops = true;
    for (int n = 0; n < 4 * BLOW_ROWS && stops; n++) {
        int next = find_closing(w);
        if (next < 0 || w->count == BLOW_ROWS) break;
        w->set[w->count++] = next;
        do stops = factor(w);
        while (stops && !go_to_set(w));
        if (!stops) w->count = w->good;
    }
    for (int i = 0; i < w->rows; i++) {
        row_push(&w->row[i], w->impulse[i] - w->given[i], w->velocity);
        w->given[i] = w->impulse[i];
    }
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
        blow_row r = row_of(w, k, lane, j);
        some = has_point(k, lane, j)
            && row_parts(&r, w->velocity) < -w->slowest;
    }
    return some;
}

static void add_contact(blow *w, block *k, int lane)
{
    if (w->rows + k->points > BLOW_ROWS) return;
    k->in_blow |= 1 << lane;
    for (int j = 0; j < k->points; j++) {
        if (!has_point(k, lane, j)) continue;
        int i = w->rows++;
        w->row[i] = row_of(w, k, lane, j);
        w->impulse[i] = w->given[i] = 0;
        w->part[i] = row_parts(&w->row[i], w->velocity);
        for (int n = 0; n <= i; n++) {
            w->k[i][n] = w->k[n][i] = row_product(&w->row[i], &w->row[n]);
            w->part[i] -= w->k[i][n] * w->given[n];
        }
    }
}

// The body on one side of a contact, if a blow goes on through it; else -1.
static int body_of(const block *k, int lane, int side)
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
        int b = body_of(&s->block[x / A_BLOCK], x / BODIES % REAL4, x % BODIES);
        if (b >= 0) s->first_of[b] = -1;
    }
    for (int x = A_BLOCK * s->blocks - 1; x >= 0; x--) {
        int b = body_of(&s->block[x / A_BLOCK], x / BODIES % REAL4, x % BODIES);
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
            add_contact(w, k, lane);
    }
}

static bool spread(blow *w)
{
    int before = w->rows;
    for (int i = 0; i < before; i++) {
        const blow_row *r = &w->row[i];
        if (r->point > 0) continue;
        spread_from(w, r->body[A]);
        if (r->yields[B]) spread_from(w, r->body[B]);
    }
    return w->rows > before;
}
//<

//> blow
//>   While the substep lasts, the blow is part of the impulses: friction, and
//>   what hears contacts, ask for all of it.
static void keep_blow(const blow *w)
{
    for (int i = 0; i < w->rows; i++) {
        const blow_row *r = &w->row[i];
        real4 *sum = &r->of->point[r->point].impulse;
        real4 *blows = &r->of->place[r->point].blow;
        real4_set(sum, r->lane, real4_get(sum, r->lane) + w->impulse[i]);
        real4_set(blows, r->lane, real4_get(blows, r->lane) + w->impulse[i]);
        r->of->is_struck = r->of->rubs = true;
        r->of->in_blow = 0;
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
            w.rows = w.count = w.good = 0;
            add_contact(&w, k, l);
            do stop_rows(&w);
            while (spread(&w));
            keep_blow(&w);
        }
    }
}

void blow_forget(contact_solver *s)
{
    const real4 zero = real4_all(0);
    for (int n = 0; n < s->blocks; n++) {
        block *k = &s->block[n];
        if (!k->is_struck) continue;
        k->is_struck = false;
        real4 all = zero, left = zero;
        for (int j = 0; j < k->points; j++) {
            real4 *sum = &k->point[j].impulse;
            all = real4_add(all, *sum);
            *sum = real4_max(real4_sub(*sum, k->place[j].blow), zero);
            left = real4_add(left, *sum);
            k->place[j].blow = zero;
        }
        // What rubbed under it goes with it.
        real4 share = real4_if_positive(all, real4_div(left, all), zero);
        for (int i = 0; i < RUBS; i++)
            k->rub[i] = real4_mul(share, k->rub[i]);
    }
}
//<
