//> little_joint 17a
// --- Joints: a point of a is a point of b ------------------------------------

typedef struct {
    body *a, *b;
    vec3 local_a, local_b;      // m, in the axes of each
    vec3 ra, rb, gap;           // m, arms and from b's point to a's
//<
//> little_joint_impulse 17a 17a
    vec3 impulse;               // kg m/s
//<
//> little_joint_chain 17b
    bool follows;               // hangs on the b of the joint before it
    vec3 part;                  // of the solution, kg m/s
    mat3 factor;                // of the joint after it, in this one
//<
//> little_joint_hinge 17c
    bool is_hinge;              // the second joint of one
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
//> little_joint_follows 17b 17b
    j->follows = j > joints && j[-1].b == a;
//<
//> little_joint_follows_no_hinge 17c
    j->follows = j > joints && j[-1].b == a && !j[-1].is_hinge;
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
static mat3 arms_answer(const body *b, vec3 at, vec3 r)
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

// How joint j parts for an impulse of joint k, the same or the one before it.
static mat3 joint_answer(const joint *j, const joint *k)
{
    mat3 sum = mat3_diagonal(0);
    if (j->a == k->a)
        sum = mat3_add_scaled(sum, 1, arms_answer(j->a, j->ra, k->ra));
    if (j->b == k->b)
        sum = mat3_add_scaled(sum, 1, arms_answer(j->b, j->rb, k->rb));
    if (j->a == k->b)
        sum = mat3_add_scaled(sum, -1, arms_answer(j->a, j->ra, k->rb));
    return sum;
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
static void joints_warm(void)
{
    for (joint *j = joints; j < joints + joint_count; j++)
        bodies_push(j->a, j->ra, j->b, j->rb, j->impulse);
}

static void joints_hold(real rate)
{
    for (joint *j = joints; j < joints + joint_count; j++) {
        vec3 p = mat3_apply(mat3_inverse(joint_answer(j, j)),
                            joint_lack(j, rate));
        j->impulse = vec3_sub(j->impulse, p);
        bodies_push(j->a, j->ra, j->b, j->rb, vec3_scale(-1, p));
    }
}
//<

//> little_chain 17b
// Joints in a row, all at once: blocks of 3 x 3 on three diagonals.  Walks
// down: joint j's part is its solution, less `factor` times the next one's.
static void chain_eliminate(joint *first, int count, real rate)
{
    mat3 inverse = mat3_diagonal(0);
    for (joint *j = first; j < first + count; j++) {
        vec3 lack = joint_lack(j, rate);
        mat3 k = joint_answer(j, j);
//<
//> little_chain_spare 17c
        // Along a hinge both of its joints do the same, and k would be 0.
        k = mat3_add_scaled(k, 1e-9, mat3_diagonal(k.x.x + k.y.y + k.z.z));
//<
//> little_chain_down 17b
        if (j > first) {        // the joint before pulls here, too
            mat3 beside = joint_answer(j, j - 1);
            j[-1].factor = mat3_times(inverse, mat3_transpose(beside));
            lack = vec3_add(lack, mat3_apply(beside, j[-1].part));
            k = mat3_add_scaled(k, -1, mat3_times(beside, j[-1].factor));
        }
        inverse = mat3_inverse(k);
        j->part = mat3_apply(inverse, vec3_scale(-1, lack));
    }
}
//<

//> little_chain_hold 17b
static void chain_hold(joint *first, int count, real rate)
{
    chain_eliminate(first, count, rate);
    for (joint *j = first + count - 1; j >= first; j--) {
        if (j + 1 < first + count)
            j->part = vec3_sub(j->part, mat3_apply(j->factor, j[1].part));
        bodies_push(j->a, j->ra, j->b, j->rb, j->part);
    }
}
//<

//> little_hinge_add 17c
// Two joints, at both ends of an axis.
static void hinge_add(body *a, body *b, vec3 low, vec3 high)
{
    joint_add(a, b, low)->follows = false;
    joint *second = joint_add(a, b, high);
    second->follows = second->is_hinge = true;
}
//<

//> little_chains_hold 17b
static void joints_hold(real rate)
{
    for (int i = 0, n; i < joint_count; i += n) {
        for (n = 1; i + n < joint_count && joints[i + n].follows;) n++;
//<
//> little_chains_awake 18a
        if (!body_is_awake(joints[i].a) && !body_is_awake(joints[i].b))
            continue;
//<
//> little_chains_end 17b
        chain_hold(&joints[i], n, rate);
    }
}
//<
