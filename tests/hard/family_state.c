// family_state.c - rows 180 to 184: save and load, threads, and what a step may
// depend on.
//
// A kind of scene is made again for every question, so that nothing is asked
// twice of one world.

#include "family.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

// ---- Scenes of each kind ---------------------------------------------------

enum { MOST_TURNED = 4 };

// A world, and what a program does in each of its steps.
typedef struct {
    tumble_world *w;
    tumble_body driven[MOST_TURNED];
    int  many;
    void (*drive)(tumble_world *w, const tumble_body *b, int many, int step);
} scene;

static void add_floor(tumble_world *w)
{
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
}

// Boxes, balls, hulls and capsules that fall into each other.
static void pile(scene *s)
{
    tumble_world *w = s->w;
    tumble_shape kind[] = {
        tumble_shape_box(w, tumble_v(0.4, 0.3, 0.5), 2),
        tumble_shape_sphere(w, 0.2, 1),
        tumble_shape_icosahedron(w, 0.25, 1),
        tumble_shape_capsule(w, 0.4, 0.1, 0.5),
        family_prism(w, 12, 0.3, 0.1, 1)
    };
    family_seed seed = 180;
    add_floor(w);
    for (int i = 0; i < 40; i++) {
        tumble_body_options o = tumble_body_at(0.3 * (i % 3), 0.5 + 0.25 * i,
                                               0.3 * (i / 3 % 3));
        o.pose.rotation = family_rotation(&seed);
        o.spin = v_scale(3, family_direction(&seed));
        o.restitution = 0.2 * (i % 4);
        tumble_body_add(w, kind[i % 5], o);
    }
}

// Boxes in stacks, which sleep after a second.
static void sleepers(scene *s)
{
    add_floor(s->w);
    tumble_shape box = tumble_shape_box(s->w, tumble_v(0.5, 0.5, 0.5), 1);
    for (int i = 0; i < 20; i++)
        tumble_body_add(s->w, box,
                        tumble_body_at(i / 4, 0.25 + 0.5 * (i % 4), 0));
}

// A box on a ball joint, which spins about no axis of its own.
static void spin_box(scene *s, double spin)
{
    tumble_shape box = tumble_shape_box(s->w, tumble_v(1, 0.2, 0.1), 1);
    tumble_body_options o = tumble_body_at(0, 3, 0);
    o.spin = tumble_v(0.3 * spin, 0.5 * spin, 0.6 * spin);
    tumble_body b = tumble_body_add(s->w, box, o);
    tumble_joint_ball(s->w, tumble_body_ground(), b, tumble_v(0.5, 3, 0));
}

static void spin_10(scene *s)  { spin_box(s, 10); }
static void spin_80(scene *s)  { spin_box(s, 80); }
static void spin_160(scene *s) { spin_box(s, 160); }
static void spin_400(scene *s) { spin_box(s, 400); }

// A ball, a hinge with limits, a fixed and a distance joint, one under the
// other, and a heavy ball; one of them breaks on the way.
static void joints(scene *s)
{
    tumble_world *w = s->w;
    tumble_shape box = tumble_shape_box(w, tumble_v(0.5, 0.1, 0.1), 1);
    tumble_body link[5], before = tumble_body_ground();
    for (int i = 0; i < 5; i++) {
        tumble_vec3 at = { 0.5 * i, 3, 0 };
        link[i] = tumble_body_add(w, box, tumble_body_at(at.x + 0.25, 3, 0));
        if (i == 1) {
            tumble_joint j = tumble_joint_hinge(w, before, link[i], at,
                                                tumble_v(0, 0, 1));
            tumble_joint_set_limits(w, j, -0.4, 0.4);
        } else if (i == 2) tumble_joint_fixed(w, before, link[i], at);
        else if (i == 3)
            tumble_joint_distance(w, before, at, link[i], at, 0, 0.1);
        else tumble_joint_ball(w, before, link[i], at);
        before = link[i];
    }
    tumble_body ball = tumble_body_add(w, tumble_shape_sphere(w, 0.2, 20),
                                       tumble_body_at(2.7, 3, 0));
    tumble_joint last = tumble_joint_ball(w, before, ball, tumble_v(2.5, 3, 0));
    tumble_joint_set_strength(w, last, 500);
}

static void wheel(scene *s)
{
    tumble_world *w = s->w;
    tumble_body arm =
        tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 0.1, 0.1), 1),
                        tumble_body_at(0.5, 2, 0));
    tumble_body_options o = tumble_body_at(1, 2, 0);
    o.spin = tumble_v(0, 60, 0);
    tumble_body disk = tumble_body_add(w, family_prism(w, 16, 0.3, 0.1, 2), o);
    tumble_joint_ball(w, tumble_body_ground(), arm, tumble_v(0, 2, 0));
    tumble_joint_hinge(w, arm, disk, tumble_v(1, 2, 0), tumble_v(0, 1, 0));
}

// A cloth that falls on a box, and one that hangs on two of its corners.
static void cloths(scene *s)
{
    tumble_world *w = s->w;
    add_floor(w);
    tumble_body_options o = tumble_body_at(0, 0.5, 0);
    o.kind = TUMBLE_STATIC;
    tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 1, 1), 1), o);
    tumble_shape cloth = tumble_shape_cloth(w, 12, 12, 2, 2, 0.4);
    tumble_body_add(w, cloth, tumble_body_at(0.1, 1.3, 0.2));
    tumble_body hung = tumble_body_add(w, cloth, tumble_body_at(0, 2, 5));
    tumble_body_pin(w, hung, 0);
    tumble_body_pin(w, hung, 11);
    tumble_body_set_bending(w, hung, 1e-3);
    tumble_body_set_stretch(w, hung, 1e-4);
}

// A rope over a bar, with a box hung on its end.
static void rope(scene *s)
{
    tumble_world *w = s->w;
    tumble_body_options o = tumble_body_at(0, 1, 0);
    o.kind = TUMBLE_STATIC;
    tumble_body_add(w, tumble_shape_box(w, tumble_v(0.3, 0.3, 2), 1), o);
    tumble_body r = tumble_body_add(w, tumble_shape_rope(w, 24, 2, 0.3),
                                    tumble_body_at(0.2, 1.3, 0));
    tumble_body box =
        tumble_body_add(w, tumble_shape_box(w, tumble_v(0.2, 0.2, 0.2), 1),
                        tumble_body_at(1.3, 1.3, 0));
    tumble_joint_hang(w, r, 24, box);
    tumble_body_pin(w, r, 0);
}

// A bar that turns, a plate that goes to and fro, and what lies between.
static void turn_about(tumble_world *w, const tumble_body *b, int many,
                       int step)
{
    double side = step / 30 % 2 ? 1 : -1;
    (void)many;
    tumble_body_set_velocity(w, b[1], tumble_v(side, 0, 0), tumble_v(0, 0, 0));
}

static void driven(scene *s)
{
    pile(s);
    tumble_body_options o = tumble_body_at(0, 0.3, 0);
    o.kind = TUMBLE_KINEMATIC;
    o.spin = tumble_v(0, 3, 0);
    s->driven[0] =
        tumble_body_add(s->w, tumble_shape_box(s->w, tumble_v(4, 0.4, 0.2), 1),
                        o);
    o = tumble_body_at(2.5, 0.5, 0);
    o.kind = TUMBLE_KINEMATIC;
    tumble_shape plate = tumble_shape_box(s->w, tumble_v(0.2, 1, 4), 1);
    s->driven[1] = tumble_body_add(s->w, plate, o);
    s->many = 2;
    s->drive = turn_about;
}

// What a program sets is for one step: it must be there when the step is
// another world's.
static void push_about(tumble_world *w, const tumble_body *b, int many,
                       int step)
{
    for (int i = 0; i < many; i++) {
        tumble_body_force(w, b[i], tumble_v(step % 7 - 3, 12, i - 2),
                          tumble_v(0, 1, 0));
        if (step % 20 == i)
            tumble_body_push(w, b[i], tumble_v(0, 0.5, 0.3),
                             tumble_body_position(w, b[i]));
        if (step % 50 == 10 * i)
            tumble_body_set_material(w, b[i], 0.1 * i, 0.5);
        if (step % 60 == 11 * i) tumble_body_set_damping(w, b[i], 0.2 * i, 0.1);
    }
}

static void pushed(scene *s)
{
    add_floor(s->w);
    tumble_shape box = tumble_shape_box(s->w, tumble_v(0.5, 0.5, 0.5), 1);
    for (int i = 0; i < MOST_TURNED; i++)
        s->driven[i] = tumble_body_add(s->w, box,
                                       tumble_body_at(0.7 * i, 0.4, 0));
    s->many = MOST_TURNED;
    s->drive = push_about;
}

// A floor of pieces, and fast things that fly at each other.
static void thrown(scene *s)
{
    tumble_world *w = s->w;
    tumble_shape piece[9], box = tumble_shape_box(w, tumble_v(2, 0.2, 2), 1);
    tumble_pose at[9];
    for (int i = 0; i < 9; i++) {
        piece[i] = box;
        at[i] = (tumble_pose){ { 2 * (i % 3) - 2, -0.1, 2 * (i / 3) - 2 },
                               { 0, 0, 0, 1 } };
    }
    tumble_body_add_pieces(w, piece, at, 9, tumble_body_at(0, 0, 0));
    tumble_shape plate = tumble_shape_box(w, tumble_v(1, 1, 0.02), 1);
    tumble_shape ball = tumble_shape_sphere(w, 0.05, 0.1);
    for (int i = 0; i < 5; i++) {
        tumble_body_add(w, plate, tumble_body_at(0, 0.5 + 1.1 * i, -1));
        for (int k = 1; k < 5; k++) {
            tumble_body_options o = tumble_body_at(0.2 * k - 0.5, 0.5 + 1.1 * i,
                                                   5 * k);
            o.velocity = tumble_v(0, 1, -60.0 * k);
            o.spin = tumble_v(0, 200, 0);
            tumble_body_add(w, ball, o);
        }
    }
}

typedef struct {
    const char *name;
    void (*build)(scene *s);
} scene_kind;

static const scene_kind KINDS[] = {
    { "pile", pile }, { "sleepers", sleepers }, { "spin 10", spin_10 },
    { "spin 80", spin_80 }, { "spin 160", spin_160 }, { "spin 400", spin_400 },
    { "joints", joints }, { "wheel", wheel }, { "cloths", cloths },
    { "rope and weight", rope }, { "driven", driven }, { "pushed", pushed },
    { "thrown", thrown }
};
enum { SCENES = sizeof KINDS / sizeof *KINDS };

static scene scene_begin(const scene_kind *kind, const tumble_options *o)
{
    scene s = { .w = tumble_world_make(o) };
    if (s.w) kind->build(&s);
    return s;
}

static void scene_step(scene *s, int step)
{
    if (s->drive) s->drive(s->w, s->driven, s->many, step);
    tumble_world_step(s->w);
}

// All that a program can ask of a body, in one number: FNV-1a.
static unsigned long long hash_more(unsigned long long h, const void *from,
                                    size_t size)
{
    const unsigned char *byte = from;
    for (size_t i = 0; i < size; i++) h = (h ^ byte[i]) * 1099511628211u;
    return h;
}

// Places, speeds, spins, who sleeps, what the report says.
static unsigned long long scene_hash(const scene *s)
{
    enum { MOST = 256 };
    tumble_body all[MOST];
    unsigned long long h = tumble_world_hash(s->w);
    int n = tumble_world_bodies(s->w, all, MOST);
    for (int i = 0; i < n && i < MOST; i++) {
        tumble_pose p = tumble_body_pose(s->w, all[i]);
        tumble_vec3 v = tumble_body_velocity(s->w, all[i]);
        tumble_vec3 spin = tumble_body_spin(s->w, all[i]);
        int awake = tumble_body_is_awake(s->w, all[i]);
        h = hash_more(h, &p, sizeof p);
        h = hash_more(h, &v, sizeof v);
        h = hash_more(h, &spin, sizeof spin);
        h = hash_more(h, &awake, sizeof awake);
    }
    tumble_report said = tumble_world_last_step(s->w);
    return hash_more(h, &said, sizeof said);
}

// ---- 180: save and load ----------------------------------------------------

// The world that such bytes give, in place of the one that gave them: all ids
// are good for it.
static scene scene_copy(const scene *s)
{
    scene copy = *s;
    size_t size = tumble_world_save(s->w, NULL, 0);
    void *bytes = malloc(size);
    copy.w = NULL;
    if (bytes && tumble_world_save(s->w, bytes, size) == size)
        copy.w = tumble_world_load(bytes, size);
    free(bytes);
    return copy;
}

// Steps of the next ones in which the two differ; and of those that were not
// saved at all, one that was never asked.
static void save_after(hard_report *r, family_worst *next, family_worst *later,
                       const scene_kind *kind, double dt, int before, int after)
{
    tumble_options o = family_options(dt, 0.5);
    scene s = scene_begin(kind, &o);
    for (int n = 0; n < before; n++) scene_step(&s, n);
    scene copy = scene_copy(&s);
    int differ = 0, at_once = 0;
    for (int n = before; n < before + after && copy.w; n++) {
        scene_step(&s, n);
        scene_step(&copy, n);
        int off = scene_hash(&s) != scene_hash(&copy);
        differ += off;
        if (n == before) at_once = off;
    }
    if (family_ok(r, s.w) && family_ok(r, copy.w)) {
        family_trial(next, at_once, "%s, after %d steps of 1/%.0f", kind->name,
                     before, 1 / dt);
        family_trial(later, differ, "%s, after %d steps of 1/%.0f", kind->name,
                     before, 1 / dt);
    }
    tumble_world_free(s.w);
    tumble_world_free(copy.w);
}

static void save_and_load(hard_report *r, int fast)
{
    static const int before[] = { 20, 0, 1, 45, 150 };
    family_worst next = { .target = 0 }, later = { .target = 0 };
    for (int k = 0; k < SCENES; k++)
        for (int i = 0; i < (fast ? 1 : 5); i++) {
            save_after(r, &next, &later, &KINDS[k], 1.0 / 60, before[i],
                       fast ? 20 : 120);
            if (!fast)
                save_after(r, &next, &later, &KINDS[k], 1.0 / 200, before[i],
                           200);
        }
    family_add(r, &next, "", "next steps with other bits after load");
    family_add(r, &later, "", "steps with other bits in the 2 s after load");
}

// ---- 181: to save changes nothing ------------------------------------------

// A world that is saved in every step, and one that never is; one that is taken
// through bytes again and again, and one that is not.
static void save_always(hard_report *r, int fast)
{
    family_worst asked = { .target = 0 }, carried = { .target = 0 };
    tumble_options o = family_options(1.0 / 60, 0.5);
    for (int k = 0; k < SCENES; k++) {
        scene plain = scene_begin(&KINDS[k], &o),
              saved = scene_begin(&KINDS[k], &o),
              moved = scene_begin(&KINDS[k], &o);
        int off = 0, other = 0;
        for (int n = 0; n < (fast ? 20 : 120) && moved.w; n++) {
            scene copy = scene_copy(&saved);
            tumble_world_free(copy.w);
            copy = scene_copy(&moved);
            tumble_world_free(moved.w);
            moved = copy;
            scene_step(&plain, n);
            scene_step(&saved, n);
            if (moved.w) scene_step(&moved, n);
            unsigned long long truth = scene_hash(&plain);
            off += scene_hash(&saved) != truth;
            other += moved.w ? scene_hash(&moved) != truth : 1;
        }
        if (family_ok(r, plain.w) && family_ok(r, moved.w)) {
            family_trial(&asked, off, "%s", KINDS[k].name);
            family_trial(&carried, other, "%s", KINDS[k].name);
        }
        tumble_world_free(plain.w);
        tumble_world_free(saved.w);
        tumble_world_free(moved.w);
    }
    family_add(r, &asked, "", "steps with other bits if saved in each");
    family_add(r, &carried, "", "steps with other bits if loaded in each");
}

// ---- 182: threads ----------------------------------------------------------

// How items are run: from the last, by chance, or on so many threads.
typedef struct {
    int threads;
    family_seed seed;   // 0: from the last
} runner;

typedef struct {
    void (*work)(void *data, int item);
    void *data;
    int  first, items, stride;
} share;

static void *run_share(void *of)
{
    const share *s = of;
    for (int i = s->first; i < s->items; i += s->stride) s->work(s->data, i);
    return NULL;
}

static void run_in_threads(int threads, void (*work)(void *data, int item),
                           void *data, int items)
{
    enum { MOST = 8 };
    pthread_t thread[MOST];
    share part[MOST], first = { work, data, 0, items, threads };
    for (int k = 1; k < threads; k++) {
        part[k] = first;
        part[k].first = k;
        if (pthread_create(&thread[k], NULL, run_share, &part[k]) != 0) abort();
    }
    run_share(&first);
    for (int k = 1; k < threads; k++) pthread_join(thread[k], NULL);
}

static void run_items(void *context, void (*work)(void *data, int item),
                      void *data, int items)
{
    runner *r = context;
    if (r->threads) {
        run_in_threads(r->threads, work, data, items);
    } else if (!r->seed) {
        for (int i = items - 1; i >= 0; i--) work(data, i);
    } else {
        // Every item once: steps that share no divisor with their number.
        int start = (int)(family_random(&r->seed) * items);
        int stride = items > 2 && items % 2 ? 2 : items - 1;
        for (int i = 0; i < items; i++)
            work(data, (start + i * (stride ? stride : 1)) % items);
    }
}

static void threads(hard_report *r, int fast)
{
    static const char *const name[] = {
        "from the last", "by chance", "2 threads", "3 threads", "8 threads"
    };
    static const runner how[] = {
        { 0, 0 }, { 0, 182 }, { 2, 0 }, { 3, 0 }, { 8, 0 }
    };
    family_worst differ = { .target = 0 };
    for (int k = 0; k < SCENES; k++)
        for (int i = 0; i < 5; i++) {
            // Threads that are made for each call are slow.
            int steps = fast ? 10 : i < 2 ? 120 : 40, off = 0;
            tumble_options o = family_options(1.0 / 60, 0.5);
            scene plain = scene_begin(&KINDS[k], &o);
            runner mine = how[i];
            o.run = run_items;
            o.context = &mine;
            scene other = scene_begin(&KINDS[k], &o);
            for (int n = 0; n < steps; n++) {
                scene_step(&plain, n);
                scene_step(&other, n);
                off += scene_hash(&plain) != scene_hash(&other);
            }
            if (family_ok(r, plain.w) && family_ok(r, other.w))
                family_trial(&differ, off, "%s, %s", KINDS[k].name, name[i]);
            tumble_world_free(plain.w);
            tumble_world_free(other.w);
        }
    family_add(r, &differ, "", "steps with other bits on threads");
}

// ---- 183: nothing is remembered --------------------------------------------

// The same program twice, with others between: nothing is kept outside of
// worlds.
static void again(hard_report *r, int fast)
{
    family_worst differ = { .target = 0 };
    unsigned long long first[SCENES];
    for (int pass = 0; pass < 2; pass++)
        for (int k = 0; k < SCENES; k++) {
            scene s = scene_begin(&KINDS[k], NULL);
            for (int n = 0; n < (fast ? 20 : 120); n++) scene_step(&s, n);
            unsigned long long h = scene_hash(&s);
            if (pass == 0) first[k] = h;
            else if (family_ok(r, s.w))
                family_trial(&differ, h != first[k], "%s", KINDS[k].name);
            tumble_world_free(s.w);
        }
    family_add(r, &differ, "", "scenes with other bits the second time");
}

const hard_case family_state[] = {
    { 180, "save and load, in the middle", 1, save_and_load },
    { 181, "to save changes nothing", 1, save_always },
    { 182, "threads and orders of work", 1, threads },
    { 183, "the same again", 1, again },
    { 0, NULL, 0, NULL }
};
