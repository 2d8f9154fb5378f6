# check_book.sh - are book.md and the pages of chapters/woven what make book would
# write, whichever awk writes them, and does it show each line of lib/ and of the judges once?
# (chapters/check-book.awk)  Does every test and function exist that it names?
# Is every figure in it, and as its program would draw it today?
# Does chapter 23 list all sources (chapters/sources.awk)?
# Are its words, the exercises' and README's spelt as a dictionary has them?

export LC_ALL=C
fresh=$(mktemp -d)
trap 'rm -rf "$fresh"' EXIT
failed=

code=$(sh chapters/weave.sh)
for awk in $(sh tests/script/awks.sh); do
    sh chapters/weave.sh "$fresh" $awk || { failed=1; break; }
    cmp -s "$fresh/book.md" book.md && diff -rq "$fresh/woven" chapters/woven || {
        echo "book.md, or a page of chapters/woven, is not what $awk weaves now: run make book"
        failed=1
    }
    $awk -f chapters/check-book.awk $code book.md || failed=1
done

# Names of three words and more, `like_this_one`; two words may be formulas.
grep -oh '`[a-z0-9]*_[a-z0-9]*_[a-z0-9_]*`' chapters/*.md README.md | tr -d '`' | sort -u > "$fresh/names"
grep -rohwF -f "$fresh/names" lib tests/*/*.[ch] figures/*/*.[ch] chapters/little/*.c exercises/*/check.c | sort -u |
    comm -23 "$fresh/names" - > "$fresh/nowhere"
[ ! -s "$fresh/nowhere" ] || { sed 's/.*/the book names &, and nothing in the tree is called that/' "$fresh/nowhere"; failed=1; }
# A table goes on from row to row: what a blank line cuts off is no table.
awk '!/^\|/ { rows = 0 } /^\|/ && ++rows == 2 && !/^\|[-:| ]*$/ { print FILENAME ": a table without a head, at line " FNR; bad = 1 }
     END { exit bad }' chapters/[0-9]*.md README.md || failed=1
# A heading opens its line, and something is below it.
awk 'FNR == 1 { open = fence = 0 } /^```/ { fence = !fence }
     !fence && /^[^#`].* ##+ / { print FILENAME ":" FNR ": a heading inside a line"; bad = 1 }
     !fence && /^##+ / { depth = index($0, " ") - 1; if (open && depth <= open) { print FILENAME ":" FNR ": nothing is below the heading before this one"; bad = 1 } open = depth; next }
     NF { open = 0 } END { exit bad }' chapters/[0-9]*.md || failed=1
sh figures/draw/stamp.sh > "$fresh/older" || {
    echo "$(wc -l < "$fresh/older") figures or tables are not as their programs would make them now; make stale lists them, make figures renews most:"
    head -n 3 "$fresh/older"; failed=1
}
awk -f chapters/sources.awk chapters/23-words.md chapters/[0-9]*.md || failed=1

# The speller itself is shown a mistake first.
echo "Wether \`wich\` is sayd in code or not." > "$fresh/wrong"
said=$(sh chapters/spell.sh "$fresh/wrong")
case $said in
*"not checked"*) ;;
*:1:*Wether*:1:*sayd*) ;;
*) echo "the speller overlooks mistakes: $said"; failed=1 ;;
esac
sh chapters/spell.sh README.md chapters/[0-9]*.md chapters/site/*.md exercises/README.md figures/README.md figures/command/README.md lib/README.md \
    exercises/*/README.md exercises/*/hints || failed=1
[ -z "$failed" ]
