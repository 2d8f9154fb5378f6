# run.sh - runs the test programs and scripts that are named, every one, JOBS at
# once or as many as there are cores, tells them in their order, and ends with
# one line that says what failed.  RUN: a command to run them under.
# UNBUILT: set if some of them could not be built.  YOURS: the reader's modules
# that they judge; then their answers are told in sentences, and a module that
# passes counts for its exercises.

# A test that never ends is stopped after a minute, also on a busy machine; one
# that judges a reader's module after Check's own four seconds.
[ -n "$YOURS" ] || export CK_DEFAULT_TIMEOUT="${CK_DEFAULT_TIMEOUT:-60}"

# run.sh --one FOLDER NUMBER TEST: that one; what it says and how it ended go to
# files of that number.
if [ "$1" = --one ]; then
    case $4 in
    *.sh) sh "$4" > "$2/$3.said" 2>&1 ;;
    *)    $RUN "$4" > "$2/$3.said" 2>&1 ;;
    esac
    echo $? > "$2/$3.code.part"
    mv "$2/$3.code.part" "$2/$3.code"
    exit 0
fi

failed= programs=0 checks=0 faults= library=
[ $# -gt 0 ] || { echo "FAILED: there is no test to run" >&2; exit 1; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
jobs=${JOBS:-$(nproc 2> /dev/null || echo 2)}

# The longest begin first: what is short then fills the other cores at the end.
long="check_exercises check_little check_page check_command check_install check_cmake check_swap \
      check_hard_rows check_start check_program check_tumble_save"
n=0
for test in "$@"; do
    n=$((n + 1)) first=0
    name=$(basename "$test" .sh)
    for each in $long; do
        [ "$each" != "$name" ] || break
        first=$((first + 1))
    done
    echo "$first $n $test"
done | sort -s -k 1,1n | while read -r first n test; do
    printf '%s\n' "$n" "$test"
done | xargs -n 2 -P "$jobs" sh "$0" --one "$folder" &
runner=$!

for test in "$@"; do
    programs=$((programs + 1))
    name=$(basename "$test" .sh)
    output=$folder/$programs.said
    until [ -e "$folder/$programs.code" ] || ! kill -0 $runner 2> /dev/null; do sleep 0.1; done
    code=$(cat "$folder/$programs.code" 2> /dev/null || echo 1)
    case $YOURS,$test in
    ,*|*.sh) cat "$output" ;;
    *)       source=$(ls tests/*/"$name.c" 2> /dev/null)
             awk -v name="$name" -v yours="$YOURS" -f tests/script/tell.awk $source "$output" ;;
    esac
    # A Check program closes with its count; without that line it never ended.
    count=$(sed -n 's/^[0-9]*%: Checks: \([0-9]*\),.*/\1/p' "$output" | tail -n 1)
    case $test in *.sh) ;; *) [ -n "$count" ] || code=1 ;; esac
    if [ "$code" -ne 0 ]; then
        failed="$failed $name"
        [ -n "$YOURS" ] || faults="$faults$(printf '\n%s:\n' "$name"; tail -n 12 "$output")"
    else
        for module in $YOURS; do
            module=$(basename "$module" .c)
            [ "$name" != "check_$module" ] || sh exercises/run.sh counts "$module"
        done
    fi
    checks=$((checks + ${count:-0}))
done

echo
if [ -n "$failed" ] || [ -n "$UNBUILT" ]; then
    [ -z "$UNBUILT" ] || echo "FAILED: some tests could not be built, see above"
    [ -z "$faults" ] || printf 'What these ended with:%s\n\n' "$faults"
    [ -z "$failed" ] || echo "FAILED:$failed"
    exit 1
fi
[ "$checks" -eq 0 ] || library=", $checks checks of the library"
echo "All passed: $programs programs$library"
