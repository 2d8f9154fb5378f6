// race_scenes.c - what is raced: rooms, piles, joints, and cloth.
//
// Every scene has a seed.  Rooms and heaps are thrown another way by another one;
// what is built to stand is displaced by up to a millimetre.

#include "race.h"
#include "random.h"

#include <stdlib.h>

static const vec3 X = { 1, 0, 0 }, Y = { 0, 1, 0 }, Z = { 0, 0, 1 };
static const real MILLIMETRE = 1e-3;

static unsigned long long state;

// ---- Forms -----------------------------------------------------------------

static body_form box_of(real x, real y, real z, real mass)
{
    body_form f = { .kind = FORM_BOX, .half = { x, y, z }, .mass = mass, .corners = 4,
               .normals = 3, .edges = 3, .normal = { X, Y, Z }, .edge = { X, Y, Z } };
    f.radius = vec3_length(f.half);
    for (int k = 0; k < 4; k++)
        f.corner[k] = vec3_make(k & 1 ? x : -x, k & 2 ? y : -y, z);
    return f;
}

static body_form ball_of(real radius, real mass)
{
    return (body_form){ .kind = FORM_BALL, .half = { radius, radius, radius },
                   .radius = radius, .mass = mass };
}

static void add_direction(vec3 *list, int *n, vec3 d)
{
    for (int k = 0; k < *n; k++)
        if (fabs(vec3_dot(list[k], d)) > 0.999) return;
    list[(*n)++] = vec3_unit(d);
}

// Three corners that are an edge apart are a face.
static void add_faces(body_form *f, const vec3 at[12], real edge)
{
    const real more = 1.01 * edge;
    for (int i = 0; i < 12; i++)
        for (int j = i + 1; j < 12; j++) {
            if (vec3_distance(at[i], at[j]) > more) continue;
            add_direction(f->edge, &f->edges, vec3_unit(vec3_sub(at[j], at[i])));
            for (int k = j + 1; k < 12; k++) {
                if (vec3_distance(at[i], at[k]) > more) continue;
                if (vec3_distance(at[j], at[k]) > more) continue;
                vec3 sum = vec3_add(at[i], vec3_add(at[j], at[k]));
                add_direction(f->normal, &f->normals, vec3_unit(sum));
            }
        }
}

// Its corners are (0, 1, g), g = (1 + sqrt 5) / 2, with all signs, and the same
// with the coordinates moved on.
static body_form icosahedron_of(real radius, real mass)
{
    body_form f = { .kind = FORM_ICOSAHEDRON, .radius = radius, .mass = mass };
    real golden = (1 + sqrt(5)) / 2, unit = radius / sqrt(1 + golden * golden);
    vec3 at[12];
    for (int k = 0; k < 2; k++) {
        real one = k ? unit : -unit, g = golden * unit;
        f.corner[k] = vec3_make(0, one, g);
        f.corner[2 + k] = vec3_make(g, 0, one);
        f.corner[4 + k] = vec3_make(one, g, 0);
    }
    f.corners = 6;
    for (int k = 0; k < 6; k++) {
        at[k] = f.corner[k];
        at[6 + k] = vec3_scale(-1, f.corner[k]);
    }
    add_faces(&f, at, 2 * unit);
    return f;
}

// ---- Parts -----------------------------------------------------------------

static scene scene_begin(const char *name, int bodies, int frames, int seed)
{
    scene s = { .name = name, .bodies = bodies, .frames = frames, .runs = RUN_BOTH,
                .friction = 0.6, .dt = 1.0 / 60 };
    s.body = calloc((size_t)bodies + 1, sizeof *s.body);
    if (!s.body) give_up("there is no memory for a scene");
    state = 12 + (unsigned long long)seed;
    random_real(&state);
    return s;
}

static void put(scene *s, int k, real x, real y, real z)
{
    s->body[k].at = (pose){ .middle = { x, y, z }, .x = X, .y = Y, .z = Z };
}

static void displace(scene *s, int k)
{
    s->body[k].at.middle.x += MILLIMETRE * random_real(&state);
    s->body[k].at.middle.z += MILLIMETRE * random_real(&state);
}

static void turn_at_random(pose *p)
{
    p->x = random_direction(&state);
    p->y = vec3_unit(vec3_cross(p->x, random_direction(&state)));
    p->z = vec3_cross(p->x, p->y);
}

static void add_wall(scene *s, vec3 normal, real offset)
{
    s->normal[s->walls] = normal;
    s->offset[s->walls++] = offset;
}

// Walls around the y axis, `far` off.
static void add_sides(scene *s, real far)
{
    for (int way = -1; way <= 1; way += 2) {
        add_wall(s, vec3_scale(way, X), -far);
        add_wall(s, vec3_scale(way, Z), -far);
    }
}

// The place of body k in a cubic grid of so many cells, around the y axis.
static vec3 cell(int k, int cells, real wide)
{
    real half = (cells - 1) / 2.0;
    return vec3_scale(wide, vec3_make(k % cells - half, k / (cells * cells),
                                      k / cells % cells - half));
}

static int cells_for(int bodies)
{
    int cells = 1;
    while (cells * cells * cells < bodies) cells++;
    return cells;
}

static void add_joints(scene *s, int most)
{
    s->joint = calloc((size_t)most, sizeof *s->joint);
    if (!s->joint) give_up("there is no memory for joints");
}

// ---- Rooms and heaps -------------------------------------------------------

// Into a closed room, one in each cell of a grid.  Returns how wide a cell is (m).
static real throw_all(scene *s, real side)
{
    int cells = cells_for(s->bodies);
    real wide = side / cells;
    s->friction = 0.5;
    for (int k = 0; k < s->bodies; k++) {
        vec3 c = cell(k, cells, wide);
        put(s, k, c.x, c.y + wide / 2, c.z);
        turn_at_random(&s->body[k].at);
        s->body[k].velocity = random_vec3(&state, 5);
        s->body[k].spin = random_vec3(&state, 5);
    }
    add_wall(s, Y, 0);
    add_wall(s, vec3_scale(-1, Y), -side);
    add_sides(s, side / 2);
    return wide;
}

scene make_thrown(int bodies, int seed)
{
    scene s = scene_begin("room", bodies, 420, seed);
    s.form[s.forms++] = icosahedron_of(0.5, 1);
    // A seventh of the room is filled, and no two begin in each other.
    real wide = throw_all(&s, fmax(cbrt(0.317 / 0.15 * bodies), cells_for(bodies)));
    for (int k = 0; k < bodies; k++) {
        vec3 off = random_vec3(&state, fmax(0, wide / 2 - 0.5));
        s.body[k].at.middle = vec3_add(s.body[k].at.middle, off);
    }
    return s;
}

// Half an edge of 10 to 50 cm; all of one density.
scene make_sizes(int bodies, int seed)
{
    scene s = scene_begin("mixed sizes", bodies, 300, seed);
    s.runs = RUN_AWAKE;
    for (int k = 0; k < 5; k++) {
        real half = 0.1 * (k + 1);
        s.form[s.forms++] = box_of(half, half, half, 8 * half * half * half);
    }
    throw_all(&s, 1.75 * cells_for(bodies));
    for (int k = 0; k < bodies; k++) s.body[k].form = random_below(&state, 5);
    return s;
}

scene make_drop(int bodies, int seed)
{
    const real wide = 1.8;      // so that none overlaps however it is turned
    scene s = scene_begin("drop", bodies, 420, seed);
    int cells = cells_for(bodies);
    s.form[s.forms++] = box_of(0.5, 0.5, 0.5, 1);
    for (int k = 0; k < bodies; k++) {
        vec3 c = cell(k, cells, wide);
        put(&s, k, c.x + 0.03 * random_real(&state), c.y + 1,
            c.z + 0.03 * random_real(&state));
        turn_at_random(&s.body[k].at);
    }
    add_wall(&s, Y, 0);
    add_sides(&s, wide / 2 * (cells + 0.5));
    return s;
}

// ---- What is built to stand ------------------------------------------------

scene make_pyramid(int rows, int seed)
{
    scene s = scene_begin("pyramid", rows * (rows + 1) / 2, 480, seed);
    s.is_built = true;
    s.form[s.forms++] = box_of(0.5, 0.5, 0.5, 1);
    for (int row = 0, k = 0; row < rows; row++)
        for (int i = 0; i < rows - row; i++, k++) {
            put(&s, k, i + row / 2.0 - rows / 2.0, row + 0.5, 0);
            s.body[k].at.middle.z = MILLIMETRE * random_real(&state);
        }
    add_wall(&s, Y, 0);
    return s;
}

static void add_stack(scene *s, int first, int high, real x, real z)
{
    for (int k = 0; k < high; k++) {
        put(s, first + k, x, k + 0.5, z);
        displace(s, first + k);
    }
}

scene make_tower(int high, int seed)
{
    scene s = scene_begin("tower", high, 480, seed);
    s.is_built = true;
    s.form[s.forms++] = box_of(0.5, 0.5, 0.5, 1);
    add_stack(&s, 0, high, 0, 0);
    add_wall(&s, Y, 0);
    return s;
}

scene make_stacks(int stacks, int seed)
{
    scene s = scene_begin("stacks of ten", 10 * stacks, 240, seed);
    s.is_built = true;
    s.form[s.forms++] = box_of(0.5, 0.5, 0.5, 1);
    for (int k = 0; k < stacks; k++)
        add_stack(&s, 10 * k, 10, 2 * (k % 10), 2 * (k / 10));
    add_wall(&s, Y, 0);
    return s;
}

// A ton on a kilogram, ten metres from the stacks.
scene make_hard_pair(int stacks, int seed)
{
    scene s = make_stacks(stacks, seed);
    s.name = "hard pair beside stacks";
    s.body = realloc(s.body, (size_t)(s.bodies + 2) * sizeof *s.body);
    if (!s.body) give_up("there is no memory for a scene");
    s.form[s.forms++] = box_of(0.5, 0.5, 0.5, 1000);
    for (int k = 0; k < 2; k++) {
        s.body[s.bodies] = (body_start){ .form = k };
        put(&s, s.bodies++, -10, k + 0.5, 0);
    }
    return s;
}

// Boxes that have fallen asleep, and ten balls that roll between their rows.
scene make_rolling(int boxes, int seed)
{
    const int balls = 10, rows = 40;
    scene s = scene_begin("10 balls among sleepers", boxes + balls, 180, seed);
    s.runs = RUN_DEFAULT;
    s.timed_from = 60;
    s.form[s.forms++] = box_of(0.4, 0.4, 0.4, 1);
    s.form[s.forms++] = ball_of(0.3, 1);
    for (int k = 0; k < boxes; k++) {
        put(&s, k, 2 * (k % rows), 0.4, 2 * (k / rows));
        displace(&s, k);
    }
    for (int k = boxes; k < boxes + balls; k++) {
        put(&s, k, 1 + 6 * (k - boxes), 0.3, -2);
        s.body[k].form = 1;
        s.body[k].velocity = vec3_scale(3, Z);
        s.body[k].spin = vec3_scale(10, X);
    }
    add_wall(&s, Y, 0);
    return s;
}

// ---- Joints ----------------------------------------------------------------

enum { LIMBS = 11, LIMB_FORMS = 5 };
static const struct {
    int  form;
    real x, y;          // m, its middle
    int  on;            // hangs on this one
    real at_x, at_y;    // m, the joint
} LIMB[LIMBS] = {
    { 0, 0, 1.2, 0, 0, 0 },                                     // chest
    { 1, 0, 1.58, 0, 0, 1.44 },                                 // head
    { 2, 0, 0.88, 0, 0, 0.98 },                                 // hips
    { 3, -0.24, 1.17, 0, -0.24, 1.34 }, { 3, 0.24, 1.17, 0, 0.24, 1.34 },
    { 3, -0.24, 0.81, 3, -0.24, 0.99 }, { 3, 0.24, 0.81, 4, 0.24, 0.99 },
    { 4, -0.09, 0.56, 2, -0.09, 0.77 }, { 4, 0.09, 0.56, 2, 0.09, 0.77 },
    { 4, -0.09, 0.12, 7, -0.09, 0.34 }, { 4, 0.09, 0.12, 8, 0.09, 0.34 },
};

static void add_doll(scene *s, int doll, vec3 middle)
{
    pose p;
    turn_at_random(&p);
    int first = LIMBS * doll;
    for (int k = 0; k < LIMBS; k++) {
        vec3 arm = vec3_add_scaled(vec3_scale(LIMB[k].x, p.x), LIMB[k].y - 1, p.y);
        vec3 at = vec3_add_scaled(vec3_scale(LIMB[k].at_x, p.x), LIMB[k].at_y - 1, p.y);
        s->body[first + k] = (body_start){ .form = LIMB[k].form, .at = p };
        s->body[first + k].at.middle = vec3_add(middle, arm);
        if (k == 0) continue;
        s->joint[s->joints++] = (ball_joint){ first + k, first + LIMB[k].on,
                                              vec3_add(middle, at) };
    }
}

scene make_dolls(int dolls, int seed)
{
    scene s = scene_begin("dolls of 11 limbs", LIMBS * dolls, 150, seed);
    s.runs = RUN_AWAKE;
    add_joints(&s, LIMBS * dolls);
    s.form[s.forms++] = box_of(0.16, 0.2, 0.1, 20);
    s.form[s.forms++] = box_of(0.09, 0.12, 0.09, 5);
    s.form[s.forms++] = box_of(0.15, 0.08, 0.1, 10);
    s.form[s.forms++] = box_of(0.05, 0.16, 0.05, 2);
    s.form[s.forms++] = box_of(0.07, 0.2, 0.07, 5);
    for (int k = 0; k < dolls; k++) {
        vec3 c = cell(k, cells_for(dolls), 2.2);
        add_doll(&s, k, vec3_add(c, vec3_make(0, 1.5, 0)));
    }
    add_wall(&s, Y, 0);
    add_sides(&s, 1.1 * cells_for(dolls) + 0.3);
    return s;
}

// It hangs from its first link, lies flat, and falls.
scene make_chain(int links, int seed)
{
    const real half = 0.2;
    scene s = scene_begin("chain", links, 300, seed);
    s.runs = RUN_AWAKE;
    add_joints(&s, links);
    s.form[s.forms++] = box_of(half, 0.05, 0.05, 1);
    for (int k = 0; k < links; k++) {
        put(&s, k, half * (2 * k + 1), 0, 0);
        s.body[k].velocity = vec3_scale(0.01 * random_real(&state), Z);
        s.joint[s.joints++] = (ball_joint){ k, k - 1, { 2 * half * k, 0, 0 } };
    }
    return s;
}

// ---- Cloth -----------------------------------------------------------------

static scene cloth_begin(const char *name, int side, int bodies, int seed)
{
    scene s = scene_begin(name, bodies, side > 60 ? 160 : 240, seed);
    s.runs = RUN_AWAKE;
    s.sheet = (cloth_sheet){ .side = side, .width = 2, .mass = 1 };
    s.sheet.middle = vec3_make(0.02 * random_real(&state), 1.6,
                               0.02 * random_real(&state));
    return s;
}

scene make_cloth_on_cube(int side, int seed)
{
    scene s = cloth_begin("cloth on a cube", side, 1, seed);
    s.fixed = 1;
    s.form[s.forms++] = box_of(0.4, 0.4, 0.4, 1);
    put(&s, 0, 0, 1, 0);
    add_wall(&s, Y, 0);
    return s;
}

// Held at two corners, it falls, and swings.
scene make_flag(int side, int seed)
{
    scene s = cloth_begin("flag", side, 0, seed);
    s.sheet.pins = 2;
    return s;
}

// Held at four corners, and boxes fall into it.
scene make_cloth_with_boxes(int side, int seed)
{
    scene s = cloth_begin("cloth with boxes", side, 10, seed);
    s.frames = 150;
    s.sheet.pins = 4;
    s.form[s.forms++] = box_of(0.12, 0.12, 0.12, 0.1);
    for (int k = 0; k < s.bodies; k++) {
        put(&s, k, 0.5 * (k % 3 - 1), 2 + 0.5 * (k / 3), 0.4 * (k % 2) - 0.2);
        turn_at_random(&s.body[k].at);
    }
    return s;
}

void scene_free(scene *s)
{
    free(s->body);
    free(s->joint);
}
