//> linkage-add
//>   Joints come and go between frames. The place of one that has gone is used
//>   again: a program may add and remove joints for hours, and needs no more
//>   memory. Joined bodies are taken out of the list of pairs that may meet.
#include "linkage.h"
#include "table.h"

#include <assert.h>

void linkage_free(linkage *l)
{
    void *owned[] = { l->joint, l->rows, l->role, l->step, l->body,
                      l->apart, l->tied };
    for (size_t i = 0; i < sizeof owned / sizeof *owned; i++) free(owned[i]);
    *l = (linkage){ .count = 0 };
}

static bool make_room(linkage *l, const joint *j)
{
    int n = l->count, room = table_room(n + 1, l->capacity);
    int need = 1 + int_max(j->a, j->b), bodies = table_room(need, l->bodies);
    if (room > l->capacity) {
        if (!table_grow(&l->joint, n, room, sizeof *l->joint)
            || !table_grow(&l->rows, n, room, sizeof *l->rows)
            || !table_grow(&l->role, n, room, sizeof *l->role)
            || !table_grow(&l->step, 2 * n, 2 * room, sizeof *l->step)
            || !table_grow(&l->apart, n, room, sizeof *l->apart))
            return false;
        l->capacity = room;
    }
    int ties = table_room(l->ties + 1, l->tie_room);
    if (ties > l->tie_room) {
        if (!table_grow(&l->tied, l->ties, ties, sizeof *l->tied))
            return false;
        l->tie_room = ties;
    }
    if (bodies > l->bodies) {
        if (!table_grow(&l->body, l->bodies, bodies, sizeof *l->body))
            return false;
        l->bodies = bodies;
    }
    return true;
}

static bool holds(const joint *j)
{
    return j->kind != JOINT_NONE && !j->is_broken;
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
        if (j->kind != JOINT_PIN || !holds(j) || j->may_touch || j->b < 0)
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
static int free_place(const linkage *l)
{
    int k = l->gone > 0 ? 0 : l->count;
    while (k < l->count && l->joint[k].kind != JOINT_NONE) k++;
    return k;
}

status linkage_add(linkage *l, const joint *j, int *number)
{
    if (!make_room(l, j)) return status_out_of_memory();
    int k = free_place(l);
    if (k < l->count)   l->gone--;
    else                l->count++;
    if (number) *number = k;
    l->joint[k] = *j;
    l->rows[k] = (joint_rows){ .count = 0 };
    l->role[k] = JOINT_IDLE;
    linkage_count_pins(l);
    return status_ok();
}

void linkage_remove(linkage *l, int number)
{
    assert(number >= 0 && number < l->count);
    assert(l->joint[number].kind != JOINT_NONE);
    l->joint[number] = (joint){ .kind = JOINT_NONE };
    l->role[number] = JOINT_IDLE;
    l->gone++;
    linkage_count_pins(l);
}

// A pair of bodies as one number, the smaller one first.
static long long key_of(int a, int b)
{
    return int_min(a, b) * (1LL << 32) + int_max(a, b);
}

static int compare(const void *x, const void *y)
{
    long long a = *(const long long *)x, b = *(const long long *)y;
    return (a > b) - (a < b);
}

// A sorted list of the joined pairs, then one search for each that may meet.
int linkage_drop_pairs(linkage *l, int (*pair)[2], int n)
{
    int apart = 0, left = 0;
    for (int k = 0; k < l->count; k++)
        if (holds(&l->joint[k]) && !l->joint[k].may_touch)
            l->apart[apart++] = key_of(l->joint[k].a, l->joint[k].b);
    if (apart == 0) return n;
    qsort(l->apart, (size_t)apart, sizeof *l->apart, compare);
    for (int k = 0; k < n; k++) {
        long long key = key_of(pair[k][0], pair[k][1]);
        if (bsearch(&key, l->apart, (size_t)apart, sizeof key, compare))
            continue;
        pair[left][0] = pair[k][0];
        pair[left++][1] = pair[k][1];
    }
    return left;
}
//<

//> linkage-sides
//>   Where do bodies stand now, and where will they be at the end of the
//>   substep? Where they freely come (chapter 18 has computed it), and further
//>   by what joints and contacts have given them.
static const motion_basis IMMOVABLE = { .inverse_mass = 0 };

static const motion_basis *basis_of(const solver_frame *f, int b)
{
    return b < 0 ? &IMMOVABLE : &f->body[b].basis;
}

static bool moves(const solver_frame *f, int b)
{
    return basis_of(f, b)->inverse_mass > 0;
}

// Body b, where it stands now.
static joint_side side_of(const linkage_pass *q, int b)
{
    joint_side s = { basis_of(q->f, b), JOINT_WORLD };
    if (b < 0) return s;
    s.frame = q->f->body[b].frame;
    if (moves(q->f, b))
        s.frame = motion_frame(&s.frame, s.basis, &q->moved[b]);
    return s;
}

// And at the end of the substep.
static joint_side side_ahead(const linkage_pass *q, int b)
{
    joint_side s = { basis_of(q->f, b), JOINT_WORLD };
    if (b < 0) return s;
    s.frame = q->f->body[b].frame;
    if (!moves(q->f, b)) return s;
    motion more;
    for (int i = 0; i < MOTIONS; i++)
        more.of[i] = q->f->h * (q->velocity[b].of[i] - q->free[b].of[i]);
    s.frame = motion_frame(&q->ahead[b], s.basis, &more);
    return s;
}
//<

//> linkage-apply
//>   A row gives a speed, and takes an impulse. Both walk over the six numbers
//>   of each body's motion.
static real speed_of(const linkage_pass *q, const real row[MOTIONS], int b)
{
    real sum = 0;
    if (!moves(q->f, b)) return 0;
    for (int i = 0; i < MOTIONS; i++) sum += row[i] * q->velocity[b].of[i];
    return sum;
}

static void push_body(const linkage_pass *q, const real row[MOTIONS], int b,
                      real impulse)
{
    real inverse = basis_of(q->f, b)->inverse_mass;
    if (!(inverse > 0)) return;
    for (int i = 0; i < MOTIONS; i++) {
        real share = i < MOTION_TURN ? inverse : 1;
        q->velocity[b].of[i] += share * row[i] * impulse;
    }
}

static void push_row(const linkage_pass *q, const joint *j,
                     const joint_rows *r, int k, real impulse)
{
    push_body(q, r->a[k], j->a, impulse);
    push_body(q, r->b[k], j->b, impulse);
}

static real speed_of_row(const linkage_pass *q, const joint *j,
                         const joint_rows *r, int k)
{
    return speed_of(q, r->a[k], j->a) + speed_of(q, r->b[k], j->b);
}
//<

//> linkage-want
//>   Before the bodies move, the impulses must close the gap at the end of the
//>   substep. After the move they must stop the relative speed. Only what is
//>   wanted differs, so it is an argument of all that follows.
// How fast a joint's errors must change.  A body that turns takes a point along
// an arc: where the points will be at the end of the substep is looked up.
//
// What is solved exactly may go home at once; what others have a say in goes
// slowly.
static const real AT_ONCE = 1, SLOWLY = 0.3;

static void want_together(const linkage_pass *q, const joint *j,
                          const joint_rows *r, real want[JOINT_ROWS])
{
    real h = q->f->h, then[JOINT_ROWS];
    joint_side a = side_ahead(q, j->a), b = side_ahead(q, j->b);
    joint_errors(j, r, &a.frame, &b.frame, then);
    for (int k = 0; k <= r->held && k < JOINT_ROWS; k++) {
        bool is_open = k == r->held && r->error[k] > 0;
        real left = is_open ? 0 : (1 - r->share) * r->error[k];
        want[k] = (left - then[k]) / h - r->give[k] * j->impulse[k];
    }
}

static void want_rest(const linkage_pass *q, const joint *j,
                      const joint_rows *r, real want[JOINT_ROWS])
{
    for (int k = 0; k <= r->held && k < JOINT_ROWS; k++) {
        bool is_open = k == r->held && r->error[k] > 0;
        want[k] = (is_open ? -r->error[k] / q->f->h : 0)
                - speed_of_row(q, j, r, k);
    }
}

typedef void wanting(const linkage_pass *q, const joint *j,
                     const joint_rows *r, real want[JOINT_ROWS]);
//<

//> linkage-alone
//>   A joint can be solved by itself, as in the exercise of chapter 13. This is
//>   the plain form. Joints that close a ring are solved like this, and with
//>   `is_plain` all are, to measure what the trees are worth.
// A unit impulse along row k moves the bodies along row l by K_kl.
static real coupling(const linkage_pass *q, const joint *j,
                     const joint_rows *r, int k, int l)
{
    real straight_a = 0, straight_b = 0, turning = 0;
    for (int i = 0; i < MOTION_TURN; i++) {
        straight_a += r->a[k][i] * r->a[l][i];
        straight_b += r->b[k][i] * r->b[l][i];
    }
    for (int i = MOTION_TURN; i < MOTIONS; i++)
        turning += r->a[k][i] * r->a[l][i] + r->b[k][i] * r->b[l][i];
    return basis_of(q->f, j->a)->inverse_mass * straight_a
         + basis_of(q->f, j->b)->inverse_mass * straight_b + turning;
}

// A joint gives way as a spring does, by a share of its own K in a substep.  It
// must: where bodies form a ring, or hang between two walls, some rows say the
// same twice, and a joint without any give would bear whatever rounding says.
// Those that stand alone are softer, for passes to be able to bring them to
// terms.
static const real GIVE = 1e-4, GIVE_ALONE = 0.3;

static void factor_alone(linkage *l, const linkage_pass *q, int number)
{
    const joint *j = &l->joint[number];
    joint_rows *r = &l->rows[number];
    if (l->role[number] != JOINT_ALONE) return;
    for (int k = 0; k < r->count; k++) {
        for (int i = 0; i <= k; i++) r->factor[k][i] = coupling(q, j, r, k, i);
        r->give[k] = GIVE_ALONE * r->factor[k][k];
        r->factor[k][k] += r->give[k];
    }
    small_factor(r->count, r->factor);
}

static void solve_alone(const linkage_pass *q, joint *j, joint_rows *r,
                        wanting *what)
{
    real want[JOINT_ROWS];
    what(q, j, r, want);
    small_solve(r->count, r->factor, want);
    for (int k = 0; k < r->count; k++) {
        j->impulse[k] += want[k];
        push_row(q, j, r, k, want[k]);
    }
}
//<

//> linkage-limit
//>   The active set changes here: a limit that pulls is dropped, and a limit
//>   that is passed is added.
// A limit only pushes, as a contact does.  While it does it is one row more;
// where it would pull, or is not reached, it is none.  Returns whether that has
// changed.
static bool switch_limit(const linkage_pass *q, joint *j, joint_rows *r,
                         wanting *what)
{
    real want[JOINT_ROWS];
    int k = r->held;
    bool pushes = r->count > k;
    if (!j->is_limited) return false;
    if (pushes && !(j->impulse[k] < 0)) return false;
    if (pushes) {
        push_row(q, j, r, k, -j->impulse[k]);
        j->impulse[k] = 0;
    } else {
        what(q, j, r, want);
        if (!(want[k] > 0)) return false;
    }
    r->count = k + !pushes;
    return true;
}
//<

//> linkage-tree
// The body at the other end of a joint.
static int other_end(const joint *j, int b)
{
    return j->a + j->b - b;
}

static int tree_of(linkage *l, int b)
{
    while (l->body[b].group != b) {
        l->body[b].group = l->body[l->body[b].group].group;
        b = l->body[b].group;
    }
    return b;
}

static void reset_body(linkage *l, int b)
{
    if (b < 0) return;
    linkage_body *x = &l->body[b];
    x->group = b;
    x->branches = x->one = 0;
    x->is_done = false;
    x->seen = l->frames;
}

static void add_branch(linkage *l, int b, int k)
{
    l->body[b].branches++;
    l->body[b].one ^= k;    // when one is left, it stands here
}

// What is driven goes its way, whatever pulls it.
static bool yields(const solver_frame *f, int b)
{
    return moves(f, b) && !f->body[b].is_driven;
}

// A joint that would close a ring stands alone.  One of which neither end yields
// has nothing to move: its impulses would grow in every substep.
static joint_role choose_role(linkage *l, const linkage_pass *q, int k)
{
    const joint *j = &l->joint[k];
    bool moves_a = moves(q->f, j->a), moves_b = moves(q->f, j->b);
    if (!holds(j) || j->kind == JOINT_PIN
        || (!yields(q->f, j->a) && !yields(q->f, j->b)))
        return JOINT_IDLE;
    if (l->is_plain) return JOINT_ALONE;
    if (!moves_a || !moves_b) return JOINT_ANCHOR;
    int a = tree_of(l, j->a), b = tree_of(l, j->b);
    if (a == b) return JOINT_ALONE;
    l->body[b].group = a;
    add_branch(l, j->a, k);
    add_branch(l, j->b, k);
    return JOINT_BRANCH;
}

// From a tip as far as there is one way to go.
static void follow(linkage *l, const linkage_pass *q, int b)
{
    while (moves(q->f, b) && !l->body[b].is_done && l->body[b].branches <= 1) {
        linkage_body *x = &l->body[b];
        int k = x->branches ? x->one : -1;
        l->step[l->steps++] = (linkage_step){ b, k };
        x->is_done = true;
        if (k < 0) return;
        b = other_end(&l->joint[k], b);
        l->body[b].branches--;
        l->body[b].one ^= k;
    }
}

static void choose_roles(linkage *l, const linkage_pass *q)
{
    for (int k = 0; k < l->count; k++) {
        if (!holds(&l->joint[k])) continue;
        reset_body(l, l->joint[k].a);
        reset_body(l, l->joint[k].b);
    }
    for (int k = 0; k < l->count; k++) l->role[k] = choose_role(l, q, k);
    l->steps = 0;
    l->is_stale = false;
    for (int k = 0; k < l->count; k++) {
        if (l->role[k] < JOINT_ANCHOR) continue;
        follow(l, q, l->joint[k].a);
        follow(l, q, l->joint[k].b);
    }
}
//<

//> linkage-factor
static real (*rows_at(joint_rows *r, const joint *j, int b))[MOTIONS]
{
    return j->a == b ? r->a : r->b;
}

static void reset_mass(linkage *l, const linkage_pass *q)
{
    for (int s = 0; s < l->steps; s++) {
        int b = l->step[s].body;
        real (*m)[MOTIONS] = l->body[b].mass;
        memset(m, 0, sizeof l->body[b].mass);
        for (int i = 0; i < MOTIONS; i++)
            m[i][i] = i < MOTION_TURN ? 1 / basis_of(q->f, b)->inverse_mass : 1;
    }
}

// What hangs on a joint makes the body heavier, along its rows.
static void hang_on(linkage_body *x, joint_rows *r, real (*row)[MOTIONS])
{
    real column[MOTIONS][JOINT_ROWS];
    for (int i = 0; i < MOTIONS; i++) {
        for (int k = 0; k < r->count; k++) column[i][k] = row[k][i];
        small_half(r->count, r->factor, column[i]);
        for (int l = 0; l <= i; l++)
            for (int k = 0; k < r->count; k++)
                x->mass[i][l] += column[i][k] * column[l][k];
    }
}

static void yield(const linkage_pass *q, const joint *j, joint_rows *r)
{
    memset(r->factor, 0, sizeof r->factor);
    for (int k = 0; k < r->count; k++)
        r->factor[k][k] = r->give[k] = GIVE * coupling(q, j, r, k, k);
}

// How the tree beyond a joint answers an impulse along it.
static void factor_branch(const linkage_pass *q, linkage_body *x,
                          const joint *j, joint_rows *r, real (*row)[MOTIONS])
{
    real half[JOINT_ROWS][MOTIONS];
    yield(q, j, r);
    for (int k = 0; k < r->count; k++) {
        memcpy(half[k], row[k], sizeof half[k]);
        small_half(MOTIONS, x->mass, half[k]);
        for (int l = 0; l <= k; l++)
            for (int i = 0; i < MOTIONS; i++)
                r->factor[k][l] += half[k][i] * half[l][i];
    }
    small_factor(r->count, r->factor);
}

static void factor_trees(linkage *l, const linkage_pass *q)
{
    reset_mass(l, q);
    for (int k = 0; k < l->count; k++) {
        if (l->role[k] != JOINT_ANCHOR) continue;
        joint *j = &l->joint[k];
        joint_rows *r = &l->rows[k];
        int b = moves(q->f, j->a) ? j->a : j->b;
        yield(q, j, r);
        small_factor(r->count, r->factor);
        hang_on(&l->body[b], r, rows_at(r, j, b));
    }
    for (int s = 0; s < l->steps; s++) {
        int b = l->step[s].body, k = l->step[s].joint;
        small_factor(MOTIONS, l->body[b].mass);
        if (k < 0) continue;
        joint *j = &l->joint[k];
        joint_rows *r = &l->rows[k];
        int on = other_end(j, b);
        factor_branch(q, &l->body[b], j, r, rows_at(r, j, b));
        hang_on(&l->body[on], r, rows_at(r, j, on));
    }
}
//<

//> linkage-solve
//>   And here are the two walks. The velocities that they find are not given to
//>   the bodies. Only the impulses are, each to A and its opposite to B, so
//>   momentum stays to rounding, however inexact the matrices are.
// drive += rows^T impulse; and speed -= rows velocity.
static void drive_by(real drive[MOTIONS], const joint_rows *r,
                     real (*row)[MOTIONS], const real *impulse)
{
    for (int k = 0; k < r->count; k++)
        for (int i = 0; i < MOTIONS; i++) drive[i] += row[k][i] * impulse[k];
}

static void take_speed(real *speed, const joint_rows *r, real (*row)[MOTIONS],
                       const real velocity[MOTIONS])
{
    for (int k = 0; k < r->count; k++)
        for (int i = 0; i < MOTIONS; i++) speed[k] -= row[k][i] * velocity[i];
}

// What a joint wants, and the bodies beyond it do not do by themselves.
static void solve_inward(linkage *l, int b, int number)
{
    joint *j = &l->joint[number];
    joint_rows *r = &l->rows[number];
    real go[MOTIONS], impulse[JOINT_ROWS];
    int on = other_end(j, b);
    memcpy(go, l->body[b].drive, sizeof go);
    small_solve(MOTIONS, l->body[b].mass, go);
    take_speed(r->want, r, rows_at(r, j, b), go);
    memcpy(impulse, r->want, sizeof impulse);
    small_solve(r->count, r->factor, impulse);
    drive_by(l->body[on].drive, r, rows_at(r, j, on), impulse);
}

static void solve_outward(linkage *l, int b, int number)
{
    linkage_body *x = &l->body[b];
    if (number >= 0) {
        joint *j = &l->joint[number];
        joint_rows *r = &l->rows[number];
        int on = other_end(j, b);
        take_speed(r->want, r, rows_at(r, j, on), l->body[on].drive);
        small_solve(r->count, r->factor, r->want);
        drive_by(x->drive, r, rows_at(r, j, b), r->want);
    }
    small_solve(MOTIONS, x->mass, x->drive);
}

static void begin_trees(linkage *l, const linkage_pass *q, wanting *what)
{
    for (int s = 0; s < l->steps; s++)
        memset(l->body[l->step[s].body].drive, 0, sizeof l->body->drive);
    for (int k = 0; k < l->count; k++) {
        real want[JOINT_ROWS] = { 0 }, impulse[JOINT_ROWS];
        joint *j = &l->joint[k];
        joint_rows *r = &l->rows[k];
        if (l->role[k] < JOINT_ANCHOR) continue;
        what(q, j, r, want);
        memcpy(r->want, want, sizeof r->want);
        for (int i = 0; i < r->count; i++)
            l->asked = real_max(l->asked, fabs(want[i]));
        if (l->role[k] == JOINT_BRANCH) continue;
        int b = moves(q->f, j->a) ? j->a : j->b;
        memcpy(impulse, want, sizeof impulse);
        small_solve(r->count, r->factor, impulse);
        drive_by(l->body[b].drive, r, rows_at(r, j, b), impulse);
    }
}

static void end_trees(linkage *l, const linkage_pass *q)
{
    for (int k = 0; k < l->count; k++) {
        joint *j = &l->joint[k];
        joint_rows *r = &l->rows[k];
        if (l->role[k] < JOINT_ANCHOR) continue;
        if (l->role[k] == JOINT_ANCHOR) {
            int b = moves(q->f, j->a) ? j->a : j->b;
            take_speed(r->want, r, rows_at(r, j, b), l->body[b].drive);
            small_solve(r->count, r->factor, r->want);
        }
        for (int i = 0; i < r->count; i++) {
            j->impulse[i] += r->want[i];
            push_row(q, j, r, i, r->want[i]);
        }
    }
}

static void solve_trees(linkage *l, const linkage_pass *q, wanting *what)
{
    if (l->steps == 0) return;
    begin_trees(l, q, what);
    for (int s = 0; s < l->steps; s++)
        if (l->step[s].joint >= 0)
            solve_inward(l, l->step[s].body, l->step[s].joint);
    for (int s = l->steps - 1; s >= 0; s--)
        solve_outward(l, l->step[s].body, l->step[s].joint);
    end_trees(l, q);
}
//<

//> linkage-pass
//>   The parts come together in four functions, one for each moment of a
//>   substep. Joints that stand alone go first, in an order that turns round
//>   every time; then come the trees, which hold best.
// By how much (m) the points are not where they should be.
static real apart(const joint *j, const joint_rows *r)
{
    const real *e = r->error;
    if (j->kind == JOINT_DISTANCE)
        return j->is_limited ? real_max(-e[0], 0) : fabs(e[0]);
    return sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
}

// What is far apart comes together no faster than an overlap goes.
static real share_of(const linkage *l, int k, const solver_frame *f)
{
    const joint_rows *r = &l->rows[k];
    real sum = 0, most = f->max_speed * f->h;
    for (int i = 0; i < r->held + l->joint[k].is_limited; i++)
        sum += i < r->held || r->error[i] < 0 ? r->error[i] * r->error[i] : 0;
    real share = l->role[k] == JOINT_ALONE ? SLOWLY : AT_ONCE;
    return share * share * sum > most * most ? most / sqrt(sum) : share;
}

// A body that a force holds at the end of its arm swings about its centre: the
// square of that angular frequency is the moment that a small turn brings,
// force times arm, beside the moment of inertia.  Here for 1 N.
static real swing_of(const joint_side *s, vec3 local)
{
    vec3 arm = vec3_sub(frame_point(&s->frame, local), s->frame.center);
    real sum = 0, length = vec3_length(arm);
    for (int t = 0; t < TURNS; t++)
        sum += vec3_length_squared(vec3_cross(s->basis->turn[t], arm));
    return length > 0 ? sum / length : 0;
}

static void find_rows_of(linkage *l, const linkage_pass *q, int k)
{
    joint *j = &l->joint[k];
    joint_rows *r = &l->rows[k];
    joint_side a = side_of(q, j->a), b = side_of(q, j->b);
    bool was_upper = r->is_upper;
    joint_find_rows(r, j, &a, &b);
    if (j->is_limited && r->is_upper != was_upper) j->impulse[r->held] = 0;
    r->count = r->held + (j->is_limited && j->impulse[r->held] > 0);
    r->share = share_of(l, k, q->f);
    r->swing = real_max(swing_of(&a, j->local_a), swing_of(&b, j->local_b));
    l->worst = real_max(l->worst, apart(j, r));
}

static void find_rows(linkage *l, const linkage_pass *q)
{
    l->worst = 0;
    for (int k = 0; k < l->count; k++) {
        if (l->role[k] == JOINT_IDLE) continue;
        find_rows_of(l, q, k);
        factor_alone(l, q, k);
    }
    factor_trees(l, q);
}

// Solved without a limit that is reached, or with one that pulls, a tree is
// solved again.
enum { LIMIT_ROUNDS = 4 };

static bool switch_limits(linkage *l, const linkage_pass *q, wanting *what)
{
    bool has_changed = false;
    for (int k = 0; k < l->count; k++) {
        if (l->role[k] == JOINT_IDLE) continue;
        if (!switch_limit(q, &l->joint[k], &l->rows[k], what)) continue;
        factor_alone(l, q, k);
        has_changed = true;
    }
    return has_changed;
}

// What stands alone first, every other time last to first; then the trees.
static void solve_all(linkage *l, const linkage_pass *q, wanting *what)
{
    l->is_backward = !l->is_backward;
    for (int i = 0; i < l->count; i++) {
        int k = l->is_backward ? l->count - 1 - i : i;
        if (l->role[k] == JOINT_ALONE)
            solve_alone(q, &l->joint[k], &l->rows[k], what);
    }
    solve_trees(l, q, what);
    for (int n = 0; n < LIMIT_ROUNDS && switch_limits(l, q, what); n++) {
        factor_trees(l, q);
        solve_trees(l, q, what);
    }
}

static void remember(const joint *j, joint_rows *r)
{
    memcpy(r->begun, j->impulse, sizeof r->begun);
    r->was_upper = r->is_upper;
    r->was_broken = j->is_broken;
}

void linkage_forget_impulses(linkage *l)
{
    for (int k = 0; k < l->count; k++) {
        joint *j = &l->joint[k];
        memset(j->impulse, 0, sizeof j->impulse);
        if (!(j->force < HUGE_VAL)) j->force = 0;
    }
}

void linkage_mark(linkage *l)
{
    for (int k = 0; k < l->count; k++) remember(&l->joint[k], &l->rows[k]);
}

void linkage_scale(linkage *l, real times)
{
    for (int k = 0; k < l->count; k++)
        for (int i = 0; i < JOINT_ROWS; i++) l->joint[k].impulse[i] *= times;
}

void linkage_rewind(linkage *l, const linkage_pass *q)
{
    for (int k = 0; k < l->count; k++) {
        joint *j = &l->joint[k];
        joint_rows *r = &l->rows[k];
        memcpy(j->impulse, r->begun, sizeof r->begun);
        r->is_upper = r->was_upper;
        l->broken -= j->is_broken && !r->was_broken;
        j->is_broken = r->was_broken;
    }
    choose_roles(l, q);
    find_rows(l, q);
}

void linkage_prepare(linkage *l, const linkage_pass *q)
{
    l->pace = l->worst = 0;
    if (l->count == 0) return;
    l->frames++;
    choose_roles(l, q);
    linkage_scale(l, q->f->warm);
    find_rows(l, q);
}

void linkage_begin(linkage *l, const linkage_pass *q)
{
    for (int k = 0; k < l->count; k++) {
        const joint_rows *r = &l->rows[k];
        if (l->role[k] == JOINT_IDLE) continue;
        for (int i = 0; i < r->count; i++)
            push_row(q, &l->joint[k], r, i, l->joint[k].impulse[i]);
    }
}

// Rows are straight, and points go along arcs: a large impact is solved more
// than once, as Newton does.
static const real LARGE = 1e-3;         // m, in a substep
enum { IMPACT_STEPS = 3 };

void linkage_push(linkage *l, const linkage_pass *q)
{
    for (int n = 0; n < IMPACT_STEPS; n++) {
        l->asked = 0;
        solve_all(l, q, want_together);
        if (!(l->asked * q->f->h > LARGE)) return;
    }
}
//<

//> linkage-break
//>   After the substep each joint knows its force. It says how fast its bodies
//>   swing, and breaks if the force is too great.
static real force_of(const joint *j, real h)
{
    const real *p = j->impulse;
    if (j->kind == JOINT_DISTANCE)
        return fabs(p[0]) / h;
    return sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / h;
}

// A spin counts twice: within a substep the joints see a body's inertia where it
// stands as it begins.  With one 30 of 84 tops (chapter 20, case 160)
// changed their energy by more than a thousandth, with two 25, with four 17;
// the substeps of a fast spin are half, or twice, as many.
static const real SPINS = 2;

// rad/s
static real spin_of(const linkage_pass *q, int b)
{
    return moves(q->f, b) ? vec3_length(motion_rotation(basis_of(q->f, b),
                                                        &q->velocity[b])) : 0;
}

static void break_overloaded(linkage *l, const linkage_pass *q)
{
    real h = q->f->h;
    l->swing = 0;
    for (int k = 0; k < l->count; k++) {
        joint *j = &l->joint[k];
        if (l->role[k] == JOINT_IDLE) continue;
        j->force = force_of(j, h);
        l->swing = real_max(l->swing, sqrt(j->force * l->rows[k].swing));
        l->swing = real_max(l->swing, SPINS * real_max(spin_of(q, j->a),
                                                       spin_of(q, j->b)));
        if (!(j->force > j->strength)) continue;
        j->is_broken = l->is_stale = true;
        l->role[k] = JOINT_IDLE;
        l->broken++;
    }
}

void linkage_relax(linkage *l, const linkage_pass *q)
{
    if (l->count == 0) return;
    find_rows(l, q);
    solve_all(l, q, want_rest);
    break_overloaded(l, q);
    l->pace = real_max(l->pace, l->swing);
    if (!l->is_stale) return;
    choose_roles(l, q);
    find_rows(l, q);
}
//<
