// family_cloth.c - rows 170 to 179: rope and cloth.
//
// All is judged from the places of vertices, in every frame: what crosses, by
// the exact test of crossings.h; how far neighbours in a row or column are
// apart; how far a vertex went since the frame before.

#include "crossings.h"
#include "family.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

static const double STEPS[] = { 1.0 / 60, 1.0 / 120, 1.0 / 30 };
static const tumble_vec3 STILL = { 0, 0, 0 };

// ---- Sheets, ropes, and what they hang on ----------------------------------

enum { MOST_SIDE = 64, MOST_VERTICES = MOST_SIDE * MOST_SIDE };

// A cloth, or a rope of one row.
typedef struct {
    tumble_body body;
    int columns, rows;
    double width, depth;        // m
} sheet;

static sheet add_sheet(tumble_world *w, int columns, int rows, double width,
                       double depth, double mass, tumble_body_options o)
{
    tumble_shape s = rows > 1
        ? tumble_shape_cloth(w, columns, rows, width, depth, mass)
        : tumble_shape_rope(w, columns - 1, width, mass);
    return (sheet){ tumble_body_add(w, s, o), columns, rows, width, depth };
}

// A small body that meets nothing, to hang things on.
static tumble_body add_post(tumble_world *w, tumble_vec3 at, tumble_vec3 speed)
{
    tumble_body_options o = tumble_body_at(at.x, at.y, at.z);
    o.kind = TUMBLE_KINEMATIC;
    o.velocity = speed;
    o.mask = 0;
    return tumble_body_add(w, tumble_shape_box(w, tumble_v(0.05, 0.05, 0.05),
                                               1), o);
}

// Vertex i hangs on a post of its own, which goes at this speed.
static tumble_joint hang_up(tumble_world *w, const sheet *s, int i,
                            tumble_vec3 speed, tumble_body *post)
{
    *post = add_post(w, tumble_body_vertex(w, s->body, i), speed);
    return tumble_joint_hang(w, s->body, i, *post);
}

static void halt(tumble_world *w, tumble_body b)
{
    tumble_body_set_velocity(w, b, STILL, STILL);
}

// The largest |length / rest - 1| of neighbours in a row or a column.
static double strain(const tumble_world *w, const sheet *s)
{
    static tumble_vec3 at[MOST_VERTICES];
    int n = tumble_body_vertices(w, s->body, at, MOST_VERTICES);
    double most = 0;
    for (int i = 0; i < n; i++) {
        if (i % s->columns)
            most = hard_worse(most, fabs(v_distance(at[i], at[i - 1])
                                         * (s->columns - 1) / s->width - 1));
        if (i >= s->columns)
            most = hard_worse(most, fabs(v_distance(at[i], at[i - s->columns])
                                         * (s->rows - 1) / s->depth - 1));
    }
    return most;
}

// m/s, of the fastest vertex since this was last asked.
static double fastest(const tumble_world *w, const sheet *s, tumble_vec3 *was,
                      double dt)
{
    static tumble_vec3 at[MOST_VERTICES];
    int n = tumble_body_vertices(w, s->body, at, MOST_VERTICES);
    double most = 0;
    for (int i = 0; i < n; i++)
        most = hard_worse(most, v_distance(at[i], was[i]) / dt);
    memcpy(was, at, (size_t)n * sizeof *at);
    return most;
}

static vec3 as_vec3(tumble_vec3 a)
{
    return vec3_make(a.x, a.y, a.z);
}

// The triangles of some sheets, as patches.
enum { MOST_PATCHES = 8192 };
static patch found[MOST_PATCHES];

static int take_patches(const tumble_world *w, const sheet *s, int sheets)
{
    static tumble_vec3 at[MOST_VERTICES];
    static vec3 place[MOST_VERTICES];
    int count = 0, first = 0;
    for (int k = 0; k < sheets; k++) {
        int faces, n = tumble_body_vertices(w, s[k].body, at, MOST_VERTICES);
        const int *face = tumble_body_triangles(w, s[k].body, &faces);
        for (int i = 0; i < n; i++) place[i] = as_vec3(at[i]);
        for (int i = 0; i < faces && count < MOST_PATCHES; i++)
            found[count++] = patch_make(place, &face[3 * i], first);
        first += n;
    }
    return count;
}

// Pairs of triangles that cross, and edges of a rigid body that pass through
// one.
static long crossings(const tumble_world *w, const sheet *s, int sheets,
                      const tumble_body *body, int bodies)
{
    int n = take_patches(w, s, sheets);
    long count = crossings_count(found, n);
    for (int k = 0; k < bodies; k++) {
        static solid hard;
        tumble_vec3 at[8];
        vec3 corner[8];
        int faces, corners = tumble_body_vertices(w, body[k], at, 8);
        const int *face = tumble_body_triangles(w, body[k], &faces);
        for (int i = 0; i < 8; i++) corner[i] = as_vec3(at[i]);
        solid_make(&hard, corner, corners, face, faces);
        for (int i = 0; i < n; i++)
            count += solid_edges_through(&hard, &found[i]);
    }
    return count;
}

static tumble_world *begin(double dt, double friction)
{
    tumble_options o = family_options(dt, friction);
    o.sleep_speed = 0;
    return tumble_world_make(&o);
}

static tumble_body add_static(tumble_world *w, tumble_shape s, tumble_vec3 at,
                              tumble_quat turned)
{
    tumble_body_options o = tumble_body_at(at.x, at.y, at.z);
    o.kind = TUMBLE_STATIC;
    o.pose.rotation = turned;
    return tumble_body_add(w, s, o);
}

// ---- 170: sheets under heavy edges -----------------------------------------

// So many sheets on a table that they hang over, at rest; then a box of 30 cm
// is thrown on them, an edge or a corner first.
static void throw_box(hard_report *r, family_worst *end, family_worst *silent,
                      int sheets, double mass, double speed, int n, double dt)
{
    const tumble_quat level = { 0, 0, 0, 1 };
    sheet s[3];
    tumble_world *w = begin(dt, 0.5);
    add_static(w, tumble_shape_box(w, tumble_v(1.2, 0.5, 1.2), 1),
               tumble_v(0, -0.25, 0), level);
    tumble_plane_add(w, tumble_v(0, 1, 0), -1.2, -1);
    for (int k = 0; k < sheets; k++) {
        tumble_body_options o = tumble_body_at(0, (1 + 1.2 * k) * 1.6 / (n - 1),
                                               0);
        o.damping = 5;
        s[k] = add_sheet(w, n, n, 1.6, 1.6, 0.2, o);
    }
    family_run(w, 1.5);
    for (int k = 0; k < sheets; k++)
        tumble_body_set_damping(w, s[k].body, 0, 0);
    tumble_body_options o = tumble_body_at(0.1, 0.6 + 0.3 * sheets, 0.05);
    o.pose.rotation = tumble_quat_turn(tumble_v(1, 0.3, 0.8), 0.8);
    o.velocity = tumble_v(0.3 * speed, -speed, 0.1 * speed);
    o.spin = tumble_v(1, 3, 2);
    tumble_body box =
        tumble_body_add(w, tumble_shape_box(w, tumble_v(0.3, 0.3, 0.3), mass),
                        o);
    long now = 0, unsaid = 0;
    for (int i = (int)(1.5 / dt); i > 0; i--) {
        tumble_world_step(w);
        now = crossings(w, s, sheets, &box, 1);
        unsaid += now > 0 && tumble_world_last_step(w).unconverged == 0;
    }
    if (family_ok(r, w)) {
        char at[80];
        snprintf(at, sizeof at, "%d of %d x %d, %g kg, %g m/s, dt 1/%.0f",
                 sheets, n, n, mass, speed, 1 / dt);
        family_trial(end, (double)now, "%s", at);
        family_trial(silent, (double)unsaid, "%s", at);
    }
    tumble_world_free(w);
}

static void heavy_edges(hard_report *r, int fast)
{
    static const double masses[] = { 5, 1, 20 }, speeds[] = { 3, 0.5, 1.5, 5, 8 };
    family_worst end = { .target = 0 }, silent = { .target = 0 };
    for (int k = 0; k < (fast ? 1 : 45); k++)
        throw_box(r, &end, &silent, k / 15 + 1, masses[k % 3],
                  speeds[k / 3 % 5], fast ? 10 : 16,
                  STEPS[fast ? 0 : (k / 3 + k / 15) % 2]);
    family_add(r, &end, "", "crossings left at the end");
    family_add(r, &silent, "", "frames with crossings that no report says");
}

// ---- 171: hung cloth comes to rest -----------------------------------------

typedef enum { CURTAIN, LOOSE, FOUR, SAGGING, EDGE, HANGINGS } hanging;
static const char *const HANGING_NAME[] = {
    "curtain", "curtain 5 cm loose", "four corners", "four, 5 cm loose", "edge"
};

static sheet hang_cloth(tumble_world *w, hanging kind, int n, double damping,
                        double dt)
{
    tumble_body_options o = tumble_body_at(0, 2, 0);
    o.damping = damping;
    if (kind != FOUR && kind != SAGGING)
        o.pose.rotation = tumble_quat_turn(tumble_v(1, 0, 0), FAMILY_PI / 2);
    sheet s = add_sheet(w, n, n, 1, 1, 0.2, o);
    int corner[] = { 0, n - 1, n * (n - 1), n * n - 1 };
    // The upper edge of one that was turned upright is that of its first row.
    if (tumble_body_vertex(w, s.body, 0).y
        < tumble_body_vertex(w, s.body, n * n - 1).y)
        for (int k = 0; k < 2; k++) corner[k] = corner[k + 2];
    int corners = kind == FOUR || kind == SAGGING ? 4 : 2;
    if (kind == EDGE)
        for (int i = 0; i < n; i++) tumble_body_pin(w, s.body, corner[0] + i);
    if (kind == CURTAIN || kind == FOUR)
        for (int k = 0; k < corners; k++) tumble_body_pin(w, s.body, corner[k]);
    if (kind != LOOSE && kind != SAGGING) return s;
    // Posts go towards each other, 5 cm together.
    tumble_body post[4];
    for (int k = 0; k < corners; k++)
        hang_up(w, &s, corner[k], tumble_v(k % 2 ? -0.1 : 0.1, 0, 0), &post[k]);
    for (int i = (int)(0.25 / dt); i > 0; i--) tumble_world_step(w);
    for (int k = 0; k < corners; k++) halt(w, post[k]);
    return s;
}

// A damping of k takes what swings down as exp(-k t / 2); what is faster than
// the fastest before, brought down so far, is driven.
static void come_to_rest(hard_report *r, int fast)
{
    static const double dampings[] = { 1, 5 };
    static const int sides[] = { 20, 10, 40 };
    static tumble_vec3 was[MOST_VERTICES];
    family_worst speed = { .target = 1e-3 }, again = { .target = 1e-3 };
    for (int k = 0; k < (fast ? 1 : HANGINGS * 5); k++) {
        hanging kind = (hanging)(k % HANGINGS);
        int n = fast ? 8 : sides[k / HANGINGS / 2];
        double k_s = dampings[k / HANGINGS % 2], most = 0, last = 0;
        double dt = STEPS[k / HANGINGS == 3], seconds = fast ? 1 : 10;
        tumble_world *w = begin(dt, 0.5);
        sheet s = hang_cloth(w, kind, n, k_s, dt);
        tumble_body_vertices(w, s.body, was, MOST_VERTICES);
        int steps = (int)(seconds / dt + 0.5);
        for (int i = 0; i < steps; i++) {
            tumble_world_step(w);
            double now = fastest(w, &s, was, dt);
            if (i < steps / 5) most = hard_worse(most, now);
            if (i >= steps - steps / 10) last = hard_worse(last, now);
        }
        // From the fifth of the time to the last tenth.
        double allowed = most * exp(-k_s * 0.7 * seconds / 2);
        if (family_ok(r, w))
            family_trial(k_s > 1 ? &again : &speed, fmax(last - allowed, 0),
                         "%s, %d x %d, dt 1/%.0f", HANGING_NAME[kind], n, n,
                         1 / dt);
        tumble_world_free(w);
    }
    family_add(r, &speed, "m/s", "fastest vertex at a damping of 1/s");
    if (!fast) family_add(r, &again, "m/s", "fastest vertex at 5/s");
}

// ---- 172: weights on taut rope and cloth -----------------------------------

// A rope of length 1 m between two points as far apart, with a weight in its
// middle.  A newton stretches it by c: its pull at a sag d is
//     T = (s / (1/2) - 1) / c,  s = sqrt(1/4 + d^2),  and 2 T d / s = M g.
// Returns d.
static double sag_of_rope(double mass, double c)
{
    double low = 0, high = 10;
    for (int k = 0; k < 200; k++) {
        double d = (low + high) / 2, s = sqrt(0.25 + d * d);
        if (2 * (2 * s - 1) / c * d / s < mass * FAMILY_G) low = d;
        else high = d;
    }
    return low;
}

// What its ends bear at worst in the last second (N), and how low it is then
// (m).
static double let_sag(tumble_world *w, const tumble_joint *j, int joints,
                      tumble_body weight, double dt, double seconds,
                      double *low)
{
    double most = 0;
    int steps = (int)(seconds / dt + 0.5), last = (int)(1 / dt);
    *low = 0;
    for (int i = 0; i < steps; i++) {
        tumble_world_step(w);
        if (i < steps - last) continue;
        for (int k = 0; k < joints; k++)
            most = hard_worse(most, tumble_joint_force(w, j[k]));
        *low -= tumble_body_position(w, weight).y / last;
    }
    return most;
}

static tumble_body add_weight(tumble_world *w, const sheet *s, int i, double mass)
{
    tumble_vec3 at = tumble_body_vertex(w, s->body, i);
    tumble_body_options o = tumble_body_at(at.x, at.y, at.z);
    o.damping = 3;
    o.mask = 0;
    tumble_body ball = tumble_body_add(w, tumble_shape_sphere(w, 0.03, mass),
                                       o);
    tumble_joint_hang(w, s->body, i, ball);
    return ball;
}

static void load_rope(hard_report *r, family_worst *sag, family_worst *force,
                      double mass, double c, double dt, double seconds)
{
    tumble_world *w = begin(dt, 0.5);
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.damping = 3;
    sheet s = add_sheet(w, 21, 1, 1, 0, 0.001, o);
    tumble_body_set_stretch(w, s.body, c);
    tumble_joint j[2];
    tumble_body post;
    for (int k = 0; k < 2; k++) j[k] = hang_up(w, &s, 20 * k, STILL, &post);
    tumble_body ball = add_weight(w, &s, 10, mass);
    double low, most = let_sag(w, j, 2, ball, dt, seconds, &low);
    double d = sag_of_rope(mass + 0.0005, c);
    double pull = (mass + 0.0005) * FAMILY_G * sqrt(0.25 + d * d) / (2 * d);
    if (family_ok(r, w)) {
        family_trial(sag, fabs(low / d - 1), "%g kg, %g 1/N, dt 1/%.0f", mass, c,
                     1 / dt);
        family_trial(force, most / pull, "%g kg, %g 1/N, dt 1/%.0f", mass, c,
                     1 / dt);
    }
    tumble_world_free(w);
}

// The same sheet as nothing but threads, each a spring: what hangs on it, its
// own weight and that of `mass` in its middle, is in balance with them.  All
// spring masses go as they are drawn, and stop when they would go back, until
// they lie still.  Returns what a corner bears (N).
enum { NET = 15 };

static void draw_thread(double (*x)[3], double (*f)[3], int a, int b, double k)
{
    double d[3], far = 0;
    for (int c = 0; c < 3; c++) {
        d[c] = x[b][c] - x[a][c];
        far += d[c] * d[c];
    }
    far = sqrt(far);
    for (int c = 0; c < 3; c++) {
        double pull = k * (1 - 1.0 / (NET - 1) / far) * d[c];
        f[a][c] += pull;
        f[b][c] -= pull;
    }
}

// A corner is held; what draws it is returned.
static double take_corners(double (*f)[3])
{
    const int corner[] = { 0, NET - 1, NET * (NET - 1), NET * NET - 1 };
    double most = 0;
    for (int k = 0; k < 4; k++) {
        double *at = f[corner[k]];
        most = hard_worse(most, sqrt(at[0] * at[0] + at[1] * at[1]
                                     + at[2] * at[2]));
        at[0] = at[1] = at[2] = 0;
    }
    return most;
}

static double pull_of_threads(double mass, double own, double k, int rounds)
{
    enum { ALL = NET * NET };
    static double x[ALL][3], v[ALL][3], f[ALL][3];
    double bears = 0;
    for (int i = 0; i < ALL; i++)
        for (int c = 0; c < 3; c++) {
            x[i][c] = c < 2 ? (c ? i / NET : i % NET) / (NET - 1.0) : 0;
            v[i][c] = 0;
        }
    for (int n = 0; n < rounds; n++) {
        for (int i = 0; i < ALL; i++) {
            f[i][0] = f[i][1] = 0;
            f[i][2] = -FAMILY_G * (own / ALL + (i == ALL / 2) * mass);
        }
        for (int i = 0; i < ALL; i++) {
            if (i % NET < NET - 1) draw_thread(x, f, i, i + 1, k);
            if (i < ALL - NET) draw_thread(x, f, i, i + NET, k);
        }
        double power = 0;
        bears = take_corners(f);
        for (int i = 0; i < ALL; i++)
            for (int c = 0; c < 3; c++) {
                v[i][c] += f[i][c] / (6 * k);
                power += v[i][c] * f[i][c];
            }
        for (int i = 0; i < ALL; i++)
            for (int c = 0; c < 3; c++) {
                if (power < 0) v[i][c] = 0;
                x[i][c] += v[i][c];
            }
    }
    return bears;
}

// A sheet on four corners that are exactly as far apart as its own.  Its edges
// are drawn inwards by what hangs between them, and since they are straight, pull
// at the corners many times as hard as they are drawn.  Threads of which nothing
// is said give by 4e-6 of themselves where they bear the sheet.
static void load_sheet(hard_report *r, family_worst *force, double mass, double c,
                       double dt, double seconds)
{
    enum { N = NET };
    const double sheet_mass = 0.1;
    tumble_world *w = begin(dt, 0.5);
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.damping = 3;
    sheet s = add_sheet(w, N, N, 1, 1, sheet_mass, o);
    tumble_body_set_stretch(w, s.body, c);
    const int corner[] = { 0, N - 1, N * (N - 1), N * N - 1 };
    tumble_joint j[4];
    tumble_body post;
    for (int k = 0; k < 4; k++) j[k] = hang_up(w, &s, corner[k], STILL, &post);
    tumble_body ball = add_weight(w, &s, N * N / 2, mass);
    double low, most = let_sag(w, j, 4, ball, dt, seconds, &low);
    double width = 1.0 / N, gives = c > 0 ? c / width
                                          : 4e-6 / (sheet_mass * FAMILY_G);
    double pull = pull_of_threads(mass, sheet_mass, (N - 1) / gives,
                                  c > 0 ? 20000 : 100000);
    if (family_ok(r, w))
        family_trial(force, most / pull, "%g kg, %g m/N, dt 1/%.0f", mass, c,
                     1 / dt);
    tumble_world_free(w);
}

static void taut(hard_report *r, int fast)
{
    static const double masses[] = { 1, 0.1, 10 }, gives[] = { 1e-3, 1e-4, 1e-5 };
    family_worst sag = { .target = 0.02 }, force = { .target = 2 },
                 sheets = { .target = 2 };
    double seconds = fast ? 3 : 8;
    for (int k = 0; k < (fast ? 1 : 18); k++)
        load_rope(r, &sag, &force, masses[k % 3], gives[k / 3 % 3],
                  STEPS[k / 9], seconds);
    for (int k = 0; k < (fast ? 1 : 6); k++)
        load_sheet(r, &sheets, masses[k % 3], k / 3 ? 0 : 1e-4, STEPS[0],
                   seconds);
    family_add(r, &sag, "", "sag of a rope under a weight, of itself");
    family_add(r, &force, "x", "most pull on a taut rope, of springs'");
    family_add(r, &sheets, "x", "most pull on a taut sheet, of its threads'");
}

// ---- 173: the capstan ------------------------------------------------------

// Rope of 1 kg/m over a drum of radius r: on one side hangs a length a, and it
// slides if on the other hangs more than this.  Along the drum
//     dT/dp = mu (T + r g sin p) + r g cos p.
static double most_beyond(double a, double r, double mu)
{
    enum { PIECES = 4000 };
    double t = a * FAMILY_G, h = FAMILY_PI / PIECES;
    for (int k = 0; k < PIECES; k++) {
        double p = (k + 0.5) * h, weight = r * FAMILY_G;
        double rate = mu * (t + weight * sin(p)) + weight * cos(p);
        t += h * (rate + mu * rate * h / 2);
    }
    return t / FAMILY_G;
}

// m, by how far the middle of a rope that hangs on a drum with so much on both
// sides may be beside the drum before it slides.
static double most_beside(double hangs, double r, double mu)
{
    double low = 0, high = hangs / 2;
    for (int k = 0; k < 60; k++) {
        double beside = (low + high) / 2, a = hangs / 2 - beside;
        if (hangs - a < most_beyond(a, r, mu)) low = beside;
        else high = beside;
    }
    return low;
}

typedef enum { ROPE_ON_DRUM, CLOTH_ON_DRUM, CLOTH_ON_ROPE, CAPSTANS } capstan;
static const char *const CAPSTAN_NAME[] = {
    "rope on a drum", "cloth on a drum", "cloth on a rope"
};

static const double SPACING = 0.05;

// A drum of 20 cm, or a rope that is pinned all along.  Returns the radius on
// which the middle of what lies on it is bent.
static double add_drum(tumble_world *w, capstan kind, double friction)
{
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.kind = kind == CLOTH_ON_ROPE ? TUMBLE_DYNAMIC : TUMBLE_STATIC;
    o.friction = friction;
    if (kind != CLOTH_ON_ROPE) {
        o.pose.rotation = tumble_quat_turn(tumble_v(1, 0, 0), FAMILY_PI / 2);
        tumble_body_add(w, tumble_shape_capsule(w, 1, 0.2, 1), o);
        return 0.2 + 0.55 * SPACING;
    }
    o.pose.rotation = tumble_quat_turn(tumble_v(0, 1, 0), FAMILY_PI / 2);
    tumble_body rope = tumble_body_add(w, tumble_shape_rope(w, 20, 1, 1), o);
    for (int i = 0; i <= 20; i++) tumble_body_pin(w, rope, i);
    return 1.1 * SPACING;
}

// Laid over it with its vertex at the top pinned until it hangs; then let go
// for 3 s.  m, how far does the heavy side go down?
static double let_slide(hard_report *r, capstan kind, double mu, double part,
                        double dt, int fast)
{
    enum { LINKS = 60 };
    tumble_world *w = begin(dt, mu);
    double radius = add_drum(w, kind, mu), length = LINKS * SPACING;
    // A vertex weighs as much as a link, so there is one link more of it.
    double hangs = length + SPACING - FAMILY_PI * radius;
    double beside = part * most_beside(hangs, radius, mu);
    int shift = (int)(beside / SPACING + 0.5), rows = kind == ROPE_ON_DRUM ? 1 : 4;
    tumble_body_options o = tumble_body_at(shift * SPACING, radius + 0.01, 0);
    o.damping = 4;
    o.friction = mu;
    sheet s = add_sheet(w, LINKS + 1, rows, length, (rows - 1) * SPACING, length,
                        o);
    int top = LINKS / 2 - shift;
    for (int k = 0; k < rows; k++)
        tumble_body_pin(w, s.body, top + k * s.columns);
    family_run(w, fast ? 2 : 4);
    for (int k = 0; k < rows; k++)
        tumble_body_unpin(w, s.body, top + k * s.columns);
    tumble_body_set_damping(w, s.body, 0, 0);
    double before = tumble_body_vertex(w, s.body, LINKS).y;
    family_run(w, 3);
    double went = before - tumble_body_vertex(w, s.body, LINKS).y;
    int is_ok = family_ok(r, w);
    tumble_world_free(w);
    return is_ok ? went : (double)NAN;
}

// It holds at four fifths of what the law allows, and slides at six fifths.
static void capstans(hard_report *r, int fast)
{
    static const double frictions[] = { 0.3, 0.1, 0.2, 0.5 };
    family_worst creep = { .target = 0.01 }, slide = { .target = 0 };
    for (int k = 0; k < (fast ? 1 : CAPSTANS * 4 * 2); k++) {
        capstan kind = (capstan)(k % CAPSTANS);
        double mu = frictions[k / CAPSTANS % 4], dt = STEPS[k / CAPSTANS / 4];
        double held = let_slide(r, kind, mu, 0.8, dt, fast);
        double went = let_slide(r, kind, mu, 1.2, dt, fast);
        family_trial(&creep, fabs(held), "%s, friction %g, dt 1/%.0f",
                     CAPSTAN_NAME[kind], mu, 1 / dt);
        family_trial(&slide, !(went > 0.05), "%s, friction %g, dt 1/%.0f",
                     CAPSTAN_NAME[kind], mu, 1 / dt);
    }
    family_add(r, &creep, "m", "creep in 3 s at .8 of what friction holds");
    family_add(r, &slide, "", "stuck at 1.2 of what it holds");
}

// ---- 174: impossible demands -----------------------------------------------

typedef enum { TORN, TWISTED, PINCHED, DEMANDS } demand;
static const char *const DEMAND_NAME[] = {
    "pulled to 1.3", "twisted", "between closing plates"
};

// A cloth between two rows of posts, or plates.  Posts move as one: a bar.
static sheet demand_begin(tumble_world *w, demand kind, int n, double speed,
                          tumble_body bar[2])
{
    sheet s = add_sheet(w, n, n, 1, 1, 0.2, tumble_body_at(0, 0, 0));
    for (int side = 0; side < 2; side++) {
        double sign = side ? 1 : -1;
        tumble_body_options o = tumble_body_at(sign / 2, 0, 0);
        o.kind = TUMBLE_KINEMATIC;
        tumble_vec3 sides = { 0.05, 0.05, 1 };
        if (kind == TORN) o.velocity = tumble_v(sign * speed / 2, 0, 0);
        if (kind == TWISTED) o.spin = tumble_v(sign * speed * 6, 0, 0);
        if (kind == PINCHED) {
            o.pose.position = tumble_v(0, 0.3 * sign, 0);
            o.velocity = tumble_v(0, -0.3 * speed * sign, 0);
            sides = tumble_v(1.5, 0.2, 1.5);
        } else o.mask = 0;
        bar[side] = tumble_body_add(w, tumble_shape_box(w, sides, 1), o);
        for (int i = 0; i < n && kind != PINCHED; i++)
            tumble_joint_hang(w, s.body, side ? i * n + n - 1 : i * n,
                              bar[side]);
    }
    return s;
}

// What cannot be, is not: but a report says so in every frame in which threads
// are off by a hundredth, or triangles cross each other or a body's edges.
static void demands(hard_report *r, int fast)
{
    static const double speeds[] = { 1, 0.3, 4 };
    family_worst silent = { .target = 0 }, cross = { .target = 0 };
    for (int k = 0; k < (fast ? 1 : DEMANDS * 3); k++) {
        demand kind = (demand)(k % DEMANDS);
        double speed = speeds[k / DEMANDS], dt = STEPS[0];
        int n = fast ? 8 : 14, unsaid = 0, hard = 0;
        tumble_body bar[2];
        tumble_world *w = begin(dt, 0.5);
        sheet s = demand_begin(w, kind, n, speed, bar);
        long most = 0;
        int stop = (int)((kind == TORN ? 0.3 : kind == TWISTED ? 2 : 0.9)
                         / speed / dt);
        for (int i = 0; i < stop + 60; i++) {
            if (i == stop)
                for (int side = 0; side < 2; side++) halt(w, bar[side]);
            tumble_world_step(w);
            long now = crossings(w, &s, 1, bar, kind == PINCHED ? 2 : 0);
            int is_hard = now > 0 || strain(w, &s) > 0.01;
            hard += is_hard;
            unsaid += is_hard && tumble_world_last_step(w).unconverged == 0;
            if (now > most) most = now;
        }
        if (family_ok(r, w)) {
            family_trial(&silent, (double)unsaid / (hard ? hard : 1),
                         "%s, at speed %g: %d of %d", DEMAND_NAME[kind], speed,
                         unsaid, hard);
            family_trial(&cross, (double)most, "%s, at speed %g",
                         DEMAND_NAME[kind], speed);
        }
        tumble_world_free(w);
    }
    family_add(r, &silent, "", "of the frames that cannot be, unreported");
    family_add(r, &cross, "", "crossings, most in a frame");
}

// ---- 175: threads keep their lengths ---------------------------------------

typedef enum { FLAG, ON_CUBE, ROPE_WHIP, PUSHED, FALLS } fall_kind;
static const char *const FALL_NAME[] = {
    "flag let go", "falls on a cube", "rope let go", "pushed at a corner"
};

static sheet fall_begin(tumble_world *w, fall_kind kind, int n)
{
    tumble_body_options o = tumble_body_at(0, 1, 0);
    sheet s = kind == ROPE_WHIP ? add_sheet(w, 2 * n, 1, 2, 0, 0.2, o)
                                : add_sheet(w, n, n, 1, 1, 0.2, o);
    if (kind == FLAG)
        for (int i = 0; i < n; i++) tumble_body_pin(w, s.body, i * n);
    if (kind == ROPE_WHIP) tumble_body_pin(w, s.body, 0);
    if (kind == ON_CUBE)
        add_static(w, tumble_shape_box(w, tumble_v(0.4, 0.4, 0.4), 1),
                   tumble_v(0.1, 0.4, 0.1), (tumble_quat){ 0, 0, 0, 1 });
    // A tenth of its weight's impulse in a second, on one vertex.
    if (kind == PUSHED)
        tumble_body_push_vertex(w, s.body, n * n - 1,
                                tumble_v(0.1, 0.1, -0.15));
    return s;
}

static void lengths(hard_report *r, int fast)
{
    static const int sides[] = { 10, 20, 30 };
    family_worst most = { .target = 0.01 };
    for (int k = 0; k < (fast ? 2 : FALLS * 9); k++) {
        fall_kind kind = (fall_kind)(k % FALLS);
        int n = fast ? 8 : sides[k / FALLS / 3];
        double dt = STEPS[fast ? 0 : k / FALLS % 3], worst = 0;
        tumble_world *w = begin(dt, 0.5);
        sheet s = fall_begin(w, kind, n);
        for (int i = (int)(1.5 / dt); i > 0; i--) {
            tumble_world_step(w);
            worst = hard_worse(worst, strain(w, &s));
        }
        if (family_ok(r, w))
            family_trial(&most, worst, "%s, %d a side, dt 1/%.0f",
                         FALL_NAME[kind], n, 1 / dt);
        tumble_world_free(w);
    }
    family_add(r, &most, "", "strain of rope and cloth on their way");
}

// ---- 176: the catenary -----------------------------------------------------

// n links of length l between two points of one height: their slopes grow in
// equal steps, tan a_k = (k - (n - 1) / 2) q, with a q that makes them as wide
// as `span`. Returns the height of vertex i under the points.
static double chain_depth(int n, double l, double span, int i)
{
    double low = 0, high = 1e6, depth = 0;
    for (int k = 0; k < 200; k++) {
        double q = (low + high) / 2, wide = 0;
        for (int m = 0; m < n; m++)
            wide += l / sqrt(1 + q * q * (m - (n - 1) / 2.0) * (m - (n - 1) / 2.0));
        if (wide > span) low = q;
        else high = q;
    }
    for (int m = 0; m < i; m++) {
        double slope = low * (m - (n - 1) / 2.0);
        depth -= l * slope / sqrt(1 + slope * slope);
    }
    return depth;
}

static void catenary(hard_report *r, int fast)
{
    static const int links[] = { 20, 10, 40 };
    static const double spans[] = { 0.6, 0.4, 0.95 }, sizes[] = { 1, 0.1, 5 };
    family_worst off = { .target = 1e-3 };
    for (int k = 0; k < (fast ? 1 : 18); k++) {
        int n = links[k % 3];
        double length = sizes[(k + k / 3) % 3], span = spans[k / 3 % 3] * length;
        double dt = STEPS[k / 9];
        tumble_world *w = begin(dt, 0.5);
        tumble_body_options o = tumble_body_at(0, 0, 0);
        o.damping = 4;
        sheet s = add_sheet(w, n + 1, 1, length, 0, 0.1, o);
        // Above the vertices that meet where both ends come close.
        tumble_body post[2];
        double seconds = sqrt(length), speed = (length - span) / 2 / seconds;
        for (int i = 0; i < 2; i++)
            hang_up(w, &s, i * n, tumble_v(i ? -speed : speed, 0, 0), &post[i]);
        family_run(w, seconds);
        for (int i = 0; i < 2; i++) halt(w, post[i]);
        double y = tumble_body_vertex(w, s.body, 0).y;
        double is = v_distance(tumble_body_vertex(w, s.body, 0),
                               tumble_body_vertex(w, s.body, n));
        family_run(w, fast ? 5 : 12);
        double worst = 0;
        for (int i = 0; i <= n; i++)
            worst = hard_worse(worst,
                               fabs(y - tumble_body_vertex(w, s.body, i).y
                - chain_depth(n, length / n, is, i)));
        if (family_ok(r, w))
            family_trial(&off, worst / length, "%d links, %g m over %.2f m, dt "
                         "1/%.0f", n, length, is, 1 / dt);
        tumble_world_free(w);
    }
    family_add(r, &off, "", "a rope between two points, of its length");
}

// ---- 177: a string ---------------------------------------------------------

// A rope of n links that is stretched by a twentieth pulls with T = 1 / (20 c) (N),
// and swings in its lowest tone with
//     w = 2 sqrt(T / (m l)) sin(pi / 2n),   m, l: mass and length of a link.
static void strings(hard_report *r, int fast)
{
    static const double pulls[] = { 0.5, 0.05, 5 };
    static const int links[] = { 20, 10, 40 };
    family_worst period = { .target = 0.01 };
    for (int k = 0; k < (fast ? 1 : 18); k++) {
        int n = links[k / 3 % 3], passed = -1;
        double pull = pulls[k % 3], dt = STEPS[k / 9], mass = 0.2, first = 0;
        tumble_options o = family_options(dt, 0.5);
        o.gravity = STILL;
        o.sleep_speed = 0;
        tumble_world *w = tumble_world_make(&o);
        sheet s = add_sheet(w, n + 1, 1, 1, 0, mass, tumble_body_at(0, 0, 0));
        tumble_body_set_stretch(w, s.body, 0.05 / pull);
        tumble_body_set_damping(w, s.body, 5, 0);
        tumble_body post[2];
        for (int i = 0; i < 2; i++)
            hang_up(w, &s, i * n, tumble_v(i ? 0.025 : -0.025, 0, 0), &post[i]);
        family_run(w, 1);
        for (int i = 0; i < 2; i++) halt(w, post[i]);
        family_run(w, 3);
        tumble_body_set_damping(w, s.body, 0, 0);
        double each = mass / (n + 1);       // kg, of a vertex
        double truth = FAMILY_PI / sqrt(pull / (each * 1.05 / n))
                     / sin(FAMILY_PI / (2 * n));
        for (int i = 1; i < n; i++)
            tumble_body_push_vertex(w, s.body, i,
                                    tumble_v(0, each * 0.03 / truth
                * sin(FAMILY_PI * i / n), 0));
        double was = 0, took = (double)NAN, most = (fast ? 3 : 7) * truth;
        for (double t = dt; t < most; t += dt) {
            tumble_world_step(w);
            double now = tumble_body_vertex(w, s.body, n / 2).y;
            if ((was < 0) != (now < 0) && was != 0) {
                double at = t - dt * now / (now - was);
                if (++passed == 0) first = at;
                else took = 2 * (at - first) / passed;
            }
            was = now;
        }
        if (family_ok(r, w))
            family_trial(&period, fabs(took / truth - 1),
                         "%d links, %g N, dt 1/%.0f", n, pull, 1 / dt);
        tumble_world_free(w);
    }
    family_add(r, &period, "", "period of a taut string, of itself");
}

// ---- 178: a rope over a smooth drum ----------------------------------------

// Two weights a, b on a rope of mass R and length L over a drum without friction:
//     x'' = g (b - a + 2 R x / L) / (a + b + R),
// so it pulls the same on both sides, but for the rope's own weight.
static void over_a_drum(hard_report *r, int fast)
{
    static const double ratios[] = { 1.5, 1, 4 };
    family_worst way = { .target = 0.02 }, pulls = { .target = 0.05 };
    for (int k = 0; k < (fast ? 1 : 6); k++) {
        enum { LINKS = 60 };
        double dt = STEPS[k / 3], a = 1, b = ratios[k % 3], rope = 0.05;
        tumble_world *w = begin(dt, 0);
        double radius = add_drum(w, ROPE_ON_DRUM, 0), length = LINKS * SPACING;
        tumble_body_options o = tumble_body_at(0, radius + 0.01, 0);
        o.damping = 4;
        o.friction = 0;
        sheet s = add_sheet(w, LINKS + 1, 1, length, 0, rope, o);
        tumble_body_pin(w, s.body, LINKS / 2);
        tumble_body ball[2];
        tumble_joint j[2];
        for (int i = 0; i < 2; i++) {
            tumble_vec3 at = tumble_body_vertex(w, s.body, i * LINKS);
            o = tumble_body_at(at.x, at.y, at.z);
            o.damping = 4;
            o.mask = 0;
            ball[i] =
                tumble_body_add(w, tumble_shape_sphere(w, 0.05, i ? b : a), o);
            j[i] = tumble_joint_hang(w, s.body, i * LINKS, ball[i]);
        }
        family_run(w, 6);
        tumble_body_unpin(w, s.body, LINKS / 2);
        tumble_body_set_damping(w, s.body, 0, 0);
        for (int i = 0; i < 2; i++) tumble_body_set_damping(w, ball[i], 0, 0);
        double was = tumble_body_position(w, ball[1]).y, t = 0.4;
        double bore[2] = { 0, 0 };
        int steps = (int)(t / dt + 0.5);
        for (int n = 0; n < steps; n++) {
            tumble_world_step(w);
            for (int i = 0; i < 2; i++)
                bore[i] += tumble_joint_force(w, j[i]) / steps;
        }
        double all = a + b + rope, grow = 2 * rope / length;
        double rate = sqrt(grow * FAMILY_G / all);
        double truth = (b - a) / grow * (cosh(rate * t) - 1);
        double x = was - tumble_body_position(w, ball[1]).y;
        double speeds = FAMILY_G * (b - a + grow * truth / 3) / all;
        if (family_ok(r, w)) {
            family_trial(&way, fabs(x - truth) / (0.5 * FAMILY_G * t * t),
                         "%g and %g kg, dt 1/%.0f", a, b, 1 / dt);
            for (int i = 0; i < 2; i++) {
                double pull = i ? b * (FAMILY_G - speeds)
                                : a * (FAMILY_G + speeds);
                family_trial(&pulls, fabs(bore[i] / pull - 1),
                             "%g and %g kg, end %d, dt 1/%.0f", a, b, i, 1 / dt);
            }
        }
        tumble_world_free(w);
    }
    family_add(r, &way, "", "way of two weights over a drum, of a fall");
    family_add(r, &pulls, "", "mean pull on both its sides, of itself");
}

// ---- 179: what soft bodies keep --------------------------------------------

// A cloth, a rope, two cloths that meet, or a cloth and a ball, in space: sums
// of m v and x times m v, of sums of sizes.  In the air: a parabola.
static void keep_sums(hard_report *r, int fast)
{
    static const char *const name[] = {
        "a cloth", "a rope", "two cloths", "a cloth and a ball"
    };
    family_worst sums = { .target = 1e-9 }, turns = { .target = 1e-9 },
                 falls = { .target = 1e-9 };
    for (int k = 0; k < (fast ? 1 : 24); k++) {
        int kind = k % 4, bends = k / 4 % 2, n = 12;
        double dt = STEPS[k / 8];
        tumble_options o = family_options(dt, 0.5);
        o.gravity = STILL;
        tumble_world *w = tumble_world_make(&o);
        sheet s = add_sheet(w, n, kind == 1 ? 1 : n, 1, 1, 0.3,
                            tumble_body_at(0, 0, 0));
        for (int i = 0; i < n; i += 4)
            tumble_body_push_vertex(w, s.body, i,
                                    tumble_v(0.02 * i, 0.05, -0.03));
        tumble_body_options thrown = tumble_body_at(0.2, 0.5, 0.1);
        thrown.velocity = tumble_v(0, -3, 0);
        if (kind == 2) add_sheet(w, n, n, 1, 1, 0.3, thrown);
        if (kind == 3)
            tumble_body_add(w, tumble_shape_sphere(w, 0.2, 1), thrown);
        if (bends) tumble_body_set_bending(w, s.body, 1e-3);
        tumble_measures a = tumble_world_measure(w), b;
        family_run(w, 1);
        b = tumble_world_measure(w);
        char at[80];
        snprintf(at, sizeof at, "%s%s, dt 1/%.0f", name[kind],
                 bends ? ", stiff" : "", 1 / dt);
        if (family_ok(r, w)) {
            family_trial(&sums, v_distance(a.momentum, b.momentum)
                         / v_length(a.momentum), "%s", at);
            family_trial(&turns, v_distance(a.angular, b.angular)
                         / v_length(a.angular), "%s", at);
        }
        tumble_world_set_gravity(w, tumble_v(0, -FAMILY_G, 0));
        tumble_pose p = tumble_body_pose(w, s.body);
        double v = tumble_body_velocity(w, s.body).y;
        if (kind < 2) {
            family_run(w, 1);
            double y = tumble_body_position(w, s.body).y;
            double t = (int)(1 / dt + 0.5) * dt;
            family_trial(&falls, fabs(y - p.position.y - v * t
                                      + FAMILY_G * t * t / 2), "%s", at);
        }
        tumble_world_free(w);
    }
    family_add(r, &sums, "", "momentum of thrown cloth and rope, of itself");
    family_add(r, &turns, "", "angular momentum of them, of itself");
    family_add(r, &falls, "m", "its middle, from a parabola, after 1 s");
}

const hard_case family_cloth[] = {
    { 170, "sheets under heavy edges", 1, heavy_edges },
    { 171, "hung cloth comes to rest", 1, come_to_rest },
    { 172, "weights on taut rope and cloth", 1, taut },
    { 173, "capstans", 1, capstans },
    { 174, "impossible demands", 1, demands },
    { 175, "threads keep their lengths", 1, lengths },
    { 176, "rope between two points", 1, catenary },
    { 177, "strings", 1, strings },
    { 178, "weights over a drum", 1, over_a_drum },
    { 179, "thrown cloth and rope", 1, keep_sums },
    { 0, NULL, 0, NULL }
};
