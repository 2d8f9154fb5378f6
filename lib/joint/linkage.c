//> linkage-add
//>   Joints come and go between frames. The place of one that has gone is used
//>   again: a program may add and remove joints for hours, and needs no more
//>   memory. Joined bodies are taken out of the list of pairs that may meet.
#include "linkage.h"
#include "actuator.h"
#include "inline.h"
#include "table.h"

#include <assert.h>

void linkage_free(linkage *l)
{
    void *owned[] = { l->joint, l->rows, l->role, l->step, l->group, l->order,
                      l->reach, l->block, l->body, l->apart, l->tied };
    for (size_t i = 0; i < sizeof owned / sizeof *owned; i++) free(owned[i]);
    *l = (linkage){ .count = 0 };
}

static bool make_joint_room(linkage *l, const joint *j)
{
    int n = l->count, room = table_room(n + 1, l->capacity);
    int need = 1 + int_max(j->a, j->b), bodies = table_room(need, l->bodies);
    bool ok = TABLE_ADD(l->tied, l->ties, l->tie_room);
    if (room > l->capacity) {
        TABLE_GROW(ok, l->joint, n, room);
        TABLE_GROW(ok, l->rows, n, room);
        TABLE_GROW(ok, l->role, n, room);
        TABLE_GROW(ok, l->step, n, room);
        TABLE_GROW(ok, l->group, n, room);
        TABLE_GROW(ok, l->apart, n, room);
        if (ok) l->capacity = room;
    }
    if (bodies > l->bodies) {
        TABLE_GROW(ok, l->body, l->bodies, bodies);
        TABLE_GROW(ok, l->order, l->bodies, bodies);
        if (ok) l->bodies = bodies;
    }
    return ok;
}

// A joint that is added brings one more at most.
static body_tie *tie_of(linkage *l, int soft, int rigid)
{
    int k = 0;
    while (k < l->ties
           && (l->tied[k].soft != soft || l->tied[k].rigid != rigid)) k++;
    if (k == l->ties) l->tied[l->ties++] = (body_tie){ soft, rigid, 0 };
    return &l->tied[k];
}

void linkage_count_pins(linkage *l)
{
    for (int k = 0; k < l->ties; k++) l->tied[k].pins = 0;
    for (int k = 0; k < l->count; k++) {
        const joint *j = &l->joint[k];
        if (j->kind != JOINT_PIN || !joint_holds(j) || j->may_touch || j->b < 0)
            continue;
        tie_of(l, j->a, j->b)->pins++;
    }
}

void linkage_untie(linkage *l, int k)
{
    assert(k >= 0 && k < l->ties && l->tied[k].pins == 0);
    l->tied[k] = l->tied[--l->ties];
}

void linkage_untie_body(linkage *l, int b)
{
    for (int k = l->ties - 1; k >= 0; k--)
        if (l->tied[k].soft == b || l->tied[k].rigid == b) linkage_untie(l, k);
}

// The place of a joint that has gone, if there is one.
static int free_joint(const linkage *l)
{
    int k = l->gone > 0 ? 0 : l->count;
    while (k < l->count && l->joint[k].kind != JOINT_NONE) k++;
    return k;
}

// Its body is joined in the next frame, from its begin.
static void mark_joined(linkage *l, int b)
{
    if (b < 0) return;
    l->body[b].seen = l->frames + 1;
    l->body[b].stiff = 0;
}

status linkage_add(linkage *l, const joint *j, int *number)
{
    if (!make_joint_room(l, j)) return status_out_of_memory();
    int k = free_joint(l);
    if (k < l->count)   l->gone--;
    else                l->count++;
    if (number) *number = k;
    l->joint[k] = *j;
    l->rows[k] = (joint_rows){ .count = 0 };
    l->role[k] = JOINT_IDLE;
    mark_joined(l, j->a);
    mark_joined(l, j->b);
    if (j->kind == JOINT_PIN) linkage_count_pins(l);
    return status_ok();
}

void linkage_remove(linkage *l, int number)
{
    assert(number >= 0 && number < l->count);
    assert(l->joint[number].kind != JOINT_NONE);
    bool was_pin = l->joint[number].kind == JOINT_PIN;
    l->joint[number] = (joint){ .kind = JOINT_NONE };
    l->role[number] = JOINT_IDLE;
    l->gone++;
    if (was_pin) linkage_count_pins(l);
}

// A pair of bodies as one number, the smaller one first.
static long long key_of(int a, int b)
{
    return int_min(a, b) * (1LL << 32) + int_max(a, b);
}

static int compare_keys(const void *x, const void *y)
{
    long long a = *(const long long *)x, b = *(const long long *)y;
    return (a > b) - (a < b);
}

void linkage_find_apart(linkage *l)
{
    l->aparts = 0;
    for (int k = 0; k < l->count; k++)
        if (joint_holds(&l->joint[k]) && !l->joint[k].may_touch)
            l->apart[l->aparts++] = key_of(l->joint[k].a, l->joint[k].b);
    if (l->aparts > 0)
        qsort(l->apart, (size_t)l->aparts, sizeof *l->apart, compare_keys);
}

bool linkage_keeps_apart(const linkage *l, int a, int b)
{
    long long key = key_of(a, b);
    return l->aparts > 0 && bsearch(&key, l->apart, (size_t)l->aparts,
                                    sizeof key, compare_keys);
}
//<

//> linkage-sides
//>   Where do bodies stand now, and where will they be at the end of the
//>   substep? Where they freely come with the velocity that they have by now.
static const motion_basis *basis_of(const solver_frame *f, int b)
{
    return b < 0 ? &MOTION_IMMOVABLE : &f->body[b].basis;
}

static bool moves(const solver_frame *f, int b)
{
    return basis_of(f, b)->inverse_mass > 0;
}

// What is driven goes its way, whatever pulls it.
static bool yields(const solver_frame *f, int b)
{
    return moves(f, b) && !f->body[b].is_driven;
}

// The one of its bodies that yields.
static int yielding(const solver_frame *f, const joint *j)
{
    return yields(f, j->a) ? j->a : j->b;
}

static const rigid_frame *joined_frame(const linkage_pass *q, int b)
{
    return b < 0 ? &JOINT_WORLD : &q->f->body[b].frame;
}

// A body that has been displaced, too, goes on for h (s).  Every impulse that
// it got in this substep acts from its begin: so what joints give is a step of
// its own motion, and takes no energy.
static void advance_shifted(solver_body *x, motion *u, const motion *moved, real h)
{
    motion d;
    if (motion_is_some(moved)) motion_displace(&x->frame, &x->basis, u, moved);
    for (int i = 0; i < MOTIONS; i++) d.of[i] = h * u->of[i];
    if (x->is_driven) x->frame = motion_frame(&x->frame, &x->basis, &d);
    else              motion_advance(&x->frame, &x->basis, u, h);
}

// Is it where it was when this was last asked?
static bool find_end(linkage *l, const linkage_pass *q, int b)
{
    if (!moves(q->f, b)) return true;
    linkage_body *x = &l->body[b];
    const motion *now = &q->velocity[b];
    if (x->has_end && memcmp(&x->last, now, sizeof x->last) == 0) return true;
    x->has_end = true;
    x->last = x->go = *now;
    x->end = q->f->body[b];
    advance_shifted(&x->end, &x->go, &q->moved[b], q->f->h);
    return false;
}

// Where its joints bring it; after a jolt it goes as without them.
void linkage_advance(linkage *l, const linkage_pass *q, int b, solver_body *now)
{
    linkage_body *x = &l->body[b];
    find_end(l, q, b);
    *now = x->end;
    q->velocity[b] = x->is_jolted ? x->rest : x->go;
    for (int t = 0; t < TURNS && x->is_jolted; t++)
        q->velocity[b].of[MOTION_TURN + t] = vec3_dot(now->basis.turn[t],
                                                      x->angular);
}

static const rigid_frame *end_of(const linkage *l, const linkage_pass *q, int b)
{
    return moves(q->f, b) ? &l->body[b].end.frame : joined_frame(q, b);
}
//<

//> linkage-apply
//>   A row gives a speed, and takes an impulse. Both walk over the six numbers
//>   of each body's motion.
ALWAYS_INLINE real rows_dot(int rows, int k, const real row[MOTIONS],
                            const real speed[MOTIONS])
{
    real sum = 0;
    for (int i = straight_first(rows, k); i < straight_end(rows, k); i++)
        sum += row[i] * speed[i];
    for (int i = MOTION_TURN; i < MOTIONS; i++) sum += row[i] * speed[i];
    return sum;
}

// drive += rows^T impulse; and speed -= rows velocity.  A compiler that sees a
// sum of its own takes two of its numbers at a time.
ALWAYS_INLINE void drive_by(real drive[MOTIONS], int rows, real (*row)[MOTIONS],
                     const real *impulse)
{
    real sum[MOTIONS];
    memcpy(sum, drive, sizeof sum);
    for (int k = 0; k < rows; k++)
        for (int i = 0; i < MOTIONS; i++) sum[i] += row[k][i] * impulse[k];
    memcpy(drive, sum, sizeof sum);
}

ALWAYS_INLINE void take_speed(real *speed, int rows, real (*row)[MOTIONS],
                       const real velocity[MOTIONS])
{
    for (int k = 0; k < rows; k++)
        speed[k] -= rows_dot(rows, k, row[k], velocity);
}

// How the turns of a heavy body have answered what it was given.
static real turned(const linkage_body *x, int t)
{
    real sum = x->then[t];
    for (int k = 0; k < TURNS; k++) sum += x->light[t][k] * x->given[k];
    return sum;
}

static void turn_heavy(linkage_body *x, real u[MOTIONS], const real impulse[TURNS])
{
    for (int t = 0; t < TURNS; t++) x->given[t] += impulse[t];
    for (int t = 0; t < TURNS; t++)
        for (int k = 0; k < TURNS; k++)
            u[MOTION_TURN + t] += x->light[t][k] * impulse[k];
}

// An impulse, in the coordinates of a body's motion.
ALWAYS_INLINE void apply_impulse(linkage *l, const linkage_pass *q, int b,
                                 const real impulse[MOTIONS])
{
    real inverse = basis_of(q->f, b)->inverse_mass;
    real *u = q->velocity[b].of;
    for (int i = 0; i < MOTION_TURN; i++) u[i] += inverse * impulse[i];
    if (l->body[b].is_heavy) turn_heavy(&l->body[b], u, impulse + MOTION_TURN);
    else for (int i = MOTION_TURN; i < MOTIONS; i++) u[i] += impulse[i];
}

ALWAYS_INLINE void push_body(linkage *l, const linkage_pass *q, int rows,
                             real (*row)[MOTIONS], int b, const real *impulse)
{
    real sum[MOTIONS] = { 0 };
    if (!moves(q->f, b)) return;
    drive_by(sum, rows, row, impulse);
    apply_impulse(l, q, b, sum);
}

static void push_both(linkage *l, const linkage_pass *q, const joint *j,
                      joint_rows *r, const real *impulse)
{
    if (r->count == 3) {
        push_body(l, q, 3, r->a, j->a, impulse);
        push_body(l, q, 3, r->b, j->b, impulse);
    } else {
        push_body(l, q, r->count, r->a, j->a, impulse);
        push_body(l, q, r->count, r->b, j->b, impulse);
    }
}
//<

//> linkage-want
//>   Before the bodies move, the impulses must close the gap at the end of the
//>   substep. After the move they must stop the relative speed. Only what is
//>   wanted differs, so it is an argument of all that follows.
// How fast a joint's errors must change.  A body that turns takes a point along
// an arc: where the points will be at the end of the substep is looked up.
static void bias_to_end(const linkage *l, const linkage_pass *q, int number,
                        real then[JOINT_ROWS], real want[JOINT_ROWS])
{
    const joint *j = &l->joint[number];
    const joint_rows *r = &l->rows[number];
    real h = q->f->h;
    joint_errors(j, r, end_of(l, q, j->a), end_of(l, q, j->b), then);
    for (int k = 0; k < r->held + j->is_limited; k++) {
        bool is_open = k == r->held && r->error[k] > 0;
        real left = is_open ? 0 : (1 - r->fraction) * r->error[k];
        want[k] = (left - then[k]) / h - r->give[k] * j->impulse[k];
    }
}

static void bias_position(const linkage *l, const linkage_pass *q, int number,
                          real want[JOINT_ROWS])
{
    real then[JOINT_ROWS];
    bias_to_end(l, q, number, then, want);
}

ALWAYS_INLINE void stop(int n, const linkage_pass *q, const joint *j,
                        joint_rows *r, real want[JOINT_ROWS])
{
    if (moves(q->f, j->a)) take_speed(want, n, r->a, q->velocity[j->a].of);
    if (moves(q->f, j->b)) take_speed(want, n, r->b, q->velocity[j->b].of);
}

static void bias_velocity(const linkage *l, const linkage_pass *q, int number,
                          real want[JOINT_ROWS])
{
    const joint *j = &l->joint[number];
    joint_rows *r = &l->rows[number];
    int rows = r->held + j->is_limited;
    for (int k = 0; k < rows; k++) want[k] = 0;
    if (j->is_limited && r->error[r->held] > 0)
        want[r->held] = -r->error[r->held] / q->f->h;
    if (j->kind == JOINT_BALL)  stop(3, q, j, r, want);
    else                        stop(rows, q, j, r, want);
}

typedef void bias_function(const linkage *l, const linkage_pass *q, int number,
                           real want[JOINT_ROWS]);
//<

//> linkage-driven
//>   Where joints are driven, the row of a drive wants something of its own.
// How fast the bodies of a joint go along row k.
static real speed_along(const linkage_pass *q, const joint *j, joint_rows *r,
                        int k)
{
    real less = 0;
    if (moves(q->f, j->a))
        take_speed(&less, 1, &r->a[k], q->velocity[j->a].of);
    if (moves(q->f, j->b))
        take_speed(&less, 1, &r->b[k], q->velocity[j->b].of);
    return -less;
}

// After the cone's: friction takes what that leaves free.
static void bias_friction(const linkage_pass *q, const joint *j, joint_rows *r,
                          real want[JOINT_ROWS])
{
    for (int i = 0; i < 3; i++) {
        bool is_cone = j->is_coned && i < 2 && j->cone_holds[i];
        r->turning[i] = speed_along(q, j, r, r->held + i);
        if (!is_cone) want[r->held + i] = actuator_bias_friction(j, r, i);
    }
}

static void bias_driven_position(const linkage *l, const linkage_pass *q,
                                 int number, real want[JOINT_ROWS])
{
    const joint *j = &l->joint[number];
    joint_rows *r = &l->rows[number];
    real h = q->f->h, rate = q->f->joint_rate, then[JOINT_ROWS];
    bias_to_end(l, q, number, then, want);
    for (int i = 0; i < 2 && j->is_coned; i++)
        want[r->held + i] = actuator_bias_cone(j, r, i, h, rate, &then[r->held + i], 0);
    if (j->friction > 0) bias_friction(q, j, r, want);
    if (j->is_driven) want[r->held] = actuator_bias(j, r, h, rate, &then[r->held], 0);
}

static void bias_driven_velocity(const linkage *l, const linkage_pass *q,
                                 int number, real want[JOINT_ROWS])
{
    const joint *j = &l->joint[number];
    joint_rows *r = &l->rows[number];
    bias_velocity(l, q, number, want);
    for (int i = 0; i < 2 && j->is_coned; i++)
        want[r->held + i] = actuator_bias_cone(j, r, i, q->f->h, q->f->joint_rate,
                                               NULL, speed_along(q, j, r,
                                                                 r->held + i));
    if (j->friction > 0) bias_friction(q, j, r, want);
    if (!j->is_driven) return;
    want[r->held] = actuator_bias(j, r, q->f->h, q->f->joint_rate, NULL,
                                  speed_along(q, j, r, r->held));
}

// How fast driven joints go when a substep begins.
static void find_speeds(linkage *l, const linkage_pass *q)
{
    for (int k = 0; k < l->count && l->is_driven; k++) {
        joint_rows *r = &l->rows[k];
        if (l->joint[k].is_driven && l->role[k] != JOINT_IDLE)
            r->before = speed_along(q, &l->joint[k], r, r->held);
    }
}

// How hard springs and motors find it to move, for a frame.
static void find_inverses(linkage *l, const linkage_pass *q)
{
    for (int k = 0; k < l->count && l->is_driven; k++) {
        joint *j = &l->joint[k];
        if (!j->is_driven || l->role[k] == JOINT_IDLE) continue;
        j->drive.inverse = actuator_inverse(&l->rows[k],
                                            basis_of(q->f, j->a)->inverse_mass,
                                            basis_of(q->f, j->b)->inverse_mass);
    }
}

// s, for which a force acts on a joint in this substep, as gravity does.
static real kick_of(const linkage_pass *q, const joint *j)
{
    const solver_frame *f = q->f;
    return f->age ? (f->age[yielding(f, j)] + f->h) / 2 : f->h;
}

static void begin_friction(const linkage_pass *q, joint *j, joint_rows *r)
{
    for (int i = 0; i < 3; i++)
        r->turning[i] = speed_along(q, j, r, r->held + i);
    actuator_begin_friction(j, r, kick_of(q, j));
}

static void begin_drives(linkage *l, const linkage_pass *q)
{
    for (int k = 0; k < l->count; k++) {
        joint *j = &l->joint[k];
        if (l->role[k] == JOINT_IDLE) continue;
        if (j->friction > 0) begin_friction(q, j, &l->rows[k]);
        if (j->is_driven)
            actuator_begin(j, &l->rows[k], q->f->h, kick_of(q, j));
    }
}
//<

//> linkage-alone
//>   A joint can be solved by itself, as in the exercise of chapter 13. This is
//>   the plain form. What is too wide to be solved at once is solved like this,
//>   and with `is_plain` all is, to measure what that is worth.
// A joint gives way as a spring does, by a share of its own K in a substep.  It
// must: where bodies form a ring, or hang between two walls, some rows say the
// same twice, and a joint without any give would bear whatever rounding says.
static const real GIVE = 1e-4;              // tuned, of K

// Those that stand alone are springs, critically damped, or passes would not bring
// them to terms: such a one turns by so much in a substep.  Half of it lets a net of
// 400 balls hang open by four radii; with double it gains a tenth of its energy.
static const real TURN_ALONE = 1.8;         // tuned, rad

static void factor_alone(linkage *l, const linkage_pass *q, int number)
{
    const joint *j = &l->joint[number];
    joint_rows *r = &l->rows[number];
    real mass_a = basis_of(q->f, j->a)->inverse_mass;
    real mass_b = basis_of(q->f, j->b)->inverse_mass;
    for (int k = 0; k < r->count; k++) {
        for (int i = 0; i < r->count; i++)
            r->inverse[k][i] = joint_coupling(r->count, r, k, i, mass_a, mass_b);
        r->give[k] = r->inverse[k][k] / (TURN_ALONE * (2 + TURN_ALONE));
        r->inverse[k][k] += r->give[k];
    }
    if (j->extra > 0) actuator_weigh(j, r, r->count, r->inverse);
    small_invert(r->count, r->inverse);
}
//<

//> linkage-limit
//>   The active set changes here: a limit that pulls is dropped, and a limit
//>   that is passed is added.
// A limit only pushes, as a contact does.  While it does it is one row more;
// where it would pull, or is not reached, it is none.  Returns whether that has
// changed.
static void push_more(linkage *l, const linkage_pass *q, int number,
                      const real more[JOINT_ROWS])
{
    joint *j = &l->joint[number];
    joint_rows *r = &l->rows[number];
    push_both(l, q, j, r, more);
    for (int k = 0; k < JOINT_ROWS; k++) {
        j->impulse[k] += more[k];
        if (more[k] != 0) r->since[k] = 0;
    }
    find_end(l, q, j->a);
    find_end(l, q, j->b);
}

static bool switch_drive(linkage *l, const linkage_pass *q, int number,
                         bias_function *what)
{
    joint *j = &l->joint[number];
    joint_rows *r = &l->rows[number];
    real want[JOINT_ROWS], more[JOINT_ROWS] = { 0 };
    what(l, q, number, want);
    bool has_changed = j->is_driven && actuator_switch(j, r, &more[r->held]);
    if (j->is_coned)     has_changed |= actuator_switch_cone(j, r, more);
    if (j->friction > 0) has_changed |= actuator_switch_friction(j, r, more);
    if (has_changed) push_more(l, q, number, more);
    return has_changed;
}

static bool switch_limit(linkage *l, const linkage_pass *q, int number,
                         bias_function *what)
{
    joint *j = &l->joint[number];
    joint_rows *r = &l->rows[number];
    real want[JOINT_ROWS], back[JOINT_ROWS] = { 0 };
    int k = r->held;
    bool pushes = r->count > k;
    if (j->extra > 0) return switch_drive(l, q, number, what);
    if (!j->is_limited) return false;
    if (pushes && !(j->impulse[k] < 0)) return false;
    if (pushes) {
        back[k] = -j->impulse[k];
        push_more(l, q, number, back);
    } else {
        what(l, q, number, want);
        if (!(want[k] > 0)) return false;
    }
    r->since[k] = 0;
    r->count = k + !pushes;
    return true;
}

static void solve_alone(linkage *l, const linkage_pass *q, int number,
                        bias_function *what)
{
    joint *j = &l->joint[number];
    joint_rows *r = &l->rows[number];
    find_end(l, q, j->a);
    find_end(l, q, j->b);
    for (int n = 0; n < 2; n++) {
        what(l, q, number, r->want);
        small_times(r->count, r->inverse, r->want);
        for (int k = 0; k < r->count; k++) j->impulse[k] += r->want[k];
        push_both(l, q, j, r, r->want);
        if (!switch_limit(l, q, number, what)) return;
        factor_alone(l, q, number);
    }
}
//<

//> linkage-graph
// The body at the other end of a joint.
static int other_end(const joint *j, int b)
{
    return j->a + j->b - b;
}

// The joint after k in the list of body b.
static int *next_of(linkage *l, int k, int b)
{
    return &l->rows[k].next[l->joint[k].a != b];
}

static void reset_body(linkage *l, int b)
{
    if (b < 0) return;
    linkage_body *x = &l->body[b];
    x->united = b;
    x->first = x->step = x->place = -1;
    x->left = 0;
    x->is_jolted = x->is_heavy = false;
    x->seen = l->frames;
}

// Is one of its bodies, of which one yields, among those that are solved now?
static bool is_in(const linkage_pass *q, const joint *j)
{
    return !q->rung || q->rung[yielding(q->f, j)] == q->of;
}

// One of which neither end yields has nothing to move: its impulses would grow in
// every substep.
static joint_role choose_role(const linkage *l, const linkage_pass *q, int k)
{
    const joint *j = &l->joint[k];
    if (!joint_holds(j) || j->kind == JOINT_PIN
        || (!yields(q->f, j->a) && !yields(q->f, j->b)) || !is_in(q, j))
        return JOINT_IDLE;
    return l->is_plain ? JOINT_ALONE : JOINT_SOLVED;
}

static void add_to_list(linkage *l, const linkage_pass *q, int b, int k)
{
    if (!moves(q->f, b)) return;
    *next_of(l, k, b) = l->body[b].first;
    l->body[b].first = k;
    l->body[b].left++;
}
//<

//> linkage-order
//>   A body is solved before those that are nearer to the root: so in a tree each
//>   waits for all that hangs on it, and in a ring two fronts come together.
// The bodies that are joined to root, and it: from it outwards.  Returns where they
// end.
static int walk_from(linkage *l, const linkage_pass *q, int root, int first)
{
    int end = first;
    l->order[end++] = root;
    l->body[root].place = first;
    for (int i = first; i < end; i++) {
        int b = l->order[i];
        for (int k = l->body[b].first; k >= 0; k = *next_of(l, k, b)) {
            int on = other_end(&l->joint[k], b);
            if (!moves(q->f, on) || l->body[on].place >= 0) continue;
            l->body[on].place = end;
            l->order[end++] = on;
        }
    }
    return end;
}

// Its root is one of those that are furthest from body b: what is long is narrow from
// there.
static int order_group(linkage *l, const linkage_pass *q, int b, int first)
{
    int end = walk_from(l, q, b, first), root = l->order[end - 1];
    for (int i = first; i < end; i++) l->body[l->order[i]].place = -1;
    return walk_from(l, q, root, first);
}
//<

//> linkage-front
// So many bodies may wait at once.  Each joint has to tell all of them: with so many
// it takes ten times as long as in a chain.
enum { FRONT_MOST = 8 };                    // tuned, bodies
enum { FRONT_ROOM = 2 * FRONT_MOST + 2 };

// Body b waits for its other joints, if it has any.
static bool wait_in(linkage *l, linkage_step *s, int b)
{
    if (l->body[b].left == 0) return true;
    if (s->count == FRONT_MOST) return false;
    if (!TABLE_ADD(l->reach, l->reaches, l->reach_room)) return false;
    l->reach[l->reaches++].body = b;
    s->count++;
    return true;
}

// The step that solves joint k.  False if it would be too wide, or memory is refused.
static bool add_step(linkage *l, const linkage_pass *q, int k)
{
    const joint *j = &l->joint[k];
    linkage_step s = { .joint = k, .first = l->reaches, .block = l->blocks };
    s.a = moves(q->f, j->a) ? j->a : -1;
    s.b = moves(q->f, j->b) ? j->b : -1;
    int end[2] = { s.a, s.b };
    bool ok = true;
    for (int e = 0; e < 2; e++) {
        s.from[e] = end[e] < 0 ? -1 : l->body[end[e]].step;
        if (end[e] >= 0) l->body[end[e]].left--;
    }
    for (int e = 0; e < 2; e++) {
        if (s.from[e] < 0 && end[e] >= 0) ok &= wait_in(l, &s, end[e]);
        if (s.from[e] < 0 || (e == 1 && s.from[1] == s.from[0])) continue;
        const linkage_step *was = &l->step[s.from[e]];
        for (int i = 0; i < was->count; i++)
            ok = ok && wait_in(l, &s, l->reach[was->first + i].body);
    }
    l->blocks += s.count * s.count;
    int room = table_room(l->blocks, l->block_room);
    if (room > l->block_room) TABLE_GROW(ok, l->block, l->block_room, room);
    if (ok) l->block_room = room;
    for (int i = 0; i < s.count; i++)
        l->body[l->reach[s.first + i].body].step = l->steps;
    l->step[l->steps++] = s;
    return ok;
}

static bool add_steps(linkage *l, const linkage_pass *q, const linkage_group *g)
{
    for (int i = g->end_body - 1; i >= g->first_body; i--) {
        int b = l->order[i];
        for (int k = l->body[b].first; k >= 0; k = *next_of(l, k, b)) {
            int on = other_end(&l->joint[k], b);
            if (moves(q->f, on) && l->body[on].place > i) continue;
            if (!add_step(l, q, k)) return false;
        }
    }
    return true;
}

// What is too wide stands alone, joint by joint.
static void add_group(linkage *l, const linkage_pass *q, int b)
{
    int bodies = l->groups ? l->group[l->groups - 1].end_body : 0;
    linkage_group g = { .first = l->steps, .first_body = bodies };
    int reaches = l->reaches, blocks = l->blocks;
    g.end_body = order_group(l, q, b, bodies);
    bool ok = add_steps(l, q, &g);
    g.end = l->steps;
    if (ok) {
        l->group[l->groups++] = g;
        return;
    }
    for (int i = g.first_body; i < g.end_body; i++) {
        int x = l->order[i];
        for (int k = l->body[x].first; k >= 0; k = *next_of(l, k, x))
            l->role[k] = JOINT_ALONE;
    }
    l->steps = g.first;
    l->reaches = reaches;
    l->blocks = blocks;
}

static void reset_bodies(linkage *l)
{
    for (int k = 0; k < l->count; k++) {
        if (!joint_holds(&l->joint[k])) continue;
        reset_body(l, l->joint[k].a);
        reset_body(l, l->joint[k].b);
    }
}

static void choose_roles(linkage *l, const linkage_pass *q)
{
    l->steps = l->groups = l->reaches = l->blocks = 0;
    l->is_stale = false;
    reset_bodies(l);
    for (int k = l->count - 1; k >= 0; k--) {
        l->role[k] = choose_role(l, q, k);
        if (l->role[k] != JOINT_SOLVED) continue;
        add_to_list(l, q, l->joint[k].a, k);
        add_to_list(l, q, l->joint[k].b, k);
    }
    for (int k = 0; k < l->count; k++) {
        const joint *j = &l->joint[k];
        int b = moves(q->f, j->a) ? j->a : j->b;
        if (l->role[k] == JOINT_SOLVED && l->body[b].place < 0) add_group(l, q, b);
    }
}

static int united_with(linkage *l, int b)
{
    while (l->body[b].united != b) {
        l->body[b].united = l->body[l->body[b].united].united;
        b = l->body[b].united;
    }
    return b;
}

void linkage_unite(linkage *l, const linkage_pass *q)
{
    reset_bodies(l);
    for (int k = 0; k < l->count; k++) {
        const joint *j = &l->joint[k];
        if (!joint_holds(j) || !yields(q->f, j->a) || !yields(q->f, j->b)) continue;
        l->body[united_with(l, j->b)].united = united_with(l, j->a);
    }
}

bool linkage_unites(linkage *l, int a, int b)
{
    return linkage_has(l, a) && linkage_has(l, b)
        && united_with(l, a) == united_with(l, b);
}
//<

//> linkage-factor
// A body of the front in which a joint is solved: the step that it waited in (-1: in
// none), and its place there.
typedef struct {
    int body, step, at;
    real (*answer)[MOTIONS];    // [rows] to impulses along the joint's rows
} front_body;

typedef struct {
    int count, a, b;        // where the joint's bodies are; -1: none moves
    front_body of[FRONT_ROOM];
    linkage_block own[2];   // of those that waited in no step
    real leaves[2][JOINT_ROWS][MOTIONS];    // answers of those that do not stay
    int stays[FRONT_MOST];  // where those are that do
} front;

static int add_own(front *x, const linkage *l, const linkage_pass *q, int b)
{
    const linkage_body *y = &l->body[b];
    int n = x->count++, own = n > 0 && x->of[0].step < 0;
    real inverse = basis_of(q->f, b)->inverse_mass;
    x->of[n].body = b;
    x->of[n].step = -1;
    x->of[n].at = own;
    for (int i = 0; i < MOTIONS; i++)
        for (int m = 0; m < MOTIONS; m++)
            x->own[own].of[i][m] = i != m ? 0 : i < MOTION_TURN ? inverse : 1;
    for (int i = 0; i < TURNS && y->is_heavy; i++)
        memcpy(x->own[own].of[MOTION_TURN + i] + MOTION_TURN, y->light[i],
               sizeof y->light[i]);
    return n;
}

// All that waited in step `from`; returns where body b stands.
static int add_waiting(front *x, const linkage *l, int from, int b)
{
    const linkage_step *s = &l->step[from];
    int found = -1;
    for (int i = 0; i < s->count; i++) {
        front_body *y = &x->of[x->count];
        y->body = l->reach[s->first + i].body;
        y->step = from;
        y->at = i;
        if (y->body == b) found = x->count;
        x->count++;
    }
    return found;
}

static int find_in(const front *x, int b)
{
    int i = 0;
    while (x->of[i].body != b) i++;
    return i;
}

// In the order in which they were told to wait.
static void gather(front *x, linkage *l, const linkage_pass *q, const linkage_step *s)
{
    x->count = 0;
    x->a = s->a < 0 ? -1 : s->from[0] < 0 ? add_own(x, l, q, s->a)
                         : add_waiting(x, l, s->from[0], s->a);
    if (s->b < 0)               x->b = -1;
    else if (s->from[1] < 0)    x->b = add_own(x, l, q, s->b);
    else if (s->from[1] == s->from[0]) x->b = find_in(x, s->b);
    else                        x->b = add_waiting(x, l, s->from[1], s->b);
    for (int i = 0, stay = 0; i < x->count; i++) {
        linkage_reach *y = &l->reach[s->first + stay];
        bool stays = stay < s->count && y->body == x->of[i].body;
        x->of[i].answer = stays ? y->answer : x->leaves[i - stay];
        if (stays) x->stays[stay++] = i;
    }
}

// How number k of the front answers impulses on number i; NULL: not at all.
static const linkage_block *block_of(const linkage *l, const front *x, int i, int k)
{
    if (i < 0) return NULL;
    const front_body *y = &x->of[i], *z = &x->of[k];
    if (y->step != z->step) return NULL;
    if (y->step < 0) return i == k ? &x->own[y->at] : NULL;
    const linkage_step *s = &l->step[y->step];
    return &l->block[s->block + y->at * s->count + z->at];
}

ALWAYS_INLINE void add_answers(int n, real (*row)[MOTIONS], const linkage_block *x,
                               real answer[JOINT_ROWS][MOTIONS])
{
    for (int a = 0; a < n; a++) {
        real sum[MOTIONS];
        memcpy(sum, answer[a], sizeof sum);
        for (int i = straight_first(n, a); i < straight_end(n, a); i++)
            for (int m = 0; m < MOTIONS; m++) sum[m] += row[a][i] * x->of[i][m];
        for (int i = MOTION_TURN; i < MOTIONS; i++)
            for (int m = 0; m < MOTIONS; m++) sum[m] += row[a][i] * x->of[i][m];
        memcpy(answer[a], sum, sizeof sum);
    }
}

ALWAYS_INLINE void find_answers(int n, const linkage *l, front *x, joint_rows *r)
{
    for (int i = 0; i < x->count; i++) {
        const linkage_block *a = block_of(l, x, x->a, i), *b = block_of(l, x, x->b, i);
        memset(x->of[i].answer, 0, (size_t)n * sizeof *x->of[i].answer);
        if (a) add_answers(n, r->a, a, x->of[i].answer);
        if (b) add_answers(n, r->b, b, x->of[i].answer);
    }
}

ALWAYS_INLINE void add_couplings(int n, real (*row)[MOTIONS],
                                 real answer[JOINT_ROWS][MOTIONS],
                                 real k[JOINT_ROWS][JOINT_ROWS])
{
    for (int a = 0; a < n; a++)
        for (int b = 0; b <= a; b++)
            k[b][a] = k[a][b] += rows_dot(n, b, row[b], answer[a]);
}

// Those that stay answer less, by what the joint holds back.
ALWAYS_INLINE void keep_front(int n, linkage *l, const linkage_step *s,
                              const front *x, const joint_rows *r)
{
    linkage_reach *y = &l->reach[s->first];
    for (int i = 0; i < s->count; i++)
        for (int k = 0; k < n; k++) {
            real less[JOINT_ROWS];
            for (int m = 0; m < n; m++) less[m] = -r->inverse[k][m];
            memset(y[i].back[k], 0, sizeof y[i].back[k]);
            drive_by(y[i].back[k], n, y[i].answer, less);
        }
    for (int i = 0; i < s->count; i++)
        for (int k = 0; k < s->count; k++) {
            const linkage_block *was = block_of(l, x, x->stays[i], x->stays[k]);
            linkage_block *now = &l->block[s->block + i * s->count + k];
            if (was) *now = *was;
            else     memset(now, 0, sizeof *now);
            for (int m = 0; m < MOTIONS; m++) {
                real moved[JOINT_ROWS];
                for (int c = 0; c < n; c++) moved[c] = y[i].answer[c][m];
                drive_by(now->of[m], n, y[k].back, moved);
            }
        }
}

// K of a joint: its own give, and how the front answers it.
ALWAYS_INLINE void factor(int n, linkage *l, const linkage_pass *q,
                          const linkage_step *s)
{
    const joint *j = &l->joint[s->joint];
    joint_rows *r = &l->rows[s->joint];
    real mass_a = basis_of(q->f, j->a)->inverse_mass;
    real mass_b = basis_of(q->f, j->b)->inverse_mass;
    front x;
    gather(&x, l, q, s);
    for (int k = 0; k < n; k++) {
        for (int i = 0; i < n; i++) r->inverse[k][i] = 0;
        r->inverse[k][k] = r->give[k] = GIVE * joint_coupling(n, r, k, k, mass_a,
                                                              mass_b);
    }
    find_answers(n, l, &x, r);
    if (x.a >= 0) add_couplings(n, r->a, x.of[x.a].answer, r->inverse);
    if (x.b >= 0) add_couplings(n, r->b, x.of[x.b].answer, r->inverse);
    if (j->extra > 0) actuator_weigh(j, r, n, r->inverse);
    small_invert(n, r->inverse);
    keep_front(n, l, s, &x, r);
}

static void factor_group(linkage *l, const linkage_pass *q, const linkage_group *g)
{
    for (int i = g->first; i < g->end; i++) {
        int n = l->rows[l->step[i].joint].count;
        if (n == 3) factor(3, l, q, &l->step[i]);
        else        factor(n, l, q, &l->step[i]);
    }
}
//<

//> linkage-solve
//>   And here are the two walks. The velocities that they find are not given to
//>   the bodies. Only the impulses are, each to A and its opposite to B, so
//>   momentum stays to rounding, however inexact the matrices are.
// What a joint wants, and its bodies do not do already.  Those that wait get the
// impulse for that, as if no joint that comes later held them.
static inline void solve_inward(int n, linkage *l, const linkage_step *s)
{
    joint_rows *r = &l->rows[s->joint];
    if (s->a >= 0) take_speed(r->want, n, r->a, l->body[s->a].speed);
    if (s->b >= 0) take_speed(r->want, n, r->b, l->body[s->b].speed);
    small_times(n, r->inverse, r->want);
    for (int i = s->first; i < s->first + s->count; i++)
        drive_by(l->body[l->reach[i].body].speed, n, l->reach[i].answer, r->want);
}

// Now it is known what the later joints give those that waited: of that the joint
// holds its part.
static inline void solve_outward(int n, linkage *l, const linkage_step *s)
{
    joint *j = &l->joint[s->joint];
    joint_rows *r = &l->rows[s->joint];
    for (int i = s->first; i < s->first + s->count; i++) {
        const linkage_reach *y = &l->reach[i];
        for (int k = 0; k < n; k++)
            for (int m = 0; m < MOTIONS; m++)
                r->want[k] += y->back[k][m] * l->body[y->body].impulse[m];
    }
    if (s->a >= 0) drive_by(l->body[s->a].impulse, n, r->a, r->want);
    if (s->b >= 0) drive_by(l->body[s->b].impulse, n, r->b, r->want);
    for (int i = 0; i < n; i++) {
        j->impulse[i] += r->want[i];
        r->since[i] += r->want[i];
    }
}

static void solve_group(linkage *l, const linkage_pass *q, const linkage_group *g)
{
    const linkage_step *s = l->step;
    for (int i = g->first_body; i < g->end_body; i++) {
        linkage_body *x = &l->body[l->order[i]];
        memset(x->speed, 0, sizeof x->speed);
        memset(x->impulse, 0, sizeof x->impulse);
    }
    for (int k = g->first; k < g->end; k++) {
        int n = l->rows[s[k].joint].count;
        if (n == 3) solve_inward(3, l, &s[k]);
        else        solve_inward(n, l, &s[k]);
    }
    for (int k = g->end - 1; k >= g->first; k--) {
        int n = l->rows[s[k].joint].count;
        if (n == 3) solve_outward(3, l, &s[k]);
        else        solve_outward(n, l, &s[k]);
    }
    for (int i = g->first_body; i < g->end_body; i++)
        apply_impulse(l, q, l->order[i], l->body[l->order[i]].impulse);
}
//<

//> linkage-settle
//>   A tree is solved once, and again as long as its joints will miss what they
//>   want by too much. Mostly once is enough.
// As a share of a body's size: by so much a joint may miss what it wants, at
// the end of a substep: a hundredth of what gaps may be.  With ten times
// as much three more double pendulums (chapter 20, case 164) change their energy
// by more than a thousandth, and a chain costs a tenth less.
static const real MISS = 1e-6;              // tuned, sizes

// Rows are straight, and points go along arcs: a large impact is solved more
// than once, as Newton does.  And as often again if it was solved without a limit
// that is reached, or with one that pulls.
enum { IMPACT_STEPS = 3 };                  // tuned, steps

// Are all where they were when this was last asked?
static bool find_ends(linkage *l, const linkage_pass *q, const linkage_group *g)
{
    bool are_known = true;
    for (int i = g->first_body; i < g->end_body; i++)
        are_known &= find_end(l, q, l->order[i]);
    return are_known;
}

// What a group was given while a row of it held that does not: a motor that is asked
// for a speed, and cannot reach it, is answered by all other joints.  They take that
// back, or a light body between them would spin away with it.
static void take_back(linkage *l, const linkage_pass *q, const linkage_group *g)
{
    for (int s = g->first; s < g->end; s++) {
        int k = l->step[s].joint;
        real back[JOINT_ROWS];
        for (int i = 0; i < JOINT_ROWS; i++) {
            back[i] = -l->rows[k].since[i];
            l->rows[k].since[i] = 0;
            l->joint[k].impulse[i] += back[i];
        }
        push_both(l, q, &l->joint[k], &l->rows[k], back);
    }
    find_ends(l, q, g);
}

static bool switch_limits(linkage *l, const linkage_pass *q, const linkage_group *g,
                          bias_function *what)
{
    bool has_changed = false;
    for (int s = g->first; s < g->end; s++)
        has_changed |= switch_limit(l, q, l->step[s].joint, what);
    if (has_changed) take_back(l, q, g);
    return has_changed;
}

// Returns by how much the worst joint will miss it, as a share of its size.
static real find_biases(linkage *l, const linkage_pass *q, const linkage_group *g,
                        bias_function *what)
{
    real worst = 0;
    for (int s = g->first; s < g->end; s++) {
        int k = l->step[s].joint;
        joint_rows *r = &l->rows[k];
        what(l, q, k, r->want);
        for (int i = 0; i < r->count; i++) {
            real size = i < r->lengths ? r->size : 1;
            worst = real_max(fabs(r->want[i]) / size, worst);
        }
    }
    return q->f->h * worst;
}

// Solved once, and again while a joint will miss what it wants by too much, and each
// solve comes nearer.
static void settle_group(linkage *l, const linkage_pass *q, linkage_group *g,
                         bias_function *what, int rounds, real rough)
{
    bool is_last = what == bias_position || what == bias_driven_position;
    real before = 0;
    for (int s = g->first; s < g->end && g->is_limited; s++)
        memset(l->rows[l->step[s].joint].since, 0, sizeof l->rows->since);
    for (int n = 0; n < rounds + IMPACT_STEPS; n++) {
        if (n >= rounds && !g->is_limited) return;
        bool is_known = is_last && find_ends(l, q, g);
        if (is_known && g->is_settled) return;
        bool has_changed = g->is_limited
                        && switch_limits(l, q, g, what);
        real missed = find_biases(l, q, g, what);
        bool is_settled = (n > 0 || g->is_solved) && missed <= MISS;
        bool is_nearer = n == 0 || has_changed || missed < before;
        g->is_settled = (is_settled || !is_nearer) && is_last;
        if (!has_changed && (is_settled || n >= rounds || !is_nearer)) return;
        before = missed;
        if (has_changed || !g->is_ready) factor_group(l, q, g);
        g->is_ready = true;
        g->is_solved = is_last;
        solve_group(l, q, g);
        if (missed <= rough && !g->is_limited) return;
    }
}

// What stands alone first, every other time last to first; then the trees.
static void settle_bounds(linkage *l, const linkage_pass *q,
                          bias_function *what, int rounds, real rough)
{
    l->is_backward = !l->is_backward;
    for (int i = 0; i < l->count; i++) {
        int k = l->is_backward ? l->count - 1 - i : i;
        if (l->role[k] == JOINT_ALONE) solve_alone(l, q, k, what);
    }
    for (int k = 0; k < l->groups; k++)
        settle_group(l, q, &l->group[k], what, rounds, rough);
}
//<

//> linkage-heavy
//>   What pulls harder than a substep follows makes its bodies harder to turn.
static real length_of(const real *x, int n)
{
    real sum = 0;
    for (int k = 0; k < n; k++) sum += x[k] * x[k];
    return sqrt(sum);
}

static real force_of(const joint *j, const joint_rows *r, real h)
{
    const real *p = j->impulse;
    if (j->kind == JOINT_DISTANCE) return fabs(p[0]) / h;
    if (j->kind == JOINT_SLIDER)
        return sqrt(p[0] * p[0] + p[1] * p[1] + p[5] * p[5]) / h;
    return length_of(p, r->lengths) / h;
}

// (h w)^2, of the swing about a joint under its pull.
static real stiffness_of(const joint *j, const joint_rows *r, real h)
{
    return h * h * force_of(j, r, h) * r->swing;
}

static vec3 straight_impulse(const joint *j, const joint_rows *r,
                             const real (*row)[MOTIONS])
{
    vec3 sum = { 0, 0, 0 };
    for (int k = 0; k < r->lengths; k++)
        sum = vec3_add_scaled(sum, j->impulse[k],
                              vec3_make(row[k][0], row[k][1], row[k][2]));
    return sum;
}

// The geometric stiffness.  A body that turns by d takes its arm r along, and P = h F
// then gives it a moment that is other by (d x r) x P = r (P d) - d (r P).  Along
// their sum s = r/|r| + P/|P| the symmetric part of that pushes on; across it, it
// turns back with |r| |P| s^2 / 4 at most.
static void add_stiffness(const linkage_pass *q, linkage_body *x, int b, vec3 at,
                          vec3 impulse)
{
    vec3 arm = vec3_sub(at, joined_frame(q, b)->center), delta[TURNS];
    real pull = vec3_length(impulse), all = vec3_length(arm);
    if (!(pull > 0 && all > 0)) return;
    vec3 s = vec3_add_scaled(vec3_scale(1 / pull, impulse), 1 / all, arm);
    real times = q->f->h * pull * all / 4;
    for (int t = 0; t < TURNS; t++)
        delta[t] = vec3_cross(basis_of(q->f, b)->turn[t], s);
    for (int i = 0; i < TURNS; i++)
        for (int k = 0; k < TURNS; k++)
            x->heavy[i][k] += times * vec3_dot(delta[i], delta[k]);
}

// A swing with h w > 1 gets so much inertia that h w is 1 again.
static void weigh_joined(linkage_body *x)
{
    real all = x->heavy[0][0] + x->heavy[1][1] + x->heavy[2][2];
    real m[JOINT_ROWS][JOINT_ROWS], fraction = all > 1 ? 1 - 1 / all : 0;
    for (int i = 0; i < TURNS; i++)
        for (int k = 0; k < TURNS; k++)
            m[i][k] = (i == k) + (x->heavy[i][k] *= fraction);
    small_invert(TURNS, m);
    for (int i = 0; i < TURNS; i++) memcpy(x->light[i], m[i], sizeof x->light[i]);
}

// Does some body swing faster than a substep follows, under the pulls that are known
// now?
static bool find_stiff(linkage *l, const linkage_pass *q, const linkage_group *g)
{
    bool some = false;
    for (int i = g->first_body; i < g->end_body; i++) l->body[l->order[i]].stiff = 0;
    for (const linkage_step *s = l->step + g->first; s < l->step + g->end; s++) {
        real more = stiffness_of(&l->joint[s->joint], &l->rows[s->joint], q->f->h);
        if (s->a >= 0) some |= (l->body[s->a].stiff += more) > 1;
        if (s->b >= 0) some |= (l->body[s->b].stiff += more) > 1;
    }
    return some;
}

// Its bodies get the inertia that its pulls give them.
static void weigh_group(linkage *l, const linkage_pass *q, linkage_group *g)
{
    vec3 a, b;
    g->is_heavy = true;
    g->is_ready = g->is_solved = g->is_settled = false;
    for (int i = g->first_body; i < g->end_body; i++)
        memset(l->body[l->order[i]].heavy, 0, sizeof l->body->heavy);
    for (const linkage_step *s = l->step + g->first; s < l->step + g->end; s++) {
        const joint *j = &l->joint[s->joint];
        const joint_rows *r = &l->rows[s->joint];
        joint_points(j, joined_frame(q, j->a), joined_frame(q, j->b), &a, &b);
        if (s->a >= 0) add_stiffness(q, &l->body[s->a], s->a, a,
                                     straight_impulse(j, r, r->a));
        if (s->b >= 0) add_stiffness(q, &l->body[s->b], s->b, b,
                                     straight_impulse(j, r, r->b));
    }
    for (int i = g->first_body; i < g->end_body; i++) {
        l->body[l->order[i]].is_heavy = true;
        weigh_joined(&l->body[l->order[i]]);
    }
}

// A chain comes taut: its bodies become as heavy as its pulls now make them, and answer
// once more to all that they were given.  No substep before this one has felt the pull:
// so it holds back how they turn (implicit Euler), not only how that changes, and takes
// energy as an impact does.
static void stiffen_group(linkage *l, const linkage_pass *q, linkage_group *g)
{
    for (int i = g->first_body; i < g->end_body; i++) {
        linkage_body *x = &l->body[l->order[i]];
        const real *now = q->velocity[l->order[i]].of + MOTION_TURN;
        for (int t = 0; t < TURNS; t++)
            x->given[t] = g->is_heavy ? x->given[t] - x->kick[t] : now[t] - x->then[t];
    }
    weigh_group(l, q, g);
    for (int i = g->first_body; i < g->end_body; i++) {
        linkage_body *x = &l->body[l->order[i]];
        for (int t = 0; t < TURNS; t++) {
            x->kick[t] = 0;
            for (int k = 0; k < TURNS; k++) x->kick[t] -= x->heavy[t][k] * x->then[k];
            x->given[t] += x->kick[t];
        }
        for (int t = 0; t < TURNS; t++)
            q->velocity[l->order[i]].of[MOTION_TURN + t] = turned(x, t);
    }
}

// From here impulses count.
static void begin_heavy(linkage *l, const linkage_pass *q, linkage_group *g)
{
    bool was_stiff = false;
    for (int i = g->first_body; i < g->end_body; i++) {
        linkage_body *x = &l->body[l->order[i]];
        was_stiff |= x->stiff > 1;
        memcpy(x->then, q->velocity[l->order[i]].of + MOTION_TURN, sizeof x->then);
        memset(x->given, 0, sizeof x->given);
        memset(x->kick, 0, sizeof x->kick);
    }
    if (!find_stiff(l, q, g)) return;
    if (was_stiff)  weigh_group(l, q, g);
    else            stiffen_group(l, q, g);
}

// The bodies have moved: their own inertia says how what parts is stopped.
static void end_heavy(linkage *l)
{
    for (linkage_group *g = l->group; g < l->group + l->groups; g++) {
        for (int i = g->first_body; i < g->end_body && g->is_heavy; i++)
            l->body[l->order[i]].is_heavy = false;
        g->is_heavy = false;
    }
}

// Contacts do not know that a body is heavy: it answers to what they have given it as
// to what its joints do.
static void take_pushes(linkage *l, const linkage_pass *q, const linkage_group *g)
{
    for (int i = g->first_body; i < g->end_body && g->is_heavy; i++) {
        linkage_body *x = &l->body[l->order[i]];
        motion *u = &q->velocity[l->order[i]];
        real more[TURNS];
        for (int t = 0; t < TURNS; t++) {
            more[t] = u->of[MOTION_TURN + t] - turned(x, t);
            u->of[MOTION_TURN + t] -= more[t];
        }
        turn_heavy(x, u->of, more);
    }
}
//<

//> linkage-find
//>   The rows are found where the bodies stand. Matrices are made of them when
//>   they are first needed.
// By how much (m) the points are not where they should be.
static real parted_by(const joint *j, const joint_rows *r)
{
    const real *e = r->error;
    if (j->kind == JOINT_DISTANCE && j->is_driven) return 0;
    if (j->kind == JOINT_DISTANCE)
        return j->is_limited ? real_max(-e[0], 0) : fabs(e[0]);
    return length_of(e, r->lengths);
}

// rad, by how much the axes that it holds are off.
static real tilted_by(const joint_rows *r)
{
    return length_of(r->error + r->lengths, r->held - r->lengths);
}

// What is far apart comes together no faster than an overlap goes: by so many radii,
// or radians, a second.
static real correction_share(const linkage *l, int k, const solver_frame *f)
{
    const joint_rows *r = &l->rows[k];
    const joint *j = &l->joint[k];
    real sum = 0, most = f->joint_rate * f->h;
    for (int i = 0; i < r->held + j->is_limited; i++) {
        bool is_angle = i < r->held ? i >= r->lengths : j->kind == JOINT_HINGE;
        real e = is_angle ? r->error[i] : r->error[i] / r->size;
        sum += i < r->held || e < 0 ? e * e : 0;
    }
    return sum > most * most ? most / sqrt(sum) : 1;
}

static void find_rows_of(linkage *l, const linkage_pass *q, int k)
{
    joint *j = &l->joint[k];
    joint_rows *r = &l->rows[k];
    joint_side a = { basis_of(q->f, j->a), *joined_frame(q, j->a) };
    joint_side b = { basis_of(q->f, j->b), *joined_frame(q, j->b) };
    bool was_upper = r->is_upper;
    joint_find_rows(r, j, &a, &b);
    if (j->is_limited && r->is_upper != was_upper) j->impulse[r->held] = 0;
    if (j->is_coned && r->is_upper != was_upper)
        j->impulse[4] = j->cone_holds[1] = 0;
    r->count = r->held + (j->is_limited && j->impulse[r->held] > 0)
             + j->extra;
    r->fraction = correction_share(l, k, q->f);
    if (l->role[k] == JOINT_ALONE)
        r->fraction = real_min(r->fraction, TURN_ALONE / (2 + TURN_ALONE));
    l->worst = real_max(l->worst, parted_by(j, r));
    l->parted += parted_by(j, r) > STRAINED * r->size || tilted_by(r) > STRAINED;
    if (l->role[k] == JOINT_ALONE) factor_alone(l, q, k);
}

static void find_rows(linkage *l, const linkage_pass *q)
{
    l->worst = 0;
    l->parted = 0;
    for (int k = 0; k < l->count; k++)
        if (l->role[k] != JOINT_IDLE) find_rows_of(l, q, k);
    for (linkage_group *g = l->group; g < l->group + l->groups; g++)
        g->is_ready = g->is_solved = g->is_settled = false;
}

// A body that a force holds at the end of its arm swings about its centre: the
// square of that angular frequency is the moment that a small turn brings,
// force times arm, beside the moment of inertia.  Here for 1 N.  However the
// body turns, this stays.
static real swing_of(const linkage_pass *q, int b, vec3 local)
{
    const rigid_frame *f = joined_frame(q, b);
    vec3 arm = vec3_sub(frame_point(f, local), f->center);
    real sum = 0, length = vec3_length(arm);
    for (int t = 0; t < TURNS; t++)
        sum += vec3_length_squared(vec3_cross(basis_of(q->f, b)->turn[t], arm));
    return length > 0 ? sum / length : 0;
}

// rad/s, that of a body which hangs there with its own weight alone.
static real hung_swing(const linkage_pass *q, int b, real swing)
{
    real inverse = basis_of(q->f, b)->inverse_mass;
    return inverse > 0 ? sqrt(vec3_length(q->f->gravity) / inverse * swing) : 0;
}

static real joined_size(const linkage_pass *q, int b)
{
    return moves(q->f, b) ? q->f->body[b].radius : HUGE_VAL;
}

// Has it limits?  Does what no pull moves hold it?
static void find_group(linkage *l, const linkage_pass *q, linkage_group *g)
{
    bool is_free = true;
    for (int s = g->first; s < g->end; s++) {
        const joint *j = &l->joint[l->step[s].joint];
        g->is_limited |= j->is_limited || j->extra > 0;
        is_free &= yields(q->f, j->a) && yields(q->f, j->b);
    }
    for (int s = g->first; s < g->end; s++)
        l->rows[l->step[s].joint].is_free = is_free;
}

// What stays for a frame.
static void find_sizes(linkage *l, const linkage_pass *q)
{
    l->is_driven = false;
    for (int k = 0; k < l->count; k++) {
        const joint *j = &l->joint[k];
        joint_rows *r = &l->rows[k];
        if (l->role[k] == JOINT_IDLE) continue;
        l->is_driven |= j->extra > 0;
        real a = swing_of(q, j->a, j->local_a);
        real b = swing_of(q, j->b, j->local_b);
        r->swing = real_max(a, b);
        r->hung = real_max(hung_swing(q, j->a, a), hung_swing(q, j->b, b));
        r->size = real_min(joined_size(q, j->a), joined_size(q, j->b));
        r->is_free = false;
    }
    for (int k = 0; k < l->groups; k++) find_group(l, q, &l->group[k]);
}
//<

//> linkage-pass
//>   The parts come together in four functions, one for each moment of a
//>   substep. Joints that stand alone go first, in an order that turns round
//>   every time; then come the trees, which hold best.
// What closed a joint's gap at the end of the last substep is what the next one
// begins with.  While its bodies swing evenly that grows by as much as it grew
// before; what changed by more than this share was struck.  (Half and double take
// as many solves; with four times as much a heavy chain loses its numbers, case 167.)
static const real STRUCK = 0.25;            // tuned, 1

static void expect(joint *j, joint_rows *r)
{
    real grown = 0, all = 0;
    for (int i = 0; i < r->held; i++) {
        real more = r->pushed[i] - r->older[i];
        grown += more * more;
        all += r->pushed[i] * r->pushed[i];
    }
    bool is_even = grown <= STRUCK * STRUCK * all;
    for (int i = 0; i < r->held; i++) {
        real more = is_even ? r->pushed[i] - r->older[i] : 0;
        j->impulse[i] = r->pushed[i] + more;
        r->older[i] = r->pushed[i];
    }
}

void linkage_forget_impulses(linkage *l, int k)
{
    joint *j = &l->joint[k];
    memset(j->impulse, 0, sizeof j->impulse);
    memset(l->rows[k].older, 0, sizeof l->rows[k].older);
    memset(l->rows[k].give, 0, sizeof l->rows[k].give);
    if (!(j->force < HUGE_VAL)) j->force = 0;
}

void linkage_mark(linkage *l)
{
    for (int k = 0; k < l->count; k++) {
        l->rows[k].begun = l->joint[k];
        l->rows[k].was_upper = l->rows[k].is_upper;
    }
}

void linkage_scale(linkage *l, real times)
{
    for (int k = 0; k < l->count; k++)
        for (int i = 0; i < JOINT_ROWS && l->role[k] != JOINT_IDLE; i++) {
            l->joint[k].impulse[i] *= times;
            l->rows[k].older[i] *= times;
        }
}

// Impulses of a substep of another length become those of this one.
static void warm(linkage *l, const linkage_pass *q)
{
    const solver_frame *f = q->f;
    for (int k = 0; k < l->count; k++) {
        joint *j = &l->joint[k];
        int b = yielding(f, j);
        bool is_pin = j->kind == JOINT_PIN;
        if (is_pin || l->role[k] != JOINT_IDLE) l->rows[k].pace = 0;
        if (l->role[k] == JOINT_IDLE) continue;
        real times = f->age ? f->warm * f->h / f->age[b] : f->warm;
        for (int i = 0; i < JOINT_ROWS; i++) {
            j->impulse[i] *= times;
            l->rows[k].older[i] *= times;
        }
    }
}

static void begin_roles(linkage *l, const linkage_pass *q)
{
    choose_roles(l, q);
    find_sizes(l, q);
    find_rows(l, q);
    find_speeds(l, q);
}

void linkage_rewind(linkage *l, const linkage_pass *q)
{
    for (int k = 0; k < l->count; k++) {
        joint *j = &l->joint[k];
        joint_rows *r = &l->rows[k];
        l->broken -= j->is_broken && !r->begun.is_broken;
        *j = r->begun;
        memcpy(r->older, j->impulse, sizeof r->older);
        r->is_upper = r->was_upper;
    }
    begin_roles(l, q);
}

void linkage_prepare(linkage *l, const linkage_pass *q)
{
    if (l->count == 0) return;
    l->frames++;
    choose_roles(l, q);
    warm(l, q);
    find_sizes(l, q);
    find_rows(l, q);
    find_speeds(l, q);
    find_inverses(l, q);
}

// Along rows that have nothing to hold, what a joint gives is less in every substep,
// until its digits end (denormal numbers): with those, processors are several times
// slower.  So what is so little beside the largest of its impulses is none.  (Any
// share from rounding to 1e-200 does the same.)
static const real TRACE = 1e-100;

static void drop_traces(real impulse[JOINT_ROWS])
{
    real most = 0;
    for (int i = 0; i < JOINT_ROWS; i++) most = real_max(most, fabs(impulse[i]));
    for (int i = 0; i < JOINT_ROWS; i++)
        if (fabs(impulse[i]) < TRACE * most) impulse[i] = 0;
}

static bool is_apart(const linkage *l, const linkage_group *g)
{
    for (int s = g->first; s < g->end; s++) {
        const joint_rows *r = &l->rows[l->step[s].joint];
        if (parted_by(&l->joint[l->step[s].joint], r) > CONTACT_DEEP * r->size)
            return true;
    }
    return false;
}

void linkage_begin(linkage *l, const linkage_pass *q)
{
    for (linkage_group *g = l->group; g < l->group + l->groups; g++) {
        g->is_jolted = is_apart(l, g);
        if (!g->is_jolted) begin_heavy(l, q, g);
    }
    if (l->is_driven) begin_drives(l, q);
    for (int k = 0; k < l->count; k++) {
        joint_rows *r = &l->rows[k];
        joint *j = &l->joint[k];
        if (j->kind == JOINT_NONE) continue;
        if (j->a >= 0) l->body[j->a].has_end = false;
        if (j->b >= 0) l->body[j->b].has_end = false;
        if (l->role[k] == JOINT_IDLE) continue;
        drop_traces(j->impulse);
        push_both(l, q, j, r, j->impulse);
    }
}

// As a share of a body's size: what missed by no more than this before it was
// solved misses by a hundredth of that after it.  Before the contacts push that is
// enough; after them it is looked at, and solved again if need be.  (A wild spin
// needs every solve: with one for all, a rod at 1000 rad/s gained forty times its
// energy.  A tenth of this saves as much; ten times as much, 3 % of a doll's time.)
static const real ROUGH = 1e-3;             // tuned, sizes

// What a body at the end of a substep has of angular momentum if it turns so (rad/s)
// about its centre.
static vec3 angular_of(const solver_body *x, vec3 spin)
{
    motion u = motion_make(&x->basis, (vec3){ 0, 0, 0 }, spin);
    return motion_angular(&x->basis, &u);
}

// A body of a group where it is, or where its joints bring it.
static const solver_body *placed_body(const linkage *l, const linkage_pass *q, int i,
                                      bool at_end)
{
    int b = l->order[i];
    return at_end ? &l->body[b].end : &q->f->body[b];
}

// As one body: its centre of mass (m), and its spin (rad/s).
typedef struct {
    vec3 center, spin;
} one_body;

static vec3 center_of_group(const linkage *l, const linkage_pass *q,
                            const linkage_group *g, bool at_end)
{
    vec3 sum = { 0, 0, 0 };
    real mass = 0;
    for (int i = g->first_body; i < g->end_body; i++) {
        const solver_body *x = placed_body(l, q, i, at_end);
        sum = vec3_add_scaled(sum, 1 / x->basis.inverse_mass, x->frame.center);
        mass += 1 / x->basis.inverse_mass;
    }
    return vec3_scale(1 / mass, sum);
}

// A group that has that angular momentum (kg m^2/s) as one body.
static one_body group_as_one(const linkage *l, const linkage_pass *q,
                             const linkage_group *g, bool at_end, vec3 angular)
{
    const vec3 axis[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    real inertia[JOINT_ROWS][JOINT_ROWS] = { { 0 } };
    vec3 center = center_of_group(l, q, g, at_end);
    for (int i = g->first_body; i < g->end_body; i++) {
        const solver_body *x = placed_body(l, q, i, at_end);
        vec3 r = vec3_sub(x->frame.center, center);
        for (int k = 0; k < 3; k++) {
            vec3 of = vec3_add_scaled(angular_of(x, axis[k]), 1 / x->basis.inverse_mass,
                                      vec3_cross(r, vec3_cross(axis[k], r)));
            inertia[k][0] += of.x, inertia[k][1] += of.y, inertia[k][2] += of.z;
        }
    }
    real spin[JOINT_ROWS] = { angular.x, angular.y, angular.z };
    small_invert(3, inertia);
    small_times(3, inertia, spin);
    return (one_body){ center, { spin[0], spin[1], spin[2] } };
}

static bool is_free_group(const linkage *l, const linkage_group *g)
{
    return l->rows[l->step[g->first].joint].is_free;
}

// What a body is heavier by is no other body's: what flies freely gets back, as one
// body, the angular momentum that this has kept from it.
static void give_back(const linkage *l, const linkage_pass *q,
                      const linkage_group *g)
{
    vec3 lost = { 0, 0, 0 };
    for (int i = g->first_body; i < g->end_body; i++) {
        const linkage_body *x = &l->body[l->order[i]];
        const real *now = q->velocity[l->order[i]].of + MOTION_TURN;
        motion less = { { 0 } };
        for (int t = 0; t < TURNS; t++)
            less.of[MOTION_TURN + t] = x->given[t] - x->kick[t] - (now[t] - x->then[t]);
        lost = vec3_add(lost, motion_angular(basis_of(q->f, l->order[i]), &less));
    }
    one_body all = group_as_one(l, q, g, false, lost);
    for (int i = g->first_body; i < g->end_body; i++) {
        const solver_body *x = placed_body(l, q, i, false);
        vec3 r = vec3_sub(x->frame.center, all.center);
        motion more = motion_make(&x->basis, vec3_cross(all.spin, r), all.spin);
        motion_add(&q->velocity[l->order[i]], &more);
    }
}

static void give_back_all(const linkage *l, const linkage_pass *q)
{
    for (const linkage_group *g = l->group; g < l->group + l->groups; g++)
        if (g->is_heavy && is_free_group(l, g)) give_back(l, q, g);
}

// A group that was moved aside of how it goes gets back what it lost by that: what
// flies freely keeps its momenta.
static void turn_group(linkage *l, const linkage_pass *q, const linkage_group *g)
{
    vec3 lost = { 0, 0, 0 };
    find_ends(l, q, g);
    for (int i = g->first_body; i < g->end_body; i++) {
        const linkage_body *x = &l->body[l->order[i]];
        lost = vec3_add_scaled(lost, q->f->h / x->end.basis.inverse_mass,
                               vec3_cross(motion_straight(&x->rest),
                                          motion_straight(&x->go)));
    }
    one_body all = group_as_one(l, q, g, true, lost);
    for (int i = g->first_body; i < g->end_body; i++) {
        linkage_body *x = &l->body[l->order[i]];
        vec3 r = vec3_sub(x->end.frame.center, all.center);
        motion_add_straight(&x->rest, 1, vec3_cross(all.spin, r));
        x->angular = vec3_add(x->angular, angular_of(&x->end, all.spin));
    }
}

// A group whose joints bring together what is far apart is jolted.  They bring it
// where it comes, and give it no speed for that: where it then is they only stop what
// would part it, as in an impact without restitution.  So a jolt keeps momentum, and
// never gives energy.
static void jolt_group(linkage *l, const linkage_pass *q, const linkage_group *g)
{
    for (int i = g->first_body; i < g->end_body; i++)
        l->body[l->order[i]].rest = q->velocity[l->order[i]];
    for (int s = g->first; s < g->end; s++) {
        int k = l->step[s].joint;
        real back[JOINT_ROWS] = { 0 };
        for (int i = 0; i < l->rows[k].held; i++) {
            back[i] = -l->joint[k].impulse[i];
            l->joint[k].impulse[i] = 0;
        }
        push_both(l, q, &l->joint[k], &l->rows[k], back);
    }
    for (int i = g->first_body; i < g->end_body; i++) {
        int b = l->order[i];
        linkage_body *x = &l->body[b];
        SWAP(motion, x->rest, q->velocity[b]);
        x->angular = motion_angular(basis_of(q->f, b), &x->rest);
    }
    if (is_free_group(l, g)) turn_group(l, q, g);
}

static void jolt_groups(linkage *l, const linkage_pass *q)
{
    for (const linkage_group *g = l->group; g < l->group + l->groups; g++) {
        if (g->is_jolted) jolt_group(l, q, g);
        for (int i = g->first_body; i < g->end_body; i++)
            l->body[l->order[i]].is_jolted = g->is_jolted;
    }
}

// Does a joint pull harder than is known of both its bodies?
static bool is_sudden(const linkage *l, const linkage_pass *q, const linkage_group *g)
{
    for (const linkage_step *s = l->step + g->first; s < l->step + g->end; s++) {
        real now = stiffness_of(&l->joint[s->joint], &l->rows[s->joint], q->f->h);
        real a = s->a < 0 ? HUGE_VAL : l->body[s->a].stiff;
        real b = s->b < 0 ? HUGE_VAL : l->body[s->b].stiff;
        if (now > real_max(real_min(a, b), 1)) return true;
    }
    return false;
}

static void settle_places(linkage *l, const linkage_pass *q, real rough)
{
    if (l->is_driven)
        settle_bounds(l, q, bias_driven_position, IMPACT_STEPS, rough);
    else                settle_bounds(l, q, bias_position, IMPACT_STEPS, rough);
}

// Returns whether some group was.
static bool stiffen_sudden(linkage *l, const linkage_pass *q)
{
    bool some = false;
    for (linkage_group *g = l->group; g < l->group + l->groups; g++) {
        if (g->is_jolted || !is_sudden(l, q, g)) continue;
        find_stiff(l, q, g);
        stiffen_group(l, q, g);
        some = true;
    }
    return some;
}

void linkage_push(linkage *l, const linkage_pass *q, bool is_last)
{
    real rough = is_last ? 0 : ROUGH;
    for (int k = 0; k < l->groups && is_last; k++) take_pushes(l, q, &l->group[k]);
    settle_places(l, q, rough);
    if (!is_last) return;
    for (int n = 0; n < IMPACT_STEPS && stiffen_sudden(l, q); n++)
        settle_places(l, q, 0);
    give_back_all(l, q);
    jolt_groups(l, q);
}
//<

//> linkage-break
//>   After the substep each joint knows its force. It says how fast its bodies
//>   swing, and breaks if the force is too great.
// A substep turns a body by 0.075 rad (FOLLOWED / TURN_PACE, substeps.c): how fast it
// turns, and would swing under its own weight, decides how exact its orbit is.  With
// this 7 of 27 thrown linkages (chapter 20, case 169) change their energy by more
// than a thousandth, with three quarters of it 10, and 4 of 36 conical pendulums
// (case 163) go round too fast.
static const real TURN_PACE = 8;            // tuned, 1

// Where something presses, energy goes, and no orbit is kept: half as exactly is
// enough.  (Half of that opens 4 joints under sudden loads for 1, case 166, and saves
// a heap of dolls 2 %; as exactly as in free flight it costs them 13 % more.)
static const real RUBBED = 4;               // tuned, 1

// rad/s: how fast a spin turns a direction, of any length.
static real turn_of_direction(vec3 spin, vec3 d)
{
    real all = vec3_length(d);
    return all > 0 ? vec3_length(vec3_cross(spin, d)) / all : 0;
}

// rad/s: how fast it turns what joint j holds of body b: the arm from its centre,
// and the axis of a hinge.  (What holds more than that holds three axes.)
static real turn_of_held(const linkage_pass *q, const joint *j, int b, vec3 spin)
{
    const rigid_frame *f = joined_frame(q, b);
    bool is_a = b == j->a, is_hinge = j->kind == JOINT_HINGE;
    bool is_point = j->kind == JOINT_DISTANCE
                 || (j->kind == JOINT_BALL && j->extra == 0);
    if (!is_hinge && !is_point) return vec3_length(spin);
    vec3 axis = is_a ? j->axis_a[0] : j->axis_b[0];
    vec3 at = is_a ? j->local_a : j->local_b;
    real arm = turn_of_direction(spin, frame_vector(f, at));
    real tilt = turn_of_direction(spin, frame_vector(f, axis));
    return is_hinge ? real_max(arm, tilt) : arm;
}

// rad/s, to be followed.  A free flywheel turns its axle, so all spin counts for
// its orbit.  Where something presses, only what it turns of the joint does: a wheel
// that rolls leaves its axle where it is.  The spin itself is always followed.
static real pace_of_spin(const linkage_pass *q, const joint *j, bool rubs, int b)
{
    if (!moves(q->f, b)) return 0;
    vec3 spin = motion_rotation(basis_of(q->f, b), &q->velocity[b]);
    if (!rubs) return TURN_PACE * vec3_length(spin);
    return real_max(vec3_length(spin), RUBBED * turn_of_held(q, j, b, spin));
}

static vec3 velocity_of(const linkage_pass *q, int b, vec3 at)
{
    if (!moves(q->f, b)) return (vec3){ 0, 0, 0 };
    return motion_at(basis_of(q->f, b), &q->velocity[b],
                     vec3_sub(at, joined_frame(q, b)->center));
}

// The way between two points that are kept at a distance turns, too; its bodies
// need not.  rad^2/s^2
static real swung_squared(const linkage_pass *q, const joint *j)
{
    vec3 a, b;
    if (j->kind != JOINT_DISTANCE || j->is_driven || !(j->force > 0)) return 0;
    joint_points(j, joined_frame(q, j->a), joined_frame(q, j->b), &a, &b);
    vec3 delta = vec3_sub(b, a);
    vec3 speed = vec3_sub(velocity_of(q, j->b, b), velocity_of(q, j->a, a));
    real most = j->most * j->most;
    vec3 across = vec3_cross(delta, speed);
    return most > 0 ? vec3_length_squared(across) / (most * most) : 0;
}

// What no pull moves holds a body's whole weight, even before a joint has felt it.
// A tree that falls has none: there a body swings only as its joint pulls.
static real weighs(const joint_rows *r, real swing)
{
    return r->is_free ? real_min(r->hung, swing) : r->hung;
}

static void break_overloaded(linkage *l, const linkage_pass *q)
{
    real h = q->f->h;
    l->swing = 0;
    for (int k = 0; k < l->count; k++) {
        joint *j = &l->joint[k];
        if (l->role[k] == JOINT_IDLE) continue;
        j->force = force_of(j, &l->rows[k], h);
        if (j->is_driven) j->given = j->impulse[l->rows[k].held] / l->rows[k].kick;
        real swing = sqrt(j->force * l->rows[k].swing);
        bool rubs = l->rows[k].rubs;
        real turns = sqrt(swung_squared(q, j)), hung = weighs(&l->rows[k], swing);
        swing = real_max(swing, pace_of_spin(q, j, rubs, j->a));
        swing = real_max(swing, pace_of_spin(q, j, rubs, j->b));
        real exactly = rubs ? RUBBED : TURN_PACE;
        swing = real_max(swing, exactly * real_max(turns, hung));
        l->rows[k].pace = real_max(l->rows[k].pace, swing);
        l->swing = real_max(l->swing, swing);
        expect(j, &l->rows[k]);
        if (!(j->force > j->strength)) continue;
        j->is_broken = l->is_stale = true;
        l->role[k] = JOINT_IDLE;
        l->broken++;
    }
}

void linkage_relax(linkage *l, const linkage_pass *q)
{
    if (l->count == 0) return;
    for (int k = 0; k < l->count; k++)
        memcpy(l->rows[k].pushed, l->joint[k].impulse, sizeof l->rows->pushed);
    find_rows(l, q);
    end_heavy(l);
    if (l->is_driven)   settle_bounds(l, q, bias_driven_velocity, 1, 0);
    else                settle_bounds(l, q, bias_velocity, 1, 0);
    find_speeds(l, q);
    break_overloaded(l, q);
    if (l->is_stale) begin_roles(l, q);
}
//<
