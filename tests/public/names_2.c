// names_2.c - a program that was written for version 2 of tumble.h: it declares all
// functions as that did, calls some, and prints how many it has and that README's
// box fell as it did.  check_names.sh compiles it.
#include "tumble.h"

#include <stdio.h>

// A name that is gone would be declared here in silence, but not be linked with; one
// that stands for another function is refused by the compiler.
#ifdef __cplusplus
extern "C" {
#endif
tumble_quat tumble_turn(tumble_vec3 axis, double angle);
void tumble_matrix(tumble_quat q, double m[9]);
tumble_quat tumble_from_matrix(const double m[9]);
tumble_vec3 tumble_rotate(tumble_quat q, tumble_vec3 v);
tumble_vec3 tumble_to_world(tumble_pose at, tumble_vec3 local);
tumble_vec3 tumble_to_local(tumble_pose at, tumble_vec3 point);
const char *tumble_version(void);
int tumble_version_number(void);
tumble_options tumble_options_default(void);
tumble_world *tumble_make(const tumble_options *options);
void tumble_free(tumble_world *w);
const char *tumble_failure(const tumble_world *w);
void tumble_forget_failure(tumble_world *w);
void tumble_step(tumble_world *w);
double tumble_time(const tumble_world *w);
bool tumble_set_gravity(tumble_world *w, tumble_vec3 gravity);
tumble_plane tumble_add_plane(tumble_world *w, tumble_vec3 normal,
                              double offset, double friction);
bool tumble_remove_plane(tumble_world *w, tumble_plane p);
tumble_report tumble_last_step(const tumble_world *w);
tumble_measures tumble_measure(const tumble_world *w);
unsigned long long tumble_hash(const tumble_world *w);
size_t tumble_save(const tumble_world *w, void *into, size_t room);
tumble_world *tumble_load(const void *from, size_t size);
void tumble_run_on(tumble_world *w,
                   void (*run)(void *context,
                               void (*work)(void *data, int item), void *data,
                               int items),
                   void *context);
tumble_options tumble_get_world_options(const tumble_world *w);
bool tumble_restore(tumble_world *w, const void *from, size_t size);
tumble_shape tumble_box(tumble_world *w, tumble_vec3 sides, double mass);
tumble_shape tumble_icosahedron(tumble_world *w, double radius, double mass);
tumble_shape tumble_sphere(tumble_world *w, double radius, double mass);
tumble_shape tumble_capsule(tumble_world *w, double length, double radius,
                            double mass);
tumble_shape tumble_hull(tumble_world *w, const tumble_vec3 *point, int n,
                         double mass);
tumble_shape tumble_obj(tumble_world *w, const char *path, double radius,
                        double mass);
tumble_shape tumble_rope(tumble_world *w, int n, double length, double mass);
tumble_shape tumble_cloth(tumble_world *w, int columns, int rows, double width,
                          double depth, double mass);
bool tumble_drop_shape(tumble_world *w, tumble_shape s);
tumble_shape tumble_weigh(tumble_world *w, tumble_shape s, double mass,
                          tumble_vec3 center, const double inertia[6]);
tumble_shape tumble_round(tumble_world *w, tumble_shape s, double radius);
tumble_body_options tumble_at(double x, double y, double z);
tumble_body tumble_add(tumble_world *w, tumble_shape s, tumble_body_options o);
tumble_body tumble_add_pieces(tumble_world *w, const tumble_shape *piece,
                              const tumble_pose *pose, int n,
                              tumble_body_options o);
tumble_body tumble_add_compound(tumble_world *w, const tumble_shape *piece,
                                const tumble_pose *pose, int n,
                                tumble_body_options o);
tumble_body tumble_add_mesh(tumble_world *w, const tumble_vec3 *point,
                            int points, const int *triangle, int triangles,
                            double thickness, tumble_body_options o);
tumble_body tumble_add_heights(tumble_world *w, const double *height,
                               int columns, int rows, double width,
                               double depth, double thickness,
                               tumble_body_options o);
bool tumble_remove(tumble_world *w, tumble_body b);
bool tumble_has(const tumble_world *w, tumble_body b);
int tumble_bodies(const tumble_world *w, tumble_body *out, int most);
tumble_pose tumble_get_pose(const tumble_world *w, tumble_body b);
tumble_vec3 tumble_position(const tumble_world *w, tumble_body b);
tumble_vec3 tumble_velocity(const tumble_world *w, tumble_body b);
tumble_vec3 tumble_spin(const tumble_world *w, tumble_body b);
double tumble_mass(const tumble_world *w, tumble_body b);
void  *tumble_user(const tumble_world *w, tumble_body b);
bool tumble_set_pose(tumble_world *w, tumble_body b, tumble_pose pose);
bool tumble_set_velocity(tumble_world *w, tumble_body b, tumble_vec3 velocity,
                         tumble_vec3 spin);
bool tumble_push(tumble_world *w, tumble_body b, tumble_vec3 impulse,
                 tumble_vec3 at);
bool tumble_force(tumble_world *w, tumble_body b, tumble_vec3 force,
                  tumble_vec3 torque);
bool tumble_wake(tumble_world *w, tumble_body b);
bool tumble_sleep(tumble_world *w, tumble_body b);
bool tumble_is_awake(const tumble_world *w, tumble_body b);
bool tumble_set_material(tumble_world *w, tumble_body b, double friction,
                         double restitution);
bool tumble_set_damping(tumble_world *w, tumble_body b, double damping,
                        double spin_damping);
bool tumble_set_filter(tumble_world *w, tumble_body b, unsigned group,
                       unsigned mask);
bool tumble_set_user(tumble_world *w, tumble_body b, void *user);
void tumble_get_poses(const tumble_world *w, const tumble_body *b, int n,
                      tumble_pose *out);
void tumble_get_velocities(const tumble_world *w, const tumble_body *b, int n,
                           tumble_vec3 *velocity, tumble_vec3 *spin);
int tumble_moved(const tumble_world *w, tumble_body *out, int most);
tumble_body_options tumble_get_options(const tumble_world *w, tumble_body b);
tumble_shape tumble_shape_of(const tumble_world *w, tumble_body b);
bool tumble_force_at(tumble_world *w, tumble_body b, tumble_vec3 force,
                     tumble_vec3 at);
bool tumble_set_kind(tumble_world *w, tumble_body b, tumble_kind kind);
bool tumble_set_gravity_scale(tumble_world *w, tumble_body b, double scale);
double tumble_gravity_scale(const tumble_world *w, tumble_body b);
bool tumble_set_locked(tumble_world *w, tumble_body b, unsigned axes);
unsigned tumble_locked(const tumble_world *w, tumble_body b);
int tumble_vertices(const tumble_world *w, tumble_body b, tumble_vec3 *out,
                    int most);
const int *tumble_triangles(const tumble_world *w, tumble_body b, int *count);
bool tumble_pin(tumble_world *w, tumble_body b, int i);
bool tumble_unpin(tumble_world *w, tumble_body b, int i);
tumble_vec3 tumble_vertex(const tumble_world *w, tumble_body b, int i);
bool tumble_push_vertex(tumble_world *w, tumble_body b, int i,
                        tumble_vec3 impulse);
bool tumble_set_bending(tumble_world *w, tumble_body b, double stiffness);
bool tumble_set_stretch(tumble_world *w, tumble_body b, double compliance);
tumble_body tumble_ground(void);
tumble_joint tumble_ball(tumble_world *w, tumble_body a, tumble_body b,
                         tumble_vec3 at);
tumble_joint tumble_hinge(tumble_world *w, tumble_body a, tumble_body b,
                          tumble_vec3 at, tumble_vec3 axis);
tumble_joint tumble_slider(tumble_world *w, tumble_body a, tumble_body b,
                           tumble_vec3 at, tumble_vec3 axis);
bool tumble_set_limits(tumble_world *w, tumble_joint j, double least,
                       double most);
bool tumble_set_cone(tumble_world *w, tumble_joint j, tumble_vec3 axis,
                     double swing, double least, double most);
bool tumble_set_motor(tumble_world *w, tumble_joint j, double speed,
                      double force);
bool tumble_set_spring(tumble_world *w, tumble_joint j, double rest,
                       double stiffness, double damping);
bool tumble_set_servo(tumble_world *w, tumble_joint j, double place,
                      double hertz, double ratio, double force);
tumble_joint tumble_fix(tumble_world *w, tumble_body a, tumble_body b,
                        tumble_vec3 at);
tumble_joint tumble_distance(tumble_world *w, tumble_body a, tumble_vec3 at_a,
                             tumble_body b, tumble_vec3 at_b, double least,
                             double most);
tumble_joint tumble_hang(tumble_world *w, tumble_body soft, int i,
                         tumble_body b);
bool tumble_set_strength(tumble_world *w, tumble_joint j, double force);
bool tumble_unjoin(tumble_world *w, tumble_joint j);
bool tumble_is_joined(const tumble_world *w, tumble_joint j);
double tumble_joint_place(const tumble_world *w, tumble_joint j);
double tumble_joint_speed(const tumble_world *w, tumble_joint j);
double tumble_joint_swing(const tumble_world *w, tumble_joint j);
double tumble_joint_twist(const tumble_world *w, tumble_joint j);
double tumble_joint_drive(const tumble_world *w, tumble_joint j);
double tumble_joint_gap(const tumble_world *w, tumble_joint j);
double tumble_joint_force(const tumble_world *w, tumble_joint j);
double tumble_hinge_angle(const tumble_world *w, tumble_joint j);
bool tumble_set_touching(tumble_world *w, tumble_joint j, bool may_touch);
bool tumble_may_touch(const tumble_world *w, tumble_joint j);
int tumble_joints(const tumble_world *w, tumble_joint *out, int most);
tumble_body tumble_joint_body(const tumble_world *w, tumble_joint j, int side);
bool tumble_ray(const tumble_world *w, tumble_vec3 from, tumble_vec3 to,
                unsigned mask, tumble_hit *hit);
bool tumble_nearest(const tumble_world *w, tumble_vec3 x, double most,
                    unsigned mask, tumble_hit *hit);
int tumble_overlap(const tumble_world *w, tumble_shape s, tumble_pose pose,
                   unsigned mask, tumble_body *out, int most);
bool tumble_sweep(const tumble_world *w, tumble_shape s, tumble_pose pose,
                  tumble_vec3 way, unsigned mask, tumble_hit *hit);
bool tumble_sweep_turning(const tumble_world *w, tumble_shape s,
                          tumble_pose pose, tumble_vec3 way, tumble_vec3 turn,
                          unsigned mask, tumble_hit *hit);
int tumble_ray_all(const tumble_world *w, tumble_vec3 from, tumble_vec3 to,
                   unsigned mask, tumble_hit *out, int most);
bool tumble_ray_soft(const tumble_world *w, tumble_vec3 from, tumble_vec3 to,
                     unsigned mask, tumble_hit *hit);
bool tumble_nearest_soft(const tumble_world *w, tumble_vec3 x, double most,
                         unsigned mask, tumble_hit *hit);
int tumble_contacts(const tumble_world *w, tumble_contact *out, int most);
int tumble_events(tumble_world *w, tumble_event *out, int most);
bool tumble_listen(tumble_world *w, bool on);
int tumble_impulses(const tumble_world *w, tumble_impulse *out, int most);
bool tumble_choose_contacts(tumble_world *w,
                            bool (*meets)(void *context,
                                          const tumble_contact *c),
                            void *context);
bool tumble_set_sensor(tumble_world *w, tumble_body b, bool is_sensor);
bool tumble_is_sensor(const tumble_world *w, tumble_body b);
int tumble_sensed(const tumble_world *w, tumble_body sensor, tumble_body *out,
                  int most);
int tumble_sensor_events(tumble_world *w, tumble_event *out, int most);
void tumble_draw(const tumble_world *w, const tumble_pen *pen);
#ifdef __cplusplus
}
#endif

typedef void any_function(void);
#define OLD(name) (any_function *)name
static any_function *const old_name[] = {
    OLD(tumble_turn), OLD(tumble_matrix), OLD(tumble_from_matrix),
    OLD(tumble_rotate), OLD(tumble_to_world), OLD(tumble_to_local),
    OLD(tumble_make), OLD(tumble_free), OLD(tumble_failure),
    OLD(tumble_forget_failure), OLD(tumble_step), OLD(tumble_time),
    OLD(tumble_set_gravity), OLD(tumble_add_plane), OLD(tumble_remove_plane),
    OLD(tumble_last_step), OLD(tumble_measure), OLD(tumble_hash),
    OLD(tumble_save), OLD(tumble_load), OLD(tumble_run_on),
    OLD(tumble_get_world_options), OLD(tumble_restore), OLD(tumble_box),
    OLD(tumble_icosahedron), OLD(tumble_sphere), OLD(tumble_capsule),
    OLD(tumble_hull), OLD(tumble_obj), OLD(tumble_rope), OLD(tumble_cloth),
    OLD(tumble_drop_shape), OLD(tumble_weigh), OLD(tumble_round),
    OLD(tumble_at), OLD(tumble_add), OLD(tumble_add_pieces),
    OLD(tumble_add_compound), OLD(tumble_add_mesh), OLD(tumble_add_heights),
    OLD(tumble_remove), OLD(tumble_has), OLD(tumble_bodies),
    OLD(tumble_get_pose), OLD(tumble_position), OLD(tumble_velocity),
    OLD(tumble_spin), OLD(tumble_mass), OLD(tumble_user), OLD(tumble_set_pose),
    OLD(tumble_set_velocity), OLD(tumble_push), OLD(tumble_force),
    OLD(tumble_wake), OLD(tumble_sleep), OLD(tumble_is_awake),
    OLD(tumble_set_material), OLD(tumble_set_damping), OLD(tumble_set_filter),
    OLD(tumble_set_user), OLD(tumble_get_poses), OLD(tumble_get_velocities),
    OLD(tumble_moved), OLD(tumble_get_options), OLD(tumble_shape_of),
    OLD(tumble_force_at), OLD(tumble_set_kind), OLD(tumble_set_gravity_scale),
    OLD(tumble_gravity_scale), OLD(tumble_set_locked), OLD(tumble_locked),
    OLD(tumble_vertices), OLD(tumble_triangles), OLD(tumble_pin),
    OLD(tumble_unpin), OLD(tumble_vertex), OLD(tumble_push_vertex),
    OLD(tumble_set_bending), OLD(tumble_set_stretch), OLD(tumble_ground),
    OLD(tumble_ball), OLD(tumble_hinge), OLD(tumble_slider),
    OLD(tumble_set_limits), OLD(tumble_set_cone), OLD(tumble_set_motor),
    OLD(tumble_set_spring), OLD(tumble_set_servo), OLD(tumble_fix),
    OLD(tumble_distance), OLD(tumble_hang), OLD(tumble_set_strength),
    OLD(tumble_unjoin), OLD(tumble_is_joined), OLD(tumble_hinge_angle),
    OLD(tumble_set_touching), OLD(tumble_may_touch), OLD(tumble_joints),
    OLD(tumble_ray), OLD(tumble_nearest), OLD(tumble_overlap),
    OLD(tumble_sweep), OLD(tumble_sweep_turning), OLD(tumble_ray_all),
    OLD(tumble_ray_soft), OLD(tumble_nearest_soft), OLD(tumble_contacts),
    OLD(tumble_events), OLD(tumble_listen), OLD(tumble_impulses),
    OLD(tumble_choose_contacts), OLD(tumble_set_sensor), OLD(tumble_is_sensor),
    OLD(tumble_sensed), OLD(tumble_sensor_events), OLD(tumble_draw),
};

int main(void)
{
    tumble_world *w = tumble_make(NULL);
    tumble_add_plane(w, tumble_v(0, 1, 0), 0, -1);
    tumble_shape box = tumble_box(w, tumble_v(1, 1, 1), 2);
    tumble_body falling = tumble_add(w, box, tumble_at(0, 3, 0));
    tumble_body sign = tumble_add(w, box, tumble_at(4, 2, 0));
    tumble_hinge(w, tumble_ground(), sign, tumble_v(4, 2.5, 0),
                 tumble_v(0, 0, 1));
    tumble_push(w, falling, tumble_v(4, 0, 0), tumble_v(0, 3, 0));
    for (int step = 0; step < 300; step++) tumble_step(w);
    const char *why = tumble_failure(w);
    int there = 0;
    for (size_t k = 0; k < sizeof old_name / sizeof *old_name; k++)
        there += old_name[k] != NULL;
    printf("%d readme %016llx%s\n", there, tumble_hash(w), why ? why : "");
    tumble_free(w);
}
