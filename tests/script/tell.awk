# tell.awk - what a test program of Check printed, for a reader whose own module
# it judged: a sentence for each test that fails, where it stands, and what it
# wanted.
#
#   awk -v name=check_distance -v yours='my/distance.c' -f tell.awk OUTPUT

BEGIN { outcome = "^[^: ]+:[0-9]+:[FE]:[^:]*:[^:]*:[0-9]+: " }

/^Running suite/ { next }

# The count; what stands before it was printed by the tests and by what they test.
/^[0-9]+%: Checks: / {
    gsub(/,/, "")
    all = $3
    failed = $5 + $7
    if (!failed) print name ": all " all " tests pass with " yours "."
    else print name ": " all - failed " of " all " tests pass with " yours ".  " (failed == 1 ? "This does not:" : "These do not:")
    next
}

# file:line:F:case:name:run: message.  The line is where it was compared, often in
# a helper; where the test begins tells more.
all && $0 ~ outcome {
    split($0, part, ":")
    match($0, outcome)
    said = substr($0, RLENGTH + 1)
    start = begins(part[1], part[5], part[2])
    print "\n  " part[5] "  (" part[1] ", line " start ")"
    print "  " sentence(said, part[2], start)
    next
}
{ print (all && $0 != "" ? "  " : "") $0 }

function begins(file, test, otherwise,    row, n, place)
{
    while ((getline row < file) > 0) {
        n++
        if (index(row, "START_TEST(" test ")") == 1) place = n
    }
    close(file)
    return place ? place : otherwise
}

# Of a test that was stopped, Check knows the last comparison that held.
function sentence(said, line, start)
{
    if (!sub(/^\(after this point\) /, "", said)) return said
    if (said ~ /timeout/) said = "It does not end."
    else if (said ~ /^Early exit/) said = "It ends the whole program (exit)."
    else if (sub(/^Received signal [0-9]+ \(/, "It stops the program: ", said)) sub(/\)$/, ".", said)
    return said (line != start ? "  The last that held is in line " line "." : "")
}
