// ball.c - an icosahedron, cut finer and finer.

#include "ball.h"
#include "convex.h"

#include <assert.h>

enum { FACES = 20 << 2 * (BALL_LEVELS - 1) };

typedef struct {
    int corners, faces;
    vec3 at[BALL_CORNERS];
    int face[FACES][3];
} globe;

// The corner at the unit vector v: an old one, if there is one.
static int corner(globe *g, vec3 v)
{
    for (int i = 0; i < g->corners; i++)
        if (vec3_distance(g->at[i], v) < 1e-6) return i;
    g->at[g->corners] = v;
    return g->corners++;
}

static void cut(globe *g)
{
    static int old[FACES][3];
    int n = g->faces;
    for (int f = 0; f < n; f++)
        for (int k = 0; k < 3; k++) old[f][k] = g->face[f][k];
    g->faces = 0;
    for (int f = 0; f < n; f++) {
        int middle[3];
        for (int k = 0; k < 3; k++) {
            vec3 a = g->at[old[f][k]], b = g->at[old[f][(k + 1) % 3]];
            middle[k] = corner(g, vec3_unit(vec3_add(a, b)));
        }
        for (int k = 0; k < 3; k++) g->face[g->faces][k] = middle[k];
        g->faces++;
        // The three that keep a corner: before it, the corner, after it.
        for (int k = 0; k < 3; k++, g->faces++) {
            int *t = g->face[g->faces];
            t[0] = middle[(k + 2) % 3];
            t[1] = old[f][k];
            t[2] = middle[k];
        }
    }
}

status ball_shape(shape *s, int level, real radius, real mass)
{
    static globe g;
    assert(level >= 0 && level < BALL_LEVELS);
    status done = shape_icosahedron(s, 1, mass);
    if (!done.ok) return done;
    g.corners = s->particles;
    g.faces = s->mesh.faces;
    for (int i = 0; i < g.corners; i++) g.at[i] = s->at[i];
    for (int f = 0; f < g.faces; f++) mesh_face(&s->mesh, f, g.face[f]);
    shape_free(s);
    for (int k = 0; k < level; k++) cut(&g);
    for (int i = 0; i < g.corners; i++)
        g.at[i] = vec3_scale(radius, g.at[i]);
    return shape_convex(s, g.corners, g.at, g.faces,
                        (const int (*)[3])g.face, mass);
}
