//> face-ask
//>   Queries of the world walk over all bodies, and leave out by a bounding
//>   sphere what is too far away.
#include "cast.h"
#include "inside.h"
#include "weight.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

// What is asked about: a thing, where it goes, which bodies are asked, and how.
typedef struct question question;
typedef cast_result cast_query(const question *q, rounded b, const plane *p,
                               vec3 *scratch);
struct question {
    rounded thing;
    vec3 delta;         // m
    sphere around;      // the thing, before it goes; of one that turns, about its
    unsigned mask;      // centre of mass
    vec3 turn;          // rad; zero: it does not
    cast_query *ask;    // of b, or of the plane, if p is not NULL
    bool by_distance;   // its answer is a distance (m), not a share of the way
    bool of_soft;       // ropes and cloths are asked, and nothing else
    real most;          // its largest answer
};

// The hull of body b of the engine where it stands; its vertices go to at.
static rounded rounded_body(const tumble_world *w, int b, vec3 *at)
{
    const body *x = &w->world.body[b];
    world_vertices(&w->world, x, at);
    return rounded_shape(x->shape, at);
}

// m^2, how near the way comes to x.
static real path_distance(const question *q, vec3 x)
{
    vec3 d = vec3_sub(x, q->around.center);
    real square = vec3_length_squared(q->delta), along = vec3_dot(d, q->delta);
    real t = square > 0 ? along / square : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return vec3_length_squared(vec3_add_scaled(d, -t, q->delta));
}

// May body b of the engine, a rigid one, be met?
static bool may_be_met(const tumble_world *w, int b, const question *q)
{
    const body *x = &w->world.body[b];
    vec3 center = rigid4_frame(w->world.pool.at + x->first).center;
    real near = q->around.radius + x->rigid->reach;
    // Written so that what is not finite is asked.
    return !(path_distance(q, center) > near * near * (1 + 1e-9));
}

static void take_hit(tumble_hit *best, const cast_result *r, tumble_body b)
{
    if (!r->hits || !(r->fraction < best->fraction)) return;
    *best = (tumble_hit){ b, to_user(r->point), to_user(r->normal),
                          r->fraction, 0 };
}
//<

//> face-ask-turning
//>   What turns is asked as chapter 15 asks it. What is behind a plane is a hull as
//>   any other, as large as the thing may need it.
static rounded behind(const question *q, const plane *p, vec3 at[4])
{
    vec3 n = p->normal, center = q->around.center;
    real height = vec3_dot(center, n) - p->offset;
    real far = 8 * (q->around.radius + vec3_length(q->delta) + fabs(height));
    vec3 other = { fabs(n.x) < 0.5, fabs(n.x) >= 0.5, 0 };
    vec3 x = vec3_scale(far, vec3_unit(vec3_cross(n, other)));
    vec3 y = vec3_cross(n, x), foot = vec3_add_scaled(center, -height, n);
    at[0] = vec3_add(foot, x);
    at[1] = vec3_add(vec3_add_scaled(foot, -0.5, x), y);
    at[2] = vec3_sub(vec3_add_scaled(foot, -0.5, x), y);
    at[3] = vec3_add_scaled(foot, -far, n);
    return (rounded){ { at, 4 }, 0, 0 };
}

// Where it first meets it.
static cast_result query_path(const question *q, rounded b, const plane *p,
                              vec3 *scratch)
{
    const swept_motion m = { q->around.center, q->delta, q->turn,
                             q->around.radius - q->thing.round };
    vec3 at[4];
    if (vec3_length(q->turn) > 0)
        return cast_turning(q->thing, &m, p ? behind(q, p, at) : b, scratch);
    return p ? cast_first_plane(q->thing, q->delta, *p)
             : cast_first(q->thing, q->delta, b, scratch);
}
//<

//> face-ask-near
//>   What is nearest to a point, and what overlaps a shape? These two need one
//>   distance a body.
static cast_result query_near(const question *q, rounded b, const plane *p,
                              vec3 *scratch)
{
    vec3 x = q->around.center;
    (void)scratch;
    return p ? cast_nearest_plane(x, *p, q->most) : cast_nearest(x, b, q->most);
}

static cast_result query_overlap(const question *q, rounded b, const plane *p,
                                 vec3 *scratch)
{
    (void)scratch;
    return (cast_result){ .hits = !p && cast_overlaps(q->thing, b) };
}
//<

//> face-ask-mesh
//>   A surface is asked through its tree. A triangle is met where its prism is,
//>   which is a convex body as any other.
typedef struct {
    const tumble_world *w;
    const surface *surface;
    const question *q;
    tumble_body body;
    tumble_hit *best;
} mesh_question;

// Returns how far there still may be something better; -1: nowhere.
static real query_prism(void *context, int triangle)
{
    mesh_question *m = context;
    vec3 *at = m->w->scratch;
    surface_prism(m->surface, triangle, at);
    cast_result r = m->q->ask(m->q, (rounded){ { at, PRISM_CORNERS }, 0, 0 }, NULL,
                              at + m->w->most_vertices);
    take_hit(m->best, &r, m->body);
    real best = m->best->fraction;
    return best > 0 ? real_min(best, m->q->most) : -1;
}

static void query_mesh(const tumble_world *w, const body_place *x,
                       const question *q, tumble_hit *best)
{
    mesh_question m = { w, &x->mesh->surface, q,
                        inside_owner(w, x->piece[0].number), best };
    vec3 center = q->around.center;
    real r = q->by_distance ? 0 : q->around.radius * (1 + 1e-9);
    surface_query ask = {
        .thing = { vec3_sub(center, (vec3){ r, r, r }),
                   vec3_add(center, (vec3){ r, r, r }) },
        .delta = q->delta, .by_distance = q->by_distance,
        .most = real_min(best->fraction, q->most), .meets = query_prism,
        .context = &m };
    surface_visit(m.surface, &ask);
}
//<

//> face-ask-soft
//>   A rope is asked link by link, a cloth triangle by triangle.
// The vertices of facet k of a rope or cloth: two, or three; returns how many.
static int facet_of(const shape *s, int k, int vertex[3])
{
    bool is_cloth = s->kind == SHAPE_CLOTH;
    for (int i = 0; i < 3; i++) vertex[i] = is_cloth ? s->face[3 * k + i] : k + i;
    return is_cloth ? 3 : 2;
}

static void query_facets(const tumble_world *w, int b, const question *q,
                         tumble_hit *best)
{
    const body *x = &w->world.body[b];
    const particle *p = w->world.pool.at + x->first;
    bool is_cloth = x->shape->kind == SHAPE_CLOTH;
    int facets = is_cloth ? x->shape->mesh.faces : x->shape->particles - 1;
    vec3 at[3], scratch[4];
    for (int k = 0; k < facets; k++) {
        int vertex[3], n = facet_of(x->shape, k, vertex);
        for (int i = 0; i < n; i++) at[i] = p[vertex[i]].position;
        rounded facet = { { at, n }, is_cloth ? 0 : x->thickness, 0 };
        sphere ball = rounded_ball(facet);
        real near = ball.radius + q->around.radius;
        if (path_distance(q, ball.center) > near * near * (1 + 1e-9)) continue;
        cast_result r = q->ask(q, facet, NULL, scratch);
        if (!r.hits || !(r.fraction < best->fraction)) continue;
        take_hit(best, &r, inside_owner(w, b));
        real least = HUGE_VAL;
        for (int i = 0; i < n; i++) {
            real far = vec3_distance(at[i], r.point);
            if (far < least) best->vertex = vertex[i];
            least = real_min(far, least);
        }
    }
}
//<

//> face-ask-first
//>   What does a ray or a moving shape meet first? Of all answers the earliest
//>   counts; of two at the same time, the body that was added first, so that
//>   the answer is always the same.
static void query_body(const tumble_world *w, const body_place *x,
                       const question *q, tumble_hit *best)
{
    const body *all = &w->world.body[x->piece[0].number];
    if (body_is_soft(all) != q->of_soft || !(all->group & q->mask)) return;
    if (q->of_soft) query_facets(w, x->piece[0].number, q, best);
    else if (x->mesh) query_mesh(w, x, q, best);
    else for (int k = 0; k < x->pieces && best->fraction > 0; k++) {
        int b = x->piece[k].number;
        if (!may_be_met(w, b, q)) continue;
        cast_result r = q->ask(q, rounded_body(w, b, w->scratch), NULL,
                               w->scratch + w->most_vertices);
        take_hit(best, &r, inside_owner(w, b));
    }
}

// Asks number k of all that can be met: places of bodies, and behind them those
// of planes.
static void query_place(const tumble_world *w, int k, const question *q,
                        tumble_hit *best)
{
    int wall = k - w->bodies.count;
    const body_place *x = wall < 0 ? slots_at(&w->bodies, k) : NULL;
    if (x) query_body(w, x, q, best);
    if (wall < 0 || !world_has_plane(&w->world, wall) || q->of_soft) return;
    cast_result r = q->ask(q, q->thing, &w->world.plane[wall],
                           w->scratch + w->most_vertices);
    take_hit(best, &r, tumble_body_ground());
}

// So many places there are to be asked; 0: of what is not finite, nothing.
static int askable(const tumble_world *w, const question *q)
{
    bool is_finite = vec3_is_finite(q->delta) && vec3_is_finite(q->around.center);
    return w && is_finite ? w->bodies.count + w->world.planes : 0;
}

static bool first_met(const tumble_world *w, const question *q,
                      tumble_hit *hit)
{
    tumble_hit best = { .fraction = HUGE_VAL };
    for (int k = 0; k < askable(w, q); k++) query_place(w, k, q, &best);
    if (hit && best.fraction < HUGE_VAL) *hit = best;
    return best.fraction < HUGE_VAL;
}

// The question of a ray; *tip is its beginning.
static question along_ray(vec3 *tip, tumble_vec3 from, tumble_vec3 to,
                          unsigned mask)
{
    *tip = from_user(from);
    return (question){ { { tip, 1 }, 0, 0 }, vec3_sub(from_user(to), *tip),
                       { *tip, 0 }, .mask = mask, .ask = query_path, .most = 1 };
}

bool tumble_world_ray(const tumble_world *w, tumble_vec3 from, tumble_vec3 to,
                      unsigned mask, tumble_hit *hit)
{
    vec3 tip;
    question q = along_ray(&tip, from, to, mask);
    return first_met(w, &q, hit);
}

bool tumble_world_ray_soft(const tumble_world *w, tumble_vec3 from,
                           tumble_vec3 to, unsigned mask, tumble_hit *hit)
{
    vec3 tip;
    question q = along_ray(&tip, from, to, mask);
    q.of_soft = true;
    return first_met(w, &q, hit);
}

static question near_to(tumble_vec3 x, double most, unsigned mask)
{
    return (question){ .around = { from_user(x), most }, .mask = mask,
                       .ask = query_near, .by_distance = true, .most = most };
}

bool tumble_world_nearest(const tumble_world *w, tumble_vec3 x, double most,
                          unsigned mask, tumble_hit *hit)
{
    question q = near_to(x, most, mask);
    return first_met(w, &q, hit);
}

bool tumble_world_nearest_soft(const tumble_world *w, tumble_vec3 x,
                               double most, unsigned mask, tumble_hit *hit)
{
    question q = near_to(x, most, mask);
    q.of_soft = true;
    return first_met(w, &q, hit);
}

// The vertices of a shape that stands there, in the world's third room.
static bool stand_shape(const tumble_world *w, tumble_shape s, tumble_pose pose,
                        question *q)
{
    if (!w) return false;
    const shape_place *x = slots_find(&w->shapes, s.place, s.generation);
    if (!x || x->shape->kind != SHAPE_RIGID) return false;
    vec3 *at = w->scratch + 3 * w->most_vertices;
    placement p = { .is_static = true };
    inside_place(&p, pose);
    for (int k = 0; k < x->shape->particles; k++)
        at[k] = vec3_add(p.position, placement_vector(&p, x->shape->at[k]));
    q->thing = rounded_shape(x->shape, at);
    q->around = rounded_ball(q->thing);
    return true;
}

bool tumble_world_sweep_turning(const tumble_world *w, tumble_shape s,
                                tumble_pose pose, tumble_vec3 delta,
                                tumble_vec3 turn, unsigned mask,
                                tumble_hit *hit)
{
    question q = { .delta = from_user(delta), .mask = mask, .ask = query_path,
                   .turn = from_user(turn), .most = 1 };
    if (!stand_shape(w, s, pose, &q) || !vec3_is_finite(q.turn)) return false;
    vec3 center = from_user(pose.position);
    q.around.radius += vec3_distance(q.around.center, center);
    q.around.center = center;
    return first_met(w, &q, hit);
}

bool tumble_world_sweep(const tumble_world *w, tumble_shape s, tumble_pose pose,
                        tumble_vec3 delta, unsigned mask, tumble_hit *hit)
{
    const tumble_vec3 turn = { 0, 0, 0 };
    return tumble_world_sweep_turning(w, s, pose, delta, turn, mask, hit);
}
//<

//> face-ask-inside
//>   A character (`tumble_walk.c`) is a capsule that no shape stands for.
bool inside_sweep(const tumble_world *w, rounded thing, vec3 delta, unsigned mask,
                  tumble_hit *hit)
{
    question q = { .thing = thing, .delta = delta, .around = rounded_ball(thing),
                   .mask = mask, .ask = query_path, .most = 1 };
    return first_met(w, &q, hit);
}

static cast_result query_gap(const question *q, rounded b, const plane *p,
                             vec3 *scratch)
{
    (void)scratch;
    cast_result r = p ? cast_gap_plane(q->thing, *p) : cast_gap(q->thing, b);
    r.hits = r.hits && r.fraction < q->most;
    return r;
}

bool inside_near(const tumble_world *w, rounded thing, real most, unsigned mask,
                 tumble_hit *hit)
{
    question q = { .thing = thing, .around = rounded_ball(thing), .mask = mask,
                   .ask = query_gap, .most = most };
    q.around.radius += most;
    return first_met(w, &q, hit);
}
//<

//> face-ask-all
//>   All that a ray meets are asked one by one, and put where they belong among the
//>   nearest.
static void insert_hit(tumble_hit *out, int most, int n, const tumble_hit *hit)
{
    int k = n < most ? n : most;
    if (!out || most <= 0) return;
    if (k == most && !(hit->fraction < out[k - 1].fraction)) return;
    if (k == most) k--;
    for (; k > 0 && hit->fraction < out[k - 1].fraction; k--) out[k] = out[k - 1];
    out[k] = *hit;
}

int tumble_world_ray_all(const tumble_world *w, tumble_vec3 from,
                         tumble_vec3 to, unsigned mask, tumble_hit *out,
                         int most)
{
    vec3 tip;
    question q = along_ray(&tip, from, to, mask);
    int n = 0;
    for (int k = 0; k < askable(w, &q); k++) {
        tumble_hit best = { .fraction = HUGE_VAL };
        query_place(w, k, &q, &best);
        if (best.fraction <= 1) insert_hit(out, most, n++, &best);
    }
    return n;
}

static bool overlaps(const tumble_world *w, const body_place *x,
                     const question *q)
{
    tumble_hit best = { .fraction = HUGE_VAL };
    query_body(w, x, q, &best);
    return best.fraction < HUGE_VAL;
}

int tumble_world_overlap(const tumble_world *w, tumble_shape s,
                         tumble_pose pose, unsigned mask, tumble_body *out,
                         int most)
{
    question q = { .mask = mask, .ask = query_overlap, .most = 1 };
    int n = 0;
    if (!stand_shape(w, s, pose, &q)) return 0;
    for (int k = 0; k < w->bodies.count; k++) {
        const body_place *x = slots_at(&w->bodies, k);
        if (!x || !overlaps(w, x, &q)) continue;
        if (out && n < most) out[n] = inside_body_in(w, k);
        n++;
    }
    return n;
}
//<

//> face-ask-sensor
//>   What is in a sensor is asked as what overlaps a shape, of each of its pieces.
// Is a vertex of a rope or cloth, with its ball, in there?
static bool soft_overlaps(const world *w, const body *x, const question *q)
{
    for (int i = x->first; i < x->first + body_particles(x); i++) {
        vec3 p = w->pool.at[i].position;
        rounded ball = { { &p, 1 }, x->thickness, 0 };
        real near = q->around.radius + x->thickness;
        if (!(path_distance(q, p) > near * near) && cast_overlaps(q->thing, ball))
            return true;
    }
    return false;
}

static bool is_sensed(const tumble_world *w, const body_place *sensor,
                      const body_place *x, const question *q)
{
    const body *all = &w->world.body[x->piece[0].number];
    if (x->kind == TUMBLE_STATIC || !(all->mask & sensor->group)) return false;
    if (!body_is_soft(all)) return overlaps(w, x, q);
    return (all->group & q->mask) && soft_overlaps(&w->world, all, q);
}

// Does a piece of the sensor overlap it?
static bool some_piece_senses(const tumble_world *w, const body_place *sensor,
                              const body_place *x)
{
    vec3 *at = w->scratch + 3 * w->most_vertices;
    for (int k = 0; k < sensor->pieces; k++) {
        question q = { .mask = sensor->mask, .ask = query_overlap, .most = 1 };
        q.thing = rounded_body(w, sensor->piece[k].number, at);
        q.around = rounded_ball(q.thing);
        if (is_sensed(w, sensor, x, &q)) return true;
    }
    return false;
}

int tumble_body_sensed(const tumble_world *w, tumble_body sensor,
                       tumble_body *out, int most)
{
    const body_place *s = inside_body_of(w, sensor);
    int n = 0;
    if (!s || !s->is_sensor) return 0;
    for (int k = 0; k < w->bodies.count; k++) {
        const body_place *x = slots_at(&w->bodies, k);
        if (!x || !some_piece_senses(w, s, x)) continue;
        if (out && n < most) out[n] = inside_body_in(w, k);
        n++;
    }
    return n;
}
//<
