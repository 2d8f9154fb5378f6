// hard_drape_watch.c - what a row of drape_table must not exceed, measured.

#include "hard.h"
#include "hard_drape_set.h"
#include "hard_springs.h"

#include <math.h>

// Cubes that fall on a cotton stretch it: it does not have to hold its length
// then.  The last one strikes after 0.7 s.  N/m: a diagonal that takes back a
// fifth of its error in a substep, as those of this cloth do, 660 a second.
static real must_stretch(const drape *d, const world *w)
{
    static const real SHEAR = 34, SECONDS = 1.2;
    return drape_is_struck(d) ? springs_strain(w, SHEAR, SECONDS) : 0;
}

bool drape_watch(const drape *d, world *w, verdict *v)
{
    verdict all = *v;
    real must = must_stretch(d, w);
    v->strain = 0;
    bool is_ready = judge_watch(w, drape_plan(d), v);
    v->off = hard_worse(all.off, fabs(v->strain - must));
    v->must = hard_worse(all.must, must);
    v->strain = hard_worse(all.strain, v->strain);
    return is_ready;
}
