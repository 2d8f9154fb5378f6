// painter.h - paints meshes, ropes and a floor into a picture.
//
// A z-buffer, and light.  A painting is the mean of nine plain pictures, each
// taken with the eye's grid shifted by a third of a point (3 x 3
// supersampling), and each lit by other lamps: points of one round lamp, and
// points of the sky.  For every lamp the scene is drawn once more, as the lamp
// sees it, and what the lamp does not see lies in its shadow.  The mean of
// nine times a few hard shadows is one soft shadow, on the floor as on the
// bodies.
//
// Units: metres.  y is up.  A front face runs counter-clockwise seen from
// outside.  Colours are linear (picture.h).

#ifndef TUMBLE_PAINTER_H
#define TUMBLE_PAINTER_H

#include "picture.h"

// A mesh to be painted; nothing of it is kept but copies.
typedef struct {
    int         vertices;
    const vec3 *at;             // [vertices] m
    int         faces;
    const int  *face;           // [faces * 3]
    colour front[2], back[2];   // skin of the two sides ...
    const real *tint;           // [faces] ... mixed from [0] to [1]; NULL: [0]
    int  smooth;                // 1: normals are interpolated; 0: flat faces
    int  creases;               // 1: edges where the faces bend are lightened
    int  see_through;           // 1: only front faces are drawn (a room's wall)
    int  casts;                 // 1: throws shadows
    real gloss;                 // strength of the lamp's reflection, 0 to 1
} painted_mesh;

// One triangle, ready for the canvas.
typedef struct {
    vec3   corner[3], normal[3];
    colour front, back;
    real   gloss, crease[3];    // m, width of the light rim at the edge
                                // opposite each corner; 0: none
    int    lit, casts, see_through;
} painted_triangle;

typedef struct {
    // The camera.
    vec3 eye, right, up, forward;
    real focal;                 // picture heights from the eye to the picture
    // What is painted.
    painted_triangle *triangle;
    int count, capacity;
    // The floor: a disc of tiles that fades into the haze.
    int    has_floor;
    vec3   floor_centre;        // m
    real   floor_radius;        // m, where it is all haze
    real   tile;                // m
    colour floor, haze, sky, wall;
    // The light.
    vec3 lamp;                  // unit, towards the lamp
    real lamp_size;             // its radius over its distance
    int  lamps;                 // of the lamp and of the sky, for each of the
                                // nine pictures: 4 quick, 12 fine
} painter;

// A studio without a floor, pale or (picture_is_dark) dark; 6 lamps.
void painter_init(painter *p);
void painter_free(painter *p);

// Forgets what was added; keeps camera, floor and light.
void painter_clear(painter *p);

// Stands at eye and looks at target; degrees is the angle of view from the
// lower to the upper edge.  Requires: eye != target, not straight up or down.
void painter_look(painter *p, vec3 eye, vec3 target, real degrees);

// A floor of tiles at this height, faded out at radius.
void painter_floor(painter *p, vec3 centre, real radius, real tile);

// Each adds triangles; fails only for want of memory.
status painter_mesh(painter *p, const painted_mesh *m);

// A line `width` picture heights wide, whatever its distance; unlit.  Requires:
// the camera stands.
status painter_line(painter *p, vec3 a, vec3 b, real width, colour c);

// A tube through n points, smoothly bent, with two strands twisted around it.
status painter_rope(painter *p, const vec3 *at, int n, real radius,
                    colour light, colour dark);

status painter_ball(painter *p, vec3 centre, real radius, colour c);

// Paints all of it into that box of the picture.  What stands behind the eye,
// or at places that are not finite, is left out.  Fails only for want of
// memory; the box is then as it was.
status painter_paint(const painter *p, picture *out,
                     int left, int top, int width, int height);

#endif
