//> push-points
#include "push.h"

// How the points stand to each other now, and when the substep began.
typedef struct {
    vec3 now, before;       // m, pA - pB
} apart;

static inline void add_side(const push_side *s, const particle *p, real sign,
                            apart *d)
{
    p += s->first;
    for (int k = 0; k < s->count; k++) {
        real a = sign * s->share[k];
        d->now = vec3_add_scaled(d->now, a, p[k].position);
        d->before = vec3_add_scaled(d->before, a, p[k].previous);
    }
}

static inline apart points_apart(const push *c, const particle *p)
{
    apart d = { { 0, 0, 0 }, { 0, 0, 0 } };
    add_side(&c->a, p, 1, &d);
    if (c->b.count > 0) {
        add_side(&c->b, p, -1, &d);
    } else {
        d.now = vec3_sub(d.now, c->fixed);
        d.before = vec3_sub(d.before, c->fixed);
    }
    return d;
}
//<

//> push-move
static inline vec3 answer_to(const push_side *s, int k,
                             const real l[DIRECTIONS])
{
    vec3 x = vec3_scale(l[NORMAL], s->answer[NORMAL][k]);
    x = vec3_add_scaled(x, l[ACROSS], s->answer[ACROSS][k]);
    return vec3_add_scaled(x, l[ASIDE], s->answer[ASIDE][k]);
}

// Pushes A by l, B by -l.  Moves where the particles are; with both, where they
// were as well.
static inline void push_side_by(const push_side *s, particle *p, real sign,
                                const real l[DIRECTIONS], int both)
{
    p += s->first;
    for (int k = 0; k < s->count; k++) {
        vec3 x = answer_to(s, k, l);
        p[k].position = vec3_add_scaled(p[k].position, sign, x);
        if (both) p[k].previous = vec3_add_scaled(p[k].previous, sign, x);
    }
}

static inline void push_by(const push *c, particle *p,
                           const real l[DIRECTIONS], int both)
{
    push_side_by(&c->a, p, 1, l, both);
    push_side_by(&c->b, p, -1, l, both);
}
//<

//> push-answers
void push_directions(push *c, vec3 n)
{
    real x = fabs(n.x), y = fabs(n.y), z = fabs(n.z);
    vec3 least = { x <= y && x <= z, y < x && y <= z, z < x && z < y };
    c->along[NORMAL] = n;
    c->along[ACROSS] = vec3_unit(vec3_cross(n, least));
    c->along[ASIDE] = vec3_cross(n, c->along[ACROSS]);
}

// How one side answers pushes along the three directions: adds how far its
// point goes to the contact's weights.
static void answer_side(push *c, push_side *s, const particle *p)
{
    if (s->count == 0) return;
    p += s->first;
    for (int d = 0; d < DIRECTIONS; d++) {
        if (s->plan) {
            c->weight[d] += four_answer(s->plan, s->at, p->inverse_mass,
                                        s->share, c->along[d],
                                        s->answer[d]);
        } else {
            s->answer[d][0] = vec3_scale(p->inverse_mass, c->along[d]);
            c->weight[d] += p->inverse_mass;
        }
    }
    for (int k = 0; k < s->count; k++) {
        for (int d = ACROSS; d < DIRECTIONS; d++)
            c->skew[d] += s->share[k] * vec3_dot(s->answer[NORMAL][k],
                                                 c->along[d]);
        c->skew[NORMAL] += s->share[k] * vec3_dot(s->answer[ACROSS][k],
                                                  c->along[ASIDE]);
    }
}

// Made when the contact is first needed: most never are.
static int make_ready(push *c, const particle *p)
{
    if (!c->ready) {
        for (int d = 0; d < DIRECTIONS; d++) c->weight[d] = c->skew[d] = 0;
        answer_side(c, &c->a, p);
        answer_side(c, &c->b, p);
        c->ready = 1;
    }
    return c->weight[NORMAL] > 0;
}
//<

//> push-remember-code
// A force F moves what it pushes by F h^2 / m in a substep.
push_memory push_remember(const push *c, int a, int b, real h)
{
    push_memory m = { .a = a, .b = b };
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
    c->pushed[NORMAL] += fmax(l[NORMAL], 0);
    c->pushed[ACROSS] += l[ACROSS];
    c->pushed[ASIDE] += l[ASIDE];
}
//<

//> push-again
void push_again(push *c, particle *p)
{
    if (c->pushed[NORMAL] > 0 && make_ready(c, p)) push_by(c, p, c->pushed, 0);
}
//<

//> push-wear
// The work of a push is the push times the mean of the slides before and after
// it: friction's share of what l will do.
static void wear(push *c, const apart *d, const real l[DIRECTIONS])
{
    vec3 slid = vec3_sub(d->now, d->before);
    for (int i = ACROSS; i < DIRECTIONS; i++) {
        real other = l[ACROSS + ASIDE - i];
        real slide = vec3_dot(slid, c->along[i]) + c->skew[i] * l[NORMAL];
        real half = (c->weight[i] * l[i] + c->skew[NORMAL] * other) / 2;
        c->worn += l[i] * (slide + half);
    }
}

void push_book_again(push *c, const particle *p)
{
    if (!(c->pushed[NORMAL] > 0) || !make_ready(c, p)) return;
    apart d = points_apart(c, p);
    wear(c, &d, c->pushed);
}
//<

//> push-mend
void push_limit(push *c, const particle *p, push_options options, real h)
{
    real gap = vec3_dot(points_apart(c, p).before, c->along[NORMAL])
             - c->thickness;
    c->most = gap + options.mend_speed * h;
}

// What is mended of an overlap.  One that goes by itself, for the points part,
// is left to go; and the slop is left to stay: were the overlap mended to
// nothing, the next contact's mending would leave a gap, into which the body
// falls within one substep.  Mending would make speed after all, and a pile
// never come to rest.
static real mended(const push *c, const apart *d, push_options options)
{
    real before = vec3_dot(d->before, c->along[NORMAL]) - c->thickness;
    real now = vec3_dot(d->now, c->along[NORMAL]) - c->thickness;
    real depth = -fmax(before, now) - options.slop * c->thickness;
    return fmax(fmin(options.mend * depth, c->most - before), 0);
}

// A push l moves the points by weight * l.
void push_mend(push *c, particle *p, push_options options)
{
    real l[DIRECTIONS] = { 0 };
    apart d = points_apart(c, p);
    real up = mended(c, &d, options);
    if (!(up > 0) || !make_ready(c, p)) return;
    l[NORMAL] = up / c->weight[NORMAL];
    push_by(c, p, l, 1);
}
//<

//> push-brake
// Coulomb: the push across is at most friction times the push along the normal.
// Each direction is asked to undo what the points have slid in this substep,
// and will by the push l[NORMAL]; then both are shortened alike until they lie
// within the cone.
static void brake(push *c, const apart *d, push_options options,
                  real l[DIRECTIONS])
{
    real across[DIRECTIONS] = { 0 }, size2 = 0;
    real limit = options.friction * c->pushed[NORMAL];
    vec3 slid = vec3_sub(d->now, d->before);
    for (int i = ACROSS; i < DIRECTIONS; i++) {
        real slide = vec3_dot(slid, c->along[i]) + c->skew[i] * l[NORMAL];
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
// The push that undoes all three at once, gap and slides b:
//     | w0 s1 s2 |
//     | s1 w1 s0 | l = -b,   by Cramer's rule.
//     | s2 s0 w2 |
// 0 if it would pull, or leaves Coulomb's cone.  (One direction after the other
// would do in the end, but in another order backward than forward: what passes
// gain they lose again.)
static int hold(push *c, const real b[DIRECTIONS], real friction,
                real l[DIRECTIONS])
{
    const real *w = c->weight, *s = c->skew;
    vec3 p = { w[0], s[1], s[2] }, q = { s[1], w[1], s[0] };
    vec3 r = { s[2], s[0], w[2] }, x = { -b[0], -b[1], -b[2] };
    vec3 qr = vec3_cross(q, r), rp = vec3_cross(r, p), pq = vec3_cross(p, q);
    real volume = vec3_dot(p, qr), in[DIRECTIONS];
    if (!(volume > 1e-9 * w[0] * w[1] * w[2])) return 0;
    l[0] = vec3_dot(x, qr) / volume;
    l[1] = vec3_dot(x, rp) / volume;
    l[2] = vec3_dot(x, pq) / volume;
    for (int i = 0; i < DIRECTIONS; i++) in[i] = c->pushed[i] + l[i];
    real most = friction * in[NORMAL];
    if (!(in[NORMAL] > 0 && in[ACROSS] * in[ACROSS] + in[ASIDE] * in[ASIDE]
                            <= most * most)) return 0;
    for (int i = 0; i < DIRECTIONS; i++) c->pushed[i] = in[i];
    return 1;
}
//<

//> push-solve
real push_solve(push *c, particle *p, push_options options)
{
    apart d = points_apart(c, p);
    real gap = vec3_dot(d.now, c->along[NORMAL]) - c->thickness;
    if (c->pushed[NORMAL] == 0 && !(gap < 0)) return 0;
    if (!make_ready(c, p)) return 0;

    real before = vec3_dot(d.before, c->along[NORMAL]) - c->thickness;
    vec3 slid = vec3_sub(d.now, d.before);
    real l[DIRECTIONS], b[DIRECTIONS] = { gap - fmin(before, 0),
        vec3_dot(slid, c->along[ACROSS]), vec3_dot(slid, c->along[ASIDE]) };
    if (!hold(c, b, options.friction, l)) {
        real was = c->pushed[NORMAL];
        c->pushed[NORMAL] = fmax(was - b[NORMAL] / c->weight[NORMAL], 0);
        l[NORMAL] = c->pushed[NORMAL] - was;
        brake(c, &d, options, l);
    }
    wear(c, &d, l);
    push_by(c, p, l, 0);
    return fabs(l[NORMAL]) * c->weight[NORMAL];
}
//<

//> push-lean
void push_mark(push *c)
{
    for (int i = 0; i < DIRECTIONS; i++) c->from[i] = c->last[i] = c->pushed[i];
}

real push_leads_on(const push *c)
{
    real sum = 0;
    for (int i = 0; i < DIRECTIONS; i++)
        sum += c->weight[i] * (c->pushed[i] - c->from[i])
                            * (c->pushed[i] - c->last[i]);
    return sum;
}

void push_lean(push *c, particle *p, real share)
{
    real l[DIRECTIONS], size = 0;
    for (int i = 0; i < DIRECTIONS; i++) {
        l[i] = share * (c->pushed[i] - c->last[i]);
        c->last[i] = c->pushed[i];
        size += fabs(l[i]);
    }
    l[NORMAL] = fmax(l[NORMAL], -c->pushed[NORMAL]);
    if (size > 0) {
        apart d = points_apart(c, p);
        wear(c, &d, l);
        push_by(c, p, l, 0);
    }
    for (int i = 0; i < DIRECTIONS; i++) {
        c->pushed[i] += l[i];
        c->from[i] = c->pushed[i];
    }
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
    apart d = points_apart(c, p);
    real gap = vec3_dot(d.before, c->along[NORMAL]) - c->thickness;
    real s = vec3_dot(vec3_sub(d.before, d.now), c->along[NORMAL]);
    real a = (falls(&c->b, p) - falls(&c->a, p))
           * vec3_dot(options.fall, c->along[NORMAL]);
    c->closing = c->share = 0;
    if (!(s > 0 && gap < 1.001 * s) || !make_ready(c, p)) return;
    real u = s - a / 2, high = fmax(gap, 0);
    real root = sqrt(fmax(u * u + 2 * a * high, 0));
    c->share = fmin(u > 0 ? 2 * high / (u + root) : (root - u) / a, 1);
    real more = (c->share - 0.5) * a;
    c->closing = fmax(s + more, 0);
    c->parting = options.restitution * c->closing + more;
}

// Gives one contact the parting that it is due: restitution times closing when
// they touch, which is so much in the middle of the substep.
static void strike(push *c, particle *p, push_options options)
{
    apart d = points_apart(c, p);
    real closing = vec3_dot(vec3_sub(d.before, d.now), c->along[NORMAL]);
    real l[DIRECTIONS] = { 0 }, was = c->pushed[NORMAL];
    real want = closing + c->parting;
    c->pushed[NORMAL] = fmax(0, was + want / c->weight[NORMAL]);
    l[NORMAL] = c->pushed[NORMAL] - was;
    brake(c, &d, options, l);
    wear(c, &d, l);
    push_by(c, p, l, 0);
}

// What the blow moves, it moves for the rest of the substep only: the share
// before it is taken back, of both places, now and before.
static void settle_blow(push *c, particle *p)
{
    real l[DIRECTIONS];
    for (int d = 0; d < DIRECTIONS; d++) l[d] = -c->share * c->pushed[d];
    push_by(c, p, l, 1);
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
