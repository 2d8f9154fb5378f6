//> drive
//>   A kinematic body goes its way by the clock, and what joints add to its
//>   motion is taken back.
#include "drive.h"

// A power of two, and its root, round nothing.  A motion basis has the root of
// the inverse mass in its turns: the same velocity is as many times more there.
static const real HEAVIER = 0x1p40, ROOT = 0x1p20;

static void set_velocity(world *w, int b)
{
    const body_drive *d = &w->rigid.drive[b];
    w->rigid.velocity[b] = motion_make(&w->rigid.now[b].basis, d->velocity,
                                       d->spin);
}

void drive_begin(world *w, int b)
{
    motion_basis *basis = &w->rigid.now[b].basis;
    basis->inverse_mass /= HEAVIER;
    for (int t = 0; t < TURNS; t++)
        basis->turn[t] = vec3_scale(1 / ROOT, basis->turn[t]);
    set_velocity(w, b);
}

void drive_hold(world *w)
{
    const rigid_tables *t = &w->rigid;
    for (int k = 0; k < t->awakes && w->kinematic_bodies > 0; k++)
        if (t->now[t->awake[k]].is_driven) set_velocity(w, t->awake[k]);
}

void drive_advance(world *w, int b, real seconds)
{
    solver_body *now = &w->rigid.now[b];
    const body_drive *d = &w->rigid.drive[b];
    const rigid_frame *began = &w->rigid.began[b];
    motion_basis basis = basis_find(w->body[b].rigid, began);
    motion delta = motion_make(&basis, vec3_scale(seconds, d->velocity),
                               vec3_scale(seconds, d->spin));
    now->frame = motion_frame(began, &basis, &delta);
    now->basis = basis_find(w->body[b].rigid, &now->frame);
    drive_begin(w, b);
}

void drive_back(world *w, int b)
{
    drive_advance(w, b, 0);
    w->rigid.middle[b] = w->rigid.now[b].frame;
}

real drive_fastest(const world *w)
{
    real most = 0;
    for (int k = 0; k < w->rigid.awakes && w->kinematic_bodies > 0; k++) {
        int b = w->rigid.awake[k];
        const solver_body *now = &w->rigid.now[b];
        if (w->rigid.moves[b] && now->is_driven)
            most = real_max(motion_fastest(&now->basis, &w->rigid.velocity[b],
                                           now->radius), most);
    }
    return most;
}
//<
