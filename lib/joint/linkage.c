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
    void *owned[] = { l->joint, l->rows, l->group, l->member, l->order, l->link,
                      l->body, l->apart, l->tied };
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
        TABLE_GROW(ok, l->group, n, room);
        TABLE_GROW(ok, l->member, n, room);
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

static void find_ends_of(linkage *l, const linkage_pass *q, const joint *j)
{
    find_end(l, q, j->a);
    find_end(l, q, j->b);
}

// Where its joints bring it; after a jolt it goes as without them.
void linkage_advance(linkage *l, const linkage_pass *q, int b, solver_body *now)
{
    linkage_body *x = &l->body[b];
    find_end(l, q, b);
    *now = x->end;
    x->has_end = false;
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
    for (int k = 0; k < rows; k++) {
        real sum = 0;
        for (int i = 0; i < MOTIONS; i++) sum += row[k][i] * velocity[i];
        speed[k] -= sum;
    }
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

// Most joints have three rows, and loops of a known length are quicker.
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
//>   wanted differs, so all that follows is told which it is (`at_end`).
// How fast a joint's errors must change.  A body that turns takes a point along
// an arc: where the points will be at the end of the substep is looked up.
static void want_at_end(const linkage *l, const linkage_pass *q, int number,
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

ALWAYS_INLINE void stop(int n, const linkage_pass *q, const joint *j, joint_rows *r,
                        real want[JOINT_ROWS])
{
    if (moves(q->f, j->a)) take_speed(want, n, r->a, q->velocity[j->a].of);
    if (moves(q->f, j->b)) take_speed(want, n, r->b, q->velocity[j->b].of);
}

static void want_to_stop(const linkage_pass *q, const joint *j, joint_rows *r,
                         real want[JOINT_ROWS])
{
    int rows = r->held + j->is_limited;
    for (int k = 0; k < rows; k++) want[k] = 0;
    if (j->is_limited && r->error[r->held] > 0)
        want[r->held] = -r->error[r->held] / q->f->h;
    if (rows == 3)  stop(3, q, j, r, want);
    else            stop(rows, q, j, r, want);
}

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

// What the rows of a joint want that are no plain ones.
static void want_of_extra(const linkage_pass *q, const joint *j, joint_rows *r,
                          const real *then, real want[JOINT_ROWS])
{
    real h = q->f->h, rate = q->f->joint_rate, speed[3];
    for (int i = 0; i < j->extra; i++)
        speed[i] = then ? 0 : speed_along(q, j, r, r->held + i);
    for (int i = 0; i < 2 && j->is_coned; i++)
        want[r->held + i] = actuator_bias_cone(j, r, i, h, rate,
                                               then ? &then[r->held + i] : NULL,
                                               speed[i]);
    if (j->friction > 0) bias_friction(q, j, r, want);
    if (j->is_driven)
        want[r->held] = actuator_bias(j, r, h, rate, then ? &then[r->held] : NULL,
                                      speed[0]);
}

// What the impulses of a joint should change: at the end of the substep its errors, or
// now its speeds.
static void find_want(linkage *l, const linkage_pass *q, int number, bool at_end,
                      real want[JOINT_ROWS])
{
    const joint *j = &l->joint[number];
    joint_rows *r = &l->rows[number];
    real then[JOINT_ROWS];
    if (at_end) want_at_end(l, q, number, then, want);
    else        want_to_stop(q, j, r, want);
    if (j->extra > 0) want_of_extra(q, j, r, at_end ? then : NULL, want);
}

// How fast driven joints go when a substep begins.
static void find_speeds(linkage *l, const linkage_pass *q)
{
    for (int m = 0; m < l->members; m++) {
        const joint *j = &l->joint[l->member[m]];
        joint_rows *r = &l->rows[l->member[m]];
        if (j->is_driven) r->before = speed_along(q, j, r, r->held);
    }
}

// How hard springs and motors find it to move, for a frame.
static void find_inverses(linkage *l, const linkage_pass *q)
{
    for (int m = 0; m < l->members; m++) {
        joint *j = &l->joint[l->member[m]];
        if (!j->is_driven) continue;
        j->drive.inverse = actuator_inverse(&l->rows[l->member[m]],
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

static void begin_extra(const linkage_pass *q, joint *j, joint_rows *r)
{
    if (j->friction > 0) begin_friction(q, j, r);
    if (j->is_driven) actuator_begin(j, r, q->f->h, kick_of(q, j));
}
//<

//> linkage-limit
//>   The active set changes here: a limit that pulls is dropped, and a limit
//>   that is passed is added.
// A limit only pushes, as a contact does.  While it does it is one row more;
// where it would pull, or is not reached, it is none.  Returns whether that has
// changed.
static void push_more(linkage *l, const linkage_pass *q, int number, bool at_end,
                      const real more[JOINT_ROWS])
{
    joint *j = &l->joint[number];
    joint_rows *r = &l->rows[number];
    push_both(l, q, j, r, more);
    for (int k = 0; k < JOINT_ROWS; k++) {
        j->impulse[k] += more[k];
        if (more[k] != 0) r->since[k] = 0;
    }
    if (at_end) find_ends_of(l, q, j);
}

static bool switch_drive(linkage *l, const linkage_pass *q, int number, bool at_end)
{
    joint *j = &l->joint[number];
    joint_rows *r = &l->rows[number];
    real want[JOINT_ROWS], more[JOINT_ROWS] = { 0 };
    find_want(l, q, number, at_end, want);
    bool has_changed = j->is_driven && actuator_switch(j, r, &more[r->held]);
    if (j->is_coned)     has_changed |= actuator_switch_cone(j, r, more);
    if (j->friction > 0) has_changed |= actuator_switch_friction(j, r, more);
    if (has_changed) push_more(l, q, number, at_end, more);
    return has_changed;
}

static bool switch_limit(linkage *l, const linkage_pass *q, int number, bool at_end)
{
    joint *j = &l->joint[number];
    joint_rows *r = &l->rows[number];
    real want[JOINT_ROWS], back[JOINT_ROWS] = { 0 };
    int k = r->held;
    bool pushes = r->count > k;
    if (j->extra > 0) return switch_drive(l, q, number, at_end);
    if (!j->is_limited) return false;
    if (pushes && !(j->impulse[k] < 0)) return false;
    if (pushes) {
        back[k] = -j->impulse[k];
        push_more(l, q, number, at_end, back);
    } else {
        find_want(l, q, number, at_end, want);
        if (!(want[k] > 0)) return false;
    }
    r->since[k] = 0;
    r->count = k + !pushes;
    return true;
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
    x->first = x->place = -1;
    x->is_jolted = x->is_heavy = false;
    x->seen = l->frames;
}

// Is it solved now?  One of its bodies must yield, or its impulses would grow in every
// substep.
static bool is_solved(const linkage_pass *q, const joint *j)
{
    return joint_holds(j) && j->kind != JOINT_PIN
        && (yields(q->f, j->a) || yields(q->f, j->b))
        && (!q->rung || q->rung[yielding(q->f, j)] == q->of);
}

static void add_to_list(linkage *l, const linkage_pass *q, int b, int k)
{
    if (!moves(q->f, b)) return;
    *next_of(l, k, b) = l->body[b].first;
    l->body[b].first = k;
}
//<

//> linkage-order
//>   The joints of a body are eliminated before those that are nearer to the root: so
//>   in a tree each waits for all that hangs on it.
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

// The joints of its bodies, from the furthest body inwards.  Returns where they end.
static int order_joints(linkage *l, const linkage_pass *q, const linkage_group *g)
{
    int end = g->first;
    for (int i = g->end_body - 1; i >= g->first_body; i--) {
        int b = l->order[i];
        for (int k = l->body[b].first; k >= 0; k = *next_of(l, k, b)) {
            int on = other_end(&l->joint[k], b);
            if (moves(q->f, on) && l->body[on].place > i) continue;
            l->rows[k].place = end;
            l->rows[k].link = -1;
            l->member[end++] = k;
        }
    }
    return end;
}
//<

//> linkage-front
// So many links a joint of a group may have, in the mean.  In a chain it has one, in a
// ring two, and the work grows with their square.  What has more is solved joint by joint.
enum { LINKS_MOST = 16 };                   // tuned, links

// The link of joint a to one that is eliminated later, or where it belongs in the list
// of a, which is in the order of elimination.
static int *link_at(linkage *l, int a, int b)
{
    int *k = &l->rows[a].link;
    while (*k >= 0 && l->rows[l->link[*k].joint].place < l->rows[b].place)
        k = &l->link[*k].next;
    return k;
}

// False if memory is refused.
static bool add_link(linkage *l, int a, int b)
{
    if (l->rows[a].place > l->rows[b].place) SWAP(int, a, b);
    if (!TABLE_ADD(l->link, l->links, l->link_room)) return false;
    int *k = link_at(l, a, b);
    if (*k >= 0 && l->link[*k].joint == b) return true;
    l->link[l->links] = (linkage_link){ .joint = b, .next = *k };
    *k = l->links++;
    return true;
}

// Joints of one body move each other.  Once a joint is eliminated, so do all that it
// moves.  False if they are too many.
static bool add_links(linkage *l, const linkage_group *g)
{
    int most = l->links + LINKS_MOST * (g->end - g->first);
    bool ok = true;
    for (int i = g->first_body; i < g->end_body; i++) {
        int b = l->order[i];
        for (int k = l->body[b].first; k >= 0; k = *next_of(l, k, b))
            for (int m = *next_of(l, k, b); m >= 0 && ok; m = *next_of(l, m, b))
                ok = add_link(l, k, m) && l->links <= most;
    }
    for (int i = g->first; i < g->end; i++)
        for (int p = l->rows[l->member[i]].link; p >= 0; p = l->link[p].next)
            for (int s = l->link[p].next; s >= 0 && ok; s = l->link[s].next)
                ok = add_link(l, l->link[p].joint, l->link[s].joint)
                  && l->links <= most;
    return ok;
}

// What is too wide has no links.
static void add_group(linkage *l, const linkage_pass *q, int b)
{
    int bodies = l->groups ? l->group[l->groups - 1].end_body : 0, links = l->links;
    linkage_group g = { .first = l->members, .first_body = bodies };
    g.end_body = order_group(l, q, b, bodies);
    l->members = g.end = order_joints(l, q, &g);
    g.is_wide = l->is_plain || !add_links(l, &g);
    if (g.is_wide) l->links = links;
    for (int i = g.first; i < g.end && g.is_wide; i++) l->rows[l->member[i]].link = -1;
    l->group[l->groups++] = g;
}

static void reset_bodies(linkage *l)
{
    for (int k = 0; k < l->count; k++) {
        if (!joint_holds(&l->joint[k])) continue;
        reset_body(l, l->joint[k].a);
        reset_body(l, l->joint[k].b);
    }
}

static void find_groups(linkage *l, const linkage_pass *q)
{
    l->groups = l->members = l->links = 0;
    l->is_stale = false;
    reset_bodies(l);
    for (int k = l->count - 1; k >= 0; k--) {
        if (!is_solved(q, &l->joint[k])) continue;
        add_to_list(l, q, l->joint[k].a, k);
        add_to_list(l, q, l->joint[k].b, k);
    }
    for (int k = 0; k < l->count; k++) {
        const joint *j = &l->joint[k];
        int b = moves(q->f, j->a) ? j->a : j->b;
        if (is_solved(q, j) && l->body[b].place < 0) add_group(l, q, b);
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

//> linkage-give
//>   By how much a joint gives way.
// A joint gives way as a spring does, by a share of its own K in a substep.  It
// must: where bodies form a ring, or hang between two walls, some rows say the
// same twice, and a joint without any give would bear whatever rounding says.
static const real GIVE = 1e-4;              // tuned, of K

// Those that stand alone are springs, critically damped, or passes would not bring
// them to terms: such a one turns by so much in a substep.  Half of it lets a net of
// 400 balls hang open by four radii; with double it gains a tenth of its energy.
static const real TURN_ALONE = 1.8;         // tuned, rad
#define GIVE_ALONE (1 / (TURN_ALONE * (2 + TURN_ALONE)))
//<

//> linkage-factor
// How body b moves after unit impulses along the rows.
static void find_answers(const linkage *l, const linkage_pass *q, int n, int b,
                         real (*row)[MOTIONS], real (*answer)[MOTIONS])
{
    bool is_heavy = moves(q->f, b) && l->body[b].is_heavy;
    real inverse = basis_of(q->f, b)->inverse_mass;
    for (int k = 0; k < n; k++) {
        memcpy(answer[k], row[k], sizeof answer[k]);
        for (int i = 0; i < MOTION_TURN; i++) answer[k][i] *= inverse;
        for (int t = 0; t < TURNS && is_heavy; t++) {
            real sum = 0;
            for (int i = 0; i < TURNS; i++)
                sum += l->body[b].light[t][i] * row[k][MOTION_TURN + i];
            answer[k][MOTION_TURN + t] = sum;
        }
    }
}

// k += row answer^T
ALWAYS_INLINE void couple_rows(real (*k)[JOINT_ROWS], int n, real (*row)[MOTIONS], int m,
                               real (*answer)[MOTIONS])
{
    for (int i = 0; i < n; i++)
        for (int c = 0; c < m; c++) {
            real sum = 0;
            for (int d = 0; d < MOTIONS; d++) sum += row[i][d] * answer[c][d];
            k[i][c] += sum;
        }
}

static void add_couplings(real (*k)[JOINT_ROWS], int n, real (*row)[MOTIONS], int m,
                          real (*answer)[MOTIONS])
{
    if (n == 3 && m == 3)   couple_rows(k, 3, row, 3, answer);
    else                    couple_rows(k, n, row, m, answer);
}

// A row that does not hold now gives nothing, and is moved by nothing.
static void open_row(joint_rows *r, int k)
{
    for (int i = 0; i < r->count; i++) r->inverse[k][i] = r->inverse[i][k] = 0;
    memset(r->answer_a[k], 0, sizeof r->answer_a[k]);
    memset(r->answer_b[k], 0, sizeof r->answer_b[k]);
}

// K of a joint, and the share of it by which its rows give.
static void begin_matrix(linkage *l, const linkage_pass *q, int number, real give)
{
    const joint *j = &l->joint[number];
    joint_rows *r = &l->rows[number];
    int n = r->count;
    find_answers(l, q, n, j->a, r->a, r->answer_a);
    find_answers(l, q, n, j->b, r->b, r->answer_b);
    memset(r->inverse, 0, sizeof r->inverse);
    add_couplings(r->inverse, n, r->a, n, r->answer_a);
    add_couplings(r->inverse, n, r->b, n, r->answer_b);
    for (int k = 0; k < n; k++) r->give[k] = give * r->inverse[k][k];
    if (j->extra > 0) actuator_soften(j, r);
    for (int k = 0; k < n; k++) {
        r->inverse[k][k] += r->give[k];
        if (r->give[k] == 0) open_row(r, k);
    }
}

// How a joint moves another one by the bodies that they have in common.
static void begin_link(linkage *l, int number, linkage_link *x)
{
    const joint *j = &l->joint[number], *o = &l->joint[x->joint];
    joint_rows *r = &l->rows[number], *s = &l->rows[x->joint];
    memset(x->of, 0, sizeof x->of);
    if (j->a == o->a) add_couplings(x->of, r->count, r->a, s->count, s->answer_a);
    if (j->a == o->b) add_couplings(x->of, r->count, r->a, s->count, s->answer_b);
    if (j->b == o->a) add_couplings(x->of, r->count, r->b, s->count, s->answer_a);
    if (j->b == o->b) add_couplings(x->of, r->count, r->b, s->count, s->answer_b);
}

// to += a^T b, of n rows of a and b.
ALWAYS_INLINE void multiply_add(real (*to)[JOINT_ROWS], int n, int rows,
                                real (*a)[JOINT_ROWS], int columns,
                                real (*b)[JOINT_ROWS])
{
    for (int i = 0; i < rows; i++)
        for (int c = 0; c < columns; c++) {
            real sum = to[i][c];
            for (int k = 0; k < n; k++) sum += a[k][i] * b[k][c];
            to[i][c] = sum;
        }
}

static void add_block(real (*to)[JOINT_ROWS], int n, int rows, real (*a)[JOINT_ROWS],
                        int columns, real (*b)[JOINT_ROWS])
{
    if (n == 3 && rows == 3 && columns == 3)    multiply_add(to, 3, 3, a, 3, b);
    else                                        multiply_add(to, n, rows, a, columns, b);
}

// A joint is eliminated: what it gives is known but for what those give that it moves,
// and all of these answer less, by what it holds back.
static void eliminate_joint(linkage *l, joint_rows *r)
{
    int n = r->count;
    small_invert(n, r->inverse);
    for (int s = r->link; s >= 0; s = l->link[s].next) {
        linkage_link *x = &l->link[s];
        joint_rows *y = &l->rows[x->joint];
        real back[JOINT_ROWS][JOINT_ROWS] = { { 0 } };
        add_block(back, n, n, r->inverse, y->count, x->of);
        for (int i = 0; i < n; i++)
            for (int c = 0; c < y->count; c++) back[i][c] = -back[i][c];
        add_block(y->inverse, n, y->count, back, y->count, x->of);
        for (int p = x->next, to = y->link; p >= 0; p = l->link[p].next) {
            while (l->link[to].joint != l->link[p].joint) to = l->link[to].next;
            add_block(l->link[to].of, n, y->count, back,
                        l->rows[l->link[p].joint].count, l->link[p].of);
        }
        memcpy(x->of, back, sizeof back);
    }
}

static void factor_group(linkage *l, const linkage_pass *q, linkage_group *g)
{
    g->has_three = true;
    for (int i = g->first; i < g->end; i++) {
        begin_matrix(l, q, l->member[i], g->is_wide ? GIVE_ALONE : GIVE);
        g->has_three &= l->rows[l->member[i]].count == 3;
    }
    for (int i = g->first; i < g->end; i++)
        for (int p = l->rows[l->member[i]].link; p >= 0; p = l->link[p].next)
            begin_link(l, l->member[i], &l->link[p]);
    for (int i = g->first; i < g->end; i++) eliminate_joint(l, &l->rows[l->member[i]]);
}
//<

//> linkage-solve
//>   And here are the two walks. The bodies get impulses, each A's and its opposite
//>   B's, so momentum stays to rounding, however inexact the matrices are.
// A joint has n rows, or with n = 0 as many as it says.
ALWAYS_INLINE int rows_of(int n, const joint_rows *r)
{
    return n ? n : r->count;
}

// What a joint wants, as if no joint that comes later held its bodies: of that those
// have their part already.
static inline void solve_inward(int n, linkage *l, const joint_rows *r)
{
    for (int p = r->link; p >= 0; p = l->link[p].next) {
        const linkage_link *x = &l->link[p];
        joint_rows *y = &l->rows[x->joint];
        for (int i = 0; i < rows_of(n, r); i++)
            for (int c = 0; c < rows_of(n, y); c++)
                y->want[c] += x->of[i][c] * r->want[i];
    }
}

// Now it is known what the later joints give, and so what this one does.
static inline void solve_outward(int n, const linkage *l, joint_rows *r)
{
    small_times(rows_of(n, r), r->inverse, r->want);
    for (int p = r->link; p >= 0; p = l->link[p].next) {
        const linkage_link *x = &l->link[p];
        const joint_rows *y = &l->rows[x->joint];
        for (int i = 0; i < rows_of(n, r); i++)
            for (int c = 0; c < rows_of(n, y); c++)
                r->want[i] += x->of[i][c] * y->want[c];
    }
}

ALWAYS_INLINE void give_joint(int rows, linkage *l, const linkage_pass *q, int number)
{
    joint *j = &l->joint[number];
    joint_rows *r = &l->rows[number];
    int n = rows_of(rows, r);
    for (int k = 0; k < n; k++) {
        j->impulse[k] += r->want[k];
        r->since[k] += r->want[k];
    }
    if (moves(q->f, j->a)) drive_by(l->body[j->a].impulse, n, r->a, r->want);
    if (moves(q->f, j->b)) drive_by(l->body[j->b].impulse, n, r->b, r->want);
}

ALWAYS_INLINE void walk_group(int n, linkage *l, const linkage_pass *q,
                              const linkage_group *g)
{
    for (int i = g->first; i < g->end; i++) solve_inward(n, l, &l->rows[l->member[i]]);
    for (int i = g->end - 1; i >= g->first; i--)
        solve_outward(n, l, &l->rows[l->member[i]]);
    for (int i = g->first; i < g->end; i++) give_joint(n, l, q, l->member[i]);
}

static void solve_group(linkage *l, const linkage_pass *q, const linkage_group *g)
{
    for (int i = g->first_body; i < g->end_body; i++)
        memset(l->body[l->order[i]].impulse, 0, sizeof l->body->impulse);
    if (g->has_three)   walk_group(3, l, q, g);
    else                walk_group(0, l, q, g);
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
static void take_back(linkage *l, const linkage_pass *q, const linkage_group *g,
                      bool at_end)
{
    for (int m = g->first; m < g->end; m++) {
        int k = l->member[m];
        real back[JOINT_ROWS];
        for (int i = 0; i < JOINT_ROWS; i++) {
            back[i] = -l->rows[k].since[i];
            l->rows[k].since[i] = 0;
            l->joint[k].impulse[i] += back[i];
        }
        push_both(l, q, &l->joint[k], &l->rows[k], back);
    }
    if (at_end) find_ends(l, q, g);
}

static bool switch_limits(linkage *l, const linkage_pass *q, const linkage_group *g,
                          bool at_end)
{
    bool has_changed = false;
    for (int m = g->first; m < g->end; m++)
        has_changed |= switch_limit(l, q, l->member[m], at_end);
    if (has_changed) take_back(l, q, g, at_end);
    return has_changed;
}

// Returns by how much the worst joint will miss it, as a share of its size.
static real find_wants(linkage *l, const linkage_pass *q, const linkage_group *g,
                       bool at_end)
{
    real worst = 0;
    for (int m = g->first; m < g->end; m++) {
        joint_rows *r = &l->rows[l->member[m]];
        find_want(l, q, l->member[m], at_end, r->want);
        for (int i = 0; i < r->count; i++) {
            real size = i < r->lengths ? r->size : 1;
            worst = real_max(fabs(r->want[i]) / size, worst);
        }
    }
    return q->f->h * worst;
}

// A joint by itself, as in the exercise of chapter 13.
static void solve_alone(linkage *l, const linkage_pass *q, int number, bool at_end)
{
    joint_rows *r = &l->rows[number];
    if (at_end) find_ends_of(l, q, &l->joint[number]);
    for (int n = 0; n < 2; n++) {
        real more[JOINT_ROWS] = { 0 };
        find_want(l, q, number, at_end, more);
        small_times(r->count, r->inverse, more);
        push_more(l, q, number, at_end, more);
        if (!switch_limit(l, q, number, at_end)) return;
        begin_matrix(l, q, number, GIVE_ALONE);
        eliminate_joint(l, r);
    }
}

// What is wide is solved joint by joint, every other time last to first.
static void sweep_group(linkage *l, const linkage_pass *q, linkage_group *g,
                        bool at_end)
{
    if (!g->is_ready) factor_group(l, q, g);
    g->is_ready = true;
    for (int n = 0; n < g->end - g->first; n++)
        solve_alone(l, q, l->member[l->is_backward ? g->end - 1 - n : g->first + n],
                    at_end);
}

// Solved once, and again while a joint will miss what it wants by too much, and each
// solve comes nearer.
static void settle_group(linkage *l, const linkage_pass *q, linkage_group *g,
                         bool at_end, int rounds, real rough)
{
    real before = 0;
    for (int m = g->first; m < g->end && g->is_limited; m++)
        memset(l->rows[l->member[m]].since, 0, sizeof l->rows->since);
    for (int n = 0; n < rounds + IMPACT_STEPS; n++) {
        if (n >= rounds && !g->is_limited) return;
        bool is_known = at_end && find_ends(l, q, g);
        if (is_known && g->is_settled) return;
        bool has_changed = g->is_limited && switch_limits(l, q, g, at_end);
        real missed = find_wants(l, q, g, at_end);
        bool is_settled = (n > 0 || g->is_solved) && missed <= MISS;
        bool is_nearer = n == 0 || has_changed || missed < before;
        g->is_settled = (is_settled || !is_nearer) && at_end;
        if (!has_changed && (is_settled || n >= rounds || !is_nearer)) return;
        before = missed;
        if (has_changed || !g->is_ready) factor_group(l, q, g);
        g->is_ready = true;
        g->is_solved = at_end;
        solve_group(l, q, g);
        if (missed <= rough && !g->is_limited) return;
    }
}

static void settle(linkage *l, const linkage_pass *q, bool at_end, real rough)
{
    l->is_backward = !l->is_backward;
    for (linkage_group *g = l->group; g < l->group + l->groups; g++)
        if (g->is_wide) sweep_group(l, q, g, at_end);
        else            settle_group(l, q, g, at_end, at_end ? IMPACT_STEPS : 1, rough);
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
    for (int m = g->first; m < g->end; m++) {
        const joint *j = &l->joint[l->member[m]];
        real more = stiffness_of(j, &l->rows[l->member[m]], q->f->h);
        if (moves(q->f, j->a)) some |= (l->body[j->a].stiff += more) > 1;
        if (moves(q->f, j->b)) some |= (l->body[j->b].stiff += more) > 1;
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
    for (int m = g->first; m < g->end; m++) {
        const joint *j = &l->joint[l->member[m]];
        const joint_rows *r = &l->rows[l->member[m]];
        joint_points(j, joined_frame(q, j->a), joined_frame(q, j->b), &a, &b);
        if (moves(q->f, j->a)) add_stiffness(q, &l->body[j->a], j->a, a,
                                             straight_impulse(j, r, r->a));
        if (moves(q->f, j->b)) add_stiffness(q, &l->body[j->b], j->b, b,
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

static void find_rows_of(linkage *l, const linkage_pass *q, int k, bool is_wide)
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
    if (is_wide)
        r->fraction = real_min(r->fraction, TURN_ALONE / (2 + TURN_ALONE));
    l->worst = real_max(l->worst, parted_by(j, r));
    l->parted += parted_by(j, r) > STRAINED * r->size || tilted_by(r) > STRAINED;
}

static void find_rows(linkage *l, const linkage_pass *q)
{
    l->worst = 0;
    l->parted = 0;
    for (linkage_group *g = l->group; g < l->group + l->groups; g++) {
        g->is_ready = g->is_solved = g->is_settled = false;
        for (int m = g->first; m < g->end; m++)
            find_rows_of(l, q, l->member[m], g->is_wide);
    }
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

// What of a joint stays for a frame.
static void find_size(linkage *l, const linkage_pass *q, int k)
{
    const joint *j = &l->joint[k];
    joint_rows *r = &l->rows[k];
    real a = swing_of(q, j->a, j->local_a), b = swing_of(q, j->b, j->local_b);
    r->swing = real_max(a, b);
    r->hung = real_max(hung_swing(q, j->a, a), hung_swing(q, j->b, b));
    r->size = real_min(joined_size(q, j->a), joined_size(q, j->b));
}

// And of a group: has it limits?  Does what no pull moves hold it?
static void find_sizes(linkage *l, const linkage_pass *q)
{
    for (linkage_group *g = l->group; g < l->group + l->groups; g++) {
        bool is_free = true;
        for (int m = g->first; m < g->end; m++) {
            const joint *j = &l->joint[l->member[m]];
            find_size(l, q, l->member[m]);
            g->is_limited |= j->is_limited || j->extra > 0;
            is_free &= yields(q->f, j->a) && yields(q->f, j->b);
        }
        for (int m = g->first; m < g->end; m++) l->rows[l->member[m]].is_free = is_free;
    }
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

static void scale_joint(linkage *l, int k, real times)
{
    for (int i = 0; i < JOINT_ROWS; i++) {
        l->joint[k].impulse[i] *= times;
        l->rows[k].older[i] *= times;
    }
}

void linkage_scale(linkage *l, real times)
{
    for (int m = 0; m < l->members; m++) scale_joint(l, l->member[m], times);
}

// Impulses of a substep of another length become those of this one.
static void warm(linkage *l, const linkage_pass *q)
{
    const solver_frame *f = q->f;
    for (int k = 0; k < l->count; k++)
        if (l->joint[k].kind == JOINT_PIN) l->rows[k].pace = 0;
    for (int m = 0; m < l->members; m++) {
        int k = l->member[m], b = yielding(f, &l->joint[k]);
        l->rows[k].pace = 0;
        scale_joint(l, k, f->age ? f->warm * f->h / f->age[b] : f->warm);
    }
}

// Groups, sizes, rows: where the bodies stand now.
static void begin_groups(linkage *l, const linkage_pass *q)
{
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
    find_groups(l, q);
    begin_groups(l, q);
}

void linkage_prepare(linkage *l, const linkage_pass *q)
{
    if (l->count == 0) return;
    l->frames++;
    find_groups(l, q);
    warm(l, q);
    begin_groups(l, q);
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
    for (int m = g->first; m < g->end && !g->is_wide; m++) {
        const joint_rows *r = &l->rows[l->member[m]];
        if (parted_by(&l->joint[l->member[m]], r) > CONTACT_DEEP * r->size) return true;
    }
    return false;
}

void linkage_begin(linkage *l, const linkage_pass *q)
{
    for (linkage_group *g = l->group; g < l->group + l->groups; g++) {
        g->is_jolted = is_apart(l, g);
        if (!g->is_jolted && !g->is_wide) begin_heavy(l, q, g);
    }
    for (int m = 0; m < l->members; m++) {
        joint *j = &l->joint[l->member[m]];
        joint_rows *r = &l->rows[l->member[m]];
        if (j->extra > 0) begin_extra(q, j, r);
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
    return l->rows[l->member[g->first]].is_free;
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
    for (int m = g->first; m < g->end; m++) {
        int k = l->member[m];
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
    for (int m = g->first; m < g->end; m++) {
        const joint *j = &l->joint[l->member[m]];
        real now = stiffness_of(j, &l->rows[l->member[m]], q->f->h);
        real a = moves(q->f, j->a) ? l->body[j->a].stiff : HUGE_VAL;
        real b = moves(q->f, j->b) ? l->body[j->b].stiff : HUGE_VAL;
        if (now > real_max(real_min(a, b), 1)) return true;
    }
    return false;
}

// Returns whether some group was.
static bool stiffen_sudden(linkage *l, const linkage_pass *q)
{
    bool some = false;
    for (linkage_group *g = l->group; g < l->group + l->groups; g++) {
        if (g->is_jolted || g->is_wide || !is_sudden(l, q, g)) continue;
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
    settle(l, q, true, rough);
    if (!is_last) return;
    for (int n = 0; n < IMPACT_STEPS && stiffen_sudden(l, q); n++)
        settle(l, q, true, 0);
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
    for (int m = 0; m < l->members; m++) {
        int k = l->member[m];
        joint *j = &l->joint[k];
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
        l->broken++;
    }
}

void linkage_relax(linkage *l, const linkage_pass *q)
{
    if (l->count == 0) return;
    for (int m = 0; m < l->members; m++)
        memcpy(l->rows[l->member[m]].pushed, l->joint[l->member[m]].impulse,
               sizeof l->rows->pushed);
    find_rows(l, q);
    end_heavy(l);
    settle(l, q, false, 0);
    find_speeds(l, q);
    break_overloaded(l, q);
    if (!l->is_stale) return;
    find_groups(l, q);
    begin_groups(l, q);
}
//<
