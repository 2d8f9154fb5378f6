//> little_head 00a
#include <math.h>
#include <stdio.h>
//<
//> little_head_bool 03a
#include <stdbool.h>
//<

//> little_vectors 00a
// --- Vectors ----------------------------------------------------------------

typedef double real;

typedef struct { real x, y, z; } vec3;

static inline real real_max(real a, real b) { return a > b ? a : b; }

// a + s b: start at a, go s times b.
static inline vec3 vec3_add_scaled(vec3 a, real s, vec3 b)
{
    return (vec3){ a.x + s * b.x, a.y + s * b.y, a.z + s * b.z };
}

static inline real vec3_dot(vec3 a, vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
//<

//> little_vec3_scale 01a
static inline vec3 vec3_scale(real s, vec3 a)
{
    return (vec3){ s * a.x, s * a.y, s * a.z };
}

static inline real vec3_length(vec3 a) { return sqrt(vec3_dot(a, a)); }
//<

//> little_vec3_sub 01b
static vec3 vec3_sub(vec3 a, vec3 b) { return vec3_add_scaled(a, -1, b); }
//<

//> little_vec3_make 02a
static vec3 vec3_make(real x, real y, real z) { return (vec3){ x, y, z }; }

static inline real vec3_distance(vec3 a, vec3 b)
{
    return vec3_length(vec3_sub(a, b));
}
//<

//> little_vec3_cross 03a
static inline vec3 vec3_add(vec3 a, vec3 b) { return vec3_add_scaled(a, 1, b); }

static inline vec3 vec3_cross(vec3 a, vec3 b)
{
    return (vec3){ a.y * b.z - a.z * b.y,
                   a.z * b.x - a.x * b.z,
                   a.x * b.y - a.y * b.x };
}

// Numbers from -1 to 1, the same on every machine.
static inline real random_real(void)
{
    static unsigned long long seed = 1;
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (real)(seed >> 11) / 4503599627370496.0 - 1;
}

static inline vec3 random_vec3(real size)
{
    real x = random_real(), y = random_real(), z = random_real();
    return vec3_make(size * x, size * y, size * z);
}
//<

//> little_vec3_unit 05a
// The unit vector along a; the zero vector stays zero.
static inline vec3 vec3_unit(vec3 a)
{
    real length = vec3_length(a);
    return length > 0 ? vec3_scale(1 / length, a) : a;
}
//<

//> little_real_min 13e
static real real_min(real a, real b) { return a < b ? a : b; }
//<
