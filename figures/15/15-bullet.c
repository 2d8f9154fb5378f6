// 15-bullet.c - a ball of 5 cm is shot at a plate of 1 cm: how many shots go
// through, by each way of looking for contacts, how many that pass beside the
// plate are stopped all the same, and what the looking costs.
//
// index 0: speed, then the share of shots at the plate that go through: end of
//          step (of these: never seen), substeps, looking ahead, swept
// index 1: speed, then the share of shots beside the plate that are pushed:
//          the same four
// index 2: speed, then ns for the frame in which a shot meets the plate: the
//          same four; substeps in that frame
// index 3: distances asked for in such a frame by swept, shots
// Columns are separated by spaces.

#include "clock.h"
#include "hit_face.h"
#include "random.h"
#include "swept.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

// The table of the book, at five of the speeds, opens its lines with "#shots| ".

enum { SHOTS = 1000, BALL = 12, PLATE = 8, PASSES = 12, SPEEDS = 13 };
static const real RADIUS = 0.05, FRAME = 1.0 / 60, TOLERANCE = 1e-9;

// A ball about the origin, and the straight line that its middle follows.
typedef struct {
    vec3 at[BALL];
    vec3 through, along;    // m, where it crosses z = 0; unit
    real phase;             // of a frame, at the crossing
} shot;

typedef enum { FLIES, STOPPED, THROUGH } outcome;
typedef enum { BY_END, BY_SUBSTEPS, BY_LOOKING_AHEAD, BY_SWEEP, WAYS } means;

// What is measured at one speed (m/s): shares of the shots, by each means; of
// those through, the share never seen to overlap, looking at the end.
typedef struct {
    real speed, through[WAYS], pushed[WAYS], unseen;
    real ns[WAYS];      // the frame in which a shot meets the plate
    int  substeps;      // in that frame
} series;

static shot hits[SHOTS], misses[SHOTS];
static vec3 plate_at[PLATE];
static const hull plate = { plate_at, PLATE };
static real inner;          // m, radius of the largest ball inside the ball
static int never_seen;

// ---- the shots

static unsigned long long seed = 1;

static void make_ball(vec3 *at)
{
    const real golden = (1 + sqrt(5.0)) / 2;
    vec3 x = random_direction(&seed),
         y = vec3_unit(vec3_cross(x, random_direction(&seed)));
    vec3 z = vec3_cross(x, y);
    real k = RADIUS / sqrt(1 + golden * golden);
    int n = 0;
    for (int s = -1; s < 2; s += 2)
        for (int t = -1; t < 2; t += 2) {
            vec3 a = vec3_scale(s * k, x), b = vec3_scale(s * k, y);
            vec3 c = vec3_scale(s * k, z);
            at[n++] = vec3_add_scaled(a, t * k * golden, y);
            at[n++] = vec3_add_scaled(b, t * k * golden, z);
            at[n++] = vec3_add_scaled(c, t * k * golden, x);
        }
}

// Down, up to 60 degrees from straight; through the plate at least 10 cm from
// its rim, or past it.
static void make_shot(shot *s, int beside)
{
    make_ball(s->at);
    do s->along = random_direction(&seed); while (s->along.z > -0.5);
    s->through = vec3_make(random_between(&seed, -0.4, 0.4),
                           random_between(&seed, -0.4, 0.4), 0);
    if (beside) s->through.x = random_between(&seed, 0.5, 0.9);
    s->phase = random_between(&seed, 0, 1);
}

static hull placed(const shot *s, vec3 where, vec3 *at)
{
    for (int i = 0; i < BALL; i++) at[i] = vec3_add(s->at[i], where);
    return (hull){ at, BALL };
}

static real distance(const shot *s, vec3 where)
{
    vec3 at[BALL];
    return gjk_distance(placed(s, where, at), plate, HUGE_VAL, NULL).distance;
}

// The least distance over the whole line, by golden sections: it is convex.
static real least_distance(const shot *s)
{
    const real part = 0.6180339887498949;
    real low = -1, high = 1;
    for (int k = 0; k < 50; k++) {
        real a = high - part * (high - low), b = low + part * (high - low);
        real da = distance(s, vec3_add_scaled(s->through, a, s->along));
        real db = distance(s, vec3_add_scaled(s->through, b, s->along));
        if (da <= db) high = b;
        else          low = a;
    }
    return distance(s, vec3_add_scaled(s->through, low, s->along));
}

static void make_shots(void)
{
    for (int i = 0; i < PLATE; i++)
        plate_at[i] = vec3_make(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5,
                                i & 4 ? 0.005 : -0.005);
    // A face of an icosahedron lies at 0.7947 of its radius.
    inner = 0.7947 * RADIUS;
    for (int k = 0; k < SHOTS; k++) {
        make_shot(&hits[k], 0);
        real least;
        do {
            make_shot(&misses[k], 1);
            least = least_distance(&misses[k]);
        } while (!(least > 0.001 && least < 0.3));
    }
}

// ---- one frame, by each means

// Do they overlap here?  Then out by the hit face: on which side?
static outcome look(const shot *s, vec3 where)
{
    vec3 at[BALL];
    hull ball = placed(s, where, at);
    gjk_result g = gjk_distance(ball, plate, HUGE_VAL, NULL);
    if (g.status != GJK_OVERLAP) return FLIES;
    hit_result h = hit_face_find(ball, plate, &g.last);
    return h.status == HIT_FOUND && h.normal.z < -0.5 ? THROUGH : STOPPED;
}

static outcome by_substeps(const shot *s, vec3 from, vec3 way)
{
    int n = (int)ceil(vec3_length(way) / inner);
    outcome o = FLIES;
    for (int k = 1; k <= n && o == FLIES; k++)
        o = look(s, vec3_add_scaled(from, (real)k / n, way));
    return o;
}

// What may come near on this way gets a plane to stay in front of.
static outcome by_looking_ahead(const shot *s, vec3 from, vec3 way)
{
    vec3 at[BALL];
    real margin = vec3_length(way);
    gjk_result g = gjk_distance(placed(s, from, at), plate, margin, NULL);
    if (g.status != GJK_APART || g.distance > margin) return FLIES;
    vec3 n = vec3_scale(1 / g.distance, g.axis);
    return g.distance + vec3_dot(way, n) < 0 ? STOPPED : FLIES;
}

static swept_result swept(const shot *s, vec3 from, vec3 way)
{
    vec3 at[BALL], room[BALL + PLATE];
    return swept_first_touch(placed(s, from, at), way, plate, 0, TOLERANCE,
                             room);
}

static outcome frame(means by, const shot *s, vec3 from, vec3 way)
{
    switch (by) {
    case BY_END:           return look(s, vec3_add(from, way));
    case BY_SUBSTEPS:      return by_substeps(s, from, way);
    case BY_LOOKING_AHEAD: return by_looking_ahead(s, from, way);
    default:               return swept(s, from, way).status == SWEPT_PASSES
                                ? FLIES : STOPPED;
    }
}

// ---- the flight: frames from a metre before the plate to a metre behind

static vec3 way_of(const shot *s, real speed)
{
    return vec3_scale(speed * FRAME, s->along);
}

// k frames before (or behind, k < 0) that in which the middle crosses z = 0.
static vec3 place_before(const shot *s, real speed, int k)
{
    return vec3_add_scaled(s->through, -(k + s->phase), way_of(s, speed));
}

static outcome fly(means by, const shot *s, real speed)
{
    int far = (int)ceil(1 / (speed * FRAME)) + 1;
    for (int k = far; k >= -far; k--) {
        outcome o = frame(by, s, place_before(s, speed, k), way_of(s, speed));
        if (o != FLIES) return o;
    }
    never_seen++;
    return FLIES;
}

static void shares(series *s)
{
    for (means by = BY_END; by < WAYS; by++) {
        int through = 0, pushed = 0;
        never_seen = 0;
        for (int k = 0; k < SHOTS; k++)
            through += fly(by, &hits[k], s->speed) != STOPPED;
        if (by == BY_END) s->unseen = (real)never_seen / SHOTS;
        for (int k = 0; k < SHOTS; k++)
            pushed += fly(by, &misses[k], s->speed) != FLIES;
        s->through[by] = (real)through / SHOTS;
        s->pushed[by] = (real)pushed / SHOTS;
    }
}

// ---- the time of the frame in which they meet

static vec3 meeting[SHOTS];

static void find_meetings(real speed)
{
    for (int k = 0; k < SHOTS; k++) {
        const shot *s = &hits[k];
        vec3 way = way_of(s, speed);
        int n = (int)ceil(1 / (speed * FRAME)) + 1;
        while (frame(BY_SWEEP, s, place_before(s, speed, n), way) == FLIES) n--;
        meeting[k] = place_before(s, speed, n);
    }
}

// Of all ways in turn, so that a neighbour's noise meets them alike.
static void times(series *s)
{
    int caught = 0;
    find_meetings(s->speed);
    s->substeps = (int)ceil(s->speed * FRAME / inner);
    for (int k = 0; k < PASSES * WAYS; k++) {
        means by = (means)(k % WAYS);
        real start = clock_seconds();
        for (int i = 0; i < SHOTS; i++)
            caught += frame(by, &hits[i], meeting[i],
                            way_of(&hits[i], s->speed)) == STOPPED;
        real took = (clock_seconds() - start) / SHOTS * 1e9;
        if (k < WAYS || took < s->ns[by]) s->ns[by] = took;
    }
    // No compiler may guess that nobody asks.
    if (caught < 0) printf("# %d\n", caught);
}

static void distances(real speed, int *asked)
{
    find_meetings(speed);
    for (int k = 0; k < SHOTS; k++) {
        vec3 way = way_of(&hits[k], speed);
        asked[swept(&hits[k], meeting[k], way).iterations]++;
    }
}

// ---- what is printed

static void print_through(const series *s)
{
    printf("%.4g %.4g %.4g %.4g %.4g %.4g\n", s->speed, s->through[BY_END],
           s->unseen, s->through[BY_SUBSTEPS], s->through[BY_LOOKING_AHEAD],
           s->through[BY_SWEEP]);
}

static void print_pushed(const series *s)
{
    printf("%.4g", s->speed);
    for (means by = BY_END; by < WAYS; by++) printf(" %.4g", s->pushed[by]);
    printf("\n");
}

static void print_times(const series *s)
{
    printf("%.4g", s->speed);
    for (means by = BY_END; by < WAYS; by++) printf(" %.0f", s->ns[by]);
    printf(" %d\n", s->substeps);
}

// A row of the book's table.
static void print_shots(const series *s)
{
    printf("#shots| %.0f,%.1f,%.1f,%.3g,%d,%.3g\n", s->speed,
           s->through[BY_END] * 100, s->pushed[BY_LOOKING_AHEAD] * 100,
           s->ns[BY_SUBSTEPS] / 1000, s->substeps, s->ns[BY_SWEEP] / 1000);
}

static void print_block(const char *title, const series *s,
                        void (*print)(const series *))
{
    printf("%s\n", title);
    for (int k = 0; k < SPEEDS; k++) print(&s[k]);
    printf("\n\n");
}

static void print_table(const series *s)
{
    printf("#shots| \"speed, m/s\",\"through, looking at the end, %%\","
           "\"beside, but pushed, looking ahead, %%\",\"substeps, µs\","
           "their number,\"swept, µs\"\n");
    static const int shown[] = { 0, 4, 6, 8, 12 };
    for (int k = 0; k < 5; k++) print_shots(&s[shown[k]]);
}

int main(void)
{
    static series s[SPEEDS];
    static int asked[SWEPT_CAP + 1];
    make_shots();
    for (int k = 0; k < SPEEDS; k++) {
        s[k].speed = pow(10, 0.25 * k);
        shares(&s[k]);
        times(&s[k]);
        distances(s[k].speed, asked);
    }
    printf("# %d shots of an icosahedron of radius %g m at a plate of 1 m x 1 m"
           " x 1 cm, frames of 1/60 s\n# and as many that pass it, 1 mm to"
           " 30 cm beside\n# %s, %s\n", SHOTS, RADIUS, __VERSION__, FLAGS);
    print_table(s);
    print_block("# through: speed end (never seen) substeps ahead swept", s,
                print_through);
    print_block("# pushed beside: speed end substeps ahead swept", s,
                print_pushed);
    print_block("# ns: speed end substeps ahead swept, number of substeps", s,
                print_times);
    printf("# distances asked for, shots\n");
    for (int k = 0; k <= SWEPT_CAP; k++)
        if (asked[k]) printf("%d %d\n", k, asked[k]);
    return 0;
}
