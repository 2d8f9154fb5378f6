# stamp.sh - which programs drew the figures?  A checksum of each figure's
# program and plot is kept in figures/tables/made.txt.
#   sh figures/draw/stamp.sh 10-distance...   these have just been drawn
#   sh figures/draw/stamp.sh                  which are older than their program?
# README's moving picture is one of them.

made=figures/tables/made.txt
now() { cat $(ls figures/*/"$1".c figures/*/"$1".gp figures/*/"$1".sh 2> /dev/null) | cksum; }

for name in "$@"; do
    { grep -v "^$name " $made; echo "$name $(now "$name")"; } | LC_ALL=C sort > $made.new &&
    mv $made.new $made || exit 1
done
[ $# = 0 ] || exit 0

failed=
for program in figures/[0-9]*/*.c figures/moving/moving.c figures/peers/piles.c; do
    name=$(basename "$program" .c)
    picture=${program%.c}.png command=figure-$name
    [ "$name" != moving ] || picture=figures/moving/moving.webp command=moving
    [ "$name" != piles ] || command=peers
    grep -qx "$name $(now "$name")" $made && [ -s "$picture" ] || {
        echo "$picture is older than its program: run make $command"
        failed=1
    }
    grep -qF "$picture" chapters/*.md README.md || {
        echo "$picture stands in no chapter"
        failed=1
    }
done
for left in figures/[0-9]*/*.png figures/[0-9]*/*.csv figures/[0-9]*/*.gp; do
    [ -e "${left%.*}.c" ] || { echo "$left has no program"; failed=1; }
done
[ -z "$failed" ]
