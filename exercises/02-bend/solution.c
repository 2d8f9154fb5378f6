// solution.c - a gap that a fixed weighted sum of four positions measures.

#include "hinge.h"

#include <assert.h>

// Lines whose directions differ by less than this (the sine squared) have no
// crossing that rounding would not move.
static const real PARALLEL = 1e-12;

// The points b + u e and d + v f, with e = a - b and f = c - d, are nearest
// where the line between them is perpendicular to both: with r = b - d,
//     (r + u e - v f) . e = 0,   (r + u e - v f) . f = 0.
// A rope has a = b, e = 0: then u = 1 will do, and v alone is sought.
status bend_make(bend *b, const int at[4], const particle *p, real stiffness)
{
    assert(at[2] != at[3] && stiffness > 0);
    vec3 e = vec3_sub(p[at[0]].position, p[at[1]].position);
    vec3 f = vec3_sub(p[at[2]].position, p[at[3]].position);
    vec3 r = vec3_sub(p[at[1]].position, p[at[3]].position);
    if (!vec3_is_finite(e) || !vec3_is_finite(f) || !vec3_is_finite(r))
        return status_fail("a particle of the bend (%d, %d, %d, %d) has a "
                           "position that is not finite",
                           at[0], at[1], at[2], at[3]);

    real ee = vec3_dot(e, e), ff = vec3_dot(f, f), ef = vec3_dot(e, f);
    real re = vec3_dot(r, e), rf = vec3_dot(r, f);
    real area = ee * ff - ef * ef;
    bool rope = at[0] == at[1];
    if (!(ff > 0) || (!rope && !(area > PARALLEL * ee * ff)))
        return status_fail("the lines %d-%d and %d-%d of the bend are "
                           "parallel and do not cross", at[0], at[1], at[2],
                           at[3]);

    real u = rope ? 1 : (ef * rf - re * ff) / area;
    real v = (rf + u * ef) / ff;
    *b = (bend){ { at[0], at[1], at[2], at[3] },
                 { u, 1 - u, -v, -(1 - v) }, stiffness };
    return status_ok();
}

// gap = sum weight_i x_i.  Moving each x_i by -k w_i weight_i gap takes
// k sum w_i weight_i^2 of the gap away: all of it for k = 1 / that sum.
// The moves keep the centre of mass, because the weights add up to nothing, and
// the angular momentum, because its change is -k gap x gap = 0.
stick_result bend_relax(bend b, particle *p)
{
    vec3 gap = { 0, 0, 0 };
    real sum = 0;
    for (int i = 0; i < 4; i++) {
        const particle *q = &p[b.at[i]];
        gap = vec3_add_scaled(gap, b.weight[i], q->position);
        sum += q->inverse_mass * b.weight[i] * b.weight[i];
    }
    real length = vec3_length(gap);
    if (!(length > 0)) return (stick_result){ length == 0 ? 0 : HUGE_VAL, 0 };
    if (!(sum > 0)) return (stick_result){ length, 0 };

    real k = b.stiffness / sum;
    for (int i = 0; i < 4; i++) {
        particle *q = &p[b.at[i]];
        real part = k * q->inverse_mass * b.weight[i];
        q->position = vec3_add_scaled(q->position, -part, gap);
    }
    return (stick_result){ length, 1 };
}
