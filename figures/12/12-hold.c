// 12-hold.c - how far a pull of the strands moves a particle that is free, one
// that slides on a surface, and one that sticks to it.
//
// Pulls of 1 kg m to all sides, a particle of 1 kg; the surface is y = 0, and
// its normal points up.
// pull_x pull_y free_x free_y slides_x slides_y sticks_x sticks_y   (m)

#include "plain_strand.h"

#include <stdio.h>

int main(void)
{
    // The pulls turn by a twelfth of a right angle at a time.
    const real cosine = 0.99144486137381038, sine = 0.13052619222005157;
    plain_particle free = { .weight = 1 }, slides = free, sticks = free;
    slides.hold.y = sqrt(0.7);
    sticks.weight = 0.3;
    vec3 pull = { 1, 0, 0 };
    printf("# 12-hold: moves of a particle under a pull of 1 kg m\n"
           "# compiler %s, flags %s\n", __VERSION__, FLAGS);
    for (int k = 0; k <= 48; k++) {
        vec3 a = plain_move(&free, pull), b = plain_move(&slides, pull);
        vec3 c = plain_move(&sticks, pull);
        printf("%.6f %.6f %.6f %.6f %.6f %.6f %.6f %.6f\n", pull.x, pull.y,
               a.x, a.y, b.x, b.y, c.x, c.y);
        pull = (vec3){ cosine * pull.x - sine * pull.y,
                       sine * pull.x + cosine * pull.y, 0 };
    }
    return 0;
}
