// 15-impact.c - a box strikes a plate with its corners: how wrong is an impact
// where the substep began, and what does the engine gain on the plain form?
//
// index 0: degrees by which the box turns in a substep, then how far the velocity
//          after the impact is off, as a share of the speed: struck where the
//          substep began; by the engine (both beside the plain form)
// index 1: corners that strike together, then ns for an impact: the plain form,
//          the engine; how many times as long the plain form takes
// Columns are separated by spaces.

#include "clock.h"
#include "plain_impact.h"
#include "random.h"
#include "restitution.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { BOX, PLATE, SHOTS = 2000, TIMED = 200 };
static const real H = 1.0 / 240, SPEED = 4, RESTITUTION = 0.5;

static shape box_shape;
static rigid4 box_four;
static unsigned long long seed = 1;

// One impact, for both forms.
typedef struct {
    solver_body body[2];
    motion velocity[2], moved[2];
    contact touch;
} striking;

// The plate is below along n; point k of the box is over it by `gap` (m).
static void add_corner(striking *s, int vertex, real gap)
{
    contact *c = &s->touch;
    vec3 local = box_four.local[vertex];
    vec3 at = frame_point(&s->body[BOX].frame, local);
    c->point[c->count++] = (contact_point){ .local_a = local, .own = 1,
        .local_b = vec3_add_scaled(at, -gap, c->normal) };
}

static int furthest_corner(vec3 d)
{
    int best = 0;
    for (int v = 1; v < box_shape.particles; v++)
        if (vec3_dot(box_shape.at[v], d) > vec3_dot(box_shape.at[best], d)) best = v;
    return best;
}

// The box flies at the plate at SPEED and turns by `turn` (rad) in the substep.
static striking make_scene(vec3 n, real turn)
{
    striking s = { .touch = { .a = BOX, .b = PLATE, .normal = n } };
    s.body[BOX] = (solver_body){ .radius = 1, .frame = rigid4_rest(&box_four) };
    s.body[BOX].basis = basis_find(&box_four, &s.body[BOX].frame);
    s.body[PLATE] = (solver_body){ .radius = 1, .basis = MOTION_IMMOVABLE,
        .frame = { .axis = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } } };
    vec3 spin = vec3_scale(turn / H, random_direction(&seed));
    s.velocity[BOX] = motion_make(&s.body[BOX].basis, vec3_scale(-SPEED, n), spin);
    return s;
}

static plain_impact plain_of(const striking *s)
{
    plain_impact x = { .normal = s->touch.normal, .points = s->touch.count,
                       .restitution = RESTITUTION };
    for (int b = BOX; b <= PLATE; b++)
        x.body[b] = (plain_body){ s->body[b].frame, s->body[b].basis, s->velocity[b] };
    for (int k = 0; k < s->touch.count; k++) {
        x.at[BOX][k] = s->touch.point[k].local_a;
        x.at[PLATE][k] = s->touch.point[k].local_b;
    }
    return x;
}

// Returns how many impacts there were: one that strikes again is one more.
static int run_engine(striking *s)
{
    const contact *table = &s->touch;
    solver_frame f = { .body = s->body, .bodies = 2, .h = H,
                       .restitution = RESTITUTION };
    return restitution_solve(&table, 1, &f, s->body, s->velocity,
                             s->moved);
}

// ---- the errors

static void print_errors(void)
{
    printf("# errors: degrees a substep, where it began, engine\n");
    for (int k = 0; k <= 10; k++) {
        real degrees = 0.1 * pow(10, 0.25 * k), began = 0, engine = 0;
        int hits = 0;
        for (int i = 0; i < SHOTS; i++) {
            vec3 n = random_direction(&seed);
            striking s = make_scene(n, degrees * 3.141592653589793 / 180);
            add_corner(&s, furthest_corner(vec3_scale(-1, n)),
                       random_fraction(&seed) * SPEED * H);
            plain_impact plain = plain_of(&s), first = plain;
            if (!(plain_impact_step(&plain, H) < H)) continue;
            first.at[PLATE][0] = frame_point(&s.body[BOX].frame, first.at[BOX][0]);
            plain_impact_step(&first, H);
            if (run_engine(&s) != 1) continue;
            vec3 right = motion_straight(&plain.body[BOX].velocity);
            began += vec3_distance(motion_straight(&first.body[BOX].velocity), right);
            engine += vec3_distance(motion_straight(&s.velocity[BOX]), right);
            hits++;
        }
        printf("%.3g %.3g %.1g\n", degrees, began / hits / SPEED,
               engine / hits / SPEED);
    }
    printf("\n\n");
}

// ---- the times

// Way 2 k - 2 is the plain form of k corners, way 2 k - 1 the engine.
static void strike_all(int way, void *with)
{
    striking *of = with;
    const striking *s = of + way / 2 * TIMED;
    for (int i = 0; i < TIMED; i++) {
        striking now = s[i];
        plain_impact x = plain_of(&now);
        if (way % 2) run_engine(&now);
        else plain_impact_step(&x, H);
    }
}

// A side of the box is over the plate, level, with up to four of its corners.
static void print_times(void)
{
    static striking all[CONTACT_POINTS * TIMED];
    lap took[2 * CONTACT_POINTS];
    for (int k = 0; k < CONTACT_POINTS; k++)
        for (int i = 0; i < TIMED; i++) {
            striking s = make_scene(vec3_make(0, 1, 0), 0);
            real gap = random_fraction(&seed) * SPEED * H;
            for (int v = 0; s.touch.count <= k; v++)
                if (box_shape.at[v].y < 0) add_corner(&s, v, gap);
            all[k * TIMED + i] = s;
        }
    clock_race((race){ 2 * CONTACT_POINTS, 15, 0.01, strike_all, all }, took);
    printf("# times: corners, ns by the plain form, by the engine, ratio\n");
    for (int k = 0; k < CONTACT_POINTS; k++) {
        real plain = took[2 * k].seconds / TIMED, fast = took[2 * k + 1].seconds / TIMED;
        printf("%d %.0f %.0f %.3g\n", k + 1, 1e9 * plain, 1e9 * fast, plain / fast);
    }
}

int main(void)
{
    if (!shape_box(&box_shape, vec3_make(0.4, 0.6, 1), 1).ok) return 1;
    if (!rigid4_build(&box_four, &box_shape).ok) return 1;
    clock_print_head("impacts of a box of 0.4 x 0.6 x 1 m and 1 kg on a plate, at"
                     " 4 m/s, with restitution 0.5 and substeps of 1/240 s", FLAGS);
    print_errors();
    print_times();
    rigid4_free(&box_four);
    shape_free(&box_shape);
}
