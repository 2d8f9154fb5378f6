# same.awk - do two CSVs of a figure say the same, but for what they took?
#   awk -v name=02-rope -f same.awk part=1 figures/times.txt \
#       part=2 WAS.csv part=3 IS.csv
# times.txt names the columns that are times (or follow from times).  Every other
# number must be the same to its last digit.  Prints what is not, and fails.

BEGIN { FS = "\n" }
FNR == 1 { block = -1; blank = 2; line_of = 0 }
part == 1 {
    n = split($0, word, " ")
    if (word[1] != name || n < 3) next
    if (word[2] == "#") { words = $0; sub(/^[^#]*# */, "", words); note[++notes] = words }
    else { m = split(word[3], column, ","); for (i = 1; i <= m; i++) timed[word[2], column[i]] = 1 }
    next
}
# The rows of gathered tables, and what names compiler and processor.
/^#= / || /^# .*(compiler|-std=|processor)/ || /^# .*-O3/ { next }
{
    line_of++; where = block
    if (/^#[a-z]+[|] /) { where = substr($0, 2, index($0, "|") - 2); text = substr($0, length(where) + 4) }
    else if (/^#/) { where = "#"; text = $0 }
    else if ($0 == "") { blank++; text = "" }
    else { if (blank >= 2) block++; blank = 0; where = block; text = $0 }
    text = without_times(where, text)
    if (part == 2) was[line_of] = text
    else {
        count = line_of
        if (was[line_of] != text && said++ < 5) print name ": " (line_of in was ? was[line_of] : "(nothing)") "  has become  " text
    }
    if (part == 2) total = line_of
}
END {
    if (count != total) { print name ": " total " lines have become " count + 0; said++ }
    exit said > 0
}
function without_times(where, text,    i, n, cell, out, rest) {
    if (where == "#") {
        for (i = 1; i <= notes; i++) if (index(text, note[i])) return note[i] " (a time)"
        return text
    }
    n = text ~ /^[^"]*("[^"]*"[^"]*)*,/ ? split_by(text, ",", cell) : split_by(text, " ", cell)
    for (i = 1; i <= n; i++)
        out = out " " ((where, i) in timed || ("*", i) in timed || (where, "*") in timed || ("*", "*") in timed ? "(a time)" : cell[i])
    return out
}
function split_by(text, mark, cell,    n) {
    text = text mark
    while (match(text, mark == "," ? "^(\"[^\"]*\"|[^\",]*)," : "^ *(\"[^\"]*\"|[^\" ]+) +") && RLENGTH > 0) {
        cell[++n] = substr(text, 1, RLENGTH - 1); text = substr(text, RLENGTH + 1)
        gsub(/^ *| *$/, "", cell[n])
    }
    return n
}
