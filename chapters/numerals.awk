# numerals.awk - the sentences in which a numeral with a unit, or a ratio, was
# typed by hand:   awk -f numerals.awk chapters/[0-9]*.md README.md
# prints of each the page, a checksum of the sentence, its line, and the numerals.
# Code, formulas, links and {{references}} are left out, and white space, so that
# lines may be broken elsewhere.  What ends with a full stop or a colon is a
# sentence, and so is a row of a table.

BEGIN {
    number = "(\342\210\222|-)?([0-9][0-9,]*)?\\.?[0-9]+"
    unit = "(m|mm|cm|km|\302\265m|nm|s|ms|ns|us|\302\265s|min|hours?|minutes?|seconds?|kg|g|N|J|W|Hz|GHz|kHz|rad|rad\\/s|m\\/s|m\\/s\302\262|kB|MB|kilobytes|bytes|degrees|times|metres|millimetres|milliseconds|nanoseconds|microseconds|joules|newtons|\303\227|x)"
    numeral = number "( %| per cent| " unit "([^a-zA-Z0-9]|$)| of (a|the|its|one) )"
    for (i = 1; i < 256; i++) code[sprintf("%c", i)] = i
}
FNR == 1 { flush(); page = FILENAME; sub(/.*\//, "", page); if (page ~ /^[0-9]/) sub(/-.*/, "", page); inside = 0 }
/^ *```/ { flush(); inside = !inside; next }
inside || /^(@@|%%) / || /^<!--/ { next }
/^ *$/ { flush(); next }
/^#/ || /^\|/ || /^ *[-*] / || /^ *[0-9]+\. / { flush() }
{
    gsub(/<!--[{][{][^}]*[}][}]-->[^<]*<!---->/, "#")      # README's references
    gsub(/\{\{[^}]*\}\}/, "#")
    gsub(/\$`[^`]*`\$/, "~"); gsub(/`[^`]*`/, "~"); gsub(/\]\([^)]*\)/, "]"); gsub(/<[a-z\/][^>]*>/, " ")
    if (paragraph == "") first = FNR
    paragraph = paragraph " " $0
}
/^\|/ { flush() }
END { flush() }

function flush(    rest, end) {
    rest = paragraph; paragraph = ""
    gsub(/[ \t]+/, " ", rest)
    while (match(rest, /[.!?:][)*"]* /)) {
        end = RSTART + RLENGTH
        sentence(substr(rest, 1, end - 1)); rest = substr(rest, end)
    }
    sentence(rest)
}
function sentence(text,    rest, found, piece) {
    gsub(/^ +| +$/, "", text)
    rest = text
    while (match(rest, numeral)) {
        piece = substr(rest, RSTART, RLENGTH); gsub(/[^0-9a-z%]+$/, "", piece)
        found = found (found == "" ? "" : "; ") piece
        rest = substr(rest, RSTART + RLENGTH - 1)
    }
    if (found != "") printf "%s %s %d %s | %s\n", page, checksum(text), first, found, text
}
function checksum(text,    i, h) {
    for (i = 1; i <= length(text); i++) h = (h * 31 + code[substr(text, i, 1)]) % 2147483647
    return sprintf("%.0f", h)
}
