//> substeps-heavy
#include "substeps.h"
#include "soft_step.h"

#include <stddef.h>

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
    if (a->is_driven || b->is_driven) return 0;
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
//<

//> substeps-stack
//>   A stack is judged by the impulses of the last frame.
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
    for (int k = 0; k < w->rigid.awakes; k++) {
        int b = w->rigid.awake[k];
        vec3 way = w->rigid.ahead[b].way;
        real far = w->rigid.now[b].radius / 16;
        if (vec3_length_squared(way) > far * far) return false;
    }
    return true;
}
//<

//> substeps-joints
// A body that is pulled at a joint swings about it.  A substep follows a swing
// of angular frequency w if h w is at most 2 (Verlet); two joints and the next
// body make it four times as stiff as one joint alone.
static const real FOLLOWED = 0.6;

static int substeps_for_joints(const world *w)
{
    real need = w->options.dt * w->joints.pace / FOLLOWED;
    return (int)real_min(need, (real)MOST_TIMES * w->options.substeps);
}
//<

//> substeps-again
// What a program may ask for is all that a frame has.  A part of a divided one
// has its share.
static int all_of_part(const world *w)
{
    return int_max((int)(w->frame / w->options.dt * ALL_SUBSTEPS), 1);
}

// A chain that comes taut pulls a hundred times as hard as in the substep before.
// Where joints swung so much faster than it could follow, it is done again.
static const real TOO_FAST = 1.3;

int substeps_again(const world *w, real h, int left)
{
    real need = left * h * w->joints.swing / FOLLOWED;
    real shortest = w->options.dt / w->options.most_substeps;
    int most = int_min((int)(left * h / shortest),
                       all_of_part(w) - w->report.substeps);
    if (w->softs > 0 || left >= most || !(need > TOO_FAST * left)) return 0;
    return need < most ? (int)need + 1 : most;
}
//<

//> substeps-choose
//>   The largest demand counts. It is obeyed at once, and released after half a
//>   second.
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
int substeps_choose(world *w)
{
    int usual = w->options.substeps;
    int most = int_max(w->options.most_substeps, usual);
    real share = w->frame / w->options.dt;
    int n = usual;
    if (w->softs == 0 && w->joints.count == 0 && is_calm(w)) {
        real need = substeps_for_stack(w);
        if (need <= 0.75 * usual) n = (3 * usual + 3) / 4;
        if (need > 2 * usual) n = (int)need + 1;
    }
    n = int_max(n, substeps_for_joints(w));
    n = hold(&w->rigid.substeps, int_max(n, substeps_for_heavy(w)));
    if (share < 1) n = int_max(usual, (int)(share * n));
    if (w->softs > 0) n = int_max(n, soft_need(w));
    n = int_min(n, int_max((int)(share * most), usual));
    w->report.cut += n > all_of_part(w);
    return int_min(n, all_of_part(w));
}
//<
