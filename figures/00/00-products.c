// 00-products.c - the dot product as a length along b, the cross product as an
// area: the points that 00-products.gp draws.

#include "vec3.h"

#include <stdio.h>

static void print(const char *name, vec3 v)
{
    printf("\"%s\" %.4f %.4f %.4f\n", name, v.x, v.y, v.z);
}

int main(void)
{
    vec3 a = vec3_make(1.6, 1.5, 0), b = vec3_make(2.6, 0.4, 0);
    vec3 along = vec3_scale(vec3_dot(a, b) / vec3_dot(b, b), b);
    printf("# a and b, a's part along b and its part across b\n"
           "# name x y z\n");
    print("a", a);
    print("b", b);
    print("along", along);
    print("across", vec3_sub(a, along));

    vec3 u = vec3_make(1.5, 0.3, 0), v = vec3_make(0.5, 1.2, 0);
    printf("\n\n# a, b and a x b\n");
    print("a", u);
    print("b", v);
    print("cross", vec3_cross(u, v));
    printf("# a . b of the left picture %.3f; |b| times the length along b "
           "%.3f\n", vec3_dot(a, b), vec3_length(b) * vec3_length(along));
    return 0;
}
