// peers_ccd.c - libccd's answers about two icosahedra.
//
// Its settings are those of CCD_INIT, but for the cap of its loops, which is
// none there.  Support looks at all points, like ours for so few.  This file is
// compiled with -O2, like libccd itself: with -O3 gcc makes branches of the two
// selections in support, and libccd would be the slower for it.

#include "peers_others.h"

#include <ccd/ccd.h>
#include <ccd/quat.h>

static void support(const void *hull, const ccd_vec3_t *d, ccd_vec3_t *out)
{
    const solid *s = hull;
    vec3 along = { d->v[0], d->v[1], d->v[2] };
    real best = vec3_dot(along, s->at[0]);
    int furthest = 0;
    for (int i = 1; i < CORNERS; i++) {
        real here = vec3_dot(along, s->at[i]);
        furthest = here > best ? i : furthest;
        best = here > best ? here : best;
    }
    ccdVec3Set(out, s->at[furthest].x, s->at[furthest].y, s->at[furthest].z);
}

static void middle(const void *hull, ccd_vec3_t *out)
{
    const solid *s = hull;
    ccdVec3Set(out, s->middle.x, s->middle.y, s->middle.z);
}

static const ccd_t SETTINGS = {
    .first_dir = ccdFirstDirDefault, .support1 = support, .support2 = support,
    .center1 = middle, .center2 = middle, .max_iterations = 500,
    .epa_tolerance = 1e-4, .mpr_tolerance = 1e-4, .dist_tolerance = 1e-6,
};

int ccd_gjk_overlap(const solid *a, const solid *b)
{
    return ccdGJKIntersect(a, b, &SETTINGS);
}

int ccd_mpr_overlap(const solid *a, const solid *b)
{
    return ccdMPRIntersect(a, b, &SETTINGS);
}

int ccd_gjk_depth(const solid *a, const solid *b, real *depth, vec3 *along)
{
    ccd_vec3_t d, at;
    if (ccdGJKPenetration(a, b, &SETTINGS, depth, &d, &at) != 0) return 0;
    *along = vec3_make(d.v[0], d.v[1], d.v[2]);
    return 1;
}

int ccd_mpr_depth(const solid *a, const solid *b, real *depth, vec3 *along)
{
    ccd_vec3_t d, at;
    if (ccdMPRPenetration(a, b, &SETTINGS, depth, &d, &at) != 0) return 0;
    *along = vec3_make(d.v[0], d.v[1], d.v[2]);
    return 1;
}
