// hard.c - hard cases as a gallery: each begins as the judge begins it, and says what
// has moved that should not (chapter 20).

#include "handle.h"
#include "hard_drape_set.h"
#include "live.h"
#include "live_world.h"
#include "measure.h"
#include "step.h"
#include "view.h"

#include <stdlib.h>
#include <string.h>

enum { CASE };                                  // dial
enum { CRADLE_CASE, BOUNCE, SLOPE, STACK, HEAVY, CARDS, ARCH, HALF, BODY_CASES };
enum { CASES = BODY_CASES + 14 };

// What it asks, where the eye stands; and of a row of drape_table its name and its
// number of particles.
static const struct {
    const char *wants;
    vec3 eye, target;
    bool has_floor;
    const char *row;
    int n;
} shown[CASES] = {
    [CRADLE_CASE] = { "14. One cube comes in, so one goes out", { 6, 3, 11 }, { 2.5, 0, 0 }, false, NULL, 0 },
    [BOUNCE] = { "15. It comes back to the height of 1 m that it fell from", { 2, 2.6, 7 }, { 0, 1, 0 }, true, NULL, 0 },
    [SLOPE] = { "16. A slope of 25 degrees, and friction for 26", { 1.4, 1.6, 5 }, { 0, 0.2, 0 }, false, NULL, 0 },
    [STACK] = { "17. Twenty cubes stand", { 12, 13.5, 34 }, { 0, 10, 0 }, true, NULL, 0 },
    [HEAVY] = { "18. 1,000 kg stand on 1 kg", { 2, 2.5, 6 }, { 0, 1, 0 }, true, NULL, 0 },
    [CARDS] = { "19. Forty cards stand", { 4.4, 3.4, 9.5 }, { 0, 2.1, 0 }, true, NULL, 0 },
    [ARCH] = { "19. The thinnest arch stands", { 1.1, 1.5, 5 }, { 0, 0.6, 0 }, true, NULL, 0 },
    [HALF] = { "20. Two cubes that begin half inside each other part", { 1.7, 2.1, 6 }, { 0.25, 0, 0 }, false, NULL, 0 },
    { "27. Cloth hangs over a cube", { 1.5, 1.7, 2.9 }, { 0, 0.5, 0 }, true, "cube", 40 },
    { "28. Cloth falls on a ball", { 1.5, 1.7, 2.9 }, { 0, 0.5, 0 }, true, "ball", 40 },
    { "28. Cloth falls over a pole", { 1.9, 1.7, 3.3 }, { 0, 0.6, 0 }, false, "pole", 40 },
    { "28. Cloth falls on fourteen cubes", { 1.5, 1.7, 2.9 }, { 0, 0.4, 0 }, true, "pile of cubes", 40 },
    { "28. Cloth falls on a rope", { 2.2, 2.2, 4 }, { 0, 0.7, 0 }, false, "rope", 40 },
    { "29. A cloth folded in three hangs over a cube", { 1.5, 1.7, 2.9 }, { 0, 0, 0 }, false, "letter on cube", 40 },
    { "29. A cloth that stands on its edge crumples", { 1.6, 1.9, 3.6 }, { 0, 0.5, 0 }, true, "on its edge", 40 },
    { "30. Cloth falls on a needle", { 1.7, 1.8, 3.3 }, { 0, 0.6, 0 }, true, "needle", 60 },
    { "31. 10 kg lie in 0.2 kg of cloth", { 1, 0.7, 1.7 }, { 0, -0.1, 0 }, false, "hammock, sides", 21 },
    { "31. Cloth hangs by two pins, over a cube", { 1.6, 1.7, 3.2 }, { 0, 0.5, 0 }, true, "two pins, cube", 20 },
    { "33. Cloth is thrown at a cube, at 20 m/s", { 1.5, 1.7, 2.9 }, { 0, 0.5, 0 }, true, "thrown, 20 m/s", 40 },
    { "34. 10,000 times a link's mass hang over a cube", { 0.9, 0.9, 2 }, { 0.3, 0.55, 0 }, true, "the same, on cube", 50 },
    { "35. Eight cubes fall into a held cloth", { 1.8, 1.7, 3.4 }, { 0, 0.2, 0 }, false, "cubes, rim", 40 },
    { "36. Card hangs over a cube of 14 cm", { 0.3, 0.35, 0.6 }, { 0, 0.08, 0 }, true, "card", 40 },
};
static const real DEGREE = 3.14159265358979323846 / 180;
static setting now;
static bool is_built;
static int frame;

static void build(int k)
{
    const drape *row = drape_table;
    world_options bouncing = best(8);
    bouncing.restitution = 1;
    if (k == CRADLE_CASE) build_cradle(&now, best(8), 0.01, 1, -1);
    else if (k == BOUNCE) build_bounce(&now, bouncing);
    else if (k == SLOPE) build_slope(&now, kept_awake(best(8), true), 25 * DEGREE, tan(26 * DEGREE), 0);
    else if (k == STACK) build_stack(&now, standing(20, 0.5, true), 20, 1);
    else if (k == HEAVY) build_stack(&now, standing(60, 0.5, true), 2, 1000);
    else if (k == CARDS) build_card_house(&now, standing(20, 0.7, true), 5, 20 * DEGREE);
    else if (k == ARCH) build_arch(&now, standing(20, 0.7, true), 11, outer_radius(0.112));
    else if (k == HALF) build_overlap(&now, best(10), vec3_make(0.5, 0.1, 0.05));
    else {
        while (strcmp(row->name, shown[k].row) != 0 || row->n != shown[k].n) row++;
        drape_build(&now, row, 1);
    }
}

static void begin(void)
{
    int k = live_choice(CASE);
    if (is_built) setting_free(&now);
    build(k);
    is_built = true;
    frame = 0;
    view_look(shown[k].eye, shown[k].target, shown[k].has_floor);
    if (!setting_begin(&now).ok) live_say("%s", now.ok.why);
}

// --- Hands ------------------------------------------------------------------------
static vec3 particle_at(const body *b, int i)
{
    return now.w.pool.at[b->first + i].position;
}

static int nearest_particle(const body *b, vec3 to)
{
    int best_so_far = 0;
    for (int i = 1; i < b->shape->particles; i++)
        if (vec3_distance(particle_at(b, i), to) < vec3_distance(particle_at(b, best_so_far), to)) best_so_far = i;
    return best_so_far;
}

static void pull_particle(int b, int i)
{
    const body *x = &now.w.body[b];
    vec3 way = vec3_sub(view_back(live_touched()), particle_at(x, i));
    world_push_particle(&now.w, b, i, vec3_scale(40 * x->shape->mass[i], way));
}

static void pull(int b)
{
    if (body_is_soft(&now.w.body[b])) {
        pull_particle(b, nearest_particle(&now.w.body[b], view_back(live_touched())));
        return;
    }
    placement at = world_where(&now.w, b);
    vec3 a = live_pull(view_of(at.position), view_turn(at.velocity));
    world_push(&now.w, b, vec3_scale(now.w.body[b].mass / 60, view_turn_back(a)), at.position);
}

static void tap(int number, vec3 along)
{
    vec3 way = vec3_unit(view_turn_back(along));
    if (now.ok.ok && !body_is_soft(&now.w.body[number])) live_world_hurry(&now.w, number, vec3_scale(2, way));
}

// --- Frames -----------------------------------------------------------------------
static void step(void)
{
    if (!now.ok.ok) return;
    if (live_held() >= 0) pull(live_held());
    world_step(&now.w);
    frame++;
}

static real most_moved(void)
{
    real most = 0;
    for (int b = 0; b < now.w.bodies; b++)
        most = real_max(most, vec3_distance(middle(&now.w, b), now.start[b]));
    return most;
}

// Of all sticks that hold their length.
static real most_strained(void)
{
    real most = 0;
    for (int b = 0; b < now.w.bodies; b++) {
        const body *x = &now.w.body[b];
        for (int k = 0; k < x->shape->sticks && body_is_soft(x); k++) {
            const stick *s = &x->shape->stick[k];
            real length = vec3_distance(particle_at(x, s->a), particle_at(x, s->b));
            if (s->stiffness >= 1) most = real_max(most, fabs(length / s->rest_length - 1));
        }
    }
    return most;
}

static void measure(void)
{
    int k = live_choice(CASE), last = now.w.bodies - 1;
    const char *wants = shown[k].wants;
    if (!now.ok.ok) return;
    if (k == CRADLE_CASE)
        live_say("%s: the last one has %.6f of its speed.", wants, velocity(&now.w, last).x / CRADLE_SPEED);
    else if (k == BOUNCE)
        live_say("%s: it is %.3f m above the floor.", wants, middle(&now.w, 0).y - 0.5);
    else if (k == HALF)
        live_say("%s: their middles are %.3f m apart.", wants, vec3_distance(middle(&now.w, 0), middle(&now.w, 1)));
    else if (k >= BODY_CASES)
        live_say("%s: no stick is longer or shorter by more than %.3f %%.", wants, 100 * most_strained());
    else
        live_say("%s: after %.1f s, without sleep, nothing has moved by more than %.2g mm.", wants,
                 frame / 60.0, 1000 * most_moved());
}

// --- Drawing ----------------------------------------------------------------------
static void draw_rope(int b, live_colour c)
{
    const body *x = &now.w.body[b];
    int n = x->shape->particles;
    vec3 *at = malloc((size_t)n * sizeof *at);
    if (!at) abort();
    for (int i = 0; i < n; i++) at[i] = view_of(particle_at(x, i));
    live_rope(b, c, at, n, real_max(x->thickness, 0.012) * view_scale());
    free(at);
}

static void draw_body(int b, live_colour c)
{
    const body *x = &now.w.body[b];
    struct skin skin = shape_skin(x->shape);
    vec3 *at = malloc((size_t)skin.points * sizeof *at);
    if (!at) abort();
    world_skin(&now.w, x, at);
    for (int i = 0; i < skin.points; i++) at[i] = view_of(at[i]);
    if (x->shape->kind == SHAPE_CLOTH) live_cloth(b, c, at, skin.points, skin.face, skin.faces);
    else live_mesh(x->mass < HUGE_VAL ? b : -1, c, at, skin.points, skin.face, skin.faces, body_is_soft(x) || skin.points > 32);
    free(at);
}

static void draw_slope(void)
{
    vec3 at[4];
    for (int k = 0; k < 4; k++) {
        real along = k == 0 || k == 3 ? -1.5 : 1.5, across = k < 2 ? -1 : 1;
        at[k] = view_of(vec3_make(along * cos(25 * DEGREE), -along * sin(25 * DEGREE), across));
    }
    live_mesh(-1, LIVE_GREY, at, 4, (int[]){ 0, 2, 1, 0, 3, 2 }, 2, false);
}

static void draw(void)
{
    static const live_colour COLOUR[] = { LIVE_BLUE, LIVE_ORANGE, LIVE_GREEN, LIVE_PURPLE };
    int k = live_choice(CASE), colours = k >= HEAVY && k < BODY_CASES ? 2 : 4;
    for (int b = 0; b < now.w.bodies && now.ok.ok; b++) {
        live_colour c = now.w.body[b].mass < HUGE_VAL ? COLOUR[b % colours] : LIVE_GREY;
        if (now.w.body[b].shape->kind == SHAPE_ROPE) draw_rope(b, c);
        else draw_body(b, c);
    }
    if (k == SLOPE) draw_slope();
}

static unsigned long long hash(void)
{
    return now.ok.ok ? world_hash(&now.w) : 0;
}

const live_figure figure = {
    .name = "hard",
    .says = "A hard case: what should stand, stands",
    .camera = VIEW_CAMERA,
    .dial = { [CASE] = { "case", NULL, 0, CASES - 1, 1, CARDS,
                         "14 cradle|15 bounce|16 slope|17 twenty cubes|18 1,000 kg on 1 kg|19 cards|19 arch|20 half inside|"
                         "27 cube|28 ball|28 pole|28 pile|28 rope|29 letter|29 on its edge|30 needle|31 hammock|31 two pins|"
                         "33 thrown|34 load|35 cubes|36 card", true } },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash, .tap = tap,
};
