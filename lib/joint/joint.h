//> joint-head
//>   A joint is made where the bodies stand, from a point and an axis in the
//>   world's coordinates. This is the plan of one.
// joint.h - joints of two rigid bodies, as rows of a Jacobian.
//
// Paper: not asked.  Book: chapter 17.
// Units: metres, kilograms, seconds, radians.

#pragma once

#include "inline.h"
#include "solver.h"

// Ball: a point of A and a point of B stay together.  Hinge: they keep an axis in
// common, too.  Fixed: A and B move as one.  Distance: two points are at least and at
// most so far apart.  Pin: a particle of a rope or cloth stays at a place on a rigid
// body (pin.h).  Slider: B moves along an axis of A, and does not turn against A.
// Lock: B, joined to the world, does not move along some of the world's axes, nor turn
// about some.
typedef enum {
    JOINT_NONE, JOINT_BALL, JOINT_HINGE, JOINT_FIXED, JOINT_DISTANCE,
    JOINT_PIN, JOINT_SLIDER, JOINT_LOCK, JOINT_KINDS
} joint_kind;

// A joint to be made, with the bodies as they stand now.
typedef struct {
    joint_kind kind;
    int  a, b;          // bodies; -1: the world, which does not move.  The A of a pin
                        // is the rope or cloth,
    int  particle;      // and this its particle
    vec3 point;         // m, in the world; of a distance: the point of A
    vec3 point_b;       // m, of a distance: the point of B
    vec3 axis;          // of a hinge or slider, in the world; of any length > 0
    real least, most;   // m, of a distance
    real strength;      // N, a greater force breaks it; 0: it never breaks
    unsigned locked;    // of a lock: bits 0 to 2 for moves along x, y and z, bits 3 to
                        // 5 for turns about them
    bool may_touch;     // the two bodies may collide
} joint_plan;
//<

//> joint-free
//>   A hinge may turn, a slider and a distance may grow longer: that is the one
//>   way in which they are free. A motor and a spring act along it. Each gives at
//>   most so much, and says whether it does.
// The motor and the spring along the free motion of a joint.  Places, speeds and
// impulses are those of B as seen from A: rad and N m of a hinge, m and N of the
// others.
typedef struct {
    real speed, force;          // the speed of the motor, and the most that it
                                // gives; force 0: there is no motor
    real rest;                  // the place to which the spring pulls
    real stiffness, damping;    // N/m, N s/m or N m/rad, N m s/rad; both 0: there
                                // is no spring
    real bound;                 // the most that it gives; HUGE_VAL: no bound
    real inverse;               // 1/kg, 1/(kg m^2), inverse effective mass
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

// Points and axes are kept as coordinates in the frame of their body, or in the world.
typedef struct {
    joint_kind kind;            // JOINT_NONE: there is no joint at this number
    int  a, b;
    int  particle;              // of a pin
    vec3 local_a, local_b;      // the points
    vec3 axis_a[JOINT_AXES];    // the same three directions, perpendicular, as
    vec3 axis_b[JOINT_AXES];    // A and as B have them; a hinge turns about [0]
    real least, most;           // m, of a distance, or a slider; rad, of a
                                // hinge: how far B may have turned against A
    bool is_limited;            // it has limits, with a row that exists while a limit
                                // pushes
    bool is_driven;             // it has a motor or a spring, whose row always exists,
    bool has_limits;            // and acts for the limits, too
    bool slips;                 // its friction gives its most
    int  extra;                 // rows of these kinds: 1 of a drive, 2 of a cone, 3 of
                                // a ball joint with friction
    bool is_coned;              // a ball joint with a cone: axis [0] of B leans from
    real cone;                  // that of A by at most so much (rad), and B turns about
    bool cone_holds[2];         // it from least to most; swing or twist holds now
    joint_drive drive;
    real friction;              // N m, of a ball joint; 0: none
    real strength;              // N; HUGE_VAL: it never breaks
    unsigned locked;            // of a lock
    bool may_touch;
    bool is_broken;             // it no longer holds
    real impulse[JOINT_ROWS];   // N s, N m s, of each row: with which the next substep
                                // begins, and in a substep the sum so far
    real force;                 // N, in the last substep
    real given;                 // N, N m, of its drive, in the last substep
    real own;                   // 1/kg, of the pinned particle, while strands pull,
    vec3 start;                 // and m, where it was before that
} joint;
//<

//> joint-rows-struct
// A joint with its bodies as they stand now.  Row k of the Jacobian says how fast error
// k grows: a[k] times A's velocity plus b[k] times B's.
typedef struct {
    int  count;                 // rows that hold now,
    int  held;                  // and of these the rows that always hold; the next one
                                // is that of a limit, which only pushes, or a drive
    int  lengths;               // the first rows are lengths, the others angles
    vec3 across[2];             // of a hinge: axes about which B must not turn
    real a[JOINT_ROWS][MOTIONS], b[JOINT_ROWS][MOTIONS];
    real error[JOINT_ROWS];         // m, rad; of the limit: what is left
    bool is_upper;              // the limit is the greater of the two
    joint begun;                // the joint at the start of the substep, and which
    bool was_upper;             // limit, to begin it again
    bool rubs;                  // a contact presses a body that is joined to it
    bool is_free;               // its tree is joined to nothing immovable
    real pushed[JOINT_ROWS];    // the impulse before the bodies moved, and that of the
    real older[JOINT_ROWS];     // substep before
    real inverse[JOINT_ROWS][JOINT_ROWS];   // of K
    real give[JOINT_ROWS];      // 1/kg, 1/(kg m^2), compliance: what is added to K
    real fraction;              // of an error that a substep takes back
    real swing;                 // 1/(kg m), see linkage.c
    real hung;                  // rad/s, of a swing under a body's own weight
    real size;                  // m, the smaller radius of the two bodies
    real want[JOINT_ROWS];      // m/s, rad/s, the change that the impulses should give
    real since[JOINT_ROWS];     // N s, N m s, the impulses since the tree was last
                                // switched
    real before;                // of a drive, rad/s or m/s: its speed when the substep
    real speed;                 // begins, and now,
    real room[2];               // which must be between these, for its limits;
    real pull, slope;           // N s, kg, the spring gives pull - slope speed;
    real kick;                  // s, for which forces act;
    real hard, kept;            // the give of a row that holds, and N s, the impulse
                                // when the substep began
    real cone_want[2];          // rad/s, what swing and twist want, held or not
    real twist_size;            // of friction: the length of the axis of its second
    real turning[3];            // row; rad/s, the spin along its rows now;
    real firm[3], resisted[3];  // the same as hard and kept, of its rows
    real pace;                  // rad/s, of the fastest swing about it in the
                                // last frame
    int  next[2];               // in the lists of A's and B's joints; -1: none
} joint_rows;

// One of the two bodies.
typedef struct {
    const motion_basis *basis;  // zeros: it is immovable
    rigid_frame frame;
} joint_side;
//<

//> joint-declare
//>   The functions of a joint know two bodies and no world, so that a test can
//>   hold one joint in its hand.
// Fails, with a sentence, if numbers are not finite, a hinge's axis has no
// direction, a distance has least > most or less than 0, or the kind is none.
status joint_check(const joint_plan *plan);

// The joint of a checked plan, between bodies in these frames.
joint joint_make(const joint_plan *plan, const rigid_frame *a,
                 const rigid_frame *b);

// The frame of the world: coordinates in it are metres.
extern const rigid_frame JOINT_WORLD;

// pi, rounded up: no hinge is further than that from how it was made.
#define JOINT_HALF_TURN 3.141592653589794

// The angle of a hinge (rad): of B as seen from A, -pi to pi, 0 when it was made.
real joint_angle(const joint *j, const rigid_frame *a, const rigid_frame *b);

// The place of B along the free motion: that angle, how far a slider has moved (m), or
// how long a distance is (m); 0 for other joints.
real joint_where(const joint *j, const rigid_frame *a, const rigid_frame *b);

// Gives a ball joint a cone about an axis in the world, with the bodies in these
// frames.  The caller sets the fields cone, least and most.
void joint_set_cone(joint *j, const rigid_frame *a, const rigid_frame *b,
                    vec3 axis);

// How far the axis leans (rad, 0 to pi), and how far B has turned about it (rad, -pi to
// pi).
real joint_swing(const joint *j, const rigid_frame *a, const rigid_frame *b);
real joint_twist(const joint *j, const rigid_frame *a, const rigid_frame *b);

// The row of the twist turns about an axis of this length.
real joint_twist_length(const joint *j, const rigid_frame *a,
                        const rigid_frame *b);

// The direction of the free motion in the world: of a hinge or a slider its axis, of a
// distance that from A to B.
vec3 joint_direction(const joint *j, const rigid_frame *a, const rigid_frame *b);

// The two points in the world (m), of A and of B.
void joint_points(const joint *j, const rigid_frame *a, const rigid_frame *b,
                  vec3 *on_a, vec3 *on_b);

// The number of rows of a ball joint beside those of its point.
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

// Finds the rows and the errors, with the bodies as they stand.  The error of a drive
// is its place.
void joint_find_rows(joint_rows *r, const joint *j, const joint_side *a,
                     const joint_side *b);

// The errors alone, along the directions of r, with the bodies in other frames.
void joint_errors(const joint *j, const joint_rows *r, const rigid_frame *a,
                  const rigid_frame *b, real error[JOINT_ROWS]);
//<

//> joint-small-declare
//>   Each joint is a small linear system, and so is each body of a tree. Both
//>   are solved by an inverse, which serves several times.
// Inverts a symmetric, positive definite matrix of n <= JOINT_ROWS rows.  A row of
// zeros becomes zeros.
void small_invert(int n, real m[JOINT_ROWS][JOINT_ROWS]);

// Three rows are those of a ball joint, and row k of them moves the centre along axis k
// only: its numbers are that one, and the turns.
ALWAYS_INLINE int straight_first(int rows, int row)
{
    return rows == 3 ? row : 0;
}

ALWAYS_INLINE int straight_end(int rows, int row)
{
    return rows == 3 ? row + 1 : MOTION_TURN;
}

// K_kl of n rows: the speed along row l that a unit impulse along row k gives to bodies
// of these inverse masses (1/kg).
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

// Sets x to m x.
static inline void small_times(int n, real m[JOINT_ROWS][JOINT_ROWS], real *x)
{
    real y[JOINT_ROWS] = { 0 };
    for (int k = 0; k < n; k++)
        for (int i = 0; i < n; i++) y[i] += m[k][i] * x[k];
    for (int i = 0; i < n; i++) x[i] = y[i];
}
//<
