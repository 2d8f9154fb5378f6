//> experiments-head
//>   The paper's three experiments are made of what a scene knows. No module of the
//>   library needs them; they stand with the tests, beside the measure of poses.
// experiments.h - the scenes of the paper's three experiments.
//
// Paper: section 7, Figure 8.  Book: chapter 9.
// Units: metres, seconds, kilograms.  Frame: the world's, y up.

#ifndef TUMBLE_EXPERIMENTS_H
#define TUMBLE_EXPERIMENTS_H

#include "scene.h"
//<

//> experiments-declare
//>   One function builds them.
typedef enum {
    SCENE_ROOM,         // icosahedra thrown into a cubic room
    SCENE_CLOTH_ON_CUBE,
    SCENE_CLOTH_ON_ROPE,
    SCENES
} scene_kind;

typedef struct {
    int  bodies;        // in the room, 1 to 20000
    int  cloth;         // particles along a side of the cloth, 2 to 512
    real diagonal;      // stiffness of the cloth's diagonals, in (0, 1]; the
                        // paper's are as stiff as the rest, 1
    unsigned long long seed;
    shape *thrown;      // of radius 0.5 m, thrown instead of icosahedra and
                        // taken over, whatever happens; NULL: none
} scene_options;

// As the command line spells it; "" if there is no such scene.
const char *scene_name(scene_kind kind);

// 50 bodies, a cloth of 40, soft diagonals (0.2), seed 1, icosahedra.
scene_options scene_options_default(void);

// The radius of a body that is thrown into the room, m.
#define SCENE_BODY_RADIUS 0.5

// The paper's three experiments:
// room: bodies of radius 0.5 m and 1 kg in a cube of side
//   cbrt(0.317 N / 0.15) m (more where their grid needs it: N = 2, 3, 9 to
//   12, 28 to 30), between y = 0 and that side, centred on x = z = 0, from a
//   jittered grid, in random orientation, velocity and spin uniform in +-5
//   (m/s, rad/s) a component.
// cloth-on-cube: n x n particles, 2 m x 2 m, 1 kg, turned by 20 degrees about
//   y, 0.1 m over a static cube of side 0.8 m that stands on y = 0 (0.7 of its
//   spacing, if that is more).
// cloth-on-rope: the same cloth, 0.1 m over the ends of a rope that hangs, at
//   rest, from two pins 2.6 m apart and 1.5 m high: 50 links, 3 m, 0.5 kg.
// Fails with a sentence (option out of range, memory), leaving *s empty.
status scene_build(scene *s, scene_kind kind, scene_options what);

#endif
//<
