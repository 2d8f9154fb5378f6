// check.c - tests of the exercise 03/solid.

#include "solid.h"
#include "expect.h"
#include "suite.h"

#include <check.h>

// Some dozen roundings of numbers near 1.
static const real ROUNDING = 1e-13;
// At 1e6 m a place is rounded to 1e-10 m.
static const real FAR = 1e-8;
// The chapter gives its ratios with four decimals.
static const real DECIMALS = 5e-5;

static const int FOUR[4][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 },
                                { 1, 2, 3 } };

static mesh mesh_of(int vertices, const int (*triangle)[3], int faces)
{
    mesh m;
    status s = mesh_build(&m, vertices, triangle, faces);
    ck_assert_msg(s.ok, "the test's own mesh: %s", s.why);
    return m;
}

static solid box_at(vec3 sides, vec3 where, real density)
{
    shape s;
    ck_assert(shape_box(&s, sides, 1).ok);
    for (int i = 0; i < 8; i++) s.at[i] = vec3_add(s.at[i], where);
    solid r = solid_measure(&s.mesh, s.at, density);
    shape_free(&s);
    return r;
}

START_TEST(tetrahedron_is_its_five_particles)
{
    // Corners at 0 and on the axes at 2 m: volume 4/3.  With m x x over all of
    // it m 2^2 / 10 and m x y m 2^2 / 20, from the corner; from the middle, at
    // 1/2, m / 4 less.  Rejects: four particles of m / 4, a tip left out, a
    // volume without its sixth.
    vec3 at[4] = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 } };
    mesh m = mesh_of(4, FOUR, 4);
    solid s = solid_measure(&m, at, 3);
    mesh_free(&m);
    near(s.mass, 4, ROUNDING, "mass", "3 kg/m^3 times 4/3 m^3.");
    near_vec3(s.centre, (vec3){ 0.5, 0.5, 0.5 }, ROUNDING, "centre",
               "The middle of its corners.");
    near(s.xx, 0.6, ROUNDING, "xx", "m (2^2 / 10 - 1/4).");
    near(s.zz, 0.6, ROUNDING, "zz", "The same along every axis.");
    near(s.xy, -0.2, ROUNDING, "xy", "m (2^2 / 20 - 1/4).");
    near(s.yz, -0.2, ROUNDING, "yz", "The same for every pair of axes.");
    near(s.zx, -0.2, ROUNDING, "zx", "The same for every pair of axes.");
}
END_TEST

START_TEST(box_has_a_twelfth_of_its_sides_squared)
{
    // Rejects: a centre or a spread as seen from a vertex, not taken back.
    solid s = box_at((vec3){ 2, 4, 6 }, (vec3){ 0, 0, 0 }, 0.5);
    near(s.mass, 24, ROUNDING, "mass", "48 m^3 of 0.5 kg/m^3.");
    near_vec3(s.centre, (vec3){ 0, 0, 0 }, ROUNDING, "centre",
               "The box stands about the origin.");
    near(s.xx, 24 * 4 / 12.0, 10 * ROUNDING, "xx", "m side^2 / 12.");
    near(s.yy, 24 * 16 / 12.0, 10 * ROUNDING, "yy", "m side^2 / 12.");
    near(s.zz, 24 * 36 / 12.0, 10 * ROUNDING, "zz", "m side^2 / 12.");
    near(s.xy, 0, 10 * ROUNDING, "xy", "The box lies along the axes.");
}
END_TEST

START_TEST(place_does_not_matter)
{
    // Rejects: Steiner forgotten or with the wrong sign; sums from the world's
    // origin, which are 1e12 too large and lose all digits.
    vec3 where = { 1e6, -2e6, 1e6 };
    solid s = box_at((vec3){ 1, 1, 1 }, where, 1);
    near(s.mass, 1, FAR, "mass", "Measure from a vertex, not from the origin.");
    near_vec3(s.centre, where, FAR, "centre", "In the world's frame again.");
    near(s.xx, 1 / 12.0, FAR, "xx", "Measure from a vertex, and correct at the "
         "end by mass times the way to the centre, squared.");
    near(s.xy, 0, FAR, "xy", "Mixed sums are corrected, too.");
}
END_TEST

START_TEST(turned_box_has_mixed_sums)
{
    // A box of 2, 4, 2, turned about z so that x goes along (0.6, 0.8):
    // xx becomes 0.36 xx + 0.64 yy, and xy 0.48 (xx - yy).  Rejects: mixed sums
    // of the wrong pair or sign.
    shape b;
    ck_assert(shape_box(&b, (vec3){ 2, 4, 2 }, 1).ok);
    for (int i = 0; i < 8; i++) {
        vec3 r = b.at[i];
        b.at[i] = (vec3){ 0.6 * r.x - 0.8 * r.y, 0.8 * r.x + 0.6 * r.y, r.z };
    }
    solid s = solid_measure(&b.mesh, b.at, 1);
    shape_free(&b);
    real xx = 16 * 4 / 12.0, yy = 16 * 16 / 12.0;
    near(s.xx, 0.36 * xx + 0.64 * yy, 10 * ROUNDING, "xx", "");
    near(s.yy, 0.64 * xx + 0.36 * yy, 10 * ROUNDING, "yy", "");
    near(s.xy, 0.48 * (xx - yy), 10 * ROUNDING, "xy",
         "m x y, summed over the solid, with its sign.");
    near(s.yz, 0, 10 * ROUNDING, "yz", "z is not turned.");
}
END_TEST

START_TEST(hollow_body_lacks_what_is_not_there)
{
    // A tetrahedron inside another, inside out.  Rejects: mass without a sign.
    vec3 at[8];
    int triangle[8][3];
    for (int i = 0; i < 4; i++) {
        at[i] = (vec3){ i == 1 ? 8 : 0, i == 2 ? 8 : 0, i == 3 ? 8 : 0 };
        at[4 + i] = vec3_add((vec3){ 1, 1, 1 }, vec3_scale(0.25, at[i]));
        for (int k = 0; k < 3; k++) {
            triangle[i][k] = FOUR[i][k];
            triangle[4 + i][k] = 4 + FOUR[i][2 - k];
        }
    }
    mesh m = mesh_of(8, (const int (*)[3])triangle, 8);
    solid s = solid_measure(&m, at, 1);
    mesh_free(&m);
    real full = 512 / 6.0, hole = 8 / 6.0, c = (2 * full - 1.5 * hole)
                                             / (full - hole);
    near(s.mass, full - hole, 10 * ROUNDING, "mass",
         "Faces that look inwards take away.");
    near_vec3(s.centre, (vec3){ c, c, c }, ROUNDING, "centre",
               "It moves away from the hole.");
    near(s.xx, full * 6.4 - hole * (0.15 + 2.25) - (full - hole) * c * c,
         1e-11, "xx", "The spread of the hole is taken away, too.");
}
END_TEST

START_TEST(inside_out_is_negative)
{
    // Rejects: fabs, which makes a mass of a mistake.
    static const int turned[4][3] = { { 0, 1, 2 }, { 0, 3, 1 }, { 0, 2, 3 },
                                      { 1, 3, 2 } };
    vec3 at[4] = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 } };
    mesh m = mesh_of(4, turned, 4);
    solid s = solid_measure(&m, at, 3);
    mesh_free(&m);
    near(s.mass, -4, ROUNDING, "mass", "All faces look inwards.");
    near(s.xx, -0.6, ROUNDING, "xx", "All faces look inwards.");
    near_vec3(s.centre, (vec3){ 0.5, 0.5, 0.5 }, ROUNDING, "centre",
               "Minus by minus.");
}
END_TEST

START_TEST(no_mass_is_all_zeros)
{
    // Rejects: 0 / 0 for a centre; face number 0 of no faces.
    vec3 at[4] = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 2, 2, 0 } };
    mesh m = mesh_of(4, FOUR, 4), none = { 0 };
    solid flat = solid_measure(&m, at, 3);
    solid nothing = solid_measure(&none, at, 3);
    mesh_free(&m);
    near(flat.mass, 0, 0, "mass of a flat mesh", "");
    near_vec3(flat.centre, (vec3){ 0, 0, 0 }, 0, "centre of a flat mesh",
               "Without mass there is no centre.");
    near(nothing.mass, 0, 0, "mass of no faces", "");
}
END_TEST

// How much harder to turn about x than the solid are equal particles at the
// corners?
static real too_hard(const mesh *m, const vec3 *at)
{
    solid s = solid_measure(m, at, 1);
    real sum = 0;
    for (int i = 0; i < m->vertices; i++) {
        vec3 r = vec3_sub(at[i], s.centre);
        sum += (r.y * r.y + r.z * r.z) / m->vertices;
    }
    return sum / ((s.yy + s.zz) / s.mass);
}

START_TEST(numbers_of_the_chapter_are_right)
{
    // Rejects: every mistake that is left.
    shape s;
    ck_assert(shape_box(&s, (vec3){ 1, 2, 3 }, 1).ok);
    near(too_hard(&s.mesh, s.at), 3, DECIMALS, "box", "");
    shape_free(&s);
    ck_assert(shape_icosahedron(&s, 1, 1).ok);
    near(too_hard(&s.mesh, s.at), 2.3033, DECIMALS, "icosahedron", "");
    shape_free(&s);
    vec3 at[4] = { { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } };
    mesh m = mesh_of(4, FOUR, 4);
    near(too_hard(&m, at), 5, DECIMALS, "tetrahedron", "");
    mesh_free(&m);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        tetrahedron_is_its_five_particles,
        box_has_a_twelfth_of_its_sides_squared,
        place_does_not_matter,
        turned_box_has_mixed_sums,
        hollow_body_lacks_what_is_not_there,
        inside_out_is_negative,
        no_mass_is_all_zeros,
        numbers_of_the_chapter_are_right,
        NULL
    };
    return suite_run((suite){ .name = "solid", .tests = tests });
}
