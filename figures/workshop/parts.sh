# parts.sh - make's rules for what an exercise is judged by in a page:
#   sh figures/workshop/parts.sh FOLDER OURS NN/name...
# The objects that its tests and the library to the left of it are linked of, and
# what its script is made of.  OURS has the objects for WebAssembly.

folder=$1 ours=$2
shift 2
. exercises/judge.sh

# build/wasm/lib/gjk.o for build/lib/gjk.o; tests are compiled with this judge.
objects() {
    for part in $(library_parts); do
        case $part in */lib/*) echo "$ours/wasm/lib/${part##*/}" ;; esac
    done
    for part in $(test_parts); do
        case $part in
        */tests/*) echo "$folder/tests/${part##*/}" ;;
        *)         echo "$folder/exercises/${dir##*/}/check.o" ;;
        esac
    done
}

for name in "$@"; do
    load "$name" || exit 1
    id=${dir##*/}
    if [ "$module" ]; then answer=$ours/wasm/lib/$module.o; else answer=$folder/exercises/$id/solution.o; fi
    echo "$folder/$id.o: $(objects | tr '\n' ' ')"
    made_of="$folder/$id.o $tests $solution"
    for file in "$dir"/*; do case $file in */mine.*|*/README.md) ;; *) made_of="$made_of $file" ;; esac; done
    echo "$folder/$id.js: $made_of $answer"
    echo "ANSWER_$id := $answer"
    echo "SOURCE_$id := $solution $tests"
    # What a module that the reader writes moves in: the first figure of its chapter.
    figure=$(sed -n "s|^${name%%/*}/||p" figures/live/live.mk | head -n 1)
    [ -z "$module" ] || [ -z "$figure" ] || echo "FIGURE_$id := $figure $module"
done
