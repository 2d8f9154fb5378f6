//> near-stale
//>   Are they still good? Both bounds come from one walk over all moves.
#include "near.h"
#include "table.h"

#include <assert.h>
#include <stddef.h>
#include <stdlib.h>

rigid_frame soft_rigid_frame(const soft_frame *f, int b)
{
    b = body_whole(&f->body[b], b);
    return motion_frame(&f->now[b].frame, &f->now[b].basis, &f->moved[b]);
}

// What the moves of some particles since their listing have in common: they end
// in a box, and none is longer than the longest.
typedef struct {
    aabb box;           // m
    real longest;       // m^2
} moves_box;

static inline real longer(real a, vec3 d)
{
    real b = vec3_length_squared(d);
    // A NaN enters, and nothing replaces it.
    return b > a || b != b ? b : a;
}

static inline void add_move(moves_box *m, vec3 d)
{
    m->box = aabb_join((aabb){ d, d }, m->box);
    m->longest = longer(m->longest, d);
}

static void add_soft_moves(moves_box *to, const near_lists *l, const soft_frame *f,
                           const body *b)
{
    moves_box m = *to;
    for (int i = b->first; i < b->first + b->shape->particles; i++)
        add_move(&m, vec3_sub(f->particle[i].position, l->listed[i]));
    *to = m;
}

// The vertices of a rigid body may be up to twice as far out as its four
// particles are.
static void add_rigid_moves(moves_box *m, const near_lists *l, const soft_frame *f,
                            int b)
{
    rigid_frame frame = soft_rigid_frame(f, b);
    for (int k = 0; k < FOUR; k++) {
        vec3 at = vec3_add(frame.center, frame_arm(&frame, k));
        add_move(m, vec3_scale(2, vec3_sub(at, l->listed[f->body[b].first + k])));
    }
}

// Two whose moves differ by the margin may have closed it.
static bool lists_are_good(near_lists *l, const soft_frame *f)
{
    // What was clear counted on the pace that was.
    l->substeps += f->age != f->h ? TRUST_MOST : 1;
    if (l->is_stale) return false;
    // What stands still has moved by nothing, and that is in the box, too.
    moves_box m = { .longest = 0 };
    for (int k = 0; k < l->candidates; k++) {
        int b = l->candidate[k];
        if (!soft_moves(f, b)) continue;
        if (body_is_soft(&f->body[b])) add_soft_moves(&m, l, f, &f->body[b]);
        else                           add_rigid_moves(&m, l, f, b);
    }
    real apart = vec3_distance(m.box.low, m.box.high), both = 2 * sqrt(m.longest);
    return (apart < both ? apart : both) < l->margin;
}
//<

//> near-pairs
//>   A particle must not collide with its neighbours in the sheet, because
//>   their links hold it nearer than two radii. What stood nearer than 1.5
//>   diameters in the flat sheet is left out: four neighbours at one spacing,
//>   and four across diagonals, at 1.41.
// The pairs of a traversal that found room; the others are counted.
static int room_for(near_lists *l, int found, int room)
{
    if (found <= room) return found;
    l->dropped += found - room;
    return room;
}

// Leaves are single particles, in the order of the body's.
static void add_near(near_lists *l, const body *a, const body *b,
                     tree_result found)
{
    int pairs = room_for(l, found.pairs, l->pair_capacity - l->pairs);
    for (int k = 0; k < pairs; k++)
        l->pair[l->pairs++] = (particle_contact){
            a->first + l->leaf[k].a, b->first + l->leaf[k].b,
            a->thickness + b->thickness };
}

// The ends of a link do not collide, the stick holds them apart: in a square
// grid they stand at 0.91 diameters.  Nor do, here, those of a cell's diagonals,
// at 1.29: they are looked after in every substep.  The next stand at 1.82.
// The grid knows the neighbours by their places, the tree by a distance (diameters)
// between these two: any other would leave out the same.
static const real LINKED = 1.5;

// A body against itself: equal balls, which a grid sorts fastest.  Where one is
// thrown far out of the others, the tree is asked.
static void list_self(near_lists *l, const soft_frame *f, int b)
{
    const body *a = &f->body[b];
    sphere_tree *tree = &l->tree[b];
    const vec3 *at = l->at + a->first;
    real touching = 2 * a->thickness;
    int found = grid_pairs(&l->grid, at, a->shape->particles,
                           touching + l->margin, a->shape->columns, l->leaf,
                           l->pair_capacity);
    if (found < 0) {
        sphere_tree_refresh(tree, at);
        add_near(l, a, a, sphere_tree_self(tree, at, l->margin, LINKED,
                                           l->leaf, l->pair_capacity));
    } else {
        add_near(l, a, a, (tree_result){ .pairs = found });
    }
}

static void list_soft_pair(near_lists *l, const soft_frame *f, int a, int b)
{
    const body *x = &f->body[a], *y = &f->body[b];
    if (l->tree[a].leaves == 0 || l->tree[b].leaves == 0) return;
    add_near(l, x, y, sphere_tree_pairs(&l->tree[a], l->at + x->first,
                                        &l->tree[b], l->at + y->first,
                                        l->margin, l->leaf, l->pair_capacity));
}
//<

//> near-view
//>   What the lists say of a particle over a face.
void rigid_view_update(rigid_view *v, const soft_frame *f, int b)
{
    const body *rigid = &f->body[b];
    const shape *s = rigid->shape;
    if (v->of == b && body_is_fixed(rigid)) return;
    rigid_frame frame = soft_rigid_frame(f, b);
    rigid4_ride(rigid->rigid, &frame, v->corner, s->particles);
    v->hull = (obstacle){ { v->corner, s->particles }, v->plane,
                          hull_planes(s, v->corner, v->plane), s->radius,
                          s->round };
    v->frame = frame;
    v->moved = f->moved[body_whole(rigid, b)];
    v->of = b;
}
//<

//> near-facets
//>   Which facets are listed? Those whose particles are near enough. But a
//>   sheet on a flat face must not become a thousand facets: what three
//>   particles hold off one face needs nothing more, as long as all three stand
//>   over it and nowhere near its rim.
// A particle keeps 0.55 of a spacing from a face, and a cell's diagonal over a
// right-angled edge 0.05: that much, and some more, facets keep from all.  What
// is about as thin as a cell may be sharp, too, and be through in a substep: it
// is stopped earlier.
static const real THIN_SHEET = 1.5;         // tuned, spacings
static const real GAP = 0.3;                // tuned, thicknesses
static const real GAP_THIN = 0.7;           // tuned, thicknesses

real facet_gap(const body *soft, const body *rigid)
{
    bool is_thin = rigid->inner < THIN_SHEET * soft->shape->spacing;
    return (is_thin ? GAP_THIN : GAP) * soft->thickness;
}

// How far from a body may all corners of a facet be that comes within reach?  Its
// nearest point is no further from a corner than 1 / sqrt(3) of its longest side,
// which may be a fifth longer than at rest, where cells are sheared; and that is
// at right angles to the reach.
static real facet_reach(real reach, const body *soft)
{
    const shape *s = soft->shape;
    // The last stick of a cloth is a diagonal.
    real longest = s->sticks > 0 ? s->stick[s->sticks - 1].rest_length : 0;
    real beside = 0.7 * longest;
    return sqrt(reach * reach + beside * beside);
}

// Where a particle is: far from the body; in front of one of its planes, by its
// number; or over that face and nowhere near its rim.  A facet over a face meets
// nothing else while the lists are good, and its particles keep it off that.
enum { OVER_NOTHING = -1 };

static bool is_over_body(const rigid_view *v, vec3 x, int ahead, real inside)
{
    if (v->hull.planes == 0) return false;
    plane face = v->plane[ahead];
    real up = plane_height(face, x);
    vec3 foot = vec3_add_scaled(x, -up, face.normal);
    real rim = inside + 2 * v->hull.round;      // of a face of the core
    for (int k = 0; k < v->hull.planes; k++)
        if (k != ahead && !(plane_height(v->plane[k], foot) < -rim))
            return false;
    return up > 0;
}

// In the order in which facets are listed: by the two bodies, by number.
static int order_facets(const facet_pair *x, const facet_pair *y)
{
    int first = int_min(x->soft, x->rigid) - int_min(y->soft, y->rigid);
    int second = int_max(x->soft, x->rigid) - int_max(y->soft, y->rigid);
    return first != 0 ? first : second != 0 ? second : x->number - y->number;
}

// What the last lists knew of a facet, which come in the same order.
static plane known_plane(facet_list *last, const facet_pair *x)
{
    while (last->next < last->count && order_facets(&last->at[last->next], x) < 0)
        last->next++;
    if (last->next < last->count && order_facets(&last->at[last->next], x) == 0)
        return last->at[last->next].between;
    return (plane){ { 0, 0, 0 }, 0 };
}

// Are all corners over the same face?
static bool is_over_face(const int *ahead, const int corner_of[FACET])
{
    int first = ahead[corner_of[0]];
    return first % 2 == 1 && ahead[corner_of[1]] == first
        && ahead[corner_of[2]] == first;
}

// May a facet with these corners come within reach?  All planes that a corner is
// in front of are asked; most often it is the same one.
static bool may_touch_soft(const near_lists *l, const rigid_view *v,
                           const int corner_of[FACET], real reach)
{
    vec3 end[FACET];
    int asked = OVER_NOTHING;
    for (int k = 0; k < FACET; k++) end[k] = l->at[corner_of[k]];
    for (int k = 0; k < FACET; k++) {
        int ahead = l->ahead[corner_of[k]];
        bool is_asked = v->hull.planes > 0 && ahead / 2 == asked;
        if (ahead == OVER_NOTHING || is_asked) continue;
        asked = ahead / 2;
        plane under = obstacle_plane(&v->hull, end[k], asked);
        if (facet_height(end, under) > reach) return false;
    }
    return true;
}

// Room for one facet more, in this list and the next.
static bool grow_facets(near_lists *l)
{
    int room = table_room(l->facet.count + 1, l->facet_capacity);
    facet_list *was = &l->facets_before;
    bool ok = true;
    if (room == l->facet_capacity) return true;
    TABLE_GROW(ok, was->at, was->count, room);
    TABLE_GROW(ok, l->facet.at, l->facet.count, room);
    if (ok) l->facet_capacity = room;
    else    l->dropped++;
    return ok;
}

static void list_facets(near_lists *l, const rigid_view *v, const soft_frame *f,
                        int a, int b)
{
    const body *soft = &f->body[a];
    const shape *s = soft->shape;
    real reach = facet_gap(soft, &f->body[b]) + l->margin;
    int facets = s->mesh.faces > 0 ? s->mesh.faces : s->sticks;
    for (int k = 0; k < facets; k++) {
        int end[FACET];
        facet_corners(soft, k, end);
        const int *ahead = l->ahead;
        int all = ahead[end[0]] & ahead[end[1]] & ahead[end[2]];
        if (all == OVER_NOTHING || is_over_face(ahead, end)) continue;
        if (!may_touch_soft(l, v, end, reach)) continue;
        if (!grow_facets(l)) continue;
        facet_pair pair = { .soft = a, .rigid = b, .number = k };
        pair.between = known_plane(&l->facets_before, &pair);
        l->facet.at[l->facet.count++] = pair;
    }
}
//<

//> near-points
// Between two particles on both sides of a right-angled edge, at the distance r
// of it, a triangle's side cuts the corner: one as long as 2.83 r touches it.
// The longest, the diagonal of a cell, would do with half a spacing, and we
// have 0.55.  But the sticks come last, and pull them nearer: so a third more
// of what is static.  What is not makes way.
static const real SPARE = 1.35;             // tuned, 1

real soft_gap(const body *soft, const body *rigid)
{
    return body_yields(rigid) ? soft->thickness : SPARE * soft->thickness;
}

// The particles of a that are near the rigid body b: inside its ball, or not
// far outside, and not far in front of any of its planes.
static void list_points(near_lists *l, rigid_view *v, const soft_frame *f,
                        int a, int b)
{
    const body *soft = &f->body[a];
    real reach = soft_gap(soft, &f->body[b]) + l->margin;
    real facet = facet_gap(soft, &f->body[b]) + l->margin;
    real wide = real_max(reach, facet_reach(facet, soft));
    real far = f->now[b].radius + wide;
    vec3 center = soft_rigid_frame(f, b).center;
    bool is_ready = false;
    int ahead = 0;
    for (int i = soft->first; i < soft->first + soft->shape->particles; i++) {
        vec3 x = l->at[i];
        l->ahead[i] = OVER_NOTHING;
        if (vec3_length_squared(vec3_sub(x, center)) > far * far) continue;
        if (!is_ready) rigid_view_update(v, f, b);
        is_ready = true;
        // Most that are far are in front of the plane that the last one was.
        if (v->hull.planes > 0 && plane_height(v->plane[ahead], x) > wide)
            continue;
        int over = is_over_body(v, x, ahead, facet);
        if (!over) ahead = hull_ahead(x, v->plane, v->hull.planes);
        real up = plane_height(obstacle_plane(&v->hull, x, ahead), x);
        if (up > wide) continue;
        l->ahead[i] = 2 * ahead;
        if (up > reach) continue;
        over = over || is_over_body(v, x, ahead, facet);
        l->ahead[i] += over;
        if (TABLE_ADD(l->point, l->points, l->point_capacity))
            l->point[l->points++] = (point_pair){ i, a, b, ahead, over };
        else
            l->dropped++;
    }
    if (is_ready) list_facets(l, v, f, a, b);
}
//<

//> near-refresh
//>   When the lists are made again, the places of that moment are noted.
static void list_pair(near_lists *l, rigid_view *v, const soft_frame *f, int a,
                      int b)
{
    bool a_is_soft = body_is_soft(&f->body[a]);
    bool b_is_soft = body_is_soft(&f->body[b]);
    if (!soft_moves(f, a) && !soft_moves(f, b)) return;
    if (!soft_meets(f, a, b)) return;
    if (a_is_soft && b_is_soft) list_soft_pair(l, f, a, b);
    else if (a_is_soft)         list_points(l, v, f, a, b);
    else if (b_is_soft)         list_points(l, v, f, b, a);
}

// Copies where the particles of a deformable body are, for tree and grid.
static void copy_soft(near_lists *l, const soft_frame *f, int b)
{
    const body *x = &f->body[b];
    for (int i = x->first; i < x->first + x->shape->particles; i++)
        l->at[i] = f->particle[i].position;
}

// A grid needs no tree; another body does.
static void note_places(near_lists *l, const soft_frame *f, int b)
{
    const body *x = &f->body[b];
    if (!body_is_soft(x)) {
        rigid_frame frame = soft_rigid_frame(f, b);
        for (int k = 0; k < FOUR; k++)
            l->listed[x->first + k] = vec3_add(frame.center,
                                               frame_arm(&frame, k));
        return;
    }
    copy_soft(l, f, b);
    if (l->softs > 1) sphere_tree_refresh(&l->tree[b], l->at + x->first);
    for (int i = x->first; i < x->first + x->shape->particles; i++)
        l->listed[i] = l->at[i];
}

// Where two begin nearer than touching, nothing has pressed them there, and to
// be pushed out at once would throw them apart.  Each keeps the least gap that it has.
static void find_soft_gaps(near_lists *l, const soft_frame *f)
{
    for (int k = 0; k < l->pairs; k++) {
        const particle_contact *c = &l->pair[k];
        real *a = &l->gap[f->owner[c->a]], *b = &l->gap[f->owner[c->b]];
        real apart = vec3_distance(l->at[c->a], l->at[c->b]) / c->distance;
        if (a == b || !(apart < 1)) continue;
        if (*a > 1) *a = real_min(*a, 2 + apart);
        if (*b > 1) *b = real_min(*b, 2 + apart);
    }
    for (int n = 0; n < l->softs; n++) {
        real *gap = &l->gap[l->soft[n]];
        if (*gap > 1) *gap -= 2;
    }
}

// It widens by so much a second that after one they touch as others do.
static void widen_gaps(near_lists *l, const soft_frame *f)
{
    for (int n = 0; n < l->softs; n++) {
        real *gap = &l->gap[l->soft[n]];
        if (soft_moves(f, l->soft[n]) && *gap < 1)
            *gap = real_min(*gap + f->h, 1);
    }
}

void near_refresh(near_lists *l, rigid_view *v, const soft_frame *f)
{
    widen_gaps(l, f);
    if (lists_are_good(l, f)) return;
    facet_list last = l->facet;
    l->facet = (facet_list){ .at = l->facets_before.at };
    l->facets_before = last;
    l->facets_before.next = 0;
    l->pairs = l->points = 0;
    l->is_stale = false;
    l->substeps = 0;
    l->made++;
    const int *c = l->candidate;
    for (int k = 0; k < l->candidates; k++) note_places(l, f, c[k]);
    for (int k = 0; k < l->candidates; k++) {
        if (is_moving_soft(f, c[k])) list_self(l, f, c[k]);
        for (int j = k + 1; j < l->candidates; j++)
            list_pair(l, v, f, c[k], c[j]);
    }
    if (l->softs > 1) find_soft_gaps(l, f);
}
//<

//> near-candidates
//>   Which bodies are asked at all.
static aabb box_around(const vec3 *at, int n)
{
    aabb x = { at[0], at[0] };
    for (int i = 1; i < n; i++) x = aabb_with(x, at[i]);
    return x;
}

static bool is_far(const aabb *x, sphere ball, real reach)
{
    real apart = ball.radius + reach;
    return aabb_distance_squared(x, ball.center) > apart * apart;
}

// Nothing gets faster in a frame than so many times the fastest, as it begins.
static const real FASTER = 2;               // tuned, 1

// Two bodies that are further apart than this (m) cannot be near in the frame.
static real frame_reach(const near_lists *l, const soft_frame *f,
                        const prediction *ahead)
{
    real fastest = 0;
    for (int b = 0; b < f->bodies; b++) {
        real reach = ahead[b].reach;
        if (reach > fastest || reach != reach) fastest = reach;
    }
    return 2 * FASTER * fastest + 2 * l->margin;
}

static void mark_near(near_lists *l, const soft_frame *f, int a, real reach)
{
    const body *soft = &f->body[a];
    if (soft->shape->particles == 0) return;
    aabb around = box_around(l->at + soft->first, soft->shape->particles);
    l->is_near[a] = true;
    for (int b = 0; b < f->bodies; b++)
        if (!body_is_soft(&f->body[b]))
            l->is_near[b] |= !is_far(&around, f->ball[b],
                                     reach + soft->thickness);
}

// What deformable bodies may meet in this frame.  If one of these was no
// candidate when the lists were made, they are no longer good.
static void choose_candidates(near_lists *l, const soft_frame *f,
                              const prediction *ahead)
{
    real reach = frame_reach(l, f, ahead);
    int missing = 0;
    for (int b = 0; b < f->bodies; b++) l->is_near[b] = false;
    for (int n = 0; n < f->softs; n++) mark_near(l, f, f->soft[n], reach);
    for (int b = 0; b < f->bodies; b++) missing += l->is_near[b];
    for (int k = 0; k < l->candidates; k++)
        missing -= l->is_near[l->candidate[k]];
    if (missing == 0) return;
    l->is_stale = true;
    l->candidates = 0;
    for (int b = 0; b < f->bodies; b++)
        if (l->is_near[b]) l->candidate[l->candidates++] = b;
}
//<

//> near-begin
//>   A frame begins with a ball around each body.
// Around the middle of the box of all.  What has no particles meets nothing.
static sphere ball_of_box(const vec3 *at, int n)
{
    if (n == 0) return (sphere){ { 0, 0, 0 }, -HUGE_VAL };
    aabb all = box_around(at, n);
    vec3 middle = vec3_scale(0.5, vec3_add(all.low, all.high));
    real far2 = 0;
    for (int i = 0; i < n; i++)
        far2 = longer(far2, vec3_sub(at[i], middle));
    return (sphere){ middle, sqrt(far2) };
}

void near_begin(near_lists *l, const soft_frame *f, const prediction *ahead)
{
    l->made = l->dropped = 0;
    for (int b = 0; b < f->bodies; b++) {
        const vec3 *at = l->at + f->body[b].first;
        if (!body_is_soft(&f->body[b])) {
            l->ball[b] = f->ball[b];
            continue;
        }
        copy_soft(l, f, b);
        l->ball[b] = ball_of_box(at, f->body[b].shape->particles);
        l->ball[b].radius += f->body[b].thickness;
    }
    choose_candidates(l, f, ahead);
}
//<

//> near-init
//>   Its memory.
// Leaves are single particles.
static status particle_tree(sphere_tree *tree, const body *b)
{
    int n = b->shape->particles;
    if (!body_is_soft(b)) return status_ok();
    leaf_feature *leaf = malloc((size_t)n * sizeof *leaf);
    if (!leaf) return status_out_of_memory();
    for (int i = 0; i < n; i++) leaf[i] = (leaf_feature){ 1, { i, 0, 0 } };
    status done = sphere_tree_build(tree, TREE_LAYERED, b->shape->at, leaf, n,
                                    b->thickness, 0);
    free(leaf);
    return done;
}

// A particle of a cloth folded on itself has 12 in touch, most of them its
// neighbours at rest, but the lists look further: 24 a particle.  And it is near
// 4 rigid bodies, where they lie together; where they are triangles smaller than its
// spacing it is near more, and those lists grow.
static bool make_list_room(near_lists *l, int soft)
{
    int pairs = table_room(24 * soft, l->pair_capacity);
    int points = table_room(4 * soft, l->point_capacity);
    int facets = table_room(6 * soft, l->facet_capacity);
    bool ok = true;
    if (pairs == l->pair_capacity) return true;
    l->pairs = l->points = 0;
    TABLE_GROW(ok, l->pair, 0, pairs);
    TABLE_GROW(ok, l->leaf, 0, pairs);
    TABLE_GROW(ok, l->pressed, 0, pairs);
    TABLE_GROW(ok, l->point, 0, points);
    TABLE_GROW(ok, l->facet.at, l->facet.count, facets);
    TABLE_GROW(ok, l->facets_before.at, l->facets_before.count, facets);
    if (!ok) return false;
    l->pair_capacity = pairs;
    l->point_capacity = points;
    l->facet_capacity = facets;
    return true;
}

static bool make_near_room(near_lists *l, int bodies, int particles)
{
    int room = table_room(bodies, l->bodies);
    int particle_room = table_room(particles, l->particles);
    bool ok = true;
    if (room > l->bodies) {
        TABLE_GROW(ok, l->tree, l->bodies, room);
        TABLE_GROW(ok, l->ball, l->bodies, room);
        TABLE_GROW(ok, l->gap, l->bodies, room);
        TABLE_GROW(ok, l->is_near, l->bodies, room);
        TABLE_GROW(ok, l->candidate, l->candidates, room);
        TABLE_GROW(ok, l->soft, l->softs, room);
        if (ok) l->bodies = room;
    }
    if (particle_room > l->particles) {
        TABLE_GROW(ok, l->at, l->particles, particle_room);
        TABLE_GROW(ok, l->listed, l->particles, particle_room);
        TABLE_GROW(ok, l->ahead, l->particles, particle_room);
        if (ok) l->particles = particle_room;
    }
    return ok;
}

static status grow_grid(grid *g, int points)
{
    grid larger;
    if (points <= g->points) return status_ok();
    status done = grid_init(&larger, points);
    if (!done.ok) return done;
    grid_free(g);
    *g = larger;
    return done;
}

// A wide margin makes long lists, a narrow one makes them often.  With 0.75 of
// a spacing a flat cloth has the diagonals of its cells, and no more: what
// stands at two spacings is further than the 1.1 of touching and the margin.
static const real MARGIN = 0.75;            // tuned, spacings

static real margin_of(const body *b)
{
    return MARGIN * b->shape->spacing;
}

status near_add(near_lists *l, const body *all, int b, int bodies,
                int particles)
{
    const body *x = &all[b];
    if (l->softs == 0) l->margin = HUGE_VAL;
    l->is_stale = true;
    if (!make_near_room(l, bodies, particles)) return status_out_of_memory();
    if (!body_is_soft(x)) return status_ok();
    int n = x->shape->particles;
    if (!make_list_room(l, l->soft_particles + n))
        return status_out_of_memory();
    status done = grow_grid(&l->grid, n);
    if (done.ok) done = particle_tree(&l->tree[b], x);
    if (!done.ok) return done;
    int k = l->softs++;
    for (; k > 0 && l->soft[k - 1] > b; k--) l->soft[k] = l->soft[k - 1];
    l->soft[k] = b;
    l->gap[b] = 3;
    l->soft_particles += n;
    l->margin = fmin(l->margin, margin_of(x));
    return done;
}

void near_free(near_lists *l)
{
    for (int b = 0; b < l->bodies; b++) sphere_tree_free(&l->tree[b]);
    void *owned[] = { l->soft, l->tree, l->ball, l->gap, l->is_near,
                      l->candidate, l->at,
                      l->listed, l->pair, l->pressed, l->point, l->leaf, l->ahead,
                      l->facet.at, l->facets_before.at };
    for (size_t i = 0; i < sizeof owned / sizeof *owned; i++) free(owned[i]);
    grid_free(&l->grid);
    *l = (near_lists){ .is_stale = true };
}

status rigid_view_add(rigid_view *v, const body *b)
{
    int corners = table_room(b->shape->particles, v->corners);
    int faces = table_room(b->shape->mesh.faces, v->faces);
    bool ok = true;
    v->of = -1;
    if (corners > v->corners) TABLE_GROW(ok, v->corner, 0, corners);
    if (faces > v->faces) TABLE_GROW(ok, v->plane, 0, faces);
    if (!ok) return status_out_of_memory();
    v->corners = corners;
    v->faces = faces;
    return status_ok();
}

void rigid_view_free(rigid_view *v)
{
    free(v->corner);
    free(v->plane);
    *v = (rigid_view){ .of = -1 };
}
//<

//> near-forget
//>   And when a body goes, what names it is forgotten.
// Facets remember on which side of a body they are.
static void forget_facets(facet_list *list, int b)
{
    int kept = 0;
    for (int k = 0; k < list->count; k++)
        if (list->at[k].soft != b && list->at[k].rigid != b)
            list->at[kept++] = list->at[k];
    list->count = kept;
}

void near_forget(near_lists *l, int b)
{
    forget_facets(&l->facet, b);
    l->pairs = l->points = 0;
    l->is_stale = true;
}

void near_remove(near_lists *l, const body *all, int b)
{
    near_forget(l, b);
    if (!body_is_soft(&all[b])) return;
    sphere_tree_free(&l->tree[b]);
    int softs = l->softs;
    l->softs = 0;
    l->soft_particles -= all[b].shape->particles;
    l->margin = HUGE_VAL;
    for (int k = 0; k < softs; k++) {
        if (l->soft[k] == b) continue;
        l->soft[l->softs++] = l->soft[k];
        l->margin = fmin(l->margin, margin_of(&all[l->soft[k]]));
    }
}
//<
