// cradle.c - Newton's cradle: five balls on strings, and one is let go.
#include "example.h"

#include <math.h>

enum { BALLS = 5 };
static tumble_body ball[BALLS];
static double fastest_first, fastest_last;

static tumble_options elastic(void)
{
    tumble_options o = tumble_options_default();
    o.restitution = 1;
    o.friction = 0;
    o.substeps = 20;
    return o;
}

static void build(tumble_world *w)
{
    const double radius = 0.1, length = 1;      // m
    tumble_shape s = tumble_shape_sphere(w, radius, 0.5);
    fastest_first = fastest_last = 0;
    for (int k = 0; k < BALLS; k++) {
        double x = 2.0005 * radius * k, lift = k == 0 ? 0.7 : 0;    // rad
        tumble_body_options at = tumble_body_at(x - length * sin(lift),
                                                -length * cos(lift), 0);
        ball[k] = tumble_body_add(w, s, at);
        for (int side = -1; side <= 1; side += 2) {
            tumble_vec3 nail = tumble_v(x, 0, 0.5 * side);
            double string = sqrt(length * length + 0.25);
            tumble_joint_distance(w, ball[k], at.pose.position,
                                  tumble_body_ground(), nail, 0, string);
        }
    }
}

static void act(tumble_world *w)
{
    fastest_first = fmax(fastest_first, tumble_body_velocity(w, ball[0]).x);
    fastest_last = fmax(fastest_last,
                        tumble_body_velocity(w, ball[BALLS - 1]).x);
}

static double lost(tumble_world *w)
{
    (void)w;
    double should_be = sqrt(2 * 9.81 * (1 - cos(0.7)));
    return fabs(fastest_last - should_be) / should_be;
}

const example cradle = {
    .name = "cradle", .about = "Newton's, with five balls", .seconds = 1,
    .eye = { 0.9, -0.3, 2.6 }, .target = { 0.35, -0.6, 0 },
    .options = elastic, .build = build, .act = act,
    .claim = "the last ball leaves with the speed of the first, to 2 %",
    .error = lost, .most = 0.02 };
