//> world-scene-head
// world_scene.h - the paper's three experiments.
//
// Paper: section 7, Figure 8.  Book: chapter 16.

#ifndef TUMBLE_WORLD_SCENE_H
#define TUMBLE_WORLD_SCENE_H

#include "measure.h"

typedef enum {
    SCENE_ROOM,         // icosahedra thrown into a cubic room
    SCENE_CLOTH_ON_CUBE,
    SCENE_CLOTH_ON_ROPE,
    SCENES
} scene_kind;

typedef struct {
    int  bodies;        // in the room, 1 to 20000
    int  cloth;         // particles along a side of the cloth, 2 to 512
    unsigned long long seed;
    const char *mesh;   // OBJ file thrown instead of icosahedra; NULL: none
} scene_options;

// A world and the shapes that its bodies are built to.  Not to be copied or
// moved: the bodies point to the shapes.
typedef struct {
    scene_kind kind;
    struct world world;
    shape plan[2];      // what moves; what it falls on
    real  size;         // m, side of the room or the cube, span of the rope
    real  body_radius;  // m, of a thrown body; what penetration is measured by
} scene;
//<

//> world-scene-declare
// As the command line spells it; "" if there is no such scene.
const char *scene_name(scene_kind kind);

// 50 bodies, a cloth of 40, seed 1, no mesh.
scene_options scene_options_default(void);

// world_options_default, with the substeps that this scene needs; a cloth of so
// many particles along a side.
world_options scene_world_options(scene_kind kind, int cloth);

// Builds the scene, ready to step:
// room: bodies of radius 0.5 m and 1 kg in a cube of side
//   cbrt(0.317 N / 0.15) m (more where their grid needs it: N = 2, 3, 9 to
//   12, 28 to 30), between y = 0 and that side, centred on x = z = 0, from a
//   jittered grid, in random orientation, velocity and spin uniform in +-5
//   (m/s, rad/s) a component.
// cloth-on-cube: n x n particles, 2 m x 2 m, 1 kg, turned by 20 degrees about
//   y, 0.1 m over a nailed cube of side 0.8 m that stands on y = 0 (0.7 of its
//   spacing, if that is more).
// cloth-on-rope: the same cloth, 0.1 m over the ends of a rope that hangs, at
//   rest, from two nails 2.6 m apart and 1.5 m high: 50 links, 3 m, 0.5 kg.
// Fails with a sentence (option out of range, mesh file, memory), leaving *s
// empty.
status scene_build(scene *s, scene_kind kind, scene_options what,
                   world_options how);
void   scene_free(scene *s);
//<

//> world-scene-end-of-header
#endif
//<
