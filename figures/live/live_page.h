// live_page.h - what the page calls, and the lists that it reads.

#ifndef TUMBLE_LIVE_PAGE_H
#define TUMBLE_LIVE_PAGE_H

#include "live.h"

#ifdef __wasm__
#define PAGE(name) __attribute__((export_name(#name)))
#else
#define PAGE(name)
#endif

typedef enum {
    LIVE_ITEM_PANE, LIVE_ITEM_LINE, LIVE_ITEM_DASHES, LIVE_ITEM_AREA,
    LIVE_ITEM_DOT, LIVE_ITEM_ARROW, LIVE_ITEM_LABEL, LIVE_ITEM_HANDLE,
    LIVE_ITEM_CIRCLE
} live_item;

typedef struct {
    float *at;
    int    count, room;
} live_list;

// What covers a surface: nothing, the squares of a woven cloth, tiles.
typedef enum { LIVE_PLAIN, LIVE_WOVEN, LIVE_TILED } live_weave;

// core.js reads this as numbers of four bytes, in this order.
typedef struct {
    live_list flat;             // items of the panes (live.c: item)
    live_list place, normal, tint;  // x y z of each vertex of the meshes
    live_list weave;            // across, along, live_weave of each
    live_list ball, tube;       // 8 and 11 numbers each
    live_list edge, edge_tint;  // x y z of each end of the thin lines
    int  *corner, corners, corner_room; // of triangles: which vertices
    char *letter;
    int   letters, letter_room;
    int  *owner, owner_room;    // of each triangle: its number
    int   points[LIVE_CHARTS][LIVE_LINES];
    char  said[200];
    char  lit[80];              // words of the line that is lit
    double hit;                 // how far along the ray what was picked lies
    double value[LIVE_CHARTS][LIVE_LINES];
    double curve[LIVE_CHARTS][LIVE_LINES][LIVE_CURVE];
} live_page;

PAGE(start)   void page_start(void);            // dials as planned, then begin
PAGE(begin)   void page_begin(void);
PAGE(step)    void page_step(void);
PAGE(measure) void page_measure(void);
PAGE(draw)    const live_page *page_draw(void);
PAGE(hash)    unsigned long long page_hash(void);
PAGE(turn)    int  page_turn(int dial, double value);   // 1: it began again
PAGE(press)   void page_press(int button);
PAGE(move)    void page_move(int number, double x, double y, double z);
PAGE(release) void page_release(int number);
PAGE(tap)     void page_tap(int number, double x, double y, double z, double px,
                            double py, double pz);     // along, and where
PAGE(paint)   void page_paint(int colour, double r, double g, double b);
// What does a ray meet first?  Its number, or -1.
PAGE(pick)    int  page_pick(double x, double y, double z,
                             double ax, double ay, double az);

// What meshes are made of.  A vertex: its colour is made darker by shade (1: not),
// and weave says across and along, in squares, and which.  Returns its number.
int  live_vertex(vec3 at, vec3 normal, live_colour c, real shade, vec3 weave);
void live_triangle(int number, int a, int b, int c);
// The mean normal of each vertex, by the area of its faces; to be freed.
vec3 *live_normals(const vec3 *at, int n, const int *face, int faces);

// On this machine: prints the figure's first two seconds as an SVG film.
void live_film(void);

#endif
