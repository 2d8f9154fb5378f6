// live.h - what a live figure is: a program that begins, steps and draws, with
// dials to turn and charts that move.
//
// A figure is one file, figures/live/NAME.c, which defines `figure`.  Compiled
// for this machine it prints the hash of its frame 60; compiled to WebAssembly
// the page runs it, and compares.  README.md says how to add one.

#ifndef TUMBLE_LIVE_H
#define TUMBLE_LIVE_H

#include "vec3.h"

#include <stdbool.h>
#include <stddef.h>

enum { LIVE_PANES = 3, LIVE_DIALS = 6, LIVE_BUTTONS = 4, LIVE_CHARTS = 3,
       LIVE_LINES = 4, LIVE_CURVE = 256, LIVE_FRAMES = 60 };

typedef enum {
    LIVE_INK, LIVE_QUIET, LIVE_RULE, LIVE_BLUE, LIVE_ORANGE, LIVE_GREEN,
    LIVE_PURPLE, LIVE_RED, LIVE_GREY, LIVE_COLOURS
} live_colour;

// A slider; or, if there are choices ("Euler|Verlet"), buttons of which one is
// pressed, and the value is its number: 0, 1 ...
typedef struct {
    const char *name, *unit;    // unit may be NULL
    double least, most, step, value;
    const char *choices;
    bool begins;                // to turn it begins the figure again
} live_dial_plan;

// Lines over the last frames; or, if `over` says over what ("link"), curves.
typedef struct {
    const char *name, *unit;
    const char *line[LIVE_LINES];   // their names; one line needs none
    double least, most;         // the axis shows at least these
    bool logarithmic;
    bool is_time;               // the page writes how many ms a frame took
    const char *over;
} live_chart_plan;

// A flat drawing: panes side by side, each this box in the figure's own units.
typedef struct {
    double left, bottom, width, height;
} live_pane_plan;

// A drawing in space: y is up, and the camera goes round a point.
typedef struct {
    double distance;            // 0: the figure is flat
    double turn, rise;          // rad, from +z towards +x; above the horizon
    vec3   target;
    bool   has_floor;           // for shadows
    double floor;               // m, its height
} live_camera_plan;

// Lists end at the first entry without a name (panes: without a width).
// Functions that a figure does not need are NULL.
typedef struct {
    const char *name;           // of the file
    const char *says;           // the drawing in a sentence, for a screen reader
    const char *code;           // "lib/paper/gjk.c furthest": a file, and those of
                                // its functions that are shown, with a line lit
    unsigned fickle;            // bits: choices of the first dial that ask the C
                                // library for sines, whose last digits differ
    live_pane_plan   pane[LIVE_PANES];
    live_camera_plan camera;
    live_dial_plan   dial[LIVE_DIALS];
    const char      *button[LIVE_BUTTONS];
    live_chart_plan  chart[LIVE_CHARTS];
    void (*begin)(void);        // from the dials, at any time
    void (*step)(void);         // one frame, 1/60 s
    void (*measure)(void);      // after it, and not timed: errors, for charts
    void (*draw)(void);         // all of it, after any number of steps
    unsigned long long (*hash)(void);   // of the state
    void (*turn)(int dial);     // a dial has another value
    void (*press)(int button);
    void (*move)(int number, vec3 to);  // a thing is dragged there (NULL: live_pull)
    void (*release)(int number);        // ... and let go
    void (*tap)(int number, vec3 along);// touched; along: unit, from the eye
    void (*ground)(vec3 at);    // ... the floor there
} live_figure;

extern const live_figure figure;

// What a dial stands at.
double live_dial(int k);
int    live_choice(int k);

// --- What begin(), step() and measure() may call --------------------------------
// The next value of a line of a chart over frames.
void live_value(int chart, int line, real value);
// A whole curve, of at most LIVE_CURVE values.
void live_curve(int chart, int line, const real *value, int n);
// The sentence below the drawing, as printf would write it.
void live_say(const char *format, ...) __attribute__((format(printf, 1, 2)));

// The first line of the shown code that holds these words is lit from now on.
void live_light(const char *words);

// The hand that drags: a figure without move() of its own asks for it in step().
// The number of what it holds; -1: nothing.
int  live_held(void);
// Where it is, or, in tap(), what it touched.
vec3 live_touched(void);
// m/s², how it pulls what it holds, which is at that place with that velocity: a
// damped spring.
vec3 live_pull(vec3 at, vec3 velocity);

// --- What draw() may call -------------------------------------------------------
// In a flat drawing z is not looked at.
void live_pane(int k);          // what follows belongs there; at first: 0
void live_line(live_colour c, const vec3 *at, int n);
void live_dashes(live_colour c, const vec3 *at, int n);
void live_area(live_colour c, const vec3 *at, int n);   // filled, lightly
void live_band(live_colour c, const vec3 *at, int n);   // ... without an outline
void live_dot(live_colour c, vec3 at, double radius);   // px
void live_circle(live_colour c, vec3 middle, double radius);    // m; filled, lightly
void live_arrow(live_colour c, vec3 from, vec3 to);
void live_label(live_colour c, vec3 at, const char *text);
// A dot that can be dragged, by mouse, finger or arrow keys.
void live_handle(int number, live_colour c, vec3 at, const char *name);

// In space.  number: what move, release and tap are told; -1: not to be touched.
void live_mesh(int number, live_colour c, const vec3 *at, int n,
               const int *face, int faces, bool smooth);
// A cloth, row by row, by the faces of its shape: woven, and with a hem.
void live_cloth(int number, live_colour c, const vec3 *at, int n,
                const int *face, int faces);
// A rope through n places, of two strands.
void live_rope(int number, live_colour c, const vec3 *at, int n, real radius);
// A flat mesh whose upper sides are tiled, a square to `side` metres.
void live_ground(live_colour c, const vec3 *at, const int *face, int faces, real side);
void live_ball(int number, live_colour c, vec3 at, real radius);
void live_tube(int number, live_colour c, vec3 a, vec3 b, real radius);
void live_edge(live_colour c, vec3 a, vec3 b);          // a thin line

// --- Hashes ---------------------------------------------------------------------
// FNV-1a of some bytes, carried on from h.
#define LIVE_HASH 0xcbf29ce484222325ULL
unsigned long long live_hash(unsigned long long h, const void *bytes, size_t n);

#endif
