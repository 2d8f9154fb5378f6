# coverage.awk - a table of what gcov -n prints: lines of lib/ that ran.
# A header's functions are counted in every file that includes it: the best
# count stands for it.

/^File '/ { file = substr($0, 7, length($0) - 7) }
/^Lines executed:/ && file ~ /^lib\// {
    sub(/^Lines executed:/, ""); sub(/%.*of/, "")
    if (!(file in lines)) order[++files] = file
    if (!(file in lines) || $1 > percent[file]) { percent[file] = $1; lines[file] = $2 }
    file = ""
}
/^Lines executed:/ { file = "" }        # gcov's own total, of everything
/^No executable lines/ { file = "" }

END {
    for (i = 1; i <= files; i++) {
        f = order[i]
        run = lines[f] * percent[f] / 100
        printf "  %-24s %7.2f %% of %4d lines\n", f, percent[f], lines[f]
        all += lines[f]; ran += run
    }
    if (all) printf "  %-24s %7.2f %% of %4d lines\n", "lib/, in all", 100 * ran / all, all
}
