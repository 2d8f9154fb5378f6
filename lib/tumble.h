//> tumble-head
// tumble.h - rigid bodies, rope and cloth of particles and sticks: what a
// program sees of the library.
//
// Book: chapter 19.  C11 and C++17; link with libtumble and the mathematics of
// the C library.
// Units: metres, kilograms, seconds, radians, newtons, joules.  Frame: the
// world's, right-handed; gravity acts along -y unless options say otherwise.
//
// What fails changes nothing: it returns false, 0, NULL or an id of zeros, and
// tumble_world_failure says in a sentence what failed first, and why.  An id of
// zeros and one of something that is gone are refused in the same way, and so
// is a world that is NULL: a program may go on, and ask once at its end. 
// Questions about a `const` world only return, and keep no sentence.  A world
// is used by one thread at a time.
// Pointers point to what they say; one that is written to may be NULL, and is
// then left out.

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

// Ids.  They are never used again: an id of what was removed stays refused.
typedef struct { unsigned place, generation; } tumble_shape;
typedef struct { unsigned place, generation; } tumble_body;
typedef struct { unsigned place, generation; } tumble_joint;
typedef struct { unsigned place, generation; } tumble_plane;

typedef struct { double x, y, z; } tumble_vec3;

// A unit quaternion, w + xi + yj + zk; all zero is taken for no rotation.
typedef struct { double x, y, z, w; } tumble_quat;

// Where a rigid body is: its centre of mass, and how it is turned from the axes
// of its shape.  Of rope and cloth: the mean of its vertices, and no rotation.
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

// Its matrix, row by row: what it does to a column (x, y, z).
void tumble_quat_matrix(tumble_quat q, double m[9]);

// The rotation that has this matrix.
tumble_quat tumble_quat_from_matrix(const double m[9]);

// A vector, turned by q: as the axes of the shape have it -> as the world does.
tumble_vec3 tumble_quat_rotate(tumble_quat q, tumble_vec3 v);

// A point as a body at this pose has it (m, from its centre of mass, along the axes
// of its shape) -> as the world does, and back.
tumble_vec3 tumble_pose_to_world(tumble_pose at, tumble_vec3 local);
tumble_vec3 tumble_pose_to_local(tumble_pose at, tumble_vec3 point);

// TUMBLE_VERSION and TUMBLE_VERSION_NUMBER of the library that runs, which may be
// another one than this header's.
const char *tumble_version(void);
int tumble_version_number(void);
//<

//> tumble-world
//>   A world has options, and each says when to turn it up. Most programs need
//>   none of them.
// --- The world ---------------------------------------------------------------
typedef struct {
    double dt;              // s, a step; 1e-9 to 1, 1/60
    int    substeps;        // of a step, at least, 1 to 10000; 0, as it comes:
                            // four (rope, and cloth with pins or beside
                            // what moves, eight), or so many that none
                            // is longer than 1/240 s.  High
                            // stacks, heavy loads, joints and cloth take more,
                            // and what does not touch them does not
    int    most_substeps;   // a hard step takes more of them, up to this, 200;
                            // none takes more than 10000 in all: one that would
                            // have more, for it is divided, is a failure
    tumble_vec3 gravity;    // m/s^2, (0, -9.81, 0)
    double friction;        // of bodies and planes that have none of their own,
                            // 0.5
    double restitution;     // likewise, 0; 0 to 1: speed after an impact / that
                            // before
    double sleep_speed;     // m/s, slower bodies fall asleep, 0.005: turn up if
                            // they keep awake too long; 0: none sleeps.  It is
                            // that of a cube of 1 m under 9.81 m/s^2: for
                            // others it goes as the root of radius times
                            // gravity, as all speeds do (Froude).  (What
                            // rolls at less than 30 times that, and is not
                            // pulled along, is braked by 1/100 of its weight.)
    double time_to_sleep;   // s, 0.5
    bool   certified;       // cloth never crosses cloth, whatever is demanded,
                            // nor a body, unless two bodies, or pins, demand it:
                            // where it must, it is stopped and stretches for it,
                            // and the report says so; true.  A frame of cloth
                            // costs up to three tenths more, and several times
                            // as much where it acts; false: turn it off for
                            // cloth that may cross

    // Runs work(data, 0) to work(data, items - 1) in any order, or at once on
    // several threads, and returns when all are done; NULL: one by one.  The
    // bits of a step do not depend on it.
    void (*run)(void *context, void (*work)(void *data, int item), void *data,
                int items);
    void *context;
} tumble_options;

tumble_options tumble_options_default(void);

// A world without bodies; options may be NULL.  Fails (NULL) if an option is
// out of range, or memory is refused: then tumble_world_failure(NULL) says
// which.
tumble_world *tumble_world_make(const tumble_options *options);

// Frees it with all that is in it.  NULL is fine.
void tumble_world_free(tumble_world *w);

// The sentence of the first failure, without a full stop, or NULL if there was
// none since the last call of tumble_world_forget_failure.  It stays where it
// is until then.  w = NULL: of making or loading a world, or of using one that
// is NULL, in this thread.
const char *tumble_world_failure(const tumble_world *w);
void tumble_world_forget_failure(tumble_world *w);

// One step of options.dt.  Forces that were set act in it, and are gone.
void tumble_world_step(tumble_world *w);

// s, that steps have taken in sum; rounded, so 60 steps of 1/60 s may be a
// little less than 1 s.
double tumble_world_time(const tumble_world *w);

// What the last step did, and what it could not do.
typedef struct {
    int substeps;           // of what took most
    int bodies, asleep;
    int pairs, contacts;    // of rigid bodies: that may meet; that touch, or
                            // will soon
    int unconverged;        // contacts that overlap by a tenth of the smaller
                            // body's radius, joints apart by a hundredth of
                            // it, or with axes off by a hundredth of a radian,
                            // ropes and cloths that are stretched by a
                            // hundredth, or cut by a body, or are not yet out
                            // of what they, or it, were set down in, and
                            // bodies that were stopped, for their numbers were
                            // lost: that is a failure, too, and has a sentence
    int prevented;          // unless options say otherwise: pairs of triangles of
                            // cloth, or of one and a body, that were kept from
                            // crossing, for what was asked for could not be;
    int crossed;            // and that cross, as they did before
    int dropped;            // contacts that found no memory
    int broken;             // joints that broke
} tumble_report;

tumble_report tumble_world_last_step(const tumble_world *w);

// How far from right is the world?  From the positions alone, slowly.
typedef struct {
    double penetration;     // m, the deepest overlap of two that meet: of joined
                            // bodies only if they may touch
    double strain;          // the largest |length - rest| / rest of a stick
    double kinetic, potential;          // J, of half a substep ago, as
                                        // momenta; potential: 0 at the origin
    tumble_vec3 momentum, angular;      // kg m/s; kg m^2/s, about the origin
} tumble_measures;

tumble_measures tumble_world_measure(const tumble_world *w);

// FNV-1a of all positions: equal bits, equal hash.
unsigned long long tumble_world_hash(const tumble_world *w);

// Writes all that w is to `room` bytes at `into`, and returns how many it takes;
// if those have no room, the bytes are not to be used (room = 0: to ask).  No
// byte changes in w.
size_t tumble_world_save(const tumble_world *w, void *into, size_t room);

// A world from such bytes: every step of it has the bits that the next ones of w
// had, and ids of w are good for it.  User pointers are the addresses that they
// were, and it has no threads until tumble_world_run_on.  Fails (NULL) if the
// bytes were cut or altered, and outside of the version and the kind of machine
// that wrote them; then tumble_world_failure(NULL) says why.  (A checksum tells
// accidents: bytes that somebody forged are not to be loaded.)
tumble_world *tumble_world_load(const void *from, size_t size);

// The same as tumble_world_load, put in the place of a world that is there: w
// is a pointer to what was saved, and keeps its threads and its choice of
// contacts.  Ids that the saved world gave are good, those that w gave since
// are gone.  Costs as much memory and time as a load, and keeps what w was in: the
// next one takes it again, and asks for no more memory than it is short of, as a
// rule for none.  Fails, changing nothing, as a load does.
bool tumble_world_restore(tumble_world *w, const void *from, size_t size);

// Steps run as options.run and context say, from now on.
void tumble_world_run_on(tumble_world *w,
                         void (*run)(void *context,
                                     void (*work)(void *data, int item),
                                     void *data, int items),
                         void *context);

// All bodies: writes `most` of them, and returns how many there are.
int tumble_world_bodies(const tumble_world *w, tumble_body *out, int most);

// All joints: writes `most` of them, and returns how many there are.
int tumble_world_joints(const tumble_world *w, tumble_joint *out, int most);

// Those that the last step moved, or may have moved, by an amount however small:
// writes `most` of them, and returns how many there are.  All others stand where
// they stood before it, to the bit, unless the program has put them elsewhere.  Of
// a world that was loaded: none, until its first step.
int tumble_world_moved(const tumble_world *w, tumble_body *out, int most);

bool tumble_world_set_gravity(tumble_world *w, tumble_vec3 gravity);

// The options of a world as they are now: substeps as they were chosen, gravity as
// it was set last.  NULL has those that tumble_world_make(NULL) takes.
tumble_options tumble_world_get_options(const tumble_world *w);

// --- Planes ------------------------------------------------------------------
// The free side of a plane: normal . x >= offset (m, in the normal's lengths).
// friction < 0: the world's.  All bodies wake when one comes or goes.
tumble_plane tumble_plane_add(tumble_world *w, tumble_vec3 normal,
                              double offset, double friction);
bool tumble_plane_remove(tumble_world *w, tumble_plane p);
//<

//> tumble-shapes
//>   Shapes are made once, from sizes in metres or from a file, and serve any
//>   number of bodies.
// --- Shapes ------------------------------------------------------------------
// A shape belongs to its world, and is good for many bodies.  Mass (kg) is that
// of one body, evenly filled; its origin is its centre of mass.
tumble_shape tumble_shape_box(tumble_world *w, tumble_vec3 sides, double mass);
tumble_shape tumble_shape_icosahedron(tumble_world *w, double radius,
                                      double mass);
tumble_shape tumble_shape_sphere(tumble_world *w, double radius, double mass);

// All points within radius of a segment of this length along y.
tumble_shape tumble_shape_capsule(tumble_world *w, double length, double radius,
                                  double mass);

// A cylinder of this length along y: it rolls on its side, and on the rim of an end.
// A ray and a nearest point find it as round as it is; rope, cloth, and shapes that
// are asked for, meet a prism of 32 sides, whose corners lie on its rims.
// Fails if the radius is less than a ten-thousandth of the length, or the other way
// round.
tumble_shape tumble_shape_cylinder(tumble_world *w, double length,
                                   double radius, double mass);

// A cone along y, its tip at +y: a pyramid of 32 sides whose corners lie on the
// rim, with the mass, the centre and the inertia of the round cone.  Its origin is a
// quarter of the height above its base.
tumble_shape tumble_shape_cone(tumble_world *w, double height, double radius,
                               double mass);

// The convex hull of n points.  Fails if they are fewer than four, flat, or not
// finite.
tumble_shape tumble_shape_hull(tumble_world *w, const tumble_vec3 *point, int n,
                               double mass);

// A convex body from a Wavefront OBJ file, scaled so that its furthest vertex
// is at radius.  Fails with the file's name, the line and what is wrong there.
tumble_shape tumble_shape_obj(tumble_world *w, const char *path, double radius,
                              double mass);

// A rope of n links along x, with n + 1 vertices; vertex 0 is at -x.  It is as
// thick as 1.1 links: to rope and cloth each vertex is a ball of that width.
tumble_shape tumble_shape_rope(tumble_world *w, int n, double length,
                               double mass);

// A cloth of columns x rows vertices in the plane y = 0: width along x, depth
// along z.  Vertex (i, j) is number j columns + i.  It lies three quarters of the
// way from one vertex to the next above what bears it: a fine cloth is a thin one.
tumble_shape tumble_shape_cloth(tumble_world *w, int columns, int rows,
                                double width, double depth, double mass);

// A rigid shape as s is, with another mass (kg), another centre of mass (m, in
// the frame of s, and inside it) and other moments of inertia about that centre
// (kg m^2): of the tensor along the axes of s, in the order xx, yy, zz, xy, xz,
// yz.  The last three are -(sum of m x y), and so on.
// Fails if no body can have them: a tensor that is not positive definite, or one
// of whose principal moments is not less than the sum of the two others.
tumble_shape tumble_shape_weighed(tumble_world *w, tumble_shape s, double mass,
                                  tumble_vec3 center, const double inertia[6]);

// All points within radius (m) of a rigid shape with faces, as a box or a hull: with
// round edges and corners, and larger by the radius on every side.  It has the mass
// of s, evenly filled, and its origin is its own centre of mass.
tumble_shape tumble_shape_rounded(tumble_world *w, tumble_shape s,
                                  double radius);

// Fails while a body is made of it.
bool tumble_shape_remove(tumble_world *w, tumble_shape s);
//<

//> tumble-bodies
// --- Bodies ------------------------------------------------------------------
typedef enum {
    TUMBLE_DYNAMIC,         // moves as physics wants
    TUMBLE_STATIC,          // never moves
    TUMBLE_KINEMATIC        // rigid; moves with the velocity that it is given,
                            // and pushes what it meets
} tumble_kind;

typedef struct {
    tumble_kind kind;
    tumble_pose pose;
    tumble_vec3 velocity;   // m/s, of the centre of mass
    tumble_vec3 spin;       // rad/s, about it
    double friction;        // < 0: the world's.  Two bodies rub with the root
                            // of the product of theirs
    double restitution;     // < 0: the world's.  Two bodies take the larger
    double damping;         // 1/s: the share of its velocity that is lost
    double spin_damping;    // 1/s, likewise of its spin
    unsigned group, mask;   // bits: two bodies meet if the mask of each has a
                            // bit of the other's group; group 0 is refused,
                            // and with it options that are all zeros
    void *user;             // the program's own
} tumble_body_options;

// Dynamic, at rest, its centre of mass there; meets everything.
tumble_body_options tumble_body_at(double x, double y, double z);

// Adds a body, at any time.
tumble_body tumble_body_add(tumble_world *w, tumble_shape s,
                            tumble_body_options o);

// Adds one static body of n rigid pieces, each with its own pose in the world;
// of the options, kind and pose are not asked.
tumble_body tumble_body_add_pieces(tumble_world *w, const tumble_shape *piece,
                                   const tumble_pose *pose, int n,
                                   tumble_body_options o);

// Adds one dynamic body of n rigid pieces that move as one, each with its own
// pose in the frame of the body; o.pose says where that frame is.  Mass, centre
// of mass and inertia are those of all pieces together; what two of them share
// counts twice.  The body has copies of the shapes.
tumble_body tumble_body_add_compound(tumble_world *w, const tumble_shape *piece,
                                     const tumble_pose *pose, int n,
                                     tumble_body_options o);

// Adds one static body of triangles: three numbers of points each, counter-
// clockwise seen from outside.  Behind them it is solid, as deep as `thickness`
// (m; 0: as a side is long on average), and no deeper than halfway to what is
// behind: from neither side does a centre of mass get in.  Points are in the
// frame of the pose, and are copied; kind is not asked.  Triangles without an
// area, lower than a millionth of their longest side, are left out.  A step
// costs as much as what of it lies near bodies; one that lies on more than 2,000
// triangles rubs too much.
// Fails if a number is not finite or names no point, or no triangle is left.
tumble_body tumble_body_add_mesh(tumble_world *w, const tumble_vec3 *point,
                                 int points, const int *triangle, int triangles,
                                 double thickness, tumble_body_options o);

// The same for a terrain of columns x rows points, 2 to 8192 each, around the
// pose: width along x, depth along z (m).  Point (i, j) is number j columns + i,
// and so high along y (m).  Below it is solid, as deep as `thickness` (m; 0: two
// of the longer sides of its cells): what begins in it by less than half of that
// is pushed out upwards.
tumble_body tumble_body_add_heights(tumble_world *w, const double *height,
                                    int columns, int rows, double width,
                                    double depth, double thickness,
                                    tumble_body_options o);

// The id that stands for the world itself: what is joined to it is joined to the
// world, and in answers all planes have it.
tumble_body tumble_body_ground(void);

// Do the two ids stand for the same body?
static inline bool tumble_body_is_same(tumble_body a, tumble_body b)
{
    return a.place == b.place && a.generation == b.generation;
}

// Takes a body away, with its joints; what lay on it wakes.
bool tumble_body_remove(tumble_world *w, tumble_body b);

// Is it in the world?
bool tumble_body_exists(const tumble_world *w, tumble_body b);

// Of a body that is not there, all numbers are 0.
tumble_pose tumble_body_pose(const tumble_world *w, tumble_body b);
tumble_vec3 tumble_body_position(const tumble_world *w, tumble_body b);
tumble_vec3 tumble_body_velocity(const tumble_world *w, tumble_body b);
tumble_vec3 tumble_body_spin(const tumble_world *w, tumble_body b);
double tumble_body_mass(const tumble_world *w, tumble_body b);  // static: 0
void  *tumble_body_user(const tumble_world *w, tumble_body b);

// Puts a rigid body somewhere else, at once; it keeps its velocity.  (A
// kinematic body that is put back before every step is a conveyor: what lies on
// it is carried along.)
bool tumble_body_set_pose(tumble_world *w, tumble_body b, tumble_pose pose);

// Gives a rigid body a velocity and a spin: a kinematic one keeps them.
bool tumble_body_set_velocity(tumble_world *w, tumble_body b,
                              tumble_vec3 velocity, tumble_vec3 spin);

// An impulse (N s) at a point of the world, now.  Static and kinematic bodies
// refuse pushes.
bool tumble_body_push(tumble_world *w, tumble_body b, tumble_vec3 impulse,
                      tumble_vec3 at);

// A force (N) at the centre of mass, and a torque (N m), in the next step; what
// is set twice adds up.  The force is the same in all of the step.  So one that
// depends on where the body is brings in energy: after ten rounds of 377 steps, a
// planet that a sun pulls is 1.5 times as far from it.  A push by the force times dt
// before each step brings in none.
bool tumble_body_force(tumble_world *w, tumble_body b, tumble_vec3 force,
                       tumble_vec3 torque);

// A force (N) at a point of the world, as it is now, in the next step; with
// tumble_body_force it adds up.
bool tumble_body_force_at(tumble_world *w, tumble_body b, tumble_vec3 force,
                          tumble_vec3 at);

// Sleeping bodies wake when they are pushed or met.
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
// tumble_body_spin, say of b[0] to b[n - 1], in that order; zeros of one that
// is not there.
void tumble_body_poses(const tumble_world *w, const tumble_body *b, int n,
                       tumble_pose *out);
void tumble_body_velocities(const tumble_world *w, const tumble_body *b, int n,
                            tumble_vec3 *velocity, tumble_vec3 *spin);

// All that was set, as it is now: with these options tumble_body_add makes
// another body of this kind there.  Of one that is not there: zeros, which
// tumble_body_add refuses.
tumble_body_options tumble_body_get_options(const tumble_world *w,
                                            tumble_body b);

// The shape that it was made of: of several pieces, the first; of a surface, zeros.
tumble_shape tumble_body_shape(const tumble_world *w, tumble_body b);

// Another kind for a body that is there, rigid and of one piece: it stays where it
// is.  What becomes dynamic goes on as it went, what becomes kinematic stands until
// it is given a velocity; its axes are locked no more.  What lay on it, or is joined
// to it, wakes.
bool tumble_body_set_kind(tumble_world *w, tumble_body b, tumble_kind kind);

// So many times the world's gravity acts on a rigid body of one piece, -1000 to 1000;
// 1: as on all others; 0: none; below: it rises.  It wakes, and keeps its velocity.
bool tumble_body_set_gravity_scale(tumble_world *w, tumble_body b,
                                   double scale);
double tumble_body_gravity_scale(const tumble_world *w, tumble_body b);

// Axes of the world along which a dynamic body does not go, and about which it does
// not turn, from where it stands now; 0: none are locked.  They hold as a joint to
// the ground does, against whatever pushes, and from a pose that is set, from there.
// Of one turn that is locked alone the speed is held, and of two or three the angles.
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
// A sensor: a rigid body, of one piece or several, that pushes nothing, and that no
// ray, sweep or other question meets.  One that is dynamic weighs what it weighs, and
// falls through all, planes as well: it is for a joint to hold.  It costs nothing until
// it is asked for what is in it.  That are dynamic and kinematic bodies, rope and cloth whose
// groups and masks would let the two meet, but no other sensor and no surface.
bool tumble_body_set_sensor(tumble_world *w, tumble_body b, bool is_sensor);
bool tumble_body_is_sensor(const tumble_world *w, tumble_body b);

// What overlaps a sensor now: writes `most` of them, and returns how many there are;
// -1 for rope and cloth, of which one vertex with its ball is enough, and all others
// as they are.  It looks at all bodies.  Of what is no sensor: 0.
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

// Its triangles: three numbers of vertices each, counter-clockwise seen from
// outside (of a cloth: from above).  They stay as long as its shape does.
const int *tumble_body_triangles(const tumble_world *w, tumble_body b,
                                 int *count);

// --- Rope and cloth ----------------------------------------------------------
// Vertex i stays where it is, until it is let go.
bool tumble_body_pin(tumble_world *w, tumble_body b, int i);
bool tumble_body_unpin(tumble_world *w, tumble_body b, int i);
tumble_vec3 tumble_body_vertex(const tumble_world *w, tumble_body b, int i);

// An impulse (N s) on vertex i.
bool tumble_body_push_vertex(tumble_world *w, tumble_body b, int i,
                             tumble_vec3 impulse);

// m/s, how fast vertex i goes, and to give it a velocity; a pinned one refuses.  The
// mean of all of them is tumble_body_velocity.
tumble_vec3 tumble_body_vertex_velocity(const tumble_world *w, tumble_body b,
                                        int i);
bool tumble_body_set_vertex_velocity(tumble_world *w, tumble_body b, int i,
                                     tumble_vec3 velocity);

// Stiffness against bending: N m^2 of a rope, N m of a cloth; 0: none.
bool tumble_body_set_bending(tumble_world *w, tumble_body b, double stiffness);

// By how much threads give: a newton stretches a metre of a rope by so many
// metres (1/N), or a cloth, for every metre of its width (m/N).  Denim: 1e-4.
// 0: not at all; but a pinned cloth becomes longer by 4e-6 under its own weight.
bool tumble_body_set_stretch(tumble_world *w, tumble_body b, double compliance);
//<

//> tumble-joints
//>   Joints are made where the bodies stand (chapter 17). Each kind has a
//>   function of its own, because each needs other arguments.
// --- Joints ------------------------------------------------------------------
// Between two rigid bodies, or a body and the world, which is the id
// tumble_body_ground().  Bodies that are joined do not collide with each other,
// unless tumble_joint_set_touching says so, nor does a rope or cloth with a
// body that it hangs on; what is joined by way of another body does, unless
// their groups or their places keep them apart.
// Points and axes are where they are in the world when the joint is made.
//
// A point of a and a point of b stay together.
tumble_joint tumble_joint_ball(tumble_world *w, tumble_body a, tumble_body b,
                               tumble_vec3 at);

// And an axis of each: b turns about it as seen from a.
tumble_joint tumble_joint_hinge(tumble_world *w, tumble_body a, tumble_body b,
                                tumble_vec3 at, tumble_vec3 axis);

// And b moves along an axis of a without turning against it.
tumble_joint tumble_joint_slider(tumble_world *w, tumble_body a, tumble_body b,
                                 tumble_vec3 at, tumble_vec3 axis);

// They move as one.
tumble_joint tumble_joint_fixed(tumble_world *w, tumble_body a, tumble_body b,
                                tumble_vec3 at);

// Two points are at least and at most so far apart (m).
tumble_joint tumble_joint_distance(tumble_world *w, tumble_body a,
                                   tumble_vec3 at_a, tumble_body b,
                                   tumble_vec3 at_b, double least, double most);

// Vertex i of a rope or cloth stays where it is now, as seen from a rigid body.
tumble_joint tumble_joint_hang(tumble_world *w, tumble_body soft, int i,
                               tumble_body b);

bool tumble_joint_remove(tumble_world *w, tumble_joint j);
bool tumble_joint_exists(const tumble_world *w, tumble_joint j);

// Which bodies it joins: side 0 is a, and side 1 is b; of one that is gone, zeros.
tumble_body tumble_joint_body(const tumble_world *w, tumble_joint j, int side);

// How far b may turn against a hinge's axis (rad; beyond -pi and pi there is no
// limit) or go along a slider's (m, of either sign), 0 being how they stood when
// they were joined; or how far apart the points of a distance are (m; below 0 there
// is no limit).  -HUGE_VAL and HUGE_VAL take both off.  Equal limits hold it there:
// moved a little in every step, they drive it.
bool tumble_joint_set_limits(tumble_world *w, tumble_joint j, double least,
                             double most);

// A ball joint: an axis, which a and b have in common as they stand now, leans by
// `swing` (rad) at most, and b turns about it from least to most (rad).  Beyond pi
// there is no limit; near pi the turn is not defined, so a cone is narrower.  Another
// call begins from how they stand then.
bool tumble_joint_set_cone(tumble_world *w, tumble_joint j, tumble_vec3 axis,
                           double swing, double least, double most);

// N m, with which a ball joint resists turning, about whatever axis, at most; 0: it
// turns freely.  Together with a cone, or alone.  It wakes both bodies.  (Of a hinge
// and a slider, friction is a motor of speed 0.)
bool tumble_joint_set_friction(tumble_world *w, tumble_joint j, double torque);

// Along the free way of a hinge (rad, N m), a slider or a distance (m, N) there may
// be a motor and a spring.  Both act together, and within the limits, but equal
// limits of a distance do not count.  To set one wakes both bodies.
//
// The motor keeps b at `speed` against a (rad/s, right-handed about the axis; m/s
// along it, or apart) with `force` (N m or N, not negative) at most.  A speed of 0 is
// friction, or a brake; a force of 0 takes the motor off, and HUGE_VAL is as much
// as it takes.
bool tumble_joint_set_motor(tumble_world *w, tumble_joint j, double speed,
                            double force);

// The spring pulls to `rest` (rad or m) with `stiffness` (N m/rad, N/m), and brakes
// with `damping` (N m s/rad, N s/m).  That of a hinge takes the shorter way round,
// whatever limits there are.  Any stiffness is safe at any dt.  Both 0: the spring is
// taken off.
bool tumble_joint_set_spring(tumble_world *w, tumble_joint j, double rest,
                             double stiffness, double damping);

// A spring to `place` (rad or m) that gives `force` (N m or N) at most.  The two
// bodies alone, as they stand now, would swing about it at `hertz` (1/s), with a
// damping ratio of `ratio` (0: undamped; 1: critical).  It takes the place of a spring
// that was set; a force of 0 takes it off, and HUGE_VAL sets no bound.
bool tumble_joint_set_servo(tumble_world *w, tumble_joint j, double place,
                            double hertz, double ratio, double force);

// N: a joint that has to bear more breaks, and is gone; 0: it never does.  Cloth and
// rope themselves do not tear, but the joints by which they hang may break.
bool tumble_joint_set_strength(tumble_world *w, tumble_joint j, double force);

// May the two bodies of a joint push each other, as if they were not joined?  A new
// joint says no, and of several between two bodies one that says no is enough.
// Begin where they do not overlap.
bool tumble_joint_set_touching(tumble_world *w, tumble_joint j, bool may_touch);
bool tumble_joint_may_touch(const tumble_world *w, tumble_joint j);

// Along its free way: where b is against a (rad, from -pi to pi, or m; of a
// distance: how far apart the points are), and how fast it moves (rad/s, m/s).
double tumble_joint_place(const tumble_world *w, tumble_joint j);
double tumble_joint_speed(const tumble_world *w, tumble_joint j);
// rad, how far a cone's axis leans, and b has turned about it; 0 without a cone.
double tumble_joint_swing(const tumble_world *w, tumble_joint j);
double tumble_joint_twist(const tumble_world *w, tumble_joint j);
// What motor, spring and limits together gave in the last substep (N m or N,
// the way that the place grows: a winch that pulls gives less than 0; 0 without
// motor and spring).
double tumble_joint_drive(const tumble_world *w, tumble_joint j);
// m, how far apart are the points that it holds (how its axes are off is not in it,
// but in a step's `unconverged`); N, what it bore in the last substep; N m, what it
// bore then against turning, about its point (of a hinge with its motor, spring and
// limits; 0 of a ball without a cone, a distance and a stitch); a hinge's place, by
// another name.
double tumble_joint_gap(const tumble_world *w, tumble_joint j);
double tumble_joint_force(const tumble_world *w, tumble_joint j);
double tumble_joint_torque(const tumble_world *w, tumble_joint j);
double tumble_joint_angle(const tumble_world *w, tumble_joint j);
//<

//> tumble-ask
//>   A program asks what is where in four ways, and one query answers all of
//>   them: the distance of chapter 04. A ray is a point that moves (chapter 15,
//>   *Rays*). A point or a shape that stands still needs only its distance from
//>   each body.
// --- What is where -----------------------------------------------------------
// Only bodies with a bit of their group in `mask` are asked (~0u: all), and
// planes, whose id is tumble_body_ground().  Rope and cloth are not.
typedef struct {
    tumble_body body;
    tumble_vec3 point;      // m, on its surface
    tumble_vec3 normal;     // unit, out of it
    double fraction;        // of the way, 0 to 1; of the nearest point: the
                            // distance (m)
    int vertex;             // of rope and cloth, the nearest one; else 0
} tumble_hit;

// What does the way from one point to another meet first?  False: nothing.  A
// way that begins in a body meets that at once.
bool tumble_world_ray(const tumble_world *w, tumble_vec3 from, tumble_vec3 to,
                      unsigned mask, tumble_hit *hit);

// The point of a body or plane nearest to x, no further away than `most` (m).
// Of an x inside: x itself.
bool tumble_world_nearest(const tumble_world *w, tumble_vec3 x, double most,
                          unsigned mask, tumble_hit *hit);

// The bodies that a rigid shape there would overlap: writes `most` of them, and
// returns how many there are.
int tumble_world_overlap(const tumble_world *w, tumble_shape s,
                         tumble_pose pose, unsigned mask, tumble_body *out,
                         int most);

// What does a rigid shape meet first that moves by `way` without turning?  If
// it touches something where it begins, or is in it, that is met at once, with
// a normal against the way, even if the way leads out.  So what slides along
// walls should keep a little away from them.
bool tumble_world_sweep(const tumble_world *w, tumble_shape s, tumble_pose pose,
                        tumble_vec3 way, unsigned mask, tumble_hit *hit);

// The same of one that turns as steadily as it goes: by the angle |turn| (rad) about
// the axis `turn`, through its centre of mass.  To a millionth of the way and the
// sizes, and never too late.
bool tumble_world_sweep_turning(const tumble_world *w, tumble_shape s,
                                tumble_pose pose, tumble_vec3 way,
                                tumble_vec3 turn, unsigned mask,
                                tumble_hit *hit);

// All bodies that the way from one point to another meets, each once, where it does
// first, and planes: the `most` nearest of them, the nearest first.  Returns how many
// there are.
int tumble_world_ray_all(const tumble_world *w, tumble_vec3 from,
                         tumble_vec3 to, unsigned mask, tumble_hit *out,
                         int most);

// Likewise of rope and cloth alone: what does the way meet first, and which point of
// them is nearest to x, no further away than `most` (m)?  A cloth is its triangles, and
// a rope as thick as it is to others.
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
// radius away from all that is in its way, and pushes nothing.
typedef struct {
    double length, radius;  // m, as tumble_shape_capsule has them
    tumble_vec3 up;         // of any length > 0
    double step;            // m, the highest step that it climbs or goes down, 0 or
                            // more; it stands on an edge no higher above its foot
    double slope;           // rad, the steepest ground that it stands on, 0 to less
                            // than pi / 2
    unsigned mask;          // groups that are in its way (a body that stands for it
                            // must be in none of them)
} tumble_walker;

// Upright along y; it climbs steps as high as its radius and slopes of pi / 4, and
// everything is in its way.
tumble_walker tumble_walker_capsule(double length, double radius);

// Where it is; all but the position may be zeros at first.
typedef struct {
    tumble_vec3 position;   // m, of its middle
    tumble_body ground;     // what it stands on; of planes tumble_body_ground()
    tumble_vec3 point;      // m, where that is next to it, in the world and
    tumble_vec3 foot;       // as the ground's pose has it
    tumble_vec3 normal;     // unit, out of the ground; of an edge it leans
    tumble_vec3 velocity;   // m/s, of the ground at that point
    bool stands;            // a program that jumps makes it false
} tumble_walk;

// From there it goes by `way` (m), and comes `to` where it can.
// What has come into it since pushes it out.  While it stands, it is carried by what
// its ground has moved and turned since, goes by the level part of the way, as long as
// on a map, over steps and down them, and only where the ground is too far below, or
// too steep, by the rest of the way.  In the air all of the way counts; where it leads
// down to ground that is not too steep, it stands.  Walls turn it along them, and take
// what leads into them.  The program adds gravity: its velocity times dt is the way, and
// how far it came, over dt, the velocity to go on with.
// False, with `to` as it was: numbers of it are not finite, or no character's.
bool tumble_world_walk(const tumble_world *w, tumble_walker how,
                       tumble_walk from, tumble_vec3 way, tumble_walk *to);
//<

//> tumble-contacts
//>   A game wants to know what touches, and above all what has *begun* to
//>   touch.
// --- Who touches whom --------------------------------------------------------
enum { TUMBLE_POINTS = 4 };

// Rigid bodies that push each other; b may be tumble_body_ground(), for a
// plane.
typedef struct {
    tumble_body a, b;
    tumble_vec3 normal;             // unit, from b to a
    int points;                     // 1 to TUMBLE_POINTS
    tumble_vec3 point[TUMBLE_POINTS];   // m
    double force[TUMBLE_POINTS];    // N, along the normal, in the last substep: what
                                    // a new velocity of a lift gives, at once, only
                                    // tumble_world_impulses has
} tumble_contact;

// Those that pushed each other in the last substep of the last step: writes `most` of
// them, and returns how many there are.  What was stopped earlier in the step, as
// what runs into a wall is, only tumble_world_impulses has.
int tumble_world_contacts(const tumble_world *w, tumble_contact *out, int most);

// Which began or ended to touch since this was last asked?  It compares what touches
// now with what did then.  A ball that came, bounced and left in between, as off a
// bumper, is in neither list; tumble_world_impulses has it.
typedef struct {
    tumble_body a, b;
    bool begins;
    tumble_vec3 point;      // m, where the pair pushed most, and
    tumble_vec3 normal;     // unit, from b to a, now, or, if it ends, when it was
    double force;           // last asked; N, with which all its points pushed; how
                            // hard a blow was: tumble_world_impulses.  Of
                            // sensors: zeros
} tumble_event;

// Writes `most` of them, and returns how many there are; those that found no
// room are lost.
int tumble_world_events(tumble_world *w, tumble_event *out, int most);

// What one rigid body gave another in the whole of the last step, impacts with it: of
// a bounce that began and ended in it as well, which no list of contacts has.
typedef struct {
    tumble_body a, b;       // b may be tumble_body_ground(), for a plane
    tumble_vec3 point;      // m, the mean of all that pushed, by its share, where
                            // it first did in the step
    tumble_vec3 normal;     // unit, from b to a, likewise
    double impulse;         // N s, along the normals
} tumble_impulse;

// Steps write it down from now on, or no more.  It changes no bit of them.  A world
// that was loaded does as the saved one did.
bool tumble_world_listen(tumble_world *w, bool on);

// Of the last step, sorted by bodies: writes `most` of them, and returns how many there
// are; 0 if it was not written down, or nothing moved.
int tumble_world_impulses(const tumble_world *w, tumble_impulse *out, int most);

// Asks `meets` for each contact that a step is about to begin with, in their order:
// shall the two push each other in this step?  It has the ids, the normal and the
// points, without forces, and may ask the world, but not change it.  NULL: all do.  A
// loaded world has none.  Of bodies that fly by their own size in a step it may be
// asked several times, and again for the rest of the step.
bool tumble_world_choose_contacts(tumble_world *w,
                                  bool (*meets)(void *context,
                                                const tumble_contact *c),
                                  void *context);

// Which came into a sensor, or left it, since this was last asked?  a is the sensor;
// what is gone has left it.  Writes `most` of them, and returns how many there are;
// those that found no room are lost.
int tumble_world_sensor_events(tumble_world *w, tumble_event *out, int most);
//<

//> tumble-draw
//>   The last part is for the moment when something goes wrong: lines for all
//>   that the engine knows, to be drawn over the picture.
// --- Drawing -----------------------------------------------------------------
// What a program's window draws with; a function may be NULL.
typedef struct {
    void (*triangle)(void *context, tumble_body b, const tumble_vec3 at[3]);
    void (*line)(void *context, tumble_body b, const tumble_vec3 at[2]);
    void (*point)(void *context, tumble_body b, tumble_vec3 at);
    void *context;
} tumble_pen;

// Bodies as triangles, ropes and joints as lines, contacts as points.
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
