// shrink.c - shrink FILE.png...: the same pictures in fewer bytes.

#include "pack.h"

#include <stdio.h>

int main(int count, char **path)
{
    for (int i = 1; i < count; i++) {
        status done = picture_pack(path[i]);
        if (done.ok) continue;
        fprintf(stderr, "shrink: %s\n", done.why);
        return 1;
    }
    return 0;
}
