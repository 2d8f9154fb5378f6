//> certificate-parts
//>   A cloth is halved, its halves are, and so on down to its cells. Each part
//>   has a box at both ends, but for the smallest.
#include "certificate.h"
#include "gjk.h"
#include "table.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum { FEW = 4 };       // cells of a part that has no boxes within

// A look at the ways from where all was to where it is; if it is no first look,
// witnesses that held at first are only asked whether they hold now.
typedef struct {
    certificate *c;
    const soft_frame *f;
    const near_lists *near;     // what rigid bodies it may meet; NULL: none
    rigid_view *view;
    const cell_range *in;       // NULL, or nothing else is looked at
    int from;                   // the end that is asked first
} frame_search;

static int cells_in(cell_range r)
{
    return (r.right - r.left) * (r.bottom - r.top);
}

static cell_part whole_soft(const frame_search *l, int b)
{
    const body *x = &l->f->body[b];
    return (cell_part){ { b, 0, 0, x->shape->columns - 1, x->shape->rows - 1 },
                   2 * x->first };
}

// The boxes of a part's first half follow its own, and then those of the other:
// of n cells there are at most 2 n - 1.
static void halve(cell_part p, cell_part half[2])
{
    cell_range r = p.cells;
    half[0] = half[1] = p;
    if (r.right - r.left >= r.bottom - r.top)
        half[0].cells.right = half[1].cells.left = (r.left + r.right) / 2;
    else
        half[0].cells.bottom = half[1].cells.top = (r.top + r.bottom) / 2;
    bool are_boxed = cells_in(r) > FEW;
    half[0].box = are_boxed ? p.box + 1 : -1;
    half[1].box = are_boxed ? p.box + 2 * cells_in(half[0].cells) : -1;
}

static int vertex_at(const frame_search *l, int b, int column, int row)
{
    const body *x = &l->f->body[b];
    return x->first + row * x->shape->columns + column;
}
//<

//> certificate-boxes
//>   Most parts are nowhere near each other: their boxes say so.
static aabb box_cells(const frame_search *l, cell_range r, int e)
{
    const vec3 *at = l->c->at[e], *first = &at[vertex_at(l, r.body, r.left, r.top)];
    aabb box = { *first, *first };
    for (int j = r.top; j <= r.bottom; j++) {
        const vec3 *x = &at[vertex_at(l, r.body, 0, j)];
        for (int i = r.left; i <= r.right; i++) box = aabb_with(box, x[i]);
    }
    return box;
}

static void box_part(const frame_search *l, cell_part p)
{
    cell_part half[2];
    swept_box *box = &l->c->box[p.box];
    halve(p, half);
    for (int k = 0; k < 2 && half[0].box >= 0; k++) box_part(l, half[k]);
    for (int e = 0; e < ENDS; e++)
        box->at[e] = half[0].box < 0 ? box_cells(l, p.cells, e)
                   : aabb_join(l->c->box[half[0].box].at[e],
                               l->c->box[half[1].box].at[e]);
}

// By how much, and along which axis?  m, 0: not.
static real gap_of_boxes(const frame_search *l, cell_part a, cell_part b, vec3 *n)
{
    const aabb *x = l->c->box[a.box].at, *y = l->c->box[b.box].at;
    vec3 over = vec3_min(vec3_sub(x[0].low, y[0].high),
                         vec3_sub(x[1].low, y[1].high));
    vec3 under = vec3_min(vec3_sub(y[0].low, x[0].high),
                          vec3_sub(y[1].low, x[1].high));
    vec3 gap = vec3_max(over, under);
    real most = real_max(real_max(gap.x, gap.y), gap.z);
    *n = (vec3){ 0, 0, 0 };
    if (most == gap.x)      n->x = over.x > under.x ? 1 : -1;
    else if (most == gap.y) n->y = over.y > under.y ? 1 : -1;
    else                    n->z = over.z > under.z ? 1 : -1;
    return real_max(most, 0);
}

static bool is_certified(const soft_frame *f, int b)
{
    return body_is_soft(&f->body[b]) && f->body[b].shape->rows > 1;
}

// Only if they are asked for.
static void box_all(const frame_search *l)
{
    const soft_frame *f = l->f;
    for (int n = 0; n < f->softs && !l->c->is_boxed; n++)
        if (is_certified(f, f->soft[n])) box_part(l, whole_soft(l, f->soft[n]));
    l->c->is_boxed = true;
}
//<

//> certificate-spread
//>   Most pairs of triangles that are near each other are neighbours in a cloth.
//>   Those of a patch need no planes of their own: if a projection spreads it
//>   out, it gives every pair one.
// The projection (x, y) is the one that makes the mean cell a square, at the
// middle of the frame: times a number > 0.
static bool projection_of(const frame_search *l, cell_range r, vec3 normal[2])
{
    vec3 along = { 0, 0, 0 }, down = along;
    for (int e = 0; e < ENDS; e++) {
        const vec3 *at = l->c->at[e];
        vec3 a = at[vertex_at(l, r.body, r.left, r.top)];
        vec3 b = at[vertex_at(l, r.body, r.right, r.top)];
        vec3 c = at[vertex_at(l, r.body, r.left, r.bottom)];
        vec3 d = at[vertex_at(l, r.body, r.right, r.bottom)];
        vec3 cross = vec3_sub(d, a), back = vec3_sub(b, c);
        along = vec3_add(along, vec3_add(cross, back));
        down = vec3_add(down, vec3_sub(cross, back));
    }
    along = vec3_scale(1.0 / (r.right - r.left), along);
    down = vec3_scale(1.0 / (r.bottom - r.top), down);
    real ee = vec3_dot(along, along), ef = vec3_dot(along, down);
    real ff = vec3_dot(down, down), det = ee * ff - ef * ef;
    real size = 1 / det;
    if (!(det > 0 && size < HUGE_VAL)) return false;
    normal[0] = vec3_add_scaled(vec3_scale(ff * size, along), -ef * size, down);
    normal[1] = vec3_add_scaled(vec3_scale(ee * size, down), -ef * size, along);
    return true;
}

typedef struct {
    real x, y;
} flat_point;

static flat_point flat_less(flat_point a, flat_point b)
{
    return (flat_point){ a.x - b.x, a.y - b.y };
}

// What is surely over 0 is over it by this share of what the mean cell has:
// rounding is far less.
static const real SURELY = 0x1p-20;

// The least w . J w of any w of length 1 is no less: see the chapter.
static real spread_of(flat_point e, flat_point f)
{
    real mixed = f.x + e.y, sum = e.x + f.y;
    return sum > 0 ? (e.x * f.y - 0.25 * mixed * mixed) / sum : 0;
}

static flat_point flat_of(const vec3 normal[2], vec3 x)
{
    return (flat_point){ vec3_dot(normal[0], x), vec3_dot(normal[1], x) };
}

// The least of the cells of a row, from one column to before another.
static real row_spread(const vec3 *upper, const vec3 *under, int left,
                          int right, int row, const vec3 normal[2])
{
    real least = HUGE_VAL;
    flat_point a = flat_of(normal, upper[left]);
    flat_point c = flat_of(normal, under[left]);
    for (int i = left; i < right && least > SURELY; i++) {
        flat_point b = flat_of(normal, upper[i + 1]);
        flat_point d = flat_of(normal, under[i + 1]);
        flat_point above = flat_less(b, a), below = flat_less(d, c);
        flat_point before = flat_less(c, a), after = flat_less(d, b);
        bool is_odd = (i + row) % 2;        // see shape_cut_cells
        least = real_min(least, spread_of(above, is_odd ? before : after));
        least = real_min(least, spread_of(below, is_odd ? after : before));
        a = b;
        c = d;
    }
    return least;
}

static cell_range range_around(cell_range a, cell_range b)
{
    return (cell_range){ a.body, int_min(a.left, b.left), int_min(a.top, b.top),
                         int_max(a.right, b.right),
                         int_max(a.bottom, b.bottom) };
}

static void keep_witness(const frame_search *l, const witness *w)
{
    certificate *c = l->c;
    if (c->keeps < c->room) c->kept[c->keeps] = *w;
    c->keeps++;
}

// m, not above 0: it is not spread out.  If two vertices go from each other by
// d, then w . J w changes by no more than sqrt(2 (p . p + q . q)) d.
static real slack_of_spread(const frame_search *l, cell_range r,
                            const vec3 normal[2])
{
    real least = HUGE_VAL;
    for (int j = r.top; j < r.bottom; j++) {
        int upper = vertex_at(l, r.body, 0, j);
        int under = vertex_at(l, r.body, 0, j + 1);
        for (int e = l->from; e < ENDS && least > SURELY; e++) {
            const vec3 *at = l->c->at[e];
            least = real_min(least, row_spread(at + upper, at + under, r.left,
                                               r.right, j, normal));
        }
    }
    return (least - SURELY) / sqrt(2 * (vec3_length_squared(normal[0])
                                        + vec3_length_squared(normal[1])));
}

// The range around two parts.
static bool is_spread_out(const frame_search *l, witness_kind kind, cell_part a,
                          cell_part b)
{
    witness w = { .kind = kind, .set = { { .part = a }, { .part = b } } };
    cell_range r = range_around(a.cells, b.cells);
    if (!projection_of(l, r, w.normal)) return false;
    w.slack = slack_of_spread(l, r, w.normal);
    if (!(w.slack > 0)) return false;
    keep_witness(l, &w);
    return true;
}
//<

//> certificate-windows
//>   A window is a part with two columns and rows more, so that parts that touch
//>   are together in one. What is no patch is tried in halves.
static void mark_window(const frame_search *l, cell_range r, int right,
                        int bottom)
{
    for (int j = r.top; j < r.bottom; j++)
        for (int i = r.left; i < r.right; i++) {
            certified_vertex *v = &l->c->of[vertex_at(l, r.body, i, j)];
            v->right = right;
            v->bottom = bottom;
        }
}

static void find_windows(const frame_search *l, cell_part p)
{
    enum { MORE = 2 };
    cell_part half[2], all = whole_soft(l, p.cells.body), window = p;
    window.cells.right = int_min(p.cells.right + MORE, all.cells.right);
    window.cells.bottom = int_min(p.cells.bottom + MORE, all.cells.bottom);
    if (is_spread_out(l, WITNESS_WINDOW, p, window)) {
        mark_window(l, p.cells, window.cells.right, window.cells.bottom);
        return;
    }
    mark_window(l, p.cells, 0, 0);
    if (cells_in(p.cells) <= FEW) return;
    halve(p, half);
    for (int k = 0; k < 2; k++) find_windows(l, half[k]);
}

// Is there a window that has all of it?
static bool is_in_window(const frame_search *l, cell_range r)
{
    const certified_vertex *v
        = &l->c->of[vertex_at(l, r.body, r.left, r.top)];
    return r.right <= v->right && r.bottom <= v->bottom;
}
//<

//> certificate-planes
//>   Small parts that are not together in a patch, and at last two triangles,
//>   are parted by a plane. A short search for the point of their differences
//>   that is nearest to the origin (Gilbert 1966) mostly finds one. If it finds
//>   none, parts are halved; for triangles GJK tells exactly.
typedef struct {
    vec3 x;
    real height;
} lowest;

static void lower_to(lowest *to, vec3 x, vec3 n)
{
    real height = vec3_dot(n, x);
    if (height < to->height) *to = (lowest){ x, height };
}

// What is furthest against n.
static vec3 lowest_of(const frame_search *l, int e, const certified_set *s,
                      vec3 n)
{
    const vec3 *at = l->c->at[e];
    lowest low = { { 0, 0, 0 }, HUGE_VAL };
    cell_range r = s->part.cells;
    if (s->part.box >= 0) {
        const aabb *b = &l->c->box[s->part.box].at[e];
        return vec3_make(n.x > 0 ? b->low.x : b->high.x,
                         n.y > 0 ? b->low.y : b->high.y,
                         n.z > 0 ? b->low.z : b->high.z);
    }
    for (int i = 0; i < s->count; i++) lower_to(&low, at[s->vertex[i]], n);
    for (int j = r.top; j <= r.bottom && s->count == 0; j++) {
        const vec3 *x = &at[vertex_at(l, r.body, 0, j)];
        for (int i = r.left; i <= r.right; i++) lower_to(&low, x[i], n);
    }
    return low.x;
}

// How far is the first set over the second, along n, and where least?
static real gap_of(const frame_search *l, const certified_set set[2], int ends,
                   vec3 n, vec3 *where)
{
    real gap = HUGE_VAL;
    for (int e = l->from; e < ends; e++) {
        vec3 d = vec3_sub(lowest_of(l, e, &set[0], n),
                          lowest_of(l, e, &set[1], vec3_scale(-1, n)));
        real height = vec3_dot(n, d);
        if (!(height < gap)) continue;
        gap = height;
        *where = d;
    }
    return gap < HUGE_VAL ? gap : 0;
}

// Of triangles, and exactly: unit.
static vec3 nearest_difference(const frame_search *l, const certified_set set[2],
                               int ends)
{
    vec3 d[ENDS * FACET * FACET], origin = { 0, 0, 0 };
    int count = 0;
    for (int e = 0; e < ends; e++)
        for (int i = 0; i < set[0].count; i++)
            for (int k = 0; k < set[1].count; k++)
                d[count++] = vec3_sub(l->c->at[e][set[0].vertex[i]],
                                      l->c->at[e][set[1].vertex[k]]);
    gjk_result g = gjk_distance((hull){ d, count }, (hull){ &origin, 1 },
                                HUGE_VAL, NULL);
    return vec3_unit(g.axis);
}

static vec3 middle_of_set(const frame_search *l, const certified_set *s)
{
    cell_range r = s->part.cells;
    int first = s->vertex[0], last = s->vertex[int_max(s->count - 1, 0)];
    if (s->count == 0) {
        first = vertex_at(l, r.body, r.left, r.top);
        last = vertex_at(l, r.body, r.right, r.bottom);
    }
    const vec3 *was = l->c->at[0], *is = l->c->at[1];
    return vec3_add(vec3_add(was[first], was[last]),
                    vec3_add(is[first], is[last]));
}

// m, not above 0: it does not part them.
static real slack_of_plane(const frame_search *l, const certified_set set[2],
                           vec3 n, vec3 *where)
{
    return gap_of(l, set, ENDS, n, where) / vec3_length(n) - l->c->rounding;
}

static bool keep_plane(const frame_search *l, const certified_set set[2], vec3 n,
                       real slack)
{
    witness w = { WITNESS_PLANE, { set[0], set[1] }, { n }, slack };
    if (!(slack > 0)) return false;
    keep_witness(l, &w);
    return true;
}

static bool has_plane(const frame_search *l, const certified_set set[2])
{
    enum { STEPS = 8 };
    vec3 least = { 0, 0, 0 };
    vec3 n = vec3_sub(middle_of_set(l, &set[0]), middle_of_set(l, &set[1]));
    for (int k = 0; k < STEPS; k++) {
        if (keep_plane(l, set, n, slack_of_plane(l, set, n, &least)))
            return true;
        vec3 back = vec3_sub(n, least);
        real fraction = vec3_dot(n, back) / vec3_length_squared(back);
        if (!(fraction > 0)) break;
        n = vec3_add_scaled(n, -real_min(fraction, 1), back);
    }
    if (set[0].count == 0 || set[1].count == 0) return false;
    n = nearest_difference(l, set, ENDS);
    return keep_plane(l, set, n, slack_of_plane(l, set, n, &least));
}
//<

//> certificate-triangles
//>   What has no plane will be parted; what had none when the frame began is
//>   left out.
static void leave_out(const frame_search *l, const certified_set set[2])
{
    l->c->left_out++;
    for (int i = 0; i < 2 * FACET; i++) {
        const certified_set *s = &set[i / FACET];
        if (i % FACET < s->count) l->c->of[s->vertex[i % FACET]].crossed = true;
    }
}

// More clash than there are vertices: no move of them parts so many.
static bool clashes_too_much(const certificate *c)
{
    return c->clashes > c->vertices;
}

static bool is_beside_crossed(const frame_search *l, const certified_set *s)
{
    bool some = false;
    for (int i = 0; i < s->count; i++) some |= l->c->of[s->vertex[i]].crossed;
    return some;
}

static void part_facets(const frame_search *l, certified_set a, certified_set b)
{
    certificate *c = l->c;
    certified_set set[2] = { a, b };
    if (clashes_too_much(c) || has_plane(l, set)) return;
    vec3 where, n = nearest_difference(l, set, 1);
    real gap = gap_of(l, set, 1, n, &where);
    bool is_crossed = !(gap > c->rounding);
    if (is_crossed) leave_out(l, set);
    if (is_crossed || (is_beside_crossed(l, &a) && is_beside_crossed(l, &b))) {
        witness w = { .kind = WITNESS_NONE, .set = { a, b } };
        keep_witness(l, &w);
        return;
    }
    if (c->clashes < c->particles)
        c->clash[c->clashes] = (facet_clash){ { a, b }, n, gap };
    c->clashes++;
}

static certified_set triangle_of(const frame_search *l, cell_range r, int k)
{
    const body *b = &l->f->body[r.body];
    int cell = r.top * (b->shape->columns - 1) + r.left;
    certified_set s = { .part = { r, -1 }, .count = FACET };
    for (int i = 0; i < FACET; i++)
        s.vertex[i] = b->first + b->shape->face[FACET * (2 * cell + k) + i];
    return s;
}

// What of a is no vertex of b.
static certified_set without(certified_set a, const certified_set *b)
{
    certified_set rest = { .part = a.part };
    for (int i = 0; i < a.count; i++) {
        bool is_common = false;
        for (int k = 0; k < b->count; k++)
            is_common |= a.vertex[i] == b->vertex[k];
        if (!is_common) rest.vertex[rest.count++] = a.vertex[i];
    }
    return rest;
}

// Triangles that share a vertex meet there: the other edge of one must not meet
// the other.  Two that share an edge meet nowhere else, but where they lie flat
// on each other.
static void part_triangles(const frame_search *l, certified_set a,
                           certified_set b)
{
    certified_set x = without(a, &b), y = without(b, &a);
    if (x.count == 1) return;
    part_facets(l, x, b);
    if (x.count < FACET) part_facets(l, a, y);
}

static void part_cells(const frame_search *l, cell_range a, cell_range b)
{
    bool is_one = a.body == b.body && a.left == b.left && a.top == b.top;
    for (int i = 0; i < 2; i++)
        for (int k = is_one ? i + 1 : 0; k < 2; k++)
            part_triangles(l, triangle_of(l, a, i), triangle_of(l, b, k));
}
//<

//> certificate-look
//>   All pairs of triangles are looked at, from the largest parts down.
static bool are_parted(const frame_search *l, cell_part p, cell_part q)
{
    cell_range a = p.cells, b = q.cells;
    certified_set set[2] = { { .part = p }, { .part = q } };
    vec3 n;
    if (a.body == b.body && is_in_window(l, range_around(a, b))) return true;
    box_all(l);
    if (p.box >= 0 && q.box >= 0) {
        real gap = gap_of_boxes(l, p, q, &n);
        if (keep_plane(l, set, n, gap - l->c->rounding)) return true;
    }
    if (int_max(cells_in(a), cells_in(b)) > FEW) return false;
    bool do_touch = a.body == b.body && a.left <= b.right && b.left <= a.right
                 && a.top <= b.bottom && b.top <= a.bottom;
    if (do_touch) return is_spread_out(l, WITNESS_SPREAD, p, q);
    set[0].part.box = set[1].part.box = -1;
    return has_plane(l, set);
}

static bool is_in_search(const frame_search *l, cell_range r)
{
    return !l->in
        || (r.left < l->in->right && l->in->left < r.right
            && r.top < l->in->bottom && l->in->top < r.bottom);
}

static void search_between(const frame_search *l, cell_part a, cell_part b)
{
    cell_part half[2];
    int cells = cells_in(a.cells), others = cells_in(b.cells);
    if (clashes_too_much(l->c) || !is_in_search(l, a.cells)
        || !is_in_search(l, b.cells) || are_parted(l, a, b)) return;
    if (cells == 1 && others == 1) {
        part_cells(l, a.cells, b.cells);
        return;
    }
    halve(cells >= others ? a : b, half);
    for (int k = 0; k < 2; k++)
        search_between(l, cells >= others ? half[k] : a,
                       cells >= others ? b : half[k]);
}

static void search_within(const frame_search *l, cell_part p)
{
    cell_part half[2];
    if (!is_in_search(l, p.cells) || is_in_window(l, p.cells)) return;
    if (cells_in(p.cells) < FEW && is_spread_out(l, WITNESS_SPREAD, p, p))
        return;
    if (cells_in(p.cells) == 1) {
        part_cells(l, p.cells, p.cells);
        return;
    }
    halve(p, half);
    for (int k = 0; k < 2; k++) search_within(l, half[k]);
    search_between(l, half[0], half[1]);
}

static bool is_same_range(cell_range a, cell_range b)
{
    return a.body == b.body && a.left == b.left && a.right == b.right
        && a.top == b.top && a.bottom == b.bottom;
}

static bool is_asked(const frame_search *l, int a, int b)
{
    const soft_frame *f = l->f;
    return is_certified(f, a) && is_certified(f, b)
        && (soft_moves(f, a) || soft_moves(f, b)) && soft_meets(f, a, b);
}

// Pairs that no plane parts are in `clash` afterwards.  What found no room in
// the last look may find some in this.
static void search_all(const frame_search *l)
{
    certificate *c = l->c;
    const int *soft = l->f->soft, softs = l->f->softs;
    TABLE_RENEW(c->kept, c->room, c->keeps);
    c->clashes = c->left_out = c->keeps = 0;
    c->is_boxed = false;
    for (int n = 0; n < softs; n++)
        if (is_asked(l, soft[n], soft[n])) find_windows(l, whole_soft(l, soft[n]));
    for (int n = 0; n < softs; n++)
        for (int m = 0; m <= n; m++) {
            int a = soft[m], b = soft[n];
            if (!is_asked(l, a, b)) continue;
            if (a == b) search_within(l, whole_soft(l, b));
            else        search_between(l, whole_soft(l, a), whole_soft(l, b));
        }
    c->made = c->keeps;
    if (clashes_too_much(c)) c->keeps = 0;
}
//<

//> certificate-again
//>   A moment later most witnesses still hold, and to ask one is far cheaper
//>   than to find it: only its other end is new. Most have so much room that
//>   they need not even be asked. What one has lost is proved again.
static real path_difference(const vec3 *from, const vec3 *to, int a, int b)
{
    return vec3_length_squared(vec3_sub(vec3_sub(to[a], from[a]),
                                        vec3_sub(to[b], from[b])));
}

// m^2; each vertex keeps the ways to the next of its row and of its column.
static real path_difference_beside(const vec3 *from, const vec3 *to, const body *x,
                                   real *beside)
{
    int columns = x->shape->columns, n = columns * x->shape->rows;
    real most = 0;
    for (int i = 0; i < n; i++) {
        int v = x->first + i;
        real delta = 0;
        if ((i + 1) % columns > 0) delta = path_difference(from, to, v, v + 1);
        if (i + columns < n)
            delta = real_max(delta, path_difference(from, to, v, v + columns));
        beside[v] = delta;
        most = real_max(most, delta);
    }
    return most;
}

// How far have they gone from each other, from there to where they are?
static void measure_paths(const frame_search *l, const vec3 *from)
{
    certificate *c = l->c;
    aabb ways = aabb_empty();
    real most = 0;
    for (int n = 0; n < l->f->softs; n++) {
        const body *x = &l->f->body[l->f->soft[n]];
        if (!is_certified(l->f, l->f->soft[n])) continue;
        most = real_max(most, path_difference_beside(from, c->at[1], x,
                                                     c->beside));
        for (int v = x->first; v < x->first + body_particles(x); v++)
            ways = aabb_with(ways, vec3_sub(c->at[1][v], from[v]));
    }
    c->apart = vec3_distance(ways.low, ways.high);
    c->bent = sqrt(most);
}

// m: so far went neighbours of a range, at most.
static real largest_path_difference(const frame_search *l, cell_range r)
{
    real most = 0;
    for (int j = r.top; j <= r.bottom; j++) {
        const real *delta = &l->c->beside[vertex_at(l, r.body, 0, j)];
        for (int i = r.left; i <= r.right; i++) most = real_max(most, delta[i]);
    }
    return sqrt(most);
}

// Neighbours' ways differ by little, and those of others by no more than the
// sum from neighbour to neighbour.  A patch asks its own: where cloth lies, it
// stays one, whatever swings elsewhere.
static real witness_path(const frame_search *l, const witness *w)
{
    const certificate *c = l->c;
    cell_range a = w->set[0].part.cells, b = w->set[1].part.cells;
    cell_range r = range_around(a, b);
    if (w->kind == WITNESS_SPREAD || w->kind == WITNESS_WINDOW)
        return largest_path_difference(l, r);
    if (a.body != b.body) return c->apart;
    int steps = r.right - r.left + r.bottom - r.top;
    return real_min(c->apart, steps * c->bent);
}

static bool witness_holds(const frame_search *now, witness *w)
{
    vec3 where;
    w->slack -= witness_path(now, w);
    if (w->slack > 0) return true;
    if (w->kind == WITNESS_PLANE) {
        box_all(now);
        w->slack = slack_of_plane(now, w->set, w->normal[0], &where);
    } else {
        cell_range r = range_around(w->set[0].part.cells, w->set[1].part.cells);
        w->slack = slack_of_spread(now, r, w->normal);
    }
    return w->slack > 0;
}

static void prove_again(const frame_search *l, const witness *w)
{
    cell_part a = w->set[0].part, b = w->set[1].part;
    frame_search inside = *l;
    inside.in = &b.cells;
    if (w->kind == WITNESS_LOST)
        search_within(&inside, whole_soft(l, b.cells.body));
    else if (w->set[0].count > 0) part_facets(l, w->set[0], w->set[1]);
    else if (w->kind == WITNESS_SPREAD && is_same_range(a.cells, b.cells))
        search_within(l, a);
    else search_between(l, a, b);
}

// Smaller windows are found for one of the first n that is none now.
static void search_windows(const frame_search *l, const frame_search *now, int n)
{
    certificate *c = l->c;
    for (int k = 0; k < n; k++) {
        witness *w = &c->kept[k];
        if (w->kind != WITNESS_WINDOW || witness_holds(now, w)) continue;
        w->kind = WITNESS_LOST;
        w->set[0].part.box = -1;
        find_windows(l, w->set[0].part);
    }
}

// What clashed has no witness, and is asked as well.
static void search_clashes(const frame_search *l, int n)
{
    certificate *c = l->c;
    c->clashes = 0;
    for (int k = 0; k < n; k++) {
        facet_clash x = c->clash[k];
        part_facets(l, x.set[0], x.set[1]);
    }
}

static bool is_witness_lost(const witness *w)
{
    if (w->kind == WITNESS_WINDOW) return false;
    return w->kind == WITNESS_LOST || !(w->slack > 0);
}

// Of the first n those that hold, and behind them those found now, move up.
static void move_up(certificate *c, int n)
{
    int held = 0, all = int_min(c->keeps, c->room);
    for (int k = 0; k < all; k++)
        if (k >= n || !is_witness_lost(&c->kept[k])) {
            if (held < k) c->kept[held] = c->kept[k];
            held++;
        }
    if (c->keeps <= c->room) c->keeps = held;
}

// Where it is hopeless, all that was kept stays, to be asked of another end.
static void check_kept(const frame_search *l)
{
    certificate *c = l->c;
    int n = c->keeps, clashed = clashes_too_much(c) ? 0 : c->clashes;
    frame_search now = *l;
    now.from = ENDS - 1;
    c->left_out = 0;
    c->is_boxed = false;
    search_clashes(l, clashed);
    search_windows(l, &now, n);
    int windows = c->keeps;
    for (int k = 0; k < n; k++) {
        witness *w = &c->kept[k];
        if (w->kind == WITNESS_WINDOW) continue;
        if (clashes_too_much(c))         w->slack -= witness_path(l, w);
        else if (w->kind == WITNESS_LOST || !witness_holds(&now, w)) prove_again(l, w);
    }
    if (clashes_too_much(c)) c->keeps = clashed > 0 ? 0 : windows;
    else                move_up(c, n);
}

// Is what is kept about what is asked for, and not worn to pieces?  Whatever else
// changes who meets whom makes the lists stale, see certificate_begin.
static bool may_check_kept(const frame_search *l)
{
    const certificate *c = l->c;
    bool are_same_awake = true;
    for (int n = 0; n < l->f->softs; n++) {
        int b = l->f->soft[n];
        certified_vertex *first = &c->of[l->f->body[b].first];
        bool moves = soft_moves(l->f, b);
        are_same_awake &= first->moved == moves;
        first->moved = moves;
    }
    return are_same_awake && c->keeps > 0
        && c->keeps <= int_min(c->room, 2 * c->made);
}
//<

//> certificate-bodies
//>   A facet and a rigid body are parted as the body sees it: it stands, and the
//>   facet comes from where the body has carried its beginning. The plane of
//>   chapter 04 between the body and both ends, edges and all, is the witness.
static int patch_of(certificate *c, int v)
{
    while (c->of[v].patch != v) {
        c->of[v].patch = c->of[c->of[v].patch].patch;
        v = c->of[v].patch;
    }
    return v;
}

// Where the body stands at an end: its frame has four vectors, as it has particles.
static rigid_frame frame_at(const certificate *c, const body *b, int e)
{
    const vec3 *x = &c->at[e][b->first];
    return (rigid_frame){ x[0], { x[1], x[2], x[3] } };
}

static void put_frame(certificate *c, const soft_frame *f, int b, int e)
{
    rigid_frame now = soft_rigid_frame(f, b);
    vec3 *x = &c->at[e][f->body[b].first];
    x[0] = now.center;
    for (int k = 0; k < FOUR_AXES; k++) x[k + 1] = now.axis[k];
}

// From where all began to where the body has carried it.
static vec3 carried_along(const certificate *c, const body *b, vec3 x)
{
    if (body_is_fixed(b)) return x;
    rigid_frame was = frame_at(c, b, 0), is = frame_at(c, b, 1);
    return frame_point(&is, frame_local(&was, vec3_sub(x, was.center)));
}

// (What a round body only turns past, it does not take along: so the way of its
// centre is asked, too.)
static bool has_body_plane(const frame_search *l, const certified_set *s,
                           const body *b, int *ahead)
{
    const certificate *c = l->c;
    vec3 at[ENDS * FACET];
    vec3 delta = vec3_sub(c->at[1][b->first], c->at[0][b->first]);
    for (int turns = !body_is_fixed(b); turns >= 0; turns--) {
        for (int k = 0; k < FACET; k++) {
            vec3 was = c->at[0][s->vertex[k]];
            at[k] = c->at[1][s->vertex[k]];
            at[FACET + k] = turns ? carried_along(c, b, was) : vec3_add(was, delta);
        }
        if (obstacle_is_apart(&l->view->hull, at, ENDS * FACET, ahead))
            return true;
    }
    return false;
}

static void part_from_body(const frame_search *l, certified_set s, int b,
                           int *ahead)
{
    certificate *c = l->c;
    const obstacle *solid = &l->view->hull;
    vec3 at[FACET];
    const body *soft = &l->f->body[s.part.cells.body];
    if (has_body_plane(l, &s, &l->f->body[b], ahead)) return;
    for (int k = 0; k < FACET; k++) at[k] = c->at[1][s.vertex[k]];
    c->of[soft->first].is_cut |= !obstacle_is_apart(solid, at, FACET, ahead);
    int with = c->of[patch_of(c, s.vertex[0])].rides;
    for (int k = 0; k < FACET; k++)
        at[k] = carried_along(c, &l->f->body[b], c->at[0][s.vertex[k]]);
    gjk_result g = gjk_distance((hull){ at, FACET }, solid->vertices,
                                HUGE_VAL, NULL);
    vec3 n = vec3_unit(g.axis);
    real gap = g.distance - solid->round, top = -HUGE_VAL;
    // It was in it, or another body has it.
    if (!(gap > c->rounding) || (with >= 0 && with != b)) {
        c->left_out++;
        return;
    }
    for (int k = 0; k < solid->vertices.count; k++)
        top = real_max(top, vec3_dot(n, solid->vertices.at[k]) + solid->round);
    if (c->cuts < c->particles) c->cut[c->cuts] = (facet_cut){ s, b, n, top, gap };
    c->cuts++;
}

// So far from where it was, at most, the body has been in the way.
static aabb swept_by_body(const frame_search *l, int b)
{
    const body *x = &l->f->body[b];
    const obstacle *solid = &l->view->hull;
    aabb box = aabb_empty();
    real far = 0;
    for (int k = 0; k < solid->vertices.count; k++)
        box = aabb_with(box, solid->vertices.at[k]);
    rigid_frame was = frame_at(l->c, x, 0), is = frame_at(l->c, x, 1);
    for (int k = 0; k < FOUR; k++)
        far = real_max(far, vec3_distance(vec3_add(was.center, frame_arm(&was, k)),
                                          vec3_add(is.center, frame_arm(&is, k))));
    return aabb_wider(box, solid->round + 2 * far);
}

static void search_body(const frame_search *l, const aabb *swept, cell_part p, int b,
                        int *ahead)
{
    cell_part half[2];
    const aabb *box = p.box >= 0 ? l->c->box[p.box].at : NULL;
    if (box) {
        aabb all = aabb_join(box[0], box[1]);
        if (!aabbs_meet(&all, swept)) return;
    }
    if (cells_in(p.cells) == 1) {
        for (int k = 0; k < 2; k++)
            part_from_body(l, triangle_of(l, p.cells, k), b, ahead);
        return;
    }
    halve(p, half);
    for (int k = 0; k < 2; k++) search_body(l, swept, half[k], b, ahead);
}

static void search_links(const frame_search *l, const aabb *swept, int a, int b,
                         int *ahead)
{
    const body *x = &l->f->body[a];
    for (int k = 0; k < x->shape->sticks; k++) {
        certified_set s = { .part = { { .body = a }, -1 }, .count = FACET };
        aabb link = aabb_empty();
        facet_corners(x, k, s.vertex);
        for (int i = 0; i < ENDS * FACET; i++)
            link = aabb_with(link, l->c->at[i / FACET][s.vertex[i % FACET]]);
        if (aabbs_meet(&link, swept)) part_from_body(l, s, b, ahead);
    }
}

static void search_bodies(const frame_search *l)
{
    certificate *c = l->c;
    const soft_frame *f = l->f;
    c->cuts = 0;
    for (int n = 0; n < f->softs; n++)
        c->of[f->body[f->soft[n]].first].is_cut = false;
    for (int k = 0; l->near && k < l->near->candidates; k++) {
        int b = l->near->candidate[k];
        if (body_is_soft(&f->body[b])) continue;
        rigid_view_update(l->view, f, b);
        aabb swept = swept_by_body(l, b);
        for (int n = 0; n < f->softs; n++) {
            int a = f->soft[n], ahead = 0;
            if (!soft_moves(f, a) || !soft_meets(f, a, b)) continue;
            box_all(l);
            if (is_certified(f, a))
                search_body(l, &swept, whole_soft(l, a), b, &ahead);
            else search_links(l, &swept, a, b, &ahead);
        }
    }
}
//<

//> certificate-part
//>   Two facets that have no plane are parted along the one that they had when
//>   the frame began, by the least moves that do it and push nothing away: those
//>   of chapter 07, of all their vertices at once.
static bool is_fixed(const frame_search *l, int v)
{
    return !(l->f->particle[v].inverse_mass > 0);
}

// kg; what is nailed outweighs all.
static real weight_of(const frame_search *l, int v)
{
    static const real NAILED = 0x1p100;
    return is_fixed(l, v) ? NAILED : 1 / l->f->particle[v].inverse_mass;
}

// A vertex must be over, or under, what parts the two.
typedef struct {
    real at, weight;    // where that may be at most, or at least: m, kg
    bool is_over;
} side_of_plane;

static bool is_past_plane(const side_of_plane *s, real middle)
{
    return s->is_over ? middle > s->at : middle < s->at;
}

// Those that are not where they must be are drawn to it.  It is where their
// pulls are in balance: each side as much as the other.
static real balance(const side_of_plane *s, int count)
{
    real low = -HUGE_VAL, sum = 0, mass = 0;
    for (int k = 0; k < count; k++) {
        real pull = 0;
        for (int i = 0; i < count; i++)
            if (is_past_plane(&s[i], s[k].at))
                pull += s[i].weight * (s[k].at - s[i].at);
        if (pull <= 0) low = real_max(low, s[k].at);
    }
    for (int i = 0; i < count; i++) {
        if (s[i].is_over != (s[i].at <= low)) continue;
        sum += s[i].weight * (s[i].at - low);
        mass += s[i].weight;
    }
    return low + sum / mass;
}

// They keep so much of their gap, as a share of the thickness of cloth: less
// than can be seen, and far more than rounding takes.
static const real KEEPS = 0x1p-16;

static void part_clash(const frame_search *l, const facet_clash *x)
{
    side_of_plane side[2 * FACET];
    int count = 0, vertex[2 * FACET];
    real thick = l->f->body[x->set[0].part.cells.body].thickness;
    real need = real_min(x->gap, KEEPS * thick);
    vec3 where = { 0, 0, 0 };
    if (!(gap_of(l, x->set, ENDS, x->normal, &where) < need)) return;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < x->set[i].count; k++, count++) {
            int v = vertex[count] = x->set[i].vertex[k];
            real height = vec3_dot(x->normal, l->c->at[1][v]);
            side[count] = (side_of_plane){ height + (i - 0.5) * need,
                                           weight_of(l, v), i == 0 };
        }
    real middle = balance(side, count);
    for (int k = 0; k < count; k++) {
        vec3 *at = &l->c->at[1][vertex[k]];
        if (is_past_plane(&side[k], middle) && !is_fixed(l, vertex[k]))
            *at = vec3_add_scaled(*at, middle - side[k].at, x->normal);
    }
}

// Does it yield?  (Such a body is stopped by what it cuts, and does not take it along.)
static bool can_be_pushed(const soft_frame *f, int b)
{
    int whole = body_whole(&f->body[b], b);
    return !body_is_fixed(&f->body[b]) && f->now[whole].basis.inverse_mass > 0
        && !f->now[whole].is_driven;
}

// What a vertex gets, the body loses (kg m, in the time of the way).
static void push_back(const frame_search *l, const facet_cut *cut, vec3 at,
                      vec3 push)
{
    const soft_frame *f = l->f;
    const body *x = &f->body[cut->body];
    int whole = body_whole(x, cut->body);
    if (!can_be_pushed(f, cut->body)) return;
    vec3 arm = vec3_sub(at, l->c->at[1][x->first]);
    motion_push(&f->velocity[whole], &f->now[whole].basis, arm,
                vec3_scale(1 / l->c->since, push));
}

// A body's side is where it is.
static void part_cut(const frame_search *l, const facet_cut *x)
{
    real thick = l->f->body[x->set.part.cells.body].thickness;
    real least = x->top + real_min(x->gap, KEEPS * thick);
    for (int k = 0; k < FACET; k++) {
        int v = x->set.vertex[k];
        vec3 *at = &l->c->at[1][v];
        real lacks = least - vec3_dot(x->normal, *at);
        if (!(lacks > 0) || is_fixed(l, v)) continue;
        *at = vec3_add_scaled(*at, lacks, x->normal);
        push_back(l, x, *at, vec3_scale(-lacks * weight_of(l, v), x->normal));
    }
}
//<

//> certificate-as-one
//>   What still clashes makes a patch with all that it clashes with, which goes
//>   as one, by its mean way: so its momentum is left to it. Where more clash
//>   than there are vertices, whole cloths make a patch.
static vec3 path_at(const certificate *c, int v)
{
    return vec3_sub(c->at[1][v], c->at[0][v]);
}

static void forget_patches(certificate *c)
{
    for (int v = 0; v < c->particles; v++) {
        c->of[v].patch = v;
        c->of[v].is_whole = false;
        c->of[v].rides = -1;
    }
}

static void join_components(certificate *c, int v, int to)
{
    int first = patch_of(c, to), other = patch_of(c, v);
    if (c->of[first].rides < 0) c->of[first].rides = c->of[other].rides;
    c->of[other].patch = first;
    c->of[first].is_whole = true;
}

static void join_clash(certificate *c, const facet_clash *x)
{
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < x->set[i].count; k++)
            join_components(c, x->set[i].vertex[k], x->set[0].vertex[0]);
}

// What a body cuts that does not yield goes as the body does.
static void join_cut(certificate *c, const facet_cut *x)
{
    for (int k = 0; k < FACET; k++)
        join_components(c, x->set.vertex[k], x->set.vertex[0]);
    c->of[patch_of(c, x->set.vertex[0])].rides = c->carrier = x->body;
}

static void join_cloths(const frame_search *l, const facet_clash *x)
{
    int first = l->f->body[x->set[0].part.cells.body].first;
    for (int i = 0; i < 2; i++) {
        const body *b = &l->f->body[x->set[i].part.cells.body];
        int patch = patch_of(l->c, b->first);
        if (l->c->of[patch].is_whole && patch == patch_of(l->c, first)) continue;
        for (int v = b->first; v < b->first + body_particles(b); v++)
            join_components(l->c, v, first);
    }
}

static void move_as_one(const frame_search *l)
{
    certificate *c = l->c;
    for (int v = 0; v < c->particles; v++) {
        c->of[v].delta = (vec3){ 0, 0, 0 };
        c->of[v].mass = 0;
    }
    for (int v = 0; v < c->particles; v++) {
        certified_vertex *p = &c->of[patch_of(c, v)];
        if (!p->is_whole) continue;
        real m = weight_of(l, v);
        p->delta = vec3_add_scaled(p->delta, m, path_at(c, v));
        p->mass += m;
    }
    for (int v = 0; v < c->particles; v++) {
        const certified_vertex *p = &c->of[patch_of(c, v)];
        if (!p->is_whole || is_fixed(l, v)) continue;
        c->at[1][v] = p->rides >= 0
            ? carried_along(c, &l->f->body[p->rides], c->at[0][v])
            : vec3_add_scaled(c->at[0][v], 1 / p->mass, p->delta);
    }
}

static void move_patches(const frame_search *l)
{
    certificate *c = l->c;
    for (int k = 0; k < c->clashes; k++) join_clash(c, &c->clash[k]);
    for (int k = 0; k < c->cuts; k++)
        if (!can_be_pushed(l->f, c->cut[k].body)) join_cut(c, &c->cut[k]);
    move_as_one(l);
}

static void move_cloths(const frame_search *l)
{
    certificate *c = l->c;
    forget_patches(c);
    for (int k = 0; k < c->vertices; k++) join_cloths(l, &c->clash[k]);
    move_as_one(l);
    forget_patches(c);
}

// Ends have been put elsewhere since the last look.
static void search_at_ends(const frame_search *l)
{
    if (may_check_kept(l)) check_kept(l);
    else                   search_all(l);
    search_bodies(l);
    l->c->cuts = int_min(l->c->cuts, l->c->particles);
}

static bool is_proved(const certificate *c)
{
    return c->clashes + c->cuts == 0;
}

static void search_after(const frame_search *l, void put(const frame_search *l))
{
    certificate *c = l->c;
    memcpy(c->seen, c->at[1], (size_t)c->particles * sizeof *c->seen);
    if (clashes_too_much(c)) move_cloths(l);
    else                put(l);
    measure_paths(l, c->seen);
    search_at_ends(l);
}

static void part_clashes(const frame_search *l)
{
    enum { ATTEMPTS = 4 };
    const certificate *c = l->c;
    for (int i = 0; i < ATTEMPTS; i++) {
        for (int k = 0; k < c->clashes; k++) part_clash(l, &c->clash[k]);
        for (int k = 0; k < c->cuts; k++) part_cut(l, &c->cut[k]);
    }
}

// All of it, with a body that would cut some.
static void go_along(const frame_search *l)
{
    certificate *c = l->c;
    for (int n = 0; n < l->f->softs; n++) {
        const body *x = &l->f->body[l->f->soft[n]];
        for (int v = x->first; v < x->first + body_particles(x); v++)
            if (!is_fixed(l, v))
                c->at[1][v] = c->carrier < 0 ? c->at[0][v]
                    : carried_along(c, &l->f->body[c->carrier], c->at[0][v]);
    }
}

static void stand_still(const frame_search *l)
{
    l->c->carrier = -1;
    go_along(l);
}

// So often each is tried before all cloth stands still for the way.
enum { PARTINGS = 4, PROOF_ROUNDS = 16 };

static void certify(const frame_search *l)
{
    certificate *c = l->c;
    forget_patches(c);
    c->carrier = -1;
    measure_paths(l, c->at[0]);
    search_at_ends(l);
    // Those beside what crossed are known now.
    if (c->left_out > 0) search_at_ends(l);
    c->prevented = c->clashes + c->cuts;
    for (int k = 0; k < PARTINGS && !is_proved(c); k++)
        search_after(l, part_clashes);
    if (!is_proved(c)) forget_patches(c);
    for (int k = 0; k < PROOF_ROUNDS && !is_proved(c); k++)
        search_after(l, move_patches);
    if (c->clashes > 0 && c->carrier >= 0) search_after(l, go_along);
    if (c->clashes > 0) stand_still(l);
}
//<

//> certificate-frame
//>   What it has added to a way, it adds to the velocity. A long frame has more
//>   than one way.
void certificate_carry(const certificate *c, const soft_frame *f, particle *p,
                       vec3 by)
{
    p->previous = vec3_add_scaled(p->previous, 1 - f->age / c->since, by);
}

static void take_back_vertex(const frame_search *l, int v)
{
    particle *p = &l->f->particle[v];
    vec3 by = vec3_sub(l->c->at[1][v], p->position);
    if (!(vec3_length_squared(by) > 0)) return;
    p->position = l->c->at[1][v];
    certificate_carry(l->c, l->f, p, by);
}

// A vertex that is lost stands still for all others.
static void copy_positions(certificate *c, const soft_frame *f,
                           const near_lists *near, int end)
{
    real most = 0;
    c->vertices = 0;
    for (int n = 0; n < f->softs; n++) {
        const body *x = &f->body[f->soft[n]];
        bool is_rope = !is_certified(f, f->soft[n]);
        c->vertices += is_rope ? 0 : body_particles(x);
        for (int v = x->first; v < x->first + body_particles(x); v++) {
            vec3 at = f->particle[v].position, was = c->at[0][v];
            if (end > 0 && !vec3_is_finite(at)) at = was;
            bool is_there = at.x == was.x && at.y == was.y && at.z == was.z;
            if (end == 0 && !is_rope && !is_there) c->keeps = 0;
            most = real_max(real_max(fabs(at.x), fabs(at.y)),
                            real_max(fabs(at.z), most));
            c->at[end][v] = at;
        }
    }
    for (int k = 0; near && k < near->candidates; k++)
        if (!body_is_soft(&f->body[near->candidate[k]]))
            put_frame(c, f, near->candidate[k], end);
    c->rounding = real_max(end == 0 ? 0 : c->rounding, 0x1p-40 * most);
}

void certificate_begin(certificate *c, const soft_frame *f, const near_lists *near)
{
    copy_positions(c, f, near, 0);
    if (near && near->is_stale) c->keeps = 0;
    c->since = 0;
}

// Cloth that falls as one, however fast, keeps all its planes: what counts is
// how far one vertex has gone from another.  No way is shorter than the usual
// substep of what is stiff: what cannot be is asked for in every one.
bool certificate_is_due(certificate *c, const soft_frame *f)
{
    aabb ways = aabb_empty();
    real spacing = HUGE_VAL;
    c->since += f->h;
    if (!(c->since * (f->stiff_substeps + 1) > f->frame)) return false;
    for (int n = 0; n < f->softs; n++) {
        const body *x = &f->body[f->soft[n]];
        if (!is_certified(f, f->soft[n])) continue;
        spacing = real_min(spacing, x->shape->spacing);
        for (int v = x->first; v < x->first + body_particles(x); v++)
            ways = aabb_with(ways, vec3_sub(f->particle[v].position,
                                            c->at[0][v]));
    }
    return vec3_distance(ways.low, ways.high) > spacing;
}

// What is proved begins the next way.
static void begin_next(certificate *c)
{
    SWAP(vec3 *, c->at[0], c->at[1]);
    c->since = 0;
}

bool certificate_is_cut(const certificate *c, const body *soft)
{
    return c->of[soft->first].is_cut;
}

void certificate_end(certificate *c, const soft_frame *f, const near_lists *near,
                     rigid_view *view)
{
    frame_search l = { .c = c, .f = f, .near = near, .view = view };
    bool is_still = true;
    for (int n = 0; n < f->softs; n++)
        is_still = is_still && !soft_moves(f, f->soft[n]);
    c->prevented = c->left_out = 0;
    if (is_still || !(c->since > 0)) return;
    copy_positions(c, f, near, 1);
    for (int v = 0; v < c->particles; v++) c->of[v].crossed = false;
    if (f->certified) certify(&l);
    else              search_bodies(&l);
    if (c->clashes > 0 || !f->certified) c->keeps = c->clashes = 0;
    for (int n = 0; n < f->softs && c->prevented > 0; n++) {
        const body *x = &f->body[f->soft[n]];
        for (int v = x->first; v < x->first + body_particles(x); v++)
            take_back_vertex(&l, v);
    }
    begin_next(c);
}
//<

//> certificate-room
//>   At last, its memory.
status certificate_grow(certificate *c, int kept, int particles)
{
    bool ok = true;
    for (int e = 0; e < ENDS; e++) TABLE_GROW(ok, c->at[e], kept, particles);
    TABLE_GROW(ok, c->of, kept, particles);
    TABLE_GROW(ok, c->box, 2 * kept, 2 * particles);
    TABLE_GROW(ok, c->clash, kept, particles);
    TABLE_GROW(ok, c->cut, kept, particles);
    TABLE_GROW(ok, c->seen, kept, particles);
    TABLE_GROW(ok, c->beside, kept, particles);
    int room = int_max(WITNESSES * particles, c->room);
    TABLE_GROW(ok, c->kept, c->room, room);
    if (!ok) return status_out_of_memory();
    c->particles = particles;
    c->room = room;
    return status_ok();
}

void certificate_free(certificate *c)
{
    for (int e = 0; e < ENDS; e++) free(c->at[e]);
    free(c->of);
    free(c->box);
    free(c->clash);
    free(c->cut);
    free(c->kept);
    free(c->seen);
    free(c->beside);
    *c = (certificate){ .particles = 0 };
}
//<
