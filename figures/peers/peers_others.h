// peers_others.h - what libccd and ODE answer.  Only peers_ccd.c and
// peers_ode.c need those libraries.

#ifndef TUMBLE_PEERS_OTHERS_H
#define TUMBLE_PEERS_OTHERS_H

#include "scene.h"

// ---- Two icosahedra --------------------------------------------------------

enum { CORNERS = 12 };

// A body, in the world's frame: none has to be transformed.
typedef struct {
    vec3 at[CORNERS];
    vec3 middle;
} solid;

// Do they overlap?
int ccd_gjk_overlap(const solid *a, const solid *b);
int ccd_mpr_overlap(const solid *a, const solid *b);

// How deep (m), and which way (a unit vector from a to b) b has to go.  0: they
// were not found to overlap, or the query failed.
int ccd_gjk_depth(const solid *a, const solid *b, real *depth, vec3 *along);
int ccd_mpr_depth(const solid *a, const solid *b, real *depth, vec3 *along);

// ---- A room ----------------------------------------------------------------

// Icosahedra thrown into a cube of this side (m), which stands on y = 0.
typedef struct {
    int  bodies;
    real side;
    real inertia;       // kg m^2, of each of them about any axis
    const shape *plan;
    placement *start;   // [bodies]
} room;

// ODE's room: there is one at a time.
const char *ode_name(void);
void ode_begin(const room *r);
void ode_step(real dt);
void ode_vertices(int k, vec3 *at);
void ode_end(void);

#endif
