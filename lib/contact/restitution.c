//> restitution
#include "restitution.h"

#include <assert.h>

// What all impacts of a substep have in common.
typedef struct {
    const solver_frame *f;
    real pull;                  // m/s^2, of gravity
    motion *velocity, *moved;
} impact_solver;

static bool strike(const impact_solver *s, const contact *c);

int restitution_solve(const contact *const *table, int n, const solver_frame *f,
                      motion *velocity, motion *moved)
{
    impact_solver s = { f, vec3_length(f->gravity), velocity, moved };
    int impacts = 0, before = -1;
    assert(f->restitution >= 0 && f->restitution <= 1);
    for (int round = 0; round < IMPACT_ROUNDS && before < impacts; round++) {
        before = impacts;
        for (int i = 0; i < n; i++)
            impacts += strike(&s, table[round % 2 ? n - 1 - i : i]);
    }
    return impacts;
}

real restitution_slowest(real radius, real gravity, real h)
{
    return real_max(sqrt(2 * gravity * radius) / 3, 2 * gravity * h);
}
//<

//> restitution-strike
// The two bodies of a contact, A and B; a plane is a body that does not move.
enum { A, B, BODIES };

typedef struct {
    const motion_basis *basis[BODIES];
    bool falls[BODIES];
} impact_pair;

// A row of the Jacobian: how a unit impulse along `along` turns A, and -B.
typedef struct {
    vec3 along;
    real turn[BODIES][TURNS];
} impact_row;

// What strikes: the points of a contact that touch in this substep.
typedef struct {
    const contact *c;
    impact_pair pair;
    contact_arms arm[CONTACT_POINTS];   // of all points of the contact
    motion u[BODIES];           // velocities at the time of the impact
    real time;                  // of the impact, as a share of the substep
    int  points, point[CONTACT_POINTS];
    impact_row row[CONTACT_POINTS];
    real impulse[CONTACT_POINTS];       // N s
} impact;

static bool meets_fast(const impact_solver *s, const contact *c);
static impact impact_of(const impact_solver *s, const contact *c);
static void push_apart(impact *x, real restitution);
static void rub(impact *x, real friction);
static real closing_speed(const impact *x);
static real slowest_of(const impact_solver *s, const contact *c);

// The velocity of a substep is that of a fall at the middle of it: at another
// time t (a share of the substep) gravity has added more.  What does not move
// does not fall.
static void fall(const impact_pair *p, vec3 gravity, real time,
                 motion u[BODIES])
{
    for (int side = A; side < BODIES; side++) {
        if (!p->falls[side]) continue;
        u[side].of[0] += time * gravity.x;
        u[side].of[1] += time * gravity.y;
        u[side].of[2] += time * gravity.z;
    }
}

// The body goes with its new velocity, but only for the rest of the substep.
static void settle(const impact_solver *s, int body, const motion *u, real time)
{
    motion *velocity = &s->velocity[body], *moved = &s->moved[body];
    for (int k = 0; k < MOTIONS; k++) {
        moved->of[k] += (velocity->of[k] - u->of[k]) * time * s->f->h;
        velocity->of[k] = u->of[k];
    }
}

static bool strike(const impact_solver *s, const contact *c)
{
    const solver_frame *f = s->f;
    material m = solver_material(f, c->a, c->b);
    if (f->material && !(m.restitution > 0)) return false;
    if (!meets_fast(s, c)) return false;
    impact x = impact_of(s, c);
    vec3 fallen = vec3_scale(f->h, f->gravity);
    fall(&x.pair, fallen, x.time - 0.5, x.u);
    if (!(closing_speed(&x) > slowest_of(s, c))) return false;
    push_apart(&x, m.restitution);
    rub(&x, m.friction);
    fall(&x.pair, fallen, 0.5 - x.time, x.u);
    if (x.pair.falls[A]) settle(s, c->a, &x.u[A], x.time);
    if (x.pair.falls[B]) settle(s, c->b, &x.u[B], x.time);
    return true;
}
//<

//> restitution-slowest
static real slowest_of(const impact_solver *s, const contact *c)
{
    real radius = s->f->body[c->a].radius;
    if (c->b >= 0) radius = real_min(s->f->body[c->b].radius, radius);
    return restitution_slowest(radius, s->pull, s->f->h);
}

// How fast a point of the body can go along n at most.
static real speed_along(const impact_solver *s, int body, vec3 n)
{
    const solver_body *b = &s->f->body[body];
    const motion *u = &s->velocity[body];
    vec3 turn = motion_rotation(&b->basis, u);
    return b->radius * vec3_length(turn)
         + u->of[0] * n.x + u->of[1] * n.y + u->of[2] * n.z;
}

// The bodies alone show of most contacts that they do not strike.
static bool meets_fast(const impact_solver *s, const contact *c)
{
    vec3 back = vec3_scale(-1, c->normal);
    real most = s->pull * s->f->h + speed_along(s, c->a, back);
    if (c->b >= 0) most += speed_along(s, c->b, c->normal);
    return most > slowest_of(s, c);
}
//<

//> restitution-row
static void set_turns(impact_row *r, const impact_pair *p, int side,
                      vec3 moment)
{
    for (int t = 0; t < TURNS; t++)
        r->turn[side][t] = vec3_dot(p->basis[side]->turn[t], moment);
}

static impact_row row_along(const impact_pair *p, vec3 along,
                            const vec3 arm[BODIES])
{
    impact_row r = { .along = along };
    for (int side = A; side < BODIES; side++)
        set_turns(&r, p, side, vec3_cross(arm[side], along));
    return r;
}

// How fast, or how far, A and B part along a row.
static real row_apart(const impact_row *r, const motion u[BODIES])
{
    const real *a = u[A].of, *b = u[B].of;
    real sum = r->along.x * (a[0] - b[0]) + r->along.y * (a[1] - b[1])
             + r->along.z * (a[2] - b[2]);
    for (int t = 0; t < TURNS; t++)
        sum += r->turn[A][t] * a[MOTION_TURN + t]
             - r->turn[B][t] * b[MOTION_TURN + t];
    return sum;
}

// How fast a unit impulse along one parts them along the other: an element of
// K = J M^-1 J^T.
static real row_product(const impact_pair *p, const impact_row *r,
                        const impact_row *s)
{
    real sum = (p->basis[A]->inverse_mass + p->basis[B]->inverse_mass)
             * vec3_dot(r->along, s->along);
    for (int t = 0; t < TURNS; t++)
        sum += r->turn[A][t] * s->turn[A][t] + r->turn[B][t] * s->turn[B][t];
    return sum;
}

static void row_push(const impact_pair *p, const impact_row *r, real impulse,
                     motion u[BODIES])
{
    for (int side = A; side < BODIES; side++) {
        real j = side == A ? impulse : -impulse;
        real straight = j * p->basis[side]->inverse_mass, *of = u[side].of;
        of[0] += straight * r->along.x;
        of[1] += straight * r->along.y;
        of[2] += straight * r->along.z;
        for (int t = 0; t < TURNS; t++)
            of[MOTION_TURN + t] += j * r->turn[side][t];
    }
}

// The fastest that any of the points closes, at the time of the impact.
static real closing_speed(const impact *x)
{
    real most = 0;
    for (int i = 0; i < x->points; i++)
        most = real_max(-row_apart(&x->row[i], x->u), most);
    return most;
}
//<

//> restitution-time
// When do two points touch whose gap g (m) closes by s (m) in a substep?  What
// falls on something immovable falls faster and faster: s is the speed in the
// middle of the substep, and with a, in m a substep squared,
//     g = t u + t^2 a/2,  u = s - a/2,
// of which t = 2 g / (u + root), root = sqrt(u^2 + 2 a g), is the time when
// they first close.  If u <= 0 they part at first, and fall back more slowly
// than anything strikes: then any time will do.
static real time_of_touch(real gap, real closing, real a)
{
    real u = closing - a / 2, high = real_max(gap, 0);
    real root = sqrt(real_max(u * u + 2 * a * high, 0));
    return u > 0 ? real_min(2 * high / (u + root), 1) : 1;
}

// What touches a thousandth of a substep too late takes part as well: rounding
// is not to decide which corners of a face do.  They strike together, when the
// first of them touches.
static void find_touching(impact *x, const impact_solver *s,
                          const real gap[CONTACT_POINTS],
                          const motion moved[BODIES])
{
    const contact *c = x->c;
    const impact_pair *p = &x->pair;
    real h = s->f->h;
    real a = (p->falls[B] - p->falls[A]) * vec3_dot(s->f->gravity, c->normal)
           * h * h;
    x->time = 1;
    for (int k = 0; k < c->count; k++) {
        const vec3 arm[BODIES] = { x->arm[k].a, x->arm[k].b };
        impact_row row = row_along(p, c->normal, arm);
        real now = gap[k] + row_apart(&row, moved);
        real closing = -h * row_apart(&row, x->u);
        if (!(closing > 0 && now < 1.001 * closing)) continue;
        x->point[x->points] = k;
        x->row[x->points++] = row;
        x->time = real_min(x->time, time_of_touch(now, closing, a));
    }
}

static const motion_basis IMMOVABLE = { .inverse_mass = 0 };

static impact impact_of(const impact_solver *s, const contact *c)
{
    const solver_frame *f = s->f;
    impact x = { .c = c };
    motion moved[BODIES] = { s->moved[c->a] };
    real gap[CONTACT_POINTS], height = 0;
    const rigid_frame *frame = NULL;
    x.pair.basis[A] = &f->body[c->a].basis;
    x.pair.basis[B] = &IMMOVABLE;
    x.u[A] = s->velocity[c->a];
    if (c->b < 0) {
        height = f->plane[-1 - c->b].offset;
    } else {
        frame = &f->body[c->b].frame;
        x.pair.basis[B] = &f->body[c->b].basis;
        x.u[B] = s->velocity[c->b];
        moved[B] = s->moved[c->b];
    }
    for (int side = A; side < BODIES; side++)
        x.pair.falls[side] = x.pair.basis[side]->inverse_mass > 0;
    if (f->body[c->a].is_driven) x.pair.falls[A] = false;
    if (c->b >= 0 && f->body[c->b].is_driven) x.pair.falls[B] = false;
    contact_gaps(c, &f->body[c->a].frame, frame, height, gap);
    for (int k = 0; k < c->count; k++)
        x.arm[k] = contact_arms_of(c, k, solver_placed(f, c->a),
                                   solver_placed(f, c->b));
    find_touching(&x, s, gap, moved);
    return x;
}
//<

//> restitution-normal
// The impulses that stop the points: projected Gauss-Seidel for the least
// lambda >= 0 that leaves no point closing.  `part` is how fast they part.
static void stop_points(impact *x, const real part[CONTACT_POINTS],
                        real k[CONTACT_POINTS][CONTACT_POINTS])
{
    enum { PASSES = 200 };
    real fastest = 0, worst = HUGE_VAL;
    for (int i = 0; i < x->points; i++) fastest = real_max(-part[i], fastest);
    for (int pass = 0; pass < PASSES && worst > 1e-14 * fastest; pass++) {
        worst = 0;
        for (int i = 0; i < x->points; i++) {
            real now = part[i], was = x->impulse[i];
            for (int j = 0; j < x->points; j++) now += k[i][j] * x->impulse[j];
            x->impulse[i] = real_max(was - now / k[i][i], 0);
            worst = real_max(fabs(x->impulse[i] - was) * k[i][i], worst);
        }
    }
}

// Impulses s lambda change the kinetic energy by
//     s (lambda . v) + s^2/2 (lambda . K lambda),
// where v is how the points part.  That is a parabola in s, deepest at
// sigma = -(lambda . v) / (lambda . K lambda), where the impact is inelastic,
// and as high as before at 2 sigma.  At (1 + e) sigma the energy that is lost
// is 1 - e^2 of the most that these impulses can take: never less than nothing,
// whatever lambda is.  And if lambda stops the points (sigma = 1), 1 + e times
// lambda parts them at e times the speed at which they met, or faster.
static void push_apart(impact *x, real restitution)
{
    real k[CONTACT_POINTS][CONTACT_POINTS], part[CONTACT_POINTS];
    real down = 0, bend = 0;
    for (int i = 0; i < x->points; i++) {
        part[i] = row_apart(&x->row[i], x->u);
        for (int j = 0; j <= i; j++)
            k[i][j] = k[j][i] = row_product(&x->pair, &x->row[i], &x->row[j]);
    }
    stop_points(x, part, k);
    for (int i = 0; i < x->points; i++) {
        down -= x->impulse[i] * part[i];
        for (int j = 0; j < x->points; j++)
            bend += x->impulse[i] * k[i][j] * x->impulse[j];
    }
    real scale = bend > 0 ? (1 + restitution) * real_max(down / bend, 0) : 0;
    for (int i = 0; i < x->points; i++) {
        x->impulse[i] *= scale;
        row_push(&x->pair, &x->row[i], x->impulse[i], x->u);
    }
}
//<

//> restitution-friction
// Where friction acts: at the mean of the points, weighted by their impulses.
// Returns the sum of these.
static real center_of(const impact *x, vec3 arm[BODIES])
{
    real sum = 0;
    arm[A] = arm[B] = vec3_make(0, 0, 0);
    for (int i = 0; i < x->points; i++) {
        const contact_arms *q = &x->arm[x->point[i]];
        sum += x->impulse[i];
        arm[A] = vec3_add_scaled(arm[A], x->impulse[i], q->a);
        arm[B] = vec3_add_scaled(arm[B], x->impulse[i], q->b);
    }
    for (int side = A; side < BODIES && sum > 0; side++)
        arm[side] = vec3_scale(1 / sum, arm[side]);
    return sum;
}

// The impulse f that stops sliding is where the energy is least; one shorter
// than that takes energy as well.  Slower than 1e-12 of how the points part is
// what rounding leaves, in any direction.
static void stop_sliding(impact *x, const vec3 arm[BODIES], real most)
{
    const impact_pair *p = &x->pair;
    vec3 n = x->c->normal;
    vec3 v = vec3_sub(motion_at(p->basis[A], &x->u[A], arm[A]),
                      motion_at(p->basis[B], &x->u[B], arm[B]));
    real whole = vec3_length(v);
    v = vec3_add_scaled(v, -vec3_dot(v, n), n);
    real speed = vec3_length(v);
    if (!(speed > 1e-12 * whole)) return;
    vec3 along = vec3_scale(1 / speed, v);
    impact_row r = row_along(p, along, arm);
    impact_row s = row_along(p, vec3_cross(n, along), arm);
    real rr = row_product(p, &r, &r), rs = row_product(p, &r, &s);
    real ss = row_product(p, &s, &s), volume = rr * ss - rs * rs;
    real f = -ss * speed / volume, g = rs * speed / volume;
    real size = sqrt(f * f + g * g), share = size > most ? most / size : 1;
    row_push(p, &r, share * f, x->u);
    row_push(p, &s, share * g, x->u);
}

// The same about the normal.
static void stop_twisting(impact *x, const vec3 arm[BODIES], real friction)
{
    const impact_pair *p = &x->pair;
    impact_row r = { .along = { 0, 0, 0 } };
    real most = 0;
    for (int side = A; side < BODIES; side++)
        set_turns(&r, p, side, x->c->normal);
    for (int i = 0; i < x->points; i++)
        most += friction * x->impulse[i]
              * vec3_distance(x->arm[x->point[i]].a, arm[A]);
    real twist = -row_apart(&r, x->u), mass = row_product(p, &r, &r);
    if (!(mass > 0)) return;
    row_push(p, &r, real_max(-most, real_min(twist / mass, most)), x->u);
}

static void rub(impact *x, real friction)
{
    vec3 arm[BODIES];
    real most = friction * center_of(x, arm);
    if (!(most > 0)) return;
    stop_sliding(x, arm, most);
    stop_twisting(x, arm, friction);
}
//<
