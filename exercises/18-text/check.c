// check.c - tests of the exercise 18/text.

#include "text.h"
#include "measure.h"
#include "suite.h"

#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Places of some metres, sums over some dozen particles.
static const real ROUNDING = 1e-9;

static text_scene read;

static void tear_down(void)
{
    text_scene_free(&read);
}

// Reads from memory that ends behind the closing 0.
static status read_text(const char *text)
{
    char *own = malloc(strlen(text) + 1);
    ck_assert_ptr_nonnull(own);
    memcpy(own, text, strlen(text) + 1);
    status r = text_scene_read(&read, own);
    free(own);
    return r;
}

static void expect_ok(const char *text, int bodies)
{
    status r = read_text(text);
    ck_assert_msg(r.ok, "this text is right:\n%s\ngot: %s", text, r.why);
    ck_assert_msg(read.world.bodies == bodies, "this text:\n%s\nhas %d "
                  "bodies, got %d", text, bodies, read.world.bodies);
}

// The middle of body b.
static vec3 middle(int b)
{
    vec3 at[12], sum = { 0, 0, 0 };
    int n = read.world.body[b].shape->particles;
    world_vertices(&read.world, &read.world.body[b], at);
    for (int k = 0; k < n; k++) sum = vec3_add_scaled(sum, 1.0 / n, at[k]);
    return sum;
}

static void expect_at(int b, real x, real y, real z)
{
    vec3 got = middle(b);
    ck_assert_msg(vec3_distance(got, (vec3){ x, y, z }) < ROUNDING, "body %d: "
                  "at (%g, %g, %g), wanted (%g, %g, %g)", b, got.x, got.y,
                  got.z, x, y, z);
}

START_TEST(text_becomes_a_world)
{
    // Rejects: lines that are skipped; sides, mass and place mixed up.
    expect_ok("gravity 0 -1.62 0\n"
              "plane 0 1 0 0.25\n"
              "box 1 2 3 4 5 6 7\n"
              "ball 0.5 8 -1 -2 -3\n", 2);
    world *w = &read.world;
    ck_assert_msg(w->options.gravity.y == -1.62, "gravity is %g",
                  w->options.gravity.y);
    ck_assert_msg(w->planes == 1 && w->plane[0].offset == 0.25, "%d planes",
                  w->planes);
    ck_assert_msg(fabs(w->body[0].mass - 4) < ROUNDING, "the box has %g kg",
                  w->body[0].mass);
    ck_assert_msg(fabs(w->body[1].mass - 8) < ROUNDING, "the ball has %g kg",
                  w->body[1].mass);
    ck_assert_msg(w->body[0].shape->at[7].x == 0.5
                  && w->body[0].shape->at[7].z == 1.5, "the box has other "
                  "sides");
    ck_assert_msg(fabs(w->body[1].shape->radius - 0.5) < ROUNDING,
                  "the ball has a radius of %g", w->body[1].shape->radius);
    expect_at(0, 5, 6, 7);
    expect_at(1, -1, -2, -3);
}
END_TEST

START_TEST(last_body_is_thrown_and_spun)
{
    // Rejects: a body that enters the world before its lines have come; the
    // first body in the place of the last.
    expect_ok("gravity 0 0 0\n"
              "box 1 1 1 2 0 0 0\n"
              "throw 3 0 0\n"
              "ball 1 4 9 0 0\n"
              "throw 0 0 -2\n"
              "spin 0 5 0\n", 2);
    measures m = world_measure(&read.world);
    ck_assert_msg(vec3_distance(m.momentum, (vec3){ 6, 0, -8 }) < 1e-6,
                  "momentum (%g, %g, %g), wanted (6, 0, -8)", m.momentum.x,
                  m.momentum.y, m.momentum.z);
    ck_assert_msg(m.kinetic > 9 + 8 + 1, "nothing spins: %g J", m.kinetic);
}
END_TEST

START_TEST(static_one_stays)
{
    expect_ok("box 1 1 1 2 0 0 0\nnail\nbox 1 1 1 2 5 0 0\n", 2);
    ck_assert_msg(body_is_static(&read.world.body[0]), "it is not static");
    ck_assert_msg(!body_is_static(&read.world.body[1]), "so is the other");
}
END_TEST

START_TEST(blanks_and_comments_mean_nothing)
{
    // Rejects: a last line that is lost without its end; a # that is a word.
    expect_ok("", 0);
    text_scene_free(&read);
    expect_ok("\n\n  # nothing\n\t\n#box 1 1 1 1 0 0 0", 0);
    text_scene_free(&read);
    expect_ok("  box\t1 1 1   2 3 4 5   # a box\r\nnail# at once\n"
              "ball 1 1 0 9 0", 2);
    expect_at(0, 3, 4, 5);
    expect_at(1, 0, 9, 0);
    text_scene_free(&read);
    expect_ok("box 1e0 +1 1.0 2 -3e-1 .5 5.\n", 1);
    expect_at(0, -0.3, 0.5, 5);
}
END_TEST

START_TEST(scene_runs)
{
    // Rejects: a world that has not begun.
    expect_ok("plane 0 1 0 0\nbox 1 1 1 2 0 0.6 0\n", 1);
    for (int k = 0; k < 60; k++) world_step(&read.world);
    ck_assert_msg(fabs(middle(0).y - 0.5) < 0.02, "the box lies at y = %g, "
                  "wanted 1/2", middle(0).y);
}
END_TEST

static void expect_wrong(const char *text, int line, const char *about)
{
    char begin[20];
    sprintf(begin, "line %d: ", line);
    status r = read_text(text);
    ck_assert_msg(!r.ok, "this text is wrong, and was read:\n%s", text);
    ck_assert_msg(strncmp(r.why, begin, strlen(begin)) == 0, "this text:\n%s\n"
                  "is wrong in line %d; got: %s", text, line, r.why);
    ck_assert_msg(!about || strstr(r.why, about), "this text:\n%s\nthe "
                  "sentence does not name %s: %s", text, about, r.why);
    ck_assert_msg(strlen(r.why) > strlen(begin) + 5, "no sentence: %s", r.why);
    ck_assert_msg(read.bodies == 0 && read.world.bodies == 0
                  && read.world.body == NULL, "after a mistake the scene is "
                  "not empty");
}

START_TEST(mistakes_are_named_with_their_line)
{
    // Rejects: lines counted from 0; blank ones not counted; a mistake that is
    // read over.
    expect_wrong("box 1 1 1 2 0 0 0\n\nbax 1 1 1\n", 3, "bax");
    expect_wrong("# a tower\ngravity 0 0\n", 2, "gravity");
    expect_wrong("box 1 1 1 2 0 0 0 7\n", 1, "box");
    expect_wrong("box 1 1 1 2 0 0 up\n", 1, "box");
    expect_wrong("plane 0 1 0 0x\n", 1, "plane");
    expect_wrong("ball 1 1 0 0\n0\n", 1, "ball");
    expect_wrong("nail\n", 1, "nail");
    expect_wrong("plane 0 1 0 0\nthrow 1 0 0\n", 2, "throw");
    expect_wrong("ball 1 1 0 0 0\nnail nail\n", 2, "nail");
    expect_wrong("ball 1 1 0 0 0\ngravity 0 0 0\n", 2, "gravity");
}
END_TEST

START_TEST(numbers_have_to_be_finite)
{
    // Rejects: whatever strtod takes for a number.
    expect_wrong("gravity 0 nan 0\n", 1, NULL);
    expect_wrong("plane 0 1 0 inf\n", 1, NULL);
    expect_wrong("box 1 1 1 2 0 1e999 0\n", 1, NULL);
    expect_wrong("ball 1 1 0 0 0\nthrow -inf 0 0\n", 2, NULL);
}
END_TEST

START_TEST(what_builders_refuse_is_passed_on)
{
    // Rejects: a status that nobody reads; plans that are not given back.
    expect_wrong("ball 1 1 0 0 0\nbox 1 1 1 1 5 0 0\nbox 1 -1 1 2 0 0 0\n", 3,
                 NULL);
    expect_wrong("ball 0 1 0 0 0\n", 1, NULL);
    expect_wrong("ball 1 0 0 0 0\n", 1, NULL);
    expect_wrong("plane 0 0 0 0\n", 1, NULL);
}
END_TEST

START_TEST(long_lines_and_many_bodies_find_an_end)
{
    // Rejects: a line that is copied without a look at its length; one body
    // past the last place.
    char text[4000] = "ball 1 1 0 0 0\n#";
    size_t n = strlen(text);
    memset(text + n, 'x', TEXT_LINE - 2);
    expect_ok(text, 1);
    text_scene_free(&read);
    memset(text + n, 'x', TEXT_LINE - 1);
    expect_wrong(text, 2, NULL);
    memset(text + n, 'x', 3000);
    expect_wrong(text, 2, NULL);
    text[0] = 0;
    for (int k = 0; k < TEXT_BODIES; k++)
        sprintf(text + strlen(text), "box 1 1 1 1 %d 0 0\n", 2 * k);
    expect_ok(text, TEXT_BODIES);
    text_scene_free(&read);
    strcat(text, "box 1 1 1 1 0 5 0\n");
    expect_wrong(text, TEXT_BODIES + 1, NULL);
}
END_TEST

START_TEST(freed_twice_is_freed_once)
{
    expect_ok("box 1 1 1 2 0 0 0\n", 1);
    text_scene_free(&read);
    text_scene_free(&read);
    ck_assert_int_eq(read.bodies, 0);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        text_becomes_a_world,
        last_body_is_thrown_and_spun,
        static_one_stays,
        blanks_and_comments_mean_nothing,
        scene_runs,
        mistakes_are_named_with_their_line,
        numbers_have_to_be_finite,
        what_builders_refuse_is_passed_on,
        long_lines_and_many_bodies_find_an_end,
        freed_twice_is_freed_once,
        NULL
    };
    return suite_run((suite){
        .name = "text", .tests = tests, .tear_down = tear_down
    });
}
