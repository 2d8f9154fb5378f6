//> plain-substep
#include "plain_solver.h"

void plain_substep(plain_solver *s, vec3 gravity)
{
    const solver_frame *f = s->frame;
    for (int b = 0; b < f->bodies; b++) {
        if (s->body[b].basis.inverse_mass == 0) continue;
        s->velocity[b].of[0] += f->h * gravity.x;
        s->velocity[b].of[1] += f->h * gravity.y;
        s->velocity[b].of[2] += f->h * gravity.z;
    }
    plain_warm_start(s);
    plain_push(s);
    plain_move(s);
    plain_relax(s);
}

// What lies is displaced: its rows stay where its contacts were found.  All else
// goes to where it is now.
static bool lies(const plain_solver *s, int b)
{
    return s->frame->is_elsewhere && s->frame->is_elsewhere[b];
}

void plain_move(plain_solver *s)
{
    real h = s->frame->h;
    for (int b = 0; b < s->frame->bodies; b++) {
        solver_body *x = &s->body[b];
        motion *u = &s->velocity[b];
        if (x->basis.inverse_mass == 0) continue;
        if (!lies(s, b))
            motion_advance(&x->frame, &x->basis, u, h);
        for (int i = 0; i < MOTIONS && lies(s, b); i++)
            s->moved[b].of[i] += h * u->of[i];
    }
    plain_measure(s);
}

void plain_measure(plain_solver *s)
{
    for (int i = 0; i < s->contacts; i++) {
        const contact *c = s->contact[i];
        const rigid_frame *b = c->b < 0 ? NULL : &s->body[c->b].frame;
        real height = c->b < 0 ? s->frame->plane[-1 - c->b].offset : 0;
        contact_gaps(c, &s->body[c->a].frame, b, height, s->gap[i]);
    }
}
//<

//> plain-pair
// The two bodies of a contact, A and B.
typedef struct {
    const motion_basis *basis[2];
    motion *velocity[2], *moved[2];
} pair;

static pair pair_of(const plain_solver *s, const contact *c)
{
    static const motion_basis immovable = { .inverse_mass = 0 };
    const solver_body *body = s->body;
    int a = c->a, b = c->b < 0 ? s->frame->bodies : c->b;
    return (pair){
        { &body[a].basis, c->b < 0 ? &immovable : &body[b].basis },
        { &s->velocity[a], &s->velocity[b] },
        { &s->moved[a], &s->moved[b] }
    };
}

// How fast the points at these arms part along d; of displacements: how far.
static real parting(const pair *p, motion *const m[2], const vec3 arm[2],
                    vec3 d)
{
    return vec3_dot(d, motion_at(p->basis[0], m[0], arm[0]))
         - vec3_dot(d, motion_at(p->basis[1], m[1], arm[1]));
}

// A gets the impulse, and B the opposite one.
static void apply(const pair *p, const vec3 arm[2], vec3 impulse)
{
    motion_push(p->velocity[0], p->basis[0], arm[0], impulse);
    motion_push(p->velocity[1], p->basis[1], arm[1], vec3_scale(-1, impulse));
}

// The inverse effective mass: how fast the points part along e, after an
// impulse of 1 along d.
static real response(const pair *p, const vec3 arm[2], vec3 d, vec3 e)
{
    real sum = 0;
    for (int side = 0; side < 2; side++) {
        const motion_basis *b = p->basis[side];
        vec3 of_d = vec3_cross(arm[side], d), of_e = vec3_cross(arm[side], e);
        sum += b->inverse_mass * vec3_dot(d, e);
        for (int t = 0; t < TURNS; t++)
            sum += vec3_dot(b->turn[t], of_d) * vec3_dot(b->turn[t], of_e);
    }
    return sum;
}
//<

//> plain-softness
//>   The three numbers of a soft contact, as in your program.
softness plain_softness(const solver_frame *f, bool both_move)
{
    const real pi = 3.141592653589793;
    real times = both_move ? 1 : 2;
    real omega = 2 * pi * times * real_min(f->hertz, 0.125 / f->h);
    real zeta = f->damping / times;
    real a1 = 2 * zeta + f->h * omega, a2 = f->h * omega * a1;
    return (softness){ .rate = omega / a1, .mass = a2 / (1 + a2),
                       .impulse = 1 / (1 + a2) };
}
//<

//> plain-normals
// What is open, has not pushed and closes fast is left to the impacts of the
// next substep, if there are any.  After the bodies have moved it may overlap.
static bool is_left(const solver_frame *f, const contact *c, real was,
                    real speed)
{
    real slowest = 2 * vec3_length(f->gravity) * f->h;
    return solver_strikes(f, c) && was == 0 && speed <= -slowest;
}

// Where the rows of body b are made: where it is.
static const rigid_frame *place_of(const plain_solver *s, int b)
{
    return lies(s, b) ? &s->frame->rows_at[b] : &s->body[b].frame;
}

// m: the radius of the smaller of those that move.
static real radius_of(const plain_solver *s, const contact *c)
{
    real radius = HUGE_VAL;
    const int side[2] = { c->a, c->b };
    for (int i = 0; i < 2; i++)
        if (side[i] >= 0 && s->body[side[i]].basis.inverse_mass > 0)
            radius = real_min(radius, s->body[side[i]].radius);
    return radius;
}

// The arms of point k of contact i.
static contact_arms arms_of(const plain_solver *s, int i, int k)
{
    const contact *c = s->contact[i];
    return contact_arms_of(c, k, place_of(s, c->a),
                           c->b < 0 ? NULL : place_of(s, c->b));
}

// m/s: what closes faster strikes.
static real slowest_of(const plain_solver *s)
{
    return 2 * vec3_length(s->frame->gravity) * s->frame->h;
}

// Does a point push that is open?
static bool solve_normals(plain_solver *s, int i, softness soft, bool relaxes)
{
    contact *c = s->contact[i];
    pair p = pair_of(s, c);
    vec3 n = c->normal;
    bool strikes = false;
    for (int k = 0; k < c->count; k++) {
        contact_arms at = arms_of(s, i, k);
        const vec3 arm[2] = { at.a, at.b };
        real was = c->impulse[k];
        real gap = s->gap[i][k] + parting(&p, p.moved, arm, n);
        real speed = parting(&p, p.velocity, arm, n);
        bool open = gap > CONTACT_TOUCHES * radius_of(s, c);
        if ((relaxes || open) && is_left(s->frame, c, was, speed)) continue;
        real mass = 1 / response(&p, arm, n, n);
        real lacking = speed + gap / s->frame->h, leak = 0;
        if (!open) {
            real bias = soft.mass * soft.rate * gap;
            real most = s->frame->max_rate * radius_of(s, c);
            lacking = soft.mass * speed + real_max(bias, -most);
            leak = soft.impulse * was;
        }
        c->impulse[k] = real_max(was - mass * lacking - leak, 0);
        apply(&p, arm, vec3_scale(c->impulse[k] - was, n));
        strikes |= open && c->impulse[k] > 0;
        s->strikes[i] |= (relaxes ? gap > 0 : open) && c->impulse[k] > 0
                      && speed <= -slowest_of(s);
    }
    return strikes;
}

// What strikes is solved once for each point that a contact may have.
void plain_push(plain_solver *s)
{
    for (int i = 0; i < s->contacts; i++) {
        pair p = pair_of(s, s->contact[i]);
        bool both_move = p.basis[0]->inverse_mass > 0
                      && p.basis[1]->inverse_mass > 0;
        softness soft = plain_softness(s->frame, both_move);
        bool strikes = solve_normals(s, i, soft, false);
        strikes &= s->contact[i]->count > 1;
        for (int k = 1; strikes && k < CONTACT_POINTS; k++)
            solve_normals(s, i, soft, false);
    }
}
//<

//> plain-center
// Where friction acts: the middle of the points that touch, of the first body
// that moves; on the other at the same place.  One counts fully up to a gap of a
// 25th of a radius, and for a hundredth from two 25ths on.
typedef struct {
    vec3 arm[2];            // m, from both bodies
    real lever;             // N m s: the sum of impulses times distances
} friction_center;

static friction_center center_of(const plain_solver *s, int i, const pair *p)
{
    const contact *c = s->contact[i];
    friction_center f = { .lever = 0 };
    real near = radius_of(s, c) / 25, sum = 0;
    bool of_b = !(p->basis[0]->inverse_mass > 0);
    vec3 *arm = &f.arm[of_b];
    for (int k = 0; k < c->count; k++) {
        real share = real_min(1, real_max(0.01, 2 - s->gap[i][k] / near));
        contact_arms at = arms_of(s, i, k);
        sum += share;
        *arm = vec3_add_scaled(*arm, share, of_b ? at.b : at.a);
    }
    *arm = vec3_scale(1 / sum, *arm);
    for (int k = 0; k < c->count; k++) {
        contact_arms at = arms_of(s, i, k);
        f.lever += c->impulse[k] * vec3_distance(of_b ? at.b : at.a, *arm);
    }
    if (c->b < 0) return f;
    vec3 way = vec3_sub(place_of(s, c->a)->center, place_of(s, c->b)->center);
    f.arm[!of_b] = vec3_add_scaled(*arm, of_b ? -1 : 1, way);
    return f;
}
//<

//> plain-friction
// Any two unit vectors across n and each other.
static void find_across(vec3 n, vec3 t[2])
{
    vec3 other = { 0, 0, 0 };
    if (fabs(n.x) < 0.6) other.x = 1;
    else other.y = 1;
    t[0] = vec3_unit(vec3_cross(n, other));
    t[1] = vec3_cross(n, t[0]);
}

// A and B turn against each other about the normal.
static void apply_twist(const pair *p, vec3 n, real twist)
{
    for (int t = 0; t < TURNS; t++) {
        p->velocity[0]->of[MOTION_TURN + t]
            += vec3_dot(p->basis[0]->turn[t], n) * twist;
        p->velocity[1]->of[MOTION_TURN + t]
            -= vec3_dot(p->basis[1]->turn[t], n) * twist;
    }
}

static void solve_twist(const pair *p, contact *c, real most)
{
    vec3 n = c->normal;
    real response = 0, was = c->twist;
    real speed = vec3_dot(n, motion_rotation(p->basis[0], p->velocity[0]))
               - vec3_dot(n, motion_rotation(p->basis[1], p->velocity[1]));
    for (int t = 0; t < TURNS; t++) {
        real a = vec3_dot(n, p->basis[0]->turn[t]);
        real b = vec3_dot(n, p->basis[1]->turn[t]);
        response += a * a + b * b;
    }
    c->twist = real_max(-most, real_min(most, was - speed / response));
    apply_twist(p, n, c->twist - was);
}

// Takes the impulse (x, y) that stops all sliding: two equations,
//     K00 x + K01 y = -slide 0,    K01 x + K11 y = -slide 1.
static void solve_across(const pair *p, contact *c, const vec3 arm[2],
                         real most)
{
    vec3 t[2], was = c->friction;
    find_across(c->normal, t);
    real k00 = response(p, arm, t[0], t[0]), k01 = response(p, arm, t[0], t[1]);
    real k11 = response(p, arm, t[1], t[1]), volume = k00 * k11 - k01 * k01;
    real slide0 = parting(p, p->velocity, arm, t[0]);
    real slide1 = parting(p, p->velocity, arm, t[1]);
    real x = -(k11 * slide0 - k01 * slide1) / volume;
    real y = -(k00 * slide1 - k01 * slide0) / volume;
    vec3 all = vec3_add_scaled(vec3_add_scaled(was, x, t[0]), y, t[1]);
    real length = vec3_length(all);
    c->friction = length > most ? vec3_scale(most / length, all) : all;
    apply(p, arm, vec3_sub(c->friction, was));
}

static void relax(plain_solver *s, int i)
{
    const softness rigid = { .rate = 0, .mass = 1, .impulse = 0 };
    contact *c = s->contact[i];
    pair p = pair_of(s, c);
    solve_normals(s, i, rigid, true);
    friction_center f = center_of(s, i, &p);
    solve_twist(&p, c, s->frame->friction * f.lever);
    solve_across(&p, c, f.arm, s->frame->friction * contact_load(c));
}

// A contact that brought no impulse along has yet to find it, and what strikes too.
void plain_relax(plain_solver *s)
{
    for (int i = 0; i < s->contacts; i++) {
        relax(s, i);
        bool seeks = s->is_first[i] || s->strikes[i];
        for (int k = 1; seeks && k < CONTACT_POINTS; k++) relax(s, i);
    }
}
//<

//> plain-warm
//>   The start of a frame, and the warm start of a substep: the impulses along
//>   the normals, the friction in the middle of the points, and the twist.
void plain_begin(plain_solver *s)
{
    for (int i = 0; i < s->contacts; i++) {
        contact *c = s->contact[i];
        s->is_first[i] = contact_load(c) == 0;
        // One point cannot hold a twist that more have held.
        if (c->count == 1) c->twist = 0;
        // The normal may have turned since the last frame.
        c->friction = vec3_add_scaled(c->friction,
                                      -vec3_dot(c->normal, c->friction),
                                      c->normal);
    }
    plain_measure(s);
}

void plain_warm_start(plain_solver *s)
{
    for (int i = 0; i < s->contacts; i++) {
        contact *c = s->contact[i];
        pair p = pair_of(s, c);
        s->strikes[i] = false;
        for (int k = 0; k < c->count; k++) {
            contact_arms at = arms_of(s, i, k);
            const vec3 arm[2] = { at.a, at.b };
            apply(&p, arm, vec3_scale(c->impulse[k], c->normal));
        }
        friction_center f = center_of(s, i, &p);
        apply(&p, f.arm, c->friction);
        apply_twist(&p, c->normal, c->twist);
    }
}
//<
