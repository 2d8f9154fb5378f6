# check_start.sh - does the first program of chapter 00 do what the page says?
# Takes the program, the commands and the output from the page itself.

page=$(pwd)/chapters/00-start.md
unset MAKEFLAGS MFLAGS      # a make that called us must not hand down its own
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
build=${BUILD:-build} build=${build%/swapped}
mkdir -p "$tree/figures/live" "$tree/figures/workshop" "$tree/chapters/site" "$tree/build" &&
cp -Rp Makefile lib "$tree" && make -s library BUILD="$build" > "$tree/said" 2>&1 &&
cp -Rp "$build/lib" "$build/flags" "$tree/build" && cp figures/live/live.mk "$tree/figures/live" &&
cp figures/workshop/workshop.mk "$tree/figures/workshop" &&
cp chapters/site/site.mk "$tree/chapters/site" && cd "$tree" || exit 1

# block LANGUAGE: the first block in it under "Your first program".
block() {
    awk -v opens="\`\`\`$1" '/^## /{ here = /first program/ }
        /^```/ { if (inside) exit; if (here && $0 == opens) { inside = 1; next } }
        inside' "$page"
}
block c > build/first.c
block text > wanted
block sh > commands
[ -s build/first.c ] && [ -s wanted ] && [ -s commands ] ||
    { echo "check_start: chapter 00 has no first program"; exit 1; }

# The objects are those that are there anyway, but one; that the others, too, could
# be built here, say their lists of what they read: files of lib/, and no other.
rm build/lib/tumble_world.o
cat build/lib/*.d | tr -s ' :\\' '\n' | grep '\.[ch]$' | grep -v '^lib/' && { echo "check_start: lib/ reads that"; exit 1; }
env -u BUILD sh -e commands > said 2>&1 || { cat said; echo "check_start: the commands of chapter 00 fail"; exit 1; }
tail -n "$(wc -l < wanted)" said > got
cmp -s wanted got || { diff wanted got; echo "check_start: the output is not the page's"; exit 1; }

# A compiler that may round otherwise is refused, in a sentence.
for flag in -O1 -ffast-math; do
    printf '#include "vec3.h"\n' | ${CC:-cc} -std=c11 $flag -Ilib/base -fsyntax-only -x c - > "said$flag" 2>&1 ||
        echo "$flag" >> refused
done
[ "$(cat refused)" = -ffast-math ] && grep -q 'compile without' said-ffast-math ||
    { cat said-*; echo "check_start: vec3.h and -ffast-math"; exit 1; }
echo "chapter 00's first program: built, run, and as the page says"
