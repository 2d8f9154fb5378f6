// canopy.c - boxes, stones and balls fall on an awning of cloth and roll off it, again
// and again: the first page of the site.

#include "capsule.h"
#include "handle.h"
#include "live.h"
#include "live_world.h"
#include "measure.h"
#include "step.h"

enum { KINDS = 4, BODIES = 15, CLOTH = BODIES, SIDE = 17, CORNERS = 4, PIN };
static const real WIDE = 2.1, DEEP = 1.6, HIGH = 1.25;  // m, of the cloth
static const vec3 DOWN = { 0, -0.5, 0.8660254037844386 };       // its slope, 30 degrees
static const real WALL = 2.2;                   // m, how far off a wall stands
static const int  EVERY = 40;                   // frames from one fall to the next
static const live_colour COLOUR[] = { LIVE_ORANGE, LIVE_GREEN, LIVE_GREY, LIVE_PURPLE, LIVE_RED };

static world room;
static shape kind[KINDS], sheet;
static bool is_ready, is_pinned[CORNERS];
static int pulled = -1, frame, next;
static vec3 pulled_to;

static int corner_of(int k)
{
    return (k & 1 ? SIDE - 1 : 0) + (k & 2 ? SIDE * (SIDE - 1) : 0);
}

// Where body b begins its fall: above the cloth, turned, in an order without chance.
static placement above(int b, real high)
{
    placement at = placement_at(vec3_make(0.3 * (b * 2 % 5 - 2), high, 0.2 * (b * 2 % 3 - 1) - 0.5));
    at.x = vec3_unit(vec3_make(1, 0.2 * (b % 4), 0.3 * (b % 3)));
    at.y = vec3_unit(vec3_cross(vec3_make(0.1 * b, 0.4, 1), at.x));
    at.z = vec3_cross(at.x, at.y);
    return at;
}

// The cloth: from side to side along x, down the slope along z.
static placement awning(void)
{
    placement at = placement_at(vec3_make(0, HIGH, -0.2));
    at.z = DOWN;
    at.y = vec3_cross(at.z, at.x);
    return at;
}

static status make_shapes(void)
{
    status done = shape_box(&kind[0], vec3_make(0.26, 0.26, 0.26), 1);
    if (done.ok) done = shape_icosahedron(&kind[1], 0.18, 1);
    if (done.ok) done = shape_sphere(&kind[2], 0.14, 1);
    if (done.ok) done = shape_capsule(&kind[3], 0.22, 0.1, 1);
    if (done.ok) done = shape_cloth(&sheet, SIDE, SIDE, WIDE, DEEP, 1.2, 0.4);
    return done;
}

static status add_all(void)
{
    static const vec3 NORMAL[] = { { 0, 1, 0 }, { 1, 0, 0 }, { -1, 0, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
    status done = make_shapes();
    for (int k = 0; k < 5 && done.ok; k++) done = world_add_plane(&room, NORMAL[k], k ? -WALL : 0);
    for (int b = 0; b < BODIES && done.ok; b++)
        done = world_add(&room, &kind[b % KINDS], above(b, 1.5 + 0.34 * b), NULL);
    if (done.ok) done = world_add(&room, &sheet, awning(), NULL);
    return done;
}

static void set_pin(int k, bool holds)
{
    if (holds == is_pinned[k]) return;
    is_pinned[k] = holds;
    if (holds) world_pin(&room, CLOTH, corner_of(k));
    else       world_unpin(&room, CLOTH, corner_of(k));
}

static void begin(void)
{
    if (is_ready) {
        world_free(&room);
        for (int k = 0; k < KINDS; k++) shape_free(&kind[k]);
        shape_free(&sheet);
    }
    world_options how = world_options_default();
    how.friction = 0.35;
    status done = world_init(&room, how);
    if (done.ok) done = add_all();
    is_ready = done.ok;
    pulled = -1;
    frame = next = 0;
    for (int k = 0; k < CORNERS; k++) is_pinned[k] = false;
    for (int k = 0; k < CORNERS && is_ready; k++) set_pin(k, true);
    if (!done.ok) live_say("%s", done.why);
}

// --- Hands ------------------------------------------------------------------------
static vec3 particle_at(int i)
{
    static vec3 at[SIDE * SIDE];
    world_vertices(&room, &room.body[CLOTH], at);
    return at[i];
}

static void move(int number, vec3 to)
{
    if (!is_ready || number != CLOTH) return;
    pulled_to = to;
    if (pulled >= 0) return;
    pulled = 0;
    for (int i = 1; i < sheet.particles; i++)
        if (vec3_distance(particle_at(i), to) < vec3_distance(particle_at(pulled), to)) pulled = i;
}

static void release(int number)
{
    if (number == CLOTH) pulled = -1;
}

// A body that is touched jumps; a pin is cut.
static void tap(int number, vec3 along)
{
    if (!is_ready || number == CLOTH) return;
    if (number > CLOTH) set_pin(number - CLOTH - 1, false);
    else live_world_hurry(&room, number, vec3_add(vec3_scale(3, along), vec3_make(0, 5, 0)));
}

// --- Frames -----------------------------------------------------------------------
// One after the other what lies on the floor falls once more.
static void lift(void)
{
    for (int k = 0; k < BODIES; k++) {
        int b = (next + k) % BODIES;
        if (b == live_held() || world_where(&room, b).position.y > 0.4) continue;
        world_put(&room, b, above(b, 2.9));
        next = b + 1;
        return;
    }
}

static void step(void)
{
    if (!is_ready) return;
    int held = live_held();
    if (held >= 0 && held < BODIES) live_world_pull(&room, held, 0);
    if (pulled >= 0) {
        vec3 dv = vec3_scale(10, vec3_sub(pulled_to, particle_at(pulled)));
        world_push_particle(&room, CLOTH, pulled, vec3_scale(8 * sheet.mass[pulled], dv));
    }
    if (frame > 240 && frame % EVERY == 0) lift();
    world_step(&room);
    frame++;
}

static void draw(void)
{
    for (int b = 0; b < BODIES && is_ready; b++) live_world_body(&room, b, COLOUR[b * 3 % 5]);
    if (!is_ready) return;
    live_world_body(&room, CLOTH, LIVE_BLUE);
    for (int k = 0; k < CORNERS; k++)
        if (is_pinned[k]) live_ball(CLOTH + 1 + k, LIVE_INK, particle_at(corner_of(k)), 0.03);
}

static unsigned long long hash(void)
{
    return is_ready ? world_hash(&room) : 0;
}

const live_figure figure = {
    .name = "canopy",
    .says = "Boxes, stones and balls fall on an awning of cloth, and roll off it",
    .camera = { .distance = 4.9, .turn = 0.5, .rise = 0.27, .target = { 0, 0.95, 0 }, .has_floor = true },
    .begin = begin, .step = step, .draw = draw, .hash = hash,
    .tap = tap, .move = move, .release = release,
};
