// solution.c - signed tetrahedra, five particles each.

#include "solid.h"

// Until the end, centre holds the sum of m r.
static void add_particle(solid *s, real m, vec3 r)
{
    s->mass += m;
    s->centre = vec3_add_scaled(s->centre, m, r);
    s->xx += m * r.x * r.x;
    s->yy += m * r.y * r.y;
    s->zz += m * r.z * r.z;
    s->yz += m * r.y * r.z;
    s->zx += m * r.z * r.x;
    s->xy += m * r.x * r.y;
}

// The tetrahedron with its tip at the base, 0, and the corners a, b, c.
static void add_tetrahedron(solid *s, real density, vec3 a, vec3 b, vec3 c)
{
    real m = density * vec3_dot(a, vec3_cross(b, c)) / 6;
    vec3 middle = vec3_scale(0.25, vec3_add(a, vec3_add(b, c)));
    add_particle(s, m / 20, (vec3){ 0, 0, 0 });
    add_particle(s, m / 20, a);
    add_particle(s, m / 20, b);
    add_particle(s, m / 20, c);
    add_particle(s, 4 * m / 5, middle);
}

// From the base to the centre: Steiner takes mass times the way, squared.
static solid about_centre(solid s, vec3 base)
{
    if (s.mass == 0) return (solid){ 0 };
    vec3 c = vec3_scale(1 / s.mass, s.centre);
    s.centre = vec3_add(base, c);
    s.xx -= s.mass * c.x * c.x;
    s.yy -= s.mass * c.y * c.y;
    s.zz -= s.mass * c.z * c.z;
    s.yz -= s.mass * c.y * c.z;
    s.zx -= s.mass * c.z * c.x;
    s.xy -= s.mass * c.x * c.y;
    return s;
}

solid solid_measure(const mesh *m, const vec3 *at, real density)
{
    solid s = { 0 };
    if (m->faces == 0) return s;
    vec3 base = at[m->half[m->face_half[0]].origin];
    for (int f = 0; f < m->faces; f++) {
        int v[3];
        mesh_face(m, f, v);
        add_tetrahedron(&s, density, vec3_sub(at[v[0]], base),
                        vec3_sub(at[v[1]], base), vec3_sub(at[v[2]], base));
    }
    return about_centre(s, base);
}
