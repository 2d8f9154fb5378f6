# check_same.sh - does a figure's program still write the same numbers, but for
# times?  The figures of a chapter that the commit draws at random are run again:
# all that are no older than their sources and take at most five seconds
# (figures/times.txt).  CHAPTER=10 says which chapter instead.  After a run of all,
#   AGAINST=HEAD sh tests/script/check_same.sh
# names what changed since that commit in any of them, and is no time.

export LC_ALL=C
unset MAKEFLAGS MFLAGS TUMBLE_QUICK
[ -z "$YOURS" ] || { echo "figures: not run again with other modules"; exit 0; }
build=${BUILD:-build}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=

# same NAME DATA AGAIN
same() { awk -v name="$1" -f figures/draw/same.awk part=1 figures/times.txt part=2 "$2" part=3 "$3"; }

if [ "$AGAINST" ]; then
    for data in figures/[0-9]*/*.csv; do
        name=${data##*/}
        git show "$AGAINST:$data" > "$work/was" 2> /dev/null && { same "${name%.csv}" "$work/was" "$data" || failed=1; }
    done
    exit ${failed:-0}
fi
sh figures/draw/stamp.sh -n > "$work/older"
for data in figures/[0-9]*/*.csv; do
    name=${data##*/}; name=${name%.csv}
    ! grep -qx "figure-$name" "$work/older" &&
        awk -v name="$name" '$1 == name && $2 == "takes" && $3 > 5 { slow = 1 } END { exit slow }' figures/times.txt &&
        echo "$name"
done > "$work/quick"
if [ ! -s "$work/quick" ]; then
    echo "figures: all that are quick are older than their sources, so none was run again"
else
    seed=$({ git rev-parse HEAD || date; } 2> /dev/null | cksum | cut -d' ' -f1)
    cut -d- -f1 "$work/quick" | sort -u > "$work/chapters"
    chapter=${CHAPTER:-$(sed -n "$((seed % $(wc -l < "$work/chapters") + 1))p" "$work/chapters")}
    again=$(grep "^$chapter-" "$work/quick")
    for name in $again; do
        make --no-print-directory -s "BUILD=$build" "$build/figures/$name" > "$work/made" 2>&1 &&
            "$build/figures/$name" > "$work/$name.csv" || { echo "$name does not run"; tail -n 3 "$work/made"; failed=1; continue; }
        same "$name" "figures/$chapter/$name.csv" "$work/$name.csv" || failed=1
    done
    echo "figures of chapter $chapter, run again: $(echo $again)"
fi

# What must be seen is seen: a number, a line, a name; and a time is not.
printf '# a rope\n# n cost strain\n1 0.5 0.25\n2 0.7 0.125\n\n\n#one| a,b\n#one| 1,2\n' > "$work/was"
echo '01-n 0 2' > "$work/times"
compare() { sed "$1" "$work/was" > "$work/is"; awk -v name=01-n -f figures/draw/same.awk part=1 "$work/times" part=2 "$work/was" part=3 "$work/is" > "$work/said"; }
compare 's/0.5 /0.6 /' || { echo "a time that changes fails"; failed=1; }
for change in 's/0.125/0.126/' '4d' 's/a rope/a chain/' 's/| 1,2/| 1,3/' '$p'; do
    compare "$change" && { echo "same.awk overlooks $change"; failed=1; }
done
[ -z "$failed" ]
