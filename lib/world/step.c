//> step
#include "step.h"
#include "ledger.h"
#include "restitution.h"
#include "soft.h"

#include <assert.h>
#include <stddef.h>
#include <string.h>

static void lap(world *w, int phase, real *since);
static void look_at_bodies(world *w);
static void find_pairs(world *w);
static void find_contacts(world *w);
static solver_frame prepare(world *w);
static void substep(world *w, const solver_frame *f, int k, real *since);
static void look_again(world *w, const solver_frame *f, int k);
static real most_motion(const world *w, const solver_frame *f);
static void brake(world *w, real most);
static void stop_at_planes(world *w);
static void move_bodies(world *w, real h);
static void fall_asleep(world *w);

// What may touch in the next `seconds`.  Paper: bodies move, then overlaps are
// looked for; here: what may touch is found before anything moves.
static void find(world *w, real seconds, real *since)
{
    w->frame = seconds;
    look_at_bodies(w);
    if (w->softs > 0 && soft_begin(w)) look_at_bodies(w);
    find_pairs(w);
    ledger_book(w, LEDGER_SLEEP);
    lap(w, PHASE_PAIRS, since);
    find_contacts(w);
    lap(w, PHASE_CONTACTS, since);
}

// The impulses that part it, and where they take everything.
static void solve(world *w, real *since)
{
    solver_frame f = prepare(w);
    real most = most_motion(w, &f);
    lap(w, PHASE_PREPARE, since);
    for (int k = 0; k < f.substeps; k++) {
        if (k > 0) look_again(w, &f, k);
        substep(w, &f, k, since);
    }
    solver_store(&w->rigid.solver, w->options.host.run,
                 w->rigid.cache.active);
    w->report.substeps += f.substeps;
    w->age = f.h;
    brake(w, most);
    stop_at_planes(w);
    ledger_book(w, LEDGER_CONTACTS);
    move_bodies(w, f.h);
    lap(w, PHASE_MOVE, since);
}

// Where something flies by more than its own size in a frame, and may hit, the
// frame is divided: after the impact everything goes elsewhere than was found.
enum { FAST_PARTS = 4 };

// A world in which everything sleeps has nothing to do: nothing in it can wake.
static bool sleeps_on(world *w)
{
    int asleep = w->report.asleep;
    if (asleep == 0 || asleep < w->dynamic_bodies) return false;
    w->report = (step_report){ .asleep = asleep };
    w->time += w->options.dt;
    return true;
}

void world_step(world *w)
{
    assert(w->is_ready);
    if (sleeps_on(w)) return;
    real dt = w->options.dt;
    real since = w->options.host.clock ? w->options.host.clock() : 0;
    w->report = (step_report){ .substeps = 0 };
    ledger_open(w);
    sleep_begin(&w->sleep);
    find(w, dt, &since);
    bool is_divided = w->rigid.cache.fast > 0;
    for (int k = 0; k < (is_divided ? FAST_PARTS : 1); k++) {
        if (is_divided) find(w, dt / FAST_PARTS, &since);
        solve(w, &since);
    }
    fall_asleep(w);
    ledger_book(w, LEDGER_SLEEP);
    w->time += dt;
    lap(w, PHASE_SLEEP, &since);
}

// Books the time since *since to a phase, and starts the next.
static void lap(world *w, int phase, real *since)
{
    real now = w->options.host.clock ? w->options.host.clock() : 0;
    w->report.time[phase] += now - *since;
    *since = now;
}
//<

//> step-chunks
// The bodies of an item: from first to the result - 1.
static int chunk_of(const world *w, int item, int *first)
{
    *first = item * TASK_CHUNK;
    return task_end(item, w->bodies);
}
//<

//> step-look
// How far a body may get in this frame: as fast as it is now, with what gravity
// adds, and a hundredth of its radius for what impacts add.  However far it
// turns, no vertex gets further than across.
static prediction predict(const world *w, const solver_body *now,
                          const motion *u)
{
    real dt = w->frame;
    vec3 straight = { u->of[0], u->of[1], u->of[2] };
    vec3 spin = motion_rotation(&now->basis, u);
    real beside = vec3_length(w->options.gravity) * dt * dt / 2
                + now->radius / 100;
    prediction p = { .way = vec3_scale(dt, straight),
                     .angle = dt * vec3_length(spin) };
    p.turn = now->radius * real_min(p.angle, 2) + beside;
    p.reach = vec3_length(p.way) + p.turn;
    return p;
}

static void look_at_body(world *w, int b)
{
    rigid_tables *t = &w->rigid;
    const body *x = &w->body[b];
    const particle *p = w->pool.at + x->first;
    bool moved = t->moves[b];
    t->moves[b] = (char)(!body_is_soft(x) && body_moves(w, b));
    if (!t->moves[b] && !moved) return;
    solver_body *now = &t->now[b];
    now->frame = rigid4_frame(p);
    t->ball[b].center = now->frame.center;
    memset(&t->moved[b], 0, sizeof t->moved[b]);
    if (t->moves[b]) {
        now->basis = basis_find(x->rigid, &now->frame);
        t->velocity[b] = motion_of(p, &now->frame, &now->basis, w->age);
        t->ahead[b] = predict(w, now, &t->velocity[b]);
    } else {
        now->basis = (motion_basis){ .inverse_mass = 0 };
        memset(&t->velocity[b], 0, sizeof t->velocity[b]);
        t->ahead[b] = (prediction){ .reach = 0 };
    }
    t->reach[b] = t->ahead[b].reach;
}

static void look_at_chunk(void *data, int item)
{
    world *w = data;
    int first, end = chunk_of(w, item, &first);
    for (int b = first; b < end; b++) look_at_body(w, b);
}

static void look_at_bodies(world *w)
{
    tasks_run(w->options.host.run, look_at_chunk, w, task_chunks(w->bodies));
}
//<

//> step-wake
// Are two bodies so near that they may meet in this frame?
static bool may_meet(const rigid_tables *t, int a, int b)
{
    real near = t->ball[a].radius + t->ball[b].radius + t->reach[a]
              + t->reach[b];
    vec3 d = vec3_sub(t->ball[a].center, t->ball[b].center);
    return vec3_length_squared(d) <= near * near;
}

static void wake_sleepers(world *w)
{
    const rigid_tables *t = &w->rigid;
    bool woke = false;
    for (int k = 0; k < t->pairs.count; k++) {
        int a = t->pairs.pair[k][0], b = t->pairs.pair[k][1];
        if (w->sleep.asleep[a] != w->sleep.asleep[b] && may_meet(t, a, b))
            woke |= world_wake_near(w, a, b);
    }
    if (woke) look_at_bodies(w);
}
//<

//> step-pairs
static void find_pairs(world *w)
{
    rigid_tables *t = &w->rigid;
    pair_query q = { t->ball, t->reach, t->dynamic, w->bodies };
    int lost;
    t->is_new_list = pair_list_update(&t->pairs, &q, &lost);
    w->report.dropped += lost;
    w->report.pairs = t->pairs.count;
    wake_sleepers(w);
}
//<

//> step-contacts
static cache_frame what_to_ask(const world *w)
{
    const rigid_tables *t = &w->rigid;
    return (cache_frame){
        .body = t->body, .now = t->now, .ahead = t->ahead, .moves = t->moves,
        .bodies = w->bodies, .list = &t->pairs, .is_new_list = t->is_new_list,
        .plane = w->plane, .planes = w->planes, .stay = w->options.stay,
        .run = w->options.host.run };
}

static void find_contacts(world *w)
{
    rigid_tables *t = &w->rigid;
    cache_frame f = what_to_ask(w);
    cache_update(&t->cache, &f);
    w->report.queries = (int)t->cache.queries;
    w->report.contacts = t->cache.actives;
    w->report.dropped += t->cache.lost;
}
//<

//> step-again
// Bodies that turn come to touch elsewhere than was found: those that have turned
// much by substep k, and may touch now, are asked again.
static void look_again(world *w, const solver_frame *f, int k)
{
    rigid_tables *t = &w->rigid;
    contact_cache *c = &t->cache;
    const contact *const *table = (const contact *const *)c->active;
    if (c->turnings == 0 || t->solver.touching == 0) return;
    cache_frame ask = what_to_ask(w);
    int n = cache_turning(c, &ask, t->moved, k, f->substeps, t->later);
    if (n == 0) return;
    solver_hold(&t->solver, c->again, n, c->active);
    cache_again(c, &ask, t->later);
    solver_renew(&t->solver, f, c->again, n, table, c->reach, t->later,
                 t->moved);
    w->report.queries += n;
}
//<

//> step-substeps
// A contact that carries a force F gives way by about F h^2 / m, with m the
// effective mass of its two bodies.  A frame takes so many substeps that this
// is no more than SAG of the smaller radius where a body lies on one that is
// EVEN times lighter, or more: that many for its own weight, whatever it pushes
// in this frame.
static const real SAG = 0.0025, EVEN = 30;
enum { MOST_TIMES = 8 };

// 1/s^2: what the contact has to bear, F / m, beside the smaller radius.
static real uneven_pace(const world *w, const contact *c)
{
    const solver_body *a = &w->rigid.now[c->a], *b = &w->rigid.now[c->b];
    real x = a->basis.inverse_mass, y = b->basis.inverse_mass;
    if (!(x > 0 && y > 0) || (x < EVEN * y && y < EVEN * x)) return 0;
    real ratio = x > y ? x / y : y / x, up = x > y ? 1 : -1;
    real bears = up * vec3_dot(c->normal, w->options.gravity);
    return real_max(bears, 0) * ratio / real_min(a->radius, b->radius);
}

static int substeps_for_heavy(const world *w)
{
    const contact_solver *s = &w->rigid.solver;
    const world_options *o = &w->options;
    real most = 0;
    if (w->rigid.heaviest < EVEN * w->rigid.lightest) return 0;
    for (int k = 0; k < s->contacts; k++)
        if (s->active[k].sides == TWO_SIDED && s->active[k].load > 0)
            most = real_max(most, uneven_pace(w, w->rigid.cache.active[k]));
    return (int)real_min(o->dt * sqrt(most / SAG),
                         (real)MOST_TIMES * o->substeps);
}

// Where nothing goes further than a sixteenth of its radius in a frame, three
// quarters of the usual substeps do, unless a stack needs all of them; or more
// than twice as many, as small bodies do, which gravity takes further beside
// their radius.  (For less than that it is not worth the jolt.)
static const real STACK_SAG = 0.0065;

static real substeps_for_stack(const world *w)
{
    const contact_solver *s = &w->rigid.solver;
    real most = 0;
    for (int k = 0; k < s->contacts; k++)
        most = real_max(most, s->active[k].pace);
    return real_min(w->frame * sqrt(most / w->age / STACK_SAG),
                    (real)MOST_TIMES * w->options.substeps);
}

static bool is_calm(const world *w)
{
    for (int b = 0; b < w->bodies; b++) {
        vec3 way = w->rigid.ahead[b].way;
        real far = w->rigid.now[b].radius / 16;
        if (vec3_length_squared(way) > far * far) return false;
    }
    return true;
}

// Every change of their number jolts what rests: it rises at once, and falls
// when it has been too high for PATIENCE frames.
enum { PATIENCE = 30 };

static int hold(substep_choice *c, int need)
{
    c->frames = need < c->now ? c->frames + 1 : 0;
    if (need > c->now || c->frames > PATIENCE) c->now = need;
    return c->now;
}

// A part of a divided frame takes its share of the substeps that a frame may
// have more than usual.
static int choose_substeps(world *w)
{
    int usual = w->options.substeps;
    int most = int_max(w->options.most_substeps, usual);
    real share = w->frame / w->options.dt;
    int n = usual;
    if (w->softs == 0 && is_calm(w)) {
        real need = substeps_for_stack(w);
        if (need <= 0.75 * usual) n = (3 * usual + 3) / 4;
        if (need > 2 * usual) n = (int)need + 1;
    }
    n = hold(&w->rigid.substeps, int_max(n, substeps_for_heavy(w)));
    if (share < 1) n = int_max(usual, (int)(share * n));
    if (w->softs > 0) n = int_max(n, soft_substeps(w));
    return int_min(n, int_max((int)(share * most), usual));
}
//<

//> step-prepare
// Contacts are damped ten times as much as would just not swing, and push out
// at 3 m/s at most.  In smaller substeps their springs may be stiffer.
static solver_frame frame_of(const world *w, int substeps)
{
    const world_options *o = &w->options;
    real h = w->frame / substeps;
    return (solver_frame){
        .body = w->rigid.now, .bodies = w->bodies,
        .placed = w->rigid.cache.placed, .plane = w->plane, .h = h,
        .substeps = substeps,
        .warm = o->warm_start ? h / w->age : 0, .friction = o->friction,
        .hertz = o->hertz, .damping = 10, .max_speed = 3,
        .restitution = o->restitution, .gravity = o->gravity,
        .run = o->host.run };
}

static void count_deep(world *w)
{
    const contact_solver *s = &w->rigid.solver;
    for (int k = 0; k < s->contacts; k++)
        w->report.unconverged += s->active[k].is_deep;
}

static solver_frame prepare(world *w)
{
    rigid_tables *t = &w->rigid;
    solver_frame f = frame_of(w, 1);
    const contact *const *table = (const contact *const *)t->cache.active;
    bool done = solver_look(&t->solver, &f, table, t->cache.reach,
                            t->cache.actives);
    f = frame_of(w, choose_substeps(w));
    done = done && solver_prepare(&t->solver, &f, table);
    if (!done) w->report.dropped += t->cache.actives;
    cache_note(&t->cache, &t->solver);
    count_deep(w);
    return f;
}
//<

//> step-substep
// A velocity is that in the middle of a substep.  The last one may have been of
// another length.
static void fall(world *w, real seconds)
{
    vec3 g = vec3_scale(seconds, w->options.gravity);
    for (int b = 0; b < w->bodies; b++) {
        if (!w->rigid.moves[b]) continue;
        real *u = w->rigid.velocity[b].of;
        u[0] += g.x;
        u[1] += g.y;
        u[2] += g.z;
    }
}

static void advance(world *w, real h)
{
    for (int b = 0; b < w->bodies; b++)
        for (int i = 0; i < MOTIONS; i++)
            w->rigid.moved[b].of[i] += h * w->rigid.velocity[b].of[i];
}

static void bounce(world *w, const solver_frame *f)
{
    rigid_tables *t = &w->rigid;
    const contact *const *table = (const contact *const *)t->cache.active;
    if (!(w->options.restitution > 0)) return;
    if (restitution_solve(table, t->cache.actives, f, t->velocity, t->moved))
        solver_see_gaps(&t->solver, f, t->moved);
}

static void substep(world *w, const solver_frame *f, int k, real *since)
{
    rigid_tables *t = &w->rigid;
    fall(w, k == 0 ? (w->age + f->h) / 2 : f->h);
    w->ledger_ahead = f->h / 2;
    ledger_book(w, LEDGER_INTEGRATE);
    bounce(w, f);
    solver_begin(&t->solver, f, t->velocity, k == 0);
    solver_push(&t->solver, f, t->velocity, t->moved);
    advance(w, f->h);
    w->ledger_ahead = -f->h / 2;
    solver_relax(&t->solver, f, t->velocity, t->moved);
    solver_end(&t->solver, t->velocity);
    ledger_book(w, LEDGER_CONTACTS);
    lap(w, PHASE_SOLVE, since);
    if (w->softs > 0) soft_substep(w, f->h);
    lap(w, PHASE_SOFT, since);
}
//<

//> step-brake
// What moves: its kinetic energy (J), and its mass (kg).  A body whose numbers
// are lost does not count.
typedef struct {
    real energy, mass;
} motion_sum;

static void add_motion(motion_sum *s, real energy, real inverse_mass)
{
    if (!(energy < HUGE_VAL) || !(inverse_mass > 0)) return;
    s->energy += energy;
    s->mass += 1 / inverse_mass;
}

static motion_sum rigid_motion(const world *w)
{
    motion_sum s = { 0, 0 };
    for (int b = 0; b < w->bodies; b++) {
        const motion_basis *basis = &w->rigid.now[b].basis;
        if (w->rigid.moves[b])
            add_motion(&s, motion_energy(basis, &w->rigid.velocity[b]),
                       basis->inverse_mass);
    }
    return s;
}

static void add_soft_motion(motion_sum *s, const world *w, const body *x)
{
    for (int i = x->first; i < x->first + body_particles(x); i++) {
        const particle *p = &w->pool.at[i];
        vec3 way = vec3_sub(p->position, p->previous);
        real square = vec3_length_squared(way) / (w->age * w->age);
        add_motion(s, square / (2 * p->inverse_mass), p->inverse_mass);
    }
}

// Contacts create no motion: beside what there is, only gravity does, and the
// speed at which overlaps are pushed out.  sqrt(2 energy / mass) is a length in
// the space of all velocities: these three add up to no more than their sum.
static real most_motion(const world *w, const solver_frame *f)
{
    motion_sum s = rigid_motion(w);
    for (int b = 0; b < w->bodies && w->softs > 0; b++)
        if (body_is_soft(&w->body[b]) && body_moves(w, b))
            add_soft_motion(&s, w, &w->body[b]);
    real more = w->frame * vec3_length(w->options.gravity) + f->max_speed;
    real most = sqrt(s.energy) + sqrt(s.mass / 2) * more;
    return most * most;
}

// The rows of a contact are those of the frame's start.  Where bodies turn by
// radians in a frame, and friction is strong, impulses along them may give what
// nothing had: that is taken back.  A body that had numbers, and has none after
// the substeps, stands still.
static void stop_lost(world *w, int b)
{
    rigid_tables *t = &w->rigid;
    real energy = motion_energy(&t->now[b].basis, &t->velocity[b]);
    if (energy < HUGE_VAL || !(t->reach[b] < HUGE_VAL)) return;
    memset(&t->velocity[b], 0, sizeof t->velocity[b]);
    memset(&t->moved[b], 0, sizeof t->moved[b]);
}

static void brake(world *w, real most)
{
    for (int b = 0; b < w->bodies; b++) stop_lost(w, b);
    real now = rigid_motion(w).energy, share = sqrt(most / now);
    if (!(now > most)) return;
    for (int b = 0; b < w->bodies; b++) {
        for (int i = 0; i < MOTIONS && w->rigid.moves[b]; i++) {
            w->rigid.velocity[b].of[i] *= share;
            w->rigid.moved[b].of[i] *= share;
        }
    }
}
//<

//> step-planes
// Contacts are those of the frame's start, and what was hit hard may turn past
// them: but no centre goes behind a plane, or further behind than it was.
static void stop_at_plane(world *w, int b, plane p)
{
    real *way = w->rigid.moved[b].of, *u = w->rigid.velocity[b].of;
    real n[3] = { p.normal.x, p.normal.y, p.normal.z };
    real was = plane_height(p, w->rigid.now[b].frame.center);
    real up = n[0] * way[0] + n[1] * way[1] + n[2] * way[2];
    real speed = n[0] * u[0] + n[1] * u[1] + n[2] * u[2];
    real least = -real_max(was, 0);
    if (!(up < least)) return;
    for (int i = 0; i < 3; i++) {
        way[i] += (least - up) * n[i];
        u[i] -= real_min(speed, 0) * n[i];
    }
}

static void stop_chunk(void *data, int item)
{
    world *w = data;
    int first, end = chunk_of(w, item, &first);
    for (int b = first; b < end; b++)
        for (int k = 0; k < w->planes && w->rigid.moves[b]; k++)
            stop_at_plane(w, b, w->plane[k]);
}

static void stop_at_planes(world *w)
{
    tasks_run(w->options.host.run, stop_chunk, w, task_chunks(w->bodies));
}
//<

//> step-move
// Bodies that turn little go in one move, those of one shape together.
enum { ALIKE = TASK_CHUNK };

static int find_alike(const world *w, int b, int end, int first[ALIKE])
{
    const rigid_tables *t = &w->rigid;
    int n = 0;
    for (int k = b; k < end; k++) {
        if (!t->moves[k]) continue;
        if (w->body[k].rigid != w->body[b].rigid) break;
        if (motion_moves(&t->now[k].basis, &t->moved[k]) > 1) break;
        first[n++] = w->body[k].first;
    }
    return n;
}

static void begin_moves(world *w, int first, int end)
{
    rigid_tables *t = &w->rigid;
    for (int b = first; b < end; b++) {
        if (!t->moves[b]) continue;
        const solver_body *now = &t->now[b];
        motion_begin(w->pool.at + w->body[b].first, &now->frame, &now->basis,
                     &t->moved[b], motion_moves(&now->basis, &t->moved[b]));
    }
}

// Body b alone, in several moves.
static rigid4_result relax_turning(world *w, int b)
{
    const body *x = &w->body[b];
    particle *p = w->pool.at + x->first;
    rigid4_result sum = { .worst = 0 };
    int moves = motion_moves(&w->rigid.now[b].basis, &w->rigid.moved[b]);
    for (int k = 0; k < moves; k++) {
        if (k > 0) motion_go_on(p);
        rigid4_result r = rigid4_relax(x->rigid, p, w->options.iterations,
                                       w->options.relax);
        sum.tested += r.tested;
        sum.relaxed += r.relaxed;
        sum.fell_back |= r.fell_back;
        sum.worst = fmax(sum.worst, r.worst);
    }
    return sum;
}

static void relax_moves(world *w, int b, int end)
{
    int first[ALIKE];
    while (b < end) {
        if (!w->rigid.moves[b]) {
            b++;
            continue;
        }
        int n = find_alike(w, b, end, first), start = b;
        if (n == 0) {
            w->rigid.relaxed[b] = relax_turning(w, b);
            b++;
            continue;
        }
        w->rigid.relaxed[start] = rigid4_relax_all(w->body[b].rigid,
            w->pool.at, first, n, w->options.iterations, w->options.relax);
        for (; n > 0; b++) n -= w->rigid.moves[b];
    }
}
//<

//> step-move-end
static void end_move(world *w, int b, real h)
{
    rigid_tables *t = &w->rigid;
    const body *x = &w->body[b];
    const real *d = t->moved[b].of;
    vec3 way = { d[0], d[1], d[2] };
    vec3 turn = motion_rotation(&t->now[b].basis, &t->moved[b]);
    motion_end(x->rigid, w->pool.at + x->first, &t->now[b].frame,
               &t->velocity[b], h);
    cache_moved(&t->cache, b, vec3_length(way)
                              + t->now[b].radius * vec3_length(turn));
}

typedef struct {
    world *w;
    real h;
} moving;

static void move_chunk(void *data, int item)
{
    const moving *m = data;
    world *w = m->w;
    int first, end = chunk_of(w, item, &first);
    for (int b = first; b < end; b++)
        w->rigid.relaxed[b] = (rigid4_result){ .worst = 0 };
    begin_moves(w, first, end);
    relax_moves(w, first, end);
    for (int b = first; b < end; b++)
        if (w->rigid.moves[b]) end_move(w, b, m->h);
}

static void move_bodies(world *w, real h)
{
    moving m = { w, h };
    tasks_run(w->options.host.run, move_chunk, &m, task_chunks(w->bodies));
    for (int b = 0; b < w->bodies; b++) {
        const rigid4_result *r = &w->rigid.relaxed[b];
        w->report.tested += r->tested;
        w->report.relaxed += r->relaxed;
        w->report.fell_back += r->fell_back;
        w->report.unconverged += !(r->worst <= 0.01);
    }
    if (w->softs > 0) w->report.unconverged += soft_stretched(w);
    w->ledger_ahead = 0;
    ledger_book(w, LEDGER_STICKS);
}
//<

//> step-sleep
// What sleeps is pinned where it lies: the other phases only look at what moves.
static void put_to_sleep(world *w, const body *b)
{
    for (int i = b->first; i < b->first + body_particles(b); i++) {
        particle *p = &w->pool.at[i];
        p->inverse_mass = 0;
        p->previous = p->position;
    }
}

// Does body b lie pinned?  Particles that were pinned from the start do not show.
static bool is_put_to_sleep(const world *w, const body *b)
{
    int i = b->first, last = i + body_particles(b) - 1;
    while (i < last && !(w->inverse_mass[i] > 0)) i++;
    return w->pool.at[i].inverse_mass == 0;
}

// Islands are held together by what the contacts carried last.
static void join_islands(world *w)
{
    const contact_solver *s = &w->rigid.solver;
    w->report.pushing = 0;
    for (int k = 0; k < s->contacts; k++) {
        const active_contact *x = &s->active[k];
        if (!(x->load > 0)) continue;
        w->report.pushing++;
        if (x->b >= 0 && !body_is_static(&w->body[x->b]))
            sleep_touch(&w->sleep, x->a, x->b);
    }
}

static void observe(world *w)
{
    const world_options *o = &w->options;
    sleep_rule rule = { o->sleep_speed, o->time_to_sleep,
                        vec3_length(o->gravity), o->dt, w->age };
    for (int b = 0; b < w->bodies; b++) {
        const body *x = &w->body[b];
        if (!body_moves(w, b)) continue;
        real radius = x->rigid ? x->rigid->radius : x->shape->radius;
        sleep_observe(&w->sleep, b, w->pool.at, x->first, body_particles(x),
                      radius, &rule);
    }
}

static void fall_asleep(world *w)
{
    join_islands(w);
    if (w->options.sleep_speed > 0) {
        observe(w);
        sleep_end(&w->sleep);
    }
    for (int b = 0; b < w->bodies; b++) {
        const body *x = &w->body[b];
        if (!w->sleep.asleep[b] || body_is_static(x)) continue;
        if (!is_put_to_sleep(w, x)) put_to_sleep(w, x);
        w->report.asleep++;
    }
}
//<
