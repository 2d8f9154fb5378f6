# check-book.awk - does the book tell the truth about the code?
#
#   awk -f check-book.awk lib/*.h lib/*.c book.md
#
# Knows nothing of how the book is made: it reads the finished book beside
# lib/.  A caption claims that the block below it is such lines of such a
# file; every claim must hold, and every line of lib/ that is not blank and
# not a marker must be claimed exactly once.  Every link must lead somewhere.

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
    caption = FNR; next
}
caption && FNR == caption + 2 { if ($0 != "```c") fail(book, FNR, "here a block of code should open"); inside = 1; next }
caption && inside && at <= end {
    if ($0 != lib[name, at]) fail(book, FNR, "this is not line " at " of " name)
    if (!(shown[name, at]++)) where[name, at] = FNR
    else fail(book, FNR, "line " at " of " name " was shown before, on line " where[name, at])
    at++; next
}
caption && inside { if ($0 != "```") fail(book, FNR, "here the block of code should close"); caption = inside = 0; next }
/^```/ { fence = !fence }
fence || /^```/ { next }

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
    for (f = 1; f <= file_count; f++) for (i = 1; i <= length_of[files[f]]; i++) {
        line = lib[files[f], i]
        if (line ~ /[^ \t]/ && line !~ /^\/\/[<>]/) {
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
    printf "book.md shows each of the %d lines of lib/ once; its %d links lead somewhere\n", code_lines, link_count
}
