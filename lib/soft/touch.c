//> touch-push
#include "touch.h"

#include <stddef.h>

// A particle that touches a rigid body.
typedef struct {
    vec3 normal;        // unit, out of the body
    vec3 arm;           // m, of the point touched, from the body's centre
    real overlap;       // m, now
    vec3 slide;         // m, how far the particle passed that point in the
                        // substep
} touch_point;

// A particle at a rigid body.
typedef struct {
    const soft_frame *f;
    const rigid_view *view;     // of that body
    int  b;
    surface_point at;           // the point of its surface
    real apart;                 // m, what is kept between the two
} touch;

static touch_point touch_of(const touch *x, const particle *p)
{
    const soft_frame *f = x->f;
    const motion_basis *basis = &f->now[x->b].basis;
    const real *seen = x->view->moved.of;
    motion since = f->moved[x->b];
    for (int i = 0; i < MOTIONS; i++) since.of[i] -= seen[i];
    vec3 go = { seen[0], seen[1], seen[2] };
    touch_point t = { .normal = x->at.normal };
    t.arm = vec3_sub(x->at.at, vec3_add(f->now[x->b].frame.center, go));
    vec3 at = vec3_add(x->at.at, motion_at(basis, &since, t.arm));
    vec3 way = vec3_scale(f->h, motion_at(basis, &f->velocity[x->b], t.arm));
    t.overlap = x->apart - vec3_dot(vec3_sub(p->position, at), t.normal);
    t.slide = vec3_sub(vec3_sub(p->position, p->previous), way);
    return t;
}

// m/kg, how far an impulse times a time of 1 kg m along d (unit) parts the two.
static real answer(const motion_basis *basis, const particle *p, vec3 arm,
                   vec3 d)
{
    vec3 moment = vec3_cross(arm, d);
    real sum = p->inverse_mass + basis->inverse_mass;
    for (int t = 0; t < TURNS; t++) {
        real row = vec3_dot(basis->turn[t], moment);
        sum += row * row;
    }
    return sum;
}

// A part of the overlap is older than this substep: the particle, and the body,
// stand elsewhere, and have no more speed for that.
static void correct(const touch *x, particle *p, vec3 arm, vec3 push)
{
    p->position = vec3_add_scaled(p->position, p->inverse_mass, push);
    p->previous = vec3_add_scaled(p->previous, p->inverse_mass, push);
    motion_push(&x->f->moved[x->b], &x->f->now[x->b].basis, arm,
                vec3_scale(-1, push));
}

// A push of 1 kg m in a substep of h is an impulse of 1 / h.
static void push(const touch *x, particle *p, vec3 arm, vec3 push)
{
    const soft_frame *f = x->f;
    const motion_basis *basis = &f->now[x->b].basis;
    p->position = vec3_add_scaled(p->position, p->inverse_mass, push);
    motion_push(&f->moved[x->b], basis, arm, vec3_scale(-1, push));
    motion_push(&f->velocity[x->b], basis, arm, vec3_scale(-1 / f->h, push));
}

static void push_apart(const touch *x, particle *p)
{
    const motion_basis *basis = &x->f->now[x->b].basis;
    touch_point t = touch_of(x, p);
    real give = answer(basis, p, t.arm, t.normal);
    if (!(t.overlap > 0) || !(give > 0)) return;
    real old = t.overlap + vec3_dot(t.slide, t.normal);
    old = real_min(real_max(old, 0), t.overlap);
    correct(x, p, t.arm, vec3_scale(old / give, t.normal));
    real load = (t.overlap - old) / give;
    push(x, p, t.arm, vec3_scale(load, t.normal));

    // Coulomb: at most so much of the load as takes the sliding back.
    vec3 slide = touch_of(x, p).slide;
    slide = vec3_add_scaled(slide, -vec3_dot(slide, t.normal), t.normal);
    real length = vec3_length(slide);
    if (!(length > 0)) return;
    vec3 across = vec3_scale(1 / length, slide);
    real brake = real_min(x->f->friction * load,
                          length / answer(basis, p, t.arm, across));
    push(x, p, t.arm, vec3_scale(-brake, across));
}
//<

//> touch-whole
// A particle at x that weighs what the cloth weighs, and moves as its centre
// of mass does; pinned, if any of it is.
static particle whole_cloth(const soft_frame *f, const body *soft, vec3 x)
{
    particle whole = { .position = x, .previous = x };
    vec3 sum = { 0, 0, 0 };
    for (int i = soft->first; i < soft->first + soft->shape->particles; i++) {
        const particle *p = &f->particle[i];
        if (p->inverse_mass == 0) return whole;
        vec3 step = vec3_sub(p->position, p->previous);
        sum = vec3_add_scaled(sum, 1 / p->inverse_mass, step);
    }
    whole.inverse_mass = 1 / soft->mass;
    whole.previous = vec3_add_scaled(x, -whole.inverse_mass, sum);
    return whole;
}

// For a moment the whole cloth stands in the particle's place; how far that is
// pushed, the cloth goes.
static void push_whole(const touch *x, point_pair pair)
{
    const soft_frame *f = x->f;
    const body *soft = &f->body[pair.soft];
    vec3 here = f->particle[pair.particle].position;
    particle before = whole_cloth(f, soft, here), after = before;
    push_apart(x, &after);
    if (before.inverse_mass == 0) return;
    vec3 now = vec3_sub(after.position, before.position);
    vec3 then = vec3_sub(after.previous, before.previous);
    for (int i = soft->first; i < soft->first + soft->shape->particles; i++) {
        particle *p = &f->particle[i];
        p->position = vec3_add(p->position, now);
        p->previous = vec3_add(p->previous, then);
    }
}
//<

//> touch-fixed
// How far the strands will let it slide is what they did in the last substep.
static void slide(const soft_frame *f, particle *p, line_hold *hold,
                  real pressed)
{
    vec3 n = hold->normal, went = vec3_sub(p->position, p->previous);
    vec3 would = vec3_add(went, hold->pull);
    went = vec3_add_scaled(went, -vec3_dot(went, n), n);
    would = vec3_add_scaled(would, -vec3_dot(would, n), n);
    real most = f->friction * pressed, far = vec3_length(would);
    hold->state = far <= most ? LINE_STICKS : LINE_SLIDES;
    p->position = far <= most ? vec3_sub(p->position, went)
                : vec3_add_scaled(p->position, -most / far, would);
}

// A particle leaves what does not move by the shortest way.  If the strands
// press it on, they will find it held; where two things do, they hold it to all
// sides.
static bool touch_fixed(const soft_frame *f, int i, surface_point at,
                        real apart)
{
    particle *p = &f->particle[i];
    line_hold *hold = &f->hold[i];
    real depth = apart - vec3_dot(vec3_sub(p->position, at.at), at.normal);
    if (!(depth > 0) || !(depth < HUGE_VAL)) return false;
    if (p->inverse_mass == 0) return true;
    real pressed = depth + real_max(-vec3_dot(hold->pull, at.normal), 0);
    p->position = vec3_add_scaled(p->position, depth, at.normal);
    bool is_held = hold->state != LINE_FREE;
    hold->normal = at.normal;
    slide(f, p, hold, pressed);
    if (is_held) hold->state = LINE_STICKS;
    return true;
}
//<

//> touch-bodies
static bool touch_body(const rigid_view *v, const soft_frame *f,
                       point_pair pair, real apart, answering who)
{
    particle *p = &f->particle[pair.particle];
    touch x = { f, v, pair.rigid, .apart = apart };
    if (!obstacle_nearest(&v->hull, p->position, pair.ahead, apart, &x.at))
        return false;
    if (body_is_static(&f->body[pair.rigid]))
        return who == BY_PARTICLE && touch_fixed(f, pair.particle, x.at, apart);
    if (who == BY_PARTICLE) push_apart(&x, p);
    else                    push_whole(&x, pair);
    f->hold[pair.particle].state = LINE_FREE;
    return true;
}

// They push one after the other: the first tilt a body that lies on them, the
// last set it upright again, and friction takes the tilting for sliding.  So
// they come in the other order in every other substep, or the body would creep.
int touch_bodies(const near_lists *l, rigid_view *v, const soft_frame *f,
                 real share, answering who, bool is_backward)
{
    int touching = 0, n = l->points;
    point_pair last = { .soft = -1 };
    real apart = 0;
    for (int k = 0; k < n; k++) {
        point_pair pair = l->point[is_backward ? n - 1 - k : k];
        if (pair.soft != last.soft || pair.rigid != last.rigid) {
            rigid_view_look(v, f, pair.rigid);
            apart = share * soft_gap(&f->body[pair.soft],
                                     &f->body[pair.rigid]);
        }
        last = pair;
        touching += touch_body(v, f, pair, apart, who);
    }
    return touching;
}
//<

//> touch-particles
static bool touch_plane(const soft_frame *f, int i, plane wall, real apart)
{
    vec3 x = f->particle[i].position;
    vec3 foot = vec3_add_scaled(x, -plane_height(wall, x), wall.normal);
    return touch_fixed(f, i, (surface_point){ foot, wall.normal }, apart);
}

int touch_planes(const soft_frame *f)
{
    int touching = 0;
    for (int b = 0; b < f->bodies && f->planes > 0; b++) {
        const body *soft = &f->body[b];
        if (!is_moving_soft(f, b)) continue;
        for (int i = soft->first; i < soft->first + soft->shape->particles; i++)
            for (int k = 0; k < f->planes; k++)
                touching += touch_plane(f, i, f->plane[k], soft->thickness);
    }
    return touching;
}

int touch_pairs(const near_lists *l, const soft_frame *f)
{
    int touching = 0;
    for (int k = 0; k < l->pairs; k++)
        if (particle_contact_overlaps(&l->pair[k], f->particle))
            touching += particle_contact_separate(l->pair[k], f->particle,
                                                  f->friction) > 0;
    return touching;
}
//<
