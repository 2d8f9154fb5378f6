# exercise.sh - exercise.sh 01/step FOLDER: copies the reader's file of an exercise
# into FOLDER under the name of its module, and prints that name.  Faults are told
# with the lines of the reader's own file.

dir=exercises/$(echo "$1" | tr / -)
fail() { echo "make live $1: $2" >&2; exit 1; }
[ -f "$dir/exercise" ] || fail "$1" "there is no such exercise"
module=$(sed -n 's/^module //p' "$dir/exercise")
[ -n "$module" ] || fail "$1" "this exercise is no module of the library, and no figure calls it"
[ -f "$dir/mine.c" ] || fail "$1" "there is no $dir/mine.c yet; make exercise $1 begins it"
mkdir -p "$2"
{ echo "#line 1 \"$dir/mine.c\""; cat "$dir/mine.c"; } > "$2/$module.c" && echo "$2/$module.c"
