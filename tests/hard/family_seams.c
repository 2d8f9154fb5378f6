// family_seams.c - rows 101 to 109: ground of pieces, and bodies that slide over its
// seams, or fall into its creases.
//
// A floor of pieces that lie flush is a plane.  So a body that slides stops
// after v^2 / (2 mu g), without friction it keeps its speed, a ball ends by
// rolling with 5/7 of its speed, and nothing hops or turns aside.  And whatever the
// ground, nothing is in it.

#include "family.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

// What the floor is made of: tiles as wide as the floor, but for the last two.
// The plane has no seams, and shows what the judge says then.
typedef enum {
    PLANE, PIECES, STATICS, KINEMATICS, DYNAMICS, TRIANGLES, BRICKS, FLOORS
} floor_kind;
static const char *const floor_name[FLOORS] = {
    "a plane", "pieces", "static bodies", "kinematic bodies",
    "heavy free slabs", "triangles", "bricks"
};

typedef enum { BOX, CAPSULE, COIN, BALL, SLIDERS } slider_kind;
static const char *const slider_name[SLIDERS] = { "box", "capsule", "coin",
                                                  "ball" };

// Lengths are in parts of the slider's size: tiles of 2.5, a floor of 32 tiles
// that are 1.25 thick, its top at y = 0.
enum { TILES = 32, MOST_PIECES = 600 };
static const double TILE = 2.5, THICK = 1.25, WIDTH = 10;

typedef struct {
    floor_kind floor;
    slider_kind slider;
    double size;        // m, the slider's length and width
    double speed;       // m/s, along x
    double friction;
    double dt;          // s
    double turned;      // rad, about y, at the start
    double step;        // m, how much higher the floor's second half is
} trial;

// What came of it.
typedef struct {
    double way, furthest, speed, hop, aside;    // m, m, m/s, m, m
    int    ok;
} outcome;

// ---- Floors ----------------------------------------------------------------

static tumble_pose place(double x, double y, double z)
{
    tumble_pose p = { { x, y, z }, { 0, 0, 0, 1 } };
    return p;
}

// The higher part of the floor begins where the slider's first tile ends.
static double height_of(const trial *t, int tile)
{
    return tile > 1 ? t->step : 0;
}

static void lay_bodies(tumble_world *w, const trial *t, tumble_kind kind)
{
    double s = t->size;
    tumble_vec3 sides = { TILE * s, THICK * s, WIDTH * s };
    // A free slab outweighs the slider by 10,000, so that it stays.
    tumble_shape tile = tumble_shape_box(w, sides, 10000 * s * s * s);
    for (int i = 0; i < TILES; i++) {
        tumble_body_options o = tumble_body_at((i - 1) * TILE * s,
                                               height_of(t, i) - THICK * s / 2,
                                               0);
        o.kind = kind;
        tumble_body_add(w, tile, o);
    }
    if (kind == TUMBLE_DYNAMIC)
        tumble_plane_add(w, tumble_v(0, 1, 0), -THICK * s, -1);
}

static void lay_tiles(tumble_world *w, const trial *t)
{
    tumble_shape shape[TILES];
    tumble_pose pose[TILES];
    double s = t->size;
    tumble_vec3 sides = { TILE * s, THICK * s, WIDTH * s };
    for (int i = 0; i < TILES; i++) {
        shape[i] = tumble_shape_box(w, sides, 1);
        pose[i] = place((i - 1) * TILE * s, height_of(t, i) - THICK * s / 2, 0);
    }
    tumble_body_add_pieces(w, shape, pose, TILES, tumble_body_at(0, 0, 0));
}

// Six rows of tiles, every other row moved by half a tile: T seams.
static void lay_bricks(tumble_world *w, const trial *t)
{
    enum { ROWS = 6 };
    tumble_shape shape[ROWS * TILES];
    tumble_pose pose[ROWS * TILES];
    double s = t->size;
    tumble_shape brick = tumble_shape_box(w, tumble_v(TILE * s, THICK * s, s),
                                          1);
    int n = 0;
    for (int k = 0; k < ROWS; k++)
        for (int i = 0; i < TILES; i++, n++) {
            shape[n] = brick;
            pose[n] = place((i - 1 + k % 2 * 0.5) * TILE * s, -THICK * s / 2,
                            (k - 2.5) * s);
        }
    tumble_body_add_pieces(w, shape, pose, n, tumble_body_at(0, 0, 0));
}

// One prism under the triangle of corners a, b, c, which are in parts of s.
static void lay_prism(tumble_world *w, double s, const double corner[6],
                      tumble_shape *shape, tumble_pose *pose)
{
    tumble_vec3 point[6], middle = { 0, -THICK * s / 2, 0 };
    for (int k = 0; k < 3; k++) {
        point[k] = tumble_v(corner[2 * k] * s, 0, corner[2 * k + 1] * s);
        point[k + 3] = tumble_v(point[k].x, -THICK * s, point[k].z);
        middle.x += point[k].x / 3;
        middle.z += point[k].z / 3;
    }
    *shape = tumble_shape_hull(w, point, 6, 1);
    *pose = place(middle.x, middle.y, middle.z);
}

static void lay_triangles(tumble_world *w, const trial *t)
{
    tumble_shape *shape = calloc(MOST_PIECES, sizeof *shape);
    tumble_pose *pose = calloc(MOST_PIECES, sizeof *pose);
    int n = 0;
    for (int i = 0; shape && pose && i < 2 * TILES; i++)
        for (int j = -2; j < 2; j++) {
            double x = (i - 3) * TILE / 2, z = j * TILE / 2, e = TILE / 2;
            double low[6] = { x, z, x, z + e, x + e, z };
            double high[6] = { x + e, z + e, x + e, z, x, z + e };
            lay_prism(w, t->size, low, &shape[n], &pose[n]);
            lay_prism(w, t->size, high, &shape[n + 1], &pose[n + 1]);
            n += 2;
        }
    tumble_body_add_pieces(w, shape, pose, n, tumble_body_at(0, 0, 0));
    free(shape);
    free(pose);
}

static void lay_floor(tumble_world *w, const trial *t)
{
    switch (t->floor) {
    case PLANE:      tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1); break;
    case STATICS:    lay_bodies(w, t, TUMBLE_STATIC); break;
    case KINEMATICS: lay_bodies(w, t, TUMBLE_KINEMATIC); break;
    case DYNAMICS:   lay_bodies(w, t, TUMBLE_DYNAMIC); break;
    case TRIANGLES:  lay_triangles(w, t); break;
    case BRICKS:     lay_bricks(w, t); break;
    default:         lay_tiles(w, t);
    }
}

// ---- Sliders ---------------------------------------------------------------

// Adds the slider at x = 0, a little off the middle line, and gives the height
// of its centre.
static tumble_body add_slider(tumble_world *w, const trial *t, double *height)
{
    double s = t->size, mass = s * s * s;
    tumble_shape shape;
    tumble_quat rotation = tumble_quat_turn(tumble_v(0, 1, 0), t->turned);
    switch (t->slider) {
    case CAPSULE:   // it lies along its way
        shape = tumble_shape_capsule(w, s, s / 4, mass);
        *height = s / 4;
        rotation = tumble_quat_turn(tumble_v(0, 0, 1), FAMILY_PI / 2);
        break;
    case COIN:
        shape = family_prism(w, 16, s / 2, s / 4, mass);
        *height = s / 8;
        break;
    case BALL:
        shape = tumble_shape_sphere(w, s / 2, mass);
        *height = s / 2;
        break;
    default:
        shape = tumble_shape_box(w, tumble_v(s, s / 2, s), mass);
        *height = s / 4;
    }
    tumble_body_options o = tumble_body_at(0, *height, 0.075 * s);
    o.pose.rotation = rotation;
    o.velocity = tumble_v(t->speed, 0, 0);
    return tumble_body_add(w, shape, o);
}

// How long is it on its way?  Until friction has stopped it, and half as long
// again; without friction: 12 tiles.
static double duration(const trial *t)
{
    double stops = t->speed / (t->friction * FAMILY_G);
    return t->friction > 0 ? 1.5 * stops : 12 * TILE * t->size / t->speed;
}

static outcome slide(hard_report *r, const trial *t)
{
    tumble_options o = family_options(t->dt, t->friction);
    outcome out = { 0, 0, 0, 0, 0, 0 };
    tumble_world *w = tumble_world_make(&o);
    lay_floor(w, t);
    double height;
    tumble_body b = add_slider(w, t, &height);
    for (double time = 0; time < duration(t); time += t->dt) {
        tumble_world_step(w);
        tumble_vec3 x = tumble_body_position(w, b);
        out.furthest = hard_worse(out.furthest, x.x);
        out.hop = hard_worse(out.hop, x.y - height);
        out.aside = hard_worse(out.aside, fabs(x.z - 0.075 * t->size));
    }
    out.way = tumble_body_position(w, b).x;
    out.speed = tumble_body_velocity(w, b).x;
    out.ok = family_ok(r, w);
    tumble_world_free(w);
    return out;
}

// ---- 101 and 102: smooth floors -------------------------------------------

// What is measured over all trials of a row.
typedef struct {
    family_worst way, rolls, speed, hop, share, aside;
} tally;

static tally new_tally(void)
{
    tally a = { .way = { .target = 0.03 }, .rolls = { .target = 0.03 },
                .speed = { .target = 1e-3 }, .hop = { .target = 1e-3 },
                .share = { .target = 2e-3 }, .aside = { .target = 2e-3 } };
    return a;
}

static void judge(hard_report *r, tally *a, const trial *t)
{
    outcome o = slide(r, t);
    const char *f = floor_name[t->floor], *b = slider_name[t->slider];
#define HERE "%s %g m, %.3g m/s on %s, dt 1/%.0f", b, t->size, t->speed, f, \
    1 / t->dt
    double ideal = t->speed * t->speed / (2 * t->friction * FAMILY_G);
    if (t->friction == 0)
        family_trial(&a->speed, fabs(o.speed / t->speed - 1), HERE);
    else if (t->slider == BALL)
        family_trial(&a->rolls, fabs(o.speed / t->speed * 7 / 5 - 1), HERE);
    else
        family_trial(&a->way, fabs(o.way / ideal - 1), HERE);
    family_trial(&a->hop, o.hop, HERE);
    family_trial(&a->share, o.hop / t->size, HERE);
    family_trial(&a->aside, o.aside / t->size, HERE);
#undef HERE
}

// Speeds are those of a slider of 0.4 m; others have the same Froude number,
// v^2 / (g size), so that all cross as many seams.
static double froude_speed(double speed, double size)
{
    return speed * sqrt(size / 0.4);
}

static void cross_seams(hard_report *r, tally *a, trial t, int fast)
{
    static const double speed[] = { 0.5, 2, 5, 10, 20 };
    static const double size[] = { 0.4, 0.02, 4, 0.4, 0.4 };
    static const double dt[] = { 1 / 60.0, 1 / 60.0, 1 / 60.0, 1 / 240.0,
                                 1 / 30.0 };
    int frictionless = t.friction == 0;
    for (int k = 0; k < (fast ? 1 : 5); k++)
        for (int v = fast ? 3 : 0; v < (fast ? 4 : 5); v++) {
            t.size = size[k];
            t.dt = dt[k];
            t.speed = froude_speed(speed[v], t.size);
            // The fast ones need more friction to stay on the floor.
            if (!frictionless) t.friction = speed[v] > 10 ? 0.8 : 0.3;
            judge(r, a, &t);
        }
}

static void smooth_floors(hard_report *r, tally *a, double friction, int fast)
{
    for (int f = 0; f < FLOORS; f++)
        for (int b = 0; b < SLIDERS; b++) {
            trial t = { .floor = (floor_kind)f, .slider = (slider_kind)b,
                        .friction = friction };
            // Two tilings are crossed aslant by the box.
            if (b == BOX && f >= TRIANGLES) t.turned = 0.5;
            cross_seams(r, a, t, fast);
        }
}

static void sliding(hard_report *r, int fast)
{
    tally a = new_tally();
    smooth_floors(r, &a, 0.3, fast);
    family_add(r, &a.way, "", "way, from v^2 / (2 mu g)");
    family_add(r, &a.rolls, "", "speed of a ball that rolls, from 5/7 v");
    family_add(r, &a.hop, "m", "hop");
    family_add(r, &a.share, "", "hop / size");
    family_add(r, &a.aside, "", "sideways / size");
}

static void gliding(hard_report *r, int fast)
{
    tally a = new_tally();
    smooth_floors(r, &a, 0, fast);
    family_add(r, &a.speed, "", "speed, from what it was");
    family_add(r, &a.hop, "m", "hop");
    family_add(r, &a.share, "", "hop / size");
    family_add(r, &a.aside, "", "sideways / size");
}

// ---- 103: a real step ------------------------------------------------------

// A step of a fortieth of the slider (1 cm of 0.4 m) stops it: it comes as far
// as the step, and no further.  Slow enough, it cannot tip over: its energy
// about the step's edge would lift it too little up to 4.5 m/s (at 0.4 m).
static void real_step(hard_report *r, int fast)
{
    static const double speed[] = { 0.7, 1.4, 2.1, 3 };
    static const double size[] = { 0.4, 0.02, 4 };
    family_worst past = { .target = 0.01 }, before = { .target = 0.01 };
    for (int f = PIECES; f <= DYNAMICS; f++)
        for (int b = BOX; b <= COIN; b += COIN - BOX)
            for (int k = fast ? 2 : 0; k < (fast ? 3 : 12); k++) {
                double s = size[k / 4];
                trial t = { .floor = (floor_kind)f, .slider = (slider_kind)b,
                            .size = s, .speed = froude_speed(speed[k % 4], s),
                            .friction = 0.05, .dt = 1 / 60.0, .step = s / 40 };
                outcome o = slide(r, &t);
                double edge = TILE * s / 2 - s / 2;
#define HERE "%s %g m, %.3g m/s on %s", slider_name[b], s, t.speed, \
    floor_name[f]
                family_trial(&past, fmax(o.way - edge, 0) / s, HERE);
                family_trial(&before, fmax(edge - o.furthest, 0) / s, HERE);
#undef HERE
            }
    family_add(r, &past, "", "past the step / size");
    family_add(r, &before, "", "stopped before the step / size");
}

// ---- 104: rough ground -----------------------------------------------------

// Heights on a grid of cells of two sizes that have nothing to do with each other;
// things of six kinds are let fall on them.
enum { ROUGH = 17, FALLEN = 18 };

static void lay_rough_ground(tumble_world *w, family_seed *s, double size,
                             double rough, int is_mesh)
{
    double height[ROUGH * ROUGH], side = 2 * size;
    tumble_vec3 point[ROUGH * ROUGH];
    int corner[6 * ROUGH * ROUGH], n = 0;
    for (int k = 0; k < ROUGH * ROUGH; k++) {
        int i = k % ROUGH, j = k / ROUGH;
        height[k] = family_between(s, -rough * side, 0);
        point[k] = (tumble_vec3){ side * (i - ROUGH / 2), height[k],
                                  side * (j - ROUGH / 2) };
        int cell[6] = { k, k + ROUGH, k + ROUGH + 1, k, k + ROUGH + 1, k + 1 };
        if (i == ROUGH - 1 || j == ROUGH - 1) continue;
        for (int c = 0; c < 6; c++) corner[n++] = cell[c];
    }
    tumble_body_options o = tumble_body_at(0, 0, 0);
    double wide = side * (ROUGH - 1);
    if (is_mesh)
        tumble_body_add_mesh(w, point, ROUGH * ROUGH, corner, n / 3, 0, o);
    else
        tumble_body_add_heights(w, height, ROUGH, ROUGH, wide, wide, 0, o);
}

static void drop_thing(tumble_world *w, family_seed *s, int k, double size)
{
    double a = size / 2;
    tumble_pose at[2] = { place(0, 0, 0), place(1.5 * a, 0, 0) };
    tumble_shape of[2];
    tumble_body_options o = tumble_body_at(size * (2 * (k % 3) - 2),
        size * (1 + 1.5 * (k / 9)), size * (2 * (k / 3 % 3) - 2));
    o.pose.rotation = family_rotation(s);
    of[0] = k % 6 == 0 ? tumble_shape_cone(w, size, 0.8 * a, 1)
          : k % 6 == 1 ? tumble_shape_box(w, (tumble_vec3){ size, a, a / 4 }, 1)
          : k % 6 == 2 ? tumble_shape_capsule(w, a, a / 2, 1)
          : k % 6 == 3 ? tumble_shape_cylinder(w, a / 2, a, 1)
          : k % 6 == 4 ? family_prism(w, 6, a, size / 3, 1)
                       : tumble_shape_sphere(w, 0.6 * a, 2);
    of[1] = tumble_shape_sphere(w, 0.4 * a, 1);
    if (k % 6 == 5) tumble_body_add_compound(w, of, at, 2, o);
    else            tumble_body_add(w, of[0], o);
}

static void rough_ground(hard_report *r, int fast)
{
    static const double size[] = { 0.4, 0.02, 4 }, rough[] = { 0.1, 0.3, 1 };
    static const double dt[] = { 1 / 60.0, 1 / 240.0 };
    family_worst deep = { .target = 0.02 }, end = { .target = 0.005 };
    family_seed s = 104;
    for (int k = 0; k < (fast ? 2 : 72); k++) {
        double a = size[k / 2 % 3], share = rough[k / 6 % 3], h = dt[k / 18 % 2];
        tumble_options o = family_options(h, 0.5);
        tumble_world *w = tumble_world_make(&o);
        double deepest = 0, now = 0, seconds = 12 * sqrt(a / FAMILY_G);
        lay_rough_ground(w, &s, a, share, k % 2);
        for (int i = 0; i < FALLEN; i++) drop_thing(w, &s, i, a);
        for (int i = (int)(seconds / h); i > 0; i--) {
            tumble_world_step(w);
            now = tumble_world_measure(w).penetration;
            deepest = hard_worse(deepest, now);
        }
#define HERE "%g m, %s as rough as %g, dt 1/%.0f", a, \
    k % 2 ? "triangles" : "heights", share, 1 / h
        family_trial(&deep, deepest / a, HERE);
        family_trial(&end, now / a, HERE);
#undef HERE
        family_ok(r, w);
        tumble_world_free(w);
    }
    family_add(r, &deep, "", "deepest in any frame / size");
    family_add(r, &end, "", "deepest at the end / size");
}

const hard_case family_seams[] = {
    { 101, "slides over seams", 1, sliding },
    { 102, "glides over seams", 1, gliding },
    { 103, "a real step still stops", 1, real_step },
    { 104, "rough ground holds what falls", 1, rough_ground },
    { 0, NULL, 0, NULL }
};
