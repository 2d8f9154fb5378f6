# readme.awk - writes README once more, with the numbers of today's tables:
#   awk -f numbers.awk -f readme.awk README.md
# A number stands between <!--{{its reference}}--> and <!---->, which no reader sees.

function fail(file, line, sentence) { printf "%s:%d: %s\n", file, line, sentence > "/dev/stderr"; failures++ }
{
    file = FILENAME; out = ""
    while (match($0, /<!--[{][{][^}]*[}][}]-->[^<]*<!---->/)) {
        piece = substr($0, RSTART, RLENGTH); past = RSTART + RLENGTH; before = substr($0, 1, RSTART - 1)
        inside = substr(piece, 7); inside = substr(inside, 1, index(inside, "}") - 1); rest = substr($0, past)
        out = out before "<!--{{" inside "}}-->" say_number(inside) "<!---->"; $0 = rest
    }
    if (/<!--[{][{]/) fail(file, FNR, "this reference has no end: <!---->")
    print out $0
}
END { exit failures > 0 }
