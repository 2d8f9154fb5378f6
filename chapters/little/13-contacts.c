//> little_spin_naive 13a 13a
// Turns the axes by h w x axis, and leaves the spin as it is.
static void body_move(body *b, real h)
{
    vec3 *column[3] = { &b->axes.x, &b->axes.y, &b->axes.z };
    b->position = vec3_add_scaled(b->position, h, b->velocity);
    for (int i = 0; i < 3; i++) {
        vec3 turn = vec3_cross(b->spin, *column[i]);
        *column[i] = vec3_add_scaled(*column[i], h, turn);
    }
    body_turn_inverse(b);
}
//<

//> little_momentum 13a
static vec3 body_angular_momentum(const body *b)
{
    vec3 own = mat3_back(b->axes, b->spin);
    own = mat3_apply(b->shape->inertia, own);
    return vec3_scale(1 / b->inverse_mass, mat3_apply(b->axes, own));
}
//<

//> little_body_speed 13g
// m/s, what no point of a body is faster than.
static real body_speed(const body *b)
{
    return vec3_length(b->velocity) + b->shape->radius * vec3_length(b->spin);
}
//<

//> little_body_move 13b
// Moves and turns; its angular momentum stays, so that its spin may change.
static void body_move(body *b, real h)
{
    vec3 momentum = body_angular_momentum(b);
    b->position = vec3_add_scaled(b->position, h, b->velocity);
    b->axes = mat3_turned(b->axes, vec3_scale(h, b->spin));
//<
//> little_body_move_path 13g
    b->path += h * body_speed(b);
//<
//> little_body_move_moved 18a
    b->moved += h * body_speed(b);
//<
//> little_body_move_end 13b
    body_turn_inverse(b);
    b->spin = mat3_apply(b->inverse, momentum);
    body_place(b);
}
//<

//> little_awake_all 13c 17z
static bool body_is_awake(const body *b) { return b->inverse_mass > 0; }
//<
//> little_awake 18a
static const real SLEEP_SPEED = 0.02;   // m/s
static real time_to_sleep = 0.5;        // s

static bool body_is_awake(const body *b)
{
    return b->inverse_mass > 0 && b->still <= time_to_sleep;
}
//<

//> little_push 13c
// m/s, of the end of an arm from the centre.
static vec3 body_velocity_at(const body *b, vec3 arm)
{
    return vec3_add(b->velocity, vec3_cross(b->spin, arm));
}

// An impulse of s p (kg m/s) at the end of an arm.
static void body_push(body *b, vec3 arm, real s, vec3 p)
{
    if (b->inverse_mass == 0) return;
    vec3 turn = mat3_apply(b->inverse, vec3_cross(arm, p));
    b->velocity = vec3_add_scaled(b->velocity, s * b->inverse_mass, p);
    b->spin = vec3_add_scaled(b->spin, s, turn);
}

// m/s along d, of the end of an arm, for an impulse of 1 along d there: one
// over the effective mass.
static real body_answer(const body *b, vec3 arm, vec3 d)
{
    if (b->inverse_mass == 0) return 0;
    vec3 t = vec3_cross(arm, d);
    return b->inverse_mass + vec3_dot(t, mat3_apply(b->inverse, t));
}
//<

//> little_contacts 13c
enum { CONTACTS = 8 * BODIES };
static contact contact_pool[2][CONTACTS], *contacts = contact_pool[0];
static int     contact_count;

// Arms, gaps and effective masses where the bodies are now.
static void contact_renew(contact *c)
{
    body *a = c->a, *b = c->b;
//<
//> little_renew_fresh 13g
    if (a->path + b->path < c->fresh) return;
    c->fresh = a->path + b->path + 1e-6;
//<
//> little_renew 13c
    for (contact_point *p = c->point; p < c->point + c->count; p++) {
        p->ra = mat3_apply(a->axes, p->local_a);
        p->rb = mat3_apply(b->axes, p->local_b);
        vec3 apart = vec3_add(vec3_sub(a->position, b->position),
                              vec3_sub(p->ra, p->rb));
        p->gap = vec3_dot(c->normal, apart);
        // What has slid apart meets half-way: one line of action for both.
        vec3 slid = vec3_add_scaled(apart, -p->gap, c->normal);
        p->ra = vec3_add_scaled(p->ra, -0.5, slid);
        p->rb = vec3_add_scaled(p->rb, 0.5, slid);
        p->mass = 1 / (body_answer(a, p->ra, c->normal)
                     + body_answer(b, p->rb, c->normal));
    }
}
//<

//> little_point_push 13c
// m/s, a's point as seen from b's.
static vec3 point_velocity(const contact *c, const contact_point *p)
{
    return vec3_sub(body_velocity_at(c->a, p->ra),
                    body_velocity_at(c->b, p->rb));
}

// An impulse on a, and the opposite one on b.
static void bodies_push(body *a, vec3 ra, body *b, vec3 rb, vec3 impulse)
{
    body_push(a, ra, 1, impulse);
    body_push(b, rb, -1, impulse);
}

// Gives what is missing to an impulse in sum.
static void point_push_to(const contact *c, contact_point *p, real impulse)
{
    if (impulse == p->push) return;
    vec3 more = vec3_scale(impulse - p->push, c->normal);
    bodies_push(c->a, p->ra, c->b, p->rb, more);
    p->push = impulse;
}
//<

//> little_rub 13c
static vec3 vec3_across(vec3 a, vec3 normal)
{
    return vec3_add_scaled(a, -vec3_dot(a, normal), normal);
}

// a, but no longer than so much.
static vec3 vec3_limit(vec3 a, real most)
{
    real length = vec3_length(a);
    return length > most ? vec3_scale(most / length, a) : a;
}

// Coulomb's law: friction stops sliding, by at most friction times the push.
static void point_rub(const contact *c, contact_point *p)
{
    vec3 slide = vec3_across(point_velocity(c, p), c->normal), old = p->rub;
    vec3 d = vec3_unit(slide);
    real most = c->friction * p->push;
    if (most == 0 && vec3_dot(old, old) == 0) return;
    real answer = body_answer(c->a, p->ra, d) + body_answer(c->b, p->rb, d);
    vec3 sum = vec3_add_scaled(old, -1 / answer, slide);
    p->rub = vec3_limit(vec3_across(sum, c->normal), most);
    bodies_push(c->a, p->ra, c->b, p->rb, vec3_sub(p->rub, old));
}
//<

//> little_press_hard 13c 13e
// What nears must stop, and a fifth of an overlap goes in a step.
static void contact_press(contact *c, real h)
{
    for (contact_point *p = c->point; p < c->point + c->count; p++) {
        real lack = vec3_dot(point_velocity(c, p), c->normal);
        lack += p->gap > 0 ? p->gap / h : 0.2 * p->gap / h;
        point_push_to(c, p, real_max(0, p->push - p->mass * lack));
    }
}
//<

//> little_soft 13f
// --- Soft contacts (Catto): springs as stiff as a step can follow ------------

// rate (1/s): of the overlap; mass: the share of the effective mass; leak: the
// share of the impulse that goes.
typedef struct { real rate, mass, leak; } softness;

// An eighth of a turn in a step, strongly damped.  stiffer: against what is
// static, where only one body can give way.
static softness soft_spring(real h, real stiffer)
{
    real omega = 2 * 3.14159265358979 * stiffer * 0.125 / h;
    real zeta = 10 / stiffer, a = 2 * zeta + h * omega, b = h * omega * a;
    return (softness){ omega / a, b / (1 + b), 1 / (1 + b) };
}

// The points of a hard impact disturb each other: again, until none was wrong
// by half a millimetre.
static void contact_press(contact *c, real h, softness s)
{
    real worst = 1;             // m
    for (int i = 0; i < 10 && worst > 0.0005; i++) {
        worst = 0;
        for (contact_point *p = c->point; p < c->point + c->count; p++) {
            real lack = vec3_dot(point_velocity(c, p), c->normal), leak = 0;
            real before = p->push;
            if (p->gap > 0) lack += p->gap / h;
            else if (s.rate > 0) {
                lack = s.mass * (lack + real_max(s.rate * p->gap, -3));
                leak = s.leak * p->push;
            }
            lack = p->mass * lack + leak;
            point_push_to(c, p, real_max(0, before - lack));
            worst = real_max(worst, h * fabs(p->push - before) / p->mass);
//<
//> little_press_pushed 15c
            if (p->push > 0) p->was_pushed = true;
//<
//> little_soft_end 13f
        }
    }
}
//<

//> little_warm 13e
// --- Contacts that remember --------------------------------------------------

static contact *before = contact_pool[1];

// Begins with the impulses of the step before.
static void contact_warm(const contact *c)
{
    for (const contact_point *p = c->point; p < c->point + c->count; p++)
        bodies_push(c->a, p->ra, c->b, p->rb,
                    vec3_add_scaled(p->rub, p->push, c->normal));
}
//<

//> little_inherit 13e
// A point keeps its impulses if it is where one was.
static void contact_inherit(contact *c, const contact *old)
{
    real near = 0.2 * real_min(c->a->shape->radius, c->b->shape->radius);
    for (contact_point *p = c->point; p < c->point + c->count; p++) {
        real best = near;
        for (int i = 0; i < old->count; i++) {
            const contact_point *q = &old->point[i];
            real d = vec3_distance(q->local_a, p->local_a);
            if (d >= best) continue;
            best = d;
            p->push = q->push;
            p->rub = q->rub;
        }
    }
}
//<

//> little_remember 13e
// The contact of the step before of these two, or NULL.
static const contact *contact_before(const body *a, const body *b)
{
    for (int i = a->first; i > 0; i = before[i - 1].next)
        if (before[i - 1].b == b) return &before[i - 1];
    return NULL;
}

// The contacts of this step become those before, in a list for each body a.
static void contacts_remember(void)
{
    contact *swap = before;
    before = contacts;
    contacts = swap;
    for (body *b = bodies; b < bodies + body_count; b++) b->first = 0;
    for (int i = 0; i < contact_count; i++) {
        before[i].next = before[i].a->first;
        before[i].a->first = i + 1;
    }
    contact_count = 0;
}
//<
