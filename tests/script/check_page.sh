# check_page.sh - is the book as one page whole?  Every formula is read, every
# picture and the font are inside, every link within it lands, none leads out
# of it into the tree.  Where there is no pandoc there is nothing to look at.

command -v pandoc > /dev/null && command -v cwebp > /dev/null || {
    echo "no pandoc or no cwebp here: the page was not looked at"; exit 0; }
unset MAKEFLAGS MFLAGS      # a make that called us must not hand down its own

export LC_ALL=C
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
page=${BUILD:=build}/book.html
failed=

complain() { echo "book.html: $1"; failed=1; }

make html BUILD="$BUILD" > "$place/said" 2>&1 || { cat "$place/said"; exit 1; }
grep -i warning "$place/said" && complain "pandoc could not read all of it"

grep -o 'id="[^"]*"' "$page" | sed 's/^id="//; s/"$//' | sort -u > "$place/ids"
grep -o 'href="#[^"]*"' "$page" | sed 's/^href="#//; s/"$//' | sort -u > "$place/wanted"
for dead in $(comm -13 "$place/ids" "$place/wanted"); do
    complain "a link goes to #$dead, and nothing is called that"
done
for out in $(grep -o '<[^>]* \(href\|src\)="[^"]*"' "$page" |
             sed 's/.*="//; s/"$//' | grep -v -e '^#' -e '^https*:' -e '^data:' | cut -c1-60 | sort -u); do
    complain "$out is not in the page, and the page goes alone"
done

formulas=$(awk '/^```math/ { n++ } { n += gsub(/\$`/, "") } END { print n }' book.md)
drawn=$(grep -o '<math' "$page" | wc -l)
[ "$drawn" -ge "$formulas" ] || complain "$formulas formulas in book.md, $drawn in the page"
pictures=$(grep -c '^!\[' book.md)
shown=$(grep -o '<figure id="figure-' "$page" | wc -l)
[ "$shown" -ge "$pictures" ] || complain "$pictures pictures in book.md, $shown in the page"
grep -q 'font-face.*font/woff2\|font-face.*data:' "$page" || complain "the font of the formulas is not in it"

[ -z "$failed" ]
