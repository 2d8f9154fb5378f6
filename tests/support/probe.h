// probe.h - what tests may see of a world that programs do not.
//
// Everything else is asked through tumble.h, world.h, or the module under test.
// When the inside of a world changes, this file follows, and no test does;
// tests/script/check_probe.sh holds all other tests to that.

#ifndef TUMBLE_PROBE_H
#define TUMBLE_PROBE_H

#include "drive.h"
#include "forget.h"
#include "world.h"

// --- Sleep -------------------------------------------------------------------

static inline bool probe_sleeps(const world *w, int b)
{
    return w->sleep.asleep[b];
}

// So many bodies does a step go over.
static inline int probe_awake(const world *w)
{
    return w->rigid.awakes;
}

// Marks body b as asleep, and nothing else.
static inline void probe_lay(world *w, int b)
{
    w->sleep.sleepers += !w->sleep.asleep[b];
    w->sleep.asleep[b] = true;
    w->sleep.island[b] = b;
}

// Bodies that fell asleep together have the same island.
static inline int probe_island(const world *w, int b)
{
    return w->sleep.island[b];
}

// The island of a body that is awake, as the last join left it.
static inline int probe_joined(const world *w, int b)
{
    while (w->sleep.parent[b] != b) b = w->sleep.parent[b];
    return b;
}

static inline void probe_stir(world *w, int b)
{
    w->sleep.watch[b].is_moving = true;
}

static inline void probe_begin_sleep(world *w)
{
    sleep_begin(&w->sleep);
}

static inline void probe_forget_sleep(world *w, int b)
{
    sleep_forget(&w->sleep, b);
}

// --- Rigid bodies within a frame ---------------------------------------------

// What the island of a body may have of energy, and has.
static inline island *probe_budget(world *w, int b)
{
    return &w->rigid.island[w->rigid.island[b].parent];
}

// In motion coordinates, see motion.h: m/s, and m since it got its frame.
static inline motion *probe_velocity(world *w, int b)
{
    return &w->rigid.velocity[b];
}

static inline motion *probe_move(world *w, int b)
{
    return &w->rigid.moved[b];
}

// Where body b stood when it got its frame, and with which basis.
static inline const solver_body *probe_start(const world *w, int b)
{
    return &w->rigid.now[b];
}

// Where it stands now.
static inline rigid_frame probe_frame(const world *w, int b)
{
    const solver_body *s = probe_start(w, b);
    return motion_frame(&s->frame, &s->basis, &w->rigid.moved[b]);
}

// The ball around it, as the frame began.
static inline sphere *probe_ball(world *w, int b)
{
    return &w->rigid.ball[b];
}

static inline bool probe_is_dynamic(const world *w, int b)
{
    return w->rigid.dynamic[b];
}

// Can it be asked where it touches?
static inline bool probe_is_rigid(const world *w, int b)
{
    return w->body[b].rigid;
}

// m, how far its ball may move in this frame.
static inline real *probe_reach(world *w, int b)
{
    return &w->rigid.ahead[b].reach;
}

// As if the last substep had been of h (s).
static inline void probe_set_age(world *w, real h)
{
    w->age = h;
    for (int b = 0; b < w->bodies; b++) w->rigid.age[b] = h;
}

// See ledger_halfway: of all bodies.
static inline void probe_set_halfway(world *w, real seconds)
{
    for (int b = 0; b < w->bodies; b++) w->rigid.halfway[b] = seconds;
}

// As a frame begins: bodies that move stand where their particles are, with the
// velocity that these have.
static inline void probe_look(world *w)
{
    for (int b = 0; b < w->bodies; b++) {
        const body *x = &w->body[b];
        const particle *p = w->pool.at + x->first;
        solver_body *now = &w->rigid.now[b];
        if (body_is_soft(x) || body_is_static(x)) continue;
        now->frame = rigid4_frame(p);
        now->basis = basis_find(x->rigid, &now->frame);
        w->rigid.velocity[b] = motion_of(p, &now->frame, &now->basis, body_age(w, b));
        w->rigid.moved[b] = (motion){ { 0 } };
        w->rigid.ball[b].center = now->frame.center;
    }
}

// And what is driven has its velocity: the substeps may begin.
static inline void probe_begin_substeps(world *w)
{
    probe_look(w);
    for (int b = 0; b < w->bodies; b++) {
        const body *x = &w->body[b];
        w->rigid.moves[b] = !body_is_soft(x) && !body_is_static(x);
        w->rigid.now[b].is_driven = x->is_kinematic;
        if (x->is_kinematic) drive_begin(w, b);
        w->rigid.awake[b] = b;
    }
    w->rigid.awakes = w->bodies;
}

// --- Contacts of rigid bodies -------------------------------------------------

// Pairs, and bodies and planes, that touch.
static inline int probe_contacts(const world *w)
{
    return w->rigid.cache.actives;
}

// In how many points body b touches anything.
static inline int probe_points(const world *w, int b)
{
    int points = 0;
    for (int k = 0; k < w->rigid.cache.actives; k++) {
        const contact *c = w->rigid.cache.active[k];
        if (c->a == b || c->b == b) points += c->count;
    }
    return points;
}

// All contacts are found again in the next frame, and start without impulses.
static inline void probe_forget_contacts(world *w)
{
    cache_clear(&w->rigid.cache);
}

// Entries that the table of contacts has room for, and vertices that are kept.
static inline int probe_contact_room(const world *w)
{
    return w->rigid.cache.entry_capacity;
}

static inline int probe_vertices(const world *w)
{
    return w->rigid.cache.vertices;
}

// Does each lane of the solver name a body below `bodies`, or the spare one?
static inline bool probe_solver_names(const world *w, int bodies)
{
    const contact_solver *s = &w->rigid.solver;
    if (s->blocks == 0 || w->rigid.motions != s->room + 1) return false;
    for (int k = 0; k < s->blocks; k++)
        for (int l = 0; l < REAL4; l++) {
            const int a = s->block[k].a[l], b = s->block[k].b[l];
            if (s->block[k].contact[l] < 0 && a != s->room) return false;
            if (b >= bodies && b != s->room) return false;
        }
    return true;
}

// --- Joints --------------------------------------------------------------------

static inline int probe_joints(const world *w)
{
    return w->joints.count;
}

static inline joint *probe_joint(world *w, int k)
{
    return &w->joints.joint[k];
}

// Ties of cloth and rope to bodies.
static inline int probe_ties(const world *w)
{
    return w->joints.ties;
}

// The joints are solved by the plain form, the oracle of the fast one.
static inline void probe_solve_plainly(world *w)
{
    w->joints.is_plain = true;
}

// --- Cloth and rope --------------------------------------------------------------

// The lists of what is near, see near.h.
static inline near_lists *probe_lists(world *w)
{
    return &w->soft.near;
}

// Contacts that pushed in the last substep.
static inline int probe_touching(const world *w)
{
    return w->soft.touching;
}

// 1/s, substeps that layers ask for.
static inline void probe_press(world *w, real pace)
{
    w->soft.pressed = pace;
}

// Ropes and cloths that a report tells of.
static inline int probe_unconverged(world *w, const soft_frame *f)
{
    return soft_unconverged(&w->soft, f);
}

// The phases of a substep, one by one.
static inline void probe_refresh(world *w, const soft_frame *f)
{
    near_refresh(&w->soft.near, &w->soft.view, f);
}

static inline void probe_begin_lists(world *w, const soft_frame *f)
{
    near_begin(&w->soft.near, f, w->rigid.ahead);
}

static inline void probe_begin_soft(world *w, const soft_frame *f)
{
    soft_begin(&w->soft, f);
}

static inline void probe_separate(world *w, const soft_frame *f)
{
    soft_separate(&w->soft, f);
}

static inline void probe_hold(world *w, const soft_frame *f)
{
    soft_hold(&w->soft, f);
}

static inline void probe_draw(world *w, const soft_frame *f)
{
    soft_draw(&w->soft, f);
}

#endif
