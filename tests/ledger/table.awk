# table.awk - the ledger, from what was run.
#   awk -v rows=FOLDER -f table.awk FOLDER/list FOLDER/base FOLDER/numbers
#
# An error that is less than what matters in its scene counts as that; of half and
# of double, the scene counts that changes by the largest factor.  Less than a
# fifth is no change.

BEGIN {
    FS = ","; LEAST = 1.2
    print "# Tuned numbers of lib/: what half and double of each do to the errors of short scenes, and to their work"
    print "number,value,unit,half: error,half: work,double: error,double: work"
}

function larger(a, b) { return a > b ? a : b }

# What scenes say of a number at half or double: sets said and work, and adds to
# differs how many scenes have other bits.
function read_row(path,    line, part, was, now, most, s, q, scene, got, stopped) {
    said = ""; was = now = most = 0; got = 0
    while ((getline line < path) > 0) {
        if (line == "stopped") { stopped = 1; continue }
        split(line, part, ","); s = part[1]; got++
        was += base_work[s]; now += part[4]
        if (part[5] == base_bits[s]) continue
        differs++; changed[s]++
        q = part[2] == "inf" || part[2] == "nan" ? 99 : log(larger(part[2], fine[s]) / larger(base_error[s], fine[s]))
        if (q * q > most * most) { most = q; scene = s }
    }
    close(path)
    if (!got && !stopped) { said = work = "not run"; open++; return }
    if (stopped) { said = "stops"; work = "-"; differs++; return }
    if (most * most > log(LEAST) * log(LEAST)) said = scene (most > 90 ? " fails" : sprintf(" x %.2g", exp(most)))
    work = sprintf("%+.0f %%", 100 * (now / was - 1))
    if (work ~ /^[-+]0 /) work = "0"
}

FILENAME ~ /list$/ { fine[$1] = $3; next }
FILENAME ~ /base$/ { base_error[$1] = $2; base_work[$1] = $4; base_bits[$1] = $5; next }
FNR == 1 { FS = "\t"; $0 = $0 }
{
    differs = 0
    file = $1; sub(/.*\//, "", file); value = $4; key = $4; gsub(/[ \/]/, "", key)
    read_row(rows "/" file "." $3 "." key ".half"); half = said; half_work = work
    read_row(rows "/" file "." $3 "." key ".double"); twice = said; twice_work = work
    if (differs == 0 && half != "not run" && twice != "not run") { half = twice = "same bits"; idle++ }
    printf "%s %s,%s,%s,%s,%s,%s,%s\n", file, $3, value, $5, half, half_work, twice, twice_work
    printf "# %s %s: %s\n", file, $3, $6
    count++
}

END {
    printf "# %d numbers; %d show nothing in any scene%s\n", count, idle, open ? "; " open " runs are open" : ""
}
