//> plain-seam
#include "plain_seam.h"

// m: how far p is behind a side.
static real depth_behind(const plane *side, vec3 p)
{
    return side->offset - vec3_dot(side->normal, p);
}

bool plain_holds(const plain_piece *x, vec3 p)
{
    bool is_in = true;
    for (int k = 0; k < x->sides; k++)
        is_in = is_in && depth_behind(&x->side[k], p) > 0;
    return is_in;
}

// Where p would come out of piece b by its side k: does another piece lie there?
static bool is_hidden(const plain_piece *piece, int pieces, int b, int k, vec3 p,
                      real flush)
{
    const plane *side = &piece[b].side[k];
    vec3 out = vec3_add_scaled(p, depth_behind(side, p) + flush, side->normal);
    bool hidden = false;
    for (int c = 0; c < pieces; c++)
        hidden |= c != b && plain_holds(&piece[c], out);
    return hidden;
}

int plain_way_out(const plain_piece *piece, int pieces, int b, vec3 p, real flush)
{
    int best = -1;
    real least = HUGE_VAL;
    for (int k = 0; k < piece[b].sides; k++) {
        real depth = depth_behind(&piece[b].side[k], p);
        if (depth >= least || is_hidden(piece, pieces, b, k, p, flush)) continue;
        least = depth;
        best = k;
    }
    return best;
}
//<

//> plain-seam-box
//>   What the tests lay floors of.
plain_piece plain_box(vec3 center, vec3 half)
{
    plain_piece x = { .sides = PLAIN_SIDES };
    const vec3 axis[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    const real size[3] = { half.x, half.y, half.z };
    for (int k = 0; k < PLAIN_SIDES; k++) {
        vec3 n = vec3_scale(k % 2 ? -1 : 1, axis[k / 2]);
        x.side[k] = (plane){ n, vec3_dot(n, center) + size[k / 2] };
    }
    return x;
}
//<
