// 06-levels.c - four levels of a sphere tree over a draped cloth, and of one
// over an egg: the spheres of a level, and in their colours what each of them
// holds.  06-levels FILE.png

#include "body.h"
#include "painter.h"
#include "sphere_tree.h"

#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 432, HEIGHT = 416, GAP = 6, PANELS = 4, LAMPS = 2,
       CLOTH = 33, MOST = 2 * (CLOTH - 1) * (CLOTH - 1) };
static const int LEVEL[PANELS] = { 0, 2, 4, 6 };

// What is shown: triangles at their places, in a tree, and how to look at them.
typedef struct {
    int  vertices, faces;
    vec3 at[MOST], rest[MOST];  // now, and when the tree was built
    int  face[3 * MOST];
    sphere_tree tree;
    vec3 eye, target, lamp;
    real floor;         // m, its height
    int  is_cloth;
    const char *name;
} subject;

// ---- A cloth falls on a ball -----------------------------------------------

static const real BALL = 0.5;   // m, its radius; its middle is the origin

// What touches the ball stays where it touches it.
static void keep_out(particle *p, int n)
{
    const vec3 middle = { 0, 0, 0 };
    for (int i = 0; i < n; i++) {
        vec3 out = vec3_sub(p[i].previous, middle);
        if (vec3_distance(p[i].position, middle) < BALL)
            p[i].position = vec3_add_scaled(middle, BALL, vec3_unit(out));
    }
}

static status drape(subject *s)
{
    enum { STEPS = 480, SWEEPS = 10 };
    const real dt = 1.0 / 240, keep = 0.996;
    const vec3 gravity = { 0, -9.81, 0 };
    static particle p[CLOTH * CLOTH];
    shape plan;
    status done = shape_cloth(&plan, CLOTH, CLOTH, 2, 2, 1, 0.3);
    if (!done.ok) return done;
    for (int i = 0; i < plan.particles; i++) {
        vec3 x = vec3_add(plan.at[i], vec3_make(0.1, BALL + 0.02, -0.06));
        p[i] = particle_start(x, vec3_make(0, 0, 0), gravity, 1, dt);
    }
    for (int step = 0; step < STEPS; step++) {
        for (int i = 0; i < plan.particles; i++) {
            vec3 moved = vec3_sub(p[i].position, p[i].previous);
            p[i].previous = vec3_add_scaled(p[i].position, -keep, moved);
        }
        verlet_step(p, plan.particles, gravity, NULL, dt);
        for (int k = 0; k < SWEEPS; k++) {
            sticks_iterate(plan.stick, plan.sticks, p, relax_options_pbd());
            keep_out(p, plan.particles);
        }
    }
    s->vertices = plan.particles;
    s->faces = plan.mesh.faces;
    for (int i = 0; i < s->vertices; i++) {
        s->rest[i] = plan.at[i];
        s->at[i] = p[i].position;
    }
    for (int i = 0; i < 3 * s->faces; i++) s->face[i] = plan.face[i];
    shape_free(&plan);
    return status_ok();
}

// ---- An egg ----------------------------------------------------------------

static int middle_of(subject *s, int a, int b)
{
    vec3 m = vec3_unit(vec3_add(s->at[a], s->at[b]));
    for (int i = 0; i < s->vertices; i++)
        if (vec3_distance(s->at[i], m) < 1e-9) return i;
    s->at[s->vertices] = m;
    return s->vertices++;
}

static void divide(subject *s)
{
    int faces = s->faces;
    for (int f = 0; f < faces; f++) {
        int *c = &s->face[3 * f], m[3];
        for (int k = 0; k < 3; k++) m[k] = middle_of(s, c[k], c[(k + 1) % 3]);
        for (int k = 0; k < 3; k++) {
            int *more = &s->face[3 * s->faces++];
            more[0] = c[k];
            more[1] = m[k];
            more[2] = m[(k + 2) % 3];
        }
        for (int k = 0; k < 3; k++) c[k] = m[k];
    }
}

static status carve(subject *s)
{
    shape plan;
    status done = shape_icosahedron(&plan, 1, 1);
    if (!done.ok) return done;
    s->vertices = plan.particles;
    s->faces = plan.mesh.faces;
    for (int i = 0; i < s->vertices; i++) s->at[i] = vec3_unit(plan.at[i]);
    for (int i = 0; i < 3 * s->faces; i++) s->face[i] = plan.face[i];
    shape_free(&plan);
    divide(s);
    divide(s);
    divide(s);
    // Longer than wide, and one end blunter than the other.
    for (int i = 0; i < s->vertices; i++) {
        vec3 v = s->at[i];
        real thin = 1 - 0.22 * v.x;
        s->at[i] = vec3_make(0.98 * v.x, 0.56 * thin * v.y,
                             0.62 * thin * v.z);
        s->rest[i] = s->at[i];
    }
    return status_ok();
}

// ---- Painting --------------------------------------------------------------

// Okabe and Ito's colours; neighbours in a grid of nodes get different ones.
static colour node_colour(int path, int level)
{
    static const unsigned wheel[] = { 0xe69f00, 0x56b4e9, 0x009e73, 0xcc79a7,
                                      0xefdc4a, 0x0072b2, 0xd55e00 };
    int x = 0, y = 0;
    for (int k = level - 1; k >= 0; k--)
        if (k % 2) x = 2 * x + (path >> k & 1);
        else       y = 2 * y + (path >> k & 1);
    return colour_hex(wheel[(x + 3 * y) % 7]);
}

static status paint_patch(painter *p, const subject *s, int node, colour c)
{
    static int face[3 * MOST];
    int faces = 0, stack[64], top = 0;
    stack[top++] = node;
    while (top > 0) {
        int k = stack[--top];
        const tree_node *n = &s->tree.node[k];
        if (k >= s->tree.leaves) {
            stack[top++] = n->child[0];
            stack[top++] = n->child[1];
            continue;
        }
        for (int j = 0; j < 3; j++)
            face[3 * faces + j] = s->face[3 * k + j];
        faces++;
    }
    colour pale = colour_mix(c, colour_hex(0xffffff), 0.25);
    painted_mesh m = { .vertices = s->vertices, .at = s->at, .faces = faces,
                       .face = face, .front = { c, c }, .back = { pale, pale },
                       .smooth = s->is_cloth, .creases = !s->is_cloth,
                       .casts = 1, .gloss = 0.1 };
    return painter_mesh(p, &m);
}

// A ball as the eye sees its rim: where the lines of sight touch it.
static status paint_rim(painter *p, sphere b, colour c)
{
    enum { PARTS = 72 };
    vec3 to_eye = vec3_sub(p->eye, b.center);
    real far = vec3_length(to_eye), ratio = b.radius / far;
    vec3 w = vec3_scale(1 / far, to_eye);
    vec3 middle = vec3_add_scaled(b.center, b.radius * ratio, w);
    vec3 u = vec3_unit(vec3_cross(p->up, w)), v = vec3_cross(w, u);
    real r = b.radius * sqrt(1 - ratio * ratio);
    vec3 before = vec3_add_scaled(middle, r, u);
    status done = status_ok();
    for (int k = 1; k <= PARTS && done.ok; k++) {
        real a = 2 * 3.14159265358979 * k / PARTS;
        vec3 at = vec3_add_scaled(middle, r * cos(a), u);
        at = vec3_add_scaled(at, r * sin(a), v);
        done = painter_line(p, before, at, 0.0035, c);
        before = at;
    }
    return done;
}

// All nodes of a level: what they hold, and, if asked for, their balls.
static status paint_level(painter *p, const subject *s, int node, int path,
                          int level, int left, int balls)
{
    const tree_node *n = &s->tree.node[node];
    if (left > 0 && node >= s->tree.leaves) {
        status done = paint_level(p, s, n->child[0], 2 * path, level, left - 1,
                                  balls);
        if (!done.ok) return done;
        return paint_level(p, s, n->child[1], 2 * path + 1, level, left - 1,
                           balls);
    }
    colour c = node_colour(path, level);
    status done = paint_patch(p, s, node, c);
    if (done.ok && balls) done = painter_ball(p, n->ball.center,
                                              n->ball.radius, c);
    if (done.ok) done = paint_rim(p, n->ball,
                                  colour_mix(c, colour_hex(0x303030), 0.3));
    return done;
}

static status paint(const subject *s, int level, int balls, picture *out)
{
    painter p;
    painter_init(&p);
    p.lamps = LAMPS;
    painter_look(&p, s->eye, s->target, 26);
    painter_floor(&p, vec3_make(0, s->floor, 0), 7, 0.25);
    p.lamp = vec3_unit(s->lamp);
    status done = paint_level(&p, s, s->tree.nodes - 1, 0, level, level, balls);
    for (int i = 0; i < p.count; i++)
        if (balls && p.triangle[i].gloss > 0.3) p.triangle[i].casts = 0;
    if (done.ok) done = painter_paint(&p, out, 0, 0, WIDTH, HEIGHT);
    painter_free(&p);
    return done;
}

// The painter knows no glass.  A picture with the balls and one without them,
// mixed, show balls that one can see through.
static status panel(const subject *s, int level, picture *out, int left,
                    int top)
{
    const real share = 0.3;
    picture bare, full;
    status done = picture_init(&bare, WIDTH, HEIGHT, colour_hex(0xffffff));
    if (!done.ok) return done;
    done = picture_init(&full, WIDTH, HEIGHT, colour_hex(0xffffff));
    if (done.ok) done = paint(s, level, 0, &bare);
    if (done.ok) done = paint(s, level, 1, &full);
    for (int i = 0; i < WIDTH * HEIGHT && done.ok; i++)
        bare.at[i] = colour_mix(bare.at[i], full.at[i], share);
    char text[32];
    snprintf(text, sizeof text, level ? "%d spheres" : "%d sphere", 1 << level);
    picture_text(&bare, 18, HEIGHT - 18, 13, colour_hex(0x4a4f57), text);
    if (done.ok) picture_copy(out, left, top, &bare);
    picture_free(&bare);
    picture_free(&full);
    return done;
}

// How much larger than need be is the ball around all of it?
static void print_roots(subject *s)
{
    static int index[MOST];
    int support[4], supports;
    real weight[4];
    for (int i = 0; i < s->vertices; i++) index[i] = i;
    sphere least = sphere_of_points(s->at, index, s->vertices, support, weight,
                                    &supports);
    printf("%s: the root's sphere has a radius of %.2f m, "
           "the smallest %.2f m\n",
           s->name, sphere_tree_root(&s->tree, s->at).radius, least.radius);
}

static status row(subject *s, tree_kind kind, picture *out, int top)
{
    static leaf_feature leaf[MOST];
    for (int f = 0; f < s->faces; f++) {
        const int *v = &s->face[3 * f];
        leaf[f] = (leaf_feature){ 3, { v[0], v[1], v[2] } };
    }
    status done = sphere_tree_build(&s->tree, kind, s->rest, leaf, s->faces, 0,
                                    0);
    if (done.ok) sphere_tree_refresh(&s->tree, s->at);
    if (done.ok) print_roots(s);
    for (int k = 0; k < PANELS && done.ok; k++)
        done = panel(s, LEVEL[k], out, k * (WIDTH + GAP), top);
    sphere_tree_free(&s->tree);
    return done;
}

int main(int arguments, char **argument)
{
    if (arguments != 2) {
        fprintf(stderr, "usage: 06-levels FILE.png\n");
        return 2;
    }
    static subject cloth = { .eye = { 2.1, 2.1, 6.3 },
                             .target = { 0.1, 0.06, 0 },
                             .lamp = { -0.4, 1, 0.5 }, .floor = -1.35,
                             .is_cloth = 1, .name = "cloth" };
    static subject body = { .eye = { 1.8, 1.6, 4.6 },
                            .target = { 0, -0.1, 0 },
                            .lamp = { -0.4, 1, 0.5 }, .floor = -1.1,
                            .name = "egg" };
    picture p;
    status done = picture_init(&p, PANELS * (WIDTH + GAP) - GAP,
                               2 * HEIGHT + GAP, colour_hex(0xffffff));
    if (done.ok) done = drape(&cloth);
    if (done.ok) done = carve(&body);
    if (done.ok) done = row(&cloth, TREE_LAYERED, &p, 0);
    if (done.ok) done = row(&body, TREE_WRAPPED, &p, HEIGHT + GAP);
    if (done.ok) done = picture_write(&p, argument[1]);
    picture_free(&p);
    if (!done.ok) fprintf(stderr, "06-levels: %s\n", done.why);
    return done.ok ? 0 : 1;
}
