// solution.c - Thomas's walk down a chain of bodies, and up again.

#include "links.h"

block answer_between(const limb *b, vec3 at, vec3 r)
{
    block k;
    vec3 *column[3] = { &k.x, &k.y, &k.z };
    for (int i = 0; i < 3; i++) {
        vec3 e = { i == 0, i == 1, i == 2 };
        vec3 turn = block_apply(b->inverse, vec3_cross(r, e));
        *column[i] = vec3_add_scaled(vec3_cross(turn, at), b->inverse_mass, e);
    }
    return k;
}

// m/s, the point of body k + 1 as seen from that of body k.
static vec3 lack_of(const limb *b, const ball_joint *j)
{
    vec3 low = vec3_add(b[1].velocity, vec3_cross(b[1].spin, j->below));
    vec3 high = vec3_add(b[0].velocity, vec3_cross(b[0].spin, j->above));
    return vec3_sub(low, high);
}

static void give(limb *b, vec3 arm, vec3 impulse)
{
    b->velocity = vec3_add_scaled(b->velocity, b->inverse_mass, impulse);
    b->spin = vec3_add(b->spin, block_apply(b->inverse, vec3_cross(arm, impulse)));
}

// Row k, freed of part k - 1, is a row for the parts k and k + 1 alone.
void chain_hold(limb *body, ball_joint *joint, int joints)
{
    for (int k = 0; k < joints; k++) {
        ball_joint *j = &joint[k];
        vec3 known = vec3_scale(-1, lack_of(&body[k], j));
        block own = block_add_scaled(answer_between(&body[k], j->above, j->above), 1,
                                     answer_between(&body[k + 1], j->below, j->below));
        if (k > 0) {
            block beside = answer_between(&body[k], j->above, j[-1].below);
            known = vec3_add(known, block_apply(beside, j[-1].part));
            own = block_add_scaled(own, -1, block_times(beside, j[-1].factor));
        }
        block inverse = block_inverse(own);
        j->part = block_apply(inverse, known);
        if (k + 1 == joints) break;
        block next = answer_between(&body[k + 1], j->below, j[1].above);
        j->factor = block_times(inverse, next);
    }
    for (int k = joints - 2; k >= 0; k--)
        joint[k].part = vec3_add(joint[k].part, block_apply(joint[k].factor, joint[k + 1].part));
    for (int k = 0; k < joints; k++) {
        give(&body[k], joint[k].above, vec3_scale(-1, joint[k].part));
        give(&body[k + 1], joint[k].below, joint[k].part);
    }
}
