// check_certificate.c - cloth never crosses cloth, whatever is asked of it.
// Book: chapter 16.

#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "certificate.h"
#include "crossings.h"
#include "plain_proof.h"
#include "random.h"
#include "suite.h"

enum { SIDE = 6, SHEETS = 2, EACH = SIDE * SIDE, ALL = SHEETS * EACH,
       FACES = SHEETS * 2 * (SIDE - 1) * (SIDE - 1) };

static const real SPACING = 0.1, FRAME = 1.0 / 60, AGE = 1.0 / 240;

static shape cloth;
static body sheet[SHEETS];
static bool asleep[SHEETS];
static particle at[ALL];
static certificate proof;
static soft_frame frame;
static const int both[SHEETS] = { 0, 1 };

static void set_up(void)
{
    real side = SPACING * (SIDE - 1);
    ck_assert(shape_cloth(&cloth, SIDE, SIDE, side, side, 1, 0.2).ok);
    for (int b = 0; b < SHEETS; b++)
        sheet[b] = (body){ .shape = &cloth, .first = b * EACH, .mass = 1,
                           .thickness = 0.55 * SPACING, .group = 1, .mask = 1 };
    proof = (certificate){ .particles = 0 };
    ck_assert(certificate_grow(&proof, 0, ALL).ok);
    frame = (soft_frame){ .body = sheet, .asleep = asleep, .bodies = SHEETS,
                          .soft = both, .softs = SHEETS,
                          .particle = at, .certified = true,
                          .frame = FRAME, .whole = FRAME,
                          .age = AGE, .h = AGE,
                          .stiff_substeps = 16 };
}

// A way begins that takes a frame.
static void begin(void)
{
    certificate_begin(&proof, &frame, NULL);
    proof.since = FRAME;
}

static void tear_down(void)
{
    certificate_free(&proof);
    shape_free(&cloth);
}

// Two sheets that lie on each other in waves, at rest; apart < 0: the second under
// the first.
static void lay(unsigned long long *seed, real apart)
{
    real wave = random_between(seed, 0, 0.3 * fabs(apart));
    for (int v = 0; v < ALL; v++) {
        vec3 x = cloth.at[v % EACH];
        real up = v / EACH * apart + wave * sin(20 * x.x) * cos(15 * x.z);
        at[v].position = at[v].previous = vec3_make(x.x, up, x.z);
        at[v].inverse_mass = EACH;
    }
}

static vec3 any(unsigned long long *seed)
{
    real x = random_real(seed), y = random_real(seed);
    return vec3_make(x, y, random_real(seed));
}

static void move(int v, vec3 by)
{
    at[v].position = vec3_add(at[v].position, by);
    at[v].previous = vec3_add_scaled(at[v].position, -AGE / FRAME, by);
}

// Every vertex for itself, or a sheet through the other, or a sheet crumpled
// towards a point.
static void demand(unsigned long long *seed)
{
    int kind = random_below(seed, 4);
    real far = SPACING * random_between(seed, 0.1, 3);
    vec3 way = vec3_scale(3 * far, any(seed)), to = vec3_scale(0.5, any(seed));
    for (int v = 0; v < ALL; v++) {
        vec3 by = vec3_scale(kind == 3 ? 0 : far, any(seed));
        if (kind == 1 && v < EACH) by = vec3_add(by, way);
        if (kind >= 2)
            by = vec3_add_scaled(by, 0.7, vec3_sub(to, at[v].position));
        move(v, by);
    }
}

static long crossing_now(void)
{
    static patch x[FACES];
    static vec3 place[ALL];
    int n = 0;
    for (int v = 0; v < ALL; v++) place[v] = at[v].position;
    for (int b = 0; b < SHEETS; b++)
        for (int k = 0; k < cloth.mesh.faces; k++)
            x[n++] = patch_make(place + b * EACH, &cloth.face[3 * k], b * EACH);
    // The numbers of a patch are those of the pool.
    return crossings_count_slowly(x, n);
}

START_TEST(whoever_starts_uncrossed_never_crosses)
{
    unsigned long long seed = (unsigned long long)_i + 1;
    lay(&seed, SPACING * random_between(&seed, 0.05, 1) * (_i % 2 ? 1 : -1));
    ck_assert_int_eq(crossing_now(), 0);
    long without = 0;
    for (int f = 0; f < 6; f++) {
        begin();
        demand(&seed);
        without += crossing_now();
        certificate_end(&proof, &frame, NULL, NULL);
        ck_assert_int_eq(crossing_now(), 0);
        ck_assert_int_eq(proof.left_out, 0);
    }
    // So it was asked to.
    ck_assert_int_gt(without, 0);
}
END_TEST

// --- the checker -------------------------------------------------------------

enum { MOST = 100000 };
static witness told[MOST];
static int count;
static vec3 start[ALL];

// Room for all witnesses, however many.
static void make_room(void)
{
    free(proof.kept);
    proof.kept = calloc(MOST, sizeof *proof.kept);
    ck_assert_ptr_nonnull(proof.kept);
    proof.room = MOST;
}

// What is kept when a way has ended; of a patch, the range around both its parts.
static void listen(void)
{
    ck_assert_int_gt(proof.keeps, 0);
    ck_assert_int_le(proof.keeps, proof.room);
    count = 0;
    for (int k = 0; k < proof.keeps; k++) {
        witness w = proof.kept[k];
        cell_range *a = &w.set[0].part.cells, b = w.set[1].part.cells;
        if (w.kind != WITNESS_PLANE && w.kind != WITNESS_NONE) {
            w.kind = WITNESS_SPREAD;
            *a = (cell_range){ a->body, int_min(a->left, b.left), int_min(a->top, b.top),
                               int_max(a->right, b.right), int_max(a->bottom, b.bottom) };
        }
        told[count++] = w;
    }
}

static bool has(const certified_set *s, int v)
{
    if (s->count > 0) {
        for (int i = 0; i < s->count; i++)
            if (s->vertex[i] == v) return true;
        return false;
    }
    int column = v % EACH % SIDE, row = v % EACH / SIDE;
    return s->part.cells.body == v / EACH
        && column >= s->part.cells.left && column <= s->part.cells.right
        && row >= s->part.cells.top && row <= s->part.cells.bottom;
}

static bool has_all(const certified_set *s, const int *v, int n)
{
    bool all = true;
    for (int i = 0; i < n; i++) all &= has(s, v[i]);
    return all;
}

static void replay_plane(const witness *w, const vec3 *x)
{
    real low = HUGE_VAL, high = -HUGE_VAL;
    for (int v = 0; v < ALL; v++) {
        if (has(&w->set[0], v)) low = fmin(low, vec3_dot(w->normal[0], x[v]));
        if (has(&w->set[1], v)) high = fmax(high, vec3_dot(w->normal[0], x[v]));
    }
    ck_assert(low < HUGE_VAL && high > -HUGE_VAL && low > high);
}

static void replay_spread(const witness *w, const vec3 *x)
{
    for (int k = 0; k < cloth.mesh.faces; k++) {
        int v[3], first = w->set[0].part.cells.body * EACH;
        for (int i = 0; i < 3; i++) v[i] = first + cloth.face[3 * k + i];
        if (!has_all(&w->set[0], v, 3)) continue;
        vec3 e = { 0, 0, 0 }, f = e;
        for (int i = 0; i < 9; i++) {
            int a = v[i / 3], b = v[i % 3];
            if (b == a + 1) e = vec3_sub(x[b], x[a]);
            if (b == a + SIDE) f = vec3_sub(x[b], x[a]);
        }
        real ee = vec3_dot(w->normal[0], e), ef = vec3_dot(w->normal[0], f);
        real fe = vec3_dot(w->normal[1], e), ff = vec3_dot(w->normal[1], f);
        ck_assert(ee > 0 && ff > 0 && 4 * ee * ff > (ef + fe) * (ef + fe));
    }
}

static bool is_told(const int *a, int m, const int *b, int n)
{
    for (int k = 0; k < count; k++) {
        const witness *w = &told[k];
        if (w->kind == WITNESS_SPREAD && has_all(&w->set[0], a, m)
            && has_all(&w->set[0], b, n)) return true;
        if (w->kind != WITNESS_PLANE) continue;
        if (has_all(&w->set[0], a, m) && has_all(&w->set[1], b, n)) return true;
        if (has_all(&w->set[1], a, m) && has_all(&w->set[0], b, n)) return true;
    }
    return false;
}

// As wholes, or every corner and edge.
static bool is_pair_told(const int a[3], const int b[3])
{
    bool all = true;
    if (is_told(a, 3, b, 3)) return true;
    for (int k = 0; k < 3; k++)
        all = all && is_told(&a[k], 1, b, 3) && is_told(a, 3, &b[k], 1);
    for (int k = 0; k < 9 && all; k++) {
        int e[2] = { a[k / 3], a[(k / 3 + 1) % 3] };
        int f[2] = { b[k % 3], b[(k % 3 + 1) % 3] };
        all = is_told(e, 2, f, 2);
    }
    return all;
}

static void corners_of(int k, int v[3])
{
    int faces = cloth.mesh.faces;
    for (int i = 0; i < 3; i++)
        v[i] = k / faces * EACH + cloth.face[3 * (k % faces) + i];
}

START_TEST(its_witnesses_are_replayed_by_dot_products)
{
    unsigned long long seed = (unsigned long long)_i + 77;
    static vec3 end[ALL];
    lay(&seed, SPACING * random_between(&seed, 0.05, 1));
    make_room();
    for (int f = 0; f < 2; f++) {
        for (int v = 0; v < ALL; v++) start[v] = at[v].position;
        begin();
        demand(&seed);
        certificate_end(&proof, &frame, NULL, NULL);
        listen();
        for (int v = 0; v < ALL; v++) end[v] = at[v].position;
        for (int k = 0; k < count; k++) {
            ck_assert_int_ne(told[k].kind, WITNESS_NONE);
            for (int e = 0; e < ENDS; e++)
                (told[k].kind == WITNESS_PLANE ? replay_plane : replay_spread)(
                    &told[k], e ? end : start);
        }
    }
    // No two triangles without a common vertex were forgotten.
    for (int i = 0; i < FACES; i++)
        for (int k = 0; k < i; k++) {
            int a[3], b[3];
            corners_of(i, a);
            corners_of(k, b);
            bool meet = false;
            for (int n = 0; n < 9; n++) meet |= a[n / 3] == b[n % 3];
            ck_assert(meet || is_pair_told(a, b));
        }
}
END_TEST

// One half of each sheet is sheared this way, the other that way, further and
// further.  Rejects: half of the mixed term, which takes cells sheared by 2.4
// times their height for spread out.
START_TEST(no_patch_of_sheared_cloth_is_taken_for_spread_out)
{
    make_room();
    for (real shear = 0; shear < 4; shear += 0.1) {
        unsigned long long seed = 1;
        static vec3 end[ALL];
        lay(&seed, 20 * SPACING);
        for (int v = 0; v < ALL; v++) {
            real x = at[v].position.x, side = x > 0 ? 1 : -1;
            at[v].position.x += shear * side * at[v].position.z;
        }
        begin();
        move(0, vec3_make(0, 1e-5, 0));
        certificate_end(&proof, &frame, NULL, NULL);
        listen();
        for (int v = 0; v < ALL; v++) end[v] = at[v].position;
        for (int k = 0; k < count; k++)
            if (told[k].kind == WITNESS_SPREAD) replay_spread(&told[k], end);
    }
}
END_TEST

// --- the plain form ----------------------------------------------------------

static int face_of[FACES][3];
static vec3 from[ALL], asked[ALL], by_plain[ALL];

static plain_cloth plain_form(void)
{
    for (int k = 0; k < FACES; k++) corners_of(k, face_of[k]);
    for (int v = 0; v < ALL; v++) by_plain[v] = asked[v] = at[v].position;
    return (plain_cloth){ ALL, FACES, (const int (*)[3])face_of, from, by_plain };
}

// Of the straight ways from `from` to `end`, in this many places.
static long crossing_on_the_way(const vec3 *end)
{
    enum { PLACES = 16 };
    long sum = 0;
    for (int k = 1; k <= PLACES; k++) {
        for (int v = 0; v < ALL; v++)
            at[v].position = vec3_add_scaled(from[v], (real)k / PLACES,
                                             vec3_sub(end[v], from[v]));
        sum += crossing_now();
    }
    return sum;
}

// One sheet under the other: every vertex a little, while all fall by fifty
// spacings, or what asks for crossings.
static void ask(int round)
{
    unsigned long long seed = (unsigned long long)round + 400;
    lay(&seed, SPACING * random_between(&seed, 0.05, 1) * (round % 2 ? 1 : -1));
    for (int v = 0; v < ALL; v++) from[v] = at[v].position;
    begin();
    if (round % 4) demand(&seed);
    for (int v = 0; v < ALL && round % 4 == 0; v++)
        move(v, vec3_add(vec3_make(0, -50 * SPACING, 0),
                         vec3_scale(0.005 * SPACING, any(&seed))));
}

// Rejects, in either form: triangles that are apart at both ends, and cross on the
// way; edges that are not asked; a certificate that finds no plane where there are
// planes for all corners, edges and triangles.
START_TEST(plain_form_and_certificate_let_nothing_cross_on_the_way)
{
    int calm = 0, busy = 0;
    static vec3 by_certificate[ALL];
    for (int round = 0; round < 40; round++) {
        ask(round);
        plain_cloth c = plain_form();
        int halved = plain_proof(&c);
        certificate_end(&proof, &frame, NULL, NULL);
        for (int v = 0; v < ALL; v++) by_certificate[v] = at[v].position;
        busy += crossing_on_the_way(asked) > 0;
        ck_assert_int_eq(crossing_on_the_way(by_plain), 0);
        ck_assert_int_eq(crossing_on_the_way(by_certificate), 0);
        if (halved > 0) continue;
        calm++;
        ck_assert_int_eq(proof.prevented, 0);
        ck_assert(memcmp(by_certificate, asked, sizeof asked) == 0);
    }
    ck_assert_int_ge(calm, 10);
    ck_assert_int_ge(busy, 20);
}
END_TEST

// --- what it does, and does not ----------------------------------------------

START_TEST(what_does_not_cross_keeps_its_bits)
{
    unsigned long long seed = 5;
    static particle before[ALL];
    lay(&seed, SPACING);
    begin();
    for (int v = 0; v < ALL; v++) {
        vec3 x = at[v].position;
        move(v, vec3_make(x.z * x.z, 3 + x.x * x.x, 0.1 * x.y));
    }
    memcpy(before, at, sizeof at);
    certificate_end(&proof, &frame, NULL, NULL);
    ck_assert_int_eq(proof.prevented, 0);
    ck_assert(memcmp(before, at, sizeof at) == 0);
}
END_TEST

// The one above goes half around the other in a frame, so far from it that they
// never meet; but from its first place to its last, straight, it goes through.
static long turns_around(int pieces)
{
    unsigned long long seed = 8;
    long prevented = 0;
    lay(&seed, 4 * SPACING);
    begin();
    proof.since = 0;
    frame.h = FRAME / pieces;
    for (int k = 1; k <= pieces; k++) {
        real turn = k * acos(-1) / pieces;
        for (int v = EACH; v < ALL; v++) {
            vec3 x = cloth.at[v - EACH], to = { x.x, 4 * SPACING, x.z };
            to = vec3_make(to.x * cos(turn) - to.y * sin(turn),
                           to.x * sin(turn) + to.y * cos(turn), to.z);
            move(v, vec3_sub(to, at[v].position));
        }
        if (certificate_is_due(&proof, &frame) || k == pieces) {
            certificate_end(&proof, &frame, NULL, NULL);
            prevented += proof.prevented;
        }
    }
    return prevented;
}

START_TEST(a_long_way_is_proved_piece_by_piece)
{
    ck_assert_int_gt(turns_around(1), 0);
    ck_assert_int_eq(turns_around(16), 0);
}
END_TEST

// By ten spacings in each substep, in rows of waves.
START_TEST(what_falls_as_one_is_proved_once_a_frame)
{
    unsigned long long seed = 9;
    lay(&seed, SPACING);
    certificate_begin(&proof, &frame, NULL);
    for (int k = 0; k < 4; k++) {
        for (int v = 0; v < ALL; v++) move(v, vec3_make(0, -10 * SPACING, 0));
        ck_assert(!certificate_is_due(&proof, &frame));
    }
    move(3, vec3_make(0, 0.9 * SPACING, 0));
    ck_assert(!certificate_is_due(&proof, &frame));
    move(3, vec3_make(0, 0.2 * SPACING, 0));
    ck_assert(certificate_is_due(&proof, &frame));
}
END_TEST

// It falls by five gaps on one that is nailed.
START_TEST(what_is_stopped_loses_its_speed_and_what_is_nailed_stays)
{
    unsigned long long seed = 3;
    real gap = 0.5 * SPACING;
    lay(&seed, gap);
    real lowest = HUGE_VAL;
    for (int v = 0; v < EACH; v++) {
        at[v].inverse_mass = 0;
        lowest = fmin(lowest, at[v].position.y);
    }
    // The upper one reaches over no rim.
    for (int v = EACH; v < ALL; v++)
        at[v].position = vec3_make(0.5 * at[v].position.x, gap,
                                   0.5 * at[v].position.z);
    begin();
    for (int v = 0; v < ALL; v++) start[v] = at[v].position;
    for (int v = EACH; v < ALL; v++) move(v, vec3_make(0, -5 * gap, 0));
    certificate_end(&proof, &frame, NULL, NULL);
    ck_assert_int_gt(proof.prevented, 0);
    ck_assert_int_eq(crossing_now(), 0);
    for (int v = 0; v < ALL; v++) {
        vec3 way = vec3_sub(at[v].position, start[v]);
        vec3 speed = vec3_scale(1 / AGE, vec3_sub(at[v].position,
                                                  at[v].previous));
        if (v < EACH) ck_assert(vec3_length(way) == 0);
        else ck_assert(at[v].position.y > lowest);
        vec3 off = vec3_sub(vec3_scale(1 / FRAME, way), speed);
        if (v >= EACH) ck_assert(vec3_length(off) < 1e-9);
    }
}
END_TEST

// kg m of all, and of each where it is now: free particles weigh what they do.
static void sums(vec3 *way, vec3 *place)
{
    *way = *place = (vec3){ 0, 0, 0 };
    for (int v = 0; v < ALL; v++) {
        real m = 1 / at[v].inverse_mass;
        *place = vec3_add_scaled(*place, m, at[v].position);
        *way = vec3_add_scaled(*way, m, vec3_sub(at[v].position,
                                                 at[v].previous));
    }
}

// Sheets of which one is three times as heavy.  Rejects: the middle between
// two that do not weigh the same; ways that are taken away; velocities that are
// left as they were.
START_TEST(what_is_free_keeps_its_momentum_and_loses_its_approach)
{
    unsigned long long seed = (unsigned long long)_i + 200;
    vec3 way, place, way_then, place_then;
    lay(&seed, 0.5 * SPACING);
    for (int v = 0; v < EACH; v++) at[v].inverse_mass = EACH / 3.0;
    begin();
    if (_i % 2) demand(&seed);
    for (int v = 0; v < ALL; v++)
        move(v, vec3_make(0, v < EACH ? SPACING : -SPACING, 0));
    sums(&way, &place);
    certificate_end(&proof, &frame, NULL, NULL);
    sums(&way_then, &place_then);
    ck_assert_int_gt(proof.prevented, 0);
    ck_assert(vec3_distance(way, way_then) < 1e-13);
    ck_assert(vec3_distance(place, place_then) < 1e-13);
    for (int v = 0; v < EACH && _i % 2 == 0; v++) {
        real lower = at[v].position.y - at[v].previous.y;
        real upper = at[EACH + v].position.y - at[EACH + v].previous.y;
        ck_assert(lower - upper < 2 * SPACING * AGE / FRAME);
    }
}
END_TEST

// Two sheets are crumpled and thrown through each other: more pairs clash than
// there are vertices.  Rejects: all stands still; each goes by its own mean way,
// and through the other.
static void ask_too_much(unsigned long long seed)
{
    vec3 way, place, way_then, place_then;
    real most = 0;
    lay(&seed, 0.5 * SPACING);
    begin();
    for (int v = 0; v < ALL; v++) {
        start[v] = at[v].position;
        move(v, vec3_add(vec3_make(0, v < EACH ? 0.6 : -0.2, 0),
                         vec3_scale(3 * SPACING, any(&seed))));
    }
    sums(&way, &place);
    certificate_end(&proof, &frame, NULL, NULL);
    sums(&way_then, &place_then);
    ck_assert_int_gt(proof.prevented, ALL);
    ck_assert_int_eq(crossing_now(), 0);
    ck_assert(vec3_distance(way, way_then) < 1e-12);
    for (int v = 0; v < ALL; v++)
        most = fmax(most, vec3_distance(start[v], at[v].position));
    ck_assert(most > 0.1 * SPACING);
}

START_TEST(what_asks_for_too_much_goes_a_part_of_it_and_keeps_its_momentum)
{
    for (unsigned k = 300; k < 308; k++) ask_too_much(k);
}
END_TEST

// An upright sheet stands through a lying one, and is drawn up and out.
START_TEST(what_crosses_already_is_left_out_and_goes_its_way)
{
    unsigned long long seed = 4;
    lay(&seed, SPACING);
    for (int v = EACH; v < ALL; v++) {
        vec3 x = cloth.at[v - EACH];
        at[v].position = vec3_make(0.6 * x.x, 0.013 + x.z, 0.03);
    }
    ck_assert_int_gt(crossing_now(), 0);
    real low = at[EACH].position.y;
    for (int f = 0; f < 60; f++) {
        begin();
        for (int v = EACH; v < ALL; v++) move(v, vec3_make(0, 0.1 * SPACING, 0));
        certificate_end(&proof, &frame, NULL, NULL);
        if (f == 0) ck_assert_int_gt(proof.left_out, 0);
    }
    ck_assert_int_eq(crossing_now(), 0);
    ck_assert_int_eq(proof.left_out, 0);
    ck_assert(fabs(at[EACH].position.y - low - 6 * SPACING) < 0.01 * SPACING);
}
END_TEST

// The numbers of one vertex are lost.
START_TEST(lost_numbers_end_and_harm_no_other_sheet)
{
    unsigned long long seed = 6;
    lay(&seed, SPACING);
    begin();
    for (int v = 0; v < EACH; v++) move(v, vec3_make(0, -1, 0));
    at[EACH].position.x = NAN;
    certificate_end(&proof, &frame, NULL, NULL);
    for (int v = 0; v < EACH; v++)
        ck_assert(vec3_is_finite(at[v].position));
}
END_TEST

START_TEST(what_was_proved_is_asked_again_if_nothing_else_moved_it)
{
    unsigned long long seed = 3;
    lay(&seed, SPACING);
    begin();
    move(0, vec3_make(0, 1e-5, 0));
    certificate_end(&proof, &frame, NULL, NULL);
    int made = proof.made;
    ck_assert_int_gt(made, 0);
    ck_assert_int_eq(proof.keeps, made);
    // The first is a window. It is not asked, but what it has left is less.
    real slack = proof.kept[0].slack;
    for (int k = 0; k < 10; k++) {
        begin();
        move(k, vec3_make(0, 1e-5, 0));
        certificate_end(&proof, &frame, NULL, NULL);
        ck_assert_int_eq(proof.prevented, 0);
        ck_assert_int_eq(proof.keeps, made);
        ck_assert(proof.kept[0].slack < slack);
        slack = proof.kept[0].slack;
    }
    at[0].position.y += 1e-5;
    begin();
    ck_assert_int_eq(proof.keeps, 0);
}
END_TEST

// Few clash in each of many frames.  Rejects: clashes that are forgotten as soon
// as they have been parted once.
START_TEST(what_shivers_a_little_never_crosses)
{
    int prevented = 0;
    for (unsigned long long seed = 21; seed < 24; seed++) {
        unsigned long long state = seed;
        lay(&state, 0.2 * SPACING);
        for (int f = 0; f < 20; f++) {
            begin();
            for (int v = 0; v < ALL; v++)
                move(v, vec3_scale(0.3 * SPACING, any(&state)));
            certificate_end(&proof, &frame, NULL, NULL);
            prevented += proof.prevented;
            ck_assert_int_eq(crossing_now(), 0);
        }
    }
    ck_assert_int_gt(prevented, 0);
}
END_TEST

// Sheet 0 is crumpled so that more clash than there are vertices; the other, far
// above it, falls through it.  Rejects: witnesses that were not asked, for it was
// hopeless, and keep the room that they had.
START_TEST(what_is_hopeless_hides_no_other_crossing)
{
    unsigned long long seed = 11;
    const vec3 down = { 0, -40 * SPACING, 0 };
    lay(&seed, 0.1 * SPACING);
    for (int v = EACH; v < ALL; v++) at[v].position.y += 20 * SPACING;
    for (int f = 0; f < 2; f++) {
        begin();
        for (int v = 0; v < ALL && f > 0; v++)
            move(v, v < EACH ? vec3_scale(4 * SPACING, any(&seed)) : down);
        certificate_end(&proof, &frame, NULL, NULL);
    }
    ck_assert_int_gt(proof.prevented, ALL);
    ck_assert_int_eq(crossing_now(), 0);
    for (int v = 0; v < EACH; v++)
        ck_assert(at[v].position.y < at[EACH].position.y);
}
END_TEST

// Rejects: windows of sheets at rest.
START_TEST(what_sleeps_is_not_looked_at)
{
    unsigned long long seed = 12;
    lay(&seed, SPACING);
    asleep[0] = asleep[1] = true;
    begin();
    certificate_end(&proof, &frame, NULL, NULL);
    asleep[0] = asleep[1] = false;
    ck_assert_int_eq(proof.keeps, 0);
}
END_TEST

// A sheet sleeps, and meets no other; then a smaller one has its number.  Rejects:
// windows of a sheet of which nothing is asked, which is not found again when it is
// another one (half of its cells do not exist then).
START_TEST(what_nothing_is_asked_of_has_no_window)
{
    unsigned long long seed = 16;
    lay(&seed, SPACING);
    asleep[1] = true;
    sheet[1].group = sheet[1].mask = 2;
    begin();
    move(0, vec3_make(0, 1e-5, 0));
    certificate_end(&proof, &frame, NULL, NULL);
    asleep[1] = false;
    ck_assert_int_gt(proof.keeps, 0);
    for (int k = 0; k < proof.keeps; k++)
        ck_assert_int_eq(proof.kept[k].set[0].part.cells.body, 0);
}
END_TEST

// A second sheet sleeps, or meets nothing, while the first is proved; then it is
// crumpled.  Rejects: pairs that are kept although others are asked for.
static void ask_later(bool is_asleep)
{
    unsigned long long seed = 17;
    near_lists lists = { .is_stale = !is_asleep };
    lay(&seed, SPACING);
    for (int v = EACH; v < ALL; v++) at[v].position.y += 20 * SPACING;
    asleep[1] = is_asleep;
    sheet[1].mask = sheet[1].group = is_asleep;
    for (int f = 0; f < 2; f++) {
        certificate_begin(&proof, &frame, f ? &lists : NULL);
        proof.since = FRAME;
        if (f == 0) move(0, vec3_make(0, 1e-5, 0));
        for (int v = EACH; v < ALL && f > 0; v++)
            move(v, vec3_scale(2 * SPACING, any(&seed)));
        certificate_end(&proof, &frame, NULL, NULL);
        asleep[1] = false;
        sheet[1].mask = sheet[1].group = 1;
    }
    ck_assert_int_gt(proof.prevented, 0);
    ck_assert_int_eq(crossing_now(), 0);
}

START_TEST(what_begins_to_be_asked_for_is_found)
{
    ask_later(true);
    proof.keeps = 0;
    ask_later(false);
}
END_TEST

// What has been proved already ends once.  Rejects: a second proof of a way that
// has taken no time.
START_TEST(a_way_of_no_time_is_not_proved)
{
    unsigned long long seed = 13;
    lay(&seed, SPACING);
    begin();
    move(0, vec3_make(0, 1e-5, 0));
    certificate_end(&proof, &frame, NULL, NULL);
    real slack = proof.kept[0].slack;
    move(0, vec3_make(0, 1e-5, 0));
    certificate_end(&proof, &frame, NULL, NULL);
    ck_assert(proof.kept[0].slack == slack);
}
END_TEST

// Rejects: witnesses that become more for ever.
START_TEST(what_is_worn_to_pieces_is_all_found_again)
{
    unsigned long long seed = 14;
    lay(&seed, SPACING);
    for (int f = 0; f < 2; f++) {
        begin();
        move(0, vec3_make(0, 1e-5, 0));
        certificate_end(&proof, &frame, NULL, NULL);
        if (f == 0) proof.made = proof.keeps / 3;
    }
    ck_assert_int_eq(proof.made, proof.keeps);
}
END_TEST

// What hangs swings, and what lies keeps its patch.  Rejects: room that every
// patch loses by the furthest way of all.
START_TEST(a_patch_loses_room_by_its_own_ways_only)
{
    unsigned long long seed = 15;
    lay(&seed, SPACING);
    real slack[SHEETS] = { 0 };
    for (int f = 0; f < 2; f++) {
        begin();
        move(0, vec3_make(0, f * 1e-4, 0));
        certificate_end(&proof, &frame, NULL, NULL);
        for (int k = 0; k < proof.keeps; k++) {
            const witness *w = &proof.kept[k];
            int b = w->set[0].part.cells.body;
            if (w->kind != WITNESS_WINDOW) continue;
            if (f > 0 && b == 1) ck_assert(w->slack == slack[b]);
            if (f > 0 && b == 0) ck_assert(w->slack < slack[b]);
            slack[b] = w->slack;
        }
    }
    ck_assert(slack[0] > 0 && slack[1] > 0);
}
END_TEST

int main(void)
{
    const TTest *tests[] = {
        what_does_not_cross_keeps_its_bits,
        a_long_way_is_proved_piece_by_piece,
        what_nothing_is_asked_of_has_no_window,
        what_falls_as_one_is_proved_once_a_frame,
        what_is_stopped_loses_its_speed_and_what_is_nailed_stays,
        what_crosses_already_is_left_out_and_goes_its_way,
        lost_numbers_end_and_harm_no_other_sheet,
        what_was_proved_is_asked_again_if_nothing_else_moved_it,
        no_patch_of_sheared_cloth_is_taken_for_spread_out,
        what_shivers_a_little_never_crosses,
        what_is_hopeless_hides_no_other_crossing,
        what_sleeps_is_not_looked_at,
        what_begins_to_be_asked_for_is_found,
        a_way_of_no_time_is_not_proved,
        what_is_worn_to_pieces_is_all_found_again,
        a_patch_loses_room_by_its_own_ways_only,
        what_asks_for_too_much_goes_a_part_of_it_and_keeps_its_momentum,
        plain_form_and_certificate_let_nothing_cross_on_the_way,
        NULL
    };
    return suite_run((suite){
        .name = "certificate", .tests = tests, .set_up = set_up,
        .tear_down = tear_down, .seconds = 60,
        .repeated = { { whoever_starts_uncrossed_never_crosses, 0, 24 },
                      { its_witnesses_are_replayed_by_dot_products, 0, 6 },
                      { what_is_free_keeps_its_momentum_and_loses_its_approach,
                        0, 12 } } });
}
