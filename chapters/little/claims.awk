# claims.awk - what a program printed, against what stages.txt says of a stage:
#   awk -v stage=01b -f claims.awk stages.txt printed.txt
# prints a line for each claim that does not hold, and ends with 1 if there is one.
# With -v ours=1 it prints all claims, and how they hold.
# A claim is NAME < NUMBER; also > <= >= and =.  A printed line is NAME VALUE UNIT.

FILENAME == ARGV[1] {
    n = split($0, part, / *\| */)
    if (n > 2 && part[1] == stage) for (i = 3; i <= n; i++) claim[++claims] = part[i]
    next
}
{ name = $0; sub(/ +[^ ]+ +[^ ]+$/, "", name); value[name] = $(NF - 1); unit[name] = $NF }
END {
    for (i = 1; i <= claims; i++) {
        if (!match(claim[i], / [<>]?=? -?[0-9.e-]+$/)) { say(claim[i] " is no claim"); continue }
        name = substr(claim[i], 1, RSTART - 1)
        split(substr(claim[i], RSTART + 1), part, " ")
        if (!(name in value)) { say("\"" name "\" is not printed"); continue }
        is = value[name] + 0; limit = part[2] + 0
        holds = part[1] == "<" ? is < limit : part[1] == ">" ? is > limit : \
                part[1] == "<=" ? is <= limit : part[1] == ">=" ? is >= limit : is == limit
        if (value[name] !~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/) holds = 0
        if (!holds) say(claim[i] " " unit[name] ", and it is " value[name])
        else if (ours) print "  holds: " claim[i] " " unit[name]
    }
    if (!claims) say("stages.txt claims nothing of stage " stage)
    exit bad
}
function say(what) { print "  does not hold: " what; bad = 1 }
