# watch.sh - looks once a second whether a file was saved, and runs again what
# depends on it, until Ctrl-C ends it.
#
#   sh exercises/watch.sh 04         the tests of chapter 04 when the library, a
#                                    test or a file of MINE= was saved; all of
#                                    chapter 04 when a figure's program was; the
#                                    exercise whose mine.c was
#   sh exercises/watch.sh 10/when    that exercise alone
#
# AGAIN: the make to run.  MINE, CC, BUILD: as in the Makefile.

. exercises/judge.sh
. exercises/follow.sh
chapter=${1%%/*}

[ $# -le 1 ] || { echo "One chapter or exercise at a time." >&2; exit 2; }
case $1 in
'')  echo "Watch which chapter or exercise?  For example:  make watch 04, or  make watch 10/when" >&2; exit 2 ;;
*/*) places=$exercises/$chapter-${1#*/}
     [ -d "$places" ] || { echo "There is no exercise $1:  make exercise  lists them." >&2; exit 2; } ;;
*)   [ -n "$(chapter_file "$1")" ] || { no_chapter "$1"; exit 2; }
     places="lib tests figures $exercises $MINE" ;;
esac
{ mkdir -p "$build" && [ -w "$build" ]; } 2> /dev/null ||
    { echo "$build cannot be written, and what is watched is built there: is this folder yours?" >&2; exit 2; }

stamp=$(mktemp) || exit 1
trap 'rm -f "$stamp" "$stamp.next" "$stamp.goals"' EXIT
trap 'echo; exit 0' INT TERM

# What to make when this file was saved.
goals() {
    case $1 in
    */mine.c)       folder=${1%/mine.c} folder=${folder##*/}
                    echo "exercise ${folder%%-*}/${folder#*-}" ;;
    */mine.old.c)   ;;
    figures/[0-9]*) case $1 in "figures/$chapter/"*) echo "$chapter" ;; esac ;;
    figures/*)      echo "$chapter" ;;
    "$exercises"/*) ;;
    *)              echo "test-$chapter" ;;
    esac
}

# The files that were saved since the stamp; what an editor keeps beside them for
# itself is none.  A save while we look is seen now or the next time.
saved() {
    touch "$stamp.next"
    # shellcheck disable=SC2086
    find $places \( -name '[!.]*.[ch]' -o -name '[!.]*.gp' \) -newer "$stamp" 2> /dev/null
    mv "$stamp.next" "$stamp"
}

again() {
    echo
    echo "---- $(date +%H:%M:%S)  make $1"
    # shellcheck disable=SC2086
    case $1 in
    exercise*) MINE='' sh exercises/run.sh $1 ;;
    *)         $AGAIN $1 ;;
    esac
}

case $1 in
*/*) again "exercise $1"; [ -f "$places/mine.c" ] && touch "$stamp" ;;
*)   again "test-$1" ;;
esac
echo "Watching; Ctrl-C ends it."
while sleep 1; do
    for file in $(saved); do goals "$file"; done | sort -u > "$stamp.goals"
    while read -r goal; do again "$goal" < /dev/null; done < "$stamp.goals"
done
