# numbers.awk - the tuned numbers of lib/, a line of file, line, name, value,
# unit and reason each, with tabs between.   awk -f numbers.awk lib/*/*.[ch]
#
# A tuned number is declared on a line of its own, with a name, and with the words
# "tuned, UNIT" in a comment behind it; more words may follow, after a colon.  Its
# reason is the comment above it.
#     static const real DEEP = 0.12;      // tuned, diameters
# What is wrong with such a line is said, and ends with 1.

function fail(what) {
    print FILENAME ":" FNR ": " what > "/dev/stderr"
    failed = 1
}

FNR == 1 { reason = ""; held = "" }

/\/\/ tuned, / {
    line = $0; unit = $0
    sub(/.*\/\/ tuned, /, "", unit)
    more = unit ~ /: / ? substr(unit, index(unit, ": ") + 2) : ""
    sub(/: .*/, "", unit)
    sub(/[ ]*\/\/ tuned, .*/, "", line)
    sub(/^[ ]*(static const real|const real|enum \{|\.)[ ]*/, "", line)
    sub(/[ ]*\}?[;,]$/, "", line)
    n = split(line, part, / = /)
    if (n != 2 || part[1] !~ /^[A-Za-z_]+$/ || unit == "") fail("no NAME = VALUE and unit")
    why = reason; gsub(/\t/, " ", why)
    if (more != "") why = why (why == "" ? "" : " ") "(" more ")"
    if (why == "") fail(part[1] " has no reason")
    printf "%s\t%d\t%s\t%s\t%s\t%s\n", FILENAME, FNR, part[1], part[2], unit, why
    next
}

# A comment goes on as a reason over the numbers that stand under it.
/^[ ]*\/\/[<>]/ { if (sub(/^[ ]*\/\/>   /, "")) held = held (held == "" ? "" : " ") $0; else held = ""; reason = held; next }
/^[ ]*\/\// { sub(/^[ ]*\/\/ ?/, ""); if (!talks) reason = ""; reason = reason (reason == "" ? "" : " ") $0; talks = 1; held = ""; next }
{ talks = 0 }
/^[ ]*$/ { reason = ""; held = "" }

END { exit failed }
