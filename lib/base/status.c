//> status-ok
#include "status.h"

#include <stdarg.h>
#include <stdio.h>

status status_ok(void)
{
    return (status){ .ok = true };
}

status status_fail(const char *format, ...)
{
    status s = { .ok = false };
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(s.why, sizeof s.why, format, arguments);
    va_end(arguments);
    return s;
}

status status_out_of_memory(void)
{
    return status_fail("out of memory");
}
//<
