//> little_pieces 06a 09z
// --- Pieces -----------------------------------------------------------------

// A convex part of a body: all of it, or a triangle or link of what is soft.
typedef struct {
    int  body, count, vertex[12];
    real margin;        // m, it is kept that far from others
} piece;

// A range of pieces.
typedef struct { int first, count; } body;

enum { PIECES = 4000, BODIES = 300 };
static piece pieces[PIECES];
static int   piece_count;
static body  bodies[BODIES];
static int   body_count;

static void body_begin(void)
{
    if (body_count < BODIES) bodies[body_count++] = (body){ piece_count, 0 };
}

// Adds a piece to the last body.
static void piece_add(int count, const int *vertex, real margin)
{
    if (piece_count == PIECES || count > 12) return;
    piece *p = &pieces[piece_count++];
    *p = (piece){ .body = body_count - 1, .count = count, .margin = margin };
    for (int i = 0; i < count; i++) p->vertex[i] = vertex[i];
    bodies[body_count - 1].count++;
}
//<
