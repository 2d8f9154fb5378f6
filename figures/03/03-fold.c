// 03-fold.c - a cube of 12 sticks folds up; one of 18 + 4 stands.  Both fall
// on the floor, seen at three moments.  03-fold FILE.png
//
// Prints, for those moments, the largest strain of a stick and the height of
// the highest corner.

#include "body.h"
#include "painter.h"

#include <stdio.h>

enum { CORNERS = 8, MOST = 22, MOMENTS = 3, CUBES = 2, ITERATIONS = 32,
       WIDTH = 560, HEIGHT = 440, GAP = 6, STEPS_A_SECOND = 240 };

static const real DT = 1.0 / STEPS_A_SECOND;
static const vec3 GRAVITY = { 0, -9.81, 0 };
static const real BALL = 0.07, EDGE = 0.03, DIAGONAL = 0.016;   // m

// When both cubes are looked at, in steps.
static const int moment[MOMENTS] = { 0, 130, 480 };

typedef struct {
    int      sticks;
    particle at[CORNERS];
    stick    stick[MOST];
} cube;

// How many coordinates the ends of a stick differ in: 1 an edge, 2 a diagonal
// of a side, 3 a main diagonal.
static int class_of(int a, int b)
{
    int d = a ^ b;
    return (d & 1) + (d >> 1 & 1) + (d >> 2);
}

// One of the two diagonals of each side: the one whose ends have an even sum.
static int is_wanted(int a, int b)
{
    return class_of(a, b) != 2 || ((a & 1) + (a >> 1 & 1) + (a >> 2)) % 2 == 0;
}

static cube cube_start(int classes)
{
    const vec3 up = vec3_unit(vec3_make(0.30, 1, 0.42));
    const vec3 right = vec3_unit(vec3_cross(up, vec3_make(-0.3, 0, 1)));
    const vec3 front = vec3_cross(right, up);
    vec3 rest[CORNERS];
    cube c = { .sticks = 0 };
    real low = 0;
    for (int k = 0; k < CORNERS; k++) {
        vec3 x = vec3_scale((k & 1) - 0.5, right);
        x = vec3_add_scaled(x, (k >> 1 & 1) - 0.5, up);
        rest[k] = vec3_add_scaled(x, (k >> 2) - 0.5, front);
        low = fmin(low, rest[k].y);
    }
    for (int k = 0; k < CORNERS; k++)
        c.at[k] = particle_start(vec3_make(rest[k].x, rest[k].y - low + 0.35,
                                           rest[k].z),
                                 vec3_make(0, 0, 0), GRAVITY, 8, DT);
    for (int class = 1; class <= classes; class++)
        for (int a = 0; a < CORNERS; a++)
            for (int b = a + 1; b < CORNERS; b++)
                if (class_of(a, b) == class && is_wanted(a, b))
                    c.stick[c.sticks++] = (stick){
                        a, b, vec3_distance(rest[a], rest[b]), 1, STICK_EXACT };
    return c;
}

// The floor holds what has reached it: by friction it stays where it was.
static void hold(cube *c)
{
    for (int k = 0; k < CORNERS; k++)
        if (c->at[k].position.y < 0) {
            c->at[k].position = c->at[k].previous;
            c->at[k].position.y = 0;
        }
}

static void step(cube *c)
{
    verlet_step(c->at, CORNERS, GRAVITY, NULL, DT);
    for (int k = 0; k < ITERATIONS; k++) {
        hold(c);
        sticks_iterate(c->stick, c->sticks, c->at, relax_options_pbd());
    }
    hold(c);
}

static void print_cube(const cube *c, real time)
{
    real strain = 0, height = 0;
    for (int k = 0; k < c->sticks; k++)
        strain = fmax(strain, stick_strain(c->stick[k], c->at));
    for (int k = 0; k < CORNERS; k++)
        height = fmax(height, c->at[k].position.y);
    printf("# %2d sticks, %.2f s: largest strain %.1e, highest corner %.2f m\n",
           c->sticks, time, strain, height);
}

static status add_cube(painter *p, const cube *c, const colour tone[3])
{
    status done = status_ok();
    for (int k = 0; k < CORNERS && done.ok; k++)
        done = painter_ball(p, c->at[k].position, BALL, tone[0]);
    for (int k = 0; k < c->sticks && done.ok; k++) {
        stick s = c->stick[k];
        int edge = class_of(s.a, s.b) == 1;
        vec3 end[2] = { c->at[s.a].position, c->at[s.b].position };
        done = painter_rope(p, end, 2, edge ? EDGE : DIAGONAL,
                            tone[edge ? 1 : 2], tone[edge ? 1 : 2]);
    }
    return done;
}

static status paint(const cube *c, picture *out, int left, int top)
{
    const colour few[3] = { colour_hex(0x4a525d), colour_hex(0xd55e00),
                            colour_hex(0xd55e00) };
    const colour enough[3] = { colour_hex(0x4a525d), colour_hex(0x0072b2),
                               colour_hex(0x56b4e9) };
    painter p;
    painter_init(&p);
    painter_look(&p, vec3_make(2.2, 2.6, 6.5), vec3_make(0.1, 0.74, 0), 22.5);
    p.lamps = 5;
    painter_floor(&p, vec3_make(0, -BALL, 0), 7, 0.5);
    status done = add_cube(&p, c, c->sticks == MOST ? enough : few);
    if (done.ok) done = painter_paint(&p, out, left, top, WIDTH, HEIGHT);
    painter_free(&p);
    return done;
}

static void label(picture *out, int left, int top, int sticks, int k)
{
    const colour ink = colour_hex(0x4a525d);
    char text[40];
    if (k == 0)
        picture_text(out, left + 20, top + 36, 19, ink,
                     sticks == MOST ? "18 + 4 sticks" : "12 sticks");
    snprintf(text, sizeof text, "%.2f s", moment[k] * DT);
    picture_text(out, left + WIDTH - 20 - picture_text(NULL, 0, 0, 16, ink,
                 text), top + 36, 16, ink, text);
}

static status paint_strip(picture *out)
{
    cube c[CUBES] = { cube_start(1), cube_start(3) };
    status done = status_ok();
    int steps = 0;
    for (int k = 0; k < MOMENTS && done.ok; k++) {
        for (; steps < moment[k]; steps++)
            for (int i = 0; i < CUBES; i++) step(&c[i]);
        for (int i = 0; i < CUBES && done.ok; i++) {
            int left = k * (WIDTH + GAP), top = i * (HEIGHT + GAP);
            print_cube(&c[i], moment[k] * DT);
            done = paint(&c[i], out, left, top);
            label(out, left, top, c[i].sticks, k);
        }
    }
    return done;
}

int main(int arguments, char **argument)
{
    if (arguments != 2) {
        fprintf(stderr, "usage: 03-fold FILE.png\n");
        return 2;
    }
    picture out;
    status done = picture_init(&out, MOMENTS * (WIDTH + GAP) - GAP,
                               CUBES * (HEIGHT + GAP) - GAP,
                               colour_hex(0xffffff));
    if (done.ok) done = paint_strip(&out);
    if (done.ok) done = picture_write(&out, argument[1]);
    picture_free(&out);
    if (!done.ok) fprintf(stderr, "03-fold: %s\n", done.why);
    return done.ok ? 0 : 1;
}
