# check-book.awk - does the book tell the truth about the code?
#
#   awk -f check-book.awk $(sh chapters/weave.sh) book.md
#
# Knows nothing of how the book is made: it reads the finished book beside the
# code.  A caption claims that the block below it is such lines of such a file;
# every claim must hold, and every line of code that is not blank and not a
# marker must be claimed exactly once.  The name of a CSV, alone on a line,
# claims that the table below it is that file.  Every link must lead somewhere.

function fail(file, line, sentence) {
    printf "%s:%d: %s\n", file, line, sentence > "/dev/stderr"
    failures++
}

# GitHub's anchor of a heading, without the number of a repeated one.
function slug(heading,    i, c, s) {
    for (i = 1; i <= length(heading); i++) {
        c = tolower(substr(heading, i, 1))
        if (c == " ") c = "-"
        else if (index("!\"#$%&'()*+,./:;<=>?@[\\]^`{|}~", c)) c = ""
        else if (c == "\342") { c = ""; i += 2 }        # a dash of three bytes
        s = s c
    }
    return s
}

# The next row of the table's file; blank if there is none.  Rows of a named
# table open with "#name| ".
function next_row(    line) {
    do if ((getline line < csv) <= 0) return ""
    while (named ? !sub("^#" named "[|] ", "", line) : line ~ /^#/)
    gsub(/"/, "", line)
    return line
}
function end_table() {
    if (next_row() != "") fail(book, FNR, "here a row of " csv " is missing")
    close(csv); csv = ""
}

# A block shows the lines that its captions claim, one claim after the other.
function open_claim(k) { which = k; name = claimed[k]; at = begins[k]; end = ends[k] }

# A caption's names: each opens a function in these lines, or closes a type.
function check_names(list, name, at, end,    n, word, i, k, found) {
    n = split(list, word, ", ")
    for (i = 1; i <= n; i++) {
        found = 0
        for (k = at; k <= end; k++)
            if (lib[name, k] ~ "^[a-z].*[ *]" word[i] "[(]" || lib[name, k] ~ "^} " word[i] ";") found = 1
        if (!found) fail(book, FNR, word[i] " is not in these lines of " name)
    }
}

FILENAME != "book.md" && FILENAME !~ /\/book\.md$/ {
    lib[FILENAME, FNR] = $0; length_of[FILENAME] = FNR
    if (FNR == 1) files[++file_count] = FILENAME
    next
}

{ book = FILENAME }

# A caption: remember the claim; the block must open two lines below.
/^\[[^]]*, lines? [0-9]/ {
    split($0, half, "]")
    n = split(substr(half[1], 2), word, /, lines? | to /)
    name = word[1]; at = word[2] + 0; end = n > 2 ? word[3] + 0 : at
    link = "(" name "#L" at (n > 2 ? "-L" end : "") ")"
    if (half[2] != link) fail(book, FNR, "the caption and its link disagree")
    if (!(name in length_of)) fail(book, FNR, "there is no file " name)
    if (sub(/.*[0-9]: /, "", half[1])) check_names(half[1], name, at, end)
    claims = caption && caption == FNR - 1 ? claims + 1 : 1
    claimed[claims] = name; begins[claims] = at; ends[claims] = end
    caption = FNR; next
}
caption && FNR == caption + 2 { if ($0 != "```" (claimed[1] ~ /\.py$/ ? "python" : "c")) fail(book, FNR, "here a block of code should open"); inside = 1; open_claim(1); next }
# Between the pieces of a block there may be a blank line.
caption && inside && $0 == "" && which > 1 && at <= begins[which] + (lib[name, begins[which]] == "") && lib[name, at] != "" { next }
caption && inside && at <= end {
    if ($0 != lib[name, at]) fail(book, FNR, "this is not line " at " of " name)
    if (!(shown[name, at]++)) where[name, at] = FNR
    else fail(book, FNR, "line " at " of " name " was shown before, on line " where[name, at])
    if (++at > end && which < claims) open_claim(which + 1)
    next
}
caption && inside { if ($0 != "```") fail(book, FNR, "here the block of code should close"); caption = inside = 0; next }
/^```/ { fence = !fence }
fence || /^```/ { next }

# The name of a CSV, and of a table in it: its head two lines below, a rule, its
# rows.
csv && FNR > table + 1 && !/^\|/ { end_table() }
csv && FNR > table + 1 && FNR != table + 3 {
    line = $0; gsub(/^\| | \|$/, "", line); gsub(/ \| /, ",", line)
    if (line != next_row()) fail(book, FNR, "this is not what " csv " says now")
    next
}
!csv && /^\[[^],]*\.csv(, [a-z]+)?\]\([^)]*\)$/ {
    csv = substr($0, 2); sub(/\].*/, "", csv); table = FNR
    named = csv; if (!sub(/.*, /, "", named)) named = ""
    sub(/, .*/, "", csv)
}

/^#+ / {
    heading = $0; sub(/^#+ /, "", heading); heading = slug(heading)
    anchors[times[heading]++ ? heading "-" times[heading] - 1 : heading] = 1
}
{
    gsub(/`[^`]*`/, "")
    while (match($0, /\]\([^) ]*\)/)) {
        link = substr($0, RSTART + 2, RLENGTH - 3); $0 = substr($0, RSTART + RLENGTH)
        if (link !~ /^https?:/) links[++link_count] = link; else continue
        link_line[link_count] = FNR
    }
}

END {
    if (book == "") { fail("book.md", 0, "there is no book"); exit 1 }
    if (caption || fence) fail(book, FNR, "the book ends inside a block")
    if (csv) end_table()
    for (f = 1; f <= file_count; f++) for (i = 1; i <= length_of[files[f]]; i++) {
        line = lib[files[f], i]
        if (line ~ /[^ \t]/ && line !~ (files[f] ~ /\.py$/ ? "^#[<>]" : "^//[<>]")) {
            if (!((files[f], i) in shown)) fail(files[f], i, "this line is not in the book")
            code_lines++
        }
    }
    for (i = 1; i <= link_count; i++) {
        link = links[i]
        if (link ~ /^#/) { if (!(substr(link, 2) in anchors)) fail(book, link_line[i], "no heading has the anchor " link); continue }
        sub(/#.*/, "", link); folder = link ~ /\/$/ || link == "exercises"
        if (!folder && (getline line < link) < 0) fail(book, link_line[i], "there is no file " link)
        if (!folder) close(link)
    }
    if (failures) exit 1
    printf "book.md shows each of the %d lines of code once; its %d links lead somewhere\n", code_lines, link_count
}
