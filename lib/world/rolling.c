//> rolling
//>   It acts on what rolls slowly, or spins on its point: not on what slides
//>   still, nor on what a slope pulls along
//>   (`ball_rolls_down_a_slope_with_five_sevenths`).
#include "rolling.h"

#include <stddef.h>

// What is round turns against a lever of this, as on hard rubber; without it a ball
// on a floor never rests.
static const real RESISTANCE = 0.01;        // tuned, radii
// Faster ones roll freely, or it_rolls_for_ten_seconds_without_loss would not hold:
// the law of rolling is theirs.
static const real SLOW = 30;                // tuned, times sleep_speed

// m, of the smaller of the two that is round; 0: neither is.
static real radius_of(const contact *c)
{
    if (!(c->round_a > 0)) return c->round_b;
    return c->round_b > 0 ? real_min(c->round_a, c->round_b) : c->round_a;
}

static real slow_speed(const world_options *o, real radius)
{
    return sleep_scaled(SLOW * o->sleep_speed, vec3_length(o->gravity), radius);
}

static real speed_across(vec3 u, vec3 normal)
{
    return vec3_length(vec3_add_scaled(u, -vec3_dot(u, normal), normal));
}

// m/s: how fast the two surfaces pass each other where they touch.
static real slip_of(const rigid_tables *t, const contact *c)
{
    const solver_body *a = &t->now[c->a], *b = c->b < 0 ? NULL : &t->now[c->b];
    contact_arms arm = contact_arms_of(c, 0, &a->frame, b ? &b->frame : NULL);
    vec3 u = motion_at(&a->basis, &t->velocity[c->a], arm.a);
    if (b) u = vec3_sub(u, motion_at(&b->basis, &t->velocity[c->b], arm.b));
    return speed_across(u, c->normal);
}

// m/s: what that resistance takes of a speed in this frame, at most.
static real taken_by(const world *w)
{
    return RESISTANCE * vec3_length(w->options.gravity) * w->frame;
}

// Has it gained speed in this frame, by more than that?  Then something pulls it
// along, as on a slope, and it will not rest.
static bool gains_speed(const world *w, const contact *c)
{
    const rigid_tables *t = &w->rigid;
    vec3 was = t->ahead[c->a].delta, now = motion_straight(&t->velocity[c->a]);
    if (c->b >= 0) {
        was = vec3_sub(was, t->ahead[c->b].delta);
        now = vec3_sub(now, motion_straight(&t->velocity[c->b]));
    }
    return speed_across(now, c->normal)
           > speed_across(was, c->normal) / w->frame + taken_by(w);
}

// The angular impulse, `most` (N m s) or less, that brakes this spin of A beside B.
static void brake(rigid_tables *t, const contact *c, vec3 spin, real most)
{
    const motion_basis *a = &t->now[c->a].basis;
    const motion_basis *b = c->b < 0 ? &MOTION_IMMOVABLE : &t->now[c->b].basis;
    real speed = vec3_length(spin);
    if (!(speed > 0)) return;
    vec3 about = vec3_scale(1 / speed, spin);
    real stops = speed / (motion_answer(0, a, about) + motion_answer(0, b, about));
    vec3 impulse = vec3_scale(real_min(stops, most), about);
    motion_twist(&t->velocity[c->a], a, vec3_scale(-1, impulse));
    if (c->b >= 0) motion_twist(&t->velocity[c->b], b, impulse);
}

// The spin across the normal is rolling; that about it is braked if there is
// friction, and is no slip.  What slips slides still, unless that is a small share of
// its rolling, or over in this frame.
static void brake_both(world *w, const contact *c, real load)
{
    rigid_tables *t = &w->rigid;
    real radius = radius_of(c), most = RESISTANCE * radius * load;
    vec3 spin = motion_rotation(&t->now[c->a].basis, &t->velocity[c->a]);
    if (c->b >= 0)
        spin = vec3_sub(spin, motion_rotation(&t->now[c->b].basis,
                                              &t->velocity[c->b]));
    vec3 point = vec3_scale(vec3_dot(spin, c->normal), c->normal);
    vec3 rolls = vec3_sub(spin, point);
    real speed = vec3_length(rolls) * radius;
    if (slip_of(t, c) > real_max(RESISTANCE * speed, taken_by(w))
        || gains_speed(w, c)) return;
    if (speed < slow_speed(&w->options, radius))
        brake(t, c, rolls, most);
    material met = material_between(t->material, w->wall, c->a, c->b);
    if (met.friction > 0) brake(t, c, point, most);
}

static bool has_round(const world *w)
{
    for (int k = 0; k < w->shapes; k++) {
        const shape *s = w->shape[k].shape;
        if (w->shape[k].bodies > 0 && (s->round > 0 || s->rim > 0)) return true;
    }
    return false;
}

void rolling_brake(world *w)
{
    const rigid_tables *t = &w->rigid;
    const contact_solver *s = &t->solver;
    if (!(w->options.sleep_speed > 0) || !has_round(w)) return;
    for (int k = 0; k < s->contacts; k++) {
        const contact *c = t->cache.active[k];
        real load = s->active[k].load * w->frame / t->age[s->active[k].a];
        if (load > 0 && radius_of(c) > 0) brake_both(w, c, load);
    }
}
//<
