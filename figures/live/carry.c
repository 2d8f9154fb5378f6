// carry.c - what each contact of a pile pushes, phase by phase, beside what it has to
// carry: begun from nothing in each substep, or from the last one (chapter 13b).

#include "live.h"

#include "../13/13-tower.h"

enum { WARM };                                  // dial
enum { BOXES = 6, SUBSTEPS = 4, SLOW = 24, SEEN = 3 };  // frames of a phase; substeps
typedef enum { FALL, BEGIN, PUSH, MOVE, RELAX, PHASES } phase;
static const real GRAVITY = 9.81, LONGEST = 6;  // m/s^2; m, of a bar of all the weights

static tower pile;
static phase now;
static int frame, substep, slow_until, at;      // at: the contact that pushes

// The contacts from `first` on, so many.
static plain_solver part(int first, int n)
{
    return (plain_solver){ &pile.frame, pile.list + first, n, pile.gap + first, pile.velocity,
                           pile.moved, pile.body, pile.is_first + first,
                           pile.strikes + first };
}

static real push_of(int b) { return contact_load(&pile.contact[b]) / pile.frame.h; }
static real weight_on(int b) { return (BOXES - b) * GRAVITY; }

// One phase of plain_substep(); of the pushes, one contact.
static void run(void)
{
    plain_solver all = part(0, BOXES), one = part(at, 1);
    if (now == FALL) {
        tower_find(&pile);
        plain_begin(&all);
        for (int b = 0; b < BOXES; b++) pile.velocity[b].of[1] -= GRAVITY * pile.frame.h;
    } else if (now == BEGIN) {
        if (!live_choice(WARM)) tower_forget(&pile);
        plain_warm_start(&all);
    } else if (now == PUSH) plain_push(&one);
    else if (now == MOVE) plain_move(&all);
    else {
        plain_relax(&all);
        tower_put(&pile);
    }
}

static void tell(void)
{
    static const char *const words[PHASES] = { "of[1] += f->h * gravity.y", "c->impulse[k], c->normal", "plain_push(s)", "plain_move(s)", "plain_relax(s)" };
    live_light(words[now]);
    if (substep >= slow_until) live_say("Substep %d: the lowest contact pushes with %.1f N of %.1f N. The top has sunk by %.1f mm.", substep + 1, push_of(0), weight_on(0), 1000 * tower_sag(&pile));
    else if (now == FALL) live_say("Substep %d. Gravity makes every box faster, by %.1f cm/s.", substep + 1, 100 * GRAVITY * pile.frame.h);
    else if (now == BEGIN && live_choice(WARM)) live_say("Warm start: each contact gives again what it gave before, the lowest %.1f N.", push_of(0));
    else if (now == BEGIN) live_say("All is forgotten: every contact begins with 0 N.");
    else if (now == PUSH) live_say("Push: contact %d stops its boxes from closing, and gives %.1f N. It must carry %.1f N.", at + 1, push_of(at), weight_on(at));
    else if (now == MOVE) live_say("Move: the boxes go on by h times their speed. The top has sunk by %.2f mm.", 1000 * tower_sag(&pile));
    else live_say("Relax: the speed of parting is taken back.");
}

static void go_on(void)
{
    if (now == PUSH && at + 1 < BOXES) at++;
    else {
        now = (now + 1) % PHASES;
        at = 0;
        substep += now == FALL;
    }
    run();
}

static void begin(void)
{
    (void)tower_frame;          // here its phases are made one by one
    tower_free(&pile);
    tower_begin(&pile, SUBSTEPS, 1);
    for (int b = 0; b < BOXES; b++) tower_add(&pile, 1);
    frame = substep = at = 0;
    slow_until = SEEN;
    now = FALL;
    run();
    while (substep == 0) go_on();       // there is nothing yet to begin with
    tell();
}

// The first substeps are seen phase by phase; then each frame is one of them.
static void step(void)
{
    bool is_slow = substep < slow_until;
    if (is_slow && ++frame % (now == PUSH ? SLOW / 2 : SLOW)) return;
    do go_on(); while (!is_slow && now != RELAX);
    tell();
}

// Hits the top; what follows is seen slowly.
static void press(int button)
{
    (void)button;
    while (now != RELAX) go_on();
    for (int i = 0; i < FOUR; i++) pile.p[BOXES - 1][i].previous.y += 1.5 * pile.frame.h;
    slow_until = substep + 1 + SEEN;
    frame = 0;
}

// --- Drawing ----------------------------------------------------------------------
static void draw_box(int b)
{
    real y = pile.body[b].frame.center.y;
    vec3 side[4] = { { -1, y - 0.5, 0 }, { 0, y - 0.5, 0 }, { 0, y + 0.5, 0 }, { -1, y + 0.5, 0 } };
    live_area(LIVE_BLUE, side, 4);
    if (now == PUSH && at == b && substep < slow_until) live_dot(LIVE_ORANGE, vec3_make(-0.5, y - 0.5, 0), 7);
}

static void draw_bar(int b)
{
    real scale = LONGEST / weight_on(0), high = 0.26;
    real has = scale * push_of(b), wants = scale * weight_on(b), long_enough = real_min(has, 1.25 * LONGEST);
    vec3 bar[4] = { { 0.8, b, 0 }, { 0.8 + long_enough, b, 0 }, { 0.8 + long_enough, b + high, 0 }, { 0.8, b + high, 0 } };
    live_area(fabs(has - wants) < 0.05 * wants ? LIVE_GREEN : LIVE_RED, bar, 4);
    live_dashes(LIVE_INK, (vec3[]){ { 0.8 + wants, b - 0.12, 0 }, { 0.8 + wants, b + high + 0.12, 0 } }, 2);
}

static void draw(void)
{
    live_line(LIVE_RULE, (vec3[]){ { -2.2, 0, 0 }, { 0.7, 0, 0 } }, 2);
    for (int b = 0; b < BOXES; b++) {
        draw_box(b);
        draw_bar(b);
    }
    live_label(LIVE_QUIET, vec3_make(0.8, BOXES - 0.1, 0), "what each contact pushes");
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, (int[]){ (int)now, at, substep }, 3 * sizeof(int));
    for (int b = 0; b < BOXES; b++) h = live_hash(h, pile.contact[b].impulse, sizeof pile.contact[b].impulse);
    return live_hash(h, pile.p, BOXES * sizeof *pile.p);
}

const live_figure figure = {
    .name = "carry",
    .says = "A pile of six boxes from the side; beside each contact a bar as long as its push, and a mark at the weight above it",
    .code = "tests/contact/plain_solver.c plain_substep plain_warm_start",
    .pane = { { -2.4, -0.6, 11, 7 } },
    .dial = { [WARM] = { "contacts begin", NULL, 0, 1, 1, 0, "from nothing|from the last substep", true } },
    .button = { "Hit the top" },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .press = press,
};
