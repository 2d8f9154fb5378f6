// bulk.c - what Python asks at once, since each call costs it a microsecond or ten.

#include "tumble.h"

#if defined(_WIN32)
#define SEEN __declspec(dllexport)
#else
#define SEEN __attribute__((visibility("default")))
#endif

// The poses of n bodies; of one that is gone, zeros.
SEEN void bulk_poses(const tumble_world *w, const tumble_body *b, int n, tumble_pose *out);
SEEN void bulk_poses(const tumble_world *w, const tumble_body *b, int n, tumble_pose *out)
{
    for (int i = 0; i < n; i++) out[i] = tumble_get_pose(w, b[i]);
}

// Their velocities and spins, in turn.
SEEN void bulk_velocities(const tumble_world *w, const tumble_body *b, int n, tumble_vec3 *out);
SEEN void bulk_velocities(const tumble_world *w, const tumble_body *b, int n, tumble_vec3 *out)
{
    for (int i = 0; i < n; i++) {
        out[2 * i] = tumble_velocity(w, b[i]);
        out[2 * i + 1] = tumble_spin(w, b[i]);
    }
}
