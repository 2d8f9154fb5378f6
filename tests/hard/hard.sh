#!/bin/sh
# hard.sh BUILD TABLES [JOBS] - runs the hard cases of BUILD/hard, those of
# BUILD/hard-plain and the rows of BUILD/families, each in a process of its own,
# through the script of sweeps: JOBS at once, or as many as there are cores.  What
# was stopped goes on, unless its program was built again meanwhile.  Writes
# TABLES/hard.csv, hard-plain.csv and families.csv.
# Ends with 1 if a case of the engine falls short, or if a number of families is
# worse than in the table that was committed; with 2 if a row could not be run.

build=$1 tables=$2 jobs=$3

# sweep NAME: runs all cases of that program, and counts those that hold.
sweep() {
    program=$build/$1 rows=$build/$1.rows table=$tables/$1.csv
    [ "$rows/head" -nt "$program" ] || rm -rf "$rows" "$rows.joblog"
    numbers=$("$program" --list | awk '{ printf "%s ", $1 }')
    cases=$(echo $numbers | wc -w)
    echo "$1: $cases cases; $rows.joblog says which are done"
    mkdir -p "$rows" &&
        { [ -e "$rows/head" ] || "$program" --head > "$rows/head"; } &&
        "$build/tumble-sweep" 'make hard goes on with it' "$rows" "$numbers" \
            "$rows.joblog" "$table" "$jobs" '' "$program" --row || exit 2
    short=$(grep -c '^[0-9].*,FALLS SHORT$' "$table")
    echo "$1: $((cases - short)) of $cases hold"
}

# committed: the table of families as it was committed; without git, as it is.
committed() {
    git show "HEAD:./$tables/families.csv" 2> /dev/null ||
        cat "$tables/families.csv" 2> /dev/null
}

sweep hard-plain
sweep hard
hard_short=$short
before=$build/families.before
committed > "$before"
sweep families
awk -F , '/^[0-9].*,FALLS SHORT$/ { print "  falls short: " $1 " " $2 }' "$tables/families.csv"
awk -f "$(dirname "$0")/worse.awk" "$before" "$tables/families.csv"
worse=$?
[ $hard_short -eq 0 ] && [ $worse -eq 0 ]
