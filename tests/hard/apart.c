// apart.c - `drape` without chapter 12's rules: contacts move particles, and the
// strands are solved after them, as if nothing were touched; what comes after the
// strands is left out.  With AGAIN=1 in the environment contacts are met once more
// after the strands.
//
// The linker puts these in the place of the library's (--wrap).

#include "line.h"
#include "soft.h"

#include <stdlib.h>

line_result __real_lines_relax(const shape *s, particle *p, int fewest,
                               int sweeps, relax_options options,
                               line_hold *hold, real give, line_scratch *scratch);
line_result __wrap_lines_relax(const shape *s, particle *p, int fewest,
                               int sweeps, relax_options options,
                               line_hold *hold, real give, line_scratch *scratch);
void __real_soft_relax(soft_solver *s, const soft_frame *f);
void __wrap_soft_relax(soft_solver *s, const soft_frame *f);
void __wrap_soft_hold(soft_solver *s, const soft_frame *f);

line_result __wrap_lines_relax(const shape *s, particle *p, int fewest,
                               int sweeps, relax_options options,
                               line_hold *hold, real give, line_scratch *scratch)
{
    for (int i = 0; hold && i < s->particles; i++)
        hold[i] = (line_hold){ .state = LINE_FREE };
    return __real_lines_relax(s, p, fewest, sweeps, options, NULL, give, scratch);
}

void __wrap_soft_relax(soft_solver *s, const soft_frame *f)
{
    __real_soft_relax(s, f);
    if (getenv("AGAIN")) soft_separate(s, f);
}

void __wrap_soft_hold(soft_solver *s, const soft_frame *f)
{
    (void)s;
    (void)f;
}
