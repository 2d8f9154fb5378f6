// live_main.c - a live figure on this machine: prints the hash of frame 60, as
// tests/bits/bits.txt keeps it; with --film, a film.

#include "live_page.h"

#include <stdio.h>
#include <string.h>

static unsigned long long hash_of_frame_60(void)
{
    page_draw();
    for (int k = 0; k < LIVE_FRAMES; k++) page_step();
    page_draw();
    return page_hash();
}

// How many choices has the first dial?  1, if it is a slider.
static int variants(void)
{
    int n = 1;
    for (const char *c = figure.dial[0].choices; c && *c; c++) n += *c == '|';
    return n;
}

static bool is_fickle(int k)
{
    return figure.fickle >> k & 1;
}

static unsigned long long hash_of_variant(int k)
{
    page_start();
    if (figure.dial[0].choices) page_turn(0, k);
    return hash_of_frame_60();
}

int main(int arguments, char **argument)
{
    if (arguments > 1 && strcmp(argument[1], "--film") == 0) {
        live_film();
        return 0;
    }
    int usual = figure.dial[0].choices ? (int)figure.dial[0].value : 0;
    printf("live %s %016llx\n", figure.name, hash_of_variant(usual));
    for (int k = 0; k < variants(); k++)
        if (k != usual && !is_fickle(k)) printf("live %s+%d %016llx\n", figure.name, k, hash_of_variant(k));
    return 0;
}
