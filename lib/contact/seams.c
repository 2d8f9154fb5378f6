//> seams-side
//>   What a slider touches: a side of a piece, or of a plane.
#include "seams.h"
#include "manifold.h"
#include "table.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

// The cosine of 0.8 degrees: normals nearer to each other are those of one side.
static const real ALIKE = 0.9999;           // tuned, 1

enum { FEW_SIDES = 64, MOST_SIDES = 2048, MOST_CORNERS = 256 };

// Body A touches B, which is a body or a plane (< 0), along n.
typedef struct {
    cache_pair *pair;
    contact *contact;
    int  b;
    vec3 n;             // unit, from B to A
    real height;        // m, of B's highest point of touch along n
    int  points;
    vec3 at[CONTACT_POINTS];    // m, on B's surface
    bool is_new;        // found in this frame, and B is a floor for A
    bool is_left;       // A touched it before this frame, and does no more
    bool is_spent;      // what it carried then was handed on
    bool is_covered, is_hidden;
    bool is_merged;     // a floor was sought for it
} side;

// Body A, and all that it touches.
typedef struct {
    contact_cache *c;
    const cache_frame *f;
    int  a, sides, room;
    side *side;         // [room]
    int  *of;           // [room] those of one floor
} slider;

static vec3 normal_to(const slider *s, const contact *t)
{
    return t->piece_a == s->a ? t->normal : vec3_scale(-1, t->normal);
}

// The face of the body that looks most along n; -1: it has none.  *most: the square
// of the cosine.
static int face_towards(const collider *x, vec3 n, real *most)
{
    int best = -1;
    *most = 0;
    for (int k = 0; k < x->shape->mesh.faces; k++) {
        vec3 m = face_area(x->shape, x->at, k);
        real along = vec3_dot(m, n), square = vec3_dot(m, m);
        if (!(along > 0 && along * along > *most * square)) continue;
        *most = along * along / square;
        best = k;
    }
    return best;
}

// Its contact seen from A.
static void find_side_points(const slider *s, side *x)
{
    const contact *t = x->contact;
    bool is_a = t->piece_a == s->a;
    x->n = normal_to(s, t);
    x->height = x->b < 0 ? s->f->plane[-1 - x->b].offset : -HUGE_VAL;
    x->points = 0;
    for (int k = 0; k < t->count && x->b >= 0; k++) {
        const contact_point *p = &t->point[k];
        vec3 at = frame_point(&s->c->placed[x->b],
                              is_a ? p->local_b : p->local_a);
        at = vec3_add_scaled(at, is_a ? t->round_b : t->round_a, x->n);
        x->at[x->points++] = at;
        x->height = real_max(x->height, vec3_dot(at, x->n));
    }
}
//<

//> seams-hold
//>   Three questions to a piece: how high does it reach, does it stand out
//>   further than that, and does a point lie in it?
// m, of body b along n, with what is round of it.
static real rise_over(const slider *s, int b, vec3 n)
{
    collider x = cache_collider(s->c, s->f, b);
    return vec3_dot(x.at[hull_scan(query_hull(&x), n)], n) + x.shape->round;
}

// Does body or plane b reach higher than that along n?  (Its ball answers most.)
static bool juts_out(const slider *s, int b, vec3 n, real height)
{
    if (b < 0) return vec3_dot(s->f->plane[-1 - b].normal, n) < ALIKE;
    real center = vec3_dot(s->f->now[b].frame.center, n);
    return center + s->f->now[b].radius > height
        && rise_over(s, b, n) > height;
}

// Is p in body or plane b, or outside by no more than flush?  (A round body
// hides nothing.)
static bool holds_point(const slider *s, int b, vec3 p, real flush)
{
    if (b < 0) {
        plane w = s->f->plane[-1 - b];
        return vec3_dot(w.normal, p) <= w.offset + flush;
    }
    collider x = cache_collider(s->c, s->f, b);
    real far = s->f->now[b].radius + flush;
    vec3 d = vec3_sub(p, s->f->now[b].frame.center);
    if (x.shape->round > 0 || !(vec3_length_squared(d) <= far * far))
        return false;
    for (int k = 0; k < x.shape->mesh.faces; k++) {
        vec3 m = face_area(x.shape, x.at, k);
        real over = vec3_dot(m, vec3_sub(p, x.at[x.shape->face[3 * k]]));
        if (over > 0 && over * over > flush * flush * vec3_dot(m, m))
            return false;
    }
    return true;
}
//<

//> seams-rules
// m: pieces whose faces are off by no more lie flush.  A contact that bears gives
// way by as much, so a step of that height is not met.
static real flush_of(const slider *s, int b)
{
    real radius = s->f->now[s->a].radius;
    return CONTACT_GIVES * (b < 0 ? radius : real_min(radius, s->f->now[b].radius));
}

// m: what moves by no more in a frame counts as where it was, here as where
// vertices are placed.
static real stays_within(const slider *s)
{
    return s->f->stay * s->f->now[s->a].radius;
}

// m, what a corner of B goes as B turns in the frame.
static real turns_of(const slider *s, int b)
{
    return b < 0 ? 0 : s->f->ahead[b].angle * s->f->now[b].radius;
}

// Do B and C stay as they lie to each other in this frame?  What a driven blade
// hides now, it hides no more when it has gone on.
static bool stay_together(const slider *s, int b, int c)
{
    const cache_frame *f = s->f;
    vec3 delta = f->ahead[b].delta;
    if (c >= 0) {
        if (f->body[b].family > 0 && f->body[b].family == f->body[c].family)
            return true;
        delta = vec3_sub(delta, f->ahead[c].delta);
    }
    return vec3_length(delta) + turns_of(s, b) + turns_of(s, c)
           <= stays_within(s);
}

// Behind: all of B lies behind the plane in which A touches C.  C keeps A away
// from B, unless it lies behind B's plane as well.
static bool is_behind(const slider *s, const side *b, const side *c)
{
    real flush = flush_of(s, b->b);
    return vec3_dot(b->n, c->n) < ALIKE && stay_together(s, b->b, c->b)
        && !juts_out(s, b->b, c->n, c->height + flush)
        && juts_out(s, c->b, b->n, b->height + flush);
}

// From p so far (m) towards the middle of a face, and no further.
static vec3 inwards(const collider *x, int face, vec3 p, real far)
{
    const int *v = &x->shape->face[3 * face];
    vec3 sum = vec3_add(vec3_add(x->at[v[0]], x->at[v[1]]), x->at[v[2]]);
    vec3 delta = vec3_sub(vec3_scale(1.0 / 3, sum), p);
    real length = vec3_length(delta);
    return length > far ? vec3_add_scaled(p, far / length, delta)
                        : vec3_add(p, delta);
}

// Covered: all points in which A touches B lie in C, or on it, and so does the side
// of B there; and C stands out further: there is no such side.  (Beside the crease of a
// valley a point of one side lies on the other as well.  The middle of a triangle is
// seen from its corner at 30 degrees from its sides: four times flush inwards it is
// twice flush from both.)
static bool is_covered(const slider *s, const side *b, int c)
{
    real flush = flush_of(s, b->b), most;
    if (!stay_together(s, b->b, c)) return false;
    if (!juts_out(s, c, b->n, b->height + flush)) return false;
    for (int k = 0; k < b->points; k++)
        if (!holds_point(s, c, b->at[k], flush)) return false;
    collider x = cache_collider(s->c, s->f, b->b);
    int face = face_towards(&x, b->n, &most);
    for (int k = 0; k < b->points && face >= 0; k++)
        if (!holds_point(s, c, inwards(&x, face, b->at[k], 4 * flush), flush))
            return false;
    return b->points > 0;
}

static bool is_covered_by_any(const slider *s, const side *b)
{
    for (int i = 0; i < s->sides; i++)
        if (s->side[i].b != b->b && !s->side[i].is_left
            && is_covered(s, b, s->side[i].b)) return true;
    return false;
}

static bool is_behind_any(const slider *s, const side *b)
{
    for (int i = 0; i < s->sides; i++)
        if (s->side[i].b != b->b && is_behind(s, b, &s->side[i])) return true;
    return false;
}
//<

//> seams-along
//>   A contact that is found again is one along a given normal.
// The point of a face of x that looks along m, over or under p.
static bool project_on_face(const collider *x, vec3 m, vec3 p, feature_point *foot)
{
    for (int k = 0; k < x->shape->mesh.faces; k++) {
        const int *v = &x->shape->face[3 * k];
        real w[3], sum = 0;
        if (!face_is_along(x->shape, x->at, k, m)) continue;
        for (int i = 0; i < 3; i++) {
            vec3 e = vec3_sub(x->at[v[(i + 1) % 3]], p);
            vec3 g = vec3_sub(x->at[v[(i + 2) % 3]], p);
            w[i] = vec3_dot(m, vec3_cross(e, g));
            sum += w[i];
        }
        if (!(real_min(w[0], real_min(w[1], w[2])) >= -1e-9 * sum)) continue;
        *foot = (feature_point){ 3, { v[0], v[1], v[2] },
                                 { w[0] / sum, w[1] / sum, w[2] / sum } };
        return true;
    }
    return false;
}

// The touches of a and b along m (from b to a): those of the patches at their
// tips, or where one's tip is over a face of the other.  count 0: it is not.
static manifold touches_along(const collider *a, const collider *b, vec3 m,
                              real margin, real turn)
{
    int tip_a = hull_scan(query_hull(a), vec3_scale(-1, m));
    int tip_b = hull_scan(query_hull(b), m);
    query_result r = { true, m, { { 1, { tip_a }, { 1 } },
                                  { 1, { tip_b }, { 1 } }, 0 } };
    feature_point foot;
    bool is_over = true;
    if (project_on_face(b, m, a->at[tip_a], &foot))
        r.at.b = foot;
    else if (project_on_face(a, vec3_scale(-1, m), b->at[tip_b], &foot))
        r.at.a = foot;
    else is_over = b->shape->particles == 1;
    vec3 apart = vec3_sub(feature_at(&r.at.a, a->at), feature_at(&r.at.b, b->at));
    r.at.gap = vec3_dot(m, apart) - query_round(a, b);
    manifold found = manifold_find(a, b, &r, margin, turn);
    if (found.count == 1 && !is_over) found.count = 0;
    return found;
}

// m, as far as the bodies of a contact may come nearer until they are asked.
static real contact_reach(const slider *s, const contact *x)
{
    const cache_frame *f = s->f;
    real slack = f->stay * (f->now[x->piece_a].radius + f->now[x->piece_b].radius);
    return f->ahead[x->piece_a].reach + f->ahead[x->piece_b].reach + 2 * slack;
}

// The same for the bodies of contact x, when its a has gone its way of the frame
// across m, as b sees it: where they will touch.
static manifold find_along(const slider *s, const contact *x, vec3 m)
{
    const cache_frame *f = s->f;
    collider a = cache_collider(s->c, f, x->piece_a);
    collider b = cache_collider(s->c, f, x->piece_b);
    vec3 moved[MOST_CORNERS];
    if (a.shape->particles > MOST_CORNERS) return (manifold){ .count = 0 };
    vec3 delta = vec3_sub(f->ahead[x->piece_a].delta, f->ahead[x->piece_b].delta);
    delta = vec3_add_scaled(delta, -vec3_dot(delta, m), m);
    for (int v = 0; v < a.shape->particles; v++)
        moved[v] = vec3_add(a.at[v], delta);
    a.at = moved;
    return touches_along(&a, &b, m, contact_reach(s, x),
                         f->ahead[x->piece_a].angle + f->ahead[x->piece_b].angle);
}
//<

//> seams-take
//>   The contact gets other points, and the load that it had.
// Each point of what was hands its impulse to the nearest, as contact_inherit
// does; none, if the normal was further off than that (a cosine).
static bool carry_load(const slider *s, const side *x, const cache_pair *p,
                       real alike)
{
    contact *t = x->contact;
    if (p->was < 0) return false;
    const contact *was = &s->c->was[p->was];
    bool is_a = t->piece_a == s->a, was_a = was->piece_a == s->a;
    real sign = is_a == was_a ? 1 : -1;
    if (t->count == 0
        || !(vec3_dot(t->normal, vec3_scale(sign, was->normal)) >= alike))
        return false;
    for (int k = 0; k < was->count; k++) {
        const contact_point *old = &was->point[k];
        vec3 local = was_a ? old->local_a : old->local_b;
        t->impulse[contact_nearest(t, is_a, local)] += was->impulse[k];
    }
    t->friction = vec3_add_scaled(t->friction, sign, was->friction);
    t->twist += was->twist;
    return true;
}

static void take_manifold(const slider *s, side *x, const manifold *m)
{
    contact *t = x->contact;
    cache_take(t, m, s->f, false);
    find_side_points(s, x);
    contact_clear(t);
    carry_load(s, x, x->pair, CONTACT_SAME);
}

static bool aim(const slider *s, side *x, vec3 m)
{
    vec3 to_a = x->contact->piece_a == s->a ? m : vec3_scale(-1, m);
    manifold found = find_along(s, x->contact, to_a);
    if (found.count > 0) take_manifold(s, x, &found);
    return found.count > 0;
}

// m, how far A and B are apart along m; < 0: they overlap.
static real apart_along(const slider *s, int b, vec3 m)
{
    return -rise_over(s, s->a, vec3_scale(-1, m)) - rise_over(s, b, m);
}
//<

//> seams-face
//>   Which face of B, if the one that was met is covered? The one that A is
//>   furthest outside of.
static real best_face(const slider *s, const side *x, vec3 *best)
{
    collider b = cache_collider(s->c, s->f, x->b);
    real most = -HUGE_VAL;
    for (int k = 0; k < b.shape->mesh.faces; k++) {
        vec3 m = vec3_unit(face_area(b.shape, b.at, k));
        if (vec3_dot(m, x->n) > ALIKE) continue;
        real apart = apart_along(s, x->b, m);
        if (apart > most) most = apart, *best = m;
    }
    return most;
}

static bool aim_at_face(const slider *s, side *x)
{
    vec3 m;
    return best_face(s, x, &m) > -CONTACT_DEEP * s->f->now[s->a].radius
        && aim(s, x, m) && !is_covered_by_any(s, x);
}
//<

//> seams-mend
//>   What is hidden is found again along another normal, or left out.
// Along the normal of what holds A away from B; of several, of that which holds
// it furthest.
static bool find_holder(const slider *s, const side *x, vec3 *n)
{
    real most = -HUGE_VAL;
    for (int i = 0; i < s->sides; i++) {
        const side *c = &s->side[i];
        if (c->b == x->b || c->is_hidden || !is_behind(s, x, c)) continue;
        real apart = apart_along(s, x->b, c->n);
        if (apart > most) most = apart, *n = c->n;
    }
    return most > -HUGE_VAL;
}

static void drop(side *x)
{
    x->contact->count = x->points = 0;
    x->pair->count = 0;
    x->pair->is_active = x->pair->passes;
}

// What overlaps by more than what bears may give way is parted where it is met: no
// other contact has kept it out.
static bool is_deep_in(const slider *s, const side *x)
{
    return apart_along(s, x->b, x->n) < -flush_of(s, x->b);
}

// (What hides a side that would be met later may turn the body to it.)
static void correct_side(const slider *s, side *x)
{
    vec3 n;
    bool is_held = find_holder(s, x, &n);
    x->pair->passes |= x->pair->seen[0] < 0 && (is_held || x->is_covered);
    if (is_held) {
        if (!aim(s, x, n)) drop(x);
    } else if (x->is_covered) {
        if (!aim_at_face(s, x) && !is_deep_in(s, x)) drop(x);
    }
    x->pair->count = (signed char)x->contact->count;
}

// First all that is hidden is found, then mended: no side hides another that is
// hidden itself, whatever their order.
static void correct_sides(slider *s)
{
    for (int i = 0; i < s->sides; i++) {
        side *x = &s->side[i];
        x->is_covered = x->is_new && is_covered_by_any(s, x);
        x->is_hidden = x->is_covered || (x->is_new && is_behind_any(s, x));
    }
    for (int i = 0; i < s->sides; i++)
        if (s->side[i].is_hidden)
            correct_side(s, &s->side[i]);
}
//<

//> seams-merge
//>   Pieces of one body in one plane under A are one floor: A touches that plane,
//>   in one contact.
// May x be merged with others?  (What comes down fast has points of its own.)
static bool is_floor(const slider *s, const side *x)
{
    vec3 delta = s->f->ahead[s->a].delta;
    return x->is_new && x->points > 0 && !s->f->moves[x->b]
        && s->f->body[x->b].family > 0
        && -vec3_dot(delta, x->n) <= s->f->body[s->a].inner;
}

// All sides in the plane of the first; returns how many.
static int find_floor(const slider *s, int first, int *of)
{
    int n = 0, family = s->f->body[s->side[first].b].family;
    const side *x = &s->side[first];
    for (int i = first; i < s->sides; i++) {
        const side *y = &s->side[i];
        if (is_floor(s, y) && s->f->body[y->b].family == family
            && vec3_dot(x->n, y->n) > ALIKE
            && fabs(x->height - y->height) <= flush_of(s, x->b)) of[n++] = i;
    }
    return n;
}

// Does p lie over a piece whose top is that of x's floor?  (A touches it there even
// if the side that was met is another one, which is hidden.)
static bool is_over(const slider *s, const side *x, vec3 p)
{
    int family = s->f->body[x->b].family;
    feature_point foot;
    for (int i = 0; i < s->sides; i++) {
        int b = s->side[i].b;
        if (b < 0 || s->f->body[b].family != family) continue;
        collider piece = cache_collider(s->c, s->f, b);
        if (project_on_face(&piece, x->n, p, &foot)
            && fabs(rise_over(s, b, x->n) - x->height) <= flush_of(s, x->b))
            return true;
    }
    return false;
}

// Contact x with the floor's plane.  (Its points are given to the one piece,
// whichever they lie over: the pieces move as one.)
static void take_plane(const slider *s, side *x, const manifold *m)
{
    contact *t = x->contact;
    collider a = cache_collider(s->c, s->f, s->a);
    const rigid_frame *floor = &s->c->placed[x->b];
    bool is_a = t->piece_a == s->a;
    t->count = m->count;
    t->is_ahead = false;
    t->is_floor = true;
    *(is_a ? &t->round_a : &t->round_b) = m->round_a;
    *(is_a ? &t->round_b : &t->round_a) = 0;
    for (int k = 0; k < m->count; k++) {
        const feature_point *of = &m->point[k].a;
        real down = m->point[k].gap + m->round_a;
        vec3 own = cache_local(s->f->body[s->a].rigid, of);
        vec3 foot = vec3_add_scaled(feature_at(of, a.at), -down, x->n);
        foot = frame_local(floor, vec3_sub(foot, floor->center));
        t->point[k] = (contact_point){ is_a ? own : foot, is_a ? foot : own, is_a };
    }
    x->pair->count = (signed char)t->count;
}

// What pieces of this floor carried that A touches no more.
static void carry_left(const slider *s, const side *x)
{
    int family = s->f->body[x->b].family;
    for (int i = 0; i < s->sides; i++) {
        side *y = &s->side[i];
        bool is_gone = y->is_left || (y->is_new && y->points == 0
                                      && !y->pair->is_merged);
        if (!is_gone || y->is_spent || s->f->body[y->b].family != family)
            continue;
        y->is_spent = carry_load(s, x, y->pair, ALIKE);
    }
}

// And what those have that A touches.
static void carry_floor(const slider *s, const side *x, const int *of, int n)
{
    contact_clear(x->contact);
    for (int k = 0; k < n; k++)
        carry_load(s, x, s->side[of[k]].pair, ALIKE);
    carry_left(s, x);
}

// Puts the piece first that A leaves last: the floor's contact is with that, and
// hands its load on for as long as A is near it.
static void begin_with_last(const slider *s, int *of, int n)
{
    vec3 delta = s->f->ahead[s->a].delta;
    int best = 0;
    real most = -HUGE_VAL;
    for (int k = 0; k < n; k++) {
        real far = vec3_dot(delta, s->c->placed[s->side[of[k]].b].center);
        if (far > most) most = far, best = k;
    }
    SWAP(int, of[0], of[best]);
}

// Not where a corner lies over no piece: there the floor ends.
static void merge_floor(slider *s, int *of, int n)
{
    begin_with_last(s, of, n);
    side *x = &s->side[of[0]];
    collider a = cache_collider(s->c, s->f, s->a);
    manifold m = manifold_on_plane(&a, x->n, x->height,
                                   contact_reach(s, x->contact),
                                   s->f->ahead[s->a].angle);
    for (int k = 0; k < m.count; k++)
        if (!is_over(s, x, feature_at(&m.point[k].a, a.at))) return;
    if (m.count == 0) return;
    take_plane(s, x, &m);
    carry_floor(s, x, of, n);
    for (int i = 1; i < n; i++) {
        drop(&s->side[of[i]]);
        s->side[of[i]].pair->is_merged = true;
    }
}

static void merge_floors(slider *s)
{
    int *of = s->of;
    for (int i = 0; i < s->sides; i++) {
        if (s->side[i].is_merged || !is_floor(s, &s->side[i])) continue;
        int n = find_floor(s, i, of);
        for (int k = 0; k < n; k++) s->side[of[k]].is_merged = true;
        if (n > 1) merge_floor(s, of, n);
        else       carry_left(s, &s->side[i]);
    }
}
//<

//> seams-straighten
//>   A body that rocks a little on a floor touches it along its own face or the
//>   floor's, by turns.
// Where A, as it stands, lies lowest over face k of B along m, that face's normal.
static bool find_lowest(const slider *s, const side *x, int k, vec3 m,
                        manifold *lowest)
{
    collider a = cache_collider(s->c, s->f, s->a);
    collider b = cache_collider(s->c, s->f, x->b);
    feature_point foot;
    *lowest = manifold_on_plane(&a, m, vec3_dot(m, b.at[b.shape->face[3 * k]]),
                                contact_reach(s, x->contact),
                                s->f->ahead[s->a].angle);
    for (int i = 0; i < lowest->count; i++)
        if (!project_on_face(&b, m, feature_at(&lowest->point[i].a, a.at), &foot))
            return false;
    return lowest->count > 0;
}

// A cylinder was asked as a prism, and over an edge of the floor the normal of that
// leans.  Where the cylinder lies lowest over a face, the normal is the face's: no
// points of both are nearer.  So it is where it is asked ahead, as a coin that leans
// and rolls over many edges is.
static bool lay_cylinder(const slider *s, side *x, int face, vec3 m)
{
    contact *t = x->contact;
    const contact was = *t;
    manifold lowest;
    if (!(s->f->body[s->a].shape->rim > 0) || s->f->moves[x->b]
        || !find_lowest(s, x, face, m, &lowest)) return false;
    x->n = m;
    t->normal = t->piece_a == s->a ? m : vec3_scale(-1, m);
    take_plane(s, x, &lowest);
    contact_inherit(t, &was);
    return true;
}

// Rule 0.  The normal of a floor's face, if it is that up to 0.8 degrees, is the
// normal: so pieces that lie flush have one and the same, as a plane has.  (Not
// that of a floor that turns in the frame.)
static void straighten(const slider *s, side *x)
{
    collider b = cache_collider(s->c, s->f, x->b);
    contact *t = x->contact;
    real most;
    if (b.shape->round > 0 || turns_of(s, x->b) > stays_within(s)) return;
    int best = face_towards(&b, x->n, &most);
    if (best < 0) return;
    vec3 m = vec3_unit(face_area(b.shape, b.at, best));
    if (lay_cylinder(s, x, best, m)) return;
    if (most > ALIKE * ALIKE) x->n = m;
    t->normal = t->piece_a == s->a ? x->n : vec3_scale(-1, x->n);
}
//<

//> seams-lists
//>   Whose contacts are which?
int seams_slider(const cache_frame *f, int a, int b)
{
    if (b < 0) return a;
    bool is_free_a = f->moves[a] && !f->now[a].is_driven;
    bool is_free_b = f->moves[b] && !f->now[b].is_driven;
    if (is_free_a && is_free_b) {
        if (2 * f->now[a].radius < f->now[b].radius) return a;
        return 2 * f->now[b].radius < f->now[a].radius ? b : -1;
    }
    return is_free_a ? a : is_free_b ? b : -1;
}

// Pieces whose points a neighbour's contact has can still cover.
static bool is_met(const cache_pair *p)
{
    return p->entry >= 0 && (p->count > 0 || p->is_merged);
}

// A floor that was touched until this frame, and is no more.
static bool is_left(const cache_pair *p)
{
    return p->was >= 0 && p->count == 0;
}

bool seams_is_on_floor(const cache_frame *f, const cache_pair *p)
{
    return p->is_asked && p->count > 0 && p->key[1] >= 0
        && seams_slider(f, p->key[0], p->key[1]) >= 0;
}

// Calls with `do_write` false count; then places are known.
static void list_met(contact_cache *c, const cache_frame *f, bool do_write)
{
    for (int k = 0; k < c->pairs.count; k++) {
        const cache_pair *p = &c->pairs.pair[k];
        if (!is_met(p) && !is_left(p)) continue;
        for (int i = 0; i < 2; i++) {
            int b = p->key[i];
            if (b < 0 || !f->moves[b]) continue;
            if (do_write) c->met[c->last[b]] = k;
            c->last[b]++;
        }
    }
}

static void find_lists(contact_cache *c, const cache_frame *f)
{
    int sum = 0;
    for (int k = 0; k < f->awakes; k++) c->last[f->awake[k]] = 0;
    list_met(c, f, false);
    for (int k = 0; k < f->awakes; k++) {
        int b = f->awake[k], count = c->last[b];
        c->first[b] = c->last[b] = sum;
        sum += count;
    }
    list_met(c, f, true);
}
//<

//> seams
//>   So each body that slides sees to its own contacts, and no two of them to
//>   the same: all may be asked at once.
// Contacts of which another body is the slider belong to that.
static void add_side(slider *s, int k)
{
    contact_cache *c = s->c;
    cache_pair *p = &c->pairs.pair[k];
    contact *t = &c->entry[p->entry].contact;
    int b = t->piece_b < 0 ? t->piece_b : t->piece_a == s->a ? t->piece_b : t->piece_a;
    int owner = seams_slider(s->f, t->piece_a, t->piece_b);
    if (owner >= 0 && owner != s->a) return;
    side *x = &s->side[s->sides++];
    *x = (side){ .pair = p, .contact = t, .b = b,
                 .is_new = owner == s->a && seams_is_on_floor(s->f, p),
                 .is_left = owner == s->a && is_left(p),
                 .n = normal_to(s, t) };
}

static void correct_slider(slider *s)
{
    contact_cache *c = s->c;
    for (int i = c->first[s->a]; i < c->last[s->a] && s->sides < s->room; i++)
        add_side(s, c->met[i]);
    for (int i = 0; i < s->sides; i++)
        if (s->side[i].is_new) straighten(s, &s->side[i]);
    if (s->sides < 2) return;
    for (int i = 0; i < s->sides; i++) find_side_points(s, &s->side[i]);
    correct_sides(s);
    merge_floors(s);
}

// What lies on many parts of a surface has more sides than others have room for.
// Where memory is refused, it has as many as they.
static void correct_large(slider *s, int sides)
{
    int room = int_min(sides, MOST_SIDES);
    side *more = malloc((size_t)room * sizeof *more);
    int *of = malloc((size_t)room * sizeof *of);
    if (more && of) {
        s->side = more;
        s->of = of;
        s->room = room;
    }
    correct_slider(s);
    free(more);
    free(of);
}

// Has body a come on a side of a floor in this frame?  If not, its seams are as they
// were.
static bool has_new_side(const contact_cache *c, const cache_frame *f, int a)
{
    for (int i = c->first[a]; i < c->last[a]; i++) {
        const cache_pair *p = &c->pairs.pair[c->met[i]];
        if (seams_is_on_floor(f, p)
            && seams_slider(f, p->key[0], p->key[1]) == a) return true;
    }
    return false;
}

static void correct_body_seams(contact_cache *c, const cache_frame *f, int a)
{
    side few[FEW_SIDES];
    int of[FEW_SIDES], sides = c->last[a] - c->first[a];
    slider s = { c, f, a, 0, FEW_SIDES, few, of };
    if (!f->moves[a] || !has_new_side(c, f, a)) return;
    if (f->has_parts && sides > FEW_SIDES) correct_large(&s, sides);
    else correct_slider(&s);
}

static void correct_chunk(void *data, int item)
{
    const cache_work *m = data;
    int end = task_end(item, m->f->awakes);
    for (int k = task_first(item); k < end; k++)
        correct_body_seams(m->c, m->f, m->f->awake[k]);
}

void seams_correct(contact_cache *c, const cache_frame *f)
{
    cache_work m = { c, f, 0 };
    bool is_any = false;
    for (int k = 0; k < c->pairs.count && !is_any; k++)
        is_any = seams_is_on_floor(f, &c->pairs.pair[k]);
    if (!is_any) return;
    if (!TABLE_RENEW(c->met, c->met_capacity, 2 * c->pairs.count)) {
        c->lost++;
        return;
    }
    find_lists(c, f);
    tasks_run(f->run, correct_chunk, &m, task_chunks(f->awakes));
}
//<
