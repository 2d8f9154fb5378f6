//> substeps-contacts
#include "substeps.h"
#include "soft_step.h"

#include <stddef.h>

// A contact that bears a force F gives way by F / (m w^2), with m the effective
// mass of its two bodies and w the angular frequency of its spring, which is an
// eighth of a whole turn in a substep (solver-pass).  A frame takes so many
// substeps that this is at most CONTACT_GIVES, as a share of the smaller radius,
// or of four inner radii if that is less (cache_width).
static const real EIGHTH_TURN = 0.7853981633974483;

// For F / m beside that, 1/s^2.
static real substeps_for_load(const world *w, real pace)
{
    return w->options.dt * sqrt(pace / CONTACT_GIVES) / EIGHTH_TURN;
}

// In a pile that is calm, what lies lowest bears one body for each layer above it.
// So a tower has the substeps that it needs before it has begun to lean.
static real substeps_for_layers(const world *w, const island *i)
{
    if (!i->is_calm || i->hangs || i->bodies < 2) return 0;
    real layers = (i->high - i->low) * i->bodies / (2 * i->inner) - 1;
    real g = vec3_length(w->options.gravity);
    return substeps_for_load(w, g * layers * i->bodies / i->width);
}

// The weight of what lies on others counts before it is felt, shared by all that it
// lies on, and when all is calm also what contacts bear: by their root mean square,
// as if loads grew evenly from nothing to the largest, as they do in a tower.
// (Where bodies are jammed, some contact is always pressed by a hundred times what
// lies on it.)  This demand grows by one substep a frame, or a tower would be thrown
// up.
static real substeps_for_contacts(const world *w, const island *i, int now)
{
    real first = real_max(substeps_for_load(w, i->weight),
                          substeps_for_layers(w, i));
    if (!(i->squares < HUGE_VAL && i->bears > 0 && i->is_calm)) return first;
    real pace = sqrt(3 * i->squares / i->bears);
    return real_max(first, real_min(substeps_for_load(w, pace), now));
}
//<

//> substeps-joints
// A body that is pulled at a joint swings about it.  A substep follows a swing
// of angular frequency w if h w is at most 2 (Verlet); two joints and the next
// body make it four times as stiff as one joint alone.
static const real FOLLOWED = 0.6;           // tuned, rad
//<

//> substeps-turns
// What may touch others, and turns further in a substep than in one move, comes
// past them between two looks.  (Cloth and rope look in every substep.)
static int substeps_for_turns(const island *i, int most)
{
    if (i->is_soft) return 1;
    return (int)real_min(i->turn / MOTION_FURTHEST, most - 1) + 1;
}
//<

//> substeps-again
// What a program may ask for is all that a frame has.  A part of a divided one
// has its share.
int substeps_all(const world *w)
{
    return int_max((int)(w->frame / w->options.dt * ALL_SUBSTEPS), 1);
}

// A chain that comes taut pulls a hundred times as hard as in the substep before.
// Where joints swung so much faster than it could follow, it is done again.
static const real TOO_FAST = 1.3;           // tuned, 1

int substeps_again(const world *w, real h, int left)
{
    real need = left * h * w->joints.swing / FOLLOWED;
    real shortest = w->options.dt / w->options.most_substeps;
    int most = int_min((int)(left * h / shortest),
                       substeps_all(w) - w->report.substeps);
    const rung *r = &w->rigid.rungs[(int)w->rigid.on_rung];
    if (!r->hangs || r->is_soft || left >= most || !(need > TOO_FAST * left)) return 0;
    return need < most ? (int)need + 1 : most;
}
//<

//> substeps-choose
//>   The largest demand counts. It is obeyed at once. What rests releases it after
//>   half a second, what moves and is not fast at once.
// Every change of the number moves what rests, for in shorter substeps it sags
// less.  So it rises at once, and falls only when it has been too high by a third
// for as long as a body must be still before it sleeps.  Bodies that move give it
// back at once: their impacts ask for thirty substeps, and are over.  Not so what
// flies by its own size in a frame, and is not joined: its next impact may be as
// hard as the last.
static const real FEWER = 0.75;             // tuned, 1

// What is fast and not joined takes in each part of a divided frame as many as are
// usual in a frame; so does cloth.  Joints ask by how they swing and turn, and what
// they swing too fast for is done again.
static bool takes_all(const island *i)
{
    return i->is_soft || (i->is_fast && !i->hangs);
}

static int hold(const world_options *o, substep_choice *c, const island *i,
                int need)
{
    real patience = i->is_calm || takes_all(i) ? o->time_to_sleep : 0;
    c->frames = need < FEWER * c->now ? c->frames + 1 : 0;
    if (need > c->now || (c->frames - 0.5) * o->dt > patience) c->now = need;
    return c->now;
}

// A part of a divided frame takes its share of the substeps.
int substeps_choose(world *w, const island *i, substep_choice *c)
{
    real fraction = w->frame / w->options.dt;
    int usual = takes_all(i) ? world_usual(w, false) : w->options.substeps;
    int fewest = usual;
    int most = int_max(w->options.most_substeps, usual);
    real stiff = real_min(substeps_for_contacts(w, i, c->now), most);
    real swing = real_min(w->options.dt * i->pace / FOLLOWED, most);
    int need = int_max(usual, (int)real_max(stiff, swing) + 1);
    int n = hold(&w->options, c, i, need);
    if (!takes_all(i)) fewest = (int)(fraction * (usual - 1)) + 1;
    if (fraction < 1) n = int_max(fewest, (int)(fraction * (n - 1)) + 1);
    n = int_max(n, substeps_for_turns(i, most));
    if (i->is_soft) n = int_max(n, soft_need(w));
    return int_min(n, int_max((int)(fraction * most), fewest));
}

//<
