# fuzz.sh - feeds the fuzz targets any bytes, each for so many seconds, and ends
# with a line for each.  What was reached is kept in corpus/ for the next time;
# bytes that broke something as fuzz_*-crash-*.  Worlds are made from numbers:
# of these the next one is kept, and those that broke something are shown.
# Called by make fuzz, with the folder, the seconds and the targets.

folder=$1 seconds=$2 failed=
shift 2

worlds() { # folder, seconds: goes on where it stopped
    first=$(cat "$1/corpus/fuzz_world/next" 2>/dev/null || echo 1)
    "$1/tests/fuzz_world" "$first" 1000000000 "$2"
    ended=$?
    runs=$(awk '/^Done / { print $2 }' "$1/fuzz_world.log")
    echo $((first + ${runs:-0})) > "$1/corpus/fuzz_world/next"
    return $ended
}

for name in "$@"; do
    corpus=$folder/corpus/$name log=$folder/$name.log seeds= longest=512
    mkdir -p "$corpus"
    case $name in
    fuzz_obj)     seeds=tests/data longest=4096 ;;
    fuzz_options) seeds=tests/data/words longest=1024 ;;
    esac
    echo "  fuzz  $name, $seconds s"
    if [ "$name" = fuzz_world ]; then
        worlds "$folder" "$seconds" > "$log" 2>&1 || failed="$failed $name"
        continue
    fi
    "$folder/tests/$name" -max_total_time="$seconds" -max_len=$longest \
        -artifact_prefix="$folder/$name-" "$corpus" $seeds \
        > "$log" 2>&1 || failed="$failed $name"
done

echo
for name in "$@"; do
    awk -v name="$name" '
    /^Done / { done = sprintf("%9d runs, %6d a second", $2, $2 / ($5 > 0 ? $5 : 1)) }
    /runtime error:|ERROR: |^tests\/fuzz/ { if (!why) why = $0 }
    /Test unit written to/ { file = $NF }
    /^seed / { seed[++seeds] = $0; why = "some worlds" }
    END {
        printf "  %-14s %s\n", name, why ? "FAILED: " why : done
        if (file) print "                 its bytes: " file
        for (k = 1; k <= seeds; k++) print "                 " seed[k]
    }' "$folder/$name.log"
done
[ -z "$failed" ]
