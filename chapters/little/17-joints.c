//> little_joint 17a
// --- Joints: a point of a is a point of b ------------------------------------

typedef struct {
    body *a, *b;
    vec3 local_a, local_b;      // m, in the axes of each
    vec3 ra, rb, gap;           // m, arms and from b's point to a's
    vec3 impulse;               // kg m/s
//<
//> little_joint_chain 17b
    bool follows;               // hangs on the b of the joint before it
    vec3 part;                  // of the solution, kg m/s
    mat3 factor;                // of the joint after it, in this one
//<
//> little_joint_hinge 17c
    bool is_hinge;
    vec3 axis_a, axis_b, twist; // unit, in the axes of each; kg m^2/s
//<
//> little_joint_add 17a
} joint;

enum { JOINTS = 1000 };
static joint joints[JOINTS];
static int   joint_count;

static joint *joint_add(body *a, body *b, vec3 at)
{
    joint *j = &joints[joint_count < JOINTS ? joint_count++ : JOINTS - 1];
    *j = (joint){ .a = a, .b = b };
    j->local_a = mat3_back(a->axes, vec3_sub(at, a->position));
    j->local_b = mat3_back(b->axes, vec3_sub(at, b->position));
//<
//> little_joint_follows 17b
    j->follows = j > joints && j[-1].b == a && a->inverse_mass > 0;
//<
//> little_joint_added 17a
    return j;
}
//<

//> little_joint_pairs 17a
static bool bodies_joined(const body *a, const body *b)
{
    for (const joint *j = joints; j < joints + joint_count; j++)
        if ((j->a == a && j->b == b) || (j->a == b && j->b == a)) return true;
    return false;
}
//<

//> little_joint_gap 17a
static void joints_renew(void)
{
    for (joint *j = joints; j < joints + joint_count; j++) {
        j->ra = mat3_apply(j->a->axes, j->local_a);
        j->rb = mat3_apply(j->b->axes, j->local_b);
        j->gap = vec3_sub(vec3_add(j->a->position, j->ra),
                          vec3_add(j->b->position, j->rb));
    }
}
//<

//> little_joint_answer 17a
// How the end of the arm `at` moves for an impulse at the end of the arm r.
static mat3 body_answer_between(const body *b, vec3 at, vec3 r)
{
    mat3 k = mat3_diagonal(b->inverse_mass);
    vec3 *column[3] = { &k.x, &k.y, &k.z };
    for (int i = 0; i < 3; i++) {
        vec3 e = { i == 0, i == 1, i == 2 };
        vec3 turn = mat3_apply(b->inverse, vec3_cross(r, e));
        *column[i] = vec3_add(*column[i], vec3_cross(turn, at));
    }
    return k;
}

static mat3 joint_answer(const joint *j)
{
    return mat3_add_scaled(body_answer_between(j->a, j->ra, j->ra), 1,
                           body_answer_between(j->b, j->rb, j->rb));
}
//<

//> little_joint_lack 17a
// m/s, that the joint is to lose: what parts its points, and the gap by a rate.
static vec3 joint_lack(const joint *j, real rate)
{
    vec3 v = vec3_sub(body_velocity_at(j->a, j->ra),
                      body_velocity_at(j->b, j->rb));
    return vec3_add_scaled(v, rate, j->gap);
}

//<
//> little_joints_one_by_one 17a 17a
static void joints_hold(real rate)
{
    for (joint *j = joints; j < joints + joint_count; j++) {
        vec3 p = mat3_apply(mat3_inverse(joint_answer(j)), joint_lack(j, rate));
        j->impulse = vec3_sub(j->impulse, p);
        bodies_push(j->a, j->ra, j->b, j->rb, vec3_scale(-1, p));
    }
}
//<

//> little_chain 17b
// Joints in a row, all at once: blocks of 3 x 3 on three diagonals.  Walks
// down: joint j's part is its solution, but for `factor` times the next one's.
static void chain_eliminate(joint *first, int count, real rate)
{
    for (joint *j = first; j < first + count; j++) {
        mat3 k = joint_answer(j);
        vec3 lack = joint_lack(j, rate);
        if (j > first) {        // the joint before pulls at body a, too
            mat3 beside = body_answer_between(j->a, j->ra, j[-1].rb);
            lack = vec3_sub(lack, mat3_apply(beside, j[-1].part));
            k = mat3_add_scaled(k, -1, mat3_times(beside, j[-1].factor));
        }
        mat3 inverse = mat3_inverse(k);
        j->part = mat3_apply(inverse, vec3_scale(-1, lack));
        if (j + 1 == first + count) break;
        mat3 beside = body_answer_between(j->b, j->rb, j[1].ra);
        j->factor = mat3_times(inverse, beside);
    }
}
//<

//> little_chain_hold 17b
static void chain_hold(joint *first, int count, real rate)
{
    chain_eliminate(first, count, rate);
    for (joint *j = first + count - 1; j >= first; j--) {
        if (j + 1 < first + count)
            j->part = vec3_add(j->part, mat3_apply(j->factor, j[1].part));
        j->impulse = vec3_add(j->impulse, j->part);
    }
    for (joint *j = first; j < first + count; j++)
        bodies_push(j->a, j->ra, j->b, j->rb, j->part);
}
//<

//> little_hinge 17c
static void joint_twist(joint *j, vec3 twist)
{
    body *a = j->a, *b = j->b;
    a->spin = vec3_add(a->spin, mat3_apply(a->inverse, twist));
    b->spin = vec3_sub(b->spin, mat3_apply(b->inverse, twist));
}
//<

//> little_hinge_hold 17c
// Body b turns about the axis as seen from a, and in no other direction: along
// the axis the matrix is made so large that nothing happens.
static void hinge_hold(joint *j, real rate)
{
    vec3 axis = mat3_apply(j->a->axes, j->axis_a);
    vec3 off = vec3_cross(mat3_apply(j->b->axes, j->axis_b), axis);
    vec3 lack = vec3_sub(j->a->spin, j->b->spin);
    lack = vec3_across(vec3_add_scaled(lack, rate, off), axis);
    mat3 k = mat3_add_scaled(j->a->inverse, 1, j->b->inverse);
    k = mat3_add_outer(k, 1e6 * (k.x.x + k.y.y + k.z.z), axis);
    vec3 twist = vec3_scale(-1, mat3_apply(mat3_inverse(k), lack));
    j->twist = vec3_add(j->twist, twist);
    joint_twist(j, twist);
}
//<

//> little_hinge_make 17c
static void joint_make_hinge(joint *j, vec3 axis)
{
    j->is_hinge = true;
    j->axis_a = mat3_back(j->a->axes, axis);
    j->axis_b = mat3_back(j->b->axes, axis);
}
//<

//> little_chains_hold 17b
static void joints_hold(real rate)
{
    for (int i = 0, n; i < joint_count; i += n) {
        for (n = 1; i + n < joint_count && joints[i + n].follows;) n++;
//<
//> little_chains_awake 18a
        if (!joints[i].a->awake && !joints[i].b->awake) continue;
//<
//> little_chains_hinges 17c
        for (int k = i; k < i + n; k++)
            if (joints[k].is_hinge) hinge_hold(&joints[k], rate);
//<
//> little_chains_end 17b
        chain_hold(&joints[i], n, rate);
    }
}
//<

//> little_joints_warm 17a
static void joints_warm(void)
{
    for (joint *j = joints; j < joints + joint_count; j++) {
//<
//> little_joints_awake 18a
        if (!j->a->awake && !j->b->awake) continue;
//<
//> little_joints_warm_push 17a
        bodies_push(j->a, j->ra, j->b, j->rb, j->impulse);
//<
//> little_joints_warm_twist 17c
        joint_twist(j, j->twist);
//<
//> little_joints_warm_end 17a
    }
}
//<
