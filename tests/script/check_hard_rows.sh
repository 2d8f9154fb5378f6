# check_hard_rows.sh - does `make hard` put the rows of its cases together as they
# stand, however many run at once, and does it go on where it was stopped?  The
# cases are those of a stand-in, a shell script.

root=$(pwd)
parallel --version 2> /dev/null | grep -q '^GNU parallel' || { echo "hard rows: no GNU Parallel"; exit 0; }
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cd "$place" || exit 1

checks=0 failures=0
verdict() {     # NAME WHY: it failed if WHY is not empty
    checks=$((checks + 1))
    [ -z "$2" ] || { failures=$((failures + 1)); echo "check_hard_rows: $1: $2"; }
}

# Row 5 waits for the file `go`; row `short` falls short, and row `bad` fails.
mkdir build tables
cp "$root/figures/command/sweep.sh" build/tumble-sweep && chmod +x build/tumble-sweep
cat > build/hard <<'END'
#!/bin/sh
case $1 in
--list) seq 8 ;;
--head) printf '# stand-in\nnumber,case,verdict\n' ;;
--row)  echo "$2" >> ran
        while [ "$2" -eq 5 ] && [ ! -e go ]; do sleep 0.05; done
        [ "$2" != "$(cat bad)" ] || exit 3
        verdict=holds; [ "$2" != "$(cat short)" ] || verdict='FALLS SHORT'
        printf '%s,"case, %s",%s\n# %s: a remark, FALLS SHORT\n' "$2" "$2" "$verdict" "$2"
        echo "line of $2" >&2 ;;
esac
END
chmod +x build/hard
sed 's/ran/plain-ran/; s/stand-in/plain/' build/hard > build/hard-plain && chmod +x build/hard-plain

# The rows of families have numbers with gaps, and one number each, in `number`.
cat > build/families <<'END'
#!/bin/sh
case $1 in
--list) printf '101  a\n105  b\n' ;;
--head) printf '# stand-in\nnumber,case,verdict\n' ;;
--row)  read -r number target verdict < number
        printf '%s,"case, %s",%s\n' "$2" "$2" "$verdict"
        printf '# %s: it: it is: %s m, target %s, %s\n' "$2" "$number" "$target" "$verdict"
        printf '# %s: of it: it is: %s of 9 beyond the target, worst\n' "$2" "$(cat beyond)" ;;
esac
END
chmod +x build/families; echo '.5 1 holds' > number; echo 0 > beyond
: > bad; : > short; : > go
run() { sh "$root/tests/hard/hard.sh" build tables "$@" > out 2> err; code=$?; }

run 1
verdict 'all hold' "$([ $code -eq 0 ] && grep -q '^hard: 8 of 8 hold' out || echo "$code: $(cat out err)")"
verdict 'a head, and rows in order with what they remark' "$(awk -F , '!/^#/ && NR > 2 && $1 != ++n { print "line " NR }
    END { if (NR != 18) print NR " lines" }' tables/hard.csv)"
verdict 'the line of each case is seen' "$([ "$(grep -c '^line of' err)" -eq 16 ] || echo "$(wc -l < err) lines")"
cp tables/hard.csv one
run 3
verdict 'three at once, the same table' "$(cmp one tables/hard.csv 2>&1)"
verdict 'nothing is left but the logs' "$(ls -d build/*.rows 2> /dev/null)"

echo 3 > short
run
verdict 'what falls short is told' "$([ $code -eq 1 ] && grep -q '^hard: 7 of 8 hold' out || echo "$code: $(cat out err)")"
: > short; echo 6 > bad
run
verdict 'what cannot be run is told' "$([ $code -eq 2 ] && grep -q 'make hard goes on' err || echo "$code: $(cat err)")"
cp tables/hard.csv before; : > bad; rm -f ran plain-ran
run
verdict 'and only that is run again' "$([ $code -eq 0 ] && [ "$(cat plain-ran)" = 6 ] || echo "$code: $(cat plain-ran out err)")"

# A number of families that was worse is not lost in a table.
families() {    # NAME CODE WORDS: the next run ends so, and says so
    run
    verdict "$1" "$([ $code -eq "$2" ] && grep -q "$3" out || echo "$code: $(cat out err)")"
}
families 'families hold' 0 '^families: 2 of 2 hold'
echo '3 1 FALLS SHORT' > number
families 'what held falls short' 1 'worse: 105: it: it is: 3 m falls short'
families 'what fell short may' 0 'falls short: 101 '
echo '3.1 1 FALLS SHORT' > number
families 'but not by more' 1 'worse: 101: it: it is: 3.1 m, was 3'
echo 'nan 1 FALLS SHORT' > number
families 'NaN is worse than any number' 1 'worse: 101: it: it is: nan m'
echo '2 1 FALLS SHORT' > number; run; echo 4 > beyond
families 'nor oftener' 1 'worse: 101: of it: it is: 4 of 9 trials'
sed -i 's/^# 105: .*target.*/# 105: another: 1 m, target 2, holds/' tables/families.csv
families 'nor be gone' 1 'worse: 105: another: is gone'
echo '.5 1 holds' > number
families 'what holds now is told' 0 'holds now: 101: it: it is'

# Stopped while row 5 runs.
rm -f go ran plain-ran build/*.joblog
sh "$root/tests/hard/hard.sh" build tables 2 > out 2> err & child=$!
tries=0
until [ "$(cat build/hard-plain.rows.joblog 2> /dev/null | wc -l)" -ge 8 ] || [ $tries -eq 200 ]; do
    tries=$((tries + 1)); sleep 0.05
done
pid=$(ps -o pid= --ppid $child | head -n 1)
kill -TERM $pid
wait $child
code=$?
verdict 'stopped, it says so' "$([ $code -eq 2 ] && grep -q 'stopped; make hard goes on' err || echo "$code: $(cat err)")"
: > go
run 2
verdict 'and goes on: the same table' "$(cmp one tables/hard.csv 2>&1)"
verdict 'no row ran twice but the one that was stopped' "$(sort plain-ran | uniq -d | grep -v 5)"

# A program that was built again begins again.
echo 6 > bad; rm -f ran; run; : > bad; rm -f plain-ran
sleep 1; touch build/hard-plain
run
verdict 'of another build no row is kept' "$([ "$(wc -l < plain-ran)" -eq 8 ] || echo "ran: $(cat plain-ran)")"

echo "$(((checks - failures) * 100 / checks))%: Checks: $checks, Failures: $failures, Errors: 0"
[ $failures -eq 0 ]
