//> world-scene-head
//>   The world is filled from chapter 09's description of a scene.
// world_scene.h - the engine's world from a scene, and the paper's experiments.
//
// Paper: section 7, Figure 8.  Book: chapter 18.

#ifndef TUMBLE_WORLD_SCENE_H
#define TUMBLE_WORLD_SCENE_H

#include "measure.h"
#include "scene.h"
//<

//> world-scene-declare
// Fills a new world with what the scene describes, ready to step.  Body k of
// the world is body k of the scene, whose shapes must outlive the world.
// Fails with a sentence (an option out of range, more planes than there is room
// for, memory), leaving *w empty.
status world_of_scene(world *w, const scene *s, world_options how);

// One of the paper's experiments, and a world that runs it.
typedef struct {
    scene_kind kind;
    scene scene;
    struct world world;
    real size;          // m, the scene's
    real body_radius;   // m, of a thrown body; what penetration is measured by
} world_scene;

// world_options_default, with the substeps that this scene needs; a cloth of so
// many particles along a side.
world_options world_scene_options(scene_kind kind, int cloth);

// Builds the scene, ready to step.  Fails as scene_build and world_of_scene do,
// leaving *s empty.
status world_scene_build(world_scene *s, scene_kind kind, scene_options what,
                         world_options how);
void   world_scene_free(world_scene *s);

#endif
//<
