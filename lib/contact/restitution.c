//> restitution
//>   An impact that is passed on is one more impact. In Newton's cradle the
//>   first round goes through the whole row.
#include "restitution.h"
#include "manifold.h"

#include <assert.h>

// What all impacts of a substep have in common.
typedef struct {
    const solver_frame *f;
    real pull;                  // m/s^2, of gravity
    real least;                 // m/s: what is passed on more slowly is left
    solver_body *body;
    motion *velocity, *moved;
} impact_solver;

static real strike(const impact_solver *s, const contact *c);

// Of the fastest blow of a substep: bodies that are wedged pass on ever less of
// it, in rounds without end.
static const real PASSED_ON = 0.1;          // tuned, 1

int restitution_solve(const contact *const *table, int n, const solver_frame *f,
                      solver_body *body, motion *velocity, motion *moved)
{
    impact_solver s = { f, vec3_length(f->gravity), 0, body, velocity, moved };
    int impacts = 0, before = -1;
    real fastest = 0;
    assert(f->restitution >= 0 && f->restitution <= 1);
    for (int round = 0; round < CONTACT_ROUNDS && before < impacts; round++) {
        before = impacts;
        for (int i = 0; i < n; i++) {
            real speed = strike(&s, table[round % 2 ? n - 1 - i : i]);
            impacts += speed > 0;
            fastest = real_max(speed, fastest);
        }
        s.least = PASSED_ON * fastest;
    }
    return impacts;
}
//<

//> restitution-strike
// As a share of a substep the time of an impact is known to this, and what touches
// as much too late takes part as well: rounding is not to decide which corners of a
// face do.
static const real SAME_TIME = 1e-9;

typedef struct {
    const motion_basis *basis[BODIES];
    bool falls[BODIES];
} impact_pair;

// What strikes: the points of a contact that touch in this substep.
typedef struct {
    const contact *found;
    contact c;                  // the same, as it is at the time of the impact
    impact_pair pair;
    contact_arms arm[CONTACT_POINTS];   // of all points of the contact
    rigid_frame at[BODIES];     // at the time of the impact they stand here,
    motion_basis basis[BODIES];
    motion u[BODIES];           // with these velocities
    real time;                  // of the impact, as a share of the substep
    impact_set set;
    int  point[CONTACT_POINTS];         // that each row is of
} impact;

static void begin_impact(impact *x, const impact_solver *s, const contact *c);
static bool meets_fast(const impact_solver *s, impact *x, real slowest);
typedef contact_arms arms_of(const contact *c, int k, const rigid_frame *a,
                             const rigid_frame *b);
static void stand_at(impact *x, const impact_solver *s, real t, arms_of *of);
static bool goes_freely(const impact_solver *s, int body);
static void find_touching(impact *x, const impact_solver *s);
static void push_impact(impact *x, real restitution);
static void rub(impact *x, real friction);
static real closing_speed(const impact *x);

// The velocity of a substep is that of a fall at the middle of it: at another
// time t (a share of the substep) gravity has added more.  What does not move
// does not fall.
static void fall_in_impact(const impact_pair *p, vec3 gravity, real time,
                           motion u[BODIES])
{
    for (int side = A; side < BODIES; side++)
        if (p->falls[side]) motion_add_straight(&u[side], time, gravity);
}

// The body goes with its new velocity, but only for the rest of the substep: what
// flies freely flies back with it from where it struck, so that it keeps its energy
// and its angular momentum, whatever its moments of inertia.
static void settle_body(const impact_solver *s, int body, impact *x, int side)
{
    motion *velocity = &s->velocity[body], *moved = &s->moved[body];
    real time = x->time * s->f->h;
    if (goes_freely(s, body)) {
        solver_body *now = &s->body[body];
        motion_advance(&x->at[side], &x->basis[side], &x->u[side], -time);
        now->frame = x->at[side];
        now->basis = x->basis[side];
        now->is_struck = true;
        *velocity = x->u[side];
        *moved = (motion){ { 0 } };
        return;
    }
    for (int k = 0; k < MOTIONS; k++) {
        moved->of[k] += (velocity->of[k] - x->u[side].of[k]) * time;
        velocity->of[k] = x->u[side].of[k];
    }
}

static real impact_sum(const impact *x)
{
    real sum = 0;
    for (int i = 0; i < x->set.rows; i++) sum += x->set.impulse[i];
    return sum;
}

// How fast they met (m/s); 0: they did not.
static real strike(const impact_solver *s, const contact *c)
{
    const solver_frame *f = s->f;
    material m = solver_material(f, c->a, c->b);
    real slowest = real_max(material_slowest(s->pull, f->h), s->least);
    impact x;
    if (!solver_strikes(f, c)) return 0;
    begin_impact(&x, s, c);
    if (!meets_fast(s, &x, slowest)) return 0;
    find_touching(&x, s);
    real speed = closing_speed(&x);
    if (!(speed > slowest)) return 0;
    push_impact(&x, m.restitution);
    if (f->hear) f->hear(f->listener, c, impact_sum(&x));
    rub(&x, m.friction);
    fall_in_impact(&x.pair, vec3_scale(f->h, f->gravity), 0.5 - x.time, x.u);
    if (x.pair.falls[A]) settle_body(s, c->a, &x, A);
    if (x.pair.falls[B]) settle_body(s, c->b, &x, B);
    return speed;
}
//<

//> restitution-meets
// How fast A and B close at their points, at most: of most contacts the bodies
// alone show that they do not strike, of most others the points.
static bool meets_fast(const impact_solver *s, impact *x, real slowest)
{
    const contact *c = x->found;
    real fallen = s->pull * s->f->h, most = -HUGE_VAL, spin = 0;
    vec3 delta[BODIES], turn[BODIES];
    for (int side = A; side < BODIES; side++) {
        int b = side == A ? c->a : c->b;
        delta[side] = motion_straight(&x->u[side]);
        turn[side] = motion_rotation(x->pair.basis[side], &x->u[side]);
        if (b >= 0) spin += s->f->body[b].radius * vec3_length(turn[side]);
    }
    vec3 closing = vec3_sub(delta[B], delta[A]);
    real straight = fallen + vec3_dot(c->normal, closing);
    if (!(straight + spin > slowest)) return false;
    const rigid_frame *a = &s->f->body[c->a].frame;
    const rigid_frame *b = c->b < 0 ? NULL : &s->f->body[c->b].frame;
    for (int k = 0; k < c->count; k++) {
        contact_arms arm = contact_sides_of(c, k, a, b);
        vec3 more = vec3_sub(vec3_cross(turn[B], arm.b),
                             vec3_cross(turn[A], arm.a));
        most = real_max(vec3_dot(c->normal, more), most);
    }
    return straight + most > slowest;
}
//<

//> restitution-row
//>   The two bodies have the numbers A and B in the rows of an impact.
static impact_row row_about(const impact_pair *p, vec3 along,
                            const vec3 moment[BODIES])
{
    impact_row r = { .along = along, .body = { A, B } };
    for (int side = A; side < BODIES; side++) {
        r.inverse[side] = p->falls[side] ? p->basis[side]->inverse_mass : 0;
        for (int t = 0; t < TURNS; t++)
            r.turn[side][t] = vec3_dot(p->basis[side]->turn[t], moment[side]);
    }
    return r;
}

static impact_row row_along(const impact_pair *p, vec3 along,
                            const vec3 arm[BODIES])
{
    const vec3 moment[BODIES] = { vec3_cross(arm[A], along),
                                  vec3_cross(arm[B], along) };
    return row_about(p, along, moment);
}

// The fastest that any of the points closes, at the time of the impact.
static real closing_speed(const impact *x)
{
    real most = 0;
    for (int i = 0; i < x->set.rows; i++)
        most = real_max(-impact_parting(&x->set.row[i], x->u), most);
    return most;
}
//<

//> restitution-pair
//>   The two bodies as they stand and go at any time within the substep, and the
//>   time at which they first touch.
// All but the arms, and what touches.
static void begin_impact(impact *x, const impact_solver *s, const contact *c)
{
    const solver_frame *f = s->f;
    x->found = c;
    x->pair.basis[A] = &f->body[c->a].basis;
    x->pair.basis[B] = c->b < 0 ? &MOTION_IMMOVABLE : &f->body[c->b].basis;
    x->u[A] = s->velocity[c->a];
    if (c->b < 0) x->u[B] = (motion){ { 0 } };
    else          x->u[B] = s->velocity[c->b];
    for (int side = A; side < BODIES; side++)
        x->pair.falls[side] = x->pair.basis[side]->inverse_mass > 0;
    if (f->body[c->a].is_driven) x->pair.falls[A] = false;
    if (c->b >= 0 && f->body[c->b].is_driven) x->pair.falls[B] = false;
}

// Not what is displaced while its rows stay: what is joined, and what turns beside
// a driven body.
static bool goes_freely(const impact_solver *s, int body)
{
    const char *kind = s->f->is_elsewhere;
    const solver_body *now = &s->body[body];
    return now->basis.inverse_mass > 0 && !now->is_driven && !now->is_joined
        && !(kind && kind[body] == GOES_BY_HALVES);
}

// Where a body is at a time t (s), and how it goes there.
static void predict_at(impact *x, const impact_solver *s, int side, int b, real t)
{
    motion d = s->moved[b], *u = &x->u[side];
    const solver_body *now = &s->body[b];
    x->basis[side] = now->basis;
    x->at[side] = now->frame;
    *u = s->velocity[b];
    x->pair.basis[side] = &x->basis[side];
    if (goes_freely(s, b)) {
        if (motion_is_some(&d))
            motion_displace(&x->at[side], &x->basis[side], u, &d);
        motion_advance(&x->at[side], &x->basis[side], u, t);
        return;
    }
    for (int i = 0; i < MOTIONS; i++) d.of[i] += t * u->of[i];
    x->at[side] = motion_frame(&now->frame, &now->basis, &d);
}

static bool are_balls(const contact *c)
{
    const contact_point *p = &c->point[0];
    vec3 origin = { 0, 0, 0 };
    return c->b >= 0 && c->count == 1 && c->round_a > 0 && c->round_b > 0
        && !(vec3_distance(p->local_a, origin) > 0)
        && !(vec3_distance(p->local_b, origin) > 0);
}

static vec3 predicted_center(const solver_frame *f, int b, const motion *u,
                   const motion *moved)
{
    vec3 delta = vec3_add_scaled(motion_straight(moved), f->h, motion_straight(u));
    return vec3_add(f->body[b].frame.center, delta);
}

bool restitution_face(contact *c, const solver_frame *f,
                      const motion *velocity, const motion *moved)
{
    if (!are_balls(c)) return false;
    vec3 a = predicted_center(f, c->a, &velocity[c->a], &moved[c->a]);
    vec3 b = predicted_center(f, c->b, &velocity[c->b], &moved[c->b]);
    vec3 normal = vec3_unit(vec3_sub(a, b));
    if (!solver_strikes(f, c)
        && vec3_distance(normal, c->normal) <= MANIFOLD_TURN) return false;
    c->normal = normal;
    return true;
}

// The bodies stand as they do at a time t (a share of the substep).  A gap closes as
// each side goes; both are struck at one place.  Two balls meet along the line of
// their centres.
static void stand_at(impact *x, const impact_solver *s, real t, arms_of *of)
{
    const contact *c = x->found;
    predict_at(x, s, A, c->a, t * s->f->h);
    if (c->b >= 0) predict_at(x, s, B, c->b, t * s->f->h);
    if (are_balls(c))
        x->c.normal = vec3_unit(vec3_sub(x->at[A].center, x->at[B].center));
    for (int k = 0; k < c->count; k++)
        x->arm[k] = of(&x->c, k, &x->at[A], c->b < 0 ? NULL : &x->at[B]);
}

static void find_impact_gaps(const impact *x, const impact_solver *s,
                             real gap[CONTACT_POINTS])
{
    const contact *c = &x->c;
    real height = c->b < 0 ? s->f->plane[-1 - c->b].offset : 0;
    contact_gaps(c, &x->at[A], c->b < 0 ? NULL : &x->at[B], height, gap);
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

// When do they first strike, as they stand and go at the time x->time?  A share
// of the substep.  A corner that lies there already does not: gravity closes it at
// half of material_slowest, and halfway between the two no rounding decides.
static real first_touch(impact *x, const impact_solver *s, real acceleration)
{
    const impact_pair *p = &x->pair;
    real gap[CONTACT_POINTS], least = HUGE_VAL, h = s->f->h;
    real slow = 0.75 * h * material_slowest(s->pull, h);
    find_impact_gaps(x, s, gap);
    for (int k = 0; k < x->c.count; k++) {
        const vec3 arm[BODIES] = { x->arm[k].a, x->arm[k].b };
        impact_row row = row_along(p, x->c.normal, arm);
        real closing = -h * impact_parting(&row, x->u);
        real began = gap[k] + x->time * closing;
        if (!(closing > slow && began < (1 + SAME_TIME) * closing)) continue;
        least = real_min(least, time_of_touch(began, closing, acceleration));
    }
    return least;
}

// What touches together strikes together, when the first of it touches.
static void take_touching(impact *x, const impact_solver *s)
{
    real gap[CONTACT_POINTS], h = s->f->h;
    find_impact_gaps(x, s, gap);
    for (int k = 0; k < x->c.count; k++) {
        const vec3 arm[BODIES] = { x->arm[k].a, x->arm[k].b };
        impact_row row = row_along(&x->pair, x->c.normal, arm);
        real closing = -h * impact_parting(&row, x->u);
        if (!(closing > 0 && gap[k] < SAME_TIME * closing)) continue;
        x->point[x->set.rows] = k;
        impact_add(&x->set, &row, impact_parting(&row, x->u));
    }
}

// The time of the impact: Newton's steps to where the first gap is closed, each
// with the bodies as they stand at the time that was found last.
static void find_touching(impact *x, const impact_solver *s)
{
    const impact_pair *p = &x->pair;
    real h = s->f->h;
    real a = (p->falls[B] - p->falls[A])
           * vec3_dot(s->f->gravity, x->found->normal) * h * h;
    x->time = 0;
    x->c = *x->found;
    impact_begin(&x->set);
    for (int n = 0; n < CONTACT_ROUNDS; n++) {
        stand_at(x, s, x->time, contact_sides_of);
        real time = first_touch(x, s, a);
        if (!(time < HUGE_VAL)) return;
        bool is_there = fabs(time - x->time) < SAME_TIME;
        x->time = time;
        if (is_there) break;
    }
    stand_at(x, s, x->time, contact_arms_of);
    fall_in_impact(p, vec3_scale(h, s->f->gravity), x->time - 0.5, x->u);
    take_touching(x, s);
}
//<

//> restitution-normal
// Impulses s lambda change the kinetic energy by
//     s (lambda . v) + s^2/2 (lambda . K lambda),
// where v is how the points part.  That is a parabola in s, deepest at
// sigma = -(lambda . v) / (lambda . K lambda), where the impact is inelastic,
// and as high as before at 2 sigma.  At (1 + e) sigma the energy that is lost
// is 1 - e^2 of the most that these impulses can take: never less than nothing,
// whatever lambda is.  And if lambda stops the points (sigma = 1), 1 + e times
// lambda parts them at e times the speed at which they met, or faster.
static void push_impact(impact *x, real restitution)
{
    impact_set *w = &x->set;
    real down = 0, bend = 0;
    impact_stop(w);
    for (int i = 0; i < w->rows; i++) {
        down -= w->impulse[i] * w->part[i];
        for (int j = 0; j < w->rows; j++)
            bend += w->impulse[i] * w->k[i][j] * w->impulse[j];
    }
    real scale = bend > 0 ? (1 + restitution) * real_max(down / bend, 0) : 0;
    for (int i = 0; i < w->rows; i++) w->impulse[i] *= scale;
    impact_apply(w, x->u);
}
//<

//> restitution-friction
//>   Friction comes last: whatever it takes, it takes from the energy.
// Where friction acts: at the mean of the points, weighted by their impulses.
// Returns the sum of these.
static real center_of(const impact *x, vec3 arm[BODIES])
{
    real sum = 0;
    arm[A] = arm[B] = vec3_make(0, 0, 0);
    for (int i = 0; i < x->set.rows; i++) {
        const contact_arms *q = &x->arm[x->point[i]];
        sum += x->set.impulse[i];
        arm[A] = vec3_add_scaled(arm[A], x->set.impulse[i], q->a);
        arm[B] = vec3_add_scaled(arm[B], x->set.impulse[i], q->b);
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
    vec3 n = x->c.normal;
    vec3 v = vec3_sub(motion_at(p->basis[A], &x->u[A], arm[A]),
                      motion_at(p->basis[B], &x->u[B], arm[B]));
    real whole = vec3_length(v);
    v = vec3_add_scaled(v, -vec3_dot(v, n), n);
    real speed = vec3_length(v);
    if (!(speed > 1e-12 * whole)) return;
    vec3 along = vec3_scale(1 / speed, v);
    impact_row r = row_along(p, along, arm);
    impact_row s = row_along(p, vec3_cross(n, along), arm);
    real rr = impact_product(&r, &r), rs = impact_product(&r, &s);
    real ss = impact_product(&s, &s), volume = rr * ss - rs * rs;
    real f = -ss * speed / volume, g = rs * speed / volume;
    real size = sqrt(f * f + g * g), fraction = size > most ? most / size : 1;
    impact_push(&r, fraction * f, x->u);
    impact_push(&s, fraction * g, x->u);
}

// The same about the normal.
static void stop_twisting(impact *x, const vec3 arm[BODIES], real friction)
{
    const vec3 n[BODIES] = { x->c.normal, x->c.normal };
    impact_row r = row_about(&x->pair, vec3_make(0, 0, 0), n);
    real most = 0;
    for (int i = 0; i < x->set.rows; i++)
        most += friction * x->set.impulse[i]
              * vec3_distance(x->arm[x->point[i]].a, arm[A]);
    real twist = -impact_parting(&r, x->u), mass = impact_product(&r, &r);
    if (!(mass > 0)) return;
    impact_push(&r, real_max(-most, real_min(twist / mass, most)), x->u);
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
