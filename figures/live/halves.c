// halves.c - half-edges, walked: around a face, around a vertex, along a rim
// (chapter 24).

#include "live.h"
#include "mesh.h"

enum { WALK };                                  // dial
enum { FACE, VERTEX, RIM };
enum { NEXT, TWIN };                            // buttons
enum { COLUMNS = 5, ROWS = 4, VERTICES = COLUMNS * ROWS, FACES = 2 * (COLUMNS - 1) * (ROWS - 1) - 1, PACE = 40 };

static mesh net;
static bool is_ready, is_paced = true;          // goes on by itself
static int here, steps, frame;                  // the half-edge; since the start

static vec3 place(int v)
{
    int column = v % COLUMNS, row = v / COLUMNS;
    return vec3_make(-2.35 + 1.0 * column + 0.35 * row + 0.06 * ((v * 7) % 3), -1.3 + 0.85 * row + 0.05 * ((v * 5) % 4), 0);
}

// All but one triangle in the middle: so there is a hole.
static status build(void)
{
    int triangle[FACES + 1][3], n = 0;
    for (int row = 0; row + 1 < ROWS; row++)
        for (int column = 0; column + 1 < COLUMNS; column++) {
            int a = row * COLUMNS + column, b = a + 1, c = a + COLUMNS + 1, d = a + COLUMNS;
            const int lower[3] = { a, b, c }, upper[3] = { a, c, d };
            bool is_hole = row == 1 && column == 2;
            for (int k = 0; k < 3 && !is_hole; k++) triangle[n][k] = lower[k];
            n += !is_hole;
            for (int k = 0; k < 3; k++) triangle[n][k] = upper[k];
            n++;
        }
    return mesh_build(&net, VERTICES, (const int (*)[3])triangle, n);
}

static void tell(void)
{
    static const char *const way[] = { "around a face", "around a vertex", "along a rim" };
    const half_edge *h = &net.half[here];
    if (h->face >= 0)
        live_say("%d steps %s. Half-edge %d goes from vertex %d to %d, with face %d on its left.", steps, way[live_choice(WALK)],
                 here, h->origin, mesh_target(&net, here), h->face);
    else
        live_say("%d steps %s. Half-edge %d goes from vertex %d to %d, and on its left there is no face.", steps, way[live_choice(WALK)],
                 here, h->origin, mesh_target(&net, here));
}

// The start of each walk: a face in the middle, or the rim of the hole.
static void begin(void)
{
    if (!net.half) is_ready = build().ok;
    if (!is_ready) return;
    here = net.face_half[10];
    for (int h = 0; h < 2 * net.edges && live_choice(WALK) == RIM; h++)
        if (net.half[h].face < 0 && net.half[h].origin == COLUMNS + 2) here = h;
    steps = frame = 0;
    is_paced = true;
    tell();
}

static void go_on(void)
{
    here = live_choice(WALK) == VERTEX ? mesh_around(&net, here) : net.half[here].next;
    steps++;
    frame = 0;
}

static void step(void)
{
    if (!is_ready) return;
    if (++frame >= PACE && is_paced) go_on();
    tell();
}

static void press(int button)
{
    if (!is_ready) return;
    is_paced = false;
    here = button == TWIN ? mesh_twin(here) : net.half[here].next;
    steps++;
    tell();
}

// --- Drawing ----------------------------------------------------------------------
// A half-edge lies on the left of its edge, a little shorter.
typedef struct { vec3 from, to; } span;

static span span_of(int h)
{
    vec3 a = place(net.half[h].origin), b = place(mesh_target(&net, h)), e = vec3_unit(vec3_sub(b, a));
    vec3 aside = vec3_make(-0.07 * e.y, 0.07 * e.x, 0);
    return (span){ vec3_add(vec3_add_scaled(a, 0.16, e), aside), vec3_add(vec3_add_scaled(b, -0.16, e), aside) };
}

static vec3 middle_of(int h)
{
    span s = span_of(h);
    return vec3_scale(0.5, vec3_add(s.from, s.to));
}

// The half-edge that is nearest to the hand.
static void move(int number, vec3 to)
{
    (void)number;
    if (!is_ready) return;
    to.z = 0;
    for (int h = 0; h < 2 * net.edges; h++)
        if (vec3_distance(middle_of(h), to) < vec3_distance(middle_of(here), to)) here = h;
    steps = frame = 0;
    tell();
}

static void draw_half(int h, live_colour c)
{
    span s = span_of(h);
    live_arrow(c, s.from, s.to);
}

static void draw(void)
{
    if (!is_ready) return;
    for (int f = 0; f < net.faces; f++) {
        int v[3];
        mesh_face(&net, f, v);
        live_area(f == net.half[here].face ? LIVE_ORANGE : LIVE_GREY, (vec3[]){ place(v[0]), place(v[1]), place(v[2]) }, 3);
    }
    draw_half(mesh_twin(here), LIVE_GREEN);
    draw_half(net.half[here].next, LIVE_PURPLE);
    draw_half(here, LIVE_ORANGE);
    live_dot(LIVE_ORANGE, place(net.half[here].origin), 6);
    live_handle(0, LIVE_ORANGE, middle_of(here), "half-edge");
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, (int[]){ here, steps, frame }, 3 * sizeof(int));
    return is_ready ? live_hash(h, net.half, (size_t)(2 * net.edges) * sizeof *net.half) : h;
}

const live_figure figure = {
    .name = "halves",
    .says = "A flat net of triangles with a hole; one half-edge is orange, the next one purple, and its twin green",
    .pane = { { -3.1, -1.6, 6.6, 3.15 } },
    .dial = { [WALK] = { "walk", NULL, 0, 2, 1, FACE, "around a face|around a vertex|along a rim", true } },
    .button = { [NEXT] = "Next", [TWIN] = "Twin" },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .press = press, .move = move,
};
