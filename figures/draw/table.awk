# table.awk - gathers what the figures of speed say in lines that open with
# "#= ": as CSV, and aligned, for eyes.  And on what machine it was said.
#
#   awk -v head=a,b,c -v csv=out.csv [-v machine=m.csv] -f table.awk *.csv

BEGIN { add(head) }
sub(/^#= /, "") { add($0) }
sub(/^# compiler: /, "") && / processor: / && machine {
    gsub(/,/, " "); gsub(/; [a-z]*: /, ",")
    print "compiler,flags,processor\n" $0 > machine
    close(machine); machine = ""
}

function add(line,    i, n, cell) {
    row[++rows] = line
    n = split(line, cell, ",")
    for (i = 1; i <= n; i++)
        if (length(cell[i]) > width[i]) width[i] = length(cell[i])
}

END {
    for (r = 1; r <= rows; r++) {
        print row[r] > csv
        n = split(row[r], cell, ","); line = ""
        for (i = 1; i < n; i++) line = line sprintf("%-" width[i] + 2 "s", cell[i])
        print line cell[n]
    }
}
