//> guard-most
//>   How much energy may there be? What there was, and what gravity, motors and
//>   forces may add.
#include "guard.h"
#include "actuator.h"
#include "advance.h"
#include "drive.h"
#include "handle.h"
#include "join.h"
#include "rungs.h"

#include <float.h>
#include <stddef.h>
#include <string.h>

// A body whose numbers are lost does not count.
static void add_motion(island *i, real energy, vec3 velocity, real inverse_mass)
{
    if (!(energy < HUGE_VAL) || !(inverse_mass > 0)) return;
    i->energy += energy;
    i->mass += 1 / inverse_mass;
    i->momentum = vec3_add_scaled(i->momentum, 1 / inverse_mass, velocity);
}

static island *budget_of(const world *w, int b)
{
    return &w->rigid.island[w->rigid.island[b].parent];
}

// Of each island: what moves, and may touch something.
static void sum_motion(world *w)
{
    const rigid_tables *t = &w->rigid;
    for (int k = 0; k < t->awakes; k++) {
        island *i = &t->island[t->awake[k]];
        i->energy = i->mass = 0;
        i->momentum = (vec3){ 0, 0, 0 };
    }
    for (int k = 0; k < t->awakes; k++) {
        int b = t->awake[k];
        const motion_basis *basis = &t->now[b].basis;
        const motion *u = &t->velocity[b];
        if (t->touches[b] && !t->now[b].is_driven)
            add_motion(budget_of(w, b), motion_energy(basis, u),
                       motion_straight(u), basis->inverse_mass);
    }
}

static void add_soft_motion(island *of, const world *w, const body *x)
{
    of->energy += soft_energy(x, w->pool.at);
    for (int i = x->first; i < x->first + body_particles(x); i++) {
        const particle *p = &w->pool.at[i];
        vec3 delta = vec3_sub(p->position, p->previous);
        real square = vec3_length_squared(delta) / (w->age * w->age);
        add_motion(of, square / (2 * p->inverse_mass),
                   vec3_scale(1 / w->age, delta), p->inverse_mass);
    }
}

static const rigid_frame *side_frame(const world *w, int b)
{
    return b < 0 ? &JOINT_WORLD : &w->rigid.now[b].frame;
}

// J: the kinetic energy that loads would give to bodies at rest.
static void sum_loads(world *w)
{
    for (int k = 0; k < w->rigid.awakes && w->rigid.is_loaded; k++) {
        int b = w->rigid.awake[k];
        if (!w->rigid.touches[b]) continue;
        motion u = world_load(w, b, w->frame);
        budget_of(w, b)->loads += motion_energy(&w->rigid.now[b].basis, &u);
    }
}

static void sum_drives(world *w)
{
    for (int k = 0; k < w->joints.count; k++) {
        const joint *j = &w->joints.joint[k];
        island *i = j->is_driven ? rungs_island(w, j->a, j->b) : NULL;
        if (!i || j->is_broken) continue;
        real place = joint_where(j, side_frame(w, j->a), side_frame(w, j->b));
        i->drives += sqrt(actuator_energy(j, place, w->frame));
    }
}

// The largest of all pairs that may touch in this frame.
static real largest_restitution(const world *w, const solver_frame *f)
{
    const rigid_tables *t = &w->rigid;
    real most = 0;
    for (int k = 0; k < t->cache.actives; k++) {
        const contact *c = t->cache.active[k];
        most = real_max(solver_material(f, c->a, c->b).restitution, most);
    }
    return most;
}

// Contacts create no motion: beside what there is in an island, and what bends and
// links have stored, only gravity does, what pushes from outside, motors and
// springs, the speed at
// which overlaps are pushed out, and what is driven: it gives others its own
// speed, and as much again if they bounce off it.  sqrt(2 energy / mass) is a
// length in the space of all velocities: these add up to no more than their sum.
void guard_begin(world *w, const solver_frame *f)
{
    const rigid_tables *t = &w->rigid;
    sum_motion(w);
    sum_loads(w);
    sum_drives(w);
    for (int k = 0; k < t->awakes && w->softs > 0; k++) {
        int b = t->awake[k];
        if (body_is_soft(&w->body[b]) && body_moves(w, b))
            add_soft_motion(budget_of(w, b), w, &w->body[b]);
    }
    real gravity = w->most_gravity * vec3_length(w->options.gravity);
    real driven = drive_fastest(w), more = w->frame * gravity;
    if (driven > 0) more += (1 + largest_restitution(w, f)) * driven;
    for (int k = 0; k < t->awakes; k++) {
        island *i = &t->island[t->awake[k]];
        real most = sqrt(i->energy) + sqrt(i->loads) + i->drives
                  + sqrt(i->mass / 2) * (more + f->max_rate * i->largest);
        i->most = most * most;
    }
}
//<

//> guard-brake
//>   If an island has more than that, all of it is slowed by the same share, as
//>   its centre of mass sees it: what is too much came from inside, and momentum
//>   does not.
// An island whose centre of mass alone has more was pushed from outside: it is slowed
// as the world sees it, and so is one whose numbers are lost: some of it was stopped.
static void slow_down(world *w, int b, const island *i)
{
    if (w->rigid.now[b].is_driven || !w->rigid.touches[b]) return;
    vec3 mean = vec3_scale(1 / i->mass, i->momentum);
    real common = vec3_dot(mean, i->momentum) / 2;
    if (i->is_lost || !(common < i->most)) {
        mean = (vec3){ 0, 0, 0 };
        common = 0;
    }
    real fraction = sqrt((i->most - common) / (i->energy - common));
    real *u = w->rigid.velocity[b].of;
    real with[MOTIONS] = { mean.x, mean.y, mean.z };
    for (int k = 0; k < MOTIONS; k++) u[k] = with[k] + fraction * (u[k] - with[k]);
}

// With more than so many times the energy that is right, no body of an island
// was solved: speeds are ten times too high.  With half or twice as many the
// same worlds are reported; what friction gives is far less.
static const real WILD = 100;               // tuned, times

// The impulses that gave it would give it again.
static void forget_impulses(world *w)
{
    rigid_tables *t = &w->rigid;
    for (int k = 0; k < t->solver.contacts; k++) {
        const island *i = rungs_island(w, t->solver.active[k].a, -1);
        if (i && i->is_lost) solver_forget(&t->solver, t->cache.active, k);
    }
    for (int k = 0; k < w->joints.count; k++) {
        const joint *j = &w->joints.joint[k];
        const island *i = rungs_island(w, j->a, j->b);
        if (i && i->is_lost) linkage_forget_impulses(&w->joints, k);
    }
}

// A wild island stands again where the frame began: where its substeps have thrown
// it, its joints would be far apart.  And what was stopped does not rest: it must
// not fall asleep in mid-air.
static void report_lost(world *w, int lost)
{
    bool is_any = lost > 0;
    for (int k = 0; k < w->rigid.awakes; k++) {
        int b = w->rigid.awake[k];
        island *i = budget_of(w, b);
        bool is_wild = i->energy > WILD * i->most;
        if (!w->rigid.moves[b] || !(i->is_lost || is_wild)) continue;
        i->is_lost = is_any = true;
        bool is_thrown = is_wild && w->rigid.touches[b];
        lost += is_thrown;
        if (is_thrown && !w->rigid.now[b].is_driven) advance_stop(w, b);
        sleep_forget(&w->sleep, b);
    }
    if (is_any) forget_impulses(w);
    w->report.lost = int_max(w->report.lost, lost);
}

void guard_brake(world *w, int lost)
{
    sum_motion(w);
    report_lost(w, lost);
    for (int k = 0; k < w->rigid.awakes; k++) {
        int b = w->rigid.awake[k];
        const island *i = budget_of(w, b);
        if (i->energy > i->most) slow_down(w, b, i);
    }
}
//<

//> guard-soft
// A pin on a body that turns by radians in a substep feeds the rope that it
// holds, without end.  When a particle has gone so far that the spacing of its
// strand is less than the last digit of the way, nothing is left of the rope.
static bool is_strand_lost(const body *x, const particle *p)
{
    real spacing = x->shape->spacing;
    for (int i = 0; i < body_particles(x); i++) {
        vec3 delta = vec3_sub(p[i].position, p[i].previous);
        real digit = DBL_EPSILON * vec3_length(delta);
        if (!(digit < spacing)) return true;
    }
    return false;
}

void guard_soft(world *w)
{
    int lost = 0;
    for (int k = 0; k < w->rigid.awakes; k++) {
        int b = w->rigid.awake[k];
        const body *x = &w->body[b];
        particle *p = w->pool.at + x->first;
        if (!body_is_soft(x) || !body_moves(w, b) || !is_strand_lost(x, p))
            continue;
        for (int i = 0; i < body_particles(x); i++)
            p[i].position = p[i].previous;
        sleep_forget(&w->sleep, b);
        lost++;
    }
    w->report.lost = int_max(w->report.lost, lost);
}
//<

//> guard-planes
//>   A centre that would go behind a plane stops on it.
// Puts the centre of body b so high over a side, and stops it on its way down.
static void lift_to(world *w, int b, plane side, real high)
{
    vec3 *center = &w->rigid.now[b].frame.center, n = side.normal;
    motion *u = &w->rigid.velocity[b];
    real up = high - plane_height(side, *center);
    real down = real_min(vec3_dot(n, motion_straight(u)), 0);
    *center = vec3_add_scaled(*center, up, n);
    motion_add_straight(u, -down, n);
}

// Contacts are those of the frame's start, and what was hit hard may turn past
// them: but no centre goes behind a plane, or further behind than it was.
static void stop_at_plane(world *w, int b, plane p)
{
    real high = real_min(plane_height(p, w->rigid.began[b].center), 0);
    if (plane_height(p, w->rigid.now[b].frame.center) < high)
        lift_to(w, b, p, high);
}

//<

//> guard-faces
//>   Of a surface of many triangles a contact may know one, and the body be
//>   thrown at the next. So the way of each centre is asked for at last: what
//>   goes in through a face is put before it; what came through another by that,
//>   back to where the frame began.
static void stop_at_faces(world *w, int b)
{
    const world_host *host = &w->options.host;
    vec3 from = w->rigid.began[b].center, *center = &w->rigid.now[b].frame.center;
    plane side;
    for (int k = 0; k < 2
         && host->enters(host->surroundings, b, from, *center, &side); k++) {
        lift_to(w, b, side, real_min(plane_height(side, from),
                                     w->rigid.body[b].inner));
        if (k > 0) *center = from;
    }
}

// (The centre of several pieces may be in none of them: a ring falls over a pole.)
static void stop_chunk(void *data, int item)
{
    world *w = data;
    const rigid_tables *t = &w->rigid;
    int end = task_end(item, t->awakes);
    for (int i = task_first(item); i < end; i++) {
        int b = t->awake[i];
        bool may = t->moves[b] && !body_meets_none(&w->body[b]);
        for (int k = 0; k < w->planes && may; k++)
            stop_at_plane(w, b, w->plane[k]);
        if (w->options.host.enters && t->moves[b] && t->dynamic[b]
            && !w->body[b].rides) stop_at_faces(w, b);
    }
}

void guard_walls(world *w)
{
    tasks_run(w->options.host.run, stop_chunk, w, task_chunks(w->rigid.awakes));
}
//<

//> guard-through
//>   Seen from the larger body, the centre of the smaller one has gone along a
//>   line. If the line has entered through a face, the centre comes back over
//>   that face, and both bodies make way by their masses.
// A body that slides along another, and that turns meanwhile, may come to be
// behind the side that it slides along: its contact is that of the frame's
// start.  So the centre of the smaller one goes through no other body, as that
// one sees it: on the straight line from where it was to where it comes.
typedef struct {
    int  face;          // through which it goes in; -1: through none
    real in, out;       // shares of the line
    int  exit;          // the face through which it goes out; -1: it stays
} line_passage;

// Out of the body, whose centre is 0.  (In coordinates of a frame, too: what is
// on which side of a plane, and where a line meets it, is no question of
// lengths.)
static vec3 out_of_face(const vec3 *local, const int *v)
{
    vec3 n = vec3_cross(vec3_sub(local[v[1]], local[v[0]]),
                        vec3_sub(local[v[2]], local[v[0]]));
    return vec3_dot(n, local[v[0]]) < 0 ? vec3_scale(-1, n) : n;
}

// A line is in a convex body behind all of its faces.
static line_passage find_passage(const body *b, vec3 from, vec3 to)
{
    const vec3 *local = b->rigid->local;
    line_passage x = { -1, 0, 1, -1 };
    for (int f = 0; f < b->shape->mesh.faces; f++) {
        const int *v = &b->shape->face[3 * f];
        vec3 n = out_of_face(local, v);
        real start = vec3_dot(n, vec3_sub(from, local[v[0]]));
        real end = vec3_dot(n, vec3_sub(to, local[v[0]]));
        real fraction = start / (start - end);
        if (start > 0 && !(end < 0)) return (line_passage){ .face = -1 };
        if (start > 0 && fraction >= x.in) { x.face = f; x.in = fraction; }
        if (!(start > 0) && end > 0 && fraction < x.out) {
            x.exit = f;
            x.out = fraction;
        }
    }
    if (!(x.in < x.out)) x.face = -1;
    return x;
}

// A line that goes out beside where it came in has cut a corner.  In coordinates
// of a frame the normals of two sides of a prism of three stand at 120 degrees,
// however flat it is: what goes through it has cut none, whatever rounding says.
static bool cuts_corner(const body *b, const line_passage *x)
{
    const int *face = b->shape->face;
    if (x->exit < 0) return false;
    vec3 in = out_of_face(b->rigid->local, &face[3 * x->face]);
    vec3 out = out_of_face(b->rigid->local, &face[3 * x->exit]);
    real both = vec3_length(in) * vec3_length(out);
    return 2 * vec3_dot(in, out) > -(1 - 0x1p-20) * both;
}

// Where the smaller body comes, beside a face of the larger.
typedef struct {
    vec3 normal, arm;   // unit, out of it; of that place from its centre
    real need;          // m, to be as high over the face as it was, or as it is
                        // where it touches
} lost_side;

static lost_side side_of(const rigid_tables *t, int large, int face,
                         const rigid_frame *end, vec3 from, vec3 to, real high)
{
    const body *b = &t->body[large];
    vec3 at[3];
    for (int k = 0; k < 3; k++)
        at[k] = frame_point(end, b->rigid->local[b->shape->face[3 * face + k]]);
    vec3 n = vec3_unit(triangle_normal(at[0], at[1], at[2]));
    if (vec3_dot(n, vec3_sub(at[0], end->center)) < 0) n = vec3_scale(-1, n);
    real was = vec3_dot(n, vec3_sub(frame_point(end, from), at[0]));
    real is = vec3_dot(n, vec3_sub(to, at[0]));
    return (lost_side){ n, vec3_sub(to, end->center), real_min(was, high) - is };
}

// The spin (rad/s) of two bodies that turn as one about their common centre, the first
// at r (m) from the second, with this angular momentum.  A matrix takes a spin to its
// angular momentum, and is symmetric: its row k is what a spin of 1 about axis k has.
// motion_angular solves the three equations.
static vec3 spin_together(const motion_basis *a, const motion_basis *b, vec3 r,
                          vec3 angular)
{
    const vec3 axis[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, none = { 0, 0, 0 };
    real mass = 1 / (a->inverse_mass + b->inverse_mass);
    motion_basis both = { .inverse_mass = 0 };
    const motion has = { { 0, 0, 0, angular.x, angular.y, angular.z } };
    for (int k = 0; k < 3; k++) {
        motion u = motion_make(a, none, axis[k]), v = motion_make(b, none, axis[k]);
        vec3 delta = vec3_cross(r, vec3_cross(axis[k], r));
        vec3 own = vec3_add(motion_angular(a, &u), motion_angular(b, &v));
        both.turn[k] = vec3_add_scaled(own, mass, delta);
    }
    return motion_angular(&both, &has);
}

// Of an energy `part`, so much that no more than `most` is left: a share of speed.
static real slowed_to(real most, real part)
{
    return part > most ? sqrt(real_max(most, 0) / part) : 1;
}

// A body keeps a share of its own motion, and gets that of one that goes with `mean`
// and turns with `spin`, in which it is `out` times r away from the centre.
static void give_together(const motion_basis *of, motion *u, real out, real fraction,
                          vec3 mean, vec3 spin, vec3 r)
{
    vec3 delta = vec3_scale(1 - fraction, mean);
    motion more = motion_make(of, vec3_add_scaled(delta, out, vec3_cross(spin, r)),
                              spin);
    for (int i = 0; i < MOTIONS; i++) u->of[i] = fraction * u->of[i] + more.of[i];
}

// Two bodies that have been put elsewhere get back the angular momentum (N m s)
// that they lost by that: they turn as one body that has it all, and what they do
// beside that is slowed, for energy must not grow.  (The spin of one of them alone
// would take any energy for it, and a needle's the most.)
static void turn_together(rigid_tables *t, int small, int large, vec3 moment)
{
    const motion_basis *a = &t->now[small].basis, *b = &t->now[large].basis;
    motion *u = &t->velocity[small], *v = &t->velocity[large];
    vec3 r = vec3_sub(t->now[small].frame.center, t->now[large].frame.center);
    real sum = a->inverse_mass + b->inverse_mass;
    vec3 apart = vec3_sub(motion_straight(u), motion_straight(v));
    vec3 mean = vec3_add_scaled(motion_straight(v), b->inverse_mass / sum, apart);

    // Angular momenta about their common centre, and the spins of one body with them.
    vec3 before = vec3_add(motion_angular(a, u), motion_angular(b, v));
    before = vec3_add_scaled(before, 1 / sum, vec3_cross(r, apart));
    vec3 after = vec3_add(before, moment);
    vec3 spin_before = spin_together(a, b, r, before);
    vec3 spin_after = spin_together(a, b, r, after);

    // Energies: of what moves about that centre, of the new spin, and of the rest.
    real drift = vec3_length_squared(mean) * sum
               / (2 * a->inverse_mass * b->inverse_mass);
    real energy = motion_energy(a, u) + motion_energy(b, v) - drift;
    real turning = vec3_dot(spin_after, after) / 2;
    real rest = energy - vec3_dot(spin_before, before) / 2;
    real fraction = slowed_to(energy, turning);
    real beside = slowed_to(energy - turning, rest);

    vec3 spin = vec3_add_scaled(vec3_scale(fraction, spin_after), -beside, spin_before);
    give_together(a, u, a->inverse_mass / sum, beside, mean, spin, r);
    give_together(b, v, -b->inverse_mass / sum, beside, mean, spin, r);
}

// Both make way, by their masses; but a joint would be torn by that, so beside a body
// that is joined only the other one does, if it is not, and can.  A shift across the
// way that they go changes their angular momentum.
static void move_both(world *w, int small, int large, const lost_side *s)
{
    rigid_tables *t = &w->rigid;
    solver_body *a = &t->now[small], *b = &t->now[large];
    real x = a->basis.inverse_mass, y = b->basis.inverse_mass;
    bool holds_a = linkage_has(&w->joints, small);
    bool holds_b = linkage_has(&w->joints, large);
    if (holds_a && !holds_b && y > 0) x = 0;
    if (holds_b && !holds_a && x > 0) y = 0;
    a->frame.center = vec3_add_scaled(a->frame.center, s->need * x / (x + y),
                                      s->normal);
    b->frame.center = vec3_add_scaled(b->frame.center, -s->need * y / (x + y),
                                      s->normal);
    vec3 apart = vec3_sub(motion_straight(&t->velocity[small]),
                          motion_straight(&t->velocity[large]));
    vec3 moment = vec3_scale(s->need / (x + y), vec3_cross(apart, s->normal));
    if (x > 0 && y > 0) turn_together(t, small, large, moment);
}

// The impulse after which the smaller one's centre goes no further in.
static void stop_closing(rigid_tables *t, int small, int large,
                         const lost_side *s)
{
    const motion_basis *a = &t->now[small].basis, *b = &t->now[large].basis;
    motion *u = &t->velocity[small], *v = &t->velocity[large];
    vec3 center = { 0, 0, 0 };
    real k = motion_answer(a->inverse_mass + b->inverse_mass, b,
                           vec3_cross(s->arm, s->normal));
    real apart = vec3_dot(s->normal, vec3_sub(motion_at(a, u, center),
                                              motion_at(b, v, s->arm)));
    if (!(apart < 0)) return;
    motion_push(u, a, center, vec3_scale(-apart / k, s->normal));
    motion_push(v, b, s->arm, vec3_scale(apart / k, s->normal));
}

// Was one of them stopped?
static bool stop_passing(world *w, int small, int large)
{
    rigid_tables *t = &w->rigid;
    const rigid_frame *end = &t->now[large].frame;
    const rigid_frame *began = &t->began[large];
    vec3 to = t->now[small].frame.center;
    vec3 from = frame_local(began, vec3_sub(t->began[small].center,
                                            began->center));
    line_passage x = find_passage(&t->body[large], from,
                                  frame_local(end, vec3_sub(to, end->center)));
    if (x.face < 0 || cuts_corner(&t->body[large], &x)) return false;
    lost_side s = side_of(t, large, x.face, end, from, to,
                          t->body[small].inner);
    move_both(w, small, large, &s);
    stop_closing(t, small, large, &s);
    return true;
}

// Only where they may have gone as far as the ball inside the smaller one.  (Not what
// hangs together by joints, which would be torn.)
static bool may_pass(world *w, int a, int b, int small)
{
    const rigid_tables *t = &w->rigid;
    return t->reach[a] + t->reach[b] > t->body[small].inner
        && !w->body[a].rides && !w->body[b].rides
        && !linkage_unites(&w->joints, a, b);
}

// All pairs that are listed, whatever was thrown where; of a program that chooses
// contacts, those that it chose.
static bool stop_all(world *w)
{
    const rigid_tables *t = &w->rigid;
    bool some = false, chooses = w->options.host.meets;
    for (int k = 0; k < t->cache.pairs.count; k++) {
        const cache_pair *p = &t->cache.pairs.pair[k];
        int a = p->key[0], b = p->key[1];
        if (b < 0 || (chooses && !(p->is_active && p->count > 0))) continue;
        bool is_a = t->now[a].radius < t->now[b].radius;
        int small = is_a ? a : b, large = is_a ? b : a;
        some |= may_pass(w, a, b, small) && stop_passing(w, small, large);
    }
    return some;
}

// What one side has stopped may be behind the next, as in the corner of a room: so
// they take turns, and what is lifted over the ground may be beside its walls.
void guard_bodies(world *w)
{
    rigid_tables *t = &w->rigid;
    bool some = false;
    for (int k = 0; k < t->awakes; k++) {
        int b = t->awake[k];
        real gone = vec3_distance(t->now[b].frame.center, t->began[b].center);
        if (!t->moves[b]) continue;
        t->reach[b] = real_max(t->reach[b], gone);
        some |= 2 * t->reach[b] > t->body[b].inner;
    }
    if (some) join_unite(w);
    for (int k = 0; k < CONTACT_ROUNDS && some; k++) {
        guard_walls(w);
        some = stop_all(w);
    }
}
//<
