# weave.sh - weaves the book into a folder:  sh chapters/weave.sh FOLDER [AWK]
# writes FOLDER/book.md, and a page a chapter into FOLDER/woven, and beside them a
# reference of tumble.h (reference.awk).  With no folder it
# prints which files are the book's code; each of their lines is in it once.

code="lib/tumble.h lib/*/*.h lib/*/*.c tests/support/oracle.[hc] tests/support/poses.[hc] tests/support/experiments.[hc]
      chapters/little/*.c tests/contact/plain_*.[hc] tests/soft/plain_*.[hc]
      figures/manual/*.c figures/manual/*.py"
[ "$1" ] || { echo $code; exit; }

export LC_ALL=C
rm -rf "$1/woven" && mkdir -p "$1/woven" &&
${2:-awk} -v pages="$1/woven" -v order="$(sed -n '/^define ORDER/,/^endef/s/^[0-9].*\///p' Makefile | tr '\n' ' ')" -f chapters/numbers.awk -f chapters/pieces.awk -f chapters/weave.awk $code chapters/[0-9]*.md > "$1/book.md" &&
${2:-awk} -f chapters/reference.awk lib/tumble.h figures/manual/*.c figures/scenes/*.c > "$1/woven/tumble-reference.md"
