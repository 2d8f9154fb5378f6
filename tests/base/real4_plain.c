// real4_plain.c - real4.h without vector types, for check_real4.c.

#undef TUMBLE_PLAIN_REAL4
#define TUMBLE_PLAIN_REAL4
#define NAME real4_run_plain
#include "real4_forms.h"
