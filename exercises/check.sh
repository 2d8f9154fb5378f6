# check.sh - is every exercise sound?  sh exercises/check.sh [NN/name ...]
#
# The stub compiles, without a warning, and fails; the solution passes; every
# wrong variant compiles and is rejected by the test that it names; there are
# three hints, a task, and no stray file.  Prints one line for each exercise, and
# one sentence for each fault.  WRONGS=2: of the wrong variants only so many, from
# the first to the last (all are read).  What was sound, and has not changed since, nor
# anything that it was made of, is not tried again.

. exercises/judge.sh
patience=60     # for what is our own
faults=0

fault() { echo "$name: $1"; faults=$((faults + 1)); }

first_error() { sed -n '/error/ { p; q; }' "$out/errors"; }

check_files() {
    for file in "$dir"/* "$dir"/.[!.]*; do
        case ${file##*/} in
        README.md|exercise|hints|wrong|show.c|mine.*|"*"|".[!.]*") ;;
        solution.c|check.c|*.h) [ -n "$after" ] || fault "$file is a stray file: the module is in lib/" ;;
        *) fault "$file is a stray file" ;;
        esac
        ! ls lib/*/"${file##*/}" 2> /dev/null | grep -q '[.][ch]$' || fault "$file has the name of a file of lib/"
    done
    for test in $first; do
        grep -q "^START_TEST($test)" "$tests" || fault "first names the test $test, which is not in $tests"
    done
    for test in $leave; do
        grep -q "^START_TEST($test)" "$tests" || fault "leave names the test $test, which is not in $tests"
        ! grep -q "^test  *$test\$" "$dir/wrong" || fault "leave names the test $test, which is to reject a wrong variant"
    done
    for chapter in "$chapters/${name%%/*}"-*.md; do
        [ ! -f "$chapter" ] || [ -n "$(told "$name")" ] ||
            fault "$chapter does not tell of it:  make exercise $name"
    done
    head -n 1 "$dir/README.md" 2> /dev/null | grep -q "^# $name: ." ||
        fault "README.md does not begin with '# $name: title'"
    [ "$(wc -w < "$dir/README.md")" -ge 40 ] || fault "README.md does not tell the task"
    awk '/^[0-9]+\. / { if ($1 + 0 != ++n) bad = 1 } n && NF { words[n] += NF }
         END { for (i = 1; i <= 3; i++) if (words[i] < 5) bad = 1
               exit bad || n != 3 }' "$dir/hints" 2> /dev/null ||
        fault "hints are not three, numbered 1. 2. 3., of some words each"
}

# The wrong variants, one after another: number, test, sentence.
check_list() {
    stub "$solution" > "$out/stub.c" 2> "$out/errors" || { fault "the stub cannot be made: $(cat "$out/errors")"; return; }
    awk -f exercises/wrong.awk "$dir/wrong" > "$out/list" 2> "$out/errors" || fault "$(cat "$out/errors")"
    [ "$wrongs" -ge 3 ] || fault "there are $wrongs wrong variants, and three are the least"
    while read -r number test told; do
        wrong=$out/wrong-$number.c
        if ! grep -q "^START_TEST($test)" "$tests"; then
            fault "wrong $number ($told) names the test $test, which is not in $tests"
        elif ! awk -v want="$number" -f exercises/wrong.awk "$dir/wrong" "$solution" > "$wrong" 2> "$out/errors"; then
            fault "$(cat "$out/errors")"
        elif ! stub "$wrong" 2>&1 | cmp -s - "$out/stub.c"; then
            fault "wrong $number ($told) changes what is not the reader's to write"
        fi
    done < "$out/list"
}

# One test that it fails is enough; that of the first wrong variant comes first.
check_stub() {
    seconds=2
    read -r number test told < "$out/list"
    compile "$out/stub.c" 2> "$out/errors" || { fault "the stub does not compile: $(first_error)"; return; }
    [ ! -s "$out/errors" ] || fault "the stub compiles with a warning: $(sed -n '/warning/ { p; q; }' "$out/errors")"
    judge "$out/stub.c" "$test" > "$out/told"
    verdict=$?
    [ $verdict -eq 1 ] || { judge "$out/stub.c" > "$out/told"; verdict=$?; }
    case $verdict in
    0) fault "the stub passes" ;;
    2) fault "the stub: no test has run" ;;
    esac
}

# The solution has the time that a reader has; a loop without end is one after a
# second or two.
check_solution() {
    seconds=$patience
    compile "$solution" 2> "$out/errors" || { fault "the solution does not compile: $(first_error)"; return; }
    judge "$solution" > "$out/told" || { fault "the solution does not pass"; sed 's/^/  /' "$out/told"; }
    show > "$out/shown" 2>&1 < /dev/null || { fault "show.c fails"; sed 's/^/  /' "$out/shown"; }
}

# Without the sanitizers: most mistakes need none, and they are most of the time.
# shellcheck disable=SC2086
compile_fast() { $cc $exact -O0 -w $rooms -I"$dir" -c "$1" -o "$out/mine.o"; }

check_wrong() {
    seconds=2
    awk -v most="${WRONGS:-0}" '{ line[NR] = $0 }
        END { if (!most || most > NR) most = NR
              apart = most == 1 ? 0 : (NR - 1) / (most - 1)
              for (k = 0; k < most; k++) print line[1 + int(k * apart)] }' "$out/list" > "$out/tried"
    tried=$(wc -l < "$out/tried")
    while read -r number test told; do
        wrong=$out/wrong-$number.c
        compile_fast "$wrong" 2> "$out/errors" || { fault "wrong $number ($told) does not compile: $(first_error)"; continue; }
        judge "$wrong" "$test" > "$out/told"
        verdict=$?
        if [ $verdict -eq 0 ]; then
            compile "$wrong" 2> "$out/errors" && judge "$wrong" "$test" > "$out/told"
            verdict=$?
        fi
        case $verdict in
        0) fault "wrong $number ($told) is not rejected by $test" ;;
        2) fault "wrong $number ($told): $test has not run" ;;
        esac
    done < "$out/tried"
}

# One number for all that an exercise is made of.
key() {
    {
        echo "$cc $exact $WRONGS"
        cat "$dir"/[!m]* exercises/*.* lib/*/*.h "$tests" tests/*/[!c]*.[ch] "$solution"
        for object in $(library_parts); do object=${object##*/}; cat lib/*/"${object%.o}.c"; done
    } 2> /dev/null | cksum
}

# First what can be seen in the files; if that is sound, what must be tried.
check() {
    before=$faults
    wrongs=$(grep -c '^wrong' "$dir/wrong")
    check_files
    check_list
    [ $faults -eq $before ] || return
    if [ "$(key)" = "$(cat "$out/sound" 2> /dev/null)" ]; then
        echo "$name: sound, $(cat "$out/tried-of"), as before"
        return
    fi
    check_stub
    check_solution
    [ $faults -eq $before ] || return
    check_wrong
    [ $faults -eq $before ] || return
    key > "$out/sound"
    [ "$tried" = "$wrongs" ] || wrongs="$tried of $wrongs"
    echo "$wrongs wrong variants rejected" > "$out/tried-of"
    echo "$name: sound, $(cat "$out/tried-of")"
}

# All that they share is built before, at once; a test that does not build shows
# as a solution that does not pass.
prepare_all() {
    for name in "$@"; do load "$name" 2> /dev/null && library_parts && test_parts; done |
        sort -u > "$build/parts"
    prepare "$(cat "$build/parts")"
}

# Every second exercise, from the one given on.
half() {
    i=0
    for name in $2; do
        i=$((i + 1))
        [ $((i % 2)) -eq "$1" ] || continue
        if load "$name"; then check; else fault "there is no such exercise"; fi
    done
    [ $faults -eq 0 ]
}

mkdir -p "$build"
[ $# -gt 0 ] || set -- $(names)
[ $# -gt 0 ] || { echo "there is no exercise to check"; exit 1; }
prepare_all "$@"
said=$build/half.$$     # of this run alone: there may be another beside it
half 0 "$*" > "$said" 2>&1 &
half 1 "$*"
one=$?
wait $!
two=$?
cat "$said"
rm -f "$said"
[ $one -eq 0 ] && [ $two -eq 0 ]
