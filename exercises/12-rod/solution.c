// solution.c - five diagonals, down and up.

#include "rod.h"

// Each bend k, x_(k-1) - 2 x_k + x_(k+1), adds the products of 1, -2, 1.
void rod_band(band *m, const particle *p, real stiffness, real h)
{
    static const real part[3] = { 1, -2, 1 };
    real s = h * h * stiffness;
    for (int k = 0; k < m->n; k++) {
        int nailed = !(p[k].inverse_mass > 0);
        m->diagonal[k] = nailed ? 1 : 1 / p[k].inverse_mass;
        m->next[k] = m->far[k] = 0;
    }
    for (int k = 0; k + 2 < m->n; k++)
        for (int i = 0; i < 3; i++)
            for (int j = i; j < 3; j++) {
                if (!(p[k + i].inverse_mass > 0)) continue;
                if (!(p[k + j].inverse_mass > 0)) continue;
                real *row = j == i ? m->diagonal : j == i + 1 ? m->next
                                                              : m->far;
                row[k + i] += s * part[i] * part[j];
            }
}

// m = L D L^T.  Row k, when it is reached, has been freed of all before it;
// what it takes from rows k + 1 and k + 2 are its shares, and what it takes of
// their matrix is symmetric again.
int band_solve(band *m, vec3 *x)
{
    for (int k = 0; k < m->n; k++) {
        real pivot = m->diagonal[k];
        if (!(pivot > 0)) return 0;
        real one = k + 1 < m->n ? m->next[k] / pivot : 0;
        real two = k + 2 < m->n ? m->far[k] / pivot : 0;
        if (k + 1 < m->n) {
            m->diagonal[k + 1] -= one * m->next[k];
            x[k + 1] = vec3_add_scaled(x[k + 1], -one, x[k]);
        }
        if (k + 2 < m->n) {
            m->next[k + 1] -= one * m->far[k];
            m->diagonal[k + 2] -= two * m->far[k];
            x[k + 2] = vec3_add_scaled(x[k + 2], -two, x[k]);
        }
        x[k] = vec3_scale(1 / pivot, x[k]);
        m->next[k] = one;
        m->far[k] = two;
    }
    for (int k = m->n - 2; k >= 0; k--) {
        x[k] = vec3_add_scaled(x[k], -m->next[k], x[k + 1]);
        if (k + 2 < m->n) x[k] = vec3_add_scaled(x[k], -m->far[k], x[k + 2]);
    }
    return 1;
}

// x + d must fulfil M d = -h^2 B (x + d), the push of the force at the end:
//     (M + h^2 B) d = -h^2 B x.
// B x is the bends', handed on to their three particles by 1, -2, 1.
int rod_step(particle *p, int n, real stiffness, real h, band *m, vec3 *move)
{
    m->n = n;
    rod_band(m, p, stiffness, h);
    for (int k = 0; k < n; k++) move[k] = (vec3){ 0, 0, 0 };
    for (int k = 1; k + 1 < n; k++) {
        vec3 bend = vec3_add(p[k - 1].position, p[k + 1].position);
        bend = vec3_add_scaled(bend, -2, p[k].position);
        real s = h * h * stiffness;
        move[k - 1] = vec3_add_scaled(move[k - 1], -s, bend);
        move[k] = vec3_add_scaled(move[k], 2 * s, bend);
        move[k + 1] = vec3_add_scaled(move[k + 1], -s, bend);
    }
    for (int k = 0; k < n; k++)
        if (!(p[k].inverse_mass > 0)) move[k] = (vec3){ 0, 0, 0 };
    if (!band_solve(m, move)) return 0;
    for (int k = 0; k < n; k++)
        p[k].position = vec3_add(p[k].position, move[k]);
    return 1;
}
