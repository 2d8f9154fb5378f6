// topple.c - a ring of dominoes and a pyramid, by tumble.h alone (chapter 19).

#include "live.h"
#include "tumble.h"

enum { DOMINOES, FRICTION, SLEEP };             // dials
enum { AWAKE, TIME };                           // charts
enum { MOST = 60, ROWS = 5, BALLS = 12, PYRAMID = ROWS * (ROWS + 1) / 2,
       BODIES = MOST + PYRAMID + BALLS, CORNERS = 8 };
static const double RADIUS = 0.14;              // m, of a ball

static tumble_world *world;
static tumble_body body[BODIES];
static tumble_shape ball_shape;
static int bodies, boxes;

static tumble_vec3 given(vec3 v)
{
    return tumble_v(v.x, v.y, v.z);
}

static vec3 taken(tumble_vec3 v)
{
    return vec3_make(v.x, v.y, v.z);
}

static void add(tumble_shape s, tumble_body_options o)
{
    if (bodies < BODIES) body[bodies++] = tumble_body_add(world, s, o);
}

// On most of a circle: each turned from the one before by the same rotation,
// which needs no sine.
static void add_dominoes(void)
{
    tumble_shape s = tumble_shape_box(world, tumble_v(0.06, 0.5, 0.24), 0.5);
    int n = (int)live_dial(DOMINOES);
    double t = 2.3 / n, c = (1 - t * t) / (1 + t * t), d = 2 * t / (1 + t * t);
    tumble_quat turn = { 0, 0, 0, 1 };
    vec3 at = { 0, 0.25, 1.6 };
    for (int k = 0; k < n; k++) {
        tumble_body_options o = tumble_body_at(at.x, at.y, at.z);
        o.pose.rotation = turn;
        add(s, o);
        at = vec3_make(c * at.x + d * at.z, at.y, c * at.z - d * at.x);
        double w = 1 / sqrt(1 + t * t);
        turn = (tumble_quat){ 0, w * (turn.y + t * turn.w), 0, w * (turn.w - t * turn.y) };
    }
}

static void add_pyramid(void)
{
    tumble_shape s = tumble_shape_box(world, tumble_v(0.24, 0.24, 0.24), 0.5);
    for (int row = 0; row < ROWS; row++)
        for (int k = 0; k < ROWS - row; k++)
            add(s, tumble_body_at(0.26 * (k - (ROWS - 1 - row) / 2.0),
                                  0.12 + 0.24 * row, 0));
}

static void begin(void)
{
    tumble_options o = tumble_options_default();
    o.friction = live_dial(FRICTION);
    if (!live_choice(SLEEP)) o.sleep_speed = 0;
    tumble_world_free(world);
    world = tumble_world_make(&o);
    bodies = 0;
    if (!world) return;
    tumble_plane_add(world, tumble_v(0, 1, 0), 0, -1);
    ball_shape = tumble_shape_sphere(world, RADIUS, 2);
    add_dominoes();
    add_pyramid();
    boxes = bodies;
    tumble_body_push(world, body[0], tumble_v(0.45, 0, 0),
                     tumble_v(0, 0.45, 1.6));
}

// --- Hands ------------------------------------------------------------------------
static void press(int button)
{
    (void)button;
    if (!world || bodies == BODIES) return;
    tumble_body_options o = tumble_body_at(0.1 * (bodies % 5) - 0.2, 0.9, 3);
    o.velocity = tumble_v(0, 1.5, -6);
    add(ball_shape, o);
}

static void tap(int number, vec3 along)
{
    if (number < 0 || number >= bodies) return;
    vec3 J = vec3_scale(2.5 * tumble_body_mass(world, body[number]), along);
    tumble_body_push(world, body[number], given(J),
                     tumble_body_position(world, body[number]));
}

static void pull(int k)
{
    tumble_vec3 at = tumble_body_position(world, body[k]);
    vec3 a = live_pull(taken(at), taken(tumble_body_velocity(world, body[k])));
    tumble_body_push(world, body[k],
                     given(vec3_scale(tumble_body_mass(world, body[k]) / 60,
                                      a)), at);
}

// --- Frames -----------------------------------------------------------------------
static void step(void)
{
    if (!world) return;
    if (live_held() >= 0) pull(live_held());
    tumble_world_step(world);
}

static void measure(void)
{
    if (!world) return;
    tumble_report r = tumble_world_last_step(world);
    live_value(AWAKE, 0, r.bodies - r.asleep);
    if (tumble_world_failure(world))
        live_say("%s.", tumble_world_failure(world));
    else live_say("%d bodies, %d asleep; %d contacts, %d substeps.", r.bodies, r.asleep, r.contacts, r.substeps);
}

static void draw_box(int k)
{
    tumble_vec3 vertex[CORNERS];
    vec3 at[CORNERS];
    int faces;
    const int *face = tumble_body_triangles(world, body[k], &faces);
    tumble_body_vertices(world, body[k], vertex, CORNERS);
    for (int i = 0; i < CORNERS; i++) at[i] = taken(vertex[i]);
    live_colour awake = k < boxes - PYRAMID ? LIVE_BLUE : LIVE_ORANGE;
    live_mesh(k, tumble_body_is_awake(world, body[k]) ? awake : LIVE_GREY, at,
              CORNERS, face, faces, false);
}

static void draw(void)
{
    if (!world) return;
    for (int k = 0; k < boxes; k++) draw_box(k);
    for (int k = boxes; k < bodies; k++)
        live_ball(k,
                  tumble_body_is_awake(world, body[k]) ? LIVE_GREEN : LIVE_GREY,
                  taken(tumble_body_position(world, body[k])), RADIUS);
}

static unsigned long long hash(void)
{
    return world ? tumble_world_hash(world) : 0;
}

const live_figure figure = {
    .name = "topple",
    .says = "A ring of dominoes falls around a pyramid of boxes; what sleeps is grey",
    .camera = { .distance = 6.2, .turn = 0.5, .rise = 0.5, .target = { 0, 0.3, 0 }, .has_floor = true },
    .dial = {
        [DOMINOES] = { "dominoes", NULL, 10, MOST, 1, 40, NULL, true },
        [FRICTION] = { "friction", NULL, 0, 1, 0.05, 0.5, NULL, true },
        [SLEEP] = { "bodies at rest", NULL, 0, 1, 1, 1, "keep awake|fall asleep", true },
    },
    .button = { "Throw a ball" },
    .chart = {
        [AWAKE] = { "bodies awake", NULL, { NULL }, 0, 10, false, false, NULL },
        [TIME] = { "time of a frame", "ms", { NULL }, 0, 0.2, false, true, NULL },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash,
    .press = press, .tap = tap,
};
