// validate.h - is every link of a mesh what the half-edge rules say?

#ifndef TUMBLE_TESTS_VALIDATE_H
#define TUMBLE_TESTS_VALIDATE_H

#include "mesh.h"

#include <assert.h>
#include <limits.h>
#include <stdlib.h>

// The vertex that h reaches, read from the array: only what is written there is
// on trial.
static inline int end_of(const mesh *m, int h)
{
    return m->half[mesh_twin(h)].origin;
}

// The rules for one half-edge alone.  Indices come first, because the other
// rules follow them.
static inline status validate_half(const mesh *m, int h)
{
    half_edge e = m->half[h];
    if (e.origin < 0 || e.origin >= m->vertices)
        return status_fail("half-edge %d leaves vertex %d, which does not "
                           "exist", h, e.origin);
    if (e.next < 0 || e.next >= 2 * m->edges)
        return status_fail("half-edge %d is followed by half-edge %d, which "
                           "does not exist", h, e.next);
    if (e.face < -1 || e.face >= m->faces)
        return status_fail("half-edge %d borders face %d, which does not "
                           "exist", h, e.face);
    if (e.face < 0 && m->half[mesh_twin(h)].face < 0)
        return status_fail("edge %d has no face on either side", h / 2);
    if (e.origin == end_of(m, h))
        return status_fail("edge %d begins and ends in vertex %d", h / 2,
                           e.origin);
    return status_ok();
}

// What comes next leaves where h ends, along the same face; and around a face
// three steps lead back.
static inline status validate_next(const mesh *m, int h)
{
    int face = m->half[h].face, second = m->half[h].next;
    if (m->half[second].origin != end_of(m, h))
        return status_fail("half-edge %d is followed by half-edge %d, which "
                           "does not leave where it ends", h, second);
    if (m->half[second].face != face)
        return status_fail("half-edge %d borders face %d, but half-edge %d "
                           "after it borders face %d", h, face, second,
                           m->half[second].face);
    if (face >= 0 && m->half[m->half[second].next].next != h)
        return status_fail("half-edge %d is not back at itself after three "
                           "steps around face %d", h, face);
    return status_ok();
}

// Every face has a half-edge, so it has three.  If some face has six, then all
// of them together are too many.
static inline status validate_faces(const mesh *m)
{
    long long bordered = 0;
    for (int h = 0; h < 2 * m->edges; h++) bordered += m->half[h].face >= 0;
    for (int f = 0; f < m->faces; f++) {
        int h = m->face_half[f];
        if (h < 0 || h >= 2 * m->edges || m->half[h].face != f)
            return status_fail("face %d begins with half-edge %d, which does "
                               "not border it", f, h);
    }
    if (bordered != 3LL * m->faces)
        return status_fail("%lld half-edges border the %d faces: three times "
                           "as many as faces it must be", bordered, m->faces);
    return status_ok();
}

// One turn around v meets every half-edge that leaves it, and only the first
// may run along a rim.
static inline status validate_vertex(const mesh *m, int v, int leaving)
{
    int start = m->vertex_half[v], h = start;
    if (start == -1 && leaving == 0) return status_ok();
    if (start < 0 || start >= 2 * m->edges || m->half[start].origin != v)
        return status_fail("vertex %d begins with half-edge %d, which does not "
                           "leave it", v, start);
    for (int met = 1; met < leaving; met++) {
        h = mesh_around(m, h);
        if (h == start)
            return status_fail("%d half-edges leave vertex %d, but a turn "
                               "around it does not meet each of them once",
                               leaving, v);
        if (m->half[h].face < 0)
            return status_fail("vertex %d begins with half-edge %d, but "
                               "half-edge %d runs along a rim", v, start, h);
    }
    return status_ok();
}

static inline status validate_vertices(const mesh *m)
{
    int *leaving = calloc((size_t)m->vertices + 1, sizeof *leaving);
    if (!leaving) return status_out_of_memory();
    status s = status_ok();
    for (int h = 0; h < 2 * m->edges; h++) leaving[m->half[h].origin]++;
    for (int v = 0; v < m->vertices && s.ok; v++)
        s = validate_vertex(m, v, leaving[v]);
    free(leaving);
    return s;
}

// Is every link of the mesh what the half-edge rules say?  If not, the sentence
// names the element and the rule that it breaks.  Any contents of the arrays
// are safe to ask about, as long as they are as long as the counts say.
static inline status mesh_validate(const mesh *m)
{
    assert(m);
    status s = status_ok();
    if (m->vertices < 0 || m->edges < 0 || m->faces < 0
        || m->edges > INT_MAX / 2)
        return status_fail("the mesh counts %d vertices, %d edges and %d faces",
                           m->vertices, m->edges, m->faces);
    if ((m->edges > 0 && !m->half) || (m->vertices > 0 && !m->vertex_half)
        || (m->faces > 0 && !m->face_half))
        return status_fail("the mesh counts elements that it does not hold");
    for (int h = 0; h < 2 * m->edges && s.ok; h++) s = validate_half(m, h);
    for (int h = 0; h < 2 * m->edges && s.ok; h++) s = validate_next(m, h);
    if (s.ok) s = validate_faces(m);
    return s.ok ? validate_vertices(m) : s;
}

#endif
