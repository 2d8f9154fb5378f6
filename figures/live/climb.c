// climb.c - which corner of a stone lies furthest along d?  Uphill along its edges,
// with the line of hull_climb() lit (chapter 5).

#include "climb.h"
#include "live.h"
#include "plane.h"

enum { START };                                 // dial
enum { LOWEST, WHERE_IT_WAS };
enum { RINGS = 9, AROUND = 14, CORNERS = RINGS * AROUND + 2, FACES = 2 * RINGS * AROUND };
enum { PACE = 3, REST = 90, TIP = CORNERS };    // frames a line, at the end; what is dragged
typedef enum { COME, ASK, KEEP, DONE } moment;

static vec3 at[CORNERS];
static int face[FACES][3];
static mesh net;
static bool is_ready, is_led;                   // led: d is the reader's
static vec3 tip;
static int v, best, half, start, asked, gone, frame, turns;
static int path[CORNERS];
static real most;
static moment now;

static real height(int k) { return vec3_dot(tip, at[k]); }

// A stone: rings about the vertical, and a corner at either end.
static void place(void)
{
    for (int r = 0; r < RINGS; r++)
        for (int k = 0; k < AROUND; k++) {
            vec3 up = plane_turned(vec3_make(0, -1, 0), plane_tangent(180.0 * (r + 1) / (RINGS + 1) - 90));
            vec3 flat = plane_turned(vec3_make(1, 0, 0), plane_tangent(360.0 * k / AROUND / 3));
            flat = plane_turned(flat, plane_tangent(240.0 * k / AROUND / 2));
            flat = plane_turned(flat, plane_tangent(240.0 * k / AROUND / 2));
            // up is a turn from straight down to straight up, in the plane of x and y.
            at[r * AROUND + k] = vec3_make(1.25 * up.y * flat.x, 0.9 * up.x, up.y * flat.y);
        }
    at[CORNERS - 2] = vec3_make(0, -0.9, 0);
    at[CORNERS - 1] = vec3_make(0, 0.9, 0);
}
