// hard.c - hard cases as a gallery: each begins as the judge begins it, and says what
// has moved that should not (chapter 20).

#include "handle.h"
#include "hard_set.h"
#include "live.h"
#include "live_world.h"
#include "measure.h"
#include "step.h"
#include "view.h"

enum { CASE };                                  // dial
enum { CRADLE_CASE, STACK, HEAVY, CARDS, ARCH, HALF, CASES };

static const struct {
    const char *wants;
    vec3 eye, target;
    bool has_floor;
} shown[CASES] = {
    [CRADLE_CASE] = { "14. One cube comes in, so one goes out", { 6, 3, 11 }, { 2.5, 0, 0 }, false },
    [STACK] = { "17. Twenty cubes stand", { 12, 13.5, 34 }, { 0, 10, 0 }, true },
    [HEAVY] = { "18. 1,000 kg stand on 1 kg", { 2, 2.5, 6 }, { 0, 1, 0 }, true },
    [CARDS] = { "19. Forty cards stand", { 4.4, 3.4, 9.5 }, { 0, 2.1, 0 }, true },
    [ARCH] = { "19. The thinnest arch stands", { 1.1, 1.5, 5 }, { 0, 0.6, 0 }, true },
    [HALF] = { "20. Two cubes that begin half inside each other part", { 1.7, 2.1, 6 }, { 0.25, 0, 0 }, false },
};
static setting now;
static bool is_built;
static int frame;

static void build(int k)
{
    const real lean = 20 * 3.14159265358979323846 / 180;
    if (k == CRADLE_CASE) build_cradle(&now, best(8), 0.01, 1, -1);
    else if (k == STACK) build_stack(&now, standing(20, 0.5, true), 20, 1);
    else if (k == HEAVY) build_stack(&now, standing(60, 0.5, true), 2, 1000);
    else if (k == CARDS) build_card_house(&now, standing(20, 0.7, true), 5, lean);
    else if (k == ARCH) build_arch(&now, standing(20, 0.7, true), 11, outer_radius(0.112));
    else build_overlap(&now, best(10), vec3_make(0.5, 0.1, 0.05));
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
static void pull(int b)
{
    placement at = world_where(&now.w, b);
    vec3 a = live_pull(view_of(at.position), view_turn(at.velocity));
    world_push(&now.w, b, vec3_scale(now.w.body[b].mass / 60, view_turn_back(a)), at.position);
}

static void tap(int number, vec3 along)
{
    vec3 way = vec3_unit(view_turn_back(along));
    if (now.ok.ok) live_world_hurry(&now.w, number, vec3_scale(2, way));
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

static void measure(void)
{
    int k = live_choice(CASE), last = now.w.bodies - 1;
    if (!now.ok.ok) return;
    if (k == CRADLE_CASE)
        live_say("%s: the last one has %.6f of its speed.", shown[k].wants, velocity(&now.w, last).x / CRADLE_SPEED);
    else if (k == HALF)
        live_say("%s: their middles are %.3f m apart.", shown[k].wants, vec3_distance(middle(&now.w, 0), middle(&now.w, 1)));
    else
        live_say("%s: after %.1f s, without sleep, nothing has moved by more than %.2g mm.", shown[k].wants,
                 frame / 60.0, 1000 * most_moved());
}

static void draw(void)
{
    static const live_colour COLOUR[] = { LIVE_BLUE, LIVE_ORANGE, LIVE_GREEN, LIVE_PURPLE };
    int colours = live_choice(CASE) >= HEAVY ? 2 : 4;
    for (int b = 0; b < now.w.bodies && now.ok.ok; b++) {
        const shape *s = now.w.body[b].shape;
        vec3 at[32];
        if (s->particles > 32) continue;
        world_vertices(&now.w, &now.w.body[b], at);
        for (int i = 0; i < s->particles; i++) at[i] = view_of(at[i]);
        live_mesh(b, COLOUR[b % colours], at, s->particles, s->face, s->mesh.faces, false);
    }
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
                         "14 cradle|17 twenty cubes|18 1,000 kg on 1 kg|19 cards|19 arch|20 half inside", true } },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash, .tap = tap,
};
