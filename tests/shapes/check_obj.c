// check_obj.c - reading OBJ files, and every way for them to be wrong.
//
// Run from the project's root: it reads tests/data/.

#define _XOPEN_SOURCE 700

#include "convex.h"
#include "expect.h"
#include "obj.h"
#include "random.h"
#include "rigidity.h"
#include "scarce.h"
#include "suite.h"
#include "validate.h"

#include <check.h>
#include <limits.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define COUNT(list) ((int)(sizeof (list) / sizeof (list)[0]))
#define DATA "tests/data/"

// Roundings on the way from the file to the body: centre, scale, centre.
static const real ROUNDING = 1e-14;

static void expect_empty(const shape *s)
{
    ck_assert(s->particles == 0 && s->sticks == 0 && s->mesh.edges == 0);
    ck_assert(!s->at && !s->mass && !s->stick && !s->face && !s->mesh.half);
}

// Each test runs in a process and a folder of its own; a file of these bytes is
// written there, read, and removed.
static char folder[] = P_tmpdir "/tumble-XXXXXX";

static void enter(void)
{
    ck_assert(mkdtemp(folder) != NULL);
}

static void leave(void)
{
    rmdir(folder);
}

static status read_bytes(const char *bytes, size_t length, shape *s)
{
    char path[64];
    snprintf(path, sizeof path, "%s/x.obj", folder);
    FILE *out = fopen(path, "wb");
    ck_assert(out && fwrite(bytes, 1, length, out) == length);
    fclose(out);
    memset(s, 0x55, sizeof *s);
    status r = obj_read(path, 1, 1, s);
    remove(path);       // a file written over is flushed: slow, 1,000 times
    return r;
}

// Expects that text is refused with this sentence after the file's name.
static void expect_refused(const char *text, const char *why)
{
    shape s;
    char whole[300];
    status r = read_bytes(text, strlen(text), &s);
    snprintf(whole, sizeof whole, "%s/x.obj%s", folder, why);
    expect_why(r, whole);
    expect_empty(&s);
}

static void expect_read(const char *text, int particles)
{
    shape s;
    expect_ok(read_bytes(text, strlen(text), &s));
    ck_assert_int_eq(s.particles, particles);
    near(s.radius, 1, ROUNDING);
    expect_ok(mesh_validate(&s.mesh));
    expect_ok(mesh_check_convex(&s.mesh, s.at));
    shape_free(&s);
}

// Vertices and faces of a tetrahedron, to be put together and spoilt.
#define V4 "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\n"
#define F4 "f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n"

// ------------------------------------------------------------------ good files

// Rejects: no scaling, scaling by a side, a centre that stays where it was.
START_TEST(cube_of_squares_is_read)
{
    shape s;
    expect_ok(obj_read(DATA "cube.obj", 3, 2, &s));
    ck_assert_int_eq(s.kind, SHAPE_RIGID);
    ck_assert_int_eq(s.particles, 8);
    ck_assert_int_eq(s.mesh.faces, 12);
    ck_assert_int_eq(s.sticks, 18 + 1);     // and the diagonal from vertex 0
    near(s.radius, 3, 3 * ROUNDING);
    for (int i = 0; i < 8; i++) {
        near(vec3_length(s.at[i]), 3, 3 * ROUNDING);
        near(s.mass[i], 0.25, 0);
    }
    near(mesh_volume(&s.mesh, s.at), 8 * 3 * sqrt(3), 1e-12);
    ck_assert_int_eq(shape_rank(&s), 18);
    shape_free(&s);
}
END_TEST

START_TEST(negative_indices_count_from_the_end)
{
    shape s;
    expect_ok(obj_read(DATA "tetrahedron.obj", 1, 1, &s));
    ck_assert_int_eq(s.particles, 4);
    ck_assert_int_eq(s.sticks, 6);
    near(s.at[1].y, -1 / sqrt(3), ROUNDING);
    shape_free(&s);
}
END_TEST

START_TEST(mesh_that_looks_inwards_is_turned_round)
{
    shape s;
    expect_ok(obj_read(DATA "octahedron-inwards.obj", 1, 1, &s));
    near(mesh_volume(&s.mesh, s.at), 4.0 / 3, ROUNDING);
    shape_free(&s);
}
END_TEST

START_TEST(every_spelling_is_read)
{
    expect_read(V4 F4, 4);
    // No newline at the end; carriage returns; tabs; blanks before and after.
    expect_read(V4 "f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3", 4);
    expect_read("v 1 1 1\r\nv 1 -1 -1\r\nv -1 1 -1\r\nv -1 -1 1\r\n"
                "f 1 2 3\r\nf 1 3 4\r\nf 1 4 2\r\nf 2 4 3\r\n", 4);
    expect_read("  v\t1  1 1 \t\n v 1 -1 -1\nv -1 1 -1\nv -1 -1 1\n\n\n\t\n"
                "f  1 2\t3  \nf 1 3 4\nf 1 4 2\nf 2 4 3\n", 4);
    // Textures, normals, comments, names, weights, colours.
    expect_read("# a comment\nmtllib x\nv 1 1 1 1.0\nv 1 -1 -1 # corner\n"
                "v -1 1 -1 .5 .5 .5\nv -1 -1 1\nvt 0 nan\nvn 0 0 1\nvp 1\n"
                "f 1/1 2/1 3/1\nf 1//1 3//1 4//1\nf 1/1/1 4/-1/-1 2/1/1\n"
                "f 2 4 3#f 1 1\nfoo 1 2 3\nl 1 2\n", 4);
    // Numbers of every kind.
    expect_read("v +1 1. 1e0\nv 10e-1 -1E+0 -.1e1\nv -0.0001e4 1 -1\n"
                "v -1.000000000000000000000000000000 -1 1\n" F4, 4);
    // More digits than a number can keep, before the point.
    expect_read("v 1000000000000000000000e-21 10000000000000000000.0e-19 1\n"
                "v 1 -1 -1\nv -1 1 -1\nv -1 -1 1\n" F4, 4);
    // Faces before their vertices; the three bytes that open some UTF-8 files.
    expect_read(F4 V4, 4);
    expect_read("\xEF\xBB\xBF" V4 F4, 4);
}
END_TEST

// Rejects: a backslash that ends a comment and takes the next line along; one
// that glues two words together; joined lines that are not counted.
START_TEST(backslash_joins_two_lines)
{
    expect_read("v 1 \\\n1 1\nv 1 -1\\\r\n-1\r\nv \\\n-1 \\\n\\\n1 -1\n"
                "v -1 -1 1\nf 1\\\n2\\\n3\nf 1 3 4\nf 1 4 2\nf 2 4 3\\\n", 4);
    expect_read("# in C:\\bodies\\\n" V4 "curv 0 1 \\\nf 1 2 9\n" F4, 4);
    expect_refused(V4 "f 1 \\\n 2 \\\n9 x\nf 1 2 3\n",
                   ", line 5: 'x' is not the index of a vertex");
    expect_refused("v 1 \\\n1 1\nv one\n", ", line 3: 'one' is not a number");
    expect_refused("v 1 1\\1 1\n", ", line 1: '1\\1' is not a number");
    expect_refused("v 1 1 \\", ", line 1: '\\' is not a number");
}
END_TEST

// Rejects: unused vertices that stay as particles no stick holds, or that pull
// the centre towards them.
START_TEST(unused_vertices_are_dropped)
{
    shape s;
    static const char text[] = "v 9 9 9\n" V4 "v 0 0 0\n"
                               "f 2 3 4\nf 2 4 5\nf 2 5 3\nf 3 5 4\n";
    expect_read(text, 4);
    expect_ok(read_bytes(text, sizeof text - 1, &s));
    for (int i = 0; i < 4; i++)
        near(vec3_length(s.at[i]), 1, ROUNDING);
    shape_free(&s);
}
END_TEST

// The lines named stay right when vertices before them are dropped.
START_TEST(lines_are_right_after_dropping)
{
    expect_refused("v 7 7 7\n" V4 "f 2 3 4\nf 2 4 5\nf 2 5 3\n",
                   ": the edge from the vertex of line 4 to the vertex of line "
                   "3 has a triangle on one side only: the mesh is open");
}
END_TEST

// Rejects: buffers of a few hundred characters; what does not fit, in parts; a
// comment that needs room.
START_TEST(long_line_is_read_and_a_longer_one_refused)
{
    enum { LONG = 200000, LINE = 65535 };
    char *text = malloc(LONG + 200);
    text[0] = '#';
    memset(text + 1, 'x', LONG);
    strcpy(text + LONG, "\n" V4 "f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3");
    expect_read(text, 4);

    // 65,535 characters are a line, one more is too long.
    static const char rest[] = "1 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                               "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    memset(text, '0', LONG);
    memcpy(text, "v 0.", 4);
    strcpy(text + LINE - 5, rest);
    expect_read(text, 4);
    memset(text, '0', LONG);
    memcpy(text, "v 0.", 4);
    strcpy(text + LINE - 4, rest);
    expect_refused(text, ", line 1: the line is longer than 65535 characters");
    free(text);
}
END_TEST

// Rejects: digits after the eighteenth that do not count as places; powers of
// ten by pow or by a table that ends.
START_TEST(numbers_are_read_to_fifteen_digits)
{
    static const char *const given[8] = {
        "0.1", "123456.789", "3.14159265358979", "-2.5e-3",
        "1234567890123456789012e-20", "100000000000000000000000e-20",
        "0.00000000000000000000125e+21", "1250000.000000000000000000001E-6"
    };
    for (int k = 0; k < 8 + 200; k++) {
        real x = k < 8 ? strtod(given[k], NULL) : sqrt(k) * 1e-7 * k * k;
        char number[40], text[400];
        snprintf(number, sizeof number, "%.17g", x);
        // A tetrahedron with corners at 0, at x on two axes, at 1 on the third.
        const char *n = k < 8 ? given[k] : number;
        snprintf(text, sizeof text, "v 0 0 0\nv %s 0 0\nv 0 %s 0\nv 0 0 1\n"
                 "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", n, n);
        shape s;
        expect_ok(read_bytes(text, strlen(text), &s));
        real got = (s.at[1].x - s.at[0].x) / (s.at[3].z - s.at[0].z);
        near(got / x, 1, 2e-15);
        shape_free(&s);
    }
}
END_TEST

// Rejects: strtod under a locale that writes a comma, if the machine has one.
START_TEST(locale_does_not_matter)
{
    static const char *const names[5] =
        { "de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8", "fr_FR" };
    for (int k = 0; k < 5; k++)
        if (setlocale(LC_ALL, names[k])) break;
    expect_read("v 0.5 0 0\nv -0.5 0 0\nv 0 1.5 0\nv 0 0 1.5\n"
                "f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n", 4);
    setlocale(LC_ALL, "C");
}
END_TEST

// Rejects: squares that overflow or vanish before the file is scaled.
START_TEST(size_in_the_file_does_not_matter)
{
    static const char *const unit[4] = { "1e-150", "1e-12", "1e12", "1e30" };
    for (int k = 0; k < 4; k++) {
        char text[300];
        const char *u = unit[k];
        snprintf(text, sizeof text, "v 0 0 0\nv %s 0 0\nv 0 %s 0\nv 0 0 %s\n"
                 "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", u, u, u);
        expect_read(text, 4);
    }
}
END_TEST

// ------------------------------------------------------------------- bad files

START_TEST(file_that_cannot_be_opened_is_named)
{
    shape s;
    expect_why(obj_read("no/such.obj", 1, 1, &s),
               "no/such.obj: cannot be opened: No such file or directory");
    expect_empty(&s);
    status r = obj_read("a/very/long/path/to/a/file/that/does/not/exist/at/"
                        "all.obj", 1, 1, &s);
    expect_why(r, "...to/a/file/that/does/not/exist/at/all.obj: cannot be "
                  "opened: No such file or directory");
}
END_TEST

START_TEST(folder_is_no_file)
{
    shape s;
    expect_why(obj_read("tests", 1, 1, &s),
               "tests: cannot be read: Is a directory");
    expect_empty(&s);
}
END_TEST

START_TEST(file_without_a_body_is_named)
{
    expect_refused("", ": no vertex: no line begins with v");
    expect_refused("\n", ": no vertex: no line begins with v");
    expect_refused("hello\nvn 1 2 3\n", ": no vertex: no line begins with v");
    expect_refused("f 1 2 3\n", ": no vertex: no line begins with v");
    expect_refused(V4, ": no face: no line begins with f");
}
END_TEST

START_TEST(bytes_that_are_no_text_are_named)
{
    shape s;
    char text[300];
    snprintf(text, sizeof text, "%s/x.obj, line 2: the file is not text: here "
             "is a zero byte", folder);
    expect_why(read_bytes("#\nv 1 2\0 3\n", 12, &s), text);
    expect_why(read_bytes("#\nv 1 2\0", 8, &s), text);

    // Noise of every byte but zero: some sentence, no crash.
    char noise[4096];
    unsigned long long seed = 1;
    for (int round = 0; round < 50; round++) {
        for (int k = 0; k < 4096; k++)
            noise[k] = (char)(1 + random_below(&seed, 255));
        ck_assert(!read_bytes(noise, sizeof noise, &s).ok);
        expect_empty(&s);
    }
}
END_TEST

// Half a file, and a file with one byte changed: no crash, and never a body
// that is not convex.
START_TEST(damaged_files_do_no_harm)
{
    static const char good[] = V4 F4;
    static const char wrong[] = "0129-+.e/ \n#vf\xff";
    shape s;
    for (size_t length = 0; length < sizeof good - 1; length++)
        if (read_bytes(good, length, &s).ok) {
            expect_ok(mesh_check_convex(&s.mesh, s.at));
            shape_free(&s);
        }
    for (size_t k = 0; k < sizeof good - 1; k++)
        for (size_t w = 0; w < sizeof wrong - 1; w++) {
            char text[sizeof good];
            memcpy(text, good, sizeof good);
            text[k] = wrong[w];
            if (read_bytes(text, sizeof good - 1, &s).ok) {
                expect_ok(mesh_check_convex(&s.mesh, s.at));
                shape_free(&s);
            }
        }
}
END_TEST

START_TEST(bad_numbers_are_named_with_their_line)
{
    static const char *const bad[14] = {
        "one", "nan", "inf", "-", ".", "1e", "1e+", "0x10", "1,5", "1.2.3",
        "--1", "1f", "e5", "1_000"
    };
    for (int k = 0; k < 14; k++) {
        char text[200], why[100];
        snprintf(text, sizeof text, "# x\n\nv 0 %s 0\n" F4, bad[k]);
        snprintf(why, sizeof why, ", line 3: '%s' is not a number", bad[k]);
        expect_refused(text, why);
    }
    expect_refused("v 1 2\n", ", line 1: a vertex needs three numbers");
    expect_refused("v\n", ", line 1: a vertex needs three numbers");
    expect_refused("v 1 2 # 3\n", ", line 1: a vertex needs three numbers");
    expect_refused("v 1 1e31 0\n", ", line 1: '1e31' is not a coordinate of "
                                   "at most 1e30");
    expect_refused("v 1 -1e999 0\n", ", line 1: '-1e999' is not a coordinate "
                                     "of at most 1e30");
    expect_refused("v 1 1e99999999999 0\n", ", line 1: "
                   "'1e99999999999' is not a coordinate of at most 1e30");
    // A long word is quoted in part.
    expect_refused("v abcdefghijklmnopqrstuvwxyz 0 0\n",
                   ", line 1: 'abcdefghijklmnopqrst' is not a number");

    shape s;
    expect_why(obj_read(DATA "comma.obj", 1, 1, &s),
               "tests/data/comma.obj, line 2: '0,5' is not a number");
}
END_TEST

START_TEST(bad_indices_are_named_with_their_line)
{
    expect_refused(V4 "f 1 2 x\n", ", line 5: 'x' is not the index of a "
                                   "vertex");
    expect_refused(V4 "f 1 2 3.5\n", ", line 5: '3.5' is not the index of a "
                                     "vertex");
    expect_refused(V4 "f 1 2 /3\n", ", line 5: '/3' is not the index of a "
                                    "vertex");
    expect_refused(V4 "f 1 2 3-4\n", ", line 5: '3-4' is not the index of a "
                                     "vertex");
    expect_refused(V4 "f 1 2 0\n", ", line 5: '0' is not an index from 1 to "
                                   "4096");
    expect_refused(V4 "f 1 2 4097\n", ", line 5: '4097' is not an index from 1 "
                                      "to 4096");
    expect_refused(V4 "f 1 2 99999999999999999999\n", ", line 5: "
                   "'99999999999999999999' is not an index from 1 to 4096");
    expect_refused(V4 F4 "f 1 2 5\n", ", line 9: a face uses vertex 5, but "
                                      "there are only 4");
    expect_refused("f 1 2 4096\n" V4, ", line 1: a face uses vertex 4096, but "
                                      "there are only 4");
    expect_refused(V4 "f 1 2 -5\n", ", line 5: a face uses vertex -5, but only "
                                    "4 stand above it");
    expect_refused("f -1 -2 -3\n" V4, ", line 1: a face uses vertex -1, but "
                                      "only 0 stand above it");
    expect_refused(V4 "f 1 2 -99999999999999999999\n", ", line 5: a face uses "
                   "vertex -9223372036854775808, but only 4 stand above it");
}
END_TEST

START_TEST(faces_with_too_few_corners_are_named)
{
    expect_refused(V4 "f\n", ", line 5: a face needs three corners");
    expect_refused(V4 "f 1 2 # 3\n", ", line 5: a face needs three corners");
    expect_refused(V4 F4 "f 1 2 2\n", ": the face of line 9 uses the vertex of "
                                   "line 2 twice");
}
END_TEST

// 4,097 vertices are refused at the line of the last; 4,096 would not be.
START_TEST(more_than_4096_vertices_are_refused)
{
    char *text = malloc(4200 * 12);
    size_t length = 0;
    for (int k = 0; k < 4096; k++)
        length += (size_t)sprintf(text + length, "v %d 0 0\n", k);
    expect_refused(text, ": no face: no line begins with f");
    sprintf(text + length, "v 0 1 0\n");
    expect_refused(text, ", line 4097: a file may have 4096 vertices at most");
    free(text);
}
END_TEST

// A face of n corners is n - 2 triangles, of which 8,192 would be read.
START_TEST(more_than_8192_triangles_are_refused)
{
    char *text = malloc(8200 * 2 + 200);
    size_t length = (size_t)sprintf(text, V4 "f");
    for (int k = 0; k < 8194; k++)
        length += (size_t)sprintf(text + length, " %d", k % 3 + 1);
    status s = read_bytes(text, length, &(shape){ 0 });
    ck_assert(!s.ok && !strstr(s.why, "8192"));
    sprintf(text + length, " 1");
    expect_refused(text,
                   ", line 5: a body may have 8192 triangles at most");
    free(text);
}
END_TEST

START_TEST(file_of_many_megabytes_is_refused)
{
    size_t length = ((size_t)1 << 24) + 1;
    char *text = malloc(length), why[100];
    memset(text, '#', length);      // remarks, for lines take longer than bytes
    for (size_t k = 0; k < length; k += 1000) text[k] = '\n';
    shape s;
    snprintf(why, sizeof why, "%s/x.obj: the file is larger than 16 MB",
             folder);
    expect_why(read_bytes(text, length, &s), why);
    snprintf(why, sizeof why, "%s/x.obj: no vertex: no line begins with v",
             folder);
    expect_why(read_bytes(text, length - 1, &s), why);
    free(text);
}
END_TEST

// ------------------------------------------------------------------ bad meshes

START_TEST(complaints_about_the_mesh_name_lines)
{
    shape s;
    expect_why(obj_read(DATA "open.obj", 1, 1, &s), "tests/data/open.obj: the "
               "edge from the vertex of line 8 to the vertex of line 6 has a "
               "triangle on one side only: the mesh is open");
    expect_empty(&s);
    expect_why(obj_read(DATA "turned.obj", 1, 1, &s), "tests/data/turned.obj: "
               "the face of line 6 and the face of line 9 both run from the "
               "vertex of line 3 to the vertex of line 4: one of them is "
               "turned inside out, or the edge has three triangles");
    expect_empty(&s);
    status r = obj_read(DATA "dented.obj", 1, 1, &s);
    ck_assert_msg(!r.ok && strstr(r.why, "of the size outside the plane of the "
                                         "face of line "), "%s", r.why);
    expect_empty(&s);
    // An edge of three faces; two bodies that touch in a vertex.
    expect_refused(V4 "v 0 5 5\n" F4 "f 1 2 5\n", ": the face of line 6 and "
                   "the face of line 10 both run from the vertex of line 1 to "
                   "the vertex of line 2: one of them is turned inside out, or "
                   "the edge has three triangles");
    expect_refused(V4 "v 2 2 3\nv 2 3 2\nv 3 2 2\n" F4
                   "f 1 5 6\nf 1 6 7\nf 1 7 5\nf 5 7 6\n",
                   ": two fans of triangles meet in the vertex of line 1 and "
                   "nowhere else: the surface is pinched there");
}
END_TEST

START_TEST(bodies_without_an_inside_are_refused)
{
    expect_refused("v 1 1 1\nv 1 1 1\nv 1 1 1\nv 1 1 1\n" F4,
                   ": all vertices stand in the same place");
    expect_refused("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 0 1\n" F4, ": the face of "
                   "line 5 is flat: the vertex of line 1, the vertex of line 2 "
                   "and the vertex of line 3 stand in one line");
    expect_refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 1 0\n" F4, ": the vertex of "
                   "line 3 and the vertex of line 4 stand in the same place");
    shape s;
    status r = read_bytes("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1.5 0\n" F4,
                          sizeof F4 - 1 + 34, &s);
    ck_assert_msg(!r.ok && (strstr(r.why, "no thickness") ||
                            strstr(r.why, "not convex")), "%s", r.why);
    expect_refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n", ": the "
                   "number of vertices is 3: it must be from 4 to 16384");
}
END_TEST

START_TEST(radius_and_mass_are_checked)
{
    real bad[5] = { 0, -1, (real)NAN, (real)INFINITY, 1e31 };
    for (int k = 0; k < 5; k++) {
        shape s;
        status r = obj_read(DATA "cube.obj", bad[k], 1, &s);
        ck_assert(!r.ok && strstr(r.why, "cube.obj: the radius is "));
        expect_empty(&s);
        r = obj_read(DATA "cube.obj", 1, bad[k], &s);
        ck_assert(!r.ok && strstr(r.why, "cube.obj: the mass is "));
        expect_empty(&s);
    }
}
END_TEST

// Rejects: a file left open: the next free number would have moved on.
START_TEST(file_is_closed_again)
{
    shape s;
    int before = dup(0);
    close(before);
    expect_ok(obj_read(DATA "cube.obj", 1, 1, &s));
    shape_free(&s);
    ck_assert(!obj_read("tests", 1, 1, &s).ok);
    int after = dup(0);
    close(after);
    ck_assert_int_eq(after, before);
}
END_TEST

// Rejects: a leak, or a half-built shape, when any one allocation is refused.
START_TEST(refused_memory_leaves_nothing)
{
    int n = 0;
    for (; n < 60; n++) {
        shape s;
        memset(&s, 0x55, sizeof s);
        mallocs_left = n;
        status r = obj_read(DATA "cube.obj", 1, 1, &s);
        mallocs_left = INT_MAX;
        if (r.ok) { shape_free(&s); break; }
        ck_assert_msg(strstr(r.why, "out of memory") ||
                      strstr(r.why, "cannot be opened"), "%s", r.why);
        expect_empty(&s);
    }
    ck_assert_int_gt(n, 8);
    ck_assert_int_lt(n, 60);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        cube_of_squares_is_read,
        negative_indices_count_from_the_end,
        mesh_that_looks_inwards_is_turned_round,
        every_spelling_is_read,
        backslash_joins_two_lines,
        unused_vertices_are_dropped,
        lines_are_right_after_dropping,
        long_line_is_read_and_a_longer_one_refused,
        numbers_are_read_to_fifteen_digits,
        locale_does_not_matter,
        size_in_the_file_does_not_matter,
        file_that_cannot_be_opened_is_named,
        folder_is_no_file,
        file_without_a_body_is_named,
        bytes_that_are_no_text_are_named,
        damaged_files_do_no_harm,
        bad_numbers_are_named_with_their_line,
        bad_indices_are_named_with_their_line,
        faces_with_too_few_corners_are_named,
        more_than_4096_vertices_are_refused,
        more_than_8192_triangles_are_refused,
        file_of_many_megabytes_is_refused,
        complaints_about_the_mesh_name_lines,
        bodies_without_an_inside_are_refused,
        radius_and_mass_are_checked,
        file_is_closed_again,
        refused_memory_leaves_nothing,
        NULL
    };
    return suite_run((suite){
        .name = "obj", .tests = tests, .set_up = enter, .tear_down = leave
    });
}
