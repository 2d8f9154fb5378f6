//> ahead-look
//>   What is found in a frame must hold until it ends.
#include "ahead.h"
#include "advance.h"
#include "handle.h"

#include <stddef.h>

// How far a body may get in so many seconds: as fast as it is now, with what
// gravity adds and what else pushes it, and a hundredth of its radius for what
// impacts add.  Nothing but its velocity moves what is driven.  However far it
// turns, no vertex gets further than across; and a ball gets nowhere by turning.
static const real HUNDREDTH = 100;          // tuned, per radius

// m: a vertex is as far from the axis of the turn as it is across.  What is long
// and turns about that length goes nowhere by it.
static real arc_of(const world *w, int b, vec3 spin, real turn)
{
    const solver_body *now = &w->rigid.now[b];
    const vec3 *axis = now->frame.axis, span = w->body[b].rigid->span;
    real out = now->radius - w->body[b].round;
    real most = span.x * vec3_length(vec3_cross(spin, axis[0]))
              + span.y * vec3_length(vec3_cross(spin, axis[1]))
              + span.z * vec3_length(vec3_cross(spin, axis[2]));
    return turn > 2 ? 2 * out : real_min(most, out * turn);
}

static prediction predict(const world *w, int b, real dt)
{
    const solver_body *now = &w->rigid.now[b];
    const motion *u = &w->rigid.velocity[b];
    vec3 straight = motion_straight(u);
    vec3 spin = rigid4_lean(w->body[b].rigid, &now->frame,
                            motion_rotation(&now->basis, u));
    real beside = vec3_length(body_gravity(w, b)) * dt * dt / 2
                + rigid_width(&w->rigid, b) / HUNDREDTH;
    if (now->is_driven) beside = 0;
    if (w->rigid.is_loaded && !now->is_driven) {
        motion more = world_load(w, b, dt);
        beside += dt * motion_fastest(&now->basis, &more, now->radius);
    }
    prediction p = { .seconds = dt, .delta = vec3_scale(dt, straight),
                     .spin = vec3_scale(dt, spin) };
    p.angle = vec3_length(p.spin);
    p.arc = arc_of(w, b, p.spin, p.angle);
    p.turn = p.arc + beside;
    p.reach = vec3_length(p.delta) + p.turn;
    return p;
}
//<

//> ahead-middle
// A body that turns comes to touch with other corners than those that are near
// when it is asked.  So it is asked as it will stand in the middle of the time:
// where it is, but turned by half of what it turns; by less, if that is more
// than MANIFOLD_TURN (rad), for it is asked again then; not at all, if it is less than
// NO_TURN, as of what lies.
static const real NO_TURN = 0.01;           // tuned, rad

static rigid_frame find_middle(const world *w, int b, real seconds)
{
    const solver_body *now = &w->rigid.now[b];
    const prediction *p = &w->rigid.ahead[b];
    real turn = p->arc / rigid_width(&w->rigid, b) * real_max(p->angle / 2, 1);
    motion half = { { 0 } };
    seconds /= 2;
    if (turn < NO_TURN) return now->frame;
    if (turn > 2 * MANIFOLD_TURN) seconds *= 2 * MANIFOLD_TURN / turn;
    for (int i = MOTION_TURN; i < MOTIONS; i++)
        half.of[i] = seconds * w->rigid.velocity[b].of[i];
    return motion_frame(&now->frame, &now->basis, &half);
}

void ahead_predict(world *w, int b, real seconds)
{
    w->rigid.ahead[b] = predict(w, b, seconds);
    w->rigid.asked[b] = find_middle(w, b, seconds);
}
//<

//> ahead-frame
//>   The step lends the cache its bodies.
cache_frame ahead_frame(const world *w)
{
    const rigid_tables *t = &w->rigid;
    return (cache_frame){
        .body = t->body, .now = t->now, .asked = t->asked,
        .ahead = t->ahead, .moves = t->moves,
        .awake = t->awake, .awakes = t->awakes,
        .list = &t->pairs, .is_new_list = t->is_new_list,
        .plane = w->plane, .stay = w->options.stay,
        .has_parts = w->options.host.surround, .has_pieces = w->has_pieces,
        .run = w->options.host.run };
}
//<

//> ahead-used
//>   Has a pair used up what its answer was good for?
// m: by how much the gap of any point of a body may differ from those of points
// that were found, for it has turned by so much since; 0 if by no more than
// MANIFOLD_TURN allows.
static real if_far(const world *w, int b, real turned)
{
    real gone = (w->rigid.now[b].radius - w->body[b].round) * turned;
    return gone > MANIFOLD_TURN * rigid_width(&w->rigid, b) ? gone : 0;
}

// A coin that rolls on its rim touches elsewhere when it leans another way, and is
// to be asked as often as it turns.
static real find_turned(const world *w, int b)
{
    const rigid_tables *t = &w->rigid;
    const rigid_frame *was = &t->cache.placed[b];
    if (!t->moves[b] || t->going[b] == LIES) return 0;
    return if_far(w, b, w->body[b].round > 0 ? advance_leaned(w, b, was)
                                             : advance_turned(w, b, was));
}

static bool find_all_turned(world *w)
{
    rigid_tables *t = &w->rigid;
    bool some = false;
    for (int k = 0; k < t->awakes; k++) {
        int b = t->awake[k];
        t->turned[b] = find_turned(w, b);
        some |= t->turned[b] > 0;
    }
    return some;
}

// Does b, round about an axis, lie on its side, with that across the normal?
static bool is_along(const world *w, int b, vec3 normal)
{
    const rigid4 *r = w->body[b].rigid;
    real up = vec3_dot(w->rigid.now[b].frame.axis[1], normal);
    return r->round_axes == 1
        && up * up <= LEAN_SINE * LEAN_SINE * r->square[1];
}

// But what lies on its side touches there however it rolls.
static real turned_of(const world *w, const contact *c, int b)
{
    const rigid_tables *t = &w->rigid;
    if (b < 0 || !t->moves[b] || !(t->turned[b] > 0)) return 0;
    if (!is_along(w, b, c->normal)) return t->turned[b];
    return if_far(w, b, advance_leaned(w, b, &t->cache.placed[b]));
}

// Does body b go elsewhere by now, in `left` (s), than it was asked for?
static bool strays(const world *w, int b, real left)
{
    const rigid_tables *t = &w->rigid;
    if (b < 0 || !t->moves[b]) return false;
    const prediction *p = &t->ahead[b];
    vec3 now = vec3_scale(left, motion_straight(&t->velocity[b]));
    vec3 was = vec3_scale(left / p->seconds, p->delta);
    return vec3_distance(now, was) > p->turn - p->arc;
}

// They passed each other, as they went when they were asked.
static bool pass_no_more(const world *w, int k, real left)
{
    const contact *c = w->rigid.cache.active[k];
    return w->rigid.cache.of[k]->passes
        && (strays(w, c->a, left) || strays(w, c->b, left));
}

// Where the points that were found are further open than that, no other touches.
static bool is_used_up(const world *w, const active_contact *x,
                       const contact *c)
{
    const rigid_tables *t = &w->rigid;
    if (x->count == 0) return false;
    real turned = turned_of(w, c, c->a) + turned_of(w, c, c->b);
    real gap[CONTACT_POINTS], least = HUGE_VAL;
    if (!(turned > 0)) return false;
    const rigid_frame *at_b = c->b < 0 ? NULL : &t->now[c->b].frame;
    contact_gaps(c, &t->now[c->a].frame, at_b,
                 c->b < 0 ? w->plane[-1 - c->b].offset : 0, gap);
    for (int k = 0; k < c->count; k++) least = real_min(least, gap[k]);
    return least < turned;
}
//<

//> ahead-again
//>   Such a pair is asked again, and its block is filled again. No other pays.
// A piece goes as the body that it rides on.
static void predict_side(world *w, int b, real left)
{
    rigid_tables *t = &w->rigid;
    if (b < 0) return;
    int of = body_whole(&w->body[b], b);
    if (b != of) {
        t->now[b].frame = t->now[of].frame;
        t->now[b].basis = t->now[of].basis;
        t->velocity[b] = t->velocity[of];
    }
    if (w->rigid.moves[b]) ahead_predict(w, b, left);
    else w->rigid.asked[b] = w->rigid.now[b].frame;
}

// A program that chooses contacts was not asked for this one, without points.
static void choose_again(world *w, int k)
{
    const world_host *host = &w->options.host;
    contact *c = w->rigid.cache.active[k];
    if (c->count > 0 && host->meets && !host->meets(host->chooser, c))
        c->count = w->rigid.cache.of[k]->count = 0;
}

void ahead_again(world *w, const solver_frame *f, real left)
{
    rigid_tables *t = &w->rigid;
    contact_solver *s = &t->solver;
    bool some = false;
    if (!find_all_turned(w) && t->cache.passing == 0) return;
    for (int k = s->first; k < s->end; k++) {
        active_contact *x = &s->active[k];
        x->is_new = is_used_up(w, x, t->cache.active[k])
                 || pass_no_more(w, k, left);
        some |= x->is_new;
    }
    if (!some) return;
    solver_store_new(s, t->cache.active);
    cache_frame ask = ahead_frame(w);
    for (int k = s->first; k < s->end; k++) {
        if (!s->active[k].is_new) continue;
        predict_side(w, t->cache.active[k]->piece_a, left);
        predict_side(w, t->cache.active[k]->piece_b, left);
        bool had_none = t->cache.active[k]->count == 0;
        cache_again(&t->cache, &ask, k);
        if (had_none) choose_again(w, k);
    }
    if (!solver_take_new(s, f, t->cache.active, t->cache.reach))
        w->report.dropped += s->end - s->first;
}
//<
