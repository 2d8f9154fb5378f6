// hard_cloth.c - cases 24 and 25: cloth that falls, folds, and lies still.
//
// What is counted is counted from outside: every triangle against every other,
// whatever the library holds to be near.

#include "hard.h"
#include "hard_set.h"
#include "world_scene.h"
#include "soft.h"
#include "step.h"

#include <math.h>
#include <stdlib.h>

// ---- triangles -------------------------------------------------------------

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
static int link_pierces(vec3 p, vec3 q, const vec3 t[3])
{
    if (side_of(t[0], t[1], t[2], p) * side_of(t[0], t[1], t[2], q) >= 0)
        return 0;
    int first = side_of(p, q, t[0], t[1]);
    return first != 0 && first == side_of(p, q, t[1], t[2])
        && first == side_of(p, q, t[2], t[0]);
}

// Two triangles cross if an edge of one passes through the other.
static int triangles_cross(const vec3 a[3], const vec3 b[3])
{
    for (int k = 0; k < 3; k++)
        if (link_pierces(a[k], a[(k + 1) % 3], b)
            || link_pierces(b[k], b[(k + 1) % 3], a)) return 1;
    return 0;
}

// Does the shadow of the triangle on this axis overlap that of the box, which
// stands on the axes about the origin?  Touching is no overlap.  An axis that
// is none, where two were parallel, parts nothing.
static int shadows_overlap(const vec3 t[3], vec3 half, vec3 axis)
{
    real reach = half.x * fabs(axis.x) + half.y * fabs(axis.y)
               + half.z * fabs(axis.z);
    real a = vec3_dot(t[0], axis), b = vec3_dot(t[1], axis);
    real c = vec3_dot(t[2], axis);
    if (vec3_length_squared(axis) == 0) return 1;
    return fmin(a, fmin(b, c)) < reach && fmax(a, fmax(b, c)) > -reach;
}

// They have a point in common unless one of thirteen axes parts them: those of
// the box, the triangle's normal, and what is perpendicular to an axis of the
// box and an edge.
static int triangle_cuts_box(const vec3 t[3], vec3 half)
{
    const vec3 axis[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    for (int k = 0; k < 3; k++)
        if (!shadows_overlap(t, half, axis[k])) return 0;
    vec3 edge[3];
    for (int k = 0; k < 3; k++) edge[k] = vec3_sub(t[(k + 1) % 3], t[k]);
    if (!shadows_overlap(t, half, vec3_cross(edge[0], edge[1]))) return 0;
    for (int k = 0; k < 9; k++)
        if (!shadows_overlap(t, half, vec3_cross(axis[k / 3], edge[k % 3])))
            return 0;
    return 1;
}

// ---- all triangles of a cloth ----------------------------------------------

// A triangle, or a link of a rope (which says its last corner twice), and the
// box around it.
typedef struct {
    vec3 corner[3], least, most;
    int  vertex[3];
} patch;

static patch patch_make(const body *b, const particle *p, const int *vertex)
{
    patch x = { .least = p[vertex[0]].position, .most = p[vertex[0]].position };
    for (int k = 0; k < 3; k++) {
        vec3 at = p[vertex[k]].position;
        x.corner[k] = at;
        x.vertex[k] = b->first + vertex[k];
        x.least = vec3_make(fmin(x.least.x, at.x), fmin(x.least.y, at.y),
                            fmin(x.least.z, at.z));
        x.most = vec3_make(fmax(x.most.x, at.x), fmax(x.most.y, at.y),
                           fmax(x.most.z, at.z));
    }
    return x;
}

static int patches_make(const world *w, int number, patch *out)
{
    const body *b = &w->body[number];
    const particle *p = w->pool.at + b->first;
    const shape *s = b->shape;
    int is_cloth = s->kind == SHAPE_CLOTH;
    int n = is_cloth ? s->mesh.faces : s->sticks;
    for (int k = 0; k < n; k++) {
        const stick *link = &s->stick[k];
        const int ends[3] = { link->a, link->b, link->b };
        out[k] = patch_make(b, p, is_cloth ? &s->face[3 * k] : ends);
    }
    return n;
}

static int share_a_vertex(const patch *a, const patch *b)
{
    for (int k = 0; k < 9; k++)
        if (a->vertex[k / 3] == b->vertex[k % 3]) return 1;
    return 0;
}

// Neighbours meet in what they share.
static int patches_cross(const patch *a, const patch *b)
{
    return !share_a_vertex(a, b) && triangles_cross(a->corner, b->corner);
}

static int boxes_meet(const patch *a, const patch *b)
{
    return a->least.y <= b->most.y && b->least.y <= a->most.y
        && a->least.z <= b->most.z && b->least.z <= a->most.z
        && a->least.x <= b->most.x && b->least.x <= a->most.x;
}

static int by_least_x(const void *a, const void *b)
{
    real x = ((const patch *)a)->least.x, y = ((const patch *)b)->least.x;
    return (x > y) - (x < y);
}

// Pairs that cross.  In the order of where they begin along x, a patch can only
// meet those that begin before it ends.
static int count_crossings(patch *x, int n)
{
    int count = 0;
    qsort(x, (size_t)n, sizeof *x, by_least_x);
    for (int i = 0; i < n; i++)
        for (int k = i + 1; k < n && x[k].least.x <= x[i].most.x; k++)
            count += boxes_meet(&x[i], &x[k]) && patches_cross(&x[i], &x[k]);
    return count;
}

// The same, every pair looked at.
static int count_crossings_slowly(const patch *x, int n)
{
    int count = 0;
    for (int i = 0; i < n; i++)
        for (int k = i + 1; k < n; k++)
            count += patches_cross(&x[i], &x[k]);
    return count;
}

// ---- a cloth on its way ----------------------------------------------------

enum { MOST_SIDE = 40, STARTS = 8 };
enum { MOST_PATCHES = 2 * MOST_SIDE * MOST_SIDE };
static patch sheet[MOST_PATCHES];

// What was found at worst: over all frames, or at the end.
typedef struct {
    real strain, end;       // in any frame; at the end
    long crossing;          // pairs of triangles, or of triangle and link,
                            // summed over the frames that were looked at
    long inside, cutting;   // particles in the solid box; triangles cutting it
} findings;

// Uniform in [-1, 1).
static real any(unsigned long long *seed)
{
    return 2 * any_share(seed) - 1;
}

// A start by chance: the cloth turned by up to 5 degrees, moved by up
// to 4 cm, every particle off by up to a thousandth of the spacing; no speeds.
static void perturb(world *w, int number, unsigned long long seed)
{
    const body *b = &w->body[number];
    real turn = 0.087 * any(&seed), c = cos(turn), s = sin(turn);
    real x = 0.04 * any(&seed), z = 0.04 * any(&seed);
    for (int i = b->first; i < b->first + b->shape->particles; i++) {
        particle *p = &w->pool.at[i];
        vec3 at = p->position, back = vec3_sub(p->previous, at);
        real off = 1e-3 * b->shape->spacing;
        p->position = vec3_make(c * at.x + s * at.z + x + off * any(&seed),
                                at.y + off * any(&seed),
                                c * at.z - s * at.x + z + off * any(&seed));
        p->previous = vec3_add(p->position, back);
    }
}

// In the solid box: particles, and triangles.
static void look_in_box(const world *w, int number, vec3 middle, vec3 half,
                        findings *f)
{
    const body *b = &w->body[number];
    int n = patches_make(w, number, sheet);
    for (int k = 0; k < n; k++) {
        vec3 t[3];
        for (int i = 0; i < 3; i++)
            t[i] = vec3_sub(sheet[k].corner[i], middle);
        f->cutting += triangle_cuts_box(t, half);
    }
    for (int i = b->first; i < b->first + b->shape->particles; i++) {
        vec3 at = vec3_sub(w->pool.at[i].position, middle);
        f->inside += fabs(at.x) < half.x && fabs(at.y) < half.y
                  && fabs(at.z) < half.z;
    }
}

// Cloths and ropes together: nothing may pass through anything.
static void look_for_crossings(const world *w, findings *f)
{
    int n = 0;
    for (int b = 0; b < w->bodies; b++)
        if (body_is_soft(&w->body[b])) n += patches_make(w, b, sheet + n);
    f->crossing += count_crossings(sheet, n);
}

// ---- a cloth folded onto itself --------------------------------------------

// A static box whose top is at y = 0, and the paper's cloth of n x n particles:
// body 1.
static void lay_table(setting *s, world_options o, vec3 sides, int n,
                      placement where)
{
    placement below = placement_at(vec3_make(0, -sides.y / 2, 0));
    below.is_static = 1;
    setting_start(s, o);
    add_body(s, add_box(s, sides, 1), below);
    shape *cloth = &s->plan[s->plans++];
    if (s->ok.ok) s->ok = shape_cloth(cloth, n, n, 2, 2, 1, 0.2);
    add_body(s, cloth, where);
}

// m, how far particles keep off each other, and off the table.
static real apart(const world *w)       { return 2 * w->body[1].thickness; }
static real off_table(const world *w)
{
    return soft_gap(&w->body[1], &w->body[0]);
}

// Which part of a fold link i of a row is: 0, none; 1, going out; 2, back.
static int fold_part(int i, int third)
{
    return i + 1 == third || i + 1 == 2 * third ? 1
         : i == third || i == 2 * third         ? 2 : 0;
}

// Folds it in three, like a letter: every sheet is `gap` above the one below,
// joined to it by two links that rise by half of that each.
static void fold(world *w, real height, real gap)
{
    const body *b = &w->body[1];
    int n = b->shape->columns, third = n / 3;
    real link = b->shape->spacing, rise = gap / 2;
    real out = sqrt(link * link - rise * rise), x = -third * link / 2;
    real way = 1;
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < n; k++) {
            particle *p = &w->pool.at[b->first + k * n + i];
            vec3 back = vec3_sub(p->previous, p->position);
            p->position = vec3_make(x, height, (k - (n - 1) / 2.0) * link);
            p->previous = vec3_add(p->position, back);
        }
        int part = fold_part(i, third);
        x += way * (part == 0 ? link : part == 1 ? out : -out);
        height += part > 0 ? rise : 0;
        if (part == 2) way = -way;
    }
}

// ---- 24: cloth that falls, and folds ---------------------------------------

// How long, how many starts, how often everything is counted.
typedef struct {
    int frames, starts, every;
} effort;

// Lets a world that has begun run; the box may be absent (half.x = 0).
static void watch(world *w, int number, vec3 middle, vec3 half, effort e,
                  findings *f)
{
    real strain = 0;
    for (int k = 1; k <= e.frames; k++) {
        world_step(w);
        strain = world_measure(w).strain;
        f->strain = hard_worse(f->strain, strain);
        if (k % e.every != 0 && k != e.frames) continue;
        look_for_crossings(w, f);
        if (half.x > 0) look_in_box(w, number, middle, half, f);
    }
    f->end = hard_worse(f->end, strain);
}

// The paper's scenes: the cloth is body 1, the cube stands on y = 0.
static findings run_scene(hard_report *r, scene_kind kind, int n, effort e)
{
    findings f = { .strain = 0 };
    for (int k = 0; k < e.starts; k++) {
        world_scene s;
        scene_options what = scene_options_default();
        what.cloth = n;
        status ok = world_scene_build(&s, kind, what,
                                      world_scene_options(kind, what.cloth));
        if (!hard_ok(r, ok)) return f;
        perturb(&s.world, 1, 100 + (unsigned long long)k);
        real half = kind == SCENE_CLOTH_ON_CUBE ? s.size / 2 : 0;
        watch(&s.world, 1, vec3_make(0, half, 0), vec3_make(half, half, half),
              e, &f);
        world_scene_free(&s);
    }
    return f;
}

// How a cloth comes to be folded.
typedef enum {
    FOLD_LETTER,        // in three, laid on a table
    FOLD_OVER_CUBE,     // in three, dropped on a cube that it hangs over
    FOLD_UPRIGHT,       // stood on its edge, it crumples
    FOLDS
} fold_kind;

// The sheets lie 1.5 times as far apart as they touch; so does the table.
static void build_fold(setting *s, fold_kind kind, int n)
{
    placement where = placement_at(vec3_make(0, 1.2, 0));
    vec3 sides = vec3_make(3, 0.2, 3);
    if (kind == FOLD_OVER_CUBE) sides = vec3_make(0.8, 0.8, 0.8);
    if (kind == FOLD_UPRIGHT) {
        where.x = vec3_make(0, 1, 0);
        where.y = vec3_make(-1, 0, 0);
    }
    lay_table(s, world_scene_options(SCENE_CLOTH_ON_CUBE, 40), sides, n, where);
    if (s->ok.ok && kind != FOLD_UPRIGHT)
        fold(&s->w, 1.5 * off_table(&s->w) + (kind == FOLD_LETTER ? 0 : 0.1),
             1.5 * apart(&s->w));
}

static findings run_fold(hard_report *r, fold_kind kind, int n, effort e)
{
    findings f = { .strain = 0 };
    for (int k = 0; k < e.starts; k++) {
        setting s;
        build_fold(&s, kind, n);
        int is_ready = hard_ok(r, setting_begin(&s));
        if (is_ready) perturb(&s.w, 1, 200 + (unsigned long long)k);
        vec3 half = kind == FOLD_OVER_CUBE ? vec3_make(0.4, 0.4, 0.4)
                                           : vec3_make(1.5, 0.1, 1.5);
        if (is_ready) watch(&s.w, 1, vec3_make(0, -half.y, 0), half, e, &f);
        setting_free(&s);
    }
    return f;
}

// ---- are the counts right? -------------------------------------------------

// A triangle in the plane y = 0 and another one, and that one and a unit box
// about the origin: a drawing shows the answers.
static int wrong_answers(void)
{
    static const vec3 flat[3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 } };
    static const struct { vec3 t[3]; int cross, cut; } known[] = {
        // Through its inside; beside it; above it; parallel to it.
        { { { .2, -1, .2 }, { .2, 1, .2 }, { 2, 1, 2 } }, 1, 1 },
        { { { .8, -1, .8 }, { .8, 1, .8 }, { 2, 1, 2 } }, 0, 0 },
        { { { .2, .1, .2 }, { .2, 1, .2 }, { 2, 1, 2 } }, 0, 1 },
        { { { 0, .1, 0 }, { 1, .1, 0 }, { 0, .1, 1 } }, 0, 1 },
        // An edge of `flat` passes through this one, none of its own through.
        { { { .5, -9, -9 }, { .5, 9, -9 }, { .5, 0, 9 } }, 1, 0 },
        // Near a corner of the box, no vertex in it: cuts it off, or not.
        { { { 1.4, 0, 0 }, { 0, 1.4, 0 }, { 0, 0, 1.4 } }, 0, 1 },
        { { { 1.6, 0, 0 }, { 0, 1.6, 0 }, { 0, 0, 1.6 } }, 0, 0 },
        // On the box's top; a finger above it.
        { { { -9, .5, -9 }, { 9, .5, -9 }, { 0, .5, 9 } }, 0, 0 },
    };
    int wrong = 0;
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        wrong += triangles_cross(flat, known[k].t) != known[k].cross;
        wrong += triangles_cross(known[k].t, flat) != known[k].cross;
        wrong += triangle_cuts_box(known[k].t, vec3_make(.5, .5, .5))
              != known[k].cut;
    }
    return wrong;
}

// The cloth on the cube again, without room for pairs of particles: nothing
// keeps it out of itself.  How it ends is counted in both ways.
static void check_counting(hard_report *r, int n, int frames)
{
    world_scene s;
    scene_options what = scene_options_default();
    scene_kind kind = SCENE_CLOTH_ON_CUBE;
    what.cloth = n;
    if (!hard_ok(r, world_scene_build(&s, kind, what,
                                      world_scene_options(kind, what.cloth))))
        return;
    s.world.soft.near.pair_capacity = 0;
    for (int k = 0; k < frames; k++) world_step(&s.world);
    int patches = patches_make(&s.world, 1, sheet);
    int found = count_crossings(sheet, patches);
    int all = count_crossings_slowly(sheet, patches);
    real strain = world_measure(&s.world).strain;
    hard_add(r, all > 0 ? fabs((double)found - all) : HUGE_VAL, 0, "",
             "crossings that the quick count misses");
    hard_add(r, wrong_answers(), 0, "", "known answers that are wrong");
    hard_note(r, "%d x %d on the cube, nothing keeping it out of itself: %d "
              "pairs cross at the end, strain %.4f", n, n, all, strain);
    world_scene_free(&s);
}

static void add_findings(hard_report *r, const findings *f, const char *where,
                         int n, real strain, real end)
{
    hard_add(r, f->strain, strain, "", "strain; %s, %d", where, n);
    hard_add(r, f->end, end, "", "strain at the end; %s, %d", where, n);
    hard_add(r, (double)f->crossing, 0, "", "crossings; %s, %d", where, n);
}

static void add_inside(hard_report *r, const findings *f, const char *where,
                       int n)
{
    hard_add(r, (double)f->inside, 0, "", "particles inside; %s, %d", where, n);
    hard_add(r, (double)f->cutting, 0, "", "triangles cutting; %s, %d", where,
             n);
}

// Beyond the table: folds that are harder than what is asked for.  Nothing may
// cross; the strain is only told.
static void fold_harder(hard_report *r, int n, effort e)
{
    static const char *const name[FOLDS] = {
        "", "letter on the cube", "fallen on its edge"
    };
    for (fold_kind kind = FOLD_OVER_CUBE; kind < FOLDS; kind++) {
        findings f = run_fold(r, kind, n, e);
        hard_add(r, (double)f.crossing, 0, "", "crossings; %s, %d", name[kind],
                 n);
        hard_add(r, (double)(f.inside + f.cutting), 0, "", "inside; %s, %d",
                 name[kind], n);
        hard_note(r, "%s, %d x %d: strain %.4f, at the end %.4f", name[kind],
                  n, n, f.strain, f.end);
    }
}

static void falling_cloth(hard_report *r, int fast)
{
    effort e = { 300, STARTS, 5 };
    if (fast) e = (effort){ 150, 1, 15 };
    for (int n = 20; n <= (fast ? 20 : 40); n += 10) {
        findings f = run_scene(r, SCENE_CLOTH_ON_CUBE, n, e);
        add_findings(r, &f, "on the cube", n, 0.013, 0.003);
        add_inside(r, &f, "the cube", n);
        f = run_scene(r, SCENE_CLOTH_ON_ROPE, n, e);
        add_findings(r, &f, "on the rope", n, 0.04, 0.01);
        f = run_fold(r, FOLD_LETTER, n, e);
        add_findings(r, &f, "folded in three", n, 0.013, 0.003);
        add_inside(r, &f, "the table", n);
    }
    if (!fast) fold_harder(r, 40, e);
    check_counting(r, fast ? 20 : 40, e.frames);
}

// ---- 25: a flat cloth at rest ----------------------------------------------

typedef struct {
    real drift;         // m, of any particle at any time
    long touching;      // pairs of its particles, summed over the frames
} stillness;

// One that lies on the table, or floats; in the axes' directions, or turned.
static void build_flat(setting *s, int n, int lies, int is_turned)
{
    world_options o = world_scene_options(SCENE_CLOTH_ON_CUBE, 40);
    placement where = placement_at(vec3_make(0, 1, 0));
    o = kept_awake(o, true);
    if (is_turned) {
        where.x = vec3_make(0.6, 0, 0.8);
        where.z = vec3_make(-0.8, 0, 0.6);
    }
    lay_table(s, lies ? o : weightless(o), vec3_make(3, 0.2, 3), n, where);
    if (!s->ok.ok || !lies) return;
    const body *b = &s->w.body[1];
    vec3 down = vec3_make(0, off_table(&s->w) - 1, 0);
    for (int i = b->first; i < s->w.pool.count; i++) {
        particle *p = &s->w.pool.at[i];
        p->position = vec3_add(p->position, down);
        p->previous = vec3_add(p->previous, down);
    }
}

static stillness lie_still(world *w, int frames)
{
    static vec3 was[MOST_SIDE * MOST_SIDE];
    const body *b = &w->body[1];
    int n = b->shape->particles;
    stillness s = { 0, 0 };
    for (int i = 0; i < n; i++) was[i] = w->pool.at[b->first + i].position;
    for (int f = 0; f < frames; f++) {
        world_step(w);
        for (int k = 0; k < w->soft.near.pairs; k++)
            s.touching += particle_contact_overlaps(&w->soft.near.pair[k],
                                                    w->pool.at);
        for (int i = 0; i < n; i++)
            s.drift = hard_worse(s.drift, vec3_distance(
                was[i], w->pool.at[b->first + i].position));
    }
    return s;
}

static stillness run_flat(hard_report *r, int n, int lies, int is_turned,
                          int frames)
{
    setting s;
    stillness found = { 0, 0 };
    build_flat(&s, n, lies, is_turned);
    if (hard_ok(r, setting_begin(&s))) found = lie_still(&s.w, frames);
    setting_free(&s);
    return found;
}

// A spacing of 2 m / 16 or 2 m / 32 is a number that a double holds, and then
// nothing at all happens.  Where it is not, places are rounded, and lines mend
// what rounding did.
static void flat_cloth(hard_report *r, int fast)
{
    int frames = fast ? 120 : 600;
    for (int n = 17; n <= 33; n += 16) {
        stillness s = run_flat(r, n, 0, 0, frames);
        hard_add(r, (double)s.touching, 0, "", "contacts; %d x %d", n, n);
        hard_add(r, s.drift, 0, "m", "drift; %d x %d", n, n);
    }
    for (int lies = 0; lies < 2; lies++) {
        real drift = 0;
        for (int n = 20; n <= (fast ? 20 : 40); n += 10)
            for (int turned = 0; turned < 2; turned++) {
                stillness s = run_flat(r, n, lies, turned, frames);
                hard_add(r, (double)s.touching, 0, "", "contacts; %d x %d%s%s",
                         n, n, lies ? ", on a table" : "",
                         turned ? ", turned" : "");
                drift = hard_worse(drift, s.drift);
            }
        hard_note(r, "spacings that no double holds, %s: they drift by %.1e m",
                  lies ? "on a table" : "weightless", drift);
    }
}

const hard_case hard_cloth[] = {
    { 24, "cloth falls and folds", 1, falling_cloth },
    { 25, "a flat cloth lies still", 1, flat_cloth },
    { 0, NULL, 0, NULL }
};
