//> joint-head
//>   A joint is made where the bodies stand, from a point and an axis in the
//>   world's coordinates. This is the plan of one.
// joint.h - what holds two rigid bodies together, as rows of a Jacobian.
//
// Paper: not asked.  Book: chapter 17.
// Units: metres, kilograms, seconds, radians.

#pragma once

#include "inline.h"
#include "solver.h"

// A ball joint: a point of A and a point of B stay together.  A hinge: an axis
// of each as well.  A fixed joint: they move as one.  A distance: two points
// are at least and at most so far apart.  A pin: a particle of a rope or cloth
// stays at a place on a rigid body (pin.h).  A slider: B moves along an axis of A,
// and does not turn against it.  A lock: B, joined to the world, does not go along
// some of the world's axes, nor turn about some.
typedef enum {
    JOINT_NONE, JOINT_BALL, JOINT_HINGE, JOINT_FIXED, JOINT_DISTANCE,
    JOINT_PIN, JOINT_SLIDER, JOINT_LOCK, JOINT_KINDS
} joint_kind;

// A joint to be made, told as the bodies stand now.
typedef struct {
    joint_kind kind;
    int  a, b;          // bodies; -1: the world, which does not move; of a pin,
                        // A is the deformable one
    int  particle;      // of a pin: of A
    vec3 point;         // m, in the world; of a distance: the point of A
    vec3 point_b;       // m, of a distance: the point of B
    vec3 axis;          // of a hinge or slider, in the world; of any length > 0
    real least, most;   // m, of a distance
    real strength;      // N: under a greater force it breaks; 0: under none
    unsigned locked;    // of a lock: bits 0 to 2, ways along x, y and z; 3 to 5,
                        // turns about them
    bool may_touch;     // the two bodies may touch each other
} joint_plan;
//<

//> joint-free
//>   A hinge may turn, a slider and a distance may grow longer: that is the one
//>   way in which they are free. A motor and a spring act along it. Each gives at
//>   most so much, and says whether it does.
// What acts along the free way of a joint.  A place, a speed and an impulse along
// it are those of B against A: rad and N m of a hinge, m and N of the others.
typedef struct {
    real speed, force;          // what the motor wants, and gives at most; no
                                // force: there is no motor
    real rest;                  // where the spring pulls to
    real stiffness, damping;    // N/m, N s/m or N m/rad, N m s/rad; both 0: there
                                // is no spring
    real bound;                 // what it gives at most; HUGE_VAL: anything
    real inverse;               // 1/kg, 1/(kg m^2), what answers along the way
    int  limit;                 // -1, 1: the least or the greatest place holds
    int  motor, spring;         // -1, 1: it gives its most, backwards or forwards
    bool is_new;                // it has not acted yet
} joint_drive;
//<

//> joint-struct
//>   It is kept in the coordinates of each of its bodies, because these do not
//>   change when the bodies move. The impulse of each row is kept as well, for
//>   the warm start.
enum { JOINT_ROWS = 6, JOINT_AXES = 3 };

// Points and axes are kept as what they are to their bodies: coordinates in the
// body's frame, or in the world.
typedef struct {
    joint_kind kind;            // JOINT_NONE: there is no joint at this number
    int  a, b;
    int  particle;              // of a pin
    vec3 local_a, local_b;      // the points
    vec3 axis_a[JOINT_AXES];    // the same three directions, perpendicular, as
    vec3 axis_b[JOINT_AXES];    // A and as B have them; a hinge turns about [0]
    real least, most;           // m, of a distance, or a slider; rad, of a
                                // hinge: how far B may have turned against A
    bool is_limited;            // there is a least and a most, in a row that is
                                // there while the limit pushes
    bool is_driven;             // there is a motor or a spring: its row is always
    bool has_limits;            // there, and does what the limits do as well
    bool slips;                 // its friction gives its most
    int  extra;                 // such rows: 1 of a drive, 2 of a cone, 3 where a
                                // ball joint has friction, with a cone or without
    bool is_coned;              // a ball joint: axis [0] of B leans from that of A
    real cone;                  // by so much at most, rad, and B has turned about
    bool cone_holds[2];         // it from least to most; swing and twist hold now
    joint_drive drive;
    real friction;              // N m, of a ball joint; 0: none
    real strength;              // N; HUGE_VAL: it never breaks
    unsigned locked;            // of a lock
    bool may_touch;
    bool is_broken;             // it holds no more
    real impulse[JOINT_ROWS];   // N s, N m s, of each row, with which the
                                // next substep begins, and in it so far
    real force;                 // N, in that substep
    real given;                 // N, N m, of a drive, in that substep
    real own;                   // 1/kg, the pinned particle's, while strands
    vec3 start;                 // pull, and m, where it was before
} joint;
//<

//> joint-rows-struct
// A joint as its bodies stand now.  The rows of the Jacobian say how fast each
// error grows: the sum of a[k] times A's velocity and b[k] times B's.
typedef struct {
    int  count;                 // rows that hold now
    int  held;                  // of these, rows that hold always; the next one
                                // is the limit's, which only pushes, or a drive's
    int  lengths;               // the first rows are lengths, the others angles
    vec3 across[2];             // of a hinge: those axes must not turn
    real a[JOINT_ROWS][MOTIONS], b[JOINT_ROWS][MOTIONS];
    real error[JOINT_ROWS];         // m, rad; of the limit: what is left
    bool is_upper;              // the limit is the greater of the two
    joint begun;                // as the substep found it, and the limit, to
    bool was_upper;             // begin it again
    bool rubs;                  // something presses one that is joined to it
    bool is_free;               // its tree is joined to nothing that no pull moves
    real pushed[JOINT_ROWS];    // the impulse before the bodies moved, and that
    real older[JOINT_ROWS];     // of the substep before
    real inverse[JOINT_ROWS][JOINT_ROWS];   // of K
    real give[JOINT_ROWS];      // 1/kg, 1/(kg m^2), what a unit impulse leaves
                                // of what it should change
    real share;                 // of an error that a substep takes back
    real swing;                 // 1/(kg m), see linkage.c
    real hung;                  // rad/s, of a swing under a body's own weight
    real size;                  // m, the smaller radius of the two bodies
    real want[JOINT_ROWS];      // m/s, rad/s: what the impulses are to change
    real since[JOINT_ROWS];     // N s, N m s: what they were given since the tree
                                // was last switched
    real before;                // rad/s, m/s, along the way of a drive when the
                                // substep begins, and
    real speed;                 // as it is now;
    real room[2];               // between the limits' speeds;
    real pull, slope;           // N s, kg, the spring gives pull - slope speed;
    real kick;                  // s, for which forces act;
    real hard, kept;            // the give of a row that holds, and N s, what it
                                // gave when the substep began
    real cone_want[2];          // what they want, rad/s, held or not
    real twist_size;            // of friction: of the axis of its second row;
    real turning[3];            // rad/s, along its rows as it is now;
    real firm[3], resisted[3];  // as hard and kept, of its rows
    real pace;                  // rad/s, of the fastest swing about it in the
                                // last frame
    int  next[2];               // in the lists of A's and B's joints; -1: none
} joint_rows;

// One of the two bodies: how it may move, and where it stands.
typedef struct {
    const motion_basis *basis;  // zero: it does not
    rigid_frame frame;
} joint_side;
//<

//> joint-declare
//>   The functions of a joint know two bodies and no world, so that a test can
//>   hold one joint in its hand.
// Fails, with a sentence, if numbers are not finite, a hinge's axis has no
// direction, a distance has least > most or less than 0, or the kind is none.
status joint_check(const joint_plan *plan);

// The joint of a plan that has been checked, between bodies that stand as the
// frames say.
joint joint_make(const joint_plan *plan, const rigid_frame *a,
                 const rigid_frame *b);

// The frame of the world: coordinates in it are metres.
extern const rigid_frame JOINT_WORLD;

// pi, rounded up: no hinge is further than that from how it was made.
#define JOINT_HALF_TURN 3.141592653589794

// How far a hinge has turned: rad, of B against A, from -pi to pi; 0 as it was
// made.
real joint_angle(const joint *j, const rigid_frame *a, const rigid_frame *b);

// Where B is along the free way: that angle, or m, how far a slider has gone, how
// long a distance is; of other joints 0.
real joint_where(const joint *j, const rigid_frame *a, const rigid_frame *b);

// A ball joint gets a cone, from an axis in the world as the bodies stand; its
// fields cone, least and most are to be set.
void joint_set_cone(joint *j, const rigid_frame *a, const rigid_frame *b,
                    vec3 axis);

// rad, from 0 to pi, by how much the axis leans; rad, from -pi to pi, by how much
// B has turned about it.
real joint_swing(const joint *j, const rigid_frame *a, const rigid_frame *b);
real joint_twist(const joint *j, const rigid_frame *a, const rigid_frame *b);

// The row of the twist turns about an axis of this length.
real joint_twist_length(const joint *j, const rigid_frame *a,
                        const rigid_frame *b);

// The free way of such a joint in the world: of a hinge or a slider its axis, of a
// distance the direction from A to B.
vec3 joint_direction(const joint *j, const rigid_frame *a, const rigid_frame *b);

// Where the points are: m, of A and of B.
void joint_points(const joint *j, const rigid_frame *a, const rigid_frame *b,
                  vec3 *on_a, vec3 *on_b);

// The rows that a ball joint has beside those of its point.
static inline int joint_ball_rows(const joint *j)
{
    return j->friction > 0 ? 3 : 2 * j->is_coned;
}

// Does it hold anything?
static inline bool joint_holds(const joint *j)
{
    return j->kind != JOINT_NONE && !j->is_broken;
}

// Can it be driven?
static inline bool joint_is_free(const joint *j)
{
    return j->kind == JOINT_HINGE || j->kind == JOINT_SLIDER
        || j->kind == JOINT_DISTANCE;
}

// The errors, and the rows by which they change, when the bodies stand so.  Of a
// drive it is no error, but the place.
void joint_find_rows(joint_rows *r, const joint *j, const joint_side *a,
                     const joint_side *b);

// The errors alone, along the directions of r, when the bodies stand elsewhere.
void joint_errors(const joint *j, const joint_rows *r, const rigid_frame *a,
                  const rigid_frame *b, real error[JOINT_ROWS]);
//<

//> joint-small-declare
//>   Each joint is a small linear system, and so is each body of a tree. Both
//>   are solved by an inverse, which serves several times.
// A symmetric, positive matrix of n <= JOINT_ROWS rows becomes its inverse.  A
// row that nothing answers becomes zeros.
void small_invert(int n, real m[JOINT_ROWS][JOINT_ROWS]);

// Three rows are those of a ball joint: each moves the centre along one axis only.
// So a row begins there, ends there, and goes on with the turns.
ALWAYS_INLINE int straight_first(int rows, int row)
{
    return rows == 3 ? row : 0;
}

ALWAYS_INLINE int straight_end(int rows, int row)
{
    return rows == 3 ? row + 1 : MOTION_TURN;
}

// K_kl: so a unit impulse along row k, of n, moves bodies of these inverse masses
// (1/kg) along row l.
ALWAYS_INLINE real joint_coupling(int n, const joint_rows *r, int k, int l,
                                  real mass_a, real mass_b)
{
    real straight_a = 0, straight_b = 0, turning = 0;
    for (int i = straight_first(n, k); i < straight_end(n, k); i++) {
        straight_a += r->a[k][i] * r->a[l][i];
        straight_b += r->b[k][i] * r->b[l][i];
    }
    for (int i = MOTION_TURN; i < MOTIONS; i++)
        turning += r->a[k][i] * r->a[l][i] + r->b[k][i] * r->b[l][i];
    return mass_a * straight_a + mass_b * straight_b + turning;
}

// x becomes m x.
static inline void small_times(int n, real m[JOINT_ROWS][JOINT_ROWS], real *x)
{
    real y[JOINT_ROWS] = { 0 };
    for (int k = 0; k < n; k++)
        for (int i = 0; i < n; i++) y[i] += m[k][i] * x[k];
    for (int i = 0; i < n; i++) x[i] = y[i];
}
//<
