//> soft-move
//>   Move and draw: fall, bend, and what the diagonals take back.
#include "soft.h"
#include "table.h"
#include "taut.h"
#include "angular.h"

#include <assert.h>
#include <stddef.h>
#include <stdlib.h>

// Taylor about x, forward by dt and backward by dt_before:
//     x'         = x + v dt        + a dt^2 / 2
//     x_previous = x - v dt_before + a dt_before^2 / 2
// The second gives
//     v dt = ((x - x_previous) + a dt_before^2 / 2) dt / dt_before,
// and put into the first,
//     x' = x + (x - x_previous) dt / dt_before + a dt (dt_before + dt) / 2.
static void verlet_step_changed(particle *p, int n, vec3 a, real dt_before,
                                real dt)
{
    assert(n >= 0 && dt_before > 0 && dt > 0);
    real carry = dt / dt_before, square = dt * (dt_before + dt) / 2;
    for (int i = 0; i < n; i++) {
        vec3 here = p[i].position, move = { 0, 0, 0 };
        if (p[i].inverse_mass > 0) {
            vec3 last_move = vec3_sub(here, p[i].previous);
            move = vec3_add_scaled(vec3_scale(carry, last_move), square, a);
        }
        p[i].position = vec3_add(here, move);
        p[i].previous = here;
    }
}

// The first substep of a frame may be longer or shorter than the last one.
static void fall_particles(const soft_frame *f, const body *b)
{
    particle *p = f->particle + b->first;
    int n = body_particles(b);
    real left = 1 / (1 + f->h * b->damping);
    for (int i = 0; i < n && b->damping > 0; i++) {
        vec3 delta = vec3_sub(p[i].position, p[i].previous);
        p[i].previous = vec3_add_scaled(p[i].position, -left, delta);
    }
    if (f->age == f->h) verlet_step(p, n, f->gravity, NULL, f->h);
    else verlet_step_changed(p, n, f->gravity, f->age, f->h);
}

// A pull that lasts moves the further, the longer the substep is.
static void forget_holds(const soft_frame *f, const body *b)
{
    real longer = f->h / f->age, times = longer * longer;
    for (int i = b->first; i < b->first + body_particles(b); i++) {
        line_hold *h = &f->hold[i];
        if (h->state == LINE_FREE) h->pull = (vec3){ 0, 0, 0 };
        else h->pull = vec3_scale(times, h->pull);
        h->push[0] *= times;
        h->push[1] *= times;
        h->state = LINE_FREE;
    }
}

// A crease can shear a cell until the ends of one of its diagonals, of which
// only every second has a stick, meet, and the triangles around them cross.
// They are kept apart as any two particles are.
static void spread_cells(const soft_frame *f, int number)
{
    const body *b = &f->body[number];
    int columns = b->shape->columns, rows = b->shape->rows;
    real distance = 2 * b->thickness;
    real friction = soft_material(f, number, number).friction;
    for (int k = 0; k + 1 < rows; k++)
        for (int i = 0; i + 1 < columns; i++) {
            int a = b->first + k * columns + i, c = a + columns;
            touch_part(f, (particle_contact){ a, c + 1, distance }, friction);
            touch_part(f, (particle_contact){ a + 1, c, distance }, friction);
        }
}

// A cloth takes up to so many substeps more than the world's for itself.
enum { MORE_WHEN_PRESSED = 9 };             // tuned, substeps

// A stick that corrects a share of its error in each substep is a spring that
// is four times as stiff in half the substep.  Where something else asks for
// short ones, a sheet must not lock for that: it stays as stiff as in the
// shortest ones that it takes for itself.
static real stiffness_in(const soft_frame *f, real stiffness)
{
    real own = f->whole / (f->substeps + MORE_WHEN_PRESSED);
    real times = own / f->h;
    if (!(times > 1)) return stiffness;
    return stiffness / (stiffness + (1 - stiffness) * times * times);
}

// A corrected share of what each is off, along what it is now.  What that turns is
// owed, see owe_angular.
static void draw(const stick *s, int n, real stiffness, particle *p, vec3 *owed)
{
    for (int k = 0; k < n; k++) {
        particle *a = &p[s[k].a], *b = &p[s[k].b];
        vec3 along = vec3_sub(b->position, a->position);
        real length = vec3_length(along);
        real divisor = length * (a->inverse_mass + b->inverse_mass);
        if (!(divisor > 0)) continue;
        real pull = stiffness * (length - s[k].rest_length) / divisor;
        vec3 then = vec3_sub(b->previous, a->previous);
        *owed = vec3_add_scaled(*owed, pull, vec3_cross(then, along));
        a->position = vec3_add_scaled(a->position, pull * a->inverse_mass,
                                      along);
        b->position = vec3_add_scaled(b->position, -pull * b->inverse_mass,
                                      along);
    }
}

// The diagonals come before the contacts, and both before the strands: what
// comes last holds best.  All of them are alike.
static void draw_diagonals(soft_solver *s, const soft_frame *f, const body *b)
{
    const shape *plan = b->shape;
    int links = shape_links(plan), others = plan->sticks - links;
    if (others == 0) return;
    const stick *diagonal = plan->stick + links;
    real stiffness = stiffness_in(f, diagonal->stiffness);
    draw(diagonal, others, stiffness, f->particle + b->first,
         &s->owed[b - f->body]);
    spread_cells(f, (int)(b - f->body));
    s->tested += others;
    s->relaxed += others;
}

// kg m^2, twice the kinetic energy times h^2.
static real sum_of_moves(const soft_frame *f, const body *b)
{
    real sum = 0;
    for (int i = b->first; i < b->first + body_particles(b); i++) {
        const particle *p = &f->particle[i];
        real move2 = vec3_length_squared(vec3_sub(p->position, p->previous));
        if (p->inverse_mass > 0) sum += move2 / p->inverse_mass;
    }
    return sum;
}

// What nothing pins or touches gets no turn from its own links.
static bool is_alone(const soft_solver *s, const soft_frame *f, const body *b)
{
    bool is_any = s->held[b - f->body];
    for (int i = b->first; i < b->first + body_particles(b); i++)
        is_any |= f->hold[i].state >= LINE_TOUCHES;
    return !is_any;
}

static void bend_particles(soft_solver *s, const soft_frame *f, int number)
{
    const body *b = &f->body[number];
    particle *p = f->particle + b->first;
    int n = body_particles(b);
    bool is_free = b->bending > 0 && is_alone(s, f, b);
    angular was = { .sum = { 0, 0, 0 } };
    if (is_free) was = angular_measure(p, n);
    bend_relax(b->shape, b->bending, p, f->h, s->bends);
    if (is_free) angular_restore(was, p, n);
}

void soft_move(soft_solver *s, const soft_frame *f)
{
    for (int n = 0; n < f->softs; n++) {
        const body *x = &f->body[f->soft[n]];
        if (!soft_moves(f, f->soft[n])) continue;
        s->owed[f->soft[n]] = (vec3){ 0, 0, 0 };
        fall_particles(f, x);
        if (s->sunk[f->soft[n]] != SUNK_NOT)
            s->fallen[f->soft[n]] = sum_of_moves(f, x);
        bend_particles(s, f, f->soft[n]);
        forget_holds(f, x);
    }
}

void soft_draw(soft_solver *s, const soft_frame *f)
{
    for (int n = 0; n < f->softs; n++)
        if (soft_moves(f, f->soft[n]))
            draw_diagonals(s, f, &f->body[f->soft[n]]);
}
//<

//> soft-separate
//>   *Separate* and *Hold* call what stands above.
// What presses layers of cloth on each other drives them into each other by a
// length that grows with the square of the substep.  So a frame takes so many
// substeps that no pair of particles overlaps by more than this share of their
// distance: at a third they would pass between each other.
static const real DEEP = 0.12;              // tuned, diameters

void soft_separate(soft_solver *s, const soft_frame *f)
{
    near_refresh(&s->near, &s->view, f);
    s->is_backward = !s->is_backward;
    s->touching = touch_planes(f);
    real deepest = 0;
    s->touching += touch_pairs(&s->near, f, &deepest);
    s->pressed = real_max(s->pressed, sqrt(deepest / DEEP) / f->h);
    s->touching += touch_bodies(&s->near, &s->view, f, s->is_backward);
    s->touching += touch_facets(&s->near, &s->view, f, BY_PARTICLE, s->is_backward);
}

// Sticks pull a light facet back over the edge or the corner that it was parted from.
// What holds it there is all that the sticks hold together.
void soft_hold(soft_solver *s, const soft_frame *f)
{
    touch_facets(&s->near, &s->view, f, BY_WHOLE, s->is_backward);
}
//<

//> soft-relax
// Sticks of a cloth may be off by as much.
static const real CLOTH_TOLERANCE = 0.0025; // tuned, 1

// What lies on something that does not move has no more speed to or from it: what
// the strands have pulled it in must not throw it off.
static void drop_pull(particle *p, const line_hold *h)
{
    vec3 went = vec3_sub(p->position, p->previous);
    if (h->state == LINE_TOUCHES)
        went = vec3_scale(vec3_dot(went, h->normal), h->normal);
    if (h->state >= LINE_TOUCHES) p->previous = vec3_add(p->previous, went);
}

// Between pins a sheet may be taut, and threads that give by nothing would pull
// without a bound, and never rest.  Those of cloth give a little.
static real compliance_of(const body *b, bool is_held)
{
    return b->compliance > 0 || !is_held ? b->compliance : b->taut;
}

// Cloth is solved along its links as they lie now: what a row has done does not
// turn what a column did.
static relax_options relax_options_of(const soft_frame *f, const shape *s)
{
    relax_options o = f->relax;
    if (shape_directions(s) < 2) return o;
    o.gradient = GRADIENT_NEW;
    o.tolerance = real_max(o.tolerance, CLOTH_TOLERANCE);
    return o;
}

// Iterations end where no link is off by more than the tolerance.  Whether the last
// one is needed would change from substep to substep, and each change moves all
// that hangs.  So held cloth takes as many as it ever needed, and one fewer only
// when less than this share of the tolerance is left.  With nothing, a half and 0.8
// of it a loose curtain rests alike, with 15, 15 and 14 iterations.
static const real SPARED = 0.5;             // tuned, 1

static void remember_sweeps(int *sweeps, line_result l, real tolerance)
{
    bool is_spared = l.worst < SPARED * tolerance && l.steps > 1;
    *sweeps = l.steps - is_spared;
}

static void relax_soft(soft_solver *s, const soft_frame *f, const body *b,
                       line_hold *hold)
{
    const shape *plan = b->shape;
    particle *p = f->particle + b->first;
    int links = shape_links(plan);
    bool is_held = s->held[b - f->body];
    relax_options o = relax_options_of(f, plan);
    real give = compliance_of(b, is_held) / (f->h * f->h);
    int *fewest = &s->sweeps[b - f->body];
    if (!is_held || shape_directions(plan) < 2) *fewest = 0;
    bool is_free = is_alone(s, f, b);
    angular was = { .sum = { 0, 0, 0 } };
    if (is_free) was = angular_measure(p, plan->particles);
    if (hold) was.sum = vec3_add(was.sum, s->owed[b - f->body]);
    line_result l = lines_relax(plan, p, *fewest, f->iterations, o, hold, give,
                                b->line);
    if (is_free) angular_restore(was, p, plan->particles);
    if (hold) remember_sweeps(fewest, l, o.tolerance);
    s->tested += l.steps * links;
    s->relaxed += l.steps * links;
    s->fell_back += l.fell_back;
    bool is_strained = l.worst > STRAINED && l.worst < HUGE_VAL;
    if (is_strained || (shape_directions(plan) > 1 && is_held))
        s->pressed = HUGE_VAL;
}

void soft_relax(soft_solver *s, const soft_frame *f)
{
    for (int n = 0; n < f->softs; n++) {
        const body *b = &f->body[f->soft[n]];
        line_hold *hold = f->hold + b->first;
        if (!soft_moves(f, f->soft[n])) continue;
        relax_soft(s, f, b, hold);
        for (int i = 0; i < body_particles(b); i++)
            drop_pull(&f->particle[b->first + i], &hold[i]);
    }
}

// What is put out, and what that moves, goes no faster for it.  It is watched until
// a frame is over in which nothing is deep, and no substep would have made it faster
// by a hundredth of a spacing for each frame.
static void calm(sunk_state *sunk, const soft_frame *f, const body *b, real fallen)
{
    real now = sum_of_moves(f, b);
    real far = STRAINED * b->shape->spacing * f->h / f->frame;
    real left = now > fallen ? sqrt(fallen / now) : 1;
    if (now - fallen > b->mass * far * far) *sunk = SUNK;
    for (int i = b->first; i < b->first + body_particles(b); i++) {
        particle *p = &f->particle[i];
        vec3 went = vec3_sub(p->position, p->previous);
        p->previous = vec3_add_scaled(p->position, -left, went);
    }
}

void soft_calm(const soft_solver *s, const soft_frame *f)
{
    for (int n = 0; n < f->softs; n++) {
        int b = f->soft[n];
        if (!soft_moves(f, b)) continue;
        if (s->sunk[b] == SUNK_PERHAPS) s->sunk[b] = SUNK_NOT;
        if (s->sunk[b] != SUNK_NOT) calm(&s->sunk[b], f, &f->body[b], s->fallen[b]);
    }
}
//<

//> soft-energy
//>   The report gets the energy, and the number of bodies strained by 1 % that
//>   must not give.
real soft_energy(const body *b, const particle *all)
{
    const particle *p = all + b->first;
    return bend_energy(b->shape, b->bending, p)
         + links_energy(b->shape, b->compliance, p);
}
//<

//> soft-certify
//>   What was parted is drawn together again, and proved again.
// What parts facets asks no link, and may strain all that is around.  So the
// strands have another turn from there, and so has the proof, until none clashes
// or so often.  Of 360 small sheets with oblong cells 115 are strained by more
// than 1 % without, 24 with four turns, 4 with eight, and 2 with sixteen.
enum { TURNS_OF_PROOF = 8 };                // tuned, turns

static void draw_parted(soft_solver *s, const soft_frame *f, const body *b)
{
    const certificate *c = &s->proof;
    relax_soft(s, f, b, NULL);
    for (int v = b->first; v < b->first + body_particles(b); v++) {
        particle *p = &f->particle[v];
        certificate_carry(c, f, p, vec3_sub(p->position, c->at[0][v]));
    }
}

void soft_certify(soft_solver *s, const soft_frame *f)
{
    certificate *c = &s->proof;
    real since = c->since;
    certificate_end(c, f, &s->near, &s->view);
    int prevented = c->prevented;
    for (int k = 0; k < TURNS_OF_PROOF && c->prevented > 0; k++) {
        c->since = since;
        for (int n = 0; n < f->softs; n++) {
            const body *b = &f->body[f->soft[n]];
            if (soft_moves(f, f->soft[n])) draw_parted(s, f, b);
        }
        certificate_end(c, f, &s->near, &s->view);
    }
    c->prevented = prevented;
}
//<

//> soft-stretched
// Squares spare the root.  A NaN is no strain of at most so much.
static bool is_stretched(const shape *s, const particle *p)
{
    int links = shape_links(s);
    real least = (1 - STRAINED) * (1 - STRAINED);
    real most = (1 + STRAINED) * (1 + STRAINED);
    for (int k = 0; k < links; k++) {
        const stick *link = &s->stick[k];
        vec3 across = vec3_sub(p[link->b].position, p[link->a].position);
        real rest2 = link->rest_length * link->rest_length;
        real now = vec3_length_squared(across);
        if (!(now >= least * rest2 && now <= most * rest2)) return true;
    }
    return false;
}

int soft_unconverged(const soft_solver *s, const soft_frame *f)
{
    int count = 0;
    for (int n = 0; n < f->softs; n++) {
        const body *x = &f->body[f->soft[n]];
        sunk_state *sunk = &f->sunk[f->soft[n]];
        if (!soft_moves(f, f->soft[n])) continue;
        count += *sunk == SUNK
              || (!(x->compliance > 0)
                  && is_stretched(x->shape, f->particle + x->first))
              || certificate_is_cut(&s->proof, x);
        if (*sunk > SUNK_PERHAPS) *sunk = *sunk == SUNK ? SUNK_BEFORE : SUNK_NOT;
    }
    return count;
}
//<

//> soft-begin
//>   When a frame begins, a cloth's bounding sphere stands for it. What may
//>   touch that sphere is woken by the cloth, or wakes it, and falls asleep
//>   only together with it.
// Its particles' middle goes straight on; beside that each goes as far as the
// fastest, and as gravity adds.
static prediction predict_soft(const soft_frame *f, int b)
{
    const body *x = &f->body[b];
    const particle *p = f->particle + x->first;
    int n = x->shape->particles;
    real dt = f->frame, ages = dt / f->age, fastest = 0;
    vec3 mean = { 0, 0, 0 };
    if (!soft_moves(f, b)) return (prediction){ .reach = 0 };
    for (int i = 0; i < n; i++)
        mean = vec3_add_scaled(mean, 1.0 / n,
                               vec3_sub(p[i].position, p[i].previous));
    for (int i = 0; i < n; i++) {
        vec3 move = vec3_sub(p[i].position, p[i].previous);
        real beside = vec3_length_squared(vec3_sub(move, mean));
        fastest = real_max(beside, fastest);
    }
    prediction a = { .delta = vec3_scale(ages, mean) };
    a.turn = ages * sqrt(fastest) + vec3_length(f->gravity) * dt * dt / 2;
    a.reach = vec3_length(a.delta) + a.turn;
    return a;
}

// Every change of their number jolts a cloth: it rises at once, and falls when
// it has been too high for SOFT_PATIENCE frames.
enum { SOFT_PATIENCE = 3 };                 // tuned, frames

static void choose_pace(soft_solver *s)
{
    s->frames = s->pressed < s->pace ? s->frames + 1 : 0;
    if (s->pressed > s->pace || s->frames > SOFT_PATIENCE) s->pace = s->pressed;
    s->pressed = 0;
}

static bool is_pinned(const soft_frame *f, const body *b)
{
    const particle *p = f->particle + b->first;
    bool some = false;
    for (int i = 0; i < body_particles(b); i++)
        some |= !(p[i].inverse_mass > 0);
    return some;
}

void soft_begin(soft_solver *s, const soft_frame *f)
{
    choose_pace(s);
    s->touching = s->fell_back = 0;
    s->tested = s->relaxed = 0;
    for (int b = 0; b < f->bodies; b++) {
        bool is_soft = body_is_soft(&f->body[b]);
        s->ahead[b] = is_soft ? predict_soft(f, b) : f->ahead[b];
        s->held[b] |= is_soft && is_pinned(f, &f->body[b]);
    }
    near_begin(&s->near, f, s->ahead);
    certificate_begin(&s->proof, f, &s->near);
}

static bool balls_near(sphere a, sphere b, real margin)
{
    return vec3_distance(a.center, b.center) <= a.radius + b.radius + margin;
}

// Twice the margin of the lists is room for what a frame will bring.
bool soft_may_touch(const soft_solver *s, int a, int b)
{
    const near_lists *l = &s->near;
    return balls_near(l->ball[a], l->ball[b], 2 * l->margin);
}

bool soft_may_meet(const soft_solver *s, int b)
{
    return s->near.is_near[b];
}
//<

//> soft-substeps
//>   Where all iterations have left a link off by 1 %, or a cloth is pinned,
//>   nine more are taken at once. A frame that is divided for something fast
//>   (chapter 15) takes as many in its four parts together. The number rises at
//>   once, and falls after three frames.
// In a substep nothing should go further than its own radius: the inner one of a
// rigid body, half the spacing of a deformable one.  One whose numbers are lost asks
// for nothing.
static int substeps_for(const soft_frame *f, int b, real far)
{
    const body *x = &f->body[b];
    real radius = body_is_soft(x) ? x->shape->spacing / 2 : x->inner;
    real need = far / radius;
    if (!(need < HUGE_VAL)) return 0;
    if (!(need < f->most_substeps)) return f->most_substeps;
    return (int)need + ((int)need < need);
}

// What a deformable body may meet: itself, where its parts go different ways;
// and others.  What lies on its particles is as heavy beside them as the load of a
// rope.
static int substeps_to_meet(const soft_solver *s, const soft_frame *f, int a,
                            int b)
{
    const prediction *x = &s->ahead[a], *y = &s->ahead[b];
    const sphere *ball = s->near.ball;
    if (a == b) return substeps_for(f, a, x->turn);
    if (!balls_near(ball[a], ball[b], x->reach + y->reach)) return 0;
    if (!soft_meets(f, a, b)) return 0;
    int n = substeps_for(f, a, x->reach);
    if (body_is_soft(&f->body[b])) return n;
    if (!body_is_fixed(&f->body[b])) n = int_max(n, f->stiff_substeps);
    return int_max(n, substeps_for(f, b, y->reach));
}

// What weight alone does in a substep, g h^2, is no more than this share of a
// spacing: else the first contacts of a small cloth come too late.
static const real SAG = 0.02;               // tuned, spacings

// A taut link swings sideways with its ends, and longer substeps than a limit
// make it swing ever wider: chapter 12.  So the weight of all of a rope, which
// may hang on its lightest link, makes that no tauter than an explicit step bears.
static real lightest_of(const shape *s)
{
    real least = s->mass[0];
    for (int i = 1; i < s->particles; i++) least = real_min(least, s->mass[i]);
    return least;
}

static int substeps_for_weight(const soft_frame *f, int a)
{
    const body *x = &f->body[a];
    const shape *s = x->shape;
    real fraction = SAG;
    if (s->kind == SHAPE_ROPE)
        fraction = real_min(SAG, taut_most(1 / lightest_of(s), 1) / x->mass);
    real g = vec3_length(f->gravity);
    real need = f->frame * sqrt(g / (fraction * s->spacing));
    return need < f->most_substeps ? (int)need : f->most_substeps;
}

// A part of a divided frame takes its share, rounded up.
static int substeps_of_part(const soft_frame *f, int substeps)
{
    real fraction = f->frame / f->whole * substeps;
    return (int)fraction + ((int)fraction < fraction);
}

// Rope, and a sheet that pins may hold taut.
static bool is_stiff(const soft_solver *s, const soft_frame *f, int a)
{
    return f->body[a].shape->kind == SHAPE_ROPE || s->held[a];
}

// The strands of a deformable body count on all of the usual substeps, and on a
// few more where layers press on each other, where all sweeps have left a link
// off by 1 %, and where a cloth is pinned.  (Blows press, too, but small steps
// hardly make those softer.)
int soft_substeps(const soft_solver *s, const soft_frame *f)
{
    int n = 0;
    for (int k = 0; k < f->softs; k++) {
        int a = f->soft[k];
        int usual = is_stiff(s, f, a) ? f->stiff_substeps : f->substeps;
        int most = substeps_of_part(f, f->substeps + MORE_WHEN_PRESSED);
        int pressed = (int)real_min(f->frame * s->pace, most);
        if (soft_moves(f, a))
            n = int_max(n, int_max(int_max(usual, pressed),
                                   substeps_for_weight(f, a)));
        for (int b = 0; b < f->bodies; b++)
            n = int_max(n, substeps_to_meet(s, f, a, b));
    }
    return n;
}
//<

//> soft-init
//>   Memory grows when a body is added, so that no substep needs any.
static bool make_soft_room(soft_solver *s, const body *b, int bodies, int particles)
{
    int room = table_room(bodies, s->bodies);
    int particle_room = table_room(particles, s->particles);
    int rows = table_room(bend_rows(b->shape), s->rows);
    bool ok = true;
    if (room > s->bodies) TABLE_GROW(ok, s->ahead, s->bodies, room);
    if (ok && room > s->bodies) TABLE_GROW(ok, s->held, s->bodies, room);
    if (ok && room > s->bodies) TABLE_GROW(ok, s->sweeps, s->bodies, room);
    if (ok && room > s->bodies) TABLE_GROW(ok, s->sunk, s->bodies, room);
    if (ok && room > s->bodies) TABLE_GROW(ok, s->fallen, 0, room);
    if (ok && room > s->bodies) TABLE_GROW(ok, s->owed, 0, room);
    if (ok) s->bodies = room;
    if (particle_room > s->particles)
        TABLE_GROW(ok, s->hold, s->particles, particle_room);
    if (ok && particle_room > s->particles)
        ok = certificate_grow(&s->proof, s->particles, particle_room).ok;
    if (ok) s->particles = particle_room;
    if (rows > s->rows) TABLE_GROW(ok, s->bends, 0, rows);
    if (ok) s->rows = rows;
    return ok;
}

// The first deformable body: rigid ones are there that were not looked at.
static status view_all(soft_solver *s, const body *all, int bodies)
{
    status done = status_ok();
    for (int b = 0; b < bodies && done.ok; b++)
        if (!body_is_soft(&all[b])) done = rigid_view_add(&s->view, &all[b]);
    return done;
}

// Something was set down: what is deformable may be in it.
void soft_doubt(soft_solver *s)
{
    for (int n = 0; n < s->near.softs; n++) {
        sunk_state *sunk = &s->sunk[s->near.soft[n]];
        if (*sunk == SUNK_NOT) *sunk = SUNK_PERHAPS;
    }
}

status soft_add(soft_solver *s, const body *all, int b, int bodies,
                int particles)
{
    bool is_soft = body_is_soft(&all[b]);
    status done = status_ok();
    if (s->near.softs == 0 && !is_soft) return done;
    if (!make_soft_room(s, &all[b], bodies, particles))
        return status_out_of_memory();
    s->sweeps[b] = 0;
    s->sunk[b] = SUNK_NOT;
    for (int i = 0; i < body_particles(&all[b]); i++)
        s->hold[all[b].first + i] = (line_hold){ .state = LINE_FREE };
    if (s->near.softs == 0) done = view_all(s, all, bodies);
    else if (!is_soft)      done = rigid_view_add(&s->view, &all[b]);
    if (done.ok) done = near_add(&s->near, all, b, bodies, particles);
    soft_doubt(s);
    return done;
}

void soft_forget(soft_solver *s, int b)
{
    near_forget(&s->near, b);
    s->view.of = -1;
    soft_doubt(s);
}

void soft_remove(soft_solver *s, const body *all, int b)
{
    near_remove(&s->near, all, b);
    s->view.of = -1;
}

void soft_free(soft_solver *s)
{
    near_free(&s->near);
    certificate_free(&s->proof);
    rigid_view_free(&s->view);
    free(s->ahead);
    free(s->held);
    free(s->sweeps);
    free(s->sunk);
    free(s->fallen);
    free(s->owed);
    free(s->hold);
    free(s->bends);
    *s = (soft_solver){ .touching = 0 };
}
//<
