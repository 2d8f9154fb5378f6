# stamp.sh - is each figure as its program would make it?  made.txt in
# figures/tables keeps two checksums of each: of the program that made it, or its
# data, and of the data and the .gp from which its chart was drawn.
#   sh figures/draw/stamp.sh 10-distance...      these have just been made
#   sh figures/draw/stamp.sh -d 10-distance...   these are drawn from the data as
#                                                they were
#   sh figures/draw/stamp.sh                     which are older?
# README's moving picture is one of them.

made=figures/tables/made.txt
sum() { cat $(ls "$@" 2> /dev/null) < /dev/null | cksum; }
program() { sum figures/*/"$1".c figures/*/"$1".sh; }
drawing() { sum figures/*/"$1".gp figures/*/"$1".csv figures/*/"$1"-curves.csv; }

again=
[ "$1" != -d ] || { again=1; shift; }
for name in "$@"; do
    was=$(sed -n "s/^$name \([0-9]* [0-9]*\) .*/\1/p" $made)
    [ "$again" ] && [ "$was" ] || was=$(program "$name")
    { grep -v "^$name " $made; echo "$name $was $(drawing "$name")"; } | LC_ALL=C sort > $made.new &&
    mv $made.new $made || exit 1
done
[ $# = 0 ] || exit 0

failed=
complain() { echo "$1"; failed=1; }
# A .gp without a program is a drawing: it has no data.
for source in figures/[0-9]*/*.c figures/[0-9]*/*.gp figures/moving/moving.c figures/peers/piles.c; do
    name=$(basename "$source"); name=${name%.*}
    picture=${source%.*}.png command=figure-$name
    [ ! -e "${source%.*}.gp" ] || picture=${source%.*}.svg
    [ -e "${source%.*}.c" ] || command=chart-$name
    [ "$name" != moving ] || picture=figures/moving/moving.webp command=moving
    [ "$name" != piles ] || command=peers
    [ "${source%.gp}" = "$source" ] || [ ! -e "${source%.gp}.c" ] || continue
    [ -s "$picture" ] || complain "$picture is missing: run make $command"
    grep -q "^$name $(program "$name") " $made || complain "$picture is older than its program: run make $command"
    grep -q "^$name .* $(drawing "$name")$" $made || complain "$picture is older than its data or its .gp: run make chart-$name"
    grep -qF "$picture" chapters/*.md README.md || complain "$picture stands in no chapter"
done
for left in figures/[0-9]*/*.png figures/[0-9]*/*.csv; do
    [ -e "${left%.*}.c" ] || complain "$left has no program"
done
for chart in figures/[0-9]*/*.svg; do
    [ -e "${chart%.svg}.gp" ] || complain "$chart has no .gp"
    [ ! -e "${chart%.svg}.png" ] || complain "${chart%.svg}.png: it is a chart now, $chart"
done
[ -z "$failed" ]
