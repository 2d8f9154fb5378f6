// worlds.c - see worlds.h.

#include "worlds.h"

#include "convex.h"
#include "step.h"

#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

// ---- The options -----------------------------------------------------------

typedef enum { OPTION_REAL, OPTION_INT, OPTION_BOOL } option_kind;

typedef struct {
    const char *name;
    size_t      at;         // where it stands in world_options
    option_kind kind;
    real        least, most;
} option_range;

#define OPTION(kind, name, least, most) \
    { #name, offsetof(world_options, name), OPTION_##kind, least, most }

// All that is varied.  A new option is a line here, and changes nothing else in
// the trial of a seed.  Where a range ends so far off that a frame would take
// minutes by right, it ends earlier here.
static const option_range RANGE[] = {
    OPTION(REAL, dt, 1e-4, 1),
    OPTION(INT, substeps, 1, 16),
    OPTION(REAL, friction, 0, 1000),
    OPTION(REAL, restitution, 0, 1),
    OPTION(INT, most_substeps, 1, 32),
    OPTION(REAL, hertz, 1e-3, 1e6),
    OPTION(REAL, stay, 0, 0.1),
    OPTION(BOOL, warm_start, 0, 1),
    OPTION(REAL, sleep_speed, 0, 10),
    OPTION(REAL, time_to_sleep, 0, 10),
    OPTION(INT, iterations, 1, 64),
    OPTION(REAL, relax.tolerance, 0, 1),
    OPTION(INT, relax.root, 0, ROOT_APPROXIMATE),
    OPTION(INT, relax.gradient, 0, GRADIENT_OLD),
    OPTION(BOOL, ledger, 0, 1),
};
enum { RANGES = sizeof RANGE / sizeof RANGE[0] };

// ---- Random numbers --------------------------------------------------------

static unsigned long long any_bits(trial *t)
{
    unsigned long long z = t->state += 0x9e3779b97f4a7c15ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
}

// Uniform in [least, most).
static real any_real(trial *t, real least, real most)
{
    return least + (most - least) * (real)(any_bits(t) >> 11) * 0x1p-53;
}

// From least to most.
static int any_int(trial *t, int least, int most)
{
    return least + (int)(any_bits(t) % (unsigned)(most - least + 1));
}

// True once in `of`.
static bool any_chance(trial *t, int of)
{
    return any_bits(t) % (unsigned)of == 0;
}

// Any power of two between two powers, times 1 to 2: every size is as likely.
static real any_scale(trial *t, int least, int most)
{
    int exponent = any_int(t, least, most - 1);
    return ldexp(any_real(t, 1, 2), exponent);
}

static vec3 any_vec3(trial *t, real most)
{
    real x = any_real(t, -most, most), y = any_real(t, -most, most);
    return vec3_make(x, y, any_real(t, -most, most));
}

static vec3 any_unit(trial *t)
{
    vec3 d = any_vec3(t, 1);
    real l = vec3_length(d);
    return l > 0.1 && l < 1 ? vec3_scale(1 / l, d) : any_unit(t);
}

// Keeps the first fault alone.
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
static void find_fault(trial *t, trial_fault fault, const char *format, ...)
{
    va_list rest;
    if (t->fault != TRIAL_WELL) return;
    t->fault = fault;
    va_start(rest, format);
    vsnprintf(t->why, TRIAL_TEXT, format, rest);
    va_end(rest);
}

static void must_be_made(trial *t, const char *what, status done)
{
    if (!done.ok) find_fault(t, TRIAL_REFUSED, "%s: %s", what, done.why);
}

// ---- Shapes ----------------------------------------------------------------

enum { HULL_POINTS = 14, HULL_FACES = 2 * HULL_POINTS };

// Points, and the triangles that have all other points behind them.
typedef struct {
    vec3 at[HULL_POINTS];
    int  points, face[HULL_FACES][3], faces;
} random_hull;

static bool is_outmost(const random_hull *h, int i, int j, int k)
{
    vec3 n = vec3_cross(vec3_sub(h->at[j], h->at[i]),
                        vec3_sub(h->at[k], h->at[i]));
    for (int p = 0; p < h->points; p++)
        if (p != i && p != j && p != k
            && vec3_dot(n, vec3_sub(h->at[p], h->at[i])) >= 0) return false;
    return true;
}

static void add_face(random_hull *h, int i, int j, int k)
{
    if (h->faces == HULL_FACES || !is_outmost(h, i, j, k)) return;
    memcpy(h->face[h->faces++], (int[3]){ i, j, k }, sizeof h->face[0]);
}

// Points on an ellipsoid: each is a vertex.
static status make_hull(trial *t, shape *s, vec3 size, real mass)
{
    random_hull h = { .points = any_int(t, 4, HULL_POINTS) };
    for (int i = 0; i < h.points; i++) {
        vec3 d = any_unit(t);
        h.at[i] = vec3_make(size.x * d.x, size.y * d.y, size.z * d.z);
    }
    for (int i = 0; i < h.points; i++)
        for (int j = i + 1; j < h.points; j++)
            for (int k = j + 1; k < h.points; k++) {
                add_face(&h, i, j, k);
                add_face(&h, i, k, j);
            }
    return shape_convex(s, h.points, h.at, h.faces,
                        (const int (*)[3])h.face, mass);
}

static status make_tetrahedron(shape *s, vec3 size, real mass)
{
    static const int face[4][3] = {
        { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 }
    };
    vec3 at[4] = { { 0, 0, 0 }, { size.x, 0, 0 }, { 0, 0, -size.z },
                   { 0, size.y, 0 } };
    return shape_convex(s, 4, at, 4, face, mass);
}

// Cubes, boxes, plates down to a thousandth as thick as wide, needles.
static vec3 any_sides(trial *t, real size)
{
    vec3 sides = { size, size, size };
    int kind = any_int(t, 0, 3);
    if (kind == 1) sides = vec3_make(any_real(t, 0.2, 1) * size,
                                     any_real(t, 0.2, 1) * size, size);
    if (kind >= 2) sides.y *= any_scale(t, -10, -3);
    if (kind == 3) sides.x = sides.y;
    return sides;
}

static status make_soft(trial *t, shape *s, real size, real mass)
{
    int most = any_chance(t, 6) ? 40 : 12;
    int columns = any_int(t, 2, most), rows = any_int(t, 2, most);
    if (any_chance(t, 2))
        return shape_rope(s, any_int(t, 1, 40), size * any_int(t, 1, 4), mass);
    return shape_cloth(s, columns, rows, size * columns / 6, size * rows / 6,
                       mass, any_chance(t, 2) ? 1 : 0.2);
}

// Every fifth shape is soft, in a trial that has some.
static void add_shape(trial *t, bool has_soft, real size)
{
    shape *s = &t->shape[t->shapes++];
    real mass = any_chance(t, 2) ? 1 : any_scale(t, -20, 20);
    int range = any_chance(t, 4) ? 5 : 1;
    vec3 sides = any_sides(t, size * any_scale(t, -range, range));
    status done;
    if (has_soft && any_chance(t, 5)) done = make_soft(t, s, size, mass);
    else switch (any_int(t, 0, 5)) {
    case 0:  done = shape_icosahedron(s, size / 2, mass); break;
    case 1:  done = make_hull(t, s, sides, mass); break;
    case 2:  done = make_tetrahedron(s, sides, mass); break;
    default: done = shape_box(s, sides, mass); break;
    }
    // A hull may be thinner than a body may be.
    if (!done.ok) done = shape_box(s, vec3_make(size, size, size), mass);
    must_be_made(t, "a shape", done);
}

// ---- Places ----------------------------------------------------------------

// How the bodies of a trial stand, and move.
enum { SCATTERED, STACKED, ALL_IN_ONE_PLACE, ARRANGEMENTS };
typedef struct {
    int  bodies;
    real size;              // m, of a body
    int  how;               // one of those
    real reach;             // m, SCATTERED: half the side of a cube around them
    real speed, spin;       // m/s, rad/s, at most
    bool is_turned, has_soft, has_static;
} group;

static group any_group(trial *t)
{
    static const real fast[] = { 0, 1, 10, 1e4 }, quick[] = { 0, 10, 200, 1e3 };
    group c = { .bodies = 1 << any_int(t, 0, 5), .size = any_scale(t, -7, 4),
                .how = any_int(t, 0, 2 * ARRANGEMENTS) % (ARRANGEMENTS + 2) };
    if (c.how >= ARRANGEMENTS) c.how = SCATTERED;
    c.bodies = any_int(t, (c.bodies + 1) / 2, c.bodies);
    c.reach = c.size * any_scale(t, -3, 4);
    c.speed = fast[any_int(t, 0, 3)];
    c.spin = quick[any_int(t, 0, 3)];
    c.is_turned = any_chance(t, 2) || c.how == SCATTERED;
    c.has_soft = t->has_soft = any_chance(t, 2);
    c.has_static = any_chance(t, 2);
    return c;
}

static placement any_placement(trial *t, const group *c, int number)
{
    placement p = placement_at(vec3_make(0, 0, 0));
    if (c->how == SCATTERED) p.position = any_vec3(t, c->reach);
    if (c->how == STACKED) p.position.y = c->size * (number + 0.5);
    if (c->is_turned) {
        p.x = any_unit(t);
        p.y = vec3_unit(vec3_cross(p.x, any_unit(t)));
        p.z = vec3_cross(p.x, p.y);
    }
    p.velocity = any_vec3(t, c->speed);
    p.spin = any_vec3(t, c->spin);
    p.is_static = c->has_static && any_chance(t, 6);
    return p;
}

// J: what may come of the speed at the start and of gravity in this body; and
// of overlap at the start, which may end within a step, and at the particles of
// a deformable body within a substep.
static real heat_of(const trial *t, const placement *p, int b, real seconds)
{
    const world_options *o = &t->world.options;
    int steps = t->has_soft ? int_max(o->substeps, o->most_substeps) : 1;
    real r = t->radius[b], fall = seconds * vec3_length(o->gravity);
    real spin = r * vec3_length(p->spin), out = 4 * r * steps / o->dt;
    return t->mass[b] * (vec3_length_squared(p->velocity) + spin * spin
                         + fall * fall + out * out);
}

static void add_body(trial *t, const group *c, int number)
{
    placement p = any_placement(t, c, number);
    const shape *s = &t->shape[any_int(t, 0, t->shapes - 1)];
    int b;
    status done = world_add(&t->world, s, p, &b);
    must_be_made(t, "a body", done);
    if (!done.ok) return;
    t->points[b] = s->particles;
    t->radius[b] = s->radius;
    t->middle[b] = p.position;
    t->mass[b] = 0;
    for (int i = 0; i < s->particles && !p.is_static; i++)
        t->mass[b] += s->mass[i];
    t->heat += heat_of(t, &p, b, 1000 * t->world.options.dt);
    if (s->kind != SHAPE_RIGID && any_chance(t, 3))
        world_pin(&t->world, b, 0);
}

// ---- Planes ----------------------------------------------------------------

static void add_plane(trial *t, vec3 normal, real offset)
{
    must_be_made(t, "a plane", world_add_plane(&t->world, normal, offset));
}

// A cube around all bodies, which stand in a ball of this radius.
static void close_room(trial *t, real reach)
{
    t->is_closed = true;
    t->room = reach * any_real(t, 1, 1.5);
    for (int k = 0; k < 6; k++) {
        vec3 n = { k / 2 == 0, k / 2 == 1, k / 2 == 2 };
        add_plane(t, vec3_scale(k % 2 ? -1 : 1, n), -t->room);
    }
}

// None, a ground, any planes, or a closed room.
static void add_planes(trial *t, const group *c)
{
    int kind = any_int(t, 0, 4);
    real high = c->how == STACKED ? c->size * (c->bodies + 0.5)
              : c->how == SCATTERED ? 1.8 * c->reach : 0;
    if (kind == 1)
        add_plane(t, vec3_make(0, any_scale(t, -4, 4), 0), 0);
    if (kind == 2)
        for (int k = any_int(t, 1, 6); k > 0; k--)
            add_plane(t, any_unit(t), -any_real(t, -1, 1) * high);
    if (kind >= 3) {
        real most = 0;
        for (int k = 0; k < t->shapes; k++)
            most = real_max(most, t->shape[k].radius);
        close_room(t, high + most);
    }
}

// ---- A trial ---------------------------------------------------------------

// An end of the range, or anywhere in it; of a wide range, every size is as
// likely.  Half of them stay as they are.
static void set_option(trial *t, const option_range *r, world_options *o)
{
    real most = r->most, x = any_real(t, r->least, most);
    int where = any_int(t, 0, 7);
    if (r->least > 0 && most > 64 * r->least)
        x = ldexp(r->least, any_int(t, 0, ilogb(most / r->least)));
    if (where == 0) x = r->least;
    if (where == 1) x = most;
    if (where >= 4) return;
    void *to = (char *)o + r->at;
    if (r->kind == OPTION_REAL) memcpy(to, &x, sizeof x);
    if (r->kind == OPTION_INT)  memcpy(to, &(int){ (int)x }, sizeof(int));
    if (r->kind == OPTION_BOOL) memcpy(to, &(bool){ x >= 0.5 }, sizeof(bool));
}

// Each option has random numbers of its own, which its name begins.
static void set_options(trial *t, world_options *o)
{
    unsigned long long kept = t->state;
    for (int k = 0; k < RANGES; k++) {
        t->state = t->seed;
        for (const char *c = RANGE[k].name; *c; c++)
            t->state = (t->state ^ (unsigned char)*c) * 0x100000001b3ull;
        set_option(t, &RANGE[k], o);
    }
    t->state = kept;
}

// The bound on what a frame may cost is of options that allow no more than so
// many times the usual substeps.
enum { MOST_TIMES = 25 };

static world_options any_options(trial *t)
{
    world_options o = world_options_default();
    set_options(t, &o);
    if (o.most_substeps > MOST_TIMES * world_substeps(&o))
        o.most_substeps = MOST_TIMES * world_substeps(&o);
    int pull = any_int(t, 0, 7);
    if (pull == 0) o.gravity = vec3_make(0, 0, 0);
    if (pull == 1) o.gravity = vec3_make(0, -1e3, 0);
    if (pull == 2) o.gravity = any_vec3(t, 100);
    return o;
}

// Some are given a velocity that is no number, at a step near the start.
static void plan_spoiling(trial *t)
{
    static const real with[] = { (real)NAN, (real)INFINITY, -(real)INFINITY };
    t->spoil_step = -1;
    if (!any_chance(t, 4)) return;
    t->spoil_step = any_int(t, 0, 15);
    t->spoil_first = any_int(t, 0, t->world.bodies - 1);
    t->spoil_count = any_int(t, 1, 3);
    t->spoil_with = with[any_int(t, 0, 2)];
}

static void describe(trial *t, const group *c)
{
    static const char *const how[] = { "scattered", "stacked", "in one place" };
    const world_options *o = &t->world.options;
    snprintf(t->what, TRIAL_TEXT, "%d bodies of %.3g m %s%s, %s%d planes, "
             "speed %g, spin %g; dt %.3g / %d, gravity %.4g, friction %.3g, "
             "restitution %.3g%s", t->world.bodies, c->size, how[c->how],
             c->has_soft ? " and soft" : "", t->is_closed ? "closed by " : "",
             t->world.planes, c->speed, c->spin, o->dt, o->substeps,
             vec3_length(o->gravity), o->friction, o->restitution,
             t->spoil_step >= 0 ? ", spoiled" : "");
}

// A stack is made of cubes.
static void make_shapes(trial *t, const group *c)
{
    vec3 cube = { c->size, c->size, c->size };
    if (c->how == STACKED)
        must_be_made(t, "a cube", shape_box(&t->shape[t->shapes++], cube, 1));
    else
        for (int k = any_int(t, 1, 8); k > 0; k--)
            add_shape(t, c->has_soft, c->size);
}

trial_fault trial_make(trial *t, unsigned long long seed)
{
    memset(t, 0, sizeof *t);
    t->seed = t->state = seed;
    must_be_made(t, "the options", world_init(&t->world, any_options(t)));
    if (t->fault != TRIAL_WELL) return t->fault;
    group c = any_group(t);
    make_shapes(t, &c);
    if (t->fault == TRIAL_WELL) add_planes(t, &c);
    for (int k = 0; k < c.bodies && t->fault == TRIAL_WELL; k++)
        add_body(t, &c, k);
    plan_spoiling(t);
    describe(t, &c);
    return t->fault;
}

void trial_free(trial *t)
{
    world_free(&t->world);
    for (int k = 0; k < t->shapes; k++) shape_free(&t->shape[k]);
}

// ---- What must hold --------------------------------------------------------

static void spoil(trial *t)
{
    world *w = &t->world;
    for (int k = 0; k < t->spoil_count; k++) {
        int b = (t->spoil_first + k) % w->bodies;
        w->pool.at[w->body[b].first].previous.x = t->spoil_with;
        t->is_spoiled[b] = true;
    }
}

// Moves the middle of body b, if all of it is numbers.
static bool find_middle(trial *t, int b)
{
    static vec3 at[TRIAL_POINTS];
    const body *x = &t->world.body[b];
    vec3 sum = { 0, 0, 0 };
    int n = t->points[b];
    world_vertices(&t->world, x, at);
    for (int i = 0; i < n; i++) {
        if (!vec3_is_finite(at[i])) return false;
        sum = vec3_add_scaled(sum, 1.0 / n, at[i]);
    }
    t->middle[b] = sum;
    return true;
}

// By so much outside the room, in m; negative: within.
static real outside(const trial *t, vec3 p)
{
    real x = fabs(p.x), y = fabs(p.y), z = fabs(p.z);
    return real_max(x, real_max(y, z)) - t->room;
}

static void judge(trial *t)
{
    real heat = 0;
    for (int b = 0; b < t->world.bodies; b++) {
        vec3 was = t->middle[b];
        if (t->is_spoiled[b]) continue;
        if (!find_middle(t, b)) {
            find_fault(t, TRIAL_NOT_NUMBERS, "body %d: not numbers", b);
            return;
        }
        real way = vec3_distance(t->middle[b], was) / t->world.options.dt;
        real out = outside(t, t->middle[b]);
        heat += t->mass[b] * way * way;
        if (t->is_closed && t->mass[b] > 0 && out > t->radius[b])
            find_fault(t, TRIAL_OUTSIDE, "body %d: %.3g m outside", b, out);
    }
    if (heat > 1e3 * t->heat)
        find_fault(t, TRIAL_TOO_FAST, "%.3g J of motion, where %.3g are much",
                   heat, t->heat);
}

trial_fault trial_step(trial *t)
{
    if (t->step == t->spoil_step) spoil(t);
    world_step(&t->world);
    t->step++;
    judge(t);
    return t->fault;
}
