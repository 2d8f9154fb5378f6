//> guard-most
#include "guard.h"
#include "drive.h"
#include "handle.h"

#include <stddef.h>
#include <string.h>

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
        if (w->rigid.moves[b] && !w->rigid.now[b].is_driven)
            add_motion(&s, motion_energy(basis, &w->rigid.velocity[b]),
                       basis->inverse_mass);
    }
    return s;
}

static void add_soft_motion(motion_sum *s, const world *w, const body *x)
{
    s->energy += soft_energy(x, w->pool.at);
    for (int i = x->first; i < x->first + body_particles(x); i++) {
        const particle *p = &w->pool.at[i];
        vec3 way = vec3_sub(p->position, p->previous);
        real square = vec3_length_squared(way) / (w->age * w->age);
        add_motion(s, square / (2 * p->inverse_mass), p->inverse_mass);
    }
}

// J: the kinetic energy that loads would give to bodies at rest.
static real load_energy(const world *w)
{
    real sum = 0;
    for (int b = 0; b < w->bodies && w->rigid.is_loaded; b++) {
        motion u = world_load(w, b, w->frame);
        sum += motion_energy(&w->rigid.now[b].basis, &u);
    }
    return sum;
}

// Contacts create no motion: beside what there is, and what bends and links
// have stored, only gravity does, what pushes from outside, the speed at which
// overlaps are pushed out, and what is driven: it gives others its own speed,
// and as much again if they bounce off it.  sqrt(2 energy / mass) is a length
// in the space of all velocities: these add up to no more than their sum.
real guard_most(const world *w, const solver_frame *f)
{
    motion_sum s = rigid_motion(w);
    for (int b = 0; b < w->bodies && w->softs > 0; b++)
        if (body_is_soft(&w->body[b]) && body_moves(w, b))
            add_soft_motion(&s, w, &w->body[b]);
    real more = w->frame * vec3_length(w->options.gravity) + f->max_speed
              + (1 + f->restitution) * drive_fastest(w);
    real most = sqrt(s.energy) + sqrt(load_energy(w))
              + sqrt(s.mass / 2) * more;
    return most * most;
}
//<

//> guard-brake
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

void guard_brake(world *w, real most)
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

//> guard-planes
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
    int end = task_end(item, w->bodies);
    for (int b = task_first(item); b < end; b++)
        for (int k = 0; k < w->planes && w->rigid.moves[b]; k++)
            stop_at_plane(w, b, w->plane[k]);
}

void guard_planes(world *w)
{
    tasks_run(w->options.host.run, stop_chunk, w, task_chunks(w->bodies));
}
//<
