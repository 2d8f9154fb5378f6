// hard_particles.c - cases 1 to 10: particles alone, on sticks, in ropes.

#include "bodies.h"
#include "convex.h"
#include "hard.h"
#include "line.h"
#include "random.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#ifndef PENDULUM
#define PENDULUM "tests/data/pendulum_90.txt"
#endif
#ifndef CHAIN
#define CHAIN "tests/data/chain50.txt"
#endif

typedef long double wide;

static const real PI = 3.14159265358979323846;
static const real G = 9.81;                     // m/s^2
static const vec3 GRAVITY = { 0, -9.81, 0 };
static const vec3 ORIGIN = { 0, 0, 0 };

// Along the gradient at the old positions until nothing is left but rounding.
static relax_options to_rounding(void)
{
    relax_options o = relax_options_default();
    o.tolerance = 1e-15;
    return o;
}

static stick stick_of(int a, int b, real length)
{
    return (stick){ a, b, length, 1, STICK_EXACT };
}

// ---- 1: free flight --------------------------------------------------------

// m, the largest distance from the parabola within 10 s.  Off every axis, so
// that no coordinate is let off.
static real flight_error(real dt)
{
    const vec3 x = { 1, 2, 3 }, v = { 12, 16, -7 }, a = { 0.3, -9.81, 1.7 };
    particle p = particle_start(x, v, a, 1, dt);
    real worst = 0;
    int steps = (int)(10 / dt);
    for (int n = 1; n <= steps; n++) {
        verlet_step(&p, 1, a, NULL, dt);
        wide t = (wide)dt * n, half = t * t / 2;
        wide ex = (wide)p.position.x - (wide)x.x - (wide)v.x * t
                - (wide)a.x * half;
        wide ey = (wide)p.position.y - (wide)x.y - (wide)v.y * t
                - (wide)a.y * half;
        wide ez = (wide)p.position.z - (wide)x.z - (wide)v.z * t
                - (wide)a.z * half;
        worst = hard_worse(worst, (real)sqrtl(ex * ex + ey * ey + ez * ez));
    }
    return worst;
}

static void free_flight(hard_report *r, int fast)
{
    const int rate[] = { 60, 64, 73, 100, 120 };
    (void)fast;
    for (int k = 0; k < 5; k++)
        hard_add(r, flight_error(1.0 / rate[k]), 1e-9, "m",
                 "distance from the parabola; dt = 1/%d s", rate[k]);
    hard_note(r, "every step rounds the place to 6e-14 m at 490 m, and Verlet "
              "keeps that as a speed: at dt = 1/1000 s it makes %.1e m",
              flight_error(1e-3));
}

// ---- 2: an oscillator ------------------------------------------------------

// A particle on a spring with omega = 1/s; its coordinate along d.
typedef struct {
    particle p;
    real dt;
} oscillator;

static const vec3 SWING = { 1.0 / 3, 2.0 / 3, 2.0 / 3 };

static real oscillator_at(const oscillator *o)
{
    return vec3_dot(o->p.position, SWING);
}

static real oscillator_step(oscillator *o)
{
    vec3 force = vec3_scale(-1 / o->p.inverse_mass, o->p.position);
    verlet_step(&o->p, 1, ORIGIN, &force, o->dt);
    return oscillator_at(o);
}

static oscillator oscillator_start(real dt)
{
    vec3 x = vec3_scale(0.75, SWING);
    return (oscillator){ particle_start(x, vec3_scale(0.25, SWING),
                                        vec3_scale(-1, x), 0.5, dt), dt };
}

// x_n = A cos(phase), x_next = A cos(phase + turn): the phase of x_n.
static real phase_of(real x, real next, real turn)
{
    return atan2(x * cos(turn) - next, x * sin(turn));
}

// The period, as a relative error against (2 / dt) asin(dt / 2), and by how
// much the largest place exceeds the amplitude of the discrete sinusoid, which
// turns by `turn` a step.  Each half turn shows as one change of sign; what is
// left of the first and the last are phases of that sinusoid.
static void oscillate(real dt, int steps, real *period, real *beyond)
{
    oscillator o = oscillator_start(dt);
    real turn = 2 * asin(dt / 2), x = oscillator_at(&o);
    real next = oscillator_step(&o);
    real begin = phase_of(x, next, turn), largest = fabs(x);
    real slope = (x * cos(turn) - next) / sin(turn);
    real amplitude = sqrt(x * x + slope * slope);
    int halves = 0;
    for (int n = 0; n < steps; n++) {
        halves += (x < 0) != (next < 0);
        x = next;
        next = oscillator_step(&o);
        largest = hard_worse(largest, fabs(x));
    }
    real rest = phase_of(x, next, turn) - begin;
    real whole = floor((halves * PI - rest) / (2 * PI) + 0.5);
    *period = fabs(steps * turn / (2 * PI * whole + rest) - 1);
    *beyond = largest / amplitude - 1;
}

// Relative error of the growth in one step at omega dt > 2, against the root
// z + sqrt(z^2 - 1), z = (omega dt)^2 / 2 - 1, of its recurrence.
static real growth_error(real dt)
{
    oscillator o = oscillator_start(dt);
    real z = dt * dt / 2 - 1, want = log(z + sqrt(z * z - 1)), from = 0;
    for (int n = 0; n < 300; n++) {
        real x = oscillator_step(&o);
        if (n == 99) from = log(fabs(x));
        if (n == 299) return fabs((log(fabs(x)) - from) / (200 * want) - 1);
    }
    return HUGE_VAL;
}

static void an_oscillator(hard_report *r, int fast)
{
    const real dt[] = { 0.01, 0.1, 0.5, 1, 1.5, 1.9, 1.99 };
    real most = 0;
    for (int k = 0; k < 7; k++) {
        real period, beyond;
        oscillate(dt[k], fast ? 50000 : 500000, &period, &beyond);
        most = hard_worse(most, beyond);
        hard_add(r, period, 1e-10, "", "period at omega dt = %g", dt[k]);
    }
    hard_add(r, most, 1e-10, "", "beyond the amplitude; omega dt < 2");
    hard_add(r, growth_error(2.01), 1e-10, "", "growth at omega dt = 2.01");
}

// ---- 3: a spinning stick ---------------------------------------------------

// Masses 1 and 3 kg at the ends of a metre, which turns by `turn` a step in a
// plane across all axes; previous lies on the circle, so that the first step
// turns as much as the exact motion does.
static void stick_spin(particle p[2], real turn)
{
    vec3 u = { 0.6, 0, 0.8 }, v = { -0.64, 0.6, 0.48 };
    vec3 old = vec3_add_scaled(vec3_scale(cos(turn), u), -sin(turn), v);
    p[0] = (particle){ vec3_scale(0.75, u), vec3_scale(0.75, old), 1 };
    p[1] = (particle){ vec3_scale(-0.25, u), vec3_scale(-0.25, old), 1.0 / 3 };
}

// The angle between the stick of one step ago and the stick now.
static real turned(const particle p[2])
{
    vec3 u = vec3_sub(p[1].previous, p[0].previous);
    vec3 v = vec3_sub(p[1].position, p[0].position);
    return atan2(vec3_length(vec3_cross(u, v)), vec3_dot(u, v));
}

// One step of the spinning stick; returns the angle that it turned by.
static real spin_step(particle p[2], real dt, gradient_kind gradient)
{
    const stick s = stick_of(0, 1, 1);
    relax_options o = to_rounding();
    o.gradient = gradient;
    verlet_step(p, 2, ORIGIN, NULL, dt);
    sticks_relax(&s, 1, p, 50, o);
    return turned(p);
}

// Jakobsen's way brakes.  A stick that turned by t goes on straight, from
// (1, 0) to (2 - cos t, sin t), and is drawn back to its length: it turns by
// atan(sin t / (2 - cos t)) the next time.  For small t that is t - t^3, and
// w0 / sqrt(1 + 2 w0^2 dt time) is its law.
static void spin_braked(hard_report *r, real w0, real dt)
{
    particle p[2];
    real step = w0 * dt, rule = 0, law = 0, early = 0;
    stick_spin(p, step);
    for (int n = 1; n <= 600; n++) {
        real turn = spin_step(p, dt, GRADIENT_NEW);
        step = atan2(sin(step), 2 - cos(step));
        rule = hard_worse(rule, fabs(turn / step - 1));
        real off = fabs(turn / dt * sqrt(1 + 2 * w0 * w0 * dt * (n * dt)) / w0
                        - 1);
        if (n % 60 == 0) law = hard_worse(law, off);
        early = hard_worse(early, off);
    }
    hard_add(r, law, 0.01, "", "Jakobsen's way from its law; after 1 to 10 s");
    hard_add(r, rule, 1e-12, "", "the same from its exact rule; every step");
    hard_note(r, "the law is that of small steps: in the first 0.2 s, at half "
              "a radian a step, Jakobsen's way is off it by up to %.1e", early);
}

static void spinning_stick(hard_report *r, int fast)
{
    const real w0 = 30, dt = 1.0 / 60;
    particle p[2];
    real drift = 0;
    (void)fast;
    stick_spin(p, w0 * dt);
    for (int n = 1; n <= 600; n++) {
        real w = spin_step(p, dt, GRADIENT_OLD) / dt;
        drift = hard_worse(drift, fabs(w / w0 - 1));
    }
    hard_add(r, drift, 1e-12, "", "drift of angular speed");
    spin_braked(r, w0, dt);
}

// ---- 4 and 5: a pendulum ---------------------------------------------------

// In an upright plane across the axes, its nail off the origin.
typedef struct {
    particle p[2];
    stick s;
    real dt;
} pendulum;

static const vec3 NAIL = { 0.25, 1.5, -0.75 }, SIDE = { 0.6, 0, 0.8 };

static pendulum pendulum_start(real dt)
{
    pendulum q = { .s = stick_of(0, 1, 1), .dt = dt };
    q.p[0] = particle_start(NAIL, ORIGIN, ORIGIN, 0, dt);
    q.p[1] = particle_start(vec3_add(NAIL, SIDE), ORIGIN, GRAVITY, 1, dt);
    return q;
}

static void pendulum_step(pendulum *q)
{
    verlet_step(q->p, 2, GRAVITY, NULL, q->dt);
    sticks_relax(&q->s, 1, q->p, 50, to_rounding());
}

static real pendulum_angle(const pendulum *q)
{
    vec3 d = vec3_sub(q->p[1].position, NAIL);
    return atan2(vec3_dot(d, SIDE), -d.y);
}

// Reads the angle at time t from the reference; NaN if it is not there.
static real angle_known(real t)
{
    FILE *file = fopen(PENDULUM, "r");
    char line[400];
    real at, known, found = HUGE_VAL;
    while (file && fgets(line, sizeof line, file))
        if (sscanf(line, "%lf %lf", &at, &known) == 2 && fabs(at - t) < 1e-9)
            found = known;
    if (file) fclose(file);
    return found;
}

static void pendulum_order(hard_report *r, int fast)
{
    enum { RUNGS = 6 };
    real dt[RUNGS], error[RUNGS], truth = angle_known(2);
    (void)fast;
    for (int k = 0; k < RUNGS; k++) {
        int rate = 60 << k;
        dt[k] = 1.0 / rate;
        pendulum q = pendulum_start(dt[k]);
        for (int n = 0; n < 2 * rate; n++) pendulum_step(&q);
        error[k] = fabs(pendulum_angle(&q) - truth);
    }
    hard_add(r, fabs(hard_order(dt, error, RUNGS) - 2), 0.05, "",
             "order %.3f from 2; dt 1/60 to 1/%d s",
             hard_order(dt, error, RUNGS), 60 << (RUNGS - 1));
    hard_add(r, error[0], 3e-3, "rad", "angle after 2 s at 60 Hz");
}

// J/kg, of the moment between two steps: the speed that the step had, and the
// mean of both heights.
static real pendulum_energy(const pendulum *q)
{
    vec3 move = vec3_sub(q->p[1].position, q->p[1].previous);
    real height = (q->p[1].position.y + q->p[1].previous.y) / 2 - NAIL.y;
    return vec3_dot(move, move) / (2 * q->dt * q->dt) + G * height;
}

// Means over windows of one period: within a period the energy of a step sways
// with dt^2, and comes back.
static void pendulum_minute(hard_report *r, int fast)
{
    enum { WINDOW = 142, WINDOWS = 25 };        // 2.3667 s; 59.2 s
    pendulum q = pendulum_start(1.0 / 60);
    real first = 0, drift = 0, sway = 0;
    (void)fast;
    for (int w = 0; w < WINDOWS; w++) {
        real mean = 0;
        for (int n = 0; n < WINDOW; n++) {
            pendulum_step(&q);
            real energy = pendulum_energy(&q);
            mean += energy / WINDOW;
            sway = hard_worse(sway, fabs(energy));
        }
        if (w == 0) first = mean;
        drift = hard_worse(drift, fabs(mean - first));
    }
    hard_add(r, drift / G, 1e-3, "", "energy drift / (g L)");
    hard_note(r, "means over a period; within one the energy of a step sways "
              "by up to %.1e g L, and comes back", sway / G);
}

// ---- 6: a double pendulum --------------------------------------------------

static const real LONG = 1, SHORT = 0.7, UPPER = 1, LOWER = 2;  // m, kg

// The angles from the vertical and their speeds.
typedef struct { wide a, b, u, v; } angles;

// Their rates, from Lagrange's equations of two rods.
static angles rates(angles s)
{
    wide m = (wide)UPPER, n = (wide)LOWER, l = (wide)LONG, k = (wide)SHORT;
    wide g = (wide)G, d = s.a - s.b, c = cosl(d);
    wide bottom = 2 * m + n - n * cosl(2 * d);
    wide up = -g * (2 * m + n) * sinl(s.a) - n * g * sinl(s.a - 2 * s.b)
            - 2 * sinl(d) * n * (s.v * s.v * k + s.u * s.u * l * c);
    wide low = 2 * sinl(d) * (s.u * s.u * l * (m + n) + g * (m + n) * cosl(s.a)
                              + s.v * s.v * k * n * c);
    return (angles){ s.u, s.v, up / (l * bottom), low / (k * bottom) };
}

static angles moved(angles s, wide h, angles r)
{
    return (angles){ s.a + h * r.a, s.b + h * r.b, s.u + h * r.u,
                     s.v + h * r.v };
}

// Runge and Kutta's fourth order, in long double.
static angles reference(angles s, real seconds, int steps)
{
    wide h = (wide)seconds / steps;
    for (int n = 0; n < steps; n++) {
        angles k1 = rates(s), k2 = rates(moved(s, h / 2, k1));
        angles k3 = rates(moved(s, h / 2, k2)), k4 = rates(moved(s, h, k3));
        s = moved(s, h / 6, k1);
        s = moved(s, h / 3, k2);
        s = moved(s, h / 3, k3);
        s = moved(s, h / 6, k4);
    }
    return s;
}

static vec3 rod(real length, wide turn)
{
    return vec3_make(length * (real)sinl(turn), -length * (real)cosl(turn),
                     0);
}

// A rod at rest whose end's angle has this acceleration.
static vec3 rod_fall(real length, wide turn, wide rate)
{
    return vec3_scale(length * (real)rate,
                      vec3_make((real)cosl(turn), (real)sinl(turn), 0));
}

// m, the farther of both ends from the reference after 2 s.
static real double_error(angles s, angles truth, real dt, int steps)
{
    angles r = rates(s);
    vec3 x = rod(LONG, s.a), a = rod_fall(LONG, s.a, r.u);
    vec3 y = vec3_add(x, rod(SHORT, s.b));
    vec3 b = vec3_add(a, rod_fall(SHORT, s.b, r.v));
    particle p[3] = { particle_start(ORIGIN, ORIGIN, ORIGIN, 0, dt),
                      particle_start(x, ORIGIN, a, 1 / UPPER, dt),
                      particle_start(y, ORIGIN, b, 1 / LOWER, dt) };
    stick link[2] = { stick_of(0, 1, LONG), stick_of(1, 2, SHORT) };
    for (int n = 0; n < steps; n++) {
        verlet_step(p, 3, GRAVITY, NULL, dt);
        sticks_relax(link, 2, p, 200, to_rounding());
    }
    x = rod(LONG, truth.a);
    y = vec3_add(x, rod(SHORT, truth.b));
    return hard_worse(vec3_distance(p[1].position, x),
                      vec3_distance(p[2].position, y));
}

static void double_pendulum(hard_report *r, int fast)
{
    enum { RUNGS = 5 };
    const angles start = { (wide)PI / 2, (wide)PI / 6, 0, 0 };
    angles truth = reference(start, 2, fast ? 8000 : 40000);
    real dt[RUNGS], error[RUNGS];
    for (int k = 0; k < RUNGS; k++) {
        int rate = 240 << k;
        dt[k] = 1.0 / rate;
        error[k] = double_error(start, truth, dt[k], 2 * rate);
    }
    hard_add(r, fabs(hard_order(dt, error, RUNGS) - 2), 0.1, "",
             "order %.3f from 2; dt 1/240 to 1/%d s",
             hard_order(dt, error, RUNGS), 240 << (RUNGS - 1));
    hard_note(r, "the ends are off by %.1e m at 1/240 s, %.1e m at 1/%d s",
              error[0], error[RUNGS - 1], 240 << (RUNGS - 1));
}

// ---- 7, 8, 9: ropes --------------------------------------------------------

typedef struct {
    shape plan;
    line_scratch *scratch;
    particle *p;
    int n;
} rope;

static void rope_free(rope *r)
{
    line_scratch_free(r->scratch);
    free(r->p);
    shape_free(&r->plan);
}

// Particles of 1 kg, the first one nailed; -1 if memory is refused.
static int rope_make(rope *r, int links, real length)
{
    *r = (rope){ .n = links + 1 };
    if (!shape_rope(&r->plan, links, length, r->n).ok) return -1;
    r->scratch = line_scratch_new(&r->plan);
    r->p = calloc((size_t)r->n, sizeof *r->p);
    if (r->scratch && r->p) return 0;
    rope_free(r);
    return -1;
}

// Straight from the origin along `down`, at rest; held: nothing falls yet.
static void rope_lay(rope *r, vec3 down, vec3 acceleration, real dt)
{
    real link = shape_strands(&r->plan, 0).rest_length;
    for (int i = 0; i < r->n; i++)
        r->p[i] = particle_start(vec3_scale(i * link, down), ORIGIN,
                                 acceleration, i > 0, dt);
}

static void rope_step(rope *r, real dt, gradient_kind gradient, int newton)
{
    relax_options o = to_rounding();
    o.gradient = gradient;
    o.tolerance = 0;
    verlet_step(r->p, r->n, GRAVITY, NULL, dt);
    line_solve(shape_strands(&r->plan, 0), r->p, newton, o, r->scratch);
}

static real rope_strain(const rope *r)
{
    real worst = 0;
    for (int i = 0; i < r->plan.sticks; i++)
        worst = hard_worse(worst, stick_strain(r->plan.stick[i], r->p));
    return worst;
}

// J, between two steps, from the height of the nail.
static real rope_energy(const rope *r, real dt)
{
    real energy = 0;
    for (int i = 1; i < r->n; i++) {
        const particle *p = &r->p[i];
        vec3 move = vec3_sub(p->position, p->previous);
        real height = (p->position.y + p->previous.y) / 2;
        energy += (vec3_dot(move, move) / (2 * dt * dt) + G * height)
                / p->inverse_mass;
    }
    return energy;
}

// What a swing, or several, did at worst.
typedef struct {
    real strain, drift, sway;
} swing;

// 20 links of 5 cm, let go `lean` radians from the horizontal; 10 s.  Energy in
// parts of what there is to win: all of it hanging straight down.  Means over a
// second: where the end whips round, the energy of a step sways, and comes
// back.
static void swing_chain(real lean, int substeps, swing *w)
{
    enum { LINKS = 20 };
    const int steps = 60 * substeps;
    const real dt = 1.0 / steps, all = G * 0.5 * (LINKS + 1);
    rope q;
    if (rope_make(&q, LINKS, 1) != 0) {
        w->strain = HUGE_VAL;
        return;
    }
    rope_lay(&q, vec3_make(cos(lean), sin(lean), 0), GRAVITY, dt);
    for (int second = 0; second < 10; second++) {
        real mean = 0;
        for (int n = 0; n < steps; n++) {
            rope_step(&q, dt, GRADIENT_OLD, 2);
            w->strain = hard_worse(w->strain, rope_strain(&q));
            real energy = rope_energy(&q, dt) / all;
            w->sway = hard_worse(w->sway, fabs(energy));
            mean += energy / steps;
        }
        w->drift = hard_worse(w->drift, fabs(mean));
    }
    rope_free(&q);
}

// The end whips, and the motion is chaotic: one start proves little.
static swing swing_often(int starts, int substeps)
{
    swing w = { 0, 0, 0 };
    for (int k = 0; k < starts; k++) swing_chain(1e-6 * k, substeps, &w);
    return w;
}

static void swinging_chain(hard_report *r, int fast)
{
    int starts = fast ? 2 : 12;
    swing w = swing_often(starts, 30);
    hard_add(r, w.strain, 1e-5, "", "strain in any substep");
    hard_add(r, w.drift, 1e-3, "", "energy drift; mean of any second");
    hard_note(r, "30 substeps of 2 Newton steps, the worst of %d starts; in a "
              "substep the energy sways by up to %.1e", starts, w.sway);
    if (fast) return;
    w = swing_often(starts, 20);
    hard_note(r, "20 substeps are too few for every start: strain %.1e, drift "
              "%.1e", w.strain, w.drift);
}

// The largest strain within 10 s of a rope of 50 links with this load, let go
// `lean` radians off the vertical.
static real loaded_strain(real load, real lean, int substeps)
{
    const real dt = 1.0 / 60 / substeps;
    rope q;
    real worst = 0;
    if (rope_make(&q, 50, 1) != 0) return HUGE_VAL;
    rope_lay(&q, vec3_make(sin(lean), -cos(lean), 0), ORIGIN, dt);
    q.p[50].inverse_mass = 1 / load;
    for (int n = 0; n < 600 * substeps; n++) {
        rope_step(&q, dt, GRADIENT_OLD, 3);
        worst = hard_worse(worst, rope_strain(&q));
    }
    rope_free(&q);
    return worst;
}

// A load stretches the rope like a string: its highest note has
// omega = 2 sqrt(tension / (link mass * link length)), 4,400 rad/s for the
// heaviest, and Verlet wants omega dt < 2 of every note that is struck.
static void loaded_rope(hard_report *r, int fast)
{
    const real load[] = { 1, 100, 10000 };
    for (int k = 0; k < 3; k++)
        hard_add(r, loaded_strain(load[k], 0, 1), 1e-8, "",
                 "strain; %g link masses at the end", load[k]);
    for (int k = 0; k < 3 && !fast; k++)
        hard_add(r, loaded_strain(load[k], PI / 180, 64), 1e-8, "",
                 "swinging by 1 degree; %g; 64 substeps", load[k]);
    hard_note(r, "60 Hz, 3 Newton steps; hanging still it needs no substep");
    if (fast) return;
    real torn[3];
    for (int k = 0; k < 3; k++) torn[k] = loaded_strain(load[k], PI / 180, 1);
    hard_note(r, "swinging by 1 degree it does: without them it is torn, the "
              "strain is %.0f, %.0f and %.0f", torn[0], torn[1], torn[2]);
}

// The stored chain, node by node: 1 if all were read.
static int chain_known(vec3 at[51])
{
    FILE *file = fopen(CHAIN, "r");
    char line[200];
    int node, read = 0;
    real x, y;
    while (file && fgets(line, sizeof line, file))
        if (sscanf(line, "%d %lf %lf", &node, &x, &y) == 3 && node == read
            && read < 51)
            at[read++] = vec3_make(x, y, 0);
    if (file) fclose(file);
    return read == 51;
}

// 2 m between nails 1 m apart: begun as a V, slowed by 5 % a step, it comes to
// rest.  (At 60 Hz it would not: see the note of the loaded rope.)
static void hanging_chain(hard_report *r, int fast)
{
    const real dt = 1.0 / 240, deep = sqrt(0.75);
    vec3 known[51];
    rope q;
    real worst = 0;
    if (!chain_known(known) || rope_make(&q, 50, 2) != 0) {
        hard_add(r, HUGE_VAL, 1e-6, "", "no memory, or no %s", CHAIN);
        return;
    }
    for (int i = 0; i < 51; i++) {
        real s = i / 50.0;
        vec3 x = { s, -deep * (1 - fabs(2 * s - 1)), 0 };
        q.p[i] = (particle){ x, x, i > 0 && i < 50 };
    }
    for (int n = 0; n < (fast ? 3000 : 6000); n++) {
        rope_step(&q, dt, GRADIENT_OLD, 4);
        for (int i = 0; i < 51; i++) {
            vec3 move = vec3_sub(q.p[i].position, q.p[i].previous);
            q.p[i].previous = vec3_add_scaled(q.p[i].position, -0.95, move);
        }
    }
    for (int i = 0; i < 51; i++)
        worst = hard_worse(worst, vec3_distance(q.p[i].position, known[i]));
    hard_add(r, worst / 2, 1e-6, "", "distance from the chain / length");
    rope_free(&q);
}

// ---- 10: a free body -------------------------------------------------------

// Of a step: sum m dx and sum m x_n x x_next, and how much there is to turn
// about in them: sum m |dx| and sum m |x| |dx|.
typedef struct {
    wide linear[3], turn[3];
    real moving, turning;
} momenta;

static momenta momenta_of(const particle *p, int n)
{
    momenta all = { .moving = 0 };
    for (int i = 0; i < n; i++) {
        wide m = 1 / (wide)p[i].inverse_mass;
        wide a[3] = { (wide)p[i].previous.x, (wide)p[i].previous.y,
                      (wide)p[i].previous.z };
        wide b[3] = { (wide)p[i].position.x, (wide)p[i].position.y,
                      (wide)p[i].position.z };
        real size = vec3_distance(p[i].position, p[i].previous)
                  / p[i].inverse_mass;
        for (int c = 0; c < 3; c++) {
            int d = (c + 1) % 3, e = (c + 2) % 3;
            all.linear[c] += m * (b[c] - a[c]);
            all.turn[c] += m * (a[d] * b[e] - a[e] * b[d]);
        }
        all.moving += size;
        all.turning += size * vec3_length(p[i].position);
    }
    return all;
}

static real change(const wide a[3], const wide b[3], real of)
{
    wide x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
    return (real)sqrtl(x * x + y * y + z * z) / of;
}

// A box, an icosahedron, or a stretched one as a convex body from a mesh.
static status free_shape(shape *s, int kind, unsigned long long *seed)
{
    vec3 size = { 0.5 + random_fraction(seed), 0, 0 };
    size.y = 0.5 + random_fraction(seed);
    size.z = 0.5 + random_fraction(seed);
    if (kind == 0) return shape_box(s, size, 8);
    shape round;
    status made = shape_icosahedron(&round, 0.7, 12);
    if (!made.ok || kind == 1) {
        *s = round;
        return made;
    }
    int face[20][3];
    for (int i = 0; i < 60; i++) face[i / 3][i % 3] = round.face[i];
    for (int i = 0; i < 12; i++) {
        round.at[i].x *= size.x;
        round.at[i].y *= size.y;
        round.at[i].z *= size.z;
    }
    made = shape_convex(s, 12, round.at, 20, (const int (*)[3])face, 12);
    shape_free(&round);
    return made;
}

static void shuffle(stick *s, int n, unsigned long long *seed)
{
    for (int i = n - 1; i > 0; i--) {
        int k = (int)((i + 1) * random_fraction(seed));
        stick keep = s[i];
        s[i] = s[k];
        s[k] = keep;
    }
}

// What a flight, or several, did at worst.
typedef struct {
    real linear, turn, strain;
    int  failed;
} flight;

// Particles of 0.5 to 1.5 kg, their centre of mass at the origin, flying with v
// and spinning with w.
static void fly_start(const shape *s, particle *p, real spin, real speed,
                      unsigned long long *seed, real dt)
{
    vec3 w = vec3_scale(spin, random_direction(seed));
    vec3 v = vec3_scale(speed, random_direction(seed)), center = ORIGIN;
    real mass[12], total = 0;
    for (int i = 0; i < s->particles; i++) {
        mass[i] = 0.5 + random_fraction(seed);
        total += mass[i];
        center = vec3_add_scaled(center, mass[i], s->at[i]);
    }
    center = vec3_scale(1 / total, center);
    for (int i = 0; i < s->particles; i++) {
        vec3 x = vec3_sub(s->at[i], center), run = vec3_cross(w, x);
        p[i] = particle_start(x, vec3_add(v, run), vec3_cross(w, run),
                              1 / mass[i], dt);
    }
}

static void fly(const shape *s, real spin, real speed,
                unsigned long long *seed, flight *f)
{
    const real dt = 1.0 / 60;
    particle p[12];
    relax_options o = relax_options_default();
    fly_start(s, p, spin, speed, seed, dt);
    momenta first = momenta_of(p, s->particles);
    for (int n = 0; n < 600; n++) {
        verlet_step(p, s->particles, ORIGIN, NULL, dt);
        relax_result r = sticks_relax(s->stick, s->sticks, p, 100, o);
        f->failed += !(r.worst <= 1e-3);
        momenta now = momenta_of(p, s->particles);
        real lost = change(first.linear, now.linear, first.moving);
        real turned_off = change(first.turn, now.turn, first.turning);
        f->linear = hard_worse(f->linear, lost);
        f->turn = hard_worse(f->turn, turned_off);
        for (int k = 0; k < s->sticks; k++)
            f->strain = hard_worse(f->strain, stick_strain(s->stick[k], p));
    }
}

// So many bodies of a kind, each with its sticks in an order of its own.
static flight fly_many(int kind, int bodies, real spin, real speed,
                       unsigned long long *seed)
{
    flight f = { 0, 0, 0, 0 };
    for (int k = 0; k < bodies; k++) {
        shape s;
        if (!free_shape(&s, kind, seed).ok) {
            f.linear = HUGE_VAL;
            return f;
        }
        shuffle(s.stick, s.sticks, seed);
        fly(&s, spin * (0.1 + 0.9 * random_fraction(seed)), speed, seed, &f);
        shape_free(&s);
    }
    return f;
}

static void free_bodies(hard_report *r, int fast)
{
    static const char *const name[3] = { "boxes", "icosahedra", "convex" };
    unsigned long long seed = 10;
    int bodies = fast ? 6 : 60, failed = 0;
    real strain = 0;
    for (int kind = 0; kind < 3; kind++) {
        flight f = fly_many(kind, bodies, 10, 0.1, &seed);
        hard_add(r, f.linear, 1e-12, "", "change of momentum; %s", name[kind]);
        hard_add(r, f.turn, 1e-12, "", "of angular momentum; %s", name[kind]);
        failed += f.failed;
        strain = hard_worse(strain, f.strain);
    }
    hard_add(r, failed, 0, "", "times that the old gradient failed");
    flight far = fly_many(0, bodies, 10, 1, &seed);
    hard_note(r, "%d bodies of each kind, 1 to 10 rad/s, 0.1 m/s, sticks in "
              "any order, strain up to %.0e", bodies, strain);
    hard_note(r, "boxes at 1 m/s, which end 10 m away, where places are "
              "rounded coarser: %.1e and %.1e", far.linear, far.turn);
}

const hard_case hard_particles[] = {
    { 1, "free flight, 10 s", 1, free_flight },
    { 2, "oscillator", 1, an_oscillator },
    { 3, "spinning stick, 30 rad/s", 1, spinning_stick },
    { 4, "pendulum from 90 degrees", 1, pendulum_order },
    { 5, "pendulum, 60 s", 1, pendulum_minute },
    { 6, "double pendulum, 2 s", 1, double_pendulum },
    { 7, "chain from 90 degrees, 10 s", 1, swinging_chain },
    { 8, "hanging rope with a load", 1, loaded_rope },
    { 9, "rope between two points", 1, hanging_chain },
    { 10, "free body, random spin, 10 s", 1, free_bodies },
    { 0, NULL, 0, NULL }
};
