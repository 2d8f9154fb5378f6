# judge.sh - what run.sh and check.sh share: an exercise, its parts, its verdict.
# Run from the project's root.  CC, BUILD, CHECK_LIBS: as in the Makefile.

exercises=${EXERCISES:-exercises}
chapters=${CHAPTERS:-chapters}
build=${BUILD:-build}/exercises
cc=${CC:-cc}
check_libs=${CHECK_LIBS:--lcheck -lsubunit -lm -lrt -lpthread}
sanitize='-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer'
wall=15                      # times four seconds, for a test that only waits
# Of computing, for one test.  One that takes longer is timed with the book's own
# answer, on this machine and now, and may take twenty times as long.
seconds=${JUDGE_SECONDS:-2}
# Blocks of 512 bytes: 10 MB for each of these seconds.  A loop that prints is
# stopped by this long before its time is up.
linker=
printout=$(awk "BEGIN { print 20000 * $seconds }")
warnings='-Wall -Wextra -Wconversion -Wshadow -Wno-unused-parameter -Wno-unused-function -Wno-unused-const-variable'
exact=$(sed -n 's/^EXACT *:= *//p' Makefile)
line=$(sed -n '/^define ORDER/,/^endef/p' Makefile | grep / | tr '\n' ' ')
rooms=$(printf ' -I%s' lib lib/*/)

# The line of the chapter that tells of exercise NN/name, or of one of the chapters
# NNb and NNc behind it, a million lines on for each; nothing if none does.
told() {
    at=0
    for chapter in "$chapters/${1%%/*}"*-*.md; do
        [ -f "$chapter" ] && grep -n "make exercise $1\`" "$chapter" | sed 's/:.*//; q' |
            { read -r place && echo $((at + place)); } && return
        at=$((at + 1000000))
    done
}

# Every exercise, NN/name, in the order in which the chapters tell of them: from
# the easy to the hard.
names() {
    set --
    for file in "$chapters"/[0-9][0-9]*-*.md; do [ ! -f "$file" ] || set -- "$@" "$file"; done
    for file in "$exercises"/[0-9][0-9]*-*/exercise; do [ ! -f "$file" ] || echo "$file"; done |
        awk -f exercises/names.awk "$@" - | sort -k 1,1 -k 2,2n -k 3 | sed 's/.* //'
}

# load NN/name: reads the file `exercise`.  One of `module` (its module of lib/ is
# rebuilt, and judged by the module's tests) and `after` (a new thing, which may
# use the line up to that module); the functions that the reader writes; the
# tests that a reader should hear of first; and those that ask for nothing that
# the reader writes, and take long.
load() {
    name=$1
    dir=$exercises/${1%%/*}-${1#*/}
    out=$build/${1%%/*}-${1#*/}
    module='' after='' empty='' remove='' first='' leave=''
    [ -f "$dir/exercise" ] || return 1
    while read -r word rest; do
        case $word in
        module) module=$rest ;;
        after)  after=$rest ;;
        empty)  empty="$empty $rest" ;;
        remove) remove="$remove $rest" ;;
        first)  first="$first $rest" ;;
        leave)  leave="$leave $rest" ;;
        *) echo "$dir/exercise: what is $word?" >&2; return 1 ;;
        esac
    done < "$dir/exercise"
    case " $line " in
    *"/${module:-$after} "*) ;;
    *) echo "$dir/exercise: there is no module ${module:-$after}" >&2; return 1 ;;
    esac
    mine=$dir/mine.c
    if [ -n "$module" ]
    then solution=$(ls lib/*/"$module.c") tests=$(ls tests/*/"check_$module.c")
    else solution=$dir/solution.c tests=$dir/check.c
    fi
    objects= times=
    mkdir -p "$out" 2> /dev/null && [ -w "$out" ] || {
        echo "$out cannot be written, and exercises are built there: is this folder yours?" >&2
        return 2
    }
}

# alone FOLDER: is no other command at work in it?  Whose it is says a link that
# leads to the number of its process, until leave_it.
alone() {
    ln -s $$ "$1/busy" 2> /dev/null && return
    other=$(readlink "$1/busy")
    [ "$other" != $$ ] && kill -0 "${other:-none}" 2> /dev/null && return 1
    ln -sfn $$ "$1/busy"
}
leave_it() { rm -f "$1/busy"; }

# stub SOURCE: the source with the reader's functions emptied.
stub() { awk -v empty="$empty" -v remove="$remove" -v derived="${after:+1}" -f exercises/cut.awk "$1"; }

# What the reader's object is linked with: the line to the left of it, as it is
# built anyway, and the tests with what they include, which have the sanitizers;
# but not the oracle, which is slow, and sees nothing that the reader gives.
library_parts() {
    for entry in $line; do
        part=${entry#*/}
        [ "$part" = "$module" ] && break
        ls lib/*/"$part.c" > /dev/null 2>&1 && echo "${BUILD:-build}/lib/$part.o"
        [ "$part" = "$after" ] && break
    done
    echo "$build/exercises/judge.o"
}
test_parts() {
    case $tests in
    tests/*) echo "$build/tests/$(basename "$tests" .c).o" ;;
    *)       echo "$build/${tests%.c}.o" ;;
    esac
    for header in $(sed -n 's/^#include "\(.*\)\.h"/\1/p' "$tests"); do
        for at in tests/*/"$header.h"; do
            case $header in oracle) sound=${BUILD:-build} ;; *) sound=$build ;; esac
            [ ! -f "${at%.h}.c" ] || echo "$sound/tests/$header.o"
        done
    done
}

# prepare PARTS: builds those, with the Makefile's own rules, if they are not up to
# date: the library as it is for all, the tests with the sanitizers and the judge.
# One command at a time does.
prepare() {
    cores=$(nproc 2> /dev/null || echo 2)
    plain=$(echo "$1" | grep -v "^$build/")
    until alone "$build"; do sleep 0.2; done
    # shellcheck disable=SC2086
    { [ -z "$plain" ] || MAKEFLAGS='' make -s -j$cores CC="$cc" BUILD="${BUILD:-build}" $plain > /dev/null; } &&
    MAKEFLAGS='' make -s -j$cores CC="$cc" BUILD="$build" CFLAGS="-Og -g1 $sanitize" \
        CPPFLAGS='-D_XOPEN_SOURCE=700 -include exercises/judge.h' \
        $(echo "$1" | grep "^$build/") > /dev/null
    prepared=$?
    leave_it "$build"
    return $prepared
}

# compile FILE: to $out/mine.o.  Not optimised: the optimiser would take away a
# write that nobody reads before the sanitizers see where it goes.
# shellcheck disable=SC2086
compile() { $cc $exact -O0 -g1 $sanitize $warnings $rooms -I"$dir" -c "$1" -o "$out/mine.o"; }

# show: what the reader has built, moving: runs the exercise's show.c, if it has
# one, with what was compiled last.
show() {
    [ -f "$dir/show.c" ] || return 0
    # shellcheck disable=SC2046,SC2086
    $cc $exact -O1 -g $sanitize $warnings -D_XOPEN_SOURCE=700 $rooms -Iexercises "$dir/show.c" \
        "$out/mine.o" $(library_parts | grep -v /judge.o) -lm -o "$out/show" && "$out/show"
}

# Linking is much of a judge's time: gold, where the compiler has it, takes a quarter.
find_linker() {
    linker=' '
    echo 'int main(void) { return 0; }' > "$out/linker.c"
    # shellcheck disable=SC2086
    $cc $sanitize -fuse-ld=gold "$out/linker.c" -o "$out/linker" 2> /dev/null && "$out/linker" && linker=-fuse-ld=gold
    rm -f "$out/linker.c" "$out/linker"
}

# run_judge FILE [TEST]: what was compiled of FILE, against all tests or against
# one.  What was said is in $out/said, the outcomes in $out/tap.
run_judge() {
    if [ -z "$objects" ]; then
        objects="$(test_parts) $(library_parts)"
        # Some tests refuse memory to what they test (tests/support/scarce.c).
        for object in $(test_parts); do
            part=$(basename "$object" .o)
            ls tests/*/"$part.c" > /dev/null 2>&1 && grep -q __wrap_malloc tests/*/"$part.c" &&
                objects="$objects -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=aligned_alloc,--wrap=free"
        done
    fi
    [ -n "$linker" ] || find_linker
    # shellcheck disable=SC2086
    $cc $sanitize $linker "$out/mine.o" $objects $check_libs -o "$out/judge" || return 2
    rm -f "$out/tap" "$out/stop"
    : > "$out/said"
    (
        ulimit -f $printout
        YOURS=$1 ONLY=$2 LEAVE=$leave JUDGE_STOP=$out/stop \
        JUDGE_SECONDS=$seconds JUDGE_TIMES=$times \
        CK_FORK=yes CK_TIMEOUT_MULTIPLIER=$wall CK_TAP_LOG_FILE_NAME=$out/tap \
        ASAN_OPTIONS=print_legend=0:$ASAN_OPTIONS \
        "$out/judge" > "$out/summary" 2> "$out/said" < /dev/null
    ) 2> /dev/null
    true
}

# judge FILE [TEST]: runs it.  Returns what tell.awk does, and says what it says.
judge() {
    run_judge "$@" || return 2
    tell "$1"
}
tell() {
    awk -v name="$name" -v mine="${1##*/}" -v seconds="$seconds" -v times="$times" -v early="$first" \
        -f exercises/tell.awk "$tests" "$out/said" "$out/tap"
}

# judge_fairly FILE: as judge; but if a test was stopped, the book's own answer is
# timed, and the file has three times what is allowed: what ends by then is too
# slow, and what does not is said not to end.
judge_fairly() {
    times= wall=15
    run_judge "$1" || return 2
    if [ -e "$out/stop" ]; then
        compile "$solution" 2> /dev/null && wall=150 && (seconds=600; run_judge "$solution") || return 2
        awk -v least="$seconds" '$1 == "judge:" && $2 == "end" && $4 > most[$3] + 0 { most[$3] = $4 }
            $1 == "judge:" && $2 == "end" { seen[$3] }
            END { for (test in seen) {
                allowed = 20 * most[test] > least ? 20 * most[test] : least
                print test, 3 * allowed, most[test] + 0 } }' "$out/said" > "$out/times"
        times=$out/times
        compile "$1" 2> /dev/null && run_judge "$1" || return 2
    fi
    tell "$1"
}
