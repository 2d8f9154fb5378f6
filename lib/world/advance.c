//> advance-kinds
#include "advance.h"
#include "drive.h"
#include "join.h"

#include <stddef.h>

// What moves freely, or is driven, has a new frame in every substep, and its rows
// are made there.  What touches a driven body that turns goes by halves: its rows
// are made in the middle, whose velocities they have.  What lies has its rows where
// its contacts were found: it is displaced, until it leaves the margin that they
// have.  (Not what has a weight of its own: where a ball's is off its middle, its
// arm changes with every turn, and with it the period at which it rocks.)
static bool rests_in_place(const world *w, int b)
{
    const rigid_tables *t = &w->rigid;
    return t->moves[b] && !t->now[b].is_driven && !linkage_has(&w->joints, b)
        && vec3_length_squared(w->options.gravity) > 0
        && t->ahead[b].reach <= w->options.stay * t->now[b].radius
        && !w->body[b].is_weighed;
}

static void rest_in_place(world *w, int b)
{
    rigid_tables *t = &w->rigid;
    if (b < 0 || t->going[b] != GOES_EXACTLY || !rests_in_place(w, b)) return;
    t->going[b] = LIES;
    t->fresh[b] = false;
    t->middle[b] = t->cache.placed[b];
    t->lying[b] = basis_find(w->body[b].rigid, &t->middle[b]);
}

static bool turns_driven(const world *w, int b)
{
    return w->rigid.now[b].is_driven
        && vec3_length_squared(w->rigid.drive[b].spin) > 0;
}

static void touch_turning(world *w, int a, int b)
{
    const solver_body *now = w->rigid.now;
    if (b < 0 || !(turns_driven(w, a) || turns_driven(w, b))) return;
    int side[2] = { a, b };
    for (int i = 0; i < 2; i++) {
        if (!w->rigid.moves[side[i]]) continue;
        w->rigid.going[side[i]] = GOES_BY_HALVES;
        w->rigid.middle[side[i]] = now[side[i]].frame;
    }
}

void advance_begin(world *w)
{
    rigid_tables *t = &w->rigid;
    t->elapsed = 0;
    for (int k = 0; k < t->awakes; k++) {
        int b = t->awake[k];
        t->going[b] = GOES_EXACTLY;
        t->fresh[b] = t->moves[b];
        t->now[b].is_joined = linkage_has(&w->joints, b);
        t->touches[b] = (char)(t->moves[b] && t->now[b].is_joined);
        t->began[b] = t->now[b].frame;
    }
    for (int k = 0; k < t->solver.contacts; k++) {
        const active_contact *x = &t->solver.active[k];
        if (x->count == 0) continue;
        t->touches[x->a] = t->moves[x->a];
        if (x->b >= 0) t->touches[x->b] = t->moves[x->b];
        rest_in_place(w, x->a);
        rest_in_place(w, x->b);
        if (w->kinematic_bodies > 0) touch_turning(w, x->a, x->b);
    }
}
//<

//> advance-displace
//>   What is displaced gets a frame for it when it leaves its margin.
static bool is_within(const solver_body *now, const motion *d, real margin)
{
    vec3 delta = motion_straight(d);
    vec3 turn = motion_rotation(&now->basis, d);
    real far = margin * now->radius;
    return vec3_length_squared(delta) <= far * far
        && vec3_length_squared(turn) <= margin * margin;
}

// A body that is displaced, too, gets a frame for it.  Was it?
static bool displace(world *w, int b)
{
    rigid_tables *t = &w->rigid;
    solver_body *now = &t->now[b];
    if (!motion_is_some(&t->moved[b])) return false;
    motion_displace(&now->frame, &now->basis, &t->velocity[b], &t->moved[b]);
    t->moved[b] = (motion){ { 0 } };
    return true;
}

// What was struck is where it would have begun with its new velocity.
void advance_struck(world *w)
{
    rigid_tables *t = &w->rigid;
    for (int k = 0; k < t->awakes; k++) {
        int b = t->awake[k];
        t->fresh[b] = t->now[b].is_struck;
        if (t->fresh[b] && t->going[b] == LIES) t->going[b] = GOES_EXACTLY;
        t->now[b].is_struck = false;
    }
}

//<

//> advance-joined
//>   What is joined is put where its joints have found that it comes (chapter
//>   17).
static rigid_frame moved_by(const solver_body *now, const motion *u, real h)
{
    motion d;
    for (int i = 0; i < MOTIONS; i++) d.of[i] = h * u->of[i];
    return motion_frame(&now->frame, &now->basis, &d);
}

// Where its joints have found that it comes.
static void advance_joined(world *w, int b, real h)
{
    rigid_tables *t = &w->rigid;
    solver_body *now = &t->now[b];
    if (t->going[b] == GOES_BY_HALVES)
        t->middle[b] = moved_by(now, &t->velocity[b], h / 2);
    solver_frame f = { .body = t->now, .h = h };
    linkage_pass q = join_pass(w, &f);
    linkage_advance(&w->joints, &q, b, now);
    t->moved[b] = (motion){ { 0 } };
}

//<

//> advance-body
//>   A body moves by the kind that it is of. What is displaced gets no new frame,
//>   and `fresh` says so to the solver. What is driven goes by the clock, so that
//>   no error adds up.
// For h (s) from `seconds` after the substeps began.
static void advance_exactly(world *w, int b, real seconds, real h)
{
    rigid_tables *t = &w->rigid;
    solver_body *now = &t->now[b];
    if (now->is_driven) drive_advance(w, b, seconds + h);
    else motion_advance(&now->frame, &now->basis, &t->velocity[b], h);
}

static void advance_body(world *w, int b, real h)
{
    rigid_tables *t = &w->rigid;
    motion sum = t->moved[b];
    for (int i = 0; i < MOTIONS; i++) sum.of[i] += h * t->velocity[b].of[i];
    t->fresh[b] = !(t->going[b] == LIES
                    && is_within(&t->now[b], &sum, w->options.stay));
    if (!t->fresh[b]) {
        t->moved[b] = sum;
        return;
    }
    if (!t->now[b].is_driven && linkage_has(&w->joints, b)) {
        advance_joined(w, b, h);
        return;
    }
    displace(w, b);
    if (t->going[b] == LIES) t->going[b] = GOES_EXACTLY;
    real seconds = t->elapsed;
    if (t->going[b] == GOES_BY_HALVES) {
        h /= 2;
        advance_exactly(w, b, seconds, h);
        t->middle[b] = t->now[b].frame;
        seconds += h;
    }
    advance_exactly(w, b, seconds, h);
}

//<

//> advance-bodies
//>   Bodies are shared among threads, 32 at a time.
typedef struct {
    world *w;
    real h;
} advance;

static void advance_chunk(void *data, int item)
{
    const advance *a = data;
    const rigid_tables *t = &a->w->rigid;
    int end = task_end(item, t->awakes);
    for (int k = task_first(item); k < end; k++)
        if (t->moves[t->awake[k]]) advance_body(a->w, t->awake[k], a->h);
}

void advance_bodies(world *w, real h)
{
    advance a = { w, h };
    tasks_run(w->options.host.run, advance_chunk, &a,
              task_chunks(w->rigid.awakes));
    w->rigid.elapsed += h;
}
//<

//> advance-back
//>   A substep that joints swing too fast for is done again, from here.
void advance_mark(world *w)
{
    rigid_tables *t = &w->rigid;
    for (int k = 0; k < t->awakes; k++) {
        int b = t->awake[k];
        t->now_then[b] = t->now[b];
        t->velocity_then[b] = t->velocity[b];
        t->moved_then[b] = t->moved[b];
    }
    t->elapsed_then = t->elapsed;
    solver_mark(&t->solver);
    linkage_mark(&w->joints);
}

void advance_back(world *w)
{
    rigid_tables *t = &w->rigid;
    t->elapsed = t->elapsed_then;
    for (int k = 0; k < t->awakes; k++) {
        int b = t->awake[k];
        t->now[b] = t->now_then[b];
        t->velocity[b] = t->velocity_then[b];
        t->moved[b] = t->moved_then[b];
        if (t->going[b] == GOES_BY_HALVES) t->middle[b] = t->now[b].frame;
    }
    solver_rewind(&t->solver);
}
//<

//> advance-end
//>   When the substeps are over, what was displaced gets its frame. A body
//>   whose numbers are lost goes back to where it was.
static bool is_lost(const world *w, int b)
{
    const rigid_tables *t = &w->rigid;
    real energy = motion_energy(&t->now[b].basis, &t->velocity[b]);
    const rigid_frame *f = &t->now[b].frame;
    bool stands = vec3_is_finite(f->center);
    for (int i = 0; i < FOUR_AXES; i++) stands &= vec3_is_finite(f->axis[i]);
    return !(energy < HUGE_VAL) || !stands;
}

void advance_stop(world *w, int b)
{
    rigid_tables *t = &w->rigid;
    t->now[b].frame = t->began[b];
    t->now[b].basis = basis_find(w->body[b].rigid, &t->began[b]);
    t->velocity[b] = t->moved[b] = (motion){ { 0 } };
}

int advance_end(world *w)
{
    rigid_tables *t = &w->rigid;
    int lost = 0;
    for (int k = 0; k < t->awakes; k++) {
        int b = t->awake[k];
        if (!t->moves[b]) continue;
        displace(w, b);
        motion_straighten(w->body[b].rigid, &t->now[b].frame);
        if (!is_lost(w, b)) continue;
        advance_stop(w, b);
        t->island[t->island[b].parent].is_lost = true;
        lost++;
    }
    return lost;
}
//<

//> advance-put
//>   The particles follow, and the cache learns how far each body has gone.
real advance_turned(const world *w, int b, const rigid_frame *was)
{
    const rigid_frame *now = &w->rigid.now[b].frame;
    const real *square = w->body[b].rigid->square;
    real turned = 0;
    for (int i = 0; i < FOUR_AXES; i++) {
        vec3 d = vec3_sub(now->axis[i], was->axis[i]);
        turned += vec3_length_squared(d) / square[i];
    }
    return sqrt(turned / 2);
}

real advance_leaned(const world *w, int b, const rigid_frame *was)
{
    const rigid4 *r = w->body[b].rigid;
    if (r->round_axes == 0) return advance_turned(w, b, was);
    if (r->round_axes == FOUR_AXES) return 0;
    return vec3_distance(w->rigid.now[b].frame.axis[1], was->axis[1])
         / sqrt(r->square[1]);
}

// m: no vertex has gone further.
static real furthest_path(const world *w, int b)
{
    const rigid_tables *t = &w->rigid;
    const rigid_frame *was = &t->began[b];
    real out = t->now[b].radius - w->body[b].round;
    return vec3_distance(t->now[b].frame.center, was->center)
         + out * advance_turned(w, b, was);
}

static void write_chunk(void *data, int item)
{
    world *w = data;
    rigid_tables *t = &w->rigid;
    int end = task_end(item, t->awakes);
    for (int k = task_first(item); k < end; k++) {
        int b = t->awake[k];
        if (!t->moves[b]) continue;
        motion_write(w->pool.at + w->body[b].first, &t->now[b].frame,
                     &t->now[b].basis, &t->velocity[b], t->age[b]);
        cache_moved(&t->cache, b, furthest_path(w, b));
    }
}

// Pieces have gone as far as the body that they ride on.
static void write_pieces(world *w, int b)
{
    struct placing *at = w->rigid.cache.placing;
    for (int k = w->body[b].next; k > 0; k = w->body[k - 1].next)
        cache_moved(&w->rigid.cache, k - 1, at[b].path - at[k - 1].path);
}

void advance_write(world *w)
{
    const rigid_tables *t = &w->rigid;
    tasks_run(w->options.host.run, write_chunk, w, task_chunks(t->awakes));
    for (int k = 0; k < t->awakes && w->has_pieces; k++)
        if (t->moves[t->awake[k]]) write_pieces(w, t->awake[k]);
}
//<
