// check_seams.c - floors of several pieces: is a side that a neighbour hides
// left alone?  Book: chapter 11.

#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "expect.h"
#include "plain_seam.h"
#include "random.h"
#include "seams.h"
#include "suite.h"

// A few products of numbers near 1.
#define ROUNDING 1e-13

static const vec3 UP = { 0, 1, 0 }, BACK = { -1, 0, 0 };

// --- a slider and its floor --------------------------------------------------

enum { BODIES = 6, PAIRS = 8 };
enum { A = 0 };         // slides: a cube of 1 m

static shape cube, tile;
static rigid4 cube4, tile4;
static int bodies;
static struct body of[BODIES];
static solver_body now[BODIES];
static prediction ahead[BODIES];
static char moves[BODIES];
static int number[BODIES];
static plane ground;
static cache_frame frame;
static contact_cache cache;
static cache_pair pair[PAIRS + 1];
static cache_entry entry[PAIRS + 1];
static contact was[PAIRS + 1];
static rigid_frame placed[BODIES];
static struct placing placing[BODIES];
static vec3 vertex[8 * BODIES];
static int first[BODIES], end_of[BODIES];

static int add(bool is_tile, vec3 at)
{
    int b = bodies++;
    const rigid4 *r = is_tile ? &tile4 : &cube4;
    const shape *s = is_tile ? &tile : &cube;
    particle p[FOUR];
    for (int k = 0; k < FOUR; k++) p[k].position = vec3_add(at, r->at[k]);
    of[b] = (struct body){ .shape = s, .rigid = r, .inner = shape_inner(s) };
    placed[b] = rigid4_frame(p);
    now[b] = (solver_body){ .radius = r->reach, .frame = placed[b] };
    ahead[b] = (prediction){ .reach = is_tile ? 0 : 0.02 };
    moves[b] = !is_tile;
    number[b] = b;
    placing[b] = (struct placing){ .number = 1, .first = 8 * b, .vertices = 8,
                                   .in_range = true };
    rigid4_ride(r, &placed[b], vertex + 8 * b, 8);
    return b;
}

static void set_up(void)
{
    ck_assert(shape_box(&cube, vec3_make(1, 1, 1), 1).ok);
    ck_assert(shape_box(&tile, vec3_make(2, 1, 4), 1).ok);
    ck_assert(rigid4_build(&cube4, &cube).ok && rigid4_build(&tile4, &tile).ok);
    bodies = 0;
    cache = (contact_cache){
        .pairs = { .pair = pair },
        .entry = entry, .was = was, .placed = placed, .placing = placing,
        .vertex = vertex, .first = first, .last = end_of,
        .room = BODIES };
    frame = (cache_frame){ .body = of, .now = now, .ahead = ahead,
                           .moves = moves, .awake = number,
                           .plane = &ground, .stay = 0.03 };
    memset(was, 0, sizeof was);
    add(false, vec3_make(0, 0.5, 0));
}

static void tear_down(void)
{
    free(cache.met);
    rigid4_free(&cube4);
    rigid4_free(&tile4);
    shape_free(&cube);
    shape_free(&tile);
}

// Vertex v of a box is at +x, +y, +z for bits 0, 1, 2.
static contact_point touch_of(int a, int va, int b, int vb)
{
    return (contact_point){ .local_a = of[a].rigid->local[va],
                            .local_b = of[b].rigid->local[vb], .own = 1 };
}

// Body A has been found to touch b along n, with its vertices va at b's vb.
static contact *found(int b, vec3 n, int count, const int *va, const int *vb)
{
    int k = cache.pairs.count++;
    contact *c = &entry[k].contact;
    pair[k] = (cache_pair){ .key = { A, b }, .entry = k, .seen = { 1, 1 },
                            .is_asked = true, .is_active = true,
                            .count = (signed char)count };
    *c = (contact){ .a = A, .b = b, .piece_a = A, .piece_b = b, .count = count,
                    .normal = n };
    for (int i = 0; i < count; i++) c->point[i] = touch_of(A, va[i], b, vb[i]);
    return c;
}

// The four lower corners of A, on top of b.
static contact *found_below(int b)
{
    const int low[4] = { 0, 1, 4, 5 }, top[4] = { 2, 3, 6, 7 };
    contact *c = found(b, UP, 4, low, top);
    for (int k = 0; k < 4; k++) {
        vec3 at = frame_point(&placed[A], c->point[k].local_a);
        at.y = placed[b].center.y + 0.5;
        vec3 d = vec3_sub(at, placed[b].center);
        for (int i = 0; i < FOUR_AXES; i++) {
            real along = vec3_dot(d, placed[b].axis[i])
                       / vec3_length_squared(placed[b].axis[i]);
            if (i == 0) c->point[k].local_b.x = along;
            if (i == 1) c->point[k].local_b.y = along;
            if (i == 2) c->point[k].local_b.z = along;
        }
    }
    return c;
}

// A's lower front edge, at the side of b that faces it.
static contact *found_ahead(int b)
{
    const int low[2] = { 1, 5 }, edge[2] = { 2, 6 };
    return found(b, BACK, 2, low, edge);
}

static void mend(void)
{
    frame.awakes = bodies;
    for (int k = 0; k < cache.pairs.count; k++)
        pair[k].was = was[k].count > 0 ? k : -1;
    seams_correct(&cache, &frame);
}

static real lowest_point(const contact *c)
{
    real least = HUGE_VAL;
    for (int k = 0; k < c->count; k++)
        least = fmin(least, frame_point(&placed[c->a], c->point[k].local_a).y);
    return least;
}

// --- behind ------------------------------------------------------------------

// The cube stands on one tile, half of it over the next, and a query found that
// it is nearest to the side between the two.
// Rejects: a hidden side that stops what slides over it.
START_TEST(side_of_a_flush_tile_is_met_from_above)
{
    int one = add(true, vec3_make(-1, -0.5, 0));
    int next = add(true, vec3_make(1, -0.5, 0));
    contact *below = found_below(one), *c = found_ahead(next);
    mend();
    near_vec3(c->normal, UP, ROUNDING);
    ck_assert_int_eq(c->count, 4);
    ck_assert_int_eq(pair[1].count, 4);
    near(lowest_point(c), 0, ROUNDING);
    near_vec3(below->normal, UP, 0);
    ck_assert_int_eq(below->count, 4);
}
END_TEST

// The same, when the cube has not reached it, and does not in this frame.
// Rejects: a contact with what lies beside A.
START_TEST(tile_that_is_not_reached_is_not_met)
{
    int one = add(true, vec3_make(-0.5, -0.5, 0));
    int next = add(true, vec3_make(1.51, -0.5, 0));
    found_below(one);
    contact *c = found_ahead(next);
    mend();
    ck_assert_int_eq(c->count, 0);
    ck_assert(pair[1].count == 0 && !pair[1].is_active);
    // But if it goes so far, it is, where it will be.
    ahead[A].delta = vec3_make(0.3, 0, 0);
    ahead[A].reach = 0.32;
    cache.pairs.count = 1;
    c = found_ahead(next);
    mend();
    ck_assert_int_eq(c->count, 4);
    near_vec3(c->normal, UP, ROUNDING);
}
END_TEST

// Tops that are off by less than a contact gives way, of the smaller radius,
// 0.87 m, are flush.
// Rejects: a step that stops nothing; a wall that is gone through; a tolerance in
// metres.
START_TEST(step_is_met_and_a_lower_tile_is_not)
{
    const real flush = CONTACT_GIVES * cube4.reach;
    const real higher[] = { -0.5, -2 * flush, -0.9 * flush, 0.9 * flush,
                            1.1 * flush, 0.5 };
    for (int k = 0; k < 6; k++) {
        bodies = 1;
        cache.pairs.count = 0;
        int one = add(true, vec3_make(-0.5, -0.5, 0));
        int next = add(true, vec3_make(1.5, -0.5 + higher[k], 0));
        found_below(one);
        contact *c = found_ahead(next);
        mend();
        if (higher[k] > flush) {
            near_vec3(c->normal, BACK, ROUNDING);
            ck_assert_int_eq(c->count, 2);
        } else {
            ck_assert_msg(c->count == 0 || c->normal.y > 0.99, "%g m higher",
                          higher[k]);
        }
    }
}
END_TEST

// The tile after the next lies behind the side of the next, which is hidden, and
// behind the top of the first.
// Rejects: a hidden side that is taken for one which holds A.
START_TEST(hidden_side_hides_nothing)
{
    int one = add(true, vec3_make(-1, -0.5, 0));
    int next = add(true, vec3_make(1, -0.5, 0));
    int last = add(true, vec3_make(3, -0.5, 0));
    found_below(one);
    found_ahead(next);
    contact *c = found_ahead(last);
    ahead[A].delta = vec3_make(2, 0, 0);
    ahead[A].reach = 2.02;
    mend();
    near_vec3(c->normal, UP, ROUNDING);
    ck_assert_int_eq(c->count, 4);
}
END_TEST

// Each of the two pieces lies behind the plane in which A touches the other.
// Rejects: a ridge of which one side is not met.
START_TEST(ridge_is_met_on_both_sides)
{
    const int low[2] = { 1, 5 }, edge[2] = { 2, 6 };
    int one = add(true, vec3_make(-0.5, -0.5, 0));
    int next = add(true, vec3_make(1.5, -0.5, 0));
    vec3 aslant = { 0.6, 0.8, 0 };
    found_below(one);
    contact *c = found(next, aslant, 2, low, edge);
    mend();
    near_vec3(c->normal, aslant, 0);
    ck_assert_int_eq(c->count, 2);
}
END_TEST

// Rejects: a blade that hides what it leaves in this frame; pieces of one body
// that moves, which hide nothing.
START_TEST(piece_that_moves_away_hides_nothing)
{
    for (int k = 0; k < 3; k++) {
        bodies = 1;
        cache.pairs.count = 0;
        int one = add(true, vec3_make(-1, -0.5, 0));
        int next = add(true, vec3_make(1, -0.5, 0));
        moves[one] = 1;
        now[one].is_driven = true;
        if (k == 1) ahead[one].angle = 0.1;
        else        ahead[one].delta = vec3_make(0, 0, 0.1);
        if (k == 2) of[one].family = of[next].family = 7;
        found_below(one);
        contact *c = found_ahead(next);
        mend();
        near_vec3(c->normal, k == 2 ? UP : BACK, ROUNDING);
    }
}
END_TEST

// Rejects: planes that hide nothing.
START_TEST(side_behind_a_plane_is_met_from_above)
{
    int next = add(true, vec3_make(1.5, -0.5, 0));
    ground = (plane){ UP, 0 };
    contact *c = found_ahead(next), *on = &entry[PAIRS].contact;
    *on = (contact){ .a = A, .b = contact_with_plane(0), .piece_a = A,
                     .piece_b = contact_with_plane(0), .count = 1,
                     .normal = UP };
    pair[cache.pairs.count++] = (cache_pair){
        .key = { A, contact_with_plane(0) }, .entry = PAIRS, .is_asked = true,
        .count = 1 };
    mend();
    ck_assert(c->count == 0 || c->normal.y > 0.99);
}
END_TEST

// --- covered -----------------------------------------------------------------

// B's top lies inside of C, a tile that reaches higher, and A was found on it.
// Rejects: what is covered holds A up; what sticks out of C does not.
START_TEST(face_inside_of_another_piece_is_not_met)
{
    int in = add(true, vec3_make(0, -0.5, 0));
    int over = add(true, vec3_make(0.2, -0.3, 0));
    contact *c = found_below(in);
    const int low[1] = { 1 }, top[1] = { 3 };
    contact *d = found(over, UP, 1, low, top);
    mend();
    ck_assert(c->count == 0 || !(c->normal.y > 0.99));
    ck_assert_int_eq(d->count, 1);
}
END_TEST

// Rejects: pieces that overlap, and lie flush, of which one hides the other.
START_TEST(pieces_that_overlap_hold_both)
{
    int one = add(true, vec3_make(0, -0.5, 0));
    int next = add(true, vec3_make(0.2, -0.5, 0));
    contact *c = found_below(one), *d = found_below(next);
    mend();
    near_vec3(c->normal, UP, 0);
    near_vec3(d->normal, UP, 0);
    ck_assert(c->count == 4 && d->count == 4);
}
END_TEST

// --- one floor ---------------------------------------------------------------

static void lay_two(int family, int other, real lower)
{
    int one = add(true, vec3_make(-1, -0.5, 0));
    int next = add(true, vec3_make(1, -0.5 - lower, 0));
    of[one].family = family;
    of[next].family = other;
    found_below(one);
    found_below(next);
}

// Rejects: eight points where four corners are; loads that are lost, or given
// twice; a piece that a later frame takes for one that is not there.
START_TEST(pieces_in_one_plane_are_one_floor)
{
    lay_two(7, 7, 0);
    for (int k = 0; k < 2; k++) {
        was[k] = (contact){ .piece_a = A, .normal = UP, .friction = { 1, 0, 0 },
                            .twist = 0.5, .count = 2 };
        for (int i = 0; i < 2; i++) {
            was[k].point[i].local_a = cube4.local[k ? 1 + 4 * i : 4 * i];
            was[k].impulse[i] = 1 + i + 2 * k;
        }
    }
    mend();
    const contact *c = &entry[0].contact;
    ck_assert_int_eq(c->count, 4);
    ck_assert(pair[1].count == 0 && pair[1].is_merged && !pair[1].is_active);
    for (int k = 0; k < 4; k++) {
        vec3 own = frame_point(&placed[A], c->point[k].local_a);
        vec3 foot = frame_point(&placed[c->b], c->point[k].local_b);
        near_vec3(own, foot, ROUNDING);
        near(fabs(own.x), 0.5, ROUNDING);
        // 1 and 2 at the back, 3 and 4 in front.
        near(c->impulse[k], (own.x > 0 ? 3 : 1) + (own.z > 0), ROUNDING);
    }
    near_vec3(c->friction, vec3_make(2, 0, 0), ROUNDING);
    near(c->twist, 1, ROUNDING);
}
END_TEST

// A third piece was left in this frame: 5 of load at A's corner in front.
// Rejects: a load that is lost, so that A sinks at every seam; one that is handed
// on to another body's piece, or to a face that looks elsewhere.
START_TEST(load_of_a_piece_that_was_left_goes_on)
{
    const int family[] = { 7, 8, 7 };
    for (int k = 0; k < 3; k++) {
        bodies = 1;
        cache.pairs.count = 0;
        lay_two(7, 7, 0);
        int left = add(true, vec3_make(-3, -0.5, 0));
        of[left].family = family[k];
        found(left, UP, 0, NULL, NULL);
        was[2] = (contact){ .piece_a = A, .piece_b = left, .count = 1,
                            .normal = k < 2 ? UP : BACK, .twist = 0.5 };
        was[2].point[0].local_a = cube4.local[1];
        was[2].impulse[0] = 5;
        mend();
        near(contact_load(&entry[0].contact), k == 0 ? 5 : 0, ROUNDING);
        near(entry[0].contact.twist, k == 0 ? 0.5 : 0, ROUNDING);
    }
}
END_TEST

// What goes along x leaves the first of two pieces sooner.
// Rejects: a contact with the piece that is left next, with its load.
START_TEST(floor_is_met_in_the_piece_that_is_left_last)
{
    ahead[A].delta = vec3_make(0.1, 0, 0);
    lay_two(7, 7, 0);
    mend();
    ck_assert(entry[0].contact.count == 0 && pair[0].is_merged);
    ck_assert_int_eq(entry[1].contact.count, 4);
}
END_TEST

// Rejects: two bodies, perhaps of two materials, in one contact; pieces at two
// heights.
START_TEST(only_flush_pieces_of_one_body_are_one_floor)
{
    const int other[] = { 0, 8, 7 };
    const real lower[] = { 0, 0, 0.01 };
    for (int k = 0; k < 3; k++) {
        bodies = 1;
        cache.pairs.count = 0;
        lay_two(k == 0 ? 0 : 7, other[k], lower[k]);
        mend();
        ck_assert(entry[0].contact.count > 0 && entry[1].contact.count > 0);
    }
}
END_TEST

// Rejects: A's own face as the plane of touch, which leans as A rocks: a push
// forwards or back where there is no friction.
START_TEST(normal_of_a_floor_is_that_of_its_face)
{
    int one = add(true, vec3_make(0, -0.5, 0));
    contact *c = found_below(one);
    c->normal = vec3_unit(vec3_make(0.01, 1, 0.005));
    mend();
    near_vec3(c->normal, UP, ROUNDING);
    c->normal = vec3_unit(vec3_make(0.03, 1, 0));
    vec3 leans = c->normal;
    mend();
    near_vec3(c->normal, leans, 0);
}
END_TEST

// --- who slides --------------------------------------------------------------

// Rejects: a heap of like bodies whose contacts are all asked; a small body as
// the floor of a large one.
START_TEST(floor_does_not_move_or_is_large)
{
    int b = add(true, vec3_make(1, -0.5, 0));
    ck_assert_int_eq(seams_slider(&frame, A, b), A);
    ck_assert_int_eq(seams_slider(&frame, b, A), A);
    ck_assert_int_eq(seams_slider(&frame, A, contact_with_plane(0)), A);
    moves[b] = 1;
    now[b].radius = 1.9 * now[A].radius;
    ck_assert_int_eq(seams_slider(&frame, A, b), -1);
    now[b].is_driven = true;
    ck_assert_int_eq(seams_slider(&frame, A, b), A);
    now[b].is_driven = false;
    now[b].radius = 2.1 * now[A].radius;
    ck_assert_int_eq(seams_slider(&frame, b, A), A);
    now[b].radius = now[A].radius / 2.1;
    ck_assert_int_eq(seams_slider(&frame, A, b), b);
    moves[A] = moves[b] = 0;
    ck_assert_int_eq(seams_slider(&frame, A, b), -1);
}
END_TEST

// Rejects: what was found in an earlier frame, and mended then, mended again.
START_TEST(contact_that_was_not_asked_stays_as_it_is)
{
    int one = add(true, vec3_make(-1, -0.5, 0));
    int next = add(true, vec3_make(1, -0.5, 0));
    found_below(one);
    contact *c = found_ahead(next);
    pair[1].is_asked = false;
    contact before = *c;
    mend();
    ck_assert(memcmp(&before, c, sizeof before) == 0);
}
END_TEST

// --- the plain form ----------------------------------------------------------

enum { PIECES = 3 };

// The cube stands anyhow on a row of tiles: it has turned about the vertical, and
// sunk by a share of what bears.  Of every other one a corner is just past a seam, by
// no more than it has sunk; the last tile may be lower.
static void lay_cube(unsigned long long *seed, plain_piece piece[PIECES])
{
    real turn = random_between(seed, 0, 1.5), flush = CONTACT_GIVES * cube4.reach;
    real sunk = random_between(seed, 0.05, 0.5) * flush;
    real past = random_below(seed, 2) ? random_fraction(seed) * sunk
                                      : random_between(seed, 0, 1);
    real middle = (cos(turn) + sin(turn)) / 2 - 1 - past;
    real lower = random_below(seed, 2) ? 0 : random_fraction(seed);
    particle p[FOUR];
    for (int k = 0; k < FOUR; k++) {
        vec3 x = cube4.at[k];
        p[k].position = vec3_make(x.x * cos(turn) + x.z * sin(turn), x.y + 0.5 - sunk,
                                  x.z * cos(turn) - x.x * sin(turn));
    }
    placed[A] = now[A].frame = rigid4_frame(p);
    rigid4_ride(&cube4, &placed[A], vertex + 8 * A, 8);
    for (int k = 0; k < PIECES; k++) {
        vec3 at = { middle + 2 * (k - 1), -0.5 - (k == 2 ? lower : 0), 0 };
        piece[k] = plain_box(at, vec3_make(1, 0.5, 2));
        add(true, at);
    }
}

// What the query and the manifold find with piece b.
static contact *find_contact(int b)
{
    int k = cache.pairs.count;
    collider x = cache_collider(&cache, &frame, A), y = cache_collider(&cache, &frame, b);
    query_cache none = { .count = 0 };
    query_result q = query_nearest(&x, &y, 0.02, &none);
    if (!q.near) return NULL;
    manifold m = manifold_find(&x, &y, &q, 0.02, 0);
    contact *c = found(b, q.normal, 0, NULL, NULL);
    cache_take(c, &m, &frame, false);
    pair[k].count = (signed char)c->count;
    return c;
}

// All corners of the cube that are in piece b leave it by the side along which the
// contact was found.
static int compare(const plain_piece piece[PIECES], int b, const contact *c)
{
    int compared = 0;
    for (int v = 0; v < 8; v++) {
        vec3 p = vertex[8 * A + v];
        if (!plain_holds(&piece[b], p)) continue;
        int k = plain_way_out(piece, PIECES, b, p, 1e-6);
        ck_assert(k >= 0 && c && c->count > 0);
        near_vec3(c->normal, piece[b].side[k].normal, ROUNDING);
        compared++;
    }
    return compared;
}

// Rejects, in either form: a side between two tiles that is met; a tile that is lower
// and hides the one before it.
START_TEST(cube_on_any_tiles_is_met_as_the_plain_form_says)
{
    unsigned long long seed = 5;
    int sideways = 0, compared = 0;
    for (int round = 0; round < 3000; round++) {
        plain_piece piece[PIECES];
        contact *c[PIECES];
        bodies = 1;
        cache.pairs.count = 0;
        lay_cube(&seed, piece);
        for (int b = 0; b < PIECES; b++) {
            c[b] = find_contact(1 + b);
            sideways += c[b] && fabs(c[b]->normal.y) < 0.5;
        }
        mend();
        for (int b = 0; b < PIECES; b++) compared += compare(piece, b, c[b]);
    }
    ck_assert_int_ge(sideways, 500);
    ck_assert_int_ge(compared, 9000);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        side_of_a_flush_tile_is_met_from_above,
        tile_that_is_not_reached_is_not_met,
        step_is_met_and_a_lower_tile_is_not,
        hidden_side_hides_nothing,
        ridge_is_met_on_both_sides,
        piece_that_moves_away_hides_nothing,
        side_behind_a_plane_is_met_from_above,
        face_inside_of_another_piece_is_not_met,
        pieces_that_overlap_hold_both,
        pieces_in_one_plane_are_one_floor,
        load_of_a_piece_that_was_left_goes_on,
        floor_is_met_in_the_piece_that_is_left_last,
        only_flush_pieces_of_one_body_are_one_floor,
        normal_of_a_floor_is_that_of_its_face,
        floor_does_not_move_or_is_large,
        contact_that_was_not_asked_stays_as_it_is,
        cube_on_any_tiles_is_met_as_the_plain_form_says,
        NULL
    };
    return suite_run((suite){ .name = "seams", .tests = tests,
                              .set_up = set_up, .tear_down = tear_down });
}
