// live_film.c - a live figure as a film, for machines without clang for
// WebAssembly: SVG pictures, one after the other, that any browser shows.

#include "live_page.h"

#include <stdio.h>
#include <stdlib.h>

enum { PICTURES = 24, EVERY = 5, WIDE = 760, HIGH = 428 };  // frames; points
static const real SECONDS = PICTURES * EVERY / 60.0;
static const char *const INK[LIVE_COLOURS] = {
    "#22252a", "#5d636d", "#d9d6cd", "#1f6fb4", "#c8570b", "#2c7d3f", "#7b4ba8", "#b8252f", "#6b7078"
};
static const double SOLID[LIVE_COLOURS][3] = {
    { 74, 78, 85 }, { 139, 144, 152 }, { 230, 227, 218 }, { 91, 149, 201 }, { 221, 138, 77 },
    { 107, 166, 119 }, { 157, 127, 191 }, { 207, 90, 94 }, { 183, 180, 173 }
};

// --- Flat drawings ----------------------------------------------------------------
typedef struct {
    double scale, x, y;         // points a unit; where the origin stands
} pane;

static pane pane_of(int k)
{
    double aspects = 0, left = 0, wide = 0;
    for (int i = 0; i < LIVE_PANES && figure.pane[i].width > 0; i++) aspects += figure.pane[i].width / figure.pane[i].height;
    for (int i = 0; i <= k; i++) {
        left += wide;
        wide = WIDE * figure.pane[i].width / figure.pane[i].height / aspects;
    }
    const live_pane_plan *p = &figure.pane[k];
    double scale = real_min(wide / p->width, HIGH / p->height);
    return (pane){ scale, left + wide / 2 - scale * (p->left + p->width / 2),
                   HIGH / 2.0 + scale * (p->bottom + p->height / 2) };
}

static void print_points(const pane *p, const float *at, int n)
{
    printf("points='");
    for (int i = 0; i < n; i++) printf("%.1f,%.1f ", p->x + p->scale * (double)at[2 * i], p->y - p->scale * (double)at[2 * i + 1]);
    printf("'");
}

static void print_item(const live_page *page, const pane *p, const float *item)
{
    const float *at = item + 4;
    const char *c = INK[(int)item[1]];
    double number = (double)item[2], x = p->x + p->scale * (double)at[0], y = p->y - p->scale * (double)at[1];
    int n = (int)item[3];
    switch ((live_item)item[0]) {
    case LIVE_ITEM_AREA:
        printf("<polygon fill='%s' fill-opacity='.14' stroke='%s' ", c, c);
        print_points(p, at, n);
        printf("/>\n");
        break;
    case LIVE_ITEM_LINE: case LIVE_ITEM_DASHES: case LIVE_ITEM_ARROW:
        printf("<polyline fill='none' stroke='%s' %s", c, item[0] == LIVE_ITEM_DASHES ? "stroke-dasharray='4 5' " : "");
        print_points(p, at, n);
        printf("/>\n");
        break;
    case LIVE_ITEM_LABEL:
        printf("<text x='%.1f' y='%.1f' fill='%s'>%s</text>\n", x, y, c, page->letter + (int)number);
        break;
    case LIVE_ITEM_PANE:
        break;
    default: {
        double r = item[0] == LIVE_ITEM_HANDLE ? 8 : item[0] == LIVE_ITEM_DOT ? number : p->scale * number;
        printf("<circle cx='%.1f' cy='%.1f' r='%.1f' stroke='%s' fill='%s' fill-opacity='%s'/>\n", x, y, r, c, c, item[0] == LIVE_ITEM_DOT ? "1" : ".14");
    }
    }
}

static void print_flat(const live_page *page)
{
    pane p = pane_of(0);
    for (const float *item = page->flat.at; item < page->flat.at + page->flat.count; item += 4 + 2 * (int)item[3]) {
        if (item[0] == LIVE_ITEM_PANE) p = pane_of((int)item[2]);
        print_item(page, &p, item);
    }
}

// --- Drawings in space: what is far is painted first ------------------------------
typedef struct {
    double depth, at[3][2], wide;   // m; points; of a ball or a tube
    int    corners;                 // 1: a ball, 2: a tube, 3: a triangle
    unsigned colour[3];
} shard;

static shard *shards;
static int count, room;
static vec3 eye, right, up, ahead;
static double focal;                // points

static void stand(void)
{
    const live_camera_plan *c = &figure.camera;
    vec3 out = { sin(c->turn) * cos(c->rise), sin(c->rise), cos(c->turn) * cos(c->rise) };
    eye = vec3_add_scaled(c->target, c->distance, out);
    ahead = vec3_scale(-1, out);
    right = vec3_unit(vec3_cross(ahead, vec3_make(0, 1, 0)));
    up = vec3_cross(right, ahead);
    focal = HIGH / (2 * tan(17 * 3.14159265 / 180));    // the page sees 34 degrees
}

static shard *new_shard(int corners, const float *tint, double light)
{
    if (count == room) {
        room = 2 * room + 1000;
        shards = realloc(shards, (size_t)room * sizeof *shards);
        if (!shards) abort();
    }
    shard *s = &shards[count++];
    *s = (shard){ .corners = corners };
    for (int k = 0; k < 3; k++) s->colour[k] = (unsigned)real_min(255, light * (double)tint[k]);
    return s;
}

static vec3 place(const float *at)
{
    return vec3_make((real)at[0], (real)at[1], (real)at[2]);
}

// Returns how many points a metre is there.
static double see(shard *s, int k, vec3 x)
{
    vec3 d = vec3_sub(x, eye);
    double depth = real_max(0.01, vec3_dot(d, ahead));
    s->at[k][0] = WIDE / 2.0 + focal * vec3_dot(d, right) / depth;
    s->at[k][1] = HIGH / 2.0 - focal * vec3_dot(d, up) / depth;
    s->depth += depth / s->corners;
    return focal / depth;
}

static void see_triangles(const live_page *page)
{
    const vec3 sun = vec3_unit(vec3_make(0.5, 1, 0.42));
    for (int k = 0; k < page->corners; k += 3) {
        vec3 x[3];
        for (int i = 0; i < 3; i++) x[i] = place(page->place.at + 3 * page->corner[k + i]);
        vec3 n = vec3_unit(vec3_cross(vec3_sub(x[1], x[0]), vec3_sub(x[2], x[0])));
        if (vec3_dot(n, vec3_sub(eye, x[0])) < 0) n = vec3_scale(-1, n);
        shard *s = new_shard(3, page->tint.at + 3 * page->corner[k], 0.72 + 0.38 * vec3_dot(n, sun));
        for (int i = 0; i < 3; i++) see(s, i, x[i]);
    }
}

static void see_thin(const live_page *page)
{
    for (const float *b = page->ball.at; b < page->ball.at + page->ball.count; b += 8) {
        shard *s = new_shard(1, b + 4, 0.95);
        s->wide = 2 * (double)b[3] * see(s, 0, place(b));
    }
    for (const float *t = page->tube.at; t < page->tube.at + page->tube.count; t += 11) {
        shard *s = new_shard(2, t + 7, 0.9);
        see(s, 0, place(t));
        s->wide = 2 * (double)t[6] * see(s, 1, place(t + 3));
    }
    for (int k = 0; k < page->edge.count; k += 6) {
        shard *s = new_shard(2, page->edge_tint.at + k, 0.9);
        for (int i = 0; i < 2; i++) see(s, i, place(page->edge.at + k + 3 * i));
        s->wide = 1;
    }
}

static int farther_first(const void *a, const void *b)
{
    double d = ((const shard *)b)->depth - ((const shard *)a)->depth;
    return d > 0 ? 1 : d < 0 ? -1 : 0;
}

static void print_space(const live_page *page)
{
    count = 0;
    stand();
    see_triangles(page);
    see_thin(page);
    qsort(shards, (size_t)count, sizeof *shards, farther_first);
    printf("<g fill='currentColor' stroke='currentColor' stroke-width='.4'>\n");
    for (const shard *s = shards; s < shards + count; s++) {
        printf("<path d='M");
        for (int k = 0; k < s->corners; k++) printf("%.1f,%.1f ", s->at[k][0], s->at[k][1]);
        printf(s->corners == 3 ? "'" : "h0' stroke-width='%.1f'", s->wide);
        printf(" color='#%02x%02x%02x'/>\n", s->colour[0], s->colour[1], s->colour[2]);
    }
    printf("</g>\n");
}

// --- The film ---------------------------------------------------------------------
static void print_picture(int k)
{
    const live_page *page = page_draw();
    printf("<g class='picture' style='animation-delay:%.4fs'>\n", k * SECONDS / PICTURES);
    if (figure.camera.distance > 0) print_space(page);
    else                            print_flat(page);
    printf("</g>\n");
}

void live_film(void)
{
    for (int c = 0; c < LIVE_COLOURS; c++) page_paint(c, SOLID[c][0], SOLID[c][1], SOLID[c][2]);
    page_start();
    printf("<svg viewBox='0 0 %d %d' stroke-width='2' stroke-linecap='round' stroke-linejoin='round' font-family='sans-serif' font-size='13' style='background:#f4f2ec'>\n"
           "<style>.picture { visibility: hidden; animation: film %.4fs step-end infinite } text { stroke: none }\n"
           "@keyframes film { 0%% { visibility: visible } %.4f%% { visibility: hidden } }</style>\n", WIDE, HIGH, SECONDS, 100.0 / PICTURES);
    for (int k = 0; k < PICTURES; k++) {
        print_picture(k);
        for (int i = 0; i < EVERY; i++) page_step();
    }
    printf("</svg>\n");
    free(shards);
    shards = NULL;
    room = 0;
}
