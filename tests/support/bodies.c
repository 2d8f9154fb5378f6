// bodies.c - see bodies.h.

#include "bodies.h"
#include "random.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

hull body_hull(const body *b)
{
    return (hull){ b->at, b->count };
}

void body_box(body *b, vec3 low, vec3 high)
{
    b->count = 8;
    b->has_ring = 0;
    for (int i = 0; i < 8; i++)
        b->at[i] = (vec3){ i & 1 ? high.x : low.x, i & 2 ? high.y : low.y,
                           i & 4 ? high.z : low.z };
}

void body_icosahedron(body *b, real radius)
{
    const real golden = (1 + sqrt(5.0)) / 2;
    b->count = 0;
    b->has_ring = 0;
    for (int s = -1; s < 2; s += 2)
        for (int t = -1; t < 2; t += 2) {
            vec3 v = { 0, s, t * golden };
            real k = radius / vec3_length(v);
            b->at[b->count++] = vec3_scale(k, v);
            b->at[b->count++] = vec3_scale(k, (vec3){ v.y, v.z, v.x });
            b->at[b->count++] = vec3_scale(k, (vec3){ v.z, v.x, v.y });
        }
}

static void ring_add(int list[6], int *count, int vertex)
{
    for (int k = 0; k < *count; k++)
        if (list[k] == vertex) return;
    list[(*count)++] = vertex;
}

// Points nearer than the limit are neighbours: on an icosphere the edges are of
// nearly one length, and diagonals much longer.
static void ring_by_distance(body *b, real limit)
{
    int filled = 0;
    b->has_ring = 1;
    for (int i = 0; i < b->count; i++) {
        int list[6], found = 0;
        b->ring_start[i] = filled;
        for (int j = 0; j < b->count; j++)
            if (j != i && found < 6
                && vec3_distance(b->at[i], b->at[j]) < limit)
                ring_add(list, &found, j);
        for (int k = 0; k < found; k++) b->ring[filled++] = list[k];
    }
    b->ring_start[b->count] = filled;
}

void body_icosphere(body *b, int level, real radius)
{
    // Halve the edges of the coarser ball; its neighbours are those nearer than
    // 1.4 of the shortest edge that its level has.
    static const real edge[4] = { 1.06, 0.63, 0.33, 0.166 };
    body_icosahedron(b, 1);
    for (int l = 0; l < level; l++) {
        int old = b->count;
        for (int i = 0; i < old; i++)
            for (int j = i + 1; j < old; j++)
                if (vec3_distance(b->at[i], b->at[j]) < edge[l])
                    b->at[b->count++] = vec3_unit(vec3_add(b->at[i], b->at[j]));
    }
    ring_by_distance(b, edge[level]);
    body_scale(b, radius);
}

void body_random(body *b, int count, unsigned long long *state)
{
    b->count = count;
    b->has_ring = 0;
    for (int i = 0; i < count; i++) b->at[i] = random_vector(state, 0.3, 1);
}

void body_square(body *b)
{
    b->count = 4;
    b->has_ring = 0;
    for (int i = 0; i < 4; i++)
        b->at[i] = (vec3){ i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, 0 };
}

void body_turn(body *b, unsigned long long *state)
{
    vec3 u = random_direction(state), across = random_direction(state);
    vec3 v = vec3_unit(vec3_cross(u, across)), w = vec3_cross(u, v);
    for (int i = 0; i < b->count; i++) {
        vec3 p = b->at[i];
        b->at[i] = (vec3){ vec3_dot(u, p), vec3_dot(v, p), vec3_dot(w, p) };
    }
}

body body_cube(real x, real y, real z)
{
    body b;
    body_box(&b, (vec3){ -0.5, -0.5, -0.5 }, (vec3){ 0.5, 0.5, 0.5 });
    body_move(&b, (vec3){ x, y, z });
    return b;
}

void body_any(body *b, int kind, unsigned long long *state)
{
    switch (kind) {
    case 0: *b = body_cube(0, 0, 0); break;
    case 1: body_icosahedron(b, 0.6); break;
    case 2: body_random(b, 4 + (int)(5 * random_fraction(state)), state); break;
    case 3: body_square(b); break;
    default: body_random(b, 1 + (int)(3 * random_fraction(state)),
                         state); break;
    }
    body_turn(b, state);
}

void body_move(body *b, vec3 by)
{
    for (int i = 0; i < b->count; i++) b->at[i] = vec3_add(b->at[i], by);
}

void body_scale(body *b, real by)
{
    for (int i = 0; i < b->count; i++) b->at[i] = vec3_scale(by, b->at[i]);
}

static int body_read(FILE *file, body *b)
{
    b->has_ring = 0;
    if (fscanf(file, "%d", &b->count) != 1) return -1;
    if (b->count < 1 || b->count > BODY_POINTS) return -1;
    for (int i = 0; i < b->count; i++)
        if (fscanf(file, "%lf %lf %lf", &b->at[i].x, &b->at[i].y,
                   &b->at[i].z) != 3)
            return -1;
    return 1;
}

int pair_read(void *stream, pair_known *p)
{
    FILE *file = stream;
    char word[40];
    while (fscanf(file, "%39s", word) == 1) {
        // A comment goes to the end of its line.
        if (word[0] == '#') {
            int c;
            while ((c = fgetc(file)) != EOF && c != '\n') continue;
            continue;
        }
        if (strcmp(word, "pair") != 0) return -1;
        if (fscanf(file, "%39s %c %lf %3s %d %lf", p->family, &p->kind,
                   &p->value, p->feature, &p->unique, &p->gap) != 6)
            return -1;
        return body_read(file, &p->a) == 1 && body_read(file, &p->b) == 1
             ? 1 : -1;
    }
    return 0;
}

void pair_any(body *a, body *b, int n, int kinds, real least, real most,
              unsigned long long *state)
{
    body_any(a, n % kinds, state);
    body_any(b, n / kinds % kinds, state);
    body_move(b, random_vector(state, least, most));
}

void pair_move(body *a, body *b, vec3 by)
{
    body_move(a, by);
    body_move(b, by);
}

void pair_scale(body *a, body *b, real by)
{
    body_scale(a, by);
    body_scale(b, by);
}

void pair_turn(body *a, body *b, unsigned long long *state)
{
    unsigned long long same = *state;
    body_turn(a, &same);
    body_turn(b, state);
}

static real body_size(const body *b)
{
    real most = 0;
    for (int i = 0; i < b->count; i++)
        most = real_max(most, vec3_distance(b->at[i], b->at[0]));
    return most;
}

real pair_size(const body *a, const body *b)
{
    return real_max(body_size(a), body_size(b));
}

int bits_are_ours(void)
{
    const char *yours = getenv("YOURS");
    return !yours || !*yours;
}

enum { SIDE = 8, TOP = SIDE * SIDE, FACES = 2 * (SIDE - 1) * (SIDE + 1) };

// A dome is what a projection from below makes of a paraboloid on straight walls,
// so its sides are convex, too.
void body_table(body *b, int foot, real rough, unsigned long long *state)
{
    *b = (body){ .count = TOP + 1 };
    for (int k = 0; k < TOP; k++) {
        vec3 x = { k % SIDE - 3.5, k / SIDE - 3.5, 5 };
        real part = 1 / (1 + 0.02 * (x.x * x.x + x.y * x.y));
        b->at[k] = rough < 0 ? vec3_scale(part, x) : x;
        b->at[k].z += real_max(rough, 0) * random_fraction(state) - 5;
    }
    b->at[TOP] = b->at[foot];
    b->at[foot] = vec3_make(0, 0, -5);
}

static int (*add_face(int (*face)[3], int i, int j, int k))[3]
{
    (*face)[0] = i, (*face)[1] = j, (*face)[2] = k;
    return face + 1;
}

status table_mesh(struct mesh *m, int foot)
{
    int face[FACES][3], (*f)[3] = face, end = SIDE - 1;
    for (int i = 0; i < end; i++)
        for (int j = 0; j < end; j++) {
            int k = i + j * SIDE;
            f = add_face(f, k, k + 1, k + 1 + SIDE);
            f = add_face(f, k, k + 1 + SIDE, k + SIDE);
        }
    for (int i = 0; i < end; i++) {
        f = add_face(f, i + 1, i, TOP);
        f = add_face(f, end * SIDE + i, end * SIDE + i + 1, TOP);
        f = add_face(f, end + (i + 1) * SIDE, end + i * SIDE, TOP);
        f = add_face(f, i * SIDE, (i + 1) * SIDE, TOP);
    }
    for (int k = 0; k < 3 * FACES; k++) {
        int *v = &face[k / 3][k % 3];
        *v = *v == TOP ? foot : *v == foot ? TOP : *v;
    }
    return mesh_build(m, TOP + 1, (const int (*)[3])face, FACES);
}
