//> face-turn
#include "inside.h"

#include <math.h>

// Sine and cosine by their series: so that all machines have the same bits.
// |x| <= pi / 4.
static void series(real x, real *sine, real *cosine)
{
    real term = 1, square = x * x;
    *cosine = 1;
    *sine = x;
    for (int k = 1; k <= 9; k++) {
        term *= -square / ((2 * k - 1) * (2 * k));
        *cosine += term;
        *sine += term * x / (2 * k + 1);
    }
}

// Of the double of an angle: cos 2x = c^2 - s^2, sin 2x = 2 s c.
static void twice(real *sine, real *cosine)
{
    real s = *sine, c = *cosine;
    *cosine = c * c - s * s;
    *sine = 2 * s * c;
}

tumble_quat tumble_quat_turn(tumble_vec3 axis, double by)
{
    const real whole = 6.28318530717958647692;
    tumble_quat none = { 0, 0, 0, 1 };
    real most = real_max(fabs(axis.x), real_max(fabs(axis.y), fabs(axis.z)));
    // Scaled, so that its square is neither too small nor too large.
    vec3 d = { axis.x / most, axis.y / most, axis.z / most };
    real length = vec3_length(d), s, c;
    if (!(length > 0 && length < HUGE_VAL && fabs(by) < 1e9)) return none;
    real half = (by - whole * nearbyint(by / whole)) / 2;
    series(half / 2, &s, &c);
    twice(&s, &c);
    d = vec3_scale(s / length, d);
    return (tumble_quat){ d.x, d.y, d.z, c };
}
//<

//> face-matrix
//>   From the quaternion comes the matrix that graphics libraries load, and
//>   from a matrix the engine's answer comes back.
void tumble_quat_matrix(tumble_quat q, double m[9])
{
    real square = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
    real s = square > 0 ? 2 / square : 0;   // all zero: no rotation
    real x = s * q.x, y = s * q.y, z = s * q.z;
    m[0] = 1 - y * q.y - z * q.z;
    m[1] = x * q.y - z * q.w;
    m[2] = x * q.z + y * q.w;
    m[3] = x * q.y + z * q.w;
    m[4] = 1 - x * q.x - z * q.z;
    m[5] = y * q.z - x * q.w;
    m[6] = x * q.z - y * q.w;
    m[7] = y * q.z + x * q.w;
    m[8] = 1 - x * q.x - y * q.y;
}

// The quaternion of a matrix whose columns are x, y and z: of 4 x^2, 4 y^2,
// 4 z^2 and 4 w^2 the largest is 1 at least, and loses nothing (Shepperd 1978).
tumble_quat inside_quat(vec3 x, vec3 y, vec3 z)
{
    real four[4] = { 1 + x.x - y.y - z.z, 1 - x.x + y.y - z.z,
                     1 - x.x - y.y + z.z, 1 + x.x + y.y + z.z };
    int most = 3;
    for (int k = 0; k < 3; k++)
        if (four[k] > four[most]) most = k;
    real root = sqrt(four[most]), q[4];
    const real product[4][4] = {        // of each two, four times
        { 0, x.y + y.x, z.x + x.z, y.z - z.y },
        { x.y + y.x, 0, y.z + z.y, z.x - x.z },
        { z.x + x.z, y.z + z.y, 0, x.y - y.x },
        { y.z - z.y, z.x - x.z, x.y - y.x, 0 } };
    for (int k = 0; k < 4; k++)
        q[k] = k == most ? root / 2 : 0.5 / root * product[most][k];
    return (tumble_quat){ q[0], q[1], q[2], q[3] };
}

tumble_quat tumble_quat_from_matrix(const double m[9])
{
    return inside_quat((vec3){ m[0], m[3], m[6] }, (vec3){ m[1], m[4], m[7] },
                       (vec3){ m[2], m[5], m[8] });
}
//<

//> face-turn-helpers
//>   A pose takes points from the frame of a body to that of the world, and back.
//>   A program asks for that again and again.
tumble_vec3 tumble_quat_rotate(tumble_quat q, tumble_vec3 v)
{
    real m[9];
    tumble_quat_matrix(q, m);
    return tumble_v(m[0] * v.x + m[1] * v.y + m[2] * v.z,
                    m[3] * v.x + m[4] * v.y + m[5] * v.z,
                    m[6] * v.x + m[7] * v.y + m[8] * v.z);
}

tumble_vec3 tumble_pose_to_world(tumble_pose at, tumble_vec3 local)
{
    vec3 r = from_user(tumble_quat_rotate(at.rotation, local));
    return to_user(vec3_add(from_user(at.position), r));
}

tumble_vec3 tumble_pose_to_local(tumble_pose at, tumble_vec3 point)
{
    tumble_quat q = at.rotation, back = { -q.x, -q.y, -q.z, q.w };
    vec3 r = vec3_sub(from_user(point), from_user(at.position));
    return tumble_quat_rotate(back, to_user(r));
}

const char *tumble_version(void)
{
    return TUMBLE_VERSION;
}

int tumble_version_number(void)
{
    return TUMBLE_VERSION_NUMBER;
}
//<
