//> system-head
//>   The system uses all that Part I has built.
// system.h - the paper's system: particles, constraints, contacts, one step.
//
// Paper: sections 3 to 7.  Book: chapter 9.
// Units: metres, kilograms, seconds.  Frame: the world's.

#pragma once

#include "hit_face.h"
#include "ordering.h"
#include "response.h"
#include "scene.h"
#include "sphere_tree.h"
//<

//> system-options
typedef enum {
    LEAF_PARTICLES,     // spheres around particles, as thick as 0.55 of the
                        // shape's shortest stick
    LEAF_FACES          // the smallest around triangles or links (the paper)
} leaf_kind;

// How the constraints of a body are relaxed, and how often in a round, at most.
typedef struct {
    relax_options how;
    int iterations;
} relaxation;

// Every difference between the paper as printed and as mended is one of these.
typedef struct {
    real dt;            // s, a frame: one call of system_step
    int  substeps;      // a frame is this many steps of Verlet (paper: 1)
    int  rounds;        // contacts, then constraints, in each (paper: 1)
    vec3 gravity;       // m/s^2
    relaxation rigid, soft;     // of rigid and of deformable bodies
    bool ordered;       // a rigid body relaxes its constraints outwards from
                        // its particle that moved most (paper), or as listed
    leaf_kind leaves;   // of deformable bodies
    bool printed;       // contacts are parted by response_printed (paper) ...
    response_errata errata;     // ... with these misprints
    real friction;      // Coulomb's coefficient; nothing if `printed` (paper)
    real margin;        // m, rigid bodies are kept so far apart (paper: 0)
    real speculative;   // m, contacts of rigid bodies, and of planes, are found
                        // so far ahead (paper: 0)
    int  find_every;    // contacts serve so many substeps, at most to the end
                        // of the frame (paper: 1)
    int  lifetime;      // contacts of two rigid bodies serve for so many finds
                        // more (paper: 0)
} system_options;
//<

//> system-types
//>   A body is a range of the particles, and a shape that it may share with
//>   others. It has no position of its own: its particles are where they are.
//>   Beside the bodies stand what the queries carry on, two lists that grow,
//>   and a report.
// A body: a range of the particles.
typedef struct {
    const shape *shape;
    int   first;        // its particles: first .. first + shape->particles - 1
    bool  is_static;
    real  mass;         // kg; HUGE_VAL: static
    sphere_tree tree;   // layered if deformable, wrapped if rigid
    sphere bound;       // around all of it, when contacts were last found
    vec3 *axis;         // [leaves] deformable: the axis that last separated
                        // each leaf from a rigid body
    stick_lists lists;  // rigid, if `ordered`
} system_body;

// The simplex with which the last query of two rigid bodies ended.
typedef struct {
    int a, b;           // bodies, a < b; both 0: none yet
    simplex last;
} carried_simplex;

typedef struct {
    feature_contact contact;
    int     left;       // finds that it will outlive
} system_contact;

// What a step did.
typedef struct {
    int  contacts;      // at its end
    long tested;        // distance constraints looked at
    long relaxed;       // distance constraints that moved something
    int  unconverged;   // bodies whose last iteration met a strain, or an error
                        // of an angle, beyond the tolerance
    int  capped;        // queries of GJK or of the hit face that were cut off
                        // before they knew the answer to rounding
    int  dropped;       // contacts that found no memory: should be 0
    int  lost;          // bodies with NaN or beyond all bounds: should be 0
} system_report;

typedef struct {
    system_options options;
    system_report  report;
    particle_pool  pool;    // all particles, body after body
    vec3          *at;      // [particles] m, when contacts were last found
    vec3          *before;  // [particles] m, before they were separated
    int            bodies, planes;
    system_body   *body;
    plane         *plane;
    carried_simplex *carried;   // [carries] pair (a, b) at a * bodies + b,
    int            carries;     // modulo carries
    // Two lists that grow as they are written.
    int            contacts, contact_room, leaf_room;
    system_contact *contact;
    leaf_pair      *leaf;   // what a traversal of trees has found
} particle_system;
//<

//> system-declare
//>   Three functions are public: begin, step, end.
// The paper's system mended, the default; and as printed.
system_options system_options_mended(void);
system_options system_options_printed(void);

// Starts from a scene, whose shapes must outlive the system.  Body k of the
// system is body k of the scene; its particles are the vertices of its shape.
// Fails with a sentence (an option out of range, memory), leaving *s empty.
status system_init(particle_system *s, const scene *from,
                   system_options options);
void   system_free(particle_system *s);

// One frame.  Never fails: the report says what did not go well.  A body whose
// positions are lost touches nothing from then on, and harms no other.
system_report system_step(particle_system *s);
//<
