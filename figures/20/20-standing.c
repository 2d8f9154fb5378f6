// 20-standing.c - hard cases 17 to 20: a stack, a heavy cube on a light one, a
// house of cards and an arch, each after 30 s in which no body was allowed to
// sleep; and two cubes that begin half inside each other, at three moments.
// 20-standing FILE.png
//
// Prints what each has moved.

#include "hard_set.h"
#include "painter.h"
#include "step.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDE = 1880, HIGH = 1200, LAMPS = 6, SECONDS = 30,
       MOMENTS = 3 };
static const real PI = 3.14159265358979;

// Where a panel lies in the picture, and what it looks at.
typedef struct {
    int  left, top, width, height;
    vec3 eye, target, lamp;
    real degrees, floor;    // m, how far the floor goes; 0: none
} panel;

// Okabe and Ito's colours, a little softened.
static const unsigned skin[] = { 0xe69f00, 0x56b4e9, 0x009e73, 0xefdc4a,
                                 0x0072b2, 0xd55e00, 0xcc79a7 };
static const unsigned card[] = { 0xf4ede0, 0xe3ecf3 };
static const unsigned stone[] = { 0xb9a88f, 0xcbbca5 };
static const unsigned weight[] = { 0xf3c766, 0x4a525d };

static status paint_body(painter *p, const world *w, int b, unsigned tone)
{
    const shape *plan = w->body[b].shape;
    const colour c = colour_hex(tone);
    vec3 *at = malloc((size_t)plan->particles * sizeof *at);
    if (!at) return status_out_of_memory();
    world_vertices(w, &w->body[b], at);
    painted_mesh m = { .vertices = plan->particles, .at = at,
                       .faces = plan->mesh.faces, .face = plan->face,
                       .front = { c, c }, .back = { c, c },
                       .creases = 1, .casts = 1, .gloss = 0.25 };
    status done = painter_mesh(p, &m);
    free(at);
    return done;
}

// Body b gets colour b of so many, again and again.
static status paint(const panel *v, const world *w, const unsigned *tone,
                    int tones, picture *out)
{
    painter p;
    painter_init(&p);
    p.lamps = LAMPS;
    painter_look(&p, v->eye, v->target, v->degrees);
    if (v->floor > 0) painter_floor(&p, vec3_make(0, 0, 0), v->floor, 0.5);
    p.lamp = vec3_unit(v->lamp);
    status done = status_ok();
    for (int b = 0; b < w->bodies && done.ok; b++)
        done = paint_body(&p, w, b, tone[b % tones]);
    if (done.ok)
        done = painter_paint(&p, out, v->left, v->top, v->width, v->height);
    painter_free(&p);
    return done;
}

static void write_on(picture *out, const panel *v, const char *title,
                     const char *below)
{
    const colour ink = colour_hex(0x30353c), pale = colour_hex(0x5a616b);
    picture_text(out, v->left + 22, v->top + 42, 20, ink, title);
    picture_text(out, v->left + 22, v->top + v->height - 22, 15, pale, below);
}

// m, the farthest that a body is from where it began.
static real moved(const setting *s)
{
    real most = 0;
    for (int b = 0; b < s->w.bodies; b++)
        most = fmax(most, vec3_distance(middle(&s->w, b), s->start[b]));
    return most;
}

// What stands, after SECONDS.
static status stand(setting *s, const panel *v, const unsigned *tone, int tones,
                    const char *title, picture *out)
{
    char below[80];
    status done = setting_begin(s);
    if (done.ok) {
        run_for(s, SECONDS);
        snprintf(below, sizeof below, "after %d s: moved by %.2g mm", SECONDS,
                 1e3 * moved(s));
        printf("%s: %s\n", title, below);
        done = paint(v, &s->w, tone, tones, out);
        write_on(out, v, title, below);
    }
    setting_free(s);
    return done;
}

static status stack(picture *out)
{
    const panel v = { 0, 0, 420, HIGH, { 12, 13.5, 30 }, { 0, 10.1, 0 },
                      { -0.5, 1, 0.8 }, 41, 22 };
    setting s;
    build_stack(&s, standing(20, 0.5, 1), 20, 1);
    return stand(&s, &v, skin, 7, "17. Twenty cubes", out);
}

static status heavy(picture *out)
{
    const panel v = { 428, 0, 420, 696, { 1.9, 2.5, 5.2 }, { 0, 1.02, 0 },
                      { -0.5, 1, 0.6 }, 37, 7 };
    setting s;
    build_stack(&s, standing(60, 0.5, 1), 2, 1000);
    return stand(&s, &v, weight, 2, "18. 1000 kg on 1 kg", out);
}

static status cards(picture *out)
{
    const panel v = { 856, 0, 1024, 696, { 4.4, 3.4, 8.8 }, { 0.1, 2.28, 0 },
                      { 1, 1, 0.9 }, 34, 13 };
    setting s;
    build_card_house(&s, standing(20, 0.7, 1), 5, 20 * PI / 180);
    return stand(&s, &v, card, 2, "19. A house of 40 cards", out);
}

static status arch(picture *out)
{
    const panel v = { 428, 704, 560, 496, { 1.1, 1.5, 4.6 }, { 0.02, 0.56, 0 },
                      { -0.5, 1, 0.8 }, 27, 6 };
    setting s;
    build_arch(&s, standing(20, 0.7, 1), 11, outer_radius(0.112));
    return stand(&s, &v, stone, 2, "19. The thinnest arch", out);
}

static status overlap(picture *out)
{
    static const int frame[MOMENTS] = { 0, 6, 30 };
    setting s;
    build_overlap(&s, best(10), vec3_make(0.5, 0.1, 0.05));
    status done = setting_begin(&s);
    for (int k = 0, f = 0; k < MOMENTS && done.ok; k++) {
        const panel v = { 996 + k * 296, 704, k < 2 ? 288 : 292, 496,
                          { 1.7, 2.1, 6 }, { 0.25, 0, 0 }, { -0.5, 1, 0.8 }, 35,
                          0 };
        char below[80];
        for (; f < frame[k]; f++) world_step(&s.w);
        real apart = vec3_distance(middle(&s.w, 0), middle(&s.w, 1));
        snprintf(below, sizeof below, "%.1f s", f * s.w.options.dt);
        printf("20. Two cubes after %s: middles %.3f m apart\n", below, apart);
        done = paint(&v, &s.w, skin, 2, out);
        write_on(out, &v, k == 0 ? "20. Half inside" : "", below);
    }
    setting_free(&s);
    return done;
}

int main(int arguments, char **argument)
{
    if (arguments != 2) {
        fprintf(stderr, "usage: 20-standing FILE.png\n");
        return 2;
    }
    status (*const part[])(picture *) = { stack, heavy, cards, arch, overlap };
    picture p;
    status done = picture_init(&p, WIDE, HIGH, colour_hex(0xffffff));
    for (int k = 0; k < 5 && done.ok; k++) done = part[k](&p);
    if (done.ok) done = picture_write(&p, argument[1]);
    picture_free(&p);
    if (!done.ok) fprintf(stderr, "20-standing: %s\n", done.why);
    return done.ok ? 0 : 1;
}
