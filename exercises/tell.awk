# tell.awk - says in plain sentences how a reader's code did.
#
#   awk -v name=01/step -v mine=mine.c -v early='t u' -f tell.awk TESTS SAID TAP
#
# The tests named early are told of before the others.
# TESTS is the source of the test program, for the comments above its tests; SAID
# is what the judge, the sanitizers and the reader's own code printed; TAP is
# Check's list of outcomes.  Exit: 0 all tests passed, 1 some did not, 2 none ran.

FNR == 1 { file++ }

# ---- the source: where each test stands, and what its comment says

file == 1 && /^START_TEST\(/ {
    test = substr($0, 12)
    sub(/\).*/, "", test)
    line_of[test] = FNR
    comment_of[test] = above
    inside = 1
}
file == 1 && /^[ \t]*\/\/( |$)/ {
    text = $0
    sub(/^[ \t]*\/\/ ?/, "", text)
    if (inside) comment_of[test] = comment_of[test] (comment_of[test] == "" ? "" : "\n") text
    else above = above (above == "" ? "" : "\n") text
    next
}
file == 1 && !/^\{|^START_TEST/ { inside = 0; above = "" }
file == 1 { next }

# ---- what was said while each test ran

# (A test that runs in a loop begins and ends several times.)

file == 2 && $1 == "judge:" && $2 == "begin" {
    now = $3
    if (!(now in begun)) begun[now] = ++ran
    unended[now]++
    report = ""
    next
}
file == 2 && $1 == "judge:" && $2 == "end" {
    unended[now]--
    if (now in own && $4 > most(now)) fault[now] = "is too slow (" short($4) " seconds of computing, where the book's own answer takes " short(own[now]) ", and " short(most(now)) " are allowed)"
    next
}
file == 2 && $1 == "judge:" && $2 == "endless" {
    report = "endless"
    fault[now] = "does not end (stopped after " short($3) " seconds of computing" (now in own ? ", where the book's own answer takes " short(own[now]) : "") ")"
    next
}
file == 2 && now == "" { next }

file == 2 && /ERROR: (Address|Leak)Sanitizer:/ { report = "memory"; kind = $3 }
# A stack that is written over may end the report here.
file == 2 && report == "memory" && /^(READ|WRITE) of size/ {
    access = $1 == "READ" ? "reads" : "writes"
    fault[now] = memory_fault(kind, "")
}
file == 2 && /LeakSanitizer has encountered a fatal error/ { fault[now] = "could not be searched for leaks on this machine (ASAN_OPTIONS=detect_leaks=0 does without)" }
file == 2 && /^SUMMARY: AddressSanitizer:/ { fault[now] = memory_fault($3, $0) }
file == 2 && /: runtime error: / && report == "" {
    report = "undefined"
    fault[now] = undefined_fault(substr($0, index($0, "runtime error: ") + 15))
}
file == 2 && /: Assertion .* failed\.$/ && report == "" {
    report = "assert"
    fault[now] = assert_fault($0)
}
file == 2 {
    if (report == "endless") find_loop()
    else if (report != "" && !(now in place)) find_place()
    if (report == "" && $0 != "" && $0 !~ /DEADLYSIGNAL|^=====/ && ++printed_lines[now] <= 20) printed[now] = printed[now] "      " $0 "\n"
    next
}

# ---- Check's outcomes; a message may go on over several lines

/^(not )?ok [0-9]+ - / {
    passed = $1 == "ok"
    text = $0
    sub(/^[^:]*:[^:]*:/, "", text)
    test = text
    sub(/:.*/, "", test)
    # Of several runs of a test, the first that did not pass is told of.
    known = test in outcome && !outcome[test]
    if (known) next
    outcome[test] = passed
    message[test] = substr(text, length(test) + 3)
    next
}
/^1\.\./ { next }
!known { message[test] = message[test] "\n" $0 }

# ---- sentences

# What a test may take that the book's own answer was timed with.
function most(test) { return 20 * own[test] > seconds ? 20 * own[test] : seconds }
function short(x) { return x < 0.01 ? "less than 0.01" : x < 10 ? sprintf("%.2g", x) : sprintf("%.0f", x) }

function memory_fault(kind, all)
{
    if (kind ~ /buffer-(over|under)flow/) return access " outside an array"
    if (kind == "SEGV") return "follows a pointer that leads nowhere (a segmentation fault)"
    if (kind == "stack-overflow") return "calls itself without end, until the stack is full"
    if (kind ~ /use-after/) return access " memory that it has given back"
    if (kind == "double-free") return "frees the same memory twice"
    if (kind == "bad-free") return "frees what malloc did not give"
    if (kind ~ /size-too-big|out-of-memory|calloc-overflow/) return "asks for more memory than there is"
    if (all ~ /leaked in/) return "does not free all that it allocates (a leak of " $3 " bytes)"
    return "makes a mistake with memory (" kind ")"
}

function undefined_fault(what)
{
    if (what ~ /null pointer/) return "follows a null pointer (a segmentation fault)"
    if (what ~ /out of bounds|insufficient space/) return "reaches outside an array"
    return "does what C leaves undefined: " what
}

# From "program: file:line: function: Assertion `what' failed."
function assert_fault(text,    what, where)
{
    what = substr(text, index(text, ": Assertion ") + 13)
    sub(/' failed\.$/, "", what)
    where = substr(text, index(text, ": ") + 2)
    split(where, part, ":")
    place[now] = part[2]
    file_of[now] = part[1]
    return "breaks a rule that is asserted, " what
}

# The first line of the reader's own file in a report.
function find_place(    line)
{
    line = line_in(mine_pattern)
    if (line != "") place[now] = line
}

# The line of that file which is named here; nothing if none is.
function line_in(file_pattern,    text)
{
    if (!match($0, "(^|/)" file_pattern ":[0-9]+")) return ""
    text = substr($0, RSTART, RLENGTH)
    sub(/.*:/, "", text)
    return text
}

# Where a test without end was stopped, and from where that was called: lines of
# the reader's file, and at last the test's.  (The stack begins with the judge, and
# goes on with Check behind the test.)
function find_loop(    line)
{
    if (now in waits) return
    if ((line = line_in(mine_pattern)) != "") {
        if (!(now in place)) place[now] = line
        else if (line != last_line && ++calls[now] <= 4) place[now] = place[now] ", called from line " line
        last_line = line
    } else if ((line = line_in(test_pattern)) != "") {
        waits[now] = ARGV[1] ", line " line
        if (now in place) place[now] = place[now] ", called from " waits[now]
    }
}

# "rank(b): got 6, wanted 5" for Check's "Assertion 'rank(b) == 5' failed: rank(b) == 6,
# 5 == 5"; what is only claimed, and any other message, as it is.
function compared(text,    i, op, word, n, at, left, right, from, rest, got, is)
{
    if (text ~ /^Assertion '.*' failed$/) return "this should hold, and does not: " substr(text, 12, length(text) - 19)
    if (!match(text, /^Assertion '.*' failed: /)) return text
    n = split("==,!=,<=,>=,<,>", op, ",")
    split(",not ,at most ,at least ,less than ,more than ", word, ",")
    rest = substr(text, RLENGTH + 1)
    text = substr(text, 12, RLENGTH - 21)
    for (i = 1; i <= n; i++) {
        if (!(at = index(text, " " op[i] " "))) continue
        left = substr(text, 1, at - 1); right = substr(text, at + length(op[i]) + 2)
        if (index(rest, left " == ") != 1) continue
        got = substr(rest, length(left) + 5)
        if (!(from = index(got, ", " right " == "))) continue
        is = substr(got, from + length(right) + 6); got = substr(got, 1, from - 1)
        return left ": got " got ", wanted " word[i] is (right == is ? "" : " (" right ")")
    }
    return "Assertion '" text "' failed: " rest
}

# What is wrong with a test that did not pass.
function sentence(test,    m)
{
    m = message[test]
    if (!(test in fault)) {
        if (m ~ /^Early exit/ || outcome[test]) return "Your code ends the whole program (exit): a function has to return."
        if (m ~ /timeout expired/) return "Your code does not end: it waits."
        if (m ~ /^Received signal 25/) return "Your code prints without end."
        if (m ~ /^Received signal/) return "Your code stops the program: " m "."
        m = compared(m)
        gsub(/\n/, "\n  ", m)
        return m ((m ~ /[^a-z]-?nan[^a-z(]/ && m !~ /wanted[^.]*nan/) ? "\n  (nan is no number: 0 was divided by 0, or a root taken of less than 0.)" : "")
    }
    if (!(test in place) && test in waits) return "The test " fault[test] ": what your code gives keeps it waiting, " waits[test] "."
    return "Your code " fault[test] (test in place ? ": " (test in file_of ? file_of[test] : mine) ", line " place[test] : "") "."
}

function indented(text)
{
    gsub(/\n/, "\n      ", text)
    return "      " text
}

# Words of a list, in lines that are not too long.
function wrapped(text,    n, word, i, all, length_now)
{
    n = split(text, word, " ")
    for (i = 1; i <= n; i++) {
        if (length_now + length(word[i]) > 76) { all = all "\n "; length_now = 0 }
        all = all " " word[i]
        length_now += length(word[i]) + 1
    }
    return " " all
}

BEGIN {
    mine_pattern = mine; gsub(/\./, "[.]", mine_pattern)
    test_pattern = ARGV[1]; sub(/.*\//, "", test_pattern); gsub(/\./, "[.]", test_pattern)
    if (!seconds) seconds = 2
    while (times != "" && (getline row < (times)) > 0) {
        split(row, part, " ")
        own[part[1]] = part[3]
    }
}

END {
    if (!ran) {
        print name ": no test has run."
        exit 2
    }
    for (test in begun) order[begun[test]] = test
    n = split(early, name_of, " ")
    for (i = 1; i <= n; i++) if (name_of[i] in begun) { queue[++queued] = name_of[i]; taken[name_of[i]] = 1 }
    for (i = 1; i <= ran; i++) if (!(order[i] in taken)) queue[++queued] = order[i]
    for (i = 1; i <= ran; i++) {
        test = queue[i]
        if (test in outcome && outcome[test] && !unended[test] && !(test in fault)) good++
        else if (first == "") first = test
        else others = others (others == "" ? "" : ", ") test
    }
    if (good == ran) {
        print name ": all " ran " tests pass."
        exit 0
    }
    for (test in outcome) if (!(test in begun)) left++
    print name ": " good + 0 " of " ran " tests pass.  The first that does not:"
    print "\n  " first "  (" ARGV[1] ", line " line_of[first] ")"
    print "  " sentence(first)
    if (printed[first] != "") printf "\n  Your code printed:\n%s", printed[first]
    if (comment_of[first] != "") print "\n  The test's own comment:\n" indented(comment_of[first])
    if (others != "") print "\n" wrapped("The others: " others ".")
    if (left) print "\n  " left " more were not tried."
    exit 1
}
