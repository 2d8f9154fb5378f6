// solution.c - compliance beside the inverse masses (Macklin 2016).

#include "spring.h"

#include <assert.h>

// With soft = compliance / dt^2, a further lambda, d, changes both sides of
//     length - rest = soft lambda:
//     length - rest - d (w_a + w_b) = soft (lambda + d).
static real further_lambda(real too_long, real weight, real soft, real lambda)
{
    real missing = too_long - soft * lambda;
    return missing / (weight + soft);
}

void spring_relax(spring s, particle *p, real dt, real *lambda)
{
    assert(s.a != s.b && s.compliance >= 0 && dt > 0);
    particle *a = &p[s.a], *b = &p[s.b];
    vec3 along = vec3_sub(b->position, a->position);
    real length = vec3_length(along);
    real weight = a->inverse_mass + b->inverse_mass;
    if (!(length > 0) || !(weight > 0)) return;

    real soft = s.compliance / (dt * dt);
    real d = further_lambda(length - s.rest_length, weight, soft, *lambda);
    vec3 n = vec3_scale(1 / length, along);
    a->position = vec3_add_scaled(a->position, d * a->inverse_mass, n);
    b->position = vec3_add_scaled(b->position, -d * b->inverse_mass, n);
    *lambda += d;
}
