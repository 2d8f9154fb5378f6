# cut.awk - takes functions out of a C file, so that a reader can put them back.
#
#   awk -v empty='f g' -v remove='h' -f cut.awk lib/m.c            the file to fill in
#   awk -v empty='f g' -v remove='h' -v show=1 -f cut.awk lib/m.c  what was taken out
#
# A function of lib/ opens and closes with a brace alone in the first column, and
# its comment and its head stand right above, with no blank line between.  An
# emptied function keeps both; a removed one goes with them.  Of an exercise that
# goes on (-v derived=1) the comment derives the answer, and the header says what
# is asked: there only a static function, which no header has, keeps its comment.

function fail(why)
{
    print FILENAME ": " why > "/dev/stderr"
    failed = 1
}

function say(line)
{
    if (line != "" || last_said != "") print line
    last_said = line
}

function say_held(last,    i)
{
    for (i = 1; i <= last; i++) say(held[i])
}

# The head alone, where the comment would tell the answer.
function say_asked(    i)
{
    for (i = 1; held[i] ~ /^\/\//; i++) continue
    if (!derived || held[i] ~ /^static/) i = 1
    for (; i <= brace; i++) say(held[i])
}

# Sets name and type from the head, the lines between the comment and the brace.
function read_head(    i, head, word, n)
{
    for (i = brace; i > 1 && held[i - 1] !~ /^\/\/|[;}]$/; i--) head = held[i - 1] " " head
    match(head, /[A-Za-z_0-9]+\(/)
    name = substr(head, RSTART, RLENGTH - 1)
    n = split(substr(head, 1, RSTART - 1), word, " ")
    type = ""
    for (i = 1; i <= n; i++)
        if (word[i] != "static" && word[i] != "inline") type = type (type == "" ? "" : " ") word[i]
}

# What an empty function of this type returns, so that it compiles.
function say_nothing()
{
    if (type == "void") return
    if (type ~ /\*$/ || type ~ /^(unsigned |long |int|double|real|char|size_t)/) say("    return 0;")
    else say("    return (" type "){ 0 };")
}

# One block is held: a function with its comment, or anything else.
function block_ends()
{
    name = ""
    if (brace) read_head()
    if (!(name in task)) {
        if (!show) say_held(count)
    } else if (show) {
        say("// " FILENAME ", line " start)
        say_held(count)
        say("")
    } else if (task[name] == "empty") {
        say_asked()
        say("    // Yours to write.")
        say_nothing()
        say("}")
    }
    if (name in task) found[name]++
    count = brace = 0
}

BEGIN {
    n = split(empty, word, " ")
    for (i = 1; i <= n; i++) task[word[i]] = "empty"
    n = split(remove, word, " ")
    for (i = 1; i <= n; i++) task[word[i]] = "remove"
    last_said = "nothing yet"
}

# The marks of the book's regions are nothing to the reader.
/^\/\/[<>]/ { block_ends(); next }
/^$/ && !brace { block_ends(); if (!show) say(""); next }
# The file to fill in is the reader's own.
FNR == 1 && !show { sub(/^\/\/ solution\.c /, "// mine.c ") }
{ held[++count] = $0; if (count == 1) start = FNR }
/^\{$/ { brace = count }
/^\}$/ { if (brace) block_ends() }

END {
    block_ends()
    for (name in task)
        if (found[name] != 1)
            fail("the function " name " stands there " found[name] + 0 " times, and the exercise wants it once")
    exit failed
}
