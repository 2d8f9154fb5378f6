# cut.awk - cuts one stage of the little program out of its source:
#   awk -v stage=07b -f cut.awk *.c > stage-07b.c
# Every line stands in a piece: //> name FROM UNTIL ... //<.  The piece is in the
# stages FROM to UNTIL; without UNTIL, in all from FROM on.  Several such pairs may
# follow each other.  Blank lines between pieces become one.  The title stands in
# stages.txt, beside the source.  -v marks=1 keeps the lines that open and close
# pieces.

NR == 1 { print_title() }
FNR == 1 { gap = 1 }
/^\/\/> / {
    if (name != "") fail("the piece " name " is not closed")
    name = $2
    if (name !~ /^little_[a-z0-9_]+$/ || NF < 3) fail("a piece wants a name, little_..., and a stage")
    if (name in seen) fail("two pieces are called " name)
    seen[name] = 1
    on = 0
    for (i = 3; i <= NF; i++) {
        if ($i !~ /^[0-9][0-9][a-z]$/) fail($i " is no stage")
        if (i > 3 && ($i < $(i - 1) || ($i == $(i - 1) && i % 2))) fail("the stages of " name " are out of order")
        if (i % 2) on += stage "" >= $i "" && (i == NF || stage "" <= $(i + 1) "")
    }
    if (marks && on) put($0)
    next
}
$0 == "//<" {
    if (name == "") fail("there is no piece to close")
    if (marks && on) put($0)
    name = ""
    next
}
name == "" { if ($0 != "") fail("this line stands in no piece"); gap = 1; next }
on { put($0) }
END { if (name != "" && !failed) fail("the piece " name " is not closed") }

# The gap is that between pieces.
function put(line) {
    if (gap) print ""
    gap = 0
    print line
}
function print_title(    list, line, part, title) {
    list = FILENAME
    if (!sub(/[^\/]*$/, "stages.txt", list)) list = "stages.txt"
    while ((getline line < list) > 0)
        if (split(line, part, / *\| */) > 1 && part[1] == stage) title = part[2]
    if (title == "") { FNR = 0; fail("stages.txt has no stage " stage) }
    print "// " title "."
    print "// The little program, stage " stage ".  C11: cc -std=c11 -O2 stage-" stage ".c -lm"
    print "// Units: metres, kilograms, seconds.  y is up."
    gap = 1
}
function fail(why) {
    printf "%s:%d: %s\n", FILENAME, FNR, why > "/dev/stderr"
    failed = 1
    exit 1
}
