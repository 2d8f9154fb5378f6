// crossings.c - see crossings.h.

#include "crossings.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// ---- two triangles ---------------------------------------------------------

static void stretch(vec3 *least, vec3 *most, vec3 at)
{
    *least = vec3_make(fmin(least->x, at.x), fmin(least->y, at.y),
                       fmin(least->z, at.z));
    *most = vec3_make(fmax(most->x, at.x), fmax(most->y, at.y),
                      fmax(most->z, at.z));
}

patch patch_make(const vec3 *at, const int vertex[3], int first)
{
    patch p = { .least = at[vertex[0]], .most = at[vertex[0]] };
    for (int k = 0; k < 3; k++) {
        p.corner[k] = at[vertex[k]];
        p.vertex[k] = first + vertex[k];
        stretch(&p.least, &p.most, p.corner[k]);
    }
    return p;
}

// Places are doubles; what is made of them has 11 bits more.
typedef struct {
    long double x, y, z;
} wide;

static wide wide_sub(vec3 a, vec3 b)
{
    return (wide){ (long double)a.x - (long double)b.x,
                   (long double)a.y - (long double)b.y,
                   (long double)a.z - (long double)b.z };
}

// Six times the volume of a, b, c, d: which side of the triangle a, b, c is d
// on?
static int side_of(vec3 a, vec3 b, vec3 c, vec3 d)
{
    wide p = wide_sub(b, a), q = wide_sub(c, a), s = wide_sub(d, a);
    long double volume = (p.y * q.z - p.z * q.y) * s.x
                       + (p.z * q.x - p.x * q.z) * s.y
                       + (p.x * q.y - p.y * q.x) * s.z;
    return (volume > 0) - (volume < 0);
}

// Does the link from p to q pass through the triangle?  Its ends are on two
// sides of it, and its line has the three edges on one side.
static bool link_pierces(vec3 p, vec3 q, const vec3 t[3])
{
    if (side_of(t[0], t[1], t[2], p) * side_of(t[0], t[1], t[2], q) >= 0)
        return false;
    int first = side_of(p, q, t[0], t[1]);
    return first != 0 && first == side_of(p, q, t[1], t[2])
        && first == side_of(p, q, t[2], t[0]);
}

static bool share_a_vertex(const patch *a, const patch *b)
{
    for (int k = 0; k < 9; k++)
        if (a->vertex[k / 3] == b->vertex[k % 3]) return true;
    return false;
}

// Two triangles cross if an edge of one passes through the other.
bool patches_cross(const patch *a, const patch *b)
{
    if (share_a_vertex(a, b)) return false;
    for (int k = 0; k < 3; k++)
        if (link_pierces(a->corner[k], a->corner[(k + 1) % 3], b->corner)
            || link_pierces(b->corner[k], b->corner[(k + 1) % 3], a->corner))
            return true;
    return false;
}

// ---- all pairs -------------------------------------------------------------

static bool boxes_meet(const patch *a, const patch *b)
{
    return a->least.y <= b->most.y && b->least.y <= a->most.y
        && a->least.z <= b->most.z && b->least.z <= a->most.z
        && a->least.x <= b->most.x && b->least.x <= a->most.x;
}

static bool is_finite(const patch *p)
{
    return vec3_is_finite(p->corner[0]) && vec3_is_finite(p->corner[1])
        && vec3_is_finite(p->corner[2]);
}

long crossings_count_slowly(const patch *x, int n)
{
    long count = 0;
    for (int i = 0; i < n; i++)
        for (int k = i + 1; k < n; k++)
            count += is_finite(&x[i]) && is_finite(&x[k])
                  && patches_cross(&x[i], &x[k]);
    return count;
}

// Strips across z.  A patch stands in every strip that it reaches; two of them
// are compared in the first strip that both reach.
typedef struct {
    real least, width;  // m
    int  count;
} strips;

typedef struct {
    int  strip, patch;
    real least;         // m, where the patch begins along x
} entry;

enum { MOST_STRIPS = 256 };

static strips strips_over(const patch *x, int n)
{
    real least = HUGE_VAL, most = -HUGE_VAL;
    for (int i = 0; i < n; i++) {
        if (!is_finite(&x[i])) continue;
        least = fmin(least, x[i].least.z);
        most = fmax(most, x[i].most.z);
    }
    strips s = { .least = least, .count = (int)sqrt(n / 4.0) + 1 };
    if (s.count > MOST_STRIPS) s.count = MOST_STRIPS;
    s.width = (most - least) / s.count;
    if (!(s.width > 0)) s.count = 1;
    return s;
}

static int strip_of(const strips *s, real z)
{
    if (s->count == 1) return 0;
    real k = (z - s->least) / s->width;
    return k < s->count - 1 ? (int)k : s->count - 1;
}

// With `out` NULL it only counts.
static int strips_fill(const strips *s, const patch *x, int n, entry *out)
{
    int count = 0;
    for (int i = 0; i < n; i++) {
        if (!is_finite(&x[i])) continue;
        int last = strip_of(s, x[i].most.z);
        for (int k = strip_of(s, x[i].least.z); k <= last; k++, count++)
            if (out) out[count] = (entry){ k, i, x[i].least.x };
    }
    return count;
}

static int by_strip(const void *a, const void *b)
{
    const entry *x = a, *y = b;
    if (x->strip != y->strip) return x->strip < y->strip ? -1 : 1;
    return (x->least > y->least) - (x->least < y->least);
}

static bool is_first_strip(const strips *s, int strip, const patch *a,
                           const patch *b)
{
    return strip_of(s, fmax(a->least.z, b->least.z)) == strip;
}

// In the order of where they begin along x, a patch can only meet those that
// begin before it ends.
long crossings_count(const patch *x, int n)
{
    strips s = strips_over(x, n);
    int room = strips_fill(&s, x, n, NULL);
    entry *e = calloc((size_t)room + 1, sizeof *e);
    if (!e) return -1;
    strips_fill(&s, x, n, e);
    qsort(e, (size_t)room, sizeof *e, by_strip);
    long count = 0;
    for (int i = 0; i < room; i++) {
        const patch *a = &x[e[i].patch];
        for (int k = i + 1; k < room && e[k].strip == e[i].strip
                            && e[k].least <= a->most.x; k++) {
            const patch *b = &x[e[k].patch];
            count += boxes_meet(a, b) && is_first_strip(&s, e[i].strip, a, b)
                  && patches_cross(a, b);
        }
    }
    free(e);
    return count;
}

// ---- a solid ---------------------------------------------------------------

void solid_make(solid *s, const vec3 *at, int corners, const int *face,
                int faces)
{
    assert(corners <= SOLID_CORNERS && faces <= SOLID_FACES);
    s->corners = corners;
    s->faces = faces;
    s->least = s->most = at[0];
    for (int i = 0; i < corners; i++) {
        s->corner[i] = at[i];
        stretch(&s->least, &s->most, at[i]);
    }
    s->size = vec3_distance(s->least, s->most);
    memcpy(s->face, face, (size_t)faces * sizeof *s->face);
    for (int f = 0; f < faces; f++) {
        const int *c = s->face[f];
        vec3 p = vec3_sub(at[c[1]], at[c[0]]), q = vec3_sub(at[c[2]], at[c[0]]);
        s->normal[f] = vec3_unit(vec3_cross(p, q));
        s->offset[f] = vec3_dot(s->normal[f], at[c[0]]);
    }
}

static real height(const solid *s, int face, vec3 x)
{
    return vec3_dot(s->normal[face], x) - s->offset[face];
}

real solid_depth(const solid *s, vec3 x)
{
    real highest = -HUGE_VAL;
    for (int f = 0; f < s->faces; f++)
        highest = fmax(highest, height(s, f, x));
    return vec3_is_finite(x) ? -highest : -HUGE_VAL;
}

// Keeps of a polygon what is below the plane of a face.  Returns how many
// corners are left: one more at most.
static int clip(const solid *s, int face, const vec3 *in, int n, vec3 *out)
{
    int left = 0;
    for (int k = 0; k < n; k++) {
        vec3 a = in[k], b = in[(k + 1) % n];
        real x = height(s, face, a), y = height(s, face, b);
        if (x <= 0) out[left++] = a;
        if ((x < 0 && y > 0) || (x > 0 && y < 0))
            out[left++] = vec3_add_scaled(a, x / (x - y), vec3_sub(b, a));
    }
    return left;
}

static bool box_misses(const solid *s, const patch *p)
{
    return p->least.x > s->most.x || p->most.x < s->least.x
        || p->least.y > s->most.y || p->most.y < s->least.y
        || p->least.z > s->most.z || p->most.z < s->least.z;
}

// What is left of it between all planes has its middle inside, unless it only
// touches.
bool solid_is_cut(const solid *s, const patch *p)
{
    enum { MOST = SOLID_FACES + 3 };
    static const real ROUNDING = 1e-12;
    if (box_misses(s, p) || !is_finite(p)) return false;
    vec3 room[2][MOST], middle = { 0, 0, 0 };
    int n = 3, now = 0;
    memcpy(room[0], p->corner, sizeof p->corner);
    for (int f = 0; f < s->faces && n > 0; f++, now = !now)
        n = clip(s, f, room[now], n, room[!now]);
    if (n == 0) return false;
    for (int k = 0; k < n; k++)
        middle = vec3_add_scaled(middle, 1.0 / n, room[now][k]);
    return solid_depth(s, middle) > ROUNDING * s->size;
}

int solid_edges_through(const solid *s, const patch *p)
{
    int count = 0;
    if (box_misses(s, p) || !is_finite(p)) return 0;
    for (int f = 0; f < s->faces; f++)
        for (int k = 0; k < 3; k++) {
            int a = s->face[f][k], b = s->face[f][(k + 1) % 3];
            // The other triangle at this edge has it the other way round.
            count += a < b
                  && link_pierces(s->corner[a], s->corner[b], p->corner);
        }
    return count;
}
