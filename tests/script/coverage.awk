# coverage.awk - a table of what gcov -b -n prints: which lines of lib/ ran, and
# which of the ways out of its branches were taken at least once.
# A header's functions are counted in every file that includes it: the best
# count stands for it.

/^File '/ { file = substr($0, 7, length($0) - 7) }
file ~ /^lib\// && /^Lines executed:/ { read(1) }
file ~ /^lib\// && /^Taken at least once:/ { read(2) }
/^$/ { file = "" }      # what follows is gcov's own total, of everything

# "Lines executed:97.50% of 40": kind 1 lines, kind 2 branches.
function read(kind) {
    sub(/^[^:]*:/, ""); sub(/%.*of/, "")
    if (!(file in known)) { known[file] = 1; order[++files] = file }
    if (!((file, kind) in of) || $1 > percent[file, kind]) {
        percent[file, kind] = $1
        of[file, kind] = $2
    }
}

function row(name, lines, run, branches, taken) {
    printf "  %-22s %7.2f %% of %4d lines", name, 100 * run / lines, lines
    if (branches) printf "  %7.2f %% of %4d branches", 100 * taken / branches, branches
    print ""
}

END {
    for (i = 1; i <= files; i++) {
        f = order[i]
        lines = of[f, 1]; run = lines * percent[f, 1] / 100
        branches = of[f, 2]; taken = branches * percent[f, 2] / 100
        row(f, lines, run, branches, taken)
        all_lines += lines; all_run += run
        all_branches += branches; all_taken += taken
    }
    if (all_lines) row("lib/, in all", all_lines, all_run, all_branches, all_taken)
}
