// flag.c - a flag on a pole, in a wind that turns.
#include "example.h"

#include <math.h>

enum { COLUMNS = 30, ROWS = 20 };
static tumble_body cloth;

static void build(tumble_world *w)
{
    tumble_shape s = tumble_shape_cloth(w, COLUMNS, ROWS, 1.5, 1, 0.3);
    tumble_body_options at = tumble_body_at(0.75, 3, 0);
    at.pose.rotation = tumble_quat_turn(tumble_v(1, 0, 0), 1.5707963);
    cloth = tumble_body_add(w, s, at);
    for (int j = 0; j < ROWS; j++) tumble_body_pin(w, cloth, j * COLUMNS);
}

static tumble_vec3 less(tumble_vec3 a, tumble_vec3 b)
{
    return tumble_v(a.x - b.x, a.y - b.y, a.z - b.z);
}

// Air pushes every triangle along its normal, by how fast it comes from there.
static void act(tumble_world *w)
{
    static tumble_vec3 at[COLUMNS * ROWS];
    const double air = 1.2, speed = 8, dt = 1.0 / 60;   // kg/m^3, m/s, s
    double angle = 0.4 * sin(0.7 * tumble_world_time(w));
    tumble_vec3 wind = tumble_v(speed * cos(angle), 0, speed * sin(angle));
    int n;
    const int *corner = tumble_body_triangles(w, cloth, &n);
    tumble_body_vertices(w, cloth, at, COLUMNS * ROWS);
    for (int k = 0; k < n; k++) {
        const int *c = corner + 3 * k;
        tumble_vec3 p = less(at[c[1]], at[c[0]]), q = less(at[c[2]], at[c[0]]);
        tumble_vec3 d = tumble_v(p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z,
                                 p.x * q.y - p.y * q.x);
        double twice = sqrt(d.x * d.x + d.y * d.y + d.z * d.z);     // m^2
        double from = (wind.x * d.x + wind.z * d.z) / twice;        // m/s
        double push = air * fabs(from) * from / 2 * dt / 3 / 2;     // N s/m^2
        for (int i = 0; i < 3; i++)
            tumble_body_push_vertex(w, cloth, c[i],
                                    tumble_v(push * d.x, push * d.y,
                                             push * d.z));
    }
}

static double strain(tumble_world *w)
{
    bool flies = tumble_body_position(w, cloth).x > 0.4;
    return flies ? tumble_world_measure(w).strain : 1;
}

const example flag = {
    .name = "flag", .about = "on a pole, in the wind", .seconds = 10,
    .eye = { 1, 3.2, 3.1 }, .target = { 0.75, 2.8, 0 },
    .build = build, .act = act,
    .claim = "it flies, and no thread is strained by more than 2 %",
    .error = strain, .most = 0.02 };
