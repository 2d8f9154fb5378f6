// meshes.h - meshes to test with, and what their tests expect.

#ifndef TUMBLE_TESTS_MESHES_H
#define TUMBLE_TESTS_MESHES_H

#include "expect.h"
#include "mesh.h"

#include <check.h>
#include <string.h>

static inline void expect_empty_mesh(const mesh *m)
{
    ck_assert(m->vertices == 0 && m->edges == 0 && m->faces == 0);
    ck_assert(!m->half && !m->vertex_half && !m->face_half);
}

// A corner tetrahedron: the origin and one step along each axis; volume 1/6.
static const int TETRAHEDRON[4][3] =
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
static const vec3 TETRAHEDRON_AT[4] =
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };

// Four triangles around vertex 0, not closed: a fan with a gap, and vertex 6
// by itself.
static const int FAN[4][3] =
    { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 5 } };

// A cube of side 1 with its corners at 0 and 1; corner k by its bits.
static const int CUBE[12][3] = {
    { 0, 4, 6 }, { 0, 6, 2 }, { 3, 7, 5 }, { 3, 5, 1 }, { 0, 1, 5 },
    { 0, 5, 4 }, { 3, 2, 6 }, { 3, 6, 7 }, { 0, 2, 3 }, { 0, 3, 1 },
    { 5, 7, 6 }, { 5, 6, 4 }
};

static inline void cube_at(vec3 at[8])
{
    for (int k = 0; k < 8; k++)
        at[k] = vec3_make(k & 1, (k >> 1) & 1, k >> 2);
}

static inline int mesh_is_closed(const mesh *m)
{
    for (int h = 0; h < 2 * m->edges; h++)
        if (m->half[h].face < 0) return 0;
    return 1;
}

static inline mesh build(int vertices, const int (*triangle)[3], int faces)
{
    mesh m;
    expect_ok(mesh_build(&m, vertices, triangle, faces));
    return m;
}

#endif
