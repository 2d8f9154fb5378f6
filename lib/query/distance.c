//> distance-polytope
#include "distance.h"

#include "exact.h"
#include "nearest.h"

#include <assert.h>
#include <float.h>
#include <stddef.h>

// A corner of A - B: the difference of a vertex of A and one of B.
typedef vertex_pair corner;

// The simplex while we search: its corners, the weights of the point of it
// that is nearest the origin, and that point.
typedef struct {
    int    count;
    corner of[4];
    real   weight[4];
    vec3   nearest;
    int    stalls;      // steps so far that have gained nothing
} search;

// The two bodies, and the power of two that brings A - B to a size whose sixth
// power neither overflows nor underflows.
typedef struct {
    const point_set *a, *b;
    real scale;
    int  measured;      // scale comes from the size: 1 is only a first guess
    real far;           // largest squared length of a corner met so far
    int  near_home;     // both are scanned, and the world's origin is no
                        // further away than 32 times that corner
} pair;

static inline vec3 corner_at(const pair *p, corner c)
{
    return vec3_scale(p->scale, vec3_sub(p->a->at[c.a], p->b->at[c.b]));
}

// A corner is met for the first time: is it the furthest so far?
static inline vec3 corner_meet(pair *p, corner c)
{
    vec3 at = corner_at(p, c);
    real squared = vec3_length_squared(at);
    // Once not a number, never a number again.
    p->far = (squared < p->far ? p->far : squared) + (p->far - p->far);
    return at;
}

// 1 if the squares of lengths are of a size to compute with.  NaN is not.
static int pair_in_range(const pair *p)
{
    return p->far <= 0x1p160 && (p->measured || p->far >= 0x1p-160);
}
//<

//> distance-reduce
// The point of this simplex nearest the origin goes to *s, with those of the
// corners that bear it.
static void search_reduce(search *s, const pair *p, const corner *of, int count)
{
    real w[4];
    vec3 at[4] = { corner_at(p, of[0]) };
    for (int c = 1; c < count; c++) at[c] = corner_at(p, of[c]);
    s->nearest = nearest_of_simplex(at, count, w);
    int kept = 0;
    for (int c = 0; c < count; c++) {
        // Copied first, then kept or not: no branch that nobody can foretell.
        s->of[kept] = of[c];
        s->weight[kept] = w[c];
        kept += w[c] > 0;
    }
    s->count = kept;
}

// 1 if the nearest point is the origin, as far as rounding can tell: nearer
// than a few units in the last place of the furthest corner.
static int search_holds_origin(const search *s, const pair *p)
{
    const real rounding = 4 * DBL_EPSILON;
    return s->count == 4
        || vec3_length_squared(s->nearest) <= rounding * rounding * p->far;
}

static int search_has(const search *s, corner w)
{
    int has = 0;
    for (int c = 0; c < s->count; c++)
        has |= (s->of[c].a == w.a) & (s->of[c].b == w.b);
    return has;
}
//<

//> distance-fan
// What a new corner o sees: the sides e[k] = p[k] - o to the corners that are
// there already, and the faces that two of them span, each with its next.
typedef struct {
    vec3 o, e[3];
    real ee[3], way[3];         // |e|^2; -o . e: how far along e the origin's
                                // foot is, times |e|
    real here[3], after[3];     // weights of the foot on face k: those of p[k]
                                // and of the next, times `whole`
    real whole[3];              // |e[k] x e[k + 1]|^2
} fan;

static inline void fan_side(fan *f, int k, vec3 p)
{
    f->e[k] = vec3_sub(p, f->o);
    f->ee[k] = vec3_length_squared(f->e[k]);
    f->way[k] = -vec3_dot(f->o, f->e[k]);
}

// The foot on the face of e and g is o + a e + b g, and what leads from it to
// the origin is perpendicular to both:
//   a |e|^2 + b e.g = way_e,   a e.g + b |g|^2 = way_g.
// Cramer's rule gives a and b times |e|^2 |g|^2 - (e.g)^2 = |e x g|^2.  They
// are left so: to choose, only their signs are needed, and no division.
static inline void fan_face(fan *f, int k, int n)
{
    real eg = vec3_dot(f->e[k], f->e[n]);
    f->here[k] = f->way[k] * f->ee[n] - f->way[n] * eg;
    f->after[k] = f->way[n] * f->ee[k] - f->way[k] * eg;
    f->whole[k] = f->ee[k] * f->ee[n] - eg * eg;
}

// 1 if the foot lies within face k; on side k between its ends.
static inline int within_face(const fan *f, int k)
{
    return (f->here[k] > 0) & (f->after[k] > 0)
         & (f->here[k] + f->after[k] < f->whole[k]);
}

static inline int within_side(const fan *f, int k)
{
    return (f->way[k] > 0) & (f->way[k] < f->ee[k]);
}
//<

//> distance-keep
// The new simplex is w alone, w and another, or w and two that span its face k.
// 0: rounding has a say in that.
static int keep_corner(search *s, corner w, vec3 at)
{
    s->count = 1;
    s->of[0] = w;
    s->weight[0] = 1;
    s->nearest = at;
    return 1;
}

static int keep_side(search *s, const pair *p, corner other, corner w, vec3 at)
{
    s->count = 2;
    s->of[0] = other;
    s->of[1] = w;
    s->nearest = nearest_of_segment(corner_at(p, other), at, &s->weight[0],
                                    &s->weight[1]);
    return s->weight[0] > 0 && s->weight[1] > 0;
}

static int keep_face(search *s, const fan *f, int k, int n, const corner *of,
                     corner w)
{
    vec3 normal = vec3_cross(f->e[k], f->e[n]);
    s->count = 3;
    s->of[0] = of[k];
    s->of[1] = of[n];
    s->of[2] = w;
    s->weight[0] = f->here[k];
    s->weight[1] = f->after[k];
    s->weight[2] = f->whole[k] - f->here[k] - f->after[k];
    s->nearest = vec3_scale(vec3_dot(normal, f->o)
                            / vec3_length_squared(normal), normal);
    return f->whole[k] >= 0x1p-6 * f->ee[k] * f->ee[n];
}
//<

//> distance-grow-side
// s is a side, and w a third corner.  The foot lies within their face; or
// beyond one side of it, where the weight of the corner across is negative, and
// that side bears the nearest point; or w alone does.  (Beyond the old side it
// lies only if that was not chosen by a search, but is carried, or the first.)
static int grow_side(search *next, const search *s, const pair *p, corner w,
                     vec3 at)
{
    fan f;
    f.o = at;
    fan_side(&f, 0, corner_at(p, s->of[0]));
    fan_side(&f, 1, corner_at(p, s->of[1]));
    fan_face(&f, 0, 1);
    real here = f.here[0], after = f.after[0];
    if (within_face(&f, 0)) return keep_face(next, &f, 0, 1, s->of, w);
    if ((after <= 0) & (f.way[0] > 0))
        return keep_side(next, p, s->of[0], w, at);
    if ((here <= 0) & (f.way[1] > 0))
        return keep_side(next, p, s->of[1], w, at);
    if ((here > 0) & (after > 0))
        return keep_side(next, p, s->of[0], s->of[1], corner_at(p, s->of[1]));
    return keep_corner(next, w, at);
}
//<

//> distance-grow-face
// s is a face, and w a fourth corner.  Of the three faces at w those count that
// the origin sees from outside.  A foot within one of them is the nearest
// point; a foot on a side is, if it lies within neither of the faces there.  No
// face seen: the origin is inside.
static int grow_face(search *next, const search *s, const pair *p, corner w,
                     vec3 at)
{
    static const int after[3] = { 1, 2, 0 }, before[3] = { 2, 0, 1 };
    fan f;
    int seen[3];
    f.o = at;
    for (int k = 0; k < 3; k++) fan_side(&f, k, corner_at(p, s->of[k]));
    for (int k = 0; k < 3; k++) fan_face(&f, k, after[k]);
    real volume = vec3_dot(vec3_cross(f.e[0], f.e[1]), f.e[2]);
    for (int k = 0; k < 3; k++) {
        vec3 normal = vec3_cross(f.e[k], f.e[after[k]]);
        seen[k] = vec3_dot(normal, f.o) * volume >= 0;
    }
    if (!(seen[0] | seen[1] | seen[2])) return 0;
    for (int k = 0; k < 3; k++)
        if (seen[k] & within_face(&f, k))
            return keep_face(next, &f, k, after[k], s->of, w);
    for (int k = 0; k < 3; k++)
        if (within_side(&f, k) & (f.after[k] <= 0) & (f.here[before[k]] <= 0))
            return keep_side(next, p, s->of[k], w, at);
    return keep_corner(next, w, at);
}
//<

//> distance-grow
// s with the new corner w, which no other is before on the way to the origin:
// so w has a share in the new nearest point.  What else has goes to *next.
// 0: rounding may have a say, as in a flat simplex, or so near the origin that
// v is small beside what it is made of; then search_reduce must be asked.
static int search_grow(search *next, const search *s, const pair *p, corner w,
                       vec3 at)
{
    int sure = 0;
    if (s->count == 1) sure = keep_side(next, p, s->of[0], w, at);
    if (s->count == 2) sure = grow_side(next, s, p, w, at);
    if (s->count == 3) sure = grow_face(next, s, p, w, at);
    if (s->count < 2 && !sure) sure = keep_corner(next, w, at);
    return sure && vec3_length_squared(next->nearest) > 0x1p-40 * p->far;
}
//<

//> distance-measure
// The largest coordinate of p, seen from `base`; NaN or infinite if one is.
static real set_extent(point_set p, vec3 base)
{
    real extent = 0, poison = 0;
    for (int i = 0; i < p.count; i++) {
        vec3 r = vec3_sub(p.at[i], base);
        real x = fabs(r.x), y = fabs(r.y), z = fabs(r.z);
        extent = x > extent ? x : extent;
        extent = y > extent ? y : extent;
        extent = z > extent ? z : extent;
        poison += (x - x) + (y - y) + (z - z);
    }
    return extent + poison;
}

// Finds the scale, for bodies so large or small that squares of squares leave
// the range of doubles.  0 if a coordinate is not finite, or a distance could
// be none.
static int pair_measure(pair *p)
{
    vec3 base = p->a->at[0];
    real ea = set_extent(*p->a, base), eb = set_extent(*p->b, base);
    real extent = ea > eb ? ea : eb;
    if (!(ea <= 0x1p1020 && eb <= 0x1p1020)) return 0;
    // The largest double needs 30 steps; the smallest would need 32, but 31 do,
    // and the scale is still a number.
    for (int k = 0; k < 30 && extent * p->scale > 0x1p64; k++)
        p->scale *= 0x1p-32;
    for (int k = 0; k < 31 && extent > 0 && extent * p->scale < 0x1p-64; k++)
        p->scale *= 0x1p32;
    p->measured = 1;
    // What is nearer than 2^-100 of the extent is touching, for smaller numbers
    // would not bear to be scaled: see search_holds_origin.
    p->far = 0x1p-50 * extent * p->scale * (0x1p-50 * extent * p->scale);
    return 1;
}
//<

//> distance-middle
// A large body is sketched by some four dozen of its points, taken evenly.
enum { SKETCH = 48 };

static int sketch_stride(point_set p)
{
    return support_climbs(p) ? (p.count + SKETCH - 1) / SKETCH : 1;
}

// The mean of the points, or of the sketch.
static vec3 middle_of(point_set p)
{
    vec3 sum = p.at[0];
    int stride = sketch_stride(p), seen = 1;
    for (int i = stride; i < p.count; i += stride, seen++)
        sum = vec3_add(sum, p.at[i]);
    return vec3_scale(1 / (real)seen, sum);
}
//<

//> distance-two
// The two points of p furthest along d; the same twice, if there is but one.
static void top_two(point_set p, vec3 d, int two[2])
{
    real best = vec3_dot(d, p.at[0]), next = -HUGE_VAL;
    int first = 0, second = 0;
    for (int i = 1; i < p.count; i++) {
        real along = vec3_dot(d, p.at[i]);
        // Who does not become the first may still become the second.
        real less = along < best ? along : best;
        int lower = along > best ? first : i;
        first = along > best ? i : first;
        best = along > best ? along : best;
        second = less > next ? lower : second;
        next = less > next ? less : next;
    }
    two[0] = first;
    two[1] = second;
}
//<

//> distance-two-climbing
// The same of a large body: a climb from the highest point of the sketch, and
// the highest neighbour of where it ends.
static void top_two_climbing(point_set p, vec3 d, int two[2])
{
    int stride = sketch_stride(p), from = 0;
    real best = vec3_dot(d, p.at[0]), next = -HUGE_VAL;
    for (int i = stride; i < p.count; i += stride) {
        real along = vec3_dot(d, p.at[i]);
        from = along > best ? i : from;
        best = along > best ? along : best;
    }
    int top = support_climb(p, d, from);
    // A coordinate that is not finite will be met again.
    if (top < 0) top = 0;
    two[0] = two[1] = top;
    for (int k = p.ring_start[top]; k < p.ring_start[top + 1]; k++) {
        real along = vec3_dot(d, p.at[p.ring[k]]);
        two[1] = along > next ? p.ring[k] : two[1];
        next = along > next ? along : next;
    }
}

static void first_two(point_set p, vec3 d, int two[2])
{
    if (support_climbs(p)) top_two_climbing(p, d, two);
    else top_two(p, d, two);
}
//<

//> distance-begin
// The corner of A - B furthest along d; -1 where a coordinate is not finite.
// d is of scaled lengths, the vertices are not: scaled once more, its products
// with them are numbers, too.
static inline corner support_along(const pair *p, vec3 d, corner from)
{
    return support_both(p->a, p->b, vec3_scale(p->scale, d), from,
                        p->near_home);
}

// Corners to start from when nothing is known: as seen from middle to middle, A
// has a first and a second vertex, and so has B.  Three of the four differences
// are mostly near to what is sought.
static int corners_first(const pair *p, corner *of)
{
    vec3 d = vec3_sub(middle_of(*p->b), middle_of(*p->a));
    d = vec3_scale(p->scale, vec3_scale(p->scale, d));
    int a[2], b[2];
    first_two(*p->a, d, a);
    first_two(*p->b, vec3_scale(-1, d), b);
    of[0] = (corner){ a[1], b[0] };
    of[1] = (corner){ a[0], b[1] };
    of[2] = (corner){ a[0], b[0] };
    return 3;
}

// The simplex to start from: the carried one, with its points where they are
// now, or the first corners.
static void search_begin(search *s, pair *p, const distance_cache *start)
{
    int count = start ? start->count : 0;
    search all;
    assert(count >= 0 && count <= 4);
    for (int c = 0; c < count; c++) {
        assert(start->a[c] >= 0 && start->a[c] < p->a->count);
        assert(start->b[c] >= 0 && start->b[c] < p->b->count);
        all.of[c] = (corner){ start->a[c], start->b[c] };
    }
    if (count == 0) count = corners_first(p, all.of);
    vec3 at = { 0, 0, 0 };
    for (int c = 0; c < count; c++) at = corner_meet(p, all.of[c]);
    all.count = count - 1;
    if (count == 4 || !search_grow(s, &all, p, all.of[count - 1], at))
        search_reduce(s, p, all.of, count);
    s->stalls = 0;
    vec3 a = vec3_scale(p->scale, p->a->at[0]);
    vec3 b = vec3_scale(p->scale, p->b->at[0]);
    p->near_home = !support_climbs(*p->a) && !support_climbs(*p->b)
        && vec3_length_squared(a) + vec3_length_squared(b) <= 0x1p10 * p->far;
}
//<

//> distance-last-plane
// Near touch v is short and its direction rough.  The plane of three corners
// has a better one.  Looks for such a plane with all of A - B beyond it, and
// away from the origin, where *normal then points.
static int some_plane_parts(pair *p, const corner *of, int count, vec3 *normal)
{
    for (int skip = count == 4 ? 0 : 3; skip < 4 && count > 2; skip++) {
        corner first = of[skip == 0];
        vec3 x = corner_at(p, first), y = corner_at(p, of[1 + (skip <= 1)]);
        vec3 z = corner_at(p, of[2 + (skip <= 2)]);
        vec3 n = cross_of_parallels(vec3_sub(y, x), vec3_sub(z, x));
        if (vec3_dot(n, x) < 0) n = vec3_scale(-1, n);
        corner w = support_along(p, vec3_scale(-1, n), first);
        // A vertex so far behind that its height overflows: nothing is shown.
        if (w.a < 0 || w.b < 0) return 0;
        *normal = n;
        if (vec3_dot(n, corner_meet(p, w)) > 0) return 1;
    }
    return 0;
}
//<

//> distance-stall
// A new corner of little weight may shorten v by less than rounding does, and
// still be on the way: one behind it is nearer by far.  So it is as long as v
// is clearly longer than the bound, v . w / |v|, and has not grown by more than
// rounding.  A few such steps are given a chance.
enum { STALLS_AT_MOST = 8 };

static int is_stall(const pair *p, real vv, real vw, real longer)
{
    const real rounding = 16 * DBL_EPSILON;
    real slip = rounding * sqrt(p->far), length = sqrt(vv);
    return vv - vw > 16 * slip * length && sqrt(longer) <= length + slip;
}
//<

//> distance-careful-step
// How it ended.
typedef struct {
    distance_status status;
    real lower;         // v . w, when beyond the margin
    vec3 normal;        // of a plane that parts them where v does not; or 0
    int  iterations;
} ending;

// The careful way on from s, where v . w is vw, to s with w.
static int step_carefully(pair *p, search *s, search *next, corner w, real vw,
                          ending *end)
{
    real vv = vec3_length_squared(s->nearest);
    s->of[s->count] = w;
    search_reduce(next, p, s->of, s->count + 1);
    real shorter = vec3_length_squared(next->nearest);
    if (next->count == 4 || shorter < vv) return 1;
    next->stalls++;
    if (s->stalls < STALLS_AT_MOST && is_stall(p, vv, vw, shorter)) return 1;
    // Rounding has eaten the rest of the way.
    if (vw <= 0 && some_plane_parts(p, s->of, s->count + 1, &end->normal))
        end->status = DISTANCE_APART;
    return 0;
}
//<

//> distance-loop
// What ends a search: v is at most gap / |v| longer than the distance.
typedef struct {
    real bound;         // of gap / |v|^2
    real margin;        // scaled
    int  cap;
} limits;

// One iteration: asks for the point w furthest towards the origin, and moves on
// to the nearest point of the simplex with w.  1: go on, from *next.  0: over,
// with *s the result and end->status the reason.
static int search_step(pair *p, const limits *until, search *s, search *next,
                       ending *end)
{
    vec3 v = s->nearest;
    real vv = vec3_length_squared(v);
    corner w = support_along(p, vec3_scale(-1, v), s->of[s->count - 1]);
    end->iterations++;
    end->status = DISTANCE_NOT_FINITE;
    if (w.a < 0 || w.b < 0) return 0;
    vec3 at = corner_meet(p, w);
    if (!pair_in_range(p)) return 0;

    // The plane through w with normal v has all of A - B beyond it.
    real vw = vec3_dot(v, at);
    end->status = DISTANCE_BEYOND;
    end->lower = vw;
    if (vw > 0 && vw * vw > until->margin * until->margin * vv) return 0;
    // No plane that parts them will be found: too near to tell.
    end->status = vw > 0 ? DISTANCE_APART : DISTANCE_OVERLAP;
    if (vv - vw <= until->bound * vv || search_has(s, w)) return 0;
    next->stalls = s->stalls;
    if (search_grow(next, s, p, w, at)
        && vec3_length_squared(next->nearest) < vv) return 1;
    return step_carefully(p, s, next, w, vw, end);
}
//<

//> distance-areas
// The area of a corner was made of products with a side and a corner, so it is
// wrong by some roundings of |side| |corner| |n|.  Divided by |n|^2 that is
// small where the triangle is well shaped, and not small for how far off it is.
// Then the areas need only be divided by their sum.
static int areas_are_weights(search *s, const vec3 at[3])
{
    vec3 e = vec3_sub(at[1], at[0]), f = vec3_sub(at[2], at[0]);
    vec3 g = vec3_sub(at[2], at[1]);
    real ee = vec3_length_squared(e), ff = vec3_length_squared(f);
    real gg = vec3_length_squared(g), sum = 0;
    real longest = ee > ff ? ee : ff;
    longest = gg > longest ? gg : longest;
    for (int c = 0; c < 3; c++) sum += s->weight[c];
    if (!(sum >= 0x1p-4 * longest * longest)) return 0;
    if (!(longest >= 0x1p-4 * vec3_length_squared(at[0]))) return 0;
    for (int c = 0; c < 3; c++) s->weight[c] /= sum;
    return 1;
}
//<

//> distance-weigh
// What did to choose becomes weights: the areas of a triangle, and the two
// parts of a segment, which add up to 1 unless it is so short and so far off
// that the distance has rounded them.
static void search_weigh(search *s, const pair *p)
{
    if (s->count == 3) {
        const vec3 at[3] = { corner_at(p, s->of[0]), corner_at(p, s->of[1]),
                             corner_at(p, s->of[2]) };
        if (!areas_are_weights(s, at))
            triangle_weights(at[0], at[1], at[2], s->nearest, s->weight);
    }
    if (s->count == 2
        && fabs(s->weight[0] + s->weight[1] - 1) > 16 * DBL_EPSILON) {
        real sum = s->weight[0] + s->weight[1];
        s->weight[0] /= sum;
        s->weight[1] /= sum;
    }
}
//<

//> distance-run
// From start (NULL: from nowhere), in two simplices that take turns.  Returns
// the one with which the search ended.
static search *search_run(pair *p, const distance_options *options,
                          const distance_cache *start, search two_of[2], ending *end)
{
    limits until = { options->relative_error, options->margin * p->scale,
                     options->cap };
    if (until.bound < DBL_EPSILON) until.bound = DBL_EPSILON;
    search *s = &two_of[0], *next = &two_of[1];
    search_begin(s, p, start);
    *end = (ending){ .status = DISTANCE_NOT_FINITE, .iterations = !start };
    if (!pair_in_range(p)) return s;
    for (;;) {
        end->status = DISTANCE_OVERLAP;
        if (search_holds_origin(s, p)) break;
        end->status = DISTANCE_CAPPED;
        if (end->iterations >= until.cap) break;
        if (!search_step(p, &until, s, next, end)) break;
        search *spare = s;
        s = next;
        next = spare;
    }
    return s;
}
//<

//> distance-points
// The simplex as it is carried on, number by number: a copy as a whole would
// have to wait until its parts, just written, have reached the memory.
static inline void simplex_write(distance_cache *to, const search *s, vec3 axis)
{
    to->count = s->count;
    for (int c = 0; c < 4; c++) {
        int used = c < s->count;
        to->a[c] = used ? s->of[c].a : 0;
        to->b[c] = used ? s->of[c].b : 0;
        to->weight[c] = used ? s->weight[c] : 0;
    }
    to->axis.x = axis.x;
    to->axis.y = axis.y;
    to->axis.z = axis.z;
}

// The point of a body that these vertices and weights make.  Weighted from the
// first vertex on, so that nothing is lost far out.
static inline vec3 weighted(const vec3 *at, const int *vertex,
                            const real *weight, int count)
{
    vec3 base = at[vertex[0]], from = { 0, 0, 0 };
    for (int c = 1; c < count; c++)
        from = vec3_add_scaled(from, weight[c], vec3_sub(at[vertex[c]], base));
    return vec3_add(base, from);
}
//<

//> distance-answer
static distance_result answer(const pair *p, search *s, const ending *end,
                         distance_cache *carried)
{
    const vec3 none = { 0, 0, 0 };
    distance_cache last;
    search_weigh(s, p);
    simplex_write(&last, s, none);
    vec3 on_a = weighted(p->a->at, last.a, last.weight, s->count);
    vec3 on_b = weighted(p->b->at, last.b, last.weight, s->count);
    real back = 1 / p->scale, length = vec3_length(s->nearest);
    real distance = back * length;
    vec3 axis = vec3_scale(back, s->nearest);
    if (end->status == DISTANCE_OVERLAP) {
        distance = 0;
        axis = none;
    } else if (end->status == DISTANCE_BEYOND) {
        distance = back * (end->lower / length);
        last.axis = vec3_scale(1 / length, s->nearest);
    } else if (vec3_length_squared(end->normal) > 0) {
        // As long as v, but along the normal of a plane that parts where v, so
        // short that its direction is rounding, does not.
        real shorten = length / vec3_length(end->normal);
        axis = vec3_scale(back * shorten, end->normal);
    }
    if (carried) simplex_write(carried, s, last.axis);
    return (distance_result){ .status = end->status, .distance = distance,
        .axis = axis, .on_a = on_a, .on_b = on_b, .last = last,
        .iterations = end->iterations };
}
//<

//> distance-least
// The least height of a point along n, measured from the world's origin; NaN
// goes to *poison if one is not finite.  Only a number, no vertex: so there is
// little to choose, and four heights need not wait for each other.
static inline real least_height(const point_set *p, vec3 n, real *poison)
{
    const vec3 *at = p->at;
    real least = HUGE_VAL, sum = 0;
    int i = 0;
    for (; i + 3 < p->count; i += 4) {
        real h0 = vec3_dot(n, at[i]), h1 = vec3_dot(n, at[i + 1]);
        real h2 = vec3_dot(n, at[i + 2]), h3 = vec3_dot(n, at[i + 3]);
        least = real_min(least, real_min(real_min(h0, h1), real_min(h2, h3)));
        sum += (h0 + h1) + (h2 + h3);
    }
    for (; i < p->count; i++) {
        real up = vec3_dot(n, at[i]);
        least = real_min(least, up);
        sum += up;
    }
    *poison += sum - sum;
    return least;
}
//<

//> distance-beyond
// m, a bound of the gap along n: heights are measured from the world's origin,
// and what that may cost, of a body far out, is taken off.
static inline real gap_at_least(const point_set *a, const point_set *b, vec3 n)
{
    real poison = 0;
    real gap = least_height(a, n, &poison)
             + least_height(b, vec3_scale(-1, n), &poison);
    vec3 a0 = a->at[0], b0 = b->at[0];
    real far = fabs(a0.x) + fabs(a0.y) + fabs(a0.z)
             + (fabs(b0.x) + fabs(b0.y) + fabs(b0.z));
    return gap - 4 * DBL_EPSILON * far + poison;
}

// Bodies that were beyond the margin mostly still are, and the axis that parted
// them still does: then nothing else is asked.  (Of large bodies a climb from
// the last corner answers sooner than this.)  The gap, if it shows that; or 0.
static inline real still_beyond(const point_set *a, const point_set *b,
                                real margin, vec3 n)
{
    if (!(vec3_length_squared(n) > 0 && margin < HUGE_VAL)) return 0;
    if (support_climbs(*a) || support_climbs(*b)) return 0;
    real gap = gap_at_least(a, b, n);
    return gap > margin && gap < HUGE_VAL ? gap : 0;
}

static inline distance_result answer_beyond(real gap, const distance_cache *carried)
{
    return (distance_result){ .status = DISTANCE_BEYOND, .distance = gap,
        .axis = vec3_scale(gap, carried->axis), .on_a = { 0, 0, 0 },
        .on_b = { 0, 0, 0 }, .last = *carried, .iterations = 1 };
}
//<

//> distance-foot
// The corners of a carried simplex where they are now, the point of it that is
// nearest the origin, and the weights that make that point.
typedef struct {
    vec3 at[3], nearest;
    real weight[3];
    real far;           // largest squared length of a corner
} foot;

// 1: the nearest point lies well within the face of the three, and the face is
// of good shape, so that the areas are weights: see areas_are_weights.
static inline int foot_on_face(foot *f)
{
    fan n;
    n.o = f->at[2];
    fan_side(&n, 0, f->at[0]);
    fan_side(&n, 1, f->at[1]);
    fan_face(&n, 0, 1);
    real w0 = n.here[0], w1 = n.after[0], w2 = n.whole[0] - w0 - w1;
    real sum = w0 + w1 + w2, longest = real_max(n.ee[0], n.ee[1]);
    longest = real_max(longest,
                       vec3_length_squared(vec3_sub(f->at[1], f->at[0])));
    int is_good = within_face(&n, 0) & (longest >= 0x1p-4 * f->far)
                & (sum >= 0x1p-4 * longest * longest);
    if (!is_good) return 0;
    vec3 normal = vec3_cross(n.e[0], n.e[1]);
    f->nearest = vec3_scale(vec3_dot(normal, n.o)
                            / vec3_length_squared(normal), normal);
    f->weight[0] = w0 / sum;
    f->weight[1] = w1 / sum;
    f->weight[2] = w2 / sum;
    return 1;
}

// The same of a side, and of a corner alone.
static inline int foot_on_side(foot *f)
{
    real *w = f->weight;
    f->nearest = nearest_of_segment(f->at[0], f->at[1], &w[0], &w[1]);
    w[2] = 0;
    return (w[0] > 0) & (w[1] > 0)
         & (fabs(w[0] + w[1] - 1) <= 16 * DBL_EPSILON);
}

static inline int foot_on_corner(foot *f)
{
    f->nearest = f->at[0];
    f->weight[0] = 1;
    f->weight[1] = f->weight[2] = 0;
    return 1;
}

static inline int foot_find(foot *f, const point_set *a, const point_set *b,
                            const distance_cache *s)
{
    f->far = 0;
    for (int c = 0; c < s->count; c++) {
        assert(s->a[c] >= 0 && s->a[c] < a->count);
        assert(s->b[c] >= 0 && s->b[c] < b->count);
        f->at[c] = vec3_sub(a->at[s->a[c]], b->at[s->b[c]]);
        f->far = real_max(vec3_length_squared(f->at[c]), f->far);
    }
    if (s->count == 3) return foot_on_face(f);
    if (s->count == 2) return foot_on_side(f);
    return foot_on_corner(f);
}
//<

//> distance-still
// 1 if no corner of A - B is lower along v than the lowest of the carried ones.
// The carried heights are found among the others, made of the same numbers in
// the same order: so they are compared bit by bit.
static inline int is_lowest(const point_set *a, const point_set *b,
                            const distance_cache *s, vec3 v)
{
    real poison = 0;
    vec3 back = vec3_scale(-1, v);
    real least_a = least_height(a, v, &poison);
    real least_b = least_height(b, back, &poison);
    int is_one = 0;
    for (int c = 0; c < s->count; c++) {
        real height_a = vec3_dot(v, a->at[s->a[c]]);
        real height_b = vec3_dot(back, b->at[s->b[c]]);
        is_one |= (height_a == least_a) & (height_b == least_b);
    }
    return is_one & (poison == 0);
}

// Mostly the corners of the last time still are those that matter.  1 if this
// is certain, no rounding has a say in it, and the distance is not beyond the
// margin; 0: ask the search.  *f is their foot.
static inline int still_nearest(const point_set *a, const point_set *b,
                                real margin, const distance_cache *s, foot *f)
{
    if (s->count < 1 || s->count > 3) return 0;
    if (support_climbs(*a) || support_climbs(*b)) return 0;
    if (!foot_find(f, a, b, s)) return 0;
    real vv = vec3_length_squared(f->nearest);
    real home = vec3_length_squared(a->at[0]) + vec3_length_squared(b->at[0]);
    int in_range = (f->far <= 0x1p160) & (f->far >= 0x1p-160);
    int is_plain = in_range & (vv > 0x1p-40 * f->far) & (vv <= margin * margin)
                 & (home <= 0x1p10 * f->far);
    return is_plain && is_lowest(a, b, s, f->nearest);
}
//<

//> distance-answer-again
// All is named and written where it stays: what is copied waits until it has
// reached the memory.
static inline distance_result answer_again(const point_set *a, const point_set *b,
                                      const foot *f, distance_cache *s)
{
    const real *w = f->weight;
    for (int c = 0; c < 3; c++) s->weight[c] = w[c];
    s->axis.x = s->axis.y = s->axis.z = 0;
    return (distance_result){ .status = DISTANCE_APART,
        .distance = vec3_length(f->nearest), .axis = f->nearest,
        .on_a = weighted(a->at, s->a, w, s->count),
        .on_b = weighted(b->at, s->b, w, s->count),
        .last = { .count = s->count,
                  .a = { s->a[0], s->a[1], s->a[2], 0 },
                  .b = { s->b[0], s->b[1], s->b[2], 0 },
                  .weight = { w[0], w[1], w[2], 0 }, .axis = { 0, 0, 0 } },
        .iterations = 1 };
}
//<

//> distance-distance
distance_options distance_options_default(void)
{
    return (distance_options){ .relative_error = 0, .margin = HUGE_VAL, .cap = 64 };
}

static distance_result search_result(const point_set *a, const point_set *b,
                                const distance_options *options, distance_cache *carried)
{
    pair p = { .a = a, .b = b, .scale = 1 };
    search two_of[2];
    ending end;
    const distance_cache *start = carried && carried->count > 0 ? carried : NULL;
    search *s = search_run(&p, options, start, two_of, &end);
    if (end.status != DISTANCE_NOT_FINITE) return answer(&p, s, &end, carried);
    // Out of range: bodies of strange size, or coordinates that are no numbers.
    if (pair_measure(&p)) s = search_run(&p, options, start, two_of, &end);
    // What is not finite may be met late: what was found until then goes.
    if (end.status != DISTANCE_NOT_FINITE) return answer(&p, s, &end, carried);
    return (distance_result){ .status = end.status, .iterations = end.iterations };
}

static distance_result distance_of(const point_set *a, const point_set *b,
                              const distance_options *options, distance_cache *carried)
{
    foot f;
    if (carried && still_nearest(a, b, options->margin, carried, &f))
        return answer_again(a, b, &f, carried);
    return search_result(a, b, options, carried);
}

distance_result distance_find(point_set a, point_set b, distance_options options,
                        distance_cache *carried)
{
    assert(a.count >= 1 && b.count >= 1);
    assert(options.relative_error >= 0 && options.relative_error < 1);
    assert(options.margin >= 0 && options.cap >= 1);
    if (carried) {
        real gap = still_beyond(&a, &b, options.margin, carried->axis);
        if (gap > 0) return answer_beyond(gap, carried);
    }
    return distance_of(&a, &b, &options, carried);
}
//<
