//> soft-substep
#include "soft.h"
#include "ledger.h"

#include <assert.h>
#include <stddef.h>

static void integrate(world *w, real h);
static void relax(world *w);

void soft_substep(world *w, real h)
{
    integrate(w, h);
    ledger_book(w, LEDGER_INTEGRATE);
    soft_refresh(w, h);
    soft_separate(w, h);
    ledger_book(w, LEDGER_CONTACTS);
    relax(w);
    ledger_book(w, LEDGER_STICKS);
    soft_hold(w, h);
    ledger_book(w, LEDGER_CONTACTS);
}

static bool is_moving_soft(const world *w, int b)
{
    return body_is_soft(&w->body[b]) && body_moves(w, b);
}
//<

//> soft-integrate
// Taylor about x, forward by dt and backward by dt_before:
//     x'         = x + v dt        + a dt^2 / 2
//     x_previous = x - v dt_before + a dt_before^2 / 2
// The second gives
//     v dt = ((x - x_previous) + a dt_before^2 / 2) dt / dt_before,
// and put into the first,
//     x' = x + (x - x_previous) dt / dt_before + a dt (dt_before + dt) / 2.
static void verlet_step_changed(particle *p, int n, vec3 a, real dt_before,
                                real dt)
{
    assert(n >= 0 && dt_before > 0 && dt > 0);
    real carry = dt / dt_before, square = dt * (dt_before + dt) / 2;
    for (int i = 0; i < n; i++) {
        vec3 here = p[i].position, move = { 0, 0, 0 };
        if (p[i].inverse_mass > 0) {
            vec3 last_move = vec3_sub(here, p[i].previous);
            move = vec3_add_scaled(vec3_scale(carry, last_move), square, a);
        }
        p[i].position = vec3_add(here, move);
        p[i].previous = here;
    }
}

// The first substep of a frame may be longer or shorter than the last one.
static void integrate(world *w, real h)
{
    vec3 g = w->options.gravity;
    for (int b = 0; b < w->bodies; b++) {
        particle *p = w->pool.at + w->body[b].first;
        int n = body_particles(&w->body[b]);
        if (!is_moving_soft(w, b)) continue;
        if (w->age == h) verlet_step(p, n, g, NULL, h);
        else             verlet_step_changed(p, n, g, w->age, h);
    }
    // The lists counted on the pace that was.
    if (w->age != h && w->soft.trusted > 0) w->soft.trusted = 0;
    w->age = h;
}
//<

//> soft-relax
static line_scratch *scratch_of(const world *w, const shape *s)
{
    int k = 0;
    while (w->shape[k].shape != s) k++;
    return w->shape[k].line;
}

// Soft diagonals first, then the strands that must hold.
static void relax_body(world *w, const body *b)
{
    const shape *s = b->shape;
    particle *p = w->pool.at + b->first;
    relax_options o = w->options.relax;
    int links = shape_links(s), others = s->sticks - links;
    if (others > 0) sticks_iterate(s->stick + links, others, p, o);
    line_result l = lines_relax(s, p, w->options.iterations, o,
                                scratch_of(w, s));
    w->report.tested += others + l.steps * links;
    w->report.relaxed += others + l.steps * links;
    w->report.fell_back += l.fell_back;
}

static void relax(world *w)
{
    for (int b = 0; b < w->bodies; b++)
        if (is_moving_soft(w, b)) relax_body(w, &w->body[b]);
}
//<

//> soft-stretched
// A NaN is no strain of at most a hundredth.
static bool is_stretched(const shape *s, const particle *p)
{
    for (int k = 0; k < shape_links(s); k++)
        if (!(stick_strain(s->stick[k], p) <= 0.01)) return true;
    return false;
}

int soft_stretched(const world *w)
{
    int n = 0;
    for (int b = 0; b < w->bodies; b++)
        if (is_moving_soft(w, b))
            n += is_stretched(w->body[b].shape, w->pool.at + w->body[b].first);
    return n;
}
//<

//> soft-begin
// Its particles' middle goes straight on; beside that each goes as far as the
// fastest, and as gravity adds, and a hundredth of the radius for impacts.
static prediction predict(const world *w, int b)
{
    const body *x = &w->body[b];
    const particle *p = w->pool.at + x->first;
    int n = x->shape->particles;
    real dt = w->frame, ages = dt / w->age, fastest = 0;
    vec3 mean = { 0, 0, 0 };
    if (!body_moves(w, b)) return (prediction){ .reach = 0 };
    for (int i = 0; i < n; i++)
        mean = vec3_add_scaled(mean, 1.0 / n,
                               vec3_sub(p[i].position, p[i].previous));
    for (int i = 0; i < n; i++) {
        vec3 move = vec3_sub(p[i].position, p[i].previous);
        real beside = vec3_length_squared(vec3_sub(move, mean));
        fastest = real_max(beside, fastest);
    }
    prediction a = { .way = vec3_scale(ages, mean) };
    a.turn = ages * sqrt(fastest) + x->shape->radius / 100
           + vec3_length(w->options.gravity) * dt * dt / 2;
    a.reach = vec3_length(a.way) + a.turn;
    return a;
}

// Copies where the particles of a deformable body are, for tree and grid.
static void look_at_soft(world *w, int b)
{
    const body *x = &w->body[b];
    for (int i = x->first; i < x->first + x->shape->particles; i++)
        w->soft.at[i] = w->pool.at[i].position;
}

static void look_at_body(world *w, int b)
{
    body *x = &w->body[b];
    soft_tables *t = &w->soft;
    if (!body_is_soft(x)) {
        t->ball[b] = w->rigid.ball[b];
        t->ahead[b] = w->rigid.ahead[b];
        return;
    }
    look_at_soft(w, b);
    sphere_tree_refresh(&x->tree, t->at + x->first);
    t->ball[b] = sphere_tree_root(&x->tree, t->at + x->first);
    t->ahead[b] = predict(w, b);
}

static bool balls_meet(sphere a, sphere b, real margin)
{
    return vec3_distance(a.center, b.center) <= a.radius + b.radius + margin;
}

// Twice the margin of the lists is room for what this frame will bring.
bool soft_begin(world *w)
{
    const soft_tables *t = &w->soft;
    bool woke = false;
    for (int b = 0; b < w->bodies; b++) look_at_body(w, b);
    for (int a = 0; a < w->bodies; a++) {
        if (!body_is_soft(&w->body[a]) || body_is_static(&w->body[a])) continue;
        for (int b = 0; b < w->bodies; b++) {
            if (b == a || body_is_static(&w->body[b])) continue;
            if (!balls_meet(t->ball[a], t->ball[b], 2 * t->margin)) continue;
            woke |= world_wake_near(w, a, b);
            sleep_touch(&w->sleep, a, b);
        }
    }
    return woke;
}
//<

//> soft-substeps
// In a substep nothing should go further than a share of its own radius: the
// inner one of a rigid body, half the spacing of a deformable one.  One whose
// numbers are lost asks for nothing.
static int substeps_for(const world *w, int b, real far, real share)
{
    const body *x = &w->body[b];
    real radius = body_is_soft(x) ? x->shape->spacing / 2 : x->inner;
    real need = far / (share * radius);
    if (!(need < HUGE_VAL)) return 0;
    if (!(need < w->options.most_substeps)) return w->options.most_substeps;
    return (int)need + ((int)need < need);
}

// What a deformable body may meet: itself, where its parts go different ways;
// and others.  A rigid body drives the light particles of a cloth before it,
// their sticks pull them back, and it must not be past them before their whole
// weight has stopped it: a quarter of its radius.
static int substeps_to_meet(const world *w, int a, int b)
{
    const prediction *x = &w->soft.ahead[a], *y = &w->soft.ahead[b];
    if (a == b) return substeps_for(w, a, x->turn, 1);
    if (!balls_meet(w->soft.ball[a], w->soft.ball[b], x->reach + y->reach))
        return 0;
    int n = substeps_for(w, a, x->reach, 1);
    if (body_is_soft(&w->body[b])) return n;
    return int_max(n, substeps_for(w, b, y->reach, 0.25));
}

// The strands of a deformable body count on all of the usual substeps.
int soft_substeps(const world *w)
{
    int n = 0;
    for (int a = 0; a < w->bodies; a++) {
        if (!body_is_soft(&w->body[a])) continue;
        if (body_moves(w, a)) n = int_max(n, w->options.substeps);
        for (int b = 0; b < w->bodies; b++)
            n = int_max(n, substeps_to_meet(w, a, b));
    }
    return n;
}
//<

//> soft-stale
// Where rigid body b stands in the middle of a frame.
static rigid_frame frame_of(const world *w, int b)
{
    const rigid_tables *t = &w->rigid;
    return motion_frame(&t->now[b].frame, &t->now[b].basis, &t->moved[b]);
}

// What the moves of some particles since their listing have in common: they end
// in a box, and none is longer than the longest.
typedef struct {
    vec3 least, most;   // m
    real longest;       // m^2
    real fastest;       // m^2, the longest of the last substep
} moves;

static inline real longer(real a, vec3 d)
{
    real b = vec3_length_squared(d);
    // A NaN enters, and nothing replaces it.
    return b > a || b != b ? b : a;
}

// d: since the listing; u: in the last substep.
static inline void add_move(moves *m, vec3 d, vec3 u)
{
    m->least = (vec3){ d.x < m->least.x ? d.x : m->least.x,
                       d.y < m->least.y ? d.y : m->least.y,
                       d.z < m->least.z ? d.z : m->least.z };
    m->most = (vec3){ d.x > m->most.x ? d.x : m->most.x,
                      d.y > m->most.y ? d.y : m->most.y,
                      d.z > m->most.z ? d.z : m->most.z };
    m->longest = longer(m->longest, d);
    m->fastest = longer(m->fastest, u);
}

static void add_soft_moves(moves *to, const world *w, const body *b)
{
    moves m = *to;
    for (int i = b->first; i < b->first + b->shape->particles; i++) {
        const particle *p = &w->pool.at[i];
        add_move(&m, vec3_sub(p->position, w->soft.listed[i]),
                 vec3_sub(p->position, p->previous));
    }
    *to = m;
}

// The vertices of a rigid body may be up to twice as far out as its four
// particles are.
static void add_rigid_moves(moves *m, const world *w, int b, real h)
{
    rigid_frame frame = frame_of(w, b);
    for (int k = 0; k < FOUR; k++) {
        vec3 arm = frame_arm(&frame, k), at = vec3_add(frame.center, arm);
        vec3 d = vec3_sub(at, w->soft.listed[w->body[b].first + k]);
        vec3 u = motion_at(&w->rigid.now[b].basis, &w->rigid.velocity[b], arm);
        add_move(m, vec3_scale(2, d), vec3_scale(2 * h, u));
    }
}

// Two whose moves differ by the margin may have closed it.  Before that the
// lists are good; and for as many substeps more as it would take if any two
// went against each other, at twice the speed of the fastest, but at most 8,
// for speeds change.
enum { TRUST_MOST = 8 };

static bool lists_are_good(world *w, real h)
{
    soft_tables *t = &w->soft;
    if (t->trusted < 0) return false;
    if (t->trusted > 0) {
        t->trusted--;
        return true;
    }
    // What stands still has moved by nothing, and that is in the box, too.
    moves m = { .longest = 0 };
    for (int b = 0; b < w->bodies; b++) {
        if (!body_moves(w, b)) continue;
        if (body_is_soft(&w->body[b])) add_soft_moves(&m, w, &w->body[b]);
        else                           add_rigid_moves(&m, w, b, h);
    }
    real apart = vec3_distance(m.least, m.most), both = 2 * sqrt(m.longest);
    real left = t->margin - (apart < both ? apart : both);
    real pace = 4 * sqrt(m.fastest);
    if (!(left > 0)) return false;
    t->trusted = left >= TRUST_MOST * pace ? TRUST_MOST
               : left > pace ? (int)(left / pace) : 0;
    return true;
}
//<

//> soft-near
// The pairs of a traversal that found room; the others are counted.
static int room_for(world *w, int found, int room)
{
    if (found <= room) return found;
    w->report.dropped += found - room;
    return room;
}

// Leaves are single particles, in the order of the body's.
static void add_near(world *w, const body *a, const body *b, tree_result found)
{
    soft_tables *t = &w->soft;
    int pairs = room_for(w, found.pairs, t->leaf_capacity);
    pairs = room_for(w, pairs, t->pair_capacity - t->pairs);
    for (int k = 0; k < pairs; k++)
        t->pair[t->pairs++] = (particle_contact){
            a->first + t->leaf[k].a, b->first + t->leaf[k].b,
            a->thickness + b->thickness };
}

// The ends of a link do not collide, the stick holds them apart: in a square
// grid they stand at 0.91 diameters.  Those of a cell's diagonals, at 1.29, do:
// only one of the two has a stick, which is soft, and a crease can shear the
// cell until the ends of the other meet, and the triangles around them cross.
static const real LINKED = 1.2;

// A body against itself: equal balls, which a grid sorts fastest.  Where one is
// thrown far out of the others, the tree is asked.
static void list_self(world *w, body *a)
{
    soft_tables *t = &w->soft;
    const vec3 *at = t->at + a->first;
    real touching = 2 * a->thickness;
    int found = grid_pairs(&t->grid, at, a->shape->particles,
                           touching + t->margin, a->shape->at,
                           LINKED * touching, t->leaf, t->leaf_capacity);
    if (found < 0) {
        sphere_tree_refresh(&a->tree, at);
        add_near(w, a, a, sphere_tree_self(&a->tree, at, t->margin, LINKED,
                                           t->leaf, t->leaf_capacity));
    } else {
        add_near(w, a, a, (tree_result){ .pairs = found });
    }
}

static void list_soft_pair(world *w, body *a, body *b)
{
    soft_tables *t = &w->soft;
    add_near(w, a, b, sphere_tree_pairs(&a->tree, t->at + a->first,
                                        &b->tree, t->at + b->first,
                                        t->margin, t->leaf, t->leaf_capacity));
}
//<

//> soft-points
// Looks where the vertices and planes of rigid body b are now.
static void look_at_hull(world *w, int b)
{
    soft_tables *t = &w->soft;
    const body *rigid = &w->body[b];
    const shape *s = rigid->shape;
    if (t->hull_of == b && body_is_static(rigid)) return;
    rigid_frame frame = frame_of(w, b);
    rigid4_ride(rigid->rigid, &frame, t->corner, s->particles);
    t->hull = (obstacle){ { t->corner, s->particles }, t->plane,
                          hull_planes(s, t->corner, t->plane), s->radius };
    t->moved = w->rigid.moved[b];
    t->hull_of = b;
}

// Between two particles on both sides of a right-angled edge, at the distance r
// of it, a triangle's side cuts the corner: one as long as 2.83 r touches it.
// The longest, the diagonal of a cell, would do with half a spacing, and we
// have 0.55.  But the sticks come last, and pull them nearer: so a quarter
// more, of what is static.  What is not makes way.
static const real SPARE = 1.25;

real soft_gap(const body *soft, const body *rigid)
{
    return body_is_static(rigid) ? SPARE * soft->thickness : soft->thickness;
}

// The particles of a that are near the rigid body b: inside its ball, or not
// far outside, and not far in front of any of its planes.
static void list_points(world *w, int a, int b)
{
    soft_tables *t = &w->soft;
    const body *soft = &w->body[a];
    real reach = soft_gap(soft, &w->body[b]) + t->margin;
    real far = w->rigid.now[b].radius + reach;
    vec3 center = frame_of(w, b).center;
    bool is_ready = false;
    for (int i = soft->first; i < soft->first + soft->shape->particles; i++) {
        vec3 x = t->at[i];
        if (vec3_length_squared(vec3_sub(x, center)) > far * far) continue;
        if (!is_ready) look_at_hull(w, b);
        is_ready = true;
        int ahead = hull_ahead(x, t->plane, t->hull.planes);
        if (plane_height(t->plane[ahead], x) > reach) continue;
        if (room_for(w, 1, t->point_capacity - t->points) == 1)
            t->point[t->points++] = (point_pair){ i, a, b, ahead };
    }
}
//<

//> soft-refresh
static void list_pair(world *w, int a, int b)
{
    body *x = &w->body[a], *y = &w->body[b];
    if (!body_moves(w, a) && !body_moves(w, b)) return;
    if (body_is_soft(x) && body_is_soft(y)) list_soft_pair(w, x, y);
    else if (body_is_soft(x))               list_points(w, a, b);
    else if (body_is_soft(y))               list_points(w, b, a);
}

// A grid needs no tree; another body does.
static void note_places(world *w, int b)
{
    soft_tables *t = &w->soft;
    body *x = &w->body[b];
    if (!body_is_soft(x)) {
        rigid_frame frame = frame_of(w, b);
        for (int k = 0; k < FOUR; k++)
            t->listed[x->first + k] = vec3_add(frame.center,
                                               frame_arm(&frame, k));
        return;
    }
    look_at_soft(w, b);
    if (w->softs > 1) sphere_tree_refresh(&x->tree, t->at + x->first);
    for (int i = x->first; i < x->first + x->shape->particles; i++)
        t->listed[i] = t->at[i];
}

void soft_refresh(world *w, real h)
{
    if (lists_are_good(w, h)) return;
    w->soft.pairs = w->soft.points = w->soft.trusted = 0;
    w->report.rebuilt++;
    for (int b = 0; b < w->bodies; b++) note_places(w, b);
    for (int a = 0; a < w->bodies; a++) {
        if (is_moving_soft(w, a)) list_self(w, &w->body[a]);
        for (int b = a + 1; b < w->bodies; b++) list_pair(w, a, b);
    }
}
//<

//> soft-push
// A particle that touches a rigid body.
typedef struct {
    vec3 normal;        // unit, out of the body
    vec3 arm;           // m, of the point touched, from the body's centre
    real overlap;       // m, now
    vec3 slide;         // m, how far the particle passed that point in the
                        // substep
} touch_point;

static touch_point touch_of(const world *w, const particle *p, int b,
                            const surface_point *s, real apart, real h)
{
    const rigid_tables *r = &w->rigid;
    const motion_basis *basis = &r->now[b].basis;
    motion since = r->moved[b];
    for (int i = 0; i < MOTIONS; i++) since.of[i] -= w->soft.moved.of[i];
    vec3 go = { w->soft.moved.of[0], w->soft.moved.of[1],
                w->soft.moved.of[2] };
    touch_point t = { .normal = s->normal };
    t.arm = vec3_sub(s->at, vec3_add(r->now[b].frame.center, go));
    vec3 at = vec3_add(s->at, motion_at(basis, &since, t.arm));
    vec3 way = vec3_scale(h, motion_at(basis, &r->velocity[b], t.arm));
    t.overlap = apart - vec3_dot(vec3_sub(p->position, at), t.normal);
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
static void correct(world *w, particle *p, int b, const touch_point *t,
                    vec3 push)
{
    p->position = vec3_add_scaled(p->position, p->inverse_mass, push);
    p->previous = vec3_add_scaled(p->previous, p->inverse_mass, push);
    motion_push(&w->rigid.moved[b], &w->rigid.now[b].basis, t->arm,
                vec3_scale(-1, push));
}

// A push of 1 kg m in a substep of h is an impulse of 1 / h.
static void push(world *w, particle *p, int b, const touch_point *t, vec3 push,
                 real h)
{
    const motion_basis *basis = &w->rigid.now[b].basis;
    p->position = vec3_add_scaled(p->position, p->inverse_mass, push);
    motion_push(&w->rigid.moved[b], basis, t->arm, vec3_scale(-1, push));
    motion_push(&w->rigid.velocity[b], basis, t->arm,
                vec3_scale(-1 / h, push));
}

static void push_apart(world *w, particle *p, int b, const surface_point *s,
                       real apart, real h)
{
    const motion_basis *basis = &w->rigid.now[b].basis;
    touch_point t = touch_of(w, p, b, s, apart, h);
    real give = answer(basis, p, t.arm, t.normal);
    if (!(t.overlap > 0) || !(give > 0)) return;
    real old = t.overlap + vec3_dot(t.slide, t.normal);
    old = real_min(real_max(old, 0), t.overlap);
    correct(w, p, b, &t, vec3_scale(old / give, t.normal));
    real load = (t.overlap - old) / give;
    push(w, p, b, &t, vec3_scale(load, t.normal), h);

    // Coulomb: at most so much of the load as takes the sliding back.
    vec3 slide = touch_of(w, p, b, s, apart, h).slide;
    slide = vec3_add_scaled(slide, -vec3_dot(slide, t.normal), t.normal);
    real length = vec3_length(slide);
    if (!(length > 0)) return;
    vec3 across = vec3_scale(1 / length, slide);
    real brake = real_min(w->options.friction * load,
                          length / answer(basis, p, t.arm, across));
    push(w, p, b, &t, vec3_scale(-brake, across), h);
}
//<

//> soft-whole
// A particle at x that weighs what the cloth weighs, and moves as its centre
// of mass does; pinned, if any of it is.
static particle whole_cloth(const world *w, const body *soft, vec3 x)
{
    particle whole = { .position = x, .previous = x };
    vec3 sum = { 0, 0, 0 };
    for (int i = soft->first; i < soft->first + soft->shape->particles; i++) {
        const particle *p = &w->pool.at[i];
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
static void push_whole(world *w, point_pair pair, const surface_point *s,
                       real apart, real h)
{
    const body *soft = &w->body[pair.soft];
    vec3 x = w->pool.at[pair.particle].position;
    particle before = whole_cloth(w, soft, x), after = before;
    push_apart(w, &after, pair.rigid, s, apart, h);
    if (before.inverse_mass == 0) return;
    vec3 now = vec3_sub(after.position, before.position);
    vec3 then = vec3_sub(after.previous, before.previous);
    for (int i = soft->first; i < soft->first + soft->shape->particles; i++) {
        particle *p = &w->pool.at[i];
        p->position = vec3_add(p->position, now);
        p->previous = vec3_add(p->previous, then);
    }
}
//<

//> soft-separate-all
// Who answers a rigid body's push: a particle, or all that it hangs on?
typedef enum { PARTICLE, WHOLE } answering;

static bool separate_point(world *w, point_pair pair, real apart,
                           answering who, real h)
{
    particle *p = &w->pool.at[pair.particle];
    surface_point s;
    if (!obstacle_nearest(&w->soft.hull, p->position, pair.ahead, apart, &s))
        return false;
    if (body_is_static(&w->body[pair.rigid]))
        return surface_separate(p, s.at, s.normal, apart,
                                w->options.friction) > 0;
    if (who == PARTICLE) push_apart(w, p, pair.rigid, &s, apart, h);
    else                 push_whole(w, pair, &s, apart, h);
    return true;
}

// All points, to this share of what keeps them apart.  Those of the same two
// bodies stand together in the list.  They push one after the other: the first
// tilt a body that lies on them, the last set it upright again, and friction
// takes the tilting for sliding.  So they come in the other order in every
// other substep, or the body would creep.  Returns how many touched.
static int separate_points(world *w, real share, answering who, real h)
{
    int touching = 0, n = w->soft.points;
    point_pair last = { .soft = -1 };
    real apart = 0;
    for (int k = 0; k < n; k++) {
        point_pair pair = w->soft.point[w->soft.is_backward ? n - 1 - k : k];
        if (pair.soft != last.soft || pair.rigid != last.rigid) {
            look_at_hull(w, pair.rigid);
            apart = share * soft_gap(&w->body[pair.soft],
                                     &w->body[pair.rigid]);
        }
        last = pair;
        touching += separate_point(w, pair, apart, who, h);
    }
    return touching;
}
//<

//> soft-separate
static int separate_plane(const world *w, particle *p, plane wall, real apart)
{
    real up = plane_height(wall, p->position);
    vec3 foot = vec3_add_scaled(p->position, -up, wall.normal);
    return surface_separate(p, foot, wall.normal, apart,
                            w->options.friction) > 0;
}

static int separate_planes(world *w)
{
    int touching = 0;
    for (int b = 0; b < w->bodies && w->planes > 0; b++) {
        const body *soft = &w->body[b];
        if (!is_moving_soft(w, b)) continue;
        for (int i = soft->first; i < soft->first + soft->shape->particles; i++)
            for (int k = 0; k < w->planes; k++)
                touching += separate_plane(w, &w->pool.at[i], w->plane[k],
                                           soft->thickness);
    }
    return touching;
}

void soft_separate(world *w, real h)
{
    int touching = separate_planes(w);
    for (int k = 0; k < w->soft.pairs; k++)
        if (particle_contact_overlaps(&w->soft.pair[k], w->pool.at))
            touching += particle_contact_separate(w->soft.pair[k], w->pool.at,
                                                  w->options.friction) > 0;
    w->soft.is_backward = !w->soft.is_backward;
    touching += separate_points(w, 1, PARTICLE, h);
    w->report.near = w->soft.pairs + w->soft.points;
    w->report.touching = touching;
}

// In a cloth that lies on a static body this finds nothing.  But particles that
// a bullet drives before it are pulled back by their sticks, and through it:
// they are light, and make way.  What stops it is all that the sticks hold
// together.
void soft_hold(world *w, real h)
{
    separate_points(w, 0.5, WHOLE, h);
}
//<
