// show.h - a moving picture in the terminal, for programs that show what a reader
// has built (NN-name/show.c).

#ifndef TUMBLE_SHOW_H
#define TUMBLE_SHOW_H

#include <stdio.h>
#include <time.h>
#include <unistd.h>

enum { SHOW_ROWS = 24, SHOW_COLUMNS = 72 };

static char show_picture[SHOW_ROWS][SHOW_COLUMNS];

static inline void show_clear(void)
{
    for (int i = 0; i < SHOW_ROWS; i++)
        for (int j = 0; j < SHOW_COLUMNS; j++) show_picture[i][j] = ' ';
}

// Puts a letter at (x, y): the picture is 3 wide and 2 high, (0, 0) is its
// middle, y points up.  What lies outside is not drawn.
static inline void show_put(double x, double y, char letter)
{
    if (!(x > -1.5 && x < 1.5 && y > -1 && y < 1)) return;
    int column = (int)((x + 1.5) / 3 * SHOW_COLUMNS);
    int row = (int)((1 - y) / 2 * SHOW_ROWS);
    show_picture[row][column] = letter;
}

static inline void show_print(void)
{
    for (int i = 0; i < SHOW_ROWS; i++)
        printf("%.*s\n", SHOW_COLUMNS, show_picture[i]);
}

// In a terminal: the picture in the place of the last one, for a thirtieth of a
// second.
static inline void show_frame(void)
{
    if (!isatty(1)) return;
    printf("\033[H\033[2J");
    show_print();
    fflush(stdout);
    nanosleep(&(struct timespec){ 0, 33000000 }, NULL);
}

#endif
