//> step-declares
//>   What a step calls, in the order of its phases.
#include "step.h"
#include "advance.h"
#include "ahead.h"
#include "blow.h"
#include "drive.h"
#include "guard.h"
#include "hear.h"
#include "handle.h"
#include "join.h"
#include "ledger.h"
#include "restitution.h"
#include "rolling.h"
#include "rungs.h"
#include "soft_step.h"
#include "substeps.h"

#include <stddef.h>
#include <string.h>

static void book_time(world *w, int phase, real *since);
static void refresh_bodies(world *w);
static void drop_sleepers(world *w);
static void surround_bodies(world *w);
static void find_pairs(world *w);
static void find_manifolds(world *w);
static int activate_contacts(world *w, const solver_frame *f);
static solver_frame solver_frame_of(const world *w, int substeps);
static solver_frame prepare(world *w, const rung *r);
static void substep(world *w, const solver_frame *f, real *since);
static void redo(world *w, solver_frame *f, real times, const ledger_page *p);
static void fall_asleep(world *w);
//<

//> step
// What may touch in the next `seconds`.  Paper: bodies move, then overlaps are
// looked for; here: what may touch is found before anything moves.
static void find(world *w, real seconds, real *since)
{
    w->frame = seconds;
    refresh_bodies(w);
    surround_bodies(w);
    if (w->softs > 0 && soft_wake(w)) refresh_bodies(w);
    find_pairs(w);
    ledger_book(w, LEDGER_SLEEP);
    book_time(w, PHASE_PAIRS, since);
    find_manifolds(w);
    drop_sleepers(w);
    book_time(w, PHASE_CONTACTS, since);
}

// The particles of what has moved are a substep apart now.
static void set_age(world *w, real h)
{
    for (int k = 0; k < w->rigid.awakes; k++)
        w->rigid.age[w->rigid.awake[k]] = h;
}

// The substeps: so many of equal length, or more and shorter ones where joints
// ask for them.
static void run_substeps(world *w, solver_frame f, real *since)
{
    int left = f.substeps;
    const rung *r = &w->rigid.rungs[(int)w->rigid.on_rung];
    if (r->hangs) join_begin(w, &f);
    while (left > 0) {
        ledger_page page = ledger_mark(w);
        int hears = w->rigid.hears;
        if (r->hangs && !r->is_soft) advance_mark(w);
        substep(w, &f, since);
        w->report.substeps++;
        int more = substeps_again(w, f.h, left);
        if (more > 0) redo(w, &f, (real)left / more, &page);
        left = more > 0 ? more : left - 1;
        if (more > 0) w->rigid.hears = hears;
        if (more > 0) continue;
        set_age(w, f.h);
        if (w->rigid.listens) hear_contacts(w);
        blow_forget(&w->rigid.solver);
        if (left > 0) ahead_again(w, &f, left * f.h);
    }
}

// What is driven stands before the bodies of each rung, and goes its way with each
// again; those of the rung before have gone theirs.
static void take_rung(rigid_tables *t, int k)
{
    const rung *r = &t->rungs[k];
    int n = t->drivens, *list = t->by_rung + r->first - n;
    if (k > 0)
        memmove(list, t->by_rung + r[-1].first - n, (size_t)n * sizeof *list);
    t->on_rung = (char)k;
    t->awake = list;
    t->awakes = r->end - r->first + n;
}

// The bodies of a rung, as if there were no others.
static void solve_rung(world *w, int k, real *since)
{
    rigid_tables *t = &w->rigid;
    const rung *r = &t->rungs[k];
    int *awake = t->awake, awakes = t->awakes;
    take_rung(t, k);
    for (int i = 0; i < t->drivens && k > 0; i++) drive_back(w, t->awake[i]);
    solver_frame f = prepare(w, r);
    if (t->listens) hear_impacts(w, &f);
    book_time(w, PHASE_PREPARE, since);
    run_substeps(w, f, since);
    solver_store(&t->solver, w->options.host.run, t->cache.active);
    if (r->hangs) {
        w->report.parted = real_max(w->report.parted, w->joints.worst);
        w->report.unconverged += w->joints.parted;
    }
    t->awake = awake;
    t->awakes = awakes;
}

// One rung after the other; a frame took as many substeps as the highest.
static void climb_rungs(world *w, int rungs, real *since)
{
    int before = w->report.substeps, most = before;
    for (int k = 0; k < rungs; k++) {
        w->report.substeps = before;
        solve_rung(w, k, since);
        most = int_max(most, w->report.substeps);
    }
    w->report.substeps = most;
    solver_take(&w->rigid.solver, 0, w->rigid.solver.contacts);
}

// The impulses that part it, and where they take everything.
static void solve_frame(world *w, real *since)
{
    solver_frame f = solver_frame_of(w, 1);
    int rungs = activate_contacts(w, &f);
    guard_begin(w, &f);
    climb_rungs(w, rungs, since);
    rolling_brake(w);
    guard_brake(w, advance_end(w));
    guard_bodies(w);
    guard_walls(w);
    drive_hold(w);
    if (w->softs > 0) soft_prove(w);
    ledger_book(w, LEDGER_CONTACTS);
    advance_write(w);
    ledger_halfway(w, 0);
    ledger_book(w, LEDGER_STICKS);
    if (w->softs > 0) soft_report(w);
    book_time(w, PHASE_MOVE, since);
}
//<

//> step-swept
// Where something flies by more than its own size in a frame, and may hit, the
// frame is divided: after the impact everything goes elsewhere than was found.
// So it is where what is driven turns past what it may hit.
enum { FAST_PARTS = 4 };                    // tuned, parts

static bool is_swept(const world *w)
{
    const contact_cache *c = &w->rigid.cache;
    for (int k = 0; k < c->actives && w->kinematic_bodies > 0; k++)
        if (rungs_sweeps(w, c->active[k]->a, c->active[k]->b)) return true;
    return false;
}

static int parts_of(const world *w)
{
    return w->rigid.cache.fast > 0 || is_swept(w) ? FAST_PARTS : 1;
}

// A world in which everything sleeps has nothing to do: nothing in it can wake.
static bool sleeps_on(world *w)
{
    if (!w->is_still) return false;
    w->report = (step_report){ .asleep = w->report.asleep };
    w->rigid.hears = 0;
    w->time += w->options.dt;
    return true;
}
//<

//> step-frame
void world_step(world *w)
{
    if (sleeps_on(w)) return;
    real dt = w->options.dt;
    real since = w->options.host.clock ? w->options.host.clock() : 0;
    w->report = (step_report){ .substeps = 0 };
    w->rigid.hears = 0;
    ledger_open(w);
    sleep_begin(&w->sleep);
    join_wake(w);
    find(w, dt, &since);
    int parts = parts_of(w);
    for (int k = 0; k < parts; k++) {
        if (parts > 1) find(w, dt / parts, &since);
        solve_frame(w, &since);
    }
    fall_asleep(w);
    world_forget_loads(w);
    w->report.unconverged += w->report.lost;
    ledger_book(w, LEDGER_SLEEP);
    w->time += dt;
    book_time(w, PHASE_SLEEP, &since);
}
//<

//> step-lap
// Books the time since *since to a phase, and starts the next.
static void book_time(world *w, int phase, real *since)
{
    real now = w->options.host.clock ? w->options.host.clock() : 0;
    w->report.time[phase] += now - *since;
    *since = now;
}
//<

//> step-awake
//>   What sleeps costs nothing: every loop over bodies in a step is one over a
//>   list of those that are awake. The list is in the order of their numbers,
//>   and so is every sum over bodies.
static void list_awake(world *w)
{
    rigid_tables *t = &w->rigid;
    if (!t->has_noticed) return;
    const char *at = t->is_awake, *end = at + w->bodies;
    t->has_noticed = false;
    t->awakes = 0;
    while (at < end && (at = memchr(at, true, (size_t)(end - at))))
        t->awake[t->awakes++] = (int)(at++ - t->is_awake);
}

// What was looked at, and does not move, is left out; and pieces that ride on a
// body, until contacts are found again.
static void drop_sleepers(world *w)
{
    rigid_tables *t = &w->rigid;
    int kept = 0;
    bool has_pieces = w->has_pieces, has_noticed = t->has_noticed;
    for (int k = 0; k < t->awakes; k++) {
        int b = t->awake[k];
        bool rides = has_pieces && body_rides(&w->body[b]);
        t->is_awake[b] = t->moves[b] || body_moves(w, b);
        has_noticed |= rides && t->is_awake[b];
        t->awake[kept] = b;
        kept += t->is_awake[b] && !rides;
    }
    t->has_noticed = has_noticed;
    t->awakes = kept;
}
//<

//> step-look-at
//>   Bodies are shared among threads, 32 at a time. One that does not move gets
//>   a motion basis of zeros: it answers no impulse, and no other phase needs to
//>   ask why.
// (A piece is as old as the body that it rides on.)
static bool rides_on(world *w, int b)
{
    int of = body_whole(&w->body[b], b);
    w->rigid.age[b] = w->rigid.age[of];
    return body_moves(w, of);
}

static void refresh_body(world *w, int b)
{
    rigid_tables *t = &w->rigid;
    const body *x = &w->body[b];
    const particle *p = w->pool.at + x->first;
    bool moved = t->moves[b];
    t->moves[b] = (char)(!body_is_soft(x)
                         && (body_moves(w, b) || body_is_driven(w, b)
                             || (x->rides > 0 && rides_on(w, b))));
    if (!t->moves[b] && !moved) return;
    solver_body *now = &t->now[b];
    now->frame = rigid4_frame(p);
    t->ball[b].center = now->frame.center;
    memset(&t->moved[b], 0, sizeof t->moved[b]);
    now->is_driven = t->moves[b] && x->is_kinematic;
    if (t->moves[b]) {
        now->basis = basis_find(x->rigid, &now->frame);
        t->velocity[b] = motion_of(p, &now->frame, &now->basis, t->age[b]);
        if (now->is_driven) drive_begin(w, b);
        ahead_predict(w, b, w->frame);
    } else {
        now->basis = (motion_basis){ .inverse_mass = 0 };
        memset(&t->velocity[b], 0, sizeof t->velocity[b]);
        t->ahead[b] = (prediction){ .reach = 0 };
        t->asked[b] = t->began[b] = now->frame;
        t->going[b] = 0;
    }
    t->reach[b] = t->ahead[b].reach;
}

static void refresh_chunk(void *data, int item)
{
    world *w = data;
    int end = task_end(item, w->rigid.awakes);
    for (int k = task_first(item); k < end; k++)
        refresh_body(w, w->rigid.awake[k]);
}

static void refresh_bodies(world *w)
{
    list_awake(w);
    tasks_run(w->options.host.run, refresh_chunk, w,
              task_chunks(w->rigid.awakes));
}
//<

//> step-around
//>   Of a mesh of many triangles, those come among the bodies that something
//>   comes near ([`tumble_mesh`](lib-tumble_mesh.md)).
static void surround_bodies(world *w)
{
    const world_host *host = &w->options.host;
    if (host->surround && host->surround(host->surroundings)) list_awake(w);
}
//<

//> step-wake
//>   A sleeper that a moving body may reach in this frame is woken *before* the
//>   impact, or it would be a rock for one frame.
// m, how far body b reaches from its centre along the unit vector d.
static real extent_of(const world *w, int b, vec3 d)
{
    const vec3 *axis = w->rigid.now[b].frame.axis;
    const shape *s = w->body[b].shape;
    vec3 along = { vec3_dot(d, axis[0]), vec3_dot(d, axis[1]),
                   vec3_dot(d, axis[2]) };
    real most = 0;
    for (int v = 0; v < s->particles; v++)
        most = real_max(vec3_dot(w->body[b].rigid->local[v], along), most);
    return most + s->round;
}

// May two bodies meet in this frame, if they go that way (m)?  Not if their balls
// do not, nor if the line through their centres shows a gap that they do not close.
static bool may_meet(const world *w, int a, int b, real ways)
{
    const rigid_tables *t = &w->rigid;
    real near = t->ball[a].radius + t->ball[b].radius + ways;
    vec3 d = vec3_sub(t->ball[a].center, t->ball[b].center);
    real far = vec3_length(d);
    if (!(far <= near)) return false;
    if (!(far > 0)) return true;
    vec3 along = vec3_scale(1 / far, d);
    return far <= extent_of(w, a, vec3_scale(-1, along))
                + extent_of(w, b, along) + ways;
}

// Raises `passed` (m) to how far the one goes that wakes the other: what was hit
// goes on as far, and wakes what it hits.
static bool wake_pair(world *w, int a, int b, real *passed)
{
    int x = body_whole(&w->body[a], a), y = body_whole(&w->body[b], b);
    real ways = w->rigid.reach[a] + w->rigid.reach[b];
    int sleeper = world_sleeper_near(w, x, y);
    if (sleeper < 0 || !may_meet(w, a, b, ways + *passed)) return false;
    world_wake(w, sleeper);
    *passed = real_max(*passed, ways);
    return true;
}

static bool wake_sleepers(world *w, real *passed)
{
    const rigid_tables *t = &w->rigid;
    const bool *asleep = w->sleep.asleep;
    bool woke = false, has_pieces = w->has_pieces;
    for (int k = 0; k < t->pairs.count; k++) {
        int a = t->pairs.pair[k][0], b = t->pairs.pair[k][1];
        if (asleep[a] != asleep[b] || has_pieces)
            woke |= wake_pair(w, a, b, passed);
    }
    if (woke) refresh_bodies(w);
    return woke;
}
//<

//> step-parts
//>   The ball around a part of a mesh is much larger than the part, and most
//>   bodies that reach into it come nowhere near. The axes of a part are those of
//>   the world, so it has a box.
// Does part b of something lie outside of that ball?
static bool is_past(const world *w, int b, sphere ball)
{
    const shape *s = w->body[b].shape;
    vec3 origin = vec3_sub(w->rigid.now[b].frame.center,
                           w->body[b].rigid->center);
    vec3 x = vec3_sub(ball.center, origin);
    aabb around = { s->at[0], s->at[0] };
    for (int i = 1; i < s->particles; i++) around = aabb_with(around, s->at[i]);
    return aabb_distance_squared(&around, x) > ball.radius * ball.radius;
}
//<

//> step-pairs
//>   Chapter 14 finds the pairs, and keeps them while the balls hold.
// (A kinematic body goes through planes.)
static bool may_pair(const void *of, const int pair[2])
{
    const world *w = of;
    int a = pair[0], b = pair[1];
    const body *x = &w->body[a], *y = &w->body[b < 0 ? a : b];
    const sphere *listed = w->rigid.pairs.listed;
    if (b < 0) return !x->is_kinematic && !body_meets_none(x);
    return body_meets(x, y)
        && !(x->is_part && is_past(w, a, listed[b]))
        && !(y->is_part && is_past(w, b, listed[a]))
        && !linkage_keeps_apart(&w->joints, body_whole(x, a), body_whole(y, b));
}

// A list without those that must not meet, that are joined, and parts of meshes
// that bodies do not reach.
static void drop_pairs(world *w)
{
    linkage_find_apart(&w->joints);
    pair_list_filter(&w->rigid.pairs, may_pair, w);
}

typedef bool pair_finding(pair_list *l, const pair_query *q, int *lost);

static bool list_pairs(world *w, pair_finding *ask)
{
    rigid_tables *t = &w->rigid;
    pair_query q = { t->ball, t->reach, t->dynamic, t->awake, t->awakes,
                     w->bodies, w->plane, w->planes };
    int lost;
    bool is_new = ask(&t->pairs, &q, &lost);
    w->report.dropped += lost;
    if (is_new) drop_pairs(w);
    return is_new;
}

static void find_pairs(world *w)
{
    real passed = 0;
    w->rigid.is_new_list = list_pairs(w, pair_list_update);
    // Each round wakes a sleeper, and none falls asleep.  Once one has woken, the
    // list is that of all pairs: the others are woken along it.
    bool woke = wake_sleepers(w, &passed);
    while (woke) {
        w->rigid.is_new_list |= list_pairs(w, pair_list_wake);
        woke = false;
        while (wake_sleepers(w, &passed)) woke = true;
    }
}
//<

//> step-contacts
//>   The cache is lent the bodies, and gives back the contacts of the frame.
static void find_manifolds(world *w)
{
    rigid_tables *t = &w->rigid;
    cache_frame f = ahead_frame(w);
    cache_update(&t->cache, &f);
    if (w->options.host.meets) hear_choose(w);
    pair_list_part(&t->pairs);
    w->report.pairs = t->pairs.count + t->pairs.parted;
    w->report.queries = (int)t->cache.queries;
    w->report.contacts = t->cache.actives;
    w->report.dropped += t->cache.lost;
}
//<

//> step-prepare
//>   Before the substeps, blocks are made of the contacts (chapter 13).
// Overlaps are pushed out with ten times the damping that would just not swing
// back, and no faster than by a radius in 18 frames: so that nothing jumps out of
// one.
static const real DAMPING = 10;             // tuned, 1
static const real PARTS_BY = 0.055;         // tuned, radii a frame
// Joints come together four times as fast at most (limits of an angle: by so many
// radians).  As fast as overlaps, a ring of small boxes that swings came apart.
enum { JOINS_FASTER = 4 };                  // tuned, times

static solver_frame solver_frame_of(const world *w, int substeps)
{
    const world_options *o = &w->options;
    real h = w->frame / substeps;
    return (solver_frame){
        .body = w->rigid.now, .bodies = w->bodies, .plane = w->plane, .h = h,
        .rows_at = w->rigid.middle, .is_elsewhere = w->rigid.going,
        .lying = w->rigid.lying,
        .substeps = substeps,
        .warm = o->warm_start ? 1 : 0, .age = w->rigid.age,
        .material = w->rigid.material, .wall = w->wall,
        .hertz = o->hertz, .damping = DAMPING, .max_rate = PARTS_BY / o->dt,
        .joint_rate = JOINS_FASTER * PARTS_BY / o->dt,
        .gravity = o->gravity,
        .run = o->host.run };
}

static const contact *const *contact_table(const world *w)
{
    return (const contact *const *)w->rigid.cache.active;
}

static void count_deep(world *w)
{
    const contact_solver *s = &w->rigid.solver;
    for (int k = 0; k < s->contacts; k++)
        w->report.unconverged += s->active[k].is_deep;
}

// Which points may touch, what is asked for substeps, and how everything goes.
static int activate_contacts(world *w, const solver_frame *f)
{
    rigid_tables *t = &w->rigid;
    if (!solver_activate(&t->solver, f, contact_table(w), t->cache.reach,
                         t->cache.actives))
        w->report.dropped += t->cache.actives;
    cache_note(&t->cache, &t->solver);
    count_deep(w);
    advance_begin(w);
    return rungs_find(w);
}

static solver_frame prepare(world *w, const rung *r)
{
    contact_solver *s = &w->rigid.solver;
    solver_frame f = solver_frame_of(w, r->substeps);
    w->rigid.elapsed = 0;
    solver_take(s, r->first_contact, r->end_contact);
    if (!solver_prepare(s, &f, contact_table(w)))
        w->report.dropped += r->end_contact - r->first_contact;
    return f;
}
//<

//> step-damp
//>   A body may have a damping (1/s): of its velocity, and of its turning.
// v' = -d v, by an implicit step: v (1 + h d) is what it was.  No d is too
// large for it.
static void damp(const body *b, real h, real u[MOTIONS])
{
    real straight = 1 / (1 + h * b->damping);
    real turning = 1 / (1 + h * b->spin_damping);
    for (int i = 0; i < MOTIONS; i++)
        u[i] *= i < MOTION_TURN ? straight : turning;
}
//<

//> step-substep
// A velocity is that in the middle of a substep.  The last one may have been of
// another length.
static void fall(world *w, real h)
{
    for (int k = 0; k < w->rigid.awakes; k++) {
        int b = w->rigid.awake[k];
        if (!w->rigid.moves[b] || w->rigid.now[b].is_driven) continue;
        motion *u = &w->rigid.velocity[b];
        motion_add_straight(u, (w->rigid.age[b] + h) / 2, body_gravity(w, b));
        if (w->rigid.is_loaded) {
            motion more = world_load(w, b, h);
            motion_add(u, &more);
        }
        if (w->is_damped) damp(&w->body[b], h, u->of);
    }
}

static void renew(world *w, solver_frame f, bool is_put_back)
{
    f.fresh = w->rigid.fresh;
    f.is_put_back = is_put_back;
    solver_renew(&w->rigid.solver, &f);
}

// Of balls that move, where impacts may be: on an older normal what parts would
// be held, and what comes would be braked before it strikes.
static void face_balls(world *w, const solver_frame *f)
{
    rigid_tables *t = &w->rigid;
    contact_solver *s = &t->solver;
    bool some = false;
    for (int k = s->first; k < s->end; k++) {
        active_contact *x = &s->active[k];
        contact *c = t->cache.active[k];
        bool moves = t->fresh[x->a]
                  || (x->sides != ONE_SIDED && t->fresh[x->b]);
        x->is_new = x->count == 1 && moves
                 && restitution_face(c, f, t->velocity, t->moved);
        some |= x->is_new;
    }
    if (!some) return;
    solver_store_new(s, t->cache.active);
    if (!solver_take_new(s, f, t->cache.active, t->cache.reach))
        w->report.dropped += s->end - s->first;
}

static void bounce(world *w, const solver_frame *f)
{
    rigid_tables *t = &w->rigid;
    const contact_solver *s = &t->solver;
    if (!s->strikes) return;
    face_balls(w, f);
    if (!restitution_solve(contact_table(w) + s->first, s->end - s->first, f,
                           t->now, t->velocity, t->moved)) return;
    advance_struck(w);
    face_balls(w, f);
    renew(w, *f, true);
    solver_update_gaps(&t->solver, f, t->moved);
}

static void substep(world *w, const solver_frame *f, real *since)
{
    rigid_tables *t = &w->rigid;
    const rung *r = &t->rungs[(int)t->on_rung];
    linkage_pass joints = join_pass(w, f);
    fall(w, f->h);
    ledger_halfway(w, f->h / 2);
    ledger_book(w, LEDGER_INTEGRATE);
    bounce(w, f);
    if (r->hangs) linkage_begin(&w->joints, &joints);
    solver_warm(&t->solver, f, t->velocity);
    if (r->hangs) linkage_push(&w->joints, &joints, false);
    solver_push(&t->solver, f, t->velocity, t->moved);
    blow_stop(&t->solver, f, t->velocity);
    if (r->hangs) linkage_push(&w->joints, &joints, true);
    advance_bodies(w, f->h);
    renew(w, *f, false);
    ledger_halfway(w, -f->h / 2);
    if (r->hangs) linkage_relax(&w->joints, &joints);
    solver_relax(&t->solver, f, t->velocity, t->moved);
    ledger_book(w, LEDGER_CONTACTS);
    book_time(w, PHASE_SOLVE, since);
    if (r->is_soft) {
        soft_step(w, f->h);
        guard_soft(w);
    }
    book_time(w, PHASE_SOFT, since);
}
//<

//> step-redo
// Back to where the substep began, for one that is so many times as long.
static void redo(world *w, solver_frame *f, real times, const ledger_page *page)
{
    linkage_pass q = join_pass(w, f);
    blow_forget(&w->rigid.solver);
    advance_back(w);
    linkage_rewind(&w->joints, &q);
    ledger_rewind(w, page);
    f->h *= times;
    solver_scale(&w->rigid.solver, times);
    linkage_scale(&w->joints, times);
    solver_renew(&w->rigid.solver, f);
}
//<

//> step-sleep
//>   In the step, a contact that pushes joins two bodies to an island. To the
//>   other phases a sleeping body is immovable. Where all sleep, a step does
//>   nothing at all.
// Three points or more of what stands press, each with this share of the load at
// least: so the middle of the load is well within them, and the body does not tip.
// Its friction holds, with as much to spare: so it does not slide.
static const real FIRM = 0.05;              // tuned, 1

// Does the body above stand on the other?  What is joined may be held elsewhere, and
// what is driven takes along what stands on it.
static bool stands(const world *w, const active_contact *x, const contact *c,
                   const solver_frame *f)
{
    const island *i = &w->rigid.island[x->above];
    int below = c->a + c->b - x->above, points = 0;
    if (w->rigid.island[i->parent].hangs) return false;
    if (below >= 0 && w->body[below].is_kinematic) return false;
    for (int k = 0; k < c->count; k++)
        points += c->impulse[k] >= FIRM * x->load;
    real most = (1 - FIRM) * solver_material(f, c->a, c->b).friction * x->load;
    return points >= 3 && vec3_length_squared(c->friction) < most * most;
}

static void find_standing(world *w)
{
    const contact_solver *s = &w->rigid.solver;
    solver_frame f = solver_frame_of(w, 1);
    for (int k = 0; k < s->contacts; k++) {
        const active_contact *x = &s->active[k];
        if (x->load > 0 && x->lift > 0
            && stands(w, x, w->rigid.cache.active[k], &f))
            sleep_stand(&w->sleep, x->above);
    }
}

// Islands are held together by what the contacts carried last.
static void join_islands(world *w)
{
    const contact_solver *s = &w->rigid.solver;
    w->report.pushing = 0;
    for (int k = 0; k < w->rigid.awakes; k++) {
        int b = w->rigid.awake[k];
        w->rigid.held[b] &= !w->rigid.moves[b];
    }
    for (int k = 0; k < s->contacts; k++) {
        const active_contact *x = &s->active[k];
        if (!(x->load > 0)) continue;
        w->report.pushing++;
        w->rigid.held[x->a] = true;
        if (x->b >= 0) w->rigid.held[x->b] = true;
        if (x->b >= 0 && body_is_dynamic(&w->body[x->a])
            && body_is_dynamic(&w->body[x->b]))
            sleep_touch(&w->sleep, x->a, x->b);
    }
    join_islands_of_joints(w);
}

static void observe(world *w)
{
    const world_options *o = &w->options;
    sleep_rule rule = { .speed = o->sleep_speed, .time = o->time_to_sleep,
                        .dt = o->dt };
    for (int k = 0; k < w->rigid.awakes; k++) {
        int b = w->rigid.awake[k];
        const body *x = &w->body[b];
        if (!body_moves(w, b)) continue;
        real radius = x->rigid ? x->rigid->radius : x->shape->radius;
        rule.h = body_age(w, b);
        rule.lasts = w->rigid.island[w->rigid.island[b].parent].lasts;
        rule.gravity = vec3_length(body_gravity(w, b));
        sleep_observe(&w->sleep, b, w->pool.at, x->first, body_particles(x),
                      radius, &rule);
    }
}

static void fall_asleep(world *w)
{
    join_islands(w);
    if (w->options.sleep_speed > 0) {
        find_standing(w);
        observe(w);
        sleep_end(&w->sleep);
    }
    w->report.asleep = w->sleep.sleepers;
    w->is_still = w->report.asleep > 0
               && w->report.asleep == w->dynamic_bodies;
    for (int k = 0; k < w->rigid.awakes; k++) {
        int b = w->rigid.awake[k];
        if (w->sleep.asleep[b]) world_pin_sleeper(w, b);
        w->is_still &= !body_is_driven(w, b);
    }
}
//<
