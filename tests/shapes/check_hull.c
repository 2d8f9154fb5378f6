// check_hull.c - the solid that points span.

#include "hull.h"
#include "expect.h"
#include "random.h"
#include "scarce.h"
#include "suite.h"
#include "validate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST = 20000 };

static vec3 at[MOST];
static unsigned long long state;

// A rotation, as the three vectors that the axes become.
static void any_rotation(vec3 axis[3])
{
    axis[0] = vec3_unit(random_vec3(&state, 1));
    axis[1] = vec3_unit(vec3_cross(axis[0], random_vec3(&state, 1)));
    axis[2] = vec3_cross(axis[0], axis[1]);
}

static vec3 turned(const vec3 axis[3], vec3 p)
{
    return vec3_add(vec3_scale(p.x, axis[0]),
           vec3_add(vec3_scale(p.y, axis[1]), vec3_scale(p.z, axis[2])));
}

// The largest height of a point above a face, beside the size.  Where the hull
// was moved to is found by the first vertex: points keep their order.
static real furthest_out(const shape *s, int n)
{
    real worst = -1, size = 0;
    int first = 0;
    vec3 way = { 0, 0, 0 };
    for (int i = 0; i < n; i++)
        size = fmax(size, vec3_distance(at[i], at[0]));
    for (first = 0; first < n; first++) {
        int v = 0;
        way = vec3_sub(at[first], s->at[0]);
        for (int i = first; i < n && v < s->particles; i++)
            v += vec3_distance(vec3_add(s->at[v], way), at[i]) <= 1e-13 * size;
        if (v == s->particles) break;
    }
    ck_assert_msg(first < n, "vertices are not points in their order");
    for (int f = 0; f < s->mesh.faces; f++) {
        const int *v = &s->face[3 * f];
        vec3 a = s->at[v[0]];
        vec3 normal = vec3_unit(vec3_cross(vec3_sub(s->at[v[1]], a),
                                           vec3_sub(s->at[v[2]], a)));
        real offset = vec3_dot(normal, vec3_add(a, way));
        for (int i = 0; i < n; i++)
            worst = fmax(worst, vec3_dot(normal, at[i]) - offset);
    }
    return worst / size;
}

// What holds for every hull of the first n points.  Returns its volume.
static real expect_hull_within(int n, shape *s, real tolerance)
{
    expect_ok(shape_hull(s, at, n, 2));
    expect_ok(mesh_validate(&s->mesh));
    expect_ok(mesh_check_convex(&s->mesh, s->at));
    ck_assert_int_eq(mesh_euler(&s->mesh), 2);
    ck_assert_int_eq(s->mesh.faces, 2 * s->particles - 4);
    ck_assert_int_eq(s->mesh.edges, 3 * s->particles - 6);
    real out = furthest_out(s, n);
    ck_assert_msg(out <= tolerance, "a point stands %g outside", out);
    real mass = 0;
    for (int i = 0; i < s->particles; i++) mass += s->mass[i];
    ck_assert(fabs(mass - 2) < 1e-12);
    return mesh_volume(&s->mesh, s->at);
}

static real expect_hull(int n, shape *s)
{
    return expect_hull_within(n, s, 1e-12);
}

static int fill_grid(int nx, int ny, int nz, vec3 step)
{
    int n = 0;
    for (int i = 0; i <= nx; i++)
        for (int j = 0; j <= ny; j++)
            for (int k = 0; k <= nz; k++)
                at[n++] = vec3_make(i * step.x, j * step.y, k * step.z);
    return n;
}

// Rejects: points inside that become vertices, faces that are counted twice.
START_TEST(cube_with_points_inside_is_a_cube)
{
    shape s;
    int n = fill_grid(1, 1, 1, vec3_make(1, 2, 3));
    for (; n < 200; n++)
        at[n] = vec3_make(.5 + .4 * random_real(&state),
                          1 + .8 * random_real(&state),
                          1.5 + 1.4 * random_real(&state));
    real volume = expect_hull(n, &s);
    ck_assert_int_eq(s.particles, 8);
    ck_assert(fabs(volume - 6) < 1e-13 * 6);
    // Its centre of mass is its origin.
    for (int k = 0; k < 8; k++)
        ck_assert(fabs(fabs(s.at[k].x) - .5) < 1e-15
                  && fabs(fabs(s.at[k].y) - 1) < 1e-15
                  && fabs(fabs(s.at[k].z) - 1.5) < 1e-15);
    shape_free(&s);
}
END_TEST

// Grids have many points on faces and on edges; turned, they lie there up to
// rounding.
// Rejects: a point on a face that is a vertex.
START_TEST(grids_in_any_pose_have_eight_vertices)
{
    const int cells[][3] = { { 1, 1, 1 }, { 9, 9, 9 }, { 20, 1, 1 },
                             { 7, 13, 2 }, { 25, 25, 1 } };
    for (int c = 0; c < COUNT(cells); c++)
        for (int pose = 0; pose < 20; pose++) {
            int n = fill_grid(cells[c][0], cells[c][1], cells[c][2],
                              vec3_make(.3, .7, .1));
            vec3 axis[3], away = random_vec3(&state, pose);
            any_rotation(axis);
            for (int i = 0; i < n && pose > 0; i++)
                at[i] = vec3_add(away, turned(axis, at[i]));
            shape s;
            real volume = expect_hull(n, &s);
            real whole = cells[c][0] * .3 * cells[c][1] * .7 * cells[c][2] * .1;
            ck_assert_int_eq(s.particles, 8);
            ck_assert(fabs(volume - whole) < 1e-11 * whole);
            shape_free(&s);
        }
}
END_TEST

// Of points of a sphere all are vertices.  The hull of many of them has nearly
// the ball's volume.
START_TEST(every_point_of_a_sphere_is_a_vertex)
{
    shape s;
    int n = 1000;
    // Along a spiral from pole to pole, as wide apart across as along.
    for (int i = 0; i < n; i++) {
        real up = 1 - (2 * i + 1) / (real)n, turn = 2.399963229728653 * i;
        real r = sqrt(1 - up * up);
        at[i] = vec3_make(r * cos(turn), up, r * sin(turn));
    }
    real volume = expect_hull(n, &s), ball = 4 * acos(-1) / 3;
    ck_assert_int_eq(s.particles, n);
    printf("sphere of 1000 points: %.4f of the ball's volume\n",
           volume / ball);
    ck_assert(volume < ball && volume > .99 * ball);
    shape_free(&s);
}
END_TEST

START_TEST(random_clouds_lie_in_their_hull)
{
    for (int run = 0; run < 400; run++) {
        int n = run < 300 ? 4 + run / 4 : 10 * run;
        vec3 wide = vec3_make(1, run % 3 == 1 ? 1e-3 : 1,
                              run % 3 == 2 ? 100 : 1);
        vec3 away = vec3_scale(run % 5, random_vec3(&state, 1));
        for (int i = 0; i < n; i++) {
            vec3 p = random_vec3(&state, 1);
            at[i] = vec3_make(away.x + wide.x * p.x, away.y + wide.y * p.y,
                              away.z + wide.z * p.z);
        }
        shape s;
        expect_hull(n, &s);
        shape_free(&s);
    }
}
END_TEST

// The corners of a tetrahedron, each said n times, with its middle: volume 1/6.
START_TEST(points_said_twice_are_one)
{
    shape s;
    int n = 0;
    for (int k = 0; k < 10; k++) {
        at[n++] = vec3_make(.25, .25, .25);
        for (int c = 0; c < 4; c++)
            at[n++] = vec3_make(c == 1, c == 2, c == 3);
    }
    real volume = expect_hull(n, &s);
    ck_assert_int_eq(s.particles, 4);
    ck_assert(fabs(volume - 1.0 / 6) < 1e-15);
    shape_free(&s);
}
END_TEST

// Cubes whose faces are rough by so little that slivers would fill them.
// Rejects: triangles thinner than shape_convex bears, or a way out that leaves
// a point far outside.
START_TEST(rough_cubes_have_hulls)
{
    int coarse = 0, runs = 0;
    real worst = 0;
    for (int power = 4; power <= 16; power++)
        for (int run = 0; run < 30; run++, runs++) {
            int n = fill_grid(5, 5, 5, vec3_make(.2, .2, .2));
            real rough = pow(10, -power);
            for (int i = 0; i < n; i++)
                at[i] = vec3_add_scaled(at[i], rough, random_vec3(&state, 1));
            shape s;
            real volume = expect_hull_within(n, &s, 1e-8);
            real out = furthest_out(&s, n);
            coarse += out > 1e-12;
            worst = fmax(worst, out);
            ck_assert(fabs(volume - 1) < 10 * rough + 1e-6);
            shape_free(&s);
        }
    printf("rough cubes: %d of %d have a point more than 1e-12 outside, at "
           "most %.2g\n", coarse, runs, worst);
}
END_TEST

// Rejects: a tolerance that is a length.
START_TEST(hull_does_not_depend_on_the_size)
{
    for (int power = -20; power <= 20; power += 5) {
        shape s;
        state = 1;
        for (int i = 0; i < 300; i++)
            at[i] = vec3_scale(pow(10, power), random_vec3(&state, 1));
        expect_hull(300, &s);
        ck_assert_int_eq(s.particles, 49);
        shape_free(&s);
    }
}
END_TEST

static void expect_refused(int n, const char *why)
{
    shape s;
    expect_why(shape_hull(&s, at, n, 1), why);
    ck_assert(s.particles == 0 && !s.at && !s.face && !s.mesh.half);
}

START_TEST(what_spans_no_body_is_refused)
{
    for (int i = 0; i < 100; i++) at[i] = vec3_make(3, 4, 5);
    expect_refused(100, "the 100 points stand in one place, or nearly: they "
                   "span no body");
    expect_refused(3, "the number of points is 3: it must be from 4 to "
                   "16777216");
    expect_refused(-1, "the number of points is -1: it must be from 4 to "
                   "16777216");
    vec3 along = vec3_unit(random_vec3(&state, 1)),
         aside = vec3_unit(random_vec3(&state, 1));
    for (int i = 0; i < 50; i++)
        at[i] = vec3_scale(random_real(&state), along);
    expect_refused(50, "the 50 points stand in one line, or nearly: they span "
                   "no body");
    for (int i = 0; i < 50; i++)
        at[i] = vec3_add_scaled(vec3_scale(random_real(&state), along),
                                random_real(&state), aside);
    expect_refused(50, "the 50 points stand in one plane, or nearly: they span "
                   "no body");
    at[7].y = (real)NAN;
    expect_refused(50, "point 7 is not at a finite place");
    for (int i = 0; i < 50; i++) at[i] = random_vec3(&state, 1e40);
    at[0] = vec3_make(0, 0, 0);
    at[1] = vec3_make(3e40, 0, 0);
    expect_refused(50, "the points measure 3e+40 m: it must be from 1e-30 to "
                   "1e30");
    for (int i = 0; i < 4; i++) at[i] = vec3_make(i == 1, i == 2, i == 3);
    shape s;
    expect_why(shape_hull(&s, at, 4, -1),
               "the mass is -1 kg: it must be a number from 1e-30 to 1e+30");
}
END_TEST

START_TEST(refused_memory_leaves_nothing)
{
    int n = fill_grid(3, 3, 3, vec3_make(1, 1, 1));
    bool done = false;
    for (int left = 0; !done; left++) {
        shape s;
        long before = blocks_held;
        mallocs_left = left;
        status made = shape_hull(&s, at, n, 1);
        mallocs_left = INT_MAX;
        done = made.ok;
        if (done) shape_free(&s);
        long held = blocks_held;
        ck_assert_int_eq(held, before);
        if (!done) ck_assert_str_eq(made.why, status_out_of_memory().why);
        ck_assert_int_lt(left, 1000);
    }
    ck_assert(done);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        cube_with_points_inside_is_a_cube,
        grids_in_any_pose_have_eight_vertices,
        every_point_of_a_sphere_is_a_vertex,
        random_clouds_lie_in_their_hull,
        points_said_twice_are_one,
        rough_cubes_have_hulls,
        hull_does_not_depend_on_the_size,
        what_spans_no_body_is_refused,
        refused_memory_leaves_nothing,
        NULL
    };
    return suite_run((suite){ .name = "hull", .tests = tests, .seconds = 120 });
}
