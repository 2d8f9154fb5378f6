//> touch-push
//>   A push on a body that moves.
#include "touch.h"
#include "material.h"

#include <stddef.h>

// A point of a cloth or a rope at a rigid body: a particle, or a weighted mean
// of two or three.
typedef struct {
    const soft_frame *f;
    const rigid_view *view;     // of that body
    const body *soft;
    int  b;
    int  corners;               // particles, in the pool, and their weights
    int  corner[FACET];
    real weight[FACET];
    surface_point at;           // the point of the body's surface
    real apart;                 // m, what is kept between the two
    real friction;
    bool is_after;              // the strands have drawn it already
} soft_touch;

// How that point touches the body.
typedef struct {
    vec3 normal;        // unit, out of the body
    vec3 arm;           // m, of the point touched, from the body's centre
    real overlap;       // m, now
    vec3 slide;         // m, how far the particle passed that point in the
                        // substep
} touch_point;

static touch_point touch_of(const soft_touch *x, const particle *p)
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
    vec3 delta = vec3_scale(f->h, motion_at(basis, &f->velocity[x->b], t.arm));
    t.overlap = x->apart - vec3_dot(vec3_sub(p->position, at), t.normal);
    t.slide = vec3_sub(vec3_sub(p->position, p->previous), delta);
    return t;
}

// m/kg, how far an impulse times a time of 1 kg m along d (unit) parts the two.
static real answer(const motion_basis *basis, const particle *p, vec3 arm,
                   vec3 d)
{
    return motion_answer(p->inverse_mass + basis->inverse_mass, basis,
                         vec3_cross(arm, d));
}

// A part of the overlap is older than this substep: the particle, and the body,
// stand elsewhere, and have no more speed for that.
static void correct(const soft_touch *x, particle *p, vec3 arm, vec3 push)
{
    p->position = vec3_add_scaled(p->position, p->inverse_mass, push);
    p->previous = vec3_add_scaled(p->previous, p->inverse_mass, push);
    motion_push(&x->f->moved[x->b], &x->f->now[x->b].basis, arm,
                vec3_scale(-1, push));
}

// A push of 1 kg m in a substep of h is an impulse of 1 / h.
static void push_particle(const soft_touch *x, particle *p, vec3 arm, vec3 push)
{
    const soft_frame *f = x->f;
    const motion_basis *basis = &f->now[x->b].basis;
    p->position = vec3_add_scaled(p->position, p->inverse_mass, push);
    motion_push(&f->moved[x->b], basis, arm, vec3_scale(-1, push));
    motion_push(&f->velocity[x->b], basis, arm, vec3_scale(-1 / f->h, push));
}

// So much of the overlap is older than this substep, and is not what the strands
// press.
static void note_old(const soft_frame *f, int soft, real old, real apart)
{
    bool is_deep = old > CONTACT_DEEP * apart;
    if (is_deep && f->sunk[soft] != SUNK_NOT) f->sunk[soft] = SUNK;
}

// m, how far the strands will draw a particle, as they did before.
static vec3 hold_drawn(const line_hold *h)
{
    return vec3_scale(hold_share(h), h->pull);
}

static vec3 point_drawn(const soft_touch *x)
{
    vec3 drawn = { 0, 0, 0 };
    for (int k = 0; k < x->corners && !x->is_after; k++)
        drawn = vec3_add_scaled(drawn, x->weight[k],
                                hold_drawn(&x->f->hold[x->corner[k]]));
    return drawn;
}

static void part_from_moving(const soft_touch *x, particle *p)
{
    const motion_basis *basis = &x->f->now[x->b].basis;
    touch_point t = touch_of(x, p);
    real give = answer(basis, p, t.arm, t.normal);
    if (!(t.overlap > 0) || !(give > 0)) return;
    real old = t.overlap + vec3_dot(t.slide, t.normal);
    old = real_min(real_max(old, 0), t.overlap);
    note_old(x->f, (int)(x->soft - x->f->body), old, x->apart);
    correct(x, p, t.arm, vec3_scale(old / give, t.normal));
    real load = (t.overlap - old) / give;
    push_particle(x, p, t.arm, vec3_scale(load, t.normal));

    // Coulomb: at most so much of the load as takes the sliding back.
    vec3 slide = vec3_add(touch_of(x, p).slide, point_drawn(x));
    slide = vec3_add_scaled(slide, -vec3_dot(slide, t.normal), t.normal);
    real length = vec3_length(slide);
    if (!(length > 0)) return;
    vec3 across = vec3_scale(1 / length, slide);
    real brake = real_min(x->friction * load,
                          length / answer(basis, p, t.arm, across));
    push_particle(x, p, t.arm, vec3_scale(-brake, across));
}
//<

//> touch-held
// How straight something fixed holds a particle against the body: 1, straight; 0,
// not at all.
static real held_against(const soft_touch *x, int i)
{
    const line_hold *h = &x->f->hold[i];
    if (h->state < LINE_TOUCHES) return 0;
    return real_max(-vec3_dot(h->normal, x->at.normal), 0);
}

// A particle on something fixed goes along it, and not into it: the straighter it
// is pushed against it, the less it answers.  If it answered as a free one, it
// would be pushed back in every substep, and be a spring, the stiffer the shorter
// these are.
static real inverse_of(const soft_touch *x, int i)
{
    real against = held_against(x, i);
    return x->f->particle[i].inverse_mass * (1 - against * against);
}

// And by what the fixed thing has moved it, it has not come nearer.
static vec3 previous_of(const soft_touch *x, int i)
{
    const particle *p = &x->f->particle[i];
    real against = held_against(x, i);
    vec3 n = x->at.normal;
    real nearer = real_min(vec3_dot(vec3_sub(p->position, p->previous), n), 0);
    return vec3_add_scaled(p->previous, against * against * nearer, n);
}
//<

//> touch-stand-in
// The point as a particle: it stands in for those that it is a mean of.  A push
// moves each by its weight and its inverse mass, so the point by the sum of
// weight^2 times inverse mass.
static particle stand_in(const soft_touch *x)
{
    particle mean = { .inverse_mass = 0 };
    for (int k = 0; k < x->corners; k++) {
        const particle *p = &x->f->particle[x->corner[k]];
        real c = x->weight[k];
        mean.position = vec3_add_scaled(mean.position, c, p->position);
        mean.previous = vec3_add_scaled(mean.previous, c,
                                        previous_of(x, x->corner[k]));
        mean.inverse_mass += c * c * inverse_of(x, x->corner[k]);
    }
    return mean;
}

// It was pushed from `before` to `after`, and they with it.
static void distribute_push(const soft_touch *x, const particle *before,
                            const particle *after)
{
    vec3 now = vec3_sub(after->position, before->position);
    vec3 then = vec3_sub(after->previous, before->previous);
    if (!(before->inverse_mass > 0)) return;
    for (int k = 0; k < x->corners; k++) {
        particle *p = &x->f->particle[x->corner[k]];
        real fraction = x->weight[k] * inverse_of(x, x->corner[k])
                   / before->inverse_mass;
        p->position = vec3_add_scaled(p->position, fraction, now);
        p->previous = vec3_add_scaled(p->previous, fraction, then);
    }
}
//<

//> touch-whole
// At that point the cloth as a whole: a particle that weighs what the cloth
// weighs with what hangs on it, and moves as its centre of mass does; pinned, if
// any of it is.
static particle whole_cloth(const soft_touch *x)
{
    const body *soft = x->soft;
    particle whole = stand_in(x);
    vec3 sum = { 0, 0, 0 };
    real mass = 0;
    whole.previous = whole.position;
    whole.inverse_mass = 0;
    for (int i = soft->first; i < soft->first + soft->shape->particles; i++) {
        const particle *p = &x->f->particle[i];
        if (p->inverse_mass == 0) return whole;
        vec3 step = vec3_sub(p->position, p->previous);
        sum = vec3_add_scaled(sum, 1 / p->inverse_mass, step);
        mass += 1 / p->inverse_mass;
    }
    whole.inverse_mass = 1 / mass;
    whole.previous = vec3_add_scaled(whole.position, -whole.inverse_mass, sum);
    return whole;
}

// How far that is pushed, the cloth goes.
static void distribute_to_all(const soft_touch *x, const particle *before,
                              const particle *after)
{
    const body *soft = x->soft;
    vec3 now = vec3_sub(after->position, before->position);
    vec3 then = vec3_sub(after->previous, before->previous);
    if (before->inverse_mass == 0) return;
    for (int i = soft->first; i < soft->first + soft->shape->particles; i++) {
        particle *p = &x->f->particle[i];
        p->position = vec3_add(p->position, now);
        p->previous = vec3_add(p->previous, then);
    }
}
//<

//> touch-fixed
//>   What does not move needs no such care. The particle leaves it, and
//>   remembers the normal, and how much of a move friction holds; the strands do
//>   the rest (chapter 12).
static vec3 along_side(vec3 delta, vec3 normal)
{
    return vec3_add_scaled(delta, -vec3_dot(delta, normal), normal);
}

// Coulomb: friction takes back how far the particle went, and how far the strands
// will draw it; but of both no more than its share of the load.
static void slide_particle(particle *p, const line_hold *hold, real most)
{
    vec3 went = vec3_add(vec3_sub(p->position, p->previous), hold_drawn(hold));
    went = along_side(went, hold->normal);
    real far = vec3_length(went);
    p->position = vec3_add_scaled(p->position, far > most ? -most / far : -1, went);
}

// Every particle bounces for itself, if it strikes fast: it came by `came` (m)
// in this substep, and goes back by a share of that in the next.
static bool bounce_off(const soft_frame *f, particle *p, vec3 normal, real came,
                       real restitution)
{
    real g = vec3_length(f->gravity);
    if (!(restitution > 0)) return false;
    if (!(came > f->h * material_slowest(g, f->h))) return false;
    real goes = vec3_dot(vec3_sub(p->position, p->previous), normal);
    p->previous = vec3_add_scaled(p->previous, goes - restitution * came,
                                  normal);
    return true;
}

// m, how far the strands will press it into what it touched in the last substep.
static real pressed_into(const line_hold *hold, vec3 normal)
{
    return real_max(-vec3_dot(hold->pull, normal), 0);
}

// Two things are one, as tiles side by side are, if the normal of the one leans
// rather along the other's than along its surface.
static bool is_one_side(vec3 a, vec3 b)
{
    return vec3_length(along_side(a, b)) < vec3_dot(a, b);
}

// A particle leaves what does not move by the shortest way.  Its diagonals may have
// lifted it off; if the strands will press it on, it goes back, or it would be free in
// every second substep.  The strands will find it heavy.  By what they will move it
// too little along the surface for that, it is moved in advance.
static bool touch_fixed(const soft_frame *f, int i, surface_point at,
                        real apart, material m)
{
    particle *p = &f->particle[i];
    line_hold *hold = &f->hold[i];
    real depth = apart - vec3_dot(vec3_sub(p->position, at.at), at.normal);
    real reach = depth + pressed_into(hold, at.normal);
    if (!(reach > 0) || !(depth < HUGE_VAL)) return false;
    if (p->inverse_mass == 0) return true;
    real came = vec3_dot(vec3_sub(p->previous, p->position), at.normal);
    note_old(f, f->owner[i], depth - came, apart);
    // The load stops what came, and bears what presses: the strands, which have
    // drawn a share of that already, or a body, which has pushed it as deep.
    real load = real_max(came - vec3_dot(hold->pull, at.normal),
                         depth + (1 - GIVE_SHARE) * pressed_into(hold, at.normal));
    p->position = vec3_add_scaled(p->position, depth, at.normal);
    bool is_held = hold->state >= LINE_TOUCHES;
    if (is_held && is_one_side(at.normal, hold->normal)) return true;
    hold->normal = at.normal;
    hold->state = is_held ? LINE_CORNERED : LINE_TOUCHES;
    if (!is_held)
        p->position = vec3_add_scaled(p->position, 1 - GIVE_SHARE,
                                      along_side(hold->pull, at.normal));
    slide_particle(p, hold, m.friction * real_max(load, 0));
    if (bounce_off(f, p, at.normal, came, m.restitution))
        hold->state = LINE_FREE;
    return true;
}
//<

//> touch-bodies
//>   With restitution every particle bounces for itself. A sheet that lands
//>   flat is a thousand impacts; the strands share them out in the same
//>   substep.
// Whatever answers at that point: *p.
static bool push_off(const soft_touch *x, particle *p)
{
    if (!body_is_static(&x->f->body[x->b])) {
        part_from_moving(x, p);
        return true;
    }
    real was = vec3_dot(vec3_sub(p->previous, x->at.at), x->at.normal);
    note_old(x->f, (int)(x->soft - x->f->body), x->apart - was, x->apart);
    return surface_separate(p, x->at.at, x->at.normal, x->apart,
                            x->friction) > 0;
}

static bool part_from(const soft_touch *x, answering who)
{
    particle before = who == BY_WHOLE ? whole_cloth(x) : stand_in(x);
    particle after = before;
    if (!push_off(x, &after)) return false;
    if (who == BY_WHOLE) distribute_to_all(x, &before, &after);
    else                 distribute_push(x, &before, &after);
    return true;
}

// Over a face and nowhere near its rim, when it was listed, a particle is over
// it while the lists are good.
static bool nearest_outside(const obstacle *b, vec3 x, const point_pair *pair,
                            real reach, surface_point *at)
{
    if (!pair->over) return obstacle_nearest(b, x, pair->ahead, reach, at);
    plane face = b->plane[pair->ahead];
    real up = plane_height(face, x);
    if (!(up > 0)) return obstacle_nearest(b, x, pair->ahead, reach, at);
    *at = (surface_point){ vec3_add_scaled(x, -up, face.normal), face.normal };
    return up <= reach;
}

static bool touch_body(const rigid_view *v, const soft_frame *f,
                       point_pair pair, real apart, material m)
{
    particle *p = &f->particle[pair.particle];
    surface_point at;
    const body *rigid = &f->body[pair.rigid];
    real reach = apart;
    if (body_is_fixed(rigid)) reach += vec3_length(f->hold[pair.particle].pull);
    if (!nearest_outside(&v->hull, p->position, &pair, reach, &at)) return false;
    if (body_is_fixed(rigid)) return touch_fixed(f, pair.particle, at, apart, m);
    soft_touch x = { f, v, &f->body[pair.soft], body_whole(rigid, pair.rigid), 1,
                { pair.particle }, { 1 }, at, apart, m.friction, false };
    if (!(held_against(&x, pair.particle) > 0))
        f->hold[pair.particle].state = LINE_MEETS;
    return part_from(&x, BY_PARTICLE);
}

// They push one after the other: the first tilt a body that lies on them, the
// last set it upright again, and friction takes the tilting for sliding.  So
// they come in the other order in every other substep, or the body would creep.
int touch_bodies(const near_lists *l, rigid_view *v, const soft_frame *f,
                 bool is_backward)
{
    int touching = 0, n = l->points;
    point_pair last = { .soft = -1 };
    real apart = 0;
    material m = { 0 };
    for (int k = 0; k < n; k++) {
        point_pair pair = l->point[is_backward ? n - 1 - k : k];
        if (pair.soft != last.soft || pair.rigid != last.rigid) {
            rigid_view_update(v, f, pair.rigid);
            apart = soft_gap(&f->body[pair.soft], &f->body[pair.rigid]);
            m = soft_material(f, pair.soft, pair.rigid);
        }
        last = pair;
        touching += touch_body(v, f, pair, apart, m);
    }
    return touching;
}
//<

//> touch-facets
// A plane of the body's frame in the world, and back.
static plane plane_out(const rigid_frame *r, plane p)
{
    vec3 n = vec3_sub(frame_point(r, p.normal), r->center);
    return (plane){ n, p.offset + vec3_dot(n, r->center) };
}

static plane plane_in(const rigid_frame *r, plane p)
{
    const vec3 *e = r->axis;
    vec3 n = { vec3_dot(p.normal, e[0]) / vec3_length_squared(e[0]),
               vec3_dot(p.normal, e[1]) / vec3_length_squared(e[1]),
               vec3_dot(p.normal, e[2]) / vec3_length_squared(e[2]) };
    return (plane){ n, p.offset - vec3_dot(p.normal, r->center) };
}

// A facet beside a rigid body that stands as the frame says.
typedef struct {
    int  number[FACET]; // of its corners, in the pool
    vec3 end[FACET];    // m, where they are
    plane between;
    rigid_frame frame;
} facet_view;

// For how many substeps is a facet clear that has so much room in front of the
// plane?  At twice the speed at which a corner comes nearer, with what gravity
// adds.  Speeds may change by more; but if the facet should cut the body then,
// the plane remembers its side.
static int substeps_clear(const soft_frame *f, const facet_view *x, int b,
                          real room)
{
    bool is_static = body_is_fixed(&f->body[b]);
    b = body_whole(&f->body[b], b);
    const motion_basis *basis = &f->now[b].basis;
    real pace = 0;
    for (int k = 0; k < FACET; k++) {
        vec3 arm = vec3_sub(x->end[k], x->frame.center);
        vec3 went = vec3_sub(x->end[k], f->particle[x->number[k]].previous);
        if (!is_static)
            went = vec3_add_scaled(went, -f->h, motion_at(basis,
                                                    &f->velocity[b], arm));
        real up = vec3_dot(went, x->between.normal);
        pace = real_max(pace, -2 * up);
    }
    pace += TRUST_MOST * f->h * f->h * vec3_length(f->gravity);
    real n = room / pace;
    return n >= TRUST_MOST ? TRUST_MOST : n > 0 ? (int)n : 0;
}

// They are nearest there: so they are parted.
static bool part_facet(const rigid_view *v, const soft_frame *f,
                       const facet_pair *pair, const facet_view *seen,
                       const facet_touch *t, real apart, answering who)
{
    soft_touch x = { f, v, &f->body[pair->soft],
                body_whole(&f->body[pair->rigid], pair->rigid), FACET,
                .apart = apart, .is_after = who == BY_WHOLE,
                .friction = soft_material(f, pair->soft,
                                          pair->rigid).friction };
    vec3 here = { 0, 0, 0 };
    for (int k = 0; k < FACET; k++) {
        x.corner[k] = seen->number[k];
        x.weight[k] = t->weight[k];
        here = vec3_add_scaled(here, t->weight[k], seen->end[k]);
    }
    // The point of the surface is so far below that of the facet.
    x.at = t->at;
    x.at.at = vec3_add_scaled(here, -t->gap, t->at.normal);
    return part_from(&x, who);
}

static bool touch_facet(const near_lists *l, rigid_view *v, const soft_frame *f,
                        facet_pair *pair, facet_view *x, answering who)
{
    const body *soft = &f->body[pair->soft];
    real apart = facet_gap(soft, &f->body[pair->rigid]);
    facet_touch t;
    facet_corners(soft, pair->number, x->number);
    for (int k = 0; k < FACET; k++)
        x->end[k] = f->particle[x->number[k]].position;
    x->between = plane_out(&x->frame, pair->between);
    real up = facet_height(x->end, x->between);
    if (!(up > apart)) {
        rigid_view_update(v, f, pair->rigid);
        bool is_near = facet_nearest(&v->hull, x->end, &x->between, apart, &t);
        pair->between = plane_in(&v->frame, x->between);
        if (is_near) return part_facet(v, f, pair, x, &t, apart, who);
        up = t.gap;
    }
    if (who == BY_PARTICLE)
        pair->until = l->substeps
                    + substeps_clear(f, x, pair->rigid, up - apart);
    return false;
}

// Sticks pull facets that were clear.  So after them (BY_WHOLE) all are asked that
// were not clear by far, but none of a body that is on its way out of what it began
// in.
int touch_facets(near_lists *l, rigid_view *v, const soft_frame *f, answering who,
                 bool is_backward)
{
    int n = l->facet.count, of = -1, touching = 0;
    bool is_after = who == BY_WHOLE;
    int trusted = is_after ? TRUST_MOST - 1 : 0;
    facet_view x;
    for (int k = 0; k < n; k++) {
        facet_pair *pair = &l->facet.at[is_backward ? n - 1 - k : k];
        if (pair->until > l->substeps + trusted) continue;
        if (is_after && f->sunk[pair->soft] > SUNK_PERHAPS) continue;
        if (pair->rigid != of) x.frame = soft_rigid_frame(f, pair->rigid);
        bool touches = touch_facet(l, v, f, pair, &x, who);
        of = touches ? -1 : pair->rigid;
        touching += touches;
    }
    return touching;
}
//<

//> touch-clear
//>   Joints ask the same two queries whether a cloth is clear of a body
//>   (chapter 17, *Pins*).
static int soft_facets(const body *soft)
{
    const shape *s = soft->shape;
    return s->mesh.faces > 0 ? s->mesh.faces : s->sticks;
}

static void facet_ends(const soft_frame *f, const body *soft, int k,
                       vec3 end[FACET])
{
    int number[FACET];
    facet_corners(soft, k, number);
    for (int i = 0; i < FACET; i++) end[i] = f->particle[number[i]].position;
}

bool touch_is_clear(rigid_view *v, const soft_frame *f, int a, int b)
{
    const body *soft = &f->body[a], *rigid = &f->body[b];
    real apart = soft_gap(soft, rigid);
    surface_point at;
    rigid_view_update(v, f, b);
    for (int i = soft->first; i < soft->first + body_particles(soft); i++)
        if (obstacle_nearest(&v->hull, f->particle[i].position, 0, apart, &at))
            return false;
    for (int k = 0; k < soft_facets(soft); k++) {
        vec3 end[FACET];
        plane between = { { 0, 0, 0 }, 0 };
        facet_touch t;
        facet_ends(f, soft, k, end);
        if (facet_nearest(&v->hull, end, &between, facet_gap(soft, rigid), &t))
            return false;
    }
    return true;
}
//<

//> touch-particles
//>   Planes and pairs of particles need only a loop. A rope that is nailed is as
//>   fixed as a plane, and holds what lies on its links as one does.
static bool touch_plane(const soft_frame *f, int i, plane wall, real apart,
                        material m)
{
    vec3 x = f->particle[i].position;
    real up = plane_height(wall, x);
    // Most are far above it.  What is no number is not, and is asked.
    if (up > apart + pressed_into(&f->hold[i], wall.normal)) return false;
    vec3 foot = vec3_add_scaled(x, -up, wall.normal);
    return touch_fixed(f, i, (surface_point){ foot, wall.normal }, apart, m);
}

int touch_planes(const soft_frame *f)
{
    int touching = 0;
    for (int n = 0; n < f->softs && f->planes > 0; n++) {
        int b = f->soft[n];
        const body *soft = &f->body[b];
        if (!soft_moves(f, b)) continue;
        for (int i = soft->first; i < soft->first + soft->shape->particles; i++)
            for (int k = 0; k < f->planes; k++)
                touching += touch_plane(f, i, f->plane[k], soft->thickness,
                                        soft_material(f, b, -1 - k));
    }
    return touching;
}

// The point of a nailed rope's links at particle `nailed` that is nearest to x.
static vec3 nailed_point(const soft_frame *f, int nailed, vec3 x)
{
    const body *b = &f->body[f->owner[nailed]];
    vec3 at = f->particle[nailed].position, nearest = at;
    for (int next = nailed - 1; next <= nailed + 1; next += 2) {
        bool is_link = b->shape->rows == 1 && next >= b->first
                    && next < b->first + body_particles(b);
        if (!is_link || f->particle[next].inverse_mass != 0) continue;
        vec3 link = vec3_sub(f->particle[next].position, at);
        real part = vec3_dot(vec3_sub(x, at), link) / vec3_length_squared(link);
        if (part > 0) nearest = vec3_add_scaled(at, real_min(part, 1), link);
    }
    return nearest;
}

// A particle that is nailed is a thing that does not move, and holds as one.
static bool touch_nailed(const soft_frame *f, int i, int nailed, real apart,
                         material m)
{
    vec3 x = f->particle[i].position, at = nailed_point(f, nailed, x);
    vec3 normal = vec3_unit(vec3_sub(x, at));
    return touch_fixed(f, i, (surface_point){ at, normal }, apart, m);
}

// Two particles of a body that touch are pushed along arms that are not one, and do not
// spin.  The angular momentum that this takes from them their body gets back when its
// strands are solved.
static void owe_angular(const soft_frame *f, particle_contact c, vec3 was)
{
    const particle *a = &f->particle[c.a], *b = &f->particle[c.b];
    vec3 *owed = &f->owed[f->owner[c.a]];
    if (f->owner[c.a] != f->owner[c.b] || !(a->inverse_mass > 0)) return;
    vec3 push = vec3_scale(1 / a->inverse_mass, vec3_sub(a->position, was));
    *owed = vec3_add(*owed, vec3_cross(push, vec3_sub(a->previous, b->previous)));
}

real touch_part(const soft_frame *f, particle_contact c, real friction)
{
    if (!particle_contact_overlaps(&c, f->particle)) return 0;
    vec3 was = f->particle[c.a].position;
    real depth = particle_contact_separate(c, f->particle, friction);
    if (depth > 0) owe_angular(f, c, was);
    return depth;
}

// When all are parted, friction takes back how far two slid past each other, and how
// far their strands will draw them, as they did before.  One pair after the other
// it would take for sliding what the next push takes back.  Two that began too near
// are still on their way out: strands that are caught in each other draw without end.
static void brake_pairs(const near_lists *l, const soft_frame *f, int pressed)
{
    for (int k = 0; k < pressed; k++) {
        particle_contact c = l->pair[l->pressed[k].pair];
        line_hold *a = &f->hold[c.a], *b = &f->hold[c.b];
        int one = f->owner[c.a], other = f->owner[c.b];
        bool is_apart = one == other || real_min(l->gap[one], l->gap[other]) >= 1;
        vec3 drawn = { 0, 0, 0 };
        if (is_apart) drawn = vec3_sub(hold_drawn(a), hold_drawn(b));
        vec3 was = f->particle[c.a].position;
        particle_contact_brake(c, f->particle, drawn,
                               soft_material(f, one, other).friction
                               * l->pressed[k].depth);
        owe_angular(f, c, was);
        if (a->state == LINE_FREE) a->state = LINE_MEETS;
        if (b->state == LINE_FREE) b->state = LINE_MEETS;
    }
}

int touch_pairs(const near_lists *l, const soft_frame *f, real *deepest)
{
    int touching = 0, pressed = 0;
    for (int k = 0; k < l->pairs; k++) {
        particle_contact c = l->pair[k];
        int a = f->owner[c.a], b = f->owner[c.b];
        if (a != b) c.distance *= real_min(l->gap[a], l->gap[b]);
        bool a_is_nailed = f->particle[c.a].inverse_mass == 0;
        bool b_is_nailed = f->particle[c.b].inverse_mass == 0;
        if (a != b && a_is_nailed != b_is_nailed) {
            touching += touch_nailed(f, a_is_nailed ? c.b : c.a,
                                     a_is_nailed ? c.a : c.b, c.distance,
                                     soft_material(f, a, b));
            continue;
        }
        real depth = touch_part(f, c, 0);
        if (!(depth > 0)) continue;
        l->pressed[pressed++] = (pressed_pair){ k, depth };
        if (depth > *deepest * c.distance) *deepest = depth / c.distance;
    }
    brake_pairs(l, f, pressed);
    return touching + pressed;
}
//<
