// hard_drape_set.c - see hard_drape_set.h.

#include "convex.h"
#include "hard.h"
#include "hard_drape_set.h"
#include "random.h"
#include "soft.h"
#include "world_scene.h"

#include <math.h>
#include <string.h>

static const real PI = 3.14159265358979323846;

real any_signed(unsigned long long *seed)
{
    return 2 * random_fraction(seed) - 1;
}

void perturb(world *w, int number, unsigned long long seed)
{
    const body *b = &w->body[number];
    real turn = 0.087 * any_signed(&seed), c = cos(turn), s = sin(turn);
    real far = 0.02 * b->shape->spacing * (b->shape->columns - 1);
    real x = far * any_signed(&seed), z = far * any_signed(&seed);
    for (int i = b->first; i < b->first + b->shape->particles; i++) {
        particle *p = &w->pool.at[i];
        vec3 at = p->position, back = vec3_sub(p->previous, at);
        real off = p->inverse_mass > 0 ? 1e-3 * b->shape->spacing : 0;
        real out[3];        // of the last axis first
        for (int k = 2; k >= 0; k--) out[k] = off * any_signed(&seed);
        p->position = vec3_make(c * at.x + s * at.z + x + out[0],
                                at.y + out[1],
                                c * at.z - s * at.x + z + out[2]);
        p->previous = vec3_add(p->position, back);
    }
}

// ---- shapes ----------------------------------------------------------------

enum { AROUND = 16, BALL_LEVEL = 2, BALL_FACES = 320, BALL_CORNERS = 162 };

// The plan that was just made: what failed first stays.
static const shape *plan_made(setting *s, status made)
{
    if (s->ok.ok) s->ok = made;
    return &s->plan[s->plans++];
}

// A cone along y, or with `top` above 0 a bar: rings of these radii.
static const shape *add_cone(setting *s, real bottom, real top, real height,
                             real mass)
{
    vec3 at[2 * AROUND];
    int face[4 * AROUND][3], n = 0, upper = top > 0 ? AROUND : 1;
    for (int k = 0; k < AROUND; k++) {
        real c = cos(2 * PI * k / AROUND), d = sin(2 * PI * k / AROUND);
        at[k] = vec3_make(bottom * c, 0, bottom * d);
        if (k < upper) at[AROUND + k] = vec3_make(top * c, height, top * d);
    }
    for (int k = 0; k < AROUND; k++) {
        int next = (k + 1) % AROUND, up = AROUND + k % upper;
        int up_next = AROUND + next % upper;
        memcpy(face[n++], (int[3]){ k, up, next }, sizeof *face);
        if (upper > 1)
            memcpy(face[n++], (int[3]){ next, up, up_next }, sizeof *face);
        if (k + 2 >= AROUND) continue;
        memcpy(face[n++], (int[3]){ 0, k + 1, k + 2 }, sizeof *face);
        if (upper > 1)
            memcpy(face[n++], (int[3]){ AROUND, up + 2, up + 1 },
                   sizeof *face);
    }
    return plan_made(s, shape_convex(&s->plan[s->plans], AROUND + upper, at, n,
                                     (const int (*)[3])face, mass));
}

static int middle_between(vec3 *at, int *n, int a, int b, real radius)
{
    vec3 m = vec3_scale(radius, vec3_unit(vec3_add(at[a], at[b])));
    for (int i = 0; i < *n; i++)
        if (vec3_distance(at[i], m) < 1e-6 * radius) return i;
    at[*n] = m;
    return (*n)++;
}

// Each triangle in four: returns how many there are then.
static int divide(int (*face)[3], int faces, vec3 *at, int *n, real radius)
{
    int old[BALL_FACES][3];
    memcpy(old, face, (size_t)faces * sizeof *old);
    for (int f = 0; f < faces; f++) {
        const int *v = old[f];
        int m[3];
        for (int k = 0; k < 3; k++)
            m[k] = middle_between(at, n, v[k], v[(k + 1) % 3], radius);
        for (int k = 0; k < 3; k++)
            memcpy(face[4 * f + k], (int[3]){ v[k], m[k], m[(k + 2) % 3] },
                   sizeof *face);
        memcpy(face[4 * f + 3], m, sizeof m);
    }
    return 4 * faces;
}

// A ball of 320 triangles.
static const shape *add_ball(setting *s, real radius, real mass)
{
    shape first;
    vec3 at[BALL_CORNERS];
    int face[BALL_FACES][3], n = 12, faces = 20;
    status made = shape_icosahedron(&first, radius, 1);
    if (made.ok) {
        memcpy(at, first.at, (size_t)n * sizeof *at);
        memcpy(face, first.face, (size_t)faces * sizeof *face);
        for (int k = 0; k < BALL_LEVEL; k++)
            faces = divide(face, faces, at, &n, radius);
        shape_free(&first);
        made = shape_convex(&s->plan[s->plans], n, at, faces,
                            (const int (*)[3])face, mass);
    }
    return plan_made(s, made);
}

static const shape *add_cloth(setting *s, int n, real side, real mass)
{
    return plan_made(s, shape_cloth(&s->plan[s->plans], n, n, side, side, mass,
                                    0.2));
}

// ---- places ----------------------------------------------------------------

// As wide as the paper's: n x n particles, 2 m x 2 m, 1 kg.
static const shape *add_wide_cloth(setting *s, int n)
{
    return add_cloth(s, n, 2, 1);
}

static void add_static(setting *s, const shape *plan, vec3 at)
{
    placement p = placement_at(at);
    p.is_static = true;
    add_body(s, plan, p);
}

// Turned by so much about y, at this height, and falling at this speed.
static int drop(setting *s, const shape *cloth, real degrees, real height,
                real speed)
{
    real turn = degrees * PI / 180;
    placement p = placement_at(vec3_make(0, height, 0));
    p.x = vec3_make(cos(turn), 0, -sin(turn));
    p.z = vec3_make(sin(turn), 0, cos(turn));
    p.velocity.y = -speed;
    return add_body(s, cloth, p);
}

// What the scenes need, awake: a sleeping cloth would be at rest by decree.
static world_options awake(int n)
{
    return kept_awake(world_scene_options(SCENE_CLOTH_ON_CUBE, n), true);
}

// The lower half of a body whose bottom is at y = 0: the mean of the corners of
// a cone or a bar is not at half of its height.
static real foot(const shape *plan)
{
    real least = 0;
    for (int i = 0; i < plan->particles; i++)
        least = fmin(least, plan->at[i].y);
    return -least;
}

// m/N.  What hangs by pins is a cotton that 490 N for each metre of its width
// make longer by a fortieth.
static const real COTTON = 5e-5;

static void make_cotton(setting *s, int b)
{
    if (s->ok.ok) s->ok = world_stretch(&s->w, b, COTTON);
}

// Pins the particles of body b, a cloth, at which `ends` rims meet, or more: 2,
// the corners; 1, all of the rim.
static void pin_rim(setting *s, int b, int ends)
{
    int n = s->ok.ok ? s->w.body[b].shape->columns : 0;
    for (int i = 0; i < n; i++)
        for (int k = 0; k < n; k++)
            if ((i == 0 || i == n - 1) + (k == 0 || k == n - 1) >= ends)
                world_pin(&s->w, b, n * i + k);
}

// Pins its first row, or the ends of it; and so the last.
static void pin_row(setting *s, int b, bool is_last, bool is_whole)
{
    int n = s->ok.ok ? s->w.body[b].shape->columns : 0;
    for (int k = 0; k < n; k += is_whole ? 1 : n - 1)
        world_pin(&s->w, b, (is_last ? n * (n - 1) : 0) + k);
}

// ---- 24: folds -------------------------------------------------------------

void lay_table(setting *s, world_options o, vec3 sides, int n,
               placement where)
{
    setting_start(s, o);
    add_static(s, add_box(s, sides, 1), vec3_make(0, -sides.y / 2, 0));
    add_body(s, add_wide_cloth(s, n), where);
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

// The sheets lie 1.5 times as far apart as they touch; so does the table.
void build_fold(setting *s, fold_kind kind, int n)
{
    placement where = placement_at(vec3_make(0, 1.2, 0));
    vec3 sides = vec3_make(3, 0.2, 3);
    if (kind == FOLD_OVER_CUBE) sides = vec3_make(0.8, 0.8, 0.8);
    if (kind == FOLD_UPRIGHT) {
        where.x = vec3_make(0, 1, 0);
        where.y = vec3_make(-1, 0, 0);
    }
    lay_table(s, world_scene_options(SCENE_CLOTH_ON_CUBE, 40), sides, n, where);
    if (!s->ok.ok || kind == FOLD_UPRIGHT) return;
    const body *cloth = &s->w.body[1];
    real off_table = soft_gap(cloth, &s->w.body[0]);
    fold(&s->w, 1.5 * off_table + (kind == FOLD_LETTER ? 0 : 0.1),
         1.5 * 2 * cloth->thickness);
}

// ---- 27, 33: on the cube, and thrown at it ---------------------------------

static void add_cube(setting *s)
{
    add_static(s, add_box(s, vec3_make(0.8, 0.8, 0.8), 1),
               vec3_make(0, 0.4, 0));
}

// The paper's, by its measures; with: how fast it is thrown down.
static void on_cube(setting *s, const drape *d)
{
    setting_start(s, awake(d->n));
    add_cube(s);
    real spacing = 2.0 / (d->n - 1);
    drop(s, add_wide_cloth(s, d->n), 20, 0.8 + fmax(0.1, 0.7 * spacing),
         d->with);
}

// ---- 28: on other things ---------------------------------------------------

static void on_ball(setting *s, const drape *d)
{
    setting_start(s, awake(d->n));
    add_static(s, add_ball(s, 0.5, 1), vec3_make(0, 0.5, 0));
    drop(s, add_wide_cloth(s, d->n), 20, 1.1, 0);
}

// A bar of 10 cm, 3 m long, level.
static void on_pole(setting *s, const drape *d)
{
    setting_start(s, awake(d->n));
    placement p = placement_at(vec3_make(0, 1, 0));
    p.is_static = true;
    p.x = vec3_make(0, -1, 0);
    p.y = vec3_make(1, 0, 0);
    add_body(s, add_cone(s, 0.05, 0.05, 3, 1), p);
    drop(s, add_wide_cloth(s, d->n), 20, 1.15, 0);
}

// A cube of 100 kg slides along the ground at 3 m/s, until friction stops it.
static void on_slider(setting *s, const drape *d)
{
    setting_start(s, awake(d->n));
    add_ground(s);
    placement p = placement_at(vec3_make(-0.5, 0.4, 0));
    p.velocity.x = d->with;
    add_body(s, add_box(s, vec3_make(0.8, 0.8, 0.8), 100), p);
    drop(s, add_wide_cloth(s, d->n), 20, 0.9, 0);
}

// A pyramid of 14 cubes of 30 cm and 1 kg, free.
static void on_pile(setting *s, const drape *d)
{
    setting_start(s, awake(d->n));
    add_ground(s);
    const shape *cube = add_box(s, vec3_make(0.3, 0.3, 0.3), 1);
    for (int level = 0; level < 3; level++)
        for (int k = 0; k < (3 - level) * (3 - level); k++) {
            int across = 3 - level;
            real x = k % across - (across - 1) / 2.0;
            real z = k / across - (across - 1) / 2.0;
            add_body(s, cube, placement_at(vec3_make(
                0.31 * x, 0.15 + 0.301 * level, 0.31 * z)));
        }
    drop(s, add_wide_cloth(s, d->n), 20, 1.1, 0);
}

// The paper's other cloth, on a rope of 50 links.
static void on_rope(setting *s, const drape *d)
{
    enum { LINKS = 50 };
    setting_start(s, awake(d->n));
    const shape *rope = plan_made(s, shape_rope(&s->plan[s->plans], LINKS, 3,
                                                0.5));
    const shape *cloth = add_wide_cloth(s, d->n);
    scene_options what = scene_options_default();
    what.cloth = d->n;
    scene known;
    status made = scene_build(&known, SCENE_CLOTH_ON_ROPE, what);
    if (s->ok.ok) s->ok = made;
    for (int b = 0; made.ok && s->ok.ok && b < known.bodies; b++) {
        bool is_rope = scene_shape(&known, b)->kind == SHAPE_ROPE;
        int k = add_body(s, is_rope ? rope : cloth, known.body[b].where);
        for (int i = 0; i < s->w.body[k].shape->particles; i++) {
            particle *p = &s->w.pool.at[s->w.body[k].first + i];
            p->position = p->previous = scene_position(&known, b, i);
        }
    }
    for (int k = 0; made.ok && s->ok.ok && k < known.pins; k++)
        world_pin(&s->w, known.pin[k].body, known.pin[k].particle);
    if (made.ok) scene_free(&known);
}

// A rope of n links and 3 m, across the cube.
static void rope_on_cube(setting *s, const drape *d)
{
    setting_start(s, awake(d->n));
    add_cube(s);
    const shape *rope = plan_made(s, shape_rope(&s->plan[s->plans], d->n, 3,
                                                0.5));
    drop(s, rope, 20, 1, 0);
}

// ---- 29: on each other -----------------------------------------------------

static void three_sheets(setting *s, const drape *d)
{
    setting_start(s, awake(d->n));
    add_cube(s);
    const shape *cloth = add_wide_cloth(s, d->n);
    for (int k = 0; k < 3; k++) drop(s, cloth, 20 + 25 * k, 0.9 + 0.1 * k, 0);
}

static void folded(setting *s, const drape *d)
{
    build_fold(s, (fold_kind)d->with, d->n);
    s->w.options.sleep_speed = 0;
}

// ---- 30: spikes ------------------------------------------------------------

// It stands on the ground, 1 m high; with: its width.
static void on_spike(setting *s, const drape *d)
{
    setting_start(s, awake(d->n));
    add_ground(s);
    const shape *cone = add_cone(s, d->with / 2, 0, 1, 1);
    if (s->ok.ok) add_static(s, cone, vec3_make(0, foot(cone), 0));
    drop(s, add_wide_cloth(s, d->n), 20, 1.1, 0);
}

// It flies, its point downwards, at a cloth of 1 m whose rim is pinned.
static void flying_spike(setting *s, const drape *d)
{
    setting_start(s, awake(d->n));
    drop(s, add_cloth(s, d->n, 1, 0.2), 0, 0, 0);
    pin_rim(s, 0, 1);
    placement p = placement_at(vec3_make(0.03, 0.4, 0.02));
    p.x = vec3_make(-1, 0, 0);
    p.y = vec3_make(0, -1, 0);
    p.velocity.y = -d->with;
    add_body(s, add_cone(s, 0.03, 0, 0.3, 0.2), p);
}

// ---- 31: pins --------------------------------------------------------------

// Two corners of the cloth hang as high as it was over the cube; with: 0, there
// is no cube.
static void by_two_pins(setting *s, const drape *d)
{
    setting_start(s, awake(d->n));
    if (d->with > 0) add_cube(s);
    int b = drop(s, add_wide_cloth(s, d->n), 20, 0.9, 0);
    make_cotton(s, b);
    pin_row(s, b, false, false);
}

static void opposite_on_cube(setting *s, const drape *d)
{
    setting_start(s, awake(d->n));
    add_cube(s);
    int b = drop(s, add_wide_cloth(s, d->n), 20, 0.9, 0);
    make_cotton(s, b);
    if (!s->ok.ok) return;
    world_pin(&s->w, b, 0);
    world_pin(&s->w, b, d->n * d->n - 1);
}

// A cube of 10 kg in 0.2 kg of cloth; with: 0, by its corners; 1, by two sides.
static void hammock(setting *s, const drape *d)
{
    setting_start(s, awake(d->n));
    make_cotton(s, drop(s, add_cloth(s, d->n, 1, 0.2), 0, 0, 0));
    pin_row(s, 0, false, d->with > 0);
    pin_row(s, 0, true, d->with > 0);
    add_body(s, add_box(s, vec3_make(0.2, 0.2, 0.2), 10),
             placement_at(vec3_make(0, 0.2, 0)));
}

// ---- 32: flat --------------------------------------------------------------

static void lands_flat(setting *s, const drape *d)
{
    setting_start(s, awake(d->n));
    add_ground(s);
    drop(s, add_wide_cloth(s, d->n), 0, 0.3, 0);
}

// ---- 34: ropes with a load -------------------------------------------------

// n links and 1 m, 10,000 link masses at one end, pinned at the other.
static const shape *add_loaded_rope(setting *s, int n)
{
    shape *rope = &s->plan[s->plans];
    status made = shape_rope(rope, n, 1, 0.001 * (n + 1));
    if (made.ok) rope->mass[n] = 10000 * rope->mass[0];
    return plan_made(s, made);
}

static void loaded_rope(setting *s, const drape *d)
{
    setting_start(s, awake(d->n));
    placement p = placement_at(vec3_make(0, 2, 0));
    p.x = vec3_make(0, -1, 0);
    p.y = vec3_make(1, 0, 0);
    int b = add_body(s, add_loaded_rope(s, d->n), p);
    if (s->ok.ok) world_pin(&s->w, b, 0);
}

// Twenty links lie on the cube, from the pin to the edge; the others hang down
// beside it, with the load, at rest.
static void loaded_rope_on_cube(setting *s, const drape *d)
{
    enum { CORNER = 20 };
    setting_start(s, awake(d->n));
    add_cube(s);
    const shape *rope = add_loaded_rope(s, d->n);
    int b = add_body(s, rope, placement_at(vec3_make(0, 2, 0)));
    if (!s->ok.ok) return;
    real off = 1.05 * soft_gap(&s->w.body[b], &s->w.body[0]);
    for (int i = 0; i <= d->n; i++) {
        particle *p = &s->w.pool.at[s->w.body[b].first + i];
        real x = fmin(i - CORNER, 0), y = fmin(CORNER - i, 0);
        p->position = vec3_make(0.4 + off + x * rope->spacing,
                                0.8 + off + y * rope->spacing, 0);
        p->previous = p->position;
    }
    world_pin(&s->w, b, 0);
}

// ---- 35: what moves into a held cloth --------------------------------------

// A curtain that hangs from 1.7 m to the ground, or nearly; a ball of 60 cm and
// 20 kg rolls through it.
static void curtain(setting *s, const drape *d)
{
    setting_start(s, awake(d->n));
    add_ground(s);
    placement p = placement_at(vec3_make(0, 0.9, 0));
    p.x = vec3_make(0, 0, 1);
    p.y = vec3_make(1, 0, 0);
    p.z = vec3_make(0, 1, 0);
    add_body(s, add_cloth(s, d->n, 1.6, 0.6), p);
    pin_row(s, 0, true, true);
    placement ball = placement_at(vec3_make(-0.8, 0.301, 0.1));
    ball.velocity.x = d->with;
    ball.spin.z = -d->with / 0.3;
    add_body(s, add_ball(s, 0.3, 20), ball);
}

// Eight cubes of 20 cm and 0.2 kg, turned anyhow, fall from 0.4 to 2.5 m onto
// the cloth, which hangs by its corners, or by its rim.
static void falling_cubes(setting *s, const drape *d)
{
    unsigned long long seed = 35;
    setting_start(s, awake(d->n));
    int b = drop(s, add_wide_cloth(s, d->n), 0, 0, 0);
    make_cotton(s, b);
    pin_rim(s, b, (int)d->with);
    const shape *cube = add_box(s, vec3_make(0.2, 0.2, 0.2), 0.2);
    for (int k = 0; k < 8; k++) {
        real z = 0.4 * any_signed(&seed), x = 0.4 * any_signed(&seed);
        add_body(s, cube,
                 turned_anyhow(vec3_make(x, 0.4 + 0.3 * k, z), &seed));
    }
}

// ---- 36: fabrics -----------------------------------------------------------

// with: silk, denim or card, 42 cm wide, over a cube of 14 cm; kg/m^2, N m, and
// m/N.
static void fabric(setting *s, const drape *d)
{
    static const real known[3][3] = { { 0.06, 5e-6, 5e-5 },
                                      { 0.4, 1e-4, 1e-4 },
                                      { 0.3, 1.6e-2, 8e-7 } };
    const real *is = known[(int)d->with], wide = 0.42, side = 0.14;
    setting_start(s, awake(d->n));
    add_static(s, add_box(s, vec3_make(side, side, side), 1),
               vec3_make(0, side / 2, 0));
    int b = drop(s, add_cloth(s, d->n, wide, is[0] * wide * wide), 20,
                 side + 0.02, 0);
    if (s->ok.ok) s->ok = world_bend(&s->w, b, is[1]);
    if (s->ok.ok) s->ok = world_stretch(&s->w, b, is[2]);
}

// ---- the table -------------------------------------------------------------

#define ANY HUGE_VAL
const drape drape_table[] = {
    // name, case, scene, n, with, frames, starts, floor,
    //     strain, end, at rest, speed, slowest
    { "cube", 27, on_cube, 20, 0, 300, 8, -ANY, .005, .003, ANY, ANY, ANY },
    { "cube", 27, on_cube, 40, 0, 300, 8, -ANY, .005, .003, ANY, ANY, ANY },
    { "cube", 27, on_cube, 80, 0, 300, 8, -ANY, .01, .003, ANY, ANY, ANY },
    { "cube", 27, on_cube, 160, 0, 300, 8, -ANY, .015, .003, ANY, ANY, ANY },
    { "ball", 28, on_ball, 40, 0, 300, 4, -ANY, .02, ANY, ANY, ANY, ANY },
    { "pole", 28, on_pole, 40, 0, 300, 4, -ANY, .02, ANY, ANY, ANY, ANY },
    { "sliding cube", 28, on_slider, 40, 3, 300, 4, -ANY, .02, ANY, ANY, ANY,
      ANY },
    { "pile of cubes", 28, on_pile, 40, 0, 300, 4, -ANY, .02, ANY, ANY, ANY,
      ANY },
    { "rope", 28, on_rope, 40, 0, 300, 4, -ANY, .02, ANY, ANY, ANY, ANY },
    { "rope on cube", 28, rope_on_cube, 50, 0, 300, 4, -ANY, .02, ANY, ANY,
      ANY, ANY },
    { "three sheets", 29, three_sheets, 40, 0, 300, 4, -ANY, .02, ANY, ANY,
      ANY, ANY },
    { "letter", 29, folded, 40, FOLD_LETTER, 300, 4, -ANY, .02, ANY, ANY, ANY,
      ANY },
    { "letter on cube", 29, folded, 40, FOLD_OVER_CUBE, 300, 4, -ANY, .02, ANY,
      ANY, ANY, ANY },
    { "on its edge", 29, folded, 40, FOLD_UPRIGHT, 300, 4, -ANY, .02, ANY, ANY,
      ANY, ANY },
    { "cone", 30, on_spike, 60, .1, 300, 4, -ANY, .05, ANY, ANY, ANY, ANY },
    { "needle", 30, on_spike, 60, .01, 300, 4, -ANY, .05, ANY, ANY, ANY, ANY },
    { "spike at 2 m/s", 30, flying_spike, 40, 2, 120, 4, -.3, .05, ANY, ANY,
      ANY, ANY },
    { "spike at 10 m/s", 30, flying_spike, 40, 10, 120, 4, -.3, .05, ANY, ANY,
      ANY, ANY },
    { "two pins, air", 31, by_two_pins, 40, 0, 900, 2, -ANY, ANY, ANY, .01,
      .001, ANY },
    { "two pins, cube", 31, by_two_pins, 20, 1, 900, 2, -ANY, ANY, ANY,
      .01, .001, ANY },
    { "two pins, cube", 31, by_two_pins, 40, 1, 900, 2, -ANY, ANY, ANY,
      .01, .001, ANY },
    { "opposite pins", 31, opposite_on_cube, 20, 0, 900, 2, -ANY, ANY, ANY,
      .01, .001, ANY },
    { "opposite pins", 31, opposite_on_cube, 40, 0, 900, 2, -ANY, ANY, ANY,
      .01, .001, ANY },
    { "hammock, corners", 31, hammock, 21, 0, 600, 2, -.5, ANY, ANY, .02, ANY,
      ANY },
    { "hammock, sides", 31, hammock, 21, 1, 600, 2, -.5, ANY, ANY, .02, ANY,
      ANY },
    { "flat", 32, lands_flat, 40, 0, 120, 1, -ANY, .01, ANY, ANY, ANY, 10 },
    { "flat", 32, lands_flat, 120, 0, 120, 1, -ANY, .01, ANY, ANY, ANY, 10 },
    { "thrown, 5 m/s", 33, on_cube, 40, 5, 300, 4, -ANY, .01, ANY, ANY, ANY,
      ANY },
    { "thrown, 10 m/s", 33, on_cube, 40, 10, 300, 4, -ANY, .01, ANY, ANY, ANY,
      ANY },
    { "thrown, 20 m/s", 33, on_cube, 40, 20, 300, 4, -ANY, .01, ANY, ANY, ANY,
      ANY },
    { "loaded rope", 34, loaded_rope, 50, 0, 600, 1, -ANY, 1e-6, ANY, ANY, ANY,
      ANY },
    { "the same, on cube", 34, loaded_rope_on_cube, 50, 0, 600, 1, -ANY, .02,
      ANY, ANY, ANY, ANY },
    { "curtain, ball", 35, curtain, 40, 2, 240, 4, -ANY, .02, ANY, ANY, ANY,
      ANY },
    { "cubes, corners", 35, falling_cubes, 40, 2, 300, 4, -ANY, .02, ANY, ANY,
      ANY, ANY },
    { "cubes, rim", 35, falling_cubes, 40, 1, 300, 4, -.5, .02, ANY, ANY, ANY,
      ANY },
    { "silk", 36, fabric, 40, 0, 300, 6, -.1, .02, ANY, ANY, ANY, ANY },
    { "denim", 36, fabric, 40, 1, 300, 6, -.1, .02, ANY, ANY, ANY, ANY },
    { "card", 36, fabric, 40, 2, 300, 6, -.1, .02, ANY, ANY, ANY, ANY },
    { NULL, 0, NULL, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }
};

watch_plan drape_plan(const drape *d)
{
    return (watch_plan){ .frames = d->frames, .floor = d->floor,
                         .calmed = d->speed < HUGE_VAL ? 2 * d->frames / 3 : 0 };
}

bool drape_is_struck(const drape *d)
{
    return d->build == falling_cubes;
}

// A rope that is pinned hangs, or lies, as it was put.
void drape_build(setting *s, const drape *d, int start)
{
    d->build(s, d);
    for (int b = 0; s->ok.ok && start > 0 && b < s->w.bodies; b++)
        if (s->w.body[b].shape->kind == SHAPE_CLOTH || d->build == rope_on_cube)
            if (body_is_soft(&s->w.body[b]))
                perturb(&s->w, b, (unsigned long long)(100 * start + 7 + b));
    setting_begin(s);
}
