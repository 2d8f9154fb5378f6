// 03-count.c - enough sticks in the wrong places: two cells in a plane, 6
// particles, 7 to 9 sticks; their rank, and how they fold.
//
//   index 0 to 2: sticks of a frame: x1 y1 x2 y2
//   index 3 to 5: the same after a small fold, or as they were
//   index 6: frame, sticks, rank
#include "rigidity.h"

#include <stdio.h>

static const int STICK[3][9][2] = {
    { { 0, 1 }, { 1, 2 }, { 3, 4 }, { 4, 5 }, { 0, 3 }, { 1, 4 }, { 2, 5 } },
    { { 0, 1 }, { 1, 2 }, { 3, 4 }, { 4, 5 }, { 0, 3 }, { 1, 4 }, { 2, 5 },
      { 0, 4 }, { 1, 3 } },
    { { 0, 1 }, { 1, 2 }, { 3, 4 }, { 4, 5 }, { 0, 3 }, { 1, 4 }, { 2, 5 },
      { 0, 4 }, { 1, 5 } }
};
static const int COUNT[3] = { 7, 9, 9 };

// Both cells lean, the right one leans, nothing does.  To first order the
// lengths stay; cos makes them stay for good.
static vec3 folded(int frame, int v)
{
    real lean = 0.42, x = v % 3, y = v / 3;
    int leans = frame == 0 || (frame == 1 && v == 5) || (frame == 1 && v == 2);
    real upright = sqrt(1 - lean * lean);
    if (frame == 0) return vec3_make(x + y * lean, y * upright, 0);
    if (!leans) return vec3_make(x, y, 0);
    return vec3_make(1 + upright, y - lean, 0);
}

static void print_frame(int frame, int is_folded)
{
    printf("# frame %d%s: x1 y1 x2 y2\n", frame, is_folded ? ", folded" : "");
    for (int k = 0; k < COUNT[frame]; k++) {
        int a = STICK[frame][k][0], b = STICK[frame][k][1];
        vec3 p = vec3_make(a % 3, a / 3, 0), q = vec3_make(b % 3, b / 3, 0);
        if (is_folded) {
            p = folded(frame, a);
            q = folded(frame, b);
        }
        printf("%.4f %.4f %.4f %.4f\n", p.x, p.y, q.x, q.y);
    }
    printf("\n\n");
}

static int rank_of(int frame)
{
    vec3 at[6];
    stick list[9];
    for (int v = 0; v < 6; v++) at[v] = vec3_make(v % 3, v / 3, 0);
    for (int k = 0; k < COUNT[frame]; k++)
        list[k] = (stick){ STICK[frame][k][0], STICK[frame][k][1], 1, 1,
                           STICK_EXACT };
    shape s = { .particles = 6, .at = at, .sticks = COUNT[frame],
                .stick = list };
    return shape_rank(&s);
}

int main(void)
{
    for (int is_folded = 0; is_folded < 2; is_folded++)
        for (int frame = 0; frame < 3; frame++) print_frame(frame, is_folded);
    printf("# frame sticks rank\n");
    for (int frame = 0; frame < 3; frame++)
        printf("%d %d %d\n", frame, COUNT[frame], rank_of(frame));
    return 0;
}
