//> push-points
#include "push.h"

#include <string.h>

// How the points stand to each other now, and when the substep began.
typedef struct {
    vec3 now, before;       // m, pA - pB
} distance;

static inline void add_particle(distance *d, real a, const particle *p)
{
    d->now = vec3_add_scaled(d->now, a, p->position);
    d->before = vec3_add_scaled(d->before, a, p->previous);
}

// (A loop of known length is unrolled.)
static inline void add_side(const push_side *s, const particle *p, real sign,
                            distance *d)
{
    p += s->first;
    if (s->count == 1) {
        add_particle(d, sign * s->share[0], p);
        return;
    }
    for (int k = 0; k < FOUR; k++) add_particle(d, sign * s->share[k], &p[k]);
}

// Reads off the particles how far the points are apart.
static inline void look(push *c, const particle *p)
{
    distance d = { { 0, 0, 0 }, { 0, 0, 0 } };
    add_side(&c->a, p, 1, &d);
    if (c->b.count > 0) {
        add_side(&c->b, p, -1, &d);
    } else {
        d.now = vec3_sub(d.now, c->fixed);
        d.before = vec3_sub(d.before, c->fixed);
    }
    vec3 slid = vec3_sub(d.now, d.before);
    c->before = vec3_dot(d.before, c->along[NORMAL]) - c->thickness;
    c->apart[NORMAL] = vec3_dot(d.now, c->along[NORMAL]) - c->thickness;
    c->apart[ACROSS] = vec3_dot(slid, c->along[ACROSS]);
    c->apart[ASIDE] = vec3_dot(slid, c->along[ASIDE]);
}
//<

//> push-rows
void push_directions(push *c, vec3 n)
{
    real x = fabs(n.x), y = fabs(n.y), z = fabs(n.z);
    vec3 least = { x <= y && x <= z, y < x && y <= z, z < x && z < y };
    c->along[NORMAL] = n;
    c->along[ACROSS] = vec3_unit(vec3_cross(n, least));
    c->along[ASIDE] = vec3_cross(n, c->along[ACROSS]);
}

static inline real row_dot(const real row[FOUR_WAYS], const real way[FOUR_WAYS])
{
    return row[0] * way[0] + row[2] * way[2] + row[4] * way[4]
        + (row[1] * way[1] + row[3] * way[3] + row[5] * way[5]);
}

// The rows of one side.  A single particle goes along x, y and z only.
static void side_rows(push *c, const push_side *s, int side, const particle *p)
{
    vec3 along[DIRECTIONS];
    for (int d = 0; d < DIRECTIONS; d++)
        along[d] = vec3_scale(side ? -1 : 1, c->along[d]);
    if (s->ways) {
        rigid4_rows(s->ways, s->share, along, c->row[side]);
    } else {
        real root = sqrt(p[s->first].inverse_mass);
        for (int d = 0; d < DIRECTIONS; d++) {
            real *row = c->row[side][d];
            row[0] = root * along[d].x;
            row[1] = root * along[d].y;
            row[2] = root * along[d].z;
            row[3] = row[4] = row[5] = 0;
        }
    }
    for (int d = 0; d < DIRECTIONS; d++)
        c->weight[d] += row_dot(c->row[side][d], c->row[side][d]);
    c->skew[ACROSS] += row_dot(c->row[side][NORMAL], c->row[side][ACROSS]);
    c->skew[ASIDE] += row_dot(c->row[side][NORMAL], c->row[side][ASIDE]);
    c->skew[NORMAL] += row_dot(c->row[side][ACROSS], c->row[side][ASIDE]);
}
//<

//> push-undo
// The pushes l that undo the gap and both slides b at once:
//     | w0 s1 s2 |
//     | s1 w1 s0 | l = -b,   by Cramer's rule: undo is the inverse.
//     | s2 s0 w2 |
static void find_undo(push *c)
{
    const real *w = c->weight, *s = c->skew;
    vec3 p = { w[0], s[1], s[2] }, q = { s[1], w[1], s[0] };
    vec3 r = { s[2], s[0], w[2] }, qr = vec3_cross(q, r);
    real volume = vec3_dot(p, qr);
    c->holds = volume > 1e-9 * w[0] * w[1] * w[2];
    if (!c->holds) return;
    c->undo[0] = vec3_scale(1 / volume, qr);
    c->undo[1] = vec3_scale(1 / volume, vec3_cross(r, p));
    c->undo[2] = vec3_scale(1 / volume, vec3_cross(p, q));
}

// Made when the contact is first needed: many never are.
static inline int make_ready(push *c, const particle *p)
{
    if (!c->ready) {
        for (int d = 0; d < DIRECTIONS; d++) c->weight[d] = c->skew[d] = 0;
        side_rows(c, &c->a, 0, p);
        if (c->b.count > 0) side_rows(c, &c->b, 1, p);
        else                memset(c->row[1], 0, sizeof c->row[1]);
        find_undo(c);
        c->length = sqrt(real_max(c->weight[NORMAL],
                                  real_max(c->weight[ACROSS],
                                           c->weight[ASIDE])));
        c->ready = 1;
    }
    return c->weight[NORMAL] > 0;
}
//<

//> push-along
// How far bodies A and B, pushed so far along their ways, part the points, and
// how far apart these are then.  (Rows of what does not move are zero.)
static inline real parted(const push *c, int d, const real *a, const real *b)
{
    return row_dot(c->row[0][d], a) + row_dot(c->row[1][d], b);
}

static inline void find_apart(const push *c, const real *a, const real *b,
                              real apart[DIRECTIONS])
{
    rigid4_part(c->row[0], c->row[1], c->apart, a, b, apart);
}

// Pushes A by l, B by -l.
static inline void push_by(const push *c, const real l[DIRECTIONS],
                           real *a, real *b)
{
    rigid4_go(c->row[0], l, a);
    if (c->b.count > 0) rigid4_go(c->row[1], l, b);
}
//<

//> push-remember-code
// A force F moves what it pushes by F h^2 / m in a substep.
push_memory push_remember(const push *c, real h)
{
    push_memory m = { .share = { 0 } };
    for (int k = 0; k < FOUR; k++) m.share[k] = c->a.share[k];
    for (int i = 0; i < DIRECTIONS; i++)
        m.force = vec3_add_scaled(m.force, c->pushed[i] / (h * h),
                                  c->along[i]);
    return m;
}

void push_recall(push *c, const push_memory *m, real h)
{
    real l[DIRECTIONS];
    for (int i = 0; i < DIRECTIONS; i++)
        l[i] = h * h * vec3_dot(m->force, c->along[i]);
    c->pushed[NORMAL] += real_max(l[NORMAL], 0);
    c->pushed[ACROSS] += l[ACROSS];
    c->pushed[ASIDE] += l[ASIDE];
}
//<

//> push-wear
// The work of a push is the push times the mean of the slides before and after
// it: friction's share of what l will do, to points that have slid so far.
static inline void wear(push *c, const real apart[DIRECTIONS],
                        const real l[DIRECTIONS])
{
    real across = apart[ACROSS] + c->skew[ACROSS] * l[NORMAL]
        + (c->weight[ACROSS] * l[ACROSS] + c->skew[NORMAL] * l[ASIDE]) / 2;
    real aside = apart[ASIDE] + c->skew[ASIDE] * l[NORMAL]
        + (c->weight[ASIDE] * l[ASIDE] + c->skew[NORMAL] * l[ACROSS]) / 2;
    c->worn += l[ACROSS] * across + l[ASIDE] * aside;
}
//<

//> push-mend
static inline void limit_mending(push *c, push_options options, real h)
{
    c->most = c->before + options.mend_speed * h;
}

void push_limit(push *c, const particle *p, push_options options, real h)
{
    look(c, p);
    limit_mending(c, options, h);
}

// What is mended of an overlap.  One that goes by itself, for the points part,
// is left to go; and the slop is left to stay: were the overlap mended to
// nothing, the next contact's mending would leave a gap, into which the body
// falls within one substep.  Mending would make speed after all, and a pile
// never come to rest.
static inline real mended(const push *c, real now, real before,
                          push_options options)
{
    real depth = -real_max(before, now) - options.slop * c->thickness;
    return real_max(real_min(options.mend * depth, c->most - before), 0);
}
//<

//> push-brake
// Coulomb: the push across is at most friction times the push along the normal.
// Each direction is asked to undo what the points have slid in this substep,
// and will by the push l[NORMAL]; then both are shortened alike until they lie
// within the cone.
static inline void brake(push *c, const real apart[DIRECTIONS],
                         push_options options, real l[DIRECTIONS])
{
    real across[DIRECTIONS] = { 0 }, size2 = 0;
    real limit = options.friction * c->pushed[NORMAL];
    for (int i = ACROSS; i < DIRECTIONS; i++) {
        real slide = apart[i] + c->skew[i] * l[NORMAL];
        across[i] = c->pushed[i] - slide / c->weight[i];
        size2 += across[i] * across[i];
    }
    real scale = size2 <= limit * limit ? 1 : limit / sqrt(size2);
    for (int i = ACROSS; i < DIRECTIONS; i++) {
        l[i] = scale * across[i] - c->pushed[i];
        c->pushed[i] = scale * across[i];
    }
}
//<

//> push-stick
// The push that undoes all three at once.  0 if it would pull, or leaves
// Coulomb's cone.  (One direction after the other would do in the end, but in
// another order backward than forward: what passes gain they lose again.)
static inline int hold(push *c, const real b[DIRECTIONS], real friction,
                       real l[DIRECTIONS])
{
    vec3 lack = { -b[0], -b[1], -b[2] };
    real in[DIRECTIONS];
    if (!c->holds) return 0;
    for (int i = 0; i < DIRECTIONS; i++) {
        l[i] = vec3_dot(c->undo[i], lack);
        in[i] = c->pushed[i] + l[i];
    }
    real most = friction * in[NORMAL];
    if (!(in[NORMAL] > 0 && in[ACROSS] * in[ACROSS] + in[ASIDE] * in[ASIDE]
                            <= most * most)) return 0;
    for (int i = 0; i < DIRECTIONS; i++) c->pushed[i] = in[i];
    return 1;
}
//<

//> push-solve
// The points are `apart` now (a gap, two slides) and were `before` when the
// substep began: what parts them, in l.
static inline void find_push(push *c, const real apart[DIRECTIONS], real before,
                        push_options options, real l[DIRECTIONS])
{
    real b[DIRECTIONS] = { apart[NORMAL] - real_min(before, 0),
                           apart[ACROSS], apart[ASIDE] };
    if (!hold(c, b, options.friction, l)) {
        real was = c->pushed[NORMAL];
        c->pushed[NORMAL] = real_max(was - b[NORMAL] / c->weight[NORMAL], 0);
        l[NORMAL] = c->pushed[NORMAL] - was;
        brake(c, apart, options, l);
    }
    if (options.book) wear(c, apart, l);
}
//<

//> push-alone
// One contact by itself: what moves its bodies moves their particles at once.
static void move_side(const push_side *s, particle *p, const push_drift *d)
{
    p += s->first;
    if (s->count == 0) return;
    if (s->ways) {
        drift_apply(d, s->ways, p);
        return;
    }
    real root = sqrt(p->inverse_mass);
    vec3 now = { d->pushed[0], d->pushed[1], d->pushed[2] };
    vec3 both = { d->mended[0], d->mended[1], d->mended[2] };
    p->position = vec3_add_scaled(p->position, root, vec3_add(now, both));
    p->previous = vec3_add_scaled(p->previous, root, both);
}

// Moves where the particles are; with both, where they were as well.
static void push_alone(push *c, particle *p, const real l[DIRECTIONS],
                       int both)
{
    push_drift a = { .is_mended = both }, b = a;
    if (both) push_by(c, l, a.mended, b.mended);
    else      push_by(c, l, a.pushed, b.pushed);
    move_side(&c->a, p, &a);
    move_side(&c->b, p, &b);
}

// A push l moves the points by weight * l.
void push_mend(push *c, particle *p, push_options options)
{
    real l[DIRECTIONS] = { 0 };
    look(c, p);
    real up = mended(c, c->apart[NORMAL], c->before, options);
    if (!(up > 0) || !make_ready(c, p)) return;
    l[NORMAL] = up / c->weight[NORMAL];
    push_alone(c, p, l, 1);
}

real push_solve(push *c, particle *p, push_options options)
{
    real l[DIRECTIONS];
    look(c, p);
    if (c->pushed[NORMAL] == 0 && !(c->apart[NORMAL] < 0)) return 0;
    if (!make_ready(c, p)) return 0;
    find_push(c, c->apart, c->before, options, l);
    push_alone(c, p, l, 0);
    return fabs(l[NORMAL]) * c->weight[NORMAL];
}
//<

//> push-blow
// 1 if gravity moves this side.
static int falls(const push_side *s, const particle *p)
{
    return s->count > 0 && p[s->first].inverse_mass > 0;
}

// When, and how fast, the points of a contact touch.  With gap g > 0 at the
// start of the substep and closing s in it they touch after the share
// t = g / s.  But what falls on something immovable falls faster and faster: s
// is the speed in the middle, and with a, in m a substep squared,
//     g = t u + t^2 a/2,  u = s - a/2,   closing = s + (t - 1/2) a,
// of which t = (root - u) / a = 2 g / (u + root), root = sqrt(u^2 + 2 a g), is
// the time when they first close: the second if u > 0, where the first loses
// digits; else they part at first, and fall back.
// What touches a thousandth of a substep too late takes part as well: rounding
// is not to decide which corners of a face do.
static void foresee(push *c, const particle *p, push_options options)
{
    look(c, p);
    real gap = c->before, s = gap - c->apart[NORMAL];
    real a = (falls(&c->b, p) - falls(&c->a, p))
           * vec3_dot(options.fall, c->along[NORMAL]);
    c->closing = c->share = 0;
    if (!(s > 0 && gap < 1.001 * s) || !make_ready(c, p)) return;
    real u = s - a / 2, high = real_max(gap, 0);
    real root = sqrt(real_max(u * u + 2 * a * high, 0));
    c->share = real_min(u > 0 ? 2 * high / (u + root) : (root - u) / a, 1);
    real more = (c->share - 0.5) * a;
    c->closing = real_max(s + more, 0);
    c->parting = options.restitution * c->closing + more;
}

// Gives one contact the parting that it is due: restitution times closing when
// they touch, which is so much in the middle of the substep.
static void strike(push *c, particle *p, push_options options)
{
    look(c, p);
    real l[DIRECTIONS] = { 0 }, was = c->pushed[NORMAL];
    real want = c->before - c->apart[NORMAL] + c->parting;
    c->pushed[NORMAL] = real_max(was + want / c->weight[NORMAL], 0);
    l[NORMAL] = c->pushed[NORMAL] - was;
    brake(c, c->apart, options, l);
    if (options.book) wear(c, c->apart, l);
    push_alone(c, p, l, 0);
}

// What the blow moves, it moves for the rest of the substep only: the share
// before it is taken back, of both places, now and before.
static void settle_blow(push *c, particle *p)
{
    real l[DIRECTIONS];
    for (int d = 0; d < DIRECTIONS; d++) l[d] = -c->share * c->pushed[d];
    push_alone(c, p, l, 1);
}

static void forget(push *c)
{
    for (int d = 0; d < DIRECTIONS; d++) c->pushed[d] = 0;
}

int push_blow(push *c, int n, particle *p, push_options options, real slowest)
{
    enum { ROUNDS = 20 };
    int fast = 0;
    for (int i = 0; i < n; i++) {
        foresee(&c[i], p, options);
        fast |= c[i].closing > slowest;
    }
    if (!fast) return 0;
    for (int i = 0; i < n; i++) forget(&c[i]);
    for (int round = 0; round < ROUNDS; round++)
        for (int i = 0; i < n; i++)
            if (c[i].closing > 0) strike(&c[i], p, options);
    for (int i = 0; i < n; i++) {
        if (c[i].closing > 0) settle_blow(&c[i], p);
        forget(&c[i]);
    }
    return 1;
}
//<

//> push-pile-near
// The drift of a contact's body.  Nothing pushes one that does not move, but
// its numbers are read, and written as they were: so each part has its own.
static inline push_drift *drift_of(const push_pile *s, int part, int body)
{
    return &s->drift[body >= 0 ? body : s->bodies + part];
}

// Where the near ones of a part stand.
static inline push_near *nears_of(const push_pile *s, int part)
{
    return s->near + (part > 0 ? s->end[part - 1] : 0);
}

//<

//> push-pile-stir
// How far a push l takes its bodies along their ways at most, in m kg^(1/2): a
// unit push takes them by the length of its rows, and that of A's and B's rows
// together is the root of the weight.  Tells those that move; returns the sum
// of what they are told.
static inline real stir(const push_pile *s, int part, const push *c,
                        const push_near *n, const real l[DIRECTIONS])
{
    const push_drift *none = drift_of(s, part, -1);
    real way = c->length * (fabs(l[NORMAL]) + fabs(l[ACROSS]) + fabs(l[ASIDE]));
    real sum = 0;
    if (n->a != none) n->a->stirred += way, sum += way;
    if (n->b != none) n->b->stirred += way, sum += way;
    return sum;
}
//<

//> push-pile-is-near
// How many more substeps go by before the gap may be as narrow as `near`?
static int substeps_away(const push *c)
{
    real n = 2 * (c->apart[NORMAL] - c->near) / c->near;
    return n < 100 ? (int)n : 100;
}

// 1 if the contact pushed in the last substep, or may come to touch in this.
static int is_near(push *c, const particle *p)
{
    if (c->far > 0) {
        c->far--;
        return 0;
    }
    look(c, p);
    if (c->pushed[NORMAL] > 0 || c->apart[NORMAL] <= c->near)
        return make_ready(c, p);
    if (c->apart[NORMAL] > c->near) c->far = substeps_away(c);
    return 0;
}

static void push_again(push_pile *s, int part, push *c, const push_near *n,
                       push_options options)
{
    real *a = n->a->pushed, *b = n->b->pushed, apart[DIRECTIONS];
    if (!(c->pushed[NORMAL] > 0)) return;
    if (options.book) {
        find_apart(c, a, b, apart);
        wear(c, apart, c->pushed);
    }
    push_by(c, c->pushed, a, b);
    stir(s, part, c, n, c->pushed);
}
//<

//> push-pile-mend
// m, how far mending has parted the points.  Few bodies are mended at all.
static inline real parted_by_mending(const push_pile *s, const push_near *n)
{
    if (!n->a->is_mended && !n->b->is_mended) return 0;
    return parted(&s->push[n->push], NORMAL, n->a->mended, n->b->mended);
}

// 1 if anything was mended.
static int mend(push_pile *s, int part, const push_near *n,
                push_options options)
{
    push *c = &s->push[n->push];
    real both = parted_by_mending(s, n), l[DIRECTIONS] = { 0 };
    real before = c->before + both;
    if (before >= -options.slop * c->thickness) return 0;
    const push_drift *none = drift_of(s, part, -1);
    push_drift *a = n->a, *b = n->b;
    real now = c->apart[NORMAL] + both
             + parted(c, NORMAL, a->pushed, b->pushed);
    real up = mended(c, now, before, options);
    if (!(up > 0)) return 0;
    l[NORMAL] = up / c->weight[NORMAL];
    push_by(c, l, a->mended, b->mended);
    a->is_mended = a != none;
    b->is_mended = b != none;
    return 1;
}

// What is mended between bodies is mended against the planes, which come first
// in the table, after that: else those that lie in each other press one another
// through a wall.
int pile_mend(push_pile *s, int part, push_options options)
{
    const push_near *n = nears_of(s, part);
    int is_mended = 0;
    for (int i = s->nears[part] - 1; i >= 0; i--)
        is_mended |= mend(s, part, &n[i], options);
    return is_mended;
}

void pile_settle(push_pile *s, int part)
{
    push_near *n = nears_of(s, part);
    for (int i = 0; i < s->nears[part]; i++) {
        real both = parted_by_mending(s, &n[i]);
        if (both == 0) continue;
        s->push[n[i].push].before += both;
        s->push[n[i].push].apart[NORMAL] += both;
        n[i].room = -1;
    }
}
//<

//> push-pile-begin
// All that is done with a push once a substep is done at one sight of it: a
// thousand bodies have more pushes than the nearest memory holds.
int pile_begin(push_pile *s, int part, const particle *p, push_options options,
               real h)
{
    int overlaps = 0, nears = 0;
    push_near *near = nears_of(s, part);
    s->drift[s->bodies + part] = (push_drift){ .stirred = 0 };
    for (int i = part > 0 ? s->end[part - 1] : 0; i < s->end[part]; i++) {
        push *c = &s->push[s->order[i]];
        if (!is_near(c, p)) continue;
        limit_mending(c, options, h);
        overlaps |= c->before < -options.slop * c->thickness;
        for (int d = 0; d < DIRECTIONS; d++)
            c->from[d] = c->last[d] = c->pushed[d];
        push_near *n = &near[nears++];
        *n = (push_near){ drift_of(s, part, c->a.body),
            drift_of(s, part, c->b.count > 0 ? c->b.body : -1),
            s->order[i], 0, 0, -1, 0 };
        if (c->pushed[NORMAL] == 0 && c->apart[NORMAL] > 0)
            n->room = c->apart[NORMAL] / c->length;
        push_again(s, part, c, n, options);
    }
    s->nears[part] = nears;
    return overlaps;
}
//<

//> push-pile-pass
// Where do the last two passes lead, as seen from the two before them?
static inline real leading_on(const push *c)
{
    real sum = 0;
    for (int d = 0; d < DIRECTIONS; d++)
        sum += c->weight[d] * (c->pushed[d] - c->from[d])
                            * (c->pushed[d] - c->last[d]);
    return sum;
}

// Solves a contact of the pile.  Whoever finds its bodies where it left them,
// but for `enough`, has nothing to do; nor has one that is open, and stays it.
static inline real solve(push_pile *s, int part, push_near *n, real enough,
                         push_options options)
{
    push_drift *a = n->a, *b = n->b;
    real stirred = a->stirred + b->stirred;
    if (stirred - n->solved <= n->room) return 0;
    push *c = &s->push[n->push];
    real apart[DIRECTIONS], l[DIRECTIONS];
    n->solved = stirred;
    n->room = enough / c->length;
    if (c->pushed[NORMAL] == 0) {
        real gap = c->apart[NORMAL] + parted(c, NORMAL, a->pushed, b->pushed);
        if (gap > enough) n->room = gap / c->length;
        if (!(gap < 0)) return 0;
    }
    find_apart(c, a->pushed, b->pushed, apart);
    find_push(c, apart, c->before, options, l);
    push_by(c, l, a->pushed, b->pushed);
    n->solved += stir(s, part, c, n, l);
    n->leans = 1;
    n->leads_on = leading_on(c);
    return fabs(l[NORMAL]) * c->weight[NORMAL];
}

real pile_pass(push_pile *s, int part, int step, real enough,
               push_options options)
{
    push_near *near = nears_of(s, part);
    int nears = s->nears[part];
    real most = 0;
    for (int i = step > 0 ? 0 : nears - 1; i >= 0 && i < nears; i += step) {
        real change = solve(s, part, &near[i], enough, options);
        most = change > most ? change : most;
    }
    return most;
}
//<

//> push-pile-lean
real pile_leads_on(const push_pile *s, int part)
{
    const push_near *near = nears_of(s, part);
    real sum = 0;
    for (int i = 0; i < s->nears[part]; i++) sum += near[i].leads_on;
    return sum;
}

static void lean(push_pile *s, int part, push_near *n, real share,
                 push_options options)
{
    push *c = &s->push[n->push];
    push_drift *a = n->a, *b = n->b;
    real l[DIRECTIONS], apart[DIRECTIONS], size = 0;
    for (int i = 0; i < DIRECTIONS; i++) {
        l[i] = share * (c->pushed[i] - c->last[i]);
        c->last[i] = c->pushed[i];
        size += fabs(l[i]);
    }
    l[NORMAL] = real_max(l[NORMAL], -c->pushed[NORMAL]);
    n->leans = size > 0;
    n->leads_on = 0;
    if (n->leans) {
        if (options.book) {
            find_apart(c, a->pushed, b->pushed, apart);
            wear(c, apart, l);
        }
        push_by(c, l, a->pushed, b->pushed);
        stir(s, part, c, n, l);
    }
    for (int i = 0; i < DIRECTIONS; i++) {
        c->pushed[i] += l[i];
        c->from[i] = c->pushed[i];
    }
}

void pile_lean(push_pile *s, int part, real share, push_options options)
{
    push_near *near = nears_of(s, part);
    for (int i = 0; i < s->nears[part]; i++)
        if (near[i].leans) lean(s, part, &near[i], share, options);
}
//<

//> push-pile-apply
void drift_apply(const push_drift *d, const rigid4_ways *ways, particle *p)
{
    vec3 now[FOUR], both[FOUR];
    rigid4_move(ways, d->pushed, now);
    if (!d->is_mended) {
        for (int k = 0; k < FOUR; k++)
            p[k].position = vec3_add(p[k].position, now[k]);
        return;
    }
    rigid4_move(ways, d->mended, both);
    for (int k = 0; k < FOUR; k++) {
        p[k].position = vec3_add(p[k].position, vec3_add(now[k], both[k]));
        p[k].previous = vec3_add(p[k].previous, both[k]);
    }
}
//<
