# numerals.sh - is each numeral with a unit, or ratio, that was typed by hand into
# the book or README one that was looked at?  Sentences with such numerals
# (numerals.awk) are listed by a checksum, so that a new one, or one that changes,
# must be looked at again: in given.txt, what is given, defined, wanted or follows
# by arithmetic; in quoted.txt, what was measured and stands in no table of
# figures/, with machine, commit, date and a command or source.  Measured numbers
# that a table has are {{references}} (numbers.awk).
#   sh chapters/numerals.sh              names the sentences that are in neither
#   sh chapters/numerals.sh given 13     they are given, all of chapter 13: lists them
#   sh chapters/numerals.sh quoted 13    the same as quoted; then fill in the columns

export LC_ALL=C
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
given=chapters/given.txt quoted=chapters/quoted.txt

awk -f chapters/numerals.awk chapters/[0-9]*.md README.md > "$work/there"
{ grep -v '^#' $given; sed '/^#/d; s/ |.*//' $quoted; } > "$work/listed"
awk 'FILENAME ~ /listed$/ { listed[$1 " " $2] = 1; next } !(($1 " " $2) in listed)' "$work/listed" "$work/there" > "$work/new"

case $1 in
given)
    awk -v page="$2" '$1 == page { sentence = $1 " " $2; sub(/ [|] .*/, ""); sub(/^[^ ]* [^ ]* [^ ]* /, ""); print sentence, $0 }' "$work/new" > "$work/more"
    { grep '^#' $given; { grep -v '^#' $given; cat "$work/more"; } | sort -u; } > "$work/given" && cp "$work/given" $given
    exit ;;
quoted)
    awk -v page="$2" '$1 == page { line = $1 " " $2; text = $0; sub(/^[^|]*\| /, "", text); sub(/^[^ ]* [^ ]* [^ ]* /, ""); sub(/ \| .*/, ""); print line " | " $0 " |  |  |  | ?  " text }' "$work/new" >> $quoted
    exit ;;
esac

failed=
awk '{ text = $0; sub(/^[^|]*\| /, "", text); at = $3; page = $1
       sub(/^[^ ]* [^ ]* [^ ]* /, ""); sub(/ \| .*/, "")
       printf "%s:%d: typed by hand: %s, in: %s\n", page, at, $0, text; bad = 1 } END { exit bad }' "$work/new" || failed=1
# A list holds what is in the book, and a quotation says all of whence it is.
awk 'FILENAME ~ /there$/ { there[$1 " " $2] = 1; next } !(($1 " " $2) in there) { print "chapters/given.txt or quoted.txt lists what is not in the book: " $0; bad = 1 } END { exit bad }' "$work/there" "$work/listed" || failed=1
awk -F ' [|] ' '!/^#/ { for (i = 2; i <= 6; i++) if ($i ~ /^ *([?].*)?$/) { print "chapters/quoted.txt:" FNR ": no " (i == 2 ? "number" : i == 3 ? "machine" : i == 4 ? "commit" : i == 5 ? "date" : "source") ": " $1; bad = 1 } } END { exit bad }' $quoted || failed=1
[ -z "$failed" ] || echo "A measured number becomes a {{reference}}; for others see chapters/numerals.sh."
[ -z "$failed" ]
