// 02-explode.c - a rope of springs and the same rope of sticks, at four
// moments: the springs explode.  02-explode FILE.png
//
// 50 particles of 20 g, 2 cm apart, let go at 40 degrees from the vertical.
// The chain of springs swings at up to omega = 2 sqrt(k / m), and both ropes
// take the same steps.  Prints omega dt, the strains at those moments, and what
// becomes of the springs in shorter steps.

#include "constraint.h"
#include "painter.h"

#include <stdio.h>

enum { LINKS = 50, MOMENTS = 4, ROPES = 2,
       WIDTH = 420, HEIGHT = 470, GAP = 6, STEPS_A_SECOND = 1560,
       MORE_STEPS_A_SECOND = 1600 };

static const real REST = 0.02;          // m
static const real MASS = 0.02;          // kg
static const real STIFFNESS = 50000;    // N/m: 1 % longer under 10 N
static const vec3 GRAVITY = { 0, -9.81, 0 };

// When both ropes are looked at, in steps.
static const int moment[MOMENTS] = { 0, 56, 234, 468 };

typedef struct {
    particle at[LINKS + 1];
    stick    link[LINKS];
} rope;

static rope rope_start(real dt)
{
    const vec3 pin = { 0.32, 1.15, 0 }, along = { -0.6428, -0.7660, 0 };
    rope r;
    for (int i = 0; i <= LINKS; i++)
        r.at[i] = particle_start(vec3_add_scaled(pin, i * REST, along),
                                 vec3_make(0, 0, 0), GRAVITY,
                                 i > 0 ? 1 / MASS : 0, dt);
    for (int i = 0; i < LINKS; i++)
        r.link[i] = (stick){ i, i + 1, REST, 1, STICK_EXACT };
    return r;
}

static void step_springs(rope *r, real dt)
{
    vec3 force[LINKS + 1] = { { 0, 0, 0 } };
    for (int i = 0; i < LINKS; i++) {
        vec3 d = vec3_sub(r->at[i + 1].position, r->at[i].position);
        real pull = STIFFNESS * (vec3_length(d) - REST);
        force[i] = vec3_add_scaled(force[i], pull, vec3_unit(d));
        force[i + 1] = vec3_add_scaled(force[i + 1], -pull, vec3_unit(d));
    }
    verlet_step(r->at, LINKS + 1, GRAVITY, force, dt);
}

static void step_sticks(rope *r, real dt)
{
    verlet_step(r->at, LINKS + 1, GRAVITY, NULL, dt);
    sticks_iterate(r->link, LINKS, r->at, relax_options_pbd());
}

// The largest strain of a link.
static real worst(const rope *r)
{
    real most = 0;
    for (int i = 0; i < LINKS; i++)
        most = fmax(most, stick_strain(r->link[i], r->at));
    return most;
}

// The largest strain of the springs in a second of shorter steps.
static real worst_in_more_steps(void)
{
    const real dt = 1.0 / MORE_STEPS_A_SECOND;
    rope r = rope_start(dt);
    real most = 0;
    for (int k = 0; k < MORE_STEPS_A_SECOND; k++) {
        step_springs(&r, dt);
        most = fmax(most, worst(&r));
    }
    return most;
}

static status add_rope(painter *p, const rope *r, colour bead, colour link)
{
    status done = status_ok();
    for (int i = 0; i <= LINKS && done.ok; i++)
        done = painter_ball(p, r->at[i].position, i ? 0.0115 : 0.024,
                            i ? bead : colour_hex(0x4a525d));
    for (int i = 0; i < LINKS && done.ok; i++) {
        vec3 end[2] = { r->at[i].position, r->at[i + 1].position };
        done = painter_rope(p, end, 2, 0.006, link, link);
    }
    return done;
}

static status paint(const rope *r, int sticks, picture *out, int left, int top)
{
    painter p;
    painter_init(&p);
    painter_look(&p, vec3_make(0.35, 1.1, 4.2), vec3_make(0.02, 0.8, 0), 18);
    painter_floor(&p, vec3_make(0, 0, 0), 4, 0.25);
    p.lamps = 4;
    status done = sticks
        ? add_rope(&p, r, colour_hex(0x0072b2), colour_hex(0x56b4e9))
        : add_rope(&p, r, colour_hex(0xd55e00), colour_hex(0xe69f00));
    if (done.ok) done = painter_paint(&p, out, left, top, WIDTH, HEIGHT);
    painter_free(&p);
    return done;
}

static void label(picture *out, int left, int top, int sticks, int k)
{
    const colour ink = colour_hex(0x4a525d);
    char text[40];
    if (k == 0)
        picture_text(out, left + 18, top + 34, 18, ink,
                     sticks ? "sticks" : "springs");
    snprintf(text, sizeof text, "%d ms",
             (moment[k] * 1000 + STEPS_A_SECOND / 2) / STEPS_A_SECOND);
    picture_text(out, left + WIDTH - 18 - picture_text(NULL, 0, 0, 15, ink,
                 text), top + 34, 15, ink, text);
}

static status paint_strip(picture *out)
{
    const real dt = 1.0 / STEPS_A_SECOND;
    rope r[ROPES] = { rope_start(dt), rope_start(dt) };
    status done = status_ok();
    int steps = 0;
    for (int k = 0; k < MOMENTS && done.ok; k++) {
        for (; steps < moment[k]; steps++) {
            step_springs(&r[0], dt);
            step_sticks(&r[1], dt);
        }
        printf("# %3.0f ms: strain of the springs %.3g, of the sticks %.3g\n",
               steps * dt * 1000, worst(&r[0]), worst(&r[1]));
        for (int i = 0; i < ROPES && done.ok; i++) {
            int left = k * (WIDTH + GAP), top = i * (HEIGHT + GAP);
            done = paint(&r[i], i, out, left, top);
            label(out, left, top, i, k);
        }
    }
    return done;
}

int main(int arguments, char **argument)
{
    if (arguments != 2) {
        fprintf(stderr, "usage: 02-explode FILE.png\n");
        return 2;
    }
    const real omega = 2 * sqrt(STIFFNESS / MASS);
    printf("# %d steps a second: omega dt %.3f\n", (int)STEPS_A_SECOND,
           omega / STEPS_A_SECOND);
    printf("# %d: omega dt %.3f, strain of the springs in a second %.3g\n",
           (int)MORE_STEPS_A_SECOND, omega / MORE_STEPS_A_SECOND,
           worst_in_more_steps());
    picture out;
    status done = picture_init(&out, MOMENTS * (WIDTH + GAP) - GAP,
                               ROPES * (HEIGHT + GAP) - GAP,
                               colour_hex(0xffffff));
    if (done.ok) done = paint_strip(&out);
    if (done.ok) done = picture_write(&out, argument[1]);
    picture_free(&out);
    if (!done.ok) fprintf(stderr, "02-explode: %s\n", done.why);
    return done.ok ? 0 : 1;
}
