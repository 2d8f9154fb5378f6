# lines.awk - how long is each module, header and source together, and how long
# are its functions?   awk -f lines.awk Makefile lib/tumble.h lib/*/*.h lib/*/*.c
# A function's lines are those between its braces.  Lines that only mark a
# region of the book, and the blank line between two regions, are not counted.

FILENAME == "Makefile" {
    if ($1 == "define" && $2 == "ORDER") inside = 1
    else if ($1 == "endef") inside = 0
    else if (inside) { split($1, part, "/"); chapter[part[2]] = part[1]; order[++modules] = part[2] }
    next
}
FNR == 1 { name = FILENAME; sub(/.*\//, "", name); sub(/\.[ch]$/, "", name) }
/^\/\/[<>]/ { marked = 1; next }
marked && /^$/ { marked = 0; next }
{ marked = 0 }
{ lines[name]++ }
/^\{/ { open = FNR }
/^\}/ && open { note(name, FNR - open - 1); open = 0 }

function note(m, n) {
    length_of[m, ++count[m]] = n
    if (n > longest[m]) longest[m] = n
    if (chapter[m] < 10) all[++functions] = n
}
# The middle one of the first n of x, which is sorted on the way.
function median(x, n,    i, j, t) {
    for (i = 2; i <= n; i++)
        for (j = i; j > 1 && x[j - 1] > x[j]; j--) { t = x[j]; x[j] = x[j - 1]; x[j - 1] = t }
    return n ? x[int((n + 1) / 2)] : 0
}
END {
    print "chapter,module,lines,functions,median,longest"
    for (i = 1; i <= modules; i++) {
        m = order[i]; n = count[m] + 0
        for (k = 1; k <= n; k++) own[k] = length_of[m, k]
        printf "%s,%s,%d,%d,%d,%d\n", chapter[m], m, lines[m], n, median(own, n), longest[m]
        whole = chapter[m] < 10 ? "Part I" : "Part II"
        sum[whole] += lines[m]; number[whole] += n
        if (longest[m] > most[whole]) most[whole] = longest[m]
    }
    printf "00 to 09,Part I,%d,%d,%d,%d\n", sum["Part I"], number["Part I"], median(all, functions), most["Part I"]
    printf "10 to 19,Part II,%d,%d,,%d\n", sum["Part II"], number["Part II"], most["Part II"]
}
