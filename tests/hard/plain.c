// plain.c - the first 26 hard cases once for the paper's system of Part I, as
// mended, with its default options: one line each, and a count.
//
// The targets are the engine's.  Where a case asks a module of Part I itself,
// the engine's own experiment is run; elsewhere a shorter one of the same kind.
//
//   hard-plain                  all of them
//   hard-plain --list           numbers and names
//   hard-plain --head           the head of figures/tables/hard-plain.csv
//   hard-plain --row 3          what case 3 writes below it; its line: to stderr

#include "experiments.h"
#include "hard.h"
#include "hard_set.h"
#include "hit_face.h"
#include "measure.h"
#include "poses.h"
#include "random.h"
#include "step.h"
#include "system.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const real PI = 3.14159265358979323846;
static const real G = 9.81;                     // m/s^2

// ---- A system from a setting -------------------------------------------------

typedef struct {
    scene scene;
    particle_system s;
    vec3 *at;           // [particles] m, for poses
    int   borrowed;     // 1: the shapes belong to a setting
} plain;

static int begin(hard_report *r, plain *p, system_options o)
{
    if (!hard_ok(r, system_init(&p->s, &p->scene, o))) return 0;
    p->at = malloc(((size_t)p->s.pool.count + 1) * sizeof *p->at);
    return hard_ok(r, p->at ? status_ok() : status_out_of_memory());
}

static void end(plain *p)
{
    system_free(&p->s);
    if (p->borrowed) p->scene.shapes = 0;
    scene_free(&p->scene);
    free(p->at);
    *p = (plain){ .borrowed = 0 };
}

// What a setting has built, at rest where it stands: its shapes are borrowed.
static int begin_setting(hard_report *r, plain *p, setting *from)
{
    world *w = &from->w;
    *p = (plain){ .borrowed = 1 };
    if (!hard_ok(r, from->ok)) return 0;
    int ok = 1;
    for (int k = 0; k < from->plans && ok; k++) {
        shape copy = from->plan[k];
        ok = hard_ok(r, scene_add_shape(&p->scene, &copy));
    }
    for (int k = 0; k < w->planes && ok; k++)
        ok = hard_ok(r, scene_add_plane(&p->scene, w->plane[k].normal,
                                        w->plane[k].offset));
    for (int b = 0; b < w->bodies && ok; b++) {
        const shape *plan = w->body[b].shape;
        placement where = placement_at(vec3_make(0, 0, 0));
        where.is_static = !(w->body[b].mass < HUGE_VAL);
        ok = hard_ok(r, scene_add(&p->scene, (int)(plan - from->plan), where));
        vec3 *start = malloc((size_t)plan->particles * sizeof *start);
        if (!ok || !start) return 0;
        world_vertices(w, &w->body[b], start);
        p->scene.body[b].start = start;
    }
    system_options o = system_options_mended();
    o.gravity = w->options.gravity;
    o.friction = w->options.friction;
    return ok && begin(r, p, o);
}

static void run(plain *p, real seconds)
{
    int frames = (int)(seconds / p->s.options.dt + 0.5);
    for (int f = 0; f < frames; f++) system_step(&p->s);
}

static poses look(plain *p)
{
    for (int i = 0; i < p->s.pool.count; i++)
        p->at[i] = p->s.pool.at[i].position;
    return poses_measure(&p->scene, p->at);
}

static vec3 mean_of(const plain *p, int b)
{
    const system_body *x = &p->s.body[b];
    vec3 sum = { 0, 0, 0 };
    int n = x->shape->particles;
    for (int i = 0; i < n; i++)
        sum = vec3_add_scaled(sum, 1.0 / n,
                              p->s.pool.at[x->first + i].position);
    return sum;
}

static vec3 speed_of(const plain *p, int b)
{
    const system_body *x = &p->s.body[b];
    vec3 sum = { 0, 0, 0 };
    int n = x->shape->particles;
    real h = p->s.options.dt / p->s.options.substeps;
    for (int i = 0; i < n; i++) {
        const particle *q = &p->s.pool.at[x->first + i];
        sum = vec3_add_scaled(sum, 1 / (n * h),
                              vec3_sub(q->position, q->previous));
    }
    return sum;
}

static system_options floating(void)
{
    system_options o = system_options_mended();
    o.gravity = vec3_make(0, 0, 0);
    return o;
}

// ---- 7 to 10: ropes, and a body that turns -------------------------------------

// A rope of n links of 1 m in all along x, pinned at its beginning.
static int begin_rope(hard_report *r, plain *p, int n)
{
    shape rope;
    *p = (plain){ .borrowed = 0 };
    return hard_ok(r, shape_rope(&rope, n, 1, 1))
        && hard_ok(r, scene_add_shape(&p->scene, &rope))
        && hard_ok(r, scene_add(&p->scene, 0, placement_at(vec3_make(0, 0, 0))))
        && hard_ok(r, scene_add_pin(&p->scene, 0, 0))
        && begin(r, p, system_options_mended());
}

static void swinging_chain(hard_report *r)
{
    plain p;
    real worst = 0;
    if (begin_rope(r, &p, 20))
        for (int f = 0; f < 600; f++) {
            run(&p, p.s.options.dt);
            worst = hard_worse(worst, look(&p).strain);
        }
    hard_add(r, worst, 1e-5, "", "strain of a chain let go from 90 degrees");
    end(&p);
}

static void loaded_rope(hard_report *r)
{
    plain p;
    if (begin_rope(r, &p, 50)) {
        p.s.pool.at[50].inverse_mass /= 10000;
        run(&p, 10);
        hard_add(r, look(&p).strain, 1e-8, "",
                 "strain, 10,000 particles' weight at the end");
    }
    end(&p);
}

static void hanging_chain(hard_report *r)
{
    plain p = { .borrowed = 0 };
    if (hard_ok(r, scene_build(&p.scene, SCENE_CLOTH_ON_ROPE,
                               scene_options_default()))) {
        p.scene.bodies = 1;
        if (begin(r, &p, system_options_mended())) {
            run(&p, 10);
            real off = 0;
            for (int i = 0; i < 51; i++)
                off = hard_worse(off, vec3_distance(p.s.pool.at[i].position,
                                                    p.scene.body[0].start[i]));
            hard_add(r, off / 3, 1e-6, "", "distance from the chain / length");
        }
        p.scene.bodies = 2;
    }
    end(&p);
}

static int add_box_to(hard_report *r, plain *p, vec3 sides, real mass,
                      placement where)
{
    shape box;
    return hard_ok(r, shape_box(&box, sides, mass))
        && hard_ok(r, scene_add_shape(&p->scene, &box))
        && hard_ok(r, scene_add(&p->scene, p->scene.shapes - 1, where));
}

static vec3 angular_momentum(const plain *p)
{
    vec3 sum = { 0, 0, 0 };
    real h = p->s.options.dt / p->s.options.substeps;
    for (int i = 0; i < p->s.pool.count; i++) {
        const particle *q = &p->s.pool.at[i];
        vec3 v = vec3_scale(1 / h, vec3_sub(q->position, q->previous));
        vec3 x = vec3_scale(0.5, vec3_add(q->position, q->previous));
        if (q->inverse_mass > 0)
            sum = vec3_add_scaled(sum, 1 / q->inverse_mass, vec3_cross(x, v));
    }
    return sum;
}

static void free_bodies(hard_report *r)
{
    unsigned long long seed = 10;
    real drift = 0, strain = 0;
    for (int n = 0; n < 20; n++) {
        plain p = { .borrowed = 0 };
        placement where = turned_anyhow(vec3_make(0, 0, 0), &seed);
        real spin = 2 + 8 * random_fraction(&seed);
        where.spin = vec3_scale(spin, random_direction(&seed));
        if (add_box_to(r, &p, vec3_make(1, 0.7, 0.4), 1, where)
            && begin(r, &p, floating())) {
            run(&p, 1 / 60.0);
            vec3 before = angular_momentum(&p);
            run(&p, 10);
            vec3 lost = vec3_sub(angular_momentum(&p), before);
            drift = hard_worse(drift, vec3_length(lost) / vec3_length(before));
            strain = hard_worse(strain, look(&p).strain);
        }
        end(&p);
    }
    hard_add(r, drift, 1e-12, "", "of angular momentum; boxes");
    hard_note(r, "strain up to %.1e", strain);
}

// ---- 13 to 20: bodies ----------------------------------------------------------

static void two_bodies(hard_report *r)
{
    unsigned long long seed = 13;
    real momentum = 0, share = 0;
    for (real ratio = 1; ratio <= 10000; ratio *= 10)
        for (int n = 0; n < 20; n++) {
            plain p = { .borrowed = 0 };
            placement a = turned_anyhow(vec3_make(-1, 0, 0), &seed);
            placement b = turned_anyhow(vec3_make(1, 0.2, 0.1), &seed);
            vec3 sides = { 1, 0.8, 0.6 };
            a.velocity = vec3_make(3, 0, 0);
            b.velocity = vec3_make(-3, 0, 0);
            if (add_box_to(r, &p, sides, 1, a)
                && add_box_to(r, &p, sides, ratio, b)
                && begin(r, &p, floating())) {
                vec3 a0 = speed_of(&p, 0), b0 = speed_of(&p, 1);
                run(&p, 1);
                vec3 da = vec3_sub(speed_of(&p, 0), a0);
                vec3 db = vec3_sub(speed_of(&p, 1), b0);
                vec3 change = vec3_add_scaled(da, ratio, db);
                real of_a = vec3_length(da)
                          / (vec3_length(da) + vec3_length(db));
                momentum = hard_worse(momentum, vec3_length(change)
                                                / (3 * (1 + ratio)));
                if (vec3_length(da) > 3e-3)
                    share = hard_worse(share, fabs(of_a - ratio / (1 + ratio)));
            }
            end(&p);
        }
    hard_add(r, momentum, 1e-12, "", "momentum; to 1:10000");
    hard_add(r, share, 1e-12, "", "share of the push; to 1:10000");
}

static void newtons_cradle(hard_report *r)
{
    plain p = { .borrowed = 0 };
    system_options o = floating();
    int ok = 1;
    o.friction = 0;
    for (int i = 0; i < CRADLE && ok; i++) {
        placement where = placement_at(vec3_make(1.02 * i - (i ? 0 : 0.3), 0, 0));
        where.velocity.x = i ? 0 : CRADLE_SPEED;
        ok = add_box_to(r, &p, vec3_make(1, 1, 1), 1, where);
    }
    if (ok && begin(r, &p, o)) {
        run(&p, 1);
        real off = 0;
        for (int i = 0; i < CRADLE; i++) {
            vec3 want = { i == CRADLE - 1 ? CRADLE_SPEED : 0, 0, 0 };
            off = hard_worse(off, vec3_distance(speed_of(&p, i), want));
        }
        hard_add(r, off / CRADLE_SPEED, 0.02, "", "end speeds");
        hard_note(r, "the paper's system has no restitution");
    }
    end(&p);
}

static void bounces(hard_report *r)
{
    setting s;
    plain p;
    world_options o = best(8);
    build_bounce(&s, o);
    if (begin_setting(r, &p, &s)) {
        real floor = mean_of(&p, 0).y - 1, top = 0;
        for (int f = 0; f < 72; f++) {
            run(&p, p.s.options.dt);
            if (f > 30) top = fmax(top, mean_of(&p, 0).y - floor);
        }
        hard_add(r, fabs(top), 0.01, "m", "height, restitution 0");
        hard_add(r, fabs(top - 0.25), 0.01, "m", "height, restitution 0.5");
    }
    end(&p);
    setting_free(&s);
}

static void slopes(hard_report *r)
{
    for (int degrees = 5; degrees <= 45; degrees += 10) {
        real tilt = degrees * PI / 180, mu = tan((degrees + 1) * PI / 180);
        real loose = tan((degrees - 1) * PI / 180);
        for (int k = 0; k < 2; k++) {
            setting s;
            plain p;
            build_slope(&s, best(8), tilt, k ? loose : mu, 0);
            if (begin_setting(r, &p, &s)) {
                vec3 from = mean_of(&p, 0);
                run(&p, 10);
                real slid = vec3_distance(mean_of(&p, 0), from);
                real want = G * (sin(tilt) - loose * cos(tilt)) * 50;
                if (k) hard_add(r, fabs(slid / want - 1), 0.01, "",
                                "slides; %d degrees, mu 1 under", degrees);
                else   hard_add(r, slid, 0.001, "m",
                                "sticks; %d degrees, mu 1 over", degrees);
            }
            end(&p);
            setting_free(&s);
        }
    }
}

// The largest way of a body of a pile from where it began, after so long.
static real drift_of(hard_report *r, setting *s, real seconds, int each,
                     real *deepest)
{
    plain p;
    real drift = 0;
    *deepest = 0;
    if (begin_setting(r, &p, s)) {
        int n = p.s.bodies;
        vec3 *from = malloc((size_t)n * sizeof *from);
        for (int b = 0; b < n && from; b++) from[b] = mean_of(&p, b);
        for (int k = 0; k < 10 * seconds && from; k++) {
            run(&p, 0.1);
            *deepest = hard_worse(*deepest, look(&p).overlap);
            for (int b = 0; b < n; b++)
                drift = hard_worse(drift, vec3_distance(mean_of(&p, b), from[b])
                                          / (each ? b + 1 : 1));
        }
        free(from);
    }
    end(&p);
    setting_free(s);
    return drift;
}

static void stacks(hard_report *r)
{
    const int cubes[] = { 10, 20, 50 };
    for (int k = 0; k < 3; k++) {
        setting s;
        real deep;
        build_stack(&s, best(8), cubes[k], 1);
        real drift = drift_of(r, &s, 30, 1, &deep);
        hard_add(r, 1e3 * drift, 1, "mm", "drift a cube; %d", cubes[k]);
        hard_add(r, deep, 0.005, "m", "penetration; %d", cubes[k]);
    }
}

static void heavy_on_light(hard_report *r)
{
    const int ratio[] = { 100, 300, 1000 };
    for (int k = 0; k < 3; k++) {
        setting s;
        real deep;
        build_stack(&s, best(8), 2, ratio[k]);
        hard_add(r, drift_of(r, &s, 30, 0, &deep), 0.01, "m",
                 "moved; %d to 1", ratio[k]);
    }
}

static void card_house(hard_report *r)
{
    setting s;
    real deep;
    build_card_house(&s, standing(8, 0.7, 1), 5, 20 * PI / 180);
    hard_add(r, drift_of(r, &s, 10, 0, &deep), 0.01, "",
             "displacement / size; cards");
    build_arch(&s, standing(8, 0.7, 1), 11, 1.3);
    hard_add(r, drift_of(r, &s, 10, 0, &deep) / 1.3, 0.01, "",
             "displacement / size; arch");
}

static void overlapping_cubes(hard_report *r)
{
    const vec3 offset[] = { { 0.5, 0, 0 }, { 0.5, 0.1, 0.05 },
                            { 0.5, 0.5, 0.5 }, { 0.1, 0, 0 }, { 0, 0, 0 } };
    real fastest = 0, left = 0;
    for (int k = 0; k < 5; k++) {
        setting s;
        plain p;
        build_overlap(&s, best(8), offset[k]);
        if (begin_setting(r, &p, &s)) {
            for (int f = 0; f < 120; f++) {
                run(&p, p.s.options.dt);
                vec3 apart = vec3_sub(speed_of(&p, 1), speed_of(&p, 0));
                fastest = hard_worse(fastest, vec3_length(apart));
            }
            left = hard_worse(left, look(&p).overlap);
        }
        end(&p);
        setting_free(&s);
    }
    hard_add(r, fastest, 3, "m/s", "leaving");
    hard_add(r, left, 0.001, "m", "still inside after 2 s");
}

// ---- 21 to 26 ------------------------------------------------------------------

static void bullets(hard_report *r)
{
    unsigned long long seed = 21;
    const real speed[] = { 10, 30, 100 };
    for (int k = 0; k < 3; k++) {
        int through = 0;
        for (int n = 0; n < 30; n++) {
            plain p = { .borrowed = 0 };
            shape ball;
            placement plate = placement_at(vec3_make(0, 0, 0));
            plate.is_static = true;
            real above = 1 + random_fraction(&seed);
            placement shot = turned_anyhow(vec3_make(0, above, 0), &seed);
            shot.velocity.y = -speed[k];
            if (add_box_to(r, &p, vec3_make(1, 0.01, 1), 1, plate)
                && hard_ok(r, shape_icosahedron(&ball, 0.05, 0.5))
                && hard_ok(r, scene_add_shape(&p.scene, &ball))
                && hard_ok(r, scene_add(&p.scene, 1, shot))
                && begin(r, &p, floating())) {
                run(&p, 0.5);
                through += !(mean_of(&p, 1).y > 0);
            }
            end(&p);
        }
        hard_add(r, through, 0, "", "of 30 through a static plate; %g m/s",
                 speed[k]);
    }
}

static void falling_cloth(hard_report *r)
{
    for (int kind = SCENE_CLOTH_ON_CUBE; kind <= SCENE_CLOTH_ON_ROPE; kind++) {
        plain p = { .borrowed = 0 };
        if (hard_ok(r, scene_build(&p.scene, (scene_kind)kind,
                                   scene_options_default()))
            && begin(r, &p, system_options_mended())) {
            run(&p, 5);
            poses m = look(&p);
            hard_add(r, m.strain, 0.01, "", "strain at the end; %s",
                     scene_name((scene_kind)kind));
            hard_add(r, m.inside, 0.008, "m", "inside; %s",
                     scene_name((scene_kind)kind));
        }
        end(&p);
    }
}

static void flat_cloth(hard_report *r)
{
    for (int n = 5; n <= 45; n += 20) {
        plain p = { .borrowed = 0 };
        shape cloth;
        if (hard_ok(r, shape_cloth(&cloth, n, n, 1, 1, 1, 0.2))
            && hard_ok(r, scene_add_shape(&p.scene, &cloth))
            && hard_ok(r, scene_add(&p.scene, 0,
                                    placement_at(vec3_make(0, 0, 0))))
            && begin(r, &p, floating())) {
            run(&p, 1);
            real moved = 0;
            for (int i = 0; i < p.s.pool.count; i++)
                moved = hard_worse(moved, vec3_distance(
                    p.s.pool.at[i].position, scene_position(&p.scene, 0, i)));
            hard_add(r, p.s.contacts, 0, "", "contacts; %d x %d", n, n);
            hard_add(r, moved, 1e-12, "m", "moved; %d x %d", n, n);
        }
        end(&p);
    }
}

static void full_room(hard_report *r)
{
    const int bodies[] = { 10, 100, 1000 };
    for (int k = 0; k < 3; k++) {
        plain p = { .borrowed = 0 };
        scene_options what = scene_options_default();
        what.bodies = bodies[k];
        real deep = 0;
        int outside = 0;
        if (hard_ok(r, scene_build(&p.scene, SCENE_ROOM, what))
            && begin(r, &p, system_options_mended()))
            for (int f = 0; f < (k < 2 ? 600 : 240); f++) {
                run(&p, p.s.options.dt);
                if (k == 2 && f % 10) continue;
                poses m = look(&p);
                deep = hard_worse(deep, fmax(m.overlap, m.behind));
                outside += m.outside;
            }
        hard_add(r, deep / SCENE_BODY_RADIUS, 0.05, "radii",
                 "penetration; %d bodies", bodies[k]);
        hard_add(r, outside, 0, "", "outside; %d bodies", bodies[k]);
        end(&p);
    }
}

// ---- All of them -----------------------------------------------------------------

// NULL: the case asks modules of Part I themselves.
// The cases from 27 on ask the engine's cloth only.
enum { PLAIN_LAST = 26 };
static void (*const experiment[PLAIN_LAST + 1])(hard_report *) = {
    [7] = swinging_chain, [8] = loaded_rope, [9] = hanging_chain,
    [10] = free_bodies, [13] = two_bodies, [14] = newtons_cradle,
    [15] = bounces, [16] = slopes, [17] = stacks, [18] = heavy_on_light,
    [19] = card_house, [20] = overlapping_cubes, [21] = bullets,
    [24] = falling_cloth, [25] = flat_cloth,
    [26] = full_room,
};

static void print(FILE *out, const hard_case *c, const hard_report *r, int csv)
{
    const hard_part *w = hard_worst(r);
    const char *verdict = hard_holds(w) ? "holds" : "FALLS SHORT";
    if (csv)
        fprintf(out, "%d,\"%s\",\"%s\",%.2g %s,%.2g %s,%s\n", c->number,
                c->name, w->what, w->error, w->unit, w->target, w->unit,
                verdict);
    else
        fprintf(out, "%2d  %-31s %-44s %9.2e %9.2e %-5s %s\n", c->number,
                c->name, w->what, w->error, w->target, w->unit, verdict);
    fflush(out);
}

static int run_case(const hard_case *c, int is_row)
{
    hard_report *r = calloc(1, sizeof *r);
    if (!c || !r) exit(2);
    if (experiment[c->number]) experiment[c->number](r);
    else                       c->run(r, 1);
    int holds = hard_holds(hard_worst(r));
    print(is_row ? stderr : stdout, c, r, 0);
    if (is_row) print(stdout, c, r, 1);
    free(r);
    return holds;
}

static int run_all(void)
{
    int hold = 0;
    for (int number = 1; number <= PLAIN_LAST; number++)
        hold += run_case(hard_find(number), 0);
    printf("%d of %d hold on the paper's system\n", hold, PLAIN_LAST);
    return 0;
}

static int list_all(void)
{
    for (int number = 1; number <= PLAIN_LAST; number++)
        printf("%2d  %s\n", number, hard_find(number)->name);
    return 0;
}

static int print_head(void)
{
    printf("# The hard cases once on the paper's system, mended: of each the "
           "worst number beside the engine's target\n"
           "number,case,measured,error,target,verdict\n");
    return 0;
}

int main(int count, char **word)
{
    int number = count == 3 ? atoi(word[2]) : 0;
    if (count == 1) return run_all();
    if (count == 2 && strcmp(word[1], "--list") == 0) return list_all();
    if (count == 2 && strcmp(word[1], "--head") == 0) return print_head();
    if (strcmp(word[1], "--row") == 0 && number >= 1 && number <= PLAIN_LAST)
        return run_case(hard_find(number), 1), 0;
    fprintf(stderr, "usage: hard-plain [--list | --head | --row NUMBER]\n");
    return 2;
}
