// tree.c - a ball swings into a hammock: which spheres of the hammock's tree are
// asked? (chapter 6)

#include "body.h"
#include "live.h"
#include "sphere_tree.h"

enum { LEVEL, SIZE };                           // dials
enum { ASKED, ITSELF };                         // charts
enum { TREE, ALL };                             // lines of charts
enum { SIDE = 17, PARTICLES = SIDE * SIDE, FACES = 2 * (SIDE - 1) * (SIDE - 1) };
enum { STEPS = 4, ITERATIONS = 8, PAIRS = 4096, ARCS = 24 };
static const real DT = 1.0 / (60 * STEPS);
static const real SWING = 2.2;                  // 1/s, of the ball, times 2 pi
static const vec3 GRAVITY = { 0, -9.81, 0 }, MIDDLE = { 0.2, 0.95, 0.1 };

static shape cloth;
static sphere_tree tree, ball_tree;
static bool is_ready, is_held;
static particle p[PARTICLES];
static vec3 at[PARTICLES], ball, velocity;
static leaf_pair pair[PAIRS];
static tree_result asked, itself;

// --- The hammock and the ball -----------------------------------------------------
// Pinned at the corners and in the middles of two sides.
static bool is_pinned(int i)
{
    int column = i % SIDE, row = i / SIDE;
    return column % (SIDE - 1) == 0 && row % (SIDE / 2) == 0;
}

static void hang(void)
{
    for (int i = 0; i < PARTICLES; i++) {
        at[i] = vec3_make(0.9 * cloth.at[i].x, 1, 0.97 * cloth.at[i].z);
        p[i] = particle_start(at[i], vec3_make(0, 0, 0), GRAVITY, is_pinned(i) ? 0 : PARTICLES, DT);
    }
}

static status build(void)
{
    leaf_feature leaf[FACES], point = { 1, { 0 } };
    status done = shape_cloth(&cloth, SIDE, SIDE, 1.8, 1.8, 1, 0.3);
    if (!done.ok) return done;
    for (int f = 0; f < FACES; f++) {
        const int *v = &cloth.face[3 * f];
        leaf[f] = (leaf_feature){ 3, { v[0], v[1], v[2] } };
    }
    hang();
    ball = vec3_make(0.1, 1.55, -0.1);
    velocity = vec3_make(0, 0, 0);
    done = sphere_tree_build(&tree, TREE_LAYERED, cloth.at, leaf, FACES, 0.005, 0);
    if (done.ok) done = sphere_tree_build(&ball_tree, TREE_LAYERED, &ball, &point, 1, live_dial(SIZE), 0);
    return done;
}

static void begin(void)
{
    shape_free(&cloth);
    sphere_tree_free(&tree);
    sphere_tree_free(&ball_tree);
    status done = build();
    is_ready = done.ok;
    is_held = false;
    if (!done.ok) live_say("%s", done.why);
}

// What has come into the ball goes back to its surface.
static void keep_out(void)
{
    for (int i = 0; i < PARTICLES; i++) {
        vec3 out = vec3_sub(p[i].position, ball);
        real least = live_dial(SIZE) + 0.03;
        if (p[i].inverse_mass > 0 && vec3_length(out) < least)
            p[i].position = vec3_add_scaled(ball, least, vec3_unit(out));
    }
}

// The ball swings as a weight on a spring does.
static void swing(void)
{
    if (is_held) return;
    velocity = vec3_add_scaled(velocity, -SWING * SWING * DT, vec3_sub(ball, MIDDLE));
    ball = vec3_add_scaled(ball, DT, velocity);
}

static void step(void)
{
    for (int k = 0; k < STEPS && is_ready; k++) {
        swing();
        for (int i = 0; i < PARTICLES; i++)     // the air brakes
            p[i].previous = vec3_add_scaled(p[i].previous, 0.01, vec3_sub(p[i].position, p[i].previous));
        verlet_step(p, PARTICLES, GRAVITY, NULL, DT);
        for (int n = 0; n < ITERATIONS; n++) {
            sticks_iterate(cloth.stick, cloth.sticks, p, relax_options_pbd());
            keep_out();
        }
    }
    for (int i = 0; i < PARTICLES; i++) at[i] = p[i].position;
    sphere_tree_refresh(&tree, at);
    sphere_tree_refresh(&ball_tree, &ball);
    asked = sphere_tree_pairs(&tree, at, &ball_tree, &ball, 0, pair, PAIRS);
    itself = sphere_tree_self(&tree, at, 0, 1.001, pair, PAIRS);
}

static void measure(void)
{
    live_value(ASKED, TREE, asked.visited);
    live_value(ASKED, ALL, FACES);
    live_value(ITSELF, TREE, itself.visited);
    live_value(ITSELF, ALL, FACES * (FACES - 1) / 2);
    live_say("The ball: %d spheres are asked, and %d of %d triangles are near. The cloth itself: %d pairs of spheres, and %d pairs of triangles are near.",
             asked.visited, asked.pairs, FACES, itself.visited, itself.pairs);
}

// --- Hands ------------------------------------------------------------------------
static void move(int number, vec3 to)
{
    (void)number;
    ball = to;
    velocity = vec3_make(0, 0, 0);
    is_held = true;
}

static void release(int number)
{
    (void)number;
    is_held = false;
}

// --- Drawing ----------------------------------------------------------------------
static bool is_near(sphere s)
{
    return vec3_distance(s.center, ball) < s.radius + live_dial(SIZE);
}

static vec3 on_circle(sphere s, int plane, int k)
{
    real t = (k % (ARCS / 2)) / (ARCS / 4.0) - 1, sign = k < ARCS / 2 ? 1 : -1;
    real c = sign * (1 - t * t) / (1 + t * t), d = sign * 2 * t / (1 + t * t);
    vec3 out = plane == 0 ? vec3_make(c, d, 0) : plane == 1 ? vec3_make(0, c, d) : vec3_make(d, 0, c);
    return vec3_add_scaled(s.center, s.radius, out);
}

static void draw_sphere(live_colour colour, sphere s)
{
    for (int plane = 0; plane < 3; plane++)
        for (int k = 0; k < ARCS; k++)
            live_edge(colour, on_circle(s, plane, k), on_circle(s, plane, (k + 1) % ARCS));
}

static int painted[2][3 * FACES], paints[2];    // faces: left aside, and near

static void paint(int node, int kind)
{
    const tree_node *n = &tree.node[node];
    if (n->child[0] >= 0) {
        paint(n->child[0], kind);
        paint(n->child[1], kind);
        return;
    }
    for (int k = 0; k < 3; k++) painted[kind][3 * paints[kind] + k] = tree.leaf[node].vertex[k];
    paints[kind]++;
}

// As the query goes down: a sphere that is near is opened.
static void descend(int node, int level)
{
    const tree_node *n = &tree.node[node];
    bool near = is_near(n->ball), is_last = level == (int)live_dial(LEVEL) || n->child[0] < 0;
    if (level == (int)live_dial(LEVEL)) draw_sphere(near ? LIVE_RED : LIVE_QUIET, n->ball);
    if (!near || is_last) {
        paint(node, near);
        return;
    }
    descend(n->child[0], level + 1);
    descend(n->child[1], level + 1);
}

static void draw(void)
{
    if (!is_ready) return;
    paints[0] = paints[1] = 0;
    descend(tree.nodes - 1, 0);
    live_mesh(-1, LIVE_BLUE, at, PARTICLES, painted[0], paints[0], true);
    live_mesh(-1, LIVE_ORANGE, at, PARTICLES, painted[1], paints[1], true);
    live_ball(0, LIVE_GREEN, ball, live_dial(SIZE));
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, at, sizeof at);
    h = live_hash(h, &asked, sizeof asked);
    return live_hash(h, &itself, sizeof itself);
}

const live_figure figure = {
    .name = "tree",
    .says = "A ball swings into a cloth that hangs like a hammock; wire spheres are those of the cloth's tree that are asked at one level",
    .camera = { .distance = 4.3, .turn = 0.5, .rise = 0.42, .target = { 0, 0.82, 0 }, .has_floor = true },
    .dial = {
        [LEVEL] = { "level that is shown", NULL, 0, 10, 1, 3, NULL, false },
        [SIZE] = { "radius of the ball", "m", 0.05, 0.5, 0.01, 0.22, NULL, true },
    },
    .chart = {
        [ASKED] = { "spheres asked for the ball", NULL, { "by the tree", "every leaf" }, 1, 1000, true, false, NULL },
        [ITSELF] = { "pairs of the cloth itself", NULL, { "by the tree", "every pair" }, 1000, 100000, true, false, NULL },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash,
    .move = move, .release = release,
};
