//> experiments-options
//>   The options are held to their ranges, and then one of three builders
//>   begins.
// experiments.c - see experiments.h.
#include "experiments.h"

#include <assert.h>
#include <stdlib.h>

const char *scene_name(scene_kind kind)
{
    static const char *const name[SCENES] = {
        "room", "cloth-on-cube", "cloth-on-rope"
    };
    return kind >= 0 && kind < SCENES ? name[kind] : "";
}

scene_options scene_options_default(void)
{
    return (scene_options){ .bodies = 50, .cloth = 40, .diagonal = 0.2,
                            .seed = 1 };
}

static status check_scene_options(const scene_options *what)
{
    if (what->bodies < 1 || what->bodies > 20000)
        return status_fail("bodies is %d; it must lie between 1 and 20000",
                           what->bodies);
    if (what->cloth < 2 || what->cloth > 512)
        return status_fail("cloth is %d; it must lie between 2 and 512",
                           what->cloth);
    if (!(what->diagonal > 0 && what->diagonal <= 1))
        return status_fail("diagonal is %g; it must lie above 0, at most 1",
                           what->diagonal);
    return status_ok();
}

// A shape that has just been built becomes the scene's, or is dropped.
static status add_shape(scene *s, shape *built)
{
    status done = scene_add_shape(s, built);
    if (!done.ok) shape_free(built);
    return done;
}

static status build_room(scene *s, const scene_options *what);
static status build_cloth_on_cube(scene *s, const scene_options *what);
static status build_cloth_on_rope(scene *s, const scene_options *what);

status scene_build(scene *s, scene_kind kind, scene_options what)
{
    static status (*const build[SCENES])(scene *, const scene_options *) = {
        build_room, build_cloth_on_cube, build_cloth_on_rope
    };
    assert(kind >= 0 && kind < SCENES);
    scene_init(s);
    status done = check_scene_options(&what);
    if (done.ok) done = build[kind](s, &what);
    if (what.thrown) shape_free(what.thrown);   // empty if it has moved
    if (!done.ok) scene_free(s);
    return done;
}
//<

//> experiments-random
//>   Where the bodies are thrown from is left to chance, but to the same chance
//>   everywhere: a seed gives the same room on every machine.
// SplitMix64 (Steele, Lea, Flood 2014): every state gives a well-mixed number,
// so any seed will do.
static unsigned long long random_bits(unsigned long long *state)
{
    unsigned long long z = (*state += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

// Uniform in [-1, 1), of 53 bits.
static real random_signed(unsigned long long *state)
{
    return (real)(random_bits(state) >> 11) * (2.0 / 9007199254740992.0) - 1;
}

static vec3 random_vector(unsigned long long *state, real most)
{
    real x = random_signed(state), y = random_signed(state);
    real z = random_signed(state);
    return vec3_make(most * x, most * y, most * z);
}

// A uniform orientation: a point of the unit ball in four dimensions, by
// rejection (it fills 31 % of its cube, so 64 tries fail once in 10^10), made a
// unit quaternion, made three axes.
static void random_axes(unsigned long long *state, placement *where)
{
    real w = 1, x = 0, y = 0, z = 0, norm = 0;
    for (int tries = 0; tries < 64 && !(norm > 0.01 && norm <= 1); tries++) {
        w = random_signed(state);
        x = random_signed(state);
        y = random_signed(state);
        z = random_signed(state);
        norm = w * w + x * x + y * y + z * z;
    }
    real s = 2 / norm;
    where->x = vec3_make(1 - s * (y * y + z * z), s * (x * y + w * z),
                         s * (x * z - w * y));
    where->y = vec3_make(s * (x * y - w * z), 1 - s * (x * x + z * z),
                         s * (y * z + w * x));
    where->z = vec3_make(s * (x * z + w * y), s * (y * z - w * x),
                         1 - s * (x * x + y * y));
}
//<

//> experiments-room
//>   An icosahedron of radius 0.5 m has a volume of 0.317 m³, and the room is
//>   so large that the bodies fill 15 % of it.
// Of v >= 1, by Newton's method: from v, which is at least the root, it falls
// to it by a third at most in each step, and stays there.
static real cube_root(real v)
{
    real x = v;
    for (int k = 0; k < 64; k++) x = fmin(x, (2 * x + v / (x * x)) / 3);
    return x;
}

// The six walls, y = 0 the floor.
static status add_walls(scene *s, real side)
{
    struct { vec3 normal; real offset; } wall[6] = {
        { { 0, 1, 0 }, 0 }, { { 0, -1, 0 }, -side },
        { { 1, 0, 0 }, -side / 2 }, { { -1, 0, 0 }, -side / 2 },
        { { 0, 0, 1 }, -side / 2 }, { { 0, 0, -1 }, -side / 2 },
    };
    status done = status_ok();
    for (int k = 0; k < 6 && done.ok; k++)
        done = scene_add_plane(s, wall[k].normal, wall[k].offset);
    return done;
}

// Cells along a side of the smallest cubic grid that has room for N bodies.
static int grid_cells(int bodies)
{
    int cells = 1;
    while (cells * cells * cells < bodies) cells++;
    return cells;
}

// Where body number k begins: in its cell, as far off the middle as the cell is
// wider than the body, turned, thrown and spun at random.
static placement random_throw(const scene *s, int k, int cells,
                              unsigned long long *seed)
{
    real cell = s->size / cells, loose = cell / 2 - SCENE_BODY_RADIUS;
    vec3 corner = vec3_make(k % cells, k / (cells * cells), k / cells % cells);
    vec3 middle = vec3_scale(cell, vec3_add(corner, vec3_make(0.5, 0.5, 0.5)));
    middle = vec3_sub(middle, vec3_make(s->size / 2, 0, s->size / 2));
    placement where = placement_at(vec3_add(
        middle, random_vector(seed, loose > 0 ? loose : 0)));
    random_axes(seed, &where);
    where.velocity = random_vector(seed, 5);
    where.spin = random_vector(seed, 5);
    return where;
}

// The side gives every body 2.1 m^3.  A few bodies fill their grid badly, and
// would overlap in it: then the room is as wide as the grid needs.
static status build_room(scene *s, const scene_options *what)
{
    const real icosahedron = 0.317, filled = 0.15;  // m^3; of the room
    int cells = grid_cells(what->bodies);
    unsigned long long seed = what->seed;
    shape made, *thrown = what->thrown ? what->thrown : &made;
    s->size = cube_root(icosahedron * what->bodies / filled);
    s->size = real_max(s->size, 2 * SCENE_BODY_RADIUS * cells);
    status done = what->thrown
        ? status_ok() : shape_icosahedron(&made, SCENE_BODY_RADIUS, 1);
    if (done.ok) done = add_shape(s, thrown);
    if (done.ok) done = add_walls(s, s->size);
    for (int k = 0; k < what->bodies && done.ok; k++)
        done = scene_add(s, 0, random_throw(s, k, cells, &seed));
    return done;
}
//<

//> experiments-cloth
// The cloth turned by 20 degrees about y, its middle at this place.
static placement cloth_at(vec3 position)
{
    const real cosine = 0.93969262078590838, sine = 0.34202014332566873;
    placement where = placement_at(position);
    where.x = vec3_make(cosine, 0, -sine);
    where.z = vec3_make(sine, 0, cosine);
    return where;
}

// Over something that is so high, by 0.1 m; a coarse cloth, whose particles are
// thick, by so much that it does not touch yet.
static status add_cloth(scene *s, const scene_options *what, real height)
{
    shape cloth;
    status done = shape_cloth(&cloth, what->cloth, what->cloth, 2, 2, 1,
                              what->diagonal);
    if (!done.ok) return done;
    real over = real_max(0.1, 0.7 * cloth.spacing);
    done = add_shape(s, &cloth);
    if (!done.ok) return done;
    vec3 middle = vec3_make(0, height + over, 0);
    return scene_add(s, s->shapes - 1, cloth_at(middle));
}

static status build_cloth_on_cube(scene *s, const scene_options *what)
{
    shape box;
    s->size = 0.8;
    status done = shape_box(&box, vec3_make(s->size, s->size, s->size), 1);
    if (done.ok) done = add_shape(s, &box);
    placement cube = placement_at(vec3_make(0, s->size / 2, 0));
    cube.is_static = true;
    if (done.ok) done = scene_add(s, 0, cube);
    if (done.ok) done = add_cloth(s, what, s->size);
    return done;
}
//<

//> experiments-hang
// Where a chain of n equal links of length l hangs between two pins at the same
// height.  In a chain at rest every link bears the same horizontal pull H, and
// a vertical one that grows by one particle's weight from link to link, in
// units of which link k of 0 .. n - 1 bears V = k - (n - 1) / 2.  The link lies
// along its pull, so it reaches l H / sqrt(H H + V V) across.
static real chain_span(int n, real l, real pull)
{
    real span = 0;
    for (int k = 0; k < n; k++) {
        real v = k - (n - 1) / 2.0;
        span += l * pull / sqrt(pull * pull + v * v);
    }
    return span;
}

// The pull that makes the span, by bisection: the span grows with the pull.
static real chain_pull(int n, real l, real span)
{
    real low = 0, high = 1;
    for (int k = 0; k < 60 && chain_span(n, l, high) < span; k++) high *= 2;
    for (int k = 0; k < 100; k++) {
        real middle = (low + high) / 2;
        if (chain_span(n, l, middle) < span) low = middle;
        else high = middle;
    }
    return high;
}

// Lays the particles of rope b along that chain, from a pin at `from`.
static status hang(scene *s, int b, vec3 from, real span)
{
    const shape *rope = scene_shape(s, b);
    int n = rope->sticks;
    real l = rope->stick[0].rest_length, pull = chain_pull(n, l, span);
    vec3 *start = malloc((size_t)(n + 1) * sizeof *start);
    s->body[b].start = start;
    if (!start) return status_out_of_memory();
    for (int i = 0; i <= n; i++) {
        start[i] = from;
        real v = i - (n - 1) / 2.0, force = sqrt(pull * pull + v * v);
        from = vec3_add(from, vec3_make(l * pull / force, l * v / force, 0));
    }
    status done = scene_add_pin(s, b, 0);
    return done.ok ? scene_add_pin(s, b, n) : done;
}
//<

//> experiments-rope
//>   What is left is to put rope and cloth into one scene.
static status build_cloth_on_rope(scene *s, const scene_options *what)
{
    const real height = 1.5, span = 2.6;
    shape rope;
    s->size = span;
    status done = shape_rope(&rope, 50, 3, 0.5);
    if (done.ok) done = add_shape(s, &rope);
    if (done.ok) done = scene_add(s, 0, placement_at(vec3_make(0, height, 0)));
    if (done.ok) done = hang(s, 0, vec3_make(-span / 2, height, 0), span);
    if (done.ok) done = add_cloth(s, what, height);
    return done;
}
//<
