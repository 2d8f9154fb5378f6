// hard_set.c - see hard_set.h.

#include "convex.h"
#include "hard_set.h"
#include "random.h"
#include "step.h"

#include <math.h>

static const real PI = 3.14159265358979323846;
static const vec3 NOWHERE = { 0, 0, 0 };

// ---- A world with its plans ------------------------------------------------

void setting_start(setting *s, world_options o)
{
    *s = (setting){ .plans = 0 };
    s->ok = world_init(&s->w, o);
}

void setting_free(setting *s)
{
    world_free(&s->w);
    for (int k = 0; k < s->plans; k++) shape_free(&s->plan[k]);
}

const shape *add_box(setting *s, vec3 sides, real mass)
{
    shape *box = &s->plan[s->plans];
    if (s->ok.ok) s->ok = shape_box(box, sides, mass);
    s->plans++;
    return box;
}

int add_body(setting *s, const shape *plan, placement where)
{
    int number = 0;
    if (s->ok.ok) s->ok = world_add(&s->w, plan, where, &number);
    return number;
}

void add_ground(setting *s)
{
    if (s->ok.ok) s->ok = world_add_plane(&s->w, vec3_make(0, 1, 0), 0);
}

vec3 middle(const world *w, int b)
{
    const body *x = &w->body[b];
    int n = body_particles(x);
    vec3 sum = NOWHERE;
    for (int i = 0; i < n; i++)
        sum = vec3_add(sum, w->pool.at[x->first + i].position);
    return vec3_scale(1.0 / n, sum);
}

vec3 velocity(const world *w, int b)
{
    const body *x = &w->body[b];
    int n = body_particles(x);
    vec3 sum = NOWHERE;
    for (int i = 0; i < n; i++) {
        const particle *p = &w->pool.at[x->first + i];
        sum = vec3_add(sum, vec3_sub(p->position, p->previous));
    }
    return vec3_scale(1 / (n * body_age(w, b)), sum);
}

status setting_begin(setting *s)
{
    for (int b = 0; s->ok.ok && b < s->w.bodies && b < MOST_BODIES; b++)
        s->start[b] = middle(&s->w, b);
    return s->ok;
}

void run_for(setting *s, real seconds)
{
    int frames = (int)(seconds / s->w.options.dt + 0.5);
    for (int f = 0; f < frames; f++) world_step(&s->w);
}

placement turned_anyhow(vec3 position, unsigned long long *seed)
{
    placement p = placement_at(position);
    p.x = random_direction(seed);
    p.z = vec3_unit(vec3_cross(p.x, random_direction(seed)));
    p.y = vec3_cross(p.z, p.x);
    return p;
}

// ---- Options ---------------------------------------------------------------

world_options best(int substeps)
{
    world_options o = world_options_default();
    o.substeps = substeps;
    return o;
}

world_options weightless(world_options o)
{
    o.gravity = NOWHERE;
    return o;
}

world_options kept_awake(world_options o, bool is_awake)
{
    if (is_awake) o.sleep_speed = 0;
    return o;
}

world_options standing(int substeps, real mu, bool is_awake)
{
    world_options o = best(substeps);
    o.friction = mu;
    return kept_awake(o, is_awake);
}

// ---- 14 to 16: what moves --------------------------------------------------

void build_cradle(setting *s, world_options o, real gap, int flying, int side)
{
    o = weightless(o);
    o.friction = 0;
    o.restitution = 1;
    setting_start(s, o);
    const shape *cube = add_box(s, vec3_make(1, 1, 1), 1);
    real pitch = 1 + gap;
    for (int i = 0; i < CRADLE; i++) {
        int flies = side < 0 ? i < flying : i >= CRADLE - flying;
        real away = flies ? 0.3 * side : 0;
        placement p = placement_at(vec3_make(i * pitch + away, 0, 0));
        p.velocity.x = flies ? -side * CRADLE_SPEED : 0;
        add_body(s, cube, p);
    }
}

void build_bounce(setting *s, world_options o)
{
    setting_start(s, o);
    const shape *cube = add_box(s, vec3_make(1, 1, 1), 1);
    add_ground(s);
    add_body(s, cube, placement_at(vec3_make(0, 1.5, 0)));
}

void build_slope(setting *s, world_options o, real tilt, real mu, real speed)
{
    o.friction = mu;
    setting_start(s, o);
    const shape *slab = add_box(s, vec3_make(1, 0.5, 1), 1);
    real c = cos(tilt), d = sin(tilt);
    placement p = placement_at(NOWHERE);
    p.x = vec3_make(c, -d, 0);
    p.y = vec3_make(d, c, 0);
    p.position = vec3_scale(0.25, p.y);
    p.velocity = vec3_scale(speed, p.x);
    if (s->ok.ok) s->ok = world_add_plane(&s->w, p.y, 0);
    add_body(s, slab, p);
}

// ---- 17 to 19: what stands -------------------------------------------------

void build_stack(setting *s, world_options o, int cubes, real last)
{
    setting_start(s, o);
    const shape *cube = add_box(s, vec3_make(1, 1, 1), 1);
    const shape *top = add_box(s, vec3_make(1, 1, 1), last);
    add_ground(s);
    for (int i = 0; i < cubes; i++)
        add_body(s, i == cubes - 1 ? top : cube,
                 placement_at(vec3_make(0, 0.5 + i, 0)));
}

// A card of 1 x 0.02 x 0.7 m, and a house of them.
typedef struct {
    const shape *card;
    real long_side, thick, lean;    // m, m, rad
    real pitch;                     // m, from tip to tip of a floor
} cards;

// Two cards that lean on each other at x, their feet at height y.  One that is
// turned clockwise by `lean` stands on its lower right edge, touches the other
// one with its upper right edge, and carries on its upper left one.
static void add_tent(setting *s, const cards *c, real x, real y)
{
    real sine = sin(c->lean), cosine = cos(c->lean);
    real side = (c->thick * cosine + c->long_side * sine) / 2;
    real up = (c->thick * sine + c->long_side * cosine) / 2;
    for (int k = -1; k <= 1; k += 2) {
        placement p = placement_at(vec3_make(x + k * side, y + up, 0));
        p.x = vec3_make(cosine, k * sine, 0);
        p.y = vec3_make(-k * sine, cosine, 0);
        add_body(s, c->card, p);
    }
}

static void add_flat_card(setting *s, const cards *c, real x, real y)
{
    placement p = placement_at(vec3_make(x, y, 0));
    p.x = vec3_make(0, 1, 0);
    p.y = vec3_make(-1, 0, 0);
    add_body(s, c->card, p);
}

void build_card_house(setting *s, world_options o, int floors, real lean)
{
    setting_start(s, o);
    cards c = { .long_side = 1, .thick = 0.02, .lean = lean, .pitch = 1.01 };
    c.card = add_box(s, vec3_make(c.thick, c.long_side, 0.7), 0.1);
    add_ground(s);
    real y = 0, rise = c.thick * sin(lean) + c.long_side * cos(lean);
    for (int floor = 0; floor < floors; floor++) {
        int tents = floors - floor;
        real x = -(tents - 1) * c.pitch / 2;
        for (int k = 0; k < tents; k++) add_tent(s, &c, x + k * c.pitch, y);
        y += rise + c.thick / 2;
        for (int k = 0; k + 1 < tents; k++)
            add_flat_card(s, &c, x + (k + 0.5) * c.pitch, y);
        y += c.thick / 2;
    }
}

real outer_radius(real thickness)
{
    return (1 + thickness / 2) / (1 - thickness / 2);
}

// A stone of an arch: between radii of 1 m and `outer`, up to the angle `half`
// on either side, 0.5 m deep.  Corner k: outer if bit 0, right if bit 1, near
// if bit 2.  Returns how high the mean of its corners is above the arch's
// centre.
static real stone_corners(vec3 at[8], real outer, real half)
{
    real height = 0;
    for (int k = 0; k < 8; k++) {
        real r = k & 1 ? outer : 1, x = r * sin(half);
        at[k] = vec3_make(k & 2 ? x : -x, r * cos(half), k & 4 ? 0.25 : -0.25);
        height += at[k].y / 8;
    }
    return height;
}

void build_arch(setting *s, world_options o, int stones, real outer)
{
    static const int face[12][3] = {
        { 0, 1, 3 }, { 0, 3, 2 }, { 4, 6, 7 }, { 4, 7, 5 },
        { 0, 2, 6 }, { 0, 6, 4 }, { 1, 5, 7 }, { 1, 7, 3 },
        { 0, 4, 5 }, { 0, 5, 1 }, { 2, 3, 7 }, { 2, 7, 6 }
    };
    setting_start(s, o);
    real half = PI / (2 * stones);
    vec3 at[8];
    real height = stone_corners(at, outer, half);
    shape *stone = &s->plan[s->plans++];
    if (s->ok.ok) s->ok = shape_convex(stone, 8, at, 12, face, 1);
    add_ground(s);
    for (int k = 0; k < stones; k++) {
        real turn = PI / 2 - (2 * k + 1) * half;
        placement p = placement_at(NOWHERE);
        p.x = vec3_make(cos(turn), sin(turn), 0);
        p.y = vec3_make(-sin(turn), cos(turn), 0);
        p.position = vec3_scale(height, p.y);
        add_body(s, stone, p);
    }
}

// ---- 20: what overlaps -----------------------------------------------------

void build_overlap(setting *s, world_options o, vec3 offset)
{
    setting_start(s, weightless(o));
    const shape *cube = add_box(s, vec3_make(1, 1, 1), 1);
    add_body(s, cube, placement_at(NOWHERE));
    add_body(s, cube, placement_at(offset));
}
