//> terrain
// terrain.c - boulders roll down a slope of a terrain, and into its hills.
#include "example.h"

#include <math.h>

enum { SIDE = 81, BOULDERS = 20 };
static const double WIDE = 40, RADIUS = 0.4, SLOPE = 0.2;   // m, m; a tangent
static tumble_body boulder[BOULDERS];
static double start, rolled;            // m

// m: a slope for x < 0, hills behind it, and a rim on both sides.
static double ground(double x, double z)
{
    double hills = 0.04 * x * x * (1 + 0.4 * sin(1.3 * z));
    return (x < 0 ? -SLOPE * x : hills) + fmax(0, fabs(z) - 17);
}

// A ray from above says where the ground is, and how it is inclined.
static tumble_body put(tumble_world *w, tumble_shape s, double x, double z)
{
    tumble_hit h;
    tumble_world_ray(w, tumble_v(x, 50, z), tumble_v(x, -50, z), ~0u, &h);
    return tumble_body_add(w, s, tumble_body_at(x + RADIUS * h.normal.x,
                                                h.point.y + RADIUS * h.normal.y,
                                                z));
}

static void build(tumble_world *w)
{
    static double height[SIDE * SIDE];
    tumble_shape stone = tumble_shape_sphere(w, RADIUS, 500);
    for (int k = 0; k < SIDE * SIDE; k++)
        height[k] = ground(WIDE * (k % SIDE) / (SIDE - 1) - WIDE / 2,
                           WIDE * (k / SIDE) / (SIDE - 1) - WIDE / 2);
    tumble_body_add_heights(w, height, SIDE, SIDE, WIDE, WIDE, 0,
                            tumble_body_at(0, 0, 0));
    for (int k = 0; k < BOULDERS; k++)
        boulder[k] = put(w, stone, -15, 1.5 * (k - (BOULDERS - 1) / 2.0));
    start = tumble_body_position(w, boulder[0]).x;
}

static void act(tumble_world *w)
{
    double x = tumble_body_position(w, boulder[0]).x;
    if (fabs(tumble_world_time(w) - 2) < 0.001)
        rolled = (x - start) * sqrt(1 + SLOPE * SLOPE);
}

static int laws(tumble_world *w, example_law *is)
{
    double sine = SLOPE / sqrt(1 + SLOPE * SLOPE), t = 2;
    int above = 0;
    for (int k = 0; k < BOULDERS; k++) {
        tumble_vec3 p = tumble_body_position(w, boulder[k]);
        above += p.y - ground(p.x, p.z) > 0.9 * RADIUS;
    }
    is[0] = example_is("rolled, 5/14 g sin a t^2 (m)",
                       9.81 * sine * t * t * 5 / 14, rolled);
    is[1] = example_is("boulders above the ground", BOULDERS, above);
    return 2;
}

const example terrain = {
    .name = "terrain", .about = "boulders on heights", .seconds = 20,
    .eye = { 8, 27, 42 }, .target = { 0, 1, 0 },
    .build = build, .act = act,
    .claim = "a ball rolls as on a plane, and none gets into the ground",
    .laws = laws, .most = 1e-3 };
//<
