# wrong.awk - makes wrong answers out of a right one.
#
#   awk -f wrong.awk EXERCISE/wrong                      number, test, sentence: one line each
#   awk -v want=2 -f wrong.awk EXERCISE/wrong lib/m.c    lib/m.c with the second mistake
#
# The file `wrong` holds, for each mistake,
#
#   wrong  a sentence that says what is wrong
#   test   the test that must reject it
#   -      lines of the solution, as they stand there, but for the indentation
#   +      the lines that take their place
#
# The lines to replace must stand in the solution once, one below the other.
# There may be several such pairs.  Lines that begin with # say nothing.

function fail(why)
{
    print why > "/dev/stderr"
    failed = 1
    exit 1
}

function trim(s)
{
    gsub(/^[ \t]+|[ \t]+$/, "", s)
    return s
}

# Are the lines to be replaced by change c those from `at` on?
function stands_at(c, at,    i)
{
    for (i = 1; i <= olds[c]; i++)
        if (trim(source[at + i - 1]) != old[c, i]) return 0
    return 1
}

# ---- the list of mistakes

FNR == NR && /^wrong/ { n++; told[n] = trim(substr($0, 6)); state = "wrong"; next }
FNR == NR && /^test/  { test[n] = trim(substr($0, 5)); next }
FNR == NR && /^-/ {
    if (n == want) {
        if (state != "old") changes++
        old[changes, ++olds[changes]] = trim(substr($0, 2))
        state = "old"
    }
    next
}
FNR == NR && /^\+/ {
    if (n == want) { new[changes] = new[changes] substr($0, 2) "\n"; state = "new" }
    next
}
FNR == NR && /^(#.*)?$/ { next }
FNR == NR { fail(FILENAME ":" FNR ": a line begins with wrong, test, -, + or #") }

# ---- the solution

{ source[FNR] = $0; lines = FNR; name = FILENAME }

END {
    if (failed) exit 1
    if (!want) {
        for (i = 1; i <= n; i++) print i, (test[i] == "" ? "-" : test[i]), told[i]
        exit 0
    }
    for (c = 1; c <= changes; c++) {
        times = 0
        for (at = 1; at <= lines; at++) if (stands_at(c, at)) { times++; place[c] = at }
        if (times != 1) fail(name ": wrong " want " (" told[want] ") changes lines that stand there " times " times, beginning with: " old[c, 1])
    }
    if (!changes) fail(name ": wrong " want " changes nothing")
    for (at = 1; at <= lines; at++) {
        for (c = 1; c <= changes; c++) if (place[c] == at) {
            printf "%s", new[c]
            skip = olds[c]
        }
        if (skip > 0) skip--
        else print source[at]
    }
}
