# fuzz.sh - feeds the fuzz targets any bytes, each for so many seconds, and ends
# with a line for each.  What was reached is kept in corpus/ for the next time;
# bytes that broke something as fuzz_*-crash-*.
# Called by make fuzz, with the folder, the seconds and the targets.

folder=$1 seconds=$2 failed=
shift 2

for name in "$@"; do
    corpus=$folder/corpus/$name log=$folder/$name.log seeds= longest=512
    mkdir -p "$corpus"
    case $name in
    fuzz_obj)     seeds=tests/data longest=4096 ;;
    fuzz_options) seeds=tests/data/words longest=1024 ;;
    esac
    echo "  fuzz  $name, $seconds s"
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
    END {
        printf "  %-14s %s\n", name, why ? "FAILED: " why : done
        if (file) print "                 its bytes: " file
    }' "$folder/$name.log"
done
[ -z "$failed" ]
