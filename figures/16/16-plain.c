// 16-plain.c - a sheet is pressed through another one: what do the plain proof and
// the certificate leave of the moves, and how long do they take?
//
// index 0: how far the vertices are to go, in gaps between the sheets, then the
//          share of that way which is kept: by the plain form, by the certificate;
//          and the momentum that the two take away, as a share of all ways
// index 1: vertices, then ms for a frame: the plain form, a certificate that
//          knows nothing, one that has proved the frame before; how many times as
//          long the plain form takes as the last
// Columns are separated by spaces.

#include "certificate.h"
#include "clock.h"
#include "plain_proof.h"
#include "random.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { MOST_SIDE = 16, SHEETS = 2, MOST = SHEETS * MOST_SIDE * MOST_SIDE,
       ROUNDS = 40, FRAMES = 10 };
static const real SPACING = 0.1, GAP = 0.05, FRAME = 1.0 / 60, AGE = 1.0 / 240;

static unsigned long long seed = 1;
static shape cloth;
static body sheet[SHEETS];
static bool asleep[SHEETS];
static const int both[SHEETS] = { 0, 1 };
static particle at[MOST];
static vec3 from[MOST], to[MOST], now[MOST];
static int face[SHEETS * 2 * MOST_SIDE * MOST_SIDE][3];
static int side, each, all, faces;
static certificate proof;
static soft_frame frame;

static bool begin(int n)
{
    real wide = SPACING * (n - 1);
    side = n;
    each = n * n;
    all = SHEETS * each;
    if (!shape_cloth(&cloth, n, n, wide, wide, 1, 0.2).ok) return false;
    faces = SHEETS * cloth.mesh.faces;
    for (int k = 0; k < 3 * faces; k++)
        face[k / 3][k % 3] = cloth.face[k % (3 * cloth.mesh.faces)]
                           + k / (3 * cloth.mesh.faces) * each;
    for (int b = 0; b < SHEETS; b++)
        sheet[b] = (body){ .shape = &cloth, .first = b * each, .mass = 1,
                           .thickness = 0.55 * SPACING, .group = 1, .mask = 1 };
    frame = (soft_frame){ .body = sheet, .asleep = asleep, .bodies = SHEETS,
                          .soft = both, .softs = SHEETS, .particle = at,
                          .certified = true, .frame = FRAME, .whole = FRAME, .age = AGE, .h = AGE,
                          .stiff_substeps = 16 };
    proof = (certificate){ .particles = 0 };
    return certificate_grow(&proof, 0, all).ok;
}

static void end(void)
{
    certificate_free(&proof);
    shape_free(&cloth);
}

// The upper sheet is to come down by `far`, and every vertex to go half as far in
// any direction beside that.
static void ask(real far)
{
    for (int v = 0; v < all; v++) {
        vec3 down = vec3_make(0, v < each ? 0 : -far, 0);
        from[v] = cloth.at[v % each];
        from[v].y += v < each ? 0 : GAP;
        to[v] = vec3_add(vec3_add(from[v], down), random_vec3(&seed, far / 4));
    }
}

static void by_plain(void)
{
    plain_cloth c = { all, faces, (const int (*)[3])face, from, now };
    for (int v = 0; v < all; v++) now[v] = to[v];
    plain_proof(&c);
}

static void by_certificate(void)
{
    for (int v = 0; v < all; v++)
        at[v] = (particle){ from[v], from[v], each };
    certificate_begin(&proof, &frame, NULL);
    proof.since = FRAME;
    for (int v = 0; v < all; v++) {
        vec3 way = vec3_sub(to[v], from[v]);
        at[v].position = to[v];
        at[v].previous = vec3_add_scaled(to[v], -AGE / FRAME, way);
    }
    certificate_end(&proof, &frame, NULL, NULL);
    for (int v = 0; v < all; v++) now[v] = at[v].position;
}

// Of the way that was asked for.
static real kept(void)
{
    real lost = 0, whole = 0;
    for (int v = 0; v < all; v++) {
        lost += vec3_distance(now[v], to[v]);
        whole += vec3_distance(from[v], to[v]);
    }
    return 1 - lost / whole;
}

static real momentum_lost(void)
{
    vec3 lost = { 0, 0, 0 };
    real whole = 0;
    for (int v = 0; v < all; v++) {
        lost = vec3_add(lost, vec3_sub(now[v], to[v]));
        whole += vec3_distance(from[v], to[v]);
    }
    return vec3_length(lost) / whole;
}

static void print_kept(void)
{
    printf("# kept: gaps, plain form, certificate; lost: plain form, certificate\n");
    for (int k = -4; k <= 4; k++) {
        real gaps = pow(2, k), plain = 0, engine = 0, lost[2] = { 0, 0 };
        for (int i = 0; i < ROUNDS; i++) {
            if (!begin(6)) return;
            ask(gaps * GAP);
            by_plain();
            plain += kept() / ROUNDS;
            lost[0] += momentum_lost() / ROUNDS;
            by_certificate();
            engine += kept() / ROUNDS;
            lost[1] += momentum_lost() / ROUNDS;
            end();
        }
        printf("%.4g %.3g %.3g %.2g %.0g\n", gaps, plain, engine, lost[0], lost[1]);
    }
    printf("\n\n");
}

// ms.
static real time_of(void (*work)(void), int times)
{
    real start = clock_seconds();
    for (int k = 0; k < times; k++) work();
    return 1000 * (clock_seconds() - start) / times;
}

static void print_times(void)
{
    printf("# times: vertices, ms by the plain form, a certificate at first, after"
           " that, ratio\n");
    for (int n = 4; n <= MOST_SIDE; n += 3) {
        if (!begin(n)) return;
        ask(GAP / 100);
        real plain = time_of(by_plain, 1 + 10 / n);
        real first = time_of(by_certificate, 1);
        real again = time_of(by_certificate, FRAMES);
        printf("%d %.3g %.3g %.3g %.3g\n", all, plain, first, again, plain / again);
        end();
    }
}

int main(void)
{
    clock_print_head("a sheet is pressed through another of the same size, a gap of"
                     " 5 cm away", FLAGS);
    print_kept();
    print_times();
}
