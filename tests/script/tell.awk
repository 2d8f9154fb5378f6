# tell.awk - what a test program of Check printed, for a reader whose own module
# it judged: a sentence for each test that fails, where it stands, what it
# wanted, and what its comment says.
#
#   awk -v name=check_distance -v yours='my/distance.c' -f tell.awk SOURCE OUTPUT
#
# SOURCE is the test program's.

BEGIN { outcome = "^[^: ]+:[0-9]+:[FE]:[^:]*:[^:]*:[0-9]+: " }

# ---- the source: where each test begins, and the comments above and at its head

FILENAME ~ /\.c$/ && /^START_TEST\(/ {
    test = substr($0, 12)
    sub(/\).*/, "", test)
    place[test] = FNR
    comment[test] = above
    inside = 1
}
FILENAME ~ /\.c$/ && /^[ \t]*\/\/( |$)/ {
    text = $0
    sub(/^[ \t]*\/\/ ?/, "", text)
    if (inside) comment[test] = comment[test] "\n      " text
    else above = above "\n      " text
    next
}
FILENAME ~ /\.c$/ {
    if (!/^\{|^START_TEST/) { inside = 0; above = "" }
    next
}

# ---- what the program printed

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
    tell_comment()
    split($0, part, ":")
    match($0, outcome)
    said = substr($0, RLENGTH + 1)
    failing = part[5]
    start = failing in place ? place[failing] : part[2]
    print "\n  " failing "  (" part[1] ", line " start ")"
    print "  " sentence(said, part[2], start)
    next
}
{ print (all && $0 != "" ? "  " : "") $0 }
END { tell_comment() }

# That of the test which was told of last; a message may go on over several lines.
function tell_comment()
{
    if (failing != "" && comment[failing] != "")
        print "  The test's own comment:" comment[failing]
    failing = ""
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
