//> tumble-head
// tumble.h - rigid bodies, ropes and cloths made of particles and sticks: what a
// program sees of the library.
//
// Book: chapter 19.  C11 and C++17.  Link with libtumble and with the mathematics of
// the C library.
// Units: metres, kilograms, seconds, radians, newtons, joules.  Frame: the
// world's, right-handed; gravity acts along -y unless the options say otherwise.
//
// A function that fails changes nothing.  It returns false, 0, NULL or an id of
// zeros, and tumble_world_failure says in a sentence what failed first, and why.
// An id of zeros, an id of something that is gone and a world that is NULL are all
// refused in this way, so a program may go on, and ask once at its end.
// Functions that take a `const` world only return something, and keep no sentence.
// One world is used by one thread at a time.
// Pointers must point to what the comment says.  One that is written to may be
// NULL; then nothing is written.

#ifndef TUMBLE_H
#define TUMBLE_H

#include <stdbool.h>
#include <stddef.h>

#define TUMBLE_VERSION "3.0.0"
#define TUMBLE_VERSION_NUMBER 30000     // 10000 major + 100 minor + patch

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif
//<

//> tumble-types
typedef struct tumble_world tumble_world;

// Ids.  An id is never used again: after a removal it stays refused.
typedef struct { unsigned place, generation; } tumble_shape;
typedef struct { unsigned place, generation; } tumble_body;
typedef struct { unsigned place, generation; } tumble_joint;
typedef struct { unsigned place, generation; } tumble_plane;

typedef struct { double x, y, z; } tumble_vec3;

// A unit quaternion, w + xi + yj + zk.  All zeros count as no rotation.
typedef struct { double x, y, z, w; } tumble_quat;

// Where a rigid body is: its centre of mass, and its rotation from the axes of its
// shape.  Of a rope or cloth: the mean of its vertices, and no rotation.
typedef struct {
    tumble_vec3 position;       // m
    tumble_quat rotation;
} tumble_pose;

static inline tumble_vec3 tumble_v(double x, double y, double z)
{
    tumble_vec3 v = { x, y, z };
    return v;
}

// The rotation by an angle (rad) about an axis of any length > 0.
tumble_quat tumble_quat_turn(tumble_vec3 axis, double angle);

// The matrix of a rotation, row by row; it acts on a column (x, y, z).
void tumble_quat_matrix(tumble_quat q, double m[9]);

// The rotation that has this matrix.  A rotation a and then b have the product of the
// matrices of b and a, in this order.
tumble_quat tumble_quat_from_matrix(const double m[9]);

// Rotates a vector by q: from the axes of the shape to those of the world.
tumble_vec3 tumble_quat_rotate(tumble_quat q, tumble_vec3 v);

// Takes a point from the frame of a body at this pose (m, from its centre of mass,
// along the axes of its shape) to the world, and back.
tumble_vec3 tumble_pose_to_world(tumble_pose at, tumble_vec3 local);
tumble_vec3 tumble_pose_to_local(tumble_pose at, tumble_vec3 point);

// TUMBLE_VERSION and TUMBLE_VERSION_NUMBER of the library that runs.  They may
// differ from those of this header.
const char *tumble_version(void);
int tumble_version_number(void);
//<

//> tumble-world
//>   A world has options, and each says when to turn it up. Most programs need
//>   none of them.
// --- The world ---------------------------------------------------------------
typedef struct {
    double dt;              // s, the length of a step; 1e-9 to 1, default 1/60
    int    substeps;        // the least number in a step, 1 to 10000.  The
                            // default, 0, means four (eight for rope, and for
                            // cloth with pins or beside moving bodies), or as
                            // many as keep each at 1/240 s or less.  High
                            // stacks, heavy loads, joints and cloth take more
                            // by themselves; what they do not touch does not
    int    most_substeps;   // a hard step takes up to so many, default 200.  A
                            // substep that has to be done again in shorter
                            // ones adds to them.  A step that would need more
                            // than 10000 in all is a failure
    tumble_vec3 gravity;    // m/s^2, default (0, -9.81, 0)
    double friction;        // coefficient of bodies and planes that have none of
                            // their own, default 0.5
    double restitution;     // likewise, 0 to 1: speed after an impact / speed
                            // before; default 0
    double sleep_speed;     // m/s, slower bodies fall asleep, default 0.005; 0:
                            // none does.  Turn it up if bodies stay awake too
                            // long.  It is the speed for a cube of 1 m under
                            // 9.81 m/s^2; for others it is scaled by the root
                            // of radius times gravity (Froude).  A body that
                            // rolls at less than 30 times this speed, and is
                            // not pulled along, is braked by 1/100 of its weight
    double time_to_sleep;   // s, it has to be so slow for so long, default 0.5
    bool   certified;       // true, the default: cloth never crosses cloth,
                            // whatever is demanded, nor a body, unless two
                            // bodies or pins demand it.  Where it would, it is
                            // stopped and stretches, and the report says so.
                            // That costs up to three tenths of a cloth's time,
                            // and several times as much where it acts.  false:
                            // for cloth that may cross

    // Must call work(data, 0) to work(data, items - 1), in any order or at once
    // on several threads, and return when all are done.  NULL, the default: they
    // run one after the other.  The bits of a step do not depend on it.
    void (*run)(void *context, void (*work)(void *data, int item), void *data,
                int items);
    void *context;
} tumble_options;

tumble_options tumble_options_default(void);

// Makes a world without bodies.  options may be NULL: the defaults.  Fails (NULL)
// if an option is out of range or memory is refused; tumble_world_failure(NULL)
// says which.
tumble_world *tumble_world_make(const tumble_options *options);

// Frees a world with everything in it.  NULL is fine.
void tumble_world_free(tumble_world *w);

// The sentence of the first failure since tumble_world_forget_failure was last
// called, without a full stop; NULL if there was none.  The text stays where it
// is until the next call of that function.  w = NULL: of making or loading a
// world, or of using a world that is NULL, in this thread.
const char *tumble_world_failure(const tumble_world *w);
void tumble_world_forget_failure(tumble_world *w);

// Moves the world on by options.dt.  Forces that were set act in this step, and
// are gone after it.
void tumble_world_step(tumble_world *w);

// s, the sum of all steps so far.  It is rounded: 60 steps of 1/60 s may be a
// little less than 1 s.
double tumble_world_time(const tumble_world *w);

// What the last step did, and what it could not do.
typedef struct {
    int substeps;           // of the part of the world that took most
    int bodies, asleep;     // how many there are, and how many of them sleep
    int pairs, contacts;    // of rigid bodies: pairs that may meet; contacts
                            // that touch, or will soon
    int unconverged;        // how many things are not as they should be: contacts
                            // that overlap by a tenth of the smaller radius;
                            // joints apart by a hundredth of it, or with axes
                            // off by a hundredth of a radian; ropes and cloths
                            // stretched by a hundredth, cut by a body, or not
                            // yet free of what they began in; and bodies that
                            // were stopped because their numbers were lost,
                            // which is a failure with a sentence, too
    int prevented;          // pairs of triangles, of cloth or of cloth and body,
                            // that were kept from crossing against what was
                            // demanded (options.certified),
    int crossed;            // and pairs that still cross, as they did before
    int dropped;            // contacts that found no memory
    int broken;             // joints that broke
} tumble_report;

tumble_report tumble_world_last_step(const tumble_world *w);

// How far is the world from what it should be?  Measured from the positions alone;
// this is slow.
typedef struct {
    double penetration;     // m, the deepest overlap of two bodies that may meet
    double strain;          // the largest |length - rest| / rest of a stick
    double kinetic, potential;          // J, half a substep ago, as momentum is;
                                        // potential is 0 at the origin
    tumble_vec3 momentum, angular;      // kg m/s; kg m^2/s, about the origin
} tumble_measures;

tumble_measures tumble_world_measure(const tumble_world *w);

// FNV-1a of all positions: equal bits give an equal hash.
unsigned long long tumble_world_hash(const tumble_world *w);

// Writes the whole state of w to `room` bytes at `into`, and returns how many bytes
// it takes.  If that is more than `room`, do not use them; room = 0 just asks.
// w does not change.
size_t tumble_world_save(const tumble_world *w, void *into, size_t room);

// Makes a world from such bytes.  Its steps have the same bits as the next steps of
// the saved world, and ids of that world are good for it.  User pointers are the
// addresses that they were.  It runs on one thread until tumble_world_run_on.
// Fails (NULL) if bytes were cut or altered, or were written by another version or
// another kind of machine; tumble_world_failure(NULL) says why.  A checksum finds
// accidents only: do not load bytes that someone may have forged.
tumble_world *tumble_world_load(const void *from, size_t size);

// Puts such bytes in the place of a world that is there: w becomes the saved world,
// but keeps its threads and its choice of contacts.  Ids that the saved world
// gave are good, and those that w gave since are gone.  It costs as much time as a
// load.  The memory of the world before is kept for the next restore, which then
// seldom asks for more.  Fails as a load does, and then w is as it was.
bool tumble_world_restore(tumble_world *w, const void *from, size_t size);

// From now on steps run their work as options.run and options.context say.
void tumble_world_run_on(tumble_world *w,
                         void (*run)(void *context,
                                     void (*work)(void *data, int item),
                                     void *data, int items),
                         void *context);

// All bodies: writes the first `most` of them, and returns how many there are.
int tumble_world_bodies(const tumble_world *w, tumble_body *out, int most);

// All joints: writes the first `most` of them, and returns how many there are.
int tumble_world_joints(const tumble_world *w, tumble_joint *out, int most);

// The bodies that the last step may have moved, however little: writes the first
// `most` of them, and returns how many there are.  Every other body stands where it
// stood before that step, to the bit, unless the program has put it elsewhere.  A
// world that was loaded has none until its first step.
int tumble_world_moved(const tumble_world *w, tumble_body *out, int most);

bool tumble_world_set_gravity(tumble_world *w, tumble_vec3 gravity);

// The options of a world as they are now: substeps as they were chosen, and gravity
// as it was last set.  For NULL: the defaults.
tumble_options tumble_world_get_options(const tumble_world *w);

// --- Planes ------------------------------------------------------------------
// Bodies stay where normal . x >= offset.  The normal may have any length > 0;
// offset is in metres times that length.  friction < 0: the world's.  All bodies
// wake when a plane comes or goes.
tumble_plane tumble_plane_add(tumble_world *w, tumble_vec3 normal,
                              double offset, double friction);
bool tumble_plane_remove(tumble_world *w, tumble_plane p);
//<

//> tumble-shapes
//>   Shapes are made once, from sizes in metres or from a file, and serve any
//>   number of bodies.
// --- Shapes ------------------------------------------------------------------
// A shape belongs to its world, and any number of bodies may be made of it.  Its
// mass (kg) is that of one body, evenly filled, and its origin is the centre of mass.
tumble_shape tumble_shape_box(tumble_world *w, tumble_vec3 sides, double mass);
tumble_shape tumble_shape_icosahedron(tumble_world *w, double radius,
                                      double mass);
tumble_shape tumble_shape_sphere(tumble_world *w, double radius, double mass);

// All points within the radius of a segment of this length along y.
tumble_shape tumble_shape_capsule(tumble_world *w, double length, double radius,
                                  double mass);

// A cylinder of this length along y.  It rolls on its side, and on the rim of an end.
// Rays and nearest points find it perfectly round.  Rope, cloth, sweeps and overlaps
// meet a prism of 32 sides instead, whose corners lie on the rims.
// Fails if the radius is less than a ten-thousandth of the length, or the length
// less than a ten-thousandth of the radius.
tumble_shape tumble_shape_cylinder(tumble_world *w, double length,
                                   double radius, double mass);

// A cone along y with its tip at +y: a pyramid of 32 sides with corners on the rim,
// but with the mass, the centre and the inertia of the round cone.  Its origin is a
// quarter of the height above its base.
tumble_shape tumble_shape_cone(tumble_world *w, double height, double radius,
                               double mass);

// The convex hull of n points.  Fails if there are fewer than four, if they lie in
// a plane, or if one is not finite.
tumble_shape tumble_shape_hull(tumble_world *w, const tumble_vec3 *point, int n,
                               double mass);

// A convex body from a Wavefront OBJ file, scaled so that its furthest vertex is
// at the radius.  Fails with the file's name, the line, and what is wrong there.
tumble_shape tumble_shape_obj(tumble_world *w, const char *path, double radius,
                              double mass);

// A rope of n links along x, with n + 1 vertices; vertex 0 is at -x.  Other ropes
// and cloths meet a ball at each vertex, as wide as 1.1 links.
tumble_shape tumble_shape_rope(tumble_world *w, int n, double length,
                               double mass);

// A cloth of columns x rows vertices in the plane y = 0: width along x, depth
// along z.  Vertex (i, j) has the number j columns + i.  It comes to rest three
// quarters of a cell above what bears it, so a finer cloth is a thinner one.
tumble_shape tumble_shape_cloth(tumble_world *w, int columns, int rows,
                                double width, double depth, double mass);

// A rigid shape like s with another mass (kg), another centre of mass (m, in the
// frame of s, and inside of it) and other moments of inertia about that centre
// (kg m^2): the tensor along the axes of s, in the order xx, yy, zz, xy, xz, yz.
// The last three are -(sum of m x y), and so on.
// Fails if no body can have that tensor: it must be positive definite, and each
// principal moment less than the sum of the two others.
tumble_shape tumble_shape_weighed(tumble_world *w, tumble_shape s, double mass,
                                  tumble_vec3 center, const double inertia[6]);

// A rigid shape with faces, such as a box or a hull, made larger by the radius (m)
// on every side, with round edges and corners.  It has the mass of s, evenly
// filled, and its origin is its own centre of mass.
tumble_shape tumble_shape_rounded(tumble_world *w, tumble_shape s,
                                  double radius);

// Fails while a body is made of it.
bool tumble_shape_remove(tumble_world *w, tumble_shape s);
//<

//> tumble-bodies
// --- Bodies ------------------------------------------------------------------
typedef enum {
    TUMBLE_DYNAMIC,         // moved by forces and contacts
    TUMBLE_STATIC,          // never moves
    TUMBLE_KINEMATIC        // rigid; keeps the velocity that it is given,
                            // and pushes what it meets
} tumble_kind;

typedef struct {
    tumble_kind kind;
    tumble_pose pose;
    tumble_vec3 velocity;   // m/s, of the centre of mass
    tumble_vec3 spin;       // rad/s, about it
    double friction;        // < 0: the world's.  Between two bodies it is the
                            // root of the product of theirs
    double restitution;     // < 0: the world's.  Between two bodies it is the
                            // larger of theirs
    double damping;         // 1/s, the share of its velocity that it loses
    double spin_damping;    // 1/s, likewise of its spin
    unsigned group, mask;   // bits: two bodies meet if the mask of each has a
                            // bit of the other's group.  A group of 0 is
                            // refused, and so options that are all zeros are
    void *user;             // the program's own
} tumble_body_options;

// Dynamic and at rest, with its centre of mass there; it meets everything.
tumble_body_options tumble_body_at(double x, double y, double z);

// Adds a body, at any time between steps.
tumble_body tumble_body_add(tumble_world *w, tumble_shape s,
                            tumble_body_options o);

// Adds one static body of n rigid pieces, each with its own pose in the world.
// o.kind and o.pose are not used.
tumble_body tumble_body_add_pieces(tumble_world *w, const tumble_shape *piece,
                                   const tumble_pose *pose, int n,
                                   tumble_body_options o);

// Adds one dynamic body of n rigid pieces that move as one, each with its own
// pose in the frame of the body; o.pose says where that frame is.  Mass, centre
// of mass and inertia are those of all pieces together, so where two pieces
// overlap, mass counts twice.  The body keeps copies of the shapes.
tumble_body tumble_body_add_compound(tumble_world *w, const tumble_shape *piece,
                                     const tumble_pose *pose, int n,
                                     tumble_body_options o);

// Adds one static body of triangles, of three numbers of points each,
// counter-clockwise as seen from outside.  Behind them it is solid to a depth of
// `thickness` (m; 0: the mean length of a side), but no deeper than halfway to the
// next triangle behind, so no centre of mass gets in from either side.
// Points are in the frame of the pose, and are copied; o.kind is not used.
// Triangles lower than a millionth of their longest side are left out.
// A step costs only what lies near moving bodies.  A body that lies on more than
// 2,000 triangles at once has too much friction.
// Fails if a number is not finite or names no point, or if no triangle is left.
tumble_body tumble_body_add_mesh(tumble_world *w, const tumble_vec3 *point,
                                 int points, const int *triangle, int triangles,
                                 double thickness, tumble_body_options o);

// Adds a terrain of columns x rows points, 2 to 8192 each, centred at the pose:
// width along x, depth along z (m).  Point (i, j) has the number j columns + i, and
// its height (m) is along y.  Below it is solid to a depth of `thickness` (m; 0: two
// of the longer sides of a cell).  A body that begins in it by less than half of
// that is pushed out upwards.
tumble_body tumble_body_add_heights(tumble_world *w, const double *height,
                                    int columns, int rows, double width,
                                    double depth, double thickness,
                                    tumble_body_options o);

// The id of the world itself: a joint with it is a joint to the world, and answers
// give it for planes.
tumble_body tumble_body_ground(void);

// Do the two ids stand for the same body?
static inline bool tumble_body_is_same(tumble_body a, tumble_body b)
{
    return a.place == b.place && a.generation == b.generation;
}

// Removes a body with its joints; what lay on it wakes.
bool tumble_body_remove(tumble_world *w, tumble_body b);

// Is it in the world?
bool tumble_body_exists(const tumble_world *w, tumble_body b);

// Where it is, how it moves, what it weighs.  For a body that is not there, all
// numbers are 0.
tumble_pose tumble_body_pose(const tumble_world *w, tumble_body b);
tumble_vec3 tumble_body_position(const tumble_world *w, tumble_body b);
tumble_vec3 tumble_body_velocity(const tumble_world *w, tumble_body b);
tumble_vec3 tumble_body_spin(const tumble_world *w, tumble_body b);
double tumble_body_mass(const tumble_world *w, tumble_body b);  // static: 0
void  *tumble_body_user(const tumble_world *w, tumble_body b);

// Puts a rigid body somewhere else, at once; it keeps its velocity.  A kinematic
// body that has a velocity and is put back before every step is a conveyor belt: it
// carries along what lies on it.
bool tumble_body_set_pose(tumble_world *w, tumble_body b, tumble_pose pose);

// Gives a rigid body a velocity and a spin.  A kinematic body keeps them.
bool tumble_body_set_velocity(tumble_world *w, tumble_body b,
                              tumble_vec3 velocity, tumble_vec3 spin);

// Gives it an impulse (N s) at a point of the world, now.  Fails for static and
// kinematic bodies.
bool tumble_body_push(tumble_world *w, tumble_body b, tumble_vec3 impulse,
                      tumble_vec3 at);

// Sets a force (N) at the centre of mass and a torque (N m) for the next step; calls
// before that step add up.  The force is constant during the step.  So a force that
// depends on where the body is adds energy: a planet that is pulled to a sun is 1.5
// times as far away after ten rounds of 377 steps.  To keep the energy, push by
// force times dt before each step instead.
bool tumble_body_force(tumble_world *w, tumble_body b, tumble_vec3 force,
                       tumble_vec3 torque);

// Sets a force (N) at a point of the world for the next step; it adds up with
// tumble_body_force.
bool tumble_body_force_at(tumble_world *w, tumble_body b, tumble_vec3 force,
                          tumble_vec3 at);

// Wakes a body, or puts it to sleep.  A sleeping body wakes by itself when it is
// pushed or met.
bool tumble_body_wake(tumble_world *w, tumble_body b);
bool tumble_body_sleep(tumble_world *w, tumble_body b);
bool tumble_body_is_awake(const tumble_world *w, tumble_body b);

bool tumble_body_set_material(tumble_world *w, tumble_body b, double friction,
                              double restitution);
bool tumble_body_set_damping(tumble_world *w, tumble_body b, double damping,
                             double spin_damping);
bool tumble_body_set_filter(tumble_world *w, tumble_body b, unsigned group,
                            unsigned mask);
bool tumble_body_set_user(tumble_world *w, tumble_body b, void *user);

// Many bodies at once: what tumble_body_pose, or tumble_body_velocity and
// tumble_body_spin, say of b[0] to b[n - 1], in that order.
void tumble_body_poses(const tumble_world *w, const tumble_body *b, int n,
                       tumble_pose *out);
void tumble_body_velocities(const tumble_world *w, const tumble_body *b, int n,
                            tumble_vec3 *velocity, tumble_vec3 *spin);

// All that was set of a body, as it is now: with these options tumble_body_add makes
// another one like it in the same place.  For a body that is not there: zeros, which
// tumble_body_add refuses.
tumble_body_options tumble_body_get_options(const tumble_world *w,
                                            tumble_body b);

// The shape that it was made of: the first one of several; of a mesh or terrain,
// zeros.
tumble_shape tumble_body_shape(const tumble_world *w, tumble_body b);

// Gives a rigid body of one piece another kind; it stays where it is.  What becomes
// dynamic keeps its velocity.  What becomes kinematic stands still until it is given
// one.  Its axes are no longer locked.  What lay on it, or is joined to it, wakes.
bool tumble_body_set_kind(tumble_world *w, tumble_body b, tumble_kind kind);

// How many times the world's gravity acts on a rigid body of one piece, -1000 to
// 1000; 1 at first; 0: none; below 0 it rises.  Setting it wakes the body, which
// keeps its velocity.
bool tumble_body_set_gravity_scale(tumble_world *w, tumble_body b,
                                   double scale);
double tumble_body_gravity_scale(const tumble_world *w, tumble_body b);

// Axes of the world along which a dynamic body does not move, and about which it does
// not turn, from where it stands now; 0: none is locked.  They hold as a joint to
// the ground does, against any push.  After tumble_body_set_pose they hold the new
// pose.  If one turn alone is locked, its speed is kept at 0; if two or three are,
// the angles are kept.
enum {
    TUMBLE_LOCK_X = 1, TUMBLE_LOCK_Y = 2, TUMBLE_LOCK_Z = 4,
    TUMBLE_LOCK_TURN_X = 8, TUMBLE_LOCK_TURN_Y = 16, TUMBLE_LOCK_TURN_Z = 32,
    TUMBLE_LOCK_TURNS = 56,     // it stays upright
    TUMBLE_LOCK_FLAT = 28       // it stays in a plane z = constant, as in a game in
                                // two dimensions
};
bool tumble_body_set_locked(tumble_world *w, tumble_body b, unsigned axes);
unsigned tumble_body_locked(const tumble_world *w, tumble_body b);

// --- Sensors -----------------------------------------------------------------
// A sensor is a rigid body, of one piece or several, that pushes nothing, and that no
// ray, sweep or other question meets.  A dynamic sensor has its weight, and falls
// through everything, planes as well, unless a joint holds it.
// It finds dynamic and kinematic bodies, ropes and cloths, if groups and masks would
// let the two meet, but no other sensor, no mesh and no terrain.  It costs nothing
// until it is asked.
bool tumble_body_set_sensor(tumble_world *w, tumble_body b, bool is_sensor);
bool tumble_body_is_sensor(const tumble_world *w, tumble_body b);

// What overlaps a sensor now: writes the first `most` bodies, and returns how many
// there are.  A rope or cloth is in it when one of its vertices is, as a ball.  The
// function looks at all bodies.  0 if the body is no sensor.
int tumble_body_sensed(const tumble_world *w, tumble_body sensor,
                       tumble_body *out, int most);
//<

//> tumble-vertices
//>   What is drawn is asked for as vertices and triangles. Rope and cloth have
//>   particles that can be pinned, pushed and measured one by one.
// --- Vertices ----------------------------------------------------------------
// The vertices of a body, in the world: writes the first `most` of them, and
// returns how many there are.
int tumble_body_vertices(const tumble_world *w, tumble_body b, tumble_vec3 *out,
                         int most);

// Its triangles: three numbers of vertices each, counter-clockwise as seen from
// outside (of a cloth: from above).  They stay where they are as long as the shape
// exists.
const int *tumble_body_triangles(const tumble_world *w, tumble_body b,
                                 int *count);

// --- Rope and cloth ----------------------------------------------------------
// Vertex i stays where it is now, until it is unpinned.
bool tumble_body_pin(tumble_world *w, tumble_body b, int i);
bool tumble_body_unpin(tumble_world *w, tumble_body b, int i);
tumble_vec3 tumble_body_vertex(const tumble_world *w, tumble_body b, int i);

// Gives vertex i an impulse (N s).
bool tumble_body_push_vertex(tumble_world *w, tumble_body b, int i,
                             tumble_vec3 impulse);

// The velocity of vertex i (m/s).  A pinned vertex cannot be given one.  The mean of
// all vertices is tumble_body_velocity.
tumble_vec3 tumble_body_vertex_velocity(const tumble_world *w, tumble_body b,
                                        int i);
bool tumble_body_set_vertex_velocity(tumble_world *w, tumble_body b, int i,
                                     tumble_vec3 velocity);

// Stiffness against bending: of a rope in N m^2, of a cloth in N m; 0: none.
bool tumble_body_set_bending(tumble_world *w, tumble_body b, double stiffness);

// How much threads give.  Of a rope: by how many metres one newton stretches one
// metre of it (1/N).  Of a cloth: the same for each metre of its width (m/N); denim
// has 1e-4.  0: not at all, but for 4e-6 of its length by which a pinned cloth gives
// under its own weight.
bool tumble_body_set_stretch(tumble_world *w, tumble_body b, double compliance);
//<

//> tumble-joints
//>   Joints are made where the bodies stand (chapter 17). Each kind has a
//>   function of its own, because each needs other arguments.
// --- Joints ------------------------------------------------------------------
// A joint is between two rigid bodies, or between a body and the world, whose id is
// tumble_body_ground().  Joined bodies do not collide with each other, unless
// tumble_joint_set_touching says so, and a rope or cloth does not collide with a
// body that it hangs on.  Bodies that are joined through a third one do collide,
// unless their groups forbid it.
// Points and axes are given in the world, as the bodies stand when the joint is made.
//
// Ball joint: a point of a and a point of b stay together.
tumble_joint tumble_joint_ball(tumble_world *w, tumble_body a, tumble_body b,
                               tumble_vec3 at);

// Hinge: they also keep an axis in common, about which b turns as seen from a.
tumble_joint tumble_joint_hinge(tumble_world *w, tumble_body a, tumble_body b,
                                tumble_vec3 at, tumble_vec3 axis);

// Slider: b moves along an axis of a, without turning against a.
tumble_joint tumble_joint_slider(tumble_world *w, tumble_body a, tumble_body b,
                                 tumble_vec3 at, tumble_vec3 axis);

// Fixed: both move as one.
tumble_joint tumble_joint_fixed(tumble_world *w, tumble_body a, tumble_body b,
                                tumble_vec3 at);

// Distance: two points are at least and at most so far apart (m).
tumble_joint tumble_joint_distance(tumble_world *w, tumble_body a,
                                   tumble_vec3 at_a, tumble_body b,
                                   tumble_vec3 at_b, double least, double most);

// Hang: vertex i of a rope or cloth stays where it is now, as seen from a rigid body.
tumble_joint tumble_joint_hang(tumble_world *w, tumble_body soft, int i,
                               tumble_body b);

bool tumble_joint_remove(tumble_world *w, tumble_joint j);
bool tumble_joint_exists(const tumble_world *w, tumble_joint j);

// The bodies that it joins: side 0 is a, side 1 is b.  Zeros if the joint is gone.
tumble_body tumble_joint_body(const tumble_world *w, tumble_joint j, int side);

// Limits.  Of a hinge: how far b may turn about the axis as seen from a (rad; there
// is no limit beyond -pi and pi).  Of a slider: how far b may move along it (m).
// Both are 0 as the bodies stood when they were joined.  Of a distance: how far
// apart its points may be (m; there is no limit below 0).
// -HUGE_VAL and HUGE_VAL take limits off.  Equal limits hold it there, and if they are
// moved a little before every step they drive it.
bool tumble_joint_set_limits(tumble_world *w, tumble_joint j, double least,
                             double most);

// Cone and twist of a ball joint.  The axis is one that a and b have in common as they
// stand now.  It leans by `swing` (rad) at most, and b turns about it from least to
// most (rad).  Beyond pi there is no limit.  Near a lean of pi a turn is not defined,
// so choose a narrower cone.  A second call measures from how they stand then.
bool tumble_joint_set_cone(tumble_world *w, tumble_joint j, tumble_vec3 axis,
                           double swing, double least, double most);

// The torque (N m) with which a ball joint resists turning about any axis, at most; 0:
// none.  It works with a cone or alone, and setting it wakes both bodies.  For a hinge
// or slider, use a motor of speed 0.
bool tumble_joint_set_friction(tumble_world *w, tumble_joint j, double torque);

// A hinge (rad, N m), a slider and a distance (m, N) leave one motion free.  Along it
// there may be a motor and a spring, which act together and within the limits; of a
// distance, only if its limits differ.  Setting one wakes both bodies.
//
// A motor keeps b at `speed` as seen from a (rad/s, right-handed about the axis; m/s
// along it, or apart) with at most `force` (N m or N, 0 or more).  With a speed of 0 it
// is friction, or a brake.  A force of 0 takes the motor off, and HUGE_VAL gives all
// that it needs.
bool tumble_joint_set_motor(tumble_world *w, tumble_joint j, double speed,
                            double force);

// A spring pulls to `rest` (rad or m) with `stiffness` (N m/rad or N/m), and brakes
// with `damping` (N m s/rad or N s/m).  Any stiffness is safe at any dt.  The spring of
// a hinge pulls the shorter way round, whatever the limits are.  Both 0: it is taken
// off.
bool tumble_joint_set_spring(tumble_world *w, tumble_joint j, double rest,
                             double stiffness, double damping);

// A servo is a spring to `place` (rad or m) that gives at most `force` (N m or N).  Its
// stiffness is such that the two bodies alone, as they stand now, would swing at
// `hertz` (1/s) with the damping ratio `ratio` (0: undamped; 1: critical).  It replaces
// a spring.  A force of 0 takes it off, and HUGE_VAL sets no bound.
bool tumble_joint_set_servo(tumble_world *w, tumble_joint j, double place,
                            double hertz, double ratio, double force);

// A joint that has to bear more than this force (N) breaks, and is gone; 0: it never
// does.  Ropes and cloths do not tear, but the joints that they hang by may break.
bool tumble_joint_set_strength(tumble_world *w, tumble_joint j, double force);

// May the two bodies of a joint collide with each other, as if they were not joined?
// Not at first.  If two bodies have several joints, all must allow it.  Allow it only
// where the bodies do not overlap.
bool tumble_joint_set_touching(tumble_world *w, tumble_joint j, bool may_touch);
bool tumble_joint_may_touch(const tumble_world *w, tumble_joint j);

// Along its free motion: where b is as seen from a (of a hinge: rad, -pi to pi; of a
// slider: m; of a distance: m between the points), and how fast it moves (rad/s, m/s).
double tumble_joint_place(const tumble_world *w, tumble_joint j);
double tumble_joint_speed(const tumble_world *w, tumble_joint j);
// rad, how far the axis of a cone leans, and how far b has turned about it; 0 without
// a cone.
double tumble_joint_swing(const tumble_world *w, tumble_joint j);
double tumble_joint_twist(const tumble_world *w, tumble_joint j);
// What motor, spring and limits together gave in the last substep (N m or N), positive
// where the place grows: a winch that pulls in gives less than 0.  0 without motor and
// spring.
double tumble_joint_drive(const tumble_world *w, tumble_joint j);
// m, the gap between the two points that it keeps together.  (Axes that are off show
// in a step's `unconverged` alone.)
double tumble_joint_gap(const tumble_world *w, tumble_joint j);
// N, the force that it bore in the last substep.
double tumble_joint_force(const tumble_world *w, tumble_joint j);
// N m, the torque that it bore then about its point; of a hinge with motor, spring and
// limits; 0 for a ball without a cone, a distance and a hang.
double tumble_joint_torque(const tumble_world *w, tumble_joint j);
// rad, tumble_joint_place of a hinge under another name.
double tumble_joint_angle(const tumble_world *w, tumble_joint j);
//<

//> tumble-ask
//>   A program asks what is where in four ways, and one query answers all of
//>   them: the distance of chapter 04. A ray is a point that moves (chapter 15,
//>   *Rays*). A point or a shape that stands still needs only its distance from
//>   each body.
// --- What is where -----------------------------------------------------------
// These functions ask bodies whose group has a bit in `mask` (~0u: all), and all
// planes, for which they give tumble_body_ground().  They do not ask rope and cloth.
typedef struct {
    tumble_body body;
    tumble_vec3 point;      // m, on its surface
    tumble_vec3 normal;     // unit, out of the surface
    double fraction;        // of the displacement, 0 to 1; of a nearest point its
                            // distance (m)
    int vertex;             // of rope and cloth, the nearest one; else 0
} tumble_hit;

// What does the segment from one point to another meet first?  False: nothing.  One
// that begins in a body meets that at once.
bool tumble_world_ray(const tumble_world *w, tumble_vec3 from, tumble_vec3 to,
                      unsigned mask, tumble_hit *hit);

// The point of a body or plane nearest to x, no further away than `most` (m).  If x is
// inside of a body, it is x itself.
bool tumble_world_nearest(const tumble_world *w, tumble_vec3 x, double most,
                          unsigned mask, tumble_hit *hit);

// The bodies that a rigid shape would overlap at this pose: writes the first `most` of
// them, and returns how many there are.
int tumble_world_overlap(const tumble_world *w, tumble_shape s,
                         tumble_pose pose, unsigned mask, tumble_body *out,
                         int most);

// What does a rigid shape meet first that moves by `displacement` (m) without turning?
// What it touches or overlaps at the start is met at once, even if the displacement
// leads out of it, with a normal against the displacement.  So a shape that slides
// along walls should keep a little distance from them.
bool tumble_world_sweep(const tumble_world *w, tumble_shape s, tumble_pose pose,
                        tumble_vec3 displacement, unsigned mask,
                        tumble_hit *hit);

// The same for a shape that also turns steadily, by the angle |turn| (rad) about the
// axis `turn` through its centre of mass.  The answer is exact to a millionth of the
// displacement and the sizes, and never too late.
bool tumble_world_sweep_turning(const tumble_world *w, tumble_shape s,
                                tumble_pose pose, tumble_vec3 displacement,
                                tumble_vec3 turn, unsigned mask,
                                tumble_hit *hit);

// All bodies and planes that the segment from one point to another meets, each once,
// where it is met first, and the nearest first: writes the first `most` of them, and
// returns how many there are.
int tumble_world_ray_all(const tumble_world *w, tumble_vec3 from,
                         tumble_vec3 to, unsigned mask, tumble_hit *out,
                         int most);

// The same questions to rope and cloth alone: what does the segment meet first, and
// which point is nearest to x, no further away than `most` (m)?  A cloth is its
// triangles, and a rope is as thick as it is to other bodies.
bool tumble_world_ray_soft(const tumble_world *w, tumble_vec3 from,
                           tumble_vec3 to, unsigned mask, tumble_hit *hit);
bool tumble_world_nearest_soft(const tumble_world *w, tumble_vec3 x,
                               double most, unsigned mask, tumble_hit *hit);
//<

//> tumble-walk
//>   A character is no body: it is a capsule that asks what is in its way, and goes
//>   where it can.
// --- Characters --------------------------------------------------------------
// A capsule that stays upright and walks.  It keeps a hundred-thousandth of its
// radius away from everything in its way, and pushes nothing.
typedef struct {
    double length, radius;  // m, as of tumble_shape_capsule
    tumble_vec3 up;         // of any length > 0
    double step;            // m, the highest step that it climbs or goes down, 0 or
                            // more; it stands on no edge that is higher above its
                            // lowest point
    double slope;           // rad, the steepest ground that it stands on, 0 to less
                            // than pi / 2
    unsigned mask;          // groups that are in its way.  A body that stands in for
                            // it in the world must be in none of them
} tumble_walker;

// Upright along y; it climbs steps as high as its radius and slopes of pi / 4, and
// everything is in its way.
tumble_walker tumble_walker_capsule(double length, double radius);

// Where a character is.  At first all but the position may be zeros.
typedef struct {
    tumble_vec3 position;   // m, of its middle
    tumble_body ground;     // what it stands on; of planes tumble_body_ground()
    tumble_vec3 point;      // m, the point of the ground next to it, in the world,
    tumble_vec3 foot;       // and in the frame of the ground's pose
    tumble_vec3 normal;     // unit, out of the ground; on an edge it leans
    tumble_vec3 velocity;   // m/s, of the ground at that point
    bool stands;            // false in the air; a program sets it to false to jump
} tumble_walk;

// Moves a character from `from` by `displacement` (m) as far as it can, and writes
// where it is then to `to`.
// First it is pushed out of what has come into it.  If it stands, it is carried along
// by its ground, and moves by the horizontal part of the displacement, up and down
// steps; the vertical part counts only where the ground is too far below or too steep.
// In the air all of the displacement counts, and where it leads down to ground that is
// not too steep, it stands.  Walls stop the part that leads into them, and let it slide
// along.  The program adds gravity itself: the displacement is its velocity times dt,
// and how far it came, over dt, is the velocity to go on with.
// False, and `to` is as it was, if a number is not finite or not one of a character.
bool tumble_world_walk(const tumble_world *w, tumble_walker how,
                       tumble_walk from, tumble_vec3 displacement,
                       tumble_walk *to);
//<

//> tumble-contacts
//>   A game wants to know what touches, and above all what has *begun* to
//>   touch.
// --- Who touches whom --------------------------------------------------------
enum { TUMBLE_POINTS = 4 };

// Two rigid bodies that push each other.  b is tumble_body_ground() for a plane.
typedef struct {
    tumble_body a, b;
    tumble_vec3 normal;             // unit, from b to a
    int points;                     // 1 to TUMBLE_POINTS
    tumble_vec3 point[TUMBLE_POINTS];   // m
    double force[TUMBLE_POINTS];    // N, along the normal, in the last substep.
                                    // What a sudden change gives at once, such as
                                    // a new velocity of a lift, is not in it: see
                                    // tumble_world_impulses
} tumble_contact;

// The contacts that pushed in the last substep of the last step: writes the first
// `most` of them, and returns how many there are.  A body that ran into a wall earlier
// in the step may be missing; tumble_world_impulses has it.
int tumble_world_contacts(const tumble_world *w, tumble_contact *out, int most);

// A pair that has begun to touch, or has ended.
typedef struct {
    tumble_body a, b;
    bool begins;
    tumble_vec3 point;      // m, where the pair pushed most,
    tumble_vec3 normal;     // unit, from b to a, and
    double force;           // N, the sum over all points: now if it begins, else
                            // when events were last asked for.  How hard an
                            // impact was: see tumble_world_impulses.  Of sensors
                            // all three are zeros
} tumble_event;

// Which pairs began or ended to touch since this function was last called?  It compares
// the contacts of now and then.  A ball that came, bounced and left in between is in
// neither list, but tumble_world_impulses has it.
// Writes the first `most` of them, and returns how many there are; those that found no
// room are lost.
int tumble_world_events(tumble_world *w, tumble_event *out, int most);

// What one rigid body gave another in the whole of the last step, with impacts, even
// if a bounce began and ended in it.
typedef struct {
    tumble_body a, b;       // b is tumble_body_ground() for a plane
    tumble_vec3 point;      // m, the mean of all points that pushed, weighted by
                            // their impulses, where each first pushed in the step
    tumble_vec3 normal;     // unit, from b to a, likewise
    double impulse;         // N s, along the normals
} tumble_impulse;

// From now on steps write impulses down, or no longer.  No bit of a step depends on it.
// A world that was loaded does as the saved one did.
bool tumble_world_listen(tumble_world *w, bool on);

// The impulses of the last step, sorted by bodies: writes the first `most` of them, and
// returns how many there are; 0 if they were not written down, or nothing moved.
int tumble_world_impulses(const tumble_world *w, tumble_impulse *out, int most);

// From now on a step calls `meets` for each contact that it begins with, always in the
// same order, and the two bodies push each other in this step only if that returns
// true.  The contact has ids, normal and points, but no forces yet.  `meets` may ask
// the world, but not change it.  For bodies that move by their own size in a step it
// may be called several times.  NULL: all contacts count, as in a world that was
// loaded.
bool tumble_world_choose_contacts(tumble_world *w,
                                  bool (*meets)(void *context,
                                                const tumble_contact *c),
                                  void *context);

// Which bodies came into a sensor, or left it, since this function was last called?  a
// is the sensor.  A body that was removed has left it.  Writes the first `most` of
// them, and returns how many there are; those that found no room are lost.
int tumble_world_sensor_events(tumble_world *w, tumble_event *out, int most);
//<

//> tumble-draw
//>   The last part is for the moment when something goes wrong: lines for all
//>   that the engine knows, to be drawn over the picture.
// --- Drawing -----------------------------------------------------------------
// The functions that a program's window draws with; each may be NULL.
typedef struct {
    void (*triangle)(void *context, tumble_body b, const tumble_vec3 at[3]);
    void (*line)(void *context, tumble_body b, const tumble_vec3 at[2]);
    void (*point)(void *context, tumble_body b, tumble_vec3 at);
    void *context;
} tumble_pen;

// Draws bodies as triangles, ropes and joints as lines, contacts as points.
void tumble_world_draw(const tumble_world *w, const tumble_pen *pen);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
//<

//> tumble-old-names
//>   A program that was written for version 2 goes on with the names that it has,
//>   for one version.
// --- The names of version 2 --------------------------------------------------
// They go with version 4.  A program that wants none of them, or wants them for
// itself, defines TUMBLE_NO_OLD_NAMES before it includes this.
#ifndef TUMBLE_NO_OLD_NAMES
#define tumble_turn tumble_quat_turn
#define tumble_matrix tumble_quat_matrix
#define tumble_from_matrix tumble_quat_from_matrix
#define tumble_rotate tumble_quat_rotate
#define tumble_to_world tumble_pose_to_world
#define tumble_to_local tumble_pose_to_local
#define tumble_make tumble_world_make
#define tumble_free tumble_world_free
#define tumble_failure tumble_world_failure
#define tumble_forget_failure tumble_world_forget_failure
#define tumble_step tumble_world_step
#define tumble_time tumble_world_time
#define tumble_set_gravity tumble_world_set_gravity
#define tumble_last_step tumble_world_last_step
#define tumble_measure tumble_world_measure
#define tumble_hash tumble_world_hash
#define tumble_save tumble_world_save
#define tumble_load tumble_world_load
#define tumble_restore tumble_world_restore
#define tumble_run_on tumble_world_run_on
#define tumble_get_world_options tumble_world_get_options
#define tumble_bodies tumble_world_bodies
#define tumble_joints tumble_world_joints
#define tumble_moved tumble_world_moved
#define tumble_ray tumble_world_ray
#define tumble_ray_all tumble_world_ray_all
#define tumble_ray_soft tumble_world_ray_soft
#define tumble_nearest tumble_world_nearest
#define tumble_nearest_soft tumble_world_nearest_soft
#define tumble_overlap tumble_world_overlap
#define tumble_sweep tumble_world_sweep
#define tumble_sweep_turning tumble_world_sweep_turning
#define tumble_contacts tumble_world_contacts
#define tumble_events tumble_world_events
#define tumble_listen tumble_world_listen
#define tumble_impulses tumble_world_impulses
#define tumble_choose_contacts tumble_world_choose_contacts
#define tumble_sensor_events tumble_world_sensor_events
#define tumble_draw tumble_world_draw
#define tumble_add_plane tumble_plane_add
#define tumble_remove_plane tumble_plane_remove
#define tumble_box tumble_shape_box
#define tumble_icosahedron tumble_shape_icosahedron
#define tumble_sphere tumble_shape_sphere
#define tumble_capsule tumble_shape_capsule
#define tumble_hull tumble_shape_hull
#define tumble_obj tumble_shape_obj
#define tumble_rope tumble_shape_rope
#define tumble_cloth tumble_shape_cloth
#define tumble_weigh tumble_shape_weighed
#define tumble_round tumble_shape_rounded
#define tumble_drop_shape tumble_shape_remove
#define tumble_at tumble_body_at
#define tumble_add tumble_body_add
#define tumble_add_pieces tumble_body_add_pieces
#define tumble_add_compound tumble_body_add_compound
#define tumble_add_mesh tumble_body_add_mesh
#define tumble_add_heights tumble_body_add_heights
#define tumble_remove tumble_body_remove
#define tumble_has tumble_body_exists
#define tumble_ground tumble_body_ground
#define tumble_get_pose tumble_body_pose
#define tumble_get_poses tumble_body_poses
#define tumble_get_velocities tumble_body_velocities
#define tumble_position tumble_body_position
#define tumble_velocity tumble_body_velocity
#define tumble_spin tumble_body_spin
#define tumble_mass tumble_body_mass
#define tumble_user tumble_body_user
#define tumble_shape_of tumble_body_shape
#define tumble_get_options tumble_body_get_options
#define tumble_set_pose tumble_body_set_pose
#define tumble_set_velocity tumble_body_set_velocity
#define tumble_push tumble_body_push
#define tumble_force tumble_body_force
#define tumble_force_at tumble_body_force_at
#define tumble_wake tumble_body_wake
#define tumble_sleep tumble_body_sleep
#define tumble_is_awake tumble_body_is_awake
#define tumble_set_material tumble_body_set_material
#define tumble_set_damping tumble_body_set_damping
#define tumble_set_filter tumble_body_set_filter
#define tumble_set_user tumble_body_set_user
#define tumble_set_kind tumble_body_set_kind
#define tumble_set_gravity_scale tumble_body_set_gravity_scale
#define tumble_gravity_scale tumble_body_gravity_scale
#define tumble_set_locked tumble_body_set_locked
#define tumble_locked tumble_body_locked
#define tumble_vertices tumble_body_vertices
#define tumble_triangles tumble_body_triangles
#define tumble_pin tumble_body_pin
#define tumble_unpin tumble_body_unpin
#define tumble_vertex tumble_body_vertex
#define tumble_push_vertex tumble_body_push_vertex
#define tumble_set_bending tumble_body_set_bending
#define tumble_set_stretch tumble_body_set_stretch
#define tumble_set_sensor tumble_body_set_sensor
#define tumble_is_sensor tumble_body_is_sensor
#define tumble_sensed tumble_body_sensed
#define tumble_ball tumble_joint_ball
#define tumble_hinge tumble_joint_hinge
#define tumble_slider tumble_joint_slider
#define tumble_fix tumble_joint_fixed
#define tumble_distance tumble_joint_distance
#define tumble_hang tumble_joint_hang
#define tumble_unjoin tumble_joint_remove
#define tumble_is_joined tumble_joint_exists
#define tumble_set_limits tumble_joint_set_limits
#define tumble_set_cone tumble_joint_set_cone
#define tumble_set_motor tumble_joint_set_motor
#define tumble_set_spring tumble_joint_set_spring
#define tumble_set_servo tumble_joint_set_servo
#define tumble_set_strength tumble_joint_set_strength
#define tumble_set_touching tumble_joint_set_touching
#define tumble_may_touch tumble_joint_may_touch
#define tumble_hinge_angle tumble_joint_angle
#endif
#endif
//<
