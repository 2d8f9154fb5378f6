// live.c - the ground of all live figures: dials, the lists of what is drawn,
// and what the page may call.

#include "live.h"
#include "live_page.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// --- Lists that grow ------------------------------------------------------------
static void *grow(void *list, int *room, int count, size_t size)
{
    if (count <= *room) return list;
    *room = 2 * count;
    list = realloc(list, (size_t)*room * size);
    if (!list) abort();
    return list;
}

static void put(live_list *l, int n, const float *value)
{
    l->at = grow(l->at, &l->room, l->count + n, sizeof *l->at);
    memcpy(l->at + l->count, value, (size_t)n * sizeof *value);
    l->count += n;
}

static live_page page;
static float palette[LIVE_COLOURS][3];
static double dial[LIVE_DIALS];
static int hand = -1;           // what it holds
static vec3 hand_at;

// --- Dials ------------------------------------------------------------------------
double live_dial(int k)
{
    return dial[k];
}

int live_choice(int k)
{
    return (int)dial[k];
}

static void clear_charts(void)
{
    for (int c = 0; c < LIVE_CHARTS; c++)
        for (int k = 0; k < LIVE_LINES; k++) {
            page.value[c][k] = (real)NAN;
            page.points[c][k] = 0;
        }
}

void page_begin(void)
{
    page.said[0] = page.lit[0] = 0;
    hand = -1;
    clear_charts();
    figure.begin();
}

void page_start(void)
{
    for (int k = 0; k < LIVE_DIALS; k++) dial[k] = figure.dial[k].value;
    page_begin();
}

int page_turn(int k, double value)
{
    dial[k] = value;
    if (figure.dial[k].begins) page_begin();
    else if (figure.turn) figure.turn(k);
    return figure.dial[k].begins;
}

// --- The hand --------------------------------------------------------------------
int live_held(void)
{
    return hand;
}

vec3 live_touched(void)
{
    return hand_at;
}

vec3 live_pull(vec3 at, vec3 velocity)
{
    const real pull = 60, brake = 12;       // 1/s^2, 1/s
    vec3 way = vec3_sub(hand_at, at);
    return vec3_add_scaled(vec3_scale(pull, way), -brake, velocity);
}

// --- Charts and the sentence --------------------------------------------------
void live_value(int chart, int line, real value)
{
    page.value[chart][line] = value;
}

void live_curve(int chart, int line, const real *value, int n)
{
    n = int_min(n, LIVE_CURVE);
    memcpy(page.curve[chart][line], value, (size_t)n * sizeof *value);
    page.points[chart][line] = n;
}

void live_say(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(page.said, sizeof page.said, format, arguments);
    va_end(arguments);
}

void live_light(const char *words)
{
    snprintf(page.lit, sizeof page.lit, "%s", words);
}

// --- Flat drawings --------------------------------------------------------------
// An item: kind, colour, a number, how many points, and these (x, y).
static void item(live_item kind, live_colour c, double number,
                 const vec3 *at, int n)
{
    put(&page.flat, 4, (float[]){ (float)kind, (float)c, (float)number, (float)n });
    for (int i = 0; i < n; i++)
        put(&page.flat, 2, (float[]){ (float)at[i].x, (float)at[i].y });
}

// A text stands in the list of letters; its number is where.
static int letters(const char *text)
{
    int where = page.letters, n = (int)strlen(text) + 1;
    page.letter = grow(page.letter, &page.letter_room, where + n, 1);
    memcpy(page.letter + where, text, (size_t)n);
    page.letters += n;
    return where;
}

void live_pane(int k)
{
    item(LIVE_ITEM_PANE, LIVE_INK, k, NULL, 0);
}

void live_line(live_colour c, const vec3 *at, int n)
{
    item(LIVE_ITEM_LINE, c, 0, at, n);
}

void live_dashes(live_colour c, const vec3 *at, int n)
{
    item(LIVE_ITEM_DASHES, c, 0, at, n);
}

void live_area(live_colour c, const vec3 *at, int n)
{
    item(LIVE_ITEM_AREA, c, 0, at, n);
}

// Without an outline, which is said by its number.
void live_band(live_colour c, const vec3 *at, int n)
{
    item(LIVE_ITEM_AREA, c, 1, at, n);
}

void live_dot(live_colour c, vec3 at, double radius)
{
    item(LIVE_ITEM_DOT, c, radius, &at, 1);
}

void live_circle(live_colour c, vec3 middle, double radius)
{
    item(LIVE_ITEM_CIRCLE, c, radius, &middle, 1);
}

void live_arrow(live_colour c, vec3 from, vec3 to)
{
    item(LIVE_ITEM_ARROW, c, 0, (vec3[]){ from, to }, 2);
}

void live_label(live_colour c, vec3 at, const char *text)
{
    item(LIVE_ITEM_LABEL, c, letters(text), &at, 1);
}

void live_handle(int number, live_colour c, vec3 at, const char *name)
{
    vec3 told[2] = { at, { letters(name), 0, 0 } };
    item(LIVE_ITEM_HANDLE, c, number, told, 2);
}

// --- Drawings in space --------------------------------------------------------
static const vec3 BARE = { 0, 0, LIVE_PLAIN };

int live_vertex(vec3 at, vec3 normal, live_colour c, real shade, vec3 weave)
{
    const float *t = palette[c], s = (float)shade;
    put(&page.place, 3, (float[]){ (float)at.x, (float)at.y, (float)at.z });
    put(&page.normal, 3, (float[]){ (float)normal.x, (float)normal.y, (float)normal.z });
    put(&page.tint, 3, (float[]){ s * t[0], s * t[1], s * t[2] });
    put(&page.weave, 3, (float[]){ (float)weave.x, (float)weave.y, (float)weave.z });
    return page.place.count / 3 - 1;
}

void live_triangle(int number, int a, int b, int c)
{
    page.corner = grow(page.corner, &page.corner_room, page.corners + 3, sizeof *page.corner);
    page.owner = grow(page.owner, &page.owner_room, page.corners / 3 + 1, sizeof *page.owner);
    page.owner[page.corners / 3] = number;
    memcpy(page.corner + page.corners, (int[]){ a, b, c }, 3 * sizeof(int));
    page.corners += 3;
}

static vec3 face_normal(const vec3 *at, const int *f)
{
    return vec3_cross(vec3_sub(at[f[1]], at[f[0]]), vec3_sub(at[f[2]], at[f[0]]));
}

// Flat: every face has corners of its own.
static void mesh_flat(int number, live_colour c, const vec3 *at,
                      const int *face, int faces)
{
    for (const int *f = face; f < face + 3 * faces; f += 3) {
        vec3 n = vec3_unit(face_normal(at, f));
        int first = live_vertex(at[f[0]], n, c, 1, BARE);
        live_vertex(at[f[1]], n, c, 1, BARE);
        live_vertex(at[f[2]], n, c, 1, BARE);
        live_triangle(number, first, first + 1, first + 2);
    }
}

vec3 *live_normals(const vec3 *at, int n, const int *face, int faces)
{
    vec3 *normal = calloc((size_t)n + 1, sizeof *normal);
    if (!normal) abort();
    for (const int *f = face; f < face + 3 * faces; f += 3)
        for (int k = 0; k < 3; k++)
            normal[f[k]] = vec3_add(normal[f[k]], face_normal(at, f));
    for (int i = 0; i < n; i++) normal[i] = vec3_unit(normal[i]);
    return normal;
}

// Smooth: a vertex has the mean normal of its faces.
static void mesh_smooth(int number, live_colour c, const vec3 *at, int n,
                        const int *face, int faces)
{
    vec3 *normal = live_normals(at, n, face, faces);
    int first = page.place.count / 3;
    for (int i = 0; i < n; i++) live_vertex(at[i], normal[i], c, 1, BARE);
    for (const int *f = face; f < face + 3 * faces; f += 3)
        live_triangle(number, first + f[0], first + f[1], first + f[2]);
    free(normal);
}

void live_mesh(int number, live_colour c, const vec3 *at, int n,
               const int *face, int faces, bool smooth)
{
    if (smooth) mesh_smooth(number, c, at, n, face, faces);
    else        mesh_flat(number, c, at, face, faces);
}

// A ball: centre, radius, colour, number.  A tube: ends, radius, colour, number.
void live_ball(int number, live_colour c, vec3 at, real radius)
{
    put(&page.ball, 4, (float[]){ (float)at.x, (float)at.y, (float)at.z, (float)radius });
    put(&page.ball, 3, palette[c]);
    put(&page.ball, 1, (float[]){ (float)number });
}

void live_tube(int number, live_colour c, vec3 a, vec3 b, real radius)
{
    put(&page.tube, 7, (float[]){ (float)a.x, (float)a.y, (float)a.z,
                                  (float)b.x, (float)b.y, (float)b.z, (float)radius });
    put(&page.tube, 3, palette[c]);
    put(&page.tube, 1, (float[]){ (float)number });
}

void live_edge(live_colour c, vec3 a, vec3 b)
{
    put(&page.edge, 3, (float[]){ (float)a.x, (float)a.y, (float)a.z });
    put(&page.edge_tint, 3, palette[c]);
    put(&page.edge, 3, (float[]){ (float)b.x, (float)b.y, (float)b.z });
    put(&page.edge_tint, 3, palette[c]);
}

void page_paint(int colour, double r, double g, double b)
{
    palette[colour][0] = (float)r;
    palette[colour][1] = (float)g;
    palette[colour][2] = (float)b;
}

const live_page *page_draw(void)
{
    live_list *const list[] = { &page.flat, &page.place, &page.normal, &page.tint,
                                &page.weave, &page.ball, &page.tube, &page.edge, &page.edge_tint };
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) list[k]->count = 0;
    page.corners = page.letters = 0;
    figure.draw();
    return &page;
}

// --- What lies under the finger? ----------------------------------------------
static vec3 place_of(const float *p)
{
    return vec3_make((real)p[0], (real)p[1], (real)p[2]);
}

static vec3 place(int i)
{
    return place_of(page.place.at + 3 * i);
}

// How far along the ray is the triangle?  HUGE_VAL: the ray misses it.
static real ray_triangle(vec3 from, vec3 along, vec3 a, vec3 b, vec3 c)
{
    vec3 ab = vec3_sub(b, a), ac = vec3_sub(c, a), p = vec3_cross(along, ac);
    real d = vec3_dot(ab, p);
    if (d == 0) return HUGE_VAL;
    vec3 t = vec3_sub(from, a), q = vec3_cross(t, ab);
    real u = vec3_dot(t, p) / d, v = vec3_dot(along, q) / d;
    real s = vec3_dot(ac, q) / d;
    return u >= 0 && v >= 0 && u + v <= 1 && s > 0 ? s : HUGE_VAL;
}

// A ball, or a tube: a segment with a radius, which is widened for fingers.
static real ray_segment(vec3 from, vec3 along, vec3 a, vec3 b, real radius)
{
    vec3 side = vec3_sub(b, a), to = vec3_sub(a, from);
    real ss = vec3_length_squared(side), sd = vec3_dot(side, along);
    real bottom = ss - sd * sd, s = 0;
    if (bottom > 1e-12 * ss)
        s = (sd * vec3_dot(to, along) - vec3_dot(side, to)) / bottom;
    vec3 near = vec3_add_scaled(to, real_max(0, real_min(1, s)), side);
    real t = vec3_dot(near, along);
    real off = vec3_distance(near, vec3_scale(t, along));
    return t > 0 && off < radius + 0.01 * t ? t - radius : HUGE_VAL;
}

static void nearer(int number, real t, int *hit, real *best)
{
    if (number < 0 || t >= *best) return;
    *hit = number;
    *best = t;
}

int page_pick(double x, double y, double z, double ax, double ay, double az)
{
    vec3 from = { x, y, z }, along = vec3_unit(vec3_make(ax, ay, az));
    int hit = -1;
    real best = HUGE_VAL;
    for (int k = 0; k < page.corners; k += 3) {
        const int *c = page.corner + k;
        nearer(page.owner[k / 3], ray_triangle(from, along, place(c[0]), place(c[1]),
               place(c[2])), &hit, &best);
    }
    for (const float *b = page.ball.at; b && b < page.ball.at + page.ball.count; b += 8) {
        vec3 at = place_of(b);
        nearer((int)b[7], ray_segment(from, along, at, at, (real)b[3]), &hit, &best);
    }
    for (const float *t = page.tube.at; t && t < page.tube.at + page.tube.count; t += 11)
        nearer((int)t[10], ray_segment(from, along, place_of(t), place_of(t + 3),
               (real)t[6]), &hit, &best);
    page.hit = best;
    return hit;
}

// --- The page's other calls -----------------------------------------------------
void page_step(void)
{
    figure.step();
}

void page_measure(void)
{
    if (figure.measure) figure.measure();
}

unsigned long long page_hash(void)
{
    return figure.hash();
}

void page_press(int button)
{
    if (figure.press) figure.press(button);
}

void page_move(int number, double x, double y, double z)
{
    hand = number;
    hand_at = vec3_make(x, y, z);
    if (figure.move) figure.move(number, hand_at);
}

void page_release(int number)
{
    hand = -1;
    if (figure.release) figure.release(number);
}

void page_tap(int number, double x, double y, double z, double px, double py, double pz)
{
    hand_at = vec3_make(px, py, pz);
    if (number < 0) figure.ground(hand_at);
    else if (figure.tap) figure.tap(number, vec3_unit(vec3_make(x, y, z)));
}

unsigned long long live_hash(unsigned long long h, const void *bytes, size_t n)
{
    const unsigned char *b = bytes;
    while (n-- > 0) h = (h ^ *b++) * 0x100000001b3ULL;
    return h;
}
