// hard_cloth.c - cases 24 and 25: cloth that falls, folds, and lies still.
//
// What is counted is counted from outside: every triangle against every other,
// whatever the library holds to be near.

#include "hard.h"
#include "hard_drape_set.h"
#include "hard_judge.h"
#include "probe.h"
#include "world_scene.h"
#include "soft.h"
#include "step.h"

#include <math.h>
#include <stdlib.h>

// ---- a cloth on its way ----------------------------------------------------

enum { MOST_SIDE = 40, STARTS = 8 };
enum { MOST_PATCHES = 2 * MOST_SIDE * MOST_SIDE };
static patch sheet[MOST_PATCHES];
static vec3 place[MOST_SIDE * MOST_SIDE];

// The triangles of a cloth, or the links of a rope.
static int patches_make(const world *w, int number, patch *out)
{
    const body *b = &w->body[number];
    const shape *s = b->shape;
    int is_cloth = s->kind == SHAPE_CLOTH;
    int n = is_cloth ? s->mesh.faces : s->sticks;
    world_vertices(w, b, place);
    for (int k = 0; k < n; k++) {
        const stick *link = &s->stick[k];
        const int ends[3] = { link->a, link->b, link->b };
        out[k] = patch_make(place, is_cloth ? &s->face[3 * k] : ends, b->first);
    }
    return n;
}

// What was found at worst: over all frames, or at the end.
typedef struct {
    real strain, end;       // in any frame; at the end
    long crossing;          // pairs of triangles, or of triangle and link,
                            // summed over the frames that were looked at
    long inside, cutting;   // particles in the solid box; triangles cutting it
} findings;

// In a rigid body: particles, and triangles.
static void look_in_solid(const world *w, int number, int rigid, findings *f)
{
    static solid stone;
    const body *b = &w->body[number];
    judge_solid(w, rigid, &stone);
    int n = patches_make(w, number, sheet);
    for (int k = 0; k < n; k++) f->cutting += solid_is_cut(&stone, &sheet[k]);
    for (int i = 0; i < b->shape->particles; i++)
        f->inside += solid_depth(&stone, place[i]) > 0;
}

// Cloths and ropes together: nothing may pass through anything.
static void look_for_crossings(const world *w, findings *f)
{
    int n = 0;
    for (int b = 0; b < w->bodies; b++)
        if (body_is_soft(&w->body[b])) n += patches_make(w, b, sheet + n);
    f->crossing += crossings_count(sheet, n);
}

// ---- 24: cloth that falls, and folds ---------------------------------------

// How long, how many starts, how often everything is counted.
typedef struct {
    int frames, starts, every;
} effort;

// Lets a world that has begun run; body 1 is the cloth, it falls on body 0.
static void watch(world *w, effort e, findings *f)
{
    real strain = 0;
    for (int k = 1; k <= e.frames; k++) {
        world_step(w);
        strain = world_measure(w).strain;
        f->strain = hard_worse(f->strain, strain);
        if (k % e.every != 0 && k != e.frames) continue;
        look_for_crossings(w, f);
        if (!body_is_soft(&w->body[0])) look_in_solid(w, 1, 0, f);
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
        watch(&s.world, e, &f);
        world_scene_free(&s);
    }
    return f;
}

static findings run_fold(hard_report *r, fold_kind kind, int n, effort e)
{
    findings f = { .strain = 0 };
    for (int k = 0; k < e.starts; k++) {
        setting s;
        build_fold(&s, kind, n);
        int is_ready = hard_ok(r, setting_begin(&s));
        if (is_ready) perturb(&s.w, 1, 200 + (unsigned long long)k);
        if (is_ready) watch(&s.w, e, &f);
        setting_free(&s);
    }
    return f;
}

// ---- is anything counted? ---------------------------------------------------

// The cloth on the cube again, without room for pairs of particles, and not
// certified: nothing keeps it out of itself.
static void check_counting(hard_report *r, int n, int frames)
{
    world_scene s;
    scene_options what = scene_options_default();
    scene_kind kind = SCENE_CLOTH_ON_CUBE;
    what.cloth = n;
    if (!hard_ok(r, world_scene_build(&s, kind, what,
                                      world_scene_options(kind, what.cloth))))
        return;
    probe_lists(&s.world)->pair_capacity = 0;
    s.world.options.certified = false;
    for (int k = 0; k < frames; k++) world_step(&s.world);
    int patches = patches_make(&s.world, 1, sheet);
    long found = crossings_count(sheet, patches);
    long all = crossings_count_slowly(sheet, patches);
    real strain = world_measure(&s.world).strain;
    hard_add(r, all > 0 ? fabs((double)(found - all)) : HUGE_VAL, 0, "",
             "crossings that the quick count misses");
    hard_note(r, "%d x %d on the cube, nothing keeping it out of itself: %ld "
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
    check_counting(r, 40, 300);
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
    vec3 down = vec3_make(0, soft_gap(b, &s->w.body[0]) - 1, 0);
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
        for (int k = 0; k < probe_lists(w)->pairs; k++)
            s.touching += particle_contact_overlaps(&probe_lists(w)->pair[k],
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
