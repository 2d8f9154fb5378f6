// 07-fly.c - a fly of a gram and an elephant of a kilogram overlap.  Who makes
// room, by Eq. 10 as printed and by mass?  07-fly FILE.png

#include "body.h"
#include "painter.h"
#include "response.h"

#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 620, HEIGHT = 500, GAP = 6, LAMPS = 4, PANELS = 3,
       ROUND = 3 };                     // times a ball's faces are divided
static const real PI = 3.14159265358979;

// Half the length of the elephant's body and of the fly's, how deep one is in
// the other, and how high it all happens, m.
static const real ELEPHANT = 0.78, FLY = 0.21, DEPTH = 0.36, HIGH = 0.95;

// ---- Parts of an animal ----------------------------------------------------

enum { CORNERS = 642, FACES = 1280 };
typedef struct {
    int  corners, faces;
    vec3 at[CORNERS];
    int  face[3 * FACES];
} ball;
static ball unit_ball;

static int middle_of(ball *b, int i, int j)
{
    vec3 m = vec3_unit(vec3_add(b->at[i], b->at[j]));
    for (int k = 0; k < b->corners; k++)
        if (vec3_distance(b->at[k], m) < 1e-9) return k;
    b->at[b->corners] = m;
    return b->corners++;
}

static status ball_make(ball *b)
{
    shape s;
    status done = shape_icosahedron(&s, 1, 1);
    if (!done.ok) return done;
    b->corners = s.particles;
    b->faces = s.mesh.faces;
    for (int i = 0; i < b->corners; i++) b->at[i] = vec3_unit(s.at[i]);
    for (int i = 0; i < 3 * b->faces; i++) b->face[i] = s.face[i];
    shape_free(&s);
    for (int round = 0; round < ROUND; round++)
        for (int f = b->faces - 1; f >= 0; f--) {
            int *c = &b->face[3 * f], m[3];
            for (int k = 0; k < 3; k++)
                m[k] = middle_of(b, c[k], c[(k + 1) % 3]);
            for (int k = 0; k < 3; k++) {
                int *more = &b->face[3 * b->faces++];
                more[0] = c[k];
                more[1] = m[k];
                more[2] = m[(k + 2) % 3];
            }
            for (int k = 0; k < 3; k++) c[k] = m[k];
        }
    return status_ok();
}

// An egg with these three half axes (m); the half axes x and y turned by a
// (radians) in their plane, then x and z by b.
static status egg(painter *p, vec3 middle, vec3 half, real a, real b, colour c)
{
    vec3 at[CORNERS];
    for (int i = 0; i < unit_ball.corners; i++) {
        vec3 v = unit_ball.at[i];
        v = vec3_make(v.x * half.x, v.y * half.y, v.z * half.z);
        v = vec3_make(cos(a) * v.x - sin(a) * v.y,
                      sin(a) * v.x + cos(a) * v.y, v.z);
        v = vec3_make(cos(b) * v.x + sin(b) * v.z, v.y,
                      cos(b) * v.z - sin(b) * v.x);
        at[i] = vec3_add(middle, v);
    }
    painted_mesh m = { .vertices = unit_ball.corners, .at = at,
                       .faces = unit_ball.faces, .face = unit_ball.face,
                       .front = { c, c }, .back = { c, c }, .casts = 1,
                       .smooth = 1, .gloss = 0.25 };
    return painter_mesh(p, &m);
}

// A tube along the parabola that corner pulls from `from` to `to`.
static status limb(painter *p, vec3 from, vec3 corner, vec3 to, real thick,
                   real thin, colour c)
{
    enum { SIDES = 10, CUTS = 10, N = SIDES * (CUTS + 1) + 1 };
    vec3 at[N];
    int face[3 * SIDES * (2 * CUTS + 1)], *f = face;
    for (int j = 0; j <= CUTS; j++) {
        real t = (real)j / CUTS, s = 1 - t, r = s * thick + t * thin;
        vec3 x = vec3_scale(s * s, from);
        x = vec3_add_scaled(x, 2 * s * t, corner);
        x = vec3_add_scaled(x, t * t, to);
        vec3 along = vec3_add(vec3_scale(s, vec3_sub(corner, from)),
                              vec3_scale(t, vec3_sub(to, corner)));
        along = vec3_unit(along);
        vec3 v = vec3_unit(vec3_cross(along, vec3_make(0.05, 0.02, 1)));
        vec3 u = vec3_cross(v, along);
        for (int i = 0; i < SIDES; i++) {
            real a = 2 * PI * i / SIDES;
            vec3 y = vec3_add_scaled(x, r * cos(a), u);
            at[j * SIDES + i] = vec3_add_scaled(y, r * sin(a), v);
        }
    }
    at[N - 1] = to;
    for (int j = 0; j <= CUTS; j++)
        for (int i = 0; i < SIDES; i++) {
            int k = j * SIDES + i, n = j * SIDES + (i + 1) % SIDES;
            int corners[6] = { k, n, k + SIDES, n, n + SIDES, k + SIDES };
            if (j == CUTS) corners[2] = N - 1;
            for (int q = 0; q < (j == CUTS ? 3 : 6); q++) *f++ = corners[q];
        }
    painted_mesh m = { .vertices = N, .at = at,
                       .faces = SIDES * (2 * CUTS + 1), .face = face,
                       .front = { c, c }, .back = { c, c }, .casts = 1,
                       .smooth = 1, .gloss = 0.2 };
    return painter_mesh(p, &m);
}

// ---- The two animals -------------------------------------------------------

static vec3 off(vec3 at, real x, real y, real z)
{
    return vec3_add(at, vec3_make(x, y, z));
}

// `at` is the middle of its body; it looks along x.
static status elephant(painter *p, vec3 at)
{
    const colour skin = colour_hex(0x8f9bab), ear = colour_hex(0x7f8b9d);
    const colour ivory = colour_hex(0xfbf6e6), eye = colour_hex(0x22262c);
    status done = egg(p, at, vec3_make(ELEPHANT, 0.57, 0.52), 0, 0, skin);
    for (int k = 0; k < 4 && done.ok; k++) {
        real x = k & 1 ? 0.42 : -0.44, z = k & 2 ? 0.21 : -0.21;
        done = limb(p, off(at, x, -HIGH, z), off(at, x, -0.5, z),
                    off(at, x, -0.1, z), 0.17, 0.16, skin);
    }
    vec3 head = off(at, 0.86, 0.27, 0);
    if (done.ok) done = egg(p, head, vec3_make(0.37, 0.41, 0.33), 0, 0, skin);
    if (done.ok) done = limb(p, off(head, 0.22, 0, 0), off(head, 0.62, -0.5, 0),
                             off(head, 0.34, -0.98, 0), 0.19, 0.075, skin);
    if (done.ok) done = limb(p, off(head, 0.34, -0.98, 0),
                             off(head, 0.33, -1.09, 0),
                             off(head, 0.52, -1.08, 0), 0.075, 0.06, skin);
    for (int side = -1; side <= 1 && done.ok; side += 2) {
        done = egg(p, off(head, -0.18, 0, 0.37 * side),
                   vec3_make(0.29, 0.4, 0.05), 0.15, -0.35 * side, ear);
        if (done.ok) done = painter_ball(p, off(head, 0.27, 0.1, 0.22 * side),
                                         0.045, eye);
        if (done.ok) done = limb(p, off(head, 0.22, -0.24, 0.17 * side),
                                 off(head, 0.42, -0.46, 0.21 * side),
                                 off(head, 0.66, -0.4, 0.2 * side), 0.055,
                                 0.015, ivory);
    }
    if (done.ok) done = limb(p, off(at, -0.66, 0.26, 0), off(at, -1, 0.36, 0),
                             off(at, -1, 0.74, 0), 0.04, 0.025, skin);
    if (done.ok) done = egg(p, off(at, -1, 0.78, 0),
                            vec3_make(0.05, 0.09, 0.05), 0, 0, eye);
    return done;
}

static status fly(painter *p, vec3 at)
{
    const colour coat = colour_hex(0x1f3a33), eyes = colour_hex(0xd55e00);
    const colour wing = colour_hex(0xbfdcec);
    status done = egg(p, at, vec3_make(FLY, 0.14, 0.14), 0, 0, coat);
    for (int side = -1; side <= 1 && done.ok; side += 2) {
        done = painter_ball(p, off(at, 0.15, 0.06, 0.075 * side), 0.065, eyes);
        if (done.ok) done = egg(p, off(at, -0.17, 0.2, 0.13 * side),
                                vec3_make(0.22, 0.014, 0.08), -0.75,
                                0.5 * side, wing);
    }
    return done;
}

// ---- What they do ----------------------------------------------------------

typedef struct {
    vec3 fly, elephant;
} places;

static places overlapping(void)
{
    return (places){ { DEPTH - FLY - ELEPHANT, HIGH, 0 }, { 0, HIGH, 0 } };
}

typedef enum { NOT_YET, PRINTED, BY_MASS } way;

// The two as particles in the middle of what they show: a gram and a kilogram.
static places part(way how)
{
    places from = overlapping();
    particle p[2] = { { from.fly, from.fly, 1000 },
                      { from.elephant, from.elephant, 1 } };
    feature_contact c = { .a = { 1, { 0 }, { 1 } }, .b = { 1, { 1 }, { 1 } },
                          .normal = { -1, 0, 0 }, .apart = FLY + ELEPHANT,
                          .mass_a = 0.001, .mass_b = 1 };
    response_errata errata = { .masses_exchanged = true };
    if (how == PRINTED) response_printed(&c, p, errata);
    if (how == BY_MASS) response_separate(&c, p, 0);
    return (places){ p[0].position, p[1].position };
}

// ---- Painting --------------------------------------------------------------

static status arrow(painter *p, vec3 from, vec3 to, colour c)
{
    const real head = 0.09, width = 0.009;
    if (vec3_distance(from, to) < head) return status_ok();
    vec3 along = vec3_unit(vec3_sub(to, from));
    status done = painter_line(p, from, to, width, c);
    for (int side = -1; side <= 1 && done.ok; side += 2) {
        vec3 barb = vec3_add_scaled(to, -head, along);
        done = painter_line(p, to, off(barb, 0, 0.6 * head * side, 0), width,
                            c);
    }
    return done;
}

static status arrows(painter *p, const places *now, const places *was)
{
    status done = arrow(p, off(was->elephant, 0, 0.82, 0),
                        off(now->elephant, 0, 0.82, 0), colour_hex(0xd55e00));
    if (!done.ok) return done;
    return arrow(p, off(was->fly, 0, -0.3, 0.45), off(now->fly, 0, -0.3, 0.45),
                 colour_hex(0x009e73));
}

// With which of the two a painting has: as they are, as they were.
typedef enum { FLY_NOW = 1, ELEPHANT_NOW = 2, GHOSTS = 4 } cast_list;

static status paint(const places *now, const places *was, cast_list who,
                    picture *out)
{
    painter p;
    painter_init(&p);
    p.lamps = LAMPS;
    painter_look(&p, vec3_make(1.75, 1.9, 6.9), vec3_make(0.36, 0.8, 0), 24);
    painter_floor(&p, vec3_make(0.2, 0, 0), 8, 0.25);
    p.lamp = vec3_unit(vec3_make(-0.35, 1, 0.55));
    status done = status_ok();
    if (who & GHOSTS) {
        done = elephant(&p, was->elephant);
        if (done.ok) done = fly(&p, was->fly);
        for (int i = 0; i < p.count; i++) p.triangle[i].casts = 0;
    }
    if (done.ok && who & ELEPHANT_NOW) done = elephant(&p, now->elephant);
    if (done.ok && who & FLY_NOW) done = fly(&p, now->fly);
    if (done.ok) done = arrows(&p, now, was);
    if (done.ok) done = painter_paint(&p, out, 0, 0, WIDTH, HEIGHT);
    painter_free(&p);
    return done;
}

// The painter knows no glass: two pictures mixed, `share` of the second, show
// what the first has not as if it were of glass.
static status mixed(const places *now, const places *was, cast_list first,
                    cast_list second, real share, picture *out)
{
    picture more;
    status done = picture_init(&more, WIDTH, HEIGHT, colour_hex(0xffffff));
    if (!done.ok) return done;
    done = paint(now, was, first, out);
    if (done.ok) done = paint(now, was, second, &more);
    for (int i = 0; i < WIDTH * HEIGHT && done.ok; i++)
        out->at[i] = colour_mix(out->at[i], more.at[i], share);
    picture_free(&more);
    return done;
}

static status panel(int k, picture *out)
{
    static const way how[PANELS] = { NOT_YET, PRINTED, BY_MASS };
    static const char *const title[PANELS] = { "before", "Eq. 10 as printed",
                                               "by mass" };
    const cast_list both = FLY_NOW | ELEPHANT_NOW;
    const places was = overlapping(), now = part(how[k]);
    picture p;
    status done = picture_init(&p, WIDTH, HEIGHT, colour_hex(0xffffff));
    if (!done.ok) return done;
    done = k == 0 ? mixed(&was, &was, FLY_NOW, both, 0.72, &p)
                  : mixed(&now, &was, both, both | GHOSTS, 0.3, &p);
    picture_text(&p, 24, HEIGHT - 24, 19, colour_hex(0x4a4f57), title[k]);
    printf("%s: the elephant moves %.4f m, the fly %.4f m\n", title[k],
           vec3_distance(was.elephant, now.elephant),
           vec3_distance(was.fly, now.fly));
    if (done.ok) picture_copy(out, k * (WIDTH + GAP), 0, &p);
    picture_free(&p);
    return done;
}

int main(int arguments, char **argument)
{
    if (arguments != 2) {
        fprintf(stderr, "usage: 07-fly FILE.png\n");
        return 2;
    }
    picture p;
    status done = picture_init(&p, PANELS * (WIDTH + GAP) - GAP, HEIGHT,
                               colour_hex(0xffffff));
    if (done.ok) done = ball_make(&unit_ball);
    for (int k = 0; k < PANELS && done.ok; k++) done = panel(k, &p);
    if (done.ok) done = picture_write(&p, argument[1]);
    picture_free(&p);
    if (!done.ok) fprintf(stderr, "07-fly: %s\n", done.why);
    return done.ok ? 0 : 1;
}
