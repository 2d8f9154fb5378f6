//> car
// car.c - a car on four springs drives off, and brakes with locked wheels.  A
// wheel is a ball: that rolls like one, and needs no other shape.
#include "example.h"

#include <math.h>

enum { WHEELS = 4 };
static const double RADIUS = 0.35, SPEED = 10, GRIP = 0.8;  // m, m/s
static tumble_body car;
static tumble_joint axle[WHEELS];
static double began, entry, rim;        // m, m/s, m/s

static void build(tumble_world *w)
{
    const tumble_vec3 up = { 0, 1, 0 }, axis = { 0, 0, -1 };
    tumble_shape body = tumble_shape_box(w, tumble_v(4, 0.5, 1), 1200);
    tumble_shape hub = tumble_shape_box(w, tumble_v(0.2, 0.2, 0.1), 15);
    tumble_shape wheel = tumble_shape_sphere(w, RADIUS, 20);
    tumble_plane_add(w, up, 0, GRIP);
    car = tumble_body_add(w, body, tumble_body_at(0, 0.6, 0));
    for (int k = 0; k < WHEELS; k++) {
        tumble_body_options at = tumble_body_at(k < 2 ? -1.3 : 1.3, RADIUS,
                                                k % 2 ? 0.9 : -0.9);
        tumble_body_options hidden = at;
        at.friction = GRIP;
        hidden.mask = 0;                                    // meets nothing
        tumble_body leg = tumble_body_add(w, hub, hidden);
        tumble_body tyre = tumble_body_add(w, wheel, at);
        tumble_joint s = tumble_joint_slider(w, car, leg, at.pose.position, up);
        tumble_joint_set_limits(w, s, -0.1, 0.1);           // m
        tumble_joint_set_spring(w, s, -0.1, 30000, 3000);   // N/m, N s/m
        axle[k] = tumble_joint_hinge(w, leg, tyre, at.pose.position, axis);
        tumble_joint_set_motor(w, axle[k], SPEED / RADIUS, 800);     // rad/s, N m
    }
}

// After two seconds it brakes: a motor without speed, and of any strength.
static void act(tumble_world *w)
{
    if (fabs(tumble_world_time(w) - 2) > 0.001) return;
    began = tumble_body_position(w, car).x;
    entry = tumble_body_velocity(w, car).x;
    rim = tumble_joint_speed(w, axle[0]) * RADIUS;
    for (int k = 0; k < WHEELS; k++) tumble_joint_set_motor(w, axle[k], 0, 1e5);
}

static int laws(tumble_world *w, example_law *is)
{
    double way = tumble_body_position(w, car).x - began;
    is[0] = example_is("speed of the rim, w r (m/s)", entry, rim);
    is[1] = example_is("stopping way, v^2 / 2 mu g (m)",
                       entry * entry / (2 * GRIP * 9.81), way);
    return 2;
}

const example car_scene = {
    .name = "car", .about = "drives off, and brakes", .seconds = 5,
    .has_floor = true, .eye = { 9, 4, 19 }, .target = { 9, 0.3, 0 },
    .build = build, .act = act,
    .claim = "it rolls, and stops where friction says, to 1 %",
    .laws = laws, .most = 0.01 };
//<
