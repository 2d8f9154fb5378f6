//> face-walk-head
//>   A character walks by asking. The engine knows nothing of it.
#include "inside.h"

#include <math.h>

// Of its radius, how far it keeps away from all things: what it touched would
// stop it at once (tumble_world_sweep).  A cast is exact to 1e-12 of the way and
// the sizes, so any share that is larger will do; before a step as high as its
// radius it stands still if it goes by less than that in a call.
static const real APART = 1e-5;

// Of its radius, the rounding of a height, and of 1, that of a slope, likewise.
static const real SMALL = 1e-6;

// Of its radius, how far behind an edge there must be ground: edges that are
// rounded or cut off by less are edges, and ledges that are narrower are none.
static const real BEHIND = 0.1;

enum {
    BENDS = 5,          // walls that one way turns at, at most
    PUSHES = 8        // times that it is pushed out of something, at most
};

typedef struct {
    const tumble_world *w;
    const tumble_walker *how;
    vec3 up;            // unit
    real apart;         // m
    real level;         // the cosine of the steepest slope
    vec3 at;            // m
    real height;        // m, along up, of what it stood on when it began
    tumble_hit ground;  // what it stands on
    bool stands;
} walk;
//<

//> face-walk-go
//>   It goes until a little before what it meets: at a flat wall so far before that it
//>   is `apart` from it, whichever way it came.
// Its middle segment, at k->at.
static rounded capsule_of(const walk *k, vec3 end[2])
{
    real half = k->how->length / 2;
    end[0] = vec3_add_scaled(k->at, -half, k->up);
    end[1] = vec3_add_scaled(k->at, half, k->up);
    return (rounded){ { end, 2 }, k->how->radius, 0 };
}

// False: it went all of the way.  Else *left is what is left of it, 0 to 1.
static bool move_until_hit(walk *k, vec3 delta, real *left, tumble_hit *hit)
{
    vec3 end[2];
    real length = vec3_length(delta), ahead = length + 2 * k->apart;
    *left = 0;
    if (!(length > 0)) return false;
    vec3 along = vec3_scale(1 / length, delta);
    real stop = length;
    if (inside_sweep(k->w, capsule_of(k, end), vec3_scale(ahead, along),
                     k->how->mask, hit)) {
        real nears = -vec3_dot(along, from_user(hit->normal));
        real before = nears > 0 ? k->apart / nears : length;
        stop = real_max(0, hit->fraction * ahead - before);
    }
    bool is_met = stop < length;
    k->at = vec3_add_scaled(k->at, is_met ? stop : length, along);
    *left = is_met ? (length - stop) / length : 0;
    return is_met;
}

// What came into it pushes it out.
static void push_out(walk *k)
{
    vec3 end[2];
    tumble_hit h;
    for (int i = 0; i < PUSHES; i++) {
        if (!inside_near(k->w, capsule_of(k, end), k->apart, k->how->mask, &h)
            || h.fraction >= k->apart * (1 - SMALL)) return;
        k->at = vec3_add_scaled(k->at, k->apart - h.fraction,
                                from_user(h.normal));
    }
}
//<

//> face-walk-along
//>   Of a way, what leads into a wall is taken away. If the rest leads into another
//>   wall, only the edge between the two is left, and in a corner of three nothing.
//>   It is always the way that was wanted: one that a wall has turned already would be
//>   turned back by the next, and jitter in corners.
static bool leads_out(vec3 delta, const vec3 *wall, int walls)
{
    real rounding = 1e-9 * vec3_length(delta);
    for (int i = 0; i < walls; i++)
        if (vec3_dot(delta, wall[i]) < -rounding) return false;
    return true;
}

static vec3 slide_along(vec3 delta, const vec3 *wall, int walls)
{
    if (leads_out(delta, wall, walls)) return delta;
    for (int i = 0; i < walls; i++) {
        vec3 v = vec3_add_scaled(delta, -vec3_dot(delta, wall[i]), wall[i]);
        if (vec3_dot(delta, wall[i]) < 0 && leads_out(v, wall, walls)) return v;
    }
    for (int i = 1; i < walls; i++)
        for (int m = 0; m < i; m++) {
            vec3 edge = vec3_cross(wall[i], wall[m]);
            real square = vec3_length_squared(edge);
            if (!(square > 0)) continue;
            vec3 v = vec3_scale(vec3_dot(delta, edge) / square, edge);
            if (leads_out(v, wall, walls)) return v;
        }
    return (vec3){ 0, 0, 0 };
}
//<

//> face-walk-level
//>   On the level every wall stands upright, however it leans, and ground that is not
//>   too steep lifts the way without making it shorter.
// The part of v that is level.
static vec3 level_part(const walk *k, vec3 v)
{
    return vec3_add_scaled(v, -vec3_dot(v, k->up), k->up);
}

static vec3 lifted(const walk *k, vec3 delta, const vec3 *ground, int grounds)
{
    real lift = 0;
    for (int i = 0; i < grounds; i++)
        lift = real_max(lift, -vec3_dot(delta, ground[i])
                        / vec3_dot(k->up, ground[i]));
    return vec3_add_scaled(delta, lift, k->up);
}

// Goes a level way; false: it did not go all of it.
static bool move_level(walk *k, vec3 delta)
{
    vec3 wall[BENDS], ground[BENDS];
    int walls = 0, grounds = 0;
    for (int i = 0; i < BENDS; i++) {
        tumble_hit h;
        real left;
        vec3 v = slide_along(delta, wall, walls);
        v = lifted(k, v, ground, grounds);
        if (!move_until_hit(k, v, &left, &h)) return walls == 0;
        delta = vec3_scale(left, delta);
        vec3 n = from_user(h.normal), upright = level_part(k, n);
        real length = vec3_length(upright);
        if (vec3_dot(n, k->up) >= k->level) {
            ground[grounds++] = n;
            continue;
        }
        // A ceiling over a slope stops it.
        if (!(length > SMALL)) upright = vec3_scale(-1, delta);
        wall[walls++] = vec3_unit(upright);
    }
    return false;
}
//<

//> face-walk-ground
//>   What it comes down on bears it if it is not too steep. A round foot on the edge
//>   of a step touches that with any normal. So an edge bears if what lies behind it
//>   does, and if it is no higher above the foot than a step.
static real foot_height(const walk *k)
{
    return vec3_dot(k->at, k->up) - k->how->length / 2 - k->how->radius
         - k->apart;
}

static bool is_level(const walk *k, const tumble_hit *h)
{
    return vec3_dot(from_user(h->normal), k->up) >= k->level;
}

static bool supports(const walk *k, const tumble_hit *h, real highest)
{
    vec3 n = from_user(h->normal), p = from_user(h->point);
    real rise = vec3_dot(p, k->up) - foot_height(k), r = k->how->radius;
    tumble_hit top;
    if (is_level(k, h)) return true;
    if (!(vec3_dot(n, k->up) > 0 && rise <= highest + SMALL * r)) return false;
    vec3 in = vec3_unit(level_part(k, n));
    vec3 over = vec3_add_scaled(vec3_add_scaled(p, -BEHIND * r, in), r, k->up);
    vec3 under = vec3_add_scaled(over, -(1 + BEHIND) * r, k->up);
    return tumble_world_ray(k->w, to_user(over), to_user(under), k->how->mask, &top)
        && top.fraction > 0 && is_level(k, &top);
}

// Comes down by so much (m) at most, if there is ground that bears it, and no higher
// above what it stood on than a step.  Its foot hung below that by `below` (m).
static bool land(walk *k, real most, real below)
{
    vec3 from = k->at;
    tumble_hit h;
    real left, highest = k->height + k->how->step + SMALL * k->how->radius;
    k->stands = move_until_hit(k, vec3_scale(-most, k->up), &left, &h)
             && supports(k, &h, k->how->step + below)
             && vec3_dot(from_user(h.point), k->up) <= highest;
    if (k->stands)  k->ground = h;
    else            k->at = from;
    return k->stands;
}
//<

//> face-walk-step
//>   Before a wall it tries the way once more from a step higher. If it gets further
//>   so, and comes down on ground, that is where it goes.
static void tread(walk *k, vec3 delta)
{
    walk over = *k;
    vec3 from = k->at;
    tumble_hit h;
    real left, step = k->how->step, below = k->height - foot_height(k);
    bool is_free = move_level(k, delta);
    land(k, step + k->apart, 0);
    if (is_free || !(step > 0)) return;
    move_until_hit(&over, vec3_scale(step + below, k->up), &left, &h);
    move_level(&over, delta);
    real further = vec3_dot(vec3_sub(over.at, k->at), delta);
    if (!(further > SMALL * vec3_length_squared(delta))) return;
    real raised = vec3_dot(vec3_sub(over.at, from), k->up);
    if (land(&over, raised + step + k->apart, below)) *k = over;
}

// Goes through the air, until there is ground.
static void fly(walk *k, vec3 delta)
{
    vec3 wall[BENDS];
    for (int walls = 0; walls < BENDS; walls++) {
        tumble_hit h;
        real left;
        if (!move_until_hit(k, slide_along(delta, wall, walls), &left, &h)) return;
        if (vec3_dot(delta, k->up) < 0 && supports(k, &h, k->how->step)) {
            k->ground = h;
            k->stands = true;
            return;
        }
        wall[walls] = from_user(h.normal);
        delta = vec3_scale(left, delta);
    }
}
//<

//> face-walk
//>   The ground that it stood on carries it by its pose, so on a turntable it goes
//>   round in a circle.
tumble_walker tumble_walker_capsule(double length, double radius)
{
    return (tumble_walker){ .length = length, .radius = radius,
                            .up = { 0, 1, 0 }, .step = radius,
                            .slope = JOINT_HALF_TURN / 4, .mask = ~0u };
}

static bool begin_walk(walk *k, const tumble_world *w,
                       const tumble_walker *how, const tumble_walk *from, vec3 delta)
{
    const tumble_vec3 x = { 1, 0, 0 };
    real up = vec3_length(from_user(how->up));
    real c = tumble_quat_turn(x, how->slope).w;     // of half of it
    bool is_size = how->length >= 0 && how->length < HUGE_VAL
                && how->radius > 0 && how->radius < HUGE_VAL
                && how->step >= 0 && how->step < HUGE_VAL;
    bool is_turn = how->slope >= 0 && 2 * how->slope < JOINT_HALF_TURN
                && up > 0 && up < HUGE_VAL;
    if (!w || !is_size || !is_turn || !vec3_is_finite(delta)
        || !vec3_is_finite(from_user(from->position))
        || !vec3_is_finite(from_user(from->point))
        || !vec3_is_finite(from_user(from->foot))) return false;
    *k = (walk){ .w = w, .how = how, .at = from_user(from->position),
                 .up = vec3_scale(1 / up, from_user(how->up)),
                 .apart = APART * how->radius };
    k->level = real_max(2 * c * c - 1 - SMALL, SMALL);
    return true;
}

// What it stood on, as it is now, has moved by so much (m).
static vec3 carried(const walk *k, const tumble_walk *from)
{
    if (!inside_body_of(k->w, from->ground)) return (vec3){ 0, 0, 0 };
    tumble_pose now = tumble_body_pose(k->w, from->ground);
    return vec3_sub(from_user(tumble_pose_to_world(now, from->foot)),
                    from_user(from->point));
}

static tumble_walk walk_result(const walk *k)
{
    tumble_walk x = { .position = to_user(k->at), .stands = k->stands };
    if (!k->stands) return x;
    tumble_body b = k->ground.body;
    tumble_pose now = tumble_body_pose(k->w, b);
    vec3 arm = vec3_sub(from_user(k->ground.point), from_user(now.position));
    vec3 turns = vec3_cross(from_user(tumble_body_spin(k->w, b)), arm);
    x.ground = b;
    x.point = k->ground.point;
    x.foot = tumble_pose_to_local(now, x.point);
    x.normal = k->ground.normal;
    x.velocity = to_user(vec3_add(from_user(tumble_body_velocity(k->w, b)),
                                  turns));
    return x;
}

bool tumble_world_walk(const tumble_world *w, tumble_walker how,
                       tumble_walk from, tumble_vec3 delta, tumble_walk *to)
{
    walk k;
    vec3 v = from_user(delta);
    if (!begin_walk(&k, w, &how, &from, v)) return false;
    real rise = vec3_dot(v, k.up);
    vec3 up = vec3_scale(rise, k.up), flat = vec3_sub(v, up);
    vec3 rides = from.stands ? carried(&k, &from) : (vec3){ 0, 0, 0 };
    k.at = vec3_add(k.at, rides);
    push_out(&k);
    k.height = vec3_dot(vec3_add(from_user(from.point), rides), k.up);
    if (from.stands) {
        tread(&k, flat);
    } else {
        if (rise > 0) fly(&k, up);
        move_level(&k, flat);
    }
    if (!k.stands && rise < 0) fly(&k, up);
    push_out(&k);
    if (!vec3_is_finite(k.at)) return false;
    if (to) *to = walk_result(&k);
    return true;
}
//<
