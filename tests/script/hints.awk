# hints.awk - does a hint call a function as it is declared?
#
#   awk -f hints.awk declarations.h code.c ... hints ...
#
# Learns from the code how many arguments each function takes.  In a hint a name
# with a "(" right after it is a call: if the code has such a function, it must
# have as many arguments; a name of two words (one_two) must be in the code.
# Says file, line, and the call.  A call that ends with "..." leaves something out,
# and x_(k+1) is an index.

# The text from the first "(" of s to the one that closes it; "" if none does.
function bracket(s,    i, depth, c) {
    for (i = index(s, "("); i && i <= length(s); i++) {
        c = substr(s, i, 1)
        if (c ~ /[({[]/) depth++
        if (c ~ /[)}\]]/ && --depth == 0) return substr(s, index(s, "("), i - index(s, "(") + 1)
    }
    return ""
}
function arguments(s,    i, depth, c, n) {
    s = substr(s, 2, length(s) - 2)
    if (s ~ /^ *(void)? *$/) return 0
    for (i = 1; i <= length(s); i++) {
        c = substr(s, i, 1)
        if (c ~ /[({[]/) depth++
        if (c ~ /[)}\]]/) depth--
        if (c == "," && !depth) n++
    }
    return n + 1
}
# A function of this name, in this exercise's files or in the library.
function learn(text,    name, s) {
    name = text; sub(/\(.*/, "", name); sub(/.*[ *]/, "", name)
    s = bracket(text)
    if (s != "") takes[name] = takes[name] " " (s ~ /\.\.\.\)/ ? "any" : arguments(s)) " "
}
function look(text, at,    rest, name, call) {
    rest = text
    while (match(rest, /[A-Za-z_][A-Za-z0-9_]*\(/)) {
        name = substr(rest, RSTART, RLENGTH - 1); call = bracket(substr(rest, RSTART))
        rest = substr(rest, RSTART + RLENGTH)
        if (call == "" || call ~ /^\( *\)$/ || call ~ /\.\.\. *\)$/ || name ~ /_$/) continue
        if (name in takes) {
            if (takes[name] !~ (" (" arguments(call) "|any) ")) say(at, name call " has " arguments(call) " arguments, the function takes" takes[name])
        } else if (name ~ /_/ && !(name in seen)) say(at, "nothing is called " name)
    }
}
function say(at, what) { printf "%s:%d: %s\n", file, at, what; failed = 1 }
function end_file() {
    if (is_hint && hint != "") look(hint, from)
    if (!is_hint && held != "") learn(held)
    hint = held = ""
}

FNR == 1 { end_file(); file = FILENAME; is_hint = file ~ /hints$/ }
is_hint && /^ *$/ { look(hint, from); hint = ""; next }
is_hint { if (hint == "") from = FNR; hint = hint " " $0; next }
{
    line = $0; sub(/\/\/.*/, "", line)
    for (s = line; match(s, /[A-Za-z_][A-Za-z0-9_]*/); s = substr(s, RSTART + RLENGTH)) seen[substr(s, RSTART, RLENGTH)]
    if (line ~ /^[a-z][A-Za-z0-9_ ]*[ *][a-z0-9_]+\(/ && line !~ /^(typedef|return|else)/) held = line
    else if (held != "") held = held " " line
    if (held != "" && bracket(held) != "") { learn(held); held = "" }
}
END { end_file(); exit failed }
