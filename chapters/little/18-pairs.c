//> little_meet_ahead 15b
// --- Fast bodies: when will they touch? --------------------------------------

// A contact as it will be at the moment of touch, with the gap until then.
// Conservative advancement: a goes on as far as the distance allows, and asks
// again, until it is nearer than half the margin.
static void contact_meet_ahead(contact *c, real dt)
{
    body *a = c->a, was = *a;
    vec3 way = vec3_scale(dt, vec3_sub(a->velocity, c->b->velocity));
    real left = 1;              // of the way
    simplex s = { .count = 0 };
    for (int i = 0; i < 40 && vec3_length(way) > c->reach; i++) {
        real d = gjk(body_hull(a), body_hull(c->b), &s, HUGE_VAL);
        if (d < MARGIN / 2) {
            contact_meet(c);
            c->until = 0;
            break;
        }
        real closing = -vec3_dot(way, s.v) / d;
        if (closing * left <= d - MARGIN / 2) break;
        real t = (d - MARGIN / 4) / closing;
        left -= t;
        a->position = vec3_add_scaled(a->position, t, way);
        body_place(a);
    }
    *a = was;
}
//<

//> little_pair_head 13c
// --- Pairs -------------------------------------------------------------------

static long asked;              // how often two bodies were asked
//<
//> little_pairs_compared 14a
static long compared;           // and how often their spheres or boxes
//<
//> little_pair 13c

static void pair_ask(body *a, body *b, real dt)
{
    if (contact_count == CONTACTS || (a->inverse_mass + b->inverse_mass == 0))
        return;
//<
//> little_pair_joined 17a
    if (bodies_joined(a, b)) return;
//<
//> little_pair_new 13c
    contact *c = &contacts[contact_count];
//<
//> little_pair_old 13e
    const contact *old = contact_before(a, b);
//<
//> little_pair_kept 14c 17z
    if (old && a->path + b->path < old->until) {
        *c = *old;              // its margin is not used up
        contact_count++;
        return;
    }
//<
//> little_pair_asleep 18a
    bool asleep = !body_is_awake(a) && !body_is_awake(b);
    if (old && (asleep || a->path + b->path < old->until)) {
        *c = *old;              // its margin is not used up
        contact_count++;
        return;
    }
//<
//> little_pair_ask 13c
    *c = (contact){ .a = a, .b = b, .reach = MARGIN };
    asked++;
//<
//> little_pair_meet_now 13c 14b
    if (!contact_meet(c)) return;
//<
//> little_pair_meet_kept 14c 15a
    contact_meet(c);            // also kept if they do not touch
//<
//> little_pair_meet_ahead 15b
    real way = dt * (body_speed(a) + body_speed(b));
    real thick = real_min(a->shape->inner, b->shape->inner);
    c->reach = MARGIN + real_min(way, 0.5 * thick);
    if (!contact_meet(c)) contact_meet_ahead(c, dt);
//<
//> little_pair_inherit 13e
    if (old) contact_inherit(c, old);
//<
//> little_pair_dt 13c 15a
    (void)dt;
//<
//> little_pair_end 13c
    contact_count++;
}
//<

//> little_find_every_pair 13c 13z 14a 14a
// Compares every body with every other.
static void contacts_find(real dt)
{
//<
//> little_find_forgets 13c 13d
    contact_count = 0;
//<
//> little_find_remembers 13e 14a
    contacts_remember();
//<
//> little_find_pairs 13c 14a
    for (body *a = bodies; a < bodies + body_count; a++)
        for (body *b = bodies; b < a; b++) {
            real near = a->shape->radius + b->shape->radius + MARGIN;
//<
//> little_find_counts 14a 14a
            compared++;
//<
//> little_find_end 13c 14a
            if (vec3_distance(a->position, b->position) < near)
                pair_ask(a, b, dt);
        }
}
//<

//> little_boxes 14b
// --- Boxes: sort and sweep ---------------------------------------------------

typedef struct { vec3 low, high; int of; } box;     // m; number `of` is in it
typedef struct { int a, b; } pair;                  // a > b

static vec3 vec3_min(vec3 a, vec3 b)
{
    return vec3_make(real_min(a.x, b.x), real_min(a.y, b.y),
                     real_min(a.z, b.z));
}

static vec3 vec3_max(vec3 a, vec3 b)
{
    return vec3_make(real_max(a.x, b.x), real_max(a.y, b.y),
                     real_max(a.z, b.z));
}

// Around n points, and `margin` (m) more on every side.
static box box_around(const vec3 *at, int n, real margin, int of)
{
    vec3 more = { margin, margin, margin };
    box b = { at[0], at[0], of };
    for (int i = 1; i < n; i++) {
        b.low = vec3_min(b.low, at[i]);
        b.high = vec3_max(b.high, at[i]);
    }
    return (box){ vec3_sub(b.low, more), vec3_add(b.high, more), of };
}

// Are they further apart than so much (m)?
static bool boxes_apart(const box *a, const box *b, real by)
{
    return a->low.z > b->high.z + by || b->low.z > a->high.z + by
        || a->low.y > b->high.y + by || b->low.y > a->high.y + by
        || a->low.x > b->high.x + by || b->low.x > a->high.x + by;
}
//<

//> little_boxes_sort 14b
// By their left ends, by insertion: the order of the last time is nearly right.
static void boxes_sort(box *list, int n)
{
    for (int i = 1; i < n; i++) {
        box b = list[i];
        int j = i;
        for (; j > 0 && list[j - 1].low.x > b.low.x; j--) list[j] = list[j - 1];
        list[j] = b;
    }
}
//<

//> little_boxes_sweep 14b
enum { PAIRS = 400000 };
static pair pairs[PAIRS];

// Which boxes overlap?  One can only meet those that begin before it ends.
static int boxes_sweep(box *list, int n)
{
    int count = 0;
    boxes_sort(list, n);
    for (const box *a = list; a < list + n; a++) {
        const box *b = a + 1;
        for (; b < list + n && b->low.x <= a->high.x; b++)
            if (!boxes_apart(a, b, 0) && count < PAIRS)
                pairs[count++] = a->of > b->of ? (pair){ a->of, b->of }
                                               : (pair){ b->of, a->of };
        compared += b - a - 1;
    }
    return count;
}
//<

//> little_box_of_body 14b
static box boxes[BODIES];       // of all bodies, sorted
static int boxed;               // how many they are

// Around a body, as far as it gets in dt, and half the margin more.
static box body_box(int i, real dt)
{
    const body *b = &bodies[i];
    real more = MARGIN / 2 + dt * vec3_length(b->velocity);
    return box_around(b->vertex, b->shape->count, more, i);
}

static void contacts_find(real dt)
{
    contacts_remember();
    for (; boxed < body_count; boxed++) boxes[boxed].of = boxed;
    for (int i = 0; i < boxed; i++) boxes[i] = body_box(boxes[i].of, dt);
    int n = boxes_sweep(boxes, boxed);
    for (int i = 0; i < n; i++)
        pair_ask(&bodies[pairs[i].a], &bodies[pairs[i].b], dt);
}
//<

//> little_sleep_clock 18a
// --- Sleep: what touches or is joined falls asleep together ------------------

// Of two that touch, neither has been still for longer than the other.
static void still_share(body *a, body *b)
{
    if (a->inverse_mass > 0 && b->inverse_mass > 0)
        a->still = b->still = real_min(a->still, b->still);
}
//<

//> little_bodies_sleep 18a
// An island has been still for as long as the body in it that moved last.
static void bodies_sleep(real dt)
{
    for (body *b = bodies; b < bodies + body_count; b++) {
        b->still = b->moved < SLEEP_SPEED * dt ? b->still + dt : 0;
        b->moved = 0;
    }
    for (contact *c = contacts; c < contacts + contact_count; c++)
        if (c->count > 0) still_share(c->a, c->b);
    for (joint *j = joints; j < joints + joint_count; j++)
        still_share(j->a, j->b);
    for (body *b = bodies; b < bodies + body_count; b++)
        if (!body_is_awake(b)) b->velocity = b->spin = vec3_make(0, 0, 0);
}
//<
