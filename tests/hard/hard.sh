#!/bin/sh
# hard.sh BUILD TABLES [JOBS] - runs the hard cases of BUILD/hard and of
# BUILD/hard-plain, each in a process of its own, through the script of sweeps:
# JOBS at once, or as many as there are cores.  What was stopped goes on, unless
# its program was built again meanwhile.  Writes TABLES/hard.csv and hard-plain.csv.
# Ends with 1 if a case of the engine falls short, with 2 if one could not be run.

build=$1 tables=$2 jobs=$3

# sweep NAME: runs all cases of that program, and counts those that hold.
sweep() {
    program=$build/$1 rows=$build/$1.rows table=$tables/$1.csv
    [ "$rows/head" -nt "$program" ] || rm -rf "$rows" "$rows.joblog"
    cases=$("$program" --list | wc -l)
    echo "$1: $cases cases; $rows.joblog says which are done"
    mkdir -p "$rows" &&
        { [ -e "$rows/head" ] || "$program" --head > "$rows/head"; } &&
        "$build/tumble-sweep" 'make hard goes on with it' "$rows" $cases \
            "$rows.joblog" "$table" "$jobs" '' "$program" --row || exit 2
    short=$(grep -c '^[0-9].*,FALLS SHORT$' "$table")
    echo "$1: $((cases - short)) of $cases hold"
}

sweep hard-plain
sweep hard
[ "$short" -eq 0 ]
