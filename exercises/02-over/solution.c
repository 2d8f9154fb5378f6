// solution.c - successive over-relaxation, and Jacobi's iteration.

#include "over.h"

void over_iterate(const stick *s, int n, particle *p, real omega)
{
    for (int i = 0; i < n; i++) {
        stick eager = s[i];
        eager.stiffness = omega;
        stick_relax(eager, p, relax_options_pbd());
    }
}

// Adds to the moves of both ends of s what would give it its length.
static void add_moves(stick s, const particle *p, vec3 *move)
{
    vec3 along = vec3_sub(p[s.b].position, p[s.a].position);
    real length = vec3_length(along);
    real wa = p[s.a].inverse_mass, wb = p[s.b].inverse_mass;
    if (!(length * (wa + wb) > 0)) return;
    real k = (length - s.rest_length) / (length * (wa + wb));
    move[s.a] = vec3_add_scaled(move[s.a], k * wa, along);
    move[s.b] = vec3_add_scaled(move[s.b], -k * wb, along);
}

void jacobi_iterate(const stick *s, int n, particle *p, int particles,
                  vec3 *move)
{
    for (int i = 0; i < particles; i++) move[i] = (vec3){ 0, 0, 0 };
    for (int i = 0; i < n; i++) add_moves(s[i], p, move);
    for (int i = 0; i < particles; i++)
        p[i].position = vec3_add(p[i].position, move[i]);
}

real over_best(int n)
{
    // With rho = cos t, sqrt(1 - rho^2) is sin t.
    const real pi = 3.14159265358979323846;
    return 2 / (1 + sin(pi / (n + 1)));
}
