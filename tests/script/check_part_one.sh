# check_part_one.sh - is Part I whole at chapter 09, and plain?
# make test-09 may build modules of chapters 00 to 09 and no others; the modules
# stand in the order of the chapters; and they are as short as was promised.

failed=
fault() { echo "part one: $1"; failed=1; }

entries=$(sed -n '/^define ORDER/,/^endef/p' Makefile | grep /)
echo "$entries" | sort -c -s -t / -k 1,1 2> /dev/null ||
    fault "the modules in the Makefile's list are not in the order of their chapters"

built=$(MAKEFLAGS='' make -n test-09 BUILD=build/none MINE= 2> /dev/null |
    grep -o 'lib/[a-z]*/[a-z0-9_]*\.c' | sort -u)
[ -n "$built" ] || fault "make -n test-09 builds nothing"
for file in $built; do
    module=$(basename "$file" .c)
    echo "$entries" | grep -qx "0[0-9][a-z]*/$module" ||
        fault "make test-09 builds $file, which belongs to a later chapter"
done

awk -f tests/script/lines.awk Makefile lib/tumble.h lib/*/*.h lib/*/*.c > /tmp/lines.$$
limit() {   # MODULE COLUMN LIMIT WHAT
    is=$(awk -F, -v m="$1" -v c="$2" '$2 == m { print $c }' /tmp/lines.$$)
    [ -n "$is" ] && [ "$is" -le "$3" ] || fault "$1: $4 ${is:-missing}, more than $3"
}
# Of gjk's lines 230 are the plain search; the others are what it takes to be right
# where rounding hides the answer.
limit wide     3 120  lines
limit gjk      3 420  lines
limit hit_face 3 335  lines
limit system   3 640  lines
limit "Part I" 3 4700 lines
limit "Part I" 5 10   "median lines of a function"
limit "Part I" 6 30   "longest function"
[ -n "$failed" ] || awk -F, '$2 == "Part I" {
    print "part one: " $3 " lines, " $4 " functions of " $5 " lines in the middle and " $6 " at most" }' /tmp/lines.$$
rm -f /tmp/lines.$$
[ -z "$failed" ]
