# stamp.sh - which programs drew the figures?  A checksum of each figure's
# program and plot is kept in figures/made.txt.
#   sh figures/stamp.sh 04-distance...   these have just been drawn
#   sh figures/stamp.sh                  which are older than their program?

made=figures/made.txt
now() { cat figures/"$1".c $(ls figures/"$1".gp 2> /dev/null) | cksum; }

for name in "$@"; do
    { grep -v "^$name " $made; echo "$name $(now "$name")"; } | LC_ALL=C sort > $made.new &&
    mv $made.new $made || exit 1
done
[ $# = 0 ] || exit 0

failed=
for program in figures/[0-9]*.c; do
    name=$(basename "$program" .c)
    grep -qx "$name $(now "$name")" $made && [ -s "figures/$name.png" ] || {
        echo "figures/$name.png is older than its program: run make figure-$name"
        failed=1
    }
    grep -qF "figures/$name.png" chapters/*.md README.md || {
        echo "figures/$name.png stands in no chapter"
        failed=1
    }
done
for left in figures/[0-9]*.png figures/[0-9]*.csv figures/[0-9]*.gp; do
    [ -e "${left%.*}.c" ] || { echo "$left has no program"; failed=1; }
done
[ -z "$failed" ]
