# reference.awk - a section for each type and function of tumble.h: its comment, how
# it is declared, and which programs call it.
#
#   awk -f reference.awk lib/tumble.h figures/scenes/*.c figures/manual/*.c
#
# A comment belongs to what follows it without a blank line, as far as the next
# blank line; a heading in it (// --- Shapes ---) begins a group.  A program calls a
# function if a line of its code has the name and a bracket.

BEGIN { MOST = 4 }

function flush_comment() { comment = ""; gap = 1 }

function link_to(word) { return "[`" word "`](#" tolower(word) ")" }
# A paragraph; names of others become links.
function prose(s,    out, word) {
    while (match(s, /tumble_[a-z0-9_]+/)) {
        word = substr(s, RSTART, RLENGTH)
        out = out substr(s, 1, RSTART - 1) (word in is_one ? link_to(word) : "`" word "`")
        s = substr(s, RSTART + RLENGTH)
    }
    return out s
}
function name_of(text,    s) {
    s = text
    if (text ~ /^(typedef struct|typedef enum)/) { sub(/;[^;]*$/, "", s); sub(/.*[ }]/, "", s); return s }
    if (text ~ /^enum/) { s = text; sub(/^enum { /, "", s); sub(/ .*/, "", s); return s }
    sub(/\(.*/, "", s); sub(/.*[ *]/, "", s)
    return s
}
# It has all of a declaration: remember it.
function keep() {
    what = name_of(text)
    if (!(what in is_one)) {
        is_one[what]; order[++n] = what; at[what] = begins; group_of[what] = group
        shown[what] = text; says[what] = comment
    }
    text = ""
}

FNR == 1 { is_header = FILENAME ~ /tumble\.h$/; files++ }
!is_header {
    line = $0; sub(/\/\/.*/, "", line)
    while (match(line, /tumble_[a-z0-9_]+\(/)) {
        called = substr(line, RSTART, RLENGTH - 1); line = substr(line, RSTART + RLENGTH)
        if (!((called, FILENAME) in seen)) { seen[called, FILENAME]; callers[called] = callers[called] " " FILENAME }
    }
    next
}
# --- the header ---
/^\/\/[<>]/ { text = ""; flush_comment(); next }
/^#/ || /^extern "C"/ { next }
text == "" && /^\/\/ --- / { group = $0; gsub(/^\/\/ --- | -+$/, "", group); comment = ""; next }
text == "" && /^\/\// { line = $0; sub(/^\/\/ ?/, "", line)
    if (gap) comment = ""
    gap = 0
    comment = comment (line == "" ? "\n\n" : (comment == "" || comment ~ /\n$/ ? "" : " ") line)
    next }
/^$/ && text == "" { gap = 1; next }
/^}$/ && text == "" { next }
{
    if (text == "") { begins = FNR; if (gap) comment = ""; gap = 0 }
    text = text (text == "" ? "" : "\n") $0
    code = $0; sub(/\/\/.*/, "", code); sub(/ +$/, "", code)
    opened += gsub(/[{]/, "{", code) - gsub(/[}]/, "}", code)
    if (opened == 0 && (code ~ /;$/ || code ~ /^}/)) keep()
}

END {
    print "<!-- Woven by `make book` from lib/tumble.h: edit that, not this. -->\n\n# tumble.h, function by function\n"
    print "All that a program sees of the library, in the order of [`tumble.h`](../../lib/tumble.h). [Chapter 19](19-library.md) explains the library, [chapter 19b](19b-howto.md) has programs that use it."
    for (i = 1; i <= n; i++) {
        what = order[i]
        if (group_of[what] != before || i == 1) { printf "%s\n**%s.**", i == 1 ? "" : "\n", group_of[what] == "" ? "Types" : group_of[what]; before = group_of[what] }
        else printf " ·"
        printf " %s", link_to(what)
    }
    print ""
    before = "none"
    for (i = 1; i <= n; i++) {
        what = order[i]
        if (group_of[what] != before) { before = group_of[what]; print "\n## " (before == "" ? "Types" : before) }
        print "\n### " what "\n"
        if (says[what] != "") print prose(says[what]) "\n"
        print "```c\n" shown[what] "\n```\n"
        printf "[lib/tumble.h](../../lib/tumble.h#L%d)", at[what]
        m = split(callers[what], from, " ")
        for (k = 1; k <= m && k <= MOST; k++) {
            base = from[k]; sub(/.*\//, "", base); sub(/\.c$/, "", base)
            printf "%s[%s](../../%s)", k == 1 ? "; called by " : ", ", base, from[k]
        }
        print (m > MOST ? " and others" : "") "."
    }
    print "\n---\n\n[Contents](../../README.md#read)"
}
