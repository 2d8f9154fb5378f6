// 03-half.c - half-edges drawn: two triangles that share an edge, each edge cut
// lengthwise; and the signed area of a shape that bends in, from one point.
//
//   index 0: edges x1 y1 x2 y2
//   index 1: half-edges of the two faces, each drawn a little inside its face:
//            x y dx dy number
//   index 2: vertices x y number
//   index 3: outline of a shape that bends in x y, and the point o first
//   index 4: triangles from o: x y, three corners and the first again; sign in
//            the third column; blank lines between
#include "mesh.h"

#include <stdio.h>

// Towards the middle of the face, and shorter at both ends.
static void print_half(const mesh *m, const vec3 *at, int h)
{
    int v[3];
    mesh_face(m, m->half[h].face, v);
    vec3 middle = vec3_scale(1.0 / 3, vec3_add(at[v[0]],
                                               vec3_add(at[v[1]], at[v[2]])));
    vec3 a = at[m->half[h].origin], b = at[mesh_target(m, h)];
    a = vec3_add_scaled(a, 0.17, vec3_sub(middle, a));
    b = vec3_add_scaled(b, 0.17, vec3_sub(middle, b));
    vec3 along = vec3_sub(b, a);
    a = vec3_add_scaled(a, 0.06, along);
    printf("%.4f %.4f %.4f %.4f %d\n", a.x, a.y, 0.88 * along.x,
           0.88 * along.y, h);
}

static void print_mesh(const mesh *m, const vec3 *at)
{
    printf("# edges x1 y1 x2 y2\n");
    for (int e = 0; e < m->edges; e++) {
        vec3 a = at[m->half[2 * e].origin], b = at[m->half[2 * e + 1].origin];
        printf("%g %g %g %g\n", a.x, a.y, b.x, b.y);
    }
    printf("\n\n# half-edges x y dx dy number\n");
    for (int h = 0; h < 2 * m->edges; h++)
        if (m->half[h].face >= 0) print_half(m, at, h);
    printf("\n\n# vertices x y number\n");
    for (int v = 0; v < m->vertices; v++)
        printf("%g %g %d\n", at[v].x, at[v].y, v);
}

// A polygon in the plane takes the place of a body, and areas that of volumes.
static void print_areas(void)
{
    static const vec3 at[5] = { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 2.6, 0 },
                                { 1.6, 0.9, 0 }, { 0.2, 2.6, 0 } };
    real area = 0;
    printf("\n\n# outline x y\n");
    for (int k = 0; k <= 5; k++) printf("%g %g\n", at[k % 5].x, at[k % 5].y);
    printf("\n\n# triangles x y sign, from the first vertex\n");
    for (int k = 1; k < 4; k++) {
        real twice = vec3_cross(at[k], at[k + 1]).z;
        int sign = twice > 0 ? 1 : -1;
        area += twice / 2;
        printf("0 0 %d\n%g %g %d\n%g %g %d\n0 0 %d\n\n", sign, at[k].x, at[k].y,
               sign, at[k + 1].x, at[k + 1].y, sign, sign);
    }
    printf("# area %g\n", area);
}

int main(void)
{
    static const vec3 at[4] =
        { { 0, 0, 0 }, { 3, 0, 0 }, { 3.3, 2.6, 0 }, { 0.5, 2.5, 0 } };
    static const int triangle[2][3] = { { 0, 1, 2 }, { 0, 2, 3 } };
    mesh m;
    if (!mesh_build(&m, 4, triangle, 2).ok) return 1;
    print_mesh(&m, at);
    print_areas();
    mesh_free(&m);
    return 0;
}
