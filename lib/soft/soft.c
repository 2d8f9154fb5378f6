//> soft-stale
#include "soft.h"
#include "contacts.h"

static int body_is_still(const world *w, int b)
{
    return body_is_nailed(&w->body[b]) || w->rest.asleep[b];
}

// What the moves of some particles since their listing have in common: they end
// in a box, and none is longer than the longest.
typedef struct {
    vec3 least, most;   // m
    real longest;       // m^2
    real quickest;      // m^2, the longest of the last substep
} moves;

static inline real longer(real a, vec3 d)
{
    real b = vec3_length_squared(d);
    // A NaN enters, and nothing replaces it.
    return b > a || b != b ? b : a;
}

// The corners of a rigid body of four particles may be up to twice as far out
// as these are.
static void add_moves(moves *to, const world *w, const body *b)
{
    moves m = *to;
    real share = body_is_soft(b) ? 1 : 2;
    for (int i = b->first; i < b->first + body_particles(b); i++) {
        const particle *p = &w->pool.at[i];
        vec3 d = vec3_sub(p->position, w->of.listed[i]);
        vec3 u = vec3_sub(p->position, p->previous);
        d = vec3_scale(share, d);
        m.least = (vec3){ d.x < m.least.x ? d.x : m.least.x,
                          d.y < m.least.y ? d.y : m.least.y,
                          d.z < m.least.z ? d.z : m.least.z };
        m.most = (vec3){ d.x > m.most.x ? d.x : m.most.x,
                         d.y > m.most.y ? d.y : m.most.y,
                         d.z > m.most.z ? d.z : m.most.z };
        m.longest = longer(m.longest, d);
        m.quickest = longer(m.quickest, vec3_scale(share, u));
    }
    *to = m;
}

// Two whose moves differ by the margin may have closed it.  Before that the
// lists are good; and for as many substeps more as it would take if any two
// went against each other, at twice the speed of the fastest, but at most 8,
// for speeds change.
enum { TRUST_MOST = 8 };

static int lists_are_good(world *w)
{
    if (w->near.trusted < 0) return 0;
    if (w->near.trusted > 0) {
        w->near.trusted--;
        return 1;
    }
    // What stands still has moved by nothing, and that is in the box, too.
    moves m = { .longest = 0 };
    for (int b = 0; b < w->bodies; b++)
        if (!body_is_still(w, b)) add_moves(&m, w, &w->body[b]);
    real apart = vec3_distance(m.least, m.most), both = 2 * sqrt(m.longest);
    real left = w->near.margin - (apart < both ? apart : both);
    real pace = 4 * sqrt(m.quickest);
    if (!(left > 0)) return 0;
    w->near.trusted = left >= TRUST_MOST * pace ? TRUST_MOST
                    : left > pace ? (int)(left / pace) : 0;
    return 1;
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
    int pairs = room_for(w, found.pairs, w->leaves.capacity);
    pairs = room_for(w, pairs, w->near.pair_capacity - w->near.pairs);
    for (int k = 0; k < pairs; k++)
        w->near.pair[w->near.pairs++] = (particle_contact){
            a->first + w->leaves.pair[k].a, b->first + w->leaves.pair[k].b,
            a->thickness + b->thickness };
}

// The ends of a link do not collide, the stick holds them apart: in a square
// grid they stand at 0.91 diameters.  Those of a cell's diagonals, at 1.29, do:
// only one of the two has a stick, which is soft, and a crease can shear the
// cell until the ends of the other meet, and the triangles around them cross.
static const real LINKED = 1.2;

// A body against itself: equal balls, which a grid sorts quickest.  Where one
// is thrown far out of the others, the tree is asked.
static void list_self(world *w, body *a)
{
    const vec3 *at = w->of.at + a->first;
    real touching = 2 * a->thickness;
    int found = grid_pairs(&w->near.grid, at, a->plan->particles,
                           touching + w->near.margin, a->plan->at,
                           LINKED * touching,
                           w->leaves.pair, w->leaves.capacity);
    if (found < 0) {
        sphere_tree_refresh(&a->tree, at);
        add_near(w, a, a, sphere_tree_self(&a->tree, at, w->near.margin, LINKED,
                                           w->leaves.pair, w->leaves.capacity));
    } else {
        add_near(w, a, a, (tree_result){ .pairs = found });
    }
}

static void list_soft_pair(world *w, body *a, body *b)
{
    add_near(w, a, b, sphere_tree_pairs(
        &a->tree, w->of.at + a->first, &b->tree, w->of.at + b->first,
        w->near.margin, w->leaves.pair, w->leaves.capacity));
}
//<

//> soft-points
// The planes of a rigid body, made anew whenever it may have moved.
static void look_at_hull(world *w, int b)
{
    body *rigid = &w->body[b];
    if (w->hull.of == b && body_is_nailed(rigid)) return;
    world_look(w, rigid);
    w->hull.planes = hull_planes(rigid->plan, w->of.at + rigid->corner,
                                 w->hull.plane, w->hull.face);
    w->hull.of = b;
}

// Between two particles on both sides of a right-angled edge, at the distance r
// of it, a triangle's side cuts the corner: one as long as 2.83 r touches it.
// The longest, the diagonal of a cell, would do with half a spacing, and we
// have 0.55.  But the sticks come last, and pull them nearer: so an eighth
// more, of what is nailed.  What is not makes way.
static const real SPARE = 1.125;

real soft_gap(const body *soft, const body *rigid)
{
    real touching = soft->thickness + rigid->thickness;
    return body_is_nailed(rigid) ? SPARE * touching : touching;
}

// The particles of a that are near the rigid body b: inside its sphere, or not
// far outside, and not far in front of any of its planes.
static void list_points(world *w, int a, int b)
{
    body *soft = &w->body[a], *rigid = &w->body[b];
    real reach = soft_gap(soft, rigid) + w->near.margin;
    sphere ball = sphere_tree_root(&rigid->tree, w->of.at + rigid->corner);
    ball.radius += reach;
    int is_ready = 0;
    for (int i = soft->first; i < soft->first + soft->plan->particles; i++) {
        vec3 x = w->of.at[i];
        vec3 d = vec3_sub(x, ball.center);
        if (vec3_length_squared(d) > ball.radius * ball.radius) continue;
        if (!is_ready) look_at_hull(w, b);
        is_ready = 1;
        int ahead = hull_ahead(x, w->hull.plane, w->hull.planes);
        if (plane_height(w->hull.plane[ahead], x) > reach) continue;
        if (room_for(w, 1, w->near.point_capacity - w->near.points) == 1)
            w->near.point[w->near.points++] = (point_pair){ i, a, b, ahead };
    }
}
//<

//> soft-refresh
static void list_pair(world *w, int a, int b)
{
    int soft_a = body_is_soft(&w->body[a]), soft_b = body_is_soft(&w->body[b]);
    if (body_is_still(w, a) && body_is_still(w, b)) return;
    if (soft_a && soft_b)  list_soft_pair(w, &w->body[a], &w->body[b]);
    else if (soft_a)       list_points(w, a, b);
    else if (soft_b)       list_points(w, b, a);
}

void soft_refresh(world *w)
{
    if (lists_are_good(w)) return;
    w->near.pairs = w->near.points = w->near.trusted = 0;
    w->report.rebuilt++;
    for (int b = 0; b < w->bodies; b++) {
        body *now = &w->body[b];
        // A grid needs no tree; another body does.
        if (body_is_soft(now) && w->softs == 1) world_look(w, now);
        else                                    world_look_again(w, now);
        for (int i = now->first; i < now->first + body_particles(now); i++)
            w->of.listed[i] = w->pool.at[i].position;
    }
    for (int a = 0; a < w->bodies; a++) {
        if (body_is_soft(&w->body[a]) && !body_is_still(w, a))
            list_self(w, &w->body[a]);
        for (int b = a + 1; b < w->bodies; b++) list_pair(w, a, b);
    }
}
//<

//> soft-separate
// Four particles answer a push as the solid would.
static void push_apart(world *w, point_pair pair, const contact_point *c)
{
    push_options how = { .friction = w->options.friction,
                         .mend = 1, .mend_speed = HUGE_VAL };
    push x = contacts_push(w, c, pair.soft, pair.rigid);
    push_limit(&x, w->pool.at, how, 1);
    push_mend(&x, w->pool.at, how);
    push_solve(&x, w->pool.at, how);
}
//<

//> soft-whole
// A particle at x that weighs what the cloth weighs, and moves as its centre
// of mass does; nailed, if any of it is.
static particle whole_cloth(const world *w, const body *soft, vec3 x)
{
    particle whole = { .position = x, .previous = x };
    vec3 sum = { 0, 0, 0 };
    for (int i = soft->first; i < soft->first + soft->plan->particles; i++) {
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
static void push_whole(world *w, point_pair pair, const contact_point *c)
{
    const body *soft = &w->body[pair.soft];
    particle *p = &w->pool.at[pair.particle], was = *p;
    particle before = whole_cloth(w, soft, p->position);
    *p = before;
    push_apart(w, pair, c);
    vec3 now = vec3_sub(p->position, before.position);
    vec3 then = vec3_sub(p->previous, before.previous);
    *p = was;
    if (before.inverse_mass == 0) return;
    for (int i = soft->first; i < soft->first + soft->plan->particles; i++) {
        p = &w->pool.at[i];
        p->position = vec3_add(p->position, now);
        p->previous = vec3_add(p->previous, then);
    }
}
//<

//> soft-over-face
// Keeps a particle so far in front of a plane.  1 if it was not.
static int separate_from_plane(const world *w, particle *p, plane face,
                               real apart)
{
    real up = plane_height(face, p->position);
    vec3 foot = vec3_add_scaled(p->position, -up, face.normal);
    return surface_separate(p, foot, face.normal, apart,
                            w->options.friction) > 0;
}

// Is the point of plane number k under x on the body?  Then no other plane is
// as far under x: from there to x that one rises with all of the way, others
// with a part of it, and they began no higher.
static int stands_over(const world *w, vec3 x, int k, real slack)
{
    real up = plane_height(w->hull.plane[k], x);
    vec3 foot = vec3_add_scaled(x, -up, w->hull.plane[k].normal);
    for (int i = 0; i < w->hull.planes; i++)
        if (plane_height(w->hull.plane[i], foot) > slack) return 0;
    return up > 0;
}

// The commonest contact by far: over a face of a nailed body, or inside it, a
// particle goes straight out, and nobody needs to know of it.  Most often it is
// the face that it was in front of when it was listed.  -1: it is over no face;
// else as separate_point.
static int separate_from_face(world *w, particle *p, int ahead, real apart,
                              real slack)
{
    vec3 x = p->position;
    if (ahead >= w->hull.planes || !stands_over(w, x, ahead, slack)) {
        ahead = hull_ahead(x, w->hull.plane, w->hull.planes);
        real up = plane_height(w->hull.plane[ahead], x);
        if (!(up <= apart)) return 0;
        if (up > 0 && !stands_over(w, x, ahead, slack)) return -1;
    }
    return separate_from_plane(w, p, w->hull.plane[ahead], apart);
}
//<

//> soft-separate-point
typedef void (*pusher)(world *w, point_pair pair, const contact_point *c);

static int separate_point(world *w, point_pair pair, real apart, pusher by)
{
    const body *soft = &w->body[pair.soft], *rigid = &w->body[pair.rigid];
    pooled a = world_collider(w, soft), b = world_collider(w, rigid);
    contact_point c;
    w->of.at[pair.particle] = w->pool.at[pair.particle].position;
    if (!collide_point(&a, pair.particle - soft->first, &b, w->hull.plane,
                       w->hull.face, w->hull.planes, apart, &c)) return 0;
    c.thickness = apart;
    if (body_is_nailed(rigid))
        return surface_separate(&w->pool.at[pair.particle], c.fixed, c.normal,
                                apart, w->options.friction) > 0;
    by(w, pair, &c);
    return 1;
}
//<

//> soft-separate-all
// The points from number k on that are of the same two bodies, to this share of
// what keeps them apart.  One plane that a particle is clear of is enough to
// know that it does not touch: most often the one that it was in front of when
// it was listed.  (There may be fewer by now: strain parts the planes of two
// triangles of one side, and lets them meet again.)  *touching counts who
// touched.  Returns the next number.
static int separate_points_of(world *w, int k, real share, pusher by,
                              int *touching)
{
    point_pair first = w->near.point[k];
    const body *soft = &w->body[first.soft], *rigid = &w->body[first.rigid];
    real apart = share * soft_gap(soft, rigid);
    real slack = 1e-12 * rigid->plan->radius;
    look_at_hull(w, first.rigid);
    for (; k < w->near.points; k++) {
        point_pair pair = w->near.point[k];
        particle *p = &w->pool.at[pair.particle];
        if (pair.soft != first.soft || pair.rigid != first.rigid) break;
        if (pair.ahead < w->hull.planes
            && plane_height(w->hull.plane[pair.ahead], p->position) > apart)
            continue;
        int touched = !body_is_nailed(rigid) ? -1
                    : separate_from_face(w, p, pair.ahead, apart, slack);
        if (touched < 0) touched = separate_point(w, pair, apart, by);
        *touching += touched;
    }
    return k;
}

// All points.  Returns how many touched.
static int separate_points(world *w, real share, pusher by)
{
    int touching = 0;
    for (int k = 0; k < w->near.points;)
        k = separate_points_of(w, k, share, by, &touching);
    return touching;
}

// Particles of deformable bodies and the world's planes.
static int separate_planes(world *w)
{
    int touching = 0;
    for (int b = 0; b < w->bodies && w->planes > 0; b++) {
        const body *soft = &w->body[b];
        if (!body_is_soft(soft) || !body_moves(w, b)) continue;
        for (int i = soft->first; i < soft->first + soft->plan->particles; i++)
            for (int k = 0; k < w->planes; k++)
                touching += separate_from_plane(w, &w->pool.at[i], w->plane[k],
                                                soft->thickness);
    }
    return touching;
}

void soft_separate(world *w)
{
    int touching = separate_planes(w);
    for (int k = 0; k < w->near.pairs; k++)
        if (particle_contact_overlaps(&w->near.pair[k], w->pool.at))
            touching += particle_contact_separate(w->near.pair[k], w->pool.at,
                                                  w->options.friction) > 0;
    touching += separate_points(w, 1, push_apart);
    w->report.near = w->near.pairs + w->near.points;
    w->report.touching = touching;
}

// In a cloth that lies on a nailed body this finds nobody.  But particles that
// a bullet drives before it are pulled back by their sticks, and through it:
// they are light, and make way.  What stops it is all that the sticks hold
// together.
void soft_hold(world *w)
{
    separate_points(w, 0.5, push_whole);
}
//<
