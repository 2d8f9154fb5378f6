# run.sh - the reader's commands, one exercise at a time.
#
#   sh exercises/run.sh exercise [NN]         which there are, in that chapter
#   sh exercises/run.sh exercise NN/name      begin it, or judge what is written
#   sh exercises/run.sh hint NN/name          the next of three hints
#   sh exercises/run.sh solution NN/name      asks, then shows it
#   sh exercises/run.sh reset NN/name         begin again; the old file is kept
#   sh exercises/run.sh chapter NN            how its exercises stand, what is next
#   sh exercises/run.sh progress [NN]         a bar for each chapter, or as above
#   sh exercises/run.sh counts MODULE         the reader's own module has passed its
#                                             tests: so have its exercises
#
# What is the reader's: in exercises/NN-name/ mine.c, mine.old.c and mine.hints (how
# many were shown), and exercises/progress.txt (follow.sh).

. exercises/judge.sh
. exercises/follow.sh

# list [NN]: those of a chapter, or all.
list() {
    states | grep "^$1" | while read -r each how; do
        case $how in passed*) mark=x ;; begun) mark=- ;; *) mark=' ' ;; esac
        printf '  [%s] %-14s %s\n' "$mark" "$each" "$(title_of "$each")"
    done
    echo "[x] passed, [-] begun.  Begin one:  make exercise 01/step"
}

begin() {
    stub "$solution" > "$mine.new" && mv "$mine.new" "$mine" || exit 1
    cat "$dir/README.md"
    echo
    echo "---"
    echo "Your file is $mine.  Write what is yours to write there, and then"
    echo "  make exercise $name    judges it"
    echo "  make hint $name        gives the next of three hints"
}

# A module that the reader has built moves in its chapter's live figures.
say_live() {
    module=$(sed -n 's/^module //p' "$dir/exercise")
    [ "$module" ] && [ "$module" != status ] && grep -q "^${name%%/*}/" figures/live/live.mk || return 0
    echo "See it move in a page:           make live $name"
}

exercise() {
    [ -f "$mine" ] || { begin; return 0; }
    alone "$out" || { echo "$name is being judged by another command: try again when that has ended." >&2; return 1; }
    trap 'leave_it "$out"' EXIT
    prepare "$(library_parts; test_parts)" || { echo "$name: the tests could not be built, see above" >&2; return 1; }
    compile "$mine" || { echo; echo "$name: $mine does not compile: begin with the first error above."; return 1; }
    judge_fairly "$mine"
    case $? in
    0)  write_passed "$name"
        show
        say_live
        echo "Compare with the book's answer:  make solution $name"
        next_of "${name%%/*}" "$(states)"
        return 0 ;;
    1)  echo; echo "  Change $mine, and run this again.  If you are stuck:  make hint $name" ;;
    2)  tail -n 20 "$out/said" ;;
    esac
    return 1
}

hint() {
    shown=$(cat "$dir/mine.hints" 2> /dev/null || echo 0)
    next=$((shown + 1))
    if [ $next -gt 3 ]; then
        echo "There are three hints; here they are again, and then there is only: make solution $name"
        cat "$dir/hints"
        return 0
    fi
    echo "Hint $next of 3:"
    awk -v want=$next '/^[0-9]+\. / { n = $1 + 0; sub(/^[0-9]+\. /, "   ") } n == want' "$dir/hints"
    echo $next > "$dir/mine.hints"
}

solution() {
    shown=$(cat "$dir/mine.hints" 2> /dev/null || echo 0)
    printf 'Show the solution of %s?  You have read %d of 3 hints.  [y/N] ' "$name" "$shown"
    read -r answer || echo
    case $answer in
    [yY]*) echo; awk -v show=1 -v empty="$empty" -v remove="$remove" -f exercises/cut.awk "$solution" ;;
    *) echo "Not shown." ;;
    esac
}

reset() {
    rm -f "$dir/mine.hints"
    forget_passed "$name"
    if [ -f "$mine" ] && ! stub "$solution" | cmp -s - "$mine"; then
        mv "$mine" "$dir/mine.old.c"
        echo "What you had is in $dir/mine.old.c."
    fi
    stub "$solution" > "$mine" || exit 1
    echo "$mine is as it was at the beginning."
}

# The exercises that ask for a part of this module.
counts() {
    theirs=
    for each in $(names); do
        grep -qx "module *$1" "$exercises/${each%%/*}-${each#*/}/exercise" || continue
        write_passed "$each"
        theirs="$theirs${theirs:+, }$each"
    done
    [ -z "$theirs" ] || echo "  It counts for its exercises: $theirs (make progress)."
}

command=$1
case $command in
counts) counts "$2"; exit ;;
exercise|hint|solution|reset) ;;
chapter) chapter "$2"; exit ;;
progress) if [ $# -gt 1 ]; then chapter "$2"; else bars; fi; exit ;;
*) echo "run.sh: exercise, hint, solution or reset?" >&2; exit 2 ;;
esac
[ $# -le 2 ] || { echo "One exercise at a time." >&2; exit 2; }
if [ $# -eq 1 ]; then
    list
    [ "$command" = exercise ] && exit
    echo "Of which exercise?  For example:  make $command 01/step" >&2
    exit 2
fi
case $2 in
[0-9][0-9]|[0-9][0-9][a-z])
    [ -n "$(chapter_file "$2")" ] || names | grep -q "^$2/" || no_chapter "$2" || exit
    names | grep -q "^$2/" || { echo "Chapter $2 has no exercises with tests."; exit 0; }
    list "$2/"
    [ "$command" = exercise ] && exit
    echo "Of which exercise?  For example:  make $command $(names | grep -m 1 "^$2/")" >&2
    exit 2 ;;
esac
load "$2"
case $? in
0)  ;;
2)  exit 2 ;;
*)  {
    if names | grep -q "^${2%%/*}/"; then list "${2%%/*}/"; fi
    if names | grep -qx "0$2"; then echo "There is no exercise $2; did you mean  make $command 0$2?"
    else echo "There is no exercise $2:  make exercise  lists them all."; fi
    } >&2
    exit 1 ;;
esac
[ "$command" = solution ] || [ -w "$dir" ] || {
    echo "$dir cannot be written, and your file stands there: work in a copy that is yours." >&2
    exit 2
}
$command
