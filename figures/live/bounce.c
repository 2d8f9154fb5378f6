// bounce.c - the first program: a ball that falls and bounces (chapter 0).

#include "live.h"
#include "verlet.h"

#include <stdio.h>

enum { GRAVITY, FLOOR, WIND, STEP };            // dials
enum { ENERGY, OFF };                           // charts
enum { MOVING, HIGH, SUM };                     // lines of the first
enum { TRAIL = 1000, AHEAD = 600, BOUNCES = 100 };
static const real RADIUS = 0.09, MASS = 1;      // m, as it is drawn; kg
static const real LONG = 5, WIDE = 6.6;         // s, m: then it is thrown again

typedef struct {
    vec3 x, v;
    real time;              // s
    bool lies;              // on the floor, for good
} flight;

static particle ball;
static vec3 trail[TRAIL], ahead[AHEAD], held_at;
static flight exact;                            // at the last bounce
static real now, time_of, worst;
static int trails;
static bool is_held;

static real step_length(void)
{
    static const real LENGTH[] = { 1.0 / 120, 1.0 / 60, 1.0 / 30, 1.0 / 10 };
    return LENGTH[live_choice(STEP)];
}

static vec3 pull(void)
{
    return vec3_make(live_dial(WIND), -live_dial(GRAVITY), 0);
}

// --- The exact path: parabolas between bounces --------------------------------
static vec3 fly(const flight *f, real t)
{
    vec3 way = vec3_add_scaled(vec3_scale(t, f->v), t * t / 2, pull());
    if (f->lies) way.y = 0;
    return vec3_add(f->x, way);
}

// s, until the floor is met.
static real fall_time(const flight *f)
{
    real g = live_dial(GRAVITY);
    if (g > 0) return (f->v.y + sqrt(f->v.y * f->v.y + 2 * g * real_max(0, f->x.y))) / g;
    return f->v.y < 0 ? -f->x.y / f->v.y : HUGE_VAL;
}

// Where is it then?  Goes on from the last bounce before.
static vec3 exact_at(flight *f, real time)
{
    for (int k = 0; k < BOUNCES && !f->lies; k++) {
        real t = fall_time(f);
        if (f->time + t > time) return fly(f, time - f->time);
        f->x = fly(f, t);
        f->x.y = 0;
        f->v = vec3_add_scaled(f->v, t, pull());
        f->v.y *= -live_dial(FLOOR);
        f->time += t;
    }
    f->lies = true;
    return fly(f, time - f->time);
}

static void look_ahead(void)
{
    flight f = exact;
    for (int k = 0; k < AHEAD; k++) ahead[k] = exact_at(&f, exact.time + k * LONG / AHEAD);
}

// --- Frames -----------------------------------------------------------------------
static void throw_from(vec3 x, vec3 v)
{
    now = time_of = worst = 0;
    trails = 0;
    exact = (flight){ x, v, 0, false };
    ball = particle_start(x, v, pull(), 1 / MASS, step_length());
    look_ahead();
}

static void begin(void)
{
    is_held = false;
    throw_from(vec3_make(0, 2, 0), vec3_make(1.6, 4, 0));
}

// As chapter 00 does it.
static void step_ball(void)
{
    verlet_step(&ball, 1, pull(), NULL, step_length());
    if (ball.position.y < 0) {
        ball.position.y *= -live_dial(FLOOR);
        ball.previous.y *= -live_dial(FLOOR);
    }
}

// A hand only moves the ball: that is how it becomes fast.
static void carry_ball(void)
{
    ball.previous = ball.position;
    ball.position = held_at;
    exact = (flight){ held_at, verlet_velocity(&ball, pull(), step_length()), 0, false };
    now = time_of = worst = 0;
    trails = 0;
    look_ahead();
}

static void step(void)
{
    bool is_over = now > LONG || fabs(ball.position.x - WIDE / 2) > WIDE;
    if (is_over && !is_held && ball.inverse_mass > 0) begin();
    now += 1.0 / 60;
    while (time_of + step_length() < now + 1e-9) {
        time_of += step_length();
        if (is_held) carry_ball();
        else         step_ball();
        if (trails < TRAIL) trail[trails++] = ball.position;
    }
}

static void measure(void)
{
    vec3 v = verlet_velocity(&ball, pull(), step_length());
    real moving = MASS * vec3_length_squared(v) / 2, high = MASS * live_dial(GRAVITY) * ball.position.y;
    real off = vec3_distance(ball.position, exact_at(&exact, time_of));
    worst = real_max(worst, off);
    live_value(ENERGY, MOVING, moving);
    live_value(ENERGY, HIGH, high);
    live_value(ENERGY, SUM, moving + high);
    live_value(OFF, 0, ball.inverse_mass > 0 ? 1000 * off : 0);
    if (ball.inverse_mass == 0) live_say("A particle of infinite mass stays where it is.");
    else live_say("%.2f m high, %.2f m/s fast. So far at most %.3g mm off the dashed path.", ball.position.y, vec3_length(v), 1000 * worst);
}

// --- Hands ------------------------------------------------------------------------
static void move(int number, vec3 to)
{
    (void)number;
    is_held = true;
    held_at = vec3_make(to.x, real_max(0, to.y), 0);
}

static void release(int number)
{
    (void)number;
    is_held = false;
}

// Of infinite mass, or of one kilogram again, and then it falls from where it is.
static void press(int button)
{
    (void)button;
    bool falls = ball.inverse_mass == 0;
    ball = particle_start(ball.position, vec3_make(0, 0, 0), pull(), falls ? 1 / MASS : 0, step_length());
    exact = (flight){ ball.position, { 0, 0, 0 }, time_of, false };
    look_ahead();
}

// --- Drawing ----------------------------------------------------------------------
static void draw_ground(void)
{
    live_line(LIVE_INK, (vec3[]){ { -1, 0, 0 }, { 8, 0, 0 } }, 2);
    for (int y = 1; y <= 3; y++) {
        char text[8];
        snprintf(text, sizeof text, "%d m", y);
        live_line(LIVE_RULE, (vec3[]){ { -1, y, 0 }, { 8, y, 0 } }, 2);
        live_label(LIVE_QUIET, vec3_make(-0.28, y + 0.05, 0), text);
    }
}

static void draw(void)
{
    draw_ground();
    if (ball.inverse_mass > 0) live_dashes(LIVE_QUIET, ahead, AHEAD);
    for (int k = 0; k < trails; k++) live_dot(LIVE_BLUE, trail[k], 2);
    live_circle(LIVE_BLUE, ball.position, RADIUS);
    live_line(LIVE_ORANGE, (vec3[]){ ball.previous, ball.position }, 2);
    live_dot(LIVE_ORANGE, ball.previous, 4);
    live_handle(0, LIVE_BLUE, ball.position, "the ball");
}

static unsigned long long hash(void)
{
    return live_hash(live_hash(LIVE_HASH, &ball, sizeof ball), &exact.x, sizeof(vec3));
}

const live_figure figure = {
    .name = "bounce",
    .says = "A ball flies and bounces on a floor; a dot stands where it was after each step, and dashes show the exact path",
    .pane = { { -0.4, -0.25, 7, 3.7 } },
    .dial = {
        [GRAVITY] = { "gravity, m/s²", NULL, 0, 25, 0.01, 9.81, NULL, true },
        [FLOOR] = { "speed kept at the floor", NULL, 0, 1, 0.05, 0.75, NULL, true },
        [WIND] = { "wind, m/s²", NULL, -3, 3, 0.1, 0, NULL, true },
        [STEP] = { "a step, s", NULL, 0, 3, 1, 2, "1/120|1/60|1/30|1/10", true },
    },
    .button = { "Infinite mass, and back" },
    .chart = {
        [ENERGY] = { "energy of 1 kg", "J", { "of motion", "of height", "sum" }, 0, 30, false, false, NULL },
        [OFF] = { "off the exact path", "mm", { NULL }, 0.01, 1000, true, false, NULL },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash,
    .press = press, .move = move, .release = release,
};
