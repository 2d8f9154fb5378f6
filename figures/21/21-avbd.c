// 21-avbd.c - a stack of boxes by soft contacts in substeps, and by augmented
// vertex block descent (Giles, Diaz and Yuksel 2025): time against error, a
// heavy box on a light one, and the momentum that an impact leaves.
//
// Boxes of 1 m stand one on the other and can only rise and tilt.  Every box
// meets the box below it in two points, the corners of its lower face, and
// these stay where they are: finding contacts is not the question here, nor is
// friction.  The weight of the highest box lies off its middle.
// Units: metres, kilograms, seconds.

#include "clock.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { MOST = 20, FRAMES = 600, LAST = 60, GROUND = -1 };
static const real DT = 1.0 / 60, G = 9.81, PI = 3.14159265358979;

// How far a box has gone, or how fast it goes.
typedef struct {
    real rise, turn;        // m, radians; or the same a second
} motion;

typedef struct {
    real mass, inertia;     // kg, kg m^2
    real middle;            // m, where its centre of mass lies along the face
    motion x, v;            // x = 0: at rest, exactly touching
    motion old, aim;        // of descent: where it was, where it would go
    int  first, end;        // its contacts
} box;

typedef struct {
    int  upper, lower;      // boxes; lower may be the GROUND
    real at;                // m, along the face
    real mass;              // kg, the effective mass
    real impulse;           // kg m/s, of soft contacts
    real force, stiffness;  // kg m/s^2, kg/s^2: lambda and k of descent
    real excused;           // m, the overlap that need not go in this frame
} contact;

typedef struct {
    int  boxes, contacts;
    real gravity;           // m/s^2, downwards
    box  box[MOST];
    contact contact[2 * MOST];
} stack;

// A solver, and how often it iterates in a frame.
typedef enum { SOFT, DESCENT } method;
typedef struct {
    method how;
    int    count;           // substeps of SOFT, iterations of DESCENT
    real   ramp;            // 1/m, beta of DESCENT: by how much a stiffness
                            // grows, over m/dt^2, for each metre of error
} solver;

static real motion_at(const box *b, motion m, real at)
{
    return m.rise + (at - b->middle) * m.turn;
}

// The gap of the contact, or how fast it opens.
static real opening(const stack *s, const contact *c, bool speed)
{
    const box *u = &s->box[c->upper];
    real sum = motion_at(u, speed ? u->v : u->x, c->at);
    if (c->lower == GROUND) return sum;
    const box *l = &s->box[c->lower];
    return sum - motion_at(l, speed ? l->v : l->x, c->at);
}

// 1/kg, by how much an impulse of 1 upon the contact moves one of its boxes.
static real mobility(const stack *s, int b, real at)
{
    if (b == GROUND) return 0;
    const box *o = &s->box[b];
    real arm = at - o->middle;
    return 1 / o->mass + arm * arm / o->inertia;
}

// Two contacts below each box, in the order of the boxes: a box's own and those
// of the box above it lie side by side.
static void stack_join(stack *s)
{
    int n = 0, first = s->gravity > 0 ? 0 : 1;
    for (int b = first; b < s->boxes; b++)
        for (int side = -1; side <= 1; side += 2) {
            contact c = { .upper = b, .lower = b - 1, .at = 0.5 * side };
            c.mass = 1 / (mobility(s, b, c.at) + mobility(s, b - 1, c.at));
            s->contact[n++] = c;
        }
    s->contacts = n;
    for (int b = 0; b < s->boxes; b++) {
        int own = 2 * (b - first);
        s->box[b].first = own < 0 ? 0 : own;
        s->box[b].end = own + 4 < n ? own + 4 : n;
    }
}

// Boxes of 1 kg, but for the lowest one (kg), which stands on the ground if
// there is gravity.
static void stack_build(stack *s, int boxes, real lowest, real gravity)
{
    *s = (stack){ .boxes = boxes, .gravity = gravity };
    for (int b = 0; b < boxes; b++) {
        real mass = b == 0 ? lowest : 1;
        s->box[b] = (box){ .mass = mass, .inertia = mass / 6 };
    }
    s->box[boxes - 1].middle = 0.1;
    stack_join(s);
}

// --- soft contacts -----------------------------------------------------------

// Equal and opposite impulses: the sum of the momenta stays.
static void impulse_apply(stack *s, const contact *c, real p)
{
    for (int side = 0; side < 2; side++) {
        int i = side == 0 ? c->upper : c->lower;
        if (i == GROUND) continue;
        box *b = &s->box[i];
        real q = side == 0 ? p : -p;
        b->v.rise += q / b->mass;
        b->v.turn += q * (c->at - b->middle) / b->inertia;
    }
}

// A contact as a damped spring, solved implicitly: an eighth of its period is
// a substep, and its damping ratio is 10.  The relax pass leaves the spring
// out, so that correcting an overlap leaves no speed.
static void soft_pass(stack *s, real h, bool relax)
{
    real w = 2 * PI * 0.125 / h, a = 2 * 10 + h * w, b = h * w * a;
    for (int i = 0; i < s->contacts; i++) {
        contact *c = &s->contact[i];
        real gap = opening(s, c, false), bias = gap / h, scale = 1, leak = 0;
        if (gap <= 0) bias = 0;
        if (gap <= 0 && !relax) {
            scale = b / (1 + b);
            leak = 1 / (1 + b);
            bias = fmax(scale * w / a * gap, -3);
        }
        real p = (scale * opening(s, c, true) + bias) * c->mass;
        real sum = fmax(c->impulse - p - leak * c->impulse, 0);
        impulse_apply(s, c, sum - c->impulse);
        c->impulse = sum;
    }
}

static void soft_frame(stack *s, int substeps)
{
    real h = DT / substeps;
    for (int n = 0; n < substeps; n++) {
        for (int b = 0; b < s->boxes; b++) s->box[b].v.rise -= s->gravity * h;
        for (int i = 0; i < s->contacts; i++)
            impulse_apply(s, &s->contact[i], s->contact[i].impulse);
        soft_pass(s, h, false);
        for (int b = 0; b < s->boxes; b++) {
            s->box[b].x.rise += h * s->box[b].v.rise;
            s->box[b].x.turn += h * s->box[b].v.turn;
        }
        soft_pass(s, h, true);
    }
}

// --- augmented vertex block descent ------------------------------------------

static const real ALPHA = 0.95, GAMMA = 0.99;

// m, the error of the contact: its gap, less what is excused.
static real descent_error(const stack *s, const contact *c)
{
    return opening(s, c, false) + c->excused;
}

// One box goes where its inertia and its contacts are in balance, while all
// other boxes stand still: two equations, by Cramer's rule.  The stiffness of a
// contact that does not push counts too: without it the boxes overshoot, and
// the tower explodes with a beta of 1000.
static void descent_box(stack *s, int b)
{
    box *o = &s->box[b];
    real m = o->mass / (DT * DT), i = o->inertia / (DT * DT);
    real rr = m, rt = 0, tt = i;
    real force = m * (o->aim.rise - o->x.rise);
    real torque = i * (o->aim.turn - o->x.turn);
    for (int k = o->first; k < o->end; k++) {
        const contact *c = &s->contact[k];
        real arm = c->at - o->middle;
        real f = fmax(c->force - c->stiffness * descent_error(s, c), 0);
        if (c->lower == b) f = -f;
        force += f;
        torque += f * arm;
        rr += c->stiffness;
        rt += c->stiffness * arm;
        tt += c->stiffness * arm * arm;
    }
    real det = rr * tt - rt * rt;
    o->x.rise += (force * tt - torque * rt) / det;
    o->x.turn += (torque * rr - force * rt) / det;
}

// Where each box was, and where it would go alone.  It begins where its speed
// takes it, without gravity: at rest that is the answer.
static void descent_begin(stack *s)
{
    for (int i = 0; i < s->contacts; i++) {
        contact *c = &s->contact[i];
        c->excused = -ALPHA * fmin(opening(s, c, false), 0);
        c->force *= ALPHA * GAMMA;
        c->stiffness = fmax(GAMMA * c->stiffness, c->mass / (DT * DT));
    }
    for (int b = 0; b < s->boxes; b++) {
        box *o = &s->box[b];
        o->old = o->aim = o->x;
        o->aim.rise += DT * o->v.rise - s->gravity * DT * DT;
        o->aim.turn += DT * o->v.turn;
        o->x.rise += DT * o->v.rise;
        o->x.turn += DT * o->v.turn;
    }
}

static void descent_frame(stack *s, int iterations, real ramp)
{
    descent_begin(s);
    for (int n = 0; n < iterations; n++) {
        for (int b = 0; b < s->boxes; b++) descent_box(s, b);
        for (int i = 0; i < s->contacts; i++) {
            contact *c = &s->contact[i];
            real error = descent_error(s, c);
            c->force = fmax(c->force - c->stiffness * error, 0);
            if (c->force > 0)
                c->stiffness += ramp * c->mass / (DT * DT) * fabs(error);
        }
    }
    for (int b = 0; b < s->boxes; b++) {
        box *o = &s->box[b];
        o->v.rise = (o->x.rise - o->old.rise) / DT;
        o->v.turn = (o->x.turn - o->old.turn) / DT;
    }
}

// --- measures ----------------------------------------------------------------

static void frame(stack *s, solver by)
{
    if (by.how == SOFT) soft_frame(s, by.count);
    else descent_frame(s, by.count, by.ramp);
}

// m, the deepest overlap of a contact.
static real deepest(const stack *s)
{
    real most = 0;
    for (int i = 0; i < s->contacts; i++)
        most = fmax(most, -opening(s, &s->contact[i], false));
    return most;
}

typedef struct {
    real ever, end;         // m, the deepest overlap, and in the last second
    real speed;             // m/s, the fastest box in the last second
} outcome;

static outcome stand(stack *s, solver by)
{
    outcome o = { 0, 0, 0 };
    for (int n = 0; n < FRAMES; n++) {
        frame(s, by);
        o.ever = fmax(o.ever, deepest(s));
        if (n < FRAMES - LAST) continue;
        o.end = fmax(o.end, deepest(s));
        for (int b = 0; b < s->boxes; b++)
            o.speed = fmax(o.speed, fabs(s->box[b].v.rise));
    }
    return o;
}

// --- three questions ---------------------------------------------------------

// How each count does, and how long a frame takes once the stack stands.
enum { COUNTS = 7 };
typedef struct { stack s[COUNTS]; solver by[COUNTS]; } timing;

static void run_frame(int way, void *with)
{
    timing *t = with;
    frame(&t->s[way], t->by[way]);
}

static void print_tower(const char *name, method how, real ramp)
{
    static timing t;
    static lap took[CLOCK_WAYS];
    outcome o[COUNTS];
    for (int k = 0; k < COUNTS; k++) {
        t.by[k] = (solver){ how, 1 << k, ramp };
        stack_build(&t.s[k], MOST, 1, G);
        o[k] = stand(&t.s[k], t.by[k]);
    }
    clock_race((race){ COUNTS, 15, 2e-3, run_frame, &t }, took);
    printf("\n\n# %d boxes, %s, microseconds a frame, mm of overlap in the "
           "last second, mm at most, fastest box (m/s) in the last second\n",
           MOST, name);
    for (int k = 0; k < COUNTS; k++)
        printf("%d %.3g %.3g %.3g %.2g\n", t.by[k].count,
               1e6 * took[k].seconds, 1e3 * o[k].end, 1e3 * o[k].ever,
               o[k].speed);
}

// A box that is through the one below it has fallen.
static void print_heavy(void)
{
    static const solver by[] = { { SOFT, 8, 0 }, { SOFT, 32, 0 },
                                 { DESCENT, 10, 10 }, { DESCENT, 10, 1000 } };
    printf("\n\n# two boxes, the upper heavier by this ratio: mm of overlap "
           "in the last second (-: it fell) with soft contacts of 8 and of 32 "
           "substeps, and descent of 10 iterations with beta 10 and 1000\n");
    for (real ratio = 1; ratio < 2e4; ratio *= sqrt(10)) {
        printf("%.5g", ratio);
        for (int k = 0; k < 4; k++) {
            stack s;
            stack_build(&s, 2, 1 / ratio, G);
            outcome o = stand(&s, by[k]);
            printf(o.ever < 1 ? " %.3g" : " -", 1e3 * o.end);
        }
        printf("\n");
    }
}

// The first of ten boxes in free space runs into the second, which touches it.
static real momentum_lost(solver by)
{
    stack s;
    real sum = 0;
    stack_build(&s, 10, 1, 0);
    s.box[0].v.rise = 1;
    frame(&s, by);
    for (int b = 0; b < s.boxes; b++) sum += s.box[b].mass * s.box[b].v.rise;
    return 100 * fabs(1 - sum);
}

static void print_impact(void)
{
    printf("\n\n# a box runs into nine: substeps or iterations, %% of the "
           "momentum that is lost in that frame with soft contacts, and with "
           "descent and beta 10\n");
    for (int n = 1; n <= 128; n *= 2)
        printf("%d %.2g %.3g\n", n, momentum_lost((solver){ SOFT, n, 0 }),
               momentum_lost((solver){ DESCENT, n, 10 }));
}

int main(void)
{
    clock_print_head("stacks of boxes, ten seconds at 60 frames a second",
                     FLAGS);
    print_tower("soft contacts: substeps", SOFT, 0);
    print_tower("descent, beta 10: iterations", DESCENT, 10);
    print_tower("descent, beta 1000: iterations", DESCENT, 1000);
    print_heavy();
    print_impact();
    return 0;
}
