# run.sh - runs the test programs and scripts that are named, every one, and
# ends with one line that says what failed.  RUN: a command to run them under.
# UNBUILT: set if some of them could not be built.  YOURS: the reader's modules
# that they judge; then their answers are told in sentences.

# A test that never ends is stopped after a minute, also on a busy machine; one
# that judges a reader's module after Check's own four seconds.
[ -n "$YOURS" ] || export CK_DEFAULT_TIMEOUT="${CK_DEFAULT_TIMEOUT:-60}"

failed= programs=0 checks=0 faults=
[ $# -gt 0 ] || { echo "FAILED: there is no test to run" >&2; exit 1; }
output=$(mktemp)
trap 'rm -f "$output"' EXIT

for test in "$@"; do
    programs=$((programs + 1))
    name=$(basename "$test" .sh)
    case $test in
    *.sh) sh "$test" > "$output" 2>&1 ;;
    *)    $RUN "$test" > "$output" 2>&1 ;;
    esac
    code=$?
    case $YOURS,$test in
    ,*|*.sh) cat "$output" ;;
    *)       awk -v name="$name" -v yours="$YOURS" -f tests/script/tell.awk "$output" ;;
    esac
    # A Check program closes with its count; without that line it never ended.
    count=$(sed -n 's/^[0-9]*%: Checks: \([0-9]*\),.*/\1/p' "$output" | tail -n 1)
    case $test in *.sh) ;; *) [ -n "$count" ] || code=1 ;; esac
    if [ "$code" -ne 0 ]; then
        failed="$failed $name"
        [ -n "$YOURS" ] || faults="$faults$(printf '\n%s:\n' "$name"; tail -n 12 "$output")"
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
echo "All passed: $programs programs, $checks checks of the library"
