//> little_awake_all 13c 17z
static bool body_is_awake(const body *b) { return b->inverse_mass > 0; }
//<
//> little_awake 18a
static bool body_is_awake(const body *b) { return b->awake; }
//<

//> little_impact 15b
// --- Fast bodies: when will they touch? --------------------------------------

// As far as two come nearer in a step, but not as far as they are thick.
static real pair_reach(const body *a, const body *b, real dt)
{
    real turning = a->shape->radius * vec3_length(a->spin)
                 + b->shape->radius * vec3_length(b->spin);
    real way = dt * (vec3_distance(a->velocity, b->velocity) + turning);
    real thick = real_min(a->shape->inner, b->shape->inner);
    return MARGIN + real_min(way, 0.5 * thick);
}
//<

//> little_time_of_impact 15b
// The share of the step until a is nearer to b than half the margin, if it
// goes on by `way`; 1: it does not come so near.  Conservative advancement: as
// far as the distance allows, and asks again.
static real time_of_impact(const body *a, const body *b, vec3 way)
{
    vec3 at[VERTICES];
    real t = 0;
    simplex s = { .count = 0 };
    for (int i = 0; i < 40; i++) {
        for (int k = 0; k < a->shape->count; k++)
            at[k] = vec3_add_scaled(a->vertex[k], t, way);
        real d = gjk((hull){ at, a->shape->count }, body_hull(b), &s, HUGE_VAL);
        if (d < MARGIN / 2) return t;
        real closing = -vec3_dot(way, s.v) / d;
        if (closing * (1 - t) <= d - MARGIN / 2) return 1;
        t += (d - MARGIN / 4) / closing;
    }
    return t;
}
//<

//> little_meet_ahead 15b
// A contact as it will be at the moment of touch, with the gap until then.
static void contact_meet_ahead(contact *c, real dt)
{
    body *a = c->a, was = *a;
    vec3 way = vec3_scale(dt, vec3_sub(a->velocity, c->b->velocity));
    real thick = real_min(a->shape->inner, c->b->shape->inner);
    if (vec3_length(way) < 0.5 * thick) return;
    real t = time_of_impact(a, c->b, way);
    if (t >= 1) return;
    a->position = vec3_add_scaled(a->position, t, way);
    body_place(a);
    contact_meet(c);
    *a = was;
    c->until = 0;
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
    int k = *table_place(a, b);
    const contact *old = k ? &before[k - 1] : NULL;
//<
//> little_pair_kept 14c 17z
    // What was asked with a margin is asked again when that is used up.
    if (old && a->path + b->path < old->until) {
        *c = *old;
        contact_count++;
        return;
    }
//<
//> little_pair_asleep 18a
    // What was asked with a margin is asked again when that is used up.
    bool asleep = !a->awake && !b->awake;
    if (old && (asleep || a->path + b->path < old->until)) {
        *c = *old;
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
    c->reach = pair_reach(a, b, dt);
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

static bool boxes_apart(vec3 low, vec3 high, vec3 low2, vec3 high2)
{
    return low.x > high2.x || low2.x > high.x || low.y > high2.y
        || low2.y > high.y || low.z > high2.z || low2.z > high.z;
}
//<

//> little_box_of_body 14b
// The box around a body, around its motion, and half the margin more.
static void body_bound(body *b, real dt)
{
    vec3 none = { 0, 0, 0 }, way = vec3_scale(dt, b->velocity);
    vec3 margin = vec3_make(MARGIN / 2, MARGIN / 2, MARGIN / 2);
    b->low = b->high = b->vertex[0];
    for (int i = 1; i < b->shape->count; i++) {
        b->low = vec3_min(b->low, b->vertex[i]);
        b->high = vec3_max(b->high, b->vertex[i]);
    }
    b->low = vec3_add(vec3_sub(b->low, margin), vec3_min(way, none));
    b->high = vec3_add(vec3_add(b->high, margin), vec3_max(way, none));
}
//<

//> little_boxes_order 14b
static body *order[BODIES];     // by the left ends of their boxes
static int   ordered;

// Sorted by insertion: the order of the last step is nearly right.
static void bodies_order(void)
{
    if (ordered > body_count) ordered = 0;
    for (; ordered < body_count; ordered++) order[ordered] = &bodies[ordered];
    for (int i = 1; i < body_count; i++)
        for (int j = i; j > 0 && order[j]->low.x < order[j - 1]->low.x; j--) {
            body *swap = order[j];
            order[j] = order[j - 1];
            order[j - 1] = swap;
        }
}
//<

//> little_boxes_sweep 14b
// Sort and sweep: a box can only meet those that begin before it ends.
static void contacts_find(real dt)
{
    contacts_remember();
    for (body *b = bodies; b < bodies + body_count; b++) body_bound(b, dt);
    bodies_order();
    for (int i = 0; i < body_count; i++)
        for (int j = i + 1; j < body_count; j++) {
            body *a = order[i], *b = order[j];
            if (b->low.x > a->high.x) break;
            compared++;
            if (boxes_apart(a->low, a->high, b->low, b->high)) continue;
            if (a > b) pair_ask(a, b, dt);
            else pair_ask(b, a, dt);
        }
}
//<

//> little_islands 18a
// --- Sleep: what touches or is joined falls asleep together ------------------

static int island_root(int i)
{
    while (bodies[i].island != i) {
        bodies[i].island = bodies[bodies[i].island].island;
        i = bodies[i].island;
    }
    return i;
}

static void islands_unite(const body *a, const body *b)
{
    if (a->inverse_mass == 0 || b->inverse_mass == 0) return;
    int i = island_root((int)(a - bodies)), j = island_root((int)(b - bodies));
    bodies[i].island = j;
}
//<

//> little_islands_wake 18a
// An island is awake if one of its bodies is.
static void islands_wake(void)
{
    static bool awake[BODIES];
    for (int i = 0; i < body_count; i++) {
        bodies[i].island = i;
        awake[i] = false;
    }
    for (contact *c = contacts; c < contacts + contact_count; c++)
        if (c->count > 0) islands_unite(c->a, c->b);
    for (joint *j = joints; j < joints + joint_count; j++)
        islands_unite(j->a, j->b);
    for (int i = 0; i < body_count; i++)
        if (bodies[i].awake) awake[island_root(i)] = true;
    for (int i = 0; i < body_count; i++) {
        body *b = &bodies[i];
        if (b->awake || b->inverse_mass == 0 || !awake[island_root(i)])
            continue;
        b->awake = true;
        b->still = 0;
    }
}
//<

//> little_islands_sleep 18a
static const real SLEEP_SPEED = 0.02;   // m/s
static real time_to_sleep = 0.5;        // s

static void islands_sleep(real dt)
{
    static real still[BODIES];
    for (int i = 0; i < body_count; i++) {
        body *b = &bodies[i];
        still[i] = HUGE_VAL;
        b->still = b->moved < SLEEP_SPEED * dt ? b->still + dt : 0;
    }
    for (int i = 0; i < body_count; i++) {
        real *s = &still[island_root(i)];
        if (bodies[i].awake) *s = real_min(*s, bodies[i].still);
    }
    for (int i = 0; i < body_count; i++) {
        body *b = &bodies[i];
        if (!b->awake || still[island_root(i)] <= time_to_sleep) continue;
        b->awake = false;
        b->velocity = b->spin = vec3_make(0, 0, 0);
    }
}
//<
